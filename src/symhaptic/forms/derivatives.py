"""Derivatives of stable forms, which are stable forms again.

The products of :mod:`symhaptic.forms.derivatives` are differentiated as a whole.

By the delay a derivative is that by its fraction, inside a period; at a whole delay it is the slope
to the right.  A value that is largest at an angle that is searched for has the derivative that it
has at this angle held still (envelope theorem).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import cached_property, lru_cache

import sympy as sp
from sympy import Expr, Symbol, exp, sin

from symhaptic.forms import fractional_delay, required_damping
from symhaptic.forms.entire import (
    SLOPES,
    C,
    Chord,
    Coast,
    CosNext,
    Decay,
    Echo,
    Entire,
    Fade,
    Gap,
    Kick,
    Lag,
    NumeratorAtOne,
    NumeratorGap,
    NumeratorGapDrop,
    PlantN0,
    Ripple,
    S,
    Sinc,
    SinNext,
    at_numbers,
)
from symhaptic.forms.implicit import (
    CriticalAngle,
    FractionalPart,
    ImplicitFunction,
    LargestRequiredDamping,
    Lifted,
    MaxStiffnessAngle,
    Pushed,
    Rated,
    SomePart,
    WholePart,
)
from symhaptic.forms.root_count import FractionalRoots, Stable, WholeRoots
from symhaptic.forms.stable import Form, NoForm
from symhaptic.model.parts import FULL, Parts
from symhaptic.notation import alpha, beta, d, delta, epsilon, gamma, l, psi


class _By:
    """Derivatives by one symbol, each subexpression done once."""

    def __init__(self, by: Symbol) -> None:
        self.by = by
        self.known: dict[Expr, Expr] = {by: sp.S.One}
        self.whole = [(whole, slopes[by]) for whole, slopes in WHOLE if by in slopes]

    def __call__(self, expr: Expr) -> Expr:
        """The derivative of an expression."""
        if expr not in self.known:
            self.known[expr] = self._found(expr) if expr.has(self.by) else sp.S.Zero
        return self.known[expr]

    def _found(self, expr: Expr) -> Expr:
        if expr.is_Add:
            return sp.Add(*map(self, expr.args))
        if expr.is_Mul:
            return self._product(expr)
        if expr.is_Pow:
            base, power = expr.args
            return power * base ** (power - 1) * self(base)
        if isinstance(expr, sp.Piecewise):
            return self._either(expr)
        if isinstance(expr, ImplicitFunction):
            return self._searched(expr)
        if isinstance(expr, sp.Abs):
            return expr.args[0] / expr * self(expr.args[0])
        if isinstance(expr, Entire) and type(expr) not in SLOPES:
            raise NoForm(f"no stable derivative of {type(expr).__name__} is known")
        return sp.Add(*(expr.fdiff(i + 1) * self(arg) for i, arg in enumerate(expr.args)))

    def _either(self, expr: sp.Piecewise) -> Expr:
        """Of a form for whole delays and another one for those with a fraction."""
        (whole, condition), (late, _) = expr.args
        by = self.inside if self.by == d else self
        slope = by(late.xreplace({SomePart(d): epsilon, WholePart(d): l}))
        if self.by == d:
            right = at_numbers(slope.xreplace({epsilon: sp.S.Zero, l: d}))
        else:
            right = self(whole)
        back = slope.xreplace({epsilon: SomePart(d), l: WholePart(d)})
        return sp.Piecewise((right, condition), (back, True))

    @cached_property
    def inside(self) -> _By:
        """Derivatives by the fraction of a period."""
        return _By(epsilon)

    def _searched(self, expr: ImplicitFunction) -> Expr:
        if isinstance(expr, WholePart):
            return sp.S.Zero
        if isinstance(expr, FractionalPart | SomePart):
            return self(expr.args[0])
        if isinstance(expr, Pushed | Rated):
            return Rated(expr.args[0], self(expr.args[1]))
        if isinstance(expr, LargestRequiredDamping):
            return Rated(expr.args[0], self._needed(expr))
        raise NoForm(f"{type(expr).__name__} is searched for")

    def _needed(self, expr: LargestRequiredDamping) -> Expr:
        """That of the need at the worst angle, which is as that of a larger wall."""
        stiffness, damping, delay = expr.args
        whole, part = WholePart(delay), FractionalPart(delay)
        angle = CriticalAngle(stiffness, damping, whole, part)
        large, strong, lift = (
            Lifted(x, stiffness, damping) for x in (stiffness, damping, sp.S.One)
        )
        at = {alpha: large, beta: strong, l: whole, epsilon: part, psi: angle}
        need = required_damping.required()
        slopes = ((alpha, self(stiffness)), (beta, self(damping)), (epsilon, self(delay) / lift))
        return sp.Add(*(_By(s)(need).xreplace(at) * slope for s, slope in slopes if slope))

    def _product(self, expr: Expr) -> Expr:
        powers = expr.as_powers_dict()
        for whole, slope in (*self.whole, *self._waves(expr)):
            parts = whole.as_powers_dict()
            times = min(_times(powers.get(base, sp.S.Zero), power) for base, power in parts.items())
            if times >= 1:
                rest, times = expr / whole ** int(times), int(times)
                return whole ** (times - 1) * (times * slope * rest + whole * self(rest))
        first, *others = sorted(expr.args, key=lambda factor: not _below(factor))
        rest = sp.Mul(*others)
        if _below(first):  # the square of what is below would leave the range of numbers
            base, power = first.args
            return first * (self(rest) + power * rest / base * self(base))
        return self(first) * rest + first * self(rest)

    def _waves(self, expr: Expr) -> Iterator[tuple[Expr, Expr]]:
        """sin((k + 1) x) over sin(x) or over x, with its derivative."""
        for wave in expr.args:
            if isinstance(wave, SinNext):
                k, x = wave.args
                turned = CosNext(k, x)
                yield wave / sin(x), self(k) * x * turned / sin(x) + self(x) * Ripple(k, x)
                flat = (wave * Gap(x) - x * Chord(k, x) / 2) / Sinc(x)
                yield wave / x, self(k) * turned + self(x) * flat


def _below(factor: Expr) -> bool:
    """Whether a factor is one below the line."""
    return bool(factor.is_Pow and factor.exp.is_number and factor.exp < 0)


def _times(power: Expr, whole: Expr) -> Expr:
    """How often a power holds another one; the exponent of exp is no number."""
    ratio = power / whole
    return ratio if ratio.is_number else sp.S.Zero


def derivative(expr: Expr, by: Symbol) -> Expr:
    """The derivative of a stable form, again a stable form.

    >>> from symhaptic.forms.entire import NumeratorAtOne
    >>> from symhaptic.notation import delta, gamma
    >>> derivative(gamma * NumeratorAtOne(gamma, delta), gamma)
    Kick(gamma, delta)
    """
    return _By(by)(expr)


def counts(form: Form) -> bool:
    """Whether a form counts roots: whole numbers have no slope."""
    return any(e.has(WholeRoots, FractionalRoots, Stable) for e in form.expressions)


def _held(expr: Expr, by: _By) -> Expr:
    """The derivative at the angle that is searched for, which stays as it is."""
    still = Symbol("still")

    def stopped(e: Expr) -> tuple[Expr, dict[Expr, Expr]]:
        (angle,) = e.atoms(MaxStiffnessAngle)
        return e.xreplace({angle: still}), {still: angle}

    if not isinstance(expr, sp.Piecewise):
        one, back = stopped(expr)
        return by(one).xreplace(back)
    (whole, condition), (late, _) = expr.args
    (one, back), (other, back_late) = stopped(whole), stopped(late)
    slopes = by(sp.Piecewise((one, condition), (other, True))).args
    return sp.Piecewise(
        (slopes[0][0].xreplace(back), condition), (slopes[1][0].xreplace(back_late), True)
    )


@lru_cache(maxsize=256)  # asked for once to see whether there are any, and again to be written
def _slopes(form: Form, by: Symbol) -> tuple[tuple[str, Expr], ...] | str:
    """The derivatives of its results by one argument, named; or what is lacking."""
    own = _By(by)
    names = [name for name, _ in form.results]
    try:
        return tuple(
            (f"{name}_by_{by.name}", _held(expr, own) if form.held else own(expr))
            for name, expr in zip(names, form.differentiated, strict=True)
            if not form.held or name in form.held
        )
    except NoForm as lacking:
        return str(lacking)


def with_derivatives(form: Form, by: tuple[str, ...]) -> Form:
    """The form with, beside each result r, its derivative r_by_x for every argument x asked for.

    Of a form with results at an angle that is searched for, only for the results that are largest
    there.  Raises :class:`NoForm` for what is no argument, for what counts, and for what is
    searched for in another way.
    """
    symbols = {s.name: s for s in form.arguments}
    for name in by:
        if name not in list(symbols):  # a list is no key of a mapping
            raise NoForm(f"{form.name}: has no argument {name!r}; it has {', '.join(symbols)}")
    if counts(form):
        raise NoForm(f"{form.name}: has no derivative, since it counts roots")
    slopes: list[tuple[str, Expr]] = []
    for name in by:
        found = _slopes(form, symbols[name])
        if isinstance(found, str):
            raise NoForm(f"{form.name}: has no derivative with respect to {name}, since {found}")
        slopes += found
    return replace(
        form,
        name=f"{form.name}_and_derivatives",
        title=f"{form.title}; and its derivatives with respect to {', '.join(by)}",
        results=(*form.results, *slopes),
        plain=form,
    )


def differentiable(form: Form) -> tuple[str, ...]:
    """The names of the arguments by which the form has derivatives.

    >>> from symhaptic.forms import stable
    >>> differentiable(stable.form("passivity_margin_at"))
    ('theta', 'alpha', 'beta', 'delta', 'd')
    >>> differentiable(stable.form("is_stable"))
    ()
    """
    return tuple(s.name for s in form.arguments if _has(form, s.name))


def _has(form: Form, name: str) -> bool:
    try:
        with_derivatives(form, (name,))
    except NoForm:
        return False
    return True


# -- Products whose derivative loses digits when it is taken factor by factor, with that derivative


def _stretched() -> Iterator[tuple[Expr, dict[Symbol, Expr]]]:
    """What moves in a part of a period: by its length, as it moves at its end; longest first."""
    still, loose = FULL.without("stiffness"), FULL.without("damping")
    for parts in (FULL, still, loose):
        for time, way in ((1 - epsilon, -1), (epsilon, 1)):
            yield from _moved(parts, time, way)


def _moved(parts: Parts, time: Expr, way: int) -> Iterator[tuple[Expr, dict[Symbol, Expr]]]:
    x = fractional_delay.brief(parts, time)
    scaled = gamma * time**2, delta * time
    if not parts.damping:  # without the half before S(..)^2
        yield 2 * x.rise, {epsilon: 2 * way * x.kick}
        yield x.kick, {epsilon: way * C(-scaled[0])}
        return
    yield exp(-delta * (1 - time)) * x.fall, {epsilon: way * exp(-delta * (1 - time)) * x.kick}
    turned = {epsilon: way * delta * x.fall}
    if parts.stiffness:
        turned |= {gamma: -delta * time**5 * NumeratorGapDrop(*scaled),
                   delta: time**3 * (PlantN0(*scaled) - 2 * Echo(*scaled))}  # fmt: skip
        speed = Coast(*scaled)
    else:
        turned |= {delta: time**3 * (Fade(scaled[1]) - 2 * Lag(scaled[1]))}
        speed = exp(-scaled[1])
    yield x.apart, turned
    yield x.rise, {epsilon: way * x.kick}
    yield x.fall, {epsilon: way * (x.kick - delta * x.fall)}
    kept = exp(-scaled[1])
    yield x.loss, {delta: time * kept, epsilon: way * delta * kept}
    yield x.kick, {epsilon: way * speed}


WHOLE: tuple[tuple[Expr, dict[Symbol, Expr]], ...] = (
    (
        gamma * NumeratorAtOne(gamma, delta),
        {gamma: Kick(gamma, delta), delta: -gamma * PlantN0(gamma, delta)},
    ),
    (
        delta * NumeratorGap(gamma, delta),
        {
            gamma: -delta * NumeratorGapDrop(gamma, delta),
            delta: PlantN0(gamma, delta) - 2 * Echo(gamma, delta),
        },
    ),
    (delta * Decay(delta), {delta: exp(-delta)}),
    (delta * Lag(delta), {delta: Fade(delta) - 2 * Lag(delta)}),
    (gamma * S(-gamma / 4) ** 2, {gamma: S(-gamma)}),
    *_stretched(),
)
"""Products and their derivatives: 1 - a + e, n1 - n0, 1 - e, these without spring or damper, and
the device after a part of a period."""
