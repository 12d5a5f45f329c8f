r"""Is a virtual coupling passive if its damper exceeds $KT/2$?

A laboratory renders a mass of 2.4 kg with a delta.3 device, and its design record is public. The
record explains why a force proportional to the measured acceleration cannot render this mass.
Instead, a computer simulates the mass by backward Euler, and a spring and a damper couple it to the
device. We check each number and each relation of the record.
"""

from symhaptic.book.lemmas.decided import SI, escapes
from symhaptic.book.lemmas.filtered_wall import decides
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.prelude import show
from symhaptic.book.lemmas.undelayed import by_sign_of_damping
from symhaptic.book.lemmas.virtual_mass import free, swings_up
from symhaptic.book.sources import STATEMENTS
from symhaptic.notation import f_v, m_v
from symhaptic.rules.coupling import AFTER, BEFORE, NEXT_V, NEXT_X, SPRUNG, STEP

DAMPER, HEAVY, BESIDE, IMPLICIT = (
    f"coupling:{name}" for name in ("damper", "stable-mass", "beside-spring", "implicit")
)
RATE = Rational(1, 4000)
RIGHT = r"b \geq \frac{KT}{2} + |B|"


def derive(page):
    _damper(page)
    _implicit(page)
    _masses(page)
    _numbers(page)


def _damper(page):
    """If the simulated mass is held, the coupling is a wall."""
    page.say(
        "The device is at $x$ and the simulated mass at $x_s$. The force of the coupling is "
        "$K(x_s-x)+B(v_s-v)$. A coupling that is passive with every mass is also passive with a "
        "very heavy one, which does not move. The coupling is then a wall."
    )
    [right] = read(RIGHT)
    found = page.lemma(
        "A coupling is passive if the damping of the device outweighs both its spring and its "
        "damper",
        passive_by_device(right),
        boxed=True,
    )
    wall = {K: S(2), B: S.One, b: S.One, T: S.One}
    page.settle(
        DAMPER,
        found,
        corrected=[RIGHT],
        misprint=False,
        example=wall | {b: S(2)},
        unless=[(wall, drives(wall))],
        shows="the coupling $K=2$, $B=T=b=1$ satisfies the condition of the record and delivers "
        "energy; it requires $b=2$",
        note="the damper that has to exceed $KT/2$ is that of the device. The virtual damper "
        "requires additional damping, so a larger $B$ leaves less margin for the coupling",
    )


def _implicit(page):
    """The energy of a mass that backward Euler simulates."""
    symbols, given, _ = taken_apart(page.claim(IMPLICIT))
    page.say(
        "Backward Euler maps $x$ and $v$ to $p=x+Tq$ and $q=v-Tkp/m$. The energy is "
        "$\\frac12mv^2+\\frac12kx^2$ before and $\\frac12mq^2+\\frac12kp^2$ after the step."
    )
    found = page.lemma(
        "A step of backward Euler never raises the energy of a mass and a spring",
        loses_energy(),
        because=r"the step dissipates $\frac12m(v-q)^2+\frac12k(x-p)^2$",
        boxed=True,
    )
    step = {m: S.One, k: S.One, T: S.One, x: S.One, v: S.Zero}
    step |= {NEXT_X: S.Half, NEXT_V: -S.Half}
    page.settle(
        IMPLICIT,
        found,
        instead=every(symbols, given, AFTER <= BEFORE),
        corrected=[r"\text{the energy does not grow; each step that moves loses some}"],
        misprint=False,
        example=step,
        unless=[step],
        shows="for $m=k=T=1$ and a start from $x=1$ at rest, half of the energy is left after one "
        "step",
        note="the energy never increases, as passivity requires; the method also damps an "
        "oscillation of the simulated mass",
    )


def _masses(page):
    """A virtual mass rendered from the measured acceleration."""
    slow = {m_v: Rational(3, 2), m: S.One, d: S.One}
    page.settle(
        HEAVY,
        free(),
        example=slow | {d: S.Zero},
        unless={Eq(d, 0): (slow, swings_up(slow))},
        shows=r"the virtual mass $m_v=\tfrac32m$ is unstable with a delay of one period",
        note=r"the limit is exact for a free mass without delay; see \chapter{s10b_virtual_mass}",
    )
    found = page.lemma(
        "A virtual mass that is stable together with a spring is stable alone",
        fades_alone(),
        because="the product of the roots is $m_v/(2m)$ with and without the spring, and has to "
        "be less than 1",
    )
    stiff = {m_v: S.One, m: S.One, K: Rational(1, 10), T: S.One}
    page.settle(
        BESIDE,
        found,
        example=(stiff, roots_inside(SPRUNG.at(stiff).terms[0], z, {})),
        note="the statement holds for a free mass without delay and damping",
    )
    light = {m_v: Rational(1, 4), m: S.One, K: Rational(1, 10), T: S.One}
    page.lemma(
        r"Together with the spring $KT^2/m=\frac1{10}$ a virtual mass of $\frac14m$ is not stable",
        escapes(SPRUNG, light),
        because="sampling adds more energy to the spring than such a light virtual mass dissipates",
    )


