# Written by `symhaptic kernels` from the stable forms; do not edit.
"""Passivity and stability of haptic walls."""

import functools
import math
import operator
import sys
from typing import NamedTuple

import numpy
from array_api_compat import (
    array_namespace,
    device,
    is_array_api_obj,
    is_jax_array,
    is_lazy_array,
    is_numpy_array,
    is_torch_array,
)

BLOCK = 25_000
"""Elements of NumPy arrays worked on at a time: few calls, and each branch fits the caches."""

FEW = 100
"""Operations below which XLA rather computes all than asks whether one is wanted."""


class Limits(NamedTuple):
    """What an argument may be at most."""

    size: float
    stiffness: float
    periods: float
    angle: float
    """The last float before pi."""


DOUBLE = Limits(1e+70, 1000000000000000.0, 1000000000000000.0, 3.141592653589793)
SINGLE = Limits(100000000.0, 10000000.0, 1000000.0, 3.141592502593994)


def limits(xp, x):
    """Those of the precision of an array."""
    return SINGLE if x.dtype == xp.float32 else DOUBLE


def by_value(function):
    """The function, with the numbers of JAX arrays in a processor's memory worked on by NumPy.

    XLA would compile every search anew.  Traced arrays and those elsewhere are not touched.
    """

    @functools.wraps(function)
    def called(*values, **named):
        given = [v for v in (*values, *named.values()) if is_jax_array(v)]
        if not given or not all(map(_at_hand, given)):
            return function(*values, **named)
        named = {name: _numbers(v) for name, v in named.items()}
        results = function(*map(_numbers, values), **named)
        place = functools.partial(sys.modules["jax"].device_put, device=device(given[0]))
        return tuple(map(place, results)) if isinstance(results, tuple) else place(results)

    return called


def _at_hand(x):
    if isinstance(x, sys.modules["jax"].core.Tracer) or x.dtype.kind not in "fiu":
        return False
    return {place.platform for place in x.devices()} == {"cpu"} and len(x.devices()) == 1


def _numbers(x):
    return numpy.asarray(x) if is_jax_array(x) else x


def arrays(*values):
    """The namespace of the arrays, and all values as arrays of one floating type in it."""
    given = [v for v in values if is_array_api_obj(v) and not isinstance(v, numpy.generic)]
    if not given:
        values = [v if isinstance(v, (int, float)) else numpy.asarray(v) for v in values]
        given = [v for v in values if is_array_api_obj(v)] or [numpy.asarray(0.0)]
    xp = array_namespace(*given)
    kinds = [v.dtype for v in given if xp.isdtype(v.dtype, "real floating")]
    kind = xp.result_type(xp.float32, *kinds) if kinds else _default(xp)
    kind = xp.float32 if kind == xp.float32 else xp.float64  # bounds and halves are of these two
    where = {} if is_lazy_array(given[0]) else {"device": device(given[0])}
    return xp, *(
        _real(xp, v, kind)
        if is_array_api_obj(v) and not isinstance(v, numpy.generic)
        else xp.asarray(_outside_or(v), dtype=kind, **where)
        for v in values
    )


def _real(xp, v, kind):
    """The array in this kind, NaN where its elements are complex, text, dates or masked."""
    if isinstance(v, numpy.ma.MaskedArray):
        return xp.where(numpy.ma.getmaskarray(v), math.nan, _real(xp, v.data, kind))
    if getattr(v.dtype, "kind", None) == "O":
        return xp.reshape(xp.asarray([_outside_or(x) for x in v.flat], dtype=kind), v.shape)
    if xp.isdtype(v.dtype, "complex floating") or getattr(v.dtype, "kind", None) in tuple("USMmV"):
        return xp.full_like(v, math.nan, dtype=kind)
    if isinstance(v, numpy.ndarray):
        with numpy.errstate(over="ignore"):  # of a longer float, which then is outside
            return v.astype(kind, copy=False)
    return xp.astype(v, kind, copy=False)


def _outside_or(v):
    """The value, or NaN for what is no real number, or an integer that no float holds."""
    if isinstance(v, (complex, str, bytes)) or (isinstance(v, int) and abs(v) >> 1023):
        return math.nan
    return math.nan if isinstance(v, numpy.generic) and v.dtype.kind not in "biuf" else v


def _default(xp):
    return xp.__array_namespace_info__().default_dtypes()["real floating"]


def deferred(x):
    """Whether the numbers in an array cannot be looked at now: JAX, or torch while it compiles."""
    if isinstance(x, numpy.ndarray):
        return False
    if is_torch_array(x):
        return sys.modules["torch"].compiler.is_compiling()
    return is_lazy_array(x)


def elementwise(xp, work, *values):
    """What ``work`` makes of arrays that are broadcast; NaN gives NaN.

    It gets flat ones, of one element where there is but one, unless numbers cannot be looked at.
    """
    return _broadcast(xp, functools.partial(_without_nan, xp, work), values)


def guarded(xp, work, names, count, outside, *values):
    """The same where all values are inside, elsewhere ``count`` results that are ``outside``.

    ``names`` are those of the conditions in ``INSIDE``, one for each of the first values; a number
    of a plant that is not inside is NaN.  ``work`` gets no value that is outside.
    """
    names, most = names.split(), limits(xp, values[0])

    def inside(*values):
        true = [INSIDE[name](xp, most, v) for name, v in zip(names, values, strict=False)]
        true += [~xp.isnan(v) for v in values[len(names):len(names) + 1]]
        return functools.reduce(operator.and_, true)

    return _broadcast(xp, functools.partial(_inside, xp, work, inside, count, outside), values)


def settled(xp, work, count, *values):
    """A verdict that is no where anything is counted, of a count and of values that are 0 there."""
    none = count == 0.0
    return xp.asarray(work(count, *(xp.where(none, v, 0.0) for v in values)))


def _broadcast(xp, work, values):
    """All results of ``work`` on flat pieces of the arrays, in the shape that they broadcast to."""
    shape = numpy.broadcast_shapes(*(tuple(v.shape) for v in values))
    if deferred(values[0]):
        results = work(values)
        results = [xp.broadcast_to(r, shape) for r in results]
        return results[0] if len(results) == 1 else tuple(results)
    size = math.prod(shape)
    flat = [xp.reshape(_stretched(xp, v, shape), (-1,)) for v in values]
    if size <= BLOCK or not is_numpy_array(values[0]):
        found = [xp.broadcast_to(r, (size,)) for r in work(flat)]
    else:
        found = None
        for begin in range(0, size, BLOCK):
            part = slice(begin, begin + BLOCK)
            rows = work([v if v.shape[0] == 1 else v[part] for v in flat])
            if found is None:
                found = [numpy.empty(size, r.dtype) for r in rows]
            for whole, row in zip(found, rows, strict=True):
                whole[part] = row
    results = [xp.reshape(r, shape) for r in found]
    return results[0] if len(results) == 1 else tuple(results)


def _stretched(xp, values, shape):
    return values if math.prod(values.shape) == 1 else xp.broadcast_to(values, shape)


def _without_nan(xp, work, values):
    """All results of ``work``, NaN where a value is NaN."""
    unknown = xp.isnan(sum(values[1:], values[0]))
    results = work(*values)
    results = results if isinstance(results, tuple) else (results,)
    if not deferred(unknown) and not bool(xp.any(unknown)):
        return [r if is_array_api_obj(r) else xp.full_like(values[0], r) for r in results]
    nan = xp.full_like(values[0], math.nan)
    return [xp.where(unknown, nan, r) for r in results]


def _inside(xp, work, inside, count, outside, values):
    """All results of ``work``, and the one for outside where a value is not inside."""
    known = inside(*values)
    if deferred(known):
        found = _rows(xp, values[0], work(*(xp.where(known, v, 0.5) for v in values)))
        return [xp.where(known, r, xp.full_like(r, outside)) for r in found]
    if bool(xp.all(known)):
        return _rows(xp, values[0], work(*values))
    (at,), (none,) = xp.nonzero(known), xp.nonzero(~known)
    kind = xp.bool if outside is False else values[0].dtype
    nothing = [xp.full(none.shape, outside, dtype=kind, device=device(known))] * count
    if at.shape[0] == 0:
        return nothing
    found = _rows(xp, values[0][:1], work(*_some(xp, at, values)))
    return _together(xp, known.shape[0], [(at, found), (none, nothing)])


def select(xp, condition, yes, yes_values, no, no_values=None):
    """``yes`` of its values where the condition holds, else ``no``; each only where it counts.

    Without values of its own, ``no`` gets those of ``yes``.
    Where numbers cannot be looked at, both are computed everywhere, of 1 where they do not count.
    """
    no_values = yes_values if no_values is None else no_values
    like = (*yes_values, *no_values)[0]
    if deferred(condition):
        one = _asked(xp, condition, yes, like, [xp.where(condition, v, 1.0) for v in yes_values])
        two = _asked(xp, ~condition, no, like, [xp.where(condition, 1.0, v) for v in no_values])
        return _all([xp.where(condition, a, b) for a, b in zip(one, two, strict=True)])
    size = condition.shape[0]
    count = int(xp.count_nonzero(condition))
    if count == size:
        return _all(_rows(xp, like, yes(*yes_values)))
    if count == 0:
        return _all(_rows(xp, like, no(*no_values)))
    pieces = []
    for where, work, values in ((condition, yes, yes_values), (~condition, no, no_values)):
        (at,) = xp.nonzero(where)
        pieces.append((at, _rows(xp, like[:1], work(*_some(xp, at, values)))))
    return _all(_together(xp, size, pieces))


def _asked(xp, wanted, work, like, values):
    """All results of ``work``; of JAX 0 where none is wanted.

    XLA then does not run it, and compiles it as a piece of its own, in half of the time or less.
    """
    if not is_jax_array(like):
        return _rows(xp, like, work(*values))
    jax = sys.modules["jax"]
    rows = jax.jit(lambda *values: _rows(xp, like, work(*values)))
    made = rows.trace(*values)
    if len(made.jaxpr.eqns) < FEW:
        return rows(*values)
    nothing = [xp.zeros(r.shape, dtype=r.dtype) for r in made.out_info]
    return jax.lax.cond(xp.any(wanted), rows, lambda *values: nothing, *values)


def _some(xp, at, values):
    return [v if v.shape[0] == 1 else xp.take(v, at) for v in values]


def _together(xp, size, pieces):
    """All rows of the pieces, each number in its place."""
    places = [at for at, _ in pieces]
    quick = isinstance(places[0], numpy.ndarray)  # the standard cannot write at places
    order = None if quick else xp.argsort(xp.concat(places))
    found = []
    for column in zip(*(rows for _, rows in pieces), strict=True):
        if quick:
            whole = numpy.empty(size, column[0].dtype)
            for at, row in zip(places, column, strict=True):
                whole[at] = row
        else:
            rows = (xp.broadcast_to(r, at.shape) for at, r in zip(places, column, strict=True))
            whole = xp.take(xp.concat(tuple(rows)), order)
        found.append(whole)
    return found


def _rows(xp, like, results):
    results = results if isinstance(results, tuple) else (results,)
    return [xp.full_like(like, r) if isinstance(r, (int, float)) else r for r in results]


def _all(rows):
    return rows[0] if len(rows) == 1 else tuple(rows)


def repeat(xp, most, over, step, start, given):
    """``step`` of the states and of what is given, until it is ``over``, at most so many times.

    Elements that are done keep their states while others go on.
    """
    sizes = [tuple(v.shape) for v in (*start, *given) if is_array_api_obj(v)]
    shape = numpy.broadcast_shapes(*sizes)
    like = next(v for v in (*given, *start) if is_array_api_obj(v))
    states = [
        xp.broadcast_to(v, shape) if is_array_api_obj(v)
        else xp.full(shape, v, dtype=like.dtype, device=device(like))
        for v in start
    ]

    def kept(states):
        done = over(*states, *given)
        return [xp.where(done, a, b) for a, b in zip(states, step(*states, *given), strict=True)]

    if is_jax_array(like):

        def busy(now):
            return (now[0] < most) & ~xp.all(over(*now[1], *given))

        loop = sys.modules["jax"].lax.while_loop
        return tuple(loop(busy, lambda now: (now[0] + 1, kept(now[1])), (0, states))[1])
    if deferred(like):
        for _ in range(most):
            states = kept(states)
        return tuple(states)
    pieces, places = [], xp.arange(shape[0], device=device(like))
    for _ in range(most):
        done = xp.broadcast_to(over(*states, *given), places.shape)
        if bool(xp.any(done)):
            (gone,), (left,) = xp.nonzero(done), xp.nonzero(~done)
            pieces.append((xp.take(places, gone), _some(xp, gone, states)))
            if left.shape[0] == 0:
                break
            places = xp.take(places, left)
            states, given = _some(xp, left, states), _some(xp, left, given)
        states = _rows(xp, states[0][:1], step(*states, *given))
    else:
        pieces.append((places, states))
    return tuple(_together(xp, shape[0], pieces))


def square_root(xp, x):
    """The root; of 0 with the slope 0, where slopes may be asked for."""
    if not deferred(x):
        return xp.sqrt(x)
    positive = x > 0
    return xp.where(positive, xp.sqrt(xp.where(positive, x, 1.0)), 0.0)


INVERSE_FACTORIAL = tuple(1/math.factorial(n) for n in range(40))
"""1/n!, the coefficients of all power series here."""


def series(xp, add, count, brief, first, few, last, step, given):
    """``count`` states, 0 at first, after ``add`` of 1/n! for n from ``first`` down to ``last``.

    Where it is ``brief``, for n from ``few`` on: what is before is too small to count.
    """

    def after(states, factorials, *given):
        for number in factorials:
            states = add(*states, number, *given)
            states = states if isinstance(states, tuple) else (states,)
        return states

    def begun(*given):
        return after((0.0,)*count, INVERSE_FACTORIAL[first:few:-step], *given)

    states = select(xp, brief, lambda *_: (0.0,)*count, given, begun, given)
    states = states if isinstance(states, tuple) else (states,)
    return _all(after(states, INVERSE_FACTORIAL[few:last - 1:-step], *given))


def decay_series(xp, x):
    """((1 - exp(-x))/x - 1 + x/2)/x^2"""
    begin = 12 if x.dtype == xp.float32 else 19
    square = (x*x)
    one, two = 0.0, 0.0
    for number in INVERSE_FACTORIAL[begin:3:-1]:
        both = number + square*two
        one, two = both, one
    return square*two - one*x + 0.16666666666666666


def fast_two_sum(xp, x, y):
    """x + y and what it misses, for |x| >= |y|"""
    total = x + y
    back = total - x
    return total, y - back


def one_minus(xp, x, x_low):
    """1 - x of a pair, for |x| <= 1"""
    total, total_low = fast_two_sum(xp, 1.0, -x)
    return total, total_low - x_low


def unfused(xp, product):
    """The product, rounded before it is added: XLA would fuse both into one operation."""
    held = deferred(product)
    return xp.where(xp.abs(product) < math.inf, product, math.nan) if held else product


def halves(xp, y):
    """A number as two of half its digits, whose products are exact.

    Of the bits of NumPy's doubles the last 27 are cut off, which takes half of the time; then the
    product of the lower halves is rounded, far below what counts.
    """
    if isinstance(y, numpy.ndarray) and y.dtype == xp.float64:
        high = (y.view(numpy.int64) & -(2**27)).view(numpy.float64)
    else:
        big = unfused(xp, (134217729.0 if y.dtype == xp.float64 else 4097.0)*y)
        high = big - (big - y)
    return high, y - high


def two_prod_error(product, one, two):
    """What a product misses, by Dekker, from the halves of its factors."""
    (high, low), (most, least) = one, two
    error = high*most
    if not isinstance(error, numpy.ndarray):
        return ((error - product) + high*least + low*most) + low*least
    error -= product  # in place: new memory takes a third of the time
    part = high*least
    error += part
    error += numpy.multiply(low, most, out=part)
    error += numpy.multiply(low, least, out=part)
    return error


def wide_prod(xp, x, y, y_low):
    """x y of a float and a pair"""
    return unfused(xp, x*y), x*y_low + two_prod_error(unfused(xp, x*y), halves(xp, x),
        halves(xp, y))


def pair_prod(xp, x, x_low, y, y_low):
    """x y of pairs"""
    prod, prod_low = wide_prod(xp, x, y, y_low)
    return prod, prod_low + x_low*y


def brief_fading(xp, rate, rate_low):
    """exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4"""
    total, total_low = fast_two_sum(xp, 1.0, -0.5*rate)
    total, total_low2 = fast_two_sum(xp, total, (rate*rate)*decay_series(xp, rate))
    bent = rate_low*(0.125*(rate*rate) - 0.3333333333333333*rate + 0.5)
    mean_low = total_low - bent + total_low2
    less, less_low = one_minus(xp, *pair_prod(xp, rate, rate_low, total, mean_low))
    return less, less_low, total, mean_low


def pair_quot(xp, x, x_low, y, y_low):
    """x/y of pairs"""
    total = x/y
    left = x - unfused(xp, total*y)
    left = left - two_prod_error(unfused(xp, total*y), halves(xp, total), halves(xp, y))
    rest = x_low - total*y_low
    left = left + rest
    return total, left/y


def fading_pair(xp, rate, rate_low):
    """exp(-rate), (1 - exp(-rate))/rate and what they miss"""
    def no(rate, rate_low):
        sunk = xp.exp(-rate)
        sunk_low = -rate_low*sunk
        quot, quot_low = pair_quot(xp, *one_minus(xp, sunk, sunk_low), rate, rate_low)
        return sunk, sunk_low, quot, quot_low

    return select(xp, rate < 0.75, lambda rate, rate_low: brief_fading(xp, rate, rate_low),
        (rate, rate_low), no)


def root_miss(xp, square, square_low, root):
    """what the root of |square + square_low| misses"""
    sign_low = xp.where(square < 0.0, -square_low, square_low)
    left = xp.abs(square) - unfused(xp, root*root)
    root_halves = halves(xp, root)
    left = left - two_prod_error(unfused(xp, root*root), root_halves, root_halves)
    left = left + sign_low
    whole = xp.where(root == 0.0, 1.0, root)
    return 0.5*left/whole


