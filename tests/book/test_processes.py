"""A command that is killed leaves no process, no temporary folder and no draft."""

import itertools
import math
import os
import random
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from uuid import uuid4

import pytest

from symhaptic import book

pytestmark = [
    pytest.mark.early,
    pytest.mark.skipif(not Path("/proc/self/environ").exists(), reason="no /proc here"),
]

HOME = Path(book.__file__).parents[2]
GUIDE = Path(__file__).parents[2] / "CONTRIBUTING.md"

SWEEP = """
import sys, time
import numpy as np
from symhaptic import sweep

def slow(alpha):
    if np.ndim(alpha):  # not the one point that is asked for first
        open(sys.argv[1] + "/begun", "a").close()
        time.sleep(1000)
    return alpha

if __name__ == "__main__":
    sweep(slow, alpha=np.arange(4.0), chunks=1, on="processes", workers=2)
"""

DRAWN = """
import sys, tempfile
from symhaptic.book import processes

with processes.temporary(), processes.folder(), tempfile.TemporaryDirectory():
    with processes.program(
        ["sh", "-c", "sleep 98765 & touch $0/begun; sleep 98765", sys.argv[1]]
    ) as program:
        program.communicate()
"""

KINDS = {
    "report": ("-m", "symhaptic", "report", "-o", "made"),
    "verify": ("-m", "symhaptic", "verify", "--workers", "2"),
    "mutants": ("-m", "symhaptic", "mutants", "-o", "mutants.json"),
    "sweep": ("sweep.py", "."),
    "program": ("program.py", "."),
}


def alive(mark):
    """The processes that have this mark among their variables."""
    found = []
    for place in Path("/proc").glob("[0-9]*/environ"):
        try:
            if mark.encode() in place.read_bytes():
                found.append(place.parent.joinpath("cmdline").read_bytes().replace(b"\0", b" "))
        except OSError:
            continue
    return [command for command in found if command]  # what is dead but not waited for has none


AWKWARD = """
import os, signal, time
import symhaptic.__main__ as commands
def end():
    os.kill(os.getpid(), {number})
    time.sleep(0.01)
class Held:
    def __del__(self):
        end()
import symhaptic.cli.main
def finaliser():
    Held()
    time.sleep(30)
def text():
    exec("end()")
symhaptic.cli.main.main = {place}
commands.main()
"""


@pytest.mark.parametrize("place", ["finaliser", "text"])
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_signal_that_comes_at_an_awkward_place_ends_the_command(number, place, tmp_path):
    """Python ignores what a finaliser raises, and remembers what is raised in `exec`."""
    (tmp_path / "awkward.py").write_text(AWKWARD.format(number=int(number), place=place))
    done = subprocess.run(
        [sys.executable, "-m", "awkward"], env=os.environ | {"PYTHONPATH": str(HOME)}, timeout=200,
        capture_output=True, text=True, check=False, cwd=tmp_path,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (128 + number, "symhaptic: interrupted\n")


KILLED = signal.SIGTERM, signal.SIGINT, signal.SIGKILL
QUICK = {
    ("report", signal.SIGTERM),
    ("verify", signal.SIGINT),
    ("mutants", signal.SIGTERM),
    ("sweep", signal.SIGTERM),
    ("sweep", signal.SIGKILL),
    ("program", signal.SIGKILL),
}


@pytest.mark.parametrize(
    ("kind", "number"),
    [
        pytest.param(*pair, marks=[] if pair in QUICK else pytest.mark.ci)
        for pair in itertools.product(KINDS, KILLED)
    ],
)
def test_nothing_is_left(kind, number, tmp_path, request):
    if kind in ("sweep", "mutants"):
        pytest.importorskip("xarray", reason="no xarray here: no sweeps")
    mark, here = f"symhaptic-{uuid4()}", tmp_path / "here"
    for folder in (here, tmp_path / "tmp"):
        folder.mkdir()
    (here / "sweep.py").write_text(SWEEP)
    (here / "program.py").write_text(DRAWN)
    before = set(os.listdir(here))
    variables = {"PYTHONPATH": str(HOME), "TMPDIR": str(tmp_path / "tmp"), "MARK": mark}
    process = subprocess.Popen(
        [sys.executable, *KINDS[kind]],
        cwd=here,
        env=os.environ | variables,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
    )
    request.addfinalizer(process.kill)
    until = time.monotonic() + 600
    begun = here / "begun"
    while len(alive(mark)) < 3 or (kind in ("sweep", "program") and not begun.exists()):
        assert time.monotonic() < until
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.05)
    begin = time.monotonic()
    process.send_signal(number)
    _, said = process.communicate(timeout=600)
    assert "Traceback" not in said or (kind in ("sweep", "program") and number == signal.SIGINT)
    while alive(mark) and time.monotonic() < begin + 60:
        time.sleep(0.05)
    assert alive(mark) == []
    assert os.listdir(tmp_path / "tmp") == []
    assert set(os.listdir(here)) - {"begun"} == before
    if KINDS[kind][0] == "-m" and number != signal.SIGKILL:
        assert said == "symhaptic: interrupted\n"
        assert process.returncode == 128 + number


