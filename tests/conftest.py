"""What several test files share: the derivations, run once, and the count of mutants."""

from functools import cache

import pytest

from symhaptic.library import Chapter, run, shipped


@cache
def _run(name: str) -> Chapter:
    return run(next(path for path in shipped() if path.stem == name))


@pytest.fixture(scope="session")
def chapter():
    """Runs a derivation by the name of its file, once per process."""
    return _run


def pytest_terminal_summary(terminalreporter):
    counts = [
        value
        for report in terminalreporter.getreports("passed")
        for name, value in report.user_properties
        if name == "mutants"
    ]
    if counts:
        terminalreporter.write_line(
            f"{sum(counts)} wrong mutants of {len(counts)} statements rejected"
        )
