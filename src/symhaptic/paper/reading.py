r"""Reads a formula as published, in LaTeX, into SymPy: the transcription is typed only once.

The conventions are those of the paper (and of IEEE print): juxtaposition binds more tightly
than a slash, so that ``\pi/T(d+1)`` is :math:`\pi/(T(d+1))` and ``b^2/4m`` is
:math:`b^2/(4m)`; ``j`` is the imaginary unit and ``e`` the base of the exponential.
"""

from __future__ import annotations

import itertools
import re
from collections.abc import Iterable
from functools import partial
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
_MOST_BITS = 100_000
"""Of the power of a number: 9^{9^{9^9}} would be computed for ever."""

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
    r":=|[=<>]|\\(?:leq?|geq?|neq?|approx|sim|simeq|equiv|cong|propto|ll|gg|lesssim|gtrsim|in|not)"
    r"(?![A-Za-z])"
)
"""What relates two sides, whether it can be read or not."""
_FUNCTIONS = {
    r"\sin": sp.sin,
    r"\cos": sp.cos,
    r"\tan": sp.tan,
    r"\exp": sp.exp,
    r"\ln": partial(sp.log, evaluate=False),
    r"\arctan": partial(sp.atan, evaluate=False),
}
_EXTREMES = {r"\min": -1, r"\max": 1}
_WORDS = re.compile(r"\\(?:mathrm|operatorname|text)\s*\{\s*(Re|min|max|ln|arctan)\s*\}")
"""Names of functions that are typed as upright letters."""
_CLOSING = {"(": ")", "[": "]", "{": "}", r"\{": r"\}"}
_BESIDE = {*_CLOSING, r"\frac", r"\tfrac", r"\sqrt"}
"""What behind the letters of an angle may be in the function before them, or a factor beside it."""
_TIMES = {"(": "t", "[": "k"}
"""In which brackets values at another time are written, as x(t + T) and x[k + 1]."""
_TAKEN = {
    r"\frac",
    r"\tfrac",
    r"\sqrt",
    r"\Re",
    r"\dot",
    r"\pi",
    r"\cdot",
    r"\times",
    *_FUNCTIONS,
    *_EXTREMES,
    *_RELATIONS,
}
"""Commands that are no names."""
_GREEK = frozenset(
    re.findall(
        r"\\\S+",
        r"\alpha \beta \gamma \delta \epsilon \varepsilon \zeta \eta \theta \vartheta \iota \kappa "
        r"\lambda \mu \nu \xi \rho \varrho \sigma \varsigma \tau \upsilon \phi \varphi \chi \psi "
        r"\omega \Gamma \Delta \Theta \Lambda \Xi \Pi \Sigma \Upsilon \Phi \Psi \Omega \ell \hbar "
        r"\hat{\omega}",
    )
)
"""Commands that print a letter, of which a name may be made."""
_EULER = r"\eulersnumber"
"""The token of an upright e, which no source calls otherwise."""
_SIGNALS = {"x", "v", "F", "F_E"}
_INSTANTS = {"t", "t_d", "T", "T_s", "k", "d", "l", "tau"}
"""What has a value at each time, and what times are made of: x(kT) is a value, and no product."""
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
    ['\\neq', '\\leq', '<']
    """
    other = {r"\le": r"\leq", r"\ge": r"\geq", r"\ne": r"\neq", ":=": "="}
    return [other.get(sign, sign) for line in lines for sign in _SIGN.findall(line)]


def sides_of(line: str) -> list[str]:
    r"""What stands between the relation signs of some LaTeX.

    >>> sides_of(r"x \ne y = 1")
    ['x ', ' y ', ' 1']
    """
    return _SIGN.split(line)


def _called(latex: str) -> str:
    """A name that a source has, as it is met; :class:`Unreadable` of what is read otherwise."""
    name = _Reader(latex)
    token = name.take()
    spelled = token + name.subscript()
    letter = re.fullmatch("[A-Za-z]", token) or token in _GREEK
    if name.peek() or not letter or not _RELATIONS.keys().isdisjoint(name.tokens):
        raise Unreadable(
            f"{latex!r} is no name: a Latin or Greek letter with or without a subscript is"
        )
    return spelled


def _differential(tokens: list[str]) -> str:
    """The name behind a d that may be a differential, as in m dv, and stands in no function."""
    for d, by in itertools.pairwise(tokens):
        if d in _FUNCTIONS:
            break
        if d == "d" and re.fullmatch(r"\\?[A-Za-z]+", by) and by not in _TAKEN:
            return by
    return ""


_DRESS = re.compile(
    r"\\(?:math(?:rm|bf|it|sf|normal)|boldsymbol|text(?:rm|bf|it)?|operatorname\*?|mbox|bigg?[lr]?|"
    r"Bigg?[lr]?|displaystyle|textstyle|qquad|quad)(?![A-Za-z])|\\[ :]"
)
"""Commands that change how a formula looks, and not what it says."""
_FRACTION = re.compile(r"\\[dt]?frac\s*(\{.*?\}|\\[A-Za-z]+|\w)\s*(\\[A-Za-z]+|\w)")
_FORMULAS = re.compile(
    r"\\(?:[dt]?frac|sqrt|cdot|times|pi|ln|log|lg|exp|max|min|gcd|deg|sgn|det|"
    r"(?:arc|a)?(?:sin|cos|tan|cot|sec|csc)h?|infty|left|right|sum|prod)(?![A-Za-z])|(?<![A-Za-z\\])[ej](?![A-Za-z])"
)
"""Commands and letters that stand in formulas of numbers."""


def undressed(name: str) -> str:
    r"""A name without what does not change what it says: fonts, spaces and needless braces.

    >>> undressed(r"{1 + \mathbf{1}}"), undressed(r"\tfrac12K")
    ('(1 + (1))', '\\frac{1}{2}K')
    """
    plain = _FRACTION.sub(
        lambda found: r"\frac" + "".join(g if g[0] == "{" else f"{{{g}}}" for g in found.groups()),
        _DRESS.sub("", name),
    )
    out, open_, before = "", list[str](), ""
    for token in re.findall(r"\\[A-Za-z]+\*?|\\.|.", plain, re.DOTALL):
        if token == "{":
            kept = before in ("_", "^", r"\sqrt", r"\frac", r"\tfrac", r"\hat", r"\dfrac") or (
                before == "}" and out.endswith("}")
            )
            open_.append("}" if kept else ")")
            token = "{" if kept else "("
        elif token == "}" and open_:
            token = open_.pop()
        out += token
        before = token if not token.isspace() else before
    return out


def names_something(name: str) -> bool:
    r"""Whether LaTeX that is no formula can be a name: it has a letter, and relates nothing.

    Relations in a subscript or a superscript say where something is taken.

    >>> names_something(r"x\big|_{t=0}"), names_something(r"\ln 1"), names_something("q = 0!")
    (True, False, False)
    """
    outside = name
    for _ in range(6):  # innermost braces first
        outside = re.sub(r"[_^]\s*\{[^{}]*\}", "", outside)
        outside = re.sub(r"(?<![_^])\{([^{}]*)\}", r" \1 ", outside)
    return not _SIGN.search(outside) and bool(re.search("[A-Za-z]", _FORMULAS.sub("", name)))


class _Reader:
    def __init__(self, latex: str, notation: Notation = (), inert: bool = False) -> None:
        self.latex, self.notation, self.inert = latex, notation, inert
        self.own = {_called(tex): name for tex, name in notation}
        self.names = {tex: n for tex, n in _SYMBOLS.items() if n not in self.own.values()}
        squeezed = re.sub(r"\\mathrm\s*\{\s*e\s*\}", rf" \{_EULER} ", latex)
        squeezed = _WORDS.sub(r"\\\1 ", squeezed)
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
        self.divisors: list[Expr] = []
        """The expressions that the line divides by."""

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
        sides, relations, starts = [self.sum()], [], [0]
        while self.peek() in _RELATIONS:
            relations.append(_RELATIONS[self.take()])
            starts.append(self.at)
            sides.append(self.sum())
        ends = [*starts[1:], self.at]
        by = [_differential(self.tokens[i:j]) for i, j in zip(starts, ends, strict=True)]
        if sum(map(bool, by)) > 1:
            raise Unreadable(f"differentials, or a d on both sides, in {self.latex!r}")
        if self.peek():
            raise Unreadable(f"{self.peek()!r} left over in {self.latex!r}")
        if self.loses_a_divisor(sides):
            if self.inert:
                raise Unreadable(f"a divisor that cancels, in {self.latex!r}")
            return _Reader(self.latex, self.notation, inert=True).line()
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
        total = self.made(sp.Mul, sp.Integer(sign), self.term()) if sign < 0 else self.term()
        while self.peek() in ("+", "-"):
            minus = self.take() == "-"
            term = self.term()
            if isinstance(term, sp.MatrixBase) != isinstance(total, sp.MatrixBase):
                raise Unreadable(f"a vector added to a number in {self.latex!r}")
            term = self.made(sp.Mul, sp.S.NegativeOne, term) if minus else term
            total = self.made(sp.Add, total, term)
        return total

    def term(self) -> Expr:
        begin, value = self.at, self.chain()
        while self.peek() in (r"\cdot", r"\times", "/"):
            divides, end = self.take() == "/", self.at
            factor = self.chain()
            if divides:
                self.no_derivative(self.tokens[begin:end], self.tokens[end : self.at])
            factor = self.raised(factor, sp.S.NegativeOne) if divides else factor
            value = self.made(sp.Mul, value, factor)
        return value

    def made(self, kind: type, *parts: Expr) -> Expr:
        """Make a sum, a product or a power, without evaluation if SymPy would cancel a divisor."""
        plain = not self.inert or any(isinstance(p, sp.MatrixBase) for p in parts)
        return kind(*parts) if plain else kind(*parts, evaluate=False)

    def raised(self, base: Expr, exponent: Expr) -> Expr:
        if not exponent.is_nonnegative:
            self.divisors.append(base)
        if base.is_Rational and exponent.is_Rational:
            bits = max(abs(base.p), base.q).bit_length() * abs(exponent)
            if bits > _MOST_BITS and abs(base) not in (0, 1):
                raise Unreadable(
                    f"a number of more than {_MOST_BITS} bits, in {self.latex!r}; give its "
                    "logarithm, or the power of a symbol"
                )
        return self.made(sp.Pow, base, exponent)

    def loses_a_divisor(self, sides: Iterable[Expr]) -> bool:
        """Whether evaluation has removed a divisor, as when SymPy makes 1 = 1 of x/x = 1."""
        powers = [power for side in sides for power in side.atoms(sp.Pow)]
        bases = [p.base for p in powers if not p.exp.is_nonnegative]
        left = {_alike(f) for base in bases for f in sp.Mul.make_args(base)}
        left |= {_alike(sp.cos(f.args[0])) for side in sides for f in side.atoms(sp.tan)}
        factors = (f.as_base_exp() for below in self.divisors for f in sp.Mul.make_args(below))
        return any(
            base.free_symbols and not exponent.is_negative and _alike(base) not in left
            for base, exponent in factors
        )

    def no_derivative(self, above: list[str], below: list[str]) -> None:
        """Refuse m dx/dt, in which d is no delay."""
        if "d" in above and (by := _differential(below)):
            raise Unreadable(f"a derivative by {by!r}, or a d in both, in {self.latex!r}")

    def chain(self) -> Expr:
        value = self.power()
        while self.starts_factor():
            value = self.made(sp.Mul, value, self.factor())
        return value

    def factor(self) -> Expr:
        """A factor right of another; v(t), x[k + 1] and K(0) are values, or products that nobody
        writes so."""
        if self.peek()[0].isdigit():
            raise Unreadable(f"a number right of a factor in {self.latex!r}")
        start, opening = self.at, self.peek()
        if opening in (r"\frac", r"\tfrac") and self.tokens[start - 1][0].isdigit():
            self.mixed()
        if opening in ("(", "[") and self.signal(start - 1):
            inside = self.group()
            if inside.free_symbols and {s.name for s in inside.free_symbols} <= _INSTANTS:
                raise Unreadable(f"a value at a time, or a product, in {self.latex!r}")
            self.at = start
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

    def mixed(self) -> None:
        """Refuse a number before a fraction of numbers, which may be added to it."""
        rest = self.tokens[self.at + 1 : self.at + 7]
        if len(rest) == 6 and rest[1][0].isdigit() and rest[4][0].isdigit():
            raise Unreadable(f"a mixed number or a product in {self.latex!r}")

    def signal(self, at: int) -> bool:
        """Whether the token is the name of what changes in time."""
        name = self.tokens[at]
        if at > 1 and self.tokens[at - 1] == "_":
            name = f"{self.tokens[at - 2]}_{name}"
        return self.own.get(name, self.names.get(name)) in _SIGNALS

    def argument(self) -> Expr:
        """What a function applies to: a bracket, or factors up to the next function."""
        bracket = self.peek() == "("
        value = self.group() if bracket else self.power()
        while self.starts_factor() and self.peek() not in _FUNCTIONS:
            beside = bool(value.free_symbols) and self.peek() in _BESIDE
            if bracket or beside or self.at in self.spaced:
                self.unclear()
            value = self.made(sp.Mul, value, self.factor())
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
            begin, exponent = self.at, self.exponent()
            if base is _E:
                return sp.exp(exponent)
            raised = "".join(self.tokens[begin : self.at])
            if base.is_Symbol and re.fullmatch(r"\{\([^()]*\)}", raised):
                raise Unreadable(f"a power or a derivative, in {self.latex!r}")
            return self.raised(base, exponent)
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
            begin, above = self.at, self.group("{")
            end, below = self.at, self.group("{")
            self.no_derivative(self.tokens[begin:end], self.tokens[end : self.at])
            return self.made(sp.Mul, above, self.raised(below, sp.S.NegativeOne))
        if token == r"\sqrt" and self.peek() != "{":
            raise Unreadable(f"a root that is not square in {self.latex!r}")
        if token == r"\sqrt":
            return sp.sqrt(self.group())
        if token == r"\Re":
            if self.peek() not in ("(", r"\{"):
                raise Unreadable(f"{token} without a bracket in {self.latex!r}")
            return sp.re(self.group(), evaluate=False)
        if token == r"\dot":
            inside = self.group() if self.peek() == "{" else self.atom()
            if inside == sp.Symbol("x"):
                return sp.Symbol("v")
            raise Unreadable(f"the derivative of something else than x in {self.latex!r}")
        if token in _EXTREMES:
            return self.extreme(token)
        if token == r"\begin{pmatrix}":
            return self.vector()
        if token in _FUNCTIONS:
            power = sp.S.One
            if self.peek() == "^":
                self.take()
                power = self.exponent()
            if power == -1:
                raise Unreadable(f"{token}^{{-1}}, an inverse or 1/{token}, in {self.latex!r}")
            value = _FUNCTIONS[token](self.argument())
            if isinstance(value, sp.tan):
                self.divisors.append(sp.cos(value.args[0]))
            return value if power == 1 else self.raised(value, power)
        if token.startswith(r"\text"):
            unit = token.partition("{")[2][:-1].strip()
            if unit in _UNITS:
                return sp.Symbol(_UNITS[unit])
            raise Unreadable(f"words {unit!r} in {self.latex!r}")
        if token == r"\pi":
            return sp.pi
        return self.name(token)

    def extreme(self, token: str) -> Expr:
        """The least or the largest of several values: (x + y - |x - y|)/2, or with a plus."""
        if self.peek() not in _CLOSING or self.peek() == "{":
            raise Unreadable(f"{token} without a bracket in {self.latex!r}")
        opening = self.take()
        values = [self.sum()]
        while self.peek() == ",":
            self.take()
            values.append(self.sum())
        self.take(_CLOSING[opening])
        if len(values) == 1:
            raise Unreadable(f"{token} of one value in {self.latex!r}")
        found = values[0]
        for value in values[1:]:
            found = (found + value + _EXTREMES[token] * sp.Abs(found - value)) / 2
        return found

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
        if spelled in ("e", _EULER):
            return _E
        if spelled in FUNCTIONS and self.peek() == "(":
            return sp.Function(spelled)(self.group())
        if spelled in self.names:
            return sp.Symbol(self.names[spelled])
        if spelled in _SYMBOLS:
            other = next(tex for tex, name in self.own.items() if name == _SYMBOLS[spelled])
            raise Unreadable(f"{spelled!r}, which the source calls {other!r}, in {self.latex!r}")
        raise Unreadable(f"{spelled!r} is not in the notation, in {self.latex!r}")


def _alike(base: Expr) -> frozenset[Expr]:
    """The same for all multiples of an expression."""
    form = sp.expand(base).primitive()[1]
    return frozenset((form, -form))


_E = sp.Symbol("_base_of_the_exponential")
