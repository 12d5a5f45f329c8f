"""The exact zero test beside the general simplifier, on the identities that the paper needs.

Both answer the same question in one run: is printed minus derived zero?  The simplifier is not a
proof method here; it is what somebody would reach for first.
"""

import pytest
import sympy as sp

from symhaptic.model import passivity
from symhaptic.notation import T, b, d, omega, theta
from symhaptic.paper import STATEMENTS
from symhaptic.proof.normal import is_zero


def differences():
    angle = {theta: omega * T}
    envelope = [e.subs(angle) for e in passivity.envelope()]
    largest = 2 * b / T * sp.tan(sp.pi / (4 * (d + 1)))
    return {
        "eq5": STATEMENTS["eq5"].printed[0].rhs - passivity.dirichlet_form().subs(angle),
        "eq7 K": STATEMENTS["eq7"].printed[0].rhs - envelope[0],
        "eq7 B": STATEMENTS["eq7"].printed[1].rhs - envelope[1],
        "eq11 K": STATEMENTS["eq11"].printed[0].rhs - largest,
    }


DIFFERENCES = differences()


@pytest.mark.parametrize("name", DIFFERENCES)
@pytest.mark.parametrize("method", ["normal form", "simplify"])
def test_decides(benchmark, name, method):
    decide = is_zero if method == "normal form" else lambda e: sp.simplify(e) == 0
    benchmark.group = name

    def run():
        sp.core.cache.clear_cache()
        return decide(DIFFERENCES[name])

    benchmark.extra_info["decided"] = bool(
        benchmark.pedantic(run, rounds=1 if method == "simplify" else 5)
    )
