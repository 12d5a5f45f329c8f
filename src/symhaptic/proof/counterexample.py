"""A counterexample: a point at which something else holds than what a statement says."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import InitVar, dataclass
from typing import TypeAlias

import sympy as sp
from sympy import Expr
from sympy.core.function import AppliedUndef

from symhaptic.proof.checks import Check
from symhaptic.proof.decide import compare
from symhaptic.proof.points import Point
from symhaptic.proof.refute import differs
from symhaptic.proof.seal import Sealed
from symhaptic.proof.shape import Form, parts
from symhaptic.proof.sign import Fact
from symhaptic.proof.values import Value, value_at
from symhaptic.proof.verdict import Unfounded


@dataclass(frozen=True)
class Witness(Sealed):
    """Something that a statement in words excludes was proved to happen at a point."""

    at: Mapping[Expr, Expr]
    method: str
    check: Check | None = None
    key: InitVar[object] = None


Truth: TypeAlias = Form | Fact | tuple[Expr, Fact] | Witness | None
"""What holds at a counterexample: a form to evaluate there, a fact (true), a relation with the
fact that contradicts it (false), or a witness (false)."""


def truth_at(truth: Truth, point: Point) -> Value:
    """The value of the truth at the point, or whether it holds there; None where undefined."""
    if isinstance(truth, Fact):
        _check_proved(truth)
        return True
    if isinstance(truth, Witness):
        if any(point.get(s) != v for s, v in truth.at.items()):
            raise Unfounded("the witness stands at another point")
        return False
    if isinstance(truth, tuple) and isinstance(truth[-1], Fact):
        relation, fact = truth
        _check_proved(fact)
        if not compare(relation, -fact.expr > 0).equal:
            raise Unfounded("the fact does not contradict the relation")
        return False
    return _value(parts(truth), point)


def check_opposed(printed: tuple[Expr, ...], theirs: Value, point: Point) -> None:
    """The printed form has another value at the point than the truth; words are false there."""
    if not printed:
        if theirs is not False:
            raise Unfounded("what the statement says holds at its counterexample")
        return
    ours = _value(printed, point)
    if isinstance(ours, Expr) and isinstance(theirs, Expr):
        if not differs(ours, theirs, {}):
            raise Unfounded("nothing differs at the counterexample")
    elif ours is theirs:
        raise Unfounded(f"at the counterexample both are {ours}")
    elif (
        ours is not None
        and theirs is not None
        and not (isinstance(ours, bool) and isinstance(theirs, bool))
    ):
        raise Unfounded("at the counterexample a value stands against a truth")


def _check_proved(fact: Fact) -> None:
    if fact.expr in {expr for expr, _ in fact.rests}:
        raise Unfounded("an assumption is not a fact")


def _value(forms: tuple[Expr, ...], point: Point) -> Value:
    """Value of one expression, or whether all relations hold; None where undefined.

    Equations whose left side has no value at the point are left aside: they define it.
    """
    values: list[Value] = []
    for form in forms:
        unknown = isinstance(form, sp.Eq) and (
            form.lhs.free_symbols - set(point) or isinstance(form.lhs, AppliedUndef)
        )
        if unknown:
            values.append(value_at(form.rhs, point))
        else:
            values.append(value_at(form, point))
    if any(v is None for v in values):
        return None
    truths = [v for v in values if isinstance(v, bool)]
    if truths:
        return all(truths)
    return values[0] if len(values) == 1 else None
