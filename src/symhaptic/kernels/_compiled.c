/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <math.h>
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <numpy/ufuncobject.h>

#include "haptic.h"

/* Of each thread its own: whether an argument of its calls was out of range. */
#ifdef _MSC_VER
#define OWN __declspec(thread)
#else
#define OWN _Thread_local
#endif

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

OWN int strayed = 0;

typedef void Loop(char **, npy_intp const *, npy_intp const *, void *);
Loop haptic_discretize_loop;
Loop haptic_discretize_fractional_loop;
Loop haptic_is_stable_loop;
Loop haptic_unstable_roots_loop;
Loop haptic_stability_boundary_loop;
Loop haptic_max_stable_stiffness_loop;
Loop haptic_passivity_margin_at_loop;
Loop haptic_passivity_margin_loop;
Loop haptic_passivity_boundary_loop;
Loop haptic_max_passive_stiffness_loop;
Loop haptic_linear_limit_loop;
Loop haptic_late_device_loop;
Loop haptic_single_discretize_loop;
Loop haptic_single_discretize_fractional_loop;
Loop haptic_single_is_stable_loop;
Loop haptic_single_unstable_roots_loop;
Loop haptic_single_stability_boundary_loop;
Loop haptic_single_max_stable_stiffness_loop;
Loop haptic_single_passivity_margin_at_loop;
Loop haptic_single_passivity_margin_loop;
Loop haptic_single_passivity_boundary_loop;
Loop haptic_single_max_passive_stiffness_loop;
Loop haptic_single_linear_limit_loop;
Loop haptic_single_late_device_loop;

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

#define ENTRY(name, given, found, truth, about) \
    {#name, given, found, truth, {haptic_single_##name##_loop, haptic_##name##_loop}, about, \
     {NULL, NULL}, {0}}

static Entry entries[] = {
    ENTRY(discretize, 2, 4, 0,
    "n1, n0, a, e of (gamma, delta)\n"
    "\n"
    "the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m.\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "Results: n1; n0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].\n"
    "Domain: gamma >= 0, delta >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or gamma larger than 1e15.\n"),
    ENTRY(discretize_fractional, 3, 5, 0,
    "m2, m1, m0, a, e of (gamma, delta, epsilon)\n"
    "\n"
    "the sampled device behind a delay of epsilon periods, P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e)) in units of T^2/m.\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "epsilon: rest of a delay, a fraction of a period [1]\n"
    "Results: m2; m1; m0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].\n"
    "Domain: gamma >= 0, delta >= 0, 0 <= epsilon < 1.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or gamma larger than 1e15.\n"),
    ENTRY(is_stable, 5, 1, 1,
    "stable of (alpha, beta, gamma, delta, d)\n"
    "\n"
    "whether all characteristic roots lie inside the unit circle.\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) where sqrt(gamma) is, rounded, a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|, gamma) < 2^-400 (single: 2^-40).\n"
    "False outside, and where an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n"),
    ENTRY(unstable_roots, 5, 1, 0,
    "roots of (alpha, beta, gamma, delta, d)\n"
    "\n"
    "number of characteristic roots outside the unit circle.\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) where sqrt(gamma) is, rounded, a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|, gamma) < 2^-400 (single: 2^-40).\n"
    "-1 outside, and where an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n"),
    ENTRY(stability_boundary, 4, 2, 0,
    "alpha, beta of (theta, gamma, delta, d)\n"
    "\n"
    "the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).\n"
    "theta: angle on the unit circle, omega T [1]\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].\n"
    "Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n"),
    ENTRY(max_stable_stiffness, 3, 3, 0,
    "alpha, beta, theta of (gamma, delta, d)\n"
    "\n"
    "the wall of largest stable stiffness, a limit that is not stable itself, and the angle theta = omega T of its roots on the unit circle.\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta, angle on the unit circle, omega T [1].\n"
    "Domain: gamma >= 0, delta >= 0, d >= 0, gamma <= 9.8, sqrt(gamma) (d + 1) <= pi or d <= 1, delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) (d + 1) > pi, NaN elsewhere, and where no wall is stable or none that is a little softer.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n"),
    ENTRY(passivity_margin_at, 5, 1, 0,
    "margin of (theta, alpha, beta, delta, d)\n"
    "\n"
    "physical damping minus the damping that the wall needs at the angle theta = omega T; a wall with alpha >= 0 is passive where this is not negative at any angle.\n"
    "theta: angle on the unit circle, omega T [1]\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: 0 < theta < pi, delta >= 0, d >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(passivity_margin, 4, 1, 0,
    "margin of (alpha, beta, delta, d)\n"
    "\n"
    "physical damping minus the damping that the wall needs at its worst angle; the wall is passive where it is not negative.\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: delta >= 0, d >= 0, -inf for alpha < 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(passivity_boundary, 3, 2, 0,
    "alpha, beta of (theta, delta, d)\n"
    "\n"
    "the wall that is just passive and whose worst angle is theta = omega T.\n"
    "theta: angle on the unit circle, omega T [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].\n"
    "Domain: 0 < theta < pi, delta >= 0, d >= 0, NaN beyond the angle where alpha is 0: pi/(d + 1) for whole delays, for d <= 2/9 the curve goes on to pi.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(max_passive_stiffness, 2, 3, 0,
    "alpha, beta, theta of (delta, d)\n"
    "\n"
    "the passive wall of largest stiffness, and its worst angle theta = omega T.\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta, angle on the unit circle, omega T [1].\n"
    "Domain: delta >= 0, d >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(linear_limit, 3, 1, 0,
    "alpha of (beta, delta, d)\n"
    "\n"
    "the stiffness alpha at which the linear condition is an equality.\n"
    "beta: virtual damping, B T/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: delta >= 0, d >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(late_device, 3, 4, 0,
    "apart, m2, kicked, m0 of (gamma, delta, part)\n"
    "\n"
    "m2 - m1 + m0, m2, an impulse's way in the rest of the period, m0, behind a fraction of it.\n"),
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
    if (PyModule_AddStringConstant(module, "STAMP", "68399589d1573d1f")) return -1;
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

