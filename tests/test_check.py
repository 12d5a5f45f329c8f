"""Each mistake that was found in other people's code is caught and named."""

import json
import math
import re
import subprocess
import sys
from dataclasses import replace
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from command import symhaptic

from symhaptic import __all__ as symhaptic_names
from symhaptic import is_stable, max_passive_stiffness
from symhaptic.check import callers, report
from symhaptic.check.compare import compared, plainest
from symhaptic.check.formulas import CHECKED
from symhaptic.check.mistakes import factor
from symhaptic.check.plugin import Agreement
from symhaptic.check.points import drawn
from symhaptic.cli.main import main

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

def crossed(gamma, delta):
    n1, n0, a, e = late(delta, gamma, 1, 1, 1)
    return n0, n1 + n0, a, e

def four(alpha, beta, gamma, delta, d):
    return alpha < 4

def stiff(m, b, k, T, d):
    return 4*m/T**2

def slip(beta, delta, d):
    return (delta - beta)/(d + 0.5)

def later(b, T, d):
    return 2*b/T*tan(pi/(4*(d + 2)))

def given(b, T, d):
    return right(b, T, d)[::-1]
"""


@pytest.fixture
def mine(tmp_path):
    (tmp_path / "mine.py").write_text(MINE)
    return tmp_path


def checked(folder, formula, name, *options):
    place = name if ":" in name else f"mine:{name}"
    way = "--points", 1000, "--formula", formula, "--python", place
    return symhaptic("check", *way, *options, cwd=folder)


def test_nan_of_the_print_explains_no_other_numbers(mine):
    """Undefined where (14) is, and something else where it is defined."""
    said = checked(mine, "eq14", "crossed").stdout
    assert "0/0" in said
    assert "where it is a number it is wrong, too" in said
    assert "wrong, too" not in checked(mine, "eq14", "printed").stdout


@pytest.mark.parametrize(
    ("formula", "name", "said"),
    [
        ("eq11", "swapped", "this is (11) with sine and cosine swapped"),
        ("eq11", "single", "single precision: "),
        ("eq11", "given", "results are given in the order B, K"),
        ("eq11", "ordered", "arguments are taken in another order; --arguments d,T,b"),
        ("eq12", "misprint", "this is (12) as published; see the erratum of eq12"),
        ("eq14", "printed", "0/0 where (14) as published is 0/0"),
        ("is_stable", "four", "four masses over the squared period is stable; see rules:four-mas"),
        ("scene.max_stable_stiffness", "stiff", "see rules:four-masses"),
        ("eq11", "later", "this is (11) with d + 1 for d"),
        ("linear_limit", "slip", "this is (25) with a slip: sign of beta"),
    ],
)
def test_a_mistake_is_caught_and_named(mine, formula, name, said):
    done = checked(mine, formula, name, "--format", "github")
    assert done.returncode == 1, done.stderr
    assert done.stdout.startswith("::error file=mine.py,line=")
    assert len(done.stdout.splitlines()) == 1
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


def test_a_library_that_ends_the_program(tmp_path):
    """What ended the program without saying so had agreed: ``exit(0)`` is the status of a pass."""
    (tmp_path / "f.c").write_text(
        "#include <stdio.h>\n#include <stdlib.h>\n"
        "double leaves(double y, double x, double d){if(d>0)exit(0);return (y+x)/(d+.5);}"
        "double fails(double y, double x, double d){abort();}"
        'double says(double y, double x, double d){puts("here");return (y+x)/(d+.5);}'
        "void late(void){_Exit(3);}"
        "double last(double y, double x, double d){atexit(late);return (y+x)/(d+.5);}"
        "void two(double b, double T, double d, double *K, double *B){if(d>0)exit(0);*K=*B=0;}"
    )
    (tmp_path / "g.c").write_text(
        "#include <stdlib.h>\n__attribute__((constructor)) void f(void){exit(0);}"
    )
    for one in "fg":
        build = ["gcc", "-shared", "-fPIC", "-o", f"{one}.so", f"{one}.c"]
        subprocess.run(build, cwd=tmp_path, check=True)
    way = "check", "--points", 500, "--formula"
    for formula, name, said in (
        (
            "linear_limit",
            "f.so:leaves",
            r"ends the program \(0\) when called with .*, [1-9][\d.]*\b",
        ),
        ("linear_limit", "f.so:fails", r"ends the program \(-6\) when called with .*"),
        ("linear_limit", "f.so:last", r"ends the program \(3\) at last"),
        ("linear_limit", "g.so:f", r"ends the program \(0\) when it is loaded"),
        ("eq11", "f.so:two", r"ends the program \(0\) when called with .*"),
    ):
        done = symhaptic(*way, formula, "--library", name, cwd=tmp_path)
        assert done.returncode == 2, done.stdout
        assert re.search(said, done.stderr), done.stderr
        assert len(done.stderr.splitlines()) == 1
    done = symhaptic(*way, "linear_limit", "--library", "f.so:says", cwd=tmp_path)
    assert done.returncode == 0
    assert "here" not in done.stdout


def test_a_command(tmp_path):
    program = "print((y+x)/(d+.5))"
    (tmp_path / "f.py").write_text(
        "import sys\nfor line in sys.stdin:\n"
        f"    y, x, d = map(float.fromhex, line.split())\n    {program}\n"
    )
    way = "check", "--formula", "linear_limit", "--command"
    assert symhaptic(*way, "python3 f.py", cwd=tmp_path).returncode == 0
    for line in ("true", "", " ", "python3 'f.py"):
        done = symhaptic(*way, line, cwd=tmp_path)
        assert done.returncode == 2
        assert done.stderr.startswith(f"symhaptic: error: --command {line.strip()}: ")
        assert len(done.stderr.splitlines()) == 1


@pytest.mark.parametrize(
    "way",
    [("--python", "f:f"), ("--command", "python3 f.py"), ("--library", "f.py:f")],
)
def test_what_is_checked_is_not_written_over(tmp_path, way):
    text = "def f(beta, delta, d):\n    return (beta + delta)/(d + 0.5)\n"
    (tmp_path / "f.py").write_text(text)
    (tmp_path / "f.txt").symlink_to("f.py")
    for name in ("f.py", "f.txt"):
        done = symhaptic(
            "check", "--formula", "linear_limit", "--points", 5, *way, "-o", name, cwd=tmp_path
        )
        assert done.returncode == 2
        said = f"symhaptic: error: -o {name}: this file is read here; give another one\n"
        assert done.stderr == said
        assert (tmp_path / "f.py").read_text() == text


BAD = """
def nothing(b, T, d):
    return None

