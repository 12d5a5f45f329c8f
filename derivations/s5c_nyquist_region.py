"""Which walls are stable with a spring at the Nyquist frequency?

At this frequency the state of the free device changes its sign after every period, and decays. The
loop has a fixed root that belongs to this motion. Without delay the other factor is a quadratic,
and the stable region is a triangle.
"""

from sympy import I, S, exp, eye, pi, symbols, tanh

from symhaptic.book.lemmas.nyquist_triangle import hardly_moved, is_triangle, other_shape_and_size
from symhaptic.model import jury, loop, plant
from symhaptic.model.parts import FULL
from symhaptic.notation import alpha, beta, d, delta, gamma, z

AT = {gamma: pi**2 + delta**2 / 4}
LEFT = exp(-delta / 2)
SHARE = symbols("nu")


def derive(page):
    motion = plant.normalised(FULL).transition(S.One, 2 * I * pi)
    page.step(
        r"After one period every state is multiplied by $-e^{-\delta/2}$",
        motion.subs(AT),
        -LEFT * eye(2),
        name=r"\Phi(1)",
        because=r"here $\gamma=\pi^2+\delta^2/4$",
    )
    force = (1 + LEFT) / AT[gamma]
    whole = loop.characteristic(FULL, split=2 * I * pi).subs(AT)
    rest = (z + LEFT) * z ** (d + 1) + force * ((alpha + beta) * z - beta)
    page.step(
        "The polynomial has one zero at $-e^{-\\delta/2}$",
        whole,
        (z + LEFT) * rest,
        name="p_1(z)",
        because=r"therefore one root is $-e^{-\delta/2}$ for every wall and every delay",
    )
    page.say(
        r"For $d=0$ the other factor $q$ is a quadratic. With $f=e^{-\delta/2}$ and "
        r"$\nu=(1+f)/\gamma$, Jury's inequalities for this quadratic are three half planes:"
    )
    f = symbols("f")
    quadratic = [S.One, f + SHARE * (alpha + beta), -SHARE * beta]
    page.same(
        "quadratic",
        rest.subs(d, 0),
        (quadratic[0] * z**2 + quadratic[1] * z + quadratic[2]).subs({f: LEFT, SHARE: force}),
    )
    one, two, three = jury.criterion(quadratic).expressions
    page.step(
        r"The quadratic is positive at 1 for $\alpha>-\gamma$",
        one,
        1 + f + SHARE * alpha,
        name="q(1)",
        because="the value is positive for $\\alpha>-\\gamma$",
    )
    page.step(
        r"The quadratic at $-1$ bounds $\alpha+2\beta$",
        two,
        1 - f - SHARE * (alpha + 2 * beta),
        name="q(-1)",
    )
    page.step(
        "The product of the other zeros bounds $\\beta$",
        three,
        1 + SHARE * beta,
        name="1-r_1r_2",
        because=r"the difference is positive for $\beta>-1/\nu$",
    )
    edge = page.step(
        r"The third side of the triangle is the line $\alpha+2\beta=(1-f)/\nu$",
        ((1 - f) / SHARE).subs({f: LEFT, SHARE: force}),
        AT[gamma] * tanh(delta / 4),
        name=r"\frac{1-f}\nu",
    )
    page.say(
        r"The corner at $\beta=-1/\nu$ has the largest stiffness, "
        r"$\alpha=(3-f)/\nu=\gamma(3-f)/(1+f)$. This is about $\pi^2$; for the arms of (23) the "
        "largest stable stiffness is $0.71$."
    )
    most = AT[gamma] * (3 - LEFT) / (1 + LEFT)
    page.same("corner", edge + 2 / force, most)
    page.lemma(
        "At the Nyquist frequency and without delay the stable walls fill a triangle",
        is_triangle(),
        because="each of Jury's inequalities for the cubic follows from these three",
        boxed=True,
    )
    page.settle(
        "s5c-shape",
        other_shape_and_size(),
        note="the statement is proved for $d=0$ only: a region below an arc, up to "
        r"$\alpha=0.71$ and $\beta=2$, becomes a triangle with corners at $\beta=\pm\pi^2/2$",
    )
    page.settle(
        "s5c-delta-hardly-visible",
        page.lemma(
            "For the dampings of (23) the sides of the triangle move by less than 0.05",
            hardly_moved(),
        ),
        enclosed=True,
        note="the statement is proved for $d=0$ and the stiffest of the 41 springs only; the "
        "other curves are undecided",
    )
