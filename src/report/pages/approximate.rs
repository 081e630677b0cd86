//! `approximate`.

use serde::Serialize;

use super::picture::{Picture, PictureData};
use crate::approximation::{Objective, Search, UnreachableError};
use crate::commands::{Approximated, Best, Gap, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::bounds::{
    EnclosureData, checked, enclosure_data, enclosure_details, enclosure_text, none_better, symbol,
};
use crate::report::headline::surface_equation;
use crate::report::json::{ValueData, values_data};
use crate::report::page::Page;
use crate::report::rounding::{Towards, rounded};
use crate::report::stopped::stopped_by;

/// Values that were found, and where the certificates are.
#[derive(Debug)]
pub struct Approximating<'a> {
    /// The values.
    pub approximated: &'a Approximated,
    /// Where the bounds at them were written.
    pub files: Files,
    /// Where it was written that none are better.
    pub barrier: Option<Files>,
    /// The picture, if one was asked for.
    pub picture: Option<Picture>,
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct ApproximatedData {
    #[serde(flatten)]
    enclosure: EnclosureData,
    objective: &'static str,
    recognised: bool,
    found: Vec<ValueData>,
    best: BestData,
    #[serde(skip_serializing_if = "Option::is_none")]
    open: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stopped: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    picture: Option<PictureData>,
}

/// Whether no values do better.
#[derive(Debug, Serialize)]
#[serde(untagged)]
enum BestData {
    Proved {
        proved: bool,
        none_better_than: String,
        within: String,
        boxes: usize,
        theorem: String,
        certificate: Option<String>,
    },
    Zero {
        proved: bool,
        none_better_than: &'static str,
        within: &'static str,
    },
    Found {
        proved: bool,
        how: &'static str,
    },
}

/// What is to be as small or large as can be.
fn goal(search: &Search, symbol: &str) -> String {
    match search.objective {
        Objective::LeastSquares => {
            let (n, symbol) = (search.points, if symbol == "r" { "r² − 1" } else { symbol });
            format!("least squares of {symbol} over {n} × {n} points")
        }
        Objective::Minimax if symbol == "r" => "smallest max |r − 1|".to_owned(),
        Objective::Minimax => format!("smallest max |{symbol}|"),
        Objective::Outer if symbol == "r" => "smallest max r with r ≥ 1".to_owned(),
        Objective::Outer => format!("smallest max {symbol} with {symbol} ≥ 0"),
        Objective::Inner if symbol == "r" => "largest min r with r ≤ 1".to_owned(),
        Objective::Inner => format!("largest min {symbol} with {symbol} ≤ 0"),
        Objective::Width => format!("smallest max {symbol} − min {symbol}"),
    }
}

/// What the values are, on a picture.
pub fn about(approximated: &Approximated) -> String {
    let quantity = approximated.found.enclosure.bounds.quantity;
    let goal = goal(&approximated.search, &symbol(quantity, approximated.degree));
    match &approximated.best {
        Best::Proved(_, gap) => format!("{goal}, proved up to {}", within(gap)),
        Best::NotAsked | Best::Zero | Best::Open(_) => format!("best found for: {goal}"),
    }
}

/// The best values up to this part of the error.
fn within(gap: &Gap) -> String {
    rounded(&gap.relative(), 1, Towards::Above)
}

impl Page for Approximating<'_> {
    type Data = ApproximatedData;

    fn verdict(&self) -> Verdict {
        self.approximated.verdict()
    }

    fn document(&self) -> Result<Document, Limit> {
        let Approximated { source, degree, search, found, best } = self.approximated;
        let (name, statement, enclosure) = (&source.name, &source.statement, &found.enclosure);
        let goal = goal(search, &symbol(enclosure.bounds.quantity, *degree));
        let bounds = format!("{} on the whole patch", enclosure_text(&enclosure.bounds, *degree));
        let mut document = Document::new(statement.ring());
        let word = self.verdict().word();
        if let Best::Open(why) = best {
            let reached = rounded(&self.approximated.reached(), 4, Towards::Above);
            let open = format!("{name}: that no values do better than {reached} is not proved: {why}");
            document.headline(word, open);
            document.gap();
            document.line(0, format!("Proved: {bounds}"));
        } else {
            document.headline(word, format!("{name}: {bounds}"));
            document.gap();
        }
        document.line(0, statement.title());
        document.line(0, format!("Surface: {}", surface_equation(statement)));
        let how_good = match best {
            Best::Proved(_, gap) => format!("{goal}, proved up to {} of it", within(gap)),
            Best::Zero => format!("{goal}: it is 0, and nothing is less"),
            _ => format!("best found for: {goal}; found by search, not proved best"),
        };
        document.line(0, how_good);
        document.line(0, format!("at {}", self.taken()));
        document.gap();
        enclosure_details(&mut document, statement, enclosure, *degree);
        if let Best::Proved(barrier, gap) = best {
            none_better(&mut document, barrier, gap);
        }
        checked(&mut document, enclosure.proof.theorem(), &self.files);
        if let (Best::Proved(barrier, _), Some(files)) = (best, &self.barrier) {
            checked(&mut document, barrier.proof.theorem(), files);
        }
        document.blocks.extend(self.picture.as_ref().map(Picture::block));
        Ok(document)
    }

    fn data(&self) -> Result<ApproximatedData, Limit> {
        let Approximated { source, search, found, best, .. } = self.approximated;
        let open = match best {
            Best::Open(why) => Some(why),
            _ => None,
        };
        let stopped = match open {
            Some(UnreachableError::Interrupted(why)) => Some(stopped_by(why.why)),
            _ => None,
        };
        Ok(ApproximatedData {
            enclosure: enclosure_data(&source.name, &source.statement, &found.enclosure, &self.files),
            objective: match search.objective {
                Objective::LeastSquares => "least-squares",
                Objective::Minimax => "minimax",
                Objective::Outer => "outer",
                Objective::Inner => "inner",
                Objective::Width => "width",
            },
            recognised: found.recognised,
            found: values_data(&source.statement, &found.found.values),
            best: match best {
                Best::Proved(barrier, gap) => BestData::Proved {
                    proved: true,
                    none_better_than: gap.unreached.to_string(),
                    within: gap.relative().to_string(),
                    boxes: barrier.boxes,
                    theorem: barrier.proof.theorem().sentence(),
                    certificate: self.barrier.as_ref().map(|files| files.certificate.display().to_string()),
                },
                Best::Zero => BestData::Zero { proved: true, none_better_than: "0", within: "0" },
                _ => BestData::Found { proved: false, how: "best found by search" },
            },
            open: open.map(ToString::to_string),
            stopped,
            picture: self.picture.as_ref().map(Picture::data),
        })
    }
}

impl Approximating<'_> {
    /// Which values were taken.
    fn taken(&self) -> String {
        let found = &self.approximated.found;
        if found.recognised && matches!(self.approximated.best, Best::Zero) {
            return "exact values recognised near those found".to_owned();
        }
        if found.recognised {
            return "exact values recognised near those found; that they are the best is a guess, the bounds are proved"
                .to_owned();
        }
        let places = &found.found.places;
        match (places.iter().min(), places.iter().max()) {
            (Some(least), Some(most)) if least == most && *least > 0 => {
                format!("values rounded to {least} decimals")
            }
            _ => "values rounded to as many digits as the search has".to_owned(),
        }
    }
}
