"""The claims of Sec. VI and the slips of the text."""
