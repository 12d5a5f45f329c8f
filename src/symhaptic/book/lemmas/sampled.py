"""What a held force does to the samples of a device, in the units of the paper."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.renaming import definitions, explicit, renamed, unnamed
from symhaptic.notation import X_d, d_1, d_2
from symhaptic.proof.theorems.axioms import answers, transfer
from symhaptic.proof.theorems.familiar import in_units, shifted
from symhaptic.proof.theorems.samples import held_answer, one_answer, turns

PARTS = (m, b, k)
RATE, SPRING = b * T / m, k * T**2 / m
"""delta and gamma of a device."""
SPLIT = sqrt(RATE**2 - 4 * SPRING)
"""The difference of its poles, times T."""
IMAGES = exp(-(RATE + SPLIT) / 2), exp(-(RATE - SPLIT) / 2)
PROMPT = answers(transfer(PARTS, 0, s), s, z, X, T)
"""X is the answer of the device."""
LATE = answers(transfer(PARTS, d * T, s), s, z, X_d, T)
"""X_d is its answer d periods late."""


def motion(device: Sequence[Any]) -> tuple[Expr, ...]:
    """Phi and Gamma of a device as functions of time; a part that is zero is not modelled."""
    mass, damping, stiffness = device
    plant = Plant(mass, None if damping == 0 else damping, None if stiffness == 0 else stiffness)
    return tuple(plant.transition(t)) + tuple(plant.held(t))


def denominator() -> Expr:
    """z^2 - (c_2 + c_3) z + exp(-delta), in the parameters of the device."""
    return z**2 - z * sum(IMAGES) + exp(-RATE)


def numerator() -> Expr:
    """((2 - c_2 - c_3) c_1 + (c_2 - c_3) delta) z + (2 exp(-delta) - c_2 - c_3) c_1 + ..."""
    one, two = IMAGES
    first = (2 - one - two) * SPLIT + (one - two) * RATE
    second = (2 * exp(-RATE) - one - two) * SPLIT + (two - one) * RATE
    return first * z + second


@cache
def poles_apart() -> tuple[Theorem, ...]:
    """What the motion divides by is not zero, if c_1 and gamma are not."""
    split, spring = assume(Ne(SPLIT, 0)), assume(Ne(SPRING, 0))
    square = combined(Ne(SPLIT**2, 0), [split, split])
    upper, lower = (-RATE + SPLIT) / 2, (-RATE - SPLIT) / 2
    return (square, *(factor(e, spring, -other) for e, other in ((upper, lower), (lower, upper))))


@cache
def answer(late: bool = False) -> Theorem:
    """The answer X (or X_d, with integer delays): z, A != 0 and 2 c_1 gamma (m X/T^2) A = N z^-d.

    Of a device with m, T > 0, c_1 != 0 and gamma != 0.
    """
    claim, found, delay = (LATE, X_d, d) if late else (PROMPT, X, sp.S.Zero)
    units = in_units(PARTS, delay * T, z, found, T, (T, m / T**2))
    device = (sp.S.One, RATE, SPRING)
    held = held_answer(device, (delay, 0), s, z, m / T**2 * found, motion(device), t)
    given = mp(held, mp(units, assume(claim)))
    alive, apart, equation = (conjunct(given, p) for p in given.conclusion.of)  # type: ignore[attr-defined]
    below = denominator()
    kept = combined(Relation(below, "!=", sp.S.Zero), [apart])
    pushed = Relation(2 * SPLIT * SPRING * m / T**2 * found * below, "=", numerator() * z**-delay)
    solved = combined(pushed, [equation, 2 * SPLIT * SPRING])
    mass, period = positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0)
    force = closed(positive(Ne(m / T**2, 0), [assume(m > 0), positive_square()]), mass, period)
    lemmas = (*poles_apart(), mass, period, force, alive)
    steps = () if late else (fact(whole(0)),)
    return closed(conj(alive, kept, solved), *lemmas, *steps)


def positive_square() -> Theorem:
    """0 < 1/T^2."""
    return over(1 / T**2 > 0, one(), positive(T**2 > 0, [T > 0, T > 0]))


@cache
def late_answer() -> Theorem:
    """X_d = z^-d X with integer delays, for every device."""
    later = mp(shifted(PARTS, 0, z, X, T, d), assume(PROMPT))
    return one_answer(assume(LATE), later)


def lumped(claim: Proposition) -> Theorem:
    """Of X behind two delays and X_d behind their sum and l periods: 1 + X z^-l H = 1 + X_d H.

    And the polynomials of both loops, cleared of their divisors.
    """
    _, given, then = taken_apart(claim)
    wall, cleared = then.parts
    own = next(p for p in given if isinstance(p, Predicate) and p.over and p.of[2] == X)
    total = next(p for p in given if isinstance(p, Relation) and p.left == d)
    late = (d_1 + d_2) * T
    moved = mp(shifted(PARTS, late, z, X, T, l), assume(own))
    rate = sp.Dummy("rate")  # of exp(rate s)
    behind = answers(transfer(PARTS, -rate, s), s, z, z**-l * X, T)
    sum_ = combined(Relation(-(late + l * T), "=", -d * T), [assume(total), T])
    equal = one_answer(assume(LATE), subst(behind, rate, moved, sum_))
    factor_ = (K + B * (z - 1) / (T * z)) * -S.One
    alive, period = turns(assume(LATE)), positive(Ne(T, 0), T > 0)
    same = closed(combined(wall, [equal, factor_]), alive, period)
    polynomial = cleared.body  # type: ignore[attr-defined]
    found = closed(identity(polynomial.left, polynomial.right), alive)
    return conj(same, gen(found, *cleared.over))  # type: ignore[attr-defined]


def sampled_as(form: Expr) -> Theorem:
    """X = form, a quotient in the parameters of the device alone; hypotheses as of ``answer``."""
    given = answer()
    _, apart, equation = (conjunct(given, p) for p in given.conclusion.of)  # type: ignore[attr-defined]
    cofactor = T**2 / (2 * SPLIT * SPRING * m * denominator())
    found = combined(Relation(X, "=", form), [equation, cofactor])
    return closed(found, apart, *device_divisors())


@cache
def device_divisors() -> tuple[Theorem, ...]:
    """m, T, k, b^2 - 4 k m and c_1^2 are not zero."""
    mass, period = positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0)
    square = poles_apart()[0]
    spring = closed(
        combined(Ne(k, 0), [assume(Ne(SPRING, 0)), assume(m > 0), positive_square()]), mass, period
    )
    discriminant = closed(
        combined(
            Ne(4 * k * m - b**2, 0), [square, assume(m > 0), assume(m > 0), positive_square()]
        ),
        mass,
        period,
    )
    return mass, period, spring, discriminant, square, *poles_apart()


def loop_as(form: Expr, bottom: Expr, wall: Expr, late: bool = True) -> Theorem:
    """X/(1 + X_d H) = form, a quotient with this divisor p, in the device's parameters.

    Without ``late`` the delay is 0, and X_d a second name of the answer.
    """
    first, second = answer(), answer(late) if late else _twice()
    _, apart, equation = (conjunct(first, p) for p in first.conclusion.of)  # type: ignore[attr-defined]
    alive, _, delayed = (conjunct(second, p) for p in second.conclusion.of)  # type: ignore[attr-defined]
    steps = d + 1 if late else sp.S.One
    gain, unit = 1 + X_d * wall, 2 * SPLIT * SPRING * m / T**2
    loop = assume(Relation(gain, "!=", sp.S.Zero))
    power = closed(factor(z**steps, fact(Relation(sp.S.One, "!=", sp.S.Zero)), -(z**-steps)), alive)
    factors = [loop, apart, assume(Ne(SPLIT, 0)), assume(Ne(SPRING, 0)), power, 2]
    cofactor = -(z**steps) * wall * T**2 / m
    kept = combined(Relation(bottom, "!=", sp.S.Zero), factors, [delayed, cofactor])
    both = unit * denominator() * gain
    found = combined(
        Relation(X / gain, "=", form),
        [equation, 1 / both],
        [delayed, -numerator() * cofactor / (bottom * both)],
    )
    return closed(found, kept, loop, apart, alive, *device_divisors())


def _twice() -> Theorem:
    return inst(answer(), {X: X_d})


def device_claim(claim: Proposition, conditions: Sequence[Any]) -> Theorem:
    """A claim X = form for every device, under conditions that keep its motion from 0/0."""
    then = taken_apart(claim)[2]
    names = definitions(taken_apart(claim)[1])
    found = sampled_as(explicit(then.right, *names))  # type: ignore[attr-defined]
    return _claimed(claim, conditions, renamed(found, then, *names))


@cache
def loop_claim(
    claim: Proposition, conditions: tuple[Any, ...], bottom: Expr, wall: Expr, late: bool = True
) -> Theorem:
    """A claim X/(1 + X_d H) = form, with this divisor, for every loop."""
    then = taken_apart(claim)[2]
    names = definitions(taken_apart(claim)[1])
    form = explicit(then.right, *names)  # type: ignore[attr-defined]
    found = loop_as(form, explicit(bottom, *names), wall, late)
    return _claimed(claim, conditions, renamed(found, then, *names))


def _claimed(claim: Proposition, conditions: Sequence[Any], found: Theorem) -> Theorem:
    given = taken_apart(claim)[1]
    names = definitions(given)
    known = [assume(c) for c in map(proposition, conditions) if isinstance(c, Relation)]
    apart = [t for c in known for t in unnamed(c, *names)]
    mass, period = positive(Ne(m, 0), m > 0), positive(Ne(T, 0), T > 0)
    if Ne(k, 0) in conditions:
        scale = closed(over(1 / m > 0, one(), m > 0), mass)
        apart.append(positive(Ne(SPRING, 0), [Ne(k, 0), T > 0, T > 0, scale]))
    found = closed(found, mass, period, *apart)
    return as_claimed(claim, found, *conditions)
