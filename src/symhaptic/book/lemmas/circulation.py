"""What the rules in circulation allow: walls with a margin at every angle, and a free mass."""

from __future__ import annotations

from sympy import cancel

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.linear_part import divisors as line_divisors
from symhaptic.book.lemmas.linear_part import margin_below, shares
from symhaptic.book.lemmas.passive_is_stable import MARGIN, passive_is_stable
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.scaling import moved
from symhaptic.notation import b
from symhaptic.proof.theorems.definitions import loop
from symhaptic.rules.claims import EXACT, STABLE, UNITS

HALF = S.Half
FREE = (alpha, beta, S.Zero, S.Zero, S.Zero)
"""A free mass without delay."""


def _scales() -> tuple[Theorem, ...]:
    """0 < T^2/m and 0 < T/m, and that m and T^2 are not zero."""
    mass, period = assume(m > 0), assume(T > 0)
    square = over(T**2 / m > 0, positive(T**2 > 0, [period, period]), mass)
    return square, over(T / m > 0, period, mass)


def apart() -> list[Theorem]:
    """m, T and T^2 are not zero."""
    return [positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0)]


def _stable(margins: Theorem) -> Theorem:
    """A damped wall that pushes, with a margin at every angle, is stable in SI units; d whole."""
    found = closed(conjunct(passive_is_stable(), EXACT), margins)
    square, ratio = _scales()
    found = inst(found, UNITS)
    sprung = positive(k * T**2 / m >= 0, [square, k >= 0])
    pushed = positive(K * T**2 / m > 0, [square, K > 0])
    stiff = positive(K * T**2 / m + k * T**2 / m > 0, [square, K > 0], [square, k >= 0])
    damped = positive(b * T / m > 0, [ratio, b > 0])
    return closed(found, stiff, sprung, damped, pushed, *apart())


def _undelayed_angles() -> tuple[Theorem, Theorem]:
    """sin((d + 1/2) theta) = sin(theta/2) and cos((d + 1) theta) = cos theta, for d = 0."""
    place, late = Symbol("q"), assume(Relation(S.Zero, "=", d))
    sides = (
        (sin((place + HALF) * theta), sin(theta / 2)),
        (cos((place + 1) * theta), cos(theta)),
    )
    found = [
        subst(Relation(turned, "=", plain), place, identity(plain, plain), late)
        for turned, plain in sides
    ]
    zero = combined(Relation(S.Zero, "=", d), [assume(Eq(d, 0)), -1])
    return closed(found[0], zero), closed(found[1], zero)


@cache
def twice_the_damping(rule: Any) -> Theorem:
    """0 < K <= 2b/T is stable for B = 0 without delay."""
    slow, _ = _undelayed_angles()
    half = sine_of_half(theta)
    undamped, room = assume(Eq(beta, 0)), assume(delta - alpha / 2 >= 0)
    cofactor = -cos((d + 1) * theta)
    margin = combined(
        MARGIN >= 0, [room], [slow, alpha / (2 * sin(theta / 2))], [undamped, cofactor]
    )
    margins = for_all([theta], INSIDE, closed(margin, not_zero(half)))
    found = _stable(margins)
    below = assume(rule)
    doubled = positive(2 * b - K * T >= 0, [assume(T > 0), below])
    size = over(1 / m > 0, one(), m > 0)
    enough = positive(b * T / m - K * T**2 / (2 * m) >= 0, [HALF, size, T > 0, doubled])
    damped = positive(b > 0, [HALF, doubled], [HALF, T > 0, K > 0])
    none = combined(Eq(B * T / m, 0), [assume(Eq(B, 0)), T / m])
    place = Symbol("q")
    now = combined(Relation(S.Zero, "=", d), [assume(Eq(d, 0)), -1])
    at_once = subst(whole(place), place, fact(whole(0)), now)
    return closed(found, enough, none, damped, at_once, *apart())


