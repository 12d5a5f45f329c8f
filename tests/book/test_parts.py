"""Parts, results, and what rests on what: each chapter, theorem and rule has its place."""

import re

import pytest
from chapters import chapter

from symhaptic.book.chapters import shipped
from symhaptic.book.parts import OWN, PARTS, in_parts, part_of
from symhaptic.book.report.printed import BAD, chapter_tex, text_files
from symhaptic.book.rests import rests, said, shown_in
from symhaptic.book.rules import called, classical, others, says
from symhaptic.proof.theorems.axioms import AXIOMS


def test_every_chapter_finds_its_part_by_its_name():
    assert all(part_of(path.stem) is not OWN for path in shipped())
    assert part_of("s4d_something_new") is PARTS[2]
    assert part_of("s6z_something_new") is PARTS[5]
    assert part_of("my_drift") is OWN


def test_chapters_of_a_part_stand_together_in_the_order_of_their_names():
    names = in_parts([path.stem for path in shipped()], str)
    found = [part_of(name).title for name in names]
    assert found == sorted(found, key=[part.title for part in PARTS].index)
    assert [n for n in names if part_of(n) is PARTS[1]] == sorted(
        n for n in names if part_of(n) is PARTS[1]
    )


def test_each_classical_rule_has_a_name_a_statement_and_a_source():
    assert classical()
    for rule, source in classical().items():
        assert source
        assert called(rule)
        assert rule in AXIOMS or says(rule)
    listed = {rule for rules in others().values() for rule in rules}
    assert not set(classical()) & listed
    assert not [name for name in listed if name.startswith("_")]  # helpers are no rules


def test_a_theorem_rests_on_those_of_its_page_and_not_on_what_is_behind_them():
    shown = shown_in([(26, chapter("s3c_stiffness_maximum"))])
    (tip,) = [
        one
        for one in shown.values()
        if one.title == "The wall of (11) is passive and has the maximum stiffness"
    ]
    found = rests([tip.theorem], shown)
    assert [one.title for one in found.shown] == ["No passive wall is stiffer than (11)"]
    assert said(tip.theorem) in shown


def test_what_a_theorem_rests_on_is_all_that_its_premises_apply():
    """Of theorems with common premises, of which the walk meets some twice."""
    page = chapter("s5a_passive_is_stable").page
    theorems = [block.theorem for block in page.blocks if block.theorem is not None]
    names, seen, stack = set(), {}, [*theorems]
    while stack:
        one = stack.pop()
        names.add(one.given[0] if one.rule == "known" else one.rule)
        stack += [] if id(one) in seen else one.premises
        seen[id(one)] = one
    assert rests(theorems, {}).rules == tuple(name for name in classical() if name in names)
    assert rests([*theorems, *theorems], {}) == rests(theorems, {})


def test_rules_are_named_beside_what_rests_on_them():
    text = chapter_tex(chapter("s5a_passive_is_stable"), 69)
    assert r"\byrule{roots-stay}{continuity of roots}" in text
    assert r"\formal" not in text  # each of its theorems stands in formulas


def groups(tex):
    """What stands between outer braces."""
    found, depth, begin = [], 0, 0
    for at, sign in enumerate(tex):
        depth += (sign == "{") - (sign == "}")
        if sign == "{" and depth == 1:
            begin = at + 1
        elif sign == "}" and depth == 0:
            found.append(tex[begin:at])
    return found


def test_what_shows_a_statement_stands_beside_it_where_it_is_short():
    text = chapter_tex(chapter("s3c_stiffness_maximum"), 26)
    forms = [groups(line) for line in text.splitlines() if line.startswith(r"\form{")]
    beside = {place: verdict for place, _, verdict, *_ in forms}
    (silver,) = (said for said in beside.values() if "rounded down" in said)
    assert r"\kind{enclosed}{enclosed}: $0.414213562373" in silver  # the square root of 2, less 1
    assert not any("rounded" in body for _, body, *_ in forms)


def test_no_row_of_the_printed_forms_stands_alone():
    text = chapter_tex(chapter("s3c_stiffness_maximum"), 26)
    _, *rows = text.partition(r"\formsend")[0].split("\n\\form{")
    assert len(rows) > 2
    assert len({row.removesuffix(r"\together") for row in rows}) == len(rows)
    assert rows[0].endswith(r"\together")
    assert rows[-2].endswith(r"\together")


def test_in_long_grounds_elementary_facts_are_counted():
    """In a margin of 32 mm a list of twenty of them left half a page empty."""
    text = chapter_tex(chapter("s5a_passive_is_robust"), 71)
    lists = re.findall(r"\b[Bb]y ((?:\\(?:byrule|theoremlink)[^\n]*?)\d+ axioms)", text)
    assert lists
    rules = {rule for one in lists for rule in re.findall(r"\\byrule\{([\w-]+)\}", one)}
    assert not rules & set(AXIOMS)
    assert len(rules) > 2


@pytest.mark.parametrize(
    "line",
    [
        "pdfTeX warning (dest): name{rule:gone} has been referenced but does not exist",
        r"Overfull \hbox (3.5pt too wide) in paragraph at lines 1--2",
    ],
)
def test_a_link_that_leads_nowhere_is_an_error_like_a_line_too_long(line):
    assert re.findall(BAD, f"a\n{line}\nb", re.MULTILINE) == [line]


def test_the_book_has_each_chapter_once_in_its_part():
    names = ["s2a_device", "s3b_rise", "s4a_discretisation"]
    book = text_files([chapter(name) for name in names])["book.tex"]
    for name in names:
        assert book.count(f"\\input{{{name}") == 1
        before = book[: book.index(f"\\input{{{name}")]
        assert before.rindex(part_of(name).title) == max(before.rfind(part.title) for part in PARTS)
