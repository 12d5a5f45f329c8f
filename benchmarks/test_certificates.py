"""How long it takes to check a certificate again, beside how long it took to find it.

Run with ``-s`` to see the table.  The search of each certificate is timed inside its chapter, its
check afterwards by itself.
"""

from time import perf_counter

import pytest

from symhaptic.book.chapters import run, shipped
from symhaptic.proof import box, roots
from symhaptic.proof.certificate import Positive
from symhaptic.proof.recheck import recheck


def timed(function, found):
    """The function; what it returns is kept with the seconds that it took."""

    def call(*arguments, **options):
        begin = perf_counter()
        result = function(*arguments, **options)
        found.append((result, perf_counter() - begin))
        return result

    return call


@pytest.fixture(scope="module")
def searches():
    found = []
    with pytest.MonkeyPatch.context() as patch:
        for module, name in ((box, "search"), (box, "maximum"), (roots, "zero")):
            patch.setattr(module, name, timed(getattr(module, name), found))
        for path in shipped():
            begin = len(found)
            run(path)
            found[begin:] = [(path.stem, *one) for one in found[begin:]]
    return found


def test_rechecks(benchmark, searches):
    def check():
        seconds = []
        for _, certificate, _ in searches:
            begin = perf_counter()
            assert recheck(certificate)
            seconds.append(perf_counter() - begin)
        return seconds

    again = benchmark.pedantic(check, rounds=3)
    print(f"\n{'chapter':34}{'kind':10}{'pieces':>7}{'found, ms':>12}{'checked, ms':>13}  ratio")
    for (name, found, took), checked in zip(searches, again, strict=True):
        pieces = found.pieces if isinstance(found, Positive) else ""
        print(
            f"{name:34}{type(found).__name__:10}{pieces:>7}{1e3 * took:12.2f}{1e3 * checked:13.2f}"
            f"  {checked / took:.3f}"
        )
    total = sum(took for *_, took in searches)
    print(f"all {len(again)}: {total:.3f} s, {sum(again):.3f} s, ratio {sum(again) / total:.3f}")