def _numbers(page):
    """The numbers of the record for a device at 4 kHz."""
    for id in ("coupling:period", "coupling:noise"):
        _, given, then = taken_apart(page.claim(id))
        at_rate = number(then.at({T: RATE}))
        at_rate = subst(then, T, at_rate, show(Eq(RATE, T), *given))
        page.settle(id, for_all([T], given, at_rate), example={T: RATE})
    page.settle("coupling:rest", number(proposition(STATEMENTS["coupling:rest"].printed[0])))
    page.say(
        "The second difference has the weights 1, $-2$ and 1. Errors of up to $e$ in three samples "
        "therefore cause an error of up to $4e/T^2$, which is 64 million times $e$."
    )
    page.settle_external(
        "coupling:passive-mass",
        "on the damping of the device, which the record does not give",
        "a virtual mass is passive up to $bT/2$, which is 12.5 mg for $b=0.1$ Ns/m, and micrograms "
        "only for $b$ of about $10^{-4}$ Ns/m or less",
    )
    page.say(
        "According to the record the device has a mass of 0.4 to 0.5 kg, so 2.4 kg is 4.8 to "
        "6 times as much. The factor of twelve in the record is the ratio to 0.2 kg, half of the "
        "smaller mass."
    )
    page.settle_slip(
        "coupling:ratio",
        "5–12×",
        r"4.8\ \text{to}\ 6",
        "the record itself names 0.4 to 0.5 kg; with half of this mass the ratio would be 9.6 to "
        "12",
    )


# A coupling by spring and damper, a virtual mass with a spring, and a step of backward Euler.


@cache
def _exact() -> Theorem:
    """passive <=> K T/2 + B <= b and K T/2 - B <= b, for K >= 0 and without a filter."""
    found = inst(decides(), {f_v: S.Zero})
    return closed(found, fact(Relation(S.Zero, "<=", S.Zero)), fact(Relation(S.Zero, "<", S.One)))


def passive_by_device(bound: Any) -> Theorem:
    """A coupling is passive if the damping of the device meets the bound."""
    fast, slow = _exact().conclusion.of[0].parts  # type: ignore[attr-defined]
    up, down = magnitude(B), magnitude(B, negative=True)
    push, brake = assume(B >= 0), positive(-B >= 0, B < 0)
    damped = conj(positive(fast, [bound], [up, -1]), positive(slow, [bound], [up, -1], [2, push]))
    driven = conj(
        positive(fast, [bound], [down, -1], [2, brake]), positive(slow, [bound], [down, -1])
    )
    return mp(_exact(), by_sign_of_damping(damped, closed(driven, positive(B <= 0, B < 0))))


def drives(point: Mapping[Any, Any]) -> Theorem:
    """The coupling with these numbers is not passive."""
    exact = inst(_exact(), point)
    exact = closed(exact, *map(fact, exact.hypotheses))
    bounds, passive = exact.conclusion.of  # type: ignore[attr-defined]
    denial = not_all(bounds, number(negated(bounds.parts[0])))
    return not_intro(mp(exact, assume(passive)), denial, passive)


def fades_alone() -> Theorem:
    """A virtual mass that is stable with a spring is stable alone."""
    last = last_coefficient(assume(SPRUNG))
    below = conjunct(last, last.conclusion.parts[1])
    at_once = inst(free(), {d: S.Zero})
    at_once = closed(at_once, identity(S.Zero, S.Zero))
    bound = at_once.conclusion.of[0]  # type: ignore[attr-defined]
    return mp(at_once, SI.closed(positive(bound, [2, m > 0, below])))


def loses_energy() -> Theorem:
    """A step of backward Euler does not increase the energy."""
    moved, sped = (assume(proposition(e)) for e in STEP)
    lost = [S.Half, m > 0, square(v - NEXT_V)], [S.Half, k > 0, square(x - NEXT_X)]
    return positive(AFTER <= BEFORE, *lost, [moved, k * NEXT_X], [sped, m * NEXT_V])
