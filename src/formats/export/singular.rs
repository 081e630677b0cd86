//! Singular.
//!
//! Singular goes on after an error, and ends with status 0. So everything happens in one procedure, which an error leaves, and what follows
//! it says REJECTED. Its one other exit status is that of a termination, after which it says `halt 1` by itself.

use super::case::{Case, ExportError};
use super::script::{Dialect, Parts, Sums, generators, roots, surface, wrapped, write};

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let patch = ["p", "q"].map(String::from);
    let names: Vec<String> = patch.into_iter().chain(generators(case)).collect();
    let squares = roots(case, "ROOT^2 - SQUARE").join(", ");
    let sums = surface(case).into_iter().map(|sum| format!("  F = F + ({sum});\n"));
    let values = [
        ("GENERATORS", wrapped(&names)),
        ("SQUARES", if squares.is_empty() { "0".to_owned() } else { squares }),
        ("SURFACE", sums.collect()),
    ];
    Ok(write(case, &PARTS, &values))
}

const PARTS: Parts = Parts {
    dialect: Dialect { comment: ["//", ""], end: ";", sums: Sums::Pieces("=") },
    run: "Singular -q FILE </dev/null",
    opening: r#"
int quiet = system("--no-warn", 1);
ring K = 0, (GENERATORS), dp;
ideal squares = std(ideal(SQUARES));

proc answer(string word, string text)
{
  print(word + "  " + text + " (Singular " + string(system("version")) + ")");
}
proc reject(string text)
{
  answer("REJECTED", text);
  // There is no other way to an exit status than to be terminated
  int killed = system("sh", "kill -TERM " + string(system("pid")));
  ERROR("still running");
}

// Long sums, in pieces
poly P1, P2, P3, P4;

// What does not vanish, and its product with its inverse, less 1
ideal nonvanishing, inverses;
int assumptions = 0;
proc assumed(poly t, poly d)
{
  assumptions = assumptions + 1;
  nonvanishing[assumptions] = reduce(d, squares);
  inverses[assumptions] = d*t - 1;
}
"#,
    patch: r#"
// The patch in p and q, where u = p/(1 + p) and v = q/(1 + q)
int m, n = DEGREE_U, DEGREE_V;
int points = 0;
poly Xh, Yh, Zh, Wh, G;
proc binomial(int a, int b)
{
  bigint product = 1;
  for (int k = 1; k <= b; k++) { product = product * (a - k + 1) div k; }
  return(product);
}
proc point(int i, int j, poly X, poly Y, poly Z, poly W)
{
  poly b = binomial(m, i) * binomial(n, j);
  b = b * p^i * q^j;
  points = points + 1;
  Xh = Xh + b*X;
  Yh = Yh + b*Y;
  Zh = Zh + b*Z;
  Wh = Wh + b*W;
}
proc surface(poly X, poly Y, poly Z, poly W)
{
  poly F;
SURFACE  return(F);
}
proc expand()
{
  if (points != (m + 1)*(n + 1)) { reject("the net is not complete"); }
  G = reduce(surface(Xh, Yh, Zh, Wh), squares);
}
// c[r,s] is the coefficient of p^r q^s
proc coefficient(int r, int s)
{
  matrix in_p = coeffs(G, p);
  if (r >= nrows(in_p)) { return(poly(0)); }
  matrix in_q = coeffs(in_p[r + 1, 1], q);
  if (s >= nrows(in_q)) { return(poly(0)); }
  return(in_q[s + 1, 1]);
}
"#,
    system: "
ideal equations;
int count = 0;
proc equation(poly P)
{
  count = count + 1;
  equations[count] = P;
}
",
    replay: r#"
// A step: what is added up must be what is concluded
poly total;
ideal conclusions;
int concluded = 0;
proc missing(string name)
{
  reject("step " + string(concluded + 1) + ": there is no premise " + name);
}
proc foreign() { missing("of this kind"); }
LOOKUP
proc nonzero(int k)
{
  if (k < 1 or k > assumptions) { missing("nonzero[" + string(k) + "]"); }
  return(inverses[k]);
}
proc earlier(int k)
{
  if (k < 1 or k > concluded) { missing("step " + string(k) + " before it"); }
  return(conclusions[k]);
}
proc add(poly premise, poly multiplier) { total = total + premise*multiplier; }
proc conclude(int k, poly P)
{
  if (k != concluded + 1) { reject("step " + string(k) + " is out of order"); }
  if (reduce(total - P, squares) != 0) { reject("step " + string(k) + ": the sum is not the stated conclusion"); }
  concluded = k;
  conclusions[k] = P;
  total = 0;
}
"#,
    lookup: [
        r#"proc c(int r, int s)
{
  if (r > HIGHEST_U or s > HIGHEST_V) { missing("c[" + string(r) + "," + string(s) + "]"); }
  return(coefficient(r, s));
}"#,
        r#"proc f(int k)
{
  if (k < 1 or k > count) { missing("f[" + string(k) + "]"); }
  return(equations[k]);
}"#,
    ],
    begin: "
proc verify()
{
",
    expansion: "
expand();

",
    impossible: r#"
if (concluded != STEPS) { reject("there are not STEPS steps"); }
if (concluded == 0) { reject("the last conclusion is not 1"); }
if (conclusions[concluded] != 1) { reject("the last conclusion is not 1"); }
answer("VERIFIED", "impossible: 1 is a combination of the equations, LENGTH");
"#,
    exact: r#"
int k, r, s;
for (k = 1; k <= assumptions; k++)
{
  if (nonvanishing[k] == 0) { reject("assumption " + string(k) + " is zero"); }
}
"#,
    zeros: [
        r#"if (reduce(Wh, squares) == 0) { reject("all weights are zero"); }
for (r = 0; r <= HIGHEST_U; r++)
{
  for (s = 0; s <= HIGHEST_V; s++)
  {
    if (coefficient(r, s) != 0) { reject("c[" + string(r) + "," + string(s) + "] is not zero"); }
  }
}
if (G != 0) { reject("the patch is not on the surface"); }
answer("VERIFIED", "exact: all COUNT coefficients vanish");
"#,
        r#"if (count != COUNT) { reject("there are not COUNT equations"); }
for (k = 1; k <= COUNT; k++)
{
  if (reduce(equations[k], squares) != 0) { reject("f[" + string(k) + "] is not zero"); }
}
answer("VERIFIED", "exact: all COUNT equations vanish");
"#,
    ],
    closing: r#"quit;
}
verify();
reject("the script has an error");
"#,
};
