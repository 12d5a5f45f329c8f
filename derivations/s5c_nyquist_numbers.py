r"""Is the limit of the spring ten thousand times the stiffness of an arm?

The Nyquist frequency is reached at $\gamma=\pi^2+\delta^2/4$. In units of a device that is Example
5.1 of the paper; against the arms of Table II it is a large factor, but which one?
"""

from sympy import Eq, I, Rational, S, pi, sqrt

from symhaptic.model import plant
from symhaptic.model.plant import Plant
from symhaptic.notation import T, b, delta, k, k_H, m
from symhaptic.proof import box
from symhaptic.proof.sign import number

DEVICE = {m: Rational(1, 10), T: Rational(1, 1000)}
"""Example 5.1, in kg and s."""

HOGAN = {m: Rational(8, 10), k_H: S(568), T: Rational(1, 1000)}
"""The stiffest arm for its mass in Table II, of those that the paper keeps."""

IN_23 = r"0\le\delta\le0.02"


def derive(page):
    spring = pi**2 * m / T**2 + b**2 / (4 * m)
    one, two = Plant().poles(2 * I * sqrt(k / m - b**2 / (4 * m**2)))
    page.step(
        "A spring that reaches the Nyquist frequency",
        (((one - two) / (2 * I)) ** 2).subs(k, spring),
        (pi / T) ** 2,
        name=r"\omega^2\big|_{k=\pi^2m/T^2+b^2/(4m)}",
        because="by (28), for a device that swings",
        paper="31",
    )
    example(page, spring)
    arms(page)


def example(page, spring):
    """Example 5.1."""
    device = spring.subs(DEVICE)
    page.step("For $m=0.1$ kg and $T=1$ ms", device, 100000 * pi**2 + Rational(5, 2) * b**2, name=k)
    page.say(
        "which is $986\\,960.44\\ldots$ N/m without damping. It rounds to 987 000 N/m as long "
        "as $2.5\\,b^2<540$ (in SI units), $b\\le14.6$ Ns/m; (23) has $b\\le0.02m/T=2$ Ns/m:"
    )
    wide = {b: (0, Rational(146, 10))}
    rounds = page.positive(
        "It rounds to the printed number",
        box.positive(987500 - device, wide),
        r"0\le b\le14.6\ \mathrm{Ns/m}",
        name="987\\,500-k",
    )
    page.settle(
        "eq31",
        Eq(k, spring),
        value=device.subs(b, 0),
        note=r"the number is that of $b=0$; it holds for $b\le14.6$ Ns/m, and (23) has $b\le2$",
    )
    share = b**2 / (4 * m) / (pi**2 * m / T**2)
    relative = page.step(
        "The share of the damping",
        share.subs(b, delta * m / T),
        delta**2 / (4 * pi**2),
        name=r"\frac{b^2/(4m)}{\pi^2m/T^2}",
        because="of the stiffness without damping, for every device",
    )
    least = page.positive(
        "It is marginal",
        box.positive(Rational(102, 10**7) - relative, {delta: (0, Rational(1, 50))}),
        IN_23,
        name=r"1.02\cdot10^{-5}-\frac{\delta^2}{4\pi^2}",
    )
    page.settle("s5c-marginal-b", least, rounds, note=r"less than $1.02\cdot10^{-5}$ inside (23)")


def arms(page):
    """Against arms."""
    page.say(
        "In units of mass and period the limit is $\\gamma=\\pi^2$ to $\\pi^2+0.0001$. The range "
        "(23) ends at $\\gamma=0.001$:"
    )
    ratio = 1000 * pi**2
    grown = page.positive(
        "With damping",
        box.positive(Rational(98698, 10) - 1000 * (pi**2 + delta**2 / 4), {delta: (0, S(1) / 50)}),
        IN_23,
        name=r"9869.8-\frac{\pi^2+\delta^2/4}{0.001}",
        because="and $1000\\pi^2=9869.604\\ldots$ without",
    )
    page.settle(
        "s5c-human-10000",
        value=ratio,
        note=r"$T=1$ ms. (23) was extended: the $710\,\mathrm{s}^{-2}$ of (21) give "
        r"$\pi^2/0.00071=13\,900$, and faster sampling more in proportion to $1/T^2$",
    )
    frequency = plant.Plant(damping=None).poles()[0]
    page.same("without damping", (frequency.subs(k, spring_of(m)) / I) ** 2, (pi / T) ** 2)
    page.say(
        "These are stiffnesses per moving mass. As stiffnesses they compare only if the mass is "
        "that of the arm: Hogan's arm, 0.8 kg and 568 N/m, would need $k=\\pi^2m/T^2$, and the "
        "device of Example 5.1 alone, 0.1 kg, much less:"
    )
    for title, mass in (("Hogan's arm", HOGAN[m]), ("The device against that arm", DEVICE[m])):
        limit = spring_of(mass).subs(T, HOGAN[T]) / HOGAN[k_H]
        page.step(title, limit, mass * 10**6 * pi**2 / 568, name=r"\frac{\pi^2m}{T^2k_H}")
    less = page.positive(
        "Less than 5000, which is not 10000 to one digit",
        number(5000 - spring_of(DEVICE[m]).subs(T, HOGAN[T]) / HOGAN[k_H]),
        r"m=0.1\ \mathrm{kg},\ k_H=568\ \mathrm{N/m}",
        name=r"5000-\frac{\pi^2m}{T^2k_H}",
        because="it is about 1740",
    )
    page.settle(
        "s6-human-10000",
        less,
        grown,
        provided=r"k/m\ \text{is compared},\ T=1\,\mathrm{ms}",
        unless={m: DEVICE[m], T: HOGAN[T], k_H: HOGAN[k_H]},
        truth=spring_of(m) > 5000 * k_H,
        shows=r"the 987\,000 N/m of Example 5.1 are 1740 times the stiffness of an arm of 568 N/m",
        note=r"with the stiffness per mass of (21) it is 13\,900 times, of (23) 9870",
    )


def spring_of(mass):
    """Stiffness that brings an undamped mass to the Nyquist frequency."""
    return pi**2 * mass / T**2
