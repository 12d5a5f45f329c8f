"""Exports as packages: built, tested and installed with the tools of their language, then used."""

import math
import shutil
import tomllib

import pytest
from export.covering import every_value, one_of
from export.test_languages import LIBM, exported, needs, run

import symhaptic
from symhaptic.export import request
from symhaptic.export.package import FLAGS

pytestmark = pytest.mark.ci

WALL = ["is_stable", "max_stable_stiffness", "max_passive_stiffness", "passivity_margin"]

IN_CMAKE = """cmake_minimum_required(VERSION 3.15)
project(user LANGUAGES C CXX)
find_package(haptic 0.1 REQUIRED)
add_executable(user main.cpp)
target_link_libraries(user PRIVATE haptic::haptic)
"""

USERS = {
    "c": """#include <haptic.h>
int main() { return haptic_is_stable(.01, .1, .001, .02, 1) ? 0 : 1; }
""",
    "cpp": """#include <haptic.hpp>
int main() {
    static_assert(noexcept(haptic::is_stable(.01, .1, .001, .02, 1)));
    return haptic::is_stable(.01, .1, .001, .02, 1) ? 0 : 1;
}
""",
}


@pytest.fixture(scope="module")
def folders(tmp_path_factory):
    """An export to each of both."""
    place = tmp_path_factory.mktemp("package")
    return {language: exported(language, place / language, WALL) for language in USERS}


@pytest.fixture(scope="module", params=USERS)
def installed(request, folders):
    """The language, and the folder of its export, which is installed into its folder ``there``."""
    needs("cmake", "make", "gcc", "g++")
    folder = folders[request.param]
    run(["cmake", "-B", "build", "-DCMAKE_INSTALL_LIBDIR=lib"], folder)
    run(["cmake", "--build", "build"], folder)
    said = run(["ctest", "--test-dir", "build"], folder)
    assert "100% tests passed" in said
    run(["cmake", "--install", "build", "--prefix", str(folder / "there")], folder)
    return request.param, folder


@pytest.mark.slow
def test_cmake_finds_it(installed, tmp_path):
    language, folder = installed
    (tmp_path / "main.cpp").write_text(USERS[language])
    (tmp_path / "CMakeLists.txt").write_text(IN_CMAKE)
    run(["cmake", "-B", "build", f"-DCMAKE_PREFIX_PATH={folder / 'there'}"], tmp_path)
    run(["cmake", "--build", "build"], tmp_path)
    run(["build/user"], tmp_path)


@pytest.mark.slow
def test_pkg_config_finds_it(installed, tmp_path, monkeypatch):
    needs("pkg-config")
    language, folder = installed
    monkeypatch.setenv("PKG_CONFIG_PATH", str(folder / "there" / "lib" / "pkgconfig"))
    flags = ["pkg-config", "--cflags", "--libs"]
    (tmp_path / "main.cpp").write_text(USERS[language])
    found = run([*flags, "haptic"], tmp_path).split()
    run(["g++", "-std=c++17", "-o", "user", "main.cpp", *found], tmp_path)
    run(["./user"], tmp_path)


@pytest.mark.slow
@pytest.mark.parametrize("language", one_of(USERS, "c"))
def test_nothing_is_undefined(language, folders):
    """Neither the self-test nor the controller reads or writes where it must not."""
    needs("gcc", "g++")
    folder = folders[language]
    flags = ["-g", "-O1", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]
    compiler, standard = {"c": ("gcc", "c99"), "cpp": ("g++", "c++17")}[language]
    for program in ("selftest", "example"):
        if (folder / f"{program}.{language}").exists():
            sources = [f"{program}.{language}", f"haptic.{language}"]
            command = [compiler, f"-std={standard}", *flags, "-o", program, *sources, "-lm"]
            run(command, folder)
            run([f"./{program}"], folder)


PHANTOM = {"mass": 0.072, "damping": 0.005, "sampling_period": 0.0001, "delay": 0.0003}
IN_SI = """#include "haptic_si.h"
#include <stdio.h>
int main(void) {
    const haptic_device some = {.m = 0.072, .b = 0.005, .k = 0.0, .T = 0.0001, .t_d = 0.0003};
    haptic_device none = some, late = some;
    double K, B, omega, X = 0, Y = 0, Z = 0;
    haptic_si_max_stable_stiffness(some, &K, &B, &omega);
    printf("%.17g %.17g %.17g ", K, B, omega);
    haptic_si_max_passive_stiffness(some, &K, &B, &omega);
    printf("%.17g %.17g %.17g ", K, B, omega);
    printf("%.17g ", haptic_si_passivity_margin(40, 0.001, some));
    none.m = -0.072, late.T = -0.0001, late.t_d = -0.0003;
    haptic_si_max_passive_stiffness(none, &X, &Y, &Z);
    printf("%g %g %g ", X, Y, Z);
    printf("%d %d ", haptic_si_is_stable(1000, 1, some), haptic_si_is_stable(-1000, -1, none));
    printf("%d ", haptic_si_is_stable(1000, 1, late));
    none.m = HUGE_VAL;
    haptic_si_max_stable_stiffness(none, &X, &Y, &Z);
    printf("%g %g %g\\n", X, Y, Z);
    return 0;
}
"""


