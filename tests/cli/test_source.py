"""A folder of a user's own: its statements and chapters, as CONTRIBUTING shows it."""

import json
from pathlib import Path
from xml.etree import ElementTree

import pytest
from command import symhaptic

TEXT = (Path(__file__).parents[2] / "CONTRIBUTING.md").read_text(encoding="utf-8")
SECTION = TEXT.split("## A source of your own")[1].split("\n## ")[0]
SOURCE, CHAPTER = (block.split("```")[0] for block in SECTION.split("```python\n")[1:])


@pytest.fixture
def notes(tmp_path):
    folder = tmp_path / "notes"
    folder.mkdir()
    (folder / "source.py").write_text(SOURCE, encoding="utf-8")
    (folder / "drifting.py").write_text(CHAPTER, encoding="utf-8")
    return folder


def verdicts(folder, *options):
    run = symhaptic("verify", "--source", folder, "--format", "json", *options)
    assert not run.stderr
    return {r["id"]: r for r in json.loads(run.stdout)["statements"]}


def test_the_example_is_settled_in_its_own_notation(notes):
    found = verdicts(notes, "--strict")
    assert {id: r["verdict"] for id, r in found.items()} == {
        "drift:way": "proved",
        "drift:force": "misprint",
    }
    assert found["drift:way"]["source"] == "Notes on drifting masses"
    assert "c" in found["drift:way"]["statement"]
    assert found["drift:force"]["corrected"] == r"F = b\left(v-\frac{bx}{m}\right)"
    # each verdict names the definitions that it follows from
    assert [d.partition(":=")[0] for d in found["drift:way"]["definitions"]] == ["x", "F"]


def test_what_is_committed_beside_it_is_held_against_it(notes):
    committed = notes / "ledger.json"
    assert (
        symhaptic("verify", "--source", notes, "--format", "json", "-o", committed).returncode == 0
    )
    assert symhaptic("verify", "--source", notes, "--strict").returncode == 0
    # the notes are mended: the verdict is another one, and that is told
    (notes / "source.py").write_text(SOURCE.replace("{2m}", "{m}"), encoding="utf-8")
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 1
    assert "DIFFERS  drift:force: definition, but the ledger says misprint" in run.stdout


def test_a_chapter_without_its_source_is_told_where_its_verdicts_are_held_against_the_ledger(notes):
    run = symhaptic("verify", "--derivation", notes / "drifting.py")
    assert run.returncode == 1
    [line] = [line for line in run.stdout.splitlines() if line.startswith("DIFFERS")]
    assert line.startswith("DIFFERS  drift:force: misprint: ")
    assert line.endswith("; a statement of one's own is to hold")
    assert "drift:way    proved" in run.stdout
    assert f"`symhaptic verify --source {notes}` compares with its ledger" in run.stderr
    run = symhaptic("verify", "drift:way", "--derivation", notes / "drifting.py")
    assert (run.returncode, run.stderr) == (0, "")


@pytest.mark.parametrize("derived", ["", ", Eq(x, 2*y)"])
def test_data_outside_is_no_proof_until_the_ledger_has_it(tmp_path, derived):
    """What a chapter has from data outside is its word, whatever else it says beside it."""
    body = f"def derive(page):\n    page.settle_external('odd:one', 'a book', 'seen'{derived})"
    folder = odd(tmp_path, body)
    run = symhaptic("verify", "--source", folder, "--strict")
    assert run.returncode == 1
    assert "DIFFERS  odd:one: external, and no ledger says so" in run.stdout
    assert symhaptic("verify", "--source", folder).returncode == 0
    ledger = folder / "ledger.json"
    symhaptic("verify", "--source", folder, "--format", "json", "-o", ledger)
    assert symhaptic("verify", "--source", folder, "--strict").returncode == 0


