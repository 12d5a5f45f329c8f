"""What the guides let one type runs as it stands: their files are written, their commands typed.

A block below a line that ends with a file's name and a colon is that file.  The doctests among
their examples are run by pytest itself.
"""

import importlib.util
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from command import symhaptic

DOCS = Path(__file__).parents[1] / "docs"
LATER = ("pip ", "symhaptic verify --source", "symhaptic report")
"""What needs a network, files that another guide shows, or minutes; tested on their own."""

NO_JAX = importlib.util.find_spec("jax") is None


def typed(text):
    """Files of a guide, and the commands, in the order in which they stand."""
    before = ""
    for part in re.split(r"(```\w*\n.*?```)", text, flags=re.DOTALL):
        if part.startswith("```"):
            name = re.search(r"`([\w.]+)`:\s*$", before)
            if name:
                yield name[1], part.split("\n", 1)[1].removesuffix("```")
            continue
        before = part
        for line in re.findall(r"^    (\S.*)$", part, re.MULTILINE):
            if re.match(r"symhaptic|cc |\./|pip |python ", line):
                yield "", line.partition("  #")[0].strip()


def run(line, folder):
    """A command, in a folder."""
    name, *words = shlex.split(line)
    if name == "symhaptic":
        return symhaptic(*words, cwd=folder)
    name = sys.executable if name == "python" else name
    return subprocess.run([name, *words], cwd=folder, capture_output=True, text=True, check=False)


@pytest.mark.slow  # it exports, compiles and draws
@pytest.mark.parametrize("guide", ["tutorial", "howto"])
def test_a_guide_can_be_typed(guide, tmp_path):
    """With the files of the tutorial at hand, which the others go on from."""
    if shutil.which("cc") is None:
        pytest.skip("no C compiler: cc is not found")
    steps = list(typed((DOCS / f"{guide}.md").read_text(encoding="utf-8")))
    for name, text in [*typed((DOCS / "tutorial.md").read_text(encoding="utf-8")), *steps]:
        if name:
            (tmp_path / name).write_text(text, encoding="utf-8")
    told = {}
    for name, line in steps:
        if not name and not line.startswith(LATER) and not (NO_JAX and "slope.py" in line):
            done = run(line, tmp_path)
            assert done.returncode == 0, f"{line}\n{done.stdout}{done.stderr}"
            told[line] = done.stdout
    assert len(told) >= 5
    assert told.get("./controller", "-0.8 N\n0 N\n") == "-0.8 N\n0 N\n"


def test_every_guide_is_a_page():
    from symhaptic.book.report.guides import ORDER

    assert {path.stem for path in DOCS.glob("*.md")} == set(ORDER)
