//! Verdicts: the first word of an answer, and the exit status that says the same to a shell.

use std::fmt;

use serde::{Serialize, Serializer};

/// What a command comes to. One word may stand for several: the rest of its line says which.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// `check`: the certificate proves its claim.
    Verified,
    /// `prove`: no values of the unknowns will do.
    Impossible,
    /// `prove`, `construct`: there is one, and here it is.
    Exact,
    /// `bound`, `approximate`: the quantity stays between two decimals.
    Enclosed,
    /// `degrees`: which bidegrees are exact.
    Classified,
    /// `audit`, `bound --claim`: what is printed is right.
    Agrees,
    /// `export -o`: a file was written, and nothing is claimed.
    Written,
    /// Something was computed and is shown, and there is no verdict on anything.
    Shown,
    /// The certificate is wrong.
    Rejected,
    /// What is printed is wrong.
    Differs,
    /// The command could not be carried out.
    Failed,
    /// None of these.
    Undecided,
    /// `construct`: that there is nothing to construct.
    Nonexistent,
}

impl Verdict {
    /// All of them, in the order of their table: by exit status.
    pub const ALL: [Verdict; 13] = [
        Verdict::Verified,
        Verdict::Impossible,
        Verdict::Exact,
        Verdict::Enclosed,
        Verdict::Classified,
        Verdict::Agrees,
        Verdict::Written,
        Verdict::Shown,
        Verdict::Rejected,
        Verdict::Differs,
        Verdict::Failed,
        Verdict::Undecided,
        Verdict::Nonexistent,
    ];

    /// The first word of the answer; none where there is no verdict.
    pub fn word(self) -> Option<&'static str> {
        Some(match self {
            Verdict::Verified => "VERIFIED",
            Verdict::Impossible | Verdict::Enclosed | Verdict::Classified | Verdict::Nonexistent => "PROVED",
            Verdict::Exact => "EXACT",
            Verdict::Agrees => "AGREES",
            Verdict::Written => "WRITTEN",
            Verdict::Shown => return None,
            Verdict::Rejected => "REJECTED",
            Verdict::Differs => "DIFFERS",
            Verdict::Failed => "ERROR",
            Verdict::Undecided => "UNDECIDED",
        })
    }

    /// The exit status: 0 for what was asked, another number for each way in which there is none of it.
    pub fn status(self) -> u8 {
        match self {
            Verdict::Verified
            | Verdict::Impossible
            | Verdict::Exact
            | Verdict::Enclosed
            | Verdict::Classified
            | Verdict::Agrees
            | Verdict::Written
            | Verdict::Shown => 0,
            Verdict::Rejected | Verdict::Differs => 1,
            Verdict::Failed => 2,
            Verdict::Undecided => 3,
            Verdict::Nonexistent => 4,
        }
    }

    /// By which commands it is said, and what it means.
    pub fn meaning(self) -> (&'static str, &'static str) {
        match self {
            Verdict::Verified => ("`check`", "the certificate proves its claim of this statement"),
            Verdict::Impossible => (
                "`prove`",
                "impossible: no values of the unknowns will do, with a certificate that was checked",
            ),
            Verdict::Exact => (
                "`prove`, `construct`",
                "there is one, and it is printed: the values, the net, with a certificate that was checked",
            ),
            Verdict::Enclosed => (
                "`bound`, `approximate`",
                "the quantity stays between two decimals on the whole patch, with a certificate that was checked",
            ),
            Verdict::Classified => (
                "`degrees`",
                "which bidegrees are exact: lemmas on paper, and certificates that were checked",
            ),
            Verdict::Agrees => ("`audit`, `bound --claim`", "all that is printed there is right"),
            Verdict::Written => ("`export -o`", "the files are written; the verdict is the other program's"),
            Verdict::Shown => (
                "`expand`, `canonical`, `list`, `table`, `export`",
                "what was asked for is shown, without a verdict",
            ),
            Verdict::Rejected => ("`check`, `export`", "the certificate is wrong, and where"),
            Verdict::Differs => (
                "`audit`, `bound --claim`",
                "what is printed (formulas, claims, a net, an interval) is wrong, and where",
            ),
            Verdict::Failed => ("all", "usage, or a file that cannot be read or written"),
            Verdict::Undecided => ("all that search", "none of these; what was found is said"),
            Verdict::Nonexistent => (
                "`construct`",
                "there is none: no patch of this bidegree covers the polygon, by lemmas on paper",
            ),
        }
    }

    /// The table of them all, in Markdown.
    pub fn table() -> String {
        let mut text = "| exit | first word | said by | meaning |\n|---|---|---|---|\n".to_owned();
        for verdict in Verdict::ALL {
            let (commands, meaning) = verdict.meaning();
            let word = verdict.word().unwrap_or("(none)");
            text += &format!("| {} | {word} | {commands} | {meaning} |\n", verdict.status());
        }
        text
    }

    /// All exit statuses with their first words, on one line.
    pub fn summary() -> String {
        let mut statuses: Vec<(u8, Vec<&str>)> = Vec::new();
        for verdict in Verdict::ALL {
            let Some(word) = verdict.word() else { continue };
            match statuses.last_mut() {
                Some((status, words)) if *status == verdict.status() => {
                    if !words.contains(&word) {
                        words.push(word);
                    }
                }
                _ => statuses.push((verdict.status(), vec![word])),
            }
        }
        let spelled: Vec<String> =
            statuses.iter().map(|(status, words)| format!("{status} {}", words.join(", "))).collect();
        format!("Exit status and first word: {} that there is none.", spelled.join("; "))
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word().unwrap_or_default())
    }
}

impl Serialize for Verdict {
    /// The first word, or null.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.word().serialize(serializer)
    }
}

impl From<crate::audit::Verdict> for Verdict {
    fn from(verdict: crate::audit::Verdict) -> Self {
        match verdict {
            crate::audit::Verdict::Agrees => Verdict::Agrees,
            crate::audit::Verdict::Differs => Verdict::Differs,
            crate::audit::Verdict::Undecided => Verdict::Undecided,
        }
    }
}
