//! ERROR, REJECTED, UNDECIDED, and that there is none.

use serde::Serialize;

use crate::commands::{Failure, Location, NoAnswer, Nonexistent, Rejected, Undecided, Verdict};
use crate::control::Interrupted;
use crate::exact::Limit;
use crate::report::attempt::Files;
use crate::report::construction::{impossible_headline, impossible_text};
use crate::report::degrees::ArgumentData;
use crate::report::headline::surface_equation;
use crate::report::json::FilesData;
use crate::report::page::Page;
use crate::report::stopped::{BestSoFarData, best_so_far_text, stopped_by};

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

    fn text(&self) -> Result<String, Limit> {
        match self {
            NoAnswer::Rejected(rejected) => rejected.text(),
            NoAnswer::Failed(failure) => failure.text(),
            NoAnswer::Undecided(undecided) => undecided.text(),
            NoAnswer::Nonexistent(nonexistent) => nonexistent.text(),
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

    fn text(&self) -> Result<String, Limit> {
        Ok(format!("ERROR: {}\n", self.message()))
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

    fn text(&self) -> Result<String, Limit> {
        Ok(format!(
            "{}  {}: {}\nNothing is exported; --unchecked does it all the same.\n",
            self.verdict(),
            self.file,
            self.rejection
        ))
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

    fn text(&self) -> Result<String, Limit> {
        let name = if self.named { format!("{}: ", self.name) } else { String::new() };
        let best = self.best.as_ref().map(|(statement, best)| best_so_far_text(statement, best));
        let best = best.map_or_else(String::new, |best| format!("\n{best}"));
        let surface = self.patch.as_ref().map(|patch| format!("Surface: {}\n", surface_equation(patch)));
        Ok(format!("{}  {name}{}\n{}{best}", self.verdict(), self.reason, surface.unwrap_or_default()))
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

    fn text(&self) -> Result<String, Limit> {
        Ok(format!(
            "{}  {}: {}\n\nTo go on: prove-cap check {} {}\n",
            self.verdict(),
            self.name,
            self.reason(),
            self.files.statement.display(),
            self.files.certificate.display()
        ))
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

    fn text(&self) -> Result<String, Limit> {
        Ok(impossible_text(self))
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
