"""The normal form proves identities exactly and never calls zero what is not."""

from contextlib import suppress

import mpmath
import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from sympy import I, Rational, S, cos, cosh, exp, pi, re, sin, sinh, sqrt, tan

from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported

x, y, z, d, N, delta = sp.symbols("x y z d N delta")
H = sp.Function("H")

# Textbook identities (Abramowitz and Stegun, ch. 4); symbols without assumptions.
IDENTITIES = {
    "Pythagoras": sin(x) ** 2 + cos(x) ** 2 - 1,
    "double angle": sin(2 * x) - 2 * sin(x) * cos(x),
    "triple angle": cos(3 * x) - 4 * cos(x) ** 3 + 3 * cos(x),
    "half-angle tangent": tan(x / 2) - sin(x) / (1 + cos(x)),
    "addition": sin(x + y) - sin(x) * cos(y) - cos(x) * sin(y),
    "sum to product, symbolic d": cos(d * x)
    - cos((d + 1) * x)
    - 2 * sin(x / 2) * sin((d + Rational(1, 2)) * x),
    "Chebyshev step, symbolic d": sin((d + 2) * x) + sin(d * x) - 2 * cos(x) * sin((d + 1) * x),
    "Dirichlet kernel of order 2": 1 + 2 * cos(x) + 2 * cos(2 * x) - sin(5 * x / 2) / sin(x / 2),
    "de Moivre": exp(I * x) - cos(x) - I * sin(x),
    "hyperbolic": cosh(x) ** 2 - sinh(x) ** 2 - 1,
    "hyperbolic and circular": cosh(I * x) - cos(x),
    "shifted by a quarter turn": sin(x + pi / 2) - cos(x),
    "root of unity": 1 + exp(2 * I * pi / 3) + exp(4 * I * pi / 3),
    "twelfth root of unity": exp(I * pi / 6) ** 12 - 1,
    "sum over seventh roots": sum(exp(2 * I * pi * n / 7) for n in range(7)),
    "cosines of sevenths": cos(pi / 7) - cos(2 * pi / 7) + cos(3 * pi / 7) - Rational(1, 2),
    "symbolic angle pi over d+1": cos(pi * d / (d + 1)) + cos(pi / (d + 1)),
    "complementary angle": sin(pi * d / (2 * (d + 1))) - cos(pi / (2 * (d + 1))),
    "denominator of a radical": 1 / (sqrt(x) + 1) - (sqrt(x) - 1) / (x - 1),
    "nested radical": (sqrt(1 + sqrt(x)) + 1) * (sqrt(1 + sqrt(x)) - 1) - sqrt(x),
    "cube root": (x ** Rational(1, 3) - 1) * (x ** Rational(2, 3) + x ** Rational(1, 3) + 1)
    - x
    + 1,
    "exponent with a root": exp((delta + sqrt(x)) / 2) * exp((delta - sqrt(x)) / 2) - exp(delta),
    "symbolic powers": z ** (d + 2) - z**2 * z**d,
    "inverse symbolic power": z ** (-d) * z ** (2 * d + 1) / z ** (d + 1) - 1,
    "two symbolic powers": z ** (x + y) - z**x * z**y,
    "half a symbolic power": z ** (d / 2) * z ** (d / 2) - z**d,
    "unknown function": (1 + H(z)) ** 2 - H(z) ** 2 - 2 * H(z) - 1,
    "real part": re((1 + exp(I * x)) / 2, evaluate=False) - cos(x / 2) ** 2,
}


@pytest.mark.parametrize("name", IDENTITIES)
def test_identity_is_proved(name):
    assert is_zero(IDENTITIES[name])


# Each is not zero for some real values; the comment names one.
FALSE = {
    "sine doubled": sin(2 * x) - 2 * sin(x),  # x = 1
    "root of a square": sqrt(x**2) - x,  # x = -1
    "cube root of a cube": (x**3) ** Rational(1, 3) - x,  # x = -1
    "power of a product": (x * y) ** d - x**d * y**d,  # x = y = -1, d = 1/2
    "power of a power": (x**2) ** d - x ** (2 * d),  # x = -1, d = 1/2
    "power of an exponential": exp(x) ** d - exp(d * x),  # x = 2 pi j, d = 1/2
    "product of roots": sqrt(x) * sqrt(y) - sqrt(x * y),  # x = y = -1
    "logarithm of a square": sp.log(x**2) - 2 * sp.log(x),  # x = -1
    "cube root of -8": (-8) ** Rational(1, 3) + 2,  # principal root is 1 + sqrt(3) j
    "off by a rational": sin(x) ** 2 + cos(x) ** 2 - 1 - Rational(1, 10**50),
    "wrong root of unity": exp(2 * I * pi / 5) ** 3 - 1,
    "another argument": H(z) - H(2 * z),
}


