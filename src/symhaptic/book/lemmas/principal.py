"""With a delay of half a period: walls of which the principal sheet says something else than the
true loop."""

from symhaptic.book.lemmas.late_loop import ALL_NUMBERS
from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.theorems.axioms import LATE_NUMBERS
from symhaptic.proof.theorems.leaves import none_right, one_right

LOOP = (alpha, beta, gamma, delta)
TRUE = Predicate("stable_loop", (), (*LOOP, HALF))
READ = Predicate("stable_principal", (), (*LOOP, HALF))
SPRING = {gamma: 4 * pi**2 / 9, delta: S.Zero}
"""A spring that swings at two thirds of the Nyquist frequency."""
LARGE = {alpha: -3 * SPRING[gamma] / 4, beta: -SPRING[gamma] / 2}
"""A wall that is stable on the principal sheet, and unstable."""
SMALL = {alpha: 3 * SPRING[gamma] / 8, beta: -5 * SPRING[gamma] / 8}
"""One that is stable in truth, and not there."""


FREE = {gamma: S.Zero, delta: S.Zero}
BETWEEN = {alpha: Rational(1, 15), beta: Rational(16, 15)}
"""A wall that is stable for a free mass on the principal sheet, and unstable."""


def some_wall(device: Terms, *claims: Proposition) -> Proposition:
    """Of a device there is a wall with these properties."""
    return Exists((alpha, beta), And(claims).at(device))


def read_wrongly() -> Proposition:
    """For a stiff spring some wall is stable on the principal sheet alone, and some in truth."""
    walls = some_wall(SPRING, READ, Not((TRUE,))), some_wall(SPRING, TRUE, Not((READ,)))
    return both(walls)


@cache
def both_errors() -> Theorem:
    """That."""
    larger, smaller = read_wrongly().parts
    one = conj(_on_the_sheet(SPRING, LARGE, True), in_truth(SPRING, LARGE, False))
    other = conj(in_truth(SPRING, SMALL, True), _on_the_sheet(SPRING, SMALL, False))
    return conj(exists(one, larger, LARGE), exists(other, smaller, SMALL))


def read_too_largely() -> Proposition:
    """For a free mass some wall is stable on the principal sheet alone."""
    return some_wall(FREE, READ, Not((TRUE,)))


@cache
def one_error() -> Theorem:
    """That."""
    found = conj(_on_the_sheet(FREE, BETWEEN, True), in_truth(FREE, BETWEEN, False))
    return exists(found, read_too_largely(), BETWEEN)


def in_truth(device: Terms, wall: Terms, stable: bool) -> Theorem:
    """Whether a wall is stable, by balls around the zeros of its polynomial."""
    loop = closed(true_loop(device, wall, S.Zero), fact(whole(S.Zero)))
    zeros = loop.conclusion.parts[1].of[0]  # type: ignore[attr-defined]
    if stable:
        return mp(loop, roots_inside(zeros, z, {}))
    return denied_by(loop, root_outside(zeros, z))


def true_loop(device: Terms, wall: Terms, periods: Expr) -> Theorem:
    """A wall is stable with a delay of half a period, and more, if the zeros of its polynomial
    lie inside."""
    values = [{**device, **wall}[s] for s in LOOP]
    loop = axiom("loop of a late device", *values, periods, HALF, *LATE_NUMBERS, a, e)
    numbers = (_device(), _late()) if device is SPRING else (_free(), _late_free())
    loop = _in_numbers(loop, numbers[0] | numbers[1])
    facts = (number(Relation(v, "<=", w)) for v, w in ((S.Zero, HALF), (HALF, S.One)))
    there_is = axiom("late device", *device.values(), HALF)
    there_is = closed(there_is, *(fact(h) for h in there_is.hypotheses))
    return choose(there_is, closed(loop, *facts))


def _on_the_sheet(device: Terms, wall: Terms, stable: bool) -> Theorem:
    """Whether it is stable on the principal sheet, by balls around the zeros to the right."""
    sheet = closed(read_loop(device, wall, S.Zero), fact(whole(S.Zero)))
    never = sheet.conclusion.parts[1]
    root = Symbol("v")
    polynomial = never.body.parts[1].left.xreplace({x + I * y: root})  # type: ignore[attr-defined]
    if stable:
        return mp(sheet, none_right(polynomial, root, x, y))
    return denied_by(sheet, one_right(polynomial, root, x, y))


