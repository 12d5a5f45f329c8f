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
"""Above this no record may be, but for those that REMARKS explains."""

REMARKS: Mapping[str, str] = {
    "stability_boundary": "Found by a search around the worst points: beta with a stiff spring; "
    "the worst of 100 000 points is 7.46.",
    "max_stable_stiffness": "Below one period of delay theta leaves pi like the square root of a "
    "sum, whose largest term counts there: theta is off by up to 2e-8 rad where it leaves pi (8e-4 "
    "in single precision), alpha and beta are not.",
}
"""Why a goal is missed, or what a figure does not say."""

MEASURED: Mapping[Precision, Mapping[str, Worst]] = {
    DOUBLE: {
        "discretize": Worst(1.94, "n0", (1.4304512041558484, 2.531980525132481)),
        "discretize_late": Worst(
            2.95, "m1", (5.776819181669012, 0.4262274231587848, 0.744103990624944)
        ),
        "characteristic_polynomial": Worst(
            3.26,
            "p1",
            (1.4855576081801212, 20.936278745160593, 419.9052463523073, 7.224481367830295e-09),
        ),
        "stability_boundary": Worst(
            9.26, "beta", (0.9402032461679584, 140.70996940645324, 1.0797515961720216e-06, 82.0)
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
            6.9, "beta", (0.001163156122722045, 3.344357597164237e-07, 1220.0)
        ),
        "max_passive_stiffness": Worst(6.83, "beta", (24.770446902362266, 9.546608463956133)),
        "linear_limit": Worst(
            2.17, "alpha", (0.003411095303636187, 32.84340004976249, 1.6193805311694287)
        ),
        "passivity_margin": Worst(
            3.04,
            "margin",
            (0.012604361782097184, 0.000379377461155146, 8.050945880708105e-07, 0.001),
        ),
        "max_stable_stiffness": Worst(5.01, "theta", (1.8988060244571752, 3.1375754372322, 0.0)),
    },
    SINGLE: {
        "discretize": Worst(1.79, "n0", (2.538376808166504, 3.280378818511963)),
        "discretize_late": Worst(
            2.59, "m1", (1.4526104927062988, 1.319366693496704, 0.006937236525118351)
        ),
        "characteristic_polynomial": Worst(
            2.92,
            "p1",
            (
                6.58954813843593e-05,
                1.5010714378149714e-06,
                0.003174767829477787,
                1.3089077472686768,
            ),
        ),
        "stability_boundary": Worst(
            7.33, "alpha", (1.304222583770752, 0.8916881680488586, 2.196506977081299, 1.0)
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
            6.4, "beta", (0.00042266599484719336, 28.381996154785156, 899.0)
        ),
        "max_passive_stiffness": Worst(6.18, "beta", (44.81534957885742, 272.5945739746094)),
        "linear_limit": Worst(
            2.07, "alpha", (0.5071318745613098, 1.933349994942546e-05, 3.668694257736206)
        ),
        "passivity_margin": Worst(
            3.09,
            "margin",
            (0.000462411786429584, 0.11287442594766617, 0.01654542051255703, 692.1644287109375),
        ),
        "max_stable_stiffness": Worst(4.44, "theta", (1.4393329620361328, 3.022043228149414, 0.0)),
    },
}
"""The worst results of 100 000 points a function; of the device, its polynomial, the stability
boundary and the linear limit in double precision also of the points that
`benchmarks/accuracy.py --around` goes on to from the worst ones."""

DERIVATIVES: Mapping[str, float] = {
    "discretize_and_derivatives": 7.31,  # n0_by_gamma; n1_by_gamma 4.85, others 4.11
    "characteristic_polynomial_and_derivatives": 7.83,
    "stability_boundary_and_derivatives": 9.17,  # alpha_by_delta; by theta 8.95
    "passivity_margin_at_and_derivatives": 8.51,
    "passivity_boundary_and_derivatives": 6.9,  # beta
    "max_passive_stiffness_and_derivatives": 5.44,  # beta; beta_by_delta 5.03
    "linear_limit_and_derivatives": 2.25,
}
"""The same of the derivatives by all arguments by which there are some, of 10 000 points each; of
the stability boundary 6000, of the passive walls 3000."""
