"""The report is complete, the same from run to run, and fits its lines."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest
from chapters import chapter

from symhaptic.book.chapters import run, shipped
from symhaptic.book.report import place
from symhaptic.book.report import printed as build
from symhaptic.book.report.tree import place_of
from symhaptic.notation.latex import latex
from symhaptic.paper import STATEMENTS

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def chapters():
    return [chapter(path.stem) for path in shipped()]


@pytest.fixture(scope="module")
def some():
    """Enough of them to write files and figures."""
    return [chapter(path.stem) for path in shipped() if path.stem.startswith("s2")]


@pytest.fixture(scope="module")
def files(chapters):
    return build.text_files(chapters)


@pytest.mark.ci
def test_one_tex_file_per_chapter_and_a_book_that_includes_them(chapters, files):
    for one in chapters:
        assert f"{one.name}.tex" in files
        assert rf"\input{{{one.name}}}" in files["book.tex"]


@pytest.mark.ci
def test_every_statement_is_in_the_ledger(files):
    for id in STATEMENTS:
        assert f"\\statementlink{{{place_of('statement', id)}}}" in files["ledger.tex"]


@pytest.mark.ci
def test_the_undecided_are_counted_aloud(files):
    first = build.text_files([run(shipped()[0])])
    few, all_ = (re.search(r"(\d+) undecided", t["ledger.tex"])[1] for t in (first, files))
    assert int(few) > 100
    assert all_ == "3"  # which chapters leave open


@pytest.mark.ci
def test_nothing_looks_like_a_program(files):
    for name, text in files.items():
        if name.endswith(".tex"):
            assert "operatorname" not in text
            assert "**" not in text
            assert "_eps" not in text


@pytest.mark.parametrize("which", ["some", pytest.param("chapters", marks=pytest.mark.ci)])
def test_no_step_says_that_a_thing_is_itself(which, request):
    """A step whose two sides are printed alike shows nothing, whatever it proves."""

    def shown(side):
        return (side if isinstance(side, str) else latex(side)).replace(" ", "")

    alike = [
        (one.name, block.title)
        for one in request.getfixturevalue(which)
        for block in one.page.blocks
        for left, _, right in block.lines
        if shown(left) == shown(right)
    ]
    assert not alike


def test_the_same_from_run_to_run(some):
    """Of some chapters in one process; the next test does the same for all, across processes."""
    again = [run(path) for path in shipped() if path.stem.startswith("s2")]
    assert build.text_files(again) == build.text_files(some)


@pytest.mark.ci
def test_committed_text_is_what_is_derived(files):
    if not (ROOT / "reports" / "errata.tex").is_file():
        pytest.skip("no committed report beside the package")
    assert build.differences(files, ROOT / "reports") == ""


@pytest.fixture
def undrawn(monkeypatch):
    """Without the pictures of what was measured, which other tests look at."""
    monkeypatch.setattr(build, "_measured", lambda folder, say: None)


@pytest.mark.usefixtures("undrawn")
def test_a_stale_report_shows_as_a_diff(some, tmp_path):
    build.write(some, tmp_path, pdf=False, say=lambda _: None)
    assert build.differences(build.text_files(some), tmp_path) == ""
    (tmp_path / f"{some[0].name}.tex").write_text("stale")
    assert "-stale" in build.differences(build.text_files(some), tmp_path)
    assert not list(tmp_path.glob(".draft-*"))


@pytest.mark.usefixtures("undrawn")
def test_records_have_to_be_there_and_the_rest_may_be_missing(some, tmp_path):
    build.write(some, tmp_path, pdf=False, say=lambda _: None)
    files = build.text_files(some)
    (tmp_path / "book.tex").unlink()
    assert build.differences(files, tmp_path) == ""
    for name in ("ledger.json", "results.tex", "errata.tex"):
        (tmp_path / name).unlink()
        assert f"{name} (derived)" in build.differences(files, tmp_path)


@pytest.fixture(scope="module")
def typeset(chapters, tmp_path_factory):
    if not place.has_tex():
        pytest.skip("no TeX: latexmk and pdflatex are not installed")
    target = tmp_path_factory.mktemp("pdf")
    build.write(chapters, target, pdf=True, say=lambda _: None)
    return target


@pytest.mark.ci
def test_the_pdf_has_every_chapter(chapters, typeset):
    if shutil.which("pdftotext") is None:
        pytest.skip("no pdftotext: poppler-utils is not installed")
    text = subprocess.run(
        ["pdftotext", "-layout", typeset / "book.pdf", "-"],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    for number in range(1, len(chapters) + 1):
        assert re.search(rf"CHAPTER {number}\b", text)


@pytest.mark.ci
def test_plain_words_are_typeset_as_they_stand(tmp_path):
    path = tmp_path / "my_chapter.py"
    path.write_text(
        '"""Is 50% of R&D a #1_item?"""\n'
        "from sympy import cos, sin\n"
        "from symhaptic.notation import theta\n"
        "def derive(page):\n"
        "    page.say('50% of it & more_or less #1')\n"
        "    page.step('100% sure', sin(theta)**2, 1 - cos(theta)**2)\n"
        "    page.state('my-own', '10% of x_1', 'x = x')\n",
        encoding="utf-8",
    )
    if not place.has_tex():
        pytest.skip("no TeX: latexmk and pdflatex are not installed")
    build.write([run(path)], tmp_path / "out", pdf=True, say=lambda _: None)
    if shutil.which("pdftotext") is None:
        pytest.skip("no pdftotext: poppler-utils is not installed")
    text = subprocess.run(
        ["pdftotext", "-layout", tmp_path / "out" / "book.pdf", "-"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    for words in ("Is 50% of R&D a #1_item?", "50% of it & more_or less #1", "100% sure", "10% of"):
        assert words in text


def test_an_overfull_line_is_an_error(tmp_path):
    if not place.has_tex():
        pytest.skip("no TeX: latexmk and pdflatex are not installed")
    (tmp_path / "book.tex").write_text(
        r"\documentclass{article}\begin{document}\hbox to 1cm{" + "x" * 400 + r"}\end{document}"
    )
    with pytest.raises(place.ReportError, match="Overfull"):
        build.typeset(tmp_path, say=lambda _: None)


@pytest.mark.usefixtures("undrawn")
def test_a_chapter_whose_derivation_is_gone_is_stale_and_goes(some, tmp_path):
    build.write(some, tmp_path, pdf=False, say=lambda _: None)
    gone, kept = tmp_path / "s9_gone.tex", tmp_path / "mine.tex"
    gone.write_text(f"% {build.GENERATED}\nold\n")
    kept.write_text("not ours\n")
    assert "-old" in build.differences(build.text_files(some), tmp_path)
    build.write(some, tmp_path, pdf=False, say=lambda _: None)
    assert not gone.exists()
    assert kept.exists()


@pytest.mark.ci
def test_a_file_that_no_report_wrote_is_not_written_over(tmp_path):
    """Whichever it is: text, figure or PDF; and then nothing else is written either."""
    for name in ("book.tex", "symhaptic.sty", "ledger.json", "figures/fig4.pdf"):
        target = tmp_path / name.replace("/", "-")
        (target / name).parent.mkdir(parents=True)
        (target / name).write_text("mine")
        with pytest.raises(place.ReportError, match=f"{name} there was not written by"):
            build.write([chapter("s3d_figures")], target, pdf=False, say=lambda _: None)
        assert [p for p in target.rglob("*") if p.is_file()] == [target / name]
        assert (target / name).read_text() == "mine"


@pytest.mark.ci
@pytest.mark.usefixtures("undrawn")
def test_a_report_is_written_over_by_the_next(tmp_path):
    for _ in range(2):
        build.write([chapter("s3d_figures")], tmp_path, pdf=False, say=lambda _: None)
    for _ in range(2):
        build.write_excerpt(
            [(14, chapter("s3d_figures"))], tmp_path, True, pdf=place.has_tex(), say=lambda _: None
        )
    assert (tmp_path / "book.tex").is_file()  # of the whole report, which an excerpt leaves alone


THESIS = r"""\documentclass[12pt,a4paper]{report}
\usepackage[margin=30mm]{geometry}
\newcommand{\step}{theirs}\newcommand{\form}[1]{#1}
\usepackage[dvipsnames]{xcolor}
\usepackage{symhaptic}
\begin{document}
\chapter{Theory}
\input{s3c_stiffness_maximum}
\step\form{!}
\end{document}
"""


@pytest.mark.ci  # typeset by LaTeX
def test_a_chapter_goes_into_a_thesis(tmp_path):
    """Whatever the thesis calls its own commands, and with margins of its own."""
    if not place.has_tex():
        pytest.skip("no TeX: latexmk and pdflatex are not installed")
    one = chapter("s3c_stiffness_maximum")
    build.write_excerpt([(13, one)], tmp_path, False, pdf=False, say=lambda _: None)
    (tmp_path / "thesis.tex").write_text(THESIS)
    build.typeset(tmp_path, lambda _: None, "thesis")
    if shutil.which("pdftotext") is None:
        pytest.skip("no pdftotext: poppler-utils is not installed")
    text = subprocess.run(
        ["pdftotext", "-layout", tmp_path / "thesis.pdf", "-"],
        capture_output=True, text=True, check=True,
    ).stdout  # fmt: skip
    for words in ("1.1 What is the largest stiffness", "(13.3)", "paper (11)", "theirs!"):
        assert words in re.sub(" +", " ", text)
    text = re.sub(r"\s+", " ", text)
    assert "the derivation “When is a delayed virtual wall passive?”" in text
    assert not re.search(r"chapter \d|\.py\b", text)  # what a thesis does not have
    cited = (tmp_path / "symhaptic.bib").read_text(encoding="utf-8")
    assert re.findall(r"^@\w+\{(\w+)", cited, re.MULTILINE) == ["symhaptic", "Hulin2014"]


def test_a_draft_that_another_run_is_making_stays(tmp_path):
    young, old = (tmp_path / f"{place.DRAFT}{age}" for age in ("young", "old"))
    for draft in (young, old):
        draft.mkdir()
    os.utime(old, (0, 0))
    with place.drafted(tmp_path):
        assert (young.exists(), old.exists()) == (True, False)
