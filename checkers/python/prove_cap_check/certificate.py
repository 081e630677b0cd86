"""Certificates (FORMAT.md section 5): a strict reader, one spelling of each certificate."""

import hashlib
import re
from fractions import Fraction

from . import limits
from .limits import Malformed, need
from .spelling import decimal, natural, rational, rational_pair, read_polynomial

PREMISE = re.compile(r"(c)\[([0-9]+),([0-9]+)\]|(f|nonzero)\[([0-9]+)\]|(step) ([0-9]+)")
KIND_ORDER = {"c": 0, "f": 1, "nonzero": 2, "step": 3}
SIDES = ("lower", "upper", "weight")
SIDE = re.compile(r"([0-9]+)\*(lower|upper|weight)\[([0-9]+)\]")
HASH = re.compile(r"[0-9a-f]{64}")


class Certificate:
    """`hash` and `claim`; the other attributes depend on the claim, see the functions below."""


class Lines:
    def __init__(self, data):
        need(data.endswith(b"\n"), "the last line is not ended by a newline")
        lines = data[:-1].split(b"\n")
        for line in lines:
            need(len(line) <= limits.LINE_BYTES, "a line is too long")
            need(not line or (min(line) >= 0x20 and max(line) <= 0x7E), "a byte is not from 0x20 to 0x7E")
        self.lines = [line.decode("ascii") for line in lines]
        self.at = 0
        self.sealed = hashlib.sha256(data[:len(data) - len(lines[-1]) - 1]).hexdigest()

    def peek(self):
        need(self.at < len(self.lines), "the certificate ends too early")
        return self.lines[self.at]

    def take(self, start=""):
        """The rest of the next line, which must begin with `start`."""
        line = self.peek()
        need(line.startswith(start), "line %d: expected %r, not %.60r" % (self.at + 1, start, line))
        self.at += 1
        return line[len(start):]

    def exactly(self, text):
        need(self.take(text) == "", "line %d: expected %r" % (self.at, text))

    def end(self, count, sealed):
        self.exactly("end %d %s" % (count, self.sealed) if sealed else "end %d" % count)
        need(self.at == len(self.lines), "something follows the last line")


def read_certificate(data, statement):
    lines = Lines(data)
    c = Certificate()
    version = lines.take("prove-cap certificate ")
    need(version in ("1", "2"), "a version of the format that this checker does not know")
    c.version = int(version)
    c.hash = lines.take("statement sha256 ")
    need(HASH.fullmatch(c.hash), "not a hash")
    c.claim = lines.take("claim ")
    readers = {"impossible": read_steps, "exact": read_exact, "bounds": read_bounds, "cover": read_cover,
               "unreachable": read_unreachable}
    need(c.claim in readers, "unknown claim %.40r" % c.claim)
    need(c.version == 1 or c.claim in ("bounds", "unreachable"), "nothing of version 2 is in this claim")
    try:
        readers[c.claim](c, lines, statement)
    except Malformed as error:
        raise Malformed("certificate, near line %d: %s" % (lines.at, error))
    return c


# Refutations and solutions

def read_steps(c, lines, statement):
    """steps: a list of (list of (premise, multiplier), conclusion); a premise is (kind, index, index or 0)."""
    c.steps = []
    while lines.peek().startswith("step "):
        number = len(c.steps) + 1
        need(number <= limits.STEPS, "too many steps")
        lines.exactly("step %d" % number)
        adds, last = [], None
        while lines.peek().startswith("add "):
            name, times, text = lines.take("add ").partition(" times ")
            need(times, "an add line has no multiplier")
            premise = read_premise(name, number)
            place = (KIND_ORDER[premise[0]],) + premise[1:]
            need(last is None or last < place, "the premises are not in order")
            last = place
            multiplier = read_polynomial(text, statement.ring)
            need(multiplier, "a multiplier is zero")
            adds.append((premise, multiplier))
        need(adds, "a step adds nothing")
        c.steps.append((adds, read_polynomial(lines.take("conclude "), statement.ring)))
    lines.end(len(c.steps), False)


def read_premise(text, number):
    match = PREMISE.fullmatch(text)
    need(match, "not a premise: %.40r" % text)
    kind, *indices = [group for group in match.groups() if group is not None]
    indices = [natural(index, limits.INDEX) for index in indices]
    if kind == "step":
        need(indices[0] < number, "a step uses itself or a later one")
    return (kind, indices[0], indices[1] if len(indices) > 1 else 0)


def read_values(c, lines, statement):
    """values: one constant of K for each unknown, in order."""
    c.values = []
    for name in statement.unknowns:
        value = read_polynomial(lines.take("value %s = " % name), statement.ring)
        need(value.is_constant(), "the value of %s is no constant" % name)
        c.values.append(value)


def read_exact(c, lines, statement):
    read_values(c, lines, statement)
    lines.end(len(c.values), False)


# Arguments by subdivision

def read_tree(text):
    """A binary tree in preorder: `open` counts the boxes that must still come."""
    need(text and not text.strip("h."), "not a tree: %.40r" % text)
    need(len(text) <= limits.BOXES, "a tree has too many boxes")
    still = 1
    for letter in text:
        need(still > 0, "a tree goes on after its end")
        still += 1 if letter == "h" else -1
    need(still == 0, "a tree is not complete")
    return text


def read_quantity(c, lines):
    kind, _, places = lines.take("quantity ").partition(" ")
    need(kind in ("radius", "ratio"), "unknown quantity %.40r" % kind)
    c.quantity, c.places = kind, natural(places, limits.PLACES)


