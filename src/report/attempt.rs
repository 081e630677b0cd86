//! The outcome of an attempt, as a proof that can be followed line by line.

use std::fmt::Write as _;
use std::path::PathBuf;

use super::headline::{headline as proved, surface_equation};
use super::refutation::refutation;
use super::solution::solution;
use super::stopped::cut_short;
use super::undecided::{headline, reason_text};
use crate::checker::Claim;
use crate::control::Control;
use crate::exact::Limit;
use crate::expand::ExpansionError;
use crate::problem::Problem;
use crate::prove::Attempt;

/// Characters of a formula on one line.
pub(super) const LINE: usize = 110;

/// Where statement and certificate were written.
#[derive(Debug, Clone)]
pub struct Files {
    /// The statement file.
    pub statement: PathBuf,
    /// The certificate file.
    pub certificate: PathBuf,
}

/// `prove-cap prove` for people. `source` is what the statement was called on the command line; `cap` tells that the patch
/// is bounded by the arcs over the cube face.
///
/// # Errors
/// Where a coefficient exceeds what the formats allow.
pub(super) fn describe(
    (name, source): (&str, &str),
    problem: &Problem,
    cap: bool,
    attempt: &Attempt,
    files: Option<&Files>,
    control: &Control,
) -> Result<String, Limit> {
    let statement = problem.statement();
    let mut text = String::new();
    match attempt {
        Attempt::Undecided(reason) => {
            let _ = writeln!(text, "UNDECIDED  {name}: {}\n", headline(reason));
            let surface = surface_equation(statement);
            let surface = if surface.is_empty() { surface } else { format!("Surface: {surface}\n") };
            let _ = writeln!(text, "{}\n{surface}", statement.title());
            text += &reason_text(statement, reason)?;
        }
        Attempt::Proved { proof, freedom } => {
            let theorem = proof.theorem();
            let _ = writeln!(text, "{}\n", proved(name, source, theorem));
            let _ = writeln!(text, "{}\n", statement.title());
            let explained = match theorem.claim() {
                Claim::Impossible(_) => refutation(problem, cap, proof.certificate(), control),
                _ => Ok(solution(statement, theorem, freedom)),
            };
            text += &match explained {
                Ok(explained) => explained,
                // The verdict stands by itself.
                Err(ExpansionError::Interrupted(why)) => format!("{}\n\n", cut_short(&why)),
                Err(ExpansionError::Limit(limit)) => return Err(limit),
            };
        }
    }
    if let (Attempt::Proved { proof, .. }, Some(files)) = (attempt, files) {
        let _ = writeln!(
            text,
            "Verdict of the independent checker, on the files below\n{}\n",
            wrapped(&format!("VERIFIED. {}", proof.theorem().sentence()))
        );
        let _ = writeln!(text, "Statement    {}", files.statement.display());
        let _ = writeln!(text, "Certificate  {}", files.certificate.display());
    }
    Ok(text)
}

/// A paragraph, broken at spaces and indented.
fn wrapped(paragraph: &str) -> String {
    wrapped_at(paragraph, 3)
}

/// A paragraph, broken at spaces and indented by so many blanks.
pub(super) fn wrapped_at(paragraph: &str, indent: usize) -> String {
    let mut lines: Vec<String> = vec![String::new()];
    for word in paragraph.split(' ') {
        let line = lines.last_mut().expect("never empty");
        if !line.is_empty() && indent + line.chars().count() + word.chars().count() >= LINE + 3 {
            lines.push(word.to_owned());
        } else {
            line.push_str(if line.is_empty() { "" } else { " " });
            line.push_str(word);
        }
    }
    let margin = " ".repeat(indent);
    format!("{margin}{}", lines.join(&format!("\n{margin}")))
}
