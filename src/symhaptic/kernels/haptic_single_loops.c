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

#include "haptic_single.c"

extern OWN int strayed;

void haptic_single_discretize_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *y0 = at[2], *y1 = at[3], *y2 = at[4], *y3 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float gamma = *(float const *)x0;
        const float delta = *(float const *)x1;
        haptic_single_discretize(gamma, delta, (float *)y0, (float *)y1, (float *)y2, (float *)y3);
        if (*(float *)y0 != *(float *)y0 && !(delta >= 0.0f && delta <= 1e+08f && gamma >= 0.0f &&
            gamma <= 1e+08f)) within = 0;
        x0 += s0; x1 += s1; y0 += s2; y1 += s3; y2 += s4; y3 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_discretize_fractional_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4], *y2 = at[5], *y3 = at[6],
        *y4 = at[7];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5], s6 = steps[6], s7 = steps[7];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float gamma = *(float const *)x0;
        const float delta = *(float const *)x1;
        const float epsilon = *(float const *)x2;
        haptic_single_discretize_fractional(gamma, delta, epsilon, (float *)y0, (float *)y1,
            (float *)y2, (float *)y3, (float *)y4);
        if (*(float *)y0 != *(float *)y0 && !(delta >= 0.0f && delta <= 1e+08f &&
            epsilon >= 0.0f && epsilon < 1.0f && gamma >= 0.0f && gamma <= 1e+08f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4; y2 += s5; y3 += s6; y4 += s7;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_is_stable_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *x4 = at[4], *y0 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float alpha = *(float const *)x0;
        const float beta = *(float const *)x1;
        const float gamma = *(float const *)x2;
        const float delta = *(float const *)x3;
        const float d = *(float const *)x4;
        *(npy_bool *)y0 = haptic_single_is_stable(alpha, beta, gamma, delta, d);
        within &= d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f &&
            fabsf(alpha) <= 1e+08f && fabsf(beta) <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; x4 += s4; y0 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_unstable_roots_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *x4 = at[4], *y0 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float alpha = *(float const *)x0;
        const float beta = *(float const *)x1;
        const float gamma = *(float const *)x2;
        const float delta = *(float const *)x3;
        const float d = *(float const *)x4;
        *(float *)y0 = haptic_single_unstable_roots(alpha, beta, gamma, delta, d);
        within &= d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f &&
            fabsf(alpha) <= 1e+08f && fabsf(beta) <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; x4 += s4; y0 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_stability_boundary_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *y0 = at[4], *y1 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float theta = *(float const *)x0;
        const float gamma = *(float const *)x1;
        const float delta = *(float const *)x2;
        const float d = *(float const *)x3;
        haptic_single_stability_boundary(theta, gamma, delta, d, (float *)y0, (float *)y1);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f && theta > 0.0f &&
            theta <= 3.1415925f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; y0 += s4; y1 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_max_stable_stiffness_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4], *y2 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float gamma = *(float const *)x0;
        const float delta = *(float const *)x1;
        const float d = *(float const *)x2;
        haptic_single_max_stable_stiffness(gamma, delta, d, (float *)y0, (float *)y1, (float *)y2);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4; y2 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_passivity_margin_at_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *x4 = at[4], *y0 = at[5];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float theta = *(float const *)x0;
        const float alpha = *(float const *)x1;
        const float beta = *(float const *)x2;
        const float delta = *(float const *)x3;
        const float d = *(float const *)x4;
        *(float *)y0 = haptic_single_passivity_margin_at(theta, alpha, beta, delta, d);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f && fabsf(alpha) <= 1e+08f && fabsf(beta) <= 1e+08f && theta > 0.0f &&
            theta <= 3.1415925f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; x4 += s4; y0 += s5;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_passivity_margin_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *x3 = at[3], *y0 = at[4];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float alpha = *(float const *)x0;
        const float beta = *(float const *)x1;
        const float delta = *(float const *)x2;
        const float d = *(float const *)x3;
        *(float *)y0 = haptic_single_passivity_margin(alpha, beta, delta, d);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f && fabsf(alpha) <= 1e+08f && fabsf(beta) <= 1e+08f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; x3 += s3; y0 += s4;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_passivity_boundary_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float theta = *(float const *)x0;
        const float delta = *(float const *)x1;
        const float d = *(float const *)x2;
        haptic_single_passivity_boundary(theta, delta, d, (float *)y0, (float *)y1);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f && theta > 0.0f && theta <= 3.1415925f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_max_passive_stiffness_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *y0 = at[2], *y1 = at[3], *y2 = at[4];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float delta = *(float const *)x0;
        const float d = *(float const *)x1;
        haptic_single_max_passive_stiffness(delta, d, (float *)y0, (float *)y1, (float *)y2);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f)) within = 0;
        x0 += s0; x1 += s1; y0 += s2; y1 += s3; y2 += s4;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_linear_limit_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float beta = *(float const *)x0;
        const float delta = *(float const *)x1;
        const float d = *(float const *)x2;
        *(float *)y0 = haptic_single_linear_limit(beta, delta, d);
        if (*(float *)y0 != *(float *)y0 && !(d >= 0.0f && d <= 1e+06f && delta >= 0.0f &&
            delta <= 1e+08f && fabsf(beta) <= 1e+08f)) within = 0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

void haptic_single_late_device_loop(
    char **at, npy_intp const *sizes, npy_intp const *steps, void *data) {
    char *x0 = at[0], *x1 = at[1], *x2 = at[2], *y0 = at[3], *y1 = at[4], *y2 = at[5], *y3 = at[6];
    const npy_intp s0 = steps[0], s1 = steps[1], s2 = steps[2], s3 = steps[3], s4 = steps[4], s5 =
        steps[5], s6 = steps[6];
    npy_intp left;
    int within = 1;
    (void)data;
    for (left = sizes[0]; left > 0; --left) {
        const float gamma = *(float const *)x0;
        const float delta = *(float const *)x1;
        const float part = *(float const *)x2;
        const Delayed found = late_device(gamma, delta, part);
        *(float *)y0 = found.apart; *(float *)y1 = found.m2; *(float *)y2 =
            found.kicked; *(float *)y3 = found.m0;
        x0 += s0; x1 += s1; x2 += s2; y0 += s3; y1 += s4; y2 += s5; y3 += s6;
    }
    if (!within) strayed = 1;
    feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}
