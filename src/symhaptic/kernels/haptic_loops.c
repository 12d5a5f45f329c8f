/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#include <Python.h>

#include <fenv.h>
#include <math.h>
#include <numpy/npy_common.h>

/* Of each thread its own: whether an argument of its calls was out of range. */
#ifdef _MSC_VER
#define OWN __declspec(thread)
#else
#define OWN _Thread_local
#endif

#ifdef __GNUC__ /* what is not seen from outside can become a part of its loop */
#pragma GCC visibility push(hidden)
#endif

#include "haptic.c"

extern OWN int strayed;

void haptic_discretize_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *y0 = at[2], *y1 = at[3], *y2 = at[4], *y3 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double gamma = *(double const *)x0;
        const double delta = *(double const *)x1;
        haptic_discretize(gamma, delta, (double *)y0, (double *)y1, (double *)y2, (double *)y3);
        if (*(double *)y0 != *(double *)y0 &&
            !(delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) within = 0;
        x0 += s0; x1 += s1; y0 += s2; y1 += s3; y2 += s4; y3 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_discretize_fractional_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4], *y2 = at[5], *y3 = at[6],
        *y4 = at[7];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5], s6 = steps[6], s7 = steps[7];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double gamma = *(double const *)x0;
        const double delta = *(double const *)x1;
        const double epsilon = *(double const *)x2;
        haptic_discretize_fractional(gamma, delta, epsilon, (double *)y0, (double *)y1,
            (double *)y2, (double *)y3, (double *)y4);
        if (*(double *)y0 != *(double *)y0 &&
            !(delta >= 0.0 && delta <= 1e+70 && epsilon >= 0.0 && epsilon < 1.0 && gamma >= 0.0 &&
            gamma <= 1e+15)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4; y2 += s5; y3 += s6; y4 += s7;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_is_stable_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *x4 = at[4], *y0 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double alpha = *(double const *)x0;
        const double beta = *(double const *)x1;
        const double gamma = *(double const *)x2;
        const double delta = *(double const *)x3;
        const double d = *(double const *)x4;
        *(npy_bool *)y0 = haptic_is_stable(alpha, beta, gamma, delta, d);
        within &= d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 &&
            fabs(alpha) <= 1e+70 && fabs(beta) <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; x4 += s4; y0 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_unstable_roots_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *x4 = at[4], *y0 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double alpha = *(double const *)x0;
        const double beta = *(double const *)x1;
        const double gamma = *(double const *)x2;
        const double delta = *(double const *)x3;
        const double d = *(double const *)x4;
        *(double *)y0 = haptic_unstable_roots(alpha, beta, gamma, delta, d);
        within &= d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 &&
            fabs(alpha) <= 1e+70 && fabs(beta) <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; x4 += s4; y0 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_stability_boundary_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *y0 = at[4], *y1 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double theta = *(double const *)x0;
        const double gamma = *(double const *)x1;
        const double delta = *(double const *)x2;
        const double d = *(double const *)x3;
        haptic_stability_boundary(theta, gamma, delta, d, (double *)y0, (double *)y1);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 &&
            gamma <= 1e+15 && theta > 0.0 && theta <= 3.141592653589793)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; y0 += s4; y1 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_max_stable_stiffness_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4], *y2 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double gamma = *(double const *)x0;
        const double delta = *(double const *)x1;
        const double d = *(double const *)x2;
        haptic_max_stable_stiffness(gamma, delta, d, (double *)y0, (double *)y1, (double *)y2);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 &&
            gamma <= 1e+15)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4; y2 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_passivity_margin_at_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *x4 = at[4], *y0 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double theta = *(double const *)x0;
        const double alpha = *(double const *)x1;
        const double beta = *(double const *)x2;
        const double delta = *(double const *)x3;
        const double d = *(double const *)x4;
        *(double *)y0 = haptic_passivity_margin_at(theta, alpha, beta, delta, d);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
            fabs(beta) <= 1e+70 && theta > 0.0 && theta <= 3.141592653589793)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; x4 += s4; y0 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_passivity_margin_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *y0 = at[4];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double alpha = *(double const *)x0;
        const double beta = *(double const *)x1;
        const double delta = *(double const *)x2;
        const double d = *(double const *)x3;
        *(double *)y0 = haptic_passivity_margin(alpha, beta, delta, d);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
            fabs(beta) <= 1e+70)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; y0 += s4;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_passivity_boundary_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double theta = *(double const *)x0;
        const double delta = *(double const *)x1;
        const double d = *(double const *)x2;
        haptic_passivity_boundary(theta, delta, d, (double *)y0, (double *)y1);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && theta > 0.0 &&
            theta <= 3.141592653589793)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_max_passive_stiffness_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *y0 = at[2], *y1 = at[3], *y2 = at[4];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double delta = *(double const *)x0;
        const double d = *(double const *)x1;
        haptic_max_passive_stiffness(delta, d, (double *)y0, (double *)y1, (double *)y2);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70)) within = 0;
        x0 += s0; x1 += s1; y0 += s2; y1 += s3; y2 += s4;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_linear_limit_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double beta = *(double const *)x0;
        const double delta = *(double const *)x1;
        const double d = *(double const *)x2;
        *(double *)y0 = haptic_linear_limit(beta, delta, d);
        if (*(double *)y0 != *(double *)y0 &&
            !(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 &&
            fabs(beta) <= 1e+70)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_late_device_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4], *y2 = at[5], *y3 = at[6];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5], s6 = steps[6];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const double gamma = *(double const *)x0;
        const double delta = *(double const *)x1;
        const double part = *(double const *)x2;
        const Delayed found = late_device(gamma, delta, part);
        *(double *)y0 = found.apart; *(double *)y1 = found.m2; *(double *)y2 =
            found.kicked; *(double *)y3 = found.m0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4; y2 += s5; y3 += s6;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}
