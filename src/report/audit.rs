//! `prove-cap audit` for people.

use std::fmt::Write as _;

use super::attempt::{LINE, wrapped_at};
use super::expansion::superscript_of;
use super::headline::surface_equation;
use super::mathematics::Notation;
use super::stopped::cut_short;
use crate::audit::{
    Audit, Change, ClaimVerdict, Correction, Finding, Judgement, Phrase, Piece, Relation, Target, Verdict,
};
use crate::control::Interrupted;
use crate::exact::Polynomial;
use crate::formats::listing::Listing;
use crate::statement::Statement;

/// What a referee wants to read: the verdict, the table, each difference, each claim.
pub fn describe_audit(listing: &Listing, name: &str, statement: &Statement, audit: &Audit) -> String {
    let notation = Notation::new(statement.ring());
    let mut text = format!("{}\n\n", headline(audit));
    let source = if listing.source.is_empty() { String::new() } else { format!("{} of ", listing.source) };
    let _ = writeln!(text, "Listing       {source}{}", listing.title);
    let _ = writeln!(text, "Held against  {name}: {}", statement.title());
    let surface = surface_equation(statement);
    if !surface.is_empty() {
        let _ = writeln!(text, "Surface       {surface}");
    }
    text.push('\n');
    text += &table(&notation, audit);
    for finding in audit.findings.iter().filter(|finding| !finding.agrees()) {
        text.push('\n');
        text += &difference(&notation, finding);
    }
    if !audit.claims.is_empty() {
        text += "\nOther claims\n";
        for claim in &audit.claims {
            text += &claim_lines(&notation, claim);
        }
    }
    if let Some(why) = &audit.stopped {
        let _ = writeln!(text, "\n{}", stopped_text(audit, why));
    }
    text
}

/// What a stop left undone.
pub(super) fn stopped_text(audit: &Audit, why: &Interrupted) -> String {
    let judged = [audit.findings.len(), audit.claims.len()];
    let of = |k: usize, what: &str| match judged[k] == audit.printed[k] {
        true => format!("all {} {what}", judged[k]),
        false => format!("{} of {} {what}", judged[k], audit.printed[k]),
    };
    match judged == audit.printed {
        true => cut_short(why),
        false => format!("Stopped: {why}. Judged: {}, {}.", of(0, "printed coefficients"), of(1, "claims")),
    }
}

/// `DIFFERS  3 of 16 …`.
pub(super) fn headline(audit: &Audit) -> String {
    let wrong: Vec<&str> = audit.findings.iter().filter(|f| !f.agrees()).map(|f| f.label.as_str()).collect();
    let judged = [audit.findings.len(), audit.claims.len()];
    // "16", or "the first 3 of 16" where the work was stopped.
    let [all, all_claims] = [0, 1].map(|k| match judged[k] == audit.printed[k] {
        true => judged[k].to_string(),
        false => format!("the first {} of {}", judged[k], audit.printed[k]),
    });
    let listed = match (wrong.len(), audit.printed[0]) {
        (_, 0) if audit.printed[1] == 0 => match audit.equations {
            1 => "no coefficient is listed, and the one there is is zero".to_owned(),
            equations => format!("no coefficient is listed, and all {equations} are zero"),
        },
        (_, 0) => String::new(),
        (0, 1) => "the one printed coefficient is right".to_owned(),
        (0, printed) if judged[0] == printed => format!("all {all} printed coefficients are right"),
        (0, _) => format!("{all} printed coefficients are right"),
        (1, _) => format!("1 of {all} printed coefficients is wrong: {}", wrong[0]),
        (many, _) => format!("{many} of {all} printed coefficients are wrong: {}", wrong.join(", ")),
    };
    let failed = audit.claims.iter().filter(|claim| claim.judgement == Judgement::Fails).count();
    let open = audit.claims.iter().filter(|claim| claim.judgement == Judgement::NotChecked).count();
    let claims = match judged[1] {
        0 => String::new(),
        _ => {
            let open = if open > 0 { format!(", {open} not checked") } else { String::new() };
            let verb = if failed == 1 { "fails" } else { "fail" };
            let before = if listed.is_empty() { "" } else { "; " };
            format!("{before}{failed} of {all_claims} claims {verb}{open}")
        }
    };
    let stopped = match &audit.stopped {
        Some(why) if audit.verdict() == Verdict::Undecided => format!("; the audit was stopped: {why}"),
        _ => String::new(),
    };
    format!("{}  {listed}{claims}{stopped}", verdict_word(audit.verdict()))
}

