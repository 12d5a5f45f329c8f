"""When is the loop stable if the device oscillates at the Nyquist frequency?

At the Nyquist frequency the state of the free device changes its sign after each period, and decays
if the device is damped. We ask which walls are stable with such a device.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.model import loop
from symhaptic.paper.propositions.comparison import (
    LATE,
    MIRROR,
    TURNED,
    WALLS,
    kept_at_minus_one,
    limit_stable_undelayed,
    q,
    split_off,
)
from symhaptic.proof.theorems.familiar import held_by_a_pole
from symhaptic.proof.theorems.roots import pole_at


def derive(page):
    page.say(
        "Without damping the state only changes its sign after each period. The numerator cancels "
        "one of the two poles at $-1$:"
    )
    page.step(
        "At $\\gamma=\\pi^2$, $\\delta=0$ the polynomial has the factor $z+1$",
        loop.characteristic(Parts(damping=False)).subs(gamma, pi**2),
        (z + 1) * ((z + 1) * z ** (d + 1) + 2 * ((alpha + beta) * z - beta) / pi**2),
        name="p_1(z)",
        because="therefore the polynomial has the root $-1$ for every wall and every delay",
    )
    pole = page.lemma(
        "Without damping a pole lies at $-1$, and no wall moves it",
        mirrored_pole(S.Zero),
        because=r"for a delay of $\ell/q$ periods, $w=e^{j\pi/q}$ is a root of the polynomial in "
        "$w=z^{1/q}$, and $w^q=-1$",
    )
    page.lemma(
        "For integer delays one pole at $-1$ is not observable in the samples",
        split(),
        because="the polynomial is $z+1$ times a second polynomial, which is zero at $-1$ only "
        r"for $\alpha+2\beta=0$",
    )
    page.say(
        "The loop is limit stable if $-1$ is a simple zero and all other zeros lie inside the "
        "unit circle. Without delay the other factor is of second order:"
    )
    page.lemma(
        "Without delay the other zeros lie inside if and only if the wall lies in a triangle",
        triangle(),
        boxed=True,
    )
    once = {alpha: S.One, beta: S.Zero, delta: S.One, l: S.One, q: S.One}
    held = held_by_a_pole(pole, number(Relation(S.One, "<=", S.One)))
    kept = as_claimed(kept_at_minus_one(), conj(pole, held))
    page.settle(
        "s5c-undamped-limit",
        conj(kept, split(), triangle()),
        note=r"the pole is proved for every delay of $\ell/q$ periods, the factor for integer "
        "delays, and the region for $d=0$; for other delays the region is not derived",
    )
    damped = page.lemma(
        "With damping a pole lies at $-e^{-\\delta/2}$, and no wall moves it",
        mirrored_pole(delta),
        because=r"for $\gamma=\pi^2+\delta^2/4$, a damped device oscillates at the Nyquist "
        "frequency",
    )
    page.settle(
        "s5c-pole-inside",
        conj(damped, *inside()),
        example=(once, fact(whole(S.One))),
        note=r"at the Nyquist frequency this pole is $-e^{-\delta/2}$, for every wall and delay",
    )


# At the Nyquist frequency the state of the device changes its sign: a pole that no wall moves.


@cache
def mirrored_pole(damping: Expr) -> Theorem:
    """For gamma = pi^2 + delta^2/4, -exp(-delta/2) is a pole for every wall and delay l/q."""
    spring, damped = pi**2 + damping**2 / 4, damping != 0
    device = plant.sampled(plant.normalised(Parts(damping=damped)), split=2 * I * pi)
    turn = -damping / 2 + I * pi
    there = exp(turn)
    values = {gamma: spring, delta: damping, z: there}
    wall = (alpha + beta) * there - beta
    loop = exp((LATE + 1) * turn) * device.denominator + device.numerator * wall
    zero = identity(loop.xreplace(values), S.Zero)
    parts = {"damping": damped}
    found = pole_at((alpha, beta, spring, damping, LATE), z, q, turn, zero, **parts)
    here = Given(whole(l), whole(q), q > 0)
    full = number(Relation(S.Zero, "<", pi**2))
    stiff = show(Relation(S.Zero, "<", spring), square(damping), full)
    stiffer = here.closed(found, stiff)
    if not damped:
        return stiffer
    other = -damping / 2 - I * pi
    return closed(stiffer, factor(turn, stiff, other), factor(other, stiff, turn))


@cache
def inside() -> tuple[Theorem, Theorem]:
    """-1 < -exp(-delta/2) < 1 for delta > 0."""
    low, high = rising(exp, -delta / 2, S.Zero), sign_of(exp, -delta / 2)
    return Given(delta > 0).show(MIRROR > -1, low), show(MIRROR < 1, high)


@cache
def undamped() -> dict[str, Theorem]:
    """Without damping a = -2, e = 1, n_1 = n_0 and n_1 = 2/pi^2."""
    device = axiom("undamped device", pi, *NUMBERS)
    turn, alike = (conjunct(device, claim) for claim in device.conclusion.parts)
    here = assume(Predicate("device", (), (pi**2, S.Zero, *NUMBERS)))
    loss = combined(Eq(e, 1), [of_device("device's loss", here)])
    half = 1 / (2 * pi**2)
    length = combined(
        Eq(n_1, TURNED),
        [-half, of_device("device at rest", here)],
        [S.Half, alike],
        [-half, turn],
        [half, loss],
    )
    return {"turn": turn, "alike": alike, "loss": loss, "length": length}


@cache
def split() -> Theorem:
    """The polynomial is z + 1 times another one, and one pole of the device at -1 cancels."""
    claim = split_off()
    given, (seen, once) = conjuncts(claim.body.of[0]), conjuncts(claim.body.of[1])
    turned, left = conjuncts(seen.body)
    known, late, below = undamped(), z ** (d + 1), z**2 - a * z + e
    shown = combined(
        turned.of[1],
        [-z * late, known["turn"]],
        [late, known["loss"]],
        [WALLS * (z + 1), known["length"]],
        [-WALLS, known["alike"]],
    )
    more = assume(left.of[0])
    both_ = below * (z + 1)
    quotient = combined(
        left.of[1],
        [TURNED * z / both_, known["turn"]],
        [-TURNED / both_, known["loss"]],
        [(z + 1) / below, known["length"]],
        [-1 / below, known["alike"]],
    )
    apart = combined(Ne(below, 0), [more, more], [z, known["turn"]], [-1, known["loss"]])
    quotient = closed(quotient, apart, combined(Ne(z + 1, 0), [more]))
    pairs = ((shown, turned), (quotient, left))
    at_each = gen(conj(*(disch(t, p.of[0]) for t, p in pairs)), z)
    value, sum_ = once.of
    there = combined(sum_, [-(pi**2) / 2, assume(value)])
    back = combined(value, [-TURNED, assume(sum_)])
    found = conj(at_each, either_way(there, back, value, sum_))
    return for_all(claim.over, given, add_assum(found, *given))


@cache
def triangle() -> Theorem:
    """Without delay the other zeros lie inside if and only if the wall lies in a triangle."""
    claim: Any = limit_stable_undelayed()
    zeros, walls = claim.body.of
    inside = jury(zeros.of[0], z)
    half = number(Relation(S.Zero, "<", pi**2 / 2))
    share = number(Relation(S.Zero, "<", TURNED))
    minors = conjuncts(inside.conclusion.of[1])
    left, down, right = conjuncts(walls)
    sides = (left, right, down)
    there = {p: combined(p, [half, assume(m)]) for p, m in zip(sides, minors, strict=True)}
    back = [combined(m, [share, assume(p)]) for p, m in zip(sides, minors, strict=True)]
    same = either_way(
        conj(*(there[p] for p in conjuncts(walls))), conj(*back), inside.conclusion.of[1], walls
    )
    return gen(chained(inside, numbers_known(same)), alpha, beta)
