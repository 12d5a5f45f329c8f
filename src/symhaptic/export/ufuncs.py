"""The exported C as ufuncs of NumPy: a module of C, and its types, from the same description."""

from __future__ import annotations

import sympy as sp

from symhaptic.export.language import Target, describe
from symhaptic.export.naming import code_name
from symhaptic.export.routine import Library, Routine
from symhaptic.export.wrapping import wrapped

LOOP = """void %(name)s(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char %(places)s;
    const npy_intp %(steps)s;
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
%(work)s
        %(on)s
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}
"""

CALL = """static PyObject *one_%(name)s(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[%(given)s];
    (void)module;
    if (count != %(given)s || !given(args, x, count)) Py_RETURN_NONE;
    const double %(known)s;
    %(work)s
    if (!(%(within)s)) Py_RETURN_NONE;
    %(end)s
}
"""

_SHARED = """/* Of each thread its own: whether an argument of its calls was out of range. */
#ifdef _MSC_VER
#define OWN __declspec(thread)
#else
#define OWN _Thread_local
#endif
"""

LOOPS = (
    """#include <Python.h>

#include <fenv.h>
#include <math.h>
#include <numpy/npy_common.h>

"""
    + _SHARED
    + """
#ifdef __GNUC__ /* what is not seen from outside can become a part of its loop */
#pragma GCC visibility push(hidden)
#endif

#include "%(name)s.c"

extern OWN int strayed;

%(loops)s"""
)

MODULE_TEXT = (
    """#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <math.h>
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <numpy/ufuncobject.h>

#include "%(double)s.h"

"""
    + _SHARED
    + """
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

OWN int strayed = 0;

typedef void Loop(char **, npy_intp const *, npy_intp const *, void *);
%(loops)s

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#define MOST 8

typedef struct {
    const char *name;
    int given, found, truth;
    PyUFuncGenericFunction loops[2]; /* of floats, of doubles: the first that is safe */
    const char *about;
    void *data[2];
    char types[2*MOST + 2*MOST];
} Entry;

#define ENTRY(name, given, found, truth, about) \\
    {#name, given, found, truth, {%(single)s_##name##_loop, %(double)s_##name##_loop}, about, \\
     {NULL, NULL}, {0}}

static Entry entries[] = {
%(entries)s
};

static int filled(PyObject *module) {
    size_t i;
    for (i = 0; i < sizeof(entries)/sizeof(entries[0]); ++i) {
        Entry *e = &entries[i];
        int k, kind, all = e->given + e->found, failed;
        PyObject *made;
        for (kind = 0; kind < 2; ++kind)
            for (k = 0; k < all; ++k)
                e->types[kind*all + k] =
                    (char)(k >= e->given && e->truth ? NPY_BOOL : kind ? NPY_DOUBLE : NPY_FLOAT);
        made = PyUFunc_FromFuncAndData(e->loops, e->data, e->types, 2, e->given, e->found,
                                       PyUFunc_None, e->name, e->about, 0);
        if (made == NULL) return -1;
        failed = PyModule_AddObjectRef(module, e->name, made);
        Py_DECREF(made);
        if (failed) return -1;
    }
    return 0;
}

static int loaded(PyObject *module) {
    import_array1(-1);
    import_umath1(-1);
    if (PyModule_AddStringConstant(module, "STAMP", "%(stamp)s")) return -1;
    return filled(module);
}

static PyObject *outside(PyObject *module, PyObject *none) {
    const int found = strayed;
    (void)module;
    (void)none;
    strayed = 0;
    return PyBool_FromLong(found);
}

/* Whether all are numbers of Python's, whole ones that a double has; then they are in x. */
static int given(PyObject *const *args, double *x, Py_ssize_t count) {
    Py_ssize_t i;
    for (i = 0; i < count; ++i) {
        if (PyFloat_CheckExact(args[i]) || PyArray_IsScalar(args[i], Double))
            x[i] = PyFloat_AS_DOUBLE(args[i]);
        else if (PyLong_CheckExact(args[i])) {
            int over = 0;
            const long long whole = PyLong_AsLongLongAndOverflow(args[i], &over);
            if (over || whole > (1LL << 53) || whole < -(1LL << 53)) return 0;
            x[i] = (double)whole;
        }
        else return 0;
    }
    return 1;
}

static PyObject *number(double value) {
    PyObject *made = PyArrayScalar_New(Double);
    if (made != NULL) PyArrayScalar_ASSIGN(made, Double, value);
    return made;
}

static PyObject *truth(int value) {
    if (value) PyArrayScalar_RETURN_TRUE;
    PyArrayScalar_RETURN_FALSE;
}

/* One of NumPy's numbers or a tuple of them; None if one is NaN. */
static PyObject *numbers(double const *y, int count) {
    PyObject *all;
    int i;
    for (i = 0; i < count; ++i) if (isnan(y[i])) Py_RETURN_NONE;
    if (count == 1) return number(y[0]);
    all = PyTuple_New(count);
    for (i = 0; all != NULL && i < count; ++i) {
        PyObject *made = number(y[i]);
        if (made == NULL) Py_CLEAR(all);
        else PyTuple_SET_ITEM(all, i, made);
    }
    return all;
}

%(calls)s
#define ONE(name) \\
    {"one_" #name, (PyCFunction)(void (*)(void))one_##name, METH_FASTCALL, \\
     "The same of numbers; None where one is none or is out of range, or a result is NaN."}

static PyMethodDef functions[] = {
%(methods)s
    {"outside", outside, METH_NOARGS,
     "Whether an argument was NaN or out of range since this thread last asked."},
    {NULL, NULL, 0, NULL}};

static PyModuleDef_Slot slots[] = {{Py_mod_exec, loaded}, {0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "%(module)s", "The stable forms as ufuncs.", 0, functions, slots,
    NULL, NULL, NULL};

PyMODINIT_FUNC PyInit_%(module)s(void) { return PyModuleDef_Init(&definition); }
"""
)


