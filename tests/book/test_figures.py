"""What a figure draws is told in its legend, and axes say what they measure before its unit."""

import ast
import re
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
import pytest

import symhaptic
from symhaptic import Scene, max_stable_stiffness, stable_region
from symhaptic.book.figures.passivity import passive_regions
from symhaptic.book.figures.region import heading
from symhaptic.book.figures.stability import passive_and_stable

SOURCE = Path(symhaptic.__file__).parent / "book"


@pytest.mark.parametrize(("draw", "panels"), [(passive_regions, 1), (passive_and_stable, 2)])
def test_every_kind_of_curve_has_its_line_in_a_legend(draw, panels):
    """Figs. 4 and 11: dashed, dotted and dash-dotted curves, too."""
    figure, axes = plt.subplots(1, panels, layout="constrained")
    draw(axes)
    every = np.atleast_1d(axes)
    drawn = {line.get_linestyle() for one in every for line in one.lines if len(line.get_xdata())}
    legends = figure.findobj(matplotlib.legend.Legend)
    told = {line.get_linestyle() for legend in legends for line in legend.get_lines()}
    plt.close(figure)
    assert len(drawn) >= 3
    assert drawn <= told


def named_axes():
    """The texts of axes and colour bars in all figures, with their file."""
    for path in sorted(SOURCE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            called = getattr(getattr(node, "func", None), "attr", "")
            if called in ("set_xlabel", "set_ylabel", "colorbar"):
                for text in ast.walk(node):
                    if isinstance(text, ast.Constant) and isinstance(text.value, str):
                        yield path.name, text.value


def test_axes_name_a_quantity_and_then_its_unit():
    texts = [text for _, text in named_axes() if re.search("[a-z]{4}", text)]
    assert len(texts) > 30
    for text in texts:
        assert not re.match(r"(seconds|periods|per cent|%|N/m|Ns/m|ms|s)\b", text), text
        assert ", periods" not in text
        assert "per cent" not in text


def test_a_small_number_in_a_title_has_a_power_of_ten():
    """1e-5 inside a formula is a product of e and a difference; 5e-5*1.38888 = 6.9444e-5."""
    title = heading(stable_region(6.944e-05, 0.02, 1))
    assert title == r"stable for $\gamma=6.944\times10^{-5}$, $\delta=0.02$, $d=1$"


def test_a_number_is_shown_as_one():
    shown = repr(max_stable_stiffness(0.001, 0.02, 1))
    assert re.fullmatch(r"Extremum\(alpha=0\.15\d+, beta=0\.42\d+, theta=0\.55\d+\)", shown)
    scene = Scene(mass=np.array(0.098), sampling_period=np.float64(0.001))
    assert repr(scene).startswith("Scene(mass=0.098, sampling_period=0.001, damping=None")
    with pytest.raises(ValueError, match=r"^mass: -0\.098 .*; give finite numbers > 0$"):
        Scene(mass=np.array(-0.098), sampling_period=0.001)
