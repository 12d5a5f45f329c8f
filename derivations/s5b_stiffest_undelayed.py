r"""How stiff can the wall be without delay, and how does that compare with passivity?

Without delay the loop is a cubic, with an arm's spring too. Its largest stable stiffness has a
closed form, and the paper's first ratio, 17.8 for $d=0$, is decided on the whole range (23).
"""

from sympy import Rational, S, sqrt

from symhaptic.book.lemmas.stiffness_claims import UNDELAYED, of_ratio
from symhaptic.bounds.walls import most, over, passive
from symhaptic.model import boundary, jury, plant
from symhaptic.notation import a, alpha, beta, delta, e, gamma, n_0, n_1, s_1, x
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.ranges import IN_23, RANGES
from symhaptic.proof import box
from symhaptic.proof.plants import BALLS, LATE, NUMBERS, named
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.tactics import example

RISE = n_1 + n_0
WIDE = {gamma: (0, Rational(1, 100)), delta: (0, Rational(1, 10))}

IN_WIDE = r"0\le\gamma\le0.01,\ 0\le\delta\le0.1"

GIVEN = named({s: s for s in NUMBERS})


def derive(page):
    first, second, third, minor = jury.criterion(jury.coefficients(0)).expressions
    arm = {a: 1 + e - gamma * RISE}
    page.say(
        "Jury's inequalities for $d=0$ are $p_1(1)>0$, $c_1>0$, $c_3=-p_1(-1)>0$ and $\\Delta_2>0$ "
        "(\\chapter{s4d_jury_counted}). With $1-a+e=\\gamma(n_1+n_0)$ and the damping "
        "$s_1=(1-e+\\gamma n_0)/(n_1+n_0)$ of the arm near $z=1$:"
    )
    loss = RISE * s_1 - gamma * n_0
    split = RISE * (1 - n_0 * beta) * (beta + s_1) - n_0 * (1 + n_1 * beta) * (alpha + gamma)
    page.step(
        "The minor has two products", minor.subs(arm).subs(e, 1 - loss), split, name=r"\Delta_2"
    )
    bounded(page, first, second, third, minor)
    reached(page, minor, second, third)
    ratio(page)


def bounded(page, first, second, third, minor):
    """Stable walls have 1 + n_1 beta > 0."""
    arm, loss = {a: 1 + e - gamma * RISE}, RISE * s_1 - gamma * n_0
    between = (8 - first - second - third).subs(arm).subs(e, 1 - loss)
    page.step(
        "The fourth coefficient, as all add up to 8",
        between,
        4 - RISE * (alpha + gamma) - 4 * n_0 * beta,
        name="c_2",
    )
    parts = n_0 * (1 + n_1 * beta) * between
    parts += (1 - n_0 * beta) * ((n_1 - n_0) ** 2 * beta + RISE**2 * s_1 - 4 * n_0)
    proof = page.same("least damping", RISE * minor.subs(arm).subs(e, 1 - loss), parts)
    text = r"n_0(1+n_1\beta)c_2+(1-n_0\beta)\bigl((n_1-n_0)^2\beta+(n_1+n_0)^2s_1-4n_0\bigr)"
    page.show(
        "The minor is also a sum with the fourth coefficient", r"(n_1+n_0)\Delta_2", text, proof
    )
    damping = (RISE * (1 - e) + gamma * n_0 * RISE).subs(BALLS)
    page.positive(
        "Beside soft springs $1+n_1\\beta$ is positive",
        box.positive(4 * LATE - damping, WIDE, GIVEN),
        IN_WIDE,
        name="4n_0-(n_1+n_0)^2s_1",
        because="the plant's numbers in balls; all $c_k$ of a stable wall are positive, so that "
        "$1+n_1\\beta\\le0$ would make $\\Delta_2$ negative",
    )


