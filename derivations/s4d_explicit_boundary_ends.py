r"""Where does the explicit boundary begin and end?

The boundary runs through the angles $0<\theta<\pi$. We ask for its two ends, for the direction in
which it starts, and how it lies there against the line $\beta+\delta=\alpha(d+\tfrac12)$ of (25).
"""

from sympy import I, Rational, S, cosh, diff, exp, pi, sinh, sqrt, symbols, tanh

from symhaptic.model import boundary, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.model.passivity import on_circle
from symhaptic.notation import alpha, beta, c, d, delta, gamma, h, nu, s_1, s_2, theta, z
from symhaptic.proof import sign
from symhaptic.proof.enclosed import value

E, N_1, N_0 = symbols("e n_1 n_0")
TOTAL = N_1 + N_0
NU, FIRST = N_0 / TOTAL, (1 - E + gamma * N_0) / TOTAL
SECOND = 1 / TOTAL - (1 - NU) * FIRST


def derive(page):
    without_spring(page, start(page))
    gap(page)
    nyquist(page)


def start(page):
    """The end at theta -> 0, and the slope there."""
    device = plant.sampled(plant.normalised(FULL), split=c)
    given = {gamma: (delta**2 - c**2) / 4}
    static = (1 - device.a + device.e).xreplace(given)
    page.show(
        "The spring is the denominator's value at 1",
        "1-a+e",
        gamma * TOTAL,
        page.same("static", static, (gamma * (device.n1 + device.n0)).xreplace(given)),
        because="as $P(1)=1/\\gamma$. It takes the place of $a$",
    )
    page.say("Three more numbers of the arm keep the formulas short:")
    page.define("The numerator's second number has a share $\\nu$", nu, NU)
    page.define("At low frequencies the device shows the damping $s_1$", s_1, FIRST)
    page.define("At low frequencies it shows the mass $s_2$", s_2, 1 / TOTAL - (1 - nu) * s_1)
    near = gamma + s_1 * (z - 1) + s_2 * (z - 1) ** 2 / (1 + (1 - nu) * (z - 1))
    arm = plant.Sampled(N_1, N_0, 1 + E - gamma * TOTAL, E)
    page.show(
        "Near $z=1$ the arm is these three",
        r"\frac{1}{P(z)}",
        near,
        page.same("near 1", 1 / arm.transfer, near.subs({nu: NU, s_1: FIRST, s_2: SECOND})),
    )
    stiffness, damping = boundary.solved(on_circle(-(z**d) * near))
    page.limit(
        "The boundary starts on the left bound", stiffness, theta, S.Zero, -gamma, name=alpha
    )
    page.limit(
        "The boundary starts from the damping $-s_1-d\\gamma$",
        damping,
        theta,
        S.Zero,
        -s_1 - d * gamma,
        name=beta,
    )
    right = s_2 + (d + 1) * s_1 + d * (d + 1) * gamma / 2
    up = (d + nu) * s_2 + d * (d + 1) * s_1 / 2 + d * (d**2 - 1) * gamma / 6
    across, name = (stiffness + gamma) / theta**2, r"\frac{\alpha+\gamma}{\theta^2}"
    page.limit(
        "From its start the boundary goes to the right in the second order",
        across,
        theta,
        S.Zero,
        right,
        name=name,
    )
    across, name = (damping + s_1 + d * gamma) / theta**2, r"\frac{\beta+s_1+d\gamma}{\theta^2}"
    page.limit(
        "From its start the boundary goes up in the second order",
        across,
        theta,
        S.Zero,
        up,
        name=name,
    )
    short = 6 * (1 - 2 * nu) * s_2 + 6 * (d + 1) ** 2 * s_1 + gamma * d * (d + 1) * (4 * d + 5)
    page.step(
        "At the start the boundary has the slope",
        up / right,
        d + Rational(1, 2) - short / (12 * s_2 + 12 * (d + 1) * s_1 + 6 * d * (d + 1) * gamma),
        name=r"\frac{d\beta}{d\alpha}",
        boxed=True,
        because="less than that of the line wherever $n_1\\ge n_0$ and no $s_i$ is negative",
    )
    return (up / right).subs({nu: NU, s_1: FIRST, s_2: SECOND})


