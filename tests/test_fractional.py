"""Fractional delay: the delayed device by SciPy's matrix exponential, roots by NumPy, and mutants.

Nothing here uses the modified z-transform: the loop is simulated as a state equation in which the
force changes inside the period, and its eigenvalues are the characteristic roots.
"""

from fractions import Fraction
from importlib import import_module

import numpy as np
import pytest
import sympy as sp
from scipy.linalg import expm

from symhaptic.book.chapters import BadChapter, folder, run
from symhaptic.book.report.breaking import pieces
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL
from symhaptic.numeric.passivity import passivity_margin

RNG = np.random.default_rng(37)
GAMMA, DELTA, PART = sp.symbols("gamma delta epsilon")


def motion(gamma, delta, time):
    """exp(A t) and its integral over the input, from one matrix exponential."""
    block = np.zeros((3, 3))
    block[0, 1], block[1] = 1, [-gamma, -delta, 1]
    found = expm(block * time)
    return found[:2, :2], found[:2, 2]


def loop(alpha, beta, gamma, delta, whole, part):
    """One period of the closed loop; state: x, v, the sample before, the forces under way."""
    rest, held = motion(gamma, delta, 1 - part)
    early, first = motion(gamma, delta, part)
    size = 3 + whole + 1
    step = np.zeros((size, size))
    force = np.zeros(size)  # of the newest sample, x_k, and of the one before
    force[0], force[2] = -(alpha + beta), beta
    queue = [force, *np.eye(size)[3:]]  # of the samples k, k-1, ..., k-whole-1
    step[:2, :2] = rest @ early
    step[:2] += np.outer(rest @ first, queue[whole + 1]) + np.outer(held, queue[whole])
    step[2, 0] = 1
    step[3:] = queue[: whole + 1]
    return step


def numbers(gamma, delta, part):
    """m2, m1, m0, a, e from the model."""
    device = fractional.late(plant.normalised(FULL))
    values = {GAMMA: sp.Float(gamma, 30), DELTA: sp.Float(delta, 30), PART: sp.Float(part, 30)}
    exact = (device.m2, device.m1, device.m0, device.device.a, device.device.e)
    return [complex(x.subs(values).evalf(30)).real for x in exact]


def polynomial(alpha, beta, gamma, delta, whole, part):
    """z^(l+2) A + M ((alpha+beta) z - beta), highest power first."""
    m2, m1, m0, a, e = numbers(gamma, delta, part)
    p = np.concatenate([[1, -a, e], np.zeros(whole + 2)])
    p[-4:] += np.convolve([m2, m1, m0], [alpha + beta, -beta])
    return p


CASES = [(0.7, 0.3, 0, 0.5), (2.0, 4.0, 1, 0.25), (9.0, 0.02, 2, 0.9), (0.001, 0.02, 0, 0.1)]


@pytest.mark.parametrize(("gamma", "delta", "whole", "part"), CASES)
def test_polynomial_is_that_of_the_simulated_loop(gamma, delta, whole, part):
    for _ in range(3):
        alpha, beta = RNG.normal(size=2)
        step = loop(alpha, beta, gamma, delta, whole, part)
        # the coefficients of a determinant of this size, from eigenvalues: some 1e-13
        assert np.allclose(
            np.poly(step), polynomial(alpha, beta, gamma, delta, whole, part), atol=1e-11, rtol=0
        )


@pytest.mark.parametrize(("gamma", "delta", "whole", "part"), CASES)
def test_each_point_of_the_explicit_boundary_has_a_root_on_the_circle(gamma, delta, whole, part):
    m2, m1, m0, a, e = numbers(gamma, delta, part)
    for theta in RNG.uniform(0.2, 3.0, size=20):
        z = np.exp(1j * theta)
        q = -(z ** (whole + 1)) * (z**2 - a * z + e) / (m2 * z**2 + m1 * z + m0)
        beta = q.imag / np.sin(theta)
        alpha = q.real - beta * (1 - np.cos(theta))
        roots = np.linalg.eigvals(loop(alpha, beta, gamma, delta, whole, part))
        # a simple root of a matrix with entries up to some 100
        assert np.abs(roots - z).min() < 1e-9


def largest(*arguments):
    return np.abs(np.linalg.eigvals(loop(*arguments))).max()


