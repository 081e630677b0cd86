"""The canonical spelling of FORMAT.md section 1, and the decimals of section 5: exactly one spelling of each value."""

import re
from fractions import Fraction
from math import gcd, lcm

from . import limits
from .limits import need
from .poly import Poly, make

NATURAL = re.compile(r"0|[1-9][0-9]*")
RATIONAL = re.compile(r"(0|[1-9][0-9]*)(?:/([1-9][0-9]*))?")
POWER = re.compile(r"([A-Za-z0-9_\[\]]+)(?:\^([1-9][0-9]*))?")
SIGN = re.compile(r" ([+-]) ")
DECIMAL = re.compile(r"(-?)(0|[1-9][0-9]*)(?:\.([0-9]+))?")


def natural(text, largest=None):
    need(NATURAL.fullmatch(text), "not a natural number: %.40r" % text)
    need(len(text) <= limits.DIGITS, "a number has too many digits")
    value = int(text)
    need(largest is None or value <= largest, "a number is too large: %.40s" % text)
    return value


def rational_pair(text):
    """A rational >= 0 in lowest terms as (numerator, denominator); the denominator 1 is not written."""
    match = RATIONAL.fullmatch(text)
    need(match, "not a rational number: %.40r" % text)
    top, bottom = match.group(1), match.group(2)
    need(len(top) <= limits.DIGITS and len(bottom or "") <= limits.DIGITS, "a number has too many digits")
    if bottom is None:
        return int(top), 1
    a, b = int(top), int(bottom)
    need(b >= 2 and gcd(a, b) == 1, "not in lowest terms: %.40r" % text)
    return a, b


def rational(text):
    return Fraction(*rational_pair(text))


def decimal(text, places):
    """A bound with `places` decimals. There is no -0 (a sign only `if negative`) and no superfluous zero in front."""
    match = DECIMAL.fullmatch(text)
    need(match, "not a decimal: %.40r" % text)
    sign, whole, rest = match.group(1), match.group(2), match.group(3) or ""
    need(len(rest) == places, "a decimal has not %d places" % places)
    need(len(whole) + len(rest) <= limits.DIGITS, "a number has too many digits")
    value = int(whole + rest)
    need(not (sign and value == 0), "-0 is not negative")
    return Fraction(-value if sign else value, 10 ** places)


def read_polynomial(text, ring):
    """Read exactly the canonical spelling of a polynomial of the ring."""
    if text == "0":
        return Poly(ring, 1, {})
    negative = text.startswith("-")
    pieces = SIGN.split(text[1:] if negative else text)
    need(len(pieces) // 2 < limits.TERMS, "a polynomial has too many terms")
    signs = [negative] + [sign == "-" for sign in pieces[1::2]]
    found, last, den, powers = [], None, 1, 0
    for minus, term in zip(signs, pieces[0::2]):
        mask, key, a, b, count = read_term(term, ring)
        powers += count
        # terms in order, each once: the larger power product first, then the smaller mask
        place = (key << limits.RADICANDS) - mask
        need(last is None or place < last, "terms are not in order at %.40r" % term)
        last = place
        if b != 1:
            den = lcm(den, b)
            need(den.bit_length() <= limits.NUMBER_BITS, "a common denominator has too many bits")
        found.append((mask, key, -a if minus else a, b))
    need(powers <= limits.POWERS, "a polynomial has too many powers of variables")
    parts = {}
    for mask, key, a, b in found:
        parts.setdefault(mask, {})[key] = a * (den // b)
    return make(ring, den, parts)


def read_term(term, ring):
    factors = term.split("*")
    start, a, b, mask, key = 0, 1, 1, 0, 0
    if "0" <= factors[0][:1] <= "9":
        a, b = rational_pair(factors[0])
        need(a > 0, "a coefficient is zero")
        need(len(factors) == 1 or a != 1 or b != 1, "a coefficient 1 is left out in front of *")
        start = 1
    if start < len(factors) and factors[start] in ring.field.root_mask:
        mask = ring.field.root_mask[factors[start]]
        start += 1
    last, degree = -1, 0
    for factor in factors[start:]:
        found = ring.power_cache.get(factor)
        if found is None:
            found = ring.power_cache[factor] = read_power(factor, ring)
        need(found[0] > last, "variables are not in order in %.40r" % term)
        last = found[0]
        key += found[1]
        # in the loop, so that no field of the key overflows
        degree += ring.degree_of(found[1])
        need(degree <= limits.DEGREE, "a degree is too large")
    return mask, key, a, b, len(factors) - start


def read_power(text, ring):
    match = POWER.fullmatch(text)
    need(match, "not a power of a variable: %.40r" % text)
    name, exponent = match.groups()
    if not hasattr(ring, "places"):
        ring.places = {n: i for i, n in enumerate(ring.names)}
    need(name in ring.places, "not a variable: %.40r" % name)
    e = 1
    if exponent is not None:
        need(len(exponent) <= 4 and 2 <= int(exponent) <= limits.DEGREE, "an exponent is not from 2 to 1000")
        e = int(exponent)
    index = ring.places[name]
    return index, e * ring.units[index]


def write_polynomial(f):
    if not f:
        return "0"
    ring = f.ring
    terms = sorted(((-key, S, c) for S, part in f.parts.items() for key, c in part.items()))
    text = []
    for minus_key, S, c in terms:
        g = gcd(c, f.den)
        top, bottom = abs(c) // g, f.den // g
        factors = [ring.field.root_text[S]] if S else []
        factors += [ring.names[i] if e == 1 else "%s^%d" % (ring.names[i], e) for i, e in ring.exponents(-minus_key)]
        number = str(top) if bottom == 1 else "%d/%d" % (top, bottom)
        if number != "1" or not factors:
            factors.insert(0, number)
        if text:
            text.append(" - " if c < 0 else " + ")
        elif c < 0:
            text.append("-")
        text.append("*".join(factors))
    return "".join(text)
