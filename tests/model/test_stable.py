"""Stable forms are the derived ones, for every scene; entire functions are what they say."""

import itertools
from functools import cache

import mpmath
import pytest
import sympy as sp
from mpmath import mpf
from scipy.linalg import expm

from symhaptic.forms import entire, stable, values
from symhaptic.forms.entire import Entire, written_out
from symhaptic.model import plant
from symhaptic.model.parts import ALL, FULL, Parts
from symhaptic.notation import SYMBOLS, delta, gamma
from symhaptic.proof.decide import compare

DELAY = 2


def all_forms(parts):
    return list(stable.forms(parts, DELAY if parts.delay else None))


@cache
def are_equal(ours, derived):
    return compare(written_out(ours), derived).equal


@pytest.mark.parametrize("parts", ALL, ids=lambda p: p.name)
def test_every_form_is_what_is_derived_for_its_scene(parts):
    for form in all_forms(parts):
        assert form.equal
        for ours, derived in form.equal:
            assert are_equal(ours, derived), form.name


@pytest.mark.parametrize("parts", ALL, ids=lambda p: p.name)
def test_a_scene_has_no_argument_for_what_it_lacks(parts):
    lacking = {
        name
        for name, there in zip(
            ("gamma", "delta", "beta", "d"),
            (parts.stiffness, parts.damping, parts.virtual_damping, parts.delay),
            strict=True,
        )
        if not there
    }
    for form in all_forms(parts):
        names = {s.name for s in form.arguments}
        assert not names & lacking
        used = {s.name for expr in form.expressions for s in expr.free_symbols}
        assert used == names, form.name
        assert names <= set(SYMBOLS)


def mutants(expr):
    """One sign, one factor or one number changed."""
    for node in sp.preorder_traversal(expr):
        if isinstance(node, Entire):
            yield expr.xreplace({node: -node})
            yield expr.xreplace({node: node.func(*node.args[:-1], 2 * node.args[-1])})
        elif node.is_Rational and node not in (0, 1, -1):
            yield expr.xreplace({node: node + 1})


def same_number(one, other):
    numbers = [mpf(i) / 7 + 1 for i in range(10)]
    at = dict(zip(sorted(one.free_symbols | other.free_symbols, key=str), numbers, strict=False))
    left, right = (
        sp.lambdify(list(at), written_out(x), "mpmath")(*map(mpmath.mpc, at.values()))
        for x in (one, other)
    )
    return abs(left - right) < 1e-9


@pytest.mark.parametrize(
    "parts",
    [
        pytest.param(FULL, marks=pytest.mark.slow),
        pytest.param(Parts(stiffness=False), marks=pytest.mark.ci),
        Parts(damping=False),
    ],
)
def test_mutants_are_not_equal(parts):
    tried, seen = 0, set()
    for form in all_forms(parts):
        for ours, derived in form.equal:
            if not ours.atoms(Entire) or ours in seen:
                continue
            seen.add(ours)
            some = 4 if sp.count_ops(ours) < 150 else 1
            for wrong in itertools.islice(mutants(ours), some):
                if same_number(wrong, ours):  # such as the sign of what is squared
                    continue
                assert not compare(written_out(wrong), derived).equal, (form.name, wrong)
                tried += 1
    assert tried > 15


def test_what_a_scene_lacks_is_said():
    with pytest.raises(stable.NoForm, match="without damping"):
        stable.form("passivity_margin", Parts(damping=False))
    with pytest.raises(stable.NoForm, match="virtual damping"):
        stable.form("stability_boundary", Parts(virtual_damping=False))
    with pytest.raises(stable.NoForm, match="one whole delay"):
        stable.form("characteristic_polynomial")
    with pytest.raises(stable.NoForm, match="no delay"):
        stable.form("characteristic_polynomial", Parts(delay=False), 3)


# -- entire functions ----------------------------------------------------------------------


@pytest.mark.parametrize("cls", values.ALL.values(), ids=lambda c: c.__name__)
def test_no_closed_form_has_a_pole_or_a_jump_at_zero(cls):
    """Beside it in three directions of the complex plane, it is what it is at zero."""
    symbols = sp.symbols("x y")[: next(iter(cls.nargs))]
    closed = sp.lambdify(symbols, cls.definition(*symbols), "mpmath")
    with mpmath.workdps(120):
        wanted = mpf(cls.at_zero.p) / cls.at_zero.q
        for turn in (1, mpmath.mpc(0.6, 0.8), mpmath.mpc(-1, 0.1)):
            at = [turn * mpf(10) ** -12, turn * mpf(10) ** -12 * 3][: len(symbols)]
            assert abs(closed(*at) - wanted) < mpf(10) ** -10


