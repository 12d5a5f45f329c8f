"""What a blow does to a device: each hypothesis dropped or weakened is refused."""

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import quad
from scipy.linalg import expm
from sympy import S, cos, exp, log, pi, sqrt, symbols

from symhaptic.notation import a, delta, e, gamma, n_0, n_1, u, z
from symhaptic.notation.proposition import Predicate, Relation
from symhaptic.proof.theorems.familiar import of_device, sign_of
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.samples import after_a_blow
from symhaptic.proof.theorems.tactics import one, positive

DEVICE = Predicate("device", (), (gamma, delta, n_1, n_0, a, e))
SLOW = Relation(gamma - delta**2 / 4, "<", pi**2)
x = symbols("x")


def kernel(first, second, test, sign="<"):
    slope = sp.diff(test, u)
    rest = sp.diff(slope, u) + delta * slope + gamma * test
    return assume(Relation(S.Zero, sign, sp.sympify(first + second * exp(-delta * u) - rest)))


def test_a_held_force_pushes_forwards():
    found = after_a_blow(assume(DEVICE), 1, 0, u, 0, one())
    assert (found.conclusion, found.hypotheses) == (Relation(S.Zero, "<", n_1), {DEVICE, SLOW})
    found = after_a_blow(assume(DEVICE), 0, 1, u, 0, sign_of(exp, -delta * u))
    assert (found.conclusion, found.hypotheses) == (Relation(S.Zero, "<", n_0), {DEVICE, SLOW})


def test_weak_stays_weak():
    nothing = assume(Relation(S.Zero, "<=", S.One + 0 * u))
    found = after_a_blow(assume(DEVICE), 1, 0, u, 0, nothing)
    assert found.conclusion.sign == "<="


@pytest.mark.parametrize(("spring", "damper"), [(5.0, 0.7), (0.3, 2.5), (1.0, 2.0), (0.0, 0.0)])
def test_the_integrals_of_the_rule(spring, damper):
    """n1, n0 and f(1) as integrals of the answer to a blow, by quadrature."""
    motion = np.array([[0, 1, 0], [-spring, -damper, 1], [0, 0, 0]])
    grown = expm(motion)
    first = grown[0, 2]
    late = grown[0, 1] * grown[1, 2] - grown[1, 1] * grown[0, 2]

    def blow(t):
        return expm(motion[:2, :2] * t)[0, 1]

    def of(weight):
        return quad(lambda v: weight(v) * blow(1 - v), 0, 1)[0]

    assert of(lambda v: 1) == pytest.approx(first, rel=1e-9)
    assert of(lambda v: np.exp(-damper * v)) == pytest.approx(late, rel=1e-9)
    by_parts = of(lambda v: 6 * v + damper * 3 * v**2 + spring * v**3)  # f = u^3
    assert by_parts == pytest.approx(1, rel=1e-9)
    assert np.trace(grown[:2, :2]) > -2 * np.exp(-damper / 2)


def test_a_swing_of_half_a_turn_is_a_hypothesis_and_is_needed():
    assert SLOW in after_a_blow(assume(DEVICE), 1, 0, u, 0, one()).hypotheses
    assert SLOW in of_device("device turns", assume(DEVICE)).hypotheses
    # h(1 - u) = sin(omega (1 - u))/omega of gamma = omega^2, 3 < pi < 4
    swing = [
        quad(lambda v, w=w: max(0.2 - v, 0) * np.sin(w * (1 - v)) / w, 0, 1)[0] for w in (3, 4)
    ]
    assert swing[0] > 0 > swing[1]


def test_the_test_function_starts_with_zero_and_flat():
    for test in (S.One, u, exp(u), 1 - cos(u) + u):
        with pytest.raises(NotShown):
            after_a_blow(assume(DEVICE), 0, 0, u, test, kernel(0, 0, test))


@pytest.mark.parametrize(
    "test",
    [u**2 * sqrt(u), u**3 * log(u), u**3 / (2 * u - 1), u**2 * z, u**x],
)
def test_the_test_function_is_smooth_and_real(test):
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), 0, 0, u, test, kernel(0, 0, test))


def test_a_corner_is_refused():
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), 0, 0, u, sp.Abs(u - S.Half) * u**2, one())


def test_a_divisor_of_the_test_function_becomes_a_hypothesis():
    free = assume(DEVICE.at({gamma: S.Zero, delta: S.Zero}))
    found = after_a_blow(free, 0, 0, u, u**2 / x, assume(Relation(S.Zero, "<", -2 / x)))
    assert Relation(x, "!=", S.Zero) in found.hypotheses
    assert found.conclusion == Relation(S.Zero, "<", -1 / x)


def test_the_kernel_is_that_of_the_weights():
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), 1, -1, u, 0, one())
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), 0, 0, u, -(u**2), kernel(0, 0, -(u**3)))
    for wrong in (Relation(S.Zero, "=", S.One), Relation(S.One, "<", u), DEVICE):
        with pytest.raises(NotShown):
            after_a_blow(assume(DEVICE), 1, 0, u, 0, assume(wrong))


def test_the_kernel_is_known_on_the_whole_period():
    falls = positive(1 - 2 * u > 0, [2, u < S.Half])
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), 1, 0, u, u**3 / 3, falls)
    part = assume(Relation(S.Zero, "<", kernel(1, 0, u**3).conclusion.right))
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), 1, 0, u, u**3, part)


def test_names_are_apart():
    other = Predicate("device", (), (gamma, u, n_1, n_0, a, e))
    with pytest.raises(NotShown):
        after_a_blow(assume(other), 1, 0, u, 0, one())
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), u, 0, u, 0, assume(Relation(S.Zero, "<", u)))
    with pytest.raises(NotShown):
        after_a_blow(assume(DEVICE), z, 0, u, 0, assume(Relation(S.Zero, "<", z)))
    with pytest.raises(NotShown):
        after_a_blow(assume(SLOW), 1, 0, u, 0, one())
    with pytest.raises(NotShown):
        of_device("device turns", assume(SLOW))


def test_what_the_poles_say():
    low = of_device("device turns", assume(DEVICE)).conclusion
    assert low == Relation(-2 * exp(-delta / 2), "<", a)
