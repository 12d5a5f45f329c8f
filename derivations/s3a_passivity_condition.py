"""When is a delayed virtual wall passive?

A wall of stiffness $K$ and damping $B$, rendered with period $T$ and a delay of $d$ periods, is
coupled to a device that dissipates energy only by its damping $b$. We ask for which $(K,B)$ no
motion of the device can extract energy.
"""

from symhaptic.book.lemmas.largest_damping import divisors, margins
from symhaptic.book.lemmas.mass import no_mass_differs, of_mass
from symhaptic.book.lemmas.motions import HALF_LATE, STEPS
from symhaptic.book.lemmas.passivity import PASSIVE, every_margin, passive_by_angle
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import passive_in_numbers
from symhaptic.model import wall
from symhaptic.paper.propositions.passivity import FIVE, at_every_frequency


def derive(page):
    response = page.define("The wall with a delay of $d$ periods", r"H(z)\,z^{-d}", wall.delayed())
    need = passivity.required_damping(response)
    brackets = (
        K * T * (cos(d * theta) - cos((d + 1) * theta))
        + B * (cos(d * theta) - 2 * cos((d + 1) * theta) + cos((d + 2) * theta))
    ) / (2 - 2 * cos(theta))
    page.step(
        "Only the real part of the wall's response times $1-1/z$ matters",
        need,
        brackets,
        paper="5",
        name=r"\frac{T}{2}\,\frac{\Re\{(1-1/z)H(z)z^{-d}\}}{1-\cos\theta}\Big|_{z=e^{j\theta}}",
        because="the transfer function of the wall is inserted into the energy balance, with "
        r"$\theta=\omega T$",
    )
    page.step(
        "The coefficient of the stiffness is Dirichlet's kernel",
        cos(d * theta) - cos((d + 1) * theta),
        2 * sin(theta / 2) * sin((d + Rational(1, 2)) * theta),
    )
    page.step(
        "The coefficient of the damping is a cosine",
        cos(d * theta) - 2 * cos((d + 1) * theta) + cos((d + 2) * theta),
        -(2 - 2 * cos(theta)) * cos((d + 1) * theta),
    )
    page.step(
        r"The required damping is that of (5), for every real $d$ and every $0<\theta<\pi$",
        need,
        passivity.dirichlet_form(),
        name=r"b_{\min}(\theta)",
        boxed=True,
        because="the previous two steps give its two terms, Dirichlet's kernel and a cosine; the "
        "mass does not occur",
    )
    page.lemma(
        r"With an integer delay a wall is passive if and only if $K\ge0$ and the damper "
        "dissipates enough at each angle",
        passive_by_angle(),
        because="the energy of a motion is the integral of the margin over the spectrum of its "
        "displacements, plus the energy stored in the spring at the end",
        boxed=True,
    )
    _mass(page)
    page.say(
        "A spring of negative stiffness, $K=-1$ without delay, meets (5), but four equal steps "
        "gain the energy 2. With a delay of half a period, the factor $z^{-d}$ is not exact. Let "
        r"the device move by $\tfrac32$ in the first half of each period and by 1 in the second "
        "half, and let it return after 30 periods."
    )
    page.step(
        "Damper and wall receive this energy from the motion",
        passivity.half_late_energy(Rational(3, 2), S.One, 30),
        390 * b / T + 345 * B / T - 1605 * K / 4,
        name="E",
        because=r"for $K=1$, $B=0$, $b=\tfrac{101}{100}$ and $T=1$ this energy is "
        r"$-\tfrac{147}{20}$, although (5) requires only $b>\cos\frac\theta2$",
    )
    _settle(page, b > brackets.subs(theta, omega * T))


def _mass(page):
    """The energy stored in the mass is not negative, and is zero at rest."""
    why = "a motion that ends at rest returns its energy, which is otherwise not negative"
    page.lemma("Passivity does not depend on the mass", of_mass(x), because=why)
    theorem = no_mass_differs(x, y)
    point = {x: S.One, y: S(2), K: S.One, B: S.Zero, b: S.One, T: S.One, d: S.Zero}
    page.settle("s3a-mass-free", theorem, example=point)