def test_a_misprint_that_becomes_another_one_is_told(notes):
    """Its verdict is the same, and so was what `verify` said of it."""
    ledger = notes / "ledger.json"
    symhaptic("verify", "--source", notes, "--format", "json", "-o", ledger)
    for file, old, new, told in (
        ("source.py", "{2m}", "{3m}", r"the print is F = c(v - \frac{cx}{3m}), but"),
        (
            "drifting.py",
            "F, b * (v - b * x / m)",
            "F, b * v - b**2 * x / m",
            "the correction is F = ",
        ),
    ):
        path, kept = notes / file, (notes / file).read_text(encoding="utf-8")
        path.write_text(kept.replace(old, new), encoding="utf-8")
        run = symhaptic("verify", "--source", notes, "--strict")
        assert (run.returncode, f"DIFFERS  drift:force: {told}" in run.stdout) == (1, True)
        assert symhaptic("verify", "--source", notes).returncode == 0
        path.write_text(kept, encoding="utf-8")
    assert symhaptic("verify", "--source", notes, "--strict").returncode == 0


def test_an_emptied_ledger_is_not_none(notes):
    (notes / "ledger.json").write_text('{"statements": []}', encoding="utf-8")
    run = symhaptic("verify", "--source", notes, "--strict")
    assert run.returncode == 1
    assert "DIFFERS  drift:force: misprint, but the ledger says nothing" in run.stdout


def test_a_print_of_which_a_part_is_derived_is_no_misprint(notes):
    two = SOURCE.replace('{2m})",)', '{2m})", "F = cv")')
    (notes / "source.py").write_text(two, encoding="utf-8")
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 2
    assert "drift:force: 1 equations are derived, and 2 printed" in run.stderr


def test_a_number_that_the_text_quotes_is_settled_with_the_formula(notes):
    """A formula that follows from definitions is not enough: pi is not about 3.2."""
    quoted = SOURCE.replace('e^{-ct/m})",)', "e^{-ct/m})\",), quoted=(Quoted('about', '3.2'),)")
    quoted = "from symhaptic.paper.quoted import Quoted\n" + quoted
    (notes / "source.py").write_text(quoted, encoding="utf-8")
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 2
    assert "drift:way: the text quotes a number, too; give value=" in run.stderr
    chapter = CHAPTER.replace("-b * t / m))))", "-b * t / m))), value=3 + exp(-2))")  # 3.135...
    (notes / "drifting.py").write_text(chapter, encoding="utf-8")
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 2
    assert "drift:way: 3.2 does not stand in what is shown" in run.stderr


def test_what_no_chapter_settles_is_undecided(notes):
    more = SOURCE.replace(
        '{2m})",)),\n', '{2m})",)),\n    Statement("drift:late", "(3)", "never late"),\n'
    )
    (notes / "source.py").write_text(more, encoding="utf-8")
    assert verdicts(notes)["drift:late"]["verdict"] == "undecided"
    assert symhaptic("verify", "--source", notes, "--strict").returncode == 1


def test_another_sign_in_its_print_is_a_misprint(notes):
    wrong = SOURCE.replace("(1 - e", "(1 + e")
    (notes / "source.py").write_text(wrong, encoding="utf-8")
    found = verdicts(notes)["drift:way"]
    assert found["verdict"] == "misprint"
    assert found["counterexample"]


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("drift:way", "drift-way", "'drift-way' is to begin with 'drift:'"),
        ('"drift:force"', '"drift:way"', "'drift:way' is to begin with 'drift:' and to stand once"),
        ('Source("drift"', 'Source("rules"', "'rules' of a source is not allowed"),
        ("{mv}{c}", "{mv}{q_9}", "'q_9' is not in the notation"),
        ("{mv}{c}", "{mv}{b}", "'b', which the source calls 'c', in"),
        ('(("c", "b"),)', '(("c", "b"), ("q", "b"))', "the notation has 'b' twice on a side"),
        ('(("c", "b"),)', '(("c", "b"), ("c", "T"))', "the notation has 'c' twice on a side"),
        (
            '(("c", "b"),)',
            '(("c", "damper"),)',
            "'damper' for 'c'; give a symbol of symhaptic.notation",
        ),
        ('(("c", "b"),)', '(("cv", "b"),)', "'cv' is no name"),
        (r'{2m})",)', r'{2m})",), reading=("F = cv",)', "reading: says something else than"),
        (r'{2m})",)', r'{2m}!)",), reading=("F < cv",)', "has other relation signs than the print"),
        ("{2m}", "{9^{9^{9^{9}}}}", "a number of more than 100000 bits, in "),
        ('"Notes on drifting masses"', "None", "title: None of a source is not allowed; give text"),
        ("STATEMENTS", "PRINTED", "has no SOURCE or no STATEMENTS"),
        ("SOURCE =", "SOURCE = =", "invalid syntax"),
    ],
)
def test_a_bad_source_is_told_in_one_line(notes, old, new, told):
    (notes / "source.py").write_text(SOURCE.replace(old, new), encoding="utf-8")
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 2
    assert not run.stdout
    assert told in run.stderr
    assert "source.py" in run.stderr
    assert len(run.stderr.splitlines()) == 1


