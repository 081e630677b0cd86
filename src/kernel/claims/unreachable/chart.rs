//! The charts that cover the space of the unknowns, and sums of sides in them.

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::One;

use super::Odds;
use crate::claims::subdivision::{Form, Side};
use crate::equations::{S, T};
use crate::exact::{Limit, Monomial, Polynomial, Stop, Work, bytes};

/// Which unknown is the largest in a chart, and its sign; none in the first.
pub(super) fn far(number: usize) -> Option<(usize, bool)> {
    let index = number.checked_sub(1)?;
    Some((index.checked_div(2)?, index.checked_rem(2)? == 1))
}

/// A side along the patch, in the unknowns, t and s.
pub(super) struct Along {
    polynomial: Polynomial,
    /// The largest total degree in the unknowns.
    degree: u32,
    /// The largest exponent of each unknown that occurs, of t and of s.
    degrees: BTreeMap<u16, u32>,
    /// A common denominator of the coefficients.
    denominator: BigInt,
}

impl Along {
    pub(super) fn new(polynomial: Polynomial, work: &mut Work) -> Result<Self, Limit> {
        let (mut degree, mut degrees, mut denominator) = (0, BTreeMap::new(), BigInt::one());
        for (monomial, value) in polynomial.terms() {
            work.charge_each(monomial.powers().len(), Work::POWER)?;
            degree = degree.max(monomial.split(T).0.degree());
            for &(variable, exponent) in monomial.powers() {
                match degrees.entry(variable) {
                    Entry::Occupied(mut known) => *known.get_mut() = exponent.max(*known.get()),
                    Entry::Vacant(entry) => {
                        work.keep(64)?;
                        entry.insert(exponent);
                    }
                }
            }
            denominator = work.common_multiple(&denominator, value.denom())?;
        }
        Ok(Along { polynomial, degree, degrees, denominator })
    }
}

/// A side at a sample, in the variables of a chart: like terms collected, the power of h apart, integers over
/// a denominator.
struct AtSample {
    terms: BTreeMap<(Monomial, u32), BigInt>,
    denominator: BigInt,
    /// The exponents of h, also in terms that are 0.
    least: u32,
    most: u32,
}

/// The variables that occur in a sum, each with its place among the axes of a form and its degree.
type Axes = BTreeMap<usize, (usize, usize)>;

/// One chart.
pub(super) struct Chart<'a> {
    /// The unknown that is ±range/h, and whether it is negative.
    pub(super) far: Option<(usize, bool)>,
    pub(super) range: &'a mut Powers,
    pub(super) samples: &'a [[Odds; 2]],
    pub(super) sides: &'a BTreeMap<Side, Along>,
    /// What sides at samples are, computed once for a chart; the last number is the degree to which all were
    /// brought.
    known: BTreeMap<(Side, usize, u32), AtSample>,
}

impl<'a> Chart<'a> {
    pub(super) fn new(
        far: Option<(usize, bool)>,
        range: &'a mut Powers,
        samples: &'a [[Odds; 2]],
        sides: &'a BTreeMap<Side, Along>,
    ) -> Self {
        Chart { far, range, samples, sides, known: BTreeMap::new() }
    }

    /// Σ factor·side at its sample, times a power of h, and which variables its axes are.
    pub(super) fn sum(
        &mut self,
        sum: &[(BigInt, Side, usize)],
        masks: usize,
        work: &mut Work,
    ) -> Result<(Form, Vec<usize>), Stop> {
        // All of them are brought to the largest degree.
        let mut degree = 0;
        for (_, side, _) in sum {
            degree = degree.max(self.side(*side)?.degree);
        }
        let mut denominator = BigInt::one();
        let (mut least, mut most) = (u32::MAX, 0);
        for &(_, side, sample) in sum {
            self.know((side, sample, degree), work)?;
            let known = self.known((side, sample, degree))?;
            denominator = work.common_multiple(&denominator, &known.denominator)?;
            (least, most) = (least.min(known.least), most.max(known.most));
        }
        let axes = self.axes(sum, most.saturating_sub(least), work)?;
        let form = Form::counted(work, |work| {
            let degrees = axes.values().map(|(_, degree)| *degree).collect();
            let mut form = Form::zero(degrees, masks, work)?;
            for (factor, side, sample) in sum {
                let known = self.known((*side, *sample, degree))?;
                let cofactor = work.quotient(&denominator, &known.denominator)?;
                let factor = work.product(factor, &cofactor)?;
                self.add(known, &factor, least, (&mut form, &axes), work)?;
            }
            Ok(form)
        })?;
        Ok((form, axes.into_keys().collect()))
    }

