"""In which form does a formula keep its digits?  Stable forms, made of entire functions.

* ``stable``, ``form``: the list of all forms; what a form is, and where it is defined
* ``device_forms``, ``passivity_forms``, ``stability_forms``: the forms of each subject, by scene
* ``fractional_delay``, ``required_damping``, ``response``, ``max_stiffness_slope``,
  ``stiffest_passive``: formulas that these share
* ``entire``: the entire functions, such as n1, and their derivatives
* ``implicit``, ``root_count``: functions that are searched for or counted
* ``derivatives``, ``values``: derivatives of forms, and values in many digits

Each form equals what ``model`` derives; a chapter of part 9 proves it.  How a float computes an
entire function, with a series near zero, is in `export/routines`.  Imports ``notation`` and
``model``; used by ``export``, ``book``, ``scene``, ``bench`` and ``cli``.
"""
