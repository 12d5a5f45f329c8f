r"""Reads a formula as printed, in LaTeX, into SymPy: the transcription is typed only once.

The conventions are those of the paper (and of IEEE print): juxtaposition binds more tightly
than a slash, so that ``\pi/T(d+1)`` is :math:`\pi/(T(d+1))` and ``b^2/4m`` is
:math:`b^2/(4m)`; ``j`` is the imaginary unit and ``e`` the base of the exponential.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NoReturn, TypeAlias

import sympy as sp
from sympy import Expr

from symhaptic.notation import FUNCTIONS, SYMBOLS

Printed = tuple[Expr, ...]

_TOKEN = re.compile(
    r"\\hat\s*\{=\}|\\hat\s*\{\\omega\}|\\begin\{[a-z]+\}|\\end\{[a-z]+\}|\\text\s*\{[^{}]*\}|"
    r"\\[A-Za-z]+|\\\\|\\[,;!{}]|\d+(?:\.\d+)?(?:\\,\d{3})*|:=|[A-Za-z]|[-+/^_(){}\[\]=<>|&,]"
)
_IGNORED = {r"\br", r"\left", r"\right", r"\!"}
_SPACES = {r"\,", r"\;"}
_SMALL = re.compile(r"_\s*\{\s*(\w)\s*\}")
r"""A subscript of one character, which needs no braces."""
_MARKED = re.compile(r"\\changed\s*\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}")
r"""What is ``\changed``, whose braces print nothing."""
_RELATIONS: dict[str, type] = {
    "=": sp.Eq,
    ":=": sp.Eq,
    r"\hat{=}": sp.Eq,
    r"\approx": sp.Eq,
    "<": sp.StrictLessThan,
    ">": sp.StrictGreaterThan,
    **dict.fromkeys((r"\neq", r"\ne"), sp.Ne),
    **dict.fromkeys((r"\leq", r"\le"), sp.LessThan),
    **dict.fromkeys((r"\geq", r"\ge"), sp.GreaterThan),
}
_SIGN = re.compile(
    r":=|[=<>]|\\(?:leq?|geq?|neq?|approx|sim|simeq|equiv|cong|propto|ll|gg|lesssim|gtrsim|in|not)\b"
)
"""What relates two sides, whether it can be read or not."""
_FUNCTIONS = {r"\sin": sp.sin, r"\cos": sp.cos, r"\tan": sp.tan, r"\exp": sp.exp}
_CLOSING = {"(": ")", "[": "]", "{": "}", r"\{": r"\}"}
_TIMES = {"(": "t", "[": "k"}
"""In which brackets values at another time are written, as x(t + T) and x[k + 1]."""
_TAKEN = {
    r"\frac",
    r"\tfrac",
    r"\sqrt",
    r"\Re",
    r"\pi",
    r"\cdot",
    r"\times",
    *_FUNCTIONS,
    *_RELATIONS,
}
"""Commands that are no names."""
_UNITS = {"s": "second", "N/m": "newton_per_metre"}
_SYMBOLS = {entry.latex: name for name, entry in SYMBOLS.items()}


class Unreadable(ValueError):
    """LaTeX that is not a formula in the paper's notation."""


Notation: TypeAlias = tuple[tuple[str, str], ...]
"""What another source calls something, as LaTeX, and the name that it has here."""


def read(latex: str, notation: Notation = ()) -> Printed:
    r"""The relations (or the one expression) that a line of LaTeX says.

    A chain of relations gives one relation per link, an equation between vectors one per
    component.

    >>> read(r"\omega = \pi/T(d+1)")
    (Eq(omega, pi/(T*(d + 1))),)
    >>> read(r"b > \frac{KT}{2} + |B|")
    (b > K*T/2 + Abs(B),)
    >>> read(r"k_w < 2b/T", notation=(("k_w", "K"),))  # K is then no other name for it
    (K < 2*b/T,)
    """
    return _Reader(latex, notation).line()


def signs_of(lines: Iterable[str]) -> list[str]:
    r"""The relation signs of some LaTeX, in their order.

    >>> signs_of([r"x \ne y", r"0 \leq x < 1"])
    ['\\\\neq', '\\\\leq', '<']
    """
    other = {r"\le": r"\leq", r"\ge": r"\geq", r"\ne": r"\neq", ":=": "="}
    return [other.get(sign, sign) for line in lines for sign in _SIGN.findall(line)]


def _called(latex: str) -> str:
    """A name that a source has, as it is met; :class:`Unreadable` of what is read otherwise."""
    name = _Reader(latex)
    token = name.take()
    spelled = token + name.subscript()
    if (
        name.peek()
        or token in _TAKEN
        or not re.fullmatch(r"[A-Za-z]|\\(?:hat\W+)?[A-Za-z]+\}?", token)
    ):
        raise Unreadable(
            f"{latex!r} is no name: a letter or a command with or without a subscript is"
        )
    return spelled


