"""Loops with a velocity filter in the explorer: no wall is called stable or passive wrongly.

The reference is the oracle of the loops: state matrices of SciPy's exponential, and eigenvalues.
"""

import json
import math
import shutil
import subprocess
import tomllib

import numpy as np
import pytest
from book.test_explorer import CHROMIUM, go, page, rest, site, told  # noqa: F401
from loops.oracle import device, difference_equation, low_pass, matrix, sizes
from scipy.signal import lfilter

from symhaptic import LowPass, Scene
from symhaptic.book.report import explorer
from symhaptic.scene.device_file import read

FILTERS = {
    "low-pass": (1, "backward Euler"),
    "tustin": (1, "Tustin"),
    "second-order": (2, "backward Euler"),
}
IN_NODE = """
const given = JSON.parse(require("fs").readFileSync(0));
const answer = ({ name, tau, ...loop }) => {
  const n = { ...loop, own: loop.delta, filter: explorer.filter(name, tau) };
  return ASKED;
};
console.log(JSON.stringify(given.map(answer)));
"""
in_browser = pytest.mark.skipif(CHROMIUM is None, reason="no chromium is installed")


def asked(question, loops, folder):
    """The answers of the page's scripts in Node."""
    if shutil.which("node") is None:
        pytest.skip("no node here: what the page computes is not tried")
    home = explorer.HOME / "static" / explorer.NAME
    named = ("decimal", "velocity", "boundary", "limits", "response")
    scripts = "\n".join((home / f"{name}.js").read_text(encoding="utf-8") for name in named)
    whole = explorer.kernels().replace("module.exports = found;", "globalThis.haptic = found;")
    code = whole + scripts + IN_NODE.replace("ASKED", question)
    (folder / "asked.js").write_text(code, encoding="utf-8")
    done = subprocess.run(
        ["node", "asked.js"],
        input=json.dumps(loops), cwd=folder, capture_output=True, text=True, check=True,
    )  # fmt: skip
    return [math.nan if each is None else each for each in json.loads(done.stdout)]


def radius(loop, alpha, beta):
    """The largest root by a state matrix."""
    order, mapping = FILTERS[loop["name"]]
    wall, kind = difference_equation(*low_pass(loop["tau"], order, mapping))
    own = device(loop["gamma"], loop["delta"])
    return np.abs(sizes(matrix(*own, alpha, beta, loop["d"], wall, kind))).max()


def random_loops(dice, count, longest):
    """Free, soft and hard devices, any filter, integer and fractional delays."""
    for _ in range(count):
        yield {
            "name": str(dice.choice(list(FILTERS))),
            "tau": 10 ** dice.uniform(-2, 2),
            "gamma": float(dice.choice([0.0, 10 ** dice.uniform(-6, 0.5)])),
            "delta": float(dice.choice([0.0, 10 ** dice.uniform(-6, 0.3)])),
            "d": float(dice.choice([0, 1, dice.integers(2, 8), dice.uniform(0, longest)])),
        }


@pytest.mark.parametrize("count", [300, pytest.param(10_000, marks=pytest.mark.slow)])
def test_no_wall_is_called_stable_wrongly(count, tmp_path):
    """Half of the walls are next to the boundary, at distances from 1e-9 to a tenth."""
    dice = np.random.default_rng(count)
    loops = [
        loop | {
            "alpha": 10 ** dice.uniform(-6, 0.5) * dice.choice([1, 1, 1, -1]),
            "beta": 10 ** dice.uniform(-4, 0.5) * dice.choice([1, 1, -1]),
        }
        for loop in random_loops(dice, count, 30)
    ]  # fmt: skip
    for loop in loops:
        loop["theta"] = math.pi * dice.random() ** 2
    near = asked("explorer.boundary(n, loop.theta)", loops, tmp_path)
    for loop, wall in zip(loops, near, strict=True):
        if dice.random() < 0.5 and all(x is not None and abs(x) < 100 for x in wall[:2]):
            off = 1 + dice.choice([1, -1], 2) * 10 ** dice.uniform(-9, -1)
            loop["alpha"], loop["beta"] = (float(x) for x in np.array(wall[:2]) * off)
    stable = asked("explorer.stable(n, loop.alpha, loop.beta)", loops, tmp_path)
    radii = [radius(loop, loop["alpha"], loop["beta"]) for loop in loops]
    wrong = [loop for loop, yes, r in zip(loops, stable, radii, strict=True) if yes and r >= 1]
    assert wrong == []
    missed = [not yes for yes, r in zip(stable, radii, strict=True) if r < 1 - 1e-9]
    assert sum(missed) <= count / 500
    assert sum(stable) > count / 6


