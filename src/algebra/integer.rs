//! Integers of any size: num-bigint by default, GMP (through rug) with the feature `gmp`.
//!
//! Everything below this file is the same for both backends.

use std::fmt;
use std::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

#[cfg(not(feature = "gmp"))]
type Backend = num_bigint::BigInt;
#[cfg(feature = "gmp")]
type Backend = rug::Integer;

/// The library that does the arithmetic: `num` or `gmp`.
pub const BACKEND: &str = if cfg!(feature = "gmp") { "gmp" } else { "num" };

/// An integer.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub struct Integer(Backend);

macro_rules! operator {
    ($trait:ident, $method:ident, $symbol:tt) => {
        impl $trait for &Integer {
            type Output = Integer;
            fn $method(self, other: &Integer) -> Integer {
                // For rug the operator builds a lazy value, for num the result itself: `from` serves both.
                #[allow(clippy::useless_conversion, reason = "a conversion with the other backend")]
                Integer(Backend::from(&self.0 $symbol &other.0))
            }
        }
    };
}

operator!(Add, add, +);
operator!(Sub, sub, -);
operator!(Mul, mul, *);

impl Neg for &Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        Integer(-self.0.clone())
    }
}

impl AddAssign<&Integer> for Integer {
    fn add_assign(&mut self, other: &Integer) {
        self.0 += &other.0;
    }
}

impl SubAssign<&Integer> for Integer {
    fn sub_assign(&mut self, other: &Integer) {
        self.0 -= &other.0;
    }
}

impl From<i64> for Integer {
    fn from(value: i64) -> Self {
        Integer(Backend::from(value))
    }
}

impl From<i128> for Integer {
    fn from(value: i128) -> Self {
        Integer(Backend::from(value))
    }
}

