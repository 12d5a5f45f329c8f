"""Forms for computing: exponentials of matrices, sums of cosines, and numerical derivatives."""

from functools import cache

import mpmath
import oracle
import pytest
from mpmath import mpf
from oracles.guarding import guards
from oracles.subject import only, page, shown, value

from symhaptic.book.lemmas.renaming import definitions, explicit
from symhaptic.notation.proposition import conjuncts
from symhaptic.proof.theorems.judge import taken_apart

pytestmark = pytest.mark.ci

PLANTS = [(mpf("0.2"), mpf("1.3")), (mpf(2), mpf("0.5")), (mpf(9), mpf("0.05"))]
LATES = (mpf("0.1"), mpf("0.7"))
ANGLES = (mpf("0.2"), mpf("1.1"), mpf("2.6"))
WALLS = [(mpf("1.5"), mpf("0.4")), (mpf("0.3"), mpf(2))]


def agree(found, expected, digits=40):
    """To so many digits of fifty, without an imaginary part."""
    found = mpmath.mpmathify(found)
    size = abs(expected) + mpf(10) ** -10
    assert abs(found - expected) < size * mpf(10) ** -digits, (found, expected)


def split(gamma, delta):
    return mpmath.sqrt(delta**2 - 4 * gamma)


@cache
def computed(chapter, statement):
    """What is computed, by the equations that a statement claims, part by part."""
    claim = page(chapter).settled[statement].settlement.claim(())
    found = []
    for part in conjuncts(claim):
        _, given, then = taken_apart(part)
        names = definitions(given)
        found.append([explicit(x, *names).left for x in conjuncts(then) if hasattr(x, "left")])
    return found


# -- the device ----------------------------------------------------------------------------


def held(gamma, delta, span):
    """Motion over a span, and what a unit force does that is held."""
    state = mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]) * span
    moved = mpmath.expm(state, method="taylor")
    return moved[:2, :2], moved[:2, 2]


def numbers(gamma, delta):
    """The device's numbers, its values at 1 and -1, and the way by an impulse."""
    n_1, n_0, a, e = oracle.numbers(gamma, delta)
    ends = 1 - a + e, 1 + a + e, 1 - e, n_1 + n_0, n_1 - n_0
    return n_1, n_0, a, e, *ends, held(gamma, delta, 1)[0][0, 1]


def late(gamma, delta, part):
    """m_2, m_1 and m_0: the first three samples after one period's force, times A."""
    move, _ = held(gamma, delta, mpf(1))
    after, new = held(gamma, delta, 1 - part)
    second = move * new + after * held(gamma, delta, part)[1]
    third = move * second
    trace, product = move[0, 0] + move[1, 1], mpmath.det(move)
    m_1 = second[0] - trace * new[0]
    return new[0], m_1, third[0] - trace * second[0] + product * new[0]


DEFINED = {
    "The displacement under a force that is held for a period": 0,
    "The further displacement in the next period": 1,
    "The sum of the poles of the sampled device": 2,
    "The sum of both displacements": 7,
    "The denominator at $z=-1$": 5,
}


@guards("s9a_computed_device")
def test_functions_of_the_device_are_those_of_an_exponential():
    for title, place in DEFINED.items():

        def agrees(expr, place=place):
            for gamma, delta in PLANTS:
                at = {"c": split(gamma, delta), "gamma": gamma, "delta": delta}
                agree(value(expr, **at), numbers(gamma, delta)[place])

        only(agrees, shown("s9a_computed_device", title))


@guards("s9a_computed_device")
@pytest.mark.parametrize(
    ("statement", "places"),
    [
        ("computed-discretize", (0, 1, 2, 3)),
        ("computed-characteristic-polynomial", (0, 1, 2, 3)),
        ("computed-stability-conditions", (0, 1, 4, 6)),
    ],
)
def test_numbers_of_the_device_are_those_of_an_exponential(statement, places):
    (found,) = computed("s9a_computed_device", statement)
    for gamma, delta in PLANTS:
        for expr, place in zip(found, places, strict=False):
            at = {"c": split(gamma, delta), "delta": delta}
            agree(value(expr, **at), numbers(gamma, delta)[place])


@guards("s9a_computed_device")
def test_the_polynomial_vanishes_at_eigenvalues():
    """For d = 2, with the state matrix of the loop."""
    *_, polynomial = computed("s9a_computed_device", "computed-characteristic-polynomial")[0]
    gamma, delta, alpha, beta = 0.2, 1.3, 0.7, 0.4
    (matrix,) = oracle.loops([alpha], beta, gamma, delta, 2)
    at = {"c": split(mpf(gamma), mpf(delta)), "delta": delta, "alpha": alpha, "beta": beta}
    for root in mpmath.eig(mpmath.matrix(matrix.tolist()), left=False, right=False):
        if abs(root) > 1e-3:
            assert abs(value(polynomial, z=root, **at)) < 1e-12


