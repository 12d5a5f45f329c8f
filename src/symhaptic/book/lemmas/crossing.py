"""At which angle can zeros leave the circle while the delay grows?  Plant and wall as two parts."""

from symhaptic.book.lemmas.prelude import *

TURN = exp(I * theta)
PLANT = exp(I * (d + 1) * theta) * (TURN**2 - a * TURN + e)
WALL = (n_1 * TURN + n_0) * ((alpha + beta) * TURN - beta)
OTHER = Symbol("theta_1")
NAMES = (alpha, beta, n_1, n_0, a, e, d, theta)


def size(of: Expr) -> Expr:
    """Real part squared and imaginary part squared."""
    return ((of + mirror(of)) / 2) ** 2 + ((of - mirror(of)) / (2 * I)) ** 2


SURPLUS = size(PLANT) - size(WALL)
"""By how much the plant leads."""

ZERO = Relation(PLANT + WALL, "=", S.Zero)
EQUAL = Relation(SURPLUS, "=", S.Zero)


@cache
def slope() -> Expr:
    """How the lead changes with the angle."""
    return sp.diff(SURPLUS, theta)


def outwards() -> Relation:
    """Re dz/(z dd) at a zero, times |dp/dtheta|^2: dp = 0 says dz/(z dd) = theta f/(dp/dtheta)."""
    speed = sp.diff(PLANT + WALL, theta)
    outward = theta * (PLANT * mirror(speed) + mirror(PLANT) * speed) / 2
    return Relation(outward, "=", theta * slope() / 2)


def growing() -> Relation:
    """The lead grows with the angle."""
    return Relation(S.Zero, "<", slope())


def twice() -> list[Proposition]:
    """At both angles the plant takes the lead."""
    there = [proposition(p) for p in (theta > 0, theta < pi, EQUAL, growing())]
    return [*there, *(p.at({theta: OTHER}) for p in there)]


def leaves_where_the_wall_stops_to_lead() -> Proposition:
    """At a zero on the circle the speed outwards has the sign of the slope of the plant's lead."""
    return every(NAMES, [ZERO], outwards())


def at_one_angle() -> Proposition:
    """Two angles at which the plant takes the lead are one."""
    return every((*NAMES, OTHER), twice(), Relation(theta, "=", OTHER))


@cache
def speed_outwards() -> Theorem:
    """The speed is theta/2 times the slope of the surplus, where p = f + g is zero."""
    turned, zero = theta * sp.diff(WALL, theta) / 2, assume(ZERO)
    found = combined(outwards(), [zero, mirror(turned)], [mirrored(zero), turned])
    return for_all(NAMES, [ZERO], found)


@cache
def one_angle() -> Theorem:
    """The surplus is q(y) of degree two, with y = 2 - 2 cos(theta), so that it rises once."""
    wanted = Relation(theta, "=", OTHER)
    later = disj_cases(
        ordered(OTHER, theta),
        contr(_apart(OTHER, theta), wanted),
        both_ways(assume(theta <= OTHER), assume(theta >= OTHER)),
    )
    found = disj_cases(ordered(theta, OTHER), contr(_apart(theta, OTHER), wanted), later)
    return for_all((*NAMES, OTHER), twice(), found)


def _apart(smaller: Symbol, larger: Symbol) -> Theorem:
    """At different angles it is falsehood."""
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
    """q' is positive where the surplus rises with the angle."""
    y = Symbol("y")
    slope = derivative(_quadratic(y), y).subs(y, 2 - 2 * cos(angle))
    sine = sign_of(sin, angle)
    found = over(
        slope > 0, assume(growing().at({theta: angle})), positive(2 * sin(angle) > 0, [2, sine])
    )
    return closed(found, positive(Ne(sin(angle), 0), [sine]))


def _mean(one: Symbol, other: Symbol) -> Expr:
    """(q(y) - q(y'))/(y - y'), half the sum of both slopes."""
    y = Symbol("y")
    slope = derivative(_quadratic(y), y)
    return sum(slope.subs(y, 2 - 2 * cos(angle)) for angle in (one, other)) / 2
