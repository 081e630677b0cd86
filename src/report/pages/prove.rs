//! `prove`.

use serde::Serialize;

use crate::commands::{Proved, Verdict};
use crate::control::Control;
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

    fn text(&self) -> Result<String, Limit> {
        let Proved { source, problem, attempt, extended } = self.proved;
        let named = (source.name.as_str(), self.called);
        let files = self.files.as_ref();
        let mut text = describe(named, problem, source.cap, attempt, files, self.control)?;
        if *extended {
            text += &format!("Extended     radicands = {:?}\n", source.statement.field().values());
        }
        Ok(text)
    }

    fn data(&self) -> Result<ProvingData, Limit> {
        let Proved { source, problem, attempt, .. } = self.proved;
        let files = self.files.as_ref();
        json::attempt(&source.name, problem, attempt, files, self.control).map(ProvingData)
    }
}