def without_spring(page, slope):
    """gamma = 0: the start is (0, -delta), on the line."""
    device = plant.sampled(plant.normalised(Parts(stiffness=False)))
    numbers = {gamma: 0, N_1: device.n1, N_0: device.n0, E: device.e}
    page.step("Without a spring the damping is $\\delta$", FIRST.subs(numbers), delta, name=s_1)
    page.step("Without a spring the mass $s_2$ is 1", SECOND.subs(numbers), S.One, name=s_2)
    excess = 1 / tanh(delta / 2) - 2 / delta
    page.step(
        "Without a spring the boundary starts at $(0,-\\delta)$ with the slope",
        slope.subs(numbers),
        d + Rational(1, 2) - ((d + 1) ** 2 * delta + excess) / (2 + 2 * (d + 1) * delta),
        name=r"\frac{d\beta}{d\alpha}",
        boxed=True,
        because="it is the $d+\\tfrac12$ of (25) for $\\delta\\to0$ only",
    )
    up, half = sign.Interval(delta, S.Zero), Rational(1, 2)
    grown = [[half, sign.exponential(s * delta / 2)] for s in (1, -1)]
    sine = sign.integrated(2 * sinh(delta / 2), up, sign.combined(cosh(delta / 2), *grown))
    rise = delta * cosh(delta / 2) - 2 * sinh(delta / 2)
    slope = sign.combined(diff(rise, delta), [Rational(1, 4), up.above, sine])
    under = sign.combined(delta * sinh(delta / 2), [half, up.above, sine])
    page.positive(
        "The start is flatter than the line",
        sign.quotient(excess, sign.integrated(rise, up, slope), under),
        r"\delta>0",
        because="so the boundary falls below the line at once",
    )


def gap(page):
    """How far the start lies below the line of (25)."""
    device = plant.sampled(plant.normalised(FULL), split=c)
    given = {gamma: (delta**2 - c**2) / 4}
    waves = gamma * sinh(delta / 2) + gamma * delta / c * sinh(c / 2)
    waves -= 2 * delta * (cosh(delta / 2) - cosh(c / 2))
    numbers = {N_1: device.n1, N_0: device.n0, E: device.e}
    below = FIRST.subs(numbers) - delta - gamma / 2
    weighed = below * gamma * (device.n1 + device.n0)
    page.show(
        "The start lies below that line by a difference of order $\\delta\\gamma^2$",
        r"s_1-\delta-\tfrac12\gamma",
        exp(-delta / 2) / (gamma * TOTAL) * waves,
        page.same("gap", weighed.xreplace(given), (exp(-delta / 2) * waves).xreplace(given)),
        because="with $c^2=\\delta^2-4\\gamma$",
    )
    scaled = waves.xreplace(given).subs({delta: h * delta, c: h * c}, simultaneous=True)
    page.show(
        "For short periods the difference is $\\delta\\gamma^2/720$ to lowest order",
        r"\lim_{T\to0}\frac{720}{\delta\gamma^2}\bigl(s_1-\delta-\tfrac12\gamma\bigr)",
        S.One,
        page.limits(720 * scaled / (h**7 * delta * gamma**3).xreplace(given), h, S.Zero, S.One),
        because="as $n_1+n_0$ and the exponential tend to 1",
    )
    corner = {gamma: Rational(1, 1000), delta: Rational(1, 50), c: sqrt(-Rational(9, 2500))}
    page.enclosed(
        "At the corner of (23) the difference is enclosed",
        [(r"s_1-\delta-\tfrac12\gamma", value(below.subs(corner)))],
    )


def nyquist(page):
    """The end at theta -> pi, for whole delays."""
    a = symbols("a")
    arm = plant.Sampled(N_1, N_0, a, E)
    stiffness, damping = boundary.solved(on_circle(boundary.needed(arm)) * exp(-I * d * pi))
    end = N_1 * (1 + a + E) / (N_1 - N_0) ** 2 - (2 + a + d * (1 + a + E)) / (N_1 - N_0)
    page.say("At the other end, for whole $d$ and $n_1\\ne n_0$, a factor $(-1)^d$ is left:")
    page.limit(
        "At $\\theta\\to\\pi$ the damping is finite", damping, theta, pi, end, name=r"(-1)^d\beta"
    )
    page.limit(
        "At $\\theta\\to\\pi$ the boundary ends on the line of a root at $-1$",
        stiffness + 2 * damping,
        theta,
        pi,
        (1 + a + E) / (N_1 - N_0),
        name=r"(-1)^d(\alpha+2\beta)",
    )
