"""What is searched for: the worst angle of a wall, and the angle of the stiffest walls.

A root between two ends is found by Chandrupatla's method: it interpolates where that is safe and
halves where it is not, so that it never leaves its bracket; T. R. Chandrupatla, Adv. Eng. Softw. 28
(1997) 145-149.
"""

from __future__ import annotations

from functools import cache

from symhaptic.export.routines.arithmetic import *
from symhaptic.export.routines.prelude import *
from symhaptic.forms import max_stiffness_slope, required_damping, stiffest_passive
from symhaptic.forms.entire import CosNext, Sinc, SinNext
from symhaptic.forms.implicit import MAX_STIFFNESS_SPRING
from symhaptic.forms.root_count import FractionalRoots, Stable, WholeRoots
from symhaptic.forms.stability_forms import curve
from symhaptic.notation import l, w

MOST = 120
"""At most so many steps; some ten are usual, and halving alone would need sixty."""


def crossing(f, low, high, close, wanted=sp.true):
    """Where ``f`` changes from positive to negative, to the relative distance ``close``.

    An end stands for the root where ``f`` does not change: ``low`` where it is not positive there
    already, ``high`` where it is positive even there.  Nothing is searched where it is not
    ``wanted``.
    """
    low, high = do("low", low), do("high", high)
    with Steps(taken=do.taken) as inner:
        found = _searched(f, low, high, close, wanted)
    at = do.fresh("at")
    root = do.fresh("root")
    do.done.append(Search(root, at, f(at), low, high, close, tuple(inner.done), found))
    return root


def _searched(f, low, high, close, wanted):
    """The same by steps."""
    above, below = (
        do(name, f(at) if wanted == sp.true else choose(wanted, f(at), 0))
        for name, at in (("above", low), ("below", high))
    )

    def over(b, fb, a, fa, *_):
        """No change of sign is left between the ends, or they are close."""
        same = Or(And(fa >= 0, fb >= 0), And(fa <= 0, fb <= 0))
        return Or(same, Abs(b - a) <= _least(b, fb, a, fa, close))

    def step(b, fb, a, fa, c, fc):
        new = do("new", next_guess(b, fb, a, fa, c, fc, close))
        value = do("value", f(new))
        same = Or(And(value > 0, fa > 0), And(value < 0, fa < 0))
        same = do("same", choose(same, 1, 0)) > 0
        kept, last = pick(same, (b, fb), (a, fa)), pick(same, (a, fa), (b, fb))
        return *kept, new, value, *last

    start = {"b": low, "fb": above, "a": high, "fa": below, "c": high, "fc": below}
    b, fb, a, fa, _, _ = do.repeat(start, step, over, MOST)
    best = choose(Abs(fa) < Abs(fb), a, b)
    return choose(above <= 0, low, choose(below >= 0, high, best))


def _least(b, fb, a, fa, close):
    return close * Abs(choose(Abs(fa) < Abs(fb), a, b))


@routine()
def next_guess(b, fb, a, fa, c, fc, close):
    """the next point of a search between a and b, where f is fa and fb, after c"""
    # inverse quadratic interpolation where that is safe, else the middle
    span, rise = do("span", c - b), do("rise", fc - fb)
    place = do("place", (a - b) / do.nonzero(span))
    height = do("height", (fa - fb) / do.nonzero(rise))
    inner = And(height * height < place, (1 - height) ** 2 < 1 - place)
    safe = do("safe", choose(inner, 1, 0)) > 0
    one = do("one", choose(safe, fb - fa, 1))
    two = do("two", choose(safe, fb - fc, 1))
    three = do("three", choose(safe, fa - fc, 1))
    width = do("width", b - a)
    here, there = do("here", fa / one), do("there", fc / two)
    some = do.nonzero(width)
    other, last = do("other", fa / three), do("last", fb / two)
    ahead, behind = here * there, (c - a) / some * other * last
    guess = do("guess", choose(safe, ahead + behind, S.Half))
    edge = do("edge", _least(b, fb, a, fa, close) / Abs(some))
    edge = do("edge", Min(edge, S.Half))
    share = do("share", Min(guess, 1 - edge))
    return a + do("share", Max(share, edge)) * width


# -- the damping that a wall needs -------------------------------------------------------------

