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
use num_traits::{One, Signed, ToPrimitive, Zero};

use super::arithmetic::Arithmetic;
use super::limits::{self, Limit};
use super::monomial::Monomial;
use super::polynomial::Polynomial;

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

impl Arithmetic<'_> {
    /// The square root ≥ 0 of a constant of K, all radicands having positive roots, or why K has none.
    ///
    /// # Errors
    /// See [`Arithmetic::dot`].
    pub fn square_root(&mut self, value: &Polynomial) -> Result<Result<Polynomial, NoRoot>, Limit> {
        if let Some(rational) = value.as_rational() {
            if rational.is_negative() {
                return Ok(Err(NoRoot::Negative));
            }
            return self.root_of_rational(&rational);
        }
        match self.sign(value)? {
            None => return Ok(Err(NoRoot::NotConstant)),
            Some(Ordering::Less) => return Ok(Err(NoRoot::Negative)),
            Some(_) => {}
        }
        let generators: Vec<u8> = self.field.generators().collect();
        let Some((class, root)) = self.square_class(value, &generators)? else {
            return Ok(Err(NoRoot::Nowhere));
        };
        let of_class = match self.root_of_rational(&class)? {
            Ok(of_class) => of_class,
            Err(missing) => return Ok(Err(missing)),
        };
        let root = self.product(&root, &of_class)?;
        let negative = self.sign(&root)? == Some(Ordering::Less);
        Ok(Ok(if negative { self.negated(&root)? } else { root }))
    }

    /// √q for a rational q ≥ 0, or what is missing for it.
    fn root_of_rational(&mut self, q: &BigRational) -> Result<Result<Polynomial, NoRoot>, Limit> {
        match self.rational_root(q)? {
            Some((factor, mask)) => Ok(Ok(Polynomial::term(factor, Monomial::radical(mask)))),
            None => self.missing(q).map(Err),
        }
    }

    /// √q for a rational q ≥ 0 as `rational · √(mask)`, or `None` where it is not in the field.
    fn rational_root(&mut self, q: &BigRational) -> Result<Option<(BigRational, u8)>, Limit> {
        if q.is_negative() {
            return Ok(None);
        }
        if q.is_zero() {
            return Ok(Some((BigRational::zero(), 0)));
        }
        // √(a/b) = √(ab)/b, and √(ab) = s·√n iff ab/n is the square s² for one squarefree n of the field.
        let product = self.work.product(q.numer(), q.denom())?;
        for mask in self.field.masks() {
            let under_root = self.field.under_root(mask).ok_or(limits::FOREIGN_ROOTS)?;
            let Some(quotient) = self.work.exact_quotient(&product, under_root)? else { continue };
            if let Some(root) = self.work.exact_root(&quotient)? {
                return Ok(Some((self.work.ratio(root, q.denom())?, mask)));
            }
        }
        Ok(None)
    }

    /// (c, y) with c rational, y in the field of `generators` and c·y² the given constant of that field,
    /// which is not 0;
    /// `None` where it is no rational times a square.
    fn square_class(
        &mut self,
        value: &Polynomial,
        generators: &[u8],
    ) -> Result<Option<(BigRational, Polynomial)>, Limit> {
        let Some((&bit, lower)) = generators.split_last() else {
            return Ok(value.as_rational().map(|rational| (rational, Polynomial::integer(1))));
        };
        if value.mask() & bit == 0 {
            return self.square_class(value, lower);
        }
        // `with` is b√d.
        let (a, with) = self.parts(value, bit)?;
        let negative = self.negated(&with)?;
        let norm = self.dot(&[(&a, &a), (&negative, &with)])?;
        let Some((class, root)) = self.square_class(&norm, lower)? else { return Ok(None) };
        let below = lower.iter().fold(0u8, |all, bit| all | bit);
        let Some((factor, mask)) = self.rational_root(&class)?.filter(|(_, mask)| mask & !below == 0) else {
            return Ok(None);
        };
        let n = self.product(&root, &Polynomial::term(factor, Monomial::radical(mask)))?;
        let half = Polynomial::rational(BigRational::new_raw(BigInt::one(), BigInt::from(2)));
        let square = self.dot(&[(&half, &a), (&half, &n)])?;
        let Some((class, s)) = self.square_class(&square, lower)? else { return Ok(None) };
        // t√d = b√d/(2cs) = b√d·s/(2cs²), and cs² is `square`.
        let Some(inverse) = self.inverse(&square)? else { return Ok(None) };
        let half_s = self.product(&half, &s)?;
        let half_s = self.product(&half_s, &inverse)?;
        let y = self.dot(&[(&Polynomial::integer(1), &s), (&half_s, &with)])?;
        Ok(Some((class, y)))
    }

    /// What K lacks for the root of a positive rational that it does not have: found where numerator times
    /// denominator is at most 10¹².
    fn missing(&mut self, q: &BigRational) -> Result<NoRoot, Limit> {
        const LARGEST: u64 = 1_000_000_000_000;
        const DIVISIONS: u64 = 1_000_000;
        let product = self.work.product(q.numer(), q.denom())?;
        let Some(mut rest) = product.to_u64().filter(|&product| product <= LARGEST) else {
            return Ok(NoRoot::Outside);
        };
        self.work.charge(DIVISIONS.saturating_mul(10))?;
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
        let is_new = |prime: &u64| !self.field.values().iter().any(|&d| u64::from(d) == *prime);
        let new: Option<Vec<u32>> =
            primes.into_iter().filter(is_new).map(|prime| u32::try_from(prime).ok()).collect();
        let allowed = |new: &Vec<u32>| {
            limits::RADICANDS.allows(new.len().saturating_add(self.field.values().len()))
                && new.iter().all(|&prime| limits::RADICAND.allows(prime))
        };
        Ok(new.filter(allowed).map_or(NoRoot::Outside, NoRoot::Radicands))
    }
}
