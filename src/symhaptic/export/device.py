"""How the device moves, as routines: its poles, and what a creeping or a swinging one has.

Both poles -p and -q of the device obey p + q = delta and p q = gamma.  They are kept to twice the
precision of a float, since exp(-q) magnifies their error by q.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import sympy as sp
from sympy import Expr, exp, sqrt

from symhaptic.export.device_series import NEAR
from symhaptic.export.double_word import Fading, Wave, fading, fallen, root_low, waving
from symhaptic.export.pairs import Pair, exact, fast_two_sum, over, scaled, two_diff
from symhaptic.export.precision import Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.steps import Steps
from symhaptic.export.whole_turns import turned
from symhaptic.notation import delta, gamma

STIFF = sp.Integer(4)
"""Up to this gamma, the squared size of complex poles, power series are used."""

SOFT = sp.Rational(9, 16)
"""The part of NEAR and of STIFF up to which n1 and n0 use them."""

# -- the motion: w = delta^2/4 - gamma and both poles, to twice the precision -----------------

HALF, ROOT, REACH = sp.symbols("half root reach")
W: Pair = sp.symbols("w w_low")
MOTION = (HALF, *W, ROOT, REACH)
"""delta/2, w, sqrt |w|, and the size of the poles in parts of that up to which series serve."""

P, Q = sp.symbols("p p_low"), sp.symbols("q q_low")
"""The larger pole, or 1 where it is 0, and the other one."""

_NAMES = tuple(s.name for s in MOTION)


@dataclass(frozen=True)
class Motion:
    """What the functions of gamma and delta share."""

    half: Expr
    w: Expr
    w_low: Expr
    root: Expr
    reach: Expr

    @property
    def values(self) -> dict[Expr, Expr]:
        """All by their symbols."""
        return dict(zip(MOTION, vars(self).values(), strict=True)) | {gamma: gamma, delta: delta}


def motion(do: Steps) -> Motion:
    """The steps that find it."""
    half, w, w_low, root, reach = do.several(_NAMES, "DeviceMotion", gamma, delta)
    return Motion(half, w, w_low, root, reach)


def poles(do: Steps, m: Motion) -> tuple[Pair, Pair]:
    """Both, where they are real."""
    p, p_low, q, q_low = do.several(
        _names(*P, *Q), "RealPoles", gamma, m.half, m.w, m.w_low, m.root
    )
    return (p, p_low), (q, q_low)


def _names(*symbols: Expr) -> tuple[str, ...]:
    return tuple(s.name for s in symbols)


def of_device(do: Steps, name: str, about: str, result: Expr) -> Routine:
    """The routine of these steps, of a spring and a damper."""
    return do.routine(name, about, (gamma, delta), result)


def device_motion() -> Routine:
    """What vanishes is a small difference."""
    do = Steps()
    half = do("half", delta / 2)
    square, square_low = scaled(do, half, exact(half))
    most, lost = two_diff(do, square, gamma)
    w, w_low = fast_two_sum(do, most, do("rest", lost + square_low))
    root = do("root", sqrt(sp.Abs(w)))
    reach = do("reach", choose(w < 0, gamma / STIFF, (half + root) / NEAR))
    found = half, w, w_low, root, reach
    return do.routine("DeviceMotion", "half = delta/2, w = half^2 - gamma, its root and the size "
                      "of the poles", (gamma, delta), dict(zip(_NAMES, found, strict=True)),
                      "Motion")  # fmt: skip


def real_poles() -> Routine:
    """Their sum is delta, and their product is gamma; 1 in place of a p of 0."""
    do = Steps()
    p, p_lost = fast_two_sum(do, HALF, ROOT)
    p_low = do("p_low", p_lost + root_low(*W, ROOT))
    larger = do.nonzero(p), p_low
    found = *larger, *over(do, exact(gamma), larger)
    return do.routine("RealPoles", "the poles p = half + root and q = gamma/p",
                      (gamma, HALF, *W, ROOT), dict(zip(_names(*P, *Q), found, strict=True)),
                      "Poles", takes=("Motion",))  # fmt: skip


# -- of poles that creep ------------------------------------------------------------------------


SLOW = Fading(sp.symbols("slow slow_low"), sp.symbols("mean mean_low"))
APART = Fading(sp.symbols("ratio ratio_low"), sp.symbols("far far_low"))
"""Of both poles: exp and mean of the slower one and of their distance."""

CREEP = (*P, *SLOW.flat, *APART.flat)
FADE = sp.symbols("decayed decayed_low")
"""exp(-half) of a device with slow poles."""


def creeping_device() -> Routine:
    """What the functions of a creeping device share."""
    do = Steps()
    p, q = poles(do, Motion(HALF, *W, ROOT, REACH))
    low = do("root_low", root_low(*W, ROOT))
    found = *p, *fading(do, q).flat, *fading(do, (2 * ROOT, 2 * low)).flat
    about = "of a creeping device the pole p, exp and mean of the other one and of their distance"
    return do.routine("CreepingDevice", about, (gamma, HALF, *W, ROOT),
                      dict(zip(_names(*CREEP), found, strict=True)), "Creeping",
                      takes=("Motion",))  # fmt: skip


# -- of poles that swing ------------------------------------------------------------------------


ENVELOPE = sp.Symbol("envelope")
WAVE = Wave(sp.symbols("even even_low"), sp.symbols("wave wave_low"))
NEAR_TURNS, RISEN, SUNK, MOVED = sp.symbols("near risen sunk moved")
SWING = (ENVELOPE, *WAVE.even, *WAVE.odd, NEAR_TURNS, RISEN, SUNK, MOVED)
"""exp(-half); cos(root), sin(root)/root; whether it is near whole turns, n1, n0, n1 + n0 there."""


def swinging_device() -> Routine:
    """What the functions of a swinging device share."""
    do = Steps()
    wave = waving(do, W, ROOT)
    turns = turned(do, HALF, *W, ROOT, do("stiff", gamma))
    found = do("envelope", exp(-HALF)), *wave.even, *wave.odd, *turns
    about = (
        "of a swinging device exp(-half), cos(root), sin(root)/root and what is near whole turns"
    )
    return do.routine("SwingingDevice", about, (gamma, HALF, *W, ROOT),
                      dict(zip(_names(*SWING), found, strict=True)), "Swinging",
                      takes=("Motion",))  # fmt: skip


# -- all together -------------------------------------------------------------------------------


def slow_fade() -> Routine:
    """Of a device that is not slow it is asked by nobody."""
    do = Steps()
    small = REACH < SOFT
    fall, low = fallen(do, choose(small, HALF, 0))
    return do.routine("SlowFade", "exp(-half) of a device with slow poles, and what it misses",
                      (REACH, HALF), {"decayed": choose(small, fall, 0),
                                      "decayed_low": choose(small, low, 0)},
                      takes=("Motion",))  # fmt: skip


@dataclass(frozen=True)
class _Device:
    """All that the functions of a device share, by the symbols of what they are given."""

    m: Motion
    swing: dict[Expr, Expr]
    creep: dict[Expr, Expr]

    def swing_pair(self, pair: Pair) -> Pair:
        """A number of a swinging device, and what it misses."""
        return self.swing[pair[0]], self.swing[pair[1]]

    def creep_pair(self, pair: Pair) -> Pair:
        """The same of a creeping one."""
        return self.creep[pair[0]], self.creep[pair[1]]

    def called(self, swing: Callable[[], Routine], creep: Callable[[], Routine]) -> Expr:
        """One of both, of what it takes."""
        both = (
            sp.Function(made.name)(*(values[s] for s in made.arguments))
            for made, values in ((swing(), self.swing), (creep(), self.creep))
        )
        return choose(self.m.w < 0, *both)


def shared(do: Steps, fades: bool = False) -> _Device:
    """The steps that find it; what only slow devices need is asked for by some."""
    m = motion(do)
    known = m.values
    if fades:
        known |= zip(FADE, do.several(_names(*FADE), "SlowFade", m.reach, m.half), strict=True)
    given = m.w_low, m.root
    swing = gamma, m.half, choose(m.w < 0, m.w, 0), *given
    swings = do.several(_names(*SWING), "SwingingDevice", *swing)
    creeps = do.several(_names(*CREEP), "CreepingDevice", gamma, m.half, m.w, *given)
    return _Device(m, known | dict(zip(SWING, swings, strict=True)),
                   known | dict(zip(CREEP, creeps, strict=True)))  # fmt: skip


ROUTINES = (device_motion, real_poles, creeping_device, swinging_device, slow_fade)
PRECISE: tuple[Callable[[Precision], Routine], ...] = ()