@cache
def damping_over_delay(rule: Any) -> Theorem:
    """0 < K < (b + B)/(dT + T/2) is stable for B <= b d/(2d + 3); d whole."""
    units = {K: alpha, B: beta, b: delta, T: S.One}
    room = assume(b + B - K * T * (d + HALF) >= 0)
    margins = inst(margin_below(room), units)
    margins = closed(margins, fact(Relation(S.Zero, "<", S.One)))
    found = _stable(margins)
    square, _ = _scales()
    size = over(1 / m > 0, one(), m > 0)
    more, low, high = shares()
    period = positive(d * T + T / 2 > 0, [HALF, T > 0, low])
    below = combined(b + B - K * T * (d + HALF) > 0, [period, assume(rule)])
    enough = positive(b * T / m + B * T / m - K * T**2 / m * (d + HALF) >= 0, [size, T > 0, below])
    range_ = assume(b * d / (2 * d + 3) >= B)
    inside = positive(d * (b * T / m) / (2 * d + 3) >= B * T / m, [size, T > 0, range_])
    total = positive(b + B > 0, [below], [HALF, K > 0, T > 0, low])
    share = over((2 * d + 3) / (d + 1) > 0, high, more)
    damped = positive(b > 0, [S.One / 3, share, total], [S.One / 3, share, range_])
    pushes = positive(K * T**2 / m >= 0, [square, K > 0])
    return closed(
        found, enough, inside, pushes, damped, not_zero(period), *apart(), *line_divisors()
    )


@cache
def free_mass() -> Theorem:
    """Without delay a wall of a free mass is stable <=> Jury's four inequalities."""
    meaning = closed(loop(FREE, z, stiffness=False, damping=False), fact(whole(0)))
    zeros: Any = meaning.conclusion.of[1]  # type: ignore[attr-defined]
    return chained(meaning, jury(zeros.of[0], z))


STILL = STABLE.at({k: S.Zero, b: S.Zero, d: S.Zero})
"""A free mass without delay, in SI units."""

NOTHING = [Eq(s, 0) for s in (k, b, d)]


def _inequalities() -> Theorem:
    """The same in SI units."""
    return closed(inst(free_mass(), {s: UNITS[s] for s in (alpha, beta)}), *apart())


@cache
def never_undamped() -> Theorem:
    """No stiffness K > 0 keeps a free mass stable without virtual damping."""
    known = [None, None, *map(assume, NOTHING)]
    there = mp(_inequalities(), moved(assume(STABLE), STILL, known))
    *_, minor = (conjunct(there, p) for p in there.conclusion.of)  # type: ignore[attr-defined]
    least = minor.conclusion.right  # type: ignore[attr-defined]
    spring, none = positive(K * T**2 / m > 0, [_scales()[0], K > 0]), assume(Eq(B, 0))
    rest = cancel((least + K * T**2 / (2 * m)) / B)
    denial = combined(Relation(least, "<=", S.Zero), [HALF, spring], [none, rest])
    return closed(not_intro(minor, denial, STABLE), *apart())


@cache
def damped_contact(rule: Any) -> Theorem:
    """0 < K < 2B (2m - BT)/(T (2m + BT)) keeps a free mass stable, for B > 0."""
    wanted = _inequalities()
    square, ratio = _scales()
    size = over(1 / m > 0, one(), m > 0)
    sum_ = positive(2 * m + B * T > 0, [2, m > 0], [B > 0, T > 0])
    below = positive(T * (2 * m + B * T) > 0, [T > 0, sum_])
    room = positive(2 * B * (2 * m - B * T) - K * T * (2 * m + B * T) > 0, [below, rule])
    stiff, damped, four, minor = wanted.conclusion.of[1].of  # type: ignore[attr-defined]
    shown = [
        positive(stiff, [square, K > 0]),
        positive(damped, [2, ratio, B > 0]),
        fact(four),
        positive(minor, [HALF**2, size, size, T > 0, room]),
    ]
    still = mp(wanted, conj(*shown))
    known = [None, None, *map(assume, NOTHING)]
    return closed(moved(still, STABLE, known), not_zero(below), *apart())


def outside(point: Mapping[Symbol, Expr]) -> Theorem:
    """That a loop is not stable, exactly, by a ball around a zero outside."""
    values = [point[s] for s in (alpha, beta, gamma, delta, d)]
    parts = {"stiffness": point[gamma] != 0, "damping": point[delta] != 0}
    meaning = closed(loop(values, z, **parts), fact(whole(point[d])))
    zeros: Any = meaning.conclusion.of[1]  # type: ignore[attr-defined]
    return denied_by(meaning, root_outside(zeros.of[0], z))
