"""The force that moves the sampled device, and the device behind a fraction of a period.

The differences in A/z and M are exact, that is, rounded once: what the boundary of stability loses
there it magnifies.
"""

from __future__ import annotations

from symhaptic.export.passes import late_numbers, merged, of_form
from symhaptic.export.routines.arithmetic import *
from symhaptic.export.routines.device import device_motion
from symhaptic.export.routines.prelude import *
from symhaptic.forms.form import Form


def less(one, factor, square, low):
    """one - factor (square + low), the larger part first.

    In numbers, not in pairs: the routine has to be short enough for compilers to find its tangent
    together with that of its caller.
    """
    taken = do("taken", factor * square)
    total, lost = two_diff(one, taken)
    missed = do("missed", TwoProdError(factor, square) + factor * low)
    return fast_two_sum(total, do("lost", lost - missed))


_DEVICE = sp.symbols("at_one at_minus_one loss together apart across")


def _force(psi, device):
    """A/z and M at z = exp(2 j psi), over cos(psi)^2, as pairs and the imaginary part of both.

    And the squared size of M.
    """
    at_one, at_minus_one, loss, together, apart, across = device
    t = do("t", tan(psi))
    square, low = do("square", t * t), do("low", TwoProdError(t, t))
    above = less(at_one, at_minus_one, square, low)
    below = less(together, apart, square, low)
    above_j, below_j = do("above_j", 2 * t * loss), do("below_j", t * across)
    rest = do("rest", below_j * below_j + 2 * below[0] * below[1])
    return above, above_j, below, below_j, do("size", below[0] * below[0] + rest)


@routine(device=_DEVICE)
def in_phase(psi, device):
    """the real part of A/(z M), M over A being the device, at z = exp(2 j psi)"""
    (above, above_low), above_j, (below, below_low), below_j, size = _force(psi, device)
    low = do("low", above_low * below + above * below_low)
    return do("found", above * below + do("rest", above_j * below_j + low)) / size


@routine(device=_DEVICE)
def ahead(psi, device):
    """the imaginary part of A/(z M), M over A being the device, at z = exp(2 j psi)"""
    (above, above_low), above_j, (below, below_low), below_j, size = _force(psi, device)
    low = do("low", above_j * below_low - above_low * below_j)
    return do("found", do("found", above_j * below - above * below_j) + low) / size


# -- behind a fraction of a period -------------------------------------------------------------


@routine()
def fractional_numerator_gap(epsilon, x: Pair, y: Pair, first, last, turned):
    """m2 - m1 + m0 of the device with a fractional delay"""
    share = scaled(epsilon, one_minus(epsilon))
    found, low = times(share, times(x, y))
    left = minus(minus(first, (2 * found, 2 * low)), last)
    return rounded(plus(left, turned))


_LIGHT = Rational(1, 4)
"""Half the damping up to which the sum of small terms rounds less."""


@routine()
def half_turned(found, gamma, delta, part):
    """m2 - m1 + m0 with a fractional delay"""
    # only a device that swings half a turn and more, lightly damped, has to be looked at
    half, (w, _), root, _ = device_motion(gamma, delta)
    swings = And(w < 0, root > 3, half < _LIGHT)
    return choose(swings, half_turned_swing(gamma, delta, part), found)


@routine()
def half_turned_swing(gamma, delta, part):
    """m2 - m1 + m0 of a lightly damped oscillating device"""
    # of half the angles that it turns in a period and in its two parts; without damping it is a
    # product, and each other term is as small as the damping
    half, w, root, _ = device_motion(gamma, delta)
    angle = do("angle", root / 2), do("angle_low", root_miss(w, root) / 2)
    odd, even = _waves(angle)
    rest = fast_two_sum(S.One, -part)
    (sine_1, cosine_1), (sine_2, cosine_2) = (_waves(times(angle, share)) for share in (rest, part))
    along = do("along", cosine_1 * cosine_2 + sine_1 * sine_2)
    across = do("across", sine_1 * cosine_2 - cosine_1 * sine_2)
    before = do("before", S.Half - part)
    step = do("step", expm1(half / 2))
    weak = do("weak", (step + step / (1 + step)) / 2)
    more = do("more", step * step / (1 + step) / 2)  # by which the cosine is larger than 1
    strong = do("strong", 1 + more)
    fallen = do("fallen", expm1(-half * before))
    grown = do("grown", 1 + fallen)
    ratio = do("ratio", half / do.divisor(root))
    lost = do("lost", weak * weak - even * along * (fallen * strong + more))
    turned = do("turned", grown * weak * odd * (across - ratio * along))
    kept = do("kept", grown * strong * even * ratio * across)
    total = do("total", lost + (turned - kept) - 2 * even * sine_1 * sine_2)
    return 4 * exp(-half) * total / do.divisor(gamma)


def _waves(angle: Pair):
    """Sine and cosine of an angle, and of what its float misses."""
    wave, still = do("wave", sin(angle[0])), do("still", cos(angle[0]))
    return do("sine", wave + angle[1] * still), do("cosine", still - angle[1] * wave)


@routine(record="Delayed")
def late_device(gamma, delta, part):
    """m2 - m1 + m0, m2, displacement by an impulse in the rest of the period, m0"""
    # both parts of the period are devices of their own, with a period so many times as long
    results = zip(("apart", "m2", "kicked", "m0"), late_numbers(part), strict=True)
    form = Form("late_device", "", (gamma, delta), tuple(results), tuple, ())
    return merged(of_form(form))