def unknown(b, T, d):
    return nowhere

def one_of_two(b, T, d):
    return {0.0: 1.0}[d] if b else (0.0, 0.0)

def two(b, T):
    return b
"""


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (
            "mine:none",
            "--python mine:none: module 'mine' has no attribute 'none' (expected MODULE:NAME)",
        ),
        (
            "./mine.py:right",
            "--python ./mine.py:right: no module and name; give MODULE:NAME, such as mine:right",
        ),
        (
            "mine.py:right",
            "--python mine.py:right: no module and name; give MODULE:NAME, such as mine:right",
        ),
        (":right", "--python :right: no module and name; give MODULE:NAME"),
        ("broken:f", "--python broken:f: SyntaxError: "),
        ("ending:f", "--python ending:f: ends the program (3) when it is imported"),
        ("mine:nothing", "gives None and no numbers when called with"),
        ("mine:unknown", "NameError: name 'nowhere' is not defined when called with"),
        ("mine:one_of_two", "KeyError: "),
        ("mine:two", "TypeError: two() takes 2 positional arguments but 3 were given when called"),
    ],
)
def test_a_function_that_cannot_be_used_is_one_line(mine, name, said):
    (mine / "mine.py").write_text(MINE + BAD)
    (mine / "broken.py").write_text("def f(\n")
    (mine / "ending.py").write_text("raise SystemExit(3)")
    done = symhaptic("check", "--formula", "eq11", "--python", name, cwd=mine)
    assert done.returncode == 2
    assert said in done.stderr
    assert len(done.stderr.splitlines()) == 1


def test_bad_usage_is_one_line(mine):
    asked = (("--formula", "eq99"), (), ("--formula", "eq11", "--points", "1000000000000"))
    for options in asked:
        done = symhaptic("check", *options, "--python", "mine:right", cwd=mine)
        assert done.returncode == 2
        assert len(done.stderr.splitlines()) == 1


def test_the_plugin_loads_nothing_symbolic():
    code = "import sys, symhaptic.check.plugin as p; print({'sympy', 'flint'} & set(sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "set()"


def test_the_plugin_passes_and_fails_a_test():
    eq25 = Agreement("linear_limit")
    eq25.agrees(lambda beta, delta, d: (beta + delta) / (d + 0.5), over={"d": (0, 2)}, points=1)
    eq25.agrees(lambda beta, delta, d: (beta + delta) / (d + 0.5), over={"d": (0, 2)}, points=500)
    with pytest.raises(pytest.fail.Exception, match="0x"):
        eq25.agrees(lambda beta, delta, d: (beta + delta) / (d + 1), points=500)
    with pytest.raises(ValueError, match="over: 'b'"):
        eq25.agrees(lambda beta, delta, d: 0.0, over={"b": (0, 1)})
    with pytest.raises(ValueError, match="id: 'eq99'"):
        Agreement("eq99")


def test_where_there_is_no_exact_value_nothing_agrees():
    with pytest.raises(ValueError, match="no exact value at any of 20 points"):
        Agreement("eq28").agrees(lambda k, b, m: 1.0, over={"k": (0, 0), "b": (1, 1)}, points=20)


def test_the_delay_margin_of_a_wall_that_is_not_stable_is_0():
    """A free undamped mass at a wall without damping: 1 - a + e + alpha n1 has roots beyond 1."""
    unstable = {"alpha": (1, 1), "beta": (0, 0), "delta": (0, 0)}
    Agreement("delay_margin").agrees(lambda *wall: 0.0, over=unstable, points=20)
    with pytest.raises(pytest.fail.Exception, match="exact 0"):
        Agreement("delay_margin").agrees(lambda *wall: 42.0, over=unstable, points=20)


def test_a_narrow_range_of_whole_numbers_has_whole_ends():
    """Before: half a period was held against no delay, and a right function was wrong."""
    Agreement("eq11").agrees(right, over={"d": (0.5, 2.5)}, points=200)
    with pytest.raises(ValueError, match=r"d: 0\.2 to 0\.8 has no whole number in it"):
        Agreement("eq11").agrees(right, over={"d": (0.2, 0.8)}, points=200)
    Agreement("is_stable").agrees(is_stable, over={"d": (0.2, 0.8)}, points=200)


def test_truths_and_counts_are_not_told_to_be_of_single_precision():
    """Each 0 and 1 is a float32."""

    def wrong_at_an_edge(alpha, beta, gamma, delta, d):
        return is_stable(alpha, beta, gamma, delta, d) or alpha == 0

    with pytest.raises(pytest.fail.Exception) as told_:
        Agreement("is_stable").agrees(wrong_at_an_edge, points=2000)
    assert "single precision" not in str(told_.value)


def test_a_range_in_whole_numbers_is_told_as_any_other():
    """Before: an AttributeError where the worst point was an end that is an int."""
    with pytest.raises(pytest.fail.Exception, match="0x"):
        Agreement("eq6").agrees(lambda K, B, T: K - K / 3, over={"B": (-7, -7)}, points=20)
    with pytest.raises(ValueError, match=r"gives 10{400} and no numbers when called with 10000"):
        Agreement("eq6").agrees(lambda K, B, T: 10**400, over={"K": (10000, 10000)}, points=2)
    for nothing in ({"points": 0}, {"over": {"B": (0, math.inf)}}):
        with pytest.raises(ValueError, match="give"):
            Agreement("eq6").agrees(lambda K, B, T: 0.0, **nothing)


def test_a_list_that_is_used_again_has_each_of_its_numbers():
    kept = [0.0, 0.0]

    def wall(b, T, d):
        kept[:] = max_passive_stiffness(b, d)[:2]
        kept[0] /= T
        return kept

    assert compared(CHECKED["eq11"], callers.called(wall), 8, 200).agrees


def _near(one, some):
    """The package's own numbers, a column for each result."""
    with np.errstate(all="ignore"):
        found = np.broadcast_arrays(*one.near(*map(np.array, zip(*some, strict=True))))
    return [column.astype(float) for column in found]


