//! Lengths, points and weights of the cap over the cube face, derived from the geometry.

use std::collections::BTreeMap;

use super::{Claimed, Judged, Judgement};
use crate::algebra::{FieldElement, Polynomial, polynomial_to_exact};
use crate::audit::AuditError;
use crate::document::Phrase;
use crate::exact;
use crate::formats::listing::{Expression, Scope, Symbol};
use crate::geometry::{CubeFace, dot};
use crate::problem::field_of;

/// What a printed quantity may be.
const NAMES: &str = "R, R^2, a, A, B, M, |OM|, |BM|, P01, |OP01|, w00, w01, w02, cos(alpha/2)";

/// A derived quantity is what is printed.
pub(super) fn quantity(at: &Claimed<'_>, name: &str, printed: &[Expression]) -> Result<Judged, AuditError> {
    let field = field_of(at.case.statement);
    let derived = CubeFace::derive(field).and_then(|face| {
        let edge = face.edge_along_v(0)?;
        let half_chord: [FieldElement; 3] = std::array::from_fn(|k| &edge.end[k] - &edge.middle_of_chord[k]);
        let one = field.one();
        let value = match name {
            "R" | "R^2" | "w00" | "w02" => vec![one],
            "a" => vec![face.side.clone()],
            "A" => edge.start.to_vec(),
            "B" => edge.end.to_vec(),
            "M" => edge.middle_of_chord.to_vec(),
            "|OM|" => vec![dot(&edge.middle_of_chord, &edge.middle_of_chord).square_root()?],
            "|BM|" => vec![dot(&half_chord, &half_chord).square_root()?],
            "P01" => edge.tangents_meet.to_vec(),
            "|OP01|" => vec![dot(&edge.tangents_meet, &edge.tangents_meet).square_root()?],
            "w01" => vec![edge.weight.clone()],
            // The angle between OM and OB, both derived: M·B / (|OM||OB|).
            "cos(alpha/2)" => {
                let length = dot(&edge.middle_of_chord, &edge.middle_of_chord).square_root()?;
                vec![&dot(&edge.middle_of_chord, &edge.end) * &length.inverse()?]
            }
            _ => return Some(Err(())),
        };
        Some(Ok((face.side, value)))
    });
    let (side, derived) = match derived {
        None => return Err(at.wrong("the field of the statement does not contain the cap's geometry".into())),
        Some(Err(())) => return Err(at.wrong(format!("`{name}` is not one of {NAMES}"))),
        Some(Ok(found)) => found,
    };
    if printed.len() != derived.len() {
        return Err(at.wrong(format!("`{name}` has {} components", derived.len())));
    }
    let spelled = |value: &FieldElement| polynomial_to_exact(&Polynomial::constant(value.clone()));
    let names = BTreeMap::from([
        (Symbol::new("a"), Some(spelled(&side)?)),
        (Symbol::new("R"), Some(exact::Polynomial::integer(1))),
    ]);
    let scope = Scope { field: at.case.statement.field().clone(), names };
    let (mut holds, mut of_derived, mut of_printed) = (true, Phrase::default(), Phrase::default());
    for (position, (printed, derived)) in printed.iter().zip(&derived).enumerate() {
        let (printed, derived) = (at.value(printed, &scope)?, spelled(derived)?);
        holds &= printed == derived;
        let comma = if position > 0 { ", " } else { "" };
        of_derived = of_derived.and(comma).formula(&derived);
        of_printed = of_printed.and(comma).formula(&printed);
    }
    let (open, close) = if derived.len() > 1 { ("(", ")") } else { ("", "") };
    let shown = name.replace("^2", "²").replace("alpha", "α");
    let mut evidence = Phrase::words(format!("{shown} = {open}"));
    evidence.0.extend(of_derived.0);
    evidence = evidence.and(close);
    if !holds {
        evidence = evidence.and(format!(", printed {open}"));
        evidence.0.extend(of_printed.0);
        evidence = evidence.and(close);
    }
    Ok((if holds { Judgement::Holds } else { Judgement::Fails }, vec![evidence]))
}
