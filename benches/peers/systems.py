#!/usr/bin/env python3
"""Larger systems by prove-cap, grobx and Singular: whole processes, side by side in one run.

    systems.py PROVE-CAP [NAME ...]

prove-cap finds, writes and checks a certificate. The others get the same equations over Q, with one unknown for each
number that is not known (symmetric and antisymmetric parts do not help them) and √2 and √3 as the last unknowns r2 and
r3, in degree reverse lexicographic order: grobx (PyPI, CPython 3.12) with its cofactors, Singular's std
(a basis, no certificate) and liftstd (with cofactors). Each runs three times, in turns; the median counts, and one run
where it takes long. A program that is missing is `not run`, one that takes too long is `> LIMIT`. LIMIT is in seconds
(default 60). Exit status: 0 all verdicts right, 1 one wrong, 2 called wrongly.
"""

import json
import os
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

SYSTEMS = ["cap-3x3", "cap-4x2", "cap-4x4-d4", "cap-4x3"]
# Without these cap-4x2 has solutions; a program that still finds 1 shows nothing by finding it.
TWIN_OF, DROPPED = "cap-4x2", {f"c[{r},2]" for r in range(2, 7)}
LIMIT = float(os.environ.get("LIMIT", "60"))
RUNS, LONG = 3, 10.0

GROBX = """
import sys, grobx
result = grobx.groebner(open(sys.argv[1]).read(), cofactors=True)
print("UNIT" if "".join(result.basis.split()) == "[1]:" else "BASIS", len(result.cofactors))
"""

SINGULAR = """
ring R = 0,({variables}),dp;
ideal I = {polynomials};
{command}
quit;
"""
# The cofactors are multiplied back: what comes out must be what is printed.
STD = 'ideal G = std(I); if (reduce(poly(1), G) == 0) { print("UNIT 0"); } else { print("BASIS 0"); }'
LIFTSTD = """matrix T; ideal G = liftstd(I, T); matrix P = matrix(I)*T;
int k; int at = 0; for (k = 1; k <= ncols(G); k = k+1) { if (deg(G[k]) == 0) { at = k; } }
if (at == 0) { print("BASIS 0"); }
else { if (P[1,at] != G[at]) { print("WRONG 0"); } else {
  int b = 0; for (k = 1; k <= nrows(T); k = k+1) { b = b + size(string(T[k,at])); } print("UNIT " + string(b)); } }"""


def expand(prove_cap, source):
    text = subprocess.run([prove_cap, "expand", source, "--format", "json"], capture_output=True, check=True).stdout
    return json.loads(text)


def equations(prove_cap, folder, name):
    """The unknowns, and the different coefficients by name, in the canonical spelling."""
    data = expand(prove_cap, name)
    statement = data["statement"]
    open_entries = [
        (point, k)
        for row in statement["net"]
        for point in row
        for k, entry in enumerate(point)
        if re.search(r"[XYZW]\d", entry)
    ]
    # Sums of parts: as many entries as unknowns, and each becomes an unknown itself.
    if len(open_entries) == len(statement["unknowns"]):
        unknowns = [f"p{number}" for number in range(len(open_entries))]
        for unknown, (point, k) in zip(unknowns, open_entries):
            point[k] = unknown
        keys = {key: statement[key] for key in ("radicands", "bidegree", "surface", "net")}
        keys.update(title=name, unknowns=unknowns, convention="homogeneous")
        text = "".join(f"{key} = {json.dumps(value)}\n" for key, value in keys.items())
        data = expand(prove_cap, write(folder, "plain.toml", text))
    values = {}
    for coefficient in data["coefficients"]:
        if coefficient["value"] not in ("0", *values.values()):
            values[coefficient["name"]] = coefficient["value"]
    return data["statement"]["unknowns"], values


def over_q(polynomial):
    """√6 is r2·r3: an element of K as a polynomial in r2 and r3."""
    roots = {"2": "r2", "3": "r3", "6": "r2*r3"}
    return re.sub(r"sqrt\((\d+)\)", lambda root: roots[root[1]], polynomial)


