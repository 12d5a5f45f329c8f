r"""Is the principal sheet of $z^{-d}$ right for a stiff spring?

The paper may mean only those roots of the polynomial in $\zeta$, $z=\zeta^q$, for which $\zeta$ is
the principal root of $z$ (the principal sheet). The loop of a delayed force differs from this
reading, and we ask by how much.
"""

from symhaptic.book.figures.fractional import stable_readings
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.principal import both_errors, read_wrongly


def derive(page):
    page.say(
        "For soft springs the principal sheet is close to the exact polynomial, as for the free "
        "mass. But Fig. 13 contains springs with which the natural frequency reaches the "
        "Nyquist frequency. Take "
        r"$\sqrt\gamma=\frac23\pi$, $\delta=0$, $d=\frac12$, and $x=\alpha/\gamma$, "
        r"$y=\beta/\gamma$:"
    )
    swinging = plant.normalised(Parts(damping=False))
    spring = {gamma: 4 * pi**2 / 9}
    device = fractional.late(swinging, HALF).device
    wall = (x + y) * z - y
    exact = z**2 * (z**2 + z + 1) + (z**2 + 4 * z + 1) / 2 * wall
    zeta = symbols("zeta")
    there = (x + y) * zeta**2 - y
    letter = zeta**3 * (zeta**4 + zeta**2 + 1) + 3 * (zeta**2 + 1) / 2 * there
    made = fractional.characteristic(Parts(damping=False), HALF).subs(l, 0)
    made = made.subs({alpha: x * gamma, beta: y * gamma}).subs(spring)
    page.step("The exact polynomial has four roots", made, exact, name="p_1(z)")
    theirs = zeta**3 * device.denominator + device.numerator * gamma * there
    page.step(
        r"The paper's polynomial in $\zeta=\sqrt z$ has seven roots",
        theirs.subs(z, zeta**2).subs(spring),
        letter,
        name=r"p_1(\zeta)",
    )
    page.step(
        "The exact polynomial has a root at $-1$ on a line",
        exact.subs(z, -1),
        1 + x + 2 * y,
        name="p_1(-1)",
        because="the stable region ends at the line $x+2y=-1$",
    )
    page.step(
        "The paper's polynomial has no root at $z=-1$",
        letter.subs(zeta, I),
        -I,
        name=r"p_1(\zeta)\big|_{\zeta=j}",
        because="the value at $z=-1$ is never zero, so the line is not a border of the region. The "
        "same holds for every device and fractional $d$, since the imaginary part is "
        r"$\pm(1+a+e)\sin\pi d$",
    )
    found = page.lemma(
        "The principal sheet errs in both directions: it calls one unstable wall stable and one "
        "stable wall unstable",
        both_errors(),
        because="balls around all roots prove this; the principal sheet has the roots with "
        r"$\Re\zeta>0$",
        boxed=True,
    )
    page.state(
        "fractional-principal",
        r"for a stiff spring, $\sqrt\gamma=\frac23\pi$ and with a delay of half a period, the "
        "principal sheet calls walls stable that are not, and others unstable that are stable",
        claim=read_wrongly(),
    )
    page.settle("fractional-principal", found)
    page.figure(
        "stable-fractional",
        "Stable walls with a delay of half a period, for a stiff spring with some damping "
        r"($\gamma=4\pi^2/9$, $\delta=\frac12$): the exact region (shaded), the region on the "
        "principal sheet, and the region on all sheets. On all sheets a wall is stable if the wall "
        "and its negative are stable on the principal sheet.",
        stable_readings,
    )
