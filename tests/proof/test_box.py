"""An inequality on a box is shown where it holds, and never where it does not."""

import mpmath
import pytest
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from symhaptic.proof import box
from symhaptic.proof.box import NotShown
from symhaptic.proof.recheck import recheck

x, y = sp.symbols("x y")
SMALL = st.integers(-5, 5)


def test_the_cosine_is_above_its_parabola():
    """cos x > 1 - x^2/2 for x in [1/10, 3], a textbook inequality."""
    found = box.positive(sp.cos(x) - 1 + x**2 / 2, {x: (sp.Rational(1, 10), 3)})
    assert recheck(found)
    assert found.box == {x: (sp.Rational(1, 10), sp.Integer(3))}


@pytest.mark.parametrize(
    "false",
    [
        1 - x**2 / 2 - sp.cos(x),  # the sign changed
        sp.cos(x) - 1 + x**2 / 3,  # a factor changed
        sp.sin(x) - x + x**3 / 6 - sp.Rational(1, 100),  # negative near 0.1 only
    ],
)
def test_mutants_are_denied(false):
    with pytest.raises(NotShown):
        box.positive(false, {x: (sp.Rational(1, 10), 3)})


def test_what_touches_zero_is_undecided_and_not_a_pass(monkeypatch):
    monkeypatch.setattr(box, "_PIECES", 200)
    with pytest.raises(NotShown, match="undecided"):
        box.positive((x - sp.Rational(1, 3)) ** 2, {x: (0, 1)})


def test_a_symbol_without_an_interval_is_named():
    with pytest.raises(NotShown, match="y"):
        box.positive(x + y, {x: (1, 2)})


@settings(max_examples=60, deadline=None)
@given(SMALL, SMALL, SMALL, SMALL)
def test_agrees_with_the_minimum_of_a_cubic(a, b, c, d):
    """The minimum on [0, 1] from mpmath's roots of the derivative."""
    ends = [mpmath.mpf(0), mpmath.mpf(1)]
    if a or b or c:
        slope = [3 * a, 2 * b, c]
        while slope and slope[0] == 0:
            slope.pop(0)
        roots = mpmath.polyroots(slope, maxsteps=200, extraprec=200) if len(slope) > 1 else []
        ends += [r.real for r in roots if abs(r.imag) < 1e-12 and 0 < r.real < 1]
    least = min(((a * t + b) * t + c) * t + d for t in ends)
    cubic = ((a * x + b) * x + c) * x + d + sp.Integer(0)
    if least > 1e-3:
        assert recheck(box.positive(cubic, {x: (0, 1)}))
    elif least < -1e-3:
        with pytest.raises(NotShown):
            box.positive(cubic, {x: (0, 1)})
