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

BLOCK = 16384
"""Elements of NumPy arrays worked on at a time: so many fit the cache."""


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
    b30 = b31*delta - b32*gamma + 3.8003907548547434e-36
    b29 = b30*delta - b31*gamma + 1.216125041553518e-34
    b28 = b29*delta - b30*gamma + 3.7699876288159054e-33
    b27 = b28*delta - b29*gamma + 1.1309962886447716e-31
    b26 = b27*delta - b28*gamma + 3.279889237069838e-30
    b25 = b26*delta - b27*gamma + 9.183689863795546e-29
    b24 = b25*delta - b26*gamma + 2.4795962632247976e-27
    b23 = b24*delta - b25*gamma + 6.446950284384474e-26
    b22 = b23*delta - b24*gamma + 1.6117375710961184e-24
    b21 = b22*delta - b23*gamma + 3.868170170630684e-23
    b20 = b21*delta - b22*gamma + 8.896791392450574e-22
    b19 = b20*delta - b21*gamma + 1.9572941063391263e-20
    b18 = b19*delta - b20*gamma + 4.110317623312165e-19
    b17 = b18*delta - b19*gamma + 8.22063524662433e-18
    b16 = b17*delta - b18*gamma + 1.5619206968586225e-16
    b15 = b16*delta - b17*gamma + 2.8114572543455206e-15
    b14 = b15*delta - b16*gamma + 4.779477332387385e-14
    b13 = b14*delta - b15*gamma + 7.647163731819816e-13
    b12 = b13*delta - b14*gamma + 1.1470745597729725e-11
    b11 = b12*delta - b13*gamma + 1.6059043836821613e-10
    b10 = b11*delta - b12*gamma + 2.08767569878681e-09
    b9 = b10*delta - b11*gamma + 2.505210838544172e-08
    b8 = b9*delta - b10*gamma + 2.755731922398589e-07
    b7 = b8*delta - b9*gamma + 2.7557319223985893e-06
    b6 = b7*delta - b8*gamma + 2.48015873015873e-05
    b5 = b6*delta - b7*gamma + 0.0001984126984126984
    b4 = b5*delta - b6*gamma + 0.001388888888888889
    total = b4*delta
    delta_halves = halves(xp, delta)
    b4_halves = halves(xp, b4)
    lost = product_error(total, delta_halves, b4_halves)
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
    total4 = total3 + 0.008333333333333333
    back2 = total4 - total3
    rest2 = total4 - back2
    one2 = total3 - rest2
    two2 = 0.008333333333333333 - back2
    lost4 = one2 + two2
    low = lost - lost2 + lost3 + lost4
    total5 = delta*total4
    total4_halves = halves(xp, total4)
    lost5 = delta*low + product_error(total5, delta_halves, total4_halves)
    total6 = b4*gamma
    lost6 = product_error(total6, gamma_halves, b4_halves)
    total7 = total5 - total6
    back3 = total7 - total5
    rest3 = total7 - back3
    one3 = total5 - rest3
    two3 = -back3 - total6
    lost7 = one3 + two3
    total8 = total7 + 0.041666666666666664
    back4 = total8 - total7
    rest4 = total8 - back4
    one4 = total7 - rest4
    two4 = 0.041666666666666664 - back4
    lost8 = one4 + two4
    low2 = lost5 - lost6 + lost7 + lost8
    total9 = delta*total8
    total8_halves = halves(xp, total8)
    lost9 = delta*low2 + product_error(total9, delta_halves, total8_halves)
    total10 = gamma*total4
    lost10 = gamma*low + product_error(total10, gamma_halves, total4_halves)
    total11 = total9 - total10
    back5 = total11 - total9
    rest5 = total11 - back5
    one5 = total9 - rest5
    two5 = -back5 - total10
    lost11 = one5 + two5
    total12 = total11 + 0.16666666666666666
    back6 = total12 - total11
    rest6 = total12 - back6
    one6 = total11 - rest6
    two6 = 0.16666666666666666 - back6
    lost12 = one6 + two6
    low3 = lost11 - lost10 + lost12 + lost9
    total13 = delta*total12
    total12_halves = halves(xp, total12)
    lost13 = delta*low3 + product_error(total13, delta_halves, total12_halves)
    total14 = gamma*total8
    lost14 = gamma*low2 + product_error(total14, gamma_halves, total8_halves)
    total15 = total13 - total14
    back7 = total15 - total13
    rest7 = total15 - back7
    one7 = total13 - rest7
    two7 = -back7 - total14
    lost15 = one7 + two7
    total16 = total15
    back8 = total16 - total15
    rest8 = total16 - back8
    one8 = total15 - rest8
    two8 = -back8
    lost16 = one8 + two8
    low4 = lost13 - lost14 + lost15 + lost16
    return low4 + total16


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
    rest2 = lost + product_error(square, half_halves, half_halves)
    total2 = rest2 + total
    back2 = total2 - total
    lost2 = rest2 - back2
    size = xp.abs(total2)
    root = square_root(xp, size)
    sign_low = xp.where(total2 < 0.0, -lost2, lost2)
    left = size - (root*root)
    root_halves = halves(xp, root)
    left2 = left - product_error(root*root, root_halves, root_halves)
    left3 = left2 + sign_low
    whole = xp.where(root == 0.0, 1.0, root)
    root_low = 0.5*left3/whole
    total3 = half + root
    back3 = total3 - half
    lost3 = root - back3
    p_low = lost3 + root_low
    whole2 = xp.where(total3 == 0.0, 1.0, total3)
    q = gamma/whole2
    off = gamma - q*whole2
    whole2_halves = halves(xp, whole2)
    q_halves = halves(xp, q)
    off2 = off - product_error(whole2*q, whole2_halves, q_halves)
    off3 = off2 - p_low*q
    q_low = off3/whole2
    return half, total2, root, whole, root_low, total3, p_low, whole2, q, q_low


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
        lost17 = envelope2*lost16 + product_error(total17, envelope2_halves, total16_halves)
        return lost17 + total17

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
            left14 = left13 - product_error(total11*whole, total11_halves, whole_halves)
            left15 = left14 + lost10 - root_low*total11
            lost11 = left15/whole
            envelope = xp.exp(-half)
            total12 = total11 - cosine
            back5 = total12 - total11
            rest4 = total12 - back5
            one3 = total11 - rest4
            two3 = -back5 - cosine
            lost12 = one3 + two3
            total13 = envelope + total12
            back6 = total13 - total12
            rest5 = total13 - back6
            one4 = total12 - rest5
            two4 = envelope - back6
            lost13 = one4 + two4
            total14 = envelope*total13
            envelope_halves = halves(xp, envelope)
            total13_halves = halves(xp, total13)
            lost14 = envelope*(lost11 + lost12 + lost13 - low) + product_error(total14, envelope_halves, total13_halves)
            stiff = xp.where(4.0 > gamma, 4.0, gamma)
            total15 = total14/stiff
            left16 = total14 - stiff*total15
            total15_halves = halves(xp, total15)
            stiff_halves = halves(xp, stiff)
            left17 = left16 - product_error(total15*stiff, total15_halves, stiff_halves)
            left18 = left17 + lost14
            lost15 = left18/stiff
            return lost15 + total15

        def no(p_low, q, q_low, root, root_low, whole2):
            fall_ = xp.exp(-q)
            fall2 = fall_ - fall_*q_low
            ratio = xp.exp(-2.0*root)
            ratio2 = ratio - 2.0*ratio*root_low
            whole3 = xp.where(q == 0.0, 1.0, q)
            none = whole3 - q
            top = none - xp.expm1(-q)
            total4 = top/whole3
            left4 = top - total4*whole3
            total4_halves = halves(xp, total4)
            whole3_halves = halves(xp, whole3)
            left5 = left4 - product_error(total4*whole3, total4_halves, whole3_halves)
            left6 = fall2*q_low + left5 - q_low*total4
            lost4 = left6/whole3
            whole4 = xp.where(root == 0.0, 1.0, 2.0*root)
            none2 = whole4 - 2.0*root
            top2 = none2 - xp.expm1(-2.0*root)
            total5 = top2/whole4
            left7 = top2 - total5*whole4
            total5_halves = halves(xp, total5)
            whole4_halves = halves(xp, whole4)
            left8 = left7 - product_error(total5*whole4, total5_halves, whole4_halves)
            left9 = left8 + 2.0*ratio2*root_low - 2.0*root_low*total5
            lost5 = left9/whole4
            total6 = ratio2*total4
            ratio2_halves = halves(xp, ratio2)
            lost6 = lost4*ratio2 + product_error(total6, ratio2_halves, total4_halves)
            total7 = total5 - total6
            back4 = total7 - total5
            rest3 = total7 - back4
            one2 = total5 - rest3
            two2 = -back4 - total6
            lost7 = one2 + two2
            total8 = total7/whole2
            left10 = total7 - total8*whole2
            total8_halves = halves(xp, total8)
            whole2_halves = halves(xp, whole2)
            left11 = left10 - product_error(total8*whole2, total8_halves, whole2_halves)
            left12 = left11 + lost5 - lost6 + lost7 - p_low*total8
            lost8 = left12/whole2
            total9 = fall2*total8
            fall2_halves = halves(xp, fall2)
            lost9 = fall2*lost8 + product_error(total9, fall2_halves, total8_halves)
            creep_ = lost9 + total9
            return creep_

        return select(xp, total2 < 0.0, yes, (gamma, half, root, root_low, whole), no, (p_low, q, q_low, root, root_low, whole2))

    return select(xp, reach < 1.0, yes, (delta, gamma, reach), no, (gamma, half, p_low, q, q_low, root, root_low, total2, whole, whole2))


