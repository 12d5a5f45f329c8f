"""Chapters, book, figures and their PDF.  Knows layout, no mathematics."""