    /// Adds a multiple of a side at a sample to a form, divided by a power of h that all terms have: h > 0
    /// for all values that the chart is about.
    fn add(
        &self,
        known: &AtSample,
        factor: &BigInt,
        least: u32,
        (form, axes): (&mut Form, &Axes),
        work: &mut Work,
    ) -> Result<(), Stop> {
        let mut exponents = vec![0usize; axes.len()];
        for ((monomial, of_h), value) in &known.terms {
            work.charge_each(exponents.len().saturating_add(monomial.powers().len()), Work::POWER)?;
            exponents.fill(0);
            let of_h = self.far.map(|(far, _)| (far, of_h.saturating_sub(least)));
            let powers =
                monomial.powers().iter().map(|&(variable, exponent)| (usize::from(variable), exponent));
            for (variable, exponent) in powers.chain(of_h).filter(|&(_, exponent)| exponent > 0) {
                let place = axes.get(&variable).and_then(|(place, _)| exponents.get_mut(*place));
                let place = place.ok_or(Stop::Defect("a variable that is no axis of its form"))?;
                *place = usize::try_from(exponent).unwrap_or(usize::MAX);
            }
            form.add(&exponents, monomial.mask(), [value, factor], work)?;
        }
        Ok(())
    }

    /// The variables that occur, each with its place among the axes and its degree; h is in the place of the
    /// unknown that is far.
    fn axes(&self, sum: &[(BigInt, Side, usize)], of_h: u32, work: &mut Work) -> Result<Axes, Stop> {
        let mut largest: BTreeMap<usize, u32> = BTreeMap::new();
        let mut seen = Vec::with_capacity(3);
        for (_, side, _) in sum {
            if seen.contains(side) {
                continue;
            }
            seen.push(*side);
            let degrees = &self.side(*side)?.degrees;
            work.charge_each(degrees.len(), Work::TERM)?;
            for (&variable, &exponent) in degrees.iter().filter(|(variable, _)| **variable < T) {
                let known = largest.entry(usize::from(variable)).or_default();
                *known = exponent.max(*known);
            }
        }
        if let Some((far, _)) = self.far {
            largest.insert(far, of_h);
        }
        work.charge_each(largest.len(), Work::TERM)?;
        let occurring = largest.into_iter().filter(|(_, degree)| *degree > 0);
        let axes = (0usize..).zip(occurring).map(|(place, (variable, degree))| {
            (variable, (place, usize::try_from(degree).unwrap_or(usize::MAX)))
        });
        Ok(axes.collect())
    }

