"""What a docstring, a comment or the manual names is there."""

import re
from pathlib import Path

import pytest

import symhaptic
from symhaptic.export.targets import TARGETS

SOURCE = Path(symhaptic.__file__).parent
ROOT = SOURCE.parents[1]
OWN = {"symhaptic.sty", "symhaptic.xml"}
"""File names that look like modules."""


def there(name):
    """Whether a dotted name is a module, or something that a module's text has."""
    parts = name.split(".")
    for split in range(len(parts), 0, -1):
        path = SOURCE.joinpath(*parts[1:split])
        files = [path.with_suffix(".py"), path / "__init__.py"]
        for file in (f for f in files if f.is_file()):
            text = file.read_text(encoding="utf-8")
            return all(re.search(rf"\b{part}\b", text) for part in parts[split:])
    return False


@pytest.mark.parametrize(
    "path",
    [*SOURCE.rglob("*.py"), *ROOT.glob("*.md"), *ROOT.glob("docs/*.md")],
    ids=lambda p: p.name,
)
def test_dotted_names_resolve(path):
    text = path.read_text(encoding="utf-8")
    named = set(re.findall(r"(?<![\w./])symhaptic(?:\.[A-Za-z]\w*)+", text)) - OWN
    assert [name for name in named if not there(name)] == []


@pytest.mark.parametrize("path", [*SOURCE.rglob("*.py")], ids=lambda p: p.name)
def test_names_in_roles_are_those_of_the_module_or_dotted(path):
    text = path.read_text(encoding="utf-8")
    for kind, name in re.findall(r":(class|func|meth|mod|data|attr):`~?\.?(\w+)`", text):
        builtin = name in dir(__builtins__) or name in __builtins__
        assert builtin or len(re.findall(rf"\b{name}\b", text)) > 1, (kind, name)


def paths_in(text):
    """Paths such as export/targets.py, with wildcards too."""
    return set(re.findall(r"(?<![\w/.<-])(?:[\w*-]+/)+[\w*-]+\.(?:py|md)\b", text))


MANUALS = [ROOT / "CONTRIBUTING.md", ROOT / "README.md", *(ROOT / "docs").glob("*.md")]
CODE = [*SOURCE.rglob("*.py"), *(ROOT / "derivations").glob("*.py")]


@pytest.mark.skipif(not (ROOT / "derivations").is_dir(), reason="no repository around the package")
@pytest.mark.parametrize("path", [*MANUALS, *CODE], ids=lambda p: p.name)
def test_paths_resolve(path):
    text = path.read_text(encoding="utf-8")
    for name in paths_in(text):
        if name.startswith("reports/"):  # made, not committed
            continue
        places = [*ROOT.glob(name), *SOURCE.glob(name), *(ROOT / "src").glob(name)]
        assert places, name
    for name in re.findall(r"\bs\d[a-e]?_\w+\.py\b", text):
        assert (ROOT / "derivations" / name).is_file(), name


def test_what_the_manual_says_is_in_a_module_is():
    """`name` in, or (after) `folder/module.py`, on one line of CONTRIBUTING."""
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    pairs = re.findall(r"`@?(\w+)`[^`.;]* in `([\w/]+\.py)`", text)
    pairs += re.findall(r"`@?(\w+)` \w* \(`([\w/]+\.py)`\)", text)
    assert ("_here", "proof/mutants.py") in pairs
    for name, path in pairs:
        assert re.search(rf"\b{name}\b", (SOURCE / path).read_text(encoding="utf-8")), name


def test_the_help_of_export_names_every_target():
    import typer.main

    from symhaptic.cli.main import app

    command = typer.main.get_command(app).commands["export"]
    (option,) = (p for p in command.params if p.name == "target")
    assert re.findall(r"\w+", option.help.replace(" or ", ", ")) == list(TARGETS)
