# Written by `symhaptic kernels` from the stable forms; do not edit.
"""Passivity and stability of haptic walls."""

import math
import sys

import numpy
from array_api_compat import (
    array_namespace,
    device,
    is_array_api_obj,
    is_lazy_array,
    is_numpy_array,
    is_torch_array,
)

BLOCK = 8192
"""Elements of NumPy arrays worked on at a time: so many fit the caches."""


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
    if is_torch_array(x):
        return sys.modules["torch"].compiler.is_compiling()
    return is_lazy_array(x)


def elementwise(xp, work, *values):
    """What ``work`` makes of arrays that are broadcast; NaN gives NaN.

    It gets flat ones, of one element where there is but one, unless numbers cannot be looked at.
    """
    shape = numpy.broadcast_shapes(*(tuple(v.shape) for v in values))
    if deferred(values[0]):
        results = _without_nan(xp, work, values)
        results = [xp.broadcast_to(r, shape) for r in results]
        return results[0] if len(results) == 1 else tuple(results)
    size = math.prod(shape)
    flat = [xp.reshape(_stretched(xp, v, shape), (-1,)) for v in values]
    if size <= BLOCK or not is_numpy_array(values[0]):
        found = [xp.broadcast_to(r, (size,)) for r in _without_nan(xp, work, flat)]
    else:
        found = None
        for begin in range(0, size, BLOCK):
            part = slice(begin, begin + BLOCK)
            rows = _without_nan(xp, work, [v if v.shape[0] == 1 else v[part] for v in flat])
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


def select(xp, condition, yes, yes_values, no, no_values):
    """``yes`` of its values where the condition holds, else ``no``; each only where it counts.

    Where numbers cannot be looked at, both are computed everywhere, of 1 where they do not count.
    """
    if deferred(condition):
        one = yes(*(xp.where(condition, v, 1.0) for v in yes_values))
        return xp.where(condition, one, no(*(xp.where(condition, 1.0, v) for v in no_values)))
    size = condition.shape[0]
    count = int(xp.count_nonzero(condition))
    if count == size:
        return yes(*yes_values)
    if count == 0:
        return no(*no_values)
    found = xp.empty_like(condition, dtype=(*yes_values, *no_values)[0].dtype)
    for where, work, values in ((condition, yes, yes_values), (~condition, no, no_values)):
        (at,) = xp.nonzero(where)
        found[where] = work(*(v if v.shape[0] == 1 else xp.take(v, at) for v in values))
    return found


def square_root(xp, x):
    """The root; of 0 with the slope 0, where slopes may be asked for."""
    if not deferred(x):
        return xp.sqrt(x)
    positive = x > 0
    return xp.where(positive, xp.sqrt(xp.where(positive, x, 1.0)), 0.0)


def halves(xp, y):
    """A number as two of half its digits, whose products are exact."""
    big = (134217729.0 if y.dtype == xp.float64 else 4097.0)*y
    high = big - (big - y)
    return high, y - high


def product_error(product, one, two):
    """What a product misses, by Dekker, from the halves of its factors."""
    (high, low), (most, least) = one, two
    return ((high*most - product) + high*least + low*most) + low*least


def fall_series(xp, gamma, delta):
    """divided difference of exp at 0, p and q, less 1/2"""
    b32 = 9.67759295863189e-41*delta + 3.387157535521162e-39
    b31 = b32*delta - 9.67759295863189e-41*gamma + 1.151633562077195e-37
    b32 = b31*delta - b32*gamma + 3.8003907548547434e-36
    b31 = b32*delta - b31*gamma + 1.216125041553518e-34
    b32 = b31*delta - b32*gamma + 3.7699876288159054e-33
    b31 = b32*delta - b31*gamma + 1.1309962886447716e-31
    b32 = b31*delta - b32*gamma + 3.279889237069838e-30
    b31 = b32*delta - b31*gamma + 9.183689863795546e-29
    b32 = b31*delta - b32*gamma + 2.4795962632247976e-27
    b31 = b32*delta - b31*gamma + 6.446950284384474e-26
    b32 = b31*delta - b32*gamma + 1.6117375710961184e-24
    b31 = b32*delta - b31*gamma + 3.868170170630684e-23
    b32 = b31*delta - b32*gamma + 8.896791392450574e-22
    b31 = b32*delta - b31*gamma + 1.9572941063391263e-20
    b32 = b31*delta - b32*gamma + 4.110317623312165e-19
    b31 = b32*delta - b31*gamma + 8.22063524662433e-18
    b32 = b31*delta - b32*gamma + 1.5619206968586225e-16
    b31 = b32*delta - b31*gamma + 2.8114572543455206e-15
    b32 = b31*delta - b32*gamma + 4.779477332387385e-14
    b31 = b32*delta - b31*gamma + 7.647163731819816e-13
    b32 = b31*delta - b32*gamma + 1.1470745597729725e-11
    b31 = b32*delta - b31*gamma + 1.6059043836821613e-10
    b32 = b31*delta - b32*gamma + 2.08767569878681e-09
    b31 = b32*delta - b31*gamma + 2.505210838544172e-08
    b32 = b31*delta - b32*gamma + 2.755731922398589e-07
    b31 = b32*delta - b31*gamma + 2.7557319223985893e-06
    b32 = b31*delta - b32*gamma + 2.48015873015873e-05
    b31 = b32*delta - b31*gamma + 0.0001984126984126984
    b32 = b31*delta - b32*gamma + 0.001388888888888889
    total = b32*delta
    delta_halves = halves(xp, delta)
    b32_halves = halves(xp, b32)
    lost = product_error(total, delta_halves, b32_halves)
    total2 = b31*gamma
    gamma_halves = halves(xp, gamma)
    b31_halves = halves(xp, b31)
    lost2 = product_error(total2, gamma_halves, b31_halves)
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
    total = b32*gamma
    lost3 = product_error(total, gamma_halves, b32_halves)
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


