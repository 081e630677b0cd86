//! `prove-cap export --to LANGUAGE NAME|FILE`: the proof in another language, for another program to verify.

use std::path::{Path, PathBuf};

use super::arguments::ExportOptions;
use super::control::under_control;
use super::files::{read_limited, write_atomically};
use super::outcome::{Ended, Format, Outcome};
use super::source::find;
use crate::commands::{self, Division, Failure, Which};
use crate::control::Control;
use crate::exact::limits;
use crate::report::pages::{ExportShown, ExportWritten};

pub(super) fn run(options: &ExportOptions, format: Format) -> Result<Outcome, Failure> {
    let name = options.source.to_string_lossy();
    under_control(&options.limits, (&name, format), |control| carried_out(options, format, control))
}

fn carried_out(options: &ExportOptions, format: Format, control: &Control) -> Result<Outcome, Ended> {
    let source = find(&options.source, control)?;
    let certificate = options.certificate.as_deref();
    let bytes = certificate.map(|file| read_limited(file, limits::CERTIFICATE_BYTES.at_most)).transpose()?;
    let which = match (certificate, &bytes) {
        (Some(file), Some(bytes)) => Which::Given { file, bytes, unchecked: options.unchecked },
        _ => Which::Found,
    };
    let division = if options.output.is_some() { Division::Files } else { Division::Whole };
    let exported = commands::export(&source, which, (options.to.target(), division), control)?;
    let Some(target) = &options.output else {
        return Ok(Outcome::of(&ExportShown(&exported), format)?);
    };
    let mut files = Vec::with_capacity(exported.parts.len());
    for (ending, text) in &exported.parts {
        let mut file = target.as_os_str().to_owned();
        if let Some(ending) = ending {
            file.push(format!(".{ending}"));
        }
        write_atomically(Path::new(&file), text.as_bytes())?;
        files.push((PathBuf::from(file), text.len()));
    }
    Ok(Outcome::of(&ExportWritten { name: exported.name, files }, format)?)
}
