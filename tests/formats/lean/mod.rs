//! Reads the Lean texts back as far as they do algebra, and verifies every identity in them by evaluation at random points modulo a prime.
//!
//! It stands in for `ring`: a false identity of degree d passes with probability d/2⁶¹. It does not stand in for Lean.

mod expression;

use std::collections::BTreeMap;

pub(crate) use expression::{Environment, MODULUS, add, multiply, power};

/// What was verified, by kind.
#[derive(Debug, Default, PartialEq)]
pub(crate) struct Verified {
    pub(crate) linear_combinations: usize,
    pub(crate) rings: usize,
    pub(crate) definitions: usize,
}

/// Verifies a text, or says which line is wrong.
pub(crate) fn verify(text: &str) -> Result<Verified, String> {
    let (_, code) = text.split_once("noncomputable section\n").ok_or("no section")?;
    let mut reader = Reader {
        environment: Environment::random(text.len() as u64),
        rows: BTreeMap::new(),
        verified: Verified::default(),
    };
    for item in code.split("\n\n") {
        let item = item.lines().filter(|line| !line.starts_with("/-")).collect::<Vec<_>>().join("\n");
        let item = item.trim();
        if item.starts_with("def ") {
            reader.definition(item)?;
        } else if item.starts_with("theorem ") {
            reader.theorem(item)?;
        } else if !matches!(item, "" | "end" | "end ProveCap") {
            return Err(format!("what is this? {item}"));
        }
    }
    let (combinations, rings) =
        (code.matches("linear_combination").count(), code.matches("  ring\n").count());
    let seen = (reader.verified.linear_combinations, reader.verified.rings);
    if seen != (combinations, rings) {
        return Err(format!(
            "{seen:?} of {combinations} linear combinations and {rings} rings were looked at"
        ));
    }
    Ok(reader.verified)
}

struct Reader {
    environment: Environment,
    /// The conjuncts of the theorem of each row.
    rows: BTreeMap<String, Vec<u64>>,
    verified: Verified,
}

impl Reader {
    fn definition(&mut self, item: &str) -> Result<(), String> {
        let (head, body) = item.split_once(" : ℝ := ").ok_or("no definition")?;
        let (name, parameters) = named(head.trim_start_matches("def "));
        self.environment.define(name, parameters, body);
        self.verified.definitions += 1;
        Ok(())
    }

    fn theorem(&mut self, item: &str) -> Result<(), String> {
        let (name, parameters) = named(item.trim_start_matches("theorem ").split('\n').next().unwrap_or(""));
        self.environment.hypotheses(item)?;
        if name.starts_with("vanish") {
            return self.vanishing(item);
        }
        // `theorem NAME … : LEFT = RIGHT := by …`
        let proof = item.find(":= by").or_else(|| item.find(":=\n")).ok_or("no proof")?;
        let claim = &item[..proof];
        match name.as_str() {
            "impossible" | "exact_patch" | "solvable" => Ok(()),
            "refutation" => self.lines(item),
            _ if name == "some_weight" || name.starts_with("assumption") => {
                let constant = claim.rsplit_once(" : (").ok_or(name.clone())?.1;
                let constant = constant.split_once(" : ℝ) ≠ 0").ok_or(name)?.0;
                let value = self.environment.value(constant)?;
                self.environment.set("h", value);
                self.lines(item)
            }
            _ if claim.contains("(h : ∀ t") => self.row(&name, item),
            _ => {
                let (left, right) = equation(
                    claim.rsplit_once(" :\n").or_else(|| claim.rsplit_once(") : ")).ok_or("no claim")?.1,
                )?;
                let difference = self.environment.difference(left, right)?;
                let proof = item[proof..].lines().last().unwrap_or("").trim();
                if let Some(combination) = proof.strip_prefix("linear_combination ") {
                    self.verified.linear_combinations += 1;
                    same(self.environment.value(combination)?, difference, &name)?;
                } else {
                    self.verified.rings += usize::from(proof == "ring");
                    same(0, difference, &name)?;
                }
                self.environment.define_equation(name, parameters, left, right);
                Ok(())
            }
        }
    }

