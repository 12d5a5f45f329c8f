r"""Where on the boundary is the stiffest wall?

The explicit boundary turns back after its first tip and is stiffer again at higher angles. At its
tip the zeros of the loop show that no stable wall, wherever it lies, is stiffer. The same argument
makes every tangent of the upper boundary a bound of the stable walls.
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.tangent import all_tangents, all_tips, tangents, tips
from symhaptic.bounds.walls import DEVICE
from symhaptic.model import boundary

PLANT, FORCE = DEVICE.denominator, DEVICE.numerator
WALL = (alpha + beta) * z - beta


def derive(page):
    boundary_in_angles(page)
    page.say(
        "Let all $d+3$ zeros of the polynomial $p=z^{d+1}A+NW$ lie inside the unit circle. Each "
        "zero $a$ adds $z/(z-a)$ to $zp'/p$, and the real part of this is more than $\\tfrac12$ "
        "for $|z|=1$. So $2\\Re(\\bar pzp')>(d+3)|p|^2$ everywhere on the circle."
    )
    page.say(
        "Take the wall $(\\alpha_1,\\beta_1)$ of the boundary that puts a zero at "
        "$z=e^{j\\theta}$, and let $(x,y)$ be the derivative of the boundary with respect to "
        "$\\theta$ there. For the wall $(\\alpha_1+u,\\beta_1+v)$ the polynomial is "
        "$q=N(uz+v(z-1))$ at this $z$, and $zp'$ is $jN(xz+y(z-1))+zq'$. The inequality becomes"
    )
    turn = exp(I * theta)
    way, rest = x * turn + y * (turn - 1), u * turn + v * (turn - 1)
    mirrored = {I: -I}
    page.step(
        "Of the linear part the tangent of the boundary is left",
        I * way * rest.xreplace(mirrored) - I * way.xreplace(mirrored) * rest,
        -2 * sin(theta) * (u * y - v * x),
        name=r"2\Re\bigl(j(xz+y(z-1))\,\overline{(uz+v(z-1))}\bigr)",
        because="times $|N|^2$; the rest is the quadratic form $2\\Re(\\bar qzq')-(d+3)|q|^2$",
    )
    page.say(
        "The form is negative definite where $\\bigl(d+1-(n_1^2-n_0^2)/|N|^2\\bigr)\\sin\\theta>1$,"
        " for a whole $d$ from about $(d+1)\\theta=1$ on. There $uy-vx<0$ is left for every stable "
        "wall: the stable walls lie on one side of the tangent."
    )
    for id, says, claim, found in (
        (
            "boundary-tangents",
            "behind a whole delay all stable walls lie on one side of each tangent of the "
            "boundary at an angle with $\\bigl(d+1-(n_1^2-n_0^2)/|N|^2\\bigr)\\sin\\theta>1$",
            tangents(),
            all_tangents(),
        ),
        (
            "stiffest-wall",
            "behind a whole delay no stable wall is as stiff as the boundary at such an angle at "
            "which $d\\alpha/d\\theta=0$ and $d\\beta/d\\theta>0$",
            tips(),
            all_tips(),
        ),
    ):
        page.state(id, says, claim=claim)
        page.settle(id, found, example=example({d: S.One}, [whole(d)], fact(whole(S.One))))
    page.say(
        "The theorem holds for every device, with or without spring and damper. It says that the "
        "stable walls end at the tip at the latest. That walls just below the tip are stable is "
        "not shown in general. It is shown in numbers where a chapter needs it, by balls around "
        "the zeros of one wall (\\chapter{s5b_stiffest_wall_numbers}), and without delay in closed "
        "form (\\chapter{s5b_stiffest_undelayed})."
    )


def boundary_in_angles(page):
    """The boundary by the angle of the device with its delay."""
    page.say(
        "Let $A=z^2-az+e$, $N=n_1z+n_0$ and $W=(\\alpha+\\beta)z-\\beta$. Turned back by half a "
        "period, the wall has the real part $\\alpha\\cos\\frac\\theta2$ on the circle:"
    )
    page.step(
        "Half a period earlier the wall has its stiffness in the real part",
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
    page.define("The plant with its delay, turned by half a period", turned, force)
    page.define("Its mirror image in the real axis", mirrored, force.xreplace({I: -I}))
    page.step(
        "The stiffness on the boundary is a real part",
        boundary.wall(DEVICE)[0],
        -(turned + mirrored) / (2 * cos(theta / 2)),
        name=r"\alpha(\theta)",
        because="so that it is $-R\\cos\\chi$ with $R=|A|/(|N|\\cos\\frac\\theta2)$: positive only "
        "for $\\tfrac\\pi2<\\chi<\\tfrac{3\\pi}2$, as far as $\\chi<\\tfrac{5\\pi}2$",
    )
    page.define("The angle enters by the tangent of its half", tau, tan(theta / 2))
    page.define("and by the angle that the delay and a period turn", phi, (d + 1) * theta)
    cosine = (n_1 + n_0) * cos(phi) + (n_1 - n_0) * tau * sin(phi)
    page.define("A cosine of the numerator and of this angle", over, cosine)
    sine = (n_1 + n_0) * sin(phi) - (n_1 - n_0) * tau * cos(phi)
    page.define("A sine of the numerator and of this angle", beside, sine)
    page.step(
        "The stiffness on the boundary is a quotient of real numbers",
        boundary.wall(DEVICE)[0],
        (((1 + a + e) * tau**2 - (1 - a + e)) * over + 2 * (1 - e) * tau * beside)
        / ((n_1 + n_0) ** 2 + (n_1 - n_0) ** 2 * tau**2),
        name=r"\alpha(\theta)",
    )
