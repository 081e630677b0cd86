"""`claim unreachable` (FORMAT.md section 6, rule 5, `Charts` and `Sides at a sample`)."""

from functools import lru_cache
from math import lcm, prod

from . import limits
from .boxes import PRECISION
from .bounds import check_quantity, ratio_bound
from .equations import patch_coefficients
from .limits import need, rule
from .poly import combine, make, sum_of_products


def substitute_product(ring, grids, z, w, names):
    """From here on the unknown z stands for z*w: z^a w^b becomes z^a w^(b-a), which must be a polynomial."""
    def change(key):
        e = (key >> ring.shifts[z]) & 1023
        f = (key >> ring.shifts[w]) & 1023
        rule(e <= f, "product %s*%s: %s has too small an exponent" % (names[z], names[w], names[w]))
        return key - e * ring.units[w]
    return [{place: f.mapped(change) for place, f in grid.items()} for grid in grids]


def substitute_form(side, index, form):
    """From here on the unknown stands for a form of degree 1 that contains it: every value of it is one of the form."""
    ring, by_exponent = side.ring, {}
    for S, part in side.parts.items():
        for key, c in part.items():
            e = dict(ring.exponents(key)).get(index, 0)
            by_exponent.setdefault(e, {}).setdefault(S, {})[key - e * ring.units[index]] = c
    pairs = [(make(ring, side.den, parts), form.power(e)) for e, parts in by_exponent.items()]
    return sum_of_products(ring, pairs)


