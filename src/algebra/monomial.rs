//! Power products and the degree reverse lexicographic order.

use std::cmp::Ordering;

/// x₀^e₀ · x₁^e₁ · …, stored sparsely.
///
/// `Ord` is DegRevLex with x₀ > x₁ > …: higher degree is larger; of two of the same degree that one is larger
/// whose exponent of the last variable in which they differ is *smaller*. It is an admissible order: 1 ≤ m,
/// and a < b implies ac < bc (Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, section 2.2).
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Monomial {
    degree: u32,
    /// (variable, exponent ≥ 1), variables increasing.
    powers: Vec<(u16, u32)>,
}

impl Monomial {
    /// 1.
    pub fn one() -> Self {
        Monomial { degree: 0, powers: Vec::new() }
    }

    /// One variable.
    pub fn variable(index: u16) -> Self {
        Monomial { degree: 1, powers: vec![(index, 1)] }
    }

    /// From (variable, exponent ≥ 1) pairs with increasing variables.
    pub fn from_powers(powers: Vec<(u16, u32)>) -> Self {
        debug_assert!(powers.is_sorted_by(|(a, _), (b, _)| a < b));
        Monomial { degree: powers.iter().map(|&(_, exponent)| exponent).sum(), powers }
    }

    /// The total degree.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// (variable, exponent ≥ 1), variables increasing.
    pub fn powers(&self) -> &[(u16, u32)] {
        &self.powers
    }

    /// The exponent of one variable.
    pub fn exponent(&self, variable: u16) -> u32 {
        self.powers.iter().find(|&&(v, _)| v == variable).map_or(0, |&(_, exponent)| exponent)
    }

    /// self · other.
    pub fn product(&self, other: &Self) -> Self {
        self.merged(other, |a, b| a + b)
    }

    /// The least common multiple.
    pub fn lcm(&self, other: &Self) -> Self {
        self.merged(other, u32::max)
    }

    /// Whether the two have no variable in common.
    pub fn is_coprime_to(&self, other: &Self) -> bool {
        self.lcm(other).degree == self.degree + other.degree
    }

    /// self / divisor, if that is a monomial.
    pub fn quotient(&self, divisor: &Self) -> Option<Self> {
        if divisor.powers.iter().any(|&(v, exponent)| self.exponent(v) < exponent) {
            return None;
        }
        let left = self.powers.iter().map(|&(v, exponent)| (v, exponent - divisor.exponent(v)));
        Some(Monomial::from_powers(left.filter(|&(_, exponent)| exponent > 0).collect()))
    }

    fn merged(&self, other: &Self, combine: impl Fn(u32, u32) -> u32) -> Self {
        let mut powers = Vec::with_capacity(self.powers.len() + other.powers.len());
        let (mut i, mut j) = (0, 0);
        while let (Some(&(a, e)), Some(&(b, f))) = (self.powers.get(i), other.powers.get(j)) {
            powers.push(match a.cmp(&b) {
                Ordering::Less => (a, e),
                Ordering::Greater => (b, f),
                Ordering::Equal => (a, combine(e, f)),
            });
            i += usize::from(a <= b);
            j += usize::from(b <= a);
        }
        powers.extend(&self.powers[i..]);
        powers.extend(&other.powers[j..]);
        Monomial::from_powers(powers)
    }

    /// All monomials of exactly this degree in the given variables (increasing), in increasing order.
    pub fn all_of_degree(variables: &[u16], degree: u32) -> Vec<Monomial> {
        let mut found = Vec::new();
        collect(variables, degree, &mut Vec::new(), &mut found);
        found.sort();
        found
    }
}

fn collect(variables: &[u16], degree: u32, powers: &mut Vec<(u16, u32)>, found: &mut Vec<Monomial>) {
    match variables {
        _ if degree == 0 => found.push(Monomial::from_powers(powers.clone())),
        [] => {}
        [first, rest @ ..] => {
            collect(rest, degree, powers, found);
            for exponent in 1..=degree {
                powers.push((*first, exponent));
                collect(rest, degree - exponent, powers, found);
                powers.pop();
            }
        }
    }
}

impl Ord for Monomial {
    fn cmp(&self, other: &Self) -> Ordering {
        self.degree.cmp(&other.degree).then_with(|| {
            let mut pairs = self.powers.iter().rev().zip(other.powers.iter().rev());
            match pairs.find(|(a, b)| a != b) {
                // The one with the later variable, or more of the same one, is smaller.
                Some(((a, e), (b, f))) => b.cmp(a).then(f.cmp(e)),
                None => Ordering::Equal,
            }
        })
    }
}

impl PartialOrd for Monomial {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
