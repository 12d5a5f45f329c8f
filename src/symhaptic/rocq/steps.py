"""A theorem and what it was made of, as lemmas: one for each rule that was applied.

A lemma says its theorem for all free symbols under its hypotheses.  Rules of logic are proved by
the term that they are; a decider's leaf by the tactics that check it; a classical rule that the
prelude does not prove becomes an axiom of its own, an instance with its premises before it.
"""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field

from sympy import Expr, Symbol

from symhaptic.book.rests import Said, said
from symhaptic.notation.proposition import And, Proposition
from symhaptic.notation.terms import is_complex
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.propositions import text, typed
from symhaptic.rocq.terms import Names, NotPrinted, real_text


@dataclass
class Step:
    """One lemma: its name, its rule, what it says, and how it is proved or why it is not."""

    name: str
    rule: str
    free: tuple[Symbol, ...]
    hypotheses: tuple[Proposition, ...]
    conclusion: Proposition
    statement: str
    kind: str = "Lemma"
    lines: list[str] = field(default_factory=list)
    why: str = ""
    """The source of a classical rule, or why a leaf is not checked."""
    pieces: int = 0
    """Of a box: into how many it was cut."""

    def written(self) -> str:
        """The lemma with its proof."""
        note = f" {self.why}" if self.why else ""
        head = wrapped(comment(f"{self.rule}.{note}"), "")
        claim = wrapped(f"{self.kind} {self.name} : {self.statement}.", "  ")
        if self.kind == "Axiom":
            return f"{head}\n{claim}\n"
        proof = "\n".join(wrapped(line, "  ", "    ") for line in self.lines)
        return f"{head}\n{claim}\nProof.\n{proof}\nQed.\n"


def is_open(name: str) -> bool:
    """Whether an axiom of a file is a leaf that is not checked."""
    return name.startswith("open_")


def comment(text: str) -> str:
    """A comment; Rocq reads strings in it, and comments in comments."""
    return f"(* {text.replace(chr(34), chr(39)).replace('(*', '( *').replace('*)', '* )')} *)"


def wrapped(line: str, indent: str, further: str | None = None) -> str:
    """A line of at most 100 characters, or several."""
    first = indent if further is not None else ""
    return textwrap.fill(
        line,
        100,
        initial_indent=first,
        subsequent_indent=indent if further is None else further,
        break_long_words=False,
        break_on_hyphens=False,
    )


def stated(theorem: Theorem) -> tuple[tuple[Symbol, ...], tuple[Proposition, ...], str]:
    """Free symbols and hypotheses in the order of the lemma, and what the lemma says."""
    everything = theorem.conclusion.free.union(*(h.free for h in theorem.hypotheses))
    free = tuple(sorted(everything, key=lambda s: (s.name, getattr(s, "dummy_index", 0))))
    names = Names()
    with names.bound(*free) as over:
        then = text(theorem.conclusion, names)
        given = sorted((text(h, names), i) for i, h in enumerate(theorem.hypotheses))
        of = list(theorem.hypotheses)
        order = tuple(of[i] for _, i in given)
        body = " -> ".join([*(g for g, _ in given), then])
        head = f"forall {typed(free, over)}, " if free else ""
    return free, order, head + body


class Proof:
    """The proof of one lemma while it is written: names of symbols, and of what is known."""

    def __init__(self, step: Step, known: Mapping[Said, Step], names: Names) -> None:
        self.step, self.known, self.names = step, known, names
        self.lines: list[str] = []
        self.scope: dict[Proposition, str] = {}
        self.helpers: list[Step] = []
        """Lemmas that it uses and that are no theorems of the chapter."""
        self._count = 0

    def new(self, letter: str) -> str:
        """A name for something that becomes known."""
        self._count += 1
        return f"{letter}{self._count}"

    def say(self, *lines: str) -> None:
        """Further tactics."""
        self.lines += lines

    def know(self, claim: Proposition, name: str) -> None:
        """A proposition and, of a conjunction, its parts, by name."""
        self.scope.setdefault(claim, name)
        if isinstance(claim, And) and len(claim.of) > 1:
            for i, one in enumerate(claim.of):
                last = i == len(claim.of) - 1
                term = name
                for _ in range(i):
                    term = f"(proj2 {term})"
                self.know(one, term if last else f"(proj1 {term})")
        elif isinstance(claim, And) and claim.of:
            self.know(claim.of[0], name)

    def find(self, claim: Proposition) -> str:
        """A term that proves what is known."""
        if claim in self.scope:
            return self.scope[claim]
        if isinstance(claim, And):
            return self.joined([self.find(p) for p in claim.of])
        raise NotPrinted(f"a step that does not know {type(claim).__name__}")

    def knows(self, claim: Proposition) -> bool:
        """Whether it is among what is known, or all its parts are."""
        parts = claim.of if isinstance(claim, And) else ()
        return claim in self.scope or (isinstance(claim, And) and all(map(self.knows, parts)))

    @staticmethod
    def joined(parts: Sequence[str]) -> str:
        """A proof of a conjunction."""
        if not parts:
            return "I"
        found = parts[-1]
        for one in reversed(parts[:-1]):
            found = f"(conj {one} {found})"
        return found

    def have(self, premise: Theorem) -> str:
        """A term that proves a premise here; its hypotheses are known."""
        if premise.rule == "assume":
            return self.find(premise.conclusion)
        step = self.known[said(premise)]
        values = [self.value(s) for s in step.free]
        args = [*values, *(self.find(h) for h in step.hypotheses)]
        return f"({' '.join([step.name, *args])})" if args else step.name

    def value(self, symbol: Symbol) -> str:
        """A symbol, or any number for one that is not spoken of."""
        if symbol in self.names:
            return self.names[symbol]
        return "(RtoC 0)" if is_complex(symbol) else "0"

    def keep(self, premise: Theorem, letter: str = "P") -> str:
        """A premise under a name of its own."""
        term = self.have(premise)
        name = self.new(letter)
        self.say(f"pose proof {term} as {name}.")
        self.know(premise.conclusion, name)
        return name

    def real(self, expr: Expr) -> str:
        """A real term here, in brackets."""
        return f"({real_text(expr, self.names)})"

    def function(self, variable: Symbol, expr: Expr) -> str:
        """A function of reals, in brackets."""
        with self.names.bound(variable) as [v]:
            return f"(fun {v} : R => {real_text(expr, self.names)})"

    def text(self, claim: Proposition) -> str:
        """A proposition here."""
        return text(claim, self.names)


def premises(theorem: Theorem) -> tuple[Theorem, ...]:
    """What a theorem was made of; lemmas that a tactic took from a set in an order of their own."""
    fixed = {"prove_hyp": 1, "is_whole": 0}.get(theorem.rule, len(theorem.premises))
    if len(theorem.premises) < fixed + 2:
        return theorem.premises
    lemmas = sorted(
        theorem.premises[fixed:],
        key=lambda t: (repr(t.conclusion), sorted(map(repr, t.hypotheses))),
    )
    return *theorem.premises[:fixed], *lemmas


def order(theorems: Iterable[Theorem]) -> Iterator[Theorem]:
    """Theorems and all below them, premises first, each once; without mere assumptions."""
    seen: set[Said] = set()
    for root in theorems:
        stack: list[tuple[Theorem, bool]] = [(root, False)]
        while stack:
            theorem, done = stack.pop()
            what = said(theorem)
            if what in seen or theorem.rule == "assume":
                continue
            if done:
                seen.add(what)
                yield theorem
            else:
                stack.append((theorem, True))
                stack += [(p, False) for p in reversed(premises(theorem))]