_FIRST = 4
"""Angles (l + 1) theta up to here hold the first zero of Lead, and no second one."""


@routine()
def straight(stiffness, damping, k, angle):
    """what straight motions require with an integer delay of k periods"""
    order = do("order", 2 * k + 1)
    wave, near = do("wave", Sinc(order * angle)), do("near", 2 * Sinc(angle))
    kernel = over(scaled(order, wave), near)
    along = do("along", CosNext(k, 2 * angle))
    return rounded(minus(scaled(stiffness, kernel), scaled(damping, along)))


@routine()
def straight_at(stiffness, damping, k, angle):
    """what straight motions require at an angle, with a delay of k periods"""
    half = do("half", angle / 2)  # the delay may turn it many times
    wave, along = do("wave", SinNext(2 * k, half)), do("along", CosNext(k, angle))
    kernel = over(wave, do("near", 2 * sin(half)))
    return rounded(minus(scaled(stiffness, kernel), scaled(damping, along)))


@routine()
def between(share, early, late):
    """early + share (late - early)"""
    return early + share * do("more", late - early)


@routine()
def damping_at(alpha, beta, l, epsilon, psi):
    """the damping that the wall requires at the angle 2 psi"""
    early, late = do("early", required_damping.straight(l)), required_damping.straight(l + 1)
    n = do("n", required_damping.between(early, late))
    root = do("root", sqrt(n * n + required_damping.extra()))
    return choose(Eq(epsilon, 0), early, (n + root) / 2)


@routine()
def required_at(alpha, beta, l, epsilon, theta, precision):
    """the damping that the wall requires at the angle theta, for a fractional delay"""
    # at any angle of (0, pi), where the delay turns many times as well
    lift = do("lift", _lift(alpha, beta, precision))
    stiffness, damping = do("stiffness", lift * alpha), do("damping", lift * beta)
    cosine, sine = next_wave(l, theta)
    half = do("half", theta / 2)
    up, along = do("up", sin(half)), do("along", cos(half))
    wave = over(scaled(sine, along), up)
    twice = do("twice", 2 * epsilon)
    push = minus(plus(wave, scaled(twice, cosine)), cosine)
    middle = plus(scaled(sine, along), scaled(cosine, up))
    later = scaled(twice, scaled(up, middle))
    pull = scaled(damping, minus(cosine, later))
    mean, mean_low = minus(scaled(stiffness / 2, push), pull)
    n = do("n", mean + mean_low)
    size = do("size", (stiffness * along) ** 2 + ((stiffness + 2 * damping) * up) ** 2)
    extra = do("extra", epsilon * (1 - epsilon) * size)
    root = do("root", sqrt(n * n + extra))
    # the mean of n and the root without a difference, and with no more than a part of the root
    more = do("more", extra / (2 * do.nonzero(root + Abs(n))))
    whole = do("whole_need", mean + do("rest", mean_low + more))
    return choose(n < 0, more, whole) / lift


@routine()
def rising(alpha, beta, l, epsilon, psi):
    """has the sign of the slope of DampingAt, at a fraction"""
    early, late = do.common(required_damping.steepness(l), required_damping.steepness(l + 1))
    early = do("early", early)
    steep = do("steep", required_damping.between(early, late))
    return required_damping.rising(damping_at(alpha, beta, l, epsilon, psi), steep)


@routine()
def steepness(alpha, beta, l, epsilon, psi):
    """has the sign of the slope of DampingAt, up to the angle in phase"""
    early = do("early", do.common(required_damping.steepness(l))[0])
    rises = do("rising", rising(alpha, beta, l, epsilon, psi))
    double = 2 * psi
    delayed = atan2(epsilon * sin(double), 1 - epsilon + epsilon * cos(double))
    own = atan2(alpha * cos(psi), (alpha + 2 * beta) * sin(psi))
    phase = do("phase", (2 * (l + 1) * psi - pi) + delayed + own)
    return choose(Eq(epsilon, 0), early, choose(phase > 0, -Abs(rises), rises))