@pytest.mark.parametrize("name", CHECKED)
def test_the_package_agrees_with_every_formula(name):
    """Its own numbers are off by less than is allowed of others."""
    one = CHECKED[name]
    if one.near is None:
        pytest.skip("it takes long: test_delay_margin")

    def call(some):
        return list(zip(*(column.tolist() for column in _near(one, some)), strict=True))

    found = compared(one, call, 10, 400)
    assert found.agrees, report.text(report.Report(found, name, 0.0))


@pytest.mark.parametrize("name", [n for n in CHECKED if n not in ("delay_margin", "max_delay")])
def test_every_point_is_in_the_domain(name):
    """Walls on the boundary, which the two left out have as well, may have a negative gain."""
    one = CHECKED[name]
    for argument, column in zip(
        one.arguments.values(), zip(*drawn(one, 300).all, strict=True), strict=True
    ):
        assert all(map(argument.allows, column))


def test_all_special_points_are_among_the_usual_number():
    """As docs/check.md lists them."""
    one = replace(CHECKED["stability_boundary"], balls=6)
    right = [tuple(map(float, at)) for at in zip(*_near(one, drawn(one, 10_000).all), strict=True)]
    what = report.covered(compared(one, lambda some: right[: len(some)], 8, 10_000))
    theta, _, delta, d = np.array(drawn(one, 10_000).all).T
    assert what["kinds"]["angles below 0.001"] == (theta < 0.001).sum() > 100
    assert what["kinds"]["angles next to pi"] == (theta > math.pi - 0.001).sum() > 100
    assert what["kinds"]["no device damping"] == (delta == 0).sum() > 100
    assert what["kinds"]["delays above 100 periods"] == (d > 100).sum() > 100
    assert len(what["kinds"]) == 13  # of the 15 kinds, two are of the wall
    assert what["ranges"]["d"][1] > 1e14


