"""The site in a browser: nothing missing, nothing asked of the network, to be read by everybody."""

import inspect
import io
import re
import shutil
from collections import defaultdict
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path
from xml.etree import ElementTree

import pytest
from chapters import chapter
from docutils import nodes
from docutils.core import publish_doctree

import symhaptic
from symhaptic.book.chapters import shipped
from symhaptic.book.parts import in_parts
from symhaptic.book.report.extension import turned
from symhaptic.book.report.place import ReportError
from symhaptic.book.report.site import single, trees, write
from symhaptic.book.report.tree import words

ALL = in_parts([path.stem for path in shipped()], str)
SOME = ["s2a_device", "s3b_envelope", "s3b_rise", "s3c_stiffness_maximum", "s4a_discretisation"]
CHROMIUM = shutil.which("chromium") or shutil.which("chromium-browser")
browser_needed = pytest.mark.skipif(CHROMIUM is None, reason="no chromium is installed")


def numbered(names):
    return [(ALL.index(name) + 1, chapter(name)) for name in names]


@pytest.fixture(scope="module")
def some(tmp_path_factory):
    """The site of a few chapters."""
    target = tmp_path_factory.mktemp("some") / "site"
    write(numbered(SOME), target, lambda _: None, whole=False)
    return target


class Links(HTMLParser):
    """Ids of a page, where it leads, and what it loads."""

    def __init__(self, text):
        super().__init__()
        self.ids, self.leads, self.loads = set(), [], []
        self.feed(text)

    def handle_starttag(self, tag, attrs):
        given = dict(attrs)
        self.ids |= {given["id"]} if "id" in given else set()
        if tag == "a" and "href" in given:
            self.leads.append(given["href"])
        elif given.get("src") or (tag == "link" and given.get("href")):
            self.loads.append(given.get("src") or given["href"])


def broken(folder):
    """Links and loads of a site that lead nowhere, or out of it."""
    pages = {path.name: Links(path.read_text(encoding="utf-8")) for path in folder.glob("*.html")}
    found = defaultdict(list)
    for name, page in pages.items():
        for link in page.leads:
            file, _, anchor = link.partition("#")
            there = pages.get(file or name)
            if link != "#" and not link.startswith("http"):
                code = file.endswith((".py", ".ipynb")) and (folder / file).is_file()
                lost = not code if there is None else anchor and anchor not in there.ids
                found[name] += [link] if lost else []
        files = [load.partition("?")[0] for load in page.loads if load != "#"]
        found[name] += [file for file in files if not (folder / file).is_file()]
    return {name: links for name, links in found.items() if links}


PARTS = dict.fromkeys(["mfrac", "mroot", "msub", "msup", "munder", "mover"], 2)
PARTS |= dict.fromkeys(["msubsup", "munderover"], 3)
"""How many elements these have by the standard; with others a browser sets them side by side."""


def fallen_apart(html):
    """Formulas in which a fraction, an exponent or an index is none: cos^2 x is read cos 2x."""
    found = []
    for text in re.findall(r"<math.*?</math>", html, re.DOTALL):
        parts = (e for e in ElementTree.fromstring(text).iter())
        if any(len(e) != PARTS.get(e.tag.rpartition("}")[2], len(e)) for e in parts):
            found.append(text)
    return found


@pytest.mark.parametrize(
    "tex",
    [r"\cos^2\frac{\theta}{2}", r"2\sin^{2d}x", r"x^2\tan^n y", r"\ln^2(x)", r"\lim_{x\to 0}x"],
)
def test_a_function_keeps_its_exponent_or_index(tex):
    (html,) = turned([(tex, False)]).values()
    assert fallen_apart(html) == []
    end = "</msub>" if "lim" in tex else "</msup>"
    assert fallen_apart(html.replace(end, f"<mspace />{end}", 1))


def test_no_formula_falls_apart(some):
    assert {p.name: fallen_apart(p.read_text("utf-8")) for p in some.glob("*.html")} == {
        p.name: [] for p in some.glob("*.html")
    }


def test_every_link_leads_somewhere(some):
    assert broken(some) == {}


