"""How is it said there?  Stable forms as source code in seven languages, and for controllers.

1. ``request`` checks what is asked for, and writes the folder.
2. ``passes`` turns a form into a routine, whose steps are ordered and whose rounding is fixed
   (``routine``), and joins calls that have steps in common.
3. ``library`` adds the routines that it calls.  They are in ``routines``, in the ``notation`` that
   all languages and precisions share.
4. ``branches`` moves each step to where its value is needed.
5. ``statements`` and one module a language (``targets`` lists them) write the text; ``language`` is
   what these have in common.
6. ``vectors``, ``rounding`` and ``readme`` add the self-test's numbers, the proofs and the text for
   people.

Imports ``notation``, ``model``, ``proof`` and ``forms``; used by ``scene`` and ``cli``, and it
writes ``kernels``.
"""