@guards("s9a_computed_late_device")
@pytest.mark.parametrize("form", ["discretize-fractional", "unstable-roots", "is-stable"])
def test_the_late_device_is_that_of_two_exponentials(form):
    whole, parts = computed("s9a_computed_late_device", f"computed-{form}")
    for gamma, delta in PLANTS:
        at = {"c": split(gamma, delta), "delta": delta}
        for expr, expected in zip(whole, numbers(gamma, delta), strict=True):
            agree(value(expr, **at), expected)
        for part in LATES:
            m_2, m_1, m_0 = late(gamma, delta, part)
            sums = m_2 + m_1 + m_0, m_2 - m_1 + m_0
            expected = m_2, m_0, *sums, m_1, 2 * (m_2 - m_0), sums[1]
            for expr, number in zip(parts, expected, strict=True):
                agree(value(expr, epsilon=part, **at), number)


# -- the boundary --------------------------------------------------------------------------


def wall(theta, top, bottom, shift):
    """Two real equations for the wall -z^shift A/M at one angle."""
    z = mpmath.expj(theta)
    needed = -mpmath.expj(shift * theta) * mpmath.polyval(bottom, z) / mpmath.polyval(top, z)
    rows = mpmath.matrix([[1, 1 - mpmath.cos(theta)], [0, mpmath.sin(theta)]])
    return mpmath.lu_solve(rows, mpmath.matrix([needed.real, needed.imag]))


def cases():
    """Devices with an integer delay and behind one with a fraction: names, M, A, and the shift."""
    for gamma, delta in PLANTS:
        n_1, n_0, a, e = oracle.numbers(gamma, delta)
        own = {"a": a, "e": e}
        for delay in (0, 3):
            yield own | {"n_1": n_1, "n_0": n_0, "d": delay}, [n_1, n_0], [1, -a, e], delay, 0
            m = late(gamma, delta, LATES[1])
            names = dict(zip(("m_2", "m_1", "m_0"), m, strict=True))
            yield own | names | {"l": delay}, list(m), [1, -a, e], delay + 1, 1


@guards("s9b_computed_boundary")
def test_both_ways_to_compute_the_wall_solve_the_two_equations():
    found = computed("s9b_computed_boundary", "computed-stability-boundary")
    for at, top, bottom, shift, which in cases():
        for theta in ANGLES:
            expected = wall(theta, top, bottom, shift)
            for place, expr in enumerate(found[which]):
                agree(value(expr, theta=theta, **at), expected[place % 2])


@guards("s9b_computed_slope")
def test_the_slope_is_that_of_the_wall():
    searched, early, undelayed = computed("s9b_computed_slope", "computed-max-stable-stiffness")
    for at, top, bottom, shift, which in cases():
        for theta in ANGLES:

            def stiffness(x, given=(top, bottom, shift)):
                return wall(x, *given)[0]

            expected = mpmath.diff(stiffness, theta)
            if which:
                agree(value(*searched, theta=theta, **at), expected, digits=18)
            if which and at["l"] == 0:
                agree(value(*early, theta=theta, **at), expected, digits=18)
            if not which and at["d"] == 0:
                agree(value(*undelayed, theta=theta, **at), expected, digits=18)


# -- passivity -----------------------------------------------------------------------------


def need(theta, alpha, beta, delay):
    """Dirichlet's kernel as a sum of cosines."""
    kernel = mpf(1) / 2 + sum(mpmath.cos(k * theta) for k in range(1, delay + 1))
    return alpha * kernel - beta * mpmath.cos((delay + 1) * theta)


def margin(theta, alpha, beta, delta, delay, part):
    """delta^2 - delta n - epsilon (1 - epsilon) |H|^2/4, with H = alpha + beta (1 - 1/z)."""
    both = [need(theta, alpha, beta, delay + i) for i in (0, 1)]
    mean = (1 - part) * both[0] + part * both[1]
    size = abs(alpha + beta * (1 - mpmath.expj(-theta))) ** 2
    return delta**2 - delta * mean - part * (1 - part) * size / 4


@guards("s9c_computed_need")
def test_what_is_left_at_an_angle_is_a_sum_of_cosines():
    ((whole, mean, left, root),) = computed("s9c_computed_need", "computed-passivity-margin-at")
    part = LATES[1]
    for alpha, beta in WALLS:
        for theta in ANGLES:
            at = {"alpha": alpha, "beta": beta, "delta": 2, "theta": theta}
            late = {"l": 3, "epsilon": part, **at}
            needs = [need(theta, alpha, beta, delay) for delay in (3, 4)]
            agree(value(whole, d=3, **at), 2 - needs[0])
            agree(value(mean, **late), (1 - part) * needs[0] + part * needs[1])
            agree(value(left, **late), margin(theta, alpha, beta, 2, 3, part))
            agree(value(root, w=mpf("0.3"), **late), 0)  # of x^2 - w x - epsilon (1 - epsilon) s/4


