//! The text of claim `bounds`: FORMAT.md, "Certificates by subdivision".

use num_rational::BigRational;
use num_traits::{One, Signed};

use super::{Bounds, End};
use crate::claims::exact::value_lines;
use crate::claims::subdivision::{leaves, quantity, sealed, spell_decimal, spelled};
use crate::exact::Ring;
use crate::text::{CertificateError, CertificateFault as Fault, Reader};

/// The lines after the claim.
pub(in crate::claims) fn write(bounds: &Bounds, ring: &Ring, lines: Vec<String>) -> String {
    let mut lines = lines;
    lines.extend(value_lines(&bounds.values, ring));
    lines.push(quantity(bounds.quantity, bounds.places));
    if !bounds.plain() {
        let [of_u, of_v] = &bounds.odds;
        lines.push(format!("odds {of_u} {of_v}"));
    }
    lines.push(format!("denominator {}", spelled(&bounds.denominator)));
    for (name, End { bound, at: [u, v], tree }) in [("lower", &bounds.lower), ("upper", &bounds.upper)] {
        let bound = spell_decimal(bound, bounds.places);
        lines.push(format!("{name} {bound} at {u} {v} over {}", spelled(tree)));
    }
    sealed(lines, boxes(bounds))
}

/// Reads them.
pub(in crate::claims) fn read(reader: &mut Reader<'_, '_>) -> Result<Bounds, CertificateError> {
    let values = reader.values()?;
    let (quantity, places) = reader.quantity()?;
    let odds = if reader.version == 1 { [(); 2].map(|()| BigRational::one()) } else { odds(reader)? };
    let denominator = reader.named_tree("denominator ", "`denominator ` and a tree of `h` and `.`")?;
    let lower = end(reader, "lower ", places)?;
    let upper = end(reader, "upper ", places)?;
    let bounds = Bounds { values, quantity, places, odds, denominator, lower, upper };
    reader.sealed(boxes(&bounds))?;
    Ok(bounds)
}

/// `odds 1/1024 1`.
fn odds(reader: &mut Reader<'_, '_>) -> Result<[BigRational; 2], CertificateError> {
    let expected = "`odds ` and two positive rationals, not both 1";
    let line = reader.next(expected)?;
    let pair = line.strip_prefix("odds ").and_then(|rest| rest.split_once(' '));
    let (u, v) = pair.ok_or_else(|| reader.unexpected(line, expected))?;
    let odds = [reader.rational(line, u)?, reader.rational(line, v)?];
    match odds.iter().all(Signed::is_positive) && !odds.iter().all(BigRational::is_one) {
        true => Ok(odds),
        false => Err(reader.unexpected(line, expected)),
    }
}

/// The boxes of all trees.
fn boxes(bounds: &Bounds) -> usize {
    let trees = [&bounds.denominator, &bounds.lower.tree, &bounds.upper.tree];
    trees.into_iter().fold(0, |sum, tree| leaves(tree).saturating_add(sum))
}

/// `lower 0.9 at 1/2 1/2 over h..`.
fn end(reader: &mut Reader<'_, '_>, name: &'static str, places: u32) -> Result<End, CertificateError> {
    let expected = match name {
        "lower " => "`lower DECIMAL at U V over TREE`",
        _ => "`upper DECIMAL at U V over TREE`",
    };
    let line = reader.next(expected)?;
    let parts = line.strip_prefix(name).and_then(|rest| {
        let (decimal, rest) = rest.split_once(" at ")?;
        let (point, tree) = rest.split_once(" over ")?;
        let (u, v) = point.split_once(' ')?;
        Some((decimal, u, v, tree))
    });
    let (decimal, u, v, tree) = parts.ok_or_else(|| reader.unexpected(line, expected))?;
    let bound = reader.decimal(decimal, places)?;
    let at = [reader.rational(line, u)?, reader.rational(line, v)?];
    if at.iter().any(|x| x.is_negative() || x.numer() > x.denom()) {
        return Err(reader.fail(1, Fault::OutsideSquare));
    }
    Ok(End { bound, at, tree: reader.tree(line, tree)? })
}