class Sides:
    """The sides as polynomials in the unknowns and the odds t, s (extra fields), and in the charts at the samples.

    What a box shows depends on the degrees it is given (FORMAT.md, "Sides at a sample"): a side keeps its degrees, and the terms
    its exponents of h, also where its terms cancel or vanish at a sample."""

    def __init__(self, c, s):
        self.c, self.s, self.ring = c, s, s.ring
        grids = patch_coefficients(s, s.points)
        for z, w in c.products:
            grids = substitute_product(s.ring, grids, z, w, s.unknowns)
        f, power, weight = map(self.joined, grids)
        low, high = [ratio_bound(c.quantity, bound) for bound in c.between]
        self.sides = [combine(s.ring, [(1, 1, f), (-low.numerator, low.denominator, power)]),
                      combine(s.ring, [(-1, 1, f), (high.numerator, high.denominator, power)]), weight]
        for index, form in c.forms:
            self.sides = [substitute_form(side, index, form) for side in self.sides]
        self.degrees = [self.largest_exponents(side) for side in self.sides]
        self.charted = {}

    def joined(self, grid):
        summands = []
        for (k, l), f in grid.items():
            shift = self.ring.extra(k, l)
            summands.append((1, 1, f.mapped(lambda key: key + shift)))
        return combine(self.ring, summands)

    def largest_exponents(self, f):
        largest = [0] * len(self.s.unknowns)
        for key in f.keys():
            for i, e in self.ring.exponents(key):
                largest[i] = max(largest[i], e)
        return largest

    def in_chart(self, chart, kind, sample):
        """(den, (exponents, mask) -> integer, least, most): the side in the variables of the chart. The exponent of h is

        relative: h^D is left out, it is the same for all summands and the least power of h is divided out anyway."""
        if (chart, kind, sample) in self.charted:
            return self.charted[chart, kind, sample]
        ring, R = self.ring, self.c.range
        unknowns = len(self.s.unknowns)
        j = variable_of(chart)
        negative = chart > 1 and chart % 2 == 1
        (t, t_h), (s, s_h) = self.c.samples[sample]
        f = self.sides[kind]
        top = [max((ring.extra_of(key)[axis] for key in f.keys()), default=0) for axis in (0, 1)]
        den = f.den * t.denominator ** top[0] * s.denominator ** top[1]
        need(den.bit_length() <= limits.NUMBER_BITS, "a common denominator has too many bits")
        terms, powers_of_h = {}, []
        for S, part in f.parts.items():
            limits.charge(8 * len(part))
            for key, c in part.items():
                k, l = ring.extra_of(key)
                exponents = [0] * unknowns
                for i, e in ring.exponents(key):
                    exponents[i] = e
                degree = ring.degree_of(key)
                c *= R ** degree * t.numerator ** k * t.denominator ** (top[0] - k)
                c *= s.numerator ** l * s.denominator ** (top[1] - l)
                if j is not None:
                    if negative and exponents[j] % 2:
                        c = -c
                    exponents[j] = k * t_h + l * s_h - degree
                    powers_of_h.append(exponents[j])
                place = tuple(exponents), S
                terms[place] = terms.get(place, 0) + c
        least, most = min(powers_of_h, default=None), max(powers_of_h, default=None)
        self.charted[chart, kind, sample] = den, terms, least, most
        return self.charted[chart, kind, sample]

    def sum_in_chart(self, chart, terms):
        """The tensor of a sum: (degrees, mask -> flat list of integers), up to a positive factor."""
        j = variable_of(chart)
        found = [(factor,) + self.in_chart(chart, kind, sample) for factor, kind, sample in terms]
        den = lcm(*[entry[1] for entry in found])
        need(den.bit_length() <= limits.NUMBER_BITS, "a common denominator has too many bits")
        degrees = [max(entry) for entry in zip(*[self.degrees[kind] for _, kind, _ in terms])]
        least = min((entry[3] for entry in found if entry[3] is not None), default=0)
        if j is not None:
            degrees[j] = max((entry[4] for entry in found if entry[4] is not None), default=0) - least
        size = prod(d + 1 for d in degrees)
        need(size <= limits.TERMS, "a polynomial has too many terms")
        tensors = {}
        for factor, d, entries, _, _ in found:
            scale = factor * (den // d)
            for (exponents, S), c in entries.items():
                if c:
                    place = 0
                    for i, (e, degree) in enumerate(zip(exponents, degrees)):
                        place = place * (degree + 1) + (e - least if i == j else e)
                    tensors.setdefault(S, [0] * size)[place] += scale * c
        return degrees, tensors


def variable_of(chart):
    """The place of h in charts 2j and 2j + 1."""
    return (chart - 2) // 2 if chart > 1 else None


@lru_cache(maxsize=20000)
def substitution(degree, low, high, den):
    """Row a: the coefficients of (low p + high q)^a (den (p + q))^(D-a), that is of xi^a on the box from low/den to high/den."""
    def times(row, x, y):
        return [a * x + b * y for a, b in zip(row + [0], [0] + row)]
    rows = []
    for a in range(degree + 1):
        row = [1]
        for _ in range(a):
            row = times(row, low, high)
        for _ in range(degree - a):
            row = times(row, den, den)
        rows.append(row)
    return rows


def on_box(degrees, tensors, box):
    """The coefficients on a box, for every mask: one variable after the other.

    The first index is replaced and goes to the end, so that after k rounds the order is the old one."""
    result = {}
    for S, flat in tensors.items():
        for degree, interval in zip(degrees, box):
            if degree == 0:
                continue  # its index has the single value 0, and the factor is 1
            matrix = substitution(degree, *interval)
            rest = len(flat) // (degree + 1)
            limits.charge(len(flat) * (degree + 1))
            slices = [flat[a * rest:(a + 1) * rest] for a in range(degree + 1)]
            columns = list(zip(*matrix))
            flat = [sum(map(int.__mul__, column, entry)) for entry in zip(*slices) for column in columns]
        result[S] = flat
    return result


def no_positive(field, tensors):
    if not tensors:
        return True
    masks = list(tensors)
    if len(masks) == 1:
        return max(tensors[masks[0]]) <= 0
    factors = [field.roots(PRECISION)[S] for S in masks]
    for entry in zip(*tensors.values()):
        # as in boxes.Grid.holds: certain if the sum is larger than the error, else decided exactly
        value = sum(map(int.__mul__, entry, factors))
        if abs(value) <= sum(map(abs, entry)):
            value = field.sign(zip(masks, entry))
        if value > 0:
            return False
    return True


def check_unreachable(c, s):
    check_quantity(c, s, c.between)
    rule(c.between[0] < c.between[1], "no number is strictly between the two bounds")
    sides = Sides(c, s)
    k = len(s.unknowns)
    for number, chart in enumerate(c.charts, 1):
        j = variable_of(number)
        # an interval is (low, high, den); h in the place of xi_j goes from 0 to 1, all others from -1 to 1
        first = tuple((0, 1, 1) if i == j else (-1, 1, 1) for i in range(k))
        stack, sums = [(first, 0)], {}
        for line in chart:
            box, depth = stack.pop()
            if line is None:
                rule(k > 0, "without unknowns no box is halved")
                i = depth % k
                low, high, den = box[i]
                low, high, den = 2 * low, 2 * high, 2 * den
                middle = (low + high) // 2
                need(den.bit_length() <= 1024, "a box is too small")
                stack.append((box[:i] + ((middle, high, den),) + box[i + 1:], depth + 1))
                stack.append((box[:i] + ((low, middle, den),) + box[i + 1:], depth + 1))
                continue
            if line not in sums:
                sums[line] = sides.sum_in_chart(number, line)
            rule(no_positive(s.field, on_box(*sums[line], box)), "chart %d: a box is not excluded" % number)
    return "no values of the unknowns reach between the bounds"
