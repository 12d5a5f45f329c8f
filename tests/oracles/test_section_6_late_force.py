"""A force that is late by a fraction: exponentials in two parts, energies, eigenvalues."""

import mpmath
import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.search import edge
from oracles.subject import number, only, said, shown, value

from symhaptic.book.lemmas.late_boundary import on_boundary
from symhaptic.book.lemmas.late_device import KINDS
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL
from symhaptic.notation import c

pytestmark = pytest.mark.ci

PLANTS = [(1e-3, 0.02), (2.0, 0.5), (0.1, 3.0), (9.0, 0.05)]
LATES = (0.1, 0.5, 0.8)


def split(gamma, delta):
    return mpmath.sqrt(mpmath.mpf(delta) ** 2 - 4 * mpmath.mpf(gamma))


def held(gamma, delta, span):
    """Motion over ``span`` periods and the effect of a unit force, in 60 digits."""
    state = mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]) * span
    moved = mpmath.expm(state, method="taylor")
    return moved[:2, :2], moved[:2, 2]


def numerator(gamma, delta, part):
    """m_2, m_1, m_0: the first three samples of the response to one period's force, times A."""
    gamma, delta, part = (mpmath.mpf(x) for x in (gamma, delta, part))
    move, _ = held(gamma, delta, mpmath.mpf(1))
    after, new = held(gamma, delta, 1 - part)
    _, old = held(gamma, delta, part)
    first = new
    second = move * first + after * old
    third = move * second
    trace, product = move[0, 0] + move[1, 1], mpmath.det(move)
    return (
        first[0],
        second[0] - trace * first[0],
        third[0] - trace * second[0] + product * first[0],
    )


def named(gamma, delta, part=None):
    found = oracle.named(gamma, delta)
    if part is not None:
        found |= dict(zip(("m_2", "m_1", "m_0"), numerator(gamma, delta, part), strict=True))
    return found


@guards("s6a_fractional_plant")
def test_the_coefficients_of_a_late_force_are_its_first_samples():
    device = fractional.late(plant.normalised(FULL), split=c)
    cases = [(g, f, late) for g, f in PLANTS for late in LATES]
    found = [numerator(*case) for case in cases]

    def agrees(*coefficients):
        for (gamma, delta, late), samples in zip(cases, found, strict=True):
            at = {"gamma": gamma, "delta": delta, "c": split(gamma, delta), "epsilon": late}
            for ours, theirs in zip(coefficients, samples, strict=True):
                assert abs(value(ours, **at) - theirs) < 1e-45

    only(agrees, device.m2, device.m1, device.m0)

    def agrees_free(*coefficients):
        for late in LATES:
            samples = numerator(0, 0, late)
            for ours, theirs in zip(coefficients, samples, strict=True):
                assert abs(value(ours, epsilon=late) - theirs) < 1e-45

    titles = (f"For the free mass $m_{i}$ is quadratic in the fraction" for i in (2, 1, 0))
    only(agrees_free, *(shown("s6a_fractional_plant", title) for title in titles))


@guards("s6a_fractional_plant")
def test_each_kind_of_device_answers_a_late_force_by_its_matrix_exponential():
    """The numbers that the theorem names for the four kinds, beside those of the exponential."""
    tried = ((2.0, 0.5), (0.0625, 0.5), (0.0, 0.7), (0.0, 0.0))
    for kind, (gamma, delta) in zip(KINDS, tried, strict=True):
        for late in LATES:
            at = {"gamma": gamma, "delta": delta, "epsilon": late}
            for claim in kind.definitions:
                at[claim.left.name] = value(claim.right, **at)
            found = [at[name] for name in ("m_2", "m_1", "m_0")]
            for ours, theirs in zip(found, numerator(gamma, delta, late), strict=True):
                assert abs(ours - theirs) < 1e-14


@guards("s6b_fractional_stability")
def test_the_polynomial_and_the_wall_that_a_root_needs():
    cases = [(0.3, 0.5, 0, 0.5), (1.2, -0.4, 1, 0.1), (-0.2, 0.1, 3, 0.8)]

    def agrees(polynomial, wanted):
        for gamma, delta in PLANTS[:3]:
            for alpha, beta, whole, part in cases:
                matrix = oracle.loops(alpha, beta, gamma, delta, whole + part)
                at = {"alpha": alpha, "beta": beta, "l": whole, **named(gamma, delta, part)}
                z = 0.4 + 0.9j
                found = np.polyval(np.poly(matrix), z)
                assert complex(value(polynomial, z=z, **at)) == pytest.approx(found, abs=1e-12)
                top = at["m_2"] * z**2 + at["m_1"] * z + at["m_0"]
                found = found / (z * complex(top))
                assert complex(value(wanted, z=z, **at)) == pytest.approx(found, rel=1e-10)

    titles = (
        r"The characteristic polynomial with a fractional delay has degree $\ell+4$",
        "A root determines one wall",
    )
    only(agrees, *(shown("s6b_fractional_stability", title) for title in titles))


