r"""Roots outside the unit circle, counted at a cost that does not grow with the delay.

On the circle a root needs :math:`|A|=|M||W|` of the device and the wall, a quadratic in
:math:`y=4\sin^2(\theta/2)` that does not contain the delay; between its solutions one side leads
and takes the argument along.  Chapter s4d_roots_counted derives this.  The quadratic is expanded
about y = 0, about the device's own frequency and about y = 4, and each root taken from the nearest.

The count is certain or it is NaN.  At each crossing A, M and W are computed with bounds of their
errors.  What is left of |A| - |M||W| there, and the derivative of its logarithm, bound how far
the true crossing is; that and the errors of the three arguments bound the error of the phase.
Where an odd number of half turns is within that bound, a root may be on either side of the circle.

Behind a fraction of a period it is a cubic in y; chapter s6b_fractional_stability.  Between the
points of expansion it is cut where it has an extremum or an inflection, and on each piece Newton's
method goes to the root from the end from which it never overshoots.

Without a spring the surplus is not positive at y = 0, and a wall that is as strong as the device at
y = 4, too, is the stronger one everywhere: no loop is stable then.  Any other wall is as strong as
the device once, and what is left of the phase there decides; s4d_roots_counted_without_spring.
"""

from __future__ import annotations

from math import ceil, log2
from types import SimpleNamespace

from symhaptic.export.routines.prelude import *
from symhaptic.forms.root_count import ARGUMENTS, FRACTIONAL_ARGUMENTS

alpha, beta, d, n1, n0, gamma, at_minus_one, loss, together, apart = ARGUMENTS
_, _, _, m2, m0, *_, across, delta = FRACTIONAL_ARGUMENTS
y, rest, off, loose, free = POINT = sp.symbols("y rest off loose free")
"""y, 4 - y and y - center; the parts of the first two, and how much of the last, may be off."""

slope, far, apart_off, n1_off, a_off, center, beyond = sp.symbols(
    "slope far apart_off n1_off a_off center beyond"
)
LOOP = alpha, slope, far, d, n1, loss, together, apart, apart_off, n1_off, a_off
"""What a crossing is told of wall and device: besides their last places M and A at z = -1 and n1
may be off by the last three."""

TERMS = sp.symbols("k0 k1 k2 k3")
"""The coefficients of a cubic, that of the lowest power first."""

WHOLE_LOOP = (*LOOP, center, beyond)
"""And the own frequency of the device, as y and 4 - y.  Behind a fraction n1 stands for m2 - m0."""


def unit(precision):
    """By so much of themselves the numbers of a device may be off, with a margin.

    In half last places 8; tests measure 4 at most, and 6 for M(-1).
    """
    return 4 * precision.last


def _turned_off(precision, spring=gamma):
    """By so much more A(-1) may be off near half turns: its root to twice the digits of a float."""
    return do("a_off", 32 * precision.last**2 * sqrt(spring * at_minus_one))


def _flat(terms, least, size, unit, more=S.Zero):
    """Whether c + b y + a y^2 (+ k y^3) may have two roots next to y = 0, and may have none.

    A product of up to four numbers of the device is off by 4 units at most; ``more`` of b is lost
    besides.  Where c and a differ in sign there is one root.  The size of c is at least ``least``:
    where it exceeds what the other terms take from it, y <= 4, there is none.
    """
    c, b, a, *k = terms
    room, product = do("room", 4 * unit * size + more), do("product", 4 * c * a)
    takes = 4 * room + sum(64 * Abs(x) for x in k)
    return And(Abs(b) <= room, product >= 0, product <= room * room, least <= 2 * takes)


def _hides(terms, least, off, cubed):
    """Whether c + b y + a y^2 + k y^3 may have two roots between which no extremum is found.

    If b and k have one sign and a has the other, b + a y + k y^2 has two roots where a^2 >= 4 b k.
    The a that is computed is off by at most ``off``, and may have neither this size nor this sign.
    If it is 8 times as large, the extrema are found.  k is off by ``cubed``.  As in :func:`_flat`,
    there are no roots where the size of c, at least ``least``, exceeds the other terms.
    """
    _, b, a, k = terms
    outer, takes = do("outer", b * k), 320 * off + 64 * (Abs(k) + cubed)
    small = And(Abs(a) <= 8 * off, Abs(b) <= 36 * off)  # those roots are at most 4
    return And(small, outer >= 0, outer <= (5 * off) ** 2, least <= 2 * takes)


def _leads(terms):
    """Whether the wall leads next to the end: the first coefficient that is not 0 is negative."""
    leads = terms[-1] < 0
    for c in terms[-2::-1]:
        leads = Or(c < 0, And(Eq(c, 0), leads))
    return leads


