r"""How much stiffer than a passive wall can a stable one be?

The paper gives the ratio of the largest stable to the largest passive stiffness for $d=1$ and
draws its inverse $\eta$ in Fig. 12. With \chapter{s5b_stiffest_wall_bound} each value is the
maximum of an explicit function, and balls enclose it.
"""

from sympy import Poly, Rational, S, pi, symbols, tan

from symhaptic.book.lemmas.stiffness_claims import LATE, of_ratio
from symhaptic.bounds.walls import DEVICE, STIFFNESS, most, over, passive
from symhaptic.model import circle, passivity
from symhaptic.notation import K, T, alpha, d, delta, gamma, phi, t, theta
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import DAMPED, IN_23, RANGES, STIFF
from symhaptic.proof import box
from symhaptic.proof.ball import bound
from symhaptic.proof.plants import BALLS, NUMBERS, named
from symhaptic.proof.roots import decimals
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.tactics import example

GIVEN = named({s: s for s in NUMBERS})
FOR_EVER = Rational(59, 10**5)
ANGLE = Rational(555, 1000)
PLAIN = (1, 2, 5, 10, 20, 40, 100, 122, 200, 500, 1000)


def derive(page):
    whole = passivity.dirichlet_form().subs({K: alpha, T: S.One}).subs(theta, pi / (2 * (d + 1)))
    page.step(
        "The stiffness (11) needs all of the damping",
        whole.subs(alpha, passive(delta, d)),
        delta,
        name=r"\text{damping needed by}\ \alpha=2\delta\tan\tfrac{\pi}{4(d+1)}",
    )
    page.say(
        "One angle of the curve is enough for a bound on the whole range of the paper: "
        "$\\alpha_{\\max}$ is at least the $\\alpha$ there. Here it is $\\theta=0.555$, for $d=1$:"
    )
    there = STIFFNESS.subs({t: tan(ANGLE / 2), phi: 2 * ANGLE}).subs(BALLS)
    need = passive(delta, 1) / Rational(1074, 10000)
    page.positive(
        "One period late a stable wall is more than 9.31 times as stiff",
        box.positive(there - need, RANGES, GIVEN),
        IN_23,
        name=r"\alpha(0.555)-2\delta\tan\tfrac\pi8/0.1074",
        because="$1/0.1074=9.310\\ldots$ is more than 9.3",
    )
    corner, plain = (ratio(stiffness, DAMPED, 1) for stiffness in (STIFF, S.Zero))
    beyond = ratio(S.Zero, Rational(202, 10000), 1)
    page.enclosed(
        "The ratio of both stiffnesses is enclosed",
        [
            (rf"\frac{{\alpha_{{\max}}}}{{2\delta\tan(\pi/8)}}\Big|_{{{arm}}}", value)
            for arm, value in (
                (r"\gamma=0.001,\ \delta=0.02", corner),
                (r"\gamma=0,\ \delta=0.02", plain),
                (r"\gamma=0,\ \delta=0.0202", beyond),
            )
        ],
        because="9.3 is cut from the first, 0.1074 its inverse rounded up; both fail a little "
        "beyond the range",
    )
    claim = CLAIMED["s5b-eta-d1"](())
    page.settle(
        "s5b-eta-d1",
        of_ratio(claim, 1, LATE),
        example=example({gamma: S.Zero, delta: DAMPED}, taken_apart(claim)[1]),
        enclosed=True,
        value=(corner, over(S.One, corner)),
        note=r"both hold on all of (23); the numbers are those of its corner "
        r"$\gamma=0.001$, $\delta=0.02$",
    )
    table(page)


def ratio(stiffness, damping, delay):
    """Largest stable over largest passive stiffness."""
    return over(most(stiffness, damping, delay), passive(damping, delay))


def table(page):
    """Fig. 12 in numbers."""
    page.say(
        "Fig. 12 has $\\delta=0.02$. With the spring the maximum is known up to $d=48$. Beyond we "
        "take the wall $\\alpha=0.00059$, $\\beta=0$. With $y=4\\sin^2\\frac\\theta2$:"
    )
    y = symbols("y")
    plant_side, wall_side = (circle.square(p) for p in (DEVICE.denominator, DEVICE.numerator))
    gap = Poly(circle.in_chord(plant_side - FOR_EVER**2 * wall_side, y), y).all_coeffs()
    gap = 4 * gap[0] * gap[2] - gap[1] ** 2
    page.positive(
        "The plant outweighs this wall all around the circle",
        box.positive(gap.subs(BALLS), {gamma: (STIFF, STIFF), delta: (DAMPED, DAMPED)}, GIVEN),
        r"|A|^2-\alpha^2|N|^2=g_2y^2+g_1y+g_0",
        name="4g_2g_0-g_1^2",
        because="so this wall is stable for every delay, and bounds $\\eta$",
    )
    rows = []
    for delay in (0, *PLAIN):
        cells = [decimals(over(S.One, ratio(S.Zero, DAMPED, delay)).ball, 20)]
        if delay <= 48:
            cells.append(decimals(over(S.One, ratio(STIFF, DAMPED, delay)).ball, 20))
        else:
            high = over(passive(DAMPED, delay), FOR_EVER)
            cells.append(f"$<{bound(high.ball, above=True)}$")
        rows.append([delay, *cells])
    head = ["$d$", r"$\eta$ for $\gamma=0$", r"$\eta$ for $\gamma=0.001$"]
    page.table("Largest passive over largest stable stiffness, decimals cut off.", head, rows)