def _neediest(slope, alpha, beta, l, close, precision):
    """Where the slope of what a wall of the size 1 needs changes its sign."""
    # beyond pi the sine is negative, which at half a period turns the phase
    most = sp.Rational(precision.below_pi)
    size = do("size", Abs(alpha) + Abs(beta))
    scale = do.nonzero(size)
    wall = do("stiffness", alpha / scale), do("damping", beta / scale)
    end = most / (2 * (l + 1))
    return crossing(lambda at: slope(*wall, l, at), S.Zero, end, close)


@routine()
def worst_angle(alpha, beta, l, epsilon, precision):
    """half of the angle at which the wall requires most damping"""
    # as near as its need has to be
    return _neediest(lambda *wall: steepness(*wall[:3], epsilon, wall[3]), alpha, beta, l,
                     precision.flat, precision)  # fmt: skip


@routine()
def critical_angle(alpha, beta, l, epsilon, precision):
    """half of the angle at which the wall requires most damping"""
    # to the last place, for derivatives of the need
    return _neediest(lambda *wall: steepness(*wall[:3], epsilon, wall[3]), alpha, beta, l,
                     precision.close, precision)  # fmt: skip


@routine()
def largest_required_damping(alpha, beta, d, precision):
    """the damping that the wall requires at its worst angle"""
    # of a wall whose squares would vanish it is that of a larger one, by a power of two
    whole = do("whole", floor(d))
    part = do("part", d - whole)
    lift = do("lift", _lift(alpha, beta, precision))
    wall = do("stiffness", lift * alpha), do("damping", lift * beta)
    psi = do("psi", worst_angle(*wall, whole, part))
    return choose(alpha < 0, sp.oo, damping_at(*wall, whole, part, psi) / lift)


def _lift(alpha, beta, precision):
    tiny = Abs(alpha) + Abs(beta) < precision.vanishing
    return choose(tiny, 1 / precision.vanishing**2, S.One)


@routine()
def lifted(x, alpha, beta, precision):
    """x, enlarged where the squares of the wall would vanish"""
    return x * _lift(alpha, beta, precision)


@routine()
def whole_damping_at(alpha, beta, l, psi):
    """the damping that the wall requires at the angle 2 psi"""
    return required_damping.straight(l)


@routine()
def whole_steepness(alpha, beta, l, psi):
    """has the sign of the slope of WholeDampingAt"""
    return do.common(required_damping.steepness(l))[0]


@routine()
def worst_whole_angle(alpha, beta, l, precision):
    """half of the angle at which the wall requires most damping"""
    return _neediest(whole_steepness, alpha, beta, l, precision.flat, precision)


@routine()
def largest_whole_required_damping(alpha, beta, d):
    """the damping that the wall requires at its worst angle"""
    psi = do("psi", worst_whole_angle(alpha, beta, d))
    return choose(alpha < 0, sp.oo, whole_damping_at(alpha, beta, d, psi))


# -- the walls that are just passive -----------------------------------------------------------


@cache
def _turning():
    """What straight motions need of a wall of the size 1, and the slope of what all need of it.

    Both are made of waves that are the same for all walls; in the slope w is the former.
    """
    straight, steep = (
        required_damping.between(of(l), of(l + 1))
        for of in (required_damping.straight, required_damping.steepness)
    )
    rises = required_damping.rising(required_damping.required(w), steep)
    waves = sorted((straight + rises).atoms(sp.Function), key=sp.default_sort_key)
    named = {wave: Symbol(f"wave{i}" if i > 1 else "wave") for i, wave in enumerate(waves, 1)}
    one = required_damping.of_size_one()
    return named, [e.xreplace(named).xreplace(one) for e in (straight, rises)]


@routine()
def turning(phi, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9, wave10,
            wave11, wave12):  # fmt: skip
    """has the sign of minus the slope of what the wall phi needs"""
    # it falls where the wall is worst at a smaller angle
    straight, rises = do.common(*_turning()[1])
    return -rises.xreplace({w: do("mean", straight)})  # one number: its root is no smaller


@routine()
def turn(psi, l, epsilon, precision):
    """the wall whose worst angle is 2 psi, as an angle"""
    waves = [do("wave", wave) for wave in _turning()[0]]  # pi/2 where there is none
    return crossing(lambda at: turning(at, l, epsilon, *waves), S.Zero, pi / 2, precision.close)


@routine()
def touching(theta, l, epsilon):
    """the wall whose worst angle is theta, as an angle, or NaN"""
    found = do("found", turn(theta / 2, l, epsilon))
    return choose(found < pi / 2, found, sp.nan)


