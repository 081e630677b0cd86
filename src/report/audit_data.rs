//! `prove-cap audit` as data. The schema is described in `docs/listings.md`.

use serde::Serialize;

use super::json::{StatementData, statement as statement_data};
use super::mathematics::Notation;
use super::stopped::stopped_by;
use super::text::phrase_text;
use crate::audit::{Audit, Change, Correction, Finding, Judgement, Relation, Target};
use crate::exact::{Polynomial, Ring};
use crate::formats::listing::Listing;
use crate::statement::Statement;

/// An audit.
#[derive(Debug, Serialize)]
pub struct AuditData {
    #[serde(skip_serializing_if = "Option::is_none")]
    stopped: Option<&'static str>,
    title: String,
    source: String,
    name: String,
    statement: StatementData,
    coefficients: Vec<FindingData>,
    unlisted: Vec<TargetData>,
    claims: Vec<ClaimData>,
}

#[derive(Debug, Serialize)]
struct TargetData {
    basis: &'static str,
    index: Vec<u32>,
}

#[derive(Debug, Serialize)]
struct FindingData {
    label: String,
    line: usize,
    column: usize,
    #[serde(flatten)]
    target: TargetData,
    agrees: bool,
    printed: String,
    #[serde(rename = "true")]
    truth: String,
    differences: Vec<DifferenceData>,
    relations: Vec<RelationData>,
    corrections: Vec<CorrectionData>,
}

#[derive(Debug, Serialize)]
struct DifferenceData {
    powers: String,
    printed: String,
    #[serde(rename = "true")]
    truth: String,
    difference: String,
}

#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum RelationData {
    Factor { factor: String },
    Exchanged,
    Other { label: String },
}

#[derive(Debug, Serialize)]
struct CorrectionData {
    line: usize,
    column: usize,
    width: usize,
    kind: &'static str,
    printed: String,
    right: String,
}

#[derive(Debug, Serialize)]
struct ClaimData {
    #[serde(rename = "where")]
    place: String,
    says: String,
    judgement: &'static str,
    evidence: Vec<String>,
    #[serde(skip_serializing_if = "String::is_empty")]
    remark: String,
}

/// An audit as data.
pub(super) fn audit(listing: &Listing, name: &str, statement: &Statement, audit: &Audit) -> AuditData {
    let ring = statement.ring();
    let notation = Notation::new(ring.clone());
    let claims = audit.claims.iter().map(|verdict| ClaimData {
        place: verdict.claim.place.clone(),
        says: verdict.claim.says.clone(),
        judgement: match verdict.judgement {
            Judgement::Holds => "holds",
            Judgement::Fails => "fails",
            Judgement::NotChecked => "not_checked",
        },
        evidence: verdict.evidence.iter().map(|phrase| phrase_text(&notation, phrase)).collect(),
        remark: verdict.claim.remark.clone(),
    });
    AuditData {
        stopped: audit.stopped.as_ref().map(|stopped| stopped_by(stopped.why)),
        title: listing.title.clone(),
        source: listing.source.clone(),
        name: name.to_owned(),
        statement: statement_data(statement),
        coefficients: audit.findings.iter().map(|found| finding(&ring, found)).collect(),
        unlisted: audit.unlisted.iter().map(|&missing| target(missing)).collect(),
        claims: claims.collect(),
    }
}

fn target(target: Target) -> TargetData {
    match target {
        Target::Monomial(i, j) => TargetData { basis: "monomial", index: vec![i, j] },
        Target::Bernstein(r, s) => TargetData { basis: "bernstein", index: vec![r, s] },
        Target::Equation(k) => TargetData { basis: "equation", index: vec![k] },
    }
}

fn finding(ring: &Ring, finding: &Finding) -> FindingData {
    let spell = |polynomial: &Polynomial| ring.spell(polynomial);
    let differences = finding.differences.iter().map(|d| DifferenceData {
        powers: spell(&d.powers),
        printed: spell(&d.printed),
        truth: spell(&d.truth),
        difference: spell(&d.difference),
    });
    let relations = finding.relations.iter().map(|relation| match relation {
        Relation::Factor(factor) => RelationData::Factor { factor: spell(factor) },
        Relation::Exchanged => RelationData::Exchanged,
        Relation::Other(label) => RelationData::Other { label: label.to_string() },
    });
    FindingData {
        label: finding.label.to_string(),
        line: finding.place.line,
        column: finding.place.column,
        target: target(finding.target),
        agrees: finding.agrees(),
        printed: spell(&finding.printed),
        truth: spell(&finding.truth),
        differences: differences.collect(),
        relations: relations.collect(),
        corrections: finding.corrections.iter().map(correction).collect(),
    }
}

fn correction(correction: &Correction) -> CorrectionData {
    let sign = |minus: bool| if minus { "-" } else { "+" }.to_owned();
    let (kind, printed, right) = match &correction.change {
        Change::Sign { minus } => ("sign", sign(!minus), sign(*minus)),
        Change::Number { printed, right } => ("number", printed.to_string(), right.to_string()),
        Change::Radicand { printed, right } => ("radicand", printed.to_string(), right.to_string()),
        Change::MissingRoot { beside, root } => {
            ("missing_root", beside.to_string(), format!("{beside}*sqrt({root})"))
        }
        Change::SuperfluousRoot => ("superfluous_root", "sqrt".to_owned(), String::new()),
        Change::Exponent { printed, right } => ("exponent", printed.to_string(), right.to_string()),
        Change::Name { printed, right } => ("name", printed.to_string(), right.to_string()),
    };
    let place = &correction.place;
    CorrectionData { line: place.line, column: place.column, width: place.width, kind, printed, right }
}
