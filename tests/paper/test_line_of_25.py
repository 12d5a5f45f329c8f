"""The line of (25), solved for a wall's stiffness or damping."""

import pytest
from sympy import Eq

from symhaptic.notation import alpha, beta, d, delta, gamma
from symhaptic.paper.propositions import linear


def test_the_line_of_25():
    """(25) is printed beta + delta > alpha (1/2 + d); the line is where both sides are equal."""
    assert (linear.on_the_line_of_25(beta) - ((2 * d + 1) * alpha / 2 - delta)).expand() == 0


def test_what_is_not_linear_is_no_line(monkeypatch):
    monkeypatch.setattr(linear, "transcribed", lambda id: [Eq(alpha**2, beta + gamma)])
    line = linear.on_the_line_of_25.__wrapped__  # keeps its values
    assert line(beta) == alpha**2 - gamma
    with pytest.raises(ValueError, match="not linear in alpha"):
        line(alpha)
