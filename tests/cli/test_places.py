"""Where results go, and numbers as a user writes them."""

import os
import subprocess
import sys
import time
from pathlib import Path
from typing import ClassVar

import pytest
from command import symhaptic

from symhaptic.cli import main as cli
from symhaptic.cli.main import unusable

FULL = Path("/dev/full")


@pytest.mark.skipif(not FULL.exists(), reason="no /dev/full here")
@pytest.mark.parametrize("asked", [["--version"], ["verify", "--list"], ["trace", "--help"]])
def test_a_place_that_takes_no_more_is_one_line(asked):
    with FULL.open("wb") as full:
        run = subprocess.run(
            [sys.executable, "-m", "symhaptic", *asked],
            stdout=full,
            stderr=subprocess.PIPE,
            env=os.environ,
            check=False,
        )
    assert run.returncode == 2
    [line] = run.stderr.decode().splitlines()
    assert line.startswith("symhaptic: error: standard output: cannot write")


def full():
    raise OSError(28, "No space left on device")


@pytest.mark.parametrize(
    ("command", "status"),
    [
        (lambda: None, 0), (lambda: 0, 0), (lambda: 1, 1), (lambda: 3, 3), (lambda: "text", 0),
        (lambda: 130, 130), (full, 2),
    ],
)  # fmt: skip
def test_the_exit_status_is_that_of_the_command(command, status, monkeypatch, capsys):
    """0 where it gives none, 130 of one that is left, 2 where the output takes no more."""

    class Command:
        commands: ClassVar = {}

        def main(self, standalone_mode):
            return command()

    monkeypatch.setattr(sys, "argv", ["symhaptic"])
    monkeypatch.setattr(cli.typer.main, "get_command", lambda app: Command())
    monkeypatch.setattr(os, "dup2", lambda *_: None)
    with pytest.raises(SystemExit) as left:
        cli.main()
    assert left.value.code == status
    said = {2: "symhaptic: error: standard output: cannot write", 130: "symhaptic: interrupted"}
    assert capsys.readouterr().err.startswith(said.get(status, ""))


def test_a_delay_may_be_a_fraction():
    traced = [
        symhaptic("trace", "--gamma", "0.001", "--delta", "1/50", "--delay", delay)
        for delay in ("1/2", "0.5")
    ]
    assert [run.returncode for run in traced] == [0, 0]
    assert traced[0].stdout == traced[1].stdout
    for wrong in ("1/0", "a/b", "1/2/3", "1e999/1"):
        run = symhaptic("trace", "--gamma", "0.001", "--delta", "0.02", "--delay", wrong)
        assert run.returncode == 2
        assert run.stderr == f"symhaptic: error: --delay: {wrong!r} is not allowed; give a number\n"


