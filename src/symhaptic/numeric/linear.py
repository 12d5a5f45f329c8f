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
    r"""Stiffness limit of the linear stability condition, alpha = (beta + delta)/(delay + 1/2).

    The limit is damping over delay; the hold adds half a period to the delay.

    Parameters
    ----------
    beta : array_like
        Virtual damping B T/m, finite.
    delta : array_like
        Physical damping b T/m, >= 0.
    delay : array_like
        Delay in sampling periods, >= 0, integer or fractional.  All arguments broadcast.
    digits : int, optional
        Return balls of python-flint (``flint.arb``) that are correct to this many digits.

    Returns
    -------
    float or ndarray
        The stiffness alpha = K T^2/m at which (25) of the paper is an equality; NaN gives NaN.

    Raises
    ------
    ValueError
        If ``beta`` is infinite, or ``delta`` or ``delay`` is negative or infinite.

    See Also
    --------
    limit_at : The exact largest stable stiffness for a damping.

    Notes
    -----
    For integer delays it is the straight part of the passivity boundary,
    -delta <= beta <= delta d/(2d + 3).  For a fractional delay it allows walls there that are not
    passive (chapter s6e_fractional_region).

    The exact stability boundary approaches this limit for small alpha and delta.  For delays of 0
    and 1 and an arm's spring and damping, (23), the limit is safe up to a crossing near

    .. math:: \alpha=\delta\,\frac{6(d+1)^2+1}{(d+1)(2d+1)(2d+3)}

    and unstable above it.  Without damping all of it is unstable (chapters s4e_line_*).

    Examples
    --------
    >>> float(linear_limit(0.0, 0.02, 1.5))
    0.01
    """
    if digits is not None:
        return in_digits(  # type: ignore[no-any-return]
            "linear_limit", digits, beta=beta, delta=delta, delay=delay
        )
    given = Given(beta=beta, delta=delta, delay=delay)
    return given(haptic.linear_limit)  # type: ignore[no-any-return]
