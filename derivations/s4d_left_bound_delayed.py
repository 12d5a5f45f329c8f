r"""Does the stable region still reach the line $\alpha=-\gamma$ with a delay?

Without delay it does, for the arms of (23). A delay of one period changes nothing for a spring as
soft as an arm's, and it does for a stiff one.
"""

from sympy import Eq, Rational, S, diff, exp, pi, symbols

from symhaptic.book.lemmas.left_bound import SOFT, bound_of_arms, left_bound
from symhaptic.model import loop, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import alpha, beta, c, d, delta, gamma, t, x, z
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.stability import damped_region_ends_on_the_line
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import conjoined, weakened, widened
from symhaptic.proof.theorems.tactics import example, fact, for_all


def derive(page):
    soft_spring(page)
    page.say(
        "Now a spring far stiffer than an arm, without damping: $\\sqrt\\gamma=2\\pi/3$, so that "
        "$\\cos\\sqrt\\gamma=-\\tfrac12$. With $x=n_1\\beta$, on the line:"
    )
    swinging = plant.sampled(plant.normalised(Parts(damping=False)))
    gam = 4 * pi**2 / 9
    poly = loop.characteristic(Parts(damping=False)).subs(d, 1)
    poly = poly.subs({alpha: -gamma, beta: x / swinging.n1}).subs(gamma, gam)
    cubic = z**3 + 2 * z**2 + (x + Rational(3, 2)) * z + x
    page.show(
        "The other three roots are those of",
        r"p_1(z)/(z-1)",
        cubic,
        page.same("divided", poly, (z - 1) * cubic),
    )
    r1, r2, r3 = symbols("r_1 r_2 r_3")
    q2, q1, q0 = -(r1 + r2 + r3), r1 * r2 + r1 * r3 + r2 * r3, -r1 * r2 * r3
    product = (1 - r1 * r2) * (1 - r1 * r3) * (1 - r2 * r3)
    names = symbols("q_0 q_1 q_2")
    page.show(
        "Three roots inside need a positive product",
        product,
        1 - names[1] + names[0] * names[2] - names[0] ** 2,
        page.same("symmetric functions", product, 1 - q1 + q0 * q2 - q0**2),
        because="positive when all $|r_i|<1$, as non-real roots come in conjugate pairs; on the "
        "right stand the coefficients of $z^3+q_2z^2+q_1z+q_0$",
    )
    margin = 1 - (x + Rational(3, 2)) + 2 * x - x**2
    page.step(
        "At this wall the product is negative",
        margin,
        -((x - Rational(1, 2)) ** 2) - Rational(1, 4),
        because="negative for every $x$: no damping makes the line a border of the region",
    )
    stable = z**4 + z**3 + Rational(9, 10) * z**2 + Rational(1, 10)
    wall = {alpha: 0, beta: -Rational(1, 10) / swinging.n1}
    away = loop.characteristic(Parts(damping=False)).subs(d, 1).subs(wall).subs(gamma, gam)
    page.show(
        "A wall of that spring is stable",
        "p_1(z)",
        stable,
        page.same("away from the line", away, stable),
        because="for $\\alpha=0$, $n_1\\beta=-\\tfrac1{10}$, away from the line",
    )
    page.inside("Its roots lie inside the circle", stable)
    _settled(page)


