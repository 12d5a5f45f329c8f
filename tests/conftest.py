"""Adds up the mutants that were tried, over all processes, and says so at the end."""

import os

# matrices are small here: threads of several processes would only get in each other's way
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
# JAX's compiler takes most of the time of its tests, and its best code runs only once there
os.environ.setdefault(
    "XLA_FLAGS", "--xla_backend_optimization_level=0 --xla_llvm_disable_expensive_passes=true"
)


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
