"""How large is it to any number of digits?  Values and root counts in ball arithmetic.

From matrix exponentials and the formulas of textbooks, by python-flint; nothing here comes from the
package's own forms.  Imports nothing; used by ``numeric`` where an accuracy is asked for, and by
``bounds``, ``bench`` and ``check``.
"""