# -- The exported C as ufuncs of NumPy: a module of C, and its types, from the same description --


MODULE = "_compiled"

INSIDE = ("LateDevice",)
"""Routines of the library that are ufuncs, too, for who has asked for its arguments' ranges."""

UNSTAMPED = "of no sources"
"""In the module's source, for what tells the sources that it is compiled of."""


def ufuncs(
    double: Library, single: Library, in_double: Target, in_single: Target
) -> dict[str, str]:
    """MODULE.c, two files of loops that call a library each, which is inside, and MODULE.pyi."""
    entries = [
        _entry(routine, describe(form))
        for form, routine in zip(double.forms, double.public, strict=True)
    ]
    inside = _inside(double)
    entries += [_entry(routine, [f"{routine.about}."]) for routine in inside]
    both = (double, in_double), (single, in_single)
    calls = ["\n".join(wrapped(_call(double, in_double, r).split("\n"))) for r in double.public]
    declared = [
        f"Loop {_name(library, r)};" for library, _ in both for r in (*library.public, *inside)
    ]
    numbers = {
        "module": MODULE,
        "stamp": UNSTAMPED,
        "double": double.name,
        "single": single.name,
        "loops": "\n".join(declared),
        "entries": "\n".join(entries),
        "calls": "\n".join(calls),
        "methods": "\n".join(f"    ONE({routine.name})," for routine in double.public),
    }
    made = {f"{MODULE}.c": MODULE_TEXT % numbers}
    for library, language in both:
        every = (*library.public, *_inside(library))
        loops = [_loop(library, language, routine) for routine in every]
        text = LOOPS % {"name": library.name, "loops": "\n".join(loops)}
        made[f"{library.name}_loops.c"] = "\n".join(wrapped(text.split("\n")))
    typed = [
        "from typing import Any\n\nfrom numpy import ufunc\n",
        *(f"{code_name(routine.name)}: ufunc" for routine in (*double.public, *inside)),
        "\nSTAMP: str\n\ndef outside() -> bool: ...",
        *(f"def one_{routine.name}(*numbers: Any) -> Any: ..." for routine in double.public),
    ]
    return made | {f"{MODULE}.pyi": "\n".join([*typed, ""])}


