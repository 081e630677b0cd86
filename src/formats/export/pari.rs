//! PARI/GP.
//!
//! PARI's polynomials are recursive: the roots come first, so that they are the main variables, where reduction is fast. One statement stands
//! on each line, since PARI can drop one of two silently. `recover` is what makes an error end the program with status 1.

use super::case::{Case, ExportError};
use super::script::{Dialect, Parts, Sums, generators, roots, surface, wrapped, write};

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let roots_first: Vec<String> = {
        let names = generators(case);
        let (roots, variables) = names.split_at(case.root_count());
        let patch = ["p", "q"].map(String::from);
        roots.iter().chain(&patch).chain(variables).cloned().collect()
    };
    let sums = surface(case).into_iter().map(|sum| format!("  F += {sum};\n"));
    let values = [
        ("GENERATORS", wrapped(&roots_first)),
        ("FOLDS", roots(case, "P = folded(P, ROOT, SQUARE); ").concat()),
        ("SURFACE", sums.collect()),
    ];
    Ok(write(case, &PARTS, &values))
}

const PARTS: Parts = Parts {
    dialect: Dialect { comment: ["\\\\", ""], end: ";", sums: Sums::Pieces("=") },
    run: "gp -q FILE </dev/null",
    opening: r#"
default(recover, 0);
default(colors, "no");
default(debugmem, 0);
default(parisizemax, 4 * 10^9);

\\ The order of the variables; the roots are the main ones
{
[GENERATORS]
};

answer(word, text) = print(word, "  ", text, " (PARI/GP ", strjoin(apply(k -> Str(k), version()), "."), ")");
reject(text) = { answer("REJECTED", text); quit(1) };

\\ A polynomial with the powers of a root r of d reduced, with those of all roots reduced
folded(P, r, d) = if(P == 0, 0, sum(i = 0, poldegree(P, r), polcoef(P, i, r) * d^(i \ 2) * r^(i % 2)));
reduced(P) = { FOLDSP };

\\ What does not vanish, and its product with its inverse, less 1
nonvanishing = List();
inverses = List();
assumed(t, d) = { listput(nonvanishing, reduced(d)); listput(inverses, d * t - 1) };
"#,
    patch: r"
\\ The patch in p and q, where u = p/(1 + p) and v = q/(1 + q)
m = DEGREE_U;
n = DEGREE_V;
points = 0;
Xh = 0;
Yh = 0;
Zh = 0;
Wh = 0;
point(i, j, X, Y, Z, W) = {
  my(b = binomial(m, i) * binomial(n, j) * p^i * q^j);
  points++;
  Xh += b * X;
  Yh += b * Y;
  Zh += b * Z;
  Wh += b * W
};
surface(X, Y, Z, W) = {
  my(F = 0);
SURFACE  F
};
\\ c[r,s] is the coefficient of p^r q^s
coefficient(r, s) = polcoef(polcoef(G, r, p), s, q);
",
    system: "
equations = List();
equation(P) = listput(equations, P);
",
    replay: r#"
\\ A step: what is added up must be what is concluded
total = 0;
conclusions = List();
missing(name) = reject(Str("step ", #conclusions + 1, ": there is no premise ", name));
foreign() = missing("of this kind");
LOOKUP
nonzero(k) = if(k < 1 || k > #inverses, missing(Str("nonzero[", k, "]")), inverses[k]);
earlier(k) = if(k < 1 || k > #conclusions, missing(Str("step ", k, " before it")), conclusions[k]);
add(premise, multiplier) = total += premise * multiplier;
conclude(k, P) = {
  if(k != #conclusions + 1, reject(Str("step ", k, " is out of order")));
  if(reduced(total - P) != 0, reject(Str("step ", k, ": the sum is not the stated conclusion")));
  listput(conclusions, P);
  total = 0
};
"#,
    lookup: [
        r#"c(r, s) = if(r > HIGHEST_U || s > HIGHEST_V, missing(Str("c[", r, ",", s, "]")), coefficient(r, s));"#,
        r#"f(k) = if(k < 1 || k > #equations, missing(Str("f[", k, "]")), equations[k]);"#,
    ],
    begin: "\n",
    expansion: r#"
if(points != (m + 1) * (n + 1), reject("the net is not complete"));
G = reduced(surface(Xh, Yh, Zh, Wh));

"#,
    impossible: r#"
if(#conclusions != STEPS, reject("there are not STEPS steps"));
if(#conclusions == 0 || conclusions[#conclusions] != 1, reject("the last conclusion is not 1"));
answer("VERIFIED", "impossible: 1 is a combination of the equations, LENGTH");
"#,
    exact: r#"
for(k = 1, #nonvanishing, if(nonvanishing[k] == 0, reject(Str("assumption ", k, " is zero"))));
"#,
    zeros: [
        r#"if(reduced(Wh) == 0, reject("all weights are zero"));
for(r = 0, HIGHEST_U, for(s = 0, HIGHEST_V, if(coefficient(r, s) != 0, reject(Str("c[", r, ",", s, "] is not zero")))));
if(G != 0, reject("the patch is not on the surface"));
answer("VERIFIED", "exact: all COUNT coefficients vanish");
"#,
        r#"if(#equations != COUNT, reject("there are not COUNT equations"));
for(k = 1, COUNT, if(reduced(equations[k]) != 0, reject(Str("f[", k, "] is not zero"))));
answer("VERIFIED", "exact: all COUNT equations vanish");
"#,
    ],
    closing: "quit(0);\n",
};
