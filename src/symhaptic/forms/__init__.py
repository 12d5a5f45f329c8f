"""How is it computed?  Formulas in forms that lose no digits, made of entire functions.

Each stable form equals what ``model`` derives, is made of SymPy expressions and of entire functions
with their series and slopes, and says where its arguments may be.  Imports ``notation``, ``model``
and ``proof``; used by ``export``, which writes them as code, and by ``book``.
"""
