//! The strict reader, continued: arguments by subdivision.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Signed;

use super::bounds::{Bounds, End, Odds, Quantity, Region, Side, Tree, Units, Unreachable};
use super::cover::{Cover, EDGES, EdgeTree};
use super::error::{CertificateError, CertificateFault as Fault};
use super::read::{Reader, column};
use super::seal::seal;
use crate::exact::{Limit, Polynomial, limits, read_natural};

impl Reader<'_, '_> {
    /// After `claim bounds`.
    pub(super) fn bounds(&mut self) -> Result<Bounds, CertificateError> {
        let values = self.values()?;
        let (quantity, places) = self.quantity()?;
        let denominator = self.named_tree("denominator ", "`denominator ` and a tree of `h` and `.`")?;
        let lower = self.end("lower ", places)?;
        let upper = self.end("upper ", places)?;
        let boxes = [&denominator, &lower.tree, &upper.tree].map(leaves);
        self.sealed(boxes.iter().fold(0, |sum, &count| count.saturating_add(sum)))?;
        Ok(Bounds { values, quantity, places, denominator, lower, upper })
    }

    /// After `claim cover`.
    pub(super) fn cover(&mut self) -> Result<Cover, CertificateError> {
        let values = self.values()?;
        let denominator = self.named_tree("denominator ", "`denominator ` and a tree of `h` and `.`")?;
        let mut edges = EDGES.map(|_| EdgeTree::Point);
        for (name, edge) in EDGES.iter().zip(&mut edges) {
            let expected = "`edge `, the next of u=0, u=1, v=0, v=1, and `point` or `arc TREE`";
            let line = self.next(expected)?;
            let rest = line.strip_prefix("edge ").and_then(|rest| rest.strip_prefix(name));
            match rest.ok_or_else(|| self.unexpected(line, expected))? {
                " point" => {}
                rest => {
                    let tree = rest.strip_prefix(" arc ").ok_or_else(|| self.unexpected(line, expected))?;
                    *edge = EdgeTree::Arc(self.tree(line, tree)?);
                }
            }
        }
        let expected = "`regular outward ` or `regular inward ` and a tree of `h` and `.`";
        let line = self.next(expected)?;
        let (inward, tree) = match line.strip_prefix("regular ").and_then(|rest| rest.split_once(' ')) {
            Some(("inward", tree)) => (true, tree),
            Some(("outward", tree)) => (false, tree),
            _ => return Err(self.unexpected(line, expected)),
        };
        let regular = self.tree(line, tree)?;
        let cover = Cover { values, denominator, edges, inward, regular };
        self.sealed(cover.trees().fold(0, |sum, tree| leaves(tree).saturating_add(sum)))?;
        Ok(cover)
    }

    /// A word and a tree.
    fn named_tree(&mut self, name: &str, expected: &'static str) -> Result<Tree, CertificateError> {
        let line = self.next(expected)?;
        let tree = line.strip_prefix(name).ok_or_else(|| self.unexpected(line, expected))?;
        self.tree(line, tree)
    }

    /// `quantity radius 12`.
    fn quantity(&mut self) -> Result<(Quantity, u32), CertificateError> {
        let expected = "`quantity radius ` or `quantity ratio ` and the number of decimal places";
        let line = self.next(expected)?;
        let rest = line.strip_prefix("quantity ").and_then(|rest| rest.split_once(' '));
        let quantity = match rest {
            Some(("radius", _)) => Quantity::Radius,
            Some(("ratio", _)) => Quantity::Ratio,
            _ => return Err(self.unexpected(line, expected)),
        };
        let places = self.index(rest.map_or("", |(_, places)| places))?;
        if places > limits::PLACES {
            return Err(self.fail(1, Limit::new("decimal places", limits::PLACES.into()).into()));
        }
        Ok((quantity, places))
    }

