"""Stability inequalities with all six symbols: from the delay to SymPy relations, and the minors.

The largest minor is also computed as Jury's determinant |X - Y| by two of SymPy's own methods,
and the whole set by ``Poly.schur_conditions`` where the SymPy that is installed has it.
"""

import pytest
import sympy as sp
from sympy.polys.matrices import DomainMatrix

from symhaptic.model import jury, polynomials

SYMBOLS = sp.symbols("alpha beta n_1 n_0 a e")
METHODS = {
    # method: what it does, largest delay at which it is asked
    "inequalities": (jury.inequalities, 8),
    "polynomials only": (lambda d: jury.criterion(jury.coefficients(d)), 8),
    "Berkowitz": (lambda d: jury.inner(jury.coefficients(d), d + 2).det(method="berkowitz"), 4),
    "domain matrix": (lambda d: over_integers(jury.inner(jury.coefficients(d), d + 2)), 7),
}
if hasattr(sp.Poly, "schur_conditions"):
    METHODS["schur_conditions"] = (
        lambda d: sp.Poly(jury.coefficients(d), sp.Symbol("z")).schur_conditions(),
        2,
    )


def over_integers(matrix):
    return DomainMatrix.from_Matrix(matrix).convert_to(sp.ZZ[SYMBOLS]).det()


def forget():
    sp.core.cache.clear_cache()
    polynomials._monomial.cache_clear()


CASES = [(d, name) for name, (_, most) in METHODS.items() for d in range(most + 1)]


@pytest.mark.parametrize(("delay", "method"), CASES)
def test_delay(benchmark, delay, method):
    benchmark.group = f"delay {delay}"
    compute = METHODS[method][0]

    def run():
        forget()
        return compute(delay)

    benchmark.pedantic(run, rounds=3)


def test_all_delays_to_7(benchmark):
    """The goal is one second."""

    def run():
        forget()
        return [jury.inequalities(delay) for delay in range(8)]

    benchmark.pedantic(run, rounds=3, warmup_rounds=1)
