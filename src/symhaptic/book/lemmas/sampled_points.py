"""Devices in numbers: their answers to a held force, and points at which claims fail or hold."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.sampled import PARTS, motion
from symhaptic.proof.theorems.familiar import amplified
from symhaptic.proof.theorems.samples import held_answer

SWINGING = {m: 1, b: 0, k: pi**2, T: 1, K: 1, B: 0, d: 1, z: 4}
"""Half a swing per period, without a damper."""
FREE = SWINGING | {k: 0, z: 2}
"""A free mass."""
UNHELD = SWINGING | {b: 1, k: 0, z: 2}
"""A device that nobody holds: no spring."""
CRITICAL = SWINGING | {b: 2, k: 1, z: 2}
"""Critical damping."""


def answered(values: Mapping[Symbol, Expr], late: bool = False) -> tuple[Expr, Theorem]:
    """The answer of a device in numbers, with a period of 1, and that it is the answer."""
    device = tuple(sp.sympify(values[p]) for p in PARTS)
    delay = sp.sympify(values[d]) if late else S.Zero
    parts = sp.floor(delay), delay - sp.floor(delay)
    at = values[z]
    law = held_answer(device, parts, s, at, X, motion(device), t)
    _, wanted = law.conclusion.of  # type: ignore[attr-defined]
    _, apart, equation = wanted.of
    value = sp.factor(equation.right / apart.left)
    law = held_answer(device, parts, s, at, value, motion(device), t)
    claims = law.conclusion.of[1].of  # type: ignore[attr-defined]
    shown = conj(*(fact(claim) for claim in claims))
    steps = [fact(h) for h in law.hypotheses]
    return value, closed(mp(law, shown), *steps)


def completed(
    claim: Proposition, point: Mapping[Symbol, Any]
) -> tuple[dict[Symbol, Expr], list[Theorem]]:
    """A point with what a claim defines and with the answers of its device."""
    symbols, given, _ = taken_apart(claim)
    values = {p: sp.sympify(v) for p, v in point.items() if p in symbols}
    values[T] = S.One
    answers: list[Theorem] = []
    for claimed in given:
        if isinstance(claimed, Relation) and claimed.sign == "=" and claimed.left.is_Symbol:
            values[claimed.left] = claimed.right.xreplace(values)
        if isinstance(claimed, Predicate) and claimed.name == "answers":
            before = claimed.of[0] * (m * s**2 + b * s + k)
            late = s in before.free_symbols  # exp(-d T s)
            known = {p: point[p] for p in (*PARTS, z)}
            known[d] = -(before.exp / s).xreplace(values) if late else S.Zero
            value, shown = answered(known, late=late)
            if before != 1 and s not in before.free_symbols:  # a gain
                device, gain = [values[p] for p in PARTS], before.xreplace(values)
                more = amplified(device, 0, values[z], value, S.One, gain)
                more = closed(more, *(fact(h) for h in more.hypotheses))
                value, shown = gain * value, mp(more, shown)
            values[claimed.of[2]] = value
            answers.append(shown)
    return values, answers


def fails(
    claim: Proposition, point: Mapping[Symbol, Any], but: Any = None, holds: Sequence[Any] = ()
) -> Case:
    """A point at which a claim about a device fails, and one condition of several."""
    values, answers = completed(claim, point)
    then = taken_apart(claim)[2].at(values)
    if isinstance(then, Relation):  # otherwise a side has no value there
        answers.append(fact(negated(then)))
    return counterexample(claim, values, *answers, holds=holds, but=but)


def shown_at(claim: Proposition, point: Mapping[Symbol, Any], *conditions: Any) -> Case:
    """A point at which the hypotheses of a claim about a device hold, and conditions."""
    values, answers = completed(claim, point)
    given = taken_apart(claim)[1]
    return example(values, [*given, *conditions], *answers)
