r"""Half a period late: is a wall stable that the paper takes for stable?

For a fractional delay the paper puts $z^{-d}=e^{-jd\theta}$ into the polynomial of a whole one.
We hold that against the exact polynomial for the plainest device, a free mass, and for
$d=\ell+\tfrac12$. The two boundaries are $Q=-z^{\ell+1}A/M$ and $Q_p=-z^dA/N$.
"""

from sympy import I, Rational, S, cos, diff, exp, log, pi, sin, sqrt, symbols

from symhaptic.book.lemmas.principal import one_error, read_too_largely
from symhaptic.model import fractional, plant
from symhaptic.model.parts import Parts
from symhaptic.model.passivity import on_circle, real_part
from symhaptic.notation import alpha, beta, epsilon, l, theta, u, w, x, z


def derive(page):
    free = fractional.late(plant.normalised(Parts(stiffness=False, damping=False)))
    poles = free.device.denominator
    exact = -(z ** (l + 1)) * poles / free.numerator
    printed = -(z ** (l + epsilon)) * poles / free.device.numerator
    top = on_circle(free.numerator)
    page.step(
        "For every fraction $M$ is larger than $N$",
        top * top.xreplace({I: -I}),
        cos(theta / 2) ** 2 + 4 * epsilon**2 * (1 - epsilon) ** 2 * sin(theta / 2) ** 4,
        name="|M|^2",
        because="and $|N|^2=\\cos^2\\frac\\theta2$, so that $|Q|\\le|Q_p|$",
    )
    ratio = on_circle(exact / printed)
    page.limit(
        "Their phases part with the third power of the angle",
        (ratio - real_part(ratio)) / (I * theta**3),
        theta,
        S.Zero,
        epsilon * (1 - epsilon) * (1 - 2 * epsilon) / 12,
        name=r"\frac{1}{\theta^3}\,\Im\frac{Q}{Q_p}",
        because="the true delay acts longer before half a period, and shorter after it",
    )
    half, c = {epsilon: S.Half}, cos(theta / 2)
    shrinks = page.step(
        "Half a period late the true wall is the smaller one",
        ratio.subs(half),
        2 * c / (1 + c**2),
        name="Q/Q_p",
        because="positive, and less than 1 as $(1-\\cos\\frac\\theta2)^2>0$",
    )
    page.step(
        "Half a period late both have one phase",
        on_circle(printed.subs(half)) * exp(-I * (l + 1) * theta),
        4 * sin(theta / 2) ** 2 / c,
        name=r"Q_p\,e^{-j(\ell+1)\theta}",
        because="positive, so that both have the phase $(\\ell+1)\\theta$",
    )
    page.say(
        "Turn a wall up from nothing, $yW$ with $W=\\alpha+\\beta(1-1/z)$. Where $yW=Q$ there is a "
        "root; with $Q/W=e^{\\mu+j\\varphi}$ on the circle, "
        "$\\partial\\ln z/\\partial\\ln y=1/(\\varphi'-j\\mu')$."
    )
    outward = page.same("outward", real_part(1 / (u - I * w)), u / (u**2 + w**2))
    page.show(
        "A root crosses outward where the phase rises",
        r"\Re\frac1{u-jw}",
        u / (u**2 + w**2),
        outward,
        because="outward if the phase $\\varphi$ rises with $\\theta$",
    )
    push = alpha + beta - beta * exp(-I * theta)
    size = alpha**2 + 2 * beta * (alpha + beta) * (1 - cos(theta))
    lead = page.step(
        "The wall takes its own slope from the phase",
        real_part(beta * exp(-I * theta) / push),
        (beta * (alpha + beta) * cos(theta) - beta**2) / size,
        name=r"\Im\Bigl(\frac{1}{W}\frac{\partial W}{\partial\theta}\Bigr)",
        because="$\\beta/\\alpha$ at $\\theta=0$",
    )
    page.step(
        "The phase is convex",
        -diff(lead, theta),
        alpha * beta * (alpha + beta) * (alpha + 2 * beta) * sin(theta) / size**2,
        name=r"\varphi''",
        because="positive for $\\alpha,\\beta>0$: once $\\varphi$ has come back to 0, it rises",
    )
    small = symbols("s")
    near = small / I  # z = exp(s)
    start = [on_circle(q.subs(half) / z ** (l + 1), near) / -(small**2) for q in (exact, printed)]
    start.append((alpha + beta * (1 - exp(-small))) * exp(-beta * small / alpha) / alpha)
    both = [page.limits((expr - 1) / small, small, S.Zero, S.Zero) for expr in start]
    page.show(
        "A weak wall moves both roots inside if $\\beta/\\alpha>\\ell+1$",
        r"s^2",
        r"-y\alpha\,e^{(\beta/\alpha-\ell-1)s}\,(1+O(s^2))",
        both[0],
        because="so that $\\Re s\\approx-\\tfrac12y\\alpha(\\beta/\\alpha-\\ell-1)$: both roots "
        "move inside if $\\beta/\\alpha>\\ell+1$, and outside if it is less",
    )
    polynomial = fractional.characteristic(Parts(False, False)).subs(half)
    page.step(
        "Only with $\\beta/\\alpha>\\ell/2$ can all roots lie inside",
        (diff(polynomial, z) / polynomial).subs(z, 1),
        beta / alpha + 2,
        name=r"p_1'(1)/p_1(1)",
        because="is the sum of $1/(1-z_i)$, each with a real part above $\\tfrac12$: more than "
        "$\\tfrac12(\\ell+4)$, so that a stable wall has $\\beta/\\alpha>\\ell/2$, hence "
        "$\\beta>0$, and $\\alpha>0$ by $p_1(1)$",
    )
    page.say(
        "For $0<\\beta/\\alpha<\\ell+1$ the phase rises from the start: the two roots are outside "
        "and nothing comes back. For $\\beta/\\alpha>\\ell+1$ all roots start inside, and every "
        "crossing is outward: the wall is stable as long as $|W|<|Q|$ at all angles with "
        "$\\varphi=0$ modulo $2\\pi$. These are the same in the paper's reading, whose $|Q_p|$ is "
        "larger, and whose roots do not leave the sheet: for $z<0$ its imaginary part is "
        "$\\pm|z|^{d+1}(1-z)^2\\ne0$. (The border $\\beta/\\alpha=\\ell+1$ is not stable either: "
        "the stable walls are an open set.)"
    )
    gain = log(64 * x**2 / ((2 - x) ** 2 * (alpha**2 + 4 * beta * (alpha + beta) * x)))
    page.step(
        "The first angle is the strictest",
        diff(gain, x),
        1 / x + 2 / (2 - x) + alpha**2 / (x * (alpha**2 + 4 * beta * (alpha + beta) * x)),
        name=r"\frac{\partial}{\partial x}\ln\frac{|Q|^2}{|W|^2}",
        because="positive, with $x=\\sin^2\\frac\\theta2$; for $\\alpha>0$ this angle is less than "
        "$\\pi/(2\\ell+3)$, where $\\alpha$ vanishes on the boundary",
    )
    far = page.same("farthest", 1 - shrinks.subs(theta, pi / 3), 1 - 4 * sqrt(3) / 7)
    page.show(
        "The two boundaries are farthest apart at $\\ell=0$, $\\theta=\\frac\\pi3$",
        r"1-Q/Q_p",
        1 - 4 * sqrt(3) / 7,
        far,
        because="1.03 per cent",
    )
    page.say("One wall between the two boundaries, $\\ell=0$, with $\\zeta=\\sqrt z$ in the paper:")
    wall = {alpha: Rational(1, 15), beta: Rational(16, 15), l: 0}
    theirs = z**3 * (z**2 - 1) ** 2 + (z**2 + 1) / 2 * ((alpha + beta) * z**2 - beta)
    page.outside("The wall $(\\tfrac1{15},\\tfrac{16}{15})$ is not stable", polynomial.subs(wall))
    page.inside("In the paper's reading it is stable", theirs.subs(wall), half=True)
    page.state(
        "fractional-half-mass",
        "half a period late, $d=\\ell+\\tfrac12$, a wall that keeps a free mass stable is stable "
        "in the paper's reading",
    )
    page.settle(
        "fractional-half-mass",
        page.same("the same phase", ratio.subs(half), shrinks),
        *(outward, far, *both),
        note="on each ray from the origin the true boundary is at most 1.03 \\% nearer",
    )
    found = page.lemma(
        "There is a wall that the paper's reading takes for stable, and that is not",
        one_error(),
        because="this one, by balls around all roots",
    )
    page.state(
        "fractional-half-mass-apart",
        "half a period late some wall is stable for a free mass in the paper's reading, the "
        "principal sheet, and not in truth",
        claim=read_too_largely(),
    )
    page.settle("fractional-half-mass-apart", found)
