"""The processor time of one evaluation, since others may share the machine."""

from __future__ import annotations

import time
from collections.abc import Callable

LEAST = 0.02
"""Seconds that a round lasts at least: calls that are shorter are repeated."""

ROUNDS = 5

METHOD = (
    f"Each call is repeated until a round lasts {1000 * LEAST:.0f} ms. The time is the shortest of "
    f"up to {ROUNDS} rounds, in CPU seconds, divided by the number of calls and elements."
)


def seconds(work: Callable[[], object], rounds: int = ROUNDS) -> float:
    """Time of a call: the least of several rounds, each of as many calls as fill it."""
    work()  # the first call may compile or import
    calls, best = 1, float("inf")
    done = 0
    while done < rounds:
        begin = time.process_time()
        for _ in range(calls):
            work()
        spent = time.process_time() - begin
        if spent < LEAST and not done:
            calls = max(2 * calls, int(calls * LEAST / max(spent, 1e-9)))
            continue
        best, done = min(best, spent / calls), done + 1
        if spent > 10 * LEAST:  # one long call is as sure as several
            break
    return best
