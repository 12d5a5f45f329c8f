"""A browser for tests of the site, and a page in it that fails on what it complains of."""

import shutil

import pytest


def pytest_itemcollected(item):
    """What opens a browser takes long by its nature."""
    if "browser" in item.fixturenames:
        item.add_marker(pytest.mark.slow)


@pytest.fixture(scope="module")
def browser():
    from playwright.sync_api import sync_playwright

    chromium = shutil.which("chromium") or shutil.which("chromium-browser")
    with sync_playwright() as play:
        found = play.chromium.launch(executable_path=chromium, args=["--no-sandbox"])
        yield found
        found.close()


@pytest.fixture
def opened(browser):
    """A page that fails on what it writes to the console or asks of the network."""
    page = browser.new_page()
    bad = []
    page.on("console", lambda told: bad.append(told.text) if told.type == "error" else None)
    page.on("pageerror", lambda error: bad.append(str(error)))
    page.on(
        "request", lambda asked: asked.url.startswith(("file:", "data:")) or bad.append(asked.url)
    )
    yield page
    assert bad == []
    page.close()
