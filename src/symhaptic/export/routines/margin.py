r"""The delay that may be added to a loop, never too large.

If the delay grows, a root on the unit circle moves by :math:`d\ln z=h/(l+2-Z)`.  Here h is the
logarithmic derivative of M by the fraction of the period, Z is that of :math:`MW/A` by
:math:`\ln z`, and l is the number of whole periods.  A root can be on the circle at two angles.  We
show that roots leave at the larger angle, above which the device is stronger than the wall, and
come back at the smaller angle.  The proof covers all fractions in a part of the period at once.  It
covers all l between two, since the real part of :math:`h\,\overline{(l+2-Z)}` is linear in l.

So no root comes back before one has left, and one leaves each time the phase at the larger angle
has made another turn.  Secants find the delay at which this happens.  The margin is a little
smaller: there, the number of turns is certainly that at the start.

A number with a bound is a pair: a value, and by how much it may be off.  Every input of a part
counts as off by 64 last places, so that all later roundings are a small part of the bounds.
"""

from __future__ import annotations

from symhaptic.export.routines.prelude import *
from symhaptic.export.routines.roots import (
    _value,
    _wall,
    across,
    alpha,
    beta,
    cubic_root,
    delta,
    expanded,
    gamma,
    loss,
    m0,
    m2,
    nearest_point,
    phase_turns,
    rounded_turn,
    together,
    unit,
)
from symhaptic.forms.root_count import FRACTIONAL_ARGUMENTS

SAMPLED = (
    "n1", "m2", "m0", "at_minus_one", "loss", "together", "apart", "across", "kick", "kicked",
)  # fmt: skip
"""What is found of a device and a delay: see :func:`symhaptic.export.sampled.sampled_at`."""

_SECANTS = 12
_TRIES = 8
_LEAST = Rational(1, 32)
"""A part that cannot be decided is cut in four, unless the pieces are shorter than this."""
_PARTS = 24
"""At most so many parts are tried: sixteen, those that the end of the period or of the margin cuts,
and those that were cut in four before."""

_KICKS = kick, kicked, n1, half = sp.symbols("kick kicked n1 half")
"""The ways by an impulse in a period and in its rest, n1 of the device, and half of a part of the
period."""
first, last, side = _TO = sp.symbols("first last side")
"""Whole periods between which it is to hold, and 1 for the larger angle, -1 for the smaller."""


# -- where a root may be on the circle --------------------------------------------------------


@routine("turns phase theta", record="Passing", given=FRACTIONAL_ARGUMENTS)
def passing(given, precision):
    """the nearest whole number of turns of the phase where the device takes the lead, NaN where
    that is not certain; the phase, in turns; and the angle"""
    x = expanded(precision)
    _, k1, k2, _ = x.near
    bottom = do("bottom", Max(-k1 / (2 * do.nonzero(k2)), 0))
    low = do("begin", choose(gamma > Abs(alpha), Min(bottom, 4), 0))
    near = do("y", cubic_root(x.near, low, S(4), S.One))
    far = _polished(x.end, 4 - near)
    off = _polished(x.own, choose(near < 2, near - x.center, x.beyond - far))
    *point, _ = nearest_point(near, far, off, x.center, x.beyond)
    turns = do("turns", phase_turns(tuple(point), x.loop))
    y, rest, off = (do("at", e) for e in (Max(point[0], 0), Max(point[1], 0), point[2]))
    sine = do("sine", 2 * sqrt(y * rest))
    alpha_, slope, wall_far, steps, across, lost, total, apart, *_ = x.loop
    theta = do("theta", 2 * atan2(sqrt(y), sqrt(rest)))
    angle = atan2(across * sine, total * rest - apart * y)
    angle += atan2(slope * sine, alpha_ * rest - wall_far * y)
    angle -= atan2(lost * sine, -2 * (2 - lost) * off)
    return turns, (angle - (steps + 2) * theta) / (2 * pi), theta


def _polished(terms, at):
    """After two steps of Newton's method."""
    _, k1, k2, k3 = terms
    for _ in range(2):
        at = do("at", at)
        steep = do.nonzero((3 * k3 * at + 2 * k2) * at + k1)
        at -= do("value", _value(terms, at)) / steep
    return do("at", at)