    /// `lower 0.9 at 1/2 1/2 over h..`.
    fn end(&mut self, name: &'static str, places: u32) -> Result<End, CertificateError> {
        let expected = match name {
            "lower " => "`lower DECIMAL at U V over TREE`",
            _ => "`upper DECIMAL at U V over TREE`",
        };
        let line = self.next(expected)?;
        let parts = line.strip_prefix(name).and_then(|rest| {
            let (decimal, rest) = rest.split_once(" at ")?;
            let (point, tree) = rest.split_once(" over ")?;
            let (u, v) = point.split_once(' ')?;
            Some((decimal, u, v, tree))
        });
        let (decimal, u, v, tree) = parts.ok_or_else(|| self.unexpected(line, expected))?;
        let bound = self.decimal(decimal, places)?;
        let at = [self.rational(line, u)?, self.rational(line, v)?];
        if at.iter().any(|x| x.is_negative() || x.numer() > x.denom()) {
            return Err(self.fail(1, Fault::OutsideSquare));
        }
        Ok(End { bound, at, tree: self.tree(line, tree)? })
    }

    /// A rational number, which is a polynomial of a kind.
    fn rational(&mut self, line: &str, spelled: &str) -> Result<BigRational, CertificateError> {
        let at = line.find(spelled).unwrap_or(0);
        let number =
            self.polynomial(line.get(..at.saturating_add(spelled.len())).unwrap_or(line), spelled)?;
        number.as_rational().ok_or_else(|| self.fail(at.saturating_add(1), Fault::NotRational))
    }

    /// A decimal with this many places.
    fn decimal(&self, text: &str, places: u32) -> Result<Units, CertificateError> {
        let wrong = || self.fail(1, Fault::Decimal { places, found: text.chars().take(60).collect() });
        let (negative, digits) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (whole, decimals) = match places {
            0 => (digits, ""),
            _ => digits.split_once('.').ok_or_else(wrong)?,
        };
        let is_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
        let length = u32::try_from(decimals.len()).unwrap_or(u32::MAX);
        if whole.is_empty() || !is_digits(whole) || !is_digits(decimals) || length != places {
            return Err(wrong());
        }
        if digits.len() > limits::DIGITS {
            return Err(self.fail(1, Limit::digits().into()));
        }
        let units: BigInt = format!("{whole}{decimals}").parse().map_err(|_| wrong())?;
        Ok(if negative { -units } else { units })
    }

    fn tree(&self, line: &str, text: &str) -> Result<Tree, CertificateError> {
        if text.len() > limits::BOXES {
            return Err(self.fail(1, Limit::new("boxes", 1_000_000).into()));
        }
        // As many boxes are still to come as were opened by halving and not closed yet.
        let (mut open, mut tree) = (1usize, Tree::with_capacity(text.len()));
        for (position, byte) in (0usize..).zip(text.bytes()) {
            let halved = match byte {
                b'h' => true,
                b'.' => false,
                _ => return Err(self.fail(column(line, text).saturating_add(position), Fault::Tree)),
            };
            let next = if halved { open.checked_add(1) } else { open.checked_sub(1) };
            open = next.filter(|_| open > 0).ok_or_else(|| self.fail(column(line, text), Fault::Tree))?;
            tree.push(halved);
        }
        if open != 0 {
            return Err(self.fail(line.len().saturating_add(1), Fault::Tree));
        }
        Ok(tree)
    }