    fn side(&self, side: Side) -> Result<&'a Along, Stop> {
        self.sides.get(&side).ok_or(Stop::Defect("a side that was not derived"))
    }

    fn known(&self, key: (Side, usize, u32)) -> Result<&AtSample, Stop> {
        self.known.get(&key).ok_or(Stop::Defect("a side that was not put at its sample"))
    }

    /// Puts a side at a sample, unless that has been done.
    fn know(&mut self, key: (Side, usize, u32), work: &mut Work) -> Result<(), Stop> {
        work.charge(Work::TERM)?;
        if !self.known.contains_key(&key) {
            work.keep(512)?;
            let (side, sample, degree) = key;
            let odds = sample.checked_sub(1).and_then(|index| self.samples.get(index));
            // The reader has refused samples that do not exist.
            let odds = odds.ok_or(Stop::Defect("a sample that does not exist"))?;
            let at_sample = self.at_sample(self.side(side)?, odds, degree, work)?;
            self.known.insert(key, at_sample);
        }
        Ok(())
    }

    /// With t, s and the unknowns replaced: x = R·ξ/h, or ±R/h for the one that is far, and all times h to
    /// the degree.
    fn at_sample(
        &mut self,
        along: &Along,
        odds: &[Odds; 2],
        degree: u32,
        work: &mut Work,
    ) -> Result<AtSample, Stop> {
        let [of_u, of_v] = odds;
        let of_u = OddsPowers::new(of_u, along.degrees.get(&T).copied().unwrap_or(0), work)?;
        let of_v = OddsPowers::new(of_v, along.degrees.get(&S).copied().unwrap_or(0), work)?;
        let denominator = work.product(&along.denominator, &of_u.denominator)?;
        let denominator = work.product(&denominator, &of_v.denominator)?;
        let mut result = AtSample { terms: BTreeMap::new(), denominator, least: u32::MAX, most: 0 };
        for (monomial, value) in along.polynomial.terms() {
            work.charge(Work::TERM)?;
            work.charge_each(monomial.powers().len(), Work::POWER)?;
            let (a, b) = (monomial.exponent(T), monomial.exponent(S));
            let (unknowns, _) = monomial.split(T);
            let total = unknowns.degree();
            let raised = of_u.of_h(a).saturating_add(of_v.of_h(b));
            let mut of_h = degree.saturating_sub(total).saturating_add(raised);
            (result.least, result.most) = (result.least.min(of_h), result.most.max(of_h));
            let mut number = self.value(value, along, (total, a, b), [&of_u, &of_v], work)?;
            let mut unknowns = unknowns;
            if let Some((far, negative)) = self.far {
                let far = u16::try_from(far).map_err(|_| Stop::Defect("an unknown beyond all variables"))?;
                if negative && unknowns.exponent(far).checked_rem(2) == Some(1) {
                    number = work.difference(&BigInt::ZERO, &number)?;
                }
                unknowns = unknowns.lowered(far, 0);
            } else {
                of_h = 0;
            }
            match result.terms.entry((unknowns, of_h)) {
                Entry::Occupied(mut known) => work.add(known.get_mut(), &number)?,
                Entry::Vacant(entry) => {
                    let (monomial, _) = entry.key();
                    work.keep(monomial.bytes().saturating_add(bytes(&number)).saturating_add(256))?;
                    entry.insert(number);
                }
            }
        }
        Ok(result)
    }

    /// A coefficient times the powers of R and of the odds, over the common denominator.
    fn value(
        &mut self,
        value: &BigRational,
        along: &Along,
        (total, a, b): (u32, u32, u32),
        [of_u, of_v]: [&OddsPowers; 2],
        work: &mut Work,
    ) -> Result<BigInt, Stop> {
        let cofactor = work.quotient(&along.denominator, value.denom())?;
        let mut number = work.product(value.numer(), &cofactor)?;
        let power = self.range.get(total, work)?;
        number = work.product(&number, power)?;
        number = work.product(&number, of_u.get(a)?)?;
        Ok(work.product(&number, of_v.get(b)?)?)
    }
}

/// Powers of a number, each the one before it times the first.
pub(super) struct Powers {
    powers: Vec<BigInt>,
    base: BigInt,
}

impl Powers {
    pub(super) fn new(base: &BigInt, work: &mut Work) -> Result<Self, Limit> {
        Ok(Powers { powers: vec![BigInt::one()], base: work.copied(base)? })
    }

    fn get(&mut self, exponent: u32, work: &mut Work) -> Result<&BigInt, Stop> {
        let wanted = usize::try_from(exponent).unwrap_or(usize::MAX);
        while self.powers.len() <= wanted {
            let last = self.powers.last().ok_or(Stop::Defect("no power"))?;
            let next = work.product(last, &self.base)?;
            work.keep(bytes(&next).saturating_add(64))?;
            self.powers.push(next);
        }
        self.powers.get(wanted).ok_or(Stop::Defect("no power"))
    }
}

/// Powers of odds p/q as integers over q^A: p^a·q^(A−a) for a from 0 to A.
struct OddsPowers {
    powers: Vec<BigInt>,
    denominator: BigInt,
    shrinking: bool,
}

impl OddsPowers {
    fn new(odds: &Odds, largest: u32, work: &mut Work) -> Result<Self, Stop> {
        let mut of_p = Powers::new(odds.value.numer(), work)?;
        let mut of_q = Powers::new(odds.value.denom(), work)?;
        let mut powers = Vec::new();
        for a in 0..=largest {
            let rest = largest.saturating_sub(a);
            let (p, q) = (of_p.get(a, work)?, of_q.get(rest, work)?);
            let power = work.product(p, q)?;
            work.keep(bytes(&power).saturating_add(64))?;
            powers.push(power);
        }
        let denominator = of_q.get(largest, work)?;
        let denominator = work.copied(denominator)?;
        Ok(OddsPowers { powers, denominator, shrinking: odds.shrinking })
    }

    fn get(&self, exponent: u32) -> Result<&BigInt, Stop> {
        let power = usize::try_from(exponent).ok().and_then(|exponent| self.powers.get(exponent));
        power.ok_or(Stop::Defect("a power of the odds beyond the largest"))
    }

    /// By how much an exponent of the parameter raises that of h.
    fn of_h(&self, exponent: u32) -> u32 {
        if self.shrinking { exponent } else { 0 }
    }
}
