"""What C and C++ have around their source: flags, CMake's package, and SI units."""

from __future__ import annotations

from collections.abc import Sequence

from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Library
from symhaptic.export.statements import wrapped
from symhaptic.forms.stable import Form
from symhaptic.notation import SYMBOLS
from symhaptic.version import __version__

FLAGS = [
    "-O2", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-pedantic",
    "-Werror",
]  # fmt: skip

STRICT = """#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \\
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "this file needs IEEE arithmetic: compile it with -mfpmath=sse or /arch:SSE2"
#endif
"""
"""Compiler flags that reorder sums, or assume that there is no NaN, cost digits and the domain.

So does the x87 unit of a processor: it rounds to more digits than a number has.  FLT_EVAL_METHOD is
16 where only half precision is computed with more digits.
"""

_LISTS = """\
# cmake -B build && cmake --build build && ctest --test-dir build
# cmake --install build --prefix WHERE; then, in another project:
#     find_package(%(name)s REQUIRED)
#     target_link_libraries(controller PRIVATE %(name)s::%(name)s)
cmake_minimum_required(VERSION 3.15)
project(%(name)s VERSION %(release)s LANGUAGES %(language)s)

include(CMakePackageConfigHelpers)
include(CTest)
include(GNUInstallDirs)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(%(name)s %(source)s)
add_library(%(name)s::%(name)s ALIAS %(name)s)
target_compile_features(%(name)s PUBLIC %(standard)s)
target_include_directories(%(name)s PUBLIC
  $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
set_target_properties(%(name)s PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  %(language)s_EXTENSIONS OFF POSITION_INDEPENDENT_CODE ON)
if(UNIX)
  target_link_libraries(%(name)s PUBLIC m)
endif()
if(NOT MSVC)
  # each rounding where it is written
  target_compile_options(%(name)s PRIVATE -ffp-contract=off)
endif()

if(BUILD_TESTING AND CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR)
%(programs)sendif()

install(TARGETS %(name)s EXPORT %(name)s-targets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES %(headers)s DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/%(name)s)
install(EXPORT %(name)s-targets FILE %(name)s-config.cmake NAMESPACE %(name)s::
  DESTINATION ${package})
write_basic_package_version_file(%(name)s-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/%(name)s-config-version.cmake DESTINATION ${package})

# from the file itself, so that what is installed may be moved
file(RELATIVE_PATH up /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(%(name)s.pc.in %(name)s.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/%(name)s.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
"""

_PROGRAM = """\
  add_executable(%(name)s-%(program)s %(file)s)
  target_link_libraries(%(name)s-%(program)s PRIVATE %(name)s)
  add_test(NAME %(program)s COMMAND %(name)s-%(program)s
    WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
"""

_PKG_CONFIG = """\
prefix=${pcfiledir}/@up@
libdir=${prefix}/@CMAKE_INSTALL_LIBDIR@
includedir=${prefix}/@CMAKE_INSTALL_INCLUDEDIR@

Name: %(name)s
Description: %(title)s
Version: @PROJECT_VERSION@
Libs: -L${libdir} -l%(name)s -lm
Cflags: -I${includedir}
"""


def package(
    name: str,
    title: str,
    standard: str,
    source: str,
    headers: Sequence[str],
    programs: Sequence[str],
) -> dict[str, str]:
    """CMakeLists.txt and NAME.pc.in of a library of one source; ``programs`` are its tests.

    >>> sorted(package("haptic", "Walls", "c_std_99", "haptic.c", ["haptic.h"], ["selftest.c"]))
    ['CMakeLists.txt', 'haptic.pc.in']
    """
    language = "CXX" if standard.startswith("cxx") else "C"
    words = {
        "headers": " ".join(headers), "language": language, "name": name, "release": __version__,
        "source": source, "standard": standard, "title": title,
    }  # fmt: skip
    tests = [words | {"program": file.split(".")[0], "file": file} for file in programs]
    words["programs"] = "".join(_PROGRAM % of for of in tests)
    return {"CMakeLists.txt": _LISTS % words, f"{name}.pc.in": _PKG_CONFIG % words}


