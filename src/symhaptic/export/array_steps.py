"""How a Python export takes the steps of a routine for all elements of arrays.

Choices and loops, power series, searches, and what products miss.
"""

from symhaptic.export.search import MOST

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

HALVES = '''def halves(xp, y):
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
