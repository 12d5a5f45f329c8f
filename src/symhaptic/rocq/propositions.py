"""Propositions as Rocq writes them: a relation beside all that its terms divide by.

A relation here is true only where both sides have values, so ``0 < 1/x`` is printed
``(x <> 0 /\\ 0 < 1/x)``; of a root the radicand is not negative, of a logarithm it is positive.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import sympy as sp
from sympy import Expr, Symbol

from symhaptic.notation.proposition import (
    And,
    Exists,
    ForAll,
    Iff,
    Implies,
    Not,
    Or,
    Predicate,
    Proposition,
    Relation,
)
from symhaptic.notation.terms import is_complex
from symhaptic.proof.theorems.definedness import conditions
from symhaptic.rocq.complexes import complex_text
from symhaptic.rocq.terms import Names, NotPrinted, complex_, imaginary, is_root, real_text

AND = " /\\ "
SIGNS = {"=": "=", "!=": "<>", "<": "<", "<=": "<="}
_JOINED: dict[type[Proposition], tuple[str, str]] = {
    And: (AND, "True"),
    Or: (" \\/ ", "False"),
    Implies: (" -> ", ""),
    Iff: (" <-> ", ""),
}
DEFINED = {"whole": "whole", "increasing": "increasing", "limit": "tends"}
"""Predicates of real terms that the prelude defines."""
REAL = {
    **{"degree": 1, "device": 6, "late_device": 8, "swings": 4, "passive_wall": 5},
    **{"stable_loop": 5, "stable_substituted": 5, "stable_principal": 5, "pole": 5},
    **{"passive": 1, "passive_device": 5},
}
"""Predicates whose first terms, so many beside a function, are real numbers."""


def text(claim: Proposition, names: Names) -> str:
    """A proposition; compound ones stand in brackets."""
    if isinstance(claim, Relation):
        both = (claim.left, claim.right)
        return _beside(both, _relation(claim, names), names)
    if isinstance(claim, Predicate):
        return _predicate(claim, names)
    if isinstance(claim, Not):
        return f"(~ {text(claim.of[0], names)})"
    if isinstance(claim, (ForAll, Exists)):
        with names.bound(*claim.over) as over:
            head = "forall" if isinstance(claim, ForAll) else "exists"
            return f"({head} {typed(claim.over, over)}, {text(claim.body, names)})"
    sign, empty = _JOINED[type(claim)]
    parts = [text(p, names) for p in claim.parts]
    return parts[0] if len(parts) == 1 else f"({sign.join(parts)})" if parts else empty


def typed(symbols: Sequence[Symbol], names: Sequence[str]) -> str:
    """Symbols with their types, as a quantifier binds them."""
    kinds = ["C" if is_complex(s) else "R" for s in symbols]
    if len(set(kinds)) == 1:
        return f"{' '.join(names)} : {kinds[0]}"
    return " ".join(f"({n} : {k})" for n, k in zip(names, kinds, strict=True))


def _relation(claim: Relation, names: Names) -> str:
    left, right = claim.left, claim.right
    if not complex_(left, right):
        return f"{real_text(left, names)} {SIGNS[claim.sign]} {real_text(right, names)}"
    sides = complex_text(left, names), complex_text(right, names)
    if claim.sign in ("=", "!="):
        return f"({sides[0]} {SIGNS[claim.sign]} {sides[1]} :> C)%C"
    return f"({'Cless' if claim.sign == '<' else 'Cless_eq'} ({sides[0]})%C ({sides[1]})%C)"


def needed(*terms: Expr) -> list[Proposition]:
    """What has to hold so that terms have the values that Rocq gives them."""
    terms = tuple(map(imaginary, terms))
    found = set(conditions(*terms))
    for expr in terms:
        for part in sp.preorder_traversal(expr):
            if is_root(part):
                if not (part.base.is_Rational and part.base >= 0):
                    found.add(Relation(sp.S.Zero, "<=", part.base))
            elif isinstance(part, sp.log):
                found.add(Relation(sp.S.Zero, "<", part.args[0]))
    return list(found)


def half_said(claim: Proposition) -> bool:
    """Whether the text says less: a root is real there, and here it may be imaginary.

    A real number equals or exceeds no imaginary one: of a single root, multiplied by nothing that
    may vanish, an order or an equation says the same.
    """
    if isinstance(claim, Relation):
        roots = [(t, r) for t in claim.terms for r in _roots(t)]
        once = len(roots) == 1 and not complex_(*claim.terms) and claim.sign != "!="
        return bool(roots) and not (once and _alone(*roots[0]))
    return any(map(half_said, claim.parts)) or any(r for t in claim.terms for r in _roots(t))


def _alone(expr: Expr, root: Expr) -> bool:
    """Whether beside the root there are numbers only, and what it is divided by."""
    return all(
        f == root or f.is_Rational or (f.is_Pow and f.exp.is_Integer and f.exp < 0)
        for f in sp.Mul.make_args(expr)
    )


def _roots(expr: Expr) -> list[Expr]:
    """Roots and logarithms of what has symbols: these are not real where it is negative."""
    parts = sp.preorder_traversal(expr)
    return [p for p in parts if (is_root(p) or isinstance(p, sp.log)) and p.args[0].free_symbols]


def _beside(terms: Sequence[Expr], said: str, names: Names, bound: Collection[Symbol] = ()) -> str:
    """What is said, beside what the terms divide by; not what divides by a bound symbol."""
    known = (c for c in needed(*terms) if isinstance(c, Relation) and c.free.isdisjoint(bound))
    found = sorted({_relation(c, names) for c in known})
    return f"({AND.join([*found, said])})" if found or " " in said else said


def _predicate(claim: Predicate, names: Names) -> str:
    name, terms = claim.name, claim.of
    if name == "whole" and not complex_(*terms):
        return _beside(terms, f"whole ({real_text(terms[0], names)})", names)
    if name in ("increasing", "limit"):
        return _on_line(claim, names)
    first: list[str] = []
    if claim.over:
        with names.bound(*claim.over) as [v]:
            names.as_complex.add(claim.over[0])
            first = [f"(fun {v} : C => {complex_text(terms[0], names)})%C"]
            names.as_complex.discard(claim.over[0])
    rest, count = terms[len(first) :], REAL.get(name, 0)
    if complex_(*rest[:count]):
        raise NotPrinted(f"the predicate {name} of complex terms")
    others = [f"({real_text(t, names)})" for t in rest[:count]]
    others += [f"({complex_text(t, names)})%C" for t in rest[count:]]
    return _beside(terms, " ".join([name, *first, *others]), names, claim.over)


def _on_line(claim: Predicate, names: Names) -> str:
    terms, name = claim.of, DEFINED[claim.name]
    if (complex_(*terms[1:]) and claim.name == "increasing") or complex_(terms[1]):
        raise NotPrinted(f"the predicate {claim.name} of complex terms")
    if complex_(terms[0], terms[2]):
        with names.bound(*claim.over) as [v]:
            body = complex_text(terms[0], names)
        said = (
            f"Ctends (fun {v} : R => ({body})%C) ({real_text(terms[1], names)}) "
            f"({complex_text(terms[2], names)})%C"
        )
        return _beside(terms[1:], said, names)
    with names.bound(*claim.over) as [v]:
        body = real_text(terms[0], names)
        inside = sorted({_relation(c, names) for c in needed(terms[0]) if isinstance(c, Relation)})
    low, high = (real_text(t, names) for t in terms[1:])
    said = f"{name} (fun {v} : R => {body}) ({low}) ({high})"
    if name == "increasing" and inside:
        said = f"(forall {v} : R, {low} < {v} -> {v} < {high} -> {AND.join(inside)}) /\\ {said}"
    return _beside(terms[1:], said, names)