@guards("s9c_computed_need")
def test_the_need_and_its_changes_are_those_of_sums_of_cosines():
    (found,) = computed("s9c_computed_need", "computed-passivity-margin")
    delay, part, delta = 2, LATES[1], mpf("1.7")
    for alpha, beta in WALLS:
        for psi in (angle / 2 for angle in ANGLES):

            def n(x, k=delay, of=(alpha, beta)):
                return need(2 * x, *of, k)

            def left(x, of=(alpha, beta)):
                return margin(2 * x, *of, delta, delay, part)

            def by_damping(b, of=alpha, x=psi):
                return margin(2 * x, of, b, delta, delay, part)

            expected = (
                n(psi),
                (1 - part) * n(psi) + part * n(psi, delay + 1),
                mpmath.diff(n, psi),
                left(psi),
                -mpmath.diff(left, psi),
                -mpmath.diff(by_damping, beta),
            )
            at = {"alpha": alpha, "beta": beta, "delta": delta, "l": delay, "epsilon": part}
            for expr, number in zip(found, expected, strict=True):
                agree(value(expr, psi=psi, **at), number, digits=18)


def touched(theta, delta, delay):
    """The wall whose need is delta at an angle and has no slope there, by two equations."""
    units = [(mpf(1), mpf(0)), (mpf(0), mpf(1))]
    level = [need(theta, *unit, delay) for unit in units]
    steep = [mpmath.diff(lambda x, u=unit: need(x, *u, delay), theta) for unit in units]
    return mpmath.lu_solve(mpmath.matrix([level, steep]), mpmath.matrix([delta, 0]))


@guards("s9c_computed_walls")
def test_the_passive_walls_solve_two_equations():
    (found,) = computed("s9c_computed_walls", "computed-passivity-boundary")
    stiffest, _ = computed("s9c_computed_walls", "computed-max-passive-stiffness")
    for delay in (1, 4):
        for share in ("0.2", "0.5", "0.9"):
            theta = mpf(share) * mpmath.pi / (delay + 1)
            expected = touched(theta, mpf(2), delay)
            for expr, number in zip(found, expected, strict=True):
                agree(value(expr, theta=theta, d=delay, delta=2), number, digits=18)
            if share == "0.5":
                for expr, number in zip(stiffest, expected, strict=True):
                    agree(value(expr, d=delay, delta=2), number, digits=18)
        around = [touched(theta + x, mpf(2), delay)[0]
                  for theta in [mpmath.pi / (2 * delay + 2)] for x in (-0.01, 0, 0.01)]  # fmt: skip
        assert around[1] == max(around)


@guards("s9c_computed_walls")
def test_the_stiffest_wall_at_a_fraction_is_where_an_angle_allows_least():
    """At the angle of the least stiffness, over all dampings, that the margin leaves."""
    _, found = computed("s9c_computed_walls", "computed-max-passive-stiffness")
    delay, part, delta = 2, LATES[1], mpf("1.7")

    def edge(theta, damping):
        """The stiffness at which the margin is 0: a quadratic in it."""
        at = [margin(theta, mpf(k), damping, delta, delay, part) for k in (-1, 0, 1)]
        square, slope = (at[0] + at[2]) / 2 - at[1], (at[2] - at[0]) / 2
        return (-slope - mpmath.sqrt(slope**2 - 4 * square * at[1])) / (2 * square)

    def best(theta):
        """The wall with the largest one over all dampings."""
        slope = lambda x: mpmath.diff(lambda y: edge(theta, y), x)  # noqa: E731
        damping = mpmath.findroot(slope, (mpf("0.1"), mpf(1)), solver="secant")
        return edge(theta, damping), damping

    turn = mpmath.pi / (2 * (delay + part + 1))
    least = mpmath.findroot(
        lambda t: mpmath.diff(lambda y: best(y)[0], t), (turn, turn * mpf("1.1")), solver="secant"
    )
    at = {"delta": delta, "l": delay, "epsilon": part}
    left, by_damping, slope, *computed_ = found
    for theta in (turn, least):
        agree(value(left, theta=theta, **at), mpf(0), digits=18)
        agree(value(by_damping, theta=theta, **at), mpf(0), digits=18)
        steep = mpmath.diff(lambda t: best(t)[0], theta)
        agree(value(slope, theta=theta, **at), steep, digits=12)
    stiffness, damping = best(least)
    for expr, number in zip(computed_, (stiffness, stiffness + 2 * damping), strict=True):
        agree(value(expr, theta=least, **at), number, digits=12)


@guards("s9c_computed_walls")
def test_the_linear_condition_is_met_by_slow_motions():
    found, *_ = computed("s9c_computed_walls", "computed-linear-limit")[0]

    def agrees(expr):
        for delay in (0, 3):
            alpha = value(expr, d=delay, beta=mpf("0.4"), delta=2)
            agree(need(mpf(10) ** -25, alpha, mpf("0.4"), delay), mpf(2))

    only(agrees, found)