def read_loop(device: Terms, wall: Terms, periods: Expr) -> Theorem:
    """It is stable on the principal sheet if no zero to the right is as large as 1."""
    values = [{**device, **wall}[s] for s in LOOP]
    sheet = axiom("half a period on the principal sheet", *values, periods, *NUMBERS)
    sheet = _in_numbers(sheet, _device() if device is SPRING else _free())
    return choose(device_exists(device[gamma], device[delta], NUMBERS), sheet)


def _in_numbers(theorem: Theorem, numbers: Mapping[Symbol, Theorem]) -> Theorem:
    """A theorem with the values of some numbers for their names."""
    place = Symbol("q")
    for name, equation in numbers.items():
        if name in theorem.conclusion.free:
            pattern = theorem.conclusion.at({name: place})
            theorem = subst(pattern, place, theorem, equation)
    return theorem


def _swing(rate: Expr) -> tuple[Theorem, Theorem, Theorem]:
    """a = 2 cos x, n_1 = n_0 and e = 1, without a damper."""
    device = axiom("undamped device", rate, *NUMBERS)
    trace, same = (conjunct(device, claim) for claim in device.conclusion.parts)
    return trace, same, axiom("device's loss", rate**2, S.Zero, *NUMBERS)


@cache
def _device() -> dict[Symbol, Theorem]:
    """The numbers of the device with the spring: a = -1, e = 1 and n_1 = n_0 = 3/(2 gamma)."""
    stiff = SPRING[gamma]
    trace, same, loss = _swing(2 * pi / 3)
    static = axiom("device at rest", stiff, S.Zero, *NUMBERS)
    share = 1 / (2 * stiff)
    first = combined(
        Eq(n_1, 3 * share), [static, -share], [same, HALF], [loss, share], [trace, -share]
    )
    return {a: trace, e: loss, n_1: first, n_0: combined(Eq(n_0, 3 * share), [first], [same, -1])}


@cache
def _free() -> dict[Symbol, Theorem]:
    """Those of the free mass: a = 2, e = 1 and n_1 = n_0 = 1/2."""
    trace, same, loss = _swing(S.Zero)
    first = axiom("free mass", *NUMBERS)
    return {a: trace, e: loss, n_1: first, n_0: combined(Eq(n_0, HALF), [first], [same, -1])}


@cache
def _late() -> dict[Symbol, Theorem]:
    """Those of the late spring: m_2 = m_0 = 1/(2 gamma) and m_1 = 2/gamma."""
    stiff = SPRING[gamma]
    moved = axiom("undamped late device", 2 * pi / 3, HALF, *LATE_NUMBERS, a, e)
    first, second = (conjunct(moved, claim) for claim in moved.conclusion.parts)
    two = combined(Eq(m_2, 1 / (2 * stiff)), [first, 1 / stiff])
    one = combined(Eq(m_1, 2 / stiff), [second, 1 / stiff], [_device()[a], -m_2])
    return _with_the_last(two, one, _device(), SPRING)


@cache
def _late_free() -> dict[Symbol, Theorem]:
    """Those of the late mass: m_2 = m_0 = 1/8 and m_1 = 3/4."""
    moved = axiom("free late mass", HALF, *LATE_NUMBERS, a, e)
    two, second = (conjunct(moved, claim) for claim in moved.conclusion.parts)
    one = combined(Eq(m_1, Rational(3, 4)), [second], [two, -3], [_free()[a], -m_2])
    return _with_the_last(two, one, _free(), FREE)


def _with_the_last(
    two: Theorem, one: Theorem, device: Mapping[Symbol, Theorem], of: Terms
) -> dict[Symbol, Theorem]:
    """m_0, from m_2 + m_1 + m_0 = n_1 + n_0."""
    sums = axiom("late device and device", *of.values(), HALF, *ALL_NUMBERS)
    total = conjunct(sums, sums.conclusion.parts[0])
    known = [device[n_1], device[n_0], one, two]
    value = [t.conclusion.right for t in known]  # type: ignore[attr-defined]
    rest = [[t, sign] for t, sign in zip(known, (1, 1, -1, -1), strict=True)]
    last = combined(Eq(m_0, value[0] + value[1] - value[2] - value[3]), [total], *rest)
    return {m_2: two, m_1: one, m_0: last}
