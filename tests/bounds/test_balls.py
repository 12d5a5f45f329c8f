"""Zeros of functions in balls: none is missed, and a ball without one is recognised."""

from fractions import Fraction

import pytest
from flint import arb, ctx

from symhaptic.balls.zeros import narrowed
from symhaptic.bounds.balls import TooMany, exact, pieces, sinc


def wave(x):
    return (3 * x).sin()


def test_all_zeros_of_a_wave_lie_in_pieces_that_are_short_and_in_order():
    found = pieces(4.0, lambda x: wave(x).contains(0))
    assert len(found) == 4  # 0, pi/3, 2 pi/3, pi
    for k, piece in enumerate(found):
        assert piece.contains(arb.pi() * k / 3)
        assert piece.rad() < 2**-5
    assert pieces(1.0, lambda x: (wave(x) - 2).contains(0)) == []


def test_what_is_never_decided_is_given_up():
    with pytest.raises(TooMany):
        pieces(1e3, lambda x: True)


def test_newtons_steps_narrow_a_ball_to_its_zero():
    with ctx.workprec(200):
        zero = narrowed(wave, lambda x: 3 * (3 * x).cos(), arb(1).union(arb(1.1)))
        assert zero.contains(arb.pi() / 3)
        assert zero.rad() < 1e-50
    assert narrowed(wave, lambda x: 3 * (3 * x).cos(), arb(0.9).union(arb(1.0))) is None
    wide = arb(0).union(arb(4))
    assert narrowed(wave, lambda x: 3 * (3 * x).cos(), wide) is wide  # its slope has no sign


def test_a_zero_at_0_is_not_narrowed_for_ever():
    """A float has ever smaller numbers around 0, and so have balls."""
    zero = narrowed(lambda x: x * x * x + x, lambda x: 3 * x * x + 1, arb(0, 0.1))
    assert zero.contains(0)
    assert zero.rad() < 1e-10


@pytest.mark.parametrize(("low", "high"), [(0, 1), (1, 3), (2, 4), (3, 7)])
def test_sinc_between_two_angles_contains_each_value(low, high):
    between = sinc(arb(low), arb(high))
    for k in range(21):
        x = exact(Fraction(low) + Fraction(high - low) * k / 20)
        assert between.contains(x.sinc())
    if high <= 3:
        assert between.rad() < 0.51 * (arb(low).sinc() - arb(high).sinc())