def substituted(alpha, beta, gamma, delta, r, q):
    """Roots of the paper's polynomial in zeta = z^(1/q) for d = r/q."""
    phi, push = motion(gamma, delta, 1.0)
    top = [push[0], phi[0, 1] * push[1] - phi[1, 1] * push[0]]
    p = np.zeros(3 * q + r + 1)
    for i, value in enumerate([1, -np.trace(phi), np.linalg.det(phi)]):
        p[-1 - (q * (3 - i) + r)] += value
    for i, value in enumerate(np.convolve(top, [alpha + beta, -beta])):
        p[-1 - q * (2 - i)] += value
    return np.roots(p)


def principal(*arguments):
    roots = substituted(*arguments)
    return np.abs(roots[np.abs(np.angle(roots)) < np.pi / arguments[-1]]).max()


@pytest.mark.parametrize("q", [2, 4])
def test_to_the_letter_only_walls_below_the_spring_are_stable(q):
    """fractional-literal: |alpha| < gamma, and for a creeping device without beta no less."""
    gamma, delta = 1.0, 3.0
    for r in range(1, 2 * q, 2):
        for _ in range(300):
            alpha, beta = RNG.uniform(-2, 2, size=2)
            if np.abs(substituted(alpha, beta, gamma, delta, r, q)).max() < 1:
                assert abs(alpha) < gamma
        for alpha in (0.99, -0.99):
            assert np.abs(substituted(alpha, 0, gamma, delta, r, q)).max() < 1


def test_walls_on_which_the_readings_differ():
    """s6c: (1/15, 16/15) for the free mass; s6h: (-3/4, -1/2) and (3/8, -5/8) times 4 pi^2/9."""
    assert largest(1 / 15, 16 / 15, 0, 0, 0, 0.5) > 1.001
    assert principal(1 / 15, 16 / 15, 0, 0, 1, 2) < 0.9995
    spring = 4 * np.pi**2 / 9
    for x, y, stable in ((-0.75, -0.5, False), (0.375, -0.625, True)):
        assert (largest(x * spring, y * spring, spring, 0, 0, 0.5) < 1) == stable
        assert (principal(x * spring, y * spring, spring, 0, 1, 2) < 1) != stable


def test_half_a_period_late_the_free_mass_is_stable_where_the_paper_says_so_or_less():
    """fractional-half-mass, on 4000 random walls for d = 1/2 and 3/2."""
    for whole in (0, 1):
        found = 0
        for _ in range(2000):
            alpha, beta = RNG.uniform(0, 0.6), RNG.uniform(0, 1.3)
            if largest(alpha, beta, 0, 0, whole, 0.5) < 1:
                found += 1
                assert principal(alpha, beta, 0, 0, 2 * whole + 1, 2) < 1
        assert found > 20
    # on the ray of the paper's boundary at theta, the true one lies at 2 c/(1 + c^2)
    theta = 0.7
    c = np.cos(theta / 2)
    half = np.tan(theta / 2)
    wall = np.array([4 * half**2 * np.cos(1.5 * theta), 2 * half * np.sin(theta) / c])
    share = 2 * c / (1 + c**2)
    assert largest(*(0.999 * share * wall), 0, 0, 0, 0.5) < 1
    assert largest(*(1.001 * share * wall), 0, 0, 0, 0.5) > 1


def test_passive_walls_are_stable_for_every_spring():
    """fractional-passive-is-stable, on walls that need at most 0.97 of the damping."""
    found = 0
    for _ in range(400):
        delta, delay = RNG.uniform(0.05, 2), RNG.uniform(0, 3)
        alpha, beta = RNG.uniform(0, 2) * delta, RNG.uniform(-1, 1.4) * delta
        if passivity_margin(alpha, beta, delta, delay) < 0.03 * delta:
            continue
        found += 1
        whole = int(delay)
        for gamma in (1e-3, RNG.uniform(0, 12)):
            assert largest(alpha, beta, gamma, delta, whole, delay - whole) < 1
    assert found > 50


# -- mutants -------------------------------------------------------------------------------


def changed(name, change):
    """A function of the model with its value changed."""
    original = getattr(fractional, name)
    return name, lambda *a, **k: change(original(*a, **k))


def late_with(**change):
    def other(value):
        return fractional.Late(
            **{**{n: getattr(value, n) for n in ("m2", "m1", "m0", "device")}}
            | {n: f(value) for n, f in change.items()}
        )

    return changed("late", other)


