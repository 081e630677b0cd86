"""The statement file (FORMAT.md section 2) and its canonical text (section 4)."""

import hashlib
import re
import unicodedata

from . import limits, toml
from .expression import digits_limited, evaluate_expression
from .field import Field
from .limits import need
from .poly import Ring
from .spelling import write_polynomial

KEYS = ("title", "radicands", "unknowns", "nonzero", "define", "convention", "bidegree", "surface", "net", "polynomials")
PATCH_KEYS = ("convention", "bidegree", "surface", "net")
NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,%d}" % (limits.NAME - 1))
NO_NAMES = ("sqrt", "X", "Y", "Z", "W")
COORDINATES = "XYZW"
FORBIDDEN_IN_TITLE = [(0xAD, 0xAD), (0x61C, 0x61C), (0x180E, 0x180E), (0x200B, 0x200F), (0x2028, 0x202E),
                      (0x2060, 0x206F), (0xFEFF, 0xFEFF), (0xFFF9, 0xFFFB), (0xE0000, 0xE007F)]


class Statement:
    """field, ring (the unknowns, then the t[k]), unknowns (names), nonzero (the d_k), patch (a truth value), and

    for a system: polynomials; for a patch: surface (in a ring of X, Y, Z, W), m, n, and points, a dictionary
    (i, j) -> the four homogeneous coordinates."""

    def polynomial_lines(self):
        """Pairs (what stands in front, polynomial) of the canonical text, None for its other lines."""
        for f in self.nonzero:
            yield "nonzero", f
        if not self.patch:
            for f in self.polynomials:
                yield "zero", f
            return
        yield "surface", self.surface
        yield "bidegree %d %d" % (self.m, self.n), None
        for (i, j), point in sorted(self.points.items()):
            for letter, f in zip(COORDINATES, point):
                yield "%s[%d,%d]" % (letter, i, j), f

    def canonical(self):
        lines = ["prove-cap statement 1", " ".join(["radicands"] + [str(d) for d in self.field.radicands]),
                 " ".join(["unknowns"] + self.unknowns)]
        for head, f in self.polynomial_lines():
            lines.append(head if f is None else head + " " + write_polynomial(f))
        return "\n".join(lines + ["end"]) + "\n"

    def hash(self):
        return hashlib.sha256(self.canonical().encode("ascii")).hexdigest()

    def is_sphere(self):
        """Whether the surface is X^2 + Y^2 + Z^2 - W^2, for what section 6 says of radii and covers."""
        return self.patch and write_polynomial(self.surface) == "X^2 + Y^2 + Z^2 - W^2"


def read_file(path, largest):
    try:
        with open(path, "rb") as file:
            data = file.read(largest + 1)
    except OSError as error:
        raise limits.Malformed("cannot read %s: %s" % (path, error.strerror))
    need(len(data) <= largest, "%s is longer than %d bytes" % (path, largest))
    return data


def array(value, what, largest, length=None):
    need(type(value) is list, "%s is not an array" % what)
    need(len(value) <= largest, "%s has too many entries" % what)
    need(length is None or len(value) == length, "%s has not %s entries" % (what, length))
    return value


def is_prime(n):
    d = 2
    while d * d <= n:
        if n % d == 0:
            return False
        d += 1
    return n >= 2


def check_title(table):
    title = table.get("title")
    need(type(title) is str, "the title is missing or no string")
    need(len(title) <= limits.TITLE, "the title is too long")
    for letter in title:
        bad = unicodedata.category(letter) == "Cc" or any(a <= ord(letter) <= b for a, b in FORBIDDEN_IN_TITLE)
        need(not bad, "a character of the title is not allowed")


def declare(name, seen):
    need(type(name) is str and NAME.fullmatch(name) and name not in NO_NAMES, "not a name: %.40r" % (name,))
    need(name not in seen, "declared twice: %s" % name)
    seen.add(name)


