//! What became of a picture that was asked for.

use std::path::PathBuf;

use serde::Serialize;

use crate::approximation::Enclosure;
use crate::commands::Source;
use crate::control::Interrupted;
use crate::document::Block;
use crate::report::bounds::{quantity_name, value_text};

/// What became of it: a result stands without a picture.
#[derive(Debug)]
pub enum Picture {
    /// It is in this file.
    Drawn(PathBuf),
    /// The work was stopped.
    NotDrawn(Interrupted),
}

/// The same as data.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum PictureData {
    File(String),
    NotDrawn(String),
}

impl Picture {
    /// The line that tells of it.
    pub(super) fn block(&self) -> Block {
        match self {
            Picture::Drawn(file) => Block::Figure(file.clone()),
            Picture::NotDrawn(why) => Block::Field {
                name: "Picture".to_owned(),
                width: 13,
                phrase: format!("not drawn: {why}").into(),
            },
        }
    }

    pub(super) fn data(&self) -> PictureData {
        match self {
            Picture::Drawn(file) => PictureData::File(file.display().to_string()),
            Picture::NotDrawn(why) => PictureData::NotDrawn(why.to_string()),
        }
    }
}

/// Characters of a title at most.
const TITLE: usize = 90;

/// What stands above a picture, the name with the values of the unknowns, and what is drawn: `r − 1`.
pub fn caption(source: &Source, enclosure: &Enclosure, about: Option<&str>) -> (String, String) {
    let (statement, bounds) = (&source.statement, &enclosure.bounds);
    let settings = statement.unknowns().iter().zip(&bounds.values);
    let settings: Vec<String> =
        settings.map(|(name, value)| format!("{name} = {}", value_text(statement, value))).collect();
    let name = about.map_or(source.name.clone(), |about| format!("{}, {about}", source.name));
    let mut title = [vec![name], settings].concat().join(", ");
    if title.chars().count() > TITLE {
        title = title.chars().take(TITLE - 2).chain(" …".chars()).collect();
    }
    (title, quantity_name(statement, bounds.quantity))
}
