//! `prove-cap table`: how good patches of the cap are, degree by degree, and how six of them fit together.

use clap::Args;
use num_rational::BigRational;
use num_traits::ToPrimitive;

use super::arguments::{Format, to_json};
use super::control::{Limits, controlled};
use super::outcome::{Failure, Outcome};
use super::source::Source;
use super::values::values;
use crate::approximation::{
    ApproximationError, BestSoFar, Enclosure, EnclosureError, FloatPatch, Objective, Search, approximate,
    enclose, error_of,
};
use crate::commands::Verdict;
use crate::control::{Control, Interrupted};
use crate::report::bounds::error_value;
use crate::report::rounding::{Towards, rounded};
use crate::report::stopped::{best_so_far_data, best_so_far_text, stopped_by};
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
    /// Where the values of the unknowns come from.
    values: &'static str,
    bidegree: (u32, u32),
    unknowns: usize,
    enclosure: Enclosure,
    gap: f64,
    kink: f64,
}

/// A row that was being computed when the work was stopped.
struct Unfinished {
    row: &'static Row,
    why: Interrupted,
    best: Option<Box<BestSoFar>>,
}

pub(super) fn run(options: &TableOptions, format: Format) -> Result<Outcome, Failure> {
    let (lines, unfinished) = controlled(&options.limits, rows)??;
    let verdict = if unfinished.is_some() { Verdict::Undecided } else { Verdict::Shown };
    let text = match format {
        Format::Json => to_json(&data(&lines, unfinished.as_ref())?)?,
        Format::Text | Format::Latex => {
            let stopped = unfinished.as_ref().map(|stopped| stopped.text(lines.len())).transpose()?;
            let table = if lines.is_empty() { String::new() } else { text(&lines) };
            match stopped {
                Some(stopped) if lines.is_empty() => stopped,
                Some(stopped) => format!("{stopped}\n{table}"),
                None => table,
            }
        }
    };
    Ok(Outcome { text, verdict })
}

/// The rows as far as they come.
fn rows(control: &Control) -> Result<(Vec<Line>, Option<Unfinished>), Failure> {
    let mut lines = Vec::new();
    for row in ROWS {
        match line(row, control)? {
            Ok(line) => lines.push(line),
            Err(unfinished) => return Ok((lines, Some(unfinished))),
        }
    }
    Ok((lines, None))
}