class Dice:
    """Always the same number, and the middle of a range."""

    def __init__(self, number):
        self.number = number

    def random(self):
        return self.number

    def uniform(self, low, high):
        return (low + high) / 2


def test_pairs_lie_on_both_sides_of_each_part_of_the_boundary():
    """Without delay p(z) = z (z - 1)(z - 1/e) + M(z) (alpha z + beta (z - 1)) for delta = 1.

    M(z) = (z + e - 2)/e is the textbook's sampled device.  p(1) = 0 at alpha = 0, p(-1) = 0 on
    the line alpha + 2 beta = 2 (e + 1)/(3 - e), and p(exp(i theta)) = 0 on the curve between.
    """
    border, e = CHECKED["is_stable"].border, math.e
    low, high = border(Dice(0.85), 1e-3, 0.0, 0.0, 0.0, 1.0, 0.0)
    assert low[0] < 0 < high[0]
    low, high = border(Dice(0.95), 1e-3, 0.0, 0.0, 0.0, 1.0, 0.0)
    line = 2 * (e + 1) / (3 - e)
    for wall, side in ((low, -1), (high, 1)):
        assert wall[0] + 2 * wall[1] == pytest.approx(line * (1 + side * 1e-3), rel=1e-9)
    low, high = border(Dice(0.5), 1e-3, 0.0, 0.0, 0.0, 1.0, 0.0)
    z = np.exp(0.5j * math.pi)
    wanted = -z * (z - 1) * (z - 1 / e) * e / (z + e - 2)
    rows = np.array([[z.real, (z - 1).real], [z.imag, (z - 1).imag]])
    middle = np.linalg.solve(rows, [wanted.real, wanted.imag])
    for wall, side in ((low, -1), (high, 1)):
        assert wall[:2] == pytest.approx(middle * (1 + side * 1e-3), rel=1e-9)


def test_pairs_lie_on_both_sides_of_the_passive_walls():
    """(4) of the paper: delta > alpha/2 + |beta|, without delay."""
    low, high = CHECKED["is_passive"].border(Dice(0.5), 1e-3, 0.4, 0.3, 1.0, 0.0)
    assert low == pytest.approx((0.4, 0.3, 0.4995, 0.0), rel=1e-9)
    assert high == pytest.approx((0.4, 0.3, 0.5005, 0.0), rel=1e-9)


@pytest.mark.parametrize("name", ["is_stable", "unstable_roots", "is_passive"])
def test_the_pairs_have_all_the_distances(name):
    """As docs/check.md has it: from 1e-3 to 1e-12."""
    far = drawn(CHECKED[name], 200).distance
    found, counts = np.unique(far[~np.isnan(far)], return_counts=True)
    assert found == pytest.approx([10.0**-k for k in range(12, 2, -1)])
    assert set(counts % 2) == {0}


