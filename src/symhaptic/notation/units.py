"""Which unit did somebody write?  Its size and its dimension, from text such as ``N m s/rad``.

SI symbols are read here, exactly; other names are those of Pint, if it is installed.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterable, Mapping
from fractions import Fraction
from functools import cache, lru_cache
from importlib.util import find_spec
from itertools import product
from typing import Any, NamedTuple
from unicodedata import normalize


class Unit(NamedTuple):
    """A size in kg, m, s and rad, and the powers of these."""

    size: Fraction
    powers: tuple[int, int, int, int]

    @property
    def dimension(self) -> tuple[int, int, int]:
        """The powers of kg, m and s; an angle has no dimension."""
        return self.powers[:3]

    @property
    def angle(self) -> int:
        """The power of rad."""
        return self.powers[3]

    def times(self, other: Unit, power: int = 1) -> Unit:
        """The product with a power of another unit."""
        powers = (a + power * b for a, b in zip(self.powers, other.powers, strict=True))
        kg, m, s, rad = powers
        return Unit(self.size * other.size**power, (kg, m, s, rad))

    def converts_to(self, wanted: Unit) -> bool:
        """Whether it measures what ``wanted`` does.

        Pint counts an angle as a number, so that 1 rad/s converts to 1 Hz.  Here the power of the
        angle has to agree.  Units of rotation (kg m^2, N m/rad) are often written without rad, and
        for an energy, with rad^2.
        """
        rotates = wanted.dimension[:2] == (1, 2) and self.angle in (0, -1, -2)
        same_angle = self.angle == wanted.angle or rotates
        return self.dimension == wanted.dimension and same_angle


class UnknownUnit(ValueError):
    """A name that is no unit, or text that is no product of units."""


ONE = Unit(Fraction(1), (0, 0, 0, 0))
_PI = Fraction("3.14159265358979323846264338327950288419716939937511")
"""pi to 50 digits: a product with it, rounded to float64, is the nearest one."""

_NAMES = {
    "g": Unit(Fraction(1, 1000), (1, 0, 0, 0)),
    "m": Unit(Fraction(1), (0, 1, 0, 0)),
    "s": Unit(Fraction(1), (0, 0, 1, 0)),
    "N": Unit(Fraction(1), (1, 1, -2, 0)),
    "J": Unit(Fraction(1), (1, 2, -2, 0)),
    "Hz": Unit(Fraction(1), (0, 0, -1, 0)),
    "rad": Unit(Fraction(1), (0, 0, 0, 1)),
}
"""SI symbols, which take a prefix."""

_PREFIXES = {
    "G": Fraction(10**9),
    "M": Fraction(10**6),
    "k": Fraction(10**3),
    "c": Fraction(1, 100),
    "m": Fraction(1, 10**3),
    "u": Fraction(1, 10**6),
    "\u03bc": Fraction(1, 10**6),
    "n": Fraction(1, 10**9),
}

_SYMBOLS = {
    **_NAMES,
    **{
        prefix + name: Unit(size * unit.size, unit.powers)
        for prefix, size in _PREFIXES.items()
        for name, unit in _NAMES.items()
    },
    "min": Unit(Fraction(60), (0, 0, 1, 0)),
    "rpm": Unit(_PI / 30, (0, 0, -1, 1)),
    **dict.fromkeys(("deg", "\N{DEGREE SIGN}"), Unit(_PI / 180, (0, 0, 0, 1))),
    **dict.fromkeys(("turn", "turns", "rev"), Unit(2 * _PI, (0, 0, 0, 1))),
}

Written = tuple[Unit, Unit]
"""Symbols without spaces: the product of all but the last, and the last, which takes the power."""

_TOKEN = re.compile(
    r"\s*(?:(?:\^|\*\*)\s*(?P<power>[-+]?[0-9]+)|(?<=\w)(?P<attached>-?[0-9]+)"
    r"|(?P<name>[^\W\d]+|\N{DEGREE SIGN})|(?P<sign>[*/().\u00b7\u22c5\u00d7])|(?P<one>1(?=\s*/)))"
)
_WORDS = {"per": "/", "squared": "^2", "cubed": "^3", "square": "2", "sq": "2", "cubic": "3"}
"""Words of Pint's for signs; a digit raises the unit that follows."""

