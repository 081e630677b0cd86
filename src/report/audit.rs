//! `prove-cap audit` for people.

use super::expansion::superscript_of;
use super::headline::surface_equation;
use super::mathematics::Notation;
use super::stopped::cut_short;
use crate::audit::{Audit, Change, ClaimVerdict, Correction, Finding, Judgement, Relation, Target, Verdict};
use crate::commands::{AuditedListing, Source};
use crate::control::Interrupted;
use crate::document::{Block, Column, Document, Item, Listed, Phrase, Table};

/// Where what stands behind a name begins.
const NAMED: usize = 14;

/// What a referee wants to read: the verdict, the table, each difference, each claim.
pub(super) fn describe_audit(audited: &AuditedListing) -> Document {
    let AuditedListing { listing, source: Source { name, statement, .. }, audit } = audited;
    let notation = Notation::new(statement.ring());
    let mut document = Document::new(statement.ring());
    document.headline(audited.verdict().word(), headline(audit));
    document.gap();
    let source = if listing.source.is_empty() { String::new() } else { format!("{} of ", listing.source) };
    document.field("Listing", NAMED, format!("{source}{}", listing.title));
    document.field("Held against", NAMED, format!("{name}: {}", statement.title()));
    let surface = surface_equation(statement);
    if !surface.is_empty() {
        document.field("Surface", NAMED, surface);
    }
    document.gap();
    listed(&mut document, audit);
    for finding in audit.findings.iter().filter(|finding| !finding.agrees()) {
        document.gap();
        difference(&mut document, &notation, finding);
    }
    if !audit.claims.is_empty() {
        document.gap();
        document.heading("Other claims");
        for verdict in &audit.claims {
            document.push(Block::Item(claim(verdict)));
        }
    }
    if let Some(why) = &audit.stopped {
        document.gap();
        document.line(0, stopped_text(audit, why));
    }
    document
}

/// What a stop left undone.
fn stopped_text(audit: &Audit, why: &Interrupted) -> String {
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

/// `3 of 16 printed coefficients are wrong: …`.
fn headline(audit: &Audit) -> String {
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
    format!("{listed}{claims}{stopped}")
}

/// `u³v²`, `u(1−u)³ v²(1−v)²`, `f[3]`.
fn target_text(target: Target) -> String {
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

fn listed(document: &mut Document, audit: &Audit) {
    let rows = audit.findings.iter().map(|finding| Listed {
        label: finding.label.to_string(),
        of: target_text(finding.target),
        agrees: finding.agrees(),
        truth: finding.truth.clone(),
    });
    document.push(Block::Listed(rows.collect()));
    if !audit.unlisted.is_empty() {
        let names: Vec<String> = audit.unlisted.iter().take(12).map(|target| target_text(*target)).collect();
        let more = if audit.unlisted.len() > 12 { ", …" } else { "" };
        document.line(3, format!("Not listed, and not zero: {}{more}", names.join(", ")));
    }
}

fn difference(document: &mut Document, notation: &Notation, finding: &Finding) {
    document.heading(Phrase::default().label(finding.label.as_str()).and(format!(
        ", the coefficient of {}, printed in line {}",
        target_text(finding.target),
        finding.place.line
    )));
    let mut table = Table::new(3, [Column::left(3); 4]).headed(["at", "printed", "true", "true − printed"]);
    for d in &finding.differences {
        let cells = [&d.powers, &d.printed, &d.truth, &d.difference];
        table.row(cells.map(|polynomial| Phrase::default().formula(polynomial)));
    }
    document.push(Block::Table(table));
    for relation in &finding.relations {
        document.line(3, relation_phrase(relation));
    }
    for correction in &finding.corrections {
        document.line(3, format!("{}:", correction_text(correction)));
        document.source(3, correction.place.to_string());
    }
    if finding.corrections.is_empty() && !finding.searched {
        document.line(3, "no explanation was found within the work that is spent on one");
    }
    if finding.corrections.is_empty() {
        for line in finding.differences.iter().filter_map(|d| term_text(notation, d)) {
            document.line(3, line);
        }
    }
}

/// What can be said of a power product that no single change explains.
fn term_text(notation: &Notation, d: &crate::audit::Difference) -> Option<String> {
    let powers = notation.polynomial(&d.powers);
    match (d.printed.is_zero(), d.truth.is_zero()) {
        (true, _) => Some(format!("the term in {powers} is missing")),
        (_, true) => Some(format!("there should be no term in {powers}")),
        _ => None,
    }
}

/// A relation in words.
fn relation_phrase(relation: &Relation) -> Phrase {
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
fn correction_text(correction: &Correction) -> String {
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

fn claim(verdict: &ClaimVerdict) -> Item {
    let mut evidence = verdict.evidence.clone();
    if !verdict.claim.remark.is_empty() {
        evidence.push(format!("(remark: {})", verdict.claim.remark).into());
    }
    Item {
        mark: judgement_word(verdict.judgement),
        place: verdict.claim.place.clone(),
        says: verdict.claim.says.clone(),
        evidence,
    }
}

/// The judgement as it is printed.
fn judgement_word(judgement: Judgement) -> &'static str {
    match judgement {
        Judgement::Holds => "HOLDS",
        Judgement::Fails => "FAILS",
        Judgement::NotChecked => "NOT CHECKED",
    }
}