def real_poles(xp, gamma, half, w, w_low, root):
    """the poles p = half + root and q = gamma/p"""
    total, total_low = fast_two_sum(xp, half, root)
    p_low = total_low + root_miss(xp, w, w_low, root)
    whole = xp.where(total == 0.0, 1.0, total)
    quot, quot_low = pair_quot(xp, gamma, xp.full_like(gamma, 0.0), whole, p_low)
    return whole, p_low, quot, quot_low


def creeping_device(xp, gamma, half, w, w_low, root):
    """of an overdamped device the pole p, exp and mean of the other one and of their distance"""
    p, p_low, q, q_low = real_poles(xp, gamma, half, w, w_low, root)
    fall, fall_low, mean, mean_low = fading_pair(xp, q, q_low)
    root_low = root_miss(xp, w, w_low, root)
    fall2, fall_low2, mean2, mean_low2 = fading_pair(xp, 2.0*root, 2.0*root_low)
    return p, p_low, fall, fall_low, mean, mean_low, fall2, fall_low2, mean2, mean_low2


def two_diff(xp, x, y):
    """x - y and what it misses"""
    total = x - y
    back = total - x
    rest = total - back
    one = x - rest
    two = -back - y
    return total, one + two


def two_prod(xp, x, y):
    """x y and what it misses"""
    return unfused(xp, x*y), two_prod_error(unfused(xp, x*y), halves(xp, x), halves(xp, y))


def device_motion(xp, gamma, delta):
    """half = delta/2, w = half^2 - gamma, its root and the size of the poles"""
    half = 0.5*delta
    prod, prod_low = two_prod(xp, half, half)
    diff, diff_low = two_diff(xp, prod, gamma)
    total, total_low = fast_two_sum(xp, diff, diff_low + prod_low)
    root = square_root(xp, xp.abs(total))
    return half, total, total_low, root, xp.where(total < 0.0, 0.25*gamma, 0.4444444444444444*
        half + 0.4444444444444444*root)


def one_plus(xp, x, x_low):
    """1 + x of a pair, for |x| <= 1"""
    total, total_low = fast_two_sum(xp, 1.0, x)
    return total, total_low + x_low


def pair_diff(xp, x, x_low, y, y_low):
    """x - y of pairs"""
    diff, diff_low = two_diff(xp, x, y)
    lost = diff_low + x_low
    return diff, lost - y_low


def pair_square(xp, x, x_low):
    """x^2 of a pair"""
    return wide_prod(xp, x, x, 2.0*x_low)


def plant_n0_term(xp, gamma, delta, one, one_low, two, two_low, number):
    """number + delta one - gamma two and what it misses, of pairs"""
    return pair_diff(xp, *pair_diff(xp, *wide_prod(xp, delta, one, one_low),
        *wide_prod(xp, gamma, two, two_low)), -number, 0.0)


def rounded(xp, x, x_low):
    """the float of a pair"""
    return x + x_low


def plant_n0_series(xp, gamma, delta):
    """divided difference of exp at 0, p and q, less 1/2"""
    begin, begin2 = (20, 9) if gamma.dtype == xp.float32 else (28, 13)
    def add(one, two, number, delta, gamma):
        next_one = delta*one - gamma*two + number
        return next_one, one

    one, two = series(xp, add, 2, (0.5*delta < 0.0625) & (xp.abs(gamma) < 0.00390625), begin,
        begin2, 6, 1, (delta, gamma))
    one2, one_low = plant_n0_term(xp, gamma, delta, one, xp.full_like(delta, 0.0), two,
        xp.full_like(delta, 0.0), xp.full_like(delta, 0.008333333333333333))
    one3, one_low2 = plant_n0_term(xp, gamma, delta, one2, one_low, one, xp.full_like(delta, 0.0),
        xp.full_like(delta, 0.041666666666666664))
    return rounded(xp, *plant_n0_term(xp, gamma, delta,
        *plant_n0_term(xp, gamma, delta, one3, one_low2, one2, one_low,
        xp.full_like(delta, 0.16666666666666666)), one3, one_low2, xp.full_like(delta, 0.0)))


def scaled_sum(xp, fall, fall_low, y, z):
    """(fall + fall_low) (y + z), rounded once"""
    return rounded(xp, *pair_prod(xp, fall, fall_low, *two_diff(xp, y, -z)))


def plant_n0_near(xp, decayed, decayed_low, gamma, delta):
    """n0 of a device with slow poles"""
    return scaled_sum(xp, *pair_square(xp, decayed, decayed_low),
        plant_n0_series(xp, gamma, delta), 0.5)


def plant_n0_creep(xp, reach, p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far,
    far_low, decayed, decayed_low, gamma, delta):
    """n0 of an overdamped device"""
    def no(far, far_low, mean, mean_low, p, p_low, ratio, ratio_low, slow, slow_low):
        return rounded(xp, *pair_prod(xp, slow, slow_low,
            *pair_quot(xp, *pair_diff(xp, far, far_low,
            *pair_prod(xp, ratio, ratio_low, mean, mean_low)), p, p_low)))

    return select(xp, reach < 0.5625, lambda *v: plant_n0_near(xp, *v),
        (decayed, decayed_low, gamma, delta), no,
        (far, far_low, mean, mean_low, p, p_low, ratio, ratio_low, slow, slow_low))


def pair_sum(xp, x, x_low, y, y_low):
    """x + y of pairs"""
    diff, diff_low = two_diff(xp, x, -y)
    lost = diff_low + x_low
    return diff, lost + y_low


def plant_n0_swing(xp, reach, half, envelope, even, even_low, wave, wave_low, near, sunk, decayed,
    decayed_low, gamma):
    """n0 of an oscillating device"""
    def yes(decayed, decayed_low, gamma, half):
        return plant_n0_near(xp, decayed, decayed_low, gamma, 2.0*half)

    def no(envelope, even, even_low, gamma, half, near, sunk, wave, wave_low):
        def no(envelope, even, even_low, gamma, half, wave, wave_low):
            whole = xp.where(gamma == 0.0, 1.0, gamma)
            return rounded(xp, *pair_quot(xp, *wide_prod(xp, envelope,
                *pair_sum(xp, *pair_diff(xp, *wide_prod(xp, half, wave, wave_low), even, even_low),
                envelope, 0.0)), whole, xp.full_like(envelope, 0.0)))

        return select(xp, near > 0.0, lambda sunk: sunk, (sunk,), no,
            (envelope, even, even_low, gamma, half, wave, wave_low))

    return select(xp, reach < 0.5625, yes, (decayed, decayed_low, gamma, half), no,
        (envelope, even, even_low, gamma, half, near, sunk, wave, wave_low))


def plant_n1_series(xp, h, w):
    """divided difference of exp at h and +-sqrt(w), less 1/2"""
    begin, begin2 = (20, 9) if h.dtype == xp.float32 else (28, 13)
    def add(total, one, two, number, h, w):
        even = number + two*w
        next_total = even + h*total
        return next_total, even, one

    total, one, two = series(xp, add, 3, (h < 0.0625) & (xp.abs(w) < 0.00390625), begin, begin2, 3,
        1, (h, w))
    return h*total + two*w


def plant_n1_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far, far_low,
    decayed, decayed_low):
    """n1 of an overdamped device"""
    def yes(decayed, decayed_low, half, w):
        return scaled_sum(xp, decayed, decayed_low, plant_n1_series(xp, half, w), 0.5)

    def no(far, far_low, mean, mean_low, p, p_low, slow, slow_low):
        return rounded(xp, *pair_quot(xp, *pair_diff(xp, mean, mean_low,
            *pair_prod(xp, slow, slow_low, far, far_low)), p, p_low))

    return select(xp, reach < 0.5625, yes, (decayed, decayed_low, half, w), no,
        (far, far_low, mean, mean_low, p, p_low, slow, slow_low))


def plant_n1_swing(xp, reach, half, w, envelope, even, even_low, wave, wave_low, near, risen,
    decayed, decayed_low, gamma):
    """n1 of an oscillating device"""
    def yes(decayed, decayed_low, half, w):
        return scaled_sum(xp, decayed, decayed_low, plant_n1_series(xp, half, w), 0.5)

    def no(envelope, even, even_low, gamma, half, near, risen, wave, wave_low):
        def no(envelope, even, even_low, gamma, half, wave, wave_low):
            whole = xp.where(gamma == 0.0, 1.0, gamma)
            return rounded(xp, *pair_quot(xp, *one_minus(xp,
                *wide_prod(xp, envelope, *pair_sum(xp, even, even_low,
                *wide_prod(xp, half, wave, wave_low)))), whole, xp.full_like(envelope, 0.0)))

        return select(xp, near > 0.0, lambda risen: risen, (risen,), no,
            (envelope, even, even_low, gamma, half, wave, wave_low))

    return select(xp, reach < 0.5625, yes, (decayed, decayed_low, half, w), no,
        (envelope, even, even_low, gamma, half, near, risen, wave, wave_low))


def slow_fade(xp, reach, half):
    """exp(-half) of a device with slow poles, and what it misses"""
    def yes(half):
        fall, fall_low, _, _ = brief_fading(xp, 0.5*half, xp.full_like(half, 0.0))
        return pair_square(xp, fall, fall_low)

    return select(xp, reach < 0.5625, yes, (half,), lambda reach: (0.0, 0.0), (reach,))


def cos_series(xp, w):
    """(cosh(sqrt(w)) - 1 - w/2)/w^2"""
    begin = 14 if w.dtype == xp.float32 else 22
    square = (w*w)
    one, two = 0.0, 0.0
    for number in INVERSE_FACTORIAL[begin:4:-2]:
        both = number + square*two
        one, two = both, one
    return one*w + square*two + 0.041666666666666664


def sin_series(xp, w):
    """(sinh(sqrt(w))/sqrt(w) - 1)/w"""
    begin = 13 if w.dtype == xp.float32 else 21
    square = (w*w)
    one, two = 0.0, 0.0
    for number in INVERSE_FACTORIAL[begin:3:-2]:
        both = number + square*two
        one, two = both, one
    return one*w + square*two + 0.16666666666666666


def waving_pair(xp, square, square_low, angle):
    """cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle"""
    def yes(square, square_low):
        total, total_low = fast_two_sum(xp, 1.0, 0.5*square)
        total, total_low2 = fast_two_sum(xp, total, (square*square)*cos_series(xp, square))
        both = total_low + total_low2
        total3, total_low2 = one_plus(xp, square*sin_series(xp, square), 0.16666666666666666*
            square_low)
        return total, both + 0.5*square_low, total3, total_low2

    def no(angle, square, square_low):
        angle_low = root_miss(xp, square, square_low, angle)
        sine = xp.sin(angle)
        cosine = xp.cos(angle)
        quot, quot_low = pair_quot(xp, sine, angle_low*cosine, angle, angle_low)
        return cosine, -angle_low*sine, quot, quot_low

    return select(xp, square > -1.5, yes, (square, square_low), no, (angle, square, square_low))


def whole_turns(xp, half, square, square_low, root, stiff):
    """whether the device has nearly swung whole turns; n1, n0 and n1 + n0 there"""
    number, number2, number3, number4, number5, number6 = (
        (6.2831854820251465, 39.478416442871094, 1.1614863524300745e-06, -1.1704736640094811e-14,
        -1.7484555314695172e-07, 4096.0) if half.dtype == xp.float32 else (6.283185307179586,
        39.47841760435743, 2.5061182034958845e-15, 1.4920070805839235e-31,
        2.4492935982947064e-16, 67108864.0)
    )
    def yes(half, root, square, square_low, stiff):
        count = xp.floor(0.5*root/3.141592653589793 + 0.5)
        prod3, prod_low3 = two_prod(xp, count, xp.full_like(count, number))
        diff6, diff_low6 = two_diff(xp, root, -prod3)
        missed = root_miss(xp, square, square_low, root)
        turns = (count*count)
        prod3, prod_low = two_prod(xp, turns, xp.full_like(turns, number2))
        prod2, prod_low2 = two_prod(xp, turns, xp.full_like(turns, number3))
        diff, diff_low = two_diff(xp, -square, prod3)
        diff, diff_low2 = two_diff(xp, diff, prod_low)
        diff, diff_low3 = two_diff(xp, diff, prod2)
        diff, diff_low4 = two_diff(xp, diff, square_low)
        turned_low = number4*turns
        low = diff_low + diff_low2 + diff_low3 + diff_low4 - prod_low2 - turned_low
        back = number5*count
        whole = xp.where(diff6 == 0.0, 1.0, diff6)
        quot, quot_low = pair_quot(xp, *two_diff(xp, diff, -low), whole, back + diff_low6 +
            missed + prod_low3)
        far = (quot*quot)

        def yes(half, missed, quot, quot_low, root, stiff):
            fall, fall_low, mean, mean_low = brief_fading(xp, half, xp.full_like(half, 0.0))
            squared, squared_low = pair_square(xp, quot, quot_low)
            less, less_low = one_minus(xp, squared*sin_series(xp, -squared), 0.0)
            prod4, prod_low4 = wide_prod(xp, quot, less, less_low)
            bent = (squared*squared)*cos_series(xp, -squared)
            total, total_low = fast_two_sum(xp, 0.5*squared, -bent)
            lift_low = 0.5*less*squared_low + total_low
            prod5, prod_low5 = pair_prod(xp, fall, fall_low, total, lift_low)
            quot2, quot_low2 = pair_quot(xp, prod4, prod_low4 + quot_low*(1.0 - total), root,
                missed)
            diff8, diff_low8 = pair_diff(xp, total, lift_low,
                *wide_prod(xp, half, *pair_diff(xp, mean, mean_low, quot2, quot_low2)))
            whole = xp.where(stiff == 0.0, 1.0, stiff)
            return (
                1.0, rounded(xp, *pair_quot(xp, *pair_sum(xp,
                *wide_prod(xp, half, *pair_diff(xp, mean, mean_low,
                *pair_prod(xp, fall, fall_low, quot2, quot_low2))), prod5, prod_low5), whole,
                xp.full_like(fall, 0.0))), rounded(xp,
                *pair_quot(xp, *pair_prod(xp, fall, fall_low,
                *two_diff(xp, diff8, -diff_low8)), whole, xp.full_like(diff8, 0.0))),
                rounded(xp, *pair_quot(xp, *pair_sum(xp,
                *pair_square(xp, *fast_two_sum(xp, *one_minus(xp, fall, fall_low))), 2.0*prod5,
                2.0*prod_low5), whole, xp.full_like(fall, 0.0)))
            )

        return select(xp, (count > 0.0) & (far < 1.5), yes,
            (half, missed, quot, quot_low, root, stiff), lambda count: (0.0, 0.0, 0.0, 0.0),
            (count,))

    return select(xp, (half < 0.75) & (root > 3.0) & (root < number6), yes,
        (half, root, square, square_low, stiff), lambda half: (0.0, 0.0, 0.0, 0.0), (half,))


def swinging_device(xp, gamma, half, w, w_low, root):
    """exp(-half), cos(root), sin(root)/root and nearby turns of an oscillating device"""
    even, even_low, odd, odd_low = waving_pair(xp, w, w_low, root)
    near, risen, sunk, moved = whole_turns(xp, half, w, w_low, root, gamma)
    return xp.exp(-half), even, even_low, odd, odd_low, near, risen, sunk, moved


def device_n0_n1_trace(xp, gamma, delta):
    """n0, n1 and trace of the device"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)
    decayed, decayed_low = slow_fade(xp, reach, half)

    def yes(decayed, decayed_low, gamma, half, reach, root, w, w_low):
        envelope, even, even_low, wave, wave_low, near, risen, sunk, _ = swinging_device(xp, gamma,
            half, w, w_low, root)
        rounded_of = rounded(xp, *wide_prod(xp, envelope, even, even_low))
        return (
            plant_n0_swing(xp, reach, half, envelope, even, even_low, wave, wave_low, near, sunk,
            decayed, decayed_low, gamma), plant_n1_swing(xp, reach, half, w, envelope, even,
            even_low, wave, wave_low, near, risen, decayed, decayed_low, gamma), 2.0*rounded_of
        )

    def no(decayed, decayed_low, delta, gamma, half, reach, root, w, w_low):
        p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = creeping_device(
            xp, gamma, half, w, w_low, root)
        return (
            plant_n0_creep(xp, reach, p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low,
            far, far_low, decayed, decayed_low, gamma, delta),
            plant_n1_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far,
            far_low, decayed, decayed_low), rounded(xp,
            *pair_prod(xp, slow, slow_low, *one_plus(xp, ratio, ratio_low)))
        )

    return select(xp, w < 0.0, yes, (decayed, decayed_low, gamma, half, reach, root, w, w_low), no,
        (decayed, decayed_low, delta, gamma, half, reach, root, w, w_low))


def numerator_at_one_series(xp, h, w):
    """divided difference of cosh(sqrt) at h^2 and w, less 1/2"""
    begin, begin2 = (20, 8) if h.dtype == xp.float32 else (28, 12)
    y = (h*h)

    def add(total, inner, number, w, y):
        own = inner*w + number
        next_total = own + total*y
        return next_total, own

    total, inner = series(xp, add, 2, (h < 0.0625) & (xp.abs(w) < 0.00390625), begin, begin2, 4, 2,
        (w, y))
    return inner*w + total*y


def numerator_at_one_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low, ratio,
    ratio_low):
    """n1 + n0 of an overdamped device"""
    def yes(half, w):
        return 2.0*scaled_sum(xp, xp.exp(-half), 0.0, numerator_at_one_series(xp, half, w), 0.5)

    def no(mean, mean_low, p, p_low, ratio, ratio_low, slow, slow_low):
        return rounded(xp, *pair_quot(xp, *pair_prod(xp, mean, mean_low,
            *one_minus(xp, *pair_prod(xp, slow, slow_low, ratio, ratio_low))), p, p_low))

    return select(xp, reach < 1.0, yes, (half, w), no,
        (mean, mean_low, p, p_low, ratio, ratio_low, slow, slow_low))


def half_squares(xp, half, envelope, wave, back):
    """(1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses"""
    grown = -0.5*xp.expm1(-half)
    return pair_sum(xp, *wide_prod(xp, envelope, *pair_square(xp, *two_diff(xp, wave, back))),
        (grown*grown), 0.0)


def numerator_at_one_swing(xp, reach, half, w, w_low, root, envelope, near, moved, gamma):
    """n1 + n0 of an oscillating device"""
    def yes(envelope, half, w):
        return 2.0*scaled_sum(xp, envelope, 0.0, numerator_at_one_series(xp, half, w), 0.5)

    def no(envelope, gamma, half, moved, near, root, w, w_low):
        def no(envelope, gamma, half, root, w, w_low):
            angle = 0.5*root
            back = -0.5*root_miss(xp, w, w_low, root)*xp.cos(angle)
            whole = xp.where(gamma == 0.0, 1.0, gamma)
            return 4.0*rounded(xp, *pair_quot(xp,
                *half_squares(xp, half, envelope, xp.sin(angle), back), whole,
                xp.full_like(angle, 0.0)))

        return select(xp, near > 0.0, lambda moved: moved, (moved,), no,
            (envelope, gamma, half, root, w, w_low))

    return select(xp, reach < 1.0, yes, (envelope, half, w), no,
        (envelope, gamma, half, moved, near, root, w, w_low))


def device_together_trace(xp, gamma, delta):
    """together and trace of the device"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)

    def yes(gamma, half, reach, root, w, w_low):
        envelope, even, even_low, _, _, near, _, _, moved = swinging_device(xp, gamma, half, w,
            w_low, root)
        rounded_of = rounded(xp, *wide_prod(xp, envelope, even, even_low))
        return numerator_at_one_swing(xp, reach, half, w, w_low, root, envelope, near, moved,
            gamma), 2.0*rounded_of

    def no(gamma, half, reach, root, w, w_low):
        p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, _, _ = creeping_device(xp,
            gamma, half, w, w_low, root)
        return numerator_at_one_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low,
            ratio, ratio_low), rounded(xp, *pair_prod(xp, slow, slow_low,
            *one_plus(xp, ratio, ratio_low)))

    return select(xp, w < 0.0, yes, (gamma, half, reach, root, w, w_low), no)


