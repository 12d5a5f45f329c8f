r"""Is the principal sheet of $z^{-d}$ right for a stiff spring?

The paper may mean only those roots of the polynomial in $\zeta$, $z=\zeta^q$, for which $\zeta$ is
the principal root of $z$. This differs from a delayed force, too, and we ask by how much.
"""

from symhaptic.book.figures.fractional import stable_readings
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.principal import both_errors, read_wrongly


def derive(page):
    page.say(
        "For soft springs the principal sheet is close to the exact polynomial, as for the free "
        r"mass. But Fig. 13 goes up to the Nyquist frequency. Take $\sqrt\gamma=\frac23\pi$, "
        r"$\delta=0$, $d=\frac12$, and $x=\alpha/\gamma$, $y=\beta/\gamma$:"
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
        r"The paper's polynomial has seven, with $\zeta=\sqrt z$",
        theirs.subs(z, zeta**2).subs(spring),
        letter,
        name=r"p_1(\zeta)",
    )
    page.step(
        "The exact polynomial has a root at $-1$ on a line",
        exact.subs(z, -1),
        1 + x + 2 * y,
        name="p_1(-1)",
        because="the region ends at the line $x+2y=-1$",
    )
    page.step(
        "The paper's polynomial has no root at $z=-1$",
        letter.subs(zeta, I),
        -I,
        name=r"p_1(\zeta)\big|_{\zeta=j}",
        because="this is never zero, so the region has no such border. The same is true for every "
        "device and "
        r"fractional $d$, as the imaginary part is $\pm(1+a+e)\sin\pi d$",
    )
    found = page.lemma(
        "Both errors occur: one wall is stable on the principal sheet only, and one is not "
        "stable on it but stable",
        both_errors(),
        because="by balls around all roots, of which the sheet has those with $\\Re\\zeta>0$",
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
        r"($\gamma=4\pi^2/9$, $\delta=\frac12$): exact (shaded), on the principal sheet, and for "
        "all sheets, where the wall and its negative have to be stable on the principal one.",
        stable_readings,
    )
