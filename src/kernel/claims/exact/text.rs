//! The text of claim `exact`, and of values within other claims.

use crate::claims::wording::written;
use crate::exact::{Polynomial, Ring};
use crate::statement::Statement;
use crate::text::{CertificateError, Reader};

/// The lines after the claim.
pub(in crate::claims) fn write(values: &[Polynomial], ring: &Ring, lines: Vec<String>) -> String {
    let mut lines = lines;
    lines.extend(value_lines(values, ring));
    lines.push(format!("end {}", values.len()));
    lines.push(String::new());
    lines.join("\n")
}

/// Reads them.
pub(in crate::claims) fn read(reader: &mut Reader<'_, '_>) -> Result<Vec<Polynomial>, CertificateError> {
    let values = reader.values()?;
    let expected = "`end` and the number of unknowns";
    let line = reader.next(expected)?;
    match reader.is_end(line, values.len())? {
        true => Ok(values),
        false => Err(reader.unexpected(line, expected)),
    }
}

/// A line for each unknown.
pub(in crate::claims) fn value_lines(values: &[Polynomial], ring: &Ring) -> Vec<String> {
    let pairs = ring.variables.iter().zip(values);
    pairs.map(|(name, value)| format!("value {name} = {}", ring.spell(value))).collect()
}

/// The values of the unknowns, a line each, under a sentence.
pub(in crate::claims) fn spelled(statement: &Statement, values: &[Polynomial]) -> Vec<String> {
    let ring = statement.ring();
    let pairs = statement.unknowns().iter().zip(values);
    pairs.map(|(name, value)| format!("value      {name} = {}", written(&ring, value))).collect()
}