def test_of_two_sources_none_is_left_out_in_silence(notes):
    for twice in (("--source", notes, "--source", notes), (f"--source={notes}", "--source", notes)):
        run = symhaptic("verify", *twice)
        said = "symhaptic: error: --source: is given more than once; give one value\n"
        assert (run.returncode, run.stdout, run.stderr) == (2, "", said)
    run = symhaptic("verify", "eq11", "-oone.txt", "-oother.txt")
    assert (run.returncode, run.stderr) == (2, said.replace("--source", "-o"))


@pytest.mark.parametrize("beside", ["--derivation", "--list"])
def test_what_a_source_has_itself_is_not_given_beside_it(notes, beside):
    given = [beside, notes / "drifting.py"] if beside == "--derivation" else [beside]
    run = symhaptic("verify", "--source", notes, *given)
    assert (run.returncode, run.stdout) == (2, "")
    assert "does not go with --derivation or --list" in run.stderr


def test_a_folder_without_a_source_or_chapters_is_refused(notes, tmp_path):
    run = symhaptic("verify", "--source", tmp_path)
    assert run.returncode == 2
    assert "has no source.py" in run.stderr
    (notes / "drifting.py").unlink()
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 2
    assert "has no chapter" in run.stderr


def test_it_is_printed_and_attacked_like_the_paper(notes, tmp_path):
    run = symhaptic("report", "--source", notes, "--format", "tex", "-o", tmp_path / "out")
    assert run.returncode == 0, run.stderr
    text = (tmp_path / "out" / "chapters.tex").read_text(encoding="utf-8")
    assert "Notes on drifting masses" in text
    assert "Hulin" not in text
    run = symhaptic("mutants", "--source", notes)
    assert run.returncode == 0, run.stdout
    assert " 0 accepted though wrong" in run.stdout


def test_a_check_of_mutants_has_a_record_to_hold_them_against(notes, tmp_path):
    """Without one it held them against nothing, and passed."""
    run = symhaptic("mutants", "--source", notes, "--check")
    assert (run.returncode, run.stderr.splitlines()) == (
        2,
        ["symhaptic: error: --check: the record is needed; -o FILE names it"],
    )
    record = ("-o", tmp_path / "mutants.json")
    assert symhaptic("mutants", "--source", notes, "--check", *record).returncode == 2
    assert symhaptic("mutants", "--source", notes, *record).returncode == 0
    assert symhaptic("mutants", "--source", notes, "--check", *record).returncode == 0


def odd(tmp_path, body, ids=("odd:one",), printed="x = 2y"):
    folder = tmp_path / "odd"
    folder.mkdir()
    (folder / "source.py").write_text(
        "from symhaptic.paper.statement import Source, Statement\n"
        'SOURCE = Source("odd", "Odd notes", "A. Author", "2026")\n'
        "STATEMENTS = tuple(\n"
        f'    Statement(id, "(1)", "an equation", ({printed!r},)) for id in {ids!r}\n'
        ")\n",
        encoding="utf-8",
    )
    (folder / "chapter.py").write_text(
        '"""A title\n\nAn introduction.\n"""\nimport os\nfrom sympy import Eq, symbols\n'
        f'x, y = symbols("x y")\n{body}\n',
        encoding="utf-8",
    )
    return folder


