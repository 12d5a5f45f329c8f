r"""Where does the explicit boundary begin and end?

The boundary has one point for each angle $0<\theta<\pi$. We ask for the two ends of the boundary
and for its direction at the first end. We compare this direction with that of the line
$\beta+\delta=\alpha(d+\tfrac12)$ of (25).
"""

from symhaptic.book.lemmas.prelude import *
from symhaptic.proof.enclosed import value as enclosed
from symhaptic.proof.theorems.analysis import grows

E, N_1, N_0 = symbols("e n_1 n_0")
TOTAL = N_1 + N_0
NU, FIRST = N_0 / TOTAL, (1 - E + gamma * N_0) / TOTAL
SECOND = 1 / TOTAL - (1 - NU) * FIRST
SLOPE = r"\frac{d\beta}{d\alpha}"


def derive(page):
    without_spring(page, start(page))
    gap(page)
    nyquist(page)


def start(page):
    """The limit at theta -> 0, and the slope there."""
    page.lemma(
        r"At $z=1$ the denominator is $\gamma$ times the numerator",
        device_static(assume(DEVICE)),
        because=r"the equality follows from $P(1)=1/\gamma$ and eliminates $a$",
    )
    page.say("Three abbreviations for the device keep the formulas short:")
    page.define(r"The second coefficient is the fraction $\nu$ of the numerator's sum", nu, NU)
    page.define("The number $s_1$ is the low-frequency damping of the device", s_1, FIRST)
    page.define(
        "The number $s_2$ is the low-frequency mass of the device", s_2, 1 / TOTAL - (1 - nu) * s_1
    )
    near = gamma + s_1 * (z - 1) + s_2 * (z - 1) ** 2 / (1 + (1 - nu) * (z - 1))
    arm = plant.Sampled(N_1, N_0, 1 + E - gamma * TOTAL, E)
    page.step(
        "Near $z=1$ these numbers describe the device",
        1 / arm.transfer,
        near,
        name=r"P^{-1}(z)",
    )
    stiffness, damping = boundary.solved(on_circle(-(z**d) * near))
    page.limit(
        r"The boundary starts at $\alpha=-\gamma$", stiffness, theta, S.Zero, -gamma, name=alpha
    )
    page.limit(
        r"The boundary starts at $\beta=-s_1-d\gamma$",
        damping,
        theta,
        S.Zero,
        -s_1 - d * gamma,
        name=beta,
    )
    right = s_2 + (d + 1) * s_1 + d * (d + 1) * gamma / 2
    up = (d + nu) * s_2 + d * (d + 1) * s_1 / 2 + d * (d**2 - 1) * gamma / 6
    for way, moved, value, name in (
        ("to the right", stiffness + gamma, right, r"\alpha(\theta)+\gamma"),
        ("up", damping + s_1 + d * gamma, up, r"\beta(\theta)+s_1+d\gamma"),
    ):
        title = f"To second order the boundary goes {way} from its start"
        name = rf"\frac{{{name}}}{{\theta^2}}"
        page.limit(title, moved / theta**2, theta, S.Zero, value, name=name)
    short = 6 * (1 - 2 * nu) * s_2 + 6 * (d + 1) ** 2 * s_1 + gamma * d * (d + 1) * (4 * d + 5)
    page.step(
        r"The initial slope of the boundary is a fraction less than $d+\frac12$",
        up / right,
        d + Rational(1, 2) - short / (12 * s_2 + 12 * (d + 1) * s_1 + 6 * d * (d + 1) * gamma),
        name=SLOPE,
        boxed=True,
        because=r"the slope is less than that of the line if $n_1\ge n_0$, $s_1\ge0$ and $s_2\ge0$",
    )
    return (up / right).subs({nu: NU, s_1: FIRST, s_2: SECOND})


def without_spring(page, slope):
    """Without a spring the boundary starts at (0, -delta), on the line."""
    device = plant.sampled(plant.normalised(Parts(stiffness=False)))
    numbers = {gamma: 0, N_1: device.n1, N_0: device.n0, E: device.e}
    page.step(
        r"Without a spring, $s_1$ is the damping $\delta$",
        FIRST.subs(numbers),
        delta,
        name=r"s_1\big|_{\gamma=0}",
    )
    page.step(
        "Without a spring, the mass $s_2$ is 1",
        SECOND.subs(numbers),
        S.One,
        name=r"s_2\big|_{\gamma=0}",
    )
    excess = cosh(delta / 2) / sinh(delta / 2) - 2 / delta
    page.step(
        r"Without a spring, the boundary starts at $(0,-\delta)$ with an explicit slope",
        slope.subs(numbers),
        d + Rational(1, 2) - ((d + 1) ** 2 * delta + excess) / (2 + 2 * (d + 1) * delta),
        name=SLOPE,
        boxed=True,
        because=r"the slope equals the slope $d+\tfrac12$ of (25) in the limit $\delta\to0$ only",
    )
    page.lemma(
        "Without a spring the boundary has a smaller initial slope than the line of (25), for "
        r"$\delta>0$",
        cotangent_exceeds(),
        because="the difference is the last term of the previous slope, and the boundary begins "
        "below the line",
    )


