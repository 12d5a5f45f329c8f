"""The explorer page: the exported functions in a browser, what is drawn of them, and its links."""

import gzip
import json

import numpy as np
import pytest
from book.test_site import CHROMIUM, browser, browser_needed, numbered, opened  # noqa: F401

import symhaptic
from symhaptic.book.site.build import write
from symhaptic.book.site.explorer import assets

pytestmark = browser_needed if CHROMIUM is None else []

FIELDS = ("mD", "bD", "mH", "bH", "kH", "T", "td", "K", "B")


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    target = tmp_path_factory.mktemp("explorer") / "site"
    write(numbered(["s3c_stiffness_maximum"]), target, lambda _: None, whole=False)
    return target


def at(page, site, **state):
    """The page, opened from the file system with a state in its link, and drawn."""
    link = "&".join(f"{key}={value}" for key, value in state.items())
    page.goto(f"file://{site / 'explorer.html'}#{link}")
    page.wait_for_function("globalThis.explorer && explorer.took > 0")
    return page


def states(count):
    """Random loops in SI units, times in ms; some without arm, damping or delay."""
    rng = np.random.default_rng(2020)
    found = 10 ** rng.uniform(
        [-2, -3, -1, -2, 0, -1, -2, 0, -2], [1, 1.3, 1.3, 2.3, 3.3, 1, 1.3, 4.7, 2.3], (count, 9)
    )
    found[:, [1, 2, 3, 4, 6]] *= rng.random((count, 5)) < 0.8
    found[: count // 3, 6] = (
        np.round(found[: count // 3, 6] / found[: count // 3, 5]) * found[: count // 3, 5]
    )
    return found


def numbers(state):
    """Table I, in the order of the page's own arithmetic."""
    mD, bD, mH, bH, kH, T, td, K, B = state.T
    m, seconds = mD + mH, T / 1000
    table = {
        "alpha": K * seconds * seconds / m,
        "beta": B * seconds / m,
        "gamma": kH * seconds * seconds / m,
        "delta": (bD + bH) * seconds / m,
        "own": bD * seconds / m,
        "d": td / T,
    }
    return table, m / (seconds * seconds), m / seconds


@browser_needed
def test_its_answers_are_those_of_python(opened, site):  # noqa: F811
    """1000 loops: the same verdicts, and numbers that differ by rounding of the last digits."""
    loops = states(1000)
    page = at(opened, site)
    found = page.evaluate(
        f"(all) => all.map((one) => {{ const s = {{}}; {json.dumps(FIELDS)}.forEach((key, i) => "
        "{ s[key] = one[i]; }); const f = explorer.limits(s);"
        "return [+f.stable, +f.passive, f.margin, f.stiffest.K, f.stiffest.B,"
        "f.stiffestPassive.K]; })",
        loops.tolist(),
    )
    ours = np.array([[np.nan if x is None else x for x in row] for row in found], dtype=float)
    n, K, B = numbers(loops)
    wall = (n["alpha"], n["beta"], n["gamma"], n["delta"], n["d"])
    assert np.array_equal(ours[:, 0].astype(bool), symhaptic.is_stable(*wall))
    assert 100 < ours[:, 0].sum() < 900
    margin = symhaptic.passivity_margin(n["alpha"], n["beta"], n["own"], n["d"])
    assert np.array_equal(ours[:, 1].astype(bool), margin >= 0)
    # some 4 ulp each, as README says of every function, and three of the page's own operations
    close = {"rtol": 4e-15, "atol": 0}
    assert np.allclose(ours[:, 2], margin * B, rtol=4e-15, atol=4e-15 * np.abs(B).max())
    stiffest = symhaptic.max_stable_stiffness(n["gamma"], n["delta"], n["d"])
    assert np.allclose(ours[:, 3], stiffest.alpha * K, **close)
    passive = symhaptic.max_passive_stiffness(n["own"], n["d"])
    assert np.allclose(ours[:, 5], getattr(passive, "alpha", passive) * K, **close)


@browser_needed
def test_the_motion_ends_where_the_springs_hold_the_push(opened, site):  # noqa: F811
    """1 N against K + k, once a stable loop has come to rest; an unstable one grows."""
    page = at(opened, site)
    loop = {"mD": 0.1, "bD": 5, "mH": 0, "bH": 0, "kH": 300, "T": 1, "td": 1.5, "K": 700, "B": 2}
    last = page.evaluate("(s) => explorer.motion(s, 4000).pop()", loop)
    assert last == pytest.approx(1 / (700 + 300), rel=1e-12)
    ways = page.evaluate("(s) => explorer.motion(s, 4000)", loop | {"K": 60000})
    assert abs(ways[-1]) > 1e3 * abs(ways[40])


@browser_needed
def test_a_link_carries_the_state_and_what_is_no_number_is_told(opened, site):  # noqa: F811
    page = at(opened, site, mD=0.072, bD=0.005, K=900, td="x", T=-1)
    assert page.input_value("#x-mD") == "0.072"
    assert page.input_value("#x-T") == "1"  # what a link says wrongly stays as it was
    assert page.input_value("#x-td") == "1.5"
    page.fill("#x-T", "0")
    assert "more than 0" in page.inner_text(".told")
    assert page.get_attribute("#x-T", "aria-invalid") == "true"
    page.fill("#x-T", "2")
    page.wait_for_function("location.hash.includes('T=2&')")
    assert "K=900" in page.url
    assert page.inner_text(".told") == ""


@browser_needed
def test_it_is_worked_by_keyboard_and_by_pointer(opened, site):  # noqa: F811
    page = at(opened, site)
    page.focus("#r-K")
    page.keyboard.press("ArrowRight")
    page.wait_for_function("explorer.state.K > 2000")
    page.select_option("#arms", label="Hogan")
    page.wait_for_function("explorer.state.kH === 568")
    assert "[17]" in page.inner_text("#arms-source")
    page.locator("svg.regions").scroll_into_view_if_needed()
    box = page.locator("svg.regions").bounding_box()
    before = page.evaluate("explorer.state.B")
    page.mouse.move(box["x"] + 0.7 * box["width"], box["y"] + box["height"] / 2)
    page.mouse.down()
    page.mouse.up()
    page.wait_for_function(f"explorer.state.B > {before}")
    assert "Scene(" in page.evaluate("explorer.write(explorer.state).Python")
    page.check("#near")
    page.wait_for_function("explorer.view.low.B === -explorer.view.high.B")
    with page.expect_download() as saved:
        page.click("button[data-save=svg]")
    assert saved.value.suggested_filename == "walls.svg"


@browser_needed
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_a_reader_and_a_phone_can_use_it(browser, site, scheme):  # noqa: F811
    from axe_playwright_python.sync_playwright import Axe

    # axe itself asks for what a file may not give, so that the console is not looked at here
    page = at(browser.new_page(color_scheme=scheme), site)
    found = Axe().run(page).response["violations"]
    bad = [v for v in found if v["impact"] in ("serious", "critical")]
    assert [(v["id"], v["nodes"][0]["html"]) for v in bad] == []
    page.set_viewport_size({"width": 360, "height": 740})
    assert page.evaluate("document.documentElement.scrollWidth") <= 360
    page.close()


def test_the_functions_are_small_enough_to_load():
    """150 kB compressed, as the page is to open at once on a phone."""
    script = assets()["haptic.script.js"]
    assert len(gzip.compress(script.encode())) < 150_000
