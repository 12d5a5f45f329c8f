"""Jury's inequalities against roots that are computed, and boundaries found by halving."""

from functools import cache
from itertools import combinations

import numpy as np
import oracle
import pytest
import sympy as sp
from oracles.guarding import guards
from oracles.search import edge
from oracles.subject import number, only, page, said, shown, solved

from symhaptic.model import jury

pytestmark = pytest.mark.ci

COUNTED, EXPLICIT, IMPLICIT = "s4d_jury_counted", "s4d_jury_explicit", "s4d_jury_implicit"


def polynomials(degree, count, rng):
    """Real polynomials, and whether all roots are inside: as many as not, most of them narrowly."""
    found = []
    for _ in range(count):
        pairs = rng.integers(0, degree // 2 + 1)
        roots = rng.uniform(0.2, 1, pairs) * np.exp(1j * rng.uniform(0, np.pi, pairs))
        real = rng.uniform(0.2, 1, degree - 2 * pairs) * rng.choice([-1, 1], degree - 2 * pairs)
        roots = np.concatenate([roots, roots.conj(), real])
        size = rng.uniform(0.8, 1.2)
        found.append((np.poly(roots * size / np.abs(roots).max()).real, size < 1))
    return found


@guards("s4d_jury")
@pytest.mark.parametrize("degree", [2, 3, 4, 5, 6])
def test_the_inequalities_hold_exactly_where_all_roots_are_inside(degree):
    falling = [sp.S.One, *sp.symbols(f"a_0:{degree}")[::-1]]
    function = sp.lambdify(falling[1:], jury.criterion(falling).expressions, "numpy")
    cases = polynomials(degree, 400, np.random.default_rng(51 + degree))
    values = [np.array(function(*p[1:])) for p, _ in cases]
    inside = np.array([stable for _, stable in cases])
    assert 0.2 < inside.mean() < 0.8
    assert np.array_equal([np.all(v > 0) for v in values], inside)
    # and not for one inequality less, were it the one at 1 or at -1, or the last
    count = len(values[0])
    planes = count - degree // 2
    for dropped in {0, planes - 1, count - 1}:
        fewer = [np.all(np.delete(v, dropped) > 0) for v in values]
        assert not np.array_equal(fewer, inside)


@guards("s4d_jury_counted")
def test_the_four_inequalities_without_delay_are_those_of_the_eigenvalues():
    """Walls beside the edges that eigenvalues show, found from a stable wall in 8 directions."""
    cases = []
    for gamma, delta in ((0.0, 0.02), (0.3, 0.1), (4.0, 0.5), (0.0, 4.6)):
        center = next(
            (a, b)
            for a in (0.05 + 0.1 * gamma, 0.5)
            for b in (0.3, 1.0, 0.0)
            if oracle.stable(a, b, gamma, delta, 0)
        )
        for direction in np.arange(8) * np.pi / 4:
            step = np.array([np.cos(direction), np.sin(direction)])

            def inside(r, step=step, center=center, device=(gamma, delta)):
                return oracle.stable(*(center + r * step), *device, 0)

            far = edge(0.0, next(r for r in 2.0 ** np.arange(-6, 8) if not inside(r)), inside)
            cases += [(center + r * far * step, gamma, delta, r < 1) for r in (0.98, 1.02)]

    def agrees(*expressions):
        for (alpha, beta), gamma, delta, stable in cases:
            at = {"alpha": alpha, "beta": beta, **oracle.named(gamma, delta)}
            assert all(number(e, **at) > 0 for e in expressions) == stable

    expressions = four()
    agrees(*expressions)
    for dropped in (0, 3):  # the other two are needed far away, see the next test
        with pytest.raises(AssertionError):
            agrees(*np.delete(expressions, dropped))


def four():
    """What is positive where a wall is stable without delay, as the chapter says."""
    claim = said(
        COUNTED, "Without delay a wall is stable if and only if four inequalities hold"
    ).conclusion
    return [right - left for left, right in (part.terms for part in claim.of[1].parts)]


@guards("s4d_jury_counted")
def test_none_of_the_four_is_idle_and_the_last_one_is_a_product_of_pairs():
    """The chapter's walls are unstable, though three of four inequalities hold."""
    walls = [(-1, 1, 0), (25, -4, 0), (1, 8, 4.6), (5, 1, 0)]
    for violated, (alpha, beta, delta) in enumerate(walls):
        at = {"alpha": alpha, "beta": beta, **oracle.named(0, delta)}
        signs = [number(expression, **at) > 0 for expression in four()]
        assert signs.index(False) == violated
        assert sum(signs) == 3
        assert not oracle.stable(alpha, beta, 0, delta, 0)
    rng = np.random.default_rng(52)

    def agrees(pairs):
        for _ in range(5):
            r = rng.uniform(-1.2, 1.2, size=3)
            p = np.poly(r)
            found = np.prod([1 - one * two for one, two in combinations(np.roots(p), 2)])
            at = dict(zip(("r_1", "r_2", "r_3"), r, strict=True))
            # roots of a cubic: nearly double ones lose half of the digits
            assert number(pairs, **at) == pytest.approx(found.real, abs=1e-6)
            a_2, a_1, a_0 = p[1:]
            (minor,) = (b.lines[0][2] for b in page(COUNTED).blocks if b.title == title)
            assert number(minor, a_0=a_0, a_1=a_1, a_2=a_2) == pytest.approx(found.real, abs=1e-6)

    title = "For degree 3 the last minor is a product over the roots"
    only(agrees, shown(COUNTED, title))
    head, *rows = next(b for b in page(COUNTED).blocks if b.kind == "table").rows
    for row in rows:
        d, count, planes = row[:3]
        # one more than the degree, of which half are minors; the first of them is linear for odd d
        assert (count, planes) == (d + 4, d + 4 - (d + 3) // 2 + d % 2)
    assert len(head) == len(rows[0])


@cache
def most(beta, gamma, delta, d, top=3.0):
    """Largest stable alpha of one beta, by halving."""
    return edge(1e-6 - gamma, top, lambda alpha: oracle.stable(alpha, beta, gamma, delta, d))


@guards("s4d_jury_explicit")
def test_explicit_solutions_without_delay_are_where_the_eigenvalues_leave():
    held = [(0.5, 0.3, 0.1), (0.2, 1.0, 0.02), (1.1, 0.05, 0.3)]

    def agrees(solved):
        for beta, gamma, delta in held:
            found = most(beta, gamma, delta, 0) + gamma
            at = {"beta": beta, "gamma": gamma, **oracle.named(gamma, delta)}
            assert number(solved, **at) == pytest.approx(found, rel=1e-10)

    title = "One stiffness makes the minor vanish, with any spring"
    only(agrees, solved(said(EXPLICIT, title).hypotheses, "alpha + gamma"))
    alone = [(0.5, 0.02), (1.3, 0.3), (-0.05, 0.2)]

    def agrees_alone(explicit):
        for beta, delta in alone:
            found = most(beta, 0, delta, 0)
            # the formula is exact; alpha by halving to some 1e-12
            assert number(explicit, beta=beta, delta=delta) == pytest.approx(found, abs=1e-11)

    only(agrees_alone, shown(EXPLICIT, "The largest stiffness without a spring is explicit"))

    def agrees_in_units(largest):
        m, T = 0.3, 2e-3
        for beta, delta in alone:
            found = most(beta, 0, delta, 0) * m / T**2
            at = {"B": beta * m / T, "b": delta * m / T, "m": m, "T": T}
            assert number(largest, **at) == pytest.approx(found, rel=1e-9)

    only(
        agrees_in_units,
        shown(
            EXPLICIT, "In physical units the largest stiffness depends on mass, damping and period"
        ),
    )

    def agrees_free(still):
        for beta in (0.3, 0.8, 1.7):
            assert number(still, beta=beta) == pytest.approx(most(beta, 0, 0, 0), rel=1e-10)

    only(agrees_free, shown(EXPLICIT, "Without damping the largest stiffness tends to a limit"))


@guards("s4d_jury_implicit")
def test_one_period_of_delay():
    held = [(0.3, 0.5, 0.2), (0.1, 0.1, 0.02)]

    def product(alpha, beta, gamma, delta):
        roots = np.linalg.eigvals(oracle.loops(alpha, beta, gamma, delta, 1))
        return np.prod([1 - one * two for one, two in combinations(roots, 2)]).real

    def agrees(minor):
        for beta, gamma, delta in held:
            alpha = most(beta, gamma, delta, 1)
            for a in (0.7 * alpha, alpha, 1.5 * alpha):
                at = {"alpha": a, "beta": beta, **oracle.named(gamma, delta)}
                # eigenvalues of a matrix of order 4, none of them double
                found = product(a, beta, gamma, delta)
                assert number(minor, **at) == pytest.approx(found, abs=1e-12)
            assert abs(found) > 1e-3 > 1e-9 > abs(product(alpha, beta, gamma, delta))

    only(
        agrees,
        shown(IMPLICIT, "For one period of delay the last minor is a difference of two products"),
    )
    alone = [(0.3, 0.2), (0.05, 0.02), (0.5, 0.1)]

    def agrees_alone(minor):
        for beta, delta in alone:
            alpha = most(beta, 0, delta, 1)
            for a in (alpha, 1.5 * alpha):
                at = {"alpha": a, "beta": beta, "delta": delta, **oracle.named(0, delta)}
                found = product(a, beta, 0, delta)
                assert number(minor, **at) == pytest.approx(found, abs=1e-12)

    only(agrees_alone, shown(IMPLICIT, r"The implicit condition is a quadratic in $\alpha$"))

    def agrees_free(explicit):
        for beta in (0.1, 0.4, 0.75):
            assert number(explicit, beta=beta) == pytest.approx(most(beta, 0, 0, 1), rel=1e-10)

    title = "The minor of a free mass vanishes at this stiffness with one period of delay"
    only(agrees_free, solved(said(IMPLICIT, title).hypotheses, "alpha"))
    assert not any(oracle.stable(a, 2 * np.sqrt(2) - 2, 0, 0, 1) for a in np.geomspace(1e-6, 1))