@pytest.mark.parametrize("name", ["max_stable_stiffness", "scene.max_stable_stiffness", "limit_at"])
def test_nan_is_no_answer_where_an_exact_value_is_known(name):
    one = CHECKED[name]
    nothing = [(math.nan,) * len(one.results)]
    assert not compared(one, lambda some: nothing * len(some), 8, 12, explained=False).agrees


def test_every_function_of_walls_can_be_checked():
    """But for what gives no numbers: regions, and what decides or converts."""
    functions = {name for name in symhaptic_names if name[0].islower()}
    others = {"enclose", "enclose_maximum", "formula", "grid_boundary", "lambdify", "prove"}
    others |= {"recheck", "robust_region", "show_config", "stable_region", "sweep"}
    others |= {"jury"}  # gives formulas
    others |= {"max_delay"}  # what delay_margin gives without a delay
    assert functions - others <= set(CHECKED)


def test_delay_margin():
    from symhaptic import delay_margin

    one = replace(CHECKED["delay_margin"], balls=4)
    right = callers.called(delay_margin)
    assert compared(one, right, 8, 12).agrees
    late = compared(one, lambda some: [(1.0,)] * len(some), 8, 12)
    assert not late.agrees


def test_a_wrong_formula_is_shown_where_it_is_plainest(mine):
    """d = 0 is right whatever is done to d, and so the plainest is d = 1."""
    (mine / "other.py").write_text(
        "import math\ndef f(b, T, d):\n    return 2*b/T*math.tan(math.pi/(4*(d*d + 1)))\n"
    )
    done = symhaptic("check", "--formula", "eq11", "--python", "other:f", cwd=mine)
    assert "b = 0x1.0000000000000p+0 (1), T = 0x1.0000000000000p+0 (1), " in done.stdout
    assert "d = 0x1.0000000000000p+1 (2)" in done.stdout  # at d = 1 d*d is d
    assert done.stdout.endswith("  differs\n")


def test_no_plainer_place_is_looked_for_when_the_time_is_over():
    checked, begin = CHECKED["eq11"], ((0.3, 0.1, 2.0), (7.0,))
    assert plainest(checked, lambda some: pytest.fail("was called"), begin, 8.0, {}, -1.0) == begin


def test_junit_and_json(mine):
    done = checked(mine, "eq11", "swapped", "--format", "junit", "-o", "found.xml")
    assert (done.returncode, done.stdout) == (1, "")
    (case,) = ET.parse(mine / "found.xml").getroot()
    assert (case.get("name"), case.get("classname")) == ("eq11", "mine:swapped")
    assert "swapped" in case.find("failure").text
    found = json.loads(checked(mine, "eq11", "right", "--format", "json").stdout)
    assert found["agrees"]
    assert found["worst_ulp"] < 8
    assert found["exact_values"] > 900
    wrong = compared(CHECKED["linear_limit"], lambda points: [(math.inf,) for _ in points], count=9)
    assert '"worst_ulp": null' in report.json_text(report.Report(wrong, "mine", 0.0))


def test_an_annotation_is_whole_whatever_the_command_is_called(tmp_path):
    """GitHub ends a property at a comma and all of them at two colons; by number they are text."""
    (tmp_path / "mine.sh").write_text("while read line; do echo 1; done")
    asked = ("--formula", "linear_limit", "--command", "sh mine.sh a,b::50%", "--points", 20)
    done = symhaptic("check", *asked, "--format", "github", cwd=tmp_path)
    head, said = done.stdout.removeprefix("::error ").split("::")
    assert head == "title=symhaptic check of sh mine.sh a%2Cb%3A%3A50%25"
    assert said.startswith("linear_limit: 20 points")


def test_a_table_of_errors(mine):
    """One row for each point in balls, as in xsref: arguments, exact values, results, error."""
    done = checked(mine, "eq11", "right", "--format", "table")
    head, *rows = [line.split(",") for line in done.stdout.splitlines()]
    assert head == ["b", "T", "d", "K", "B", "K_got", "B_got", "ulp"]
    for row in rows[::100]:
        b, _, d = (float.fromhex(v) for v in row[:3])
        assert float(row[-1]) < 8
        assert abs(float(row[4]) - float.fromhex(row[6])) <= 8 * math.ulp(b * (d + 1))
        assert d.is_integer()


