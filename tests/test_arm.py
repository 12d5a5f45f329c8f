"""The range of arms and devices is (23) of the paper."""

from symhaptic.paper import STATEMENTS
from symhaptic.paper.ranges import DAMPED, RANGES, STIFF


def test_the_range_is_the_printed_one():
    within = [side for s, (low, high) in RANGES.items() for side in (low <= s, s <= high)]
    assert tuple(within) == STATEMENTS["eq23"].printed
    assert [RANGES[s][1] for s in RANGES] == [STIFF, DAMPED]
