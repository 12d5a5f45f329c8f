"""The sampled device, the normalisation and the polynomial: exponentials and eigenvalues."""

import mpmath
import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import counterexample, number, only, page, settled, shown, value
from scipy.integrate import solve_ivp
from scipy.linalg import expm
from scipy.signal import cont2discrete

from symhaptic.model import loop, plant
from symhaptic.model.parts import ALL, FULL
from symhaptic.notation import c

pytestmark = pytest.mark.ci

DEVICES = [(0.4, 3.0, 250.0, 2e-3), (2.0, 9.0, 10.0, 0.1), (0.02, 0.3, 900.0, 0.01)]
"""m, b, k and T: swinging, overdamped with a long period, and with a third of a swing."""

PLANTS = [(1e-3, 0.02), (2.0, 0.5), (0.1, 3.0), (9.0, 0.01)]
"""gamma and delta: an arm, a swing, overdamped, close to the Nyquist frequency."""


def split(gamma, delta):
    """c_1 of the print, to 50 digits."""
    return mpmath.sqrt(mpmath.mpf(delta) ** 2 - 4 * mpmath.mpf(gamma))


@guards("s4a_discretisation")
def test_the_discrete_equivalent_is_that_of_scipy():
    """eq12 as corrected, at a z, against SciPy's zero-order hold in SI units."""
    z = 1.3 + 0.8j
    found = []
    for m, b, k, T in DEVICES:
        top, bottom, _ = cont2discrete(([1.0], [m, b, k]), T, method="zoh")
        found.append(np.polyval(top[0], z) / np.polyval(bottom, z))

    def agrees(transfer):
        for (m, b, k, T), theirs in zip(DEVICES, found, strict=True):
            c_1 = split(k * T**2 / m, b * T / m)
            ours = complex(value(transfer, m=m, b=b, k=k, T=T, c_1=c_1, z=z))
            # rounding of an exponential whose entries are up to 1/m
            assert ours == pytest.approx(theirs, rel=1e-11)

    only(agrees, settled("s4a_discretisation", "eq12")[0].rhs, kept=("k",))


@guards("s4b_normalisation")
def test_the_plants_numbers_are_those_of_a_matrix_exponential():
    """n_1, n_0, a, e; then critical damping and no spring, where the print is 0/0."""

    def agrees(n1, n0, trace, product):
        for gamma, delta in PLANTS:
            numbers = {"gamma": gamma, "delta": delta, "c_1": split(gamma, delta)}
            half = [(-mpmath.mpf(delta) + s * numbers["c_1"]) / 2 for s in (-1, 1)]
            numbers["c_2"], numbers["c_3"] = (mpmath.exp(h) for h in half)
            for ours, theirs in zip(
                (n1, n0, trace, product), oracle.numbers(gamma, delta), strict=True
            ):
                # 60 digits, of which the print loses some where gamma is small
                assert abs(value(ours, **numbers) - theirs) < 1e-45

    first = shown("s4b_normalisation", "The first sample of the step response is $n_1$")
    second = shown("s4b_normalisation", "The second coefficient is $n_0$")
    images = shown("s4b_normalisation", "The images of the poles add up to $a$")
    product = shown("s4b_normalisation", "The two poles have the product $e$")
    only(agrees, first, second, images, product)

    for title, spring in (
        ("At critical damping ${}$ has this limit", 0.25),
        ("Without a spring ${}$ has this limit", 0.0),
    ):

        def agrees_there(n1, n0, spring=spring):
            for delta in (0.02, 0.5, 3.0):
                exact = oracle.numbers(spring * mpmath.mpf(delta) ** 2, delta)
                for ours, theirs in zip((n1, n0), exact, strict=False):
                    assert abs(value(ours, delta=delta) - theirs) < 1e-45

        only(
            agrees_there,
            *(shown("s4b_normalisation", title.format(name)) for name in ("n_1", "n_0")),
        )


@guards("s4b_normalisation")
def test_table_1_takes_the_same_motion_to_other_units():
    """The loop in SI units beside the loop in dimensionless numbers, sample by sample."""
    loops = [(0.4, 3.0, 250.0, 2e-3, 9e3, 30.0, 5e-3), (1.7, 26.0, 199.0, 1e-3, 8e3, 500.0, 0.0)]

    def agrees(delay, *rules):
        for m, b, k, T, K, B, t_d in loops:
            at = {"m": m, "b": b, "k": k, "T": T, "K": K, "B": B, "t_d": t_d}
            late = number(delay, **at)
            alpha, beta, gamma, delta = (number(rule, **at) for rule in rules)
            metres = motion.positions(K, B, m, b, k, T, t_d / T, speed=1 / T)
            units = motion.positions(alpha, beta, 1.0, delta, gamma, 1.0, late)
            # 200 steps, each with roundings of the largest position
            assert np.allclose(metres, units, rtol=0, atol=1e-10 * np.abs(units).max())

    only(agrees, *(line.rhs for line in settled("s4b_normalisation", "tab1")))