def test_a_python_function_takes_little():
    """Of 100 000 points; the machine may be busy, and half of it is the function's own."""
    found = compared(CHECKED["eq11"], callers.called(right), 8, 100_000)
    assert (found.called, found.agrees) == (100_000, True)


def right(b, T, d):
    """(11) of the paper."""
    n = math.pi / (2 * (d + 1))
    return 2 * b / T * math.tan(n / 2), b * (math.sin(n * d) - d / (d + 1)) / math.sin(n)


def test_a_table_of_exact_values():
    """Without delay (11) is K = 2b/T tan(pi/4) = 2b/T, so 2000 for b = 1, T = 0.001."""
    done = symhaptic("check", "--formula", "eq11", "--format", "table", "--points", 200)
    head, *rows = [line.split(",") for line in done.stdout.splitlines()]
    assert head == ["b", "T", "d", "K", "B"]
    assert len(rows) == 200
    wanted = [(1.0).hex(), (0.001).hex(), (0.0).hex()]
    found = next(row for row in rows if row[:3] == wanted)
    assert abs(float(found[3]) - 2000) < 1e-9


def test_what_counts_in_coarse_units_is_said():
    """Of a maximum that is flat; an error of half of the digits, which nobody would see else."""
    checked = CHECKED["max_stable_stiffness"]

    def told_of(change):
        mine = callers.called(lambda *plant: change(*checked.near(*plant)))
        return report.text(report.Report(compared(checked, mine, 8, 20), "mine", 0.0))

    coarse = f"in beta and theta a unit is {math.ulp(1e8):.2g}, half of the digits"
    agrees = told_of(lambda alpha, beta, theta: (alpha, beta + 1e-8, theta))
    assert "agrees" in agrees
    assert coarse in agrees
    assert coarse in told_of(lambda alpha, beta, theta: (alpha, beta + 1e-6, theta))
    alone = told_of(lambda alpha, beta, theta: (alpha,))
    assert "agrees" in alone
    assert coarse not in alone


def test_a_function_may_give_the_first_of_several_results():
    def stiffness(b, T, d):  # (11) of the paper
        return 2 * b / T * math.tan(math.pi / (4 * (d + 1)))

    found = compared(CHECKED["eq11"], callers.called(stiffness), 8, 500)
    assert found.worst < 8
    assert found.missing == ()
    with pytest.raises(ValueError, match="3 numbers; give K, B"):
        compared(CHECKED["eq11"], callers.called(lambda b, T, d: (b, T, d)), 8, 50)


def test_what_is_not_looked_at_does_not_agree(mine):
    wrong = """
import sys
from math import nan, pi, tan

asked = 0

def seldom(b, T, d):
    # B is wrong; at one point there is no B, so that only K would be compared
    global asked
    asked += 1
    K = 2*b/T*tan(pi/(4*(d + 1)))
    return (K,) if asked == 7 else (K, 123.0)

def leaves(b, T, d):
    sys.exit(0)

def nothing(b, T, d):
    return nan, nan
"""
    (mine / "mine.py").write_text(MINE + wrong)
    (mine / "early.py").write_text("import sys\nsys.exit(0)\n")
    for options, said in (
        (("eq11", "seldom"), "1 numbers at one point and 2 at another"),
        (("eq11", "leaves"), "ends the program (0) when called with"),
        (("eq11", "nothing", "--ulp", "inf"), "--ulp: inf is not a finite number"),
        (("eq11", "early:f"), "early:f: ends the program (0) when it is imported"),
    ):
        done = checked(mine, *options)
        assert done.returncode == 2, done.stdout
        assert said in done.stderr
        assert len(done.stderr.splitlines()) == 1
    with pytest.raises(ValueError, match="ulp: inf is not a finite number"):
        Agreement("eq11").agrees(lambda b, T, d: math.nan, ulp=math.inf, points=50)


