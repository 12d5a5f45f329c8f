"""What the rules in circulation allow: walls with a margin at every angle, and a free mass."""

from sympy import cancel

from symhaptic.book.lemmas.linear_part import margin_below
from symhaptic.book.lemmas.passive_is_stable import MARGIN, passive_is_stable
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.scaling import moved
from symhaptic.proof.theorems.definitions import loop
from symhaptic.rules.claims import EXACT, UNITS
from symhaptic.rules.claims import STABLE as STABLE_IN_UNITS

FREE = (alpha, beta, S.Zero, S.Zero, S.Zero)
"""A free mass without delay."""


SI = Given(m > 0, T > 0)
for scale in T**2 / m > 0, T / m > 0, 1 / m > 0:
    SI.have(scale)


def _stable(margins: Theorem, *known: Any) -> Theorem:
    """A damped wall that pushes, with a margin at every angle, is stable in SI units; d whole."""
    found = inst(closed(conjunct(passive_is_stable(), EXACT), margins), UNITS)
    return SI.and_(K > 0, k >= 0, d >= 0).closed(found, *known)


def _undelayed_angles() -> tuple[Theorem, Theorem]:
    """sin((d + 1/2) theta) = sin(theta/2) and cos((d + 1) theta) = cos theta, for d = 0."""
    place, late = Symbol("q"), assume(Relation(S.Zero, "=", d))
    sides = ((sin((place + HALF) * theta), sin(theta / 2)), (cos((place + 1) * theta), cos(theta)))
    found = [
        subst(Relation(turned, "=", plain), place, identity(plain, plain), late)
        for turned, plain in sides
    ]
    zero = show(Eq(S.Zero, d), Eq(d, 0))
    return closed(found[0], zero), closed(found[1], zero)


@cache
def twice_the_damping(rule: Any) -> Theorem:
    """0 < K <= 2b/T is stable for B = 0 without delay."""
    slow, _ = _undelayed_angles()
    undamped, room = assume(Eq(beta, 0)), assume(delta - alpha / 2 >= 0)
    cofactor = -cos((d + 1) * theta)
    margin = combined(
        MARGIN >= 0, [room], [slow, alpha / (2 * sin(theta / 2))], [undamped, cofactor]
    )
    margins = for_all([theta], INSIDE, Given(*INSIDE).closed(margin, sine_of_half(theta)))
    here = SI.and_(K > 0, rule)
    damped = here.show(b > 0), here.show(2 * b - K * T >= 0)
    place = Symbol("q")
    at_once = subst(whole(place), place, fact(whole(0)), show(Eq(S.Zero, d), Eq(d, 0)))
    return SI.closed(closed(_stable(margins, *damped, Eq(B, 0)), at_once))


@cache
def damping_over_delay(rule: Any) -> Theorem:
    """0 < K < (b + B)/(dT + T/2) is stable for B <= b d/(2d + 3); d whole."""
    units = {K: alpha, B: beta, b: delta, T: S.One}
    room = assume(b + B - K * T * (d + HALF) >= 0)
    margins = inst(margin_below(room), units)
    here = SI.and_(d >= 0, whole(d), K > 0, rule, b * d / (2 * d + 3) >= B)
    here.have((d + HALF) * T > 0)
    below = here.have(b + B - K * T * (d + HALF) > 0)
    total = here.have(b + B > 0, degree=3)
    share = here.show((2 * d + 3) / (d + 1) > 0)
    range_ = assume(b * d / (2 * d + 3) >= B)
    damped = here.closed(positive(b > 0, [S.One / 3, share, total], [S.One / 3, share, range_]))
    return here.closed(_stable(Given().closed(margins), below, range_, damped))


@cache
def free_mass() -> Theorem:
    """Without delay a wall of a free mass is stable <=> Jury's four inequalities."""
    meaning = closed(loop(FREE, z, stiffness=False, damping=False), fact(whole(0)))
    zeros: Any = meaning.conclusion.of[1]  # type: ignore[attr-defined]
    return chained(meaning, jury(zeros.of[0], z))


STILL = STABLE_IN_UNITS.at({k: S.Zero, b: S.Zero, d: S.Zero})
"""A free mass without delay, in SI units."""

NOTHING = [Eq(s, 0) for s in (k, b, d)]


def _inequalities() -> Theorem:
    """The same in SI units."""
    return SI.closed(inst(free_mass(), {s: UNITS[s] for s in (alpha, beta)}))


@cache
def never_undamped() -> Theorem:
    """No stiffness K > 0 keeps a free mass stable without virtual damping."""
    known = [None, None, *map(assume, NOTHING)]
    there = mp(_inequalities(), moved(assume(STABLE_IN_UNITS), STILL, known))
    *_, minor = (conjunct(there, p) for p in there.conclusion.of)  # type: ignore[attr-defined]
    least = minor.conclusion.right  # type: ignore[attr-defined]
    spring, none = SI.show(K * T**2 / m > 0, K > 0), assume(Eq(B, 0))
    rest = cancel((least + K * T**2 / (2 * m)) / B)
    denial = combined(Relation(least, "<=", S.Zero), [HALF, spring], [none, rest])
    return SI.closed(not_intro(minor, denial, STABLE_IN_UNITS))


@cache
def damped_contact(rule: Any) -> Theorem:
    """0 < K < 2B (2m - BT)/(T (2m + BT)) keeps a free mass stable, for B > 0."""
    wanted = _inequalities()
    here = SI.and_(K > 0, B > 0, rule)
    room = here.show(2 * B * (2 * m - B * T) - K * T * (2 * m + B * T) > 0, T * (2 * m + B * T) > 0)
    still = mp(wanted, SI.and_(K > 0, B > 0).show(wanted.conclusion.of[1], room, degree=4))  # type: ignore[attr-defined]
    known = [None, None, *map(assume, NOTHING)]
    return here.closed(moved(still, STABLE_IN_UNITS, known))


def _exactly(point: Mapping[Symbol, Expr]) -> tuple[Theorem, Expr]:
    """stable <=> all zeros inside, behind whole delays, and the polynomial."""
    values = [point[s] for s in (alpha, beta, gamma, delta, d)]
    parts = {"stiffness": point[gamma] != 0, "damping": point[delta] != 0}
    meaning = closed(loop(values, z, **parts), fact(whole(point[d])))
    zeros: Any = meaning.conclusion.of[1]  # type: ignore[attr-defined]
    return meaning, zeros.of[0]


def inside(point: Mapping[Symbol, Expr]) -> Theorem:
    """That a loop is stable, exactly, by balls around its zeros."""
    meaning, polynomial = _exactly(point)
    return mp(meaning, roots_inside(polynomial, z, {}))


def outside(point: Mapping[Symbol, Expr]) -> Theorem:
    """That a loop is not stable, exactly, by a ball around a zero outside."""
    meaning, polynomial = _exactly(point)
    return denied_by(meaning, root_outside(polynomial, z))
