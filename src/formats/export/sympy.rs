//! SymPy.
//!
//! Its sparse polynomials, without any symbolic expressions, whose names are a trap (`E`, `I`, `S`, …) and whose parser has limits. Rationals are
//! SymPy's own: with python-flint installed it would compute with FLINT without saying so.

use super::case::{Case, ExportError};
use super::script::{Dialect, Parts, Sums, generators, roots, surface, write};

pub(super) fn export(case: &Case) -> Result<String, ExportError> {
    let values = [
        ("GENERATORS", generators(case).join(" ")),
        ("SQUARES", roots(case, "\"ROOT\": SQUARE").join(", ")),
        ("SURFACE", surface(case).join("\n + ").replace("+ -", "- ")),
    ];
    // Python looks for a declaration of the encoding in the first two lines: no title may stand there.
    Ok(format!("#!/usr/bin/env python3\n# -*- coding: ascii -*-\n{}", write(case, &PARTS, &values)))
}

const PARTS: Parts = Parts {
    dialect: Dialect { comment: ["#", ""], end: "", sums: Sums::Text },
    run: "python3 FILE",
    opening: r##"
import os
import sys
from math import comb

os.environ["SYMPY_GROUND_TYPES"] = "python"

import sympy
from sympy import QQ
from sympy.polys.orderings import lex
from sympy.polys.rings import PolyRing

NAMES = "p q GENERATORS".split()
K = PolyRing(NAMES, QQ, lex)
P, Q = K.gens[:2]
ROOTS = {NAMES.index(name): square for name, square in {SQUARES}.items()}


def answer(word, text):
    print(f"{word}  {text} (SymPy {sympy.__version__})")


def reject(text):
    answer("REJECTED", text)
    sys.exit(1)


def terms(text):
    """The terms of a sum such as 3/8*r2*x1^2 - 4: a coefficient, and names with exponents."""
    for term in text.replace("- ", "-").replace("+ ", "").split():
        coefficient, powers = QQ(1), []
        if term[0] == "-":
            coefficient, term = QQ(-1), term[1:]
        for factor in term.split("*"):
            if factor[0].isdigit():
                numerator, _, denominator = factor.partition("/")
                coefficient *= QQ(int(numerator), int(denominator or 1))
            else:
                name, _, exponent = factor.partition("^")
                powers.append((name, int(exponent or 1)))
        yield coefficient, powers


def collected(pairs):
    """Sums up (exponents, coefficient) modulo the squares of the roots."""
    total = {}
    for exponents, coefficient in pairs:
        exponents = list(exponents)
        for place, square in ROOTS.items():
            coefficient *= square ** (exponents[place] // 2)
            exponents[place] %= 2
        exponents = tuple(exponents)
        total[exponents] = total.get(exponents, 0) + coefficient
    return K.from_dict(total)


def reduced(f):
    return collected(f.terms())


def polynomial(text):
    def exponents(powers):
        found = [0] * len(NAMES)
        for name, exponent in powers:
            found[NAMES.index(name)] += exponent
        return found

    return collected((exponents(powers), coefficient) for coefficient, powers in terms(text))


# What does not vanish, and its product with its inverse, less 1
nonvanishing, inverses = [], []


def assumed(t, d):
    nonvanishing.append(polynomial(d))
    inverses.append(polynomial(d) * polynomial(t) - 1)

"##,
    patch: r#"
# The patch in p and q, where u = p/(1 + p) and v = q/(1 + q)
M, N = DEGREE_U, DEGREE_V
EQUATION = """
SURFACE"""
points = []
patch = [K.zero] * 4


def point(i, j, *coordinates):
    points.append((i, j))
    for place, coordinate in enumerate(coordinates):
        patch[place] += comb(M, i) * comb(N, j) * P**i * Q**j * polynomial(coordinate)


def expanded():
    """The coefficients c[r,s] of p^r q^s in the surface equation."""
    values = dict(zip(NAMES, K.gens)) | dict(zip("XYZW", patch))
    total = K.zero
    for coefficient, powers in terms(EQUATION):
        product = K(coefficient)
        for name, exponent in powers:
            product = reduced(product * values[name] ** exponent)
        total += product
    found = {}
    for exponents, coefficient in total.terms():
        place = exponents[:2]
        found.setdefault(place, K.zero)
        found[place] += K.from_dict({(0, 0) + exponents[2:]: coefficient})
    return found

"#,
    system: "
equations = []


def equation(text):
    equations.append(polynomial(text))

",
    replay: r#"
# A step: what is added up must be what is concluded
total = K.zero
conclusions = []


def missing(name):
    reject(f"step {len(conclusions) + 1}: there is no premise {name}")


def foreign():
    missing("of this kind")

LOOKUP

def nonzero(k):
    return inverses[k - 1] if 1 <= k <= len(inverses) else missing(f"nonzero[{k}]")


def earlier(k):
    return conclusions[k - 1] if 1 <= k <= len(conclusions) else missing(f"step {k} before it")


def add(premise, multiplier):
    global total
    total += premise * polynomial(multiplier)


def conclude(k, text):
    global total
    if k != len(conclusions) + 1:
        reject(f"step {k} is out of order")
    if reduced(total - polynomial(text)) != 0:
        reject(f"step {k}: the sum is not the stated conclusion")
    conclusions.append(polynomial(text))
    total = K.zero

"#,
    lookup: [
        r#"
def c(r, s):
    return coefficients.get((r, s), K.zero) if r <= HIGHEST_U and s <= HIGHEST_V else missing(f"c[{r},{s}]")
"#,
        r#"
def f(k):
    return equations[k - 1] if 1 <= k <= len(equations) else missing(f"f[{k}]")
"#,
    ],
    begin: "\n",
    expansion: r#"
if len(points) != (M + 1) * (N + 1):
    reject("the net is not complete")
coefficients = expanded()

"#,
    impossible: r#"
if len(conclusions) != STEPS:
    reject("there are not STEPS steps")
if not conclusions or conclusions[-1] != 1:
    reject("the last conclusion is not 1")
answer("VERIFIED", "impossible: 1 is a combination of the equations, LENGTH")
"#,
    exact: r#"
for k, d in enumerate(nonvanishing, 1):
    if d == 0:
        reject(f"assumption {k} is zero")
"#,
    zeros: [
        r#"if reduced(patch[3]) == 0:
    reject("all weights are zero")
for (r, s), coefficient in sorted(coefficients.items(), key=lambda item: item[0]):
    if coefficient != 0:
        reject(f"c[{r},{s}] is not zero")
answer("VERIFIED", "exact: all COUNT coefficients vanish")
"#,
        r#"if len(equations) != COUNT:
    reject("there are not COUNT equations")
for k, f in enumerate(equations, 1):
    if f != 0:
        reject(f"f[{k}] is not zero")
answer("VERIFIED", "exact: all COUNT equations vanish")
"#,
    ],
    closing: "",
};
