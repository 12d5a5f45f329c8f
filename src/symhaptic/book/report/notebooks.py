"""Guides as notebooks: what is typed becomes a cell, what is told beside it stays as it is.

Nothing is run here.  What a cell gives back is what the guide says, which its doctests hold to; a
test runs every notebook and compares.
"""

from __future__ import annotations

import ast
import doctest
import re
from collections.abc import Iterator
from typing import Any

import nbformat
from markdown_it import MarkdownIt
from nbformat import v4

from symhaptic.book.chapters import beside

FOLDER = "notebooks"
SHELL = {"tutorial"}
"""Guides whose commands are cells; those of others want files or minutes, and stay text."""

GUIDES = ("tutorial", "limits", "devices", "sweep", "verify")
"""Those that are notebooks, too."""

_COMMAND = re.compile(r"symhaptic |cc |\./")


def notebooks() -> dict[str, str]:
    """Name and text of each; none where there is no repository."""
    paths = {name: beside(f"docs/{name}.md") for name in GUIDES}
    return {
        name: nbformat.writes(notebook(path.read_text(encoding="utf-8"), name in SHELL)) + "\n"
        for name, path in paths.items()
        if path.is_file()
    }


def notebook(text: str, shell: bool = False) -> nbformat.NotebookNode:
    r"""A guide in Markdown as a notebook; with ``shell`` its commands are cells, too.

    >>> made = notebook("# Add\n\n```python\n>>> 1 + 1\n2\n\n```\n")
    >>> [(cell.cell_type, cell.source) for cell in made.cells]
    [('markdown', '# Add'), ('code', '1 + 1')]
    >>> made.cells[1].outputs[0].data
    {'text/plain': '2'}
    """
    cells: list[Any] = []
    for count, cell in enumerate(_cells(text, shell)):
        cell["id"] = f"cell-{count}"  # the same from run to run
        cells.append(cell)
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    made: nbformat.NotebookNode = v4.new_notebook(cells=cells, metadata={"kernelspec": kernel})
    nbformat.validate(made)
    return made


def _cells(text: str, shell: bool) -> Iterator[Any]:
    lines = text.splitlines()
    done = 0
    for token in MarkdownIt("commonmark").parse(text):
        if token.map is None or token.type not in ("fence", "code_block"):
            continue
        start, end = token.map
        before = "\n".join(lines[done:start]).strip()
        found = list(_typed(token, before, shell))
        if found:
            if before:
                yield v4.new_markdown_cell(_linked(before))
            yield from found
            done = end
    rest = "\n".join(lines[done:]).strip()
    if rest:
        yield v4.new_markdown_cell(_linked(rest))


def _typed(token: Any, before: str, shell: bool) -> Iterator[Any]:
    """Cells of a block of code; none where it is only to be read."""
    named = re.search(r"`([\w.]+)`:$", before)
    if token.info == "python" and ">>>" in token.content:
        yield from _examples(token.content)
    elif token.type == "fence" and named and shell:
        yield v4.new_code_cell(f"%%writefile {named[1]}\n{token.content.rstrip()}")
    elif token.type == "code_block" and shell:
        commands = token.content.strip().splitlines()
        if all(_COMMAND.match(line) for line in commands):
            yield v4.new_code_cell("\n".join(f"!{line}" for line in commands))


def _examples(content: str) -> Iterator[Any]:
    """Examples of a doctest, up to what each gives back."""
    typed: list[str] = []
    for example in doctest.DocTestParser().get_examples(content):
        typed.append(re.sub(r"\s*# doctest:.*", "", example.source).rstrip())
        if example.exc_msg:
            yield _refused("\n".join(typed), example.exc_msg.strip())
            typed = []
        elif example.want:
            yield v4.new_code_cell("\n".join(typed), outputs=[_output(typed[-1], example.want)])
            typed = []
    if typed:
        yield v4.new_code_cell("\n".join(typed))


def _refused(source: str, message: str) -> Any:
    """A cell that ends in an error; those after it run all the same."""
    name, _, why = message.partition(": ")
    shown = v4.new_output("error", ename=name, evalue=why, traceback=[message])
    return v4.new_code_cell(source, outputs=[shown], metadata={"tags": ["raises-exception"]})


def _output(source: str, want: str) -> Any:
    """What an expression is, or what was printed."""
    last = ast.parse(source).body[-1]
    printed = isinstance(last, ast.Expr) and ast.unparse(last).startswith("print(")
    if printed or not isinstance(last, ast.Expr):
        return v4.new_output("stream", text=want)
    return v4.new_output("execute_result", data={"text/plain": want.rstrip("\n")})


def _linked(text: str) -> str:
    """Links to other guides, and pictures, as they lie beside the folder of the notebooks."""
    text = re.sub(
        r"\]\((?:\.\./)?(\w+)\.md(#[\w-]+)?\)",
        lambda link: f"](../{link[1].lower()}.html{link[2] or ''})",
        text,
    )
    return re.sub(r"\]\((\w+\.png)\)", r"](../_images/\1)", text)