def _faint(precision, spring=gamma):
    """Whether squares vanish that decide: those of wall and damping, or of the stiffnesses.

    Of a wall and a damping neither is seen to lead then, of the stiffnesses not at z = 1.
    """
    strength = do("strength", Abs(alpha) + Abs(beta))
    stiffest = do("stiffest", Max(Abs(alpha), spring))
    weak = precision.vanishing
    return And(strength > 0, Or(strength + loss < weak, And(stiffest > 0, stiffest < weak)))


def _at_the_end(far, unit, a_off, apart_off=S.Zero):
    """Whether the wall may be as strong as the device at z = -1, where a root may be then.

    And the least size of A(-1)^2 - (M W)(-1)^2, where it is not.
    """
    pull = do("pull", Abs(apart * far))
    off = do("end_off", 2 * unit * (at_minus_one + pull) + apart_off * Abs(far) + a_off)
    apart_by = do("end_apart", Abs(at_minus_one - pull) - off)
    return apart_by <= 0, do("end_least", apart_by * (at_minus_one + pull))


def _wall():
    """alpha + beta, its product with beta, and alpha + 2 beta."""
    slope, far = do("slope", alpha + beta), do("wall_far", alpha + 2 * beta)
    return slope, do("force", slope * beta), far


def _counted(unsure, total):
    """A count that is certain, else -1; without a wall none is outside."""
    bare = And(Eq(alpha, 0), Eq(beta, 0))
    known = do("known", total)
    return choose(bare, 0, choose(unsure, -1, choose(known >= 0, known, -1)))


def _ends(total, near, far_terms, slope, far, across):
    """The count with what the ends of the circle add to it."""
    side = do("side", choose(slope >= 0, 1, -1))
    begin = choose(alpha > 0, 0, side)
    end = choose(far > 0, side, 0) - (d + 3) + choose(apart > 0, choose(across >= 0, 1, -1), 0)
    end = do("end", end)
    total = do("total", total + choose(_leads(near), begin, 0))
    return do("total", total - choose(_leads(far_terms), end, 0))


# -- what is known at a crossing ---------------------------------------------------------------

_WIDE = sp.Integer(4)
"""More than half a turn: nothing is known of an angle that is so far off."""


@routine("halves rest size per off blur slope fast bend turn spread", record="Part",
         called="halves turned size per away blur rise fast bend turn spread")  # fmt: skip
def crossing_part(x, u, x_off, u_off, steep, low, high, precision):
    """of x + j u: half turns and the rest of the angle, the size and its inverse, how far both may
    be off, and how they change with y"""
    # the real part is linear in y, and u goes with sin(theta); derivatives are those by y, times
    # the distance to the nearer end of the circle, which makes edge/y low and edge/(4 - y) high
    most, least = do("most", Max(Abs(x), Abs(u))), do("least", Min(Abs(x), Abs(u)))
    ratio = do("ratio", least / do.nonzero(most))
    size = do("size", most * do("longer", sqrt(1 + ratio * ratio)))
    per = do("per", 1 / do.nonzero(size))
    real, up = do("real", x * per), do("up", u * per)
    along, across = do("along", x_off * per), do("across", u_off * per)
    away = do("away", along + across)
    one, two = do("one", Abs(real)), do("two", Abs(up))
    blur = do("blur", (one * across + two * along) * (1 + 2 * away))
    rest = do("rest", atan2(choose(x < 0, -u, u), Abs(x)))
    falls, tilt = do("falls", steep * per), do("tilt", (low - high) / 2)
    square = do("square", up * up)
    fast = do("fast", 2 * Abs(falls) + square * (low + high))
    return (
        choose(x < 0, choose(u < 0, -1, 1), 0),  # where u keeps its sign, which is + for 0
        rest,
        size,
        per,
        choose(size > 0, one * along + two * across + away * away, 1),
        # what is left of the number is at least three quarters of its size
        choose(4 * away < 1, blur + unit(precision) * Abs(rest) / 2, _WIDE),
        2 * (real * falls + square * tilt),  # the derivative of 2 ln(size)
        fast,  # the same with all terms positive
        2 * (falls * falls + square * low * high) + fast * fast,  # the most of its second one
        up * (real * tilt - falls),  # the derivative of the angle
        two * (one * Abs(tilt) + Abs(falls)),  # the same with all terms positive
    )


def _part(x, u, x_off, u_off, steep):
    """A, M or W, four times as large, and what :func:`crossing_part` finds of it."""
    found = crossing_part(x, u, x_off, u_off, *steep)
    return SimpleNamespace(**dict(zip(crossing_part.gives, found, strict=True)))