@pytest.mark.parametrize(
    ("body", "said"),
    [
        ("def derive(page):\n    raise KeyboardInterrupt", "KeyboardInterrupt"),
        ("async def derive(page):\n    pass", "derive is async or has a yield"),
        ("def derive(page):\n    yield page", "derive is async or has a yield"),
        ("def derive(page):\n    os._exit(0)", "its process ended without a result"),
        (
            "class E(Exception):\n    def __str__(self):\n        return 3\n"
            "def derive(page):\n    raise E",
            "E: <exception str() failed>",
        ),
        (
            "class E(Exception):\n    __module__ = None\ndef derive(page):\n    raise E('wrong')",
            "E: wrong",
        ),
        ("__doc__ = 3\ndef derive(page):\n    pass", "has no docstring"),
        ("def derive(page):\n    raise SyntaxError", "SyntaxError: None"),
        ("def derive(page):\n    raise ValueError(9999 * 'x')", "xxx..."),
        ('def derive(page):\n    page.enclosed("t", [1])', "1 is no pair of a name"),
        ('def derive(page):\n    page.enclosed("t", ["ab"])', "'ab' is no pair of a name"),
        ('def derive(page):\n    page.define("t", "{x", 2*y)', "'{x' has braces that do not match"),
        ('def derive(page):\n    page.state("a", "b", "}")', "'}' is not in the notation"),
        ('def derive(page):\n    page.state("a\\nb", "two lines")', "up to 99 further letters"),
    ],
)
def test_a_chapter_that_fails_is_one_line_and_a_case_in_error(tmp_path, body, said):
    folder, out = odd(tmp_path, body), tmp_path / "out.xml"
    run = symhaptic("verify", "--source", folder, "--format", "junit", "-o", out)
    assert run.returncode == 2
    [line] = run.stderr.splitlines()
    assert said in line
    assert len(line) < 1000
    suite = ElementTree.parse(out).getroot()
    assert suite.get("errors") == "1"
    [error] = suite.iter("error")
    assert said in error.get("message")


def test_what_a_chapter_writes_is_no_part_of_a_listing(tmp_path):
    body = "def derive(page):\n    os.write(1, b'{}')\n    page.settle('odd:one', Eq(x, 2*y))"
    run = symhaptic("verify", "--source", odd(tmp_path, body), "--format", "json")
    assert [r["id"] for r in json.loads(run.stdout)["statements"]] == ["odd:one"]
    assert "{}" in run.stderr


@pytest.mark.parametrize("id", ["odd:", "odd:a b", "odd:a\nb", "odd:\x1b[31m", "odd:" + 200 * "l"])
def test_an_id_is_what_a_line_can_name(tmp_path, id):
    body = "def derive(page):\n    page.settle('odd:one', Eq(x, 2*y))"
    run = symhaptic("verify", "--source", odd(tmp_path, body, ("odd:one", id)))
    assert run.returncode == 2
    assert len(run.stderr.splitlines()) == 1
    assert "up to 99 further letters" in run.stderr


def test_each_case_of_a_source_fails_for_itself(tmp_path):
    ids = ("odd:one", "odd:two", "odd:u.3")
    body = "def derive(page):\n" + "".join(f"    page.settle({id!r}, Eq(x, 2*y))\n" for id in ids)
    folder, out = odd(tmp_path, body, ids), tmp_path / "out.xml"
    committed = [{"id": id, "verdict": "refuted"} for id in ids[:2]]
    (folder / "ledger.json").write_text(json.dumps({"statements": committed}))
    run = symhaptic("verify", "--source", folder, "--format", "junit", "-o", out)
    assert run.returncode == 1
    cases = list(ElementTree.parse(out).getroot())
    assert [case.get("name") for case in cases] == list(ids)
    assert all(case.find("failure") is not None for case in cases)


def test_what_xml_has_no_character_for_is_replaced(tmp_path):
    body = "def derive(page):\n    raise ValueError('a\\x00b\\x1b\\ufffe')"
    folder, out = odd(tmp_path, body), tmp_path / "out.xml"
    symhaptic("verify", "--source", folder, "--format", "junit", "-o", out)
    [error] = ElementTree.parse(out).getroot().iter("error")
    assert "ValueError: a\ufffdb\ufffd\ufffd" in error.get("message")


CLAIMS = """
from sympy import Eq, Symbol
from symhaptic.notation.proposition import ForAll, proposition
from symhaptic.paper.propositions.registry import claims
from symhaptic.paper.statement import Source, Statement
x = Symbol("x")
SOURCE = Source("odd", "Odd notes", "A. Author", "2026")
STATEMENTS = (Statement("odd:words", "p. 1", "a square of a sum has three terms"),)

@claims("odd:words")
def _squared(printed):
    return ForAll((x,), proposition(Eq((x + 1)**2, x**2 + 2*x + 1)))
"""
SQUARED = """
from symhaptic.proof.theorems.kernel import gen
from symhaptic.proof.theorems.leaves import identity
def derive(page):
    page.settle("odd:words", gen(identity((x + 1)**2, x**2 + 2*x + 1), x))
"""


