"""What `benchmarks/accuracy.py` measured; a figure may only shrink."""

MEASURED: dict[str, float] = {
    "discretize": 2.85,  # n0; n1 2.05, a 1.89, e 0.51
    "discretize_late": 3.0,
    "characteristic_polynomial": 3.38,
    "stability_boundary": 7.89,
    "max_stable_stiffness": 19.6,  # theta, which is flat without delay; alpha 1.1, beta 1.0
    "passivity_margin_at": 3.54,
    "passivity_margin": 3.0,
    "passivity_boundary": 7.95,
    "max_passive_stiffness": 3.7,
    "linear_limit": 2.67,
}
"""Units in the last place of the largest term: the worst result of 100 000 points each."""
