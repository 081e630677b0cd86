//! The value of a printed formula: a polynomial over K.

use std::collections::BTreeMap;

use super::error::{ListingFault, Located};
use super::expression::{Expression, Kind, Operator};
use super::token::Symbol;
use crate::exact::{Limit, Polynomial, Radicands, Work};

/// What names stand for.
#[derive(Debug, Clone)]
pub struct Scope {
    /// K.
    pub field: Radicands,
    /// The meaning of each name that has one; none where it has two.
    pub names: BTreeMap<Symbol, Option<Polynomial>>,
}

impl Scope {
    /// The scope in which names stand for the variables of these names, in this order.
    pub fn of(field: &Radicands, variables: &[String]) -> Self {
        let mut scope = Scope { field: field.clone(), names: BTreeMap::new() };
        for (index, name) in (0u16..).zip(variables) {
            let meaning = Some(Polynomial::variable(index));
            let entry = scope.names.entry(Symbol::new(name));
            entry.and_modify(|meaning| *meaning = None).or_insert(meaning);
        }
        scope
    }

    fn known(&self) -> String {
        let names: Vec<&str> = self.names.keys().map(Symbol::as_str).collect();
        match names.len() {
            0 => "numbers only".into(),
            1..=12 => format!("one of {}", names.join(", ")),
            _ => format!("one of {}, …", names[..12].join(", ")),
        }
    }
}

/// Evaluates a formula.
///
/// # Errors
/// An unknown name, a root outside K, a division that is none, or a limit.
pub(crate) fn evaluate(
    expression: &Expression,
    scope: &Scope,
    work: &mut Work,
) -> Result<Polynomial, Located> {
    let here = |limit: Limit| (ListingFault::from(limit), expression.span.clone());
    let fault = |fault: ListingFault| (fault, expression.span.clone());
    match &expression.kind {
        Kind::Number(value) => Ok(Polynomial::rational(value.clone())),
        Kind::Name(symbol) => match scope.names.get(symbol) {
            Some(Some(meaning)) => {
                work.charge_copy(meaning).map_err(here)?;
                Ok(meaning.clone())
            }
            Some(None) => Err(fault(ListingFault::AmbiguousName { name: symbol.to_string() })),
            None => {
                let name = symbol.as_str().chars().take(40).collect();
                Err(fault(ListingFault::UnknownName { name, expected: scope.known() }))
            }
        },
        Kind::Sum(terms) => {
            let mut summands = Vec::with_capacity(terms.len());
            for term in terms {
                let value = evaluate(&term.term, scope, work)?;
                summands.push(if term.minus { value.negate() } else { value });
            }
            Polynomial::sum(&summands, &scope.field, work).map_err(here)
        }
        Kind::Product(first, factors) => {
            let mut product = evaluate(first, scope, work)?;
            for (operator, factor) in factors {
                let mut value = evaluate(factor, scope, work)?;
                if *operator == Operator::Over {
                    value = reciprocal(&value, scope, work).map_err(|fault| (fault, factor.span.clone()))?;
                }
                product = product.multiply(&value, &scope.field, work).map_err(here)?;
            }
            Ok(product)
        }
        Kind::Power(base, exponent, _) => {
            let base = evaluate(base, scope, work)?;
            base.power(*exponent, &scope.field, work).map_err(here)
        }
        Kind::Root(inside) => {
            let value = evaluate(inside, scope, work)?;
            let root = value.square_root(&scope.field, work).map_err(here)?;
            root.map_err(|why| fault(ListingFault::Root { outside: format!("{}{why}", scope.field) }))
        }
    }
}

fn reciprocal(value: &Polynomial, scope: &Scope, work: &mut Work) -> Result<Polynomial, ListingFault> {
    if value.is_zero() {
        return Err(ListingFault::DivisionByZero);
    }
    value.inverse(&scope.field, work)?.ok_or(ListingFault::DivisionByUnknown)
}
