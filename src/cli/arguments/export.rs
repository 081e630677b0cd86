//! What `export` takes.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use super::limits::Limits;
use crate::formats::export::Target;

#[derive(Debug, Args)]
pub(in crate::cli) struct ExportOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    pub(in crate::cli) source: PathBuf,
    /// The language.
    #[arg(long, value_enum, value_name = "LANGUAGE")]
    pub(in crate::cli) to: Language,
    /// Export this certificate, not one that is found now.
    #[arg(long, value_name = "FILE")]
    pub(in crate::cli) certificate: Option<PathBuf>,
    /// Export the certificate even if our own checker rejects it: to see that the other program does so too.
    #[arg(long, requires = "certificate")]
    pub(in crate::cli) unchecked: bool,
    /// Where the text is written [default: standard output]; for pac, three files FILE.polys, FILE.proof, FILE.target.
    #[arg(short, long, value_name = "FILE")]
    pub(in crate::cli) output: Option<PathBuf>,
    #[command(flatten)]
    pub(in crate::cli) limits: Limits,
}

/// The languages as they are named on the command line.
#[derive(Debug, Clone, Copy, ValueEnum)]
pub(in crate::cli) enum Language {
    /// Coq (Rocq): the geometric theorem, standard library only. Run: coqc FILE.v
    Coq,
    /// Run: Singular -q FILE </dev/null
    Singular,
    /// Run: M2 --script FILE
    Macaulay2,
    /// PARI/GP. Run: gp -q FILE </dev/null
    Pari,
    /// Run: python3 FILE
    Sympy,
    /// Run: maxima --very-quiet --init-mac=FILE </dev/null
    Maxima,
    /// Lean 4 with Mathlib; not compiled by us.
    Lean,
    /// The practical algebraic calculus. Run: pacheck -e FILE.polys FILE.proof FILE.target; a yes is TARGET CHECKED.
    Pac,
}

impl Language {
    pub(in crate::cli) fn target(self) -> Target {
        match self {
            Language::Coq => Target::Coq,
            Language::Singular => Target::Singular,
            Language::Macaulay2 => Target::Macaulay2,
            Language::Pari => Target::Pari,
            Language::Sympy => Target::Sympy,
            Language::Maxima => Target::Maxima,
            Language::Lean => Target::Lean,
            Language::Pac => Target::Pac,
        }
    }
}
