"""Deterministic mutants of committed certificates, compared between the two checkers (phase 2; no part of the checker).

python3 mutants.py SEED COUNT [PART_OF_PATH]: damages one thing of a certificate or statement, re-seals it (the count and the
hash of the last line, the hash of the statement), so that the damage reaches the checks, and compares the exit codes."""

import contextlib
import glob
import hashlib
import io
import os
import random
import re
import subprocess
import sys
import tempfile
import time

import prove_cap_check.__main__ as second
from prove_cap_check import limits
from prove_cap_check.certificate import read_certificate
from prove_cap_check.statement import read_statement

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.join(HERE, "..", "..")
FIRST = os.environ.get("FIRST", os.path.join(ROOT, "target", "release", "prove-cap-check"))
PROOFS = os.path.join(ROOT, "proofs")
OUT = os.path.join(ROOT, "target", "disagreements")
TMP = tempfile.mkdtemp()
SEALED = ("bounds", "unreachable", "cover")


def claim_of(lines):
    return lines[2][6:] if len(lines) > 2 and lines[2].startswith("claim ") else ""


def seal(lines):
    """The count and the hash of the last line, as section 5 says."""
    claim = claim_of(lines)
    body = lines[:-1]
    if claim == "unreachable":
        count = sum(line.startswith("exclude ") for line in body)
    elif claim in SEALED:
        count = sum(line.split(" ")[-1].count(".") for line in body
                    if re.search(r" [h.]+$", line) and line.startswith(("denominator", "lower", "upper", "edge", "regular")))
    else:
        count = sum(line.startswith("step " if claim == "impossible" else "value ") for line in body)
    text = "\n".join(body) + "\n"
    if claim in SEALED:
        return text + "end %d %s\n" % (count, hashlib.sha256(text.encode("utf-8")).hexdigest())
    return text + "end %d\n" % count


def pick(rng, line, pattern):
    found = list(re.finditer(pattern, line))
    return rng.choice(found) if found else None


def replaced(line, match, text, group=0):
    return line[:match.start(group)] + text + line[match.end(group):]


def other_number(rng, text):
    value = int(text)
    return str(rng.choice([value + 1, max(value - 1, 0), value * 2, 0, 1, 2, value + 10, rng.randrange(100), value * 3 + 1]))


def subtree(tree, start):
    still, at = 1, start
    while still and at < len(tree):
        still += 1 if tree[at] == "h" else -1
        at += 1
    return at


def damage_tree(rng, tree):
    kind = rng.randrange(6)
    at = rng.randrange(len(tree))
    end = subtree(tree, at)
    if kind == 0:      # halve a box more
        dots = [i for i, letter in enumerate(tree) if letter == "."]
        at = rng.choice(dots)
        return tree[:at] + "h.." + tree[at + 1:]
    if kind in (1, 2): # a halved box less
        pairs = [m.start() for m in re.finditer(r"(?=h\.\.)", tree)]
        if pairs:
            at = rng.choice(pairs)
            return tree[:at] + "." + tree[at + 3:]
        return tree
    if kind == 3 and tree[at] == "h":  # exchange the halves
        middle = subtree(tree, at + 1)
        return tree[:at + 1] + tree[middle:end] + tree[at + 1:middle] + tree[end:]
    if kind == 4:
        return tree[:at] + "." + tree[end:]
    return tree[:at] + tree[at + 1:] if rng.random() < .5 else tree[:at] + rng.choice("h.") + tree[at:]


def damage_line(rng, line):
    """One small damage inside one line."""
    kind = rng.randrange(14)
    if kind == 0 and re.search(r" [h.]+$", line):
        m = re.search(r" ([h.]+)$", line)
        return line[:m.start(1)] + damage_tree(rng, m.group(1))
    if kind <= 3:
        m = pick(rng, line, r"[0-9]+")
        return replaced(line, m, other_number(rng, m.group())) if m else line
    if kind == 4:
        m = pick(rng, line, r" ([+-]) ")
        return replaced(line, m, "-" if m.group(1) == "+" else "+", 1) if m else line
    if kind == 5:
        m = pick(rng, line, r"(times|conclude|=|at|between|over|lower|upper) (-?)(?=[0-9a-z])")
        return replaced(line, m, "" if m.group(2) else "-", 2) if m else line
    if kind == 6:
        m = pick(rng, line, r"\^[0-9]+")
        return replaced(line, m, rng.choice(["", "^1", "^2", "^3", "^1001", "^0"])) if m else line
    if kind == 7:
        terms = re.split(r" (?=[+-] )", line)
        if len(terms) > 1:
            at = rng.randrange(1, len(terms))
            if rng.random() < .5:
                del terms[at]
            else:
                terms[at], terms[at - 1] = terms[at - 1], terms[at]
        return " ".join(terms)
    if kind == 8:
        m = pick(rng, line, r"sqrt\([0-9]+\)")
        return replaced(line, m, rng.choice(["sqrt(2)", "sqrt(3)", "sqrt(6)", "sqrt(4)", "2"])) if m else line
    if kind == 9:
        m = pick(rng, line, r"\*[^ *]+")
        return replaced(line, m, "") if m else line
    if kind == 10:
        m = pick(rng, line, r"lower|upper|weight|outward|inward|radius|ratio|point|arc|halve")
        return replaced(line, m, rng.choice(["lower", "upper", "weight", "outward", "inward", "radius", "ratio", "point"])) if m else line
    if kind == 11:
        m = pick(rng, line, r"(?<= )[0-9]+(/[0-9]+)?(\*h)?(?= |$)")
        return replaced(line, m, rng.choice(["0", "1", "1/2", "1/3", "2", "7/5", "1*h", "1/2*h", "3*h", "0*h", "h"])) if m else line
    if kind == 12:
        m = pick(rng, line, r"(?<![A-Za-z0-9_])[a-z][A-Za-z0-9_]{0,3}(?![A-Za-z0-9_(])")
        return replaced(line, m, rng.choice("abcwxyzst")) if m else line
    at = rng.randrange(len(line) + 1)
    return line[:at] + rng.choice(" 0*-+h.x") + line[at + (rng.random() < .5):]


