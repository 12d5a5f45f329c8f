"""Theorems, and the rules of logic that make them.

A theorem says that its conclusion is true for all values of the free symbols (real ones, or complex
where the notation says so) for which its hypotheses are true.  Nobody but a rule makes one: each
rule takes theorems and terms, and gives hypotheses and a conclusion.  A theorem keeps the rule and
what it was given, so that it is derived once more, from nothing, where it arrives in
another process.

Rules are functions of this module, of ``leaves``, ``axioms``, ``analysis``, ``energy``,
``roots``, ``samples`` and ``definitions``; no other module can add one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import wraps
from importlib import import_module
from types import NoneType
from typing import Any, ParamSpec, TypeAlias
from weakref import WeakValueDictionary

from sympy import Basic, Expr, Mul, S, Symbol
from sympy.core.relational import Relational

from symhaptic.notation.proposition import (
    FALSE,
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
    Terms,
    both,
    conjuncts,
    negated,
    proposition,
    replaced,
)
from symhaptic.notation.terms import is_complex, symbols_in, term, without_value
from symhaptic.proof.certificate import Positive
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.theorems.definedness import conditions, differs, needed, real


class NotShown(ValueError):
    """A rule that does not apply; the message says what is missing."""


Judgement: TypeAlias = tuple[Iterable[Proposition], Proposition]
"""Hypotheses and conclusion."""

_TOKEN = object()
_DATA = (Positive, str, bool, int, float, Fraction, NoneType)


class Theorem:
    """``hypotheses`` imply ``conclusion``; made by rules only."""

    __slots__ = ("__weakref__", "_given", "_rule", "conclusion", "hypotheses")

    hypotheses: frozenset[Proposition]
    conclusion: Proposition
    _rule: str
    _given: tuple[tuple[Any, ...], tuple[tuple[str, Any], ...]]

    def __init__(self, token: object, judgement: Judgement, rule: str, given: Any) -> None:
        if token is not _TOKEN:
            raise NotShown("a theorem is made by a rule, not by hand")
        hypotheses, conclusion = judgement
        object.__setattr__(self, "hypotheses", frozenset(hypotheses))
        object.__setattr__(self, "conclusion", conclusion)
        object.__setattr__(self, "_rule", rule)
        object.__setattr__(self, "_given", given)

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a theorem does not change")

    def __reduce__(self) -> Any:
        return _arrived, (self._rule, *self._given)

    @property
    def rule(self) -> str:
        """The rule that made it."""
        return self._rule

    @property
    def given(self) -> tuple[Any, ...]:
        """What the rule was given."""
        return (*self._given[0], *(v for _, v in self._given[1]))

    @property
    def premises(self) -> tuple[Theorem, ...]:
        """The theorems that the rule was given."""
        return tuple(_theorems(self.given))

    def __repr__(self) -> str:
        return f"<theorem by {self._rule}: {len(self.hypotheses)} hypotheses, {self.conclusion}>"


_RULES: dict[str, Callable[..., Judgement]] = {}
MODULES = ("kernel", "leaves", "axioms", "analysis", "energy", "roots", "samples", "definitions")
"""The modules of rules, all that has to be believed beside the deciders."""

_HOMES = tuple(f"symhaptic.proof.theorems.{name}" for name in MODULES)

_P = ParamSpec("_P")


def rule(build: Callable[_P, Judgement]) -> Callable[_P, Theorem]:
    """A way to a theorem; refused outside the modules that are to be believed."""
    name = build.__name__
    if build.__module__ not in _HOMES or name in _RULES:
        raise NotShown(f"{build.__module__}.{name} is no rule; rules stand in {', '.join(_HOMES)}")
    _RULES[name] = build

    @wraps(build)
    def apply(*args: _P.args, **named: _P.kwargs) -> Theorem:
        return _derived(name, args, tuple(named.items()))

    return apply


def _derived(name: str, args: tuple[Any, ...], named: tuple[tuple[str, Any], ...]) -> Theorem:
    args, named = _written(args), _written(named)
    same = _exactly((name, args, named))
    known = _known.get(same)
    if known is not None:
        return known
    try:
        judgement = _RULES[name](*args, **dict(named))
    except (Unsupported, Undefined) as why:  # a decider's, that it cannot tell
        raise NotShown(str(why)) from None
    found = Theorem(_TOKEN, judgement, name, (args, named))
    if same is not None:
        _known[same] = found
    return found


_known: WeakValueDictionary[Any, Theorem] = WeakValueDictionary()
"""What was derived here and is still in somebody's hands, by its rule and what that was given.

