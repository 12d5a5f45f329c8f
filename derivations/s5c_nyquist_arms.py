"""Is the limit of the spring ten thousand times the stiffness of an arm?

The paper says that the spring at the Nyquist limit is ten thousand times as stiff as an arm. We
compare this limit with the arms of Table II.
"""

from symhaptic.book.lemmas.arm_ranges import SHARE, above, damped, divisors, scale, weak
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.swing import spring_of_nyquist

DEVICE = {m: Rational(1, 10), T: Rational(1, 1000)}
"""Example 5.1, in kg and s."""

HOGAN = {m: Rational(8, 10), k_H: S(568), T: Rational(1, 1000)}
"""The arm with the largest stiffness per mass in Table II, without the row that is left out."""


def derive(page):
    arms(page)
    human(page)


def arms(page):
    """Compare the limit with the arms in units of mass and period."""
    page.say(
        r"In units of mass and period the limit is between $\gamma=\pi^2$ and $\pi^2+0.0001$. The "
        r"range (23) ends at $\gamma=0.001$:"
    )
    _, given, near = taken_apart(page.claim("s5c-human-10000"))
    limit, largest = map(assume, given[-2:])
    lower = combined(
        gamma >= 9500 * x,
        [above(pi**2, Rational(19, 2))],
        [square(delta), S.One / 4],
        [limit, -1],
        [largest, 9500],
    )
    upper = combined(
        gamma < 10000 * x,
        [above(10 - Rational(1, 10000), pi**2)],
        [S.One / 4, weak()],
        [limit, S.One],
        [largest, -10000],
    )
    size = combined(x > 0, [above(S.One / 1000, S.Zero)], [largest, -1])
    lower = over((gamma - 9500 * x) / x >= 0, positive(gamma - 9500 * x >= 0, [lower]), size)
    upper = over((10000 * x - gamma) / x > 0, positive(10000 * x - gamma > 0, [upper]), size)
    found = conj(combined(near.of[0], [lower]), combined(near.of[1], [upper]))
    found = closed(found, positive(Ne(x, 0), [size]))
    page.settle(
        "s5c-human-10000",
        found,
        example={gamma: pi**2, delta: S.Zero, x: Rational(1, 1000)},
        enclosed=True,
        value=1000 * pi**2,
        note="the number holds for $T=1$ ms. The range (23) is wider than (21); the "
        r"$710\,\mathrm{s}^{-2}$ of (21) give $\pi^2/0.00071=13\,900$. The number is proportional "
        "to $1/T^2$",
    )
    frequency = plant.Plant(damping=None).poles()[0]
    page.same("without damping", (frequency.subs(k, spring_of(m)) / I) ** 2, (pi / T) ** 2)


def human(page):
    """Compare the limit with the arms in N/m."""
    page.say(
        "The limit and the end of (23) are stiffnesses per mass. Their ratio is the ratio of the "
        "stiffnesses only if the limit is that of the arm's mass. For Hogan's arm, 0.8 kg and "
        r"568 N/m, the limit is $k=\pi^2m/T^2$. For the device of Example 5.1 alone, 0.1 kg, the "
        "limit is much smaller:"
    )
    for title, mass in (
        ("For Hogan's arm the spring is 13\\,900 times as stiff", HOGAN[m]),
        ("For the device alone it is 1740 times as stiff as that arm", DEVICE[m]),
    ):
        limit = spring_of(mass).subs(T, HOGAN[T]) / HOGAN[k_H]
        page.step(
            title,
            limit,
            mass * 10**6 * pi**2 / 568,
            name=r"\frac{\pi^2m}{T^2k_H}\Big|_{T=1\,\mathrm{ms}}",
        )
    _, given, about = taken_apart(page.claim("s6-human-10000"))
    alike = Eq(k_H * T**2 / m, Rational(1, 1000))
    low, high = about.of
    arm, spring = assume(alike), mp(spring_of_nyquist(), assume(given[-1]))
    lower = combined(
        low,
        [scale(), above(pi**2, Rational(19, 2))],
        [over(1 / m > 0, one(), m > 0), square(b), S.One / 4],
        [arm, 9500 * m / T**2],
        [spring, -1],
    )
    upper = combined(
        high,
        [scale(), above(Rational(21, 2) - Rational(1, 10000), pi**2)],
        [scale(), weak(SHARE), S.One / 4],
        [arm, -10500 * m / T**2],
        [spring, S.One],
    )
    found = closed(conj(lower, upper), *divisors(), damped())
    point = {**DEVICE, b: S.Zero, k: spring_of(m).subs(DEVICE), k_H: HOGAN[k_H]}
    same = point | {k_H: S(100)}
    page.settle(
        "s6-human-10000",
        found,
        example=(same, swung(same)),
        unless={alike: (point, swung(point), soft(about.at(point)))},
        shows=r"the 987\,000 N/m of Example 5.1 are 1740 times the stiffness of an arm of 568 N/m",
        note=r"at $T=1$ ms the factor is 13\,900 with the stiffness per mass of (21), and 9870 "
        "with that of (23)",
    )


def swung(point):
    """The device of this point oscillates at the Nyquist frequency."""
    there = inst(spring_of_nyquist(), {s: point[s] for s in (m, b, k, T)})
    return mp(closed(there, *map(fact, there.hypotheses)), fact(there.conclusion.of[0]))


def soft(about):
    """The spring is less than 9500 times as stiff as the arm."""
    low = about.of[0]
    return not_intro(conjunct(assume(about), low), number(negated(low)), about)


def spring_of(mass):
    """Stiffness that brings an undamped mass to the Nyquist frequency."""
    return pi**2 * mass / T**2