@pytest.mark.parametrize(
    ("command", "option"),
    [
        ("export", ["-o", "place"]),
        ("export", ["--target", "c"]),
        ("export", ["--precision", "single"]),
        ("check", ["-o", "place"]),
        ("check", ["--formula", "eq11"]),
        ("report", ["-o", "place"]),
        ("report", ["-o", "reports"]),
        ("report", ["--format", "tex"]),
        ("report", ["--check"]),
        ("report", ["--chapter", "s3d_figures"]),
    ],
)
def test_what_has_no_effect_on_a_list_is_refused(command, option, tmp_path):
    run = symhaptic(command, "--list", *option, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr == (
        f"symhaptic: error: {' '.join(option)}: has no effect on what --list prints; "
        "leave one of them out\n"
    )
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize("format", ["csv", "json"])
def test_what_is_not_traced_is_told_in_one_line(format):
    """Next to pi^2 the outline is there, and its farthest points are not."""
    run = symhaptic("trace", "--gamma", "9.8696044", "--delta", "0", "--delay", "0",
                    "--format", format)  # fmt: skip
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith("symhaptic: error: --gamma: 9.8696044 with delta=0.0 behind ")
    assert len(run.stderr.splitlines()) == 1


LEFT = """
import sys
import time


class Left:
    def find_spec(self, name, *_):
        if name == sys.argv[1]:
            raise KeyboardInterrupt


sys.meta_path.insert(0, Left())
from symhaptic.__main__ import main

main()
"""


@pytest.mark.parametrize("at", ["typer", "symhaptic.cli.main", "symhaptic.cli.limits"])
def test_left_while_it_loads_it_says_so_in_one_line(at):
    run = subprocess.run(
        [sys.executable, "-c", LEFT, at], capture_output=True, text=True, check=False
    )
    assert (run.returncode, run.stderr) == (130, "symhaptic: interrupted\n")


def test_letters_that_a_terminal_has_not_are_written_out(tmp_path):
    path = tmp_path / "my-λ.py"
    path.write_text(
        '"""A title."""\n'
        "def derive(page):\n"
        "    page.state('my-own', 'doubling', r'\\sin(2\\theta) = 2\\sin(\\theta)\\cos(\\theta)')\n"
        "    page.settle('my-own')\n",
        encoding="utf-8",
    )
    run = subprocess.run(
        [sys.executable, "-m", "symhaptic", "verify", "--derivation", path],
        capture_output=True,
        env={**os.environ, "PYTHONIOENCODING": "cp1252"},
        check=False,
    )
    assert (run.returncode, run.stderr) == (0, b"")
    assert b"[my-\\u03bb.py]" in run.stdout


LONG = 300 * "x"
"""A name that no file system takes."""


@pytest.mark.parametrize(
    "asked",
    [
        ["verify", "--list", "-o", LONG],
        ["verify", "eq11", "-o", LONG],
        ["verify", "eq11", f"-o{LONG}"],
        ["verify", "eq11", "--rocq", LONG],
        ["verify", "--derivation", LONG],
        ["verify", "--source", LONG],
        ["verify", f"--source={LONG}"],
        ["export", "linear_limit", "--target", "c", "-o", LONG],
        ["check", "--formula", "eq11", "--python", "math:sin", "-o", LONG],
        ["check", "--formula", "eq11", "--library", f"{LONG}:f"],
        ["check", "--formula", "eq11", "--command", LONG],
        ["trace", "--gamma", "1", "--delta", "1", "--delay", "1", "-o", LONG],
        ["mutants", "-o", LONG],
        ["mutants", "--check", "-o", LONG],
        ["limits", LONG],
        ["limits", LONG, "-o", LONG],
        ["bench", "-o", LONG],
        ["report", "-o", LONG],
        ["report", "-o", LONG, "--check"],
    ],
)
def test_a_name_that_is_too_long_is_one_line(asked, tmp_path):
    run = symhaptic(*asked, cwd=tmp_path)
    assert run.returncode == 2
    [line] = run.stderr.splitlines()
    assert line.startswith("symhaptic: error: ")
    assert LONG in line
    assert list(tmp_path.iterdir()) == []


def test_an_error_that_names_no_argument_is_no_bad_input():
    wrong = OSError(2, "No such file or directory", "/data/of/the/package")
    assert unusable(wrong, ["verify", "-o", "out.txt"]) is None


def test_a_check_of_mutants_without_a_record_says_so_at_once(tmp_path):
    begin = time.monotonic()
    for record in ([], ["-o", "none.json"]):
        run = symhaptic("mutants", "--check", *record, cwd=tmp_path)
        assert run.returncode == 2
        [line] = run.stderr.splitlines()
        assert "--check: there is no record" in line
        assert "write one with `symhaptic mutants -o " in line
    assert time.monotonic() - begin < 200


# -- places that are none ---------------------------------------------------------------------


@pytest.mark.parametrize(
    "asked",
    [
        ["limits", "device.toml", "-o", "LOOP"],
        ["limits", "device.toml", "-oLOOP"],
        ["verify", "--list", "-o", "LOOP"],
        ["verify", "--derivation", "LOOP"],
        ["report", "--derivation=LOOP"],
        ["mutants", "-o", "LOOP"],
        ["check", "--formula", "eq11", "--python", "mine:f", "-o", "LOOP"],
        ["check", "--formula", "eq11", "--library", "LOOP:f"],
    ],
)
def test_links_in_a_circle_are_one_line(asked, tmp_path):
    loop = tmp_path / "loop"
    loop.symlink_to("loop")
    run = symhaptic(*(word.replace("LOOP", str(loop)) for word in asked), cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.count("\n") == 1
    assert str(loop) in run.stderr
    assert "Too many levels of symbolic links" in run.stderr
    assert [path.name for path in tmp_path.iterdir()] == ["loop"]


@pytest.mark.parametrize(
    "asked",
    [
        ["report", "-o", ""],
        ["report", "--format", "tex", "-o", ""],
        ["verify", "eq1", "--rocq", ""],
        ["verify", "eq1", "--rocq="],
        ["verify", "--source", ""],
        ["bench", "-o", ""],
    ],
)
def test_an_empty_place_is_not_the_current_folder(asked, tmp_path):
    """Of ``-o "$OUT"`` without the variable a report filled the folder one stands in."""
    run = symhaptic(*asked, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith("symhaptic: error: -")
    assert run.stderr.endswith(" '': is empty; give a DIR\n")
    assert not list(tmp_path.iterdir())


@pytest.mark.parametrize(
    "asked",
    [["verify", "--rocq", "--help"], ["report", "-o", "--check"], ["verify", "--source", "-h"]],
)
def test_an_option_is_no_place(asked, tmp_path):
    """A folder ``--help`` was filled for 20 minutes."""
    run = symhaptic(*asked, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr == f"symhaptic: error: {' '.join(asked[1:])}: is an option; give a DIR\n"
    assert not list(tmp_path.iterdir())


def closed(streams, *asked):
    """The command, started with some of its streams closed."""
    command = f"{sys.executable} -m symhaptic {' '.join(asked)} {streams}"
    run = subprocess.run(["sh", "-c", command], capture_output=True, text=True, check=False)
    return run.returncode, run.stdout, run.stderr


@pytest.mark.skipif(os.name != "posix", reason="closes streams as a shell does")
def test_a_closed_stream_loses_no_result(tmp_path):
    """Without a standard output the status was 0, without a standard error it was 1."""
    said = "symhaptic: error: standard output: is closed; give it a place\n"
    assert closed(">&-", "jury", "0") == (2, "", said)
    assert closed(">&-", "verify", "eq1") == (2, "", said)
    status, text, _ = closed("2>&-", "verify", "eq1")
    assert (status, text.splitlines()[-1]) == (0, "1 statement: 1 definition")
    assert closed("<&-", "jury", "0")[0] == 0
    assert closed("<&- >&- 2>&-", "jury", "0") == (2, "", "")
    said = "cannot write the result (Bad file descriptor); give another place\n"
    for asked in (["jury", "0"], ["--help"]):
        told = f"symhaptic: error: standard output: {said}"
        assert closed(">&0 </dev/null", *asked) == (2, "", told)


@pytest.mark.parametrize("option", [["--strict"], ["--rocq", "place"], ["--workers", "2"]])
def test_what_has_no_effect_on_a_list_of_statements_is_refused(option, tmp_path):
    run = symhaptic("verify", "--list", *option, cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert f"{' '.join(option)}: has no effect on what --list prints" in run.stderr
    assert not list(tmp_path.iterdir())


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="no folder here that nobody can write")
@pytest.mark.parametrize(
    "asked",
    [
        "verify --derivation mine.py",
        "mutants --derivation mine.py",
        "check --formula eq11 --python mine:f",
    ],
)
def test_a_place_where_nothing_can_be_written_is_refused_before_the_work(asked, tmp_path):
    mine = tmp_path / "mine.py"
    run = f"open({str(tmp_path / 'run')!r}, 'w')"
    mine.write_text(f'"""A title."""\n{run}\n\ndef derive(page): ...\n')
    run = symhaptic(*asked.split(), "-o", "/proc/out", cwd=tmp_path)
    assert (run.returncode, run.stdout) == (2, "")
    assert run.stderr.startswith("symhaptic: error: -o /proc/out: cannot write there (")
    assert list(tmp_path.iterdir()) == [mine]


def test_a_result_may_have_the_longest_name_there_is(tmp_path):
    name = 250 * "x" + ".json"
    assert symhaptic("jury", "0", "-o", name, cwd=tmp_path).returncode == 0
    assert [path.name for path in tmp_path.iterdir()] == [name]


ONE = "--chapter s2a_device"


@pytest.mark.skipif(os.name != "posix", reason="limits a process as a shell does")
@pytest.mark.parametrize(
    ("limit", "asked", "said"),
    [
        (
            "ulimit -n 12",
            "report --chapter s2a_device --standalone --format html -o out",
            "too many",
        ),
        pytest.param("ulimit -n 12", "verify eq11", "", marks=pytest.mark.ci),
        *(
            pytest.param("ulimit -f 2", f"{asked} -o out", "-o out: cannot write", marks=marks)
            for asked, marks in (
                (f"report {ONE} --format tex", []),
                ("export is_stable --target c", pytest.mark.ci),
                ("verify eq11 --format json", pytest.mark.ci),
            )
        ),
    ],
)
def test_where_files_are_few_or_small_it_is_one_line_and_nothing_is_left(
    limit, asked, said, tmp_path
):
    command = f"{limit}; exec {sys.executable} -m symhaptic {asked}"
    run = subprocess.run(
        ["bash", "-c", command], cwd=tmp_path, env=os.environ | {"TMPDIR": str(tmp_path)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert run.returncode == (2 if said else 0), run.stderr
    assert not said or run.stderr.startswith(f"symhaptic: error: {said}")
    assert run.stderr.count("\n") == bool(said)
    assert list(tmp_path.iterdir()) == []