def _settle(page, printed):
    """For integer delays and K >= 0, (5) is equivalent to passivity, except for equality."""
    claim = CLAIMED["eq5"]((printed,))
    frequencies, passive = taken_apart(claim)[2].of
    extra = [whole(d), K >= 0, off_border()]
    enough = follows(passive_by_angle(), assume(K >= 0), margins(frequencies))
    page.lemma(r"With an integer delay a wall with $K\ge0$ that meets (5) is passive", enough)
    needed = page.lemma(
        r"With an integer delay every passive wall meets (5) with $\ge$ in place of $>$",
        frequencies_met(frequencies),
        because="the energy of a motion near one frequency is given by the margin at this "
        "frequency",
    )
    both = either_way(enough, needed, frequencies, passive)

    half, quarter = S.Half, S.Half / 2
    late = {K: S.One, B: S.Zero, b: Rational(101, 100), T: S.One, d: half}
    pulled = {K: -S.One, B: S.Zero, b: S.One, T: S.One, d: S.Zero}
    border = {K: S.One, B: S.Zero, b: half, T: S.One, d: S.Zero}
    soft = {K: S.Zero, B: half, b: S.One, T: S.One, d: S.Zero}

    slow = [half, square(1 - cos(omega / 2))], [half, bounded(cos, omega / 2)]
    full = [quarter, square(1 + cos(omega))], [quarter, bounded(cos, omega)]
    fractional = holds(claim, late, *slow, [Rational(1, 100)])
    light = holds(claim, pulled, [Rational(3, 2)])
    easy = holds(claim, soft, *full, [half])

    page.settle(
        "eq5",
        as_claimed(claim, both, *extra),
        printed,
        example=(soft, apart(easy)),
        unless={
            whole(d): (late, *(gaining(claim, late, fractional, HALF_LATE), apart(fractional))),
            K >= 0: (pulled, *(gaining(claim, pulled, light, STEPS), apart(light))),
            off_border(): (border, *on_the_border(claim, border)),
        },
        shows="with a delay of half a period, (5) holds at every frequency, yet a motion extracts "
        "$147/20$",
        note="condition (5) is equivalent to (4) with $z^{-d}$ for every real $d$. For a "
        "fractional delay of the held force, (5) allows some walls that are not passive and "
        r"excludes some passive walls. At equality no motion gains energy either: with $\ge$ "
        "in (5) the last condition of the verdict is not needed",
    )


# (5) is equivalent to passivity for integer delays and K >= 0, except for equality.


def frequencies_met(frequencies: Any) -> Theorem:
    """A passive wall that meets (5) with equality at no frequency meets (5) at each one."""
    angle = omega * T
    inside = (
        positive(angle > 0, [omega > 0, T > 0]),
        closed(positive(angle < pi, [omega < pi / T, T > 0]), not_zero(assume(T > 0))),
    )
    always = conjunct(mp(passive_by_angle(), assume(PASSIVE)), every_margin())
    weak = positive(b >= FIVE.rhs, [at(always, {theta: angle}, *inside)])
    below = closed(closed(weak, *divisors(angle)), *inside, not_zero(assume(T > 0)))
    apart = at(assume(off_border()), {omega: omega}, *map(assume, INSIDE_BAND))
    return for_all([omega], frequencies.body.of[0].of, strictly(below, apart))


INSIDE_BAND = (omega > 0, omega < pi / T)


def off_border() -> Proposition:
    """The required damping differs from b at every frequency."""
    return at_every_frequency(Ne(b, FIVE.rhs))


def on_the_border(claim: Proposition, point: Terms) -> tuple[Theorem, Theorem]:
    """A passive spring whose required damping equals b at every frequency does not meet (5)."""
    same = taken_apart(claim)[2].at(point)
    passive = passive_in_numbers(point)
    inside = [fact(proposition(p).at({omega: S.One, T: S.One})) for p in INSIDE_BAND]
    met = at(mp(assume(same), passive), {omega: S.One}, *inside)
    need = met.conclusion.left
    equal = identity(need, point[b])
    equal = closed(equal, *map(fact, equal.hypotheses))
    denied_ = off_border().at(point)
    apart = at(assume(denied_), {omega: S.One}, *inside)
    return not_intro(met, equal, same), not_intro(apart, equal, denied_)


INSIDE = (omega > 0, omega < pi)
"""The frequencies for T = 1."""


def holds(claim: Proposition, point: Terms, *products: Any) -> Theorem:
    """(5) at every frequency for a wall in numbers; its margin is a sum of products."""
    frequencies = taken_apart(claim)[2].parts[0]
    relation = frequencies.body.of[1].at(point)
    return for_all([omega], INSIDE, closed(combined(relation, *products), *divisors(omega)))


def apart(met: Theorem) -> Theorem:
    """For a wall that meets (5), the required damping differs from b at every frequency."""
    there = at(met, {omega: omega}, *map(assume, INSIDE))
    need, damping = there.conclusion.terms
    return for_all([omega], INSIDE, positive(Ne(damping, need), [there]))


def gaining(claim: Proposition, point: Terms, met: Theorem, motion: Any) -> Theorem:
    """The wall meets (5), but a motion gains energy."""
    there = taken_apart(claim)[2].at(point)
    return not_intro(mp(assume(there), met), gains(list(point.values()), motion), there)
