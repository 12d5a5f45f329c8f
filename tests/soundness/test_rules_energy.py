"""Energy of filtered answers and of counted positions: what each rule asks for, and vacuous cases.

Each is attacked where one of its conditions is missing.
"""

import numpy as np
import pytest
import sympy as sp
from sympy import Abs, Add, I, Mul, Pow, S, symbols

from symhaptic.book.lemmas.counts import spring_passive, wall_passive
from symhaptic.notation import Delta_x, T, b, f_c, p_k, s, theta, x, y, z
from symhaptic.notation.proposition import Not, Predicate, Relation, whole
from symhaptic.proof.theorems.energy import dissipates, filtered, swing_gains, toeplitz
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.leaves import identity, number
from symhaptic.proof.theorems.roots import degree, hurwitz, jury

K, c, f, q, n = symbols("K u f q n")
WALL = (b, f_c, T, Delta_x)


# -- answers of a filter --------------------------------------------------------------------


def margin(theorem):
    """c + Re H/(z - 1) at an angle."""
    return theorem.conclusion.of[1].of[1].body.of[1].right


@pytest.mark.parametrize("above", [S.One, z, 2 * z - 1, S.Zero])
def test_the_margin_is_that_of_the_response(above):
    found = filtered(above / (z - f), z - f, z, c, theta)
    assert Predicate("stable", (z,), (z - f,)) in found.hypotheses
    for pole, angle in ((0.3, 0.7), (-0.8, 2.9)):
        at = np.exp(1j * angle)
        response = complex((above / (z - f)).subs({z: at, f: pole}))
        wanted = 0.1 + (response / (at - 1)).real
        assert complex(margin(found).subs({theta: angle, f: pole, c: 0.1})) == pytest.approx(wanted)


def test_without_a_filter_it_is_a_spring():
    """D = 1 has no zeros: what is said is vacuous, and true."""
    found = filtered(K, S.One, z, c, theta)
    assert complex(margin(found).subs({theta: 1.3, K: 2, c: 0})) == pytest.approx(-1)
    assert found.conclusion.of[1].of[0] == Relation(S.Zero, "<=", K)


def test_a_response_is_made_of_real_numbers_known_degrees_and_no_future():
    for response, below, why in (
        (z**2 / (z - f), z - f, "lower degree"),  # it answers before it is asked
        (K / (2 * z - f), 2 * z - f, "not monic"),
        (K / (z - I * f), z - I * f, "not real"),
        (I * K / (z - f), z - f, "not real"),
        (sp.sqrt(K) / (z - f), z - f, "not real"),
        (Abs(s + I), S.One, "not real"),  # s is complex: the mirror image is another number
        (K / (z - f), z - q, "no polynomial"),  # the filter of another response
        (z**n / (z - f), z - f, "no polynomial"),
        (K, z**n, "no polynomial"),
    ):
        with pytest.raises(NotShown, match=why):
            filtered(response, below, z, c, theta)


def test_what_sympy_cancels_is_checked(monkeypatch):
    monkeypatch.setattr(sp, "cancel", lambda _: z)
    with pytest.raises(NotShown, match="is not z by"):
        filtered(K / (z - f), z - f, z, c, theta)


def test_the_angle_and_the_variable_are_bound():
    for response, below, damping in (
        (K / (z - f), z - f, theta),
        (K / (z - f), z - f, z),
        (theta / (z - f), z - f, c),
        (K / (z - theta), z - theta, c),
        (K, z - theta, c),
        (K - theta, z + theta, c),  # their sum does not know the angle
    ):
        with pytest.raises(NotShown, match="bound"):
            filtered(response, below, z, damping, theta)


def test_a_loss_is_real():
    for damping in (I, sp.sqrt(c)):
        with pytest.raises(NotShown, match="not real by its form"):
            filtered(K / (z - f), z - f, z, damping, theta)


def test_a_divisor_of_the_response_is_asked_for():
    found = filtered(K / (T * (z - f)), z - f, z, c / q, theta)
    assert {Relation(t, "!=", S.Zero) for t in (T, q)} <= found.hypotheses


def written(above, below):
    """A quotient as it stands, of which SymPy cancels nothing."""
    return Mul(above, Pow(below, -1), evaluate=False)


VANISHING = q * z - q / 2
"""A divisor that is zero for all z, for q = 0."""

