"""What may stand as a ground of a verdict: nothing assumed, nothing put in, nothing idle."""

from __future__ import annotations

import ast
import itertools
import linecache
from collections.abc import Iterable, Mapping, Sequence
from types import CodeType

import sympy as sp
from sympy import Expr

from symhaptic.notation import SYMBOLS
from symhaptic.proof.ball import is_real
from symhaptic.proof.decide import equal
from symhaptic.proof.names import carrying
from symhaptic.proof.normal import is_zero
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.settle import Settlement, is_name
from symhaptic.proof.sign import Fact, facts_below, remade

Rest = tuple[Expr, bool]
Definition = tuple[Expr, Expr]

_ENDS: dict[str, tuple[Expr | None, Expr | None]] = {
    "positive": (sp.S.Zero, None),
    "nonnegative": (sp.S.Zero, None),
    "(0, pi)": (sp.S.Zero, sp.pi),
    "(0, pi/2)": (sp.S.Zero, sp.pi / 2),
    "[0, 1]": (sp.S.Zero, sp.S.One),
}
_CLOSED = frozenset({"nonnegative", "[0, 1]"})


def unproved(fact: Fact, written: Iterable[Rest]) -> str | None:
    """What a fact assumes without its being on the page, or nothing.

    Assumptions are ``written`` with a fact that :meth:`~symhaptic.book.steps.Steps.positive`
    showed; those that the notation makes, and that squares are not negative, need not be.
    """
    if fact.made is None:
        return f"{fact.expr} is assumed, not proved"
    if told := carrying(*(below.expr for below in facts_below(fact))):
        return told
    if any(_same(expr, fact.expr) for expr, _ in fact.rests):
        return f"{fact.expr} rests on itself"
    known = set(written)
    for rest in sorted(fact.rests - known, key=str):
        if not _follows(*rest):
            sign = ">" if rest[1] else ">="
            return f"{fact.expr} rests on {rest[0]} {sign} 0, which is not on the page"
    return None


def _same(one: Expr, other: Expr) -> bool:
    """Whether two expressions differ by a positive factor only."""
    if one == other:
        return True
    if one.free_symbols != other.free_symbols or not (
        one.is_polynomial() and other.is_polynomial()
    ):
        return False
    ratio = sp.cancel(one / other)
    return bool(ratio.is_Rational and ratio > 0)


def _follows(expr: Expr, strict: bool) -> bool:
    """Whether the symbols' domains, or a square, make an assumption true."""
    if expr.is_Pow and expr.exp == 2 and not strict:
        real = all(_domain(s) not in (None, "complex") for s in expr.free_symbols)
        return real and is_real(expr.base)
    if len(expr.free_symbols) != 1:
        return False
    (symbol,) = expr.free_symbols
    domain = _domain(symbol) or ""
    slope = sp.diff(expr, symbol)
    if domain not in _ENDS or slope.free_symbols or slope == 0:
        return False
    end = _ENDS[domain][0 if slope.is_positive else 1]
    if end is None:
        return False
    least = expr.subs(symbol, end)
    return bool(least > 0 or (least == 0 and not (strict and domain in _CLOSED)))


def _domain(symbol: Expr) -> str | None:
    entry = SYMBOLS.get(str(symbol))
    return entry.domain if entry else None


def not_defined(given: Mapping[Expr, Expr], definitions: Sequence[Definition]) -> str | None:
    """What is put into a statement without being a definition on the page, or nothing.

    A definition may be put in as it stands or solved for one of its symbols.
    """
    for name, meaning in given.items():
        if meaning.is_number:
            return f"{name} = {meaning} restricts the statement; a definition is allowed"
        named = _named(definitions)
        if any(_says(known, name, meaning, given) for known in named):
            continue
        if any(is_name(n) and n == name for n, _ in definitions) and name not in dict(named):
            return f"{name} stands for more than one thing on the page"
        return f"{name} = {meaning} is not a definition on the page; `define` it there"
    return None


def _named(definitions: Sequence[Definition]) -> list[Definition]:
    """Those of what has no value of its own, and not by itself, and that stands for one thing:
    neither cos x nor the x of 2 x nor that of 1 and 2 is a name for what an author likes."""
    bare = ((n, meaning) for n, meaning in definitions if not carrying(n, meaning))
    named = [(n, meaning) for n, meaning in bare if is_name(n) and not meaning.has(n)]
    return [(n, m) for n, m in named if all(_alike(m, o, {}) for other, o in named if other == n)]


def _says(definition: Definition, name: Expr, meaning: Expr, given: Mapping[Expr, Expr]) -> bool:
    known, stands_for = definition
    try:
        if known == name:
            return _alike(stands_for, meaning, given)
        if name in stands_for.free_symbols and name not in known.free_symbols:
            return is_zero(known - stands_for.xreplace({name: meaning}))
    except (Unsupported, Undefined):
        return False
    return False


def _alike(one: Expr, other: Expr, given: Mapping[Expr, Expr]) -> bool:
    return one == other or equal(one.xreplace(dict(given)), other.xreplace(dict(given)))


def shows(
    derived: Iterable[Expr], definitions: Sequence[Definition], facts: Sequence[Fact]
) -> bool:
    """Whether what is on a page shows each of some forms."""
    return all(follows(form, definitions, facts) for form in derived)


def not_shown(settlement: Settlement) -> bool:
    """Whether a derived form is typed only: the page, as it was sent, does not show it."""
    facts = [remade(sign) for sign in settlement.signs]
    return not shows(settlement.derived, settlement.definitions, facts)


def follows(relation: Expr, definitions: Sequence[Definition], facts: Iterable[Fact]) -> bool:
    """Whether what is on the page shows a relation: a sign that rests on nothing but the domains
    of the symbols, or what a side stands for."""
    if not isinstance(relation, sp.Eq):
        return any(equal(relation, f.relation) for f in facts if unproved(f, ()) is None)
    named = _named(definitions)
    known = dict(named)
    left, right = ([side, *(m for n, m in named if n == side)] for side in relation.args)
    return any(_alike(one, other, known) for one in left for other in right)


def written_twice(call: CodeType, at: int, skipped: int) -> str | None:
    """An argument of a call that is written twice in a row, or nothing; ``skipped`` come before.

    SymPy evaluates what it is given, so that two sides that were worked out on different ways can
    be one expression.  Only what the author wrote tells whether a thing is compared with itself.
    """
    line, last, first, end = next(itertools.islice(call.co_positions(), at // 2, None))
    if line is None or last is None or first is None or end is None:
        return None
    lines = linecache.getlines(call.co_filename)[line - 1 : last]
    source = "".join(lines).encode()
    cut = len("".join(lines[:-1]).encode()) + end
    try:
        asked = ast.parse(source[first:cut].decode().strip(), mode="eval").body
    except SyntaxError:
        return None
    if not isinstance(asked, ast.Call):
        return None
    for one, other in itertools.pairwise(asked.args[skipped:]):
        if not isinstance(one, ast.Starred) and ast.dump(one) == ast.dump(other):
            return ast.unparse(one)
    return None