def rise_series(xp, h, w):
    """divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2"""
    b32 = 9.67759295863189e-41*h + 3.387157535521162e-39
    e31 = 9.67759295863189e-41*w + 1.151633562077195e-37
    b31 = b32*h + e31
    e30 = 3.387157535521162e-39*w + 3.8003907548547434e-36
    b30 = b31*h + e30
    e29 = e31*w + 1.216125041553518e-34
    b29 = b30*h + e29
    e28 = e30*w + 3.7699876288159054e-33
    b28 = b29*h + e28
    e27 = e29*w + 1.1309962886447716e-31
    b27 = b28*h + e27
    e26 = e28*w + 3.279889237069838e-30
    b26 = b27*h + e26
    e25 = e27*w + 9.183689863795546e-29
    b25 = b26*h + e25
    e24 = e26*w + 2.4795962632247976e-27
    b24 = b25*h + e24
    e23 = e25*w + 6.446950284384474e-26
    b23 = b24*h + e23
    e22 = e24*w + 1.6117375710961184e-24
    b22 = b23*h + e22
    e21 = e23*w + 3.868170170630684e-23
    b21 = b22*h + e21
    e20 = e22*w + 8.896791392450574e-22
    b20 = b21*h + e20
    e19 = e21*w + 1.9572941063391263e-20
    b19 = b20*h + e19
    e18 = e20*w + 4.110317623312165e-19
    b18 = b19*h + e18
    e17 = e19*w + 8.22063524662433e-18
    b17 = b18*h + e17
    e16 = e18*w + 1.5619206968586225e-16
    b16 = b17*h + e16
    e15 = e17*w + 2.8114572543455206e-15
    b15 = b16*h + e15
    e14 = e16*w + 4.779477332387385e-14
    b14 = b15*h + e14
    e13 = e15*w + 7.647163731819816e-13
    b13 = b14*h + e13
    e12 = e14*w + 1.1470745597729725e-11
    b12 = b13*h + e12
    e11 = e13*w + 1.6059043836821613e-10
    b11 = b12*h + e11
    e10 = e12*w + 2.08767569878681e-09
    b10 = b11*h + e10
    e9 = e11*w + 2.505210838544172e-08
    b9 = b10*h + e9
    e8 = e10*w + 2.755731922398589e-07
    b8 = b9*h + e8
    e7 = e9*w + 2.7557319223985893e-06
    b7 = b8*h + e7
    e6 = e8*w + 2.48015873015873e-05
    b6 = b7*h + e6
    e5 = e7*w + 0.0001984126984126984
    b5 = b6*h + e5
    e4 = e6*w + 0.001388888888888889
    b4 = b5*h + e4
    e3 = e5*w + 0.008333333333333333
    b3 = b4*h + e3
    e2 = e4*w + 0.041666666666666664
    b2 = b3*h + e2
    e1 = e3*w + 0.16666666666666666
    b1 = b2*h + e1
    e0 = e2*w
    b0 = b1*h + e0
    return b0


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
        lost12 = envelope2*lost11 + product_error(total12, envelope2_halves, total11_halves)
        return lost12 + total12

    def no(gamma, half, p_low, q, q_low, root, root_low, total2, whole, whole2):

        def yes(gamma, half, root, root_low, whole):
            sine = xp.sin(root)
            cosine = xp.cos(root)
            low = -root_low*sine
            total9 = half*sine
            total10 = total9/whole
            envelope = xp.exp(-half)
            return (1.0 - envelope*(cosine + low + total10))/xp.where(4.0 > gamma, 4.0, gamma)

        def no(gamma, p_low, q, q_low, root, root_low, whole2):

            def yes(p_low, q, q_low, root, root_low, whole2):
                fall_ = xp.exp(-q)
                fall2 = fall_ - fall_*q_low
                ratio = xp.exp(-2.0*root)
                ratio2 = ratio - 2.0*ratio*root_low
                whole3 = xp.where(q == 0.0, 1.0, q)
                none = whole3 - q
                top = none - xp.expm1(-q)
                total4 = top/whole3
                left4 = top - total4*whole3
                total4_halves = halves(xp, total4)
                whole3_halves = halves(xp, whole3)
                left5 = left4 - product_error(total4*whole3, total4_halves, whole3_halves)
                left6 = fall2*q_low + left5 - q_low*total4
                lost4 = left6/whole3
                whole4 = xp.where(root == 0.0, 1.0, 2.0*root)
                none2 = whole4 - 2.0*root
                top2 = none2 - xp.expm1(-2.0*root)
                total5 = top2/whole4
                left7 = top2 - total5*whole4
                total5_halves = halves(xp, total5)
                whole4_halves = halves(xp, whole4)
                left8 = left7 - product_error(total5*whole4, total5_halves, whole4_halves)
                left9 = left8 + 2.0*ratio2*root_low - 2.0*root_low*total5
                lost5 = left9/whole4
                total6 = fall2*total5
                fall2_halves = halves(xp, fall2)
                lost6 = fall2*lost5 + product_error(total6, fall2_halves, total5_halves)
                total7 = total4 - total6
                back4 = total7 - total4
                rest3 = total7 - back4
                one2 = total4 - rest3
                two2 = -back4 - total6
                lost7 = one2 + two2
                total8 = total7/whole2
                left10 = total7 - total8*whole2
                total8_halves = halves(xp, total8)
                whole2_halves = halves(xp, whole2)
                left11 = left10 - product_error(total8*whole2, total8_halves, whole2_halves)
                left12 = left11 + lost4 - lost6 + lost7 - p_low*total8
                lost8 = left12/whole2
                return lost8 + total8

            def no(gamma, q, q_low, root):
                fall_ = xp.exp(-q)
                fall2 = fall_ - fall_*q_low
                whole4 = xp.where(root == 0.0, 1.0, 2.0*root)
                none2 = whole4 - 2.0*root
                top2 = none2 - xp.expm1(-2.0*root)
                total5 = top2/whole4
                whole5 = xp.where(gamma == 0.0, 1.0, gamma)
                return (1.0 - fall2*(q*total5 + 1.0))/whole5

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
        fall2 = fall_ - fall_*q_low
        ratio = xp.exp(-2.0*root)
        ratio2 = ratio - 2.0*ratio*root_low
        return fall2*ratio2 + fall2

    return select(xp, total2 < 0.0, yes, (half, root, root_low), no, (q, q_low, root, root_low))


