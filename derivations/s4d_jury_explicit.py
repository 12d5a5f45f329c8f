r"""Which walls are stable without delay?

Gil et al. solved Jury's inequalities for $d=0$ without a spring. There are four inequalities. The
last one is linear in $\alpha$, so it can be solved for the stiffness with any spring. Without
a spring one formula is sufficient for some devices, and we show for which.
"""

from symhaptic.book.lemmas.damped_mass import signs, stable_damped_mass
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.stability import collected, free_by_inequalities
from symhaptic.model import jury

DAMPED = plant.sampled(plant.normalised(Parts(stiffness=False)))
NUMBERS = {n_1: DAMPED.n1, n_0: DAMPED.n0, e: DAMPED.e}
RISE = n_1 + n_0


def derive(page):
    first, _, _, minor = jury.criterion(jury.coefficients(0)).expressions
    held = plant.sampled(plant.normalised(FULL), split=c)
    rest = held.transfer.subs(z, 1).subs(gamma, (delta**2 - c**2) / 4)
    page.same("at rest", rest, 4 / (delta**2 - c**2))
    page.say(
        r"A device with a spring has $P(1)=1/\gamma$, that is $a=1+e-\gamma(n_1+n_0)$. So one "
        "half plane bounds the stiffness alone:"
    )
    spring = {a: 1 + e - gamma * RISE}
    one = RISE * (alpha + gamma)
    page.step(r"One half plane is $\alpha>-\gamma$", first.subs(spring), one, name="p_1(1)")
    top = (1 - n_0 * beta) * (RISE * beta + 1 - e + gamma * n_0)
    below = n_0 * (1 + n_1 * beta)
    split = top - below * (alpha + gamma)
    page.step(
        "With any spring the minor is linear in the stiffness",
        minor.subs(spring),
        split,
        name=r"\Delta_2",
    )
    page.lemma(
        "One stiffness makes the minor vanish, with any spring",
        combined(Eq(split, 0), [assume(Eq(alpha + gamma, top / below)), -below]),
        because="therefore the boundary requires neither a grid nor a parameter, even with a "
        "spring",
        boxed=True,
    )
    page.say(
        r"Without a spring $\gamma=0$, and the coefficients are those of a damped mass: $a=1+e$ "
        r"and $1-e=\delta(n_1+n_0)$."
    )
    sums = [f.subs(NUMBERS) for f in (RISE, (1 - e) / delta, 1 - delta * n_1)]
    page.same("the sum", *sums)
    page.same("the trace", DAMPED.a, 1 + DAMPED.e)
    minor = minor.subs(a, 1 + e).subs(e, 1 - delta * RISE)
    last = RISE * (beta + delta) * (1 - n_0 * beta) - n_0 * alpha * (1 + n_1 * beta)
    page.step(
        "Without a spring the minor is also linear in the stiffness", minor, last, name=r"\Delta_2"
    )
    page.lemma(
        r"The numerator of a damped mass has $0<n_0\le n_1$",
        conj(*signs()),
        because="the impulse response of the device is positive during the period",
    )
    page.lemma(
        "Without spring and delay, the minor and two bounds decide stability if "
        r"$\delta\le\frac13$",
        stable_damped_mass(),
        because=r"a stable wall has $1+n_1\beta>0$ and $n_0\beta<1$, so the minor is not "
        r"positive for $\beta\le-\delta$; the remaining half planes follow from these three "
        "inequalities",
        boxed=True,
    )
    formulas(page, minor)


def formulas(page, minor):
    """The remaining condition, in dimensionless parameters and in SI units."""
    most = RISE * (beta + delta) * (1 - n_0 * beta) / (n_0 * (1 + n_1 * beta))
    page.same("the minor vanishes", minor.subs(alpha, most), S.Zero)
    page.say(
        r"So for $0<\delta\le\tfrac13$ a wall is stable if and only if $-\delta<\beta<1/n_0$ and "
        r"$0<\alpha<\alpha_0(\beta)$, where the minor vanishes at $\alpha_0$. For $\delta=4.6$ the "
        "third half plane is also necessary."
    )
    f = exp(-delta)
    left = 1 - (1 + delta) * f
    explicit = delta * (1 - f) * (beta + delta) * (delta**2 - left * beta)
    explicit /= left * (delta**2 + (delta - 1 + f) * beta)
    most = most.subs(NUMBERS)
    page.step(
        "The largest stiffness without a spring is explicit",
        most,
        explicit,
        name=r"\alpha_0",
        boxed=True,
    )
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
        "Without damping the largest stiffness tends to a limit",
        explicit,
        delta,
        S.Zero,
        still,
        name=r"\alpha_0",
    )
    page.lemma(
        "Without delay three inequalities decide the stability of a free mass",
        collected(
            free_by_inequalities(0),
            alpha > 0,
            beta > 0,
            2 * beta * (2 - beta) - alpha * (2 + beta) > 0,
        ),
        boxed=True,
    )
