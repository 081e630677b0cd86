"""python3 -m prove_cap_check STATEMENT CERTIFICATE, or --canonical STATEMENT.

The answer is the first word: VERIFIED (exit 0), REJECTED (1) or ERROR (2), as FORMAT.md section 6 says."""

import sys

from . import limits
from .bounds import check_bounds
from .certificate import read_certificate
from .cover import check_cover
from .limits import Malformed, Rejected, rule
from .replay import check_exact, check_impossible
from .statement import read_file, read_statement
from .unreachable import check_unreachable

CHECKS = {"impossible": check_impossible, "exact": check_exact, "bounds": check_bounds, "cover": check_cover,
          "unreachable": check_unreachable}


def check(statement_path, certificate_path):
    """Both files are read completely, then the hash is compared, then the claim is checked."""
    statement = read_statement(statement_path)
    certificate = read_certificate(read_file(certificate_path, limits.CERTIFICATE_BYTES), statement)
    rule(certificate.hash == statement.hash(), "the certificate is for another statement")
    return "%s: %s" % (certificate.claim, CHECKS[certificate.claim](certificate, statement))


def main(arguments):
    if hasattr(sys, "set_int_max_str_digits"):
        # numbers have up to 131072 bits (section 7), more digits than Python converts by itself
        sys.set_int_max_str_digits(0)
    try:
        if len(arguments) == 2 and arguments[0] == "--canonical":
            sys.stdout.write(read_statement(arguments[1]).canonical())
            return 0
        if len(arguments) != 2:
            raise Malformed("usage: prove_cap_check STATEMENT CERTIFICATE | --canonical STATEMENT")
        print("VERIFIED", check(*arguments))
        return 0
    except Rejected as error:
        print("REJECTED", error)
        return 1
    except Malformed as error:
        print("ERROR", error, file=sys.stderr)
        return 2
    except Exception as error:  # a bug, or no memory: never a verdict
        print("ERROR internal: %s: %.200s" % (type(error).__name__, error), file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
