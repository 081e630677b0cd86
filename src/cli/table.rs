//! `prove-cap table`: how good patches of the cap are, degree by degree, and how six of them fit together.

use clap::Args;

use super::arguments::{Format, to_json};
use super::control::{Limits, under_control};
use super::outcome::{Failure, Outcome, Status};
use super::source::Source;
use super::values::values;
use crate::approximation::{
    ApproximationError, Enclosure, FloatPatch, Objective, Search, approximate, enclose, error_of,
};
use crate::elimination::Control;
use crate::report::bounds::{error_value, scientific};
use crate::statement::{Statement, Subject};

/// Decimals of the bounds: enough for four digits of the smallest error.
const PLACES: u32 = 16;

#[derive(Debug, Args)]
pub(super) struct TableOptions {
    #[command(flatten)]
    limits: Limits,
}

/// A row to be computed.
struct Row {
    name: &'static str,
    about: &'static str,
    values: Values,
}

/// Where the values of the unknowns come from.
enum Values {
    Best,
    Given(&'static [&'static str]),
}

const ROWS: &[Row] = &[
    Row { name: "cap-2x2-polynomial", about: "all weights 1, D4", values: Values::Best },
    Row {
        name: "cap-2x2",
        about: "standard edges, D4; G1 (Eq. 13)",
        values: Values::Given(&["w=1/2", "z=4*sqrt(3)/3"]),
    },
    Row { name: "cap-2x2", about: "standard edges, D4", values: Values::Best },
    Row { name: "cap-2x2-free", about: "free edges, D4", values: Values::Best },
    Row { name: "cap-3x3-d4", about: "standard edges, D4", values: Values::Best },
    Row { name: "cap-4x4-d4", about: "standard edges, D4", values: Values::Best },
    Row { name: "cap-4x2-exact", about: "other edges, D2", values: Values::Given(&[]) },
    Row { name: "cobb", about: "other edges, D4 (Cobb 1988)", values: Values::Given(&[]) },
];

/// A row as it came out.
struct Line {
    name: &'static str,
    about: &'static str,
    bidegree: (u32, u32),
    unknowns: usize,
    enclosure: Enclosure,
    gap: f64,
    kink: f64,
}

pub(super) fn run(options: &TableOptions, format: Format) -> Result<Outcome, Failure> {
    let lines = under_control(&options.limits, |control| {
        ROWS.iter().map(|row| line(row, control)).collect::<Result<Option<Vec<_>>, Failure>>()
    })??;
    let Some(lines) = lines else {
        let text = "UNDECIDED  the table was not finished in the time allowed\n".to_owned();
        return Ok(Outcome { text, status: Status::Undecided });
    };
    match format {
        Format::Json => {
            let rows: Vec<_> = lines.iter().map(Line::data).collect();
            to_json(&rows).map(Outcome::plain)
        }
        Format::Text | Format::Latex => Ok(Outcome::plain(text(&lines))),
    }
}

/// `None` if it was interrupted.
fn line(row: &Row, control: &Control<'_>) -> Result<Option<Line>, Failure> {
    let source = Source::find(row.name.as_ref())?;
    let statement = &source.statement;
    let of = |error: &dyn std::fmt::Display| Failure(format!("{}: {error}", row.name));
    let enclosure = match row.values {
        Values::Given(set) => {
            let set: Vec<String> = set.iter().map(|&text| text.to_owned()).collect();
            enclose(statement, &values(statement, &set)?, PLACES, control).map_err(|error| of(&error))?
        }
        Values::Best => {
            let search = Search {
                objective: Objective::Minimax,
                points: 101,
                pass: Vec::new(),
                places: PLACES,
                seed: 1,
            };
            match approximate(statement, &search, control) {
                Ok(found) => found.enclosure,
                Err(ApproximationError::Interrupted(_)) => return Ok(None),
                Err(error) => return Err(of(&error)),
            }
        }
    };
    let seams = FloatPatch::at(statement, &enclosure.bounds.values).map_err(|error| of(&error))?.seams();
    let bidegree = bidegree(statement);
    Ok(Some(Line {
        name: row.name,
        about: row.about,
        bidegree,
        unknowns: statement.unknowns().len(),
        enclosure,
        gap: seams.gap,
        kink: seams.kink,
    }))
}

