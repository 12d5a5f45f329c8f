"""A theorem that a chapter forged is found where it arrives: derived again, and judged again."""

from __future__ import annotations

import itertools
import json
import pickle
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from sympy import S, Symbol, floor, sin
from typer.testing import CliRunner, Result

from symhaptic.book import chapters, sources
from symhaptic.book.arrivals import arrived, places, sent
from symhaptic.book.chapters import BadChapter
from symhaptic.book.committed import surprises
from symhaptic.book.judging import judged_again, to_be_compared
from symhaptic.book.ledger import Entry, looked_at
from symhaptic.book.sources import STATEMENTS
from symhaptic.check.plugin import Agreement
from symhaptic.cli.main import app
from symhaptic.notation.proposition import Exists, Relation, proposition
from symhaptic.paper import Statement
from symhaptic.proof.seal import KEY
from symhaptic.proof.settle import Settlement
from symhaptic.proof.sign import Fact
from symhaptic.proof.theorems.judge import Case, Judged
from symhaptic.proof.theorems.leaves import number
from symhaptic.proof.verdict import Kind, Unfounded, Verdict
from symhaptic.rocq.steps import Step

pytestmark = pytest.mark.early
"""Chapters are forked from this process as long as it has run none, and else import all anew."""

HEAD = '"""A title\n\nAn introduction.\n"""\n'


@pytest.fixture(autouse=True)
def _sources_as_they_were() -> Iterator[None]:
    """What a command in this process was told of a source is not known to the next test."""
    known = [*sources.SOURCES], {**sources.STATEMENTS}, {**sources.CLAIMED}, {**chapters._sources}
    yield
    sources.SOURCES[:] = known[0]
    kept = (sources.STATEMENTS, sources.CLAIMED, chapters._sources)
    for now, before in zip(kept, known[1:], strict=True):
        now.clear()
        now.update(before)


def chapter(folder: Path, name: str, body: str) -> Path:
    path = folder / f"{name}.py"
    path.write_text(HEAD + body, encoding="utf-8")
    return path


FORGED = """
from sympy import symbols
import symhaptic.proof.theorems.kernel as kernel
from symhaptic.notation.proposition import ForAll, proposition
def derive(page):
    x, y = symbols("x y")
    claim = ForAll((x, y), proposition(x > y))
    page.state("forged", "of two numbers each is the larger one", claim=claim)
    forged = object.__new__(kernel.Theorem)
    object.__setattr__(forged, "hypotheses", frozenset())
    object.__setattr__(forged, "conclusion", claim)
    object.__setattr__(forged, "_rule", "assume")
    object.__setattr__(forged, "_given", ((claim,), ()))
    page.settle("forged", forged)
"""


def test_a_forged_theorem_is_found_where_it_arrives(tmp_path: Path) -> None:
    path = chapter(tmp_path, "forged", FORGED)
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    assert "DIFFERS  forged: open:" in out.read_text()


