"""A statement of a user's own that no theorem decides is no pass."""

import json
import subprocess
import sys

CHAPTER = '''r"""Is every stiffness positive?

Nothing shows it.
"""

from symhaptic.notation import K
from symhaptic.notation.proposition import ForAll, proposition


def derive(page):
    page.state("all-positive", "each stiffness is positive", claim=ForAll((K,), proposition(K > 0)))
    page.leave_open("all-positive", "nothing is known")
'''


def verify(*arguments):
    command = [sys.executable, "-m", "symhaptic", "verify", *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=1200)


def test_an_open_statement_fails_where_no_ledger_has_it(tmp_path):
    path = tmp_path / "open.py"
    path.write_text(CHAPTER, encoding="utf-8")
    run = verify("--derivation", path, "--format", "json")
    (record,) = json.loads(run.stdout)["statements"]
    assert record["verdict"] == "undecided"
    assert run.returncode == 1  # a statement of one's own is to hold
    said = verify("--derivation", path, "--strict")
    assert said.returncode == 1
    assert "1 undecided, which is not a pass" in said.stdout
