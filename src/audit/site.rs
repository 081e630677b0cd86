//! The places of a formula at which one character can be wrong.

use num_rational::BigRational;
use num_traits::One;

use super::correction::Change;
use crate::formats::listing::{Expression, Kind, Operator, Signed};

/// A place that can be changed.
pub(super) enum Site<'a> {
    /// The sign of a term.
    Sign(&'a Signed),
    /// A number; whether it stands under a root; whether it is a divisor.
    Number { part: &'a Expression, in_root: bool, below: bool },
    /// A root.
    Root(&'a Expression),
    /// An exponent, with the power it belongs to; 1 for a name without one.
    Exponent { whole: &'a Expression, exponent: u32 },
    /// A name.
    Name(&'a Expression),
}

/// The number of sites.
pub(super) fn count_sites(expression: &Expression) -> usize {
    let mut count = 0;
    walk(expression, Context::default(), &mut |_| {
        count += 1;
        false
    });
    count
}

/// The site with this number.
pub(super) fn site(expression: &Expression, index: usize) -> Option<Site<'_>> {
    let (mut count, mut found) = (0, None);
    walk(expression, Context::default(), &mut |site| {
        if count == index {
            found = Some(site);
        }
        count += 1;
        count > index
    });
    found
}

#[derive(Clone, Copy, Default)]
struct Context {
    in_root: bool,
    below: bool,
    /// The base of a power: its exponent is the power's.
    raised: bool,
}

/// Visits the sites in the order in which [`Rewrite`] numbers them, until `visit` says true.
fn walk<'a>(part: &'a Expression, context: Context, visit: &mut dyn FnMut(Site<'a>) -> bool) -> bool {
    let inside = Context { below: false, raised: false, ..context };
    match &part.kind {
        Kind::Number(_) => visit(Site::Number { part, in_root: context.in_root, below: context.below }),
        Kind::Name(_) => {
            visit(Site::Name(part)) || (!context.raised && visit(Site::Exponent { whole: part, exponent: 1 }))
        }
        Kind::Sum(terms) => {
            terms.iter().any(|term| visit(Site::Sign(term)) || walk(&term.term, inside, visit))
        }
        Kind::Product(first, factors) => {
            walk(first, inside, visit)
                || factors.iter().any(|(operator, factor)| {
                    let below = *operator == Operator::Over;
                    walk(factor, Context { below, ..inside }, visit)
                })
        }
        Kind::Power(base, exponent, _) => {
            visit(Site::Exponent { whole: part, exponent: *exponent })
                || walk(base, Context { raised: true, ..inside }, visit)
        }
        Kind::Root(inner) => {
            visit(Site::Root(part)) || walk(inner, Context { in_root: true, ..inside }, visit)
        }
    }
}

/// The formula with one site changed.
pub(super) fn change_site(expression: &Expression, index: usize, change: &Change) -> Expression {
    let mut changed = expression.clone();
    let mut rewrite = Rewrite { left: index, change };
    rewrite.part(&mut changed, false);
    changed
}

/// Counts sites down to the one to be changed. Its order is that of [`walk`].
struct Rewrite<'a> {
    left: usize,
    change: &'a Change,
}

impl Rewrite<'_> {
    /// Whether this site is the one.
    fn here(&mut self) -> bool {
        let here = self.left == 0;
        self.left = self.left.wrapping_sub(1);
        here
    }

    fn part(&mut self, part: &mut Expression, raised: bool) {
        let span = part.span.clone();
        let number = |value: BigRational| Expression { kind: Kind::Number(value), span: span.clone() };
        match &mut part.kind {
            Kind::Number(value) => {
                if self.here() {
                    match self.change {
                        Change::Number { right, .. } => *value = right.clone(),
                        Change::Radicand { right, .. } => *value = BigRational::from_integer((*right).into()),
                        Change::MissingRoot { root, .. } => {
                            let root = number(BigRational::from_integer((*root).into()));
                            let root = Expression { kind: Kind::Root(Box::new(root)), span: span.clone() };
                            let factor = number(value.clone());
                            part.kind = Kind::Product(Box::new(factor), vec![(Operator::Times, root)]);
                        }
                        _ => {}
                    }
                }
            }
            Kind::Name(name) => {
                if self.here()
                    && let Change::Name { right, .. } = self.change
                {
                    *name = right.clone();
                }
                if !raised
                    && self.here()
                    && let Change::Exponent { right, .. } = self.change
                {
                    part.kind = Kind::Power(Box::new(part.clone()), *right, span);
                }
            }
            Kind::Sum(terms) => {
                for term in terms {
                    if self.here()
                        && let Change::Sign { minus } = self.change
                    {
                        term.minus = *minus;
                    }
                    self.part(&mut term.term, false);
                }
            }
            Kind::Product(first, factors) => {
                self.part(first, false);
                for (_, factor) in factors {
                    self.part(factor, false);
                }
            }
            Kind::Power(base, exponent, _) => {
                if self.here()
                    && let Change::Exponent { right, .. } = self.change
                {
                    *exponent = *right;
                }
                self.part(base, true);
            }
            Kind::Root(inner) => {
                let here = self.here();
                self.part(inner, false);
                if here && matches!(self.change, Change::SuperfluousRoot) {
                    part.kind = Kind::Number(BigRational::one());
                }
            }
        }
    }
}