def _inside(library: Library) -> list[Routine]:
    return [helper for helper in library.helpers if helper.name in INSIDE]


def _name(library: Library, routine: Routine) -> str:
    return f"{library.name}_{code_name(routine.name)}_loop"


def _loop(library: Library, language: Target, routine: Routine) -> str:
    """One ufunc's inner loop in one precision: a call an element, and whether all is in range."""
    kind, given, count = language.real, len(routine.arguments), len(routine.results)
    names = [language.rename(symbol.name) for symbol in routine.arguments]
    x, y = [f"x{i}" for i in range(given)], [f"y{i}" for i in range(count)]
    work = [f"const {kind} {n} = *({kind} const *){at};" for n, at in zip(names, x, strict=True)]
    call = f"{library.name}_{routine.name}({', '.join(names)}"
    if routine.record:
        call = f"{language.call(routine.name)}({', '.join(names)})"
        work += [f"const {routine.record} found = {call};"]
        fields = zip(y, routine.results, strict=True)
        work += [" ".join(f"*({kind} *){at} = found.{name};" for at, (name, _) in fields)]
    elif count > 1:
        work += [f"{call}, {', '.join(f'({kind} *){at}' for at in y)});"]
    else:
        work += [f"*({'npy_bool' if routine.truth else kind} *){y[0]} = {call});"]
    within = language.printing().doprint(sp.And(*routine.within))
    if routine.truth or routine.outside is not sp.nan:
        work += [f"within &= {within};"]
    elif routine.within:  # NaN tells that it may be outside
        first = f"*({kind} *){y[0]}"
        work += [f"if ({first} != {first} && !({within})) within = 0;"]
    places = [*x, *y]
    return LOOP % {
        "name": _name(library, routine),
        "places": ", ".join(f"*{at} = at[{i}]" for i, at in enumerate(places)),
        "steps": ", ".join(f"s{i} = steps[{i}]" for i in range(len(places))),
        "work": "\n".join(f"        {line}" for line in work),
        "on": " ".join(f"{at} += s{i};" for i, at in enumerate(places)),
    }


def _call(library: Library, language: Target, routine: Routine) -> str:
    """A call with numbers of Python's: what the ufunc gives, or None."""
    given, count = len(routine.arguments), len(routine.results)
    names = [language.rename(symbol.name) for symbol in routine.arguments]
    call = f"{library.name}_{routine.name}({', '.join(names)}"
    if count > 1:
        work = f"double y[{count}];\n    {call}, {', '.join(f'&y[{i}]' for i in range(count))});"
    else:
        work = f"{'const int' if routine.truth else 'const double'} y = {call});"
    if routine.truth:
        end = "return truth(y);"
    else:
        end = f"return numbers({'y' if count > 1 else '&y'}, {count});"
    known = ", ".join(f"{n} = x[{i}]" for i, n in enumerate(names))
    return CALL % {
        "name": routine.name,
        "given": given,
        "known": known,
        "within": language.printing().doprint(sp.And(*routine.within)),
        "work": work,
        "end": end,
    }


def _entry(routine: Routine, about: list[str]) -> str:
    """One ufunc's entry of the table: its name, what it takes and gives, what it says."""
    given, count = len(routine.arguments), len(routine.results)
    names = ", ".join(symbol.name for symbol in routine.arguments)
    results = ", ".join(name for name, _ in routine.results)
    said = "\n    ".join(
        f'"{_quoted(line)}\\n"' for line in (f"{results} of ({names})", "", *about)
    )
    truth = str(int(routine.truth))
    return f"    ENTRY({code_name(routine.name)}, {given}, {count}, {truth},\n    {said}),"


def _quoted(line: str) -> str:
    return line.replace("\\", "\\\\").replace('"', '\\"')