def apart_series(xp, h, w):
    """divided difference of sinh(sqrt)/sqrt at h^2 and w"""
    y = (h*h)
    e14 = 1.151633562077195e-37*w + 1.216125041553518e-34
    b14 = e14 + 1.151633562077195e-37*y
    e13 = e14*w + 1.1309962886447716e-31
    b13 = b14*y + e13
    e12 = e13*w + 9.183689863795546e-29
    b12 = b13*y + e12
    e11 = e12*w + 6.446950284384474e-26
    b11 = b12*y + e11
    e10 = e11*w + 3.868170170630684e-23
    b10 = b11*y + e10
    e9 = e10*w + 1.9572941063391263e-20
    b9 = b10*y + e9
    e8 = e9*w + 8.22063524662433e-18
    b8 = b9*y + e8
    e7 = e8*w + 2.8114572543455206e-15
    b7 = b8*y + e7
    e6 = e7*w + 7.647163731819816e-13
    b6 = b7*y + e6
    e5 = e6*w + 1.6059043836821613e-10
    b5 = b6*y + e5
    e4 = e5*w + 2.505210838544172e-08
    b4 = b5*y + e4
    e3 = e4*w + 2.7557319223985893e-06
    b3 = b4*y + e3
    e2 = e3*w + 0.0001984126984126984
    b2 = b3*y + e2
    e1 = e2*w + 0.008333333333333333
    b1 = b2*y + e1
    e0 = e1*w + 0.16666666666666666
    b0 = b1*y + e0
    return b0


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
            total10 = total9/whole
            envelope = xp.exp(-half)
            whole6 = xp.where(delta == 0.0, 1.0, delta)
            return (decay(xp, delta) - 2.0*envelope*total10/whole6)/xp.where(4.0 > gamma, 4.0, gamma)

        def no(delta, q, q_low, root, root_low, total3):
            fall_ = xp.exp(-q)
            fall2 = fall_ - fall_*q_low
            ratio = xp.exp(-2.0*root)
            ratio2 = ratio - 2.0*ratio*root_low
            whole3 = xp.where(q == 0.0, 1.0, q)
            none = whole3 - q
            top = none - xp.expm1(-q)
            total4 = top/whole3
            left4 = top - total4*whole3
            total4_halves = halves(xp, total4)
            whole3_halves = halves(xp, whole3)
            left5 = left4 - product_error(total4*whole3, total4_halves, whole3_halves)
            left6 = fall2*q_low + left5 - q_low*total4
            lost4 = left6/whole3
            whole4 = xp.where(root == 0.0, 1.0, 2.0*root)
            none2 = whole4 - 2.0*root
            top2 = none2 - xp.expm1(-2.0*root)
            total5 = top2/whole4
            left7 = top2 - total5*whole4
            total5_halves = halves(xp, total5)
            whole4_halves = halves(xp, whole4)
            left8 = left7 - product_error(total5*whole4, total5_halves, whole4_halves)
            left9 = left8 + 2.0*ratio2*root_low - 2.0*root_low*total5
            lost5 = left9/whole4
            fast = fall2*ratio2
            twice = 2.0*fall2
            total6 = total5*twice
            twice_halves = halves(xp, twice)
            lost6 = lost5*twice + product_error(total6, twice_halves, total5_halves)
            total7 = total4 - total6
            back4 = total7 - total4
            rest3 = total7 - back4
            one2 = total4 - rest3
            two2 = -back4 - total6
            lost7 = one2 + two2
            total8 = fast*total4
            fast_halves = halves(xp, fast)
            lost8 = fast*lost4 + product_error(total8, fast_halves, total4_halves)
            top3 = total7 + total8
            low = lost4 - lost6 + lost7 + lost8
            whole5 = xp.where(delta*total3 == 0.0, 1.0, delta*total3)
            return (low + top3)/whole5

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
            wave2 = wave - 0.5*root_low*xp.sin(angle)
            return 4.0*(grown*grown) + 4.0*(wave2*wave2)*xp.exp(-half)

        return select(xp, cosine > 0.0, yes, (cosine, delta, half, root, root_low), no, (half, root, root_low))

    def no(q, q_low, total3):
        fast = xp.exp(-total3)
        slow = xp.exp(-q)
        slow2 = slow - q_low*slow
        return (fast + 1.0)*(slow2 + 1.0)

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
            left2 = left - product_error(root*root, root_halves, root_halves)
            low = 0.5*left2/whole
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
    e13 = e14*w + 3.279889237069838e-30
    b13 = b14*y + e13
    e12 = e13*w + 2.4795962632247976e-27
    b12 = b13*y + e12
    e11 = e12*w + 1.6117375710961184e-24
    b11 = b12*y + e11
    e10 = e11*w + 8.896791392450574e-22
    b10 = b11*y + e10
    e9 = e10*w + 4.110317623312165e-19
    b9 = b10*y + e9
    e8 = e9*w + 1.5619206968586225e-16
    b8 = b9*y + e8
    e7 = e8*w + 4.779477332387385e-14
    b7 = b8*y + e7
    e6 = e7*w + 1.1470745597729725e-11
    b6 = b7*y + e6
    e5 = e6*w + 2.08767569878681e-09
    b5 = b6*y + e5
    e4 = e5*w + 2.755731922398589e-07
    b4 = b5*y + e4
    e3 = e4*w + 2.48015873015873e-05
    b3 = b4*y + e3
    e2 = e3*w + 0.001388888888888889
    b2 = b3*y + e2
    e1 = e2*w + 0.041666666666666664
    b1 = b2*y + e1
    e0 = e1*w
    b0 = b1*y + e0
    return b0


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
        lost5 = envelope*lost4 + product_error(total5, envelope_halves, total4_halves)
        return 2.0*lost5 + 2.0*total5

    def no(delta, gamma, half, q, root, root_low, total2, total3):

        def yes(delta, gamma, half, root, root_low):

            def yes(delta, gamma):
                return (sinhc_root(xp, xp.where(delta != 0.0, 0.0, -0.25*gamma))*sinhc_root(xp, xp.where(delta != 0.0, 0.0, -0.25*gamma)))

            def no(gamma, half, root, root_low):
                grown = -0.5*xp.expm1(-half)
                angle = 0.5*root
                wave = xp.sin(angle)
                wave2 = 0.5*root_low*xp.cos(angle) + wave
                return 4.0*((grown*grown) + (wave2*wave2)*xp.exp(-half))/xp.where(4.0 > gamma, 4.0, gamma)

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
    square3 = (own1*own1)
    product2 = 4.0*own0*own2
    disc2 = square3 - product2
    size2 = square3 + xp.abs(product2)
    square4 = (far1*far1)
    product3 = 4.0*far0*square
    disc3 = square4 - product3
    size3 = square4 + xp.abs(product3)
    disc4 = xp.where((size >= size2) & (size2 <= size3), disc2, xp.where((size > size3) & (size2 > size3), disc3, disc))
    root = square_root(xp, xp.where(0.0 > disc4, 0.0, disc4))
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
    q2 = -0.5*own1 - 0.5*xp.where(case4, root, -root)
    case5 = own2 == 0.0
    lead2 = xp.where(case5, 1.0, own2)
    case6 = q2 == 0.0
    own3 = xp.where(case6, 1.0, q2)
    one2 = xp.where(case5, -1.0, q2/lead2)
    two2 = xp.where(case6, -1.0, own0/own3)
    low2 = xp.where(case4, one2, two2)
    high2 = xp.where(case4, two2, one2)
    case7 = far1 >= 0.0
    q3 = -0.5*far1 - 0.5*xp.where(case7, root, -root)
    lead3 = xp.where(case2, 1.0, square)
    case8 = q3 == 0.0
    own4 = xp.where(case8, 1.0, q3)
    one3 = xp.where(case2, -1.0, q3/lead3)
    two3 = xp.where(case8, -1.0, far0/own4)
    low3 = xp.where(case7, one3, two3)
    high3 = xp.where(case7, two3, one3)
    case9 = high3 > low
    edge = xp.where(case9, low, high3)
    case10 = (beyond - low2 > 0.0) & (center + low2 > 0.0) & (edge > xp.abs(low2))
    at = xp.where(case10, center + low2, xp.where(case9, low, 4.0 - high3))
    still = xp.where(case10, beyond - low2, xp.where(case9, 4.0 - low, high3))
    away = xp.where(case10, low2, xp.where(case9, low - center, beyond - high3))
    case11 = (disc4 >= 0.0) & (edge < 4.0) & (high3 > 0.0) & (low > 0.0)
    at2 = xp.where(case11, at, 2.0)
    still2 = xp.where(case11, still, 2.0)
    at3 = xp.where(0.0 > at2, 0.0, at2)
    still3 = xp.where(0.0 > still2, 0.0, still2)
    sine2 = 2.0*square_root(xp, at3*still3)
    x = away*(-2.0*e - 2.0)
    y = loss*sine2
    case12 = x < 0.0
    halves_ = xp.where(case12, xp.where(y < 0.0, xp.full_like(y, -1.0), 1.0), 0.0)
    turned = xp.atan2(xp.where(case12, -y, y), xp.abs(x))
    x2 = still3*together_ - apart_*at3
    y2 = n1*sine2
    case13 = x2 < 0.0
    halves2 = xp.where(case13, xp.where(y2 < 0.0, xp.full_like(y2, -1.0), 1.0), 0.0)
    turned2 = xp.atan2(xp.where(case13, -y2, y2), xp.abs(x2))
    x3 = alpha*still3 - at3*wall_far
    y3 = sine2*slope
    case14 = x3 < 0.0
    halves3 = xp.where(case14, xp.where(y3 < 0.0, xp.full_like(y3, -1.0), 1.0), 0.0)
    turned3 = xp.atan2(xp.where(case14, -y3, y3), xp.abs(x3))
    case15 = at3 > 2.0
    half = xp.atan2(xp.where(case15, square_root(xp, still3), square_root(xp, at3)), xp.where(case15, square_root(xp, at3), square_root(xp, still3)))
    late = d + 2.0
    halves4 = halves2 - halves_ + halves3 - xp.where(case15, late, 0.0)
    share = 0.5*(turned2 - late*xp.where(case15, -2.0*half, 2.0*half) - turned + turned3)/3.141592653589793
    even = xp.floor(0.5*halves4)
    left = 0.5*halves4 - even
    turns = even + xp.where(left == 0.5, xp.floor(share) + 1.0, xp.floor(left + share + 0.5))
    total = xp.where(case11, 2.0*turns, 0.0)
    case16 = high < low3
    edge2 = xp.where(case16, high, low3)
    case17 = (beyond - high2 > 0.0) & (center + high2 > 0.0) & (edge2 > xp.abs(high2))
    at4 = xp.where(case17, center + high2, xp.where(case16, high, 4.0 - low3))
    still4 = xp.where(case17, beyond - high2, xp.where(case16, 4.0 - high, low3))
    away2 = xp.where(case17, high2, xp.where(case16, high - center, beyond - low3))
    case18 = (disc4 >= 0.0) & (edge2 < 4.0) & (high > 0.0) & (low3 > 0.0)
    at5 = xp.where(case18, at4, 2.0)
    still5 = xp.where(case18, still4, 2.0)
    at6 = xp.where(0.0 > at5, 0.0, at5)
    still6 = xp.where(0.0 > still5, 0.0, still5)
    sine3 = 2.0*square_root(xp, at6*still6)
    x4 = away2*(-2.0*e - 2.0)
    y4 = loss*sine3
    case19 = x4 < 0.0
    halves5 = xp.where(case19, xp.where(y4 < 0.0, xp.full_like(y4, -1.0), 1.0), 0.0)
    turned4 = xp.atan2(xp.where(case19, -y4, y4), xp.abs(x4))
    x5 = still6*together_ - apart_*at6
    y5 = n1*sine3
    case20 = x5 < 0.0
    halves6 = xp.where(case20, xp.where(y5 < 0.0, xp.full_like(y5, -1.0), 1.0), 0.0)
    turned5 = xp.atan2(xp.where(case20, -y5, y5), xp.abs(x5))
    x6 = alpha*still6 - at6*wall_far
    y6 = sine3*slope
    case21 = x6 < 0.0
    halves7 = xp.where(case21, xp.where(y6 < 0.0, xp.full_like(y6, -1.0), 1.0), 0.0)
    turned6 = xp.atan2(xp.where(case21, -y6, y6), xp.abs(x6))
    case22 = at6 > 2.0
    half2 = xp.atan2(xp.where(case22, square_root(xp, still6), square_root(xp, at6)), xp.where(case22, square_root(xp, at6), square_root(xp, still6)))
    late2 = d + 2.0
    halves8 = halves6 - halves5 + halves7 - xp.where(case22, late2, 0.0)
    share2 = 0.5*(turned5 - late2*xp.where(case22, -2.0*half2, 2.0*half2) - turned4 + turned6)/3.141592653589793
    even2 = xp.floor(0.5*halves8)
    left2 = 0.5*halves8 - even2
    turns2 = even2 + xp.where(left2 == 0.5, xp.floor(share2) + 1.0, xp.floor(left2 + share2 + 0.5))
    total2 = total + xp.where(case18, -2.0*turns2, 0.0)
    side = xp.where(slope >= 0.0, xp.full_like(slope, 1.0), -1.0)
    end = xp.where(wall_far > 0.0, side, 0.0) - d + xp.where(apart_ > 0.0, xp.where(n1 >= 0.0, xp.full_like(n1, 1.0), -1.0), 0.0) - 3.0
    total3 = total2 + xp.where(((((near1 == 0.0) & (square < 0.0)) | (near1 < 0.0)) & (near0 == 0.0)) | (near0 < 0.0), xp.where(alpha > 0.0, 0.0, side), 0.0)
    return total3 - xp.where(((((far1 == 0.0) & (square < 0.0)) | (far1 < 0.0)) & (far0 == 0.0)) | (far0 < 0.0), end, 0.0)