# -- numbers with bounds ------------------------------------------------------------------------


@routine("product product_low")
def near_product(x: Pair, y: Pair):
    """x y of numbers that may be off by their second parts"""
    (v, e), (w, f) = x, y
    return v * w, Abs(v) * f + (Abs(w) + f) * e


@routine("sum sum_low")
def near_sum(x: Pair, y: Pair):
    """x + y of numbers that may be off by their second parts"""
    return x[0] + y[0], x[1] + y[1]


@routine("quotient quotient_low")
def near_quotient(x: Pair, y: Pair):
    """x/y of numbers that may be off by their second parts"""
    (v, e), (w, f) = x, y
    ratio = do("ratio", v / do.nonzero(w))
    return ratio, (e + Abs(ratio) * f) / Max(Abs(w) - f, 0)  # infinite where w may be 0


class _Near:
    """A number with a bound, to write formulas with."""

    def __init__(self, v, e):
        self.v, self.e = v, e

    @property
    def pair(self):
        return self.v, self.e

    @property
    def size(self):
        return Abs(self.v) + self.e

    def __neg__(self):
        return _Near(-self.v, self.e)

    def __add__(self, other):
        return _Near(*near_sum(self.pair, other.pair))

    def __sub__(self, other):
        return self + -other

    def __mul__(self, other):
        if not isinstance(other, _Near):
            return _Near(other * self.v, Abs(S(other)) * self.e)
        return _Near(*near_product(self.pair, other.pair))

    __rmul__ = __mul__

    def __truediv__(self, other):
        return _Near(*near_quotient(self.pair, other.pair))

    def widened(self, more):
        """The same, off by more."""
        return _Near(self.v, do("off", self.e + more))

    @property
    def least(self):
        """What it certainly exceeds; the roundings of the bounds count half as much as these."""
        return self.v - 3 * self.e / 2


# -- which way roots cross, in a part of the period ---------------------------------------------


