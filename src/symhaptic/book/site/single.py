"""A chapter as one file: what its page of the site says, with style and figures inside it."""

from __future__ import annotations

import base64
import re
from collections.abc import Callable, Sequence
from pathlib import Path
from string import Template

from symhaptic.book.committed import GENERATED
from symhaptic.book.listing import replace
from symhaptic.book.processes import folder
from symhaptic.book.site.build import STATIC, Numbered, write

_PAGE = Template("""\
<!doctype html>
<!-- $generated -->
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="generator" content="symhaptic report">
<title>$title</title>
<style>
$style
:root { color-scheme: light dark;
  --color-background-border: #8884; --color-foreground-muted: #767676;
  --color-background-primary: Canvas; --color-background-secondary: Canvas;
  --color-code-background: Canvas; --color-foreground-primary: CanvasText;
  --color-brand-primary: LinkText; }
body { font-family: var(--font-stack); line-height: 1.5;
  max-width: 56em; margin: 2em auto; padding: 0 1em; }
img { max-width: 100%; height: auto; }
.headerlink, .math-link { display: none; }
p.rubric { font-weight: 700; }
table.numbers { border-collapse: collapse; }
table.numbers :is(td, th) { padding: .2em .8em; border-bottom: 1px solid #8884; }
</style>
<script>
$script
</script>
</head>
<body>
<main>
$article
</main>
</body>
</html>
""")


def write_single(
    numbered: Sequence[Numbered], target: Path, say: Callable[[str], None]
) -> list[Path]:
    """One file for each chapter; a site is made beside, and left behind."""
    with folder() as beside:
        site = beside / "site"
        write(numbered, site, say, whole=False)
        pages = {target / f"{c.name}.html": single(site, c.name) for _, c in numbered}
    target.mkdir(parents=True, exist_ok=True)
    for path, text in pages.items():
        replace(path, text)
    return list(pages)


def single(folder: Path, name: str) -> str:
    """Of a site in a folder; links to its other pages become words."""
    text = (folder / f"{name}.html").read_text(encoding="utf-8")
    found = re.search(r"<article[^>]*>(.*?)</article>", text, re.DOTALL)
    title = re.search(r"<title>(.*?)</title>", text, re.DOTALL)
    article = "" if found is None else found[1]
    article = re.sub(r'<a [^>]*href="[^"#][^"]*"[^>]*>(.*?)</a>', r"\1", article, flags=re.DOTALL)
    article = re.sub(r'src="([^"]*\.svg)"', lambda m: f'src="{_data(folder / m[1])}"', article)
    return _PAGE.substitute(
        generated=GENERATED,
        title=name if title is None else title[1],
        style=(STATIC / "site.css").read_text(encoding="utf-8"),
        script=(STATIC / "site.js").read_text(encoding="utf-8"),
        article=article.strip(),
    )


def _data(image: Path) -> str:
    return "data:image/svg+xml;base64," + base64.b64encode(image.read_bytes()).decode("ascii")