def _parts(y, rest, unit, moving=True):
    """A/z, M/z and W at a point, with what the device, the point and three roundings may miss.

    And 4 sin(theta), and the distance to the nearer end.
    """
    sine, total = do("sine", 2 * sqrt(y * rest)), do("total", 2 - loss)
    plain, made = do("plain", loose + unit / 2), do("made", loose + unit * 3 / 2)
    edge = do("edge", Min(y, rest))
    ends = [do(name, edge / do.nonzero(end)) for name, end in (("low", y), ("high", rest))]

    def moved(steep):
        return (edge * steep, *ends) if moving else (0, 0, 0)

    below = _part(
        do("ahead", -2 * total * off), do("up", loss * sine),
        total * (unit * Abs(off) + 2 * free) + 4 * a_off, made * loss * sine, moved(-2 * total),
    )  # fmt: skip
    above = _part(
        together * rest - apart * y, n1 * sine,
        made * (together * rest + Abs(apart) * y) + apart_off * y,
        (made * Abs(n1) + n1_off) * sine, moved(-(together + apart)),
    )  # fmt: skip
    force = _part(
        alpha * rest - far * y, slope * sine,
        plain * (Abs(alpha) * rest + Abs(far) * y), plain * Abs(slope) * sine,
        moved(-(alpha + far)),
    )  # fmt: skip
    return (below, above, force), sine, edge


def _gap(parts, unit):
    """1 - |M W/A|, and the most by which that is off; finding the sizes rounds, too."""
    below, above, force = parts
    ratio = do("ratio", above.size * below.per)
    gap = do("gap", 1 - ratio * force.size / 4)
    return gap, do("rough", below.off + above.off + force.off + 3 * unit / 2)


@routine(takes="Loop", point=POINT, loop=LOOP)
def touches(leads, point, loop, precision):
    """NaN where it is not certain that the device is stronger if leads is positive, and else the
    wall, else 0"""
    # at an extremum of |A|^2 - |M W|^2, whose sign tells whether there are crossings
    last = unit(precision)
    y, rest, *_ = point
    parts, _, _ = _parts(do("at", Max(y, 0)), do("still", Max(rest, 0)), last, moving=False)
    gap, rough = _gap(parts, last)
    gap = do("signed", choose(leads > 0, gap, -gap))
    good = do("good", choose(gap > 2 * rough, 1, 0))  # not where the gap is NaN
    return choose(And(y > 0, rest > 0, good < 1), sp.nan, 0)


@routine(takes="Loop", point=POINT, loop=LOOP)
def phase_turns(point, loop, precision):
    """the nearest whole number of turns in the phase at a crossing, NaN where that is not
    certain"""
    # of wall and delay beside the device; how far the crossing is from this point at most follows
    # by Newton and Kantorovich, of 2 ln |A/(M W)|
    last = unit(precision)
    y, rest = do("at", Max(point[0], 0)), do("still", Max(point[1], 0))
    parts, sine, edge = _parts(y, rest, last)
    below, above, force = parts
    gap, rough = _gap(parts, last)
    gap = do("distant", Abs(gap))
    miss = [do("miss", last + 3 * part.off) for part in parts]
    slope_off = sum(part.fast * off for part, off in zip(parts, miss, strict=True))
    steep = do("sure", Abs(below.slope - above.slope - force.slope) - slope_off)
    reach = do("reach", 9 * (gap + rough) / (4 * do.nonzero(steep)))
    bend = do("bends", below.bend + above.bend + force.bend)
    known = And(steep > 0, 8 * bend * reach < steep, 4 * reach < 1)
    high = y > 2
    half = do("half", atan2(sqrt(choose(high, rest, y)), sqrt(choose(high, y, rest))))
    late = do("late", d + 2)
    halves = do("halves", above.halves + force.halves - below.halves - choose(high, late, 0))
    around = do("around", late * choose(high, -2 * half, 2 * half))
    turned = above.rest + force.rest - below.rest - around
    share = do("share", turned / (2 * pi))
    even = do("even", floor(halves / 2))
    left = do("left", halves / 2 - even)
    odd = Eq(left, S.Half)  # the sign of the rest decides, however small it is
    found = do("found", even + choose(odd, floor(share) + 1, floor(share + left + S.Half)))
    near = do("near", Abs(share - floor(share + S.Half)))
    distance = do("distance", choose(odd, near, S.Half - near))
    # the phase turns by so much over the reach; what goes with sin(theta) has roots of y and 4 - y
    delayed = do("delayed", 2 * late * edge / do.nonzero(sine))
    turning = Abs(above.turn + force.turn - below.turn - delayed)
    most = do("most", delayed + below.spread + above.spread + force.spread)
    fast = 2 + below.fast + above.fast + force.fast
    lost = sum(part.spread * off for part, off in zip(parts, miss, strict=True))
    moved = reach * (turning + lost + last * delayed + 2 * reach * most * fast)
    blur = below.blur + above.blur + force.blur + late * (last + loose) * half
    good = And(known, do("blur_", blur + moved) < 6 * distance)
    good = do("good", choose(good, 1, 0)) > 0
    return choose(good, found, sp.nan)


