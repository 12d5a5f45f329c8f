r"""Which walls are stable without delay?

Gil et al. solved the inequalities for $d=0$ without a spring. There are four, and the last is
linear in $\alpha$, so that its boundary can be solved with any spring. Without a spring one
formula says it all, and we show for which devices.
"""

from sympy import Rational, S, diff, exp, expand

from symhaptic.model import jury, plant
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import B, K, T, a, alpha, b, beta, c, delta, e, gamma, m, n_0, n_1, z
from symhaptic.proof.sign import Interval, assume, combined, exponential, integrated, quotient

DAMPED = plant.sampled(plant.normalised(Parts(stiffness=False)))
FREE = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
NUMBERS = {n_1: DAMPED.n1, n_0: DAMPED.n0, e: DAMPED.e}
RISE = n_1 + n_0


def derive(page):
    first, second, third, minor = jury.criterion(jury.coefficients(0)).expressions
    held = plant.sampled(plant.normalised(FULL), split=c)
    rest = held.transfer.subs(z, 1).subs(gamma, (delta**2 - c**2) / 4)
    page.same("at rest", rest, 4 / (delta**2 - c**2))
    page.say("A spring has $P(1)=1/\\gamma$, that is $a=1+e-\\gamma(n_1+n_0)$. So for any device:")
    spring = {a: 1 + e - gamma * RISE}
    one = RISE * (alpha + gamma)
    page.step("One side is the line $\\alpha=-\\gamma$", first.subs(spring), one, name="p_1(1)")
    top = (1 - n_0 * beta) * (RISE * beta + 1 - e + gamma * n_0)
    below = n_0 * (1 + n_1 * beta)
    split = top - below * (alpha + gamma)
    page.step(
        "With any spring the minor is linear in the stiffness",
        minor.subs(spring),
        split,
        name=r"\Delta_2",
    )
    page.show(
        "With any spring the minor vanishes at this stiffness",
        alpha + gamma,
        top / below,
        page.same("on the curve", split.subs(alpha, top / below - gamma), S.Zero),
        because="a spring needs neither a grid nor a parameter",
        boxed=True,
    )
    page.say(
        "Without a spring $\\gamma=0$, and the numbers are those of a damped mass. Their sum is "
        "$(1-e)/\\delta$ and also $1-n_1\\delta$, so that $1-n_1\\delta>0$."
    )
    sums = [f.subs(NUMBERS) for f in (RISE, (1 - e) / delta, 1 - delta * n_1)]
    page.same("the sum", *sums)
    page.same("the trace", DAMPED.a, 1 + DAMPED.e)
    four = (first, second, third, minor)
    first, second, third, minor = (f.subs(a, 1 + e).subs(e, 1 - delta * RISE) for f in four)
    last = RISE * (beta + delta) * (1 - n_0 * beta) - n_0 * alpha * (1 + n_1 * beta)
    page.step("Without a spring the minor keeps its shape", minor, last, name=r"\Delta_2")
    signs(page)
    necessary(page, minor, 8 - first - second - third)
    sufficient(page, second, third, minor)
    formulas(page, minor)


def signs(page):
    """Of the damped mass's numbers."""
    n1, n0, e = DAMPED.n1, DAMPED.n0, DAMPED.e
    room = assume(Rational(1, 3) - delta, strict=False)
    up, left = Interval(delta, S.Zero), exponential(-delta)
    soft = Interval(delta, S.Zero, (room, combined(S.One, [1])))
    low, apart, light = (expand(delta**2 * f) for f in (n0, n1 - n0, (2 + e) * n0 - n1))
    low = integrated(low, up, combined(diff(low, delta), [up.above, left]))
    apart = integrated(apart, up, combined(diff(apart, delta), [low]))
    lost = integrated(1 - e, up, combined(e, [left]))
    bend = combined(diff(light, delta, 2), [6, left, room], [4, left, up.above, lost])
    light = integrated(light, soft, integrated(diff(light, delta), soft, bend))
    page.positive("The number $n_0$ is positive", low, r"\delta>0", name=r"\delta^2n_0")
    page.positive("The number $n_1$ is the larger", apart, r"\delta>0", name=r"\delta^2(n_1-n_0)")
    on, name = r"0<\delta\le\tfrac13", r"\delta^2\bigl((2+e)n_0-n_1\bigr)"
    page.positive("For light damping $(2+e)n_0$ exceeds $n_1$", light, on, name=name)


