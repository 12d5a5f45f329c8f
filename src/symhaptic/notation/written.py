r"""Propositions as LaTeX: chains of relations, bounds beside the symbol that they bound."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from sympy import Expr, Symbol

from symhaptic.notation.latex import is_factor, is_sum, latex
from symhaptic.notation.predicates import MEANINGS, TERMS
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
    conjuncts,
)
from symhaptic.notation.terms import Term, tree

SIGNS = {"=": "=", "!=": r"\ne", "<": "<", "<=": r"\le"}
TURNED = {"=": "=", "!=": r"\ne", "<": ">", "<=": r"\ge"}


class _Placed(str):
    r"""LaTeX of a term where it is read as one.

    >>> f"{_Placed('a/b'):factor}x+{_Placed('-b'):term}", f"{_Placed('ab'):base}^k"
    ('(a/b)x+(-b)', '(ab)^k')
    """

    def __format__(self, place: str) -> str:
        whole = {"": True, "term": not is_sum(self), "factor": is_factor(self)}
        stands = whole.get(place, re.fullmatch(r"[A-Za-z]|\d+|\\[A-Za-z]+", self) is not None)
        return str(self) if stands else f"({self})"


def written(claim: Proposition, inline: bool = True) -> str:
    r"""LaTeX of a proposition; ``inline`` avoids built-up fractions.

    >>> from symhaptic.notation import K, T
    >>> from symhaptic.notation.proposition import proposition
    >>> written(And((proposition(K > 0), proposition(K < T))))
    '0<K<T'
    """
    return _written(told_apart(claim), inline)


def told_apart(claim: Proposition) -> Proposition:
    r"""The same with a prime for symbols that would be printed as others that stand in it.

    >>> from sympy import Dummy
    >>> from symhaptic.notation import x
    >>> own = Dummy("x")
    >>> print(written(ForAll((x,), Exists((own,), Relation(x, "<", own)))))
    \forall\,x:\ \exists\,x':\ x<x'
    """
    symbols = dict.fromkeys(sorted(claim.free, key=lambda s: (s.is_Dummy, s.name)))
    stack = [claim]
    while stack:
        part = stack.pop()
        symbols |= dict.fromkeys(part.bound)
        stack += part.parts[::-1]
    taken: set[str] = set()
    names: dict[Symbol, Symbol] = {}
    for symbol in symbols:
        name = symbol.name
        while latex(new := Symbol(name)).strip() in taken:
            name += "'"
        taken.add(latex(new).strip())
        if name != symbol.name:
            names[symbol] = new
    return _renamed(claim, {s: tree(new) for s, new in names.items()}) if names else claim


def _renamed(claim: Proposition, names: Mapping[Symbol, Term]) -> Proposition:
    """A proposition with other names, bound or not."""
    bound = tuple(names[s].head if s in names else s for s in claim.bound)
    terms = tuple(t.inst(names).shown for t in claim.trees)
    return claim.made(bound, terms, tuple(_renamed(p, names) for p in claim.parts))


def _written(claim: Proposition, inline: bool) -> str:
    if isinstance(claim, Relation):
        left, right = latex(claim.left, inline), latex(claim.right, inline)
        if not claim.left.free_symbols and claim.right.free_symbols:
            return _related(right, TURNED[claim.sign], left)
        return _related(left, SIGNS[claim.sign], right)
    if isinstance(claim, Predicate):
        terms = [_Placed(latex(t, inline)) for t in claim.of]
        over = latex(claim.over[0]) if claim.over else ""
        return MEANINGS[claim.name][2].format(*terms, s=over)
    if isinstance(claim, (ForAll, Exists)):
        return _quantified(claim, inline)
    if isinstance(claim, And):
        return listed(conjuncts(claim), inline) or r"\text{true}"
    if isinstance(claim, Or):
        return _cases(claim.of, inline)
    parts = [_bracketed(p, inline) for p in claim.parts]
    if isinstance(claim, Not):
        return _denied(claim.of[0], inline)
    if isinstance(claim, Implies):
        return rf"{parts[0]}\ \Rightarrow\ {parts[1]}"
    if isinstance(claim, Iff):
        return rf"{parts[0]}\ \Leftrightarrow\ {parts[1]}"
    raise TypeError(f"{claim!r} is no proposition")


def defined(name: str) -> tuple[str, str]:
    r"""How a predicate is printed, and what that means, with formulas between dollar signs.

    >>> defined("whole")
    ('n\\in\\mathbb{N}_0', '$n$ is a whole number, zero included')
    """
    variable = {"increasing": "x", "limit": "x", "hurwitz": "s", "passive_device": "v"}
    return MEANINGS[name][2].format(
        *map(_Placed, TERMS[name]), s=variable.get(name, "z")
    ), MEANINGS[name][3]


def _related(left: str, sign: str, right: str) -> str:
    """A relation; a command keeps clear of a letter behind it."""
    return f"{left}{sign}{' ' if sign[0] == chr(92) and right[:1].isalpha() else ''}{right}"


def _denied(claim: Proposition, inline: bool) -> str:
    if isinstance(claim, Predicate) and claim.name == "whole":
        return rf"{latex(claim.of[0], inline)}\notin\mathbb{{N}}_0"
    if isinstance(claim, And) and len(chains(conjuncts(claim))) > 1:
        return rf"\text{{not}}\ ({_written(claim, inline)})"
    return rf"\text{{not}}\ {_bracketed(claim, inline)}"


def _cases(claims: Sequence[Proposition], inline: bool = True) -> str:
    r"""Propositions of which one holds; what has to hold together in one of them is bracketed.

    >>> from symhaptic.notation import K, T
    >>> from symhaptic.notation.proposition import proposition
    >>> positive, one = proposition(K > 0), proposition(T >= 1)
    >>> print(_cases((And((positive, one)), proposition(K < 0))))
    (K>0,\ T\ge1)\ \text{or}\ K<0
    >>> print(_cases((one,)))
    T\ge1
    """
    if len(claims) == 1:
        return _written(claims[0], inline)
    parts = [
        rf"({_written(p, inline)})" if len(conjuncts(p)) > 1 else _bracketed(p, inline)
        for p in claims
    ]
    return r"\ \text{or}\ ".join(parts) or r"\text{false}"


def _bracketed(claim: Proposition, inline: bool) -> str:
    text = _written(claim, inline)
    alone = isinstance(claim, (Relation, Predicate, Not)) or (
        isinstance(claim, And) and all(isinstance(p, (Relation, Predicate)) for p in claim.parts)
    )
    if alone:
        return text
    return rf"\bigl({text}\bigr)" if inline else rf"\left({text}\right)"


def listed(claims: Sequence[Proposition], inline: bool = True) -> str:
    """Propositions beside each other."""
    return r",\ ".join(chains(claims, inline))


def chains(claims: Sequence[Proposition], inline: bool = True) -> list[str]:
    """Propositions one by one, two bounds of one term as a chain."""
    left = list(claims)
    out: list[str] = []
    while left:
        claim = left.pop(0)
        chain = upper(claim, left)
        if chain is not None:
            assert isinstance(claim, Relation)
            left.remove(chain)
            lower = latex(claim.left, inline)
            middle = latex(claim.right, inline)
            highest = latex(chain.right, inline)
            inner = _related(middle, SIGNS[chain.sign], highest)
            out.append(_related(lower, SIGNS[claim.sign], inner))
        else:
            out.append(_bracketed(claim, inline))
    return out


def upper(claim: Proposition, others: Sequence[Proposition]) -> Relation | None:
    """The bound from above of what a relation bounds from below."""
    if not (isinstance(claim, Relation) and claim.sign in ("<", "<=") and claim.right.free_symbols):
        return None
    for other in others:
        if isinstance(other, Relation) and other.sign in ("<", "<=") and other.left == claim.right:
            return other
    return None


def _quantified(claim: ForAll | Exists, inline: bool = True) -> str:
    r"""The symbol stands before its conditions, unless one of them shows which it is.

    >>> from symhaptic.notation import K, T
    >>> from symhaptic.notation.proposition import implied, proposition
    >>> for given in proposition(K > 0), proposition(K * T < 1):
    ...     print(_quantified(ForAll((K,), implied([given], proposition(K < 2)))))
    \forall\,K>0:\ K<2
    \forall\,K\ \text{with}\ KT<1:\ K<2
    """
    sign = r"\forall" if isinstance(claim, ForAll) else r"\exists"
    head, rest, body = parted(claim, inline)
    joined = r"\Rightarrow" if isinstance(claim, ForAll) else r"\text{and}"
    lead = rf"{listed(rest, inline)}\ {joined}\ " if rest else ""
    return rf"{sign}\,{head}:\ {lead}{(_bracketed if rest else _written)(body, inline)}"


def parted(
    claim: ForAll | Exists, inline: bool = True
) -> tuple[str, list[Proposition], Proposition]:
    """The symbols of a quantifier with their conditions, other conditions, and what it is of."""
    body = claim.body
    given: tuple[Proposition, ...] = ()
    if isinstance(claim, ForAll) and isinstance(body, Implies):
        given, body = conjuncts(body.of[0]), body.of[1]
    if isinstance(claim, Exists) and isinstance(body, And):
        given, body = conjuncts(body)[:-1], conjuncts(body)[-1]
    own = [g for g in given if g.free & set(claim.over) and not isinstance(g, (ForAll, Exists))]
    rest = [g for g in given if g not in own]
    if len(claim.over) == 1 and any(_bounds(g, claim.over[0]) for g in own):
        head = listed(own, inline)
    else:
        head = ",".join(latex(s) for s in claim.over)
        head += rf"\ \text{{with}}\ {listed(own, inline)}" if own else ""
    return head, rest, body


def _bounds(given: Proposition, symbol: Symbol) -> bool:
    """Whether a condition says by its form which symbol it is of, as 0 < x does of x."""
    if isinstance(given, Relation):
        return symbol in given.terms
    return isinstance(given, Predicate) and given.name == "whole" and given.of[0] == symbol


def point(values: dict[Expr, Expr]) -> dict[str, str]:
    """A point with plain names and exact numbers as text."""
    return {str(s): str(v) for s, v in values.items()}
