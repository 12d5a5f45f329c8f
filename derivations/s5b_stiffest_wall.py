"""Which wall on the boundary bounds the stable stiffness?

The stiffness on the explicit boundary has a first maximum, but at larger angles it becomes larger
again. We show from the poles of the loop that no stable wall is stiffer than the first maximum. By
the same argument every tangent of the upper boundary bounds the stable walls.
"""

from symhaptic.book.lemmas.outpaced import ROOM, room
from symhaptic.book.lemmas.prelude import *
from symhaptic.bounds import walls
from symhaptic.paper.propositions.plots import BESIDE
from symhaptic.paper.propositions.stability import SQUARE

PLANT, FORCE = walls.DEVICE.denominator, walls.DEVICE.numerator
WALL = (alpha + beta) * z - beta


def derive(page):
    boundary_in_angles(page)
    page.say(
        "Let all $d+3$ zeros of the polynomial $p=z^{d+1}A+NW$ lie inside the unit circle. Each "
        "zero $a$ adds $z/(z-a)$ to $zp'/p$. For $|z|=1$ the real part of this term is more than "
        r"$\tfrac12$. So $2\Re(\bar pzp')>(d+3)|p|^2$ everywhere on the circle."
    )
    page.say(
        r"Let $(\alpha_1,\beta_1)$ be the wall on the boundary for which $p$ has a zero at "
        r"$z=e^{j\theta}$. Let $(x,y)$ be the derivative of the boundary with respect to $\theta$ "
        r"at this wall. For the wall $(\alpha_1+u,\beta_1+v)$ the polynomial is $q=N(uz+v(z-1))$ "
        "at this $z$, and $zp'$ is $jN(xz+y(z-1))+zq'$. At $z$ the inequality has a linear and a "
        "quadratic part:"
    )
    turn = exp(I * theta)
    way, rest = x * turn + y * (turn - 1), u * turn + v * (turn - 1)
    mirrored = {I: -I}
    page.step(
        "The linear part is the tangent of the boundary",
        I * way * rest.xreplace(mirrored) - I * way.xreplace(mirrored) * rest,
        -2 * sin(theta) * (u * y - v * x),
        name=r"2\Re\bigl(j(xz+y(z-1))\,\overline{(uz+v(z-1))}\bigr)",
        because="the linear part of the inequality is this number times $|N|^2$; the rest is the "
        r"quadratic form $2\Re(\bar qzq')-(d+3)|q|^2$",
    )
    page.say(
        "For an integer $d$, the quadratic part is negative definite if "
        r"$\bigl(d+1-(n_1^2-n_0^2)/|N|^2\bigr)\sin\theta>1$, that is, for $(d+1)\theta$ above "
        "about 1. At these angles $uy-vx<0$ for every stable wall: the stable walls lie on one "
        "side of the tangent."
    )
    for id, says, claim, found in (
        (
            "boundary-tangents",
            "with an integer delay all stable walls lie on one side of each tangent of the "
            r"boundary at an angle with $\bigl(d+1-(n_1^2-n_0^2)/|N|^2\bigr)\sin\theta>1$",
            tangents(),
            all_tangents(),
        ),
        (
            "stiffest-wall",
            "with an integer delay no stable wall is as stiff as the boundary at such an angle "
            r"if also $d\alpha/d\theta=0$ and $d\beta/d\theta>0$",
            tips(),
            all_tips(),
        ),
    ):
        page.state(id, says, claim=claim)
        page.settle(id, found, example=({d: S.One}, fact(whole(S.One))))
    page.say(
        "The theorem holds for every device, with or without spring and damper. It bounds the "
        "stable stiffness by that of the tip, the first maximum. It does not show that walls "
        "just below the tip are stable. Other chapters prove that such a wall is stable: by ball "
        "arithmetic around the zeros of the characteristic polynomial "
        r"(\chapter{s5b_stiffest_wall_numbers}) and, without delay, in closed form "
        r"(\chapter{s5b_stiffest_undelayed})."
    )


