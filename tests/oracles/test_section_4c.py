"""The arm: numbers of Table II typed anew, and how arm and device move in both kinds of units."""

import numpy as np
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import number, only, settled

pytestmark = pytest.mark.ci

ARMS = {  # m_H, k_H, b_H as in the paper
    "Daniel": (1, 39.5, 12.6),
    "Hogan": (0.8, 568, 5.5),
    "Kazerooni": (4.54, 12.5, 6.83),
    "Kosuge": (1.95, 55, 2.46),
    "Kuchenbecker": (0.15, 1000, 7.5),
    "Lakatos": (2.79, 345, 33.8),
    "Lawrence": (17.51, 175.1, 175.1),
    "Chapel": (0.5, 40, 6),
    "Lee": (0.15, 7, 0.5),
    "Tsuji": (1.8, 199.1, 26.2),
    "Yokokohji": (2.0, 10.0, 2.0),
}
STIFF = {name: k / m for name, (m, k, _) in ARMS.items()}
SLOW = {name: b / m for name, (m, _, b) in ARMS.items()}


@guards("s4c_arm_and_device")
def test_spring_and_damper_of_the_arm_in_the_loop():
    """A held force moves arm and device as it moves a unit mass with gamma and delta."""
    cases = [(0.4, 1.5, 1.8, 26.2, 199.1, 1e-3), (0.1, 0.02, 0.8, 5.5, 568.0, 0.05)]

    def agrees(gamma, delta):
        for m_D, b_D, m_H, b_H, k_H, T in cases:
            at = {"m_D": m_D, "b_D": b_D, "m_H": m_H, "b_H": b_H, "k_H": k_H, "T": T}
            spring, damper = number(gamma, **at), number(delta, **at)
            ours = motion.held(1.0, damper, spring, 1.0)[0]
            theirs = motion.held(m_D + m_H, b_D + b_H, k_H, T)[0]
            assert ours[0, 0] - 1 == pytest.approx(theirs[0, 0] - 1, rel=1e-9)
            assert ours[1, 1] - 1 == pytest.approx(theirs[1, 1] - 1, rel=1e-9)
            assert ours[0, 1] == pytest.approx(theirs[0, 1] / T, rel=1e-12)

    found = settled("s4c_arm_and_device", "eq19")
    only(agrees, *(line.rhs for line in found))
    for m_D, b_D, m_H, b_H, k_H, T in cases:  # (20), and the mean of both ratios
        at = {"m_D": m_D, "b_D": b_D, "m_H": m_H, "b_H": b_H, "k_H": k_H, "T": T}
        gamma, delta = (number(line.rhs, **at) for line in found)
        assert gamma < T**2 * k_H / m_H
        assert delta < T * max(b_D / m_D, b_H / m_H) < T * (b_D / m_D + b_H / m_H)


@guards("s4c_arm_data", "s4c_arm_limits")
def test_ratios_of_the_arms():
    kept = [name for name in ARMS if name != "Kuchenbecker"]
    stiff, slow = (max(kept, key=ratios.get) for ratios in (STIFF, SLOW))
    assert (stiff, slow) == ("Hogan", "Tsuji")

    def agrees(spring, damper):
        assert number(spring, k_H=0, m_H=1, second=1) == pytest.approx(STIFF[stiff], rel=1e-12)
        bound = number(damper, b_H=0, m_H=1, second=1)
        assert SLOW[slow] <= bound < SLOW[slow] + 0.05  # rounded up to a tenth

    only(agrees, *(line.rhs for line in settled("s4c_arm_limits", "eq21")), kept=("second",))
    assert STIFF["Kuchenbecker"] / STIFF[stiff] == pytest.approx(9.4, abs=0.05)
    assert SLOW["Kuchenbecker"] / SLOW[slow] == pytest.approx(3.4, abs=0.05)
    # 1 lbf/in in N/m, and 1 Hz with critical damping, from the units' definitions
    pound = 0.45359237 * 9.80665 / 0.0254
    assert (round(pound / 10, 2), round(pound, 1)) == (17.51, 175.1)
    assert (round(4 * np.pi**2, 1), round(4 * np.pi, 1)) == (39.5, 12.6)


@guards("s4c_arm_ranges")
def test_how_much_wider_the_ranges_are():
    T = 1e-3
    limits = 710 * T**2, (14.6 + 0.625) * T

    def agrees(spring, damper):
        assert number(spring) / limits[0] == pytest.approx(1.41, abs=0.005)
        assert number(damper) / limits[1] == pytest.approx(1.31, abs=0.005)

    ends = [
        line.rhs if line.lhs.is_Symbol else line.lhs for line in settled("s4c_arm_ranges", "eq23")
    ]
    only(agrees, *(end for end in ends if end != 0))
    for name in ARMS:
        inside = STIFF[name] * T**2 <= 1e-3 and SLOW[name] * T <= 0.02
        assert inside == (name != "Kuchenbecker")
