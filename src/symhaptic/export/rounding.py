"""What rounding costs, as goals for Gappa: of results that sums, products and quotients lead to.

A goal is made of the very lines that the C source has, read as C reads them: operators of one rank
from the left.  Each operation is rounded once, u = 2^-53 of its result at most; how that adds up is
counted here, and proved by Gappa, whose proof Coq checks.  What a function of a library or another
routine gives is taken as it is: the bound is of what is done with it.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from fractions import Fraction

import sympy as sp

from symhaptic.export.branches import Assign, Block, Choice, Return, guarded
from symhaptic.export.language import Target
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, Several

MARK = "# Written by `symhaptic export`; do not edit."

AND = " /\\ "


@dataclass(frozen=True)
class Goal:
    """A bound of the rounding errors of one result."""

    name: str
    result: str
    given: tuple[str, ...]
    """Functions whose values are taken as they are."""
    bound: Fraction
    """In units in the last place: of the result, or of the largest term of a sum."""
    text: str
    """For Gappa."""
    whole: bool = False
    """Whether it is of integer delays only."""

    def at(self, bound: Fraction) -> str:
        """The same goal with another bound."""
        return self.text.replace(_dyadic(self.bound, self.bits), _dyadic(bound, self.bits))

    @property
    def file(self) -> str:
        """Where an export has it."""
        return f"rounding/{self.name}.gappa"

    @property
    def bits(self) -> int:
        """Of a float."""
        return next(bits for bits, (name, _, _) in FORMATS.items() if name in self.text)


def goals(routine: Routine, target: Target) -> list[Goal]:
    """What Gappa proves of a public routine: of each result that is rounded on a straight way.

    Of one that chooses between integer delays and others, it is the result of a integer delay.
    """
    found: list[Goal] = []
    if not target.proves:
        return found
    try:
        steps, leaves, results, whole = _straight(guarded(routine), routine, target)
    except NotStraight:
        return found
    for (name, _), expr in zip(routine.results, results, strict=True):
        script = Script(target, steps, leaves)
        try:
            goal = _goal(script, f"{routine.name}_{name}", name, expr)
        except NotStraight:
            continue
        found += [replace(goal, whole=whole)] if goal else []
    return found


def _straight(
    block: Block, routine: Routine, target: Target
) -> tuple[dict[str, sp.Expr], dict[str, str], tuple[sp.Basic, ...], bool]:
    """The steps of the one way that is taken inside the domain, by name; what is given; the end.

    Last stands whether it is the way of integer delays.
    """
    steps: dict[str, sp.Expr] = {}
    meant: dict[sp.Basic, sp.Expr] = {}
    whole = False
    leaves = {target.rename(s.name): "" for s in routine.arguments}
    while True:
        for statement in block:
            if isinstance(statement, Assign):
                steps[target.rename(statement.name.name)] = statement.expr
                meant[statement.name] = statement.expr.xreplace(meant)
            elif isinstance(statement, Several):
                for symbol in statement.names:
                    name = target.rename(symbol.name)
                    leaves[name] = name.removesuffix("_of")
            elif isinstance(statement, Return):
                return steps, leaves, statement.results, whole
            elif isinstance(statement, Choice):
                fraction = _is_fraction(statement.condition, meant)
                block = statement.yes if fraction else _inside(statement, routine)
                whole = whole or fraction
            else:
                raise NotStraight(type(statement).__name__)


def _inside(choice: Choice, routine: Routine) -> Block:
    outside = (Return((routine.outside,) * len(routine.results)),)
    if choice.yes == outside:
        return choice.no
    raise NotStraight(str(choice.condition))


def _is_fraction(asked: sp.Basic, meant: dict[sp.Basic, sp.Expr]) -> bool:
    """Whether it is asked if a delay has no fraction of a period, x - floor(x) = 0."""
    if not isinstance(asked, sp.Eq) or asked.rhs != 0:
        return False
    part = asked.lhs.xreplace(meant)
    return any(part == of.args[0] - of for of in part.atoms(sp.floor))


def _goal(script: Script, name: str, result: str, expr: sp.Basic) -> Goal | None:
    """The goal of one result; none where nothing is rounded."""
    node = script.read(expr)
    while isinstance(node, ast.Name) and node.id in script.steps:
        node = script.read(script.steps[node.id])
    try:
        value = script.value(node)
        said, error = f"{value.float_} -/ {value.exact}", value.error
    except NotStraight:
        script = Script(script.target, script.steps, script.leaves)
        said, error = script.sum(node)
    if not error:
        return None
    bits = script.target.precision.bits
    bound = Fraction(math.ceil(100 * error / script.unit), 100)
    limit = _dyadic(bound, bits)
    said += f" in [-{limit},{limit}]" if "-/" in said else f" <= {limit}"
    given = AND.join(script.ranges)
    lines = [
        MARK,
        f"# {name}, rounded as in C, against what it is exactly: for floats of {bits} bits",
        f"@rnd = float<{FORMATS[bits][0]}, ne>;",
        *script.rounded,
        *script.exact,
        f"{{ {given} -> {said} }}",
        *script.hints,
    ]
    taken = tuple(dict.fromkeys(of for of in script.used.values() if of))
    return Goal(name, result, taken, bound, "\n".join(lines) + "\n")


def _dyadic(bound: Fraction, bits: int) -> str:
    """So many units, rounded down, as Gappa writes numbers."""
    return f"{math.floor(bound * 1024)}b-{bits + 10}"


def told(found: list[Goal], precision: Precision) -> list[str]:
    """What a README says of what is proved."""
    if not found:
        return []
    _, low, high = FORMATS[precision.bits]
    lines = [
        "",
        "Bounds on the rounding errors of sums, products and quotients, proved by Gappa and Coq,",
    ]
    lines += ["in units in the last place of the largest term:", ""]
    for goal in found:
        values = f"value{'s' * (len(goal.given) > 1)} of {', '.join(goal.given)}"
        given = f", with the {values} taken as given" if goal.given else ""
        given += ", for integer delays" if goal.whole else ""
        lines.append(f"- {goal.result}: at most {float(goal.bound):g}{given} ({goal.file})")
    return [
        *lines,
        "",
        f"These bounds hold if each intermediate result has a size from 2^{low} to 2^{high}, and",
        "if the compiler does not contract to fma. All other errors are measured.",
    ]


__all__ = ["Goal", "goals", "told"]


# -- One result of C's arithmetic for Gappa: definitions, ranges and hints, while collected ------


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

    target: Target
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
