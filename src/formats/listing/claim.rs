//! What a source claims about its coefficients, beside listing them.

use std::ops::Range;

use super::error::Located;
use super::expression::{Expression, Formula};
use super::table::{Table, Value, file_fault, string, strings};
use super::token::Symbol;

/// A claim, as data. What it means is decided by the audit.
#[derive(Debug, Clone)]
pub struct Claim {
    /// Where the source makes it: "3.1", "Eq. 15".
    pub place: String,
    /// What is claimed, in a few words.
    pub says: String,
    /// What is checked.
    pub kind: ClaimKind,
    /// A remark that is not checked: a slip of the pen nearby.
    pub remark: String,
    /// Where it stands in the listing file.
    pub span: Range<usize>,
}

/// The kinds of claims.
#[derive(Debug, Clone)]
pub enum ClaimKind {
    /// `a12 = a15 = -2*a16`: a relation between coefficients.
    Relation(Formula),
    /// The coefficients of uⁱvʲ and uʲvⁱ are equal.
    Symmetric,
    /// These coefficients, and no others, are linear in these expressions of the unknowns.
    Linear {
        /// The coefficients.
        labels: Vec<Symbol>,
        /// In what.
        variables: Vec<Expression>,
    },
    /// These coefficients are linearly independent over K.
    Independent(Vec<Symbol>),
    /// These equations, linear in the variables, have this solution and no other.
    Solution {
        /// The coefficients that are set to zero.
        labels: Vec<Symbol>,
        /// In what they are linear.
        variables: Vec<Expression>,
        /// The values of the unknowns.
        values: Vec<(Symbol, Expression)>,
        /// Whether the solution is that of least squares.
        least_squares: bool,
    },
    /// At these values of the unknowns the coefficients have these values, to the digits printed.
    Values {
        /// The values of the unknowns.
        at: Vec<(Symbol, Expression)>,
        /// Each coefficient with its printed decimal.
        printed: Vec<(Symbol, String)>,
    },
    /// A constant is, to the digits printed, this decimal.
    Decimal {
        /// The constant.
        of: Expression,
        /// As printed.
        printed: String,
    },
    /// At these values of the unknowns the distance from the origin stays in this interval, to the digits printed.
    Radius {
        /// The values of the unknowns.
        at: Vec<(Symbol, Expression)>,
        /// The printed bounds.
        interval: (String, String),
    },
    /// These values of the unknowns are best: the rival does not keep the distance from the origin in a smaller interval.
    Unrivalled {
        /// The values of the unknowns.
        at: Vec<(Symbol, Expression)>,
        /// Other values to compare with.
        rival: Vec<(Symbol, Expression)>,
    },
    /// A built-in statement comes out as expected.
    Proved {
        /// Its name.
        statement: String,
        /// How.
        expected: Expectation,
    },
    /// A quantity of the cap over the cube face, derived from the geometry, is what is printed.
    Quantity {
        /// Its name: a, OM, P01, ….
        name: String,
        /// One printed expression for each component; `a` and `R` may occur.
        printed: Vec<Expression>,
    },
    /// Nothing this program can compute.
    Unchecked,
}

/// What proving a statement is expected to give.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expectation {
    /// No values of the unknowns put the patch on the surface.
    Impossible,
    /// The patch lies on the surface.
    Exact,
}

const KEYS: [&str; 22] = [
    "where",
    "says",
    "remark",
    "relation",
    "symmetric",
    "linear",
    "independent",
    "solve",
    "variables",
    "solution",
    "least_squares",
    "at",
    "values",
    "radius",
    "rival",
    "proved",
    "quantity",
    "printed",
    "expected",
    "unchecked",
    "decimal",
    "of",
];

/// Reads one `[[claim]]`.
pub(super) fn read(table: Table<'_, '_>) -> Result<Claim, Located> {
    table.check_keys(&KEYS)?;
    let place = string(table.required("where", "where the claim is made")?, "where")?.to_owned();
    let says = string(table.required("says", "the claim in a few words")?, "says")?.to_owned();
    Ok(Claim {
        place,
        says,
        kind: kind(&table)?,
        remark: table.string("remark")?.unwrap_or("").to_owned(),
        span: table.span(),
    })
}