@routine()
def passive_slope(theta, l, epsilon):
    """whether a larger angle allows less stiffness, at a fraction"""
    waves: dict[sp.Expr, sp.Expr] = {}
    for periods in (l, l + 1):
        known = CosNext(periods, theta), SinNext(periods, theta)
        waves |= zip(known, next_wave(periods, theta), strict=True)
    sine = do("up", stiffest_passive.sine().xreplace(waves))
    cosine = do("along", stiffest_passive.cosine().xreplace(waves))
    return stiffest_passive.falling(sine, cosine).xreplace(waves)


@routine()
def passive_angle(l, epsilon, precision):
    """the worst angle of the stiffest passive wall, at a fraction"""
    high = pi / (l + epsilon + 1)
    return crossing(lambda at: passive_slope(at, l, epsilon), S.Zero, high, precision.close)


@routine()
def pushed(alpha, need):
    """the need, infinite for alpha < 0"""
    return choose(alpha < 0, sp.oo, need)


@routine()
def lead(theta, l, epsilon):
    """negative beyond the angle in phase with the delay"""
    # whether mere damping is not yet in phase: the sine of what it lacks
    early, late = do("early", SinNext(l, theta)), do("late", SinNext(l + 1, theta))
    sine = do("sine", required_damping.between(early, late))
    return choose((l + 1) * theta < _FIRST, sine, -1)


@routine()
def rated(number, value):
    """the value, NaN for number < 0"""
    return choose(number < 0, sp.nan, value)  # a slope if the wall pulls, a lost end


@routine()
def whole_part(d):
    """whole periods of a delay"""
    return floor(d)


@routine()
def fractional_part(d):
    """the fraction of a period in a delay"""
    return d - floor(d)


@routine()
def some_part(d):
    """the same, or 1/2 where it is 0"""
    part = do("part", d - floor(d))
    return choose(Eq(part, 0), S.Half, part)


# -- the stiffest stable wall: where the explicit boundary reaches farthest --------------------

_PARTS = 24
"""Of what is looked at for the first maximum."""


def _times(number, pair):
    """So often, by a power of two, which rounds nothing."""
    return number * pair[0], number * pair[1]


@routine()
def end_slope(at_minus_one, loss, together, apart, last):
    """has the sign of the slope of the boundary's alpha next to pi"""
    # its terms cancel where the maximum is next to pi: each is known twice as well as a float
    r, s, a = at_minus_one, together, apart
    side = two_diff(s, 4 * last)
    square, across = squared(side), scaled(a, s)
    gap, lean = minus(across, square), minus(square, _times(2, across))
    bent = plus(times(side, lean), scaled(a, across))
    rest = minus(2 * a, side)
    two = scaled(loss, scaled(a, gap))
    three = times(squared(a), rest)
    found = minus(_times(4, three), scaled(r, bent))
    return rounded(minus(found, _times(2, two)))


@routine()
def early_slope(theta, k4, k3, k2, k1, k0):
    """has the sign of the slope of the boundary's alpha, d < 1"""
    sine, cosine = do("sine", sin(theta / 2)), do("cosine", cos(theta / 2))
    up, along = do("up", sine * sine), do("along", cosine * cosine)
    found, power = k4, S.One
    for k in (k3, k2, k1, k0):
        power = do("power", power * along)
        found = do("found", found * up + k * power)
    return found


_DEVICE = max_stiffness_slope.UNDELAYED
"""A(1), A(-1), 1 - e, and M(1) and M(-1)."""


@routine(device=_DEVICE)
def undelayed_angle(device):
    """the angle of the largest stiffness without delay"""
    # where a parabola changes its sign first, or pi where it does not
    square = do("k", end_slope(*device[1:], 0))
    middle, last = (do("k", k) for k in do.common(*max_stiffness_slope.undelayed()[1:]))
    discriminant = do("discriminant", middle * middle - 4 * square * last)
    root = do("root", sqrt(Max(discriminant, 0)))
    falls = choose(discriminant < 0, 0, root - middle)
    above = do("above", choose(middle > 0, middle + root, 2 * last))
    below = do("below", choose(middle > 0, Max(-2 * square, 0), falls))
    return 2 * atan2(sqrt(above), sqrt(below))


