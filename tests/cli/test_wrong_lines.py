"""Wrong command lines: one line, exit status 2, and nothing is printed or written.

Each option gets values that it cannot have, beside what the command otherwise needs.
"""

import sys

import pytest

from symhaptic.cli.main import main

NUMBERS = (
    "",
    " ",
    "one",
    "1,5",
    "0x10",
    "nan",
    "inf",
    "-inf",
    "1e999",
    "--",
    "١٢x",
    "1 2",
    "\x1b[31m",
)
COUNTS = "", "0", "-1", "1.5", "two", "1e3", "nan"
WORDS = "", " ", "nothing", "ALL", "eq0", "eq11,eq12", "../eq11", "\x1b[2J", "é" * 400, "-"
FILES = "", "missing/out", "folder", "device.toml/out", "/dev/null/out", "/proc/out", "x" * 300
FOLDERS = "", "device.toml", "device.toml/out", "/dev/null/out", "/proc/out", "x" * 300
READ = "", "missing", "folder", "device.toml/x", "binary", "/proc/self/mem", "y" * 300, "\udce4"

LINES = {
    "verify --format": WORDS,
    "verify -o": FILES,
    "verify eq1 -o": FILES,
    "verify --workers": COUNTS,
    "verify --derivation": (*READ, "device.toml", "empty.py"),
    "verify --source": (*READ, "device.toml"),
    "verify --rocq": FOLDERS,
    "verify": (*WORDS[2:9], "--stric", "--Strict", "-x", "--list --strict", "--as-recorded"),
    "verify --source folder": ("--list", "--derivation empty.py", "--as-recorded"),
    "report --format": WORDS,
    "report --format tex -o": FOLDERS,
    "report --chapter": WORDS,
    "report --derivation": READ,
    "report --source": READ,
    "report": ("eq11", "--standalone", "--list --check", "--format html --check", "--list -o x"),
    "export": (*WORDS[2:9], "--whole", "-t", "eq11 eq11 eq999"),
    "export eq11 -o": FOLDERS,
    "export eq11 --target": WORDS,
    "export eq11 --scene": (*WORDS[2:9], "no-stiffness,no-stifness", ",,", "no-mass"),
    "export eq11 --target c --precision": (*WORDS, "half", "DOUBLE"),
    "export is_stable --delay": ("", "one", "nan", "-1", "1e9", "0.5x"),
    "export eq11 --derivative": (*WORDS[2:9], "alpha,", "theta"),
    "export eq11 --target c --name": ("", " ", "1st", "a-b", "for", "ä", "a b", "n" * 400),
    "check --formula": WORDS,
    "check --formula eq11 --python": (*WORDS[1:9], "math", "math:", ":sin", "math:nope", "os:sep"),
    "check --formula eq11 --library": (*READ[1:7], "device.toml:f", "missing.so:f", ":f"),
    "check --formula eq11 --command": ("", " ", "missing-program", "'", "./folder"),
    "check --formula eq11 --python math:sin --ulp": (*NUMBERS[2:6], "nan", "inf", "-1"),
    "check --formula eq11 --python math:sin --points": (*COUNTS, "1000001"),
    "check --formula eq11 --python math:sin --over": (*WORDS, "d=1", "d=2:1", "x=0:1", "d=a:b"),
    "check --formula eq11 --python math:sin --timeout": (*COUNTS[:3], "nan", "inf", "1e7"),
    "check --formula eq11 --python math:sin --memory": (*COUNTS[:3], "nan", "inf", "1e7"),
    "check --formula eq11 --python math:sin --arguments": (*WORDS, "d,d,d", "d,b", "d,b,T,m"),
    "check --formula eq11 --python math:sin --format": WORDS,
    "check --formula eq11 --python math:sin -o": FILES,
    "check": ("", "eq11", "--formula eq11", "--python math:sin", "--list --formula eq11"),
    "trace --delta 1 --delay 1 --gamma": (*NUMBERS, "-1", "1/0"),
    "trace --gamma 1 --delay 1 --delta": (*NUMBERS, "-1", "1/0"),
    "trace --gamma 1 --delta 1 --delay": (*NUMBERS, "-1", "1/0"),
    "trace --gamma 1 --delta 1 --delay 1 --format": WORDS,
    "trace --gamma 1 --delta 1 --delay 1 -o": (*FILES, "out.txt", "out.csv.gz"),
    "trace --gamma 1": ("", "--delta 1", "--delay 1", "--gamma 2"),
    "limits": (*READ, "empty.py", "device.toml more.toml", "device.toml --formt json"),
    "limits device.toml --format": WORDS,
    "limits device.toml -o": (*FILES, "device.toml", "out.doc", "out"),
    "jury": (*NUMBERS[2:], "-1", "1.5", "1 2", "1000000"),
    "jury 1 --gamma": (*NUMBERS, "1", "-1 --delta 1"),
    "jury 1 --gamma 1 --delta": (*NUMBERS, "-1"),
    "jury 1 --format": WORDS,
    "jury 1 -o": FILES,
    "bench -o": FOLDERS,
    "bench": ("eq11", "--fast", "--quick=1", "-o a -o b"),
    "mutants -o": (*FILES, "device.toml"),
    "mutants --workers": COUNTS,
    "mutants --derivation": (*READ, "empty.py"),
    "mutants --source": READ,
    "mutants": ("eq11", "--check", "--check -o missing.json", "--source folder --derivation a.py"),
    "kernels": ("eq11", "--list", "-o out"),
    "": ("nothing", "--nothing", "-v", "VERIFY", "verify report eq1", "--version=1"),
}


def words():
    """The lines, word by word."""
    for lead, values in LINES.items():
        for value in values:
            whole = lead and lead.split()[-1].startswith("-")
            yield [*lead.split(), value] if whole else [*lead.split(), *value.split()]


def shown(case):
    return " ".join(case)[:60].encode("unicode_escape").decode()


CASES = [pytest.param(case, id=shown(case)) for case in words()]


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "folder").mkdir()
    (tmp_path / "empty.py").write_text("")
    (tmp_path / "binary").write_bytes(bytes(range(256)))
    (tmp_path / "device.toml").write_text(
        'mass = "72 g"\ndamping = "5 Ns/m"\nsampling_period = "1 ms"\ndelay = "1 ms"\n'
    )
    return tmp_path


@pytest.mark.ci  # 520 lines; test_places.py and others have those that were once accepted
@pytest.mark.parametrize("case", CASES)
def test_a_wrong_line_is_refused_in_one_line(case, here, monkeypatch, capfd):
    before = sorted(here.rglob("*"))
    monkeypatch.setattr(sys, "argv", ["symhaptic", *case])
    with pytest.raises(SystemExit) as left:
        main()
    out, err = capfd.readouterr()
    assert (left.value.code, out) == (2, ""), err
    assert err.startswith("symhaptic: error: ")
    assert err.count("\n") == 1
    assert err[:-1].isprintable()
    assert sorted(here.rglob("*")) == before
