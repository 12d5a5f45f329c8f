"""The smallest model of a loop whose error is proved to be small."""
