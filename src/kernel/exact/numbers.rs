//! Metered integers and rationals: the one file of the kernel in which numbers of any length are calculated
//! with.
//!
//! `clippy.toml` and the kernel's lints refuse the operators and the costly methods of `BigInt` and `Ratio`
//! everywhere else. Each operation charges its price, which is about what it costs in time, before it is
//! carried out.
#![allow(clippy::arithmetic_side_effects, clippy::disallowed_methods, reason = "this is the place for them")]

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};

use super::limits::{self, Limit};
use super::work::{Work, count};

/// An operation, however short its numbers.
const LEAST: u64 = 16;
/// One step of a common divisor, beside its words.
const STEP: u64 = 8;
/// Writing a word of a result.
const WORD: u64 = 2;

/// The length of a number in words of 64 bits.
pub(crate) fn words(a: &BigInt) -> u64 {
    a.bits().div_ceil(64)
}

/// The memory of a number beside the two or three words it has where it stands.
pub(crate) fn bytes(a: &BigInt) -> u64 {
    // The allocator's own part, and the words.
    words(a).saturating_mul(8).saturating_add(24)
}

/// −a, which is a without a copy.
pub(crate) fn negated(a: BigRational) -> BigRational {
    -a
}

/// A bound as a rational number; for those who need not account for it.
pub fn decimal_value(units: &BigInt, places: u32) -> BigRational {
    BigRational::new(units.clone(), BigInt::from(10).pow(places))
}

impl Work {
    /// Reading or writing in decimal a number of so many digits.
    pub(crate) fn charge_digits(&mut self, digits: usize) -> Result<(), Limit> {
        let digits = count(digits);
        // Quadratic in the words.
        let squared = digits.saturating_mul(digits).div_ceil(64);
        self.charge(digits.saturating_mul(32).saturating_add(squared).saturating_add(LEAST))
    }

    /// Writing a number in decimal.
    pub(crate) fn charge_spelling(&mut self, a: &BigInt) -> Result<(), Limit> {
        // log₁₀ 2 < 1/3.
        self.charge_digits(usize::try_from(a.bits().div_ceil(3)).unwrap_or(usize::MAX))
    }

    /// A copy.
    pub(crate) fn copied(&mut self, a: &BigInt) -> Result<BigInt, Limit> {
        self.keep(bytes(a))?;
        Ok(a.clone())
    }

    /// a + b.
    pub(crate) fn sum(&mut self, a: &BigInt, b: &BigInt) -> Result<BigInt, Limit> {
        self.charge_sum(a, b)?;
        Ok(a + b)
    }

    /// a − b.
    pub(crate) fn difference(&mut self, a: &BigInt, b: &BigInt) -> Result<BigInt, Limit> {
        self.charge_sum(a, b)?;
        Ok(a - b)
    }

    /// Adds b to a sum, which is kept.
    pub(crate) fn add(&mut self, sum: &mut BigInt, b: &BigInt) -> Result<(), Limit> {
        self.charge_sum(sum, b)?;
        self.keep_growth(sum, words(b).saturating_add(1))?;
        *sum += b;
        Ok(())
    }

    /// Memory for a sum that may become so many words long; where a number grows it may have room for twice
    /// its length.
    fn keep_growth(&mut self, sum: &BigInt, longest: u64) -> Result<(), Limit> {
        let grown = longest.saturating_sub(words(sum)).saturating_mul(16);
        self.keep(if sum.is_zero() { grown.saturating_add(24) } else { grown })
    }

    fn charge_sum(&mut self, a: &BigInt, b: &BigInt) -> Result<(), Limit> {
        self.charge(words(a).max(words(b)).saturating_mul(WORD).saturating_add(LEAST))
    }

    /// |a|.
    pub(crate) fn size(&mut self, a: &BigInt) -> Result<BigInt, Limit> {
        self.charge(words(a).saturating_mul(WORD).saturating_add(LEAST))?;
        Ok(a.abs())
    }

    /// a·b, refused where it would be absurdly long: many large denominators without common factors would
    /// otherwise turn a small file into a huge number.
    pub(crate) fn product(&mut self, a: &BigInt, b: &BigInt) -> Result<BigInt, Limit> {
        limits::BITS.check(a.bits().saturating_add(b.bits()))?;
        let kept = words(a).saturating_add(words(b)).saturating_mul(WORD);
        self.charge(words(a).saturating_mul(words(b)).saturating_add(kept).saturating_add(LEAST))?;
        Ok(a * b)
    }

    /// Adds a·b to a sum, which is kept.
    pub(crate) fn add_product(&mut self, sum: &mut BigInt, a: &BigInt, b: &BigInt) -> Result<(), Limit> {
        let product = self.product(a, b)?;
        self.add(sum, &product)
    }

    /// aⁿ.
    pub(crate) fn power(&mut self, a: &BigInt, exponent: u32) -> Result<BigInt, Limit> {
        let bits = a.bits().saturating_mul(u64::from(exponent));
        limits::BITS.check(bits)?;
        // Squaring again and again: all products together are no more than one of the result's length, twice.
        let words = bits.div_ceil(64);
        let kept = words.saturating_mul(WORD.saturating_mul(2));
        self.charge(
            words.saturating_mul(words).saturating_add(kept).saturating_add(LEAST.saturating_mul(32)),
        )?;
        Ok(a.pow(exponent))
    }

