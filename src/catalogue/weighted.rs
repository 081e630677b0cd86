//! Edges whose end weights are powers of an unknown d.

use super::cap::Entries;
use crate::algebra::{FieldElement, spell};
use crate::bezier::RationalArc;

/// A rational curve with homogeneous control points Σ arcₖ·dᵏ.
pub(super) struct WeightedArc {
    /// By power of d.
    parts: Vec<RationalArc>,
}

impl WeightedArc {
    /// A quadratic arc between end points of weight 1, reparametrised so that the ends have the weights d^powers.
    ///
    /// The middle weight is multiplied by the square root of the product of both (MATH: Farin, section 12.3).
    pub(super) fn new(arc: &RationalArc, powers: [u32; 2]) -> Self {
        let zero = arc.points[0][0].field().zero();
        let powers = [powers[0], (powers[0] + powers[1]) / 2, powers[1]];
        let part = |power: u32| RationalArc {
            points: std::iter::zip(&arc.points, powers)
                .map(|(point, of_point)| {
                    point.each_ref().map(|x| if of_point == power { x.clone() } else { zero.clone() })
                })
                .collect(),
        };
        WeightedArc { parts: (0..=powers[0].max(powers[2])).map(part).collect() }
    }

    pub(super) fn elevated_to(&self, degree: u32) -> Self {
        WeightedArc { parts: self.parts.iter().map(|part| part.elevated_to(degree)).collect() }
    }

    /// The numbers of a control point as expressions: premultiplied by the weight, or, where the weight is known, not.
    pub(super) fn entries(&self, at: usize, cartesian: bool) -> Entries {
        if cartesian {
            let [.., weight] = &self.parts[0].points[at];
            let inverse = weight.inverse().expect("weights of the edges are not zero");
            let point = &self.parts[0].points[at];
            return std::array::from_fn(|k| {
                spell(&if k < 3 { &point[k] * &inverse } else { weight.clone() })
            });
        }
        std::array::from_fn(|k| {
            let terms = self.parts.iter().enumerate().map(|(power, part)| (power, &part.points[at][k]));
            in_d(terms.filter(|(_, value)| !value.is_zero()))
        })
    }
}

/// Σ value·d^power.
fn in_d<'a>(terms: impl Iterator<Item = (usize, &'a FieldElement)>) -> String {
    let mut text = String::new();
    for (power, value) in terms {
        let number = spell(value);
        let several = number.contains(" + ") || number.contains(" - ");
        let number = if several && power > 0 { format!("({number})") } else { number };
        let term = match (number.as_str(), power) {
            (number, 0) => number.to_owned(),
            ("1", 1) => "d".to_owned(),
            ("1", power) => format!("d^{power}"),
            (number, 1) => format!("{number}*d"),
            (number, power) => format!("{number}*d^{power}"),
        };
        match (text.is_empty(), term.strip_prefix('-')) {
            (true, _) => text = term,
            (false, Some(positive)) => text += &format!(" - {positive}"),
            (false, None) => text += &format!(" + {term}"),
        }
    }
    if text.is_empty() { "0".into() } else { text }
}
