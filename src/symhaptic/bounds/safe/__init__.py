"""The walls that are stable for every arm of a range, proved by enclosure and checked again."""
