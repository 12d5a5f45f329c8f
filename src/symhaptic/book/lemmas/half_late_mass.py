"""Half a period late a wall that is stable for a free mass is stable in the paper's reading.

Exactly the loop has the polynomial F(z), and v P(v) = F(v^2) - (v-1)^4 W(v^2)/8 with the one that
the paper reads, v^2 = z.  Along f = F(v^2) - q (v-1)^4 W(v^2)/8, 0 < q <= 1, no zero crosses the
border of the region 0 < Re v, 1 <= |v|.
"""

from __future__ import annotations

from functools import cache
from typing import Any

from sympy import Eq, Expr, I, Ne, Rational, S, Symbol, cos, exp, expand, pi, sin

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.crossing import mirror
from symhaptic.book.lemmas.principal import FREE, read_loop, true_loop
from symhaptic.notation import alpha, beta, l, x, y
from symhaptic.notation.proposition import (
    Predicate,
    Proposition,
    Relation,
    proposition,
    whole,
)
from symhaptic.proof.theorems.analysis import induction
from symhaptic.proof.theorems.familiar import (
    bounded,
    both_ways,
    decided,
    full_turns,
    not_negative,
    ordered,
    rising,
    sign_of,
    square,
    strictly,
)
from symhaptic.proof.theorems.kernel import (
    Theorem,
    absurd,
    anything,
    applied,
    assume,
    by_cases,
    conjoined,
    discharged,
    part,
    placed,
    substituted,
    weakened,
)
from symhaptic.proof.theorems.leaves import (
    combined,
    factor,
    identity,
    is_whole,
    mirrored,
    number,
)
from symhaptic.proof.theorems.roots import first_minors, none_enters, outpaces
from symhaptic.proof.theorems.tactics import at, closed, every, fact, for_all, over, positive

q, t, n, v = (Symbol(name) for name in "qtnv")
HALF = Rational(1, 2)
LOOP = (alpha, beta, S.Zero, S.Zero, l + HALF)
TRUE, READ = (Predicate(f"stable_{name}", (), LOOP) for name in ("loop", "principal"))
WALLS = {alpha: alpha, beta: beta}
STIFF = alpha + beta
"""W = STIFF z - beta."""


def half_late_mass() -> Proposition:
    """A wall that is stable half a period late is stable on the principal sheet."""
    return every((alpha, beta, l), [whole(l), TRUE], READ)


# -- what a stable wall is -------------------------------------------------------------


@cache
def zeros() -> Theorem:
    """All zeros of F lie inside."""
    return applied(true_loop(FREE, WALLS, l), assume(TRUE))


@cache
def pushes() -> tuple[Theorem, Theorem, Theorem]:
    """0 < alpha, l alpha <= 2 beta and so 0 <= beta: F(1), and 2 F'(1) - (l + 4) F(1)."""
    found = first_minors(zeros(), 1)
    static, slope = (part(found, claim) for claim in found.conclusion.parts)
    spring = combined(alpha > 0, [static])
    late = not_negative(assume(whole(l)))
    brake = combined(beta > 0, [HALF, slope], [HALF, late, spring])
    return spring, brake, positive(STIFF > 0, [spring], [brake])


# -- on the half circle ----------------------------------------------------------------

TURN = exp(2 * I * t)
C = cos(t)
MU, D = (1 + C**2) / 2, (1 - C) ** 2 / 2
"""M/z and (v-1)^4/(8 z) at v = exp(j t), which are real."""
KAPPA = MU - q * D
WALL = STIFF * TURN - beta
SIZE = alpha**2 + 2 * beta * STIFF * (1 - cos(2 * t))
"""|W|^2."""
PULL = STIFF * (STIFF - beta * cos(2 * t))
"""Re z W' conj(W)."""
LEAD = 2 * MU * PULL - (l + 2) * (MU + KAPPA) * SIZE
ZERO = Relation(-4 * sin(t) ** 2 * exp(2 * I * (l + 2) * t) + KAPPA * WALL, "=", S.Zero)
"""f/z."""
ON = [q > 0, q <= 1, t > 0, t <= pi / 2]


