"""One result of C's arithmetic for Gappa: definitions, ranges and hints, while collected."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction

import sympy as sp

from symhaptic.export.printing import Language

FORMATS = {53: ("ieee_64", -1021, 1023), 24: ("ieee_32", -125, 127)}
"""By the binary digits of a float: Gappa's name, and the powers of two between which no result on
the way is rounded to fewer digits, or overflows."""

MOST = 3
"""Terms of a sum up to which its rounding is bounded."""


class NotStraight(ValueError):
    """A result that branches, repetitions or numbers that are no floats lead to."""


@dataclass(frozen=True)
class _Value:
    """A value as a float and exactly, by name, and by how much of itself it may be off."""

    float_: str
    exact: str
    error: Fraction = Fraction(0)
    power: bool = False
    """Whether it is a power of two, whose products are not rounded."""
    slack: Fraction = Fraction(0)
    """What Gappa takes it to be off by in a sum, as it does not see there that it is not."""

    @property
    def loose(self) -> Fraction:
        """By how much a term of a sum may be off."""
        return max(self.error, self.slack)


@dataclass
class Script:
    """Definitions, hypotheses and hints while they are collected."""

    target: Language
    steps: dict[str, sp.Expr]
    leaves: dict[str, str]
    """Names that are given, each with the function that gives it, or none."""
    rounded: list[str] = field(default_factory=list)
    exact: list[str] = field(default_factory=list)
    ranges: list[str] = field(default_factory=list)
    hints: list[str] = field(default_factory=list)
    known: dict[str, _Value] = field(default_factory=dict)
    used: dict[str, str] = field(default_factory=dict)
    numbers: set[Fraction] = field(default_factory=lambda: {Fraction(1)})
    """Those that are meant as they stand; that of pi is not."""

    @property
    def unit(self) -> Fraction:
        """By how much of itself a result may be off that is rounded once."""
        return Fraction(1, 2**self.target.precision.bits)

    def read(self, expr: sp.Expr) -> ast.expr:
        """An expression as C reads it: Python ranks these operators alike."""
        self.numbers |= {Fraction(abs(n.p), n.q) for n in expr.atoms(sp.Rational)}
        text = re.sub(r"(?<=[\d.])f\b", "", self.target.printing().doprint(expr))
        try:
            return ast.parse(text, mode="eval").body
        except SyntaxError:
            raise NotStraight(text) from None

    def value(self, node: ast.expr) -> _Value:
        """What a part of an expression is, with all that leads to it defined."""
        key = ast.unparse(node)
        if key not in self.known:
            self.known[key] = self._value(node)
        return self.known[key]

    def _value(self, node: ast.expr) -> _Value:
        if isinstance(node, ast.Name) and node.id in self.steps:
            return self.value(self.read(self.steps[node.id]))
        if isinstance(node, ast.Name) and node.id in self.leaves:
            return self._leaf(node.id, self.leaves[node.id])
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            name = node.func.id
            return self._leaf(f"{name}_{sum(f == name for f in self.used.values()) + 1}", name)
        if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
            return self._number(node.value)
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            of = self.value(node.operand)
            return replace(of, float_=f"(-{of.float_})", exact=f"(-{of.exact})", power=False)
        if isinstance(node, ast.BinOp) and type(node.op) in _SIGNS:
            left, right = self.value(node.left), self.value(node.right)
            return self._rounded(_SIGNS[type(node.op)], left, right)
        raise NotStraight(ast.unparse(node))

    def _leaf(self, name: str, of: str) -> _Value:
        self.used[name] = of
        self.rounded.append(f"{name} = rnd({name}_);")
        return _Value(name, name)

    def _number(self, number: float) -> _Value:
        if Fraction(number) not in self.numbers:
            raise NotStraight(f"{number} stands for another number")
        top, bottom = float(number).as_integer_ratio()
        text = f"{top}b{1 - bottom.bit_length()}"
        return _Value(text, text, power=top & (top - 1) == 0 and top > 0)

    def _rounded(self, sign: str, left: _Value, right: _Value) -> _Value:
        a, b, u = left.error, right.error, self.unit
        if sign in "+-" and (left.loose or right.loose):
            raise NotStraight("a sum of rounded terms inside of a product")
        if sign == "/":
            error = (1 + a) / (1 - b) * (1 + u) - 1
        else:
            doubled = sign == "*" and (left.power or right.power)
            error = (1 + a) * (1 + b) * (1 if doubled else 1 + u) - 1
            if doubled:
                return replace(self._named(sign, left, right, error), slack=error + u)
        return self._named(sign, left, right, error)

    def _named(self, sign: str, left: _Value, right: _Value, error: Fraction) -> _Value:
        number = len(self.exact) + 1
        self.rounded.append(f"s{number} = {left.float_} {sign} {right.float_};")
        self.rounded.append(f"v{number} = rnd(s{number});")
        self.exact.append(f"V{number} = {left.exact} {sign} {right.exact};")
        _, low, high = FORMATS[self.target.precision.bits]
        self.ranges.append(f"|s{number}| in [1b{low},1b{high}]")
        return _Value(f"v{number}", f"V{number}", error)

    def sum(self, node: ast.expr) -> tuple[str, Fraction]:
        """A sum of rounded terms: what is to be bounded, in parts of the largest term M."""
        terms = list(self._terms(node))
        if len(terms) > MOST:
            raise NotStraight("a long sum, of which Gappa finds no proof in time")
        values = [self.value(term) for _, term in terms]
        total = values[0] if terms[0][0] == "+" else None
        if total is None:
            raise NotStraight("a sum that begins with a difference")
        _, low, high = FORMATS[self.target.precision.bits]
        self.ranges.append(f"M in [1b{low},1b{high}]")
        self.ranges += [f"|{v.exact} / M| <= 1" for v in values]
        error = total.loose
        self._share(total)
        for count, ((sign, _), term) in enumerate(zip(terms[1:], values[1:], strict=True), 2):
            self._share(term)
            before, off = total, error + term.loose
            error = off + self.unit * (count + off)
            total = self._named(sign, before, term, error)
            s = f"s{total.float_[1:]}"
            lost = [_off(before), f"{sign} {_off(term)}"]
            off_ = " ".join(
                t for t, v in zip(lost, (before, term), strict=True) if v.float_ != v.exact
            ).removeprefix("+ ")
            whole = f"{before.exact} / M {sign} {term.exact} / M"
            self.hints += [
                f"({total.float_} - {total.exact}) / M -> "
                f"(({total.float_} - {s}) / {s}) * ({s} / M){_plus(off_)} {{ M <> 0, {s} <> 0 }};",
                f"{s} / M -> {total.exact} / M{_plus(off_)} {{ M <> 0 }};",
                f"{total.exact} / M -> {whole} {{ M <> 0 }};",
            ]
        return f"|({total.float_} - {total.exact}) / M|", error

    def _share(self, term: _Value) -> None:
        if term.float_ != term.exact:
            relative = f"(({term.float_} - {term.exact}) / {term.exact})"
            self.hints.append(
                f"{_off(term)} -> {relative} * ({term.exact} / M) {{ M <> 0, {term.exact} <> 0 }};"
            )

    def _terms(self, node: ast.expr) -> Iterable[tuple[str, ast.expr]]:
        if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub)):
            yield from self._terms(node.left)
            yield _SIGNS[type(node.op)], node.right
        else:
            yield "+", node


_SIGNS: dict[type[ast.operator], str] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}


def _off(value: _Value) -> str:
    return f"({value.float_} - {value.exact}) / M"


def _plus(text: str) -> str:
    return f" {text}" if text.startswith("- ") else f" + {text}" if text else ""
