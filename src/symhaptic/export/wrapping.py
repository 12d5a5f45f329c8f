"""Lines of source that people can read: broken where a language lets them go on."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterable

WIDTH = 100

_COMMENT = re.compile(r"\s*(//[/!]?|\*|%|!|#) ")
_GAP = re.compile(
    r"[,?] |\{ (?!\w+; \})|(?<= ): |\((?!\))|(?<= )[-+=] |(?<![ */])[*/](?![*/])"
    r"|(?:&&|\|\||\.and\.|\.or\.|[&|]) "
)
"""Behind these a line may end: no language takes what is before for a whole statement, and a block
of one word stays together."""


def wrapped(lines: Iterable[str], end: str = "", width: int = WIDTH) -> list[str]:
    """Lines of source and comments; ``end`` is what a line that goes on ends with."""
    return [part for line in lines for part in _parts(line, end, width)]


def _parts(line: str, end: str, width: int, inside: bool = False) -> list[str]:
    if len(line) <= width:
        return [line]
    if lead := _COMMENT.match(line):
        text = line[lead.end() :]
        return textwrap.wrap(
            text, width, initial_indent=lead[0], subsequent_indent=lead[0],
            break_long_words=False, break_on_hyphens=False,
        )  # fmt: skip
    indent = " " * (len(line) - len(line.lstrip()) + 4)
    found = []
    while len(line) > width and (at := _best(line, width - len(end), inside)):
        found.append(line[:at].rstrip() + end)
        line, inside = indent + line[at:].lstrip(), False
    return [*found, line]


def _best(line: str, width: int, inside: bool = False) -> int:
    """Where to break: inside as few brackets as possible, then as late as possible; 0 if nowhere.

    In one bracket at least, if it has to be inside.

    >>> line = "    y = f(a, b) + g(c, d);"
    >>> line[: _best(line, 20)]
    '    y = f(a, b) + '
    """
    start = len(line) - len(line.lstrip())
    gaps = [m.end() for m in _GAP.finditer(line, start) if m.end() <= width]
    gaps = [at for at in gaps if depth(line[:at]) > 0] if inside else gaps
    late = [at for at in gaps if at > start + 0.4 * (width - start)] or gaps[-1:]
    return min(late, key=lambda at: (depth(line[:at]), -at), default=0)


def depth(text: str) -> int:
    """Brackets that are open behind a text."""
    return sum((c in "([{") - (c in ")]}") for c in text)


def in_brackets(line: str) -> list[str]:
    """A statement of Python, with brackets round what would not go on without them."""
    if len(line) <= WIDTH:
        return [line]
    pad = line[: len(line) - len(line.lstrip())]
    names, equals, value = line.strip().partition(" = ")
    if not equals or depth(names):
        word, value = line.strip().split(" ", 1)
        return _valued(pad, f"{word} ", value)
    if len(pad + names) < WIDTH - 10:
        return _valued(pad, f"{names} = ", value)
    return [f"{pad}(", *wrapped([f"{pad}    {names}"]), *_valued(pad, ") = ", value)]


def _valued(pad: str, start: str, value: str) -> list[str]:
    """A value behind the start of its statement; a call goes on inside its own brackets."""
    parts = _parts(pad + start + value, "", WIDTH, inside=_is_call(value))
    inside = (depth("".join(parts[:i])) > depth(start) for i in range(1, len(parts)))
    if parts[1:] and all(inside):
        return parts
    first, *others = wrapped([f"{pad}    {value}"])
    inner = [first, *(other.removeprefix("    ") for other in others)]
    return [f"{pad}{start}(", *inner, f"{pad})"]


def _is_call(value: str) -> bool:
    """Whether one call is all of it.

    >>> _is_call("f(x, g(y))"), _is_call("f(x)*g(y)")
    (True, False)
    """
    name, _, rest = value.partition("(")
    closed = (at for at in range(len(rest)) if depth(rest[: at + 1]) < 0)
    return name.isidentifier() and next(closed, None) == len(rest) - 1