NOTHING = Add(Mul(S.Zero, z, evaluate=False), Mul(S.Zero, -S.Half, evaluate=False), evaluate=False)
"""What becomes of it."""


@pytest.mark.parametrize("above", [VANISHING, NOTHING])
def test_a_divisor_with_the_variable_is_a_factor_of_the_denominator(above):
    """Two answers that are the same 0/0 for q = 0 would be 1 and 0."""
    quotient = written(above, VANISHING)
    for use in (
        lambda: filtered(quotient, z - S.Half, z, c, theta),
        lambda: filtered(q * (z - S.Half) / (f * z - f / 2), z - S.Half, z, c, theta),
        lambda: toeplitz(quotient, z, c, theta),
        lambda: jury(Add(z, quotient, evaluate=False), z),
        lambda: hurwitz(Add(z, quotient, evaluate=False), z),
        lambda: degree(Add(z, quotient, evaluate=False), z, 1),
    ):
        with pytest.raises(NotShown, match="is about z"):
            use()


def test_a_polynomial_for_the_half_plane_has_no_negative_powers():
    with pytest.raises(NotShown, match="is about s"):
        hurwitz(Add(s, written(s, s), evaluate=False), s)


# -- counted positions ----------------------------------------------------------------------

STORE = K * x**2 / 2


def taken(force, store, way=p_k):
    rest = force * way + b * way**2 / T + f_c * Abs(way)
    return Relation(S.Zero, "<=", rest - store.xreplace({x: x + way}) + store)


def parts(force=K * y, store=STORE):
    """What is shown of a force and a store, taken for granted."""
    some = assume(Relation(S.Zero, "<=", store))
    start = store.xreplace({x: S.Zero})
    none = identity(start, S.Zero) if start == 0 else assume(Relation(start, "=", S.Zero))
    return assume(taken(force, store)), some, none


def test_a_store_that_is_only_assumed_is_about_the_place():
    with pytest.raises(NotShown, match="is about"):
        dissipates(STORE, K * y, WALL, (x, y, p_k), *parts())


def test_nothing_pushes_and_nothing_is_stored():
    """The vacuous case: no force, no store and no loss."""
    nothing = number(Relation(S.Zero, "<=", S.Zero))
    none = identity(S.Zero, S.Zero)
    found = dissipates(0, 0, (0, 0, T, Delta_x), (x, y, p_k), nothing, nothing, none)
    assert found.conclusion == Predicate("passive_counted", (y,), (0, 0, 0, T, Delta_x))
    assert {Relation(S.Zero, "<", T), Relation(S.Zero, "<", Delta_x)} <= found.hypotheses


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"wall": (p_k, f_c, T, Delta_x)}, "bound"),
        ({"wall": (b, f_c, x, Delta_x)}, "bound"),
        ({"wall": (S.Zero, Abs(p_k), T, Delta_x)}, "bound"),  # their product is 0
        ({"wall": (x, 1 / x, T, Delta_x)}, "bound"),  # their product does not know the place
        ({"over": (x, x, p_k)}, "bound"),
        ({"force": K * x}, "of the count"),
        ({"force": K * p_k}, "of the count"),
        ({"store": K * y**2}, "of the count"),
        ({"growth": assume(taken(K * y, 2 * STORE))}, "not negative"),
        ({"growth": assume(taken(-K * y, STORE))}, "not negative"),
        ({"some": assume(Relation(S.Zero, "<=", K))}, "not negative"),
        ({"none": assume(Relation(STORE, "=", S.Zero))}, "stored at the start"),
        ({"none": assume(Relation(S.Zero, "<=", S.Zero))}, "stored at the start"),
    ],
)
def test_a_store_is_one_of_the_place_and_grows_by_what_is_taken(change, why):
    growth, some, none = parts()
    given = {
        "store": STORE,
        "force": K * y,
        "wall": WALL,
        "over": (x, y, p_k),
        "growth": growth,
        "some": some,
        "none": none,
    }
    with pytest.raises(NotShown, match=why):
        dissipates(**given | change)


