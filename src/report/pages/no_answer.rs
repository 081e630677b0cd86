//! ERROR, REJECTED, UNDECIDED, and that there is none.

use serde::Serialize;

use crate::commands::{Failure, Location, NoAnswer, Nonexistent, Rejected, Undecided, Verdict};
use crate::control::Interrupted;
use crate::document::Document;
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::construction::{impossible, impossible_headline};
use crate::report::degrees::ArgumentData;
use crate::report::headline::surface_equation;
use crate::report::json::FilesData;
use crate::report::page::Page;
use crate::report::stopped::{BestSoFarData, best_so_far, stopped_by};

/// Each kind has its members.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub enum NoAnswerData {
    /// REJECTED.
    Rejected(RejectedData),
    /// ERROR.
    Failed(FailedData),
    /// UNDECIDED.
    Undecided(Box<UndecidedData>),
    /// PROVED that there is none.
    Nonexistent(NonexistentData),
}

impl Page for NoAnswer {
    type Data = NoAnswerData;

    fn verdict(&self) -> Verdict {
        NoAnswer::verdict(self)
    }

    fn document(&self) -> Result<Document, Limit> {
        match self {
            NoAnswer::Rejected(rejected) => rejected.document(),
            NoAnswer::Failed(failure) => failure.document(),
            NoAnswer::Undecided(undecided) => undecided.document(),
            NoAnswer::Nonexistent(nonexistent) => nonexistent.document(),
        }
    }

    fn data(&self) -> Result<NoAnswerData, Limit> {
        Ok(match self {
            NoAnswer::Rejected(rejected) => NoAnswerData::Rejected(rejected.data()?),
            NoAnswer::Failed(failure) => NoAnswerData::Failed(failure.data()?),
            NoAnswer::Undecided(undecided) => NoAnswerData::Undecided(Box::new(undecided.data()?)),
            NoAnswer::Nonexistent(nonexistent) => NoAnswerData::Nonexistent(nonexistent.data()?),
        })
    }
}

/// What is wrong, and where.
#[derive(Debug, Serialize)]
pub struct FailedData {
    reason: String,
    #[serde(flatten)]
    at: Location,
}

impl Page for Failure {
    type Data = FailedData;

    fn verdict(&self) -> Verdict {
        Verdict::Failed
    }

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        document.headline(Verdict::Failed.word(), self.message());
        Ok(document)
    }

    fn data(&self) -> Result<FailedData, Limit> {
        Ok(FailedData { reason: self.message().to_owned(), at: self.location().clone() })
    }
}

/// What the checker has against a certificate.
#[derive(Debug, Serialize)]
pub struct RejectedData {
    name: String,
    file: String,
    reason: String,
}

impl Page for Rejected {
    type Data = RejectedData;

    fn verdict(&self) -> Verdict {
        Verdict::Rejected
    }

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        document.headline(self.verdict().word(), format!("{}: {}", self.file, self.rejection));
        document.line(0, "Nothing is exported; --unchecked does it all the same.");
        Ok(document)
    }

    fn data(&self) -> Result<RejectedData, Limit> {
        Ok(RejectedData {
            name: self.name.clone(),
            file: self.file.clone(),
            reason: self.rejection.to_string(),
        })
    }
}

/// Why nothing was decided.
#[derive(Debug, Serialize)]
pub struct UndecidedData {
    name: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    bidegree: Option<(u32, u32)>,
    reason: String,
    stopped: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    best_found: Option<BestSoFarData>,
    #[serde(skip_serializing_if = "Option::is_none")]
    files: Option<FilesData>,
}

impl Page for Undecided {
    type Data = UndecidedData;

    fn verdict(&self) -> Verdict {
        Verdict::Undecided
    }

    fn document(&self) -> Result<Document, Limit> {
        let name = if self.named { format!("{}: ", self.name) } else { String::new() };
        let mut document = Document::of_words();
        document.headline(self.verdict().word(), format!("{name}{}", self.reason));
        if let Some(patch) = &self.patch {
            document.line(0, format!("Surface: {}", surface_equation(patch)));
        }
        if let Some((statement, best)) = &self.best {
            document.gap();
            best_so_far(&mut document, statement, best);
        }
        Ok(document)
    }

    fn data(&self) -> Result<UndecidedData, Limit> {
        Ok(UndecidedData {
            name: self.name.clone(),
            bidegree: self.bidegree,
            reason: self.reason.clone(),
            stopped: self.stopped.as_ref().map(|stopped| stopped_by(stopped.why)),
            best_found: self.best.as_ref().map(|(statement, best)| BestSoFarData::of(statement, best)),
            files: None,
        })
    }
}

/// Files were written, and the work was stopped while the checker read them.
#[derive(Debug)]
pub struct Unchecked {
    /// What they are about.
    pub name: String,
    /// What stopped the work.
    pub why: Interrupted,
    /// The files.
    pub files: Files,
}

impl Unchecked {
    fn reason(&self) -> String {
        format!("an argument was found and written, but its check was stopped: {}", self.why)
    }
}

impl Page for Unchecked {
    type Data = UndecidedData;

    fn verdict(&self) -> Verdict {
        Verdict::Undecided
    }

    fn document(&self) -> Result<Document, Limit> {
        let mut document = Document::of_words();
        document.headline(self.verdict().word(), format!("{}: {}", self.name, self.reason()));
        document.gap();
        let [statement, certificate] =
            [&self.files.statement, &self.files.certificate].map(|file| file.display());
        document.line(0, format!("To go on: prove-cap check {statement} {certificate}"));
        Ok(document)
    }

    fn data(&self) -> Result<UndecidedData, Limit> {
        let stopped = Undecided::stopped(&self.name, self.why.clone());
        let files = Some(FilesData::of(&self.files));
        Ok(UndecidedData { reason: self.reason(), files, ..stopped.data()? })
    }
}

/// By which lemma there is no patch.
#[derive(Debug, Serialize)]
pub struct NonexistentData {
    name: String,
    bidegree: (u32, u32),
    reason: String,
    #[serde(flatten)]
    argument: ArgumentData,
}

impl Page for Nonexistent {
    type Data = NonexistentData;

    fn verdict(&self) -> Verdict {
        Verdict::Nonexistent
    }

    fn document(&self) -> Result<Document, Limit> {
        Ok(impossible(self))
    }

    fn data(&self) -> Result<NonexistentData, Limit> {
        Ok(NonexistentData {
            name: self.name.clone(),
            bidegree: self.bidegree,
            reason: impossible_headline(self.bidegree),
            argument: ArgumentData::of(&self.polygon, self.bidegree, self.cell)?,
        })
    }
}
