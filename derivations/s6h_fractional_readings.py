r"""Which polynomial do the paper's curves for $d=\tfrac14$ and $d=\tfrac12$ belong to?

With $d=r/q$ the paper turns $z^{-d}$ into a polynomial by substituting $z=\zeta^q$. Read to the
letter, all its roots have to lie inside the unit circle. Or only those are meant whose $\zeta$ is
the principal root of $z$. Neither is the delayed force, and we ask how far they are from it.
"""

from sympy import I, Rational, pi, tan

from symhaptic.book.figures.fractional import stable_readings
from symhaptic.model import fractional, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import alpha, beta, c, delta, gamma, l, n_0, n_1, x, y, z
from symhaptic.notation.latex import latex
from symhaptic.proof import sign

HALF = Rational(1, 2)


def derive(page):
    page.say(
        "In $\\zeta$ the polynomial is $\\zeta^{q+r}A(\\zeta^q)+N(\\zeta^q)"
        "((\\alpha+\\beta)\\zeta^q-\\beta)$, of degree $3q+r$. Each of the $q$ sheets sees the "
        "wall turned by another multiple of $2\\pi d$. Let $q$ be even, as in all fractions of the "
        "paper. Then $r$ is odd, and at $\\zeta=-1$ is $z=1$ while $z^d=-1$: a sheet with "
        "the wall reversed."
    )
    given = {gamma: (delta**2 - c**2) / 4}
    device = plant.sampled(plant.normalised(FULL), split=c)
    total = device.n1 + device.n0
    bottom = device.denominator.subs(z, 1)
    sheets = []
    for power, wall, title, because in (
        (1, gamma + alpha, "At $\\zeta=1$", "positive if all roots are inside"),
        (-1, alpha - gamma, "At $\\zeta=-1$", "negative if so, since the degree $3q+r$ is odd"),
    ):
        value = power * bottom + total * alpha
        proof = page.same(title, value.xreplace(given), (total * wall).xreplace(given))
        name = rf"p_1\big|_{{\zeta={power}}}"
        page.show(title, name, (n_1 + n_0) * wall, proof, because)
        sheets.append(proof)
    page.state(
        "fractional-literal",
        "to the letter, for even $q$, a wall is stable only if $|\\alpha|<\\gamma$: never without "
        "a physical spring",
    )
    page.settle("fractional-literal", *sheets)
    page.say(
        "In Fig. 11 $\\gamma=0.001$, $\\delta=0.02$, and the text says that the passive regions "
        "lie inside the stable ones. By (11) they reach to"
    )
    gap = page.positive(
        "The passive walls reach too far",
        sign.number(2 * Rational("0.02") * tan(pi / 6) - Rational("0.001")),
        r"d=\tfrac12",
        name=r"\alpha_{\max}-\gamma",
        because="23 times as far as the stable walls of that reading could, and for "
        "$d=\\tfrac14$ farther still. Fig. 13 shades walls that are stable for all $\\gamma\\ge0$; "
        "to the letter there is none at $\\gamma=0$",
    )
    page.state(
        "fractional-figures",
        "the curves of Fig. 11 and Fig. 13 for fractional delays are not those of the polynomial "
        "read to the letter",
    )
    page.settle(
        "fractional-figures",
        *sheets,
        gap,
        note="Fig. 4 is (7), the principal sheet; whether the others are drawn from it or from "
        "the exact plant cannot be told from the text",
    )
    stiff_spring(page)


def stiff_spring(page):
    page.say(
        "For soft springs the principal sheet is close to the truth, as for the free mass. But "
        "Fig. 13 goes up to the Nyquist frequency. Take $\\sqrt\\gamma=\\frac23\\pi$, "
        "$\\delta=0$, $d=\\frac12$, and $x=\\alpha/\\gamma$, $y=\\beta/\\gamma$:"
    )
    swinging = plant.normalised(Parts(damping=False))
    spring = {gamma: 4 * pi**2 / 9}
    device = fractional.late(swinging, HALF).device
    wall = (x + y) * z - y
    exact = z**2 * (z**2 + z + 1) + (z**2 + 4 * z + 1) / 2 * wall
    letter = z**3 * (z**4 + z**2 + 1) + 3 * (z**2 + 1) / 2 * ((x + y) * z**2 - y)
    made = fractional.characteristic(Parts(damping=False), HALF).subs(l, 0)
    made = made.subs({alpha: x * gamma, beta: y * gamma}).subs(spring)
    exactly = page.same("exact", made, exact)
    page.show("The true polynomial", "p_1(z)", exact, exactly)
    theirs = z**3 * device.denominator.subs(z, z**2) + device.numerator.subs(z, z**2) * gamma * (
        (x + y) * z**2 - y
    )
    page.show(
        "The paper's, with $\\zeta=\\sqrt z$",
        r"p_1(\zeta)",
        r"\zeta^3(\zeta^4+\zeta^2+1)+\tfrac32(\zeta^2+1)\bigl((x+y)\zeta^2-y\bigr)",
        page.same("the paper's", theirs.subs(spring), letter),
    )
    page.step(
        "A root at $-1$",
        exact.subs(z, -1),
        1 + x + 2 * y,
        name="p_1(-1)",
        because="the region ends at the line $x+2y=-1$",
    )
    page.step(
        "The paper's at $z=-1$",
        letter.subs(z, I),
        -I,
        name=r"p_1(\zeta)\big|_{\zeta=j}",
        because="never zero: this border is missing. So it is for every device and fractional "
        "$d$, as the imaginary part is $\\pm(1+a+e)\\sin\\pi d$",
    )
    apart = []
    for place, stable in (((-3, -2, 4), False), ((3, -5, 8), True)):
        at = {x: Rational(place[0], place[2]), y: Rational(place[1], place[2])}
        words = f"${latex(at[x])}$, ${latex(at[y])}$"
        true, read = (page.inside, page.outside) if stable else (page.outside, page.inside)
        apart.append(true(f"True, at $(x,y)=$ {words}", exact.subs(at)))
        apart.append(read(f"On the principal sheet, at {words}", letter.subs(at), half=True))
    page.state(
        "fractional-principal",
        "for a stiff spring the principal sheet calls walls stable that are not, and others "
        "unstable that are stable",
    )
    page.settle("fractional-principal", *apart)
    page.figure(
        "stable-fractional",
        "Stable walls half a period late, for a stiff spring with some damping "
        "($\\gamma=4\\pi^2/9$, $\\delta=\\frac12$): exact (shaded), on the principal sheet, and "
        "for all sheets, where the wall and its negative have to be stable on the principal one.",
        stable_readings,
    )
