"""What is misspelt: one line that names what may have been meant, and options that there are."""

import ast
import re
import sys
from pathlib import Path

import pytest
import typer.main

import symhaptic
from symhaptic.cli.main import app, main

SOURCE = Path(symhaptic.__file__).parent

MISSPELT = {
    "statement": (["verify", "eq111"], "did you mean 'eq11'", "`symhaptic verify --list`"),
    "formula": (["export", "linear_limt"], "did you mean 'linear_limit'", "`symhaptic export --l"),
    "part": (["export", "--scene", "no-dely"], "did you mean 'no-delay'", "no-stiffness, no-damp"),
    "target": (["export", "--target", "fortan"], "did you mean 'fortran'", "rust, javascript"),
    "precision": (["export", "eq11", "--target", "c", "--precision", "singel"], "'single'", ""),
    "derivative": (["export", "--derivative", "gama"], "did you mean 'gamma'", "alpha, beta"),
    "format": (["verify", "--format", "jsn"], "did you mean 'json'", "text, json, junit"),
    "option": (["trace", "--gama", "1"], "did you mean --gamma?", "--help"),
    "command": (["verfy"], "did you mean 'verify'?", "--help"),
    "chapter": (["report", "--chapter", "s3d_figure"], "'s3d_figures'", "`symhaptic report --l"),
}


@pytest.mark.parametrize("case", MISSPELT)
def test_what_is_misspelt_is_told_with_what_may_be_meant(case, monkeypatch, capsys):
    arguments, *parts = MISSPELT[case]
    monkeypatch.setattr(sys, "argv", ["symhaptic", *arguments])
    with pytest.raises(SystemExit) as left:
        main()
    error = capsys.readouterr().err
    assert left.value.code == 2
    assert error.count("\n") == 1
    assert all(part in error for part in parts), error
    assert "give one of 'did" not in error


@pytest.mark.parametrize("option", ["--alpha", "--lambda", "--zzz"])
def test_what_is_like_nothing_is_told_without_a_guess(option, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["symhaptic", "trace", option, "3"])
    with pytest.raises(SystemExit):
        main()
    said = f"symhaptic: error: No such option: {option}; see --help\n"
    assert capsys.readouterr().err == said


@pytest.mark.parametrize(("command", "one"), [("verify", "eq11"), ("report", "s3d_figures")])
def test_what_lists_all_does(command, one, monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["symhaptic", command, "--list"])
    with pytest.raises(SystemExit) as left:
        main()
    assert not left.value.code
    assert one in [line.split()[0] for line in capsys.readouterr().out.splitlines()]


COMMANDS = {
    name: {option for parameter in command.params for option in parameter.opts} | {"--help"}
    for name, command in typer.main.get_command(app).commands.items()
}
FILES = {
    "report": [
        *(SOURCE / "book" / "report" / f"{name}.py" for name in ("place", "printed")),
        SOURCE / "cli" / "report.py",
    ],
    "export": [SOURCE / "export" / "request.py", SOURCE / "export" / "language.py"],
}
"""Where messages of a command are, outside of its own function."""


def texts(tree):
    return [n.value for n in ast.walk(tree) if isinstance(n, ast.Constant) and type(n.value) is str]


def functions(path):
    tree = ast.parse(path.read_text(encoding="utf-8"))
    return {n.name: n for n in ast.walk(tree) if isinstance(n, ast.FunctionDef)}


def reached(name, known, seen):
    """The function and those of the commands' modules that it calls."""
    if name in known and name not in seen:
        seen.add(name)
        for node in ast.walk(known[name]):
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
                reached(node.func.id, known, seen)
    return seen


def test_an_option_that_a_message_names_exists():
    known = {}
    for path in (SOURCE / "cli").glob("*.py"):
        known |= functions(path)
    wrong = []
    for command, options in COMMANDS.items():
        said = [text for name in reached(command, known, set()) for text in texts(known[name])]
        for path in FILES.get(command, []):
            said += texts(ast.parse(path.read_text(encoding="utf-8")))
        for text in said:
            for option in re.findall(r"^(--[a-z][a-z-]*|-o)(?= |:|$)", text):
                wrong += [(command, text)] * (option not in options)
    assert not wrong


def test_a_command_that_a_text_shows_exists_with_its_options():
    root = SOURCE.parents[1]
    shown = [path.read_text(encoding="utf-8") for path in SOURCE.rglob("*.py")]
    shown += [path.read_text(encoding="utf-8") for path in root.glob("*.md")]
    for text in shown:
        for command, rest in re.findall(r"(?:`|^ {4,})symhaptic ([a-z]+)([^`\n#]*)", text, re.M):
            assert command in COMMANDS, command
            for option in re.findall(r"(?<!\S)--?[a-z][a-z-]*", rest):
                assert option in COMMANDS[command], (command, option)
