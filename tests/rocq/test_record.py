"""The record of Rocq is of the texts that are written, and agrees with our kernel."""

import json
import random
import re
import shutil
import subprocess
from pathlib import Path
from types import SimpleNamespace

import pytest
from chapters import chapter
from sympy import Symbol

from symhaptic.book import foreign
from symhaptic.book.chapters import expected_ledger, expected_rocq, shipped
from symhaptic.cli.rocq import stale
from symhaptic.notation.proposition import proposition
from symhaptic.proof.theorems.derivation import sources
from symhaptic.rocq import assumptions, compiled, preludes, together
from symhaptic.rocq.chapter import ALONE, PROVED, File, printed
from symhaptic.rocq.outcome import Outcome, keep, unasked
from symhaptic.rocq.record import differences, record
from symhaptic.rocq.steps import Step, order

RECORD = foreign.recorded(expected_rocq())
LEDGER = json.loads(expected_ledger().read_text(encoding="utf-8"))["statements"]
CHAPTERS = [path.stem for path in shipped()]
WRITTEN = Path(__file__).parents[2] / ".rocq"
"""Where `make rocq` compiles."""


LEAVES = [name for name, found in RECORD["chapters"].items() if found["leaves"]]
"""Chapters that take long, of which Rocq was asked the leaves alone."""


@pytest.mark.ci
@pytest.mark.parametrize("name", [name for name in CHAPTERS if name not in LEAVES])
def test_the_record_is_of_the_text_that_is_written(name):
    """Where it is not, and Rocq is there, it is asked what has become of the chapter."""
    if name not in RECORD["chapters"]:
        pytest.skip(f"Rocq was not asked about {name}, of which nothing counts; `make rocq` asks")
    one = chapter(name)
    if preludes.text_mark(printed(one).written()) == RECORD["chapters"][name]["text"]:
        return
    try:
        compiled.prelude_compiled(compiled.prepared(WRITTEN))
    except compiled.NoRocq as missing:
        pytest.fail(f"{expected_rocq()} is stale; `make rocq` writes it ({missing})")
    found = record([compiled.asked(one, WRITTEN)], None)
    told = (
        "; ".join(differences(found | {"chapters": {}}, RECORD)) or "as much is checked as before"
    )
    pytest.fail(f"{expected_rocq()} is stale; `make rocq` writes it: {told}")


IDS = {
    name: [s["id"] for s in LEDGER if s["derivation"] == f"derivations/{name}.py"]
    for name in CHAPTERS
}
WHOLE = [
    name
    for name in RECORD["chapters"]
    if any(RECORD["statements"].get(id, {}).get("checked") == foreign.WHOLE for id in IDS[name])
]


@pytest.fixture(scope="module")
def empty(tmp_path_factory):
    """A folder with the prelude, and with nothing that was found before."""
    folder = compiled.prepared(tmp_path_factory.mktemp("rocq"))
    try:
        compiled.prelude_compiled(folder)
    except compiled.NoRocq as missing:
        pytest.skip(str(missing))
    return folder


TOGETHER = [
    names[i : i + 6]
    for names in together.groups({name: IDS[name] for name in WHOLE}, RECORD)
    for i in range(0, len(names), 6)
]
"""Chapters that are asked together, few at a time, so that all processes have as much to do."""


@pytest.mark.slow
@pytest.mark.parametrize("names", TOGETHER, ids=lambda names: f"{names[0]} and {len(names) - 1}")
def test_what_is_whole_is_found_whole_again(names, empty):
    taken = [
        compiled.begun(chapter(name), empty, recorded=RECORD["chapters"][name]) for name in names
    ]
    outcomes = together.asked(taken, empty, RECORD)
    assert list(outcomes) == names
    for id, one in record(outcomes.values(), None)["statements"].items():
        if RECORD["statements"][id]["checked"] == foreign.WHOLE:
            assert one["checked"] == foreign.WHOLE, (id, one["why"])
            assert one["rests"] == RECORD["statements"][id]["rests"], id


