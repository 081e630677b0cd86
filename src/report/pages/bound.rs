//! `bound`.

use serde::Serialize;

use super::picture::{Picture, PictureData};
use crate::commands::{Bounded, Verdict};
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::bounds::{
    EnclosureData, EndVerdictData, checked_text, enclosure_data, enclosure_details, enclosure_text, symbol,
    verdict_text,
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

    fn text(&self) -> Result<String, Limit> {
        let Bounded { source, degree, enclosure, claim } = self.bounded;
        let (name, statement, word) = (&source.name, &source.statement, self.verdict());
        let enclosed = enclosure_text(&enclosure.bounds, *degree);
        let surface = format!("Surface: {}", surface_equation(statement));
        let mut text = match claim {
            Some(([low, high], verdicts)) => {
                let holds = match word {
                    Verdict::Agrees => "holds",
                    Verdict::Undecided => "is not decided",
                    _ => "does not hold",
                };
                let symbol = symbol(enclosure.bounds.quantity, *degree);
                format!(
                    "{word}  {name}: the printed interval [{low}, {high}] {holds}\n{surface}\n\n{}\n\
                     Proved: {enclosed} on the whole patch\n",
                    verdict_text(verdicts, &symbol)
                )
            }
            None => format!("{word}  {name}: {enclosed} on the whole patch\n{surface}\n"),
        };
        text += &format!("\n{}\n\n", statement.title());
        text += &enclosure_details(statement, enclosure, *degree);
        text += &checked_text(enclosure.proof.theorem(), &self.files);
        text += &self.picture.as_ref().map_or_else(String::new, Picture::text);
        Ok(text)
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
