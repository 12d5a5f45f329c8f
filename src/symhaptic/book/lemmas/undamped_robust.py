"""Without damping no wall is stable with every spring, for every delay.

Behind d = p/(q+1) periods the loop is a polynomial in w, z = w^(q+1).  Beside a spring with which
the device swings by M psi per period, M = q + 1, take w = exp(j psi) with N psi = pi/2 and
N = p + q + 1: there only the wall's part of the polynomial is left.
"""

from __future__ import annotations

from symhaptic.book.lemmas.chords import not_zero
from symhaptic.book.lemmas.prelude import *
from symhaptic.paper.propositions.comparison import STABLE
from symhaptic.paper.propositions.stability import NUMBERS
from symhaptic.proof.theorems.analysis import grows

p, q = symbols("p q")
N, M = p + q + 1, q + 1
SWING = M * psi
C_, S_ = cos(SWING), sin(SWING)
UNDAMPED = Predicate("device", (), (SWING**2, S.Zero, *NUMBERS))
TURN = proposition(Eq(N * psi, pi / 2))


@cache
def sizes() -> dict[str, Theorem]:
    """0 < M, 0 < N and 0 < psi, of whole p and q."""
    some, none = (not_negative(assume(whole(s))) for s in (p, q))
    large = positive(N > 0, [some], [none], [S.One])
    angle = combined(
        psi > 0, [number(Relation(S.Zero, "<", pi / 2)), _share(large)], [assume(TURN), -1 / N]
    )
    return {
        "share": positive(M > 0, [none], [S.One]),
        "size": large,
        "angle": closed(angle, not_zero(large)),
        "delay": some,
    }


def _share(theorem: Theorem) -> Theorem:
    """0 < 1/x."""
    return closed(over(1 / N > 0, number(Relation(S.Zero, "<", S.One)), theorem), not_zero(theorem))


@cache
def ends() -> tuple[Theorem, Theorem]:
    """sin N psi = 1 and cos N psi = 0."""
    half = combined(Eq(pi / 2, N * psi), [assume(TURN), -S.One])
    place = Symbol("t")
    one, zero = identity(S.One, S.One), identity(S.Zero, S.Zero)
    return (
        subst(Relation(sin(place), "=", S.One), place, one, half),
        subst(Relation(cos(place), "=", S.Zero), place, zero, half),
    )


@cache
def chord() -> Theorem:
    """M <= N sin M psi: a sine lies above its chord."""
    known, t = sizes(), Symbol("t")
    rise = N * sin(M * t) - M * sin(N * t)
    low = positive(M * t > 0, [known["share"], t > 0])
    more = assume(p > 0)
    apart = positive(N * t - M * t > 0, [more, t > 0])
    top = combined(
        N * t <= pi,
        [known["size"], assume(t < psi)],
        [assume(TURN), 1],
        [number(Relation(S.Zero, "<", pi / 2))],
    )
    falls = closed(
        rising(cos, M * t, N * t),
        positive(M * t < N * t, [apart]),
        positive(M * t >= 0, [low]),
        top,
    )
    slope = positive(
        M * N * cos(M * t) - M * N * cos(N * t) > 0, [known["share"], known["size"], falls]
    )
    grown = closed(grows(rise, t, S.Zero, psi, slope), known["angle"])
    one, _ = ends()
    goal = proposition(N * sin(SWING) - M >= 0)
    inside = combined(goal, [grown], [one, -M])
    none = assume(Eq(p, 0))
    bare = Symbol("k")
    same = subst(Relation(sin((bare + M) * psi), "=", S.One), bare, one, none)
    there = combined(goal, [same, -N], [none, -S.One])
    late = strictly(assume(p >= 0), combined(Ne(S.Zero, p), [assume(Ne(p, 0))]))
    return closed(disj_cases(decided(p, S.Zero), there, closed(inside, late)), known["delay"])


LATE = loop_late(NUMBERS, (alpha, beta, SWING**2, S.Zero, d), (p, q)).conclusion.parts[1]
"""There are whole p and q with d (q + 1) = p, and all zeros of a polynomial lie inside."""
ZEROS = LATE.parts[0].parts[-1]


