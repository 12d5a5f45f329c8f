"""The claims of Sec. IV-E: the linear condition."""
