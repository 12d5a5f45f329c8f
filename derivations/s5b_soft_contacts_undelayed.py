r"""Can the stiffness of a stable wall always be reduced without delay?

With a delay a stable wall can become unstable if its stiffness is reduced at constant damping
(\chapter{s5b_soft_contacts}). We ask for which arms this cannot happen without delay.
"""

from symhaptic.book.lemmas.arm_numbers import pushed
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import by_inequalities, stable_at, unstable_at
from symhaptic.book.lemmas.stiffest_stable import damping_between, inequalities, towards
from symhaptic.model import jury

RISE = n_1 + n_0
IN_WIDE = r"0\le\gamma\le0.01,\ 0\le\delta\le0.1"


def derive(page):
    page.say(
        "Without delay, Jury's inequalities decide. The device satisfies "
        r"$1-a+e=\gamma(n_1+n_0)$ and $(n_1+n_0)s_1=1-e+\gamma n_0$. A stable wall has "
        r"$1+n_1\beta>0$ by \chapter{s4d_jury_explicit}, and $|n_0\beta|<1$ since $n_0\beta$ is "
        "the product of its roots:"
    )
    arm = {a: 1 + e - gamma * RISE}
    loss = {e: 1 - RISE * s_1 + gamma * n_0}
    first, second, third, minor = (
        f.subs(arm).subs(loss) for f in jury.criterion(jury.coefficients(0)).expressions
    )
    page.step(
        "The value of the polynomial at 1 grows with the stiffness",
        first,
        RISE * (alpha + gamma),
        name="p_1(1)",
    )
    page.step(
        "The second inequality holds for $\\beta>-s_1$",
        second,
        2 * RISE * (beta + s_1) + (n_1 - n_0) * (alpha + gamma),
        name=r"c_1(\alpha)",
        because=r"the left side is positive for $\alpha>-\gamma$ if $\beta>-s_1$",
    )
    page.step(
        "The third inequality decreases with the stiffness",
        diff(third, alpha),
        -(n_1 - n_0),
        name=r"\partial c_3/\partial\alpha",
    )
    page.step(
        "The minor falls with the stiffness",
        minor,
        RISE * (1 - n_0 * beta) * (beta + s_1) - n_0 * (1 + n_1 * beta) * (alpha + gamma),
        name=r"\Delta_2",
        because=r"the minor falls with $\alpha$, and is positive only for $\beta>-s_1$",
    )
    page.lemma(r"A device with $\omega_dT<\pi$ has $n_0\le n_1$", pushed()[2])
    page.say(
        r"So all four inequalities stay true while $\alpha$ falls, down to $-\gamma$. With one "
        "period of delay a wall can become unstable if the arm has a stiff spring, such as "
        r"$\gamma=5$ with $\delta=\frac12$, $\beta=-2.5$:"
    )
    stiff = {beta: -Rational(5, 2), gamma: S(5), delta: S.Half, d: S.One}
    page.lemma(
        r"With a stiff spring the wall with $\alpha=4$, $\beta=-2.5$ is stable with one period of "
        "delay",
        stable_at({**stiff, alpha: S(4)}),
    )
    page.lemma(
        r"With the stiff spring the wall with $\alpha=0$, $\beta=-2.5$ is not stable with one "
        "period of delay",
        unstable_at({**stiff, alpha: S.Zero}),
    )
    stated = claim()
    symbols, given, _ = taken_apart(stated)
    theorem = for_all(symbols, given, turned_down())
    page.lemma(
        r"Without delay a stable wall stays stable at any smaller stiffness above $-\gamma$",
        theorem,
        because="the four inequalities prove the statement on the whole range",
        boxed=True,
    )
    page.state(
        "undelayed-turned-down",
        rf"without delay and for ${IN_WIDE}$ a stable wall stays stable as its stiffness falls to "
        r"any value above $-\gamma$",
        claim=stated,
    )
    wall = {alpha: Rational(7, 10), beta: Rational(4, 5), x: Rational(1, 10)}
    arm = {gamma: S.Zero, delta: Rational(1, 50)}
    stable = stable_at({**arm, **wall, d: S.Zero})
    page.settle("undelayed-turned-down", theorem, example=(wall | arm, stable))


# Without delay and with a soft spring, a stable wall stays stable as its stiffness falls.

WIDE = {gamma: (S.Zero, Rational(1, 100)), delta: (S.Zero, Rational(1, 10))}
FARTHEST = Rational(5, 2)
"""All stable walls have a virtual damping of at most this size, as 1 < 2.5 n_0."""

TOTAL = n_1 + n_0
"""The sum of the coefficients of the numerator."""


def claim() -> Proposition:
    """With gamma <= 0.01 and delta <= 0.1 a stable wall is stable at any stiffness above -gamma."""
    arm = [bound for s, (low, high) in WIDE.items() for bound in (s >= low, s <= high)]
    here = STABLE.at({d: S.Zero})
    given = [*arm, -gamma < x, x <= alpha, here]
    return ForAll((alpha, beta, gamma, delta, x), implied(given, here.at({alpha: x})))


@cache
def turned_down() -> Theorem:
    """The wall (x, beta) is stable if (alpha, beta) is stable and -gamma < x <= alpha."""
    *planes, minor = inequalities(0)
    low, high, inside = damping_between(0, WIDE, FARTHEST)
    toward = towards(planes, minor, inside, {**WIDE, beta: (-FARTHEST, FARTHEST)})
    first, second, less = pushed()
    total = positive(TOTAL > 0, [first], [second])
    above, fall = positive(x + gamma > 0, -gamma < x), positive(alpha - x >= 0, x <= alpha)
    there = positive(alpha + gamma > 0, [above], [fall])
    turn = combined(Relation(a, "=", 1 + e - gamma * TOTAL), [device_static(assume(DEVICE)), -1])
    # the minor is (n_1 + n_0) (1 - n_0 beta) (beta + s_1) - n_0 (1 + n_1 beta) (alpha + gamma)
    left = (1 - n_0 * beta) * (beta * TOTAL + 1 - e + gamma * n_0)
    product = combined(left > 0, [minor], [second, toward, there], [turn, n_0 * beta])
    push = over(beta * TOTAL + 1 - e + gamma * n_0 > 0, product, inside)
    push = closed(push, positive(Ne(1 - n_0 * beta, 0), [inside]))
    heavier = positive(n_1 - n_0 >= 0, [less])
    rows = (
        ([total, above], [turn, S.One]),
        ([2, push], [heavier, above], [turn, S.One]),
        ([planes[2]], [heavier, fall]),
        ([minor], [second, toward, fall]),
    )
    loop = inst(by_inequalities(0), {alpha: x})
    goals = conjuncts(loop.conclusion.of[1])
    shown = [combined(goal, *known) for goal, known in zip(goals, rows, strict=True)]
    return closed(of_every_plant(closed(mp(loop, conj(*shown)), low, high)), _slow())


def _slow() -> Theorem:
    """These arms have a damped frequency below the Nyquist frequency."""
    soft = WIDE[gamma][1]
    far = number(Relation(soft, "<", pi**2))
    return positive(
        gamma - delta**2 / 4 < pi**2, [gamma <= soft], [far], [Rational(1, 4), square(delta)]
    )
