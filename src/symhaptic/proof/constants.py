"""A quoted number beside the ball that contains the true one."""

from __future__ import annotations

from decimal import Decimal

from flint import arb, ctx
from sympy import Expr

from symhaptic.paper.quoted import Quoted
from symhaptic.proof.ball import ball

DIGITS = 30
"""Digits given of a constant."""

_BITS = 4 * DIGITS + 32


class Unmeasured(ValueError):
    """A value that is not a real number known to enough digits."""


def measured(value: Expr | arb) -> arb:
    """A narrow ball around a real number, exact or in a ball already.

    Raises :class:`Unmeasured` for a number that may be complex or is known to less than
    twenty digits.
    """
    if isinstance(value, arb):
        found = value
    else:
        whole = ball(value, None, _BITS)
        if not whole.imag.is_zero():
            raise Unmeasured(f"{value} is not shown to be real")
        found = whole.real
    with ctx.workprec(_BITS):
        if not (found.is_finite() and found.rad() <= abs(found).lower() * arb(10) ** -20):
            raise Unmeasured(f"{value} is known to {found.str(5)} only")
    return found


def holds(quoted: Quoted, number: arb) -> bool | None:
    """Whether the text is right; None where the ball is too wide to tell.

    A number given as "about" so much is one that rounds to the printed digits.

    >>> holds(Quoted("about", "0.41"), measured(2**0.5 - arb(1))), holds(
    ...     Quoted("below", "0.27"), arb("0.28"))
    (True, False)
    """
    with ctx.workprec(_BITS):
        printed, half = arb(quoted.digits), arb(str(quoted.unit)) / 2
        below = {"about": printed + half, "below": printed}.get(quoted.how)
        above = {"about": printed - half, "above": printed}.get(quoted.how)
        if (below is not None and number > below) or (above is not None and number < above):
            return False
        decided = (below is None or number < below) and (above is None or number > above)
    return True if decided else None


def rounding(quoted: Quoted, number: arb) -> str:
    """How the last printed digit came about, as far as the number tells.

    >>> rounding(Quoted("above", "17.8"), arb("17.83")), rounding(
    ...     Quoted("below", "0.0562"), arb("0.05609"))
    ('17.8 is cut off', '0.0562 is looser than its digits: 0.0561 would hold')
    """
    digits = quoted.digits
    with ctx.workprec(_BITS):
        printed, unit = arb(digits), arb(str(quoted.unit))
        if quoted.how == "about":
            how = "rounded down" if number > printed else "rounded up"
        elif quoted.how == "above":
            spare = ((number - printed) / unit).lower().floor().unique_fmpz()
            how = "cut off" if spare == 0 else _looser(quoted, int(spare or 0))
        else:
            spare = ((printed - number) / unit).lower().floor().unique_fmpz()
            how = "rounded up" if spare == 0 else _looser(quoted, -int(spare or 0))
        if holds(quoted, number) is not True:
            how = f"not what it is: {number.str(6, radius=False)}"
    return f"{digits} is {how}"


def _looser(quoted: Quoted, units: int) -> str:
    better = Decimal(quoted.digits) + units * quoted.unit
    return f"looser than its digits: {better} would hold"


def decimals(number: arb) -> tuple[str, str]:
    """A number with thirty digits at most, and a bound of what they leave out."""
    text = number.str(DIGITS, radius=False)
    with ctx.workprec(_BITS):
        # two digits of a bound, widened by more than their rounding takes away
        radius = f"{1.1 * float(abs(number - arb(text)).abs_upper()):.1e}"
    return text, radius