def read_end_of_bounds(c, lines, word):
    parts = lines.take(word + " ").split(" ")
    need(len(parts) == 6 and parts[1] == "at" and parts[4] == "over", "not a bound")
    u, v = rational(parts[2]), rational(parts[3])
    need(u <= 1 and v <= 1, "a point is outside the unit square")
    return decimal(parts[0], c.places), u, v, read_tree(parts[5])


def read_bounds(c, lines, statement):
    """lower, upper: (decimal, u, v, tree)."""
    read_values(c, lines, statement)
    read_quantity(c, lines)
    c.odds = (Fraction(1), Fraction(1))
    if c.version == 2:
        odds = lines.take("odds ").split(" ")
        need(len(odds) == 2, "not two odds")
        c.odds = tuple(Fraction(*rational_pair(text)) for text in odds)
        need(min(c.odds) > 0 and c.odds != (1, 1), "odds that are not positive, or both 1")
    c.denominator = read_tree(lines.take("denominator "))
    c.lower = read_end_of_bounds(c, lines, "lower")
    c.upper = read_end_of_bounds(c, lines, "upper")
    lines.end(sum(tree.count(".") for tree in (c.denominator, c.lower[3], c.upper[3])), True)


EDGES = ("u=0", "u=1", "v=0", "v=1")


def read_cover(c, lines, statement):
    """edges: for each of EDGES a tree, or None for a point; regular: (sign, tree)."""
    read_values(c, lines, statement)
    c.denominator = read_tree(lines.take("denominator "))
    c.edges = []
    for edge in EDGES:
        rest = lines.take("edge %s " % edge)
        if rest == "point":
            c.edges.append(None)
        else:
            need(rest.startswith("arc "), "an edge is neither arc nor point")
            c.edges.append(read_tree(rest[4:]))
    word, _, tree = lines.take("regular ").partition(" ")
    need(word in ("outward", "inward"), "neither outward nor inward")
    c.regular = (1 if word == "outward" else -1, read_tree(tree))
    trees = [c.denominator, c.regular[1]] + [tree for tree in c.edges if tree is not None]
    lines.end(sum(tree.count(".") for tree in trees), True)


def read_odds(text):
    """(kappa, 1 for kappa*h or 0 for kappa)."""
    times_h = text.endswith("*h")
    return Fraction(*rational_pair(text[:-2] if times_h else text)), int(times_h)


def read_form(spelled, index, statement):
    """A polynomial of degree 1 with rational coefficients that contains the unknown, and is not it alone."""
    form, ring = read_polynomial(spelled, statement.ring), statement.ring
    for S, part in form.parts.items():
        need(S == 0, "a coefficient that is not rational")
        for key in part:
            used = ring.exponents(key)
            need(ring.degree_of(key) <= 1 and all(i < len(statement.unknowns) for i, _ in used), "not a form of degree 1")
    need(any((index, 1) in ring.exponents(key) for key in form.keys()), "a form without its unknown")
    need(form != ring.variable(index), "the unknown itself")
    return form


def read_unreachable(c, lines, statement):
    """between: (low, high); products: pairs of variables; range; samples: pairs of odds; charts: lists of None (a halved

    box) or of a sum, a tuple of (factor, side, sample from 0)."""
    read_quantity(c, lines)
    bounds = lines.take("between ").split(" ")
    need(len(bounds) == 2, "not two bounds")
    c.between = tuple(decimal(bound, c.places) for bound in bounds)
    c.products = []
    while lines.peek().startswith("product "):
        names = lines.take("product ").split("*")
        need(len(names) == 2 and all(name in statement.unknowns for name in names), "not a product of two unknowns")
        need(names[0] != names[1], "not a product of two different unknowns")
        c.products.append(tuple(statement.unknowns.index(name) for name in names))
    need(len(c.products) <= len(statement.unknowns), "more products than unknowns")
    c.forms = []
    while lines.peek().startswith("put "):
        name, _, spelled = lines.take("put ").partition(" = ")
        need(name in statement.unknowns, "not an unknown")
        index = statement.unknowns.index(name)
        need(not c.forms or c.forms[-1][0] < index, "not a later unknown")
        c.forms.append((index, read_form(spelled, index, statement)))
    need(bool(c.forms) == (c.version == 2), "`put` is what version 2 is for")
    c.range = natural(lines.take("range "))
    need(c.range > 0, "the range is not positive")
    c.samples = []
    while lines.peek().startswith("sample "):
        need(len(c.samples) < limits.SAMPLES, "too many samples")
        odds = lines.take("sample %d at " % (len(c.samples) + 1)).split(" ")
        need(len(odds) == 2, "not two odds")
        c.samples.append(tuple(map(read_odds, odds)))
    c.charts, boxes, excluded = [], 0, 0
    for number in range(1, 2 * len(statement.unknowns) + 2):
        lines.exactly("chart %d" % number)
        chart, still = [], 1
        while still > 0:
            boxes += 1
            need(boxes <= limits.BOXES, "too many boxes")
            if lines.peek() == "halve":
                lines.take()
                chart.append(None)
                still += 1
            else:
                chart.append(read_sum(lines.take("exclude "), len(c.samples)))
                still -= 1
                excluded += 1
        c.charts.append(chart)
    lines.end(excluded, True)


def read_sum(text, samples):
    terms, last = [], None
    for term in text.split(" + "):
        match = SIDE.fullmatch(term)
        need(match, "not a side at a sample: %.40r" % term)
        factor, side, sample = natural(match.group(1)), SIDES.index(match.group(2)), natural(match.group(3))
        need(factor > 0, "a factor is not positive")
        need(1 <= sample <= samples, "there is no such sample")
        need(last is None or last < (side, sample), "the terms of a sum are not in order")
        last = (side, sample)
        terms.append((factor, side, sample - 1))
    return tuple(terms)