@pytest.mark.parametrize("count", [20, pytest.param(150, marks=pytest.mark.slow)])
def test_limits_are_on_the_border(count, tmp_path):
    """Of the stiffest wall at a damping and of any: stable below, and not above.

    Of few loops the page says that it does not know the stiffest: at an end far from B = 0.
    """
    dice = np.random.default_rng(44)
    loops = [
        loop | {"alpha": 0.01, "beta": 10 ** dice.uniform(-3, -0.3)}
        for loop in random_loops(dice, count, 8)
        if loop["delta"] and loop["gamma"] < 1
    ]
    question = "[n.beta, ...explorer.stiffestAt(n, explorer.curve(n), n.beta)]"
    best = "explorer.limits(n, explorer.curve(n)).stiffest"
    seen = unknown = 0
    answers = zip(*(asked(q, loops, tmp_path) for q in (question, best)), strict=True)
    for loop, ((beta, alpha, _), (most, at, _)) in zip(loops, answers, strict=True):
        for K, B, inside in ((alpha, beta, 1e-6), (most, at, 0)):  # corners may lean to any side
            if K is None or not abs(K) > 1e-9:
                continue
            seen += 1
            assert radius(loop, K - inside * abs(K), B) < 1 + 1e-6 * (not inside), (loop, K, B)
            assert radius(loop, K + 1e-6 * abs(K), B) >= 1, (loop, K, B)
        unknown += most is None
        assert alpha is None or most is None or alpha <= most * (1 + 1e-9)
    assert seen > len(loops)
    assert unknown <= len(loops) / 20


def test_passivity_with_an_average_is_its_closed_form(tmp_path):
    """b >= K T/2 + B (1 - f)/(1 + f) for B >= 0, b >= K T/2 + |B| for B < 0: no delay."""
    dice = np.random.default_rng(5)
    loops, bounds = [], []
    for _ in range(300):
        tau, delta = 10 ** dice.uniform(-2, 2), 10 ** dice.uniform(-4, 0)
        pole = tau / (1 + tau)
        beta = delta * dice.uniform(-1.2, 2)
        need = beta * (1 - pole) / (1 + pole) if beta >= 0 else -beta
        alpha = 2 * (delta - need) * (1 + dice.choice([1, -1]) * 10 ** dice.uniform(-6, -1))
        loops.append({
            "name": "low-pass", "tau": tau, "gamma": 0.0, "delta": delta, "d": 0.0,
            "alpha": alpha, "beta": beta,
        })  # fmt: skip
        bounds.append(alpha >= 0 and alpha / 2 + need <= delta)
    found = asked("explorer.margin(n, n.alpha, n.beta) >= 0", loops, tmp_path)
    assert found == bounds


def test_passivity_with_a_delay_is_condition_4(tmp_path):
    """No angle of a fine grid needs more, and the need is that of some angle."""
    dice = np.random.default_rng(6)
    loops = [
        loop | {"d": float(dice.integers(0, 12)), "alpha": 10 ** dice.uniform(-3, 0), "beta": B}
        for loop, B in zip(random_loops(dice, 60, 1), dice.uniform(-1, 1, 60), strict=True)
    ]
    found = asked("explorer.required(n, n.alpha, n.beta)[0]", loops, tmp_path)
    theta = np.concatenate([np.geomspace(1e-6, 1, 4000), np.linspace(1e-3, np.pi, 20_000)])
    z = np.exp(1j * theta)
    for loop, need in zip(loops, found, strict=True):
        above, below = low_pass(loop["tau"], *FILTERS[loop["name"]])
        filtered = np.polyval(above[::-1], 1 / z) / np.polyval(below[::-1], 1 / z)
        force = loop["alpha"] + loop["beta"] * (1 - 1 / z) * filtered
        each = ((1 - 1 / z) * z ** -loop["d"] * force).real / (2 - 2 * np.cos(theta))
        top = each[theta > 1e-5].max()  # below, the quotient of two small numbers is rounded
        assert top - 1e-5 <= need <= top + 1e-4 * (abs(top) + loop["alpha"] * loop["d"] + 1)


PADDLE = "#m=0.1&b=3&k=0&m_H=0&b_H=0&k_H=0&T=0.0005&t_d=0.001&f_c={}&K=500&B=2&velocity={}"
MADE = {
    "low-pass": LowPass(cutoff=50),
    "tustin": LowPass(cutoff=50, mapping="Tustin"),
    "second-order": LowPass(cutoff=50, order=2),
}


