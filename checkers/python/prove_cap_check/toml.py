"""Reading TOML (FORMAT.md section 2). TOML itself forbids duplicate keys; unknown keys are found in statement.py."""

from .limits import Malformed

try:
    import tomllib
except ImportError:  # before Python 3.11
    tomllib = None


class NoValue:
    """Stands for a TOML float, which no key of a statement takes; so nothing is ever made a floating point number."""

    def __init__(self, text):
        pass


def read(data):
    try:
        text = data.decode("utf-8")
    except UnicodeDecodeError:
        raise Malformed("the statement is not UTF-8")
    if tomllib is None:
        from .minitoml import read as read_subset
        return read_subset(text)
    try:
        return tomllib.loads(text, parse_float=NoValue)
    except (tomllib.TOMLDecodeError, ValueError, RecursionError) as error:
        raise Malformed("the statement is not TOML: %s" % str(error)[:200])