def boundary_in_angles(page):
    """The boundary in terms of the angle of the device with its delay."""
    page.say(
        r"Let $A=z^2-az+e$, $N=n_1z+n_0$ and $W=(\alpha+\beta)z-\beta$. On the circle the wall, "
        r"multiplied by $z^{-1/2}$, has the real part $\alpha\cos\frac\theta2$:"
    )
    page.step(
        "The real part of $z^{-1/2}W$ contains the stiffness only",
        on_circle(WALL) * exp(-I * theta / 2),
        alpha * cos(theta / 2) + I * (alpha + 2 * beta) * sin(theta / 2),
        name=r"z^{-1/2}W",
    )
    page.say(
        "A zero at $z$ means $z^{-1/2}W=-f$ with $f=z^{d+1/2}A/N$. Let $\\chi$ be the angle of "
        "$f$. The explicit boundary is the real part of this equation:"
    )
    force = on_circle(PLANT / FORCE) * exp(I * (d + Rational(1, 2)) * theta)
    turned, mirrored = (Function(name)(theta) for name in ("f", r"\overline{f}"))
    over, beside = symbols("C S")
    page.define("The function $f$ is the plant with its delay, times $z^{1/2}$", turned, force)
    page.define(
        r"The function $\bar f$ is its mirror image in the real axis",
        mirrored,
        force.xreplace({I: -I}),
    )
    page.step(
        "The stiffness on the boundary is a real part",
        boundary.wall(walls.DEVICE)[0],
        -(turned + mirrored) / (2 * cos(theta / 2)),
        name=r"\alpha(\theta)",
        because=r"the stiffness is $-R\cos\chi$ with $R=|A|/(|N|\cos\frac\theta2)$; for "
        r"$\chi<\tfrac{5\pi}2$ it is positive only for $\tfrac\pi2<\chi<\tfrac{3\pi}2$",
    )
    page.define(r"The parameter of the boundary is $\tau=\tan(\theta/2)$", tau, tan(theta / 2))
    page.define(r"The angle $\varphi$ belongs to the delay plus one period", phi, (d + 1) * theta)
    cosine = (n_1 + n_0) * cos(phi) + (n_1 - n_0) * tau * sin(phi)
    page.define("One term is a cosine of the numerator and of this angle", over, cosine)
    sine = (n_1 + n_0) * sin(phi) - (n_1 - n_0) * tau * cos(phi)
    page.define("Another term is a sine of the numerator and of this angle", beside, sine)
    page.step(
        "The stiffness on the boundary is a quotient of real numbers",
        boundary.wall(walls.DEVICE)[0],
        (((1 + a + e) * tau**2 - (1 - a + e)) * over + 2 * (1 - e) * tau * beside)
        / ((n_1 + n_0) ** 2 + (n_1 - n_0) ** 2 * tau**2),
        name=r"\alpha(\theta)",
    )


# With an integer delay all stable walls lie on one side of each tangent of the boundary.
#
# If p has its zeros inside, n |p|^2 < 2 Re conj(p) z p' on the circle (``outpaces``).  Expand both
# sides around the wall of the boundary for which p has a zero at exp(j theta).  At this zero z p'
# is j N times the velocity of the boundary.  The equation of the tangent and a quadratic form are
# left.  The form is negative definite for 1 < (d + 1 - (n1^2 - n0^2)/|N|^2) sin(theta), that is,
# from about (d + 1) theta = 1 on.

TURN = exp(I * theta)
TOP = n_1 * TURN + n_0
LATE = exp(I * (d + 1) * theta)


def _value(wall: tuple[Expr, Expr]) -> Expr:
    """The value of p at exp(j theta)."""
    stiff, damp = wall
    return LATE * (TURN**2 - a * TURN + e) + TOP * ((stiff + damp) * TURN - damp)


def _speed(wall: tuple[Expr, Expr]) -> Expr:
    """The value of z p' at exp(j theta)."""
    stiff, damp = wall
    plant = LATE * ((d + 3) * TURN**2 - (d + 2) * a * TURN + (d + 1) * e)
    push = n_1 * TURN * ((stiff + damp) * TURN - damp) + TOP * (stiff + damp) * TURN
    return plant + push


ROOT = Relation(_value(BESIDE), "=", S.Zero)
"""With the wall (alpha_1, beta_1), p has a zero at exp(j theta)."""
MOVES = Relation(I * _speed(BESIDE) + TOP * (x * TURN + y * (TURN - 1)), "=", S.Zero)
"""The derivative of the boundary with respect to theta at this wall is (x, y)."""
WEIGHT = (d + 1) * SQUARE - (n_1**2 - n_0**2)
STEEP = Relation(SQUARE, "<", WEIGHT * sin(theta))
"""The angle is large enough for the quadratic form to be negative definite."""
ANGLE = (proposition(theta > 0), proposition(theta < pi))
SIDE = (alpha - BESIDE[0]) * y - (beta - BESIDE[1]) * x