@guards("s6b_fractional_stability")
def test_ends_and_sizes_of_the_fractional_polynomial():
    def agrees(at_one, at_minus_one, device, late, wall):
        for gamma, delta in PLANTS[1:3]:
            for part in LATES:
                at = {"alpha": 0.7, "beta": -0.2, "gamma": gamma, **named(gamma, delta, part)}
                matrix = oracle.loops(0.7, -0.2, gamma, delta, part)
                for z, ours in ((1, at_one), (-1, at_minus_one)):
                    found = np.linalg.det(z * np.eye(len(matrix)) - matrix)
                    assert number(ours, **at) == pytest.approx(found, abs=1e-12)
                z = mpmath.expj(1.1)
                parts = [z * z - at["a"] * z + at["e"]]
                parts.append(at["m_2"] * z**2 + at["m_1"] * z + at["m_0"])
                parts.append(0.7 * z + mpmath.mpf(-0.2) * (z - 1))
                for ours, theirs in zip((device, late, wall), parts, strict=True):
                    assert abs(value(ours, theta=1.1, **at) - abs(theirs) ** 2) < 1e-40

    titles = [
        r"For even $\ell$ the walls with a root at $-1$ lie on a second line",
        "The size of $A$ does not contain the delay",
        "The size of $M$ does not contain the delay either",
        "The size of the wall $W=(\\alpha+\\beta)z-\\beta$ is linear in $\\cos\\theta$",
    ]
    at_one = said("s6b_fractional_stability", r"A root at 1 means $\alpha=-\gamma$")
    only(
        agrees,
        at_one.conclusion.terms[1],
        *(shown("s6b_fractional_stability", title) for title in titles),
    )


@guards("s6b_fractional_stability")
def test_a_boundary_found_by_halving_fulfils_the_explicit_one():
    """Q = -z^(l+1) A/M at the angle of the eigenvalue that leaves; then both sides simulated."""
    for gamma, delta, late in ((0.0, 0.1, 0.3), (0.2, 0.3, 1.6), (1e-3, 0.02, 2.5)):
        alpha = edge(1e-3, 4.0, lambda a, rest=(0.25, gamma, delta, late): oracle.stable(a, *rest))
        roots = np.linalg.eigvals(oracle.loops(alpha, 0.25, gamma, delta, late))
        z = roots[np.abs(roots).argmax()]
        at = named(gamma, delta, late % 1)
        bottom, top = z * z - at["a"] * z + at["e"], at["m_2"] * z**2 + at["m_1"] * z + at["m_0"]
        q = complex(-(z ** (int(late) + 1)) * bottom / top)
        damping = q.imag / np.sin(np.angle(z))
        names = {
            "l": int(late),
            "theta": float(np.angle(z)),
            **{k: float(v) for k, v in at.items()},
        }
        found = [float(number(claim.right, **names)) for claim in on_boundary().of]
        # the theorem's form of the same
        assert found == pytest.approx([alpha, 0.25], abs=1e-9)
        # a root to 1e-13 from halving, and the slope of Q
        assert damping == pytest.approx(0.25, abs=1e-9)
        assert q.real - damping * (1 - z.real) == pytest.approx(alpha, abs=1e-9)
        for share, grows in ((0.97, False), (1.03, True)):
            place = motion.positions(share * alpha, 0.25, 1, delta, gamma, 1, late, steps=2000)
            assert motion.grows(place) == grows


HALF = "s6c_half_a_period"


@guards("s6c_half_a_period")
def test_exact_and_printed_walls_of_a_root():
    """Q and Q_p from exponentials; their sizes, their phases and their ratio at half a period."""

    def walls(theta, late):
        theta = mpmath.mpf(theta)
        z, top = mpmath.expj(theta), numerator(0, 0, late)
        bottom = (z - 1) ** 2
        exact = -z * bottom / (top[0] * z**2 + top[1] * z + top[2])
        return exact, -mpmath.expj(late * theta) * bottom / ((z + 1) / 2)

    def agrees(size, shrinks, common, phase):
        for theta in (0.4, 1.7):
            for late in (0.2, 0.5):
                z, top = mpmath.expj(theta), numerator(0, 0, late)
                found = abs(top[0] * z**2 + top[1] * z + top[2]) ** 2
                assert abs(value(size, theta=theta, epsilon=late) - found) < 1e-45
            exact, printed = walls(theta, 0.5)
            assert abs(value(shrinks, theta=theta) - exact / printed) < 1e-45
            found = printed * mpmath.expj(-mpmath.mpf(theta))
            assert abs(value(common, theta=theta) - found) < 1e-45
        small = mpmath.mpf("1e-12")  # the next term is of its square
        for late in (0.2, 0.9):
            late = mpmath.mpf(late)
            exact, printed = walls(small, late)
            found = mpmath.im(exact / printed) / small**3
            assert abs(value(phase, epsilon=late) - found) < 1e-20

    titles = (
        "For every fraction, $|M|$ is larger than $|N|$",
        "With a delay of half a period the wall on the exact boundary is the smaller one",
        "With a delay of half a period the two boundaries $Q$ and $Q_p$ have the same phase",
        "The phases of the two boundaries differ by a term of third order in the angle",
    )
    only(agrees, *(shown(HALF, title) for title in titles))


