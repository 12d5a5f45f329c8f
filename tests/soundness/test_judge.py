"""A verdict is refused where the theorem is open, vacuous, of another claim, or says nothing."""

from __future__ import annotations

import pytest
from sympy import S, symbols

from symhaptic.notation.proposition import ForAll, implied, proposition
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.theorems.kernel import assume
from symhaptic.proof.theorems.tactics import counterexample, example, for_all, positive
from symhaptic.proof.verdict import Kind, Unfounded

x, y = symbols("x y")
CLAIM = ForAll((x, y), implied([x > 0], x * y > 0))
PRODUCT = for_all((x, y), [x > 0, y > 0], positive(x * y > 0, [x > 0, y > 0]))
EXAMPLE = example({x: S.One, y: S.One}, [x > 0, y > 0])
UNLESS = (counterexample(CLAIM, {x: S.One, y: S.Zero}, but=y > 0),)


def test_a_condition_with_its_points_qualifies() -> None:
    verdict = Judged(PRODUCT, EXAMPLE, UNLESS).decide(CLAIM)
    assert (verdict.kind, verdict.condition) == (Kind.QUALIFIED, "y>0")


def test_a_condition_is_not_what_is_claimed() -> None:
    itself = for_all((x, y), [x > 0, x * y > 0], positive(x * y > 0, x * y > 0))
    judged = Judged(itself, example({x: S.One, y: S.One}, [x > 0, x * y > 0]), UNLESS)
    with pytest.raises(Unfounded, match="what is claimed"):
        judged.decide(CLAIM)


@pytest.mark.parametrize(
    "wrong",
    [
        Judged(PRODUCT, None, UNLESS),
        Judged(PRODUCT, EXAMPLE, ()),
        Judged(PRODUCT, example({x: S.One, y: S(2)}, [x > 0]), UNLESS),
        Judged(positive(x * y > 0, [x > 0, y > 0]), EXAMPLE, UNLESS),
        Judged(assume(CLAIM), EXAMPLE),
    ],
)
def test_grounds_that_are_not_enough(wrong: Judged) -> None:
    with pytest.raises(Unfounded):
        wrong.decide(CLAIM)


def test_a_theorem_of_another_claim() -> None:
    for other in (
        ForAll((x, y), implied([x >= 0], x * y > 0)),
        ForAll((x, y), implied([x > 0], x * y >= 0)),
        ForAll((x,), ForAll((y,), implied([x > 0], x * y > 0))),
        proposition(x * y > 0),
    ):
        with pytest.raises(Unfounded):
            Judged(PRODUCT, EXAMPLE, UNLESS).decide(other)


def test_both_are_told_where_a_theorem_says_something_else() -> None:
    claim = proposition(y > 0)
    with pytest.raises(Unfounded) as wrong:
        Judged(PRODUCT, EXAMPLE, UNLESS).decide(claim)
    assert str(wrong.value).startswith(r"the theorem says \forall\,x,y")
    assert str(wrong.value).endswith("the statement y>0")


def test_what_is_proved_has_no_counterexample() -> None:
    square = for_all((x,), [x > 0], positive(x**2 > 0, [x > 0, x > 0]))
    claim, at = ForAll((x,), implied([x > 0], x**2 > 0)), example({x: S.One}, [x > 0])
    assert Judged(square, at).decide(claim).kind is Kind.PROVED
    with pytest.raises(Unfounded):
        Judged(square, at, UNLESS).decide(claim)
    with pytest.raises(Unfounded):
        Judged(square).decide(claim)
