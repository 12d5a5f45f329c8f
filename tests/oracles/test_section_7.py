"""Slips of the text beside the paper's own lists, typed anew, and half a swing of a device."""

import numpy as np
import oracle
import pytest
from oracles.guarding import guards
from oracles.subject import counterexample, page

pytestmark = pytest.mark.ci

SECTIONS = ["I", "II", "III", "IV", "V", "VI"]  # the last is the conclusion
AUTHORS = {21: "Daniel McAree", 17: "Hogan", 22: "Kazerooni Tsay Hollerbach"}
AUTHORS |= {23: "Kosuge Fujisawa Fukuda", 24: "Kuchenbecker Park Niemeyer"}
AUTHORS |= {25: "Lakatos Petit van-der-Smagt", 26: "Lawrence", 27: "Lawrence Chapel"}
AUTHORS |= {28: "Lee Lee", 29: "Tsuji Takeda Tanaka", 30: "Yokokohji Yoshikawa"}
ET_AL = {21, 22, 23, 24, 25, 28, 29, 30}  # as Table II writes them


@guards("s7a_slips_in_words")
def test_what_the_lists_of_the_paper_say():
    settled = page("s7a_slips_in_words").settled
    found = {id: s.verdict.corrected for id, s in settled.items()}
    assert f"Section {SECTIONS[-1]}" in found["s1-conclusion"]
    two = sorted(n for n in ET_AL if len(AUTHORS[n].split()) == 2)
    assert all(f"[{n}]" in found["s4c-et-al"] for n in two)
    assert found["s4c-et-al"].count("[") == len(two) == 3
    assert "(b) and (c)" in found["s5b-ratio-panels"]


@guards("s7b_slips_in_relations")
def test_half_a_swing_per_period():
    for delta in (0.0, 0.02):
        move, _ = oracle.sampled(np.pi**2 + delta**2 / 4, delta)
        assert move == pytest.approx(-np.exp(-delta / 2) * np.eye(2), abs=1e-13)
    beyond = counterexample("s7b_slips_in_relations", "s5c-interval")
    assert beyond["gamma"] - beyond["delta"] ** 2 / 4 > np.pi**2