/// One row, or where it was interrupted.
fn line(row: &'static Row, control: &Control) -> Result<Result<Line, Unfinished>, Failure> {
    let source = Source::find(row.name.as_ref())?;
    let statement = &source.statement;
    let of = |error: &dyn std::fmt::Display| Failure(format!("{}: {error}", row.name));
    let enclosure = match row.values {
        Values::Given(set) => {
            let set: Vec<String> = set.iter().map(|&text| text.to_owned()).collect();
            match enclose(statement, &values(statement, &set)?, PLACES, control) {
                Ok(enclosure) => enclosure,
                Err(EnclosureError::Interrupted(why)) => return Ok(Err(Unfinished { row, why, best: None })),
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
            match approximate(statement, &search, control) {
                Ok(found) => found.enclosure,
                Err(ApproximationError::Interrupted(why, best)) => {
                    return Ok(Err(Unfinished { row, why, best }));
                }
                Err(error) => return Err(of(&error)),
            }
        }
    };
    let seams = FloatPatch::at(statement, &enclosure.bounds.values).map_err(|error| of(&error))?.seams();
    let bidegree = bidegree(statement);
    Ok(Ok(Line {
        name: row.name,
        about: row.about,
        values: match row.values {
            Values::Best => "best found",
            Values::Given(_) if statement.unknowns().is_empty() => "none",
            Values::Given(_) => "given",
        },
        bidegree,
        unknowns: statement.unknowns().len(),
        enclosure,
        gap: seams.gap,
        kink: seams.kink,
    }))
}

impl Unfinished {
    fn text(&self, finished: usize) -> Result<String, Failure> {
        let mut text = format!(
            "UNDECIDED  {}: {finished} of {} rows of the table were finished\n",
            self.why,
            ROWS.len()
        );
        if let Some(best) = &self.best {
            let source = Source::find(self.row.name.as_ref())?;
            text += &format!("\n{}, {}\n", self.row.name, self.row.about);
            text += &best_so_far_text(&source.statement, best);
        }
        Ok(text)
    }
}

/// The rows as far as they are finished, and what stopped the work.
fn data(lines: &[Line], unfinished: Option<&Unfinished>) -> Result<serde_json::Value, Failure> {
    let best = |stopped: &Unfinished| {
        let statement = Source::find(stopped.row.name.as_ref())?.statement;
        Ok::<_, Failure>(stopped.best.as_ref().map(|best| best_so_far_data(&statement, best)))
    };
    Ok(serde_json::json!({
        "rows": lines.iter().map(Line::data).collect::<Vec<_>>(),
        "of": ROWS.len(),
        "stopped": unfinished.map(|stopped| stopped_by(stopped.why.why)),
        "reason": unfinished.map(|stopped| stopped.why.to_string()),
        "unfinished": unfinished.map(|stopped| Ok::<_, Failure>(serde_json::json!({
            "name": stopped.row.name,
            "about": stopped.row.about,
            "best_found": best(stopped)?,
        }))).transpose()?,
    }))
}

fn bidegree(statement: &Statement) -> (u32, u32) {
    match statement.subject() {
        Subject::Patch(patch) => patch.bidegree,
        Subject::System(_) => (0, 0),
    }
}

impl Line {
    fn error(&self) -> BigRational {
        error_value(&error_of(&self.enclosure), self.enclosure.bounds.places)
    }

    /// The same in floating point, to be compared.
    fn size(&self) -> f64 {
        self.error().to_f64().unwrap_or(f64::NAN)
    }

    /// Whether both bounds are attained and 1: the patch lies on the sphere.
    fn exact(&self) -> bool {
        let bounds = &self.enclosure.bounds;
        bounds.lower.bound == bounds.upper.bound
    }

    fn cells(&self, before: Option<f64>) -> [String; 8] {
        let (m, n) = self.bidegree;
        let digits =
            before.filter(|_| !self.exact()).map(|before| format!("{:.1}", (before / self.size()).log10()));
        // What is below the rounding of floating point is taken for zero; the rest is rounded up.
        let measured = |value: f64| {
            if value < 1e-10 { "0".to_owned() } else { above(value) }
        };
        let kink = match self.kink {
            kink if kink < 1e-9 => "0, G1".to_owned(),
            kink if kink < 1e-3 => format!("{}°", above(kink)),
            kink => format!("{:.4}°", (kink * 1e4).ceil() / 1e4),
        };
        [
            format!("({m},{n})"),
            self.about.to_owned(),
            self.name.to_owned(),
            ((m + 1) * (n + 1)).to_string(),
            self.unknowns.to_string(),
            if self.exact() { "0, exact".to_owned() } else { rounded(&self.error(), 4, Towards::Above) },
            digits.unwrap_or_default(),
            format!("{}; {kink}", measured(self.gap)),
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
            "values": self.values,
            "seams_measured_in_floating_point": { "gap": self.gap, "kink_degrees": self.kink },
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
            before = Some(line.size());
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
        "{}\n\nmax |r − 1| is a proved bound, rounded up. Values of unknowns are the best found by search, but for Eq. 13; that none are better\n\
         is not proved here (`approximate NAME --prove-best` does, where it can). digits: decimal digits gained by one degree more. seam: of\n\
         six patches around the cube, the largest distance of an edge from the plane between the faces, and the largest angle between\n\
         tangent planes; measured at 1001 points of each edge in floating point, rounded up.\n",
        table.join("\n")
    )
}

/// 1.3·10⁻⁷, rounded up.
fn above(value: f64) -> String {
    BigRational::from_float(value).map_or("?".to_owned(), |value| rounded(&value, 1, Towards::Above))
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::control::Why;

    #[test]
    fn rows_that_are_finished_are_kept_and_the_next_as_far_as_it_came() {
        let stopper = Control::default();
        let descents = AtomicUsize::new(0);
        // The second row has its values given: the second descent is that of the third row.
        let control = stopper.clone().observed(move |progress| {
            let starts = progress.to_string().starts_with("linear programs: round 1,");
            if starts && descents.fetch_add(1, Ordering::Relaxed) == 1 {
                stopper.stop(Why::Interrupt);
            }
        });
        let (lines, unfinished) = rows(&control).unwrap();
        let names: Vec<_> = lines.iter().map(|line| (line.name, line.values)).collect();
        assert_eq!(names, [("cap-2x2-polynomial", "best found"), ("cap-2x2", "given")]);
        let unfinished = unfinished.unwrap();
        let text = unfinished.text(lines.len()).unwrap();
        let expected = "UNDECIDED  interrupted: 2 of 8 rows of the table were finished\n\n\
                        cap-2x2, standard edges, D4\n\
                        Best found so far, by search; nothing is proved of it\n   w = 0.47";
        assert!(text.starts_with(expected), "{text}");
        let data = data(&lines, Some(&unfinished)).unwrap();
        assert_eq!(data["stopped"], "ctrl-c");
        assert_eq!(data["rows"].as_array().map(Vec::len), Some(2));
        assert_eq!(data["unfinished"]["best_found"]["values"][0]["unknown"], "w");
        assert!(super::text(&lines).contains("8.4628·10⁻³"));
    }
}