def motion(xp, gamma, delta):
    """w = delta^2/4 - gamma and both poles, to twice the precision of a float"""
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
    size = xp.abs(total2)
    root = square_root(xp, size)
    sign_low = xp.where(total2 < 0.0, -lost, lost)
    left = size - (root*root)
    root_halves = halves(xp, root)
    left = left - product_error(root*root, root_halves, root_halves)
    left = left + sign_low
    whole = xp.where(root == 0.0, 1.0, root)
    root_low = 0.5*left/whole
    total = half + root
    back = total - half
    lost = root - back
    p_low = lost + root_low
    whole2 = xp.where(total == 0.0, 1.0, total)
    q = gamma/whole2
    off = gamma - q*whole2
    whole2_halves = halves(xp, whole2)
    q_halves = halves(xp, q)
    off = off - product_error(whole2*q, whole2_halves, q_halves)
    off = off - p_low*q
    q_low = off/whole2
    return half, total2, root, whole, root_low, total, p_low, whole2, q, q_low


def fall(xp, gamma, delta, half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low):
    """n0, the same device with its time reversed, times exp(-delta)"""
    reach = xp.where(total2 < 0.0, 0.25*gamma, 0.4444444444444444*total3)

    def yes(delta, gamma, reach):
        case1 = reach >= 1.0
        rest6 = fall_series(xp, xp.where(case1, 0.0, gamma), xp.where(case1, 0.0, delta))
        total16 = rest6 + 0.5
        back7 = total16 - 0.5
        lost16 = rest6 - back7
        envelope2 = xp.exp(-delta)
        total17 = envelope2*total16
        envelope2_halves = halves(xp, envelope2)
        total16_halves = halves(xp, total16)
        lost16 = envelope2*lost16 + product_error(total17, envelope2_halves, total16_halves)
        return lost16 + total17

    def no(gamma, half, p_low, q, q_low, root, root_low, total2, whole, whole2):

        def yes(gamma, half, root, root_low, whole):
            sine = xp.sin(root)
            cosine = xp.cos(root)
            low = -root_low*sine
            total10 = half*sine
            half_halves = halves(xp, half)
            sine_halves = halves(xp, sine)
            lost10 = cosine*half*root_low + product_error(total10, half_halves, sine_halves)
            total11 = total10/whole
            left13 = total10 - total11*whole
            total11_halves = halves(xp, total11)
            whole_halves = halves(xp, whole)
            left13 = left13 - product_error(total11*whole, total11_halves, whole_halves)
            left13 = left13 + lost10 - root_low*total11
            lost10 = left13/whole
            envelope = xp.exp(-half)
            total10 = total11 - cosine
            back5 = total10 - total11
            rest4 = total10 - back5
            one3 = total11 - rest4
            two3 = -back5 - cosine
            lost12 = one3 + two3
            total11 = envelope + total10
            back5 = total11 - total10
            rest4 = total11 - back5
            one3 = total10 - rest4
            two3 = envelope - back5
            lost13 = one3 + two3
            total10 = envelope*total11
            envelope_halves = halves(xp, envelope)
            total11_halves = halves(xp, total11)
            lost13 = envelope*(lost10 + lost12 + lost13 - low) + product_error(total10, envelope_halves, total11_halves)
            stiff = xp.where(4.0 > gamma, 4.0, gamma)
            total11 = total10/stiff
            left13 = total10 - stiff*total11
            total11_halves = halves(xp, total11)
            stiff_halves = halves(xp, stiff)
            left13 = left13 - product_error(total11*stiff, total11_halves, stiff_halves)
            left13 = left13 + lost13
            lost13 = left13/stiff
            return lost13 + total11

        def no(p_low, q, q_low, root, root_low, whole2):
            fall_ = xp.exp(-q)
            fall_ = fall_ - fall_*q_low
            ratio = xp.exp(-2.0*root)
            ratio = ratio - 2.0*ratio*root_low
            whole3 = xp.where(q == 0.0, 1.0, q)
            none = whole3 - q
            top = none - xp.expm1(-q)
            total4 = top/whole3
            left4 = top - total4*whole3
            total4_halves = halves(xp, total4)
            whole3_halves = halves(xp, whole3)
            left4 = left4 - product_error(total4*whole3, total4_halves, whole3_halves)
            left4 = fall_*q_low + left4 - q_low*total4
            lost4 = left4/whole3
            whole3 = xp.where(root == 0.0, 1.0, 2.0*root)
            none = whole3 - 2.0*root
            top = none - xp.expm1(-2.0*root)
            total5 = top/whole3
            left4 = top - total5*whole3
            total5_halves = halves(xp, total5)
            whole3_halves = halves(xp, whole3)
            left4 = left4 - product_error(total5*whole3, total5_halves, whole3_halves)
            left4 = left4 + 2.0*ratio*root_low - 2.0*root_low*total5
            lost5 = left4/whole3
            total6 = ratio*total4
            ratio_halves = halves(xp, ratio)
            lost4 = lost4*ratio + product_error(total6, ratio_halves, total4_halves)
            total4 = total5 - total6
            back4 = total4 - total5
            rest3 = total4 - back4
            one2 = total5 - rest3
            two2 = -back4 - total6
            lost7 = one2 + two2
            total6 = total4/whole2
            left4 = total4 - total6*whole2
            total6_halves = halves(xp, total6)
            whole2_halves = halves(xp, whole2)
            left4 = left4 - product_error(total6*whole2, total6_halves, whole2_halves)
            left4 = left4 + lost5 - lost4 + lost7 - p_low*total6
            lost7 = left4/whole2
            total4 = fall_*total6
            fall__halves = halves(xp, fall_)
            lost7 = fall_*lost7 + product_error(total4, fall__halves, total6_halves)
            creep_ = lost7 + total4
            return creep_

        return select(xp, total2 < 0.0, yes, (gamma, half, root, root_low, whole), no, (p_low, q, q_low, root, root_low, whole2))

    return select(xp, reach < 1.0, yes, (delta, gamma, reach), no, (gamma, half, p_low, q, q_low, root, root_low, total2, whole, whole2))


