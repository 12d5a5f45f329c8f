"""A box of plants: what a certificate about their numbers gives, and what it must not give."""

from dataclasses import replace

import oracle
import pytest
from sympy import Rational, Symbol, exp, expand, symbols

from symhaptic.notation import a, alpha, delta, e, gamma, n_0, n_1
from symhaptic.notation.proposition import Predicate, Relation
from symhaptic.proof import box
from symhaptic.proof.certificate import Known
from symhaptic.proof.plants import BALLS, NUMBERS, SLOPES, Named, named
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.theorems.leaves import more_damped, on_plants

RANGES = {gamma: (0, Rational(1, 1000)), delta: (0, Rational(1, 10))}
SOFT = (2 * n_0 - n_1).subs(BALLS)


def certificate(expr=SOFT, ranges=RANGES, meanings=None):
    return box.positive(expr, ranges, named(meanings or {s: s for s in NUMBERS}))


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


# -- two dampers beside one spring -----------------------------------------------------------

LARGER, OTHERS = Symbol("delta'"), symbols("p_1 p_0 b_2 e_2")
EVERY = {s: s for s in (*NUMBERS, *SLOPES)}


def slope_of(expr):
    """The derivative with respect to delta, by the names of the certificates."""
    by_balls = expr.subs(BALLS)
    inner = (by_balls.diff(x) * dx for x, dx in zip(NUMBERS, SLOPES, strict=True))
    return by_balls.diff(delta) + sum(inner)


def rising(expr, ranges=RANGES):
    return certificate(expand(slope_of(expr)), ranges, EVERY)


def test_a_number_that_rises_with_the_damper():
    """-n_1 does: the held force meets more damping."""
    found = more_damped(rising(-n_1), -n_1, LARGER, OTHERS)
    assert found.conclusion == Relation(-n_1, "<", -OTHERS[0])
    assert Relation(delta, "<", LARGER) in found.hypotheses
    for damper, numbers in ((delta, (n_1, n_0, a, e)), (LARGER, OTHERS)):
        assert Predicate("device", (), (gamma, damper, *numbers)) in found.hypotheses
        assert {Relation(0, "<=", damper), Relation(damper, "<=", Rational(1, 10))} <= (
            found.hypotheses
        )
    one, two = ([float(n) for n in oracle.numbers(5e-4, damper)] for damper in (0.02, 0.09))
    assert -one[0] < -two[0]


def test_what_falls_with_the_damper_is_refused():
    for wrong in (n_1, e, n_0):
        with pytest.raises(NotShown):
            more_damped(rising(-n_1), wrong, LARGER, OTHERS)


def test_the_slope_of_something_else_is_refused():
    """That f is positive says nothing of its slope; nor does part of the slope."""
    positive = certificate()
    for expr in (3 * n_0 - (n_1 + n_0), -n_1 - n_0, -n_1 - 2 * delta):
        with pytest.raises(NotShown):
            more_damped(positive, expr, LARGER, OTHERS)
        with pytest.raises(NotShown):
            more_damped(rising(-n_1), expr, LARGER, OTHERS)
    with pytest.raises(NotShown):  # the explicit delta counts, too
        more_damped(rising(-n_1), -n_1 - delta, LARGER, OTHERS)


def test_a_box_has_the_plant_s_parameters_for_sides_and_none_of_its_numbers():
    held = rising(-n_1)
    for sides in (RANGES | {n_1: (0, 1)}, {s: v for s, v in RANGES.items() if s != delta}):
        with pytest.raises(NotShown, match="no side of the box"):
            more_damped(replace(held, box=sides), -n_1, LARGER, OTHERS)
    with pytest.raises(NotShown, match="box of plants is wanted"):
        more_damped(replace(held, given={}), -n_1, LARGER, OTHERS)


def test_a_certificate_that_does_not_hold_is_refused():
    wrong = replace(rising(-n_1), expr=expand(slope_of(n_1)))
    with pytest.raises(NotShown):
        more_damped(wrong, n_1, LARGER, OTHERS)
    with pytest.raises(NotShown):
        more_damped(replace(rising(-n_1), box=RANGES | {delta: (0, 10**4)}), -n_1, LARGER, OTHERS)
    patched = Named(EVERY)
    patched._known[()] = {}
    with pytest.raises(NotShown):
        more_damped(replace(wrong, given=patched), n_1, LARGER, OTHERS)


def test_both_devices_have_names_of_their_own():
    for larger, numbers in (
        (delta, OTHERS),
        (LARGER, (n_1, *OTHERS[1:])),
        (LARGER, (OTHERS[0],) * 4),
        (gamma, OTHERS),
        (LARGER, (LARGER, *OTHERS[1:])),
        (LARGER, OTHERS[:3]),
        (Symbol("z"), OTHERS),
        (LARGER, (SLOPES[0], *OTHERS[1:])),
    ):
        with pytest.raises(NotShown):
            more_damped(rising(-n_1), -n_1, larger, numbers)


def test_a_symbol_beside_the_box_is_refused():
    """It might be another one for the other device."""
    for expr in (alpha - n_1, -n_1 / (1 + n_1), -n_1 + exp(gamma) - exp(gamma + 0 * n_1) + alpha):
        with pytest.raises(NotShown):
            more_damped(rising(-n_1), expr, LARGER, OTHERS)