@pytest.mark.parametrize("cls", values.ALL.values(), ids=lambda c: c.__name__)
def test_derivatives(cls):
    """Against a difference quotient of the closed form, by mpmath."""
    count = next(iter(cls.nargs))
    symbols = sp.symbols(f"x:{count}")
    point = [mpf("0.4"), mpf("0.9")][:count]
    for i in range(count):
        slope = written_out(cls(*symbols).diff(symbols[i]))
        with mpmath.workdps(30):
            ours = sp.lambdify(symbols, slope, "mpmath")(*map(mpmath.mpc, point))
            closed = sp.lambdify(symbols, cls.definition(*symbols), "mpmath")
            order = tuple(int(i == k) for k in range(count))

            def complex_(*v, f=closed):
                return f(*map(mpmath.mpc, v))

            theirs = mpmath.diff(complex_, tuple(point), order)
            assert abs(ours - theirs) < 1e-12


@pytest.mark.parametrize("at", [(0.3, 0.2), (5.0, 1.0), (2.0, 9.0), (0.25, 1.0)])
def test_the_device_beside_the_exponential_of_its_matrix(at):
    """scipy.linalg.expm of [[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]."""
    moved = expm([[0, 1, 0], [-at[0], -at[1], 1], [0, 0, 0]])
    n1 = moved[0, 2]
    n0 = moved[0, 1] * moved[1, 2] - moved[1, 1] * n1
    a, e = moved[0, 0] + moved[1, 1], moved[0, 0] * moved[1, 1] - moved[0, 1] * moved[1, 0]
    point = {gamma: mpf(at[0]), delta: mpf(at[1])}
    expected = {
        entire.PlantN1: n1,
        entire.PlantN0: n0,
        entire.NumeratorAtOne: n1 + n0,
        entire.NumeratorGap: (n1 - n0) / at[1],
        entire.PlantTrace: a,
        entire.DenominatorAtMinusOne: 1 + a + e,
    }
    for cls, number in expected.items():
        found = values.value(cls(gamma, delta), point)
        assert float(found) == pytest.approx(number, rel=1e-12), cls


@pytest.mark.parametrize(
    ("cls", "at", "limit"),
    [
        # the leading term of each power series
        (entire.PlantN1, (0, 0), "0.5"),
        (entire.PlantN0, (0, 0), "0.5"),
        (entire.NumeratorGap, (0, 0), "1/6"),
        (entire.NumeratorAtOne, (0, 0), "1"),
        (entire.Gap, (0,), "1/6"),
        (entire.Lag, (0,), "1/6"),
        (entire.Creep, (0,), "0.5"),
        # (1 - cos(2))/4 and 1 - 2/e: textbook steps of an undamped and of a critical device
        (entire.PlantN1, (4, 0), "(1 - cos(2))/4"),
        (entire.PlantN1, (1, 2), "1 - 2*exp(-1)"),
        (entire.PlantN0, (1, 2), "exp(-2)"),
        (entire.PlantN1, (0, 3), "(3 - 1 + exp(-3))/9"),
    ],
)
def test_values_where_the_closed_form_is_undefined(cls, at, limit):
    symbols = sp.symbols(f"x:{len(at)}")
    found = values.value(cls(*symbols), dict(zip(symbols, map(mpf, at), strict=True)))
    expected = sp.N(sp.sympify(limit), 30)
    assert mpmath.nstr(found, 25) == mpmath.nstr(mpmath.mpmathify(expected), 25)


def test_numbers_at_critical_damping():
    """A double pole at -1: n1 = 1 - 2/e and n0 = 1/e^2, by hand from 1 - (1 + t) e^-t."""
    found = plant.sampled(plant.Plant(sp.S.One, sp.S(2), sp.S.One))
    assert sp.expand(found.n1 - (1 - 2 * sp.exp(-1))) == 0
    assert sp.expand(found.n0 - sp.exp(-2)) == 0
