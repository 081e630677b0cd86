//! LaTeX → tokens.

use num_rational::BigRational;

use super::display::{DISPLAYS, displays, environment};
use super::error::{ListingFault, Located, shown};
use super::number::{digits_at, number_at};
use super::token::{Bracket, Kind, Symbol, Token, Tokens};

/// Environments inside a display.
const INNER: [&str; 6] = ["aligned", "alignedat", "gathered", "split", "array", "multlined"];
/// Environments with an argument that is not printed.
const WITH_ARGUMENT: [&str; 3] = ["alignat", "alignedat", "array"];

/// Commands that print a blank, a bracket size or nothing.
const BLANK: [&str; 29] = [
    "quad",
    "qquad",
    "left",
    "right",
    "big",
    "Big",
    "bigg",
    "Bigg",
    "bigl",
    "Bigl",
    "biggl",
    "Biggl",
    "bigr",
    "Bigr",
    "biggr",
    "Biggr",
    "displaystyle",
    "textstyle",
    "nonumber",
    "notag",
    "square",
    "Box",
    "qed",
    "blacksquare",
    "hfill",
    "allowbreak",
    "thinspace",
    "enspace",
    "limits",
];
/// Letters that have a name.
const GREEK: [&str; 27] = [
    "alpha",
    "beta",
    "gamma",
    "delta",
    "epsilon",
    "varepsilon",
    "zeta",
    "eta",
    "theta",
    "vartheta",
    "iota",
    "kappa",
    "lambda",
    "mu",
    "nu",
    "xi",
    "rho",
    "sigma",
    "tau",
    "phi",
    "varphi",
    "chi",
    "psi",
    "omega",
    "Omega",
    "Lambda",
    "ell",
];

/// The tokens of all displays, with a row break after each.
pub(super) fn tokens(text: &str) -> Tokens {
    let mut all = Vec::new();
    for display in displays(text)? {
        let end = display.end;
        let mut lexer = Lexer { text, at: display.start, end, tokens: Vec::new() };
        while lexer.step()? {}
        all.append(&mut lexer.tokens);
        all.push(Token { kind: Kind::Row, span: end..end });
    }
    Ok(all)
}

struct Lexer<'a> {
    text: &'a str,
    at: usize,
    end: usize,
    tokens: Vec<Token>,
}