def plant_n0(xp, gamma, delta):
    """n0, the same device with its time reversed, times exp(-delta)"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)
    decayed, decayed_low = slow_fade(xp, reach, half)

    def no(decayed, decayed_low, delta, gamma, half, reach, root, w, w_low):
        def yes(decayed, decayed_low, gamma, half, reach, root, w, w_low):
            envelope, even, even_low, wave, wave_low, near, _, sunk, _ = swinging_device(xp, gamma,
                half, w, w_low, root)
            return plant_n0_swing(xp, reach, half, envelope, even, even_low, wave, wave_low, near,
                sunk, decayed, decayed_low, gamma)

        def no(decayed, decayed_low, delta, gamma, half, reach, root, w, w_low):
            p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = (
                creeping_device(xp, gamma, half, w, w_low, root)
            )
            return plant_n0_creep(xp, reach, p, p_low, slow, slow_low, mean, mean_low, ratio,
                ratio_low, far, far_low, decayed, decayed_low, gamma, delta)

        return select(xp, w < 0.0, yes, (decayed, decayed_low, gamma, half, reach, root, w, w_low),
            no, (decayed, decayed_low, delta, gamma, half, reach, root, w, w_low))

    return select(xp, reach < 0.5625, lambda *v: plant_n0_near(xp, *v),
        (decayed, decayed_low, gamma, delta), no,
        (decayed, decayed_low, delta, gamma, half, reach, root, w, w_low))


def plant_n1(xp, gamma, delta):
    """n1, how far a unit force moves the device in a period"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)
    decayed, decayed_low = slow_fade(xp, reach, half)

    def yes(decayed, decayed_low, half, w):
        return scaled_sum(xp, decayed, decayed_low, plant_n1_series(xp, half, w), 0.5)

    def no(decayed, decayed_low, gamma, half, reach, root, w, w_low):
        def yes(decayed, decayed_low, gamma, half, reach, root, w, w_low):
            envelope, even, even_low, wave, wave_low, near, risen, _, _ = swinging_device(xp,
                gamma, half, w, w_low, root)
            return plant_n1_swing(xp, reach, half, w, envelope, even, even_low, wave, wave_low,
                near, risen, decayed, decayed_low, gamma)

        def no(decayed, decayed_low, gamma, half, reach, root, w, w_low):
            p, p_low, slow, slow_low, mean, mean_low, _, _, far, far_low = creeping_device(xp,
                gamma, half, w, w_low, root)
            return plant_n1_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low,
                far, far_low, decayed, decayed_low)

        return select(xp, w < 0.0, yes, (decayed, decayed_low, gamma, half, reach, root, w, w_low),
            no)

    return select(xp, reach < 0.5625, yes, (decayed, decayed_low, half, w), no,
        (decayed, decayed_low, gamma, half, reach, root, w, w_low))


def decay(xp, x):
    """(1 - exp(-x))/x"""
    return select(xp, x == 0.0, lambda x: 1.0, (x,), lambda x: -xp.expm1(-x)/x)


def denominator_at_minus_one_creep(xp, slow, slow_low, ratio, ratio_low):
    """1 + a + e of an overdamped device"""
    return rounded(xp, *pair_prod(xp, *one_plus(xp, slow, slow_low),
        *one_plus(xp, *pair_prod(xp, slow, slow_low, ratio, ratio_low))))


def denominator_at_minus_one_swing(xp, half, w, w_low, root, envelope, even, even_low):
    """1 + a + e of an oscillating device"""
    prod, prod_low = wide_prod(xp, 2.0*envelope, even, even_low)

    def yes(half, prod, prod_low):
        return rounded(xp, *pair_sum(xp, *one_plus(xp, xp.exp(-2.0*half), 0.0), prod, prod_low))

    def no(envelope, half, root, w, w_low):
        angle = 0.5*root
        return 4.0*rounded(xp, *half_squares(xp, half, envelope, xp.cos(angle), 0.5*
            root_miss(xp, w, w_low, root)*xp.sin(angle)))

    return select(xp, prod > 0.0, yes, (half, prod, prod_low), no, (envelope, half, root, w, w_low))


def numerator_gap_series(xp, h, w):
    """divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6"""
    begin, begin2, number2 = (19, 9, -4.967053879312289e-09) if h.dtype == xp.float32 else (27, 13,
        9.25185853854297e-18)
    y = (h*h)

    def add(total, inner, number, w, y):
        own = inner*w + number
        next_total = own + total*y
        return next_total, own

    total, inner = series(xp, add, 2, (h < 0.0625) & (xp.abs(w) < 0.00390625), begin, begin2, 5, 2,
        (w, y))
    return inner*w + total*y + number2


def numerator_gap_creep(xp, reach, half, w, p, slow, mean, mean_low, ratio, far, far_low, delta):
    """(n1 - n0)/delta of an overdamped device"""
    def yes(half, w):
        return scaled_sum(xp, xp.exp(-half), 0.0, numerator_gap_series(xp, half, w),
            0.16666666666666666)

    def no(delta, far, far_low, mean, mean_low, p, ratio, slow):
        diff, diff_low = pair_diff(xp, mean, mean_low, *wide_prod(xp, 2.0*slow, far, far_low))
        prod, prod_low = wide_prod(xp, ratio*slow, mean, mean_low)
        top = diff + prod
        low = diff_low + prod_low
        whole = xp.where(delta*p == 0.0, 1.0, delta*p)
        return (low + top)/whole

    return select(xp, reach < 1.0, yes, (half, w), no,
        (delta, far, far_low, mean, mean_low, p, ratio, slow))


def numerator_gap_swing(xp, reach, half, w, envelope, wave, wave_low, gamma, delta):
    """(n1 - n0)/delta of an oscillating device"""
    def yes(envelope, half, w):
        return scaled_sum(xp, envelope, 0.0, numerator_gap_series(xp, half, w), 0.16666666666666666)

    def no(delta, envelope, gamma, wave, wave_low):
        whole = xp.where(gamma == 0.0, 1.0, gamma)
        return rounded(xp, *pair_quot(xp, *pair_diff(xp, decay(xp, delta), 0.0,
            *wide_prod(xp, envelope, wave, wave_low)), whole, xp.full_like(delta, 0.0)))

    return select(xp, reach < 1.0, yes, (envelope, half, w), no,
        (delta, envelope, gamma, wave, wave_low))