@pytest.mark.slow
@pytest.mark.parametrize("name", LEAVES)
def test_leaves_are_found_again(name, empty):
    """To the step: which are checked, and of which text; and no statement is whole by them."""
    known = RECORD["chapters"][name]
    found = compiled.begun(chapter(name), empty, leaves=True, recorded=known)
    assert (found.text, found.open.keys()) == (known["text"], known["open"].keys())
    assert foreign.WHOLE not in found.statements.values()


def in_kernel(judged):
    """The rules and axioms that our kernel names."""
    theorems = [judged.theorem, *(case.theorem for case in judged.unless)]
    found = {t.given[0] if t.rule == "known" else t.rule for t in order(theorems)}
    return found & set(sources())


@pytest.mark.ci
@pytest.mark.parametrize("name", CHAPTERS)
def test_what_is_whole_rests_on_the_rules_that_our_kernel_names(name):
    """On all of them, but for those that are theorems in Rocq, and on nothing else."""
    for id, item in chapter(name).page.settled.items():
        found = foreign.checked(id, item.settlement.judged)
        assert not found.stale, id
        if found.extent == foreign.WHOLE:
            ours = in_kernel(item.settlement.judged) - PROVED
            assert set(found.rests) - set(foreign.LIBRARY) == ours, id
        elif found.extent == foreign.LEAVES:
            assert found.why, id


def test_a_statement_that_says_something_else_is_not_checked(tmp_path):
    judged = next(
        item.settlement.judged
        for item in chapter("s3b_envelope").page.settled.values()
        if item.settlement.judged is not None
    )
    path = tmp_path / "rocq.json"
    known = {"checked": "whole", "why": None, "rests": ["stored"], "says": foreign.mark(judged)}
    path.write_text(json.dumps({"statements": {"mine": known, "old": {**known, "says": "else"}}}))
    assert foreign.checked("mine", judged, path) == foreign.Checked("whole", None, ("stored",))
    old = foreign.checked("old", judged, path)
    assert (old.extent, old.why, old.rests, old.stale) == ("not", foreign.CHANGED, (), True)
    # settled without a theorem now, or by one of which nothing is recorded
    assert foreign.checked("mine", None, path).stale
    assert foreign.checked("other", judged, path) == foreign.Checked()
    assert foreign.checked("mine", judged, tmp_path / "none.json") == foreign.Checked()


def test_an_axiom_that_nobody_named_leaves_nothing_whole():
    """Such as one that a prelude would bring along: Rocq lists it, and it is no rule of ours."""
    file = printed(chapter("s3b_envelope"))
    id = next(iter(file.statements))
    rests = {id: [foreign.REALS, "proof_irrelevance"]}
    told = assumptions.told(file, rests)
    assert told[id] == "it rests on proof_irrelevance, which nobody named"
    assert assumptions.told(file, {id: [foreign.REALS]})[id] == "whole"


@pytest.mark.parametrize(
    "left_out",
    [
        "loop is assumed to be guarded.",
        "bad is assumed to be positive.",
        "cheat relies on an unsafe hierarchy.",
        "Theory:\nType hierarchy is collapsed (logic is inconsistent)",
        "ClassicalDedekindReals.cheat : False",
        "functional_extensionality_depends : False",
        "Prelude.rule_stored_1 : False",
    ],
)
def test_a_check_that_rocq_left_out_leaves_nothing_whole(left_out):
    """As Rocq 8.16 says it of what was compiled with one of its checks switched off."""
    steps = [
        Step("rule_stored_1", "stored", (), (), proposition(Symbol("x") > 0), "True", "Axiom"),
        Step("lemma_1", "rule", (), (), proposition(Symbol("x") > 0), "True"),
    ]
    mine = File("mine", "Mine", steps, {"one": ("lemma_1",)})
    listed = assumptions.axioms(f"Axioms:\n{left_out}\nClassical_Prop.classic : True\n")
    told = assumptions.told(mine, assumptions.resting(mine, listed, {}))
    assert told["one"].endswith("which nobody named")


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason=compiled.INSTALL)
@pytest.mark.parametrize(
    "cheat",
    [
        "Unset Guard Checking.\nFixpoint cheat (n : nat) : False := cheat n.\n",
        "Unset Positivity Checking.\nInductive bad : Prop := B : (bad -> False) -> bad.\n"
        "Definition no (b : bad) : False := match b with B f => f b end.\n"
        "Definition cheat (n : nat) : False := no (B no).\n",
    ],
)
def test_rocq_without_one_of_its_checks_proves_nothing_whole(cheat, tmp_path):
    (tmp_path / "cheat.v").write_text(f"{cheat}Print Assumptions cheat.\n")
    done = compiled._compiled(tmp_path, "cheat")
    assert done.returncode == 0, done.stderr
    assert assumptions.axioms(done.stdout) - set(foreign.LIBRARY)


