"""The rules, each with who uses it."""

from __future__ import annotations

from symhaptic.paper.statement import Source, Statement

SOURCE = Source("rules", "Rules in circulation", where="articles, course notes and simulation code")

RULES = (
    Statement(
        "rules:twice-damping",
        "Colgate and Schenkel, 1997, for $B=0$",
        "a stiffness up to twice the damping over the period is stable",
        (r"K \leq \frac{2b}{T}",),
        condition=True,
    ),
    Statement(
        "rules:damping-over-delay",
        "Gil et al., 2004, and Hulin et al., 2006",
        "a stiffness below the damping over the delay, the half period of the hold included, "
        "is stable",
        (r"K < \frac{b+B}{t_d+T/2}",),
        condition=True,
    ),
    Statement(
        "rules:four-masses",
        "course notes on haptic rendering",
        "a stiffness below four masses over the squared period is stable",
        (r"K < \frac{4m}{T^2}",),
        condition=True,
    ),
    Statement(
        "rules:two-masses",
        "simulation code",
        "a stiffness below two masses over the squared period is stable",
        (r"K < \frac{2m}{T^2}",),
        condition=True,
    ),
    Statement(
        "rules:damped-contact",
        "simulation code",
        "a stiffness below this bound of the virtual damping is stable for a free mass without "
        "delay",
        (r"K < \frac{2B}{T} - \frac{B^2T}{2m}",),
        condition=True,
    ),
)
"""What each of them says; where no delay is named, none is meant to matter."""
