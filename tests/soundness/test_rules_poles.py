"""Poles and swinging devices: what a rule does not say is refused."""

from __future__ import annotations

import pytest
import sympy as sp
from sympy import I, S, exp, pi, symbols

from symhaptic.notation.proposition import Not, Predicate, Relation, whole
from symhaptic.notation.terms import NoTerm
from symhaptic.proof.theorems.familiar import held_by_a_pole, swinging
from symhaptic.proof.theorems.kernel import NotShown, assume
from symhaptic.proof.theorems.leaves import identity, number
from symhaptic.proof.theorems.roots import pole_at

alpha, beta, d, m, b, k, omega, sigma, z, q, y = symbols("alpha beta d m b k omega sigma z q y")
NYQUIST = (alpha, beta, pi**2, S.Zero, d)
NOTHING = identity(S.Zero, S.Zero)


def refused(*attempts: object) -> None:
    for attempt in attempts:
        with pytest.raises((NotShown, NoTerm)):
            attempt()  # type: ignore[operator]


def lt(a: object, b: object, sign: str = "<") -> Relation:
    return Relation(sp.sympify(a), sign, sp.sympify(b))


def test_a_pole_is_a_zero_of_the_polynomial() -> None:
    pole = pole_at(NYQUIST, z, 1, I * pi, NOTHING, damping=False)
    assert pole.conclusion == Predicate("pole", (), (*NYQUIST, -S.One))
    assert pole.hypotheses == {whole(d), *(whole(d + n) for n in (1, 2, 3))}
    refused(
        # another place, another spring, a damper, parts that are left out
        lambda: pole_at(NYQUIST, z, 1, S.Zero, NOTHING, damping=False),
        lambda: pole_at((alpha, beta, S.One, S.Zero, d), z, 1, I * pi, NOTHING, damping=False),
        lambda: pole_at((alpha, beta, pi**2, S.One, d), z, 1, I * pi, NOTHING),
        lambda: pole_at((alpha, beta, pi**2, S.One, d), z, 1, I * pi, NOTHING, damping=False),
        # a zero that is none of the polynomial, or no equation at all
        lambda: pole_at(NYQUIST, z, 1, I * pi, identity(y, y), damping=False),
        lambda: pole_at(NYQUIST, z, 1, I * pi, assume(lt(y, 0, "=")), damping=False),
        lambda: pole_at(NYQUIST, z, 1, I * pi, number(lt(0, 1)), damping=False),
        # no share of a period
        lambda: pole_at(NYQUIST, z, S.Half, I * pi, NOTHING, damping=False),
        lambda: pole_at(NYQUIST, z, 0, I * pi, NOTHING, damping=False),
        lambda: pole_at(NYQUIST, z, z, I * pi, NOTHING, damping=False),
    )


def test_the_variable_of_a_pole_s_polynomial_is_bound() -> None:
    zero = assume(lt(y, 0, "="))
    for share, exponent in ((z, I * pi), (1 + z, I * pi), (1, z), (q, z + I * pi), (I * q, I * pi)):
        with pytest.raises(NotShown, match="is bound"):
            pole_at(NYQUIST, z, share, exponent, zero, damping=False)


def test_that_the_delay_is_whole_shares_is_said() -> None:
    late = (alpha, beta, pi**2, S.Zero, d / q)
    pole = pole_at(late, z, q, I * pi, NOTHING, damping=False)
    assert {whole(q), whole(d), lt(0, q)} <= pole.hypotheses
    # with w^q = z at another branch w is no zero
    turned = exp(I * pi * (d / q + 1))
    refused(lambda: pole_at(late, z, q, I * pi, identity(turned, turned), damping=False))


def test_a_pole_inside_holds_nothing() -> None:
    pole = assume(Predicate("pole", (), (*NYQUIST, -S.One)))
    held = held_by_a_pole(pole, number(lt(1, 1, "<=")))
    assert held.conclusion == Not((Predicate("stable_substituted", (), NYQUIST),))
    inside = assume(Predicate("pole", (), (*NYQUIST, S.Half)))
    away = assume(Predicate("pole", (), (*NYQUIST, 2 * I)))
    refused(
        lambda: held_by_a_pole(inside, number(lt(1, 1, "<="))),
        lambda: held_by_a_pole(inside, number(lt(sp.Rational(1, 4), 1, "<="))),
        lambda: held_by_a_pole(away, number(lt(1, 4, "<="))),
        lambda: held_by_a_pole(number(lt(0, 1)), number(lt(1, 1, "<="))),
    )


def test_a_swing_needs_a_frequency() -> None:
    meaning = swinging((m, b, k, omega), sigma)
    # at omega = 0 the sine is no motion
    assert meaning.hypotheses == {lt(omega, 0, "!=")}
    with pytest.raises(NotShown):
        swinging((m, b, sigma, omega), sigma)
    with pytest.raises(NotShown):
        swinging((m, b, sp.sqrt(k), omega), sigma)