def reached(page, minor, second, third):
    """The largest stiffness, and that it is reached."""
    arm = {a: 1 + e - gamma * RISE}
    device = plant.Sampled(n_1, n_0, arm[a], e)
    largest = boundary.largest_undelayed(device)
    best = sqrt(n_0 * (n_0 + e * n_1 - gamma * n_0 * n_1))
    margin = n_0 * x * (largest - alpha) - RISE * (n_0 * x - best) ** 2 / (n_0 * n_1**2)
    page.show(
        "With $x=1+n_1\\beta>0$ the minor is a margin less a square",
        r"\Delta_2",
        r"n_0x(\alpha_{\max}-\alpha)-\frac{(n_1+n_0)(n_0x-w)^2}{n_0n_1^2},\quad "
        r"w=\sqrt{n_0(n_0+en_1-\gamma n_0n_1)}",
        page.same("margin", minor.subs(arm).subs(beta, (x - 1) / n_1), margin),
    )
    page.step(
        "The largest stable stiffness without delay has a closed form",
        largest,
        (RISE - best) ** 2 / (n_0 * n_1**2) - gamma,
        name=r"\alpha_{\max}(0)",
        because="if it is reached: at $n_0x=w$, just below it, the other inequalities must hold",
        boxed=True,
    )
    top = {alpha: (RISE - best) ** 2 / (n_0 * n_1**2) - gamma, beta: (best / n_0 - 1) / n_1}
    for name, title, plane in (("c_1", "second", second), ("c_3", "third", third)):
        fact = box.positive(plane.subs(top).subs(BALLS), WIDE, GIVEN)
        page.positive(f"There the {title} of them is positive", fact, IN_WIDE, name=name)
    page.say(
        "and $p_1(1)=(n_1+n_0)(\\alpha+\\gamma)$ is positive. So this holds for every spring up to "
        "ten times and every damper up to five times the largest of the paper's range (23), and "
        "$\\alpha_{\\max}$ itself is never stable."
    )


def ratio(page):
    """The first of the paper's ratios."""
    page.say(
        "The largest passive stiffness without delay is $\\alpha=2\\delta$, by (11). On the range "
        "of the paper:"
    )
    device = plant.Sampled(*(s.subs(BALLS) for s in (n_1, n_0, a, e)))
    largest = boundary.largest_undelayed(device)
    page.positive(
        "The stiffest stable wall is more than 17.8 times as stiff",
        box.positive(largest - Rational(356, 10) * delta, RANGES, GIVEN),
        IN_23,
        name=r"\alpha_{\max}(0)-17.8\cdot2\delta",
        because="$\\eta<1/17.8<0.0562$; at $\\delta=0$ no stiffness is passive at all",
    )
    low = box.positive(Rational(72, 100) - largest, RANGES, GIVEN)
    page.positive("No stable wall is stiffer than 0.72", low, IN_23, name=r"0.72-\alpha_{\max}(0)")
    end = Rational(1, 50)
    plants = [(Rational(1, 1000), end), (S.Zero, end), (S.Zero, Rational(201, 10000))]
    ratios = [over(most(*arm, 0), passive(arm[1], 0)) for arm in plants]
    names = [
        rf"\frac{{\alpha_{{\max}}}}{{2\delta}}\Big|_{{\gamma={g},\ \delta={v}}}"
        for g, v in (("0.001", 0.02), (0, 0.02), (0, 0.0201))
    ]
    page.enclosed(
        "The ratio is 17.8 and a little more",
        list(zip(names, ratios, strict=True)),
        because="17.8 is cut from these, 0.0562 is the inverse of the first, rounded up (that of "
        "the second is below 0.0561); just beyond the range 17.8 is too much",
    )
    claim = CLAIMED["s5b-eta-d0"](())
    page.settle(
        "s5b-eta-d0",
        of_ratio(claim, 0, UNDELAYED),
        example=example({gamma: S.Zero, delta: end}, taken_apart(claim)[1]),
        enclosed=True,
        value=(ratios[0], over(S.One, ratios[0])),
        note=r"both hold on all of (23); the numbers are those of its corner "
        r"$\gamma=0.001$, $\delta=0.02$",
    )
