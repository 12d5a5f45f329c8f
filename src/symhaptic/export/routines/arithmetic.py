"""Pairs of floats, and the elementary functions made of them.

The first of a pair is the nearest float, the second one what it misses: of sums and of products of
two floats exactly, of pairs nearly; T. J. Dekker, Numer. Math. 18 (1971) 224-242.

The libraries' exp, expm1, sin and cos are off by half a last place and more, which differences
magnify.  Where such a function is close to 1, its series below is exact to a small part of that:
the leading terms are added without rounding.
"""

from __future__ import annotations

from symhaptic.export.precision import DOUBLE
from symhaptic.export.routines.prelude import *
from symhaptic.forms.entire import CosNext, Decay, Gap, Lag, Sinc, SinNext

# -- arithmetic of pairs -----------------------------------------------------------------------


@routine()
def rounded(x: Pair):
    """the float of a pair"""
    return x[0] + x[1]


@routine("total total_low")
def fast_two_sum(x, y):
    """x + y and what it misses, for |x| >= |y|"""
    total = do("total", x + y)
    back = do("back", total - x)
    return total, y - back


@routine("total total_low", called="diff diff_low")
def two_diff(x, y):
    """x - y and what it misses"""
    total = do("total", x - y)
    back = do("back", total - x)
    rest = do("rest", total - back)
    one, two = do("one", x - rest), do("two", -y - back)
    return total, one + two


@routine("total total_low", called="prod prod_low")
def two_prod(x, y):
    """x y and what it misses"""
    return do("total", x * y), TwoProdError(x, y)


@routine("total total_low", called="prod prod_low")
def wide_prod(x, y: Pair):
    """x y of a float and a pair"""
    return do("total", x * y[0]), TwoProdError(x, y[0]) + x * y[1]


def scaled(factor, number):
    """A float times a float or a pair."""
    if not isinstance(number, tuple) or number[1] == 0:
        return two_prod(factor, number[0] if isinstance(number, tuple) else number)
    return wide_prod(factor, number)


@routine("total total_low", name="PairSum")
def plus(x: Pair, y: Pair):
    """x + y of pairs"""
    total, lost = two_diff(x[0], -y[0])
    return total, do("lost", lost + x[1]) + y[1]


@routine("total total_low", called="diff diff_low", name="PairDiff")
def minus(x: Pair, y: Pair):
    """x - y of pairs"""
    total, lost = two_diff(x[0], y[0])
    return total, do("lost", lost + x[1]) - y[1]


@routine("total total_low")
def one_plus(x: Pair):
    """1 + x of a pair, for |x| <= 1"""
    total, lost = fast_two_sum(S.One, x[0])
    return total, lost + x[1]


@routine("total total_low", called="less less_low")
def one_minus(x: Pair):
    """1 - x of a pair, for |x| <= 1"""
    total, lost = fast_two_sum(S.One, -x[0])
    return total, lost - x[1]


@routine("total total_low", called="prod prod_low", name="PairProd")
def times(x: Pair, y: Pair):
    """x y of pairs"""
    total, lost = scaled(x[0], y)
    return total, lost + x[1] * y[0]


@routine("total total_low", called="squared squared_low", name="PairSquare")
def squared(x: Pair):
    """x^2 of a pair"""
    return scaled(x[0], (x[0], 2 * x[1]))


@routine("total total_low", called="quot quot_low", name="PairQuot")
def over(x: Pair, y: Pair):
    """x/y of pairs"""
    total = do("total", x[0] / y[0])
    left = do("left", x[0] - total * y[0])
    left = do("left", left - TwoProdError(total, y[0]))
    left = do("left", left + do("rest", x[1] - total * y[1]))
    return total, left / y[0]


@routine()
def scaled_sum(fall: Pair, y, z):
    """(fall + fall_low) (y + z), rounded once"""
    return rounded(times(fall, two_diff(y, -z)))