TRIED = """
import os, pathlib, signal
from symhaptic.cli.shared import folder_allowed
make = pathlib.Path.mkdir
def mkdir(folder, *given, **named):
    make(folder, *given, **named)
    if folder.name.startswith({name!r}):
        os.kill(os.getpid(), signal.SIGKILL)
pathlib.Path.mkdir = mkdir
folder_allowed(pathlib.Path("one/two"))
"""


@pytest.mark.parametrize("name", ["one", "two", "symhaptic-"])
def test_where_a_folder_is_tried_no_kill_leaves_a_part_of_it(name, tmp_path):
    mark = f"symhaptic-{uuid4()}"
    variables = {"PYTHONPATH": str(HOME), "MARK": mark}
    done = subprocess.run(
        [sys.executable, "-c", TRIED.format(name=name)],
        cwd=tmp_path, env=os.environ | variables, timeout=200, check=False,
    )  # fmt: skip
    assert done.returncode == -signal.SIGKILL
    until = time.monotonic() + 60
    while alive(mark) and time.monotonic() < until:
        time.sleep(0.05)
    assert os.listdir(tmp_path) == []


MINE = """
import sys, time
for line in sys.stdin:
    beta, delta, d = map(float.fromhex, line.split())
    print((beta + delta)/(d + 0.5), flush=True)
"""

DEVICE = 'mass = "72 g"\ndamping = "5 Ns/m"\nsampling_period = "1 ms"\ndelay = "1 ms"\n'

STORED = """
import numpy as np
from symhaptic import sweep

if __name__ == "__main__":
    given = {"beta": np.linspace(0.1, 1.0, 400), "gamma": 0.0, "delta": 0.0, "delay": 1}
    sweep("is_stable", alpha=np.linspace(0.1, 1.0, 400), **given, chunks=100, to="stable.zarr",
          on="processes", workers=2)
"""

LONG = {
    "report": "-m symhaptic report --chapter s2a_device --standalone --format pdf -o made",
    "site": "-m symhaptic report --source notes --standalone --format html -o made",
    "verify": "-m symhaptic verify eq5 eq11 eq12 --workers 2 -o verdicts.txt",
    "mutants": "-m symhaptic mutants --source notes -o mutants.json",
    "sweep": "stored.py",
    "bench": "-m symhaptic bench --quick -o bench",
    "check": "-m symhaptic check --formula linear_limit --command 'python3 mine.py' -o checked",
    "limits": "-m symhaptic limits device.toml -o walls.svg",
    "export": "-m symhaptic export is_stable max_stable_stiffness --target c -o made",
}
"""Commands that take a second or more, each of which writes a result."""

INTERRUPTED = "symhaptic: interrupted\n"
VARY = {"bench", "check"}
"""Commands that print how long they took."""

KILLS = int(os.environ.get("SYMHAPTIC_KILLS", "3"))
"""How often each of them is killed at a random moment, by each signal in turn."""


def contents(folder):
    """All files of a folder with what they hold, and the folders in it."""
    return {
        str(path.relative_to(folder)): path.read_bytes() if path.is_file() else None
        for path in folder.rglob("*")
        if "__pycache__" not in path.parts
    }


