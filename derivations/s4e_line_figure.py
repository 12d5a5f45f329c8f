r"""Where on the boundary is the error of the linear condition 0, 2 or 5 per cent?

Fig. 10 of the paper marks points with these errors for $\gamma=0.001$, five dampings and two
delays. On each boundary the points with one error are zeros of a polynomial of degree two or three
in $y=4\sin^2\frac\theta2$. Ball arithmetic encloses all of these zeros.
"""

from flint import arb

from symhaptic.book.figures.linear import DAMPINGS, DELAYS, GAMMA, LEVELS, marks
from symhaptic.book.figures.linear import linear as draw
from symhaptic.book.lemmas.figure10 import drawn
from symhaptic.book.lemmas.prelude import *
from symhaptic.bounds.linear_points import Arc, apart
from symhaptic.model import linear
from symhaptic.proof.roots import rounded


def derive(page):
    page.say(
        r"The error has the value $\varepsilon$ where "
        r"$\Delta-\varepsilon\,(d+\frac12)(\alpha+\gamma)$ vanishes. Multiplied by $|M|^2$ this "
        "expression is a polynomial in $y$ of degree $d+2$. Its coefficients depend on the "
        r"parameters $\nu$, $s_1$ and $s_2$ of the arm. Flint encloses each of its roots in a "
        r"ball, and the roots of $\alpha+\gamma$ in the same way. The first root of "
        r"$\alpha+\gamma$ is the end of the arc. The tables list every root on the arc with its "
        r"angle $\theta=2\arcsin\frac{\sqrt y}2$. So the ten boundaries have these errors at no "
        "other point."
    )
    for delay in DELAYS:
        page.same("a root at z", *wall(delay))
    undamped = {delta: 0, s_1: gamma / 2, nu: S.Half, linear.CHORD: 0}
    page.same("no gap", *(linear.arc(n).above.subs(undamped) for n in DELAYS), S.Zero)
    page.say(
        "Without damping there is no gap. We then divide by the factor $y$, and the boundary "
        "crosses the line at the origin. With damping the error is unbounded towards the start; "
        r"the marks of $-2\,\%$ and $-5\,\%$ with $\alpha<0$ lie so close to the corner at "
        r"$\alpha=-0.001$ that the figure cannot show them."
    )
    for delay in DELAYS:
        rows = [
            (1000 * damping, 100 * level, *map(digits, point))
            for damping in DAMPINGS
            for level, point in marks(delay, damping)
        ]
        page.table(
            rf"All points for $d={delay}$, $\gamma=0.001$; $\varepsilon$ in per cent, the other "
            "columns in thousandths, correctly rounded.",
            ("$\\delta$", "$\\varepsilon$", "$\\theta$", "$\\alpha$", "$\\beta$"),
            rows,
        )
    page.figure(
        "fig10",
        "Fig. 10 of the paper: exact boundaries (solid) and lines of (25) (dashed) for "
        r"$\gamma=0.001$. The marks are points with errors of 0, 2 and 5\,\% and $\alpha\ge0$.",
        draw,
        panels=(2, 1),
        height=1.1,
    )
    for delay in DELAYS:
        for damping in DAMPINGS:
            counted(page, delay, damping)
    page.say(
        "The theorem is weaker than the tables. For each mark, it shows that some wall on the "
        "boundary, at an angle near that of the mark, has the error of the mark to within a "
        r"hundredth of a percent. The walls on the curves have a zero at $e^{j\theta}$ and are "
        r"not stable, and stable walls lie right of $\alpha=-\gamma$."
    )
    page.settle(
        "fig10",
        drawn(),
        note=r"for all $\delta>0$, errors of $-2$ and $-5\,\%$ also occur next to the corner",
    )


def counted(page, delay, damping):
    """On the arc no point except those of the table has one of these errors."""
    arc, zero = Arc(GAMMA, damping, delay), arb(0)
    shown = marks(delay, damping)
    for level in LEVELS:
        chords = [(2 * (p.theta / 2).sin()) ** 2 for at, p in shown if at == level]
        polynomial = arc.coefficients(apart(arc, level))
        page.all_zeros(f"{level}", polynomial, zero, arc.end, chords)


def wall(delay):
    """The two sides of the root condition: that of the wall and that of the plant."""
    arc, chord = linear.arc(delay), {linear.CHORD: 2 - z - 1 / z}
    stiffness = arc.right - gamma * arc.size
    turned = (stiffness + arc.up * (1 - 1 / z)).subs(chord)
    return turned, expand(-(z**delay) * linear.near() * arc.size.subs(chord))


def digits(ball):
    """Fifteen digits, or 0 if the ball contains it."""
    return "$0$" if ball.contains(0) else f"${rounded(ball, power=3)}$"