@routine(listed=False)
def two_prod_error(y, z, precision):
    """y z minus the float nearest to it"""
    product = do("product", y * z)  # Dekker's, for targets without a fused one
    halves = []
    for number in (y, z):
        big = do("big", precision.split * number)
        away = do("away", big - number)
        high = do("high", big - away)
        halves.append((high, do("low", number - high)))
    (high, low), (most, least) = halves
    left = do("left", high * most)
    left = do("left", left - product)
    left = do("left", left + high * least)
    left = do("left", left + low * most)
    return left + low * least


# -- exponentials and waves as pairs -----------------------------------------------------------

BRIEF = Rational(3, 4)
"""Up to this rate 1 - exp(-rate) is found from its series, beyond it from exp(-rate)."""

SLOW = Rational(3, 2)
"""The same for the squared angle of a wave: cos is still above 1/4."""


@routine("fall fall_low mean mean_low", record="Fading")
def brief_fading(rate: Pair):
    """exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4"""
    x, low = rate
    first, lost = fast_two_sum(S.One, -x / 2)
    curved = do("curved", x * x * decay_series(x))
    mean, more = fast_two_sum(first, curved)
    bent = do("bent", low * (S.Half - x / 3 + x * x / 8))
    whole = mean, do("mean_low", (lost + more) - bent)
    return one_minus(times(rate, whole)), whole


@routine("fall fall_low mean mean_low", record="Fading")
def fading_pair(rate: Pair):
    """exp(-rate), (1 - exp(-rate))/rate and what they miss"""
    x, low = rate
    brief = x < BRIEF
    near = brief_fading((do("given", choose(brief, x, 0)), low))
    sunk = do("sunk", exp(-x))
    fall = sunk, do("sunk_low", -sunk * low)
    bottom = do("bottom", choose(brief, 1, x))
    return pick(brief, near, (fall, over(one_minus(fall), (bottom, low))))


@routine()
def root_miss(square: Pair, root):
    """what the root of |square + square_low| misses"""
    w, low = square
    low = do("sign_low", choose(w < 0, -low, low))
    left = do("left", Abs(w) - root * root)  # exact
    left = do("left", left - TwoProdError(root, root))
    return do("left", left + low) / do.nonzero(root) / 2


@routine("even even_low odd odd_low", record="Wave")
def waving_pair(square: Pair, angle):
    """cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle"""
    w, low = square
    slow = w > -SLOW
    small = do("small", choose(slow, w, 0))
    first, lost = fast_two_sum(S.One, small / 2)
    even, more = fast_two_sum(first, do("curved", small * small * cos_series(small)))
    both = do("both", lost + more)
    odd = one_plus((do("bent", small * sin_series(small)), low / 6))
    miss = do("angle_low", root_miss(square, angle))
    sine, cosine = do("sine", sin(angle)), do("cosine", cos(angle))
    some = do("some", choose(slow, 1, angle))
    far = (cosine, -miss * sine), over((sine, miss * cosine), (some, miss))
    return pick(slow, ((even, both + low / 2), odd), far)


def _polynomial(at, factorials):
    """The sum of at^k/n! for the n of a range, its even and its odd half side by side."""
    square = do("square", at * at)
    one, two = do.sum("one two", lambda one, two, number:
                      (do("both", number + square * two), one), factorials[:0:-1])  # fmt: skip
    return 1 / factorial(factorials[0]) + at * one + square * two


@routine()
def decay_series(x, precision):
    """((1 - exp(-x))/x - 1 + x/2)/x^2"""
    count = precision.terms(lambda k: BRIEF**k / factorial(k + 3))
    return _polynomial(-x, range(3, count + 3))


@routine()
def cos_series(w, precision):
    """(cosh(sqrt(w)) - 1 - w/2)/w^2"""
    count = precision.terms(lambda k: SLOW**k / factorial(2 * k + 4))
    return _polynomial(w, range(4, 2 * count + 4, 2))