def kind_of(line):
    return re.match(r"[a-z]* ?[a-z]*", line).group() if line else ""


def damage(rng, lines):
    """One damage of the lines in front of the last one."""
    lines = list(lines)
    last = len(lines) - 1
    if last < 3:
        return lines
    kind = rng.randrange(10)
    # first a kind of line, so that the rare lines are not lost among thousands of others
    word = rng.choice(sorted({line.split(" ")[0] for line in lines[2:last]}))
    at = rng.choice([i for i in range(2, last) if lines[i].split(" ")[0] == word])
    if claim_of(lines) == "unreachable" and rng.random() < .45:
        return damage_charts(rng, lines)
    if claim_of(lines) in ("bounds", "cover") and rng.random() < .3:
        trees = [i for i, line in enumerate(lines[:last]) if re.search(r" [h.]+$", line)]
        i = rng.choice(trees)
        head, _, tree = lines[i].rpartition(" ")
        lines[i] = head + " " + damage_tree(rng, tree)
        return lines
    if claim_of(lines) == "bounds" and rng.random() < .25:
        for i, line in enumerate(lines):
            m = re.match(r"(lower|upper) (-?[0-9.]+) ", line)
            if m and rng.random() < .7:
                digits = m.group(2).replace(".", "")
                value = int(digits) + rng.choice([-1, 1, 1, -1, 2, -2])
                places = len(m.group(2).partition(".")[2])
                text = str(abs(value)).rjust(places + 1, "0")
                text = ("-" if value < 0 else "") + (text[:-places] + "." + text[-places:] if places else text)
                lines[i] = replaced(line, m, text, 2)
        return lines
    if kind <= 6:
        lines[at] = damage_line(rng, lines[at])
    elif kind == 7:
        del lines[at]
    elif kind == 8:
        lines.insert(at, lines[at])
    else:
        other = rng.randrange(2, last)
        lines[at], lines[other] = lines[other], lines[at]
    return lines


def damage_charts(rng, lines):
    at = rng.choice([i for i, line in enumerate(lines) if line.startswith("exclude ")])
    kind = rng.randrange(7)
    if kind == 0:
        lines[at:at + 1] = ["halve", lines[at], lines[at]]
    elif kind in (1, 2):
        pairs = [i for i in range(len(lines) - 2) if lines[i] == "halve" and lines[i + 1][:1] == lines[i + 2][:1] == "e"]
        if pairs:
            i = rng.choice(pairs)
            lines[i:i + 3] = [rng.choice(lines[i + 1:i + 3])]
    elif kind == 3:
        factor = rng.choice([2, 3, 10 ** 6])
        lines[at] = re.sub(r"([0-9]+)\*", lambda m: "%d*" % (factor * int(m.group(1))), lines[at])
    elif kind == 4:
        other = rng.choice([i for i, line in enumerate(lines) if line.startswith("exclude ")])
        lines[at] = lines[other]
    elif kind == 5:
        samples = sum(line.startswith("sample ") for line in lines)
        terms = lines[at][8:].split(" + ") + ["1*%s[%d]" % (rng.choice(["lower", "upper", "weight"]), rng.randint(1, samples))]
        key = lambda term: (term.split("*")[1].split("[")[0], int(term.split("[")[1][:-1]))
        lines[at] = "exclude " + " + ".join(sorted(terms, key=key))
    else:
        for i, line in enumerate(lines):
            if line.startswith("range "):
                lines[i] = "range %d" % max(1, int(line[6:]) + rng.choice([-1, 1, 2, 5, 100]))
    return lines