@pytest.mark.parametrize("name", FALSE)
def test_what_fails_somewhere_is_not_proved(name):
    assert not is_zero(FALSE[name])


# x = -1, d = 1/2 makes x^d = j; x = 1 makes sqrt(-x) = j; c_1 is complex by its notation.
@pytest.mark.parametrize("form", [x**d, sqrt(-x), (-1) ** x, sp.Symbol("c_1")])
def test_what_need_not_be_real_is_not_its_own_real_part(form):
    with suppress(Unsupported):
        assert not is_zero(re(form, evaluate=False) - form)


@pytest.mark.parametrize(
    "expr",
    [
        1 / (sin(x) ** 2 + cos(x) ** 2 - 1),
        x / (exp(I * pi / 3) + exp(-I * pi / 3) - 1),
        (z ** (d + 1) - z * z**d + cosh(x) ** 2 - sinh(x) ** 2 - 1) ** -2,
        1 / (1 + exp(2 * I * pi / 3) + exp(4 * I * pi / 3)),
    ],
)
def test_division_by_an_identical_zero_is_undefined(expr):
    with pytest.raises(Undefined):
        is_zero(expr)


def root(n, q=2):
    """A root of a number that SymPy leaves as it is."""
    return sp.Pow(n, Rational(1, q), evaluate=False)


ABSOLUTE = sqrt(y**2)
# Each vanishes for one value of its roots: a product with the conjugate is zero, by hand.
ZERO_DIVISORS = {
    "y^2 - y^2": (ABSOLUTE - y) * (ABSOLUTE + y),
    "zero for y > 0": ABSOLUTE - y,
    "zero for y < 0, in a divisor's divisor": 1 + 1 / (ABSOLUTE + y),
    "sqrt 2 sqrt 3 = sqrt 6": sp.Mul(root(2), root(3), evaluate=False) - root(6),
    "the root of 4": root(4) - 2,
    "the root of 4 x": root(4 * x) - 2 * sqrt(x),
    "the root of 3 + 2 sqrt 2 is 1 + sqrt 2": sqrt(3 + 2 * sqrt(2)) - 1 - sqrt(2),
    "a root of unity and a radical": exp(I * pi / 4, evaluate=False)
    + exp(-I * pi / 4, evaluate=False)
    - sqrt(2),
    "the cube root of -1": root(-1, 3) ** 2 - root(-1, 3) + 1,
    "roots of a product": sqrt(x) * sqrt(y) - sqrt(x * y),
    "cube roots": root(x, 3) * root(x**2, 3) - x,
    "fourth root and root": sp.Pow(root(x, 4), 2, evaluate=False) - sqrt(x),
    "a nested root": sqrt(ABSOLUTE - y),
    "a symbolic power": (y**2) ** (d + Rational(1, 2)) / (y**2) ** d - y,
    "a product of one in an exponent": sp.exp(1 / (ABSOLUTE - y)) * (ABSOLUTE + y),
    "the base of a symbolic power": (ABSOLUTE - y) ** d,
}


@pytest.mark.parametrize("name", ZERO_DIVISORS)
def test_division_by_a_zero_divisor_is_refused(name):
    with pytest.raises((Unsupported, Undefined)):
        is_zero(5 / ZERO_DIVISORS[name])
    with pytest.raises((Unsupported, Undefined)):
        is_zero(x - 1 / (2 + 1 / ZERO_DIVISORS[name]))


@settings(max_examples=80, deadline=None, derandomize=True)
@given(
    st.sampled_from([x**2, x**2 + 1, x, S(4), S(2), x**4, (x + y) ** 2, x * y]),
    st.tuples(*[st.sampled_from([x, -x, y, x + y, x**2, S(0), S(1), S(2), 1 + x**2])] * 2),
)
def test_a_divisor_is_allowed_where_its_norm_is_not_zero(base, parts):
    """The norm of a + b w with w^2 = c is a^2 - b^2 c."""
    first, second = parts
    of = root(base)
    divisor = sp.Add(first, sp.Mul(second, of, evaluate=False), evaluate=False)
    quotient = sp.Pow(divisor, -1, evaluate=False)
    if sp.expand(first**2 - second**2 * base) == 0:
        with pytest.raises((Unsupported, Undefined)):
            is_zero(quotient)
    else:
        assert not is_zero(quotient)


def test_a_denominator_that_is_the_prime_is_refused():
    prime = next(p for p in range(2**61 + 1, 2**61 + 10_000, 4) if sp.isprime(p))
    for number in (Rational(1, prime), Rational(1, 2**61 - 1)):
        with suppress(Unsupported):
            assert not is_zero(1 / (sqrt(x) + number))


