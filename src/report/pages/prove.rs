//! `prove`.

use serde::Serialize;

use crate::commands::{Proved, Verdict};
use crate::control::Control;
use crate::document::Document;
use crate::exact::Limit;
use crate::report::attempt::{Files, describe};
use crate::report::json::{self, AttemptData};
use crate::report::page::Page;

/// A proof, or why there is none.
#[derive(Debug)]
pub struct Proving<'a> {
    /// What came of it.
    pub proved: &'a Proved,
    /// What the statement was called.
    pub called: &'a str,
    /// Where statement and certificate were written.
    pub files: Option<Files>,
    /// What may cut the explanation short.
    pub control: &'a Control,
}

/// The same as data.
#[derive(Debug, Serialize)]
pub struct ProvingData(AttemptData);

impl Page for Proving<'_> {
    type Data = ProvingData;

    fn verdict(&self) -> Verdict {
        self.proved.verdict()
    }

    fn document(&self) -> Result<Document, Limit> {
        let Proved { source, problem, attempt, extended } = self.proved;
        let named = (source.name.as_str(), self.called);
        let files = self.files.as_ref();
        let mut document =
            describe(self.verdict(), named, problem, source.cap, attempt, files, self.control)?;
        if *extended {
            document.field("Extended", 13, format!("radicands = {:?}", source.statement.field().values()));
        }
        Ok(document)
    }

    fn data(&self) -> Result<ProvingData, Limit> {
        let Proved { source, problem, attempt, .. } = self.proved;
        let files = self.files.as_ref();
        json::attempt(&source.name, problem, attempt, files, self.control).map(ProvingData)
    }
}
