"""The chapters on Jury's inequalities, beside eigenvalues of loops that SciPy discretised."""

import numpy as np
import pytest
import sympy as sp
from chapters import run_altered
from scipy.signal import cont2discrete

from symhaptic.book.chapters import BadChapter, Chapter, folder, run
from symhaptic.book.page import Page
from symhaptic.book.report.printed import chapter_tex
from symhaptic.model import jury


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


def explicit(damping, delta):
    """alpha_0 of the chapter on walls without delay."""
    n1, n0, _, _ = plant(0.0, delta)
    return (n1 + n0) * (damping + delta) * (1 - n0 * damping) / (n0 * (1 + n1 * damping))


@pytest.mark.parametrize("delta", [1e-3, 0.02, 0.1, 1 / 3])
def test_undelayed_mass_with_a_damper(delta):
    numbers = plant(0.0, delta)
    for share in np.linspace(0.02, 0.98, 25):
        damping = -delta + share * (1 / numbers[1] + delta)
        most = explicit(damping, delta)
        for stiffness in (1e-4 * most, 0.5 * most, 0.9999 * most):
            assert largest_root(0, stiffness, damping, numbers) < 1
        for stiffness in (-0.01, 1.0001 * most, 3 * most):
            assert largest_root(0, stiffness, damping, numbers) > 1
    for damping in (-1.1 * delta, -delta - 1, 1.01 / numbers[1], 5 / numbers[1]):
        for stiffness in 10 ** np.linspace(-5, 3, 60):
            assert largest_root(0, stiffness, damping, numbers) > 1


def test_in_physical_units():
    """m = 0.1 kg, b = 0.4 Ns/m, T = 1 ms, B = 60 Ns/m: K of the chapter, from its own formula."""
    m, b, T, B = 0.1, 0.4, 1e-3, 60.0
    x = b * T / m
    kept = m - (m + b * T) * np.exp(-x)
    most = b * (b + B) * (1 - np.exp(-x)) / kept
    most *= (b**2 * T - kept * B) / (b**2 * T + (b * T - m + m * np.exp(-x)) * B)
    numbers = plant(0.0, x)
    for factor, inside in ((0.999, True), (1.001, False)):
        stiffness = factor * most * T**2 / m
        assert (largest_root(0, stiffness, B * T / m, numbers) < 1) == inside


def test_heavy_damping_needs_the_third_half_plane():
    """delta = 4.6: below alpha_0, and yet a root beyond -1."""
    numbers = plant(0.0, 4.6)
    assert explicit(8.0, 4.6) > 1.0
    assert largest_root(0, 1.0, 8.0, numbers) > 1


def test_undelayed_with_a_spring():
    """The curve alpha + gamma = (1 - n0 b)((n1 + n0) b + 1 - e + gamma n0)/(n0 (1 + n1 b))."""
    for gamma in (1e-3, 0.1, 1.0, 4.0):
        n1, n0, _, det = numbers = plant(gamma, 0.02)
        for damping in (0.01, 0.3, 1.0):
            curve = (1 - n0 * damping) * ((n1 + n0) * damping + 1 - det + gamma * n0)
            curve = curve / (n0 * (1 + n1 * damping)) - gamma
            assert abs(largest_root(0, curve, damping, numbers) - 1) < 1e-9


@pytest.mark.parametrize("damping", [0.01, 0.2, 0.41, 0.7, 0.82])
def test_free_mass_one_period_late(damping):
    square = damping**2 + 12
    most = (np.sqrt(square**2 + 16 * damping * (4 - 4 * damping - damping**2)) - square) / 4
    free = (0.5, 0.5, 2.0, 1.0)
    assert largest_root(1, 0.999 * most, damping, free) < 1
    assert largest_root(1, 1.001 * most, damping, free) > 1
    for outside in (-0.1, -3.0, 0.84, 2.0):
        for stiffness in 10 ** np.linspace(-4, 2, 40):
            assert largest_root(1, stiffness, outside, free) > 1


