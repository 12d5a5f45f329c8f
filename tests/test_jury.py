"""Jury's inequalities beside roots: exact ones that were multiplied out, and NumPy's eigenvalues.

No reference comes from the package: polynomials are made of known roots, plants by SciPy, and
the matrices X - Y are typed from the textbook (Jury, Inners and Stability of Dynamic Systems).
"""

import json
import re
from fractions import Fraction
from functools import cache, reduce
from itertools import combinations
from math import prod
from operator import add, mul

import numpy as np
import pytest
import sympy as sp
from command import symhaptic as symhaptic_command
from scipy.signal import cont2discrete
from sympy.polys.matrices import DomainMatrix

import symhaptic
from symhaptic.model import jury
from symhaptic.model.plant import Sampled

DELAYS = range(9)
alpha, beta, n_1, n_0, a, e = NAMES = sp.symbols("alpha beta n_1 n_0 a e")


# -- polynomials with known roots ---------------------------------------------------------


def times(left, right):
    """The product of two polynomials, the highest power first."""
    out = [Fraction(0)] * (len(left) + len(right) - 1)
    for i, x in enumerate(left):
        for j, y in enumerate(right):
            out[i + j] += x * y
    return out


def made_of_roots(rng, degree, spread):
    """Coefficients of exact roots within ``spread`` of the circle, and whether all are inside."""
    polynomial, inside = [Fraction(1)], True
    while (left := degree - len(polynomial) + 1) > 0:
        size = 1 + spread * Fraction(int(rng.integers(-100, 21)), 100)
        if left >= 2 and rng.random() < 0.6:
            # z^2 - 2 c z + size^2 with |c| < size: a pair of modulus size
            c = size * Fraction(int(rng.integers(-99, 100)), 100)
            polynomial = times(polynomial, [1, -2 * c, size**2])
        else:
            polynomial = times(polynomial, [1, size * int(rng.choice([-1, 1]))])
        inside &= size < 1
    return polynomial, inside


@cache
def corpus(degree):
    """Polynomials of known roots: anywhere, near the circle, and very near."""
    rng = np.random.default_rng(degree)
    spreads = (Fraction(1), Fraction(1, 50), Fraction(1, 10**9))
    return [made_of_roots(rng, degree, spread) for spread in spreads for _ in range(30)]


def judged(polynomial):
    """Whether all inequalities hold."""
    exact = [sp.Rational(c.numerator, c.denominator) for c in polynomial]
    return all(bool(expr > 0) for expr in jury.criterion(exact).expressions)


@pytest.mark.parametrize("degree", range(1, 13))
def test_decides_polynomials_with_known_roots(degree):
    found = corpus(degree)
    assert {inside for _, inside in found} == {True, False}
    for polynomial, inside in found:
        assert judged(polynomial) == inside, polynomial


def test_ends_that_cancel():
    """z^4 - 1 and (z - 1/2)(z + 2)(z^2 + 1): a_n + a_0 = 0."""
    assert not judged([Fraction(c) for c in (1, 0, 0, 0, -1)])
    half = Fraction(1, 2)
    assert not judged(times(times([1, -half], [1, 2]), [1, 0, 1]))


# -- each inequality is needed --------------------------------------------------------------


def values(expressions, names, points):
    """Floating-point values of expressions, one row each."""
    known = dict(zip(names, points, strict=True))

    def value(expr):
        if expr not in known:
            if expr.is_Pow:
                known[expr] = value(expr.base) ** int(expr.exp)
            elif expr.is_Add or expr.is_Mul:
                known[expr] = reduce(add if expr.is_Add else mul, map(value, expr.args))
            else:
                known[expr] = float(expr)
        return known[expr]

    return np.array([value(expr) * np.ones_like(points[0]) for expr in expressions])


def violated_alone(expressions, names, points):
    """For each expression, how often it alone is clearly negative."""
    found = values(expressions, names, points)
    held = found > 0
    return [
        int(((row < -1e-6) & np.delete(held, i, axis=0).all(axis=0)).sum())
        for i, row in enumerate(found)
    ]


@pytest.mark.parametrize("degree", [2, 3, 4, 5, 6])
def test_without_any_one_an_unstable_polynomial_would_pass(degree):
    rng = np.random.default_rng(degree)
    names = sp.symbols(f"a_0:{degree}")[::-1]
    expressions = jury.criterion([sp.S.One, *names]).expressions
    assert len(expressions) == degree + 1
    points = rng.normal(size=(degree, 300_000)) * 10 ** rng.uniform(-1, 1, (degree, 300_000))
    assert min(violated_alone(expressions, names, points)) > 0


