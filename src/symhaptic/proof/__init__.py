"""What can be decided, and what is proved?  Deciders, theorems and verdicts.

* ``theorems``: the kernel that makes theorems; its `judge` makes verdicts of them
* ``verdict``, ``settle``: the kinds of verdict; a theorem beside a published statement
* ``normal``, ``rewriting``, ``ring``: is an expression zero?
* ``series``: limits
* ``ball``, ``box``, ``enclose``, ``enclosed``, ``program``, ``plants``: numbers and boxes, in balls
* ``certificate``, ``recheck``: what was found, and checked again by another routine
* ``decide``, ``prove``, ``refute``, ``asked``: two formulas compared, for users too
* ``derivative``, ``roots``, ``values``, ``constants``, ``points``: exact values and derivatives
* ``shape``, ``names``, ``units``, ``budget``: forms, names, dimensions, the work that is allowed
* ``mutants``: formulas with one change

A decider answers yes, no or undecided.  Imports ``notation``, ``paper`` and ``model``; used by
``bounds``, ``book``, ``rocq`` and ``check``.
"""
