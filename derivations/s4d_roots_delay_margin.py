"""What is the delay margin of a wall?

A wall that is stable without delay may become unstable as the delay grows. The angles at which a
root can cross the circle do not depend on the delay. We ask at which of these angles roots leave
the unit disc, and at which delay the first root leaves it.
"""

from symhaptic.book.figures.stability import delay_margins
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at


def derive(page):
    page.say(
        "Let $h=-NW/A$. A root is a point where $z^{d+1}=h(z)$, and in this equation the delay "
        r"may be any real number (principal sheet). The equation $(d+1)\ln z=\ln h$ describes how "
        r"the root moves with the delay. Let $u+jw=z\,h'/h$ at $z=e^{j\theta}$; the imaginary "
        "part determines the direction of the root:"
    )
    page.step(
        "With growing delay, a root on the circle moves outwards if $w$ is positive",
        real_part(-I * theta / (d + 1 - u - I * w)),
        theta * w / ((d + 1 - u) ** 2 + w**2),
        name=r"\frac{\partial\ln|z|}{\partial d}",
    )
    page.step(
        "Along the circle the logarithm of $|h|$ has the derivative $-w$",
        real_part(I * (u + I * w)),
        -w,
        name=r"\frac{\partial\ln|h|}{\partial\theta}",
        because="so, with growing delay, roots leave the disc at an angle where the wall ceases "
        "to dominate, and return at an angle where the wall begins to dominate",
    )
    page.say(
        r"The surplus $|A|^2-|NW|^2$ has degree two in $y=4\sin^2\frac\theta2$, so it rises "
        r"at no more than one of its zeros. So roots leave at no more than one angle $\theta_1$. "
        "If there is no such angle, a wall that is stable without delay is stable with every "
        "delay. (If the wall dominates at $z=-1$, the sign of $p_1(-1)$ makes the loop unstable "
        r"for every other integer delay.) Let $\Phi_0$ be the phase of $NWz/A$:"
    )
    turns, phase = symbols("k Phi_0")
    critical = (phase + (2 * turns + 1) * pi) / theta - 2
    page.step(
        "A pair of roots leaves the unit disc at each delay of a sequence",
        (critical + 2) * theta,
        phase + (2 * turns + 1) * pi,
        name=r"(d_k+2)\,\theta_1",
        because=r"here $k$ is an integer, so one pair of roots leaves every $2\pi/\theta_1$ "
        "periods of delay",
    )
    page.say(
        r"The first $d_k\ge0$ is the delay margin, since no root can return before one has left. "
        "For integer delays the next integer is the first unstable delay. A free mass with "
        r"$\alpha=0.01$, $\beta=0.05$ has $\theta_1=0.1077$ and the margin $3.969$:"
    )
    free = {alpha: Rational(1, 100), beta: Rational(1, 20), gamma: S.Zero, delta: S.Zero}
    page.lemma(
        "With three periods of delay the wall $\\alpha=0.01$, $\\beta=0.05$ of a free mass is "
        "stable",
        stable_at({**free, d: S(3)}),
    )
    page.lemma(
        "With four periods of delay the wall $\\alpha=0.01$, $\\beta=0.05$ of a free mass is not "
        "stable",
        unstable_at({**free, d: S(4)}),
    )
    page.say(
        "With a fractional delay the plant has one more coefficient and the surplus has degree "
        "three. For each fraction, the phase gives the integer number of periods in the same "
        "way; the margin is the least value over all fractions, as plotted below."
    )
    page.figure(
        "delay_margin",
        r"The largest delay up to which a wall stays stable, for $\gamma=0.001$, $\delta=0.02$, "
        "and a close-up. The lines are the borders of the stable regions for $d=0$, 1, 2, 4 and 8.",
        delay_margins,
        panels=(1, 2),
        height=0.6,
    )
    page.state(
        "delay-margin",
        "with growing delay (on the principal sheet) a root on the circle moves outwards at an "
        "angle where the wall ceases to dominate, and inwards at an angle where it begins to "
        "dominate; the wall ceases to dominate at one angle at most",
        claim=both([leaves_where_the_wall_stops_to_lead(), at_one_angle()]),
    )
    page.settle(
        "delay-margin",
        conj(speed_outwards(), one_angle()),
        note=r"the radial velocity of a root is $\Re\{dz/(z\,dd)\}$; multiplied by "
        r"$|dp_1/d\theta|^2$, it equals $\tfrac\theta2$ times the slope of the surplus "
        "$|f|^2-|g|^2$",
    )


# The angle at which zeros leave the unit disc as the delay grows, by the sizes of plant and wall.

TURN = exp(I * theta)
PLANT = exp(I * (d + 1) * theta) * (TURN**2 - a * TURN + e)
WALL = (n_1 * TURN + n_0) * ((alpha + beta) * TURN - beta)
OTHER = Symbol("theta_1")
NAMES = (alpha, beta, n_1, n_0, a, e, d, theta)


