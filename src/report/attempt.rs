//! The outcome of an attempt, as a proof that can be followed line by line.

use std::path::PathBuf;

use super::headline::{headline as proved, surface_equation};
use super::refutation::refutation;
use super::solution::solution;
use super::stopped::cut_short;
use super::undecided::{headline, reason_document};
use crate::checker::Claim;
use crate::commands::Verdict;
use crate::control::Control;
use crate::document::{Block, Document};
use crate::exact::Limit;
use crate::expand::ExpansionError;
use crate::problem::Problem;
use crate::prove::Attempt;

/// Where statement and certificate were written.
#[derive(Debug, Clone)]
pub struct Files {
    /// The statement file.
    pub statement: PathBuf,
    /// The certificate file.
    pub certificate: PathBuf,
}

impl Files {
    /// Both, to be printed.
    pub(super) fn block(&self) -> Block {
        Block::Files { statement: Some(self.statement.clone()), certificates: vec![self.certificate.clone()] }
    }
}

/// What the checker says, before the files in which it has seen it.
pub(super) fn verdict_of_checker(document: &mut Document, sentence: &str) {
    document.heading("Verdict of the independent checker, on the files below");
    document.paragraph(3, format!("{}. {sentence}", Verdict::Verified));
    document.gap();
}

/// `prove-cap prove` for people. `source` is what the statement was called on the command line; `cap` tells that the patch
/// is bounded by the arcs over the cube face.
///
/// # Errors
/// Where a coefficient exceeds what the formats allow.
pub(super) fn describe(
    verdict: Verdict,
    (name, source): (&str, &str),
    problem: &Problem,
    cap: bool,
    attempt: &Attempt,
    files: Option<&Files>,
    control: &Control,
) -> Result<Document, Limit> {
    let statement = problem.statement();
    let mut document = Document::new(statement.ring());
    match attempt {
        Attempt::Undecided(reason) => {
            document.headline(verdict.word(), format!("{name}: {}", headline(reason)));
            document.gap();
            document.line(0, statement.title());
            let surface = surface_equation(statement);
            if !surface.is_empty() {
                document.line(0, format!("Surface: {surface}"));
            }
            document.gap();
            document.append(reason_document(statement, reason)?);
        }
        Attempt::Proved { proof, freedom } => {
            let theorem = proof.theorem();
            document.headline(verdict.word(), format!("{name}: {}", proved(source, theorem)));
            document.gap();
            document.line(0, statement.title());
            document.gap();
            let explained = match theorem.claim() {
                Claim::Impossible(_) => refutation(problem, cap, proof.certificate(), control),
                _ => Ok(solution(statement, theorem, freedom)),
            };
            match explained {
                Ok(explained) => document.append(explained),
                // The verdict stands by itself.
                Err(ExpansionError::Interrupted(why)) => {
                    document.line(0, cut_short(&why));
                    document.gap();
                }
                Err(ExpansionError::Limit(limit)) => return Err(limit),
            }
        }
    }
    if let (Attempt::Proved { proof, .. }, Some(files)) = (attempt, files) {
        verdict_of_checker(&mut document, &proof.theorem().sentence());
        document.push(files.block());
    }
    Ok(document)
}
