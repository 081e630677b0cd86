//! Expressions of Lean as the exporter writes them, evaluated modulo a prime.

use std::collections::BTreeMap;

/// 2⁶¹ − 1.
pub(crate) const MODULUS: u64 = (1 << 61) - 1;

fn reduce(value: u128) -> u64 {
    (value % u128::from(MODULUS)) as u64
}

pub(crate) fn multiply(a: u64, b: u64) -> u64 {
    reduce(u128::from(a) * u128::from(b))
}

pub(crate) fn add(a: u64, b: u64) -> u64 {
    reduce(u128::from(a) + u128::from(b))
}

fn negate(a: u64) -> u64 {
    add(MODULUS - a, 0)
}

pub(crate) fn power(base: u64, exponent: u64) -> u64 {
    (0..64).rev().fold(1, |value, bit| {
        let square = multiply(value, value);
        if exponent >> bit & 1 == 1 { multiply(square, base) } else { square }
    })
}

enum Function {
    Definition(String),
    /// An equation, as left − right.
    Equation(String, String),
}

/// The values of names.
pub(crate) struct Environment {
    values: BTreeMap<String, u64>,
    functions: BTreeMap<String, (Vec<String>, Function)>,
    state: u64,
}

impl Environment {
    pub(crate) fn random(seed: u64) -> Self {
        let mut environment =
            Environment { values: BTreeMap::new(), functions: BTreeMap::new(), state: seed };
        for name in ["p", "q", "u", "v"] {
            environment.draw(name);
        }
        environment
    }

    fn draw(&mut self, name: &str) {
        // splitmix64
        self.state = self.state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        self.values.entry(name.to_owned()).or_insert(reduce(u128::from(z ^ (z >> 31))));
    }

    pub(crate) fn set(&mut self, name: &str, value: u64) {
        self.values.insert(name.to_owned(), value);
    }

    pub(crate) fn define(&mut self, name: String, parameters: Vec<String>, body: &str) {
        self.functions.insert(name, (parameters, Function::Definition(body.to_owned())));
    }

    pub(crate) fn define_equation(&mut self, name: String, parameters: Vec<String>, left: &str, right: &str) {
        self.functions.insert(name, (parameters, Function::Equation(left.to_owned(), right.to_owned())));
    }

    /// Draws the real parameters of a theorem that are new; hypotheses that are equations get left − right.
    pub(crate) fn hypotheses(&mut self, item: &str) -> Result<(), String> {
        let head = item.lines().next().unwrap_or("");
        for group in head.split('(').skip(1) {
            let Some((names, kind)) = group.split_once(" : ") else { continue };
            if kind.starts_with('ℝ') {
                names.split_whitespace().for_each(|name| self.draw(name));
            }
        }
        // `(hr2 : r2 ^ 2 = 2)`, `(ht1 : nonzero1 r2 x1 * t1 = 1)`, `(h1 : f1 r2 x1 = 0)`
        for group in head.split(" (h").skip(1) {
            let Some((name, rest)) = group.split_once(" : ") else { continue };
            let Some((left, right)) = rest.split_once(')').and_then(|(claim, _)| claim.split_once(" = "))
            else {
                continue;
            };
            let value = self.difference(left, right)?;
            self.set(&format!("h{name}"), value);
        }
        Ok(())
    }

    pub(crate) fn difference(&self, left: &str, right: &str) -> Result<u64, String> {
        Ok(add(self.value(left)?, negate(self.value(right)?)))
    }

    pub(crate) fn value(&self, text: &str) -> Result<u64, String> {
        self.value_with(text, None)
    }

    fn value_with(&self, text: &str, local: Option<&BTreeMap<String, u64>>) -> Result<u64, String> {
        let mut parser = Parser { tokens: tokens(text)?, at: 0, environment: self, local };
        let value = parser.sum()?;
        if parser.at < parser.tokens.len() {
            return Err(format!("unexpected {} in {text}", parser.tokens[parser.at]));
        }
        Ok(value)
    }
}

