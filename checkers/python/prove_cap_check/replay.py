"""`claim impossible` and `claim exact` (FORMAT.md section 6, rules 2 and 3)."""

from .equations import patch_coefficients, equations
from .limits import rule
from .poly import evaluate, sum_of_products


def premise_name(premise):
    kind, a, b = premise
    return {"c": "c[%d,%d]" % (a, b), "step": "step %d" % a}.get(kind, "%s[%d]" % (kind, a))


def check_impossible(c, s):
    rule(c.steps, "there is no step")
    premises = equations(s)
    first = {}
    for name, f in premises.items():
        first.setdefault(f, name)
    known = set(first)
    last_step = len(c.steps)
    used = set()
    for number, (adds, conclusion) in enumerate(c.steps, 1):
        pairs = []
        for premise, multiplier in adds:
            where = "step %d: %s " % (number, premise_name(premise))
            rule(premise in premises, where + "does not exist")
            f = premises[premise]
            rule(f, where + "is zero")
            if premise[0] == "step":
                used.add(premise[1])
            else:
                rule(first[f] == premise, where + "equals " + premise_name(first[f]))
            pairs.append((multiplier, f))
        rule(sum_of_products(s.ring, pairs) == conclusion, "step %d: the sum is not the conclusion" % number)
        rule(conclusion, "step %d: the conclusion is zero" % number)
        if number < last_step:
            rule(conclusion not in known, "step %d: the conclusion is known before" % number)
        known.add(conclusion)
        premises["step", number, 0] = conclusion
    rule(conclusion == s.ring.constant(1), "the last conclusion is not 1")
    for number in range(1, last_step):
        rule(number in used, "step %d is not used" % number)
    return "%d steps" % last_step


def points_at_values(s, values):
    return {place: [evaluate(f, values) for f in point] for place, point in s.points.items()}


def check_solution(s, values):
    """Rule 3; returns the points at the values (None for a system)."""
    for k, d in enumerate(s.nonzero):
        rule(evaluate(d, values), "assumption %d is zero at the values" % (k + 1))
    if not s.patch:
        for k, f in enumerate(s.polynomials):
            rule(not evaluate(f, values), "f[%d] is not zero at the values" % (k + 1))
        return None
    points = points_at_values(s, values)
    # the equations are polynomials in the coordinates, so that they may be formed after the evaluation
    grid = patch_coefficients(s, points)[0]
    for (r, q), f in sorted(grid.items()):
        rule(not f, "c[%d,%d] is not zero at the values" % (r, q))
    rule(any(point[3] for point in points.values()), "every W is zero at the values")
    return points


def check_exact(c, s):
    points = check_solution(s, c.values)
    if points is None:
        return "all equations hold"
    positive = all(point[3].sign() > 0 for point in points.values())
    return "all equations hold; " + ("all W are positive" if positive else "not all W are positive")