def notes(name: str, header: str) -> list[str]:
    """Lines of the README on it."""
    return [
        "The code does not compile with -ffast-math, -Ofast or /fp:fast, because these flags",
        "assume that there is no NaN, and reorder sums. It does not compile for the x87 unit of",
        "32-bit x86 either, because this unit rounds each step to more digits: compile with",
        "-msse2 -mfpmath=sse there. Never use -funsafe-math-optimizations or -fassociative-math",
        "with clang, which does not report these two flags: an unstable wall may then count as",
        "stable. The self-test fails with both flags. If the processor has fused multiplication,",
        "use -ffp-contract=off, as CMakeLists.txt does, to get the measured accuracy.",
        "",
        "Build, test and install it with CMake; `find_package` and pkg-config then find it:",
        "",
        "```",
        "cmake -B build && cmake --build build && ctest --test-dir build",
        "cmake --install build --prefix WHERE",
        "```",
        "",
        f"In the CMakeLists.txt of a program with `#include <{header}>`:",
        "",
        "```",
        f"find_package({name} REQUIRED)",
        f"target_link_libraries(controller PRIVATE {name}::{name})",
        "```",
        "",
    ]


# -- The same functions in C for a device in SI units, and a controller that uses them -----------


_DEVICE = {"gamma": "k", "delta": "b", "d": "t_d"}
"""Arguments that belong to the device, beside its mass and its sampling period."""

_GIVEN = {"alpha": "K", "beta": "B", "theta": "omega"}
"""The others, and what they are in SI units."""

_ARGUMENTS = {
    "alpha": "K*of.T*of.T/of.m",
    "beta": "B*of.T/of.m",
    "theta": "omega*of.T",
    "gamma": "of.k*of.T*of.T/of.m",
    "delta": "of.b*of.T/of.m",
    "d": "{name}_periods(of)",
}

_RESULTS = {
    "alpha": ("K", "of.m/(of.T*of.T)"),
    "beta": ("B", "of.m/of.T"),
    "theta": ("omega", "1/of.T"),
    "margin": ("b", "of.m/of.T"),
    "added": ("t", "of.T"),
    "stable": ("", ""),
    "verdict": ("", ""),
    "roots": ("", ""),
}
"""What each is in SI units, and what it has to be multiplied by."""


def header(library: Library, real: str, precision: Precision) -> dict[str, str]:
    """NAME_si.h, and example.c of a whole device whose limit and whose test of a wall are there.

    What has another result, such as a derivative, is left out; no file if all have.
    """
    forms = [form for form in library.forms if {n for n, _ in form.results} <= _RESULTS.keys()]
    if not forms:
        return {}
    name = library.name
    parts = {_DEVICE[s.name] for f in forms for s in f.arguments if s.name in _DEVICE}
    members: list[str] = [n for n in ("m", "b", "k", "T", "t_d") if n in {"m", "T", *parts}]
    files = {f"{name}_si.h": _header(name, forms, members, precision, real)}
    if len(members) == 5 and {"max_stable_stiffness", "is_stable"} <= {f.name for f in forms}:
        device = ", ".join(f".{n} = {_PHANTOM[n]}{_suffix(precision)}" for n in members)
        words = {"name": name, "real": real, "device": device, "f": _suffix(precision)}
        files["example.c"] = _EXAMPLE % words
    return files


_PHANTOM = {"m": "0.072", "b": "0.005", "k": "0.0", "T": "0.001", "t_d": "0.001"}


def _suffix(precision: Precision) -> str:
    return "" if precision is DOUBLE else "f"


def _header(
    name: str, forms: list[Form], members: list[str], precision: Precision, real: str
) -> str:
    fields = [(n, f"/* {SYMBOLS[n].meaning} [{SYMBOLS[n].unit}] */") for n in members]
    lines = [f"    {real} {n}; {about}" for n, about in fields]
    functions = [line for form in forms for line in [*_function(name, form, real), ""]]
    words = {
        "name": name, "guard": f"{name.upper()}_SI_H", "real": real, "f": _suffix(precision),
        "strict": STRICT, "members": "\n".join(lines), "functions": "\n".join(wrapped(functions)),
        "last": "DBL_EPSILON" if precision is DOUBLE else "FLT_EPSILON",
        "most": "DBL_MAX" if precision is DOUBLE else "FLT_MAX",
    }  # fmt: skip
    words["delay"] = _DELAY % words if "t_d" in members else ""
    return _HEADER % words