def device_at_minus_one_kick_together_n_gap_n0_n1(xp, gamma, delta):
    """at_minus_one, kick, together, n_gap, n0 and n1 of the device"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)

    def yes(delta, gamma, half, reach, root, w, w_low):
        envelope, even, even_low, wave, wave_low, near, risen, sunk, moved = swinging_device(xp,
            gamma, half, w, w_low, root)
        decayed, decayed_low = slow_fade(xp, reach, half)
        return (
            denominator_at_minus_one_swing(xp, half, w, w_low, root, envelope, even, even_low),
            rounded(xp, *wide_prod(xp, envelope, wave, wave_low)),
            numerator_at_one_swing(xp, reach, half, w, w_low, root, envelope, near, moved,
            gamma), numerator_gap_swing(xp, reach, half, w, envelope, wave, wave_low, gamma,
            delta), plant_n0_swing(xp, reach, half, envelope, even, even_low, wave, wave_low,
            near, sunk, decayed, decayed_low, gamma),
            plant_n1_swing(xp, reach, half, w, envelope, even, even_low, wave, wave_low, near,
            risen, decayed, decayed_low, gamma)
        )

    def no(delta, gamma, half, reach, root, w, w_low):
        p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = creeping_device(
            xp, gamma, half, w, w_low, root)
        decayed, decayed_low = slow_fade(xp, reach, half)
        return (
            denominator_at_minus_one_creep(xp, slow, slow_low, ratio, ratio_low),
            rounded(xp, *pair_prod(xp, slow, slow_low, far, far_low)),
            numerator_at_one_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean,
            mean_low, ratio, ratio_low), numerator_gap_creep(xp, reach, half, w, p, slow, mean,
            mean_low, ratio, far, far_low, delta),
            plant_n0_creep(xp, reach, p, p_low, slow, slow_low, mean, mean_low, ratio,
            ratio_low, far, far_low, decayed, decayed_low, gamma, delta),
            plant_n1_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far,
            far_low, decayed, decayed_low)
        )

    return select(xp, w < 0.0, yes, (delta, gamma, half, reach, root, w, w_low), no)


def cubic_root(xp, k0, k1, k2, k3, low, high, rise):
    """the root of a cubic on a piece where it bends one way"""
    number, begin3, begin4 = (8.271806125530277e-25, 5, 48) if k0.dtype == xp.float32 else (
        1.499696813895631e-241, 8, 98)
    three = 3.0*k3
    two = 2.0*k2
    convex = xp.where(three*(high + low) + two > 0.0, xp.full_like(high, 1.0), -1.0)
    down = xp.where(convex*rise > 0.0, xp.full_like(convex, 1.0), -1.0)
    case1 = down > 0.0
    begin = xp.where((convex*k0 > 0.0) & (high > 0.0) & (low < 0.0), 0.0,
        xp.where(case1, high, low))
    end = xp.where((convex*k0 <= 0.0) & (high > 0.0) & (low < 0.0), 0.0, xp.where(case1, low, high))
    part = 0.0625*begin
    above = xp.where((convex*(k0 + part*(k1 + part*(k2 + k3*part))) > 0.0) &
        (xp.abs(end) < xp.abs(part)), xp.full_like(convex, 1.0), 0.0)

    def over(begin2, end2, convex, k0, k1, k2, k3):
        return xp.abs(begin2) <= 16.0*xp.where(number > xp.abs(end2), number, xp.abs(end2))

    def step(begin2, end2, convex, k0, k1, k2, k3):
        more = xp.where(number > xp.abs(end2), number, xp.abs(end2))
        size = square_root(xp, more)*square_root(xp, xp.abs(begin2))
        at = xp.where(begin2 < 0.0, -size, size)
        outside = xp.where(convex*(at*(at*(at*k3 + k2) + k1) + k0) > 0.0, xp.full_like(at, 1.0),
            0.0)
        case1 = outside > 0.0
        next_begin = xp.where(case1, at, begin2)
        next_end = xp.where(case1, end2, at)
        return next_begin, next_end

    begin2, end2 = repeat(xp, begin3, over, step,
        (xp.where(above > 0.0, part, begin),
        xp.where((above <= 0.0) & (xp.abs(end) < xp.abs(part)), part, end)),
        (convex, k0, k1, k2, k3))

    def over(y, moves, down, high, k0, k1, k2, k3, low, three, two):
        return moves == 0.0

    def step(y, moves, down, high, k0, k1, k2, k3, low, three, two):
        steep = k1 + y*(three*y + two)
        case1 = steep == 0.0
        some = xp.where(case1, 1.0, steep)
        move = xp.where(case1, 0.0, (k0 + y*(k1 + y*(k2 + k3*y)))/some)
        new = xp.where(high < y - move, high, y - move)
        new = xp.where(low > new, low, new)
        moves = xp.where(down*(y - new) > 0.0, xp.full_like(down, 1.0), 0.0)
        next_y = xp.where(moves > 0.0, new, y)
        return next_y, moves

    y, moves = repeat(xp, begin4, over, step, (begin2, 1.0),
        (down, high, k0, k1, k2, k3, low, three, two))
    return y


def crossing_part(xp, x, u, x_off, u_off, steep, low, high):
    """of x + j u: half turns and the rest of the angle, the size and its inverse, how far both
    may be off, and how they change with y
    """
    close = 2.384185791015625e-07 if x.dtype == xp.float32 else 4.440892098500626e-16
    most_ = xp.where(xp.abs(u) > xp.abs(x), xp.abs(u), xp.abs(x))
    least = xp.where(xp.abs(u) < xp.abs(x), xp.abs(u), xp.abs(x))
    whole = xp.where(most_ == 0.0, 1.0, most_)
    ratio = least/whole
    longer = square_root(xp, ratio*ratio + 1.0)
    size = longer*most_
    whole = xp.where(size == 0.0, 1.0, size)
    per = 1.0/whole
    real = per*x
    up = per*u
    along = per*x_off
    across = per*u_off
    away = across + along
    one = xp.abs(real)
    two = xp.abs(up)
    blur = (2.0*away + 1.0)*(across*one + along*two)
    case1 = x < 0.0
    rest = xp.atan2(xp.where(case1, -u, u), xp.abs(x))
    falls = per*steep
    tilt = 0.5*low - 0.5*high
    square = (up*up)
    fast = square*(high + low) + 2.0*xp.abs(falls)
    return (
        xp.where(case1, xp.where(u < 0.0, xp.full_like(u, -1.0), 1.0), 0.0), rest, size, per,
        xp.where(size > 0.0, across*two + along*one + away*away, 1.0),
        xp.where(away < 0.25, blur + close*xp.abs(rest), 4.0), 2.0*falls*real + 2.0*square*
        tilt, fast, 2.0*(falls*falls) + fast*fast + 2.0*high*low*square, up*
        (real*tilt - falls), two*(one*xp.abs(tilt) + xp.abs(falls))
    )


def phase_turns(xp, y, rest, off, loose, free, alpha, slope, far, d, n1, loss, together, apart,
    apart_off, n1_off, a_off):
    """the nearest whole number of turns in the phase at a crossing, NaN where that is not
    certain
    """
    close, number, number2 = (2.384185791015625e-07, 7.152557373046875e-07,
        4.76837158203125e-07) if y.dtype == xp.float32 else (4.440892098500626e-16,
        1.3322676295501878e-15, 8.881784197001252e-16)
    at = xp.where(0.0 > y, 0.0, y)
    still = xp.where(0.0 > rest, 0.0, rest)
    sine = 2.0*square_root(xp, at*still)
    total = 2.0 - loss
    plain = loose + close
    made = loose + number
    edge = xp.where(at < still, at, still)
    whole = xp.where(at == 0.0, 1.0, at)
    low = edge/whole
    whole = xp.where(still == 0.0, 1.0, still)
    high = edge/whole
    halves2, turned2, size2, _, away2, blur2, rise2, fast2, bend2, turn2, spread2 = crossing_part(
        xp, still*together - apart*at, n1*sine, apart_off*at + made*
        (at*xp.abs(apart) + still*together), sine*(made*xp.abs(n1) + n1_off), edge*
        (-apart - together), low, high)
    halves3, turned3, size3, _, away3, blur3, rise3, fast3, bend3, turn3, spread3 = crossing_part(
        xp, alpha*still - at*far, sine*slope, plain*(at*xp.abs(far) + still*xp.abs(alpha)), plain*
        sine*xp.abs(slope), edge*(-alpha - far), low, high)
    halves_, turned, _, per, away, blur, rise, fast, bend_, turn_, spread_ = crossing_part(xp, -2.0*
        off*total, loss*sine, 4.0*a_off + total*(2.0*free + number2*xp.abs(off)), loss*made*sine,
        -2.0*edge*total, low, high)
    ratio = per*size2
    gap_ = 1.0 - 0.25*ratio*size3
    rough = away + away2 + away3 + number
    distant = xp.abs(gap_)
    miss = 3.0*away + number2
    miss2 = 3.0*away2 + number2
    miss3 = 3.0*away3 + number2
    sure = xp.abs(rise2 - rise + rise3) - fast*miss - fast2*miss2 - fast3*miss3
    whole = xp.where(sure == 0.0, 1.0, sure)
    reach = 0.25*(9.0*distant + 9.0*rough)/whole
    bends = bend_ + bend2 + bend3
    case1 = at > 2.0
    half = xp.atan2(xp.where(case1, square_root(xp, still), square_root(xp, at)),
        xp.where(case1, square_root(xp, at), square_root(xp, still)))
    late = d + 2.0
    halves3 = halves2 - halves_ + halves3 - xp.where(case1, late, 0.0)
    around = late*xp.where(case1, -2.0*half, 2.0*half)
    share = 0.5*(turned2 - around - turned + turned3)/3.141592653589793
    even = xp.floor(0.5*halves3)
    left = 0.5*halves3 - even
    near = xp.abs(share - xp.floor(share + 0.5))
    distance = xp.where(left == 0.5, near, 0.5 - near)
    whole = xp.where(sine == 0.0, 1.0, sine)
    delayed = 2.0*edge*late/whole
    most_ = delayed + spread_ + spread2 + spread3
    blur_ = (
        blur + blur2 + blur3 + half*late*(loose + number2) + reach*
        (number2*delayed + miss*spread_ + miss2*spread2 + miss3*spread3 + 2.0*most_*reach*
        (fast + fast2 + fast3 + 2.0) + xp.abs(delayed + turn_ - turn2 - turn3))
    )
    good = xp.where((blur_ < 6.0*distance) & (reach < 0.25) & (sure > 0.0) &
        (sure > 8.0*bends*reach), xp.full_like(bends, 1.0), 0.0)
    return xp.where(good > 0.0, even + xp.where(left == 0.5, xp.floor(share) + 1.0,
        xp.floor(left + share + 0.5)), xp.nan)


def piece_turns(xp, k0, k1, k2, k3, low, high, at_low, at_high, zone, alpha, slope, far, d, n1,
    loss, together, apart, apart_off, n1_off, a_off, center, beyond):
    """what the crossing on a piece, if there is one, adds"""
    number, last, number2 = (9.5367431640625e-07, 1.1920928955078125e-07,
        4.76837158203125e-07) if k0.dtype == xp.float32 else (1.7763568394002505e-15,
        2.220446049250313e-16, 8.881784197001252e-16)
    def yes(a_off, alpha, apart, apart_off, at_high, at_low, beyond, center, d, far, high, k0, k1,
        k2, k3, loss, low, n1, n1_off, slope, together, zone):
        x = cubic_root(xp, k0, k1, k2, k3, low, high, at_high - at_low)
        case1 = zone == 1.0
        case2 = zone == 0.0
        y = xp.where(case2, x, xp.where(case1, center + x, 4.0 - x))
        rest = xp.where(case2, 4.0 - x, xp.where(case1, beyond - x, x))

        def yes(a_off, alpha, apart, apart_off, at_high, at_low, beyond, center, d, far, loss, n1,
            n1_off, rest, slope, together, x, y, zone):
            case1 = zone == 1.0
            case2 = zone == 0.0
            off = xp.where(case2, x - center, xp.where(case1, x, beyond - x))
            loose = xp.where(case1, xp.full_like(zone, number), last)
            free = xp.where(case1, 0.0, number2*xp.where(case2, center, beyond))
            found = phase_turns(xp, y, rest, off, loose, free, alpha, slope, far, d, n1, loss,
                together, apart, apart_off, n1_off, a_off)
            up = xp.where(at_high > at_low, xp.full_like(at_high, 1.0), -1.0)
            rises = xp.where(zone == 2.0, -up, up)
            return -2.0*found*rises

        return select(xp, (rest > 0.0) & (y > 0.0), yes,
            (a_off, alpha, apart, apart_off, at_high, at_low, beyond, center, d, far, loss, n1,
            n1_off, rest, slope, together, x, y, zone), lambda rest: xp.nan, (rest,))

    return select(xp, (((at_high >= 0.0) & (at_low < 0.0)) | ((at_high < 0.0) & (at_low >= 0.0))) &
        ((at_low != 0.0) | (low != 0.0)) & (high > low), yes,
        (a_off, alpha, apart, apart_off, at_high, at_low, beyond, center, d, far, high, k0, k1, k2,
        k3, loss, low, n1, n1_off, slope, together, zone), lambda at_high: 0.0, (at_high,))


def touches(xp, leads, y, rest, off, loose, free, alpha, slope, far, d, n1, loss, together, apart,
    apart_off, n1_off, a_off):
    """NaN where it is not certain that the device is stronger if leads is positive, and else
    the wall, else 0
    """
    close, number, number2 = (2.384185791015625e-07, 7.152557373046875e-07,
        4.76837158203125e-07) if leads.dtype == xp.float32 else (4.440892098500626e-16,
        1.3322676295501878e-15, 8.881784197001252e-16)
    at = xp.where(0.0 > y, 0.0, y)
    still = xp.where(0.0 > rest, 0.0, rest)
    sine = 2.0*square_root(xp, at*still)
    total = 2.0 - loss
    plain = loose + close
    _, _, size3, _, away3, _, _, _, _, _, _ = crossing_part(xp, alpha*still - at*far, sine*slope,
        plain*(at*xp.abs(far) + still*xp.abs(alpha)), plain*sine*xp.abs(slope),
        xp.full_like(alpha, 0.0), xp.full_like(alpha, 0.0), xp.full_like(alpha, 0.0))
    made = loose + number
    _, _, size2, _, away2, _, _, _, _, _, _ = crossing_part(xp, still*together - apart*at, n1*sine,
        apart_off*at + made*(at*xp.abs(apart) + still*together), sine*(made*xp.abs(n1) + n1_off),
        xp.full_like(apart, 0.0), xp.full_like(apart, 0.0), xp.full_like(apart, 0.0))
    _, _, _, per, away, _, _, _, _, _, _ = crossing_part(xp, -2.0*off*total, loss*sine, 4.0*a_off +
        total*(2.0*free + number2*xp.abs(off)), loss*made*sine, xp.full_like(a_off, 0.0),
        xp.full_like(a_off, 0.0), xp.full_like(a_off, 0.0))
    ratio = per*size2
    gap_ = 1.0 - 0.25*ratio*size3
    rough = away + away2 + away3 + number
    signed = xp.where(leads > 0.0, gap_, -gap_)
    good = xp.where(signed > 2.0*rough, xp.full_like(rough, 1.0), 0.0)
    return xp.where((good < 1.0) & (rest > 0.0) & (y > 0.0), xp.full_like(good, xp.nan), 0.0)


def zone_touches(xp, leads, x, zone, alpha, slope, far, d, n1, loss, together, apart, apart_off,
    n1_off, a_off, center, beyond):
    """NaN where the wall may be as strong as the device at an extremum of both, else 0"""
    number, last, number2 = (9.5367431640625e-07, 1.1920928955078125e-07,
        4.76837158203125e-07) if leads.dtype == xp.float32 else (1.7763568394002505e-15,
        2.220446049250313e-16, 8.881784197001252e-16)
    case1 = zone == 1.0
    case2 = zone == 0.0
    y = xp.where(case2, x, xp.where(case1, center + x, 4.0 - x))
    rest = xp.where(case2, 4.0 - x, xp.where(case1, beyond - x, x))
    off = xp.where(case2, x - center, xp.where(case1, x, beyond - x))
    loose = xp.where(case1, xp.full_like(zone, number), last)
    free = xp.where(case1, 0.0, number2*xp.where(case2, center, beyond))
    return touches(xp, leads, y, rest, off, loose, free, alpha, slope, far, d, n1, loss, together,
        apart, apart_off, n1_off, a_off)


def zone_turns(xp, k0, k1, k2, k3, low, high, at_low, at_high, zone, alpha, slope, far, d, n1,
    loss, together, apart, apart_off, n1_off, a_off, center, beyond):
    """what the crossings between two points add to the count"""
    disc = k2*k2 - 3.0*k1*k3
    root = square_root(xp, xp.where(0.0 > disc, 0.0, disc))
    q = -k2 - xp.where(k2 < 0.0, -root, root)
    some = xp.where(xp.abs(k2) < 24.0*xp.abs(k3), 3.0*k3, 1.0)
    at = -k2/some
    cut = xp.where((at > low) & (at < high) & (xp.abs(k2) < 24.0*xp.abs(k3)), at, low)
    some = xp.where(xp.abs(q) < 24.0*xp.abs(k3), 3.0*k3, 1.0)
    at = q/some
    cut2 = xp.where((at > low) & (at < high) & (xp.abs(q) < 24.0*xp.abs(k3)), at, low)
    some = xp.where(xp.abs(k1) < 8.0*xp.abs(q), q, 1.0)
    at = k1/some
    cut3 = xp.where((at > low) & (at < high) & (xp.abs(k1) < 8.0*xp.abs(q)), at, low)
    less = xp.where(cut2 < cut3, cut2, cut3)
    more = xp.where(cut2 > cut3, cut2, cut3)
    first = xp.where(cut < less, cut, less)
    middle = xp.where(cut > less, cut, less)
    last = xp.where(middle > more, middle, more)
    middle = xp.where(middle < more, middle, more)
    p = first*(first*(first*k3 + k2) + k1) + k0
    p2 = k0 + middle*(k1 + middle*(k2 + k3*middle))
    p3 = k0 + last*(k1 + last*(k2 + k3*last))
    value_ = cut3*(cut3*(cut3*k3 + k2) + k1) + k0

    def yes(a_off, alpha, apart, apart_off, beyond, center, cut2, d, far, k0, k1, k2, k3, loss, n1,
        n1_off, slope, together, zone):
        value_ = cut2*(cut2*(cut2*k3 + k2) + k1) + k0
        return zone_touches(xp, value_, cut2, zone, alpha, slope, far, d, n1, loss, together,
            apart, apart_off, n1_off, a_off, center, beyond)

    found = select(xp, cut2 > low, yes, (a_off, alpha, apart, apart_off, beyond, center, cut2, d,
        far, k0, k1, k2, k3, loss, n1, n1_off, slope, together, zone), lambda cut2: 0.0, (cut2,))
    found2 = found + xp.where(cut3 > low, zone_touches(xp, value_, cut3, zone, alpha, slope, far,
        d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond), 0.0)
    found2 = found2 + piece_turns(xp, k0, k1, k2, k3, low, first, at_low, p, zone, alpha, slope,
        far, d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
    found2 = found2 + piece_turns(xp, k0, k1, k2, k3, first, middle, p, p2, zone, alpha, slope,
        far, d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
    found2 = found2 + piece_turns(xp, k0, k1, k2, k3, middle, last, p2, p3, zone, alpha, slope,
        far, d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)
    return found2 + piece_turns(xp, k0, k1, k2, k3, last, high, p3, at_high, zone, alpha, slope,
        far, d, n1, loss, together, apart, apart_off, n1_off, a_off, center, beyond)


def fractional_roots(xp, alpha, beta, d, m2, m0, gamma, at_minus_one, loss, together, apart,
    across, delta):
    """roots outside the unit circle with a fractional delay, -1 if that is not certain"""
    (
        number, number2, number3, number4, number5, number6, number7, number8, number9, number10,
            number11
    ) = (4.76837158203125e-07, 3.814697265625e-06, 7.62939453125e-06, 4.547473508864641e-13,
        9.5367431640625e-07, 1.9073486328125e-06, 9.5367431640625e-06, 9.094947017729282e-13,
        0.001220703125, 6.866455078125e-05, 1.52587890625e-05) if alpha.dtype == xp.float32 else (
        8.881784197001252e-16, 7.105427357601002e-15, 1.4210854715202004e-14,
        1.5777218104420236e-30, 1.7763568394002505e-15, 3.552713678800501e-15,
        1.7763568394002505e-14, 3.8725919148493183e-121, 2.2737367544323206e-12,
        1.2789769243681803e-13, 2.842170943040401e-14)
    def no(across, alpha, apart, at_minus_one, beta, d, delta, gamma, loss, m0, m2, together):
        strength = xp.abs(alpha) + xp.abs(beta)
        stiffest = xp.where(gamma > xp.abs(alpha), gamma, xp.abs(alpha))
        slope = alpha + beta
        wall_far = alpha + 2.0*beta
        force = beta*slope
        lost = (loss*loss)
        square = m0*m2
        size = (across*across)
        at_one = gamma*together
        turn_off = xp.where(gamma > 10.0, number/
            (xp.where(1.0 > delta, 1.0, delta)*square_root(xp, xp.where(1.0 > gamma, 1.0, gamma))),
            0.0)
        size2 = m2 + together + xp.abs(m0)
        near = square_root(xp, xp.where(1.0 < at_minus_one, 1.0, at_minus_one))
        near2 = square_root(xp, xp.where(1.0 < at_one, 1.0, at_one))
        whole = xp.where(gamma == 0.0, 1.0, gamma)
        apart_off = near*(number2*size2 + 2.0*turn_off)
        n1_off = near2*turn_off + number3*xp.where((gamma > 10.0) & (loss < 0.5), 2.0*near2/whole,
            0.125*size2)
        a_off = number4*square_root(xp, at_minus_one*gamma)
        ends = m2 + xp.abs(m0)
        apart_one = (gamma - alpha)*(alpha + gamma)
        even = (together*together)
        even2 = together*(m0 + m2)
        linear = size - even2
        push = (alpha*alpha)
        near2 = apart_one*even
        near = lost - at_one*(2.0 - loss) - force*(together*together) - linear*push
        near22 = 1.0 - force*linear - loss - push*square
        near3 = -force*square
        cross = size + xp.abs(even2)
        bent = cross*xp.abs(force) + push*xp.abs(square) + 1.0
        most_ = at_one*(2.0 - loss) + cross*push + lost + (together*together)*xp.abs(force)
        blurred = n1_off*(n1_off + 2.0*xp.abs(across))
        cross_off = blurred + together*turn_off
        pull = xp.abs(apart*wall_far)
        end_off = a_off + apart_off*xp.abs(wall_far) + number5*at_minus_one + number5*pull
        end_apart = xp.abs(at_minus_one - pull) - end_off
        end_least = end_apart*(at_minus_one + pull)
        cubed = ends*turn_off*xp.abs(force)
        room = (alpha*alpha)*cross_off + number6*most_
        product = 4.0*near2*near22
        outer = near*near3
        pushed_ = apart*wall_far
        even2 = apart*(m0 + m2)
        linear = size - even2
        push = (wall_far*wall_far)
        far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_)
        far1 = (apart*apart)*force - at_minus_one*(2.0 - loss) - linear*push + lost
        far2 = force*linear - loss - push*square + 1.0
        far3 = force*square
        cross = size + xp.abs(even2)
        bent2 = cross*xp.abs(force) + push*xp.abs(square) + 1.0
        most_ = (apart*apart)*xp.abs(force) + at_minus_one*(2.0 - loss) + cross*push + lost
        cross_off2 = apart_off*ends + blurred + turn_off*xp.abs(apart)
        room2 = (
            2.0*a_off + apart_off*(apart_off + 2.0*xp.abs(apart))*xp.abs(force) + cross_off2*
            (wall_far*wall_far) + number6*most_
        )
        product2 = 4.0*far0*far2
        outer2 = far1*far3
        base = number7*bent2 + 5.0*cross_off2*xp.abs(force) + 5.0*ends*turn_off*(wall_far*wall_far)
        base2 = 5.0*(alpha*alpha)*ends*turn_off + number7*bent + 5.0*cross_off*xp.abs(force)

        def no(a_off, across, alpha, apart, apart_off, at_minus_one, at_one, d, far0, far1, far2,
            far3, force, loss, lost, m0, m2, n1_off, near0, near1, near22, near3, size, slope,
            square, together, wall_far):
            middle = 2.0*at_one/(2.0 - loss)
            rest = 2.0*at_minus_one/(2.0 - loss)
            sine = 0.25*middle*rest
            tilt = 0.25*rest - 0.25*middle
            real = 0.25*rest*together - 0.25*apart*middle
            one = real*real + sine*size
            two = size*tilt - real*(m0 + m2)
            wave = 0.25*alpha*rest - 0.25*middle*wall_far
            wall = sine*(slope*slope) + wave*wave
            own0 = lost*sine - one*wall
            own1 = lost*tilt - force*one - two*wall
            own2 = 1.0 - force*two - loss - square*wall
            own3 = -force*square
            one = 0.5*middle
            two = 0.5*rest
            before = own0 - one*(own1 - one*(own2 - one*own3))
            after = own0 + two*(own1 + two*(own2 + own3*two))
            side = xp.where(slope >= 0.0, xp.full_like(slope, 1.0), -1.0)
            end = (
                xp.where(wall_far > 0.0, side, 0.0) - d +
                xp.where(apart > 0.0, xp.where(across >= 0.0, xp.full_like(across, 1.0), -1.0),
                0.0) - 3.0
            )
            total = (
                xp.where(((((((near22 == 0.0) & (near3 < 0.0)) | (near22 < 0.0)) &
                (near1 == 0.0)) | (near1 < 0.0)) & (near0 == 0.0)) | (near0 < 0.0),
                xp.where(alpha > 0.0, 0.0, side), 0.0) +
                zone_turns(xp, far0, far1, far2, far3, xp.full_like(a_off, 0.0), two, far0,
                after, xp.full_like(a_off, 2.0), alpha, slope, wall_far, d, across, loss,
                together, apart, apart_off, n1_off, a_off, middle, rest) +
                zone_turns(xp, near0, near1, near22, near3, xp.full_like(a_off, 0.0), one,
                near0, before, xp.full_like(a_off, 0.0), alpha, slope, wall_far, d, across,
                loss, together, apart, apart_off, n1_off, a_off, middle, rest) +
                zone_turns(xp, own0, own1, own2, own3, -one, two, before, after,
                xp.full_like(a_off, 1.0), alpha, slope, wall_far, d, across, loss, together,
                apart, apart_off, n1_off, a_off, middle, rest)
            )
            total = total - xp.where(((((((far2 == 0.0) & (far3 < 0.0)) | (far2 < 0.0)) &
                (far1 == 0.0)) | (far1 < 0.0)) & (far0 == 0.0)) | (far0 < 0.0), end, 0.0)
            return xp.where(total >= 0.0, total, -1.0)

        return select(xp, ((((stiffest > 0.0) & (stiffest < number8)) |
            (loss + strength < number8)) & (strength > 0.0)) |
            ((end_least <= number9*bent2 + 640.0*cross_off2*xp.abs(force) + 128.0*cubed + 640.0*
            ends*turn_off*(wall_far*wall_far) + 128.0*xp.abs(far3)) & (outer2 >= 0.0) &
            (outer2 <= base*base) & (xp.abs(far1) <= number10*bent2 + 36.0*cross_off2*
            xp.abs(force) + 36.0*ends*turn_off*(wall_far*wall_far)) &
            (xp.abs(far2) <= number11*bent2 + 8.0*cross_off2*xp.abs(force) + 8.0*ends*turn_off*
            (wall_far*wall_far))) | ((end_least <= 8.0*room2 + 128.0*xp.abs(far3)) &
            (product2 >= 0.0) & (product2 <= room2*room2) & (room2 >= xp.abs(far1))) |
            ((outer >= 0.0) & (outer <= base2*base2) &
            (xp.abs(near) <= 36.0*(alpha*alpha)*ends*turn_off + number10*bent + 36.0*cross_off*
            xp.abs(force)) & (xp.abs(near2) <= 640.0*(alpha*alpha)*ends*turn_off + number9*bent +
            640.0*cross_off*xp.abs(force) + 128.0*cubed + 128.0*xp.abs(near3)) &
            (xp.abs(near22) <= 8.0*(alpha*alpha)*ends*turn_off + number11*bent + 8.0*cross_off*
            xp.abs(force))) | ((product >= 0.0) & (product <= room*room) & (room >= xp.abs(near)) &
            (xp.abs(near2) <= 8.0*room + 128.0*xp.abs(near3))) | (end_apart <= 0.0),
            lambda alpha: -1.0, (alpha,), no, (a_off, across, alpha, apart, apart_off,
            at_minus_one, at_one, d, far0, far1, far2, far3, force, loss, lost, m0, m2, n1_off,
            near2, near, near22, near3, size, slope, square, together, wall_far))

    return select(xp, (alpha == 0.0) & (beta == 0.0), lambda alpha: 0.0, (alpha,), no,
        (across, alpha, apart, at_minus_one, beta, d, delta, gamma, loss, m0, m2, together))


def fractional_numerator_gap(xp, epsilon, x, x_low, y, y_low, first, last, turned):
    """m2 - m1 + m0 of the device with a fractional delay"""
    prod2, prod_low2 = pair_prod(xp, *wide_prod(xp, epsilon, *one_minus(xp, epsilon, 0.0)),
        *pair_prod(xp, x, x_low, y, y_low))
    return rounded(xp, *pair_sum(xp, *pair_diff(xp,
        *pair_diff(xp, first, 0.0, 2.0*prod2, 2.0*prod_low2), last, 0.0), turned, 0.0))


def half_turned_swing(xp, gamma, delta, part):
    """m2 - m1 + m0 of a lightly damped oscillating device"""
    half, w, w_low, root, _ = device_motion(xp, gamma, delta)
    angle = 0.5*root
    angle_low = 0.5*root_miss(xp, w, w_low, root)
    prod, prod_low = pair_prod(xp, angle, angle_low, *fast_two_sum(xp, 1.0, -part))
    prod2, prod_low2 = pair_prod(xp, angle, angle_low, part, xp.full_like(angle, 0.0))
    wave = xp.sin(angle)
    still = xp.cos(angle)
    sine = angle_low*still + wave
    cosine = still - angle_low*wave
    wave = xp.sin(prod)
    still = xp.cos(prod)
    sine2 = prod_low*still + wave
    cosine2 = still - prod_low*wave
    wave = xp.sin(prod2)
    still = xp.cos(prod2)
    sine3 = prod_low2*still + wave
    cosine3 = still - prod_low2*wave
    along = cosine2*cosine3 + sine2*sine3
    across = cosine3*sine2 - cosine2*sine3
    before = 0.5 - part
    step_ = xp.expm1(0.5*half)
    weak = 0.5*step_ + 0.5*step_/(step_ + 1.0)
    more = 0.5*(step_*step_)/(step_ + 1.0)
    strong = more + 1.0
    fallen = xp.expm1(-before*half)
    grown = fallen + 1.0
    whole = xp.where(root == 0.0, 1.0, root)
    ratio = half/whole
    lost = weak*weak - along*cosine*(fallen*strong + more)
    turned = grown*sine*weak*(across - along*ratio)
    kept = across*cosine*grown*ratio*strong
    total = lost - 2.0*cosine*sine2*sine3 - kept + turned
    whole = xp.where(gamma == 0.0, 1.0, gamma)
    return 4.0*total*xp.exp(-half)/whole


def half_turned(xp, found, gamma, delta, part):
    """m2 - m1 + m0 with a fractional delay"""
    half, w, _, root, _ = device_motion(xp, gamma, delta)
    return select(xp, (half < 0.25) & (root > 3.0) & (w < 0.0),
        lambda *v: half_turned_swing(xp, *v), (gamma, delta, part), lambda found: found, (found,))


def device_kick_kick_low_n_gap_n0_n1(xp, gamma, delta):
    """kick, kick_low, n_gap, n0 and n1 of the device"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)

    def yes(delta, gamma, half, reach, root, w, w_low):
        envelope, even, even_low, wave, wave_low, near, risen, sunk, _ = swinging_device(xp, gamma,
            half, w, w_low, root)
        total, total_low = fast_two_sum(xp, *wide_prod(xp, envelope, wave, wave_low))
        decayed, decayed_low = slow_fade(xp, reach, half)
        return (
            total, total_low, numerator_gap_swing(xp, reach, half, w, envelope, wave, wave_low,
            gamma, delta), plant_n0_swing(xp, reach, half, envelope, even, even_low, wave,
            wave_low, near, sunk, decayed, decayed_low, gamma),
            plant_n1_swing(xp, reach, half, w, envelope, even, even_low, wave, wave_low, near,
            risen, decayed, decayed_low, gamma)
        )

    def no(delta, gamma, half, reach, root, w, w_low):
        p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = creeping_device(
            xp, gamma, half, w, w_low, root)
        total, total_low = fast_two_sum(xp, *pair_prod(xp, slow, slow_low, far, far_low))
        decayed, decayed_low = slow_fade(xp, reach, half)
        return (
            total, total_low, numerator_gap_creep(xp, reach, half, w, p, slow, mean, mean_low,
            ratio, far, far_low, delta), plant_n0_creep(xp, reach, p, p_low, slow, slow_low,
            mean, mean_low, ratio, ratio_low, far, far_low, decayed, decayed_low, gamma,
            delta), plant_n1_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean,
            mean_low, far, far_low, decayed, decayed_low)
        )

    return select(xp, w < 0.0, yes, (delta, gamma, half, reach, root, w, w_low), no)


