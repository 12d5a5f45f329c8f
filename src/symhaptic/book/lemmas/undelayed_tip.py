"""The largest stable stiffness without delay in closed form, beside springs up to gamma = 0.01.

With x = 1 + n_1 beta > 0 and w^2 = n_0 (n_0 + e n_1 - gamma n_0 n_1) Jury's minor is
n_0 x (alpha_max - alpha) - (n_1 + n_0) (n_0 x - w)^2/(n_0 n_1^2).
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities
from symhaptic.book.lemmas.stiffest_stable import damping_between, inequalities, on_box, towards

WIDE = {gamma: (S.Zero, Rational(1, 100)), delta: (S.Zero, Rational(1, 10))}
"""Ten times the springs of (23), and five times the dampers."""
FARTHEST = Rational(5, 2)
"""No stable wall has a larger virtual damping, of either sign, as 1 < 2.5 n_0."""

TOTAL = n_1 + n_0
SIZE = n_0 * (n_0 + e * n_1 - gamma * n_0 * n_1)
LARGEST = (TOTAL - w) ** 2 / (n_0 * n_1**2) - gamma
"""The largest stable stiffness, by w >= 0 with w^2 = SIZE."""
BEST = (w / n_0 - 1) / n_1
"""The damping of the wall next to it."""


def claim() -> Proposition:
    """Every stable wall has alpha < LARGEST; with BEST all walls up to there are stable."""
    arm = [bound for s, (low, high) in WIDE.items() for bound in (s >= low, s <= high)]
    here = STABLE.at({d: S.Zero})
    most = ForAll((alpha, beta), implied([here], alpha < LARGEST))
    reached = ForAll((alpha,), implied([-gamma < alpha, alpha < LARGEST], here.at({beta: BEST})))
    given = [DEVICE, w >= 0, Eq(w**2, SIZE)]
    plants = ForAll((*NUMBERS, w), implied(given, both([most, reached])))
    return ForAll((gamma, delta), implied(arm, plants))


@cache
def signs() -> dict[str, Theorem]:
    """0 < n_0, n_1 and n_1 + n_0."""
    known = {name: on_box(f, WIDE) for name, f in (("n_0", n_0), ("n_1", n_1), ("total", TOTAL))}
    return {**known, "weight": show(n_0 * n_1**2 > 0, *known.values())}


def _apart() -> tuple[Theorem, ...]:
    return tuple(map(not_zero, signs().values()))


@cache
def none_stiffer() -> Theorem:
    """alpha < LARGEST for every stable wall."""
    *planes, minor = inequalities(0)
    low, high, inside = damping_between(0, WIDE, FARTHEST)
    toward = towards(planes, minor, inside, {**WIDE, beta: (-FARTHEST, FARTHEST)})
    known, x = signs(), 1 + n_1 * beta
    bend = over(TOTAL / (n_0 * n_1**2) > 0, known["total"], known["weight"])
    static, root = device_static(assume(DEVICE)), assume(Eq(w**2, SIZE))
    share = (n_0 * beta - 1) / (n_0 * n_1)
    found = by_multiple(
        alpha < LARGEST,
        positive(n_0 * x > 0, [known["n_0"], toward]),
        [minor],
        [bend, square(n_0 * x - w)],
        [static, -beta * n_0],
        [root, -share],
    )
    return closed(found, *_apart(), low, high)


LOW, HIGH = Rational(6, 10), Rational(3, 4)
"""Between these is w."""
WIDER = {**WIDE, w: (LOW, HIGH)}


@cache
def size_between() -> tuple[Theorem, Theorem]:
    """LOW <= w <= HIGH, from w^2 = SIZE and 0 <= w."""
    root = Eq(w**2, SIZE)
    more, most = (positive(end + w > 0, [end], [w >= 0]) for end in (LOW, HIGH))
    low = by_multiple(w > LOW, more, [on_box(SIZE - LOW**2, WIDE)], [root, -1])
    high = by_multiple(w < HIGH, most, [on_box(HIGH**2 - SIZE, WIDE)], [root, 1])
    return positive(w >= LOW, [low]), positive(w <= HIGH, [high])


@cache
def all_softer() -> Theorem:
    """The walls with BEST are stable for -gamma < alpha < LARGEST."""
    known, ends = signs(), size_between()
    static, root = device_static(assume(DEVICE)), assume(Eq(w**2, SIZE))
    room = on_box((2 + gamma) * n_0 * n_1**2 - (TOTAL - w) ** 2, WIDER)
    two = over(2 - LARGEST > 0, room, known["weight"])
    here = Given(-gamma < alpha, alpha < LARGEST, gamma <= WIDE[gamma][1])
    inside = (*ends, here.show(alpha >= -WIDE[gamma][1]), here.show(alpha <= 2, two))
    loop = inst(by_inequalities(0), {beta: BEST})
    goals = conjuncts(loop.conclusion.of[1])  # type: ignore[attr-defined]
    product = positive(n_0 * n_1 > 0, [known["n_0"], known["n_1"]])
    wide = {**WIDER, alpha: (-WIDE[gamma][1], S(2))}
    share = (n_0 * BEST - 1) / (n_0 * n_1)
    shown = [positive(goals[0], [known["total"], -gamma < alpha], [static, -S.One])]
    for goal in goals[1:3]:
        value = expand(goal.right * n_0 * n_1)  # type: ignore[attr-defined]
        shown.append(over(goal, on_box(value, wide), product))
    heavy = positive(w > 0, [ends[0]], [LOW])
    rest = [static, n_0 * BEST], [root, share]
    shown.append(positive(goals[3], [heavy, alpha < LARGEST], *rest))
    return closed(mp(loop, conj(*shown)), *inside, *_apart(), not_zero(product))


@cache
def closed_form() -> Theorem:
    """Both."""
    plants = taken_apart(claim())[2]
    then = taken_apart(plants)[2]
    most, reached = then.of  # type: ignore[attr-defined]
    parts = [
        for_all((alpha, beta), [most.body.of[0]], none_stiffer()),
        for_all((alpha,), conjuncts(reached.body.of[0]), all_softer()),
    ]
    return as_claimed(claim(), as_claimed(plants, conj(*parts)))
