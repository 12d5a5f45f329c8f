"""Theorems that more than one chapter applies, each made once by the rules of the kernel."""
