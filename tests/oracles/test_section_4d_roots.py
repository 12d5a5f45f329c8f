"""Counting roots without polynomials, and the delay margin: eigenvalues for many integer delays."""

import numpy as np
import oracle
import pytest
from oracles.guarding import guards
from oracles.subject import number, only, shown, value

pytestmark = pytest.mark.ci

COUNTED, MARGIN = "s4d_roots_counted", "s4d_roots_delay_margin"


class Loop:
    """Plant and wall on the circle, as the chapter takes them apart."""

    def __init__(self, alpha, beta, gamma, delta):
        self.wall = {"alpha": alpha, "beta": beta}
        self.plant = {name: float(n) for name, n in oracle.named(gamma, delta).items()}

    def parts(self, theta):
        """A/z, N and W."""
        n1, n0, a, e = self.plant.values()
        alpha, beta = self.wall.values()
        z = np.exp(1j * theta)
        return z - a + e / z, n1 * z + n0, (alpha + beta) * z - beta

    def surplus(self, sizes, y):
        device, top, wall = (number(size, y=y, **self.plant, **self.wall) for size in sizes)
        return device - top * wall

    def crossings(self, sizes):
        """Angles of equal size, in order, from three values of a quadratic in y."""
        values = [self.surplus(sizes, y) for y in (0, 2, 4)]
        roots = np.roots(np.polyfit([0, 2, 4], values, 2))
        roots = np.sort(roots[np.abs(roots.imag) < 1e-9].real)
        return [2 * np.arcsin(np.sqrt(y) / 2) for y in roots if 0 < y < 4]

    def phase(self, theta, d):
        device, top, wall = np.angle(self.parts(theta))
        return top + wall - device - (d + 2) * theta

    def outside(self, sizes, d):
        """The chapter's count: twice the k where the wall starts to lead, less where it stops."""
        leads, count = self.surplus(sizes, 0.0) < 0, 0
        if leads:
            count += round(self.phase(1e-9, d) / np.pi)
        for theta in self.crossings(sizes):
            k = 2 * round(self.phase(theta, d) / (2 * np.pi))
            count, leads = count + (-k if leads else k), not leads
        return count - round(self.phase(np.pi - 1e-9, d) / np.pi) if leads else count


def sizes():
    return [shown(COUNTED, f"On the circle $|{name}|^2$ is a polynomial in $y$") for name in "ANW"]


@guards("s4d_roots_counted")
def test_sizes_and_heights_on_the_circle():
    loop, angles = Loop(0.7, -0.3, 0.5, 0.4), (0.3, 1.4, 2.9)

    def agrees(*shown_parts):
        for theta in angles:
            at = {"y": 4 * np.sin(theta / 2) ** 2, "theta": theta, **loop.plant, **loop.wall}
            found = loop.parts(theta)
            values = [number(part, **at) for part in shown_parts]
            assert values[:3] == pytest.approx([abs(f) ** 2 for f in found], abs=1e-14)
            assert values[3:] == pytest.approx([f.imag for f in found], abs=1e-14)

    title = r"The imaginary part of $%s$ is a multiple of $\sin\theta$"
    heights = [shown(COUNTED, title % name) for name in ("A/z", "N", "W")]
    only(agrees, *sizes(), *heights)


@guards("s4d_roots_counted")
def test_the_count_is_that_of_the_eigenvalues():
    rng = np.random.default_rng(71)
    cases = []
    for _ in range(50):
        wall = rng.normal(size=2) * 10 ** rng.uniform(-2, 1)
        cases.append((*wall, rng.uniform(0, 9), rng.uniform(0.02, 2), rng.choice([0, 1, 3, 12])))
    found = [int((oracle.moduli(*case) > 1).sum()) for case in cases]
    assert len(set(found)) > 5
    loops = [(Loop(*case[:4]), case[4]) for case in cases]

    def agrees(*parts):
        ours = [loop.outside(parts, d) for loop, d in loops]
        assert ours == found

    agrees(*sizes())  # whose mutants the test before refuses
    device, top, wall = sizes()
    with pytest.raises(AssertionError):
        agrees(device, 2 * top, wall)


FREE = "s4d_roots_counted_without_spring"


@guards("s4d_roots_counted_without_spring")
def test_without_a_spring_one_quadratic_says_which_part_is_larger():
    def agrees(surplus, first, last, bend, real):
        for alpha, beta, delta in ((0.7, -0.3, 0.4), (0.2, 1.5, 2.0)):
            loop = Loop(alpha, beta, 0.0, delta)
            found = []
            for theta in (1e-9, 0.4, 1.9, np.pi):
                device, top, wall = loop.parts(theta)
                y = 4 * np.sin(theta / 2) ** 2
                found.append(abs(device) ** 2 - abs(top * wall) ** 2)
                given = {"y": y, "theta": theta, **loop.plant, **loop.wall}
                assert number(surplus, **given) == pytest.approx(found[-1], abs=1e-12)
                assert number(real, **given) == pytest.approx(device.real, abs=1e-12)
            at = {**loop.plant, **loop.wall}
            assert number(first, **at) == pytest.approx(found[0], abs=1e-8)
            assert number(last, **at) == pytest.approx(found[-1], abs=1e-12)
            ys = [4 * np.sin(t / 2) ** 2 for t in (0.4, 1.9, np.pi)]
            square = np.polyfit(ys, found[1:], 2)[0]
            assert number(bend, **at) == pytest.approx(16 * square - found[0], abs=1e-8)

    titles = (
        "The surplus $|A|^2-|NW|^2$ of the plant is a quadratic",
        "At $z=1$ the wall dominates",
        "At $z=-1$ the terms of plant and wall are real",
        "The curvature of the quadratic is bounded by its value at $z=1$",
        "The real part of $A/z$ is negative",
    )
    only(agrees, *(shown(FREE, title) for title in titles))


