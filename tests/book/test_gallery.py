"""The gallery: every program is short, runs by itself and draws; one that fails is named."""

import ast
from pathlib import Path

import pytest

from symhaptic.book.figures.programs import draw
from symhaptic.book.report import gallery
from symhaptic.book.report.place import ReportError

FOLDER = Path(__file__).parents[2] / "docs" / "gallery"


def test_every_program_is_shown():
    assert sorted(path.stem for path in FOLDER.glob("*.py")) == sorted(gallery.ORDER)
    page = gallery.page().astext()
    assert all(f"{name}.py" in page for name in gallery.ORDER)


@pytest.mark.parametrize("name", gallery.ORDER)
def test_a_program_is_short_and_says_what_it_shows(name):
    text = (FOLDER / f"{name}.py").read_text(encoding="utf-8")
    title, blank, more = ast.get_docstring(ast.parse(text)).split("\n", 2)
    assert blank == ""
    assert title.endswith((".", "?"))
    assert more.strip()
    code = [line for line in text.split('"""', 2)[2].splitlines() if line.strip()]
    assert len([line for line in code if not line.startswith(("import", "from"))]) <= 15


@pytest.mark.slow
@pytest.mark.parametrize("name", gallery.ORDER)
def test_a_program_draws(name, tmp_path):
    """Axes that say what they show, and their units where there are any."""
    import matplotlib.pyplot as plt

    draw([FOLDER / f"{name}.py"], tmp_path)
    svg = (tmp_path / f"{name}.svg").read_text(encoding="utf-8")
    assert svg.count("<path") > 10
    assert 10_000 < len(svg) < 150_000
    assert plt.get_fignums() == []


def test_a_program_that_fails_is_named(tmp_path, monkeypatch):
    folder = tmp_path / "gallery"
    folder.mkdir()
    (folder / "walls.py").write_text(
        '"""A title.\n\nMore.\n"""\nraise ValueError("no such wall")\n'
    )
    monkeypatch.setattr(gallery, "programs", lambda: [folder / "walls.py"])
    (tmp_path / "source").mkdir()
    told = r"^docs/gallery/walls\.py: ValueError: no such wall$"
    with pytest.raises(ReportError, match=told), gallery.drawn(tmp_path / "source"):
        pass
