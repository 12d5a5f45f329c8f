"""A chapter as a file for Rocq: each theorem that it hands over, with all that it was made of."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from symhaptic.book.chapters import Chapter
from symhaptic.book.rests import Said, said
from symhaptic.book.rules import says
from symhaptic.proof.theorems.axioms import AXIOMS
from symhaptic.proof.theorems.derivation import sources
from symhaptic.proof.theorems.kernel import Theorem
from symhaptic.rocq.classical import CLASSICAL, ELEMENTARY
from symhaptic.rocq.energy import ENERGY
from symhaptic.rocq.leaves import BOXED, COUNTED, LEAVES
from symhaptic.rocq.logic import LOGIC
from symhaptic.rocq.loops import LOOPS
from symhaptic.rocq.meaning import differs
from symhaptic.rocq.propositions import half_said
from symhaptic.rocq.steps import Proof, Step, comment, order, stated, wrapped
from symhaptic.rocq.terms import Names, NotPrinted
from symhaptic.rocq.zeros import ZEROS

SHOWN = CLASSICAL | ZEROS | LOOPS | ENERGY
"""Classical rules that are theorems here."""
WRITTEN = LOGIC | LEAVES | SHOWN
BELIEVED = sources()
"""Rules that are believed, with where each is from; those that are proved here are not asked."""
PROVED = frozenset(SHOWN) | frozenset(ELEMENTARY)
"""Classical rules and axioms that are theorems of Rocq here."""
HALF = "a root of what may be negative, in complex numbers"
OPEN = "not checked:"
"""How the comment of a leaf begins that no tactic checks; it is an axiom named ``open_``."""


@dataclass
class File:
    """The lemmas of a chapter in their order, and which of them each statement is."""

    name: str
    title: str
    steps: list[Step] = field(default_factory=list)
    statements: dict[str, tuple[str, ...]] = field(default_factory=dict)
    """Names of the lemmas by which a statement is settled; none where one is not printed."""
    missing: dict[str, str] = field(default_factory=dict)
    """Why a statement is not printed."""
    says: dict[str, str] = field(default_factory=dict)
    """What each statement says, in words."""
    titles: dict[str, str] = field(default_factory=dict)
    """Of each lemma that the chapter shows, and of each statement, what it is."""

    def written(self, asks: bool = True) -> str:
        """The text: byte by byte the same from run to run; it may ask on what all of it rests."""
        import_ = f"From Symhaptic Require Import {' '.join(['Control', *self._checkers()])}."
        head = [*map(_paragraph, self._head()), import_, ""]
        steps = [f"{self._title(step)}{step.written()}" for step in self.steps]
        # where it is cut short, it names what it has not read yet among the axioms
        ends = ["Unset Default Timeout."] if self.statements else []
        if self.statements:
            names = dict.fromkeys(n for some in self.statements.values() for n in some)
            said = ", ".join(names)
            ends.append(_paragraph("On what Rocq says that all of it rests."))
            ends.append(wrapped(f"Definition all_of_it := {f'({said})' if names else 'I'}.", "  "))
            ends += ["Print Assumptions all_of_it."] if asks else []
        return "\n".join([*head, *steps, *ends]) + "\n"

    def leaves(self) -> File:
        """The leaves that use no other lemma, without what is made of them."""
        steps = [step for step in self.steps if step.rule in ALONE]
        return replace(self, name=f"{self.name}_leaves", steps=steps, statements={}, missing={})

    def _checkers(self) -> list[str]:
        """The files of the checkers that it uses."""
        rules = {step.rule for step in self.steps}
        return [name for name, (some, _) in CHECKERS.items() if rules & some]

    def named_by(self, id: str) -> set[str]:
        """Every name in the lemmas of a statement, and in those that they use."""
        known = {step.name: step for step in self.steps}
        found, left = set[str](), list(self.statements[id])
        while left:
            step = known[left.pop()]
            words = set(re.findall(r"[\w']+", " ".join([step.name, step.statement, *step.lines])))
            left += (words - found) & set(known)
            found |= words
        return found

    def _head(self) -> Iterator[str]:
        """For a reader who knows Rocq and nothing else: what is shown here, and of what."""
        yield self.title
        for id, names in self.statements.items():
            yield f"{id}: {self.says.get(id, '')}: {', '.join(names)}"
        for id, why in self.missing.items():
            yield f"{id} is not here: {why}"
        if self.steps:
            yield (
                HOW
                + "".join(f"; {CHECKERS[name][1]}, in {name}.v" for name in self._checkers())
                + "."
            )
        rules = sorted({step.rule for step in self.steps} - set(AXIOMS))
        for rule in rules:
            yield f"{rule}: {says(rule).partition('. ')[0].removesuffix('.')}."

    def _title(self, step: Step) -> str:
        own = self.titles.get(step.name.removeprefix("open_"))
        return f"{_paragraph(own)}\n" if own else ""


HOW = (
    "Lemmas stand after those that they use. A lemma says a theorem for all of its free symbols: "
    "hypotheses, then conclusion; a relation stands beside what it divides by. Its comment names "
    "the rule that made it, listed below. A classical theorem that the library does not prove is "
    "an axiom named rule_, with its source; one that is named open_ is a step which nobody has "
    "checked here. What is named _fails_ shows a point at which a condition, or what is printed, "
    "fails. Tactics stand in Prelude.v and Control.v; predicates are defined in Polynomials.v "
    "(degree), Circle.v (stable, hurwitz), Device.v, Loop.v, Energy.v (passive), Stored.v and "
    "Answers.v"
)
ALONE = frozenset({"identity", "number", "broken", "tends"}) | BOXED
"""Leaves that use no other lemma."""
CHECKERS = {
    "Boxes": (BOXED, "how the pieces of a box are checked"),
    "Zeros": (COUNTED, "how the zeros of a polynomial are counted"),
}
"""Programs that are proved in Rocq, by their files: for which rules, and what they do."""


def _paragraph(text: str) -> str:
    return wrapped(comment(text), "", "   ")


def slug(id: str) -> str:
    """A name that Rocq allows."""
    return "".join(c if c.isascii() and c.isalnum() else "_" for c in id)


def theorems_of(chapter: Chapter) -> Iterator[tuple[str, str, Theorem]]:
    """Each theorem of a chapter: what kind, by what name, and itself."""
    for block in chapter.page.blocks:
        if block.theorem is not None:
            yield "lemma", str(block.number), block.theorem
    for id, one in chapter.page.settled.items():
        judged = one.settlement.judged
        if judged is not None:
            yield "statement", id, judged.theorem
            for case in judged.unless:
                yield "statement", id, case.theorem


def printed(chapter: Chapter, broken: Mapping[str, str] | None = None) -> File:
    """The file of a chapter; ``broken`` says which lemmas are known to fail, and how."""
    file = File(chapter.name, chapter.title)
    known: dict[Said, Step] = {}
    why: dict[Said, str] = {}
    named = _named(chapter)
    unlike = _unlike(chapter)
    for theorem in order(t for _, _, t in theorems_of(chapter) if said(t) not in unlike):
        if said(theorem) in known:
            continue
        try:
            number, own = len(file.steps) + 1, named.get(said(theorem))
            found = _step(theorem, number, own, known, why)
        except NotPrinted as wrong:
            why[said(theorem)] = str(wrong)
            continue
        if broken:
            found = _opened_where(found, broken)
        known[said(theorem)] = found[-1]
        there = {step.name for step in file.steps}
        file.steps += [step for step in found if step.name not in there]
    for kind, id, theorem in theorems_of(chapter):
        if kind == "statement":
            file.says[id] = chapter.page.settled[id].statement.says
            if said(theorem) in unlike:
                file.missing.setdefault(id, unlike[said(theorem)])
            elif said(theorem) in known:
                file.statements[id] = (*file.statements.get(id, ()), known[said(theorem)].name)
            else:
                file.missing.setdefault(id, why.get(said(theorem), "a mere assumption"))
    file.titles = {
        f"lemma_{block.number}": f"Theorem {block.number}: {block.title}."
        for block in chapter.page.blocks
        if block.theorem is not None
    }
    file.statements = {id: names for id, names in file.statements.items() if id not in file.missing}
    return file


def _unlike(chapter: Chapter) -> dict[Said, str]:
    """Why a theorem of a chapter is not printed: the text would not say the same."""
    found = {}
    for kind, _, theorem in theorems_of(chapter):
        if any(map(half_said, (*theorem.hypotheses, theorem.conclusion))):
            found[said(theorem)] = HALF
        elif kind == "statement" and (wrong := _says_else(theorem)):
            found[said(theorem)] = wrong
    return found


def _says_else(*theorems: Theorem) -> str | None:
    """Where the text of theorems is found to say something else than the theorems."""
    try:
        claims = ((t.hypotheses, (*t.hypotheses, t.conclusion)) for t in theorems)
        return next(filter(None, (differs(said, given) for given, said in claims)), None)
    except NotPrinted as wrong:
        return str(wrong)


def _named(chapter: Chapter) -> dict[Said, str]:
    found: dict[Said, str] = {}
    counts: dict[str, int] = {}
    for kind, name, theorem in reversed(list(theorems_of(chapter))):
        if kind == "lemma":
            found[said(theorem)] = f"lemma_{name}"
    for kind, name, theorem in theorems_of(chapter):
        if kind == "statement":
            counts[name] = counts.get(name, 0) + 1
            suffix = "" if counts[name] == 1 else f"_fails_{counts[name] - 1}"
            found.setdefault(said(theorem), f"statement_{slug(name)}{suffix}")
    return found


def _step(
    theorem: Theorem,
    number: int,
    own: str | None,
    known: Mapping[Said, Step],
    why: Mapping[Said, str],
) -> list[Step]:
    for premise in theorem.premises:
        if premise.rule != "assume" and said(premise) not in known:
            raise NotPrinted(why.get(said(premise), "a premise"))
    free, hypotheses, statement = stated(theorem)
    rule = theorem.given[0] if theorem.rule == "known" else theorem.rule
    step = Step(own or f"step_{number}", rule, free, hypotheses, theorem.conclusion, statement)
    if rule in BOXED:
        step.pieces = theorem.given[0].pieces
    if theorem.rule == "known":
        return [_axiom(step, rule, own)]
    if theorem.rule in BELIEVED and theorem.rule not in SHOWN:
        return _instance(step, theorem, known, number)
    names = Names("0")  # of a symbol that cancels, any number will do
    try:
        if theorem.rule not in WRITTEN:
            raise NotPrinted(f"the rule {theorem.rule}")
        with names.bound(*free) as over:
            proof = Proof(step, known, names)
            _introduce(proof, over)
            WRITTEN[theorem.rule](proof, theorem)
    except NotPrinted as wrong:
        return [_opened(step, str(wrong))]
    step.lines = proof.lines
    return [*proof.helpers, step]


def _introduce(proof: Proof, over: Sequence[str]) -> None:
    given = [proof.new("H") for _ in proof.step.hypotheses]
    for claim, name in zip(proof.step.hypotheses, given, strict=True):
        proof.know(claim, name)
    if over or given:
        proof.say(f"intros {' '.join([*over, *given])}.")


def _opened(step: Step, why: str) -> Step:
    """The leaf as an axiom that every statement on it is seen to rest on."""
    name = step.name if step.name.startswith("open_") else f"open_{step.name}"
    return replace(step, name=name, kind="Axiom", lines=[], why=f"{OPEN} {why}")


def _opened_where(steps: Sequence[Step], broken: Mapping[str, str]) -> list[Step]:
    """The same with those open that are known to fail, under the names that these then have."""
    found, names = list[Step](), dict[str, str]()
    for step in steps:
        if step.name in broken and step.kind != "Axiom":
            found.append(_opened(step, broken[step.name]))
            names[step.name] = found[-1].name
        else:
            lines = [
                re.sub(r"[\w']+", lambda word: names.get(word[0], word[0]), line)
                for line in step.lines
            ]
            found.append(replace(step, lines=lines) if names else step)
    return found


def _axiom(step: Step, name: str, own: str | None) -> Step:
    """What an axiom of the kernel says: proved where Rocq's library knows it."""
    step.name = own or f"known_{slug(name)}"
    step.rule = name
    step.why = AXIOMS[name].source
    if name in ELEMENTARY:
        step.lines = [ELEMENTARY[name]]
    else:
        step.kind = "Axiom"
        step.name = f"axiom_{slug(name)}"
    return step


def _instance(step: Step, theorem: Theorem, known: Mapping[Said, Step], number: int) -> list[Step]:
    """A classical rule, for just this use of it: what its premises say gives what it concludes."""
    used = [p for p in theorem.premises if p.rule != "assume"]
    if any(half_said(c) for t in (theorem, *used) for c in (*t.hypotheses, t.conclusion)):
        raise NotPrinted(HALF)
    if wrong := _says_else(theorem, *used):
        raise NotPrinted(wrong)
    premises = [known[said(p)] for p in used]
    statement = " -> ".join([*(f"({p.statement})" for p in premises), f"({step.statement})"])
    name = f"rule_{theorem.rule}_{number}"
    rule = replace(step, name=name, kind="Axiom", why=BELIEVED[theorem.rule], statement=statement)
    step.lines = [f"exact ({' '.join([name, *(p.name for p in premises)])})."]
    return [rule, step]


__all__ = ["File", "printed", "slug", "theorems_of"]
