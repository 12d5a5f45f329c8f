"""Deciding statements: exact zero tests, exact series, sign certificates, enclosures, units."""
