"""What a user calls a symbol changes nothing: the provers' own symbols are nobody else's."""

import pytest
import sympy as sp
from sympy import I, Symbol, exp, pi

from symhaptic import prove
from symhaptic.proof.series import limit, lowest_term

x = Symbol("x")
NAMES = [
    "_zeta",
    "zeta",
    "_g1",
    "g1",
    "g0",
    "_g2",
    "_eps",
    "eps",
    "X",
    "log(2)",
    "log(x)",
    "r",
    "f",
]


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("of", [exp(x), exp(I * pi / 3) * 2, 2**x, I, sp.sqrt(x), sp.sin(x)])
def test_a_symbol_is_never_a_generator(name, of):
    assert not prove(Symbol(name), of)
    assert not prove(Symbol(name) * of, of**2)
    assert not prove(Symbol(name), I * Symbol(name))


def test_zeta_is_not_j():
    verdict = prove(Symbol("_zeta"), I)
    assert verdict.kind == "refuted"
    assert list(verdict.counterexample) == ["_zeta"]  # as the user writes it


@pytest.mark.parametrize("name", NAMES)
def test_a_symbol_is_never_the_small_variable_of_a_limit(name):
    own = Symbol(name)
    assert limit((exp(own * x) - 1) / x, x) == own
    assert lowest_term(own + x, x) == (0, own)
    assert limit(own * sp.sin(x) / x, x) == own


def test_the_logarithm_in_a_limit_is_a_logarithm():
    # (2^x - 1)/x tends to log 2
    assert sp.simplify(limit((2**x - 1) / x, x) - sp.log(2)) == 0
