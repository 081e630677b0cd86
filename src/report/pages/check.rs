//! `check` and `canonical`.

use prove_cap_kernel::command::verified;
use serde::Serialize;

use crate::commands::{Checked, Verdict};
use crate::document::Document;
use crate::exact::Limit;
use crate::report::json::{StatementData, statement};
use crate::report::page::Page;

/// What the checker says of a certificate.
#[derive(Debug)]
pub struct Checking<'a> {
    /// What it says.
    pub checked: &'a Checked,
    /// The certificate's file.
    pub certificate: &'a str,
}

/// The same as data.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum CheckedData {
    /// VERIFIED.
    Verified {
        /// The kind of claim.
        claim: &'static str,
        /// The sentence that is proved.
        theorem: String,
        /// Of which statement.
        statement: Box<StatementData>,
    },
    /// REJECTED.
    Rejected {
        /// What is wrong.
        reason: String,
    },
}

impl Page for Checking<'_> {
    type Data = CheckedData;

    fn verdict(&self) -> Verdict {
        self.checked.verdict()
    }

    /// The words of the checker alone.
    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        match &self.checked.0 {
            Ok(theorem) => document.source(0, verified(theorem)),
            Err(rejection) => {
                document.headline(self.verdict().word(), format!("{}: {rejection}", self.certificate));
            }
        }
        Ok(document)
    }

    fn data(&self) -> Result<CheckedData, Limit> {
        Ok(match &self.checked.0 {
            Ok(theorem) => CheckedData::Verified {
                claim: theorem.kind(),
                theorem: theorem.sentence(),
                statement: Box::new(statement(theorem.statement())),
            },
            Err(rejection) => CheckedData::Rejected { reason: rejection.to_string() },
        })
    }
}

/// A canonical text.
#[derive(Debug, Serialize)]
pub struct Canonical {
    /// The text.
    pub canonical: String,
}

impl Page for Canonical {
    type Data = Canonical;

    fn verdict(&self) -> Verdict {
        Verdict::Shown
    }

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        document.source(0, self.canonical.as_str());
        Ok(document)
    }

    fn data(&self) -> Result<Canonical, Limit> {
        Ok(Canonical { canonical: self.canonical.clone() })
    }
}
