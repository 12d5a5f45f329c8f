"""What `benchmarks/accuracy.py` measured; a figure may only shrink."""

MEASURED: dict[str, float] = {
    "discretize": 2.85,  # n0; n1 2.05, a 1.89, e 0.51
    "characteristic_polynomial": 3.38,
    "stability_boundary": 7.89,
    "passivity_margin": 3.54,
    "passivity_boundary": 7.95,
    "max_passive_stiffness": 3.17,
    "linear_limit": 2.67,
}
"""Units in the last place of the largest term: the worst result of 100 000 points each."""

DERIVATIVES: dict[str, float] = {
    "discretize_and_derivatives": 7.31,  # n0_by_gamma; n1_by_gamma 4.85, others 4.11
    "characteristic_polynomial_and_derivatives": 7.83,
    "stability_boundary_and_derivatives": 8.69,  # beta_by_gamma
    "passivity_margin_and_derivatives": 8.51,
    "passivity_boundary_and_derivatives": 11.47,  # alpha_by_d; others 9.83
    "max_passive_stiffness_and_derivatives": 4.84,
    "linear_limit_and_derivatives": 2.15,
}
"""The same of the derivatives with respect to all arguments, of 10 000 points each."""
