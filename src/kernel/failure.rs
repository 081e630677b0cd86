//! Why an argument comes to no theorem: it is wrong, it asks for too much, or the checker itself is.

use crate::exact::{Limit, Stop};

/// Why there is no theorem; `R` says in how many ways an argument of some kind can be wrong.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Failure<R> {
    /// The argument does not prove its claim.
    Rejected(R),
    /// A limit was reached. That says nothing of the claim.
    Limited {
        /// Where.
        place: Place,
        /// Which.
        limit: Limit,
    },
    /// A check found what an earlier check has excluded: a fault of this program. That says nothing of the claim either.
    Defect(&'static str),
}

/// Where in an argument a limit was reached.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// While the equations of the statement were derived.
    Equations,
    /// While the values of the unknowns were tried.
    Values,
    /// In this step, from 1.
    Step(usize),
    /// At this node, from 1, of the tree with this name.
    Node(&'static str, usize),
}

impl<R> From<R> for Failure<R> {
    fn from(rejection: R) -> Self {
        Failure::Rejected(rejection)
    }
}

impl<R> Failure<R> {
    /// The same failure, its rejection as one of another kind.
    pub fn map<S>(self, of: impl FnOnce(R) -> S) -> Failure<S> {
        match self {
            Failure::Rejected(rejection) => Failure::Rejected(of(rejection)),
            Failure::Limited { place, limit } => Failure::Limited { place, limit },
            Failure::Defect(what) => Failure::Defect(what),
        }
    }
}

/// Says where arithmetic was stopped.
pub(crate) trait At<T> {
    /// The result, or a failure at this place.
    fn at<R>(self, place: Place) -> Result<T, Failure<R>>;
}

impl<T, E: Into<Stop>> At<T> for Result<T, E> {
    fn at<R>(self, place: Place) -> Result<T, Failure<R>> {
        self.map_err(|stop| match stop.into() {
            Stop::Limit(limit) => Failure::Limited { place, limit },
            Stop::Defect(what) => Failure::Defect(what),
        })
    }
}
