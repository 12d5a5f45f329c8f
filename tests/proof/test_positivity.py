"""Certificates are searched for, kept in a file and read from it; the kernel believes none."""

import json
import runpy
import subprocess
import sys
from pathlib import Path

import pytest
import sympy as sp
from scipy import optimize
from sympy import Eq, cos, pi, sin

from symhaptic.book import certificates, chapters, lemmas
from symhaptic.book.certificates import FILE
from symhaptic.book.lemmas import chords
from symhaptic.notation.proposition import proposition, whole
from symhaptic.proof.theorems import positivity
from symhaptic.proof.theorems.kernel import NotShown, assume, inst
from symhaptic.proof.theorems.positivity import Given, nlinarith, show

x, y, z = sp.symbols("x y w")  # the letter z stands for a complex number
CLAIM, KNOWN = proposition(x * y > x), (x > 0, y > 1)


@pytest.fixture(autouse=True)
def nothing_kept(monkeypatch):
    monkeypatch.setattr(positivity, "CERTIFICATES", {})
    monkeypatch.setattr(positivity, "USED", {})


def no_search(*_, **__):
    raise AssertionError("a linear program is solved")


@pytest.mark.parametrize(
    ("claim", "known"),
    [
        (CLAIM, KNOWN),
        (x + y < 2 * pi, [x < pi, y < pi]),
        (sin(x) ** 2 * y > 0, [x > 0, x < pi, y > 0]),
        (1 / x - 1 / y > 0, [x > 0, y > x]),
        (x / y > 0, [x < 0, y < 0]),
        (cos(2 * x) > -1, [sin(x) > 0, cos(x) > 0]),
        (sp.Ne(x - y, 0), [x < y]),
        (x**2 >= 0, []),
        (whole(2 * x + 1), [whole(x)]),
        (x + 1 > 0, [whole(x)]),
        (Eq(x, y + z), [(Eq(2 * x * z, 2 * y * z + 2 * z**2), 1 / (2 * z))]),
        (x * z <= y * z + z, [(Eq(x, y), z), z > 0]),
        (x * y > 0, [Eq(x, z**2 / y), z > 0, y > 0]),
        (z > 0, [Eq(x, 3 * z), x > 0]),
        (Eq(x, z + 2), [Eq(x, y + z), Eq(y, 2)]),
        (sp.exp(sp.I * x) * sp.exp(-sp.I * x) * y > 0, [y > 0]),
        (x**3 - x > 0, [x > 1]),
    ],
)
def test_what_follows_is_shown(claim, known):
    """Under no other hypotheses than the known ones, and that divisors are not zero."""
    found = show(claim, *known)
    given = {proposition(k[0] if isinstance(k, tuple) else k) for k in known}
    assert found.conclusion == proposition(claim)
    assert found.hypotheses - given <= {proposition(sp.Ne(z, 0))}


@pytest.mark.parametrize(
    ("claim", "known"),
    [
        (x * y > x, [x > 0, y > 0]),
        (x > 0, [x >= 0]),
        (x < 3, [x < pi]),
        (sin(x) > 0, [x > 0]),
        (1 / x > 0, []),
        (whole(x - 1), [whole(x)]),
        (Eq(x, y), [x <= y]),
        (sp.Ne(x, y), [x <= y]),
    ],
)
def test_what_does_not_follow_is_not_shown(claim, known):
    with pytest.raises(NotShown):
        show(claim, *known)


def test_what_is_kept_is_not_searched_for(monkeypatch):
    nlinarith(CLAIM, *KNOWN)
    monkeypatch.setattr(optimize, "linprog", no_search)
    assert nlinarith(CLAIM, *KNOWN).conclusion == CLAIM
    with pytest.raises(AssertionError):
        nlinarith(x * y > 2 * x, x > 0, y > 2)  # another claim, another certificate


