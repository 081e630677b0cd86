"""Expressions of statements (FORMAT.md section 2): tokens, a recursive descent, and the value as a polynomial."""

import re
from math import isqrt

from . import limits
from .field import square_root
from .limits import Malformed, need
from .poly import make

TOKEN = re.compile(r"[ \t\n\r]*(?:([0-9]+(?:\.[0-9]+)?)|([A-Za-z][A-Za-z0-9_]*)|([-+*/^()]))")
BLANK = re.compile(r"[ \t\n\r]*")
TEN_POWER = 10 ** limits.DIGITS


def digits_limited(f):
    """Section 7: the digits of a number are limited in every value on the way through an expression."""
    if f.bits() > TEN_POWER.bit_length() - 1:
        from math import gcd
        for part in f.parts.values():
            for c in part.values():
                g = gcd(c, f.den)
                need(abs(c) // g < TEN_POWER and f.den // g < TEN_POWER, "a number has too many digits")
    return f


def tokens_of(text):
    found, position = [], 0
    while True:
        match = TOKEN.match(text, position)
        if not match:
            break
        found.append(match.group(match.lastindex))
        position = match.end()
    need(BLANK.fullmatch(text, position), "an expression cannot be read at %.40r" % text[position:])
    return found + [""]


class Reader:
    """Evaluates while it reads. `names` maps a name to its polynomial."""

    def __init__(self, text, ring, names):
        self.tokens, self.at = tokens_of(text), 0
        self.ring, self.names, self.depth = ring, names, 0

    def take(self):
        token = self.tokens[self.at]
        self.at += 1
        return token

    def whole(self):
        value = self.expression()
        need(self.tokens[self.at] == "", "an expression does not end where it should")
        return value

    def expression(self):
        # a sign may stand only here: at the start of an expression or bracket, and it belongs to the product
        sign = self.take() if self.tokens[self.at] in ("-", "+") else "+"
        value = self.product()
        if sign == "-":
            value = -value
        while self.tokens[self.at] in ("+", "-"):
            operator = self.take()
            other = self.product()
            value = digits_limited(value + other if operator == "+" else value - other)
        return value

    def product(self):
        value = self.factor()
        while self.tokens[self.at] in ("*", "/"):
            operator = self.take()
            other = self.factor()
            if operator == "/":
                need(other and other.is_constant(), "one divides only by a non-zero constant")
                other = digits_limited(other.inverse())
            value = digits_limited(value * other)
        return value

    def factor(self):
        value = self.atom()
        if self.tokens[self.at] == "^":
            self.take()
            exponent = self.take()
            need(exponent.isdigit(), "an exponent is not a row of digits")
            need(len(exponent) <= limits.DIGITS and int(exponent) <= limits.DEGREE, "an exponent is too large")
            value = self.power(value, int(exponent))
        return value

    def power(self, value, n):
        result = self.ring.constant(1)
        for bit in bin(n)[2:]:
            result = digits_limited(result * result)
            if bit == "1":
                result = digits_limited(result * value)
        return result

    def atom(self):
        token = self.take()
        if token[:1].isdigit():
            whole, _, rest = token.partition(".")
            need(len(whole) + len(rest) <= limits.DIGITS, "a number has too many digits")
            return make(self.ring, 10 ** len(rest), {0: {0: int(whole + rest)}})
        if token == "(":
            return self.bracket()
        if token == "sqrt":
            need(self.take() == "(", "sqrt needs a bracket")
            return self.root(self.bracket())
        need(token in self.names, "not a number, a declared name or a bracket: %.40r" % token)
        return self.names[token]

    def bracket(self):
        self.depth += 1
        need(self.depth <= limits.BRACKETS, "too many nested brackets")
        value = self.expression()
        need(self.take() == ")", "a bracket is not closed")
        self.depth -= 1
        return value

    def root(self, value):
        if not value:
            return value
        need(value.is_constant() and value.sign() > 0, "sqrt of no constant >= 0")
        if set(value.parts) == {0}:
            found = square_root(self.ring.field, value.parts[0][0], value.den)
            need(found, "the root is not in the field")
            mask, top, bottom = found
            return digits_limited(self.ring.constant(top, bottom, mask))
        root = self.descent(value, len(self.ring.field.radicands))
        need(root is not None, "the root is not in the field")
        return digits_limited(root if root.sign() > 0 else -root)

    def descent(self, value, rank):
        """An element of the field of the first `rank` radicands whose square this is, or None (section 2).

        a + b sqrt(d) = (s + t sqrt(d))^2: for b = 0 a or a/d is a square; otherwise a^2 - d b^2 = n^2, s^2 = (a +- n)/2
        and t = b/(2s)."""
        ring = self.ring
        if not value:
            return value
        if rank == 0:
            top, bottom = value.parts[0][0], value.den
            root = isqrt(top * bottom) if top > 0 else 0
            return ring.constant(root, bottom) if root * root == top * bottom and root else None
        bit = 1 << (rank - 1)
        d, sqrt_d = ring.constant(ring.field.n[bit]), ring.constant(1, 1, bit)
        a = make(ring, value.den, {S: dict(part) for S, part in value.parts.items() if not S & bit})
        b = make(ring, value.den, {S ^ bit: dict(part) for S, part in value.parts.items() if S & bit})
        if not b:
            root = self.descent(a, rank - 1)
            if root is None:
                root = self.descent(a * d.inverse(), rank - 1)
                root = root * sqrt_d if root is not None else None
            return root
        n = self.descent(a * a - d * b * b, rank - 1)
        for twice in [] if n is None else [a + n, a - n]:
            s = self.descent(twice.scaled(1, 2), rank - 1)
            if s is not None:
                return s + b * s.scaled(2).inverse() * sqrt_d
        return None


def evaluate_expression(value, ring, names):
    """The value of a TOML string, or of a TOML integer of 64 bits."""
    if type(value) is int:
        need(-2 ** 63 <= value < 2 ** 63, "an integer has more than 64 bits")
        return ring.constant(value)
    if type(value) is not str:
        raise Malformed("an expression is neither a string nor an integer")
    return Reader(value, ring, names).whole()
