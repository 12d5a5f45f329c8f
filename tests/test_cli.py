"""The command line keeps the contract: exit status, one line for bad input, nothing lost."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from xml.etree import ElementTree

import chapters
import pytest
import typer
from command import symhaptic

from symhaptic.book.chapters import expected_ledger
from symhaptic.book.listing import replace
from symhaptic.book.parts import numbers
from symhaptic.book.report.printed import chapter_tex
from symhaptic.cli.main import app, main
from symhaptic.paper import STATEMENTS

ROOT = Path(__file__).parents[1]

GOOD = '''r"""A title.

Words.
"""
from sympy import Eq, cos, sin
from symhaptic.notation import theta, x


def derive(page):
    page.step("A step", sin(theta) ** 2, 1 - cos(theta) ** 2)
    page.step("Doubled", sin(2 * theta), 2 * sin(theta) * cos(theta), name=x)
    page.state("my-own", "doubling", r"x + 1 = (\\sin(\\theta) + \\cos(\\theta))^2")
    page.settle("my-own", Eq(x + 1, 1 + sin(2 * theta)))
'''


def started(*arguments):
    return subprocess.run(
        [sys.executable, "-c", "from symhaptic.cli.main import main; main()", *map(str, arguments)],
        capture_output=True,
        text=True,
        check=False,
        timeout=1200,
    )


def chapter(folder: Path, text: str, name: str = "my.py") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_selected_ids_only():
    run = symhaptic("verify", "eq1", "eq8")
    assert run.returncode == 0
    heads = [line.split()[0] for line in run.stdout.splitlines() if line[:2] == "eq"]
    assert heads == ["eq1", "eq8"]


WORDS = {
    "quotation": "Note that this condition is independent of mass",
    "reading": "does not depend on the mass",
    "proposition": r"\mathrm{passive}",
    "verdict": "proved",
}


def test_a_named_statement_is_told_from_the_papers_words_to_the_verdict():
    told = symhaptic("verify", "s3a-mass-free").stdout
    places = [told.index(f"{name}: ") for name in WORDS]
    assert places == sorted(places)
    for name, what in WORDS.items():
        assert what in told.split(f"{name}: ")[1].splitlines()[0]


def test_json_and_junit_have_the_papers_words_our_reading_and_the_proposition():
    [found] = json.loads(symhaptic("verify", "s3a-mass-free", "--format", "json").stdout)[
        "statements"
    ]
    keys = "quote", "says", "proposition", "verdict"
    for key, what in zip(keys, WORDS.values(), strict=True):
        assert what in found[key]
    case = ElementTree.fromstring(symhaptic("verify", "s3a-mass-free", "--format", "junit").stdout)
    lines = case.findtext("testcase/system-out").splitlines()
    assert [line.partition(": ")[0] for line in lines] == list(WORDS)
    for line, what in zip(lines, WORDS.values(), strict=True):
        assert what in line


def test_every_record_of_the_paper_has_words():
    for record in json.loads(expected_ledger().read_text(encoding="utf-8"))["statements"]:
        statement = STATEMENTS.get(record["id"])
        assert record["says"] == (statement.says if statement else record["says"])
        assert record["says"], record["id"]


@pytest.fixture
def open_question(monkeypatch):
    """eq1 is settled by no derivation, and the committed ledger knows it."""
    monkeypatch.setattr("symhaptic.book.parallel.settled", lambda *arguments: [])
    monkeypatch.setattr("symhaptic.book.committed.expected", lambda path: {"eq1": "undecided"})


def status(monkeypatch, *arguments):
    """Exit status of the command, run in this process."""
    monkeypatch.setattr(sys, "argv", ["symhaptic", *map(str, arguments)])
    with pytest.raises(SystemExit) as left:
        main()
    return left.value.code


def test_strict_fails_on_undecided_only(open_question, monkeypatch):
    assert status(monkeypatch, "verify", "eq1") == 0
    assert status(monkeypatch, "verify", "eq1", "--strict") == 1
    assert symhaptic("verify", "--strict", "eq1").returncode == 0


def committed(id):
    from symhaptic.book.chapters import expected_ledger
    from symhaptic.book.committed import expected

    return expected(expected_ledger())[id]


def test_junit_names_each_statement_with_verdict_and_seconds(tmp_path):
    target = tmp_path / "out.xml"
    assert symhaptic("verify", "eq1", "eq11", "--format", "junit", "-o", target).returncode == 0
    suite = ElementTree.parse(target).getroot()
    cases = {case.get("name"): case for case in suite.iter("testcase")}
    assert set(cases) == {"eq1", "eq11"}
    verdicts = {n: c.find("properties/property").get("value") for n, c in cases.items()}
    assert verdicts == {"eq1": "definition", "eq11": committed("eq11")}
    assert all(float(one.get("time")) < 300 for one in (suite, *cases.values()))
    assert suite.get("failures") == "0"


def test_junit_tells_what_is_undecided(open_question, monkeypatch, tmp_path):
    found = []
    for name, options in (("a.xml", []), ("b.xml", ["--strict"])):
        status(monkeypatch, "verify", "eq1", "--format", "junit", "-o", tmp_path / name, *options)
        found.append(ElementTree.parse(tmp_path / name).getroot().find("testcase"))
    assert found[0].find("skipped") is not None
    assert found[1].find("failure") is not None


def test_a_statement_that_is_gone_is_missed():
    from symhaptic.book import committed, ledger, listing

    entries = ledger.ledger([])
    known = {e.statement.id: str(e.verdict.kind) for e in entries} | {"my-own": "proved"}
    assert committed.surprises(entries, known, whole=False) == []
    missed = committed.surprises(entries, known)
    assert missed == ["my-own: nothing, but the ledger says proved"]
    suite = ElementTree.fromstring(listing.junit(entries, missed, strict=False))
    (case,) = (c for c in suite.iter("testcase") if c.get("name") == "my-own")
    assert case.find("failure") is not None
    assert suite.get("tests") == str(len(entries) + 1)


def test_a_chapter_that_is_not_there_is_named_at_once(monkeypatch, capsys):
    from symhaptic.book import parallel

    monkeypatch.setattr(parallel, "settled", lambda *_: pytest.fail("the others were run"))
    assert status(monkeypatch, "verify", "--derivation", "nowhere.py") == 2
    assert "--derivation nowhere.py: no such file" in capsys.readouterr().err


@pytest.mark.slow
def test_same_ledger_whatever_the_number_of_workers():
    ids = ["eq1", "eq5", "eq11", "eq12", "eq28", "s3c-kmax-41", "s5a-proportional"]
    ledgers = []
    for workers in (1, 2, 3):
        run = symhaptic("verify", *ids, "--format", "json", "--workers", workers)
        records = json.loads(run.stdout)["statements"]
        for record in records:
            del record["seconds"]
        ledgers.append(records)
    assert ledgers[0] == ledgers[1] == ledgers[2]
    assert [r["id"] for r in ledgers[0]] == ids


def test_a_chapter_of_ones_own(tmp_path):
    path = chapter(tmp_path, GOOD)
    run = symhaptic("verify", "my-own", "--derivation", path)
    assert run.returncode == 0, run.stderr
    assert "verdict: definition" in run.stdout  # all that it says is what x stands for
    assert r"by: x:=\sin 2\theta, defined in my.py" in run.stdout


def test_without_an_id_those_of_ones_own_chapters_are_meant(tmp_path):
    path = chapter(tmp_path, GOOD)
    other = chapter(tmp_path, GOOD.replace("my-own", "my-other"), "other.py")
    silent = chapter(tmp_path, GOOD.partition("    page.state(")[0], "silent.py")
    run = symhaptic("verify", "--derivation", path, "--derivation", other)
    assert run.returncode == 0, run.stderr
    heads = [line.split()[0] for line in run.stdout.splitlines()]
    assert heads == ["my-own", "by", "my-other", "by", "2"]
    run = symhaptic("verify", "--derivation", silent)
    assert (run.returncode, run.stdout) == (0, "0 statements\n")
    run = symhaptic("verify", "--strict", "--derivation", silent)
    assert (run.returncode, run.stdout) == (1, "0 statements\n")
    assert run.stderr == "symhaptic: there is no statement, which is not a pass\n"
    committed = GOOD.replace("my-own", "eq6").replace('    page.state("eq6", "doubling",', "    (")
    run = symhaptic("verify", "--derivation", chapter(tmp_path, committed))
    assert run.returncode == 2
    assert "'eq6' has a verdict in my.py and in derivations/" in run.stderr


def test_what_is_read_is_not_written_over(tmp_path):
    path = chapter(tmp_path, GOOD)
    for place in (path, tmp_path / "no" / ".." / "my.py"):
        (tmp_path / "no").mkdir(exist_ok=True)
        run = symhaptic("verify", "my-own", "--derivation", path, "-o", place)
        assert run.returncode == 2
        assert run.stderr.endswith(": is the input file; give another one\n")
        assert path.read_text(encoding="utf-8") == GOOD


def test_a_wrong_statement_of_ones_own_fails(tmp_path):
    path = chapter(tmp_path, GOOD.replace("x + 1 =", "x + 2 ="))
    run = symhaptic("verify", "my-own", "--derivation", path)
    assert run.returncode == 1
    assert "misprint" in run.stdout


BAD_CHAPTERS = {
    "raises": (GOOD.replace("page.step(", "1/0; page.step("), "ZeroDivisionError"),
    "raises anything": (GOOD.replace("page.step(", "raise Exception('own'); page.step("), "own"),
    "proves nothing": (
        '"""A title."""\n\ndef derive(page):\n    page.say("x")\n',
        "proves nothing",
    ),
    "false step": (GOOD.replace("1 - cos", "2 - cos"), "'A step' is false at theta = 1"),
    "leaves the program": (GOOD.replace("page.step(", "raise SystemExit(0); page.step("), "Exit"),
    "no derive": ('"""A title."""\n', "no function derive"),
    "no docstring": ("def derive(page):\n    pass\n", "no docstring"),
    "syntax": ("def derive(page:\n", "SyntaxError"),
    "unreadable LaTeX": (GOOD.replace("x + 1 =", "\\foo x + 1 ="), "not in the notation"),
}


@pytest.mark.parametrize("case", BAD_CHAPTERS)
def test_a_bad_chapter_gives_one_line_and_writes_nothing(case, tmp_path):
    text, message = BAD_CHAPTERS[case]
    path = chapter(tmp_path, text)
    run = symhaptic("verify", "eq1", "--derivation", path, "-o", tmp_path / "out.txt")
    assert run.returncode == 2
    if case == next(iter(BAD_CHAPTERS)):
        alone = symhaptic("verify", "--workers", 1, "my", "--derivation", path)
        assert (alone.returncode, alone.stderr) == (2, run.stderr)
    assert message in run.stderr
    assert str(path) in run.stderr
    assert run.stderr.count("\n") == 1
    assert "Traceback" not in run.stderr
    assert not (tmp_path / "out.txt").exists()


BAD_INPUT = {
    "unknown id": (["verify", "eq99"], "'eq99'"),
    "unknown format": (["verify", "--format", "xml"], "'xml'"),
    "missing file": (["verify", "--derivation", "nowhere.py"], "nowhere.py"),
    "folder missing": (["verify", "eq1", "-o", "nowhere/out.txt"], "nowhere"),
    "unknown command": (["frobnicate"], "'frobnicate'"),
    "unknown option": (["report", "--frobnicate"], "--frobnicate"),
    "too small a number": (["verify", "--workers", "0"], "Invalid value for '--workers': "),
    "no number": (["export", "--delay", "two"], "Invalid value for '--delay': 'two' "),
    "one word too many": (["report", "book"], "(book); see --help"),
    "unknown chapter": (
        ["report", "--chapter", "s3d_figure"],
        "'s3d_figures'",
    ),
    "standing alone without a chapter": (["report", "--standalone"], "--chapter NAME"),
    "report into a file": (["report", "-o", "a_file"], "a_file"),
    "report below a file": (["report", "-o", "a_file/deeper"], "a_file"),
    "check of a file": (["report", "--check", "-o", "a_file"], "-o a_file: is no folder"),
    "no record of mutants": (["mutants", "--check", "-o", "gone.json"], "no record gone.json"),
    "check of nothing": (["report", "--check", "-o", "nowhere"], "-o nowhere: is no folder"),
}


@pytest.mark.parametrize("case", BAD_INPUT)
def test_bad_input_gives_one_line(case, tmp_path):
    arguments, named = BAD_INPUT[case]
    (tmp_path / "a_file").write_text("kept")
    run = symhaptic(*arguments, cwd=tmp_path)
    assert run.returncode == 2
    assert named in run.stderr
    assert run.stderr.startswith("symhaptic: error: ")
    assert run.stderr.count("\n") == 1
    assert [p.name for p in tmp_path.iterdir()] == ["a_file"]
    assert (tmp_path / "a_file").read_text() == "kept"


PRINTS = "    print('hello')\n    import subprocess\n    subprocess.run(['echo', 'from a program'])"


def test_what_a_chapter_prints_stays_out_of_the_listing(tmp_path):
    path = chapter(tmp_path, GOOD.replace("    page.step(", f"{PRINTS}\n    page.step("))
    run = symhaptic("verify", "my-own", "--format", "json", "--derivation", path)
    assert json.loads(run.stdout)["statements"][0]["id"] == "my-own"
    assert "hello" in run.stderr
    assert "from a program" in run.stderr


@pytest.mark.parametrize("name", ["s3_energy.py", "book.py"])
def test_a_chapter_may_not_take_the_name_of_another_file(name, tmp_path):
    path = chapter(tmp_path, GOOD, name)
    run = symhaptic("report", "--format", "tex", "-o", tmp_path / "out", "--derivation", path)
    assert run.returncode == 2
    assert "is taken" in run.stderr
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("name", ["1 drift.py", "drift%.py", "über.py"])
def test_a_chapter_has_a_name_that_latex_can_read(name, tmp_path):
    path = chapter(tmp_path, GOOD, name)
    run = symhaptic("report", "--format", "tex", "-o", tmp_path / "out", "--derivation", path)
    assert (run.returncode, run.stderr.count("\n")) == (2, 1)
    assert "is no name for LaTeX" in run.stderr
    assert not (tmp_path / "out").exists()


ONE_CHAPTER = """
import sys
from pathlib import Path
from symhaptic.book.chapters import run, shipped
from symhaptic.book.report import printed