@guards("s6c_half_a_period")
def test_a_term_between_both_polynomials_and_the_rise_of_a_phase():
    """The weaker wall by characteristic polynomials; the rise by the slope of the phase itself."""

    def read(alpha, beta, whole, root):
        push = (alpha + beta) * root**2 - beta
        return root ** (2 * whole + 3) * (root**2 - 1) ** 2 + (root**2 + 1) / 2 * push

    for whole in (0, 2):
        alpha, beta = 0.3, 0.7
        exact = np.poly(oracle.loops(alpha, beta, 0, 0, whole + 0.5))
        for root in (0.8 + 0.9j, 1.3 - 0.2j):
            term = (root - 1) ** 4 * ((alpha + beta) * root**2 - beta) / 8
            found = np.polyval(exact, root**2) - term
            assert root * read(alpha, beta, whole, root) == pytest.approx(found, rel=1e-9)

    def weaker(share):
        for theta in (0.4, 2.0):
            z, root, top = mpmath.expj(theta), mpmath.expj(theta / 2), numerator(0, 0, 0.5)
            found = (top[0] * z**2 + top[1] * z + top[2] - 0.25 * (root - 1) ** 4 / 8) / z
            assert abs(value(share, theta=theta, q=0.25) - found) < 1e-14

    only(weaker, shown(HALF, "On the circle the term reduces the wall slightly"))

    def rises(rate):
        for whole, theta in ((0, mpmath.mpf("0.9")), (2, mpmath.mpf("0.35"))):
            q = mpmath.expj((whole + 1) * theta)  # the phase of Q; its size is in both
            beta = mpmath.im(q) / mpmath.sin(theta)
            alpha = mpmath.re(q) - beta * (1 - mpmath.cos(theta))
            near = [theta + sign * mpmath.mpf("1e-20") for sign in (1, -1)]
            later, sooner = ((alpha + beta) * mpmath.expj(t) - beta for t in near)
            found = mpmath.arg(later / sooner) / mpmath.mpf("2e-20")
            assert abs(value(rate, l=whole, theta=theta) - found) < 1e-30

    only(rises, shown(HALF, "On the boundary the phase of the wall increases more slowly"))


LETTER, READ = "s6h_fractional_letter", "s6h_fractional_readings"


@guards("s6h_fractional_letter")
def test_to_the_letter_no_wall_is_stable_beyond_the_spring():
    def agrees(at_one, at_minus_one):
        for gamma, delta in PLANTS[1:3]:
            alpha, beta, late = 0.4, -0.3, "1/2"
            w, q = oracle.sheets(alpha, beta, gamma, delta, late)
            at = {"alpha": alpha, "gamma": gamma, **named(gamma, delta)}
            assert q == 2
            # 7 roots of order 1
            assert number(at_one, **at) == pytest.approx(np.prod(1 - w).real, abs=1e-12)
            assert number(at_minus_one, **at) == pytest.approx(np.prod(-1 - w).real, abs=1e-12)

    titles = (
        r"At $\zeta=1$ the polynomial is a multiple of $\gamma+\alpha$",
        r"At $\zeta=-1$ the polynomial is a multiple of $\alpha-\gamma$, for even $q$",
    )
    only(agrees, *(said(LETTER, title).conclusion.terms[1] for title in titles))
    rng = np.random.default_rng(95)
    inside = 0
    for _ in range(300):
        gamma, delta = rng.uniform(0, 2), rng.uniform(0, 2)
        alpha, beta = rng.normal(size=2) * gamma * 0.7
        w, _ = oracle.sheets(alpha, beta, gamma, delta, rng.choice(["1/2", "1/4", "3/2"]))
        if np.abs(w).max() < 1:
            inside += 1
            assert abs(alpha) < gamma
    assert inside > 20


@guards("s6h_fractional_readings")
def test_a_stiff_spring_is_read_wrongly_on_the_principal_sheet():
    gamma = 4 * np.pi**2 / 9

    def agrees(true, at_minus_one):
        for x, y in ((0.3, 0.4), (-0.75, -0.5)):
            found = np.poly(oracle.loops(x * gamma, y * gamma, gamma, 0, 0.5))
            for z in (0.4 + 0.3j, -1.5):
                ours = complex(value(true, x=x, y=y, z=z))
                assert ours == pytest.approx(np.polyval(found, z), abs=1e-12)
            assert number(at_minus_one, x=x, y=y) == pytest.approx(np.polyval(found, -1), abs=1e-12)

    only(
        agrees,
        shown(READ, "The exact polynomial has four roots"),
        shown(READ, "The exact polynomial has a root at $-1$ on a line"),
    )
    for x, y, stable in ((-3 / 4, -2 / 4, False), (3 / 8, -5 / 8, True)):
        assert oracle.stable(x * gamma, y * gamma, gamma, 0, 0.5) == stable
        read = oracle.principal(x * gamma, y * gamma, gamma, 0, "1/2").max() < 1
        assert read != stable