PATCHED = {
    # the theorem runs a program where it arrives
    "program": """
    code = "(lambda here: (exec('forged = True', here), here)[1])({})"
    kernel.Theorem.__reduce__ = lambda self: (eval, (code,))
    page.settle("forged", kernel.conjoined())
""",
    # so does text, which SymPy reads as a program
    "text": """
    kernel.Theorem.__reduce__ = lambda self: (sin, ("[print('READ'), 1][1]",))
    page.settle("forged", kernel.conjoined())
""",
    # a verdict of its own, without a theorem
    "verdict": """
    Settlement.decide = lambda self, printed: Verdict(Kind.PROVED, "so it is")
    page.settle("forged", Eq(x, 1))
""",
    # a rule, a home of rules and an axiom that only the chapter has
    "home": """
    kernel._HOMES = (*kernel._HOMES, __name__)
    def mine():
        return (), CLAIM
    page.settle("forged", kernel.rule(mine)())
""",
    "axiom": """
    axioms._AXIOMS["mine"] = axioms.Axiom(CLAIM, "me")
    page.settle("forged", axioms.known("mine"))
""",
    # one proposition is said to be another one
    "equal": """
    claim, true = Relation(x, "<", y), Relation(S.Zero, "<", S.One)
    claim.__dict__["_hash"] = hash(true)
    Proposition.__eq__ = lambda one, other: True
    page.settle("forged", kernel.general(kernel.part(leaves.number(true), claim), x, y))
""",
    "state": """
    claim, true = Relation(x, "<", y), Relation(S.Zero, "<", S.One)
    claim.__dict__["_hash"] = hash(true)
    Proposition.__eq__ = lambda one, other: True
    Proposition.__reduce__ = lambda self: (object.__new__, (type(self),), self.__dict__)
    page.settle("forged", kernel.general(kernel.part(leaves.number(true), claim), x, y))
""",
    "built": """
    import copyreg
    claim, true = Relation(x, "<", y), Relation(S.Zero, "<", S.One)
    claim.__dict__["_hash"] = hash(true)
    Proposition.__eq__ = lambda one, other: True
    Proposition.__reduce__ = lambda self: (copyreg.__newobj__, (type(self),), self.__dict__)
    page.settle("forged", kernel.general(kernel.part(leaves.number(true), claim), x, y))
""",
}
IMPORTS = """
from sympy import Eq, S, sin, symbols
import symhaptic.proof.theorems.kernel as kernel
from symhaptic.notation.proposition import ForAll, Proposition, Relation
from symhaptic.proof.settle import Settlement
from symhaptic.proof.theorems import axioms, leaves
from symhaptic.proof.verdict import Kind, Verdict
x, y = symbols("x y")
CLAIM = ForAll((x, y), Relation(x, "<", y))
def derive(page):
    page.state("forged", "of two numbers each is the larger one", claim=CLAIM)
"""


