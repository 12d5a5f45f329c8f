"""What a docstring, a comment or the manual names is there."""

import re
from functools import cache
from pathlib import Path

import pytest

import symhaptic
from symhaptic.export.targets import TARGETS

SOURCE = Path(symhaptic.__file__).parent
ROOT = SOURCE.parents[1]
OWN = {"symhaptic.bib", "symhaptic.sty", "symhaptic.xml"}
"""File names that look like modules."""


CODE = [*SOURCE.rglob("*.py")]
MANUALS = [*ROOT.glob("*.md"), *ROOT.glob("docs/*.md")]


@cache
def text_of(path):
    return path.read_text(encoding="utf-8")


@cache
def there(name):
    """Whether a dotted name is a module, or something that a module's text has."""
    parts = name.split(".")
    for split in range(len(parts), 0, -1):
        path = SOURCE.joinpath(*parts[1:split])
        files = [path.with_suffix(".py"), path / "__init__.py"]
        for file in (f for f in files if f.is_file()):
            return all(re.search(rf"\b{part}\b", text_of(file)) for part in parts[split:])
    return False


def test_dotted_names_resolve():
    for path in (*CODE, *MANUALS):
        named = re.findall(r"(?<![\w./])symhaptic(?:\.[A-Za-z]\w*)+", text_of(path))
        assert [name for name in {*named} - OWN if not there(name)] == [], path


def test_names_in_roles_are_those_of_the_module_or_dotted():
    for path in CODE:
        text = text_of(path)
        for _, name in re.findall(r":(class|func|meth|mod|data|attr):`~?\.?(\w+)`", text):
            builtin = name in dir(__builtins__) or name in __builtins__
            assert builtin or len(re.findall(rf"\b{name}\b", text)) > 1, (path, name)


def paths_in(text):
    """Paths such as export/targets.py, with wildcards too."""
    return set(re.findall(r"(?<![\w/.<-])(?:[\w*-]+/)+[\w*-]+\.(?:py|md)\b", text))


@cache
def found(name):
    return [*ROOT.glob(name), *SOURCE.glob(name), *(ROOT / "src").glob(name)]


@pytest.mark.skipif(not (ROOT / "derivations").is_dir(), reason="no repository around the package")
def test_paths_resolve():
    own = [ROOT / "CONTRIBUTING.md", ROOT / "README.md", *(ROOT / "docs").glob("*.md")]
    for path in (*own, *CODE, *(ROOT / "derivations").glob("*.py")):
        for name in paths_in(text_of(path)):
            if not name.startswith("reports/"):  # made, not committed
                assert found(name), (path, name)
        for name in re.findall(r"\bs\d[a-e]?_\w+\.py\b", text_of(path)):
            assert (ROOT / "derivations" / name).is_file(), (path, name)


def test_what_the_manual_says_is_in_a_module_is():
    """`name` in, or (after) `folder/module.py`, on one line of CONTRIBUTING."""
    text = text_of(ROOT / "CONTRIBUTING.md")
    pairs = re.findall(r"`@?(\w+)`[^`.;]* in `([\w/]+\.py)`", text)
    pairs += re.findall(r"`@?(\w+)` \w* \(`([\w/]+\.py)`\)", text)
    assert ("Parts", "model/parts.py") in pairs
    for name, path in pairs:
        assert re.search(rf"\b{name}\b", text_of(SOURCE / path)), name


def test_the_help_of_export_names_every_target():
    import typer.main

    from symhaptic.cli.main import app

    command = typer.main.get_command(app).commands["export"]
    (option,) = (p for p in command.params if p.name == "target")
    assert re.findall(r"\w+", option.help.replace(" or ", ", ")) == list(TARGETS)
