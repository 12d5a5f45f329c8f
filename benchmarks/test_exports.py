"""What an export costs: each function alone and all of them, as a process of its own, cold.

Run with `make bench`.  Processor time of the export itself, vectors included and the import of the
package and of SymPy not: at most 2 s a function and 60 s for all targets are the goals, of an idle
core.  Nothing fails here by being slow.
"""

import subprocess
import sys

import pytest

from symhaptic.export.targets import TARGETS
from symhaptic.forms.stable import FOR_ONE_DELAY, FORMS

PROGRAM = """
import sys, time
from symhaptic.export import request
from symhaptic.export.targets import TARGETS
import mpmath, numpy, sympy, flint
targets, names, delay = (word.split() for word in sys.argv[1:])
begin = time.process_time()
for target in targets:
    forms = request.chosen(names, delay=int(delay[0]) if delay else None)
    request.built(TARGETS[target], forms)
print(time.process_time() - begin)
"""


def seconds(targets, names, delay):
    """Processor time of one fresh process."""
    command = [sys.executable, "-c", PROGRAM, " ".join(targets), " ".join(names), delay]
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def told(benchmark, targets, names, delay=""):
    found = []
    benchmark.pedantic(lambda: found.append(seconds(targets, names, delay)), rounds=1)
    benchmark.extra_info["processor seconds"] = round(min(found), 2)
    print(f"\n    {', '.join(names) or 'all'}: {min(found):.2f} s", end="")


@pytest.mark.parametrize("name", FORMS)
def test_one_function(benchmark, name):
    told(benchmark, ["fortran"], [name], "2" if name in FOR_ONE_DELAY else "")


def test_everything_for_all_targets(benchmark):
    told(benchmark, list(TARGETS), [], "2")
