//! The canonical text of a certificate.

use super::seal::seal;
use super::{Argument, Certificate, write_bounds};
use crate::exact::Ring;

impl Certificate {
    /// The text, spelled with the names of the statement's ring.
    pub fn write(&self, ring: &Ring) -> String {
        let mut lines =
            vec!["prove-cap certificate 1".to_owned(), format!("statement sha256 {}", self.statement)];
        let count = match &self.argument {
            Argument::Impossible(steps) => {
                lines.push("claim impossible".into());
                for (number, step) in (1u32..).zip(steps) {
                    lines.push(format!("step {number}"));
                    for (premise, multiplier) in &step.combination {
                        lines.push(format!("add {premise} times {}", ring.spell(multiplier)));
                    }
                    lines.push(format!("conclude {}", ring.spell(&step.conclusion)));
                }
                steps.len()
            }
            Argument::Exact(values) => {
                lines.push("claim exact".into());
                for (name, value) in ring.variables.iter().zip(values) {
                    lines.push(format!("value {name} = {}", ring.spell(value)));
                }
                values.len()
            }
            Argument::Cover(cover) => return sealed(lines, write_bounds::cover(cover, ring)),
            Argument::Bounds(bounds) => return sealed(lines, write_bounds::bounds(bounds, ring)),
            Argument::Unreachable(argument) => {
                return sealed(lines, write_bounds::unreachable(argument, ring));
            }
        };
        lines.push(format!("end {count}"));
        lines.push(String::new());
        lines.join("\n")
    }
}

/// Header and body with the line that seals them.
fn sealed(mut lines: Vec<String>, (body, count): (Vec<String>, usize)) -> String {
    lines.extend(body);
    lines.push(String::new());
    let text = lines.join("\n");
    let last = seal(&text, count);
    text + &last + "\n"
}
