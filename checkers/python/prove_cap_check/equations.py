"""The equations of a statement (FORMAT.md section 3)."""

from math import comb

from .poly import sum_of_products


def hat(points, m, n, ring):
    """The polynomials sum C(m,i) C(n,j) X_ij p^i q^j of the four coordinates, p and q in the extra fields of the keys.

    With p = u/(1-u), q = v/(1-v) they are the coordinates of the patch but for the factor (1-u)^m (1-v)^n; so their
    coefficients are those of u^i (1-u)^(m-i) v^j (1-v)^(n-j)."""
    result = []
    for c in range(4):
        pairs = []
        for (i, j), point in points.items():
            shift = ring.extra(i, j)
            binomials = ring.constant(comb(m, i) * comb(n, j))
            pairs.append((binomials, point[c].mapped(lambda key: key + shift)))
        result.append(sum_of_products(ring, pairs))
    return result


def substitute(surface, coordinates, ring):
    """F(X^, Y^, Z^, W^)."""
    powers = [[ring.constant(1)] for _ in coordinates]
    pairs = []
    for S, part in surface.parts.items():
        for key, c in part.items():
            factors = []
            for i, e in surface.ring.exponents(key):
                while len(powers[i]) <= e:
                    powers[i].append(powers[i][-1] * coordinates[i])
                factors.append(powers[i][e])
            # the last product is left to the sum, so that most of the work is done in one dictionary
            left = ring.constant(c, surface.den, S)
            for factor in factors[:-1]:
                left = left * factor
            pairs.append((left, factors[-1]))
    return sum_of_products(ring, pairs)


def patch_coefficients(s, points):
    """Grids (dictionaries of the non-zero coefficients) of F, W^e and W for the given points."""
    coordinates = hat(points, s.m, s.n, s.ring)
    f = substitute(s.surface, coordinates, s.ring)
    return f.split(), coordinates[3].power(s.e).split(), coordinates[3].split()


def equations(s):
    """All equations as a dictionary premise -> polynomial, in the order of premises (section 5)."""
    result = {}
    if s.patch:
        grid = substitute(s.surface, hat(s.points, s.m, s.n, s.ring), s.ring).split()
        zero = s.ring.constant(0)
        for r in range(s.e * s.m + 1):
            for q in range(s.e * s.n + 1):
                result["c", r, q] = grid.get((r, q), zero)
    else:
        for k, f in enumerate(s.polynomials):
            result["f", k + 1, 0] = f
    for k, d in enumerate(s.nonzero):
        t = s.ring.variable(len(s.unknowns) + k)
        result["nonzero", k + 1, 0] = d * t - s.ring.constant(1)
    return result
