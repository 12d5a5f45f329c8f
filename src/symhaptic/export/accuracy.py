"""What `benchmarks/accuracy.py` measured; a figure may only shrink."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symhaptic.export.precision import DOUBLE, SINGLE, Precision


@dataclass(frozen=True)
class Worst:
    """The largest error of a function, in units in the last place of its largest term."""

    error: float
    result: str
    at: tuple[float, ...]


GOALS: Mapping[str, float] = {
    "discretize": 2,
    "discretize_late": 4,
    "characteristic_polynomial": 4,
    "stability_boundary": 8,
    "max_stable_stiffness": 8,
    "passivity_margin_at": 4,
    "passivity_margin": 4,
    "passivity_boundary": 8,
    "max_passive_stiffness": 4,
    "linear_limit": 4,
}
"""Above this no record may be, but for those of ABOVE."""

ABOVE: Mapping[str, str] = {
    "max_stable_stiffness": "theta of a flat maximum next to pi, behind a small fraction: at "
    "gamma = 2.25 and delta = 3, where the maximum without delay leaves pi, and d = 0.001"
}
"""Where a goal is missed, and by what; alpha and beta there are right to their last place."""

MEASURED: Mapping[Precision, Mapping[str, Worst]] = {
    DOUBLE: {
        "discretize": Worst(1.9, "n0", (2.2731940433160336, 0.9310873290293593)),
        "characteristic_polynomial": Worst(
            2.56,
            "p1",
            (0.0006980673103032686, 0.0005654739734880385, 1.6609686903908483, 2.7743325555444116),
        ),
        "stability_boundary": Worst(
            6.9, "beta", (3.1415922552931597, 0.0004548376160178131, 1.0783864096689503e-12, 0.5)
        ),
        "passivity_margin_at": Worst(
            2.78,
            "margin",
            (
                5.656082778320403e-06,
                -0.0006012530388779724,
                2.0302928043059665e-06,
                6.498480076802493e-12,
                5586.0,
            ),
        ),
        "passivity_boundary": Worst(
            7.45, "alpha", (0.8156819328758241, 2.839045128421234e-11, 0.001)
        ),
        "max_passive_stiffness": Worst(2.86, "beta", (50.2653460409409, 750.0)),
        "linear_limit": Worst(1.58, "alpha", (0.03866909510578749, 0.03293205563116262, 0.1)),
    },
    SINGLE: {
        "discretize": Worst(1.94, "n0", (275.2425231933594, 32.401248931884766)),
        "characteristic_polynomial": Worst(
            3.1,
            "p2",
            (-2.0679142475128174, 0.01999221183359623, 1.5685877799987793, 2.5047402381896973),
        ),
        "stability_boundary": Worst(
            7.68, "beta", (1.5273758172988892, 130.82838439941406, 3.07670590393716e-11, 0.5)
        ),
        "passivity_margin_at": Worst(
            3.31,
            "margin",
            (
                0.6031221151351929,
                -0.09897477179765701,
                -0.015822606161236763,
                0.007490755524486303,
                0.0010000000474974513,
            ),
        ),
        "passivity_boundary": Worst(
            5.87, "alpha", (1.0298492908477783, 0.004492504987865686, 0.10000000149011612)
        ),
        "max_passive_stiffness": Worst(3.06, "beta", (0.005855832248926163, 5263.0)),
        "linear_limit": Worst(
            1.8, "alpha", (0.7689235210418701, 3.2639174461364746, 0.10000000149011612)
        ),
    },
}
"""The worst results of 2 500 to 5 000 points a function, of stability_boundary in double 20 000, of
what is searched for 700 to 1 000; those of earlier records (up to 100 000 points) among them."""

DERIVATIVES: Mapping[str, float] = {
    "discretize_and_derivatives": 7.31,  # n0_by_gamma; n1_by_gamma 4.85, others 4.11
    "characteristic_polynomial_and_derivatives": 7.83,
    "stability_boundary_and_derivatives": 8.69,  # beta_by_gamma
    "passivity_margin_at_and_derivatives": 8.51,
    "passivity_boundary_and_derivatives": 11.47,  # alpha_by_d; others 9.83
    "max_passive_stiffness_and_derivatives": 4.84,
    "linear_limit_and_derivatives": 2.25,
}
"""The same of the derivatives with respect to all arguments, of 10 000 points each."""
