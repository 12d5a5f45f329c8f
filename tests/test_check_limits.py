"""Somebody else's code gets so much time, memory and output, and leaves nothing behind."""

import inspect
import os
import re
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
from command import symhaptic

from symhaptic import check
from symhaptic.cli.check import check as check_command

GUIDE = Path(__file__).parents[1] / "docs" / "check.md"

MINE = """
import os, subprocess, sys, time

def asleep(beta, delta, d):
    time.sleep(1000)

def hungry(beta, delta, d):
    return len([0.0] * 10**9)

def chatty(beta, delta, d):
    while True:
        print("x" * 1000)

def started(beta, delta, d):
    child = subprocess.Popen(["sleep", "987654"])
    with open("child", "w") as file:
        print(child.pid, file=file)
    time.sleep(1000)

def slow(beta, delta, d):
    time.sleep(0.02)
    return (beta + delta)/(d + 0.5)

def seldom(beta, delta, d, seen=[]):
    seen.append(0)
    return float("nan") if len(seen) == 9_999 else (beta + delta)/(d + 0.5)

def good(beta, delta, d):
    return (beta + delta)/(d + 0.5)
"""
LIMIT = "check", "--formula", "linear_limit"


@pytest.fixture
def mine(tmp_path):
    (tmp_path / "mine.py").write_text(MINE)
    return tmp_path


def test_without_options_it_has_what_the_guide_says():
    said = re.sub(r"\s+", " ", GUIDE.read_text(encoding="utf-8"))
    given = inspect.signature(check_command).parameters
    for name, unit in (("timeout", "seconds"), ("memory", "GiB")):
        (number,) = re.findall(rf"(\d+) {unit} (?:of|in) [a-z ]*\(`--{name} ", said)
        assert given[name].default == float(number)


def is_alive(pid):
    """Whether a process runs; one that is dead but not waited for does not."""
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except FileNotFoundError:
        return False


@pytest.mark.parametrize(
    ("way", "said"),
    [
        (("--command", "yes"), "--command yes: prints more than 1099776 bytes for 50 points"),
        (("--command", "sh -c 'yes >&2'"), "prints more than 1099776 bytes for 50 points"),
        (("--command", "sleep 1000"), "--command sleep 1000: no end after 2 s; --timeout allows"),
        (("--command", "sh -c 'cat; exit 3'"), "ends with status 3; end with 0"),
        (("--command", "sh -c 'echo no room >&2; exit 1'"), "status 1 (no room); end with 0"),
        (("--command", "cut -c 1-3"), "print numbers, a line for each point"),
        (("--command", "head -n 3"), "print one for each of 50 points"),
        (("--python", "mine:asleep"), "mine:asleep: no answer after 2 s when called with "),
        (("--python", "mine:hungry", "--memory", "1"), "mine:hungry: MemoryError"),
        (("--python", "mine:chatty"), "mine:chatty: OSError: [Errno 27] File too large"),
        (("--library", "stuck.so:f"), "stuck.so:f: no answer after 2 s when called with "),
    ],
)
def test_what_has_no_end_is_ended_with_one_line(mine, way, said):
    if "--library" in way:
        (mine / "stuck.c").write_text("double f(double y, double x, double d) { for (;;) ; }")
        build = ["gcc", "-shared", "-fPIC", "-o", "stuck.so", "stuck.c"]
        subprocess.run(build, cwd=mine, check=True)
    begin = time.monotonic()
    done = symhaptic(*LIMIT, *way, "--timeout", 2, cwd=mine)
    assert done.returncode == 2, done.stdout
    assert said in done.stderr
    assert len(done.stderr.splitlines()) == 1
    assert time.monotonic() - begin < 600