# -- behind a whole delay ----------------------------------------------------------------------


def _summed(name, *terms):
    """The sum, and that of the sizes."""
    return do(name, sp.Add(*terms)), do(f"{name}_size", sp.Add(*map(Abs, terms)))


def _about(e, slope, force, wall_far):
    """The quadratic about 0, the own frequency and 4, and that frequency's y and 4 - y.

    As (c, b, a), the first and the last with b when all of its terms are positive.  At y = 0 it is
    (gamma^2 - alpha^2) (n1 + n0)^2: its sign is that of two exact differences.
    """
    cross, lost = do("cross", n1 * n0), do("lost", loss * loss)
    square, at_one = do("square", e + cross * force), do("at_one", gamma * together)
    even = do("even", together * together)
    pull = do("pull", apart * wall_far)
    b, most = _summed("near1", lost, -at_one * (1 + e), cross * alpha**2, -even * force)
    first = do("near0", do("apart_one", (gamma - alpha) * (gamma + alpha)) * even)
    near = (first, b, square), most
    terms = lost, -at_minus_one * (1 + e), -cross * wall_far**2, apart**2 * force
    b, most = _summed("far1", *terms)
    far = (do("far0", (at_minus_one - pull) * (at_minus_one + pull)), b, square), most
    center, beyond = do("center", 2 * at_one / (1 + e)), do("beyond", 2 * at_minus_one / (1 + e))
    sine, tilt = do("sine", center * beyond / 4), do("tilt", (beyond - center) / 4)
    real = do("real", (together * beyond - apart * center) / 4)
    m0, m1 = do("m0", real**2 + n1**2 * sine), do("m1", n1**2 * tilt - n1 * real)
    wave = do("wave", (alpha * beyond - wall_far * center) / 4)
    wall = do("wall", wave**2 + slope**2 * sine)
    own = (
        do("own0", lost * sine - m0 * wall),
        do("own1", lost * tilt - m1 * wall - m0 * force),
        do("own2", e - m1 * force),
    )
    return near, own, far, center, beyond


def _root(parts):
    """The root of the discriminant, from the point where its terms are smallest, and its sign."""
    discs, sizes = [], []
    for c, b, a in parts:
        square, product = do("square", b * b), do("product", 4 * c * a)
        discs.append(do("disc", square - product))
        sizes.append(do("size", square + Abs(product)))
    first = And(sizes[1] <= sizes[0], sizes[1] <= sizes[2])
    third = And(sizes[2] < sizes[0], sizes[2] < sizes[1])
    disc = do("disc", choose(first, discs[1], choose(third, discs[2], discs[0])))
    return do("root", sqrt(do("positive", choose(disc >= 0, disc, 0)))), disc


@routine("low high", record="Roots")
def quadratic_roots(c, b, a, root):
    """(-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite"""
    upper = b >= 0  # the quotient of the two makes the second one
    q = do("q", -(b + choose(upper, root, -root)) / 2)
    lead, own = do("lead", choose(Eq(a, 0), 1, a)), do("own", choose(Eq(q, 0), 1, q))
    one = do("one", choose(Eq(a, 0), -1, q / lead))
    two = do("two", choose(Eq(q, 0), -1, c / own))
    return choose(upper, one, two), choose(upper, two, one)


def _extremum(c, b, a):
    """Where a quadratic is largest or smallest; -1 for what is infinite."""
    return choose(Eq(a, 0), -1, -b / (2 * do.nonzero(a)))


def _on_circle(y, rest):
    """Whether a root is there, of y and 4 - y that are known apart; -1 is infinite."""
    return And(y > 0, rest > 0, Min(y, rest) < 4)


def _point_off(unit):
    """The parts of y and 4 - y that may be off: those of the own frequency, which is at most y
    twice, and next to the ends of a rounding."""
    return 2 * unit, unit / 4


@routine("at still away loose free there", record="Point", takes="Loop")
def nearest_point(y, rest, off, center, beyond, precision):
    """a point that is known about three, and whether it is on the circle"""
    last = unit(precision)  # about y = 0, about the own frequency and about 4, from the nearest
    small = y < rest
    edge = do("edge", choose(small, y, rest))
    inside = And(Abs(off) < edge, center + off > 0, beyond - off > 0)
    inside = do("inside", choose(inside, 1, 0)) > 0
    return (
        choose(inside, center + off, choose(small, y, 4 - rest)),
        choose(inside, beyond - off, choose(small, 4 - y, rest)),
        choose(inside, off, choose(small, y - center, beyond - rest)),
        choose(inside, *_point_off(last)),
        choose(inside, 0, last * choose(small, center, beyond)),
        choose(_on_circle(y, rest), 1, 0),
    )


