"""On which side of the exact boundary does the line of the linear condition lie?

The paper says that the walls on the line above its crossing with the boundary are unstable. We ask
whether there is only one crossing, for every spring and damping of the ranges (23).
"""

from symhaptic.book.lemmas.line_crossing import one_crossing, room
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at, unstable_at
from symhaptic.model import jury, linear


def derive(page):
    page.say(
        r"A wall is stable if and only if Jury's inequalities hold (\chapter{s4d_jury_counted}). "
        r"On the line $\beta=(d+\frac12)\alpha-\delta$ each of them is a polynomial in $\alpha$. "
        "The last inequality, which contains the largest minor, fails first. Let "
        r"$g=s_1-\delta-\frac\gamma2\ge0$ be the gap between the start of the boundary and the "
        "line. Without delay, this minor is a difference of two products:"
    )
    total = n_1 + n_0
    *_, minor = jury.criterion(jury.coefficients(0)).expressions
    arm = {a: 1 + e - gamma * total, e: 1 - total * s_1 + gamma * n_0}
    on_it = minor.subs(beta, alpha / 2 - delta).subs(a, arm[a]).subs(e, arm[e])
    wall = alpha / 2 - delta
    page.step(
        "On the line the minor is a difference of two products",
        on_it,
        total * (1 - n_0 * wall) * ((alpha + gamma) / 2 + linear.GAP)
        - n_0 * (1 + n_1 * wall) * (alpha + gamma),
        name=r"\Delta_2",
        because=r"at the start of the line, $\alpha=-\gamma$, only the first term remains, which "
        r"is "
        "not negative",
    )
    page.step(
        "The minor is concave on the line",
        on_it.expand().coeff(alpha, 2),
        -n_0 * (n_0 + 3 * n_1) / 4,
        name=r"\tfrac12\,\Delta_2''(\alpha)",
    )
    page.lemma(
        "The gap of an arm is not negative",
        room(),
        because="the product $g(n_1+n_0)$ is not negative on all of (23)",
    )
    page.say(
        r"The minor is not negative at the start of the line, $\alpha=-\gamma$. Since it is "
        "concave and positive for a stable wall on the line, it is positive for all walls on the "
        r"line with smaller $\alpha$. The other inequalities without delay are linear on the "
        "line. With one period of delay the minor is a cubic. Ball arithmetic shows that this "
        r"cubic is concave up to $\alpha=0.16$; no stiffer wall is stable. So the stable walls on "
        "the line end at one wall. At this wall the line crosses the boundary, and it does so "
        "only once:"
    )
    theorem = as_claimed(page.claim("s4e-unstable-side"), one_crossing())
    page.lemma(
        "If a wall on the line is stable, every less stiff wall on the line is stable",
        theorem,
        because="the statement holds for $d=0$ and $d=1$ on all of (23)",
        boxed=True,
    )
    witnesses(page)
    page.settle(
        "s4e-unstable-side",
        theorem,
        example={gamma: S.Zero, delta: S.Zero, x: S.One, alpha: S(2)},
        note="the statement holds for $d=0$ and $d=1$ on all of (23). Without damping the "
        r"crossing is the origin, and all walls on the line with $\alpha>0$ are unstable",
    )


def witnesses(page):
    """For each delay, one wall of the line below the crossing and one above it."""
    arm = {gamma: Rational(1, 1000), delta: Rational(1, 50)}
    for delay, low, high in ((0, Rational(4, 100), Rational(6, 100)), (1, S(1) / 100, S(2) / 100)):
        sides = (stable_at, "stable", low), (unstable_at, "not stable", high)
        for shown, word, stiffness in sides:
            damping = linear.on_the_line(stiffness, delay).subs(arm)
            at = {alpha: stiffness, beta: damping, d: S(delay), **arm}
            where = f"For $d={delay}$, $\\gamma=0.001$, $\\delta=0.02$"
            wall = f"the wall $({float(stiffness):g},{float(damping):g})$"
            page.lemma(f"{where} {wall} of the line is {word}", shown(at))