@pytest.mark.parametrize(
    "delay",
    [0, 1, pytest.param(2, marks=pytest.mark.slow), pytest.param(3, marks=pytest.mark.slow)],
)
def test_without_any_one_an_unstable_loop_would_pass(delay):
    """The device's numbers are any real numbers here, as the symbols are."""
    rng = np.random.default_rng(delay)
    expressions = jury.criterion(jury.coefficients(delay)).expressions
    assert len(expressions) == delay + 4
    size = 10 ** rng.uniform(-2, 1, (6, 400_000))
    points = size * rng.choice([-1, 1], (6, 400_000))
    assert min(violated_alone(expressions, NAMES, points)) > 0


def test_a_half_plane_between_is_needed():
    """Roots 2, 5/4, 3/5 and 0: p(1), p(-1), 1 - a_0 and the product over pairs are positive."""
    roots = [Fraction(2), Fraction(5, 4), Fraction(3, 5), Fraction(0)]
    polynomial = [Fraction(1)]
    for root in roots:
        polynomial = times(polynomial, [1, -root])
    at_one, between, at_minus_one, first, last = jury.criterion(
        [sp.Rational(c.numerator, c.denominator) for c in polynomial]
    ).expressions
    assert prod(1 - x * y for x, y in combinations(roots, 2)) > 0
    assert min(at_one, at_minus_one, first, last) > 0
    assert between < 0


# -- what the minors are ----------------------------------------------------------------


def proportional(one, other):
    """Whether two polynomials in one symbol are the same up to a positive number."""
    one, other = (sp.Poly(f, X).primitive()[1] for f in (one, other))
    return one == other


X = sp.Symbol("X")