@cache
def on_one_side() -> Theorem:
    """(alpha - alpha_1) y - (beta - beta_1) x < 0 for every stable wall."""
    right, up = alpha - BESIDE[0], beta - BESIDE[1]
    total, weight = right + up, WEIGHT + SQUARE
    size = combined(SQUARE >= 0, [square(n_1 + n_0 * cos(theta))], [square(n_0 * sin(theta))])
    wave, steep = sign_of(sin, theta), assume(STEEP)
    heavy = positive(WEIGHT * sin(theta) > 0, [steep], [size])
    first = over(WEIGHT > 0, heavy, wave)
    more = positive(weight > 0, [first], [size])
    room_ = room()
    away = assume(Relation(S.Zero, "<=", SIDE))
    root, moves = assume(ROOT), assume(MOVES)
    rest = TOP * (right * TURN + up * (TURN - 1))
    rise = n_1 * TURN * (right * TURN + up * (TURN - 1)) + TOP * total * TURN
    speed = _speed(BESIDE) + rise - (d + 3) * rest
    less = combined(
        Relation(weight * ROOM, "<=", S.Zero),
        [2, size, more, wave, away],
        [square(weight * up - WEIGHT * cos(theta) * total)],
        [steep, positive(WEIGHT * sin(theta) + SQUARE > 0, [heavy], [size]), square(total)],
        [root, weight * (mirror(speed) - (d + 3) * mirror(_value(BESIDE)))],
        [mirrored(root), weight * speed],
        [moves, -weight * I * mirror(rest)],
        [mirrored(moves), weight * I * rest],
    )
    contrary = not_intro(positive(weight * ROOM > 0, [more, room_]), less)
    wanted = Relation(SIDE, "<", S.Zero)
    found = disj_cases(ordered(SIDE, S.Zero), assume(wanted), contr(contrary, wanted))
    return closed(found, positive(Ne(sin(theta), 0), [wave]))


def tangents() -> Proposition:
    """For an integer d, every stable wall lies on one side of the tangent at each steep angle."""
    given = [*ANGLE, ROOT, MOVES, STEEP, STABLE]
    walls = (theta, *BESIDE, x, y, alpha, beta)
    every_ = ForAll(walls, implied(given, Relation(SIDE, "<", S.Zero)))
    return _of_plants(every_)


def tips() -> Proposition:
    """No stable wall is as stiff as the boundary at an angle at which its stiffness is stationary.

    This is for an integer d, and for each steep angle at which the damping of the boundary rises.
    """
    given = [*ANGLE, ROOT, MOVES.at({x: S.Zero}), y > 0, STEEP, STABLE]
    walls = (theta, *BESIDE, y, alpha, beta)
    return _of_plants(ForAll(walls, implied(given, alpha < BESIDE[0])))


def _of_plants(then: Proposition) -> Proposition:
    plants = ForAll((gamma, delta, *NUMBERS), implied([DEVICE], then))
    return ForAll((d,), implied([whole(d)], plants))


def _for_plants(theorem: Theorem) -> Theorem:
    plants = for_all((gamma, delta, *NUMBERS), [DEVICE], add_assum(theorem, DEVICE))
    return for_all((d,), [whole(d)], add_assum(plants, whole(d)))


@cache
def all_tangents() -> Theorem:
    """:func:`tangents`."""
    return _for_plants(as_claimed(_inner(tangents()), on_one_side()))


@cache
def all_tips() -> Theorem:
    """:func:`tips`."""
    side, rise = inst(on_one_side(), {x: S.Zero}), assume(y > 0)
    below = over(BESIDE[0] - alpha > 0, positive((BESIDE[0] - alpha) * y > 0, [side]), rise)
    found = closed(positive(alpha < BESIDE[0], [below]), positive(Ne(y, 0), [rise]))
    return _for_plants(as_claimed(_inner(tips()), found))


def _inner(claim: Proposition) -> Proposition:
    """The claim for one plant."""
    return taken_apart(taken_apart(claim)[2])[2]
