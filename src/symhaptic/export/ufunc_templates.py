"""The text of the ufuncs' module in C, and of its loops, around what :mod:`ufuncs` fills in."""

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
