"""Is a passive wall stable, whatever the delay?

Passivity is a condition on energies, and stability is a condition on roots. Both conditions contain
the delay. For a root on the unit circle the delay cancels, and the device alone decides.
"""

from symhaptic.book.figures.arguments import sides
from symhaptic.book.lemmas.connections import (
    DAMPED_DEVICE,
    HELD,
    passive_wall_is_stable,
    stays_on_circle,
)
from symhaptic.book.lemmas.one_plane import held_passive_is_stable
from symhaptic.book.lemmas.passive_is_stable import no_crossing, passive_is_stable
from symhaptic.book.lemmas.prelude import *
from symhaptic.book.lemmas.undelayed import passive_in_numbers
from symhaptic.book.lemmas.walls import margins
from symhaptic.paper.propositions.comparison import passive


def derive(page):
    page.say(
        "We use units of mass and period. Let $P=N/A$ be the sampled device with $A=z^2-az+e$ "
        r"and $N=n_1z+n_0$, and let $W(z)=(\alpha+\beta(1-1/z))z^{-d}$ be the wall with its "
        "delay. At a root of the loop, $1+PW=0$, so $W=-1/P$. The margin of passivity, "
        r"$\delta+\Re\{W/(z-1)\}$, becomes $\delta-\Re\{1/((z-1)P)\}$ there, and no longer "
        r"contains the delay, $\alpha$ and $\beta$. Let a held force $F$ drive the device in a "
        r"steady state that is multiplied by $z=e^{j\theta}$ per period."
    )
    page.step(
        "The work of the force is stored or dissipated",
        v * (F - delta * v - gamma * x) + gamma * x * v,
        F * v - delta * v**2,
        name=r"\tfrac{d}{dt}\,\tfrac12(v^2+\gamma x^2)",
        because=r"by Newton's law $\dot v=F-\delta v-\gamma x$, and $\dot x=v$",
    )
    page.step(
        "For a given displacement the damper dissipates least at constant speed",
        v**2,
        (v - p_k) ** 2 + 2 * v * p_k - p_k**2,
        because="over one period the last two terms integrate to $p_k^2$",
    )
    page.lemma(
        "A held force does more work than the damper dissipates at constant speed",
        held_steady_state(assume(DEVICE), theta),
        because=r"the stored energy is the same after each period, and for $z\ne1$ the speed is "
        r"not "
        "constant",
    )
    page.say(
        r"Divided by $|(z-1)N|^2$ the inequality is $\delta<\Re\{1/((z-1)P)\}$. Now take a wall "
        r"$W$ that satisfies (5) and scale it from zero: $yW$ with $0<y\le1$. At a root of the "
        r"loop on the circle, $1/P=-yW$, so $\delta+y\Re\{W/(z-1)\}<0$. But the left side is "
        r"the sum of $(1-y)\delta$ and $y$ times the margin, and neither term is negative."
    )
    page.lemma(
        "No root crosses the circle while the wall is scaled from zero to $W$",
        no_crossing(),
        because="at every angle, the condition is (5) in these units. At $z=1$ the polynomial is "
        r"$(n_1+n_0)(y\alpha+\gamma)$ by \chapter{s4d_left_bound}, which is positive for "
        r"$\alpha+\gamma>0$",
    )
    page.figure(
        "sides",
        "The curves of wall and device over the upper half circle. They meet at an angle at "
        "which a root lies on the circle. The curve of the device stays to the left of "
        r"$-\delta$. The curve of a passive wall stays to the right for every scale "
        r"($\gamma=0.05$, $\delta=0.4$, one period of delay).",
        sides,
        height=0.5,
    )
    page.lemma(
        "A wall with a margin at every angle is stable with every spring and damper",
        passive_is_stable(),
        because=r"the relation $\mathrm{stable}$ refers to the exact loop, and "
        r"$\mathrm{stable}_{(18)}$ to the roots of (18); for integer delays they are "
        "equivalent. The roots of a polynomial are continuous functions of its "
        "coefficients. Without a wall, the poles of a damped device with a spring lie "
        "inside the unit circle. Without a spring, one pole lies at 1, and a small "
        "stiffness moves it inside",
        boxed=True,
    )
    _subset(page)


def _subset(page):
    page.say(
        "The argument above is the proof for integer delays, for which (5) and (18) are exact. "
        "For other delays the proof uses the held force itself, as in "
        r"\chapter{s6e_fractional_passive_is_stable}."
    )
    exact, computed = page.claim("s5a-subset").of
    arm = {gamma: STIFF, delta: DAMPED}
    held = page.lemma(
        "A passive wall is stable with a damped device with a spring, for every delay",
        held_passive_is_stable(),
        because="the stiffness of a passive wall is not negative",
    )
    first = numbers_known(inst(held, arm))
    margin = margins(passive())
    second = closed(conjunct(passive_is_stable(), STABLE), margin)
    second = closed(second, positive(alpha + gamma > 0, alpha >= 0, gamma > 0))
    second = numbers_known(inst(second, arm))
    page.settle(
        "s5a-subset",
        conj(as_claimed(exact, first), as_claimed(computed, second)),
        note="the first theorem is about the held force and every real delay, the second about (5) "
        "and (18)",
    )
    _every_arm(page)


def _every_arm(page):
    """Without a damper, or without any stiffness, a passive wall need not be stable."""
    claim = page.claim("s6-subset")
    extra = [DAMPED_DEVICE, HELD]
    wall = dict.fromkeys((alpha, gamma, d), S.Zero)
    drift = wall | {beta: Rational(1, 2), delta: S.One}
    swing = wall | {beta: S.Zero, gamma: pi**2 / 4, delta: S.Zero}
    easy = wall | {alpha: S.One, beta: S.Zero, delta: S.One}

    def shown(point):
        return passive_in_numbers({K: point[alpha], B: point[beta], b: point[delta], T: S.One})

    page.settle(
        "s6-subset",
        as_claimed(claim, passive_wall_is_stable(), *extra),
        example=(easy, shown(easy)),
        unless={
            HELD: (drift, *(shown(drift), stays_on_circle(drift, S.Zero))),
            DAMPED_DEVICE: (swing, *(shown(swing), stays_on_circle(swing, pi / 2))),
        },
        shows="with a passive wall without stiffness a free mass drifts, and without a damper a "
        "spring oscillates forever",
        note="the proof uses the energy of the held force and holds for every real delay",
    )
