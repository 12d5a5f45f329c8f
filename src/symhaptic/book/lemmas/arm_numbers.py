"""The signs of an arm's numbers, for all arms that swing by less than half a turn in a period."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import linear
from symhaptic.proof.theorems.analysis import grows
from symhaptic.proof.theorems.samples import after_a_blow

SLOW = Relation(gamma - delta**2 / 4, "<", pi**2)
ARM = (DEVICE, gamma >= 0, delta >= 0, SLOW)
TOTAL = n_1 + n_0
BY_NUMBERS = linear.numbers(Sampled(n_1, n_0, a, e))
"""nu, s_1 and s_2 by the numbers of the sampled device."""
GAP = (s_1 - delta - gamma / 2).xreplace(BY_NUMBERS)
_PLACE = Symbol("q")


@cache
def pushed() -> tuple[Theorem, Theorem, Theorem]:
    """0 < n_1, 0 < n_0 and n_0 <= n_1."""
    device = assume(DEVICE)
    first = after_a_blow(device, 1, 0, u, 0, one())
    second = after_a_blow(device, 0, 1, u, 0, sign_of(exp, -delta * u))
    less = after_a_blow(device, 1, -1, u, 0, _falls())
    return first, second, positive(n_0 <= n_1, [less])


@cache
def together() -> Theorem:
    """0 < n_1 + n_0."""
    first, second, _ = pushed()
    return positive(TOTAL > 0, [first], [second])


def _falls() -> Theorem:
    """0 <= 1 - exp(-delta u) for 0 <= delta, 0 < u."""
    claim = Relation(S.Zero, "<=", 1 - exp(-delta * u))
    lower = positive(-delta * u < 0, [delta > 0, u > 0])
    rises = inst(_exponential(), {_PLACE: -delta * u})
    damped = combined(claim, [closed(rises, lower)])
    return damped_or_not(claim, damped, number(Relation(S.Zero, "<=", S.Zero)))


def _exponential() -> Theorem:
    """exp(q) < 1 for q < 0."""
    slope = sign_of(exp, u)
    return grows(exp(u), u, _PLACE, S.Zero, slope)


def damped_or_not(claim: Proposition, damped: Theorem, free: Theorem) -> Theorem:
    """A claim for 0 <= delta from those for 0 < delta and, with 0 for it, delta = 0."""
    weak = positive(delta >= 0, delta >= 0)
    zero = both_ways(weak, assume(Relation(delta, "<=", S.Zero)))
    undamped = subst(claim.at({delta: _PLACE}), _PLACE, free, zero)
    return disj_cases(ordered(S.Zero, delta), damped, undamped)


@cache
def turned() -> tuple[Theorem, Theorem]:
    """-2 exp(-delta/2) < a, and e = exp(-delta)."""
    device = assume(DEVICE)
    return of_device("device turns", device), of_device("device's loss", device)


@cache
def share() -> tuple[Theorem, Theorem]:
    """0 < nu <= 1/2."""
    _, second, less = pushed()
    return (
        over(BY_NUMBERS[nu] > 0, second, together()),
        over(BY_NUMBERS[nu] <= HALF, positive(n_1 / 2 >= n_0 / 2, [HALF, less]), together()),
    )


@cache
def mass() -> Theorem:
    """0 < s_2 = n_1^2 A(-n_0/n_1)/(n_1 + n_0)^3: real zeros of A are positive."""
    first, second, _ = pushed()
    low, image = turned()
    root = exp(-delta / 2)
    zero = device_static(assume(DEVICE))
    value = combined(
        TOTAL * (n_0 + e * n_1 - gamma * n_1 * n_0) > 0,
        [square(n_0 - root * n_1)],
        [first, second, low],
        [image, -(n_1**2)],
        [zero, -n_1 * n_0],
    )
    cube = positive(sp.expand(TOTAL**3) > 0, [together()] * 3)
    found = over(BY_NUMBERS[s_2] > 0, value, cube)
    return closed(found, positive(sp.Ne(TOTAL, 0), [together()]))


@cache
def gap(strict: bool = False) -> Theorem:
    """0 <= s_1 - delta - gamma/2, and 0 < for 0 < gamma, 0 < delta."""
    spring = assume(gamma > 0 if strict else gamma >= 0)
    damped = _damped(spring)
    if strict:
        return damped
    claim = Relation(S.Zero, "<=", GAP)
    given = (DEVICE, gamma >= 0, SLOW)
    implied = Implies((both(given), claim))
    free = disch(add_assum(_undamped(), *(undamped(p) for p in given)), *map(undamped, given))
    return undisch(damped_or_not(implied, disch(add_assum(damped, *given), *given), free))


def undamped(claim: object) -> Proposition:
    """The same for a device without damping."""
    return both([claim]).at({delta: S.Zero})


def _damped(spring: Theorem) -> Theorem:
    """With x = delta u the kernel is gamma^2/delta^2 (1 - u) ((1 + x/2) exp(-x) - 1 + x/2)."""
    x = delta * u
    bent = (1 + x / 2) * exp(-x) - 1 + x / 2
    size = closed(over(1 / delta > 0, one(), delta > 0))
    there = closed(inst(_bent(), {_PLACE: x}), positive(x > 0, [delta > 0, u > 0]))
    test = -u * (1 - exp(-x)) - gamma * (1 - u) * bent / delta**2
    first, second = -delta - gamma / 2, gamma / 2 - delta
    kernel = first + second * exp(-x)
    slope = derivative(test, u)
    kernel -= derivative(slope, u) + delta * slope + gamma * test
    sign = "<" if spring.conclusion == both([gamma > 0]) else "<="
    shown = combined(
        Relation(S.Zero, sign, kernel), [spring, spring, size, size, assume(u < 1), there]
    )
    apart = positive(sp.Ne(delta, 0), delta > 0)
    found = after_a_blow(assume(DEVICE), first, second, u, test, closed(shown, apart))
    return _over_the_numerator(closed(found, apart), sign)


def _over_the_numerator(below: Theorem, sign: str) -> Theorem:
    _, image = turned()
    top = 1 - e + gamma * n_0 - (delta + gamma / 2) * TOTAL
    raised = combined(Relation(S.Zero, sign, top), [below], [image, S.One])
    return over(Relation(S.Zero, sign, GAP), raised, together())


def _bent() -> Theorem:
    """0 < (1 + q/2) exp(-q) - 1 + q/2 for 0 < q."""
    v = Symbol("v")
    inner = 1 - (1 + u) * exp(-u)
    rise = grows(inner, u, S.Zero, v, combined(derivative(inner, u) > 0, [assume(u > 0), _fall(u)]))
    outer = (1 + v / 2) * exp(-v) - 1 + v / 2
    slope = combined(Relation(S.Zero, "<", derivative(outer, v)), [HALF, rise])
    return positive(outer.subs(v, _PLACE) > 0, [grows(outer, v, S.Zero, _PLACE, slope)])


def _fall(x: Expr) -> Theorem:
    return sign_of(exp, -x)


def _undamped() -> Theorem:
    """Without damping n_1 = n_0 and e = 1, and there is no gap."""
    device = assume(undamped(DEVICE))
    nothing = number(Relation(S.Zero, "<=", S.Zero))
    less = after_a_blow(device, -1, 1, u, 0, nothing)
    image = of_device("device's loss", device)
    top = 1 - e + gamma * n_0 - gamma / 2 * TOTAL
    spring = assume(gamma >= 0)
    raised = combined(Relation(S.Zero, "<=", top), [HALF, spring, less], [image, S.One])
    total = inst(together(), {delta: S.Zero})
    return over(undamped(Relation(S.Zero, "<=", GAP)), raised, total)


@cache
def signs() -> Theorem:
    """0 < nu <= 1/2, 0 < s_2, delta + gamma/2 <= s_1, and < for 0 < gamma delta."""
    line = positive(delta + gamma / 2 <= BY_NUMBERS[s_1], [gap()])
    above = positive(delta + gamma / 2 < BY_NUMBERS[s_1], [gap(strict=True)])
    product = assume(gamma * delta > 0)
    parts = [_positive(s, product) for s in (gamma, delta)]
    strict = disch(closed(above, *parts), gamma * delta > 0)
    return conj(*share(), mass(), line, strict)


def _positive(of: Symbol, product: Theorem) -> Theorem:
    """0 < x from 0 <= x and 0 < x y."""
    other = delta if of == gamma else gamma
    apart = factor(of, product, other)
    return strictly(positive(of >= 0, of >= 0), apart)
