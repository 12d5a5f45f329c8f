"""When can no motion extract energy from a sampled wall?

A user moves a device with damping $b$ arbitrarily. A wall $H(z)$ computes a force once per period
$T$, and this force is held until the next period. The user gains energy if the wall delivers more
than the damper dissipates. Which inequality excludes this, and is it sufficient?
"""

from sympy import re

from symhaptic.book.lemmas.largest_damping import divisors
from symhaptic.book.lemmas.prelude import *
from symhaptic.notation import function
from symhaptic.paper.propositions.passivity import ANSWER, TAPS
from symhaptic.proof.theorems.energy import toeplitz


def derive(page):
    H = function("H")
    page.say(
        "The wall force is constant over a period, so its work $F_kp_k$ depends on the "
        "displacement $p_k$ only. The damper dissipates the integral of $bv^2$. For a given "
        "displacement this integral is smallest at constant speed:"
    )
    page.step(
        "A damper dissipates least at constant speed",
        v**2,
        (v - p_k / T) ** 2 + 2 * v * p_k / T - p_k**2 / T**2,
        because="the integral of the last two terms over a period is $p_k^2/T$, and the integral "
        "of the square vanishes only at constant speed",
    )
    page.say(
        "A motion that ends at rest returns the kinetic energy, so the mass does not matter. "
        "If $p$ is the spectrum of the displacements, the position has the spectrum $x=p/(z-1)$. "
        "The sum over all periods gives the energy that damper and wall receive per squared "
        r"displacement, $b/T+\Re\{H/(z-1)\}$."
    )
    page.step(
        "On the unit circle, $1/(z-1)$ can be written with a real denominator",
        passivity.on_circle(1 / (z - 1)),
        (exp(-I * theta) - 1) / (2 - 2 * cos(theta)),
        because=r"here $z=e^{j\theta}$ has the angle $\theta=\omega T$",
        name=r"\left.\frac{1}{z-1}\right|_{z=e^{j\theta}}",
    )
    angle = omega * T
    needed = passivity.required_damping(H(z), angle)
    printed = re((1 - exp(-I * angle)) * H(exp(I * angle)), evaluate=False)
    page.step(
        "At every angle the damper must dissipate more than the wall delivers",
        needed,
        T / 2 / (1 - cos(angle)) * printed,
        name=r"b_{\min}(\omega)",
        boxed=True,
        paper="4",
        because="if this inequality fails at an angle, a motion whose spectrum is concentrated "
        "near this angle gains energy",
    )
    page.say(
        r"At $\theta=0$, which the open interval excludes, $1/(z-1)$ has a pole. This pole adds a "
        "second term to the sum. For the spring alone, $F_k=Kx_k$, this term is the stored energy:"
    )
    page.step(
        "The work of a step against a spring contains the change of the stored energy",
        x * p_k,
        ((x + p_k) ** 2 - x**2 - p_k**2) / 2,
        because="with $x_{k+1}=x_k+p_k$ and $x_0=0$ the sum of the first two terms over all "
        "periods is $x_N^2/2$",
    )
    periods = S(4)
    ramp = periods * b * p_k**2 / T + K * p_k**2 * periods * (periods - 1) / 2
    page.step(
        "Damper and spring receive this energy in four equal steps",
        ramp,
        (4 * b / T + 6 * K) * p_k**2,
        name="E",
        because="the position is $x_k=kp_k$, so the spring receives $K(0+1+2+3)p_k^2$",
    )
    page.say(
        r"For $H(1)<0$ the stored energy $\tfrac12H(1)x_N^2$ is negative, and its magnitude grows "
        "with the square of the distance. The dissipated energy grows only in proportion to the "
        r"distance. No inequality at $\theta>0$ excludes such walls, so $H(1)\ge0$ is "
        "necessary as well. Both conditions together are sufficient. (At equality no motion gains "
        "energy either: the strict sign is slightly stronger than passivity.)"
    )
    _settle(page, b > needed)


