//! `degrees`: which bidegrees are exact, each answer with something that can be checked.

use super::construct::refused;
use super::{NoAnswer, Shape};
use crate::checker::CheckError;
use crate::construction::{
    Cell, Construction, Phase, Refusal, classify, closing_argument, closing_statement, construct,
};
use crate::control::Control;
use crate::proof::Proof;
use crate::statement::Statement;

/// The bidegrees from which degrees are raised.
const BASES: [(u32, u32); 3] = [(2, 2), (4, 2), (2, 4)];

/// Which bidegrees are exact, with what was computed and verified for it.
#[derive(Debug)]
pub struct Degrees {
    /// The polygon.
    pub shape: Shape,
    /// Whether its phase closes, which decides.
    pub phase: Phase,
    /// The largest degrees that are asked about.
    pub up_to: u32,
    /// That the phase does not close.
    pub closing: Option<Closing>,
    /// Exact patches, or such with an edge the longer way round.
    pub nets: Vec<((u32, u32), Construction)>,
}

/// The closing condition as a statement, and its refutation, which the checker has accepted.
#[derive(Debug)]
pub struct Closing {
    /// The text of the statement.
    pub text: String,
    /// The refutation.
    pub refutation: Proof,
}

/// Classifies the bidegrees, and makes what backs the classification.
///
/// # Errors
/// [`NoAnswer`], where something that backs it cannot be made.
pub fn degrees(shape: Shape, up_to: u32, control: &Control) -> Result<Degrees, NoAnswer> {
    let phase = Phase::of(&shape.polygon);
    let closing = (phase == Phase::Open).then(|| closing(&shape, control));
    let closing = closing.transpose().map_err(|refusal| refused(&shape, (2, 2), refusal))?;
    let mut nets = Vec::new();
    for base in BASES.into_iter().filter(|base| is_base(phase, *base) && base.0.max(base.1) <= up_to) {
        let made = construct(&shape.polygon, &shape.name, base, None, control);
        nets.push((base, made.map_err(|refusal| refused(&shape, base, refusal))?));
    }
    Ok(Degrees { shape, phase, up_to, closing, nets })
}

/// Whether a net of this bidegree backs the table.
fn is_base(phase: Phase, base: (u32, u32)) -> bool {
    match classify(phase, base) {
        Cell::Exact(from) => from == base,
        Cell::LongerWay => true,
        Cell::NoSurface | Cell::NoClosure => false,
    }
}

/// The statement that the phase closes, and its refutation.
fn closing(shape: &Shape, control: &Control) -> Result<Closing, Refusal> {
    let title = format!("Closing condition of the quadrilateral {}", shape.name);
    let text = closing_statement(&shape.polygon, &title);
    let statement = Statement::read(&text).map_err(CheckError::from)?;
    let argument = closing_argument(&shape.polygon).map_err(Refusal::Limit)?.ok_or(Refusal::NoneFound)?;
    Ok(Closing { text, refutation: Proof::of(&statement, argument, control)? })
}