def test_a_force_and_a_store_have_values():
    """At q = 0 both forces are the same 0/0: one passive, one not."""
    nothing = number(Relation(S.Zero, "<=", S.Zero))
    none = identity(S.Zero, S.Zero)
    over = (x, y, p_k)
    still = Mul(y, S.Zero, Pow(q, -1), evaluate=False)
    found = dissipates(0, still, (0, 0, 1, 1), over, nothing, nothing, none)
    assert Relation(q, "!=", S.Zero) in found.hypotheses
    pushing = Mul(y, q, Pow(q, -1), evaluate=False)
    gain = number(Relation(-S.Half, "<", S.Zero))
    found = swing_gains(pushing, y, (0, 0, 1, 1), (S(1) / 4, S.Half, 0, 1), gain)
    assert Relation(q, "!=", S.Zero) in found.hypotheses
    loss = Mul(S.Zero, Pow(q, -1), evaluate=False)
    found = dissipates(0, 0, (loss, 0, 1, 1), over, nothing, nothing, none)
    assert Relation(q, "!=", S.Zero) in found.hypotheses


def test_no_force_divides_by_its_place():
    nothing = number(Relation(S.Zero, "<=", S.Zero))
    none = identity(S.Zero, S.Zero)
    still = Mul(S.Zero, y, Pow(y, -1), evaluate=False)
    with pytest.raises(NotShown, match="is about y"):
        dissipates(0, still, (0, 0, 1, 1), (x, y, p_k), nothing, nothing, none)
    gain = number(Relation(-S.Half, "<", S.Zero))
    pushing = Mul(y, y, Pow(y, -1), evaluate=False)
    with pytest.raises(NotShown, match="is about y"):
        swing_gains(pushing, y, (0, 0, 1, 1), (S(1) / 4, S.Half, 0, 1), gain)


def swing(force, start, way, one, other, wall=WALL):
    """That a swing gains energy, assumed."""
    damping, friction, period, step = wall
    low, high = (force.xreplace({y: k * step}) for k in (one, other))
    left = low * way - high * way + 2 * damping * way**2 / period + 2 * friction * Abs(way)
    return assume(Relation(left, "<", S.Zero))


def test_a_swing_has_the_counts_that_it_is_given():
    gain = swing(K * y, x, p_k, S.Zero, n)
    found = swing_gains(K * y, y, WALL, (x, p_k, 0, n), gain)
    assert found.conclusion == Not((Predicate("passive_counted", (y,), (K * y, *WALL)),))
    assert {whole(S.Zero), whole(n)} <= found.hypotheses
    near = {
        Relation(-Delta_x / 2, "<", x),
        Relation(x, "<", Delta_x / 2),
        Relation(n * Delta_x - Delta_x / 2, "<", x + p_k),
        Relation(x + p_k, "<", n * Delta_x + Delta_x / 2),
    }
    assert near | {Relation(S.Zero, "<", T), Relation(S.Zero, "<", Delta_x)} <= found.hypotheses


def test_where_a_swing_begins_has_a_value():
    start = Delta_x / q
    gain = swing(K * y, start, p_k, S.Zero, S.One)
    found = swing_gains(K * y, y, WALL, (start, p_k, 0, 1), gain)
    assert Relation(q, "!=", S.Zero) in found.hypotheses


@pytest.mark.parametrize(
    ("wall", "way", "gain", "why"),
    [
        (WALL, p_k, swing(K * y, x, p_k, S.One, S.Zero), "is negative"),  # the other way round
        (WALL, p_k, swing(K * y, x, 2 * p_k, S.Zero, S.One), "is negative"),
        (WALL, p_k, assume(Relation(S.Zero, "<", S.Zero)), "is negative"),
        (WALL, I * p_k, swing(K * y, x, I * p_k, S.Zero, S.One), "not real"),
        ((y, f_c, T, Delta_x), p_k, swing(K * y, x, p_k, S.Zero, S.One), "not real"),
        ((I, f_c, T, Delta_x), p_k, swing(K * y, x, p_k, S.Zero, S.One), "not real"),
    ],
)
def test_a_swing_is_real_and_gains(wall, way, gain, why):
    with pytest.raises(NotShown, match=why):
        swing_gains(K * y, y, wall, (x, way, 0, 1), gain)


@pytest.mark.parametrize("proved", [spring_passive, wall_passive])
def test_damper_and_friction_burn_and_do_not_drive(proved):
    """Of a negative one a detour takes less than the straight way, and nothing is shown."""
    wanted = {Relation(S.Zero, "<=", loss) for loss in (b, f_c)}
    wanted |= {Relation(S.Zero, "<", size) for size in (T, Delta_x)}
    assert wanted <= proved().hypotheses
