"""`symhaptic trace`: what it writes is the region, and a bad input writes nothing."""

import csv
import io
import json

import numpy as np
import pytest
from command import symhaptic
from scipy.signal import cont2discrete


def trace(*arguments):
    return symhaptic("trace", *arguments, text=False)


def radius(alpha, beta, gamma, delta, d):
    """Spectral radius from SciPy's zero-order hold."""
    top, bottom, _ = cont2discrete(([1.0], [1.0, delta, gamma]), 1.0, method="zoh")
    p = np.concatenate([bottom, np.zeros(d + 1)])
    p[-3:] += np.convolve(top[0][1:], [alpha + beta, -beta])
    return np.abs(np.roots(p)).max()


PLANT = ("--gamma", 0.001, "--delta", 0.02, "--delay", 1)


def test_csv_is_a_closed_ring_of_walls_with_a_root_on_the_circle():
    run = trace(*PLANT)
    assert run.returncode == 0, run.stderr
    rows = list(csv.DictReader(io.StringIO(run.stdout.decode())))
    ring = np.array([[float(r["alpha"]), float(r["beta"])] for r in rows])
    assert (ring[0] == ring[-1]).all()
    assert len(ring) > 100
    # the coefficients of the zero-order hold near its double pole cost SciPy some 1e-9
    for alpha, beta in ring[:: len(ring) // 40]:
        assert abs(radius(alpha, beta, 0.001, 0.02, 1) - 1) < 1e-6


def test_json_says_what_is_known_of_the_region():
    run = trace("--gamma", 5, "--delta", 0.02, "--delay", 1, "--format", "json")
    known = json.loads(run.stdout)
    assert known["touches_left_bound"] is False
    assert len(known["corners"]) == 1
    # Green's theorem on the outline, by hand
    ring = np.array(known["outline"][0])
    x, y = ring[:-1].T
    area = abs(np.sum(x * ring[1:, 1] - ring[1:, 0] * y)) / 2
    assert area == pytest.approx(known["area"], rel=1e-12)
    top = known["max_stiffness"]
    assert radius(top["alpha"], top["beta"], 5, 0.02, 1) == pytest.approx(1, abs=1e-9)
    assert radius(top["alpha"] + 1e-3, top["beta"], 5, 0.02, 1) > 1


@pytest.mark.parametrize(
    ("format", "head"), [("png", b"\x89PNG"), ("svg", b"<?xml"), ("pdf", b"%PDF")]
)
def test_a_picture_is_the_same_from_run_to_run(format, head, tmp_path):
    files = [tmp_path / f"{i}.{format}" for i in range(2)]
    for file in files:
        run = trace(*PLANT, "--format", format, "-o", file)
        assert run.returncode == 0, run.stderr
    one, two = (file.read_bytes() for file in files)
    assert one.startswith(head)
    assert one == two


@pytest.mark.parametrize(
    ("name", "head"),
    [
        ("x.png", b"\x89PNG"),
        ("x.SVG", b"<?xml"),
        ("x.pdf", b"%PDF"),
        ("x.json", b"{"),
        ("x.csv", b"ring"),
        ("x", b"ring"),
    ],
)
def test_the_ending_of_the_file_names_the_format(name, head, tmp_path):
    run = trace(*PLANT, "-o", tmp_path / name)
    assert run.returncode == 0, run.stderr
    assert (tmp_path / name).read_bytes().startswith(head)


@pytest.mark.parametrize(
    ("arguments", "says"),
    [
        (("--gamma", -1, "--delta", 0, "--delay", 0), ("--gamma", "-1.0", "gamma >= 0")),
        (("--gamma", 0, "--delta", "nan", "--delay", 0), ("--delta", "nan", "delta >= 0")),
        (("--gamma", 0, "--delta", 0, "--delay", "inf"), ("--delay", "inf", "delay >= 0")),
        (("--gamma", "x", "--delta", 0, "--delay", 0), ("--gamma", "'x'", "number")),
        (("--gamma", 0, "--delta", 0), ("--delay",)),
        ((*PLANT, "--format", "png"), ("--format png", "-o FILE")),
        ((*PLANT, "--format", "gif"), ("--format", "gif", "csv")),
        ((*PLANT, "--format", "csv", "-o", "x.png"), ("-o x.png", "--format csv", ".csv")),
        ((*PLANT, "--format", "png", "-o", "x.pdf"), ("-o x.pdf", "--format png", ".png")),
        ((*PLANT, "-o", "x.gif"), ("-o x.gif", ".csv, .json, .png, .svg, .pdf")),
        ((*PLANT, "-o", "no/such/folder/x.csv"), ("-o no/such/folder/x.csv", "folder")),
    ],
)
def test_bad_input_gives_one_line(arguments, says):
    run = trace(*arguments)
    error = run.stderr.decode()
    assert run.returncode == 2
    assert run.stdout == b""
    assert error.count("\n") == 1
    assert all(part in error for part in says), error