def _function(name: str, form: Form, real: str) -> list[str]:
    given = [_GIVEN[s.name] for s in form.arguments if s.name in _GIVEN]
    found = [(n, *_RESULTS[n]) for n, _ in form.results]
    about = [f"As {name}_{form.name}: {form.title}."]
    about += [f"{n}: {SYMBOLS[n].meaning} [{SYMBOLS[n].unit}]" for n in given]
    args = [f"const {real} {n}" for n in given] + [f"const {name}_device device"]
    called = [_ARGUMENTS[s.name].format(name=name) for s in form.arguments]
    kind = "bool" if form.truth else real
    if len(found) > 1:
        kind = "void"
        args += [f"{real} *const {si}_out" for _, si, _ in found]
        about += [f"{si}_out: {SYMBOLS[si].meaning} [{SYMBOLS[si].unit}]" for _, si, _ in found]
        called += [f"{si}_out" for _, si, _ in found]
    lines = ["/*", *(f" * {line}" for line in about), " */"]
    lines += [f"static inline {kind} {name}_si_{form.name}({', '.join(args)}) {{"]
    lines += [f"    const {name}_device of = {name}_device_checked(device);"]
    call = f"{name}_{form.name}({', '.join(called)})"
    if len(found) > 1:
        lines += [f"    {call};"]
        lines += [f"    *{si}_out *= {factor};" for _, si, factor in found]
    else:
        factor = found[0][2]
        lines += [f"    return {call}*({factor});" if factor else f"    return {call};"]
    return [*lines, "}"]


_HEADER = """\
#ifndef %(guard)s
#define %(guard)s

#include <float.h>
#include <math.h>

#include "%(name)s.h"

%(strict)s
/* A device with a delay, in SI units. */
typedef struct {
%(members)s
} %(name)s_device;

/* Without a positive finite mass and period, all arguments are outside the domain. */
static inline %(name)s_device %(name)s_device_checked(%(name)s_device device) {
    if (!(device.m > 0 && device.m <= %(most)s)) device.m = NAN;
    if (!(device.T > 0 && device.T <= %(most)s)) device.T = NAN;
    return device;
}

%(delay)s%(functions)s
#endif
"""

_DELAY = """\
/*
 * The delay in sampling periods. It is an integer if it differs from this integer only by the
 * rounding of decimals: 0.0003 s are exactly three periods of 0.0001 s.
 */
static inline %(real)s %(name)s_periods(const %(name)s_device device) {
    const %(real)s d = device.t_d/device.T, whole = floor%(f)s(d + 0.5%(f)s);
    return fabs%(f)s(d - whole) <= 2*%(last)s*whole ? whole : d;
}

"""

_EXAMPLE = """\
/*
 * A virtual wall in a loop at 1 kHz. The limit is computed once, before the loop, and the wall
 * stays well below it. A finger that pushes with 1 N and a device that moves in steps of 1 us
 * replace the encoder and the motor: write your own read_position() and write_force().
 */
#include <stdio.h>

#include "%(name)s_si.h"

static const %(name)s_device device = {%(device)s};

static %(real)s position, speed;

static %(real)s read_position(void) {
    return position;
}

/* Holds a force for one sampling period. */
static void write_force(const %(real)s force) {
    const %(real)s finger = 1.0%(f)s, step = device.T/1000;
    int i;
    for (i = 0; i < 1000; ++i) {
        speed += (finger + force - device.b*speed - device.k*position)/device.m*step;
        position += speed*step;
    }
}

/* The largest deflection of the device in the last tenth of a second. */
static %(real)s pushed_into(const %(real)s K, const %(real)s B, const int periods) {
    %(real)s last = 0, late = 0, farthest = 0;
    int i;
    position = speed = 0;
    for (i = 0; i < periods; ++i) {
        const %(real)s now = read_position();
        const %(real)s force = -K*now - B*(now - last)/device.T;
        write_force(late); /* which is delayed by one period */
        late = force;
        last = now;
        if (i >= periods - 100) farthest = fmax%(f)s(farthest, fabs%(f)s(now));
    }
    return farthest;
}

int main(void) {
    %(real)s K, B, omega, below, above;
    %(name)s_si_max_stable_stiffness(device, &K, &B, &omega);
    printf("K < %%g N/m, at B = %%g Ns/m; beyond, it oscillates at %%g rad/s\\n", (double)K,
           (double)B, (double)omega);
    if (!%(name)s_si_is_stable(K/2, B/2, device)) return 1;
    below = pushed_into(K/2, B/2, 2000);
    above = pushed_into(K*1.2%(f)s, B, 2000);
    printf("after 2 s: %%g m at half of the limit, %%g m at 1.2 times it\\n", (double)below,
           (double)above);
    return !(below < 0.01%(f)s && !(above < 1));
}
"""