A rule gives the same for the same, so that this is the theorem and not a copy of one."""


def at_hand() -> list[Theorem]:
    """What was derived here and need not be derived anew."""
    return list(_known.values())


def forget() -> None:
    """Derive anew from here on, even what has been derived here before."""
    _known.clear()


def _exactly(part: Any) -> Any:
    """What only equal arguments share, names of bound symbols and types included; None for those
    that cannot be told apart so."""
    if isinstance(part, (Theorem, Basic)):
        return part
    part = ("at", *part.items()) if isinstance(part, dict) else part
    if isinstance(part, tuple):
        parts = tuple(map(_exactly, part))
        return None if any(found is None for found in parts) else parts
    if isinstance(part, Proposition):
        return _exactly((type(part).__name__, *part.__reduce__()[1]))
    if isinstance(part, (str, int, NoneType)):
        return type(part).__name__, part
    return None


def _arrived(name: str, args: tuple[Any, ...], named: tuple[tuple[str, Any], ...]) -> Theorem:
    """A theorem from another process, derived here anew."""
    for module in _HOMES:
        import_module(module)
    return _derived(name, args, named)


def _written(part: Any) -> Any:
    """Arguments with propositions for SymPy's relations, which decide themselves when copied.

    A theorem stands where it is found again: by itself or in a sequence.  What holds others is read
    here and never again, and nothing is of a class of its own, which may answer as it likes.
    """
    if isinstance(part, Relational):
        return proposition(part)
    if isinstance(part, (tuple, list)):
        return tuple(_written(p) for p in part)
    if isinstance(part, Mapping):
        return {key: _written(value) for key, value in part.items()}
    if not isinstance(part, (Basic, Proposition)) and type(part) not in (Theorem, *_DATA):
        raise NotShown(f"what looks like a theorem is none, nor is {type(part).__name__} a term")
    return part


def _theorems(parts: Iterable[Any]) -> Iterator[Theorem]:
    for part in parts:
        if isinstance(part, Theorem):
            yield part
        elif isinstance(part, (tuple, dict)):
            yield from _theorems(part.values() if isinstance(part, dict) else part)


def relation(theorem: Theorem, *signs: str) -> Relation:
    """What a theorem concludes, a relation with one of these signs; of any, without."""
    claim = theorem.conclusion
    if not isinstance(claim, Relation) or (signs and claim.sign not in signs):
        raise NotShown(f"{claim} is no relation with {' or '.join(signs or ('a sign',))}")
    return claim


def predicate(theorem: Theorem, name: str) -> Predicate:
    """What a theorem concludes, a predicate of this name."""
    claim = theorem.conclusion
    if not (isinstance(claim, Predicate) and claim.name == name):
        raise NotShown(f"{claim} does not say {name}")
    return claim


def without(symbols: Iterable[Symbol], *parts: Iterable[Proposition]) -> None:
    """Nothing, where they are symbols, and no hypothesis, or other proposition, is about one."""
    claims = [p for some in parts for p in some]
    for symbol in symbols:
        about = [c for c in claims if symbol in c.free]
        if about or not symbol.is_Symbol:
            raise NotShown(f"{about[0] if about else 'no proposition'} is about {symbol}")


# -- hypotheses ------------------------------------------------------------------------


@rule
def assume(claim: Any) -> Judgement:
    """p |- p."""
    claim = proposition(claim)
    return [claim], claim


@rule
def weakened(theorem: Theorem, *more: Any) -> Judgement:
    """G |- q gives G, p |- q."""
    return theorem.hypotheses | {proposition(p) for p in more}, theorem.conclusion


@rule
def discharged(theorem: Theorem, *given: Any) -> Judgement:
    """G |- q gives G without p |- p => q; of several hypotheses, their conjunction implies q."""
    found = tuple(proposition(p) for p in given)
    if not found:
        raise NotShown("nothing to discharge")
    left = theorem.hypotheses - {c for p in found for c in conjuncts(p)} - set(found)
    return left, Implies((both(found), theorem.conclusion))


@rule
def cut(theorem: Theorem, *lemmas: Theorem) -> Judgement:
    """Hypotheses that lemmas conclude give way to the hypotheses of the lemmas."""
    shown = {c for lemma in lemmas for c in conjuncts(lemma.conclusion)}
    shown |= {lemma.conclusion for lemma in lemmas}
    if not shown & theorem.hypotheses:
        raise NotShown("no lemma concludes a hypothesis")
    left = theorem.hypotheses - shown
    return left.union(*(lemma.hypotheses for lemma in lemmas)), theorem.conclusion


@rule
def applied(implication: Theorem, given: Theorem) -> Judgement:
    """p => q and p give q; so does p <=> q, in either direction."""
    claim = implication.conclusion
    hypotheses = implication.hypotheses | given.hypotheses
    if isinstance(claim, Implies) and covers(given.conclusion, claim.of[0]):
        return hypotheses, claim.of[1]
    if isinstance(claim, Iff):
        for one, other in (claim.of, claim.of[::-1]):
            if covers(given.conclusion, one):
                return hypotheses, other
    raise NotShown(f"{given.conclusion} is not what is implied from")


def covers(known: Proposition, wanted: Proposition) -> bool:
    """Whether each part of what is wanted is a part of what is known."""
    have = {known, *conjuncts(known)}
    return wanted in have or all(c in have for c in conjuncts(wanted))


# -- connectives -----------------------------------------------------------------------


@rule
def conjoined(*theorems: Theorem) -> Judgement:
    """p and q give p /\\ q."""
    hypotheses = frozenset[Proposition]().union(*(t.hypotheses for t in theorems))
    return hypotheses, And(tuple(t.conclusion for t in theorems))


@rule
def part(theorem: Theorem, wanted: Any) -> Judgement:
    """p /\\ q gives p."""
    wanted = proposition(wanted)
    if not covers(theorem.conclusion, wanted):
        raise NotShown(f"{wanted} is no part of {theorem.conclusion}")
    return theorem.hypotheses, wanted


@rule
def widened(theorem: Theorem, wanted: Proposition) -> Judgement:
    """p gives p \\/ q."""
    if not isinstance(wanted, Or) or theorem.conclusion not in wanted.of:
        raise NotShown("the conclusion is none of the cases")
    return theorem.hypotheses, wanted


@rule
def by_cases(cover: Theorem, *cases: Theorem) -> Judgement:
    """p \\/ q, and r from either, give r; each case may use its own disjunct as a hypothesis."""
    if not isinstance(cover.conclusion, Or) or not 0 < len(cases) == len(cover.conclusion.of):
        raise NotShown("there is not one theorem for each case")
    hypotheses = set(cover.hypotheses)
    for disjunct, case in zip(cover.conclusion.of, cases, strict=True):
        if case.conclusion != cases[0].conclusion:
            raise NotShown("the cases conclude different things")
        hypotheses |= case.hypotheses - {disjunct, *conjuncts(disjunct)}
    return hypotheses, cases[0].conclusion


@rule
def absurd(theorem: Theorem, denial: Theorem, *given: Any) -> Judgement:
    """p and not p give the negation of a hypothesis; without one, falsehood.

    Of a relation the opposite one denies it, too: a < b and b <= a.
    """
    claim, other = theorem.conclusion, denial.conclusion
    denied = other == Not((claim,)) or (isinstance(claim, Relation) and other in _against(claim))
    if not denied:
        raise NotShown(f"{other} does not contradict {claim}")
    hypotheses = theorem.hypotheses | denial.hypotheses
    found = tuple(proposition(p) for p in given)
    if not found:
        return hypotheses, FALSE
    left = hypotheses - {c for p in found for c in conjuncts(p)} - set(found)
    return left, Not((both(found),))


def _against(claim: Relation) -> set[Proposition]:
    """Relations that cannot hold beside one."""
    left, right = claim.left, claim.right
    against: set[Proposition] = {negated(claim)}
    if claim.sign in ("=", "!="):
        against.add(Relation(right, negated(claim).sign, left))
    if claim.sign == "=":
        against |= {Relation(left, "<", right), Relation(right, "<", left)}
    if claim.sign == "<":
        against |= {Relation(right, sign, left) for sign in ("<", "=")}
        against.add(Relation(left, "=", right))
    return against


@rule
def anything(falsehood: Theorem, wanted: Any) -> Judgement:
    """Falsehood gives anything."""
    if falsehood.conclusion != FALSE:
        raise NotShown("the premise is not false")
    return falsehood.hypotheses, proposition(wanted)


@rule
def equivalent(one: Theorem, other: Theorem) -> Judgement:
    """p => q and q => p give p <=> q."""
    there, back = one.conclusion, other.conclusion
    if not (isinstance(there, Implies) and isinstance(back, Implies) and there.of == back.of[::-1]):
        raise NotShown("the two implications are not each other's converse")
    return one.hypotheses | other.hypotheses, Iff(there.of)


# -- quantifiers -----------------------------------------------------------------------


@rule
def general(theorem: Theorem, *symbols: Symbol) -> Judgement:
    """What holds for a symbol that no hypothesis knows holds for all of its values."""
    without(symbols, theorem.hypotheses)
    return theorem.hypotheses, ForAll(symbols, theorem.conclusion)


@rule
def instance(theorem: Theorem, values: Terms) -> Judgement:
    """For all x: p(x) gives p(a), a real term; its definedness becomes a hypothesis.

    Not where p(x) is an implication from a relation or a predicate of x itself, which is false of
    what has no value; nor need a be real by its form where that is an order relation.
    """
    claim = theorem.conclusion
    if not isinstance(claim, ForAll) or set(values) != set(claim.over):
        raise NotShown(f"{claim} is not for all {', '.join(map(str, values))}")
    given = conjuncts(claim.body.parts[0]) if isinstance(claim.body, Implies) else ()
    said = {s for p in given if isinstance(p, (Relation, Predicate)) for s in p.free & {*p.terms}}
    sided = {t for p in given if isinstance(p, Relation) and p.sign in ("<", "<=") for t in p.terms}
    extra = _real({s: v for s, v in values.items() if s not in sided})
    extra |= conditions(*(term(v) for s, v in values.items() if s not in said))
    return theorem.hypotheses | extra | lost(values, claim.body), claim.body.at(values)


@rule
def placed(theorem: Theorem, values: Terms) -> Judgement:
    """Real terms in place of free symbols, in hypotheses and conclusion alike.

    Where SymPy cancels a divisor of a hypothesis on the way, that it is not zero becomes a
    hypothesis of its own: a hypothesis must not become weaker.
    """
    extra = _allowed(values, theorem.conclusion, *theorem.hypotheses)
    return {p.at(values) for p in theorem.hypotheses} | extra, theorem.conclusion.at(values)


def _allowed(values: Terms, *claims: Proposition) -> set[Proposition]:
    """What has to hold so that claims at these terms are the claims at their values."""
    defined = conditions(*map(term, values.values()))
    return _real(values).union(defined, *(lost(values, claim) for claim in claims))


def _real(values: Terms) -> set[Proposition]:
    """Nothing, if each term is real whose symbol is."""
    for symbol, value in values.items():
        if not is_complex(term(symbol)) and not real(term(value)):
            raise NotShown(f"{value} is not real by its form, {symbol} is")
    return set()


def lost(values: Terms, claim: Proposition) -> set[Proposition]:
    """Conditions of a claim's terms that are no conditions any more of what they become."""
    found: set[Proposition] = set()
    stack = [(claim.apart(values), frozenset[Symbol]())]
    while stack:
        current, inside = stack.pop()
        bound = set(inside) | set(current.bound)
        here = {s: term(v) for s, v in values.items() if s in current.free and s not in bound}
        if not here:
            continue  # it stays as it is, and so do its parts
        for old, new in zip(current.terms, replaced(current.terms, here), strict=True):
            if not conditions(old) or (not symbols_in(new) and without_value(new)):
                continue  # nothing is lost, or the relation is false there, whatever it divides by
            kept = needed(new, by=current)
            for condition in conditions(old, at=here, beside=[new]):
                moved = condition.at(here)
                if not isinstance(moved, Relation):
                    found.add(moved)  # a divisor has no value there
                elif not _kept(moved.left, kept):
                    if moved.free & bound:
                        raise NotShown(f"a divisor of {old} is lost under its quantifier")
                    found.add(moved)
        stack += [(p, frozenset(bound)) for p in current.parts]
    return found