@cache
def angles() -> dict[str, Theorem]:
    """Signs of sine and cosine of t and 2 t, 0 < t <= pi/2."""
    half = number(Relation(S.Zero, "<", pi / 2))
    low = positive(t > -pi / 2, t > 0, [half])
    sine = closed(sign_of(sin, t), positive(t < pi, t <= pi / 2, [half]))
    falls = closed(
        rising(cos, S.Zero, t),
        number(Relation(S.Zero, "<=", S.Zero)),
        positive(t <= pi, t <= pi / 2, [half]),
    )
    short = positive(D > 0, [HALF, falls, falls])
    middle = positive(MU > 0, [HALF, S.One], [HALF, square(C)])
    return {"sine": sine, "low": low, "short": short, "falls": falls, "middle": middle}


@cache
def leads() -> Theorem:
    """0 < q D LEAD where f is zero: there F = q D z W, and n |F|^2 < 2 Re conj(F) z F'."""
    room, late = outpaces(zeros(), 2 * t), exp(2 * I * (l + 2) * t)
    plant, push = late * (TURN - 1) ** 2, MU * TURN * WALL
    speed = late * ((l + 4) * TURN**2 - 2 * (l + 3) * TURN + l + 2)
    speed += (TURN + 3) / 4 * TURN * WALL + MU * TURN * STIFF * TURN
    speed -= (l + 4) / 2 * (plant + push)
    rate = l + 3 - I * C / sin(t) - (l + 4) / 2
    beside = (mirror(speed) + q * D * mirror(TURN * WALL) * rate) * TURN
    zero = assume(ZERO)
    found = combined(q * D * LEAD > 0, [room], [zero, beside], [mirrored(zero), mirror(beside)])
    return closed(found, not_zero(angles()["sine"]))


@cache
def behind_beyond() -> Theorem:
    """q D LEAD <= 0 for cos 2 t <= 0: there Re z W' conj(W) <= |W|^2, and 2 <= l + 2."""
    known, (spring, brake, stiff) = angles(), pushes()
    back, late = assume(cos(2 * t) <= 0), not_negative(assume(whole(l)))
    share = positive(q * D > 0, [q > 0, known["short"]])
    size = positive(SIZE >= 0, [spring, spring], [4, brake, stiff, square(sin(t))])
    middle, rest = known["middle"], _not_negative()
    return combined(
        Relation(q * D * LEAD, "<=", S.Zero),
        [share, 2, middle, brake, brake],
        [share, 2, middle, stiff, brake, back],
        [share, late, middle, size],
        [share, late, rest, size],
        [share, 2, rest, size],
    )


@cache
def _cosine() -> Theorem:
    """0 <= cos t, 0 < t <= pi/2."""
    wanted, half = Relation(S.Zero, "<=", C), pi / 2
    less = positive(wanted, [closed(sign_of(cos, t), angles()["low"])])
    place = Symbol("u")
    end = both_ways(assume(t <= half), assume(Relation(half, "<=", t)))
    back = combined(Relation(half, "=", t), [end, -S.One])
    there = substituted(
        Relation(S.Zero, "<=", cos(place)), place, number(Relation(S.Zero, "<=", S.Zero)), back
    )
    return by_cases(ordered(t, half), less, there)


@cache
def _not_negative() -> Theorem:
    """0 <= KAPPA."""
    less = positive(1 - q >= 0, q <= 1)
    more = positive(q >= 0, q > 0)
    return positive(KAPPA >= 0, [HALF, less], [HALF, less, square(C)], [more, _cosine()])