def test_what_a_source_claims_in_words_is_settled_by_a_theorem(tmp_path):
    folder = odd(tmp_path, SQUARED)
    (folder / "source.py").write_text(CLAIMS, encoding="utf-8")
    assert verdicts(folder, "--strict")["odd:words"]["verdict"] == "proved"


@pytest.mark.parametrize("printed", ["x = 7y", "7y < x", "x", None])
def test_what_is_claimed_of_a_print_concludes_it(tmp_path, printed):
    """The square of a sum was a proof of whatever was printed beside it."""
    folder = odd(tmp_path, SQUARED)
    shown = CLAIMS.replace(
        '"a square of a sum has three terms")', f'"three terms", ({printed!r},))'
    )
    (folder / "source.py").write_text(shown if printed else CLAIMS, encoding="utf-8")
    run = symhaptic("verify", "--source", folder, "--strict")
    if printed is None:
        assert run.returncode == 0, run.stderr
        return
    assert run.returncode == 2
    told = "is no relation" if printed == "x" else "the claim does not conclude the print"
    assert told in run.stderr


@pytest.mark.parametrize(
    ("claims", "chapter", "told"),
    [
        # a theorem of something else
        (("2*x + 1", "2*x + 2"), ("", ""), "chapter.py"),
        (("", ""), ("(x + 1)**2, x**2 + 2*x + 1", "(x + 2)**2, x**2 + 4*x + 4"), "chapter.py"),
        # claimed of what is not stated, of what the paper states, and not a proposition
        (('@claims("odd:words")', '@claims("odd:other")'), ("", ""), "'odd:other', which it does"),
        (('@claims("odd:words")', '@claims("eq11")'), ("", ""), "eq11 is claimed twice"),
        (("return ForAll", "return str"), ("", ""), "source.py"),
    ],
)
def test_what_it_does_not_claim_is_not_settled_so(tmp_path, claims, chapter, told):
    folder = odd(tmp_path, SQUARED.replace(*chapter))
    (folder / "source.py").write_text(CLAIMS.replace(*claims), encoding="utf-8")
    run = symhaptic("verify", "--source", folder, "--strict")
    assert run.returncode == 2
    assert told in run.stderr
    assert run.stderr.count("\n") == 1
    assert "proved" not in run.stdout


OTHER = "(x + 2)**2, x**2 + 4*x + 4"
IMPORTED = """
from symhaptic.notation.proposition import ForAll, proposition
from symhaptic.paper.propositions.registry import CLAIMED, claims
"""


@pytest.mark.parametrize(
    ("claimed", "print_"),
    [
        ('CLAIMED["odd:words"] = lambda printed: {}\n', ""),
        ('claims("odd:words")(lambda printed: {})\n', "x = 7y"),
        ('claims("odd:words")(lambda printed: {})\n', "7y < x"),
        ('claims("odd:words")(lambda printed: {})\n', ""),
    ],
)
def test_a_chapter_does_not_say_what_its_source_claims(tmp_path, claimed, print_):
    """A claim that a chapter registers of its source's print had been taken for the source's."""
    forged = IMPORTED + claimed.format(f"ForAll((x,), proposition(Eq({OTHER})))")
    folder = odd(tmp_path, forged + SQUARED.replace("(x + 1)**2, x**2 + 2*x + 1", OTHER))
    source = CLAIMS if "CLAIMED" in claimed else CLAIMS.split("@claims")[0]
    if print_:
        source = source.replace('three terms")', f'three terms", ({print_!r},))')
    (folder / "source.py").write_text(source, encoding="utf-8")
    run = symhaptic("verify", "--source", folder)
    assert run.returncode == 2
    assert run.stdout.splitlines()[0].split()[:2] == ["odd:words", "undecided"]
    told = "the theorem says" if "CLAIMED" in claimed else "has no claim that a theorem could show"
    assert told in run.stderr


