"""The loop by other means than the package: matrix exponentials, eigenvalues, certified roots.

Nothing here comes from ``symhaptic``.  The device x'' + delta x' + gamma x = u with a held input
is sampled by the exponential of [[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]; the wall is
u = -(alpha x + beta (x - x one period ago)), which arrives ``delay`` periods late.
"""

from fractions import Fraction
from functools import lru_cache

import flint
import mpmath
import numpy as np

_BITS = 256
"""Precision of the certified oracle: 77 decimal digits."""


# -- in float64, on stacks ------------------------------------------------------------------


def expm(matrices):
    """Exponentials of a stack of square matrices: scaling, Taylor's series, squaring."""
    matrices = np.asarray(matrices, dtype=float)
    norm = np.abs(matrices).sum(axis=-1).max(axis=-1, initial=1e-300)
    halvings = np.maximum(np.ceil(np.log2(norm)) + 2, 0)
    small = matrices / 2.0 ** halvings[..., None, None]
    unit = np.eye(matrices.shape[-1])
    total = np.broadcast_to(unit, matrices.shape)
    for k in range(14, 0, -1):  # 4^-15/15! = 7e-22
        total = unit + small @ total / k
    for k in range(int(halvings.max(initial=0))):
        total = np.where(k < halvings[..., None, None], total @ total, total)
    return total


def sampled(gamma, delta, span=1.0):
    """State transition (..., 2, 2) and effect of a held input (..., 2) over ``span`` periods."""
    gamma, delta, span = np.broadcast_arrays(gamma, delta, span)
    motion = np.zeros((*gamma.shape, 3, 3))
    motion[..., 0, 1] = span
    motion[..., 1, 0], motion[..., 1, 1], motion[..., 1, 2] = -gamma * span, -delta * span, span
    moved = expm(motion)
    return moved[..., :2, :2], moved[..., :2, 2]


def loops(alpha, beta, gamma, delta, delay):
    """State matrices of loops with one delay: x, v, the last x and the forces under way."""
    alpha, beta, gamma, delta = np.broadcast_arrays(alpha, beta, gamma, delta)
    steps = int(np.floor(delay))
    part = delay - steps
    free, late = sampled(gamma, delta)
    late = late[..., None]
    if part:  # the older force acts first, for ``part`` of the period
        after, newer = sampled(gamma, delta, 1 - part)
        _, older = sampled(gamma, delta, part)
        late = np.stack([newer, np.einsum("...ij,...j->...i", after, older)], axis=-1)
    under_way = steps + (part > 0)
    size = 3 + under_way
    matrix = np.zeros((*alpha.shape, size, size))
    force = np.zeros((*alpha.shape, size))
    force[..., 0], force[..., 2] = -(alpha + beta), beta
    matrix[..., :2, :2] = free
    matrix[..., 2, 0] = 1
    for age, effect in enumerate(np.moveaxis(late, -1, 0), start=steps):
        if age == 0:
            matrix[..., :2, :] += effect[..., None] * force[..., None, :]
        else:
            matrix[..., :2, 2 + age] += effect
    if under_way:
        matrix[..., 3, :] += force
        matrix[..., range(4, size), range(3, size - 1)] = 1
    return matrix


def moduli(alpha, beta, gamma, delta, delay):
    """Moduli of the loop's eigenvalues, for one delay."""
    return np.abs(np.linalg.eigvals(loops(alpha, beta, gamma, delta, delay)))


def each(function, *arguments):
    """``function(..., delay)`` group by group of equal delays, as one array per element."""
    *given, delay = np.broadcast_arrays(*arguments)
    found = np.zeros(delay.shape)
    for one in np.unique(delay):
        at = delay == one
        found[at] = function(*(a[at] for a in given), one)
    return found


def radius(alpha, beta, gamma, delta, delay):
    """Spectral radius of each loop."""
    return each(lambda *a: moduli(*a).max(axis=-1), alpha, beta, gamma, delta, delay)


