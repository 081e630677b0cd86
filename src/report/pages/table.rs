//! `table`.

use num_rational::BigRational;
use serde::Serialize;

use crate::certificate::spell_decimal;
use crate::commands::{Line, ROWS, Table, Unfinished, Verdict};
use crate::document::{self, Block, Column, Document};
use crate::exact::Limit;
use crate::report::page::Page;
use crate::report::rounding::{Towards, rounded};
use crate::report::stopped::{BestSoFarData, best_so_far, stopped_by};

/// The rows as far as they came.
#[derive(Debug)]
pub struct Tabled<'a>(pub &'a Table);

/// The same as data.
#[derive(Debug, Serialize)]
pub struct TableData {
    rows: Vec<RowData>,
    of: usize,
    stopped: Option<&'static str>,
    reason: Option<String>,
    unfinished: Option<UnfinishedData>,
}

#[derive(Debug, Serialize)]
struct RowData {
    name: &'static str,
    about: &'static str,
    bidegree: (u32, u32),
    control_points: u32,
    unknowns: usize,
    radius: RadiusData,
    values: &'static str,
    seams_measured_in_floating_point: SeamsData,
}

#[derive(Debug, Serialize)]
struct RadiusData {
    lower: String,
    upper: String,
}

#[derive(Debug, Serialize)]
struct SeamsData {
    gap: f64,
    kink_degrees: f64,
}

#[derive(Debug, Serialize)]
struct UnfinishedData {
    name: &'static str,
    about: &'static str,
    best_found: Option<BestSoFarData>,
}

impl Page for Tabled<'_> {
    type Data = TableData;

    fn verdict(&self) -> Verdict {
        self.0.verdict()
    }

    fn document(&self) -> Result<Document, Limit> {
        let Table { lines, unfinished } = self.0;
        let mut document = Document::of_words();
        if let Some(stopped) = unfinished {
            unfinished_row(&mut document, stopped, lines.len());
        }
        if !lines.is_empty() {
            if unfinished.is_some() {
                document.gap();
            }
            document.push(Block::Table(rows(lines)));
            document.gap();
            document.line(0, EXPLAINED);
        }
        Ok(document)
    }

    fn data(&self) -> Result<TableData, Limit> {
        let Table { lines, unfinished } = self.0;
        let unfinished = unfinished.as_ref();
        Ok(TableData {
            rows: lines.iter().map(row_data).collect(),
            of: ROWS.len(),
            stopped: unfinished.map(|stopped| stopped_by(stopped.why.why)),
            reason: unfinished.map(|stopped| stopped.why.to_string()),
            unfinished: unfinished.map(|stopped| UnfinishedData {
                name: stopped.row.name,
                about: stopped.row.about,
                best_found: stopped.best.as_ref().map(|best| BestSoFarData::of(&stopped.statement, best)),
            }),
        })
    }
}

fn unfinished_row(document: &mut Document, stopped: &Unfinished, finished: usize) {
    let (why, all) = (&stopped.why, ROWS.len());
    let sentence = format!("{why}: {finished} of {all} rows of the table were finished");
    document.headline(Verdict::Undecided.word(), sentence);
    if let Some(best) = &stopped.best {
        document.gap();
        document.line(0, format!("{}, {}", stopped.row.name, stopped.row.about));
        best_so_far(document, &stopped.statement, best);
    }
}

fn row_data(line: &Line) -> RowData {
    let bounds = &line.enclosure.bounds;
    let (m, n) = line.bidegree;
    RowData {
        name: line.row.name,
        about: line.row.about,
        bidegree: line.bidegree,
        control_points: (m + 1) * (n + 1),
        unknowns: line.unknowns,
        radius: RadiusData {
            lower: spell_decimal(&bounds.lower.bound, bounds.places),
            upper: spell_decimal(&bounds.upper.bound, bounds.places),
        },
        values: line.origin(),
        seams_measured_in_floating_point: SeamsData { gap: line.seams.gap, kink_degrees: line.seams.kink },
    }
}

fn cells(line: &Line) -> [String; 8] {
    let (m, n) = line.bidegree;
    // What is below the rounding of floating point is taken for zero; the rest is rounded up.
    let gap = if line.seams.gap < 1e-10 { "0".to_owned() } else { above(line.seams.gap) };
    let kink = match line.seams.kink {
        kink if kink < 1e-9 => "0, G1".to_owned(),
        kink if kink < 1e-3 => format!("{}°", above(kink)),
        kink => format!("{:.4}°", (kink * 1e4).ceil() / 1e4),
    };
    [
        format!("({m},{n})"),
        line.row.about.to_owned(),
        line.row.name.to_owned(),
        ((m + 1) * (n + 1)).to_string(),
        line.unknowns.to_string(),
        if line.exact() { "0, exact".to_owned() } else { rounded(&line.error(), 4, Towards::Above) },
        line.digits.map_or_else(String::new, |digits| format!("{digits:.1}")),
        format!("{gap}; {kink}"),
    ]
}

/// What the columns mean.
const EXPLAINED: &str = "max |r − 1| is a proved bound, rounded up. Values of unknowns are the best found by search, but for Eq. 13; that none are better\n\
    is not proved here (`approximate NAME --prove-best` does, where it can). digits: decimal digits gained by one degree more. seam: of\n\
    six patches around the cube, the largest distance of an edge from the plane between the faces, and the largest angle between\n\
    tangent planes; measured at 1001 points of each edge in floating point, rounded up.";

fn rows(lines: &[Line]) -> document::Table {
    let mut table = document::Table::new(0, [Column::left(2); 8]).headed([
        "bidegree",
        "family",
        "name",
        "points",
        "unknowns",
        "max |r − 1|",
        "digits",
        "seam: gap; kink",
    ]);
    for line in lines {
        table.row(cells(line));
    }
    table
}

/// 1.3·10⁻⁷, rounded up.
fn above(value: f64) -> String {
    BigRational::from_float(value).map_or("?".to_owned(), |value| rounded(&value, 1, Towards::Above))
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::control::{Control, Why};

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
        let table = crate::commands::table(&control).unwrap();
        let names: Vec<_> = table.lines.iter().map(|line| (line.row.name, line.origin())).collect();
        assert_eq!(names, [("cap-2x2-polynomial", "best found"), ("cap-2x2", "given")]);
        let page = Tabled(&table);
        let text = crate::report::text(&page).unwrap();
        let expected = "UNDECIDED  interrupted: 2 of 8 rows of the table were finished\n\n\
                        cap-2x2, standard edges, D4\n\
                        Best found so far, by search; nothing is proved of it\n   w = 0.47";
        assert!(text.starts_with(expected), "{text}");
        assert!(text.contains("8.4628·10⁻³"));
        let data: serde_json::Value = serde_json::from_str(&crate::report::json(&page).unwrap()).unwrap();
        assert_eq!((&data["verdict"], &data["stopped"]), (&"UNDECIDED".into(), &"ctrl-c".into()));
        assert_eq!(data["rows"].as_array().map(Vec::len), Some(2));
        assert_eq!(data["unfinished"]["best_found"]["values"][0]["unknown"], "w");
    }
}
