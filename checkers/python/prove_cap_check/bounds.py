"""`claim bounds` (FORMAT.md section 6, rule 4)."""

from fractions import Fraction

from .boxes import check_tree, grid_of
from .equations import patch_coefficients
from .limits import rule
from .poly import combine
from .replay import points_at_values


def ratio_bound(quantity, bound):
    """A bound b on the radius means the bound b^2 - 1 on F/W^2."""
    return bound * bound - 1 if quantity == "radius" else bound


def check_quantity(c, s, bounds):
    rule(s.patch, "bounds are for patches")
    if c.quantity == "radius":
        rule(s.is_sphere(), "a radius is for the surface X^2 + Y^2 + Z^2 - W^2 only")
        rule(all(bound >= 0 for bound in bounds), "a bound of a radius is negative")


def difference(s, f, weight, bound, sign):
    """sign * (F - bound * W^e), coefficient by coefficient."""
    result = {}
    zero = s.ring.constant(0)
    for place in set(f) | set(weight):
        a, b = f.get(place, zero), weight.get(place, zero)
        result[place] = combine(s.ring, [(sign, 1, a), (-sign * bound.numerator, bound.denominator, b)])
    return result


def at_point(s, coefficients, degrees, u, v):
    summands = []
    for (k, l), f in coefficients.items():
        x = u ** k * (1 - u) ** (degrees[0] - k) * v ** l * (1 - v) ** (degrees[1] - l)
        summands.append((x.numerator, x.denominator, f))
    return combine(s.ring, summands)


def check_bounds(c, s):
    check_quantity(c, s, (c.lower[0], c.upper[0]))
    # the boxes are those of u', v' with u/(1-u) = lambda u'/(1-u'): row i of the net times lambda^i, column j times mu^j
    points = {}
    for (i, j), point in points_at_values(s, c.values).items():
        factor = c.odds[0] ** i * c.odds[1] ** j
        points[i, j] = [x.scaled(factor.numerator, factor.denominator) for x in point]
    f, power, weight = patch_coefficients(s, points)
    degrees = (s.e * s.m, s.e * s.n)
    check_tree(c.denominator, grid_of(s, weight, (s.m, s.n)), True, "denominator")
    step = Fraction(1, 10 ** c.places)
    for word, sign, (bound, u, v, tree) in (("lower", 1, c.lower), ("upper", -1, c.upper)):
        side = difference(s, f, power, ratio_bound(c.quantity, bound), sign)
        # no radius is negative: the bound 0 needs no boxes
        if not (word == "lower" and c.quantity == "radius" and bound == 0 and tree == "."):
            check_tree(tree, grid_of(s, side, degrees), False, word)
        following = bound + sign * step
        if c.quantity == "radius" and following < 0:
            # radius >= a negative number holds everywhere
            continue
        side = difference(s, f, power, ratio_bound(c.quantity, following), sign)
        u, v = [x / (x + odds * (1 - x)) for x, odds in zip((u, v), c.odds)]
        rule(at_point(s, side, degrees, u, v).sign() <= 0, "%s: the next decimal is a bound at the point too" % word)
    return "the bounds hold and are sharp"