def test_a_missing_anchor_is_found(some, tmp_path):
    copy = shutil.copytree(some, tmp_path / "site")
    page = copy / "s3c_stiffness_maximum.html"
    page.write_text(page.read_text().replace('id="statement-eq11"', 'id="statement-eq12"'))
    (copy / "index.html").write_text('<a href="s3c_stiffness_maximum.html#statement-eq11">x</a>')
    assert "index.html" in broken(copy)


def test_the_largest_stiffness_can_be_copied_as_latex(some):
    text = (some / "s3c_stiffness_maximum.html").read_text(encoding="utf-8")
    assert r"K = \frac{2b\tan\tfrac{\pi}{4(d+1)}}{T}</annotation>" in text


def test_a_chapter_is_one_file(some):
    """Style, script and figures in it; what leads to other pages is words."""
    page = Links(single(some, "s3c_stiffness_maximum"))
    assert page.loads == []
    assert page.leads
    assert {link.removeprefix("#") for link in page.leads} <= page.ids
    assert "statement-eq11" in page.ids


def test_no_tex_is_left_in_the_words(some):
    for path in some.glob("s*.html"):
        text = re.sub(
            r"<annotation.*?</annotation>|<pre>.*?</pre>", "", path.read_text(), flags=re.S
        )
        text = re.sub(r"<[^>]*>", "", text)
        assert not re.findall(r"\\[a-zA-Z]+|\$", text), path.name


@pytest.mark.parametrize(
    ("text", "made"),
    [
        ("a $b$ c", ["a ", "<math>b</math>", " c"]),
        ("5\\,\\% of *it*", ["5\u202f% of *it*"]),
        ("$x$, $y$s", ["<math>x</math>", ", ", "<math>y</math>", "s"]),
        ("(b) and (c) differ", ["(b) and (c) differ"]),
        (r"see \chapter{nowhere}", [r"see \chapter{nowhere}"]),
        (r"\emph{all $c_n$}", ["<emphasis>all <math>c_n</math></emphasis>"]),
    ],
)
def test_words(text, made):
    assert [str(node) for node in words(text)] == made


@pytest.mark.parametrize("name", ["explorer", "errata", "sweep"])
def test_no_page_of_the_site_takes_the_place_of_a_chapter(name):
    """One that is named like a public name has its own page, too."""
    one, jury = (replace(chapter(SOME[0]), path=Path(f"{n}.py")) for n in (name, "jury"))
    with pytest.raises(ReportError, match=f"{name}: the site has a page of this name"):
        trees([(1, one)], whole=True)
    assert trees([(1, jury)], whole=True)["jury"]["number"] == 1


def test_a_formula_that_pandoc_cannot_read_is_told():
    with pytest.raises(ReportError, match=r"^pandoc could not read a formula: .*\\nosuch"):
        turned([(r"\nosuch{x}", False)])


def test_a_folder_of_somebody_else_stays(tmp_path):
    (tmp_path / "site").mkdir()
    (tmp_path / "site" / "index.html").write_text("mine")
    with pytest.raises(ReportError, match="site there was not written by"):
        write(numbered(SOME[:1]), tmp_path / "site", lambda _: None, whole=False)
    assert (tmp_path / "site" / "index.html").read_text() == "mine"


@pytest.mark.slow
def test_a_site_is_replaced_as_a_whole(tmp_path):
    target = tmp_path / "site"
    for names in (SOME[:1], SOME[1:2]):
        write(numbered(names), target, lambda _: None, whole=False)
    assert [path.stem for path in target.glob("s*.html") if path.stem in ALL] == SOME[1:2]
    assert [path.name for path in tmp_path.iterdir()] == ["site"]


@browser_needed
def test_formulas_have_a_size(some, opened):
    opened.goto((some / "s3c_stiffness_maximum.html").as_uri())
    boxes = opened.eval_on_selector_all(
        "math", "all => all.map(m => m.getBoundingClientRect()).map(b => [b.width, b.height])"
    )
    assert len(boxes) > 30
    assert all(width > 2 and height > 4 for width, height in boxes)


