"""Theorems, and the rules of logic that make them.

A theorem says that its conclusion is true for all values of the free symbols (real ones, or complex
where the notation says so) for which its hypotheses are true.  Only rules make one: each takes
theorems and terms, and gives hypotheses and a conclusion.  A theorem keeps the rule and what it was
given.

Rules are functions of this module, of ``leaves``, ``axioms``, ``analysis``, ``energy``,
``roots``, ``samples`` and ``definitions``; no other module can add one.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from fractions import Fraction
from functools import wraps
from typing import Any, ParamSpec, TypeAlias
from weakref import WeakValueDictionary

from sympy import Basic, Expr, Symbol
from sympy.core.relational import Relational

from symhaptic.notation.proposition import (
    FALSE,
    KINDS,
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
)
from symhaptic.notation.terms import Term, is_complex, term, tree
from symhaptic.proof.certificate import Positive
from symhaptic.proof.rewriting import Undefined, Unsupported
from symhaptic.proof.theorems.definedness import conditions, kept, limits, needed, real


class NotShown(ValueError):
    """A rule that does not apply; the message says what is missing."""


Judgement: TypeAlias = tuple[Iterable[Proposition], Proposition]
"""Hypotheses and conclusion."""

_TOKEN = object()


class Theorem:
    """``hypotheses`` imply ``conclusion``; made by rules only."""

    __slots__ = ("__weakref__", "_given", "_rule", "conclusion", "hypotheses")

    hypotheses: frozenset[Proposition]
    conclusion: Proposition
    _rule: str
    _given: tuple[Any, ...]

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

    @property
    def rule(self) -> str:
        """The rule that made it."""
        return self._rule

    @property
    def given(self) -> tuple[Any, ...]:
        """What the rule was given."""
        return self._given

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
        return _derived(name, tuple(map(_read, args)), {k: _read(v) for k, v in named.items()})

    return apply


def _derived(name: str, args: tuple[Any, ...], named: dict[str, Any]) -> Theorem:
    same = _same((name, args, tuple(named.items())))
    known = None if same is None else _known.get(same)
    if known is not None:
        return known
    try:
        judgement = _RULES[name](*args, **named)
    except (Unsupported, Undefined) as why:  # a decider's, that it cannot tell
        raise NotShown(str(why)) from None
    found = Theorem(_TOKEN, judgement, name, (*args, *named.values()))
    if same is not None:
        _known[same] = found
    return found


_known: WeakValueDictionary[Any, Theorem] = WeakValueDictionary()
"""What was derived here and is still in somebody's hands, by its rule and what that was given.

