"""What C and C++ have in common: flags, CMake's package, and pkg-config's file."""

from __future__ import annotations

from collections.abc import Sequence

from symhaptic.version import __version__

FLAGS = [
    "-O2", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Wdouble-promotion", "-pedantic",
    "-Werror",
]  # fmt: skip

STRICT = """#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \\
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif
"""
"""What rewrites sums, or takes it that there is no NaN, loses the digits and the domain."""

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
        "With -ffast-math, -Ofast or /fp:fast it does not compile: these take it that there is",
        "no NaN, and rewrite sums. Use -ffp-contract=off where the processor has fused",
        "multiplication, as CMakeLists.txt does, for the digits that were measured.",
        "",
        "CMake builds, tests and installs it; then `find_package` and pkg-config know it:",
        "",
        "```",
        "cmake -B build && cmake --build build && ctest --test-dir build",
        "cmake --install build --prefix WHERE",
        "```",
        "",
        f"In CMakeLists.txt of a program that says `#include <{header}>`:",
        "",
        "```",
        f"find_package({name} REQUIRED)",
        f"target_link_libraries(controller PRIVATE {name}::{name})",
        "```",
        "",
    ]
