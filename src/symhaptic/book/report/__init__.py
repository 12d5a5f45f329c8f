"""The report: pages as trees (one walk), a writer each for print and for the site, and the files."""
