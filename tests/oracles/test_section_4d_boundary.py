"""The explicit boundary: eigenvalues, loops simulated on both sides, small angles in 60 digits."""

import mpmath
import numpy as np
import oracle
import pytest
from oracles import motion
from oracles.guarding import guards
from oracles.subject import decimals, number, only, said, shown, value

from symhaptic.model import boundary, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import c

pytestmark = pytest.mark.ci

ENDS, UNDAMPED = "s4d_explicit_boundary_ends", "s4d_explicit_boundary"


def tiny(expected, found, scale=1.0):
    """Two values of which one is a limit, met at an angle of 1e-20: the next term is 1e-20."""
    assert abs(expected - found) < 1e-18 * max(1.0, abs(scale))


@guards("s4d_explicit_boundary")
def test_walls_of_the_explicit_boundary_have_a_root_on_the_circle():
    device = plant.sampled(plant.normalised(FULL), split=c)
    cases = [(1e-3, 0.02, 0, 0.6), (2.0, 0.5, 1, 1.3), (0.1, 3.0, 2, 0.4), (9.0, 0.01, 7, 3.0)]

    def agrees(stiffness, damping):
        for gamma, delta, d, theta in cases:
            apart = mpmath.sqrt(mpmath.mpf(delta) ** 2 - 4 * mpmath.mpf(gamma))
            at = {"gamma": gamma, "delta": delta, "c": apart, "d": d, "theta": theta}
            alpha, beta = number(stiffness, **at), number(damping, **at)
            # the two walls are rounded to floats
            assert oracle.residual(alpha, beta, theta, gamma, delta, d) < 1e-15

    only(agrees, *boundary.wall(device))


@guards("s4d_explicit_boundary")
def test_the_simulated_loop_dies_out_on_one_side_and_grows_on_the_other():
    """On the first arc, where the boundary bounds the stable walls: 1 per cent in and out."""
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    walls = [(d, part * np.pi / 2 / (d + 1)) for d in (0, 1, 3) for part in (0.4, 0.7)]

    def agrees(stiffness, damping):
        for d, theta in walls:
            alpha, beta = (number(f, d=d, theta=theta) for f in (stiffness, damping))
            for share, grows in ((0.99, False), (1.01, True)):
                # roots within some 0.001 of the circle: 8000 periods tell
                place = motion.positions(share * alpha, beta, late=float(d), steps=8000)
                assert motion.grows(place) == grows

    only(agrees, *boundary.wall(free), by=0.05)


@guards("s4d_explicit_boundary")
def test_roots_at_one_and_minus_one_and_the_free_mass():
    def agrees(at_one, at_minus_one):
        for gamma, delta in ((0.3, 0.2), (4.0, 1.0)):
            for alpha, beta in ((0.4, -0.3), (1.5, 2.0)):
                at = {"alpha": alpha, "beta": beta, **oracle.named(gamma, delta)}
                matrix = oracle.loops(alpha, beta, gamma, delta, 0)
                for z, ours in ((1, at_one), (-1, at_minus_one)):
                    found = np.linalg.det(z * np.eye(3) - matrix)
                    assert number(ours, **at) == pytest.approx(found, abs=1e-13)

    both = (
        shown("s4d_explicit_boundary", f"A root at {t}")
        for t in (
            r"1 means $\alpha=-\gamma$",
            "$-1$ means that the wall lies on a second line, here for even delays",
        )
    )
    only(agrees, *both)

    def agrees_free(stiffness, damping):
        for d, theta in ((0, 0.7), (1, 0.5), (4, 2.0)):
            alpha, beta = (number(f, d=d, theta=theta) for f in (stiffness, damping))
            assert oracle.residual(alpha, beta, theta, 0, 0, d) < 1e-15

    names = (
        "The free mass has this stiffness on its boundary",
        "The free mass has this damping on its boundary",
    )
    only(agrees_free, *(shown("s4d_explicit_boundary", name) for name in names))

    def agrees_slope(slope):
        for d in (0, 2, 6.5):
            alpha, beta = oracle.wall(mpmath.mpf("1e-20"), 0, 0, d)
            tiny(beta / alpha, value(slope, d=d))

    only(
        agrees_slope,
        shown("s4d_explicit_boundary", r"At the origin $\beta/\alpha=d+\frac12$"),
    )


