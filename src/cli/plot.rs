//! `--plot FILE`: pictures of a patch at the values that were enclosed.

use super::arguments::PlotOptions;
use super::files::write_atomically;
use crate::approximation::Enclosure;
use crate::commands::{self, Failure, Source};
use crate::control::Control;
use crate::report::pages::{Picture, caption};

impl PlotOptions {
    /// Draws the picture, if one is asked for: what is proved stands without it.
    pub(super) fn draw(
        &self,
        source: &Source,
        enclosure: &Enclosure,
        about: Option<&str>,
        control: &Control,
    ) -> Result<Option<Picture>, Failure> {
        let Some(file) = &self.plot else { return Ok(None) };
        if let Err(why) = control.check() {
            return Ok(Some(Picture::NotDrawn(why)));
        }
        let (title, symbol) = caption(source, enclosure, about);
        let bytes = commands::picture(
            (self.figure.into(), file),
            &source.statement,
            enclosure,
            (&title, &symbol),
            control,
        )?;
        Ok(Some(match bytes {
            Ok(bytes) => {
                write_atomically(file, &bytes)?;
                Picture::Drawn(file.clone())
            }
            Err(why) => Picture::NotDrawn(why),
        }))
    }
}
