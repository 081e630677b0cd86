"""`claim cover` (FORMAT.md section 6, rule 6)."""

from math import comb

from .boxes import check_tree, from_powers, grid_of
from .equations import hat
from .limits import Malformed, rule
from .poly import make, sum_of_products
from .replay import check_solution
from .spelling import write_polynomial

NEXT = ((1, 2), (2, 0), (0, 1))


def dot(ring, a, b):
    return sum_of_products(ring, list(zip(a, b)))


def cross(ring, a, b):
    return [sum_of_products(ring, [(a[i], b[j]), (-a[j], b[i])]) for i, j in NEXT]


def power_basis(s, f):
    """From hat coefficients at (i, j) to a polynomial in u, v (the extra fields): u^i (1-u)^(m-i) by the binomial formula."""
    ring, pairs = s.ring, []
    for (i, j), c in f.split().items():
        for a in range(i, s.m + 1):
            for b in range(j, s.n + 1):
                number = comb(s.m - i, a - i) * comb(s.n - j, b - j) * (-1) ** (a - i + b - j)
                shift = ring.extra(a, b)
                pairs.append((ring.constant(number), c.mapped(lambda key: key + shift)))
    return sum_of_products(ring, pairs)


def derivative(s, f, axis):
    ring, parts = s.ring, {}
    unit = ring.extra(1, 0) if axis == 0 else ring.extra(0, 1)
    for S, part in f.parts.items():
        for key, c in part.items():
            e = ring.extra_of(key)[axis]
            if e:
                parts.setdefault(S, {})[key - unit] = c * e
    return make(ring, f.den, parts)


def determinant(s, coordinates):
    """D = det[P, P_u, P_v] in the coefficients on the unit square, of degrees 3m - 2 and 3n - 2."""
    p = [power_basis(s, f) for f in coordinates[:3]]
    p_u, p_v = [[derivative(s, f, axis) for f in p] for axis in (0, 1)]
    degrees = (3 * s.m - 2, 3 * s.n - 2)
    powers = dot(s.ring, p, cross(s.ring, p_u, p_v)).split()
    if any(a > degrees[0] or b > degrees[1] for a, b in powers):
        raise Malformed("internal: a determinant has a larger degree than it can have")
    return from_powers(powers, degrees), degrees


def check_cover(c, s):
    rule(s.is_sphere(), "a cover is for a patch on X^2 + Y^2 + Z^2 - W^2")
    points = check_solution(s, c.values)
    ring, zero = s.ring, s.ring.constant(0)
    coordinates = hat(points, s.m, s.n, ring)
    grids = [f.split() for f in coordinates]
    check_tree(c.denominator, grid_of(s, grids[3], (s.m, s.n)), True, "denominator")

    det, (du, dv) = determinant(s, coordinates)
    count = 0
    for number, tree in enumerate(c.edges):
        axis, end = divmod(number, 2)          # axis 0: u = 0 or 1, and the parameter is v
        along = (s.m, s.n)[1 - axis]
        place = (lambda k: (end * s.m, k)) if axis == 0 else (lambda k: (k, end * s.n))
        curve = [[grid.get(place(k), zero) for grid in grids[:3]] for k in range(along + 1)]
        a_end, b_end = points[place(0)], points[place(along)]
        first, last, a, b = a_end[:3], b_end[:3], a_end[3], b_end[3]
        name = "edge %s=%d" % ("uv"[axis], end)
        if tree is None:
            count += 1
            rule(count == 1, "two edges are points")
            for p in curve:
                rule(not any(cross(ring, p, first)), name + " is no point")
            # D vanishes there, so that in the coefficients on the square the division is a shift: all have a factor q or p
            if axis == 0:
                du -= 1
                lost, det = divide(det, 0, du if end else -1)
            else:
                dv -= 1
                lost, det = divide(det, 1, dv if end else -1)
            if lost:
                raise Malformed("internal: D does not vanish along an edge that is a point")
            continue
        normal = cross(ring, first, last)
        rule(any(normal), name + ": its ends are parallel")
        for p in curve:
            rule(not dot(ring, normal, p), name + " leaves the plane of its ends")
        middle = [sum_of_products(ring, [(b, x), (a, y)]) for x, y in zip(first, last)]
        values = {place_in_grid(axis, k): dot(ring, middle, p) for k, p in enumerate(curve)}
        check_tree(tree, grid_of(s, values, (along, 0) if axis else (0, along)), True, name)

    sign, tree = c.regular
    if sign < 0:
        det = {place: -f for place, f in det.items()}
    check_tree(tree, grid_of(s, det, (du, dv)), True, "regular")
    corners = [points[i, j] for i in (0, s.m) for j in (0, s.n)]
    text = "; ".join(", ".join(write_polynomial(x * p[3].inverse()) for x in p[:3]) for p in corners)
    return "the patch covers a %s, normal %s, with the corners %s" % (
        "triangle" if count else "quadrilateral", "outward" if sign > 0 else "inward", text)


def place_in_grid(axis, k):
    return (k, 0) if axis else (0, k)


def divide(coefficients, axis, degree):
    """By q (degree < 0) or by p, where degree is the one after it: what is lost must be zero."""
    lost, result = False, {}
    for place, f in coefficients.items():
        k = place[axis] - 1 if degree < 0 else place[axis]
        if f and (k < 0 or 0 <= degree < k):
            lost = True
        elif f:
            result[(k, place[1]) if axis == 0 else (place[0], k)] = f
    return lost, result