def late_device(xp, gamma, delta, part):
    """m2 - m1 + m0, m2, displacement by an impulse in the rest of the period, m0"""
    t0 = 1.0 - part
    t1 = (t0*t0)
    t2 = gamma*t1
    t3 = delta*t0
    kick_of, kick_low_of, n_gap, n0_2, n1 = device_kick_kick_low_n_gap_n0_n1(xp, t2, t3)
    t5 = (part*part)
    t6 = gamma*t5
    t7 = delta*part
    kick_of2, kick_low_of2, n_gap_2, n0, n1_2 = device_kick_kick_low_n_gap_n0_n1(xp, t6, t7)
    t9 = n0*t5
    return (
        half_turned(xp, fractional_numerator_gap(xp, part, kick_of, kick_low_of, kick_of2,
        kick_low_of2, delta*n_gap*(t0*t0*t0), delta*n_gap_2*(part*part*part), n0_2*t1*
        (kick_of2*t7 + n1_2*t6) + n1*n1_2*t2*t5 - t3*t9*decay(xp, t3)), gamma, delta, part), n1*
        t1, kick_of*t0, t9*xp.exp(-t3)
    )


def stable(xp, roots, alpha, beta, gamma, delta):
    """1 if the loop is stable, 0 if it is not, -1 if that is not certain"""
    number, number2 = (5.960464477539062e-07, 4194304.0) if roots.dtype == xp.float32 else (
        1.1102230246251565e-15, 2251799813685248.0)
    swing = square_root(xp, gamma)
    yes_ = xp.where((alpha > -gamma) & (roots == 0.0) &
        (~((alpha == 0.0) & (beta == 0.0) & (delta == 0.0) & (gamma > 0.0))) &
        (~((delta < number) & (gamma > 1.0) & (swing >= number2*xp.abs(xp.sin(swing))))),
        xp.full_like(alpha, 1.0), 0.0)
    return yes_ - xp.where(((alpha == 0.0) & (beta == 0.0) & (delta == 0.0) & (gamma > 0.0)) |
        (alpha <= -gamma) | (roots > 0.0) | (yes_ > 0.0), xp.full_like(alpha, 0.0), 1.0)


def nearest_point(xp, y, rest, off, center, beyond):
    """a point that is known about three, and whether it is on the circle"""
    number, last, number2 = (9.5367431640625e-07, 1.1920928955078125e-07,
        4.76837158203125e-07) if y.dtype == xp.float32 else (1.7763568394002505e-15,
        2.220446049250313e-16, 8.881784197001252e-16)
    case1 = rest > y
    edge = xp.where(case1, y, rest)
    inside_ = xp.where((beyond - off > 0.0) & (center + off > 0.0) & (edge > xp.abs(off)),
        xp.full_like(beyond, 1.0), 0.0)
    case2 = inside_ > 0.0
    return (
        xp.where(case2, center + off, xp.where(case1, y, 4.0 - rest)),
        xp.where(case2, beyond - off, xp.where(case1, 4.0 - y, rest)),
        xp.where(case2, off, xp.where(case1, y - center, beyond - rest)),
        xp.where(case2, xp.full_like(inside_, number), last),
        xp.where(case2, 0.0, number2*xp.where(case1, center, beyond)),
        xp.where((rest > 0.0) & (xp.where(rest < y, rest, y) < 4.0) & (y > 0.0),
        xp.full_like(rest, 1.0), 0.0)
    )


def bottom_touches(xp, leads, y, rest, off, center, beyond, alpha, slope, far, d, n1, loss,
    together, apart, apart_off, n1_off, a_off):
    """NaN where the wall may be as strong as the device at an extremum of both, else 0"""
    at, still, away, loose, free, there = nearest_point(xp, y, rest, off, center, beyond)
    return select(xp, there > 0.0, lambda *v: touches(xp, *v),
        (leads, at, still, away, loose, free, alpha, slope, far, d, n1, loss, together, apart,
        apart_off, n1_off, a_off), lambda there: 0.0, (there,))


def crossing_turns(xp, y, rest, off, center, beyond, alpha, slope, far, d, n1, loss, together,
    apart, apart_off, n1_off, a_off):
    """the turns at a crossing, if there is one"""
    at, still, away, loose, free, there = nearest_point(xp, y, rest, off, center, beyond)
    return select(xp, there > 0.0, lambda *v: phase_turns(xp, *v),
        (at, still, away, loose, free, alpha, slope, far, d, n1, loss, together, apart, apart_off,
        n1_off, a_off), lambda there: 0.0, (there,))


def quadratic_roots(xp, c, b, a, root):
    """(-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite"""
    q = -0.5*b - 0.5*xp.where(b >= 0.0, root, -root)
    case1 = a == 0.0
    lead_ = xp.where(case1, 1.0, a)
    case2 = q == 0.0
    own = xp.where(case2, 1.0, q)
    one = xp.where(case1, -1.0, q/lead_)
    two = xp.where(case2, -1.0, c/own)
    return select(xp, b >= 0.0, lambda one, two: (one, two), (one, two), lambda one,
        two: (two, one))


def whole_roots(xp, alpha, beta, d, n1, n0, gamma, at_minus_one, loss, together, apart):
    """roots outside the unit circle, -1 where that is not certain"""
    number, number2, number3, number4 = (4.547473508864641e-13, 9.5367431640625e-07,
        1.9073486328125e-06, 9.094947017729282e-13) if alpha.dtype == xp.float32 else (
        1.5777218104420236e-30, 1.7763568394002505e-15, 3.552713678800501e-15,
        3.8725919148493183e-121)
    def no(alpha, apart, at_minus_one, beta, d, gamma, loss, n0, n1, together):
        strength = xp.abs(alpha) + xp.abs(beta)
        stiffest = xp.where(gamma > xp.abs(alpha), gamma, xp.abs(alpha))
        e = 1.0 - loss
        slope = alpha + beta
        wall_far = alpha + 2.0*beta
        force = beta*slope
        cross = n0*n1
        lost = (loss*loss)
        square = cross*force + e
        at_one = gamma*together
        even = (together*together)
        pull = apart*wall_far
        near1 = (alpha*alpha)*cross - at_one*(e + 1.0) - even*force + lost
        near1_size = (
            xp.abs(lost) + xp.abs((alpha*alpha)*cross) + xp.abs(at_one*(e + 1.0)) +
            xp.abs(even*force)
        )
        apart_one = (gamma - alpha)*(alpha + gamma)
        near0 = apart_one*even
        far1 = (apart*apart)*force - at_minus_one*(e + 1.0) - cross*(wall_far*wall_far) + lost
        far1_size = (
            xp.abs(lost) + xp.abs((apart*apart)*force) + xp.abs(at_minus_one*(e + 1.0)) +
            xp.abs(cross*(wall_far*wall_far))
        )
        far0 = (at_minus_one - pull)*(at_minus_one + pull)
        center = 2.0*at_one/(e + 1.0)
        beyond = 2.0*at_minus_one/(e + 1.0)
        sine = 0.25*beyond*center
        tilt = 0.25*beyond - 0.25*center
        real = 0.25*beyond*together - 0.25*apart*center
        m0 = (n1*n1)*sine + real*real
        m1 = (n1*n1)*tilt - n1*real
        wave = 0.25*alpha*beyond - 0.25*center*wall_far
        wall = sine*(slope*slope) + wave*wave
        own0 = lost*sine - m0*wall
        own1 = lost*tilt - force*m0 - m1*wall
        own2 = e - force*m1
        a_off = number*square_root(xp, at_minus_one*gamma)
        pull = xp.abs(apart*wall_far)
        end_off = a_off + number2*at_minus_one + number2*pull
        end_apart = xp.abs(at_minus_one - pull) - end_off
        end_least = end_apart*(at_minus_one + pull)
        room = number3*near1_size
        product = 4.0*near0*square
        room2 = 2.0*a_off + number3*far1_size
        product2 = 4.0*far0*square
        square2 = (near1*near1)
        product3 = 4.0*near0*square
        size = square2 + xp.abs(product3)
        square3 = (own1*own1)
        product4 = 4.0*own0*own2
        size2 = square3 + xp.abs(product4)
        square4 = (far1*far1)
        product5 = 4.0*far0*square
        size3 = square4 + xp.abs(product5)
        odd2 = xp.abs(xp.where(((((far1 == 0.0) & (square < 0.0)) | (far1 < 0.0)) &
            (far0 == 0.0)) | (far0 < 0.0), xp.full_like(far0, 1.0), 0.0) -
            xp.where(((((near1 == 0.0) & (square < 0.0)) | (near1 < 0.0)) & (near0 == 0.0)) |
            (near0 < 0.0), xp.full_like(near0, 1.0), 0.0))

        def no(product3, product5, size, size2, size3, square2, square4):
            return select(xp, (size > size3) & (size2 > size3), lambda product5, square4: square4 -
                product5, (product5, square4), lambda product3, square2: square2 - product3,
                (product3, square2))

        disc4 = select(xp, (size >= size2) & (size2 <= size3), lambda product4, square3: square3 -
            product4, (product4, square3), no, (product3, product5, size, size2, size3, square2,
            square4))
        positive = xp.where(disc4 >= 0.0, disc4, 0.0)
        root = square_root(xp, positive)
        low, high = quadratic_roots(xp, near0, near1, square, root)
        low3, high3 = quadratic_roots(xp, far0, far1, square, root)
        odd = xp.abs(xp.where((disc4 >= 0.0) & (high > 0.0) & (low3 > 0.0) &
            (xp.where(high < low3, high, low3) < 4.0), xp.full_like(disc4, 1.0), 0.0) -
            xp.where((disc4 >= 0.0) & (high3 > 0.0) & (low > 0.0) &
            (xp.where(high3 < low, high3, low) < 4.0), xp.full_like(disc4, 1.0), 0.0))

        def no(a_off, alpha, apart, beyond, center, d, disc4, far0, far1, high, high3, loss, low,
            low3, n1, near0, near1, own0, own1, own2, root, slope, square, together, wall_far):
            side = xp.where(slope >= 0.0, xp.full_like(slope, 1.0), -1.0)
            end = (
                xp.where(wall_far > 0.0, side, 0.0) - d +
                xp.where(apart > 0.0, xp.where(n1 >= 0.0, xp.full_like(n1, 1.0), -1.0), 0.0) -
                3.0
            )

            def yes(a_off, alpha, apart, beyond, center, d, high, high3, loss, low, low3, n1, own0,
                own1, own2, root, slope, together, wall_far):
                low2, high2 = quadratic_roots(xp, own0, own1, own2, root)
                return (
                    2.0*crossing_turns(xp, low, high3, low2, center, beyond, alpha, slope,
                    wall_far, d, n1, loss, together, apart, xp.full_like(a_off, 0.0),
                    xp.full_like(a_off, 0.0), a_off) - 2.0*
                    crossing_turns(xp, high, low3, high2, center, beyond, alpha, slope,
                    wall_far, d, n1, loss, together, apart, xp.full_like(a_off, 0.0),
                    xp.full_like(a_off, 0.0), a_off)
                )

            def no(a_off, alpha, apart, beyond, center, d, far1, loss, n1, near1, own1, own2,
                slope, square, together, wall_far):
                def no(far1, near1, square):
                    return -0.5*near1/square, -0.5*far1/square

                bottom, bottom2 = select(xp, square == 0.0, lambda square: (-1.0, -1.0), (square,),
                    no, (far1, near1, square))
                bottom3 = select(xp, own2 == 0.0, lambda own2: -1.0, (own2,), lambda own1,
                    own2: -0.5*own1/own2, (own1, own2))
                return bottom_touches(xp, square, bottom, bottom2, bottom3, center, beyond, alpha,
                    slope, wall_far, d, n1, loss, together, apart, xp.full_like(a_off, 0.0),
                    xp.full_like(a_off, 0.0), a_off)

            total = select(xp, disc4 >= 0.0, yes,
                (a_off, alpha, apart, beyond, center, d, high, high3, loss, low, low3, n1, own0,
                own1, own2, root, slope, together, wall_far), no,
                (a_off, alpha, apart, beyond, center, d, far1, loss, n1, near1, own1, own2, slope,
                square, together, wall_far))
            total2 = total + xp.where(((((near1 == 0.0) & (square < 0.0)) | (near1 < 0.0)) &
                (near0 == 0.0)) | (near0 < 0.0), xp.where(alpha > 0.0, 0.0, side), 0.0)
            total2 = total2 - xp.where(((((far1 == 0.0) & (square < 0.0)) | (far1 < 0.0)) &
                (far0 == 0.0)) | (far0 < 0.0), end, 0.0)
            return xp.where(total2 >= 0.0, total2, -1.0)

        return select(xp, ((((stiffest > 0.0) & (stiffest < number4)) |
            (loss + strength < number4)) & (strength > 0.0)) |
            ((end_least <= 8.0*room2) & (product2 >= 0.0) & (product2 <= room2*room2) &
            (room2 >= xp.abs(far1))) | ((product >= 0.0) & (product <= room*room) &
            (room >= xp.abs(near1)) & (xp.abs(near0) <= 8.0*room)) | (end_apart <= 0.0) |
            (odd != odd2), lambda end_apart: -1.0, (end_apart,), no,
            (a_off, alpha, apart, beyond, center, d, disc4, far0, far1, high, high3, loss, low,
            low3, n1, near0, near1, own0, own1, own2, root, slope, square, together, wall_far))

    return select(xp, (alpha == 0.0) & (beta == 0.0), lambda alpha: 0.0, (alpha,), no,
        (alpha, apart, at_minus_one, beta, d, gamma, loss, n0, n1, together))


