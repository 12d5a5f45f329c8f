"""The list of all pages beside each of them: made once, since all pages lie in one folder.

Sphinx would put it together anew for every page, and the theme read it again, which takes longer
than everything else; only which entry is the page itself differs.
"""

from __future__ import annotations

from typing import Any

from sphinx.application import Sphinx
from sphinx.builders.html import StandaloneHTMLBuilder
from sphinx.environment.adapters.toctree import global_toctree_for_doc

_ENTRY = '<li class="toctree-l1"><a class="reference internal" href="{}">'
_CURRENT = (
    '<li class="toctree-l1 current current-page"><a class="current reference internal" href="#">'
)
_EARLY, _LATE = 400, 600
"""Before and after the theme, which comes at 500."""


class _Navigation:
    def __init__(self) -> None:
        self.tree = ""

    def make(self, app: Sphinx, builder: StandaloneHTMLBuilder) -> None:
        """As the page that leads to all others has it, which is not among them."""
        tree = global_toctree_for_doc(
            app.env,
            app.config.root_doc,
            builder,
            tags=app.tags,
            titles_only=True,
            maxdepth=-1,
            includehidden=True,
        )
        self.tree = builder.render_partial(tree)["fragment"]

    def give(self, app: Sphinx, page: str, template: str, context: Any, tree: Any) -> None:
        """To the theme."""
        context["toctree"] = lambda **_: self.tree

    def mark(self, app: Sphinx, page: str, template: str, context: Any, tree: Any) -> None:
        """The page itself."""
        entry = _ENTRY.format(app.builder.get_target_uri(page))
        tree = context["furo_navigation_tree"]
        context["furo_navigation_tree"] = tree.replace(entry, _CURRENT)


def setup(app: Sphinx) -> dict[str, Any]:
    """Sphinx's entry."""
    navigation = _Navigation()
    app.connect("write-started", navigation.make)
    app.connect("html-page-context", navigation.give, _EARLY)
    app.connect("html-page-context", navigation.mark, _LATE)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
