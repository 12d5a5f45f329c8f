"""Text of chapters and sources is data: it is printed as it stands, or refused, and never run."""

import html
import re
import shutil
import subprocess
from html.parser import HTMLParser

import pytest
from sympy import Function, Symbol

from symhaptic.book.chapters import run
from symhaptic.book.page import Page
from symhaptic.book.record import FalseStep
from symhaptic.book.report.latex import prose
from symhaptic.book.report.place import has_tex
from symhaptic.book.report.printed import write_excerpt
from symhaptic.book.report.site import write
from symhaptic.book.report.tree import flat, words
from symhaptic.book.sources import SOURCES, STATEMENTS, add
from symhaptic.notation.latex import latex, refused
from symhaptic.paper.statement import Source, Statement

LINES = [
    "- 5 N/m of stiffness",
    "* 5 N/m of stiffness",
    "+ 5 N/m of stiffness",
    "\N{BULLET} 5 N/m of stiffness",
    "1. of two",
    "IV. of two",
    "(ii) of two",
    "#. of two",
    ".. a line that begins with two dots",
    ".. include:: /etc/passwd",
    ".. raw:: html",
    ".. |x| replace:: y",
    ".. _label: https://example.org",
    "__ https://example.org",
    ":class: evil",
    "-a option",
    "--long option",
    "/V option",
    "| a line",
    ">>> evil()",
    "====",
    "\\\\\\\\",
    "+---+",
    "[1] of a list",
    "a code block::",
    "a `link <javascript:alert(1)>`_ to nowhere",
    "javascript:alert(1) and https://example.org/ and a@example.org",
    "a :raw-html:`<script>alert(1)</script>` role",
    "a :math:`x` role, a |substitution|, a footnote [1]_, a target_ and *emphasis*",
    "<script>alert(1)</script>",
    r"\input{/etc/passwd} and \include{x}",
    r"\immediate\write18{touch pwned}",
    r"\catcode`\%=12 and ^^5cinput and \csname input\endcsname",
    r"\def\x{\x}\x and \end{document}",
    r"$\input{/etc/passwd}$ and $x^^5cinput{a}$",
    r"$\href{javascript:alert(1)}{x}$",
    r"$x`$ and $x\end{aligned}$ and $5 for one, 6 % for another # & more ~~ {",
    r"\texttt{a``b} and \texttt{:raw:`x`} and \emph{never closed",
    r"\chapter{nowhere}",
    r"a backslash \- before \. signs \` that \\ typographers know",
    "- a list\n- of two\n\n.. raw:: html\n\n   <b>bold</b>",
]


def seen(line):
    """How a line is read in print."""
    line = line.replace(r"\emph{", "").replace(r"\%", "%").replace("~", "\xa0")
    return re.sub(r"\\texttt\{([^{}]*)\}", r"\1", line)


class Words(HTMLParser):
    """The words of a page, with its elements and where they lead."""

    def __init__(self, text):
        super().__init__()
        self.words, self.tags, self.leads = [], set(), []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        self.tags.add(tag)
        self.leads += [value for name, value in attrs if name in ("href", "src")]
        assert not [name for name, _ in attrs if name.startswith("on")]

    def handle_data(self, data):
        self.words.append(data)


CHAPTER = '''
"""- A title: <script>, `a <b:c>`_, \\\\input{{x}}

{paragraphs}
"""
from symhaptic.notation import K, T

LINES = {lines!r}

def derive(page):
    for line in LINES:
        page.say(line)
    page.step(".. a title\\n\\n.. raw:: html\\n\\n   <b>x", K * T, T * K,
              because="- a reason\\n\\n.. include:: /etc/passwd", paper="`x`_")
    page.table("\\n\\n.. a caption: |x|", ["- head", "* more"], [["[1] cell", "* cell"]])
    page.figure("fig", ":class: x\\n\\n   :name: y", lambda axes: None)
    page.state("mine", "- I say <b> so\\n\\n.. raw:: html", "KT=TK")
    page.settle("mine", definition=True)
    page.settle_external("hostile:data", "- data `x`_ $5", "- a note \\\\input{{x}} of $5 _x_")
    page.settle_slip("hostile:slip", "<script>", "x", "- it \\\\shows `x`_ $5")
'''


@pytest.fixture(scope="module")
def hostile(tmp_path_factory):
    """A chapter and a source in which every text is hostile."""
    source = Source("hostile", "- Notes, 50 % `x`_ \\input{y}")
    add(
        source,
        [
            Statement(
                "hostile:slip",
                "- p. 5 `x`_ \\input{y}",
                "- it reads |x| \\input{y}",
                quote="- it <script> says $5 \\input{y} .. `x`_",
            ),
            Statement("hostile:data", "1", "- x"),
        ],
    )
    path = tmp_path_factory.mktemp("hostile") / "hostile.py"
    path.write_text(
        CHAPTER.strip().format(paragraphs="- one\\n\\n.. include:: /etc/passwd", lines=LINES),
        encoding="utf-8",
    )
    yield run(path)
    SOURCES.remove(source)
    del STATEMENTS["hostile:slip"], STATEMENTS["hostile:data"]