@browser_needed
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_axe_finds_nothing_serious(some, browser, scheme):
    from axe_playwright_python.sync_playwright import Axe

    page = browser.new_page(color_scheme=scheme)  # axe itself asks for what a file may not give
    for name in ("index", "s3c_stiffness_maximum", "s3b_envelope", "believed"):
        page.goto((some / f"{name}.html").as_uri())
        found = Axe().run(page).response["violations"]
        bad = [v for v in found if v["impact"] in ("serious", "critical")]
        assert [(v["id"], v["nodes"][0]["html"]) for v in bad] == [], name


@browser_needed
def test_a_narrow_screen_scrolls_formulas_and_not_the_page(some, opened):
    opened.set_viewport_size({"width": 360, "height": 700})
    for name in SOME:
        opened.goto((some / f"{name}.html").as_uri())
        wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
        assert opened.evaluate(wide) <= 0, name


CUT = """() => [...document.querySelectorAll("math, pre, table")].filter((one) => {
  if (!one.getClientRects().length) return false;
  let box = one.parentElement;
  while (box && getComputedStyle(box).overflowX === "visible") box = box.parentElement;
  const column = box ?? one.closest("article");
  if (!column || column.matches("body, html, .content, .sidebar-scroll")) {
    const article = one.closest("article");
    return article && one.getBoundingClientRect().right > article.getBoundingClientRect().right + 1;
  }
  if (column.scrollWidth <= column.clientWidth + 1) return false;
  const arrow = getComputedStyle(column, "::after");
  const told = column.tabIndex === 0 && column.dataset.more && arrow.display === "block";
  return getComputedStyle(column).overflowX !== "auto" || !told;
}).map((one) => one.textContent.slice(0, 60))"""
"""What is wider than its column without a scroll bar, a place for the keyboard, and an arrow."""

BOXES = "div.math, .claim p, .answer p, .statement p, .verdict p"
WIDER = f"""() => [...document.querySelectorAll("{BOXES}")]
  .filter((box) => box.scrollWidth > box.clientWidth + 1).map((box) => box.textContent)"""


@browser_needed
def test_what_is_wider_than_its_column_says_so(some, opened):
    opened.set_viewport_size({"width": 390, "height": 800})
    opened.goto((some / "s3b_rise.html").as_uri())
    assert opened.evaluate(CUT) == []
    assert opened.evaluate(WIDER) != []  # this page has some
    opened.add_style_tag(content="[data-more]::after { display: none !important }")
    assert opened.evaluate(CUT) != []


LONELY = """() => [...document.querySelectorAll("p math")].filter((one) => {
  const text = one.nextSibling ?? one;
  if (text.nodeType !== 3 || !/^\\s*[.,;:!?)]/.test(text.textContent)) return false;
  const mark = document.createRange();
  mark.setStart(text, text.textContent.search(/[.,;:!?)]/));
  mark.setEnd(text, mark.startOffset + 1);
  const [above, here] = [one.getBoundingClientRect(), mark.getBoundingClientRect()];
  return here.width > 0 && here.left < above.left && here.top > above.top;
}).map((one) => one.textContent.slice(0, 40))"""


@browser_needed
def test_no_full_stop_stands_alone_on_a_line(some, opened):
    for width in (390, 520, 700):
        opened.set_viewport_size({"width": width, "height": 800})
        for name in SOME:
            opened.goto((some / f"{name}.html").as_uri())
            assert opened.evaluate(LONELY) == [], (name, width)


