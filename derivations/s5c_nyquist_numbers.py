r"""Which spring reaches the Nyquist frequency, and does the damper matter?

The device reaches the Nyquist frequency at $\gamma=\pi^2+\delta^2/4$. Example 5.1 of the paper
states this stiffness in SI units.
"""

from symhaptic.book.lemmas.arm_ranges import FIFTIETH, SHARE, above, damped, divisors, scale, weak
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.swing import spring_of_nyquist
from symhaptic.paper.propositions.comparison import EXAMPLE
from symhaptic.proof import box
from symhaptic.proof.theorems.leaves import on_box


def derive(page):
    spring = pi**2 * m / T**2 + b**2 / (4 * m)
    one, two = Plant().poles(2 * I * sqrt(k / m - b**2 / (4 * m**2)))
    page.step(
        "With the spring (31) the device oscillates at the Nyquist frequency",
        (((one - two) / (2 * I)) ** 2).subs(k, spring),
        (pi / T) ** 2,
        name=r"\omega^2\big|_{k=\pi^2m/T^2+b^2/(4m)}",
        because="the stiffness follows from (28) for an underdamped device",
        paper="31",
    )
    example_(page, spring)
    marginal(page, spring)


def example_(page, spring):
    """Example 5.1."""
    device = spring.subs(EXAMPLE)
    page.step(
        "For $m=0.1$ kg and $T=1$ ms the damper adds $\\frac52b^2$",
        device,
        100000 * pi**2 + Rational(5, 2) * b**2,
        name=k,
    )
    page.say(
        r"Without damping the stiffness is $986\,960.44\ldots$ N/m. It rounds to 987 000 N/m as "
        r"long as $2.5\,b^2<540$ (in SI units), that is for $b\le14.6$ Ns/m. The range (23) has "
        r"$b\le0.02m/T=2$ Ns/m:"
    )
    page.lemma(
        "For $0\\le b\\le14.6$ Ns/m the stiffness of Example 5.1 stays below 987\\,500 N/m",
        on_box(box.positive(987500 - device, {b: (0, Rational(146, 10))})),
        because="therefore the stiffness rounds to the published number",
    )
    then = taken_apart(CLAIMED["eq31"]((Eq(k, spring),)))[2]
    _, rounds = then.of
    about = disch(rounded(spring, rounds.of[1]), rounds.of[0])
    point = {m: S.One, b: S.Zero, k: S.One, T: S.One}
    page.settle(
        "eq31",
        conj(spring_of_nyquist(), about),
        Eq(k, spring),
        example=point,
        enclosed=True,
        value=device.subs(b, 0),
        note=r"the number belongs to $b=0$ and is right for $b\le14.6$ Ns/m; (23) has $b\le2$ Ns/m",
    )


def marginal(page, spring):
    """The contribution of the damping does not change the published digits."""
    page.define(r"Table I defines the damping $\delta$", delta, b * T / m)
    page.step(
        r"The contribution of the damping depends only on $\delta$",
        b**2 / (4 * m) / (pi**2 * m / T**2),
        delta**2 / (4 * pi**2),
        because="the ratio to the stiffness without damping is the same for every device",
    )
    then = taken_apart(page.claim("s5c-marginal-b"))[2]
    small, rounds = then.of
    room = above(Rational(102, 10**7) * pi**2, Rational(1, 10000))
    less = closed(
        combined(small, [scale(), room], [scale(), weak(SHARE), Rational(1, 4)]), *divisors()
    )
    about = rounded(spring, rounds)
    page.settle(
        "s5c-marginal-b",
        closed(conj(less, about), *divisors()),
        example={m: S.One, b: S.Zero, T: S.One},
        note=r"the contribution is less than $1.02\cdot10^{-5}$ of the stiffness inside (23)",
    )


def rounded(spring, claim):
    """986500 <= k < 987500 for Example 5.1, where b <= 2."""
    values, bounds = claim.of
    mass, period = (assume(Eq(s, EXAMPLE[s])) for s in (m, T))
    same = combined(
        Eq(spring, 100000 * pi**2 + Rational(5, 2) * b**2),
        [mass, pi**2 / T**2 - 5 * b**2 / (2 * m)],
        [period, -100000 * pi**2 * (T + EXAMPLE[T]) / T**2],
    )
    most = combined(b <= 2, [100, assume(SHARE <= FIFTIETH)], [mass, b / m], [period, -100 * b / m])
    room = positive(2 + b > 0, [damped()], [2])
    low, high = bounds.of
    lower = combined(low, [above(100000 * pi**2, 986500)], [square(b), Rational(5, 2)], [same, -1])
    upper = combined(
        high, [above(987490, 100000 * pi**2)], [Rational(5, 2), most, room], [same, S.One]
    )
    return disch(closed(conj(lower, upper), *divisors()), values)
