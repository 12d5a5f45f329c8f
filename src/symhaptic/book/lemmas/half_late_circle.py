"""With a delay of half a period, a free mass: what keeps a stable wall from a zero on the half
circle.

The loop has the polynomial F = z^(l+2) (z-1)^2 + M W, and f = F(v^2) - q (v-1)^4 W(v^2)/8 is at
v = exp(j psi) that of a wall which is weaker by MU : KAPPA.  Where f is zero, F with its zeros
inside says (l + 2) (1 + KAPPA/MU)/2 < w, and w is the rise of the phase of W with 2 psi.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.principal import FREE, true_loop

q, n, u = (Symbol(name) for name in "qnu")
LOOP = (alpha, beta, S.Zero, S.Zero, l + HALF)
TRUE = Predicate("stable_loop", (), LOOP)
WALL = {alpha: alpha, beta: beta}
PUSH = alpha + beta
"""W = PUSH z - beta."""

TURN = exp(2 * I * psi)
C = cos(psi)
MU, TERM = (1 + C**2) / 2, (1 - C) ** 2 / 2
"""M/z and (v-1)^4/(8 z) at v = exp(j psi), which are real."""
KAPPA = MU - q * TERM
W = PUSH * TURN - beta
SIZE = alpha**2 + 2 * beta * PUSH * (1 - cos(2 * psi))
"""|W|^2."""
RISE = PUSH * (PUSH - beta * cos(2 * psi))
"""w |W|^2."""
LEAD = 2 * MU * RISE - (l + 2) * (MU + KAPPA) * SIZE
SQUARE = 4 * sin(psi) ** 2
"""|z - 1|^2."""
ZERO = Relation(KAPPA * W - SQUARE * exp(2 * I * (l + 2) * psi), "=", S.Zero)
"""f/z."""


def path(w: Expr) -> Expr:
    """f at v = exp(w)."""
    turn = exp(2 * w)
    wall = PUSH * turn - beta
    loop = exp(2 * w * (l + 2)) * (turn - 1) ** 2 + (turn**2 + 6 * turn + 1) / 8 * wall
    return loop - q * (exp(w) - 1) ** 4 * wall / 8


# -- what a stable wall is -------------------------------------------------------------


@cache
def zeros() -> Theorem:
    """All zeros of F lie inside."""
    return counted(mp(true_loop(FREE, WALL, l), assume(TRUE)))


@cache
def pushes() -> tuple[Theorem, Theorem, Theorem]:
    """0 < alpha and 0 < beta, by F(1) and 2 F'(1) - (l + 4) F(1) = 2 beta - l alpha."""
    found = counted(first_minors(zeros(), 1))
    static, slope = (conjunct(found, claim) for claim in found.conclusion.parts)
    spring = combined(alpha > 0, [static])
    brake = combined(beta > 0, [HALF, slope], [HALF, late(), spring])
    return spring, brake, positive(PUSH > 0, [spring], [brake])


def late() -> Theorem:
    """0 <= l."""
    return not_negative(assume(whole(l)))


def counted(theorem: Theorem) -> Theorem:
    """A theorem whose exponents are whole as l is."""
    return Given(whole(l)).closed(theorem)


@cache
def leads() -> Theorem:
    """0 < q TERM LEAD where f is zero: there F = q TERM z W, and n |F|^2 < 2 Re conj(F) z F'."""
    room, turned = outpaces(zeros(), 2 * psi), exp(2 * I * (l + 2) * psi)
    plant, push = turned * (TURN - 1) ** 2, MU * TURN * W
    speed = turned * ((l + 4) * TURN**2 - 2 * (l + 3) * TURN + l + 2)
    speed += (TURN + 3) / 4 * TURN * W + MU * TURN * PUSH * TURN
    speed -= (l + 4) / 2 * (plant + push)
    rate = l + 3 - I * C / sin(psi) - (l + 4) / 2
    beside = (mirror(speed) + q * TERM * mirror(TURN * W) * rate) * TURN
    zero = assume(ZERO)
    found = combined(q * TERM * LEAD > 0, [room], [zero, beside], [mirrored(zero), mirror(beside)])
    return counted(CORNER.closed(found, sine()))