@pytest.fixture(scope="module")
def site(hostile, tmp_path_factory):
    folder = tmp_path_factory.mktemp("site") / "site"
    write([(1, hostile)], folder, lambda _: None, whole=False)
    return folder


def test_the_site_prints_it_and_runs_nothing(site):
    text = (site / "hostile.html").read_text(encoding="utf-8")
    [article] = re.findall(r"<article[^>]*>(.*?)</article>", text, re.DOTALL)
    page = Words(article)
    read = " ".join("".join(page.words).split())
    read = read.translate(str.maketrans("\u201c\u201d\u2018\u2019", "\"\"''"))
    for line in LINES:
        assert " ".join(seen(line).split()) in read, line
    for text in ("- a reason", "- a note", "- it reads |x|", "- p. 5 `x`_", "- one", "* cell"):
        assert text in read, text
    assert page.tags.isdisjoint({"script", "iframe", "ol", "b", "pre", "form"})
    assert article.count("<ul") == 1  # what the chapter finds
    assert [link for link in page.leads if not link.startswith(("#", "_", "fig", "code"))] == []
    assert "root:" not in html.unescape(text)


@pytest.mark.skipif(not has_tex() or not shutil.which("pdftotext"), reason="no TeX is installed")
def test_the_print_has_it_and_runs_nothing(hostile, tmp_path):
    write_excerpt([(1, hostile)], tmp_path, True, True, lambda _: None)
    out = subprocess.run(
        ["pdftotext", "-raw", tmp_path / "chapters.pdf", "-"], capture_output=True, check=True
    )
    read = "".join(out.stdout.decode().split())
    read = read.translate({0x2C6: "^", 0x2DC: "~", 0x2018: "`", 0x2019: "'", 0x201C: "``"})
    assert "root:" not in read
    for line in filter(str.isascii, LINES):
        shown = "".join(seen(line).split())
        assert shown.replace("-", "") in read.replace("-", ""), line  # lines are hyphenated


@pytest.mark.parametrize("line", LINES)
def test_no_command_is_left_in_the_latex(line):
    left = re.findall(r"\\[A-Za-z]+", prose(line))
    assert set(left) <= {r"\textbackslash", r"\textasciitilde", r"\texttt", r"\emph"}
    assert "^^" not in prose(line)
    depth = 0
    for brace in re.findall(r"\\.|[{}]", prose(line)):
        depth += {"{": 1, "}": -1}.get(brace, 0)
        assert depth >= 0
    assert depth == 0


@pytest.mark.parametrize("break_", ["\n\n", "\r\n\r\n", "\x0b", "\x0c", "\x85", "\u2028", "\x1c"])
def test_a_text_is_one_line(break_):
    text = f"a{break_}.. raw:: html{break_}   b"
    for shown in (words(text), flat([text])):
        [one] = shown
        assert len(one.astext().splitlines()) == 1
    assert "\n\n" not in prose("a\n \nb")
    assert "\x00" not in words("a\x00*b*")[0].astext() + prose("a\x00*b*")


@pytest.mark.parametrize(
    "tex",
    [
        *(
            r"\input{x}",
            r"\write18{x}",
            r"\catcode",
            r"\def\x{}",
            r"\csname x\endcsname",
            r"\end{x}",
        ),
        *("^^5cinput", "x$y", "x%y", "x#1", "x`y", "{x", "x}", "x\n\ny", "x\\", "x&y"),
        *(r"\begin{filecontents}", r"\href{javascript:x}{y}", r"\includegraphics{x}", r"\hbox{x}"),
    ],
)
def test_a_typed_formula_is_refused(tex):
    assert refused(tex)
    with pytest.raises(FalseStep, match=r"^(step 't'|t):"):
        Page("x").define("t", tex, Symbol("y"))
    with pytest.raises(ValueError, match=r"mine|cannot read|words|expected"):
        Page("x").state("mine", "says", rf"x = \text{{{tex}}}")
    with pytest.raises(ValueError, match="other:x"):
        add(Source("other", "Notes"), [Statement("other:x", "1", "x", domain=f"x > {tex}")])


def test_the_name_of_a_symbol_is_no_command():
    for thing in (Symbol(r"\input{x}"), Function(r"\input{x}")(1), Symbol("x$y"), Symbol("x`")):
        assert refused(latex(thing)) is None


@pytest.mark.parametrize("name", ["../x", "a/b", "/etc/x", "", "..", "a b", "x}", ".hidden", "ä"])
def test_a_figure_stays_in_its_folder(name):
    with pytest.raises(FalseStep, match="figure"):
        Page("x").figure(name, "caption", lambda axes: None)