WALLS = [(0.3, 0.5, 0), (1.2, -0.4, 1), (-0.2, 0.1, 3)]


@guards("s4b_polynomial")
def test_the_polynomial_vanishes_at_the_eigenvalues():
    def agrees(polynomial):
        for gamma, delta in PLANTS:
            for alpha, beta, d in WALLS:
                at = {"alpha": alpha, "beta": beta, "d": d, **oracle.named(gamma, delta)}
                matrix = oracle.loops(alpha, beta, gamma, delta, d)
                characteristic = np.poly(matrix)
                for z in (0.4 + 0.9j, -1.2):
                    # coefficients of order 10 from eigenvalues of a matrix of order 6
                    found = np.polyval(characteristic, z)
                    assert complex(value(polynomial, z=z, **at)) == pytest.approx(found, abs=1e-12)

    only(
        agrees,
        shown("s4b_polynomial", "The characteristic polynomial has the leading coefficient 1"),
    )


@guards("s4b_polynomial")
def test_the_closed_loop_answers_to_a_force_as_its_states_do():
    """(16) as derived: position over external force, which enters like the wall's."""

    def agrees(transfer):
        for gamma, delta in PLANTS[:3]:
            for alpha, beta, d in WALLS:
                matrix = oracle.loops(alpha, beta, gamma, delta, d)
                push = np.zeros(len(matrix))
                push[:2] = oracle.sampled(gamma, delta)[1]
                z = 1.1 + 0.7j
                found = np.linalg.solve(z * np.eye(len(matrix)) - matrix, push)[0]
                at = {"gamma": gamma, "delta": delta, "c_1": split(gamma, delta), "z": z}
                at |= {"alpha": alpha, "beta": beta, "d": d, "T": 1, "m": 1}
                ours = complex(value(transfer, **at))
                assert ours == pytest.approx(found, rel=1e-11)

    only(agrees, settled("s4b_polynomial", "eq16")[0].rhs)


@guards("s4b_polynomial_degree")
def test_five_numbers_and_as_many_roots_as_states():
    for d in range(4):
        # position, velocity, the sample before, and d forces under way
        assert oracle.loops(0.3, 0.2, 0.1, 0.1, d).shape == (d + 3, d + 3)
    # any mass and any period, at the same five numbers
    alpha, beta, gamma, delta, d = 0.3, 0.5, 0.01, 0.02, 2.0
    here = motion.positions(alpha, beta, 1.0, delta, gamma, 1.0, d)
    for m, T in ((0.2, 1e-3), (7.0, 0.05)):
        wall, device = (alpha * m / T**2, beta * m / T), (delta * m / T, gamma * m / T**2)
        there = motion.positions(*wall, m, *device, T, d, speed=1 / T)
        assert np.allclose(there, here, rtol=0, atol=1e-11 * np.abs(here).max())
    assert not np.allclose(motion.positions(alpha, beta, 1.1, delta, gamma, 1.0, d), here)


@guards("s4b_polynomial")
@pytest.mark.parametrize("parts", ALL, ids=lambda parts: parts.name)
def test_each_scene_has_the_eigenvalues_of_a_loop_without_that_part(parts):
    gamma, delta = (1.3 if parts.stiffness else 0.0), (0.4 if parts.damping else 0.0)
    beta, d = (0.3 if parts.virtual_damping else 0.0), (2 if parts.delay else 0)
    at = {"alpha": 0.7, "beta": beta, "gamma": gamma, "delta": delta, "d": d}
    characteristic = np.poly(oracle.loops(0.7, beta, gamma, delta, d))

    def agrees(polynomial):
        for z in (0.4 + 0.9j, -1.2):
            # without virtual damping the state of the sample before is a root at 0
            found = np.polyval(characteristic, z) / (1 if parts.virtual_damping else z)
            assert complex(value(polynomial, z=z, **at)) == pytest.approx(found, abs=1e-12)

    only(agrees, loop.characteristic(parts))


@guards("s4b_polynomial")
def test_devices_without_spring_or_damper():
    z, cases = 0.3 + 1.1j, []
    for title, gamma, delta in (
        ("The four coefficients of a free mass are rational numbers", 0, 0),
        ("The coefficients of a damped mass contain one exponential", 0, 0.3),
    ):
        cases.append((title, gamma, delta, {"delta": delta}))
    cases.append(
        ("The coefficients of a mass on a spring contain one cosine", 1.69, 0, {"Omega": 1.3})
    )
    for title, gamma, delta, at in cases:
        n1, n0, a, e = (complex(n) for n in oracle.numbers(gamma, delta))
        found = (n1 * z + n0) / (z**2 - a * z + e)

        def agrees(transfer, found=found, at=at):
            # gamma = 1.69 and Omega = 1.3 differ by a rounding
            assert complex(value(transfer, z=z, **at)) == pytest.approx(found, rel=1e-14)

        only(agrees, shown("s4b_polynomial", title))
    least = shown("s4b_polynomial", "The smallest scene has a quadratic polynomial")

    def agrees_least(polynomial):
        roots = np.linalg.eigvals(oracle.loops(0.7, 0.0, 0.0, 0.0, 0))
        roots = roots[np.abs(roots) > 1e-8]
        assert all(abs(complex(value(polynomial, alpha=0.7, z=z))) < 1e-12 for z in roots)
        assert complex(value(polynomial, alpha=0.7, z=3)) == pytest.approx(np.prod(3 - roots))

    only(agrees_least, least)


