"""The linear condition on a wall, (25) of the paper."""

from __future__ import annotations

from numpy.typing import ArrayLike

from symhaptic.kernels import haptic
from symhaptic.numeric.arguments import Array
from symhaptic.numeric.compiled import at_once
from symhaptic.numeric.containers import kept
from symhaptic.numeric.digits import in_digits
from symhaptic.numeric.given import Given


@at_once("linear_limit")
@kept(alpha=float)
def linear_limit(
    beta: ArrayLike, delta: ArrayLike, delay: ArrayLike, *, digits: int | None = None
) -> Array:
    """alpha = (beta + delta)/(delay + 1/2), the stiffness at which (25) is an equality.

    The limit is damping over delay; the hold adds half a period to the delay.  Arrays broadcast.
    For integer delays it is the straight part of the passivity boundary,
    -delta <= beta <= delta d/(2d + 3).  For a fractional delay it allows walls there that are not
    passive (chapter s6e_fractional_region).

    The exact stability boundary approaches this limit for small alpha and delta.  For
    delays of 0 and 1 and an arm's spring and damping, (23), the limit is safe up to a crossing near

        alpha = delta (6 (delay + 1)^2 + 1)/((delay + 1) (2 delay + 1) (2 delay + 3))

    and unstable above it; without damping all of it is unstable (chapters s4e_line_*).

    With ``digits`` each result is a ball of python-flint (``flint.arb``), right to so many digits.

    Raises :class:`ValueError` for an infinite ``beta`` and for a negative or infinite ``delta``
    or ``delay``; NaN gives NaN.

    >>> float(linear_limit(0.0, 0.02, 1.5))
    0.01
    """
    if digits is not None:
        return in_digits("linear_limit", digits, beta=beta, delta=delta, delay=delay)  # type: ignore[no-any-return]
    given = Given(beta=beta, delta=delta, delay=delay)
    return given(haptic.linear_limit)  # type: ignore[no-any-return]
