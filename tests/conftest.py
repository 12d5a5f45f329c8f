"""Adds up the mutants that were tried, over all processes, and says so at the end."""

import os

# matrices are small here: threads of several processes would only get in each other's way
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")


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
