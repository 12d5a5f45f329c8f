"""What every Python export begins with: how functions of numbers become functions of arrays.

How choices and loops, power series and searches are done for all elements; and its self-test.
"""

from symhaptic.export.precision import DOUBLE, SINGLE, Precision
from symhaptic.export.routines.walls import MOST


def _limits(precision: Precision) -> str:
    p = precision
    return f"{p.largest!r}, {p.stiffest!r}, {p.longest!r}, {p.below_pi!r}"


PRELUDE = '''import functools
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


DOUBLE = Limits(DOUBLE_LIMITS)
SINGLE = Limits(SINGLE_LIMITS)


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
'''.replace("DOUBLE_LIMITS", _limits(DOUBLE)).replace("SINGLE_LIMITS", _limits(SINGLE))

SELFTEST = """from pathlib import Path

import numpy as np

import NAME

COUNT = COUNTS
tried = missed = 0
for line in Path("vectors.txt").read_text(encoding="ascii").splitlines():
    name, *words = line.split()
    numbers = [float.fromhex(word) for word in words]
    count = COUNT[name]
    got = np.ravel(getattr(NAME, name)(*map(np.KIND, numbers[:count])))
    for i, value in enumerate(got):
        expected, allowed = numbers[count + 2*i : count + 2*i + 2]
        tried += 1
        if not abs(value - expected) <= allowed and not (np.isnan(value) and np.isnan(expected)):
            missed += 1
            print(f"{name}, result {i}: {value!r} instead of {expected!r}")
print(f"{tried} values, {missed} missed")
raise SystemExit(tried == 0 or missed > 0)
"""


# -- How a Python export takes the steps of a routine for all elements of arrays -----------------


STEPS = '''def select(xp, condition, yes, yes_values, no, no_values=None):
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
'''

SERIES = '''INVERSE_FACTORIAL = tuple(1/math.factorial(n) for n in range(40))
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
'''

CROSSING = '''def crossing(xp, value, low, high, close, given):
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
        b, fb, a, fa, _, _ = repeat(xp, MOST, over, step, start, given)
        return xp.where(xp.abs(fa) < xp.abs(fb), a, b)

    def beyond(low, above, high, *given):
        below = value(high, *given)
        known = low, above, high, below, *given
        return select(xp, below >= 0.0, lambda high: high, (high,), between, known)

    above = value(low, *given)
    return select(xp, above <= 0.0, lambda low: low, (low,), beyond, (low, above, high, *given))
'''.replace("MOST", str(MOST))

UNFUSED = '''def unfused(xp, product):
    """The product, rounded before it is added: XLA would fuse both into one operation."""
    held = deferred(product)
    return xp.where(xp.abs(product) < math.inf, product, math.nan) if held else product
'''

HALVES = '''def halves(xp, y):
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
'''

PRODUCT_ERROR = '''def two_prod_error(product, one, two):
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
'''
