//! The command line of the build without the prover: two commands, exactly spelled, no options.

use std::ffi::OsString;
use std::path::Path;

use super::check;
use super::outcome::{Failure, Outcome};

const USAGE: &str = "prove-cap (checker only)

prove-cap check STATEMENT CERTIFICATE   replay a certificate against a statement
prove-cap canonical STATEMENT           print the canonical text whose SHA-256 certificates name

exit status: 0 VERIFIED, 1 REJECTED, 2 ERROR
";

/// Carries out the command line.
pub fn run() -> Result<Outcome, Failure> {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let words: Vec<Option<&str>> = arguments.iter().map(|argument| argument.to_str()).collect();
    match (words.as_slice(), arguments.as_slice()) {
        ([Some("check"), _, _], [_, statement, certificate]) => {
            check::run(Path::new(statement), Path::new(certificate))
        }
        ([Some("canonical"), _], [_, statement]) => check::canonical(Path::new(statement)),
        ([Some("--help" | "-h")], _) => Ok(Outcome::plain(USAGE.to_owned())),
        ([Some("--version" | "-V")], _) => Ok(Outcome::plain(
            concat!("prove-cap ", env!("CARGO_PKG_VERSION"), " (checker only)\n").to_owned(),
        )),
        _ => Err(Failure(format!("expected one of the commands below\n\n{USAGE}"))),
    }
}