def test_a_device_file_without_an_end_is_not_read_to_the_end():
    done = symhaptic("limits", "/dev/full", timeout=600)
    assert done.returncode == 2
    assert "/dev/full: has more than 1048576 characters" in done.stderr


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT, signal.SIGKILL])
def test_no_process_and_no_folder_is_left(mine, number, tmp_path):
    """The function's process ends with the check, and what it has started unless that is killed."""
    program = [sys.executable, "-m", "symhaptic", *LIMIT, "--python", "mine:started"]
    (kept := tmp_path / "kept").mkdir()
    env = {"PYTHONPATH": str(Path(check.__file__).parents[2]), "TMPDIR": str(kept)}
    process = subprocess.Popen(
        program, cwd=mine, env=os.environ | env, stderr=subprocess.PIPE, text=True
    )
    child = mine / "child"
    for _ in range(6000):
        if child.exists() and child.read_text():
            break
        time.sleep(0.1)
    started = int(child.read_text())
    theirs = int(Path(f"/proc/{started}/stat").read_text().rpartition(")")[2].split()[1])
    assert is_alive(started)
    assert is_alive(theirs)
    process.send_signal(number)
    _, said = process.communicate(timeout=300)
    time.sleep(0.5)
    assert not is_alive(theirs)
    for _ in range(600):
        if not os.listdir(kept):
            break
        time.sleep(0.1)
    assert os.listdir(kept) == []
    if number == signal.SIGKILL:  # nobody is left who could end it
        os.kill(started, signal.SIGKILL)
        return
    assert not is_alive(started)
    assert process.returncode == {signal.SIGTERM: 143, signal.SIGINT: 130}[number]
    assert said in ("", "symhaptic: interrupted\n")


def test_a_slow_function_gets_fewer_points_and_they_are_told(mine):
    """0.02 s a point: some 250 in 5 s."""
    done = symhaptic(*LIMIT, "--python", "mine:slow", cwd=mine)
    assert done.returncode == 0, done.stderr
    points = int(done.stdout.split(": ")[1].split(" points")[0])
    assert 50 <= points < 500
    assert f"not covered: {10_000 - points} of 10000 points: the function is slow" in done.stdout
    done = symhaptic(*LIMIT, "--python", "mine:slow", "--points", 60, cwd=mine)
    assert "linear_limit: 60 points" in done.stdout


def test_nan_at_one_of_ten_thousand_points_fails_the_junit_case(mine):
    done = symhaptic(*LIMIT, "--python", "mine:seldom", "--format", "junit", cwd=mine)
    assert done.returncode == 1, done.stderr
    assert 'tests="1"' in done.stdout
    assert 'failures="1"' in done.stdout
    assert "<failure message=" in done.stdout
    done = symhaptic(*LIMIT, "--python", "mine:good", "--format", "junit", cwd=mine)
    assert done.returncode == 0
    assert 'failures="0"' in done.stdout
    assert "<failure" not in done.stdout
    assert '<property name="ranges" value="{&quot;beta&quot;: [' in done.stdout


def test_ranges_may_be_narrower(mine):
    way = *LIMIT, "--python", "mine:good", "--points", 200
    done = symhaptic(*way, "--over", "d=0:2", "--over", "beta=0:1", cwd=mine)
    assert "covered: beta 0 to 1, delta " in done.stdout
    assert "d 0 to 2\n" in done.stdout
    assert "delays above 100 periods" in done.stdout.split("not covered: ")[1]
    for bad in ("d=2:0", "d=0", "x=0:1", "d=0:inf"):
        done = symhaptic(*way, "--over", bad, cwd=mine)
        assert done.returncode == 2
        assert done.stderr.startswith(f"symhaptic: error: --over: {bad!r} is no range; give NAME=")


def test_what_is_wrong_is_told_though_the_function_ends_at_plainer_arguments(mine):
    """2 is no point that is drawn, and one of the plainer arguments that are tried."""
    (mine / "f.c").write_text(
        "#include <stdlib.h>\n"
        "double f(double y, double x, double d) { if (y == 2) abort(); return y; }"
    )
    build = ["gcc", "-shared", "-fPIC", "-o", "f.so", "f.c"]
    subprocess.run(build, cwd=mine, check=True)
    done = symhaptic(*LIMIT, "--library", "f.so:f", "--points", 100, cwd=mine)
    assert done.returncode == 1, done.stderr
    assert "differs" in done.stdout


def test_a_function_that_reads_gets_nothing(mine):
    (mine / "reads.py").write_text("def f(y, x, d):\n    return float(input())\n")
    done = symhaptic(*LIMIT, "--python", "reads:f", cwd=mine)
    assert done.returncode == 2
    assert "reads:f: EOFError: EOF when reading a line when called with" in done.stderr