@routine(device=_DEVICE)
def boundary_slope(theta, l, device, across):
    """has the sign of the slope of the boundary's alpha"""
    return do.common(max_stiffness_slope.slope()[0])[0]


def _first_maximum(end, slope, rising, precision):
    """Where a slope that is positive at 0 changes its sign first; or what holds if it does not."""

    def angle(count):
        return count * end / _PARTS

    def scan(count, _):
        rises = do("rises", slope(angle(count)))
        return choose(rises > 0, count + 1, count), choose(rises > 0, 0, 1)

    start = {"count": S.One, "found": S.Zero}
    count, found = do.repeat(start, scan, lambda n, found: Or(found > 0, n > _PARTS), _PARTS)
    high = do("high", angle(count))
    low = do("low", Max(angle(count - 1), high / 1000))
    root = crossing(slope, low, high, precision.close, found > 0)
    return choose(found > 0, root, rising)


@routine(device=_DEVICE)
def early_angle(device, last, precision):
    """the angle of the largest stiffness for delays below a period"""
    end = end_slope(*device[1:], last)  # pi where it rises all the way
    quartic = [do("k", k) for k in (end, *do.common(*max_stiffness_slope.early()[1:]))]
    return _first_maximum(pi, lambda at: early_slope(at, *quartic), pi, precision)


@routine(device=_DEVICE)
def later_angle(d, l, device, across, precision):
    """the angle of the largest stiffness for a period and more"""
    half_turn = do("turn", pi / (d + 1))  # NaN where it rises so far
    return _first_maximum(
        half_turn, lambda at: boundary_slope(at, l, device, across), sp.nan, precision
    )


_INSIDE = sp.symbols("inside damping")


@routine(device=_DEVICE)
def max_stiffness_angle(gamma, delta, d, l, part, first, last, device, precision):
    """the angle of the wall of largest stable stiffness, or NaN"""
    whole = Eq(part, 0)
    across = do("across", choose(whole, first, first - last))
    late = choose(d < 1, early_angle(device, last), later_angle(d, l, device, across))
    top = do("theta", choose(Eq(d, 0), undelayed_angle(device), late))
    known = gamma, *device[1:]
    roots = choose(
        whole,
        WholeRoots(*_INSIDE, l, first, last, *known),
        FractionalRoots(*_INSIDE, l, first, last, *known, first - last, delta),
    )
    return _bordering(top, across, l, roots, gamma, delta, d, device, precision)


@routine(device=_DEVICE)
def max_stiffness_whole_angle(gamma, delta, d, first, last, device, precision):
    """the angle of the wall of largest stable stiffness, or NaN"""
    later = later_angle(d, d, device, first)
    top = do("theta", choose(Eq(d, 0), undelayed_angle(device), later))
    roots = WholeRoots(*_INSIDE, d, first, last, gamma, *device[1:])
    return _bordering(top, first, d, roots, gamma, delta, d, device, precision)


def _bordering(top, across, steps, roots, gamma, delta, d, device, precision):
    """The angle if its wall borders the stable region, else NaN; ``roots`` are those of a wall."""
    stiffness, damping = do.common(*curve((*device, 2 * across), top, steps))
    stiffness, damping = do("stiffness", stiffness), do("damping", damping)
    # a little inside a wall must be stable, so that the boundary borders the region; farther inside
    # where the count is not certain
    counts, stables = [], []
    for inward in (10 * precision.flat, sp.Rational(1, 2**8)):
        wall = do("inside", stiffness - inward * (stiffness + gamma)), damping
        counted = roots.xreplace(dict(zip(_INSIDE, wall, strict=True)))
        counts.append(do("outside", counted))
        stables.append(Stable(counts[-1], *wall, gamma, delta))
    soft = sqrt(gamma) * (d + 1) <= pi
    known = And(gamma <= MAX_STIFFNESS_SPRING, Or(soft, d <= 1))
    # with damping and no stiff spring, comparison found no maximum that lies elsewhere
    sure = And(soft, delta > 0, stiffness > -gamma)
    good = do("good", choose(sure, 1, choose(counts[0] < 0, *stables[::-1])))
    return choose(known, choose(good > 0, top, sp.nan), sp.nan)