    /// After `claim unreachable`.
    pub(super) fn unreachable(&mut self) -> Result<Unreachable, CertificateError> {
        let (quantity, places) = self.quantity()?;
        let expected = "`between ` and two decimals";
        let line = self.next(expected)?;
        let pair = line.strip_prefix("between ").and_then(|rest| rest.split_once(' '));
        let (low, high) = pair.ok_or_else(|| self.unexpected(line, expected))?;
        let (lower, upper) = (self.decimal(low, places)?, self.decimal(high, places)?);
        let expected = "`product`, `put` or `range`";
        let mut line = self.next(expected)?;
        let mut products = Vec::new();
        while let Some(text) = line.strip_prefix("product ") {
            let pair = text.split_once('*').and_then(|(z, w)| Some((self.unknown(z)?, self.unknown(w)?)));
            let pair = pair.filter(|(z, w)| z != w && products.len() < self.unknowns);
            products.push(pair.ok_or_else(|| self.unexpected(line, "`product ` and two unknowns, z*w"))?);
            line = self.next(expected)?;
        }
        let mut forms: Vec<(u16, Polynomial)> = Vec::new();
        while let Some(text) = line.strip_prefix("put ") {
            let form = self.form(line, text, forms.last().map(|(before, _)| *before))?;
            forms.push(form);
            line = self.next("`put` or `range`")?;
        }
        let range = line.strip_prefix("range ").filter(|digits| digits.len() <= limits::DIGITS);
        let range = range
            .and_then(|digits| read_natural(digits).ok())
            .filter(|(range, rest)| rest.is_empty() && range.is_positive());
        let (range, _) = range.ok_or_else(|| self.unexpected(line, "`range ` and a positive integer"))?;
        let (samples, charts) = self.charts()?;
        Ok(Unreachable { quantity, places, lower, upper, products, forms, range, samples, charts })
    }

    /// `z = 500*z + 3*w`: in the order of the unknowns, each once; its form is not the unknown alone, but contains it.
    fn form(
        &mut self,
        line: &str,
        text: &str,
        before: Option<u16>,
    ) -> Result<(u16, Polynomial), CertificateError> {
        let expected = "`put`, a later unknown than before, ` = ` and another form of degree 1 with rational \
                        coefficients in the unknowns, which contains this one";
        let parts = text.split_once(" = ").and_then(|(name, form)| Some((self.unknown(name)?, form)));
        let (unknown, spelled) = parts
            .filter(|(unknown, _)| before.is_none_or(|before| before < *unknown))
            .ok_or_else(|| self.unexpected(line, expected))?;
        let form = self.polynomial(line, spelled)?;
        let is_unknown = |&(k, _): &(u16, u32)| usize::from(k) < self.unknowns;
        let affine = form.terms().all(|(monomial, _)| {
            monomial.mask() == 0 && monomial.degree() <= 1 && monomial.powers().iter().all(is_unknown)
        });
        let contains = form.terms().any(|(monomial, _)| monomial.exponent(unknown) == 1);
        match affine && contains && form != Polynomial::variable(unknown) {
            true => Ok((unknown, form)),
            false => Err(self.unexpected(line, expected)),
        }
    }

    fn unknown(&self, name: &str) -> Option<u16> {
        let position = self.ring.variables.iter().take(self.unknowns).position(|unknown| unknown == name)?;
        u16::try_from(position).ok()
    }

    #[expect(clippy::type_complexity, reason = "the two lists that the lines make up")]
    fn charts(&mut self) -> Result<(Vec<[Odds; 2]>, Vec<Vec<Region>>), CertificateError> {
        let mut samples = Vec::new();
        let mut charts: Vec<Vec<Region>> = Vec::new();
        let (mut open, mut boxes) = (0usize, 0usize);
        loop {
            let expected = match (charts.len(), open) {
                (0, _) => "`sample` or `chart 1`",
                (_, 0) => "the next `chart`, or `end`",
                _ => "`halve` or `exclude …`",
            };
            let line = self.next(expected)?;
            if let Some(text) = line.strip_prefix("sample ").filter(|_| charts.is_empty()) {
                samples.push(self.sample(line, text, samples.len().saturating_add(1))?);
            } else if open > 0 {
                let region = match line.strip_prefix("exclude ") {
                    Some(text) => {
                        boxes = boxes.saturating_add(1);
                        open = open.saturating_sub(1);
                        Region::Excluded(self.sum(line, text, samples.len())?)
                    }
                    None if line == "halve" => {
                        open = open.saturating_add(1);
                        Region::Halved
                    }
                    None => return Err(self.unexpected(line, expected)),
                };
                if boxes.saturating_add(open) > limits::BOXES {
                    return Err(self.fail(1, Limit::new("boxes", 1_000_000).into()));
                }
                if let Some(chart) = charts.last_mut() {
                    chart.push(region);
                }
            } else if charts.len() == Unreachable::chart_count(self.unknowns) {
                self.check_seal(line, boxes)?;
                return Ok((samples, charts));
            } else {
                let number = charts.len().saturating_add(1);
                if line != format!("chart {number}") {
                    return Err(self.unexpected(line, expected));
                }
                charts.push(Vec::new());
                open = 1;
            }
        }
    }

