"""A reader of a part of TOML, for Python before 3.11 only. What it does not know is an ERROR, never another meaning.

It knows comments, bare keys, [define], strings of one line and of several, integers, arrays and inline tables."""

import re

from .limits import Malformed, need

SPACE = re.compile(r"[ \t]*")
BLANK = re.compile(r"(?:[ \t\n]|#[^\n]*)*")
KEY = re.compile(r"[A-Za-z0-9_-]+")
INTEGER = re.compile(r"[+-]?(?:0|[1-9](?:_?[0-9])*)(?![0-9A-Za-z_.:-])")
LITERAL = re.compile(r"'''\n?(.*?)'''(?!')|'(?!'')([^'\n]*)'", re.S)
BASIC = re.compile(r'"""\n?((?:[^"\\]|"(?!""))*)"""(?!")|"(?!"")([^"\\\n]*)"')
CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f]")
DEPTH = 20


class Reader:
    def __init__(self, text):
        text = text.replace("\r\n", "\n")
        need(not CONTROL.search(text), "a control character in the statement")
        self.text, self.at = text, 0

    def match(self, pattern):
        found = pattern.match(self.text, self.at)
        if found:
            self.at = found.end()
        return found

    def mark(self, letter):
        if self.text.startswith(letter, self.at):
            self.at += len(letter)
            return True
        return False

    def must(self, condition, message):
        if not condition:
            raise Malformed("TOML at %.40r: %s (this Python reads a part of TOML only)" % (self.text[self.at:], message))

    def entry(self, table):
        key = self.match(KEY)
        self.must(key, "expected a bare key")
        key = key.group()
        self.match(SPACE)
        self.must(self.mark("="), "expected =")
        self.match(SPACE)
        self.must(key not in table, "a key is there twice")
        table[key] = self.value(0)
        self.match(SPACE)

    def value(self, depth):
        self.must(depth < DEPTH, "too deep")
        for pattern in (BASIC, LITERAL):
            found = self.match(pattern)
            if found:
                return found.group(found.lastindex)
        found = self.match(INTEGER)
        if found:
            digits = found.group().replace("_", "")
            self.must(len(digits) <= 20, "an integer has more than 64 bits")
            return int(digits)
        if self.mark("["):
            return self.array(depth)
        self.must(self.mark("{"), "expected a value")
        table = {}
        self.match(SPACE)
        if not self.mark("}"):
            while True:
                self.match(SPACE)
                self.entry(table)
                if self.mark("}"):
                    break
                self.must(self.mark(","), "expected , or }")
        return table

    def array(self, depth):
        values = []
        while True:
            self.match(BLANK)
            if self.mark("]"):
                return values
            values.append(self.value(depth + 1))
            self.match(BLANK)
            if not self.mark(","):
                self.must(self.mark("]"), "expected , or ]")
                return values

    def whole(self):
        root = {}
        table = root
        while True:
            self.match(BLANK)
            if self.at == len(self.text):
                return root
            if self.mark("["):
                name = self.match(KEY)
                self.must(name and self.mark("]"), "expected a table")
                self.must(name.group() not in root, "a table is there twice")
                table = root[name.group()] = {}
                self.match(SPACE)
            else:
                self.entry(table)
            self.match(re.compile(r"#[^\n]*"))
            self.must(self.mark("\n") or self.at == len(self.text), "expected the end of the line")


def read(text):
    return Reader(text).whole()
