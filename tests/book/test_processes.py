"""A command that is killed leaves no process, no temporary folder and no draft."""

import os
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
import sys
from symhaptic.book import processes

with processes.folder(), processes.program(
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
        [sys.executable, "-m", "awkward"], env=os.environ | {"PYTHONPATH": str(HOME)}, timeout=20,
        capture_output=True, text=True, check=False, cwd=tmp_path,
    )  # fmt: skip
    assert (done.returncode, done.stderr) == (128 + number, "symhaptic: interrupted\n")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGKILL])
@pytest.mark.parametrize("kind", KINDS)
def test_nothing_is_left(kind, number, tmp_path):
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
    until = time.monotonic() + 60
    begun = here / "begun"
    while len(alive(mark)) < 3 or (kind in ("sweep", "program") and not begun.exists()):
        assert time.monotonic() < until
        assert process.poll() is None, process.stderr.read()
        time.sleep(0.05)
    begin = time.monotonic()
    process.send_signal(number)
    _, said = process.communicate(timeout=60)
    assert "Traceback" not in said or (kind in ("sweep", "program") and number == signal.SIGINT)
    while alive(mark) and time.monotonic() < begin + 8:
        time.sleep(0.05)
    assert alive(mark) == []
    assert os.listdir(tmp_path / "tmp") == []
    assert set(os.listdir(here)) - {"begun"} == before
    if KINDS[kind][0] == "-m" and number != signal.SIGKILL:
        assert said == "symhaptic: interrupted\n"
        assert process.returncode == 128 + number