static PyObject *one_discretize(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[2];
    (void)module;
    if (count != 2 || !given(args, x, count)) Py_RETURN_NONE;
    const double gamma = x[0], delta = x[1];
    double y[4];
    haptic_discretize(gamma, delta, &y[0], &y[1], &y[2], &y[3]);
    if (!(delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) Py_RETURN_NONE;
    return numbers(y, 4);
}

static PyObject *one_discretize_fractional(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[3];
    (void)module;
    if (count != 3 || !given(args, x, count)) Py_RETURN_NONE;
    const double gamma = x[0], delta = x[1], epsilon = x[2];
    double y[5];
    haptic_discretize_fractional(gamma, delta, epsilon, &y[0], &y[1], &y[2], &y[3], &y[4]);
    if (!(delta >= 0.0 && delta <= 1e+70 && epsilon >= 0.0 && epsilon < 1.0 && gamma >= 0.0 &&
        gamma <= 1e+15)) Py_RETURN_NONE;
    return numbers(y, 5);
}

static PyObject *one_is_stable(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[5];
    (void)module;
    if (count != 5 || !given(args, x, count)) Py_RETURN_NONE;
    const double alpha = x[0], beta = x[1], gamma = x[2], delta = x[3], d = x[4];
    const int y = haptic_is_stable(alpha, beta, gamma, delta, d);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) Py_RETURN_NONE;
    return truth(y);
}

static PyObject *one_unstable_roots(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[5];
    (void)module;
    if (count != 5 || !given(args, x, count)) Py_RETURN_NONE;
    const double alpha = x[0], beta = x[1], gamma = x[2], delta = x[3], d = x[4];
    const double y = haptic_unstable_roots(alpha, beta, gamma, delta, d);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) Py_RETURN_NONE;
    return numbers(&y, 1);
}