@pytest.mark.parametrize("degree", range(2, 12))
def test_minors_are_jurys_inner_determinants(degree):
    """X is Toeplitz, Y Hankel: Jury's inners, orders n-1, n-3, ... by deleting the frame."""
    rng = np.random.default_rng(degree)
    falling = [sp.S.One, *(int(i) + int(j) * X for i, j in rng.integers(-9, 10, (degree, 2)))]
    rising = falling[::-1]
    order = degree - 1
    toeplitz = sp.Matrix(order, order, lambda i, j: falling[j - i] if j >= i else 0)
    below = [0] * (order - 1) + rising
    hankel = sp.Matrix(order, order, lambda i, j: below[i + j])
    matrix = toeplitz - hankel
    for minor in jury.criterion(falling).expressions[: -(degree // 2) - 1 : -1]:
        found = DomainMatrix.from_Matrix(matrix).convert_to(sp.ZZ[X]).det()
        assert proportional(minor, sp.ZZ[X].to_sympy(found))
        assert matrix.rows < 3 or jury.inner(falling, matrix.rows) == matrix
        matrix = matrix[1:-1, 1:-1]


# -- the loop ------------------------------------------------------------------------------


def plant(gamma, delta):
    """n_1, n_0, a and e of a unit mass with spring and damper, by SciPy's zero-order hold."""
    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    return top[0][1], top[0][2], -bottom[1], bottom[2]


def largest_root(delay, stiffness, damping, numbers):
    """Largest modulus of the roots of A z^(d+1) + (n1 z + n0)((alpha+beta) z - beta)."""
    n1, n0, trace, det = numbers
    polynomial = np.concatenate([[1, -trace, det], np.zeros(delay + 1)])
    polynomial[-3:] += np.convolve([n1, n0], [stiffness + damping, -damping])
    return np.abs(np.roots(polynomial)).max()


@pytest.mark.parametrize("delay", DELAYS)
def test_loops_beside_eigenvalues(delay):
    rng = np.random.default_rng(delay)
    loops, largest = [], []
    for _ in range(15):
        gamma, delta = 10 ** rng.uniform(-3, 1), rng.choice([0, 10 ** rng.uniform(-3, 0.7)])
        numbers = plant(gamma, delta)
        for _ in range(30):
            wall = 10 ** rng.uniform(-3, 1) / (delay + 1)
            stiffness = wall * rng.uniform(-0.5, 1)
            damping = wall * (delay + 1) * rng.uniform(-0.5, 2)
            loops.append((stiffness, damping, *numbers))
            largest.append(largest_root(delay, stiffness, damping, numbers))
    found = values([r.lhs for r in jury.inequalities(delay)], NAMES, np.array(loops).T)
    largest = np.array(largest)
    clear = np.abs(largest - 1) > 1e-5  # roots of multiplicity two are known to half the digits
    clear &= np.abs(found).min(axis=0) > 1e-9  # and a sum of some thousand terms is rounded
    assert ((found > 0).all(axis=0) == (largest < 1))[clear].all()
    assert (largest[clear] < 1).sum() > 10
    assert (largest[clear] > 1).sum() > 10


# -- the function itself -------------------------------------------------------------------


def test_a_device_with_a_symbol_of_its_own():
    own = jury.inequalities(1, Sampled(sp.Symbol("x"), sp.Symbol("x"), sp.S(2), sp.S.One))
    assert {s for r in own for s in r.free_symbols} == {alpha, beta, sp.Symbol("x")}


def test_numbers_alone():
    assert jury.criterion([1, 0, 0]).relations == ()
    assert sp.false in jury.criterion([1, 0, sp.Rational(3, 2)]).relations


def test_a_delay_of_another_integer_type():
    assert jury.inequalities(np.int64(2)) == jury.inequalities(2)


@pytest.mark.parametrize(
    ("delay", "word"), [(-1, "-1"), (0.5, "0.5"), ("2", "'2'"), (True, "True"), (None, "None")]
)
def test_a_delay_that_is_no_whole_number(delay, word):
    with pytest.raises(ValueError, match=r"delay: .*0, 1, 2") as wrong:
        jury.inequalities(delay)
    assert word in str(wrong.value)


@pytest.mark.parametrize(
    "coefficients",
    [[1], [-1, 2], [a, 1], [1, sp.sqrt(2)], [1, 0.5], [1, sp.exp(a)], [1, 1 / a], [0, 1]],
    ids=str,
)
def test_coefficients_that_are_not_allowed(coefficients):
    with pytest.raises(ValueError, match="coefficients"):
        jury.criterion(coefficients)


# -- the public function and the command ------------------------------------------------------


def schur_cohn(coefficients):
    """Whether all roots lie inside, by Schur's reduction in exact fractions, highest power first.

    p is replaced by (a_n p - a_0 p*)/z as long as |a_0| < |a_n|, where p* has the coefficients in
    the other order; Marden, Geometry of Polynomials, Section 42.
    """
    p = list(coefficients)
    while len(p) > 1:
        lead, last = p[0], p[-1]
        if abs(last) >= abs(lead):
            return False
        p = [lead * x - last * y for x, y in zip(p, reversed(p), strict=True)][:-1]
    return True


def exact_loop(delay, wall, device):
    """Coefficients of z^(d+1) (z^2 - a z + e) + (n_1 z + n_0)((alpha + beta) z - beta), by hand."""
    (right, up), (n1, n0, trace, loss) = wall, device
    p = [Fraction(1), -trace, loss, *[Fraction(0)] * (delay + 1)]
    for power, c in ((2, n1 * (right + up)), (1, n0 * (right + up) - n1 * up), (0, -n0 * up)):
        p[len(p) - 1 - power] += c
    return p


@pytest.mark.parametrize("delay", range(6))
def test_the_public_inequalities_beside_schurs_reduction(delay):
    """Exact fractions near a device of (23), walls on either side of the boundary."""
    found = [sp.lambdify(NAMES, p.lhs, [], cse=True) for p in symhaptic.jury(delay)]
    rng = np.random.default_rng(40 + delay)
    counts = {True: 0, False: 0}
    size = Fraction(1, 2 * delay + 1)
    for _ in range(40):
        wall = [size * Fraction(int(rng.integers(low, 100)), 60) for low in (-5, -20)]
        device = [
            Fraction(int(rng.integers(low, high)), 1000)
            for low, high in ((450, 500), (450, 500), (1900, 1999), (900, 999))
        ]
        inside = schur_cohn(exact_loop(delay, wall, device))
        counts[inside] += 1
        assert all(p(*wall, *device) > 0 for p in found) == inside, (wall, device)
    assert min(counts.values()) > 1


@pytest.mark.parametrize("delay", [0, 1, 2, 5, pytest.param(8, marks=pytest.mark.ci)])
def test_a_device_in_numbers_beside_eigenvalues(delay):
    rng = np.random.default_rng(delay)
    for gamma, delta in ((0.001, 0.02), (0.0, 0.0), (2.0, 0.3), (1.0, 2.0)):  # the last is critical
        conditions = symhaptic.jury(delay, gamma, delta)
        found = [sp.lambdify((alpha, beta), p.lhs, []) for p in conditions]
        for stiffness, damping in rng.uniform(-0.1, 1.0, (20, 2)) / (delay + 1):
            size = largest_root(delay, stiffness, damping, plant(gamma, delta))
            if abs(size - 1) > 1e-6:
                assert all(p(stiffness, damping) > 0 for p in found) == (size < 1)


def test_no_inequality_has_a_fraction_in_it():
    for delay in range(5):
        for relation in symhaptic.jury(delay):
            assert relation.rhs == 0
            polynomial = sp.Poly(relation.lhs, *NAMES)
            assert polynomial.domain == sp.ZZ


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        ((-1,), "delay"),
        ((1.5,), "delay"),
        ((0, 0.001), "delta"),
        ((0, -1.0, 0.0), "gamma"),
        ((0, float("nan"), 0.0), "gamma"),
        ((0, 0.0, float("inf")), "delta"),
    ],
)
def test_what_is_no_loop_is_refused_by_name(arguments, word):
    with pytest.raises(ValueError, match=f"^{word}: "):
        symhaptic.jury(*arguments)


