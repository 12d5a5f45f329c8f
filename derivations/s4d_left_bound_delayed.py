r"""Does the stable region still reach the line $\alpha=-\gamma$ with a delay?

Without delay it does, for the arms of (23). A delay of one period changes nothing for a spring as
soft as an arm's, and it does for a stiff one.
"""

from symhaptic.book.lemmas.left_bound import SOFT, bound_of_arms, left_bound
from symhaptic.book.lemmas.passive_is_stable import DEVICE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.model import loop, plant
from symhaptic.paper.propositions.stability import damped_region_ends_on_the_line


def derive(page):
    soft_spring(page)
    page.say(
        "Now a spring far stiffer than an arm, without damping: $\\sqrt\\gamma=2\\pi/3$, so that "
        "$\\cos\\sqrt\\gamma=-\\tfrac12$. With $x=n_1\\beta$, on the line:"
    )
    swinging = plant.sampled(plant.normalised(Parts(damping=False)))
    spring = {gamma: 4 * pi**2 / 9}
    poly = loop.characteristic(Parts(damping=False)).subs(d, 1)
    poly = poly.subs({alpha: -gamma, beta: x / swinging.n1}).subs(spring)
    page.step(
        "The other three roots are those of a cubic",
        poly / (z - 1),
        z**3 + 2 * z**2 + (x + Rational(3, 2)) * z + x,
        name=r"p_1(z)/(z-1)",
    )
    roots, names = symbols("r_1 r_2 r_3"), symbols("q_0 q_1 q_2")
    one, two, three = roots
    made = ((z - one) * (z - two) * (z - three)).expand()
    by_roots = -one * two * three, one * two + one * three + two * three, -one - two - three
    for power, (name, value) in enumerate(zip(names, by_roots, strict=True)):
        page.step(
            f"Three roots give the coefficient of power {power}",
            made.coeff(z, power),
            value,
            name=name,
        )
    page.step(
        "Three roots inside need a positive product",
        1 - names[1] + names[0] * names[2] - names[0] ** 2,
        (1 - one * two) * (1 - one * three) * (1 - two * three),
        because="positive when all $|r_i|<1$, as non-real roots come in conjugate pairs",
    )
    page.step(
        "At this wall the product is negative",
        1 - (x + Rational(3, 2)) + 2 * x - x**2,
        -((x - Rational(1, 2)) ** 2) - Rational(1, 4),
        because="negative for every $x$: no damping makes the line a border of the region",
    )
    damping = (-1 / (10 * swinging.n1)).subs(spring)
    page.lemma(
        "Beside that spring a wall away from the line is stable one period late",
        stable_at({alpha: S.Zero, beta: damping, delta: S.Zero, d: S.One, **spring}),
        because="for $\\alpha=0$, $n_1\\beta=-\\tfrac1{10}$",
    )
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
        for_all(symbols, given, add_assum(arms, *given)),
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
    there = disj(conj(*(fact(p) for p in soft.parts[0].parts)), soft)
    page.state(
        "left-bound-damped",
        "for a damped arm the stable region ends on the line $\\alpha=-\\gamma$ without delay, and "
        "for $d=1$ if $\\gamma<2\\delta$",
        claim=claim,
    )
    page.settle(
        "left-bound-damped",
        for_all(symbols, given, add_assum(found, *given)),
        example=example(easy, given, there),
    )


def soft_spring(page):
    """One period of delay and gamma <= 1: the wall alpha = -gamma, beta = 0 has one root at 1."""
    line = loop.named().subs({d: 1, alpha: -gamma, beta: 0})
    roots = Eq(line, z * (z - 1) * (z**2 + (1 - a) * z + gamma * n_0))
    static = device_static(assume(DEVICE))
    page.lemma(
        "For one period of delay and $\\beta=0$ the polynomial on the line has the roots 0 and 1",
        combined(roots, [static, z**2]),
        because="the quadratic has both roots inside if $\\gamma n_0<1$, $2-a+\\gamma n_0>0$ and "
        "$a+\\gamma n_0>0$",
    )
    page.say(
        "A force that is held for a period moves the mass by half a unit at most, so that "
        "$n_1\\le\\frac12$, and $n_0\\le n_1$. For $\\gamma\\le1$ therefore $\\gamma n_0<1$, "
        "$a+\\gamma n_0=1+e-\\gamma n_1>0$ and $2-a+\\gamma n_0=1-e+\\gamma(n_1+2n_0)>0$, unless "
        "$\\gamma=\\delta=0$. There take $\\beta=\\tfrac12$ instead:"
    )
    free = loop.characteristic(Parts(False, False)).subs({d: 1, alpha: 0, beta: S.Half})
    cubic = z**3 - z**2 + z / 4 + Rational(1, 4)
    page.step("For a free mass the polynomial has the root 1", free, (z - 1) * cubic, name="p_1(z)")
    page.lemma("All zeros of this cubic lie inside the unit circle", roots_inside(cubic, z, {}))
