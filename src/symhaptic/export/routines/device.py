"""The numbers of the sampled device: where each form keeps its digits.

Both poles -p and -q of the device obey p + q = delta and p q = gamma.  They are kept to twice the
precision of a float, since exp(-q) magnifies their error by q.  Near p = q = 0 a power series is
used, beyond it closed forms that subtract no two nearly equal numbers:

    n1 = (Decay(q) - exp(-q) Decay(p - q))/p,   n0 = exp(-q) (Decay(p - q) - exp(-(p-q)) Decay(q))/p

for a creeping device, and those of cos and sin of sqrt(gamma - delta^2/4) for a swinging one.

Of a device that has just swung whole turns in a period these cancel.  With h = delta/2,
E = exp(-h), eta = root - 2 pi k and c = 1 - cos(eta),

    gamma n1 = h (Decay(h) - E sin(eta)/root) + E c,
    gamma n0 = E (c - h (Decay(h) - sin(eta)/root)),
    gamma (n1 + n0) = (1 - E)^2 + 2 E c,

where root^2 = gamma - h^2: the closed forms, which take cos(root) from 1, rounded.  All terms of n1
are positive; those of n0 differ, it changes its sign at delta near eta^2.  What decides is eta:
root^2 - (2 pi k)^2 over root + 2 pi k, with (2 pi)^2 in three floats, as no float is (2 pi k)^2.
"""

from __future__ import annotations

from functools import partial

from symhaptic.export.routines.arithmetic import *
from symhaptic.export.routines.prelude import *
from symhaptic.forms.entire import Decay

NEAR = Rational(9, 4)
"""Up to this size of the larger real pole power series are used."""

TINY = Rational(1, 8)
"""Up to this size fewer terms do: a haptic device has slow poles."""

STIFF = sp.Integer(4)
"""Up to this gamma, the squared size of complex poles, power series are used."""

SOFT = Rational(9, 16)
"""The part of NEAR and of STIFF up to which n1 and n0 use them."""

# -- how the device moves ----------------------------------------------------------------------


@routine("half w w_low root reach", record="Motion")
def device_motion(gamma, delta):
    """half = delta/2, w = half^2 - gamma, its root and the size of the poles"""
    half = do("half", delta / 2)
    square, low = scaled(half, half)
    most, lost = two_diff(square, gamma)
    w = fast_two_sum(most, do("rest", lost + low))
    root = do("root", sqrt(Abs(w[0])))
    reach = do("reach", choose(w[0] < 0, gamma / STIFF, (half + root) / NEAR))
    return half, w, root, reach


@routine("p p_low q q_low", record="Poles", takes="Motion")
def real_poles(gamma, half, w: Pair, root):
    """the poles p = half + root and q = gamma/p"""
    p, lost = fast_two_sum(half, root)
    low = do("p_low", lost + root_miss(w, root))
    larger = do.nonzero(p), low
    return larger, over(gamma, larger)


@routine("p p_low slow slow_low mean mean_low ratio ratio_low far far_low", record="Creeping",
         takes="Motion")  # fmt: skip
def creeping_device(gamma, half, w: Pair, root):
    """of an overdamped device the pole p, exp and mean of the other one and of their distance"""
    p, q = real_poles(gamma, half, w, root)
    low = do("root_low", root_miss(w, root))
    return p, *fading_pair(q), *fading_pair((2 * root, 2 * low))


@routine("envelope even even_low wave wave_low near risen sunk moved", record="Swinging",
         takes="Motion")  # fmt: skip
def swinging_device(gamma, half, w: Pair, root):
    """exp(-half), cos(root), sin(root)/root and nearby turns of an oscillating device"""
    even, wave = waving_pair(w, root)
    turns = whole_turns(half, w, root, do("stiff", gamma))
    return do("envelope", exp(-half)), even, wave, *turns


@routine("decayed decayed_low", takes="Motion")
def slow_fade(reach, half):
    """exp(-half) of a device with slow poles, and what it misses"""
    small = reach < SOFT
    return pick(small, squared(brief_fading(choose(small, half, 0) / 2)[0]), 0)


