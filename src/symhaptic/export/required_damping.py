"""What a wall needs at its worst angle, as routines: that angle is searched for."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import sympy as sp
from sympy import Expr, Symbol, atan2, cos, floor, pi, sin, sqrt

from symhaptic.export.pairs import exact, minus, over, plus, rounded, scaled
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Routine, choose
from symhaptic.export.search import crossing
from symhaptic.export.steps import Steps
from symhaptic.forms import required_damping, stiffest_passive
from symhaptic.forms.entire import CosNext, Sinc, SinNext
from symhaptic.notation import alpha, beta, d, epsilon, l, phi, psi, theta

_WALL = (alpha, beta, l, epsilon)
_WHOLE = (alpha, beta, l, psi)

_FIRST = 4
"""Angles (l + 1) theta up to here hold the first zero of Lead, and no second one."""

_whole = sp.Eq(epsilon, 0)


def straight() -> Routine:
    """What straight motions need, its products and its quotient not rounded one by one."""
    do = Steps()
    stiffness, damping, k, angle = given = sp.symbols("stiffness damping k angle")
    order = do("order", 2 * k + 1)
    wave, near = do("wave", Sinc(order * angle)), do("near", 2 * Sinc(angle))
    kernel = over(do, scaled(do, order, exact(wave)), exact(near))
    along = do("along", CosNext(k, 2 * angle))
    found = minus(do, scaled(do, stiffness, kernel), scaled(do, damping, exact(along)))
    return do.routine("Straight", "what straight motions need at a whole delay of k periods",
                      given, rounded(found))  # fmt: skip


def straight_at() -> Routine:
    """The same of angles that the delay turns many times, too."""
    do = Steps()
    stiffness, damping, k, angle = given = sp.symbols("stiffness damping k angle")
    half = do("half", angle / 2)
    wave, along = do("wave", SinNext(2 * k, half)), do("along", CosNext(k, angle))
    kernel = over(do, exact(wave), exact(do("near", 2 * sin(half))))
    found = minus(do, scaled(do, stiffness, kernel), scaled(do, damping, exact(along)))
    return do.routine("StraightAt", "what straight motions need at an angle behind k whole periods",
                      given, rounded(found))  # fmt: skip


def between() -> Routine:
    """A mean; the difference is rounded before it is weighted."""
    do = Steps()
    share, early, late = given = sp.symbols("share early late")
    more = do("more", late - early)
    return do.routine("Between", "early + share (late - early)", given, early + share * more)


def damping_at() -> Routine:
    """The damping that the wall needs at an angle."""
    do = Steps()
    early, late = do("early", required_damping.straight(l)), required_damping.straight(l + 1)
    n = do("n", required_damping.between(early, late))
    root = do("root", sqrt(n * n + required_damping.extra()))
    return do.routine("DampingAt", "the damping that the wall needs at the angle 2 psi",
                      required_damping.ARGUMENTS,
                      choose(_whole, early, (n + root) / 2))  # fmt: skip


def required_at(precision: Precision = DOUBLE) -> Routine:
    """The same at any angle of (0, pi), where the delay turns many times as well.

    Of a wall whose squares would vanish it is that of a larger one, by a power of two.
    """
    do = Steps()
    lift = do("lift", _lift(precision))
    stiffness, damping = do("stiffness", lift * alpha), do("damping", lift * beta)
    cosine, sine = do.several(("cosine", "sine"), "NextWave", l, theta)
    half = do("half", theta / 2)
    up, along = do("up", sin(half)), do("along", cos(half))
    wave = over(do, scaled(do, sine, exact(along)), exact(up))
    twice = do("twice", 2 * epsilon)
    push = minus(do, plus(do, wave, scaled(do, twice, exact(cosine))), exact(cosine))
    middle = plus(do, scaled(do, sine, exact(along)), scaled(do, cosine, exact(up)))
    later = scaled(do, twice, scaled(do, up, middle))
    pull = scaled(do, damping, minus(do, exact(cosine), later))
    mean, mean_low = minus(do, scaled(do, stiffness / 2, push), pull)
    n = do("n", mean + mean_low)
    size = do("size", (stiffness * along) ** 2 + ((stiffness + 2 * damping) * up) ** 2)
    extra = do("extra", epsilon * (1 - epsilon) * size)
    root = do("root", sqrt(n * n + extra))
    # the mean of n and the root without a difference, and with no more than a part of the root
    more = do("more", extra / (2 * do.nonzero(root + sp.Abs(n))))
    whole = do("whole_need", mean + do("rest", mean_low + more))
    return do.routine("RequiredAt", "the damping that the wall needs at the angle theta, at a "
                      "fraction of a period", (alpha, beta, l, epsilon, theta),
                      choose(n < 0, more, whole) / lift)  # fmt: skip


def rising() -> Routine:
    """Whether that grows with the angle, at a fraction of a period."""
    do = Steps()
    early, late = do.common(required_damping.steepness(l), required_damping.steepness(l + 1))
    early = do("early", early)
    steep = do("steep", required_damping.between(early, late))
    found = required_damping.rising(sp.Function("DampingAt")(*required_damping.ARGUMENTS), steep)
    return do.routine("Rising", "has the sign of the slope of DampingAt, at a fraction",
                      required_damping.ARGUMENTS, found)  # fmt: skip


def steepness() -> Routine:
    """Whether that grows with the angle; negative beyond the angle in phase."""
    do = Steps()
    early = do("early", do.common(required_damping.steepness(l))[0])
    rising = do("rising", sp.Function("Rising")(*required_damping.ARGUMENTS))
    double = 2 * psi
    delayed = atan2(epsilon * sin(double), 1 - epsilon + epsilon * cos(double))
    own = atan2(alpha * cos(psi), (alpha + 2 * beta) * sin(psi))
    phase = do("phase", (2 * (l + 1) * psi - pi) + delayed + own)
    fractional = choose(phase > 0, -sp.Abs(rising), rising)
    return do.routine("Steepness",
                      "has the sign of the slope of DampingAt, up to the angle in phase",
                      required_damping.ARGUMENTS, choose(_whole, early, fractional))  # fmt: skip


def worst_angle(precision: Precision = DOUBLE) -> Routine:
    """Half of the angle at which the wall needs most, as near as its need has to be."""
    return _worst("WorstAngle", precision, precision.flat)


def critical_angle(precision: Precision = DOUBLE) -> Routine:
    """The same to the last place, for derivatives of the need."""
    return _worst("CriticalAngle", precision, precision.close)


def _worst(name: str, precision: Precision, close: Expr) -> Routine:
    do = Steps()

    def slope(stiffness: Expr, damping: Expr, whole: Expr, at: Expr) -> Expr:
        return sp.Function("Steepness")(stiffness, damping, whole, epsilon, at)

    psi = _neediest(do, slope, precision, close)
    return do.routine(name, "half of the angle at which the wall needs most damping",
                      _WALL, psi)  # fmt: skip


def _neediest(do: Steps, slope: Callable[..., Expr], precision: Precision, close: Expr) -> Expr:
    """Where the slope of what a wall of the size 1 needs changes its sign."""
    # beyond pi the sine is negative, which at half a period turns the phase
    most = sp.Rational(precision.below_pi)
    size = do("size", sp.Abs(alpha) + sp.Abs(beta))
    scale = do.nonzero(size)
    wall = do("stiffness", alpha / scale), do("damping", beta / scale)
    end = most / (2 * (l + 1))
    return crossing(do, lambda _, at: slope(*wall, l, at), sp.S.Zero, end, close)


def largest_required_damping(precision: Precision = DOUBLE) -> Routine:
    """The damping that the wall needs, infinite if it pulls.

    Of a wall whose squares would vanish it is that of a larger one, by a power of two.
    """
    do = Steps()
    whole = do("whole", floor(d))
    part = do("part", d - whole)
    lift = do("lift", _lift(precision))
    wall = do("stiffness", lift * alpha), do("damping", lift * beta)
    psi = do("psi", sp.Function("WorstAngle")(*wall, whole, part))
    found = sp.Function("DampingAt")(*wall, whole, part, psi) / lift
    return do.routine("LargestRequiredDamping",
                      "the damping that the wall needs at its worst angle",
                      (alpha, beta, d), choose(alpha < 0, sp.oo, found))  # fmt: skip


def _lift(precision: Precision) -> Expr:
    tiny = sp.Abs(alpha) + sp.Abs(beta) < precision.vanishing
    return choose(tiny, 1 / precision.vanishing**2, sp.S.One)


def lifted(precision: Precision = DOUBLE) -> Routine:
    """By the same power of two, for derivatives of the need."""
    x = sp.Symbol("x")
    return Steps().routine("Lifted", "x, enlarged where the squares of the wall would vanish",
                           (x, alpha, beta), x * _lift(precision))  # fmt: skip


def whole_damping_at() -> Routine:
    """Of a whole delay."""
    return Steps().routine("WholeDampingAt", "the damping that the wall needs at the angle 2 psi",
                           _WHOLE, required_damping.straight(l))  # fmt: skip


def whole_steepness() -> Routine:
    """Its sign counts."""
    do = Steps()
    return do.routine("WholeSteepness", "has the sign of the slope of WholeDampingAt", _WHOLE,
                      do.common(required_damping.steepness(l))[0])  # fmt: skip


def worst_whole_angle(precision: Precision = DOUBLE) -> Routine:
    """The same as the worst angle."""
    do = Steps()
    psi = _neediest(do, lambda *at: sp.Function("WholeSteepness")(*at), precision, precision.flat)
    return do.routine("WorstWholeAngle", "half of the angle at which the wall needs most damping",
                      _WHOLE[:-1], psi)  # fmt: skip


def largest_whole_required_damping() -> Routine:
    """The damping that the wall needs behind a whole delay, infinite if it pulls."""
    do = Steps()
    psi = do("psi", sp.Function("WorstWholeAngle")(alpha, beta, d))
    found = sp.Function("WholeDampingAt")(alpha, beta, d, psi)
    return do.routine("LargestWholeRequiredDamping",
                      "the damping that the wall needs at its worst angle",
                      (alpha, beta, d), choose(alpha < 0, sp.oo, found))  # fmt: skip


@cache
def _turning() -> tuple[dict[Expr, Symbol], Expr]:
    """The slope of the need of a wall of the size 1, made of waves that are the same for all."""
    steep = required_damping.between(
        required_damping.steepness(l), required_damping.steepness(l + 1)
    )
    rising = required_damping.rising(required_damping.required(), steep)
    waves = sorted(rising.atoms(sp.Function), key=sp.default_sort_key)
    named = {wave: Symbol(f"wave{i}" if i > 1 else "wave") for i, wave in enumerate(waves, 1)}
    return named, rising.xreplace(named).xreplace(required_damping.of_size_one())


def turning() -> Routine:
    """It falls where the wall is worst at a smaller angle."""
    do, (waves, rising) = Steps(), _turning()
    return do.routine("Turning", "has the sign of minus the slope of what the wall phi needs",
                      (phi, l, epsilon, *waves.values()), -do.common(rising)[0])  # fmt: skip


def turn(precision: Precision = DOUBLE) -> Routine:
    """The wall that is worst at an angle, as an angle; pi/2 where there is none."""
    do = Steps()
    waves = [do("wave", wave) for wave in _turning()[0]]

    def falls(_: Steps, at: Expr) -> Expr:
        return sp.Function("Turning")(at, l, epsilon, *waves)

    found = crossing(do, falls, 0 * psi, pi / 2, precision.close)
    return do.routine("Turn", "the wall whose worst angle is 2 psi, as an angle",
                      (psi, l, epsilon), found)  # fmt: skip


def touching() -> Routine:
    """The same, and NaN where there is none."""
    do = Steps()
    found = do("found", sp.Function("Turn")(theta / 2, l, epsilon))
    return do.routine("Touching", "the wall whose worst angle is theta, as an angle, or NaN",
                      (theta, l, epsilon), choose(found < pi / 2, found, sp.nan))  # fmt: skip


def passive_slope() -> Routine:
    """Of the largest stiffness that an angle allows."""
    do = Steps()
    waves: dict[Expr, Expr] = {}
    for periods in (l, l + 1):
        both = do.several(("cosine", "sine"), "NextWave", periods, theta)
        waves |= zip((CosNext(periods, theta), SinNext(periods, theta)), both, strict=True)
    sine, cosine = (
        do(name, mean.xreplace(waves))
        for name, mean in (("up", stiffest_passive.sine()), ("along", stiffest_passive.cosine()))
    )
    found = stiffest_passive.falling(sine, cosine).xreplace(waves)
    return do.routine("PassiveSlope", "whether a larger angle allows less stiffness, at a fraction",
                      (theta, l, epsilon), found)  # fmt: skip


def passive_angle(precision: Precision = DOUBLE) -> Routine:
    """The angle that is worst for the stiffest passive wall, at a fraction of a period."""
    do = Steps()
    high = pi / (l + epsilon + 1)
    slope = sp.Function("PassiveSlope")
    angle = crossing(do, lambda _, at: slope(at, l, epsilon), sp.S.Zero, high, precision.close)
    return do.routine("PassiveAngle", "the worst angle of the stiffest passive wall, at a fraction",
                      (l, epsilon), angle)  # fmt: skip


def pushed() -> Routine:
    """A need, infinite if the wall pulls."""
    do, need = Steps(), sp.Symbol("need")
    return do.routine("Pushed", "the need, infinite for alpha < 0", (alpha, need),
                      choose(alpha < 0, sp.oo, need))  # fmt: skip


def lead() -> Routine:
    """Whether mere damping is not yet in phase with its delay: the sine of what it lacks."""
    do = Steps()
    early, late = do("early", SinNext(l, theta)), do("late", SinNext(l + 1, theta))
    sine = do("sine", required_damping.between(early, late))
    return do.routine("Lead", "negative beyond the angle in phase with the delay",
                      (theta, l, epsilon), choose((l + 1) * theta < _FIRST, sine, -1))  # fmt: skip


def rated() -> Routine:
    """A value that is none where a number is negative: a slope if the wall pulls, a lost end."""
    do = Steps()
    number, value = given = sp.symbols("number value")
    return do.routine("Rated", "the value, NaN for number < 0", given,
                      choose(number < 0, sp.nan, value))  # fmt: skip


def whole_part() -> Routine:
    """Whole periods of a delay."""
    return Steps().routine("WholePart", "whole periods of a delay", (d,), floor(d))


def fractional_part() -> Routine:
    """The rest of them."""
    return Steps().routine(
        "FractionalPart", "the fraction of a period in a delay", (d,), d - floor(d)
    )


def some_part() -> Routine:
    """The same for whole delays, too, where another branch counts."""
    do = Steps()
    part = do("part", d - floor(d))
    return do.routine("SomePart", "the same, or 1/2 where it is 0", (d,),
                      choose(sp.Eq(part, 0), sp.S.Half, part))  # fmt: skip


ROUTINES = (
    straight, straight_at, between, passive_slope, whole_part, fractional_part, some_part,
    damping_at, rising, steepness, touching, pushed, lead, rated, whole_damping_at,
    whole_steepness, largest_whole_required_damping, turning,
)  # fmt: skip
PRECISE = (
    worst_angle, worst_whole_angle, critical_angle, turn, passive_angle, largest_required_damping,
    lifted, required_at,
)  # fmt: skip