fn bidegree(statement: &Statement) -> (u32, u32) {
    match statement.subject() {
        Subject::Patch(patch) => patch.bidegree,
        Subject::System(_) => (0, 0),
    }
}

impl Line {
    fn error(&self) -> f64 {
        error_value(&error_of(&self.enclosure), self.enclosure.bounds.places)
    }

    /// Whether both bounds are attained and 1: the patch lies on the sphere.
    fn exact(&self) -> bool {
        let bounds = &self.enclosure.bounds;
        bounds.lower.bound == bounds.upper.bound
    }

    fn cells(&self, before: Option<f64>) -> [String; 8] {
        let (m, n) = self.bidegree;
        let digits =
            before.filter(|_| !self.exact()).map(|before| format!("{:.1}", (before / self.error()).log10()));
        // What is below the rounding of floating point is taken for zero.
        let measured = |value: f64, unit: &str| {
            if value < 1e-10 { "0".to_owned() } else { format!("{value:.1e}{unit}") }
        };
        let kink = match self.kink {
            kink if kink < 1e-9 => "0, G1".to_owned(),
            kink if kink < 1e-3 => format!("{}°", scientific(kink, 1)),
            kink => format!("{kink:.4}°"),
        };
        [
            format!("({m},{n})"),
            self.about.to_owned(),
            self.name.to_owned(),
            ((m + 1) * (n + 1)).to_string(),
            self.unknowns.to_string(),
            if self.exact() { "0, exact".to_owned() } else { scientific(self.error(), 4) },
            digits.unwrap_or_default(),
            format!("{}; {kink}", measured(self.gap, "")),
        ]
    }

    fn data(&self) -> serde_json::Value {
        let bounds = &self.enclosure.bounds;
        let decimal = |units| crate::certificate::spell_decimal(units, bounds.places);
        serde_json::json!({
            "name": self.name,
            "about": self.about,
            "bidegree": self.bidegree,
            "control_points": (self.bidegree.0 + 1) * (self.bidegree.1 + 1),
            "unknowns": self.unknowns,
            "radius": { "lower": decimal(&bounds.lower.bound), "upper": decimal(&bounds.upper.bound) },
            "seams": { "gap": self.gap, "kink_degrees": self.kink },
        })
    }
}

fn text(lines: &[Line]) -> String {
    let heading =
        ["bidegree", "family", "name", "points", "unknowns", "max |r − 1|", "digits", "seam: gap; kink"]
            .map(str::to_owned);
    // Digits gained over the best patch with standard edges of the degree before.
    let mut before = None;
    let mut rows = vec![heading];
    for line in lines {
        let standard = line.about == "standard edges, D4";
        rows.push(line.cells(before.filter(|_| standard)));
        if standard {
            before = Some(line.error());
        }
    }
    let width: [usize; 8] =
        std::array::from_fn(|k| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0));
    let padded = |row: &[String; 8]| {
        let cells = row
            .iter()
            .zip(width)
            .map(|(cell, width)| format!("{cell}{}", " ".repeat(width - cell.chars().count())));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    let table: Vec<String> = rows.iter().map(padded).collect();
    format!(
        "{}\n\nmax |r − 1| is a proved bound, rounded; that the values are best is found, not proved, but for cap-2x2 and\n\
         cap-2x2-polynomial (approximate --prove-best). digits: decimal digits gained by one degree more. seam: of six patches around the cube,\n\
         the largest distance of an edge from the plane between the faces, and the largest angle between tangent planes; measured at\n\
         1001 points of each edge.\n",
        table.join("\n")
    )
}
