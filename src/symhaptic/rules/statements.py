"""The rules, each with its users."""

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
        "a stiffness below the damping over the delay is stable; the delay includes the half "
        "period of the hold",
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
        "for a free mass without delay a stiffness below this bound, which depends on the "
        "virtual damping, is stable",
        (r"K < \frac{2B}{T} - \frac{B^2T}{2m}",),
        condition=True,
    ),
    Statement(
        "rules:euler-for-devices",
        "the limit of a simulator, used for a device",
        "a stiffness below the limit of a simulator is stable for a free mass without delay",
        (r"K < \frac{4m}{T^2} - \frac{2B}{T}",),
        condition=True,
    ),
    Statement(
        "rules:two-dampings",
        "the limit for a measured velocity, used for the difference of two samples",
        "for a free mass without delay a stiffness below twice the virtual damping over the "
        "period is stable",
        (r"K < \frac{2B}{T}",),
        condition=True,
    ),
)
"""The rules; a rule that names no delay is meant for every delay."""

OTHER_LOOPS = (
    Statement(
        "rules:average-damping",
        "for a damper with an exponential average of the velocity, with the pole $f_v$",
        "a wall is passive if the damping of the device outweighs the stiffness and the part of "
        "the virtual damping that passes the filter",
        (r"b \geq \frac{KT}{2} + B\frac{1-f_v}{1+f_v}", r"b \geq \frac{KT}{2} - B"),
        condition=True,
    ),
    Statement(
        "rules:plain-damping",
        "Colgate and Schenkel, 1997, used for walls with a filter and with a delay",
        "a wall that is passive with the difference of two samples is also passive with a filter "
        "and with a delay",
        (r"b > \frac{KT}{2} + |B|",),
        condition=True,
    ),
    Statement(
        "rules:virtual-mass",
        "design notes of haptic software",
        "a virtual mass is passive up to half of the damping times the period",
        (r"m_v \leq \frac{bT}{2}",),
        condition=True,
    ),
    Statement(
        "rules:virtual-wall",
        "for a virtual mass with a spring and a damper",
        "a wall is passive if the damping of the device outweighs spring, damper and virtual "
        "mass together",
        (r"b \geq \frac{KT}{2} + B + \frac{2m_v}{T}",),
        condition=True,
    ),
    Statement(
        "rules:virtual-mass-stable",
        "design notes of haptic software",
        "a virtual mass is stable up to twice the mass of the device",
        (r"m_v < 2m",),
        condition=True,
    ),
    Statement(
        "rules:semi-implicit-euler",
        "simulation code, for steps $v'=v+TF/m$, $x'=x+Tv'$",
        "a mass with a spring and a damper is stable if and only if these bounds hold",
        (r"0 < K < \frac{4m}{T^2} - \frac{2B}{T}", r"B > 0"),
        condition=True,
    ),
    Statement(
        "rules:euler-explicit",
        "simulation code, for steps $v'=v+TF/m$, $x'=x+Tv$",
        "a mass with a spring and a damper is stable if and only if these bounds hold",
        (r"0 < K < \frac{B}{T}", r"\frac{2B}{T} - \frac{4m}{T^2} < K"),
        condition=True,
    ),
    Statement(
        "rules:both-below-two",
        "checks of gains in simulation code",
        "a spring and a damper are stable in a simulator if $KT^2/m$ and $BT/m$ are both below two",
        (r"\frac{KT^2}{m} < 2", r"\frac{BT}{m} < 2"),
        condition=True,
    ),
    Statement(
        "rules:one-mass",
        "simulation code with semi-implicit Euler",
        "a stiffness below one mass over the squared period is stable",
        (r"K < \frac{m}{T^2}",),
        condition=True,
    ),
    Statement(
        "rules:known-velocity",
        "for a wall with a measured velocity",
        "a free mass without delay is stable if and only if these bounds hold",
        (r"0 < K < \frac{2B}{T}", r"B < \frac{2m}{T}"),
        condition=True,
    ),
    Statement(
        "rules:low-pass-mass",
        r"for a damper with a low-pass filter, $1/(\tau_fs+1)$ by backward Euler",
        "a free mass without delay is stable if and only if these bounds hold",
        (r"K > 0", r"B > 0", r"\tau_f(T+2\tau_f)K^2 + (2m+B(T+4\tau_f))K < \frac{2B(2m-BT)}{T}"),
        condition=True,
    ),
    Statement(
        "rules:filter-as-delay",
        "for a damper with a low-pass filter that is counted as a delay",
        "for a free mass a stiffness below the damping over all delays, including that of the "
        "filter, is stable",
        (r"K < \frac{B}{T/2+\tau_f}",),
        condition=True,
    ),
    Statement(
        "rules:lag-as-delay",
        "for an actuator with a lag that is counted as a delay",
        "for a free mass no stiffness above the damping over all delays, including that of the "
        "lag, is stable",
        (r"K < \frac{B}{T/2+\tau_a}",),
        condition=True,
    ),
    Statement(
        "rules:lag-below-delay",
        "the same advice, taken as safe for every device",
        "a wall that is stable with a delay is stable with an equal or smaller lag of the "
        "actuator, for every spring of the device",
        (r"\tau_a \leq t_d",),
        condition=True,
    ),
    Statement(
        "rules:counts-and-friction",
        "Abbott and Okamura, 2005, for $B=0$",
        "damping dissipates the energy that sampling adds, and friction the energy that an "
        "encoder adds",
        (r"K \leq \frac{2b}{T}", r"K \leq \frac{2f_c}{\Delta_x}"),
        condition=True,
    ),
    Statement(
        "rules:energy-leak",
        "open courses, for $B=0$",
        "in a period at the speed $v$ a spring delivers the energy $K(vT)^2/2$ and a damper "
        "dissipates $bv^2T$; the wall is passive if the ratio of these energies is at most one",
        (r"\frac{KT}{2b} \leq 1",),
        condition=True,
    ),
    Statement(
        "rules:delay-damping",
        "open courses, for $B=0$",
        "a delay requires the damping $Kt_d$, in addition to the $KT/2$ that the hold requires",
        (r"b \geq \frac{KT}{2} + Kt_d",),
        condition=True,
    ),
)
"""Rules for loops with parts that the loop of the paper does not have."""