def _of_nearest(found, *first):
    """A function of the point of expansion that is nearest, if that is on the circle."""
    *point, there = nearest_point(y, rest, off, center, beyond)
    point[:2] = (do(s.name, choose(there > 0, s, 2)) for s in point[:2])
    return choose(there > 0, found(*first, tuple(point), LOOP), 0)


@routine(takes="Loop", loop=LOOP)
def crossing_turns(y, rest, off, center, beyond, loop):
    """the turns at a crossing, if there is one"""
    return _of_nearest(phase_turns)


@routine(takes="Loop", loop=LOOP)
def bottom_touches(leads, y, rest, off, center, beyond, loop):
    """NaN where the wall may be as strong as the device at an extremum of both, else 0"""
    return _of_nearest(touches, leads)


@routine(given=ARGUMENTS)
def whole_roots(given, precision):
    """roots outside the unit circle, -1 where that is not certain"""
    weak = _faint(precision)
    e = do("e", 1 - loss)
    slope, force, far = _wall()
    (near, most), own, (end, end_most), center, beyond = _about(e, slope, force, far)
    a_off, last = _turned_off(precision), unit(precision)
    end_unsure, least = _at_the_end(far, last, a_off)
    unsure = [
        weak,
        end_unsure,
        _flat(near, Abs(near[0]), most, last),
        _flat(end, least, end_most, last, 2 * a_off),
    ]
    root, disc = _root((near, own, end))
    ys, offs, rests = (quadratic_roots(*k, root) for k in (near, own, end))
    rests = rests[::-1]
    loop = alpha, slope, far, d, n1, loss, together, apart, S.Zero, S.Zero, a_off
    one, two = (crossing_turns(*point, center, beyond, loop)
                for point in zip(ys, rests, offs, strict=True))  # fmt: skip
    bottoms = (do("bottom", _extremum(*k)) for k in (near, end, own))
    none = bottom_touches(near[2], *bottoms, center, beyond, loop)
    inside = [choose(And(disc >= 0, _on_circle(*at)), 1, 0) for at in zip(ys, rests, strict=True)]
    sides = [choose(_leads(k), 1, 0) for k in (near, end)]
    odd = [do("odd", Abs(one - two)) for one, two in (inside, sides)]
    total = do("total", choose(disc >= 0, 2 * (one - two), none))
    total = _ends(total, near, end, slope, far, n1)
    return _counted(Or(*unsure, Ne(*odd)), total)


@routine()
def stable(roots, alpha, beta, gamma, delta, precision):
    """1 if the loop is stable, 0 if it is not, -1 if that is not certain"""
    # no root outside, none at 1, and no device that swings on whatever the wall does
    swing = do("swing", sqrt(gamma))
    free = And(Eq(alpha, 0), Eq(beta, 0), Eq(delta, 0), gamma > 0)
    bound = 2 * precision.last * swing
    stuck = And(delta < 5 * precision.last, gamma > 1, Abs(sp.sin(swing)) <= bound)
    yes = do("yes", choose(And(Eq(roots, 0), alpha > -gamma, Not(free), Not(stuck)), 1, 0))
    return yes - choose(Or(yes > 0, roots > 0, alpha <= -gamma, free), 0, 1)


@routine()
def free_stable(alpha, beta, d, n1, n0, at_minus_one, loss, together, apart, precision):
    """1 if a loop without a spring is stable, 0 if it is not, -1 if that is not certain"""
    # the angle is that of the crossing; no turn is left of its phase where none is outside
    last = unit(precision)
    slope, force, far = _wall()
    cross = do("cross", n1 * n0)
    push = do("push", together * alpha)
    c, a = do("near0", push * push), do("square", 1 - loss + cross * force)
    b = do("near1", loss * loss + cross * alpha**2 - together**2 * force)
    size = do("size", Abs(b) + sqrt(Max(b * b + 4 * a * c, 0)))
    y = do("y", choose(b < 0, size / (2 * do.divisor(a)), 2 * c / do.divisor(size)))
    rest = do("rest", Max(4 - y, 0))
    a_off = _turned_off(precision, S.Zero)
    loop = alpha, slope, far, d, n1, loss, together, apart, 0, 0, a_off
    point = y, rest, y, last / do.nonzero(rest), S.Zero  # the last rounding of 4 - y counts
    turns = do("turns", phase_turns(point, loop))
    end, _ = _at_the_end(far, last, a_off)
    pull = do("weaker", Abs(apart * far) - at_minus_one)
    clear = And(Not(end), Not(_faint(precision, S.Zero)))
    kicked = Abs(n0 * beta) > 2  # by more than 1, with a margin: the product of all roots
    counted = choose(Eq(turns, 0), 1, choose(Or(Abs(turns) > 0, kicked), 0, -1))  # turns may be NaN
    strong = choose(Or(alpha <= 0, kicked, And(pull >= 0, clear)), 0, -1)
    return choose(And(alpha > 0, pull < 0, clear), counted, strong)