def test_si_units(folders):
    """As Scene says it, whole delays in decimals included; a mass below zero is no device, and of
    an infinite one the limit is no infinite one."""
    needs("gcc")
    folder = folders["c"]
    (folder / "main.c").write_text(IN_SI)
    run(["gcc", "-std=c99", *FLAGS, "-o", "main", "main.c", "haptic.c", "-lm"], folder)
    words = run(["./main"], folder).split()
    found, scene = list(map(float, words)), symhaptic.Scene(**PHANTOM)
    stable, passive = scene.max_stable_stiffness(), scene.max_passive_stiffness()
    expected = [x for w in (stable, passive) for x in (w.K, w.B, 2 * math.pi * w.frequency_hz)]
    assert found[:6] == pytest.approx(expected, rel=1e-13)
    assert words[7:10] == ["nan", "nan", "nan"] or words[7:10] == ["-nan"] * 3
    assert words[10:13] == ["1", "0", "0"]
    assert {word.lstrip("-") for word in words[13:]} == {"nan"}


SCENES = ["no-stiffness", "no-damping", "no-virtual-damping", "no-delay",
          "no-stiffness,no-damping,no-delay"]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(("target", "scene"), every_value(["c", "microcontroller"], SCENES))
def test_si_units_in_every_scene(scene, target, tmp_path):
    """What the scene lacks, the device lacks; all warnings are errors, in C and in C++."""
    needs("gcc", "g++")
    forms = request.chosen([], request.scene(scene))
    language = request.target(target)
    made, files = request.built(language, forms, vectors=False)
    for name, text in (files | language.package(made)).items():
        (tmp_path / name).write_text(text)
    (tmp_path / "user.c").write_text('#include "haptic_si.h"\nint main(void) { return 0; }\n')
    run(["gcc", "-std=c99", *FLAGS, "-fsyntax-only", "user.c"], tmp_path)
    run(["g++", "-std=c++17", *FLAGS, "-fsyntax-only", "-x", "c++", "user.c"], tmp_path)
    device = (tmp_path / "haptic_si.h").read_text().partition("} haptic_device;")[0]
    lacks = {"stiffness": " k;", "damping": " b;", "delay": " t_d;"}
    for part, member in lacks.items():
        assert (member in device) == (f"no-{part}" not in scene.split(","))
    wide = [line for name in ("haptic_si.h", "CMakeLists.txt")
            for line in (tmp_path / name).read_text().splitlines() if len(line) > 100]  # fmt: skip
    assert not wide


def test_arithmetic_without_nan_is_refused_in_si_units_too(folders):
    needs("gcc")
    folder = folders["c"]
    command = ["gcc", "-std=c99", "-Ofast", "-fsyntax-only", "example.c"]
    with pytest.raises(AssertionError, match="IEEE arithmetic"):
        run(command, folder)


def test_what_has_no_si_units_has_no_header(tmp_path):
    folder = exported("c", tmp_path / "out", ["discretize"])
    assert not [file.name for file in folder.iterdir() if "si.h" in file.name]
    assert "haptic_si.h" not in (folder / "CMakeLists.txt").read_text()
    assert shutil.which("cmake") is None or (folder / "haptic.pc.in").exists()


# -- the other languages -----------------------------------------------------------------

OFFLINE = ["--offline", "--quiet"]


@pytest.mark.slow
def test_a_crate_is_tested_and_documented(tmp_path, monkeypatch):
    """`cargo test` runs the self-test and the example, and rustdoc finds nothing to warn of."""
    needs("cargo")
    folder = exported("rust", tmp_path / "out", WALL)
    (tmp_path / "libm" / "src").mkdir(parents=True)
    (tmp_path / "libm" / "src" / "lib.rs").write_text(LIBM)
    (tmp_path / "libm" / "Cargo.toml").write_text(
        '[package]\nname = "libm"\nversion = "0.2.0"\nedition = "2021"\n'
    )
    nearby = ["--config", 'patch.crates-io.libm.path="../libm"']
    said = run(["cargo", "test", "--offline", *nearby], folder)
    assert " 0 missed" in said
    assert said.count("test result: ok. 1 passed") == 1
    monkeypatch.setenv("RUSTDOCFLAGS", "-D warnings")
    run(["cargo", "doc", *OFFLINE, *nearby], folder)
    lint = ["cargo", "clippy", *OFFLINE, "--all-targets", *nearby]
    run([*lint, "--", "-D", "warnings"], folder)
    bare = ["cargo", "clippy", *OFFLINE, "--lib", "--no-default-features", *nearby]
    run([*bare, "--features", "libm", "--", "-D", "warnings"], folder)
    with pytest.raises(AssertionError, match="one of the features std and libm is needed"):
        run(bare, folder)


