//! The checker alone: two commands, exactly spelled, no options.

use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;

use prove_cap_kernel::command;
use prove_cap_kernel::outcome::{Failure, Outcome, finish};

const USAGE: &str = "prove-cap-check, the checker of prove-cap

prove-cap-check check STATEMENT CERTIFICATE   replay a certificate against a statement
prove-cap-check canonical STATEMENT           print the canonical text whose SHA-256 certificates name

exit status: 0 VERIFIED, 1 REJECTED, 2 ERROR
";

fn main() -> ExitCode {
    finish(run())
}

/// Carries out the command line.
fn run() -> Result<Outcome, Failure> {
    let arguments: Vec<OsString> = std::env::args_os().skip(1).collect();
    let words: Vec<Option<&str>> = arguments.iter().map(|argument| argument.to_str()).collect();
    match (words.as_slice(), arguments.as_slice()) {
        ([Some("check"), _, _], [_, statement, certificate]) => {
            command::check(Path::new(statement), Path::new(certificate))
        }
        ([Some("canonical"), _], [_, statement]) => command::canonical(Path::new(statement)),
        ([Some("--help" | "-h")], _) => Ok(Outcome::plain(USAGE.to_owned())),
        ([Some("--version" | "-V")], _) => {
            Ok(Outcome::plain(concat!("prove-cap-check ", env!("CARGO_PKG_VERSION"), "\n").to_owned()))
        }
        _ => Err(Failure(format!("expected one of the commands below\n\n{USAGE}"))),
    }
}