MUTANTS = [
    ("s6a_fractional_plant", late_with(m0=lambda v: -v.m0)),
    ("s6a_fractional_plant", late_with(m2=lambda v: v.m0, m0=lambda v: v.m2)),
    ("s6a_fractional_plant", late_with(m1=lambda v: v.m1 / 2)),
    ("s6b_fractional_stability", late_with(m1=lambda v: v.m1 + v.m0)),
    ("s6b_fractional_stability", changed("characteristic", lambda p: p * sp.Symbol("z"))),
    ("s6c_half_a_period", late_with(m2=lambda v: v.m0)),
    ("s6d_fractional_passivity", changed("stiffness_squared", lambda s: s + sp.Symbol("K"))),
    ("s6d_fractional_passivity", changed("energy_form", lambda m: m.applyfunc(lambda x: 2 * x))),
    ("s6d_fractional_passivity", changed("margin", lambda m: m.subs(PART, PART / 2))),
    ("s6e_fractional_region", changed("margin", lambda m: m.subs(sp.Symbol("l"), 0))),
    ("s6e_fractional_passive_is_stable", late_with(m0=lambda v: 2 * v.m0)),
    ("s6f_half_a_period_passive", changed("margin", lambda m: m - sp.Symbol("B") ** 2 / 16)),
    ("s6f_stiffest_passive_wall", changed("margin", lambda m: m.subs(PART, PART / 2))),
    ("s6g_next_whole_delay", changed("margin", lambda m: m.subs(PART, 1 - PART))),
    ("s6h_fractional_readings", changed("characteristic", lambda p: p + 1)),
]


@pytest.mark.parametrize(("chapter", "mutant"), MUTANTS)
def test_a_chapter_on_a_changed_model_fails(chapter, mutant, monkeypatch):
    import_module("symhaptic.book.lemmas.late_passivity")  # made of the model, once: of this one
    monkeypatch.setattr(fractional, *mutant)
    with pytest.raises(BadChapter, match=r"step|false|undecided|is not"):
        run(folder() / f"{chapter}.py")


# -- what the chapters lean on -------------------------------------------------------------


def test_a_product_of_two_sums_keeps_its_brackets_when_broken():
    x, y = sp.symbols("x y")
    long = sum(sp.Symbol(f"a_{i}") for i in range(20))
    first = pieces((x - y) * long, 20.0)[0]
    assert first.startswith(("(x-y)", "(-y+x)"))


def test_the_energy_of_the_model_is_that_of_the_motion():
    """The form against a finite motion, summed by hand in exact arithmetic: d = 5/4."""
    stiffness, damping, b, part, whole = Fraction(3, 5), Fraction(1, 7), 1, Fraction(1, 4), 1
    count = 12
    first = [Fraction(int(n), 8) for n in RNG.integers(-8, 9, size=count)]
    second = [Fraction(int(n), 8) for n in RNG.integers(-8, 9, size=count - 1)]
    second.append(-sum(first) - sum(second))  # comes back
    place, force, energy = [Fraction(0)], [Fraction(0)] * (whole + 1), Fraction(0)
    for k in range(count + whole + 2):
        p, q = (first[k], second[k]) if k < count else (0, 0)
        before = place[-2] if k else Fraction(0)
        force.append(stiffness * place[-1] + damping * (place[-1] - before))
        energy += force[k] * p + force[k + 1] * q + b * (p**2 / part + q**2 / (1 - part))
        place.append(place[-1] + p + q)
    # Parseval on a fine circle: the terms are trigonometric polynomials of low order
    angles = 2 * np.pi * (np.arange(400) + 0.5) / 400
    names, given = sp.symbols("K B b T epsilon l"), (stiffness, damping, b, 1, part, whole)
    values = zip(names, given, strict=True)
    symbolic = fractional.energy_form().subs({name: sp.S(value) for name, value in values})
    form = sp.lambdify(sp.Symbol("theta"), list(symbolic))
    total = 0.0
    for theta in angles:
        z = np.exp(1j * theta)
        powers = z ** -np.arange(count)
        p, q = np.dot(np.array(first, float), powers), np.dot(np.array(second, float), powers)
        # while a force is held: first q of a period, then p of the next
        held = q + z * p
        off = q - (1 - float(part)) * held
        entries = np.array(form(theta)).reshape(2, 2)
        vector = np.array([held, off])
        total += float((vector.conj() @ entries @ vector).real) / len(angles)
    assert total == pytest.approx(float(energy), rel=1e-9)
