//! The program. What it does is in `prove_cap::cli`.

use std::process::ExitCode;

use prove_cap::cli;

fn main() -> ExitCode {
    cli::outcome::finish(cli::run())
}