def ahead_in_phase(xp, psi, at_one, at_minus_one, loss, together, apart, across):
    """the imaginary and the real part of A/(z M), M over A being the device, at z = exp(2 j
    psi)
    """
    t = xp.tan(psi)
    square = unfused(xp, t*t)
    t_halves = halves(xp, t)
    low = two_prod_error(square, t_halves, t_halves)
    diff, diff_low = two_diff(xp, at_one, unfused(xp, at_minus_one*square))
    square_halves = halves(xp, square)
    missed = at_minus_one*low + two_prod_error(unfused(xp, at_minus_one*square),
        halves(xp, at_minus_one), square_halves)
    total, total_low = fast_two_sum(xp, diff, diff_low - missed)
    diff, diff_low = two_diff(xp, together, unfused(xp, apart*square))
    missed = apart*low + two_prod_error(unfused(xp, apart*square), halves(xp, apart), square_halves)
    total2, total_low2 = fast_two_sum(xp, diff, diff_low - missed)
    above_j = 2.0*loss*t
    below_j = across*t
    rest = below_j*below_j + 2.0*total2*total_low2
    size = rest + total2*total2
    low = above_j*total_low2 - below_j*total_low
    found = above_j*total2 - below_j*total
    found = found + low
    low = total*total_low2 + total2*total_low
    rest = above_j*below_j + low
    found3 = rest + total*total2
    return found/size, found3/size


def device_at_minus_one_kick_together_n_gap(xp, gamma, delta):
    """at_minus_one, kick, together and n_gap of the device"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)

    def yes(delta, gamma, half, reach, root, w, w_low):
        envelope, even, even_low, wave, wave_low, near, _, _, moved = swinging_device(xp, gamma,
            half, w, w_low, root)
        return (
            denominator_at_minus_one_swing(xp, half, w, w_low, root, envelope, even, even_low),
            rounded(xp, *wide_prod(xp, envelope, wave, wave_low)),
            numerator_at_one_swing(xp, reach, half, w, w_low, root, envelope, near, moved,
            gamma), numerator_gap_swing(xp, reach, half, w, envelope, wave, wave_low, gamma,
            delta)
        )

    def no(delta, gamma, half, reach, root, w, w_low):
        p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = creeping_device(
            xp, gamma, half, w, w_low, root)
        return (
            denominator_at_minus_one_creep(xp, slow, slow_low, ratio, ratio_low),
            rounded(xp, *pair_prod(xp, slow, slow_low, far, far_low)),
            numerator_at_one_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean,
            mean_low, ratio, ratio_low), numerator_gap_creep(xp, reach, half, w, p, slow, mean,
            mean_low, ratio, far, far_low, delta)
        )

    return select(xp, w < 0.0, yes, (delta, gamma, half, reach, root, w, w_low), no)


def next_wave_single(xp, k, x):
    """The same in single precision."""
    count = k + 1.0
    before = count - 1.0
    angle = unfused(xp, count*x)
    missed = k - before
    quarters = xp.floor(2.0*angle/3.141592653589793 + 0.5)
    quarters_halves = halves(xp, quarters)
    diff, diff_low = two_diff(xp, angle - unfused(xp, 1.5707963705062866*quarters),
        two_prod_error(unfused(xp, quarters*1.5707963705062866), quarters_halves,
        halves(xp, xp.full_like(quarters, 1.5707963705062866))))
    diff, diff_low2 = two_diff(xp, diff, unfused(xp, -4.371138828673793e-08*quarters))
    x_halves = halves(xp, x)
    diff, diff_low3 = two_diff(xp, diff, -two_prod_error(angle, halves(xp, count), x_halves))
    diff, diff_low4 = two_diff(xp, diff, -unfused(xp, missed*x))
    low = (
        diff_low + diff_low2 + diff_low3 + diff_low4 + 1.7151245100058819e-15*quarters -
        two_prod_error(unfused(xp, quarters*-4.371138828673793e-08), quarters_halves,
        halves(xp, xp.full_like(quarters, -4.371138828673793e-08)))
    )
    low = low + two_prod_error(unfused(xp, missed*x), halves(xp, missed), x_halves)
    wave = xp.sin(diff)
    still = xp.cos(diff)
    turn_ = quarters - 4.0*xp.floor(0.25*quarters)
    sine = low*still + wave
    cosine = still - low*wave
    case1 = (turn_ == 1.0) | (turn_ == 3.0)
    value_ = xp.where(case1, sine, cosine)
    value2 = xp.where(case1, cosine, sine)
    return (
        xp.where((turn_ >= 1.0) & (turn_ <= 2.0), -value_, value_),
        xp.where(turn_ >= 2.0, -value2, value2)
    )


def next_wave(xp, k, x):
    """cos((k + 1) x) and sin((k + 1) x)"""
    if k.dtype == xp.float32:
        return next_wave_single(xp, k, x)
    count = k + 1.0
    before = count - 1.0
    angle = unfused(xp, count*x)
    missed = k - before
    off = missed*x + two_prod_error(angle, halves(xp, count), halves(xp, x))
    sine = xp.sin(angle)
    cosine = xp.cos(angle)

    def no(cosine, off, sine):
        return cosine*xp.cos(off) - sine*xp.sin(off), cosine*xp.sin(off) + sine*xp.cos(off)

    return select(xp, xp.abs(off) < 7.450580596923828e-09, lambda cosine, off,
        sine: (cosine - off*sine, cosine*off + sine), (cosine, off, sine), no)


def device_at_minus_one_together_n_gap_n0_n1(xp, gamma, delta):
    """at_minus_one, together, n_gap, n0 and n1 of the device"""
    half, w, w_low, root, reach = device_motion(xp, gamma, delta)

    def yes(delta, gamma, half, reach, root, w, w_low):
        envelope, even, even_low, wave, wave_low, near, risen, sunk, moved = swinging_device(xp,
            gamma, half, w, w_low, root)
        decayed, decayed_low = slow_fade(xp, reach, half)
        return (
            denominator_at_minus_one_swing(xp, half, w, w_low, root, envelope, even, even_low),
            numerator_at_one_swing(xp, reach, half, w, w_low, root, envelope, near, moved,
            gamma), numerator_gap_swing(xp, reach, half, w, envelope, wave, wave_low, gamma,
            delta), plant_n0_swing(xp, reach, half, envelope, even, even_low, wave, wave_low,
            near, sunk, decayed, decayed_low, gamma),
            plant_n1_swing(xp, reach, half, w, envelope, even, even_low, wave, wave_low, near,
            risen, decayed, decayed_low, gamma)
        )

    def no(delta, gamma, half, reach, root, w, w_low):
        p, p_low, slow, slow_low, mean, mean_low, ratio, ratio_low, far, far_low = creeping_device(
            xp, gamma, half, w, w_low, root)
        decayed, decayed_low = slow_fade(xp, reach, half)
        return (
            denominator_at_minus_one_creep(xp, slow, slow_low, ratio, ratio_low),
            numerator_at_one_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean,
            mean_low, ratio, ratio_low), numerator_gap_creep(xp, reach, half, w, p, slow, mean,
            mean_low, ratio, far, far_low, delta),
            plant_n0_creep(xp, reach, p, p_low, slow, slow_low, mean, mean_low, ratio,
            ratio_low, far, far_low, decayed, decayed_low, gamma, delta),
            plant_n1_creep(xp, reach, half, w, p, p_low, slow, slow_low, mean, mean_low, far,
            far_low, decayed, decayed_low)
        )

    return select(xp, w < 0.0, yes, (delta, gamma, half, reach, root, w, w_low), no)


def cos_next(xp, k, x):
    """cos((k + 1) x)"""
    cosine, _ = next_wave(xp, k, x)
    return cosine


def early_slope(xp, theta, k4, k3, k2, k1, k0):
    """has the sign of the slope of the boundary's alpha, d < 1"""
    sine = xp.sin(0.5*theta)
    cosine = xp.cos(0.5*theta)
    up = (sine*sine)
    along = (cosine*cosine)
    found = along*k3 + k4*up
    power2 = (along*along)
    found = found*up + k2*power2
    power2 = along*power2
    found = found*up + k1*power2
    power2 = along*power2
    return found*up + k0*power2


def end_slope(xp, at_minus_one, loss, together, apart, last):
    """has the sign of the slope of the boundary's alpha next to pi"""
    diff, diff_low = two_diff(xp, together, 4.0*last)
    squared, squared_low = pair_square(xp, diff, diff_low)
    prod, prod_low = two_prod(xp, apart, together)
    prod4, prod_low4 = wide_prod(xp, loss,
        *wide_prod(xp, apart, *pair_diff(xp, prod, prod_low, squared, squared_low)))
    prod6, prod_low6 = pair_prod(xp, *pair_square(xp, apart, xp.full_like(apart, 0.0)),
        *pair_diff(xp, 2.0*apart, 0.0, diff, diff_low))
    return rounded(xp, *pair_diff(xp, *pair_diff(xp, 4.0*prod6, 4.0*prod_low6,
        *wide_prod(xp, at_minus_one, *pair_sum(xp,
        *pair_prod(xp, diff, diff_low, *pair_diff(xp, squared, squared_low, 2.0*prod, 2.0*
        prod_low)), *wide_prod(xp, apart, prod, prod_low)))), 2.0*prod4, 2.0*prod_low4))


def next_guess(xp, b, fb, a, fa, c, fc, close):
    """the next point of a search between a and b, where f is fa and fb, after c"""
    span = c - b
    rise = fc - fb
    whole = xp.where(span == 0.0, 1.0, span)
    place = (a - b)/whole
    whole = xp.where(rise == 0.0, 1.0, rise)
    height = (fa - fb)/whole
    base = 1.0 - height
    safe = xp.where((place > height*height) & (place < 1.0 - (base*base)), xp.full_like(base, 1.0),
        0.0)
    width = b - a
    whole = xp.where(width == 0.0, 1.0, width)
    edge = close*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/xp.abs(whole)
    edge = xp.where(0.5 < edge, 0.5, edge)

    def yes(a, c, fa, fb, fc, whole3):
        one = fb - fa
        two = fb - fc
        three = fa - fc
        here = fa/one
        there = fc/two
        other = fa/three
        last = fb/two
        return here*there + last*other*(c - a)/whole3

    guess = select(xp, safe > 0.0, yes, (a, c, fa, fb, fc, whole), lambda safe: 0.5, (safe,))
    share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
    share = xp.where(edge > share, edge, share)
    return a + share*width


def crossing(xp, value, low, high, close, given):
    """Where a value changes from positive to negative between two ends, by Chandrupatla's method.

    An end stands for it where it does not change.
    """
    like = next((v for v in (low, high) if is_array_api_obj(v)), given[0])
    low, high = (v if is_array_api_obj(v) else xp.full_like(like, v) for v in (low, high))

    def over(b, fb, a, fa, c, fc, *given):
        same = ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0))
        return same | (xp.abs(a - b) <= close*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))

    def step(b, fb, a, fa, c, fc, *given):
        new = next_guess(xp, b, fb, a, fa, c, fc, xp.full_like(a, close))
        found = value(new, *given)
        same = ((fa < 0.0) & (found < 0.0)) | ((fa > 0.0) & (found > 0.0))
        kept = xp.where(same, b, a), xp.where(same, fb, fa)
        return *kept, new, found, xp.where(same, a, b), xp.where(same, fa, fb)

    def between(low, above, high, below, *given):
        start = low, above, high, below, high, below
        b, fb, a, fa, _, _ = repeat(xp, 120, over, step, start, given)
        return xp.where(xp.abs(fa) < xp.abs(fb), a, b)

    def beyond(low, above, high, *given):
        below = value(high, *given)
        known = low, above, high, below, *given
        return select(xp, below >= 0.0, lambda high: high, (high,), between, known)

    above = value(low, *given)
    return select(xp, above <= 0.0, lambda low: low, (low,), beyond, (low, above, high, *given))


def early_angle(xp, at_one, at_minus_one, loss, together, apart, last):
    """the angle of the largest stiffness for delays below a period"""
    close = 2.384185791015625e-07 if at_one.dtype == xp.float32 else 4.440892098500626e-16
    t = (apart*apart*apart)
    t2 = (together*together*together)
    t3 = (together*together)
    t4 = apart*t3
    t5 = (apart*apart)
    t6 = 2.0*loss
    t7 = at_minus_one + t6
    t8 = 4.0*together
    t9 = 16.0*apart
    t6 = at_one + t6
    t11 = 2.0*at_one
    t12 = 5.0*at_minus_one
    t13 = -at_one
    t14 = 4.0*loss
    t15 = apart*together
    t16 = 16.0*together
    t17 = at_one*last
    t18 = apart*t11
    t19 = at_one*t5
    k = end_slope(xp, at_minus_one, loss, together, apart, last)
    k2 = last*(32.0*at_minus_one*t3 + last*
        (64.0*apart*loss + 128.0*at_minus_one*last - 96.0*at_minus_one*together) - 96.0*t5 - t7*t9*
        together) - 4.0*at_minus_one*t2 + 16.0*t + 8.0*t4*(at_minus_one + loss) - t5*t7*t8
    k3 = (
        last*(last*(last*(-192.0*at_minus_one - 256.0*at_one - 512.0*loss) + t16*
        (9.0*at_one + 16.0*loss + t12) + t9*(8.0*at_minus_one + 8.0*at_one + 18.0*loss)) - 32.0*
        t15 - 4.0*t3*(at_minus_one + 7.0*at_one + 14.0*loss) - 112.0*t5) + 8.0*t + 2.0*t2*
        (t6 - 2.0*at_minus_one) + 2.0*t4*(t12 + t13 + t14) - 2.0*t5*together*(t7 - t11)
    )
    k4 = (
        last*(32.0*t17*together - 8.0*together*(t18 + 12.0*together)) + t8*
        (t6*t3 + t15*(at_minus_one + t13) + t19)
    )
    k5 = (
        last*(t16*t17 + t8*(t6*together - t18)) + together*
        (t19 - 2.0*t15*(at_one + loss) + t3*(at_minus_one + t11 + t14))
    )

    def over(count, found, k, k2, k3, k4, k5):
        return (count > 24.0) | (found > 0.0)

    def step(count, found, k, k2, k3, k4, k5):
        rises = early_slope(xp, 0.041666666666666664*3.141592653589793*count, k, k2, k3, k4, k5)
        case1 = rises > 0.0
        next_count = xp.where(case1, count + 1.0, count)
        next_found = xp.where(case1, xp.full_like(rises, 0.0), 1.0)
        return next_count, next_found

    count, found = repeat(xp, 24, over, step, (1.0, 0.0), (k, k2, k3, k4, k5))

    def yes(count, k, k2, k3, k4, k5):
        high = 0.041666666666666664*3.141592653589793*count
        low = xp.where(0.001*high > 0.041666666666666664*3.141592653589793*(count - 1.0), 0.001*
            high, 0.041666666666666664*3.141592653589793*(count - 1.0))
        return crossing(xp, lambda *v: early_slope(xp, *v), low, high, close, (k, k2, k3, k4, k5))

    return select(xp, found > 0.0, yes, (count, k, k2, k3, k4, k5),
        lambda found: 3.141592653589793, (found,))


def sin_next(xp, k, x):
    """sin((k + 1) x)"""
    _, sine = next_wave(xp, k, x)
    return sine


def boundary_slope(xp, theta, l, at_one, at_minus_one, loss, together, apart, across):
    """has the sign of the slope of the boundary's alpha"""
    t = 2.0*l + 2.0
    t2 = 0.5*theta
    t3 = sin_next(xp, t, t2)
    t4 = xp.tan(t2)
    t5 = (t4*t4)
    t6 = 4.0*t5
    t7 = apart*t5
    t8 = together - t7
    t9 = at_minus_one*t5
    t10 = at_one - t9
    t11 = across*loss*t6 + t10*t8
    t2 = cos_next(xp, t, t2)
    t = 2.0*loss*t4*t8 - 2.0*across*t10*t4
    t14 = (across*across)
    t15 = t14*t6 + t8*t8
    t16 = (loss*loss)
    t6 = t10*t10 + t16*t6
    t18 = t15*t6
    t5 = t5 + 1.0
    return (
        (t11*t3 + t2*t)*(t18*(l + 1.5) + t5*(loss*t15*(at_one + t9) - across*t6*(t7 + together))) -
        t4*(0.5*t18 + t5*(t15*(2.0*t16 - at_minus_one*t10) - t6*(2.0*t14 - apart*t8)))*
        (t11*t2 - t*t3)
    )