impl<'a> Lexer<'a> {
    fn rest(&self) -> &'a str {
        &self.text[self.at..self.end]
    }

    fn push(&mut self, kind: Kind, length: usize) {
        self.tokens.push(Token { kind, span: self.at..self.at + length });
        self.at += length;
    }

    fn fail<T>(&self, fault: ListingFault, length: usize) -> Result<T, Located> {
        Err((fault, self.at..(self.at + length).min(self.end)))
    }

    fn expected<T>(&self, expected: &'static str) -> Result<T, Located> {
        self.fail(ListingFault::Expected { expected, found: shown(self.rest()) }, 1)
    }

    fn skip_blanks(&mut self) {
        loop {
            let rest = self.rest();
            let blanks = rest.len() - rest.trim_start_matches([' ', '\t', '\n', '\r', '~']).len();
            self.at += blanks;
            if !self.rest().starts_with('%') {
                return;
            }
            self.at += self.rest().find('\n').unwrap_or(self.rest().len());
        }
    }

    /// Reads one token; false at the end.
    fn step(&mut self) -> Result<bool, Located> {
        self.skip_blanks();
        let Some(first) = self.rest().chars().next() else {
            return Ok(false);
        };
        match first {
            '\\' => self.command()?,
            '0'..='9' => {
                let (value, length) = number_at(self.rest()).map_err(|fault| self.spanned(fault))?;
                self.push(Kind::Number(value), length);
            }
            'a'..='z' | 'A'..='Z' => self.name(self.at, 1)?,
            '+' => self.push(Kind::Sign { minus: false }, 1),
            '-' | '−' => self.push(Kind::Sign { minus: true }, first.len_utf8()),
            '&' => self.push(Kind::Column, 1),
            '*' => self.push(Kind::Times, 1),
            '/' => self.push(Kind::Slash, 1),
            '=' => self.push(Kind::Equals, 1),
            '^' => self.superscript()?,
            '(' => self.push(Kind::Open(Bracket::Round), 1),
            ')' => self.push(Kind::Close(Bracket::Round), 1),
            '[' => self.push(Kind::Open(Bracket::Square), 1),
            ']' => self.push(Kind::Close(Bracket::Square), 1),
            '{' => self.push(Kind::Open(Bracket::Brace), 1),
            '}' => self.push(Kind::Close(Bracket::Brace), 1),
            ',' | ';' => self.push(Kind::Separator, 1),
            // The full stop after a formula; inside a number it has been read already.
            '.' if !self.rest()[1..].starts_with(|c: char| c.is_ascii_digit()) => {
                self.push(Kind::Separator, 1);
            }
            '.' => self.expected("a digit in front of the decimal point")?,
            _ => self.expected("a formula")?,
        }
        Ok(true)
    }

    fn spanned(&self, fault: ListingFault) -> Located {
        (fault, self.at..self.at + 1)
    }

    /// One digit or letter after `^` needs no braces; two digits do.
    fn superscript(&mut self) -> Result<(), Located> {
        self.push(Kind::Caret, 1);
        self.skip_blanks();
        self.single_digit()
    }

    /// Reads the argument of a command or an exponent, if it is a digit without braces.
    fn single_digit(&mut self) -> Result<(), Located> {
        let digits = digits_at(self.rest());
        if digits > 1 {
            let digits = self.rest()[..digits].to_owned();
            let length = digits.len();
            return self.fail(ListingFault::BareDigits { digits }, length);
        }
        if digits == 1 {
            self.digit_token();
        }
        Ok(())
    }

    fn digit_token(&mut self) {
        let digit = self.rest().as_bytes()[0] - b'0';
        self.push(Kind::Number(BigRational::from_integer(digit.into())), 1);
    }

    /// A name whose letters are the next `length` bytes, with its subscript.
    fn name(&mut self, start: usize, length: usize) -> Result<(), Located> {
        self.at += length;
        let letters_end = self.at;
        self.skip_blanks();
        if !self.rest().starts_with('_') {
            self.at = letters_end;
        } else {
            self.at += 1;
            self.skip_blanks();
            self.subscript()?;
        }
        let symbol = Symbol::new(&self.text[start..self.at]);
        self.tokens.push(Token { kind: Kind::Name(symbol), span: start..self.at });
        Ok(())
    }

    fn subscript(&mut self) -> Result<(), Located> {
        if self.rest().starts_with('{') {
            let inside = |c: char| c.is_ascii_alphanumeric() || c == ',' || c == ' ';
            let length = self.rest()[1..].find(|c| !inside(c)).unwrap_or(self.rest().len() - 1);
            if !self.rest()[1 + length..].starts_with('}') || length == 0 {
                self.at += 1 + length;
                return self.expected("a subscript of letters, digits and commas, then `}`");
            }
            self.at += length + 2;
            return Ok(());
        }
        let digits = digits_at(self.rest());
        match self.rest().chars().next() {
            Some(_) if digits > 1 => {
                let digits = self.rest()[..digits].to_owned();
                let length = digits.len();
                self.fail(ListingFault::BareDigits { digits }, length)
            }
            Some(c) if c.is_ascii_alphanumeric() => {
                self.at += 1;
                Ok(())
            }
            _ => self.expected("a subscript"),
        }
    }

    fn command(&mut self) -> Result<(), Located> {
        let after = &self.rest()[1..];
        let letters = after.len() - after.trim_start_matches(|c: char| c.is_ascii_alphabetic()).len();
        let name = &after[..letters];
        let length = 1 + letters;
        match name {
            "" => return self.symbol_command(after),
            "frac" | "tfrac" | "dfrac" | "cfrac" => {
                self.push(Kind::Fraction, length);
                // \frac12: TeX takes one digit for each argument that has no braces.
                self.skip_blanks();
                if digits_at(self.rest()) > 0 {
                    self.digit_token();
                    self.skip_blanks();
                    self.single_digit()?;
                }
            }
            "sqrt" => {
                self.push(Kind::Root, length);
                self.skip_blanks();
                if self.rest().starts_with('[') {
                    return self.expected("a square root: `{`, or one digit");
                }
                self.single_digit()?;
            }
            "cdot" | "times" | "ast" => self.push(Kind::Times, length),
            "lbrack" => self.push(Kind::Open(Bracket::Square), length),
            "rbrack" => self.push(Kind::Close(Bracket::Square), length),
            "lbrace" => self.push(Kind::Open(Bracket::Curly), length),
            "rbrace" => self.push(Kind::Close(Bracket::Curly), length),
            "begin" | "end" => self.environment(name)?,
            "tag" | "label" => {
                self.at += length;
                self.skip_argument()?;
            }
            "mathrm" | "mathit" | "operatorname" | "text" => self.named(length)?,
            _ if GREEK.contains(&name) => self.name(self.at, length)?,
            "quad" | "qquad" => {
                // As wide as between columns: a product would not be set like this.
                self.push(Kind::Column, length);
                self.equation_number();
            }
            _ if BLANK.contains(&name) => self.at += length,
            _ => return self.fail(ListingFault::Command { name: name.to_owned() }, length),
        }
        Ok(())
    }

    /// A backslash and one character that is not a letter.
    fn symbol_command(&mut self, after: &str) -> Result<(), Located> {
        match after.chars().next() {
            Some('\\') => {
                self.push(Kind::Row, 2);
                // The distance in \\[2pt], and the star in \\*.
                if self.rest().starts_with('*') {
                    self.at += 1;
                }
                if self.rest().starts_with('[')
                    && let Some(close) = self.rest().find(']')
                    && ["pt", "ex", "em", "mm", "cm"].iter().any(|unit| self.rest()[..close].ends_with(unit))
                {
                    self.at += close + 1;
                }
            }
            Some('{') => self.push(Kind::Open(Bracket::Curly), 2),
            Some('}') => self.push(Kind::Close(Bracket::Curly), 2),
            Some(',' | ';' | ':' | '!' | ' ' | '>' | '/' | '\n') => self.at += 2,
            _ => return self.expected("a formula"),
        }
        Ok(())
    }

    fn environment(&mut self, command: &str) -> Result<(), Located> {
        let Some(name) = environment(self.rest(), &format!("\\{command}{{")) else {
            return self.expected("the name of an environment in braces");
        };
        let plain = name.trim_end_matches('*');
        let length = command.len() + name.len() + 3;
        if !DISPLAYS.contains(&plain) && !INNER.contains(&plain) {
            return self.fail(ListingFault::Environment { name: name.to_owned() }, length);
        }
        self.at += length;
        if command == "begin" && WITH_ARGUMENT.contains(&plain) {
            self.skip_argument()?;
        }
        if command == "begin" && self.rest().starts_with("[t]") {
            self.at += 3;
        }
        Ok(())
    }

    /// `{…}` without braces inside.
    fn skip_argument(&mut self) -> Result<(), Located> {
        self.skip_blanks();
        match self.rest().starts_with('{').then(|| self.rest().find('}')).flatten() {
            Some(close) => {
                self.at += close + 1;
                Ok(())
            }
            None => self.expected("an argument in braces"),
        }
    }

    /// `\mathrm{name}`, with its subscript.
    fn named(&mut self, length: usize) -> Result<(), Located> {
        let start = self.at + length;
        let rest = &self.text[start..self.end];
        let inside = rest.strip_prefix('{').and_then(|rest| rest.split_once('}')).map(|(name, _)| name);
        let letters = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '\\';
        match inside.filter(|name| !name.is_empty() && name.chars().all(letters)) {
            Some(name) => {
                self.at = start;
                self.name(start, name.len() + 2)
            }
            None => {
                self.at = start;
                self.expected("a name of letters and digits in braces")
            }
        }
    }

    /// The number of the equation, as in `\quad (11)` at the end of a display.
    fn equation_number(&mut self) {
        let rest = self.rest().trim();
        let number = rest.strip_prefix('(').and_then(|rest| rest.strip_suffix(')'));
        // 11, 3.2, 4a, A-3: with letters alone it could be a factor.
        let plain = |text: &str| {
            let after_letter = text.trim_start_matches(|c: char| c.is_ascii_alphabetic());
            let lettered = after_letter.len() + 1 == text.len() && after_letter.starts_with(['-', '.']);
            (text.starts_with(|c: char| c.is_ascii_digit()) || lettered)
                && text.contains(|c: char| c.is_ascii_digit())
                && text.chars().all(|c| c.is_ascii_alphanumeric() || "-.'".contains(c))
        };
        if number.is_some_and(plain) {
            self.at = self.end;
        }
    }
}