def shared(gamma, delta, fades=False):
    """What the functions of the device are given, by name: of a swinging and of a creeping one."""
    half, (w, low), root, reach = device_motion(gamma, delta)
    known = {"gamma": gamma, "delta": delta, "half": half, "w": w, "w_low": low, "root": root,
             "reach": reach}  # fmt: skip
    if fades:
        known |= slow_fade.by_name(reach, half)
    swing = known | swinging_device.by_name(gamma, half, (choose(w < 0, w, 0), low), root)
    return swing, known | creeping_device.by_name(gamma, half, (w, low), root)


# -- near whole turns --------------------------------------------------------------------------


@routine("near risen sunk moved", record="Turns")
def whole_turns(half, square: Pair, root, stiff, precision):
    """whether the device has nearly swung whole turns; n1, n0 and n1 + n0 there"""
    swings = And(root > 3, root < 2 ** (precision.bits // 2), half < BRIEF)  # so far k^2 is exact
    count = do("count", floor(root / (2 * pi) + S.Half))
    missed = do("missed", root_miss(square, root))
    eta, low = _beyond(square, root, count, missed, precision)
    near = And(count > 0, do("far", eta * eta) < SLOW)
    eta, low = do("eta", choose(near, eta, 0)), do("eta_low", choose(near, low, 0))
    y, y_low = squared((eta, low))
    lift, lost = fast_two_sum(y / 2, -do("bent", y * y * cos_series(-y)))
    flat = one_minus(y * sin_series(-y))
    rise = lift, do("lift_low", lost + y_low * flat[0] / 2)
    sine, sine_low = scaled(eta, flat)
    some = do("some", choose(near, root, 1))
    wave = over((sine, sine_low + low * (1 - lift)), (some, missed))
    fall, mean = brief_fading(half)
    lifted = times(fall, rise)
    some = do.divisor(stiff)
    risen = plus(scaled(half, minus(mean, times(fall, wave))), lifted)
    total, total_low = minus(rise, scaled(half, minus(mean, wave)))
    sunk = times(fall, two_diff(total, -total_low))
    gone = fast_two_sum(*one_minus(fall))  # n1 + n0 are its square and twice what is lifted
    moved = plus(squared(gone), (2 * lifted[0], 2 * lifted[1]))
    found = (S.One, *(rounded(over(pair, some)) for pair in (risen, sunk, moved)))
    return pick(swings, pick(near, found, 0), 0)


def _beyond(square, root, count, missed, precision):
    """Root - 2 pi count."""
    large, middle, small = precision.parts(4 * pi**2, 3)
    square, low = square
    turns = do("turns", count * count)
    most, most_low = scaled(turns, large)
    more, more_low = scaled(turns, middle)
    left, one = two_diff(-square, most)
    left, two = two_diff(left, most_low)
    left, three = two_diff(left, more)
    left, four = two_diff(left, low)
    turned = do("turned_low", turns * small)
    low = do("low", one + two + three + four - (more_low + turned))
    left = two_diff(left, -low)
    once, once_low = precision.parts(2 * pi)
    way, way_low = scaled(count, once)
    both, lost = two_diff(root, -way)
    back = do("back", count * once_low)
    low = do("both_low", lost + (way_low + back) + missed)
    return over(left, (do.divisor(both), low))


# -- power series, for slow poles: sums of both of their powers --------------------------------

_CAREFUL = 4
"""Last terms of a series with signs that are added up to twice the precision."""


def _sizes(precision, ahead):
    """Terms that serve for slow poles and for all; ``ahead`` bounds those of a size from k on."""
    return [precision.terms(partial(ahead, size)) for size in (TINY, NEAR)]


def _simplex(size, k):
    """Of a divided difference of exp at three nodes: the sum of k + 1 products is over (k + 2)!."""
    return 2 * (k + 1) * size**k / factorial(k + 2)


def _powers(names, half, square, terms, first, step):
    """Horner's scheme from the last term on; for slow poles from an earlier one.

    ``first`` are the n of the first two terms, each of which has the coefficient 1/n!.
    """
    slow = And(half < TINY / 2, Abs(square) < TINY**2 / 4)  # half + sqrt |square| is at most TINY
    few, all_ = (first.start + (count - 1) * first.step for count in terms)
    return do.sum(names, step, range(all_, first.start - 1, -first.step), slow, few)


@routine()
def plant_n1_series(h, w, precision):
    """divided difference of exp at h and +-sqrt(w), less 1/2"""
    few, all_ = _sizes(precision, _simplex)

    def step(total, one, two, number):
        even = do("even", number + w * two)
        return even + h * total, even, one

    total, _, two = _powers("total one two", h, w, (few - 1, all_ - 1), range(3, 5), step)
    return w * two + h * total


@routine()
def plant_n0_series(gamma, delta, precision):
    """divided difference of exp at 0, p and q, less 1/2"""
    few, all_ = (size - _CAREFUL for size in _sizes(precision, _simplex))

    def step(one, two, number):
        return number + delta * one - gamma * two, one

    first = range(_CAREFUL + 2, _CAREFUL + 4)
    one, two = _powers("one two", delta / 2, gamma, (few, all_), first, step)
    one, two = (one, S.Zero), (two, S.Zero)
    for k in range(_CAREFUL - 1, -1, -1):
        number = 1 / factorial(k + 2) if k else S.Zero
        one, two = plant_n0_term(gamma, delta, one, two, number), one
    return rounded(one)


@routine("total total_low", called="one one_low")
def plant_n0_term(gamma, delta, one: Pair, two: Pair, number):
    """number + delta one - gamma two and what it misses, of pairs"""
    return minus(minus(scaled(delta, one), scaled(gamma, two)), -number)


def _mixed(h, w, first, precision):
    """Sum over i and j, not both 0, of (h^2)^j w^i/(2 (i + j) + first)!."""
    few, all_ = _sizes(precision, lambda size, k:
                       2 * (k + 1) * size ** (2 * k) / factorial(2 * k + first))  # fmt: skip
    y = do("y", h * h)

    def step(total, inner, number):
        inner = do("own", number + w * inner)
        return inner + y * total, inner

    terms, begin = (few - 1, all_ - 1), range(first + 2, first + 6, 2)
    total, inner = _powers("total inner", h, w, terms, begin, step)
    return w * inner + y * total


@routine()
def numerator_at_one_series(h, w, precision):
    """divided difference of cosh(sqrt) at h^2 and w, less 1/2"""
    return _mixed(h, w, 2, precision)


@routine()
def numerator_gap_series(h, w, precision):
    """divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6"""
    return _mixed(h, w, 3, precision) + precision.parts(Rational(1, 6))[1]


@routine()
def plant_n0_near(decayed: Pair, gamma, delta):
    """n0 of a device with slow poles"""
    return scaled_sum(squared(decayed), plant_n0_series(gamma, delta), S.Half)


def _only(small, *given):
    """Arguments of a form near the origin, which are 0 elsewhere."""
    return [pick(small, argument, 0) for argument in given]


def _n1_near(small, *given):
    """n1 from its power series, of the pair exp(-half), half and w."""
    fall, half, w = _only(small, *given)
    return scaled_sum(fall, plant_n1_series(half, w), S.Half)


def _one_near(small, half, w, envelope=None):
    """The same of n1 + n0; of a device that swings exp(-half) is there."""
    half, w = _only(small, half, w)
    return 2 * scaled_sum(envelope or exp(-half), numerator_at_one_series(half, w), S.Half)


def _gap_near(small, half, w, envelope=None):
    """The same of (n1 - n0)/delta."""
    half, w = _only(small, half, w)
    return scaled_sum(envelope or exp(-half), numerator_gap_series(half, w), SIXTH)


# -- of poles that creep -----------------------------------------------------------------------


@routine(takes="Motion Creeping")
def plant_n1_creep(reach, half, w, p: Pair, slow: Pair, mean: Pair, far: Pair, decayed: Pair):
    """n1 of an overdamped device"""
    found = over(minus(mean, times(slow, far)), p)
    near = _n1_near(reach < SOFT, decayed, half, w)
    return choose(reach < SOFT, near, rounded(found))


@routine(takes="Motion Creeping")
def plant_n0_creep(reach, p: Pair, slow: Pair, mean: Pair, ratio: Pair, far: Pair, decayed: Pair,
                   gamma, delta):  # fmt: skip
    """n0 of an overdamped device"""
    found = times(slow, over(minus(far, times(ratio, mean)), p))
    near = plant_n0_near(*_only(reach < SOFT, decayed, gamma, delta))
    return choose(reach < SOFT, near, rounded(found))


@routine(takes="Motion Creeping")
def numerator_at_one_creep(reach, half, w, p: Pair, slow: Pair, mean: Pair, ratio: Pair):
    """n1 + n0 of an overdamped device"""
    fast = times(slow, ratio)
    found = over(times(mean, one_minus(fast)), p)
    return choose(reach < 1, _one_near(reach < 1, half, w), rounded(found))


@routine(takes="Motion Creeping")
def denominator_at_minus_one_creep(slow: Pair, ratio: Pair):
    """1 + a + e of an overdamped device"""
    fast = times(slow, ratio)
    return rounded(times(one_plus(slow), one_plus(fast)))


@routine(takes="Motion Creeping")
def numerator_gap_creep(reach, half, w, p, slow, mean: Pair, ratio, far: Pair, delta):
    """(n1 - n0)/delta of an overdamped device"""
    top, top_low = minus(mean, scaled(do("twice", 2 * slow), far))
    more, more_low = scaled(do("fast", slow * ratio), mean)
    top, low = do("top", top + more), do("low", top_low + more_low)
    found = (top + low) / do.divisor(p * delta)
    return choose(reach < 1, _gap_near(reach < 1, half, w), found)


# -- of poles that swing: a form near the origin, what is known near whole turns, a closed form ----


@routine(takes="Motion Swinging")
def plant_n1_swing(reach, half, w, envelope, even: Pair, wave: Pair, near, risen, decayed: Pair,
                   gamma):  # fmt: skip
    """n1 of an oscillating device"""
    top = one_minus(scaled(envelope, plus(even, scaled(half, wave))))
    swing = rounded(over(top, do.divisor(gamma)))
    slow = _n1_near(reach < SOFT, decayed, half, w)
    return choose(reach < SOFT, slow, choose(near > 0, risen, swing))


@routine(takes="Motion Swinging")
def plant_n0_swing(reach, half, envelope, even: Pair, wave: Pair, near, sunk, decayed: Pair,
                   gamma):  # fmt: skip
    """n0 of an oscillating device"""
    both = minus(scaled(half, wave), even)
    top = scaled(envelope, plus(both, envelope))
    swing = rounded(over(top, do.divisor(gamma)))
    slow = plant_n0_near(*_only(reach < SOFT, decayed, gamma, 2 * half))
    return choose(reach < SOFT, slow, choose(near > 0, sunk, swing))


@routine("total total_low")
def half_squares(half, envelope, wave, back):
    """(1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses"""
    grown = do("grown", -expm1(-half) / 2)
    turned = scaled(envelope, squared(two_diff(wave, back)))
    return plus(turned, grown * grown)


def _squares(half, w, root, envelope, wave):
    """(1 - exp(-delta/2))^2/4 and exp(-delta/2) times the square of sin or cos of root/2, added."""
    angle = do("angle", root / 2)
    own, other = (sin(angle), cos(angle)) if wave is sin else (cos(angle), -sin(angle))
    return half_squares(half, envelope, own, do("back", -root_miss(w, root) / 2 * other))


@routine(takes="Motion Swinging")
def numerator_at_one_swing(reach, half, w: Pair, root, envelope, near, moved, gamma):
    """n1 + n0 of an oscillating device"""
    found = rounded(over(_squares(half, w, root, envelope, sin), do.divisor(gamma)))
    slow = _one_near(reach < 1, half, w[0], envelope)
    return choose(reach < 1, slow, choose(near > 0, moved, 4 * found))


@routine(takes="Motion Swinging")
def denominator_at_minus_one_swing(half, w: Pair, root, envelope, even: Pair):
    """1 + a + e of an oscillating device"""
    squares = _squares(half, w, root, envelope, cos)  # a sum where a > 0, these where it is not
    turn = scaled(2 * envelope, even)
    both = plus(one_plus(do("e", exp(-2 * half))), turn)
    return choose(turn[0] > 0, rounded(both), 4 * rounded(squares))


@routine(takes="Motion Swinging")
def numerator_gap_swing(reach, half, w, envelope, wave: Pair, gamma, delta):
    """(n1 - n0)/delta of an oscillating device"""
    top = minus(do("mean", Decay(delta)), scaled(envelope, wave))
    swing = rounded(over(top, do.divisor(gamma)))
    return choose(reach < 1, _gap_near(reach < 1, half, w, envelope), swing)


# -- of any device; a series first: of a function alone nothing else is found in vain then -----


def _either(small, near, swing, creep, found):
    """A form near the origin, else that of an oscillating or of an overdamped device."""
    both = choose(found[1]["w"] < 0, swing.of(found[0]), creep.of(found[1]))
    return choose(small, near, both)


@routine()
def plant_n1(gamma, delta):
    """n1, how far a unit force moves the device in a period"""
    found = shared(gamma, delta, fades=True)
    of = found[1]
    small = of["reach"] < SOFT
    near = _n1_near(small, (of["decayed"], of["decayed_low"]), of["half"], of["w"])
    return _either(small, near, plant_n1_swing, plant_n1_creep, found)


@routine()
def plant_n0(gamma, delta):
    """n0, the same device with its time reversed, times exp(-delta)"""
    found = shared(gamma, delta, fades=True)
    of = found[1]
    small = of["reach"] < SOFT
    near = plant_n0_near(*_only(small, (of["decayed"], of["decayed_low"]), gamma, delta))
    return _either(small, near, plant_n0_swing, plant_n0_creep, found)


@routine()
def numerator_at_one(gamma, delta):
    """n1 + n0"""
    # a product for a creeping device, a sum of squares for a swinging one
    found = shared(gamma, delta)
    small = found[1]["reach"] < 1
    near = _one_near(small, found[1]["half"], found[1]["w"])
    return _either(small, near, numerator_at_one_swing, numerator_at_one_creep, found)


@routine()
def numerator_gap(gamma, delta):
    """(n1 - n0)/delta"""
    # for delta = 0 and a stiff spring only a finite number: forms have delta NumeratorGap alone
    found = shared(gamma, delta)
    small = found[1]["reach"] < 1
    near = _gap_near(small, found[1]["half"], found[1]["w"])
    return _either(small, near, numerator_gap_swing, numerator_gap_creep, found)


@routine()
def denominator_at_minus_one(gamma, delta):
    """1 + a + e"""
    swing, creep = shared(gamma, delta)
    return choose(creep["w"] < 0, denominator_at_minus_one_swing.of(swing),
                  denominator_at_minus_one_creep.of(creep))  # fmt: skip


@routine()
def plant_trace(gamma, delta):
    """a, the sum of the sampled device's poles"""
    swing, creep = shared(gamma, delta)
    even, slow, ratio = ((of[name], of[f"{name}_low"]) for of, name in (
        (swing, "even"), (creep, "slow"), (creep, "ratio")))  # fmt: skip
    swings = 2 * rounded(scaled(swing["envelope"], even))
    return choose(creep["w"] < 0, swings, rounded(times(slow, one_plus(ratio))))


def _kick(gamma, delta):
    """The nearest float, and what it misses."""
    swing, creep = shared(gamma, delta)
    wave, fall, far = ((of[name], of[f"{name}_low"]) for of, name in (
        (swing, "wave"), (creep, "slow"), (creep, "far")))  # fmt: skip
    swings = fast_two_sum(*scaled(swing["envelope"], wave))
    return pick(creep["w"] < 0, swings, fast_two_sum(*times(fall, far)))


@routine()
def kick(gamma, delta):
    """displacement by a unit impulse after a period"""
    return _kick(gamma, delta)[0]


@routine()
def kick_low(gamma, delta):
    """what the last rounding of Kick takes"""
    return _kick(gamma, delta)[1]
