"""Too much virtual damping: products of eigenvalues, and where loops start to grow."""

import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import number, only, page, shown

pytestmark = pytest.mark.ci

CHAPTER = "s4d_virtual_damping"
ARM = (0.001, 0.02)
"""The largest spring and damper of (23)."""


@guards("s4d_virtual_damping")
def test_the_constant_coefficient_is_the_product_of_the_eigenvalues():
    cases = [(0.4, 0.7, 0.3, 0.2), (-0.3, 1.9, 2.0, 0.0), (2.0, -0.8, 0.1, 3.0)]

    def agrees(constant):
        for d in (0, 1, 4):
            for alpha, beta, gamma, delta in cases:
                roots = np.linalg.eigvals(oracle.loops(alpha, beta, gamma, delta, d))
                at = {"beta": beta, **oracle.named(gamma, delta)}
                found = np.prod(-roots)
                assert number(constant, **at) == pytest.approx(found, abs=1e-12)

    only(agrees, shown(CHAPTER, r"The constant coefficient is $-\beta n_0$ for every delay"))


@guards("s4d_virtual_damping")
@pytest.mark.parametrize(("d", "low", "high"), [(0, 1.9, 2.1), (1, 0.7, 0.9)])
def test_the_four_walls_of_the_arm(d, low, high):
    said = {b.title for b in page(CHAPTER).blocks if b.theorem is not None}
    for beta, word in ((low, "stable"), (high, "not stable")):
        where = rf"For $d={d}$, $\gamma=0.001$, $\delta=0.02$ the wall $(0.05,{beta})$"
        assert f"{where} is {word}" in said
        assert (oracle.radius(0.05, beta, *ARM, d).max() < 1) == (word == "stable")
        place = motion.positions(0.05, beta, 1.0, ARM[1], ARM[0], 1.0, float(d), steps=1500)
        assert motion.grows(place) == (word == "not stable")