PLANTS = [(0.3, 0.2, 0), (2.0, 0.01, 1), (0.001, 0.02, 2), (0.1, 3.0, 5)]


def short(gamma, delta):
    """The chapter's three numbers of an arm."""
    at = {"gamma": gamma, **oracle.named(gamma, delta)}
    at["nu"], at["s_1"] = (
        value(shown(ENDS, t), **at)
        for t in (
            r"The second coefficient is the fraction $\nu$ of the numerator's sum",
            "The number $s_1$ is the low-frequency damping of the device",
        )
    )
    at["s_2"] = value(shown(ENDS, "The number $s_2$ is the low-frequency mass of the device"), **at)
    return at


@guards("s4d_explicit_boundary_ends")
def test_the_boundary_at_small_angles():
    angle = mpmath.mpf("1e-20")
    walls = [oracle.wall(angle, g, f, d, 100) for g, f, d in PLANTS]

    def agrees(stiffness, damping, right, up, slope):
        for (gamma, delta, d), (alpha, beta) in zip(PLANTS, walls, strict=True):
            at = {"d": d, **short(gamma, delta)}
            with mpmath.workdps(100):
                start = value(stiffness, **at), value(damping, **at)
                tiny(start[0], alpha)
                tiny(start[1], beta)
                # the start has 60 digits: 40 are left of 1e-40
                exact = oracle.wall(angle, gamma, delta, d, 100)
                across, over = (exact[0] + gamma) / angle**2, (exact[1] - start[1]) / angle**2
                assert abs(across / value(right, **at) - 1) < 1e-12
                assert abs(over / value(up, **at) - 1) < 1e-12
                assert abs(over / across / value(slope, **at) - 1) < 1e-12

    titles = [
        r"The boundary starts at $\alpha=-\gamma$",
        r"The boundary starts at $\beta=-s_1-d\gamma$",
    ]
    titles += [
        "To second order the boundary goes to the right from its start",
        "To second order the boundary goes up from its start",
        r"The initial slope of the boundary is a fraction less than $d+\frac12$",
    ]
    only(agrees, *(shown(ENDS, title) for title in titles))


@guards("s4d_explicit_boundary_ends")
def test_the_start_without_a_spring_and_its_gap_with_one():
    def agrees(damping, slope):
        for delta, d in ((0.02, 0), (1.0, 2), (4.0, 1)):
            one, two = (oracle.wall(mpmath.mpf(t), 0, delta, d, 100) for t in ("1e-20", "2e-20"))
            with mpmath.workdps(100):
                tiny(one[1], -value(damping, delta=delta))
                found = (two[1] - one[1]) / (two[0] - one[0])
                assert abs(found / value(slope, delta=delta, d=d) - 1) < 1e-12

    titles = (
        r"Without a spring, $s_1$ is the damping $\delta$",
        "Without a spring, the boundary starts at $(0,-\\delta)$ with an explicit slope",
    )
    only(agrees, *(shown(ENDS, title) for title in titles))
    gamma, delta = mpmath.mpf("0.001"), mpmath.mpf("0.02")
    gap = -oracle.wall(mpmath.mpf("1e-25"), gamma, delta, 0, 100)[1] - delta - gamma / 2
    (printed,) = decimals(ENDS, "An interval contains the distance at the corner of (23)")
    assert 0 <= gap - printed < 1e-24  # its digits are cut

    def agrees_with_the_gap(formula):
        at = {"gamma": gamma, "delta": delta, "c": mpmath.sqrt(delta**2 - 4 * gamma)}
        n1, n0, *_ = oracle.numbers(gamma, delta)
        assert abs(value(formula, **at) - gamma * (n1 + n0) * gap) < 1e-30

    title = (
        "The distance of the start from the line of (25) is a difference of hyperbolic functions"
    )
    only(agrees_with_the_gap, shown(ENDS, title))
    small = mpmath.mpf("1e-6")  # the next terms are smaller by this
    gap = -oracle.wall(mpmath.mpf("1e-40"), small**2, small, 0, 120)[1]
    gap = 720 * (gap - small - small**2 / 2) / small**5
    assert abs(gap - 1) < 1e-5


