"""For which walls is the linear condition safe?

The line of (25) crosses the boundary once. The stiffer walls on the line are unstable, and the
less stiff ones are stable. For the arms of (23), we ask whether every wall that satisfies (25) and
has at most the damping of the crossing is stable.
"""

from symhaptic.book.lemmas.line_crossing import below_the_crossing
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import stable_at
from symhaptic.paper.propositions.linear import safe


def derive(page):
    flat, rise = 6 * (d + 1) ** 2 + 1, (d + 1) * (2 * d + 1) * (2 * d + 3)
    page.step(
        r"For short periods, the damping $\beta_\times$ of the crossing is a multiple of $\delta$",
        (d + Rational(1, 2)) * flat * delta / rise - delta,
        (2 * d**2 + 2 * d + 1) * delta / (2 * (d + 1) * (2 * d + 3)),
        name=r"\beta_\times",
        because=r"the line and the stiffness $\alpha_\times$ of \chapter{s4e_line} give the "
        r"damping $\beta_\times$ of the crossing: a sixth of $\delta$ for $d=0$, a quarter for "
        "$d=1$, and nearly half for long delays",
    )
    page.say(
        r"The walls that satisfy (25), $\alpha>-\gamma$ and $\beta\le\beta_\times$ form a "
        "triangle. For each wall in the triangle, the line has a stiffer wall with the same "
        "damping. This wall is at most as stiff as the crossing, so it is stable. With less "
        "stiffness the largest of Jury's minors is larger, and the other inequalities hold in "
        "the whole triangle."
    )
    claim = safe()
    theorem = as_claimed(claim, below_the_crossing())
    page.lemma(
        "If a wall on the line is stable, every wall with (25) and at most its damping is stable",
        theorem,
        because="the statement holds for $d=0$ and $d=1$ on all of (23)",
        boxed=True,
    )
    page.state(
        "linear-safe",
        "inside (23), for $d=0$ and $d=1$, a wall is stable if it satisfies (25) and "
        r"$\alpha>-\gamma$ and has at most the damping of a stable wall on the line",
        claim=claim,
    )
    arm = {gamma: Rational(1, 1000), delta: Rational(1, 50)}
    wall = {alpha: Rational(1, 100), beta: -Rational(5, 1000), x: Rational(1, 100)}
    late = {**arm, alpha: wall[x], beta: Rational(3, 2) * wall[x] - arm[delta], d: S.One}
    page.lemma(
        r"With one period of delay the wall $\alpha=0.01$ on the line is stable", stable_at(late)
    )
    page.settle(
        "linear-safe",
        theorem,
        example=arm | wall,
        note=r"the statement holds for walls up to the damping $\beta_\times$ of the only "
        "crossing",
    )
