//! Values of the unknowns, by name.

use crate::exact::Polynomial;
use crate::formats::listing::read_constant;
use crate::statement::Statement;

/// Why there is not one value for each unknown.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ValuesError {
    /// One that is given cannot be taken.
    #[error("{name}={value}: {fault}")]
    Wrong {
        /// The name.
        name: String,
        /// The value.
        value: String,
        /// What is wrong with them.
        fault: String,
    },
    /// Some are not given.
    #[error("no value for {}", .0.join(", "))]
    Missing(Vec<String>),
}

/// The value of each unknown in the statement's order, from names and exact numbers of the field as people write them.
///
/// # Errors
/// [`ValuesError`]
pub fn values(statement: &Statement, given: &[(&str, &str)]) -> Result<Vec<Polynomial>, ValuesError> {
    let unknowns = statement.unknowns();
    let mut values: Vec<Option<Polynomial>> = vec![None; unknowns.len()];
    for (name, value) in given {
        let wrong = |fault: String| ValuesError::Wrong {
            name: (*name).to_owned(),
            value: (*value).to_owned(),
            fault,
        };
        let Some(place) = unknowns.iter().position(|unknown| unknown == name.trim()) else {
            let expected = match unknowns {
                [] => "the patch has no unknowns".to_owned(),
                names => format!("expected one of {}", names.join(", ")),
            };
            return Err(wrong(format!("`{}` is not an unknown; {expected}", name.trim())));
        };
        if values[place].is_some() {
            return Err(wrong(format!("`{}` is set twice", name.trim())));
        }
        let read = read_constant(value, statement.field()).map_err(|error| {
            wrong(format!(
                "{}\nexpected an exact number of {}: a decimal, 1/2, or an expression like 4*sqrt(3)/3",
                error.fault(),
                statement.field()
            ))
        })?;
        values[place] = Some(read);
    }
    let missing: Vec<String> = unknowns
        .iter()
        .zip(&values)
        .filter(|(_, value)| value.is_none())
        .map(|(name, _)| name.clone())
        .collect();
    if missing.is_empty() {
        Ok(values.into_iter().flatten().collect())
    } else {
        Err(ValuesError::Missing(missing))
    }
}
