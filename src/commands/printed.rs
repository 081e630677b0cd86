//! What a file that is to be audited is: a listing of formulas or a control net, in which notation.

use std::path::Path;

use super::audit::failure;
use super::{Failure, Source};
use crate::audit::PAPER;
use crate::control::Control;
use crate::formats::listing::{
    LISTING_BYTES, Listing, Notation, convention_word, decode, is_expansion, is_net,
};
use crate::formats::net::{Convention, PrintedNet, from_json, from_matlab};

/// Bytes of a file that may be JSON: what is written for a statement may have its proof beside it.
pub const JSON_BYTES: u64 = 16 << 20;

/// What a file to be audited is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// Formulas in LaTeX.
    Latex,
    /// Formulas in plain text.
    Plain,
    /// A listing or a net in TOML.
    Toml,
    /// A net, or an expansion, in JSON.
    Json,
    /// A net in MATLAB's notation.
    Matlab,
}

impl FileKind {
    /// By the ending of its name.
    ///
    /// # Errors
    /// Where that does not tell.
    pub fn of(file: &Path) -> Result<FileKind, Failure> {
        let ending = file.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        Ok(match ending {
            "tex" | "latex" => FileKind::Latex,
            "txt" => FileKind::Plain,
            "toml" => FileKind::Toml,
            "json" => FileKind::Json,
            "m" => FileKind::Matlab,
            _ => {
                return Err(Failure::in_file(
                    file,
                    "a listing or a net, in which notation? say so with --as, or by the ending .tex, .txt, .toml, .json or .m",
                ));
            }
        })
    }

    /// How many bytes such a file may have.
    pub fn bytes(self) -> u64 {
        if self == FileKind::Json { JSON_BYTES } else { LISTING_BYTES }
    }
}

/// What was read.
#[derive(Debug)]
pub enum Printed {
    /// Formulas, with the statement that is in the same file, if so.
    Listing(Box<Listing>, Option<Box<Source>>),
    /// A control net.
    Net(PrintedNet),
}

impl Printed {
    /// The paper's Eq. 11.
    ///
    /// # Errors
    /// Where it cannot be read: a fault of this program.
    pub fn paper() -> Result<Printed, Failure> {
        let listing = Listing::from_toml(PAPER).map_err(Failure::of)?;
        Ok(Printed::Listing(Box::new(listing), None))
    }

    /// The net of a statement, which says itself which convention it follows.
    ///
    /// # Errors
    /// Where the statement has unknowns or no patch, or a convention is stated besides.
    pub fn net_of(place: &str, source: &Source, stated: Option<Convention>) -> Result<Printed, Failure> {
        if stated.is_some() {
            return Err(Failure::new("a statement says itself which convention it follows"));
        }
        let convention = convention_word(&source.text).and_then(|word| Convention::read(&word));
        let convention = convention.unwrap_or(Convention::Homogeneous);
        PrintedNet::from_statement(&source.statement, convention)
            .map(Printed::Net)
            .map_err(|error| failure(place, error.into()))
    }

    /// The bytes of a file.
    ///
    /// # Errors
    /// Where they cannot be read as what they are said to be.
    pub fn read(
        file: &Path,
        kind: FileKind,
        bytes: &[u8],
        stated: Option<Convention>,
        control: &Control,
    ) -> Result<Printed, Failure> {
        let place = file.display().to_string();
        let text = decode(bytes, kind.bytes()).map_err(|error| Failure::at(&place, &error))?;
        let title = file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let listing = match kind {
            FileKind::Latex => Listing::from_formulas(&title, text, Notation::Latex),
            FileKind::Plain => Listing::from_formulas(&title, text, Notation::Plain),
            FileKind::Toml if is_net(text) => {
                return Printed::net_of(&place, &Source::read(file, bytes, control)?, stated);
            }
            FileKind::Toml => Listing::from_toml(text),
            FileKind::Json if is_expansion(text) => {
                let listing = Listing::from_json(text).map_err(|error| Failure::at(&place, &error))?;
                let own = Source::from_json(file, text)?;
                return Ok(Printed::Listing(Box::new(listing), Some(Box::new(own))));
            }
            FileKind::Json => {
                let net = from_json(text).map_err(|error| failure(&place, error.into()))?;
                let convention = stated.unwrap_or(net.convention);
                return Ok(Printed::Net(PrintedNet { convention, ..net }));
            }
            FileKind::Matlab => {
                let Some(convention) = stated else {
                    return Err(Failure::in_file(
                        file,
                        "are the points premultiplied by their weights? MATLAB files do not say: add \
                         --convention homogeneous (premultiplied) or --convention cartesian",
                    ));
                };
                let net =
                    from_matlab(text, &title, convention).map_err(|error| failure(&place, error.into()))?;
                return Ok(Printed::Net(net));
            }
        };
        listing
            .map(|listing| Printed::Listing(Box::new(listing), None))
            .map_err(|error| Failure::at(&place, &error))
    }
}
