//! `table`: how good patches of the cap are, degree by degree, and how six of them fit together.

use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

use super::{Failure, Source, Verdict, values};
use crate::approximation::{
    ApproximationError, BestSoFar, Enclosure, EnclosureError, FloatPatch, Objective, Seams, Search,
    approximate, enclose, error_of,
};
use crate::certificate::decimal_value;
use crate::control::{Control, Interrupted};
use crate::statement::{Statement, Subject};

/// Decimals of the bounds: enough for four digits of the smallest error.
const PLACES: u32 = 16;

/// A row to be computed.
#[derive(Debug)]
pub struct Row {
    /// The built-in statement.
    pub name: &'static str,
    /// The family it stands for.
    pub about: &'static str,
    /// Where the values of the unknowns come from.
    pub values: Values,
}

/// Where the values of the unknowns come from.
#[derive(Debug)]
pub enum Values {
    /// The best that a search finds.
    Best,
    /// Stated, by name.
    Given(&'static [(&'static str, &'static str)]),
}

/// The rows: polynomial and rational, from standard edges to exact ones.
pub const ROWS: &[Row] = &[
    Row { name: "cap-2x2-polynomial", about: "all weights 1, D4", values: Values::Best },
    Row {
        name: "cap-2x2",
        about: "standard edges, D4; G1 (Eq. 13)",
        values: Values::Given(&[("w", "1/2"), ("z", "4*sqrt(3)/3")]),
    },
    Row { name: "cap-2x2", about: STANDARD, values: Values::Best },
    Row { name: "cap-2x2-free", about: "free edges, D4", values: Values::Best },
    Row { name: "cap-3x3-d4", about: STANDARD, values: Values::Best },
    Row { name: "cap-4x4-d4", about: STANDARD, values: Values::Best },
    Row { name: "cap-4x2-exact", about: "other edges, D2", values: Values::Given(&[]) },
    Row { name: "cobb", about: "other edges, D4 (Cobb 1988)", values: Values::Given(&[]) },
];

/// The family of which digits are compared from degree to degree.
const STANDARD: &str = "standard edges, D4";

/// The rows as far as they came.
#[derive(Debug)]
pub struct Table {
    /// Those that are finished.
    pub lines: Vec<Line>,
    /// The one that was being computed when the work was stopped.
    pub unfinished: Option<Unfinished>,
}

/// A row as it came out.
#[derive(Debug)]
pub struct Line {
    /// What it was asked to be.
    pub row: &'static Row,
    /// The degrees in u and v.
    pub bidegree: (u32, u32),
    /// How many unknowns the statement has.
    pub unknowns: usize,
    /// The bounds.
    pub enclosure: Enclosure,
    /// How six of them fit together, measured in floating point.
    pub seams: Seams,
    /// Decimal digits gained over the best patch with standard edges of the degree before.
    pub digits: Option<f64>,
}

/// A row that was being computed when the work was stopped.
#[derive(Debug)]
pub struct Unfinished {
    /// The row.
    pub row: &'static Row,
    /// Its statement.
    pub statement: Statement,
    /// What stopped it.
    pub why: Interrupted,
    /// The best values so far.
    pub best: Option<Box<BestSoFar>>,
}

impl Table {
    /// Without a verdict, unless it is not finished.
    pub fn verdict(&self) -> Verdict {
        if self.unfinished.is_some() { Verdict::Undecided } else { Verdict::Shown }
    }
}

impl Line {
    /// The largest |r − 1|, as the bounds have it.
    pub fn error(&self) -> BigRational {
        decimal_value(&error_of(&self.enclosure).abs(), self.enclosure.bounds.places)
    }

    /// Whether both bounds are attained and 1: the patch lies on the sphere.
    pub fn exact(&self) -> bool {
        self.enclosure.bounds.lower.bound == self.enclosure.bounds.upper.bound
    }

    /// Where the values of the unknowns come from, in words.
    pub fn origin(&self) -> &'static str {
        match self.row.values {
            Values::Best => "best found",
            Values::Given([]) => "none",
            Values::Given(_) => "given",
        }
    }

    /// The error in floating point, to be compared.
    fn size(&self) -> f64 {
        self.error().to_f64().unwrap_or(f64::NAN)
    }
}

/// Computes the rows, as far as they come before the work is stopped.
///
/// # Errors
/// Where a row has no bounds: a fault of this program.
pub fn table(control: &Control) -> Result<Table, Failure> {
    let mut lines: Vec<Line> = Vec::new();
    for row in ROWS {
        match line(row, control)? {
            Ok(mut line) => {
                let standard = |line: &Line| line.row.about == STANDARD;
                let before = lines.iter().rev().find(|other| standard(other));
                line.digits = before
                    .filter(|_| standard(&line) && !line.exact())
                    .map(|before| (before.size() / line.size()).log10());
                lines.push(line);
            }
            Err(unfinished) => return Ok(Table { lines, unfinished: Some(unfinished) }),
        }
    }
    Ok(Table { lines, unfinished: None })
}

/// One row, or where it was interrupted.
fn line(row: &'static Row, control: &Control) -> Result<Result<Line, Unfinished>, Failure> {
    let statement = Source::named(row.name)?.statement;
    let of = |error: &dyn std::fmt::Display| Failure::about(row.name, error);
    let enclosed = match row.values {
        Values::Given(given) => {
            let values = values(&statement, given).map_err(|error| of(&error))?;
            match enclose(&statement, &values, PLACES, control) {
                Ok(enclosure) => Ok(enclosure),
                Err(EnclosureError::Interrupted(why)) => Err((why, None)),
                Err(error) => return Err(of(&error)),
            }
        }
        Values::Best => {
            let search = Search {
                objective: Objective::Minimax,
                points: 101,
                pass: Vec::new(),
                places: Some(PLACES),
                seed: 1,
            };
            match approximate(&statement, &search, control) {
                Ok(found) => Ok(found.enclosure),
                Err(ApproximationError::Interrupted(why, best)) => Err((why, best)),
                Err(error) => return Err(of(&error)),
            }
        }
    };
    let enclosure = match enclosed {
        Ok(enclosure) => enclosure,
        Err((why, best)) => return Ok(Err(Unfinished { row, statement, why, best })),
    };
    let patch = FloatPatch::at(&statement, &enclosure.bounds.values).map_err(|error| of(&error))?;
    let bidegree = match statement.subject() {
        Subject::Patch(patch) => patch.bidegree,
        Subject::System(_) => (0, 0),
    };
    let (unknowns, seams) = (statement.unknowns().len(), patch.seams());
    Ok(Ok(Line { row, bidegree, unknowns, enclosure, seams, digits: None }))
}
