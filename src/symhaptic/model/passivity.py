r"""How much damping a sampled wall needs so that no motion can extract energy from it.

Whatever the device does within a period, only its displacement p over that period matters: the
wall's held force does the work F p, and the damper burns at least b p^2/T.  Summed over all
periods and written with the spectrum of p, this gives one inequality per angle.
"""

from __future__ import annotations

import sympy as sp
from sympy import Expr

from symhaptic.model import wall
from symhaptic.notation import B, K, T, b, d, theta, z


def on_circle(expr: Expr, angle: Expr = theta) -> Expr:
    """The value at z = exp(j theta), principal branch for powers: z^d = exp(j d theta)."""
    if expr == z:
        return sp.exp(sp.I * angle)
    if expr.is_Pow and expr.args[0] == z:
        return sp.exp(sp.I * angle * expr.args[1])
    if not expr.args:
        return expr
    return expr.func(*(on_circle(a, angle) for a in expr.args))


def mirror(expr: Expr) -> Expr:
    """The conjugate, of real symbols."""
    return expr.xreplace({sp.I: -sp.I})


def real_part(expr: Expr) -> Expr:
    """(X + conjugate of X)/2 for real symbols."""
    return (expr + mirror(expr)) / 2


def dissipated(response: Expr, angle: Expr = theta) -> Expr:
    """Energy burnt per squared displacement at one angle: b/T + Re of H/(z - 1)."""
    return b / T + real_part(on_circle(response / (z - 1), angle))


def required_damping(response: Expr, angle: Expr = theta) -> Expr:
    """The damping at which the energy at one angle is zero."""
    return b - T * dissipated(response, angle)


def dirichlet_form(angle: Expr = theta) -> Expr:
    """K T sin((d+1/2) theta)/(2 sin(theta/2)) - B cos((d+1) theta)."""
    half = sp.Rational(1, 2)
    kernel = sp.sin((d + half) * angle) / (2 * sp.sin(angle / 2))
    return K * T * kernel - B * sp.cos((d + 1) * angle)


def margin(angle: Expr = theta) -> Expr:
    """b minus the required damping: not negative at any angle of a passive wall."""
    return b - dirichlet_form(angle)


def envelope() -> tuple[Expr, Expr]:
    """(K, B) where the line of one angle meets the line of the next: margin and slope vanish."""
    line = margin(theta)
    slope = sp.diff(line, theta)
    system, rhs = sp.linear_eq_to_matrix([line, slope], [K, B])
    det = system[0, 0] * system[1, 1] - system[0, 1] * system[1, 0]
    return (
        (rhs[0] * system[1, 1] - system[0, 1] * rhs[1]) / det,
        (system[0, 0] * rhs[1] - rhs[0] * system[1, 0]) / det,
    )


def half_late_energy(first: Expr, second: Expr, periods: int) -> Expr:
    """Energy that a motion leaves to damper and wall, for a delay of half a period, d = 1/2.

    The device moves by ``first`` in the first half of a period, where the force is still that of
    the sample before, and by ``second`` in the other half; after ``periods`` periods it goes back
    with both signs reversed.  The damper burns at least 2 b/T times the squares.
    """
    energy, place, before, held = sp.S.Zero, sp.S.Zero, sp.S.Zero, sp.S.Zero
    for step in range(2 * periods):
        sign = 1 if step < periods else -1
        force = wall.force(place, before)
        energy += 2 * b / T * (first**2 + second**2)
        energy += sign * (held * first + force * second)
        place, before, held = place + sign * (first + second), place, force
    return sp.expand(energy)