def _kept(divisor: Expr, known: frozenset[Proposition]) -> bool:
    """Whether a divisor is a product of powers of what is not zero, such as s^2 of s."""
    for factor in Mul.make_args(divisor):
        base, power = factor.as_base_exp()
        base = base if power.is_Rational and power > 0 else factor
        if Relation(base, "!=", S.Zero) not in known and not differs(base):
            return False
    return True


@rule
def substituted(pattern: Any, place: Symbol, theorem: Theorem, equation: Theorem) -> Judgement:
    """p(a) and a = b give p(b)."""
    pattern, equal = proposition(pattern), relation(equation, "=")
    before, after = {place: equal.left}, {place: equal.right}
    if theorem.conclusion != pattern.at(before):
        raise NotShown(f"{theorem.conclusion} is not {pattern} there")
    extra = _allowed(before, pattern) | _allowed(after, pattern)
    return theorem.hypotheses | equation.hypotheses | extra, pattern.at(after)


@rule
def witnessed(theorem: Theorem, wanted: Proposition, values: Terms) -> Judgement:
    """p(a), for real terms a, gives that there is an x with p(x)."""
    if not isinstance(wanted, Exists) or set(values) != set(wanted.over):
        raise NotShown("no value for each of the symbols")
    if lost(values, wanted.body) or wanted.body.at(values) != theorem.conclusion:
        raise NotShown(f"{theorem.conclusion} is not {wanted} at these values")
    return theorem.hypotheses | _allowed(values, wanted.body), wanted


@rule
def chosen(existence: Theorem, theorem: Theorem) -> Judgement:
    """There is an x with p(x), and p(x) |- q where q does not know x, give q."""
    claim = existence.conclusion
    if not isinstance(claim, Exists):
        raise NotShown(f"{claim} says nothing of existence")
    left = theorem.hypotheses - {claim.body, *conjuncts(claim.body)}
    known = theorem.conclusion.free.union(*(p.free for p in left))
    if known & set(claim.over):
        raise NotShown("more is said of what exists than its property")
    return left | existence.hypotheses, theorem.conclusion


@rule
def unfolded(theorem: Theorem) -> Judgement:
    """p => q gives q under the hypothesis p, and p /\\ q => r under both."""
    if not isinstance(theorem.conclusion, Implies):
        raise NotShown("the conclusion is no implication")
    given, then = theorem.conclusion.of
    return theorem.hypotheses | set(conjuncts(given)), then