@routine()
def sin_series(w, precision):
    """(sinh(sqrt(w))/sqrt(w) - 1)/w"""
    count = precision.terms(lambda k: SLOW**k / factorial(2 * k + 3))
    return _polynomial(w, range(3, 2 * count + 3, 2))


# -- entire functions of one variable ----------------------------------------------------------

SIXTH = DOUBLE.parts(Rational(1, 6), 1)[0]
"""The float next to 1/6, in any precision; its series has what it misses."""


@routine()
def decay(x):
    """(1 - exp(-x))/x"""
    whole = do.nonzero(x)
    return choose(Eq(x, 0), 1, -expm1(-x) / whole)


@routine()
def creep(x):
    """(exp(-x) - 1 + x)/x^2"""
    # half of the sum of Creep and Fade and of their difference, both of which are positive
    return (Decay(x) + x * Lag(x)) / 2


@routine()
def fade(x):
    """(1 - (1 + x) exp(-x))/x^2"""
    near = (Decay(x) - x * Lag(x)) / 2
    far = (Decay(x) - exp(-x)) / do.nonzero(x)
    return choose(x < 2, near, far)


@routine()
def lag(x):
    """(x - 2 + (x + 2) exp(-x))/x^3"""
    near = exp(-x / 2) * sp.Function("BendSeries")(choose(x >= 4, 0, x * x / 4))
    whole = do("whole", choose(x < 4, 4, x))
    two = do("two", x - 2)
    far = (two + (x + 2) * exp(-x)) / whole / (whole * whole)
    return choose(x < 4, near, far)


@routine()
def sinc(x):
    """sin(x)/x"""
    near = do("near", choose(Abs(x) >= 1, 0, x))
    far = sin(x) / do.nonzero(x)
    return choose(Abs(x) < 1, 1 - near * near * Gap(near), far)


@routine()
def gap(x, precision):
    """(x - sin(x))/x^3"""
    near = do("near", choose(Abs(x) >= 2, 0, x))  # from 2 on the difference keeps its digits
    square = do("square", -near * near)
    sixth, low = precision.parts(Rational(1, 6))  # what the float misses goes into the next term
    terms = precision.terms(lambda k: 6 * sp.Integer(4) ** k / factorial(2 * k + 3))
    (total,) = do.sum("total", lambda total, number: [number + square * total],
                      range(2 * terms + 1, 4, -2))  # fmt: skip
    total = do("total", sixth + do("rest", square * total + low))
    whole = do("whole", choose(Abs(x) < 2, 2, x))
    return choose(Abs(x) < 2, total, (x - sin(x)) / whole / (whole * whole))


def _root(w):
    """sqrt |w|, its rounding error, and the root with 1 in place of 0."""
    size = do("size", Abs(w))
    root = do("root", sqrt(size))
    some = do.nonzero(root)
    left = do("left", size - root * root)
    left = do("left", left - TwoProdError(root, root))
    return root, do("low", left / some / 2), some


@routine()
def cosh_root(w):
    """cosh(sqrt(w))"""
    root, low, _ = _root(w)
    swing = do("cosine", cos(root)) - low * sin(root)
    grown = do("grown", exp(choose(w < 0, 0, root)))
    return choose(w < 0, swing, (grown + 1 / grown) / 2)


@routine()
def sinhc_root(w):
    """sinh(sqrt(w))/sqrt(w)"""
    root, low, some = _root(w)
    sine = do("sine", sin(root))
    swing = do("turned", sine + low * cos(root)) / some
    grown = do("grown", expm1(choose(w < 0, 0, root)))
    creeps = (grown + grown / (1 + grown)) / 2 / some
    return choose(Eq(w, 0), 1, choose(w < 0, swing, creeps))


# -- functions of an angle and a delay, with the rounding of sum and product put back ----------