@guards("s4d_roots_counted_without_spring")
def test_without_a_spring_the_verdict_is_that_of_the_eigenvalues():
    """Also of walls that are as strong as the device at z = -1, of which none is stable."""
    rng = np.random.default_rng(72)
    found = [0, 0, 0]
    for _ in range(300):
        d, delta = int(rng.integers(0, 6)), rng.choice([0.0, rng.uniform(0, 3), 30.0])
        alpha = rng.choice([1, 1, 0.05]) * rng.uniform(-0.3, 2) / (d + 1) ** 2 * (1 + delta)
        beta = rng.uniform(-1, 4) / (d + 1) * (1 + delta)
        loop = Loop(alpha, beta, 0.0, delta)
        plant, top, wall = (abs(part) for part in loop.parts(np.pi))
        strong = top * wall >= plant
        stable = oracle.stable(alpha, beta, 0.0, delta, d)
        if strong:
            given = {**loop.plant, **loop.wall}
            quadratic = shown(FREE, "The surplus $|A|^2-|NW|^2$ of the plant is a quadratic")
            assert max(number(quadratic, y=y, **given) for y in np.linspace(0.01, 3.99, 25)) < 0
            assert not stable
        else:
            angles = np.linspace(1e-4, np.pi, 2001)
            sizes_ = np.array([abs(p) for p in loop.parts(angles)])
            (first, *_) = np.flatnonzero(sizes_[0] > sizes_[1] * sizes_[2])
            phase = np.sum(np.unwrap(np.angle(loop.parts(angles)), axis=1)
                           * np.array([[-1], [1], [1]]), axis=0) - (d + 2) * angles  # fmt: skip
            if abs(phase[first] + np.pi) > 0.02:
                assert stable == (alpha > 0 and phase[first] > -np.pi)
        found[0 if strong else 1 if stable else 2] += 1
    assert min(found) > 5


@guards("s4d_roots_delay_margin")
def test_roots_leave_and_come_back_at_the_delays_that_are_said():
    """The sum of crossings up to a delay, against eigenvalues for integer delays up to 30."""
    walls = [(0.05, 0.1, 0.0, 0.1), (0.02, 0.06, 1e-3, 0.02), (0.5, 0.2, 0.3, 0.05)]
    found = {w: [int((oracle.moduli(*w, d) > 1).sum()) for d in range(31)] for w in walls}

    def agrees(product):
        for wall, counts in found.items():
            loop = Loop(*wall)
            device = loop.crossings(sizes())
            leads = loop.surplus(sizes(), 0.0) < 0
            changes = []
            for theta in device:
                turned = loop.phase(theta, 0) + 2 * theta
                for k in range(40):
                    # (d + 2) theta is what the chapter shows
                    delay = float(value(product, Phi_0=turned, k=k)) / theta - 2
                    changes.append((delay, 2 if leads else -2))
                leads = not leads
            for d, count in enumerate(counts):
                assert count == counts[0] + sum(step for at, step in changes if 0 < at <= d)

    only(
        agrees,
        shown(MARGIN, "A pair of roots leaves the unit disc at each delay of a sequence"),
        by=0.3,
    )
    assert any(max(counts) > 2 for counts in found.values())


@guards("s4d_roots_delay_margin")
def test_the_margin_of_the_free_mass_on_the_principal_sheet():
    """3.969; on the sheet rational delays are asked, whose polynomials have up to 250 roots."""
    loop = Loop(0.01, 0.05, 0, 0)
    (theta,) = loop.crossings(sizes())
    assert theta == pytest.approx(0.1077, abs=1e-4)
    margin = (loop.phase(theta, 0) + 2 * theta + np.pi) / theta - 2
    assert margin == pytest.approx(3.969, abs=1e-3)
    for late, stable in (("3.96", True), ("3.98", False)):
        assert (oracle.principal(0.01, 0.05, 0, 0, late).max() < 1) == stable


@guards("s4d_roots_delay_margin")
def test_how_fast_a_root_leaves():
    """A loop that turns unstable at d = 3.079, between 3.06 and 3.1 on the principal sheet."""
    wall = (0.05, 0.1, 0, 0.1)
    loop = Loop(*wall)
    (theta,) = loop.crossings(sizes())
    low, high = (oracle.principal(*wall, late).max() for late in ("3.06", "3.1"))
    assert low < 1 < high

    def lead(angle):
        """ln h with h = -N W/A = N W/(-z (A/z))."""
        device, top, push = loop.parts(angle)
        return np.log(top * push / -np.exp(1j * angle) / device)

    def agrees(moves):
        step = 1e-6  # d/d theta is j z d/dz; the difference is off by 1e-10
        turned = (lead(theta + step) - lead(theta - step)) / (2j * step)
        at = {"u": turned.real, "w": turned.imag, "theta": theta, "d": 3.079}
        # the curvature over 0.04 periods, around the middle
        assert np.log(high / low) / 0.04 == pytest.approx(number(moves, **at), rel=2e-3)

    only(
        agrees,
        shown(MARGIN, "With growing delay, a root on the circle moves outwards if $w$ is positive"),
        by=0.15,
    )
