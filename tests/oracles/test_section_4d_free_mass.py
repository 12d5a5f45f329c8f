"""A free or damped mass: walls by eigenvalues, largest stiffness by a search, long delays."""

import mpmath
import numpy as np
import oracle
import pytest
from oracles.guarding import guards
from oracles.search import edge, stiffest
from oracles.subject import decimals, meant, number, only, page, shown, value

pytestmark = pytest.mark.ci

MASS, EXTREMES, LONG = "s4d_free_mass", "s4d_free_mass_extremes", "s4d_free_mass_long_delay"
DAMPED = "s4d_mass_with_damper"


@guards("s4d_free_mass")
def test_walls_between_the_two_ends_of_the_first_arc_are_stable_and_no_others():
    """For each alpha two angles of the arc; eigenvalues within 2 per cent of their dampings."""

    def stable_between(stiffness, both, d):
        def at(formula, angle):
            return number(formula, tau=np.tan(angle / 2), theta=angle, d=d)

        end = np.pi / 2 / (d + 1)
        angles = np.linspace(0, end, 101)[1:]
        peak = max(angles, key=lambda angle: at(stiffness, angle))
        for share in (0.2, 0.6, 0.95):
            alpha = share * at(stiffness, peak)

            def stiffer(angle, alpha=alpha):
                return at(stiffness, angle) > alpha

            ends = (edge(peak, last, stiffer, steps=30) for last in (angles[0], end))
            low, high = ((at(both, angle) - alpha) / 2 for angle in ends)
            assert 0 < low < high
            for beta in np.linspace(0, 2.2 * np.tan(np.pi / 4 / (d + 1)), 40):
                stable = oracle.stable(alpha, beta, 0, 0, d)
                if 1.02 * low < beta < 0.98 * high:
                    assert stable
                elif not 0.98 * low < beta < 1.02 * high:
                    assert not stable

    def agrees(stiffness, both):
        for d in (1, 0, 2, 5):
            stable_between(stiffness, both, d)

    titles = ["On the boundary of a free mass the stiffness is a multiple of a cosine"]
    titles.append(r"On the boundary of a free mass $\alpha+2\beta$ is a multiple of a sine")
    only(agrees, *(shown(MASS, title) for title in titles), by=0.2)
    for d in (0, 1, 2, 5):
        assert not any(oracle.stable(-1e-3, beta, 0, 0, d) for beta in np.linspace(-2, 2, 21))


@guards("s4d_free_mass")
def test_how_the_two_roots_near_one_move():
    beta, step = 0.3, 1e-5

    def agrees(first, second):
        # differences of eigenvalues: of the order of the step, and rounding over its square
        near = [np.sort(oracle.moduli(0, b, 0, 0, 2))[-2] for b in (step, 2 * step)]
        assert (near[1] - near[0]) / step == pytest.approx(number(second), rel=1e-3)
        roots = [oracle.moduli(a, beta, 0, 0, 2).max() for a in (step, 2 * step)]
        assert (roots[1] - roots[0]) / step == pytest.approx(number(first, beta=beta), rel=1e-3)

    titles = (
        r"The first root near 1 moves inside as $\alpha$ grows",
        r"The second root near 1 moves inside as $\beta$ grows",
    )
    only(agrees, *(shown(MASS, title) for title in titles))


@guards("s4d_free_mass_extremes")
def test_the_largest_stiffness_by_a_search_with_eigenvalues():
    printed = decimals(EXTREMES, "Intervals contain the largest stable stiffnesses of a free mass")
    for d in (0, 1, 2, 4, 8):
        low, high = 0.02, 0.95 * 2 * np.tan(np.pi / 4 / (d + 1))
        found, _ = stiffest(0, 0, d, low, high, top=2.0)
        # the search ends where beta is 1e-7 off; a simple root crosses: 1e-12 of rounding
        assert found == pytest.approx(float(printed[d]), rel=1e-9)
    one = shown(EXTREMES, "Without delay the largest stiffness has a closed form")
    assert abs(value(one) - printed[0]) < 1e-23


@guards("s4d_free_mass_extremes")
def test_minimal_polynomials_have_these_roots():
    (polynomials,) = (
        b
        for b in page(EXTREMES).blocks
        if b.title == "The largest stiffnesses are algebraic, with these minimal polynomials"
    )
    printed = decimals(EXTREMES, "Intervals contain the largest stable stiffnesses of a free mass")
    for (_, _, polynomial), alpha in zip(polynomials.lines, printed, strict=True):
        # alpha is cut after 24 digits; the slopes are of the size of the coefficients
        size = max(abs(int(c)) for c in polynomial.as_poly().all_coeffs())
        assert abs(value(polynomial, rho=alpha / 4)) < 1e-22 * size


