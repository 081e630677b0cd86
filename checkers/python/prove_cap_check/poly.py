"""Polynomials over K (FORMAT.md section 1).

A power product is one integer: fields of 10 bits, from the top: two extra fields (for p, q of section 3, or h of
section 6), the total degree, the exponent of x0, x1, ... Exponents and degrees are at most 1000 (section 7), so that no
field overflows; products of power products are sums of integers, and the order of terms is the order of integers.

A polynomial is a positive common denominator and for each mask S a dictionary from power products to integers.
"""

from collections import defaultdict
from math import gcd, lcm

from . import limits
from .limits import need

BITS = 10
FIELD = (1 << BITS) - 1


class Ring:
    """K[names]; all polynomials of one computation share a ring."""

    def __init__(self, field, names):
        self.field = field
        self.names = list(names)
        n = len(self.names)
        self.n = n
        self.degree_shift = BITS * n
        self.extra_shift = BITS * (n + 1)
        self.plain = (1 << self.extra_shift) - 1
        self.shifts = [BITS * (n - 1 - i) for i in range(n)]
        self.units = [(1 << self.degree_shift) | (1 << s) for s in self.shifts]
        self.power_cache = {}  # used by the reader of canonical spelling

    def extra(self, i, j=0):
        """The key of p^i q^j (or h^i); it does not count in the degree."""
        return (i << self.extra_shift) | (j << (self.extra_shift + BITS))

    def extra_of(self, key):
        return (key >> self.extra_shift) & FIELD, key >> (self.extra_shift + BITS)

    def degree_of(self, key):
        return (key >> self.degree_shift) & FIELD

    def exponents(self, key):
        """Pairs (variable, exponent) with exponent > 0, in the order of variables."""
        rest = key & ((1 << self.degree_shift) - 1)
        found = []
        while rest:
            place = (rest.bit_length() - 1) // BITS
            e = rest >> (BITS * place)
            rest -= e << (BITS * place)
            found.append((self.n - 1 - place, e))
        return found

    def constant(self, numerator, denominator=1, mask=0):
        return make(self, denominator, {mask: {0: numerator}})

    def variable(self, index):
        return Poly(self, 1, {0: {self.units[index]: 1}})