@guards("s4d_explicit_boundary_ends")
def test_the_end_at_half_the_sampling_rate():
    def agrees(damping, line):
        for gamma, delta, d in PLANTS:
            with mpmath.workdps(100):
                alpha, beta = oracle.wall(mpmath.pi - mpmath.mpf("1e-20"), gamma, delta, d, 100)
                ours = [
                    (-1) ** d * value(f, d=d, **oracle.named(gamma, delta)) for f in (damping, line)
                ]
                assert abs(beta / ours[0] - 1) < 1e-12
                assert abs((alpha + 2 * beta) / ours[1] - 1) < 1e-12

    titles = (
        r"At $\theta\to\pi$ the damping is finite",
        r"At $\theta\to\pi$ the boundary ends on the line of a root at $-1$",
    )
    only(agrees, *(shown(ENDS, title) for title in titles))


@guards("s4d_explicit_boundary")
def test_the_boundary_without_damping():
    cases = [(0.4, 0, 0.6), (2.0, 1, 1.3), (3.0, 2.5, 0.4), (5.0, 3, 3.0)]

    def agrees(spring, stiffness, both):
        for Omega, d, theta in cases:
            gamma = mpmath.mpf(Omega) ** 2
            alpha, beta = oracle.wall(theta, gamma, 0, d)
            g = value(spring, gamma=gamma, Omega=Omega, theta=theta)
            assert abs(value(stiffness, g=g, d=d, theta=theta) - alpha) < 1e-45
            assert abs(value(both, g=g, d=d, theta=theta) - alpha - 2 * beta) < 1e-45

    titles = [r"One function contains the stiffness $\gamma$"]
    titles += [
        "The boundary of an undamped device has one stiffness at each angle",
        "The damping on the boundary is a multiple of a sine",
    ]
    only(agrees, *(shown(UNDAMPED, title) for title in titles))


@guards("s4d_explicit_boundary")
def test_both_ends_of_the_boundary_without_damping():
    with mpmath.workdps(100):
        gamma, near = mpmath.mpf("1.69"), mpmath.mpf("1e-20")
        x = mpmath.cos(mpmath.sqrt(gamma))
        low = {d: oracle.wall(near, gamma, 0, d, 100) for d in (0, 1, 3)}
        high = {d: oracle.wall(mpmath.pi - near, gamma, 0, d, 100) for d in (0, 1, 3)}

    def agrees(stiffness, damping, right, slope, line):
        with mpmath.workdps(100):
            for d, (alpha, beta) in low.items():
                tiny(alpha / gamma, value(stiffness))
                tiny(beta / gamma, value(damping, d=d))
                across = (alpha / gamma + 1) / near**2
                assert abs(across / value(right, x=x, d=d) - 1) < 1e-12
                over = (beta / gamma + d + mpmath.mpf(1) / 2) / near**2
                assert abs(over / across / value(slope, x=x, d=d) - 1) < 1e-12
            for d, (alpha, beta) in high.items():
                found = (-1) ** d * (alpha + 2 * beta) / gamma
                assert abs(found / value(line, x=x, d=d) - 1) < 1e-12

    titles = [
        r"The boundary starts at $\alpha=-\gamma$",
        r"The boundary starts at $\beta=-(d+\frac12)\gamma$",
        r"Near its start the stiffness on the boundary grows as $\theta^2$",
        "The initial slope of the boundary is smaller than that of the line",
    ]
    titles.append(r"The boundary approaches a line of constant $\alpha+2\beta$")
    only(agrees, *(shown(UNDAMPED, title) for title in titles))

    def agrees_at_half_swings(stiffness, both):
        for d, theta in ((1, 0.7), (2, 3.0)):
            gamma = mpmath.pi**2
            alpha, beta = oracle.wall(theta, gamma, 0, d)
            assert abs(value(stiffness, d=d, theta=theta) - alpha / gamma) < 1e-45
            assert abs(value(both, d=d, theta=theta) - (alpha + 2 * beta) / gamma) < 1e-45

    titles = (
        r"The stiffness stays finite if $\Omega$ is an odd multiple of $\pi$, that is, for $x=-1$",
        "For $x=-1$ the damping also stays finite",
    )
    only(agrees_at_half_swings, *(shown(UNDAMPED, title) for title in titles))


