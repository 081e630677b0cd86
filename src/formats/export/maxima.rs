//! Maxima.
//!
//! Canonical rational expressions (`rat`) with the roots as main variables. Maxima ends with status 0 whatever happens, and 5.46 has no other
//! way: so the Lisp beneath is told to end, and what Maxima calls at the end of its input is replaced, for an error gets there too. The script
//! is run as an init file, since `--batch` repeats every line of it.

use super::case::{Case, ExportError};
use super::script::{Dialect, Parts, Sums, generators, roots, surface, wrapped, write};

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let names = generators(case);
    let (of_roots, variables) = names.split_at(case.root_count());
    let patch = ["p", "q"].map(String::from);
    // The last variable is the main one.
    let order: Vec<String> = variables.iter().chain(&patch).chain(of_roots).cloned().collect();
    let sums = surface(case).into_iter().map(|sum| format!("  F : F + ({sum}),\n"));
    let values = [
        ("GENERATORS", wrapped(&order)),
        ("REMAINDERS", roots(case, "P : remainder(P, ROOT^2 - SQUARE, ROOT), ").concat()),
        ("SURFACE", sums.collect()),
    ];
    Ok(write(case, &PARTS, &values))
}

const PARTS: Parts = Parts {
    dialect: Dialect { comment: ["/*", "*/"], end: "$", sums: Sums::Pieces(":") },
    run: "maxima --very-quiet --init-mac=FILE </dev/null",
    opening: r##"
lisp(text) := ?eval(?read\-from\-string(text))$
/* Maxima's quit() knows no status; errors end in it, or in the debugger */
leave(status) := (?finish\-output(), lisp(sconcat("(progn #+gcl (si::bye ", status, ") #+sbcl (sb-ext:exit :code ",
  status, " :abort t) #+ccl (ccl:quit ", status, ") #-(or gcl sbcl ccl) (ext:quit ", status, "))")))$
lisp("(defun bye (&rest ignored) (declare (ignore ignored)) (mfuncall '$leave 1))")$
lisp("(setq *debugger-hook* (lambda (condition hook) (declare (ignore condition hook)) (mfuncall '$leave 1)))")$

answer(word, text) := (?princ(sconcat(word, "  ", text, " (Maxima ", build_info()@version, ")")), ?terpri())$
reject(text) := (answer("REJECTED", text), leave(1))$

/* The last variables are the main ones */
ratvars(GENERATORS)$
reduced(P) := block(P : rat(P), REMAINDERSrat(P))$
vanishes(P) := is(ratdisrep(reduced(P)) = 0)$

/* What does not vanish, and its product with its inverse, less 1 */
nonvanishing : []$
inverses : []$
assumed(t, d) := (nonvanishing : endcons(d, nonvanishing), inverses : endcons(rat(d*t - 1), inverses))$
"##,
    patch: r"
/* The patch in p and q, where u = p/(1 + p) and v = q/(1 + q) */
m : DEGREE_U$
n : DEGREE_V$
points : 0$
Xh : rat(0)$
Yh : rat(0)$
Zh : rat(0)$
Wh : rat(0)$
point(i, j, X, Y, Z, W) := block([b],
  b : rat(binomial(m, i)*binomial(n, j)*p^i*q^j),
  points : points + 1,
  Xh : Xh + b*X,
  Yh : Yh + b*Y,
  Zh : Zh + b*Z,
  Wh : Wh + b*W)$
surface(X, Y, Z, W) := block([F],
  F : rat(0),
SURFACE  F)$
/* c[r,s] is the coefficient of p^r q^s */
coefficient(r, s) := ratcoef(ratcoef(G, p, r), q, s)$
",
    system: "
equations : []$
equation(P) := equations : endcons(P, equations)$
",
    replay: r#"
/* A step: what is added up must be what is concluded */
total : rat(0)$
conclusions : []$
missing(name) := reject(sconcat("step ", length(conclusions) + 1, ": there is no premise ", name))$
foreign() := missing("of this kind")$
LOOKUP
nonzero(k) := if k < 1 or k > length(inverses) then missing(sconcat("nonzero[", k, "]")) else inverses[k]$
earlier(k) := if k < 1 or k > length(conclusions) then missing(sconcat("step ", k, " before it"))
  else conclusions[k]$
add(premise, multiplier) := total : total + premise*rat(multiplier)$
conclude(k, P) := (
  if k # length(conclusions) + 1 then reject(sconcat("step ", k, " is out of order")),
  P : rat(P),
  if not vanishes(total - P) then reject(sconcat("step ", k, ": the sum is not the stated conclusion")),
  conclusions : endcons(P, conclusions),
  total : rat(0))$
"#,
    lookup: [
        r#"c(r, s) := if r > HIGHEST_U or s > HIGHEST_V then missing(sconcat("c[", r, ",", s, "]"))
  else coefficient(r, s)$"#,
        r#"f(k) := if k < 1 or k > length(equations) then missing(sconcat("f[", k, "]")) else equations[k]$"#,
    ],
    begin: "\n",
    expansion: r#"
if points # (m + 1)*(n + 1) then reject("the net is not complete")$
G : reduced(surface(Xh, Yh, Zh, Wh))$

"#,
    impossible: r#"
if length(conclusions) # STEPS then reject("there are not STEPS steps")$
if emptyp(conclusions) or not is(ratdisrep(last(conclusions)) = 1) then reject("the last conclusion is not 1")$
answer("VERIFIED", "impossible: 1 is a combination of the equations, LENGTH")$
"#,
    exact: r#"
for k : 1 thru length(nonvanishing) do
  if vanishes(nonvanishing[k]) then reject(sconcat("assumption ", k, " is zero"))$
"#,
    zeros: [
        r#"if vanishes(Wh) then reject("all weights are zero")$
for r : 0 thru HIGHEST_U do for s : 0 thru HIGHEST_V do
  if not vanishes(coefficient(r, s)) then reject(sconcat("c[", r, ",", s, "] is not zero"))$
if not vanishes(G) then reject("the patch is not on the surface")$
answer("VERIFIED", "exact: all COUNT coefficients vanish")$
"#,
        r#"if length(equations) # COUNT then reject("there are not COUNT equations")$
for k : 1 thru COUNT do
  if not vanishes(equations[k]) then reject(sconcat("f[", k, "] is not zero"))$
answer("VERIFIED", "exact: all COUNT equations vanish")$
"#,
    ],
    closing: "leave(0)$\n",
};
