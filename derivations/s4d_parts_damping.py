r"""Does more damping enlarge the stable region?

A wall that is stable stays so until a root reaches the unit circle. If, wherever a root can be on
the circle, more damping pulls it inwards, no stable wall is lost. Without delay and inside the
paper's ranges (23) this is one inequality in three variables.
"""

from sympy import Poly, Rational, S, diff, symbols

from symhaptic.book.lemmas.more_damped import (
    grown,
    grows,
    lost_by_a_damper,
    minor_rises,
    more_damped_is_stable,
)
from symhaptic.model import circle
from symhaptic.notation import alpha, beta, delta, gamma, z
from symhaptic.paper.propositions import CLAIMED
from symhaptic.paper.propositions.stability import HEAVIER, damping_can_destabilise
from symhaptic.paper.ranges import IN_23, RANGES
from symhaptic.proof import box
from symhaptic.proof.plants import AT_ONE, LATE, LOSS, NUMBERS, SLOPES, TOGETHER, named
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import weakened
from symhaptic.proof.theorems.tactics import example, for_all


def derive(page):
    y = symbols("y")
    e, n_1 = 1 - LOSS, TOGETHER - LATE
    bottom, top = z**2 - (1 + e - AT_ONE) * z + e, n_1 * z + LATE
    page.say(
        "Without delay $p_1=zA+NW$. Let $L=1-e$, $S=n_1+n_0$ and $q=1-a+e=\\gamma S$, and let a "
        "dash be the derivative with respect to $\\delta$. At a root on the circle $W=-zA/N$, so "
        "that $\\partial p_1/\\partial\\delta=z(A'-AN'/N)$, and $\\alpha+\\beta$ follows from the "
        "explicit boundary. The root $z=e^{\\sigma+j\\theta}$ moves inwards, "
        "$\\partial\\sigma/\\partial\\delta<0$, where $\\partial p_1/\\partial\\delta$ times the "
        "conjugate of $z\\,\\partial p_1/\\partial z$ has a positive real part. Times $|N|^4$ this "
        "is $y\\,G(y)$ with $y=4\\sin^2(\\theta/2)$."
    )

    def dash(expr):
        return sum(diff(expr, s) * slope for s, slope in zip(NUMBERS, SLOPES, strict=True))

    total = -circle.height(z * bottom * top.subs(circle.MIRRORED))  # (alpha + beta) |N|^2
    pulled = dash(bottom) * top - bottom * dash(top)
    turned = LATE * bottom + top * z * diff(bottom, z)
    speed = circle.square(top) * turned + top**2 * total
    inward = circle.real(pulled * speed.subs(circle.MIRRORED))
    pull = (circle.in_chord(inward, y) / y).expand()
    page.same("G in y", inward, (y * pull).subs(y, 2 - z - 1 / z))
    page.say(
        "$G$ has degree four; its coefficients are polynomials in $L$, $S$, $n_0$, $q$ and their "
        "derivatives, too long to print, found and compared with the definition by machine. For a "
        "free mass"
    )
    half, third = Rational(1, 2), Rational(1, 3)
    free = {LOSS: 0, TOGETHER: 1, LATE: half, AT_ONE: 0}
    free |= dict(zip(SLOPES, (1, -half, -third, 0), strict=True))
    page.step(
        "On a free mass the pull is a positive product",
        pull.subs(free),
        (6 - y) * (4 - y) * (y**2 - 4 * y + 8) / 96,
        name="G(y)",
        because="positive for $0\\le y<4$",
    )
    end = Rational(11, 5)
    page.positive(
        "Inside (23) the pull is positive",
        positive(pull, y, (0, end)),
        on=rf"0\le y\le\tfrac{{11}}5,\ {IN_23}",
        name="G(y)",
        because="the plant's numbers in balls, from the exponential of its matrix",
    )
    product = -bottom * top.subs(circle.MIRRORED)  # Q |N|^2
    stiffness = circle.real(product) - circle.height(product) * (2 - z - 1 / z) / 2
    left = circle.in_chord(-stiffness - gamma * circle.square(top), y)
    page.positive(
        "The rest of the curve is positive, too",
        positive(left, y, (end, 4)),
        on=rf"\tfrac{{11}}5\le y\le4,\ {IN_23}",
        name=r"-(\alpha+\gamma)|N|^2",
        because="there the boundary lies left of $\\alpha=-\\gamma$, where no wall is stable",
    )
    page.say(
        "A real root can reach 1 for $\\alpha=-\\gamma$ only, and $-1$ only for $\\alpha+2\\beta="
        "(1+a+e)/(n_1-n_0)$, far away: a stable wall has $|n_0\\beta|<1$ and "
        "$|a-n_1(\\alpha+\\beta)|<3$, product and sum of its roots. So a wall that is stable for "
        "one damping inside (23) is stable for every larger one. The left bound $\\alpha=-\\gamma$ "
        "stays where it is."
    )
    page.say(
        "As a theorem this needs no roots that move. The stable walls with $\\beta>-1$ are those "
        "right of $\\alpha=-\\gamma$ with a positive largest minor of Jury's, and the minor of a "
        "wall rises with the damping:"
    )
    page.lemma(
        "The minor of a wall is larger for the larger damper",
        minor_rises(),
        because="the devices' numbers are $n_1$ to $e$ and $n_1''$ to $e''$; the slope is "
        "positive, in balls from the exponential of the plant's matrix and its derivative",
    )
    page.lemma(
        "Inside (23) and without delay a stable wall stays stable with more damping",
        more_damped_is_stable(),
    )
    page.say(
        "Going from a stable wall in any direction, one keeps a positive minor as long as the "
        "walls are stable, so that at the end of the way it is not negative, and with the larger "
        "damper it is positive again. Only at $\\alpha=-\\gamma$ this does not help."
    )
    page.lemma(
        "Inside (23) and without delay a wall right of $\\alpha=-\\gamma$ at which stable walls "
        "end is stable with more damping",
        grows(),
        because="what holds at all walls on the way holds weakly in the limit",
    )
    symbols_, given, then = taken_apart(CLAIMED["s4d-delta-grows"](()))
    point = {alpha: S.One / 100, beta: S.One / 10, gamma: S.Zero}
    point |= {delta: Rational(1, 100), HEAVIER: Rational(1, 50)}
    page.settle(
        "s4d-delta-grows",
        for_all(symbols_, given, weakened(grown(then), *given)),
        example=example(point, given),
        note="with a delay nothing is shown here; a stiff spring makes it false "
        "(damping-destabilises)",
    )
    page.say(
        "For stiffer springs it is false: $\\gamma=5$, $\\alpha=-4$, $\\beta=5.9$ and no delay. "
        "With $\\delta=1.2$ this wall is stable, and with $1.5$ a root lies outside."
    )
    page.state(
        "damping-destabilises",
        "with a stiff spring, $\\gamma=5$, and without delay a wall is stable with a damper and "
        "unstable with a larger one",
        claim=damping_can_destabilise(),
    )
    page.settle(
        "damping-destabilises",
        lost_by_a_damper(),
        note="$\\alpha=-4$, $\\beta=5.9$, $\\delta=1.2$ and $1.5$",
    )


def positive(polynomial, y, interval):
    """A polynomial in y is positive inside (23) and on the interval."""
    rows = Poly(polynomial, y).all_coeffs()
    names = symbols(f"h:{len(rows)}")
    nested = S.Zero
    for name in names:
        nested = nested * y + name
    given = named(dict(zip(names, rows, strict=True)))
    return box.positive(nested, {**RANGES, y: interval}, given)
