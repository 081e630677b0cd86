//! Square roots in K, where they exist.

use super::field::FieldElement;
use super::integer::Integer;

impl FieldElement {
    /// An element whose square this is, if K has one; of the two, the one that this computation finds.
    ///
    /// Let √d be the last root of K and L the field without it. If a + b√d = (s + t√d)² with a, b, s, t in L, then
    /// a = s² + dt² and b = 2st, so that a² − db² = (s² − dt²)² is a square n² in L, and s² = (a ± n)/2.
    pub fn square_root(&self) -> Option<FieldElement> {
        self.root_without(self.field().radicands().len())
    }

    /// The square root in the field of the first `rank` radicands, in which this lies.
    fn root_without(&self, rank: usize) -> Option<FieldElement> {
        let field = self.field();
        if self.is_zero() {
            return Some(self.clone());
        }
        let Some(bit) = rank.checked_sub(1) else { return self.rational_root() };
        let d = field.integer(field.radicands()[bit].into());
        let (a, b) = self.split(bit);
        let with_root = |s: FieldElement, t: FieldElement| &s + &t.times_root(bit);
        if b.is_zero() {
            // (s + t√d)² has no √d: s = 0 or t = 0.
            let plain = a.root_without(bit);
            let over_d = || Some((&a * &d.inverse()?).root_without(bit)?.times_root(bit));
            return plain.or_else(over_d);
        }
        let n = (&(&a * &a) - &(&d * &(&b * &b))).root_without(bit)?;
        let half = field.rational(Integer::one(), Integer::from(2u32));
        [&a + &n, &a - &n].iter().find_map(|twice| {
            let s = (twice * &half).root_without(bit)?;
            let t = &(&b * &half) * &s.inverse()?;
            Some(with_root(s, t))
        })
    }

    /// The primes p₁, …, up to a largest one, such that this is a square in K(√p₁, …): where it is d times a square of K,
    /// those that divide the rational integer d to an odd power and are not radicands of K. `None` where there is no
    /// such d, where it is negative, or where a prime is larger.
    pub fn radicands_of_root(&self, largest: u32) -> Option<Vec<u32>> {
        if self.is_zero() {
            return Some(Vec::new());
        }
        let mut rest = self.square_class(self.field().radicands().len())?;
        if rest.is_negative() {
            return None;
        }
        let mut primes = Vec::new();
        // Every p that divides what is left is prime, and so is what is left when it is below p².
        for p in 2..=largest {
            let below = rest.to_i64().is_some_and(|rest| rest < i64::from(p) * i64::from(p));
            if let Some(last) = rest.to_i64().filter(|&rest| below && rest > 1) {
                primes.push(u32::try_from(last).ok().filter(|&last| last <= largest)?);
                rest = Integer::one();
            }
            let mut odd = false;
            while rest.residue(p.into()) == 0 {
                rest = rest.exact_quotient(&Integer::from(p));
                odd = !odd;
            }
            if odd {
                primes.push(p);
            }
            if rest.is_one() {
                break;
            }
        }
        let root = rest.floor_sqrt();
        primes.retain(|p| !self.field().radicands().contains(p));
        (&root * &root == rest).then_some(primes)
    }

    /// A rational integer d for which this, not 0 and in the field of the first `rank` radicands, is d times a square of
    /// that field, if there is one: the descent of [`Self::square_root`]. If a + b√D = d·(s + t√D)², then
    /// a² − Db² = d²(s² − Dt²)² is a square n², and d·s² = (a ± n)/2.
    fn square_class(&self, rank: usize) -> Option<Integer> {
        let field = self.field();
        let Some(bit) = rank.checked_sub(1) else {
            return Some(&self.numerators()[0] * self.denominator());
        };
        let (a, b) = self.split(bit);
        if b.is_zero() {
            return a.square_class(bit);
        }
        let radicand = field.integer(field.radicands()[bit].into());
        let n = (&(&a * &a) - &(&radicand * &(&b * &b))).root_without(bit)?;
        let half = field.rational(Integer::one(), Integer::from(2u32));
        [&a + &n, &a - &n].iter().find_map(|twice| (twice * &half).square_class(bit))
    }

    /// (a, b) with self = a + b√d, d the radicand of `bit`, both without √d.
    fn split(&self, bit: usize) -> (FieldElement, FieldElement) {
        let part = |with_root: bool| {
            let mut numerators = vec![Integer::zero(); self.field().degree()];
            for (subset, numerator) in self.numerators().iter().enumerate() {
                if (subset >> bit & 1 == 1) == with_root {
                    numerators[subset & !(1 << bit)] = numerator.clone();
                }
            }
            self.field().element(numerators, self.denominator().clone())
        };
        (part(false), part(true))
    }

    /// self · √d for an element without √d.
    fn times_root(&self, bit: usize) -> FieldElement {
        let mut numerators = vec![Integer::zero(); self.field().degree()];
        for (subset, numerator) in self.numerators().iter().enumerate().filter(|(_, n)| !n.is_zero()) {
            numerators[subset | 1 << bit] = numerator.clone();
        }
        self.field().element(numerators, self.denominator().clone())
    }

    /// √(p/q) = √(pq)/q in Q.
    fn rational_root(&self) -> Option<FieldElement> {
        let square = &self.numerators()[0] * self.denominator();
        if square.is_negative() {
            return None;
        }
        let root = square.floor_sqrt();
        (&root * &root == square).then(|| self.field().rational(root, self.denominator().clone()))
    }
}