# -- behind a fraction of a period -------------------------------------------------------------

_NEAR = 16
"""How many times larger than its root the place may be at most from which Newton's method goes."""


def _steps(precision):
    """After how many steps Newton's method is at the last place of the root of a cubic.

    Each leaves two thirds of the distance at most.  Let f and f' be positive and f convex at a
    distance of u above the root r, at y.  Then f'/f is the sum of 1/(y - s) over all roots s.  A
    real one is at r, below it or above y, so it adds 1/u at most.  Two complex ones of the real
    part c add 2/(y - c) at most if c < y, else less than 0.  With r < c < y the inflection, which
    is the mean of all roots, would lie between r and y.  So f'/f <= 3/u.
    """
    return ceil((precision.bits + log2(_NEAR)) / log2(1.5))


def _halvings(precision):
    """How often the exponent is halved before: the faintest root is the square of the faintest
    wall that is counted, and the largest one is below 4."""
    return ceil(log2(log2(4 / float(precision.vanishing) ** 2) / log2(_NEAR)))


NEAR, OWN, FAR = range(3)
"""Zones: y, y - center and 4 - y are the variable."""

_STIFF = sp.Integer(10)
"""A device that is stiffer, and is damped little, turns more than half a turn in a period."""


def _value(terms, y):
    found = terms[-1]
    for k in terms[-2::-1]:
        found = found * y + k
    return found


def _about_end(name, lost, square, size, first, at, top, force, tilt):
    """|A|^2 - |M|^2 |W|^2 about an end, from its value and those of A, M and W there.

    ``square`` is m2 m0, ``size`` (m2 - m0)^2.  And the second and the third coefficient with all
    terms positive.
    """
    even = do("even", top * (m2 + m0))
    linear, push = do("linear", size - even), do("push", force**2)
    terms = (
        do(f"{name}0", first),
        do(f"{name}1", lost - at * (2 - loss) - linear * push - top**2 * tilt),
        do(f"{name}2", 1 - loss - square * push - linear * tilt),
        do(f"{name}3", -square * tilt),
    )
    cross = do("cross", size + Abs(even))
    sizes = lost, at * (2 - loss), cross * push, top**2 * Abs(tilt)
    bent = do("bent", 1 + Abs(square) * push + cross * Abs(tilt))
    return terms, do("most", sp.Add(*sizes)), bent


def _about_own(lost, square, size, middle, rest, slope, force, far):
    """The same about the device's own frequency."""
    sine, tilt = do("sine", middle * rest / 4), do("tilt", (rest - middle) / 4)
    real = do("real", (together * rest - apart * middle) / 4)
    one = do("one", real**2 + size * sine)
    two = do("two", size * tilt - (m2 + m0) * real)
    wave = do("wave", (alpha * rest - far * middle) / 4)
    wall = do("wall", wave**2 + slope**2 * sine)
    return (
        do("own0", lost * sine - one * wall),
        do("own1", lost * tilt - two * wall - one * force),
        do("own2", 1 - loss - square * wall - two * force),
        do("own3", -square * force),
    )


def rounded_turn(last):
    """By how much m2, m0 and m2 + m0 of a stiff device may be off besides their last places.

    The angles that it turns in the parts of a period are products of rounded numbers.  Their errors
    are as many last places of sqrt(gamma), and m2 and m0 are 1 - cos of them over gamma.  In a part
    f the cosine is damped by exp(-f delta/2), and f times this is at most 2/(e delta).
    """
    slow = sqrt(Max(gamma, 1)) * Max(delta, 1)
    return do("turn_off", choose(gamma > _STIFF, last / slow, 0))


def _blurs(at_one, turn_off, last):
    """By how much M(-1) and m2 - m0 may be off: the first near half turns, that near whole ones.

    There each term of their sums is as small as the root of A(-1) or of A(1).
    """
    size = do("size", m2 + Abs(m0) + together)
    near_half, near_one = (do("near", sqrt(Min(end, 1))) for end in (at_minus_one, at_one))
    stiff = And(gamma > _STIFF, loss < S.Half)
    near_whole = choose(stiff, 2 * near_one / do.nonzero(gamma), size / 8)
    apart_off = do("apart_off", near_half * (8 * last * size + 2 * turn_off))
    return apart_off, do("n1_off", 16 * last * near_whole + near_one * turn_off)