/// The first word.
pub(super) fn verdict_word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Agrees => "AGREES",
        Verdict::Differs => "DIFFERS",
        Verdict::Undecided => "UNDECIDED",
    }
}

/// `u³v²`, `u(1−u)³ v²(1−v)²`, `f[3]`.
pub(super) fn target_text(target: Target) -> String {
    match target {
        Target::Monomial(i, j) => {
            let power = |name: &str, exponent: u32| match exponent {
                0 => String::new(),
                exponent => {
                    format!("{name}{}", if exponent == 1 { String::new() } else { superscript_of(exponent) })
                }
            };
            let text = power("u", i) + &power("v", j);
            if text.is_empty() { "1".into() } else { text }
        }
        Target::Bernstein(r, s) => format!("c[{r},{s}]"),
        Target::Equation(k) => format!("f[{k}]"),
    }
}

fn table(notation: &Notation, audit: &Audit) -> String {
    let mut text = String::new();
    let rows: Vec<[String; 3]> = audit
        .findings
        .iter()
        .map(|finding| {
            let verdict = if finding.agrees() { "AGREES" } else { "DIFFERS" };
            [finding.label.to_string(), target_text(finding.target), verdict.to_owned()]
        })
        .collect();
    let width = |k: usize| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0);
    let (first, second) = (width(0), width(1).max(2));
    for (row, finding) in rows.iter().zip(&audit.findings) {
        let pad = |text: &str, width: usize| format!("{text}{}", " ".repeat(width - text.chars().count()));
        let formula = match finding.agrees() {
            true => notation.shortened(&finding.truth, LINE),
            false => String::new(),
        };
        let line = format!("{}  {}  {:<7}  {formula}", pad(&row[0], first), pad(&row[1], second), row[2]);
        let _ = writeln!(text, "   {}", line.trim_end());
    }
    if !audit.unlisted.is_empty() {
        let names: Vec<String> = audit.unlisted.iter().take(12).map(|target| target_text(*target)).collect();
        let more = if audit.unlisted.len() > 12 { ", …" } else { "" };
        let _ = writeln!(text, "   Not listed, and not zero: {}{more}", names.join(", "));
    }
    text
}

fn difference(notation: &Notation, finding: &Finding) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}, the coefficient of {}, printed in line {}",
        finding.label,
        target_text(finding.target),
        finding.place.line
    );
    let cell = |polynomial: &Polynomial| notation.polynomial(polynomial);
    let mut rows: Vec<[String; 4]> =
        vec![["at".into(), "printed".into(), "true".into(), "true − printed".into()]];
    for d in &finding.differences {
        rows.push([cell(&d.powers), cell(&d.printed), cell(&d.truth), cell(&d.difference)]);
    }
    let width: [usize; 4] =
        std::array::from_fn(|k| rows.iter().map(|row| row[k].chars().count()).max().unwrap_or(0));
    for row in &rows {
        let cells = row.iter().zip(width);
        let padded: Vec<String> = cells
            .map(|(cell, width)| format!("{cell}{}", " ".repeat(width - cell.chars().count())))
            .collect();
        let _ = writeln!(text, "   {}", padded.join("   ").trim_end());
    }
    for relation in &finding.relations {
        let _ = writeln!(text, "   {}", phrase_text(notation, &relation_phrase(relation)));
    }
    for correction in &finding.corrections {
        let _ = writeln!(text, "   {}:", correction_text(correction));
        for line in correction.place.to_string().lines() {
            let _ = writeln!(text, "   {line}");
        }
    }
    if finding.corrections.is_empty() && !finding.searched {
        text += "   no explanation was found within the work that is spent on one\n";
    }
    if finding.corrections.is_empty() {
        for d in &finding.differences {
            if let Some(line) = term_text(notation, d) {
                let _ = writeln!(text, "   {line}");
            }
        }
    }
    text
}

