"""The report: one walk over a page, a writer for print and one for the site, and their files."""