def gap(page):
    """The distance of the start from the line of (25)."""
    device = plant.sampled(plant.normalised(FULL), split=c)
    given = {gamma: (delta**2 - c**2) / 4}
    waves = gamma * sinh(delta / 2) + gamma * delta / c * sinh(c / 2)
    waves -= 2 * delta * (cosh(delta / 2) - cosh(c / 2))
    numbers = {N_1: device.n1, N_0: device.n0, E: device.e}
    below = FIRST.subs(numbers) - delta - gamma / 2
    weighed = below * gamma * (device.n1 + device.n0)
    page.say(
        "The start of the boundary lies below the line of (25) by the distance "
        r"$g=s_1-\delta-\frac12\gamma$. Let $c$ be the difference of the poles:"
    )
    page.define("The poles of the arm differ by $c$", gamma, given[gamma])
    page.step(
        "The distance of the start from the line of (25) is a difference of hyperbolic functions",
        weighed,
        exp(-delta / 2) * waves,
        name=r"\gamma(n_1+n_0)\,g",
        because="the distance is positive up to the limit (30), as "
        r"\chapter{s4d_explicit_boundary_signs} shows",
    )
    scaled = waves.xreplace(given).subs({delta: h * delta, c: h * c}, simultaneous=True)
    page.limit(
        "For short periods the distance is $\\delta\\gamma^2/720$ to lowest order",
        720 * scaled / (h**7 * delta * gamma**3).xreplace(given),
        h,
        S.Zero,
        S.One,
        name=r"\frac{720\,(n_1+n_0)\,e^{\delta/2}}{\delta\gamma^2}\,g",
        because=r"with a period that is $h$ times as long, $\delta$ and $c$ become $h\delta$ and "
        r"$hc$; for $h\to0$, $n_1+n_0$ and the exponential tend to 1",
    )
    corner = {gamma: Rational(1, 1000), delta: Rational(1, 50), c: sqrt(-Rational(9, 2500))}
    page.enclosed(
        "An interval contains the distance at the corner of (23)",
        [("g", enclosed(below.subs(corner)))],
    )


def nyquist(page):
    """The limit at theta -> pi, for integer delays."""
    a = symbols("a")
    arm = plant.Sampled(N_1, N_0, a, E)
    stiffness, damping = boundary.solved(on_circle(boundary.needed(arm)) * exp(-I * d * pi))
    end = N_1 * (1 + a + E) / (N_1 - N_0) ** 2 - (2 + a + d * (1 + a + E)) / (N_1 - N_0)
    page.say(
        r"At the other end, for integer $d$ and $n_1\ne n_0$, the limits contain a factor "
        "$(-1)^d$:"
    )
    title, name = "At $\\theta\\to\\pi$ the damping is finite", r"(-1)^d\beta(\theta)"
    page.limit(title, damping, theta, pi, end, name=name)
    page.limit(
        "At $\\theta\\to\\pi$ the boundary ends on the line of a root at $-1$",
        stiffness + 2 * damping,
        theta,
        pi,
        (1 + a + E) / (N_1 - N_0),
        name=r"(-1)^d(\alpha(\theta)+2\beta(\theta))",
    )


# The hyperbolic cotangent of half a number exceeds two over the number.


def cotangent_exceeds() -> Theorem:
    """0 < coth(delta/2) - 2/delta for 0 < delta, as t cosh(t/2) - 2 sinh(t/2) rises from 0."""
    half = positive(t / 2 > 0, [Rational(1, 2), t > 0])
    sine = closed(rising(sinh, S.Zero, t / 2), half)
    rest = t * cosh(t / 2) - 2 * sinh(t / 2)
    slope = positive(diff(rest, t) > 0, [Rational(1, 2), t > 0, sine])
    above = positive(rest.subs(t, delta) > 0, [grows(rest, t, S.Zero, delta, slope)])
    sine = inst(sine, {t: delta})
    below = positive(delta * sinh(delta / 2) > 0, [delta > 0, sine])
    apart = positive(Ne(sinh(delta / 2), 0), [sine]), positive(Ne(delta, 0), delta > 0)
    excess = cosh(delta / 2) / sinh(delta / 2) - 2 / delta
    return closed(over(excess > 0, above, below), *apart)
