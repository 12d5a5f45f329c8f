"""What `benchmarks/accuracy.py` measured; a figure may only shrink where it was measured."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from symhaptic.export.precision import DOUBLE, SINGLE, Precision

MEASURED_ON = "glibc 2.36 x86_64 96a68562"
"""Whose sines and exponentials the figures rest on, as `tests/libm.py` tells it; with another
library they differ in the last places, and only the goals hold."""

MUSL = "musl 1.2.3"
"""The other library that they were measured with, as `tests/libm.py` tells it."""


@dataclass(frozen=True)
class Worst:
    """The largest error of a function, in units in the last place of its largest term."""

    error: float
    result: str
    at: tuple[float, ...]
    remark: str = ""
    """What the figure alone does not say."""


_AROUND = (
    "Found by a search around the worst points, too: it found no worse one than the 100 000 points."
)
_AROUND_AT = "The worst of three searches around the worst points of 100 000 each."
_NEXT_TO_PI = (
    "Below one period of delay theta leaves pi like the square root of a sum, whose largest term "
    "counts there: theta is off by up to {} rad where it leaves pi, alpha and beta are not."
)

_WHOLE_TURNS = (
    "Next to gamma = (2 pi k)^2{}, n1 is right to 2 last places of its own for the float gamma "
    "that is given, a last place of which may change it altogether; so is n0, but with a part of "
    "delta of the last place of n1 + n0 where it changes its sign, at delta near "
    "(sqrt(gamma) - 2 pi k)^2."
)

MEASURED: Mapping[Precision, Mapping[str, Worst]] = {
    DOUBLE: {
        "discretize": Worst(
            1.94, "n0", (1.4304512041558484, 2.531980525132481), _WHOLE_TURNS.format("")
        ),
        "discretize_fractional": Worst(
            2.95, "m1", (5.776819181669012, 0.4262274231587848, 0.744103990624944)
        ),
        "characteristic_polynomial": Worst(
            3.26,
            "p1",
            (1.4855576081801212, 20.936278745160593, 419.9052463523073, 7.224481367830295e-09),
        ),
        "stability_boundary": Worst(
            7.46,
            "beta",
            (0.9798120890688231, 339.5422498593508, 48.56881017683488, 1000000.0),
            _AROUND,
        ),
        "passivity_margin_at": Worst(
            3.32,
            "margin",
            (
                1.4530171007793746,
                6.34338817450219e-06,
                0.015961034010999006,
                0.000160423766345912,
                0.09999097608772921,
            ),
            _AROUND_AT,
        ),
        "passivity_boundary": Worst(
            6.9, "beta", (0.001163156122722045, 3.344357597164237e-07, 1220.0)
        ),
        "max_passive_stiffness": Worst(5.68, "beta", (5.452144812319781, 0.3408052141474169)),
        "linear_limit": Worst(
            2.17, "alpha", (0.003411095303636187, 32.84340004976249, 1.6193805311694287)
        ),
        "passivity_margin": Worst(
            3.08,
            "margin",
            (0.06030178270445182, 33.54602749472617, 1.5021300258299932, 0.8085033174070179),
        ),
        "max_stable_stiffness": Worst(
            5.01, "theta", (1.8988060244571752, 3.1375754372322, 0.0), _NEXT_TO_PI.format("2e-8")
        ),
    },
    SINGLE: {
        "discretize": Worst(
            1.79,
            "n0",
            (2.538376808166504, 3.280378818511963),
            _WHOLE_TURNS.format(", for gamma up to 2^24")
            + " Beyond, it is the last place of 1/gamma that counts.",
        ),
        "discretize_fractional": Worst(
            2.09, "m1", (1.4526104927062988, 1.319366693496704, 0.006937236525118351)
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
            3.63,
            "margin",
            (
                0.14436283707618713,
                69.0941390991211,
                -0.03279636427760124,
                3.9436419010162354,
                117096.0,
            ),
            _AROUND_AT,
        ),
        "passivity_boundary": Worst(
            6.4, "beta", (0.00042266599484719336, 28.381996154785156, 899.0)
        ),
        "max_passive_stiffness": Worst(5.33, "alpha", (3.4068586826324463, 10.871851921081543)),
        "linear_limit": Worst(
            2.07, "alpha", (0.5071318745613098, 1.933349994942546e-05, 3.668694257736206)
        ),
        "passivity_margin": Worst(
            3.09,
            "margin",
            (0.000462411786429584, 0.11287442594766617, 0.01654542051255703, 692.1644287109375),
        ),
        "max_stable_stiffness": Worst(
            4.44, "theta", (1.4393329620361328, 3.022043228149414, 0.0), _NEXT_TO_PI.format("8e-4")
        ),
    },
}
"""The worst results of 100 000 points a function; of the device, its polynomial, the stability
boundary and the linear limit in double precision also of the points that
`benchmarks/accuracy.py --around` goes on to from the worst ones."""

MEASURED_WITH_MUSL: Mapping[Precision, Mapping[str, Worst]] = {
    DOUBLE: {
        "discretize": Worst(1.9, "n0", (2.2731940433160336, 0.9310873290293593)),
        "discretize_fractional": Worst(
            2.95, "m1", (5.776819181669012, 0.4262274231587848, 0.744103990624944)
        ),
        "characteristic_polynomial": Worst(
            2.87,
            "p1",
            (-0.0002271038888627423, -31.49702949002001, 1.65094394271264, 2.569781269067577),
        ),
        "stability_boundary": Worst(
            7.46, "beta", (0.9798120890688231, 339.5422498593508, 48.56881017683488, 1000000.0)
        ),
        "passivity_margin_at": Worst(
            2.84,
            "margin",
            (
                0.8897575709675538,
                26.890425268036253,
                -2.7203099625703936e-06,
                0.5642454470103901,
                16.60259111673583,
            ),
        ),
        "passivity_boundary": Worst(5.9, "alpha", (0.26179936687342953, 3.5499298761608458, 11.0)),
        "max_passive_stiffness": Worst(5.55, "alpha", (5.178300807331123, 1.1930736561331874)),
        "linear_limit": Worst(
            2.07, "alpha", (6.914257587776434e-05, 9.307974292748303e-12, 0.6950657871742972)
        ),
        "passivity_margin": Worst(
            3.08,
            "margin",
            (0.06030178270445182, 33.54602749472617, 1.5021300258299932, 0.8085033174070179),
        ),
        "max_stable_stiffness": Worst(4.55, "theta", (1.5141374588643963, 3.243929256215032, 0.0)),
    },
    SINGLE: {
        "discretize": Worst(1.79, "n0", (2.538376808166504, 3.280378818511963)),
        "discretize_fractional": Worst(
            2.73, "m1", (6.303262710571289, 0.31897521018981934, 0.6518388390541077)
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
            6.38, "beta", (3.141592264175415, 0.0, 3.7756059169769287, 15729.0)
        ),
        "passivity_margin_at": Worst(
            2.89,
            "margin",
            (
                0.6155641674995422,
                -51.088714599609375,
                -0.9555187225341797,
                0.18117335438728333,
                6.0,
            ),
        ),
        "passivity_boundary": Worst(
            6.75, "alpha", (2.459030866622925, 2.9691402912139893, 0.27490442991256714)
        ),
        "max_passive_stiffness": Worst(5.83, "alpha", (0.0090215178206563, 0.14540055394172668)),
        "linear_limit": Worst(
            2.07, "alpha", (0.5071318745613098, 1.933349994942546e-05, 3.668694257736206)
        ),
        "passivity_margin": Worst(
            2.45,
            "margin",
            (11.741888999938965, 28.544145584106445, 35.74428176879883, 88.15802001953125),
        ),
        "max_stable_stiffness": Worst(4.44, "theta", (1.4393329620361328, 3.022043228149414, 0.0)),
    },
}
"""The same with the functions of musl, in whose place the figures rest on ``MUSL``: the worst of
100 000 points a function, of the largest passive stiffness in single precision 50 000; in double
precision of the passivity boundary 30 000, of the largest passive stiffness 20 000 and of the
largest stable one 15 000."""

DERIVATIVES: Mapping[Precision, Mapping[str, Worst]] = {
    DOUBLE: {
        "discretize": Worst(6.56, "n0_by_gamma", (1.3662385124568999, 4.681881812359408)),
        "discretize_fractional": Worst(
            5.74, "m1_by_gamma", (0.0, 4.42549577368435e-05, 0.8752492116968561)
        ),
        "characteristic_polynomial": Worst(
            6.78,
            "p0_by_gamma",
            (1.83368981270156, 1.1149537645461917e-05, 5.638904250123087, 4.9358669197294605),
        ),
        "stability_boundary": Worst(
            8.3,
            "alpha_by_theta",
            (3.1415926186887253, 15.888932096690953, 1.3089371299025449e-05, 1.0),
        ),
        "passivity_margin_at": Worst(
            7.19,
            "margin_by_d",
            (
                1.7513328437201674,
                -1.9163864274458784,
                -1.3671230737367105e-06,
                29.342073130153974,
                2.0,
            ),
        ),
        "passivity_margin": Worst(
            18.74,
            "margin_by_beta",
            (
                0.00045884904594419457,
                4.599535368638165e-05,
                0.13473898440854096,
                0.13257046421863627,
            ),
        ),
        "passivity_boundary": Worst(
            6.13,
            "beta_by_delta",
            (2.4741407306377035, 44.31806647410914, 0.26977120326838444),
        ),
        "max_passive_stiffness": Worst(
            4.33, "alpha_by_delta", (33.79599874658609, 415.93931699793706)
        ),
        "max_stable_stiffness": Worst(
            2.26, "alpha_by_delta", (0.0, 1.537936648422959, 5.6103714604375545)
        ),
        "linear_limit": Worst(
            3.52, "alpha_by_d", (0.000263936012945385, 0.017974309151175802, 3.8360398115847967)
        ),
    },
    SINGLE: {
        "discretize": Worst(5.21, "n1_by_gamma", (1.6330372095108032, 5.597702980041504)),
        "discretize_fractional": Worst(
            6.14,
            "m1_by_gamma",
            (0.000664557155687362, 0.008879425935447216, 0.08418747782707214),
        ),
        "characteristic_polynomial": Worst(
            4.99,
            "p2_by_gamma",
            (-11.078564643859863, -3.739474058151245, 1.6330372095108032, 5.597702980041504),
        ),
        "passivity_margin_at": Worst(
            7.07,
            "margin_by_theta",
            (
                1.2517658472061157,
                3.8543965816497803,
                0.00012282586249057204,
                3.191879659425467e-05,
                0.18985220789909363,
            ),
        ),
        "passivity_boundary": Worst(
            5.08, "alpha_by_delta", (0.02854604460299015, 2.3772430419921875, 100.0)
        ),
        "max_passive_stiffness": Worst(
            4.27, "alpha_by_delta", (5.6969099044799805, 0.10936619341373444)
        ),
        "max_stable_stiffness": Worst(
            2.12, "alpha_by_delta", (0.024949656799435616, 0.315909206867218, 8.0)
        ),
        "linear_limit": Worst(
            3.20, "alpha_by_d", (0.17839649319648743, 8.253727912902832, 15.959040641784668)
        ),
    },
}
"""The worst derivatives of 10 000 points a function, by all arguments by which there are some; of
the largest stable stiffness 1500 in double precision.

Two have no record in single precision: of the stability boundary those by delta and d, which lose
digits to underflow where exp(-delta/2) over the square of gamma is below the smallest normal float,
and of the margin at its worst angle, where the wall is so nearly as good at all angles that a float
does not tell which is the worst one."""
