//! What the texts of arguments by subdivision have in common: quantities, decimals, trees, and the seal.

use num_rational::BigRational;

use super::{Quantity, Tree, Units};
use crate::exact::limits;
use crate::text::{CertificateError, CertificateFault as Fault, Reader, column, seal};

impl Reader<'_, '_> {
    /// A word and a tree.
    pub(in crate::claims) fn named_tree(
        &mut self,
        name: &str,
        expected: &'static str,
    ) -> Result<Tree, CertificateError> {
        let line = self.next(expected)?;
        let tree = line.strip_prefix(name).ok_or_else(|| self.unexpected(line, expected))?;
        self.tree(line, tree)
    }

    /// `quantity radius 12`.
    pub(in crate::claims) fn quantity(&mut self) -> Result<(Quantity, u32), CertificateError> {
        let expected = "`quantity radius ` or `quantity ratio ` and the number of decimal places";
        let line = self.next(expected)?;
        let rest = line.strip_prefix("quantity ").and_then(|rest| rest.split_once(' '));
        let quantity = match rest {
            Some(("radius", _)) => Quantity::Radius,
            Some(("ratio", _)) => Quantity::Ratio,
            _ => return Err(self.unexpected(line, expected)),
        };
        let places = self.index(rest.map_or("", |(_, places)| places))?;
        self.limited(limits::PLACES.check(places))?;
        Ok((quantity, places))
    }

    /// A rational number, which is a polynomial of a kind.
    pub(in crate::claims) fn rational(
        &mut self,
        line: &str,
        spelled: &str,
    ) -> Result<BigRational, CertificateError> {
        let at = line.find(spelled).unwrap_or(0);
        let number =
            self.polynomial(line.get(..at.saturating_add(spelled.len())).unwrap_or(line), spelled)?;
        number.as_rational().ok_or_else(|| self.fail(at.saturating_add(1), Fault::NotRational))
    }

    /// A decimal with this many places.
    pub(in crate::claims) fn decimal(&mut self, text: &str, places: u32) -> Result<Units, CertificateError> {
        let wrong = self.fail(1, Fault::Decimal { places, found: text.chars().take(60).collect() });
        let (negative, digits) = match text.strip_prefix('-') {
            Some(rest) => (true, rest),
            None => (false, text),
        };
        let (whole, decimals) = match places {
            0 => (digits, ""),
            _ => digits.split_once('.').ok_or_else(|| wrong.clone())?,
        };
        let is_digits = |part: &str| part.bytes().all(|byte| byte.is_ascii_digit());
        let length = u32::try_from(decimals.len()).unwrap_or(u32::MAX);
        if whole.is_empty() || !is_digits(whole) || !is_digits(decimals) || length != places {
            return Err(wrong);
        }
        self.limited(limits::DIGITS.check(digits.len()))?;
        // It is read now, and written to compare the text and for the sentence.
        self.charge_digits(digits.len().saturating_mul(4))?;
        let sign = if negative { "-" } else { "" };
        format!("{sign}{whole}{decimals}").parse().map_err(|_| wrong)
    }

    /// A tree, `h` for a box that is halved and `.` for one that is not.
    pub(in crate::claims) fn tree(&self, line: &str, text: &str) -> Result<Tree, CertificateError> {
        self.limited(limits::BOXES.check(text.len()))?;
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

    /// The last line, with this number of boxes.
    pub(in crate::claims) fn sealed(&mut self, count: usize) -> Result<(), CertificateError> {
        let line = self.next("`end`, the number of boxes and a hash")?;
        self.check_seal(line, count)
    }

    /// The last line is what the text before it calls for.
    pub(in crate::claims) fn check_seal(&self, line: &str, count: usize) -> Result<(), CertificateError> {
        let before = self.text.rfind("\nend ").map_or(0, |at| at.saturating_add(1));
        let expected = seal(self.text.get(..before).unwrap_or(""), count);
        match line == expected {
            true => Ok(()),
            false => Err(self.fail(1, Fault::Seal { expected, found: line.chars().take(90).collect() })),
        }
    }
}

/// `quantity radius 12`.
pub(in crate::claims) fn quantity(quantity: Quantity, places: u32) -> String {
    match quantity {
        Quantity::Radius => format!("quantity radius {places}"),
        Quantity::Ratio => format!("quantity ratio {places}"),
    }
}

/// A tree, a character for each box.
pub(in crate::claims) fn spelled(tree: &Tree) -> String {
    tree.iter().map(|halved| if *halved { 'h' } else { '.' }).collect()
}

/// The lines and the one that seals them.
pub(in crate::claims) fn sealed(lines: Vec<String>, boxes: usize) -> String {
    let mut lines = lines;
    lines.push(String::new());
    let text = lines.join("\n");
    let last = seal(&text, boxes);
    text + &last + "\n"
}

/// The boxes that are not halved.
pub(in crate::claims) fn leaves(tree: &Tree) -> usize {
    tree.iter().filter(|halved| !**halved).count()
}
