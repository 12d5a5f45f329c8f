"""A free mass behind an actuator that lags: no stable stiffness is above that of the delay."""

from __future__ import annotations

from symhaptic.book.lemmas.decided import SI
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import tau_a
from symhaptic.proof.theorems.analysis import grows
from symhaptic.rules.other_loops import FADING, FOLLOWING, LAG

h, u = symbols("h u")
AHEAD, BEFORE = Given(h > 0), Given(u > 0, u < h)


def _from_zero(rest: Expr, slope: Theorem) -> Theorem:
    """0 < f(h) for f(0) = 0 and a positive slope before."""
    return grows(rest, u, S.Zero, h, slope)


def _at_u(theorem: Theorem) -> Theorem:
    return BEFORE.closed(inst(theorem, {h: u}))


@cache
def exponentials() -> list[Theorem]:
    """1 < e^h, 1 + h < e^h, 1 + h + h^2/2 < e^h and 2 (e^h - 1) < h (e^h + 1), for h > 0."""
    grown = show(exp(h) - 1 > 0, rising(exp, S.Zero, h))
    found = [AHEAD.closed(grown)]
    for rest in exp(u) - 1 - u, exp(u) - 1 - u - u**2 / 2:
        found.append(_from_zero(rest, show(derivative(rest, u) > 0, _at_u(found[-1]))))
    rest = u * exp(u) - exp(u) + 1
    bent = combined(derivative(rest, u) > 0, [assume(u > 0), sign_of(exp, u)])
    turned = _at_u(_from_zero(rest, bent))
    rest = u * (exp(u) + 1) - 2 * (exp(u) - 1)
    found.append(_from_zero(rest, show(derivative(rest, u) > 0, turned)))
    return found


LOOP = FOLLOWING.at({T: S.One, m: S.One})
LOST = 1 - FADING
TURN = 1 + FADING - 2 * LAG * LOST
AHEAD_BY = LAG * LOST - FADING
BENT = 4 * LAG**2 * LOST**2 - 4 * LAG * FADING * LOST - 2 * FADING * LOST
SIGNS = tuple(proposition(t > 0) for t in (LOST, LAG, TURN, AHEAD_BY, BENT))


@cache
def in_units() -> Theorem:
    """A stable wall has K (1/2 + tau) < B for m = T = 1, by two of Hurwitz' inequalities."""
    found = first_minors(assume(LOOP), 2)
    _, first, second = (conjunct(found, p) for p in found.conclusion.parts)
    lag, turn, ahead, bent = map(assume, SIGNS[1:])
    pushes, damps = assume(K > 0), assume(B > 0)
    surplus = 8 * LOST**2 * (B - K * (LAG + S.Half))
    rows = (
        [second],
        [2, first, lag, turn, pushes],
        [4, first, ahead, damps],
        [2, pushes, damps, bent],
    )
    above = combined(surplus > 0, *rows)
    share = show(1 / (8 * LOST**2) > 0, SIGNS[0])
    return combined(K * (LAG + S.Half) < B, [share, above])


@cache
def below_the_line() -> Theorem:
    """The same in SI units, K < B/(T/2 + tau)."""
    here = SI.and_(tau_a > 0, K > 0, B > 0)
    grown, once, twice, thrice = exponentials()
    h_ = T / tau_a
    fades = exp(-h)
    slow = Given(h > 0, *exponentials())
    signs = {FADING: fades, LAG: 1 / h}
    share, part = slow.show(1 / h > 0), sign_of(exp, -h)
    known = (
        combined(SIGNS[0].at(signs), [part, grown]),
        show(SIGNS[1].at(signs), share),
        combined(SIGNS[2].at(signs), [share, part, thrice]),
        combined(SIGNS[3].at(signs), [share, part, once]),
        combined(SIGNS[4].at(signs), [4, share, share, part, part, grown, twice]),
    )
    scale = {K: K * T**2 / m, B: B * T / m}
    found = inst(closed(inst(in_units(), signs), *known), scale | {h: h_})
    found = combined(B / (T / 2 + tau_a) > K, [here.show(m / (T * (T / 2 + tau_a)) > 0), found])
    return here.closed(found)


def holds(stable: Proposition, point: Mapping[Any, Any]) -> Theorem:
    """That a loop in numbers is stable, by balls around its zeros."""
    return roots_inside(stable.at(point).terms[0], z, {})