def rise_series(xp, h, w):
    """divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2"""
    b32 = 9.67759295863189e-41*h + 3.387157535521162e-39
    e31 = 9.67759295863189e-41*w + 1.151633562077195e-37
    b32 = b32*h + e31
    e30 = 3.387157535521162e-39*w + 3.8003907548547434e-36
    b32 = b32*h + e30
    e31 = e31*w + 1.216125041553518e-34
    b32 = b32*h + e31
    e30 = e30*w + 3.7699876288159054e-33
    b32 = b32*h + e30
    e31 = e31*w + 1.1309962886447716e-31
    b32 = b32*h + e31
    e30 = e30*w + 3.279889237069838e-30
    b32 = b32*h + e30
    e31 = e31*w + 9.183689863795546e-29
    b32 = b32*h + e31
    e30 = e30*w + 2.4795962632247976e-27
    b32 = b32*h + e30
    e31 = e31*w + 6.446950284384474e-26
    b32 = b32*h + e31
    e30 = e30*w + 1.6117375710961184e-24
    b32 = b32*h + e30
    e31 = e31*w + 3.868170170630684e-23
    b32 = b32*h + e31
    e30 = e30*w + 8.896791392450574e-22
    b32 = b32*h + e30
    e31 = e31*w + 1.9572941063391263e-20
    b32 = b32*h + e31
    e30 = e30*w + 4.110317623312165e-19
    b32 = b32*h + e30
    e31 = e31*w + 8.22063524662433e-18
    b32 = b32*h + e31
    e30 = e30*w + 1.5619206968586225e-16
    b32 = b32*h + e30
    e31 = e31*w + 2.8114572543455206e-15
    b32 = b32*h + e31
    e30 = e30*w + 4.779477332387385e-14
    b32 = b32*h + e30
    e31 = e31*w + 7.647163731819816e-13
    b32 = b32*h + e31
    e30 = e30*w + 1.1470745597729725e-11
    b32 = b32*h + e30
    e31 = e31*w + 1.6059043836821613e-10
    b32 = b32*h + e31
    e30 = e30*w + 2.08767569878681e-09
    b32 = b32*h + e30
    e31 = e31*w + 2.505210838544172e-08
    b32 = b32*h + e31
    e30 = e30*w + 2.755731922398589e-07
    b32 = b32*h + e30
    e31 = e31*w + 2.7557319223985893e-06
    b32 = b32*h + e31
    e30 = e30*w + 2.48015873015873e-05
    b32 = b32*h + e30
    e31 = e31*w + 0.0001984126984126984
    b32 = b32*h + e31
    e30 = e30*w + 0.001388888888888889
    b32 = b32*h + e30
    e31 = e31*w + 0.008333333333333333
    b32 = b32*h + e31
    e30 = e30*w + 0.041666666666666664
    b32 = b32*h + e30
    e31 = e31*w + 0.16666666666666666
    b32 = b32*h + e31
    e30 = e30*w
    b32 = b32*h + e30
    return b32


def rise(xp, gamma, delta, half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low):
    """n1, how far a unit force moves the device in a period"""
    reach = xp.where(total2 < 0.0, 0.25*gamma, 0.375*total3)

    def yes(half, reach, total2):
        case1 = reach >= 1.0
        rest4 = rise_series(xp, xp.where(case1, 0.0, half), xp.where(case1, 0.0, total2))
        total11 = rest4 + 0.5
        back5 = total11 - 0.5
        lost11 = rest4 - back5
        envelope2 = xp.exp(-half)
        total12 = envelope2*total11
        envelope2_halves = halves(xp, envelope2)
        total11_halves = halves(xp, total11)
        lost11 = envelope2*lost11 + product_error(total12, envelope2_halves, total11_halves)
        return lost11 + total12

    def no(gamma, half, p_low, q, q_low, root, root_low, total2, whole, whole2):

        def yes(gamma, half, root, root_low, whole):
            sine = xp.sin(root)
            cosine = xp.cos(root)
            low = -root_low*sine
            total9 = half*sine
            total9 = total9/whole
            envelope = xp.exp(-half)
            return (1.0 - envelope*(cosine + low + total9))/xp.where(4.0 > gamma, 4.0, gamma)

        def no(gamma, p_low, q, q_low, root, root_low, whole2):

            def yes(p_low, q, q_low, root, root_low, whole2):
                fall_ = xp.exp(-q)
                fall_ = fall_ - fall_*q_low
                ratio = xp.exp(-2.0*root)
                ratio = ratio - 2.0*ratio*root_low
                whole3 = xp.where(q == 0.0, 1.0, q)
                none = whole3 - q
                top = none - xp.expm1(-q)
                total4 = top/whole3
                left4 = top - total4*whole3
                total4_halves = halves(xp, total4)
                whole3_halves = halves(xp, whole3)
                left4 = left4 - product_error(total4*whole3, total4_halves, whole3_halves)
                left4 = fall_*q_low + left4 - q_low*total4
                lost4 = left4/whole3
                whole3 = xp.where(root == 0.0, 1.0, 2.0*root)
                none = whole3 - 2.0*root
                top = none - xp.expm1(-2.0*root)
                total5 = top/whole3
                left4 = top - total5*whole3
                total5_halves = halves(xp, total5)
                whole3_halves = halves(xp, whole3)
                left4 = left4 - product_error(total5*whole3, total5_halves, whole3_halves)
                left4 = left4 + 2.0*ratio*root_low - 2.0*root_low*total5
                lost5 = left4/whole3
                total6 = fall_*total5
                fall__halves = halves(xp, fall_)
                lost5 = fall_*lost5 + product_error(total6, fall__halves, total5_halves)
                total5 = total4 - total6
                back4 = total5 - total4
                rest3 = total5 - back4
                one2 = total4 - rest3
                two2 = -back4 - total6
                lost7 = one2 + two2
                total6 = total5/whole2
                left4 = total5 - total6*whole2
                total6_halves = halves(xp, total6)
                whole2_halves = halves(xp, whole2)
                left4 = left4 - product_error(total6*whole2, total6_halves, whole2_halves)
                left4 = left4 + lost4 - lost5 + lost7 - p_low*total6
                lost7 = left4/whole2
                return lost7 + total6

            def no(gamma, q, q_low, root):
                fall_ = xp.exp(-q)
                fall_ = fall_ - fall_*q_low
                whole4 = xp.where(root == 0.0, 1.0, 2.0*root)
                none2 = whole4 - 2.0*root
                top2 = none2 - xp.expm1(-2.0*root)
                total5 = top2/whole4
                whole4 = xp.where(gamma == 0.0, 1.0, gamma)
                return (1.0 - fall_*(q*total5 + 1.0))/whole4

            return select(xp, q < 2.0, yes, (p_low, q, q_low, root, root_low, whole2), no, (gamma, q, q_low, root))

        return select(xp, total2 < 0.0, yes, (gamma, half, root, root_low, whole), no, (gamma, p_low, q, q_low, root, root_low, whole2))

    return select(xp, reach < 1.0, yes, (half, reach, total2), no, (gamma, half, p_low, q, q_low, root, root_low, total2, whole, whole2))