def read_statement(path):
    table = toml.read(read_file(path, limits.STATEMENT_BYTES))
    for key in table:
        need(key in KEYS, "unknown key %.40r" % key)
    check_title(table)
    s = Statement()

    radicands = array(table.get("radicands"), "radicands", limits.RADICANDS)
    for d in radicands:
        need(type(d) is int and 0 < d <= limits.RADICAND and is_prime(d), "a radicand is not a prime up to 1000000")
    need(len(set(radicands)) == len(radicands), "a radicand is there twice")
    s.field = Field(radicands)

    s.unknowns = list(array(table.get("unknowns"), "unknowns", limits.UNKNOWNS))
    seen = set()
    for name in s.unknowns:
        declare(name, seen)
    nonzero = array(table.get("nonzero", []), "nonzero", limits.ASSUMPTIONS)
    s.ring = Ring(s.field, s.unknowns + ["t[%d]" % (k + 1) for k in range(len(nonzero))])

    # constants may use those above them in the file (dictionaries keep that order), and no unknowns
    define = table.get("define", {})
    need(type(define) is dict, "define is not a table")
    constants = {}
    for name, value in define.items():
        declare(name, seen)
        need(name not in KEYS, "a constant is called like a key: %s" % name)
        constants[name] = evaluate_expression(value, s.ring, constants)

    names = dict(constants)
    for i, name in enumerate(s.unknowns):
        names[name] = s.ring.variable(i)
    s.nonzero = [evaluate_expression(value, s.ring, names) for value in nonzero]
    need(all(s.nonzero), "an assumption is that 0 is not 0")

    s.patch = "polynomials" not in table
    if s.patch:
        read_patch(s, table, constants, names)
    else:
        need(not any(key in table for key in PATCH_KEYS), "a system has no key of a patch")
        values = array(table["polynomials"], "polynomials", limits.POLYNOMIALS)
        s.polynomials = [evaluate_expression(value, s.ring, names) for value in values]
    total = 0
    for _, f in s.polynomial_lines():
        if f is not None:
            # the product bounds the bits from above; count exactly only where that could matter
            total += f.all_bits() if f.terms() * f.bits() > 1000000 else 2 * f.terms() * f.bits()
    if total > limits.STATEMENT_BITS:
        total = sum(f.all_bits() for _, f in s.polynomial_lines() if f is not None)
    need(total <= limits.STATEMENT_BITS, "the numbers of the statement have too many bits")
    return s


def read_patch(s, table, constants, names):
    convention = table.get("convention")
    need(convention in ("cartesian", "homogeneous"), "convention is not cartesian or homogeneous")
    for value in array(table.get("bidegree"), "bidegree", 2, 2):
        need(type(value) is int and 1 <= value <= limits.BIDEGREE, "bidegree is not two integers from 1 to 32")
    s.m, s.n = table["bidegree"]

    ring = Ring(s.field, COORDINATES)
    # constants are polynomials without variables, they have the same keys in every ring
    surface_names = {name: type(f)(ring, f.den, f.parts) for name, f in constants.items()}
    surface_names.update((letter, ring.variable(i)) for i, letter in enumerate(COORDINATES))
    s.surface = evaluate_expression(table.get("surface", "X^2 + Y^2 + Z^2 - W^2"), ring, surface_names)
    s.e = s.surface.degree()
    need(1 <= s.e <= limits.SURFACE_DEGREE, "the degree of the surface is not from 1 to 8")
    need(all(ring.degree_of(key) == s.e for key in s.surface.keys()), "the surface is not homogeneous")

    s.points = {}
    for i, row in enumerate(array(table.get("net"), "net", s.m + 1, s.m + 1)):
        for j, point in enumerate(array(row, "a row of net", s.n + 1, s.n + 1)):
            values = [evaluate_expression(value, s.ring, names) for value in array(point, "a point", 4, 4)]
            if convention == "cartesian":
                x, y, z, w = values
                values = [digits_limited(w * x), digits_limited(w * y), digits_limited(w * z), w]
            s.points[i, j] = values
    need(any(point[3] for point in s.points.values()), "every W is zero")
