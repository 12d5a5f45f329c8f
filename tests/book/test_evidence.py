"""The numbers that a theorem shows are those of its loop, by another road."""

import re

import numpy as np
import pytest
from scipy.linalg import expm

from symhaptic.book.chapters import folder, run
from symhaptic.book.evidence import evidence
from symhaptic.book.rests import shown_in
from symhaptic.book.rules import classical, says
from symhaptic.notation.predicates import MEANINGS, TERMS
from symhaptic.notation.written import defined
from symhaptic.proof.theorems.axioms import AXIOMS

WALLS = (
    (269 / 400, 97 / 100, 0, 0, 0),
    (269 / 400, 97 / 100, 1e-3, 0, 0),
    (9 / 800, -13 / 4000, 0, 0.02, 1),
    (9 / 1600, -13 / 8000, 0, 0.01, 1),
)


@pytest.fixture(scope="module")
def told():
    chapter = run(folder() / "s4d_parts_of_the_arm.py")
    shown = shown_in([(1, chapter)])
    return [evidence(b.theorem, shown) for b in chapter.page.blocks if b.theorem is not None]


def loop(alpha, beta, gamma, delta, d):
    """z^(d+1) A + N W, of the matrix exponential of the device and a held force."""
    flow = expm(np.array([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]], dtype=float))
    phi, force = flow[:2, :2], flow[:2, 2]
    late = phi[0, 1] * force[1] - phi[1, 1] * force[0]
    held = np.polymul([1, -np.trace(phi), np.linalg.det(phi)], [1] + [0] * (d + 1))
    return np.polyadd(held, np.polymul([force[0], late], [alpha + beta, -beta]))


def written(text):
    """Coefficients of the polynomial in a sentence."""
    shown = re.match(r"\$([^$]*)\$", text)[1]
    parts = re.findall(r"([+-]?[\d.]*)(z?)(?:\^(\d))?", shown)
    powers = {
        int(p or bool(z)): float({"": 1, "+": 1, "-": -1}.get(c, c)) for c, z, p in parts if c or z
    }
    return [powers.get(n, 0.0) for n in range(max(powers), -1, -1)]


@pytest.mark.parametrize("at", range(4))
def test_the_polynomial_and_its_largest_zero_are_those_of_the_loop(at, told):
    exact = loop(*WALLS[at])
    assert written(told[at]) == pytest.approx(exact, abs=6e-10)
    largest = float(re.search(r"\|z\|=([\d.]+)", told[at])[1])
    assert largest == pytest.approx(max(abs(np.roots(exact))), abs=1e-7)
    assert (largest < 1) is (at in (0, 2))


def test_a_predicate_is_told_as_it_is_printed():
    assert list(TERMS) == list(MEANINGS)
    for name, (_, terms, _, _) in MEANINGS.items():
        assert len(TERMS[name]) == terms
        shown, meaning = defined(name)
        assert shown
        assert meaning.count("$") % 2 == 0


@pytest.mark.parametrize("rule", [rule for rule in classical() if rule not in AXIOMS])
def test_a_rule_is_stated_without_names_of_arguments(rule):
    assert says(rule)
    assert "``" not in says(rule)
    assert ">>>" not in says(rule)


def test_a_rule_is_stated_with_its_hypotheses():
    assert "a_(n-j+i)" in says("jury")
    assert "nor at 1" in says("roots_stay")
