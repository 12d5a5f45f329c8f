"""The committed measurement as a chapter: its record, its tables and its words."""
