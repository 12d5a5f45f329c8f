"""Without stiffness: which damping is passive that is late by a fraction of a period?

With c = (1 - epsilon) cos (l+1) theta + epsilon cos (l+2) theta and v = epsilon (1 - epsilon)
sin^2(theta/2) the margin is b^2 + b B c - B^2 v, and by Lagrange's identity 1 + c - 2 v and
1 - c - 2 v are sums of two squares.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import HALF, PI, not_zero
from symhaptic.book.lemmas.extent import weak_sine
from symhaptic.book.lemmas.late_passivity import EVERY_MARGIN, GIVEN, MARGIN, passive_late
from symhaptic.book.lemmas.passivity import INSIDE
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import b
from symhaptic.proof.theorems.familiar import bounded

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
def _places() -> tuple[Theorem, ...]:
    """0 < l + 2, and what is not negative: 1 - epsilon and epsilon (1 - epsilon)."""
    later = positive(l + 2 > 0, [not_negative(assume(GIVEN[2]))], [2])
    rest = positive(1 - epsilon >= 0, epsilon <= 1)
    return later, rest, positive(PAIR >= 0, [rest, epsilon >= 0])


@cache
def divisors() -> tuple[Theorem, ...]:
    """l + 2 and its multiples are not zero, l being whole."""
    later, *_ = _places()
    found = [later, *(positive(n * (l + 2) > 0, [n, later]) for n in (2, 4))]
    return *map(not_zero, found), not_negative(assume(GIVEN[2]))


@cache
def margin() -> Theorem:
    """0 <= the margin at an angle, of a passive damper."""
    found = passive_late()
    always = conjunct(mp(found, assume(found.conclusion.parts[0])), EVERY_MARGIN)
    found = at(always, {theta: theta}, *map(assume, INSIDE))
    return closed(inst(found, {K: S.Zero}), not_zero(sine_of_half(theta)))


@cache
def begins() -> Theorem:
    """-b <= B, from the limit b (b + B) of the margin."""
    limit = tends(FALLS, theta, S.Zero, b * (b + B))
    start = closed(in_the_limit(margin(), theta, S.Zero, pi, limit), PI)
    share = over(b * (b + B) / b >= 0, positive(b * (b + B) >= 0, [start]), b > 0)
    return closed(positive(-b <= B, [share]), not_zero(assume(b > 0)))


@cache
def ends() -> Theorem:
    """epsilon B <= b, by the margin at theta = pi/(l+2)."""
    later, rest, pair = _places()
    angle = pi / (l + 2)
    above = over(angle > 0, PI, later)
    half = over(pi / 2 - angle >= 0, positive(pi * l / 2 >= 0, [HALF, PI, l >= 0]), later)
    below = positive(angle < pi, [half], [HALF, PI])
    known = closed(inst(margin(), {theta: angle}), above, below)
    near = weak_sine(pi / 2 - angle)
    near = closed(near, half, positive(pi / 2 - angle <= pi, [above], [HALF, PI]))
    room = combined(
        Relation(S.Zero, "<=", b * (b - epsilon * B)),
        [known],
        [assume(B >= 0), assume(b > 0), rest, near],
        [pair, square(B * sin(angle / 2))],
    )
    share = over(b * (b - epsilon * B) / b >= 0, room, b > 0)
    wanted = epsilon * B <= b
    damps = positive(wanted, [share])
    pushes = positive(wanted, [epsilon >= 0, B < 0], b > 0)
    found = disj_cases(ordered(B, S.Zero), pushes, damps)
    return closed(found, *divisors(), not_zero(assume(b > 0)))


@cache
def _lowest_sine() -> Theorem:
    """0 < sin(pi/(4 (l+2)))."""
    later, *_ = _places()
    angle = EARLY / 2
    above = over(angle > 0, PI, positive(4 * (l + 2) > 0, [4, later]))
    rest = positive(pi * (l + Rational(7, 4)) > 0, [PI, l >= 0], [Rational(7, 4), PI])
    below = positive(angle < pi, [over(pi * (l + Rational(7, 4)) / (l + 2) > 0, rest, later)])
    return closed(sign_of(sin, angle), above, below, *divisors())


@cache
def above_the_damper() -> Theorem:
    """b < END for 0 < epsilon < 1."""
    given = assume(epsilon > 0), assume(epsilon < 1)
    sine = _lowest_sine()
    more = positive(b < END, [HALF, assume(b > 0), *given, sine, sine])
    return disch(closed(more, *divisors()), epsilon > 0, epsilon < 1)


@cache
def _squares() -> tuple[Theorem, Theorem]:
    """0 <= 1 + c - 2 v and 0 <= 1 - c - 2 v."""
    rest = 1 - epsilon
    turn = rest * cos((l + 1) * theta) + epsilon * cos((l + 2) * theta)
    mixed = rest * sin(ONE) * cos(ONE) + epsilon * sin(TWO) * cos(TWO)
    along, across = (rest * f(ONE) ** 2 + epsilon * f(TWO) ** 2 for f in (cos, sin))
    return tuple(  # type: ignore[return-value]
        combined(1 + sign * turn - 2 * LOSS >= 0, [2, square(part_)], [2, square(mixed)])
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
    apart = not_zero(sine_of_half(theta))
    always = for_all([theta], INSIDE, closed(margin_, apart))
    found = mp(passive_late(), conj(combined(K >= 0, [soft, -S.One]), always))
    return closed(inst(found, {K: S.Zero}), fact(Relation(S.Zero, "=", S.Zero)), *divisors())


def _weak() -> Theorem:
    """0 <= the margin for -b <= B <= b: it is concave."""
    plus, minus = _squares()
    _, _, pair = _places()
    low, high = positive(b + B >= 0, -b <= B), positive(b - B >= 0, b >= B)
    loss = positive(LOSS >= 0, [pair, square(sin(theta / 2))])
    return combined(
        FALLS >= 0,
        [HALF, assume(b > 0), low, plus],
        [HALF, assume(b > 0), high, minus],
        [loss, low, high],
        [loss, assume(b > 0), assume(b > 0)],
    )


@cache
def _excess() -> tuple[Theorem, Theorem]:
    """B - b is b epsilon (1 - epsilon) LOW^2/2 at most, and less than b/2."""
    _, _, pair = _places()
    room = positive(END - B >= 0, B <= END)
    half, low = square(epsilon - HALF), positive(1 - LOW**2 >= 0, [bounded(sin, EARLY / 2)])
    size = assume(b > 0)
    less = positive(
        3 * b / 2 - B > 0,
        [room],
        [HALF, size, half],
        [Rational(3, 8), size],
        [HALF, size, pair, low],
    )
    return room, less


def _late() -> Theorem:
    """0 <= the margin for b < B and pi/(2 (l+2)) <= theta: v is large."""
    plus, _ = _squares()
    later, _, pair = _places()
    room, less = _excess()
    size, more, high = assume(b > 0), positive(B - b > 0, b < B), assume(theta < pi)
    apart, middle = (theta - EARLY) / 4, (theta + EARLY) / 4
    start = over(EARLY > 0, PI, positive(2 * (l + 2) > 0, [2, later]))
    end = over(pi * (l + Rational(3, 2)) / (l + 2) > 0, _further(), later)
    ends_ = (
        positive(apart >= 0, [Rational(1, 4), assume(theta >= EARLY)]),
        positive(
            apart <= pi, [Rational(1, 4), high], [Rational(1, 4), start], [Rational(3, 4), PI]
        ),
        positive(pi / 2 - middle >= 0, [Rational(1, 4), high], [Rational(1, 4), end]),
        positive(
            pi / 2 - middle <= pi,
            [HALF, PI],
            [Rational(1, 4), start],
            [Rational(1, 4), assume(theta > 0)],
        ),
    )
    sines = [closed(weak_sine(x), *ends_) for x in (apart, pi / 2 - middle)]
    half, low = sine_of_half(theta), _lowest_sine()
    rises = positive(sin(theta / 2) - LOW >= 0, [2, *sines])
    loss = positive(LOSS >= 0, [pair, square(sin(theta / 2))])
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
    return closed(found, *divisors())


def _further() -> Theorem:
    """0 < pi (l + 3/2)."""
    share = Rational(3, 2)
    return positive(pi * (l + share) > 0, [PI, l >= 0], [share, PI])


def _early() -> Theorem:
    """0 <= the margin for b < B and theta < pi/(2 (l+2)): both cosines are positive."""
    later, rest, pair = _places()
    _, less = _excess()
    size, low, high = assume(b > 0), assume(theta > 0), assume(theta < EARLY)
    large = positive(B > 0, b < B, b > 0)
    above = positive((l + 2) * theta > 0, [later, low])
    below = positive((l + 2) * theta < pi / 2, [later, high])
    one, two = (l + 1) * theta, (l + 2) * theta
    inside = (
        below,
        positive(one < pi / 2, [below], [low]),
        positive(one > -pi / 2, [l >= 0, low], [low], [HALF, PI]),
        positive(two > -pi / 2, [above], [HALF, PI]),
    )
    first, second = (closed(sign_of(cos, x), *inside) for x in (one, two))
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
    return closed(found, *divisors())