@cache
def swinging() -> list[Theorem]:
    """n_1 = n_0, a = 2 cos M psi and e = 1, of the undamped device."""
    device = axiom("undamped device", SWING, *NUMBERS)
    turn, alike = (conjunct(device, claim) for claim in device.conclusion.parts)
    loss = of_device("device's loss", assume(UNDAMPED))
    return [alike, turn, combined(Eq(e, 1), [loss])]


@cache
def signs() -> dict[str, Theorem]:
    """0 < sin M psi, 0 < 1 - cos M psi, 0 < 1 + cos M psi and 0 < n_0."""
    known, half = sizes(), Rational(1, 2)
    wave = over(S_ > 0, combined(N * S_ > 0, [chord()], [known["share"]]), known["size"])
    less, more = (
        combined(1 + way * C_ > 0, [half, square(1 + way * C_)], [half, wave, wave])
        for way in (-1, 1)
    )
    static = of_device("device at rest", assume(UNDAMPED))
    alike, turn, loss = swinging()
    length = positive(
        SWING**2 > 0, [known["share"], known["angle"], known["share"], known["angle"]]
    )
    heavy = combined(
        SWING**2 * n_0 > 0,
        [less],
        [static, half],
        [alike, half * SWING**2],
        [turn, half],
        [loss, -half],
    )
    found = {"wave": wave, "less": less, "more": more, "heavy": over(n_0 > 0, heavy, length)}
    apart = [not_zero(t) for t in (known["size"], length, known["share"], known["angle"])]
    return {name: closed(t, *apart) for name, t in found.items()}


@cache
def outpaced() -> Theorem:
    """Beside this spring no wall with 0 <= alpha has all zeros inside."""
    late = outpaces(assume(ZEROS), psi)
    place = Symbol("t")
    for equation in swinging():
        name = equation.conclusion.terms[0]
        pattern = late.conclusion.at({name: place})
        late = subst(pattern, place, late, equation)
    one, none = ends()
    known, of = sizes(), signs()
    total, height = alpha + beta, alpha + 2 * beta
    gap = combined(
        N**2 * S_**2 - M**2 >= 0,
        [chord(), positive(N * S_ + M > 0, [known["size"], of["wave"]], [known["share"]])],
    )
    both = positive(N + M > 0, [known["size"]], [known["share"]])
    share = closed(
        over(1 / (N + M) > 0, number(Relation(S.Zero, "<", S.One)), both), not_zero(both)
    )
    weight = [2, of["heavy"], of["heavy"], of["more"], share]
    wall = 4 * M * S_ * n_0
    less = combined(
        Relation(late.conclusion.terms[1], "<=", S.Zero),
        [4, known["share"], of["wave"], of["heavy"], of["more"], assume(alpha >= 0)],
        [one, -wall * alpha * (1 + C_)],
        [none, wall * height * S_],
        [*weight, square((N + M) * beta - N * C_ * total)],
        [*weight, gap, square(total)],
    )
    return closed(not_intro(late, less), not_zero(both))


SOFT = Predicate("device", (), (x**2, S.Zero, *NUMBERS))


@cache
def pulled() -> Theorem:
    """Nor has a wall with alpha <= -x^2 beside the spring x^2, 0 < x < pi."""
    device = axiom("undamped device", x, *NUMBERS)
    turn = conjunct(device, device.conclusion.parts[0])
    known = assume(SOFT)
    static = of_device("device at rest", known)
    loss = combined(Eq(e, 1), [of_device("device's loss", known)])
    wave, half = sign_of(sin, x), Rational(1, 2)
    less = combined(1 - cos(x) > 0, [half, square(1 - cos(x))], [half, wave, wave])
    length = positive(x**2 > 0, [x > 0, x > 0])
    heavy = over(
        n_1 + n_0 > 0,
        combined(x**2 * (n_1 + n_0) > 0, [2, less], [static, S.One], [turn, S.One], [loss, -S.One]),
        length,
    )
    heavy = closed(heavy, not_zero(length))
    zeros = ZEROS.terms[0]
    weak = assume(Relation(x**2 + alpha, "<=", S.Zero))
    value = combined(Relation(zeros.subs(z, 1), "<=", S.Zero), [heavy, weak], [static, S.One])
    denial = zero_beyond(zeros, z, value)
    return not_intro(assume(ZEROS), denial)


