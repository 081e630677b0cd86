"""Both checkers on every committed proof and every test file: python3 agree.py [FIRST_CHECKER]. Any difference fails."""

import glob
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
FIRST = sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, "target", "release", "prove-cap-check")
SECOND = [sys.executable, "-m", "prove_cap_check"]


def status(command):
    return subprocess.run(command, cwd=HERE, capture_output=True, text=True)


def pairs():
    """The committed proofs, then the files that must be refused."""
    for statement in sorted(glob.glob(os.path.join(ROOT, "proofs", "**", "statement.toml"), recursive=True)):
        for certificate in sorted(glob.glob(os.path.join(os.path.dirname(statement), "*.txt"))):
            yield statement, certificate
    data = os.path.join(ROOT, "tests", "data")
    good = os.path.join(data, "accept", "two_steps.txt")
    for statement in sorted(glob.glob(os.path.join(data, "reject", "statement", "*.toml"))):
        yield statement, good
    for certificate in sorted(glob.glob(os.path.join(data, "reject", "certificate", "*.txt"))):
        own = certificate[:-3] + "toml"
        yield own if os.path.exists(own) else os.path.join(data, "reject", "certificate", "statement.toml"), certificate


def main():
    same = differing = 0
    for statement, certificate in pairs():
        first = status([os.path.abspath(FIRST), "check", statement, certificate])
        second = status(SECOND + [statement, certificate])
        if first.returncode == second.returncode:
            same += 1
        else:
            differing += 1
            print("DIFFERENT %d %d %s\n%s%s%s%s" % (first.returncode, second.returncode, certificate, first.stdout,
                                                    first.stderr, second.stdout, second.stderr))
    print("%d passed, %d failed" % (same, differing))
    return 1 if differing or not same else 0


if __name__ == "__main__":
    sys.exit(main())
