"""What can be asked on the command line?  The commands: each parses, calls and prints.

* ``check``, ``controller``, ``limits``, ``mutants``, ``report``, ``verify``: the commands of these
  names
* ``computing``: the commands `bench`, `export`, `jury`, `kernels` and `trace`
* ``rocq``: `verify --rocq`
* ``given``, ``shared``: the options and messages that several commands have
* ``main``: the entry point; what becomes of errors

The exit status is 2 after a bad input, and 1 if a result is not as it should be; the file of the
command sets it.  Imports most rooms; used by the entry point ``symhaptic`` and by
``python -m symhaptic``.
"""
