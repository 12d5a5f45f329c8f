"""One body of a function for two precisions that differ in numbers alone."""

from __future__ import annotations

import re
from collections.abc import Iterable

from symhaptic.export.precision import DOUBLE, SINGLE, Precision

_NUMBER = re.compile(
    r"(?P<sign> [-+] (?=[\d.e+-]+(?:$|[,)])))?"
    r"(?P<size>(?:(?<=[(=,] )-|(?<=\()-)?(?<![\w.])\d+(?:\.\d*)?(?:e[-+]?\d+)?(?![\w.]))"
)
"""A number; of a term that is nothing else, with its sign."""


def of_both(
    double: list[str], single: list[str], taken: Iterable[str]
) -> tuple[list[str], list[tuple[str, str, str]]] | None:
    """The body with names for the numbers that differ, and these: name, double and single.

    Nothing where the bodies differ in more than that.

    >>> of_both(["y = 2.0*x + 1e-15"], ["y = 2.0*x - 1e-07"], ["x"])
    (['y = 2.0*x + number'], [('number', '1e-15', '-1e-07')])
    """
    if _shapes(double) != _shapes(single):
        return None
    used = {*taken, *re.findall(r"\w+", " ".join(double))}
    names: dict[tuple[str, str], str] = {}

    def named(one: re.Match[str], other: re.Match[str]) -> str:
        if one[0] == other[0]:
            return one[0]
        pair = _signed(one), _signed(other)
        if pair not in names:
            names[pair] = _fresh(_KNOWN.get(pair) or _usual(pair[0]), used)
        return f"{' + ' * bool(one['sign'])}{names[pair]}"

    found = []
    for one, other in zip(double, single, strict=True):
        shown, end = "", 0
        for pair in zip(_NUMBER.finditer(one), _NUMBER.finditer(other), strict=True):
            shown, end = f"{shown}{one[end : pair[0].start()]}{named(*pair)}", pair[0].end()
        found.append(shown + one[end:])
    return found, [(name, *pair) for pair, name in names.items()]


def _shapes(lines: list[str]) -> list[str]:
    return [_NUMBER.sub(lambda n: f"{'+' * bool(n['sign'])}#", line) for line in lines]


def _signed(number: re.Match[str]) -> str:
    return f"{'-' * ('-' in (number['sign'] or ''))}{number['size']}"


def _usual(number: str) -> str:
    """What counts is where a series begins; for slow poles it begins later."""
    return "begin" if number.isdigit() else "number"


def _fresh(name: str, used: set[str]) -> str:
    free, count = name, 1
    while free in used:
        count += 1
        free = f"{name}{count}"
    used.add(free)
    return free


def _of(precision: Precision) -> dict[str, str]:
    sizes = {"close": precision.close, "flat": precision.flat, "last": precision.last}
    return {name: repr(float(size)) for name, size in sizes.items()}


_KNOWN = {(_of(DOUBLE)[name], _of(SINGLE)[name]): name for name in _of(DOUBLE)}
"""Numbers that a precision has a name for."""