@browser_needed
def test_an_arrow_points_to_what_is_not_seen(some, opened):
    opened.set_viewport_size({"width": 390, "height": 800})
    opened.goto((some / "s3b_rise.html").as_uri())
    box = opened.locator("[data-more]").first
    assert box.get_attribute("data-more") == "→"
    for left, arrows in ((10, "← →"), (10_000, "←"), (0, "→")):
        box.evaluate("(box, left) => { box.scrollLeft = left; }", left)
        opened.wait_for_timeout(100)
        assert box.get_attribute("data-more") == arrows
    opened.set_viewport_size({"width": 1280, "height": 800})
    opened.wait_for_timeout(100)
    assert opened.locator("[data-more]").count() == 0


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The site of all chapters."""
    target = tmp_path_factory.mktemp("whole") / "site"
    write(numbered(ALL), target, lambda _: None)
    return target


@pytest.mark.slow
def test_the_whole_site_is_whole_and_small(whole):
    assert broken(whole) == {}
    assert [p.name for p in whole.glob("*.html") if fallen_apart(p.read_text("utf-8"))] == []
    assert sum(path.stat().st_size for path in whole.rglob("*") if path.is_file()) < 20e6


@browser_needed
def test_the_search_finds_an_equation(whole, opened):
    opened.goto((whole / "search.html").as_uri() + "?q=eq11")
    opened.wait_for_selector("ul.search li a")
    links = opened.eval_on_selector_all("ul.search li a", "all => all.map(a => a.href)")
    assert any("s3c_stiffness_maximum" in link for link in links)


@browser_needed
def test_the_ledger_is_filtered_and_sorted(whole, opened):
    opened.goto((whole / "ledger.html").as_uri())
    shown = "table.ledger tbody tr:not([hidden])"
    assert opened.locator(shown).count() > 140
    opened.get_by_label("Verdict").select_option("refuted")
    refuted = opened.locator(shown).count()
    assert 1 <= refuted < 20
    opened.get_by_label("Find").fill("shrinks")
    assert opened.locator(shown).count() == 1
    opened.get_by_label("Find").fill("")
    opened.get_by_label("Verdict").select_option("")
    opened.get_by_role("button", name="verdict").click()
    assert opened.locator(f"{shown} td:nth-child(3)").first.inner_text().strip() == "definition"


def test_every_public_name_is_in_the_table_and_has_a_place():
    from symhaptic.book.report.reference import PUBLIC, beside, page

    table, places = page([]).split("\n.. auto", 1)
    for name in PUBLIC:
        assert re.search(rf"^   \* - :(func|class):`{name}`\n     - \w", table, re.MULTILINE), name
        assert re.search(rf"^(\.\. auto)?(function|class):: {name}$", places, re.MULTILINE), name
    assert "In the paper it is (11), as published:" in beside("max_passive_stiffness").astext()


def docstrings():
    """Whatever the reference takes over."""
    from symhaptic.book.report.reference import PUBLIC, mathematics, sections

    for name in PUBLIC:
        thing = getattr(symhaptic, name)
        yield mathematics(sections(inspect.getdoc(thing) or ""))
        for member, of in vars(thing).items() if inspect.isclass(thing) else ():
            if not member.startswith("_"):
                yield mathematics(sections(inspect.getdoc(of) or ""))


def test_public_docstrings_can_be_set():
    """Sphinx would stop at what docutils cannot read; roles are Sphinx's, and are no words here."""
    from docutils.core import publish_doctree

    for text in docstrings():
        plain = re.sub(r":(class|func|meth|mod|py:obj):(?=`)", "", text)
        plain = plain.replace(".. seealso::", ".. note::")
        said = io.StringIO()
        settings = {"warning_stream": said, "report_level": 1, "halt_level": 6}
        publish_doctree(plain, settings_overrides=settings)
        assert said.getvalue() == "", text


def test_what_public_docstrings_name_has_a_place():
    """Sphinx stops at a name that the reference has not, and with it the report."""
    from symhaptic.book.report.reference import PUBLIC

    for text in docstrings():
        for name in re.findall(r":(?:class|func|meth):`~?symhaptic\.([\w.]+)`", text):
            assert name in PUBLIC, text


@browser_needed
@pytest.mark.parametrize("width", [360, 1280])
def test_no_page_is_wider_than_the_screen(whole, opened, width):
    opened.set_viewport_size({"width": width, "height": 700})
    wide = "document.documentElement.scrollWidth - document.documentElement.clientWidth"
    found = {}
    for path in sorted(whole.glob("*.html")):
        opened.goto(path.as_uri())
        found[path.stem] = opened.evaluate(wide)
    assert {name: by for name, by in found.items() if by > 0} == {}


