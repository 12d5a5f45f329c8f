"""A public design record: how a haptic device renders a heavy mass.

The record is about virtual mass, a coupling by spring and damper, and backward Euler.  Each of its
numbers and relations is a statement here.
"""

from __future__ import annotations

import sympy as sp

from symhaptic.notation import B, K, T, b, d, f_v, k, m, m_v, v, x, z
from symhaptic.notation.proposition import ForAll, Predicate, Proposition, both, implied
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.reading import Printed
from symhaptic.paper.statement import Source, Statement
from symhaptic.rules.other_loops import AVERAGED, FREELY

SOURCE = Source(
    "coupling",
    "Virtual coupling for mass rendering on an impedance-type haptic device",
    "authors of hapticore",
    "2026",
    "design record docs/adr/010 in the repository raeedcho/hapticore, commit 6ec5b61c",
)

STATEMENTS = {
    s.id: s
    for s in (
        Statement(
            "coupling:period",
            "Why the delta.3 cannot, and Consequences",
            "at 4 kHz a period takes 250 microseconds",
            (r"T = \frac{250}{1000000}",),
            domain=r"T = \frac{1}{4000}",
            quote="At 4 kHz (dt = 0.25 ms) [...] the 250 µs haptic tick budget",
        ),
        Statement(
            "coupling:noise",
            "Why the delta.3 cannot",
            "dividing by the squared period multiplies the noise of the encoder by 16 million",
            (r"\frac{1}{T^2} = 16000000",),
            domain=r"T = \frac{1}{4000}",
            quote=r"dividing by dt² amplifies encoder noise by $\sim$16,000,000×",
        ),
        Statement(
            "coupling:passive-mass",
            "Why the delta.3 cannot",
            "the largest virtual mass that is guaranteed to be passive is of the order of "
            "micrograms",
            quote="the passivity-guaranteed renderable mass is on the order of micrograms",
        ),
        Statement(
            "coupling:stable-mass",
            "Why the delta.3 cannot",
            "a virtual mass is stable up to twice the mass of the device",
            (r"m_v < 2m",),
            condition=True,
            quote="the less conservative coupled-stability boundary [...] caps out at roughly 2× "
            "the device's own effective mass",
        ),
        Statement(
            "coupling:ratio",
            "Why the delta.3 cannot",
            "a mass of 2.4 kg is 5 to 12 times the mass of the device",
            quote=r"At M = 2.4 kg, the mass-to-device-mass ratio of $\sim$5–12× substantially "
            "exceeds this limit.",
        ),
        Statement(
            "coupling:beside-spring",
            "Why the delta.3 cannot",
            "fewer virtual masses are stable together with a spring than alone",
            quote="combined spring-mass rendering has a smaller stability region than pure mass "
            "rendering alone",
        ),
        Statement(
            "coupling:rest",
            "Alternatives considered",
            "to render 2.4 kg with a device of 0.4 kg, a virtual mass of 2.0 kg is required",
            (r"2.4 - 0.4 = 2.0",),
            quote="M_additional = $2.4 - 0.4 = 2.0$ kg needs active rendering",
        ),
        Statement(
            "coupling:implicit",
            "Rationale, 1",
            "the energy of a mass and a spring is constant in a simulation by backward Euler",
            quote="an implicit (backward Euler) integrator, which guarantees discrete-time energy "
            "conservation of the simulation",
        ),
        Statement(
            "coupling:damper",
            "Rationale, 3",
            "a coupling is passive if its damper is at least half its stiffness times the period",
            (r"B \geq \frac{TK}{2}",),
            condition=True,
            quote="The coupler parameters are chosen per the Adams-Hannaford two-port passivity "
            r"criterion: $B_{vc} \geq T \cdot K_{vc} / 2$.",
        ),
    )
}

PASSIVE = AVERAGED.at({f_v: sp.S.Zero})
"""A spring and a damper to a fixed point; the velocity is the difference of two samples."""

ALONE = FREELY.at({d: sp.S.Zero})
"""A free mass with a virtual mass alone, without delay."""

SPRUNG = Predicate(
    "stable",
    (z,),
    (z**2 * (z - 1) ** 2 + (z + 1) / 2 * (K * T**2 / m * z**2 + m_v / m * (z - 1) ** 2),),
)
"""A virtual mass together with a spring, for a free mass without delay."""

NEXT_X, NEXT_V = sp.symbols("p q")
"""Position and velocity after a step."""

STEP = (sp.Eq(NEXT_X, x + T * NEXT_V), sp.Eq(NEXT_V, v - T * k * NEXT_X / m))
"""A step of backward Euler: the change is computed from the values after the step."""

BEFORE, AFTER = ((m * speed**2 + k * way**2) / 2 for way, speed in ((x, v), (NEXT_X, NEXT_V)))
"""The energy of mass and spring."""


@claims("coupling:period", "coupling:noise")
def _in_numbers(printed: Printed) -> Proposition:
    """At the rate that the record names."""
    return ForAll((T,), implied([sp.Eq(T, sp.Rational(1, 4000))], both(printed)))


@claims("coupling:rest")
def _difference(printed: Printed) -> Proposition:
    return both(printed)


@claims("coupling:damper")
def _damper(printed: Printed) -> Proposition:
    """With every damping of the device, including none."""
    return ForAll((K, B, b, T), implied([T > 0, b >= 0, K >= 0, *printed], PASSIVE))


@claims("coupling:beside-spring")
def _beside_spring(printed: Printed) -> Proposition:
    """A virtual mass that is stable together with a spring is stable alone."""
    given = [m > 0, T > 0, K > 0, m_v >= 0, SPRUNG]
    return ForAll((K, m_v, m, T), implied(given, ALONE))


@claims("coupling:implicit")
def _implicit(printed: Printed) -> Proposition:
    """From every state, with every step."""
    over = (x, v, NEXT_X, NEXT_V, m, k, T)
    return ForAll(over, implied([m > 0, k > 0, T > 0, *STEP], sp.Eq(AFTER, BEFORE)))