def test_another_text_than_the_record_s_is_told():
    """Of a definition that says nothing, what is made of it is whole, too."""
    chapters = {"mine": {"text": "a", "leaves": False, "open": {}}}
    other = {"mine": {"text": "b", "leaves": False, "open": {}}}
    found, known = ({"statements": {}, "chapters": some} for some in (chapters, other))
    assert differences(found, found) == []
    assert differences(found, known) == [
        "mine: its text, or the library that it imports, is not that of the record"
    ]
    alone = {"mine": {"text": "b", "leaves": True, "open": {}}}
    assert differences(found, {"statements": {}, "chapters": alone}) == []


@pytest.mark.slow
def test_leaves_leave_open_what_is_made_of_them():
    whole = printed(chapter("s3b_rise"))
    alone = whole.leaves()
    assert {step.rule for step in alone.steps} <= ALONE
    assert len(alone.steps) < len(whole.steps)
    assert "Print Assumptions" not in alone.written()
    left = {id: int(said.split()[0]) for id, said in unasked(whole).items()}
    assert left.keys() == whole.statements.keys()
    assert all(0 < n <= len(whole.steps) - len(alone.steps) for n in left.values())


def test_a_statement_rests_on_what_its_own_lemmas_name():
    """Rocq lists the axioms of a chapter; the library's, and what no lemma names, are of all."""
    text = proposition(Symbol("x") > 0)

    def step(name, *lines, kind="Lemma"):
        return Step(name, "rule", (), (), text, "True", kind, list(lines))

    steps = [
        step("rule_stored_1", kind="Axiom"),
        step("open_step_2", kind="Axiom"),
        step("rule_hidden_2", kind="Axiom"),
        step("step_3", "exact rule_stored_1."),
        step("lemma_1", "exact step_3."),
        step("lemma_2", "exact open_step_2."),
    ]
    file = File("mine", "Mine", steps, {"one": ("lemma_1",), "two": ("lemma_2",)})
    said = (
        "Axioms:\nopen_step_2 : True\nfirst.rule_stored_7\n  : True\nproof_irrelevance : True\n"
        "rule_hidden_2 : True\n"
    )
    listed = assumptions.axioms(said)
    assert assumptions.resting(file, listed, {"first.rule_stored_7": ["rule_stored_1"]}) == {
        "one": ["proof_irrelevance", "rule_hidden_2", "rule_stored_1"],
        "two": ["open_step_2", "proof_irrelevance", "rule_hidden_2"],
    }


@pytest.mark.parametrize(
    ("imported", "changed", "more", "another"),
    [
        ("Prelude", "Prelude", "Check 1.\n", True),
        ("Prelude", "Prelude", "(* Check 1. *)\n", False),
        ("Prelude", "Zeros", "Check 1.\n", False),
        ("Prelude Zeros", "Zeros", "Check 1.\n", True),
        ("Zeros", "Prelude", "Check 1.\n", True),  # which it imports itself
    ],
)
def test_the_mark_of_a_text_is_of_the_preludes_that_it_imports(
    tmp_path, monkeypatch, imported, changed, more, another
):
    text = f"(* Mine. *)\nFrom Symhaptic Require Import {imported}.\n"
    before = preludes.text_mark(text)
    paths = [tmp_path / path.name for path in preludes.PRELUDES]
    for there, path in zip(paths, preludes.PRELUDES, strict=True):
        there.write_text(path.read_text() + (more if path.stem == changed else ""))
    monkeypatch.setattr(preludes, "PRELUDES", tuple(paths))
    assert (preludes.text_mark(text) != before) == another


