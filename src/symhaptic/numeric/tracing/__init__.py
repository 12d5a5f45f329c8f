"""Boundaries, regions and extremes in numbers; and the paper's grid, to compare with."""