@routine(given=FRACTIONAL_ARGUMENTS, more=(*_KICKS, *_TO))
def outward(given, more, precision):
    """1 if roots leave in a part of the period, or come back on the other side; 2 if there are
    none, 0 where that is not certain"""
    share = 64 * precision.last
    one = _Near(S.One, share)

    def near(value, size=None):
        value = do("v", value)
        return _Near(value, do("off", share * (Abs(value) if size is None else size)))

    # the device in the part: S = m2 + m0, D = m2 - m0, D^2 - N S, S'D - D'S and their changes
    slope, _, far = _wall()
    bend = do("bend", Min(2, delta + gamma / 2))
    early, late = -kicked, kick * (1 - delta * kicked - gamma * m2)
    late = do("late", late - (1 - delta * kick - gamma * n1) * kicked)
    size = do("size", 4 * (1 + delta + gamma))
    sums_by, gap_by = near(early + late, size), near(early - late, size)
    ends = do("ends", m2 + Abs(m0))
    turn_off = rounded_turn(unit(precision))
    sums, gap = (near(v, ends).widened(turn_off) for v in (m2 + m0, across))
    force = near(together)
    tilt = 2 * (gap * gap_by) - force * sums_by
    cross, twist = gap * gap - force * sums, sums_by * gap - gap_by * sums
    sums = sums.widened(half * (sums_by.size + half))
    gap = gap.widened(half * (gap_by.size + half * bend / 2))
    gap_by = gap_by.widened(half * bend)
    square = gap_by * gap_by
    turn = do("turn", Abs(2 * square.v - together * (2 - bend)))
    turn = do("turn", turn + 2 * (square.e + bend * gap.size) + together * bend)
    cross = cross.widened(half * (tilt.size + half * turn / 2))
    tilt = tilt.widened(half * turn)
    twist = twist.widened(half * (2 * gap.size + bend * sums.size))
    both = near(m2 * m0).widened(half / 8 + ends * turn_off)
    # the surplus |A|^2 - |M W|^2
    sizes = do("wall_size", Abs(alpha) + 2 * Abs(beta))
    a, b, slope, far = near(alpha), near(beta), near(slope, sizes), near(far, sizes)
    lost, begin = near(loss), near(gamma * together)
    push, top, pull = a * a, force * force, b * slope
    total, kept = one + one - lost, one - lost
    linear = lost * lost - begin * total
    apart = 2 * sums - force
    strength = apart * far
    c0 = near((gamma - alpha) * (gamma + alpha)) * top
    c1 = linear - cross * push - top * pull
    c2 = kept - cross * pull - both * push
    c3 = -(both * pull)
    over = c2 + 12 * c3
    bent = do("bent", Min(c2.least, over.least))
    up = bent > 0
    down = And((-c2).least > 0, (-over).least > 0)
    terms = c0.v, c1.v, c2.v, c3.v
    disc = do("disc", c1.v**2 - 4 * c0.v * c2.v)
    root = do("root", sqrt(Max(disc, 0)))
    whole = do.nonzero(c2.v)
    sum_ = do.nonzero(Abs(c1.v) + root)
    start = choose(c1.v < 0, sum_ / (2 * whole), -2 * c0.v / sum_)
    y = _polished(terms, choose(side > 0, start, 2 * c0.v / sum_))
    bottom = do("bottom", -c1.v / (2 * whole))
    at = near(bottom)
    under = ((c3 * at + c2) * at + c1) * at + c0
    steep = (3 * c3 * at + 2 * c2) * at + c1
    stronger = gamma > Abs(alpha)
    inside = And(bottom >= 0, bottom <= 4)
    # the surplus is above the parabola that bends least
    above = And(inside, 4 * bent * under.least > 1.01 * steep.size**2)
    clear = And(stronger, Or(down, And(up, Or(c1.least > 0, above))))
    twice = Or(Not(stronger), And(up, inside, (-under).least > 0))
    # how far the crossing is from there at most
    at = near(y)
    value = do("value", (((c3 * at + c2) * at + c1) * at + c0).size)
    rise = do("rise", (side * ((3 * c3 * at + 2 * c2) * at + c1)).least)
    bends = do("bends", 2 * c2.size + 24 * c3.size)
    off = do("reach", 2 * value / do.nonzero(rise))
    known = And(rise > 0, 8 * off * bends < rise, y > 0, y < 4)
    # the logarithmic derivatives there
    y = near(y).widened(off)
    half_y = Rational(1, 2) * y
    along, rest = one - half_y, one + one - half_y
    inner = half_y * rest  # sin(theta)^2
    real = force - sums * half_y  # of M/z: its angle does not jump by a turn where D vanishes
    m = top + (cross + both * y) * y
    wall, plant = push + pull * y, begin * begin + (linear + kept * y) * y
    angle = gap * (force * along + sums * half_y) / m
    angle += slope * (a + b * half_y) / wall
    angle -= lost * (begin * along + total * half_y) / plant
    less = (linear + 2 * (kept * y)) / plant - (cross + 2 * (both * y)) / m - pull / wall
    grows = half_y * (tilt + _Near(S.Zero, Rational(1, 8)) * y) / m
    turns = (gap_by * force + half_y * twist) / m
    rest = grows * angle + inner * (turns * less)
    ways = [(side * (_Near(n + 2, share * n) * grows - rest)).least > 0 for n in (first, last)]
    leads = Abs(strength.v) + 3 * strength.e / 2 < (1 - 3 * share) * given[6]
    there = And(Or(up, down), leads, Ne(Abs(alpha), gamma))
    good = do("good", choose(And(there, twice, known, real.least > 0, *ways), 1, 0))
    return choose(And(there, clear), 2, good)


# -- the margin ---------------------------------------------------------------------------------


_LOOP = sp.symbols("alpha beta gamma delta d")


def _sampled(gamma, delta, delay):
    """What is known of a device with a delay."""
    found = do.several(SAMPLED, "SampledAt", gamma, delta, delay)
    return dict(zip(SAMPLED, found, strict=True))


def _told(x, alpha, beta, steps, gamma, delta):
    """Those of them that a crossing is told."""
    own = {"alpha": alpha, "beta": beta, "d": steps, "gamma": gamma, "delta": delta}
    return tuple((x | own)[s.name] for s in FRACTIONAL_ARGUMENTS)