_QUARTER = Rational(3, 2)
"""Near a quarter turn."""


@routine("cosine sine", record="CosSin")
def next_wave(k, x, precision):
    """cos((k + 1) x) and sin((k + 1) x)"""
    if precision.bits < DOUBLE.bits:
        turn, sine, cosine = _turned(k, x, precision)
        odd = Or(Eq(turn, 1), Eq(turn, 3))
        even_wave, odd_wave = (do("value", choose(odd, *pair))
                               for pair in ((sine, cosine), (cosine, sine)))  # fmt: skip
        cosine = choose(sp.And(turn >= 1, turn <= 2), -even_wave, even_wave)
        return cosine, choose(turn >= 2, -odd_wave, odd_wave)
    angle, off, missed = _next_parts(k, x)
    off = do("off", off + missed * x)
    wave, still = do("sine", sin(angle)), do("cosine", cos(angle))
    small = Abs(off) < sqrt(precision.last) / 2
    cosine = choose(small, still - off * wave, still * cos(off) - wave * sin(off))
    return cosine, choose(small, wave + off * still, wave * cos(off) + still * sin(off))


@routine()
def cos_next(k, x):
    """cos((k + 1) x)"""
    return next_wave(k, x)[0]


@routine()
def sin_next(k, x):
    """sin((k + 1) x)"""
    return next_wave(k, x)[1]


@routine()
def spread(k, x):
    """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3"""
    # up to a quarter turn of the delay the sines are close, beyond it they add
    order, turn, angle, some = _delayed(k, x)
    near = order * (order * order * Gap(2 * angle) - Gap(x))
    far = (order * sin(x) - 2 * SinNext(k, x) * CosNext(k, x)) / some / (some * some)
    return choose(turn < _QUARTER, near, far)


@routine()
def chord(k, x):
    """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3"""
    order, turn, angle, some = _delayed(k, x)
    along = do("along", CosNext(k, x))
    wave = do("wave", Sinc(angle / 2))
    inner = do("inner", wave * wave / 2 - Gap(angle))
    near = order * (order * order * inner / 4 + Gap(x) * along)
    far = (2 * SinNext(k, x) - order * sin(x) * along) / some / (some * some)
    return choose(turn < _QUARTER, near, far)


def _delayed(k, x):
    """2 (k + 1), the angle (k + 1) x, the same where it is small, and x where it is not."""
    turn = do("turn", (k + 1) * x)
    angle = do("angle", choose(turn >= _QUARTER, 0, turn))
    some = do("some", choose(turn < _QUARTER, 1, x))
    return do("order", 2 * (k + 1)), turn, angle, some


def _next_parts(k, x):
    """The product of x and k + 1 rounded, its rounding error, and the sum's rounding error."""
    count = do("count", k + 1)
    before = do("before", count - 1)
    angle = do("angle", count * x)
    return angle, TwoProdError(count, x), do("missed", k - before)


def _turned(k, x, precision):
    """Quarter turns in (k + 1) x, modulo 4, with sine and cosine of what is left.

    For few digits: the rounding of a long angle is no small angle then.
    """
    angle, off, missed = _next_parts(k, x)
    large, middle, small = precision.parts(sp.pi / 2, 3)
    count = do("quarters", floor(angle * 2 / sp.pi + S.Half))
    left = do("left", angle - count * large)  # exact
    left, one = two_diff(left, TwoProdError(count, large))
    left, two = two_diff(left, count * middle)
    left, three = two_diff(left, -off)
    left, four = two_diff(left, -missed * x)
    low = do("low", one + two + three + four - (TwoProdError(count, middle) + count * small))
    low = do("low", low + TwoProdError(missed, x))
    sine, cosine = do("wave", sin(left)), do("still", cos(left))
    turn = do("turn", count - 4 * floor(count / 4))
    return turn, do("sine", sine + low * cosine), do("cosine", cosine - low * sine)
