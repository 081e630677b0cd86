"""Polynomials on boxes of the unit square, and trees of boxes (FORMAT.md section 6, `Coefficients on a box`)."""

from math import comb, lcm

from . import limits
from .limits import need, rule

PRECISION = 96


class Grid:
    """The coefficients of p^(D-k) q^k (in both variables) on a box, up to a positive factor, as integers.

    `parts` is a list of (mask, rows); rows[k][l] belongs to q^k in u and q^l in v."""

    def __init__(self, field, parts):
        self.field = field
        self.parts = parts

    def halves(self, axis):
        """The lower and the upper half across u (axis 0) or v (axis 1)."""
        lower, upper = [], []
        for S, rows in self.parts:
            if axis:
                rows = list(zip(*rows))
            low, high = halve(rows)
            if axis:
                low, high = list(map(list, zip(*low))), list(map(list, zip(*high)))
            lower.append((S, low))
            upper.append((S, high))
        return Grid(self.field, lower), Grid(self.field, upper)

    def holds(self, strict):
        """Whether all coefficients are positive (strict) or not negative."""
        if not self.parts:
            return not strict
        if len(self.parts) == 1:
            least = min(map(min, self.parts[0][1]))
            return least > 0 if strict else least >= 0
        roots = self.field.roots(PRECISION)
        masks = [S for S, _ in self.parts]
        factors = [roots[S] for S in masks]
        for rows in zip(*[rows for _, rows in self.parts]):
            for entry in zip(*rows):
                # every root is short by less than 1, so that the error is less than the sum of |c|; close to 0 decide exactly
                value = sum(map(int.__mul__, entry, factors))
                if abs(value) <= sum(map(abs, entry)):
                    value = self.field.sign(zip(masks, entry))
                if value < 0 or (strict and value == 0):
                    return False
        return True


def halve(rows):
    """Across the first index. On the lower half p = 2p' + q', q = q' (after multiplication by 2^D): a Taylor shift by

    additions, and powers of 2. The upper half is its mirror image."""
    degree = len(rows) - 1
    limits.charge(2 * degree * degree * len(rows[0]))
    return shift_and_scale(rows[::-1], degree)[::-1], shift_and_scale(rows, degree)


def shift_and_scale(rows, degree):
    rows = list(rows)
    for i in range(degree):
        for j in range(degree - 1, i - 1, -1):
            rows[j] = [a + b for a, b in zip(rows[j], rows[j + 1])]
    return [[a << j for a in row] for j, row in enumerate(rows)]


def grid_of(s, coefficients, degrees):
    """From constants at (k, l), the coefficients of u^k (1-u)^(D-k) v^l (1-v)^(E-l): that is the box of the whole square."""
    den = 1
    for f in coefficients.values():
        den = lcm(den, f.den)
        need(den.bit_length() <= limits.NUMBER_BITS, "a common denominator has too many bits")
    rows = {}
    for (k, l), f in coefficients.items():
        for S, c in f.entries():
            if S not in rows:
                rows[S] = [[0] * (degrees[1] + 1) for _ in range(degrees[0] + 1)]
            rows[S][k][l] = c * (den // f.den)
    return Grid(s.field, sorted(rows.items()))


def check_tree(tree, grid, strict, what):
    """On the boxes `.` the coefficients are positive (or not negative), on the boxes `h` they are not all so."""
    stack = [(grid, 0)]
    for letter in tree:
        grid, depth = stack.pop()
        holds = grid.holds(strict)
        if letter == ".":
            rule(holds, "%s: a box does not show it" % what)
            continue
        rule(not holds, "%s: a box is halved that need not be" % what)
        need(depth * 64 <= limits.NUMBER_BITS, "a box is too small")
        lower, upper = grid.halves(depth % 2)
        stack.append((upper, depth + 1))
        stack.append((lower, depth + 1))


def from_powers(coefficients, degrees):
    """From constants at (a, b), the coefficients of u^a v^b, to those of `grid_of`: u^a = q^a (p+q)^(D-a)."""
    result = {}
    for (a, b), f in coefficients.items():
        for k in range(a, degrees[0] + 1):
            for l in range(b, degrees[1] + 1):
                part = f.scaled(comb(degrees[0] - a, k - a) * comb(degrees[1] - b, l - b))
                result[k, l] = result[k, l] + part if (k, l) in result else part
    return result
