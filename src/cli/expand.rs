//! `prove-cap expand NAME|FILE`: the coefficients of the surface condition.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::outcome::{Format, Outcome};
use super::source::find;
use crate::commands::{self, Failure};
use crate::control::Control;
use crate::expand::Basis;

#[derive(Debug, Args)]
pub(super) struct ExpandOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    source: PathBuf,
    /// The basis of the polynomials in u and v.
    #[arg(long, value_enum, default_value_t = BasisName::Bernstein)]
    basis: BasisName,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
enum BasisName {
    /// `c[r,s]`, coefficients of uʳ(1−u)^(M−r)·vˢ(1−v)^(N−s).
    Bernstein,
    /// `a[i,j]`, coefficients of uⁱvʲ; the paper's a1, …, a16 where they apply.
    Monomial,
}

pub(super) fn run(options: &ExpandOptions, format: Format) -> Result<Outcome, Failure> {
    let basis = match options.basis {
        BasisName::Bernstein => Basis::Bernstein,
        BasisName::Monomial => Basis::Monomial,
    };
    let source = find(&options.source, &Control::default())?;
    Outcome::of(&commands::expand(source, basis)?, format)
}