class Poly:
    """Immutable by convention; always in normal form (see `make`), so that equality is equality of the parts."""

    __slots__ = ("ring", "den", "parts", "_degree", "_bits")

    def __init__(self, ring, den, parts):
        self.ring = ring
        self.den = den
        self.parts = parts
        self._degree = self._bits = None

    def __eq__(self, other):
        return self.den == other.den and self.parts == other.parts

    def __hash__(self):
        return hash((self.den, frozenset((S, frozenset(part.items())) for S, part in self.parts.items())))

    def __bool__(self):
        return bool(self.parts)

    def terms(self):
        return sum(map(len, self.parts.values()))

    def keys(self):
        return {key for part in self.parts.values() for key in part}

    def degree(self):
        if self._degree is None:
            shift = self.ring.degree_shift
            self._degree = max(((key >> shift) & FIELD for part in self.parts.values() for key in part), default=0)
        return self._degree

    def bits(self):
        """The length of the longest integer."""
        if self._bits is None:
            self._bits = max((c.bit_length() for part in self.parts.values() for c in part.values()), default=0)
            self._bits = max(self._bits, self.den.bit_length())
        return self._bits

    def all_bits(self):
        """At least the bits of all numbers; exact only if that matters for the limit of a statement."""
        total = 0
        for part in self.parts.values():
            for c in part.values():
                g = gcd(c, self.den)
                total += (c // g).bit_length() + (self.den // g).bit_length()
        return total

    def is_constant(self):
        return all(key == 0 for part in self.parts.values() for key in part)

    def entries(self):
        """A constant as (mask, integer) pairs, without the denominator: for signs."""
        return [(S, part[0]) for S, part in self.parts.items()]

    def sign(self):
        return self.ring.field.sign(self.entries())

    def coefficient(self, S, key):
        return self.parts.get(S, {}).get(key, 0)

    def __neg__(self):
        return Poly(self.ring, self.den, {S: {k: -c for k, c in part.items()} for S, part in self.parts.items()})

    def __add__(self, other):
        return combine(self.ring, [(1, 1, self), (1, 1, other)])

    def __sub__(self, other):
        return combine(self.ring, [(1, 1, self), (-1, 1, other)])

    def __mul__(self, other):
        return sum_of_products(self.ring, [(self, other)])

    def scaled(self, numerator, denominator=1):
        return combine(self.ring, [(numerator, denominator, self)])

    def power(self, n):
        result, square = self.ring.constant(1), self
        while n:
            if n & 1:
                result = result * square
            n >>= 1
            if n:
                square = square * square
        return result

    def mapped(self, function):
        """Replace every power product by function(power product), which must be one to one or may merge terms."""
        parts = {}
        for S, part in self.parts.items():
            new = parts[S] = defaultdict(int)
            for key, c in part.items():
                new[function(key)] += c
        return make(self.ring, self.den, parts)

    def inverse(self):
        """1/a for a constant a != 0: multiply by the conjugates, one root after the other, until it is rational."""
        top, bottom = self.ring.constant(1), self
        for b in range(len(self.ring.field.radicands)):
            conjugate = Poly(self.ring, bottom.den, {
                S: {k: -c if S >> b & 1 else c for k, c in part.items()} for S, part in bottom.parts.items()})
            if conjugate.parts != bottom.parts:
                top, bottom = top * conjugate, bottom * conjugate
        value = bottom.parts[0][0]
        return top.scaled(bottom.den if value > 0 else -bottom.den, abs(value))

    def split(self):
        """Collect by the extra fields: a dictionary (i, j) -> the coefficient of p^i q^j."""
        ring, found = self.ring, {}
        for S, part in self.parts.items():
            for key, c in part.items():
                found.setdefault(ring.extra_of(key), {}).setdefault(S, {})[key & ring.plain] = c
        return {place: make(ring, self.den, parts) for place, parts in found.items()}


def make(ring, den, parts):
    """The normal form: no zero coefficients, no empty parts, denominator coprime to the coefficients; limits checked."""
    clean, g, terms = {}, den, 0
    for S, part in parts.items():
        part = {key: c for key, c in part.items() if c}
        if part:
            clean[S] = part
            terms += len(part)
            if g > 1:
                g = gcd(g, *part.values())
    if not clean:
        return Poly(ring, 1, {})
    if g > 1:
        den //= g
        clean = {S: {key: c // g for key, c in part.items()} for S, part in clean.items()}
    result = Poly(ring, den, clean)
    need(terms <= limits.TERMS, "a polynomial has too many terms")
    if terms * (ring.n + 1) > limits.POWERS:
        powers = sum(len(ring.exponents(key)) for part in clean.values() for key in part)
        need(powers <= limits.POWERS, "a polynomial has too many powers of variables")
    need(result.bits() <= limits.NUMBER_BITS, "a number has too many bits")
    if terms * result.bits() > limits.SUM_BITS:
        total = sum(c.bit_length() for part in clean.values() for c in part.values())
        need(total <= limits.SUM_BITS, "the numbers of a sum have too many bits")
    return result


def combine(ring, summands):
    """The sum of a/b * polynomial over triples (a, b, polynomial)."""
    den = 1
    for a, b, f in summands:
        if a and f.parts:
            den = lcm(den, b * f.den)
            need(den.bit_length() <= limits.NUMBER_BITS, "a common denominator has too many bits")
    parts = {}
    for a, b, f in summands:
        if not a or not f.parts:
            continue
        scale = a * (den // (b * f.den))
        need(scale.bit_length() + f.bits() <= limits.NUMBER_BITS + 64, "a number has too many bits")
        for S, part in f.parts.items():
            limits.charge(len(part))
            if S not in parts:
                parts[S] = defaultdict(int, part if scale == 1 else {k: scale * c for k, c in part.items()})
            else:
                target = parts[S]
                for key, c in part.items():
                    target[key] += scale * c
    return make(ring, den, parts)


def sum_of_products(ring, pairs):
    """The sum of a * b over the pairs: one common denominator, one dictionary for each mask."""
    pairs = [(a, b) for a, b in pairs if a.parts and b.parts]
    den = 1
    for a, b in pairs:
        # degrees are limited also where the product cancels later (section 7)
        need(a.degree() + b.degree() <= limits.DEGREE, "the degree of a product is too large")
        den = lcm(den, a.den * b.den)
        need(den.bit_length() <= limits.NUMBER_BITS, "a common denominator has too many bits")
    parts = {}
    for a, b in pairs:
        scale = den // (a.den * b.den)
        need(a.bits() + b.bits() + scale.bit_length() <= limits.NUMBER_BITS, "a number has too many bits")
        for S, left in a.parts.items():
            for T, right in b.parts.items():
                # sqrt(n_S) sqrt(n_T) = n_(S and T) sqrt(n_(S xor T))
                factor = scale * ring.field.n[S & T]
                multiply_into(parts.setdefault(S ^ T, defaultdict(int)), left, right, factor)
    return make(ring, den, parts)


def multiply_into(target, left, right, factor):
    if len(left) > len(right):
        left, right = right, left
    limits.charge(len(left) * len(right))
    right = list(right.items())
    for key, c in left.items():
        c *= factor
        for other, d in right:
            target[key + other] += c * d
    need(len(target) <= 4 * limits.TERMS, "a polynomial has too many terms")


def evaluate(f, values):
    """f at constants, one for each of the first variables of the ring; f has none of the others."""
    ring = f.ring
    tables = [[ring.constant(1)] for _ in values]
    pairs = []
    for S, part in f.parts.items():
        for key, c in part.items():
            product = ring.constant(1)
            for i, e in ring.exponents(key):
                table = tables[i]
                while len(table) <= e:
                    table.append(table[-1] * values[i])
                product = product * table[e] if product.den != 1 or e else product
            pairs.append((ring.constant(c, f.den, S), product))
    return sum_of_products(ring, pairs)
