"""A certificate that was found is confirmed; one that says something false never is."""

import pickle
from dataclasses import replace

import pytest
import sympy as sp
from flint import arb, ctx
from sympy import Rational, S

from symhaptic.notation import delta, gamma
from symhaptic.proof import box
from symhaptic.proof.plants import LOSS, TOGETHER, named
from symhaptic.proof.program import Uncheckable, program
from symhaptic.proof.recheck import recheck
from symhaptic.proof.roots import zero

x, y, h = sp.symbols("x y h")


def certificate(expr, where, given=None):
    return box.positive(expr, where, given)


COSINE = certificate(sp.cos(x) - 1 + x**2 / 2, {x: (Rational(1, 10), 3)})  # a textbook inequality
RIDGE = certificate(Rational(26, 100) - x * y * (1 - x * y), {x: (0, 1), y: (0, 1)})
PLANT = certificate(
    h - gamma * TOGETHER,
    {gamma: (0, 1), delta: (0, Rational(1, 2))},
    named({h: 2 - LOSS, TOGETHER: TOGETHER}),
)
FOUND = [COSINE, RIDGE, PLANT]
NAMES = ["cosine", "ridge", "plant"]


@pytest.mark.parametrize("found", FOUND, ids=NAMES)
def test_a_certificate_is_confirmed(found):
    assert recheck(found)


@pytest.mark.parametrize("found", FOUND, ids=NAMES)
def test_a_certificate_survives_storage(found):
    assert recheck(pickle.loads(pickle.dumps(found)))


def test_slopes_are_used_and_confirmed():
    assert ":" in RIDGE.cuts
    assert not recheck(replace(RIDGE, expr=Rational(249, 1000) - x * y * (1 - x * y)))


@pytest.mark.parametrize(
    "wrong",
    [
        replace(COSINE, expr=-COSINE.expr),
        replace(COSINE, expr=COSINE.expr - Rational(1, 10**5)),  # 4e-6 at 1/10
        replace(COSINE, box={x: (0, 3)}),  # zero at 0
        replace(COSINE, box={x: (Rational(1, 10), 300)}),  # the pieces are too wide
        replace(COSINE, cuts="."),  # one ball does not decide it
        replace(COSINE, cuts=COSINE.cuts[:-1]),  # a piece is missing
        replace(COSINE, cuts=COSINE.cuts + "."),  # one too many
        replace(PLANT, expr=PLANT.expr - 2),
        replace(PLANT, box={gamma: (0, 8), delta: (0, Rational(1, 2))}),
    ],
)
def test_mutants_are_not_confirmed(wrong):
    assert not recheck(wrong)


def test_zero_of_the_cosine():
    found = zero(sp.cos(x), x, S.One, S(2))
    assert recheck(found)
    assert found.ball.overlaps(arb.pi() / 2)
    with ctx.workprec(256):
        assert not recheck(replace(found, ball=found.ball + arb("1e-20")))
    assert not recheck(replace(found, between=(Rational(8, 5), S(2))))
    assert not recheck(replace(found, expr=sp.cos(x) ** 2))  # touches, and its slope vanishes
    assert not recheck(replace(found, between=(S.One, S(5))))  # two zeros: the slope changes sign


def test_maximum_of_a_parabola():
    found = box.maximum(x * (1 - x), {x: (0, 1)}, Rational(1, 1000))
    assert recheck(found)
    assert found.lower <= Rational(1, 4) <= found.upper  # at 1/2
    assert found.upper - found.lower <= Rational(1, 1000)
    assert not recheck(replace(found, upper=Rational(249, 1000)))
    assert not recheck(replace(found, lower=Rational(251, 1000)))
    assert not recheck(replace(found, where={x: S(0)}))
    assert not recheck(replace(found, where={x: Rational(3, 2)}))  # outside
    assert not recheck(replace(found, expr=x * (1 - x) + 1))


def test_maximum_on_a_ridge():
    """x y (1 - x y) is 1/4 wherever x y = 1/2."""
    found = box.maximum(x * y * (1 - x * y), {x: (0, 1), y: (0, 1)}, Rational(1, 100))
    assert recheck(found)
    assert found.lower <= Rational(1, 4) <= found.upper


def test_what_has_no_program_is_refused():
    with pytest.raises(Uncheckable, match="gamma"):
        program(sp.gamma(x), [x])
