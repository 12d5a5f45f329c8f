"""Without stiffness: which damping is passive that is late by a fraction of a period?

With c = (1 - epsilon) cos (l+1) theta + epsilon cos (l+2) theta and v = epsilon (1 - epsilon)
sin^2(theta/2) the margin is b^2 + b B c - B^2 v, and by Lagrange's identity 1 + c - 2 v and
1 - c - 2 v are sums of two squares.
"""

from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.late_passivity import EVERY_MARGIN, GIVEN, MARGIN, passive_late
from symhaptic.book.lemmas.prelude import *

DAMPER = Predicate("passive_wall", (), (S.Zero, B, b, T, l + epsilon))
"""A wall without stiffness is passive, l + epsilon periods late."""
FALLS = MARGIN.subs(K, 0)
LOW = sin(pi / (4 * (l + 2)))
END = b * (1 + epsilon * (1 - epsilon) * LOW**2 / 2)
"""A damping above b, for 0 < epsilon < 1, that is passive still."""
EARLY = pi / (2 * (l + 2))
"""Below this angle both cosines of c are positive."""
ONE, TWO = (l + 1) * theta / 2, (l + 2) * theta / 2
PAIR = epsilon * (1 - epsilon)
LOSS = PAIR * sin(theta / 2) ** 2
RANGE = (-b <= B, B <= END)
HERE = Given(*GIVEN)
REST, SHARES = HERE.lemma(1 - epsilon >= 0), HERE.lemma(PAIR >= 0)
_lowest_sine = HERE.lemma(LOW > 0)


def limit_points() -> Proposition:
    """Passive damping is -b at least, from there to ``END`` all is passive, that is above b for a
    fraction, and nothing is above b/epsilon."""
    above = implied([epsilon > 0, epsilon < 1], b < END)
    claims = (
        every([B], [DAMPER], -b <= B),
        every([B], RANGE, DAMPER),
        above,
        every([B], [DAMPER], epsilon * B <= b),
    )
    return every([b, T, l, epsilon], GIVEN, both(claims))


@cache
def damping_late() -> Theorem:
    """That."""
    found = conj(
        for_all([B], [DAMPER], begins()),
        for_all([B], RANGE, all_between()),
        above_the_damper(),
        for_all([B], [DAMPER], ends()),
    )
    return for_all([b, T, l, epsilon], GIVEN, add_assum(found, *GIVEN))


@cache
def margin() -> Theorem:
    """0 <= the margin at an angle, of a passive damper."""
    found = passive_late()
    always = conjunct(mp(found, assume(found.conclusion.parts[0])), EVERY_MARGIN)
    found = at(always, {theta: theta}, *map(assume, INSIDE))
    return Given(*INSIDE).closed(inst(found, {K: S.Zero}), sine_of_half(theta))


@cache
def begins() -> Theorem:
    """-b <= B, from the limit b (b + B) of the margin."""
    limit = tends(FALLS, theta, S.Zero, b * (b + B))
    start = in_the_limit(margin(), theta, S.Zero, pi, limit)
    return HERE.closed(show(-b <= B, over(b * (b + B) / b >= 0, start, b > 0)))


@cache
def ends() -> Theorem:
    """epsilon B <= b, by the margin at theta = pi/(l+2)."""
    angle = pi / (l + 2)
    known = HERE.closed(inst(margin(), {theta: angle}))
    near = HERE.closed(weak_sine(pi / 2 - angle))
    room = combined(
        Relation(S.Zero, "<=", b * (b - epsilon * B)),
        [known],
        [assume(B >= 0), assume(b > 0), REST(), near],
        [SHARES(), square(B * sin(angle / 2))],
    )
    wanted = epsilon * B <= b
    damps = show(wanted, over(b * (b - epsilon * B) / b >= 0, room, b > 0))
    pushes = show(wanted, epsilon >= 0, B < 0, b > 0)
    return HERE.closed(disj_cases(ordered(B, S.Zero), pushes, damps))


@cache
def above_the_damper() -> Theorem:
    """b < END for 0 < epsilon < 1."""
    inside = HERE.and_(epsilon > 0, epsilon < 1)
    more = inside.show(b < END, inside.show(b * PAIR * LOW**2 / 2 > 0))
    return disch(more, epsilon > 0, epsilon < 1)


