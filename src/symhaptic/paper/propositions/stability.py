"""The claims of Sec. IV-D: stability."""