@pytest.mark.parametrize(
    "wrong",
    [
        "1 1",
        "-1 0",
        "1 0 1 + 1",
        "2 0 1",
        "",
        "1 7",
        "x 0",
        "1/0 0",
        "nonsense",
        "1 -1",
        3,
        ["1 0"],
    ],
)
def test_a_wrong_certificate_is_searched_for_again(wrong):
    """Stale, tampered with or no certificate at all: the theorem is the same."""
    nlinarith(CLAIM, *KNOWN)
    [key] = positivity.CERTIFICATES
    positivity.CERTIFICATES[key] = wrong
    found = nlinarith(CLAIM, *KNOWN)
    assert found.conclusion == CLAIM
    assert found.hypotheses == set(map(proposition, KNOWN))
    assert positivity.CERTIFICATES[key] == positivity.USED[key] == "1 0 1"


@pytest.mark.parametrize("wrong", ["1 0", "1", "1 0 1", "-1 0", "0", "", "1/2 0 0"])
def test_no_certificate_makes_a_wrong_theorem(wrong):
    """Whatever stands in the file for a claim that does not follow, none is made."""
    with pytest.raises(NotShown):
        nlinarith(x > 1, x > 0)
    [key] = positivity.CERTIFICATES
    positivity.CERTIFICATES[key] = wrong
    with pytest.raises(NotShown):
        nlinarith(x > 1, x > 0)


def test_a_failed_search_is_kept_too(monkeypatch):
    with pytest.raises(NotShown):
        nlinarith(x > 1, x > 0)
    monkeypatch.setattr(optimize, "linprog", no_search)
    with pytest.raises(NotShown):
        nlinarith(x > 1, x > 0)


def test_a_failed_search_on_the_way_to_a_proof_is_not_kept():
    """The next time the proof is found without it."""
    Given(x > 0, y > 0).show(1 / x + y > 0)
    assert None not in positivity.USED.values()


def test_without_search_only_a_certificate_counts(monkeypatch):
    with pytest.raises(NotShown, match="has no certificate"):
        nlinarith(CLAIM, *KNOWN, search=False)
    nlinarith(CLAIM, *KNOWN)
    monkeypatch.setattr(optimize, "linprog", no_search)
    assert nlinarith(CLAIM, *KNOWN, search=False).conclusion == CLAIM


def test_what_is_assumed_stays_and_the_rest_is_closed():
    here = Given(x > 0, x < 1)
    found = here.closed(inst(assume(y > 0), {y: x + 1}))
    assert found.conclusion == proposition(x + 1 > 0)
    assert found.hypotheses == {proposition(x > 0)}
    other = assume(z > 0)
    assert here.closed(other) is other


def test_a_lemma_is_given_at_any_term():
    sine = Given(x > 0, x < pi).about(x)(sin(x) > 0)
    assert sine(2 * y).conclusion == proposition(sin(2 * y) > 0)
    assert sine(2 * y).hypotheses == {proposition(2 * y > 0), proposition(2 * y < pi)}


def test_a_lemma_of_the_package_needs_no_search(monkeypatch):
    monkeypatch.setattr(positivity, "CERTIFICATES", json.loads(FILE.read_text(encoding="utf-8")))
    monkeypatch.setattr(optimize, "linprog", no_search)
    uses = chords.flatter, chords.cosine, chords.sine_of_larger, chords.falls
    made = chords.HERE.lemma(chords.width().conclusion, *uses)
    assert made().hypotheses == chords.width().hypotheses


def test_the_file_is_written_by_the_command_and_not_by_an_import(tmp_path, monkeypatch):
    monkeypatch.setattr(lemmas, "__path__", [str(tmp_path)])
    monkeypatch.setattr(chapters, "shipped", lambda: [])
    monkeypatch.setitem(positivity.USED, "asked", [1])
    source = Path(certificates.__file__)
    runpy.run_path(str(source))
    assert not list(tmp_path.iterdir())
    runpy.run_path(str(source), run_name="__main__")
    assert json.loads((tmp_path / FILE.name).read_text()) == {"asked": [1]}


@pytest.mark.slow  # a stale entry costs a search, and proves nothing
@pytest.mark.early
def test_the_file_has_what_the_chapters_ask_for_and_nothing_else():
    """In a process of its own, in which no lemma is made before; and without a search."""
    code = (
        "from scipy import optimize; del optimize.linprog; "
        "from symhaptic.book.certificates import FILE, kept; "
        "raise SystemExit(kept() != FILE.read_text(encoding='utf-8'))"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
