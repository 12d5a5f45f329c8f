"""Compilers that join a product and a sum in one instruction, as gfortran and gcc do by default.

Both do so where the processor has fused multiplication: on each ARM of 64 bits, and elsewhere with
-march=native.
"""

import platform
import re
import subprocess
from pathlib import Path

import mpmath
import oracle
import pytest
from export.test_languages import needs, run

from symhaptic.export import request
from symhaptic.export.precision import PRECISIONS
from symhaptic.export.targets import TARGETS

pytestmark = pytest.mark.ci

UNSTABLE = {
    "double": [
        (161527781748.0814, -6.904392709664849e16, 278559.7146134357, 8.068987139502359e-12, 0.0),
        (
            4.47587176554127e16,
            -1.1224332911810312e16,
            138534870088541.36,
            0.024838338911242343,
            0.0,
        ),
    ],
    "single": [
        (7612.50390625, -118191.4921875, 988.18115234375, 0.01395196933299303, 0.0),
        (-17293.84765625, -107456.546875, 17409.591796875, 1.1719253052433487e-05, 3.0),
    ],
}
"""Walls that Fortran called stable: next to whole half turns of the device in a period."""
CRITICAL = {
    "double": (86134.47386720502, 586.9441584378429),
    "single": (4562.21728515625, 135.08837890625),
}
"""Next to critical damping: n0 needs the square of delta/2, rounded, before gamma is subtracted."""
NEAR_PI = 3.141592025756836, 0.02618967555463314, 2.8793745274376115e-13
"""The angle, the damping and the delay of a passive wall; single precision."""


def flags():
    """What makes the compiler use fused multiplication here."""
    if platform.machine() in {"aarch64", "arm64"}:
        return []
    known = Path("/proc/cpuinfo")
    if not known.exists() or not re.search(r"^flags.*\bfma\b", known.read_text(), re.MULTILINE):
        pytest.skip("this processor has no fused multiplication: no program is tried that uses it")
    return ["-mfma"]


def built(language, precision, names, folder):
    _, files = request.built(TARGETS[language].at(PRECISIONS[precision]), request.chosen(names))
    request.write(files, folder / "out")
    return folder / "out"


IN_FORTRAN = """program main
  use, intrinsic :: iso_fortran_env, only: wp => KIND
  use haptic
  implicit none
  real(wp) :: n1, n0, a, e
  call discretize(PLANT, n1, n0, a, e)
  print *, n0
WALLS
end program main
"""


@pytest.mark.parametrize("precision", PRECISIONS)
def test_no_unstable_wall_counts_as_stable_in_fortran(precision, tmp_path):
    needs("gfortran")
    fused = flags()
    folder = built("fortran", precision, ["is_stable", "discretize"], tmp_path)

    def written(values):
        return ", ".join(f"{value!r}_wp" for value in values)

    walls = "\n".join(f"  print *, is_stable({written(w)})" for w in UNSTABLE[precision])
    text = IN_FORTRAN.replace("KIND", "real64" if precision == "double" else "real32")
    text = text.replace("PLANT", written(CRITICAL[precision])).replace("WALLS", walls)
    (folder / "main.f90").write_text(text)
    source = ["src/haptic.f90", "main.f90"]
    run(["gfortran", "-std=f2008", "-O3", *fused, "-o", "main", *source], folder)
    n0, *found = run(["./main"], folder).split()
    with mpmath.workdps(60):
        exact = oracle.numbers(*map(mpmath.mpf, CRITICAL[precision]))[1]
    assert float(n0) == pytest.approx(float(exact), rel=1e-14 if precision == "double" else 1e-6)
    assert found == ["F"] * len(UNSTABLE[precision])


@pytest.mark.parametrize("wall", [w for walls in UNSTABLE.values() for w in walls])
def test_they_are_not_stable(wall):
    assert oracle.all_inside(*wall) is False


@pytest.mark.parametrize("precision", PRECISIONS)
def test_the_self_test_in_fortran_fails_with_flags_that_break_it(precision, tmp_path):
    """Those that the README names; with fused multiplication it passes."""
    needs("gfortran")
    folder = built("fortran", precision, [], tmp_path)
    other = {"double": "-freal-8-real-10", "single": "-freal-4-real-8"}[precision]
    known = dict.fromkeys(["", *flags()], 0)
    known |= dict.fromkeys(["-ffast-math", "-funsafe-math-optimizations", other], 1)
    for flag, status in known.items():
        command = ["gfortran", "-O3", *flag.split(), "-o", "selftest"]
        run([*command, "src/haptic.f90", "test/selftest.f90"], folder)
        done = subprocess.run(["./selftest"], cwd=folder, capture_output=True, check=False)
        assert done.returncode == status, flag


IN_C = """#include "haptic.h"
#include <stdio.h>
int main(void) {
    float alpha, beta;
    haptic_passivity_boundary(THETA, DELTA, D, &alpha, &beta);
    printf("%.9g", (double)alpha);
}
"""


@pytest.mark.parametrize("language", ["c", "microcontroller"])
def test_no_passive_wall_is_stiffer_than_twice_the_damping(language, tmp_path):
    """At the angles 0 and pi a wall without delay needs alpha/2 - beta and alpha/2 + beta."""
    needs("gcc")
    fused = flags()
    folder = built(language, "single", ["passivity_boundary"], tmp_path)
    text = IN_C
    for name, value in zip(("THETA", "DELTA", "D"), NEAR_PI, strict=True):
        text = re.sub(rf"\b{name}\b", f"{value!r}f", text)
    (folder / "main.c").write_text(text)
    run(["gcc", "-O3", *fused, "-o", "main", "main.c", "haptic.c", "-lm"], folder)
    alpha = float(run(["./main"], folder))
    assert alpha == pytest.approx(2 * NEAR_PI[1], rel=1e-5)
