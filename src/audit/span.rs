//! The K-space that polynomials span: rank, membership, relations.

use crate::algebra::{FieldElement, MultiquadraticField, Polynomial};

/// Polynomials in echelon form, each known as a combination of those that were added.
#[derive(Debug, Clone)]
pub(super) struct Span {
    field: MultiquadraticField,
    /// Monic, with different leading monomials; the scalars of the combination.
    rows: Vec<(Polynomial, Vec<FieldElement>)>,
    added: usize,
}

/// What is left of a polynomial after reduction: remainder = polynomial − Σ scalar · added.
pub(super) struct Reduced {
    pub remainder: Polynomial,
    pub scalars: Vec<FieldElement>,
}

impl Span {
    /// The space {0}.
    pub(super) fn new(field: MultiquadraticField) -> Self {
        Span { field, rows: Vec::new(), added: 0 }
    }

    /// The span of some polynomials.
    pub(super) fn of<'a>(
        field: MultiquadraticField,
        polynomials: impl IntoIterator<Item = &'a Polynomial>,
    ) -> Self {
        let mut span = Span::new(field);
        for polynomial in polynomials {
            span.add(polynomial);
        }
        span
    }

    /// The dimension.
    pub(super) fn rank(&self) -> usize {
        self.rows.len()
    }

    /// Reduces by the space.
    pub(super) fn reduce(&self, polynomial: &Polynomial) -> Reduced {
        let mut remainder = polynomial.clone();
        let mut scalars = vec![self.field.zero(); self.added];
        for (row, combination) in &self.rows {
            let leading = row.leading_term().map(|(monomial, _)| monomial);
            let Some(factor) = leading.and_then(|m| remainder.coefficient(m)).cloned() else { continue };
            remainder = remainder.add_scaled(&-&factor, row);
            for (scalar, part) in scalars.iter_mut().zip(combination) {
                *scalar = &*scalar + &(&factor * part);
            }
        }
        Reduced { remainder, scalars }
    }

    /// Adds a polynomial; if it is in the space already, the scalars that combine it from those before.
    pub(super) fn add(&mut self, polynomial: &Polynomial) -> Option<Vec<FieldElement>> {
        let Reduced { remainder, scalars } = self.reduce(polynomial);
        self.added += 1;
        for (_, combination) in &mut self.rows {
            combination.push(self.field.zero());
        }
        let Some(inverse) = remainder.leading_term().and_then(|(_, value)| value.inverse()) else {
            return Some(scalars);
        };
        let mut combination: Vec<FieldElement> = scalars.iter().map(|scalar| &-scalar * &inverse).collect();
        combination.push(inverse.clone());
        let row = remainder.scaled(&inverse);
        // Rows stay free of each other's leading monomials, so that one pass reduces.
        let leading = row.leading_term().map(|(monomial, _)| monomial.clone());
        for (other, others) in &mut self.rows {
            let Some(factor) = leading.as_ref().and_then(|m| other.coefficient(m)).cloned() else { continue };
            *other = other.add_scaled(&-&factor, &row);
            for (scalar, part) in others.iter_mut().zip(&combination) {
                *scalar = &*scalar - &(&factor * part);
            }
        }
        self.rows.push((row, combination));
        None
    }
}

/// The solutions of a linear system.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Solutions {
    /// None.
    Inconsistent,
    /// One.
    Unique(Vec<FieldElement>),
    /// A family of this dimension.
    Family(usize),
}

/// Solves Σ matrix[k][i]·x_i = right[k] over K; also the rank of the matrix.
pub(super) fn solve(
    matrix: &[Vec<FieldElement>],
    right: &[FieldElement],
    columns: usize,
) -> (usize, Solutions) {
    let mut rows: Vec<Vec<FieldElement>> =
        matrix.iter().zip(right).map(|(row, value)| row.iter().chain([value]).cloned().collect()).collect();
    let mut pivots = Vec::new();
    for column in 0..columns {
        let rank = pivots.len();
        let Some(pivot) = (rank..rows.len()).find(|&k| !rows[k][column].is_zero()) else { continue };
        rows.swap(rank, pivot);
        let inverse = rows[rank][column].inverse().expect("not zero");
        let scaled: Vec<FieldElement> = rows[rank].iter().map(|value| value * &inverse).collect();
        for (k, row) in rows.iter_mut().enumerate() {
            let factor = row[column].clone();
            if k != rank && !factor.is_zero() {
                *row = row.iter().zip(&scaled).map(|(value, pivot)| value - &(&factor * pivot)).collect();
            }
        }
        rows[rank] = scaled;
        pivots.push(column);
    }
    let rank = pivots.len();
    let solutions = if rows[rank..].iter().any(|row| !row[columns].is_zero()) {
        Solutions::Inconsistent
    } else if rank == columns {
        Solutions::Unique(rows[..rank].iter().map(|row| row[columns].clone()).collect())
    } else {
        Solutions::Family(columns - rank)
    };
    (rank, solutions)
}
