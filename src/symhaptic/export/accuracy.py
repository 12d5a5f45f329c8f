"""What `benchmarks/accuracy.py` measured; a figure may only shrink."""

MEASURED: dict[str, float] = {
    "discretize": 2.85,  # n0; n1 2.05, a 1.89, e 0.51
    "characteristic_polynomial": 3.38,
    "stability_boundary": 7.89,
    "passivity_margin_at": 3.54,
    "passivity_margin": 3.0,
    "passivity_boundary": 7.95,
    "max_passive_stiffness": 3.17,
    "linear_limit": 2.67,
}
"""Units in the last place of the largest term: the worst result of 100 000 points each."""

DERIVATIVES: dict[str, float] = {}
"""The same of the derivatives with respect to all arguments, of 10 000 points each."""