def cos_next(xp, k, x):
    """cos((k + 1) x)"""
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    off = missed*x + product_error(angle, count_halves, x_halves)
    cosine = xp.cos(angle)
    return cosine - off*xp.sin(angle)


def sin_next(xp, k, x):
    """sin((k + 1) x)"""
    count = k + 1.0
    before = count - 1.0
    angle = count*x
    missed = k - before
    count_halves = halves(xp, count)
    x_halves = halves(xp, x)
    off = missed*x + product_error(angle, count_halves, x_halves)
    sine = xp.sin(angle)
    return off*xp.cos(angle) + sine


def gap(xp, x):
    """(x - sin(x))/x^3"""

    def yes(x):
        near = xp.where(xp.abs(x) >= 2.0, 0.0, x)
        square = -(near*near)
        b12 = 1.1309962886447716e-31*square + 9.183689863795546e-29
        b11 = b12*square + 6.446950284384474e-26
        b10 = b11*square + 3.868170170630684e-23
        b9 = b10*square + 1.9572941063391263e-20
        b8 = b9*square + 8.22063524662433e-18
        b7 = b8*square + 2.8114572543455206e-15
        b6 = b7*square + 7.647163731819816e-13
        b5 = b6*square + 1.6059043836821613e-10
        b4 = b5*square + 2.505210838544172e-08
        b3 = b4*square + 2.7557319223985893e-06
        b2 = b3*square + 0.0001984126984126984
        b1 = b2*square + 0.008333333333333333
        rest = b1*square + 9.25185853854297e-18
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
        along = cos_next(xp, k, x)
        wave = sinc(xp, 0.5*angle)
        inner = 0.5*(wave*wave) - gap(xp, angle)
        return order*(along*gap(xp, x) + 0.25*inner*(order*order))

    def no(k, turn, x):
        some = xp.where(turn < 1.5, 1.0, x)
        order = 2.0*k + 2.0
        along = cos_next(xp, k, x)
        return (2.0*sin_next(xp, k, x) - along*order*xp.sin(x))/(some*some*some)

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
        return (order*xp.sin(x) - 2.0*cos_next(xp, k, x)*sin_next(xp, k, x))/(some*some*some)

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
        t10 = sin_next(xp, d, theta)
        t11 = t1*t5*t7 - t1*t3*t6
        t12 = t9*cos_next(xp, d, theta)
        t13 = -t10*t8*t9 - t11*t12
        return t10*t11*t9 - t1*t13 - t12*t8, 0.5*t13*(t2 + 1.0)/t1

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
        return beta*cos_next(xp, d, theta) - 0.5*alpha*sin_next(xp, 2.0*d, t0)/xp.sin(t0) + delta

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
        t1 = (t2*t2)*(d + 1.0)*sin_next(xp, d, theta)/theta
        return 2.0*t0*t1, t0*(chord(xp, d, theta) - t1)

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
        t3 = 0.5*t1
        t4 = xp.sin(t2)
        return 2.0*delta*xp.tan(t2), delta*(t0 - 2.0*(t4*t4))/xp.sin(t3), t3

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