impl From<u32> for Integer {
    fn from(value: u32) -> Self {
        Integer(Backend::from(value))
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl fmt::Debug for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl Integer {
    /// 0.
    pub fn zero() -> Self {
        Integer::default()
    }

    /// 1.
    pub fn one() -> Self {
        Integer::from(1i64)
    }

    /// Whether this is 0.
    pub fn is_zero(&self) -> bool {
        self.0 == Backend::default()
    }

    /// Whether this is 1.
    pub fn is_one(&self) -> bool {
        *self == Integer::one()
    }

    /// Whether this is below 0.
    pub fn is_negative(&self) -> bool {
        self.0 < Backend::default()
    }

    /// The value, if it fits.
    pub fn to_i64(&self) -> Option<i64> {
        i64::try_from(&self.0).ok()
    }

    /// self − quotient·divisor for the quotient rounded down, so that it lies in 0..divisor for a positive divisor.
    pub fn modulo(&self, divisor: &Self) -> Self {
        let (_, remainder) = self.quotient_and_remainder(divisor);
        if remainder.is_negative() { &remainder + divisor } else { remainder }
    }

    /// |self|.
    pub fn abs(&self) -> Self {
        if self.is_negative() { -self } else { self.clone() }
    }

    /// The greatest common divisor, never negative.
    pub fn gcd(&self, other: &Self) -> Self {
        // Most numbers are short, and most of the time would go into allocating them.
        match (self.to_i64(), other.to_i64()) {
            (Some(a), Some(b)) => {
                let divisor = num_integer::Integer::gcd(&i128::from(a), &i128::from(b));
                Integer::from(divisor)
            }
            _ => self.gcd_of_long(other),
        }
    }

    /// self · factor.
    pub fn times(&self, factor: u64) -> Self {
        Integer(Backend::from(&self.0 * factor))
    }

    /// ⌊self / 2ⁿ⌋.
    pub fn shifted_right(&self, n: u32) -> Self {
        Integer(Backend::from(&self.0 >> n))
    }

    /// self · 2ⁿ.
    pub fn shifted_left(&self, n: u32) -> Self {
        Integer(Backend::from(&self.0 << n))
    }

    /// self to a power.
    pub fn power(&self, exponent: u32) -> Self {
        (0..exponent).fold(Integer::one(), |power, _| &power * self)
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        if self == other || other.is_one() {
            return self.clone();
        }
        if self.is_one() {
            return other.clone();
        }
        &self.exact_quotient(&self.gcd(other)) * other
    }
}

#[cfg(not(feature = "gmp"))]
impl Integer {
    fn gcd_of_long(&self, other: &Self) -> Self {
        Integer(num_integer::Integer::gcd(&self.0, &other.0))
    }

    /// self / divisor for a divisor that divides.
    pub fn exact_quotient(&self, divisor: &Self) -> Self {
        Integer(&self.0 / &divisor.0)
    }

    /// The quotient rounded towards 0, and the remainder, which has the sign of `self`.
    pub fn quotient_and_remainder(&self, divisor: &Self) -> (Self, Self) {
        let (quotient, remainder) = num_integer::Integer::div_rem(&self.0, &divisor.0);
        (Integer(quotient), Integer(remainder))
    }

    /// Binary digits of the absolute value; none for 0.
    pub fn bits(&self) -> u64 {
        self.0.bits()
    }

    /// The largest r with r² ≤ self, for self ≥ 0.
    pub fn floor_sqrt(&self) -> Self {
        Integer(self.0.sqrt())
    }

    /// The residue in 0..p.
    pub fn residue(&self, p: u64) -> u64 {
        let p = num_bigint::BigInt::from(p);
        u64::try_from(num_integer::Integer::mod_floor(&self.0, &p)).expect("a residue modulo a u64")
    }

    /// As the checker's kind of integer.
    pub fn to_bigint(&self) -> num_bigint::BigInt {
        self.0.clone()
    }

    /// From the checker's kind of integer.
    pub fn from_bigint(value: &num_bigint::BigInt) -> Self {
        Integer(value.clone())
    }
}

#[cfg(feature = "gmp")]
impl Integer {
    fn gcd_of_long(&self, other: &Self) -> Self {
        Integer(Backend::from(self.0.gcd_ref(&other.0)))
    }

    /// self / divisor for a divisor that divides.
    pub fn exact_quotient(&self, divisor: &Self) -> Self {
        Integer(Backend::from(self.0.div_exact_ref(&divisor.0)))
    }

    /// The quotient rounded towards 0, and the remainder, which has the sign of `self`.
    pub fn quotient_and_remainder(&self, divisor: &Self) -> (Self, Self) {
        let (quotient, remainder) = <(Backend, Backend)>::from(self.0.div_rem_ref(&divisor.0));
        (Integer(quotient), Integer(remainder))
    }

    /// Binary digits of the absolute value; none for 0.
    pub fn bits(&self) -> u64 {
        u64::from(self.0.significant_bits())
    }

    /// The largest r with r² ≤ self, for self ≥ 0.
    pub fn floor_sqrt(&self) -> Self {
        Integer(Backend::from(self.0.sqrt_ref()))
    }

    /// The residue in 0..p.
    pub fn residue(&self, p: u64) -> u64 {
        use rug::ops::RemRounding;
        let residue = Backend::from((&self.0).rem_euc(&Backend::from(p)));
        residue.to_u64().expect("a residue modulo a u64")
    }

    /// As the checker's kind of integer.
    pub fn to_bigint(&self) -> num_bigint::BigInt {
        let digits = self.0.to_digits::<u32>(rug::integer::Order::Lsf);
        let sign = if self.is_negative() { num_bigint::Sign::Minus } else { num_bigint::Sign::Plus };
        num_bigint::BigInt::new(sign, digits)
    }

    /// From the checker's kind of integer.
    pub fn from_bigint(value: &num_bigint::BigInt) -> Self {
        let (sign, digits) = value.to_u32_digits();
        let magnitude = Backend::from_digits(&digits, rug::integer::Order::Lsf);
        Integer(if sign == num_bigint::Sign::Minus { -magnitude } else { magnitude })
    }
}
