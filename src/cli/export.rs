//! `prove-cap export --to LANGUAGE NAME|FILE`: the proof in another language, for another program to verify.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::control::{Limits, under_control};
use super::files::{read_limited, write_atomically};
use super::outcome::{Ended, Format, Outcome};
use super::source::find;
use crate::commands::{self, Division, Failure, Which};
use crate::control::Control;
use crate::exact::limits;
use crate::export::Target;
use crate::report::pages::{ExportShown, ExportWritten};

#[derive(Debug, Args)]
pub(super) struct ExportOptions {
    /// A built-in statement (see `list`) or a statement file.
    #[arg(value_name = "NAME|FILE")]
    source: PathBuf,
    /// The language.
    #[arg(long, value_enum, value_name = "LANGUAGE")]
    to: Language,
    /// Export this certificate, not one that is found now.
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Export the certificate even if our own checker rejects it: to see that the other program does so too.
    #[arg(long, requires = "certificate")]
    unchecked: bool,
    /// Where the text is written [default: standard output]; for pac, three files FILE.polys, FILE.proof, FILE.target.
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    #[command(flatten)]
    limits: Limits,
}

/// The languages as they are named on the command line.
#[derive(Debug, Clone, Copy, ValueEnum)]
enum Language {
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
    fn target(self) -> Target {
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

pub(super) fn run(options: &ExportOptions, format: Format) -> Result<Outcome, Failure> {
    let name = options.source.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &ExportOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let source = find(&options.source, control)?;
    let certificate = options.certificate.as_deref();
    let bytes = certificate.map(|file| read_limited(file, limits::CERTIFICATE_BYTES)).transpose()?;
    let which = match (certificate, &bytes) {
        (Some(file), Some(bytes)) => Which::Given { file, bytes, unchecked: options.unchecked },
        _ => Which::Found,
    };
    let division = if options.output.is_some() { Division::Files } else { Division::Whole };
    let exported = commands::export(&source, which, (options.to.target(), division), control)?;
    let Some(target) = &options.output else {
        return Ok(Outcome::of(&ExportShown(&exported), format)?);
    };
    let mut files = Vec::with_capacity(exported.parts.len());
    for (ending, text) in &exported.parts {
        let mut file = target.as_os_str().to_owned();
        if let Some(ending) = ending {
            file.push(format!(".{ending}"));
        }
        write_atomically(Path::new(&file), text.as_bytes())?;
        files.push((PathBuf::from(file), text.len()));
    }
    Ok(Outcome::of(&ExportWritten { name: exported.name, files }, format)?)
}