    /// `1 at 1/2 3*h`.
    fn sample(&mut self, line: &str, text: &str, number: usize) -> Result<[Odds; 2], CertificateError> {
        let expected = "`sample`, the next number, ` at ` and two odds";
        let odds = text.split_once(" at ").filter(|(found, _)| *found == number.to_string());
        let pair = odds.and_then(|(_, odds)| odds.split_once(' '));
        let (u, v) = pair.ok_or_else(|| self.unexpected(line, expected))?;
        if number > limits::SAMPLES {
            return Err(self.fail(1, Limit::new("samples", 10_000).into()));
        }
        let mut read = |odds: &str| {
            let (value, shrinking) = match odds.strip_suffix("*h") {
                Some(value) => (value, true),
                None => (odds, false),
            };
            let value = self.rational(line, value)?;
            match value.is_negative() {
                true => Err(self.fail(1, Fault::OutsideSquare)),
                false => Ok(Odds { value, shrinking }),
            }
        };
        Ok([read(u)?, read(v)?])
    }

    /// `3*upper[1] + 2*lower[2]`: sides in their order, by sample, each once.
    fn sum(
        &self,
        line: &str,
        text: &str,
        samples: usize,
    ) -> Result<Vec<(BigInt, Side, usize)>, CertificateError> {
        let expected = "`exclude ` and a sum of terms N*lower[k], N*upper[k], N*weight[k] in order";
        let mut sum: Vec<(BigInt, Side, usize)> = Vec::new();
        for part in text.split(" + ") {
            let term = part.split_once('*').filter(|(factor, _)| factor.len() <= limits::DIGITS).and_then(
                |(factor, name)| {
                    let (factor, rest) = read_natural(factor).ok()?;
                    let (name, index) = name.strip_suffix(']')?.split_once('[')?;
                    let side = [Side::Lower, Side::Upper, Side::Weight]
                        .into_iter()
                        .find(|side| side.name() == name)?;
                    let index: usize = index.parse().ok()?;
                    (rest.is_empty() && factor.is_positive() && (1..=samples).contains(&index))
                        .then_some((factor, side, index))
                },
            );
            let term = term.ok_or_else(|| self.unexpected(line, expected))?;
            if sum.last().is_some_and(|(_, side, index)| (*side, *index) >= (term.1, term.2)) {
                return Err(self.unexpected(line, expected));
            }
            sum.push(term);
        }
        Ok(sum)
    }

    fn sealed(&mut self, count: usize) -> Result<(), CertificateError> {
        let line = self.next("`end`, the number of boxes and a hash")?;
        self.check_seal(line, count)
    }

    /// The last line is what the text before it calls for.
    fn check_seal(&self, line: &str, count: usize) -> Result<(), CertificateError> {
        let before = self.text.rfind("\nend ").map_or(0, |at| at.saturating_add(1));
        let expected = seal(self.text.get(..before).unwrap_or(""), count);
        match line == expected {
            true => Ok(()),
            false => Err(self.fail(1, Fault::Seal { expected, found: line.chars().take(90).collect() })),
        }
    }
}

/// The boxes that are not halved.
fn leaves(tree: &Tree) -> usize {
    tree.iter().filter(|halved| !**halved).count()
}
