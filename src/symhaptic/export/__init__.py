"""Stable forms as source code: one module per target language, over one list of operations."""
