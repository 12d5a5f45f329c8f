"""The exported C as ufuncs of NumPy: a module of C, and its types, from the same description."""

from __future__ import annotations

from symhaptic.export.module import Library
from symhaptic.export.routine import Routine
from symhaptic.export.target import describe

MODULE = "_compiled"


def ufuncs(double: Library, single: Library) -> dict[str, str]:
    """MODULE.c, whose ufuncs call both libraries, and MODULE.pyi."""
    loops = [
        _loop(name, kind, routine)
        for one, two in zip(double.public, single.public, strict=True)
        for name, kind, routine in ((double.name, "double", one), (single.name, "float", two))
    ]
    entries = [
        _entry(routine, describe(form))
        for form, routine in zip(double.forms, double.public, strict=True)
    ]
    text = _MODULE % {
        "module": MODULE,
        "double": double.name,
        "single": single.name,
        "loops": "\n".join(loops),
        "entries": "\n".join(entries),
    }
    names = "\n".join(f"{routine.name}: ufunc" for routine in double.public)
    return {f"{MODULE}.c": text, f"{MODULE}.pyi": f"from numpy import ufunc\n\n{names}\n"}


def _loop(library: str, kind: str, routine: Routine) -> str:
    """One ufunc's inner loop in one precision: a call an element."""
    given, count = len(routine.arguments), len(routine.results)
    call = ", ".join(f"*({kind} *)(at[{i}])" for i in range(given))
    own = f"{library}_{routine.name}"
    places = [f"at[{given + i}]" for i in range(count)]
    if count > 1:
        into = "".join(f", &found[{i}]" for i in range(count))
        work = [f"{kind} found[{count}];", f"{own}({call}{into});"]
        work += [f"*({kind} *){place} = found[{i}];" for i, place in enumerate(places)]
    else:
        work = [f"*({'npy_bool' if routine.truth else kind} *){places[0]} = {own}({call});"]
    return _LOOP % {
        "name": f"{own}_loop",
        "all": given + count,
        "work": "\n".join(f"        {line}" for line in work),
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
    return f"    ENTRY({routine.name}, {given}, {count}, {truth},\n    {said}),"


def _quoted(line: str) -> str:
    return line.replace("\\", "\\\\").replace('"', '\\"')


_LOOP = """static void %(name)s(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[%(all)s];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < %(all)s; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
%(work)s
        for (k = 0; k < %(all)s; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}
"""

_MODULE = """#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

#include <fenv.h>

#include "%(double)s.h"
#include "%(single)s.h"

#define MOST 8

%(loops)s
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
    return filled(module);
}

static PyModuleDef_Slot slots[] = {{Py_mod_exec, loaded}, {0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "%(module)s", "The stable forms as ufuncs.", 0, NULL, slots,
    NULL, NULL, NULL};

PyMODINIT_FUNC PyInit_%(module)s(void) { return PyModuleDef_Init(&definition); }
"""
