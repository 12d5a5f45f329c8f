"""That a computed formula is the derived one is a statement of the ledger, for every form."""

from functools import cache

import pytest
import sympy as sp
from chapters import chapter

from symhaptic.book.chapters import shipped
from symhaptic.book.lemmas import (
    computed,
    stable_boundary,
    stable_device,
    stable_need,
    stable_slope,
    stable_walls,
)
from symhaptic.book.lemmas.renaming import definitions, explicit
from symhaptic.book.lemmas.stable_forms import Later
from symhaptic.forms import stable
from symhaptic.forms.entire import written_out
from symhaptic.model.parts import FULL
from symhaptic.notation import alpha, c, delta, gamma
from symhaptic.notation.proposition import ForAll, Relation, conjuncts
from symhaptic.proof.theorems.judge import taken_apart
from symhaptic.proof.theorems.kernel import NotShown
from symhaptic.proof.theorems.leaves import identity

DELAY = 2
POLES = sp.sqrt(delta**2 - 4 * gamma)
SPRING = (delta**2 - c**2) / 4


@cache
def settled():
    """The statements of the part on forms, from the pages of its chapters."""
    found = {}
    for path in shipped():
        if path.stem.startswith("s9"):
            found |= chapter(path.stem).page.settled
    return found


@cache
def equations(form):
    """The equations that the ledger's statement on a form claims, without names."""
    statement = settled()[computed.statement(form)]
    found = []
    for part in conjuncts(statement.settlement.claim(())):
        assert isinstance(part, ForAll)
        _, given, then = taken_apart(part)
        own = (explicit(claim, *definitions(given)) for claim in conjuncts(then))
        found += [(c in part.over, e.left, e.right) for e in own if isinstance(e, Relation)]
    return found


@cache
def same(one, other):
    if one == other:
        return True
    try:
        identity(one, other)
    except NotShown:
        return False
    return True


@cache
def by_poles(expr):
    """The same with c for the difference of the poles, of which the claims on devices are."""
    return written_out(expr).subs(POLES, c).subs(gamma, SPRING)


def covered(pair, among):
    """Whether one of the claimed equations has both sides of the pair, not one of them twice."""
    ways = {poles: [(by_poles if poles else written_out)(side) for side in pair]
            for poles in {poles for poles, _, _ in among}}  # fmt: skip
    return any(
        (left != right or ways[poles][0] == ways[poles][1])
        and same(left, ways[poles][0])
        and same(right, ways[poles][1])
        for poles, left, right in among
    )


RESTS = {
    "stability_boundary": "discretize_fractional",
    "max_stable_stiffness": "discretize_fractional",
    "passivity_boundary": "passivity_margin",
    "max_passive_stiffness": "passivity_margin",
}
"""Forms that are made, beside, of what the statement on another form is about."""


def claimed(form):
    rest = RESTS.get(form)
    return equations(form) + (equations(rest) if rest else [])


def test_every_form_has_a_statement():
    assert {computed.statement(form) for form in stable.FORMS} == set(settled())


@pytest.mark.parametrize("form", stable.FORMS)
def test_it_is_proved_by_a_theorem(form):
    verdict = settled()[computed.statement(form)].verdict
    assert (verdict.kind, bool(verdict.rests)) == ("proved", True)


LONG = {"max_stable_stiffness": pytest.mark.slow, "stability_boundary": pytest.mark.ci}
each = pytest.mark.parametrize(
    "form", [pytest.param(f, marks=LONG.get(f, ())) for f in stable.FORMS]
)


@each
def test_every_pair_of_a_form_is_in_its_statement(form):
    for pair in stable.form(form, FULL, DELAY if form in stable.FOR_ONE_DELAY else None).equal:
        assert covered(pair, claimed(form)), pair


@each
def test_what_a_form_rests_on_is_said_of_its_own_pairs_only(form):
    """What is left to another statement is not all that there is."""
    pairs = stable.form(form, FULL, DELAY if form in stable.FOR_ONE_DELAY else None).equal
    assert any(covered(pair, equations(form)) for pair in pairs)


@pytest.mark.ci
@pytest.mark.parametrize("form", ["discretize_fractional", "max_stable_stiffness"])
def test_a_pair_that_is_nowhere_claimed_is_missed(form):
    ours, derived = stable.form(form).equal[-1]
    assert covered((ours, derived), claimed(form))
    assert not covered((ours, 2 * derived), claimed(form))
    assert not covered((2 * ours, derived), claimed(form))
    assert not covered((2 * ours, 2 * derived), claimed(form))
    assert not covered((alpha, alpha), claimed(form))


def test_what_is_said_twice_covers_nothing():
    ours, derived = stable.form("passivity_margin_at").equal[0]
    assert not covered((ours, derived), [(False, derived, derived)])


BLOCKS = {
    name: value.block
    for module in (stable_device, stable_boundary, stable_slope, stable_need, stable_walls)
    for name, value in vars(module).items()
    if isinstance(value, Later)
}


@pytest.mark.parametrize("name", BLOCKS)
def test_the_hypotheses_of_each_part_hold_somewhere(name):
    block = BLOCKS[name]
    assert block.example().exists(block.over, block.given)


@pytest.mark.parametrize("name", BLOCKS)
def test_a_part_with_a_wrong_equation_is_no_theorem(name):
    block = BLOCKS[name]
    for pair in block.pairs:
        if isinstance(pair, Relation):
            with pytest.raises(NotShown):
                block._pair(Relation(pair.left, "=", pair.right + 1))
            if pair.right != 0:  # what is 0 is minus itself
                with pytest.raises(NotShown):
                    block._pair(Relation(-pair.left, "=", pair.right))