def swing(xp, gamma, delta, half, total2, root, root_low, total3, q, q_low):
    """a, the sum of the sampled device's poles"""

    def yes(half, root, root_low):
        sine = xp.sin(root)
        cosine = xp.cos(root)
        envelope = xp.exp(-half)
        total6 = cosine*envelope
        envelope_halves = halves(xp, envelope)
        cosine_halves = halves(xp, cosine)
        lost6 = product_error(total6, envelope_halves, cosine_halves) - envelope*root_low*sine
        return 2.0*lost6 + 2.0*total6

    def no(q, q_low, root, root_low):
        fall_ = xp.exp(-q)
        fall_ = fall_ - fall_*q_low
        ratio = xp.exp(-2.0*root)
        ratio = ratio - 2.0*ratio*root_low
        return fall_*ratio + fall_

    return select(xp, total2 < 0.0, yes, (half, root, root_low), no, (q, q_low, root, root_low))


def apart_series(xp, h, w):
    """divided difference of sinh(sqrt)/sqrt at h^2 and w"""
    y = (h*h)
    e14 = 1.151633562077195e-37*w + 1.216125041553518e-34
    b14 = e14 + 1.151633562077195e-37*y
    e14 = e14*w + 1.1309962886447716e-31
    b14 = b14*y + e14
    e14 = e14*w + 9.183689863795546e-29
    b14 = b14*y + e14
    e14 = e14*w + 6.446950284384474e-26
    b14 = b14*y + e14
    e14 = e14*w + 3.868170170630684e-23
    b14 = b14*y + e14
    e14 = e14*w + 1.9572941063391263e-20
    b14 = b14*y + e14
    e14 = e14*w + 8.22063524662433e-18
    b14 = b14*y + e14
    e14 = e14*w + 2.8114572543455206e-15
    b14 = b14*y + e14
    e14 = e14*w + 7.647163731819816e-13
    b14 = b14*y + e14
    e14 = e14*w + 1.6059043836821613e-10
    b14 = b14*y + e14
    e14 = e14*w + 2.505210838544172e-08
    b14 = b14*y + e14
    e14 = e14*w + 2.7557319223985893e-06
    b14 = b14*y + e14
    e14 = e14*w + 0.0001984126984126984
    b14 = b14*y + e14
    e14 = e14*w + 0.008333333333333333
    b14 = b14*y + e14
    e14 = e14*w + 0.16666666666666666
    b14 = b14*y + e14
    return b14


def decay(xp, x):
    """(1 - exp(-x))/x"""

    def yes():
        return 1.0

    def no(x):
        whole = xp.where(x == 0.0, 1.0, x)
        return -xp.expm1(-x)/whole

    return select(xp, x == 0.0, yes, (), no, (x,))


def apart(xp, gamma, delta, half, total2, root, whole, root_low, total3, q, q_low):
    """(n1 - n0)/delta"""
    reach = xp.where(total2 < 0.0, 0.25*gamma, 0.4444444444444444*total3)

    def yes(half, reach, total2):
        case1 = reach >= 1.0
        return apart_series(xp, xp.where(case1, 0.0, half), xp.where(case1, 0.0, total2))*xp.exp(-half)

    def no(delta, gamma, half, q, q_low, root, root_low, total2, total3, whole):

        def yes(delta, gamma, half, root, whole):
            sine = xp.sin(root)
            total9 = half*sine
            total9 = total9/whole
            envelope = xp.exp(-half)
            whole6 = xp.where(delta == 0.0, 1.0, delta)
            return (decay(xp, delta) - 2.0*envelope*total9/whole6)/xp.where(4.0 > gamma, 4.0, gamma)

        def no(delta, q, q_low, root, root_low, total3):
            fall_ = xp.exp(-q)
            fall_ = fall_ - fall_*q_low
            ratio = xp.exp(-2.0*root)
            ratio = ratio - 2.0*ratio*root_low
            whole3 = xp.where(q == 0.0, 1.0, q)
            none = whole3 - q
            top = none - xp.expm1(-q)
            total4 = top/whole3
            left4 = top - total4*whole3
            total4_halves = halves(xp, total4)
            whole3_halves = halves(xp, whole3)
            left4 = left4 - product_error(total4*whole3, total4_halves, whole3_halves)
            left4 = fall_*q_low + left4 - q_low*total4
            lost4 = left4/whole3
            whole3 = xp.where(root == 0.0, 1.0, 2.0*root)
            none = whole3 - 2.0*root
            top = none - xp.expm1(-2.0*root)
            total5 = top/whole3
            left4 = top - total5*whole3
            total5_halves = halves(xp, total5)
            whole3_halves = halves(xp, whole3)
            left4 = left4 - product_error(total5*whole3, total5_halves, whole3_halves)
            left4 = left4 + 2.0*ratio*root_low - 2.0*root_low*total5
            lost5 = left4/whole3
            fast = fall_*ratio
            twice = 2.0*fall_
            total6 = total5*twice
            twice_halves = halves(xp, twice)
            lost5 = lost5*twice + product_error(total6, twice_halves, total5_halves)
            total5 = total4 - total6
            back4 = total5 - total4
            rest3 = total5 - back4
            one2 = total4 - rest3
            two2 = -back4 - total6
            lost7 = one2 + two2
            total6 = fast*total4
            fast_halves = halves(xp, fast)
            lost8 = fast*lost4 + product_error(total6, fast_halves, total4_halves)
            top = total5 + total6
            low = lost4 - lost5 + lost7 + lost8
            whole3 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)
            return (low + top)/whole3

        return select(xp, total2 < 0.0, yes, (delta, gamma, half, root, whole), no, (delta, q, q_low, root, root_low, total3))

    return select(xp, reach < 1.0, yes, (half, reach, total2), no, (delta, gamma, half, q, q_low, root, root_low, total2, total3, whole))