IN_TYPESCRIPT = """import { is_stable, discretize } from "haptic";
const yes: boolean = is_stable(0.01, 0.1, 0.001, 0.02, 1);
const [n1, n0, a, e] = discretize(1, 2);
console.log(yes, n1 + n0 + a + e);
// @ts-expect-error
is_stable("0.01");
"""
IN_COMMONJS = """const { is_stable } = require("haptic");
console.log(is_stable(0.01, 0.1, 0.001, 0.02, 1));
"""


def test_a_package_of_node(tmp_path):
    """Found by its name, with `import` and with require(), in programs and by TypeScript."""
    needs("node")
    place = tmp_path / "node_modules"
    place.mkdir()
    exported("javascript", place / "haptic", ["is_stable", "discretize"])
    plain = IN_TYPESCRIPT.replace(": boolean", "").split("//")[0]
    (tmp_path / "tried.mjs").write_text(plain)
    (tmp_path / "tried.cjs").write_text(IN_COMMONJS)
    assert run(["node", "tried.mjs"], tmp_path).startswith("true 1.27067")
    assert run(["node", "tried.cjs"], tmp_path) == "true\n"
    needs("tsc")
    (tmp_path / "tried.mts").write_text(IN_TYPESCRIPT)
    (tmp_path / "old.cts").write_text('import haptic = require("haptic");\nhaptic.is_stable;\n')
    settings = ["--strict", "--noEmit", "--target", "es2022", "--module", "nodenext", "--lib"]
    run(["tsc", *settings, "es2022,dom", "tried.mts", "old.cts"], tmp_path)


IN_FORTRAN = """program tried
  use haptic, only: linear_limit, stability_boundary, is_stable
  implicit none
  integer, parameter :: wp = kind(1d0)
  real(wp) :: a(3), alpha(3), beta(3), d(3)
  d = [0.0_wp, 1.0_wp, 1.5_wp]
  a = linear_limit(0.1_wp, 0.2_wp, d)
  print '(3f8.5)', a
  call stability_boundary(0.5_wp, 0.1_wp, 0.2_wp, d, alpha, beta)
  print *, all(alpha > 0), is_stable(0.01_wp, [0.1_wp, -9.0_wp], 0.001_wp, 0.02_wp, 1.0_wp)
end program tried
"""


def test_arrays_in_fortran(tmp_path):
    needs("gfortran")
    names = ["linear_limit", "stability_boundary", "is_stable"]
    folder = exported("fortran", tmp_path / "out", names)
    (folder / "tried.f90").write_text(IN_FORTRAN)
    run(["gfortran", "-std=f2008", "-o", "tried", "src/haptic.f90", "tried.f90"], folder)
    assert run(["./tried"], folder).split() == ["0.60000", "0.20000", "0.15000", "T", "T", "F"]


def test_a_package_of_fortran(tmp_path):
    needs("fpm", "gfortran")
    folder = exported("fortran", tmp_path / "out", WALL)
    assert " 0 missed" in run(["fpm", "test"], folder)


def test_the_manifest_of_fortran_names_its_files(tmp_path):
    folder = exported("fortran", tmp_path / "out", WALL)
    manifest = tomllib.loads((folder / "fpm.toml").read_text())
    assert (folder / manifest["library"]["source-dir"] / "haptic.f90").exists()
    (test,) = manifest["test"]
    assert (folder / test["source-dir"] / test["main"]).exists()


def test_help_in_octave(tmp_path):
    """The name, a call, arguments and domain."""
    needs("octave-cli")
    folder = exported("octave", tmp_path / "out", ["max_passive_stiffness"])
    said = run(["octave-cli", "--norc", "--eval", "help haptic.max_passive_stiffness"], folder)
    assert "MAX_PASSIVE_STIFFNESS  the passive wall of largest stiffness" in said
    assert "[alpha, beta, theta] = haptic.max_passive_stiffness(delta, d)" in said
    assert "delta: physical damping, b T/m [1]" in said
    assert "Domain: delta >= 0, d >= 0." in said