def test_who_gives_too_many_numbers_is_said():
    """Before: `gives 3 numbers; K, B are`, with nobody named."""
    with pytest.raises(ValueError, match=r"^the function gives 3 numbers; give K, B$"):
        compared(CHECKED["eq11"], lambda some: [(1.0, 2.0, 3.0)] * len(some), 4, 10)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (["--over", "b=2:1"], "--over: 'b=2:1' is no range; give NAME=LOW:HIGH with one of b, T"),
        (
            ["--points", "1000000", "--over", "b=2:1"],  # the number that --help allows
            "--over: 'b=2:1' is no range",
        ),
        (["--over", "T=0:0"], "--over: 'T=0:0' has numbers that are not allowed; give a range of"),
        (["--over", "T=-1:0"], "--over: 'T=-1:0' has numbers that are not allowed; give a range"),
        (["--over", "b=-5:-1"], "--over: 'b=-5:-1' has numbers that are not allowed; give a ran"),
        (["--over", "b=1:1e71"], "--over: 'b=1:1e71' has numbers that are too large; give a ran"),
        (["--over", "d=0.2:0.3"], "--over: 'd=0.2:0.3' has no whole number in it; give another"),
        (["--over", "b=0:1", "--over", "b=2:3"], "--over: 'b=2:3' is a second range of b; give"),
        (["--memory", "1e300"], "--memory: 1e+300 is not a number > 0 and <= 1e+06; give one"),
        (["--timeout", "1e300"], "--timeout: 1e+300 is not a number > 0 and <= 1e+06; give one"),
        (["--arguments", ""], "--arguments: '' does not name each argument; order b, T, d"),
    ],
)
def test_a_range_or_limit_that_is_none_is_one_line(words, told, monkeypatch, capsys):
    """Of a function, and of a table."""
    for way in (["--python", "math:hypot"], ["--format", "table"]):
        asked = ["symhaptic", "check", "--formula", "eq11", *way, *words]
        monkeypatch.setattr(sys, "argv", asked)
        with pytest.raises(SystemExit, match="2"):
            main()
        said = capsys.readouterr()
        assert said.out == ""
        assert said.err.startswith(f"symhaptic: error: {told}")
        assert said.err.count("\n") == 1


def test_an_exact_table_has_the_range_that_is_asked_for():
    words = ("--over", "T=0.1:0.2", "--over", "b=3:4", "--points", "9")
    run = symhaptic("check", "--formula", "eq11", "--format", "table", *words)
    rows = [list(map(float.fromhex, line.split(",")[:2])) for line in run.stdout.splitlines()[1:]]
    assert len(rows) == 9
    assert all(3 <= b <= 4 and 0.1 <= T <= 0.2 for b, T in rows)


def test_a_range_without_a_boundary_has_points():
    words = ("--format", "table", "--over", "alpha=1e60:1e61", "--points", "20")
    run = symhaptic("check", "--formula", "is_stable", *words)
    assert (run.returncode, run.stderr, run.stdout.count("\n")) == (0, "", 21)


def test_what_is_wrong_with_a_function_or_a_range_names_the_option(tmp_path):
    (tmp_path / "odd.py").write_text("def three(*at): return 1, 2, 3")
    words = ("check", "--python", "odd:three", "--formula")
    run = symhaptic(*words, "is_stable", cwd=tmp_path)
    said = "symhaptic: error: --python odd:three: gives 3 numbers; give stable\n"
    assert (run.returncode, run.stderr) == (2, said)
    hard = ("--over", "gamma=1e14:1e15", "--over", "d=9e14:1e15", "--points", "9")
    run = symhaptic(*words, "max_stable_stiffness", *hard, cwd=tmp_path)
    said = "symhaptic: error: --over: max_stable_stiffness has no exact value at any of 9 points\n"
    assert (run.returncode, run.stderr) == (2, said)


def test_nan_is_told_of_what_differs_and_of_nothing_else():
    """NaN at the two points of no delay: the exact value is a number there."""

    def mine(beta, delta, d):
        return math.nan if d == 0 else (beta + delta) / (d + 0.5)

    for call, told in ((mine, True), (lambda *at: (at[0] + at[1]) / (at[2] + 0.5), False)):
        found = compared(CHECKED["linear_limit"], callers.called(call), 8, 200)
        said = report.text(report.Report(found, "mine", 0.0))
        assert (" points, such as " in said) is told
        assert found.agrees is not told


def test_a_factor_below_zero_is_named_with_its_sign():
    x = np.arange(1.0, 9.0)
    assert factor({"x": ()}, [x], x, -3 * x**2) == "-3*x"
