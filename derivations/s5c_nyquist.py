"""Up to which stiffness is the natural frequency of the device below the Nyquist frequency?

A device with a spring oscillates. Sampling can represent the oscillation up to the Nyquist
frequency. We ask for which stiffness the device reaches this frequency.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.swing import SQUARE, by_its_square, rewritten, swings, up_to_nyquist


def derive(page):
    damped = Plant()
    rate = sqrt(k / m - b**2 / (4 * m**2))
    one, two = damped.poles(2 * I * rate)
    page.step(
        r"An underdamped device has a pole at $-\frac b{2m}+j\omega$",
        damped.characteristic.subs("s", one),
        S.Zero,
        name=r"ms^2+bs+k\,\big|_{s=-\frac{b}{2m}+j\omega}",
        because=r"the frequency $\omega$ follows from the roots of $ms^2+bs+k$ and is real for "
        "$k>b^2/(4m)$",
        paper="28",
    )
    page.lemma(
        "A damped mass on a spring oscillates with one frequency only",
        swings(),
        because=r"the motion $e^{\sigma t}\sin\omega t$ satisfies Newton's law if and only if "
        "the coefficients of its sine and of its cosine vanish",
    )
    _frequency(page, (one - two) / (2 * I))
    unit = plant.normalised(Parts())
    turns = sqrt(gamma - delta**2 / 4)
    page.step(
        "In units of mass and period the pole lies at $-\\delta/2+j\\omega T$",
        unit.characteristic.subs("s", unit.poles(2 * I * turns)[0]),
        S.Zero,
        name=r"s^2+\delta s+\gamma\,\big|_{s=-\delta/2+j\omega T}",
        because=r"Table I gives $\omega T=\sqrt{\gamma-\delta^2/4}$",
        paper="29",
    )
    _in_units(page, turns)
    page.say(
        r"The Nyquist frequency is $\omega T=\pi$. The two sides of $\omega T\le\pi$ are "
        "positive, so their squares can be compared:"
    )
    page.lemma(
        "The damped frequency is at most the Nyquist frequency if and only if (30) holds",
        up_to_nyquist(),
        boxed=True,
    )
    _up_to_nyquist(page, turns)
    _undamped(page)


def _frequency(page, frequency):
    """(28) follows by taking the root of the square of the frequency."""
    given = taken_apart(CLAIMED["eq28"]((Eq(omega, frequency),)))[1]
    square = over(SQUARE > 0, positive(4 * m * k - b**2 > 0, [4, m > 0, given[2]]), _four(m))
    apart = positive(Ne(m, 0), m > 0)
    root = closed(by_its_square(SQUARE), positive(SQUARE >= 0, [square]), apart)
    same = closed(rewritten(root, swings()), apart)
    point = {m: S.One, b: S.Zero, k: S.One, omega: S.One}
    page.settle("eq28", same, Eq(omega, frequency), example=point)


def _four(mass):
    return positive(4 * mass**2 > 0, [4, mass > 0, mass > 0])


def _in_units(page, turns):
    """(29) follows from (28) and Table I."""
    _, given, same = taken_apart(CLAIMED["eq29"]((Eq(omega, turns / T),)))
    unit = inst(swings(), {b: delta * m / T, k: gamma * m / T**2})
    angle = by_its_square(gamma - delta**2 / 4)
    angle = inst(angle, {omega: omega * T})
    apart = positive(Ne(T, 0), T > 0), positive(Ne(m, 0), m > 0)
    root, turned = angle.conclusion.of
    value, swinging = same.of
    square = unit.conclusion.of[1]
    there = mp(angle, combined(root, [assume(value), T]))
    there = mp(unit, combined(square, [there, 1 / T**2]))
    back = mp(angle, combined(turned, [mp(unit, assume(swinging)), T**2]))
    back = combined(value, [back, 1 / T])
    both = either_way(there, back, value, swinging)
    both = closed(
        both,
        *apart,
        positive(omega * T > 0, [omega > 0, T > 0]),
        positive(gamma - delta**2 / 4 >= 0, given[3]),
    )
    point = {m: S.One, T: S.One, gamma: S.One, delta: S.Zero, omega: S.One}
    page.settle("eq29", both, Eq(omega, turns / T), example=point)


def _up_to_nyquist(page, turns):
    """(30): the frequency (29), if it is real, is at most the Nyquist frequency."""
    _, given, both = taken_apart(CLAIMED["eq30"]((turns**2 <= pi**2,)))
    swinging, calm = both.of
    same = disch(up_to_nyquist(), swinging.of[0])
    slow = positive(calm.of[1], calm.of[0], number(Relation(S.Zero, "<", pi**2)))
    found = add_assum(conj(same, disch(slow, calm.of[0])), *given)
    point = {T: S.One, gamma: S.One, delta: S.Zero, omega: S.One}
    page.settle("eq30", found, turns**2 <= pi**2, example=point)


def _undamped(page):
    """Without damping (30) is an equation for gamma = pi^2."""
    _, given, then = taken_apart(page.claim("s5c-nyquist-spring"))
    reached, spring = then.of
    law, period = assume(given[-1]), positive(Ne(T, 0), T > 0)
    root = combined(Eq(sqrt(gamma), pi), [assume(reached), 1], [law, -T])
    stiff = combined(spring, [root, sqrt(gamma) + pi])
    place = Relation(sqrt(delta), "=", pi)
    root = combined(Eq(pi**2, gamma), [assume(spring), -1])
    root = subst(place, delta, identity(sqrt(pi**2), pi), root)
    fast = combined(reached, [root, 1], [law, T])
    same = closed(either_way(stiff, fast, reached, spring), period)
    page.settle(
        "s5c-nyquist-spring",
        same,
        example={T: S.One, omega: S.One, gamma: S.One},
        note=r"with damping the limit is $\gamma=\pi^2+\frac14\delta^2$",
    )