_LONGEST = 80
"""Characters of the text of a unit."""

_HIGHEST = 9
"""The power of a unit is at most this."""

_SHORT = 8
"""Letters that are read as several symbols without spaces."""

_MANY = 100
"""Meanings of a text that are compared."""


@lru_cache(maxsize=256)
def unit(text: str, wanted: str) -> Unit:
    """The unit that a text means where a quantity in ``wanted`` is asked for.

    ``ms`` is a millisecond, because it is one symbol.  ``Nms`` is several without spaces: N m s or
    N ms, whichever converts to ``wanted``.

    Raises :class:`UnknownUnit` for text that means nothing that converts to ``wanted``.
    """
    (target,) = _meanings(wanted, _symbols)
    found = _meanings(text, _symbols)
    if not any(one.converts_to(target) for one in found):
        found |= _meanings(text, _of_pint)
    fitting = [one for one in found if one.converts_to(target)]
    if len({one.size for one in fitting}) == 1:
        return fitting[0]
    if fitting:
        raise UnknownUnit("give a unit with one meaning, with spaces between its symbols")
    if any(one.dimension == target.dimension for one in found):
        raise UnknownUnit(other_angle(wanted))
    if not found and find_spec("pint") is None:
        raise UnknownUnit(f"give {said(wanted)}; pip install pint reads the names of other units")
    number = f"a number and a unit that converts to {said(wanted)}" if wanted else "a number"
    raise UnknownUnit(f"give {number}")


def angle_fits(angle: int, wanted: str) -> bool:
    """Whether a quantity of the dimension of ``wanted`` may have this power of an angle."""
    (target,) = _meanings(wanted, _symbols)
    kg, m, s = target.dimension
    return Unit(ONE.size, (kg, m, s, angle)).converts_to(target)


def other_angle(wanted: str) -> str:
    """What to give instead of a quantity with another power of an angle."""
    if wanted == "Hz":
        return "give a frequency in Hz without an angle: 2 pi rad/s are 1 Hz"
    if not wanted:
        return "give a number without an angle"
    return f"give {said(wanted)}, with no other power of an angle"


def said(wanted: str) -> str:
    """A unit as it is printed.

    >>> said("N*m*s/rad"), said("N*s/m"), said("kg*m**2")
    ('N m s/rad', 'Ns/m', 'kg m^2')
    """
    return "Ns/m" if wanted == "N*s/m" else wanted.replace("**", "^").replace("*", " ")


def spelled(printed: str) -> str:
    """A unit as Pint reads it; that of a number, 1, is none.

    >>> spelled("Ns/m"), spelled("N m s/rad"), spelled("1")
    ('N*s/m', 'N*m*s/rad', '')
    """
    own = {"Ns/m": "N*s/m", "1": ""}
    return own.get(printed, printed.replace("^", "**").replace(" ", "*"))


def _meanings(text: str, names: Callable[[str], Iterable[Written]]) -> set[Unit]:
    """All that a text may mean; nothing if it is no product of known units."""
    if len(text) > _LONGEST:
        return set()
    # superscripts become digits, and the two signs for micro become one
    text = normalize("NFKC", text).replace("\u2212", "-")
    tokens, end = list[str](), 0
    while text[end:].strip():
        match = _TOKEN.match(text, end)
        if match is None:
            return set()
        kind, end = str(match.lastgroup), match.end()
        word = match[kind]
        if kind in ("power", "attached"):
            word = f"^{word}"
        elif kind == "sign" and word not in "/()":
            word = "*"
        tokens.append(_WORDS.get(word, word))
    known = {word: {*names(word)} for word in tokens if _is_name(word)}
    found = set[Unit]()
    if math.prod(map(len, known.values())) > _MANY:
        return found
    for chosen in product(*known.values()):
        try:
            found.add(_Product(tokens, dict(zip(known, chosen, strict=True))).whole())
        except UnknownUnit:
            return set()
    return found


