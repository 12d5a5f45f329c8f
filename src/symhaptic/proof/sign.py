r"""Signs on a whole domain, by certificates that are checked exactly.

A fact says that an expression is positive (or not negative) wherever the assumptions hold.
New facts follow in seven ways, each checked by the normal form:

* a sum of products of facts, with positive rational coefficients;
* the sine of an angle that lies between 0 and pi;
* the sine of the larger of two angles between -pi/2 and pi/2 is the larger one;
* the exponential of a real number;
* two cases, one where some expression is positive and one where it is not;
* integration: zero at the lower end of an interval, with a positive derivative on it;
* division by a fact.

Nothing here samples.  A certificate that does not add up raises :class:`NotShown`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import InitVar, dataclass, field, replace
from functools import wraps
from importlib import import_module
from typing import Any, ParamSpec

import sympy as sp
from sympy import Expr

from symhaptic.proof.ball import sign
from symhaptic.proof.certificate import Certificate
from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import conjugated
from symhaptic.proof.seal import KEY, Sealed
from symhaptic.proof.series import limit


class NotShown(ValueError):
    """A certificate that does not show what it claims."""


@dataclass(frozen=True)
class Fact(Sealed):
    """``expr > 0`` (or ``>= 0``) wherever the assumptions that it ``rests`` on hold."""

    expr: Expr
    strict: bool = True
    reason: str = "assumed"
    rests: frozenset[tuple[Expr, bool]] = frozenset()
    certificates: tuple[Certificate, ...] = field(default=(), compare=False, repr=False)
    """Of the balls that show it, where balls do."""
    made: Made | None = field(default=None, compare=False, repr=False)
    key: InitVar[object] = None

    @property
    def relation(self) -> Expr:
        """The fact as a SymPy relation."""
        kind = sp.StrictGreaterThan if self.strict else sp.GreaterThan
        return kind(self.expr, 0, evaluate=False)


@dataclass(frozen=True)
class Made:
    """The rule that a fact was made by, and from what, so that it can be made again."""

    rule: Callable[..., Fact]
    args: tuple[Any, ...]
    named: Mapping[str, Any]


def facts_below(fact: Fact) -> Iterator[Fact]:
    """A fact and all those that it was made from, but for assumptions; each once."""
    found = [fact] if fact.made else []
    for known in found:
        for part in _inside([*known.made.args, *known.made.named.values()] if known.made else []):
            if part.made and part not in found:
                found.append(part)
    yield from found


def _inside(parts: Iterable[Any]) -> Iterator[Fact]:
    for part in parts:
        if isinstance(part, Fact):
            yield part
        elif isinstance(part, Interval):
            yield from _inside(part.held)
        elif isinstance(part, (list, tuple)):
            yield from _inside(part)


_P = ParamSpec("_P")
_RULES: dict[str, Callable[..., Fact]] = {}
"""The ways to a fact, by name."""


def rule(build: Callable[_P, Fact]) -> Callable[_P, Fact]:
    """A way to a fact, which then knows how it was made."""

    @wraps(build)
    def making(*args: _P.args, **named: _P.kwargs) -> Fact:
        return replace(build(*args, **named), made=Made(making, args, named), key=KEY)

    _RULES[build.__name__] = making
    return making


@dataclass(frozen=True)
class Recipe:
    """How a fact was made, as data that another process makes it from anew."""

    rule: str
    args: tuple[Any, ...]
    named: tuple[tuple[str, Any], ...] = ()


def recipe(fact: Fact) -> Recipe:
    """How a fact was made, and what it was made from."""
    if fact.made is None:
        return Recipe("assume", (fact.expr, fact.strict))
    made = fact.made
    named = tuple((name, _as_data(value)) for name, value in made.named.items())
    return Recipe(made.rule.__name__, _as_data(made.args), named)


def _as_data(part: Any) -> Any:
    if isinstance(part, (tuple, list)):
        return tuple(map(_as_data, part))
    return recipe(part) if isinstance(part, Fact) else part


def remade(of: Recipe) -> Fact:
    """The fact of a recipe.

    Raises :class:`ValueError` where there is no such rule, or it gives none.
    """
    import_module("symhaptic.proof.box")  # which registers its rule
    if of.rule != "assume" and of.rule not in _RULES:
        raise ValueError(f"{of.rule!r} is no rule for a sign")
    make = assume if of.rule == "assume" else _RULES[of.rule]
    return make(*_as_facts(of.args), **{name: _as_facts(value) for name, value in of.named})


def _as_facts(part: Any) -> Any:
    if isinstance(part, tuple):
        return tuple(map(_as_facts, part))
    return remade(part) if isinstance(part, Recipe) else part


def assume(expr: Expr, strict: bool = True) -> Fact:
    """An assumption: part of the domain, not a claim."""
    known = sp.sympify(expr, strict=True)
    return Fact(known, strict, "assumed", frozenset([(known, strict)]), key=KEY)


@rule
def number(expr: Expr) -> Fact:
    """A positive number, shown by a ball."""
    if sign(expr) != 1:
        raise NotShown(f"{expr} is not positive")
    return Fact(sp.sympify(expr, strict=True), True, "a positive number", key=KEY)


class Interval:
    """All values of ``variable`` from ``lower`` up to where an assumption stops holding.

    ``held`` pairs each assumption in which the variable occurs with the fact that it does not
    grow with the variable, so that it holds for every smaller value too.
    """

    def __init__(self, variable: sp.Symbol, lower: Expr, *held: tuple[Fact, Fact]) -> None:
        for assumption, slope in held:
            if assumption.rests != {(assumption.expr, assumption.strict)}:
                raise NotShown(f"{assumption.expr} > 0 is not an assumption")
            if slope.expr.has(variable) or not is_zero(
                sp.diff(assumption.expr, variable) + slope.expr
            ):
                raise NotShown(f"{assumption.expr} > 0 is not known for smaller {variable}")
        self.variable, self.lower, self.held = variable, lower, held
        self.above = assume(variable - lower)
        """The assumption that the variable lies above the lower end."""
        self.holds = self.above.rests.union(*(a.rests for a, _ in held))
        self.rests = self.above.rests.union(*(slope.rests for _, slope in held))
        """What it rests on that these are all values down to the lower end."""


Product = Sequence[Fact | int | sp.Rational]


@rule
def combined(expr: Expr, *products: Product) -> Fact:
    """``expr`` is the given sum of products of facts and positive rationals.

    >>> x, y = sp.symbols("x y")
    >>> a, b = assume(x), assume(y - x)
    >>> combined(y, [a], [b]).relation
    y > 0
    """
    total, strict, rests = sp.S.Zero, False, frozenset[tuple[Expr, bool]]()
    for product in products:
        value, positive = sp.S.One, True
        for factor in product:
            if isinstance(factor, Fact):
                value *= factor.expr
                positive = positive and factor.strict
                rests |= factor.rests
            else:
                number = sp.sympify(factor, strict=True)
                if not (number.is_Rational and number > 0):
                    raise NotShown(f"{factor} is not a positive rational")
                value *= number
        total += value
        strict = strict or positive
    if not is_zero(sp.sympify(expr, strict=True) - total):
        raise NotShown(f"{expr} is not {total}")
    return Fact(
        sp.sympify(expr, strict=True), strict, "a sum of products of positive terms", rests, key=KEY
    )


@rule
def quotient(expr: Expr, numerator: Fact, denominator: Fact) -> Fact:
    """``expr`` is a fact divided by a strictly positive fact."""
    if not denominator.strict:
        raise NotShown(f"{denominator.expr} may vanish")
    if not is_zero(expr - numerator.expr / denominator.expr):
        raise NotShown(f"{expr} is not ({numerator.expr})/({denominator.expr})")
    rests = numerator.rests | denominator.rests
    return Fact(expr, numerator.strict, "a quotient of positive terms", rests, key=KEY)


@rule
def sine(angle: Fact, complement: Fact) -> Fact:
    """sin x > 0, because x > 0 and pi - x > 0."""
    if not is_zero(angle.expr + complement.expr - sp.pi):
        raise NotShown(f"{angle.expr} and {complement.expr} do not add up to pi")
    strict, rests = angle.strict and complement.strict, angle.rests | complement.rests
    return Fact(sp.sin(angle.expr), strict, "the sine of (0, pi)", rests, key=KEY)


@rule
def cosine(angle: Fact, complement: Fact) -> Fact:
    """cos x > 0, because x >= 0 and pi/2 - x > 0."""
    if not is_zero(angle.expr + complement.expr - sp.pi / 2):
        raise NotShown(f"{angle.expr} and {complement.expr} do not add up to pi/2")
    rests = angle.rests | complement.rests
    return Fact(sp.cos(angle.expr), complement.strict, "the cosine of [0, pi/2)", rests, key=KEY)


@rule
def chord(lower: Fact, upper: Fact, gap: Fact) -> Fact:
    """sin x - sin y > 0, because y + pi/2 >= 0, pi/2 - x >= 0 and x - y > 0, in this order.

    >>> x = sp.Symbol("x")
    >>> up, down = assume(x), assume(sp.pi/2 - x)
    >>> chord(number(sp.pi/2), down, up).relation
    sin(x) > 0
    """
    if not is_zero(lower.expr + upper.expr + gap.expr - sp.pi):
        raise NotShown(f"{lower.expr}, {gap.expr} and {upper.expr} do not add up to pi")
    larger, smaller = sp.pi / 2 - upper.expr, lower.expr - sp.pi / 2
    rests = lower.rests | upper.rests | gap.rests
    expr = sp.sin(larger) - sp.sin(smaller)
    return Fact(expr, gap.strict, "the sine rises", rests, key=KEY)


@rule
def exponential(exponent: Expr) -> Fact:
    """exp x > 0 for a real x."""
    if not is_zero(conjugated(exponent) - exponent):
        raise NotShown(f"{exponent} is not real")
    return Fact(sp.exp(exponent), True, "an exponential", key=KEY)


@rule
def integrated(expr: Expr, over: Interval, slope: Fact) -> Fact:
    """``expr > 0``: it tends to 0 at the interval's lower end, and its derivative is positive.

    ``slope.expr`` must be the derivative, and whatever it rests on must hold on the whole
    interval from the lower end to the point in question.

    >>> x = sp.Symbol("x")
    >>> up = Interval(x, sp.S.Zero)
    >>> integrated(x**2, up, combined(2*x, [2, up.above])).relation
    x**2 > 0
    """
    for assumption in slope.rests:
        if assumption[0].has(over.variable) and assumption not in over.holds:
            raise NotShown(f"{assumption[0]} > 0 is not known for smaller {over.variable}")
    if not is_zero(limit(expr, over.variable, over.lower)):
        raise NotShown(f"{expr} does not vanish at {over.variable} = {over.lower}")
    if not is_zero(sp.diff(expr, over.variable) - slope.expr):
        raise NotShown(f"the derivative of {expr} is not {slope.expr}")
    rests = slope.rests | over.rests
    return Fact(expr, slope.strict, "rises from zero", rests, key=KEY)


@rule
def either(first: Fact, second: Fact, split: Expr) -> Fact:
    """The same fact from two cases: ``first`` where split > 0, ``second`` where split <= 0.

    The split is real, or there would be a third.

    >>> x, y = sp.symbols("x y")
    >>> one = combined(x + y, [assume(x)], [assume(y)])
    >>> two = combined(x + y, [assume(-x, strict=False)], [2, assume(x)], [assume(y)])
    >>> either(one, two, x).rests == assume(x).rests | assume(y).rests
    True
    """
    if not is_zero(first.expr - second.expr):
        raise NotShown(f"{first.expr} and {second.expr} are two different things")
    if not is_zero(conjugated(split) - split):
        raise NotShown(f"{split} is not real")
    rests = (first.rests - {(split, True)}) | (second.rests - {(-split, False)})
    return Fact(first.expr, first.strict and second.strict, "two cases", rests, key=KEY)
