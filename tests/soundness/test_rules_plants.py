"""A box of plants: what a certificate about their numbers gives, and what it must not give."""

from dataclasses import replace

import pytest
from sympy import Rational, Symbol, exp

from symhaptic.notation import a, alpha, delta, e, gamma, n_0, n_1
from symhaptic.notation.proposition import Predicate, Relation
from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.proof.plants import BALLS, NUMBERS, SLOPES, Named, named
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.theorems.leaves import on_plants

RANGES = {gamma: (0, Rational(1, 1000)), delta: (0, Rational(1, 10))}
SOFT = (2 * n_0 - n_1).subs(BALLS)


def certificate(expr=SOFT, ranges=RANGES, meanings=None):
    found = box.positive(expr, ranges, named(meanings or {s: s for s in NUMBERS}))
    [certificate] = found.certificates
    return certificate


def test_numbers_of_a_plant_on_a_box():
    found = on_plants(certificate())
    assert found.conclusion == Relation(0, "<", 3 * n_0 - (n_1 + n_0))
    assert Predicate("device", (), (gamma, delta, n_1, n_0, a, e)) in found.hypotheses
    assert Relation(delta, "<=", Rational(1, 10)) in found.hypotheses


def test_what_is_not_so_on_the_whole_box_is_refused():
    # 2 n_0 > 1.0005 n_1 fails for delta = 1/10: n_0 = n_1 (1 - delta/3 + ...) of a free mass
    wide = replace(certificate(), expr=(Rational(105, 100) * n_0 - n_1).subs(BALLS))
    with pytest.raises(NotShown):
        on_plants(wide)
    with pytest.raises(NotShown):
        on_plants(replace(certificate(), box=RANGES | {delta: (0, 100)}))


def test_the_box_tells_which_plants():
    without = replace(certificate(), box={gamma: RANGES[gamma]})
    with pytest.raises(NotShown):
        on_plants(without)


@pytest.mark.parametrize("symbol", [n_1, e, a, n_0])
def test_a_number_of_the_plant_is_no_side_of_the_box(symbol):
    wide = RANGES | {symbol: (0, 1)}
    with pytest.raises(NotShown):
        on_plants(replace(certificate(), box=wide, cuts=certificate().cuts))


def test_balls_of_other_things_are_refused():
    made_up = Known({s: 1 + 0 * s for s in NUMBERS})
    for given in (made_up, None, object()):
        with pytest.raises(NotShown):
            on_plants(replace(certificate(), given=given))


def test_balls_that_were_put_in_are_not_believed():
    false = replace(certificate(), expr=(n_0 - n_1).subs(BALLS))
    patched = Named({s: s for s in NUMBERS})
    patched._known[()] = {}
    with pytest.raises(NotShown):
        on_plants(replace(false, given=patched))


def test_a_subclass_of_the_plants_is_refused():
    class Others(Named):
        def numbers(self, at):
            return dict.fromkeys(NUMBERS, at[delta] * 0 + 1)

    with pytest.raises(NotShown):
        on_plants(replace(certificate(), given=Others({s: s for s in NUMBERS})))


def test_slopes_of_the_numbers_have_no_name_in_a_proposition():
    slope = certificate(SLOPES[0] + 1, meanings={s: s for s in (*NUMBERS, *SLOPES)})
    with pytest.raises(NotShown):
        on_plants(slope)


def test_meanings_are_put_in():
    x = Symbol("x")
    found = on_plants(certificate(x + 2 * alpha, RANGES | {alpha: (1, 2)}, {x: NUMBERS[0]}))
    assert found.conclusion == Relation(0, "<", 1 - e + 2 * alpha)
    assert not found.conclusion.free & {x}
    # e = exp(-delta) is below 1 + alpha wherever delta is not negative
    assert float((1 - exp(-delta) + 2 * alpha).subs({delta: 0, alpha: 1})) > 0