def _unsure(terms, least, sizes, last, off):
    """Whether roots may be missed; b, a and k are off by ``off`` besides their last places."""
    return (
        _flat(terms, least, sizes[0], last, off[0]),
        _hides(terms, least, 4 * last * sizes[1] + off[1], off[2]),
    )


@routine(given=FRACTIONAL_ARGUMENTS)
def fractional_roots(given, precision):
    """roots outside the unit circle with a fractional delay, -1 if that is not certain"""
    weak, x = _faint(precision), expanded(precision)
    one, two = do("one", x.center / 2), do("two", x.beyond / 2)
    before, after = do("before", _value(x.own, -one)), do("after", _value(x.own, two))
    loop = (*x.loop, x.center, x.beyond)
    zones = [do("zone", sp.Integer(number)) for number in (NEAR, OWN, FAR)]
    found = zone_turns(x.near, zones[0], one, x.near[0], before, zones[0], loop)
    found += zone_turns(x.own, -one, two, before, after, zones[1], loop)
    found += zone_turns(x.end, zones[0], two, x.end[0], after, zones[2], loop)
    total = _ends(found, x.near, x.end, x.slope, x.far, across)
    return _counted(Or(weak, *x.unsure), total)


def expanded(precision):
    """|A|^2 - |M|^2 |W|^2 about both ends and about the device's own frequency, this frequency, and
    what a crossing is told; and where the ends decide nothing."""
    last = unit(precision)
    slope, force, far = _wall()
    both = do("lost", loss * loss), do("square", m2 * m0), do("size", across * across)
    at_one = do("at_one", gamma * together)
    turn_off = rounded_turn(last)
    apart_off, n1_off = _blurs(at_one, turn_off, last)
    a_off = _turned_off(precision)
    ends = do("ends", m2 + Abs(m0))
    first = do("apart_one", (gamma - alpha) * (gamma + alpha)) * do("even", together * together)
    near, *most = _about_end("near", *both, first, at_one, together, alpha, force)
    blurred = do("blurred", (2 * Abs(across) + n1_off) * n1_off)
    cross_off = do("cross_off", blurred + together * turn_off)
    end_unsure, least = _at_the_end(far, last, a_off, apart_off)
    cubed = do("cubed", ends * turn_off * Abs(force))
    bent_off = ends * turn_off * alpha**2 + cross_off * Abs(force)
    near_off = cross_off * alpha**2, bent_off, cubed
    unsure = [end_unsure, *_unsure(near, Abs(near[0]), most, last, near_off)]
    pushed = do("pushed", apart * far)
    first = (at_minus_one - pushed) * (at_minus_one + pushed)
    end, *most = _about_end("far", *both, first, at_minus_one, apart, far, -force)
    cross_off = do("cross_off", blurred + apart_off * ends + Abs(apart) * turn_off)
    more = cross_off * far**2 + (2 * Abs(apart) + apart_off) * apart_off * Abs(force)
    bent_off = ends * turn_off * far**2 + cross_off * Abs(force)
    end_off = more + 2 * a_off, bent_off, cubed
    unsure += _unsure(end, least, most, last, end_off)
    middle = do("middle", 2 * at_one / (2 - loss))
    rest = do("rest", 2 * at_minus_one / (2 - loss))
    own = _about_own(*both, middle, rest, slope, force, far)
    loop = alpha, slope, far, d, across, loss, together, apart, apart_off, n1_off, a_off
    return SimpleNamespace(near=near, own=own, end=end, center=middle, beyond=rest, loop=loop,
                           unsure=unsure, slope=slope, far=far)  # fmt: skip


def _cut(top, bottom, low, high):
    """The quotient if it lies between the ends, else the low end."""
    small = Abs(top) < 8 * Abs(bottom)
    some = do("some", choose(small, bottom, 1))
    at = do("at", top / some)
    return do("cut", choose(And(small, at > low, at < high), at, low))


@routine(takes="Loop", terms=TERMS, loop=WHOLE_LOOP)
def zone_turns(terms, low, high, at_low, at_high, zone, loop):
    """what the crossings between two points add to the count"""
    _, k1, k2, k3 = terms
    disc = do("disc", k2 * k2 - 3 * k3 * k1)
    root = do("root", sqrt(Max(disc, 0)))
    q = do("q", -(k2 + choose(k2 < 0, -root, root)))
    bend = _cut(-k2, 3 * k3, low, high)
    extrema = [_cut(q, 3 * k3, low, high), _cut(k1, q, low, high)]  # if none, cuts like any other
    less, more = do("less", Min(*extrema)), do("more", Max(*extrema))
    first, middle = do("first", Min(less, bend)), do("middle", Max(less, bend))
    last = do("last", Max(middle, more))
    middle = do("middle", Min(middle, more))
    cuts = [low, first, middle, last, high]
    values = [at_low, *(do("p", _value(terms, c)) for c in cuts[1:-1]), at_high]
    found = S.Zero
    for extremum in extrema:
        value = do("value", _value(terms, extremum))
        here = zone_touches(value, extremum, zone, loop)
        found = do("found", found + choose(extremum > low, here, 0))
    for i in range(4):
        ends = (cuts[i], cuts[i + 1], values[i], values[i + 1])
        found = do("found", found + piece_turns(terms, *ends, zone, loop))
    return found