def timed(command):
    """Seconds and standard output of a process; None where it takes too long."""
    start = time.perf_counter()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=LIMIT, stdin=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return None
    return time.perf_counter() - start, done.stdout


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def peers(folder, unknowns, values):
    """Programs with their commands; None where one is missing."""
    variables = [*unknowns, "r2", "r3"]
    polynomials = [over_q(value) for value in values] + ["r2^2 - 2", "r3^2 - 3"]
    msolve = ",".join(variables) + "\n0\n" + ",\n".join(p.replace(" ", "") for p in polynomials) + "\n"
    python = python_with_grobx()
    grobx = python and [python, write(folder, "run-grobx.py", GROBX), write(folder, "system.ms", msolve)]
    yield "grobx, cofactors", grobx
    singular = shutil.which("Singular")
    for label, file, body in [("Singular std, no proof", "std.sing", STD), ("Singular liftstd", "lift.sing", LIFTSTD)]:
        script = SINGULAR.format(variables=",".join(variables), polynomials=",\n".join(polynomials), command=body)
        yield label, singular and [singular, "-q", "--no-rc", write(folder, file, script)]


def python_with_grobx():
    for name in [os.environ.get("PYTHON312", "python3.12"), sys.executable]:
        path = shutil.which(name)
        if path and subprocess.run([path, "-c", "import grobx"], capture_output=True).returncode == 0:
            return path
    return None


def verdict(output):
    """The first word, and the number of bytes after it if there is one."""
    words = output.split()
    return (words or [""])[0], int(words[1]) if len(words) > 1 and words[1].isdigit() else 0


def measure(folder, prove_cap, name):
    """Rows (program, seconds or text, bytes) for one system, and whether all verdicts were right."""
    unknowns, values = equations(prove_cap, folder, name)
    proof = os.path.join(folder, name)
    programs = [("prove-cap", [prove_cap, "prove", name, "-o", proof]), *peers(folder, unknowns, values.values())]
    times = {label: [] for label, _ in programs}
    results, right = {}, True
    for _ in range(RUNS):
        for label, command in programs:
            if command is None:
                results[label] = ("not run", 0)
            if label in results and (results[label][0] or times[label][-1] > LONG):
                continue
            run = timed(command)
            if run is None:
                results[label] = (f"> {LIMIT:.0f}", 0)
                continue
            word, size = verdict(run[1])
            if word not in ("PROVED", "UNIT"):
                results[label], right = ("wrong verdict", 0), False
                continue
            times[label].append(run[0])
            results[label] = ("", os.path.getsize(proof + "/certificate.txt") if label == "prove-cap" else size)
    rows = [(label, results[label][0] or statistics.median(times[label]), results[label][1]) for label, _ in programs]
    return rows, right


def twins_are_spared(folder, prove_cap):
    unknowns, values = equations(prove_cap, folder, TWIN_OF)
    kept = [value for name, value in values.items() if name not in DROPPED]
    statement = f'title = "twin"\nradicands = [2, 3]\nunknowns = {json.dumps(unknowns)}\npolynomials = {json.dumps(kept)}\n'
    twin = write(folder, "twin.toml", statement)
    right = True
    for label, command in [("prove-cap", [prove_cap, "prove", twin, "-o", folder]), *peers(folder, unknowns, kept)]:
        run = command and timed(command)
        if run and verdict(run[1])[0] not in ("EXACT", "UNDECIDED", "BASIS"):
            print(f"{label}: wrong on the damaged twin: {run[1][:200]!r}", file=sys.stderr)
            right = False
    return right


def main():
    if len(sys.argv) < 2 or not shutil.which(sys.argv[1]):
        print(__doc__, file=sys.stderr)
        return 2
    prove_cap = shutil.which(sys.argv[1])
    names = sys.argv[2:] or SYSTEMS
    right = True
    print(f"{'system':<12}{'program':<26}{'seconds':>10}{'ratio':>9}{'bytes of proof':>17}")
    with tempfile.TemporaryDirectory() as folder:
        right &= twins_are_spared(folder, prove_cap)
        for name in names:
            rows, verdicts = measure(folder, prove_cap, name)
            right &= verdicts
            base = rows[0][1]
            for label, seconds, size in rows:
                known = isinstance(seconds, float)
                ratio = f"{seconds / base:.1f}" if known and isinstance(base, float) else "-"
                print(f"{name:<12}{label:<26}{f'{seconds:.3f}' if known else seconds:>10}{ratio:>9}{size or '-':>17}")
                name = ""
            sys.stdout.flush()
    return 0 if right else 1


if __name__ == "__main__":
    sys.exit(main())
