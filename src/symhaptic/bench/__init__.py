"""Speed against error: every function measured, beside exact values and beside its peers."""