    /// Halves of numbers, if all are even.
    pub(crate) fn halved<const N: usize>(&mut self, numbers: [BigInt; N]) -> Result<[BigInt; N], Limit> {
        let words = numbers.iter().map(words).fold(0, u64::saturating_add);
        self.charge(words.saturating_mul(WORD).saturating_add(LEAST))?;
        let even = numbers.iter().all(Integer::is_even);
        Ok(if even { numbers.map(|number| number >> 1u8) } else { numbers })
    }

    /// The greatest common divisor: about one subtraction of the longer number for each bit of both.
    pub(crate) fn common_divisor(&mut self, a: &BigInt, b: &BigInt) -> Result<BigInt, Limit> {
        let steps = a.bits().saturating_add(b.bits());
        let step = words(a).max(words(b)).saturating_add(STEP);
        self.charge(steps.saturating_mul(step).saturating_add(LEAST))?;
        Ok(a.gcd(b))
    }

    /// The least common multiple of numbers that are not both 0.
    pub(crate) fn common_multiple(&mut self, a: &BigInt, b: &BigInt) -> Result<BigInt, Limit> {
        if b.is_one() || a == b {
            return self.copied(a);
        }
        let divisor = self.common_divisor(a, b)?;
        let cofactor = self.quotient(a, &divisor)?;
        self.product(&cofactor, b)
    }

    /// a/b, towards 0 where it is not an integer.
    pub(crate) fn quotient(&mut self, a: &BigInt, b: &BigInt) -> Result<BigInt, Limit> {
        if b.is_zero() {
            return Err(limits::DENOMINATORS);
        }
        if b.is_one() {
            return self.copied(a);
        }
        self.charge_quotient(a, b)?;
        Ok(a / b)
    }

    /// a/b, if that is an integer.
    pub(crate) fn exact_quotient(&mut self, a: &BigInt, b: &BigInt) -> Result<Option<BigInt>, Limit> {
        if b.is_zero() {
            return Err(limits::DENOMINATORS);
        }
        self.charge_quotient(a, b)?;
        let (quotient, remainder) = a.div_rem(b);
        Ok(remainder.is_zero().then_some(quotient))
    }

    fn charge_quotient(&mut self, a: &BigInt, b: &BigInt) -> Result<(), Limit> {
        let steps = words(a).saturating_add(1).saturating_mul(words(b).saturating_add(1));
        self.charge(
            steps.saturating_mul(2).saturating_add(words(a).saturating_mul(STEP)).saturating_add(LEAST),
        )
    }

    /// ⌊√a⌋ for a ≥ 0: a few divisions of numbers that long.
    pub(crate) fn root(&mut self, a: &BigInt) -> Result<BigInt, Limit> {
        self.charge(words(a).saturating_mul(words(a)).saturating_mul(64).saturating_add(1000))?;
        Ok(a.sqrt())
    }

    /// The square root of a ≥ 0, if that is an integer.
    pub(crate) fn exact_root(&mut self, a: &BigInt) -> Result<Option<BigInt>, Limit> {
        let root = self.root(a)?;
        let square = self.product(&root, &root)?;
        Ok((square == *a).then_some(root))
    }

    /// numerator/denominator in lowest terms.
    pub(crate) fn ratio(&mut self, numerator: BigInt, denominator: &BigInt) -> Result<BigRational, Limit> {
        if !denominator.is_positive() {
            return Err(limits::DENOMINATORS);
        }
        if denominator.is_one() {
            return Ok(BigRational::from_integer(numerator));
        }
        let divisor = self.common_divisor(&numerator, denominator)?;
        let (numerator, denominator) =
            (self.quotient(&numerator, &divisor)?, self.quotient(denominator, &divisor)?);
        self.keep(bytes(&numerator).saturating_add(bytes(&denominator)))?;
        Ok(BigRational::new_raw(numerator, denominator))
    }

    /// n·a for a rational a.
    pub(crate) fn multiple(&mut self, a: &BigRational, n: &BigInt) -> Result<BigRational, Limit> {
        let product = self.product(a.numer(), n)?;
        self.ratio(product, a.denom())
    }

    /// 1/a for a rational a that is not 0.
    pub(crate) fn reciprocal(&mut self, a: &BigRational) -> Result<BigRational, Limit> {
        self.keep(bytes(a.numer()).saturating_add(bytes(a.denom())))?;
        if a.is_zero() { Err(limits::DENOMINATORS) } else { Ok(a.recip()) }
    }

    /// a² − 1 for a rational a: in lowest terms if a is.
    pub(crate) fn square_less_one(&mut self, a: &BigRational) -> Result<BigRational, Limit> {
        let denominator = self.product(a.denom(), a.denom())?;
        let square = self.product(a.numer(), a.numer())?;
        let numerator = self.difference(&square, &denominator)?;
        Ok(BigRational::new_raw(numerator, denominator))
    }

    /// A decimal as a rational number.
    pub(crate) fn decimal(&mut self, units: &BigInt, places: u32) -> Result<BigRational, Limit> {
        let denominator = self.power(&BigInt::from(10), places)?;
        let units = self.copied(units)?;
        self.ratio(units, &denominator)
    }
}