    /// From the samples to the coefficients.
    fn vanishing(&mut self, item: &str) -> Result<(), String> {
        let sum =
            item.split_once("t ≤ 1 → ").and_then(|(_, rest)| rest.split_once(" = 0)")).ok_or("no sum")?.0;
        let n = sum.matches(" * (t ^ ").count() - 1;
        for k in 0..=n {
            let sample = format!("  have h{k} := h ({k} / {n}) (by norm_num) (by norm_num)");
            if !item.lines().any(|line| line == sample) {
                return Err(format!("no sample {k}"));
            }
            let point = self.environment.value(&format!("{k} / {n}"))?;
            self.environment.set("t", point);
            let value = self.environment.value(sum)?;
            self.environment.set(&format!("h{k}"), value);
        }
        let proofs = item.split_once("exact ⟨").ok_or("no proofs")?.1.trim_end_matches('⟩');
        let proofs: Vec<&str> = proofs.split(",\n").map(str::trim).collect();
        same(proofs.len() as u64, n as u64 + 1, "the number of coefficients")?;
        for (r, proof) in proofs.iter().enumerate() {
            let combination = proof.strip_prefix("by linear_combination ").ok_or("no combination")?;
            let expected = self.environment.value(&format!("e{r}"))?;
            same(self.environment.value(combination)?, expected, &format!("vanish{n}, coefficient {r}"))?;
            self.verified.linear_combinations += 1;
        }
        Ok(())
    }

    /// The expansion along a row, whose coefficients are the conjuncts of the claim.
    fn row(&mut self, name: &str, item: &str) -> Result<(), String> {
        let claim = item
            .split_once("= 0) :\n")
            .and_then(|(_, rest)| rest.split_once(" := by\n"))
            .ok_or("no claim")?
            .0;
        let (_, expansion) = item.split_once("have e : ∀ p q : ℝ, ").ok_or("no expansion")?;
        let (left, right) = equation(expansion.split_once(" := by").ok_or("no proof")?.0)?;
        same(0, self.environment.difference(left, right)?, name)?;
        self.verified.rings += 1;
        let conjuncts: Vec<&str> = claim
            .split(" ∧ ")
            .map(|c| c.trim().trim_end_matches(" : ℝ) = 0").trim_start_matches('('))
            .collect();
        let n = conjuncts.len() - 1;
        let sum = conjuncts.iter().enumerate().map(|(s, c)| format!("({c}) * (p ^ {s} * q ^ {})", n - s));
        if sum.collect::<Vec<_>>().join(" + ") != right.trim() {
            return Err(format!("{name}: the conjuncts are not the coefficients"));
        }
        let values = conjuncts.iter().map(|c| self.environment.value(c)).collect::<Result<_, _>>()?;
        self.rows.insert(name.to_owned(), values);
        Ok(())
    }

    /// The lines of the main proof, in order: each may use what was shown before it.
    fn lines(&mut self, item: &str) -> Result<(), String> {
        let mut shown = String::new();
        for line in item.lines().map(str::trim) {
            if let Some(rest) = line.strip_prefix("obtain ⟨") {
                let (pattern, rest) = rest.split_once("⟩ := ").ok_or("no pattern")?;
                let (row, _) = rest.split_once(' ').ok_or("no row")?;
                let r: usize = row.trim_start_matches("row").parse().map_err(|_| row)?;
                let projection = ".2".repeat(r);
                if !rest.contains(&format!("(g v h0 h1){projection}")) {
                    return Err(format!("{row} is not given its coefficient: {rest}"));
                }
                for (s, (name, value)) in pattern.split(", ").zip(self.rows[row].clone()).enumerate() {
                    if name != "_" {
                        if name != format!("k_{r}_{s}") {
                            return Err(format!("{name} at place {s} of {row}"));
                        }
                        self.environment.set(name, value);
                    }
                }
            } else if let Some((name, rest)) =
                line.strip_prefix("have ").and_then(|rest| rest.split_once(" : ("))
            {
                let (claim, proof) = rest.split_once(" : ℝ) = 0 := ").ok_or(name)?;
                let value = self.environment.value(claim)?;
                match proof.strip_prefix("by linear_combination ") {
                    Some(combination) => {
                        self.verified.linear_combinations += 1;
                        same(self.environment.value(combination)?, value, name)?;
                    }
                    None => same(self.environment.value(proof)?, value, name)?,
                }
                self.environment.set(name, value);
                shown = format!("{name} : {claim}");
            } else if let Some(last) = line.strip_prefix("exact one_ne_zero ") {
                if shown != format!("{last} : 1") {
                    return Err(format!("the last line is not 1 = 0 but {shown}"));
                }
                return Ok(());
            }
        }
        Err("no contradiction".to_owned())
    }
}

fn same(a: u64, b: u64, place: &str) -> Result<(), String> {
    if a == b { Ok(()) } else { Err(format!("{place}: not an identity")) }
}

/// `NAME (a b : ℝ) …`.
fn named(head: &str) -> (String, Vec<String>) {
    let (name, rest) = head.split_once(' ').unwrap_or((head, ""));
    let parameters =
        rest.strip_prefix('(').and_then(|rest| rest.split_once(" : ℝ)")).map_or("", |(names, _)| names);
    (name.to_owned(), parameters.split_whitespace().map(String::from).collect())
}

fn equation(text: &str) -> Result<(&str, &str), String> {
    text.split_once(" =\n").or_else(|| text.split_once(" = ")).ok_or(format!("no equation: {text}"))
}
