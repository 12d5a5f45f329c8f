"""What can be asked on the command line?  The commands, each thin: it parses, calls, prints.

Imports all rooms; used by the entry point ``symhaptic`` and by ``python -m symhaptic``.
"""