# -- angles: 0 < psi <= pi/2 -----------------------------------------------------------


CORNER = Given(psi > 0, psi <= pi / 2)
sine = CORNER.lemma(sin(psi) > 0)
falls = CORNER.lemma(C < 1, lambda: rising(cos, S.Zero, psi))


@cache
def cosine() -> Theorem:
    """0 <= cos psi."""
    wanted, half, place = Relation(S.Zero, "<=", C), pi / 2, Symbol("u")
    less = show(wanted, CORNER.closed(sign_of(cos, psi)))
    end = both_ways(assume(psi <= half), assume(Relation(half, "<=", psi)))
    back = show(Relation(half, "=", psi), end)
    pattern = Relation(S.Zero, "<=", cos(place))
    there = subst(pattern, place, number(pattern.at({place: half})), back)
    return disj_cases(ordered(psi, half), less, there)


@cache
def middle() -> Theorem:
    """0 < MU."""
    return show(MU > 0)


@cache
def shares() -> tuple[Theorem, Theorem]:
    """0 < q TERM and q <= 1."""
    return show(q * TERM > 0, q > 0, falls()), show(1 - q >= 0, q <= 1)


@cache
def before() -> tuple[Theorem, Theorem]:
    """0 < cos psi and 0 < sin 2 psi, for 0 < cos 2 psi."""
    size = show(C * C > 0, cos(2 * psi) > 0)
    above = strictly(cosine(), combined(Ne(0, C), [factor(C, size, C), -S.One]))
    return above, show(sin(2 * psi) > 0, sine(), above)


@cache
def chord_of_whole() -> Theorem:
    """-n sin u <= sin n u <= n sin u for a whole n and 0 <= sin u."""
    low, high = -n * sin(u) <= sin(n * u), sin(n * u) <= n * sin(u)
    claim = conj(assume(low), assume(high)).conclusion
    known, some = assume(claim), assume(sin(u) >= 0)
    below, above = (conjunct(known, c) for c in claim.parts)
    more, less, up, down = (
        show(1 + c >= 0, square(1 + c), bounded(cos, angle))
        for angle in (u, n * u)
        for c in (cos(angle), -cos(angle))
    )
    then = claim.at({n: n + 1})
    step = conj(
        combined(then.parts[0], [HALF, more, below], [HALF, less, above], [some, up]),
        combined(then.parts[1], [HALF, more, above], [HALF, less, below], [some, down]),
    )
    start = claim.at({n: S.Zero})
    step = disch(add_assum(step, whole(n), claim), whole(n), claim)
    return induction(claim, n, conj(*map(number, start.parts)), step)


# -- no zero ---------------------------------------------------------------------------


@cache
def behind_beyond() -> Theorem:
    """q TERM LEAD <= 0 for cos 2 psi <= 0: there w <= 1, and 2 <= l + 2."""
    spring, brake, stiff = pushes()
    back, (share, less) = assume(cos(2 * psi) <= 0), shares()
    size = show(SIZE >= 0, spring, brake, stiff, square(sin(psi)), degree=3)
    weak = show(KAPPA >= 0, less, square(C), q > 0, cosine())
    return combined(
        Relation(q * TERM * LEAD, "<=", S.Zero),
        [share, 2, middle(), brake, brake],
        [share, 2, middle(), stiff, brake, back],
        [share, late(), middle(), size],
        [share, late(), weak, size],
        [share, 2, weak, size],
    )


