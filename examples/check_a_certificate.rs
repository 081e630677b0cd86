//! Check a committed certificate with the trusted part alone.

use prove_cap_kernel::checker::{CheckError, check};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args().nth(1).unwrap_or("proofs/cap-2x2".into());
    let statement = std::fs::read(format!("{folder}/statement.toml"))?;
    let certificate = std::fs::read(format!("{folder}/certificate.txt"))?;
    match check(&statement, &certificate) {
        Ok(theorem) => println!("VERIFIED: {theorem}"),
        Err(CheckError::Rejected(rejection)) => println!("REJECTED: {rejection}"),
        Err(unreadable) => return Err(unreadable.into()),
    }
    Ok(())
}
