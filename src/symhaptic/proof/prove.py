"""Questions of a user's own: are two formulas the same, does an inequality hold on a box?"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.logic.boolalg import BooleanAtom

from symhaptic.proof import box as boxes
from symhaptic.proof.asked import Ends, allowed_steps, box_of, form_of, spend_reading
from symhaptic.proof.budget import STEPS, Exhausted, budget
from symhaptic.proof.certificate import Positive
from symhaptic.proof.decide import compare, named
from symhaptic.proof.names import admissible, renamed, shared
from symhaptic.proof.program import Uncheckable
from symhaptic.proof.recheck import recheck
from symhaptic.proof.refute import truth, where_defined
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.shape import Form, parts
from symhaptic.proof.verdict import Kind, Verdict


def prove(lhs: Form, rhs: Form | Ends | None = None, *, steps: int = STEPS) -> Verdict:
    r"""Decide whether two formulas are the same, or whether an inequality holds on a box.

    Parameters
    ----------
    lhs : SymPy expression, relation, vector or number
        The first formula; for an inequality, the relation.
    rhs : SymPy expression, relation, vector or number, or dict
        The second formula; for an inequality, the box: a closed interval for each symbol,
        ``{x: (0, 1)}``.
    steps : int, optional
        Steps of arithmetic after which an inequality is left undecided.

    Returns
    -------
    Verdict
        True if it is *proved*, with the field in which the difference is zero, or *enclosed*, with
        a ``certificate`` that :func:`symhaptic.recheck` has checked again.  False if it is
        *refuted*, with a confirmed counterexample, or *undecided*.

    Raises
    ------
    TypeError, ValueError
        If an argument is no formula, relation or box.  Text is refused, because SymPy would run it
        as a program.

    Notes
    -----
    Two formulas are the same if both sides agree wherever both are defined, for real values of the
    symbols and any real exponent, and such a point exists.  A counterexample respects the domains
    of ``symhaptic.notation`` for symbols that have a name there, such as ``y`` in [0, 1].  Symbols
    with the same name are one symbol with the assumptions of all of them.

    Both sides of an inequality, as written, must be defined and real on the whole box, ends
    included.  An inequality that holds with equality at a point, such as :math:`x^2\ge0` on [-1,
    1], is undecided, because interval arithmetic cannot prove an equality.

    Under pytest, ``assert prove(...)`` fails with the sentence of the verdict and its
    counterexample.

    Examples
    --------
    >>> from sympy.abc import x
    >>> bool(prove(sp.tan(x/2), sp.sin(x)/(1 + sp.cos(x))))
    True
    >>> print(prove(sp.sin(2*x), 2*sp.sin(x)).counterexample)
    {'x': '1'}
    >>> print(prove(sp.sin(x) < x - x**3/8, {x: (1, 2)}))
    enclosed: ball arithmetic on 20 pieces
    """
    if rhs is None:
        raise TypeError(
            f"prove: {lhs!r} alone is no question; prove(lhs, rhs) is one, and "
            "prove(inequality, {x: (0, 1)}) with an interval for each of its symbols"
        )
    allowed_steps("prove", steps)
    try:
        with budget(steps):
            return _on_box(lhs, rhs, steps) if isinstance(rhs, Mapping) else _same(lhs, rhs)
    except Exhausted as spent:
        return Verdict(Kind.UNDECIDED, str(spent))
    except RecursionError:
        return Verdict(Kind.UNDECIDED, "nested too deeply")
    except (Undefined, ZeroDivisionError):  # SymPy's of a number that nobody has evaluated
        return Verdict(Kind.UNDECIDED, "a number in it divides by zero")


def _same(lhs: Form, rhs: Form) -> Verdict:
    left, right = form_of("prove", lhs), form_of("prove", rhs)
    forms = (*parts(left), *parts(right))
    related = any(isinstance(part, (Relational, BooleanAtom)) for part in parts(right))
    if isinstance(left, Relational) and isinstance(right, list) and not related:
        raise TypeError(
            f"prove: rhs: {rhs!r} is no relation to compare {left} with and no box; a relation is "
            "allowed, or {x: (0, 1)} with an interval for each symbol"
        )
    spend_reading(*forms)
    if any(_complex_part_of_unknown(form) for form in forms):
        return Verdict(Kind.UNDECIDED, "an unknown function need not be real")
    names = shared("prove", {s for form in forms for s in form.free_symbols})
    try:
        result = compare(left, right, anywhere=True)
        if result.equal is None:
            return Verdict(Kind.UNDECIDED, result.method)
        point = where_defined(*(renamed(form, names) for form in forms), at=result.point)
    except (Uncheckable, Unsupported) as unknown:
        return Verdict(Kind.UNDECIDED, str(unknown))
    if point is None:
        return Verdict(Kind.UNDECIDED, "no point is found at which both sides are defined")
    if not result.equal:
        return Verdict(Kind.REFUTED, result.method, counterexample=named(point))
    return Verdict(Kind.PROVED, result.method)


def _complex_part_of_unknown(form: Any) -> bool:
    """Real coefficients are known of the paper's transfer functions, not of a user's H."""
    return any(part.has(AppliedUndef) for part in form.atoms(sp.re, sp.im, sp.conjugate, sp.Abs))


def _on_box(relation: Form, ends: Ends, steps: int) -> Verdict:
    if isinstance(relation, (bool, BooleanAtom)):
        raise TypeError(
            f"prove: the inequality is {relation} already: SymPy decided it when it was written; "
            "evaluate=False keeps it as it is"
        )
    if not isinstance(relation, Relational) or isinstance(relation, (sp.Eq, sp.Ne)):
        raise TypeError(f"prove: {relation!r} is no inequality; give one of <, <=, >, >=")
    form_of("prove", relation)
    spend_reading(relation)
    floats = sorted(relation.atoms(sp.Float))
    if floats:
        raise ValueError(f"prove: {floats[0]} is no exact number; Rational(1, 10) is one, say")
    box, (relation,) = box_of("prove", ends, relation)
    smaller, larger = relation.lhs, relation.rhs
    if isinstance(relation, (sp.StrictGreaterThan, sp.GreaterThan)):
        smaller, larger = larger, smaller
    difference = larger - smaller
    try:
        found = boxes.search(difference, box, defined=(smaller, larger), steps=steps)
    except (Unsupported, boxes.NotShown) as wrong:
        return Verdict(Kind.UNDECIDED, str(wrong))
    if found is None:
        return Verdict(
            Kind.UNDECIDED,
            "the pieces of the box became too many, or a side is not defined and real on it",
        )
    if isinstance(found, Positive):
        if not recheck(found):
            return Verdict(Kind.UNDECIDED, "found by balls, and not confirmed when checked again")
        pieces = f"{found.pieces} piece" + ("s" if found.pieces > 1 else "")
        return Verdict(Kind.ENCLOSED, f"ball arithmetic on {pieces}", certificate=found)
    if found.touches and isinstance(relation, (sp.LessThan, sp.GreaterThan)):
        return Verdict(Kind.UNDECIDED, "both sides are equal somewhere")
    known = all(admissible(symbol, at) for symbol, at in found.point.items())
    if not known or truth(relation, found.point) is not False:
        return Verdict(Kind.UNDECIDED, "a point seems to deny it, and is not confirmed")
    return Verdict(Kind.REFUTED, "ball arithmetic at a point", counterexample=named(found.point))