@cache
def on_the_ray() -> tuple[Theorem, Theorem]:
    """Where f is zero: KAPPA^2 |W|^2 = SQUARE^2, and with z = exp(j theta)
    KAPPA^2 w |W|^2 sin theta = SQUARE^2 sin((l+2) theta) cos((l+1) theta)."""
    zero, turn = assume(ZERO), 2 * (l + 1) * psi
    other = mirrored(zero)
    across, along = KAPPA * PUSH * sin(2 * psi), KAPPA * (PUSH - beta * cos(2 * psi))
    ahead = SQUARE * sin(turn + 2 * psi)
    size = combined(
        Relation(KAPPA**2 * SIZE, "=", SQUARE**2),
        [zero, KAPPA * mirror(W)],
        [other, SQUARE * exp(2 * I * (l + 2) * psi)],
    )
    rise = combined(
        Relation(across * along, "=", ahead * SQUARE * cos(turn)),
        [zero, along / (2 * I) + ahead / (2 * TURN)],
        [other, -along / (2 * I) + ahead * TURN / 2],
    )
    return size, rise


@cache
def spare() -> Theorem:
    """(l + 2) q TERM <= 2 (l + 1) MU sin^2 2 psi for 0 < cos 2 psi."""
    ahead, some, (_, less) = assume(cos(2 * psi) > 0), before()[0], shares()
    count = show(l + 1 > 0, late())
    rest = positive(
        4 * C**2 * (1 + C**2) * (1 + C) - (1 - C) > 0,
        *([2, ahead, *([some] * k)] for k in range(4)),
        *([factor_, *([some] * k)] for k, factor_ in enumerate((S.One, 3, 2, 2))),
    )
    return positive(
        2 * (l + 1) * MU * sin(2 * psi) ** 2 - (l + 2) * q * TERM >= 0,
        [falls(), count, rest],
        [HALF, falls(), falls(), late()],
        [HALF, falls(), falls(), late(), less],
        [falls(), falls(), less],
    )


@cache
def behind_before() -> Theorem:
    """KAPPA^2 sin 2 psi q TERM LEAD <= 0 for 0 < cos 2 psi: w <= 1 + (l + 1) cos^2 2 psi."""
    ahead, (_, some), (share, _) = assume(cos(2 * psi) > 0), before(), shares()
    count, turn = l + 1, 2 * (l + 1) * psi
    size, rise = on_the_ray()
    flat = inst(chord_of_whole(), {n: count, u: 4 * psi})
    flat = counted(closed(flat, show(sin(4 * psi) >= 0, some, ahead)))
    above = conjunct(flat, flat.conclusion.parts[1])
    small = show(1 - cos(turn) ** 2 >= 0, bounded(cos, turn))
    return combined(
        Relation(KAPPA**2 * sin(2 * psi) * q * TERM * LEAD, "<=", S.Zero),
        [size, -q * TERM * (l + 2) * (MU + KAPPA) * sin(2 * psi)],
        [rise, 2 * MU * q * TERM],
        [share, square(SQUARE), 2, middle(), some, small],
        [share, square(SQUARE), middle(), ahead, above],
        [share, square(SQUARE), some, spare()],
    )


@cache
def no_crossing() -> Theorem:
    """f != 0 at exp(j psi), 0 < psi <= pi/2."""
    ahead, (above, some), (_, less) = leads(), before(), shares()
    weak = show(KAPPA > 0, less, show(TERM > 0, falls()), above)
    size = show(KAPPA**2 * sin(2 * psi) > 0, weak, some)
    more = combined(KAPPA**2 * sin(2 * psi) * q * TERM * LEAD > 0, [size, ahead])
    cases = not_intro(more, behind_before()), not_intro(ahead, behind_beyond())
    wrong = disj_cases(ordered(0, cos(2 * psi)), *cases)
    root = combined(ZERO, [assume(Eq(path(I * psi), 0)), 1 / TURN])
    return differs(path(I * psi), closed(wrong, root))


def differs(value: Expr, wrong: Theorem) -> Theorem:
    """p != 0, from what is wrong if p = 0."""
    wanted: Any = proposition(Ne(value, 0))
    return disj_cases(decided(value, S.Zero), contr(wrong, wanted), assume(wanted))
