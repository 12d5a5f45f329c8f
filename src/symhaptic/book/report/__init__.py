"""The report: one walk over a page, and two writers, for print and for the site.

* ``chapter``, ``pages``, ``tree``: a chapter, and the pages beside the chapters, as trees
* ``latex``, ``breaking``, ``printed``: LaTeX: text, long formulas, and the folder with the book
* ``site``, ``extension``, ``mentions``: the site, which Sphinx makes, with its search index
* ``reference``, ``guides``, ``gallery``, ``notebooks``: further pages of the site
* ``explorer``, ``devices``: the page *Explore a wall*
* ``place``: where a report is written

The look of a verdict, with its colour in the margin, is in `templates/symhaptic.sty` (print) and
`static/site.css` (site).
"""