def test_the_command_prints_what_the_function_returns(tmp_path):
    told = symhaptic_command("jury", 1, "--gamma", "1/1000", "--delta", "0.02")
    assert told.stdout.splitlines() == [str(p) for p in symhaptic.jury(1, 0.001, 0.02)]
    path = tmp_path / "two.json"
    assert symhaptic_command("jury", 2, "--format", "json", "-o", path).returncode == 0
    data = json.loads(path.read_text(encoding="utf-8"))
    assert data == {"delay": 2, "inequalities": [str(p) for p in symhaptic.jury(2)]}


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["1.5"], "DELAY: '1.5' is not an integer"),
        (["1", "--gamma", "0"], "--delta: is missing"),
        (["1", "--gamma", "-1", "--delta", "0"], "--gamma: -1.0 is not allowed; give finite"),
        (["1", "--gamma", "x", "--delta", "0"], "--gamma: 'x'"),
    ],
)
def test_the_command_refuses_in_one_line(arguments, words):
    run = symhaptic_command("jury", *arguments)
    assert (run.returncode, run.stdout) == (2, "")
    [line] = run.stderr.splitlines()
    assert words in line


# -- devices of any size ----------------------------------------------------------------------

BEYOND = [
    # a float next to 4 pi^2, of a device that swings once in a period: n_0 is 5e-34
    (4 * np.pi**2, 0.0, 0, 1e33, 1e34),
    (1.0, 1e20, 0, 1e45, 1e44),
    (1e15, 1.0, 0, 1e20, 1e20),
    (1e15, 1e70, 0, -1e20, 0.0),
    (0.0, 1e-300, 0, 0.0, -1e-300),
    (1e-300, 1e-300, 1, -1e-299, 0.0),
]


@pytest.mark.parametrize(("gamma", "delta", "delay", "K", "B"), BEYOND)
def test_a_small_coefficient_is_not_left_out(gamma, delta, delay, K, B):
    """Coefficients below 1e-50 were dropped, and with them what refuses large walls."""
    assert not symhaptic.is_stable(K, B, gamma, delta, delay)
    at = {alpha: sp.Rational(K), beta: sp.Rational(B)}
    assert not all(r.subs(at) for r in symhaptic.jury(delay, gamma, delta))


@pytest.mark.parametrize(
    ("gamma", "delta", "told"),
    [
        (1e300, 1.0, "gamma: 1e+300 is not allowed; give numbers 0 <= gamma <= 1e+15"),
        (1.0, 1e300, "delta: 1e+300 is not allowed; give numbers 0 <= delta <= 1e+70"),
        ("1 m", 0.0, "gamma: '1 m' is not allowed; give a number"),
        (0.0, np.array([1.0, 2.0]), "delta: array([1., 2.]) is not allowed; give finite numbers"),
        (0.0, 1j, "delta: 1j is not allowed; give finite numbers >= 0"),
        (0.0, None, "delta: is missing; give gamma and delta, or none"),
    ],
)
def test_a_device_that_is_none_is_refused_by_name(gamma, delta, told):
    """A spring of 1e300 left no inequality, so that each wall was stable."""
    with pytest.raises(ValueError, match=re.escape(told)):
        symhaptic.jury(1, gamma, delta)


def test_a_fraction_is_a_number():
    found = {symhaptic.jury(1, x, x) for x in (0.5, Fraction(1, 2), sp.Rational(1, 2))}
    assert len(found) == 1


def test_a_delay_that_takes_for_ever_is_refused_at_once():
    with pytest.raises(ValueError, match="delay: 10000 is not allowed; give at most 20 periods"):
        symhaptic.jury(10_000)
    for delay in ("10000", 5000 * "9"):
        run = symhaptic_command("jury", delay)
        assert (run.returncode, run.stdout, run.stderr.count("\n")) == (2, "", 1)
        assert run.stderr.startswith(f"symhaptic: error: DELAY: {delay[:9]}")