@browser_needed
def test_no_formula_is_cut(whole, opened):
    """On a narrow screen it scrolls and says so; on a wide one nothing is wider than its column."""
    for width in (390, 1280):
        opened.set_viewport_size({"width": width, "height": 800})
        found = {}
        for path in sorted(whole.glob("*.html")):
            opened.goto(path.as_uri())
            found[path.stem] = opened.evaluate(CUT) + (
                opened.evaluate(WIDER) if width == 1280 else []
            )
        assert {name: cut for name, cut in found.items() if cut} == {}


@browser_needed
def test_the_errata_are_filtered(whole, opened):
    opened.goto((whole / "errata.html").as_uri())
    opened.get_by_label("Verdict").select_option("misprint")
    opened.get_by_label("Find").fill("eq12")
    opened.locator("table.ledger tbody tr:not([hidden]) a").first.click()
    assert opened.url.endswith("errata.html#erratum-eq12")


def test_the_guides_are_pages_with_their_code_and_links():
    from symhaptic.book.report.guides import ORDER, guides

    found = guides()
    assert list(found) == list(ORDER)
    assert "::\n\n   pip install ." in found["verify"]
    assert ".. code:: python\n\n   >>> " in found["limits"]
    assert not any(re.search(r"\.md(#[\w-]+)?>`__", text) for text in found.values())
    assert "<devices.html#units>`__" in found["limits"]


def test_a_cell_with_the_number_of_an_equation_is_no_list():
    from symhaptic.book.report.guides import led, turned

    table = led(turned("| paper | so |\n|---|---|\n| (4) | no |\n| (5), (8) | no |\n"))
    cells = [node.astext() for node in publish_doctree(table).findall(nodes.entry)]
    assert cells == ["paper", "so", "(4)", "no", "(5), (8)", "no"]
    assert not [*publish_doctree(table).findall(nodes.enumerated_list)]


@browser_needed
@pytest.mark.parametrize(
    ("words", "page"),
    [("own paper", "howto"), ("velocity filter", "loops")],
)
def test_the_search_shows_guides_before_chapters(whole, opened, words, page):
    opened.goto((whole / "search.html").as_uri() + f"?q={words}")
    opened.wait_for_selector("ul.search li a")
    links = opened.eval_on_selector_all("ul.search li a", "all => all.map(a => a.href)")
    assert any(f"/{page}.html" in link for link in links[:3])


def test_the_pictures_of_the_guides_are_there():
    from symhaptic.book.report.guides import guides, pictures

    shown = pictures()
    assert shown
    assert all(picture.is_file() for picture in shown)
    assert sum(
        text.count("image:: ") + text.count("figure:: ") for text in guides().values()
    ) == len(shown)


def linked(text, of):
    """Where the words of a link lead to on a page: what mentions a place is no plain text."""
    pattern = rf'<a class="reference internal" href="([^"]*)"><span[^>]*>{re.escape(of)}</span></a>'
    return set(re.findall(pattern, text))


def test_what_a_chapter_mentions_is_a_link_both_ways(some):
    """Section 3-C mentions the chapter on its rise, and another that is not among these few."""
    text = (some / "s3c_stiffness_maximum.html").read_text(encoding="utf-8")
    rise, condition = (ALL.index(name) + 1 for name in ("s3b_rise", "s3a_passivity_condition"))
    assert linked(text, f"chapter {rise}") == {"s3b_rise.html#chapter-s3b-rise"}
    assert f"By chapter {condition} a wall is passive" in text
    assert linked(text, "(7)") == {"s3b_rise.html#statement-eq7"}
    back = (some / "s3b_rise.html").read_text(encoding="utf-8")
    (neighbours,) = re.findall(r'<div class="source.*?</div>', back, re.DOTALL)
    assert "s3c_stiffness_maximum.html" in neighbours


def test_titles_code_and_formulas_are_left_alone(some):
    for path in some.glob("s*.html"):
        text = path.read_text(encoding="utf-8")
        for tag in ("h1", "title", "code", "math", "pre"):
            for inside in re.findall(rf"<{tag}[ >].*?</{tag}>", text, re.DOTALL):
                assert "#statement-" not in inside, path.name