def later_angle(xp, d, l, at_one, at_minus_one, loss, together, apart, across):
    """the angle of the largest stiffness for a period and more"""
    close = 2.384185791015625e-07 if d.dtype == xp.float32 else 4.440892098500626e-16
    turn_ = 3.141592653589793/(d + 1.0)

    def over(count, found, across, apart, at_minus_one, at_one, l, loss, together, turn_):
        return (count > 24.0) | (found > 0.0)

    def step(count, found, across, apart, at_minus_one, at_one, l, loss, together, turn_):
        rises = boundary_slope(xp, 0.041666666666666664*count*turn_, l, at_one, at_minus_one, loss,
            together, apart, across)
        case1 = rises > 0.0
        next_count = xp.where(case1, count + 1.0, count)
        next_found = xp.where(case1, xp.full_like(rises, 0.0), 1.0)
        return next_count, next_found

    count, found = repeat(xp, 24, over, step, (1.0, 0.0),
        (across, apart, at_minus_one, at_one, l, loss, together, turn_))

    def yes(across, apart, at_minus_one, at_one, count, l, loss, together, turn_):
        high = 0.041666666666666664*count*turn_
        low = xp.where(0.001*high > 0.041666666666666664*turn_*(count - 1.0), 0.001*high,
            0.041666666666666664*turn_*(count - 1.0))
        return crossing(xp, lambda *v: boundary_slope(xp, *v), low, high, close,
            (l, at_one, at_minus_one, loss, together, apart, across))

    return select(xp, found > 0.0, yes, (across, apart, at_minus_one, at_one, count, l, loss,
        together, turn_), lambda found: xp.nan, (found,))


def undelayed_angle(xp, at_one, at_minus_one, loss, together, apart):
    """the angle of the largest stiffness without delay"""
    k = end_slope(xp, at_minus_one, loss, together, apart, xp.full_like(apart, 0.0))
    t = 2.0*apart
    t2 = -together
    t3 = 2.0*together
    t4 = (together*together)
    k2 = t3*((apart*apart)*at_one + together*(at_minus_one*(t + t2) + loss*t))
    base = -apart - t2
    k3 = together*(at_minus_one*t4 + at_one*(base*base + t4) + loss*t3*(2.0*together - apart))

    def yes(k, k2, k3):
        discriminant = k2*k2 - 4.0*k*k3
        root = square_root(xp, xp.where(0.0 > discriminant, 0.0, discriminant))
        return k2 + root, xp.where(0.0 > -2.0*k, 0.0, -2.0*k)

    def no(k, k2, k3):
        discriminant = k2*k2 - 4.0*k*k3

        def no(discriminant, k2, k3):
            root = square_root(xp, xp.where(0.0 > discriminant, 0.0, discriminant))
            return 2.0*k3, root - k2

        return select(xp, discriminant < 0.0, lambda k3: (2.0*k3, 0.0), (k3,), no,
            (discriminant, k2, k3))

    above, below = select(xp, k2 > 0.0, yes, (k, k2, k3), no)
    return 2.0*xp.atan2(square_root(xp, above), square_root(xp, below))


def max_stiffness_angle(xp, gamma, delta, d, l, part, first, last, at_one, at_minus_one, loss,
    together, apart):
    """the angle of the wall of largest stable stiffness, or NaN"""
    number, number2 = (0.9999237060546875, 7.62939453125e-05) if gamma.dtype == xp.float32 else (
        0.9999999953433871, 4.6566128730773926e-09)
    def yes(apart, at_minus_one, at_one, d, delta, first, gamma, l, last, loss, part, together):
        across = xp.where(part == 0.0, first, first - last)

        def no(across, apart, at_minus_one, at_one, d, l, last, loss, together):
            return select(xp, d < 1.0, lambda *v: early_angle(xp, *v),
                (at_one, at_minus_one, loss, together, apart, last),
                lambda *v: later_angle(xp, *v), (d, l, at_one, at_minus_one, loss, together, apart,
                across))

        theta = select(xp, d == 0.0, lambda *v: undelayed_angle(xp, *v),
            (at_one, at_minus_one, loss, together, apart), no,
            (across, apart, at_minus_one, at_one, d, l, last, loss, together))
        t = sin_next(xp, l, theta)
        t2 = 0.5*theta
        t3 = xp.sin(t2)
        t2 = xp.cos(t2)
        t5 = (t2*t2)
        t6 = (t3*t3)
        t7 = 4.0*t5*t6
        t8 = t5*together - apart*t6
        t9 = 1.0/((across*across)*t7 + t8*t8)
        t5 = at_one*t5 - at_minus_one*t6
        t11 = 2.0*loss*t8 - 2.0*across*t5
        t5 = across*loss*t7 + t5*t8
        t8 = t9*cos_next(xp, l, theta)
        t7 = -t*t5*t9/xp.sin(theta) - 0.5*t11*t8
        stiffness = t*t11*t3*t2*t9 - t5*t8 - 2.0*t7*t6

        def no(apart, at_minus_one, delta, first, gamma, l, last, loss, part, stiffness, t14,
            together):
            inside_ = number*stiffness - number2*gamma

            def no(apart, at_minus_one, delta, first, gamma, inside_, l, last, loss, t14, together):
                return fractional_roots(xp, inside_, t14, l, first, last, gamma, at_minus_one,
                    loss, together, apart, first - last, delta)

            outside = select(xp, part == 0.0, lambda *v: whole_roots(xp, *v),
                (inside_, t14, l, first, last, gamma, at_minus_one, loss, together, apart), no,
                (apart, at_minus_one, delta, first, gamma, inside_, l, last, loss, t14, together))

            def yes(apart, at_minus_one, delta, first, gamma, l, last, loss, part, stiffness, t14,
                together):
                inside_ = 0.99609375*stiffness - 0.00390625*gamma

                def no(apart, at_minus_one, delta, first, gamma, inside2, l, last, loss, t14,
                    together):
                    return fractional_roots(xp, inside2, t14, l, first, last, gamma, at_minus_one,
                        loss, together, apart, first - last, delta)

                outside2 = select(xp, part == 0.0, lambda *v: whole_roots(xp, *v),
                    (inside_, t14, l, first, last, gamma, at_minus_one, loss, together, apart), no,
                    (apart, at_minus_one, delta, first, gamma, inside_, l, last, loss, t14,
                    together))
                return stable(xp, outside2, inside_, t14, gamma, delta)

            return select(xp, outside < 0.0, yes,
                (apart, at_minus_one, delta, first, gamma, l, last, loss, part, stiffness, t14,
                together), lambda *v: stable(xp, *v), (outside, inside_, t14, gamma, delta))

        good = select(xp, (delta > 0.0) & (gamma > -stiffness) &
            (square_root(xp, gamma)*(d + 1.0) <= 3.141592653589793), lambda d: 1.0, (d,), no,
            (apart, at_minus_one, delta, first, gamma, l, last, loss, part, stiffness, t7,
            together))
        return xp.where(good > 0.0, theta, xp.nan)

    return select(xp, ((d <= 1.0) | (square_root(xp, gamma)*(d + 1.0) <= 3.141592653589793)) &
        (gamma <= 9.8), yes, (apart, at_minus_one, at_one, d, delta, first, gamma, l, last, loss,
        part, together), lambda d: xp.nan, (d,))


def required_at(xp, alpha, beta, l, epsilon, theta):
    """the damping that the wall requires at the angle theta, for a fractional delay"""
    number, number2 = (9.094947017729282e-13,
        1.2089258196146292e+24) if alpha.dtype == xp.float32 else (3.8725919148493183e-121,
        6.668014432879854e+240)
    cosine, sine = next_wave(xp, l, theta)
    lift = xp.where(xp.abs(alpha) + xp.abs(beta) < number, xp.full_like(alpha, number2), 1.0)
    stiffness = alpha*lift
    damping = beta*lift
    half = 0.5*theta
    up = xp.sin(half)
    along = xp.cos(half)
    twice = 2.0*epsilon
    diff, diff_low = pair_diff(xp, *wide_prod(xp, 0.5*stiffness,
        *pair_diff(xp, *pair_sum(xp, *pair_quot(xp, *two_prod(xp, sine, along), up,
        xp.full_like(along, 0.0)), *two_prod(xp, twice, cosine)), cosine, 0.0)),
        *wide_prod(xp, damping, *pair_diff(xp, cosine, 0.0,
        *wide_prod(xp, twice, *wide_prod(xp, up,
        *pair_sum(xp, *two_prod(xp, sine, along), *two_prod(xp, cosine, up)))))))
    n = diff + diff_low
    base = 2.0*damping + stiffness
    size = (along*along)*(stiffness*stiffness) + (base*base)*(up*up)
    extra = epsilon*size*(1.0 - epsilon)
    root = square_root(xp, extra + n*n)
    whole = xp.where(root + xp.abs(n) == 0.0, 1.0, root + xp.abs(n))
    more = 0.5*extra/whole
    rest = diff_low + more
    whole_need = diff + rest
    return xp.where(n < 0.0, more, whole_need)/lift


def straight_at(xp, stiffness, damping, k, angle):
    """what straight motions require at an angle, with a delay of k periods"""
    half = 0.5*angle
    return rounded(xp, *pair_diff(xp, *wide_prod(xp, stiffness,
        *pair_quot(xp, sin_next(xp, 2.0*k, half), xp.full_like(half, 0.0), 2.0*xp.sin(half),
        xp.full_like(half, 0.0))), *two_prod(xp, damping, cos_next(xp, k, angle))))


def gap(xp, x):
    """(x - sin(x))/x^3"""
    begin, number2, number3 = (17, -4.967053879312289e-09,
        0.1666666716337204) if x.dtype == xp.float32 else (25, 9.25185853854297e-18,
        0.16666666666666666)
    def yes(x):
        square = -(x*x)
        total = 0.0
        for number in INVERSE_FACTORIAL[begin:4:-2]:
            next_total = number + square*total
            total = next_total
        rest = square*total + number2
        return rest + number3

    return select(xp, xp.abs(x) < 2.0, yes, (x,), lambda x: (x - xp.sin(x))/(x*x*x))


def sinc(xp, x):
    """sin(x)/x"""
    return select(xp, xp.abs(x) < 1.0, lambda x: 1.0 - (x*x)*gap(xp, x), (x,), lambda x: xp.sin(x)/
        x)


def damping_at(xp, alpha, beta, l, epsilon, psi):
    """the damping that the wall requires at the angle 2 psi"""
    early = (
        0.5*alpha*(2.0*l + 1.0)*sinc(xp, psi*(2.0*l + 1.0))/sinc(xp, psi) - beta*
        cos_next(xp, l, 2.0*psi)
    )

    def no(alpha, beta, early, epsilon, l, psi):
        n = early + epsilon*(0.5*alpha*(2.0*l + 3.0)*sinc(xp, psi*(2.0*l + 3.0))/sinc(xp, psi) -
            beta*cos_next(xp, l + 1.0, 2.0*psi) - early)
        base = xp.sin(psi)
        base2 = xp.cos(psi)
        base3 = alpha + 2.0*beta
        root = square_root(xp, epsilon*(1.0 - epsilon)*
            ((alpha*alpha)*(base2*base2) + (base*base)*(base3*base3)) + n*n)
        return 0.5*n + 0.5*root

    return select(xp, epsilon == 0.0, lambda early: early, (early,), no,
        (alpha, beta, early, epsilon, l, psi))


def chord(xp, k, x):
    """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3"""
    turn_ = x*(k + 1.0)
    order = 2.0*k + 2.0
    along = cos_next(xp, k, x)

    def yes(along, order, turn_, x):
        wave = sinc(xp, 0.5*turn_)
        inner = 0.5*(wave*wave) - gap(xp, turn_)
        return order*(along*gap(xp, x) + 0.25*inner*(order*order))

    def no(along, k, order, x):
        return (2.0*sin_next(xp, k, x) - along*order*xp.sin(x))/(x*x*x)

    return select(xp, turn_ < 1.5, yes, (along, order, turn_, x), no, (along, k, order, x))


def rising(xp, alpha, beta, l, epsilon, psi):
    """has the sign of the slope of DampingAt, at a fraction"""
    t = 2.0*psi
    base = sinc(xp, psi)
    t2 = 2.0*alpha/(base*base)
    t3 = 0.5*alpha + beta
    t4 = 2.0*l
    t5 = t4 + 2.0
    t4 = t4 + 4.0
    early = t3*(t5*t5)*sinc(xp, psi*t5) - t2*chord(xp, l, t)
    steep = early + epsilon*(t3*(t4*t4)*sinc(xp, psi*t4) - early - t2*chord(xp, l + 1.0, t))
    return (
        2.0*beta*epsilon*(1.0 - epsilon)*(alpha + beta)*sinc(xp, 2.0*psi) + steep*
        damping_at(xp, alpha, beta, l, epsilon, psi)
    )


def steepness(xp, alpha, beta, l, epsilon, psi):
    """has the sign of the slope of DampingAt, up to the angle in phase"""
    def yes(alpha, beta, l, psi):
        t = 2.0*l + 2.0
        base = sinc(xp, psi)
        return (
            (t*t)*(0.5*alpha + beta)*sinc(xp, psi*t) - 2.0*alpha*chord(xp, l, 2.0*psi)/(base*base)
        )

    def no(alpha, beta, epsilon, l, psi):
        rising_ = rising(xp, alpha, beta, l, epsilon, psi)
        phase = (
            psi*(2.0*l + 2.0) + xp.atan2(alpha*xp.cos(psi), (alpha + 2.0*beta)*xp.sin(psi)) +
            xp.atan2(epsilon*xp.sin(2.0*psi), epsilon*xp.cos(2.0*psi) - epsilon + 1.0) -
            3.141592653589793
        )
        return xp.where(phase > 0.0, -xp.abs(rising_), rising_)

    return select(xp, epsilon == 0.0, yes, (alpha, beta, l, psi), no,
        (alpha, beta, epsilon, l, psi))


def worst_angle(xp, alpha, beta, l, epsilon):
    """half of the angle at which the wall requires most damping"""
    number, flat = (3.141592502593994, 7.62939453125e-06) if alpha.dtype == xp.float32 else (
        3.141592653589793, 4.656612873077393e-10)
    size = xp.abs(alpha) + xp.abs(beta)
    whole = xp.where(size == 0.0, 1.0, size)
    stiffness = alpha/whole
    damping = beta/whole
    high = number/(2.0*l + 2.0)

    def value(at, damping, epsilon, l, stiffness):
        return steepness(xp, stiffness, damping, l, epsilon, at)

    return crossing(xp, value, 0.0, high, flat, (damping, epsilon, l, stiffness))


def largest_required_damping(xp, alpha, beta, d):
    """the damping that the wall requires at its worst angle"""
    number, number2 = (9.094947017729282e-13,
        1.2089258196146292e+24) if alpha.dtype == xp.float32 else (3.8725919148493183e-121,
        6.668014432879854e+240)
    def no(alpha, beta, d):
        whole = xp.floor(d)
        part = d - whole
        lift = xp.where(xp.abs(alpha) + xp.abs(beta) < number, xp.full_like(alpha, number2), 1.0)
        stiffness = alpha*lift
        damping = beta*lift
        return damping_at(xp, stiffness, damping, whole, part,
            worst_angle(xp, stiffness, damping, whole, part))/lift

    return select(xp, alpha < 0.0, lambda alpha: xp.inf, (alpha,), no, (alpha, beta, d))


def between(xp, share, early, late):
    """early + share (late - early)"""
    more = late - early
    return early + more*share


def lead(xp, theta, l, epsilon):
    """negative beyond the angle in phase with the delay"""
    def yes(epsilon, l, theta):
        early = sin_next(xp, l, theta)
        late = sin_next(xp, l + 1.0, theta)
        return early + epsilon*(late - early)

    return select(xp, theta*(l + 1.0) < 4.0, yes, (epsilon, l, theta), lambda l: -1.0, (l,))


def rated(xp, number, value_):
    """the value, NaN for number < 0"""
    return xp.where(number < 0.0, xp.nan, value_)


def spread(xp, k, x):
    """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3"""
    turn_ = x*(k + 1.0)
    order = 2.0*k + 2.0

    def yes(order, turn_, x):
        return order*((order*order)*gap(xp, 2.0*turn_) - gap(xp, x))

    def no(k, order, x):
        return (order*xp.sin(x) - 2.0*cos_next(xp, k, x)*sin_next(xp, k, x))/(x*x*x)

    return select(xp, turn_ < 1.5, yes, (order, turn_, x), no, (k, order, x))


def straight(xp, stiffness, damping, k, angle):
    """what straight motions require with an integer delay of k periods"""
    order = 2.0*k + 1.0
    return rounded(xp, *pair_diff(xp, *wide_prod(xp, stiffness,
        *pair_quot(xp, *two_prod(xp, order, sinc(xp, angle*order)), 2.0*sinc(xp, angle),
        xp.full_like(angle, 0.0))), *two_prod(xp, damping, cos_next(xp, k, 2.0*angle))))


def turning(xp, phi, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9,
    wave10, wave11, wave12):
    """has the sign of minus the slope of what the wall phi needs"""
    t = xp.sin(phi)
    t2 = l + 1.0
    t3 = xp.cos(phi)
    t4 = t3/t2
    t5 = 0.5*t4
    t6 = t - t5
    t7 = t6*wave5
    t8 = 2.0*l
    t9 = t5/wave7
    t10 = t9*wave9*(t8 + 1.0)
    t11 = epsilon*(1.0 - epsilon)
    t4 = 2.0*t4/(wave7*wave7)
    base = t8 + 2.0
    t13 = (base*base)*t*wave10 - t4*wave3
    mean = epsilon*(t7 - t10 - t6*wave6 + t9*wave11*(t8 + 3.0)) + t10 - t7
    base = t8 + 4.0
    return (
        -2.0*t11*t6*wave8*(t + t5) - (0.5*mean + 0.5*
        square_root(xp, mean*mean + t11*(4.0*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/
        (t2*t2))))*(epsilon*((base*base)*t*wave12 - t4*wave4 - t13) + t13)
    )