SIGNS = "s4d_explicit_boundary_signs"


def gap(gamma, delta):
    """nu, s_1 - delta - gamma/2 and s_2 by differences of 1/P around z = 1, in 120 digits."""
    with mpmath.workdps(120):
        gamma, delta = mpmath.mpf(gamma), mpmath.mpf(delta)
        n1, n0, a, e = oracle.numbers(gamma, delta, 120)
        step = mpmath.mpf("1e-20")  # the next terms are of its square
        high, low = ((z * z - a * z + e) / (n1 * z + n0) - gamma for z in (1 + step, 1 - step))
        s_1, s_2 = (high - low) / (2 * step), (high + low) / (2 * step**2)
        return n0 / (n1 + n0), s_1 - delta - gamma / 2, s_2


@guards("s4d_explicit_boundary_signs")
def test_what_the_signs_are_made_of():
    """The integrals by quadrature, beside the sampled device."""

    def S(x):
        root = mpmath.sqrt(mpmath.mpc(x))
        return mpmath.re(mpmath.sinh(root) / root) if x else mpmath.mpf(1)

    def agrees(surplus, mass):
        for gamma, delta in ((0.3, 0.2), (9.0, 0.05), (1.0, 4.0)):
            _, *found = gap(gamma, delta)
            at = {"gamma": gamma, "delta": delta, **oracle.named(gamma, delta)}
            for ours, theirs in zip((surplus, mass), found, strict=True):
                assert abs(value(ours, **at) - theirs) < 1e-30

    half = r"A device with $\omega_dT<\pi$ has"
    titles = rf"{half} $s_1\ge\delta+\frac12\gamma$", f"{half} $s_2>0$"
    only(agrees, *(said(SIGNS, title).conclusion.terms[1] for title in titles))
    for gamma, delta in ((0.3, 0.2), (9.0, 0.05), (1.0, 4.0)):
        gamma, delta = mpmath.mpf(gamma), mpmath.mpf(delta)
        n1, n0, a, e = oracle.numbers(gamma, delta)
        p, q, fall = delta**2 / 4, delta**2 / 4 - gamma, mpmath.exp(-delta / 2)

        def swing(t, q=q, delta=delta):
            return mpmath.exp(-delta * t / 2) * t * S(q * t * t)

        assert abs(mpmath.quad(swing, [0, 1]) - n1) < 1e-40
        back, *_ = oracle.numbers(gamma, -delta)
        assert abs(mpmath.exp(-delta) * back - n0) < 1e-40
        assert abs(gamma * (n1 + n0) - fall * mpmath.quad(S, [q, p])) < 1e-40
        assert abs(gamma * (n1 - n0) - delta * fall * (S(p) - S(q))) < 1e-40
        error = gamma * (S(p) + S(q)) / 2 - mpmath.quad(S, [q, p])
        assert error > 0
        above, mass = gap(gamma, delta)[1:]
        assert abs((n1 + n0) * above - delta * fall / gamma * error) < 1e-30
        z = -n0 / n1
        assert abs(mass - n1**2 * (z * z - a * z + e) / (n1 + n0) ** 3) < 1e-30