printed.write([run(shipped()[0])], Path(sys.argv[1]), pdf=True, say=print)
"""


def test_a_killed_report_leaves_the_old_one_whole(tmp_path):
    target = tmp_path / "reports"
    target.mkdir()
    old = "% written by `symhaptic report`; do not edit\nold"
    (target / "book.tex").write_text(old)
    (target / "ledger.json").write_text(old)
    process = subprocess.Popen(
        [sys.executable, "-c", ONE_CHAPTER, target],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        start_new_session=True,
    )
    deadline = time.monotonic() + 600
    while not list(target.glob(".draft-*")) and time.monotonic() < deadline:
        time.sleep(0.02)  # until the draft is being written
    assert list(target.glob(".draft-*"))
    os.killpg(process.pid, signal.SIGKILL)
    process.wait()
    assert (target / "book.tex").read_text() == old
    assert (target / "ledger.json").read_text() == old


@pytest.mark.parametrize("name", ["book.tex", "symhaptic.sty", "s3_energy.tex", "ledger.json"])
def test_a_report_does_not_write_over_what_is_not_its_own(name, tmp_path):
    (tmp_path / name).write_text("mine")
    begin = time.monotonic()
    run = symhaptic("report", "--format", "tex", "-o", tmp_path)
    assert run.returncode == 2
    assert f"{name} there was not written by `symhaptic report`" in run.stderr
    assert run.stderr.count("\n") == 1
    assert time.monotonic() - begin < 60  # told before the work
    assert [path.name for path in tmp_path.iterdir()] == [name]
    assert (tmp_path / name).read_text() == "mine"


def test_one_chapter_alone(tmp_path):
    (tmp_path / "book.tex").write_text("mine")  # which it does not write
    name = "s3a_undelayed"
    run = symhaptic("report", "--chapter", name, "-o", tmp_path)
    assert run.returncode == 0, run.stderr
    assert run.stdout == f"wrote {tmp_path / name}.tex\n"
    names = {path.name for path in tmp_path.iterdir()}
    assert names == {"book.tex", f"{name}.tex", "symhaptic.sty", "symhaptic.bib"}
    written = (tmp_path / f"{name}.tex").read_text(encoding="utf-8")
    assert written.endswith(chapter_tex(chapters.chapter(name), numbers()[name]))  # as in the book
    check = ("report", "--chapter", name, "--check", "-o", tmp_path)
    assert symhaptic(*check).returncode == 0
    (tmp_path / "symhaptic.sty").unlink()
    assert symhaptic(*check).returncode == 1


def test_a_chapter_of_ones_own_alone_and_standing_alone(tmp_path):
    path = chapter(tmp_path, GOOD)
    run = symhaptic("report", "--chapter", "my", "--derivation", path, "--standalone", cwd=tmp_path)
    assert run.returncode == 0, run.stderr
    assert run.stdout == "wrote reports/chapters.tex\n"
    names = {path.name for path in (tmp_path / "reports").iterdir()}
    assert names == {"my.tex", "chapters.tex", "symhaptic.sty", "symhaptic.bib"}


def test_help_and_version():
    assert "verify" in symhaptic("--help").stdout
    assert symhaptic("--version").stdout.startswith("symhaptic ")
    assert started("--version").stdout == symhaptic("--version").stdout


def test_a_flag_that_is_not_given_is_off():
    commands = typer.main.get_command(app).commands
    flags = [
        o for command in commands.values() for o in command.params if getattr(o, "is_flag", False)
    ]
    assert {option.name for option in flags} >= {"quick", "strict", "check", "standalone"}
    assert not [option.opts for option in flags if option.default]


def test_statements_are_listed_in_columns():
    from symhaptic.book.listing import names

    some = [{"id": n * "i", "location": m * "l", "says": "s"} for n, m in ((9, 2), (2, 7), (1, 1))]
    for line, one in zip(names(some, as_json=False).splitlines(), some, strict=True):
        assert line == f"{one['id'].ljust(9)}  {one['location'].ljust(7)}  s"


def test_beside_a_verdict_stands_its_number_or_its_condition_or_what_refutes_it():
    from symhaptic.book import ledger, listing

    for name in ("s3c_stiffness_maximum", "s8c_four_masses"):
        entries = ledger.of_chapter(chapters.chapter(name))
        lines = listing.text(entries, [], strict=False).splitlines()
        found = [line.split(maxsplit=1)[1] for line in lines[: len(entries)]]
        for entry, line in zip(entries, found, strict=True):
            kind, *rest = line.split(maxsplit=1)
            verdict = entry.verdict
            at = ", ".join(f"{k} = {v}" for k, v in (verdict.counterexample or {}).items())
            told = f"at {at}" if at and kind == "refuted" else verdict.value or verdict.condition
            assert kind == verdict.kind
            assert rest == [f"{told or ''}  [{entry.derivation}]".strip()]
        assert lines[len(entries)].startswith(f"{len(entries)} statements: ")


def test_of_named_statements_these_alone_are_listed():
    told = symhaptic("verify", "--list", "eq8", "eq1").stdout
    assert [line.split()[0] for line in told.splitlines()] == ["eq8", "eq1"]


@pytest.mark.parametrize(
    "arguments",
    [
        ["verify", "eq1"],
        *(pytest.param(a, marks=pytest.mark.ci) for a in (["verify", "eq99"], ["report", "book"])),
    ],
)
def test_started_from_nothing_it_says_the_same(arguments):
    told, anew = symhaptic(*arguments), started(*arguments)
    assert (told.returncode, told.stderr) == (anew.returncode, anew.stderr)
    assert told.stdout == anew.stdout


@pytest.mark.parametrize("command", ["verify", "mutants"])
def test_a_place_that_is_none_is_told_before_the_work(command, tmp_path):
    for place in (tmp_path, tmp_path / "no" / "file.json"):
        begin = time.monotonic()
        ran = symhaptic(command, "-o", place)
        assert ran.returncode == 2
        assert "cannot write there" in ran.stderr
        assert ran.stderr.count("\n") == 1
        assert time.monotonic() - begin < 60


def test_mutants_of_a_chapter_of_ones_own(tmp_path):
    path = chapter(tmp_path, GOOD)
    ran = symhaptic("mutants", "--derivation", path, cwd=tmp_path)
    assert ran.returncode == 0, ran.stderr
    count = int(ran.stdout.split()[0])
    assert count > 5
    assert "0 accepted though wrong" in ran.stdout
    assert [p.name for p in tmp_path.iterdir()] == ["my.py"]
    kept = symhaptic("mutants", "--derivation", path, "-o", "my.json", cwd=tmp_path)
    assert f"wrote my.json: {count}" in kept.stdout
    written = json.loads((tmp_path / "my.json").read_text())["chapters"]
    assert set(written) == {"my"}
    assert f"{count} changes refused, 0 survive with a reason, 0 accepted" in kept.stdout
    assert written["my"]["survivors"] == []


def test_mutants_of_nothing_are_no_pass(tmp_path):
    path = chapter(tmp_path, GOOD.partition("    page.state(")[0])
    run = symhaptic("mutants", "--derivation", path)
    assert run.returncode == 1
    assert run.stderr.endswith("symhaptic: there is nothing to change, which is not a pass\n")


def test_mutants_tell_a_chapter_that_raises(tmp_path):
    path = chapter(tmp_path, '"""What breaks?"""\n\ndef derive(page):\n    1 / 0\n')
    ran = symhaptic("mutants", "--derivation", path, cwd=tmp_path)
    assert ran.returncode == 2
    assert "my.py:4: ZeroDivisionError" in ran.stderr
    assert "Traceback" not in ran.stderr


def test_mutants_keep_a_file_of_somebody_else(tmp_path):
    mine = tmp_path / "mine.json"
    mine.write_text("{}")
    ran = symhaptic("mutants", "-o", mine)
    assert ran.returncode == 2
    assert "give another name" in ran.stderr
    assert mine.read_text() == "{}"


@pytest.mark.parametrize("command", ["report", "bench"])
def test_a_folder_that_cannot_be_is_told_before_the_work(command, tmp_path):
    (tmp_path / "file").write_text("kept")
    (tmp_path / "link").symlink_to(tmp_path / "nothing")
    for place in ("file", "file/deeper", "link", "new/" + 300 * "x"):
        begin = time.monotonic()
        ran = symhaptic(command, "-o", place, cwd=tmp_path)
        assert ran.returncode == 2
        assert f"-o {place}: cannot write there" in ran.stderr
        assert ("(Not a directory)" in ran.stderr) == place.startswith("file")
        assert ran.stderr.count("\n") == 1
        assert time.monotonic() - begin < 60
    assert sorted(path.name for path in tmp_path.iterdir()) == ["file", "link"]
    assert (tmp_path / "file").read_text() == "kept"


def test_a_pipe_is_written_to_and_a_link_stays_one(tmp_path):
    # os.replace() would put a plain file in the place of both
    pipe, link, there = tmp_path / "pipe", tmp_path / "link", tmp_path / "there"
    os.mkfifo(pipe)
    link.symlink_to(there)
    with subprocess.Popen(["cat", pipe], stdout=subprocess.PIPE, text=True) as reader:
        assert symhaptic("verify", "eq1", "-o", pipe).returncode == 0
        assert reader.communicate(timeout=600)[0].startswith("eq1")
    assert pipe.is_fifo()
    assert symhaptic("verify", "eq1", "-o", link).returncode == 0
    assert link.is_symlink()
    assert there.read_text().startswith("eq1")
    told = started("verify", "eq1", "-o", "/dev/stdout")  # a pipe without a name
    assert (told.returncode, told.stdout[:3]) == (0, "eq1"), told.stderr


def test_who_may_read_a_file_may_read_what_is_written_over_it(tmp_path):
    path, new = tmp_path / "mine.csv", tmp_path / "new.csv"
    path.write_text("old")
    path.chmod(0o600)
    masked = os.umask(0o027)
    try:
        for place in (path, new):
            replace(place, "text")
    finally:
        os.umask(masked)
    assert [oct(place.stat().st_mode & 0o777) for place in (path, new)] == ["0o600", "0o640"]
    assert path.read_text() == new.read_text() == "text"
