r"""How large is the stable stiffness of a damped mass without delay?

Without spring and delay, $\gamma=0$ and $d=0$, the characteristic polynomial is a cubic, and its
stability conditions are explicit. We derive the largest stiffness in closed form, and a bound on
the damping.
"""

from symhaptic.book.lemmas.damped_mass import signs
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed_tip import all_softer, none_stiffer

E, N_1, N_0 = symbols("e n_1 n_0")
TOTAL, APART = N_1 + N_0, N_1 - N_0
ARM = plant.Sampled(N_1, N_0, 1 + E, E)
"""Any arm without a spring: a = 1 + e."""

B_0, B_1 = TOTAL * alpha, 2 * (1 - E) + APART * alpha + 2 * TOTAL * beta
B_2, B_3 = 4 - TOTAL * alpha - 4 * N_0 * beta, 2 * (1 + E) - APART * (alpha + 2 * beta)


def derive(page):
    polynomial = ARM.denominator * z + ARM.numerator * ((alpha + beta) * z - beta)
    page.step(
        "The unit disc is mapped to a half plane",
        (1 - s) ** 3 * polynomial.subs(z, (1 + s) / (1 - s)),
        B_3 * s**3 + B_2 * s**2 + B_1 * s + B_0,
        name=r"(1-s)^3p_1\bigl(\tfrac{1+s}{1-s}\bigr)",
        because="by Routh's criterion all roots are inside if and only if the coefficients "
        "$b_0,b_1,b_2,b_3$ of $1,s,s^2,s^3$ are positive and $b_1b_2>b_0b_3$",
    )
    page.lemma(
        "A damped mass has $0<n_0\\le n_1$",
        conj(*signs()),
        because="the impulse response is positive during the period",
    )
    stiffness(page)
    damping(page, polynomial)


def stiffness(page):
    """The largest stable alpha."""
    root = sqrt(N_0 * (N_0 + E * N_1))
    largest = (TOTAL - w) ** 2 / (N_0 * N_1**2)
    page.define(
        "The number $w$ is the square root of an expression in the device's coefficients", w, root
    )
    page.step(
        r"The minor is a positive multiple of $\alpha_{\max}-\alpha$, minus a square",
        (B_1 * B_2 - B_0 * B_3) / 8,
        N_0 * (1 + N_1 * beta) * (largest - alpha)
        - TOTAL * (N_0 * (1 + N_1 * beta) - w) ** 2 / (N_0 * N_1**2),
        name=r"\tfrac18(b_1b_2-b_0b_3)",
        because="a stable wall has $1+n_1\\beta>0$",
    )
    page.lemma(
        r"Without a spring and with $\delta\le0.1$, no stable wall reaches this stiffness",
        of_masses(none_stiffer()),
        because="the bound holds for both roots $w$; the positive root gives the stricter bound",
    )
    page.lemma(
        r"Without a spring and with $\delta\le0.1$, every smaller stiffness is stable with the "
        "same virtual damping",
        of_masses(all_softer()),
    )
    page.step(
        "The largest stable stiffness has a closed form",
        boundary.largest_undelayed(ARM),
        largest,
        name=r"\alpha_{\max}",
        boxed=True,
        because=r"stable walls approach this bound at $n_0(1+n_1\beta)=w$ but do not attain it",
    )
    free = plant.sampled(plant.normalised(Parts(stiffness=False, damping=False)))
    page.step(
        "Without damping the largest stiffness is that of a free mass",
        boundary.largest_undelayed(free),
        12 - 8 * sqrt(2),
        name=r"\alpha_{\max}|_{\delta\to0}",
    )


def damping(page, polynomial):
    """A bound of beta."""
    page.step(
        "The product of the three roots is $n_0\\beta$",
        polynomial.subs(z, 0),
        -N_0 * beta,
        name="p_1(0)",
        because=r"therefore $|\beta|<1/n_0$ for every stable wall",
    )
    device = plant.sampled(plant.normalised(Parts(stiffness=False)))
    page.limit(
        "For small damping $1/n_0$ exceeds 2 by $\\frac43\\delta$",
        (1 / device.n0 - 2) / delta,
        delta,
        S.Zero,
        Rational(4, 3),
        name=r"\tfrac1\delta\bigl(\tfrac1{n_0}-2\bigr)",
        because=r"in SI units the bound is $B<2m/T+\frac43b+\ldots$",
    )


def of_masses(theorem):
    """The theorem for arms without a spring, gamma = 0."""
    return numbers_known(inst(theorem, {gamma: S.Zero}))
