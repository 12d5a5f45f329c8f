"""Without damping no wall is stable with every spring, for every delay.

Behind d = p/(q+1) periods the loop is a polynomial in w, z = w^(q+1).  Beside a spring with which
the device swings by M psi per period, M = q + 1, take w = exp(j psi) with N psi = pi/2 and
N = p + q + 1: there only the wall's part of the polynomial is left.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.analysis import grows

p, q = symbols("p q")
N, M = p + q + 1, q + 1
SWING = M * psi
C_, S_ = cos(SWING), sin(SWING)
UNDAMPED = Predicate("device", (), (SWING**2, S.Zero, *NUMBERS))
TURN = proposition(Eq(N * psi, pi / 2))


@cache
def here() -> Given:
    """0 < M, 0 < N and 0 < psi, of whole p and q."""
    found = Given(whole(p), whole(q), TURN)
    for claim in M > 0, N > 0, 1 / N > 0, N + M > 0:
        found.have(claim)
    half = number(Relation(S.Zero, "<", pi / 2))
    angle = combined(psi > 0, [half, found.show(1 / N > 0)], [assume(TURN), -1 / N])
    return found.and_(found.closed(angle))


@cache
def ends() -> tuple[Theorem, Theorem]:
    """sin N psi = 1 and cos N psi = 0."""
    half = show(Eq(pi / 2, N * psi), TURN)
    place = Symbol("t")
    one, zero = identity(S.One, S.One), identity(S.Zero, S.Zero)
    return (
        subst(Relation(sin(place), "=", S.One), place, one, half),
        subst(Relation(cos(place), "=", S.Zero), place, zero, half),
    )


@cache
def chord() -> Theorem:
    """M <= N sin M psi: a sine lies above its chord."""
    t = Symbol("t")
    rise = N * sin(M * t) - M * sin(N * t)
    below = here().and_(p > 0, t > 0, t < psi)
    slope = below.show(derivative(rise, t) > 0, rising(cos, M * t, N * t), degree=3)
    grown = here().closed(grows(rise, t, S.Zero, psi, slope))
    one, _ = ends()
    goal = proposition(N * sin(SWING) - M >= 0)
    inside = combined(goal, [grown], [one, -M])
    none = assume(Eq(p, 0))
    bare = Symbol("k")
    same = subst(Relation(sin((bare + M) * psi), "=", S.One), bare, one, none)
    there = combined(goal, [same, -N], [none, -S.One])
    late = strictly(assume(p >= 0), show(Ne(S.Zero, p), Ne(p, 0)))
    return here().closed(disj_cases(decided(p, S.Zero), there, closed(inside, late)))


LATE = loop_late(NUMBERS, (alpha, beta, SWING**2, S.Zero, d), (p, q)).conclusion.parts[1]
"""There are whole p and q with d (q + 1) = p, and all zeros of a polynomial lie inside."""
ZEROS = LATE.parts[0].parts[-1]


@cache
def swinging() -> list[Theorem]:
    """n_1 = n_0, a = 2 cos M psi and e = 1, of the undamped device."""
    device = axiom("undamped device", SWING, *NUMBERS)
    turn, alike = (conjunct(device, claim) for claim in device.conclusion.parts)
    loss = of_device("device's loss", assume(UNDAMPED))
    return [alike, turn, show(Eq(e, 1), loss)]


@cache
def signs() -> Given:
    """0 < sin M psi, 0 < 1 - cos M psi, 0 < 1 + cos M psi and 0 < n_0."""
    found, half = here().and_(), Rational(1, 2)
    wave = found.have(S_ > 0)
    found.have(1 + C_ > 0, square(1 + C_))
    less = found.have(1 - C_ > 0, square(1 - C_))
    static = of_device("device at rest", assume(UNDAMPED))
    alike, turn, loss = swinging()
    heavy = combined(
        SWING**2 * n_0 > 0,
        [less],
        [static, half],
        [alike, half * SWING**2],
        [turn, half],
        [loss, -half],
    )
    return found.and_(found.closed(over(n_0 > 0, heavy, SWING**2 > 0)), wave)


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
    known, total, height = signs(), alpha + beta, alpha + 2 * beta
    wave, heavy, more = (known.show(e > 0) for e in (S_, n_0, 1 + C_))
    gap = combined(N**2 * S_**2 - M**2 >= 0, [chord(), known.show(N * S_ + M > 0)])
    weight = [2, heavy, heavy, more, known.show(1 / (N + M) > 0)]
    wall = 4 * M * S_ * n_0
    less = combined(
        Relation(late.conclusion.terms[1], "<=", S.Zero),
        [4, known.show(M > 0), wave, heavy, more, assume(alpha >= 0)],
        [one, -wall * alpha * (1 + C_)],
        [none, wall * height * S_],
        [*weight, square((N + M) * beta - N * C_ * total)],
        [*weight, gap, square(total)],
    )
    return known.closed(not_intro(late, less))


SOFT = Predicate("device", (), (x**2, S.Zero, *NUMBERS))


@cache
def pulled() -> Theorem:
    """Nor has a wall with alpha <= -x^2 beside the spring x^2, 0 < x < pi."""
    device = axiom("undamped device", x, *NUMBERS)
    turn = conjunct(device, device.conclusion.parts[0])
    known = assume(SOFT)
    static = of_device("device at rest", known)
    loss = of_device("device's loss", known)
    here = Given(x > 0, x < pi, known)
    less = here.show(1 - cos(x) > 0, square(1 - cos(x)), here.show(sin(x) > 0))
    heavy = combined(
        x**2 * (n_1 + n_0) > 0, [2, less], [static, S.One], [turn, S.One], [loss, -S.One]
    )
    heavy = here.closed(over(n_1 + n_0 > 0, heavy, x**2 > 0))
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
    false = Given(whole(p), whole(q)).closed(false)
    found = choose(mp(late, assume(stable)), false)
    return choose(device_exists(spring, S.Zero, NUMBERS), found)


@cache
def excluded() -> Theorem:
    """No wall with 0 <= alpha is stable beside the spring with (d + 1) Omega = pi/2, 0 <= d."""
    late = Given(d >= 0, whole(q))
    turn, angle = pi / (2 * d + 2), pi / ((2 * d + 2) * (q + 1))
    delay = assume(Eq(d * (q + 1), p))
    whole_turn = late.closed(combined(TURN.at({psi: angle}), [delay, -angle]))
    found = late.closed(closed(inst(outpaced(), {psi: angle}), whole_turn))
    return Given(d >= 0).closed(without(turn**2, found))


def _stable(held: Proposition, turn: Expr, given: Given) -> Theorem:
    """What is said of all springs 0 < x^2 < pi^2, of one."""
    given.have(turn > 0)
    given.have(turn < pi)
    inside = given.show(turn**2 > 0), given.show(pi**2 - turn**2 > 0)
    return given.closed(
        at(assume(held), {gamma: turn**2}, inside[0], show(turn**2 < pi**2, inside[1]))
    )


def pushes(held: Proposition) -> Theorem:
    """``held`` is false of a wall with 0 <= alpha."""
    here = Given(d >= 0)
    return here.closed(closed(excluded(), _stable(held, pi / (2 * d + 2), here)))


def pulls(held: Proposition) -> Theorem:
    """It is false of one with alpha < 0."""
    turn, here = -alpha / (1 - alpha), Given(alpha < 0)
    here.have(turn < 1)
    here.have(turn < pi, number(Relation(S.One, "<", pi)))
    stable = _stable(held, turn, here)
    here.have(-alpha * (1 - alpha + alpha**2) >= 0)
    here.have(turn**2 + alpha <= 0)
    return here.closed(closed(without(turn**2, here.closed(inst(pulled(), {x: turn}))), stable))


def vanishes(held: Proposition) -> Theorem:
    """``held`` is not so, for 0 <= d."""
    return reductio(disj_cases(ordered(alpha, S.Zero), pulls(held), pushes(held)), held)