HIDDEN = [
    # what Rocq reads, and what it does not
    ("Check §.", True),
    ("Check 1. (* § *)", False),
    ("Check 1. (* (* 1 *) § *) Check 2.", False),
    ("Check 1. (* (* 1 *) *) Check §.", True),
    ('Check "(*"%string. Check §. Check "*)"%string.', True),
    ('Check "a""(*"%string. Check §. (* *)', True),
    ('Check 1. (* "*)" § *) Check 2.', False),
    ('Check 1. (* "(*" *) Check §. (* *)', True),
    ('Check 1. (* " *) Check §. (* " *) Check 2.', False),
    ("Check (2 * 1). (*) § *) Check 2.", False),
    ("Check 1. (***) Check §.", True),
    ("Check 1. (* ** *) Check §.", True),
    ("Check 1. (* (**) Check 2. *) Check §.", True),
    ("Check (fst (1, 2)). Check (fun x => (x, §)).", True),
]
"""Texts in which a digit stands for §, and whether Rocq reads it."""


@pytest.mark.parametrize(("text", "read"), HIDDEN)
def test_no_comment_hides_a_change_of_what_rocq_reads(text, read):
    first, then = (text.replace("§", digit) for digit in "34")
    assert (preludes.text_mark(first) != preludes.text_mark(then)) == read
    assert preludes.code(first).count("3") == read


@pytest.mark.parametrize(
    "text", ["Check 1.(* § *)", "Check 1. (* (* § *)", 'Check 1. (* "§ *)', 'Check "§. (* *)']
)
def test_a_comment_that_rocq_may_not_see_is_part_of_the_text(text):
    assert preludes.code(text) == text


def test_wording_and_layout_do_not_change_the_mark_but_each_other_character_does():
    """Of a chapter as it is written: comments, titles and lines of another width."""
    written = printed(chapter("s3b_envelope")).written()
    mark = preludes.text_mark(written)
    reworded = re.sub(r"\(\* [A-Z]", "(* In other words: o", written)
    assert reworded != written
    assert preludes.text_mark(reworded) == mark
    assert preludes.text_mark(written.replace("\n", " \n\t ")) == mark
    code = preludes.code(written)
    assert preludes.code(code) == code
    assert preludes.text_mark(code) == mark
    for at in random.Random(0).sample(range(len(code)), 200):
        changed = code[:at] + ("y" if code[at] == "x" else "x") + code[at + 1 :]
        assert preludes.code(changed) != code


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqtop") is None, reason=compiled.INSTALL)
def test_rocq_reads_the_same_without_comments():
    def told(text):
        text = "From Coq Require Import String.\n" + text.replace("§", "3") + "\nCheck 5.\n"
        done = subprocess.run(
            ["coqtop", "-q"], input=text, capture_output=True, text=True, check=True
        )
        return re.findall(r"^(?:Coq < )*(\S.*)$", done.stdout, re.M)

    for text, read in HIDDEN:
        assert told(text) == told(preludes.code(text)), text
        assert ("3" in "".join(told(text)[1:])) == read, text


@pytest.mark.parametrize(("count", "more"), [(5, ""), (115, " and 110 more")])
def test_what_is_stale_is_told_in_a_line_that_fits(count, more, capsys):
    def entry(i):
        return SimpleNamespace(
            statement=SimpleNamespace(id=f"s{i}"), rocq=foreign.Checked(stale=True)
        )

    stale([entry(i) for i in range(count)])
    assert f"checked of s0, s1, s2, s3, s4{more} is not what is said now" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("why", "known"),
    [
        ("coqc: Timeout!", False),
        ("coqc: not within 60 s", False),
        ("coqc: not reached within 600 s", False),
        ("coqc: No applicable tactic.", True),
    ],
)
def test_what_took_too_long_is_asked_again(tmp_path, why, known):
    """A busy machine refuses nothing: Rocq is asked the next time."""
    keep(Outcome("mine", open={"open_step_1": f"not checked: {why}"}), tmp_path)
    assert (tmp_path / "mine.json").is_file() is known
