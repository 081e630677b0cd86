//! `degrees`, the table and the argument for one of its cells.

use serde::Serialize;

use crate::commands::{Degrees, Shape, Verdict};
use crate::construction::{Cell, Phase, classify};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::degrees::{ArgumentData, classified, explain};
use crate::report::page::Page;

/// Which bidegrees are exact, and where what backs it is.
#[derive(Debug)]
pub struct Classifying<'a> {
    /// The answer.
    pub degrees: &'a Degrees,
    /// The refutation of the closing condition.
    pub closing: Option<Files>,
    /// What is written of each net.
    pub nets: Vec<Vec<Files>>,
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct DegreesData {
    name: String,
    cells: Vec<CellData>,
    closing: Option<String>,
    nets: Vec<BaseData>,
}

/// A bidegree.
#[derive(Debug, Serialize)]
struct CellData {
    bidegree: (u32, u32),
    verdict: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    lemma: Option<&'static str>,
    /// The bidegree from which degrees are raised.
    #[serde(skip_serializing_if = "Option::is_none")]
    from: Option<(u32, u32)>,
}

/// A net that backs the table.
#[derive(Debug, Serialize)]
struct BaseData {
    bidegree: (u32, u32),
    covers: bool,
    files: Vec<String>,
}

impl CellData {
    fn of(phase: Phase, bidegree: (u32, u32)) -> Self {
        let (verdict, lemma, from) = match classify(phase, bidegree) {
            Cell::NoSurface => ("impossible", Some("parity"), None),
            Cell::NoClosure => ("impossible", Some("holonomy"), None),
            Cell::LongerWay => ("longer way", Some("holonomy"), None),
            Cell::Exact(base) => ("exact", None, Some(base)),
        };
        CellData { bidegree, verdict, lemma, from }
    }
}

impl Page for Classifying<'_> {
    type Data = DegreesData;

    fn verdict(&self) -> Verdict {
        Verdict::Classified
    }

    fn document(&self) -> Result<Document, Limit> {
        Ok(classified(self.degrees, self.closing.as_ref(), &self.nets))
    }

    fn data(&self) -> Result<DegreesData, Limit> {
        let Degrees { shape, phase, up_to, nets, .. } = self.degrees;
        let all = (1..=*up_to).flat_map(|m| (1..=*up_to).map(move |n| (m, n)));
        let certificate = |files: &Files| files.certificate.display().to_string();
        let bases = nets.iter().zip(&self.nets).map(|((bidegree, made), files)| BaseData {
            bidegree: *bidegree,
            covers: made.cover.is_ok(),
            files: files.iter().map(certificate).collect(),
        });
        Ok(DegreesData {
            name: shape.name.clone(),
            cells: all.map(|bidegree| CellData::of(*phase, bidegree)).collect(),
            closing: self.closing.as_ref().map(certificate),
            nets: bases.collect(),
        })
    }
}

/// The argument for one bidegree.
#[derive(Debug)]
pub struct Explained {
    /// The polygon.
    pub shape: Shape,
    /// The bidegree.
    pub bidegree: (u32, u32),
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct ExplainedData {
    name: String,
    bidegree: (u32, u32),
    exact: bool,
    #[serde(flatten)]
    argument: ArgumentData,
}

impl Explained {
    fn cell(&self) -> Cell {
        classify(Phase::of(&self.shape.polygon), self.bidegree)
    }
}

impl Page for Explained {
    type Data = ExplainedData;

    fn verdict(&self) -> Verdict {
        Verdict::Classified
    }

    fn document(&self) -> Result<Document, Limit> {
        Ok(explain(&self.shape.name, &self.shape.polygon, self.bidegree))
    }

    fn data(&self) -> Result<ExplainedData, Limit> {
        let cell = self.cell();
        Ok(ExplainedData {
            name: self.shape.name.clone(),
            bidegree: self.bidegree,
            exact: matches!(cell, Cell::Exact(_)),
            argument: ArgumentData::of(&self.shape.polygon, self.bidegree, cell)?,
        })
    }
}
