# Written by `symhaptic kernels` from the stable forms; do not edit.
from numpy import ufunc

discretize: ufunc
discretize_fractional: ufunc
is_stable: ufunc
unstable_roots: ufunc
stability_boundary: ufunc
max_stable_stiffness: ufunc
passivity_margin_at: ufunc
passivity_margin: ufunc
passivity_boundary: ufunc
max_passive_stiffness: ufunc
linear_limit: ufunc
