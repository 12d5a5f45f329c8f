"""How long the commands take, each as a process of its own from a cold start.

Run with `make bench`.  The limits are goals, not tests: nothing fails here by being slow.
"""

import subprocess
import sys

import pytest

COMMANDS = {
    "import numpy": ["-c", "import numpy"],
    "import symhaptic": ["-c", "import symhaptic"],
    "symhaptic --help": ["-m", "symhaptic", "--help"],
    "symhaptic verify": ["-m", "symhaptic", "verify"],
    "symhaptic verify eq11": ["-m", "symhaptic", "verify", "eq11"],
    "symhaptic report --format tex": ["-m", "symhaptic", "report", "--format", "tex", "-o"],
}


@pytest.mark.parametrize("name", COMMANDS)
def test_command(benchmark, name, tmp_path):
    command = [sys.executable, *COMMANDS[name]]
    if command[-1] == "-o":
        command.append(str(tmp_path))
    rounds = 3 if "verify" in name or "report" in name else 10
    benchmark.pedantic(
        lambda: subprocess.run(command, check=True, capture_output=True),
        rounds=rounds,
        warmup_rounds=1,
    )
