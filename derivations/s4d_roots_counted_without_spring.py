"""When is a device without a spring stable with an integer delay?

The argument principle counts roots at up to two angles at which plant and wall have the same size.
Without a spring, one angle is sufficient: a quadratic and a comparison of angles decide the
stability.
"""

from symhaptic.book.lemmas.prelude import *


def derive(page):
    page.say(
        "Without a spring the plant has a pole at 1, so $a=1+e$, and $A=(z-1)(z-e)$ vanishes "
        r"there. We compare the sizes of plant and wall as in \chapter{s4d_roots_counted}:"
    )
    page.define("The number $y$ is the square of the chord from $z$ to 1", y, 2 - z - 1 / z)
    bottom, top = z**2 - a * z + e, (n_1 * z + n_0) * ((alpha + beta) * z - beta)
    sizes = [(x * x.subs(z, 1 / z)).subs(a, 1 + e) for x in (bottom, top)]
    page.step(
        "The surplus $|A|^2-|NW|^2$ of the plant is a quadratic",
        sizes[0] - sizes[1],
        surplus(),
        name="F(y)",
    )
    lead = -((alpha * (n_1 + n_0)) ** 2)
    page.step("At $z=1$ the wall dominates", surplus(S.Zero), lead, name="F(0)")
    page.step(
        "At $z=-1$ the terms of plant and wall are real",
        surplus(4),
        (2 * (1 + e)) ** 2 - ((n_1 - n_0) * (alpha + 2 * beta)) ** 2,
        name="F(4)",
    )
    bend = surplus().diff(y, 2) / 2
    page.step(
        "The curvature of the quadratic is bounded by its value at $z=1$",
        16 * bend - surplus(S.Zero),
        ((n_1 - n_0) * alpha) ** 2 + 4 * n_1 * n_0 * (alpha + 2 * beta) ** 2 + 16 * e,
        name=r"8F''-F(0)",
    )
    found = page.lemma(
        "A wall that is as large as the plant at $z=-1$ is larger at all other angles",
        stronger_everywhere(),
        because=r"the quadratic is $F(y)=(1-\tfrac y4)F(0)+\tfrac y4F(4)-\tfrac12F''y(4-y)$, and "
        "if $F''<0$, the previous step bounds $F''$",
        boxed=True,
    )
    page.state(
        "free-wall-stronger",
        "without a spring a wall that is as large as the plant at $z=-1$ is larger on the whole "
        "circle between $z=1$ and $z=-1$",
        claim=stronger(),
    )
    point = {alpha: S.One, beta: S.One, n_1: Rational(1, 2), n_0: Rational(1, 2), e: S.One}
    page.settle("free-wall-stronger", found, example=point)
    page.say(
        "For such a wall, $g=NW$ determines the argument of $p_1$ on the whole half circle. At "
        "most two of the $d+3$ roots then lie inside: the loop is not stable. Any other wall "
        r"with $\alpha\ne0$ has $F(0)<0<F(4)$, and one angle $\theta_1$ at which plant and wall "
        r"have the same size. In a stable loop $p_1(1)=\alpha(n_1+n_0)>0$, so $\arg g(1)=0$ "
        r"and $\theta=0$ adds nothing to the count of \chapter{s4d_roots_counted}. Only "
        r"$\theta_1$ counts: the number of roots outside is twice the integer nearest to "
        r"$-\Phi(\theta_1)/(2\pi)$. This number is not negative, so the loop is stable if and "
        r"only if $\alpha>0$, $2(1+e)>|(n_1-n_0)(\alpha+2\beta)|$ and $\Phi(\theta_1)>-\pi$. The "
        r"argument of $A/z$ is $\pi$ minus an angle that is small for small $\theta_1$. If the "
        "wall has little stiffness, the last condition therefore compares small angles:"
    )
    turned = on_circle(bottom.subs(a, 1 + e) / z)
    page.step(
        "The real part of $A/z$ is negative",
        (turned + turned.xreplace({I: -I})) / 2,
        -(1 + e) * (1 - cos(theta)),
        name=r"\Re\frac Az",
        because=r"the real part is $-\tfrac12(1+e)y$, and the imaginary part is $(1-e)\sin\theta$",
    )


# A device without a spring: at which angles the wall or the plant is larger.

y = symbols("y")
WALL = alpha, beta, n_1, n_0, e
GIVEN = tuple(map(proposition, (n_1 > 0, n_0 > 0, e > 0)))


def surplus(at: Expr = y) -> Expr:
    """abs(A)^2 - abs(N)^2 abs(W)^2 at y = 4 sin^2(theta/2), for a - e = 1."""
    device = (1 - e) ** 2 * at + e * at**2
    moved = (n_1 + n_0) ** 2 - n_1 * n_0 * at
    return device - moved * (alpha**2 + (alpha + beta) * beta * at)


STRONG = proposition(surplus(4) <= 0)
"""At z = -1 the wall is at least as large as the plant."""


def stronger() -> Proposition:
    """A wall that is as large as the plant at z = -1 is larger at all other angles."""
    inside = (y > 0, y < 4)
    return ForAll(WALL, implied(GIVEN, ForAll((y,), implied([STRONG, *inside], surplus() < 0))))


@cache
def stronger_everywhere() -> Theorem:
    """The surplus is negative, because a chord and its value at z = 1 bound it from above."""
    left = positive(4 - y > 0, y < 4)
    there = square((n_1 + n_0) * alpha)
    apart, far = square((n_1 - n_0) * alpha), square(alpha + 2 * beta)
    sixteenth = Rational(1, 16)
    found = positive(
        surplus() < 0,
        [Rational(1, 4), y > 0, STRONG],
        [sixteenth, left, left, there],
        [sixteenth, y > 0, left, apart],
        [4 * sixteenth, y > 0, left, n_1 > 0, n_0 > 0, far],
        [y > 0, left, e > 0],
    )
    return for_all(WALL, GIVEN, for_all([y], [STRONG, y > 0, y < 4], found))
