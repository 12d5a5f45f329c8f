"""Symbols that equations define, put in for what they stand for and out again."""

from symhaptic.book.lemmas.prelude import *
from symhaptic.notation.terms import is_complex
from symhaptic.proof.theorems.definedness import real


def _place(name: Symbol, form: Expr, met: frozenset[Symbol]) -> Symbol:
    """A symbol for the place of another and of what it stands for, complex as either may be.

    It is none of those that the claim has.
    """
    places = map(
        sp.Symbol, ("c", "X_d", "c_3") if is_complex(name) or not real(form) else ("q", "q_k")
    )
    return next(place for place in places if place not in met)


def definitions(given: Any) -> list[Theorem]:
    """The equations among hypotheses that define a symbol, assumed."""
    equations = (g for g in given if isinstance(g, Relation) and g.sign == "=")
    return [assume(e) for e in equations if e.left.is_Symbol]


def renamed(theorem: Theorem, pattern: Proposition, *equations: Theorem) -> Theorem:
    """The theorem ``pattern``, from itself with the right side of each equation for its left.

    Each equation defines a symbol; it may hold symbols that were defined before.
    """
    names = [e.conclusion.left for e in equations]  # type: ignore[attr-defined]
    forms = [e.conclusion.right for e in equations]  # type: ignore[attr-defined]
    met = pattern.free.union(*(f.free_symbols for f in forms))
    for i, equation in enumerate(equations):
        name, form = names[i], forms[i]
        later: dict[Symbol, Expr] = {}
        for other, value in zip(names[i + 1 :], forms[i + 1 :], strict=True):
            later[other] = value.xreplace(later)
        place = _place(name, form, met)
        here = {name: place} | {n: v.xreplace({name: place}) for n, v in later.items()}
        turned = combined(Relation(form, "=", name), [equation, -sp.S.One])
        theorem = subst(pattern.at(here), place, theorem, turned)
    return theorem


def explicit(form: Any, *equations: Theorem) -> Any:
    """A term or claim with the right sides of equations for their left sides."""
    values: dict[Symbol, Expr] = {}
    for e in equations:
        values[e.conclusion.left] = e.conclusion.right.xreplace(values)  # type: ignore[attr-defined]
    return form.at(values) if isinstance(form, Proposition) else form.xreplace(values)


def unnamed(theorem: Theorem, *equations: Theorem) -> list[Theorem]:
    """A theorem with the right sides of equations for their left sides, one after the other."""
    found = [theorem]
    for equation in reversed(equations):
        name = equation.conclusion.left  # type: ignore[attr-defined]
        if name in theorem.conclusion.free:
            form = equation.conclusion.right  # type: ignore[attr-defined]
            place = _place(name, form, theorem.conclusion.free | form.free_symbols)
            theorem = subst(theorem.conclusion.at({name: place}), place, theorem, equation)
            found.append(theorem)
    return found
