//! `prove-cap export --to LANGUAGE NAME|FILE`: the proof in another language, for another program to verify.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use super::arguments::{Format, to_json};
use super::check::read_limited;
use super::control::{Limits, stopped, under_control};
use super::files::write_atomically;
use super::outcome::{Failure, Outcome, Status};
use super::source::Source;
use crate::certificate::Certificate;
use crate::checker::{CheckError, check_read_within};
use crate::control::Control;
use crate::elimination::Undecided;
use crate::exact::limits;
use crate::export::{Case, ExportError, Target, export, pac_files};
use crate::prove::{Attempt, Reason, prove};

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

fn carried_out(options: &ExportOptions, format: Format, control: &Control) -> Result<Outcome, Failure> {
    let source = Source::find_within(&options.source, control)?;
    let found = match &options.certificate {
        Some(file) => read(&source, file, options.unchecked, (format, control))?,
        None => search(&source, (format, control))?,
    };
    let certificate = match found {
        Ok(certificate) => certificate,
        Err(outcome) => return Ok(outcome),
    };
    let unfit = |error: ExportError| match control.unless_stopped(error) {
        ExportError::Interrupted(why) => stopped(&source.name, format, &why),
        error => Err(Failure(format!("{}: {error}", source.name))),
    };
    let case = match Case::within(&source.statement, &certificate, control) {
        Ok(case) => case,
        Err(error) => return unfit(error),
    };
    if let (Some(prefix), Language::Pac) = (&options.output, options.to) {
        return pac_files(&case).map_or_else(unfit, |files| write_pac(&source.name, prefix, &files, format));
    }
    let text = match export(&case, options.to.target()) {
        Ok(text) => text,
        Err(error) => return unfit(error),
    };
    let Some(target) = &options.output else {
        return Ok(Outcome::plain(match format {
            Format::Json => to_json(&serde_json::json!({ "name": source.name, "text": text }))?,
            _ => text,
        }));
    };
    write_atomically(target, text.as_bytes())?;
    let bytes = text.len();
    Ok(Outcome::plain(match format {
        Format::Json => to_json(&serde_json::json!({
            "verdict": "WRITTEN", "name": source.name, "file": target, "bytes": bytes,
        }))?,
        _ => format!("WRITTEN  {}: {bytes} bytes; the verdict is the other program's\n", target.display()),
    }))
}

/// The three files of pacheck, beside each other.
fn write_pac(
    name: &str,
    prefix: &Path,
    files: &[(&str, String); 3],
    format: Format,
) -> Result<Outcome, Failure> {
    let mut written = Vec::with_capacity(files.len());
    for (ending, text) in files {
        let mut target = prefix.as_os_str().to_owned();
        target.push(format!(".{ending}"));
        write_atomically(Path::new(&target), text.as_bytes())?;
        written.push((PathBuf::from(target), text.len()));
    }
    Ok(Outcome::plain(match format {
        Format::Json => {
            let (files, bytes): (Vec<_>, Vec<_>) = written.into_iter().unzip();
            to_json(
                &serde_json::json!({ "verdict": "WRITTEN", "name": name, "files": files, "bytes": bytes }),
            )?
        }
        _ => {
            let lines =
                written.iter().map(|(file, bytes)| format!("WRITTEN  {}: {bytes} bytes\n", file.display()));
            lines.collect::<String>() + "The verdict is the other program's\n"
        }
    }))
}

/// The certificate in a file, or what our checker has against it.
fn read(
    source: &Source,
    file: &Path,
    unchecked: bool,
    (format, control): (Format, &Control),
) -> Result<Result<Certificate, Outcome>, Failure> {
    let statement = &source.statement;
    let bytes = read_limited(file, limits::CERTIFICATE_BYTES.at_most)?;
    let unknowns = statement.unknowns().len();
    let certificate = Certificate::read(&bytes, &statement.ring(), unknowns, &mut control.work())
        .map_err(|error| Failure(format!("{}:{error}", file.display())))?;
    if unchecked {
        return Ok(Ok(certificate));
    }
    match check_read_within(statement, &certificate, &mut control.work()) {
        Ok(_) => Ok(Ok(certificate)),
        Err(CheckError::Rejected(rejection)) => {
            let text = match format {
                Format::Json => to_json(&serde_json::json!({
                    "verdict": "REJECTED", "name": source.name, "reason": rejection.to_string(),
                }))?,
                _ => format!(
                    "REJECTED  {}: {rejection}\nNothing is exported; --unchecked does it all the same.\n",
                    file.display()
                ),
            };
            Ok(Err(Outcome { text, status: Status::Wrong }))
        }
        Err(error) => Err(Failure(format!("{}: {error}", file.display()))),
    }
}

/// The certificate that is found for the statement, or that none was.
fn search(
    source: &Source,
    (format, control): (Format, &Control),
) -> Result<Result<Certificate, Outcome>, Failure> {
    let reason = match prove(&source.statement, control).map_err(Failure::of)? {
        Attempt::Proved { certificate, .. } => return Ok(Ok(certificate)),
        Attempt::Undecided(Reason::Elimination(Undecided::Interrupted(why))) => {
            return stopped(&source.name, format, &why).map(Err);
        }
        Attempt::Undecided(_) => {
            "no proof was found to be exported; `prove-cap prove` says what was found instead"
        }
    };
    let text = match format {
        Format::Json => {
            to_json(&serde_json::json!({ "verdict": "UNDECIDED", "name": source.name, "reason": reason }))?
        }
        _ => format!("UNDECIDED  {}: {reason}\n", source.name),
    };
    Ok(Err(Outcome { text, status: Status::Undecided }))
}
