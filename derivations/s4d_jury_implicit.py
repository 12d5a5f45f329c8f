r"""Is there an explicit solution with a delay of one period?

The paper says that only an implicit solution could be determined for $d=1$. We derive this equation
for every device and find that it is quadratic in $\alpha$. For longer delays we show that the
implicit equation agrees with the explicit boundary.
"""

from symhaptic.book.figures.passivity import free_mass_inequalities
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import collected, free_by_inequalities
from symhaptic.model import jury

RISE, PLANE = n_1 + n_0, 4 - alpha - 4 * beta


def derive(page):
    minor = jury.criterion(jury.coefficients(1)).expressions[-1]
    low = n_0 * alpha - (n_1 - n_0) * beta
    page.step(
        "For one period of delay the last minor is a difference of two products",
        minor,
        (1 + n_0 * beta) ** 2 * (1 - e - n_1 * (alpha + beta) - n_0 * beta)
        - (low + a) * (low - a * n_0 * beta),
        name=r"\Delta_3",
        because="the difference has this form for every device",
    )
    page.say(r"Without a spring we show that the minor is quadratic in $\alpha$:")
    page.define("Without a spring the device has a pole at 1", a, 1 + e)
    page.define("Without a spring the damping gives the other pole", e, 1 - delta * RISE)
    linear = n_0**2 * n_1 * beta**2 + (1 - e) * n_0**2 * beta + (1 + e) * n_0 + n_1
    constant = RISE * (beta + delta) * (1 - (n_1 + e * n_0) * beta - n_0**2 * beta**2)
    implicit = constant - linear * alpha - n_0**2 * alpha**2
    page.step(
        r"The implicit condition is a quadratic in $\alpha$",
        minor,
        implicit,
        name=r"\Delta_3",
        boxed=True,
    )
    root = (sqrt(linear**2 + 4 * n_0**2 * constant) - linear) / (2 * n_0**2)
    page.same("a root", implicit.subs(alpha, root), S.Zero)
    page.say(
        "So, with one period of delay, a square root gives an explicit solution. The solution "
        "is shortest for a free mass: $p_1(-1)=4$, and four inequalities are left:"
    )
    free_mass(page)
    two_roads(page)


def free_mass(page):
    minor = 2 * beta * (4 - 4 * beta - beta**2) - (beta**2 + 12) * alpha - 2 * alpha**2
    four = collected(free_by_inequalities(1), alpha > 0, PLANE > 0, 2 + beta > 0, minor > 0)
    page.lemma(
        "With one period of delay four inequalities decide the stability of a free mass", four
    )
    page.lemma(
        "With one period of delay three inequalities decide the stability of a free mass",
        chained(four, three_are_enough(minor, *four.conclusion.of[1].parts)),
        because="for $-2<\\beta\\le0$ the minor is negative, as "
        "$4-4\\beta-\\beta^2=4-\\beta(4+\\beta)$ is positive; for $\\beta>0$ the second half plane "
        "follows from the minor",
        boxed=True,
    )
    page.say(
        r"So $\alpha$ lies between 0 and the larger root of a quadratic. The roots of this "
        r"quadratic have different signs if $4-4\beta-\beta^2>0$, that is for $0<\beta<2\sqrt2-2$:"
    )
    middle = beta**2 + 12
    width = sqrt(middle**2 + 16 * beta * (4 - 4 * beta - beta**2))
    explicit, other = (width - middle) / 4, (-width - middle) / 4
    page.lemma(
        "The minor of a free mass vanishes at this stiffness with one period of delay",
        combined(Eq(minor, 0), [assume(Eq(alpha, explicit)), 2 * (other - alpha)]),
        because="the stable walls have less than this stiffness",
        boxed=True,
    )


def three_are_enough(minor, *four):
    """The condition beta > 0 replaces the second and the third of the four inequalities."""
    positive_minor = Relation(S.Zero, "<", minor)
    before, after = both(four), both([alpha > 0, beta > 0, positive_minor])
    push, _, low, last = (conjunct(assume(before), p) for p in four)
    wanted, weak = Relation(S.Zero, "<", beta), assume(beta <= 0)
    denial = combined(
        Relation(minor, "<", S.Zero),
        *([8, weak], [2, weak, weak, low], [4, weak, weak]),
        *([push, square(beta)], [12, push], [2, push, push]),
    )
    braked = disj_cases(
        ordered(S.Zero, beta), assume(wanted), contr(not_intro(last, denial), wanted)
    )
    there = conj(push, braked, last)
    push, brake, last = (conjunct(assume(after), p) for p in after.parts)
    low = positive(2 + beta > 0, [2], [brake])
    back = conj(push, half_plane(push, brake, last), low, last)
    return either_way(there, back, before, after)


def half_plane(push, brake, last):
    """0 < PLANE, because 8 beta (1 - beta) is positive where the minor is positive."""
    rest = positive(
        8 * beta * (1 - beta) > 0, [last], [2, *[brake] * 3], [12, push], [push, brake, brake],
        [2, push, push],
    )  # fmt: skip
    room = over(1 - beta > 0, rest, positive(8 * beta > 0, [8, brake]))
    found = positive(
        PLANE > 0,
        [Rational(1, 12), last],
        [Rational(10, 3), room],
        [Rational(2, 3), room, room],
        [Rational(1, 6), *[brake] * 3],
        [Rational(1, 12), push, brake, brake],
        [Rational(1, 6), push, push],
    )
    return closed(found, positive(Ne(8 * beta, 0), [8, brake]))


def two_roads(page):
    device = Sampled(n_1, n_0, a, e)
    page.say(
        r"The degree in $\alpha$ rises by one with every period, so a formula for the "
        "solution does not exist in general for longer delays. But the boundary with the angle as "
        r"parameter stays explicit. We insert the wall with a root at $e^{j\theta}$ into the last "
        "minor, for any device and $d=0,1,2$:"
    )
    stiffness, damping = boundary.wall(device)
    for delay in range(3):
        minor = jury.criterion(jury.coefficients(delay)).expressions[-1]
        wall = {alpha: stiffness.subs(d, delay), beta: damping.subs(d, delay)}
        page.step(
            f"For $d={delay}$ the last minor vanishes on the explicit boundary",
            minor.subs(wall, simultaneous=True),
            S.Zero,
            name=rf"\Delta_{delay + 2}\bigl(\alpha(\theta),\beta(\theta)\bigr)",
            because=r"on the circle, the wall satisfies $\alpha+\beta(1-1/z)=-z^dA/N$",
        )
    page.figure(
        "jury",
        "Jury's inequalities for a free mass with two periods of delay. Each line is the "
        "boundary of one inequality. All inequalities hold in the green region. The dots are "
        "points of the explicit boundary. The thick line is the boundary of the last minor; only "
        r"this line and $\alpha=0$ bound the region.",
        free_mass_inequalities,
    )