# -- the sampling instants ------------------------------------------------------------------


@guards("s4a_instants")
def test_free_motion_and_the_effect_of_a_force_over_any_time():
    device = plant.normalised(FULL)

    def agrees(*entries):
        for gamma, delta in PLANTS:
            for t in (1, 2):
                state = np.array([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]])
                at = {"gamma": gamma, "delta": delta, "c": split(gamma, delta), "t": t}
                ours = [number(entry, **at) for entry in entries]
                assert ours == pytest.approx(expm(state * t)[:2].ravel(), rel=1e-11)

    move, push = device.transition(split=c), device.held(split=c)
    only(agrees, move[0, 0], move[0, 1], push[0], move[1, 0], move[1, 1], push[1])


@guards("s4a_instants")
def test_a_force_that_is_not_held_and_one_that_is_half_a_period_late():
    def agrees(ramp, late):
        moved = solve_ivp(lambda t, x: (x[1], t), (0, 1), (0.0, 0.0), rtol=1e-12, atol=1e-13)
        assert number(ramp) == pytest.approx(moved.y[0, -1], rel=1e-10)
        for d in (0.2, 0.5, 0.9):
            _, push = motion.held(1.0, 0.0, 0.0, 1 - d)
            assert number(late, d=d) == pytest.approx(push[0], rel=1e-12)

    titles = (
        "A force that grows in time, $F_E=t$, moves the mass by a sixth",
        "With a fractional delay a held force already moves the mass within the first period",
    )
    only(agrees, *(shown("s4a_instants", title) for title in titles))
    point = counterexample("s4a_instants", "s4a-exact-instants")
    first = motion.positions(1.0, 0.0, late=point["d"], steps=2, speed=1.0)[2] - 2
    # the wall has felt the sample 1, and its force -1 acts for the rest of the second period
    assert first == pytest.approx(-number(shown("s4a_instants", titles[1]), **point), rel=1e-12)


# -- seven parameters -----------------------------------------------------------------------

SI = {"T": 0.02, "m": 0.7, "t_d": 0.03, "K": 60.0, "B": 3.0, "k": 40.0, "b": 1.1}


def shape(parameters):
    """A loop's motion over its periods, in units of its first step."""
    *_, T, late = (parameters[n] for n in ("m", "b", "k", "T", "t_d"))
    device = {n: parameters[n] for n in ("m", "b", "k")}
    place = motion.positions(
        parameters["K"], parameters["B"], **device, T=T, late=late / T, steps=40
    )
    return place[2:] / place[1]


@guards("s4b_parameters_counted")
def test_a_motion_changes_with_five_of_seven_directions():
    """The slopes of a motion to the logarithms of the parameters, and what their tables say."""
    powers, chosen = (b.rows for b in page("s4b_parameters_counted").blocks if b.kind == "table")
    names = [name.strip("$") for name in powers[0][1:]]
    assert set(names) == set(SI)
    step, slopes = 1e-4, []
    for name in names:
        more, less = (shape({**SI, name: SI[name] * np.exp(s)}) for s in (step, -step))
        slopes.append((more - less) / (2 * step))
    sizes = np.linalg.svd(np.array(slopes), compute_uv=False)
    # the differences are off by the square of the step
    changing = int((sizes > 1e-5 * sizes[0]).sum())
    assert sizes[changing:].max() < 1e-6 * sizes[0]

    def agrees(rank, left):
        assert number(left) == changing
        assert number(rank) == len(names) - changing

    titles = (
        "The units of the seven parameters have rank two",
        "Five dimensionless numbers are independent",
    )
    only(agrees, *(shown("s4b_parameters_counted", title) for title in titles))
    units = np.array([row[1:] for row in powers[1:]], dtype=float)
    assert np.abs(units @ slopes).max() < 1e-6 * sizes[0]  # other units, the same motion
    # the numbers of Table I are constant where the motion is, and nowhere else
    five = np.array([row[1:] for row in chosen[1:]], dtype=float)
    _, _, free = np.linalg.svd(five)
    assert np.abs(free[5:] @ slopes).max() < 1e-6 * sizes[0]
    assert np.linalg.matrix_rank(five) == 5
