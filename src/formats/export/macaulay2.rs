//! Macaulay2.
//!
//! The coefficients live in a quotient ring that knows the squares of the roots, so that nothing need be reduced. `--script` makes an error end
//! the program with status 1.

use super::case::{Case, ExportError};
use super::script::{Dialect, Parts, Sums, generators, roots, surface, wrapped, write};

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let names = generators(case);
    // A ring without variables is no ring of polynomials.
    let ring = if names.is_empty() { "QQ".to_owned() } else { format!("QQ[{}]", wrapped(&names)) };
    let squares = roots(case, "ROOT^2 - SQUARE").join(", ");
    let quotient = if squares.is_empty() { String::new() } else { format!(" / ideal({squares})") };
    let sums = surface(case).into_iter().map(|sum| format!("  F = F + ({sum});\n"));
    let values = [("RING", ring + &quotient), ("SURFACE", sums.collect())];
    Ok(write(case, &PARTS, &values))
}

const PARTS: Parts = Parts {
    dialect: Dialect { comment: ["--", ""], end: ";", sums: Sums::Pieces("=") },
    run: "M2 --script FILE",
    opening: r#"
K = RING;

answer = (word, text) -> print(word | "  " | text | " (Macaulay2 " | version#"VERSION" | ")");
reject = text -> (answer("REJECTED", text); exit 1);

-- What does not vanish, and its product with its inverse, less 1
nonvanishing = new MutableList;
inverses = new MutableList;
assumed = (t, d) -> (
  nonvanishing##nonvanishing = d_K;
  inverses##inverses = d_K * t - 1_K;
);
"#,
    patch: r#"
-- The patch in p and q, where u = p/(1 + p) and v = q/(1 + q)
S = K[p, q];
(m, n) = (DEGREE_U, DEGREE_V);
points = 0;
(Xh, Yh, Zh, Wh) = (0_S, 0_S, 0_S, 0_S);
point = (i, j, X, Y, Z, W) -> (
  b := binomial(m, i) * binomial(n, j) * p^i * q^j;
  points = points + 1;
  Xh = Xh + b * X;
  Yh = Yh + b * Y;
  Zh = Zh + b * Z;
  Wh = Wh + b * W;
);
surface = (X, Y, Z, W) -> (
  F := 0_S;
SURFACE  F
);
-- c[r,s] is the coefficient of p^r q^s
coefficientAt = (r, s) -> coefficient(p^r * q^s, G);
"#,
    system: "
equations = new MutableList;
equation = P -> (equations##equations = P_K;);
",
    replay: r#"
-- A step: what is added up must be what is concluded
total = 0_K;
conclusions = new MutableList;
missing = name -> reject("step " | #conclusions + 1 | ": there is no premise " | name);
foreign = () -> missing "of this kind";
LOOKUP
nonzero = k -> (
  if k < 1 or k > #inverses then missing("nonzero[" | k | "]");
  inverses#(k - 1)
);
earlier = k -> (
  if k < 1 or k > #conclusions then missing("step " | k | " before it");
  conclusions#(k - 1)
);
add = (premise, multiplier) -> (total = total + premise * multiplier;);
conclude = (k, P) -> (
  if k != #conclusions + 1 then reject("step " | k | " is out of order");
  if total - P != 0 then reject("step " | k | ": the sum is not the stated conclusion");
  conclusions##conclusions = P_K;
  total = 0_K;
);
"#,
    lookup: [
        r#"c = (r, s) -> (
  if r > HIGHEST_U or s > HIGHEST_V then missing("c[" | r | "," | s | "]");
  coefficientAt(r, s)
);"#,
        r#"f = k -> (
  if k < 1 or k > #equations then missing("f[" | k | "]");
  equations#(k - 1)
);"#,
    ],
    begin: "\n",
    expansion: r#"
if points != (m + 1) * (n + 1) then reject "the net is not complete";
G = surface(Xh, Yh, Zh, Wh);

"#,
    impossible: r#"
if #conclusions != STEPS then reject "there are not STEPS steps";
if #conclusions == 0 or last conclusions != 1 then reject "the last conclusion is not 1";
answer("VERIFIED", "impossible: 1 is a combination of the equations, LENGTH");
"#,
    exact: r#"
for k from 1 to #nonvanishing do (
  if nonvanishing#(k - 1) == 0 then reject("assumption " | k | " is zero"));
"#,
    zeros: [
        r#"if Wh == 0 then reject "all weights are zero";
for r from 0 to HIGHEST_U do for s from 0 to HIGHEST_V do (
  if coefficientAt(r, s) != 0 then reject("c[" | r | "," | s | "] is not zero"));
if G != 0 then reject "the patch is not on the surface";
answer("VERIFIED", "exact: all COUNT coefficients vanish");
"#,
        r#"if #equations != COUNT then reject "there are not COUNT equations";
for k from 1 to COUNT do (
  if equations#(k - 1) != 0 then reject("f[" | k | "] is not zero"));
answer("VERIFIED", "exact: all COUNT equations vanish");
"#,
    ],
    closing: "exit 0\n",
};