def stable(alpha, beta, gamma, delta, delay):
    """Whether all eigenvalues of one loop lie inside the unit circle."""
    return bool(moduli(alpha, beta, gamma, delta, delay).max() < 1)


def sheets(alpha, beta, gamma, delta, delay):
    """The roots w = z^(1/q) of the polynomial with z^(p/q) in it, for a delay p/q, and q."""
    late = Fraction(delay)
    q, r = late.denominator, late.numerator
    (free, effect) = sampled(gamma, delta)
    a, e = np.trace(free), np.linalg.det(free)
    n1 = effect[0]
    n0 = effect[1] * free[0, 1] - effect[0] * free[1, 1]  # c adj(z - F) g
    p = np.zeros(r + 3 * q + 1)  # lowest power first
    p[[r + 3 * q, r + 2 * q, r + q]] = 1.0, -a, e
    for power, number in ((2 * q, n1 * (alpha + beta)), (q, n0 * (alpha + beta) - n1 * beta)):
        p[power] += number
    p[0] -= n0 * beta
    return np.roots(p[::-1]), q


def principal(alpha, beta, gamma, delta, delay):
    """Moduli of the roots on the principal sheet of z^delay, for one wall and a rational delay.

    With z = w^q the equation is a polynomial in w; the sheet is |arg w| < pi/q.
    """
    w, q = sheets(alpha, beta, gamma, delta, delay)
    w = w[np.abs(np.angle(w)) < np.pi / q]
    return np.abs(w) ** q


# -- certified ------------------------------------------------------------------------------


def _held(gamma, delta, span):
    motion = flint.arb_mat([[0, span, 0], [-gamma * span, -delta * span, span], [0, 0, 0]])
    moved = motion.exp()
    return moved[0, 0], moved[0, 1], moved[1, 0], moved[1, 1], moved[0, 2], moved[1, 2]


def coefficients(alpha, beta, gamma, delta, delay):
    """Balls of the characteristic polynomial's coefficients, lowest power first.

    The arguments are floats and count as the dyadic numbers that they are.
    """
    alpha, beta, gamma, delta = (flint.arb(float(v)) for v in (alpha, beta, gamma, delta))
    steps = int(np.floor(delay))
    part = flint.arb(float(delay)) - steps
    xx, xv, vx, vv, gx, gv = _held(gamma, delta, flint.arb(1))
    one, two = [gx], [gv]  # effect of the forces, the newest first
    if part > 0:
        rest_xx, rest_xv, rest_vx, rest_vv, new_x, new_v = _held(gamma, delta, 1 - part)
        *_, old_x, old_v = _held(gamma, delta, part)
        one = [new_x, rest_xx * old_x + rest_xv * old_v]
        two = [new_v, rest_vx * old_x + rest_vv * old_v]
    # the transfer is (1, 0) (z - F)^-1 g, its numerator (z - vv) gx + xv gv
    top = [-vv * x + xv * v for x, v in zip(one, two, strict=True)]
    top = flint.arb_poly([top[0], one[0]]) * flint.arb_poly([0, 1]) ** (len(one) - 1) + (
        flint.arb_poly([top[1], one[1]]) if len(one) > 1 else 0
    )
    bottom = flint.arb_poly([xx * vv - xv * vx, -(xx + vv), 1])
    shift = flint.arb_poly([0, 1]) ** (steps + len(one))
    return bottom * shift + top * flint.arb_poly([-beta, alpha + beta])


def certified(alpha, beta, gamma, delta, delay):
    """Roots outside the unit circle, counted with balls that exclude every other answer."""
    with flint.ctx.workprec(_BITS):
        p = coefficients(alpha, beta, gamma, delta, delay)
        roots = flint.acb_poly(p).roots(tol=flint.arb(2) ** -100)
        outside = 0
        for root in roots:
            size = root.real * root.real + root.imag * root.imag
            if size > 1:
                outside += 1
            elif not size < 1:
                raise ArithmeticError(f"the ball {root} meets the circle")
    return outside