static PyObject *one_stability_boundary(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[4];
    (void)module;
    if (count != 4 || !given(args, x, count)) Py_RETURN_NONE;
    const double theta = x[0], gamma = x[1], delta = x[2], d = x[3];
    double y[2];
    haptic_stability_boundary(theta, gamma, delta, d, &y[0], &y[1]);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 &&
        gamma <= 1e+15 && theta > 0.0 && theta <= 3.141592653589793)) Py_RETURN_NONE;
    return numbers(y, 2);
}

static PyObject *one_max_stable_stiffness(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[3];
    (void)module;
    if (count != 3 || !given(args, x, count)) Py_RETURN_NONE;
    const double gamma = x[0], delta = x[1], d = x[2];
    double y[3];
    haptic_max_stable_stiffness(gamma, delta, d, &y[0], &y[1], &y[2]);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 &&
        gamma <= 1e+15)) Py_RETURN_NONE;
    return numbers(y, 3);
}

static PyObject *one_passivity_margin_at(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[5];
    (void)module;
    if (count != 5 || !given(args, x, count)) Py_RETURN_NONE;
    const double theta = x[0], alpha = x[1], beta = x[2], delta = x[3], d = x[4];
    const double y = haptic_passivity_margin_at(theta, alpha, beta, delta, d);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70 && theta > 0.0 && theta <= 3.141592653589793)) Py_RETURN_NONE;
    return numbers(&y, 1);
}

static PyObject *one_passivity_margin(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[4];
    (void)module;
    if (count != 4 || !given(args, x, count)) Py_RETURN_NONE;
    const double alpha = x[0], beta = x[1], delta = x[2], d = x[3];
    const double y = haptic_passivity_margin(alpha, beta, delta, d);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70)) Py_RETURN_NONE;
    return numbers(&y, 1);
}

static PyObject *one_passivity_boundary(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[3];
    (void)module;
    if (count != 3 || !given(args, x, count)) Py_RETURN_NONE;
    const double theta = x[0], delta = x[1], d = x[2];
    double y[2];
    haptic_passivity_boundary(theta, delta, d, &y[0], &y[1]);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && theta > 0.0 &&
        theta <= 3.141592653589793)) Py_RETURN_NONE;
    return numbers(y, 2);
}

static PyObject *one_max_passive_stiffness(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[2];
    (void)module;
    if (count != 2 || !given(args, x, count)) Py_RETURN_NONE;
    const double delta = x[0], d = x[1];
    double y[3];
    haptic_max_passive_stiffness(delta, d, &y[0], &y[1], &y[2]);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70)) Py_RETURN_NONE;
    return numbers(y, 3);
}

static PyObject *one_linear_limit(
    PyObject *module, PyObject *const *args, Py_ssize_t count) {
    double x[3];
    (void)module;
    if (count != 3 || !given(args, x, count)) Py_RETURN_NONE;
    const double beta = x[0], delta = x[1], d = x[2];
    const double y = haptic_linear_limit(beta, delta, d);
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 &&
        fabs(beta) <= 1e+70)) Py_RETURN_NONE;
    return numbers(&y, 1);
}

#define ONE(name) \
    {"one_" #name, (PyCFunction)(void (*)(void))one_##name, METH_FASTCALL, \
     "The same of numbers; None where one is none or is out of range, or a result is NaN."}

static PyMethodDef functions[] = {
    ONE(discretize),
    ONE(discretize_fractional),
    ONE(is_stable),
    ONE(unstable_roots),
    ONE(stability_boundary),
    ONE(max_stable_stiffness),
    ONE(passivity_margin_at),
    ONE(passivity_margin),
    ONE(passivity_boundary),
    ONE(max_passive_stiffness),
    ONE(linear_limit),
    {"outside", outside, METH_NOARGS,
     "Whether an argument was NaN or out of range since this thread last asked."},
    {NULL, NULL, 0, NULL}};

static PyModuleDef_Slot slots[] = {{Py_mod_exec, loaded}, {0, NULL}};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "_compiled", "The stable forms as ufuncs.", 0, functions, slots,
    NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__compiled(void) { return PyModuleDef_Init(&definition); }
