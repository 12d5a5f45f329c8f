"""How is it said there?  Stable forms as source code in seven languages, and for controllers.

A form becomes a routine of ordered steps with branches, which one module for each target language
writes out; with a self-test, a README and the error that was measured.  Imports ``notation``,
``model``, ``proof`` and ``forms``; used by ``scene`` and ``cli``, and it writes ``kernels``.
"""
