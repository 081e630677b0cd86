"""Small tests from the examples of FORMAT.md. Run: python3 test_page.py [FORMAT.md]"""

import os
import re
import subprocess
import sys
import tempfile

from prove_cap_check.certificate import read_tree
from prove_cap_check.equations import equations
from prove_cap_check.field import Field
from prove_cap_check.limits import Malformed
from prove_cap_check.poly import Ring
from prove_cap_check.spelling import decimal, rational, read_polynomial, write_polynomial
from prove_cap_check.statement import read_statement

HERE = os.path.dirname(os.path.abspath(__file__))
PAGE = sys.argv[1] if len(sys.argv) > 1 else os.path.join(HERE, "..", "..", "proofs", "FORMAT.md")
BLOCKS = re.findall(r"```text\n(.*?)```", open(PAGE, encoding="utf-8").read(), re.S)
WORK = tempfile.mkdtemp()


def fails(function, *arguments):
    try:
        function(*arguments)
    except Malformed:
        return True
    return False


def write(name, text):
    path = os.path.join(WORK, name)
    with open(path, "w", newline="") as file:
        file.write(text)
    return path


def run(*arguments):
    done = subprocess.run([sys.executable, "-m", "prove_cap_check", *arguments], cwd=HERE, capture_output=True, text=True)
    return done.returncode, (done.stdout + done.stderr).split()[0], done.stdout


ring = Ring(Field([3, 2]), ["w", "z", "x"])
for good in ("8/3*sqrt(3)*w*z - 8*w - 4/3", "-x^2 + sqrt(6)", "1", "0", "-1", "w^2*z - w*z^2 + w + sqrt(2)*w + sqrt(3)*w - 1/2"):
    assert write_polynomial(read_polynomial(good, ring)) == good, good
for bad in ("+x", "02", "2/4", "3/1", "1*x", "x^1", "-0", "z*w", "sqrt(12)", "x - -1", "", " x", "x ", "x + x", "x + w",
            "sqrt(3) + sqrt(2)", "sqrt(1)", "x*x", "0*x", "x + 0", "2*2", "sqrt(2)*sqrt(3)", "x*2", "x*sqrt(2)", "y", "x^02",
            "x^1001", "x^600*x^600", "w^600*z^600", "--x", "- x", "x +w", "x  + 1", "1/0", "0/2", "x^", "x*", "*x"):
    assert fails(read_polynomial, bad, ring), bad
assert decimal("-0.50", 2) == -rational("1/2") and decimal("7", 0) == 7 and decimal("0.0", 1) == 0
for bad in ("-0.0", "00.1", ".5", "1.", "1", "+1.0", "1.00", "1,0"):
    assert fails(decimal, bad, 1), bad
assert read_tree("h.h..")
for bad in ("", "h", "..", "h...", "h.", "x"):
    assert fails(read_tree, bad), bad

# the example of section 8: a statement file made from its canonical text
canonical, listed, certificate = BLOCKS[-3:]
values = dict(re.findall(r"^([XYZW]\[\d,\d\]) (.*)$", canonical, re.M))
net = ",\n".join("[%s]" % ", ".join("[%s]" % ", ".join('"%s"' % values["%s[%d,%d]" % (c, i, j)] for c in "XYZW")
                                    for j in range(3)) for i in range(3))
toml = 'title = "t"\nradicands = [3, 2]\nunknowns = ["w", "z"]\nconvention = "homogeneous"\nbidegree = [2, 2]\nnet = [%s]\n' % net
statement = write("statement.toml", toml)
read = read_statement(statement)
assert read.canonical() == canonical
found = equations(read)
names = [("c", 1, 1), ("c", 1, 2), ("c", 2, 2)]
assert [write_polynomial(found[name]) for name in names] == listed.splitlines()
assert run("--canonical", statement) == (0, "prove-cap", canonical)
assert run(statement, write("c", certificate))[:2] == (0, "VERIFIED")
for old, new, code in (("-3/8", "-3/7", 1), ("end 3", "end 2", 2), ("add c[1,2]", "add c[1,0]", 2), ("add c[1,2]", "add c[2,2]", 1), ("8ac", "8ad", 1),
                       ("step 2\nadd c[1,1]", "step 2\nadd c[9,1]", 1), ("add step 2 ", "add step 3 ", 2),
                       ("sqrt(6)", "sqrt(5)", 2), ("times -3/8", "times 0", 2), ("end 3\n", "end 3", 2), ("end 3\n", "end 3\n\n", 2)):
    assert certificate.count(old) == 1, old
    assert run(statement, write("c", certificate.replace(old, new)))[0] == code, (old, new)

# the same points with cartesian coordinates where W is a constant of 1, and other spellings
other = toml.replace("[3, 2]", "[2, 3]").replace('"-1/3*sqrt(3)"', '"-1/sqrt(3)"').replace('"1"', "0x1").replace(
    '"1/3*sqrt(6)"', '"k"').replace("net =", "define = {s = \"sqrt(6)\", k = \"s/3.0\"}\nnet =")
assert read_statement(write("o", other)).canonical() == canonical
for extra in ("radicands = []", "colour = 1", "nonzero = [\"w - w\"]", "define = {w = 1}", "define = {net = 1}",
              "define = {a = \"b\", b = 1}", "polynomials = []", "define = {a = true}", "define = {a = 1.5}",
              "define = {a = 9223372036854775808}", "define = {a = \"2 x\"}", "define = {a = \"2 * -1\"}",
              "define = {a = \"sqrt(5)\"}", "define = {a = \"2^1001\"}", "define = {a = \"1/0\"}", "define = {a = \"w\"}",
              "surface = \"X^2 + Y\"", "surface = \"7\"", "nonzero = [\"X\"]", "define = {a = \"1 .5\"}"):
    assert fails(read_statement, write("e", toml.replace("net =", extra + "\nnet ="))), extra
system = 'title = "s"\nradicands = []\nunknowns = ["x", "y"]\nnonzero = ["x"]\npolynomials = ["x*y", "y - 1"]\n'
text = read_statement(write("s", system)).canonical()
assert text == "prove-cap statement 1\nradicands\nunknowns x y\nnonzero x\nzero x*y\nzero y - 1\nend\n"
print("all tests of the page pass")