A rule gives the same for the same, so that this is the theorem and not a copy of one."""


def _same(part: Any) -> Any:
    """What only equal arguments share, names of bound symbols included; None where nothing is."""
    if isinstance(part, (tuple, dict)):
        items = part.items() if isinstance(part, dict) else part
        parts = tuple(map(_same, items))
        return None if any(found is None for found in parts) else (type(part).__name__, *parts)
    if isinstance(part, Proposition):
        return _same((type(part).__name__, *part.__reduce__()[1]))
    if isinstance(part, (Theorem, Expr)):
        return part
    return (type(part).__name__, part) if isinstance(part, (str, int)) else None


def _read(part: Any) -> Any:
    """What a rule is given, read once: a class of one's own may say something else the next time.

    SymPy's relations become propositions, since they decide themselves when they are copied.
    """
    if isinstance(part, Relational):
        return proposition(part)
    if isinstance(part, Mapping):
        return {_read(key): _read(value) for key, value in part.items()}
    if isinstance(part, Iterable) and not isinstance(part, (str, Basic)):
        return tuple(map(_read, part))
    if type(part) not in _KINDS and not isinstance(part, Expr):
        raise NotShown(f"{part!r} is no theorem, proposition, term, number, name or certificate")
    return part


_KINDS = KINDS | {Theorem, Positive, int, float, bool, str, Fraction}
"""What a rule is given beside terms, of which :func:`symhaptic.notation.terms.tree` asks."""


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
def add_assum(theorem: Theorem, *more: Any) -> Judgement:
    """G |- q gives G, p |- q."""
    return theorem.hypotheses | {proposition(p) for p in more}, theorem.conclusion


@rule
def disch(theorem: Theorem, *given: Any) -> Judgement:
    """G |- q gives G without p |- p => q; several hypotheses are joined in a conjunction."""
    found = tuple(proposition(p) for p in given)
    if not found:
        raise NotShown("nothing to discharge")
    left = theorem.hypotheses - {c for p in found for c in conjuncts(p)} - set(found)
    return left, Implies((both(found), theorem.conclusion))


@rule
def prove_hyp(theorem: Theorem, *lemmas: Theorem) -> Judgement:
    """Hypotheses that lemmas prove are replaced by the hypotheses of the lemmas."""
    shown = {c for lemma in lemmas for c in conjuncts(lemma.conclusion)}
    shown |= {lemma.conclusion for lemma in lemmas}
    if not shown & theorem.hypotheses:
        raise NotShown("no lemma concludes a hypothesis")
    left = theorem.hypotheses - shown
    return left.union(*(lemma.hypotheses for lemma in lemmas)), theorem.conclusion


@rule
def mp(implication: Theorem, given: Theorem) -> Judgement:
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
def conj(*theorems: Theorem) -> Judgement:
    """p and q give p /\\ q."""
    hypotheses = frozenset[Proposition]().union(*(t.hypotheses for t in theorems))
    return hypotheses, And(tuple(t.conclusion for t in theorems))


@rule
def conjunct(theorem: Theorem, wanted: Any) -> Judgement:
    """p /\\ q gives p."""
    wanted = proposition(wanted)
    if not covers(theorem.conclusion, wanted):
        raise NotShown(f"{wanted} is no part of {theorem.conclusion}")
    return theorem.hypotheses, wanted


@rule
def disj(theorem: Theorem, wanted: Proposition) -> Judgement:
    """p gives p \\/ q."""
    if not isinstance(wanted, Or) or theorem.conclusion not in wanted.of:
        raise NotShown("the conclusion is none of the cases")
    return theorem.hypotheses, wanted


@rule
def disj_cases(cover: Theorem, *cases: Theorem) -> Judgement:
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
def not_intro(theorem: Theorem, denial: Theorem, *given: Any) -> Judgement:
    """p and not p give the negation of a hypothesis, or falsehood if none is named.

    The opposite relation also contradicts a relation, as b <= a does a < b.
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
def contr(falsehood: Theorem, wanted: Any) -> Judgement:
    """Falsehood implies anything."""
    if falsehood.conclusion != FALSE:
        raise NotShown("the premise is not false")
    return falsehood.hypotheses, proposition(wanted)


@rule
def imp_antisym(one: Theorem, other: Theorem) -> Judgement:
    """p => q and q => p give p <=> q."""
    there, back = one.conclusion, other.conclusion
    if not (isinstance(there, Implies) and isinstance(back, Implies) and there.of == back.of[::-1]):
        raise NotShown("the two implications are not each other's converse")
    return one.hypotheses | other.hypotheses, Iff(there.of)


# -- quantifiers -----------------------------------------------------------------------


@rule
def gen(theorem: Theorem, *symbols: Symbol) -> Judgement:
    """If no hypothesis contains a symbol, the conclusion holds for all of its values."""
    without(symbols, theorem.hypotheses)
    return theorem.hypotheses, ForAll(symbols, theorem.conclusion)


@rule
def spec(theorem: Theorem, values: Terms) -> Judgement:
    """For all x: p(x) gives p(a) for a real term; that the term has a value becomes a hypothesis.

    This hypothesis is not added if p(x) is an implication whose premise is a relation or a
    predicate of x itself: the premise is false for a term without a value.  If the premise is an
    order relation, it is not required either that a be real by its form.
    """
    claim = theorem.conclusion
    if not isinstance(claim, ForAll) or set(values) != set(claim.over):
        raise NotShown(f"{claim} is not for all {', '.join(map(str, values))}")
    given = conjuncts(claim.body.parts[0]) if isinstance(claim.body, Implies) else ()
    said = {s for p in given if isinstance(p, (Relation, Predicate)) for s in p.free & {*p.terms}}
    sided = {t for p in given if isinstance(p, Relation) and p.sign in ("<", "<=") for t in p.terms}
    _real({s: v for s, v in values.items() if s not in sided})
    extra = conditions(*(term(v) for s, v in values.items() if s not in said))
    found, lost = put(claim.body, values)
    return theorem.hypotheses | extra | lost, found


@rule
def inst(theorem: Theorem, values: Terms) -> Judgement:
    """Real terms in place of free symbols, in hypotheses and conclusion alike.

    That the terms have values is a hypothesis.  If SymPy cancels a divisor when it writes the
    result, it is also a hypothesis that this divisor is not zero: none may become weaker.
    """
    conclusion, extra = put(theorem.conclusion, values)
    extra |= _real(values) | conditions(*map(term, values.values()))
    hypotheses = set[Proposition]()
    for hypothesis in theorem.hypotheses:
        there, lost = put(hypothesis, values)
        hypotheses |= {there, *lost}
    return hypotheses | extra, conclusion