fn tokens(text: &str) -> Result<Vec<String>, String> {
    let mut tokens: Vec<String> = Vec::new();
    let mut word = false;
    for c in text.chars() {
        if c.is_ascii_alphanumeric() || c == '_' {
            if !word {
                tokens.push(String::new());
            }
            tokens.last_mut().unwrap().push(c);
            word = true;
        } else {
            word = false;
            if "+-*/^()".contains(c) {
                tokens.push(c.to_string());
            } else if !c.is_whitespace() {
                return Err(format!("{c} in {text}"));
            }
        }
    }
    Ok(tokens)
}

struct Parser<'a> {
    tokens: Vec<String>,
    at: usize,
    environment: &'a Environment,
    local: Option<&'a BTreeMap<String, u64>>,
}

impl Parser<'_> {
    fn peek(&self) -> &str {
        self.tokens.get(self.at).map_or("", String::as_str)
    }

    fn take(&mut self, token: &str) -> bool {
        let found = self.peek() == token;
        self.at += usize::from(found);
        found
    }

    fn sum(&mut self) -> Result<u64, String> {
        let mut value = self.product()?;
        loop {
            if self.take("+") {
                value = add(value, self.product()?);
            } else if self.take("-") {
                value = add(value, negate(self.product()?));
            } else {
                return Ok(value);
            }
        }
    }

    fn product(&mut self) -> Result<u64, String> {
        let mut value = self.signed()?;
        loop {
            if self.take("*") {
                value = multiply(value, self.signed()?);
            } else if self.take("/") {
                value = multiply(value, power(self.signed()?, MODULUS - 2));
            } else {
                return Ok(value);
            }
        }
    }

    fn signed(&mut self) -> Result<u64, String> {
        if self.take("-") {
            return Ok(negate(self.signed()?));
        }
        let base = self.application()?;
        if self.take("^") {
            let exponent = self.peek().parse().map_err(|_| format!("exponent {}", self.peek()))?;
            self.at += 1;
            return Ok(power(base, exponent));
        }
        Ok(base)
    }

    fn application(&mut self) -> Result<u64, String> {
        let environment = self.environment;
        if self.local.is_some_and(|local| local.contains_key(self.peek())) {
            return self.atom();
        }
        let Some((parameters, function)) = environment.functions.get(self.peek()) else { return self.atom() };
        self.at += 1;
        let mut local = BTreeMap::new();
        for parameter in parameters {
            local.insert(parameter.clone(), self.atom()?);
        }
        // A theorem is also given its hypotheses.
        while matches!(function, Function::Equation(..)) && self.peek().starts_with('h') {
            if !environment.values.contains_key(self.peek()) {
                return Err(format!("{} is not known", self.peek()));
            }
            self.at += 1;
        }
        match function {
            Function::Definition(body) => environment.value_with(body, Some(&local)),
            Function::Equation(left, right) => Ok(add(
                environment.value_with(left, Some(&local))?,
                negate(environment.value_with(right, Some(&local))?),
            )),
        }
    }

    fn atom(&mut self) -> Result<u64, String> {
        if self.take("(") {
            let value = self.sum()?;
            return if self.take(")") { Ok(value) } else { Err(format!("no ) at {}", self.peek())) };
        }
        let token = self.peek().to_owned();
        self.at += 1;
        if token.starts_with(|c: char| c.is_ascii_digit()) {
            return token.bytes().try_fold(0, |value, digit| match digit {
                b'0'..=b'9' => Ok(add(multiply(value, 10), u64::from(digit - b'0'))),
                _ => Err(format!("{token} is no number")),
            });
        }
        // What a definition depends on are its parameters, nothing else.
        let value = match self.local {
            Some(local) => local.get(&token),
            None => self.environment.values.get(&token),
        };
        value.copied().ok_or(format!("{token} is not known"))
    }
}