def nyquist(xp, gamma, delta, half, total2, root, whole, root_low, total3, q, q_low):
    """1 + a + e"""

    def yes(delta, half, root, root_low):
        cosine = xp.cos(root)

        def yes(cosine, delta, half, root, root_low):
            sine = xp.sin(root)
            low = -root_low*sine
            envelope = xp.exp(-half)
            ends = 1.0 + xp.exp(-delta)
            return ends + 2.0*envelope*(cosine + low)

        def no(half, root, root_low):
            grown = -0.5*xp.expm1(-half)
            angle = 0.5*root
            wave = xp.cos(angle)
            wave = wave - 0.5*root_low*xp.sin(angle)
            return 4.0*(grown*grown) + 4.0*(wave*wave)*xp.exp(-half)

        return select(xp, cosine > 0.0, yes, (cosine, delta, half, root, root_low), no, (half, root, root_low))

    def no(q, q_low, total3):
        fast = xp.exp(-total3)
        slow = xp.exp(-q)
        slow = slow - q_low*slow
        return (fast + 1.0)*(slow + 1.0)

    return select(xp, total2 < 0.0, yes, (delta, half, root, root_low), no, (q, q_low, total3))


def stable(xp, roots, alpha, beta, gamma, delta):
    """1 where the loop is stable, else 0"""
    swing_ = square_root(xp, gamma)
    return xp.where((alpha > -gamma) & (roots == 0.0) & (~((alpha == 0.0) & (beta == 0.0) & (delta == 0.0))) & (~((delta < 1e-15) & (gamma > 1.0) & (swing_ >= 2500000000000000.0*xp.abs(xp.sin(swing_))))), xp.full_like(alpha, 1.0), 0.0)


def sinhc_root(xp, w):
    """sinh(sqrt(w))/sqrt(w)"""

    def yes():
        return 1.0

    def no(w):

        def yes(w):
            size = xp.abs(w)
            root = square_root(xp, size)
            whole = xp.where(root == 0.0, 1.0, root)
            left = size - (root*root)
            root_halves = halves(xp, root)
            left = left - product_error(root*root, root_halves, root_halves)
            low = 0.5*left/whole
            sine = xp.sin(root)
            turned = low*xp.cos(root) + sine
            return turned/whole

        def no(w):
            size = xp.abs(w)
            root = square_root(xp, size)
            whole = xp.where(root == 0.0, 1.0, root)
            grown = xp.expm1(xp.where(w < 0.0, 0.0, root))
            return (0.5*grown + 0.5*grown/(grown + 1.0))/whole

        return select(xp, w < 0.0, yes, (w,), no, (w,))

    return select(xp, w == 0.0, yes, (), no, (w,))


def together_series(xp, h, w):
    """divided difference of cosh(sqrt) at h^2 and w, less 1/2"""
    y = (h*h)
    e14 = 3.8003907548547434e-36*w + 3.7699876288159054e-33
    b14 = e14 + 3.8003907548547434e-36*y
    e14 = e14*w + 3.279889237069838e-30
    b14 = b14*y + e14
    e14 = e14*w + 2.4795962632247976e-27
    b14 = b14*y + e14
    e14 = e14*w + 1.6117375710961184e-24
    b14 = b14*y + e14
    e14 = e14*w + 8.896791392450574e-22
    b14 = b14*y + e14
    e14 = e14*w + 4.110317623312165e-19
    b14 = b14*y + e14
    e14 = e14*w + 1.5619206968586225e-16
    b14 = b14*y + e14
    e14 = e14*w + 4.779477332387385e-14
    b14 = b14*y + e14
    e14 = e14*w + 1.1470745597729725e-11
    b14 = b14*y + e14
    e14 = e14*w + 2.08767569878681e-09
    b14 = b14*y + e14
    e14 = e14*w + 2.755731922398589e-07
    b14 = b14*y + e14
    e14 = e14*w + 2.48015873015873e-05
    b14 = b14*y + e14
    e14 = e14*w + 0.001388888888888889
    b14 = b14*y + e14
    e14 = e14*w + 0.041666666666666664
    b14 = b14*y + e14
    e14 = e14*w
    b14 = b14*y + e14
    return b14


def together(xp, gamma, delta, half, total2, root, root_low, total3, q):
    """n1 + n0"""
    reach = xp.where(total2 < 0.0, 0.25*gamma, 0.4444444444444444*total3)

    def yes(half, reach, total2):
        case1 = reach >= 1.0
        rest3 = together_series(xp, xp.where(case1, 0.0, half), xp.where(case1, 0.0, total2))
        total4 = rest3 + 0.5
        back4 = total4 - 0.5
        lost4 = rest3 - back4
        envelope = xp.exp(-half)
        total5 = envelope*total4
        envelope_halves = halves(xp, envelope)
        total4_halves = halves(xp, total4)
        lost4 = envelope*lost4 + product_error(total5, envelope_halves, total4_halves)
        return 2.0*lost4 + 2.0*total5

    def no(delta, gamma, half, q, root, root_low, total2, total3):

        def yes(delta, gamma, half, root, root_low):

            def yes(delta, gamma):
                return (sinhc_root(xp, xp.where(delta != 0.0, 0.0, -0.25*gamma))*sinhc_root(xp, xp.where(delta != 0.0, 0.0, -0.25*gamma)))

            def no(gamma, half, root, root_low):
                grown = -0.5*xp.expm1(-half)
                angle = 0.5*root
                wave = xp.sin(angle)
                wave = 0.5*root_low*xp.cos(angle) + wave
                return 4.0*((grown*grown) + (wave*wave)*xp.exp(-half))/xp.where(4.0 > gamma, 4.0, gamma)

            return select(xp, delta == 0.0, yes, (delta, gamma), no, (gamma, half, root, root_low))

        def no(q, total3):
            return decay(xp, q)*decay(xp, total3)

        return select(xp, total2 < 0.0, yes, (delta, gamma, half, root, root_low), no, (q, total3))

    return select(xp, reach < 1.0, yes, (half, reach, total2), no, (delta, gamma, half, q, root, root_low, total2, total3))