@cache
def behind_before() -> Theorem:
    """KAPPA^2 sin 2 t q D LEAD <= 0 for 0 < cos 2 t: there KAPPA W = 4 sin^2 t z^(l+2)."""
    known, late = angles(), not_negative(assume(whole(l)))
    ahead, zero = assume(cos(2 * t) > 0), assume(ZERO)
    other = mirrored(zero)
    share = positive(q * D > 0, [q > 0, known["short"]])
    cosine, sine = _cosine_before(), _sine_before()
    count, turn = l + 1, 2 * (l + 1) * t
    x_ = 4 * sin(t) ** 2
    forced = x_ * exp(2 * I * (l + 2) * t)
    across, along = KAPPA * STIFF * sin(2 * t), KAPPA * (STIFF - beta * cos(2 * t))
    # |W|^2 KAPPA^2 = x^2, and Re z W' conj(W) KAPPA^2 sin 2 t = x^2 sin((l+2) 2 t) cos((l+1) 2 t)
    size = combined(
        Relation(KAPPA**2 * SIZE, "=", x_**2),
        [zero, KAPPA * mirror(WALL)],
        [other, forced],
    )
    pull = combined(
        Relation(across * along, "=", x_**2 * sin(turn + 2 * t) * cos(turn)),
        [zero, along / (2 * I) + x_ * sin(turn + 2 * t) / (2 * TURN)],
        [other, -along / (2 * I) + x_ * sin(turn + 2 * t) * TURN / 2],
    )
    wide = square(x_)
    middle = known["middle"]
    small = positive(1 - cos(turn) ** 2 >= 0, [bounded(cos, turn)])
    flat = placed(chord_of_whole(), {n: count, u: 4 * t})
    flat = closed(
        flat, positive(sin(4 * t) >= 0, [2, sine, ahead]), is_whole(count, assume(whole(l)))
    )
    above = part(flat, flat.conclusion.of[1])  # type: ignore[attr-defined]
    return combined(
        Relation(KAPPA**2 * sin(2 * t) * q * D * LEAD, "<=", S.Zero),
        [size, -q * D * (l + 2) * (MU + KAPPA) * sin(2 * t)],
        [pull, 2 * MU * q * D],
        [share, wide, 2, middle, sine, small],
        [share, wide, middle, ahead, above],
        [share, wide, sine, spare()],
    )


@cache
def _cosine_before() -> Theorem:
    """0 < cos t for 0 < cos 2 t."""
    size = positive(C * C > 0, [HALF, cos(2 * t) > 0], [HALF])
    return strictly(_cosine(), combined(Ne(0, C), [factor(C, size, C), -S.One]))


@cache
def _sine_before() -> Theorem:
    """0 < sin 2 t."""
    return positive(sin(2 * t) > 0, [2, angles()["sine"], _cosine_before()])


@cache
def spare() -> Theorem:
    """(l + 2) q D <= 2 (l + 1) MU sin^2 2 t for 0 < cos 2 t."""
    late, ahead = not_negative(assume(whole(l))), assume(cos(2 * t) > 0)
    cosine, falls = _cosine_before(), angles()["falls"]
    less = positive(1 - q >= 0, q <= 1)
    count = positive(l + 1 > 0, [late], [S.One])
    rest = positive(
        4 * C**2 * (1 + C**2) * (1 + C) - (1 - C) > 0,
        [2, ahead],
        [2, ahead, cosine],
        [2, ahead, cosine, cosine],
        [2, ahead, cosine, cosine, cosine],
        [S.One],
        [3, cosine],
        [2, cosine, cosine],
        [2, cosine, cosine, cosine],
    )
    return positive(
        2 * (l + 1) * MU * sin(2 * t) ** 2 - (l + 2) * q * D >= 0,
        [falls, count, rest],
        [HALF, falls, falls, late],
        [HALF, falls, falls, late, less],
        [falls, falls, less],
    )


u = Symbol("u")


@cache
def chord_of_whole() -> Theorem:
    """-n sin u <= sin n u <= n sin u for a whole n and 0 <= sin u."""
    low, high = -n * sin(u) <= sin(n * u), sin(n * u) <= n * sin(u)
    claim = conjoined(assume(low), assume(high)).conclusion
    known, sine = assume(claim), assume(sin(u) >= 0)
    below, above = (part(known, c) for c in claim.parts)
    more, less, up, down = (
        positive(1 + s * cos(a) >= 0, *([HALF, x] for x in (square(1 + s * cos(a)), bounded(cos, a))))
        for a in (u, n * u)
        for s in (1, -1)
    )
    then = claim.at({n: n + 1})
    step = conjoined(
        combined(then.parts[0], [HALF, more, below], [HALF, less, above], [sine, up]),
        combined(then.parts[1], [HALF, more, above], [HALF, less, below], [sine, down]),
    )
    start = claim.at({n: S.Zero})
    step = discharged(weakened(step, whole(n), claim), whole(n), claim)
    return induction(claim, n, conjoined(*map(number, start.parts)), step)