def all_inside(alpha, beta, gamma, delta, delay):
    """Whether all roots lie inside the unit circle, by the Schur-Cohn recursion in balls.

    None where a root is on the circle, or nearer than balls of 6000 bits tell.
    """
    bits = 320
    while bits < 6000:
        with flint.ctx.workprec(bits):
            found = _schur_cohn(coefficients(alpha, beta, gamma, delta, delay).coeffs())
        if found is not None:
            return found
        bits *= 3
    return None


def _schur_cohn(p):
    """The same of balls of coefficients, lowest power first; None where they are too wide."""
    while len(p) > 1:
        share = p[0] / p[-1]
        if not abs(share) < 1:
            return False if abs(share) >= 1 else None
        p = [x - share * y for x, y in zip(p[1:], p[-2::-1], strict=True)]
    return True


# -- with mpmath ----------------------------------------------------------------------------


def _held_mp(gamma, delta, span):
    motion = mpmath.matrix([[0, 1, 0], [-gamma, -delta, 1], [0, 0, 0]]) * span
    moved = mpmath.expm(motion, method="taylor")
    return moved[:2, :2], moved[:2, 2]


@lru_cache(maxsize=256)
def numbers(gamma, delta, digits=60):
    """n1, n0, a and e: the sampled device is (n1 z + n0)/(z^2 - a z + e)."""
    with mpmath.workdps(digits):
        free, push = _held_mp(mpmath.mpmathify(gamma), mpmath.mpmathify(delta), 1)
        trace, product = free[0, 0] + free[1, 1], mpmath.det(free)
        return push[0], free[0, 1] * push[1] - free[1, 1] * push[0], trace, product


def named(gamma, delta, digits=60):
    """The same by their names."""
    return dict(zip(("n_1", "n_0", "a", "e"), numbers(gamma, delta, digits), strict=True))


def wall(theta, gamma, delta, delay, digits=60):
    """(alpha, beta) with a root at exp(j theta), z^delay on the principal sheet.

    The wall must be -1/P there: two real equations, solved as such.
    """
    n1, n0, trace, product = numbers(gamma, delta, digits)
    with mpmath.workdps(digits):
        theta = mpmath.mpmathify(theta)
        z = mpmath.expj(theta)
        wanted = -mpmath.expj(delay * theta) * (z**2 - trace * z + product) / (n1 * z + n0)
        rows = mpmath.matrix([[1, 1 - mpmath.cos(theta)], [0, mpmath.sin(theta)]])
        found = mpmath.lu_solve(rows, mpmath.matrix([wanted.real, wanted.imag]))
        return found[0], found[1]


def late_wall(theta, gamma, delta, delay, digits=60):
    """(alpha, beta) with a root at exp(j theta) for any delay, exact for fractions.

    The held force of ``delay`` periods ago acts for the rest of a period, the one before it first.
    """
    with mpmath.workdps(digits):
        theta, gamma, delta, delay = map(mpmath.mpf, (theta, gamma, delta, delay))
        z, steps = mpmath.expj(theta), mpmath.floor(delay)
        free, _ = _held_mp(gamma, delta, 1)
        after, newer = _held_mp(gamma, delta, 1 - (delay - steps))
        _, older = _held_mp(gamma, delta, delay - steps)
        push = (newer + after * older / z) * mpmath.expj(-steps * theta)
        # displacement per force: (1, 0) (z - F)^-1 push
        top = (z - free[1, 1]) * push[0] + free[0, 1] * push[1]
        needed = -(z**2 - (free[0, 0] + free[1, 1]) * z + mpmath.exp(-delta)) / top
        beta = needed.imag / mpmath.sin(theta)
        return needed.real - beta * (1 - mpmath.cos(theta)), beta