class _Reader:
    def __init__(self, latex: str, notation: Notation = ()) -> None:
        self.latex = latex
        self.own = {_called(tex): name for tex, name in notation}
        self.names = {tex: n for tex, n in _SYMBOLS.items() if n not in self.own.values()}
        squeezed = re.sub(r"\\mathrm\s*\{\s*e\s*\}", " e ", latex)
        squeezed = re.sub(r"\\hat\s*\{\s*=\s*\}", r"\\hat{=}", squeezed)
        squeezed = _MARKED.sub(r" \1 ", _SMALL.sub(r"_\1 ", squeezed))
        rest = _TOKEN.sub("", squeezed).replace("~", "").split()
        if rest and not (len(rest) == 1 and rest[0] in ".;" and latex.rstrip().endswith(rest[0])):
            raise Unreadable(f"cannot read {rest!r} in {latex!r}")
        self.tokens: list[str] = []
        self.spaced = set[int]()
        """The tokens behind a space."""
        for token in _TOKEN.findall(squeezed):
            if token in _SPACES:
                self.spaced.add(len(self.tokens))
            elif token not in _IGNORED:
                self.tokens.append(token)
        self.at = 0

    # -- tokens ---------------------------------------------------------------------

    def peek(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self, expected: str | None = None) -> str:
        token = self.peek()
        if not token or (expected is not None and token != expected):
            raise Unreadable(f"expected {expected or 'more'}, found {token!r} in {self.latex!r}")
        self.at += 1
        return token

    # -- grammar --------------------------------------------------------------------

    def line(self) -> Printed:
        sides, relations = [self.sum()], []
        while self.peek() in _RELATIONS:
            relations.append(_RELATIONS[self.take()])
            sides.append(self.sum())
        if self.peek():
            raise Unreadable(f"{self.peek()!r} left over in {self.latex!r}")
        if not relations:
            return (sides[0],)
        links: list[Expr] = []
        for kind, left, right in zip(relations, sides, sides[1:], strict=False):
            vectors = [isinstance(side, sp.MatrixBase) for side in (left, right)]
            if any(vectors) and not (all(vectors) and left.shape == right.shape):
                raise Unreadable(f"a vector against something else in {self.latex!r}")
            pairs = zip(left, right, strict=True) if all(vectors) else [(left, right)]
            links += [kind(one, other, evaluate=False) for one, other in pairs]
        return tuple(links)

    def sum(self) -> Expr:
        sign = -1 if self.peek() == "-" else 1
        if self.peek() in ("+", "-"):
            self.take()
        total = sign * self.term()
        while self.peek() in ("+", "-"):
            minus = self.take() == "-"
            term = self.term()
            if isinstance(term, sp.MatrixBase) != isinstance(total, sp.MatrixBase):
                raise Unreadable(f"a vector added to a number in {self.latex!r}")
            total = total - term if minus else total + term
        return total

    def term(self) -> Expr:
        begin, value = self.at, self.chain()
        while self.peek() in (r"\cdot", r"\times", "/"):
            divides = self.take() == "/"
            if divides:
                self.no_derivative(self.tokens[begin : self.at])
            factor = self.chain()
            value = value / factor if divides else value * factor
        return value

    def no_derivative(self, above: list[str]) -> None:
        """Refuse dx/dt, in which d is no delay; here begins what stands below."""
        d, by = self.tokens[self.at : self.at + 1], "".join(self.tokens[self.at + 1 : self.at + 2])
        if "d" in above and d == ["d"] and re.fullmatch(r"\\?[A-Za-z]+", by) and by not in _TAKEN:
            raise Unreadable(f"a derivative by {by!r}, or a d in both, in {self.latex!r}")

    def chain(self) -> Expr:
        value = self.power()
        while self.starts_factor():
            value = value * self.factor()
        return value

    def factor(self) -> Expr:
        """A factor right of another; v(t), x[k + 1] and K(0) are values, or products that nobody
        writes so."""
        if self.peek()[0].isdigit():
            raise Unreadable(f"a number right of a factor in {self.latex!r}")
        start, opening = self.at, self.peek()
        if opening in ("(", "["):
            self.take()
            sign = self.take()
            if sign[-1].isalnum() and sign not in _FUNCTIONS:
                sign += self.subscript()
                moved = sign == _TIMES[opening] and self.peek() in ("+", "-")
                if self.peek() == _CLOSING[opening] or (moved and self.tokens[start - 1].isalpha()):
                    shown = f"{opening}{sign}{self.peek()}"
                    raise Unreadable(f"a value or a product with {shown!r} in {self.latex!r}")
            self.at = start
        return self.power()

    def argument(self) -> Expr:
        """What a function applies to: a bracket, or factors up to the next function."""
        bracket = self.peek() == "("
        value = self.group() if bracket else self.power()
        while self.starts_factor() and self.peek() not in _FUNCTIONS:
            if bracket or self.at in self.spaced:
                self.unclear()
            value = value * self.factor()
        if not bracket and self.peek() in (r"\cdot", r"\times", "/"):
            self.unclear()
        return value

    def unclear(self) -> NoReturn:
        """What stands here may be a part of the function before it, or not."""
        raise Unreadable(
            f"whether {self.peek()!r} is in the function before it, in {self.latex!r}; a bracket "
            "around all that the function is of tells, or the factor before the function"
        )

    def starts_factor(self) -> bool:
        token = self.peek()
        if not token or token in _RELATIONS or token in (r"\cdot", r"\times", r"\\", r"\}"):
            return False
        return (
            (token[0] == "\\" and not token.startswith(r"\end"))
            or token[0] in "([{"
            or (token[0].isalnum())
        )

    def power(self) -> Expr:
        base = self.atom()
        if self.peek() == "^":
            self.take()
            exponent = self.exponent()
            return sp.exp(exponent) if base is _E else base**exponent
        if base is _E:
            raise Unreadable(f"e without exponent in {self.latex!r}")
        return base

    def exponent(self) -> Expr:
        """What stands in braces, or what TeX raises without: one digit or letter, not more."""
        token = self.peek()
        if token == "{":
            return self.group()
        if token in {*_CLOSING, *_FUNCTIONS, "|"} or (token[:1].isdigit() and len(token) > 1):
            raise Unreadable(f"an exponent {token!r} without braces in {self.latex!r}")
        if self.tokens[self.at + 1 : self.at + 2] == ["_"]:  # it is printed below the base
            raise Unreadable(f"a subscript behind the exponent {token!r} in {self.latex!r}")
        return self.atom()

    def group(self, expected: str | None = None) -> Expr:
        opening = self.take(expected)
        value = self.sum()
        self.take(_CLOSING[opening])
        return value

    def atom(self) -> Expr:
        token = self.peek()
        if token == "{":
            raise Unreadable(f"braces, which print nothing, around a part of {self.latex!r}")
        if token in _CLOSING:
            return self.group()
        if token == "|":
            self.take()
            inside = self.sum()
            self.take("|")
            return sp.Abs(inside)
        self.take()
        if token[0].isdigit():
            return sp.Rational(token.replace(r"\,", ""))
        if token in (r"\frac", r"\tfrac"):
            begin, above = self.at + 1, self.group("{")
            self.take("{")
            self.no_derivative(self.tokens[begin : begin + 1])
            below = self.sum()
            self.take("}")
            return above / below
        if token == r"\sqrt" and self.peek() != "{":
            raise Unreadable(f"a root that is not square in {self.latex!r}")
        if token == r"\sqrt":
            return sp.sqrt(self.group())
        if token == r"\Re":
            if self.peek() not in ("(", r"\{"):
                raise Unreadable(f"{token} without a bracket in {self.latex!r}")
            return sp.re(self.group(), evaluate=False)
        if token == r"\begin{pmatrix}":
            return self.vector()
        if token in _FUNCTIONS:
            power = sp.S.One
            if self.peek() == "^":
                self.take()
                power = self.exponent()
            if power == -1:
                raise Unreadable(f"{token}^{{-1}}, an inverse or 1/{token}, in {self.latex!r}")
            return _FUNCTIONS[token](self.argument()) ** power
        if token.startswith(r"\text"):
            unit = token.partition("{")[2][:-1].strip()
            if unit in _UNITS:
                return sp.Symbol(_UNITS[unit])
            raise Unreadable(f"words {unit!r} in {self.latex!r}")
        if token == r"\pi":
            return sp.pi
        return self.name(token)

    def vector(self) -> Expr:
        first = self.at == 1
        rows = [self.sum()]
        while self.peek() == r"\\":
            self.take()
            rows.append(self.sum())
        self.take(r"\end{pmatrix}")
        if first:  # it tells of which numbers the line speaks
            self.subscript()
        return sp.Matrix(rows)

    def subscript(self) -> str:
        if self.peek() != "_":
            return ""
        self.take()
        if self.peek() != "{":
            return "_" + self.take()
        depth, start = 0, self.at
        while True:
            token = self.take()
            depth += (token == "{") - (token == "}")
            if depth == 0:
                return "_" + "".join(self.tokens[start : self.at])

    def name(self, token: str) -> Expr:
        spelled = token + self.subscript()
        if spelled in self.own:
            return sp.Symbol(self.own[spelled])
        if spelled == "j":
            return sp.I
        if spelled == "e":
            return _E
        if spelled in FUNCTIONS and self.peek() == "(":
            return sp.Function(spelled)(self.group())
        if spelled in self.names:
            return sp.Symbol(self.names[spelled])
        if spelled in _SYMBOLS:
            other = next(tex for tex, name in self.own.items() if name == _SYMBOLS[spelled])
            raise Unreadable(f"{spelled!r}, which the source calls {other!r}, in {self.latex!r}")
        raise Unreadable(f"{spelled!r} is not in the notation, in {self.latex!r}")


_E = sp.Symbol("_base_of_the_exponential")
