"""Verifies with SymPy that the net of a statement file lies on the unit sphere: the time of the identity alone, without SymPy's start."""
import re
import sys
import time
import tomllib

from sympy import QQ, Poly, binomial, sqrt, symbols, sympify

u, v = symbols("u v")
with open(sys.argv[1], "rb") as file:
    statement = tomllib.load(file)
radicands = statement["radicands"]
K = QQ.algebraic_field(*map(sqrt, radicands)) if radicands else QQ
m, n = statement["bidegree"]
start = time.perf_counter()


def polynomial(k):
    rows = {}
    for i, row in enumerate(statement["net"]):
        for j, point in enumerate(row):
            # u = t/(1+t), v = s/(1+s): the same identity, in powers of t and s.
            rows[(i, j)] = sympify(re.sub(r"\^", "**", str(point[k]))) * binomial(m, i) * binomial(n, j)
    return Poly.from_dict({key: K.from_sympy(value) for key, value in rows.items()}, u, v, domain=K)


X, Y, Z, W = map(polynomial, range(4))
residual = X * X + Y * Y + Z * Z - W * W
seconds = time.perf_counter() - start
print(f"{'AGREES' if residual.is_zero else 'DIFFERS'}  {seconds:.3f} s")
sys.exit(0 if residual.is_zero else 1)
