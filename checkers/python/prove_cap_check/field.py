"""The field K = Q(sqrt d_1, ..., sqrt d_k) of FORMAT.md section 1: masks, products of roots, exact signs."""

from math import isqrt, prod


class Field:
    """K for sorted radicands. A mask S names the root sqrt(n_S); the roots are a basis of K over Q."""

    def __init__(self, radicands):
        self.radicands = sorted(radicands)
        k = len(self.radicands)
        self.size = 1 << k
        self.n = [prod(d for b, d in enumerate(self.radicands) if S >> b & 1) for S in range(self.size)]
        # the spelling of a root (section 1); mask 0 has none
        self.root_text = ["sqrt(%d)" % n for n in self.n]
        self.root_mask = {self.root_text[S]: S for S in range(1, self.size)}
        self._roots = {}

    def roots(self, precision):
        """floor(sqrt(n_S) * 2^precision) for every S."""
        if precision not in self._roots:
            self._roots[precision] = [isqrt(n << (2 * precision)) for n in self.n]
        return self._roots[precision]

    def sign(self, entries):
        """The sign of the sum of c * sqrt(n_S) over the pairs (S, c) of `entries` (each S once, c an integer).

        The roots are linearly independent over Q, so the number is 0 only if all c are. Otherwise ever finer intervals
        [r, r+1] / 2^p around the roots must separate it from 0 in the end.
        """
        entries = [(S, c) for S, c in entries if c]
        if not entries:
            return 0
        if all(c > 0 for _, c in entries):
            return 1
        if all(c < 0 for _, c in entries):
            return -1
        precision = 64
        while True:
            roots = self.roots(precision)
            low = high = 0
            for S, c in entries:
                value = c * roots[S]
                # the root of 1 (S = 0) is exact, all others are short by less than one unit
                low += value if c > 0 or S == 0 else value + c
                high += value if c < 0 or S == 0 else value + c
            if low > 0:
                return 1
            if high < 0:
                return -1
            precision *= 2


def square_root(field, a, b):
    """The root >= 0 of the rational a/b >= 0 as (mask, numerator, denominator), or None if it is not rational * sqrt(n_S).

    sqrt(a/b) = sqrt(ab)/b, and sqrt(ab) = s * sqrt(n_S) with rational s iff a*b*n_S is a square (section 2).
    """
    for S in range(field.size):
        square = a * b * field.n[S]
        root = isqrt(square)
        if root * root == square:
            return S, root, b * field.n[S]
    return None