def _is_name(word: str) -> bool:
    return word.isalpha() or "_" in word or word == "\N{DEGREE SIGN}"


class _Product:
    """A product of units, from left to right as in Pint: ``N/m s`` is (N/m) s."""

    def __init__(self, tokens: list[str], units: Mapping[str, Written]) -> None:
        self.tokens = [*reversed(tokens)]
        self.units = units

    def whole(self) -> Unit:
        """The product of all tokens."""
        found = self.product() if self.tokens else ONE
        if self.tokens:
            raise UnknownUnit(self.tokens[-1])
        return found

    def product(self) -> Unit:
        """Factors up to a closing bracket or the end; a first ``/`` has a 1 before it."""
        found = ONE if self.next_is("/") else self.factor()
        while self.tokens and not self.next_is(")"):
            power = -1 if self.next_is("/") else 1
            if self.next_is("/") or self.next_is("*"):
                self.tokens.pop()
            found = found.times(self.factor(), power)
        return found

    def factor(self) -> Unit:
        """A unit or a product in brackets, with its power."""
        word = self.tokens.pop() if self.tokens else ""
        before = ONE
        if word in ("2", "3"):
            return ONE.times(self.factor(), int(word))
        if word == "(":
            last = self.product()
            if not self.next_is(")"):
                raise UnknownUnit(word)
            self.tokens.pop()
        elif word == "1" or word in self.units:
            before, last = self.units.get(word, (ONE, ONE))
        else:
            raise UnknownUnit(word)
        power = 1
        if self.tokens and self.tokens[-1].startswith("^"):
            power = int(self.tokens.pop()[1:])
        if abs(power) > _HIGHEST:
            raise UnknownUnit(word)
        return before.times(last, power)

    def next_is(self, sign: str) -> bool:
        """Whether this sign comes next."""
        return bool(self.tokens) and self.tokens[-1] == sign


def _symbols(name: str) -> list[Written]:
    """What a name means as one symbol, or else as several without spaces."""
    if name in _SYMBOLS:
        return [(ONE, _SYMBOLS[name])]
    return _split(name) if len(name) <= _SHORT else []


def _split(name: str) -> list[Written]:
    """All ways to read a name as symbols without spaces."""
    found = [(ONE, _SYMBOLS[name])] if name in _SYMBOLS else []
    return found + [
        (_SYMBOLS[name[:end]].times(before), last)
        for end in range(1, len(name))
        if name[:end] in _SYMBOLS
        for before, last in _split(name[end:])
    ]


@cache
def _pint() -> Any:
    from pint import UnitRegistry

    return UnitRegistry(non_int_type=Fraction)


_ROOTS = ("gram", "meter", "second", "radian")
"""Pint's names of the units that sizes are in; it has the gram for the kilogram."""


@lru_cache(maxsize=256)
def _of_pint(name: str) -> list[Written]:
    """What a name means, also to Pint if it is a multiple of products of kg, m, s and rad."""
    found = _symbols(name)
    if name in _SYMBOLS or find_spec("pint") is None:
        return found
    from pint import PintError

    quantity = _pint().Quantity
    try:
        one, two = (quantity(Fraction(n), name).to_root_units() for n in (1, 2))
    except (PintError, TypeError, ValueError):
        return found  # not known, or logarithmic
    powers = dict(one.unit_items())
    whole = all(power == int(power) for power in powers.values())
    if two.magnitude != 2 * one.magnitude or not whole or not powers.keys() <= {*_ROOTS}:
        return found  # such as degrees Celsius
    kg, m, s, rad = (int(powers.get(root, 0)) for root in _ROOTS)
    return [*found, (ONE, Unit(Fraction(one.magnitude) / Fraction(1000) ** kg, (kg, m, s, rad)))]
