"""The command line: the commands under one name, and what becomes of errors."""

from __future__ import annotations

import errno
import os
import re
import sys
import warnings
from collections.abc import Iterator
from difflib import get_close_matches
from functools import cache
from io import TextIOWrapper
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any

import typer

from symhaptic.cli import (  # noqa: F401 - each registers its commands
    check,
    computing,
    controller,
    limits,
    mutants,
    report,
    verify,
)
from symhaptic.cli.shared import FULL, Unusable, app, refuse
from symhaptic.notation.suggest import suggested

_ORDER = (
    *("verify", "report", "check", "limits", "controller", "trace", "jury"),
    *("export", "bench", "mutants", "kernels"),
)
"""In which the help lists the commands, what most people need first."""


def _place(command: typer.models.CommandInfo) -> int:
    assert command.callback is not None
    return _ORDER.index(command.name or command.callback.__name__)


app.registered_commands.sort(key=_place)

# Typer carries Click inside or beside itself, depending on its age; this is the base of the
# errors that its parser raises, in either case.
ParserError: type[Exception] = next(
    c for c in typer.BadParameter.__mro__ if c.__name__ in ("TyperException", "ClickException")
)


_INTERRUPTED = 130
"""The exit status of what a user leaves."""

_SCARCE = {errno.EMFILE, errno.ENFILE}
"""No file or pipe can be opened, whatever its name."""


@app.callback(invoke_without_command=True)
def _root(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Print version and kernels.")] = False,
) -> None:
    """Derive, verify and typeset the passivity and stability formulas of haptic walls."""
    if "SYMHAPTIC_KERNELS" in os.environ:
        try:
            import symhaptic.numeric.compiled  # noqa: F401 - it looks at the variable
        except ValueError as wrong:
            refuse(str(wrong))
    if version:
        from symhaptic.numeric.compiled import kernels_used
        from symhaptic.version import __version__

        typer.echo(f"symhaptic {__version__} ({kernels_used()} kernels)")
    elif context.invoked_subcommand is None:
        typer.echo(context.get_help())


def clearer(said: str) -> str:
    """What the parser says, with what may have been meant."""
    if choice := re.search(r"'([^']*)' is not one of ('.*')\.?$", said):
        names = re.findall(r"'([^']*)'", choice[2])
        return f"{said[: choice.start()]}{choice[1]!r} is not known; {suggested(choice[1], names)}"
    if not said.startswith(("No such", "Got unexpected")):
        return said
    if option := re.match(r"No such option: --([\w-]+)", said):
        near = [
            name
            for name in re.findall(r"--([\w-]+)", said[option.end() :])
            if get_close_matches(option[1], [name])
        ]  # dashes alone are no likeness
        said = option[0] + (f"; did you mean {', '.join(f'--{n}' for n in near)}?" if near else "")
    said = re.sub(r"\. Did you mean (.*)\?", r"; did you mean \1?", said).rstrip(".")
    return f"{said}{' ' if said.endswith('?') else '; '}see --help"


def _warned(message: Warning | str, *_: Any, **__: Any) -> None:
    """One line for a warning as for a bad input, without the place in our code."""
    _said_once(" ".join(str(message).split()))


@cache
def _said_once(warning: str) -> None:
    typer.echo(f"symhaptic: warning: {warning}", err=True)


def once(command: Any, given: list[str]) -> None:
    """Refuse an option with two values, of which the parser takes the last without a word."""
    before = given[: given.index("--")] if "--" in given else given
    called = next((command.commands[word] for word in before if word in command.commands), None)
    for option in called.params if called else ():
        if option.param_type_name != "option" or option.multiple or option.is_flag:
            continue
        names = [word[:2] if word[1:2] != "-" else word.partition("=")[0] for word in before]
        if sum(name in option.opts for name in names) > 1:
            refuse(f"{option.opts[0]}: is given more than once; give one value")


