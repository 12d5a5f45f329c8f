"""Each mistake that was found in other people's code is caught and named."""

import math
import subprocess
import sys

import pytest
from command import symhaptic

from symhaptic.check.plugin import Agreement

MINE = """
from math import cos, exp, pi, sin, tan
import cmath
import numpy as np

def right(b, T, d):
    return 2*b/T*tan(pi/(4*(d + 1))), b*(sin(pi*d/(2*(d + 1))) - d/(d + 1))/sin(pi/(2*(d + 1)))

def ordered(d, T, b):
    return right(b, T, d)

def swapped(b, T, d):
    n = pi/(2*(d + 1))
    return 2*b*(1 - sin(n))/(T*sin(d*n)), b*(cos(d*n) - d/(d + 1))/cos(n)

def single(b, T, d):
    return tuple(float(np.float32(x)) for x in right(b, T, d))

def late(b, k, m, T, factor):
    root = cmath.sqrt(b*b - 4*k*m)
    c1 = root*T/m
    c2, c3 = cmath.exp(-b*T/(2*m) - c1/2), cmath.exp(-b*T/(2*m) + c1/2)
    e, inside = exp(-b*T/m), b*b - 4*k*m
    odd, below = factor*b*c1*(c3 - c2), -2*k*inside
    return (((odd + inside*(c2 + c3 - 2))/below).real,
            ((-odd + inside*(c2 + c3 - 2*e))/below).real, (c2 + c3).real, e)

def misprint(b, k, m, T):
    return late(b, k, m, T, 1)

def printed(gamma, delta):
    return late(delta, gamma, 1, 1, 1)

def four(alpha, beta, gamma, delta, d):
    return alpha < 4
"""


@pytest.fixture
def mine(tmp_path):
    (tmp_path / "mine.py").write_text(MINE)
    return tmp_path


def checked(folder, formula, name, *options):
    way = "--points", 3000, "--formula", formula, "--python", f"mine:{name}"
    return symhaptic("check", *way, *options, cwd=folder)


@pytest.mark.parametrize(
    ("formula", "name", "said"),
    [
        ("eq11", "swapped", "sine and cosine are swapped"),
        ("eq11", "single", "single precision"),
        ("eq12", "misprint", "this is (12) as printed"),
        ("eq14", "printed", "0/0 for k = 0 or critical damping"),
        ("is_stable", "four", "rules:four-masses"),
    ],
)
def test_a_mistake_is_caught_and_named(mine, formula, name, said):
    done = checked(mine, formula, name, "--github")
    assert done.returncode == 1, done.stderr
    assert done.stdout.startswith("::error ")
    assert said in done.stdout
    assert "0x" in done.stdout


def test_a_right_function_agrees(mine):
    done = checked(mine, "eq11", "right")
    assert done.returncode == 0, done.stdout + done.stderr


def test_the_order_of_arguments_is_the_callers(mine):
    assert checked(mine, "eq11", "ordered", "--arguments", "d,T,b").returncode == 0
    assert checked(mine, "eq11", "ordered").returncode == 1


def test_a_library_in_c(tmp_path):
    (tmp_path / "f.c").write_text("double f(double y, double x, double d){return (y+x)/(d+.5);}")
    build = ["gcc", "-shared", "-fPIC", "-o", "f.so", "f.c"]
    subprocess.run(build, cwd=tmp_path, check=True)
    way = "check", "--formula", "linear_limit", "--library"
    assert symhaptic(*way, "f.so:f", cwd=tmp_path).returncode == 0
    assert symhaptic(*way, "f.so:g", cwd=tmp_path).returncode == 2


def test_a_command(tmp_path):
    program = "print((y+x)/(d+.5))"
    (tmp_path / "f.py").write_text(
        "import sys\nfor line in sys.stdin:\n"
        f"    y, x, d = map(float.fromhex, line.split())\n    {program}\n"
    )
    way = "check", "--formula", "linear_limit", "--command"
    assert symhaptic(*way, "python3 f.py", cwd=tmp_path).returncode == 0
    done = symhaptic(*way, "true", cwd=tmp_path)
    assert done.returncode == 2
    assert len(done.stderr.splitlines()) == 1


def test_bad_usage_is_one_line(mine):
    for options in (("eq99", "right"), ("eq11", "none")):
        done = checked(mine, *options)
        assert done.returncode == 2
        assert len(done.stderr.splitlines()) == 1


def test_the_plugin_loads_nothing_symbolic():
    code = "import sys, symhaptic.check.plugin as p; print({'sympy', 'flint'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


def test_the_plugin_passes_and_fails_a_test():
    eq25 = Agreement("linear_limit")
    eq25.agrees(lambda beta, delta, d: (beta + delta) / (d + 0.5), over={"d": (0, 2)}, points=500)
    with pytest.raises(pytest.fail.Exception, match="0x"):
        eq25.agrees(lambda beta, delta, d: (beta + delta) / (d + 1), points=500)
    with pytest.raises(ValueError, match="over: 'b'"):
        eq25.agrees(lambda beta, delta, d: 0.0, over={"b": (0, 1)})
    with pytest.raises(ValueError, match="id: 'eq99'"):
        Agreement("eq99")


def test_a_table_of_exact_values():
    """Without delay (11) is K = 2b/T tan(pi/4) = 2b/T, so 100000 for b = 50, T = 0.001."""
    done = symhaptic("check", "--formula", "eq11", "--table", "--points", 200)
    head, *rows = [line.split(",") for line in done.stdout.splitlines()]
    assert head == ["b", "T", "d", "K", "B"]
    assert len(rows) == 200
    wanted = [(50.0).hex(), (0.001).hex(), (0.0).hex()]
    (found,) = [row for row in rows if row[:3] == wanted]
    assert abs(float(found[3]) - 100000) < 1e-9


def test_a_function_may_give_the_first_of_several_results():
    from symhaptic.check.callers import called
    from symhaptic.check.compare import compared
    from symhaptic.check.formulas import CHECKED

    def stiffness(b, T, d):  # (11) of the paper
        return 2 * b / T * math.tan(math.pi / (4 * (d + 1)))

    found = compared(CHECKED["eq11"], called(stiffness, 2), 8, 500)
    assert found.worst < 8
    assert found.missing == 0
    with pytest.raises(ValueError, match="3 numbers; K, B are"):
        compared(CHECKED["eq11"], called(lambda b, T, d: (b, T, d), 2), 8, 50)