fn kind(table: &Table<'_, '_>) -> Result<ClaimKind, Located> {
    if let Some(value) = table.get("relation") {
        return Ok(ClaimKind::Relation(table.formula(string(value, "relation")?, value, "relation")?));
    }
    if table.flag("symmetric")? {
        return Ok(ClaimKind::Symmetric);
    }
    if let Some(value) = table.get("linear") {
        return Ok(ClaimKind::Linear { labels: symbols(value, "linear")?, variables: variables(table)? });
    }
    if let Some(value) = table.get("independent") {
        return Ok(ClaimKind::Independent(symbols(value, "independent")?));
    }
    if let Some(value) = table.get("solve") {
        return Ok(ClaimKind::Solution {
            labels: symbols(value, "solve")?,
            variables: variables(table)?,
            values: point(table, "solution")?,
            least_squares: table.flag("least_squares")?,
        });
    }
    if let Some(values) = table.table("values")? {
        let mut printed = Vec::new();
        for (key, value) in values.entries() {
            printed.push((Symbol::new(key.get_ref()), decimal(value, key.get_ref())?));
        }
        return Ok(ClaimKind::Values { at: point(table, "at")?, printed });
    }
    if let Some(value) = table.get("decimal") {
        let of = table.expression(table.required("of", "the constant")?, "of")?;
        return Ok(ClaimKind::Decimal { of, printed: decimal(value, "decimal")? });
    }
    if let Some(value) = table.get("radius") {
        let [low, high] = value.get_ref().as_array().map(|items| &**items).unwrap_or_default() else {
            return Err(file_fault("`radius`: expected the two ends of an interval".into(), value.span()));
        };
        let interval = (decimal(low, "radius")?, decimal(high, "radius")?);
        return Ok(ClaimKind::Radius { at: point(table, "at")?, interval });
    }
    if table.get("rival").is_some() {
        return Ok(ClaimKind::Unrivalled { at: point(table, "at")?, rival: point(table, "rival")? });
    }
    if let Some(statement) = table.string("proved")? {
        let expected = match table.string("expected")? {
            Some("impossible") => Expectation::Impossible,
            Some("exact") => Expectation::Exact,
            _ => {
                let message = "`expected`: \"impossible\" or \"exact\"".to_owned();
                return Err(file_fault(message, table.span()));
            }
        };
        return Ok(ClaimKind::Proved { statement: statement.to_owned(), expected });
    }
    if let Some(name) = table.string("quantity")? {
        let value = table.required("printed", "the printed components")?;
        let items = value.get_ref().as_array();
        let items = items.ok_or_else(|| file_fault("`printed`: expected a list".into(), value.span()))?;
        let printed = items.iter().map(|item| table.expression(item, "printed")).collect::<Result<_, _>>()?;
        return Ok(ClaimKind::Quantity { name: name.to_owned(), printed });
    }
    if table.flag("unchecked")? {
        return Ok(ClaimKind::Unchecked);
    }
    let kinds = "relation, symmetric, linear, independent, solve, values, decimal, radius, rival, \
                 proved, quantity or unchecked";
    Err(file_fault(format!("a claim without content, expected one of {kinds}"), table.span()))
}

fn symbols(value: &Value<'_>, key: &str) -> Result<Vec<Symbol>, Located> {
    Ok(strings(value, key)?.into_iter().map(Symbol::new).collect())
}

fn variables(table: &Table<'_, '_>) -> Result<Vec<Expression>, Located> {
    let value = table.required("variables", "the expressions that the equations are linear in")?;
    let items = value.get_ref().as_array();
    let items = items.ok_or_else(|| file_fault("`variables`: expected a list".into(), value.span()))?;
    items.iter().map(|item| table.expression(item, "variables")).collect()
}

fn point(table: &Table<'_, '_>, key: &str) -> Result<Vec<(Symbol, Expression)>, Located> {
    let Some(values) = table.table(key)? else {
        return Err(file_fault(
            format!("`{key}` is missing, expected the values of the unknowns"),
            table.span(),
        ));
    };
    let read = |(key, value): (&toml::Spanned<std::borrow::Cow<'_, str>>, &Value<'_>)| {
        Ok((Symbol::new(key.get_ref()), values.expression(value, key.get_ref())?))
    };
    values.entries().into_iter().map(read).collect()
}

/// A printed decimal, kept as it is spelled: its digits tell how much is claimed.
fn decimal(value: &Value<'_>, key: &str) -> Result<String, Located> {
    let text = string(value, key)?;
    let digits = text.strip_prefix('-').unwrap_or(text);
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, "0"));
    let all = |part: &str| !part.is_empty() && part.len() <= 40 && part.bytes().all(|b| b.is_ascii_digit());
    if all(whole) && all(decimals) {
        Ok(text.to_owned())
    } else {
        Err(file_fault(format!("`{key}`: expected a decimal in quotes, as it is printed"), value.span()))
    }
}