@guards("s4d_free_mass_extremes")
def test_the_largest_damping_of_a_free_mass():
    def agrees(damping):
        for d in (0, 1, 3, 7):
            beta = number(damping, d=d)
            # at alpha = 1e-6 the bound is lower by about that
            assert oracle.stable(1e-6, beta - 1e-4, 0, 0, d)
            assert not oracle.stable(1e-6, beta + 1e-4, 0, 0, d)

    title = r"The damping is largest at the end of the arc, where $\alpha=0$"
    only(agrees, shown(EXTREMES, title))


@guards("s4d_free_mass_long_delay")
def test_long_delays():
    """The largest (d+1)^2 alpha: at h = 0 and for small h by Newton's method on its slope."""
    angle, largest = decimals(LONG, "Intervals contain the angle and the height of the maximum")
    second, third = decimals(LONG, "Intervals contain the coefficients of the next terms")

    def top(h):
        """Largest 4 tan(h phi/2)^2 cos(phi)/h^2 over phi, from a wall with that root."""

        def scaled(phi):
            return oracle.wall(h * phi, 0, 0, 1 / h - 1, 80)[0] / h**2

        step = mpmath.mpf("1e-20")  # the slope is off by its square, 1e-40
        at = mpmath.findroot(lambda phi: scaled(phi + step) - scaled(phi - step), 1.0769)
        return scaled(at)

    found = mpmath.findroot(lambda x: mpmath.diff(lambda y: y**2 * mpmath.cos(y), x), 1.0769)
    assert 0 <= found - angle < 1e-24
    assert 0 <= found**2 * mpmath.cos(found) - largest < 1e-24
    with mpmath.workdps(80):
        h = mpmath.mpf("1e-4")
        exact = found**2 * mpmath.cos(found)
        rise = [(top(step) / exact - 1) / step**2 for step in (h, 2 * h)]
        a_4 = (rise[1] - rise[0]) / (3 * h**2)  # next: of the order of h^2
        a_2 = rise[0] - a_4 * h**2
        assert abs(a_2 - second) < 1e-14
        assert abs(a_4 - third) < 1e-7

    def agrees(first_factor, second_factor):
        assert abs(value(first_factor, phi=found) - second) < 1e-23
        assert abs(value(second_factor, phi=found) - third) < 1e-23

    only(
        agrees,
        shown(LONG, r"The coefficient of $h^2$ is $\varphi_*^2/6$"),
        shown(LONG, r"The coefficient of $h^4$ is rational in $\varphi_*^2$"),
    )


@guards("s4d_free_mass_long_delay")
def test_a_long_delay_by_eigenvalues():
    _, largest = map(
        float, decimals(LONG, "Intervals contain the angle and the height of the maximum")
    )
    second, third = map(
        float, decimals(LONG, "Intervals contain the coefficients of the next terms")
    )
    d = 30
    h = 1 / (d + 1)
    found, _ = stiffest(0, 0, d, 0.02, 0.05, top=0.01)
    # the series ends with h^6 = 1e-9; eigenvalues of a matrix of order 33
    series = largest * (1 + second * h**2 + third * h**4)
    assert found * (d + 1) ** 2 == pytest.approx(series, rel=1e-8)
    assert largest < found * (d + 1) ** 2 < largest * (np.tan(h * np.pi / 4) / (h * np.pi / 4)) ** 2
    assert found * (d + 1) ** 2 != pytest.approx(series - 0.01 * largest * second * h**2, rel=1e-8)


@guards("s4d_mass_with_damper")
def test_the_largest_stiffness_of_a_damped_mass_by_a_search():
    found = {delta: stiffest(0, delta, 0, 0.1, 1.6)[0] for delta in (0.02, 0.3, 1.0)}

    def agrees(formula):
        for delta, alpha in found.items():
            numbers = oracle.named(0, delta)
            assert number(formula, **numbers) == pytest.approx(alpha, rel=1e-10)

    only(agrees, meant(DAMPED, "The largest stable stiffness has a closed form"))


@guards("s4d_mass_with_damper")
def test_the_product_of_the_roots_bounds_the_damping():
    def agrees(product):
        for delta, beta in ((0.02, 1.2), (1.5, -0.7)):
            numbers = oracle.named(0, delta)
            found = -np.prod(np.linalg.eigvals(oracle.loops(0.2, beta, 0, delta, 0))).real
            assert number(product, beta=beta, **numbers) == pytest.approx(found, rel=1e-13)

    only(agrees, shown(DAMPED, r"The product of the three roots is $n_0\beta$"))
    for delta in (0.02, 0.5):
        limit = 1 / float(oracle.numbers(0, delta)[1])
        assert not any(oracle.stable(a, 1.001 * limit, 0, delta, 0) for a in np.geomspace(1e-6, 1))
    small = mpmath.mpf("1e-20")
    found = (1 / oracle.numbers(0, small, 100)[1] - 2) / small
    title = r"For small damping $1/n_0$ exceeds 2 by $\frac43\delta$"
    assert abs(value(shown(DAMPED, title)) - found) < 1e-18