def turn(xp, psi, l, epsilon):
    """the wall whose worst angle is 2 psi, as an angle"""
    close = 2.384185791015625e-07 if psi.dtype == xp.float32 else 4.440892098500626e-16
    wave = xp.sin(psi)
    wave2 = xp.cos(psi)
    wave3 = chord(xp, l, 2.0*psi)
    wave4 = chord(xp, l + 1.0, 2.0*psi)
    wave5 = cos_next(xp, l, 2.0*psi)
    wave6 = cos_next(xp, l + 1.0, 2.0*psi)
    wave7 = sinc(xp, psi)
    wave8 = sinc(xp, 2.0*psi)
    wave9 = sinc(xp, psi*(2.0*l + 1.0))
    wave10 = sinc(xp, psi*(2.0*l + 2.0))
    wave11 = sinc(xp, psi*(2.0*l + 3.0))
    wave12 = sinc(xp, psi*(2.0*l + 4.0))
    return crossing(xp, lambda *v: turning(xp, *v), 0.0, 0.5*3.141592653589793, close,
        (l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9, wave10, wave11,
        wave12))


def touching(xp, theta, l, epsilon):
    """the wall whose worst angle is theta, as an angle, or NaN"""
    found = turn(xp, 0.5*theta, l, epsilon)
    return xp.where(found < 0.5*3.141592653589793, found, xp.nan)


def passive_slope(xp, theta, l, epsilon):
    """whether a larger angle allows less stiffness, at a fraction"""
    cosine, sine = next_wave(xp, l, theta)
    cosine2, sine2 = next_wave(xp, l + 1.0, theta)
    up = epsilon*(sine2 - sine) + sine
    along = cosine + epsilon*(cosine2 - cosine)
    return (1.0 - up)*xp.cos(theta) + (along*(epsilon + l + 1.0) - epsilon*(1.0 - epsilon)*
        (cosine - cosine2))*xp.sin(theta)


def passive_angle(xp, l, epsilon):
    """the worst angle of the stiffest passive wall, at a fraction"""
    close = 2.384185791015625e-07 if l.dtype == xp.float32 else 4.440892098500626e-16
    high = 3.141592653589793/(epsilon + l + 1.0)
    return crossing(xp, lambda *v: passive_slope(xp, *v), 0.0, high, close, (l, epsilon))


INSIDE = {
    "gamma": lambda xp, most, gamma: (gamma >= 0.0) & (gamma <= most.stiffness),
    "delta": lambda xp, most, delta: (delta >= 0.0) & (delta <= most.size),
    "epsilon": lambda xp, most, epsilon: (epsilon >= 0.0) & (epsilon < 1.0),
    "alpha": lambda xp, most, alpha: xp.abs(alpha) <= most.size,
    "beta": lambda xp, most, beta: xp.abs(beta) <= most.size,
    "d": lambda xp, most, d: (d >= 0.0) & (d <= most.periods),
    "theta": lambda xp, most, theta: (theta > 0.0) & (theta <= most.angle),
}
"""What is true of each argument inside its domain alone."""


@by_value
def discretize(gamma, delta):
    """the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m.

    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    Results: n1; n0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].
    Domain: gamma >= 0, delta >= 0.
    NaN outside it, and if an argument is NaN or larger than 1e70 or gamma larger than 1e15.
    """
    xp, gamma, delta = arrays(gamma, delta)

    def work(gamma, delta):
        n0, n1, trace = device_n0_n1_trace(xp, gamma, delta)
        return n1, n0, trace, xp.exp(-delta)

    return guarded(xp, work, "gamma delta", 4, math.nan, gamma, delta)


@by_value
def discretize_fractional(gamma, delta, epsilon):
    """the sampled device with a delay of epsilon periods, P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 -
    a z + e)) in units of T^2/m.

    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    epsilon: rest of a delay, a fraction of a period [1]
    Results: m2; m1; m0; a, trace of the sampled plant [1]; e, determinant of the sampled plant
    [1].
    Domain: gamma >= 0, delta >= 0, 0 <= epsilon < 1.
    NaN outside it, and if an argument is NaN or larger than 1e70 or gamma larger than 1e15.
    """
    xp, gamma, delta, epsilon = arrays(gamma, delta, epsilon)

    def plant(gamma, delta):
        return device_together_trace(xp, gamma, delta)

    together, trace = guarded(xp, plant, "gamma delta", 2, math.nan, gamma, delta)

    def work(gamma, delta, epsilon, together, trace):
        t0 = 1.0 - epsilon
        t1 = (t0*t0)
        t0 = delta*t0
        n1 = plant_n1(xp, gamma*t1, t0)
        t1 = n1*t1
        t4 = (epsilon*epsilon)
        n0 = plant_n0(xp, gamma*t4, delta*epsilon)
        t4 = n0*t4*xp.exp(-t0)
        return t1, together - t1 - t4, t4, trace, xp.exp(-delta)

    return guarded(xp, work, "gamma delta epsilon", 5, math.nan, gamma, delta, epsilon, together,
        trace)


@by_value
def is_stable(alpha, beta, gamma, delta, d):
    """whether all characteristic roots lie inside the unit circle.

    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) rounds
    to a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|,
    gamma) < 2^-400 (single: 2^-40).
    False outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than
    1e15.
    """
    xp, alpha, beta, gamma, delta, d = arrays(alpha, beta, gamma, delta, d)
    roots = unstable_roots(alpha, beta, gamma, delta, d)

    def work(roots, alpha, beta, gamma, delta):
        return stable(xp, roots, alpha, beta, gamma, delta) > 0.0

    return settled(xp, work, roots, alpha, beta, gamma, delta)


@by_value
def unstable_roots(alpha, beta, gamma, delta, d):
    """number of characteristic roots outside the unit circle.

    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) rounds
    to a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|,
    gamma) < 2^-400 (single: 2^-40).
    -1 outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.
    """
    xp, alpha, beta, gamma, delta, d = arrays(alpha, beta, gamma, delta, d)

    def plant(gamma, delta):
        at_minus_one, kick_of, together, n_gap, n0, n1 = (
            device_at_minus_one_kick_together_n_gap_n0_n1(xp, gamma, delta)
        )
        return at_minus_one, kick_of, together, n0, n1, delta*decay(xp, delta), delta*n_gap

    at_minus_one, kick_of, together, n0, n1, t1, t3 = guarded(xp, plant, "gamma delta", 7,
        math.nan, gamma, delta)

    def work(alpha, beta, gamma, delta, d, at_minus_one, kick_of, together, n0, n1, t1, t3):
        whole = xp.floor(d)
        part = d - whole

        def no(alpha, beta, delta, at_minus_one, gamma, kick_of, together, part, t1, t3, whole):
            apart, m2, kicked, m0 = late_device(xp, gamma, delta, part)
            return fractional_roots(xp, alpha, beta, whole, m2, m0, gamma, at_minus_one, t1,
                together, apart, 0.5*kick_of*(delta*m2 + 2.0*kicked) + 0.5*m2*
                (gamma*together + t1) - 0.5*together + 0.5*t3, delta)

        return select(xp, part == 0.0, lambda *v: whole_roots(xp, *v),
            (alpha, beta, d, n1, n0, gamma, at_minus_one, t1, together, t3), no,
            (alpha, beta, delta, at_minus_one, gamma, kick_of, together, part, t1, t3, whole))

    return guarded(xp, work, "alpha beta gamma delta d", 1, -1, alpha, beta, gamma, delta, d,
        at_minus_one, kick_of, together, n0, n1, t1, t3)


@by_value
def stability_boundary(theta, gamma, delta, d):
    """the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).

    theta: angle on the unit circle, omega T [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].
    Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0.
    NaN outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than
    1e15.
    """
    xp, theta, gamma, delta, d = arrays(theta, gamma, delta, d)

    def plant(gamma, delta):
        at_minus_one, kick_of, together, n_gap = device_at_minus_one_kick_together_n_gap(xp, gamma,
            delta)
        return at_minus_one, kick_of, together, gamma*together, delta*decay(xp, delta), delta*n_gap

    at_minus_one, kick_of, together, t4, t6, t7 = guarded(xp, plant, "gamma delta", 6, math.nan,
        gamma, delta)

    def work(theta, gamma, delta, d, at_minus_one, kick_of, together, t4, t6, t7):
        whole = xp.floor(d)
        cosine, sine = next_wave(xp, whole, theta)
        part = d - whole
        t2 = 0.5*theta

        def no(delta, gamma, kick_of, together, part, t4, t6, t7):
            apart, m2, kicked, _ = late_device(xp, gamma, delta, part)
            return apart, kick_of*(delta*m2 + 2.0*kicked) + m2*(t4 + t6) - together + t7

        t10, t12 = select(xp, part == 0.0, lambda together, t7: (t7, together + t7),
            (together, t7), no, (delta, gamma, kick_of, together, part, t4, t6, t7))
        ahead_of, in_phase_of = ahead_in_phase(xp, t2, t4, at_minus_one, t6, together, t10, t12)
        t16 = ahead_of*cosine + in_phase_of*sine
        return ahead_of*sine - cosine*in_phase_of + t16*xp.tan(t2), -t16/xp.sin(theta)

    return guarded(xp, work, "theta gamma delta d", 2, math.nan, theta, gamma, delta, d,
        at_minus_one, kick_of, together, t4, t6, t7)


@by_value
def max_stable_stiffness(gamma, delta, d):
    """the wall of largest stable stiffness, a limit that is not stable itself, and the angle
    theta = omega T of its roots on the unit circle.

    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta,
    angle on the unit circle, omega T [1].
    Domain: gamma >= 0, delta >= 0, d >= 0, gamma <= 9.8, sqrt(gamma) (d + 1) <= pi or d <= 1,
    delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) (d + 1) > pi, NaN elsewhere, and if no wall is
    stable, or none that is slightly softer.
    NaN outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than
    1e15.
    """
    xp, gamma, delta, d = arrays(gamma, delta, d)

    def plant(gamma, delta):
        at_minus_one, together, n_gap, n0, n1 = device_at_minus_one_together_n_gap_n0_n1(xp, gamma,
            delta)
        t3 = delta*decay(xp, delta)
        t4 = delta*n_gap
        return at_minus_one, together, n0, n1, gamma*together, t3, t4, together + t4, 2.0*t3

    at_minus_one, together, n0, n1, t1, t3, t4, t10, t16 = guarded(xp, plant, "gamma delta", 9,
        math.nan, gamma, delta)

    def work(gamma, delta, d, at_minus_one, together, n0, n1, t1, t3, t4, t10, t16):
        whole = xp.floor(d)
        part = d - whole

        def yes(d, delta, at_minus_one, gamma, together, n0, n1, t1, t10, t16, t3, t4):
            t5 = max_stiffness_angle(xp, gamma, delta, d, d, xp.full_like(at_minus_one, 0.0), n1,
                n0, t1, at_minus_one, t3, together, t4)
            cosine, sine = next_wave(xp, d, t5)
            t7 = 0.5*t5
            t8 = xp.sin(t7)
            t7 = xp.cos(t7)
            t11 = (t7*t7)
            t12 = (t8*t8)
            t13 = t11*t12
            t14 = together*t11 - t12*t4
            t15 = 1.0/((t10*t10)*t13 + t14*t14)
            t11 = t1*t11 - at_minus_one*t12
            t18 = t14*t16 - t10*t11
            t11 = t10*t13*t16 + t14*t11
            t14 = cosine*t15
            t13 = -sine*t15*t11/xp.sin(t5) - 0.5*t18*t14
            return sine*t15*t18*t8*t7 - 2.0*t12*t13 - t11*t14, t13, t5

        def no(d, delta, at_minus_one, gamma, together, part, t1, t16, t3, whole):
            apart, m2, _, m0 = late_device(xp, gamma, delta, part)
            t27 = max_stiffness_angle(xp, gamma, delta, d, whole, part, m2, m0, t1, at_minus_one,
                t3, together, apart)
            cosine, sine = next_wave(xp, whole, t27)
            t28 = 0.5*t27
            t29 = xp.sin(t28)
            t28 = xp.cos(t28)
            t32 = (t28*t28)
            t33 = (t29*t29)
            t34 = together*t32 - apart*t33
            t35 = 2.0*m2 - 2.0*m0
            t36 = t32*t33
            t37 = 1.0/(t34*t34 + (t35*t35)*t36)
            t32 = t1*t32 - at_minus_one*t33
            t39 = t16*t34 - t35*t32
            t32 = t16*t35*t36 + t34*t32
            t36 = cosine*t37
            t35 = -sine*t37*t32/xp.sin(t27) - 0.5*t39*t36
            return sine*t29*t28*t37*t39 - 2.0*t33*t35 - t32*t36, t35, t27

        return select(xp, part == 0.0, yes, (d, delta, at_minus_one, gamma, together, n0, n1, t1,
            t10, t16, t3, t4), no, (d, delta, at_minus_one, gamma, together, part, t1, t16, t3,
            whole))

    return guarded(xp, work, "gamma delta d", 3, math.nan, gamma, delta, d, at_minus_one, together,
        n0, n1, t1, t3, t4, t10, t16)


@by_value
def passivity_margin_at(theta, alpha, beta, delta, d):
    """physical damping minus the damping that the wall requires at the angle theta = omega T; a
    wall with alpha >= 0 is passive if this is not negative at any angle.

    theta: angle on the unit circle, omega T [1]
    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, delta >= 0, d >= 0.
    NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, theta, alpha, beta, delta, d = arrays(theta, alpha, beta, delta, d)

    def work(theta, alpha, beta, delta, d):
        whole = xp.floor(d)
        part = d - whole

        def yes(alpha, beta, d, delta, theta):
            return delta - straight_at(xp, alpha, beta, d, theta)

        def no(alpha, beta, delta, part, theta, whole):
            return delta - required_at(xp, alpha, beta, whole, part, theta)

        return select(xp, part == 0.0, yes, (alpha, beta, d, delta, theta), no,
            (alpha, beta, delta, part, theta, whole))

    return guarded(xp, work, "theta alpha beta delta d", 1, math.nan, theta, alpha, beta, delta, d)


@by_value
def passivity_margin(alpha, beta, delta, d):
    """physical damping minus the damping that the wall requires at its worst angle; the wall is
    passive if this is not negative.

    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0, -inf for alpha < 0.
    NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, alpha, beta, delta, d = arrays(alpha, beta, delta, d)

    def work(alpha, beta, delta, d):
        return delta - largest_required_damping(xp, alpha, beta, d)

    return guarded(xp, work, "alpha beta delta d", 1, math.nan, alpha, beta, delta, d)


@by_value
def passivity_boundary(theta, delta, d):
    """the wall that is just passive and whose worst angle is theta = omega T.

    theta: angle on the unit circle, omega T [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].
    Domain: 0 < theta < pi, delta >= 0, d >= 0, NaN beyond the angle where alpha is 0: pi/(d +
    1) for integer delays, for d <= 2/9 the curve continues to pi.
    NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, theta, delta, d = arrays(theta, delta, d)

    def work(theta, delta, d):
        whole = xp.floor(d)
        part = d - whole
        t = 0.5*theta

        def yes(d, delta, t2, theta):
            t0 = lead(xp, theta, d, xp.full_like(d, 0.0))
            t1 = delta/spread(xp, d, theta)
            t15 = sinc(xp, t2)
            sine = sin_next(xp, d, theta)
            t15 = sine*(t15*t15)*(d + 1.0)/theta
            return rated(xp, t0, 2.0*t1*t15), rated(xp, t0, t1*(chord(xp, d, theta) - t15))

        def no(delta, part, t2, theta, whole):
            t6 = lead(xp, theta, whole, part)
            t7 = whole + 1.0
            t8 = touching(xp, theta, whole, part)
            t9 = xp.cos(t8)
            t10 = t9/t7
            t8 = xp.sin(t8)
            t12 = t8 - 0.5*t10
            t13 = between(xp, part, straight(xp, t10, t12, whole, t2),
                straight(xp, t10, t12, t7, t2))
            t16 = xp.sin(t2)
            t17 = xp.cos(t2)
            t17 = delta/(0.5*t13 + 0.5*square_root(xp, part*(1.0 - part)*
                (4.0*(t8*t8)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7)) + t13*t13))
            return rated(xp, t6, t10*t17), rated(xp, t6, t12*t17)

        return select(xp, part == 0.0, yes, (d, delta, t, theta), no,
            (delta, part, t, theta, whole))

    return guarded(xp, work, "theta delta d", 2, math.nan, theta, delta, d)


@by_value
def max_passive_stiffness(delta, d):
    """the passive wall of largest stiffness, and its worst angle theta = omega T.

    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta,
    angle on the unit circle, omega T [1].
    Domain: delta >= 0, d >= 0.
    NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, delta, d = arrays(delta, d)

    def work(delta, d):
        whole = xp.floor(d)
        part = d - whole
        t = 2.0*delta

        def yes(d, delta, t3):
            t0 = d + 1.0
            t1 = 3.141592653589793/t0
            t2 = xp.tan(0.25*t1)
            t1 = 0.5*t1
            return t2*t3, delta*(1.0/(t0*xp.sin(t1)) - t2), t1

        def no(delta, part, t3, whole):
            t7 = passive_angle(xp, whole, part)
            cosine, sine = next_wave(xp, whole, t7)
            t9 = whole + 1.0
            cosine_2, sine_3 = next_wave(xp, t9, t7)
            t10 = cosine + part*(cosine_2 - cosine)
            t12 = 0.5*t7
            t13 = xp.sin(t12)
            t14 = (t13*t13)
            t15 = 2.0*whole
            t16 = t15 + 2.0
            sine_2 = sin_next(xp, t16, t12)
            t13 = 2.0*sine_2*t13
            t10 = (
                (t10*t13 + t14*(4.0*part + 4.0*whole + 4.0))/
                (t10*xp.cos(t7) + (part + t9)*(part*(sine_3 - sine) + sine + 1.0)*xp.sin(t7))
            )
            t9 = 2.0*part
            return t10*t3, delta*(t13 - t10*(t14*(t15 + t9) + 1.0))/(t14*(t16 + t9)), t7

        return select(xp, part == 0.0, yes, (d, delta, t), no, (delta, part, t, whole))

    return guarded(xp, work, "delta d", 3, math.nan, delta, d)


@by_value
def linear_limit(beta, delta, d):
    """the stiffness alpha at which the linear condition is an equality.

    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0.
    NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, beta, delta, d = arrays(beta, delta, d)

    def work(beta, delta, d):
        return (beta + delta)/(d + 0.5)

    return guarded(xp, work, "beta delta d", 1, math.nan, beta, delta, d)