@cache
def no_crossing() -> Theorem:
    """f != 0 at exp(j t), 0 < t <= pi/2."""
    ahead = leads()
    kappa = positive(KAPPA > 0, [positive(1 - q >= 0, q <= 1), angles()["short"]], [_cosine_before()])
    size = positive(KAPPA**2 * sin(2 * t) > 0, [kappa, kappa, _sine_before()])
    before = combined(KAPPA**2 * sin(2 * t) * q * D * LEAD > 0, [size, ahead])
    wanted = proposition(Ne(path(I * t), 0))
    falsehood = by_cases(
        ordered(0, cos(2 * t)),
        absurd(before, behind_before()),
        absurd(ahead, behind_beyond()),
    )
    root = combined(ZERO, [assume(Eq(path(I * t), 0)), 1 / TURN])
    return _not_zero(anything(closed(falsehood, root), wanted), wanted)


def _not_zero(contrary: Theorem, wanted: Any) -> Theorem:
    """p != 0, from that which follows from p = 0."""
    return by_cases(decided(wanted.left, S.Zero), contrary, assume(wanted))


# -- on the imaginary axis -------------------------------------------------------------


def path(w: Expr) -> Expr:
    """f at exp(w)."""
    turn = exp(2 * w)
    wall = STIFF * turn - beta
    loop = exp(2 * w * (l + 2)) * (turn - 1) ** 2 + (turn**2 + 6 * turn + 1) / 8 * wall
    return loop - q * (exp(w) - 1) ** 4 * wall / 8


@cache
def no_crossing_of_the_axis() -> Theorem:
    """f != 0 at j r, 1 < r = exp(t): of z^(l+2) (z-1)^2 and of W the imaginary part is zero."""
    _, brake, stiff = pushes()
    size, sign = exp(t), exp(I * pi * l)
    above = [sign_of(exp, t), assume(q > 0)]
    longer = closed(rising(exp, S.Zero, 2 * t), positive(2 * t > 0, [2, t > 0]))
    imaginary = q * size * (size**2 - 1) * (STIFF * size**2 + beta)
    some = combined(
        imaginary > 0, [*above, longer, stiff, sign_of(exp, 2 * t)], [*above, longer, brake]
    )
    whole_turns = full_turns(S.Zero, assume(whole(l)))
    sine, cosine = (part(whole_turns, claim) for claim in whole_turns.conclusion.parts)
    real = combined(Eq(sign, 1 / sign), [cosine, 1 / sign], [sine, I / sign])
    there = path(t + I * pi / 2)
    zero = assume(Eq(there, 0))
    none = combined(
        Relation(imaginary, "=", S.Zero),
        [zero, -I],
        [mirrored(zero), I],
        [real, I * exp(2 * t * (l + 2)) * (size**2 + 1) ** 2],
    )
    wanted = proposition(Ne(there, 0))
    return _not_zero(anything(absurd(some, none), wanted), wanted)


# -- to the right ----------------------------------------------------------------------


@cache
def stable_as_read() -> Theorem:
    """That."""
    spring, *_ = pushes()
    static = positive(Ne(alpha, 0), spring)
    change = -((v - 1) ** 4) * (STIFF * v**2 - beta) / 8
    shown = no_crossing(), static, no_crossing_of_the_axis()
    never = none_enters(zeros(), change, (v, q, t, x, y), *shown)
    sheet = read_loop(FREE, WALLS, l)
    wanted: Any = sheet.conclusion.parts[1]
    outside, apart = wanted.body.of
    known = at(never, {x: x, y: y}, *map(assume, outside.of))
    here = x + I * y
    right = [assume(x > 0), assume(Eq(here, 0))]
    twice = combined(Relation(2 * x, "=", S.Zero), [right[1]], [mirrored(right[1])])
    wrong = absurd(positive(2 * x > 0, [2, right[0]]), twice)
    there = proposition(Ne(here, 0))
    found = closed(factor(apart.left, known, -here), _not_zero(anything(wrong, there), there))
    found = applied(sheet, for_all((x, y), outside.of, found))
    steps = [
        is_whole(claim.of[0], assume(whole(l)))
        for claim in found.hypotheses
        if isinstance(claim, Predicate) and claim.name == "whole" and claim != whole(l)
    ]
    return for_all((alpha, beta, l), [whole(l), TRUE], closed(found, *steps))
