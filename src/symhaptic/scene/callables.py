"""Formulas as functions of numbers, without a file between."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cache, partial, update_wrapper
from inspect import Parameter, Signature
from typing import Any

import mpmath
import numpy as np
import sympy as sp
from sympy import Expr, Symbol
from sympy.core.relational import Relational
from sympy.logic.boolalg import Boolean

from symhaptic.export import request
from symhaptic.export.language import Refused
from symhaptic.export.targets import TARGETS
from symhaptic.forms.derivatives import differentiable, with_derivatives
from symhaptic.forms.form import BELOW_PI, LARGEST, LONGEST, STIFFEST
from symhaptic.forms.stable import AS_DERIVED, STATEMENTS, Form, NoForm
from symhaptic.forms.stable import form as stable_form
from symhaptic.forms.values import value
from symhaptic.model.parts import FULL, Parts, left
from symhaptic.notation import d
from symhaptic.notation.extras import needed
from symhaptic.notation.suggest import suggested
from symhaptic.numeric import slopes
from symhaptic.numeric.arguments import IN_ORDER
from symhaptic.numeric.containers import kept
from symhaptic.scene.scene import Scene

FORMS = ("stable", "derived", "printed")
MODULES = ("numpy", "jax", "torch", "cupy", "mpmath")


def lambdify(
    id: str,
    form: str = "stable",
    modules: str = "numpy",
    scene: Scene | Parts | str | None = None,
    derivatives: Sequence[str] | str = (),
) -> Callable[..., Any]:
    """Return a numerical function for a formula.

    Parameters
    ----------
    id : str
        A formula of the paper that has a stable form, such as ``"eq11"``, or the name of a function
        that ``symhaptic export --list`` prints.  (7), (9), (12) and (24) are computed in the
        dimensionless parameters of Table I, as (27), (25), (14) and (25): K = alpha m/T^2,
        B = beta m/T.  (31) is its derived form in SI units: T in s, b in Ns/m, m in kg.
    form : {"stable", "derived", "printed"}, optional
        ``"stable"`` is accurate everywhere.  The other two are SymPy's own lambdify of the
        derived and the published formula.
    modules : {"numpy", "jax", "torch", "cupy", "mpmath"}, optional
        The library of the arrays; arrays of xarray, Dask, pandas and Pint come back as such.
        ``"mpmath"`` returns as many digits as ``mpmath.mp.dps`` says.
    scene : Scene, Parts or str, optional
        The function has no arguments for parts that the scene lacks.  A string is written as on the
        command line (``"no-stiffness,no-delay"``).  If a scene has an arm, gamma and delta of
        stability are those of device and arm together (``scene.dimensionless``), and delta of
        passivity is that of the device alone (``scene.device.dimensionless``).
    derivatives : sequence of str, optional
        Arguments of a stable form.  After its results, the function returns their derivatives by
        the first of these arguments, then by the next.

    Returns
    -------
    callable
        A function that returns one number or a tuple; ``"is_stable"`` returns a truth value.  The
        arguments of a stable form are dimensionless and in the order that ``symhaptic export
        --list`` prints.  Those of the other forms are in the order of ``symhaptic check --list``,
        or of their names if it does not list the formula.  Outside the domain numbers are NaN, the
        count ``"unstable_roots"`` is -1, and nothing is stable.

    Raises
    ------
    ValueError
        If an argument is not known, or if the scene lacks a part of the formula.

    Notes
    -----
    The function can be pickled.  ``jax.vmap`` maps it; ``torch.vmap`` cannot, because the function
    looks for NaN.  Pass arrays that broadcast instead.

    Examples
    --------
    >>> import numpy as np
    >>> stiffest = lambdify("eq11")
    >>> alpha, beta, theta = stiffest(1.0, np.array([0.0, 1.0]))
    >>> alpha.round(6).tolist()
    [2.0, 0.828427]
    >>> [float(x) for x in lambdify("discretize", scene=Parts(stiffness=False))(0.0)]
    [0.5, 0.5, 2.0, 1.0]
    >>> round(lambdify("eq31")(0.001, 0.0, 0.1))  # T, b, m; in N/m
    986960
    >>> alpha, alpha_by_d = lambdify("linear_limit", derivatives=["d"])(0.0, 1.0, 1.5)
    >>> float(alpha), float(alpha_by_d)
    (0.5, -0.25)
    """
    if not isinstance(id, str):
        raise ValueError(f"id: {id!r} is not allowed; give text such as 'eq11'")
    for name, given, known in (("form", form, FORMS), ("modules", modules, MODULES)):
        if given not in known:
            raise ValueError(f"{name}: {given!r} is not allowed; {suggested(given, known)}")
    if modules not in ("numpy", "mpmath"):
        extra = "arrays" if modules in ("jax", "torch") else None
        needed(f"symhaptic.lambdify(modules={modules!r})", modules, extra=extra)
    if form == "stable" and id in AS_DERIVED and scene is None and not derivatives:
        form = "derived"
    if form != "stable":
        if derivatives:
            raise ValueError(f"derivatives: not available with form={form!r}; give form='stable'")
        if scene is not None:
            raise ValueError(f"scene: not available with form={form!r}; give form='stable'")
        return _Lambdified.of(_of_the_paper(id, form, modules), (id, form, modules))
    parts = _parts(scene)
    try:
        (wanted,) = request.chosen([id], parts)
        if isinstance(scene, Scene) and "passiv" in wanted.name:
            parts = scene.device.parts
            (wanted,) = request.chosen([id], parts)
    except Refused as wrong:
        raise ValueError(f"id: {str(wrong).removeprefix('FORMULA: ')}") from None
    if not isinstance(derivatives, Sequence | None):
        raise TypeError(f"derivatives: {derivatives!r} is not allowed; give names of arguments")
    if isinstance(derivatives, str):
        derivatives = [name.strip() for name in derivatives.split(",") if name.strip()]
    if derivatives:
        try:
            wanted = with_derivatives(wanted, tuple(derivatives))
        except NoForm as lacking:
            raise ValueError(f"derivatives: {lacking}") from None
    made, kind = (_in_digits, modules) if modules == "mpmath" else (_on_arrays, "numpy")
    return made(wanted, (id, form, kind, parts, tuple(derivatives or ())))


class _Lambdified(partial[Any]):
    """A function that another process makes anew from what was asked for."""

    asked: tuple[Any, ...]

    @classmethod
    def of(cls, function: Callable[..., Any], asked: tuple[Any, ...]) -> _Lambdified:
        """The function itself, as it is called and shown."""
        made = cls(function)
        update_wrapper(made, function)
        made.asked = asked
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return lambdify, self.asked


def _parts(scene: Scene | Parts | str | None) -> Parts:
    """What is in the loop."""
    if scene is None or isinstance(scene, Parts):
        return scene or FULL
    if isinstance(scene, Scene):
        scene.refuse_further("a formula of the paper's loop")
        return scene.parts
    if not isinstance(scene, str):
        raise TypeError(
            f"scene: {scene!r} is not allowed; give a Scene or words such as 'no-delay'"
        )
    try:
        return left(scene)
    except ValueError as wrong:
        raise ValueError(f"scene: {wrong}") from None


@cache
def _on_arrays(form: Form, asked: tuple[Any, ...]) -> _Lambdified:
    _, files = request.built(TARGETS["numpy"], [form], "callables", vectors=False)
    space: dict[str, Any] = {}  # of no name: Torch's compiler would import a module of this name
    exec(compile(files["callables.py"], f"<{form.name}>", "exec"), space)
    function = space[form.name]
    if (form.plain or form).name in SEARCHES:
        results = tuple(name for name, _ in form.results)
        function = slopes.in_jax(results, *_slopes(form))(function)
    around = kept(None, True, **{name: float for name, _ in form.results})
    return _Lambdified.of(around(function), asked)


SEARCHES = "max_stable_stiffness", "max_passive_stiffness", "passivity_margin", "passivity_boundary"
"""Forms that search for an angle, through which JAX cannot differentiate."""


def _slopes(form: Form) -> tuple[tuple[str, ...], slopes.Slopes | None]:
    """The arguments by which JAX may differentiate a form that searches, and the derivatives."""
    if form.plain is not None:
        return (), None
    if form.name == "max_passive_stiffness" and d in form.arguments:
        return ("delta", "d"), partial(_of_passive_stiffness, form)
    return differentiable(form), partial(_derivatives, form)


def _derivatives(form: Form, *values: Any) -> dict[tuple[str, str], Any]:
    """The derivatives of a form, by the names of its results and of its arguments.

    An angle that is searched for is held, by the envelope theorem.
    """
    wanted = with_derivatives(form, differentiable(form))
    shape = np.broadcast_shapes(*(v.shape for v in values))
    function = _on_arrays(wanted, ())
    rows = function(*(np.broadcast_to(v, shape) for v in values))
    names = (name.partition("_by_") for name, _ in wanted.results)
    return {(one, by): np.asarray(row) for (one, _, by), row in zip(names, rows, strict=True)}


def _of_passive_stiffness(form: Form, delta: Any, delay: Any) -> dict[tuple[str, str], Any]:
    """The derivatives of the largest passive stiffness.

    At the wall of largest stiffness the margin m(alpha, beta, d) is 0 and does not change with
    beta, so that alpha changes with the delay by -m_d/m_alpha.  NaN without delay, where every
    angle is a worst one.
    """
    found = _derivatives(form, delta, delay)
    margin = _derivatives(
        stable_form("passivity_margin"), found["alpha", ""], found["beta", ""], delta, delay
    )
    slope = -margin["margin", "d"] / margin["margin", "alpha"]
    found["alpha", "d"] = np.where(delay == 0, np.nan, slope)
    return found


def _in_digits(form: Form, asked: tuple[Any, ...]) -> _Lambdified:
    signature = Signature([Parameter(s.name, _EITHER_WAY) for s in form.arguments])

    def function(*numbers: Any, **named: Any) -> Any:
        try:
            given = signature.bind(*numbers, **named).args
        except TypeError as wrong:
            raise TypeError(f"{form.name}{signature}: {wrong}") from None
        at = dict(zip(form.arguments, map(mpmath.mpmathify, given), strict=True))
        if not all(_inside(*pair) for pair in zip(form.within, at.items(), strict=True)):
            nothing = (_NOTHING[form.outside],) * len(form.results)
            return nothing if len(nothing) > 1 else nothing[0]
        found = tuple(value(expr, at, mpmath.mp.dps) for expr in form.expressions)
        if form.truth:
            return found[0] != 0
        return found if len(found) > 1 else found[0]

    function.__name__ = form.name
    function.__signature__ = signature  # type: ignore[attr-defined]
    return _Lambdified.of(function, asked)


_EITHER_WAY = Parameter.POSITIONAL_OR_KEYWORD
_NOTHING = {sp.nan: mpmath.nan, sp.Integer(-1): mpmath.mpf(-1), sp.false: False}
_NO_END = {BELOW_PI: sp.pi, **dict.fromkeys((LARGEST, STIFFEST, LONGEST), sp.Float(10) ** 1000)}


def _inside(within: Boolean, argument: tuple[Symbol, mpmath.mpf]) -> bool:
    """Whether an argument of many digits is in its range."""
    symbol, number = argument
    if isinstance(number, mpmath.mpc) or not mpmath.isfinite(number):
        return False
    return bool(within.xreplace({**_NO_END, symbol: sp.Float(number)}))


def _of_the_paper(id: str, form: str, modules: str) -> Callable[..., Any]:
    from symhaptic.book.formulas import formula

    own = next((ids[0] for name, ids in STATEMENTS.items() if name == id), id)
    lines = getattr(formula(own), form)
    sides = [_side(line) for line in lines]
    order = IN_ORDER.get(id, "").split()
    symbols = sorted(
        set().union(*(side.free_symbols for side in sides)),
        key=lambda s: (order.index(s.name) if s.name in order else -1, s.name),
    )
    found: Callable[..., Any] = sp.lambdify(
        symbols, sides[0] if len(sides) == 1 else sides, modules
    )
    return found


def _side(line: Expr) -> Expr:
    """What an equation defines; an inequality as it is."""
    return line.rhs if isinstance(line, Relational) and isinstance(line, sp.Eq) else line
