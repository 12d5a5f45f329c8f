/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/ufuncobject.h>

#include <fenv.h>

#include "haptic.h"
#include "haptic_single.h"

#define MOST 8

static void haptic_discretize_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        double found[4];
        haptic_discretize(*(double *)(at[0]), *(double *)(at[1]), &found[0], &found[1], &found[2], &found[3]);
        *(double *)at[2] = found[0];
        *(double *)at[3] = found[1];
        *(double *)at[4] = found[2];
        *(double *)at[5] = found[3];
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_discretize_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        float found[4];
        haptic_single_discretize(*(float *)(at[0]), *(float *)(at[1]), &found[0], &found[1], &found[2], &found[3]);
        *(float *)at[2] = found[0];
        *(float *)at[3] = found[1];
        *(float *)at[4] = found[2];
        *(float *)at[5] = found[3];
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_discretize_fractional_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[8];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 8; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        double found[5];
        haptic_discretize_fractional(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), &found[0], &found[1], &found[2], &found[3], &found[4]);
        *(double *)at[3] = found[0];
        *(double *)at[4] = found[1];
        *(double *)at[5] = found[2];
        *(double *)at[6] = found[3];
        *(double *)at[7] = found[4];
        for (k = 0; k < 8; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_discretize_fractional_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[8];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 8; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        float found[5];
        haptic_single_discretize_fractional(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), &found[0], &found[1], &found[2], &found[3], &found[4]);
        *(float *)at[3] = found[0];
        *(float *)at[4] = found[1];
        *(float *)at[5] = found[2];
        *(float *)at[6] = found[3];
        *(float *)at[7] = found[4];
        for (k = 0; k < 8; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_is_stable_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(npy_bool *)at[5] = haptic_is_stable(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), *(double *)(at[3]), *(double *)(at[4]));
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_is_stable_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(npy_bool *)at[5] = haptic_single_is_stable(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), *(float *)(at[3]), *(float *)(at[4]));
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_unstable_roots_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(double *)at[5] = haptic_unstable_roots(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), *(double *)(at[3]), *(double *)(at[4]));
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_unstable_roots_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(float *)at[5] = haptic_single_unstable_roots(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), *(float *)(at[3]), *(float *)(at[4]));
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_stability_boundary_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        double found[2];
        haptic_stability_boundary(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), *(double *)(at[3]), &found[0], &found[1]);
        *(double *)at[4] = found[0];
        *(double *)at[5] = found[1];
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_stability_boundary_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        float found[2];
        haptic_single_stability_boundary(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), *(float *)(at[3]), &found[0], &found[1]);
        *(float *)at[4] = found[0];
        *(float *)at[5] = found[1];
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_max_stable_stiffness_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        double found[3];
        haptic_max_stable_stiffness(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), &found[0], &found[1], &found[2]);
        *(double *)at[3] = found[0];
        *(double *)at[4] = found[1];
        *(double *)at[5] = found[2];
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_max_stable_stiffness_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        float found[3];
        haptic_single_max_stable_stiffness(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), &found[0], &found[1], &found[2]);
        *(float *)at[3] = found[0];
        *(float *)at[4] = found[1];
        *(float *)at[5] = found[2];
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_passivity_margin_at_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(double *)at[5] = haptic_passivity_margin_at(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), *(double *)(at[3]), *(double *)(at[4]));
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_passivity_margin_at_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[6];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 6; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(float *)at[5] = haptic_single_passivity_margin_at(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), *(float *)(at[3]), *(float *)(at[4]));
        for (k = 0; k < 6; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_passivity_margin_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[5];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 5; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(double *)at[4] = haptic_passivity_margin(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), *(double *)(at[3]));
        for (k = 0; k < 5; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_passivity_margin_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[5];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 5; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(float *)at[4] = haptic_single_passivity_margin(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), *(float *)(at[3]));
        for (k = 0; k < 5; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_passivity_boundary_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[5];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 5; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        double found[2];
        haptic_passivity_boundary(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]), &found[0], &found[1]);
        *(double *)at[3] = found[0];
        *(double *)at[4] = found[1];
        for (k = 0; k < 5; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_passivity_boundary_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[5];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 5; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        float found[2];
        haptic_single_passivity_boundary(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]), &found[0], &found[1]);
        *(float *)at[3] = found[0];
        *(float *)at[4] = found[1];
        for (k = 0; k < 5; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_max_passive_stiffness_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[5];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 5; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        double found[3];
        haptic_max_passive_stiffness(*(double *)(at[0]), *(double *)(at[1]), &found[0], &found[1], &found[2]);
        *(double *)at[2] = found[0];
        *(double *)at[3] = found[1];
        *(double *)at[4] = found[2];
        for (k = 0; k < 5; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_max_passive_stiffness_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[5];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 5; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        float found[3];
        haptic_single_max_passive_stiffness(*(float *)(at[0]), *(float *)(at[1]), &found[0], &found[1], &found[2]);
        *(float *)at[2] = found[0];
        *(float *)at[3] = found[1];
        *(float *)at[4] = found[2];
        for (k = 0; k < 5; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_linear_limit_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[4];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 4; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(double *)at[3] = haptic_linear_limit(*(double *)(at[0]), *(double *)(at[1]), *(double *)(at[2]));
        for (k = 0; k < 4; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

static void haptic_single_linear_limit_loop(
    char **args, npy_intp const *sizes, npy_intp const *strides, void *data) {
    char *at[4];
    npy_intp i, k;
    (void)data;
    for (k = 0; k < 4; ++k) at[k] = args[k];
    for (i = 0; i < sizes[0]; ++i) {
        *(float *)at[3] = haptic_single_linear_limit(*(float *)(at[0]), *(float *)(at[1]), *(float *)(at[2]));
        for (k = 0; k < 4; ++k) at[k] += strides[k];
    }
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

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
    "Domain: gamma >= 0, delta >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70.\n"),
    ENTRY(discretize_fractional, 3, 5, 0,
    "m2, m1, m0, a, e of (gamma, delta, epsilon)\n"
    "\n"
    "the sampled device behind a delay of epsilon periods, P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e)) in units of T^2/m.\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "epsilon: rest of a delay, a fraction of a period [1]\n"
    "Domain: gamma >= 0, delta >= 0, 0 <= epsilon < 1.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70.\n"),
    ENTRY(is_stable, 5, 1, 1,
    "stable of (alpha, beta, gamma, delta, d)\n"
    "\n"
    "whether all characteristic roots lie inside the unit circle.\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: gamma >= 0, delta >= 0, d >= 0, no 0 < delta < 5 ulp(1) where sqrt(gamma) is a whole multiple of pi, rounded.\n"
    "False outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(unstable_roots, 5, 1, 0,
    "roots of (alpha, beta, gamma, delta, d)\n"
    "\n"
    "number of characteristic roots outside the unit circle.\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: gamma >= 0, delta >= 0, d >= 0, no 0 < delta < 5 ulp(1) where sqrt(gamma) is a whole multiple of pi, rounded.\n"
    "-1 outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(stability_boundary, 4, 2, 0,
    "alpha, beta of (theta, gamma, delta, d)\n"
    "\n"
    "the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).\n"
    "theta: angle on the unit circle, omega T [1]\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(max_stable_stiffness, 3, 3, 0,
    "alpha, beta, theta of (gamma, delta, d)\n"
    "\n"
    "the wall of largest stable stiffness, a limit that is not stable itself, and the angle theta = omega T of its roots on the unit circle.\n"
    "gamma: physical stiffness, k T^2/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: gamma >= 0, delta >= 0, d >= 0, gamma <= 9.8, sqrt(gamma) (d + 1) <= pi or d <= 1, no 0 < delta < 5 ulp(1) if sqrt(gamma) (d + 1) > pi, NaN elsewhere and where no wall is stable.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(passivity_margin_at, 5, 1, 0,
    "margin of (theta, alpha, beta, delta, d)\n"
    "\n"
    "physical damping minus the damping that the wall needs at the angle theta = omega T; the wall is passive where it is positive at every angle.\n"
    "theta: angle on the unit circle, omega T [1]\n"
    "alpha: virtual stiffness, K T^2/m [1]\n"
    "beta: virtual damping, B T/m [1]\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
    "Domain: 0 < theta < pi, delta >= 0, d >= 0, d whole, or fractional on the principal sheet.\n"
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
    "Domain: 0 < theta < pi, delta >= 0, d >= 0, NaN beyond the angle where alpha is 0: pi/(d + 1) for whole delays, for d <= 2/9 the curve goes on to pi.\n"
    "NaN outside, and where an argument is NaN or larger than 1e70 or d larger than 1e15.\n"),
    ENTRY(max_passive_stiffness, 2, 3, 0,
    "alpha, beta, theta of (delta, d)\n"
    "\n"
    "the passive wall of largest stiffness, and its worst angle theta = omega T.\n"
    "delta: physical damping, b T/m [1]\n"
    "d: delay in sampling periods, t_d/T [1]\n"
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
    PyModuleDef_HEAD_INIT, "_compiled", "The stable forms as ufuncs.", 0, NULL, slots,
    NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__compiled(void) { return PyModuleDef_Init(&definition); }