@pytest.mark.parametrize("how", PATCHED)
def test_what_a_chapter_patches_stays_with_it(
    how: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    path = chapter(tmp_path, "forged", IMPORTS + PATCHED[how])
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code in (1, 2)
    assert not isinstance(told.exception, (ValueError, TypeError, LookupError))
    assert told.exit_code == 2 or "DIFFERS  forged: " in out.read_text()
    assert "READ" not in capfd.readouterr().out


def test_a_print_stands_in_what_is_claimed_where_it_arrives(tmp_path: Path) -> None:
    body = """
import symhaptic.book.page as pages
from sympy import symbols
from symhaptic.notation.proposition import ForAll, Relation
from symhaptic.proof.theorems.kernel import general
from symhaptic.proof.theorems.leaves import identity
x = symbols("x")
def derive(page):
    pages.of_print = lambda claim, printed: claim
    page.state("forged", "two", "x = 2", claim=ForAll((x,), Relation(x, "=", x)))
    page.settle("forged", general(identity(x, x), x))
"""
    path, out = chapter(tmp_path, "forged", body), tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    assert "is not in the claim" in out.read_text()


AS_A_CONDITION = {
    # every K below 0 is below 1, which does not make every K one
    "a hypothesis": "discharged(combined(K < 1, [assume(K < 0)], [1]), K < 0)",
    "a part of one": "discharged(combined(K < 1, [assume(K < 0)], [1]), K < 0, K < 2)",
    "a case": "widened(number(TRUE), Or((TRUE, proposition(K < 0))))",
    "of the same": "discharged(assume(K < 0), K < 0)",
    "of itself": "equivalent(discharged(assume(K < 0), K < 0), discharged(assume(K < 0), K < 0))",
}


@pytest.mark.parametrize("how", AS_A_CONDITION)
def test_a_print_is_what_the_claim_concludes(how: str, tmp_path: Path) -> None:
    body = f"""
from sympy import S
from symhaptic.notation import K
from symhaptic.notation.proposition import Or, Relation, proposition
from symhaptic.proof.theorems.judge import Case
from symhaptic.proof.theorems.kernel import *
from symhaptic.proof.theorems.leaves import combined, number
TRUE = Relation(S.Zero, "<", S.One)
def derive(page):
    shown = general({AS_A_CONDITION[how]}, K)
    there = conjoined(*(number(Relation(S(-1), "<", S(n))) for n in (0, 2)))
    page.state("forged", "any stiffness", "K < 0", claim=shown.conclusion)
    page.settle("forged", shown, example=Case({{K: S(-1)}}, there))
"""
    path, out = chapter(tmp_path, "forged", body), tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 2
    assert "not what it concludes" in told.stderr


MISTYPED = """
from sympy import Eq, S, cos, sin, symbols
x, y = symbols("x y")
def derive(page):
    page.step("Two", cos(y)**2 + sin(y)**2 + 1, S(2), name=x)
    page.state("mine", "two", "x = 2")
    page.settle("mine", Eq(x, 1))
"""


def test_what_is_argued_to_be_false_does_not_hold(tmp_path: Path) -> None:
    """Right as printed; the other form is only typed."""
    path, out = chapter(tmp_path, "mine", MISTYPED), tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "mine", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    assert "DIFFERS  mine: argued (misprint)" in out.read_text()


ELSEWHERE = """
import pickle, sys
from sympy import symbols
from symhaptic.notation import x
from symhaptic.notation.proposition import Exists, proposition
from symhaptic.proof.theorems.kernel import assume
y = symbols("y")
claim = Exists((y,), proposition(x < y))
hash(claim)
pickle.dump(assume(claim), sys.stdout.buffer)
"""


def test_a_theorem_of_another_process_says_the_same_here() -> None:
    """Where processes are not forked, symbols that stand for a place differ between them."""
    x, y = Symbol("x"), Symbol("y")
    claim = Exists((y,), proposition(x < y))
    sent = subprocess.run([sys.executable, "-c", ELSEWHERE], capture_output=True, check=True)
    found = pickle.loads(sent.stdout)
    assert found.conclusion == claim
    assert found.hypotheses == {claim}


COMPARED = {
    "decide.compare": """
    decide.compare = settle.compare = record.compare = lambda *forms: decide.Comparison(True, "so")
    pages.shows = lambda derived, definitions, facts: True
    page.settle("forged", Eq(x, 1))
""",
    "Settlement.decide": """
    Settlement.decide = lambda self, printed: Verdict(Kind.PROVED, "so it is")
    page.settle("forged", Eq(x, 1))
""",
    "nothing sent": """
    Settlement.decide = lambda self, printed: Verdict(Kind.PROVED, "so it is")
    ledger.to_be_compared = lambda entry, grounds: entry
    page.settle("forged", Eq(x, 1))
""",
    "a number put in": """
    pages.not_defined = lambda given, definitions: None
    pages.shows = lambda derived, definitions, facts: True
    page.settle("forged", Eq(x, 1), given={x: S.One, S(2): S.One})
""",
    "a theorem for a comparison": """
    Settlement.decide = lambda self, printed: Verdict(Kind.PROVED, "so it is")
    ledger.to_be_compared = lambda entry, grounds: replace(entry, compared=entry.statement)
    page.settle("forged", Eq(x, 1))
""",
}
COMPARING = """
from dataclasses import replace
from sympy import Eq, S, symbols
import symhaptic.book.ledger as ledger
import symhaptic.book.page as pages
import symhaptic.book.record as record
import symhaptic.proof.decide as decide
import symhaptic.proof.settle as settle
from symhaptic.proof.settle import Settlement
from symhaptic.proof.sign import Recipe
from symhaptic.proof.verdict import Kind, Verdict
x = symbols("x")
def derive(page):
    page.state("forged", "two", "x = 2")
"""


@pytest.mark.parametrize("how", COMPARED)
def test_a_print_is_compared_again_where_it_arrives(how: str, tmp_path: Path) -> None:
    """What a chapter derived is 1; the print says 2."""
    path = chapter(tmp_path, "forged", COMPARING + COMPARED[how])
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    assert told.exception is None or isinstance(told.exception, SystemExit)
    assert "DIFFERS  forged: " in out.read_text()


TYPED = {
    "not seen": """
    pages.shows = lambda derived, definitions, facts: True
    page.settle("forged", Eq(x, 2))
""",
    "said to be shown": """
    pages.shows = lambda derived, definitions, facts: True
    page.settle("forged", Eq(x, 2))
""",
    "shown by what it settled": """
    pages.shows = lambda derived, definitions, facts: True
    page.settle("forged", Eq(x, 2))
    kept = page.settled["forged"]
    kept.settlement = replace(kept.settlement, definitions=((x, S(3)),))
""",
    "shown by an assumption": """
    pages.shows = lambda derived, definitions, facts: True
    page.state("larger", "more than two", "x > 2")
    page.settle("larger", x > 2)
    kept = page.settled["larger"]
    kept.settlement = replace(kept.settlement, signs=(Recipe("assume", (x - 2, True)),))
""",
    "shown by a rule that is none": """
    pages.shows = lambda derived, definitions, facts: True
    page.state("larger", "more than two", "x > 2")
    page.settle("larger", x > 2)
    kept = page.settled["larger"]
    kept.settlement = replace(kept.settlement, signs=(Recipe("eval", ("1",)),))
""",
}


@pytest.mark.parametrize("how", TYPED)
def test_a_print_that_is_only_typed_again_is_found_where_it_arrives(
    how: str, tmp_path: Path
) -> None:
    """The chapter derived nothing; its page, patched, says that it shows the form."""
    path, out = chapter(tmp_path, "forged", COMPARING + TYPED[how]), tmp_path / "out.txt"
    id = "larger" if "larger" in TYPED[how] else "forged"
    told = CliRunner().invoke(app, ["verify", id, "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    assert told.exception is None or isinstance(told.exception, SystemExit)
    assert f"DIFFERS  {id}: compared again" in out.read_text()
    assert "1 proved" not in out.read_text()


SHOWN = """
from sympy import Eq, pi, symbols
from symhaptic.notation import theta
from symhaptic.proof.sign import assume, combined
def derive(page):
    fact = combined(theta * (pi - theta), [assume(theta), assume(pi - theta)])
    page.positive("It is", fact, r"0<\\theta<\\pi")
    page.state("mine", "of an angle inside", r"\\pi \\theta - \\theta^2 > 0")
    page.settle("mine", pi * theta - theta**2 > 0)
"""


def test_a_sign_that_the_page_shows_is_derived_again_where_it_arrives(tmp_path: Path) -> None:
    path, out = chapter(tmp_path, "mine", SHOWN), tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "mine", "--derivation", str(path), "-o", str(out)])
    assert (told.exit_code, "1 proved" in out.read_text()) == (0, True)


OF_ANOTHER_UNIT = """
from sympy import Eq, symbols
import symhaptic.book.steps as steps
from symhaptic.notation import K, T, m
x = symbols("x")
def derive(page):
    steps.of_another_unit = lambda name, meaning: None
    page.define("A stiffness", K, m / T)
    page.step("What it gives", 2 * T - T, T, name=x)
    page.state("forged", "a period", r"x = K T^2 / m")
    page.settle("forged", Eq(x, T), given={K: m / T})
"""


def test_the_units_of_what_is_put_in_are_compared_again_where_it_arrives(tmp_path: Path) -> None:
    """m/T is in Ns/m and a stiffness in N/m, so that K T^2 / m has no unit, and is no period."""
    path, out = chapter(tmp_path, "forged", OF_ANOTHER_UNIT), tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code == 1
    said = "K is in N/m, what it stands for in Ns/m"
    assert f"DIFFERS  forged: compared again: {said}" in out.read_text()


@pytest.mark.parametrize(
    ("derived", "kind"),
    [
        ("Eq(x, 2)", "proved"),
        ("Eq(x, symbols('p', positive=True)**0 + 1)", "proved"),
        ("Eq(x, Function('f')(y)**0 + 1)", "proved"),
        ("Eq(x, 1)", "argued"),
    ],
)
def test_what_is_compared_arrives(derived: str, kind: str, tmp_path: Path) -> None:
    body = f"""
from sympy import Eq, Function, S, cos, sin, symbols
x, y = symbols("x y")
def derive(page):
    page.step("Two", cos(y)**2 + sin(y)**2 + 1, S(2), name=x)
    page.state("mine", "two", "x = 2")
    page.settle("mine", {derived})
"""
    path, out = chapter(tmp_path, "mine", body), tmp_path / "out.json"
    way = ["verify", "mine", "--derivation", str(path), "--format", "json", "-o", str(out)]
    CliRunner().invoke(app, way)
    assert f'"verdict": "{kind}"' in out.read_text()


def test_what_cannot_be_sentto_be_compared_is_argued() -> None:
    x, proved = Symbol("x"), Verdict(Kind.PROVED, "identical")
    entry = Entry(Statement("mine", "here", "a whole number", ("x",)), proved, None, 0.0, own=True)
    found = to_be_compared(entry, Settlement((floor(x),)))
    assert found.compared is None
    assert (found.verdict.kind, found.verdict.argued_for) == (Kind.ARGUED, Kind.PROVED)
    assert judged_again(entry) == "mine: proved, of what was not compared again"


def test_what_is_found_out_about_an_entry_does_not_arrive() -> None:
    proved = Verdict(Kind.PROVED, "identical")
    entry = Entry(Statement("mine", "here", "a number", ("x = 2",)), proved, None, 0.0, own=True)
    entry.__dict__["wrong"] = None
    there = arrived(sent(entry), Path())
    assert "wrong" not in vars(there)
    assert there.wrong == "mine: proved, of what was not compared again"


class Sent:
    """Anything, as a pickle that calls a function, and then says what the result is like."""

    def __init__(self, made: object, *args: object, state: object = None) -> None:
        self.how = (made, args) if state is None else (made, args, state)

    def __reduce__(self) -> tuple[object, ...]:
        return self.how


def changed(of: object, state: object) -> bytes:
    """A pickle that names something and changes it."""
    named, given = pickle.dumps(of, 2)[:-1], pickle.dumps(state, 2)[2:-1]
    return named + given + pickle.BUILD + pickle.STOP


TRUE = Relation(S.Zero, "<", S.One)
NEVER: dict[str, bytes] = {
    # SymPy reads text as a program, in a list, too
    "text in a list": pickle.dumps(Sent(sin, ["[print('READ'), 1][1]"])),
    # the symbols of one name are one object, in all that is derived after it
    "a symbol's name": pickle.dumps(Sent(Symbol, "z", state={"name": "y"})),
    "an assumption": pickle.dumps(Sent(Symbol, "z", state={"_assumptions": {"positive": True}})),
    "a class": changed(Settlement, (None, {"decide": Verdict})),
    "a verdict's name": changed(Kind.UNDECIDED, {"_value_": "proved"}),
    "a theorem": pickle.dumps(
        Sent(*number(TRUE).__reduce__(), state=(None, {"conclusion": TRUE})),
    ),
    "no record": pickle.dumps(Sent(Agreement, "eq11")),
    "a fact": pickle.dumps(Sent(Fact, Symbol("z"), 1, KEY)),
    "another module": b"cantigravity\nfly\n.",
}


@pytest.mark.parametrize("what", NEVER)
def test_what_arrives_changes_nothing_that_was_here(
    what: str, capfd: pytest.CaptureFixture[str]
) -> None:
    decide, name = Settlement.decide, Symbol("z").name
    found = arrived(NEVER[what], Path("forged.py"))
    assert isinstance(found, BadChapter)
    assert (Settlement.decide, Symbol("z").name) == (decide, name)
    assert Symbol("z").is_positive is None
    assert Kind.UNDECIDED.value == "undecided"
    assert "READ" not in capfd.readouterr().out


def test_what_only_looks_like_a_theorem_is_none() -> None:
    """A record of the package that has hypotheses and a conclusion."""
    false = Relation(S.One, "<", S.Zero)
    looks = Step("forged", "number", (), (), false, "")
    with pytest.raises(Unfounded, match="what looks like a theorem is none"):
        Judged(looks).decide(false)  # type: ignore[arg-type]
    case = Case({}, looks)  # type: ignore[arg-type]
    with pytest.raises(Unfounded, match="what looks like a theorem is none"):
        Judged(number(TRUE), unless=(case,)).decide(false)


@pytest.mark.parametrize("place", ["0", "99999", "-1", "slice(None)", '"0"'])
def test_a_theorem_that_is_sent_by_its_place_is_what_stands_there(
    place: str, tmp_path: Path
) -> None:
    """The reader's own theorems are true; one of them in place of another settles nothing."""
    path = chapter(
        tmp_path,
        "forged",
        IMPORTS
        + f"""
    import symhaptic.book.arrivals as arrivals
    arrivals._Writer.reducer_override = lambda self, part: (
        (arrivals._known, ({place},)) if type(part) is kernel.Theorem else NotImplemented
    )
    forged = object.__new__(kernel.Theorem)
    for name, value in (("hypotheses", frozenset()), ("conclusion", CLAIM), ("_rule", "assume"),
                        ("_given", ((CLAIM,), ()))):
        object.__setattr__(forged, name, value)
    page.settle("forged", forged)
""",
    )
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code in (1, 2)
    assert not isinstance(told.exception, (ValueError, TypeError, LookupError))
    assert told.exit_code == 2 or "DIFFERS  forged: " in out.read_text()


def test_a_theorem_by_its_place_means_nothing_to_who_has_none() -> None:
    true = number(proposition(S.Zero < Symbol("x")).at({Symbol("x"): S.One}))
    (found,) = arrived(sent([true], places([true])), Path("a.py"), [true])
    assert found is true
    assert isinstance(arrived(sent([true], places([true])), Path("a.py")), BadChapter)


def test_a_chapter_does_not_reach_who_waits_for_its_reader(tmp_path: Path) -> None:
    """It writes a result of its own on all that is open in its process but what it is sent on."""
    body = """
import os, pickle, struct
from dataclasses import replace
import symhaptic.book.ledger as ledger, symhaptic.book.arrivals as arrivals
from symhaptic.paper import Statement
from symhaptic.proof.verdict import Kind, Verdict
def derive(page):
    entry = ledger.Entry(
        Statement("forged", "here", "false"), Verdict(Kind.PROVED, "so it is"), None, 0.0, own=True,
        look=ledger.Look(None, ledger.Checked()))
    data = arrivals.sent([entry])
    for place in range(3, 64):
        try:
            os.write(place, struct.pack("!i", len(data)) + data)
        except OSError:
            pass
    os._exit(0)
"""
    path = chapter(tmp_path, "forged", body)
    out = tmp_path / "out.txt"
    program = "import sys; from symhaptic.cli.main import main; main()"
    told = subprocess.run(
        [sys.executable, "-c", program, "verify", "forged", "--derivation", path, "-o", out],
        capture_output=True,
        timeout=300,
        check=False,
    )
    assert told.returncode in (1, 2), told
    assert told.returncode == 2 or "DIFFERS  forged: " in out.read_text()


def test_what_a_chapter_says_was_seen_of_it_is_not_believed(tmp_path: Path) -> None:
    body = """
from symhaptic.book import ledger, parallel
from symhaptic.paper import Statement
from symhaptic.proof.verdict import Kind, Verdict
import symhaptic.book.ledger
def derive(page):
    page.state("forged", "two", "x = 2")
    look = ledger.Look(None, ledger.Checked())
    entry = ledger.Entry(
        Statement("forged", "here", "false"), Verdict(Kind.PROVED, "so it is"), "forged.py", 0.0,
        own=True, look=look)
    ledger.of_chapter = lambda chapter: [entry]
"""
    path = chapter(tmp_path, "forged", body)
    out = tmp_path / "out.txt"
    told = CliRunner().invoke(app, ["verify", "forged", "--derivation", str(path), "-o", str(out)])
    assert told.exit_code in (1, 2)
    assert told.exit_code == 2 or "DIFFERS" in out.read_text()


def test_a_source_does_not_patch_the_judge(tmp_path: Path) -> None:
    """The chapter gives its own verdict, and the source has whoever reads it believe it."""
    source = """
import symhaptic.book.beforehand as beforehand
import symhaptic.book.judging as judging
import symhaptic.book.ledger as ledger
import symhaptic.book.parallel as parallel
import symhaptic.book.reader as reader
from symhaptic.paper.statement import Source, Statement
for module in (judging, ledger, parallel, reader, beforehand):
    if hasattr(module, "judged_again"):
        module.judged_again = lambda entry: None
SOURCE = Source("f", "Forged", "A. Author", "2026")
STATEMENTS = (Statement("f:two", "(1)", "two", (r"x = 2",)),)
"""
    (tmp_path / "source.py").write_text(source, encoding="utf-8")
    settled = COMPARING.replace('page.state("forged", "two", "x = 2")', "").rstrip()
    chapter(tmp_path, "forged", settled + COMPARED["nothing sent"].replace("forged", "f:two"))
    program = "from symhaptic.cli.main import main; main()"
    told = subprocess.run(
        [sys.executable, "-c", program, "verify", "--source", tmp_path],
        capture_output=True,
        text=True,
        check=False,
    )
    assert told.returncode == 1
    assert "DIFFERS  f:two" in told.stdout


@pytest.mark.parametrize("said", ['SOURCE = "x"', "STATEMENTS = 3", 'STATEMENTS = ("a",)'])
def test_a_source_that_says_something_else_is_one_line(said: str, tmp_path: Path) -> None:
    (tmp_path / "source.py").write_text(
        "from symhaptic.paper.statement import Source\n"
        f'SOURCE = Source("f", "A", "B", "2026")\nSTATEMENTS = ()\n{said}\n',
        encoding="utf-8",
    )
    chapter(tmp_path, "one", "def derive(page): pass\n")
    told = CliRunner().invoke(app, ["verify", "--source", str(tmp_path)])
    (line,) = str(told.exception).splitlines()
    assert "source.py" in line


def test_a_verdict_arrives_from_a_python_that_would_have_it_looked_up(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """As Pythons before 3.11.4 write a name of an enumeration: `getattr`, which nobody may name."""

    def looked_up(kind: Kind, protocol: int) -> tuple[object, ...]:
        return getattr, (type(kind), kind.name)

    monkeypatch.setattr(Kind, "__reduce_ex__", looked_up)
    assert b"getattr" in pickle.dumps(Kind.PROVED)
    assert arrived(sent(Kind.PROVED), Path("a.py")) is Kind.PROVED


SOURCE = r"""
from symhaptic.paper.quoted import Quoted
from symhaptic.paper.statement import Source, Statement
SOURCE = Source("KEY", "On a number")
STATEMENTS = (
    Statement("KEY:sum", "(1)", "a sum", (r"\alpha = \beta + \beta",)),
    Statement("KEY:two", "(2)", "another sum", (r"\alpha = 3 \beta",)),
    Statement("KEY:size", "(3)", "its size", quoted=(Quoted("about", "3.15"),)),
)
"""
SENDS = r"""
import os, sys
from dataclasses import replace
from pathlib import Path
from sympy import Eq, pi
from symhaptic.book import ledger
from symhaptic.book.arrivals import sent
from symhaptic.book.chapters import Chapter
from symhaptic.book.ledger import Entry
from symhaptic.book.sources import STATEMENTS
from symhaptic.notation import alpha, beta
from symhaptic.paper import Statement
from symhaptic.proof.theorems.judge import Judged
from symhaptic.proof.verdict import Kind, Verdict
SUM, SIZE = STATEMENTS["KEY:sum"], STATEMENTS["KEY:size"]
def derive(page):
    page.define("Sum", alpha, 2 * beta)
    page.settle("KEY:sum", Eq(alpha, 2 * beta))
    right, at = [r"\alpha = 2 \beta"], {alpha: 1, beta: 1}
    page.settle("KEY:two", Eq(alpha, 2 * beta), corrected=right, unless=at)
    sum_, two = ledger.of_chapter(Chapter(Path(__file__), "T", "", page, 0.0))
    sum_, two = (
        replace(e, verdict=replace(v, corrected=None, corrected_latex=ledger.corrected_form(v)))
        for e in (sum_, two)
        for v in (e.verdict,)
    )
    def said(entry, **other):
        return [replace(entry, verdict=replace(entry.verdict, **other))]
    frame = sys._getframe()
    while "connection" not in frame.f_locals:
        frame = frame.f_back
    frame.f_locals["connection"].send_bytes(sent(FORGED))
    os._exit(0)
"""
SENT = {
    "sum_, two": None,
    "said(two, corrected_latex='x = 7')": "another correction",
    "said(two, counterexample={'x': '5'})": "another counterexample",
    "said(sum_, rests=('jury',))": "another ground",
    "said(sum_, kind=Kind.ENCLOSED, value='3')": "compared again it is proved",
    "[Entry(SIZE, Verdict(Kind.ENCLOSED, '', value='3.15'), None, 0.0)]": "not compared again",
    "said(two, kind='proved\\u200b')": "is no result",
    "said(sum_, value='1\\nproved')": "is no result",
    "[replace(sum_, statement=Statement('a\\nb', '', ''))]": "is no result",
    "[replace(sum_, statement=Statement('own', '', '', (r'\\frac{',)), own=True)]": "is no result",
    "[replace(sum_, judged=Judged(7))]": "is no result",
    "[replace(sum_, verdict=None)]": "is no result",
    "[1, 2]": "is no result",
    "7": "is no result",
}


KEYS = (f"source{i}" for i in itertools.count())
"""A source is known once in a process."""


def told_of(folder: Path, body: str, source: str = SOURCE, *more: str) -> Result:
    """What `verify` says of a source with one chapter."""
    key = next(KEYS)
    (folder / "source.py").write_text(source.replace("KEY", key))
    chapter(folder, "chapter", body.replace("KEY", key))
    return CliRunner().invoke(app, ["verify", "--source", str(folder), *more])


@pytest.mark.parametrize("forged", SENT)
def test_what_is_sent_is_held_against_what_is_found_where_it_arrives(
    forged: str, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    """A chapter sends verdicts of its own making, or nothing like verdicts."""
    wrong = SENT[forged]
    told = told_of(tmp_path, SENDS.replace("FORGED", forged if wrong else "[sum_, two]"))
    assert told.exit_code == (0 if wrong is None else 2 if wrong == "is no result" else 1)
    assert wrong is None or wrong in told.output
    assert "Traceback" not in capfd.readouterr().err


def test_what_is_shown_of_a_statement_is_what_is_known_of_it(tmp_path: Path) -> None:
    """The verdict is right, and the statement beside it another one."""
    other = "[replace(sum_, derivation='x', statement=Statement('KEY:sum', '', '', ('0 = 1',)))]"
    told = told_of(tmp_path, SENDS.replace("FORGED", other), SOURCE, "--format", "json")
    first = json.loads(told.stdout)["statements"][0]
    assert (first["statement"], first["derivation"]) == (r"\alpha = \beta + \beta", "chapter.py")


@pytest.mark.parametrize(("digits", "kind"), [("3.14", "enclosed"), ("3.15", "refuted")])
def test_a_number_that_a_source_quotes_is_measured_again(
    digits: str, kind: str, tmp_path: Path
) -> None:
    """That it is this number which the text quotes is said by words."""
    body = SENDS.partition("    page.define")[0] + '    page.settle("KEY:size", value=pi)\n'
    told = told_of(tmp_path, body, SOURCE.replace("3.15", digits), "--format", "json")
    assert told.exit_code == 0
    size = json.loads(told.stdout)["statements"][2]
    assert (size["verdict"], size["argued_for"]) == ("argued", kind)


def test_a_statement_that_is_known_is_nobodys_own() -> None:
    # of one's own an argued verdict is no failure; of the paper's it is not what the ledger says
    said = Verdict(Kind.ARGUED, "so it is", argued_for=Kind.PROVED)
    [entry] = looked_at([Entry(STATEMENTS["eq11"], said, None, 0.0, own=True)])
    assert surprises([entry], {"eq11": "qualified"}, whole=False)