def necessary(page, minor, between):
    """Stable walls have beta > -delta; ``between`` is c_2, as all four c_k add up to 8."""
    page.same("c_2", between, 4 - RISE * alpha - 4 * n_0 * beta)
    parts = n_0 * (1 + n_1 * beta) * (4 - RISE * alpha - 4 * n_0 * beta)
    parts += (1 - n_0 * beta) * ((n_1 - n_0) ** 2 * (beta + delta) - 4 * n_0 * RISE)
    same = {delta: (1 - RISE) / n_1}
    proof = page.same("least damping", RISE * minor.subs(same), parts.subs(same))
    page.show(
        "The minor is a sum that no $\\beta\\le-\\delta$ makes positive",
        r"(n_1+n_0)\Delta_2",
        parts,
        proof,
    )
    page.say(
        "Let all roots lie inside. The first half plane says $\\alpha>0$, and "
        "$c_2=4-(n_1+n_0)\\alpha-4n_0\\beta$ is positive, like all $c_k$. If $\\beta\\le-\\delta$, "
        "the last term is negative, so that $1+n_1\\beta>0$. But then no term of $\\Delta_2$ in "
        "the form before is positive. So $\\beta>-\\delta$."
    )


def sufficient(page, second, third, minor):
    """With alpha > 0 and beta > -delta the minor is all there is."""
    low, apart, damper = assume(n_0), assume(n_1 - n_0), assume(delta)
    still, light = assume(1 - delta * n_1), assume(3 * n_0 - delta * RISE * n_0 - n_1)
    push, brake, last = assume(alpha), assume(beta + delta), assume(minor)
    high, rise = combined(n_1, [apart], [low]), combined(RISE, [apart], [2, low])
    less = combined(1 - delta * n_0, [still], [damper, apart])
    above = combined(1 + n_1 * beta, [still], [high, brake])
    more = combined(1 + delta * n_0, [1], [damper, low])
    both = combined(RISE * (beta + delta), [rise, brake])
    product = combined(both.expr * (1 - n_0 * beta), [last], [low, push, above])
    edge = quotient(1 - n_0 * beta, product, both)
    page.say("Conversely let $\\alpha>0$, $\\beta>-\\delta$, $\\Delta_2>0$. With the signs above:")
    on = r"\alpha>0,\ \beta>-\delta,\ \Delta_2>0"
    page.positive("The damping stays below $1/n_0$", edge, on)
    second = combined(second, [2, rise, brake], [apart, push])
    page.positive("The second half plane follows from the minor", second, on, name="c_1")
    scale = combined(more.expr * low.expr * above.expr, [more, low, above])
    product = combined(
        scale.expr * third,
        [more, apart, last],
        [4, edge, low, still, less],
        [2, brake, rise, light],
        [more, apart, apart, brake, edge],
    )
    third = quotient(third, product, scale)
    light = on + r",\ \delta\le\tfrac13"
    page.positive("The third half plane follows, too", third, light, name="-p_1(-1)")


def formulas(page, minor):
    """The one condition that is left, in both kinds of units."""
    most = RISE * (beta + delta) * (1 - n_0 * beta) / (n_0 * (1 + n_1 * beta))
    page.same("the minor vanishes", minor.subs(alpha, most), S.Zero)
    page.say(
        "So for $0<\\delta\\le\\tfrac13$ a wall is stable exactly if $-\\delta<\\beta<1/n_0$ and "
        "$0<\\alpha<\\alpha_0(\\beta)$. At $\\delta=4.6$ the third half plane is needed too."
    )
    f = exp(-delta)
    left = 1 - (1 + delta) * f
    explicit = delta * (1 - f) * (beta + delta) * (delta**2 - left * beta)
    explicit /= left * (delta**2 + (delta - 1 + f) * beta)
    most = most.subs(NUMBERS)
    page.step("The solution is explicit", most, explicit, name=r"\alpha_0", boxed=True)
    kept = m - (m + b * T) * exp(-b * T / m)
    physical = b * (b + B) * (1 - exp(-b * T / m)) / kept
    physical *= (b**2 * T - kept * B) / (b**2 * T + (b * T - m + m * exp(-b * T / m)) * B)
    largest = explicit.subs({beta: B * T / m, delta: b * T / m}) * m / T**2
    page.step(
        "In physical units the largest stiffness depends on mass, damping and period",
        largest,
        physical,
        name=K,
    )
    still = 2 * beta * (2 - beta) / (2 + beta)
    page.limit(
        "Without damping the solution tends to a limit",
        explicit,
        delta,
        S.Zero,
        still,
        name=r"\alpha_0",
    )
    page.result(
        "A wall of a free mass is stable if and only if",
        (alpha > 0, beta > 0, 2 * beta * (2 - beta) - alpha * (2 + beta) > 0),
        equal_to=jury.inequalities(0, FREE),
    )