def size(of: Expr) -> Expr:
    """The square of the absolute value."""
    return ((of + mirror(of)) / 2) ** 2 + ((of - mirror(of)) / (2 * I)) ** 2


SURPLUS = size(PLANT) - size(WALL)
"""The surplus of the plant over the wall."""

ZERO = Relation(PLANT + WALL, "=", S.Zero)
EQUAL = Relation(SURPLUS, "=", S.Zero)


@cache
def slope() -> Expr:
    """The slope of the surplus with respect to the angle."""
    return sp.diff(SURPLUS, theta)


def outwards() -> Relation:
    """Re dz/(z dd) at a zero, times abs(dp/dtheta)^2, is theta/2 times the slope of the surplus."""
    speed = sp.diff(PLANT + WALL, theta)
    outward = theta * (PLANT * mirror(speed) + mirror(PLANT) * speed) / 2
    return Relation(outward, "=", theta * slope() / 2)


def growing() -> Relation:
    """The surplus rises with the angle."""
    return Relation(S.Zero, "<", slope())


def twice() -> list[Proposition]:
    """At both angles the surplus is zero and rises."""
    there = [proposition(p) for p in (theta > 0, theta < pi, EQUAL, growing())]
    return [*there, *(p.at({theta: OTHER}) for p in there)]


def leaves_where_the_wall_stops_to_lead() -> Proposition:
    """At a zero on the circle the radial velocity has the sign of the slope of the surplus."""
    return every(NAMES, [ZERO], outwards())


def at_one_angle() -> Proposition:
    """The surplus is zero and rises at one angle at most."""
    return every((*NAMES, OTHER), twice(), Relation(theta, "=", OTHER))


@cache
def speed_outwards() -> Theorem:
    """If p = f + g is zero, the radial velocity is theta/2 times the slope of the surplus."""
    turned, zero = theta * sp.diff(WALL, theta) / 2, assume(ZERO)
    found = combined(outwards(), [zero, mirror(turned)], [mirrored(zero), turned])
    return for_all(NAMES, [ZERO], found)


@cache
def one_angle() -> Theorem:
    """The surplus is a quadratic in y = 2 - 2 cos(theta), so it rises at one zero at most."""
    wanted = Relation(theta, "=", OTHER)
    later = disj_cases(
        ordered(OTHER, theta),
        contr(_apart(OTHER, theta), wanted),
        both_ways(assume(theta <= OTHER), assume(theta >= OTHER)),
    )
    found = disj_cases(ordered(theta, OTHER), contr(_apart(theta, OTHER), wanted), later)
    return for_all((*NAMES, OTHER), twice(), found)


def _apart(smaller: Symbol, larger: Symbol) -> Theorem:
    """Two different angles lead to a contradiction."""
    rises = positive(
        _mean(smaller, larger) > 0, [S.Half, _rises(smaller)], [S.Half, _rises(larger)]
    )
    side = rising(cos, smaller, larger)
    low = [positive(smaller >= 0, smaller > 0), positive(larger <= pi, larger < pi)]
    ahead = closed(positive(2 * cos(smaller) - 2 * cos(larger) > 0, [2, side]), *low)
    product = (2 * cos(smaller) - 2 * cos(larger)) * _mean(smaller, larger)
    equal = [assume(EQUAL.at({theta: s})) for s in (larger, smaller)]
    nothing = combined(Relation(product, "=", S.Zero), [equal[0], 1], [equal[1], -S.One])
    return not_intro(combined(product > 0, [ahead, rises]), nothing)


def _quadratic(y: Expr) -> Expr:
    """The surplus."""
    static, total, stiff = 1 - a + e, n_1 + n_0, alpha + beta
    plant = static**2 + ((1 - e) ** 2 - static * (1 + e)) * y + e * y**2
    return plant - (total**2 - n_1 * n_0 * y) * (alpha**2 + stiff * beta * y)


def _rises(angle: Symbol) -> Theorem:
    """The quadratic rises with y where the surplus rises with the angle."""
    y = Symbol("y")
    slope = derivative(_quadratic(y), y).subs(y, 2 - 2 * cos(angle))
    sine = sign_of(sin, angle)
    found = over(
        slope > 0, assume(growing().at({theta: angle})), positive(2 * sin(angle) > 0, [2, sine])
    )
    return closed(found, positive(Ne(sin(angle), 0), [sine]))


def _mean(one: Symbol, other: Symbol) -> Expr:
    """(q(y) - q(y'))/(y - y') of the quadratic q, the mean of its two slopes."""
    y = Symbol("y")
    slope = derivative(_quadratic(y), y)
    return sum(slope.subs(y, 2 - 2 * cos(angle)) for angle in (one, other)) / 2
