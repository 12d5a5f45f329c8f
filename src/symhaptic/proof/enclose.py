"""Numbers in balls as narrow as they are asked for."""

from __future__ import annotations

import sympy as sp
from flint import acb, arb, ctx
from sympy import Expr

from symhaptic.proof import box as boxes
from symhaptic.proof.asked import Ends, allowed_steps, box_of, exact, spend_reading
from symhaptic.proof.ball import ball, is_real
from symhaptic.proof.budget import STEPS, Exhausted, budget
from symhaptic.proof.certificate import Largest
from symhaptic.proof.normal import is_zero
from symhaptic.proof.program import Uncheckable, program
from symhaptic.proof.rewriting import Undefined, Unsupported

_LIMIT = 100_000
"""Most digits that may be asked for."""


def enclose(expr: Expr | int, digits: int = 20) -> arb | acb:
    """Return an interval (ball) that contains the value of a constant.

    Parameters
    ----------
    expr : SymPy expression or int
        An expression without symbols.  The normal form recognises zero.
    digits : int, optional
        The radius is below ``10**-digits`` of the value.

    Returns
    -------
    flint.arb or flint.acb
        The ball; ``acb`` for a complex number.

    Raises
    ------
    ValueError
        If the expression is no constant, or if no precision reaches the digits: it is undefined, or
        it is zero and the normal form does not recognise this.
    TypeError
        If ``expr`` is text, because SymPy would run it as a program.

    Examples
    --------
    >>> print(enclose(sp.sqrt(2) - 1, 30).str(30))
    [0.414213562373095048801688724210 +/- 3.02e-31]
    >>> print(enclose(sp.sin(1)**2 + sp.cos(1)**2 - 1))
    0
    """
    try:
        return _of_constant(exact("enclose", "expr", expr), digits)
    except RecursionError as deep:
        raise ValueError("enclose: expr is nested too deeply") from deep
    except (Undefined, ZeroDivisionError) as wrong:  # SymPy's of what nobody has evaluated
        raise ValueError("enclose: expr: a number in it divides by zero") from wrong


def _of_constant(expr: Expr, digits: int) -> arb | acb:
    if expr.free_symbols or not expr.is_commutative or expr.is_Matrix:
        raise ValueError(f"enclose: expr: {expr} is no constant; a number without symbols is")
    if isinstance(digits, bool) or not isinstance(digits, int) or not 1 <= digits <= _LIMIT:
        raise ValueError(f"enclose: digits: {digits!r} is not allowed; give 1 to {_LIMIT}")
    try:
        return _enclosed(expr, digits)
    except (Exhausted, Unsupported, Uncheckable) as wrong:
        raise ValueError(f"enclose: expr: {expr} is undecided: {wrong}") from wrong


def _enclosed(expr: Expr, digits: int) -> arb | acb:
    need = int(digits * 3.33) + 8
    for bits in (need + 32, 2 * need + 64, 4 * need + 256, 16 * need + 4096):
        value = ball(expr, None, bits)
        with ctx.workprec(bits):
            if value.is_finite() and value.rad() < abs(value).lower() * arb(10) ** -digits:
                _confirm(expr, value)
                return value.real if value.imag.is_zero() or is_real(expr) else value
            if value.contains(acb(0)) and bits == need + 32 and _is_zero(expr):
                _confirm(expr, acb(0))
                return arb(0)
    raise ValueError(f"enclose: expr: {expr} is not known to {digits} digits at {bits} bits")


def _confirm(expr: Expr, found: acb) -> None:
    """Raises unless another routine finds a number that may be the same one."""
    again = program(expr, [])()
    if not (again.is_finite() and again.overlaps(found)):
        raise ValueError(f"enclose: expr: {expr} is {found}, which is not confirmed by {again}")


def _is_zero(expr: Expr) -> bool:
    """Whether the normal form says so; where it cannot tell, a higher precision may."""
    try:
        with budget(STEPS):
            return is_zero(expr)
    except (Exhausted, Unsupported):
        return False
    except Undefined as wrong:
        raise ValueError(f"enclose: expr: {expr} is undefined: {wrong}") from wrong


def enclose_maximum(expr: Expr, box: Ends, digits: int = 6, *, steps: int = STEPS) -> Largest:
    """Bound the largest value of an expression on a box.

    Parameters
    ----------
    expr : SymPy expression
        Defined and real on the whole box.
    box : dict
        A closed interval for each symbol, ``{x: (0, 1)}``.
    digits : int, optional
        ``upper - lower`` is at most ``10**-digits``.
    steps : int, optional
        Steps of arithmetic at most.

    Returns
    -------
    Largest
        ``lower`` and ``upper`` bounds of the largest value, and ``where``, a point with a value of
        at least ``lower``.  It is a certificate that :func:`symhaptic.recheck` checks again.

    Raises
    ------
    ValueError
        If the expression is not defined and real on the whole box, has no largest value, or needs
        more than ``steps`` steps of arithmetic.

    Examples
    --------
    >>> x, y = sp.symbols("x y")
    >>> found = enclose_maximum(x*y*(1 - x*y), {x: (0, 1), y: (0, 1)}, digits=4)
    >>> found.lower <= sp.Rational(1, 4) <= found.upper
    True
    """
    allowed_steps("enclose_maximum", steps)
    if isinstance(digits, bool) or not isinstance(digits, int) or not 0 <= digits <= 15:
        raise ValueError(f"enclose_maximum: digits: {digits!r} is not allowed; give 0 to 15")
    try:
        with budget(steps):
            spend_reading(*(expr,) if isinstance(expr, Expr) else ())
        expr = exact("enclose_maximum", "expr", expr)
        inside, (expr,) = box_of("enclose_maximum", box, expr)
        return boxes.maximum(expr, inside, sp.Rational(1, 10**digits), steps=steps)
    except (Exhausted, boxes.NotShown, Unsupported, Uncheckable) as wrong:
        raise ValueError(f"enclose_maximum: expr: {wrong}") from wrong
    except RecursionError as deep:
        raise ValueError("enclose_maximum: expr is nested too deeply") from deep
    except (Undefined, ZeroDivisionError) as wrong:
        raise ValueError("enclose_maximum: expr: a number in it divides by zero") from wrong
