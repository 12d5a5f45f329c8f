"""How stiff a stable wall can be: walls beyond what searches with eigenvalues find are refused.

The largest stable stiffness of the figures' arm is 0.71269 without delay and 0.15433 one period
late: tests/oracles/test_section_5b_stiffest.py finds both by a search.
"""

import pytest
from sympy import Rational

from symhaptic.book.lemmas.stiffest_stable import no_stiffer, stable_wall
from symhaptic.book.lemmas.stiffness_claims import HERE, LATE, UNDELAYED, of_delay, of_ratio
from symhaptic.notation import alpha, x
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.ratio import (
    ARM,
    BEST,
    not_stiffer,
    on_the_range,
    outdoes,
    stable,
    stiffer,
)
from symhaptic.paper.ranges import RANGES
from symhaptic.proof.box import NotShown

NEAR = {0: Rational("0.824"), 1: Rational("0.422")}


@pytest.mark.parametrize(("delay", "limit"), [(0, "0.7126"), (1, "0.1543")])
def test_a_limit_below_the_stiffest_wall_is_refused(delay, limit):
    with pytest.raises(NotShown):
        no_stiffer(delay, (Rational(limit), NEAR[delay]), HERE)


@pytest.mark.parametrize(("delay", "stiffness"), [(0, "0.7128"), (1, "0.1544")])
def test_a_wall_beyond_the_stiffest_is_refused(delay, stiffness):
    with pytest.raises(NotShown):
        stable_wall(delay, (Rational(stiffness), NEAR[delay]), HERE)


def test_a_wall_is_stable_on_the_whole_range_or_not_at_all():
    # stable at delta = 0.02 only: at delta = 0 the stiffest has 0.6863
    with pytest.raises(NotShown):
        stable_wall(0, (Rational("0.7"), NEAR[0]), RANGES)


def test_the_ratios_of_the_paper():
    for id, delay, wall in (("s5b-eta-d0", 0, UNDELAYED), ("s5b-eta-d1", 1, LATE)):
        found = of_ratio(CLAIMED[id](()), delay, wall)
        assert found.conclusion == CLAIMED[id](())
        assert not found.hypotheses


@pytest.mark.parametrize(
    ("times", "most"),
    [("17.9", "17.9"), ("17.8", "17.81")],  # the search has 17.817
)
def test_a_ratio_that_is_off_by_a_digit_is_refused(times, most):
    claim = on_the_range(
        stiffer(0, Rational(times) * alpha < x, alpha < x),
        not_stiffer(0, alpha < Rational(most) * x, alpha < 20 * x),
    )
    with pytest.raises(ValueError, match="not shown"):
        of_ratio(claim, 0, UNDELAYED)


@pytest.mark.slow
def test_less_than_a_free_mass_keeps_is_refused():
    # one period late a free mass of delta = 0.02 keeps 21.705 % of 0.71321
    with pytest.raises(NotShown):
        no_stiffer(1, (Rational("0.216") * UNDELAYED[0], Rational("0.424")), RANGES)


def test_a_share_that_is_off_by_a_digit_is_refused():
    claim = on_the_range(
        outdoes(stable(0, BEST), stable(1), alpha < Rational("0.22") * x),
        outdoes(stable(1, BEST), stable(0), Rational("0.217") * alpha < x).at(ARM),
    )
    with pytest.raises(ValueError, match="not shown"):
        of_delay(claim)
