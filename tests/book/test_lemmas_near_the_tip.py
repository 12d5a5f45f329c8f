"""Bounds next to the tip of a stable region: a stiffness below it is not shown to be one."""

import numpy as np
import oracle
import pytest
import sympy as sp
from sympy import Rational, S

from symhaptic.book.lemmas.counted_delays import counted
from symhaptic.book.lemmas.faster import gained
from symhaptic.book.lemmas.figure10 import mark
from symhaptic.book.lemmas.near_tip import none_above, tip, wall_below
from symhaptic.book.lemmas.outpaced import ROOM, softer_than
from symhaptic.book.lemmas.outweighed import LATE, stable_behind_every_delay
from symhaptic.book.lemmas.weaker_damping import APART, HIGH, WALLS
from symhaptic.notation import a, alpha, beta, d, delta, e, gamma, n_0, n_1, theta
from symhaptic.notation.proposition import (
    Exists,
    ForAll,
    Or,
    Relation,
    both,
    conjuncts,
    implied,
    whole,
)
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.conclusion import LITTLE
from symhaptic.paper.propositions.plots import LEVELS, marked
from symhaptic.paper.propositions.ratio import BEST
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import NotShown

ARM = (Rational(1, 1000), Rational(1, 50))
RANGES = {gamma: (ARM[0], ARM[0]), delta: (ARM[1], ARM[1])}
RNG = np.random.default_rng(1735)


@pytest.mark.parametrize("delay", [1, 7, 40])
def test_the_bound_is_next_to_a_stable_wall(delay):
    limit, bounded = none_above(ARM, delay)
    (stiffness, damping), stable = wall_below(ARM, delay)
    assert 0 < limit - stiffness < Rational(2, 10**4) * limit
    assert bounded.conclusion.right == limit
    assert not stable.hypotheses
    assert oracle.stable(float(stiffness), float(damping), 1e-3, 0.02, delay)


def test_a_bound_below_the_tip_is_refused():
    """The attack: what is stable would be softer than itself."""
    stiffness, _, angle = tip(ARM, 7)
    softer_than(stiffness * Rational(10001, 10000), 7, angle, RANGES)
    with pytest.raises((NotShown, ValueError)):
        softer_than(stiffness * Rational(9999, 10000), 7, angle, RANGES)
    with pytest.raises((NotShown, ValueError)):
        softer_than(stiffness * Rational(10001, 10000), 6, angle, RANGES)


def test_a_wall_beyond_the_tip_is_refused():
    with pytest.raises(NotShown):
        wall_below(ARM, 7, share=-Rational(1, 10**4))


def test_the_room_is_that_of_the_characteristic_polynomial():
    """2 Re conj(p) z p' - n |p|^2, with p from its coefficients."""
    for delay in (0, 3):
        wall, angle = RNG.uniform(0, 1, 2), RNG.uniform(0, 3)
        numbers = dict(zip((n_1, n_0, a, e), oracle.numbers(1e-3, 0.02), strict=True))
        values = {**numbers, alpha: wall[0], beta: wall[1], d: delay, theta: angle}
        first, second, third, loss = map(float, numbers.values())
        falling = np.zeros(delay + 4)
        falling[:3] += 1, -third, loss
        falling[-3:] += np.polymul([first, second], [wall.sum(), -wall[1]])
        p, turn = np.poly1d(falling), np.exp(1j * angle)
        room = 2 * np.conj(p(turn)) * turn * p.deriv()(turn)
        room = room.real - (delay + 3) * abs(p(turn)) ** 2
        assert float(sp.N(ROOM.subs(values))) == pytest.approx(room)


def test_a_whole_delay_is_counted():
    found = counted(3)
    assert found.hypotheses == {whole(d)}
    assert isinstance(found.conclusion, Or)
    assert len(found.conclusion.of) == 4


def test_one_wall_for_every_delay():
    found = stable_behind_every_delay()
    assert found.hypotheses == {whole(d)}
    assert found.conclusion.of == (LATE, S.Zero, *ARM, d)


def test_two_dampings_are_two_percent_apart():
    """The attack: the same linear functions say nothing of dampings that are nearer."""
    low, high = WALLS[0][0], HIGH[0]
    near = {delta: Rational(1, 50)}
    assert (low - high).subs(near) < 0
    for delay in (0, 1):
        low, high = WALLS[delay][0], HIGH[delay]
        for damper in (Rational(1, 1000), Rational(1, 60)):
            above = high.subs(delta, APART * damper)
            assert low.subs(delta, damper) * APART > above


def test_faster_sampling_gains_more_than_a_twentieth(monkeypatch):
    """The attack: with a smaller share the same bounds do not say it."""
    then = taken_apart(CLAIMED["s6-faster-sampling"](()))[2]
    passive, stable = then.of
    less = stable.body.of[1].body.of[1]
    assert less.right == LITTLE * BEST[0]
    tight = Relation(less.left, "<=", Rational(105, 100) * BEST[0])
    [others] = (p for p in conjuncts(stable.body) if isinstance(p, ForAll))
    body = ForAll(others.over, implied([others.body.of[0]], tight))
    wrong = both([passive, Exists(BEST, both([stable.body.of[0], body]))])
    gained()
    monkeypatch.setitem(CLAIMED, "s6-faster-sampling", lambda printed: wrong)
    gained.cache_clear()
    with pytest.raises((NotShown, ValueError)):
        gained()


def test_a_mark_of_another_error_is_refused():
    """The attack: a wall with the error 2 % is no mark of 2.1 %."""
    level = LEVELS[1]
    plant = {gamma: ARM[0], delta: ARM[1], d: S.One}
    assert not mark(marked(level).at(plant), ARM[1], 1, level).hypotheses
    with pytest.raises((NotShown, ValueError)):
        mark(marked(level + Rational(1, 1000)).at(plant), ARM[1], 1, level)
