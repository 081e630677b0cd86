//! Prove a built-in statement and print its certificate.
//!
//! `cargo run --example prove_a_statement`

use prove_cap::catalogue;
use prove_cap::control::Control;
use prove_cap::prove::{Attempt, prove};
use prove_cap::statement::Statement;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let entry = catalogue::find("cap-2x2-weights").ok_or("not in the catalogue")?;
    let statement = Statement::read(&entry.statement())?;
    match prove(&statement, &Control::default())? {
        Attempt::Proved { proof, .. } => {
            println!("{}\n", proof.theorem());
            print!("{}", proof.text());
        }
        Attempt::Undecided(reason) => println!("undecided: {reason:?}"),
    }
    Ok(())
}
