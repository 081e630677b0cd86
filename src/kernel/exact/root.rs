//! Square roots of constants of K, where they lie in K.
//!
//! Every x in K is looked for as c·y² with c rational and y in K: then √x = √c·y, and √c is in K iff c is a square
//! times a product of radicands. Let √d be the last root of K and L the field without it. If a + b√d = c(s + t√d)² with
//! a, b, s, t in L and b ≠ 0, then a² − b²d = c²(s² − t²d)² is the square of some n in L, and (a + n)/2 is c·s² or
//! cd·t², in both cases a rational times a square in L, from which c, s and t = b/(2cs) follow. So L decides about K.

use std::cmp::Ordering;
use std::fmt;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Signed, ToPrimitive};

use super::combination::combination;
use super::limits;
use super::monomial::Monomial;
use super::polynomial::Polynomial;
use super::radicands::Radicands;
use super::sign::sign;
use super::work::{Limit, Work};

/// Why K has no square root of an element.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoRoot {
    /// It is no constant.
    NotConstant,
    /// It is negative, and K is real.
    Negative,
    /// The root lies in the field that has these radicands, too.
    Radicands(Vec<u32>),
    /// The root lies in no field that square roots of rationals generate.
    Nowhere,
    /// None of these: the root is that of a rational times an element of K, and the format has no radicands for it.
    Outside,
}

impl fmt::Display for NoRoot {
    /// What follows "… is not in K".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NoRoot::NotConstant => f.write_str(": one takes roots of constants only"),
            NoRoot::Negative => f.write_str(": the number is negative"),
            NoRoot::Radicands(primes) => {
                let primes: Vec<String> = primes.iter().map(u32::to_string).collect();
                write!(f, "; with {} among the radicands it is", primes.join(" and "))
            }
            NoRoot::Nowhere => f.write_str(", nor in any field of square roots of rationals"),
            NoRoot::Outside => Ok(()),
        }
    }
}

impl Polynomial {
    /// The square root ≥ 0 of a constant of K, all radicands having positive roots, or why K has none.
    pub fn square_root(&self, field: &Radicands, work: &mut Work) -> Result<Result<Self, NoRoot>, Limit> {
        if let Some(rational) = self.as_rational() {
            if rational.is_negative() {
                return Ok(Err(NoRoot::Negative));
            }
            return root_of_rational(&rational, field, work);
        }
        match sign(self, field, work)? {
            None => return Ok(Err(NoRoot::NotConstant)),
            Some(Ordering::Less) => return Ok(Err(NoRoot::Negative)),
            Some(_) => {}
        }
        let generators: Vec<u8> = field.generators().collect();
        let Some((class, root)) = square_class(self, &generators, field, work)? else {
            return Ok(Err(NoRoot::Nowhere));
        };
        let of_class = match root_of_rational(&class, field, work)? {
            Ok(of_class) => of_class,
            Err(missing) => return Ok(Err(missing)),
        };
        let root = root.multiply(&of_class, field, work)?;
        let negative = sign(&root, field, work)? == Some(Ordering::Less);
        Ok(Ok(if negative { root.negate() } else { root }))
    }
}

/// √q for a rational q ≥ 0, or what is missing for it.
fn root_of_rational(
    q: &BigRational,
    field: &Radicands,
    work: &mut Work,
) -> Result<Result<Polynomial, NoRoot>, Limit> {
    match field.square_root(q, work)? {
        Some((factor, mask)) => Ok(Ok(Polynomial::term(factor, Monomial::radical(mask)))),
        None => missing(q, field, work).map(Err),
    }
}

/// (c, y) with c rational, y in the field of `generators` and c·y² the given constant of that field, which is not 0;
/// `None` where it is no rational times a square.
fn square_class(
    value: &Polynomial,
    generators: &[u8],
    field: &Radicands,
    work: &mut Work,
) -> Result<Option<(BigRational, Polynomial)>, Limit> {
    let Some((&bit, lower)) = generators.split_last() else {
        return Ok(value.as_rational().map(|rational| (rational, Polynomial::integer(1))));
    };
    if value.mask() & bit == 0 {
        return square_class(value, lower, field, work);
    }
    // `with` is b√d.
    let (a, with) = value.parts(bit);
    let norm = combination(&[(&a, &a), (&with.negate(), &with)], field, work)?;
    let Some((class, root)) = square_class(&norm, lower, field, work)? else { return Ok(None) };
    let below = lower.iter().fold(0u8, |all, bit| all | bit);
    let Some((factor, mask)) = field.square_root(&class, work)?.filter(|(_, mask)| mask & !below == 0) else {
        return Ok(None);
    };
    let n = root.multiply(&Polynomial::term(factor, Monomial::radical(mask)), field, work)?;
    let half = Polynomial::rational(BigRational::new(BigInt::one(), BigInt::from(2)));
    let square = combination(&[(&half, &a), (&half, &n)], field, work)?;
    let Some((class, s)) = square_class(&square, lower, field, work)? else { return Ok(None) };
    // t√d = b√d/(2cs) = b√d·s/(2cs²), and cs² is `square`.
    let Some(inverse) = square.inverse(field, work)? else { return Ok(None) };
    let half_s = half.multiply(&s, field, work)?.multiply(&inverse, field, work)?;
    let y = combination(&[(&Polynomial::integer(1), &s), (&half_s, &with)], field, work)?;
    Ok(Some((class, y)))
}

/// What K lacks for the root of a positive rational that it does not have: found where numerator times denominator is
/// at most 10¹².
fn missing(q: &BigRational, field: &Radicands, work: &mut Work) -> Result<NoRoot, Limit> {
    const LARGEST: u64 = 1_000_000_000_000;
    const DIVISIONS: u64 = 1_000_000;
    work.charge_product(q.numer(), q.denom())?;
    let product = (q.numer() * q.denom()).to_u64().filter(|&product| product <= LARGEST);
    let Some(mut rest) = product else { return Ok(NoRoot::Outside) };
    work.charge(DIVISIONS.saturating_mul(10))?;
    let mut primes = Vec::new();
    for d in 2..=DIVISIONS {
        if d.saturating_mul(d) > rest {
            break;
        }
        let mut odd = false;
        while rest.is_multiple_of(d) {
            rest = rest.checked_div(d).unwrap_or(1);
            odd = !odd;
        }
        if odd {
            primes.push(d);
        }
    }
    // No divisor up to its root: 1, or a prime.
    primes.extend(Some(rest).filter(|&rest| rest > 1));
    let is_new = |prime: &u64| !field.values().iter().any(|&d| u64::from(d) == *prime);
    let new: Option<Vec<u32>> =
        primes.into_iter().filter(is_new).map(|prime| u32::try_from(prime).ok()).collect();
    let allowed = |new: &Vec<u32>| {
        new.len().saturating_add(field.values().len()) <= limits::RADICANDS
            && new.iter().all(|&prime| prime <= limits::RADICAND)
    };
    Ok(new.filter(allowed).map_or(NoRoot::Outside, NoRoot::Radicands))
}
