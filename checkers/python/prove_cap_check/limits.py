"""The two ways to fail, and the limits of FORMAT.md section 7."""


class Malformed(Exception):
    """The answer is ERROR: a file does not follow the format, or a limit is exceeded (section 6)."""


class Rejected(Exception):
    """The answer is REJECTED: a well-formed certificate breaks a rule of section 6."""


STATEMENT_BYTES = 1048576
CERTIFICATE_BYTES = 16777216
LINE_BYTES = 1048576
STEPS = 100000
DIGITS = 4096
TERMS = 1000000
POWERS = 10000000
NUMBER_BITS = 131072
SUM_BITS = 2147483648
STATEMENT_BITS = 134217728
DEGREE = 1000
UNKNOWNS = 1024
ASSUMPTIONS = 64
POLYNOMIALS = 4096
BIDEGREE = 32
SURFACE_DEGREE = 8
BRACKETS = 64
RADICANDS = 4
RADICAND = 1000000
PLACES = 1000
BOXES = 1000000
SAMPLES = 10000
NAME = 32
TITLE = 200
INDEX = 4294967295

# Section 7 allows a bound on the work. Ours counts multiplications of coefficients (about 0.1 microseconds each).
WORK = 3000000000
_spent = 0


def charge(units):
    """Pay for work before it is done, so that a hostile file ends as ERROR instead of never."""
    global _spent
    _spent += units
    if _spent > WORK:
        raise Malformed("the work exceeds the bound of this checker")


def need(condition, message):
    """A condition of sections 1, 2, 5 or 7; where it fails, the answer is ERROR."""
    if not condition:
        raise Malformed(message)


def rule(condition, message):
    """A rule of section 6; where it fails, the answer is REJECTED."""
    if not condition:
        raise Rejected(message)