@routine("turns phase theta", record="Passing", loop=_LOOP)
def passing_at(loop):
    """the same with a delay of d periods"""
    alpha, beta, gamma, delta, d = loop
    whole = do("whole", floor(d))
    return passing(_told(_sampled(gamma, delta, d), alpha, beta, whole, gamma, delta))


@routine(loop=_LOOP)
def turns_at(loop):
    """the turns alone"""
    return passing_at(loop)[0]


@routine(loop=_LOOP)
def phase_at(loop):
    """the phase alone"""
    return passing_at(loop)[1]


_SPAN = sp.symbols("begin width first last")


@routine(loop=_LOOP[:4], span=_SPAN)
def outward_at(loop, span):
    """1 if no root comes back before one has left, with a delay in a part of the period, 2 if none
    can leave, 0 where that is not certain"""
    alpha, beta, gamma, delta = loop
    begin, width, first, last = span
    half = do("half", width / 2)
    middle = do("middle", begin + half)
    x = _sampled(gamma, delta, middle)
    told = _told(x, alpha, beta, first, gamma, delta)
    more = x["kick"], x["kicked"], x["n1"], 1.0001 * half, first, last
    high = do("high", outward(told, (*more, S.One)))
    low = do("low", outward(told, (*more, -S.One)))
    back = choose(gamma > Abs(alpha), low, high)
    return choose(Eq(high, 1), back, high)


@routine(loop=_LOOP)
def delay_margin(stable, loop, precision):
    """the delay that may be added, 0 if the loop is not stable, NaN where it is not certain"""
    alpha, beta, gamma, delta, d = loop
    turns, phase, theta = passing_at(loop)
    known = do("known", choose(Abs(turns) <= precision.longest, 1, 0)) > 0
    ahead = do("ahead", phase + S.Half - turns)
    whole = do("whole", floor(d))
    part = do("part", d - whole)

    def left(at):
        there = do("there", d + at)
        return phase_at((alpha, beta, gamma, delta, there)) + S.Half - turns

    def secant(at, value, before, above):
        rise = do.nonzero(value - above)
        new = do("new", at - value * (at - before) / rise)
        new = do("new", Min(Max(new, 0), 2 * at + 1))
        return new, do("next_value", left(new)), at, value

    def arrived(at, value, before, _):
        return Or(Eq(value, 0), Abs(at - before) <= 4 * precision.last * (d + at))

    start = do("start", 2 * pi * ahead / do.nonzero(theta))
    states = {"at": start, "value": left(start), "before": S.Zero, "above": ahead}
    at, *_ = do.repeat(states, secant, arrived, _SECANTS)

    def sure(added):
        there = do("there", d + added)
        return choose(Eq(turns_at((alpha, beta, gamma, delta, there)), turns), 1, 0)

    room = do("room", 4 * precision.last * (d + at + 2))
    first = do("first", at - room)
    states = {"added": first, "less": room, "good": sure(first)}

    def lower(added, less, _):
        more = do("more", 8 * less)
        new = do("new", at - more)
        return new, more, do("next_good", sure(new))

    added, _, good = do.repeat(states, lower, lambda _, __, good: good > 0, _TRIES)
    # none comes back on the way
    last = do("last", choose(known, whole + floor(added) + 2, whole))
    states = {"begin": part, "width": S.One, "rest": choose(known, Min(added, 1), 1), "ways": S(2)}

    def look(begin, width, rest, ways):
        some = do("some", Min(width, Min(1 - begin, rest)))
        way = do("way", outward_at((alpha, beta, gamma, delta), (begin, some, whole, last)))
        end = do("end", begin + some)
        new = choose(way > 0, choose(end < 1, end, 0), begin)
        return (
            new,
            choose(way > 0, width, width / 4),
            choose(way > 0, rest - some, rest),
            choose(way > 0, Min(ways, way), ways),
        )

    _, _, rest, ways = do.repeat(
        states, look, lambda _, width, rest, __: Or(rest <= 0, width < _LEAST), _PARTS
    )
    free = And(gamma > Abs(alpha), ways > 1)
    found = do("found", added - precision.last * (d + added))  # d + added is rounded
    found = choose(And(good > 0, found > 0), found, sp.nan)
    found = choose(rest > 0, sp.nan, choose(known, found, choose(free, sp.oo, sp.nan)))
    return choose(stable > 0, found, 0)