def _point(x, zone, last):
    """y, 4 - y and y - center of a point of a zone, and how much these may be off."""
    near, own = Eq(zone, NEAR), Eq(zone, OWN)
    y = do("y", choose(near, x, choose(own, center + x, 4 - x)))
    rest = do("rest", choose(near, 4 - x, choose(own, beyond - x, x)))
    off = do("off", choose(near, x - center, choose(own, x, beyond - x)))
    loose = do("loose", choose(own, *_point_off(last)))
    return y, rest, off, loose, do("free", choose(own, 0, last * choose(near, center, beyond)))


@routine(takes="Loop", loop=WHOLE_LOOP)
def zone_touches(leads, x, zone, loop, precision):
    """NaN where the wall may be as strong as the device at an extremum of both, else 0"""
    # at an extremum of the surplus, which may be so small that its sign is not certain
    return touches(leads, _point(x, zone, unit(precision)), LOOP)


@routine(takes="Loop", terms=TERMS, loop=WHOLE_LOOP)
def piece_turns(terms, low, high, at_low, at_high, zone, loop, precision):
    """what the crossing on a piece, if there is one, adds"""
    # the cubic has neither extremum nor inflection there; at an end of the circle it may be 0,
    # which is no crossing
    there = And(high > low, Or(And(at_low < 0, at_high >= 0), And(at_low >= 0, at_high < 0)),
                Or(Ne(low, 0), Ne(at_low, 0)))  # fmt: skip
    x = do("x", cubic_root(terms, low, high, at_high - at_low))
    point = _point(x, zone, unit(precision))
    inner = And(point[0] > 0, point[1] > 0)
    found = do("found", phase_turns(point, LOOP))
    up = do("up", choose(at_high > at_low, 1, -1))
    rises = do("rises", choose(Eq(zone, FAR), -up, up))
    return choose(there, choose(inner, -2 * rises * found, sp.nan), 0)


@routine(terms=TERMS)
def cubic_root(terms, low, high, rise, precision):
    """the root of a cubic on a piece where it bends one way"""
    k0, k1, k2, k3 = terms
    three, two = do("three", 3 * k3), do("two", 2 * k2)
    convex = do("convex", choose(three * (low + high) + two > 0, 1, -1))
    down = do("down", choose(rise * convex > 0, 1, -1))  # from this end it never overshoots
    # next to 0 a root is known to its own digits, so a piece on both sides of it is cut there
    before = And(low < 0, high > 0, k0 * convex > 0)
    behind = And(low < 0, high > 0, k0 * convex <= 0)
    begin = do("begin", choose(before, 0, choose(down > 0, high, low)))
    end = do("end", choose(behind, 0, choose(down > 0, low, high)))
    # a root that is far smaller than the begin is approached by geometric means first
    part = do("part", begin / _NEAR)
    far = Abs(part) > Abs(end)
    above = do("above", choose(And(far, convex * _value(terms, part) > 0), 1, 0)) > 0
    least = precision.vanishing**2
    start = {
        "begin": choose(above, part, begin),
        "end": choose(And(far, Not(above)), part, end),
    }

    def mean(begin, end):
        more = do("more", Max(Abs(end), least))
        size = do("size", sqrt(Abs(begin)) * sqrt(more))
        at = do("at", choose(begin < 0, -size, size))
        outside = do("outside", choose(convex * _value(terms, at) > 0, 1, 0)) > 0
        return choose(outside, at, begin), choose(outside, end, at)

    def near(begin, end):
        return Abs(begin) <= _NEAR * Max(Abs(end), least)

    begin, _ = do.repeat(start, mean, near, _halvings(precision))

    def step(y, _):
        steep = do("steep", (three * y + two) * y + k1)
        some = do("some", choose(Eq(steep, 0), 1, steep))
        move = do("move", choose(Eq(steep, 0), 0, _value(terms, y) / some))
        new = do("new", Min(y - move, high))
        new = do("new", Max(new, low))
        moves = do("moves", choose((y - new) * down > 0, 1, 0))
        return choose(moves > 0, new, y), moves  # not back, where a slope is its own rounding

    start = {"y": begin, "moves": S.One}
    return do.repeat(start, step, lambda _, moves: Eq(moves, 0), _steps(precision))[0]