@in_browser
@pytest.mark.parametrize("name", FILTERS)
def test_the_page_tells_what_the_scene_tells(page, tmp_path, name):  # noqa: F811
    go(page, PADDLE.format(50, name))
    scene = Scene(
        mass=0.1, damping=3, stiffness=0, sampling_period=5e-4, delay=1e-3, velocity=MADE[name]
    )
    assert page.is_visible("#field-f_c")
    assert "time constant 3.183 ms" in page.inner_text("label[for=field-f_c]")
    near = {"rel_tol": 1e-7}
    assert math.isclose(told(page, "told-limit"), scene.limit_at(B=2).K, **near)
    assert math.isclose(told(page, "told-stiffest"), scene.max_stable_stiffness(), **near)
    assert math.isclose(told(page, "told-passive-limit"), scene.max_passive_stiffness(B=2), **near)
    assert math.isclose(told(page, "told-stiffest-passive"), scene.max_passive_stiffness(), **near)
    margin = 1000 * scene.delay_margin(500, 2)
    assert math.isclose(told(page, "told-delay"), margin, **near)
    assert page.inner_text("#told-linear") == "not computed"
    names = {}
    exec(page.inner_text("#code").split("print")[0], names)
    assert names["scene"] == scene
    page.select_option("#language", "TOML")
    rest(page)
    place = tmp_path / "device.toml"
    place.write_text(page.inner_text("#code"), encoding="utf-8")
    assert tomllib.loads(place.read_text())["velocity"]["cutoff"] == 50
    assert read(place).scene == scene


@in_browser
def test_passivity_is_not_told_between_two_periods(page):  # noqa: F811
    """With a filter (4) is of integer delays; the code then does not ask for it either."""
    go(page, PADDLE.replace("t_d=0.001", "t_d=0.0013").format(50, "low-pass"))
    assert page.inner_text("#told-passive") == "passivity not computed"
    assert page.inner_text("#told-needed") == "not computed"
    assert "is_passive" not in page.inner_text("#code")
    page.select_option("#velocity", "difference")
    rest(page)
    assert page.inner_text("#told-passive") == "passive"
    assert not page.is_visible("#field-f_c")
    assert "velocity" not in page.inner_text("#code")


def test_the_chart_ends_where_walls_become_unstable(tmp_path):
    """Drawn between samples, to a hundredth."""
    loops = [
        {"name": name, "tau": tau, "gamma": 0.0, "delta": 0.01, "d": d, "alpha": 0, "beta": 0}
        for name, tau, d in (("low-pass", 6, 2), ("tustin", 3, 1.5), ("second-order", 6, 2))
    ]
    charts = asked("explorer.chart(n, explorer.curve(n))", loops, tmp_path)
    for loop, chart in zip(loops, charts, strict=True):
        assert chart[0][1] == 0
        assert len(chart) > 40
        for alpha, beta in chart[1:-8:8]:
            assert radius(loop, 0.99 * alpha, beta) < 1 < radius(loop, 1.01 * alpha, beta)


def test_the_wall_in_c_is_the_filter(tmp_path):
    """The code of the page, compiled, beside SciPy's difference equation."""
    if shutil.which("cc") is None:
        pytest.skip("no cc here: the wall in C is not tried")
    home = explorer.HOME / "static" / explorer.NAME
    write = (home / "copies.js").read_text(encoding="utf-8")
    x = np.random.default_rng(3).normal(size=40)
    loops = [{"name": name, "tau": 5.0, "gamma": 0, "delta": 0, "d": 0} for name in FILTERS]
    state = '{ T: "0.001", K: "500", B: "2" }'
    question = f"eval({json.dumps(write)}) ?? explorer.copies.C({state}, n)"
    for loop, code in zip(loops, asked(question, loops, tmp_path), strict=True):
        values = ", ".join(map(repr, x.tolist()))
        main = f"double x[] = {{{values}}}; for (int i = 0; i < 40; ++i)"
        main = f'int main(void) {{ {main} printf("%.17g\\n", wall(x[i])); }}'
        (tmp_path / "w.c").write_text(f"#include <stdio.h>\n{code}\n{main}", encoding="utf-8")
        subprocess.run(["cc", "-o", "w", "w.c"], cwd=tmp_path, check=True)
        done = subprocess.run(["./w"], cwd=tmp_path, capture_output=True, text=True, check=True)
        speed = lfilter(*low_pass(5.0, *FILTERS[loop["name"]]), np.diff(x, prepend=0.0)) / 1e-3
        found = [float(line) for line in done.stdout.split()]
        np.testing.assert_allclose(found, -(500 * x + 2 * speed), rtol=1e-9, atol=1e-9)