def _settle(page, condition):
    """(4) guarantees passivity if H(1) >= 0."""
    claim = page.claim("eq4")
    given = taken_apart(claim)[1]
    theorem = as_claimed(claim, no_motion_gains(given[-1]), PUSHES)
    page.say(
        "A wall that is computed from three positions, the latest of them $d$ periods old, has "
        "$H=(h_0+h_1/z+h_2/z^2)z^{-d}$. The wall (1) has $h_0=K+B/T$, $h_1=-B/T$ and $h_2=0$. The "
        "stiffness of a wall is $H(1)=h_0+h_1+h_2$."
    )
    page.lemma(
        "No motion gains energy from a wall $(h_0+h_1/z+h_2/z^2)z^{-d}$ if and only if the wall "
        r"has $H(1)\ge0$ and meets (4) at each angle, with $\ge$ in place of $>$",
        exactly(),
        because="condition (4) is sufficient, as the paper says, and necessary except for equality",
    )
    pulls = [S.One], [S.Half, square(1 + 2 * cos(omega))]
    soft = dict(zip(TAPS, (S.One, S.Zero, S.Zero), strict=True)) | {b: S.One, T: S.One, d: S.Zero}
    pulled = soft | dict.fromkeys(TAPS, -S.One)
    page.lemma(
        r"A wall $(h_0+h_1/z+h_2/z^2)z^{-d}$ that meets (4) and has $H(1)\ge0$ delivers no energy",
        theorem,
        because="the energy of a motion is the integral of the margin over the spectrum of its "
        "displacements, plus the energy stored at the end",
        boxed=True,
    )
    page.settle(
        "eq4",
        theorem,
        condition,
        example=(soft, holds(given[-1], soft, [S.Half])),
        unless={PUSHES: (pulled, holds(given[-1], pulled, *pulls), gives_energy())},
        note="the verdict covers walls with three coefficients, $H=(h_0+h_1/z+h_2/z^2)z^{-d}$ with "
        "an integer $d$. The wall (1) is one of them; other $H$ are not decided. At equality no "
        "motion gains energy either, so (4) is sufficient, and necessary except for equality",
        shows="a wall with three coefficients, $H=(h_0+h_1/z+h_2/z^2)z^{-d}$, may have $H(1)<0$: "
        "$H=-(1+1/z+1/z^2)$ satisfies (4) for every damper, and delivers energy",
    )


# Passive walls h_0 + h_1/z + h_2/z^2: (4) for any three coefficients.

PUSHES = Add(*TAPS) >= 0
"""H(1) >= 0: the static stiffness is not negative."""

_WHOLE = tuple(is_whole(d + late, assume(whole(d))) for late in (1, 2))


def by_angle() -> Theorem:
    """passive <=> H(1) >= 0 and the margin is not negative at any angle."""
    return toeplitz(ANSWER, z, b / T, theta)


def exactly() -> Theorem:
    """The equivalence of `by_angle` for T > 0 and an integer delay."""
    return closed(by_angle(), *apart(), *_WHOLE)


def no_motion_gains(frequencies: Any) -> Theorem:
    """A wall with H(1) >= 0 that meets (4) at every frequency is passive."""
    angle, period = theta / T, over(1 / T > 0, one(), T > 0)
    inside = (over(angle > 0, theta > 0, T > 0), over(angle < pi / T, assume(theta < pi), T > 0))
    met = at(assume(frequencies), {omega: angle}, *inside)
    energy = by_angle()
    static, always = energy.conclusion.of[1].of
    margin = closed(positive(always.body.of[1], [met, period]), *divisors(theta), *apart())
    found = follows(energy, assume(static), for_all([theta], INSIDE, margin))
    return closed(found, *apart(), *_WHOLE)


def apart() -> tuple[Theorem, ...]:
    return (positive(Ne(T, 0), T > 0),)


def holds(frequencies: Any, point: Mapping[Any, Any], *margin: Any) -> Theorem:
    """(4) at every frequency for given numbers; its margin is a sum of products."""
    relation = frequencies.body.of[1].at(point)
    half = sine_of_half(omega)
    turned = not_zero(positive(1 - cos(omega) > 0, [2, half, half]))
    found = closed(combined(relation, *margin), turned)
    return for_all([omega], [omega > 0, omega < pi], found)


def gives_energy() -> Theorem:
    """The wall -(1 + 1/z + 1/z^2) delivers energy although b/T = 1."""
    energy = toeplitz(ANSWER.subs(dict.fromkeys(TAPS, -1) | {d: 0}), z, S.One, theta)
    static, _ = energy.conclusion.of[1].of
    negative = denied(combined(Relation(S(-3), "<", S.Zero), [3]), static)
    gains = denied_by(energy, not_all(energy.conclusion.of[1], negative))
    return closed(gains, *map(is_whole, map(Integer, range(3))))