@pytest.mark.parametrize("place", ["halves", "bezoutian", "half_planes", "inner"])
def test_a_chapter_does_not_survive_a_changed_sign(monkeypatch, place):
    whole = getattr(jury, place)

    def negated(found):
        if isinstance(found, list):
            return [negated(part) for part in found]
        return tuple(map(negated, found)) if isinstance(found, tuple) else -found

    changed = {
        "halves": lambda rising: (whole(rising)[0], negated(whole(rising)[1])),
        "bezoutian": lambda f, g: negated(whole(f, g)),
        "half_planes": lambda rising: negated(whole(rising)),
        "inner": lambda falling, order: whole([*falling[:-1], -falling[-1]], order),
    }[place]
    monkeypatch.setattr(jury, place, changed)
    with pytest.raises(BadChapter):
        run(folder() / "s4d_jury.py")


def test_a_table_has_a_cell_under_each_head(tmp_path):
    page = Page("x")
    page.table("50% of $a_1$", ["$n$", "what"], [(1, "one & two"), (2, sp.Symbol("alpha") ** 2)])
    tex = chapter_tex(Chapter(tmp_path / "x.py", "X?", "", page, 0.0), 1)
    assert r"$n$ & what \\" in tex
    assert r"$1$ & one \& two \\" in tex
    assert r"$2$ & $\alpha^2$ \\" in tex
    assert r"50\% of $a_1$" in tex
    with pytest.raises(ValueError, match="table: 1 cells under 2 heads"):
        page.table("", ["a", "b"], [(1,)])


ALTERED = [
    # chapter, what is written, what a slip of the pen would make of it
    ("s4d_jury", "(a_3 + a_0) * (x - 1)", "(a_3 + a_0) * (x + 1)"),
    ("s4d_jury", "(a_4 - a_0) * x + a_3 - a_1", "(a_4 - a_0) * x + a_1 - a_3"),
    ("s4d_jury", "f[1] * g[0] - f[0] * g[1]", "f[1] * g[0] + f[0] * g[1]"),
    ("s4d_jury", "2 * (1 + s**2) / (1 - s**2)", "(1 + s**2) / (1 - s**2)"),
    ("s4d_jury", "range(1 + n % 2, n, 2)", "range(2 - n % 2, n, 2)"),
    ("s4d_jury_counted", "3 - a - e", "2 - a - e"),
    ("s4d_jury_counted", "n_1 - n_0 + a * n_0", "n_1 + n_0 + a * n_0"),
    ("s4d_jury_counted", "FREE, (25, -4)", "FREE, (23, -4)"),
    ("s4d_jury_counted", "1 - one * two", "1 + one * two"),
    ("s4d_jury_counted", "1 - middle + last", "1 + middle + last"),
    ("s4d_jury_explicit", "top = (1 - n_0 * beta)", "top = (1 + n_0 * beta)"),
    ("s4d_jury_explicit", "top / below))", "top / n_0))"),
    ("s4d_jury_explicit", "last = RISE * (beta + delta)", "last = RISE * (beta - delta)"),
    ("s4d_jury_explicit", "(2 - beta) - alpha", "(1 - beta) - alpha"),
    ("s4d_jury_explicit", "(delta - 1 + f) * beta", "(delta + 1 - f) * beta"),
    ("s4d_jury_explicit", "(b**2 * T - kept * B)", "(b * T - kept * B)"),
    ("s4d_jury_explicit", "2 * beta * (2 - beta) / (2 + beta)", "beta * (2 - beta) / (2 + beta)"),
    ("s4d_jury_implicit", "(low + a)", "(low - a)"),
    ("s4d_jury_implicit", "(1 - e) * n_0**2 * beta", "(1 + e) * n_0**2 * beta"),
    (
        "s4d_jury_implicit",
        "(4 - 4 * beta - beta**2) - (beta**2",
        "(4 - 4 * beta - beta) - (beta**2",
    ),
    ("s4d_jury_implicit", "sqrt(middle**2 + 16", "sqrt(middle**2 + 8"),
    ("s4d_jury_implicit", "Sampled(n_1, n_0, a, e)", "Sampled(n_1, n_0, e, a)"),
    ("s4d_jury_implicit", "boundary.wall(device)", "boundary.wall(device, delay=d + 1)"),
]


@pytest.mark.parametrize(("name", "written", "slip"), ALTERED)
def test_a_slip_of_the_pen_is_noticed(tmp_path, name, written, slip):
    with pytest.raises(BadChapter):
        run_altered(name, written, slip, tmp_path)
