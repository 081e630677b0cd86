//! The same as data. Polynomials are strings in the canonical spelling of certificates: no number is rounded.

use serde::Serialize;

use super::attempt::Files;
use super::stopped::stopped_by;

use crate::algebra::{self, polynomial_to_exact};
use crate::bezier::Image;
use crate::certificate::{Argument, Step};
use crate::checker::{Claim, ExactNet, Solution, Theorem};
use crate::control::Control;
use crate::elimination::{Closure, Undecided, VALUES};
use crate::exact::{Limit, Polynomial};
use crate::expand::{Basis, Coefficient, ExpansionError, coefficients_of};
use crate::problem::Problem;
use crate::prove::{Attempt, Consistent, Reason, image_of};
use crate::statement::{HomogeneousPoint, Statement, Subject};

/// The convention of every net that is written: X, Y, Z, W, premultiplied.
pub(super) const CONVENTION: &str = "homogeneous";

/// The mathematical content of a statement.
#[derive(Debug, Serialize)]
pub struct StatementData {
    title: String,
    sha256: String,
    radicands: Vec<u32>,
    unknowns: Vec<String>,
    nonzero: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    bidegree: Option<(u32, u32)>,
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<String>,
    /// How the points of `net` are given.
    #[serde(skip_serializing_if = "Option::is_none")]
    convention: Option<&'static str>,
    /// Whether the file names it; otherwise it is the unit sphere.
    #[serde(skip_serializing_if = "Option::is_none")]
    surface_named: Option<bool>,
    /// Homogeneous points, premultiplied: `net[i]`[j] = [X, Y, Z, W].
    #[serde(skip_serializing_if = "Option::is_none")]
    net: Option<Vec<Vec<[String; 4]>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    polynomials: Option<Vec<String>>,
}

/// One coefficient of the surface condition.
#[derive(Debug, Serialize)]
pub struct CoefficientData {
    name: String,
    index: (u32, u32),
    value: String,
}

/// One step of a certificate.
#[derive(Debug, Serialize)]
struct StepData {
    premises: Vec<PremiseData>,
    conclusion: String,
}

#[derive(Debug, Serialize)]
struct PremiseData {
    premise: String,
    multiplier: String,
}

/// A value of an unknown.
#[derive(Debug, Serialize)]
pub(super) struct ValueData {
    unknown: String,
    value: String,
}

/// Values of all unknowns, exactly, in the canonical spelling.
pub(super) fn values_data(statement: &Statement, values: &[Polynomial]) -> Vec<ValueData> {
    let ring = statement.ring();
    let pairs = statement.unknowns().iter().zip(values);
    pairs.map(|(name, value)| ValueData { unknown: name.clone(), value: ring.spell(value) }).collect()
}

/// The outcome of an attempt.
#[derive(Debug, Serialize)]
pub struct AttemptData {
    /// `impossible`, `exact` or `solution`.
    #[serde(skip_serializing_if = "Option::is_none")]
    claim: Option<&'static str>,
    name: String,
    statement: StatementData,
    #[serde(skip_serializing_if = "Option::is_none")]
    bernstein: Option<Vec<CoefficientData>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    monomial: Option<Vec<CoefficientData>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    steps: Option<Vec<StepData>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    values: Option<Vec<ValueData>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    convention: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    net: Option<Vec<Vec<[String; 4]>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights_positive: Option<bool>,
    /// `surface`, `curve` or `point`: what the patch is.
    #[serde(skip_serializing_if = "Option::is_none")]
    image: Option<&'static str>,
    /// Where there are infinitely many zeros: the values that were chosen.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    chosen: Vec<ValueData>,
    /// Unknowns that occur in no equation.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    indifferent: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<ReasonData>,
    /// What stopped the work, if it was stopped.
    #[serde(skip_serializing_if = "Option::is_none")]
    stopped: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theorem: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    files: Option<FilesData>,
}

/// Where something was written.
#[derive(Debug, Serialize)]
pub(super) struct FilesData {
    statement: String,
    certificate: String,
}

impl FilesData {
    pub(super) fn of(files: &Files) -> Self {
        FilesData {
            statement: files.statement.display().to_string(),
            certificate: files.certificate.display().to_string(),
        }
    }
}

/// What the coordinates of finitely many zeros are roots of.
#[derive(Debug, Serialize)]
struct EliminantData {
    unknown: String,
    /// c₀, c₁, …: the coefficients of 1, x, x², ….
    coefficients: Vec<String>,
    real_roots: Option<usize>,
}

/// Values that were tried in vain.
#[derive(Debug, Serialize)]
struct TriedData {
    unknowns: Vec<String>,
    values: Vec<String>,
    choices: usize,
}