@pytest.fixture
def used(tmp_path):
    """A folder with what the commands read, beside an empty one for what is temporary."""
    here = tmp_path / "here"
    for folder in (here, tmp_path / "tmp", here / "notes"):
        folder.mkdir()
    blocks = re.findall(r"```python\n(.*?)```", GUIDE.read_text(encoding="utf-8"), re.DOTALL)
    first = next(i for i, block in enumerate(blocks) if block.startswith("# source.py"))
    texts = {"mine.py": MINE, "device.toml": DEVICE, "stored.py": STORED}
    texts |= {"notes/source.py": blocks[first], "notes/drift.py": blocks[first + 1]}
    for name, text in texts.items():
        (here / name).write_text(text, encoding="utf-8")
    return here


@pytest.mark.slow
@pytest.mark.parametrize("kind", LONG)
def test_nothing_is_lost_or_left_at_any_moment(kind, used, request):
    """After a kill each file is as it was before, or as a whole run writes it.

    Half of the kills come over the results of a whole run, half where nothing is yet.
    """
    mark, temporary = f"symhaptic-{uuid4()}", used.parent / "tmp"
    variables = os.environ | {"PYTHONPATH": str(HOME), "TMPDIR": str(temporary), "MARK": mark}
    command = [sys.executable, *shlex.split(LONG[kind])]

    def begun():
        return subprocess.Popen(
            command, cwd=used, env=variables, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
            text=True,
        )  # fmt: skip

    def cleared():
        made = [used / name for name in contents(used).keys() - given.keys()]
        for path in sorted(made, reverse=True):  # a folder after what is in it
            if path.is_file():
                path.unlink()
            else:
                path.rmdir()

    given, took = contents(used), math.inf
    for _ in range(2):  # the first run finds no compiled modules, and takes longer
        cleared()
        begin = time.monotonic()
        with begun() as process:
            said = process.stderr.read()
        assert process.returncode == 0, said
        took = min(took, time.monotonic() - begin)
    whole, arrived = contents(used), 0
    shutil.copytree(used, used.parent / "whole")
    chance = random.Random(kind)
    for i in range(KILLS):
        number = (signal.SIGTERM, signal.SIGKILL, signal.SIGINT)[i % 3]
        moment = chance.uniform(0, took)
        cleared()
        if chance.random() < 0.5:
            shutil.copytree(used.parent / "whole", used, dirs_exist_ok=True)
        before = contents(used)
        process = begun()
        request.addfinalizer(process.kill)
        time.sleep(moment)
        process.send_signal(number)
        _, said = process.communicate(timeout=600)
        arrived += process.returncode != 0  # else it had ended before
        until = time.monotonic() + 60
        while alive(mark) and time.monotonic() < until:
            time.sleep(0.05)
        what = f"kill {i} of {kind} by {number.name} after {moment:.3f} of {took:.1f} s\n{said}"
        if kind != "sweep" or number != signal.SIGINT:  # else where Python itself begins
            assert "Traceback" not in said or ", in main\n" not in said, what
        assert alive(mark) == [], what
        assert os.listdir(temporary) == [], what
        found = contents(used)
        assert before.keys() <= found.keys(), what
        if kind != "sweep":
            assert found.keys() <= whole.keys(), what
            folders = [path for path in used.rglob("*") if path.is_dir()]
            assert all(any(folder.iterdir()) for folder in folders), what
            if process.returncode > 0:  # less than 0 where Python itself begins or ends
                assert "Traceback" in said or process.returncode == 128 + number, what
                assert said == "" or said.endswith(INTERRUPTED) or "Traceback" in said, what
        if kind not in ("sweep", *VARY):
            assert all(found[name] == whole[name] for name in found), what
    assert arrived > KILLS / (4 if kind == "sweep" else 2)  # one that is whole ends at once
    with begun() as process:  # a sweep goes on, all others begin anew
        said = process.stderr.read()
    assert process.returncode == 0, said
    found = contents(used)
    assert found.keys() == whole.keys()
    assert kind in VARY or found == whole