@cache
def _squares() -> tuple[Theorem, Theorem]:
    """0 <= 1 + c - 2 v and 0 <= 1 - c - 2 v."""
    rest = 1 - epsilon
    turn = rest * cos((l + 1) * theta) + epsilon * cos((l + 2) * theta)
    mixed = rest * sin(ONE) * cos(ONE) + epsilon * sin(TWO) * cos(TWO)
    along, across = (rest * f(ONE) ** 2 + epsilon * f(TWO) ** 2 for f in (cos, sin))
    return tuple(  # type: ignore[return-value]
        show(1 + sign * turn - 2 * LOSS >= 0, square(part_), square(mixed))
        for sign, part_ in ((1, along), (-1, across))
    )


@cache
def all_between() -> Theorem:
    """passive, for -b <= B <= END."""
    beyond = disj_cases(ordered(theta, EARLY), _early(), _late())
    falls = disj_cases(ordered(b, B), beyond, _weak())
    soft = assume(Eq(K, 0))
    share = sum(part_ / K for part_ in expand(FALLS - MARGIN).args)
    margin_ = combined(MARGIN >= 0, [falls], [soft, share])
    margin_ = Given(*INSIDE).closed(margin_, sine_of_half(theta))
    found = mp(passive_late(), conj(show(K >= 0, soft), for_all([theta], INSIDE, margin_)))
    return HERE.closed(inst(found, {K: S.Zero}))


def _weak() -> Theorem:
    """0 <= the margin for -b <= B <= b: it is concave."""
    loss = HERE.show(LOSS >= 0)
    return show(FALLS >= 0, b > 0, -b <= B, b >= B, *_squares(), loss, degree=3)


@cache
def _excess() -> tuple[Theorem, Theorem]:
    """B - b is b epsilon (1 - epsilon) LOW^2/2 at most, and less than b/2."""
    room = show(END - B >= 0, B <= END)
    half, low = square(epsilon - HALF), show(1 - LOW**2 >= 0, bounded(sin, EARLY / 2))
    return room, show(3 * b / 2 - B > 0, room, half, low, SHARES(), b > 0, degree=3)


def _late() -> Theorem:
    """0 <= the margin for b < B and pi/(2 (l+2)) <= theta: v is large."""
    plus, _ = _squares()
    pair, (room, less) = SHARES(), _excess()
    size, more = assume(b > 0), show(B - b > 0, b < B)
    here = HERE.and_(theta < pi, theta > 0, theta >= EARLY)
    here.have(EARLY > 0)
    here.have(pi - EARLY > 0)
    sines = (here.closed(weak_sine(x)) for x in ((theta - EARLY) / 4, (2 * pi - theta - EARLY) / 4))
    half, low = sine_of_half(theta), _lowest_sine()
    rises = show(sin(theta / 2) - LOW >= 0, *sines)
    loss = here.show(LOSS >= 0)
    found = combined(
        FALLS >= 0,
        [size, assume(b < B), plus],
        [size, size, plus],
        [size, room],
        [HALF, size, size, pair, rises, half],
        [HALF, size, size, pair, rises, low],
        [HALF, loss, less, size],
        [loss, less, more],
        [Rational(1, 4), loss, size, size],
    )
    return here.closed(found)


def _early() -> Theorem:
    """0 <= the margin for b < B and theta < pi/(2 (l+2)): both cosines are positive."""
    rest, pair, (_, less) = REST(), SHARES(), _excess()
    here = HERE.and_(theta > 0, theta < EARLY)
    here.have((l + 2) * theta < pi / 2)
    size, large = assume(b > 0), show(B > 0, b < B, b > 0)
    first, second = (here.show(cos((l + n) * theta) > 0) for n in (1, 2))
    found = combined(
        FALLS >= 0,
        [size, large, rest, first],
        [size, large, assume(epsilon >= 0), second],
        [square(B * (epsilon - HALF))],
        [pair, square(B * cos(theta / 2))],
        [HALF, less, size],
        [Rational(1, 4), less, large],
        [Rational(1, 4), size, size],
        [Rational(1, 8), size, large],
    )
    return here.closed(found)