def damage_statement(rng, text):
    lines = text.split("\n")
    for _ in range(20):
        at = rng.randrange(len(lines))
        line = lines[at].split("#")[0]
        if line.strip() and not line.startswith("title"):
            break
    new = list(lines)
    kind = rng.randrange(12)
    if kind == 0:
        new.pop(at)
    elif kind == 1:
        new.insert(at, line)
    elif kind == 2:
        new[at] = line.replace("cartesian", "homogeneous") if "cartesian" in line else line.replace("homogeneous", "cartesian")
    elif kind == 3:
        m = pick(rng, line, r'"[^"]*"')
        new[at] = replaced(line, m, rng.choice(['"0"', '"1"', "-2", '"(1)/2"', '"1.50"', '"x"', '"w*z"', "true", '"-(-3)"', '"sqrt(2)"',
                                                '"sqrt(8/9)"', '"+1"', '"1--1"'])) if m else line
    elif kind == 4:
        m = pick(rng, line, r"[-+*/^]")
        new[at] = replaced(line, m, rng.choice("-+*/^")) if m else line
    elif kind == 5:
        where = rng.randrange(len(lines))
        here = rng.randrange(len(lines[where]) + 1)
        new[where] = lines[where][:here] + rng.choice(' 0*-+)("[],.x') + lines[where][here + (rng.random() < .5):]
    else:
        m = pick(rng, line, r"[0-9]+")
        new[at] = replaced(line, m, other_number(rng, m.group())) if m else line
    return "\n".join(new)


def verdict_of_second(statement, certificate):
    limits._spent = 0
    with contextlib.redirect_stdout(io.StringIO()) as out, contextlib.redirect_stderr(out):
        code = second.main([statement, certificate])
    return code, out.getvalue()


def compare(statement, certificate, name, tally):
    """Both verdicts on two texts; differences are kept as files."""
    paths = [os.path.join(TMP, "statement.toml"), os.path.join(TMP, "certificate.txt")]
    for path, text in zip(paths, (statement, certificate)):
        with open(path, "w", encoding="utf-8", newline="") as file:
            file.write(text)
    done = subprocess.run([FIRST, "check", *paths], capture_output=True, text=True, errors="replace")
    code, words = verdict_of_second(*paths)
    tally[done.returncode, code] = tally.get((done.returncode, code), 0) + 1
    if done.returncode != code or "internal" in words:
        print("DIFFERENT", name, "first:", (done.stdout + done.stderr)[:300].replace("\n", " "), "| second:", words[:300])
        for path, end in zip(paths, ("toml", "txt")):
            with open(path, "rb") as file, open(os.path.join(OUT, "%s.%s" % (name, end)), "wb") as copy:
                copy.write(file.read())
    return done.returncode, code


def one_damage(rng, statement, lines):
    if rng.random() >= .25:
        new = damage(rng, lines)
        return statement, damage(rng, new) if rng.random() < .1 else new
    text, new = damage_statement(rng, statement), list(lines)
    path = os.path.join(TMP, "s.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    try:
        new[1] = "statement sha256 " + read_statement(path).hash()
    except limits.Malformed:
        pass
    return text, damage(rng, new) if rng.random() < .3 else new


def readable(statement, certificate):
    limits._spent = 0
    path = os.path.join(TMP, "r.toml")
    with open(path, "w", encoding="utf-8") as file:
        file.write(statement)
    try:
        read_certificate(certificate.encode("utf-8"), read_statement(path))
        return True
    except limits.Malformed:
        return False


def main(seed, count, part=""):
    os.makedirs(TMP, exist_ok=True)
    os.makedirs(OUT, exist_ok=True)
    tally, started = {}, time.time()
    for path in sorted(glob.glob(PROOFS + "/**/statement.toml", recursive=True)):
        folder = os.path.dirname(path)
        for proof in sorted(glob.glob(folder + "/*.txt")):
            if part not in proof:
                continue
            statement = open(path, encoding="utf-8").read()
            lines = open(proof).read().split("\n")[:-1]
            slow = len(lines) > 3000
            name = os.path.relpath(proof, PROOFS).replace("/", "-")[:-4]
            rng = random.Random("%s %s" % (seed, name))
            for number in range(count // 10 if slow else count):
                for _ in range(8):
                    text, new = one_damage(rng, statement, lines)
                    certificate = seal(new) if rng.random() < .99 else "\n".join(new) + "\n"
                    # most damages make a file unreadable; most of those are tried again, so that the checks are reached
                    if (new[2:] != lines[2:] or text != statement) and (readable(text, certificate) or rng.random() < .1):
                        break
                else:
                    continue
                compare(text, certificate, "%s-%s-%d" % (name, seed, number), tally)
    print("%.0f s;" % (time.time() - started), "exit codes (first, second): count", dict(sorted(tally.items())))


if __name__ == "__main__":
    if hasattr(sys, "set_int_max_str_digits"):
        sys.set_int_max_str_digits(0)
    main(sys.argv[1], int(sys.argv[2]), *sys.argv[3:4])