@pytest.mark.parametrize(
    "divisor",
    [
        ABSOLUTE,
        ABSOLUTE - y - 1,  # its product with the conjugate is 2 y + 1, up to the sign
        root(2) * root(3) - root(6) + 1,
        root(4) - 3,
        sum(sqrt(x + k) for k in range(6)),
        cos(pi / 1009) + sqrt(x),
        sqrt(1 + sqrt(1 + sqrt(x))) - x,
        x ** (d + Rational(1, 2)) - x**d,
    ],
)
def test_division_by_what_no_value_of_a_root_makes_zero_is_allowed(divisor):
    assert not is_zero(5 / divisor)
    assert is_zero((x + 1) ** 2 / divisor - (x**2 + 2 * x + 1) / divisor)


def test_a_root_whose_base_is_made_of_a_symbolic_power_is_reduced_first():
    # the base is a quotient of y^(x + 1/2) and of the root of y, which has a relation, too
    of = sqrt(y**x + 1)
    zero = ((of + 1) * (of - 1)) ** 2 * y - y ** (2 * x + 1)
    assert is_zero((y ** (x + Rational(1, 2)) + 1) * zero)


def test_a_base_that_is_zero_by_the_relations_of_its_roots_is_refused():
    zero = (ABSOLUTE - y) * (ABSOLUTE + y)
    with pytest.raises(Unsupported, match="which is zero"):
        is_zero(zero**d - 2 * zero**d)


@pytest.mark.parametrize(
    "expr",
    [
        sp.Derivative(H(x), x),
        sp.oo * x,
        sp.nan,
        sp.zoo,
        x + sp.Float("0.1"),
        exp(exp(x)),
        exp(1 / (x + I)),
        re(z, evaluate=False),
    ],
)
def test_what_is_not_known_is_refused(expr):
    with pytest.raises(Unsupported):
        is_zero(expr)


# -- soundness on random expressions ------------------------------------------------------

LEAVES = st.sampled_from(
    [
        x,
        y,
        I,
        sp.S(2),
        Rational(1, 3),
        sin(x),
        cos(y),
        exp(I * x),
        exp(-y / 2),
        sin((d + 1) * x),
        z**d,
        z ** (d + 1),
        sqrt(y),
        exp(I * pi * x / 3),
        sinh(x / 2),
    ]
)
AT = [
    {x: Rational(7, 5), y: Rational(3, 7), d: Rational(5, 4), z: Rational(4, 3)},
    {x: Rational(-9, 8), y: Rational(11, 4), d: Rational(2, 9), z: Rational(1, 6)},
]


def joined(children):
    pairs = st.tuples(children, children)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        pairs.map(lambda p: p[0] / (3 + p[1] ** 2)),
        children.map(lambda e: e**2 - e),
    )


EXPRESSIONS = st.recursive(LEAVES, joined, max_leaves=5)
# SymPy's own rewritings, which share nothing with the normal form
REWRITES = st.sampled_from(
    [
        sp.expand,
        sp.expand_trig,
        sp.together,
        sp.factor_terms,
        lambda e: e.rewrite(cos),
        lambda e: e.rewrite([sin, cos, sinh], exp),
        lambda e: sp.expand(e, trig=True),
    ]
)


def value(expr, at):
    with mpmath.workdps(50):
        return complex(sp.sympify(expr).subs(at).evalf(40))


@settings(max_examples=60, deadline=None, derandomize=True)
@given(EXPRESSIONS, REWRITES)
def test_rewritten_expression_is_the_same(expr, rewrite):
    assume(not expr.has(sp.nan, sp.zoo))
    assert is_zero(expr - rewrite(expr))


@settings(max_examples=80, deadline=None, derandomize=True)
@given(EXPRESSIONS, EXPRESSIONS, REWRITES, st.sampled_from([0, 1, Rational(1, 10**9)]))
def test_nothing_that_differs_is_called_zero(one, other, rewrite, shift):
    assume(not one.has(sp.nan, sp.zoo) and not other.has(sp.nan, sp.zoo))
    for difference in (one - other, one - rewrite(one) + shift * other):
        try:
            claimed = is_zero(difference)
        except Undefined:
            continue
        # 40 digits are computed; a true zero leaves less than 1e-20 of the parts' size,
        # and a false one at least about 1e-9 of it
        size = 1 + max(abs(value(one, at)) + abs(value(other, at)) for at in AT)
        if any(abs(value(difference, at)) > 1e-20 * size for at in AT):
            assert not claimed
