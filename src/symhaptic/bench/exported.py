"""Exported C, compiled and run on arrays: with the C library of this process, or with another."""

from __future__ import annotations

import ctypes
import subprocess
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

import numpy as np

from symhaptic.bench.points import Array
from symhaptic.export import request
from symhaptic.export.precision import DOUBLE, Precision
from symhaptic.export.routine import Library
from symhaptic.export.targets import TARGETS
from symhaptic.forms.stable import Form

GCC = "gcc"
"""Compiles for the C library that this process has."""

MUSL = "musl-gcc"
"""Compiles for musl, which is linked to a program of its own: no process has two C libraries."""


def compiled(
    form: Form, folder: Path, precision: Precision = DOUBLE, compiler: str = GCC
) -> Callable[[list[Array]], Array]:
    """The exported C function on arrays, in a loop that is compiled with it."""
    language = TARGETS["c"].at(precision)
    made, files = written(form, precision)
    for name, text in files.items():
        (folder / name).write_text(text)
    given, found = len(form.arguments), len(made.public[0].results)
    inner = ", ".join(f"x{i}[k]" for i in range(given))
    outs = ", ".join(f"y{i} + k" for i in range(found))
    call = (
        f"y0[k] = haptic_{form.name}({inner})" if found == 1
        else f"haptic_{form.name}({inner}, {outs})"
    )  # fmt: skip
    args = [f"const {language.real} *x{i}" for i in range(given)]
    args += [f"{language.real} *y{i}" for i in range(found)]
    loop = (
        f'#include "haptic.h"\nvoid all(long n, {", ".join(args)}) {{\n'
        f"  for (long k = 0; k < n; ++k) {call};\n}}\n"
    )
    if compiler == GCC:
        return _loaded(form, folder, precision, loop, found)
    return _started(folder, precision, compiler, loop, given, found)


@lru_cache(maxsize=64)  # the same is compiled for several libraries
def written(form: Form, precision: Precision) -> tuple[Library, dict[str, str]]:
    """The library of the form alone in C, and its files."""
    return request.built(TARGETS["c"].at(precision), [form], vectors=False)


def _loaded(
    form: Form, folder: Path, precision: Precision, loop: str, found: int
) -> Callable[[list[Array]], Array]:
    (folder / "loop.c").write_text(loop)
    library = folder / f"{form.name}.so"
    subprocess.run(
        [GCC, "-std=c99", "-O2", "-shared", "-fPIC", "-o", library, folder / "loop.c",
         folder / "haptic.c", "-lm"],
        check=True,
    )  # fmt: skip
    function = ctypes.CDLL(str(library)).all

    def run(arrays: list[Array]) -> Array:
        rows = np.empty((found, arrays[0].size), dtype=precision.kind)
        pointers = [ctypes.c_void_p(a.ctypes.data) for a in (*arrays, *rows)]
        function(ctypes.c_long(arrays[0].size), *pointers)
        return rows

    return run


_PROGRAM = """
#include <stdio.h>
#include <stdlib.h>
int main(int argc, char **argv) {{
    long n = argc > 1 ? atol(argv[1]) : 0;
    {real} *at = malloc(n*{all}*sizeof({real}) + 1);
    if (at == NULL || fread(at, sizeof({real}), n*{given}, stdin) != (size_t)n*{given}) return 1;
    all(n, {columns});
    return fwrite(at + n*{given}, sizeof({real}), n*{found}, stdout) != (size_t)n*{found};
}}
"""


def _started(
    folder: Path, precision: Precision, compiler: str, loop: str, given: int, found: int
) -> Callable[[list[Array]], Array]:
    program = folder / "program"
    columns = ", ".join(f"at + {i}*n" for i in range(given + found))
    real = TARGETS["c"].at(precision).real
    numbers = {"real": real, "all": given + found, "given": given, "found": found}
    (folder / "loop.c").write_text(loop + _PROGRAM.format(columns=columns, **numbers))
    subprocess.run(
        [compiler, "-std=c99", "-O2", "-static", "-o", program, folder / "loop.c",
         folder / "haptic.c", "-lm"],
        check=True,
    )  # fmt: skip

    def run(arrays: list[Array]) -> Array:
        size = arrays[0].size
        columns = b"".join(a.tobytes() for a in arrays)
        told = subprocess.run([program, str(size)], input=columns, capture_output=True, check=True)
        rows = np.empty((found, size), dtype=precision.kind)
        rows[:] = np.frombuffer(told.stdout, dtype=precision.kind).reshape(found, size)
        return rows

    return run