def somewhere(command: Any, given: list[str]) -> None:
    """Refuse an option without a place, which would be the current folder, and links in a circle.

    ``-o "$OUT"`` is empty where a script has not set the variable; ``--rocq --help`` would write
    into a folder of this name.
    """
    called = next((command.commands[word] for word in given if word in command.commands), None)
    places = {
        name: option.metavar
        for option in (called.params if called else ())
        if option.param_type_name == "option" and option.metavar in ("FILE", "DIR")
        for name in option.opts
    }
    options = {
        "-h",
        "--help",
        *(name for own in (called.params if called else ()) for name in own.opts),
    }
    for lead, value in _values(given):
        if lead in places and (not value or value in options):
            said = f"{value}: is an option" if value else "'': is empty"
            refuse(f"{lead} {said}; give a {places[lead]}")
        try:
            os.stat(value)
        except OSError as wrong:
            if wrong.errno == errno.ELOOP:
                refuse(_cannot_be_used(lead, value, wrong))


def _values(given: list[str]) -> Iterator[tuple[str, str]]:
    """Each word as the value of the option before it, or of an option in the same word."""
    for option, word in pairwise(["", *given]):
        yield option, word
        if word.startswith("-") and len(word) > 2:
            yield word[:2], word[2:]
        if "=" in word:
            lead, _, value = word.partition("=")
            yield lead, value


def _cannot_be_used(lead: str, value: str, wrong: OSError) -> str:
    shown = f"{lead} {value}" if lead.startswith("-") else value
    return f"{shown}: cannot be used ({wrong.strerror}); give another name"


def unusable(wrong: OSError, given: list[str]) -> str | None:
    """Say which of the arguments names a file or folder that the system refuses, and why.

    Python asks whether a file exists without an error, but for names that are too long and folders
    that may not be looked into.
    """
    if not isinstance(wrong.filename, str):
        return None
    named = Path(wrong.filename)
    for lead, value in _values(given):
        if value and Path(value) in (named, *named.parents):
            return _cannot_be_used(lead, value, wrong)
    return None


def main() -> None:
    """Entry point: one line for a bad input, exit status 2, no traceback."""
    warnings.showwarning = _warned
    if isinstance(sys.stdout, TextIOWrapper):  # an id may have letters that a terminal has not
        sys.stdout.reconfigure(errors="backslashreplace")
    command = typer.main.get_command(app)
    try:
        once(command, sys.argv[1:])
        somewhere(command, sys.argv[1:])
        status = command.main(standalone_mode=False)
        if status == _INTERRUPTED:  # so newer Typers say it
            raise KeyboardInterrupt
    except (ParserError, Unusable) as wrong:
        said = getattr(wrong, "format_message", wrong.__str__)()
        said = said.replace("Value error, ", "")
        if (errors := getattr(wrong.__cause__, "errors", None)) is not None:
            said = said.replace("Input should", f"{errors()[0]['input']!r} should")
        said = " ".join(clearer(said).split())
        said = re.sub(r"[\x00-\x1f\x7f-\x9f]", "\ufffd", said)  # a terminal would obey them
        typer.echo(f"symhaptic: error: {said}", err=True)
        raise SystemExit(2) from None
    except (typer.Abort, KeyboardInterrupt):
        typer.echo("symhaptic: interrupted", err=True)
        raise SystemExit(_INTERRUPTED) from None
    except OSError as wrong:
        if wrong.errno in _SCARCE:
            said = (
                f"{(wrong.strerror or '').lower()}; allow more, for instance with `ulimit -n 256`"
            )
            typer.echo(f"symhaptic: error: {said}", err=True)
            raise SystemExit(2) from None
        if said := unusable(wrong, sys.argv[1:]):
            typer.echo(f"symhaptic: error: {said}", err=True)
            raise SystemExit(2) from None
        if wrong.errno not in FULL or wrong.filename is not None:
            raise
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)  # what is left is not tried again at the end
        said = f"cannot write the result ({wrong.strerror}); give another place"
        typer.echo(f"symhaptic: error: standard output: {said}", err=True)
        raise SystemExit(2) from None
    raise SystemExit(status if isinstance(status, int) else 0)
