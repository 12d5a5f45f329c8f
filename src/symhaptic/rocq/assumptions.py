"""What a statement rests on: the axioms that Rocq lists for a chapter, laid to its statements."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from symhaptic.book.foreign import EXCLUDED, EXTENSIONAL, INTEGERS, LIBRARY, REALS
from symhaptic.proof.theorems.axioms import AXIOMS
from symhaptic.rocq.chapter import BELIEVED, WRITTEN, File, slug
from symhaptic.rocq.steps import is_open

_STANDARD = {
    "ClassicalDedekindReals.sig_forall_dec": REALS,
    "ClassicalDedekindReals.sig_not_dec": REALS,
    "Classical_Prop.classic": EXCLUDED,
    "FunctionalExtensionality.functional_extensionality_dep": EXTENSIONAL,
    "functional_extensionality_dep": EXTENSIONAL,
}
_PRIMITIVE = (
    "PrimInt63.",
    "Uint63.",
    "Sint63.",
    "PrimFloat.",
    "FloatAxioms.",
    "Uint63Axioms.",
    "FloatOps.",
)


def rule_of(name: str) -> str:
    """The classical rule or axiom of our kernel that an axiom of a file stands for.

    >>> rule_of("rule_roots_stay_91"), rule_of("axiom_passive_wall"), rule_of("hidden")
    ('roots_stay', 'passive wall', 'hidden')
    """
    instance = re.fullmatch(r"rule_(\w+?)(_\d+)?", name)
    if instance and instance[1] in BELIEVED | WRITTEN:
        return instance[1]
    return _AXIOMS.get(name, name)


_AXIOMS = {f"axiom_{slug(name)}": name for name in AXIOMS}


def resting(
    file: File, listed: Iterable[str], own: Mapping[str, Sequence[str]]
) -> dict[str, list[str]]:
    """What each statement rests on: what all of them do, but for what only others' lemmas name.

    ``own`` has the file's names by those that Rocq lists.
    """
    found = {here for name in listed for here in own.get(name, [name])}
    here = {step.name for step in file.steps}
    named = {id: file.named_by(id) & here for id in file.statements}
    others = set[str]().union(*named.values())  # what no lemma names is laid to all of them
    return {id: sorted(found - (others - own)) for id, own in named.items()}


def axioms(said: str) -> set[str]:
    r"""What ``Print Assumptions`` lists, with the library's under four names.

    Lines that name no axiom are kept as they are: they report which checks were switched off.

    >>> sorted(axioms("Axioms:\nmine : False\nloop is assumed to be guarded.\n"))
    ['loop is assumed to be guarded.', 'mine']
    """
    lines = (line for line in said.splitlines() if line.strip() and not line[0].isspace())
    told = (line for line in lines if line not in _NO_AXIOM)
    return {_short(re.sub(r"^([\w.']+)( :.*)?$", r"\1", line)) for line in told}


_NO_AXIOM = ("Axioms:", "Closed under the global context")


def _short(name: str) -> str:
    return INTEGERS if name.startswith(_PRIMITIVE) else _STANDARD.get(name, name)


def told(file: File, rests: dict[str, list[str]]) -> dict[str, str]:
    """Whether a statement is checked whole, or which of its leaves are open."""
    reasons = {s.name: s.why for s in file.steps if is_open(s.name)}
    named = {s.name for s in file.steps if s.kind == "Axiom"}.union(LIBRARY)
    found = {}
    for id, names in rests.items():
        open_ = [n for n in names if n in reasons]
        why = sorted({reasons[n] for n in open_})
        found[id] = f"{len(open_)} steps open: {'; '.join(why)}" if open_ else "whole"
        strange = sorted(set(names) - named)
        if strange:
            found[id] = f"it rests on {', '.join(strange)}, which nobody named"
    return found