/// Why nothing was established.
#[derive(Debug, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
enum ReasonData {
    Consistent {
        dimension: usize,
        zeros: Option<usize>,
        verified: bool,
        basis: Vec<String>,
        eliminants: Vec<EliminantData>,
        /// Zeros in K that make the denominator W vanish identically.
        #[serde(skip_serializing_if = "Option::is_none")]
        zeros_without_patch: Option<usize>,
        /// Where there are infinitely many zeros: for which unknowns values were tried, and how many choices.
        #[serde(skip_serializing_if = "Option::is_none")]
        tried: Option<TriedData>,
        /// Radicands with which there is a zero.
        #[serde(skip_serializing_if = "Option::is_none")]
        exact_with_radicands: Option<Vec<u32>>,
    },
    TooLarge {
        degree: u32,
        rows: usize,
        columns: usize,
    },
    Interrupted {
        why: String,
        reached: Option<String>,
    },
    NoDenominator,
    Limited {
        limit: &'static str,
        at_most: u64,
        found: bool,
    },
}

/// A statement as data.
pub fn statement(statement: &Statement) -> StatementData {
    let ring = statement.ring();
    let spell = |polynomial: &Polynomial| ring.spell(polynomial);
    let (patch, polynomials) = match statement.subject() {
        Subject::Patch(patch) => (Some(patch), None),
        Subject::System(polynomials) => (None, Some(polynomials.iter().map(spell).collect())),
    };
    StatementData {
        title: statement.title().to_owned(),
        sha256: statement.hash(),
        radicands: statement.field().values().to_vec(),
        unknowns: statement.unknowns().to_vec(),
        nonzero: statement.nonzero().iter().map(spell).collect(),
        bidegree: patch.map(|patch| patch.bidegree),
        surface: patch.map(|patch| statement.coordinate_ring().spell(&patch.surface)),
        convention: patch.map(|_| CONVENTION),
        surface_named: patch.map(|_| statement.names_surface()),
        net: patch.map(|patch| net(statement, &patch.net)),
        polynomials,
    }
}

/// The points of a net in the canonical spelling.
pub(super) fn net(statement: &Statement, net: &[Vec<HomogeneousPoint>]) -> Vec<Vec<[String; 4]>> {
    let ring = statement.ring();
    let point = |point: &HomogeneousPoint| point.each_ref().map(|entry| ring.spell(entry));
    net.iter().map(|row| row.iter().map(point).collect()).collect()
}

/// Those that are not zero, spelled.
pub(super) fn listed(statement: &Statement, list: Vec<Coefficient>) -> Vec<CoefficientData> {
    let ring = statement.ring();
    let nonzero = list.into_iter().filter(|coefficient| !coefficient.value.is_zero());
    let entry =
        |c: Coefficient| CoefficientData { value: ring.spell(&c.value), name: c.name, index: c.index };
    nonzero.map(entry).collect()
}

/// The same beside an attempt: none where there is no time left for them.
fn expansion_within(
    problem: &Problem,
    basis: Basis,
    control: &Control,
) -> Result<Option<Vec<CoefficientData>>, Limit> {
    match coefficients_of(problem, basis, control) {
        Ok(list) => Ok(list.map(|list| listed(problem.statement(), list))),
        Err(ExpansionError::Interrupted(_)) => Ok(None),
        Err(ExpansionError::Limit(limit)) => Err(limit),
    }
}

/// An attempt as data.
///
/// # Errors
/// Where a coefficient exceeds what the formats allow.
pub fn attempt(
    name: &str,
    problem: &Problem,
    attempt: &Attempt,
    files: Option<&Files>,
    control: &Control,
) -> Result<AttemptData, Limit> {
    let of = problem.statement();
    let of_basis = |basis| expansion_within(problem, basis, control);
    let (bernstein, monomial) = (of_basis(Basis::Bernstein)?, of_basis(Basis::Monomial)?);
    let mut data = AttemptData {
        claim: None,
        name: name.to_owned(),
        statement: statement(of),
        bernstein,
        monomial,
        steps: None,
        values: None,
        convention: None,
        net: None,
        weights_positive: None,
        image: None,
        chosen: Vec::new(),
        indifferent: Vec::new(),
        reason: None,
        stopped: None,
        theorem: None,
        files: files.map(FilesData::of),
    };
    match attempt {
        Attempt::Undecided(why) => {
            data.reason = Some(reason(of, why)?);
            if let Reason::Elimination(Undecided::Interrupted(stopped)) = why {
                data.stopped = Some(stopped_by(stopped.why));
            }
        }
        Attempt::Proved { proof, freedom } => {
            let theorem = proof.theorem();
            data.claim = Some(theorem.kind());
            data.theorem = Some(theorem.sentence());
            if let Argument::Impossible(steps) = &proof.certificate().argument {
                data.steps = Some(steps.iter().map(|step| step_data(of, step)).collect());
            }
            solution(&mut data, theorem);
            let unknown = |k: usize| of.unknowns().get(k).cloned();
            data.indifferent = freedom.indifferent.iter().filter_map(|&k| unknown(k)).collect();
            for (k, value) in &freedom.chosen {
                let Some(unknown) = unknown(*k) else { continue };
                let constant = polynomial_to_exact(&algebra::Polynomial::constant(value.clone()))?;
                data.chosen.push(ValueData { unknown, value: of.ring().spell(&constant) });
            }
        }
    }
    Ok(data)
}