def unstable_roots(xp, alpha, beta, d, n1, n0, at_one, at_minus_one, loss, together_, apart_):
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
    disc = square2 - product
    size = square2 + xp.abs(product)
    square2 = (own1*own1)
    product = 4.0*own0*own2
    disc2 = square2 - product
    size2 = square2 + xp.abs(product)
    square2 = (far1*far1)
    product = 4.0*far0*square
    disc3 = square2 - product
    size3 = square2 + xp.abs(product)
    disc3 = xp.where((size >= size2) & (size2 <= size3), disc2, xp.where((size > size3) & (size2 > size3), disc3, disc))
    root = square_root(xp, xp.where(0.0 > disc3, 0.0, disc3))
    case1 = near1 >= 0.0
    q = -0.5*near1 - 0.5*xp.where(case1, root, -root)
    case2 = square == 0.0
    lead = xp.where(case2, 1.0, square)
    case3 = q == 0.0
    own = xp.where(case3, 1.0, q)
    one = xp.where(case2, -1.0, q/lead)
    two = xp.where(case3, -1.0, near0/own)
    low = xp.where(case1, one, two)
    high = xp.where(case1, two, one)
    case4 = own1 >= 0.0
    q = -0.5*own1 - 0.5*xp.where(case4, root, -root)
    case5 = own2 == 0.0
    lead = xp.where(case5, 1.0, own2)
    case6 = q == 0.0
    own = xp.where(case6, 1.0, q)
    one = xp.where(case5, -1.0, q/lead)
    two = xp.where(case6, -1.0, own0/own)
    low2 = xp.where(case4, one, two)
    high2 = xp.where(case4, two, one)
    case7 = far1 >= 0.0
    q = -0.5*far1 - 0.5*xp.where(case7, root, -root)
    lead = xp.where(case2, 1.0, square)
    case8 = q == 0.0
    own1 = xp.where(case8, 1.0, q)
    one = xp.where(case2, -1.0, q/lead)
    two = xp.where(case8, -1.0, far0/own1)
    low3 = xp.where(case7, one, two)
    high3 = xp.where(case7, two, one)
    case9 = high3 > low
    edge = xp.where(case9, low, high3)
    case10 = (beyond - low2 > 0.0) & (center + low2 > 0.0) & (edge > xp.abs(low2))
    at = xp.where(case10, center + low2, xp.where(case9, low, 4.0 - high3))
    still = xp.where(case10, beyond - low2, xp.where(case9, 4.0 - low, high3))
    away = xp.where(case10, low2, xp.where(case9, low - center, beyond - high3))
    case11 = (disc3 >= 0.0) & (edge < 4.0) & (high3 > 0.0) & (low > 0.0)
    at = xp.where(case11, at, 2.0)
    still = xp.where(case11, still, 2.0)
    at = xp.where(0.0 > at, 0.0, at)
    still = xp.where(0.0 > still, 0.0, still)
    sine = 2.0*square_root(xp, at*still)
    x = away*(-2.0*e - 2.0)
    y = loss*sine
    case12 = x < 0.0
    halves_ = xp.where(case12, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned = xp.atan2(xp.where(case12, -y, y), xp.abs(x))
    x = still*together_ - apart_*at
    y = n1*sine
    case13 = x < 0.0
    halves2 = xp.where(case13, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned2 = xp.atan2(xp.where(case13, -y, y), xp.abs(x))
    x = alpha*still - at*wall_far
    y = sine*slope
    case14 = x < 0.0
    halves3 = xp.where(case14, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned3 = xp.atan2(xp.where(case14, -y, y), xp.abs(x))
    case15 = at > 2.0
    half = xp.atan2(xp.where(case15, square_root(xp, still), square_root(xp, at)), xp.where(case15, square_root(xp, at), square_root(xp, still)))
    late = d + 2.0
    halves3 = halves2 - halves_ + halves3 - xp.where(case15, late, 0.0)
    share = 0.5*(turned2 - late*xp.where(case15, -2.0*half, 2.0*half) - turned + turned3)/3.141592653589793
    even = xp.floor(0.5*halves3)
    left = 0.5*halves3 - even
    turns = even + xp.where(left == 0.5, xp.floor(share) + 1.0, xp.floor(left + share + 0.5))
    total = xp.where(case11, 2.0*turns, 0.0)
    case16 = high < low3
    edge = xp.where(case16, high, low3)
    case17 = (beyond - high2 > 0.0) & (center + high2 > 0.0) & (edge > xp.abs(high2))
    at = xp.where(case17, center + high2, xp.where(case16, high, 4.0 - low3))
    still = xp.where(case17, beyond - high2, xp.where(case16, 4.0 - high, low3))
    away = xp.where(case17, high2, xp.where(case16, high - center, beyond - low3))
    case18 = (disc3 >= 0.0) & (edge < 4.0) & (high > 0.0) & (low3 > 0.0)
    at = xp.where(case18, at, 2.0)
    still = xp.where(case18, still, 2.0)
    at = xp.where(0.0 > at, 0.0, at)
    still = xp.where(0.0 > still, 0.0, still)
    sine = 2.0*square_root(xp, at*still)
    x = away*(-2.0*e - 2.0)
    y = loss*sine
    case19 = x < 0.0
    halves3 = xp.where(case19, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned3 = xp.atan2(xp.where(case19, -y, y), xp.abs(x))
    x = still*together_ - apart_*at
    y = n1*sine
    case20 = x < 0.0
    halves2 = xp.where(case20, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned2 = xp.atan2(xp.where(case20, -y, y), xp.abs(x))
    x = alpha*still - at*wall_far
    y = sine*slope
    case21 = x < 0.0
    halves_ = xp.where(case21, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned = xp.atan2(xp.where(case21, -y, y), xp.abs(x))
    case22 = at > 2.0
    half = xp.atan2(xp.where(case22, square_root(xp, still), square_root(xp, at)), xp.where(case22, square_root(xp, at), square_root(xp, still)))
    late = d + 2.0
    halves_ = halves2 - halves3 + halves_ - xp.where(case22, late, 0.0)
    share = 0.5*(turned2 - late*xp.where(case22, -2.0*half, 2.0*half) - turned3 + turned)/3.141592653589793
    even = xp.floor(0.5*halves_)
    left = 0.5*halves_ - even
    turns = even + xp.where(left == 0.5, xp.floor(share) + 1.0, xp.floor(left + share + 0.5))
    total = total + xp.where(case18, -2.0*turns, 0.0)
    side = xp.where(slope >= 0.0, xp.full_like(slope, 1.0), -1.0)
    end = xp.where(wall_far > 0.0, side, 0.0) - d + xp.where(apart_ > 0.0, xp.where(n1 >= 0.0, xp.full_like(n1, 1.0), -1.0), 0.0) - 3.0
    total = total + xp.where(((((near1 == 0.0) & (square < 0.0)) | (near1 < 0.0)) & (near0 == 0.0)) | (near0 < 0.0), xp.where(alpha > 0.0, 0.0, side), 0.0)
    return total - xp.where(((((far1 == 0.0) & (square < 0.0)) | (far1 < 0.0)) & (far0 == 0.0)) | (far0 < 0.0), end, 0.0)


def next_angle(xp, k, x):
    """cosine and sine of (k + 1) x as it is rounded, and the rest of the angle"""
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    off = missed*x + product_error(angle, count_halves, x_halves)
    cosine = xp.cos(angle)
    sine = xp.sin(angle)
    return off, cosine, sine


def cos_next(xp, k, x, off, cosine, sine):
    """cos((k + 1) x)"""
    return cosine - off*sine


def sin_next(xp, k, x, off, cosine, sine):
    """sin((k + 1) x)"""
    return cosine*off + sine


def gap(xp, x):
    """(x - sin(x))/x^3"""

    def yes(x):
        near = xp.where(xp.abs(x) >= 2.0, 0.0, x)
        square = -(near*near)
        b12 = 1.1309962886447716e-31*square + 9.183689863795546e-29
        b12 = b12*square + 6.446950284384474e-26
        b12 = b12*square + 3.868170170630684e-23
        b12 = b12*square + 1.9572941063391263e-20
        b12 = b12*square + 8.22063524662433e-18
        b12 = b12*square + 2.8114572543455206e-15
        b12 = b12*square + 7.647163731819816e-13
        b12 = b12*square + 1.6059043836821613e-10
        b12 = b12*square + 2.505210838544172e-08
        b12 = b12*square + 2.7557319223985893e-06
        b12 = b12*square + 0.0001984126984126984
        b12 = b12*square + 0.008333333333333333
        rest = b12*square + 9.25185853854297e-18
        total = rest + 0.16666666666666666
        return total

    def no(x):
        whole = xp.where(xp.abs(x) < 2.0, 2.0, x)
        return (x - xp.sin(x))/(whole*whole*whole)

    return select(xp, xp.abs(x) < 2.0, yes, (x,), no, (x,))


def sinc(xp, x):
    """sin(x)/x"""

    def yes(x):
        near = xp.where(xp.abs(x) >= 1.0, 0.0, x)
        return 1.0 - (near*near)*gap(xp, near)

    def no(x):
        whole = xp.where(x == 0.0, 1.0, x)
        return xp.sin(x)/whole

    return select(xp, xp.abs(x) < 1.0, yes, (x,), no, (x,))


def chord(xp, k, x):
    """(2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3"""
    turn = x*(k + 1.0)

    def yes(k, turn, x):
        angle = xp.where(turn >= 1.5, 0.0, turn)
        order = 2.0*k + 2.0
        off, cosine, sine = next_angle(xp, k, x)
        along = cos_next(xp, k, x, off, cosine, sine)
        wave = sinc(xp, 0.5*angle)
        inner = 0.5*(wave*wave) - gap(xp, angle)
        return order*(along*gap(xp, x) + 0.25*inner*(order*order))

    def no(k, turn, x):
        some = xp.where(turn < 1.5, 1.0, x)
        order = 2.0*k + 2.0
        off, cosine, sine = next_angle(xp, k, x)
        along = cos_next(xp, k, x, off, cosine, sine)
        return (2.0*sin_next(xp, k, x, off, cosine, sine) - along*order*xp.sin(x))/(some*some*some)

    return select(xp, turn < 1.5, yes, (k, turn, x), no, (k, turn, x))


def spread(xp, k, x):
    """((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3"""
    turn = x*(k + 1.0)

    def yes(k, turn, x):
        angle = xp.where(turn >= 1.5, 0.0, turn)
        order = 2.0*k + 2.0
        return order*((order*order)*gap(xp, 2.0*angle) - gap(xp, x))

    def no(k, turn, x):
        some = xp.where(turn < 1.5, 1.0, x)
        order = 2.0*k + 2.0
        off, cosine, sine = next_angle(xp, k, x)
        return (order*xp.sin(x) - 2.0*cos_next(xp, k, x, off, cosine, sine)*sin_next(xp, k, x, off, cosine, sine))/(some*some*some)

    return select(xp, turn < 1.5, yes, (k, turn, x), no, (k, turn, x))


def discretize(gamma, delta):
    """the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m.

    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    Domain: gamma >= 0, delta >= 0.
    """
    xp, gamma, delta = arrays(gamma, delta)

    def work(gamma, delta):
        half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low = motion(xp, gamma, delta)
        return rise(xp, gamma, delta, half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low), fall(xp, gamma, delta, half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low), swing(xp, gamma, delta, half, total2, root, root_low, total3, q, q_low), xp.exp(-delta)

    return elementwise(xp, work, gamma, delta)


def is_stable(alpha, beta, gamma, delta, d):
    """roots outside the unit circle, and 1 where the loop is stable, else 0.

    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: gamma >= 0, delta >= 0, d >= 0, d whole.
    """
    xp, alpha, beta, gamma, delta, d = arrays(alpha, beta, gamma, delta, d)

    def plant(gamma, delta):
        half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low = motion(xp, gamma, delta)
        return together(xp, gamma, delta, half, total2, root, root_low, total3, q), rise(xp, gamma, delta, half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low), fall(xp, gamma, delta, half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low), nyquist(xp, gamma, delta, half, total2, root, whole, root_low, total3, q, q_low), decay(xp, delta), apart(xp, gamma, delta, half, total2, root, whole, root_low, total3, q, q_low)

    t0, rise_, fall_, nyquist_, decay_, apart_ = elementwise(xp, plant, gamma, delta)

    def work(alpha, beta, gamma, delta, d, t0, rise_, fall_, nyquist_, decay_, apart_):
        t1 = unstable_roots(xp, alpha, beta, d, rise_, fall_, gamma*t0, nyquist_, decay_*delta, t0, apart_*delta)
        return t1, stable(xp, t1, alpha, beta, gamma, delta)

    return elementwise(xp, work, alpha, beta, gamma, delta, d, t0, rise_, fall_, nyquist_, decay_, apart_)


def stability_boundary(theta, gamma, delta, d):
    """the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).

    theta: angle on the unit circle, omega T [1]
    gamma: physical stiffness, k T^2/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0, d whole, or fractional on the principal sheet.
    """
    xp, theta, gamma, delta, d = arrays(theta, gamma, delta, d)

    def plant(gamma, delta):
        half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low = motion(xp, gamma, delta)
        return together(xp, gamma, delta, half, total2, root, root_low, total3, q), nyquist(xp, gamma, delta, half, total2, root, whole, root_low, total3, q, q_low), delta*apart(xp, gamma, delta, half, total2, root, whole, root_low, total3, q, q_low), 2.0*delta*decay(xp, delta)

    t0, nyquist_, t4, t7 = elementwise(xp, plant, gamma, delta)

    def work(theta, gamma, d, t0, nyquist_, t4, t7):
        t1 = xp.tan(0.5*theta)
        t2 = (t1*t1)
        t3 = gamma*t0 - nyquist_*t2
        t5 = t0 - t2*t4
        t6 = t0 + t4
        t8 = t2*t6*t7 + t3*t5
        t9 = 1.0/(t2*(t6*t6) + (t5*t5))
        off, cosine, sine = next_angle(xp, d, theta)
        t10 = sin_next(xp, d, theta, off, cosine, sine)
        t6 = t1*t5*t7 - t1*t3*t6
        t5 = t9*cos_next(xp, d, theta, off, cosine, sine)
        t3 = -t10*t8*t9 - t6*t5
        return t10*t6*t9 - t1*t3 - t5*t8, 0.5*t3*(t2 + 1.0)/t1

    return elementwise(xp, work, theta, gamma, d, t0, nyquist_, t4, t7)


def passivity_margin(theta, alpha, beta, delta, d):
    """physical damping minus the damping that the wall needs at the angle theta = omega T; the wall is passive where it is positive at every angle.

    theta: angle on the unit circle, omega T [1]
    alpha: virtual stiffness, K T^2/m [1]
    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, delta >= 0, d >= 0, d whole, or fractional on the principal sheet.
    """
    xp, theta, alpha, beta, delta, d = arrays(theta, alpha, beta, delta, d)

    def work(theta, alpha, beta, delta, d):
        t0 = 0.5*theta
        off, cosine, sine = next_angle(xp, d, theta)
        off_2, cosine_2, sine_2 = next_angle(xp, 2.0*d, t0)
        return beta*cos_next(xp, d, theta, off, cosine, sine) - 0.5*alpha*sin_next(xp, 2.0*d, t0, off_2, cosine_2, sine_2)/xp.sin(t0) + delta

    return elementwise(xp, work, theta, alpha, beta, delta, d)


def passivity_boundary(theta, delta, d):
    """the wall that is just passive and whose worst angle is theta = omega T.

    theta: angle on the unit circle, omega T [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: 0 < theta < pi, delta >= 0, d >= 0, theta <= pi/(d + 1), beyond which it bounds nothing.
    """
    xp, theta, delta, d = arrays(theta, delta, d)

    def work(theta, delta, d):
        t0 = delta/spread(xp, d, theta)
        t2 = sinc(xp, 0.5*theta)
        off, cosine, sine = next_angle(xp, d, theta)
        t2 = (t2*t2)*(d + 1.0)*sin_next(xp, d, theta, off, cosine, sine)/theta
        return 2.0*t0*t2, t0*(chord(xp, d, theta) - t2)

    return elementwise(xp, work, theta, delta, d)


def max_passive_stiffness(delta, d):
    """the passive wall of largest stiffness, and its worst angle theta = omega T.

    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0.
    """
    xp, delta, d = arrays(delta, d)

    def work(delta, d):
        t0 = 1.0/(d + 1.0)
        t1 = 3.141592653589793*t0
        t2 = 0.25*t1
        t1 = 0.5*t1
        t4 = xp.sin(t2)
        return 2.0*delta*xp.tan(t2), delta*(t0 - 2.0*(t4*t4))/xp.sin(t1), t1

    return elementwise(xp, work, delta, d)


def linear_limit(beta, delta, d):
    """the stiffness alpha at which the linear condition is an equality.

    beta: virtual damping, B T/m [1]
    delta: physical damping, b T/m [1]
    d: delay in sampling periods, t_d/T [1]
    Domain: delta >= 0, d >= 0.
    """
    xp, beta, delta, d = arrays(beta, delta, d)

    def work(beta, delta, d):
        return (beta + delta)/(d + 0.5)

    return elementwise(xp, work, beta, delta, d)
