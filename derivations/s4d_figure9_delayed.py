r"""Does an arm's spring show in the region with a delay?

Fig. 9 of the paper draws the stable walls for $d=1$ and $d=2$ at the limits of the arm's spring and
damping. The spring moves the left bound by $\gamma\le0.001$, as it does without delay, but the
region around it is smaller. How much?
"""

from sympy import Rational, S, cancel, cos, pi, sin

from symhaptic.book.figures.stability import delayed
from symhaptic.book.lemmas.enclosed import enclosed_walls_are_stable
from symhaptic.book.lemmas.figure9 import drawn, right_of_the_line
from symhaptic.model import plant
from symhaptic.model.passivity import on_circle
from symhaptic.notation import a, alpha, beta, d, e, gamma, n_0, n_1, theta, z
from symhaptic.paper.ranges import DAMPED, STIFF
from symhaptic.proof.box import positive


def derive(page):
    polynomial = (z**2 - a * z + e) * z ** (d + 1) + (n_1 * z + n_0) * ((alpha + beta) * z - beta)
    terms = {2: n_0, 1: n_1 - a * n_0, 0: e * n_0 - a * n_1, -1: e * n_1}
    size = n_1**2 + n_0**2 + 2 * n_1 * n_0 * cos(theta)
    half = S.Half
    along = -sum(c * cos((d + k + half) * theta) for k, c in terms.items())
    across = -sum(c * sin((d + k) * theta) for k, c in terms.items())
    on_it = {alpha: along / (cos(theta / 2) * size), beta: across / (sin(theta) * size)}
    root = page.same("a root", on_circle(polynomial).subs(on_it), S.Zero)
    page.say(
        "Multiplied by the conjugate of the numerator, the explicit boundary needs four terms, for "
        "every delay. With $|N|^2=n_1^2+n_0^2+2n_1n_0\\cos\\theta$:"
    )
    page.show(
        "The delayed boundary has this stiffness", r"\alpha|N|^2\cos\tfrac{\theta}{2}", along, root
    )
    page.show("The delayed boundary has this damping", r"\beta|N|^2\sin\theta", across, root)
    page.say(
        "Take the angles $0\\le\\theta\\le\\pi/(d+1)$. On all of these, with the damping "
        "$\\delta=0.02$ that makes the regions largest:"
    )
    for late, bound in ((1, Rational(17, 100)), (2, Rational(8, 100))):
        for gam in (S.Zero, STIFF):
            device = plant.numbers(gam, DAMPED)
            slack = (bound * size * cos(theta / 2) - along).subs({d: late, **device})
            page.positive(
                f"No wall of the curve is wider for $d={late}$",
                positive(slack, {theta: (S.Zero, pi / (late + 1))}),
                rf"\gamma={float(gam):g}",
                name=rf"{float(bound):g}-\alpha",
            )
    page.say(
        "So the spring's $0.001$ is more than $1/170$ of the width for $d=1$ and more than $1/80$ "
        "for $d=2$, after $1/690$ without delay. Does the region reach the line "
        "$\\alpha=-\\gamma$? For $d=1$ it does, as shown before. For $d=2$ take "
        "$\\beta=\\tfrac14$ on the line, where one root lies at 1 and moves inside as $\\alpha$ "
        "grows. The other roots, at the four limits:"
    )
    line = polynomial.subs({d: 2, alpha: -gamma}).subs(a, 1 + e - gamma * (n_1 + n_0))
    others = cancel(line / (z - 1))
    for gam, fall in ((S.Zero, S.Zero), (S.Zero, DAMPED), (STIFF, S.Zero), (STIFF, DAMPED)):
        title = f"The others lie inside for $\\gamma={float(gam):g}$, $\\delta={float(fall):g}$"
        point, given = {gamma: gam, beta: Rational(1, 4)}, plant.numbers(gam, fall)
        page.inside(title, others, point, given)
    page.figure(
        "fig9",
        "Fig. 9 of the paper: stable walls for $d=1$ and $d=2$ at the limits of the parameter "
        "range. Left bounds and tips for $\\gamma=0.001$ stand apart from those for $\\gamma=0$.",
        delayed,
        panels=(1, 2),
        height=0.5,
    )
    page.lemma(
        "Stable walls lie right of $\\alpha=-\\gamma$, for all arms of (23)",
        right_of_the_line(),
        because="at 1 the polynomial is $(\\alpha+\\gamma)(n_1+n_0)$",
    )
    page.say(
        "Two walls of each region, one next to the left bound and one next to the tip, are shown "
        "to be stable by their roots. That none is stiffer says one point of the circle: of a "
        "polynomial $p$ of degree $n$ with its zeros inside, $n|p|^2<2\\Re\\bar p\\,zp'$ there."
    )
    page.lemma(
        "Walls that no boundary parts from a stable wall are stable",
        enclosed_walls_are_stable(),
        because="on the way between two walls the zeros are continuous, and none crosses the "
        "circle; for every plant and every whole delay",
    )
    page.settle(
        "fig9",
        drawn(),
        note="for $d=2$ the spring takes over a percent of the width",
    )