@pytest.mark.parametrize(
    ("statement", "told"),
    [
        (
            'Statement("drift:way", "p. 1", "", ["x = v t"])',
            "latex: ['x = v t'] is not allowed; give a tup",
        ),
        (
            'Statement("drift:way", "p. 1", "", "x = v t")',
            "latex: 'x = v t' is not allowed; give a tuple ",
        ),
        ('Statement("drift:way", 1, "it drifts")', "location: 1 is not allowed; give text"),
        ('Statement("drift:way", "p. 1", None)', "says: None is not allowed; give text"),
    ],
)
def test_what_is_no_text_is_told_in_one_line(notes, statement, told):
    (notes / "source.py").write_text(
        "from symhaptic.book.sources import Source, Statement\n"
        f'SOURCE = Source("drift", "Notes")\nSTATEMENTS = ({statement},)\n',
        encoding="utf-8",
    )
    run = symhaptic("verify", "--source", notes)
    assert (run.returncode, run.stdout) == (2, "")
    assert f": drift:way: {told}" in run.stderr
    assert run.stderr.count("\n") == 1


def test_a_folder_for_a_ledger_is_not_taken_for_none(notes):
    (notes / "ledger.json").mkdir()
    run = symhaptic("verify", "--source", notes, "--strict")
    assert run.returncode == 2
    assert "ledger.json: is a folder" in run.stderr


def test_a_link_to_nothing_is_not_taken_for_none(notes):
    (notes / "ledger.json").symlink_to(notes / "gone.json")
    run = symhaptic("verify", "--source", notes)
    assert run.returncode == 2
    assert "ledger.json: is no file" in run.stderr


@pytest.mark.parametrize("id", [3, ["drift:way"], None])
def test_an_id_in_a_ledger_is_text(notes, id):
    (notes / "ledger.json").write_text(
        json.dumps({"statements": [{"id": id, "verdict": "proved"}]}), encoding="utf-8"
    )
    run = symhaptic("verify", "--source", notes)
    assert (run.returncode, run.stdout) == (2, "")
    assert "ledger.json: is no ledger; " in run.stderr
    assert run.stderr.count("\n") == 1


def test_a_ledger_with_an_id_twice_fails(notes):
    path = notes / "ledger.json"
    symhaptic("verify", "--source", notes, "--format", "json", "-o", path)
    data = json.loads(path.read_text())
    data["statements"].insert(0, {**data["statements"][0], "verdict": "refuted"})
    path.write_text(json.dumps(data))
    run = symhaptic("verify", "--source", notes, "--strict")
    assert run.returncode == 2
    assert "has the id 'drift:way' 2 times" in run.stderr


def test_another_counterexample_is_told(notes):
    path = notes / "ledger.json"
    symhaptic("verify", "--source", notes, "--format", "json", "-o", path)
    # where a damper of 3 Ns/m has slowed 1 kg from 5 m/s for 2 s
    chapter = CHAPTER.replace("b * x / m)))", "b * x / m)), unless={b: 3, m: 1, t: 2, v: 5})")
    assert chapter != CHAPTER
    (notes / "drifting.py").write_text(chapter, encoding="utf-8")
    assert symhaptic("verify", "--source", notes).returncode == 0
    run = symhaptic("verify", "--source", notes, "--strict")
    assert run.returncode == 1
    assert "DIFFERS  drift:force: the counterexample is {'b': '3', 'm': '1', 't': '2'" in run.stdout


def test_no_control_character_reaches_a_terminal(tmp_path):
    body = "def derive(page):\n    page.settle('odd:one', Eq(x, 2*y))"
    folder = odd(tmp_path, body)
    source = folder / "source.py"
    source.write_text(source.read_text().replace("an equation", "\\x1b[31m red \\x9b1m"))
    run = symhaptic("verify", "--source", folder, "odd:one")
    assert "\ufffd[31m red \ufffd1m" in run.stdout
    for wrong in ("raise ValueError('\\x1b[2J')", "page.settle('\\x1b[2J')"):
        (folder / "chapter.py").write_text(f'"""A title"""\ndef derive(page):\n    {wrong}\n')
        run = symhaptic("verify", "--source", folder)
        assert run.returncode == 2
        assert "\x1b" not in run.stdout + run.stderr
