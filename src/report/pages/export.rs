//! `export`, to standard output and into files.

use std::path::PathBuf;

use serde::Serialize;

use crate::commands::{Exported, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::page::Page;

/// A proof in another language, as it is.
#[derive(Debug)]
pub struct ExportShown<'a>(pub &'a Exported);

/// The same as data.
#[derive(Debug, Serialize)]
pub struct ExportShownData {
    name: String,
    text: String,
}

impl Page for ExportShown<'_> {
    type Data = ExportShownData;

    fn verdict(&self) -> Verdict {
        Verdict::Shown
    }

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        document.source(0, self.whole());
        Ok(document)
    }

    fn data(&self) -> Result<ExportShownData, Limit> {
        Ok(ExportShownData { name: self.0.name.clone(), text: self.whole() })
    }
}

impl ExportShown<'_> {
    fn whole(&self) -> String {
        self.0.parts.iter().map(|(_, text)| text.as_str()).collect()
    }
}

/// Where it was written.
#[derive(Debug)]
pub struct ExportWritten {
    /// What it proves.
    pub name: String,
    /// The files, with how many bytes each has.
    pub files: Vec<(PathBuf, usize)>,
}

/// The same as data.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum ExportWrittenData {
    /// One file.
    One {
        /// What it proves.
        name: String,
        /// The file.
        file: String,
        /// How long it is.
        bytes: usize,
    },
    /// The files that the other program reads.
    Several {
        /// What they prove.
        name: String,
        /// The files.
        files: Vec<String>,
        /// How long they are.
        bytes: Vec<usize>,
    },
}

impl Page for ExportWritten {
    type Data = ExportWrittenData;

    fn verdict(&self) -> Verdict {
        Verdict::Written
    }

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        let other = "he verdict is the other program's";
        for (file, bytes) in &self.files {
            let alone = if self.files.len() == 1 { format!("; t{other}") } else { String::new() };
            document.headline(self.verdict().word(), format!("{}: {bytes} bytes{alone}", file.display()));
        }
        if self.files.len() > 1 {
            document.line(0, format!("T{other}"));
        }
        Ok(document)
    }

    fn data(&self) -> Result<ExportWrittenData, Limit> {
        let name = self.name.clone();
        Ok(match self.files.as_slice() {
            [(file, bytes)] => {
                ExportWrittenData::One { name, file: file.display().to_string(), bytes: *bytes }
            }
            files => ExportWrittenData::Several {
                name,
                files: files.iter().map(|(file, _)| file.display().to_string()).collect(),
                bytes: files.iter().map(|(_, bytes)| *bytes).collect(),
            },
        })
    }
}
