"""The command `report`: the book, single chapters and the site."""

from __future__ import annotations

from collections.abc import Callable
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from symhaptic.cli.given import Derivations, SourceFolder, chapters_in, own_chapters
from symhaptic.cli.rocq import stale
from symhaptic.cli.shared import app, filling, folder_allowed, only_listed, progress, refuse
from symhaptic.notation.suggest import suggested

if TYPE_CHECKING:
    from symhaptic.book.chapters import Chapter


class ReportFormat(StrEnum):
    """What `report` writes."""

    tex = "tex"
    pdf = "pdf"
    html = "html"


@app.command()
def report(
    format: Annotated[
        ReportFormat | None,
        typer.Option(
            "--format",
            help="Default: the book as tex, and as pdf and html if their programs are installed.",
        ),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("-o", metavar="DIR", help="Folder of the report. Default: reports."),
    ] = None,
    check: Annotated[
        bool, typer.Option("--check", help="Write nothing; fail if the text in DIR is stale.")
    ] = False,
    chapter: Annotated[
        list[str] | None,
        typer.Option(
            "--chapter",
            metavar="NAME",
            help="Write only this chapter, for \\input with symhaptic.sty; repeatable.",
        ),
    ] = None,
    standalone: Annotated[
        bool,
        typer.Option(
            "--standalone",
            help="With --chapter: also write chapters.tex, which compiles by itself; in html, one "
            "file per chapter.",
        ),
    ] = False,
    listing: Annotated[bool, typer.Option("--list", help="Print the chapters' names.")] = False,
    derivation: Derivations = None,
    source: SourceFolder = None,
) -> None:
    """Write the derivations as LaTeX chapters and a book, and as a web site.

    With --source, write the chapters of your own source for \\input, and chapters.tex, which
    contains them all.
    """
    from symhaptic.book import chapters as library
    from symhaptic.book.figures.drawings import Drawings
    from symhaptic.book.ledger import of_chapter
    from symhaptic.book.parts import in_parts
    from symhaptic.book.report import place

    if listing:
        only_listed(
            output=output,
            format=format,
            check=check,
            chapter=", ".join(chapter or []),
            standalone=standalone,
        )
    output = output or Path("reports")
    paths = in_parts(library.shipped(), lambda path: path.stem) + own_chapters(derivation)
    if source is not None:
        if derivation:
            refuse(f"--source {source}: does not go with --derivation; leave one of them out")
        paths = chapters_in(source)
        chapter, standalone = chapter or [path.stem for path in paths], True
    if listing:
        typer.echo("\n".join(path.stem for path in paths))
        return
    if format is not ReportFormat.html and not place.can():
        refuse(place.NEEDS)
    if format is ReportFormat.html and not place.can_site():
        refuse(f"--format html: {place.SITE_NEEDS}")
    from symhaptic.book.report import printed

    can = place.has_tex()
    if format is ReportFormat.pdf and not can and not check:
        refuse(f"--format pdf: {place.NO_TEX}")
    if standalone and not chapter:
        refuse("--standalone: needs --chapter NAME")
    some = [named(name, paths) for name in dict.fromkeys(chapter or [])]
    pdf = format is ReportFormat.pdf if some else can and format in (None, ReportFormat.pdf)
    html = format is ReportFormat.html or (format is None and not some and place.can_site())
    only_html = format is ReportFormat.html
    if only_html and check:
        refuse("--format html: does not go with --check, which compares LaTeX; leave one out")
    single = only_html and standalone
    alone = standalone or pdf
    try:
        with Drawings() as drawings:
            printed.check(paths)
            if not check:
                folder_allowed(output)
                names = (
                    printed.names_of_excerpt(some, alone, pdf)
                    if some
                    else printed.names_of(paths, pdf)
                )
                names = [f"{path.stem}.html" for path in some] if single else names
                place.refuse_foreign(output, names if single or not only_html else [])
                if html and not single:
                    place.allowed(output / "site")
            elif not output.is_dir():
                refuse(f"-o {output}: is no folder; with --check give the folder of a report")
            chapters = chapters_of(some or paths, nothing if check or some else drawings.begin)
            stale([entry for one in chapters for entry in of_chapter(one)])
            numbered = [(paths.index(one.path) + 1, one) for one in chapters]
            if check:
                files = (
                    printed.excerpt_files(numbered, alone) if some else printed.text_files(chapters)
                )
                diff = printed.differences(files, output, whole=not some)
                typer.echo(diff, nl=False)
                if diff:
                    typer.echo(
                        f"symhaptic: {output} is stale; `symhaptic report` writes it", err=True
                    )
                    raise typer.Exit(1)
                return
            with filling(output):
                if some and not only_html:
                    printed.write_excerpt(numbered, output, alone, pdf, say)
                elif not only_html:
                    printed.write(chapters, output, pdf, say, drawings.take)
                if html and not single:
                    from symhaptic.book.report.site import write as write_site

                    write_site(numbered, output / "site", say, not some, drawings.take)
            if single:
                from symhaptic.book.report.site import write_single

                with filling(output):
                    made = write_single(numbered, output, say)
                typer.echo("\n".join(f"wrote {path}" for path in made))
                return
    except place.ReportError as wrong:
        refuse(str(wrong))
    mains = ["book"] if not some else ["chapters"] if alone else [path.stem for path in some]
    mains = [f"{name}.{'pdf' if pdf else 'tex'}" for name in mains if not only_html]
    mains += ["site/index.html"] if html else []
    typer.echo("\n".join(f"wrote {output / name}" for name in mains))
    if not pdf and not some and format is None:
        typer.echo(f"no PDF: {place.NO_TEX}", err=True)
    if not html and not some and format is None:
        typer.echo(f"no site: {place.SITE_NEEDS}", err=True)


def say(line: str) -> None:
    """What is being made."""
    typer.echo(line, err=True)


def named(name: str, paths: list[Path]) -> Path:
    """The derivation of a chapter that is asked for by its name."""
    found = {path.stem: path for path in paths}
    if name not in found:
        where = "`symhaptic report --list` lists all"
        refuse(f"--chapter {name}: is no chapter; {suggested(name, found, where)}")
    return found[name]


def nothing(chapter: Chapter) -> None:
    """What is done with a chapter that is only read."""


def chapters_of(paths: list[Path], derived: Callable[[Chapter], None]) -> list[Chapter]:
    """Run derivations one after the other, whole with their pages; each is heard of at once."""
    from symhaptic.book.chapters import BadChapter, run

    done: list[Chapter] = []
    try:
        with progress(len(paths)) as told:
            for path in paths:
                told(len(done), path)
                done.append(run(path))
                derived(done[-1])
    except BadChapter as wrong:
        refuse(f"--derivation {wrong}")
    return done
