# Written by `symhaptic kernels` from the stable forms; do not edit.
"""Passivity and stability of haptic walls."""

import functools
import math
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


class Limits(NamedTuple):
    """What an argument may be at most."""

    size: float
    periods: float
    angle: float
    """The last float before pi."""


DOUBLE = Limits(1e+70, 1000000000000000.0, 3.141592653589793)
SINGLE = Limits(100000000.0, 1000000.0, 3.141592502593994)


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
    where = {} if is_lazy_array(given[0]) else {"device": device(given[0])}
    return xp, *(
        xp.astype(v, kind, copy=False)
        if is_array_api_obj(v) and not isinstance(v, numpy.generic)
        else xp.asarray(v, dtype=kind, **where)
        for v in values
    )


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


def guarded(xp, work, inside, count, outside, *values):
    """The same where all values are ``inside``, elsewhere ``count`` results that are ``outside``.

    ``work`` gets no value that is outside.
    """
    return _broadcast(xp, functools.partial(_inside, xp, work, inside, count, outside), values)


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


def select(xp, condition, yes, yes_values, no, no_values):
    """``yes`` of its values where the condition holds, else ``no``; each only where it counts.

    Where numbers cannot be looked at, both are computed everywhere, of 1 where they do not count.
    """
    like = (*yes_values, *no_values)[0]
    if deferred(condition):
        one = _rows(xp, like, yes(*(xp.where(condition, v, 1.0) for v in yes_values)))
        two = _rows(xp, like, no(*(xp.where(condition, 1.0, v) for v in no_values)))
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


def cos_series_single(xp, w):
    """The same in single precision."""
    square = (w*w)
    b3 = 1.1470745597729725e-11*square + 2.755731922398589e-07
    b2 = 2.08767569878681e-09*square + 2.48015873015873e-05
    b3 = b3*square + 0.001388888888888889
    b2 = b2*square + 0.041666666666666664
    return b2 + b3*w


def cos_series(xp, w):
    """(cosh(sqrt(w)) - 1 - w/2)/w^2"""
    if w.dtype == xp.float32:
        return cos_series_single(xp, w)
    square = (w*w)
    b7 = 8.896791392450574e-22*square + 1.5619206968586225e-16
    b6 = 4.110317623312165e-19*square + 4.779477332387385e-14
    b7 = b7*square + 1.1470745597729725e-11
    b6 = b6*square + 2.08767569878681e-09
    b7 = b7*square + 2.755731922398589e-07
    b6 = b6*square + 2.48015873015873e-05
    b7 = b7*square + 0.001388888888888889
    b6 = b6*square + 0.041666666666666664
    return b6 + b7*w


def decay_series_single(xp, x):
    """The same in single precision."""
    square = (x*x)
    b7 = 2.08767569878681e-09*square + 2.755731922398589e-07
    b6 = 2.505210838544172e-08*square + 2.7557319223985893e-06
    b7 = b7*square + 2.48015873015873e-05
    b6 = b6*square + 0.0001984126984126984
    b7 = b7*square + 0.001388888888888889
    b6 = b6*square + 0.008333333333333333
    b7 = b7*square + 0.041666666666666664
    b6 = b6*square + 0.16666666666666666
    return b6 - b7*x


def decay_series(xp, x):
    """((1 - exp(-x))/x - 1 + x/2)/x^2"""
    if x.dtype == xp.float32:
        return decay_series_single(xp, x)
    square = (x*x)
    b14 = 8.22063524662433e-18*square + 2.8114572543455206e-15
    b13 = 1.5619206968586225e-16*square + 4.779477332387385e-14
    b14 = b14*square + 7.647163731819816e-13
    b13 = b13*square + 1.1470745597729725e-11
    b14 = b14*square + 1.6059043836821613e-10
    b13 = b13*square + 2.08767569878681e-09
    b14 = b14*square + 2.505210838544172e-08
    b13 = b13*square + 2.755731922398589e-07
    b14 = b14*square + 2.7557319223985893e-06
    b13 = b13*square + 2.48015873015873e-05
    b14 = b14*square + 0.0001984126984126984
    b13 = b13*square + 0.001388888888888889
    b14 = b14*square + 0.008333333333333333
    b13 = b13*square + 0.041666666666666664
    b14 = b14*square + 0.16666666666666666
    return b14 - b13*x


def halves(xp, y):
    """A number as two of half its digits, whose products are exact.

    Of the bits of NumPy's doubles the last 27 are cut off, which takes half of the time; then the
    product of the lower halves is rounded, far below what counts.
    """
    if isinstance(y, numpy.ndarray) and y.dtype == xp.float64:
        high = (y.view(numpy.int64) & -(2**27)).view(numpy.float64)
    else:
        big = (134217729.0 if y.dtype == xp.float64 else 4097.0)*y
        high = big - (big - y)
    return high, y - high


def product_error(product, one, two):
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


def fall_series_single(xp, gamma, delta):
    """The same in single precision."""

    def yes(delta, gamma):
        b6 = 2.7557319223985893e-06*delta + 2.48015873015873e-05
        b5 = b6*delta - 2.7557319223985893e-06*gamma + 0.0001984126984126984
        b6 = b5*delta - b6*gamma + 0.001388888888888889
        total = b6*delta
        delta_halves = halves(xp, delta)
        b6_halves = halves(xp, b6)
        lost = product_error(total, delta_halves, b6_halves)
        total2 = b5*gamma
        gamma_halves = halves(xp, gamma)
        b5_halves = halves(xp, b5)
        lost2 = product_error(total2, gamma_halves, b5_halves)
        total3 = total - total2
        back = total3 - total
        rest = total3 - back
        one = total - rest
        two = -back - total2
        lost3 = one + two
        total2 = total3 + 0.008333333333333333
        back = total2 - total3
        rest = total2 - back
        one = total3 - rest
        two = 0.008333333333333333 - back
        lost4 = one + two
        low = lost - lost2 + lost3 + lost4
        total3 = delta*total2
        total2_halves = halves(xp, total2)
        lost4 = delta*low + product_error(total3, delta_halves, total2_halves)
        total = b6*gamma
        lost3 = product_error(total, gamma_halves, b6_halves)
        total7 = total3 - total
        back = total7 - total3
        rest = total7 - back
        one = total3 - rest
        two = -back - total
        lost2 = one + two
        total = total7 + 0.041666666666666664
        back = total - total7
        rest = total - back
        one = total7 - rest
        two = 0.041666666666666664 - back
        lost = one + two
        low2 = lost4 - lost3 + lost2 + lost
        total7 = delta*total
        total_halves = halves(xp, total)
        lost = delta*low2 + product_error(total7, delta_halves, total_halves)
        total3 = gamma*total2
        lost2 = gamma*low + product_error(total3, gamma_halves, total2_halves)
        total2 = total7 - total3
        back = total2 - total7
        rest = total2 - back
        one = total7 - rest
        two = -back - total3
        lost3 = one + two
        total3 = total2 + 0.16666666666666666
        back = total3 - total2
        rest = total3 - back
        one = total2 - rest
        two = 0.16666666666666666 - back
        lost4 = one + two
        low = lost3 - lost2 + lost4 + lost
        total2 = delta*total3
        total3_halves = halves(xp, total3)
        lost = delta*low + product_error(total2, delta_halves, total3_halves)
        total3 = gamma*total
        lost4 = gamma*low2 + product_error(total3, gamma_halves, total_halves)
        total = total2 - total3
        back = total - total2
        rest = total - back
        one = total2 - rest
        two = -back - total3
        lost3 = one + two
        total3 = total
        back = total3 - total
        rest = total3 - back
        one = total - rest
        two = -back
        lost2 = one + two
        low2 = lost - lost4 + lost3 + lost2
        return low2 + total3

    def no(delta, gamma):
        b17 = 4.110317623312165e-19*delta + 8.22063524662433e-18
        b16 = b17*delta - 4.110317623312165e-19*gamma + 1.5619206968586225e-16
        b17 = b16*delta - b17*gamma + 2.8114572543455206e-15
        b16 = b17*delta - b16*gamma + 4.779477332387385e-14
        b17 = b16*delta - b17*gamma + 7.647163731819816e-13
        b16 = b17*delta - b16*gamma + 1.1470745597729725e-11
        b17 = b16*delta - b17*gamma + 1.6059043836821613e-10
        b16 = b17*delta - b16*gamma + 2.08767569878681e-09
        b17 = b16*delta - b17*gamma + 2.505210838544172e-08
        b16 = b17*delta - b16*gamma + 2.755731922398589e-07
        b17 = b16*delta - b17*gamma + 2.7557319223985893e-06
        b16 = b17*delta - b16*gamma + 2.48015873015873e-05
        b17 = b16*delta - b17*gamma + 0.0001984126984126984
        b16 = b17*delta - b16*gamma + 0.001388888888888889
        total17 = b16*delta
        delta_halves = halves(xp, delta)
        b16_halves = halves(xp, b16)
        lost17 = product_error(total17, delta_halves, b16_halves)
        total18 = b17*gamma
        gamma_halves = halves(xp, gamma)
        b17_halves = halves(xp, b17)
        lost18 = product_error(total18, gamma_halves, b17_halves)
        total19 = total17 - total18
        back9 = total19 - total17
        rest9 = total19 - back9
        one9 = total17 - rest9
        two9 = -back9 - total18
        lost19 = one9 + two9
        total18 = total19 + 0.008333333333333333
        back9 = total18 - total19
        rest9 = total18 - back9
        one9 = total19 - rest9
        two9 = 0.008333333333333333 - back9
        lost20 = one9 + two9
        low5 = lost17 - lost18 + lost19 + lost20
        total19 = delta*total18
        total18_halves = halves(xp, total18)
        lost20 = delta*low5 + product_error(total19, delta_halves, total18_halves)
        total17 = b16*gamma
        lost19 = product_error(total17, gamma_halves, b16_halves)
        total23 = total19 - total17
        back9 = total23 - total19
        rest9 = total23 - back9
        one9 = total19 - rest9
        two9 = -back9 - total17
        lost18 = one9 + two9
        total17 = total23 + 0.041666666666666664
        back9 = total17 - total23
        rest9 = total17 - back9
        one9 = total23 - rest9
        two9 = 0.041666666666666664 - back9
        lost17 = one9 + two9
        low6 = lost20 - lost19 + lost18 + lost17
        total23 = delta*total17
        total17_halves = halves(xp, total17)
        lost17 = delta*low6 + product_error(total23, delta_halves, total17_halves)
        total19 = gamma*total18
        lost18 = gamma*low5 + product_error(total19, gamma_halves, total18_halves)
        total18 = total23 - total19
        back9 = total18 - total23
        rest9 = total18 - back9
        one9 = total23 - rest9
        two9 = -back9 - total19
        lost19 = one9 + two9
        total19 = total18 + 0.16666666666666666
        back9 = total19 - total18
        rest9 = total19 - back9
        one9 = total18 - rest9
        two9 = 0.16666666666666666 - back9
        lost20 = one9 + two9
        low5 = lost17 - lost18 + lost19 + lost20
        total18 = delta*total19
        total19_halves = halves(xp, total19)
        lost20 = delta*low5 + product_error(total18, delta_halves, total19_halves)
        total19 = gamma*total17
        lost19 = gamma*low6 + product_error(total19, gamma_halves, total17_halves)
        total17 = total18 - total19
        back9 = total17 - total18
        rest9 = total17 - back9
        one9 = total18 - rest9
        two9 = -back9 - total19
        lost18 = one9 + two9
        total19 = total17
        back9 = total19 - total17
        rest9 = total19 - back9
        one9 = total17 - rest9
        two9 = -back9
        lost17 = one9 + two9
        low6 = lost20 - lost19 + lost18 + lost17
        return low6 + total19

    return select(xp, (delta < 0.125) & (xp.abs(gamma) < 0.00390625), yes, (delta, gamma), no,
        (delta, gamma))


def fall_series(xp, gamma, delta):
    """divided difference of exp at 0, p and q, less 1/2"""
    if gamma.dtype == xp.float32:
        return fall_series_single(xp, gamma, delta)

    def yes(delta, gamma):
        b10 = 1.6059043836821613e-10*delta + 2.08767569878681e-09
        b9 = b10*delta - 1.6059043836821613e-10*gamma + 2.505210838544172e-08
        b10 = b9*delta - b10*gamma + 2.755731922398589e-07
        b9 = b10*delta - b9*gamma + 2.7557319223985893e-06
        b10 = b9*delta - b10*gamma + 2.48015873015873e-05
        b9 = b10*delta - b9*gamma + 0.0001984126984126984
        b10 = b9*delta - b10*gamma + 0.001388888888888889
        total = b10*delta
        delta_halves = halves(xp, delta)
        b10_halves = halves(xp, b10)
        lost = product_error(total, delta_halves, b10_halves)
        total2 = b9*gamma
        gamma_halves = halves(xp, gamma)
        b9_halves = halves(xp, b9)
        lost2 = product_error(total2, gamma_halves, b9_halves)
        total3 = total - total2
        back = total3 - total
        rest = total3 - back
        one = total - rest
        two = -back - total2
        lost3 = one + two
        total2 = total3 + 0.008333333333333333
        back = total2 - total3
        rest = total2 - back
        one = total3 - rest
        two = 0.008333333333333333 - back
        lost4 = one + two
        low = lost - lost2 + lost3 + lost4
        total3 = delta*total2
        total2_halves = halves(xp, total2)
        lost4 = delta*low + product_error(total3, delta_halves, total2_halves)
        total = b10*gamma
        lost3 = product_error(total, gamma_halves, b10_halves)
        total7 = total3 - total
        back = total7 - total3
        rest = total7 - back
        one = total3 - rest
        two = -back - total
        lost2 = one + two
        total = total7 + 0.041666666666666664
        back = total - total7
        rest = total - back
        one = total7 - rest
        two = 0.041666666666666664 - back
        lost = one + two
        low2 = lost4 - lost3 + lost2 + lost
        total7 = delta*total
        total_halves = halves(xp, total)
        lost = delta*low2 + product_error(total7, delta_halves, total_halves)
        total3 = gamma*total2
        lost2 = gamma*low + product_error(total3, gamma_halves, total2_halves)
        total2 = total7 - total3
        back = total2 - total7
        rest = total2 - back
        one = total7 - rest
        two = -back - total3
        lost3 = one + two
        total3 = total2 + 0.16666666666666666
        back = total3 - total2
        rest = total3 - back
        one = total2 - rest
        two = 0.16666666666666666 - back
        lost4 = one + two
        low = lost3 - lost2 + lost4 + lost
        total2 = delta*total3
        total3_halves = halves(xp, total3)
        lost = delta*low + product_error(total2, delta_halves, total3_halves)
        total3 = gamma*total
        lost4 = gamma*low2 + product_error(total3, gamma_halves, total_halves)
        total = total2 - total3
        back = total - total2
        rest = total - back
        one = total2 - rest
        two = -back - total3
        lost3 = one + two
        total3 = total
        back = total3 - total
        rest = total3 - back
        one = total - rest
        two = -back
        lost2 = one + two
        low2 = lost - lost4 + lost3 + lost2
        return low2 + total3

    def no(delta, gamma):
        b25 = 3.279889237069838e-30*delta + 9.183689863795546e-29
        b24 = b25*delta - 3.279889237069838e-30*gamma + 2.4795962632247976e-27
        b25 = b24*delta - b25*gamma + 6.446950284384474e-26
        b24 = b25*delta - b24*gamma + 1.6117375710961184e-24
        b25 = b24*delta - b25*gamma + 3.868170170630684e-23
        b24 = b25*delta - b24*gamma + 8.896791392450574e-22
        b25 = b24*delta - b25*gamma + 1.9572941063391263e-20
        b24 = b25*delta - b24*gamma + 4.110317623312165e-19
        b25 = b24*delta - b25*gamma + 8.22063524662433e-18
        b24 = b25*delta - b24*gamma + 1.5619206968586225e-16
        b25 = b24*delta - b25*gamma + 2.8114572543455206e-15
        b24 = b25*delta - b24*gamma + 4.779477332387385e-14
        b25 = b24*delta - b25*gamma + 7.647163731819816e-13
        b24 = b25*delta - b24*gamma + 1.1470745597729725e-11
        b25 = b24*delta - b25*gamma + 1.6059043836821613e-10
        b24 = b25*delta - b24*gamma + 2.08767569878681e-09
        b25 = b24*delta - b25*gamma + 2.505210838544172e-08
        b24 = b25*delta - b24*gamma + 2.755731922398589e-07
        b25 = b24*delta - b25*gamma + 2.7557319223985893e-06
        b24 = b25*delta - b24*gamma + 2.48015873015873e-05
        b25 = b24*delta - b25*gamma + 0.0001984126984126984
        b24 = b25*delta - b24*gamma + 0.001388888888888889
        total17 = b24*delta
        delta_halves = halves(xp, delta)
        b24_halves = halves(xp, b24)
        lost17 = product_error(total17, delta_halves, b24_halves)
        total18 = b25*gamma
        gamma_halves = halves(xp, gamma)
        b25_halves = halves(xp, b25)
        lost18 = product_error(total18, gamma_halves, b25_halves)
        total19 = total17 - total18
        back9 = total19 - total17
        rest9 = total19 - back9
        one9 = total17 - rest9
        two9 = -back9 - total18
        lost19 = one9 + two9
        total18 = total19 + 0.008333333333333333
        back9 = total18 - total19
        rest9 = total18 - back9
        one9 = total19 - rest9
        two9 = 0.008333333333333333 - back9
        lost20 = one9 + two9
        low5 = lost17 - lost18 + lost19 + lost20
        total19 = delta*total18
        total18_halves = halves(xp, total18)
        lost20 = delta*low5 + product_error(total19, delta_halves, total18_halves)
        total17 = b24*gamma
        lost19 = product_error(total17, gamma_halves, b24_halves)
        total23 = total19 - total17
        back9 = total23 - total19
        rest9 = total23 - back9
        one9 = total19 - rest9
        two9 = -back9 - total17
        lost18 = one9 + two9
        total17 = total23 + 0.041666666666666664
        back9 = total17 - total23
        rest9 = total17 - back9
        one9 = total23 - rest9
        two9 = 0.041666666666666664 - back9
        lost17 = one9 + two9
        low6 = lost20 - lost19 + lost18 + lost17
        total23 = delta*total17
        total17_halves = halves(xp, total17)
        lost17 = delta*low6 + product_error(total23, delta_halves, total17_halves)
        total19 = gamma*total18
        lost18 = gamma*low5 + product_error(total19, gamma_halves, total18_halves)
        total18 = total23 - total19
        back9 = total18 - total23
        rest9 = total18 - back9
        one9 = total23 - rest9
        two9 = -back9 - total19
        lost19 = one9 + two9
        total19 = total18 + 0.16666666666666666
        back9 = total19 - total18
        rest9 = total19 - back9
        one9 = total18 - rest9
        two9 = 0.16666666666666666 - back9
        lost20 = one9 + two9
        low5 = lost17 - lost18 + lost19 + lost20
        total18 = delta*total19
        total19_halves = halves(xp, total19)
        lost20 = delta*low5 + product_error(total18, delta_halves, total19_halves)
        total19 = gamma*total17
        lost19 = gamma*low6 + product_error(total19, gamma_halves, total17_halves)
        total17 = total18 - total19
        back9 = total17 - total18
        rest9 = total17 - back9
        one9 = total18 - rest9
        two9 = -back9 - total19
        lost18 = one9 + two9
        total19 = total17
        back9 = total19 - total17
        rest9 = total19 - back9
        one9 = total17 - rest9
        two9 = -back9
        lost17 = one9 + two9
        low6 = lost20 - lost19 + lost18 + lost17
        return low6 + total19

    return select(xp, (delta < 0.125) & (xp.abs(gamma) < 0.00390625), yes, (delta, gamma), no,
        (delta, gamma))


def rise_series_single(xp, h, w):
    """The same in single precision."""

    def yes(h, w):
        b6 = 2.7557319223985893e-06*h + 2.48015873015873e-05
        e5 = 2.7557319223985893e-06*w + 0.0001984126984126984
        b6 = b6*h + e5
        e4 = 2.48015873015873e-05*w + 0.001388888888888889
        b6 = b6*h + e4
        e5 = e5*w + 0.008333333333333333
        b6 = b6*h + e5
        e4 = e4*w + 0.041666666666666664
        b6 = b6*h + e4
        e5 = e5*w + 0.16666666666666666
        b6 = b6*h + e5
        e4 = e4*w
        b6 = b6*h + e4
        return b6

    def no(h, w):
        b17 = 4.110317623312165e-19*h + 8.22063524662433e-18
        e16 = 4.110317623312165e-19*w + 1.5619206968586225e-16
        b17 = b17*h + e16
        e15 = 8.22063524662433e-18*w + 2.8114572543455206e-15
        b17 = b17*h + e15
        e16 = e16*w + 4.779477332387385e-14
        b17 = b17*h + e16
        e15 = e15*w + 7.647163731819816e-13
        b17 = b17*h + e15
        e16 = e16*w + 1.1470745597729725e-11
        b17 = b17*h + e16
        e15 = e15*w + 1.6059043836821613e-10
        b17 = b17*h + e15
        e16 = e16*w + 2.08767569878681e-09
        b17 = b17*h + e16
        e15 = e15*w + 2.505210838544172e-08
        b17 = b17*h + e15
        e16 = e16*w + 2.755731922398589e-07
        b17 = b17*h + e16
        e15 = e15*w + 2.7557319223985893e-06
        b17 = b17*h + e15
        e16 = e16*w + 2.48015873015873e-05
        b17 = b17*h + e16
        e15 = e15*w + 0.0001984126984126984
        b17 = b17*h + e15
        e16 = e16*w + 0.001388888888888889
        b17 = b17*h + e16
        e15 = e15*w + 0.008333333333333333
        b17 = b17*h + e15
        e16 = e16*w + 0.041666666666666664
        b17 = b17*h + e16
        e15 = e15*w + 0.16666666666666666
        b17 = b17*h + e15
        e16 = e16*w
        b17 = b17*h + e16
        return b17

    return select(xp, (h < 0.0625) & (xp.abs(w) < 0.00390625), yes, (h, w), no, (h, w))


def rise_series(xp, h, w):
    """divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2"""
    if h.dtype == xp.float32:
        return rise_series_single(xp, h, w)

    def yes(h, w):
        b10 = 1.6059043836821613e-10*h + 2.08767569878681e-09
        e9 = 1.6059043836821613e-10*w + 2.505210838544172e-08
        b10 = b10*h + e9
        e8 = 2.08767569878681e-09*w + 2.755731922398589e-07
        b10 = b10*h + e8
        e9 = e9*w + 2.7557319223985893e-06
        b10 = b10*h + e9
        e8 = e8*w + 2.48015873015873e-05
        b10 = b10*h + e8
        e9 = e9*w + 0.0001984126984126984
        b10 = b10*h + e9
        e8 = e8*w + 0.001388888888888889
        b10 = b10*h + e8
        e9 = e9*w + 0.008333333333333333
        b10 = b10*h + e9
        e8 = e8*w + 0.041666666666666664
        b10 = b10*h + e8
        e9 = e9*w + 0.16666666666666666
        b10 = b10*h + e9
        e8 = e8*w
        b10 = b10*h + e8
        return b10

    def no(h, w):
        b25 = 3.279889237069838e-30*h + 9.183689863795546e-29
        e24 = 3.279889237069838e-30*w + 2.4795962632247976e-27
        b25 = b25*h + e24
        e23 = 9.183689863795546e-29*w + 6.446950284384474e-26
        b25 = b25*h + e23
        e24 = e24*w + 1.6117375710961184e-24
        b25 = b25*h + e24
        e23 = e23*w + 3.868170170630684e-23
        b25 = b25*h + e23
        e24 = e24*w + 8.896791392450574e-22
        b25 = b25*h + e24
        e23 = e23*w + 1.9572941063391263e-20
        b25 = b25*h + e23
        e24 = e24*w + 4.110317623312165e-19
        b25 = b25*h + e24
        e23 = e23*w + 8.22063524662433e-18
        b25 = b25*h + e23
        e24 = e24*w + 1.5619206968586225e-16
        b25 = b25*h + e24
        e23 = e23*w + 2.8114572543455206e-15
        b25 = b25*h + e23
        e24 = e24*w + 4.779477332387385e-14
        b25 = b25*h + e24
        e23 = e23*w + 7.647163731819816e-13
        b25 = b25*h + e23
        e24 = e24*w + 1.1470745597729725e-11
        b25 = b25*h + e24
        e23 = e23*w + 1.6059043836821613e-10
        b25 = b25*h + e23
        e24 = e24*w + 2.08767569878681e-09
        b25 = b25*h + e24
        e23 = e23*w + 2.505210838544172e-08
        b25 = b25*h + e23
        e24 = e24*w + 2.755731922398589e-07
        b25 = b25*h + e24
        e23 = e23*w + 2.7557319223985893e-06
        b25 = b25*h + e23
        e24 = e24*w + 2.48015873015873e-05
        b25 = b25*h + e24
        e23 = e23*w + 0.0001984126984126984
        b25 = b25*h + e23
        e24 = e24*w + 0.001388888888888889
        b25 = b25*h + e24
        e23 = e23*w + 0.008333333333333333
        b25 = b25*h + e23
        e24 = e24*w + 0.041666666666666664
        b25 = b25*h + e24
        e23 = e23*w + 0.16666666666666666
        b25 = b25*h + e23
        e24 = e24*w
        b25 = b25*h + e24
        return b25

    return select(xp, (h < 0.0625) & (xp.abs(w) < 0.00390625), yes, (h, w), no, (h, w))


def sin_series_single(xp, w):
    """The same in single precision."""
    square = (w*w)
    b3 = 1.6059043836821613e-10*square + 2.7557319223985893e-06
    b2 = 2.505210838544172e-08*square + 0.0001984126984126984
    b3 = b3*square + 0.008333333333333333
    b2 = b2*square + 0.16666666666666666
    return b2 + b3*w


def sin_series(xp, w):
    """(sinh(sqrt(w))/sqrt(w) - 1)/w"""
    if w.dtype == xp.float32:
        return sin_series_single(xp, w)
    square = (w*w)
    b7 = 1.9572941063391263e-20*square + 2.8114572543455206e-15
    b6 = 8.22063524662433e-18*square + 7.647163731819816e-13
    b7 = b7*square + 1.6059043836821613e-10
    b6 = b6*square + 2.505210838544172e-08
    b7 = b7*square + 2.7557319223985893e-06
    b6 = b6*square + 0.0001984126984126984
    b7 = b7*square + 0.008333333333333333
    b6 = b6*square + 0.16666666666666666
    return b6 + b7*w


def fall_rise_swing_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half, lost2, total2):
            square2 = total2
            envelope = xp.exp(-half)
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back32 = total54 - 1.0
            lost54 = -back32 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total55 = curved5 + total54
            back32 = total55 - total54
            lost55 = curved5 - back32
            mean_low6 = lost54 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back32 = total55 - 1.0
            lost54 = -back32 - total54
            fall_low6 = lost54 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost54 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost54 = 2.0*lost54*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back32 = total54 - rest15
            rest16 = total54 - back32
            one14 = rest15 - rest16
            two14 = 0.5 - back32
            lost55 = one14 + two14
            total61 = total55*total54
            total55_halves = halves(xp, total55)
            total54_halves = halves(xp, total54)
            lost55 = lost55*total55 + product_error(total61, total55_halves, total54_halves)
            half2 = half
            given5 = 0.5*half2
            total55 = 1.0 - 0.5*given5
            back32 = total55 - 1.0
            lost532 = -back32 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total542 = curved5 + total55
            back32 = total542 - total55
            lost542 = curved5 - back32
            mean_low6 = lost532 + lost542
            total55 = given5*total542
            given5_halves = halves(xp, given5)
            total542_halves = halves(xp, total542)
            lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
            total542 = 1.0 - total55
            back32 = total542 - 1.0
            lost532 = -back32 - total55
            fall_low6 = lost532 - lost542
            total55 = (total542*total542)
            total542_halves = halves(xp, total542)
            lost532 = 2.0*fall_low6*total542 + product_error(total55, total542_halves,
                total542_halves)
            rest16 = rise_series(xp, half2, total2)
            total542 = rest16 + 0.5
            back32 = total542 - rest16
            rest15 = total542 - back32
            one14 = rest16 - rest15
            two14 = 0.5 - back32
            lost542 = one14 + two14
            total592 = total55*total542
            total55_halves = halves(xp, total55)
            total542_halves = halves(xp, total542)
            lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

            def yes(lost2, square2):
                given3 = square2
                total20 = 0.5*given3 + 1.0
                back13 = total20 - 1.0
                lost20 = 0.5*given3 - back13
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total21 = curved3 + total20
                back13 = total21 - total20
                lost21 = curved3 - back13
                even_low = 0.5*lost2 + lost20 + lost21
                even = total21
                return even, even_low

            def no(lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no, (lost2, total2))

            total55 = envelope*even
            envelope_halves = halves(xp, envelope)
            even_halves = halves(xp, even)
            lost212 = envelope*even_low2 + product_error(total55, envelope_halves, even_halves)
            fall_of = lost54*total54 + lost55 + total61
            rise_of = lost532*total542 + lost542 + total592
            swing_of = 2.0*lost212 + 2.0*total55
            return fall_of, rise_of, swing_of

        def no(gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma

            def yes(lost2, square2):
                given3 = square2
                total20 = 0.5*given3 + 1.0
                back13 = total20 - 1.0
                lost20 = 0.5*given3 - back13
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total21 = curved3 + total20
                back13 = total21 - total20
                lost21 = curved3 - back13
                even_low = 0.5*lost2 + lost20 + lost21
                even = total21
                return even, even_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total212 = envelope*even
            envelope_halves = halves(xp, envelope)
            even_halves = halves(xp, even)
            lost212 = envelope*even_low2 + product_error(total212, envelope_halves, even_halves)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total29 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number3_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost29 = product_error(total29, turns_halves, number3_halves)
            total30 = 1.1614863524300745e-06*turns
            number4_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost30 = product_error(total30, turns_halves, number4_halves)
            total31 = -total2 - total29
            back18 = total2 + total31
            rest6 = total31 - back18
            one5 = -rest6 - total2
            two5 = -back18 - total29
            lost31 = one5 + two5
            total29 = total31 - lost29
            back18 = total29 - total31
            rest6 = total29 - back18
            one5 = total31 - rest6
            two5 = -back18 - lost29
            lost29 = one5 + two5
            total31 = total29 - total30
            back18 = total31 - total29
            rest6 = total31 - back18
            one5 = total29 - rest6
            two5 = -back18 - total30
            lost33 = one5 + two5
            total30 = total31 - lost2
            back18 = total30 - total31
            rest6 = total30 - back18
            one5 = total31 - rest6
            two5 = -back18 - lost2
            lost34 = one5 + two5
            low = lost31 - lost30 + lost29 + lost33 + lost34 + 1.1704736640094811e-14*turns
            total31 = low + total30
            total29 = 6.2831854820251465*count
            total37 = root + total29
            whole3 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole3
            far = (total38*total38)

            def yes(count, half, lost2, lost212, low, root, size, stiff, total212, total34,
                total35, total36, total37, total38, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back22 = total35 - total34
                rest10 = total35 - back22
                one9 = total34 - rest10
                two9 = low - back22
                lost35 = one9 + two9
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                lost36 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                back22 = total37 - root
                rest10 = total37 - back22
                one9 = root - rest10
                two9 = total36 - back22
                lost37 = one9 + two9
                both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                left = total35 - total38*whole3
                total38_halves = halves(xp, total38)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total38*whole3, total38_halves, whole3_halves)
                left = left - both_low*total38 + lost35
                lost35 = left/whole3
                eta = total38
                eta_low = lost35
                total39 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                cos_series_of2 = cos_series(xp, -total39)
                bent2 = cos_series_of2*(total39*total39)
                total40 = 0.5*total39 - bent2
                back22 = total40 - 0.5*total39
                lost37 = -back22 - bent2
                sin_series_of2 = sin_series(xp, -total39)
                total41 = 1.0 - sin_series_of2*total39
                back22 = total41 - 1.0
                lost36 = -back22 - sin_series_of2*total39
                lift_low = 0.5*lost35*total41 + lost37
                total39 = eta*total41
                total41_halves = halves(xp, total41)
                lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                some2 = root
                total41 = total39/some2
                left = total39 - some2*total41
                total41_halves = halves(xp, total41)
                some2_halves = halves(xp, some2)
                left = left - product_error(total41*some2, total41_halves, some2_halves)
                left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                lost36 = left/some2
                given4 = half
                total39 = 1.0 - 0.5*given4
                back22 = total39 - 1.0
                lost37 = -back22 - 0.5*given4
                decay_series_of3 = decay_series(xp, given4)
                curved4 = decay_series_of3*(given4*given4)
                total45 = curved4 + total39
                back22 = total45 - total39
                lost35 = curved4 - back22
                mean_low5 = lost37 + lost35
                total39 = given4*total45
                given4_halves = halves(xp, given4)
                total45_halves = halves(xp, total45)
                lost35 = given4*mean_low5 + product_error(total39, given4_halves, total45_halves)
                total47 = 1.0 - total39
                back22 = total47 - 1.0
                lost37 = -back22 - total39
                fall_low5 = lost37 - lost35
                total39 = total45 - total41
                back22 = total39 - total45
                rest10 = total39 - back22
                one9 = total45 - rest10
                two9 = -back22 - total41
                lost37 = one9 + two9
                total49 = given4*total39
                total39_halves = halves(xp, total39)
                lost37 = (
                    given4*(lost37 - lost36 + mean_low5) +
                    product_error(total49, given4_halves, total39_halves)
                )
                total39 = total40 - total49
                back22 = total39 - total40
                rest10 = total39 - back22
                one9 = total40 - rest10
                two9 = -back22 - total49
                lost35 = one9 + two9
                low2 = lift_low - lost37 + lost35
                total49 = low2 + total39
                back22 = total49 - total39
                rest10 = total49 - back22
                one9 = total39 - rest10
                two9 = low2 - back22
                lost35 = one9 + two9
                total39 = total47*total49
                total47_halves = halves(xp, total47)
                total49_halves = halves(xp, total49)
                lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                low2 = fall_low5*total49 + lost35
                total49 = total39/stiff
                left = total39 - stiff*total49
                total49_halves = halves(xp, total49)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                left = left + low2
                lost35 = left/stiff
                total39 = total41*total47
                lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                total482 = total45 - total39
                back22 = total482 - total45
                rest10 = total482 - back22
                one9 = total45 - rest10
                two9 = -back22 - total39
                lost37 = one9 + two9
                low2 = lost37 - fall_low5*total41 - lost36 + mean_low5
                total41 = given4*total482
                total482_halves = halves(xp, total482)
                lost37 = given4*low2 + product_error(total41, given4_halves, total482_halves)
                total482 = total40*total47
                total40_halves = halves(xp, total40)
                lost36 = lift_low*total47 + product_error(total482, total47_halves, total40_halves)
                total47 = total41 + total482
                back22 = total47 - total41
                rest10 = total47 - back22
                one9 = total41 - rest10
                two9 = total482 - back22
                lost512 = one9 + two9
                low2 = fall_low5*total40 + lost37 + lost36 + lost512
                total40 = total47/stiff
                left = total47 - stiff*total40
                total40_halves = halves(xp, total40)
                left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                left = left + low2
                lost512 = left/stiff
                fall_of = lost35 + total49
                rise_of = lost512 + total40
                swing_of = 2.0*lost212 + 2.0*total212
                return fall_of, rise_of, swing_of

            def no(envelope, even, even_low2, half, lost2, lost212, root, size, square2, stiff,
                total212):

                def yes(lost2, square2):
                    given3 = square2
                    sin_series_of = sin_series(xp, given3)
                    bent = given3*sin_series_of
                    total22 = bent + 1.0
                    back15 = total22 - 1.0
                    lost22 = bent - back15
                    odd_low = 0.16666666666666666*lost2 + lost22
                    odd = total22
                    return odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total23 = sine/some
                    left = sine - some*total23
                    total23_halves = halves(xp, total23)
                    some_halves = halves(xp, some)
                    left = left - product_error(total23*some, total23_halves, some_halves)
                    left = cosine*root_low + left - root_low*total23
                    lost23 = left/some
                    odd = total23
                    odd_low2 = lost23
                    return odd, odd_low2

                odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, root, size))

                total24 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost24 = half*odd_low2 + product_error(total24, half_halves, odd_halves)
                total25 = total24 - even
                back16 = total25 - total24
                rest4 = total25 - back16
                one3 = total24 - rest4
                two3 = -back16 - even
                lost25 = one3 + two3
                total26 = envelope + total25
                back16 = total26 - total25
                rest4 = total26 - back16
                one3 = total25 - rest4
                two3 = envelope - back16
                lost26 = one3 + two3
                total25 = envelope*total26
                envelope_halves = halves(xp, envelope)
                total26_halves = halves(xp, total26)
                lost26 = (
                    envelope*(lost24 - even_low2 + lost25 + lost26) +
                    product_error(total25, envelope_halves, total26_halves)
                )
                total26 = total25/stiff
                left16 = total25 - stiff*total26
                total26_halves = halves(xp, total26)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total26*stiff, total26_halves, stiff_halves)
                left16 = left16 + lost26
                lost26 = left16/stiff
                total25 = even + total24
                back16 = total25 - even
                rest4 = total25 - back16
                one3 = even - rest4
                two3 = total24 - back16
                lost25 = one3 + two3
                total24 = envelope*total25
                total25_halves = halves(xp, total25)
                lost25 = (
                    envelope*(even_low2 + lost24 + lost25) +
                    product_error(total24, envelope_halves, total25_halves)
                )
                total25 = 1.0 - total24
                back16 = total25 - 1.0
                lost24 = -back16 - total24
                total24 = total25/stiff
                left16 = total25 - stiff*total24
                total24_halves = halves(xp, total24)
                left16 = left16 - product_error(total24*stiff, total24_halves, stiff_halves)
                left16 = left16 - lost25 + lost24
                lost24 = left16/stiff
                fall_of = lost26 + total26
                rise_of = lost24 + total24
                swing_of = 2.0*lost212 + 2.0*total212
                return fall_of, rise_of, swing_of

            fall_of, rise_of, swing_of = select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75),
                yes, (count, half, lost2, lost212, low, root, size, stiff, total212, total30,
                total31, total29, total37, total38, whole3), no,
                (envelope, even, even_low2, half, lost2, lost212, root, size, square2, stiff,
                total212))

            return fall_of, rise_of, swing_of

        fall_of, rise_of, swing_of = select(xp, reach < 0.5625, yes,
            (delta, gamma, half, lost2, total2), no, (gamma, half, lost2, total2))

        return fall_of, rise_of, swing_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half, lost2, root, size, total2, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back3 = total54 - 1.0
            lost3 = -back3 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total55 = curved5 + total54
            back3 = total55 - total54
            lost55 = curved5 - back3
            mean_low6 = lost3 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back3 = total55 - 1.0
            lost3 = -back3 - total54
            fall_low6 = lost3 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost3 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost3 = 2.0*lost3*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back3 = total54 - rest15
            rest16 = total54 - back3
            one14 = rest15 - rest16
            two14 = 0.5 - back3
            lost55 = one14 + two14
            total61 = total55*total54
            total55_halves = halves(xp, total55)
            total54_halves = halves(xp, total54)
            lost55 = lost55*total55 + product_error(total61, total55_halves, total54_halves)
            half2 = half
            given5 = 0.5*half2
            total55 = 1.0 - 0.5*given5
            back3 = total55 - 1.0
            lost532 = -back3 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total542 = curved5 + total55
            back3 = total542 - total55
            lost542 = curved5 - back3
            mean_low6 = lost532 + lost542
            total55 = given5*total542
            given5_halves = halves(xp, given5)
            total542_halves = halves(xp, total542)
            lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
            total542 = 1.0 - total55
            back3 = total542 - 1.0
            lost532 = -back3 - total55
            fall_low6 = lost532 - lost542
            total55 = (total542*total542)
            total542_halves = halves(xp, total542)
            lost532 = 2.0*fall_low6*total542 + product_error(total55, total542_halves,
                total542_halves)
            rest16 = rise_series(xp, half2, total2)
            total542 = rest16 + 0.5
            back3 = total542 - rest16
            rest15 = total542 - back3
            one14 = rest16 - rest15
            two14 = 0.5 - back3
            lost542 = one14 + two14
            total592 = total55*total542
            total55_halves = halves(xp, total55)
            total542_halves = halves(xp, total542)
            lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                return fall_, fall_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                fall_ = sunk
                fall_low2 = sunk_low
                return fall_, fall_low2

            fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total55 = fall2 + 1.0
            back3 = total55 - 1.0
            lost222 = fall2 - back3
            total232 = fall_*total55
            fall__halves = halves(xp, fall_)
            total55_halves = halves(xp, total55)
            lost222 = (
                fall_*(fall_low4 + lost222) + product_error(total232, fall__halves, total55_halves)
            )
            creep2 = fall_low2*total55 + lost222 + total232
            fall_of = lost3*total54 + lost55 + total61
            rise_of = lost532*total542 + lost542 + total592
            swing_of = creep2
            return fall_of, rise_of, swing_of

        def no(gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            mean_halves = halves(xp, mean)
            lost3 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost3
            total17 = mean2 - total16
            back3 = total17 - mean2
            rest3 = total17 - back3
            one2 = mean2 - rest3
            two2 = -back3 - total16
            lost3 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost3 + mean_low4 - p_low*total16 - pulled_low
            lost3 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost3 = fall_*lost3 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost3 + total17
            total17 = fall_*mean2
            mean2_halves = halves(xp, mean2)
            lost3 = fall_*mean_low4 + product_error(total17, fall__halves, mean2_halves)
            pulled_low = fall_low2*mean2 + lost3
            total16 = mean - total17
            back3 = total16 - mean
            rest3 = total16 - back3
            one2 = mean - rest3
            two2 = -back3 - total17
            lost3 = one2 + two2
            total17 = total16/whole
            left = total16 - total17*whole
            total17_halves = halves(xp, total17)
            left = left - product_error(total17*whole, total17_halves, whole_halves)
            left = left + lost3 + mean_low2 - p_low*total17 - pulled_low
            lost3 = left/whole
            total16 = fall2 + 1.0
            back3 = total16 - 1.0
            lost222 = fall2 - back3
            total232 = fall_*total16
            total16_halves = halves(xp, total16)
            lost222 = (
                fall_*(fall_low4 + lost222) + product_error(total232, fall__halves, total16_halves)
            )
            creep2 = fall_low2*total16 + lost222 + total232
            fall_of = creep_
            rise_of = lost3 + total17
            swing_of = creep2
            return fall_of, rise_of, swing_of

        fall_of, rise_of, swing_of = select(xp, reach < 0.5625, yes,
            (delta, gamma, half, lost2, root, size, total2, total3), no,
            (gamma, half, lost2, root, size, total3))

        return fall_of, rise_of, swing_of

    fall_of, rise_of, swing_of = select(xp, total2 < 0.0, yes, (delta, gamma, half, lost, total2),
        no, (delta, gamma, half, lost, total2))

    return fall_of, rise_of, swing_of


def fall_rise_swing(xp, gamma, delta):
    """n0, the same device with its time reversed, times exp(-delta); n1, how far a unit force
    moves the device in a period; a, the sum of the sampled device's poles
    """
    if gamma.dtype == xp.float32:
        return fall_rise_swing_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half, lost2, total2):
            square2 = total2
            envelope = xp.exp(-half)
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back32 = total54 - 1.0
            lost54 = -back32 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total55 = curved5 + total54
            back32 = total55 - total54
            lost55 = curved5 - back32
            mean_low6 = lost54 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back32 = total55 - 1.0
            lost54 = -back32 - total54
            fall_low6 = lost54 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost54 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost54 = 2.0*lost54*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back32 = total54 - rest15
            rest16 = total54 - back32
            one14 = rest15 - rest16
            two14 = 0.5 - back32
            lost55 = one14 + two14
            total61 = total55*total54
            total55_halves = halves(xp, total55)
            total54_halves = halves(xp, total54)
            lost55 = lost55*total55 + product_error(total61, total55_halves, total54_halves)
            half2 = half
            given5 = 0.5*half2
            total55 = 1.0 - 0.5*given5
            back32 = total55 - 1.0
            lost532 = -back32 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total542 = curved5 + total55
            back32 = total542 - total55
            lost542 = curved5 - back32
            mean_low6 = lost532 + lost542
            total55 = given5*total542
            given5_halves = halves(xp, given5)
            total542_halves = halves(xp, total542)
            lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
            total542 = 1.0 - total55
            back32 = total542 - 1.0
            lost532 = -back32 - total55
            fall_low6 = lost532 - lost542
            total55 = (total542*total542)
            total542_halves = halves(xp, total542)
            lost532 = 2.0*fall_low6*total542 + product_error(total55, total542_halves,
                total542_halves)
            rest16 = rise_series(xp, half2, total2)
            total542 = rest16 + 0.5
            back32 = total542 - rest16
            rest15 = total542 - back32
            one14 = rest16 - rest15
            two14 = 0.5 - back32
            lost542 = one14 + two14
            total592 = total55*total542
            total55_halves = halves(xp, total55)
            total542_halves = halves(xp, total542)
            lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

            def yes(lost2, square2):
                given3 = square2
                total20 = 0.5*given3 + 1.0
                back13 = total20 - 1.0
                lost20 = 0.5*given3 - back13
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total21 = curved3 + total20
                back13 = total21 - total20
                lost21 = curved3 - back13
                even_low = 0.5*lost2 + lost20 + lost21
                even = total21
                return even, even_low

            def no(lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no, (lost2, total2))

            total55 = envelope*even
            envelope_halves = halves(xp, envelope)
            even_halves = halves(xp, even)
            lost212 = envelope*even_low2 + product_error(total55, envelope_halves, even_halves)
            fall_of = lost54*total54 + lost55 + total61
            rise_of = lost532*total542 + lost542 + total592
            swing_of = 2.0*lost212 + 2.0*total55
            return fall_of, rise_of, swing_of

        def no(gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma

            def yes(lost2, square2):
                given3 = square2
                total20 = 0.5*given3 + 1.0
                back13 = total20 - 1.0
                lost20 = 0.5*given3 - back13
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total21 = curved3 + total20
                back13 = total21 - total20
                lost21 = curved3 - back13
                even_low = 0.5*lost2 + lost20 + lost21
                even = total21
                return even, even_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total212 = envelope*even
            envelope_halves = halves(xp, envelope)
            even_halves = halves(xp, even)
            lost212 = envelope*even_low2 + product_error(total212, envelope_halves, even_halves)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total29 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number3_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost29 = product_error(total29, turns_halves, number3_halves)
            total30 = 2.5061182034958845e-15*turns
            number4_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost30 = product_error(total30, turns_halves, number4_halves)
            total31 = -total2 - total29
            back18 = total2 + total31
            rest6 = total31 - back18
            one5 = -rest6 - total2
            two5 = -back18 - total29
            lost31 = one5 + two5
            total29 = total31 - lost29
            back18 = total29 - total31
            rest6 = total29 - back18
            one5 = total31 - rest6
            two5 = -back18 - lost29
            lost29 = one5 + two5
            total31 = total29 - total30
            back18 = total31 - total29
            rest6 = total31 - back18
            one5 = total29 - rest6
            two5 = -back18 - total30
            lost33 = one5 + two5
            total30 = total31 - lost2
            back18 = total30 - total31
            rest6 = total30 - back18
            one5 = total31 - rest6
            two5 = -back18 - lost2
            lost34 = one5 + two5
            low = lost31 - lost30 + lost29 + lost33 + lost34 - 1.4920070805839235e-31*turns
            total31 = low + total30
            total29 = 6.283185307179586*count
            total37 = root + total29
            whole3 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole3
            far = (total38*total38)

            def yes(count, half, lost2, lost212, low, root, size, stiff, total212, total34,
                total35, total36, total37, total38, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back22 = total35 - total34
                rest10 = total35 - back22
                one9 = total34 - rest10
                two9 = low - back22
                lost35 = one9 + two9
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                lost36 = product_error(count*6.283185307179586, count_halves, number2_halves)
                back22 = total37 - root
                rest10 = total37 - back22
                one9 = root - rest10
                two9 = total36 - back22
                lost37 = one9 + two9
                both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                left = total35 - total38*whole3
                total38_halves = halves(xp, total38)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total38*whole3, total38_halves, whole3_halves)
                left = left - both_low*total38 + lost35
                lost35 = left/whole3
                eta = total38
                eta_low = lost35
                total39 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                cos_series_of2 = cos_series(xp, -total39)
                bent2 = cos_series_of2*(total39*total39)
                total40 = 0.5*total39 - bent2
                back22 = total40 - 0.5*total39
                lost37 = -back22 - bent2
                sin_series_of2 = sin_series(xp, -total39)
                total41 = 1.0 - sin_series_of2*total39
                back22 = total41 - 1.0
                lost36 = -back22 - sin_series_of2*total39
                lift_low = 0.5*lost35*total41 + lost37
                total39 = eta*total41
                total41_halves = halves(xp, total41)
                lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                some2 = root
                total41 = total39/some2
                left = total39 - some2*total41
                total41_halves = halves(xp, total41)
                some2_halves = halves(xp, some2)
                left = left - product_error(total41*some2, total41_halves, some2_halves)
                left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                lost36 = left/some2
                given4 = half
                total39 = 1.0 - 0.5*given4
                back22 = total39 - 1.0
                lost37 = -back22 - 0.5*given4
                decay_series_of3 = decay_series(xp, given4)
                curved4 = decay_series_of3*(given4*given4)
                total45 = curved4 + total39
                back22 = total45 - total39
                lost35 = curved4 - back22
                mean_low5 = lost37 + lost35
                total39 = given4*total45
                given4_halves = halves(xp, given4)
                total45_halves = halves(xp, total45)
                lost35 = given4*mean_low5 + product_error(total39, given4_halves, total45_halves)
                total47 = 1.0 - total39
                back22 = total47 - 1.0
                lost37 = -back22 - total39
                fall_low5 = lost37 - lost35
                total39 = total45 - total41
                back22 = total39 - total45
                rest10 = total39 - back22
                one9 = total45 - rest10
                two9 = -back22 - total41
                lost37 = one9 + two9
                total49 = given4*total39
                total39_halves = halves(xp, total39)
                lost37 = (
                    given4*(lost37 - lost36 + mean_low5) +
                    product_error(total49, given4_halves, total39_halves)
                )
                total39 = total40 - total49
                back22 = total39 - total40
                rest10 = total39 - back22
                one9 = total40 - rest10
                two9 = -back22 - total49
                lost35 = one9 + two9
                low2 = lift_low - lost37 + lost35
                total49 = low2 + total39
                back22 = total49 - total39
                rest10 = total49 - back22
                one9 = total39 - rest10
                two9 = low2 - back22
                lost35 = one9 + two9
                total39 = total47*total49
                total47_halves = halves(xp, total47)
                total49_halves = halves(xp, total49)
                lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                low2 = fall_low5*total49 + lost35
                total49 = total39/stiff
                left = total39 - stiff*total49
                total49_halves = halves(xp, total49)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                left = left + low2
                lost35 = left/stiff
                total39 = total41*total47
                lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                total482 = total45 - total39
                back22 = total482 - total45
                rest10 = total482 - back22
                one9 = total45 - rest10
                two9 = -back22 - total39
                lost37 = one9 + two9
                low2 = lost37 - fall_low5*total41 - lost36 + mean_low5
                total41 = given4*total482
                total482_halves = halves(xp, total482)
                lost37 = given4*low2 + product_error(total41, given4_halves, total482_halves)
                total482 = total40*total47
                total40_halves = halves(xp, total40)
                lost36 = lift_low*total47 + product_error(total482, total47_halves, total40_halves)
                total47 = total41 + total482
                back22 = total47 - total41
                rest10 = total47 - back22
                one9 = total41 - rest10
                two9 = total482 - back22
                lost512 = one9 + two9
                low2 = fall_low5*total40 + lost37 + lost36 + lost512
                total40 = total47/stiff
                left = total47 - stiff*total40
                total40_halves = halves(xp, total40)
                left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                left = left + low2
                lost512 = left/stiff
                fall_of = lost35 + total49
                rise_of = lost512 + total40
                swing_of = 2.0*lost212 + 2.0*total212
                return fall_of, rise_of, swing_of

            def no(envelope, even, even_low2, half, lost2, lost212, root, size, square2, stiff,
                total212):

                def yes(lost2, square2):
                    given3 = square2
                    sin_series_of = sin_series(xp, given3)
                    bent = given3*sin_series_of
                    total22 = bent + 1.0
                    back15 = total22 - 1.0
                    lost22 = bent - back15
                    odd_low = 0.16666666666666666*lost2 + lost22
                    odd = total22
                    return odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total23 = sine/some
                    left = sine - some*total23
                    total23_halves = halves(xp, total23)
                    some_halves = halves(xp, some)
                    left = left - product_error(total23*some, total23_halves, some_halves)
                    left = cosine*root_low + left - root_low*total23
                    lost23 = left/some
                    odd = total23
                    odd_low2 = lost23
                    return odd, odd_low2

                odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, root, size))

                total24 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost24 = half*odd_low2 + product_error(total24, half_halves, odd_halves)
                total25 = total24 - even
                back16 = total25 - total24
                rest4 = total25 - back16
                one3 = total24 - rest4
                two3 = -back16 - even
                lost25 = one3 + two3
                total26 = envelope + total25
                back16 = total26 - total25
                rest4 = total26 - back16
                one3 = total25 - rest4
                two3 = envelope - back16
                lost26 = one3 + two3
                total25 = envelope*total26
                envelope_halves = halves(xp, envelope)
                total26_halves = halves(xp, total26)
                lost26 = (
                    envelope*(lost24 - even_low2 + lost25 + lost26) +
                    product_error(total25, envelope_halves, total26_halves)
                )
                total26 = total25/stiff
                left16 = total25 - stiff*total26
                total26_halves = halves(xp, total26)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total26*stiff, total26_halves, stiff_halves)
                left16 = left16 + lost26
                lost26 = left16/stiff
                total25 = even + total24
                back16 = total25 - even
                rest4 = total25 - back16
                one3 = even - rest4
                two3 = total24 - back16
                lost25 = one3 + two3
                total24 = envelope*total25
                total25_halves = halves(xp, total25)
                lost25 = (
                    envelope*(even_low2 + lost24 + lost25) +
                    product_error(total24, envelope_halves, total25_halves)
                )
                total25 = 1.0 - total24
                back16 = total25 - 1.0
                lost24 = -back16 - total24
                total24 = total25/stiff
                left16 = total25 - stiff*total24
                total24_halves = halves(xp, total24)
                left16 = left16 - product_error(total24*stiff, total24_halves, stiff_halves)
                left16 = left16 - lost25 + lost24
                lost24 = left16/stiff
                fall_of = lost26 + total26
                rise_of = lost24 + total24
                swing_of = 2.0*lost212 + 2.0*total212
                return fall_of, rise_of, swing_of

            fall_of, rise_of, swing_of = select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75),
                yes, (count, half, lost2, lost212, low, root, size, stiff, total212, total30,
                total31, total29, total37, total38, whole3), no,
                (envelope, even, even_low2, half, lost2, lost212, root, size, square2, stiff,
                total212))

            return fall_of, rise_of, swing_of

        fall_of, rise_of, swing_of = select(xp, reach < 0.5625, yes,
            (delta, gamma, half, lost2, total2), no, (gamma, half, lost2, total2))

        return fall_of, rise_of, swing_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half, lost2, root, size, total2, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back3 = total54 - 1.0
            lost3 = -back3 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total55 = curved5 + total54
            back3 = total55 - total54
            lost55 = curved5 - back3
            mean_low6 = lost3 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back3 = total55 - 1.0
            lost3 = -back3 - total54
            fall_low6 = lost3 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost3 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost3 = 2.0*lost3*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back3 = total54 - rest15
            rest16 = total54 - back3
            one14 = rest15 - rest16
            two14 = 0.5 - back3
            lost55 = one14 + two14
            total61 = total55*total54
            total55_halves = halves(xp, total55)
            total54_halves = halves(xp, total54)
            lost55 = lost55*total55 + product_error(total61, total55_halves, total54_halves)
            half2 = half
            given5 = 0.5*half2
            total55 = 1.0 - 0.5*given5
            back3 = total55 - 1.0
            lost532 = -back3 - 0.5*given5
            decay_series_of4 = decay_series(xp, given5)
            curved5 = decay_series_of4*(given5*given5)
            total542 = curved5 + total55
            back3 = total542 - total55
            lost542 = curved5 - back3
            mean_low6 = lost532 + lost542
            total55 = given5*total542
            given5_halves = halves(xp, given5)
            total542_halves = halves(xp, total542)
            lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
            total542 = 1.0 - total55
            back3 = total542 - 1.0
            lost532 = -back3 - total55
            fall_low6 = lost532 - lost542
            total55 = (total542*total542)
            total542_halves = halves(xp, total542)
            lost532 = 2.0*fall_low6*total542 + product_error(total55, total542_halves,
                total542_halves)
            rest16 = rise_series(xp, half2, total2)
            total542 = rest16 + 0.5
            back3 = total542 - rest16
            rest15 = total542 - back3
            one14 = rest16 - rest15
            two14 = 0.5 - back3
            lost542 = one14 + two14
            total592 = total55*total542
            total55_halves = halves(xp, total55)
            total542_halves = halves(xp, total542)
            lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                return fall_, fall_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                fall_ = sunk
                fall_low2 = sunk_low
                return fall_, fall_low2

            fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total55 = fall2 + 1.0
            back3 = total55 - 1.0
            lost222 = fall2 - back3
            total232 = fall_*total55
            fall__halves = halves(xp, fall_)
            total55_halves = halves(xp, total55)
            lost222 = (
                fall_*(fall_low4 + lost222) + product_error(total232, fall__halves, total55_halves)
            )
            creep2 = fall_low2*total55 + lost222 + total232
            fall_of = lost3*total54 + lost55 + total61
            rise_of = lost532*total542 + lost542 + total592
            swing_of = creep2
            return fall_of, rise_of, swing_of

        def no(gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            mean_halves = halves(xp, mean)
            lost3 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost3
            total17 = mean2 - total16
            back3 = total17 - mean2
            rest3 = total17 - back3
            one2 = mean2 - rest3
            two2 = -back3 - total16
            lost3 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost3 + mean_low4 - p_low*total16 - pulled_low
            lost3 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost3 = fall_*lost3 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost3 + total17
            total17 = fall_*mean2
            mean2_halves = halves(xp, mean2)
            lost3 = fall_*mean_low4 + product_error(total17, fall__halves, mean2_halves)
            pulled_low = fall_low2*mean2 + lost3
            total16 = mean - total17
            back3 = total16 - mean
            rest3 = total16 - back3
            one2 = mean - rest3
            two2 = -back3 - total17
            lost3 = one2 + two2
            total17 = total16/whole
            left = total16 - total17*whole
            total17_halves = halves(xp, total17)
            left = left - product_error(total17*whole, total17_halves, whole_halves)
            left = left + lost3 + mean_low2 - p_low*total17 - pulled_low
            lost3 = left/whole
            total16 = fall2 + 1.0
            back3 = total16 - 1.0
            lost222 = fall2 - back3
            total232 = fall_*total16
            total16_halves = halves(xp, total16)
            lost222 = (
                fall_*(fall_low4 + lost222) + product_error(total232, fall__halves, total16_halves)
            )
            creep2 = fall_low2*total16 + lost222 + total232
            fall_of = creep_
            rise_of = lost3 + total17
            swing_of = creep2
            return fall_of, rise_of, swing_of

        fall_of, rise_of, swing_of = select(xp, reach < 0.5625, yes,
            (delta, gamma, half, lost2, root, size, total2, total3), no,
            (gamma, half, lost2, root, size, total3))

        return fall_of, rise_of, swing_of

    fall_of, rise_of, swing_of = select(xp, total2 < 0.0, yes, (delta, gamma, half, lost, total2),
        no, (delta, gamma, half, lost, total2))

    return fall_of, rise_of, swing_of


def fall_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total

    def yes(delta, gamma, half, rest2, total, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half):
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back32 = total54 - 1.0
            lost54 = -back32 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total55 = curved5 + total54
            back32 = total55 - total54
            lost55 = curved5 - back32
            mean_low6 = lost54 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back32 = total55 - 1.0
            lost54 = -back32 - total54
            fall_low6 = lost54 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost54 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost54 = 2.0*lost54*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back32 = total54 - rest15
            rest16 = total54 - back32
            one14 = rest15 - rest16
            two14 = 0.5 - back32
            lost55 = one14 + two14
            envelope2 = total55
            total55 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost55 = envelope2*lost55 + product_error(total55, envelope2_halves, total54_halves)
            return lost54*total54 + lost55 + total55

        def no(gamma, half, rest2, total, total2):
            back2 = total2 - total
            lost2 = rest2 - back2
            size = xp.abs(total2)
            root = square_root(xp, size)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total29 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number1_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost29 = product_error(total29, turns_halves, number1_halves)
            total30 = 1.1614863524300745e-06*turns
            number2_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost30 = product_error(total30, turns_halves, number2_halves)
            total31 = -total2 - total29
            back2 = total2 + total31
            rest6 = total31 - back2
            one5 = -rest6 - total2
            two5 = -back2 - total29
            lost31 = one5 + two5
            total29 = total31 - lost29
            back2 = total29 - total31
            rest6 = total29 - back2
            one5 = total31 - rest6
            two5 = -back2 - lost29
            lost29 = one5 + two5
            total31 = total29 - total30
            back2 = total31 - total29
            rest6 = total31 - back2
            one5 = total29 - rest6
            two5 = -back2 - total30
            lost33 = one5 + two5
            total30 = total31 - lost2
            back2 = total30 - total31
            rest6 = total30 - back2
            one5 = total31 - rest6
            two5 = -back2 - lost2
            lost34 = one5 + two5
            low = lost31 - lost30 + lost29 + lost33 + lost34 + 1.1704736640094811e-14*turns
            total31 = low + total30
            total29 = 6.2831854820251465*count
            total37 = root + total29
            whole3 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole3
            far = (total38*total38)

            def yes(count, gamma, half, lost2, low, root, size, total34, total35, total36, total37,
                total38, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                stiff = gamma
                back22 = total35 - total34
                rest10 = total35 - back22
                one9 = total34 - rest10
                two9 = low - back22
                lost35 = one9 + two9
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                lost36 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                back22 = total37 - root
                rest10 = total37 - back22
                one9 = root - rest10
                two9 = total36 - back22
                lost37 = one9 + two9
                both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                left = total35 - total38*whole3
                total38_halves = halves(xp, total38)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total38*whole3, total38_halves, whole3_halves)
                left = left - both_low*total38 + lost35
                lost35 = left/whole3
                eta = total38
                eta_low = lost35
                total39 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                bent2 = (total39*total39)*cos_series(xp, -total39)
                total40 = 0.5*total39 - bent2
                back22 = total40 - 0.5*total39
                lost37 = -back22 - bent2
                total41 = 1.0 - total39*sin_series(xp, -total39)
                back22 = total41 - 1.0
                lost36 = -back22 - total39*sin_series(xp, -total39)
                lift_low = 0.5*lost35*total41 + lost37
                total39 = eta*total41
                total41_halves = halves(xp, total41)
                lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                some2 = root
                total41 = total39/some2
                left = total39 - some2*total41
                total41_halves = halves(xp, total41)
                some2_halves = halves(xp, some2)
                left = left - product_error(total41*some2, total41_halves, some2_halves)
                left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                lost36 = left/some2
                given4 = half
                total39 = 1.0 - 0.5*given4
                back22 = total39 - 1.0
                lost37 = -back22 - 0.5*given4
                curved4 = (given4*given4)*decay_series(xp, given4)
                total45 = curved4 + total39
                back22 = total45 - total39
                lost35 = curved4 - back22
                mean_low5 = lost37 + lost35
                total39 = given4*total45
                given4_halves = halves(xp, given4)
                total45_halves = halves(xp, total45)
                lost35 = given4*mean_low5 + product_error(total39, given4_halves, total45_halves)
                total47 = 1.0 - total39
                back22 = total47 - 1.0
                lost37 = -back22 - total39
                fall_low5 = lost37 - lost35
                total39 = total45 - total41
                back22 = total39 - total45
                rest10 = total39 - back22
                one9 = total45 - rest10
                two9 = -back22 - total41
                lost37 = one9 + two9
                total41 = given4*total39
                total39_halves = halves(xp, total39)
                lost37 = (
                    given4*(lost37 - lost36 + mean_low5) +
                    product_error(total41, given4_halves, total39_halves)
                )
                total39 = total40 - total41
                back22 = total39 - total40
                rest10 = total39 - back22
                one9 = total40 - rest10
                two9 = -back22 - total41
                lost36 = one9 + two9
                low2 = lift_low - lost37 + lost36
                total41 = low2 + total39
                back22 = total41 - total39
                rest10 = total41 - back22
                one9 = total39 - rest10
                two9 = low2 - back22
                lost36 = one9 + two9
                total39 = total47*total41
                total47_halves = halves(xp, total47)
                total41_halves = halves(xp, total41)
                lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                low2 = fall_low5*total41 + lost36
                total41 = total39/stiff
                left = total39 - stiff*total41
                total41_halves = halves(xp, total41)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total41*stiff, total41_halves, stiff_halves)
                left = left + low2
                lost36 = left/stiff
                return lost36 + total41

            def no(gamma, half, lost2, root, size, total2):
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma

                def yes(lost2, square2):
                    given3 = square2
                    total20 = 0.5*given3 + 1.0
                    back13 = total20 - 1.0
                    lost20 = 0.5*given3 - back13
                    curved3 = (given3*given3)*cos_series(xp, given3)
                    total21 = curved3 + total20
                    back13 = total21 - total20
                    lost21 = curved3 - back13
                    even_low = 0.5*lost2 + lost20 + lost21
                    bent = given3*sin_series(xp, given3)
                    total20 = bent + 1.0
                    back13 = total20 - 1.0
                    lost21 = bent - back13
                    odd_low = 0.16666666666666666*lost2 + lost21
                    even = total21
                    odd = total20
                    return even, even_low, odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total23 = sine/some
                    left = sine - some*total23
                    total23_halves = halves(xp, total23)
                    some_halves = halves(xp, some)
                    left = left - product_error(total23*some, total23_halves, some_halves)
                    left = cosine*root_low + left - root_low*total23
                    lost23 = left/some
                    even = cosine
                    even_low2 = -root_low*sine
                    odd = total23
                    odd_low2 = lost23
                    return even, even_low2, odd, odd_low2

                even, even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2),
                    no, (lost2, root, size))

                total24 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost24 = half*odd_low2 + product_error(total24, half_halves, odd_halves)
                total25 = total24 - even
                back16 = total25 - total24
                rest4 = total25 - back16
                one3 = total24 - rest4
                two3 = -back16 - even
                lost25 = one3 + two3
                total24 = envelope + total25
                back16 = total24 - total25
                rest4 = total24 - back16
                one3 = total25 - rest4
                two3 = envelope - back16
                lost26 = one3 + two3
                total25 = envelope*total24
                envelope_halves = halves(xp, envelope)
                total24_halves = halves(xp, total24)
                lost26 = (
                    envelope*(lost24 - even_low2 + lost25 + lost26) +
                    product_error(total25, envelope_halves, total24_halves)
                )
                total24 = total25/stiff
                left16 = total25 - stiff*total24
                total24_halves = halves(xp, total24)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total24*stiff, total24_halves, stiff_halves)
                left16 = left16 + lost26
                lost26 = left16/stiff
                return lost26 + total24

            return select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, gamma, half, lost2, low, root, size, total30, total31, total29, total37,
                total38, whole3), no, (gamma, half, lost2, root, size, total2))

        return select(xp, reach < 0.5625, yes, (delta, gamma, half), no,
            (gamma, half, rest2, total, total2))

    def no(delta, gamma, half, rest2, total, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half):
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back32 = total54 - 1.0
            lost54 = -back32 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total55 = curved5 + total54
            back32 = total55 - total54
            lost55 = curved5 - back32
            mean_low6 = lost54 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back32 = total55 - 1.0
            lost54 = -back32 - total54
            fall_low6 = lost54 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost54 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost54 = 2.0*lost54*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back32 = total54 - rest15
            rest16 = total54 - back32
            one14 = rest15 - rest16
            two14 = 0.5 - back32
            lost55 = one14 + two14
            envelope2 = total55
            total55 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost55 = envelope2*lost55 + product_error(total55, envelope2_halves, total54_halves)
            return lost54*total54 + lost55 + total55

        def no(gamma, half, rest2, root, size, total, total2, total3):
            back2 = total2 - total
            lost2 = rest2 - back2
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back2 = total3 - half
            lost2 = root - back2
            p_low = lost2 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate = q
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                curved = (given*given)*decay_series(xp, given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, rate < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                curved2 = (given2*given2)*decay_series(xp, given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            mean_halves = halves(xp, mean)
            lost2 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost2
            total17 = mean2 - total16
            back2 = total17 - mean2
            rest3 = total17 - back2
            one2 = mean2 - rest3
            two2 = -back2 - total16
            lost2 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost2 + mean_low4 - p_low*total16 - pulled_low
            lost2 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost2 = fall_*lost2 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost2 + total17
            return creep_

        return select(xp, reach < 0.5625, yes, (delta, gamma, half), no,
            (gamma, half, rest2, root, size, total, total2, total3))

    return select(xp, total2 < 0.0, yes, (delta, gamma, half, rest, total, total2), no,
        (delta, gamma, half, rest, total, total2))


def fall(xp, gamma, delta):
    """n0, the same device with its time reversed, times exp(-delta)"""
    if gamma.dtype == xp.float32:
        return fall_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total

    def yes(delta, gamma, half, rest2, total, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half):
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back32 = total54 - 1.0
            lost54 = -back32 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total55 = curved5 + total54
            back32 = total55 - total54
            lost55 = curved5 - back32
            mean_low6 = lost54 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back32 = total55 - 1.0
            lost54 = -back32 - total54
            fall_low6 = lost54 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost54 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost54 = 2.0*lost54*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back32 = total54 - rest15
            rest16 = total54 - back32
            one14 = rest15 - rest16
            two14 = 0.5 - back32
            lost55 = one14 + two14
            envelope2 = total55
            total55 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost55 = envelope2*lost55 + product_error(total55, envelope2_halves, total54_halves)
            return lost54*total54 + lost55 + total55

        def no(gamma, half, rest2, total, total2):
            back2 = total2 - total
            lost2 = rest2 - back2
            size = xp.abs(total2)
            root = square_root(xp, size)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total29 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number1_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost29 = product_error(total29, turns_halves, number1_halves)
            total30 = 2.5061182034958845e-15*turns
            number2_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost30 = product_error(total30, turns_halves, number2_halves)
            total31 = -total2 - total29
            back2 = total2 + total31
            rest6 = total31 - back2
            one5 = -rest6 - total2
            two5 = -back2 - total29
            lost31 = one5 + two5
            total29 = total31 - lost29
            back2 = total29 - total31
            rest6 = total29 - back2
            one5 = total31 - rest6
            two5 = -back2 - lost29
            lost29 = one5 + two5
            total31 = total29 - total30
            back2 = total31 - total29
            rest6 = total31 - back2
            one5 = total29 - rest6
            two5 = -back2 - total30
            lost33 = one5 + two5
            total30 = total31 - lost2
            back2 = total30 - total31
            rest6 = total30 - back2
            one5 = total31 - rest6
            two5 = -back2 - lost2
            lost34 = one5 + two5
            low = lost31 - lost30 + lost29 + lost33 + lost34 - 1.4920070805839235e-31*turns
            total31 = low + total30
            total29 = 6.283185307179586*count
            total37 = root + total29
            whole3 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole3
            far = (total38*total38)

            def yes(count, gamma, half, lost2, low, root, size, total34, total35, total36, total37,
                total38, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                stiff = gamma
                back22 = total35 - total34
                rest10 = total35 - back22
                one9 = total34 - rest10
                two9 = low - back22
                lost35 = one9 + two9
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                lost36 = product_error(count*6.283185307179586, count_halves, number2_halves)
                back22 = total37 - root
                rest10 = total37 - back22
                one9 = root - rest10
                two9 = total36 - back22
                lost37 = one9 + two9
                both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                left = total35 - total38*whole3
                total38_halves = halves(xp, total38)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total38*whole3, total38_halves, whole3_halves)
                left = left - both_low*total38 + lost35
                lost35 = left/whole3
                eta = total38
                eta_low = lost35
                total39 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                bent2 = (total39*total39)*cos_series(xp, -total39)
                total40 = 0.5*total39 - bent2
                back22 = total40 - 0.5*total39
                lost37 = -back22 - bent2
                total41 = 1.0 - total39*sin_series(xp, -total39)
                back22 = total41 - 1.0
                lost36 = -back22 - total39*sin_series(xp, -total39)
                lift_low = 0.5*lost35*total41 + lost37
                total39 = eta*total41
                total41_halves = halves(xp, total41)
                lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                some2 = root
                total41 = total39/some2
                left = total39 - some2*total41
                total41_halves = halves(xp, total41)
                some2_halves = halves(xp, some2)
                left = left - product_error(total41*some2, total41_halves, some2_halves)
                left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                lost36 = left/some2
                given4 = half
                total39 = 1.0 - 0.5*given4
                back22 = total39 - 1.0
                lost37 = -back22 - 0.5*given4
                curved4 = (given4*given4)*decay_series(xp, given4)
                total45 = curved4 + total39
                back22 = total45 - total39
                lost35 = curved4 - back22
                mean_low5 = lost37 + lost35
                total39 = given4*total45
                given4_halves = halves(xp, given4)
                total45_halves = halves(xp, total45)
                lost35 = given4*mean_low5 + product_error(total39, given4_halves, total45_halves)
                total47 = 1.0 - total39
                back22 = total47 - 1.0
                lost37 = -back22 - total39
                fall_low5 = lost37 - lost35
                total39 = total45 - total41
                back22 = total39 - total45
                rest10 = total39 - back22
                one9 = total45 - rest10
                two9 = -back22 - total41
                lost37 = one9 + two9
                total41 = given4*total39
                total39_halves = halves(xp, total39)
                lost37 = (
                    given4*(lost37 - lost36 + mean_low5) +
                    product_error(total41, given4_halves, total39_halves)
                )
                total39 = total40 - total41
                back22 = total39 - total40
                rest10 = total39 - back22
                one9 = total40 - rest10
                two9 = -back22 - total41
                lost36 = one9 + two9
                low2 = lift_low - lost37 + lost36
                total41 = low2 + total39
                back22 = total41 - total39
                rest10 = total41 - back22
                one9 = total39 - rest10
                two9 = low2 - back22
                lost36 = one9 + two9
                total39 = total47*total41
                total47_halves = halves(xp, total47)
                total41_halves = halves(xp, total41)
                lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                low2 = fall_low5*total41 + lost36
                total41 = total39/stiff
                left = total39 - stiff*total41
                total41_halves = halves(xp, total41)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total41*stiff, total41_halves, stiff_halves)
                left = left + low2
                lost36 = left/stiff
                return lost36 + total41

            def no(gamma, half, lost2, root, size, total2):
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma

                def yes(lost2, square2):
                    given3 = square2
                    total20 = 0.5*given3 + 1.0
                    back13 = total20 - 1.0
                    lost20 = 0.5*given3 - back13
                    curved3 = (given3*given3)*cos_series(xp, given3)
                    total21 = curved3 + total20
                    back13 = total21 - total20
                    lost21 = curved3 - back13
                    even_low = 0.5*lost2 + lost20 + lost21
                    bent = given3*sin_series(xp, given3)
                    total20 = bent + 1.0
                    back13 = total20 - 1.0
                    lost21 = bent - back13
                    odd_low = 0.16666666666666666*lost2 + lost21
                    even = total21
                    odd = total20
                    return even, even_low, odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total23 = sine/some
                    left = sine - some*total23
                    total23_halves = halves(xp, total23)
                    some_halves = halves(xp, some)
                    left = left - product_error(total23*some, total23_halves, some_halves)
                    left = cosine*root_low + left - root_low*total23
                    lost23 = left/some
                    even = cosine
                    even_low2 = -root_low*sine
                    odd = total23
                    odd_low2 = lost23
                    return even, even_low2, odd, odd_low2

                even, even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2),
                    no, (lost2, root, size))

                total24 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost24 = half*odd_low2 + product_error(total24, half_halves, odd_halves)
                total25 = total24 - even
                back16 = total25 - total24
                rest4 = total25 - back16
                one3 = total24 - rest4
                two3 = -back16 - even
                lost25 = one3 + two3
                total24 = envelope + total25
                back16 = total24 - total25
                rest4 = total24 - back16
                one3 = total25 - rest4
                two3 = envelope - back16
                lost26 = one3 + two3
                total25 = envelope*total24
                envelope_halves = halves(xp, envelope)
                total24_halves = halves(xp, total24)
                lost26 = (
                    envelope*(lost24 - even_low2 + lost25 + lost26) +
                    product_error(total25, envelope_halves, total24_halves)
                )
                total24 = total25/stiff
                left16 = total25 - stiff*total24
                total24_halves = halves(xp, total24)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total24*stiff, total24_halves, stiff_halves)
                left16 = left16 + lost26
                lost26 = left16/stiff
                return lost26 + total24

            return select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, gamma, half, lost2, low, root, size, total30, total31, total29, total37,
                total38, whole3), no, (gamma, half, lost2, root, size, total2))

        return select(xp, reach < 0.5625, yes, (delta, gamma, half), no,
            (gamma, half, rest2, total, total2))

    def no(delta, gamma, half, rest2, total, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half):
            given5 = 0.5*half
            total54 = 1.0 - 0.5*given5
            back32 = total54 - 1.0
            lost54 = -back32 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total55 = curved5 + total54
            back32 = total55 - total54
            lost55 = curved5 - back32
            mean_low6 = lost54 + lost55
            total54 = given5*total55
            given5_halves = halves(xp, given5)
            total55_halves = halves(xp, total55)
            lost55 = given5*mean_low6 + product_error(total54, given5_halves, total55_halves)
            total55 = 1.0 - total54
            back32 = total55 - 1.0
            lost54 = -back32 - total54
            fall_low6 = lost54 - lost55
            total54 = (total55*total55)
            total55_halves = halves(xp, total55)
            lost54 = 2.0*fall_low6*total55 + product_error(total54, total55_halves, total55_halves)
            total55 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost54 = 2.0*lost54*total54 + product_error(total55, total54_halves, total54_halves)
            rest15 = fall_series(xp, gamma, delta)
            total54 = rest15 + 0.5
            back32 = total54 - rest15
            rest16 = total54 - back32
            one14 = rest15 - rest16
            two14 = 0.5 - back32
            lost55 = one14 + two14
            envelope2 = total55
            total55 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost55 = envelope2*lost55 + product_error(total55, envelope2_halves, total54_halves)
            return lost54*total54 + lost55 + total55

        def no(gamma, half, rest2, root, size, total, total2, total3):
            back2 = total2 - total
            lost2 = rest2 - back2
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back2 = total3 - half
            lost2 = root - back2
            p_low = lost2 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate = q
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                curved = (given*given)*decay_series(xp, given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, rate < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                curved2 = (given2*given2)*decay_series(xp, given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            mean_halves = halves(xp, mean)
            lost2 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost2
            total17 = mean2 - total16
            back2 = total17 - mean2
            rest3 = total17 - back2
            one2 = mean2 - rest3
            two2 = -back2 - total16
            lost2 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost2 + mean_low4 - p_low*total16 - pulled_low
            lost2 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost2 = fall_*lost2 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost2 + total17
            return creep_

        return select(xp, reach < 0.5625, yes, (delta, gamma, half), no,
            (gamma, half, rest2, root, size, total, total2, total3))

    return select(xp, total2 < 0.0, yes, (delta, gamma, half, rest, total, total2), no,
        (delta, gamma, half, rest, total, total2))


def rise_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total

    def yes(gamma, half, rest2, total, total2):
        reach = 0.25*gamma

        def yes(half, total2):
            half2 = half
            given5 = 0.5*half2
            total53 = 1.0 - 0.5*given5
            back31 = total53 - 1.0
            lost53 = -back31 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total54 = curved5 + total53
            back31 = total54 - total53
            lost54 = curved5 - back31
            mean_low6 = lost53 + lost54
            total53 = given5*total54
            given5_halves = halves(xp, given5)
            total54_halves = halves(xp, total54)
            lost54 = given5*mean_low6 + product_error(total53, given5_halves, total54_halves)
            total54 = 1.0 - total53
            back31 = total54 - 1.0
            lost53 = -back31 - total53
            fall_low6 = lost53 - lost54
            total53 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost53 = 2.0*fall_low6*total54 + product_error(total53, total54_halves, total54_halves)
            rest13 = rise_series(xp, half2, total2)
            total54 = rest13 + 0.5
            back31 = total54 - rest13
            rest14 = total54 - back31
            one12 = rest13 - rest14
            two12 = 0.5 - back31
            lost54 = one12 + two12
            envelope2 = total53
            total53 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost54 = envelope2*lost54 + product_error(total53, envelope2_halves, total54_halves)
            return lost53*total54 + lost54 + total53

        def no(gamma, half, rest2, total, total2):
            back2 = total2 - total
            lost2 = rest2 - back2
            size = xp.abs(total2)
            root = square_root(xp, size)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total28 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number1_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost28 = product_error(total28, turns_halves, number1_halves)
            total29 = 1.1614863524300745e-06*turns
            number2_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost29 = product_error(total29, turns_halves, number2_halves)
            total30 = -total2 - total28
            back2 = total2 + total30
            rest5 = total30 - back2
            one4 = -rest5 - total2
            two4 = -back2 - total28
            lost30 = one4 + two4
            total28 = total30 - lost28
            back2 = total28 - total30
            rest5 = total28 - back2
            one4 = total30 - rest5
            two4 = -back2 - lost28
            lost28 = one4 + two4
            total30 = total28 - total29
            back2 = total30 - total28
            rest5 = total30 - back2
            one4 = total28 - rest5
            two4 = -back2 - total29
            lost32 = one4 + two4
            total29 = total30 - lost2
            back2 = total29 - total30
            rest5 = total29 - back2
            one4 = total30 - rest5
            two4 = -back2 - lost2
            lost33 = one4 + two4
            low = lost30 - lost29 + lost28 + lost32 + lost33 + 1.1704736640094811e-14*turns
            total30 = low + total29
            total28 = 6.2831854820251465*count
            total36 = root + total28
            whole3 = xp.where(total36 == 0.0, 1.0, total36)
            total37 = total30/whole3
            far = (total37*total37)

            def yes(count, gamma, half, lost2, low, root, size, total33, total34, total35, total36,
                total37, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                stiff = gamma
                back22 = total34 - total33
                rest9 = total34 - back22
                one8 = total33 - rest9
                two8 = low - back22
                lost34 = one8 + two8
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                lost35 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                back22 = total36 - root
                rest9 = total36 - back22
                one8 = root - rest9
                two8 = total35 - back22
                lost36 = one8 + two8
                both_low = lost35 - 1.7484555314695172e-07*count + lost36 + root_low
                left = total34 - total37*whole3
                total37_halves = halves(xp, total37)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total37*whole3, total37_halves, whole3_halves)
                left = left - both_low*total37 + lost34
                lost34 = left/whole3
                eta = total37
                eta_low = lost34
                total38 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost34 = 2.0*eta*eta_low + product_error(total38, eta_halves, eta_halves)
                bent2 = (total38*total38)*cos_series(xp, -total38)
                total39 = 0.5*total38 - bent2
                back22 = total39 - 0.5*total38
                lost36 = -back22 - bent2
                total40 = 1.0 - total38*sin_series(xp, -total38)
                back22 = total40 - 1.0
                lost35 = -back22 - total38*sin_series(xp, -total38)
                lift_low = 0.5*lost34*total40 + lost36
                total38 = eta*total40
                total40_halves = halves(xp, total40)
                lost35 = eta*lost35 + product_error(total38, eta_halves, total40_halves)
                some2 = root
                total40 = total38/some2
                left = total38 - some2*total40
                total40_halves = halves(xp, total40)
                some2_halves = halves(xp, some2)
                left = left - product_error(total40*some2, total40_halves, some2_halves)
                left = eta_low*(1.0 - total39) + left + lost35 - root_low*total40
                lost35 = left/some2
                given4 = half
                total38 = 1.0 - 0.5*given4
                back22 = total38 - 1.0
                lost36 = -back22 - 0.5*given4
                curved4 = (given4*given4)*decay_series(xp, given4)
                total44 = curved4 + total38
                back22 = total44 - total38
                lost34 = curved4 - back22
                mean_low5 = lost36 + lost34
                total38 = given4*total44
                given4_halves = halves(xp, given4)
                total44_halves = halves(xp, total44)
                lost34 = given4*mean_low5 + product_error(total38, given4_halves, total44_halves)
                total46 = 1.0 - total38
                back22 = total46 - 1.0
                lost36 = -back22 - total38
                fall_low5 = lost36 - lost34
                total38 = total40*total46
                total46_halves = halves(xp, total46)
                lost35 = lost35*total46 + product_error(total38, total46_halves, total40_halves)
                total48 = total44 - total38
                back22 = total48 - total44
                rest9 = total48 - back22
                one8 = total44 - rest9
                two8 = -back22 - total38
                lost36 = one8 + two8
                low2 = lost36 - fall_low5*total40 - lost35 + mean_low5
                total40 = given4*total48
                total48_halves = halves(xp, total48)
                lost36 = given4*low2 + product_error(total40, given4_halves, total48_halves)
                total48 = total39*total46
                total39_halves = halves(xp, total39)
                lost35 = lift_low*total46 + product_error(total48, total46_halves, total39_halves)
                total46 = total40 + total48
                back22 = total46 - total40
                rest9 = total46 - back22
                one8 = total40 - rest9
                two8 = total48 - back22
                lost34 = one8 + two8
                low2 = fall_low5*total39 + lost36 + lost35 + lost34
                total39 = total46/stiff
                left = total46 - stiff*total39
                total39_halves = halves(xp, total39)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total39*stiff, total39_halves, stiff_halves)
                left = left + low2
                lost34 = left/stiff
                return lost34 + total39

            def no(gamma, half, lost2, root, size, total2):
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma

                def yes(lost2, square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    back13 = total19 - 1.0
                    lost19 = 0.5*given3 - back13
                    curved3 = (given3*given3)*cos_series(xp, given3)
                    total20 = curved3 + total19
                    back13 = total20 - total19
                    lost20 = curved3 - back13
                    even_low = lost19 + 0.5*lost2 + lost20
                    bent = given3*sin_series(xp, given3)
                    total19 = bent + 1.0
                    back13 = total19 - 1.0
                    lost20 = bent - back13
                    odd_low = 0.16666666666666666*lost2 + lost20
                    even = total20
                    odd = total19
                    return even, even_low, odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total22 = sine/some
                    left = sine - some*total22
                    total22_halves = halves(xp, total22)
                    some_halves = halves(xp, some)
                    left = left - product_error(total22*some, total22_halves, some_halves)
                    left = cosine*root_low + left - root_low*total22
                    lost22 = left/some
                    even = cosine
                    even_low2 = -root_low*sine
                    odd = total22
                    odd_low2 = lost22
                    return even, even_low2, odd, odd_low2

                even, even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2),
                    no, (lost2, root, size))

                total23 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)
                total24 = even + total23
                back16 = total24 - even
                rest4 = total24 - back16
                one3 = even - rest4
                two3 = total23 - back16
                lost24 = one3 + two3
                total23 = envelope*total24
                envelope_halves = halves(xp, envelope)
                total24_halves = halves(xp, total24)
                lost24 = (
                    envelope*(even_low2 + lost23 + lost24) +
                    product_error(total23, envelope_halves, total24_halves)
                )
                total24 = 1.0 - total23
                back16 = total24 - 1.0
                lost23 = -back16 - total23
                total23 = total24/stiff
                left16 = total24 - stiff*total23
                total23_halves = halves(xp, total23)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total23*stiff, total23_halves, stiff_halves)
                left16 = left16 - lost24 + lost23
                lost23 = left16/stiff
                return lost23 + total23

            return select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, gamma, half, lost2, low, root, size, total29, total30, total28, total36,
                total37, whole3), no, (gamma, half, lost2, root, size, total2))

        return select(xp, reach < 0.5625, yes, (half, total2), no,
            (gamma, half, rest2, total, total2))

    def no(gamma, half, rest2, total, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(half, total2):
            half2 = half
            given5 = 0.5*half2
            total53 = 1.0 - 0.5*given5
            back31 = total53 - 1.0
            lost53 = -back31 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total54 = curved5 + total53
            back31 = total54 - total53
            lost54 = curved5 - back31
            mean_low6 = lost53 + lost54
            total53 = given5*total54
            given5_halves = halves(xp, given5)
            total54_halves = halves(xp, total54)
            lost54 = given5*mean_low6 + product_error(total53, given5_halves, total54_halves)
            total54 = 1.0 - total53
            back31 = total54 - 1.0
            lost53 = -back31 - total53
            fall_low6 = lost53 - lost54
            total53 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost53 = 2.0*fall_low6*total54 + product_error(total53, total54_halves, total54_halves)
            rest13 = rise_series(xp, half2, total2)
            total54 = rest13 + 0.5
            back31 = total54 - rest13
            rest14 = total54 - back31
            one12 = rest13 - rest14
            two12 = 0.5 - back31
            lost54 = one12 + two12
            envelope2 = total53
            total53 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost54 = envelope2*lost54 + product_error(total53, envelope2_halves, total54_halves)
            return lost53*total54 + lost54 + total53

        def no(gamma, half, rest2, root, size, total, total2, total3):
            back2 = total2 - total
            lost2 = rest2 - back2
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back2 = total3 - half
            lost2 = root - back2
            p_low = lost2 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate = q
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                curved = (given*given)*decay_series(xp, given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, rate < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                curved2 = (given2*given2)*decay_series(xp, given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                mean2 = total11
                return mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                mean2 = total15
                mean_low4 = lost14
                return mean2, mean_low4

            mean2, mean_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total16 = fall_*mean2
            fall__halves = halves(xp, fall_)
            mean2_halves = halves(xp, mean2)
            lost2 = fall_*mean_low4 + product_error(total16, fall__halves, mean2_halves)
            pulled_low = fall_low2*mean2 + lost2
            total17 = mean - total16
            back2 = total17 - mean
            rest3 = total17 - back2
            one2 = mean - rest3
            two2 = -back2 - total16
            lost2 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost2 + mean_low2 - p_low*total16 - pulled_low
            lost2 = left/whole
            return lost2 + total16

        return select(xp, reach < 0.5625, yes, (half, total2), no,
            (gamma, half, rest2, root, size, total, total2, total3))

    return select(xp, total2 < 0.0, yes, (gamma, half, rest, total, total2), no,
        (gamma, half, rest, total, total2))


def rise(xp, gamma, delta):
    """n1, how far a unit force moves the device in a period"""
    if gamma.dtype == xp.float32:
        return rise_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total

    def yes(gamma, half, rest2, total, total2):
        reach = 0.25*gamma

        def yes(half, total2):
            half2 = half
            given5 = 0.5*half2
            total53 = 1.0 - 0.5*given5
            back31 = total53 - 1.0
            lost53 = -back31 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total54 = curved5 + total53
            back31 = total54 - total53
            lost54 = curved5 - back31
            mean_low6 = lost53 + lost54
            total53 = given5*total54
            given5_halves = halves(xp, given5)
            total54_halves = halves(xp, total54)
            lost54 = given5*mean_low6 + product_error(total53, given5_halves, total54_halves)
            total54 = 1.0 - total53
            back31 = total54 - 1.0
            lost53 = -back31 - total53
            fall_low6 = lost53 - lost54
            total53 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost53 = 2.0*fall_low6*total54 + product_error(total53, total54_halves, total54_halves)
            rest13 = rise_series(xp, half2, total2)
            total54 = rest13 + 0.5
            back31 = total54 - rest13
            rest14 = total54 - back31
            one12 = rest13 - rest14
            two12 = 0.5 - back31
            lost54 = one12 + two12
            envelope2 = total53
            total53 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost54 = envelope2*lost54 + product_error(total53, envelope2_halves, total54_halves)
            return lost53*total54 + lost54 + total53

        def no(gamma, half, rest2, total, total2):
            back2 = total2 - total
            lost2 = rest2 - back2
            size = xp.abs(total2)
            root = square_root(xp, size)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total28 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number1_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost28 = product_error(total28, turns_halves, number1_halves)
            total29 = 2.5061182034958845e-15*turns
            number2_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost29 = product_error(total29, turns_halves, number2_halves)
            total30 = -total2 - total28
            back2 = total2 + total30
            rest5 = total30 - back2
            one4 = -rest5 - total2
            two4 = -back2 - total28
            lost30 = one4 + two4
            total28 = total30 - lost28
            back2 = total28 - total30
            rest5 = total28 - back2
            one4 = total30 - rest5
            two4 = -back2 - lost28
            lost28 = one4 + two4
            total30 = total28 - total29
            back2 = total30 - total28
            rest5 = total30 - back2
            one4 = total28 - rest5
            two4 = -back2 - total29
            lost32 = one4 + two4
            total29 = total30 - lost2
            back2 = total29 - total30
            rest5 = total29 - back2
            one4 = total30 - rest5
            two4 = -back2 - lost2
            lost33 = one4 + two4
            low = lost30 - lost29 + lost28 + lost32 + lost33 - 1.4920070805839235e-31*turns
            total30 = low + total29
            total28 = 6.283185307179586*count
            total36 = root + total28
            whole3 = xp.where(total36 == 0.0, 1.0, total36)
            total37 = total30/whole3
            far = (total37*total37)

            def yes(count, gamma, half, lost2, low, root, size, total33, total34, total35, total36,
                total37, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                stiff = gamma
                back22 = total34 - total33
                rest9 = total34 - back22
                one8 = total33 - rest9
                two8 = low - back22
                lost34 = one8 + two8
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                lost35 = product_error(count*6.283185307179586, count_halves, number2_halves)
                back22 = total36 - root
                rest9 = total36 - back22
                one8 = root - rest9
                two8 = total35 - back22
                lost36 = one8 + two8
                both_low = 2.4492935982947064e-16*count + lost35 + lost36 + root_low
                left = total34 - total37*whole3
                total37_halves = halves(xp, total37)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total37*whole3, total37_halves, whole3_halves)
                left = left - both_low*total37 + lost34
                lost34 = left/whole3
                eta = total37
                eta_low = lost34
                total38 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost34 = 2.0*eta*eta_low + product_error(total38, eta_halves, eta_halves)
                bent2 = (total38*total38)*cos_series(xp, -total38)
                total39 = 0.5*total38 - bent2
                back22 = total39 - 0.5*total38
                lost36 = -back22 - bent2
                total40 = 1.0 - total38*sin_series(xp, -total38)
                back22 = total40 - 1.0
                lost35 = -back22 - total38*sin_series(xp, -total38)
                lift_low = 0.5*lost34*total40 + lost36
                total38 = eta*total40
                total40_halves = halves(xp, total40)
                lost35 = eta*lost35 + product_error(total38, eta_halves, total40_halves)
                some2 = root
                total40 = total38/some2
                left = total38 - some2*total40
                total40_halves = halves(xp, total40)
                some2_halves = halves(xp, some2)
                left = left - product_error(total40*some2, total40_halves, some2_halves)
                left = eta_low*(1.0 - total39) + left + lost35 - root_low*total40
                lost35 = left/some2
                given4 = half
                total38 = 1.0 - 0.5*given4
                back22 = total38 - 1.0
                lost36 = -back22 - 0.5*given4
                curved4 = (given4*given4)*decay_series(xp, given4)
                total44 = curved4 + total38
                back22 = total44 - total38
                lost34 = curved4 - back22
                mean_low5 = lost36 + lost34
                total38 = given4*total44
                given4_halves = halves(xp, given4)
                total44_halves = halves(xp, total44)
                lost34 = given4*mean_low5 + product_error(total38, given4_halves, total44_halves)
                total46 = 1.0 - total38
                back22 = total46 - 1.0
                lost36 = -back22 - total38
                fall_low5 = lost36 - lost34
                total38 = total40*total46
                total46_halves = halves(xp, total46)
                lost35 = lost35*total46 + product_error(total38, total46_halves, total40_halves)
                total48 = total44 - total38
                back22 = total48 - total44
                rest9 = total48 - back22
                one8 = total44 - rest9
                two8 = -back22 - total38
                lost36 = one8 + two8
                low2 = lost36 - fall_low5*total40 - lost35 + mean_low5
                total40 = given4*total48
                total48_halves = halves(xp, total48)
                lost36 = given4*low2 + product_error(total40, given4_halves, total48_halves)
                total48 = total39*total46
                total39_halves = halves(xp, total39)
                lost35 = lift_low*total46 + product_error(total48, total46_halves, total39_halves)
                total46 = total40 + total48
                back22 = total46 - total40
                rest9 = total46 - back22
                one8 = total40 - rest9
                two8 = total48 - back22
                lost34 = one8 + two8
                low2 = fall_low5*total39 + lost36 + lost35 + lost34
                total39 = total46/stiff
                left = total46 - stiff*total39
                total39_halves = halves(xp, total39)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total39*stiff, total39_halves, stiff_halves)
                left = left + low2
                lost34 = left/stiff
                return lost34 + total39

            def no(gamma, half, lost2, root, size, total2):
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma

                def yes(lost2, square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    back13 = total19 - 1.0
                    lost19 = 0.5*given3 - back13
                    curved3 = (given3*given3)*cos_series(xp, given3)
                    total20 = curved3 + total19
                    back13 = total20 - total19
                    lost20 = curved3 - back13
                    even_low = lost19 + 0.5*lost2 + lost20
                    bent = given3*sin_series(xp, given3)
                    total19 = bent + 1.0
                    back13 = total19 - 1.0
                    lost20 = bent - back13
                    odd_low = 0.16666666666666666*lost2 + lost20
                    even = total20
                    odd = total19
                    return even, even_low, odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total22 = sine/some
                    left = sine - some*total22
                    total22_halves = halves(xp, total22)
                    some_halves = halves(xp, some)
                    left = left - product_error(total22*some, total22_halves, some_halves)
                    left = cosine*root_low + left - root_low*total22
                    lost22 = left/some
                    even = cosine
                    even_low2 = -root_low*sine
                    odd = total22
                    odd_low2 = lost22
                    return even, even_low2, odd, odd_low2

                even, even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2),
                    no, (lost2, root, size))

                total23 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)
                total24 = even + total23
                back16 = total24 - even
                rest4 = total24 - back16
                one3 = even - rest4
                two3 = total23 - back16
                lost24 = one3 + two3
                total23 = envelope*total24
                envelope_halves = halves(xp, envelope)
                total24_halves = halves(xp, total24)
                lost24 = (
                    envelope*(even_low2 + lost23 + lost24) +
                    product_error(total23, envelope_halves, total24_halves)
                )
                total24 = 1.0 - total23
                back16 = total24 - 1.0
                lost23 = -back16 - total23
                total23 = total24/stiff
                left16 = total24 - stiff*total23
                total23_halves = halves(xp, total23)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total23*stiff, total23_halves, stiff_halves)
                left16 = left16 - lost24 + lost23
                lost23 = left16/stiff
                return lost23 + total23

            return select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, gamma, half, lost2, low, root, size, total29, total30, total28, total36,
                total37, whole3), no, (gamma, half, lost2, root, size, total2))

        return select(xp, reach < 0.5625, yes, (half, total2), no,
            (gamma, half, rest2, total, total2))

    def no(gamma, half, rest2, total, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(half, total2):
            half2 = half
            given5 = 0.5*half2
            total53 = 1.0 - 0.5*given5
            back31 = total53 - 1.0
            lost53 = -back31 - 0.5*given5
            curved5 = (given5*given5)*decay_series(xp, given5)
            total54 = curved5 + total53
            back31 = total54 - total53
            lost54 = curved5 - back31
            mean_low6 = lost53 + lost54
            total53 = given5*total54
            given5_halves = halves(xp, given5)
            total54_halves = halves(xp, total54)
            lost54 = given5*mean_low6 + product_error(total53, given5_halves, total54_halves)
            total54 = 1.0 - total53
            back31 = total54 - 1.0
            lost53 = -back31 - total53
            fall_low6 = lost53 - lost54
            total53 = (total54*total54)
            total54_halves = halves(xp, total54)
            lost53 = 2.0*fall_low6*total54 + product_error(total53, total54_halves, total54_halves)
            rest13 = rise_series(xp, half2, total2)
            total54 = rest13 + 0.5
            back31 = total54 - rest13
            rest14 = total54 - back31
            one12 = rest13 - rest14
            two12 = 0.5 - back31
            lost54 = one12 + two12
            envelope2 = total53
            total53 = envelope2*total54
            envelope2_halves = halves(xp, envelope2)
            total54_halves = halves(xp, total54)
            lost54 = envelope2*lost54 + product_error(total53, envelope2_halves, total54_halves)
            return lost53*total54 + lost54 + total53

        def no(gamma, half, rest2, root, size, total, total2, total3):
            back2 = total2 - total
            lost2 = rest2 - back2
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back2 = total3 - half
            lost2 = root - back2
            p_low = lost2 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate = q
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                curved = (given*given)*decay_series(xp, given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, rate < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                curved2 = (given2*given2)*decay_series(xp, given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                mean2 = total11
                return mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                mean2 = total15
                mean_low4 = lost14
                return mean2, mean_low4

            mean2, mean_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total16 = fall_*mean2
            fall__halves = halves(xp, fall_)
            mean2_halves = halves(xp, mean2)
            lost2 = fall_*mean_low4 + product_error(total16, fall__halves, mean2_halves)
            pulled_low = fall_low2*mean2 + lost2
            total17 = mean - total16
            back2 = total17 - mean
            rest3 = total17 - back2
            one2 = mean - rest3
            two2 = -back2 - total16
            lost2 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost2 + mean_low2 - p_low*total16 - pulled_low
            lost2 = left/whole
            return lost2 + total16

        return select(xp, reach < 0.5625, yes, (half, total2), no,
            (gamma, half, rest2, root, size, total, total2, total3))

    return select(xp, total2 < 0.0, yes, (gamma, half, rest, total, total2), no,
        (gamma, half, rest, total, total2))


def together_series_single(xp, h, w):
    """The same in single precision."""

    def yes(h, w):
        y = (h*h)
        e2 = 2.48015873015873e-05*w + 0.001388888888888889
        b2 = e2 + 2.48015873015873e-05*y
        e2 = e2*w + 0.041666666666666664
        b2 = b2*y + e2
        e2 = e2*w
        b2 = b2*y + e2
        return b2

    def no(h, w):
        y2 = (h*h)
        e8 = 4.110317623312165e-19*w + 1.5619206968586225e-16
        b8 = e8 + 4.110317623312165e-19*y2
        e8 = e8*w + 4.779477332387385e-14
        b8 = b8*y2 + e8
        e8 = e8*w + 1.1470745597729725e-11
        b8 = b8*y2 + e8
        e8 = e8*w + 2.08767569878681e-09
        b8 = b8*y2 + e8
        e8 = e8*w + 2.755731922398589e-07
        b8 = b8*y2 + e8
        e8 = e8*w + 2.48015873015873e-05
        b8 = b8*y2 + e8
        e8 = e8*w + 0.001388888888888889
        b8 = b8*y2 + e8
        e8 = e8*w + 0.041666666666666664
        b8 = b8*y2 + e8
        e8 = e8*w
        b8 = b8*y2 + e8
        return b8

    return select(xp, (h < 0.0625) & (xp.abs(w) < 0.00390625), yes, (h, w), no, (h, w))


def together_series(xp, h, w):
    """divided difference of cosh(sqrt) at h^2 and w, less 1/2"""
    if h.dtype == xp.float32:
        return together_series_single(xp, h, w)

    def yes(h, w):
        y = (h*h)
        e4 = 2.08767569878681e-09*w + 2.755731922398589e-07
        b4 = e4 + 2.08767569878681e-09*y
        e4 = e4*w + 2.48015873015873e-05
        b4 = b4*y + e4
        e4 = e4*w + 0.001388888888888889
        b4 = b4*y + e4
        e4 = e4*w + 0.041666666666666664
        b4 = b4*y + e4
        e4 = e4*w
        b4 = b4*y + e4
        return b4

    def no(h, w):
        y2 = (h*h)
        e12 = 3.279889237069838e-30*w + 2.4795962632247976e-27
        b12 = e12 + 3.279889237069838e-30*y2
        e12 = e12*w + 1.6117375710961184e-24
        b12 = b12*y2 + e12
        e12 = e12*w + 8.896791392450574e-22
        b12 = b12*y2 + e12
        e12 = e12*w + 4.110317623312165e-19
        b12 = b12*y2 + e12
        e12 = e12*w + 1.5619206968586225e-16
        b12 = b12*y2 + e12
        e12 = e12*w + 4.779477332387385e-14
        b12 = b12*y2 + e12
        e12 = e12*w + 1.1470745597729725e-11
        b12 = b12*y2 + e12
        e12 = e12*w + 2.08767569878681e-09
        b12 = b12*y2 + e12
        e12 = e12*w + 2.755731922398589e-07
        b12 = b12*y2 + e12
        e12 = e12*w + 2.48015873015873e-05
        b12 = b12*y2 + e12
        e12 = e12*w + 0.001388888888888889
        b12 = b12*y2 + e12
        e12 = e12*w + 0.041666666666666664
        b12 = b12*y2 + e12
        e12 = e12*w
        b12 = b12*y2 + e12
        return b12

    return select(xp, (h < 0.0625) & (xp.abs(w) < 0.00390625), yes, (h, w), no, (h, w))


def swing_together_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(half, lost2, total2):
            square2 = total2
            envelope = xp.exp(-half)
            rest12 = together_series(xp, half, total2)
            total55 = rest12 + 0.5
            back33 = total55 - rest12
            rest13 = total55 - back33
            one11 = rest12 - rest13
            two11 = 0.5 - back33
            lost55 = one11 + two11
            total56 = envelope*total55
            envelope_halves = halves(xp, envelope)
            total55_halves = halves(xp, total55)
            lost55 = envelope*lost55 + product_error(total56, envelope_halves, total55_halves)

            def yes(lost2, square2):
                given3 = square2
                total16 = 0.5*given3 + 1.0
                back12 = total16 - 1.0
                lost16 = 0.5*given3 - back12
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total17 = curved3 + total16
                back12 = total17 - total16
                lost17 = curved3 - back12
                even_low = lost16 + lost17 + 0.5*lost2
                even = total17
                return even, even_low

            def no(lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no, (lost2, total2))

            total55 = envelope*even
            even_halves = halves(xp, even)
            lost21 = envelope*even_low2 + product_error(total55, envelope_halves, even_halves)
            swing_of = 2.0*lost21 + 2.0*total55
            together_of = 2.0*lost55 + 2.0*total56
            return swing_of, together_of

        def no(gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma

            def yes(lost2, square2):
                given3 = square2
                total16 = 0.5*given3 + 1.0
                back12 = total16 - 1.0
                lost16 = 0.5*given3 - back12
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total17 = curved3 + total16
                back12 = total17 - total16
                lost17 = curved3 - back12
                even_low = lost16 + lost17 + 0.5*lost2
                even = total17
                return even, even_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total21 = envelope*even
            envelope_halves = halves(xp, envelope)
            even_halves = halves(xp, even)
            lost21 = envelope*even_low2 + product_error(total21, envelope_halves, even_halves)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total142 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number3_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost142 = product_error(total142, turns_halves, number3_halves)
            total152 = 1.1614863524300745e-06*turns
            number4_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost152 = product_error(total152, turns_halves, number4_halves)
            total162 = -total142 - total2
            back102 = total162 + total2
            rest5 = total162 - back102
            one4 = -rest5 - total2
            two4 = -back102 - total142
            lost162 = one4 + two4
            total142 = total162 - lost142
            back102 = total142 - total162
            rest5 = total142 - back102
            one4 = total162 - rest5
            two4 = -back102 - lost142
            lost142 = one4 + two4
            total162 = total142 - total152
            back102 = total162 - total142
            rest5 = total162 - back102
            one4 = total142 - rest5
            two4 = -back102 - total152
            lost182 = one4 + two4
            total152 = total162 - lost2
            back102 = total152 - total162
            rest5 = total152 - back102
            one4 = total162 - rest5
            two4 = -back102 - lost2
            lost192 = one4 + two4
            low3 = lost162 - lost152 + lost142 + lost182 + lost192 + 1.1704736640094811e-14*turns
            total162 = low3 + total152
            total142 = 6.2831854820251465*count
            total222 = root + total142
            whole3 = xp.where(total222 == 0.0, 1.0, total222)
            total232 = total162/whole3
            far = (total232*total232)

            def yes(count, half, lost2, lost21, low3, root, size, stiff, total192, total202,
                total21, total212, total222, total232, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back142 = total202 - total192
                rest9 = total202 - back142
                one8 = total192 - rest9
                two8 = low3 - back142
                lost202 = one8 + two8
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                lost212 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                back142 = total222 - root
                rest9 = total222 - back142
                one8 = root - rest9
                two8 = total212 - back142
                lost222 = one8 + two8
                both_low = lost212 - 1.7484555314695172e-07*count + lost222 + root_low
                left = total202 - total232*whole3
                total232_halves = halves(xp, total232)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total232*whole3, total232_halves, whole3_halves)
                left = left - both_low*total232 + lost202
                lost202 = left/whole3
                eta = total232
                eta_low = lost202
                total24 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost202 = 2.0*eta*eta_low + product_error(total24, eta_halves, eta_halves)
                cos_series_of2 = cos_series(xp, -total24)
                bent2 = cos_series_of2*(total24*total24)
                total25 = 0.5*total24 - bent2
                back142 = total25 - 0.5*total24
                lost222 = -back142 - bent2
                sin_series_of2 = sin_series(xp, -total24)
                total24 = 1.0 - sin_series_of2*total24
                lift_low = 0.5*lost202*total24 + lost222
                given22 = half
                total24 = 1.0 - 0.5*given22
                back142 = total24 - 1.0
                lost222 = -back142 - 0.5*given22
                decay_series_of3 = decay_series(xp, given22)
                curved22 = decay_series_of3*(given22*given22)
                total30 = curved22 + total24
                back142 = total30 - total24
                lost202 = curved22 - back142
                mean_low5 = lost222 + lost202
                total24 = given22*total30
                given22_halves = halves(xp, given22)
                total30_halves = halves(xp, total30)
                lost202 = given22*mean_low5 + product_error(total24, given22_halves, total30_halves)
                total30 = 1.0 - total24
                back142 = total30 - 1.0
                lost222 = -back142 - total24
                fall_low5 = lost222 - lost202
                total24 = 1.0 - total30
                back142 = total24 - 1.0
                lost222 = -back142 - total30
                low4 = lost222 - fall_low5
                total34 = low4 + total24
                back142 = total34 - total24
                lost222 = low4 - back142
                total24 = (total34*total34)
                total34_halves = halves(xp, total34)
                lost222 = 2.0*lost222*total34 + product_error(total24, total34_halves,
                    total34_halves)
                total34 = total25*total30
                total30_halves = halves(xp, total30)
                total25_halves = halves(xp, total25)
                lost202 = lift_low*total30 + product_error(total34, total30_halves, total25_halves)
                total30 = total24 + 2.0*total34
                back142 = total30 - total24
                rest9 = total30 - back142
                one8 = total24 - rest9
                two8 = 2.0*total34 - back142
                lost212 = one8 + two8
                low4 = 2.0*fall_low5*total25 + lost222 + 2.0*lost202 + lost212
                total25 = total30/stiff
                left = total30 - stiff*total25
                total25_halves = halves(xp, total25)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total25*stiff, total25_halves, stiff_halves)
                left = left + low4
                lost212 = left/stiff
                swing_of = 2.0*lost21 + 2.0*total21
                together_of = lost212 + total25
                return swing_of, together_of

            def no(envelope, half, lost2, lost21, root, size, stiff, total21):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                expm1_of = xp.expm1(-half)
                grown = -0.5*expm1_of
                angle = 0.5*root
                wave = xp.sin(angle)
                cos_of = xp.cos(angle)
                back72 = -0.5*cos_of*root_low
                total92 = wave - back72
                back82 = total92 - wave
                rest3 = total92 - back82
                one2 = wave - rest3
                two2 = -back72 - back82
                lost92 = one2 + two2
                total102 = (total92*total92)
                total92_halves = halves(xp, total92)
                lost102 = product_error(total102, total92_halves, total92_halves)
                low = lost102 + 2.0*lost92*total92
                total92 = envelope*total102
                envelope_halves = halves(xp, envelope)
                total102_halves = halves(xp, total102)
                lost92 = envelope*low + product_error(total92, envelope_halves, total102_halves)
                total102 = (grown*grown) + total92
                back82 = total102 - total92
                rest3 = total102 - back82
                one2 = total92 - rest3
                two2 = (grown*grown) - back82
                lost102 = one2 + two2
                low = lost92 + lost102
                total92 = total102/stiff
                left = total102 - stiff*total92
                total92_halves = halves(xp, total92)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total92*stiff, total92_halves, stiff_halves)
                left = left + low
                lost102 = left/stiff
                swing_of = 2.0*lost21 + 2.0*total21
                together_of = 4.0*lost102 + 4.0*total92
                return swing_of, together_of

            swing_of, together_of = select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, half, lost2, lost21, low3, root, size, stiff, total152, total162, total21,
                total142, total222, total232, whole3), no,
                (envelope, half, lost2, lost21, root, size, stiff, total21))

            return swing_of, together_of

        swing_of, together_of = select(xp, reach < 1.0, yes, (half, lost2, total2), no,
            (gamma, half, lost2, total2))

        return swing_of, together_of

    def no(gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(gamma, half, lost2, root, size, total2, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            envelope = xp.exp(-half)
            rest12 = together_series(xp, half, total2)
            total55 = rest12 + 0.5
            back3 = total55 - rest12
            rest13 = total55 - back3
            one11 = rest12 - rest13
            two11 = 0.5 - back3
            lost3 = one11 + two11
            total56 = envelope*total55
            envelope_halves = halves(xp, envelope)
            total55_halves = halves(xp, total55)
            lost3 = envelope*lost3 + product_error(total56, envelope_halves, total55_halves)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                return fall_, fall_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                fall_ = sunk
                fall_low2 = sunk_low
                return fall_, fall_low2

            fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total55 = fall2 + 1.0
            back3 = total55 - 1.0
            lost22 = fall2 - back3
            total23 = fall_*total55
            fall__halves = halves(xp, fall_)
            total55_halves = halves(xp, total55)
            lost22 = (
                fall_*(fall_low4 + lost22) + product_error(total23, fall__halves, total55_halves)
            )
            creep_ = fall_low2*total55 + lost22 + total23
            swing_of = creep_
            together_of = 2.0*lost3 + 2.0*total56
            return swing_of, together_of

        def no(gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total22 = fall2 + 1.0
            back3 = total22 - 1.0
            lost3 = fall2 - back3
            total23 = fall_*total22
            fall__halves = halves(xp, fall_)
            total22_halves = halves(xp, total22)
            lost3 = fall_*(fall_low4 + lost3) + product_error(total23, fall__halves, total22_halves)
            creep_ = fall_low2*total22 + lost3 + total23
            total23 = fall_*fall2
            fall2_halves = halves(xp, fall2)
            lost3 = fall_*fall_low4 + product_error(total23, fall__halves, fall2_halves)
            low6 = fall2*fall_low2 + lost3
            total22 = 1.0 - total23
            back3 = total22 - 1.0
            lost3 = -back3 - total23
            total23 = mean*total22
            mean_halves = halves(xp, mean)
            total22_halves = halves(xp, total22)
            lost3 = mean*(lost3 - low6) + product_error(total23, mean_halves, total22_halves)
            moved_low = lost3 + mean_low2*total22
            total22 = total23/whole
            left = total23 - total22*whole
            total22_halves = halves(xp, total22)
            left = left - product_error(total22*whole, total22_halves, whole_halves)
            left = left + moved_low - p_low*total22
            lost3 = left/whole
            swing_of = creep_
            together_of = lost3 + total22
            return swing_of, together_of

        swing_of, together_of = select(xp, reach < 1.0, yes,
            (gamma, half, lost2, root, size, total2, total3), no,
            (gamma, half, lost2, root, size, total3))

        return swing_of, together_of

    swing_of, together_of = select(xp, total2 < 0.0, yes, (gamma, half, lost, total2), no,
        (gamma, half, lost, total2))

    return swing_of, together_of


def swing_together(xp, gamma, delta):
    """a, the sum of the sampled device's poles; n1 + n0"""
    if gamma.dtype == xp.float32:
        return swing_together_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(half, lost2, total2):
            square2 = total2
            envelope = xp.exp(-half)
            rest12 = together_series(xp, half, total2)
            total55 = rest12 + 0.5
            back33 = total55 - rest12
            rest13 = total55 - back33
            one11 = rest12 - rest13
            two11 = 0.5 - back33
            lost55 = one11 + two11
            total56 = envelope*total55
            envelope_halves = halves(xp, envelope)
            total55_halves = halves(xp, total55)
            lost55 = envelope*lost55 + product_error(total56, envelope_halves, total55_halves)

            def yes(lost2, square2):
                given3 = square2
                total16 = 0.5*given3 + 1.0
                back12 = total16 - 1.0
                lost16 = 0.5*given3 - back12
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total17 = curved3 + total16
                back12 = total17 - total16
                lost17 = curved3 - back12
                even_low = lost16 + lost17 + 0.5*lost2
                even = total17
                return even, even_low

            def no(lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no, (lost2, total2))

            total55 = envelope*even
            even_halves = halves(xp, even)
            lost21 = envelope*even_low2 + product_error(total55, envelope_halves, even_halves)
            swing_of = 2.0*lost21 + 2.0*total55
            together_of = 2.0*lost55 + 2.0*total56
            return swing_of, together_of

        def no(gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma

            def yes(lost2, square2):
                given3 = square2
                total16 = 0.5*given3 + 1.0
                back12 = total16 - 1.0
                lost16 = 0.5*given3 - back12
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total17 = curved3 + total16
                back12 = total17 - total16
                lost17 = curved3 - back12
                even_low = lost16 + lost17 + 0.5*lost2
                even = total17
                return even, even_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                even = cosine
                even_low2 = -root_low*sine
                return even, even_low2

            even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total21 = envelope*even
            envelope_halves = halves(xp, envelope)
            even_halves = halves(xp, even)
            lost21 = envelope*even_low2 + product_error(total21, envelope_halves, even_halves)

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total142 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number3_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost142 = product_error(total142, turns_halves, number3_halves)
            total152 = 2.5061182034958845e-15*turns
            number4_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost152 = product_error(total152, turns_halves, number4_halves)
            total162 = -total142 - total2
            back102 = total162 + total2
            rest5 = total162 - back102
            one4 = -rest5 - total2
            two4 = -back102 - total142
            lost162 = one4 + two4
            total142 = total162 - lost142
            back102 = total142 - total162
            rest5 = total142 - back102
            one4 = total162 - rest5
            two4 = -back102 - lost142
            lost142 = one4 + two4
            total162 = total142 - total152
            back102 = total162 - total142
            rest5 = total162 - back102
            one4 = total142 - rest5
            two4 = -back102 - total152
            lost182 = one4 + two4
            total152 = total162 - lost2
            back102 = total152 - total162
            rest5 = total152 - back102
            one4 = total162 - rest5
            two4 = -back102 - lost2
            lost192 = one4 + two4
            low3 = lost162 - lost152 + lost142 + lost182 + lost192 - 1.4920070805839235e-31*turns
            total162 = low3 + total152
            total142 = 6.283185307179586*count
            total222 = root + total142
            whole3 = xp.where(total222 == 0.0, 1.0, total222)
            total232 = total162/whole3
            far = (total232*total232)

            def yes(count, half, lost2, lost21, low3, root, size, stiff, total192, total202,
                total21, total212, total222, total232, whole3):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back142 = total202 - total192
                rest9 = total202 - back142
                one8 = total192 - rest9
                two8 = low3 - back142
                lost202 = one8 + two8
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                lost212 = product_error(count*6.283185307179586, count_halves, number2_halves)
                back142 = total222 - root
                rest9 = total222 - back142
                one8 = root - rest9
                two8 = total212 - back142
                lost222 = one8 + two8
                both_low = 2.4492935982947064e-16*count + lost212 + lost222 + root_low
                left = total202 - total232*whole3
                total232_halves = halves(xp, total232)
                whole3_halves = halves(xp, whole3)
                left = left - product_error(total232*whole3, total232_halves, whole3_halves)
                left = left - both_low*total232 + lost202
                lost202 = left/whole3
                eta = total232
                eta_low = lost202
                total24 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost202 = 2.0*eta*eta_low + product_error(total24, eta_halves, eta_halves)
                cos_series_of2 = cos_series(xp, -total24)
                bent2 = cos_series_of2*(total24*total24)
                total25 = 0.5*total24 - bent2
                back142 = total25 - 0.5*total24
                lost222 = -back142 - bent2
                sin_series_of2 = sin_series(xp, -total24)
                total24 = 1.0 - sin_series_of2*total24
                lift_low = 0.5*lost202*total24 + lost222
                given22 = half
                total24 = 1.0 - 0.5*given22
                back142 = total24 - 1.0
                lost222 = -back142 - 0.5*given22
                decay_series_of3 = decay_series(xp, given22)
                curved22 = decay_series_of3*(given22*given22)
                total30 = curved22 + total24
                back142 = total30 - total24
                lost202 = curved22 - back142
                mean_low5 = lost222 + lost202
                total24 = given22*total30
                given22_halves = halves(xp, given22)
                total30_halves = halves(xp, total30)
                lost202 = given22*mean_low5 + product_error(total24, given22_halves, total30_halves)
                total30 = 1.0 - total24
                back142 = total30 - 1.0
                lost222 = -back142 - total24
                fall_low5 = lost222 - lost202
                total24 = 1.0 - total30
                back142 = total24 - 1.0
                lost222 = -back142 - total30
                low4 = lost222 - fall_low5
                total34 = low4 + total24
                back142 = total34 - total24
                lost222 = low4 - back142
                total24 = (total34*total34)
                total34_halves = halves(xp, total34)
                lost222 = 2.0*lost222*total34 + product_error(total24, total34_halves,
                    total34_halves)
                total34 = total25*total30
                total30_halves = halves(xp, total30)
                total25_halves = halves(xp, total25)
                lost202 = lift_low*total30 + product_error(total34, total30_halves, total25_halves)
                total30 = total24 + 2.0*total34
                back142 = total30 - total24
                rest9 = total30 - back142
                one8 = total24 - rest9
                two8 = 2.0*total34 - back142
                lost212 = one8 + two8
                low4 = 2.0*fall_low5*total25 + lost222 + 2.0*lost202 + lost212
                total25 = total30/stiff
                left = total30 - stiff*total25
                total25_halves = halves(xp, total25)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total25*stiff, total25_halves, stiff_halves)
                left = left + low4
                lost212 = left/stiff
                swing_of = 2.0*lost21 + 2.0*total21
                together_of = lost212 + total25
                return swing_of, together_of

            def no(envelope, half, lost2, lost21, root, size, stiff, total21):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                expm1_of = xp.expm1(-half)
                grown = -0.5*expm1_of
                angle = 0.5*root
                wave = xp.sin(angle)
                cos_of = xp.cos(angle)
                back72 = -0.5*cos_of*root_low
                total92 = wave - back72
                back82 = total92 - wave
                rest3 = total92 - back82
                one2 = wave - rest3
                two2 = -back72 - back82
                lost92 = one2 + two2
                total102 = (total92*total92)
                total92_halves = halves(xp, total92)
                lost102 = product_error(total102, total92_halves, total92_halves)
                low = lost102 + 2.0*lost92*total92
                total92 = envelope*total102
                envelope_halves = halves(xp, envelope)
                total102_halves = halves(xp, total102)
                lost92 = envelope*low + product_error(total92, envelope_halves, total102_halves)
                total102 = (grown*grown) + total92
                back82 = total102 - total92
                rest3 = total102 - back82
                one2 = total92 - rest3
                two2 = (grown*grown) - back82
                lost102 = one2 + two2
                low = lost92 + lost102
                total92 = total102/stiff
                left = total102 - stiff*total92
                total92_halves = halves(xp, total92)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total92*stiff, total92_halves, stiff_halves)
                left = left + low
                lost102 = left/stiff
                swing_of = 2.0*lost21 + 2.0*total21
                together_of = 4.0*lost102 + 4.0*total92
                return swing_of, together_of

            swing_of, together_of = select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, half, lost2, lost21, low3, root, size, stiff, total152, total162, total21,
                total142, total222, total232, whole3), no,
                (envelope, half, lost2, lost21, root, size, stiff, total21))

            return swing_of, together_of

        swing_of, together_of = select(xp, reach < 1.0, yes, (half, lost2, total2), no,
            (gamma, half, lost2, total2))

        return swing_of, together_of

    def no(gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(gamma, half, lost2, root, size, total2, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            envelope = xp.exp(-half)
            rest12 = together_series(xp, half, total2)
            total55 = rest12 + 0.5
            back3 = total55 - rest12
            rest13 = total55 - back3
            one11 = rest12 - rest13
            two11 = 0.5 - back3
            lost3 = one11 + two11
            total56 = envelope*total55
            envelope_halves = halves(xp, envelope)
            total55_halves = halves(xp, total55)
            lost3 = envelope*lost3 + product_error(total56, envelope_halves, total55_halves)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                return fall_, fall_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                fall_ = sunk
                fall_low2 = sunk_low
                return fall_, fall_low2

            fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total55 = fall2 + 1.0
            back3 = total55 - 1.0
            lost22 = fall2 - back3
            total23 = fall_*total55
            fall__halves = halves(xp, fall_)
            total55_halves = halves(xp, total55)
            lost22 = (
                fall_*(fall_low4 + lost22) + product_error(total23, fall__halves, total55_halves)
            )
            creep_ = fall_low2*total55 + lost22 + total23
            swing_of = creep_
            together_of = 2.0*lost3 + 2.0*total56
            return swing_of, together_of

        def no(gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )


            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            total22 = fall2 + 1.0
            back3 = total22 - 1.0
            lost3 = fall2 - back3
            total23 = fall_*total22
            fall__halves = halves(xp, fall_)
            total22_halves = halves(xp, total22)
            lost3 = fall_*(fall_low4 + lost3) + product_error(total23, fall__halves, total22_halves)
            creep_ = fall_low2*total22 + lost3 + total23
            total23 = fall_*fall2
            fall2_halves = halves(xp, fall2)
            lost3 = fall_*fall_low4 + product_error(total23, fall__halves, fall2_halves)
            low6 = fall2*fall_low2 + lost3
            total22 = 1.0 - total23
            back3 = total22 - 1.0
            lost3 = -back3 - total23
            total23 = mean*total22
            mean_halves = halves(xp, mean)
            total22_halves = halves(xp, total22)
            lost3 = mean*(lost3 - low6) + product_error(total23, mean_halves, total22_halves)
            moved_low = lost3 + mean_low2*total22
            total22 = total23/whole
            left = total23 - total22*whole
            total22_halves = halves(xp, total22)
            left = left - product_error(total22*whole, total22_halves, whole_halves)
            left = left + moved_low - p_low*total22
            lost3 = left/whole
            swing_of = creep_
            together_of = lost3 + total22
            return swing_of, together_of

        swing_of, together_of = select(xp, reach < 1.0, yes,
            (gamma, half, lost2, root, size, total2, total3), no,
            (gamma, half, lost2, root, size, total3))

        return swing_of, together_of

    swing_of, together_of = select(xp, total2 < 0.0, yes, (gamma, half, lost, total2), no,
        (gamma, half, lost, total2))

    return swing_of, together_of


def apart_series_single(xp, h, w):
    """The same in single precision."""

    def yes(h, w):
        y = (h*h)
        e2 = 2.7557319223985893e-06*w + 0.0001984126984126984
        b2 = e2 + 2.7557319223985893e-06*y
        e2 = e2*w + 0.008333333333333333
        b2 = b2*y + e2
        e2 = e2*w
        b2 = b2*y + e2
        return b2 - 4.967053879312289e-09

    def no(h, w):
        y2 = (h*h)
        e7 = 8.22063524662433e-18*w + 2.8114572543455206e-15
        b7 = e7 + 8.22063524662433e-18*y2
        e7 = e7*w + 7.647163731819816e-13
        b7 = b7*y2 + e7
        e7 = e7*w + 1.6059043836821613e-10
        b7 = b7*y2 + e7
        e7 = e7*w + 2.505210838544172e-08
        b7 = b7*y2 + e7
        e7 = e7*w + 2.7557319223985893e-06
        b7 = b7*y2 + e7
        e7 = e7*w + 0.0001984126984126984
        b7 = b7*y2 + e7
        e7 = e7*w + 0.008333333333333333
        b7 = b7*y2 + e7
        e7 = e7*w
        b7 = b7*y2 + e7
        return b7 - 4.967053879312289e-09

    return select(xp, (h < 0.0625) & (xp.abs(w) < 0.00390625), yes, (h, w), no, (h, w))


def apart_series(xp, h, w):
    """divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6"""
    if h.dtype == xp.float32:
        return apart_series_single(xp, h, w)

    def yes(h, w):
        y = (h*h)
        e4 = 1.6059043836821613e-10*w + 2.505210838544172e-08
        b4 = e4 + 1.6059043836821613e-10*y
        e4 = e4*w + 2.7557319223985893e-06
        b4 = b4*y + e4
        e4 = e4*w + 0.0001984126984126984
        b4 = b4*y + e4
        e4 = e4*w + 0.008333333333333333
        b4 = b4*y + e4
        e4 = e4*w
        b4 = b4*y + e4
        return b4 + 9.25185853854297e-18

    def no(h, w):
        y2 = (h*h)
        e11 = 9.183689863795546e-29*w + 6.446950284384474e-26
        b11 = e11 + 9.183689863795546e-29*y2
        e11 = e11*w + 3.868170170630684e-23
        b11 = b11*y2 + e11
        e11 = e11*w + 1.9572941063391263e-20
        b11 = b11*y2 + e11
        e11 = e11*w + 8.22063524662433e-18
        b11 = b11*y2 + e11
        e11 = e11*w + 2.8114572543455206e-15
        b11 = b11*y2 + e11
        e11 = e11*w + 7.647163731819816e-13
        b11 = b11*y2 + e11
        e11 = e11*w + 1.6059043836821613e-10
        b11 = b11*y2 + e11
        e11 = e11*w + 2.505210838544172e-08
        b11 = b11*y2 + e11
        e11 = e11*w + 2.7557319223985893e-06
        b11 = b11*y2 + e11
        e11 = e11*w + 0.0001984126984126984
        b11 = b11*y2 + e11
        e11 = e11*w + 0.008333333333333333
        b11 = b11*y2 + e11
        e11 = e11*w
        b11 = b11*y2 + e11
        return b11 + 9.25185853854297e-18

    return select(xp, (h < 0.0625) & (xp.abs(w) < 0.00390625), yes, (h, w), no, (h, w))


def decay(xp, x):
    """(1 - exp(-x))/x"""

    def yes(x):
        return 1.0

    def no(x):
        whole = x
        return -xp.expm1(-x)/whole

    return select(xp, x == 0.0, yes, (x,), no, (x,))


def apart_fall_kick_kick_low_rise_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half, lost2, reach, total2):

            def yes(delta, gamma, half, lost2, total2):
                square2 = total2
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back17 = total27 - 1.0
                lost54 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back17 = total55 - total27
                lost55 = curved5 - back17
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back17 = total55 - 1.0
                lost54 = -back17 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back17 = total27 - rest6
                rest5 = total27 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back17 = total55 - 1.0
                lost532 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back17 = total542 - total55
                lost542 = curved5 - back17
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back17 = total542 - 1.0
                lost532 = -back17 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back17 = total542 - rest5
                rest6 = total542 - back17
                one4 = rest5 - rest6
                two4 = 0.5 - back17
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

                def yes(lost2, square2):
                    given3 = square2
                    sin_series_of = sin_series(xp, given3)
                    bent = given3*sin_series_of
                    total21 = bent + 1.0
                    back15 = total21 - 1.0
                    lost21 = bent - back15
                    odd_low = 0.16666666666666666*lost2 + lost21
                    odd = total21
                    return odd, odd_low

                def no(lost2, total2):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total22 = sine/some
                    left = sine - some*total22
                    total22_halves = halves(xp, total22)
                    some_halves = halves(xp, some)
                    left = left - product_error(total22*some, total22_halves, some_halves)
                    left = cosine*root_low + left - root_low*total22
                    lost22 = left/some
                    odd = total22
                    odd_low2 = lost22
                    return odd, odd_low2

                odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, total2))

                total55 = envelope*odd
                odd_halves = halves(xp, odd)
                lost24 = envelope*odd_low2 + product_error(total55, envelope_halves, odd_halves)
                total222 = lost24 + total55
                back17 = total222 - total55
                lost24 = lost24 - back17
                apart_of = lost27 + total28
                fall_of = lost54*total27 + lost55 + total61
                kick_of = total222
                kick_low_of = lost24
                rise_of = lost532*total542 + lost542 + total592
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            def no(gamma, half, lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)

                def yes(lost2, square2):
                    given3 = square2
                    sin_series_of = sin_series(xp, given3)
                    bent = given3*sin_series_of
                    total21 = bent + 1.0
                    back15 = total21 - 1.0
                    lost21 = bent - back15
                    odd_low = 0.16666666666666666*lost2 + lost21
                    odd = total21
                    return odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total22 = sine/some
                    left = sine - some*total22
                    total22_halves = halves(xp, total22)
                    some_halves = halves(xp, some)
                    left = left - product_error(total22*some, total22_halves, some_halves)
                    left = cosine*root_low + left - root_low*total22
                    lost22 = left/some
                    odd = total22
                    odd_low2 = lost22
                    return odd, odd_low2

                odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, root, size))

                total27 = envelope*odd
                odd_halves = halves(xp, odd)
                lost24 = envelope*odd_low2 + product_error(total27, envelope_halves, odd_halves)
                total222 = lost24 + total27
                back17 = total222 - total27
                lost24 = lost24 - back17

                def yes(root):
                    count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                    return count

                def no(root):
                    return 0.0

                count = select(xp, root < 4096.0, yes, (root,), no, (root,))

                turns = (count*count)
                total27 = 39.478416442871094*turns
                turns_halves = halves(xp, turns)
                number4_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
                lost29 = product_error(total27, turns_halves, number4_halves)
                total30 = 1.1614863524300745e-06*turns
                number5_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
                lost30 = product_error(total30, turns_halves, number5_halves)
                total31 = -total2 - total27
                back17 = total2 + total31
                rest6 = total31 - back17
                one4 = -rest6 - total2
                two4 = -back17 - total27
                lost31 = one4 + two4
                total27 = total31 - lost29
                back17 = total27 - total31
                rest6 = total27 - back17
                one4 = total31 - rest6
                two4 = -back17 - lost29
                lost29 = one4 + two4
                total31 = total27 - total30
                back17 = total31 - total27
                rest6 = total31 - back17
                one4 = total27 - rest6
                two4 = -back17 - total30
                lost33 = one4 + two4
                total30 = total31 - lost2
                back17 = total30 - total31
                rest6 = total30 - back17
                one4 = total31 - rest6
                two4 = -back17 - lost2
                lost34 = one4 + two4
                low2 = lost31 - lost30 + lost29 + lost33 + lost34 + 1.1704736640094811e-14*turns
                total31 = low2 + total30
                total27 = 6.2831854820251465*count
                total37 = root + total27
                whole32 = xp.where(total37 == 0.0, 1.0, total37)
                total38 = total31/whole32
                far = (total38*total38)

                def yes(count, half, lost2, lost222, lost28, low2, root, size, stiff, total222,
                    total28, total34, total35, total36, total37, total38, whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    back22 = total35 - total34
                    rest10 = total35 - back22
                    one9 = total34 - rest10
                    two9 = low2 - back22
                    lost35 = one9 + two9
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                    lost36 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                    back22 = total37 - root
                    rest10 = total37 - back22
                    one9 = root - rest10
                    two9 = total36 - back22
                    lost37 = one9 + two9
                    both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                    left = total35 - total38*whole32
                    total38_halves = halves(xp, total38)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                    left = left - both_low*total38 + lost35
                    lost35 = left/whole32
                    eta = total38
                    eta_low = lost35
                    total39 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total39)
                    bent2 = cos_series_of2*(total39*total39)
                    total40 = 0.5*total39 - bent2
                    back22 = total40 - 0.5*total39
                    lost37 = -back22 - bent2
                    sin_series_of2 = sin_series(xp, -total39)
                    total41 = 1.0 - sin_series_of2*total39
                    back22 = total41 - 1.0
                    lost36 = -back22 - sin_series_of2*total39
                    lift_low = 0.5*lost35*total41 + lost37
                    total39 = eta*total41
                    total41_halves = halves(xp, total41)
                    lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                    some2 = root
                    total41 = total39/some2
                    left = total39 - some2*total41
                    total41_halves = halves(xp, total41)
                    some2_halves = halves(xp, some2)
                    left = left - product_error(total41*some2, total41_halves, some2_halves)
                    left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                    lost36 = left/some2
                    given4 = half
                    total39 = 1.0 - 0.5*given4
                    back22 = total39 - 1.0
                    lost37 = -back22 - 0.5*given4
                    decay_series_of3 = decay_series(xp, given4)
                    curved4 = decay_series_of3*(given4*given4)
                    total45 = curved4 + total39
                    back22 = total45 - total39
                    lost35 = curved4 - back22
                    mean_low5 = lost37 + lost35
                    total39 = given4*total45
                    given4_halves = halves(xp, given4)
                    total45_halves = halves(xp, total45)
                    lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                        total45_halves)
                    total47 = 1.0 - total39
                    back22 = total47 - 1.0
                    lost37 = -back22 - total39
                    fall_low5 = lost37 - lost35
                    total39 = total45 - total41
                    back22 = total39 - total45
                    rest10 = total39 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total41
                    lost37 = one9 + two9
                    total49 = given4*total39
                    total39_halves = halves(xp, total39)
                    lost37 = (
                        given4*(lost37 - lost36 + mean_low5) +
                        product_error(total49, given4_halves, total39_halves)
                    )
                    total39 = total40 - total49
                    back22 = total39 - total40
                    rest10 = total39 - back22
                    one9 = total40 - rest10
                    two9 = -back22 - total49
                    lost35 = one9 + two9
                    low22 = lift_low - lost37 + lost35
                    total49 = low22 + total39
                    back22 = total49 - total39
                    rest10 = total49 - back22
                    one9 = total39 - rest10
                    two9 = low22 - back22
                    lost35 = one9 + two9
                    total39 = total47*total49
                    total47_halves = halves(xp, total47)
                    total49_halves = halves(xp, total49)
                    lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                    low22 = fall_low5*total49 + lost35
                    total49 = total39/stiff
                    left = total39 - stiff*total49
                    total49_halves = halves(xp, total49)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                    left = left + low22
                    lost35 = left/stiff
                    total39 = total41*total47
                    lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                    total482 = total45 - total39
                    back22 = total482 - total45
                    rest10 = total482 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total39
                    lost37 = one9 + two9
                    low22 = lost37 - fall_low5*total41 - lost36 + mean_low5
                    total41 = given4*total482
                    total482_halves = halves(xp, total482)
                    lost37 = given4*low22 + product_error(total41, given4_halves, total482_halves)
                    total482 = total40*total47
                    total40_halves = halves(xp, total40)
                    lost36 = lift_low*total47 + product_error(total482, total47_halves,
                        total40_halves)
                    total47 = total41 + total482
                    back22 = total47 - total41
                    rest10 = total47 - back22
                    one9 = total41 - rest10
                    two9 = total482 - back22
                    lost512 = one9 + two9
                    low22 = fall_low5*total40 + lost37 + lost36 + lost512
                    total40 = total47/stiff
                    left = total47 - stiff*total40
                    total40_halves = halves(xp, total40)
                    left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                    left = left + low22
                    lost512 = left/stiff
                    apart_of = lost28 + total28
                    fall_of = lost35 + total49
                    kick_of = total222
                    kick_low_of = lost222
                    rise_of = lost512 + total40
                    return apart_of, fall_of, kick_of, kick_low_of, rise_of

                def no(envelope, half, lost2, lost222, lost28, odd, odd_low2, root, size, square2,
                    stiff, total222, total28):
                    total23 = half*odd
                    half_halves = halves(xp, half)
                    odd_halves = halves(xp, odd)
                    lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        even = total20
                        return even, even_low

                    def no(lost2, root, size):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        sine = xp.sin(root)
                        cosine = xp.cos(root)
                        even = cosine
                        even_low2 = -root_low*sine
                        return even, even_low2

                    even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (lost2, root, size))

                    total252 = total23 - even
                    back162 = total252 - total23
                    rest42 = total252 - back162
                    one32 = total23 - rest42
                    two32 = -back162 - even
                    lost252 = one32 + two32
                    total262 = envelope + total252
                    back162 = total262 - total252
                    rest42 = total262 - back162
                    one32 = total252 - rest42
                    two32 = envelope - back162
                    lost262 = one32 + two32
                    total252 = envelope*total262
                    envelope_halves = halves(xp, envelope)
                    total262_halves = halves(xp, total262)
                    lost262 = (
                        envelope*(lost23 - even_low2 + lost252 + lost262) +
                        product_error(total252, envelope_halves, total262_halves)
                    )
                    total262 = total252/stiff
                    left16 = total252 - stiff*total262
                    total262_halves = halves(xp, total262)
                    stiff_halves = halves(xp, stiff)
                    left16 = left16 - product_error(total262*stiff, total262_halves, stiff_halves)
                    left16 = left16 + lost262
                    lost262 = left16/stiff
                    total252 = even + total23
                    back162 = total252 - even
                    rest42 = total252 - back162
                    one32 = even - rest42
                    two32 = total23 - back162
                    lost252 = one32 + two32
                    total23 = envelope*total252
                    total252_halves = halves(xp, total252)
                    lost252 = (
                        envelope*(even_low2 + lost23 + lost252) +
                        product_error(total23, envelope_halves, total252_halves)
                    )
                    total252 = 1.0 - total23
                    back162 = total252 - 1.0
                    lost23 = -back162 - total23
                    total23 = total252/stiff
                    left16 = total252 - stiff*total23
                    total23_halves = halves(xp, total23)
                    left16 = left16 - product_error(total23*stiff, total23_halves, stiff_halves)
                    left16 = left16 - lost252 + lost23
                    lost23 = left16/stiff
                    apart_of = lost28 + total28
                    fall_of = lost262 + total262
                    kick_of = total222
                    kick_low_of = lost222
                    rise_of = lost23 + total23
                    return apart_of, fall_of, kick_of, kick_low_of, rise_of

                apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, half, lost2, lost24, lost27, low2, root, size, stiff, total222,
                    total28, total30, total31, total27, total37, total38, whole32), no,
                    (envelope, half, lost2, lost24, lost27, odd, odd_low2, root, size, square2,
                    stiff, total222, total28))
                )

                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, total2), no,
                (gamma, half, lost2, total2))
            )

            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        def no(delta, gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma
            mean3 = decay(xp, delta)

            def yes(lost2, square2):
                given3 = square2
                sin_series_of = sin_series(xp, given3)
                bent = given3*sin_series_of
                total21 = bent + 1.0
                back15 = total21 - 1.0
                lost21 = bent - back15
                odd_low = 0.16666666666666666*lost2 + lost21
                odd = total21
                return odd, odd_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                some = root
                total22 = sine/some
                left = sine - some*total22
                total22_halves = halves(xp, total22)
                some_halves = halves(xp, some)
                left = left - product_error(total22*some, total22_halves, some_halves)
                left = cosine*root_low + left - root_low*total22
                lost22 = left/some
                odd = total22
                odd_low2 = lost22
                return odd, odd_low2

            odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total24 = envelope*odd
            envelope_halves = halves(xp, envelope)
            odd_halves = halves(xp, odd)
            lost24 = envelope*odd_low2 + product_error(total24, envelope_halves, odd_halves)
            total25 = mean3 - total24
            back16 = total25 - mean3
            rest4 = total25 - back16
            one3 = mean3 - rest4
            two3 = -back16 - total24
            lost25 = one3 + two3
            total26 = total25/stiff
            left13 = total25 - stiff*total26
            total26_halves = halves(xp, total26)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total26*stiff, total26_halves, stiff_halves)
            left13 = left13 - lost24 + lost25
            lost25 = left13/stiff
            total25 = lost24 + total24
            back16 = total25 - total24
            lost24 = lost24 - back16

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total24 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number5_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost29 = product_error(total24, turns_halves, number5_halves)
            total30 = 1.1614863524300745e-06*turns
            number6_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost30 = product_error(total30, turns_halves, number6_halves)
            total31 = -total2 - total24
            back16 = total2 + total31
            rest4 = total31 - back16
            one3 = -rest4 - total2
            two3 = -back16 - total24
            lost31 = one3 + two3
            total24 = total31 - lost29
            back16 = total24 - total31
            rest4 = total24 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost29
            lost29 = one3 + two3
            total31 = total24 - total30
            back16 = total31 - total24
            rest4 = total31 - back16
            one3 = total24 - rest4
            two3 = -back16 - total30
            lost33 = one3 + two3
            total30 = total31 - lost2
            back16 = total30 - total31
            rest4 = total30 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost2
            lost34 = one3 + two3
            low2 = lost31 - lost30 + lost29 + lost33 + lost34 + 1.1704736640094811e-14*turns
            total31 = low2 + total30
            total24 = 6.2831854820251465*count
            total37 = root + total24
            whole32 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole32
            far = (total38*total38)

            def yes(count, half, lost2, lost222, lost26, low2, root, size, stiff, total222,
                total26, total34, total35, total36, total37, total38, whole32):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back22 = total35 - total34
                rest10 = total35 - back22
                one9 = total34 - rest10
                two9 = low2 - back22
                lost35 = one9 + two9
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                lost36 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                back22 = total37 - root
                rest10 = total37 - back22
                one9 = root - rest10
                two9 = total36 - back22
                lost37 = one9 + two9
                both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                left = total35 - total38*whole32
                total38_halves = halves(xp, total38)
                whole32_halves = halves(xp, whole32)
                left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                left = left - both_low*total38 + lost35
                lost35 = left/whole32
                eta = total38
                eta_low = lost35
                total39 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                cos_series_of2 = cos_series(xp, -total39)
                bent2 = cos_series_of2*(total39*total39)
                total40 = 0.5*total39 - bent2
                back22 = total40 - 0.5*total39
                lost37 = -back22 - bent2
                sin_series_of2 = sin_series(xp, -total39)
                total41 = 1.0 - sin_series_of2*total39
                back22 = total41 - 1.0
                lost36 = -back22 - sin_series_of2*total39
                lift_low = 0.5*lost35*total41 + lost37
                total39 = eta*total41
                total41_halves = halves(xp, total41)
                lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                some2 = root
                total41 = total39/some2
                left = total39 - some2*total41
                total41_halves = halves(xp, total41)
                some2_halves = halves(xp, some2)
                left = left - product_error(total41*some2, total41_halves, some2_halves)
                left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                lost36 = left/some2
                given4 = half
                total39 = 1.0 - 0.5*given4
                back22 = total39 - 1.0
                lost37 = -back22 - 0.5*given4
                decay_series_of3 = decay_series(xp, given4)
                curved4 = decay_series_of3*(given4*given4)
                total45 = curved4 + total39
                back22 = total45 - total39
                lost35 = curved4 - back22
                mean_low5 = lost37 + lost35
                total39 = given4*total45
                given4_halves = halves(xp, given4)
                total45_halves = halves(xp, total45)
                lost35 = given4*mean_low5 + product_error(total39, given4_halves, total45_halves)
                total47 = 1.0 - total39
                back22 = total47 - 1.0
                lost37 = -back22 - total39
                fall_low5 = lost37 - lost35
                total39 = total45 - total41
                back22 = total39 - total45
                rest10 = total39 - back22
                one9 = total45 - rest10
                two9 = -back22 - total41
                lost37 = one9 + two9
                total49 = given4*total39
                total39_halves = halves(xp, total39)
                lost37 = (
                    given4*(lost37 - lost36 + mean_low5) +
                    product_error(total49, given4_halves, total39_halves)
                )
                total39 = total40 - total49
                back22 = total39 - total40
                rest10 = total39 - back22
                one9 = total40 - rest10
                two9 = -back22 - total49
                lost35 = one9 + two9
                low22 = lift_low - lost37 + lost35
                total49 = low22 + total39
                back22 = total49 - total39
                rest10 = total49 - back22
                one9 = total39 - rest10
                two9 = low22 - back22
                lost35 = one9 + two9
                total39 = total47*total49
                total47_halves = halves(xp, total47)
                total49_halves = halves(xp, total49)
                lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                low22 = fall_low5*total49 + lost35
                total49 = total39/stiff
                left = total39 - stiff*total49
                total49_halves = halves(xp, total49)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                left = left + low22
                lost35 = left/stiff
                total39 = total41*total47
                lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                total482 = total45 - total39
                back22 = total482 - total45
                rest10 = total482 - back22
                one9 = total45 - rest10
                two9 = -back22 - total39
                lost37 = one9 + two9
                low22 = lost37 - fall_low5*total41 - lost36 + mean_low5
                total41 = given4*total482
                total482_halves = halves(xp, total482)
                lost37 = given4*low22 + product_error(total41, given4_halves, total482_halves)
                total482 = total40*total47
                total40_halves = halves(xp, total40)
                lost36 = lift_low*total47 + product_error(total482, total47_halves, total40_halves)
                total47 = total41 + total482
                back22 = total47 - total41
                rest10 = total47 - back22
                one9 = total41 - rest10
                two9 = total482 - back22
                lost512 = one9 + two9
                low22 = fall_low5*total40 + lost37 + lost36 + lost512
                total40 = total47/stiff
                left = total47 - stiff*total40
                total40_halves = halves(xp, total40)
                left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                left = left + low22
                lost512 = left/stiff
                apart_of = lost26 + total26
                fall_of = lost35 + total49
                kick_of = total222
                kick_low_of = lost222
                rise_of = lost512 + total40
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            def no(envelope, half, lost2, lost222, lost26, odd, odd_low2, root, size, square2,
                stiff, total222, total26):
                total23 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)

                def yes(lost2, square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    back13 = total19 - 1.0
                    lost19 = 0.5*given3 - back13
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total20 = curved3 + total19
                    back13 = total20 - total19
                    lost20 = curved3 - back13
                    even_low = lost19 + 0.5*lost2 + lost20
                    even = total20
                    return even, even_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    even = cosine
                    even_low2 = -root_low*sine
                    return even, even_low2

                even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, root, size))

                total252 = total23 - even
                back162 = total252 - total23
                rest42 = total252 - back162
                one32 = total23 - rest42
                two32 = -back162 - even
                lost252 = one32 + two32
                total262 = envelope + total252
                back162 = total262 - total252
                rest42 = total262 - back162
                one32 = total252 - rest42
                two32 = envelope - back162
                lost262 = one32 + two32
                total252 = envelope*total262
                envelope_halves = halves(xp, envelope)
                total262_halves = halves(xp, total262)
                lost262 = (
                    envelope*(lost23 - even_low2 + lost252 + lost262) +
                    product_error(total252, envelope_halves, total262_halves)
                )
                total262 = total252/stiff
                left16 = total252 - stiff*total262
                total262_halves = halves(xp, total262)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total262*stiff, total262_halves, stiff_halves)
                left16 = left16 + lost262
                lost262 = left16/stiff
                total252 = even + total23
                back162 = total252 - even
                rest42 = total252 - back162
                one32 = even - rest42
                two32 = total23 - back162
                lost252 = one32 + two32
                total23 = envelope*total252
                total252_halves = halves(xp, total252)
                lost252 = (
                    envelope*(even_low2 + lost23 + lost252) +
                    product_error(total23, envelope_halves, total252_halves)
                )
                total252 = 1.0 - total23
                back162 = total252 - 1.0
                lost23 = -back162 - total23
                total23 = total252/stiff
                left16 = total252 - stiff*total23
                total23_halves = halves(xp, total23)
                left16 = left16 - product_error(total23*stiff, total23_halves, stiff_halves)
                left16 = left16 - lost252 + lost23
                lost23 = left16/stiff
                apart_of = lost26 + total26
                fall_of = lost262 + total262
                kick_of = total222
                kick_low_of = lost222
                rise_of = lost23 + total23
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, half, lost2, lost24, lost25, low2, root, size, stiff, total25, total26,
                total30, total31, total24, total37, total38, whole32), no,
                (envelope, half, lost2, lost24, lost25, odd, odd_low2, root, size, square2,
                stiff, total25, total26))
            )

            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        apart_of, fall_of, kick_of, kick_low_of, rise_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, total2), no,
            (delta, gamma, half, lost2, total2))
        )

        return apart_of, fall_of, kick_of, kick_low_of, rise_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half, lost2, reach, root, size, total2, total3):

            def yes(delta, gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back3 = total27 - 1.0
                lost54 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back3 = total55 - total27
                lost55 = curved5 - back3
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back3 = total55 - 1.0
                lost54 = -back3 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back3 = total27 - rest6
                rest5 = total27 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back3 = total55 - 1.0
                lost532 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back3 = total542 - total55
                lost542 = curved5 - back3
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back3 = total542 - 1.0
                lost532 = -back3 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back3 = total542 - rest5
                rest6 = total542 - back3
                one4 = rest5 - rest6
                two4 = 0.5 - back3
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    return fall_, fall_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    fall_ = sunk
                    fall_low2 = sunk_low
                    return fall_, fall_low2

                fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))


                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    mean2 = total11
                    return mean2, mean_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    total14 = 1.0 - sunk2
                    back11 = total14 - 1.0
                    lost14 = -back11 - sunk2
                    bottom2 = 2.0*root
                    total15 = total14/bottom2
                    left7 = total14 - bottom2*total15
                    total15_halves = halves(xp, total15)
                    bottom2_halves = halves(xp, bottom2)
                    left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                    left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                    lost14 = left7/bottom2
                    mean2 = total15
                    mean_low4 = lost14
                    return mean2, mean_low4

                mean2, mean_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no,
                    (root, root_low))

                total55 = fall_*mean2
                fall__halves = halves(xp, fall_)
                mean2_halves = halves(xp, mean2)
                lost163 = fall_*mean_low4 + product_error(total55, fall__halves, mean2_halves)
                creep_low = fall_low2*mean2 + lost163
                total232 = creep_low + total55
                back3 = total232 - total55
                lost163 = creep_low - back3
                apart_of = lost3 + total28
                fall_of = lost54*total27 + lost55 + total61
                kick_of = total232
                kick_low_of = lost163
                rise_of = lost532*total542 + lost542 + total592
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            def no(gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    mean = total5
                    return fall_, fall_low, mean, mean_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    total8 = 1.0 - sunk
                    back7 = total8 - 1.0
                    lost8 = -back7 - sunk
                    bottom = q
                    total9 = total8/bottom
                    left4 = total8 - bottom*total9
                    total9_halves = halves(xp, total9)
                    bottom_halves = halves(xp, bottom)
                    left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                    left4 = left4 + lost8 - q_low*total9 - sunk_low
                    lost8 = left4/bottom
                    fall_ = sunk
                    fall_low2 = sunk_low
                    mean = total9
                    mean_low2 = lost8
                    return fall_, fall_low2, mean, mean_low2

                fall_, fall_low2, mean, mean_low2 = (
                    select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
                )


                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    total10 = given2*total11
                    given2_halves = halves(xp, given2)
                    total11_halves = halves(xp, total11)
                    lost11 = given2*mean_low3 + product_error(total10, given2_halves,
                        total11_halves)
                    total13 = 1.0 - total10
                    back8 = total13 - 1.0
                    lost10 = -back8 - total10
                    fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                    fall2 = total13
                    mean2 = total11
                    return fall2, fall_low3, mean2, mean_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    total14 = 1.0 - sunk2
                    back11 = total14 - 1.0
                    lost14 = -back11 - sunk2
                    bottom2 = 2.0*root
                    total15 = total14/bottom2
                    left7 = total14 - bottom2*total15
                    total15_halves = halves(xp, total15)
                    bottom2_halves = halves(xp, bottom2)
                    left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                    left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                    lost14 = left7/bottom2
                    fall2 = sunk2
                    fall_low4 = sunk_low2
                    mean2 = total15
                    mean_low4 = lost14
                    return fall2, fall_low4, mean2, mean_low4

                fall2, fall_low4, mean2, mean_low4 = (
                    select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
                )

                total27 = fall2*mean
                fall2_halves = halves(xp, fall2)
                mean_halves = halves(xp, mean)
                lost162 = fall2*mean_low2 + product_error(total27, fall2_halves, mean_halves)
                pulled_low = fall_low4*mean + lost162
                total172 = mean2 - total27
                back3 = total172 - mean2
                rest6 = total172 - back3
                one4 = mean2 - rest6
                two4 = -back3 - total27
                lost162 = one4 + two4
                total27 = total172/whole
                left = total172 - total27*whole
                total27_halves = halves(xp, total27)
                left = left - product_error(total27*whole, total27_halves, whole_halves)
                left = left + lost162 + mean_low4 - p_low*total27 - pulled_low
                lost162 = left/whole
                total172 = fall_*total27
                fall__halves = halves(xp, fall_)
                lost162 = fall_*lost162 + product_error(total172, fall__halves, total27_halves)
                creep_ = fall_low2*total27 + lost162 + total172
                total172 = fall_*mean2
                mean2_halves = halves(xp, mean2)
                lost162 = fall_*mean_low4 + product_error(total172, fall__halves, mean2_halves)
                creep_low = fall_low2*mean2 + lost162
                total27 = creep_low + total172
                back3 = total27 - total172
                lost162 = creep_low - back3
                total173 = mean - total172
                back3 = total173 - mean
                rest6 = total173 - back3
                one4 = mean - rest6
                two4 = -back3 - total172
                lost173 = one4 + two4
                total172 = total173/whole
                left = total173 - total172*whole
                total172_halves = halves(xp, total172)
                left = left - product_error(total172*whole, total172_halves, whole_halves)
                left = left - creep_low + lost173 + mean_low2 - p_low*total172
                lost173 = left/whole
                apart_of = lost3 + total28
                fall_of = creep_
                kick_of = total27
                kick_low_of = lost162
                rise_of = lost173 + total172
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, root, size, total2,
                total3), no, (gamma, half, lost2, root, size, total2, total3))
            )

            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        def no(delta, gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )

            twice = 2.0*fall_

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            fast = fall_*fall2
            total16 = mean2*twice
            twice_halves = halves(xp, twice)
            mean2_halves = halves(xp, mean2)
            lost3 = mean_low4*twice + product_error(total16, twice_halves, mean2_halves)
            total17 = mean - total16
            back3 = total17 - mean
            rest3 = total17 - back3
            one2 = mean - rest3
            two2 = -back3 - total16
            lost17 = one2 + two2
            total16 = fast*mean
            fast_halves = halves(xp, fast)
            mean_halves = halves(xp, mean)
            lost18 = fast*mean_low2 + product_error(total16, fast_halves, mean_halves)
            top = total17 + total16
            low = lost17 - lost3 + lost18 + mean_low2
            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            lost18 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost18
            total17 = mean2 - total16
            back3 = total17 - mean2
            rest3 = total17 - back3
            one2 = mean2 - rest3
            two2 = -back3 - total16
            lost18 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost18 + mean_low4 - p_low*total16 - pulled_low
            lost18 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost18 = fall_*lost18 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost18 + total17
            total17 = fall_*mean2
            lost18 = fall_*mean_low4 + product_error(total17, fall__halves, mean2_halves)
            creep_low = fall_low2*mean2 + lost18
            total16 = creep_low + total17
            back3 = total16 - total17
            lost18 = creep_low - back3
            total173 = mean - total17
            back3 = total173 - mean
            rest3 = total173 - back3
            one2 = mean - rest3
            two2 = -back3 - total17
            lost17 = one2 + two2
            total17 = total173/whole
            left = total173 - total17*whole
            total17_halves = halves(xp, total17)
            left = left - product_error(total17*whole, total17_halves, whole_halves)
            left = left - creep_low + lost17 + mean_low2 - p_low*total17
            lost17 = left/whole
            apart_of = (low + top)/whole3
            fall_of = creep_
            kick_of = total16
            kick_low_of = lost18
            rise_of = lost17 + total17
            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        apart_of, fall_of, kick_of, kick_low_of, rise_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, root, size, total2,
            total3), no, (delta, gamma, half, lost2, root, size, total3))
        )

        return apart_of, fall_of, kick_of, kick_low_of, rise_of

    apart_of, fall_of, kick_of, kick_low_of, rise_of = (
        select(xp, total2 < 0.0, yes, (delta, gamma, half, lost, total2), no,
        (delta, gamma, half, lost, total2))
    )

    return apart_of, fall_of, kick_of, kick_low_of, rise_of


def apart_fall_kick_kick_low_rise(xp, gamma, delta):
    """(n1 - n0)/delta; n0, the same device with its time reversed, times exp(-delta);
    displacement by a unit impulse after a period; what the last rounding of Kick takes; n1, how
    far a unit force moves the device in a period
    """
    if gamma.dtype == xp.float32:
        return apart_fall_kick_kick_low_rise_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half, lost2, reach, total2):

            def yes(delta, gamma, half, lost2, total2):
                square2 = total2
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back17 = total27 - 1.0
                lost54 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back17 = total55 - total27
                lost55 = curved5 - back17
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back17 = total55 - 1.0
                lost54 = -back17 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back17 = total27 - rest6
                rest5 = total27 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back17 = total55 - 1.0
                lost532 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back17 = total542 - total55
                lost542 = curved5 - back17
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back17 = total542 - 1.0
                lost532 = -back17 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back17 = total542 - rest5
                rest6 = total542 - back17
                one4 = rest5 - rest6
                two4 = 0.5 - back17
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

                def yes(lost2, square2):
                    given3 = square2
                    sin_series_of = sin_series(xp, given3)
                    bent = given3*sin_series_of
                    total21 = bent + 1.0
                    back15 = total21 - 1.0
                    lost21 = bent - back15
                    odd_low = 0.16666666666666666*lost2 + lost21
                    odd = total21
                    return odd, odd_low

                def no(lost2, total2):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total22 = sine/some
                    left = sine - some*total22
                    total22_halves = halves(xp, total22)
                    some_halves = halves(xp, some)
                    left = left - product_error(total22*some, total22_halves, some_halves)
                    left = cosine*root_low + left - root_low*total22
                    lost22 = left/some
                    odd = total22
                    odd_low2 = lost22
                    return odd, odd_low2

                odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, total2))

                total55 = envelope*odd
                odd_halves = halves(xp, odd)
                lost24 = envelope*odd_low2 + product_error(total55, envelope_halves, odd_halves)
                total222 = lost24 + total55
                back17 = total222 - total55
                lost24 = lost24 - back17
                apart_of = lost27 + total28
                fall_of = lost54*total27 + lost55 + total61
                kick_of = total222
                kick_low_of = lost24
                rise_of = lost532*total542 + lost542 + total592
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            def no(gamma, half, lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)

                def yes(lost2, square2):
                    given3 = square2
                    sin_series_of = sin_series(xp, given3)
                    bent = given3*sin_series_of
                    total21 = bent + 1.0
                    back15 = total21 - 1.0
                    lost21 = bent - back15
                    odd_low = 0.16666666666666666*lost2 + lost21
                    odd = total21
                    return odd, odd_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    some = root
                    total22 = sine/some
                    left = sine - some*total22
                    total22_halves = halves(xp, total22)
                    some_halves = halves(xp, some)
                    left = left - product_error(total22*some, total22_halves, some_halves)
                    left = cosine*root_low + left - root_low*total22
                    lost22 = left/some
                    odd = total22
                    odd_low2 = lost22
                    return odd, odd_low2

                odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, root, size))

                total27 = envelope*odd
                odd_halves = halves(xp, odd)
                lost24 = envelope*odd_low2 + product_error(total27, envelope_halves, odd_halves)
                total222 = lost24 + total27
                back17 = total222 - total27
                lost24 = lost24 - back17

                def yes(root):
                    count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                    return count

                def no(root):
                    return 0.0

                count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

                turns = (count*count)
                total27 = 39.47841760435743*turns
                turns_halves = halves(xp, turns)
                number4_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
                lost29 = product_error(total27, turns_halves, number4_halves)
                total30 = 2.5061182034958845e-15*turns
                number5_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
                lost30 = product_error(total30, turns_halves, number5_halves)
                total31 = -total2 - total27
                back17 = total2 + total31
                rest6 = total31 - back17
                one4 = -rest6 - total2
                two4 = -back17 - total27
                lost31 = one4 + two4
                total27 = total31 - lost29
                back17 = total27 - total31
                rest6 = total27 - back17
                one4 = total31 - rest6
                two4 = -back17 - lost29
                lost29 = one4 + two4
                total31 = total27 - total30
                back17 = total31 - total27
                rest6 = total31 - back17
                one4 = total27 - rest6
                two4 = -back17 - total30
                lost33 = one4 + two4
                total30 = total31 - lost2
                back17 = total30 - total31
                rest6 = total30 - back17
                one4 = total31 - rest6
                two4 = -back17 - lost2
                lost34 = one4 + two4
                low2 = lost31 - lost30 + lost29 + lost33 + lost34 - 1.4920070805839235e-31*turns
                total31 = low2 + total30
                total27 = 6.283185307179586*count
                total37 = root + total27
                whole32 = xp.where(total37 == 0.0, 1.0, total37)
                total38 = total31/whole32
                far = (total38*total38)

                def yes(count, half, lost2, lost222, lost28, low2, root, size, stiff, total222,
                    total28, total34, total35, total36, total37, total38, whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    back22 = total35 - total34
                    rest10 = total35 - back22
                    one9 = total34 - rest10
                    two9 = low2 - back22
                    lost35 = one9 + two9
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                    lost36 = product_error(count*6.283185307179586, count_halves, number2_halves)
                    back22 = total37 - root
                    rest10 = total37 - back22
                    one9 = root - rest10
                    two9 = total36 - back22
                    lost37 = one9 + two9
                    both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                    left = total35 - total38*whole32
                    total38_halves = halves(xp, total38)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                    left = left - both_low*total38 + lost35
                    lost35 = left/whole32
                    eta = total38
                    eta_low = lost35
                    total39 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total39)
                    bent2 = cos_series_of2*(total39*total39)
                    total40 = 0.5*total39 - bent2
                    back22 = total40 - 0.5*total39
                    lost37 = -back22 - bent2
                    sin_series_of2 = sin_series(xp, -total39)
                    total41 = 1.0 - sin_series_of2*total39
                    back22 = total41 - 1.0
                    lost36 = -back22 - sin_series_of2*total39
                    lift_low = 0.5*lost35*total41 + lost37
                    total39 = eta*total41
                    total41_halves = halves(xp, total41)
                    lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                    some2 = root
                    total41 = total39/some2
                    left = total39 - some2*total41
                    total41_halves = halves(xp, total41)
                    some2_halves = halves(xp, some2)
                    left = left - product_error(total41*some2, total41_halves, some2_halves)
                    left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                    lost36 = left/some2
                    given4 = half
                    total39 = 1.0 - 0.5*given4
                    back22 = total39 - 1.0
                    lost37 = -back22 - 0.5*given4
                    decay_series_of3 = decay_series(xp, given4)
                    curved4 = decay_series_of3*(given4*given4)
                    total45 = curved4 + total39
                    back22 = total45 - total39
                    lost35 = curved4 - back22
                    mean_low5 = lost37 + lost35
                    total39 = given4*total45
                    given4_halves = halves(xp, given4)
                    total45_halves = halves(xp, total45)
                    lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                        total45_halves)
                    total47 = 1.0 - total39
                    back22 = total47 - 1.0
                    lost37 = -back22 - total39
                    fall_low5 = lost37 - lost35
                    total39 = total45 - total41
                    back22 = total39 - total45
                    rest10 = total39 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total41
                    lost37 = one9 + two9
                    total49 = given4*total39
                    total39_halves = halves(xp, total39)
                    lost37 = (
                        given4*(lost37 - lost36 + mean_low5) +
                        product_error(total49, given4_halves, total39_halves)
                    )
                    total39 = total40 - total49
                    back22 = total39 - total40
                    rest10 = total39 - back22
                    one9 = total40 - rest10
                    two9 = -back22 - total49
                    lost35 = one9 + two9
                    low22 = lift_low - lost37 + lost35
                    total49 = low22 + total39
                    back22 = total49 - total39
                    rest10 = total49 - back22
                    one9 = total39 - rest10
                    two9 = low22 - back22
                    lost35 = one9 + two9
                    total39 = total47*total49
                    total47_halves = halves(xp, total47)
                    total49_halves = halves(xp, total49)
                    lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                    low22 = fall_low5*total49 + lost35
                    total49 = total39/stiff
                    left = total39 - stiff*total49
                    total49_halves = halves(xp, total49)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                    left = left + low22
                    lost35 = left/stiff
                    total39 = total41*total47
                    lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                    total482 = total45 - total39
                    back22 = total482 - total45
                    rest10 = total482 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total39
                    lost37 = one9 + two9
                    low22 = lost37 - fall_low5*total41 - lost36 + mean_low5
                    total41 = given4*total482
                    total482_halves = halves(xp, total482)
                    lost37 = given4*low22 + product_error(total41, given4_halves, total482_halves)
                    total482 = total40*total47
                    total40_halves = halves(xp, total40)
                    lost36 = lift_low*total47 + product_error(total482, total47_halves,
                        total40_halves)
                    total47 = total41 + total482
                    back22 = total47 - total41
                    rest10 = total47 - back22
                    one9 = total41 - rest10
                    two9 = total482 - back22
                    lost512 = one9 + two9
                    low22 = fall_low5*total40 + lost37 + lost36 + lost512
                    total40 = total47/stiff
                    left = total47 - stiff*total40
                    total40_halves = halves(xp, total40)
                    left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                    left = left + low22
                    lost512 = left/stiff
                    apart_of = lost28 + total28
                    fall_of = lost35 + total49
                    kick_of = total222
                    kick_low_of = lost222
                    rise_of = lost512 + total40
                    return apart_of, fall_of, kick_of, kick_low_of, rise_of

                def no(envelope, half, lost2, lost222, lost28, odd, odd_low2, root, size, square2,
                    stiff, total222, total28):
                    total23 = half*odd
                    half_halves = halves(xp, half)
                    odd_halves = halves(xp, odd)
                    lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        even = total20
                        return even, even_low

                    def no(lost2, root, size):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        sine = xp.sin(root)
                        cosine = xp.cos(root)
                        even = cosine
                        even_low2 = -root_low*sine
                        return even, even_low2

                    even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (lost2, root, size))

                    total252 = total23 - even
                    back162 = total252 - total23
                    rest42 = total252 - back162
                    one32 = total23 - rest42
                    two32 = -back162 - even
                    lost252 = one32 + two32
                    total262 = envelope + total252
                    back162 = total262 - total252
                    rest42 = total262 - back162
                    one32 = total252 - rest42
                    two32 = envelope - back162
                    lost262 = one32 + two32
                    total252 = envelope*total262
                    envelope_halves = halves(xp, envelope)
                    total262_halves = halves(xp, total262)
                    lost262 = (
                        envelope*(lost23 - even_low2 + lost252 + lost262) +
                        product_error(total252, envelope_halves, total262_halves)
                    )
                    total262 = total252/stiff
                    left16 = total252 - stiff*total262
                    total262_halves = halves(xp, total262)
                    stiff_halves = halves(xp, stiff)
                    left16 = left16 - product_error(total262*stiff, total262_halves, stiff_halves)
                    left16 = left16 + lost262
                    lost262 = left16/stiff
                    total252 = even + total23
                    back162 = total252 - even
                    rest42 = total252 - back162
                    one32 = even - rest42
                    two32 = total23 - back162
                    lost252 = one32 + two32
                    total23 = envelope*total252
                    total252_halves = halves(xp, total252)
                    lost252 = (
                        envelope*(even_low2 + lost23 + lost252) +
                        product_error(total23, envelope_halves, total252_halves)
                    )
                    total252 = 1.0 - total23
                    back162 = total252 - 1.0
                    lost23 = -back162 - total23
                    total23 = total252/stiff
                    left16 = total252 - stiff*total23
                    total23_halves = halves(xp, total23)
                    left16 = left16 - product_error(total23*stiff, total23_halves, stiff_halves)
                    left16 = left16 - lost252 + lost23
                    lost23 = left16/stiff
                    apart_of = lost28 + total28
                    fall_of = lost262 + total262
                    kick_of = total222
                    kick_low_of = lost222
                    rise_of = lost23 + total23
                    return apart_of, fall_of, kick_of, kick_low_of, rise_of

                apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, half, lost2, lost24, lost27, low2, root, size, stiff, total222,
                    total28, total30, total31, total27, total37, total38, whole32), no,
                    (envelope, half, lost2, lost24, lost27, odd, odd_low2, root, size, square2,
                    stiff, total222, total28))
                )

                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, total2), no,
                (gamma, half, lost2, total2))
            )

            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        def no(delta, gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma
            mean3 = decay(xp, delta)

            def yes(lost2, square2):
                given3 = square2
                sin_series_of = sin_series(xp, given3)
                bent = given3*sin_series_of
                total21 = bent + 1.0
                back15 = total21 - 1.0
                lost21 = bent - back15
                odd_low = 0.16666666666666666*lost2 + lost21
                odd = total21
                return odd, odd_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                some = root
                total22 = sine/some
                left = sine - some*total22
                total22_halves = halves(xp, total22)
                some_halves = halves(xp, some)
                left = left - product_error(total22*some, total22_halves, some_halves)
                left = cosine*root_low + left - root_low*total22
                lost22 = left/some
                odd = total22
                odd_low2 = lost22
                return odd, odd_low2

            odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total24 = envelope*odd
            envelope_halves = halves(xp, envelope)
            odd_halves = halves(xp, odd)
            lost24 = envelope*odd_low2 + product_error(total24, envelope_halves, odd_halves)
            total25 = mean3 - total24
            back16 = total25 - mean3
            rest4 = total25 - back16
            one3 = mean3 - rest4
            two3 = -back16 - total24
            lost25 = one3 + two3
            total26 = total25/stiff
            left13 = total25 - stiff*total26
            total26_halves = halves(xp, total26)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total26*stiff, total26_halves, stiff_halves)
            left13 = left13 - lost24 + lost25
            lost25 = left13/stiff
            total25 = lost24 + total24
            back16 = total25 - total24
            lost24 = lost24 - back16

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total24 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number5_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost29 = product_error(total24, turns_halves, number5_halves)
            total30 = 2.5061182034958845e-15*turns
            number6_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost30 = product_error(total30, turns_halves, number6_halves)
            total31 = -total2 - total24
            back16 = total2 + total31
            rest4 = total31 - back16
            one3 = -rest4 - total2
            two3 = -back16 - total24
            lost31 = one3 + two3
            total24 = total31 - lost29
            back16 = total24 - total31
            rest4 = total24 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost29
            lost29 = one3 + two3
            total31 = total24 - total30
            back16 = total31 - total24
            rest4 = total31 - back16
            one3 = total24 - rest4
            two3 = -back16 - total30
            lost33 = one3 + two3
            total30 = total31 - lost2
            back16 = total30 - total31
            rest4 = total30 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost2
            lost34 = one3 + two3
            low2 = lost31 - lost30 + lost29 + lost33 + lost34 - 1.4920070805839235e-31*turns
            total31 = low2 + total30
            total24 = 6.283185307179586*count
            total37 = root + total24
            whole32 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole32
            far = (total38*total38)

            def yes(count, half, lost2, lost222, lost26, low2, root, size, stiff, total222,
                total26, total34, total35, total36, total37, total38, whole32):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back22 = total35 - total34
                rest10 = total35 - back22
                one9 = total34 - rest10
                two9 = low2 - back22
                lost35 = one9 + two9
                count_halves = halves(xp, count)
                number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                lost36 = product_error(count*6.283185307179586, count_halves, number2_halves)
                back22 = total37 - root
                rest10 = total37 - back22
                one9 = root - rest10
                two9 = total36 - back22
                lost37 = one9 + two9
                both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                left = total35 - total38*whole32
                total38_halves = halves(xp, total38)
                whole32_halves = halves(xp, whole32)
                left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                left = left - both_low*total38 + lost35
                lost35 = left/whole32
                eta = total38
                eta_low = lost35
                total39 = (eta*eta)
                eta_halves = halves(xp, eta)
                lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                cos_series_of2 = cos_series(xp, -total39)
                bent2 = cos_series_of2*(total39*total39)
                total40 = 0.5*total39 - bent2
                back22 = total40 - 0.5*total39
                lost37 = -back22 - bent2
                sin_series_of2 = sin_series(xp, -total39)
                total41 = 1.0 - sin_series_of2*total39
                back22 = total41 - 1.0
                lost36 = -back22 - sin_series_of2*total39
                lift_low = 0.5*lost35*total41 + lost37
                total39 = eta*total41
                total41_halves = halves(xp, total41)
                lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                some2 = root
                total41 = total39/some2
                left = total39 - some2*total41
                total41_halves = halves(xp, total41)
                some2_halves = halves(xp, some2)
                left = left - product_error(total41*some2, total41_halves, some2_halves)
                left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                lost36 = left/some2
                given4 = half
                total39 = 1.0 - 0.5*given4
                back22 = total39 - 1.0
                lost37 = -back22 - 0.5*given4
                decay_series_of3 = decay_series(xp, given4)
                curved4 = decay_series_of3*(given4*given4)
                total45 = curved4 + total39
                back22 = total45 - total39
                lost35 = curved4 - back22
                mean_low5 = lost37 + lost35
                total39 = given4*total45
                given4_halves = halves(xp, given4)
                total45_halves = halves(xp, total45)
                lost35 = given4*mean_low5 + product_error(total39, given4_halves, total45_halves)
                total47 = 1.0 - total39
                back22 = total47 - 1.0
                lost37 = -back22 - total39
                fall_low5 = lost37 - lost35
                total39 = total45 - total41
                back22 = total39 - total45
                rest10 = total39 - back22
                one9 = total45 - rest10
                two9 = -back22 - total41
                lost37 = one9 + two9
                total49 = given4*total39
                total39_halves = halves(xp, total39)
                lost37 = (
                    given4*(lost37 - lost36 + mean_low5) +
                    product_error(total49, given4_halves, total39_halves)
                )
                total39 = total40 - total49
                back22 = total39 - total40
                rest10 = total39 - back22
                one9 = total40 - rest10
                two9 = -back22 - total49
                lost35 = one9 + two9
                low22 = lift_low - lost37 + lost35
                total49 = low22 + total39
                back22 = total49 - total39
                rest10 = total49 - back22
                one9 = total39 - rest10
                two9 = low22 - back22
                lost35 = one9 + two9
                total39 = total47*total49
                total47_halves = halves(xp, total47)
                total49_halves = halves(xp, total49)
                lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                low22 = fall_low5*total49 + lost35
                total49 = total39/stiff
                left = total39 - stiff*total49
                total49_halves = halves(xp, total49)
                stiff_halves = halves(xp, stiff)
                left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                left = left + low22
                lost35 = left/stiff
                total39 = total41*total47
                lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                total482 = total45 - total39
                back22 = total482 - total45
                rest10 = total482 - back22
                one9 = total45 - rest10
                two9 = -back22 - total39
                lost37 = one9 + two9
                low22 = lost37 - fall_low5*total41 - lost36 + mean_low5
                total41 = given4*total482
                total482_halves = halves(xp, total482)
                lost37 = given4*low22 + product_error(total41, given4_halves, total482_halves)
                total482 = total40*total47
                total40_halves = halves(xp, total40)
                lost36 = lift_low*total47 + product_error(total482, total47_halves, total40_halves)
                total47 = total41 + total482
                back22 = total47 - total41
                rest10 = total47 - back22
                one9 = total41 - rest10
                two9 = total482 - back22
                lost512 = one9 + two9
                low22 = fall_low5*total40 + lost37 + lost36 + lost512
                total40 = total47/stiff
                left = total47 - stiff*total40
                total40_halves = halves(xp, total40)
                left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                left = left + low22
                lost512 = left/stiff
                apart_of = lost26 + total26
                fall_of = lost35 + total49
                kick_of = total222
                kick_low_of = lost222
                rise_of = lost512 + total40
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            def no(envelope, half, lost2, lost222, lost26, odd, odd_low2, root, size, square2,
                stiff, total222, total26):
                total23 = half*odd
                half_halves = halves(xp, half)
                odd_halves = halves(xp, odd)
                lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)

                def yes(lost2, square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    back13 = total19 - 1.0
                    lost19 = 0.5*given3 - back13
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total20 = curved3 + total19
                    back13 = total20 - total19
                    lost20 = curved3 - back13
                    even_low = lost19 + 0.5*lost2 + lost20
                    even = total20
                    return even, even_low

                def no(lost2, root, size):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    cosine = xp.cos(root)
                    even = cosine
                    even_low2 = -root_low*sine
                    return even, even_low2

                even, even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                    (lost2, root, size))

                total252 = total23 - even
                back162 = total252 - total23
                rest42 = total252 - back162
                one32 = total23 - rest42
                two32 = -back162 - even
                lost252 = one32 + two32
                total262 = envelope + total252
                back162 = total262 - total252
                rest42 = total262 - back162
                one32 = total252 - rest42
                two32 = envelope - back162
                lost262 = one32 + two32
                total252 = envelope*total262
                envelope_halves = halves(xp, envelope)
                total262_halves = halves(xp, total262)
                lost262 = (
                    envelope*(lost23 - even_low2 + lost252 + lost262) +
                    product_error(total252, envelope_halves, total262_halves)
                )
                total262 = total252/stiff
                left16 = total252 - stiff*total262
                total262_halves = halves(xp, total262)
                stiff_halves = halves(xp, stiff)
                left16 = left16 - product_error(total262*stiff, total262_halves, stiff_halves)
                left16 = left16 + lost262
                lost262 = left16/stiff
                total252 = even + total23
                back162 = total252 - even
                rest42 = total252 - back162
                one32 = even - rest42
                two32 = total23 - back162
                lost252 = one32 + two32
                total23 = envelope*total252
                total252_halves = halves(xp, total252)
                lost252 = (
                    envelope*(even_low2 + lost23 + lost252) +
                    product_error(total23, envelope_halves, total252_halves)
                )
                total252 = 1.0 - total23
                back162 = total252 - 1.0
                lost23 = -back162 - total23
                total23 = total252/stiff
                left16 = total252 - stiff*total23
                total23_halves = halves(xp, total23)
                left16 = left16 - product_error(total23*stiff, total23_halves, stiff_halves)
                left16 = left16 - lost252 + lost23
                lost23 = left16/stiff
                apart_of = lost26 + total26
                fall_of = lost262 + total262
                kick_of = total222
                kick_low_of = lost222
                rise_of = lost23 + total23
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, half, lost2, lost24, lost25, low2, root, size, stiff, total25, total26,
                total30, total31, total24, total37, total38, whole32), no,
                (envelope, half, lost2, lost24, lost25, odd, odd_low2, root, size, square2,
                stiff, total25, total26))
            )

            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        apart_of, fall_of, kick_of, kick_low_of, rise_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, total2), no,
            (delta, gamma, half, lost2, total2))
        )

        return apart_of, fall_of, kick_of, kick_low_of, rise_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half, lost2, reach, root, size, total2, total3):

            def yes(delta, gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back3 = total27 - 1.0
                lost54 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back3 = total55 - total27
                lost55 = curved5 - back3
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back3 = total55 - 1.0
                lost54 = -back3 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back3 = total27 - rest6
                rest5 = total27 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back3 = total55 - 1.0
                lost532 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back3 = total542 - total55
                lost542 = curved5 - back3
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back3 = total542 - 1.0
                lost532 = -back3 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back3 = total542 - rest5
                rest6 = total542 - back3
                one4 = rest5 - rest6
                two4 = 0.5 - back3
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    return fall_, fall_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    fall_ = sunk
                    fall_low2 = sunk_low
                    return fall_, fall_low2

                fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))


                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    mean2 = total11
                    return mean2, mean_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    total14 = 1.0 - sunk2
                    back11 = total14 - 1.0
                    lost14 = -back11 - sunk2
                    bottom2 = 2.0*root
                    total15 = total14/bottom2
                    left7 = total14 - bottom2*total15
                    total15_halves = halves(xp, total15)
                    bottom2_halves = halves(xp, bottom2)
                    left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                    left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                    lost14 = left7/bottom2
                    mean2 = total15
                    mean_low4 = lost14
                    return mean2, mean_low4

                mean2, mean_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no,
                    (root, root_low))

                total55 = fall_*mean2
                fall__halves = halves(xp, fall_)
                mean2_halves = halves(xp, mean2)
                lost163 = fall_*mean_low4 + product_error(total55, fall__halves, mean2_halves)
                creep_low = fall_low2*mean2 + lost163
                total232 = creep_low + total55
                back3 = total232 - total55
                lost163 = creep_low - back3
                apart_of = lost3 + total28
                fall_of = lost54*total27 + lost55 + total61
                kick_of = total232
                kick_low_of = lost163
                rise_of = lost532*total542 + lost542 + total592
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            def no(gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    mean = total5
                    return fall_, fall_low, mean, mean_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    total8 = 1.0 - sunk
                    back7 = total8 - 1.0
                    lost8 = -back7 - sunk
                    bottom = q
                    total9 = total8/bottom
                    left4 = total8 - bottom*total9
                    total9_halves = halves(xp, total9)
                    bottom_halves = halves(xp, bottom)
                    left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                    left4 = left4 + lost8 - q_low*total9 - sunk_low
                    lost8 = left4/bottom
                    fall_ = sunk
                    fall_low2 = sunk_low
                    mean = total9
                    mean_low2 = lost8
                    return fall_, fall_low2, mean, mean_low2

                fall_, fall_low2, mean, mean_low2 = (
                    select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
                )


                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    total10 = given2*total11
                    given2_halves = halves(xp, given2)
                    total11_halves = halves(xp, total11)
                    lost11 = given2*mean_low3 + product_error(total10, given2_halves,
                        total11_halves)
                    total13 = 1.0 - total10
                    back8 = total13 - 1.0
                    lost10 = -back8 - total10
                    fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                    fall2 = total13
                    mean2 = total11
                    return fall2, fall_low3, mean2, mean_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    total14 = 1.0 - sunk2
                    back11 = total14 - 1.0
                    lost14 = -back11 - sunk2
                    bottom2 = 2.0*root
                    total15 = total14/bottom2
                    left7 = total14 - bottom2*total15
                    total15_halves = halves(xp, total15)
                    bottom2_halves = halves(xp, bottom2)
                    left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                    left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                    lost14 = left7/bottom2
                    fall2 = sunk2
                    fall_low4 = sunk_low2
                    mean2 = total15
                    mean_low4 = lost14
                    return fall2, fall_low4, mean2, mean_low4

                fall2, fall_low4, mean2, mean_low4 = (
                    select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
                )

                total27 = fall2*mean
                fall2_halves = halves(xp, fall2)
                mean_halves = halves(xp, mean)
                lost162 = fall2*mean_low2 + product_error(total27, fall2_halves, mean_halves)
                pulled_low = fall_low4*mean + lost162
                total172 = mean2 - total27
                back3 = total172 - mean2
                rest6 = total172 - back3
                one4 = mean2 - rest6
                two4 = -back3 - total27
                lost162 = one4 + two4
                total27 = total172/whole
                left = total172 - total27*whole
                total27_halves = halves(xp, total27)
                left = left - product_error(total27*whole, total27_halves, whole_halves)
                left = left + lost162 + mean_low4 - p_low*total27 - pulled_low
                lost162 = left/whole
                total172 = fall_*total27
                fall__halves = halves(xp, fall_)
                lost162 = fall_*lost162 + product_error(total172, fall__halves, total27_halves)
                creep_ = fall_low2*total27 + lost162 + total172
                total172 = fall_*mean2
                mean2_halves = halves(xp, mean2)
                lost162 = fall_*mean_low4 + product_error(total172, fall__halves, mean2_halves)
                creep_low = fall_low2*mean2 + lost162
                total27 = creep_low + total172
                back3 = total27 - total172
                lost162 = creep_low - back3
                total173 = mean - total172
                back3 = total173 - mean
                rest6 = total173 - back3
                one4 = mean - rest6
                two4 = -back3 - total172
                lost173 = one4 + two4
                total172 = total173/whole
                left = total173 - total172*whole
                total172_halves = halves(xp, total172)
                left = left - product_error(total172*whole, total172_halves, whole_halves)
                left = left - creep_low + lost173 + mean_low2 - p_low*total172
                lost173 = left/whole
                apart_of = lost3 + total28
                fall_of = creep_
                kick_of = total27
                kick_low_of = lost162
                rise_of = lost173 + total172
                return apart_of, fall_of, kick_of, kick_low_of, rise_of

            apart_of, fall_of, kick_of, kick_low_of, rise_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, root, size, total2,
                total3), no, (gamma, half, lost2, root, size, total2, total3))
            )

            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        def no(delta, gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )

            twice = 2.0*fall_

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            fast = fall_*fall2
            total16 = mean2*twice
            twice_halves = halves(xp, twice)
            mean2_halves = halves(xp, mean2)
            lost3 = mean_low4*twice + product_error(total16, twice_halves, mean2_halves)
            total17 = mean - total16
            back3 = total17 - mean
            rest3 = total17 - back3
            one2 = mean - rest3
            two2 = -back3 - total16
            lost17 = one2 + two2
            total16 = fast*mean
            fast_halves = halves(xp, fast)
            mean_halves = halves(xp, mean)
            lost18 = fast*mean_low2 + product_error(total16, fast_halves, mean_halves)
            top = total17 + total16
            low = lost17 - lost3 + lost18 + mean_low2
            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            lost18 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost18
            total17 = mean2 - total16
            back3 = total17 - mean2
            rest3 = total17 - back3
            one2 = mean2 - rest3
            two2 = -back3 - total16
            lost18 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost18 + mean_low4 - p_low*total16 - pulled_low
            lost18 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost18 = fall_*lost18 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost18 + total17
            total17 = fall_*mean2
            lost18 = fall_*mean_low4 + product_error(total17, fall__halves, mean2_halves)
            creep_low = fall_low2*mean2 + lost18
            total16 = creep_low + total17
            back3 = total16 - total17
            lost18 = creep_low - back3
            total173 = mean - total17
            back3 = total173 - mean
            rest3 = total173 - back3
            one2 = mean - rest3
            two2 = -back3 - total17
            lost17 = one2 + two2
            total17 = total173/whole
            left = total173 - total17*whole
            total17_halves = halves(xp, total17)
            left = left - product_error(total17*whole, total17_halves, whole_halves)
            left = left - creep_low + lost17 + mean_low2 - p_low*total17
            lost17 = left/whole
            apart_of = (low + top)/whole3
            fall_of = creep_
            kick_of = total16
            kick_low_of = lost18
            rise_of = lost17 + total17
            return apart_of, fall_of, kick_of, kick_low_of, rise_of

        apart_of, fall_of, kick_of, kick_low_of, rise_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, root, size, total2,
            total3), no, (delta, gamma, half, lost2, root, size, total3))
        )

        return apart_of, fall_of, kick_of, kick_low_of, rise_of

    apart_of, fall_of, kick_of, kick_low_of, rise_of = (
        select(xp, total2 < 0.0, yes, (delta, gamma, half, lost, total2), no,
        (delta, gamma, half, lost, total2))
    )

    return apart_of, fall_of, kick_of, kick_low_of, rise_of


def apart_fall_nyquist_rise_together_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half, lost2, reach, total2):

            def yes(delta, gamma, half, lost2, total2):
                square2 = total2
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back17 = total27 - 1.0
                lost54 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back17 = total55 - total27
                lost55 = curved5 - back17
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back17 = total55 - 1.0
                lost54 = -back17 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back17 = total27 - rest6
                rest5 = total27 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                twice2 = 2.0*envelope
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back17 = total55 - 1.0
                lost532 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back17 = total542 - total55
                lost542 = curved5 - back17
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back17 = total542 - 1.0
                lost532 = -back17 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back17 = total542 - rest5
                rest6 = total542 - back17
                one4 = rest5 - rest6
                two4 = 0.5 - back17
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)
                rest6 = together_series(xp, half, total2)
                total55 = rest6 + 0.5
                back17 = total55 - rest6
                rest5 = total55 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost553 = one4 + two4
                total563 = envelope*total55
                total55_halves = halves(xp, total55)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total55_halves)

                def yes(square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total19 = curved3 + total19
                    even = total19
                    return even

                def no(total2):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    cosine = xp.cos(root)
                    even = cosine
                    return even

                even = select(xp, square2 > -1.5, yes, (square2,), no, (total2,))

                total55 = even*twice2

                def yes(delta, even, lost2, lost28, lost563, lost572, lost59, lost592, lost61,
                    square2, total2, total263, total28, total563, total582, total592, total60,
                    total61, twice2):
                    e = xp.exp(-delta)
                    total253 = e + 1.0
                    back182 = total253 - 1.0
                    lost253 = e - back182
                    total273 = total253 + total263
                    back182 = total273 - total253
                    lost273 = total263 - back182

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(lost2, total2):
                        size = xp.abs(total2)
                        root = square_root(xp, size)
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (lost2, total2))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost263 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost28 + total28
                    fall_of = lost59*total60 + lost61 + total61
                    nyquist_of = lost253 + lost263 + lost273 + total273
                    rise_of = lost572*total582 + lost592 + total592
                    together_of = 2.0*lost563 + 2.0*total563
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(envelope, half, lost2, lost28, lost563, lost572, lost59, lost592, lost61,
                    total2, total28, total563, total582, total592, total60, total61):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back72 = 0.5*root_low*sin_of
                    total92 = wave - back72
                    back82 = total92 - wave
                    rest33 = total92 - back82
                    one23 = wave - rest33
                    two23 = -back72 - back82
                    lost92 = one23 + two23
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low4 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low4 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest33 = total102 - back82
                    one23 = total92 - rest33
                    two23 = (grown*grown) - back82
                    lost102 = one23 + two23
                    low4 = lost92 + lost102
                    apart_of = lost28 + total28
                    fall_of = lost59*total60 + lost61 + total61
                    nyquist_of = 4.0*low4 + 4.0*total102
                    rise_of = lost572*total582 + lost592 + total592
                    together_of = 2.0*lost563 + 2.0*total563
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, total55 > 0.0, yes, (delta, even, lost2, lost27, lost553, lost532,
                    lost54, lost542, lost55, square2, total2, total55, total28, total563,
                    total542, total592, total27, total61, twice2), no,
                    (envelope, half, lost2, lost27, lost553, lost532, lost54, lost542, lost55,
                    total2, total28, total563, total542, total592, total27, total61))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            def no(delta, gamma, half, lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
                twice2 = 2.0*envelope
                rest6 = together_series(xp, half, total2)
                total27 = rest6 + 0.5
                back17 = total27 - rest6
                rest5 = total27 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost553 = one4 + two4
                total563 = envelope*total27
                total27_halves = halves(xp, total27)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total27_halves)

                def yes(square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total19 = curved3 + total19
                    even = total19
                    return even

                def no(root):
                    cosine = xp.cos(root)
                    even = cosine
                    return even

                even = select(xp, square2 > -1.5, yes, (square2,), no, (root,))

                total27 = even*twice2

                def yes(root):
                    count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                    return count

                def no(root):
                    return 0.0

                count = select(xp, root < 4096.0, yes, (root,), no, (root,))

                turns = (count*count)
                total29 = 39.478416442871094*turns
                turns_halves = halves(xp, turns)
                number4_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
                lost29 = product_error(total29, turns_halves, number4_halves)
                total30 = 1.1614863524300745e-06*turns
                number5_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
                lost30 = product_error(total30, turns_halves, number5_halves)
                total31 = -total2 - total29
                back17 = total2 + total31
                rest5 = total31 - back17
                one4 = -rest5 - total2
                two4 = -back17 - total29
                lost31 = one4 + two4
                total29 = total31 - lost29
                back17 = total29 - total31
                rest5 = total29 - back17
                one4 = total31 - rest5
                two4 = -back17 - lost29
                lost29 = one4 + two4
                total31 = total29 - total30
                back17 = total31 - total29
                rest5 = total31 - back17
                one4 = total29 - rest5
                two4 = -back17 - total30
                lost33 = one4 + two4
                total30 = total31 - lost2
                back17 = total30 - total31
                rest5 = total30 - back17
                one4 = total31 - rest5
                two4 = -back17 - lost2
                lost34 = one4 + two4
                low2 = lost31 - lost30 + lost29 + lost33 + lost34 + 1.1704736640094811e-14*turns
                total31 = low2 + total30
                total29 = 6.2831854820251465*count
                total37 = root + total29
                whole32 = xp.where(total37 == 0.0, 1.0, total37)
                total38 = total31/whole32
                far = (total38*total38)

                def yes(count, delta, envelope, even, half, lost2, lost28, lost563, low2, root,
                    size, square2, stiff, total263, total28, total34, total35, total36, total37,
                    total38, total563, twice2, whole32):

                    def yes(count, delta, even, half, lost2, lost28, lost563, low2, root, size,
                        square2, stiff, total263, total28, total34, total35, total36, total37,
                        total38, total563, twice2, whole32):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        back22 = total35 - total34
                        rest10 = total35 - back22
                        one9 = total34 - rest10
                        two9 = low2 - back22
                        lost35 = one9 + two9
                        count_halves = halves(xp, count)
                        number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                        lost36 = product_error(count*6.2831854820251465, count_halves,
                            number2_halves)
                        back22 = total37 - root
                        rest10 = total37 - back22
                        one9 = root - rest10
                        two9 = total36 - back22
                        lost37 = one9 + two9
                        both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                        left = total35 - total38*whole32
                        total38_halves = halves(xp, total38)
                        whole32_halves = halves(xp, whole32)
                        left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                        left = left - both_low*total38 + lost35
                        lost35 = left/whole32
                        eta = total38
                        eta_low = lost35
                        total39 = (eta*eta)
                        eta_halves = halves(xp, eta)
                        lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                        cos_series_of2 = cos_series(xp, -total39)
                        bent2 = cos_series_of2*(total39*total39)
                        total40 = 0.5*total39 - bent2
                        back22 = total40 - 0.5*total39
                        lost37 = -back22 - bent2
                        sin_series_of2 = sin_series(xp, -total39)
                        total41 = 1.0 - sin_series_of2*total39
                        back22 = total41 - 1.0
                        lost36 = -back22 - sin_series_of2*total39
                        lift_low = 0.5*lost35*total41 + lost37
                        total39 = eta*total41
                        total41_halves = halves(xp, total41)
                        lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                        some2 = root
                        total41 = total39/some2
                        left = total39 - some2*total41
                        total41_halves = halves(xp, total41)
                        some2_halves = halves(xp, some2)
                        left = left - product_error(total41*some2, total41_halves, some2_halves)
                        left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                        lost36 = left/some2
                        given4 = half
                        total39 = 1.0 - 0.5*given4
                        back22 = total39 - 1.0
                        lost37 = -back22 - 0.5*given4
                        decay_series_of3 = decay_series(xp, given4)
                        curved4 = decay_series_of3*(given4*given4)
                        total45 = curved4 + total39
                        back22 = total45 - total39
                        lost35 = curved4 - back22
                        mean_low5 = lost37 + lost35
                        total39 = given4*total45
                        given4_halves = halves(xp, given4)
                        total45_halves = halves(xp, total45)
                        lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                            total45_halves)
                        total47 = 1.0 - total39
                        back22 = total47 - 1.0
                        lost37 = -back22 - total39
                        fall_low5 = lost37 - lost35
                        total39 = total45 - total41
                        back22 = total39 - total45
                        rest10 = total39 - back22
                        one9 = total45 - rest10
                        two9 = -back22 - total41
                        lost37 = one9 + two9
                        total49 = given4*total39
                        total39_halves = halves(xp, total39)
                        lost37 = (
                            given4*(lost37 - lost36 + mean_low5) +
                            product_error(total49, given4_halves, total39_halves)
                        )
                        total39 = total40 - total49
                        back22 = total39 - total40
                        rest10 = total39 - back22
                        one9 = total40 - rest10
                        two9 = -back22 - total49
                        lost35 = one9 + two9
                        low22 = lift_low - lost37 + lost35
                        total49 = low22 + total39
                        back22 = total49 - total39
                        rest10 = total49 - back22
                        one9 = total39 - rest10
                        two9 = low22 - back22
                        lost35 = one9 + two9
                        total39 = total47*total49
                        total47_halves = halves(xp, total47)
                        total49_halves = halves(xp, total49)
                        lost35 = lost35*total47 + product_error(total39, total47_halves,
                            total49_halves)
                        low22 = fall_low5*total49 + lost35
                        total49 = total39/stiff
                        left = total39 - stiff*total49
                        total49_halves = halves(xp, total49)
                        stiff_halves = halves(xp, stiff)
                        left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                        left = left + low22
                        lost35 = left/stiff
                        e = xp.exp(-delta)
                        total39 = e + 1.0
                        back22 = total39 - 1.0
                        lost37 = e - back22
                        total273 = total39 + total263
                        back22 = total273 - total39
                        lost273 = total263 - back22
                        total39 = total41*total47
                        lost36 = lost36*total47 + product_error(total39, total47_halves,
                            total41_halves)
                        total482 = total45 - total39
                        back22 = total482 - total45
                        rest10 = total482 - back22
                        one9 = total45 - rest10
                        two9 = -back22 - total39
                        lost482 = one9 + two9
                        low22 = lost482 - fall_low5*total41 - lost36 + mean_low5
                        total41 = given4*total482
                        total482_halves = halves(xp, total482)
                        lost482 = given4*low22 + product_error(total41, given4_halves,
                            total482_halves)
                        total482 = total40*total47
                        total40_halves = halves(xp, total40)
                        lost36 = lift_low*total47 + product_error(total482, total47_halves,
                            total40_halves)
                        total47 = total41 + total482
                        back22 = total47 - total41
                        rest10 = total47 - back22
                        one9 = total41 - rest10
                        two9 = total482 - back22
                        lost512 = one9 + two9
                        low22 = fall_low5*total40 + lost482 + lost36 + lost512
                        total40 = total47/stiff
                        left = total47 - stiff*total40
                        total40_halves = halves(xp, total40)
                        left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                        left = left + low22
                        lost512 = left/stiff

                        def yes(lost2, square2):
                            given3 = square2
                            total19 = 0.5*given3 + 1.0
                            back13 = total19 - 1.0
                            lost19 = 0.5*given3 - back13
                            cos_series_of = cos_series(xp, given3)
                            curved3 = cos_series_of*(given3*given3)
                            total20 = curved3 + total19
                            back13 = total20 - total19
                            lost20 = curved3 - back13
                            even_low = lost19 + 0.5*lost2 + lost20
                            return even_low

                        def no(root, root_low):
                            sine = xp.sin(root)
                            even_low2 = -root_low*sine
                            return even_low2

                        even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                            (root, root_low))

                        twice2_halves = halves(xp, twice2)
                        even_halves = halves(xp, even)
                        lost36 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                            even_halves)
                        apart_of = lost28 + total28
                        fall_of = lost35 + total49
                        nyquist_of = lost37 + lost36 + lost273 + total273
                        rise_of = lost512 + total40
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    def no(count, envelope, half, lost2, lost28, lost563, low2, root, size, stiff,
                        total28, total34, total35, total36, total37, total38, total563, whole32):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        back22 = total35 - total34
                        rest10 = total35 - back22
                        one9 = total34 - rest10
                        two9 = low2 - back22
                        lost35 = one9 + two9
                        count_halves = halves(xp, count)
                        number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                        lost36 = product_error(count*6.2831854820251465, count_halves,
                            number2_halves)
                        back22 = total37 - root
                        rest10 = total37 - back22
                        one9 = root - rest10
                        two9 = total36 - back22
                        lost37 = one9 + two9
                        both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                        left = total35 - total38*whole32
                        total38_halves = halves(xp, total38)
                        whole32_halves = halves(xp, whole32)
                        left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                        left = left - both_low*total38 + lost35
                        lost35 = left/whole32
                        eta = total38
                        eta_low = lost35
                        total39 = (eta*eta)
                        eta_halves = halves(xp, eta)
                        lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                        cos_series_of2 = cos_series(xp, -total39)
                        bent2 = cos_series_of2*(total39*total39)
                        total40 = 0.5*total39 - bent2
                        back22 = total40 - 0.5*total39
                        lost37 = -back22 - bent2
                        sin_series_of2 = sin_series(xp, -total39)
                        total41 = 1.0 - sin_series_of2*total39
                        back22 = total41 - 1.0
                        lost36 = -back22 - sin_series_of2*total39
                        lift_low = 0.5*lost35*total41 + lost37
                        total39 = eta*total41
                        total41_halves = halves(xp, total41)
                        lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                        some2 = root
                        total41 = total39/some2
                        left = total39 - some2*total41
                        total41_halves = halves(xp, total41)
                        some2_halves = halves(xp, some2)
                        left = left - product_error(total41*some2, total41_halves, some2_halves)
                        left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                        lost36 = left/some2
                        given4 = half
                        total39 = 1.0 - 0.5*given4
                        back22 = total39 - 1.0
                        lost37 = -back22 - 0.5*given4
                        decay_series_of3 = decay_series(xp, given4)
                        curved4 = decay_series_of3*(given4*given4)
                        total45 = curved4 + total39
                        back22 = total45 - total39
                        lost35 = curved4 - back22
                        mean_low5 = lost37 + lost35
                        total39 = given4*total45
                        given4_halves = halves(xp, given4)
                        total45_halves = halves(xp, total45)
                        lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                            total45_halves)
                        total47 = 1.0 - total39
                        back22 = total47 - 1.0
                        lost37 = -back22 - total39
                        fall_low5 = lost37 - lost35
                        total39 = total45 - total41
                        back22 = total39 - total45
                        rest10 = total39 - back22
                        one9 = total45 - rest10
                        two9 = -back22 - total41
                        lost37 = one9 + two9
                        total49 = given4*total39
                        total39_halves = halves(xp, total39)
                        lost37 = (
                            given4*(lost37 - lost36 + mean_low5) +
                            product_error(total49, given4_halves, total39_halves)
                        )
                        total39 = total40 - total49
                        back22 = total39 - total40
                        rest10 = total39 - back22
                        one9 = total40 - rest10
                        two9 = -back22 - total49
                        lost35 = one9 + two9
                        low22 = lift_low - lost37 + lost35
                        total49 = low22 + total39
                        back22 = total49 - total39
                        rest10 = total49 - back22
                        one9 = total39 - rest10
                        two9 = low22 - back22
                        lost35 = one9 + two9
                        total39 = total47*total49
                        total47_halves = halves(xp, total47)
                        total49_halves = halves(xp, total49)
                        lost35 = lost35*total47 + product_error(total39, total47_halves,
                            total49_halves)
                        low22 = fall_low5*total49 + lost35
                        total49 = total39/stiff
                        left = total39 - stiff*total49
                        total49_halves = halves(xp, total49)
                        stiff_halves = halves(xp, stiff)
                        left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                        left = left + low22
                        lost35 = left/stiff
                        expm1_of = xp.expm1(-half)
                        grown = -0.5*expm1_of
                        angle = 0.5*root
                        wave = xp.cos(angle)
                        sin_of = xp.sin(angle)
                        back22 = 0.5*root_low*sin_of
                        total39 = wave - back22
                        back82 = total39 - wave
                        rest10 = total39 - back82
                        one9 = wave - rest10
                        two9 = -back22 - back82
                        lost37 = one9 + two9
                        total102 = (total39*total39)
                        total39_halves = halves(xp, total39)
                        lost102 = product_error(total102, total39_halves, total39_halves)
                        low22 = lost102 + 2.0*lost37*total39
                        total39 = envelope*total102
                        envelope_halves = halves(xp, envelope)
                        total102_halves = halves(xp, total102)
                        lost37 = envelope*low22 + product_error(total39, envelope_halves,
                            total102_halves)
                        total102 = (grown*grown) + total39
                        back82 = total102 - total39
                        rest10 = total102 - back82
                        one9 = total39 - rest10
                        two9 = (grown*grown) - back82
                        lost102 = one9 + two9
                        low22 = lost37 + lost102
                        total39 = total41*total47
                        lost36 = lost36*total47 + product_error(total39, total47_halves,
                            total41_halves)
                        total482 = total45 - total39
                        back82 = total482 - total45
                        rest10 = total482 - back82
                        one9 = total45 - rest10
                        two9 = -back82 - total39
                        lost102 = one9 + two9
                        low24 = lost102 - fall_low5*total41 - lost36 + mean_low5
                        total41 = given4*total482
                        total482_halves = halves(xp, total482)
                        lost102 = given4*low24 + product_error(total41, given4_halves,
                            total482_halves)
                        total482 = total40*total47
                        total40_halves = halves(xp, total40)
                        lost36 = lift_low*total47 + product_error(total482, total47_halves,
                            total40_halves)
                        total47 = total41 + total482
                        back82 = total47 - total41
                        rest10 = total47 - back82
                        one9 = total41 - rest10
                        two9 = total482 - back82
                        lost37 = one9 + two9
                        low24 = fall_low5*total40 + lost102 + lost36 + lost37
                        total40 = total47/stiff
                        left = total47 - stiff*total40
                        total40_halves = halves(xp, total40)
                        left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                        left = left + low24
                        lost37 = left/stiff
                        apart_of = lost28 + total28
                        fall_of = lost35 + total49
                        nyquist_of = 4.0*low22 + 4.0*total102
                        rise_of = lost37 + total40
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    apart_of, fall_of, nyquist_of, rise_of, together_of = (
                        select(xp, total263 > 0.0, yes,
                        (count, delta, even, half, lost2, lost28, lost563, low2, root, size,
                        square2, stiff, total263, total28, total34, total35, total36, total37,
                        total38, total563, twice2, whole32), no,
                        (count, envelope, half, lost2, lost28, lost563, low2, root, size,
                        stiff, total28, total34, total35, total36, total37, total38, total563,
                        whole32))
                    )

                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(delta, envelope, even, half, lost2, lost28, lost563, root, size, square2,
                    stiff, total263, total28, total563, twice2):

                    def yes(delta, envelope, even, half, lost2, lost28, lost563, root, size,
                        square2, stiff, total263, total28, total563, twice2):
                        e = xp.exp(-delta)
                        total253 = e + 1.0
                        back182 = total253 - 1.0
                        lost253 = e - back182
                        total273 = total253 + total263
                        back182 = total273 - total253
                        lost273 = total263 - back182

                        def yes(lost2, square2):
                            given3 = square2
                            total19 = 0.5*given3 + 1.0
                            back13 = total19 - 1.0
                            lost19 = 0.5*given3 - back13
                            cos_series_of = cos_series(xp, given3)
                            curved3 = cos_series_of*(given3*given3)
                            total20 = curved3 + total19
                            back13 = total20 - total19
                            lost20 = curved3 - back13
                            even_low = lost19 + 0.5*lost2 + lost20
                            sin_series_of = sin_series(xp, given3)
                            bent = given3*sin_series_of
                            total20 = bent + 1.0
                            back13 = total20 - 1.0
                            lost20 = bent - back13
                            odd_low = 0.16666666666666666*lost2 + lost20
                            odd = total20
                            return even_low, odd, odd_low

                        def no(lost2, root, size):
                            sign_low = -lost2
                            left = size - (root*root)
                            root_halves = halves(xp, root)
                            left = left - product_error(root*root, root_halves, root_halves)
                            left = left + sign_low
                            whole = xp.where(root == 0.0, 1.0, root)
                            root_low = 0.5*left/whole
                            sine = xp.sin(root)
                            cosine = xp.cos(root)
                            some = root
                            total22 = sine/some
                            left = sine - some*total22
                            total22_halves = halves(xp, total22)
                            some_halves = halves(xp, some)
                            left = left - product_error(total22*some, total22_halves, some_halves)
                            left = cosine*root_low + left - root_low*total22
                            lost22 = left/some
                            even_low2 = -root_low*sine
                            odd = total22
                            odd_low2 = lost22
                            return even_low2, odd, odd_low2

                        even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes,
                            (lost2, square2), no, (lost2, root, size))

                        total253 = half*odd
                        half_halves = halves(xp, half)
                        odd_halves = halves(xp, odd)
                        lost23 = half*odd_low2 + product_error(total253, half_halves, odd_halves)
                        total252 = total253 - even
                        back182 = total252 - total253
                        rest42 = total252 - back182
                        one32 = total253 - rest42
                        two32 = -back182 - even
                        lost252 = one32 + two32
                        total262 = envelope + total252
                        back182 = total262 - total252
                        rest42 = total262 - back182
                        one32 = total252 - rest42
                        two32 = envelope - back182
                        lost262 = one32 + two32
                        total252 = envelope*total262
                        envelope_halves = halves(xp, envelope)
                        total262_halves = halves(xp, total262)
                        lost262 = (
                            envelope*(lost23 - even_low2 + lost252 + lost262) +
                            product_error(total252, envelope_halves, total262_halves)
                        )
                        total262 = total252/stiff
                        left16 = total252 - stiff*total262
                        total262_halves = halves(xp, total262)
                        stiff_halves = halves(xp, stiff)
                        left16 = left16 - product_error(total262*stiff, total262_halves,
                            stiff_halves)
                        left16 = left16 + lost262
                        lost262 = left16/stiff
                        twice2_halves = halves(xp, twice2)
                        even_halves = halves(xp, even)
                        lost252 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                            even_halves)
                        total252 = even + total253
                        back182 = total252 - even
                        rest42 = total252 - back182
                        one32 = even - rest42
                        two32 = total253 - back182
                        lost242 = one32 + two32
                        total253 = envelope*total252
                        total252_halves = halves(xp, total252)
                        lost242 = (
                            envelope*(even_low2 + lost23 + lost242) +
                            product_error(total253, envelope_halves, total252_halves)
                        )
                        total252 = 1.0 - total253
                        back182 = total252 - 1.0
                        lost23 = -back182 - total253
                        total253 = total252/stiff
                        left16 = total252 - stiff*total253
                        total253_halves = halves(xp, total253)
                        left16 = left16 - product_error(total253*stiff, total253_halves,
                            stiff_halves)
                        left16 = left16 - lost242 + lost23
                        lost23 = left16/stiff
                        apart_of = lost28 + total28
                        fall_of = lost262 + total262
                        nyquist_of = lost253 + lost252 + lost273 + total273
                        rise_of = lost23 + total253
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    def no(envelope, even, half, lost2, lost28, lost563, root, size, square2,
                        stiff, total28, total563):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        expm1_of = xp.expm1(-half)
                        grown = -0.5*expm1_of
                        angle = 0.5*root
                        wave = xp.cos(angle)
                        sin_of = xp.sin(angle)
                        back72 = 0.5*root_low*sin_of
                        total92 = wave - back72
                        back82 = total92 - wave
                        rest33 = total92 - back82
                        one23 = wave - rest33
                        two23 = -back72 - back82
                        lost92 = one23 + two23
                        total102 = (total92*total92)
                        total92_halves = halves(xp, total92)
                        lost102 = product_error(total102, total92_halves, total92_halves)
                        low4 = lost102 + 2.0*lost92*total92
                        total92 = envelope*total102
                        envelope_halves = halves(xp, envelope)
                        total102_halves = halves(xp, total102)
                        lost92 = envelope*low4 + product_error(total92, envelope_halves,
                            total102_halves)
                        total102 = (grown*grown) + total92
                        back82 = total102 - total92
                        rest33 = total102 - back82
                        one23 = total92 - rest33
                        two23 = (grown*grown) - back82
                        lost102 = one23 + two23
                        low4 = lost92 + lost102

                        def yes(lost2, square2):
                            given3 = square2
                            total19 = 0.5*given3 + 1.0
                            back13 = total19 - 1.0
                            lost19 = 0.5*given3 - back13
                            cos_series_of = cos_series(xp, given3)
                            curved3 = cos_series_of*(given3*given3)
                            total20 = curved3 + total19
                            back13 = total20 - total19
                            lost20 = curved3 - back13
                            even_low = lost19 + 0.5*lost2 + lost20
                            sin_series_of = sin_series(xp, given3)
                            bent = given3*sin_series_of
                            total20 = bent + 1.0
                            back13 = total20 - 1.0
                            lost20 = bent - back13
                            odd_low = 0.16666666666666666*lost2 + lost20
                            odd = total20
                            return even_low, odd, odd_low

                        def no(root, root_low):
                            sine = xp.sin(root)
                            cosine = xp.cos(root)
                            some = root
                            total22 = sine/some
                            left10 = sine - some*total22
                            total22_halves = halves(xp, total22)
                            some_halves = halves(xp, some)
                            left10 = left10 - product_error(total22*some, total22_halves,
                                some_halves)
                            left10 = cosine*root_low + left10 - root_low*total22
                            lost22 = left10/some
                            even_low2 = -root_low*sine
                            odd = total22
                            odd_low2 = lost22
                            return even_low2, odd, odd_low2

                        even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes,
                            (lost2, square2), no, (root, root_low))

                        total92 = half*odd
                        half_halves = halves(xp, half)
                        odd_halves = halves(xp, odd)
                        lost102 = half*odd_low2 + product_error(total92, half_halves, odd_halves)
                        total252 = total92 - even
                        back82 = total252 - total92
                        rest33 = total252 - back82
                        one23 = total92 - rest33
                        two23 = -back82 - even
                        lost92 = one23 + two23
                        total262 = envelope + total252
                        back82 = total262 - total252
                        rest33 = total262 - back82
                        one23 = total252 - rest33
                        two23 = envelope - back82
                        lost262 = one23 + two23
                        total252 = envelope*total262
                        total262_halves = halves(xp, total262)
                        lost262 = (
                            envelope*(lost102 - even_low2 + lost92 + lost262) +
                            product_error(total252, envelope_halves, total262_halves)
                        )
                        total262 = total252/stiff
                        left = total252 - stiff*total262
                        total262_halves = halves(xp, total262)
                        stiff_halves = halves(xp, stiff)
                        left = left - product_error(total262*stiff, total262_halves, stiff_halves)
                        left = left + lost262
                        lost262 = left/stiff
                        total252 = even + total92
                        back82 = total252 - even
                        rest33 = total252 - back82
                        one23 = even - rest33
                        two23 = total92 - back82
                        lost92 = one23 + two23
                        total92 = envelope*total252
                        total252_halves = halves(xp, total252)
                        lost92 = (
                            envelope*(even_low2 + lost102 + lost92) +
                            product_error(total92, envelope_halves, total252_halves)
                        )
                        total252 = 1.0 - total92
                        back82 = total252 - 1.0
                        lost102 = -back82 - total92
                        total92 = total252/stiff
                        left = total252 - stiff*total92
                        total92_halves = halves(xp, total92)
                        left = left - product_error(total92*stiff, total92_halves, stiff_halves)
                        left = left - lost92 + lost102
                        lost102 = left/stiff
                        apart_of = lost28 + total28
                        fall_of = lost262 + total262
                        nyquist_of = 4.0*low4 + 4.0*total102
                        rise_of = lost102 + total92
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    apart_of, fall_of, nyquist_of, rise_of, together_of = (
                        select(xp, total263 > 0.0, yes,
                        (delta, envelope, even, half, lost2, lost28, lost563, root, size,
                        square2, stiff, total263, total28, total563, twice2), no,
                        (envelope, even, half, lost2, lost28, lost563, root, size, square2,
                        stiff, total28, total563))
                    )

                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, delta, envelope, even, half, lost2, lost27, lost553, low2, root,
                    size, square2, stiff, total27, total28, total30, total31, total29, total37,
                    total38, total563, twice2, whole32), no,
                    (delta, envelope, even, half, lost2, lost27, lost553, root, size, square2,
                    stiff, total27, total28, total563, twice2))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            apart_of, fall_of, nyquist_of, rise_of, together_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, total2), no,
                (delta, gamma, half, lost2, total2))
            )

            return apart_of, fall_of, nyquist_of, rise_of, together_of

        def no(delta, gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma
            mean3 = decay(xp, delta)
            twice2 = 2.0*envelope

            def yes(lost2, square2):
                given3 = square2
                total19 = 0.5*given3 + 1.0
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total19 = curved3 + total19
                sin_series_of = sin_series(xp, given3)
                bent = given3*sin_series_of
                total21 = bent + 1.0
                back15 = total21 - 1.0
                lost21 = bent - back15
                odd_low = 0.16666666666666666*lost2 + lost21
                even = total19
                odd = total21
                return even, odd, odd_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                some = root
                total22 = sine/some
                left = sine - some*total22
                total22_halves = halves(xp, total22)
                some_halves = halves(xp, some)
                left = left - product_error(total22*some, total22_halves, some_halves)
                left = cosine*root_low + left - root_low*total22
                lost22 = left/some
                even = cosine
                odd = total22
                odd_low2 = lost22
                return even, odd, odd_low2

            even, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total24 = envelope*odd
            envelope_halves = halves(xp, envelope)
            odd_halves = halves(xp, odd)
            lost24 = envelope*odd_low2 + product_error(total24, envelope_halves, odd_halves)
            total25 = mean3 - total24
            back16 = total25 - mean3
            rest4 = total25 - back16
            one3 = mean3 - rest4
            two3 = -back16 - total24
            lost25 = one3 + two3
            total24 = total25/stiff
            left13 = total25 - stiff*total24
            total24_halves = halves(xp, total24)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total24*stiff, total24_halves, stiff_halves)
            left13 = left13 - lost24 + lost25
            lost25 = left13/stiff
            total25 = even*twice2

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total29 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number5_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost24 = product_error(total29, turns_halves, number5_halves)
            total30 = 1.1614863524300745e-06*turns
            number6_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost30 = product_error(total30, turns_halves, number6_halves)
            total31 = -total2 - total29
            back16 = total2 + total31
            rest4 = total31 - back16
            one3 = -rest4 - total2
            two3 = -back16 - total29
            lost31 = one3 + two3
            total29 = total31 - lost24
            back16 = total29 - total31
            rest4 = total29 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost24
            lost24 = one3 + two3
            total31 = total29 - total30
            back16 = total31 - total29
            rest4 = total31 - back16
            one3 = total29 - rest4
            two3 = -back16 - total30
            lost33 = one3 + two3
            total30 = total31 - lost2
            back16 = total30 - total31
            rest4 = total30 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost2
            lost34 = one3 + two3
            low2 = lost31 - lost30 + lost24 + lost33 + lost34 + 1.1704736640094811e-14*turns
            total31 = low2 + total30
            total29 = 6.2831854820251465*count
            total37 = root + total29
            whole32 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole32
            far = (total38*total38)

            def yes(count, delta, envelope, even, half, lost2, lost26, low2, root, size, square2,
                stiff, total26, total263, total34, total35, total36, total37, total38, twice2,
                whole32):

                def yes(count, delta, even, half, lost2, lost26, low2, root, size, square2, stiff,
                    total26, total263, total34, total35, total36, total37, total38, twice2,
                    whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    back22 = total35 - total34
                    rest10 = total35 - back22
                    one9 = total34 - rest10
                    two9 = low2 - back22
                    lost35 = one9 + two9
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                    lost36 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                    back22 = total37 - root
                    rest10 = total37 - back22
                    one9 = root - rest10
                    two9 = total36 - back22
                    lost37 = one9 + two9
                    both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                    left = total35 - total38*whole32
                    total38_halves = halves(xp, total38)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                    left = left - both_low*total38 + lost35
                    lost35 = left/whole32
                    eta = total38
                    eta_low = lost35
                    total39 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total39)
                    bent2 = cos_series_of2*(total39*total39)
                    total40 = 0.5*total39 - bent2
                    back22 = total40 - 0.5*total39
                    lost37 = -back22 - bent2
                    sin_series_of2 = sin_series(xp, -total39)
                    total41 = 1.0 - sin_series_of2*total39
                    back22 = total41 - 1.0
                    lost36 = -back22 - sin_series_of2*total39
                    lift_low = 0.5*lost35*total41 + lost37
                    total39 = eta*total41
                    total41_halves = halves(xp, total41)
                    lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                    some2 = root
                    total41 = total39/some2
                    left = total39 - some2*total41
                    total41_halves = halves(xp, total41)
                    some2_halves = halves(xp, some2)
                    left = left - product_error(total41*some2, total41_halves, some2_halves)
                    left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                    lost36 = left/some2
                    given4 = half
                    total39 = 1.0 - 0.5*given4
                    back22 = total39 - 1.0
                    lost37 = -back22 - 0.5*given4
                    decay_series_of3 = decay_series(xp, given4)
                    curved4 = decay_series_of3*(given4*given4)
                    total45 = curved4 + total39
                    back22 = total45 - total39
                    lost35 = curved4 - back22
                    mean_low5 = lost37 + lost35
                    total39 = given4*total45
                    given4_halves = halves(xp, given4)
                    total45_halves = halves(xp, total45)
                    lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                        total45_halves)
                    total47 = 1.0 - total39
                    back22 = total47 - 1.0
                    lost37 = -back22 - total39
                    fall_low5 = lost37 - lost35
                    total39 = total45 - total41
                    back22 = total39 - total45
                    rest10 = total39 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total41
                    lost37 = one9 + two9
                    total49 = given4*total39
                    total39_halves = halves(xp, total39)
                    lost37 = (
                        given4*(lost37 - lost36 + mean_low5) +
                        product_error(total49, given4_halves, total39_halves)
                    )
                    total39 = total40 - total49
                    back22 = total39 - total40
                    rest10 = total39 - back22
                    one9 = total40 - rest10
                    two9 = -back22 - total49
                    lost35 = one9 + two9
                    low22 = lift_low - lost37 + lost35
                    total49 = low22 + total39
                    back22 = total49 - total39
                    rest10 = total49 - back22
                    one9 = total39 - rest10
                    two9 = low22 - back22
                    lost35 = one9 + two9
                    total39 = total47*total49
                    total47_halves = halves(xp, total47)
                    total49_halves = halves(xp, total49)
                    lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                    low22 = fall_low5*total49 + lost35
                    total49 = total39/stiff
                    left = total39 - stiff*total49
                    total49_halves = halves(xp, total49)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                    left = left + low22
                    lost35 = left/stiff
                    e = xp.exp(-delta)
                    total39 = e + 1.0
                    back22 = total39 - 1.0
                    lost37 = e - back22
                    total273 = total39 + total263
                    back22 = total273 - total39
                    lost273 = total263 - back22
                    total39 = total41*total47
                    lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                    total482 = total45 - total39
                    back22 = total482 - total45
                    rest10 = total482 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total39
                    lost482 = one9 + two9
                    low22 = lost482 - fall_low5*total41 - lost36 + mean_low5
                    total41 = given4*total482
                    total482_halves = halves(xp, total482)
                    lost482 = given4*low22 + product_error(total41, given4_halves, total482_halves)
                    total482 = total40*total47
                    total40_halves = halves(xp, total40)
                    lost36 = lift_low*total47 + product_error(total482, total47_halves,
                        total40_halves)
                    total39 = total41 + total482
                    back22 = total39 - total41
                    rest10 = total39 - back22
                    one9 = total41 - rest10
                    two9 = total482 - back22
                    lost512 = one9 + two9
                    low22 = fall_low5*total40 + lost482 + lost36 + lost512
                    total41 = total39/stiff
                    left = total39 - stiff*total41
                    total41_halves = halves(xp, total41)
                    left = left - product_error(total41*stiff, total41_halves, stiff_halves)
                    left = left + low22
                    lost512 = left/stiff
                    total39 = 1.0 - total47
                    back22 = total39 - 1.0
                    lost482 = -back22 - total47
                    low22 = lost482 - fall_low5
                    total47 = low22 + total39
                    back22 = total47 - total39
                    lost482 = low22 - back22
                    total39 = (total47*total47)
                    total47_halves = halves(xp, total47)
                    lost482 = 2.0*lost482*total47 + product_error(total39, total47_halves,
                        total47_halves)
                    total47 = total39 + 2.0*total482
                    back22 = total47 - total39
                    rest10 = total47 - back22
                    one9 = total39 - rest10
                    two9 = 2.0*total482 - back22
                    lost372 = one9 + two9
                    low22 = 2.0*fall_low5*total40 + lost482 + lost372 + 2.0*lost36
                    total40 = total47/stiff
                    left = total47 - stiff*total40
                    total40_halves = halves(xp, total40)
                    left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                    left = left + low22
                    lost372 = left/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost482 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost26 + total26
                    fall_of = lost35 + total49
                    nyquist_of = lost37 + lost482 + lost273 + total273
                    rise_of = lost512 + total41
                    together_of = lost372 + total40
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(count, envelope, half, lost2, lost26, low2, root, size, stiff, total26,
                    total34, total35, total36, total37, total38, whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    back22 = total35 - total34
                    rest10 = total35 - back22
                    one9 = total34 - rest10
                    two9 = low2 - back22
                    lost35 = one9 + two9
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                    lost36 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                    back22 = total37 - root
                    rest10 = total37 - back22
                    one9 = root - rest10
                    two9 = total36 - back22
                    lost37 = one9 + two9
                    both_low = lost36 - 1.7484555314695172e-07*count + lost37 + root_low
                    left = total35 - total38*whole32
                    total38_halves = halves(xp, total38)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                    left = left - both_low*total38 + lost35
                    lost35 = left/whole32
                    eta = total38
                    eta_low = lost35
                    total39 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total39)
                    bent2 = cos_series_of2*(total39*total39)
                    total40 = 0.5*total39 - bent2
                    back22 = total40 - 0.5*total39
                    lost37 = -back22 - bent2
                    sin_series_of2 = sin_series(xp, -total39)
                    total41 = 1.0 - sin_series_of2*total39
                    back22 = total41 - 1.0
                    lost36 = -back22 - sin_series_of2*total39
                    lift_low = 0.5*lost35*total41 + lost37
                    total39 = eta*total41
                    total41_halves = halves(xp, total41)
                    lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                    some2 = root
                    total41 = total39/some2
                    left = total39 - some2*total41
                    total41_halves = halves(xp, total41)
                    some2_halves = halves(xp, some2)
                    left = left - product_error(total41*some2, total41_halves, some2_halves)
                    left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                    lost36 = left/some2
                    given4 = half
                    total39 = 1.0 - 0.5*given4
                    back22 = total39 - 1.0
                    lost37 = -back22 - 0.5*given4
                    decay_series_of3 = decay_series(xp, given4)
                    curved4 = decay_series_of3*(given4*given4)
                    total45 = curved4 + total39
                    back22 = total45 - total39
                    lost35 = curved4 - back22
                    mean_low5 = lost37 + lost35
                    total39 = given4*total45
                    given4_halves = halves(xp, given4)
                    total45_halves = halves(xp, total45)
                    lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                        total45_halves)
                    total47 = 1.0 - total39
                    back22 = total47 - 1.0
                    lost37 = -back22 - total39
                    fall_low5 = lost37 - lost35
                    total39 = total45 - total41
                    back22 = total39 - total45
                    rest10 = total39 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total41
                    lost37 = one9 + two9
                    total49 = given4*total39
                    total39_halves = halves(xp, total39)
                    lost37 = (
                        given4*(lost37 - lost36 + mean_low5) +
                        product_error(total49, given4_halves, total39_halves)
                    )
                    total39 = total40 - total49
                    back22 = total39 - total40
                    rest10 = total39 - back22
                    one9 = total40 - rest10
                    two9 = -back22 - total49
                    lost35 = one9 + two9
                    low22 = lift_low - lost37 + lost35
                    total49 = low22 + total39
                    back22 = total49 - total39
                    rest10 = total49 - back22
                    one9 = total39 - rest10
                    two9 = low22 - back22
                    lost35 = one9 + two9
                    total39 = total47*total49
                    total47_halves = halves(xp, total47)
                    total49_halves = halves(xp, total49)
                    lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                    low22 = fall_low5*total49 + lost35
                    total49 = total39/stiff
                    left = total39 - stiff*total49
                    total49_halves = halves(xp, total49)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                    left = left + low22
                    lost35 = left/stiff
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back22 = 0.5*root_low*sin_of
                    total39 = wave - back22
                    back82 = total39 - wave
                    rest10 = total39 - back82
                    one9 = wave - rest10
                    two9 = -back22 - back82
                    lost37 = one9 + two9
                    total102 = (total39*total39)
                    total39_halves = halves(xp, total39)
                    lost102 = product_error(total102, total39_halves, total39_halves)
                    low22 = lost102 + 2.0*lost37*total39
                    total39 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost37 = envelope*low22 + product_error(total39, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total39
                    back82 = total102 - total39
                    rest10 = total102 - back82
                    one9 = total39 - rest10
                    two9 = (grown*grown) - back82
                    lost102 = one9 + two9
                    low22 = lost37 + lost102
                    total39 = total41*total47
                    lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                    total482 = total45 - total39
                    back82 = total482 - total45
                    rest10 = total482 - back82
                    one9 = total45 - rest10
                    two9 = -back82 - total39
                    lost102 = one9 + two9
                    low24 = lost102 - fall_low5*total41 - lost36 + mean_low5
                    total41 = given4*total482
                    total482_halves = halves(xp, total482)
                    lost102 = given4*low24 + product_error(total41, given4_halves, total482_halves)
                    total482 = total40*total47
                    total40_halves = halves(xp, total40)
                    lost36 = lift_low*total47 + product_error(total482, total47_halves,
                        total40_halves)
                    total39 = total41 + total482
                    back82 = total39 - total41
                    rest10 = total39 - back82
                    one9 = total41 - rest10
                    two9 = total482 - back82
                    lost37 = one9 + two9
                    low24 = fall_low5*total40 + lost102 + lost36 + lost37
                    total41 = total39/stiff
                    left = total39 - stiff*total41
                    total41_halves = halves(xp, total41)
                    left = left - product_error(total41*stiff, total41_halves, stiff_halves)
                    left = left + low24
                    lost37 = left/stiff
                    total39 = 1.0 - total47
                    back82 = total39 - 1.0
                    lost102 = -back82 - total47
                    low24 = lost102 - fall_low5
                    total47 = low24 + total39
                    back82 = total47 - total39
                    lost102 = low24 - back82
                    total39 = (total47*total47)
                    total47_halves = halves(xp, total47)
                    lost102 = 2.0*lost102*total47 + product_error(total39, total47_halves,
                        total47_halves)
                    total47 = total39 + 2.0*total482
                    back82 = total47 - total39
                    rest10 = total47 - back82
                    one9 = total39 - rest10
                    two9 = 2.0*total482 - back82
                    lost372 = one9 + two9
                    low24 = 2.0*fall_low5*total40 + lost102 + lost372 + 2.0*lost36
                    total40 = total47/stiff
                    left = total47 - stiff*total40
                    total40_halves = halves(xp, total40)
                    left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                    left = left + low24
                    lost372 = left/stiff
                    apart_of = lost26 + total26
                    fall_of = lost35 + total49
                    nyquist_of = 4.0*low22 + 4.0*total102
                    rise_of = lost37 + total41
                    together_of = lost372 + total40
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, total263 > 0.0, yes, (count, delta, even, half, lost2, lost26, low2,
                    root, size, square2, stiff, total26, total263, total34, total35, total36,
                    total37, total38, twice2, whole32), no,
                    (count, envelope, half, lost2, lost26, low2, root, size, stiff, total26,
                    total34, total35, total36, total37, total38, whole32))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            def no(delta, envelope, even, half, lost2, lost26, odd, odd_low2, root, size, square2,
                stiff, total26, total263, twice2):

                def yes(delta, envelope, even, half, lost2, lost26, odd, odd_low2, root, size,
                    square2, stiff, total26, total263, twice2):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    total23 = half*odd
                    half_halves = halves(xp, half)
                    odd_halves = halves(xp, odd)
                    lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)
                    total252 = total23 - even
                    back162 = total252 - total23
                    rest42 = total252 - back162
                    one32 = total23 - rest42
                    two32 = -back162 - even
                    lost252 = one32 + two32
                    total262 = envelope + total252
                    back162 = total262 - total252
                    rest42 = total262 - back162
                    one32 = total252 - rest42
                    two32 = envelope - back162
                    lost262 = one32 + two32
                    total252 = envelope*total262
                    total282 = total252/stiff
                    left = total252 - stiff*total282
                    total282_halves = halves(xp, total282)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total282*stiff, total282_halves, stiff_halves)
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    e = xp.exp(-delta)
                    total253 = e + 1.0
                    back162 = total253 - 1.0
                    lost253 = e - back162
                    total273 = total253 + total263
                    back162 = total273 - total253
                    lost273 = total263 - back162
                    total253 = even + total23
                    back162 = total253 - even
                    rest42 = total253 - back162
                    one32 = even - rest42
                    two32 = total23 - back162
                    lost242 = one32 + two32
                    total23 = envelope*total253
                    total264 = 1.0 - total23
                    back162 = total264 - 1.0
                    lost264 = -back162 - total23
                    total274 = total264/stiff
                    left162 = total264 - stiff*total274
                    total274_halves = halves(xp, total274)
                    left162 = left162 - product_error(total274*stiff, total274_halves, stiff_halves)
                    back162 = -0.5*root_low*wave
                    total264 = sin_of - back162
                    back83 = total264 - sin_of
                    rest42 = total264 - back83
                    one32 = sin_of - rest42
                    two32 = -back162 - back83
                    lost93 = one32 + two32
                    total103 = (total264*total264)
                    total264_halves = halves(xp, total264)
                    lost103 = product_error(total103, total264_halves, total264_halves)
                    low5 = lost103 + 2.0*lost93*total264
                    total264 = envelope*total103
                    envelope_halves = halves(xp, envelope)
                    total103_halves = halves(xp, total103)
                    lost93 = envelope*low5 + product_error(total264, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total264
                    back83 = total103 - total264
                    rest42 = total103 - back83
                    one32 = total264 - rest42
                    two32 = (grown*grown) - back83
                    lost103 = one32 + two32
                    low5 = lost93 + lost103
                    total264 = total103/stiff
                    left72 = total103 - stiff*total264
                    total264_halves = halves(xp, total264)
                    left72 = left72 - product_error(total264*stiff, total264_halves, stiff_halves)
                    left72 = left72 + low5
                    lost103 = left72/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    total262_halves = halves(xp, total262)
                    lost262 = (
                        envelope*(lost23 - even_low2 + lost252 + lost262) +
                        product_error(total252, envelope_halves, total262_halves)
                    )
                    left = left + lost262
                    lost262 = left/stiff
                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost252 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    total253_halves = halves(xp, total253)
                    lost242 = (
                        envelope*(even_low2 + lost23 + lost242) +
                        product_error(total23, envelope_halves, total253_halves)
                    )
                    left162 = left162 - lost242 + lost264
                    lost264 = left162/stiff
                    apart_of = lost26 + total26
                    fall_of = lost262 + total282
                    nyquist_of = lost253 + lost252 + lost273 + total273
                    rise_of = lost264 + total274
                    together_of = 4.0*lost103 + 4.0*total264
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(envelope, even, half, lost2, lost26, odd, odd_low2, root, size, square2,
                    stiff, total26):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    total23 = half*odd
                    half_halves = halves(xp, half)
                    odd_halves = halves(xp, odd)
                    lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)
                    total252 = total23 - even
                    back162 = total252 - total23
                    rest42 = total252 - back162
                    one32 = total23 - rest42
                    two32 = -back162 - even
                    lost252 = one32 + two32
                    total262 = envelope + total252
                    back162 = total262 - total252
                    rest42 = total262 - back162
                    one32 = total252 - rest42
                    two32 = envelope - back162
                    lost262 = one32 + two32
                    total252 = envelope*total262
                    total282 = total252/stiff
                    left = total252 - stiff*total282
                    total282_halves = halves(xp, total282)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total282*stiff, total282_halves, stiff_halves)
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back162 = 0.5*root_low*sin_of
                    total92 = wave - back162
                    back82 = total92 - wave
                    rest42 = total92 - back82
                    one32 = wave - rest42
                    two32 = -back162 - back82
                    lost92 = one32 + two32
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low4 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low4 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest42 = total102 - back82
                    one32 = total92 - rest42
                    two32 = (grown*grown) - back82
                    lost102 = one32 + two32
                    low4 = lost92 + lost102
                    total92 = even + total23
                    back82 = total92 - even
                    rest42 = total92 - back82
                    one32 = even - rest42
                    two32 = total23 - back82
                    lost102 = one32 + two32
                    total23 = envelope*total92
                    total264 = 1.0 - total23
                    back82 = total264 - 1.0
                    lost92 = -back82 - total23
                    total274 = total264/stiff
                    left162 = total264 - stiff*total274
                    total274_halves = halves(xp, total274)
                    left162 = left162 - product_error(total274*stiff, total274_halves, stiff_halves)
                    back82 = -0.5*root_low*wave
                    total264 = sin_of - back82
                    back162 = total264 - sin_of
                    rest42 = total264 - back162
                    one32 = sin_of - rest42
                    two32 = -back82 - back162
                    lost93 = one32 + two32
                    total103 = (total264*total264)
                    total264_halves = halves(xp, total264)
                    lost103 = product_error(total103, total264_halves, total264_halves)
                    low5 = lost103 + 2.0*lost93*total264
                    total264 = envelope*total103
                    total103_halves = halves(xp, total103)
                    lost93 = envelope*low5 + product_error(total264, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total264
                    back162 = total103 - total264
                    rest42 = total103 - back162
                    one32 = total264 - rest42
                    two32 = (grown*grown) - back162
                    lost103 = one32 + two32
                    low5 = lost93 + lost103
                    total264 = total103/stiff
                    left72 = total103 - stiff*total264
                    total264_halves = halves(xp, total264)
                    left72 = left72 - product_error(total264*stiff, total264_halves, stiff_halves)
                    left72 = left72 + low5
                    lost103 = left72/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    total262_halves = halves(xp, total262)
                    lost262 = (
                        envelope*(lost23 - even_low2 + lost252 + lost262) +
                        product_error(total252, envelope_halves, total262_halves)
                    )
                    left = left + lost262
                    lost262 = left/stiff
                    total92_halves = halves(xp, total92)
                    lost102 = (
                        envelope*(even_low2 + lost23 + lost102) +
                        product_error(total23, envelope_halves, total92_halves)
                    )
                    left162 = left162 - lost102 + lost92
                    lost92 = left162/stiff
                    apart_of = lost26 + total26
                    fall_of = lost262 + total282
                    nyquist_of = 4.0*low4 + 4.0*total102
                    rise_of = lost92 + total274
                    together_of = 4.0*lost103 + 4.0*total264
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, total263 > 0.0, yes, (delta, envelope, even, half, lost2, lost26,
                    odd, odd_low2, root, size, square2, stiff, total26, total263, twice2), no,
                    (envelope, even, half, lost2, lost26, odd, odd_low2, root, size, square2,
                    stiff, total26))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            apart_of, fall_of, nyquist_of, rise_of, together_of = (
                select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, delta, envelope, even, half, lost2, lost25, low2, root, size, square2,
                stiff, total24, total25, total30, total31, total29, total37, total38, twice2,
                whole32), no, (delta, envelope, even, half, lost2, lost25, odd, odd_low2, root,
                size, square2, stiff, total24, total25, twice2))
            )

            return apart_of, fall_of, nyquist_of, rise_of, together_of

        apart_of, fall_of, nyquist_of, rise_of, together_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, total2), no,
            (delta, gamma, half, lost2, total2))
        )

        return apart_of, fall_of, nyquist_of, rise_of, together_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half, lost2, reach, root, size, total2, total3):

            def yes(delta, gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back3 = total27 - 1.0
                lost54 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back3 = total55 - total27
                lost55 = curved5 - back3
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back3 = total55 - 1.0
                lost54 = -back3 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back3 = total27 - rest6
                rest5 = total27 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back3 = total55 - 1.0
                lost532 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back3 = total542 - total55
                lost542 = curved5 - back3
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back3 = total542 - 1.0
                lost532 = -back3 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back3 = total542 - rest5
                rest6 = total542 - back3
                one4 = rest5 - rest6
                two4 = 0.5 - back3
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)
                rest6 = together_series(xp, half, total2)
                total55 = rest6 + 0.5
                back3 = total55 - rest6
                rest5 = total55 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost553 = one4 + two4
                total563 = envelope*total55
                total55_halves = halves(xp, total55)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total55_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    return fall_, fall_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    fall_ = sunk
                    fall_low2 = sunk_low
                    return fall_, fall_low2

                fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))

                total55 = fall_ + 1.0
                back3 = total55 - 1.0
                lost283 = fall_ - back3

                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    total10 = given2*total11
                    given2_halves = halves(xp, given2)
                    total11_halves = halves(xp, total11)
                    lost11 = given2*mean_low3 + product_error(total10, given2_halves,
                        total11_halves)
                    total13 = 1.0 - total10
                    back8 = total13 - 1.0
                    lost10 = -back8 - total10
                    fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                    fall2 = total13
                    return fall2, fall_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    fall2 = sunk2
                    fall_low4 = sunk_low2
                    return fall2, fall_low4

                fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no,
                    (root, root_low))

                fast = fall_*fall2
                fall__halves = halves(xp, fall_)
                fall2_halves = halves(xp, fall2)
                lost292 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
                low32 = fall2*fall_low2 + lost292
                total302 = fast + 1.0
                back3 = total302 - 1.0
                lost292 = fast - back3
                total312 = total55*total302
                total55_halves = halves(xp, total55)
                total302_halves = halves(xp, total302)
                lost292 = (
                    total55*(lost292 + low32) + product_error(total312, total55_halves,
                    total302_halves)
                )
                apart_of = lost3 + total28
                fall_of = lost54*total27 + lost55 + total61
                nyquist_of = lost292 + total302*(fall_low2 + lost283) + total312
                rise_of = lost532*total542 + lost542 + total592
                together_of = 2.0*lost553 + 2.0*total563
                return apart_of, fall_of, nyquist_of, rise_of, together_of

            def no(gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
                rest6 = together_series(xp, half, total2)
                total27 = rest6 + 0.5
                back3 = total27 - rest6
                rest5 = total27 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost553 = one4 + two4
                total563 = envelope*total27
                total27_halves = halves(xp, total27)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total27_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    mean = total5
                    return fall_, fall_low, mean, mean_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    total8 = 1.0 - sunk
                    back7 = total8 - 1.0
                    lost8 = -back7 - sunk
                    bottom = q
                    total9 = total8/bottom
                    left4 = total8 - bottom*total9
                    total9_halves = halves(xp, total9)
                    bottom_halves = halves(xp, bottom)
                    left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                    left4 = left4 + lost8 - q_low*total9 - sunk_low
                    lost8 = left4/bottom
                    fall_ = sunk
                    fall_low2 = sunk_low
                    mean = total9
                    mean_low2 = lost8
                    return fall_, fall_low2, mean, mean_low2

                fall_, fall_low2, mean, mean_low2 = (
                    select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
                )

                total27 = fall_ + 1.0
                back3 = total27 - 1.0
                lost283 = fall_ - back3

                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    total10 = given2*total11
                    given2_halves = halves(xp, given2)
                    total11_halves = halves(xp, total11)
                    lost11 = given2*mean_low3 + product_error(total10, given2_halves,
                        total11_halves)
                    total13 = 1.0 - total10
                    back8 = total13 - 1.0
                    lost10 = -back8 - total10
                    fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                    fall2 = total13
                    mean2 = total11
                    return fall2, fall_low3, mean2, mean_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    total14 = 1.0 - sunk2
                    back11 = total14 - 1.0
                    lost14 = -back11 - sunk2
                    bottom2 = 2.0*root
                    total15 = total14/bottom2
                    left7 = total14 - bottom2*total15
                    total15_halves = halves(xp, total15)
                    bottom2_halves = halves(xp, bottom2)
                    left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                    left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                    lost14 = left7/bottom2
                    fall2 = sunk2
                    fall_low4 = sunk_low2
                    mean2 = total15
                    mean_low4 = lost14
                    return fall2, fall_low4, mean2, mean_low4

                fall2, fall_low4, mean2, mean_low4 = (
                    select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
                )

                fast = fall_*fall2
                total162 = fall2*mean
                fall2_halves = halves(xp, fall2)
                mean_halves = halves(xp, mean)
                lost162 = fall2*mean_low2 + product_error(total162, fall2_halves, mean_halves)
                pulled_low = fall_low4*mean + lost162
                total172 = mean2 - total162
                back3 = total172 - mean2
                rest5 = total172 - back3
                one4 = mean2 - rest5
                two4 = -back3 - total162
                lost162 = one4 + two4
                total162 = total172/whole
                left = total172 - total162*whole
                total162_halves = halves(xp, total162)
                left = left - product_error(total162*whole, total162_halves, whole_halves)
                left = left + lost162 + mean_low4 - p_low*total162 - pulled_low
                lost162 = left/whole
                total172 = fall_*total162
                fall__halves = halves(xp, fall_)
                lost162 = fall_*lost162 + product_error(total172, fall__halves, total162_halves)
                creep_ = fall_low2*total162 + lost162 + total172
                lost162 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
                low32 = fall2*fall_low2 + lost162
                total172 = fast + 1.0
                back3 = total172 - 1.0
                lost162 = fast - back3
                total162 = total27*total172
                total27_halves = halves(xp, total27)
                total172_halves = halves(xp, total172)
                lost162 = (
                    total27*(lost162 + low32) + product_error(total162, total27_halves,
                    total172_halves)
                )
                total27 = fall_*mean2
                mean2_halves = halves(xp, mean2)
                lost163 = fall_*mean_low4 + product_error(total27, fall__halves, mean2_halves)
                pulled_low = fall_low2*mean2 + lost163
                total173 = mean - total27
                back3 = total173 - mean
                rest5 = total173 - back3
                one4 = mean - rest5
                two4 = -back3 - total27
                lost163 = one4 + two4
                total27 = total173/whole
                left = total173 - total27*whole
                total27_halves = halves(xp, total27)
                left = left - product_error(total27*whole, total27_halves, whole_halves)
                left = left + lost163 + mean_low2 - p_low*total27 - pulled_low
                lost163 = left/whole
                apart_of = lost3 + total28
                fall_of = creep_
                nyquist_of = lost162 + total172*(fall_low2 + lost283) + total162
                rise_of = lost163 + total27
                together_of = 2.0*lost553 + 2.0*total563
                return apart_of, fall_of, nyquist_of, rise_of, together_of

            apart_of, fall_of, nyquist_of, rise_of, together_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, root, size, total2,
                total3), no, (gamma, half, lost2, root, size, total2, total3))
            )

            return apart_of, fall_of, nyquist_of, rise_of, together_of

        def no(delta, gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )

            twice = 2.0*fall_
            total283 = fall_ + 1.0
            back3 = total283 - 1.0
            lost3 = fall_ - back3

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            fast = fall_*fall2
            total16 = mean2*twice
            twice_halves = halves(xp, twice)
            mean2_halves = halves(xp, mean2)
            lost16 = mean_low4*twice + product_error(total16, twice_halves, mean2_halves)
            total17 = mean - total16
            back3 = total17 - mean
            rest3 = total17 - back3
            one2 = mean - rest3
            two2 = -back3 - total16
            lost17 = one2 + two2
            total16 = fast*mean
            fast_halves = halves(xp, fast)
            mean_halves = halves(xp, mean)
            lost18 = fast*mean_low2 + product_error(total16, fast_halves, mean_halves)
            top = total17 + total16
            low = lost17 - lost16 + lost18 + mean_low2
            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            lost18 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost18
            total17 = mean2 - total16
            back3 = total17 - mean2
            rest3 = total17 - back3
            one2 = mean2 - rest3
            two2 = -back3 - total16
            lost18 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost18 + mean_low4 - p_low*total16 - pulled_low
            lost18 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost18 = fall_*lost18 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost18 + total17
            lost18 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
            low32 = fall2*fall_low2 + lost18
            total17 = fast + 1.0
            back3 = total17 - 1.0
            lost18 = fast - back3
            total16 = total283*total17
            total283_halves = halves(xp, total283)
            total17_halves = halves(xp, total17)
            lost18 = (
                total283*(lost18 + low32) + product_error(total16, total283_halves, total17_halves)
            )
            total283 = fall_*mean2
            lost17 = fall_*mean_low4 + product_error(total283, fall__halves, mean2_halves)
            pulled_low = fall_low2*mean2 + lost17
            total173 = mean - total283
            back3 = total173 - mean
            rest3 = total173 - back3
            one2 = mean - rest3
            two2 = -back3 - total283
            lost17 = one2 + two2
            total283 = total173/whole
            left = total173 - total283*whole
            total283_halves = halves(xp, total283)
            left = left - product_error(total283*whole, total283_halves, whole_halves)
            left = left + lost17 + mean_low2 - p_low*total283 - pulled_low
            lost17 = left/whole
            total173 = 1.0 - fast
            back3 = total173 - 1.0
            lost16 = -back3 - fast
            total533 = mean*total173
            total173_halves = halves(xp, total173)
            lost16 = mean*(lost16 - low32) + product_error(total533, mean_halves, total173_halves)
            moved_low = lost16 + mean_low2*total173
            total173 = total533/whole
            left = total533 - total173*whole
            total173_halves = halves(xp, total173)
            left = left - product_error(total173*whole, total173_halves, whole_halves)
            left = left + moved_low - p_low*total173
            lost16 = left/whole
            apart_of = (low + top)/whole3
            fall_of = creep_
            nyquist_of = lost18 + total17*(fall_low2 + lost3) + total16
            rise_of = lost17 + total283
            together_of = lost16 + total173
            return apart_of, fall_of, nyquist_of, rise_of, together_of

        apart_of, fall_of, nyquist_of, rise_of, together_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, root, size, total2,
            total3), no, (delta, gamma, half, lost2, root, size, total3))
        )

        return apart_of, fall_of, nyquist_of, rise_of, together_of

    apart_of, fall_of, nyquist_of, rise_of, together_of = (
        select(xp, total2 < 0.0, yes, (delta, gamma, half, lost, total2), no,
        (delta, gamma, half, lost, total2))
    )

    return apart_of, fall_of, nyquist_of, rise_of, together_of


def apart_fall_nyquist_rise_together(xp, gamma, delta):
    """(n1 - n0)/delta; n0, the same device with its time reversed, times exp(-delta); 1 + a +
    e; n1, how far a unit force moves the device in a period; n1 + n0
    """
    if gamma.dtype == xp.float32:
        return apart_fall_nyquist_rise_together_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, gamma, half, lost2, reach, total2):

            def yes(delta, gamma, half, lost2, total2):
                square2 = total2
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back17 = total27 - 1.0
                lost54 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back17 = total55 - total27
                lost55 = curved5 - back17
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back17 = total55 - 1.0
                lost54 = -back17 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back17 = total27 - rest6
                rest5 = total27 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                twice2 = 2.0*envelope
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back17 = total55 - 1.0
                lost532 = -back17 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back17 = total542 - total55
                lost542 = curved5 - back17
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back17 = total542 - 1.0
                lost532 = -back17 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back17 = total542 - rest5
                rest6 = total542 - back17
                one4 = rest5 - rest6
                two4 = 0.5 - back17
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)
                rest6 = together_series(xp, half, total2)
                total55 = rest6 + 0.5
                back17 = total55 - rest6
                rest5 = total55 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost553 = one4 + two4
                total563 = envelope*total55
                total55_halves = halves(xp, total55)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total55_halves)

                def yes(square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total19 = curved3 + total19
                    even = total19
                    return even

                def no(total2):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    cosine = xp.cos(root)
                    even = cosine
                    return even

                even = select(xp, square2 > -1.5, yes, (square2,), no, (total2,))

                total55 = even*twice2

                def yes(delta, even, lost2, lost28, lost563, lost572, lost59, lost592, lost61,
                    square2, total2, total263, total28, total563, total582, total592, total60,
                    total61, twice2):
                    e = xp.exp(-delta)
                    total253 = e + 1.0
                    back182 = total253 - 1.0
                    lost253 = e - back182
                    total273 = total253 + total263
                    back182 = total273 - total253
                    lost273 = total263 - back182

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(lost2, total2):
                        size = xp.abs(total2)
                        root = square_root(xp, size)
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (lost2, total2))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost263 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost28 + total28
                    fall_of = lost59*total60 + lost61 + total61
                    nyquist_of = lost253 + lost263 + lost273 + total273
                    rise_of = lost572*total582 + lost592 + total592
                    together_of = 2.0*lost563 + 2.0*total563
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(envelope, half, lost2, lost28, lost563, lost572, lost59, lost592, lost61,
                    total2, total28, total563, total582, total592, total60, total61):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back72 = 0.5*root_low*sin_of
                    total92 = wave - back72
                    back82 = total92 - wave
                    rest33 = total92 - back82
                    one23 = wave - rest33
                    two23 = -back72 - back82
                    lost92 = one23 + two23
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low4 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low4 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest33 = total102 - back82
                    one23 = total92 - rest33
                    two23 = (grown*grown) - back82
                    lost102 = one23 + two23
                    low4 = lost92 + lost102
                    apart_of = lost28 + total28
                    fall_of = lost59*total60 + lost61 + total61
                    nyquist_of = 4.0*low4 + 4.0*total102
                    rise_of = lost572*total582 + lost592 + total592
                    together_of = 2.0*lost563 + 2.0*total563
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, total55 > 0.0, yes, (delta, even, lost2, lost27, lost553, lost532,
                    lost54, lost542, lost55, square2, total2, total55, total28, total563,
                    total542, total592, total27, total61, twice2), no,
                    (envelope, half, lost2, lost27, lost553, lost532, lost54, lost542, lost55,
                    total2, total28, total563, total542, total592, total27, total61))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            def no(delta, gamma, half, lost2, total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                square2 = total2
                envelope = xp.exp(-half)
                stiff = gamma
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back17 = total27 - rest5
                rest6 = total27 - back17
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back17
                lost27 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
                twice2 = 2.0*envelope
                rest6 = together_series(xp, half, total2)
                total27 = rest6 + 0.5
                back17 = total27 - rest6
                rest5 = total27 - back17
                one4 = rest6 - rest5
                two4 = 0.5 - back17
                lost553 = one4 + two4
                total563 = envelope*total27
                total27_halves = halves(xp, total27)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total27_halves)

                def yes(square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total19 = curved3 + total19
                    even = total19
                    return even

                def no(root):
                    cosine = xp.cos(root)
                    even = cosine
                    return even

                even = select(xp, square2 > -1.5, yes, (square2,), no, (root,))

                total27 = even*twice2

                def yes(root):
                    count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                    return count

                def no(root):
                    return 0.0

                count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

                turns = (count*count)
                total29 = 39.47841760435743*turns
                turns_halves = halves(xp, turns)
                number4_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
                lost29 = product_error(total29, turns_halves, number4_halves)
                total30 = 2.5061182034958845e-15*turns
                number5_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
                lost30 = product_error(total30, turns_halves, number5_halves)
                total31 = -total2 - total29
                back17 = total2 + total31
                rest5 = total31 - back17
                one4 = -rest5 - total2
                two4 = -back17 - total29
                lost31 = one4 + two4
                total29 = total31 - lost29
                back17 = total29 - total31
                rest5 = total29 - back17
                one4 = total31 - rest5
                two4 = -back17 - lost29
                lost29 = one4 + two4
                total31 = total29 - total30
                back17 = total31 - total29
                rest5 = total31 - back17
                one4 = total29 - rest5
                two4 = -back17 - total30
                lost33 = one4 + two4
                total30 = total31 - lost2
                back17 = total30 - total31
                rest5 = total30 - back17
                one4 = total31 - rest5
                two4 = -back17 - lost2
                lost34 = one4 + two4
                low2 = lost31 - lost30 + lost29 + lost33 + lost34 - 1.4920070805839235e-31*turns
                total31 = low2 + total30
                total29 = 6.283185307179586*count
                total37 = root + total29
                whole32 = xp.where(total37 == 0.0, 1.0, total37)
                total38 = total31/whole32
                far = (total38*total38)

                def yes(count, delta, envelope, even, half, lost2, lost28, lost563, low2, root,
                    size, square2, stiff, total263, total28, total34, total35, total36, total37,
                    total38, total563, twice2, whole32):

                    def yes(count, delta, even, half, lost2, lost28, lost563, low2, root, size,
                        square2, stiff, total263, total28, total34, total35, total36, total37,
                        total38, total563, twice2, whole32):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        back22 = total35 - total34
                        rest10 = total35 - back22
                        one9 = total34 - rest10
                        two9 = low2 - back22
                        lost35 = one9 + two9
                        count_halves = halves(xp, count)
                        number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                        lost36 = product_error(count*6.283185307179586, count_halves,
                            number2_halves)
                        back22 = total37 - root
                        rest10 = total37 - back22
                        one9 = root - rest10
                        two9 = total36 - back22
                        lost37 = one9 + two9
                        both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                        left = total35 - total38*whole32
                        total38_halves = halves(xp, total38)
                        whole32_halves = halves(xp, whole32)
                        left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                        left = left - both_low*total38 + lost35
                        lost35 = left/whole32
                        eta = total38
                        eta_low = lost35
                        total39 = (eta*eta)
                        eta_halves = halves(xp, eta)
                        lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                        cos_series_of2 = cos_series(xp, -total39)
                        bent2 = cos_series_of2*(total39*total39)
                        total40 = 0.5*total39 - bent2
                        back22 = total40 - 0.5*total39
                        lost37 = -back22 - bent2
                        sin_series_of2 = sin_series(xp, -total39)
                        total41 = 1.0 - sin_series_of2*total39
                        back22 = total41 - 1.0
                        lost36 = -back22 - sin_series_of2*total39
                        lift_low = 0.5*lost35*total41 + lost37
                        total39 = eta*total41
                        total41_halves = halves(xp, total41)
                        lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                        some2 = root
                        total41 = total39/some2
                        left = total39 - some2*total41
                        total41_halves = halves(xp, total41)
                        some2_halves = halves(xp, some2)
                        left = left - product_error(total41*some2, total41_halves, some2_halves)
                        left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                        lost36 = left/some2
                        given4 = half
                        total39 = 1.0 - 0.5*given4
                        back22 = total39 - 1.0
                        lost37 = -back22 - 0.5*given4
                        decay_series_of3 = decay_series(xp, given4)
                        curved4 = decay_series_of3*(given4*given4)
                        total45 = curved4 + total39
                        back22 = total45 - total39
                        lost35 = curved4 - back22
                        mean_low5 = lost37 + lost35
                        total39 = given4*total45
                        given4_halves = halves(xp, given4)
                        total45_halves = halves(xp, total45)
                        lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                            total45_halves)
                        total47 = 1.0 - total39
                        back22 = total47 - 1.0
                        lost37 = -back22 - total39
                        fall_low5 = lost37 - lost35
                        total39 = total45 - total41
                        back22 = total39 - total45
                        rest10 = total39 - back22
                        one9 = total45 - rest10
                        two9 = -back22 - total41
                        lost37 = one9 + two9
                        total49 = given4*total39
                        total39_halves = halves(xp, total39)
                        lost37 = (
                            given4*(lost37 - lost36 + mean_low5) +
                            product_error(total49, given4_halves, total39_halves)
                        )
                        total39 = total40 - total49
                        back22 = total39 - total40
                        rest10 = total39 - back22
                        one9 = total40 - rest10
                        two9 = -back22 - total49
                        lost35 = one9 + two9
                        low22 = lift_low - lost37 + lost35
                        total49 = low22 + total39
                        back22 = total49 - total39
                        rest10 = total49 - back22
                        one9 = total39 - rest10
                        two9 = low22 - back22
                        lost35 = one9 + two9
                        total39 = total47*total49
                        total47_halves = halves(xp, total47)
                        total49_halves = halves(xp, total49)
                        lost35 = lost35*total47 + product_error(total39, total47_halves,
                            total49_halves)
                        low22 = fall_low5*total49 + lost35
                        total49 = total39/stiff
                        left = total39 - stiff*total49
                        total49_halves = halves(xp, total49)
                        stiff_halves = halves(xp, stiff)
                        left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                        left = left + low22
                        lost35 = left/stiff
                        e = xp.exp(-delta)
                        total39 = e + 1.0
                        back22 = total39 - 1.0
                        lost37 = e - back22
                        total273 = total39 + total263
                        back22 = total273 - total39
                        lost273 = total263 - back22
                        total39 = total41*total47
                        lost36 = lost36*total47 + product_error(total39, total47_halves,
                            total41_halves)
                        total482 = total45 - total39
                        back22 = total482 - total45
                        rest10 = total482 - back22
                        one9 = total45 - rest10
                        two9 = -back22 - total39
                        lost482 = one9 + two9
                        low22 = lost482 - fall_low5*total41 - lost36 + mean_low5
                        total41 = given4*total482
                        total482_halves = halves(xp, total482)
                        lost482 = given4*low22 + product_error(total41, given4_halves,
                            total482_halves)
                        total482 = total40*total47
                        total40_halves = halves(xp, total40)
                        lost36 = lift_low*total47 + product_error(total482, total47_halves,
                            total40_halves)
                        total47 = total41 + total482
                        back22 = total47 - total41
                        rest10 = total47 - back22
                        one9 = total41 - rest10
                        two9 = total482 - back22
                        lost512 = one9 + two9
                        low22 = fall_low5*total40 + lost482 + lost36 + lost512
                        total40 = total47/stiff
                        left = total47 - stiff*total40
                        total40_halves = halves(xp, total40)
                        left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                        left = left + low22
                        lost512 = left/stiff

                        def yes(lost2, square2):
                            given3 = square2
                            total19 = 0.5*given3 + 1.0
                            back13 = total19 - 1.0
                            lost19 = 0.5*given3 - back13
                            cos_series_of = cos_series(xp, given3)
                            curved3 = cos_series_of*(given3*given3)
                            total20 = curved3 + total19
                            back13 = total20 - total19
                            lost20 = curved3 - back13
                            even_low = lost19 + 0.5*lost2 + lost20
                            return even_low

                        def no(root, root_low):
                            sine = xp.sin(root)
                            even_low2 = -root_low*sine
                            return even_low2

                        even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                            (root, root_low))

                        twice2_halves = halves(xp, twice2)
                        even_halves = halves(xp, even)
                        lost36 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                            even_halves)
                        apart_of = lost28 + total28
                        fall_of = lost35 + total49
                        nyquist_of = lost37 + lost36 + lost273 + total273
                        rise_of = lost512 + total40
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    def no(count, envelope, half, lost2, lost28, lost563, low2, root, size, stiff,
                        total28, total34, total35, total36, total37, total38, total563, whole32):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        back22 = total35 - total34
                        rest10 = total35 - back22
                        one9 = total34 - rest10
                        two9 = low2 - back22
                        lost35 = one9 + two9
                        count_halves = halves(xp, count)
                        number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                        lost36 = product_error(count*6.283185307179586, count_halves,
                            number2_halves)
                        back22 = total37 - root
                        rest10 = total37 - back22
                        one9 = root - rest10
                        two9 = total36 - back22
                        lost37 = one9 + two9
                        both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                        left = total35 - total38*whole32
                        total38_halves = halves(xp, total38)
                        whole32_halves = halves(xp, whole32)
                        left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                        left = left - both_low*total38 + lost35
                        lost35 = left/whole32
                        eta = total38
                        eta_low = lost35
                        total39 = (eta*eta)
                        eta_halves = halves(xp, eta)
                        lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                        cos_series_of2 = cos_series(xp, -total39)
                        bent2 = cos_series_of2*(total39*total39)
                        total40 = 0.5*total39 - bent2
                        back22 = total40 - 0.5*total39
                        lost37 = -back22 - bent2
                        sin_series_of2 = sin_series(xp, -total39)
                        total41 = 1.0 - sin_series_of2*total39
                        back22 = total41 - 1.0
                        lost36 = -back22 - sin_series_of2*total39
                        lift_low = 0.5*lost35*total41 + lost37
                        total39 = eta*total41
                        total41_halves = halves(xp, total41)
                        lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                        some2 = root
                        total41 = total39/some2
                        left = total39 - some2*total41
                        total41_halves = halves(xp, total41)
                        some2_halves = halves(xp, some2)
                        left = left - product_error(total41*some2, total41_halves, some2_halves)
                        left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                        lost36 = left/some2
                        given4 = half
                        total39 = 1.0 - 0.5*given4
                        back22 = total39 - 1.0
                        lost37 = -back22 - 0.5*given4
                        decay_series_of3 = decay_series(xp, given4)
                        curved4 = decay_series_of3*(given4*given4)
                        total45 = curved4 + total39
                        back22 = total45 - total39
                        lost35 = curved4 - back22
                        mean_low5 = lost37 + lost35
                        total39 = given4*total45
                        given4_halves = halves(xp, given4)
                        total45_halves = halves(xp, total45)
                        lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                            total45_halves)
                        total47 = 1.0 - total39
                        back22 = total47 - 1.0
                        lost37 = -back22 - total39
                        fall_low5 = lost37 - lost35
                        total39 = total45 - total41
                        back22 = total39 - total45
                        rest10 = total39 - back22
                        one9 = total45 - rest10
                        two9 = -back22 - total41
                        lost37 = one9 + two9
                        total49 = given4*total39
                        total39_halves = halves(xp, total39)
                        lost37 = (
                            given4*(lost37 - lost36 + mean_low5) +
                            product_error(total49, given4_halves, total39_halves)
                        )
                        total39 = total40 - total49
                        back22 = total39 - total40
                        rest10 = total39 - back22
                        one9 = total40 - rest10
                        two9 = -back22 - total49
                        lost35 = one9 + two9
                        low22 = lift_low - lost37 + lost35
                        total49 = low22 + total39
                        back22 = total49 - total39
                        rest10 = total49 - back22
                        one9 = total39 - rest10
                        two9 = low22 - back22
                        lost35 = one9 + two9
                        total39 = total47*total49
                        total47_halves = halves(xp, total47)
                        total49_halves = halves(xp, total49)
                        lost35 = lost35*total47 + product_error(total39, total47_halves,
                            total49_halves)
                        low22 = fall_low5*total49 + lost35
                        total49 = total39/stiff
                        left = total39 - stiff*total49
                        total49_halves = halves(xp, total49)
                        stiff_halves = halves(xp, stiff)
                        left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                        left = left + low22
                        lost35 = left/stiff
                        expm1_of = xp.expm1(-half)
                        grown = -0.5*expm1_of
                        angle = 0.5*root
                        wave = xp.cos(angle)
                        sin_of = xp.sin(angle)
                        back22 = 0.5*root_low*sin_of
                        total39 = wave - back22
                        back82 = total39 - wave
                        rest10 = total39 - back82
                        one9 = wave - rest10
                        two9 = -back22 - back82
                        lost37 = one9 + two9
                        total102 = (total39*total39)
                        total39_halves = halves(xp, total39)
                        lost102 = product_error(total102, total39_halves, total39_halves)
                        low22 = lost102 + 2.0*lost37*total39
                        total39 = envelope*total102
                        envelope_halves = halves(xp, envelope)
                        total102_halves = halves(xp, total102)
                        lost37 = envelope*low22 + product_error(total39, envelope_halves,
                            total102_halves)
                        total102 = (grown*grown) + total39
                        back82 = total102 - total39
                        rest10 = total102 - back82
                        one9 = total39 - rest10
                        two9 = (grown*grown) - back82
                        lost102 = one9 + two9
                        low22 = lost37 + lost102
                        total39 = total41*total47
                        lost36 = lost36*total47 + product_error(total39, total47_halves,
                            total41_halves)
                        total482 = total45 - total39
                        back82 = total482 - total45
                        rest10 = total482 - back82
                        one9 = total45 - rest10
                        two9 = -back82 - total39
                        lost102 = one9 + two9
                        low24 = lost102 - fall_low5*total41 - lost36 + mean_low5
                        total41 = given4*total482
                        total482_halves = halves(xp, total482)
                        lost102 = given4*low24 + product_error(total41, given4_halves,
                            total482_halves)
                        total482 = total40*total47
                        total40_halves = halves(xp, total40)
                        lost36 = lift_low*total47 + product_error(total482, total47_halves,
                            total40_halves)
                        total47 = total41 + total482
                        back82 = total47 - total41
                        rest10 = total47 - back82
                        one9 = total41 - rest10
                        two9 = total482 - back82
                        lost37 = one9 + two9
                        low24 = fall_low5*total40 + lost102 + lost36 + lost37
                        total40 = total47/stiff
                        left = total47 - stiff*total40
                        total40_halves = halves(xp, total40)
                        left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                        left = left + low24
                        lost37 = left/stiff
                        apart_of = lost28 + total28
                        fall_of = lost35 + total49
                        nyquist_of = 4.0*low22 + 4.0*total102
                        rise_of = lost37 + total40
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    apart_of, fall_of, nyquist_of, rise_of, together_of = (
                        select(xp, total263 > 0.0, yes,
                        (count, delta, even, half, lost2, lost28, lost563, low2, root, size,
                        square2, stiff, total263, total28, total34, total35, total36, total37,
                        total38, total563, twice2, whole32), no,
                        (count, envelope, half, lost2, lost28, lost563, low2, root, size,
                        stiff, total28, total34, total35, total36, total37, total38, total563,
                        whole32))
                    )

                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(delta, envelope, even, half, lost2, lost28, lost563, root, size, square2,
                    stiff, total263, total28, total563, twice2):

                    def yes(delta, envelope, even, half, lost2, lost28, lost563, root, size,
                        square2, stiff, total263, total28, total563, twice2):
                        e = xp.exp(-delta)
                        total253 = e + 1.0
                        back182 = total253 - 1.0
                        lost253 = e - back182
                        total273 = total253 + total263
                        back182 = total273 - total253
                        lost273 = total263 - back182

                        def yes(lost2, square2):
                            given3 = square2
                            total19 = 0.5*given3 + 1.0
                            back13 = total19 - 1.0
                            lost19 = 0.5*given3 - back13
                            cos_series_of = cos_series(xp, given3)
                            curved3 = cos_series_of*(given3*given3)
                            total20 = curved3 + total19
                            back13 = total20 - total19
                            lost20 = curved3 - back13
                            even_low = lost19 + 0.5*lost2 + lost20
                            sin_series_of = sin_series(xp, given3)
                            bent = given3*sin_series_of
                            total20 = bent + 1.0
                            back13 = total20 - 1.0
                            lost20 = bent - back13
                            odd_low = 0.16666666666666666*lost2 + lost20
                            odd = total20
                            return even_low, odd, odd_low

                        def no(lost2, root, size):
                            sign_low = -lost2
                            left = size - (root*root)
                            root_halves = halves(xp, root)
                            left = left - product_error(root*root, root_halves, root_halves)
                            left = left + sign_low
                            whole = xp.where(root == 0.0, 1.0, root)
                            root_low = 0.5*left/whole
                            sine = xp.sin(root)
                            cosine = xp.cos(root)
                            some = root
                            total22 = sine/some
                            left = sine - some*total22
                            total22_halves = halves(xp, total22)
                            some_halves = halves(xp, some)
                            left = left - product_error(total22*some, total22_halves, some_halves)
                            left = cosine*root_low + left - root_low*total22
                            lost22 = left/some
                            even_low2 = -root_low*sine
                            odd = total22
                            odd_low2 = lost22
                            return even_low2, odd, odd_low2

                        even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes,
                            (lost2, square2), no, (lost2, root, size))

                        total253 = half*odd
                        half_halves = halves(xp, half)
                        odd_halves = halves(xp, odd)
                        lost23 = half*odd_low2 + product_error(total253, half_halves, odd_halves)
                        total252 = total253 - even
                        back182 = total252 - total253
                        rest42 = total252 - back182
                        one32 = total253 - rest42
                        two32 = -back182 - even
                        lost252 = one32 + two32
                        total262 = envelope + total252
                        back182 = total262 - total252
                        rest42 = total262 - back182
                        one32 = total252 - rest42
                        two32 = envelope - back182
                        lost262 = one32 + two32
                        total252 = envelope*total262
                        envelope_halves = halves(xp, envelope)
                        total262_halves = halves(xp, total262)
                        lost262 = (
                            envelope*(lost23 - even_low2 + lost252 + lost262) +
                            product_error(total252, envelope_halves, total262_halves)
                        )
                        total262 = total252/stiff
                        left16 = total252 - stiff*total262
                        total262_halves = halves(xp, total262)
                        stiff_halves = halves(xp, stiff)
                        left16 = left16 - product_error(total262*stiff, total262_halves,
                            stiff_halves)
                        left16 = left16 + lost262
                        lost262 = left16/stiff
                        twice2_halves = halves(xp, twice2)
                        even_halves = halves(xp, even)
                        lost252 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                            even_halves)
                        total252 = even + total253
                        back182 = total252 - even
                        rest42 = total252 - back182
                        one32 = even - rest42
                        two32 = total253 - back182
                        lost242 = one32 + two32
                        total253 = envelope*total252
                        total252_halves = halves(xp, total252)
                        lost242 = (
                            envelope*(even_low2 + lost23 + lost242) +
                            product_error(total253, envelope_halves, total252_halves)
                        )
                        total252 = 1.0 - total253
                        back182 = total252 - 1.0
                        lost23 = -back182 - total253
                        total253 = total252/stiff
                        left16 = total252 - stiff*total253
                        total253_halves = halves(xp, total253)
                        left16 = left16 - product_error(total253*stiff, total253_halves,
                            stiff_halves)
                        left16 = left16 - lost242 + lost23
                        lost23 = left16/stiff
                        apart_of = lost28 + total28
                        fall_of = lost262 + total262
                        nyquist_of = lost253 + lost252 + lost273 + total273
                        rise_of = lost23 + total253
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    def no(envelope, even, half, lost2, lost28, lost563, root, size, square2,
                        stiff, total28, total563):
                        sign_low = -lost2
                        left = size - (root*root)
                        root_halves = halves(xp, root)
                        left = left - product_error(root*root, root_halves, root_halves)
                        left = left + sign_low
                        whole = xp.where(root == 0.0, 1.0, root)
                        root_low = 0.5*left/whole
                        expm1_of = xp.expm1(-half)
                        grown = -0.5*expm1_of
                        angle = 0.5*root
                        wave = xp.cos(angle)
                        sin_of = xp.sin(angle)
                        back72 = 0.5*root_low*sin_of
                        total92 = wave - back72
                        back82 = total92 - wave
                        rest33 = total92 - back82
                        one23 = wave - rest33
                        two23 = -back72 - back82
                        lost92 = one23 + two23
                        total102 = (total92*total92)
                        total92_halves = halves(xp, total92)
                        lost102 = product_error(total102, total92_halves, total92_halves)
                        low4 = lost102 + 2.0*lost92*total92
                        total92 = envelope*total102
                        envelope_halves = halves(xp, envelope)
                        total102_halves = halves(xp, total102)
                        lost92 = envelope*low4 + product_error(total92, envelope_halves,
                            total102_halves)
                        total102 = (grown*grown) + total92
                        back82 = total102 - total92
                        rest33 = total102 - back82
                        one23 = total92 - rest33
                        two23 = (grown*grown) - back82
                        lost102 = one23 + two23
                        low4 = lost92 + lost102

                        def yes(lost2, square2):
                            given3 = square2
                            total19 = 0.5*given3 + 1.0
                            back13 = total19 - 1.0
                            lost19 = 0.5*given3 - back13
                            cos_series_of = cos_series(xp, given3)
                            curved3 = cos_series_of*(given3*given3)
                            total20 = curved3 + total19
                            back13 = total20 - total19
                            lost20 = curved3 - back13
                            even_low = lost19 + 0.5*lost2 + lost20
                            sin_series_of = sin_series(xp, given3)
                            bent = given3*sin_series_of
                            total20 = bent + 1.0
                            back13 = total20 - 1.0
                            lost20 = bent - back13
                            odd_low = 0.16666666666666666*lost2 + lost20
                            odd = total20
                            return even_low, odd, odd_low

                        def no(root, root_low):
                            sine = xp.sin(root)
                            cosine = xp.cos(root)
                            some = root
                            total22 = sine/some
                            left10 = sine - some*total22
                            total22_halves = halves(xp, total22)
                            some_halves = halves(xp, some)
                            left10 = left10 - product_error(total22*some, total22_halves,
                                some_halves)
                            left10 = cosine*root_low + left10 - root_low*total22
                            lost22 = left10/some
                            even_low2 = -root_low*sine
                            odd = total22
                            odd_low2 = lost22
                            return even_low2, odd, odd_low2

                        even_low2, odd, odd_low2 = select(xp, square2 > -1.5, yes,
                            (lost2, square2), no, (root, root_low))

                        total92 = half*odd
                        half_halves = halves(xp, half)
                        odd_halves = halves(xp, odd)
                        lost102 = half*odd_low2 + product_error(total92, half_halves, odd_halves)
                        total252 = total92 - even
                        back82 = total252 - total92
                        rest33 = total252 - back82
                        one23 = total92 - rest33
                        two23 = -back82 - even
                        lost92 = one23 + two23
                        total262 = envelope + total252
                        back82 = total262 - total252
                        rest33 = total262 - back82
                        one23 = total252 - rest33
                        two23 = envelope - back82
                        lost262 = one23 + two23
                        total252 = envelope*total262
                        total262_halves = halves(xp, total262)
                        lost262 = (
                            envelope*(lost102 - even_low2 + lost92 + lost262) +
                            product_error(total252, envelope_halves, total262_halves)
                        )
                        total262 = total252/stiff
                        left = total252 - stiff*total262
                        total262_halves = halves(xp, total262)
                        stiff_halves = halves(xp, stiff)
                        left = left - product_error(total262*stiff, total262_halves, stiff_halves)
                        left = left + lost262
                        lost262 = left/stiff
                        total252 = even + total92
                        back82 = total252 - even
                        rest33 = total252 - back82
                        one23 = even - rest33
                        two23 = total92 - back82
                        lost92 = one23 + two23
                        total92 = envelope*total252
                        total252_halves = halves(xp, total252)
                        lost92 = (
                            envelope*(even_low2 + lost102 + lost92) +
                            product_error(total92, envelope_halves, total252_halves)
                        )
                        total252 = 1.0 - total92
                        back82 = total252 - 1.0
                        lost102 = -back82 - total92
                        total92 = total252/stiff
                        left = total252 - stiff*total92
                        total92_halves = halves(xp, total92)
                        left = left - product_error(total92*stiff, total92_halves, stiff_halves)
                        left = left - lost92 + lost102
                        lost102 = left/stiff
                        apart_of = lost28 + total28
                        fall_of = lost262 + total262
                        nyquist_of = 4.0*low4 + 4.0*total102
                        rise_of = lost102 + total92
                        together_of = 2.0*lost563 + 2.0*total563
                        return apart_of, fall_of, nyquist_of, rise_of, together_of

                    apart_of, fall_of, nyquist_of, rise_of, together_of = (
                        select(xp, total263 > 0.0, yes,
                        (delta, envelope, even, half, lost2, lost28, lost563, root, size,
                        square2, stiff, total263, total28, total563, twice2), no,
                        (envelope, even, half, lost2, lost28, lost563, root, size, square2,
                        stiff, total28, total563))
                    )

                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, delta, envelope, even, half, lost2, lost27, lost553, low2, root,
                    size, square2, stiff, total27, total28, total30, total31, total29, total37,
                    total38, total563, twice2, whole32), no,
                    (delta, envelope, even, half, lost2, lost27, lost553, root, size, square2,
                    stiff, total27, total28, total563, twice2))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            apart_of, fall_of, nyquist_of, rise_of, together_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, total2), no,
                (delta, gamma, half, lost2, total2))
            )

            return apart_of, fall_of, nyquist_of, rise_of, together_of

        def no(delta, gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma
            mean3 = decay(xp, delta)
            twice2 = 2.0*envelope

            def yes(lost2, square2):
                given3 = square2
                total19 = 0.5*given3 + 1.0
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total19 = curved3 + total19
                sin_series_of = sin_series(xp, given3)
                bent = given3*sin_series_of
                total21 = bent + 1.0
                back15 = total21 - 1.0
                lost21 = bent - back15
                odd_low = 0.16666666666666666*lost2 + lost21
                even = total19
                odd = total21
                return even, odd, odd_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                some = root
                total22 = sine/some
                left = sine - some*total22
                total22_halves = halves(xp, total22)
                some_halves = halves(xp, some)
                left = left - product_error(total22*some, total22_halves, some_halves)
                left = cosine*root_low + left - root_low*total22
                lost22 = left/some
                even = cosine
                odd = total22
                odd_low2 = lost22
                return even, odd, odd_low2

            even, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total24 = envelope*odd
            envelope_halves = halves(xp, envelope)
            odd_halves = halves(xp, odd)
            lost24 = envelope*odd_low2 + product_error(total24, envelope_halves, odd_halves)
            total25 = mean3 - total24
            back16 = total25 - mean3
            rest4 = total25 - back16
            one3 = mean3 - rest4
            two3 = -back16 - total24
            lost25 = one3 + two3
            total24 = total25/stiff
            left13 = total25 - stiff*total24
            total24_halves = halves(xp, total24)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total24*stiff, total24_halves, stiff_halves)
            left13 = left13 - lost24 + lost25
            lost25 = left13/stiff
            total25 = even*twice2

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total29 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number5_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost24 = product_error(total29, turns_halves, number5_halves)
            total30 = 2.5061182034958845e-15*turns
            number6_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost30 = product_error(total30, turns_halves, number6_halves)
            total31 = -total2 - total29
            back16 = total2 + total31
            rest4 = total31 - back16
            one3 = -rest4 - total2
            two3 = -back16 - total29
            lost31 = one3 + two3
            total29 = total31 - lost24
            back16 = total29 - total31
            rest4 = total29 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost24
            lost24 = one3 + two3
            total31 = total29 - total30
            back16 = total31 - total29
            rest4 = total31 - back16
            one3 = total29 - rest4
            two3 = -back16 - total30
            lost33 = one3 + two3
            total30 = total31 - lost2
            back16 = total30 - total31
            rest4 = total30 - back16
            one3 = total31 - rest4
            two3 = -back16 - lost2
            lost34 = one3 + two3
            low2 = lost31 - lost30 + lost24 + lost33 + lost34 - 1.4920070805839235e-31*turns
            total31 = low2 + total30
            total29 = 6.283185307179586*count
            total37 = root + total29
            whole32 = xp.where(total37 == 0.0, 1.0, total37)
            total38 = total31/whole32
            far = (total38*total38)

            def yes(count, delta, envelope, even, half, lost2, lost26, low2, root, size, square2,
                stiff, total26, total263, total34, total35, total36, total37, total38, twice2,
                whole32):

                def yes(count, delta, even, half, lost2, lost26, low2, root, size, square2, stiff,
                    total26, total263, total34, total35, total36, total37, total38, twice2,
                    whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    back22 = total35 - total34
                    rest10 = total35 - back22
                    one9 = total34 - rest10
                    two9 = low2 - back22
                    lost35 = one9 + two9
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                    lost36 = product_error(count*6.283185307179586, count_halves, number2_halves)
                    back22 = total37 - root
                    rest10 = total37 - back22
                    one9 = root - rest10
                    two9 = total36 - back22
                    lost37 = one9 + two9
                    both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                    left = total35 - total38*whole32
                    total38_halves = halves(xp, total38)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                    left = left - both_low*total38 + lost35
                    lost35 = left/whole32
                    eta = total38
                    eta_low = lost35
                    total39 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total39)
                    bent2 = cos_series_of2*(total39*total39)
                    total40 = 0.5*total39 - bent2
                    back22 = total40 - 0.5*total39
                    lost37 = -back22 - bent2
                    sin_series_of2 = sin_series(xp, -total39)
                    total41 = 1.0 - sin_series_of2*total39
                    back22 = total41 - 1.0
                    lost36 = -back22 - sin_series_of2*total39
                    lift_low = 0.5*lost35*total41 + lost37
                    total39 = eta*total41
                    total41_halves = halves(xp, total41)
                    lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                    some2 = root
                    total41 = total39/some2
                    left = total39 - some2*total41
                    total41_halves = halves(xp, total41)
                    some2_halves = halves(xp, some2)
                    left = left - product_error(total41*some2, total41_halves, some2_halves)
                    left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                    lost36 = left/some2
                    given4 = half
                    total39 = 1.0 - 0.5*given4
                    back22 = total39 - 1.0
                    lost37 = -back22 - 0.5*given4
                    decay_series_of3 = decay_series(xp, given4)
                    curved4 = decay_series_of3*(given4*given4)
                    total45 = curved4 + total39
                    back22 = total45 - total39
                    lost35 = curved4 - back22
                    mean_low5 = lost37 + lost35
                    total39 = given4*total45
                    given4_halves = halves(xp, given4)
                    total45_halves = halves(xp, total45)
                    lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                        total45_halves)
                    total47 = 1.0 - total39
                    back22 = total47 - 1.0
                    lost37 = -back22 - total39
                    fall_low5 = lost37 - lost35
                    total39 = total45 - total41
                    back22 = total39 - total45
                    rest10 = total39 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total41
                    lost37 = one9 + two9
                    total49 = given4*total39
                    total39_halves = halves(xp, total39)
                    lost37 = (
                        given4*(lost37 - lost36 + mean_low5) +
                        product_error(total49, given4_halves, total39_halves)
                    )
                    total39 = total40 - total49
                    back22 = total39 - total40
                    rest10 = total39 - back22
                    one9 = total40 - rest10
                    two9 = -back22 - total49
                    lost35 = one9 + two9
                    low22 = lift_low - lost37 + lost35
                    total49 = low22 + total39
                    back22 = total49 - total39
                    rest10 = total49 - back22
                    one9 = total39 - rest10
                    two9 = low22 - back22
                    lost35 = one9 + two9
                    total39 = total47*total49
                    total47_halves = halves(xp, total47)
                    total49_halves = halves(xp, total49)
                    lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                    low22 = fall_low5*total49 + lost35
                    total49 = total39/stiff
                    left = total39 - stiff*total49
                    total49_halves = halves(xp, total49)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                    left = left + low22
                    lost35 = left/stiff
                    e = xp.exp(-delta)
                    total39 = e + 1.0
                    back22 = total39 - 1.0
                    lost37 = e - back22
                    total273 = total39 + total263
                    back22 = total273 - total39
                    lost273 = total263 - back22
                    total39 = total41*total47
                    lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                    total482 = total45 - total39
                    back22 = total482 - total45
                    rest10 = total482 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total39
                    lost482 = one9 + two9
                    low22 = lost482 - fall_low5*total41 - lost36 + mean_low5
                    total41 = given4*total482
                    total482_halves = halves(xp, total482)
                    lost482 = given4*low22 + product_error(total41, given4_halves, total482_halves)
                    total482 = total40*total47
                    total40_halves = halves(xp, total40)
                    lost36 = lift_low*total47 + product_error(total482, total47_halves,
                        total40_halves)
                    total39 = total41 + total482
                    back22 = total39 - total41
                    rest10 = total39 - back22
                    one9 = total41 - rest10
                    two9 = total482 - back22
                    lost512 = one9 + two9
                    low22 = fall_low5*total40 + lost482 + lost36 + lost512
                    total41 = total39/stiff
                    left = total39 - stiff*total41
                    total41_halves = halves(xp, total41)
                    left = left - product_error(total41*stiff, total41_halves, stiff_halves)
                    left = left + low22
                    lost512 = left/stiff
                    total39 = 1.0 - total47
                    back22 = total39 - 1.0
                    lost482 = -back22 - total47
                    low22 = lost482 - fall_low5
                    total47 = low22 + total39
                    back22 = total47 - total39
                    lost482 = low22 - back22
                    total39 = (total47*total47)
                    total47_halves = halves(xp, total47)
                    lost482 = 2.0*lost482*total47 + product_error(total39, total47_halves,
                        total47_halves)
                    total47 = total39 + 2.0*total482
                    back22 = total47 - total39
                    rest10 = total47 - back22
                    one9 = total39 - rest10
                    two9 = 2.0*total482 - back22
                    lost372 = one9 + two9
                    low22 = 2.0*fall_low5*total40 + lost482 + lost372 + 2.0*lost36
                    total40 = total47/stiff
                    left = total47 - stiff*total40
                    total40_halves = halves(xp, total40)
                    left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                    left = left + low22
                    lost372 = left/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost482 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost26 + total26
                    fall_of = lost35 + total49
                    nyquist_of = lost37 + lost482 + lost273 + total273
                    rise_of = lost512 + total41
                    together_of = lost372 + total40
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(count, envelope, half, lost2, lost26, low2, root, size, stiff, total26,
                    total34, total35, total36, total37, total38, whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    back22 = total35 - total34
                    rest10 = total35 - back22
                    one9 = total34 - rest10
                    two9 = low2 - back22
                    lost35 = one9 + two9
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                    lost36 = product_error(count*6.283185307179586, count_halves, number2_halves)
                    back22 = total37 - root
                    rest10 = total37 - back22
                    one9 = root - rest10
                    two9 = total36 - back22
                    lost37 = one9 + two9
                    both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low
                    left = total35 - total38*whole32
                    total38_halves = halves(xp, total38)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total38*whole32, total38_halves, whole32_halves)
                    left = left - both_low*total38 + lost35
                    lost35 = left/whole32
                    eta = total38
                    eta_low = lost35
                    total39 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost35 = 2.0*eta*eta_low + product_error(total39, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total39)
                    bent2 = cos_series_of2*(total39*total39)
                    total40 = 0.5*total39 - bent2
                    back22 = total40 - 0.5*total39
                    lost37 = -back22 - bent2
                    sin_series_of2 = sin_series(xp, -total39)
                    total41 = 1.0 - sin_series_of2*total39
                    back22 = total41 - 1.0
                    lost36 = -back22 - sin_series_of2*total39
                    lift_low = 0.5*lost35*total41 + lost37
                    total39 = eta*total41
                    total41_halves = halves(xp, total41)
                    lost36 = eta*lost36 + product_error(total39, eta_halves, total41_halves)
                    some2 = root
                    total41 = total39/some2
                    left = total39 - some2*total41
                    total41_halves = halves(xp, total41)
                    some2_halves = halves(xp, some2)
                    left = left - product_error(total41*some2, total41_halves, some2_halves)
                    left = eta_low*(1.0 - total40) + left + lost36 - root_low*total41
                    lost36 = left/some2
                    given4 = half
                    total39 = 1.0 - 0.5*given4
                    back22 = total39 - 1.0
                    lost37 = -back22 - 0.5*given4
                    decay_series_of3 = decay_series(xp, given4)
                    curved4 = decay_series_of3*(given4*given4)
                    total45 = curved4 + total39
                    back22 = total45 - total39
                    lost35 = curved4 - back22
                    mean_low5 = lost37 + lost35
                    total39 = given4*total45
                    given4_halves = halves(xp, given4)
                    total45_halves = halves(xp, total45)
                    lost35 = given4*mean_low5 + product_error(total39, given4_halves,
                        total45_halves)
                    total47 = 1.0 - total39
                    back22 = total47 - 1.0
                    lost37 = -back22 - total39
                    fall_low5 = lost37 - lost35
                    total39 = total45 - total41
                    back22 = total39 - total45
                    rest10 = total39 - back22
                    one9 = total45 - rest10
                    two9 = -back22 - total41
                    lost37 = one9 + two9
                    total49 = given4*total39
                    total39_halves = halves(xp, total39)
                    lost37 = (
                        given4*(lost37 - lost36 + mean_low5) +
                        product_error(total49, given4_halves, total39_halves)
                    )
                    total39 = total40 - total49
                    back22 = total39 - total40
                    rest10 = total39 - back22
                    one9 = total40 - rest10
                    two9 = -back22 - total49
                    lost35 = one9 + two9
                    low22 = lift_low - lost37 + lost35
                    total49 = low22 + total39
                    back22 = total49 - total39
                    rest10 = total49 - back22
                    one9 = total39 - rest10
                    two9 = low22 - back22
                    lost35 = one9 + two9
                    total39 = total47*total49
                    total47_halves = halves(xp, total47)
                    total49_halves = halves(xp, total49)
                    lost35 = lost35*total47 + product_error(total39, total47_halves, total49_halves)
                    low22 = fall_low5*total49 + lost35
                    total49 = total39/stiff
                    left = total39 - stiff*total49
                    total49_halves = halves(xp, total49)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total49*stiff, total49_halves, stiff_halves)
                    left = left + low22
                    lost35 = left/stiff
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back22 = 0.5*root_low*sin_of
                    total39 = wave - back22
                    back82 = total39 - wave
                    rest10 = total39 - back82
                    one9 = wave - rest10
                    two9 = -back22 - back82
                    lost37 = one9 + two9
                    total102 = (total39*total39)
                    total39_halves = halves(xp, total39)
                    lost102 = product_error(total102, total39_halves, total39_halves)
                    low22 = lost102 + 2.0*lost37*total39
                    total39 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost37 = envelope*low22 + product_error(total39, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total39
                    back82 = total102 - total39
                    rest10 = total102 - back82
                    one9 = total39 - rest10
                    two9 = (grown*grown) - back82
                    lost102 = one9 + two9
                    low22 = lost37 + lost102
                    total39 = total41*total47
                    lost36 = lost36*total47 + product_error(total39, total47_halves, total41_halves)
                    total482 = total45 - total39
                    back82 = total482 - total45
                    rest10 = total482 - back82
                    one9 = total45 - rest10
                    two9 = -back82 - total39
                    lost102 = one9 + two9
                    low24 = lost102 - fall_low5*total41 - lost36 + mean_low5
                    total41 = given4*total482
                    total482_halves = halves(xp, total482)
                    lost102 = given4*low24 + product_error(total41, given4_halves, total482_halves)
                    total482 = total40*total47
                    total40_halves = halves(xp, total40)
                    lost36 = lift_low*total47 + product_error(total482, total47_halves,
                        total40_halves)
                    total39 = total41 + total482
                    back82 = total39 - total41
                    rest10 = total39 - back82
                    one9 = total41 - rest10
                    two9 = total482 - back82
                    lost37 = one9 + two9
                    low24 = fall_low5*total40 + lost102 + lost36 + lost37
                    total41 = total39/stiff
                    left = total39 - stiff*total41
                    total41_halves = halves(xp, total41)
                    left = left - product_error(total41*stiff, total41_halves, stiff_halves)
                    left = left + low24
                    lost37 = left/stiff
                    total39 = 1.0 - total47
                    back82 = total39 - 1.0
                    lost102 = -back82 - total47
                    low24 = lost102 - fall_low5
                    total47 = low24 + total39
                    back82 = total47 - total39
                    lost102 = low24 - back82
                    total39 = (total47*total47)
                    total47_halves = halves(xp, total47)
                    lost102 = 2.0*lost102*total47 + product_error(total39, total47_halves,
                        total47_halves)
                    total47 = total39 + 2.0*total482
                    back82 = total47 - total39
                    rest10 = total47 - back82
                    one9 = total39 - rest10
                    two9 = 2.0*total482 - back82
                    lost372 = one9 + two9
                    low24 = 2.0*fall_low5*total40 + lost102 + lost372 + 2.0*lost36
                    total40 = total47/stiff
                    left = total47 - stiff*total40
                    total40_halves = halves(xp, total40)
                    left = left - product_error(total40*stiff, total40_halves, stiff_halves)
                    left = left + low24
                    lost372 = left/stiff
                    apart_of = lost26 + total26
                    fall_of = lost35 + total49
                    nyquist_of = 4.0*low22 + 4.0*total102
                    rise_of = lost37 + total41
                    together_of = lost372 + total40
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, total263 > 0.0, yes, (count, delta, even, half, lost2, lost26, low2,
                    root, size, square2, stiff, total26, total263, total34, total35, total36,
                    total37, total38, twice2, whole32), no,
                    (count, envelope, half, lost2, lost26, low2, root, size, stiff, total26,
                    total34, total35, total36, total37, total38, whole32))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            def no(delta, envelope, even, half, lost2, lost26, odd, odd_low2, root, size, square2,
                stiff, total26, total263, twice2):

                def yes(delta, envelope, even, half, lost2, lost26, odd, odd_low2, root, size,
                    square2, stiff, total26, total263, twice2):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    total23 = half*odd
                    half_halves = halves(xp, half)
                    odd_halves = halves(xp, odd)
                    lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)
                    total252 = total23 - even
                    back162 = total252 - total23
                    rest42 = total252 - back162
                    one32 = total23 - rest42
                    two32 = -back162 - even
                    lost252 = one32 + two32
                    total262 = envelope + total252
                    back162 = total262 - total252
                    rest42 = total262 - back162
                    one32 = total252 - rest42
                    two32 = envelope - back162
                    lost262 = one32 + two32
                    total252 = envelope*total262
                    total282 = total252/stiff
                    left = total252 - stiff*total282
                    total282_halves = halves(xp, total282)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total282*stiff, total282_halves, stiff_halves)
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    e = xp.exp(-delta)
                    total253 = e + 1.0
                    back162 = total253 - 1.0
                    lost253 = e - back162
                    total273 = total253 + total263
                    back162 = total273 - total253
                    lost273 = total263 - back162
                    total253 = even + total23
                    back162 = total253 - even
                    rest42 = total253 - back162
                    one32 = even - rest42
                    two32 = total23 - back162
                    lost242 = one32 + two32
                    total23 = envelope*total253
                    total264 = 1.0 - total23
                    back162 = total264 - 1.0
                    lost264 = -back162 - total23
                    total274 = total264/stiff
                    left162 = total264 - stiff*total274
                    total274_halves = halves(xp, total274)
                    left162 = left162 - product_error(total274*stiff, total274_halves, stiff_halves)
                    back162 = -0.5*root_low*wave
                    total264 = sin_of - back162
                    back83 = total264 - sin_of
                    rest42 = total264 - back83
                    one32 = sin_of - rest42
                    two32 = -back162 - back83
                    lost93 = one32 + two32
                    total103 = (total264*total264)
                    total264_halves = halves(xp, total264)
                    lost103 = product_error(total103, total264_halves, total264_halves)
                    low5 = lost103 + 2.0*lost93*total264
                    total264 = envelope*total103
                    envelope_halves = halves(xp, envelope)
                    total103_halves = halves(xp, total103)
                    lost93 = envelope*low5 + product_error(total264, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total264
                    back83 = total103 - total264
                    rest42 = total103 - back83
                    one32 = total264 - rest42
                    two32 = (grown*grown) - back83
                    lost103 = one32 + two32
                    low5 = lost93 + lost103
                    total264 = total103/stiff
                    left72 = total103 - stiff*total264
                    total264_halves = halves(xp, total264)
                    left72 = left72 - product_error(total264*stiff, total264_halves, stiff_halves)
                    left72 = left72 + low5
                    lost103 = left72/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    total262_halves = halves(xp, total262)
                    lost262 = (
                        envelope*(lost23 - even_low2 + lost252 + lost262) +
                        product_error(total252, envelope_halves, total262_halves)
                    )
                    left = left + lost262
                    lost262 = left/stiff
                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost252 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    total253_halves = halves(xp, total253)
                    lost242 = (
                        envelope*(even_low2 + lost23 + lost242) +
                        product_error(total23, envelope_halves, total253_halves)
                    )
                    left162 = left162 - lost242 + lost264
                    lost264 = left162/stiff
                    apart_of = lost26 + total26
                    fall_of = lost262 + total282
                    nyquist_of = lost253 + lost252 + lost273 + total273
                    rise_of = lost264 + total274
                    together_of = 4.0*lost103 + 4.0*total264
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                def no(envelope, even, half, lost2, lost26, odd, odd_low2, root, size, square2,
                    stiff, total26):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    total23 = half*odd
                    half_halves = halves(xp, half)
                    odd_halves = halves(xp, odd)
                    lost23 = half*odd_low2 + product_error(total23, half_halves, odd_halves)
                    total252 = total23 - even
                    back162 = total252 - total23
                    rest42 = total252 - back162
                    one32 = total23 - rest42
                    two32 = -back162 - even
                    lost252 = one32 + two32
                    total262 = envelope + total252
                    back162 = total262 - total252
                    rest42 = total262 - back162
                    one32 = total252 - rest42
                    two32 = envelope - back162
                    lost262 = one32 + two32
                    total252 = envelope*total262
                    total282 = total252/stiff
                    left = total252 - stiff*total282
                    total282_halves = halves(xp, total282)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total282*stiff, total282_halves, stiff_halves)
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back162 = 0.5*root_low*sin_of
                    total92 = wave - back162
                    back82 = total92 - wave
                    rest42 = total92 - back82
                    one32 = wave - rest42
                    two32 = -back162 - back82
                    lost92 = one32 + two32
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low4 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low4 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest42 = total102 - back82
                    one32 = total92 - rest42
                    two32 = (grown*grown) - back82
                    lost102 = one32 + two32
                    low4 = lost92 + lost102
                    total92 = even + total23
                    back82 = total92 - even
                    rest42 = total92 - back82
                    one32 = even - rest42
                    two32 = total23 - back82
                    lost102 = one32 + two32
                    total23 = envelope*total92
                    total264 = 1.0 - total23
                    back82 = total264 - 1.0
                    lost92 = -back82 - total23
                    total274 = total264/stiff
                    left162 = total264 - stiff*total274
                    total274_halves = halves(xp, total274)
                    left162 = left162 - product_error(total274*stiff, total274_halves, stiff_halves)
                    back82 = -0.5*root_low*wave
                    total264 = sin_of - back82
                    back162 = total264 - sin_of
                    rest42 = total264 - back162
                    one32 = sin_of - rest42
                    two32 = -back82 - back162
                    lost93 = one32 + two32
                    total103 = (total264*total264)
                    total264_halves = halves(xp, total264)
                    lost103 = product_error(total103, total264_halves, total264_halves)
                    low5 = lost103 + 2.0*lost93*total264
                    total264 = envelope*total103
                    total103_halves = halves(xp, total103)
                    lost93 = envelope*low5 + product_error(total264, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total264
                    back162 = total103 - total264
                    rest42 = total103 - back162
                    one32 = total264 - rest42
                    two32 = (grown*grown) - back162
                    lost103 = one32 + two32
                    low5 = lost93 + lost103
                    total264 = total103/stiff
                    left72 = total103 - stiff*total264
                    total264_halves = halves(xp, total264)
                    left72 = left72 - product_error(total264*stiff, total264_halves, stiff_halves)
                    left72 = left72 + low5
                    lost103 = left72/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    total262_halves = halves(xp, total262)
                    lost262 = (
                        envelope*(lost23 - even_low2 + lost252 + lost262) +
                        product_error(total252, envelope_halves, total262_halves)
                    )
                    left = left + lost262
                    lost262 = left/stiff
                    total92_halves = halves(xp, total92)
                    lost102 = (
                        envelope*(even_low2 + lost23 + lost102) +
                        product_error(total23, envelope_halves, total92_halves)
                    )
                    left162 = left162 - lost102 + lost92
                    lost92 = left162/stiff
                    apart_of = lost26 + total26
                    fall_of = lost262 + total282
                    nyquist_of = 4.0*low4 + 4.0*total102
                    rise_of = lost92 + total274
                    together_of = 4.0*lost103 + 4.0*total264
                    return apart_of, fall_of, nyquist_of, rise_of, together_of

                apart_of, fall_of, nyquist_of, rise_of, together_of = (
                    select(xp, total263 > 0.0, yes, (delta, envelope, even, half, lost2, lost26,
                    odd, odd_low2, root, size, square2, stiff, total26, total263, twice2), no,
                    (envelope, even, half, lost2, lost26, odd, odd_low2, root, size, square2,
                    stiff, total26))
                )

                return apart_of, fall_of, nyquist_of, rise_of, together_of

            apart_of, fall_of, nyquist_of, rise_of, together_of = (
                select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                (count, delta, envelope, even, half, lost2, lost25, low2, root, size, square2,
                stiff, total24, total25, total30, total31, total29, total37, total38, twice2,
                whole32), no, (delta, envelope, even, half, lost2, lost25, odd, odd_low2, root,
                size, square2, stiff, total24, total25, twice2))
            )

            return apart_of, fall_of, nyquist_of, rise_of, together_of

        apart_of, fall_of, nyquist_of, rise_of, together_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, total2), no,
            (delta, gamma, half, lost2, total2))
        )

        return apart_of, fall_of, nyquist_of, rise_of, together_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(delta, gamma, half, lost2, reach, root, size, total2, total3):

            def yes(delta, gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
                given5 = 0.5*half
                total27 = 1.0 - 0.5*given5
                back3 = total27 - 1.0
                lost54 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total55 = curved5 + total27
                back3 = total55 - total27
                lost55 = curved5 - back3
                mean_low6 = lost54 + lost55
                total27 = given5*total55
                given5_halves = halves(xp, given5)
                total55_halves = halves(xp, total55)
                lost55 = given5*mean_low6 + product_error(total27, given5_halves, total55_halves)
                total55 = 1.0 - total27
                back3 = total55 - 1.0
                lost54 = -back3 - total27
                fall_low6 = lost54 - lost55
                total27 = (total55*total55)
                total55_halves = halves(xp, total55)
                lost54 = 2.0*fall_low6*total55 + product_error(total27, total55_halves,
                    total55_halves)
                total55 = (total27*total27)
                total27_halves = halves(xp, total27)
                lost54 = 2.0*lost54*total27 + product_error(total55, total27_halves, total27_halves)
                rest6 = fall_series(xp, gamma, delta)
                total27 = rest6 + 0.5
                back3 = total27 - rest6
                rest5 = total27 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost55 = one4 + two4
                total61 = total55*total27
                total55_halves = halves(xp, total55)
                total27_halves = halves(xp, total27)
                lost55 = lost55*total55 + product_error(total61, total55_halves, total27_halves)
                half2 = half
                given5 = 0.5*half2
                total55 = 1.0 - 0.5*given5
                back3 = total55 - 1.0
                lost532 = -back3 - 0.5*given5
                decay_series_of4 = decay_series(xp, given5)
                curved5 = decay_series_of4*(given5*given5)
                total542 = curved5 + total55
                back3 = total542 - total55
                lost542 = curved5 - back3
                mean_low6 = lost532 + lost542
                total55 = given5*total542
                given5_halves = halves(xp, given5)
                total542_halves = halves(xp, total542)
                lost542 = given5*mean_low6 + product_error(total55, given5_halves, total542_halves)
                total542 = 1.0 - total55
                back3 = total542 - 1.0
                lost532 = -back3 - total55
                fall_low6 = lost532 - lost542
                total55 = (total542*total542)
                total542_halves = halves(xp, total542)
                lost532 = (
                    2.0*fall_low6*total542 + product_error(total55, total542_halves,
                    total542_halves)
                )
                rest5 = rise_series(xp, half2, total2)
                total542 = rest5 + 0.5
                back3 = total542 - rest5
                rest6 = total542 - back3
                one4 = rest5 - rest6
                two4 = 0.5 - back3
                lost542 = one4 + two4
                total592 = total55*total542
                total55_halves = halves(xp, total55)
                total542_halves = halves(xp, total542)
                lost542 = lost542*total55 + product_error(total592, total55_halves, total542_halves)
                rest6 = together_series(xp, half, total2)
                total55 = rest6 + 0.5
                back3 = total55 - rest6
                rest5 = total55 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost553 = one4 + two4
                total563 = envelope*total55
                total55_halves = halves(xp, total55)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total55_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    return fall_, fall_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    fall_ = sunk
                    fall_low2 = sunk_low
                    return fall_, fall_low2

                fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))

                total55 = fall_ + 1.0
                back3 = total55 - 1.0
                lost283 = fall_ - back3

                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    total10 = given2*total11
                    given2_halves = halves(xp, given2)
                    total11_halves = halves(xp, total11)
                    lost11 = given2*mean_low3 + product_error(total10, given2_halves,
                        total11_halves)
                    total13 = 1.0 - total10
                    back8 = total13 - 1.0
                    lost10 = -back8 - total10
                    fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                    fall2 = total13
                    return fall2, fall_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    fall2 = sunk2
                    fall_low4 = sunk_low2
                    return fall2, fall_low4

                fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no,
                    (root, root_low))

                fast = fall_*fall2
                fall__halves = halves(xp, fall_)
                fall2_halves = halves(xp, fall2)
                lost292 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
                low32 = fall2*fall_low2 + lost292
                total302 = fast + 1.0
                back3 = total302 - 1.0
                lost292 = fast - back3
                total312 = total55*total302
                total55_halves = halves(xp, total55)
                total302_halves = halves(xp, total302)
                lost292 = (
                    total55*(lost292 + low32) + product_error(total312, total55_halves,
                    total302_halves)
                )
                apart_of = lost3 + total28
                fall_of = lost54*total27 + lost55 + total61
                nyquist_of = lost292 + total302*(fall_low2 + lost283) + total312
                rise_of = lost532*total542 + lost542 + total592
                together_of = 2.0*lost553 + 2.0*total563
                return apart_of, fall_of, nyquist_of, rise_of, together_of

            def no(gamma, half, lost2, root, size, total2, total3):
                sign_low = lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                back3 = total3 - half
                lost3 = root - back3
                p_low = lost3 + root_low
                whole = xp.where(total3 == 0.0, 1.0, total3)
                q = gamma/whole
                off = gamma - q*whole
                whole_halves = halves(xp, whole)
                q_halves = halves(xp, q)
                off = off - product_error(whole*q, whole_halves, q_halves)
                off = off - p_low*q
                q_low = off/whole
                rate2 = 2.0*root
                envelope = xp.exp(-half)
                rest5 = apart_series(xp, half, total2)
                total27 = rest5 + 0.16666666666666666
                back3 = total27 - rest5
                rest6 = total27 - back3
                one4 = rest5 - rest6
                two4 = 0.16666666666666666 - back3
                lost3 = one4 + two4
                total28 = envelope*total27
                envelope_halves = halves(xp, envelope)
                total27_halves = halves(xp, total27)
                lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
                rest6 = together_series(xp, half, total2)
                total27 = rest6 + 0.5
                back3 = total27 - rest6
                rest5 = total27 - back3
                one4 = rest6 - rest5
                two4 = 0.5 - back3
                lost553 = one4 + two4
                total563 = envelope*total27
                total27_halves = halves(xp, total27)
                lost553 = envelope*lost553 + product_error(total563, envelope_halves,
                    total27_halves)

                def yes(q, q_low):
                    given = q
                    total4 = 1.0 - 0.5*given
                    back4 = total4 - 1.0
                    lost4 = -back4 - 0.5*given
                    decay_series_of = decay_series(xp, given)
                    curved = decay_series_of*(given*given)
                    total5 = curved + total4
                    back4 = total5 - total4
                    lost5 = curved - back4
                    mean_low = (
                        lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given + 0.5)
                    )
                    total4 = given*total5
                    given_halves = halves(xp, given)
                    total5_halves = halves(xp, total5)
                    lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                    total7 = 1.0 - total4
                    back4 = total7 - 1.0
                    lost4 = -back4 - total4
                    fall_low = lost4 - lost5 - q_low*total5
                    fall_ = total7
                    mean = total5
                    return fall_, fall_low, mean, mean_low

                def no(q, q_low):
                    sunk = xp.exp(-q)
                    sunk_low = -q_low*sunk
                    total8 = 1.0 - sunk
                    back7 = total8 - 1.0
                    lost8 = -back7 - sunk
                    bottom = q
                    total9 = total8/bottom
                    left4 = total8 - bottom*total9
                    total9_halves = halves(xp, total9)
                    bottom_halves = halves(xp, bottom)
                    left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                    left4 = left4 + lost8 - q_low*total9 - sunk_low
                    lost8 = left4/bottom
                    fall_ = sunk
                    fall_low2 = sunk_low
                    mean = total9
                    mean_low2 = lost8
                    return fall_, fall_low2, mean, mean_low2

                fall_, fall_low2, mean, mean_low2 = (
                    select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
                )

                total27 = fall_ + 1.0
                back3 = total27 - 1.0
                lost283 = fall_ - back3

                def yes(root, root_low):
                    given2 = 2.0*root
                    total10 = 1.0 - 0.5*given2
                    back8 = total10 - 1.0
                    lost10 = -back8 - 0.5*given2
                    decay_series_of2 = decay_series(xp, given2)
                    curved2 = decay_series_of2*(given2*given2)
                    total11 = curved2 + total10
                    back8 = total11 - total10
                    lost11 = curved2 - back8
                    mean_low3 = (
                        lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5)
                    )
                    total10 = given2*total11
                    given2_halves = halves(xp, given2)
                    total11_halves = halves(xp, total11)
                    lost11 = given2*mean_low3 + product_error(total10, given2_halves,
                        total11_halves)
                    total13 = 1.0 - total10
                    back8 = total13 - 1.0
                    lost10 = -back8 - total10
                    fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                    fall2 = total13
                    mean2 = total11
                    return fall2, fall_low3, mean2, mean_low3

                def no(root, root_low):
                    sunk2 = xp.exp(-2.0*root)
                    sunk_low2 = -2.0*root_low*sunk2
                    total14 = 1.0 - sunk2
                    back11 = total14 - 1.0
                    lost14 = -back11 - sunk2
                    bottom2 = 2.0*root
                    total15 = total14/bottom2
                    left7 = total14 - bottom2*total15
                    total15_halves = halves(xp, total15)
                    bottom2_halves = halves(xp, bottom2)
                    left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                    left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                    lost14 = left7/bottom2
                    fall2 = sunk2
                    fall_low4 = sunk_low2
                    mean2 = total15
                    mean_low4 = lost14
                    return fall2, fall_low4, mean2, mean_low4

                fall2, fall_low4, mean2, mean_low4 = (
                    select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
                )

                fast = fall_*fall2
                total162 = fall2*mean
                fall2_halves = halves(xp, fall2)
                mean_halves = halves(xp, mean)
                lost162 = fall2*mean_low2 + product_error(total162, fall2_halves, mean_halves)
                pulled_low = fall_low4*mean + lost162
                total172 = mean2 - total162
                back3 = total172 - mean2
                rest5 = total172 - back3
                one4 = mean2 - rest5
                two4 = -back3 - total162
                lost162 = one4 + two4
                total162 = total172/whole
                left = total172 - total162*whole
                total162_halves = halves(xp, total162)
                left = left - product_error(total162*whole, total162_halves, whole_halves)
                left = left + lost162 + mean_low4 - p_low*total162 - pulled_low
                lost162 = left/whole
                total172 = fall_*total162
                fall__halves = halves(xp, fall_)
                lost162 = fall_*lost162 + product_error(total172, fall__halves, total162_halves)
                creep_ = fall_low2*total162 + lost162 + total172
                lost162 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
                low32 = fall2*fall_low2 + lost162
                total172 = fast + 1.0
                back3 = total172 - 1.0
                lost162 = fast - back3
                total162 = total27*total172
                total27_halves = halves(xp, total27)
                total172_halves = halves(xp, total172)
                lost162 = (
                    total27*(lost162 + low32) + product_error(total162, total27_halves,
                    total172_halves)
                )
                total27 = fall_*mean2
                mean2_halves = halves(xp, mean2)
                lost163 = fall_*mean_low4 + product_error(total27, fall__halves, mean2_halves)
                pulled_low = fall_low2*mean2 + lost163
                total173 = mean - total27
                back3 = total173 - mean
                rest5 = total173 - back3
                one4 = mean - rest5
                two4 = -back3 - total27
                lost163 = one4 + two4
                total27 = total173/whole
                left = total173 - total27*whole
                total27_halves = halves(xp, total27)
                left = left - product_error(total27*whole, total27_halves, whole_halves)
                left = left + lost163 + mean_low2 - p_low*total27 - pulled_low
                lost163 = left/whole
                apart_of = lost3 + total28
                fall_of = creep_
                nyquist_of = lost162 + total172*(fall_low2 + lost283) + total162
                rise_of = lost163 + total27
                together_of = 2.0*lost553 + 2.0*total563
                return apart_of, fall_of, nyquist_of, rise_of, together_of

            apart_of, fall_of, nyquist_of, rise_of, together_of = (
                select(xp, reach < 0.5625, yes, (delta, gamma, half, lost2, root, size, total2,
                total3), no, (gamma, half, lost2, root, size, total2, total3))
            )

            return apart_of, fall_of, nyquist_of, rise_of, together_of

        def no(delta, gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )

            twice = 2.0*fall_
            total283 = fall_ + 1.0
            back3 = total283 - 1.0
            lost3 = fall_ - back3

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            fast = fall_*fall2
            total16 = mean2*twice
            twice_halves = halves(xp, twice)
            mean2_halves = halves(xp, mean2)
            lost16 = mean_low4*twice + product_error(total16, twice_halves, mean2_halves)
            total17 = mean - total16
            back3 = total17 - mean
            rest3 = total17 - back3
            one2 = mean - rest3
            two2 = -back3 - total16
            lost17 = one2 + two2
            total16 = fast*mean
            fast_halves = halves(xp, fast)
            mean_halves = halves(xp, mean)
            lost18 = fast*mean_low2 + product_error(total16, fast_halves, mean_halves)
            top = total17 + total16
            low = lost17 - lost16 + lost18 + mean_low2
            total16 = fall2*mean
            fall2_halves = halves(xp, fall2)
            lost18 = fall2*mean_low2 + product_error(total16, fall2_halves, mean_halves)
            pulled_low = fall_low4*mean + lost18
            total17 = mean2 - total16
            back3 = total17 - mean2
            rest3 = total17 - back3
            one2 = mean2 - rest3
            two2 = -back3 - total16
            lost18 = one2 + two2
            total16 = total17/whole
            left = total17 - total16*whole
            total16_halves = halves(xp, total16)
            left = left - product_error(total16*whole, total16_halves, whole_halves)
            left = left + lost18 + mean_low4 - p_low*total16 - pulled_low
            lost18 = left/whole
            total17 = fall_*total16
            fall__halves = halves(xp, fall_)
            lost18 = fall_*lost18 + product_error(total17, fall__halves, total16_halves)
            creep_ = fall_low2*total16 + lost18 + total17
            lost18 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
            low32 = fall2*fall_low2 + lost18
            total17 = fast + 1.0
            back3 = total17 - 1.0
            lost18 = fast - back3
            total16 = total283*total17
            total283_halves = halves(xp, total283)
            total17_halves = halves(xp, total17)
            lost18 = (
                total283*(lost18 + low32) + product_error(total16, total283_halves, total17_halves)
            )
            total283 = fall_*mean2
            lost17 = fall_*mean_low4 + product_error(total283, fall__halves, mean2_halves)
            pulled_low = fall_low2*mean2 + lost17
            total173 = mean - total283
            back3 = total173 - mean
            rest3 = total173 - back3
            one2 = mean - rest3
            two2 = -back3 - total283
            lost17 = one2 + two2
            total283 = total173/whole
            left = total173 - total283*whole
            total283_halves = halves(xp, total283)
            left = left - product_error(total283*whole, total283_halves, whole_halves)
            left = left + lost17 + mean_low2 - p_low*total283 - pulled_low
            lost17 = left/whole
            total173 = 1.0 - fast
            back3 = total173 - 1.0
            lost16 = -back3 - fast
            total533 = mean*total173
            total173_halves = halves(xp, total173)
            lost16 = mean*(lost16 - low32) + product_error(total533, mean_halves, total173_halves)
            moved_low = lost16 + mean_low2*total173
            total173 = total533/whole
            left = total533 - total173*whole
            total173_halves = halves(xp, total173)
            left = left - product_error(total173*whole, total173_halves, whole_halves)
            left = left + moved_low - p_low*total173
            lost16 = left/whole
            apart_of = (low + top)/whole3
            fall_of = creep_
            nyquist_of = lost18 + total17*(fall_low2 + lost3) + total16
            rise_of = lost17 + total283
            together_of = lost16 + total173
            return apart_of, fall_of, nyquist_of, rise_of, together_of

        apart_of, fall_of, nyquist_of, rise_of, together_of = (
            select(xp, reach < 1.0, yes, (delta, gamma, half, lost2, reach, root, size, total2,
            total3), no, (delta, gamma, half, lost2, root, size, total3))
        )

        return apart_of, fall_of, nyquist_of, rise_of, together_of

    apart_of, fall_of, nyquist_of, rise_of, together_of = (
        select(xp, total2 < 0.0, yes, (delta, gamma, half, lost, total2), no,
        (delta, gamma, half, lost, total2))
    )

    return apart_of, fall_of, nyquist_of, rise_of, together_of


def late_apart(xp, epsilon, x, x_low, y, y_low, first, last, turned):
    """m2 - m1 + m0, M at z = -1 behind a fraction of a period"""
    total = 1.0 - epsilon
    back = total - 1.0
    lost = -back - epsilon
    total2 = epsilon*total
    epsilon_halves = halves(xp, epsilon)
    total_halves = halves(xp, total)
    lost = epsilon*lost + product_error(total2, epsilon_halves, total_halves)
    total = x*y
    x_halves = halves(xp, x)
    y_halves = halves(xp, y)
    lost3 = x*y_low + product_error(total, x_halves, y_halves)
    both_low = lost3 + x_low*y
    total4 = total2*total
    total2_halves = halves(xp, total2)
    total_halves = halves(xp, total)
    lost3 = both_low*total2 + product_error(total4, total2_halves, total_halves)
    low = lost*total + lost3
    total = first - 2.0*total4
    back = total - first
    rest = total - back
    one = first - rest
    two = -back - 2.0*total4
    lost3 = one + two
    total4 = total - last
    back = total4 - total
    rest = total4 - back
    one = total - rest
    two = -back - last
    lost = one + two
    total = total4 + turned
    back = total - total4
    rest = total - back
    one = total4 - rest
    two = turned - back
    lost7 = one + two
    rest = lost3 + lost
    rest = lost7 + rest
    rest = rest - 2.0*low
    return rest + total


def late_part(xp, d):
    """the fraction of a period in a delay"""
    return d - xp.floor(d)


def cubic_root(xp, k0, k1, k2, k3, low, high, rise_):
    """the root of a cubic on a piece where it bends one way"""
    convex = xp.where(2.0*k2 + 3.0*k3*(high + low) > 0.0, xp.full_like(high, 1.0), -1.0)
    down = xp.where(convex*rise_ > 0.0, xp.full_like(convex, 1.0), -1.0)

    def over(y, moves, down, high, k0, k1, k2, k3, low):
        return moves == 0.0

    def step(y, moves, down, high, k0, k1, k2, k3, low):
        steep = k1 + y*(2.0*k2 + 3.0*k3*y)
        case1 = steep == 0.0
        some = xp.where(case1, 1.0, steep)
        move = xp.where(case1, 0.0, (k0 + y*(k1 + y*(k2 + k3*y)))/some)
        new = xp.where(high < y - move, high, y - move)
        new = xp.where(low > new, low, new)
        next_y = new
        next_moves = xp.where(down*(y - new) > 0.0, xp.full_like(down, 1.0), 0.0)
        return next_y, next_moves

    y, moves = repeat(xp, 100, over, step, (xp.where(down > 0.0, high, low), 1.0),
        (down, high, k0, k1, k2, k3, low))
    return y


def piece_turns(xp, k0, k1, k2, k3, low, high, at_low, at_high, zone, alpha, slope, far, n1, loss,
    together_, apart_, center, beyond, d):
    """what the crossing on a piece, if there is one, adds"""

    def yes(alpha, apart_, at_high, at_low, beyond, center, d, far, high, k0, k1, k2, k3, loss,
        low, n1, slope, together_, zone):
        x = cubic_root(xp, k0, k1, k2, k3, low, high, at_high - at_low)
        case1 = zone == 1.0
        case2 = zone == 0.0
        y = xp.where(case2, x, xp.where(case1, center + x, 4.0 - x))
        rest = xp.where(case2, 4.0 - x, xp.where(case1, beyond - x, x))

        def yes(alpha, apart_, at_high, at_low, beyond, center, d, far, loss, n1, rest, slope,
            together_, x, y, zone):
            off = xp.where(zone == 0.0, x - center, xp.where(zone == 1.0, x, beyond - x))
            at = xp.where(0.0 > y, 0.0, y)
            still = xp.where(0.0 > rest, 0.0, rest)
            sine = 2.0*square_root(xp, at*still)
            x2 = off*(2.0*loss - 4.0)
            y2 = loss*sine
            case1 = x2 < 0.0
            halves_ = xp.where(case1, xp.where(y2 < 0.0, xp.full_like(y2, -1.0), 1.0), 0.0)
            turned = xp.atan2(xp.where(case1, -y2, y2), xp.abs(x2))
            x2 = still*together_ - apart_*at
            y2 = n1*sine
            case2 = x2 < 0.0
            halves2 = xp.where(case2, xp.where(y2 < 0.0, xp.full_like(y2, -1.0), 1.0), 0.0)
            turned2 = xp.atan2(xp.where(case2, -y2, y2), xp.abs(x2))
            x2 = alpha*still - at*far
            y2 = sine*slope
            case3 = x2 < 0.0
            halves3 = xp.where(case3, xp.where(y2 < 0.0, xp.full_like(y2, -1.0), 1.0), 0.0)
            turned3 = xp.atan2(xp.where(case3, -y2, y2), xp.abs(x2))
            case4 = at > 2.0
            half = xp.atan2(xp.where(case4, square_root(xp, still), square_root(xp, at)),
                xp.where(case4, square_root(xp, at), square_root(xp, still)))
            late = d + 2.0
            halves3 = halves2 - halves_ + halves3 - xp.where(case4, late, 0.0)
            share = (
                0.5*(turned2 - late*xp.where(case4, -2.0*half, 2.0*half) - turned + turned3)/
                3.141592653589793
            )
            even = xp.floor(0.5*halves3)
            left = 0.5*halves3 - even
            turns = even + xp.where(left == 0.5, xp.floor(share) + 1.0,
                xp.floor(left + share + 0.5))
            rises = (
                xp.where(zone == 2.0, xp.full_like(zone, -1.0), 1.0)*
                xp.where(at_high > at_low, xp.full_like(at_high, 1.0), -1.0)
            )
            turned3 = -2.0*rises*turns
            return turned3

        def no(rest):
            return 0.0

        turned4 = select(xp, (rest > 0.0) & (y > 0.0), yes,
            (alpha, apart_, at_high, at_low, beyond, center, d, far, loss, n1, rest, slope,
            together_, x, y, zone), no, (rest,))

        return turned4

    def no(at_high):
        return 0.0

    return select(xp, (((at_high < 0.0) & (at_low >= 0.0)) | ((at_high >= 0.0) & (at_low < 0.0))) &
        (high > low), yes, (alpha, apart_, at_high, at_low, beyond, center, d, far, high, k0, k1,
        k2, k3, loss, low, n1, slope, together_, zone), no, (at_high,))


def zone_turns(xp, k0, k1, k2, k3, low, high, at_low, at_high, zone, alpha, slope, far, n1, loss,
    together_, apart_, center, beyond, d):
    """what the crossings between two points add to the count"""
    disc = (k2*k2) - 3.0*k1*k3
    some = xp.where(xp.abs(k2) < 24.0*xp.abs(k3), 3.0*k3, 1.0)
    at = -k2/some
    cut = xp.where((at < high) & (at > low) & (xp.abs(k2) < 24.0*xp.abs(k3)), at, low)

    def yes(low):
        one = low
        two = low
        return one, two

    def no(disc, high, k1, k2, k3, low):
        root = square_root(xp, xp.where(0.0 > disc, 0.0, disc))
        q = -k2 - xp.where(k2 < 0.0, -root, root)
        some2 = xp.where(xp.abs(q) < 24.0*xp.abs(k3), 3.0*k3, 1.0)
        at2 = q/some2
        cut2 = xp.where((at2 < high) & (at2 > low) & (xp.abs(q) < 24.0*xp.abs(k3)), at2, low)
        some2 = xp.where(xp.abs(k1) < 8.0*xp.abs(q), q, 1.0)
        at2 = k1/some2
        cut3 = xp.where((at2 < high) & (at2 > low) & (xp.abs(k1) < 8.0*xp.abs(q)), at2, low)
        one = cut2
        two = cut3
        return one, two

    one, two = select(xp, disc < 0.0, yes, (low,), no, (disc, high, k1, k2, k3, low))

    less = xp.where(one < two, one, two)
    more = xp.where(one > two, one, two)
    first = xp.where(cut < less, cut, less)
    middle = xp.where(cut > less, cut, less)
    last = xp.where(middle > more, middle, more)
    middle = xp.where(middle < more, middle, more)
    height = first*(first*(first*k3 + k2) + k1) + k0
    height2 = k0 + middle*(k1 + middle*(k2 + k3*middle))
    height3 = k0 + last*(k1 + last*(k2 + k3*last))
    found = piece_turns(xp, k0, k1, k2, k3, low, first, at_low, height, zone, alpha, slope, far,
        n1, loss, together_, apart_, center, beyond, d)
    found = found + piece_turns(xp, k0, k1, k2, k3, first, middle, height, height2, zone, alpha,
        slope, far, n1, loss, together_, apart_, center, beyond, d)
    found = found + piece_turns(xp, k0, k1, k2, k3, middle, last, height2, height3, zone, alpha,
        slope, far, n1, loss, together_, apart_, center, beyond, d)
    found = found + piece_turns(xp, k0, k1, k2, k3, last, high, height3, at_high, zone, alpha,
        slope, far, n1, loss, together_, apart_, center, beyond, d)
    return found


def late_roots(xp, alpha, beta, d, m2, m0, at_one, at_minus_one, loss, together_, apart_):
    """roots outside the unit circle, behind a fractional delay"""
    slope = alpha + beta
    wall_far = alpha + 2.0*beta
    force = beta*slope
    across = m2 - m0
    square = m0*m2
    even = together_*(m0 + m2)
    linear = (across*across) - even
    pushed_ = alpha*together_
    lost = (loss*loss)
    near0 = (at_one - pushed_)*(at_one + pushed_)
    near1 = lost - (alpha*alpha)*linear - at_one*(2.0 - loss) - force*(together_*together_)
    near2 = 1.0 - (alpha*alpha)*square - force*linear - loss
    near3 = -force*square
    square = m0*m2
    even = apart_*(m0 + m2)
    linear = (across*across) - even
    pushed_ = apart_*wall_far
    lost = (loss*loss)
    far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_)
    far1 = (apart_*apart_)*force - at_minus_one*(2.0 - loss) - linear*(wall_far*wall_far) + lost
    far2 = force*linear - loss - square*(wall_far*wall_far) + 1.0
    far3 = force*square
    middle = 2.0*at_one/(2.0 - loss)
    rest = 2.0*at_minus_one/(2.0 - loss)
    sine = 0.25*middle*rest
    tilt = 0.25*rest - 0.25*middle
    real = 0.25*rest*together_ - 0.25*apart_*middle
    size = (across*across)
    lost = (loss*loss)
    one = (real*real) + sine*size
    two = size*tilt - real*(m0 + m2)
    three = m0*m2
    wave = 0.25*alpha*rest - 0.25*middle*wall_far
    wall = sine*(slope*slope) + (wave*wave)
    own0 = lost*sine - one*wall
    own1 = lost*tilt - force*one - two*wall
    own2 = 1.0 - force*two - loss - three*wall
    own3 = -force*three
    one = 0.5*middle
    two = 0.5*rest
    before = own0 - one*(own1 - one*(own2 - one*own3))
    after = own0 + two*(own1 + two*(own2 + own3*two))
    side = xp.where(slope >= 0.0, xp.full_like(slope, 1.0), -1.0)
    end = (
        xp.where(wall_far > 0.0, side, 0.0) - d +
        xp.where(apart_ > 0.0, xp.where(across >= 0.0, xp.full_like(across, 1.0), -1.0), 0.0) -
        3.0
    )
    total = (
        xp.where(((((((near2 == 0.0) & (near3 < 0.0)) | (near2 < 0.0)) & (near1 == 0.0)) |
        (near1 < 0.0)) & (near0 == 0.0)) | (near0 < 0.0), xp.where(alpha > 0.0, 0.0, side),
        0.0) + zone_turns(xp, far0, far1, far2, far3, xp.full_like(across, 0.0), two, far0,
        after, xp.full_like(across, 2.0), alpha, slope, wall_far, across, loss, together_,
        apart_, middle, rest, d) + zone_turns(xp, near0, near1, near2, near3,
        xp.full_like(across, 0.0), one, near0, before, xp.full_like(across, 0.0), alpha, slope,
        wall_far, across, loss, together_, apart_, middle, rest, d) +
        zone_turns(xp, own0, own1, own2, own3, -one, two, before, after,
        xp.full_like(across, 1.0), alpha, slope, wall_far, across, loss, together_, apart_,
        middle, rest, d)
    )
    return total - xp.where(((((((far2 == 0.0) & (far3 < 0.0)) | (far2 < 0.0)) & (far1 == 0.0)) |
        (far1 < 0.0)) & (far0 == 0.0)) | (far0 < 0.0), end, 0.0)


def some_part(xp, d):
    """the same, or 1/2 where it is 0"""
    part = d - xp.floor(d)
    return xp.where(part == 0.0, 0.5, part)


def stable_single(xp, roots, alpha, beta, gamma, delta):
    """The same in single precision."""
    swing_ = square_root(xp, gamma)
    return xp.where((alpha > -gamma) & (roots == 0.0) &
        (~((alpha == 0.0) & (beta == 0.0) & (delta == 0.0))) &
        (~((delta < 5.960464477539062e-07) & (gamma > 1.0) &
        (swing_ >= 4194304.0*xp.abs(xp.sin(swing_))))), xp.full_like(alpha, 1.0), 0.0)


def stable(xp, roots, alpha, beta, gamma, delta):
    """1 where the loop is stable, else 0"""
    if roots.dtype == xp.float32:
        return stable_single(xp, roots, alpha, beta, gamma, delta)
    swing_ = square_root(xp, gamma)
    return xp.where((alpha > -gamma) & (roots == 0.0) &
        (~((alpha == 0.0) & (beta == 0.0) & (delta == 0.0))) &
        (~((delta < 1.1102230246251565e-15) & (gamma > 1.0) &
        (swing_ >= 2251799813685248.0*xp.abs(xp.sin(swing_))))), xp.full_like(alpha, 1.0), 0.0)


def whole_part(xp, d):
    """whole periods of a delay"""
    return xp.floor(d)


def whole_roots(xp, alpha, beta, d, n1, n0, at_one, at_minus_one, loss, together_, apart_):
    """roots outside the unit circle"""
    e = 1.0 - loss
    slope = alpha + beta
    wall_far = alpha + 2.0*beta
    force = beta*slope
    cross = n0*n1
    lost = (loss*loss)
    square = cross*force + e
    push = alpha*together_
    pull = apart_*wall_far
    near0 = (at_one - push)*(at_one + push)
    near1 = (alpha*alpha)*cross - at_one*(e + 1.0) - force*(together_*together_) + lost
    far0 = (at_minus_one - pull)*(at_minus_one + pull)
    far1 = (apart_*apart_)*force - at_minus_one*(e + 1.0) - cross*(wall_far*wall_far) + lost
    center = 2.0*at_one/(e + 1.0)
    beyond = 2.0*at_minus_one/(e + 1.0)
    sine = 0.25*beyond*center
    tilt = 0.25*beyond - 0.25*center
    real = 0.25*beyond*together_ - 0.25*apart_*center
    m0 = (n1*n1)*sine + (real*real)
    m1 = (n1*n1)*tilt - n1*real
    wave = 0.25*alpha*beyond - 0.25*center*wall_far
    wall = sine*(slope*slope) + (wave*wave)
    own0 = lost*sine - m0*wall
    own1 = lost*tilt - force*m0 - m1*wall
    own2 = e - force*m1
    square2 = (near1*near1)
    product = 4.0*near0*square
    size = square2 + xp.abs(product)
    square3 = (own1*own1)
    product2 = 4.0*own0*own2
    size2 = square3 + xp.abs(product2)
    square4 = (far1*far1)
    product3 = 4.0*far0*square
    size3 = square4 + xp.abs(product3)
    side = xp.where(slope >= 0.0, xp.full_like(slope, 1.0), -1.0)
    end = (
        xp.where(wall_far > 0.0, side, 0.0) - d +
        xp.where(apart_ > 0.0, xp.where(n1 >= 0.0, xp.full_like(n1, 1.0), -1.0), 0.0) - 3.0
    )

    def yes(product2, square3):
        disc2 = square3 - product2
        return disc2

    def no(product, product3, size, size2, size3, square2, square4):

        def yes(product3, square4):
            disc3 = square4 - product3
            return disc3

        def no(product, square2):
            disc = square2 - product
            return disc

        disc4 = select(xp, (size > size3) & (size2 > size3), yes, (product3, square4), no,
            (product, square2))

        return disc4

    disc4 = select(xp, (size >= size2) & (size2 <= size3), yes, (product2, square3), no,
        (product, product3, size, size2, size3, square2, square4))


    def yes(alpha, apart_, beyond, center, d, disc4, e, far0, far1, loss, n1, near0, near1, own0,
        own1, own2, slope, square, together_, wall_far):

        def yes(disc4, near0, near1, square):
            positive = disc4
            root = square_root(xp, positive)
            q = -0.5*near1 - 0.5*root

            def yes(square):
                return -1.0

            def no(q, square):
                lead_ = square
                one = q/lead_
                return one

            one = select(xp, square == 0.0, yes, (square,), no, (q, square))


            def yes(q):
                return -1.0

            def no(near0, q):
                own = q
                two = near0/own
                return two

            two = select(xp, q == 0.0, yes, (q,), no, (near0, q))

            low = one
            high = two
            return low, high

        def no(disc4, near0, near1, square):
            positive = disc4
            root = square_root(xp, positive)
            q = 0.5*root - 0.5*near1

            def yes(square):
                return -1.0

            def no(q, square):
                lead_ = square
                one = q/lead_
                return one

            one = select(xp, square == 0.0, yes, (square,), no, (q, square))


            def yes(q):
                return -1.0

            def no(near0, q):
                own = q
                two = near0/own
                return two

            two = select(xp, q == 0.0, yes, (q,), no, (near0, q))

            low = two
            high = one
            return low, high

        low, high = select(xp, near1 >= 0.0, yes, (disc4, near0, near1, square), no,
            (disc4, near0, near1, square))


        def yes(disc4, far0, far1, square):
            positive = disc4
            root = square_root(xp, positive)
            q3 = -0.5*far1 - 0.5*root

            def yes(square):
                return -1.0

            def no(q3, square):
                lead3 = square
                one3 = q3/lead3
                return one3

            one3 = select(xp, square == 0.0, yes, (square,), no, (q3, square))


            def yes(q3):
                return -1.0

            def no(far0, q3):
                own4 = q3
                two3 = far0/own4
                return two3

            two3 = select(xp, q3 == 0.0, yes, (q3,), no, (far0, q3))

            low3 = one3
            high3 = two3
            return low3, high3

        def no(disc4, far0, far1, square):
            positive = disc4
            root = square_root(xp, positive)
            q3 = 0.5*root - 0.5*far1

            def yes(square):
                return -1.0

            def no(q3, square):
                lead3 = square
                one3 = q3/lead3
                return one3

            one3 = select(xp, square == 0.0, yes, (square,), no, (q3, square))


            def yes(q3):
                return -1.0

            def no(far0, q3):
                own4 = q3
                two3 = far0/own4
                return two3

            two3 = select(xp, q3 == 0.0, yes, (q3,), no, (far0, q3))

            low3 = two3
            high3 = one3
            return low3, high3

        low3, high3 = select(xp, far1 >= 0.0, yes, (disc4, far0, far1, square), no,
            (disc4, far0, far1, square))

        edge = xp.where(high3 > low, low, high3)
        edge2 = xp.where(high < low3, high, low3)

        def yes(alpha, apart_, beyond, center, d, disc4, e, edge, high3, loss, low, n1, own0, own1,
            own2, slope, together_, wall_far):
            late = d + 2.0

            def yes(disc4, own1, own2):

                def yes(own2):
                    return -1.0

                def no(disc4, own1, own2):
                    positive = disc4
                    root = square_root(xp, positive)
                    q2 = -0.5*own1 - 0.5*root
                    lead2 = own2
                    one2 = q2/lead2
                    return one2

                one2 = select(xp, own2 == 0.0, yes, (own2,), no, (disc4, own1, own2))

                low2 = one2
                return low2

            def no(disc4, own0, own1):
                positive = disc4
                root = square_root(xp, positive)
                q2 = 0.5*root - 0.5*own1

                def yes(q2):
                    return -1.0

                def no(own0, q2):
                    own3 = q2
                    two2 = own0/own3
                    return two2

                two2 = select(xp, q2 == 0.0, yes, (q2,), no, (own0, q2))

                low2 = two2
                return low2

            low2 = select(xp, own1 >= 0.0, yes, (disc4, own1, own2), no, (disc4, own0, own1))

            case1 = high3 > low
            case2 = (beyond - low2 > 0.0) & (center + low2 > 0.0) & (edge > xp.abs(low2))
            at = xp.where(case2, center + low2, xp.where(case1, low, 4.0 - high3))
            still = xp.where(case2, beyond - low2, xp.where(case1, 4.0 - low, high3))
            away = xp.where(case2, low2, xp.where(case1, low - center, beyond - high3))
            at = xp.where(0.0 > at, 0.0, at)
            still = xp.where(0.0 > still, 0.0, still)
            sine2 = 2.0*square_root(xp, at*still)
            x = away*(-2.0*e - 2.0)
            y = loss*sine2
            case3 = x < 0.0
            halves_ = xp.where(case3, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
            turned = xp.atan2(xp.where(case3, -y, y), xp.abs(x))
            x = still*together_ - apart_*at
            y = n1*sine2
            case4 = x < 0.0
            halves2 = xp.where(case4, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
            turned2 = xp.atan2(xp.where(case4, -y, y), xp.abs(x))
            x = alpha*still - at*wall_far
            y = sine2*slope
            case5 = x < 0.0
            halves3 = xp.where(case5, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
            turned3 = xp.atan2(xp.where(case5, -y, y), xp.abs(x))
            case6 = at > 2.0
            half = xp.atan2(xp.where(case6, square_root(xp, still), square_root(xp, at)),
                xp.where(case6, square_root(xp, at), square_root(xp, still)))
            halves3 = halves2 - halves_ + halves3 - xp.where(case6, late, 0.0)
            share = (
                0.5*(turned2 - late*xp.where(case6, -2.0*half, 2.0*half) - turned + turned3)/
                3.141592653589793
            )
            even = xp.floor(0.5*halves3)
            left = 0.5*halves3 - even
            turns = even + xp.where(left == 0.5, xp.floor(share) + 1.0,
                xp.floor(left + share + 0.5))
            found = 2.0*turns
            return found

        def no(edge):
            return 0.0

        found = select(xp, (edge < 4.0) & (high3 > 0.0) & (low > 0.0), yes,
            (alpha, apart_, beyond, center, d, disc4, e, edge, high3, loss, low, n1, own0, own1,
            own2, slope, together_, wall_far), no, (edge,))

        total = found

        def yes(alpha, apart_, beyond, center, d, disc4, e, edge2, high, loss, low3, n1, own0,
            own1, own2, slope, together_, wall_far):
            late2 = d + 2.0

            def yes(disc4, own0, own1):
                positive = disc4
                root = square_root(xp, positive)
                q2 = -0.5*own1 - 0.5*root

                def yes(q2):
                    return -1.0

                def no(own0, q2):
                    own3 = q2
                    two2 = own0/own3
                    return two2

                two2 = select(xp, q2 == 0.0, yes, (q2,), no, (own0, q2))

                high2 = two2
                return high2

            def no(disc4, own1, own2):

                def yes(own2):
                    return -1.0

                def no(disc4, own1, own2):
                    positive = disc4
                    root = square_root(xp, positive)
                    q2 = 0.5*root - 0.5*own1
                    lead2 = own2
                    one2 = q2/lead2
                    return one2

                one2 = select(xp, own2 == 0.0, yes, (own2,), no, (disc4, own1, own2))

                high2 = one2
                return high2

            high2 = select(xp, own1 >= 0.0, yes, (disc4, own0, own1), no, (disc4, own1, own2))

            case1 = high < low3
            case2 = (beyond - high2 > 0.0) & (center + high2 > 0.0) & (edge2 > xp.abs(high2))
            at4 = xp.where(case2, center + high2, xp.where(case1, high, 4.0 - low3))
            still4 = xp.where(case2, beyond - high2, xp.where(case1, 4.0 - high, low3))
            away2 = xp.where(case2, high2, xp.where(case1, high - center, beyond - low3))
            at4 = xp.where(0.0 > at4, 0.0, at4)
            still4 = xp.where(0.0 > still4, 0.0, still4)
            sine3 = 2.0*square_root(xp, at4*still4)
            x4 = away2*(-2.0*e - 2.0)
            y4 = loss*sine3
            case3 = x4 < 0.0
            halves5 = xp.where(case3, xp.where(y4 < 0.0, xp.full_like(y4, -1.0), 1.0), 0.0)
            turned4 = xp.atan2(xp.where(case3, -y4, y4), xp.abs(x4))
            x4 = still4*together_ - apart_*at4
            y4 = n1*sine3
            case4 = x4 < 0.0
            halves6 = xp.where(case4, xp.where(y4 < 0.0, xp.full_like(y4, -1.0), 1.0), 0.0)
            turned5 = xp.atan2(xp.where(case4, -y4, y4), xp.abs(x4))
            x4 = alpha*still4 - at4*wall_far
            y4 = sine3*slope
            case5 = x4 < 0.0
            halves7 = xp.where(case5, xp.where(y4 < 0.0, xp.full_like(y4, -1.0), 1.0), 0.0)
            turned6 = xp.atan2(xp.where(case5, -y4, y4), xp.abs(x4))
            case6 = at4 > 2.0
            half2 = xp.atan2(xp.where(case6, square_root(xp, still4), square_root(xp, at4)),
                xp.where(case6, square_root(xp, at4), square_root(xp, still4)))
            halves7 = halves6 - halves5 + halves7 - xp.where(case6, late2, 0.0)
            share2 = 0.5*(turned5 - late2*xp.where(case6, -2.0*half2, 2.0*half2) - turned4 +
                turned6)/3.141592653589793
            even2 = xp.floor(0.5*halves7)
            left2 = 0.5*halves7 - even2
            turns2 = even2 + xp.where(left2 == 0.5, xp.floor(share2) + 1.0,
                xp.floor(left2 + share2 + 0.5))
            found2 = -2.0*turns2
            return found2

        def no(edge2):
            return 0.0

        found2 = select(xp, (edge2 < 4.0) & (high > 0.0) & (low3 > 0.0), yes,
            (alpha, apart_, beyond, center, d, disc4, e, edge2, high, loss, low3, n1, own0, own1,
            own2, slope, together_, wall_far), no, (edge2,))

        total = found2 + total
        return total

    def no(disc4):
        return 0.0

    total3 = select(xp, disc4 >= 0.0, yes,
        (alpha, apart_, beyond, center, d, disc4, e, far0, far1, loss, n1, near0, near1, own0,
        own1, own2, slope, square, together_, wall_far), no, (disc4,))

    total4 = total3 + xp.where(((((near1 == 0.0) & (square < 0.0)) | (near1 < 0.0)) &
        (near0 == 0.0)) | (near0 < 0.0), xp.where(alpha > 0.0, 0.0, side), 0.0)
    return total4 - xp.where(((((far1 == 0.0) & (square < 0.0)) | (far1 < 0.0)) & (far0 == 0.0)) |
        (far0 < 0.0), end, 0.0)


def ahead_in_phase(xp, psi, at_one, at_minus_one, loss, together_, apart_, across):
    """the imaginary part of A/(z M) at z = exp(2 j psi); the real part of A/(z M) at z = exp(2
    j psi)
    """
    t = xp.tan(psi)
    square = (t*t)
    t_halves = halves(xp, t)
    low = product_error(square, t_halves, t_halves)
    taken = at_minus_one*square
    total = at_one - taken
    back = total - at_one
    rest = total - back
    one = at_one - rest
    two = -back - taken
    lost = one + two
    at_minus_one_halves = halves(xp, at_minus_one)
    square_halves = halves(xp, square)
    missed = at_minus_one*low + product_error(taken, at_minus_one_halves, square_halves)
    lost = lost - missed
    total2 = lost + total
    back = total2 - total
    lost = lost - back
    taken = apart_*square
    total = together_ - taken
    back = total - together_
    rest = total - back
    one = together_ - rest
    two = -back - taken
    lost4 = one + two
    apart__halves = halves(xp, apart_)
    missed = apart_*low + product_error(taken, apart__halves, square_halves)
    lost4 = lost4 - missed
    total4 = lost4 + total
    back = total4 - total
    lost4 = lost4 - back
    above_j = 2.0*loss*t
    below_j = across*t
    rest = (below_j*below_j) + 2.0*lost4*total4
    size = rest + (total4*total4)
    low = above_j*lost4 - below_j*lost
    found = above_j*total4 - below_j*total2
    found = found + low
    ahead_of = found/size
    low = lost*total4 + lost4*total2
    rest = above_j*below_j + low
    found = rest + total2*total4
    in_phase_of = found/size
    return ahead_of, in_phase_of


def apart_nyquist_together_single(xp, gamma, delta):
    """The same in single precision."""
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, half, lost2, total2):
            square2 = total2
            envelope = xp.exp(-half)
            rest5 = apart_series(xp, half, total2)
            total27 = rest5 + 0.16666666666666666
            back17 = total27 - rest5
            rest6 = total27 - back17
            one4 = rest5 - rest6
            two4 = 0.16666666666666666 - back17
            lost27 = one4 + two4
            total28 = envelope*total27
            envelope_halves = halves(xp, envelope)
            total27_halves = halves(xp, total27)
            lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
            twice2 = 2.0*envelope
            rest6 = together_series(xp, half, total2)
            total27 = rest6 + 0.5
            back17 = total27 - rest6
            rest5 = total27 - back17
            one4 = rest6 - rest5
            two4 = 0.5 - back17
            lost55 = one4 + two4
            total56 = envelope*total27
            total27_halves = halves(xp, total27)
            lost55 = envelope*lost55 + product_error(total56, envelope_halves, total27_halves)

            def yes(square2):
                given3 = square2
                total19 = 0.5*given3 + 1.0
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total19 = curved3 + total19
                even = total19
                return even

            def no(total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                cosine = xp.cos(root)
                even = cosine
                return even

            even = select(xp, square2 > -1.5, yes, (square2,), no, (total2,))

            total27 = even*twice2

            def yes(delta, even, lost2, lost28, lost56, square2, total2, total262, total28,
                total56, twice2):
                e = xp.exp(-delta)
                total252 = e + 1.0
                back18 = total252 - 1.0
                lost252 = e - back18
                total272 = total252 + total262
                back18 = total272 - total252
                lost272 = total262 - back18

                def yes(lost2, square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    back13 = total19 - 1.0
                    lost19 = 0.5*given3 - back13
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total20 = curved3 + total19
                    back13 = total20 - total19
                    lost20 = curved3 - back13
                    even_low = lost19 + 0.5*lost2 + lost20
                    return even_low

                def no(lost2, total2):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    even_low2 = -root_low*sine
                    return even_low2

                even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no, (lost2, total2))

                twice2_halves = halves(xp, twice2)
                even_halves = halves(xp, even)
                lost262 = even_low2*twice2 + product_error(twice2*even, twice2_halves, even_halves)
                apart_of = lost28 + total28
                nyquist_of = lost252 + lost262 + lost272 + total272
                together_of = 2.0*lost56 + 2.0*total56
                return apart_of, nyquist_of, together_of

            def no(envelope, half, lost2, lost28, lost56, total2, total28, total56):
                size = xp.abs(total2)
                root = square_root(xp, size)
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                expm1_of = xp.expm1(-half)
                grown = -0.5*expm1_of
                angle = 0.5*root
                wave = xp.cos(angle)
                sin_of = xp.sin(angle)
                back72 = 0.5*root_low*sin_of
                total92 = wave - back72
                back82 = total92 - wave
                rest32 = total92 - back82
                one22 = wave - rest32
                two22 = -back72 - back82
                lost92 = one22 + two22
                total102 = (total92*total92)
                total92_halves = halves(xp, total92)
                lost102 = product_error(total102, total92_halves, total92_halves)
                low2 = lost102 + 2.0*lost92*total92
                total92 = envelope*total102
                envelope_halves = halves(xp, envelope)
                total102_halves = halves(xp, total102)
                lost92 = envelope*low2 + product_error(total92, envelope_halves, total102_halves)
                total102 = (grown*grown) + total92
                back82 = total102 - total92
                rest32 = total102 - back82
                one22 = total92 - rest32
                two22 = (grown*grown) - back82
                lost102 = one22 + two22
                low2 = lost92 + lost102
                apart_of = lost28 + total28
                nyquist_of = 4.0*low2 + 4.0*total102
                together_of = 2.0*lost56 + 2.0*total56
                return apart_of, nyquist_of, together_of

            apart_of, nyquist_of, together_of = (
                select(xp, total27 > 0.0, yes, (delta, even, lost2, lost27, lost55, square2,
                total2, total27, total28, total56, twice2), no,
                (envelope, half, lost2, lost27, lost55, total2, total28, total56))
            )

            return apart_of, nyquist_of, together_of

        def no(delta, gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma
            mean3 = decay(xp, delta)
            twice2 = 2.0*envelope

            def yes(lost2, square2):
                given3 = square2
                total19 = 0.5*given3 + 1.0
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total19 = curved3 + total19
                sin_series_of = sin_series(xp, given3)
                bent = given3*sin_series_of
                total21 = bent + 1.0
                back15 = total21 - 1.0
                lost21 = bent - back15
                odd_low = 0.16666666666666666*lost2 + lost21
                even = total19
                odd = total21
                return even, odd, odd_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                some = root
                total22 = sine/some
                left = sine - some*total22
                total22_halves = halves(xp, total22)
                some_halves = halves(xp, some)
                left = left - product_error(total22*some, total22_halves, some_halves)
                left = cosine*root_low + left - root_low*total22
                lost22 = left/some
                even = cosine
                odd = total22
                odd_low2 = lost22
                return even, odd, odd_low2

            even, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total24 = envelope*odd
            envelope_halves = halves(xp, envelope)
            odd_halves = halves(xp, odd)
            lost24 = envelope*odd_low2 + product_error(total24, envelope_halves, odd_halves)
            total25 = mean3 - total24
            back16 = total25 - mean3
            rest4 = total25 - back16
            one3 = mean3 - rest4
            two3 = -back16 - total24
            lost25 = one3 + two3
            total24 = total25/stiff
            left13 = total25 - stiff*total24
            total24_halves = halves(xp, total24)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total24*stiff, total24_halves, stiff_halves)
            left13 = left13 - lost24 + lost25
            lost25 = left13/stiff
            total25 = even*twice2

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 4096.0, yes, (root,), no, (root,))

            turns = (count*count)
            total142 = 39.478416442871094*turns
            turns_halves = halves(xp, turns)
            number5_halves = halves(xp, xp.full_like(turns, 39.478416442871094))
            lost24 = product_error(total142, turns_halves, number5_halves)
            total152 = 1.1614863524300745e-06*turns
            number6_halves = halves(xp, xp.full_like(turns, 1.1614863524300745e-06))
            lost152 = product_error(total152, turns_halves, number6_halves)
            total162 = -total142 - total2
            back16 = total162 + total2
            rest4 = total162 - back16
            one3 = -rest4 - total2
            two3 = -back16 - total142
            lost162 = one3 + two3
            total142 = total162 - lost24
            back16 = total142 - total162
            rest4 = total142 - back16
            one3 = total162 - rest4
            two3 = -back16 - lost24
            lost24 = one3 + two3
            total162 = total142 - total152
            back16 = total162 - total142
            rest4 = total162 - back16
            one3 = total142 - rest4
            two3 = -back16 - total152
            lost182 = one3 + two3
            total152 = total162 - lost2
            back16 = total152 - total162
            rest4 = total152 - back16
            one3 = total162 - rest4
            two3 = -back16 - lost2
            lost192 = one3 + two3
            low32 = lost162 - lost152 + lost24 + lost182 + lost192 + 1.1704736640094811e-14*turns
            total162 = low32 + total152
            total142 = 6.2831854820251465*count
            total222 = root + total142
            whole32 = xp.where(total222 == 0.0, 1.0, total222)
            total232 = total162/whole32
            far = (total232*total232)

            def yes(count, delta, envelope, even, far, half, lost2, lost26, low32, root, size,
                square2, stiff, total192, total202, total212, total222, total232, total26,
                total262, twice2, whole32):

                def yes(count, delta, even, half, lost2, lost26, low32, root, size, square2, stiff,
                    total192, total202, total212, total222, total232, total26, total262, twice2,
                    whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    e = xp.exp(-delta)
                    total252 = e + 1.0
                    back18 = total252 - 1.0
                    lost252 = e - back18
                    total272 = total252 + total262
                    back18 = total272 - total252
                    lost272 = total262 - back18
                    back18 = total202 - total192
                    rest9 = total202 - back18
                    one8 = total192 - rest9
                    two8 = low32 - back18
                    lost202 = one8 + two8
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                    lost212 = product_error(count*6.2831854820251465, count_halves, number2_halves)
                    back18 = total222 - root
                    rest9 = total222 - back18
                    one8 = root - rest9
                    two8 = total212 - back18
                    lost222 = one8 + two8
                    both_low = lost212 - 1.7484555314695172e-07*count + lost222 + root_low
                    left = total202 - total232*whole32
                    total232_halves = halves(xp, total232)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total232*whole32, total232_halves, whole32_halves)
                    left = left - both_low*total232 + lost202
                    lost202 = left/whole32
                    eta = total232
                    eta_low = lost202
                    total252 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost202 = 2.0*eta*eta_low + product_error(total252, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total252)
                    bent2 = cos_series_of2*(total252*total252)
                    total253 = 0.5*total252 - bent2
                    back18 = total253 - 0.5*total252
                    lost222 = -back18 - bent2
                    sin_series_of2 = sin_series(xp, -total252)
                    total252 = 1.0 - sin_series_of2*total252
                    lift_low = 0.5*lost202*total252 + lost222
                    given22 = half
                    total252 = 1.0 - 0.5*given22
                    back18 = total252 - 1.0
                    lost222 = -back18 - 0.5*given22
                    decay_series_of3 = decay_series(xp, given22)
                    curved22 = decay_series_of3*(given22*given22)
                    total302 = curved22 + total252
                    back18 = total302 - total252
                    lost202 = curved22 - back18
                    mean_low5 = lost222 + lost202
                    total252 = given22*total302
                    given22_halves = halves(xp, given22)
                    total302_halves = halves(xp, total302)
                    lost202 = given22*mean_low5 + product_error(total252, given22_halves,
                        total302_halves)
                    total302 = 1.0 - total252
                    back18 = total302 - 1.0
                    lost222 = -back18 - total252
                    fall_low5 = lost222 - lost202
                    total252 = 1.0 - total302
                    back18 = total252 - 1.0
                    lost222 = -back18 - total302
                    low42 = lost222 - fall_low5
                    total34 = low42 + total252
                    back18 = total34 - total252
                    lost222 = low42 - back18
                    total252 = (total34*total34)
                    total34_halves = halves(xp, total34)
                    lost222 = 2.0*lost222*total34 + product_error(total252, total34_halves,
                        total34_halves)
                    total34 = total253*total302
                    total302_halves = halves(xp, total302)
                    total253_halves = halves(xp, total253)
                    lost202 = lift_low*total302 + product_error(total34, total302_halves,
                        total253_halves)
                    total302 = total252 + 2.0*total34
                    back18 = total302 - total252
                    rest9 = total302 - back18
                    one8 = total252 - rest9
                    two8 = 2.0*total34 - back18
                    lost212 = one8 + two8
                    low42 = 2.0*fall_low5*total253 + lost222 + 2.0*lost202 + lost212
                    total253 = total302/stiff
                    left = total302 - stiff*total253
                    total253_halves = halves(xp, total253)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total253*stiff, total253_halves, stiff_halves)
                    left = left + low42
                    lost212 = left/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost202 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost26 + total26
                    nyquist_of = lost252 + lost202 + lost272 + total272
                    together_of = lost212 + total253
                    return apart_of, nyquist_of, together_of

                def no(delta, envelope, even, half, lost2, lost26, root, size, square2, stiff,
                    total26, total262, twice2):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    e = xp.exp(-delta)
                    total252 = e + 1.0
                    back18 = total252 - 1.0
                    lost252 = e - back18
                    total272 = total252 + total262
                    back18 = total272 - total252
                    lost272 = total262 - back18
                    back18 = -0.5*root_low*wave
                    total252 = sin_of - back18
                    back83 = total252 - sin_of
                    rest33 = total252 - back83
                    one23 = sin_of - rest33
                    two23 = -back18 - back83
                    lost93 = one23 + two23
                    total103 = (total252*total252)
                    total252_halves = halves(xp, total252)
                    lost103 = product_error(total103, total252_halves, total252_halves)
                    low4 = lost103 + 2.0*lost93*total252
                    total252 = envelope*total103
                    envelope_halves = halves(xp, envelope)
                    total103_halves = halves(xp, total103)
                    lost93 = envelope*low4 + product_error(total252, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total252
                    back83 = total103 - total252
                    rest33 = total103 - back83
                    one23 = total252 - rest33
                    two23 = (grown*grown) - back83
                    lost103 = one23 + two23
                    low4 = lost93 + lost103
                    total252 = total103/stiff
                    left = total103 - stiff*total252
                    total252_halves = halves(xp, total252)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total252*stiff, total252_halves, stiff_halves)
                    left = left + low4
                    lost103 = left/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost93 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost26 + total26
                    nyquist_of = lost252 + lost93 + lost272 + total272
                    together_of = 4.0*lost103 + 4.0*total252
                    return apart_of, nyquist_of, together_of

                apart_of, nyquist_of, together_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, delta, even, half, lost2, lost26, low32, root, size, square2,
                    stiff, total192, total202, total212, total222, total232, total26, total262,
                    twice2, whole32), no, (delta, envelope, even, half, lost2, lost26, root,
                    size, square2, stiff, total26, total262, twice2))
                )

                return apart_of, nyquist_of, together_of

            def no(count, envelope, far, half, lost2, lost26, low32, root, size, stiff, total192,
                total202, total212, total222, total232, total26, whole32):

                def yes(count, envelope, half, lost2, lost26, low32, root, size, stiff, total192,
                    total202, total212, total222, total232, total26, whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back72 = 0.5*root_low*sin_of
                    total92 = wave - back72
                    back82 = total92 - wave
                    rest32 = total92 - back82
                    one22 = wave - rest32
                    two22 = -back72 - back82
                    lost92 = one22 + two22
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low2 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low2 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest32 = total102 - back82
                    one22 = total92 - rest32
                    two22 = (grown*grown) - back82
                    lost102 = one22 + two22
                    low2 = lost92 + lost102
                    back82 = total202 - total192
                    rest32 = total202 - back82
                    one22 = total192 - rest32
                    two22 = low32 - back82
                    lost102 = one22 + two22
                    count_halves = halves(xp, count)
                    number5_halves = halves(xp, xp.full_like(count, 6.2831854820251465))
                    lost92 = product_error(count*6.2831854820251465, count_halves, number5_halves)
                    back82 = total222 - root
                    rest32 = total222 - back82
                    one22 = root - rest32
                    two22 = total212 - back82
                    lost222 = one22 + two22
                    both_low = lost92 - 1.7484555314695172e-07*count + lost222 + root_low
                    left = total202 - total232*whole32
                    total232_halves = halves(xp, total232)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total232*whole32, total232_halves, whole32_halves)
                    left = left - both_low*total232 + lost102
                    lost102 = left/whole32
                    eta = total232
                    eta_low = lost102
                    total92 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost102 = 2.0*eta*eta_low + product_error(total92, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total92)
                    bent2 = cos_series_of2*(total92*total92)
                    total253 = 0.5*total92 - bent2
                    back82 = total253 - 0.5*total92
                    lost222 = -back82 - bent2
                    sin_series_of2 = sin_series(xp, -total92)
                    total92 = 1.0 - sin_series_of2*total92
                    lift_low = 0.5*lost102*total92 + lost222
                    given22 = half
                    total92 = 1.0 - 0.5*given22
                    back82 = total92 - 1.0
                    lost222 = -back82 - 0.5*given22
                    decay_series_of3 = decay_series(xp, given22)
                    curved22 = decay_series_of3*(given22*given22)
                    total302 = curved22 + total92
                    back82 = total302 - total92
                    lost102 = curved22 - back82
                    mean_low5 = lost222 + lost102
                    total92 = given22*total302
                    given22_halves = halves(xp, given22)
                    total302_halves = halves(xp, total302)
                    lost102 = given22*mean_low5 + product_error(total92, given22_halves,
                        total302_halves)
                    total302 = 1.0 - total92
                    back82 = total302 - 1.0
                    lost222 = -back82 - total92
                    fall_low5 = lost222 - lost102
                    total92 = 1.0 - total302
                    back82 = total92 - 1.0
                    lost222 = -back82 - total302
                    low42 = lost222 - fall_low5
                    total34 = low42 + total92
                    back82 = total34 - total92
                    lost222 = low42 - back82
                    total92 = (total34*total34)
                    total34_halves = halves(xp, total34)
                    lost222 = 2.0*lost222*total34 + product_error(total92, total34_halves,
                        total34_halves)
                    total34 = total253*total302
                    total302_halves = halves(xp, total302)
                    total253_halves = halves(xp, total253)
                    lost102 = lift_low*total302 + product_error(total34, total302_halves,
                        total253_halves)
                    total302 = total92 + 2.0*total34
                    back82 = total302 - total92
                    rest32 = total302 - back82
                    one22 = total92 - rest32
                    two22 = 2.0*total34 - back82
                    lost92 = one22 + two22
                    low42 = 2.0*fall_low5*total253 + lost222 + 2.0*lost102 + lost92
                    total253 = total302/stiff
                    left = total302 - stiff*total253
                    total253_halves = halves(xp, total253)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total253*stiff, total253_halves, stiff_halves)
                    left = left + low42
                    lost92 = left/stiff
                    apart_of = lost26 + total26
                    nyquist_of = 4.0*low2 + 4.0*total102
                    together_of = lost92 + total253
                    return apart_of, nyquist_of, together_of

                def no(envelope, half, lost2, lost26, root, size, stiff, total26):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back72 = 0.5*root_low*sin_of
                    total92 = wave - back72
                    back82 = total92 - wave
                    rest32 = total92 - back82
                    one22 = wave - rest32
                    two22 = -back72 - back82
                    lost92 = one22 + two22
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low2 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low2 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest32 = total102 - back82
                    one22 = total92 - rest32
                    two22 = (grown*grown) - back82
                    lost102 = one22 + two22
                    low2 = lost92 + lost102
                    back82 = -0.5*root_low*wave
                    total92 = sin_of - back82
                    back72 = total92 - sin_of
                    rest32 = total92 - back72
                    one22 = sin_of - rest32
                    two22 = -back82 - back72
                    lost102 = one22 + two22
                    total103 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost92 = product_error(total103, total92_halves, total92_halves)
                    low4 = lost92 + 2.0*lost102*total92
                    total92 = envelope*total103
                    total103_halves = halves(xp, total103)
                    lost102 = envelope*low4 + product_error(total92, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total92
                    back72 = total103 - total92
                    rest32 = total103 - back72
                    one22 = total92 - rest32
                    two22 = (grown*grown) - back72
                    lost92 = one22 + two22
                    low4 = lost102 + lost92
                    total92 = total103/stiff
                    left = total103 - stiff*total92
                    total92_halves = halves(xp, total92)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total92*stiff, total92_halves, stiff_halves)
                    left = left + low4
                    lost92 = left/stiff
                    apart_of = lost26 + total26
                    nyquist_of = 4.0*low2 + 4.0*total102
                    together_of = 4.0*lost92 + 4.0*total92
                    return apart_of, nyquist_of, together_of

                apart_of, nyquist_of, together_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, envelope, half, lost2, lost26, low32, root, size, stiff, total192,
                    total202, total212, total222, total232, total26, whole32), no,
                    (envelope, half, lost2, lost26, root, size, stiff, total26))
                )

                return apart_of, nyquist_of, together_of

            apart_of, nyquist_of, together_of = (
                select(xp, total25 > 0.0, yes, (count, delta, envelope, even, far, half, lost2,
                lost25, low32, root, size, square2, stiff, total152, total162, total142,
                total222, total232, total24, total25, twice2, whole32), no,
                (count, envelope, far, half, lost2, lost25, low32, root, size, stiff, total152,
                total162, total142, total222, total232, total24, whole32))
            )

            return apart_of, nyquist_of, together_of

        apart_of, nyquist_of, together_of = select(xp, reach < 1.0, yes,
            (delta, half, lost2, total2), no, (delta, gamma, half, lost2, total2))

        return apart_of, nyquist_of, together_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(gamma, half, lost2, root, size, total2, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            envelope = xp.exp(-half)
            rest5 = apart_series(xp, half, total2)
            total27 = rest5 + 0.16666666666666666
            back3 = total27 - rest5
            rest6 = total27 - back3
            one4 = rest5 - rest6
            two4 = 0.16666666666666666 - back3
            lost3 = one4 + two4
            total28 = envelope*total27
            envelope_halves = halves(xp, envelope)
            total27_halves = halves(xp, total27)
            lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
            rest6 = together_series(xp, half, total2)
            total27 = rest6 + 0.5
            back3 = total27 - rest6
            rest5 = total27 - back3
            one4 = rest6 - rest5
            two4 = 0.5 - back3
            lost55 = one4 + two4
            total56 = envelope*total27
            total27_halves = halves(xp, total27)
            lost55 = envelope*lost55 + product_error(total56, envelope_halves, total27_halves)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                return fall_, fall_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                fall_ = sunk
                fall_low2 = sunk_low
                return fall_, fall_low2

            fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))

            total27 = fall_ + 1.0
            back3 = total27 - 1.0
            lost282 = fall_ - back3

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            fast = fall_*fall2
            fall__halves = halves(xp, fall_)
            fall2_halves = halves(xp, fall2)
            lost29 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
            low3 = fall2*fall_low2 + lost29
            total30 = fast + 1.0
            back3 = total30 - 1.0
            lost29 = fast - back3
            total31 = total27*total30
            total27_halves = halves(xp, total27)
            total30_halves = halves(xp, total30)
            lost29 = total27*(lost29 + low3) + product_error(total31, total27_halves,
                total30_halves)
            apart_of = lost3 + total28
            nyquist_of = lost29 + total30*(fall_low2 + lost282) + total31
            together_of = 2.0*lost55 + 2.0*total56
            return apart_of, nyquist_of, together_of

        def no(delta, gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )

            twice = 2.0*fall_
            total282 = fall_ + 1.0
            back3 = total282 - 1.0
            lost3 = fall_ - back3

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            fast = fall_*fall2
            total16 = mean2*twice
            twice_halves = halves(xp, twice)
            mean2_halves = halves(xp, mean2)
            lost16 = mean_low4*twice + product_error(total16, twice_halves, mean2_halves)
            total17 = mean - total16
            back3 = total17 - mean
            rest3 = total17 - back3
            one2 = mean - rest3
            two2 = -back3 - total16
            lost17 = one2 + two2
            total16 = fast*mean
            fast_halves = halves(xp, fast)
            mean_halves = halves(xp, mean)
            lost18 = fast*mean_low2 + product_error(total16, fast_halves, mean_halves)
            top = total17 + total16
            low = lost17 - lost16 + lost18 + mean_low2
            fall__halves = halves(xp, fall_)
            fall2_halves = halves(xp, fall2)
            lost18 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
            low3 = fall2*fall_low2 + lost18
            total16 = fast + 1.0
            back3 = total16 - 1.0
            lost18 = fast - back3
            total17 = total282*total16
            total282_halves = halves(xp, total282)
            total16_halves = halves(xp, total16)
            lost18 = (
                total282*(lost18 + low3) + product_error(total17, total282_halves, total16_halves)
            )
            total282 = 1.0 - fast
            back3 = total282 - 1.0
            lost17 = -back3 - fast
            total53 = mean*total282
            total282_halves = halves(xp, total282)
            lost17 = mean*(lost17 - low3) + product_error(total53, mean_halves, total282_halves)
            moved_low = lost17 + mean_low2*total282
            total282 = total53/whole
            left = total53 - total282*whole
            total282_halves = halves(xp, total282)
            left = left - product_error(total282*whole, total282_halves, whole_halves)
            left = left + moved_low - p_low*total282
            lost17 = left/whole
            apart_of = (low + top)/whole3
            nyquist_of = lost18 + total16*(fall_low2 + lost3) + total17
            together_of = lost17 + total282
            return apart_of, nyquist_of, together_of

        apart_of, nyquist_of, together_of = select(xp, reach < 1.0, yes,
            (gamma, half, lost2, root, size, total2, total3), no,
            (delta, gamma, half, lost2, root, size, total3))

        return apart_of, nyquist_of, together_of

    apart_of, nyquist_of, together_of = select(xp, total2 < 0.0, yes,
        (delta, gamma, half, lost, total2), no, (delta, gamma, half, lost, total2))

    return apart_of, nyquist_of, together_of


def apart_nyquist_together(xp, gamma, delta):
    """(n1 - n0)/delta; 1 + a + e; n1 + n0"""
    if gamma.dtype == xp.float32:
        return apart_nyquist_together_single(xp, gamma, delta)
    half = 0.5*delta
    square = (half*half)
    total = square - gamma
    back = total - square
    rest = total - back
    one = square - rest
    two = -back - gamma
    lost = one + two
    half_halves = halves(xp, half)
    rest = lost + product_error(square, half_halves, half_halves)
    total2 = rest + total
    back = total2 - total
    lost = rest - back

    def yes(delta, gamma, half, lost2, total2):
        reach = 0.25*gamma

        def yes(delta, half, lost2, total2):
            square2 = total2
            envelope = xp.exp(-half)
            rest5 = apart_series(xp, half, total2)
            total27 = rest5 + 0.16666666666666666
            back17 = total27 - rest5
            rest6 = total27 - back17
            one4 = rest5 - rest6
            two4 = 0.16666666666666666 - back17
            lost27 = one4 + two4
            total28 = envelope*total27
            envelope_halves = halves(xp, envelope)
            total27_halves = halves(xp, total27)
            lost27 = envelope*lost27 + product_error(total28, envelope_halves, total27_halves)
            twice2 = 2.0*envelope
            rest6 = together_series(xp, half, total2)
            total27 = rest6 + 0.5
            back17 = total27 - rest6
            rest5 = total27 - back17
            one4 = rest6 - rest5
            two4 = 0.5 - back17
            lost55 = one4 + two4
            total56 = envelope*total27
            total27_halves = halves(xp, total27)
            lost55 = envelope*lost55 + product_error(total56, envelope_halves, total27_halves)

            def yes(square2):
                given3 = square2
                total19 = 0.5*given3 + 1.0
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total19 = curved3 + total19
                even = total19
                return even

            def no(total2):
                size = xp.abs(total2)
                root = square_root(xp, size)
                cosine = xp.cos(root)
                even = cosine
                return even

            even = select(xp, square2 > -1.5, yes, (square2,), no, (total2,))

            total27 = even*twice2

            def yes(delta, even, lost2, lost28, lost56, square2, total2, total262, total28,
                total56, twice2):
                e = xp.exp(-delta)
                total252 = e + 1.0
                back18 = total252 - 1.0
                lost252 = e - back18
                total272 = total252 + total262
                back18 = total272 - total252
                lost272 = total262 - back18

                def yes(lost2, square2):
                    given3 = square2
                    total19 = 0.5*given3 + 1.0
                    back13 = total19 - 1.0
                    lost19 = 0.5*given3 - back13
                    cos_series_of = cos_series(xp, given3)
                    curved3 = cos_series_of*(given3*given3)
                    total20 = curved3 + total19
                    back13 = total20 - total19
                    lost20 = curved3 - back13
                    even_low = lost19 + 0.5*lost2 + lost20
                    return even_low

                def no(lost2, total2):
                    size = xp.abs(total2)
                    root = square_root(xp, size)
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    sine = xp.sin(root)
                    even_low2 = -root_low*sine
                    return even_low2

                even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no, (lost2, total2))

                twice2_halves = halves(xp, twice2)
                even_halves = halves(xp, even)
                lost262 = even_low2*twice2 + product_error(twice2*even, twice2_halves, even_halves)
                apart_of = lost28 + total28
                nyquist_of = lost252 + lost262 + lost272 + total272
                together_of = 2.0*lost56 + 2.0*total56
                return apart_of, nyquist_of, together_of

            def no(envelope, half, lost2, lost28, lost56, total2, total28, total56):
                size = xp.abs(total2)
                root = square_root(xp, size)
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                expm1_of = xp.expm1(-half)
                grown = -0.5*expm1_of
                angle = 0.5*root
                wave = xp.cos(angle)
                sin_of = xp.sin(angle)
                back72 = 0.5*root_low*sin_of
                total92 = wave - back72
                back82 = total92 - wave
                rest32 = total92 - back82
                one22 = wave - rest32
                two22 = -back72 - back82
                lost92 = one22 + two22
                total102 = (total92*total92)
                total92_halves = halves(xp, total92)
                lost102 = product_error(total102, total92_halves, total92_halves)
                low2 = lost102 + 2.0*lost92*total92
                total92 = envelope*total102
                envelope_halves = halves(xp, envelope)
                total102_halves = halves(xp, total102)
                lost92 = envelope*low2 + product_error(total92, envelope_halves, total102_halves)
                total102 = (grown*grown) + total92
                back82 = total102 - total92
                rest32 = total102 - back82
                one22 = total92 - rest32
                two22 = (grown*grown) - back82
                lost102 = one22 + two22
                low2 = lost92 + lost102
                apart_of = lost28 + total28
                nyquist_of = 4.0*low2 + 4.0*total102
                together_of = 2.0*lost56 + 2.0*total56
                return apart_of, nyquist_of, together_of

            apart_of, nyquist_of, together_of = (
                select(xp, total27 > 0.0, yes, (delta, even, lost2, lost27, lost55, square2,
                total2, total27, total28, total56, twice2), no,
                (envelope, half, lost2, lost27, lost55, total2, total28, total56))
            )

            return apart_of, nyquist_of, together_of

        def no(delta, gamma, half, lost2, total2):
            size = xp.abs(total2)
            root = square_root(xp, size)
            square2 = total2
            envelope = xp.exp(-half)
            stiff = gamma
            mean3 = decay(xp, delta)
            twice2 = 2.0*envelope

            def yes(lost2, square2):
                given3 = square2
                total19 = 0.5*given3 + 1.0
                cos_series_of = cos_series(xp, given3)
                curved3 = cos_series_of*(given3*given3)
                total19 = curved3 + total19
                sin_series_of = sin_series(xp, given3)
                bent = given3*sin_series_of
                total21 = bent + 1.0
                back15 = total21 - 1.0
                lost21 = bent - back15
                odd_low = 0.16666666666666666*lost2 + lost21
                even = total19
                odd = total21
                return even, odd, odd_low

            def no(lost2, root, size):
                sign_low = -lost2
                left = size - (root*root)
                root_halves = halves(xp, root)
                left = left - product_error(root*root, root_halves, root_halves)
                left = left + sign_low
                whole = xp.where(root == 0.0, 1.0, root)
                root_low = 0.5*left/whole
                sine = xp.sin(root)
                cosine = xp.cos(root)
                some = root
                total22 = sine/some
                left = sine - some*total22
                total22_halves = halves(xp, total22)
                some_halves = halves(xp, some)
                left = left - product_error(total22*some, total22_halves, some_halves)
                left = cosine*root_low + left - root_low*total22
                lost22 = left/some
                even = cosine
                odd = total22
                odd_low2 = lost22
                return even, odd, odd_low2

            even, odd, odd_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                (lost2, root, size))

            total24 = envelope*odd
            envelope_halves = halves(xp, envelope)
            odd_halves = halves(xp, odd)
            lost24 = envelope*odd_low2 + product_error(total24, envelope_halves, odd_halves)
            total25 = mean3 - total24
            back16 = total25 - mean3
            rest4 = total25 - back16
            one3 = mean3 - rest4
            two3 = -back16 - total24
            lost25 = one3 + two3
            total24 = total25/stiff
            left13 = total25 - stiff*total24
            total24_halves = halves(xp, total24)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total24*stiff, total24_halves, stiff_halves)
            left13 = left13 - lost24 + lost25
            lost25 = left13/stiff
            total25 = even*twice2

            def yes(root):
                count = xp.floor(0.5*root/3.141592653589793 + 0.5)
                return count

            def no(root):
                return 0.0

            count = select(xp, root < 67108864.0, yes, (root,), no, (root,))

            turns = (count*count)
            total142 = 39.47841760435743*turns
            turns_halves = halves(xp, turns)
            number5_halves = halves(xp, xp.full_like(turns, 39.47841760435743))
            lost24 = product_error(total142, turns_halves, number5_halves)
            total152 = 2.5061182034958845e-15*turns
            number6_halves = halves(xp, xp.full_like(turns, 2.5061182034958845e-15))
            lost152 = product_error(total152, turns_halves, number6_halves)
            total162 = -total142 - total2
            back16 = total162 + total2
            rest4 = total162 - back16
            one3 = -rest4 - total2
            two3 = -back16 - total142
            lost162 = one3 + two3
            total142 = total162 - lost24
            back16 = total142 - total162
            rest4 = total142 - back16
            one3 = total162 - rest4
            two3 = -back16 - lost24
            lost24 = one3 + two3
            total162 = total142 - total152
            back16 = total162 - total142
            rest4 = total162 - back16
            one3 = total142 - rest4
            two3 = -back16 - total152
            lost182 = one3 + two3
            total152 = total162 - lost2
            back16 = total152 - total162
            rest4 = total152 - back16
            one3 = total162 - rest4
            two3 = -back16 - lost2
            lost192 = one3 + two3
            low32 = lost162 - lost152 + lost24 + lost182 + lost192 - 1.4920070805839235e-31*turns
            total162 = low32 + total152
            total142 = 6.283185307179586*count
            total222 = root + total142
            whole32 = xp.where(total222 == 0.0, 1.0, total222)
            total232 = total162/whole32
            far = (total232*total232)

            def yes(count, delta, envelope, even, far, half, lost2, lost26, low32, root, size,
                square2, stiff, total192, total202, total212, total222, total232, total26,
                total262, twice2, whole32):

                def yes(count, delta, even, half, lost2, lost26, low32, root, size, square2, stiff,
                    total192, total202, total212, total222, total232, total26, total262, twice2,
                    whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    e = xp.exp(-delta)
                    total252 = e + 1.0
                    back18 = total252 - 1.0
                    lost252 = e - back18
                    total272 = total252 + total262
                    back18 = total272 - total252
                    lost272 = total262 - back18
                    back18 = total202 - total192
                    rest9 = total202 - back18
                    one8 = total192 - rest9
                    two8 = low32 - back18
                    lost202 = one8 + two8
                    count_halves = halves(xp, count)
                    number2_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                    lost212 = product_error(count*6.283185307179586, count_halves, number2_halves)
                    back18 = total222 - root
                    rest9 = total222 - back18
                    one8 = root - rest9
                    two8 = total212 - back18
                    lost222 = one8 + two8
                    both_low = 2.4492935982947064e-16*count + lost212 + lost222 + root_low
                    left = total202 - total232*whole32
                    total232_halves = halves(xp, total232)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total232*whole32, total232_halves, whole32_halves)
                    left = left - both_low*total232 + lost202
                    lost202 = left/whole32
                    eta = total232
                    eta_low = lost202
                    total252 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost202 = 2.0*eta*eta_low + product_error(total252, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total252)
                    bent2 = cos_series_of2*(total252*total252)
                    total253 = 0.5*total252 - bent2
                    back18 = total253 - 0.5*total252
                    lost222 = -back18 - bent2
                    sin_series_of2 = sin_series(xp, -total252)
                    total252 = 1.0 - sin_series_of2*total252
                    lift_low = 0.5*lost202*total252 + lost222
                    given22 = half
                    total252 = 1.0 - 0.5*given22
                    back18 = total252 - 1.0
                    lost222 = -back18 - 0.5*given22
                    decay_series_of3 = decay_series(xp, given22)
                    curved22 = decay_series_of3*(given22*given22)
                    total302 = curved22 + total252
                    back18 = total302 - total252
                    lost202 = curved22 - back18
                    mean_low5 = lost222 + lost202
                    total252 = given22*total302
                    given22_halves = halves(xp, given22)
                    total302_halves = halves(xp, total302)
                    lost202 = given22*mean_low5 + product_error(total252, given22_halves,
                        total302_halves)
                    total302 = 1.0 - total252
                    back18 = total302 - 1.0
                    lost222 = -back18 - total252
                    fall_low5 = lost222 - lost202
                    total252 = 1.0 - total302
                    back18 = total252 - 1.0
                    lost222 = -back18 - total302
                    low42 = lost222 - fall_low5
                    total34 = low42 + total252
                    back18 = total34 - total252
                    lost222 = low42 - back18
                    total252 = (total34*total34)
                    total34_halves = halves(xp, total34)
                    lost222 = 2.0*lost222*total34 + product_error(total252, total34_halves,
                        total34_halves)
                    total34 = total253*total302
                    total302_halves = halves(xp, total302)
                    total253_halves = halves(xp, total253)
                    lost202 = lift_low*total302 + product_error(total34, total302_halves,
                        total253_halves)
                    total302 = total252 + 2.0*total34
                    back18 = total302 - total252
                    rest9 = total302 - back18
                    one8 = total252 - rest9
                    two8 = 2.0*total34 - back18
                    lost212 = one8 + two8
                    low42 = 2.0*fall_low5*total253 + lost222 + 2.0*lost202 + lost212
                    total253 = total302/stiff
                    left = total302 - stiff*total253
                    total253_halves = halves(xp, total253)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total253*stiff, total253_halves, stiff_halves)
                    left = left + low42
                    lost212 = left/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost202 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost26 + total26
                    nyquist_of = lost252 + lost202 + lost272 + total272
                    together_of = lost212 + total253
                    return apart_of, nyquist_of, together_of

                def no(delta, envelope, even, half, lost2, lost26, root, size, square2, stiff,
                    total26, total262, twice2):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    e = xp.exp(-delta)
                    total252 = e + 1.0
                    back18 = total252 - 1.0
                    lost252 = e - back18
                    total272 = total252 + total262
                    back18 = total272 - total252
                    lost272 = total262 - back18
                    back18 = -0.5*root_low*wave
                    total252 = sin_of - back18
                    back83 = total252 - sin_of
                    rest33 = total252 - back83
                    one23 = sin_of - rest33
                    two23 = -back18 - back83
                    lost93 = one23 + two23
                    total103 = (total252*total252)
                    total252_halves = halves(xp, total252)
                    lost103 = product_error(total103, total252_halves, total252_halves)
                    low4 = lost103 + 2.0*lost93*total252
                    total252 = envelope*total103
                    envelope_halves = halves(xp, envelope)
                    total103_halves = halves(xp, total103)
                    lost93 = envelope*low4 + product_error(total252, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total252
                    back83 = total103 - total252
                    rest33 = total103 - back83
                    one23 = total252 - rest33
                    two23 = (grown*grown) - back83
                    lost103 = one23 + two23
                    low4 = lost93 + lost103
                    total252 = total103/stiff
                    left = total103 - stiff*total252
                    total252_halves = halves(xp, total252)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total252*stiff, total252_halves, stiff_halves)
                    left = left + low4
                    lost103 = left/stiff

                    def yes(lost2, square2):
                        given3 = square2
                        total19 = 0.5*given3 + 1.0
                        back13 = total19 - 1.0
                        lost19 = 0.5*given3 - back13
                        cos_series_of = cos_series(xp, given3)
                        curved3 = cos_series_of*(given3*given3)
                        total20 = curved3 + total19
                        back13 = total20 - total19
                        lost20 = curved3 - back13
                        even_low = lost19 + 0.5*lost2 + lost20
                        return even_low

                    def no(root, root_low):
                        sine = xp.sin(root)
                        even_low2 = -root_low*sine
                        return even_low2

                    even_low2 = select(xp, square2 > -1.5, yes, (lost2, square2), no,
                        (root, root_low))

                    twice2_halves = halves(xp, twice2)
                    even_halves = halves(xp, even)
                    lost93 = even_low2*twice2 + product_error(twice2*even, twice2_halves,
                        even_halves)
                    apart_of = lost26 + total26
                    nyquist_of = lost252 + lost93 + lost272 + total272
                    together_of = 4.0*lost103 + 4.0*total252
                    return apart_of, nyquist_of, together_of

                apart_of, nyquist_of, together_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, delta, even, half, lost2, lost26, low32, root, size, square2,
                    stiff, total192, total202, total212, total222, total232, total26, total262,
                    twice2, whole32), no, (delta, envelope, even, half, lost2, lost26, root,
                    size, square2, stiff, total26, total262, twice2))
                )

                return apart_of, nyquist_of, together_of

            def no(count, envelope, far, half, lost2, lost26, low32, root, size, stiff, total192,
                total202, total212, total222, total232, total26, whole32):

                def yes(count, envelope, half, lost2, lost26, low32, root, size, stiff, total192,
                    total202, total212, total222, total232, total26, whole32):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back72 = 0.5*root_low*sin_of
                    total92 = wave - back72
                    back82 = total92 - wave
                    rest32 = total92 - back82
                    one22 = wave - rest32
                    two22 = -back72 - back82
                    lost92 = one22 + two22
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low2 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low2 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest32 = total102 - back82
                    one22 = total92 - rest32
                    two22 = (grown*grown) - back82
                    lost102 = one22 + two22
                    low2 = lost92 + lost102
                    back82 = total202 - total192
                    rest32 = total202 - back82
                    one22 = total192 - rest32
                    two22 = low32 - back82
                    lost102 = one22 + two22
                    count_halves = halves(xp, count)
                    number5_halves = halves(xp, xp.full_like(count, 6.283185307179586))
                    lost92 = product_error(count*6.283185307179586, count_halves, number5_halves)
                    back82 = total222 - root
                    rest32 = total222 - back82
                    one22 = root - rest32
                    two22 = total212 - back82
                    lost222 = one22 + two22
                    both_low = 2.4492935982947064e-16*count + lost92 + lost222 + root_low
                    left = total202 - total232*whole32
                    total232_halves = halves(xp, total232)
                    whole32_halves = halves(xp, whole32)
                    left = left - product_error(total232*whole32, total232_halves, whole32_halves)
                    left = left - both_low*total232 + lost102
                    lost102 = left/whole32
                    eta = total232
                    eta_low = lost102
                    total92 = (eta*eta)
                    eta_halves = halves(xp, eta)
                    lost102 = 2.0*eta*eta_low + product_error(total92, eta_halves, eta_halves)
                    cos_series_of2 = cos_series(xp, -total92)
                    bent2 = cos_series_of2*(total92*total92)
                    total253 = 0.5*total92 - bent2
                    back82 = total253 - 0.5*total92
                    lost222 = -back82 - bent2
                    sin_series_of2 = sin_series(xp, -total92)
                    total92 = 1.0 - sin_series_of2*total92
                    lift_low = 0.5*lost102*total92 + lost222
                    given22 = half
                    total92 = 1.0 - 0.5*given22
                    back82 = total92 - 1.0
                    lost222 = -back82 - 0.5*given22
                    decay_series_of3 = decay_series(xp, given22)
                    curved22 = decay_series_of3*(given22*given22)
                    total302 = curved22 + total92
                    back82 = total302 - total92
                    lost102 = curved22 - back82
                    mean_low5 = lost222 + lost102
                    total92 = given22*total302
                    given22_halves = halves(xp, given22)
                    total302_halves = halves(xp, total302)
                    lost102 = given22*mean_low5 + product_error(total92, given22_halves,
                        total302_halves)
                    total302 = 1.0 - total92
                    back82 = total302 - 1.0
                    lost222 = -back82 - total92
                    fall_low5 = lost222 - lost102
                    total92 = 1.0 - total302
                    back82 = total92 - 1.0
                    lost222 = -back82 - total302
                    low42 = lost222 - fall_low5
                    total34 = low42 + total92
                    back82 = total34 - total92
                    lost222 = low42 - back82
                    total92 = (total34*total34)
                    total34_halves = halves(xp, total34)
                    lost222 = 2.0*lost222*total34 + product_error(total92, total34_halves,
                        total34_halves)
                    total34 = total253*total302
                    total302_halves = halves(xp, total302)
                    total253_halves = halves(xp, total253)
                    lost102 = lift_low*total302 + product_error(total34, total302_halves,
                        total253_halves)
                    total302 = total92 + 2.0*total34
                    back82 = total302 - total92
                    rest32 = total302 - back82
                    one22 = total92 - rest32
                    two22 = 2.0*total34 - back82
                    lost92 = one22 + two22
                    low42 = 2.0*fall_low5*total253 + lost222 + 2.0*lost102 + lost92
                    total253 = total302/stiff
                    left = total302 - stiff*total253
                    total253_halves = halves(xp, total253)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total253*stiff, total253_halves, stiff_halves)
                    left = left + low42
                    lost92 = left/stiff
                    apart_of = lost26 + total26
                    nyquist_of = 4.0*low2 + 4.0*total102
                    together_of = lost92 + total253
                    return apart_of, nyquist_of, together_of

                def no(envelope, half, lost2, lost26, root, size, stiff, total26):
                    sign_low = -lost2
                    left = size - (root*root)
                    root_halves = halves(xp, root)
                    left = left - product_error(root*root, root_halves, root_halves)
                    left = left + sign_low
                    whole = xp.where(root == 0.0, 1.0, root)
                    root_low = 0.5*left/whole
                    expm1_of = xp.expm1(-half)
                    grown = -0.5*expm1_of
                    angle = 0.5*root
                    wave = xp.cos(angle)
                    sin_of = xp.sin(angle)
                    back72 = 0.5*root_low*sin_of
                    total92 = wave - back72
                    back82 = total92 - wave
                    rest32 = total92 - back82
                    one22 = wave - rest32
                    two22 = -back72 - back82
                    lost92 = one22 + two22
                    total102 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost102 = product_error(total102, total92_halves, total92_halves)
                    low2 = lost102 + 2.0*lost92*total92
                    total92 = envelope*total102
                    envelope_halves = halves(xp, envelope)
                    total102_halves = halves(xp, total102)
                    lost92 = envelope*low2 + product_error(total92, envelope_halves,
                        total102_halves)
                    total102 = (grown*grown) + total92
                    back82 = total102 - total92
                    rest32 = total102 - back82
                    one22 = total92 - rest32
                    two22 = (grown*grown) - back82
                    lost102 = one22 + two22
                    low2 = lost92 + lost102
                    back82 = -0.5*root_low*wave
                    total92 = sin_of - back82
                    back72 = total92 - sin_of
                    rest32 = total92 - back72
                    one22 = sin_of - rest32
                    two22 = -back82 - back72
                    lost102 = one22 + two22
                    total103 = (total92*total92)
                    total92_halves = halves(xp, total92)
                    lost92 = product_error(total103, total92_halves, total92_halves)
                    low4 = lost92 + 2.0*lost102*total92
                    total92 = envelope*total103
                    total103_halves = halves(xp, total103)
                    lost102 = envelope*low4 + product_error(total92, envelope_halves,
                        total103_halves)
                    total103 = (grown*grown) + total92
                    back72 = total103 - total92
                    rest32 = total103 - back72
                    one22 = total92 - rest32
                    two22 = (grown*grown) - back72
                    lost92 = one22 + two22
                    low4 = lost102 + lost92
                    total92 = total103/stiff
                    left = total103 - stiff*total92
                    total92_halves = halves(xp, total92)
                    stiff_halves = halves(xp, stiff)
                    left = left - product_error(total92*stiff, total92_halves, stiff_halves)
                    left = left + low4
                    lost92 = left/stiff
                    apart_of = lost26 + total26
                    nyquist_of = 4.0*low2 + 4.0*total102
                    together_of = 4.0*lost92 + 4.0*total92
                    return apart_of, nyquist_of, together_of

                apart_of, nyquist_of, together_of = (
                    select(xp, (count > 0.0) & (far < 1.5) & (half < 0.75), yes,
                    (count, envelope, half, lost2, lost26, low32, root, size, stiff, total192,
                    total202, total212, total222, total232, total26, whole32), no,
                    (envelope, half, lost2, lost26, root, size, stiff, total26))
                )

                return apart_of, nyquist_of, together_of

            apart_of, nyquist_of, together_of = (
                select(xp, total25 > 0.0, yes, (count, delta, envelope, even, far, half, lost2,
                lost25, low32, root, size, square2, stiff, total152, total162, total142,
                total222, total232, total24, total25, twice2, whole32), no,
                (count, envelope, far, half, lost2, lost25, low32, root, size, stiff, total152,
                total162, total142, total222, total232, total24, whole32))
            )

            return apart_of, nyquist_of, together_of

        apart_of, nyquist_of, together_of = select(xp, reach < 1.0, yes,
            (delta, half, lost2, total2), no, (delta, gamma, half, lost2, total2))

        return apart_of, nyquist_of, together_of

    def no(delta, gamma, half, lost2, total2):
        size = xp.abs(total2)
        root = square_root(xp, size)
        total3 = half + root
        reach = 0.4444444444444444*total3

        def yes(gamma, half, lost2, root, size, total2, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            envelope = xp.exp(-half)
            rest5 = apart_series(xp, half, total2)
            total27 = rest5 + 0.16666666666666666
            back3 = total27 - rest5
            rest6 = total27 - back3
            one4 = rest5 - rest6
            two4 = 0.16666666666666666 - back3
            lost3 = one4 + two4
            total28 = envelope*total27
            envelope_halves = halves(xp, envelope)
            total27_halves = halves(xp, total27)
            lost3 = envelope*lost3 + product_error(total28, envelope_halves, total27_halves)
            rest6 = together_series(xp, half, total2)
            total27 = rest6 + 0.5
            back3 = total27 - rest6
            rest5 = total27 - back3
            one4 = rest6 - rest5
            two4 = 0.5 - back3
            lost55 = one4 + two4
            total56 = envelope*total27
            total27_halves = halves(xp, total27)
            lost55 = envelope*lost55 + product_error(total56, envelope_halves, total27_halves)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                return fall_, fall_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                fall_ = sunk
                fall_low2 = sunk_low
                return fall_, fall_low2

            fall_, fall_low2 = select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))

            total27 = fall_ + 1.0
            back3 = total27 - 1.0
            lost282 = fall_ - back3

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                return fall2, fall_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                fall2 = sunk2
                fall_low4 = sunk_low2
                return fall2, fall_low4

            fall2, fall_low4 = select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))

            fast = fall_*fall2
            fall__halves = halves(xp, fall_)
            fall2_halves = halves(xp, fall2)
            lost29 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
            low3 = fall2*fall_low2 + lost29
            total30 = fast + 1.0
            back3 = total30 - 1.0
            lost29 = fast - back3
            total31 = total27*total30
            total27_halves = halves(xp, total27)
            total30_halves = halves(xp, total30)
            lost29 = total27*(lost29 + low3) + product_error(total31, total27_halves,
                total30_halves)
            apart_of = lost3 + total28
            nyquist_of = lost29 + total30*(fall_low2 + lost282) + total31
            together_of = 2.0*lost55 + 2.0*total56
            return apart_of, nyquist_of, together_of

        def no(delta, gamma, half, lost2, root, size, total3):
            sign_low = lost2
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            left = left + sign_low
            whole = xp.where(root == 0.0, 1.0, root)
            root_low = 0.5*left/whole
            back3 = total3 - half
            lost3 = root - back3
            p_low = lost3 + root_low
            whole = xp.where(total3 == 0.0, 1.0, total3)
            q = gamma/whole
            off = gamma - q*whole
            whole_halves = halves(xp, whole)
            q_halves = halves(xp, q)
            off = off - product_error(whole*q, whole_halves, q_halves)
            off = off - p_low*q
            q_low = off/whole
            rate2 = 2.0*root
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)

            def yes(q, q_low):
                given = q
                total4 = 1.0 - 0.5*given
                back4 = total4 - 1.0
                lost4 = -back4 - 0.5*given
                decay_series_of = decay_series(xp, given)
                curved = decay_series_of*(given*given)
                total5 = curved + total4
                back4 = total5 - total4
                lost5 = curved - back4
                mean_low = lost4 + lost5 - q_low*(0.125*(given*given) - 0.3333333333333333*given +
                    0.5)
                total4 = given*total5
                given_halves = halves(xp, given)
                total5_halves = halves(xp, total5)
                lost5 = given*mean_low + product_error(total4, given_halves, total5_halves)
                total7 = 1.0 - total4
                back4 = total7 - 1.0
                lost4 = -back4 - total4
                fall_low = lost4 - lost5 - q_low*total5
                fall_ = total7
                mean = total5
                return fall_, fall_low, mean, mean_low

            def no(q, q_low):
                sunk = xp.exp(-q)
                sunk_low = -q_low*sunk
                total8 = 1.0 - sunk
                back7 = total8 - 1.0
                lost8 = -back7 - sunk
                bottom = q
                total9 = total8/bottom
                left4 = total8 - bottom*total9
                total9_halves = halves(xp, total9)
                bottom_halves = halves(xp, bottom)
                left4 = left4 - product_error(total9*bottom, total9_halves, bottom_halves)
                left4 = left4 + lost8 - q_low*total9 - sunk_low
                lost8 = left4/bottom
                fall_ = sunk
                fall_low2 = sunk_low
                mean = total9
                mean_low2 = lost8
                return fall_, fall_low2, mean, mean_low2

            fall_, fall_low2, mean, mean_low2 = (
                select(xp, q < 0.75, yes, (q, q_low), no, (q, q_low))
            )

            twice = 2.0*fall_
            total282 = fall_ + 1.0
            back3 = total282 - 1.0
            lost3 = fall_ - back3

            def yes(root, root_low):
                given2 = 2.0*root
                total10 = 1.0 - 0.5*given2
                back8 = total10 - 1.0
                lost10 = -back8 - 0.5*given2
                decay_series_of2 = decay_series(xp, given2)
                curved2 = decay_series_of2*(given2*given2)
                total11 = curved2 + total10
                back8 = total11 - total10
                lost11 = curved2 - back8
                mean_low3 = (
                    lost10 + lost11 - 2.0*root_low*(0.125*(given2*given2) - 0.3333333333333333*
                    given2 + 0.5)
                )
                total10 = given2*total11
                given2_halves = halves(xp, given2)
                total11_halves = halves(xp, total11)
                lost11 = given2*mean_low3 + product_error(total10, given2_halves, total11_halves)
                total13 = 1.0 - total10
                back8 = total13 - 1.0
                lost10 = -back8 - total10
                fall_low3 = lost10 - lost11 - 2.0*root_low*total11
                fall2 = total13
                mean2 = total11
                return fall2, fall_low3, mean2, mean_low3

            def no(root, root_low):
                sunk2 = xp.exp(-2.0*root)
                sunk_low2 = -2.0*root_low*sunk2
                total14 = 1.0 - sunk2
                back11 = total14 - 1.0
                lost14 = -back11 - sunk2
                bottom2 = 2.0*root
                total15 = total14/bottom2
                left7 = total14 - bottom2*total15
                total15_halves = halves(xp, total15)
                bottom2_halves = halves(xp, bottom2)
                left7 = left7 - product_error(total15*bottom2, total15_halves, bottom2_halves)
                left7 = left7 + lost14 - 2.0*root_low*total15 - sunk_low2
                lost14 = left7/bottom2
                fall2 = sunk2
                fall_low4 = sunk_low2
                mean2 = total15
                mean_low4 = lost14
                return fall2, fall_low4, mean2, mean_low4

            fall2, fall_low4, mean2, mean_low4 = (
                select(xp, rate2 < 0.75, yes, (root, root_low), no, (root, root_low))
            )

            fast = fall_*fall2
            total16 = mean2*twice
            twice_halves = halves(xp, twice)
            mean2_halves = halves(xp, mean2)
            lost16 = mean_low4*twice + product_error(total16, twice_halves, mean2_halves)
            total17 = mean - total16
            back3 = total17 - mean
            rest3 = total17 - back3
            one2 = mean - rest3
            two2 = -back3 - total16
            lost17 = one2 + two2
            total16 = fast*mean
            fast_halves = halves(xp, fast)
            mean_halves = halves(xp, mean)
            lost18 = fast*mean_low2 + product_error(total16, fast_halves, mean_halves)
            top = total17 + total16
            low = lost17 - lost16 + lost18 + mean_low2
            fall__halves = halves(xp, fall_)
            fall2_halves = halves(xp, fall2)
            lost18 = fall_*fall_low4 + product_error(fast, fall__halves, fall2_halves)
            low3 = fall2*fall_low2 + lost18
            total16 = fast + 1.0
            back3 = total16 - 1.0
            lost18 = fast - back3
            total17 = total282*total16
            total282_halves = halves(xp, total282)
            total16_halves = halves(xp, total16)
            lost18 = (
                total282*(lost18 + low3) + product_error(total17, total282_halves, total16_halves)
            )
            total282 = 1.0 - fast
            back3 = total282 - 1.0
            lost17 = -back3 - fast
            total53 = mean*total282
            total282_halves = halves(xp, total282)
            lost17 = mean*(lost17 - low3) + product_error(total53, mean_halves, total282_halves)
            moved_low = lost17 + mean_low2*total282
            total282 = total53/whole
            left = total53 - total282*whole
            total282_halves = halves(xp, total282)
            left = left - product_error(total282*whole, total282_halves, whole_halves)
            left = left + moved_low - p_low*total282
            lost17 = left/whole
            apart_of = (low + top)/whole3
            nyquist_of = lost18 + total16*(fall_low2 + lost3) + total17
            together_of = lost17 + total282
            return apart_of, nyquist_of, together_of

        apart_of, nyquist_of, together_of = select(xp, reach < 1.0, yes,
            (gamma, half, lost2, root, size, total2, total3), no,
            (delta, gamma, half, lost2, root, size, total3))

        return apart_of, nyquist_of, together_of

    apart_of, nyquist_of, together_of = select(xp, total2 < 0.0, yes,
        (delta, gamma, half, lost, total2), no, (delta, gamma, half, lost, total2))

    return apart_of, nyquist_of, together_of


def cos_next_sin_next_single(xp, k, x):
    """The same in single precision."""
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    quarters = xp.floor(2.0*angle/3.141592653589793 + 0.5)
    left = angle - 1.5707963705062866*quarters
    quarters_halves = halves(xp, quarters)
    number1_halves = halves(xp, xp.full_like(quarters, 1.5707963705062866))
    total = left - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
    back = total - left
    rest = total - back
    one = left - rest
    two = -back - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
    lost = one + two
    total2 = 4.371138828673793e-08*quarters + total
    back = total2 - total
    rest = total2 - back
    one = total - rest
    two = 4.371138828673793e-08*quarters - back
    lost2 = one + two
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    total = total2 + product_error(angle, count_halves, x_halves)
    back = total - total2
    rest = total - back
    one = total2 - rest
    two = product_error(angle, count_halves, x_halves) - back
    lost3 = one + two
    total2 = missed*x + total
    back = total2 - total
    rest = total2 - back
    one = total - rest
    two = missed*x - back
    lost4 = one + two
    number4_halves = halves(xp, xp.full_like(quarters, -4.371138828673793e-08))
    low = (
        lost + lost2 + lost3 + lost4 + 1.7151245100058819e-15*quarters -
        product_error(quarters*-4.371138828673793e-08, quarters_halves, number4_halves)
    )
    missed_halves = halves(xp, missed)
    low = low + product_error(missed*x, missed_halves, x_halves)
    wave = xp.sin(total2)
    still = xp.cos(total2)
    turn_ = quarters - 4.0*xp.floor(0.25*quarters)

    def yes(low2, still, wave):
        sine = low2*still + wave
        cosine = still - low2*wave
        value = sine
        value2 = cosine
        return value, value2

    def no(low2, still, wave):
        sine = low2*still + wave
        cosine = still - low2*wave
        value = cosine
        value2 = sine
        return value, value2

    value, value2 = select(xp, (turn_ == 1.0) | (turn_ == 3.0), yes, (low, still, wave), no,
        (low, still, wave))

    cos_next_of = xp.where((turn_ <= 2.0) & (turn_ >= 1.0), -value, value)
    sin_next_of = xp.where(turn_ >= 2.0, -value2, value2)
    return cos_next_of, sin_next_of


def cos_next_sin_next(xp, k, x):
    """cos((k + 1) x); sin((k + 1) x)"""
    if k.dtype == xp.float32:
        return cos_next_sin_next_single(xp, k, x)
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    off = missed*x + product_error(angle, count_halves, x_halves)
    cosine = xp.cos(angle)
    sine = xp.sin(angle)
    cos_next_of = cosine - off*sine
    sin_next_of = cosine*off + sine
    return cos_next_of, sin_next_of


def cos_next_single(xp, k, x):
    """The same in single precision."""
    count = k + 1.0
    angle = count*x
    quarters = xp.floor(2.0*angle/3.141592653589793 + 0.5)
    turn_ = quarters - 4.0*xp.floor(0.25*quarters)

    def yes(angle, count, k, quarters, turn_, x):
        before = count - 1.0
        missed = k - before
        left = angle - 1.5707963705062866*quarters
        quarters_halves = halves(xp, quarters)
        number1_halves = halves(xp, xp.full_like(quarters, 1.5707963705062866))
        total = left - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        back = total - left
        rest = total - back
        one = left - rest
        two = -back - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        lost = one + two
        total2 = 4.371138828673793e-08*quarters + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = 4.371138828673793e-08*quarters - back
        lost2 = one + two
        count_halves = halves(xp, count)
        x_halves = halves(xp, x)
        total = total2 + product_error(count*x, count_halves, x_halves)
        back = total - total2
        rest = total - back
        one = total2 - rest
        two = product_error(count*x, count_halves, x_halves) - back
        lost3 = one + two
        total2 = missed*x + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = missed*x - back
        lost4 = one + two
        number4_halves = halves(xp, xp.full_like(quarters, -4.371138828673793e-08))
        low = (
            lost + lost2 + lost3 + lost4 + 1.7151245100058819e-15*quarters -
            product_error(quarters*-4.371138828673793e-08, quarters_halves, number4_halves)
        )
        missed_halves = halves(xp, missed)
        low = low + product_error(missed*x, missed_halves, x_halves)
        wave = xp.sin(total2)
        still = xp.cos(total2)

        def yes(low2, still, wave):
            sine = low2*still + wave
            value = sine
            return value

        def no(low2, still, wave):
            cosine = still - low2*wave
            value = cosine
            return value

        value = select(xp, (turn_ == 1.0) | (turn_ == 3.0), yes, (low, still, wave), no,
            (low, still, wave))

        return -value

    def no(angle, count, k, quarters, turn_, x):
        before = count - 1.0
        missed = k - before
        left = angle - 1.5707963705062866*quarters
        quarters_halves = halves(xp, quarters)
        number1_halves = halves(xp, xp.full_like(quarters, 1.5707963705062866))
        total = left - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        back = total - left
        rest = total - back
        one = left - rest
        two = -back - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        lost = one + two
        total2 = 4.371138828673793e-08*quarters + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = 4.371138828673793e-08*quarters - back
        lost2 = one + two
        count_halves = halves(xp, count)
        x_halves = halves(xp, x)
        total = total2 + product_error(count*x, count_halves, x_halves)
        back = total - total2
        rest = total - back
        one = total2 - rest
        two = product_error(count*x, count_halves, x_halves) - back
        lost3 = one + two
        total2 = missed*x + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = missed*x - back
        lost4 = one + two
        number4_halves = halves(xp, xp.full_like(quarters, -4.371138828673793e-08))
        low = (
            lost + lost2 + lost3 + lost4 + 1.7151245100058819e-15*quarters -
            product_error(quarters*-4.371138828673793e-08, quarters_halves, number4_halves)
        )
        missed_halves = halves(xp, missed)
        low = low + product_error(missed*x, missed_halves, x_halves)
        wave = xp.sin(total2)
        still = xp.cos(total2)

        def yes(low2, still, wave):
            sine = low2*still + wave
            value = sine
            return value

        def no(low2, still, wave):
            cosine = still - low2*wave
            value = cosine
            return value

        value = select(xp, (turn_ == 1.0) | (turn_ == 3.0), yes, (low, still, wave), no,
            (low, still, wave))

        return value

    return select(xp, (turn_ <= 2.0) & (turn_ >= 1.0), yes, (angle, count, k, quarters, turn_, x),
        no, (angle, count, k, quarters, turn_, x))


def cos_next(xp, k, x):
    """cos((k + 1) x)"""
    if k.dtype == xp.float32:
        return cos_next_single(xp, k, x)
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    off = missed*x + product_error(angle, count_halves, x_halves)
    cosine = xp.cos(angle)
    sine = xp.sin(angle)
    return cosine - off*sine


def early_slope(xp, theta, k4, k3, k2, k1, k0):
    """has the sign of the slope of the boundary's alpha, d < 1"""
    sine = xp.sin(0.5*theta)
    cosine = xp.cos(0.5*theta)
    up = (sine*sine)
    along = (cosine*cosine)
    power = along
    found = k3*power + k4*up
    power = along*power
    found = found*up + k2*power
    power = along*power
    found = found*up + k1*power
    power = along*power
    found = found*up + k0*power
    return found


def end_slope(xp, at_minus_one, loss, together_, apart_, last):
    """has the sign of the slope of the boundary's alpha next to pi"""
    total = together_ - 4.0*last
    back = total - together_
    rest = total - back
    one = together_ - rest
    two = -back - 4.0*last
    lost = one + two
    total2 = (total*total)
    total_halves = halves(xp, total)
    lost2 = 2.0*lost*total + product_error(total2, total_halves, total_halves)
    total3 = apart_*together_
    apart__halves = halves(xp, apart_)
    together__halves = halves(xp, together_)
    lost3 = product_error(total3, apart__halves, together__halves)
    total4 = total3 - total2
    back = total4 - total3
    rest = total4 - back
    one = total3 - rest
    two = -back - total2
    lost4 = one + two
    gap_low = lost3 - lost2 + lost4
    total5 = total2 - 2.0*total3
    back = total5 - total2
    rest = total5 - back
    one = total2 - rest
    two = -back - 2.0*total3
    lost4 = one + two
    lean_low = lost2 - 2.0*lost3 + lost4
    total2 = total*total5
    total5_halves = halves(xp, total5)
    lost4 = lean_low*total + product_error(total2, total_halves, total5_halves)
    total7 = apart_*total3
    total3_halves = halves(xp, total3)
    lost3 = apart_*lost3 + product_error(total7, apart__halves, total3_halves)
    total3 = total2 + total7
    back = total3 - total2
    rest = total3 - back
    one = total2 - rest
    two = total7 - back
    lost2 = one + two
    bent_low = lost*total5 + lost4 + lost3 + lost2
    total5 = at_minus_one*total3
    at_minus_one_halves = halves(xp, at_minus_one)
    total3_halves = halves(xp, total3)
    lost2 = at_minus_one*bent_low + product_error(total5, at_minus_one_halves, total3_halves)
    total3 = apart_*total4
    total4_halves = halves(xp, total4)
    lost3 = apart_*gap_low + product_error(total3, apart__halves, total4_halves)
    total4 = loss*total3
    loss_halves = halves(xp, loss)
    total3_halves = halves(xp, total3)
    lost3 = loss*lost3 + product_error(total4, loss_halves, total3_halves)
    total3 = 2.0*apart_ - total
    back = total3 - 2.0*apart_
    rest = total3 - back
    one = 2.0*apart_ - rest
    two = -back - total
    lost4 = one + two
    total = (apart_*apart_)
    lost13 = product_error(total, apart__halves, apart__halves)
    total7 = total3*total
    total_halves = halves(xp, total)
    total3_halves = halves(xp, total3)
    lost4 = total*(lost4 - lost) + product_error(total7, total_halves, total3_halves)
    three_low = lost13*total3 + lost4
    total3 = 4.0*total7 - total5
    back = total3 - 4.0*total7
    rest = total3 - back
    one = 4.0*total7 - rest
    two = -back - total5
    lost4 = one + two
    total5 = total3 - 2.0*total4
    back = total5 - total3
    rest = total5 - back
    one = total3 - rest
    two = -back - 2.0*total4
    lost13 = one + two
    low = lost4 - 2.0*lost3 + lost13 - lost2 + 4.0*three_low
    return low + total5


def early_angle_single(xp, at_one, at_minus_one, loss, together_, apart_, last):
    """The same in single precision."""
    t = (apart_*apart_*apart_)
    t2 = (together_*together_*together_)
    t3 = (together_*together_)
    t4 = apart_*t3
    t5 = (apart_*apart_)
    t6 = 2.0*loss
    t7 = at_minus_one + t6
    t8 = 4.0*together_
    t9 = 16.0*apart_
    t6 = at_one + t6
    t11 = 2.0*at_one
    t12 = 5.0*at_minus_one
    t13 = -at_one
    t14 = 4.0*loss
    t15 = apart_*together_
    t16 = 16.0*together_
    t17 = at_one*last
    t18 = apart_*t11
    t19 = at_one*t5
    k = end_slope(xp, at_minus_one, loss, together_, apart_, last)
    k2 = last*(32.0*at_minus_one*t3 + last*
        (64.0*apart_*loss + 128.0*at_minus_one*last - 96.0*at_minus_one*together_) - 96.0*t5 - t7*
        t9*together_) - 4.0*at_minus_one*t2 + 16.0*t + 8.0*t4*(at_minus_one + loss) - t5*t7*t8
    k3 = (
        last*(last*(last*(-192.0*at_minus_one - 256.0*at_one - 512.0*loss) + t16*
        (9.0*at_one + 16.0*loss + t12) + t9*(8.0*at_minus_one + 8.0*at_one + 18.0*loss)) - 32.0*
        t15 - 4.0*t3*(at_minus_one + 7.0*at_one + 14.0*loss) - 112.0*t5) + 8.0*t + 2.0*t2*
        (t6 - 2.0*at_minus_one) + 2.0*t4*(t12 + t13 + t14) - 2.0*t5*together_*(t7 - t11)
    )
    k4 = (
        last*(32.0*t17*together_ - 8.0*together_*(t18 + 12.0*together_)) + t8*
        (t6*t3 + t15*(at_minus_one + t13) + t19)
    )
    k5 = (
        last*(t16*t17 + t8*(t6*together_ - t18)) + together_*
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
        above = early_slope(xp, low, k, k2, k3, k4, k5)

        def yes(low2):
            root = low2
            return root

        def no(above, high, k, k2, k3, k4, k5, low2):
            high2 = high
            below = early_slope(xp, high2, k, k2, k3, k4, k5)

            def yes(high2):
                root = high2
                return root

            def no(above, below, high2, k, k2, k3, k4, k5, low2):

                def over(b, fb, a, fa, c, fc, k, k2, k3, k4, k5):
                    return (
                        ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                        (xp.abs(a - b) <= 2.384185791015625e-07*
                        xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                    )

                def step(b, fb, a, fa, c, fc, k, k2, k3, k4, k5):
                    span = c - b
                    rise_ = fc - fb
                    whole = xp.where(span == 0.0, 1.0, span)
                    place = (a - b)/whole
                    whole = xp.where(rise_ == 0.0, 1.0, rise_)
                    height = (fa - fb)/whole
                    safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                        (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                    case1 = safe > 0.0
                    one = xp.where(case1, fb - fa, 1.0)
                    two = xp.where(case1, fb - fc, 1.0)
                    three = xp.where(case1, fa - fc, 1.0)
                    width = b - a
                    here = fa/one
                    there = fc/two
                    whole = xp.where(width == 0.0, 1.0, width)
                    other = fa/three
                    last2 = fb/two
                    guess = xp.where(case1, here*there + last2*other*(c - a)/whole, 0.5)
                    edge = (
                        2.384185791015625e-07*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                        xp.abs(whole)
                    )
                    edge = xp.where(0.5 < edge, 0.5, edge)
                    share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                    share = xp.where(edge > share, edge, share)
                    new = a + share*width
                    value = early_slope(xp, new, k, k2, k3, k4, k5)
                    case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                    next_b = xp.where(case2, b, a)
                    next_fb = xp.where(case2, fb, fa)
                    next_a = new
                    next_fa = value
                    next_c = xp.where(case2, a, b)
                    next_fc = xp.where(case2, fa, fb)
                    return next_b, next_fb, next_a, next_fa, next_c, next_fc

                b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                    (low2, above, high2, below, high2, below), (k, k2, k3, k4, k5))
                root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
                return root

            root = select(xp, below >= 0.0, yes, (high2,), no,
                (above, below, high2, k, k2, k3, k4, k5, low2))

            return root

        root = select(xp, above <= 0.0, yes, (low,), no, (above, high, k, k2, k3, k4, k5, low))

        return root

    def no(found):
        return 3.141592653589793

    return select(xp, found > 0.0, yes, (count, k, k2, k3, k4, k5), no, (found,))


def early_angle(xp, at_one, at_minus_one, loss, together_, apart_, last):
    """the angle of the largest stiffness for delays below a period"""
    if at_one.dtype == xp.float32:
        return early_angle_single(xp, at_one, at_minus_one, loss, together_, apart_, last)
    t = (apart_*apart_*apart_)
    t2 = (together_*together_*together_)
    t3 = (together_*together_)
    t4 = apart_*t3
    t5 = (apart_*apart_)
    t6 = 2.0*loss
    t7 = at_minus_one + t6
    t8 = 4.0*together_
    t9 = 16.0*apart_
    t6 = at_one + t6
    t11 = 2.0*at_one
    t12 = 5.0*at_minus_one
    t13 = -at_one
    t14 = 4.0*loss
    t15 = apart_*together_
    t16 = 16.0*together_
    t17 = at_one*last
    t18 = apart_*t11
    t19 = at_one*t5
    k = end_slope(xp, at_minus_one, loss, together_, apart_, last)
    k2 = last*(32.0*at_minus_one*t3 + last*
        (64.0*apart_*loss + 128.0*at_minus_one*last - 96.0*at_minus_one*together_) - 96.0*t5 - t7*
        t9*together_) - 4.0*at_minus_one*t2 + 16.0*t + 8.0*t4*(at_minus_one + loss) - t5*t7*t8
    k3 = (
        last*(last*(last*(-192.0*at_minus_one - 256.0*at_one - 512.0*loss) + t16*
        (9.0*at_one + 16.0*loss + t12) + t9*(8.0*at_minus_one + 8.0*at_one + 18.0*loss)) - 32.0*
        t15 - 4.0*t3*(at_minus_one + 7.0*at_one + 14.0*loss) - 112.0*t5) + 8.0*t + 2.0*t2*
        (t6 - 2.0*at_minus_one) + 2.0*t4*(t12 + t13 + t14) - 2.0*t5*together_*(t7 - t11)
    )
    k4 = (
        last*(32.0*t17*together_ - 8.0*together_*(t18 + 12.0*together_)) + t8*
        (t6*t3 + t15*(at_minus_one + t13) + t19)
    )
    k5 = (
        last*(t16*t17 + t8*(t6*together_ - t18)) + together_*
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
        above = early_slope(xp, low, k, k2, k3, k4, k5)

        def yes(low2):
            root = low2
            return root

        def no(above, high, k, k2, k3, k4, k5, low2):
            high2 = high
            below = early_slope(xp, high2, k, k2, k3, k4, k5)

            def yes(high2):
                root = high2
                return root

            def no(above, below, high2, k, k2, k3, k4, k5, low2):

                def over(b, fb, a, fa, c, fc, k, k2, k3, k4, k5):
                    return (
                        ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                        (xp.abs(a - b) <= 4.440892098500626e-16*
                        xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                    )

                def step(b, fb, a, fa, c, fc, k, k2, k3, k4, k5):
                    span = c - b
                    rise_ = fc - fb
                    whole = xp.where(span == 0.0, 1.0, span)
                    place = (a - b)/whole
                    whole = xp.where(rise_ == 0.0, 1.0, rise_)
                    height = (fa - fb)/whole
                    safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                        (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                    case1 = safe > 0.0
                    one = xp.where(case1, fb - fa, 1.0)
                    two = xp.where(case1, fb - fc, 1.0)
                    three = xp.where(case1, fa - fc, 1.0)
                    width = b - a
                    here = fa/one
                    there = fc/two
                    whole = xp.where(width == 0.0, 1.0, width)
                    other = fa/three
                    last2 = fb/two
                    guess = xp.where(case1, here*there + last2*other*(c - a)/whole, 0.5)
                    edge = (
                        4.440892098500626e-16*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                        xp.abs(whole)
                    )
                    edge = xp.where(0.5 < edge, 0.5, edge)
                    share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                    share = xp.where(edge > share, edge, share)
                    new = a + share*width
                    value = early_slope(xp, new, k, k2, k3, k4, k5)
                    case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                    next_b = xp.where(case2, b, a)
                    next_fb = xp.where(case2, fb, fa)
                    next_a = new
                    next_fa = value
                    next_c = xp.where(case2, a, b)
                    next_fc = xp.where(case2, fa, fb)
                    return next_b, next_fb, next_a, next_fa, next_c, next_fc

                b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                    (low2, above, high2, below, high2, below), (k, k2, k3, k4, k5))
                root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
                return root

            root = select(xp, below >= 0.0, yes, (high2,), no,
                (above, below, high2, k, k2, k3, k4, k5, low2))

            return root

        root = select(xp, above <= 0.0, yes, (low,), no, (above, high, k, k2, k3, k4, k5, low))

        return root

    def no(found):
        return 3.141592653589793

    return select(xp, found > 0.0, yes, (count, k, k2, k3, k4, k5), no, (found,))


def sin_next_single(xp, k, x):
    """The same in single precision."""
    count = k + 1.0
    angle = count*x
    quarters = xp.floor(2.0*angle/3.141592653589793 + 0.5)
    turn_ = quarters - 4.0*xp.floor(0.25*quarters)

    def yes(angle, count, k, quarters, turn_, x):
        before = count - 1.0
        missed = k - before
        left = angle - 1.5707963705062866*quarters
        quarters_halves = halves(xp, quarters)
        number1_halves = halves(xp, xp.full_like(quarters, 1.5707963705062866))
        total = left - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        back = total - left
        rest = total - back
        one = left - rest
        two = -back - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        lost = one + two
        total2 = 4.371138828673793e-08*quarters + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = 4.371138828673793e-08*quarters - back
        lost2 = one + two
        count_halves = halves(xp, count)
        x_halves = halves(xp, x)
        total = total2 + product_error(count*x, count_halves, x_halves)
        back = total - total2
        rest = total - back
        one = total2 - rest
        two = product_error(count*x, count_halves, x_halves) - back
        lost3 = one + two
        total2 = missed*x + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = missed*x - back
        lost4 = one + two
        number4_halves = halves(xp, xp.full_like(quarters, -4.371138828673793e-08))
        low = (
            lost + lost2 + lost3 + lost4 + 1.7151245100058819e-15*quarters -
            product_error(quarters*-4.371138828673793e-08, quarters_halves, number4_halves)
        )
        missed_halves = halves(xp, missed)
        low = low + product_error(missed*x, missed_halves, x_halves)
        wave = xp.sin(total2)
        still = xp.cos(total2)

        def yes(low2, still, wave):
            cosine = still - low2*wave
            value = cosine
            return value

        def no(low2, still, wave):
            sine = low2*still + wave
            value = sine
            return value

        value = select(xp, (turn_ == 1.0) | (turn_ == 3.0), yes, (low, still, wave), no,
            (low, still, wave))

        return -value

    def no(angle, count, k, quarters, turn_, x):
        before = count - 1.0
        missed = k - before
        left = angle - 1.5707963705062866*quarters
        quarters_halves = halves(xp, quarters)
        number1_halves = halves(xp, xp.full_like(quarters, 1.5707963705062866))
        total = left - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        back = total - left
        rest = total - back
        one = left - rest
        two = -back - product_error(quarters*1.5707963705062866, quarters_halves, number1_halves)
        lost = one + two
        total2 = 4.371138828673793e-08*quarters + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = 4.371138828673793e-08*quarters - back
        lost2 = one + two
        count_halves = halves(xp, count)
        x_halves = halves(xp, x)
        total = total2 + product_error(count*x, count_halves, x_halves)
        back = total - total2
        rest = total - back
        one = total2 - rest
        two = product_error(count*x, count_halves, x_halves) - back
        lost3 = one + two
        total2 = missed*x + total
        back = total2 - total
        rest = total2 - back
        one = total - rest
        two = missed*x - back
        lost4 = one + two
        number4_halves = halves(xp, xp.full_like(quarters, -4.371138828673793e-08))
        low = (
            lost + lost2 + lost3 + lost4 + 1.7151245100058819e-15*quarters -
            product_error(quarters*-4.371138828673793e-08, quarters_halves, number4_halves)
        )
        missed_halves = halves(xp, missed)
        low = low + product_error(missed*x, missed_halves, x_halves)
        wave = xp.sin(total2)
        still = xp.cos(total2)

        def yes(low2, still, wave):
            cosine = still - low2*wave
            value = cosine
            return value

        def no(low2, still, wave):
            sine = low2*still + wave
            value = sine
            return value

        value = select(xp, (turn_ == 1.0) | (turn_ == 3.0), yes, (low, still, wave), no,
            (low, still, wave))

        return value

    return select(xp, turn_ >= 2.0, yes, (angle, count, k, quarters, turn_, x), no,
        (angle, count, k, quarters, turn_, x))


def sin_next(xp, k, x):
    """sin((k + 1) x)"""
    if k.dtype == xp.float32:
        return sin_next_single(xp, k, x)
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    off = missed*x + product_error(angle, count_halves, x_halves)
    cosine = xp.cos(angle)
    sine = xp.sin(angle)
    return cosine*off + sine


def boundary_slope(xp, theta, l, at_one, at_minus_one, loss, together_, apart_, across):
    """has the sign of the slope of the boundary's alpha"""
    t = 2.0*l + 2.0
    t2 = 0.5*theta
    t3 = sin_next(xp, t, t2)
    t4 = xp.tan(t2)
    t5 = (t4*t4)
    t6 = 4.0*t5
    t7 = apart_*t5
    t8 = together_ - t7
    t9 = at_minus_one*t5
    t10 = at_one - t9
    t11 = across*loss*t6 + t10*t8
    t2 = cos_next(xp, t, t2)
    t = 2.0*loss*t4*t8 - 2.0*across*t10*t4
    t14 = (across*across)
    t15 = t14*t6 + (t8*t8)
    t16 = (loss*loss)
    t6 = (t10*t10) + t16*t6
    t18 = t15*t6
    t5 = t5 + 1.0
    return (
        (t11*t3 + t2*t)*(t18*(l + 1.5) + t5*(loss*t15*(at_one + t9) - across*t6*
        (t7 + together_))) - t4*(0.5*t18 + t5*
        (t15*(2.0*t16 - at_minus_one*t10) - t6*(2.0*t14 - apart_*t8)))*(t11*t2 - t*t3)
    )


def later_angle_single(xp, d, l, at_one, at_minus_one, loss, together_, apart_, across):
    """The same in single precision."""
    turn_ = 3.141592653589793/(d + 1.0)

    def over(count, found, across, apart_, at_minus_one, at_one, l, loss, together_, turn_):
        return (count > 24.0) | (found > 0.0)

    def step(count, found, across, apart_, at_minus_one, at_one, l, loss, together_, turn_):
        rises = boundary_slope(xp, 0.041666666666666664*count*turn_, l, at_one, at_minus_one, loss,
            together_, apart_, across)
        case1 = rises > 0.0
        next_count = xp.where(case1, count + 1.0, count)
        next_found = xp.where(case1, xp.full_like(rises, 0.0), 1.0)
        return next_count, next_found

    count, found = repeat(xp, 24, over, step, (1.0, 0.0),
        (across, apart_, at_minus_one, at_one, l, loss, together_, turn_))

    def yes(across, apart_, at_minus_one, at_one, count, l, loss, together_, turn_):
        high = 0.041666666666666664*count*turn_
        low = xp.where(0.001*high > 0.041666666666666664*turn_*(count - 1.0), 0.001*high,
            0.041666666666666664*turn_*(count - 1.0))
        above = boundary_slope(xp, low, l, at_one, at_minus_one, loss, together_, apart_, across)

        def yes(low2):
            root = low2
            return root

        def no(above, across, apart_, at_minus_one, at_one, high, l, loss, low2, together_):
            high2 = high
            below = boundary_slope(xp, high2, l, at_one, at_minus_one, loss, together_, apart_,
                across)

            def yes(high2):
                root = high2
                return root

            def no(above, across, apart_, at_minus_one, at_one, below, high2, l, loss, low2,
                together_):

                def over(b, fb, a, fa, c, fc, across, apart_, at_minus_one, at_one, l, loss,
                    together_):
                    return (
                        ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                        (xp.abs(a - b) <= 2.384185791015625e-07*
                        xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                    )

                def step(b, fb, a, fa, c, fc, across, apart_, at_minus_one, at_one, l, loss,
                    together_):
                    span = c - b
                    rise_ = fc - fb
                    whole = xp.where(span == 0.0, 1.0, span)
                    place = (a - b)/whole
                    whole = xp.where(rise_ == 0.0, 1.0, rise_)
                    height = (fa - fb)/whole
                    safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                        (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                    case1 = safe > 0.0
                    one = xp.where(case1, fb - fa, 1.0)
                    two = xp.where(case1, fb - fc, 1.0)
                    three = xp.where(case1, fa - fc, 1.0)
                    width = b - a
                    here = fa/one
                    there = fc/two
                    whole = xp.where(width == 0.0, 1.0, width)
                    other = fa/three
                    last = fb/two
                    guess = xp.where(case1, here*there + last*other*(c - a)/whole, 0.5)
                    edge = (
                        2.384185791015625e-07*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                        xp.abs(whole)
                    )
                    edge = xp.where(0.5 < edge, 0.5, edge)
                    share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                    share = xp.where(edge > share, edge, share)
                    new = a + share*width
                    value = boundary_slope(xp, new, l, at_one, at_minus_one, loss, together_,
                        apart_, across)
                    case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                    next_b = xp.where(case2, b, a)
                    next_fb = xp.where(case2, fb, fa)
                    next_a = new
                    next_fa = value
                    next_c = xp.where(case2, a, b)
                    next_fc = xp.where(case2, fa, fb)
                    return next_b, next_fb, next_a, next_fa, next_c, next_fc

                b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                    (low2, above, high2, below, high2, below),
                    (across, apart_, at_minus_one, at_one, l, loss, together_))
                root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
                return root

            root = select(xp, below >= 0.0, yes, (high2,), no,
                (above, across, apart_, at_minus_one, at_one, below, high2, l, loss, low2,
                together_))

            return root

        root = select(xp, above <= 0.0, yes, (low,), no,
            (above, across, apart_, at_minus_one, at_one, high, l, loss, low, together_))

        return root

    def no(found):
        return xp.nan

    return select(xp, found > 0.0, yes, (across, apart_, at_minus_one, at_one, count, l, loss,
        together_, turn_), no, (found,))


def later_angle(xp, d, l, at_one, at_minus_one, loss, together_, apart_, across):
    """the angle of the largest stiffness for a period and more"""
    if d.dtype == xp.float32:
        return later_angle_single(xp, d, l, at_one, at_minus_one, loss, together_, apart_, across)
    turn_ = 3.141592653589793/(d + 1.0)

    def over(count, found, across, apart_, at_minus_one, at_one, l, loss, together_, turn_):
        return (count > 24.0) | (found > 0.0)

    def step(count, found, across, apart_, at_minus_one, at_one, l, loss, together_, turn_):
        rises = boundary_slope(xp, 0.041666666666666664*count*turn_, l, at_one, at_minus_one, loss,
            together_, apart_, across)
        case1 = rises > 0.0
        next_count = xp.where(case1, count + 1.0, count)
        next_found = xp.where(case1, xp.full_like(rises, 0.0), 1.0)
        return next_count, next_found

    count, found = repeat(xp, 24, over, step, (1.0, 0.0),
        (across, apart_, at_minus_one, at_one, l, loss, together_, turn_))

    def yes(across, apart_, at_minus_one, at_one, count, l, loss, together_, turn_):
        high = 0.041666666666666664*count*turn_
        low = xp.where(0.001*high > 0.041666666666666664*turn_*(count - 1.0), 0.001*high,
            0.041666666666666664*turn_*(count - 1.0))
        above = boundary_slope(xp, low, l, at_one, at_minus_one, loss, together_, apart_, across)

        def yes(low2):
            root = low2
            return root

        def no(above, across, apart_, at_minus_one, at_one, high, l, loss, low2, together_):
            high2 = high
            below = boundary_slope(xp, high2, l, at_one, at_minus_one, loss, together_, apart_,
                across)

            def yes(high2):
                root = high2
                return root

            def no(above, across, apart_, at_minus_one, at_one, below, high2, l, loss, low2,
                together_):

                def over(b, fb, a, fa, c, fc, across, apart_, at_minus_one, at_one, l, loss,
                    together_):
                    return (
                        ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                        (xp.abs(a - b) <= 4.440892098500626e-16*
                        xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                    )

                def step(b, fb, a, fa, c, fc, across, apart_, at_minus_one, at_one, l, loss,
                    together_):
                    span = c - b
                    rise_ = fc - fb
                    whole = xp.where(span == 0.0, 1.0, span)
                    place = (a - b)/whole
                    whole = xp.where(rise_ == 0.0, 1.0, rise_)
                    height = (fa - fb)/whole
                    safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                        (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                    case1 = safe > 0.0
                    one = xp.where(case1, fb - fa, 1.0)
                    two = xp.where(case1, fb - fc, 1.0)
                    three = xp.where(case1, fa - fc, 1.0)
                    width = b - a
                    here = fa/one
                    there = fc/two
                    whole = xp.where(width == 0.0, 1.0, width)
                    other = fa/three
                    last = fb/two
                    guess = xp.where(case1, here*there + last*other*(c - a)/whole, 0.5)
                    edge = (
                        4.440892098500626e-16*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                        xp.abs(whole)
                    )
                    edge = xp.where(0.5 < edge, 0.5, edge)
                    share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                    share = xp.where(edge > share, edge, share)
                    new = a + share*width
                    value = boundary_slope(xp, new, l, at_one, at_minus_one, loss, together_,
                        apart_, across)
                    case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                    next_b = xp.where(case2, b, a)
                    next_fb = xp.where(case2, fb, fa)
                    next_a = new
                    next_fa = value
                    next_c = xp.where(case2, a, b)
                    next_fc = xp.where(case2, fa, fb)
                    return next_b, next_fb, next_a, next_fa, next_c, next_fc

                b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                    (low2, above, high2, below, high2, below),
                    (across, apart_, at_minus_one, at_one, l, loss, together_))
                root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
                return root

            root = select(xp, below >= 0.0, yes, (high2,), no,
                (above, across, apart_, at_minus_one, at_one, below, high2, l, loss, low2,
                together_))

            return root

        root = select(xp, above <= 0.0, yes, (low,), no,
            (above, across, apart_, at_minus_one, at_one, high, l, loss, low, together_))

        return root

    def no(found):
        return xp.nan

    return select(xp, found > 0.0, yes, (across, apart_, at_minus_one, at_one, count, l, loss,
        together_, turn_), no, (found,))


def undelayed_angle(xp, at_one, at_minus_one, loss, together_, apart_):
    """the angle of the largest stiffness without delay"""
    k = end_slope(xp, at_minus_one, loss, together_, apart_, xp.full_like(apart_, 0.0))
    t = 2.0*apart_
    t2 = -together_
    t3 = 2.0*together_
    t4 = (together_*together_)
    k2 = t3*((apart_*apart_)*at_one + together_*(at_minus_one*(t + t2) + loss*t))
    k3 = together_*(at_minus_one*t4 + at_one*(t4 + ((-apart_ - t2)*(-apart_ - t2))) + loss*t3*
        (2.0*together_ - apart_))

    def yes(k, k2, k3):
        discriminant = (k2*k2) - 4.0*k*k3
        root = square_root(xp, xp.where(0.0 > discriminant, 0.0, discriminant))
        above = k2 + root
        below = xp.where(0.0 > -2.0*k, 0.0, -2.0*k)
        return above, below

    def no(k, k2, k3):
        discriminant = (k2*k2) - 4.0*k*k3

        def yes(k3):
            above = 2.0*k3
            return above, 0.0

        def no(discriminant, k2, k3):
            root = square_root(xp, xp.where(0.0 > discriminant, 0.0, discriminant))
            above = 2.0*k3
            below = root - k2
            return above, below

        above, below = select(xp, discriminant < 0.0, yes, (k3,), no, (discriminant, k2, k3))

        return above, below

    above, below = select(xp, k2 > 0.0, yes, (k, k2, k3), no, (k, k2, k3))

    return 2.0*xp.atan2(square_root(xp, above), square_root(xp, below))


def stiffest_angle_single(xp, gamma, delta, d, l, part, first, last, at_one, at_minus_one, loss,
    together_, apart_):
    """The same in single precision."""

    def yes(apart_, at_minus_one, at_one, d, delta, first, gamma, l, last, loss, part, together_):
        across = xp.where(part == 0.0, first, first - last)

        def yes(apart_, at_minus_one, at_one, loss, together_):
            theta = undelayed_angle(xp, at_one, at_minus_one, loss, together_, apart_)
            return theta

        def no(across, apart_, at_minus_one, at_one, d, l, last, loss, together_):

            def yes(apart_, at_minus_one, at_one, last, loss, together_):
                theta = early_angle(xp, at_one, at_minus_one, loss, together_, apart_, last)
                return theta

            def no(across, apart_, at_minus_one, at_one, d, l, loss, together_):
                theta = later_angle(xp, d, l, at_one, at_minus_one, loss, together_, apart_, across)
                return theta

            theta = select(xp, d < 1.0, yes, (apart_, at_minus_one, at_one, last, loss, together_),
                no, (across, apart_, at_minus_one, at_one, d, l, loss, together_))

            return theta

        theta = select(xp, d == 0.0, yes, (apart_, at_minus_one, at_one, loss, together_), no,
            (across, apart_, at_minus_one, at_one, d, l, last, loss, together_))

        t = sin_next(xp, l, theta)
        t2 = 0.5*theta
        t3 = xp.sin(t2)
        t2 = xp.cos(t2)
        t5 = (t2*t2)
        t6 = (t3*t3)
        t7 = 4.0*t5*t6
        t8 = t5*together_ - apart_*t6
        t9 = 1.0/((across*across)*t7 + (t8*t8))
        t5 = at_one*t5 - at_minus_one*t6
        t11 = 2.0*loss*t8 - 2.0*across*t5
        t5 = across*loss*t7 + t5*t8
        t8 = t9*cos_next(xp, l, theta)
        t7 = -t*t5*t9/xp.sin(theta) - 0.5*t11*t8
        stiffness = t*t11*t3*t2*t9 - t5*t8 - 2.0*t7*t6

        def yes(d):
            return 1.0

        def no(apart_, at_minus_one, at_one, delta, first, gamma, l, last, loss, part, stiffness,
            t14, together_):
            damping = t14
            inside_ = 0.9999237060546875*stiffness - 7.62939453125e-05*gamma

            def yes(apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss,
                together_):
                outside = whole_roots(xp, inside_, damping, l, first, last, at_one, at_minus_one,
                    loss, together_, apart_)
                return outside

            def no(apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss, together_):
                outside = late_roots(xp, inside_, damping, l, first, last, at_one, at_minus_one,
                    loss, together_, apart_)
                return outside

            outside = select(xp, part == 0.0, yes,
                (apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss, together_),
                no, (apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss,
                together_))

            good = stable(xp, outside, inside_, damping, gamma, delta)
            return good

        good = select(xp, (delta > 0.0) & (gamma > -stiffness) &
            (square_root(xp, gamma)*(d + 1.0) <= 3.141592653589793), yes, (d,), no,
            (apart_, at_minus_one, at_one, delta, first, gamma, l, last, loss, part, stiffness, t7,
            together_))

        return xp.where(good > 0.0, theta, xp.nan)

    def no(d):
        return xp.nan

    return select(xp, ((d <= 1.0) | (square_root(xp, gamma)*(d + 1.0) <= 3.141592653589793)) &
        (gamma <= 9.8), yes, (apart_, at_minus_one, at_one, d, delta, first, gamma, l, last, loss,
        part, together_), no, (d,))


def stiffest_angle(xp, gamma, delta, d, l, part, first, last, at_one, at_minus_one, loss,
    together_, apart_):
    """the angle of the wall of largest stable stiffness, or NaN"""
    if gamma.dtype == xp.float32:
        return stiffest_angle_single(xp, gamma, delta, d, l, part, first, last, at_one,
            at_minus_one, loss, together_, apart_)

    def yes(apart_, at_minus_one, at_one, d, delta, first, gamma, l, last, loss, part, together_):
        across = xp.where(part == 0.0, first, first - last)

        def yes(apart_, at_minus_one, at_one, loss, together_):
            theta = undelayed_angle(xp, at_one, at_minus_one, loss, together_, apart_)
            return theta

        def no(across, apart_, at_minus_one, at_one, d, l, last, loss, together_):

            def yes(apart_, at_minus_one, at_one, last, loss, together_):
                theta = early_angle(xp, at_one, at_minus_one, loss, together_, apart_, last)
                return theta

            def no(across, apart_, at_minus_one, at_one, d, l, loss, together_):
                theta = later_angle(xp, d, l, at_one, at_minus_one, loss, together_, apart_, across)
                return theta

            theta = select(xp, d < 1.0, yes, (apart_, at_minus_one, at_one, last, loss, together_),
                no, (across, apart_, at_minus_one, at_one, d, l, loss, together_))

            return theta

        theta = select(xp, d == 0.0, yes, (apart_, at_minus_one, at_one, loss, together_), no,
            (across, apart_, at_minus_one, at_one, d, l, last, loss, together_))

        t = sin_next(xp, l, theta)
        t2 = 0.5*theta
        t3 = xp.sin(t2)
        t2 = xp.cos(t2)
        t5 = (t2*t2)
        t6 = (t3*t3)
        t7 = 4.0*t5*t6
        t8 = t5*together_ - apart_*t6
        t9 = 1.0/((across*across)*t7 + (t8*t8))
        t5 = at_one*t5 - at_minus_one*t6
        t11 = 2.0*loss*t8 - 2.0*across*t5
        t5 = across*loss*t7 + t5*t8
        t8 = t9*cos_next(xp, l, theta)
        t7 = -t*t5*t9/xp.sin(theta) - 0.5*t11*t8
        stiffness = t*t11*t3*t2*t9 - t5*t8 - 2.0*t7*t6

        def yes(d):
            return 1.0

        def no(apart_, at_minus_one, at_one, delta, first, gamma, l, last, loss, part, stiffness,
            t14, together_):
            damping = t14
            inside_ = 0.9999999953433871*stiffness - 4.6566128730773926e-09*gamma

            def yes(apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss,
                together_):
                outside = whole_roots(xp, inside_, damping, l, first, last, at_one, at_minus_one,
                    loss, together_, apart_)
                return outside

            def no(apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss, together_):
                outside = late_roots(xp, inside_, damping, l, first, last, at_one, at_minus_one,
                    loss, together_, apart_)
                return outside

            outside = select(xp, part == 0.0, yes,
                (apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss, together_),
                no, (apart_, at_minus_one, at_one, damping, first, inside_, l, last, loss,
                together_))

            good = stable(xp, outside, inside_, damping, gamma, delta)
            return good

        good = select(xp, (delta > 0.0) & (gamma > -stiffness) &
            (square_root(xp, gamma)*(d + 1.0) <= 3.141592653589793), yes, (d,), no,
            (apart_, at_minus_one, at_one, delta, first, gamma, l, last, loss, part, stiffness, t7,
            together_))

        return xp.where(good > 0.0, theta, xp.nan)

    def no(d):
        return xp.nan

    return select(xp, ((d <= 1.0) | (square_root(xp, gamma)*(d + 1.0) <= 3.141592653589793)) &
        (gamma <= 9.8), yes, (apart_, at_minus_one, at_one, d, delta, first, gamma, l, last, loss,
        part, together_), no, (d,))


def gap_single(xp, x):
    """The same in single precision."""

    def yes(x):
        near = x
        square = -(near*near)
        b6 = 2.8114572543455206e-15*square + 7.647163731819816e-13
        b6 = b6*square + 1.6059043836821613e-10
        b6 = b6*square + 2.505210838544172e-08
        b6 = b6*square + 2.7557319223985893e-06
        b6 = b6*square + 0.0001984126984126984
        b6 = b6*square + 0.008333333333333333
        rest = b6*square - 4.967053879312289e-09
        total = rest + 0.1666666716337204
        return total

    def no(x):
        whole = x
        return (x - xp.sin(x))/(whole*whole*whole)

    return select(xp, xp.abs(x) < 2.0, yes, (x,), no, (x,))


def gap(xp, x):
    """(x - sin(x))/x^3"""
    if x.dtype == xp.float32:
        return gap_single(xp, x)

    def yes(x):
        near = x
        square = -(near*near)
        b10 = 6.446950284384474e-26*square + 3.868170170630684e-23
        b10 = b10*square + 1.9572941063391263e-20
        b10 = b10*square + 8.22063524662433e-18
        b10 = b10*square + 2.8114572543455206e-15
        b10 = b10*square + 7.647163731819816e-13
        b10 = b10*square + 1.6059043836821613e-10
        b10 = b10*square + 2.505210838544172e-08
        b10 = b10*square + 2.7557319223985893e-06
        b10 = b10*square + 0.0001984126984126984
        b10 = b10*square + 0.008333333333333333
        rest = b10*square + 9.25185853854297e-18
        total = rest + 0.16666666666666666
        return total

    def no(x):
        whole = x
        return (x - xp.sin(x))/(whole*whole*whole)

    return select(xp, xp.abs(x) < 2.0, yes, (x,), no, (x,))


def sinc(xp, x):
    """sin(x)/x"""

    def yes(x):
        near = x
        return 1.0 - (near*near)*gap(xp, near)

    def no(x):
        whole = xp.where(x == 0.0, 1.0, x)
        return xp.sin(x)/whole

    return select(xp, xp.abs(x) < 1.0, yes, (x,), no, (x,))


def need(xp, alpha, beta, l, epsilon, psi):
    """the damping that the wall needs at the angle 2 psi"""

    def yes(alpha, beta, l, psi):
        early = (
            0.5*alpha*(2.0*l + 1.0)*sinc(xp, psi*(2.0*l + 1.0))/sinc(xp, psi) - beta*
            cos_next(xp, l, 2.0*psi)
        )
        return early

    def no(alpha, beta, epsilon, l, psi):
        early = (
            0.5*alpha*(2.0*l + 1.0)*sinc(xp, psi*(2.0*l + 1.0))/sinc(xp, psi) - beta*
            cos_next(xp, l, 2.0*psi)
        )
        n = early + epsilon*(0.5*alpha*(2.0*l + 3.0)*sinc(xp, psi*(2.0*l + 3.0))/sinc(xp, psi) -
            beta*cos_next(xp, l + 1.0, 2.0*psi) - early)
        root = square_root(xp, epsilon*(1.0 - epsilon)*
            ((alpha*alpha)*(xp.cos(psi)*xp.cos(psi)) + ((alpha + 2.0*beta)*(alpha + 2.0*beta))*
            (xp.sin(psi)*xp.sin(psi))) + (n*n))
        return 0.5*n + 0.5*root

    return select(xp, epsilon == 0.0, yes, (alpha, beta, l, psi), no,
        (alpha, beta, epsilon, l, psi))


def chord(xp, k, x):
    """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3"""
    turn_ = x*(k + 1.0)

    def yes(k, turn_, x):
        angle = turn_
        order = 2.0*k + 2.0
        along = cos_next(xp, k, x)
        wave = sinc(xp, 0.5*angle)
        inner = 0.5*(wave*wave) - gap(xp, angle)
        return order*(along*gap(xp, x) + 0.25*inner*(order*order))

    def no(k, x):
        some = x
        order = 2.0*k + 2.0
        along = cos_next(xp, k, x)
        return (2.0*sin_next(xp, k, x) - along*order*xp.sin(x))/(some*some*some)

    return select(xp, turn_ < 1.5, yes, (k, turn_, x), no, (k, x))


def rising(xp, alpha, beta, l, epsilon, psi):
    """has the sign of the slope of Need, at a fraction"""
    t = 2.0*psi
    t2 = 2.0*alpha/(sinc(xp, psi)*sinc(xp, psi))
    t3 = 0.5*alpha + beta
    t4 = 2.0*l
    t5 = t4 + 2.0
    t4 = t4 + 4.0
    early = t3*(t5*t5)*sinc(xp, psi*t5) - t2*chord(xp, l, t)
    steep = early + epsilon*(t3*(t4*t4)*sinc(xp, psi*t4) - early - t2*chord(xp, l + 1.0, t))
    return (
        2.0*beta*epsilon*(1.0 - epsilon)*(alpha + beta)*sinc(xp, 2.0*psi) + steep*
        need(xp, alpha, beta, l, epsilon, psi)
    )


def steepness(xp, alpha, beta, l, epsilon, psi):
    """has the sign of the slope of Need, up to the angle in phase"""

    def yes(alpha, beta, l, psi):
        t = 2.0*l + 2.0
        early = (
            (t*t)*(0.5*alpha + beta)*sinc(xp, psi*t) - 2.0*alpha*chord(xp, l, 2.0*psi)/
            (sinc(xp, psi)*sinc(xp, psi))
        )
        return early

    def no(alpha, beta, epsilon, l, psi):
        phase = (
            psi*(2.0*l + 2.0) + xp.atan2(alpha*xp.cos(psi), (alpha + 2.0*beta)*xp.sin(psi)) +
            xp.atan2(epsilon*xp.sin(2.0*psi), epsilon*xp.cos(2.0*psi) - epsilon + 1.0) -
            3.141592653589793
        )

        def yes(alpha, beta, epsilon, l, psi):
            rising_ = rising(xp, alpha, beta, l, epsilon, psi)
            return -xp.abs(rising_)

        def no(alpha, beta, epsilon, l, psi):
            rising_ = rising(xp, alpha, beta, l, epsilon, psi)
            return rising_

        return select(xp, phase > 0.0, yes, (alpha, beta, epsilon, l, psi), no,
            (alpha, beta, epsilon, l, psi))

    return select(xp, epsilon == 0.0, yes, (alpha, beta, l, psi), no,
        (alpha, beta, epsilon, l, psi))


def worst_angle_single(xp, alpha, beta, l, epsilon):
    """The same in single precision."""
    size = xp.abs(alpha) + xp.abs(beta)
    whole = xp.where(size == 0.0, 1.0, size)
    stiffness = alpha/whole
    damping = beta/whole
    above = steepness(xp, stiffness, damping, l, epsilon, xp.full_like(damping, 0.0))

    def yes(above):
        return 0.0

    def no(above, damping, epsilon, l, stiffness):
        high = 3.141592502593994/(2.0*l + 2.0)
        below = steepness(xp, stiffness, damping, l, epsilon, high)

        def yes(high):
            root = high
            return root

        def no(above, below, damping, epsilon, high, l, stiffness):

            def over(b, fb, a, fa, c, fc, damping, epsilon, l, stiffness):
                return (
                    ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                    (xp.abs(a - b) <= 7.62939453125e-06*
                    xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                )

            def step(b, fb, a, fa, c, fc, damping, epsilon, l, stiffness):
                span = c - b
                rise_ = fc - fb
                whole2 = xp.where(span == 0.0, 1.0, span)
                place = (a - b)/whole2
                whole2 = xp.where(rise_ == 0.0, 1.0, rise_)
                height = (fa - fb)/whole2
                safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                    (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                case1 = safe > 0.0
                one = xp.where(case1, fb - fa, 1.0)
                two = xp.where(case1, fb - fc, 1.0)
                three = xp.where(case1, fa - fc, 1.0)
                width = b - a
                here = fa/one
                there = fc/two
                whole2 = xp.where(width == 0.0, 1.0, width)
                other = fa/three
                last = fb/two
                guess = xp.where(case1, here*there + last*other*(c - a)/whole2, 0.5)
                edge = (
                    7.62939453125e-06*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/xp.abs(whole2)
                )
                edge = xp.where(0.5 < edge, 0.5, edge)
                share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                share = xp.where(edge > share, edge, share)
                new = a + share*width
                value = steepness(xp, stiffness, damping, l, epsilon, new)
                case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                next_b = xp.where(case2, b, a)
                next_fb = xp.where(case2, fb, fa)
                next_a = new
                next_fa = value
                next_c = xp.where(case2, a, b)
                next_fc = xp.where(case2, fa, fb)
                return next_b, next_fb, next_a, next_fa, next_c, next_fc

            b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                (0.0, above, high, below, high, below), (damping, epsilon, l, stiffness))
            root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
            return root

        root = select(xp, below >= 0.0, yes, (high,), no,
            (above, below, damping, epsilon, high, l, stiffness))

        return root

    root = select(xp, above <= 0.0, yes, (above,), no, (above, damping, epsilon, l, stiffness))

    return root


def worst_angle(xp, alpha, beta, l, epsilon):
    """half of the angle at which the wall needs most damping"""
    if alpha.dtype == xp.float32:
        return worst_angle_single(xp, alpha, beta, l, epsilon)
    size = xp.abs(alpha) + xp.abs(beta)
    whole = xp.where(size == 0.0, 1.0, size)
    stiffness = alpha/whole
    damping = beta/whole
    above = steepness(xp, stiffness, damping, l, epsilon, xp.full_like(damping, 0.0))

    def yes(above):
        return 0.0

    def no(above, damping, epsilon, l, stiffness):
        high = 3.141592653589793/(2.0*l + 2.0)
        below = steepness(xp, stiffness, damping, l, epsilon, high)

        def yes(high):
            root = high
            return root

        def no(above, below, damping, epsilon, high, l, stiffness):

            def over(b, fb, a, fa, c, fc, damping, epsilon, l, stiffness):
                return (
                    ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                    (xp.abs(a - b) <= 4.656612873077393e-10*
                    xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                )

            def step(b, fb, a, fa, c, fc, damping, epsilon, l, stiffness):
                span = c - b
                rise_ = fc - fb
                whole2 = xp.where(span == 0.0, 1.0, span)
                place = (a - b)/whole2
                whole2 = xp.where(rise_ == 0.0, 1.0, rise_)
                height = (fa - fb)/whole2
                safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                    (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                case1 = safe > 0.0
                one = xp.where(case1, fb - fa, 1.0)
                two = xp.where(case1, fb - fc, 1.0)
                three = xp.where(case1, fa - fc, 1.0)
                width = b - a
                here = fa/one
                there = fc/two
                whole2 = xp.where(width == 0.0, 1.0, width)
                other = fa/three
                last = fb/two
                guess = xp.where(case1, here*there + last*other*(c - a)/whole2, 0.5)
                edge = (
                    4.656612873077393e-10*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                    xp.abs(whole2)
                )
                edge = xp.where(0.5 < edge, 0.5, edge)
                share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                share = xp.where(edge > share, edge, share)
                new = a + share*width
                value = steepness(xp, stiffness, damping, l, epsilon, new)
                case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                next_b = xp.where(case2, b, a)
                next_fb = xp.where(case2, fb, fa)
                next_a = new
                next_fa = value
                next_c = xp.where(case2, a, b)
                next_fc = xp.where(case2, fa, fb)
                return next_b, next_fb, next_a, next_fa, next_c, next_fc

            b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                (0.0, above, high, below, high, below), (damping, epsilon, l, stiffness))
            root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
            return root

        root = select(xp, below >= 0.0, yes, (high,), no,
            (above, below, damping, epsilon, high, l, stiffness))

        return root

    root = select(xp, above <= 0.0, yes, (above,), no, (above, damping, epsilon, l, stiffness))

    return root


def largest_need(xp, alpha, beta, d):
    """the damping that the wall needs at its worst angle"""

    def yes(alpha):
        return xp.inf

    def no(alpha, beta, d):
        whole = xp.floor(d)
        part = d - whole
        psi = worst_angle(xp, alpha, beta, whole, part)
        return need(xp, alpha, beta, whole, part, psi)

    return select(xp, alpha < 0.0, yes, (alpha,), no, (alpha, beta, d))


def between(xp, share, early, late):
    """early + share (late - early)"""
    more = late - early
    return early + more*share


def lead(xp, theta, l, epsilon):
    """negative beyond the angle in phase with the delay"""

    def yes(epsilon, l, theta):
        early = sin_next(xp, l, theta)
        late = sin_next(xp, l + 1.0, theta)
        sine = early + epsilon*(late - early)
        return sine

    def no(l):
        return -1.0

    return select(xp, theta*(l + 1.0) < 4.0, yes, (epsilon, l, theta), no, (l,))


def rated(xp, number, value):
    """the value, NaN for number < 0"""
    return xp.where(number < 0.0, xp.nan, value)


def spread(xp, k, x):
    """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3"""
    turn_ = x*(k + 1.0)

    def yes(k, turn_, x):
        angle = turn_
        order = 2.0*k + 2.0
        return order*((order*order)*gap(xp, 2.0*angle) - gap(xp, x))

    def no(k, x):
        some = x
        order = 2.0*k + 2.0
        return (order*xp.sin(x) - 2.0*cos_next(xp, k, x)*sin_next(xp, k, x))/(some*some*some)

    return select(xp, turn_ < 1.5, yes, (k, turn_, x), no, (k, x))


def straight(xp, stiffness, damping, k, angle):
    """what straight motions need at a whole delay of k periods"""
    order = 2.0*k + 1.0
    wave = sinc(xp, angle*order)
    near = 2.0*sinc(xp, angle)
    total = order*wave
    order_halves = halves(xp, order)
    wave_halves = halves(xp, wave)
    lost = product_error(total, order_halves, wave_halves)
    total2 = total/near
    left = total - near*total2
    total2_halves = halves(xp, total2)
    near_halves = halves(xp, near)
    left = left - product_error(total2*near, total2_halves, near_halves)
    left = left + lost
    lost = left/near
    total = stiffness*total2
    stiffness_halves = halves(xp, stiffness)
    lost = lost*stiffness + product_error(total, stiffness_halves, total2_halves)
    along = cos_next(xp, k, 2.0*angle)
    total2 = along*damping
    damping_halves = halves(xp, damping)
    along_halves = halves(xp, along)
    lost4 = product_error(total2, damping_halves, along_halves)
    total5 = total - total2
    back = total5 - total
    rest = total5 - back
    one = total - rest
    two = -back - total2
    lost5 = one + two
    low = lost - lost4 + lost5
    return low + total5


def turn_single(xp, psi, l, epsilon):
    """The same in single precision."""
    wave2 = xp.cos(psi)
    wave3 = chord(xp, l, 2.0*psi)
    wave4 = chord(xp, l + 1.0, 2.0*psi)
    wave5 = cos_next(xp, l, 2.0*psi)
    wave6 = cos_next(xp, l + 1.0, 2.0*psi)
    wave7 = sinc(xp, psi)
    wave8 = sinc(xp, 2.0*psi)
    wave9 = sinc(xp, psi*(2.0*l + 1.0))
    wave11 = sinc(xp, psi*(2.0*l + 3.0))
    t2 = l + 1.0
    t4 = 1.0/t2
    t5 = 0.5*t4
    t6 = -t5
    t7 = epsilon*(1.0 - epsilon)
    t8 = 2.0*l
    t9 = 2.0*t4/(wave7*wave7)
    t10 = -t9*wave3
    t11 = t6*wave5
    t12 = 1.0/wave7
    t13 = wave9*(t8 + 1.0)
    t14 = t12*t5
    t15 = t13*t14
    t14 = epsilon*(t11 + t14*wave11*(t8 + 3.0) - t15 - t6*wave6)
    above = (
        -2.0*t5*t6*t7*wave8 - (epsilon*(-t10 - t9*wave4) + t10)*
        (0.25*t12*t13*t4 - 0.5*t11 + 0.5*t14 + 0.5*
        square_root(xp, ((t15 - t11 + t14)*(t15 - t11 + t14)) + t7*(wave2*wave2)/(t2*t2)))
    )

    def yes(above):
        return 0.0

    def no(above, epsilon, l, psi, wave11, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9):
        wave = xp.sin(psi)
        wave10 = sinc(xp, psi*(2.0*l + 2.0))
        wave12 = sinc(xp, psi*(2.0*l + 4.0))
        t23 = epsilon*(1.0 - epsilon)
        t24 = 2.0*l
        t26 = wave10*((t24 + 2.0)*(t24 + 2.0))
        t27 = wave5
        t32 = epsilon*(t27 - wave6)
        below = (
            -2.0*t23*wave8 - (epsilon*(wave12*((t24 + 4.0)*(t24 + 4.0)) - t26) + t26)*
            (0.5*t32 - 0.5*t27 + 0.5*square_root(xp, 4.0*t23*(wave*wave) +
            ((t32 - t27)*(t32 - t27))))
        )

        def yes(below):
            return 0.5*3.141592653589793

        def no(above, below, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3, wave4, wave5,
            wave6, wave7, wave8, wave9):

            def over(b, fb, a, fa, c, fc, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3,
                wave4, wave5, wave6, wave7, wave8, wave9):
                return (
                    ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                    (xp.abs(a - b) <= 2.384185791015625e-07*
                    xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                )

            def step(b, fb, a, fa, c, fc, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3,
                wave4, wave5, wave6, wave7, wave8, wave9):
                span = c - b
                rise_ = fc - fb
                whole = xp.where(span == 0.0, 1.0, span)
                place = (a - b)/whole
                whole = xp.where(rise_ == 0.0, 1.0, rise_)
                height = (fa - fb)/whole
                safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                    (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                case1 = safe > 0.0
                one = xp.where(case1, fb - fa, 1.0)
                two = xp.where(case1, fb - fc, 1.0)
                three = xp.where(case1, fa - fc, 1.0)
                width = b - a
                here = fa/one
                there = fc/two
                whole = xp.where(width == 0.0, 1.0, width)
                other = fa/three
                last = fb/two
                guess = xp.where(case1, here*there + last*other*(c - a)/whole, 0.5)
                edge = (
                    2.384185791015625e-07*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                    xp.abs(whole)
                )
                edge = xp.where(0.5 < edge, 0.5, edge)
                share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                share = xp.where(edge > share, edge, share)
                new = a + share*width
                t33 = xp.sin(new)
                t34 = l + 1.0
                t35 = xp.cos(new)
                t36 = t35/t34
                t37 = 0.5*t36
                t38 = t33 - t37
                t39 = epsilon*(1.0 - epsilon)
                t40 = 2.0*l
                t41 = 2.0*t36/(wave7*wave7)
                t42 = t33*wave10*((t40 + 2.0)*(t40 + 2.0)) - t41*wave3
                t43 = t38*wave5
                t44 = 1.0/wave7
                t45 = wave9*(t40 + 1.0)
                t46 = t37*t44
                t47 = t45*t46
                t46 = epsilon*(t43 - t38*wave6 + t46*wave11*(t40 + 3.0) - t47)
                value = (
                    -2.0*t38*t39*wave8*(t33 + t37) -
                    (epsilon*(t33*wave12*((t40 + 4.0)*(t40 + 4.0)) - t41*wave4 - t42) + t42)*
                    (0.25*t36*t44*t45 - 0.5*t43 + 0.5*t46 + 0.5*
                    square_root(xp, t39*(4.0*(t33*t33)*(wave*wave) + (t35*t35)*(wave2*wave2)/
                    (t34*t34)) + ((t47 - t43 + t46)*(t47 - t43 + t46))))
                )
                case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                next_b = xp.where(case2, b, a)
                next_fb = xp.where(case2, fb, fa)
                next_a = new
                next_fa = value
                next_c = xp.where(case2, a, b)
                next_fc = xp.where(case2, fa, fb)
                return next_b, next_fb, next_a, next_fa, next_c, next_fc

            b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                (0.0, above, 0.5*3.141592653589793, below, 0.5*3.141592653589793, below),
                (epsilon, l, wave, wave10, wave11, wave12, wave2, wave3, wave4, wave5, wave6,
                wave7, wave8, wave9))
            root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
            return root

        root = select(xp, below >= 0.0, yes, (below,), no,
            (above, below, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3, wave4, wave5,
            wave6, wave7, wave8, wave9))

        return root

    root = select(xp, above <= 0.0, yes, (above,), no,
        (above, epsilon, l, psi, wave11, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9))

    return root


def turn(xp, psi, l, epsilon):
    """the wall whose worst angle is 2 psi, as an angle"""
    if psi.dtype == xp.float32:
        return turn_single(xp, psi, l, epsilon)
    wave2 = xp.cos(psi)
    wave3 = chord(xp, l, 2.0*psi)
    wave4 = chord(xp, l + 1.0, 2.0*psi)
    wave5 = cos_next(xp, l, 2.0*psi)
    wave6 = cos_next(xp, l + 1.0, 2.0*psi)
    wave7 = sinc(xp, psi)
    wave8 = sinc(xp, 2.0*psi)
    wave9 = sinc(xp, psi*(2.0*l + 1.0))
    wave11 = sinc(xp, psi*(2.0*l + 3.0))
    t2 = l + 1.0
    t4 = 1.0/t2
    t5 = 0.5*t4
    t6 = -t5
    t7 = epsilon*(1.0 - epsilon)
    t8 = 2.0*l
    t9 = 2.0*t4/(wave7*wave7)
    t10 = -t9*wave3
    t11 = t6*wave5
    t12 = 1.0/wave7
    t13 = wave9*(t8 + 1.0)
    t14 = t12*t5
    t15 = t13*t14
    t14 = epsilon*(t11 + t14*wave11*(t8 + 3.0) - t15 - t6*wave6)
    above = (
        -2.0*t5*t6*t7*wave8 - (epsilon*(-t10 - t9*wave4) + t10)*
        (0.25*t12*t13*t4 - 0.5*t11 + 0.5*t14 + 0.5*
        square_root(xp, ((t15 - t11 + t14)*(t15 - t11 + t14)) + t7*(wave2*wave2)/(t2*t2)))
    )

    def yes(above):
        return 0.0

    def no(above, epsilon, l, psi, wave11, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9):
        wave = xp.sin(psi)
        wave10 = sinc(xp, psi*(2.0*l + 2.0))
        wave12 = sinc(xp, psi*(2.0*l + 4.0))
        t23 = epsilon*(1.0 - epsilon)
        t24 = 2.0*l
        t26 = wave10*((t24 + 2.0)*(t24 + 2.0))
        t27 = wave5
        t32 = epsilon*(t27 - wave6)
        below = (
            -2.0*t23*wave8 - (epsilon*(wave12*((t24 + 4.0)*(t24 + 4.0)) - t26) + t26)*
            (0.5*t32 - 0.5*t27 + 0.5*square_root(xp, 4.0*t23*(wave*wave) +
            ((t32 - t27)*(t32 - t27))))
        )

        def yes(below):
            return 0.5*3.141592653589793

        def no(above, below, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3, wave4, wave5,
            wave6, wave7, wave8, wave9):

            def over(b, fb, a, fa, c, fc, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3,
                wave4, wave5, wave6, wave7, wave8, wave9):
                return (
                    ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                    (xp.abs(a - b) <= 4.440892098500626e-16*
                    xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                )

            def step(b, fb, a, fa, c, fc, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3,
                wave4, wave5, wave6, wave7, wave8, wave9):
                span = c - b
                rise_ = fc - fb
                whole = xp.where(span == 0.0, 1.0, span)
                place = (a - b)/whole
                whole = xp.where(rise_ == 0.0, 1.0, rise_)
                height = (fa - fb)/whole
                safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                    (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                case1 = safe > 0.0
                one = xp.where(case1, fb - fa, 1.0)
                two = xp.where(case1, fb - fc, 1.0)
                three = xp.where(case1, fa - fc, 1.0)
                width = b - a
                here = fa/one
                there = fc/two
                whole = xp.where(width == 0.0, 1.0, width)
                other = fa/three
                last = fb/two
                guess = xp.where(case1, here*there + last*other*(c - a)/whole, 0.5)
                edge = (
                    4.440892098500626e-16*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                    xp.abs(whole)
                )
                edge = xp.where(0.5 < edge, 0.5, edge)
                share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                share = xp.where(edge > share, edge, share)
                new = a + share*width
                t33 = xp.sin(new)
                t34 = l + 1.0
                t35 = xp.cos(new)
                t36 = t35/t34
                t37 = 0.5*t36
                t38 = t33 - t37
                t39 = epsilon*(1.0 - epsilon)
                t40 = 2.0*l
                t41 = 2.0*t36/(wave7*wave7)
                t42 = t33*wave10*((t40 + 2.0)*(t40 + 2.0)) - t41*wave3
                t43 = t38*wave5
                t44 = 1.0/wave7
                t45 = wave9*(t40 + 1.0)
                t46 = t37*t44
                t47 = t45*t46
                t46 = epsilon*(t43 - t38*wave6 + t46*wave11*(t40 + 3.0) - t47)
                value = (
                    -2.0*t38*t39*wave8*(t33 + t37) -
                    (epsilon*(t33*wave12*((t40 + 4.0)*(t40 + 4.0)) - t41*wave4 - t42) + t42)*
                    (0.25*t36*t44*t45 - 0.5*t43 + 0.5*t46 + 0.5*
                    square_root(xp, t39*(4.0*(t33*t33)*(wave*wave) + (t35*t35)*(wave2*wave2)/
                    (t34*t34)) + ((t47 - t43 + t46)*(t47 - t43 + t46))))
                )
                case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                next_b = xp.where(case2, b, a)
                next_fb = xp.where(case2, fb, fa)
                next_a = new
                next_fa = value
                next_c = xp.where(case2, a, b)
                next_fc = xp.where(case2, fa, fb)
                return next_b, next_fb, next_a, next_fa, next_c, next_fc

            b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                (0.0, above, 0.5*3.141592653589793, below, 0.5*3.141592653589793, below),
                (epsilon, l, wave, wave10, wave11, wave12, wave2, wave3, wave4, wave5, wave6,
                wave7, wave8, wave9))
            root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
            return root

        root = select(xp, below >= 0.0, yes, (below,), no,
            (above, below, epsilon, l, wave, wave10, wave11, wave12, wave2, wave3, wave4, wave5,
            wave6, wave7, wave8, wave9))

        return root

    root = select(xp, above <= 0.0, yes, (above,), no,
        (above, epsilon, l, psi, wave11, wave2, wave3, wave4, wave5, wave6, wave7, wave8, wave9))

    return root


def touching(xp, theta, l, epsilon):
    """the wall whose worst angle is theta, as an angle, or NaN"""
    found = turn(xp, 0.5*theta, l, epsilon)
    return xp.where(found < 0.5*3.141592653589793, found, xp.nan)


def passive_angle_single(xp, l, epsilon):
    """The same in single precision."""
    low = 1e-06*3.141592653589793/(2.0*epsilon + 2.0*l + 2.0)
    turned = turn(xp, low, l, epsilon)
    wall = xp.cos(turned)/(l + 1.0)
    wall2 = xp.sin(turned) - 0.5*xp.cos(turned)/(l + 1.0)
    need_ = need(xp, wall, wall2, l, epsilon, low)
    above = (
        need_*(epsilon*(cos_next(xp, l + 1.0, 2.0*low) - cos_next(xp, l, 2.0*low)) +
        cos_next(xp, l, 2.0*low)) - epsilon*(1.0 - epsilon)*(wall + 2.0*wall2)*
        (xp.sin(low)*xp.sin(low))
    )

    def yes(low):
        root = low
        return root

    def no(above, epsilon, l, low):
        high = 3.141592653589793/(2.0*epsilon + 2.0*l + 2.0)
        turned2 = turn(xp, high, l, epsilon)
        wall3 = xp.cos(turned2)/(l + 1.0)
        wall4 = xp.sin(turned2) - 0.5*xp.cos(turned2)/(l + 1.0)
        need2 = need(xp, wall3, wall4, l, epsilon, high)
        below = (
            need2*(epsilon*(cos_next(xp, l + 1.0, 2.0*high) - cos_next(xp, l, 2.0*high)) +
            cos_next(xp, l, 2.0*high)) - epsilon*(1.0 - epsilon)*(wall3 + 2.0*wall4)*
            (xp.sin(high)*xp.sin(high))
        )

        def yes(high):
            root = high
            return root

        def no(above, below, epsilon, high, l, low):

            def over(b, fb, a, fa, c, fc, epsilon, l):
                return (
                    ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                    (xp.abs(a - b) <= 2.384185791015625e-07*
                    xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                )

            def step(b, fb, a, fa, c, fc, epsilon, l):
                span = c - b
                rise_ = fc - fb
                whole = xp.where(span == 0.0, 1.0, span)
                place = (a - b)/whole
                whole = xp.where(rise_ == 0.0, 1.0, rise_)
                height = (fa - fb)/whole
                safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                    (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                case1 = safe > 0.0
                one = xp.where(case1, fb - fa, 1.0)
                two = xp.where(case1, fb - fc, 1.0)
                three = xp.where(case1, fa - fc, 1.0)
                width = b - a
                here = fa/one
                there = fc/two
                whole = xp.where(width == 0.0, 1.0, width)
                other = fa/three
                last = fb/two
                guess = xp.where(case1, here*there + last*other*(c - a)/whole, 0.5)
                edge = (
                    2.384185791015625e-07*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                    xp.abs(whole)
                )
                edge = xp.where(0.5 < edge, 0.5, edge)
                share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                share = xp.where(edge > share, edge, share)
                new = a + share*width
                turned3 = turn(xp, new, l, epsilon)
                wall5 = xp.cos(turned3)/(l + 1.0)
                wall6 = xp.sin(turned3) - 0.5*xp.cos(turned3)/(l + 1.0)
                need3 = need(xp, wall5, wall6, l, epsilon, new)
                value = (
                    need3*(epsilon*(cos_next(xp, l + 1.0, 2.0*new) - cos_next(xp, l, 2.0*new)) +
                    cos_next(xp, l, 2.0*new)) - epsilon*(1.0 - epsilon)*(wall5 + 2.0*wall6)*
                    (xp.sin(new)*xp.sin(new))
                )
                case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                next_b = xp.where(case2, b, a)
                next_fb = xp.where(case2, fb, fa)
                next_a = new
                next_fa = value
                next_c = xp.where(case2, a, b)
                next_fc = xp.where(case2, fa, fb)
                return next_b, next_fb, next_a, next_fa, next_c, next_fc

            b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                (low, above, high, below, high, below), (epsilon, l))
            root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
            return root

        root = select(xp, below >= 0.0, yes, (high,), no, (above, below, epsilon, high, l, low))

        return root

    root = select(xp, above <= 0.0, yes, (low,), no, (above, epsilon, l, low))

    return 2.0*root


def passive_angle(xp, l, epsilon):
    """the worst angle of the stiffest passive wall, at a fraction"""
    if l.dtype == xp.float32:
        return passive_angle_single(xp, l, epsilon)
    low = 1e-06*3.141592653589793/(2.0*epsilon + 2.0*l + 2.0)
    turned = turn(xp, low, l, epsilon)
    wall = xp.cos(turned)/(l + 1.0)
    wall2 = xp.sin(turned) - 0.5*xp.cos(turned)/(l + 1.0)
    need_ = need(xp, wall, wall2, l, epsilon, low)
    above = (
        need_*(epsilon*(cos_next(xp, l + 1.0, 2.0*low) - cos_next(xp, l, 2.0*low)) +
        cos_next(xp, l, 2.0*low)) - epsilon*(1.0 - epsilon)*(wall + 2.0*wall2)*
        (xp.sin(low)*xp.sin(low))
    )

    def yes(low):
        root = low
        return root

    def no(above, epsilon, l, low):
        high = 3.141592653589793/(2.0*epsilon + 2.0*l + 2.0)
        turned2 = turn(xp, high, l, epsilon)
        wall3 = xp.cos(turned2)/(l + 1.0)
        wall4 = xp.sin(turned2) - 0.5*xp.cos(turned2)/(l + 1.0)
        need2 = need(xp, wall3, wall4, l, epsilon, high)
        below = (
            need2*(epsilon*(cos_next(xp, l + 1.0, 2.0*high) - cos_next(xp, l, 2.0*high)) +
            cos_next(xp, l, 2.0*high)) - epsilon*(1.0 - epsilon)*(wall3 + 2.0*wall4)*
            (xp.sin(high)*xp.sin(high))
        )

        def yes(high):
            root = high
            return root

        def no(above, below, epsilon, high, l, low):

            def over(b, fb, a, fa, c, fc, epsilon, l):
                return (
                    ((fa <= 0.0) & (fb <= 0.0)) | ((fa >= 0.0) & (fb >= 0.0)) |
                    (xp.abs(a - b) <= 4.440892098500626e-16*
                    xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b)))
                )

            def step(b, fb, a, fa, c, fc, epsilon, l):
                span = c - b
                rise_ = fc - fb
                whole = xp.where(span == 0.0, 1.0, span)
                place = (a - b)/whole
                whole = xp.where(rise_ == 0.0, 1.0, rise_)
                height = (fa - fb)/whole
                safe = xp.where((place < 1.0 - ((1.0 - height)*(1.0 - height))) &
                    (place > (height*height)), xp.full_like(height, 1.0), 0.0)
                case1 = safe > 0.0
                one = xp.where(case1, fb - fa, 1.0)
                two = xp.where(case1, fb - fc, 1.0)
                three = xp.where(case1, fa - fc, 1.0)
                width = b - a
                here = fa/one
                there = fc/two
                whole = xp.where(width == 0.0, 1.0, width)
                other = fa/three
                last = fb/two
                guess = xp.where(case1, here*there + last*other*(c - a)/whole, 0.5)
                edge = (
                    4.440892098500626e-16*xp.abs(xp.where(xp.abs(fa) < xp.abs(fb), a, b))/
                    xp.abs(whole)
                )
                edge = xp.where(0.5 < edge, 0.5, edge)
                share = xp.where(guess < 1.0 - edge, guess, 1.0 - edge)
                share = xp.where(edge > share, edge, share)
                new = a + share*width
                turned3 = turn(xp, new, l, epsilon)
                wall5 = xp.cos(turned3)/(l + 1.0)
                wall6 = xp.sin(turned3) - 0.5*xp.cos(turned3)/(l + 1.0)
                need3 = need(xp, wall5, wall6, l, epsilon, new)
                value = (
                    need3*(epsilon*(cos_next(xp, l + 1.0, 2.0*new) - cos_next(xp, l, 2.0*new)) +
                    cos_next(xp, l, 2.0*new)) - epsilon*(1.0 - epsilon)*(wall5 + 2.0*wall6)*
                    (xp.sin(new)*xp.sin(new))
                )
                case2 = ((fa < 0.0) & (value < 0.0)) | ((fa > 0.0) & (value > 0.0))
                next_b = xp.where(case2, b, a)
                next_fb = xp.where(case2, fb, fa)
                next_a = new
                next_fa = value
                next_c = xp.where(case2, a, b)
                next_fc = xp.where(case2, fa, fb)
                return next_b, next_fb, next_a, next_fa, next_c, next_fc

            b, fb, a, fa, c, fc = repeat(xp, 120, over, step,
                (low, above, high, below, high, below), (epsilon, l))
            root = xp.where(xp.abs(fa) < xp.abs(fb), a, b)
            return root

        root = select(xp, below >= 0.0, yes, (high,), no, (above, below, epsilon, high, l, low))

        return root

    root = select(xp, above <= 0.0, yes, (low,), no, (above, epsilon, l, low))

    return 2.0*root


@by_value
def discretize(gamma, delta):
    """the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m.

    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    Domain: gamma >= 0, delta >= 0.
    NaN outside, and where an argument is NaN or larger than 1e70.
    """
    xp, gamma, delta = arrays(gamma, delta)
    most = limits(xp, gamma)

    def work(gamma, delta):
        fall_of, rise_of, swing_of = fall_rise_swing(xp, gamma, delta)
        return rise_of, fall_of, swing_of, xp.exp(-delta)

    def inside(gamma, delta):
        return ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0))

    return guarded(xp, work, inside, 4, math.nan, gamma, delta)


@by_value
def discretize_late(gamma, delta, epsilon):
    """the sampled device behind a delay of epsilon periods, P(z) = (m2 z^2 + m1 z + m0)/(z (z^2

    - a z + e)) in units of T^2/m.
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    epsilon: rest of a delay, a fraction of a period [1]
    Domain: gamma >= 0, delta >= 0, 0 <= epsilon < 1.
    NaN outside, and where an argument is NaN or larger than 1e70.
    """
    xp, gamma, delta, epsilon = arrays(gamma, delta, epsilon)
    most = limits(xp, gamma)

    def plant(gamma, delta):
        swing_of, together_of = swing_together(xp, gamma, delta)
        return swing_of, together_of

    def inside(gamma, delta):
        return ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0))

    swing_of, together_of = guarded(xp, plant, inside, 2, math.nan, gamma, delta)

    def work(gamma, delta, epsilon, swing_of, together_of):
        t0 = 1.0 - epsilon
        t1 = (t0*t0)
        t0 = delta*t0
        rise_of = rise(xp, gamma*t1, t0)
        t1 = rise_of*t1
        t4 = (epsilon*epsilon)
        fall_of = fall(xp, gamma*t4, delta*epsilon)
        t4 = fall_of*t4*xp.exp(-t0)
        return t1, together_of - t1 - t4, t4, swing_of, xp.exp(-delta)

    def inside(gamma, delta, epsilon, swing_of, together_of):
        return (
            ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0)) &
            ((epsilon < 1.0) & (epsilon >= 0.0)) & ~xp.isnan(swing_of)
        )

    return guarded(xp, work, inside, 5, math.nan, gamma, delta, epsilon, swing_of, together_of)


@by_value
def is_stable(alpha, beta, gamma, delta, d):
    """whether all characteristic roots lie inside the unit circle.

    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: gamma >= 0, delta >= 0, d >= 0, no 0 < delta < 5 ulp(1) where sqrt(gamma) is a whole
    multiple of pi, rounded.
    False outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, alpha, beta, gamma, delta, d = arrays(alpha, beta, gamma, delta, d)
    most = limits(xp, alpha)

    def plant(gamma, delta):
        apart_of, fall_of2, nyquist_of, rise_of3, together_of = (
            apart_fall_nyquist_rise_together(xp, gamma, delta)
        )
        t1 = gamma*together_of
        t3 = delta*decay(xp, delta)
        return apart_of, fall_of2, nyquist_of, rise_of3, together_of, t1, t3

    def inside(gamma, delta):
        return ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0))

    apart_of, fall_of2, nyquist_of, rise_of3, together_of, t1, t3 = (
        guarded(xp, plant, inside, 7, math.nan, gamma, delta)
    )

    def work(alpha, beta, gamma, delta, d, apart_of, fall_of2, nyquist_of, rise_of3, together_of,
        t1, t3):

        def yes(alpha, apart_of, beta, d, delta, fall_of2, gamma, nyquist_of, rise_of3, t1, t3,
            together_of):
            return stable(xp, whole_roots(xp, alpha, beta, d, rise_of3, fall_of2, t1, nyquist_of,
                t3, together_of, apart_of*delta), alpha, beta, gamma, delta) != 0.0

        def no(alpha, beta, d, delta, gamma, nyquist_of, t1, t3, together_of):
            t4 = some_part(xp, d)
            t5 = 1.0 - t4
            t6 = (t5*t5)
            t7 = gamma*t6
            t8 = delta*t5
            apart_of3, fall_of3, kick_of2, kick_low_of2, rise_of = (
                apart_fall_kick_kick_low_rise(xp, t7, t8)
            )
            t10 = (t4*t4)
            t11 = gamma*t10
            t12 = delta*t4
            apart_of2, fall_of, kick_of, kick_low_of, rise_of2 = (
                apart_fall_kick_kick_low_rise(xp, t11, t12)
            )
            t13 = fall_of*t10
            return stable(xp, late_roots(xp, alpha, beta, whole_part(xp, d), rise_of*t6, t13*
                xp.exp(-t8), t1, nyquist_of, t3, together_of,
                late_apart(xp, t4, kick_of2, kick_low_of2, kick_of, kick_low_of, apart_of3*delta*
                (t5*t5*t5), apart_of2*delta*(t4*t4*t4), fall_of3*t6*(kick_of*t12 + rise_of2*t11) +
                rise_of*rise_of2*t10*t7 - t13*t8*decay(xp, t8))), alpha, beta, gamma, delta) != 0.0

        return select(xp, late_part(xp, d) == 0.0, yes,
            (alpha, apart_of, beta, d, delta, fall_of2, gamma, nyquist_of, rise_of3, t1, t3,
            together_of), no, (alpha, beta, d, delta, gamma, nyquist_of, t1, t3, together_of))

    def inside(alpha, beta, gamma, delta, d, apart_of, fall_of2, nyquist_of, rise_of3, together_of,
        t1, t3):
        return (
            (xp.abs(alpha) <= most.size) & (xp.abs(beta) <= most.size) &
            ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0)) &
            ((d <= most.periods) & (d >= 0.0)) & ~xp.isnan(apart_of)
        )

    return guarded(xp, work, inside, 1, False, alpha, beta, gamma, delta, d, apart_of, fall_of2,
        nyquist_of, rise_of3, together_of, t1, t3)


@by_value
def unstable_roots(alpha, beta, gamma, delta, d):
    """number of characteristic roots outside the unit circle.

    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: gamma >= 0, delta >= 0, d >= 0, no 0 < delta < 5 ulp(1) where sqrt(gamma) is a whole
    multiple of pi, rounded.
    -1 outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, alpha, beta, gamma, delta, d = arrays(alpha, beta, gamma, delta, d)
    most = limits(xp, alpha)

    def plant(gamma, delta):
        apart_of, fall_of2, nyquist_of, rise_of3, together_of = (
            apart_fall_nyquist_rise_together(xp, gamma, delta)
        )
        t1 = gamma*together_of
        t3 = delta*decay(xp, delta)
        return apart_of, fall_of2, nyquist_of, rise_of3, together_of, t1, t3

    def inside(gamma, delta):
        return ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0))

    apart_of, fall_of2, nyquist_of, rise_of3, together_of, t1, t3 = (
        guarded(xp, plant, inside, 7, math.nan, gamma, delta)
    )

    def work(alpha, beta, gamma, delta, d, apart_of, fall_of2, nyquist_of, rise_of3, together_of,
        t1, t3):

        def yes(alpha, apart_of, beta, d, delta, fall_of2, nyquist_of, rise_of3, t1, t3,
            together_of):
            return whole_roots(xp, alpha, beta, d, rise_of3, fall_of2, t1, nyquist_of, t3,
                together_of, apart_of*delta)

        def no(alpha, beta, d, delta, gamma, nyquist_of, t1, t3, together_of):
            t4 = some_part(xp, d)
            t5 = 1.0 - t4
            t6 = (t5*t5)
            t7 = gamma*t6
            t8 = delta*t5
            apart_of3, fall_of3, kick_of2, kick_low_of2, rise_of = (
                apart_fall_kick_kick_low_rise(xp, t7, t8)
            )
            t10 = (t4*t4)
            t11 = gamma*t10
            t12 = delta*t4
            apart_of2, fall_of, kick_of, kick_low_of, rise_of2 = (
                apart_fall_kick_kick_low_rise(xp, t11, t12)
            )
            t13 = fall_of*t10
            return late_roots(xp, alpha, beta, whole_part(xp, d), rise_of*t6, t13*xp.exp(-t8), t1,
                nyquist_of, t3, together_of, late_apart(xp, t4, kick_of2, kick_low_of2, kick_of,
                kick_low_of, apart_of3*delta*(t5*t5*t5), apart_of2*delta*(t4*t4*t4), fall_of3*t6*
                (kick_of*t12 + rise_of2*t11) + rise_of*rise_of2*t10*t7 - t13*t8*decay(xp, t8)))

        return select(xp, late_part(xp, d) == 0.0, yes,
            (alpha, apart_of, beta, d, delta, fall_of2, nyquist_of, rise_of3, t1, t3, together_of),
            no, (alpha, beta, d, delta, gamma, nyquist_of, t1, t3, together_of))

    def inside(alpha, beta, gamma, delta, d, apart_of, fall_of2, nyquist_of, rise_of3, together_of,
        t1, t3):
        return (
            (xp.abs(alpha) <= most.size) & (xp.abs(beta) <= most.size) &
            ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0)) &
            ((d <= most.periods) & (d >= 0.0)) & ~xp.isnan(apart_of)
        )

    return guarded(xp, work, inside, 1, -1, alpha, beta, gamma, delta, d, apart_of, fall_of2,
        nyquist_of, rise_of3, together_of, t1, t3)


@by_value
def stability_boundary(theta, gamma, delta, d):
    """the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).

    theta: angle on the unit circle, omega T [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, theta, gamma, delta, d = arrays(theta, gamma, delta, d)
    most = limits(xp, theta)

    def plant(gamma, delta):
        apart_of, nyquist_of, together_of = apart_nyquist_together(xp, gamma, delta)
        t3 = gamma*together_of
        t5 = delta*decay(xp, delta)
        t6 = apart_of*delta
        t7 = t6 + together_of
        return nyquist_of, together_of, t3, t5, t6, t7

    def inside(gamma, delta):
        return ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0))

    nyquist_of, together_of, t3, t5, t6, t7 = guarded(xp, plant, inside, 6, math.nan, gamma, delta)

    def work(theta, gamma, delta, d, nyquist_of, together_of, t3, t5, t6, t7):

        def yes(d, nyquist_of, t3, t5, t6, t7, theta, together_of):
            cos_next_of, sin_next_of = cos_next_sin_next(xp, d, theta)
            t1 = 0.5*theta
            ahead_of, in_phase_of = ahead_in_phase(xp, t1, t3, nyquist_of, t5, together_of, t6, t7)
            t1 = xp.tan(t1)
            t12 = ahead_of*cos_next_of + in_phase_of*sin_next_of
            t13 = xp.sin(theta)
            return ahead_of*sin_next_of - cos_next_of*in_phase_of + t1*t12, -t12/t13

        def no(d, delta, gamma, nyquist_of, t3, t5, theta, together_of):
            t1 = 0.5*theta
            t11 = xp.tan(t1)
            t13 = xp.sin(theta)
            t14 = whole_part(xp, d)
            cos_next_of2, sin_next_of2 = cos_next_sin_next(xp, t14, theta)
            t16 = some_part(xp, d)
            t17 = 1.0 - t16
            t18 = (t17*t17)
            t19 = gamma*t18
            t20 = delta*t17
            apart_of2, fall_of2, kick_of2, kick_low_of, rise_of2 = (
                apart_fall_kick_kick_low_rise(xp, t19, t20)
            )
            t21 = (t16*t16)
            t22 = gamma*t21
            t23 = delta*t16
            apart_of3, fall_of, kick_of, kick_low_of2, rise_of = (
                apart_fall_kick_kick_low_rise(xp, t22, t23)
            )
            t25 = fall_of*t21
            t23 = late_apart(xp, t16, kick_of2, kick_low_of, kick_of, kick_low_of2, apart_of2*delta*
                (t17*t17*t17), apart_of3*delta*(t16*t16*t16), fall_of2*t18*
                (kick_of*t23 + rise_of*t22) + rise_of*rise_of2*t19*t21 - t20*t25*decay(xp, t20))
            t25 = 2.0*rise_of2*t18 - 2.0*t25*xp.exp(-t20)
            ahead_of2, in_phase_of2 = ahead_in_phase(xp, t1, t3, nyquist_of, t5, together_of, t23,
                t25)
            t20 = ahead_of2*cos_next_of2 + in_phase_of2*sin_next_of2
            return ahead_of2*sin_next_of2 - cos_next_of2*in_phase_of2 + t11*t20, -t20/t13

        return select(xp, late_part(xp, d) == 0.0, yes,
            (d, nyquist_of, t3, t5, t6, t7, theta, together_of), no,
            (d, delta, gamma, nyquist_of, t3, t5, theta, together_of))

    def inside(theta, gamma, delta, d, nyquist_of, together_of, t3, t5, t6, t7):
        return (
            ((theta <= most.angle) & (theta > 0.0)) & ((gamma <= most.size) & (gamma >= 0.0)) &
            ((delta <= most.size) & (delta >= 0.0)) & ((d <= most.periods) & (d >= 0.0)) &
            ~xp.isnan(nyquist_of)
        )

    return guarded(xp, work, inside, 2, math.nan, theta, gamma, delta, d, nyquist_of, together_of,
        t3, t5, t6, t7)


@by_value
def max_stable_stiffness(gamma, delta, d):
    """the wall of largest stable stiffness, a limit that is not stable itself, and the angle

    theta = omega T of its roots on the unit circle.
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: gamma >= 0, delta >= 0, d >= 0, gamma <= 9.8, sqrt(gamma) (d + 1) <= pi or d <= 1,
    no 0 < delta < 5 ulp(1) if sqrt(gamma) (d + 1) > pi, NaN elsewhere and where no wall is
    stable.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, gamma, delta, d = arrays(gamma, delta, d)
    most = limits(xp, gamma)

    def plant(gamma, delta):
        apart_of, fall_of, nyquist_of, rise_of, together_of = (
            apart_fall_nyquist_rise_together(xp, gamma, delta)
        )
        t1 = gamma*together_of
        t3 = delta*decay(xp, delta)
        t4 = apart_of*delta
        t10 = t4 + together_of
        t16 = 2.0*t3
        return fall_of, nyquist_of, rise_of, together_of, t1, t3, t4, t10, t16

    def inside(gamma, delta):
        return ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0))

    fall_of, nyquist_of, rise_of, together_of, t1, t3, t4, t10, t16 = (
        guarded(xp, plant, inside, 9, math.nan, gamma, delta)
    )

    def work(gamma, delta, d, fall_of, nyquist_of, rise_of, together_of, t1, t3, t4, t10, t16):

        def yes(d, delta, fall_of, gamma, nyquist_of, rise_of, t1, t10, t16, t3, t4, together_of):
            t5 = stiffest_angle(xp, gamma, delta, d, d, xp.full_like(d, 0.0), rise_of, fall_of, t1,
                nyquist_of, t3, together_of, t4)
            cos_next_of, sin_next_of = cos_next_sin_next(xp, d, t5)
            t7 = 0.5*t5
            t8 = xp.sin(t7)
            t7 = xp.cos(t7)
            t11 = (t7*t7)
            t12 = (t8*t8)
            t13 = t11*t12
            t14 = t11*together_of - t12*t4
            t15 = 1.0/((t10*t10)*t13 + (t14*t14))
            t11 = t1*t11 - nyquist_of*t12
            t18 = t14*t16 - t10*t11
            t11 = t10*t13*t16 + t14*t11
            t14 = cos_next_of*t15
            t13 = -sin_next_of*t15*t11/xp.sin(t5) - 0.5*t18*t14
            return sin_next_of*t15*t18*t8*t7 - 2.0*t12*t13 - t11*t14, t13, t5

        def no(d, delta, gamma, nyquist_of, t1, t16, t3, together_of):
            t22 = whole_part(xp, d)
            t23 = some_part(xp, d)
            t24 = 1.0 - t23
            t25 = (t24*t24)
            t26 = gamma*t25
            t27 = delta*t24
            apart_of2, fall_of3, kick_of2, kick_low_of, rise_of2 = (
                apart_fall_kick_kick_low_rise(xp, t26, t27)
            )
            t29 = rise_of2*t25
            t30 = (t23*t23)
            t31 = gamma*t30
            t32 = delta*t23
            apart_of3, fall_of2, kick_of, kick_low_of2, rise_of3 = (
                apart_fall_kick_kick_low_rise(xp, t31, t32)
            )
            t33 = fall_of2*t30
            t34 = t33*xp.exp(-t27)
            t33 = late_apart(xp, t23, kick_of2, kick_low_of, kick_of, kick_low_of2, apart_of2*delta*
                (t24*t24*t24), apart_of3*delta*(t23*t23*t23), fall_of3*t25*
                (kick_of*t32 + rise_of3*t31) + rise_of2*rise_of3*t26*t30 - t27*t33*decay(xp, t27))
            t23 = stiffest_angle(xp, gamma, delta, d, t22, t23, t29, t34, t1, nyquist_of, t3,
                together_of, t33)
            cos_next_of2, sin_next_of2 = cos_next_sin_next(xp, t22, t23)
            t32 = 0.5*t23
            t31 = xp.sin(t32)
            t32 = xp.cos(t32)
            t34 = 2.0*t29 - 2.0*t34
            t29 = (t32*t32)
            t30 = (t31*t31)
            t27 = t29*t30
            t33 = t29*together_of - t33*t30
            t26 = 1.0/((t34*t34)*t27 + (t33*t33))
            t29 = t1*t29 - nyquist_of*t30
            t25 = t16*t33 - t34*t29
            t29 = t16*t34*t27 + t33*t29
            t33 = cos_next_of2*t26
            t27 = -sin_next_of2*t26*t29/xp.sin(t23) - 0.5*t25*t33
            return sin_next_of2*t31*t32*t26*t25 - 2.0*t30*t27 - t29*t33, t27, t23

        return select(xp, late_part(xp, d) == 0.0, yes,
            (d, delta, fall_of, gamma, nyquist_of, rise_of, t1, t10, t16, t3, t4, together_of), no,
            (d, delta, gamma, nyquist_of, t1, t16, t3, together_of))

    def inside(gamma, delta, d, fall_of, nyquist_of, rise_of, together_of, t1, t3, t4, t10, t16):
        return (
            ((gamma <= most.size) & (gamma >= 0.0)) & ((delta <= most.size) & (delta >= 0.0)) &
            ((d <= most.periods) & (d >= 0.0)) & ~xp.isnan(fall_of)
        )

    return guarded(xp, work, inside, 3, math.nan, gamma, delta, d, fall_of, nyquist_of, rise_of,
        together_of, t1, t3, t4, t10, t16)


@by_value
def passivity_margin_at(theta, alpha, beta, delta, d):
    """physical damping minus the damping that the wall needs at the angle theta = omega T; the

    wall is passive where it is positive at every angle.
    theta: angle on the unit circle, omega T [1]
    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, delta >= 0, d >= 0, d whole, or fractional on the principal sheet.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, theta, alpha, beta, delta, d = arrays(theta, alpha, beta, delta, d)
    most = limits(xp, theta)

    def work(theta, alpha, beta, delta, d):
        t0 = 0.5*theta
        cos_next_of = cos_next(xp, d, theta)
        sin_next_of = sin_next(xp, 2.0*d, t0)
        return beta*cos_next_of - 0.5*alpha*sin_next_of/xp.sin(t0) + delta

    def inside(theta, alpha, beta, delta, d):
        return (
            ((theta <= most.angle) & (theta > 0.0)) & (xp.abs(alpha) <= most.size) &
            (xp.abs(beta) <= most.size) & ((delta <= most.size) & (delta >= 0.0)) &
            ((d <= most.periods) & (d >= 0.0))
        )

    return guarded(xp, work, inside, 1, math.nan, theta, alpha, beta, delta, d)


@by_value
def passivity_margin(alpha, beta, delta, d):
    """physical damping minus the damping that the wall needs at its worst angle; the wall is

    passive where it is not negative.
    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0, -inf for alpha < 0.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, alpha, beta, delta, d = arrays(alpha, beta, delta, d)
    most = limits(xp, alpha)

    def work(alpha, beta, delta, d):
        return delta - largest_need(xp, alpha, beta, d)

    def inside(alpha, beta, delta, d):
        return (
            (xp.abs(alpha) <= most.size) & (xp.abs(beta) <= most.size) &
            ((delta <= most.size) & (delta >= 0.0)) & ((d <= most.periods) & (d >= 0.0))
        )

    return guarded(xp, work, inside, 1, math.nan, alpha, beta, delta, d)


@by_value
def passivity_boundary(theta, delta, d):
    """the wall that is just passive and whose worst angle is theta = omega T.

    theta: angle on the unit circle, omega T [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, delta >= 0, d >= 0, NaN beyond the angle where alpha is 0: pi/(d +
    1) for whole delays, for d <= 2/9 the curve goes on to pi.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, theta, delta, d = arrays(theta, delta, d)
    most = limits(xp, theta)

    def work(theta, delta, d):

        def yes(d, delta, theta):
            t0 = lead(xp, theta, d, xp.full_like(d, 0.0))
            t1 = delta/spread(xp, d, theta)
            t2 = 0.5*theta
            t2 = sinc(xp, t2)
            sin_next_of = sin_next(xp, d, theta)
            t2 = sin_next_of*(t2*t2)*(d + 1.0)/theta
            return rated(xp, t0, 2.0*t1*t2), rated(xp, t0, t1*(chord(xp, d, theta) - t2))

        def no(d, delta, theta):
            t2 = 0.5*theta
            t4 = whole_part(xp, d)
            t5 = some_part(xp, d)
            t6 = lead(xp, theta, t4, t5)
            t7 = t4 + 1.0
            t8 = touching(xp, theta, t4, t5)
            t9 = xp.cos(t8)
            t10 = t9/t7
            t8 = xp.sin(t8)
            t12 = t8 - 0.5*t10
            t4 = between(xp, t5, straight(xp, t10, t12, t4, t2), straight(xp, t10, t12, t7, t2))
            t16 = xp.sin(t2)
            t2 = xp.cos(t2)
            t2 = delta/(0.5*t4 + 0.5*square_root(xp, (t4*t4) + t5*(1.0 - t5)*
                (4.0*(t8*t8)*(t16*t16) + (t2*t2)*(t9*t9)/(t7*t7))))
            return rated(xp, t6, t10*t2), rated(xp, t6, t12*t2)

        return select(xp, late_part(xp, d) == 0.0, yes, (d, delta, theta), no, (d, delta, theta))

    def inside(theta, delta, d):
        return (
            ((theta <= most.angle) & (theta > 0.0)) & ((delta <= most.size) & (delta >= 0.0)) &
            ((d <= most.periods) & (d >= 0.0))
        )

    return guarded(xp, work, inside, 2, math.nan, theta, delta, d)


@by_value
def max_passive_stiffness(delta, d):
    """the passive wall of largest stiffness, and its worst angle theta = omega T.

    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, delta, d = arrays(delta, d)
    most = limits(xp, delta)

    def work(delta, d):

        def yes(d, delta):
            t0 = 3.141592653589793/(d + 1.0)
            t1 = xp.tan(0.25*t0)
            t0 = 0.5*t0
            return 2.0*delta*t1, delta*(2.0/(3.141592653589793*sinc(xp, t0)) - t1), t0

        def no(d, delta):
            t3 = whole_part(xp, d)
            t4 = t3 + 1.0
            t5 = some_part(xp, d)
            t6 = passive_angle(xp, t3, t5)
            t7 = touching(xp, t6, t3, t5)
            t8 = xp.cos(t7)
            t9 = t8/t4
            t7 = xp.sin(t7)
            t11 = t7 - 0.5*t9
            t12 = 0.5*t6
            t3 = between(xp, t5, straight(xp, t9, t11, t3, t12), straight(xp, t9, t11, t4, t12))
            t15 = xp.sin(t12)
            t12 = xp.cos(t12)
            t12 = delta/(0.5*t3 + 0.5*square_root(xp, (t3*t3) + t5*(1.0 - t5)*
                (4.0*(t7*t7)*(t15*t15) + (t12*t12)*(t8*t8)/(t4*t4))))
            return t12*t9, t11*t12, t6

        return select(xp, late_part(xp, d) == 0.0, yes, (d, delta), no, (d, delta))

    def inside(delta, d):
        return ((delta <= most.size) & (delta >= 0.0)) & ((d <= most.periods) & (d >= 0.0))

    return guarded(xp, work, inside, 3, math.nan, delta, d)


@by_value
def linear_limit(beta, delta, d):
    """the stiffness alpha at which the linear condition is an equality.

    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0.
    NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.
    """
    xp, beta, delta, d = arrays(beta, delta, d)
    most = limits(xp, beta)

    def work(beta, delta, d):
        return (beta + delta)/(d + 0.5)

    def inside(beta, delta, d):
        return (
            (xp.abs(beta) <= most.size) & ((delta <= most.size) & (delta >= 0.0)) &
            ((d <= most.periods) & (d >= 0.0))
        )

    return guarded(xp, work, inside, 1, math.nan, beta, delta, d)
