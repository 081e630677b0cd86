//! The ways in which there is no answer, one for each exit status but 0.

use super::{Failure, Verdict};
use crate::approximation::BestSoFar;
use crate::checker::Rejection;
use crate::construction::Cell;
use crate::control::Interrupted;
use crate::geometry::Polygon;
use crate::statement::Statement;

/// Why a command has no result.
#[derive(Debug)]
pub enum NoAnswer {
    /// 1: the certificate is wrong.
    Rejected(Rejected),
    /// 2: the command could not be carried out.
    Failed(Failure),
    /// 3: the search has not come to an end, or to none that says anything.
    Undecided(Box<Undecided>),
    /// 4: there is nothing to construct.
    Nonexistent(Box<Nonexistent>),
}

impl NoAnswer {
    /// What it comes to.
    pub fn verdict(&self) -> Verdict {
        match self {
            NoAnswer::Rejected(_) => Verdict::Rejected,
            NoAnswer::Failed(_) => Verdict::Failed,
            NoAnswer::Undecided(_) => Verdict::Undecided,
            NoAnswer::Nonexistent(_) => Verdict::Nonexistent,
        }
    }
}

impl From<Failure> for NoAnswer {
    fn from(failure: Failure) -> Self {
        NoAnswer::Failed(failure)
    }
}

impl From<Undecided> for NoAnswer {
    fn from(undecided: Undecided) -> Self {
        NoAnswer::Undecided(Box::new(undecided))
    }
}

/// A certificate that the checker refuses.
#[derive(Debug)]
pub struct Rejected {
    /// What it is to prove.
    pub name: String,
    /// The file it is in.
    pub file: String,
    /// What is wrong with it.
    pub rejection: Rejection,
}

/// Why nothing was decided, and what is known all the same.
#[derive(Debug)]
pub struct Undecided {
    /// What it is about.
    pub name: String,
    /// Why.
    pub reason: String,
    /// Whether the sentence begins with the name; otherwise the reason says enough.
    pub named: bool,
    /// What stopped the work, if it was stopped.
    pub stopped: Option<Interrupted>,
    /// The patch whose surface is told.
    pub patch: Option<Statement>,
    /// The bidegree, where one was asked for.
    pub bidegree: Option<(u32, u32)>,
    /// The best values of the unknowns so far; nothing is proved of them.
    pub best: Option<(Statement, Box<BestSoFar>)>,
}

impl Undecided {
    /// The search ended for this reason.
    pub fn new(name: impl Into<String>, reason: impl Into<String>) -> Self {
        Undecided {
            name: name.into(),
            reason: reason.into(),
            named: true,
            stopped: None,
            patch: None,
            bidegree: None,
            best: None,
        }
    }

    /// The work was stopped.
    pub fn stopped(name: impl Into<String>, why: Interrupted) -> Self {
        Undecided { stopped: Some(why.clone()), ..Undecided::new(name, why.to_string()) }
    }
}

/// No patch of this bidegree covers the polygon exactly.
#[derive(Debug)]
pub struct Nonexistent {
    /// The name of the polygon.
    pub name: String,
    /// The polygon.
    pub polygon: Polygon,
    /// The bidegree.
    pub bidegree: (u32, u32),
    /// By which lemma.
    pub cell: Cell,
}
