//! Expand the surface condition of a patch of one's own, in both bases.
//!
//! `cargo run --example expand_a_patch`

use prove_cap::expand::{Basis, coefficients};
use prove_cap::report::Notation;
use prove_cap::statement::Statement;

const QUARTER_CYLINDER: &str = r#"
title = "A quarter of a cylinder with one weight open"
radicands = [2]
unknowns = ["w"]
convention = "cartesian"
bidegree = [2, 1]
surface = "X^2 + Y^2 - W^2"
net = [
  [["1", "0", "0", "1"], ["1", "0", "1", "1"]],
  [["1", "1", "0", "w"], ["1", "1", "1", "w"]],
  [["0", "1", "0", "1"], ["0", "1", "1", "1"]],
]
"#;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let statement = Statement::read(QUARTER_CYLINDER)?;
    let notation = Notation::new(statement.ring());
    for basis in [Basis::Bernstein, Basis::Monomial] {
        for coefficient in coefficients(&statement, basis)?.unwrap_or_default() {
            if !coefficient.value.is_zero() {
                println!("{} = {}", coefficient.name, notation.polynomial(&coefficient.value));
            }
        }
    }
    Ok(())
}