def residual(alpha, beta, theta, gamma, delta, delay, digits=50, sheet="exact"):
    """|p(z)| at z = exp(j theta) over the sum of the sizes of its terms, as a float.

    The terms are z^2, a z and e of the device's det(z - F), and alpha and beta (1 - 1/z) times its
    numerator: not the sum of the polynomial's coefficients, which is larger.
    """
    with mpmath.workdps(digits):
        alpha, beta, theta, gamma, delta, delay = (
            mpmath.mpf(float(v)) for v in (alpha, beta, theta, gamma, delta, delay)
        )
        z = mpmath.expj(theta)
        free, effect = _held_mp(gamma, delta, 1)
        trace, e = free[0, 0] + free[1, 1], mpmath.exp(-delta)
        if sheet == "principal" or delay == mpmath.floor(delay):
            push = effect * mpmath.expj(-delay * theta)
        else:
            steps = mpmath.floor(delay)
            after, newer = _held_mp(gamma, delta, 1 - (delay - steps))
            _, older = _held_mp(gamma, delta, delay - steps)
            push = (newer + after * older / z) * mpmath.expj(-steps * theta)
        # displacement per force: (1, 0) (z - F)^-1 push = top/det
        top = (z - free[1, 1]) * push[0] + free[0, 1] * push[1]
        backward = 1 - 1 / z
        size = 1 + abs(trace) + e + abs(top) * (abs(alpha) + abs(beta * backward))
        return float(abs(z**2 - trace * z + e + top * (alpha + beta * backward)) / size)


def mp_outside(alpha, beta, gamma, delta, delay, digits=60):
    """Roots outside the unit circle by mpmath's polyroots, started at NumPy's roots."""
    with flint.ctx.workprec(_BITS):
        balls = coefficients(alpha, beta, gamma, delta, delay).coeffs()
        texts = [c.str(digits + 10, radius=False) for c in balls]
    with mpmath.workdps(digits):
        numbers = [mpmath.mpf(t) for t in reversed(texts)]
        start = [mpmath.mpc(w) for w in np.roots([float(c) for c in numbers])]
        roots = mpmath.polyroots(numbers, maxsteps=100, extraprec=400, roots_init=start)
        return sum(abs(root) > 1 for root in roots)


def _turned(function, points):
    """How far the argument of a function turns on the way through the points, in steps below 0.3.

    Other steps are halved.
    """
    total, left, here = 0, list(reversed(points)), None
    value = function(left[-1])
    while left:
        end = left.pop()
        here = end if here is None else here
        middle, last = function((here + end) / 2), function(end)
        step = mpmath.arg(middle / value), mpmath.arg(last / middle)
        if max(map(abs, step)) > 0.3:
            left += [end, (here + end) / 2]
            continue
        total, value, here = total + sum(step), last, end
    return total


def principal_outside(alpha, beta, gamma, delta, delay, digits=60):
    """Roots with |z| > 1 and |arg z| < pi for any real delay, by the argument principle.

    Around the upper half: a large circle, the cut along the negative axis, the unit circle.
    """
    n1, n0, trace, product = numbers(gamma, delta, digits)
    with mpmath.workdps(digits):
        alpha, beta, late = (mpmath.mpf(float(v)) for v in (alpha, beta, delay + 0.0))

        def value(size, angle):
            z, power = mpmath.exp(size + 1j * angle), mpmath.exp((late + 1) * (size + 1j * angle))
            return power * (z * z - trace * z + product) + (n1 * z + n0) * (
                (alpha + beta) * z - beta
            )

        far = mpmath.log(10**16 * (1 + abs(alpha) + abs(beta)))
        near = [mpmath.mpf(10) ** -k for k in range(30, 0, -1)]
        angles = [0, *near, *(mpmath.pi * k / 60 for k in range(3, 58))]
        angles += [mpmath.pi - x for x in reversed(near)] + [mpmath.pi]
        sizes = [0, *near, *(far * k / 200 for k in range(1, 201))]
        turned = _turned(lambda angle: value(far, angle), angles)
        turned += _turned(lambda size: value(size, mpmath.pi), sorted(sizes, reverse=True))
        turned += _turned(lambda angle: value(0, angle), sorted(angles, reverse=True))
        found = turned / mpmath.pi
        assert abs(found - mpmath.nint(found)) < 1e-20
        return int(mpmath.nint(found))