/// What can be said of a power product that no single change explains.
pub(super) fn term_text(notation: &Notation, d: &crate::audit::Difference) -> Option<String> {
    let powers = notation.polynomial(&d.powers);
    match (d.printed.is_zero(), d.truth.is_zero()) {
        (true, _) => Some(format!("the term in {powers} is missing")),
        (_, true) => Some(format!("there should be no term in {powers}")),
        _ => None,
    }
}

/// A relation in words.
pub(super) fn relation_phrase(relation: &Relation) -> Phrase {
    match relation {
        Relation::Factor(factor) => {
            Phrase::words("what is printed is the true coefficient times ").formula(factor)
        }
        Relation::Exchanged => {
            Phrase::words("what is printed is the coefficient with the parameters u and v exchanged")
        }
        Relation::Other(label) => Phrase::words("what is printed belongs to ").label(label.as_str()),
    }
}

/// A correction in words.
pub(super) fn correction_text(correction: &Correction) -> String {
    let root = |n: &str| format!("√{n}");
    match &correction.change {
        Change::Sign { minus } => {
            let (printed, right) = if *minus { ("+", "−") } else { ("−", "+") };
            format!("the sign {printed} is printed where {right} would be right")
        }
        Change::Number { printed, right } => {
            format!("{printed} is printed where {} would be right", right.to_string().replace('-', "−"))
        }
        Change::Radicand { printed, right } => format!(
            "{} is printed where {} would be right",
            root(&printed.to_string()),
            root(&right.to_string())
        ),
        Change::MissingRoot { beside, root: n } => {
            format!("{beside} is printed where {beside}·√{n} would be right")
        }
        Change::SuperfluousRoot => "this root is printed where none would be right".to_owned(),
        Change::Exponent { printed, right } => {
            format!("the exponent {printed} is printed where {right} would be right")
        }
        Change::Name { printed, right } => format!("{printed} is printed where {right} would be right"),
    }
}

fn claim_lines(notation: &Notation, verdict: &ClaimVerdict) -> String {
    let judgement = judgement_word(verdict.judgement);
    let place = &verdict.claim.place;
    let mut text = format!("   {judgement:<11}  {place:<14} {}\n", verdict.claim.says);
    let indent = 33;
    for phrase in &verdict.evidence {
        text += &wrapped_at(&phrase_text(notation, phrase), indent);
        text.push('\n');
    }
    if !verdict.claim.remark.is_empty() {
        text += &wrapped_at(&format!("(remark: {})", verdict.claim.remark), indent);
        text.push('\n');
    }
    text
}

/// The judgement as it is printed.
pub(super) fn judgement_word(judgement: Judgement) -> &'static str {
    match judgement {
        Judgement::Holds => "HOLDS",
        Judgement::Fails => "FAILS",
        Judgement::NotChecked => "NOT CHECKED",
    }
}

/// A sentence for a terminal.
pub(super) fn phrase_text(notation: &Notation, phrase: &Phrase) -> String {
    let piece = |piece: &Piece| match piece {
        Piece::Words(words) => words.clone(),
        Piece::Formula(polynomial) => notation.polynomial(polynomial),
        Piece::Factor(polynomial) => notation.factor(polynomial),
        Piece::Label(label) => label.clone(),
    };
    phrase.0.iter().map(piece).collect()
}
