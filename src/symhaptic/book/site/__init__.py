"""The book as a web site: the same chapters from the same pages, made by Sphinx, with MathML."""