fn solution(data: &mut AttemptData, theorem: &Theorem) {
    let statement = theorem.statement();
    let named = |values: &[Polynomial]| Some(values_data(statement, values));
    match theorem.claim() {
        Claim::Exact(ExactNet { values, net: points, weights_positive }) => {
            data.values = named(values);
            data.convention = Some(CONVENTION);
            data.net = Some(net(statement, points));
            data.weights_positive = Some(*weights_positive);
            data.image = Some(match image_of(statement, points) {
                Image::Surface => "surface",
                Image::Curve => "curve",
                Image::Point => "point",
            });
        }
        Claim::Solution(Solution { values }) => data.values = named(values),
        _ => {}
    }
}

fn step_data(statement: &Statement, step: &Step) -> StepData {
    let ring = statement.ring();
    let premise = |(premise, multiplier): &(crate::certificate::Premise, Polynomial)| PremiseData {
        premise: premise.to_string(),
        multiplier: ring.spell(multiplier),
    };
    StepData {
        premises: step.combination.iter().map(premise).collect(),
        conclusion: ring.spell(&step.conclusion),
    }
}

fn reason(statement: &Statement, reason: &Reason) -> Result<ReasonData, Limit> {
    Ok(match reason {
        Reason::NoDenominator => ReasonData::NoDenominator,
        Reason::Limited { limit, found } => {
            ReasonData::Limited { limit: limit.what, at_most: limit.at_most, found: *found }
        }
        Reason::Elimination(Undecided::TooLarge { degree, matrix: (rows, columns) }) => {
            ReasonData::TooLarge { degree: *degree, rows: *rows, columns: *columns }
        }
        Reason::Elimination(Undecided::Interrupted(stopped)) => {
            ReasonData::Interrupted { why: stopped.to_string(), reached: stopped.reached.clone() }
        }
        Reason::Consistent(consistent) => {
            let Consistent { closure, without_patch, tried, extension } = consistent.as_ref();
            let tried = tried.as_ref().map(|tried| {
                let name = |&k: &u16| statement.unknowns().get(usize::from(k)).cloned();
                TriedData {
                    unknowns: tried.unknowns.iter().filter_map(name).collect(),
                    values: VALUES.iter().map(|(above, below)| fraction(*above, *below)).collect(),
                    choices: tried.choices,
                }
            });
            let radicands = extension.as_ref().map(|extension| extension.radicands.clone());
            consistent_data(statement, (closure, *without_patch), tried, radicands)?
        }
        Reason::Elimination(Undecided::Consistent(closure)) => {
            consistent_data(statement, (closure, 0), None, None)?
        }
    })
}

fn fraction(above: i64, below: u32) -> String {
    if below == 1 { above.to_string() } else { format!("{above}/{below}") }
}

fn consistent_data(
    statement: &Statement,
    (closure, without_patch): (&Closure, usize),
    tried: Option<TriedData>,
    exact_with_radicands: Option<Vec<u32>>,
) -> Result<ReasonData, Limit> {
    let mut basis = Vec::new();
    for polynomial in closure.linear.iter().chain(&closure.basis) {
        basis.push(statement.ring().spell(&polynomial_to_exact(polynomial)?));
    }
    let mut eliminants = Vec::new();
    for eliminant in &closure.eliminants {
        let Some(unknown) = statement.unknowns().get(usize::from(eliminant.variable)) else { continue };
        let mut coefficients = Vec::new();
        for c in eliminant.polynomial.coefficients() {
            let constant = polynomial_to_exact(&algebra::Polynomial::constant(c.clone()))?;
            coefficients.push(statement.ring().spell(&constant));
        }
        let real_roots = eliminant.real_roots;
        eliminants.push(EliminantData { unknown: unknown.clone(), coefficients, real_roots });
    }
    Ok(ReasonData::Consistent {
        dimension: closure.dimension,
        zeros: closure.zeros,
        verified: closure.verified,
        basis,
        eliminants,
        zeros_without_patch: Some(without_patch).filter(|count| *count > 0),
        tried,
        exact_with_radicands,
    })
}
