"""What `benchmarks/accuracy.py` measured; a figure may only shrink."""

MEASURED: dict[str, float] = {}
"""Units in the last place of the largest term, over at least 10^5 points beside exact values."""