def put(claim: Proposition, values: Terms) -> tuple[Proposition, frozenset[Proposition]]:
    """A claim at terms as SymPy writes it, and what it divides by no more."""
    there = claim.inst({s: tree(term(v)) for s, v in values.items()})
    written = there.evaluated()
    return written, frozenset(lost(there, written))


def lost(before: Proposition, after: Proposition) -> set[Proposition]:
    """Conditions of a claim's terms that do not follow from what SymPy makes of these terms.

    Under them both claims say the same.  Raises :class:`NotShown` if one is of a bound symbol.
    """
    found: set[Proposition] = set()
    stack: list[tuple[Proposition, Proposition, frozenset[Symbol]]] = [
        (before, after, frozenset[Symbol]())
    ]
    while stack:
        one, other, bound = stack.pop()
        if one is other or type(one) is not type(other):
            continue  # the same, or false for want of a value
        bound |= frozenset(one.bound)
        for old, new in zip(one.trees, other.trees, strict=True):
            if old is not new:
                found |= _dropped(old, new, other, bound)
        stack += [(p, q, bound) for p, q in zip(one.parts, other.parts, strict=True)]
    return found


def _dropped(
    old: Term, new: Term, claim: Proposition, bound: frozenset[Symbol]
) -> set[Proposition]:
    """Conditions of a term that do not follow from those of what SymPy makes of it.

    A divisor is taken as SymPy writes it, too: what it divides by itself has a condition here.
    """
    there, known = limits(new), needed(new, by=claim)
    found = set[Proposition]()
    for condition, power in limits(old):
        written = condition.evaluated()
        here = isinstance(written, Relation) and (
            (written, power.evaluated or power) in there or kept(tree(written.left), known)
        )
        if not here:
            found.add(written)
            if not bound.isdisjoint(written.free):
                raise NotShown(f"a divisor of {old} is lost under its quantifier")
    return found


def _real(values: Terms) -> frozenset[Proposition]:
    """Nothing, if each term is real whose symbol is."""
    for symbol, value in values.items():
        if not is_complex(term(symbol)) and not real(term(value)):
            raise NotShown(f"{value} is not real by its form, {symbol} is")
    return frozenset()


@rule
def subst(pattern: Any, place: Symbol, theorem: Theorem, equation: Theorem) -> Judgement:
    """p(a) and a = b give p(b)."""
    pattern, equal = proposition(pattern), relation(equation, "=")
    before, extra = put(pattern, {place: equal.left})
    if theorem.conclusion != before:
        raise NotShown(f"{theorem.conclusion} is not {pattern} there")
    after, more = put(pattern, {place: equal.right})
    extra |= more | _real({place: equal.left}) | _real({place: equal.right})
    return theorem.hypotheses | equation.hypotheses | extra | conditions(*equal.terms), after


@rule
def exists(theorem: Theorem, wanted: Proposition, values: Terms) -> Judgement:
    """p(a), for real terms a, implies that there is an x with p(x)."""
    if not isinstance(wanted, Exists) or set(values) != set(wanted.over):
        raise NotShown("no value for each of the symbols")
    there, lost_ = put(wanted.body, values)
    if there != theorem.conclusion:
        raise NotShown(f"{theorem.conclusion} is not {wanted} at these values")
    _real(values)
    return theorem.hypotheses | lost_ | conditions(*map(term, values.values())), wanted


@rule
def choose(existence: Theorem, theorem: Theorem) -> Judgement:
    """If there is an x with p(x), and p(x) |- q for a q that does not contain x, then q."""
    claim = existence.conclusion
    if not isinstance(claim, Exists):
        raise NotShown(f"{claim} says nothing of existence")
    left = theorem.hypotheses - {claim.body, *conjuncts(claim.body)}
    known = theorem.conclusion.free.union(*(p.free for p in left))
    if known & set(claim.over):
        raise NotShown("more is said of what exists than its property")
    return left | existence.hypotheses, theorem.conclusion


@rule
def undisch(theorem: Theorem) -> Judgement:
    """p => q gives q under the hypothesis p; p /\\ q => r gives r under both."""
    if not isinstance(theorem.conclusion, Implies):
        raise NotShown("the conclusion is no implication")
    given, then = theorem.conclusion.of
    return theorem.hypotheses | set(conjuncts(given)), then