def without(spring: Any, false: Theorem) -> Theorem:
    """No wall is stable beside an undamped device, from what its zeros contradict."""
    values = (alpha, beta, spring, S.Zero, d)
    late = loop_late(NUMBERS, values, (p, q))
    stable = STABLE.at({gamma: spring, delta: S.Zero})
    numbers = [assume(whole(s)) for s in (p, q)]
    sums = [
        is_whole(h.terms[0], *numbers)
        for h in false.hypotheses
        if isinstance(h, Predicate) and h.name == "whole" and h.terms[0] not in (p, q)
    ]
    found = choose(mp(late, assume(stable)), closed(false, *sums))
    return choose(device_exists(spring, S.Zero, NUMBERS), found)


def _spring(turn: Any, low: Theorem, high: Theorem) -> list[Theorem]:
    """0 < x^2 < pi^2 from 0 < x < pi."""
    gap = positive(pi - turn > 0, [high])
    more = positive(pi + turn > 0, [low], [number(Relation(S.Zero, "<", pi))])
    return [positive(turn**2 > 0, [low, low]), positive(turn**2 < pi**2, [gap, more])]


@cache
def excluded() -> Theorem:
    """No wall with 0 <= alpha is stable beside the spring with (d + 1) Omega = pi/2, 0 <= d."""
    more = _more()
    turn, angle = pi / (2 * d + 2), pi / ((2 * d + 2) * (q + 1))
    delay, share = assume(Eq(d * (q + 1), p)), sizes()["share"]
    product = positive((2 * d + 2) * (q + 1) > 0, [more, share])
    apart = [not_zero(t) for t in (share, more, product)]
    whole_turn = closed(combined(TURN.at({psi: angle}), [delay, -angle]), *apart)
    found = without(turn**2, closed(inst(outpaced(), {psi: angle}), whole_turn, *apart))
    return closed(found, not_zero(more))


def _more() -> Theorem:
    """0 < 2d + 2."""
    return positive(2 * d + 2 > 0, [2, d >= 0], [2])


def pushes(held: Proposition) -> Theorem:
    """``held`` is false of a wall with 0 <= alpha."""
    more, turn = _more(), pi / (2 * d + 2)
    low = over(turn > 0, number(Relation(S.Zero, "<", pi)), more)
    half = positive(
        pi * (2 * d + 1) > 0,
        [2, number(Relation(S.Zero, "<", pi)), d >= 0],
        [number(Relation(S.Zero, "<", pi))],
    )
    high = over(pi - turn > 0, half, more)
    high = positive(turn < pi, [high])
    stable = at(assume(held), {gamma: turn**2}, *_spring(turn, low, high))
    return closed(excluded(), closed(stable, not_zero(more)), not_zero(more))


def pulls(held: Proposition) -> Theorem:
    """It is false of one with alpha < 0."""
    turn = -alpha / (1 - alpha)
    back = positive(-alpha > 0, alpha < 0)
    more = positive(1 - alpha > 0, [back], [S.One])
    low = over(turn > 0, back, more)
    one = over(1 - turn > 0, number(Relation(S.Zero, "<", S.One)), more)
    high = positive(turn < pi, [one], [number(Relation(S.One, "<", pi))])
    size = positive(-alpha * (1 - alpha + alpha**2) >= 0, [back, more], [back, square(alpha)])
    weak = over(-(turn**2) - alpha >= 0, size, positive((1 - alpha) ** 2 > 0, [more, more]))
    less = combined(Relation(turn**2 + alpha, "<=", S.Zero), [weak])
    apart = not_zero(more), not_zero(positive((1 - alpha) ** 2 > 0, [more, more]))
    found = without(turn**2, closed(inst(pulled(), {x: turn}), low, high, less, *apart))
    stable = at(assume(held), {gamma: turn**2}, *_spring(turn, low, high))
    return closed(found, closed(stable, *apart), *apart)


def vanishes(held: Proposition) -> Theorem:
    """``held`` is not so, for 0 <= d."""
    return reductio(disj_cases(ordered(alpha, S.Zero), pulls(held), pushes(held)), held)
