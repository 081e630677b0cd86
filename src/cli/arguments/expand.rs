//! What `expand` takes.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::expand::Basis;

#[derive(Debug, Args)]
pub(in crate::cli) struct ExpandOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    pub(in crate::cli) source: PathBuf,
    /// The basis of the polynomials in u and v.
    #[arg(long, value_enum, default_value_t = BasisName::Bernstein)]
    pub(in crate::cli) basis: BasisName,
}

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(in crate::cli) enum BasisName {
    /// `c[r,s]`, coefficients of uʳ(1−u)^(M−r)·vˢ(1−v)^(N−s).
    Bernstein,
    /// `a[i,j]`, coefficients of uⁱvʲ; the paper's a1, …, a16 where they apply.
    Monomial,
}

impl From<BasisName> for Basis {
    fn from(name: BasisName) -> Self {
        match name {
            BasisName::Bernstein => Basis::Bernstein,
            BasisName::Monomial => Basis::Monomial,
        }
    }
}