def _settled(page):
    """What of all this is a theorem: the arms of (23), and damped arms with any spring."""
    page.say(
        "For the arms of (23) the exact curve of \\chapter{s4d_figure7_undelayed} shows that the "
        "region ends on the line without delay. With a delay every stable wall lies right of it."
    )
    claim = CLAIMED["s4d-left-bound"]([Eq(alpha, -gamma)])
    symbols, given, _ = taken_apart(claim)
    arms = page.lemma("The left bound of the arms of (23)", bound_of_arms())
    page.settle(
        "s4d-left-bound",
        Eq(alpha, -gamma),
        for_all(symbols, given, weakened(arms, *given)),
        example=example({alpha: S.Zero, gamma: S.Zero, delta: S.Zero}, given),
        note=r"for $d\ge1$ inside (23) only $\alpha>-\gamma$ is shown, and for $d=1$ and $d=2$ at "
        r"the limits of (23) that the line is reached to within the thickness of a line (fig9); a "
        r"stiff spring beyond (23) can keep the region away from it, such as "
        r"$\sqrt\gamma=\tfrac23\pi$ at $d=1$, $\delta=0$",
    )
    page.say(
        "A damped arm with any spring needs none of these estimates without delay, nor one with "
        "$\\gamma<2\\delta$ for one period. A wall that pulls, with little virtual damping, "
        "satisfies (5) then, so that it is stable (\\chapter{s5a_passive_is_stable}):"
    )
    found = page.lemma("The region of a damped arm ends on the line", left_bound(), boxed=True)
    claim = damped_region_ends_on_the_line()
    symbols, given, _ = taken_apart(claim)
    easy = {alpha: -S.One, gamma: S.One, delta: S.One, d: S.Zero}
    soft = SOFT.at(easy)
    there = widened(conjoined(*(fact(p) for p in soft.parts[0].parts)), soft)
    page.state(
        "left-bound-damped",
        "for a damped arm the stable region ends on the line $\\alpha=-\\gamma$ without delay, and "
        "for $d=1$ if $\\gamma<2\\delta$",
        claim=claim,
    )
    page.settle(
        "left-bound-damped",
        for_all(symbols, given, weakened(found, *given)),
        example=example(easy, given, there),
    )


def soft_spring(page):
    """One period of delay and gamma <= 1: the wall alpha = -gamma, beta = 0 has one root at 1."""
    given = {gamma: (delta**2 - c**2) / 4}
    device = plant.sampled(plant.normalised(FULL), split=c)
    motion = plant.normalised(FULL).transition(t, c).xreplace(given)
    place, speed = motion[0, 0].subs(t, 1), motion[1, 1].subs(t, 1)
    a, e, kept = symbols("a e r")
    line = loop.characteristic(FULL, split=c).subs({d: 1, alpha: -gamma, beta: 0})
    shape = z * (z - 1) * (z**2 + (1 - a) * z + e - kept)
    page.show(
        "For one period of delay and $\\beta=0$ the polynomial has the roots 0 and 1",
        "p_1(z)",
        shape,
        page.same(
            "roots",
            line.xreplace(given),
            shape.subs({a: device.a, e: device.e, kept: speed}, simultaneous=True),
        ),
        because="$r$ is the speed left of a unit speed. The quadratic has both roots inside "
        "if $e-r<1$, $2-a+e-r>0$ and $a+e-r>0$",
    )
    page.show(
        "The trace less the speed left is the position left",
        "a-r",
        symbols("y"),
        page.same("trace", device.a - speed, place),
        because="where $y$ is the position left after a period of a unit displacement",
    )
    page.show(
        "Newton's law ties speed and position",
        r"\tfrac{d}{dt}(e^{\delta t}v)",
        -gamma * exp(delta * t) * x,
        page.same(
            "after a unit displacement and after a unit speed",
            [diff(exp(delta * t) * motion[1, i], t) for i in (0, 1)],
            [-given[gamma] * exp(delta * t) * motion[0, i] for i in (0, 1)],
        ),
        because="for a motion that starts with a unit displacement or with a unit speed",
    )
    page.say(
        "By the energy of \\chapter{s4d_left_bound}, a unit speed carries the mass no further "
        "than $t$, so integrating over a period, $e-r\\le\\gamma/2$; a unit displacement stays "
        "below 1, so $y\\ge1-\\gamma/2$. For $\\gamma\\le1$ therefore $e-r<1$ and $a+e-r=y+e>0$, "
        "and $2-a+e-r=(1-a+e)+(1-r)>0$ as $1-a+e=\\gamma(n_1+n_0)\\ge0$ and $r<1$, unless "
        "$\\gamma=\\delta=0$. There take $\\beta=\\tfrac12$ instead:"
    )
    free = loop.characteristic(Parts(False, False)).subs({d: 1, alpha: 0, beta: S.Half})
    cubic = z**3 - z**2 + z / 4 + Rational(1, 4)
    page.step("For a free mass the polynomial has the root 1", free, (z - 1) * cubic, name="p_1(z)")
    page.inside("Its other roots lie inside", cubic)
