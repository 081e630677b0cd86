"""No biquadratic rational patch is the cap of the unit sphere over a cube face: cofactors of 1 by SymPy.

Prints PROVED or FAILED; the exit status is 0 or 1.
"""

import sys
from math import comb

from sympy import QQ
from sympy.polys.groebnertools import groebner
from sympy.polys.rings import ring

# s, t stand for sqrt(2), sqrt(3); u, v for u/(1-u), v/(1-v), so that u^r v^s carries the coefficient c[r,s] of
# u^r (1-u)^(4-r) v^s (1-v)^(4-s). Bare polynomial rings, because SymPy's expressions are slower.
BIG, U, V, W, Z, S, T = ring("u,v,w,z,s,t", QQ)
RING, w, z, s, t = ring("w,z,s,t", QQ)
FIELD = [s**2 - 2, t**2 - 3]


def point(x, y):
    """Cartesian coordinates and weight of the control point in the direction (x, y)."""
    if x and y:
        return x * T / 3, y * T / 3, T / 3, BIG.one
    if x or y:
        return x * T / 2, y * T / 2, T / 2, S * T / 3
    return BIG.zero, BIG.zero, Z, W


def coefficients():
    """The coefficients c[r,s] of the condition that the patch lies on the sphere."""
    patch = [BIG.zero] * 4
    for i in range(3):
        for j in range(3):
            *cartesian, weight = point(j - 1, i - 1)
            basis = comb(2, i) * comb(2, j) * weight * U**i * V**j
            for k, coordinate in enumerate([*cartesian, 1]):
                patch[k] += basis * coordinate
    x, y, height, weight = patch
    found = {}
    for (r, c, *rest), value in (x**2 + y**2 + height**2 - weight**2).terms():
        found.setdefault((r, c), {})[tuple(rest)] = value
    return {rs: RING.from_dict(terms).rem(FIELD) for rs, terms in found.items()}


def inverse(number):
    """1/number in Q(s, t), through its conjugates; None for zero."""
    first = number.compose(s, -s)
    norm = (number * first).rem(FIELD)
    second = norm.compose(t, -t)
    rational = (norm * second).rem(FIELD)
    return (first * second).rem(FIELD) / rational.LC if rational else None


def linear_parts(c):
    """The numbers a, b in c = a w z + b w + constant; None if c is not of this form."""
    parts = {(1, 1): RING.zero, (1, 0): RING.zero, (0, 0): RING.zero}
    for (i, j, *powers), value in c.terms():
        if (i, j) not in parts:
            return None
        parts[i, j] += RING.from_dict({(0, 0, *powers): value})
    return parts[1, 1], parts[1, 0]


def cofactors(system):
    """Numbers and polynomials g with sum g[k] system[k] = 1 over Q(s, t); None if the way below finds none.

    groebner keeps no cofactors. But two of the equations are linear in w z and w: solved, they turn a third
    into a number.
    """
    linear = [(k, parts) for k, c in enumerate(system) if (parts := linear_parts(c))]
    if len(linear) < 2:
        return None
    (k, (a, b)), (l, (a_, b_)) = linear[:2]
    reciprocal = inverse((a * b_ - a_ * b).rem(FIELD))
    if reciprocal is None:
        return None
    # Cramer's rule: first = w z - constant, second = w - constant.
    rule = [
        [(b_ * reciprocal).rem(FIELD), (-b * reciprocal).rem(FIELD)],
        [(-a_ * reciprocal).rem(FIELD), (a * reciprocal).rem(FIELD)],
    ]
    first, second = [(p * system[k] + q * system[l]).rem(FIELD) for p, q in rule]
    for m, c in enumerate(system):
        (on_first, on_second, *_), rest = c.div([first, second, *FIELD])
        scale = inverse(rest) if linear_parts(rest) == (0, 0) else None
        if scale is None:
            continue
        g = [RING.zero] * len(system)
        g[m] = scale
        g[k] = -scale * (on_first * rule[0][0] + on_second * rule[1][0])
        g[l] = -scale * (on_first * rule[0][1] + on_second * rule[1][1])
        return [p.rem(FIELD) for p in g]
    return None


def proved():
    found = coefficients()
    #TWIN del found[2, 2]
    # Zeros and repetitions add nothing to the ideal.
    system = list({c: None for c in found.values() if c})
    if groebner([*system, *FIELD], RING) != [RING.one]:
        return False
    g = cofactors(system)
    return g is not None and sum((p * c for p, c in zip(g, system)), RING.zero).rem(FIELD) == RING.one


verdict = proved()
print("PROVED" if verdict else "FAILED")
sys.exit(0 if verdict else 1)
