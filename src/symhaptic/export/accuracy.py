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
    "max_passive_stiffness": 8,
    "linear_limit": 4,
}
"""Above this no record may be, but for those of ABOVE."""

ABOVE: Mapping[str, str] = {
    "stability_boundary": "alpha next to pi behind a thousandth of a period, where it has M(-1) "
    "squared: found by a search; the worst of 100 000 points is beta with 7.40",
    "max_stable_stiffness": "theta of a flat maximum next to pi, behind a small fraction: at "
    "gamma = 2.25 and delta = 3, where the maximum without delay leaves pi, and d = 0.001",
}
"""Where a goal is missed, and by what; at a flat maximum alpha and beta are right."""

MEASURED: Mapping[Precision, Mapping[str, Worst]] = {
    DOUBLE: {
        "discretize": Worst(1.9, "n0", (2.2731940433160336, 0.9310873290293593)),
        "discretize_late": Worst(
            3.43, "m1", (5.174199245491099, 0.7492981573874902, 0.9718182105024766)
        ),
        "characteristic_polynomial": Worst(
            3.13,
            "p1",
            (0.0011849210939711555, 0.0007502812362385499, 1.4862750573572336, 2.4382576216283915),
        ),
        "stability_boundary": Worst(
            9.59,
            "alpha",
            (
                3.1415924918150595,
                0.04029236126616619,
                1.5850285438641733e-07,
                0.0010012853150034595,
            ),
        ),
        "passivity_margin_at": Worst(
            3.24,
            "margin",
            (
                3.945100806677093e-06,
                1.7963627656099195,
                -0.00042809175993313884,
                13.148669115668456,
                1115.0,
            ),
        ),
        "passivity_boundary": Worst(
            6.1, "alpha", (2.4741407306377035, 44.31806647410914, 0.26977120326838444)
        ),
        "max_passive_stiffness": Worst(6.66, "beta", (0.00027015134263007535, 2070.9917543718147)),
        "linear_limit": Worst(
            2.07, "alpha", (6.914257587776434e-05, 9.307974292748303e-12, 0.6950657871742972)
        ),
        "passivity_margin": Worst(
            1.94,
            "margin",
            (0.4570479406847814, 3.723081191525364e-05, 0.005872870935564926, 96.05400743175716),
        ),
        "max_stable_stiffness": Worst(62.75, "theta", (2.25, 3.0, 0.001)),
    },
    SINGLE: {
        "discretize": Worst(1.94, "n0", (275.2425231933594, 32.401248931884766)),
        "discretize_late": Worst(
            3.47, "m1", (5.2519145011901855, 0.6701744794845581, 0.36009857058525085)
        ),
        "characteristic_polynomial": Worst(
            3.1,
            "p2",
            (-2.0679142475128174, 0.01999221183359623, 1.5685877799987793, 2.5047402381896973),
        ),
        "stability_boundary": Worst(
            7.77, "beta", (2.774841070175171, 1.7941627502441406, 4.693538188934326, 100.0)
        ),
        "passivity_margin_at": Worst(
            3.41,
            "margin",
            (
                0.008298058994114399,
                0.4753524959087372,
                1.6212248802185059,
                3.4870453746727037e-10,
                64810.0,
            ),
        ),
        "passivity_boundary": Worst(
            5.93, "beta", (0.010557831265032291, 6.075566265362209e-12, 100.0)
        ),
        "max_passive_stiffness": Worst(7.5, "beta", (47.95070266723633, 947.6818237304688)),
        "linear_limit": Worst(
            2.07, "alpha", (0.5071318745613098, 1.933349994942546e-05, 3.668694257736206)
        ),
        "passivity_margin": Worst(
            3.09,
            "margin",
            (0.000462411786429584, 0.11287442594766617, 0.01654542051255703, 692.1644287109375),
        ),
        "max_stable_stiffness": Worst(
            42.34, "theta", (7.552922248840332, 1.4621795415878296, 0.0010000000474974513)
        ),
    },
}
"""The worst results of 100 000 points a function; of those that touch a searched angle 20 000 in
double and 50 000 in single precision, of what is searched for 4000 and 20 000; those of earlier
records among them, and of 160 points around each of the boundary's worst ones."""

DERIVATIVES: Mapping[str, float] = {
    "discretize_and_derivatives": 7.31,  # n0_by_gamma; n1_by_gamma 4.85, others 4.11
    "characteristic_polynomial_and_derivatives": 7.83,
    "stability_boundary_and_derivatives": 11.34,  # alpha_by_d next to pi; by gamma 8.89
    "passivity_margin_at_and_derivatives": 8.51,
    "passivity_boundary_and_derivatives": 6.13,  # beta_by_delta
    "max_passive_stiffness_and_derivatives": 6.66,  # beta; beta_by_delta 5.35
    "linear_limit_and_derivatives": 2.25,
}
"""The same of the derivatives by all arguments by which there are some, of 10 000 points each."""
