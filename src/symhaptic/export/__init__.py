"""How do formulas become source code?  In seven languages, and for controllers.

1. ``request`` checks what is asked for, and writes the folder.
2. ``passes`` turns a form into a routine, whose steps are ordered and whose rounding is fixed
   (``routine``), and joins calls that have steps in common.
3. ``library`` adds the routines that it calls.  They are in ``routines``, in the ``notation`` that
   all languages and precisions share: series near zero, searches, root counts.
4. ``branches`` moves each step to where its value is needed.
5. ``statements`` and one module a language (``targets`` lists them) write the text; ``language`` is
   what these have in common, ``reserved`` the names that an export may not have, ``package`` what C
   and C++ have around it, compiler flags included.
6. ``vectors``, ``rounding`` and ``readme`` add the self-test's numbers, the proofs and the text for
   people.

``precision`` is what depends on the digits of a float, ``accuracy`` the largest errors that were
measured.  ``kernels`` writes the package's own functions.  Imports ``notation``, ``model`` and
``forms``; used by ``book``, ``scene``, ``bench`` and ``cli``.
"""
