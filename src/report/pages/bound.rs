//! `bound`.

use serde::Serialize;

use super::picture::{Picture, PictureData};
use crate::commands::{Bounded, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::bounds::{
    EnclosureData, EndVerdictData, checked, enclosure_data, enclosure_details, enclosure_text, judged, symbol,
};
use crate::report::headline::surface_equation;
use crate::report::page::Page;

/// Proved bounds, and where their certificate is.
#[derive(Debug)]
pub struct Bounding<'a> {
    /// The bounds.
    pub bounded: &'a Bounded,
    /// Where statement and certificate were written.
    pub files: Files,
    /// The picture, if one was asked for.
    pub picture: Option<Picture>,
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct BoundData {
    #[serde(flatten)]
    enclosure: EnclosureData,
    claim: Option<Vec<EndVerdictData>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    picture: Option<PictureData>,
}

impl Page for Bounding<'_> {
    type Data = BoundData;

    fn verdict(&self) -> Verdict {
        self.bounded.verdict()
    }

    fn document(&self) -> Result<Document, Limit> {
        let Bounded { source, degree, enclosure, claim } = self.bounded;
        let (name, statement) = (&source.name, &source.statement);
        let enclosed = format!("{} on the whole patch", enclosure_text(&enclosure.bounds, *degree));
        let mut document = Document::new(statement.ring());
        let holds = match self.verdict() {
            Verdict::Agrees => "holds",
            Verdict::Undecided => "is not decided",
            _ => "does not hold",
        };
        let sentence = match claim {
            Some(([low, high], _)) => format!("{name}: the printed interval [{low}, {high}] {holds}"),
            None => format!("{name}: {enclosed}"),
        };
        document.headline(self.verdict().word(), sentence);
        document.line(0, format!("Surface: {}", surface_equation(statement)));
        if let Some((_, verdicts)) = claim {
            document.gap();
            judged(&mut document, verdicts, &symbol(enclosure.bounds.quantity, *degree));
            document.gap();
            document.line(0, format!("Proved: {enclosed}"));
        }
        document.gap();
        document.line(0, statement.title());
        document.gap();
        enclosure_details(&mut document, statement, enclosure, *degree);
        checked(&mut document, enclosure.proof.theorem(), &self.files);
        document.blocks.extend(self.picture.as_ref().map(Picture::block));
        Ok(document)
    }

    fn data(&self) -> Result<BoundData, Limit> {
        let Bounded { source, enclosure, claim, .. } = self.bounded;
        let verdicts = claim.as_ref().map(|(_, verdicts)| verdicts);
        Ok(BoundData {
            enclosure: enclosure_data(&source.name, &source.statement, enclosure, &self.files),
            claim: verdicts.map(|verdicts| verdicts.iter().map(EndVerdictData::of).collect()),
            picture: self.picture.as_ref().map(Picture::data),
        })
    }
}
