/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#include "haptic_single.h"

#include <math.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif

// 1/n!
static const float inverse_factorial[] =
    {1.0f, 1.0f, 0.5f, 0.16666667f, 0.041666668f, 0.008333334f, 0.0013888889f, 0.0001984127f,
    2.4801588e-05f, 2.7557319e-06f, 2.755732e-07f, 2.5052108e-08f, 2.0876756e-09f, 1.6059044e-10f,
    1.1470745e-11f, 7.6471636e-13f, 4.7794773e-14f, 2.8114574e-15f, 1.5619207e-16f, 8.220635e-18f,
    4.1103176e-19f};

// x + y and what it misses, for |x| >= |y|
static inline void fast_two_sum(float x, float y, float *total_out, float *lost_out) {
    const float total = x + y, back = total - x;
    *total_out = total; *lost_out = -back + y; return;
}

// x - y and what it misses
static inline void two_diff(float x, float y, float *total_out, float *lost_out) {
    const float total = x - y, back = total - x, rest = -back + total, one = -rest + x;
    const float two = -back - y;
    *total_out = total; *lost_out = one + two; return;
}

// w = delta^2/4 - gamma, what it misses, its root and the size of the poles
static inline void device_motion(float gamma, float delta, float *w_out, float *w_low_out,
    float *root_out, float *reach_out) {
    const float half = 0.5f*delta, square = (half*half);
    float total, lost; two_diff(square, gamma, &total, &lost);
    const float rest = lost + fmaf(half, half, -(half*half));
    float total2, lost2; fast_two_sum(total, rest, &total2, &lost2);
    const float root = sqrtf(fabsf(total2));
    *w_out = total2; *w_low_out = lost2; *root_out = root;
    *reach_out = (total2 < 0.0f ? 0.25f*gamma : 0.44444445f*half + 0.44444445f*root);
    return;
}

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static inline float decay_series(float x) {
    const float square = (x*x);
    return square*(square*(square*(2.5052108e-08f*square + 2.7557319e-06f) + 0.0001984127f) +
        0.008333334f) - x*(square*(square*(square*(2.0876756e-09f*square + 2.755732e-07f) +
        2.4801588e-05f) + 0.0013888889f) + 0.041666668f) + 0.16666667f;
}

// x (y + y_low) and what it misses
static inline void wide_prod(float x, float y, float y_low, float *total_out, float *lost_out) {
    *total_out = x*y; *lost_out = x*y_low + fmaf(x, y, -(x*y)); return;
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4
static inline void brief_fading(float rate, float low, float *fall_out, float *fall_low_out,
    float *mean_out, float *mean_low_out) {
    float total, lost; fast_two_sum(1.0f, -0.5f*rate, &total, &lost);
    const float curved = (rate*rate)*decay_series(rate);
    float total2, lost2; fast_two_sum(total, curved, &total2, &lost2);
    const float bent = low*(0.125f*(rate*rate) - 0.33333334f*rate + 0.5f);
    const float mean_low = -bent + lost + lost2;
    float total3, lost3; wide_prod(rate, total2, mean_low, &total3, &lost3);
    float total4, lost4; fast_two_sum(1.0f, -total3, &total4, &lost4);
    const float off = lost3 + low*total2;
    *fall_out = total4; *fall_low_out = lost4 - off; *mean_out = total2;
    *mean_low_out = mean_low; return;
}

// (x + x_low)/(y + y_low) and what it misses
static inline void wide_quot(float x, float y, float x_low, float y_low, float *total_out,
    float *lost_out) {
    const float total = x/y, left = -total*y + x;
    const float left2 = left - fmaf(total, y, -(total*y)), rest = -total*y_low + x_low;
    const float left3 = left2 + rest;
    *total_out = total; *lost_out = left3/y; return;
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss
static inline void fading_pair(float rate, float low, float *fall_out, float *fall_low_out,
    float *mean_out, float *mean_low_out) {
    if (rate < 0.75f) {
        float fall, fall_low, mean, mean_low;
        brief_fading(rate, low, &fall, &fall_low, &mean, &mean_low);
        *fall_out = fall; *fall_low_out = fall_low; *mean_out = mean;
        *mean_low_out = mean_low; return;
    }
    const float sunk = expf(-rate);
    float total, lost; fast_two_sum(1.0f, -sunk, &total, &lost);
    const float sunk_low = -low*sunk;
    float total2, lost2; wide_quot(total, rate, lost - sunk_low, low, &total2, &lost2);
    *fall_out = sunk; *fall_low_out = sunk_low; *mean_out = total2;
    *mean_low_out = lost2; return;
}

// number + delta one - gamma two and what it misses, of pairs
static inline void plant_n0_term(float gamma, float delta, float one, float one_low, float two,
    float two_low, float number, float *total_out, float *low_out) {
    float total, lost; wide_prod(delta, one, one_low, &total, &lost);
    float total2, lost2; wide_prod(gamma, two, two_low, &total2, &lost2);
    float total3, lost3; two_diff(total, total2, &total3, &lost3);
    float total4, lost4; two_diff(total3, -number, &total4, &lost4);
    const float rest = lost - lost2, both = lost3 + lost4;
    *total_out = total4; *low_out = both + rest; return;
}

// divided difference of exp at 0, p and q, less 1/2
static inline float plant_n0_series(float gamma, float delta) {
    float one = 0.0f, two = 0.0f;
    for (int n = ((0.5f*delta < 0.0625f) && (fabsf(gamma) < 0.00390625f) ? 9 :
        20); n >= 6; n -= 1) {
        const float number = inverse_factorial[n], next_one = delta*one - gamma*two + number;
        two = one; one = next_one;
    }
    float one2, one_low;
    plant_n0_term(gamma, delta, one, 0.0f, two, 0.0f, 0.008333334f, &one2, &one_low);
    float one3, one_low2;
    plant_n0_term(gamma, delta, one2, one_low, one, 0.0f, 0.041666668f, &one3, &one_low2);
    float one4, one_low3;
    plant_n0_term(gamma, delta, one3, one_low2, one2, one_low, 0.16666667f, &one4, &one_low3);
    float one5, one_low4;
    plant_n0_term(gamma, delta, one4, one_low3, one3, one_low2, 0.0f, &one5, &one_low4);
    return one5 + one_low4;
}

// (fall + fall_low) (y + z), rounded once
static inline float scaled_sum(float fall, float fall_low, float y, float z) {
    float total, lost; two_diff(y, -z, &total, &lost);
    float total2, lost2; wide_prod(fall, total, lost, &total2, &lost2);
    const float low = fall_low*total + lost2;
    return low + total2;
}

// n0 of a device with slow poles
static inline float plant_n0_near(float fade_, float fade_low, float gamma, float delta) {
    float total, lost; wide_prod(fade_, fade_, 2.0f*fade_low, &total, &lost);
    return scaled_sum(total, lost, plant_n0_series(gamma, delta), 0.5f);
}

// n0 of a creeping device
static inline float plant_n0_creep(float reach, float fade_, float fade_low, float gamma,
    float delta, float p, float p_low, float slow, float slow_low, float mean, float mean_low,
    float ratio, float ratio_low, float even, float even_low) {
    if (reach < 0.5625f) { return plant_n0_near(fade_, fade_low, gamma, delta); }
    float total, lost; wide_prod(ratio, mean, mean_low, &total, &lost);
    float total2, lost2; two_diff(even, total, &total2, &lost2);
    const float pulled_low = lost + mean*ratio_low;
    const float rest = even_low + lost2 - pulled_low;
    float total3, lost3; wide_quot(total2, p, rest, p_low, &total3, &lost3);
    float total4, lost4; wide_prod(slow, total3, lost3, &total4, &lost4);
    const float low = lost4 + slow_low*total3;
    return low + total4;
}

// n0 of a swinging device
static inline float plant_n0_swing(float reach, float fade_, float fade_low, float half,
    float envelope, float even, float even_low, float wave, float wave_low, float gamma,
    float near, float known) {
    if (reach < 0.5625f) { return plant_n0_near(fade_, fade_low, gamma, 2.0f*half); }
    if (near > 0.0f) { return known; }
    float total, lost; wide_prod(half, wave, wave_low, &total, &lost);
    float total2, lost2; two_diff(total, even, &total2, &lost2);
    float total3, lost3; two_diff(total2, -envelope, &total3, &lost3);
    const float rest = -even_low + lost + lost2 + lost3;
    float total4, lost4; wide_prod(envelope, total3, rest, &total4, &lost4);
    const float whole = (gamma == 0.0f ? 1.0f : gamma);
    float total5, lost5; wide_quot(total4, whole, lost4, 0.0f, &total5, &lost5);
    return lost5 + total5;
}

// divided difference of exp at h and +-sqrt(w), less 1/2
static inline float plant_n1_series(float h, float w) {
    float total = 0.0f, one = 0.0f, two = 0.0f;
    for (int n = ((fabsf(w) < 0.00390625f) && (h < 0.0625f) ? 9 : 20); n >= 3; n -= 1) {
        const float number = inverse_factorial[n], even = number + two*w;
        total = even + h*total; two = one; one = even;
    }
    return h*total + two*w;
}

// n1 of a creeping device
static inline float plant_n1_creep(float reach, float fade_, float fade_low, float half, float w,
    float p, float p_low, float slow, float slow_low, float mean, float mean_low, float even,
    float even_low) {
    if (reach < 0.5625f) { return scaled_sum(fade_, fade_low, plant_n1_series(half, w), 0.5f); }
    float total, lost; wide_prod(slow, even, even_low, &total, &lost);
    float total2, lost2; two_diff(mean, total, &total2, &lost2);
    const float pulled_low = even*slow_low + lost, rest = lost2 + mean_low - pulled_low;
    float total3, lost3; wide_quot(total2, p, rest, p_low, &total3, &lost3);
    return lost3 + total3;
}

// n1 of a swinging device
static inline float plant_n1_swing(float reach, float fade_, float fade_low, float half, float w,
    float envelope, float even, float even_low, float wave, float wave_low, float gamma,
    float near, float known) {
    if (reach < 0.5625f) { return scaled_sum(fade_, fade_low, plant_n1_series(half, w), 0.5f); }
    if (near > 0.0f) { return known; }
    float total, lost; wide_prod(half, wave, wave_low, &total, &lost);
    float total2, lost2; two_diff(even, -total, &total2, &lost2);
    float total3, lost3;
    wide_prod(envelope, total2, even_low + lost + lost2, &total3, &lost3);
    float total4, lost4; fast_two_sum(1.0f, -total3, &total4, &lost4);
    const float whole = (gamma == 0.0f ? 1.0f : gamma);
    float total5, lost5; wide_quot(total4, whole, -lost3 + lost4, 0.0f, &total5, &lost5);
    return lost5 + total5;
}

// a of a creeping device
static inline float plant_trace_creep(float slow, float slow_low, float ratio, float ratio_low) {
    float total, lost; fast_two_sum(1.0f, ratio, &total, &lost);
    float total2, lost2; wide_prod(slow, total, lost + ratio_low, &total2, &lost2);
    const float low = lost2 + slow_low*total;
    return low + total2;
}

// a of a swinging device
static inline float plant_trace_swing(float envelope, float even, float even_low) {
    float total, lost; wide_prod(envelope, even, even_low, &total, &lost);
    return 2.0f*lost + 2.0f*total;
}

// what the root of |square + square_low| misses
static inline float root_miss(float square, float square_low, float root) {
    const float sign_low = (square < 0.0f ? -square_low : square_low);
    const float left = -(root*root) + fabsf(square);
    const float left2 = left - fmaf(root, root, -(root*root)), left3 = left2 + sign_low;
    const float whole = (root == 0.0f ? 1.0f : root);
    return 0.5f*left3/whole;
}

// the poles p = half + root and q = gamma/p and what they miss
static inline void real_poles(float gamma, float half, float w, float w_low, float root,
    float *p_out, float *p_low_out, float *q_out, float *q_low_out) {
    float total, lost; fast_two_sum(half, root, &total, &lost);
    const float p_low = lost + root_miss(w, w_low, root);
    const float whole = (total == 0.0f ? 1.0f : total), q = gamma/whole;
    const float off = gamma - q*whole, off2 = off - fmaf(whole, q, -(whole*q));
    const float off3 = off2 - p_low*q;
    *p_out = whole; *p_low_out = p_low; *q_out = q; *q_low_out = off3/whole; return;
}

// exp(-half) of a device with slow poles, and what it misses
static inline void slow_fade(float reach, float half, float *fade_out, float *low_out) {
    if (reach < 0.5625f) {
        float fall, fall_low, mean, mean_low;
        brief_fading(0.5f*half, 0.0f, &fall, &fall_low, &mean, &mean_low);
        float total, lost; wide_prod(fall, fall, 2.0f*fall_low, &total, &lost);
        *fade_out = total; *low_out = lost; return;
    }
    *fade_out = 0.0f; *low_out = 0.0f; return;
}

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static inline float cos_series(float w) {
    const float square = (w*w);
    float one = 0.0f, two = 0.0f;
    for (int n = 14; n >= 6; n -= 2) {
        const float number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.041666668f;
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static inline float sin_series(float w) {
    const float square = (w*w);
    float one = 0.0f, two = 0.0f;
    for (int n = 13; n >= 5; n -= 2) {
        const float number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.16666667f;
}

// cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle
static inline void waving_pair(float square, float square_low, float angle, float *even_out,
    float *even_low_out, float *odd_out, float *odd_low_out) {
    if (square > -1.5f) {
        float total, lost; fast_two_sum(1.0f, 0.5f*square, &total, &lost);
        const float curved = (square*square)*cos_series(square);
        float total2, lost2; fast_two_sum(total, curved, &total2, &lost2);
        const float both = lost + lost2, bent = square*sin_series(square);
        float total3, lost3; fast_two_sum(1.0f, bent, &total3, &lost3);
        *even_out = total2; *even_low_out = both + 0.5f*square_low; *odd_out = total3;
        *odd_low_out = lost3 + 0.16666667f*square_low; return;
    }
    const float angle_low = root_miss(square, square_low, angle), sine = sinf(angle);
    const float cosine = cosf(angle);
    float total4, lost4;
    wide_quot(sine, angle, angle_low*cosine, angle_low, &total4, &lost4);
    *even_out = cosine; *even_low_out = -angle_low*sine; *odd_out = total4;
    *odd_low_out = lost4; return;
}

// x y and what it misses
static inline void two_prod(float x, float y, float *total_out, float *lost_out) {
    *total_out = x*y; *lost_out = fmaf(x, y, -(x*y)); return;
}

// whether the device has nearly swung whole turns; n1, n0 and n1 + n0 there
static inline void whole_turns(float half, float square, float square_low, float root, float stiff,
    float *near_out, float *risen_out, float *sunk_out, float *moved_out) {
    if ((half < 0.75f) && (root < 4096.0f) && (root > 3.0f)) {
        const float count = floorf(0.5f*root/3.1415927f + 0.5f);
        float total8, lost8; two_prod(count, 6.2831855f, &total8, &lost8);
        float total9, lost9; two_diff(root, -total8, &total9, &lost9);
        const float missed = root_miss(square, square_low, root), turns = (count*count);
        float total, lost; two_prod(turns, 39.478416f, &total, &lost);
        float total2, lost2; two_prod(turns, 1.1614864e-06f, &total2, &lost2);
        float total3, lost3; two_diff(-square, total, &total3, &lost3);
        float total4, lost4; two_diff(total3, lost, &total4, &lost4);
        float total5, lost5; two_diff(total4, total2, &total5, &lost5);
        float total6, lost6; two_diff(total5, square_low, &total6, &lost6);
        const float turned_low = -1.1704737e-14f*turns;
        const float low = -lost2 + lost3 + lost4 + lost5 + lost6 - turned_low;
        float total7, lost7; two_diff(total6, -low, &total7, &lost7);
        const float back = -1.7484555e-07f*count;
        const float both_low = back + lost8 + lost9 + missed;
        const float whole = (total9 == 0.0f ? 1.0f : total9);
        float total10, lost10; wide_quot(total7, whole, lost7, both_low, &total10, &lost10);
        const float far = (total10*total10);
        if ((count > 0.0f) && (far < 1.5f)) {
            float fall, fall_low, mean, mean_low;
            brief_fading(half, 0.0f, &fall, &fall_low, &mean, &mean_low);
            float total26, lost26; fast_two_sum(1.0f, -fall, &total26, &lost26);
            float total11, lost11; wide_prod(total10, total10, 2.0f*lost10, &total11, &lost11);
            float total13, lost13;
            fast_two_sum(1.0f, -total11*sin_series(-total11), &total13, &lost13);
            float total14, lost14; wide_prod(total10, total13, lost13, &total14, &lost14);
            const float bent = (total11*total11)*cos_series(-total11);
            float total12, lost12; fast_two_sum(0.5f*total11, -bent, &total12, &lost12);
            const float lift_low = 0.5f*lost11*total13 + lost12;
            float total19, lost19; wide_prod(fall, total12, lift_low, &total19, &lost19);
            float total29, lost29; wide_prod(fall, total12, lift_low, &total29, &lost29);
            float total15, lost15;
            wide_quot(total14, root, lost10*(1.0f - total12) + lost14, missed, &total15, &lost15);
            float total16, lost16; wide_prod(fall, total15, lost15, &total16, &lost16);
            float total17, lost17; two_diff(mean, total16, &total17, &lost17);
            float total21, lost21; two_diff(mean, total15, &total21, &lost21);
            float total22, lost22;
            wide_prod(half, total21, -lost15 + lost21 + mean_low, &total22, &lost22);
            float total23, lost23; two_diff(total12, total22, &total23, &lost23);
            const float whole2 = (stiff == 0.0f ? 1.0f : stiff);
            const float low2 = -fall_low*total15 - lost16 + lost17 + mean_low;
            float total18, lost18; wide_prod(half, total17, low2, &total18, &lost18);
            float total20, lost20; two_diff(total18, -total19, &total20, &lost20);
            const float low3 = lift_low - lost22 + lost23;
            float total24, lost24; two_diff(total23, -low3, &total24, &lost24);
            float total25, lost25; wide_prod(fall, total24, lost24, &total25, &lost25);
            const float low4 = -fall_low + lost26;
            float total27, lost27; fast_two_sum(total26, low4, &total27, &lost27);
            float total28, lost28; wide_prod(total27, total27, 2.0f*lost27, &total28, &lost28);
            float total30, lost30; two_diff(total28, -2.0f*total29, &total30, &lost30);
            const float low5 = fall_low*total12 + lost18 + lost19 + lost20;
            float total31, lost31; wide_quot(total20, whole2, low5, 0.0f, &total31, &lost31);
            const float low6 = fall_low*total24 + lost25;
            float total32, lost32; wide_quot(total25, whole2, low6, 0.0f, &total32, &lost32);
            const float low7 = 2.0f*fall_low*total12 + lost28 + 2.0f*lost29 + lost30;
            float total33, lost33; wide_quot(total30, whole2, low7, 0.0f, &total33, &lost33);
            *near_out = 1.0f; *risen_out = lost31 + total31;
            *sunk_out = lost32 + total32; *moved_out = lost33 + total33; return;
        }
        *near_out = 0.0f; *risen_out = 0.0f; *sunk_out = 0.0f; *moved_out = 0.0f;
        return;
    }
    *near_out = 0.0f; *risen_out = 0.0f; *sunk_out = 0.0f; *moved_out = 0.0f; return;
}

// n0, the same device with its time reversed, times exp(-delta); n1, how far a unit force moves the
// device in a period; a, the sum of the sampled device's poles
static inline void device_n0_n1_trace(float gamma, float delta, float *n0_out, float *n1_out,
    float *trace_out) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
        const float envelope = expf(-half);
        *n0_out = plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd,
            odd_low, gamma, near, sunk);
        *n1_out = plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
        *trace_out = plant_trace_swing(envelope, even, even_low); return;
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *n0_out = plant_n0_creep(reach, fade_, fade_low, gamma, delta, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2, mean2, mean_low2);
    *n1_out = plant_n1_creep(reach, fade_, fade_low, half, w, p, p_low, fall, fall_low, mean,
        mean_low, mean2, mean_low2);
    *trace_out = plant_trace_creep(fall, fall_low, fall2, fall_low2); return;
}

// exp(-p), of the faster pole, and what it misses
static inline void fast_fall(float slow, float slow_low, float ratio, float ratio_low,
    float *fast_out, float *low_out) {
    float total, lost; wide_prod(slow, ratio, ratio_low, &total, &lost);
    *fast_out = total; *low_out = lost + ratio*slow_low; return;
}

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static inline float numerator_at_one_series(float h, float w) {
    const float y = (h*h);
    float total = 0.0f, inner = 0.0f;
    for (int n = ((fabsf(w) < 0.00390625f) && (h < 0.0625f) ? 8 : 20); n >= 4; n -= 2) {
        const float number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y;
}

// n1 + n0 of a creeping device
static inline float numerator_at_one_creep(float reach, float half, float w, float p, float p_low,
    float slow, float slow_low, float mean, float mean_low, float ratio, float ratio_low) {
    if (reach < 1.0f) {
        return 2.0f*scaled_sum(expf(-half), 0.0f, numerator_at_one_series(half, w), 0.5f);
    }
    float fast, fast_low; fast_fall(slow, slow_low, ratio, ratio_low, &fast, &fast_low);
    float total, lost; fast_two_sum(1.0f, -fast, &total, &lost);
    float total2, lost2; wide_prod(mean, total, -fast_low + lost, &total2, &lost2);
    const float moved_low = lost2 + mean_low*total;
    float total3, lost3; wide_quot(total2, p, moved_low, p_low, &total3, &lost3);
    return lost3 + total3;
}

// (1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses
static inline void half_squares(float half, float envelope, float wave, float back,
    float *total_out, float *low_out) {
    float total, lost; two_diff(wave, back, &total, &lost);
    float total2, lost2; two_prod(total, total, &total2, &lost2);
    const float grown = -0.5f*expm1f(-half), low = 2.0f*lost*total + lost2;
    float total3, lost3; wide_prod(envelope, total2, low, &total3, &lost3);
    float total4, lost4; two_diff(total3, -(grown*grown), &total4, &lost4);
    *total_out = total4; *low_out = lost3 + lost4; return;
}

// n1 + n0 of a swinging device
static inline float numerator_at_one_swing(float reach, float half, float w, float w_low,
    float envelope, float root, float gamma, float near, float known) {
    if (reach < 1.0f) {
        return 2.0f*scaled_sum(envelope, 0.0f, numerator_at_one_series(half, w), 0.5f);
    }
    if (near > 0.0f) { return known; }
    const float angle = 0.5f*root, back = -0.5f*root_miss(w, w_low, root)*cosf(angle);
    float total, low; half_squares(half, envelope, sinf(angle), back, &total, &low);
    const float whole = (gamma == 0.0f ? 1.0f : gamma);
    float total2, lost; wide_quot(total, whole, low, 0.0f, &total2, &lost);
    return 4.0f*lost + 4.0f*total2;
}

// n1 + n0; a, the sum of the sampled device's poles
static inline void device_together_trace(float gamma, float delta, float *together_out,
    float *trace_out) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        const float envelope = expf(-half);
        *together_out = numerator_at_one_swing(reach, half, w, w_low, envelope, root, gamma, near,
            moved);
        *trace_out = plant_trace_swing(envelope, even, even_low); return;
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *together_out = numerator_at_one_creep(reach, half, w, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2);
    *trace_out = plant_trace_creep(fall, fall_low, fall2, fall_low2); return;
}

// n0, the same device with its time reversed, times exp(-delta)
static inline float plant_n0(float gamma, float delta) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    if (reach < 0.5625f) { return plant_n0_near(fade_, fade_low, gamma, delta); }
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        const float envelope = expf(-half);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        return plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd, odd_low,
            gamma, near, sunk);
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    return plant_n0_creep(reach, fade_, fade_low, gamma, delta, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2, mean2, mean_low2);
}

// n1, how far a unit force moves the device in a period
static inline float plant_n1(float gamma, float delta) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    if (reach < 0.5625f) { return scaled_sum(fade_, fade_low, plant_n1_series(half, w), 0.5f); }
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        const float envelope = expf(-half);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        return plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    return plant_n1_creep(reach, fade_, fade_low, half, w, p, p_low, fall, fall_low, mean,
        mean_low, mean2, mean_low2);
}

// (1 - exp(-x))/x
static inline float decay(float x) {
    if (x == 0.0f) { return 1.0f; }
    return -expm1f(-x)/x;
}

// 1 + a + e of a creeping device
static inline float denominator_at_minus_one_creep(float slow, float slow_low, float ratio,
    float ratio_low) {
    float total, lost; fast_two_sum(1.0f, slow, &total, &lost);
    float fast, fast_low; fast_fall(slow, slow_low, ratio, ratio_low, &fast, &fast_low);
    float total2, lost2; fast_two_sum(1.0f, fast, &total2, &lost2);
    float total3, lost3; wide_prod(total, total2, fast_low + lost2, &total3, &lost3);
    const float low = lost3 + total2*(lost + slow_low);
    return low + total3;
}

// 1 + a + e of a swinging device
static inline float denominator_at_minus_one_swing(float half, float w, float w_low,
    float envelope, float even, float even_low, float root) {
    float total3, lost2; wide_prod(2.0f*envelope, even, even_low, &total3, &lost2);
    if (total3 > 0.0f) {
        const float e = expf(-2.0f*half);
        float total2, lost; fast_two_sum(1.0f, e, &total2, &lost);
        float total4, lost3; fast_two_sum(total2, total3, &total4, &lost3);
        const float rest = lost + lost2 + lost3;
        return rest + total4;
    }
    const float angle = 0.5f*root, back = 0.5f*root_miss(w, w_low, root)*sinf(angle);
    float total, low; half_squares(half, envelope, cosf(angle), back, &total, &low);
    return 4.0f*low + 4.0f*total;
}

// divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6
static inline float numerator_gap_series(float h, float w) {
    const float y = (h*h);
    float total = 0.0f, inner = 0.0f;
    for (int n = ((fabsf(w) < 0.00390625f) && (h < 0.0625f) ? 9 : 19); n >= 5; n -= 2) {
        const float number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y - 4.967054e-09f;
}

// (n1 - n0)/delta of a creeping device
static inline float numerator_gap_creep(float reach, float half, float w, float delta, float p,
    float slow, float mean, float mean_low, float ratio, float even, float even_low) {
    if (reach < 1.0f) {
        return scaled_sum(expf(-half), 0.0f, numerator_gap_series(half, w), 0.16666667f);
    }
    const float fast = ratio*slow;
    float total3, lost3; wide_prod(fast, mean, mean_low, &total3, &lost3);
    const float twice = 2.0f*slow;
    float total, lost; wide_prod(twice, even, even_low, &total, &lost);
    float total2, lost2; two_diff(mean, total, &total2, &lost2);
    const float top = total2 + total3, rest = -lost + lost3 + mean_low;
    const float low = lost2 + rest, whole = (delta*p == 0.0f ? 1.0f : delta*p);
    return (low + top)/whole;
}

// (n1 - n0)/delta of a swinging device
static inline float numerator_gap_swing(float reach, float half, float w, float envelope,
    float wave, float wave_low, float gamma, float delta) {
    if (reach < 1.0f) {
        return scaled_sum(envelope, 0.0f, numerator_gap_series(half, w), 0.16666667f);
    }
    float total, lost; wide_prod(envelope, wave, wave_low, &total, &lost);
    const float mean = decay(delta);
    float total2, lost2; two_diff(mean, total, &total2, &lost2);
    const float whole = (gamma == 0.0f ? 1.0f : gamma);
    float total3, lost3; wide_quot(total2, whole, -lost + lost2, 0.0f, &total3, &lost3);
    return lost3 + total3;
}

// 1 + a + e; n1 + n0; (n1 - n0)/delta; n0, the same device with its time reversed, times
// exp(-delta); n1, how far a unit force moves the device in a period
static inline void device_at_minus_one_together_n_gap_n0_n1(float gamma, float delta,
    float *at_minus_one_out, float *together_out, float *n_gap_out, float *n0_out, float *n1_out) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
        const float envelope = expf(-half);
        *at_minus_one_out = denominator_at_minus_one_swing(half, w, w_low, envelope, even,
            even_low, root);
        *together_out = numerator_at_one_swing(reach, half, w, w_low, envelope, root, gamma, near,
            moved);
        *n_gap_out = numerator_gap_swing(reach, half, w, envelope, odd, odd_low, gamma, delta);
        *n0_out = plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd,
            odd_low, gamma, near, sunk);
        *n1_out = plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
        return;
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *at_minus_one_out = denominator_at_minus_one_creep(fall, fall_low, fall2, fall_low2);
    *together_out = numerator_at_one_creep(reach, half, w, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2);
    *n_gap_out = numerator_gap_creep(reach, half, w, delta, p, fall, mean, mean_low, fall2, mean2,
        mean_low2);
    *n0_out = plant_n0_creep(reach, fade_, fade_low, gamma, delta, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2, mean2, mean_low2);
    *n1_out = plant_n1_creep(reach, fade_, fade_low, half, w, p, p_low, fall, fall_low, mean,
        mean_low, mean2, mean_low2);
    return;
}

// the root of a cubic on a piece where it bends one way
static inline float cubic_root(float k0, float k1, float k2, float k3, float low, float high,
    float rise) {
    const float convex = (2.0f*k2 + 3.0f*k3*(high + low) > 0.0f ? 1.0f : -1.0f);
    const float down = (convex*rise > 0.0f ? 1.0f : -1.0f);
    float y = (down > 0.0f ? high : low), moves = 1.0f;
    for (int count_y = 0; count_y < 100; ++count_y) {
        if (moves == 0.0f) { break; }
        const float steep = k1 + y*(2.0f*k2 + 3.0f*k3*y), some = (steep == 0.0f ? 1.0f : steep);
        const float move = (steep == 0.0f ? 0.0f : (k0 + y*(k1 + y*(k2 + k3*y)))/some);
        const float new_ = fminf(high, -move + y), new2 = fmaxf(low, new_);
        moves = (down*(-new2 + y) > 0.0f ? 1.0f : 0.0f); y = new2;
    }
    return y;
}

// the angle of x + j y in half turns, and the rest
static inline void turn_angle(float x, float y, float *halves_out, float *rest_out) {
    *halves_out = (x < 0.0f ? (y < 0.0f ? -1.0f : 1.0f) : 0.0f);
    *rest_out = atan2f((x < 0.0f ? -y : y), fabsf(x)); return;
}

// the nearest whole number of turns in the phase at a crossing
static inline float phase_turns(float y, float rest, float off, float alpha, float slope,
    float far, float d, float n1, float loss, float together, float apart) {
    const float at = fmaxf(0.0f, y), still = fmaxf(0.0f, rest);
    const float sine = 2.0f*sqrtf(at*still);
    float halves, turned; turn_angle(off*(2.0f*loss - 4.0f), loss*sine, &halves, &turned);
    float halves2, turned2;
    turn_angle(-apart*at + still*together, n1*sine, &halves2, &turned2);
    float halves3, turned3;
    turn_angle(alpha*still - at*far, sine*slope, &halves3, &turned3);
    const float half = atan2f((at > 2.0f ? sqrtf(still) : sqrtf(at)),
        (at > 2.0f ? sqrtf(at) : sqrtf(still)));
    const float late = d + 2.0f;
    const float halves4 = -halves + halves2 + halves3 - (at > 2.0f ? late : 0.0f);
    const float share = 0.5f*(-late*(at > 2.0f ? -2.0f*half : 2.0f*half) - turned + turned2 +
        turned3)/3.1415927f;
    const float even = floorf(0.5f*halves4), left = -even + 0.5f*halves4;
    return even + (left == 0.5f ? floorf(share) + 1.0f : floorf(left + share + 0.5f));
}

// what the crossing on a piece, if there is one, adds
static inline float piece_turns(float k0, float k1, float k2, float k3, float low, float high,
    float at_low, float at_high, float zone, float alpha, float slope, float far, float n1,
    float loss, float together, float apart, float center, float beyond, float d) {
    if ((((at_high < 0.0f) && (at_low >= 0.0f)) || ((at_high >= 0.0f) && (at_low < 0.0f))) &&
        (high > low)) {
        const float x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const float y = (zone == 0.0f ? x : (zone == 1.0f ? center + x : 4.0f - x));
        const float rest = (zone == 0.0f ? 4.0f - x : (zone == 1.0f ? beyond - x : x));
        float turned;
        if ((rest > 0.0f) && (y > 0.0f)) {
            const float off = (zone == 0.0f ? -center + x : (zone == 1.0f ? x : beyond - x));
            const float found = phase_turns(y, rest, off, alpha, slope, far, d, n1, loss, together,
                apart);
            const float rises = (zone == 2.0f ? -1.0f : 1.0f)*(at_high > at_low ? 1.0f : -1.0f);
            turned = -2.0f*found*rises;
        } else {
            turned = 0.0f;
        }
        return turned;
    }
    return 0.0f;
}

// what the crossings between two points add to the count
static inline float zone_turns(float k0, float k1, float k2, float k3, float low, float high,
    float at_low, float at_high, float zone, float alpha, float slope, float far, float n1,
    float loss, float together, float apart, float center, float beyond, float d) {
    const float disc = -3.0f*k1*k3 + (k2*k2);
    const float some = (fabsf(k2) < 24.0f*fabsf(k3) ? 3.0f*k3 : 1.0f), at = -k2/some;
    const float cut = ((at < high) && (at > low) && (fabsf(k2) < 24.0f*fabsf(k3)) ? at : low);
    float one, two;
    if (disc < 0.0f) {
        one = low; two = low;
    } else {
        const float root = sqrtf(fmaxf(0.0f, disc));
        const float q = -k2 - (k2 < 0.0f ? -root : root);
        const float some2 = (fabsf(q) < 24.0f*fabsf(k3) ? 3.0f*k3 : 1.0f);
        const float at2 = q/some2, some3 = (fabsf(k1) < 8.0f*fabsf(q) ? q : 1.0f);
        const float at3 = k1/some3;
        one = ((at2 < high) && (at2 > low) && (fabsf(q) < 24.0f*fabsf(k3)) ? at2 : low);
        two = ((at3 < high) && (at3 > low) && (fabsf(k1) < 8.0f*fabsf(q)) ? at3 : low);
    }
    const float less = fminf(one, two), more = fmaxf(one, two);
    const float first = fminf(cut, less), middle = fmaxf(cut, less);
    const float last = fmaxf(middle, more), middle2 = fminf(middle, more);
    const float height = first*(first*(first*k3 + k2) + k1) + k0;
    const float height2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2));
    const float height3 = k0 + last*(k1 + last*(k2 + k3*last));
    const float found = piece_turns(k0, k1, k2, k3, low, first, at_low, height, zone, alpha, slope,
        far, n1, loss, together, apart, center, beyond, d);
    const float found2 = found + piece_turns(k0, k1, k2, k3, first, middle2, height, height2, zone,
        alpha, slope, far, n1, loss, together, apart, center, beyond, d);
    const float found3 = found2 + piece_turns(k0, k1, k2, k3, middle2, last, height2, height3,
        zone, alpha, slope, far, n1, loss, together, apart, center, beyond, d);
    return found3 + piece_turns(k0, k1, k2, k3, last, high, height3, at_high, zone, alpha, slope,
        far, n1, loss, together, apart, center, beyond, d);
}

// roots outside the unit circle, behind a fractional delay
static inline float fractional_roots(float alpha, float beta, float d, float m2, float m0,
    float at_one, float at_minus_one, float loss, float together, float apart) {
    const float slope = alpha + beta, wall_far = alpha + 2.0f*beta, force = beta*slope;
    const float across = -m0 + m2, square = m0*m2, even = together*(m0 + m2);
    const float linear = (across*across) - even, pushed_ = alpha*together;
    const float lost = (loss*loss), near0 = (at_one - pushed_)*(at_one + pushed_);
    const float near1 = -(alpha*alpha)*linear - at_one*(2.0f - loss) - force*(together*together) +
        lost;
    const float near2 = -(alpha*alpha)*square - force*linear - loss + 1.0f;
    const float near3 = -force*square, square2 = m0*m2, even2 = apart*(m0 + m2);
    const float linear2 = (across*across) - even2, pushed2 = apart*wall_far;
    const float lost2 = (loss*loss);
    const float far0 = (at_minus_one - pushed2)*(at_minus_one + pushed2);
    const float far1 = (apart*apart)*force - at_minus_one*(2.0f - loss) - linear2*
        (wall_far*wall_far) + lost2;
    const float far2 = force*linear2 - loss - square2*(wall_far*wall_far) + 1.0f;
    const float far3 = force*square2, middle = 2.0f*at_one/(2.0f - loss);
    const float rest = 2.0f*at_minus_one/(2.0f - loss), sine = 0.25f*middle*rest;
    const float tilt = -0.25f*middle + 0.25f*rest;
    const float real = -0.25f*apart*middle + 0.25f*rest*together;
    const float size = (across*across), lost3 = (loss*loss);
    const float one = (real*real) + sine*size, two = -real*(m0 + m2) + size*tilt;
    const float three = m0*m2, wave = 0.25f*alpha*rest - 0.25f*middle*wall_far;
    const float wall = sine*(slope*slope) + (wave*wave), own0 = lost3*sine - one*wall;
    const float own1 = -force*one + lost3*tilt - two*wall;
    const float own2 = -force*two - loss - three*wall + 1.0f, own3 = -force*three;
    const float one2 = 0.5f*middle, two2 = 0.5f*rest;
    const float before = -one2*(-one2*(-one2*own3 + own2) + own1) + own0;
    const float after = own0 + two2*(own1 + two2*(own2 + own3*two2)), zone = 0.0f;
    const float zone2 = 1.0f, zone3 = 2.0f, side = (slope >= 0.0f ? 1.0f : -1.0f);
    const float end = -d + (wall_far > 0.0f ? side : 0.0f) +
        (apart > 0.0f ? (across >= 0.0f ? 1.0f : -1.0f) : 0.0f) - 3.0f;
    const float total = (((((((near2 == 0.0f) && (near3 < 0.0f)) || (near2 < 0.0f)) &&
        (near1 == 0.0f)) || (near1 < 0.0f)) && (near0 == 0.0f)) || (near0 < 0.0f) ?
        (alpha > 0.0f ? 0.0f : side) : 0.0f) +
        zone_turns(far0, far1, far2, far3, zone, two2, far0, after, zone3, alpha, slope, wall_far,
        across, loss, together, apart, middle, rest, d) +
        zone_turns(near0, near1, near2, near3, zone, one2, near0, before, zone, alpha, slope,
        wall_far, across, loss, together, apart, middle, rest, d) +
        zone_turns(own0, own1, own2, own3, -one2, two2, before, after, zone2, alpha, slope,
        wall_far, across, loss, together, apart, middle, rest, d);
    return total - (((((((far2 == 0.0f) && (far3 < 0.0f)) || (far2 < 0.0f)) && (far1 == 0.0f)) ||
        (far1 < 0.0f)) && (far0 == 0.0f)) || (far0 < 0.0f) ? end : 0.0f);
}

// m2 - m1 + m0, M at z = -1 behind a fraction of a period
static inline float fractional_numerator_gap(float epsilon, float x, float x_low, float y,
    float y_low, float first, float last, float turned) {
    float total, lost; fast_two_sum(1.0f, -epsilon, &total, &lost);
    float total2, lost2; wide_prod(epsilon, total, lost, &total2, &lost2);
    float total3, lost3; wide_prod(x, y, y_low, &total3, &lost3);
    const float both_low = lost3 + x_low*y;
    float total4, lost4; wide_prod(total2, total3, both_low, &total4, &lost4);
    float total5, lost5; two_diff(first, 2.0f*total4, &total5, &lost5);
    float total6, lost6; two_diff(total5, last, &total6, &lost6);
    float total7, lost7; two_diff(total6, -turned, &total7, &lost7);
    const float low = lost2*total3 + lost4, rest = lost5 + lost6, rest2 = lost7 + rest;
    const float rest3 = -2.0f*low + rest2;
    return rest3 + total7;
}

// displacement by a unit impulse after a period; what the last rounding of Kick takes; (n1 -
// n0)/delta; n0, the same device with its time reversed, times exp(-delta); n1, how far a unit
// force moves the device in a period
static inline void device_kick_kick_low_n_gap_n0_n1(float gamma, float delta, float *kick_out,
    float *kick_low_out, float *n_gap_out, float *n0_out, float *n1_out) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
        const float envelope = expf(-half);
        float total2, lost2; wide_prod(envelope, odd, odd_low, &total2, &lost2);
        float total3, lost3; fast_two_sum(total2, lost2, &total3, &lost3);
        *kick_out = total3; *kick_low_out = lost3;
        *n_gap_out = numerator_gap_swing(reach, half, w, envelope, odd, odd_low, gamma, delta);
        *n0_out = plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd,
            odd_low, gamma, near, sunk);
        *n1_out = plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
        return;
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    float fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    float total, lost; wide_prod(fall, mean2, mean_low2, &total, &lost);
    const float creep_low = fall_low*mean2 + lost;
    float total4, lost4; fast_two_sum(total, creep_low, &total4, &lost4);
    *kick_out = total4; *kick_low_out = lost4;
    *n_gap_out = numerator_gap_creep(reach, half, w, delta, p, fall, mean, mean_low, fall2, mean2,
        mean_low2);
    *n0_out = plant_n0_creep(reach, fade_, fade_low, gamma, delta, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2, mean2, mean_low2);
    *n1_out = plant_n1_creep(reach, fade_, fade_low, half, w, p, p_low, fall, fall_low, mean,
        mean_low, mean2, mean_low2);
    return;
}

// m2 - m1 + m0, m2 and m0 of the device behind a fraction of a period
static inline void late_device(float gamma, float delta, float part, float *apart_out,
    float *m2_out, float *m0_out) {
    const float t0 = 1.0f - part, t1 = (t0*t0), t2 = gamma*t1, t3 = delta*t0;
    float kick_of2, kick_low_of, n_gap, n0_2, n1;
    device_kick_kick_low_n_gap_n0_n1(t2, t3, &kick_of2, &kick_low_of, &n_gap, &n0_2, &n1);
    const float t4 = (part*part), t5 = gamma*t4, t6 = delta*part;
    float kick_of, kick_low_of2, n_gap_2, n0, n1_2;
    device_kick_kick_low_n_gap_n0_n1(t5, t6, &kick_of, &kick_low_of2, &n_gap_2, &n0, &n1_2);
    const float t8 = n0*t4;
    *apart_out = fractional_numerator_gap(part, kick_of2, kick_low_of, kick_of, kick_low_of2, delta*
        n_gap*(t0*t0*t0), delta*n_gap_2*(part*part*part), n0_2*t1*(kick_of*t6 + n1_2*t5) + n1*n1_2*
        t2*t4 - t3*t8*decay(t3));
    *m2_out = n1*t1; *m0_out = t8*expf(-t3); return;
}

// 1 where the loop is stable, else 0
static inline float stable(float roots, float alpha, float beta, float gamma, float delta) {
    const float swing = sqrtf(gamma);
    if ((!((alpha == 0.0f) && (beta == 0.0f) && (delta == 0.0f))) &&
        (!((delta < 5.9604645e-07f) && (gamma > 1.0f) &&
        (swing >= 4.194304e+06f*fabsf(sinf(swing))))) && (alpha > -gamma) && (roots == 0.0f)) {
        return 1.0f;
    }
    return 0.0f;
}

// the turns at a crossing, if there is one
static inline float crossing_turns(float y, float rest, float off, float center, float beyond,
    float alpha, float slope, float far, float d, float n1, float loss, float together,
    float apart) {
    const float edge = (rest > y ? y : rest);
    if ((edge < 4.0f) && (rest > 0.0f) && (y > 0.0f)) {
        const float inside = ((beyond - off > 0.0f) && (center + off > 0.0f) &&
            (edge > fabsf(off)) ? 1.0f : 0.0f);
        const float at = (inside > 0.0f ? center + off : (rest > y ? y : 4.0f - rest));
        const float still = (inside > 0.0f ? beyond - off : (rest > y ? 4.0f - y : rest));
        const float away = (inside > 0.0f ? off : (rest > y ? -center + y : beyond - rest));
        return phase_turns(at, still, away, alpha, slope, far, d, n1, loss, together, apart);
    }
    return 0.0f;
}

// (-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite
static inline void quadratic_roots(float c, float b, float a, float root, float *low_out,
    float *high_out) {
    const float q = -0.5f*b - 0.5f*(b >= 0.0f ? root : -root);
    const float lead_ = (a == 0.0f ? 1.0f : a), own = (q == 0.0f ? 1.0f : q);
    const float one = (a == 0.0f ? -1.0f : q/lead_), two = (q == 0.0f ? -1.0f : c/own);
    if (b >= 0.0f) { *low_out = one; *high_out = two; return; }
    *low_out = two; *high_out = one; return;
}

// roots outside the unit circle
static inline float whole_roots(float alpha, float beta, float d, float n1, float n0, float at_one,
    float at_minus_one, float loss, float together, float apart) {
    const float e = 1.0f - loss, slope = alpha + beta, wall_far = alpha + 2.0f*beta;
    const float force = beta*slope, cross = n0*n1, lost = (loss*loss);
    const float square = cross*force + e, push = alpha*together, pull = apart*wall_far;
    const float near0 = (at_one - push)*(at_one + push);
    const float near1 = (alpha*alpha)*cross - at_one*(e + 1.0f) - force*(together*together) + lost;
    const float far0 = (at_minus_one - pull)*(at_minus_one + pull);
    const float far1 = (apart*apart)*force - at_minus_one*(e + 1.0f) - cross*(wall_far*wall_far) +
        lost;
    const float center = 2.0f*at_one/(e + 1.0f), beyond = 2.0f*at_minus_one/(e + 1.0f);
    const float sine = 0.25f*beyond*center, tilt = 0.25f*beyond - 0.25f*center;
    const float real = -0.25f*apart*center + 0.25f*beyond*together;
    const float m0 = (n1*n1)*sine + (real*real), m1 = (n1*n1)*tilt - n1*real;
    const float wave = 0.25f*alpha*beyond - 0.25f*center*wall_far;
    const float wall = sine*(slope*slope) + (wave*wave), own0 = lost*sine - m0*wall;
    const float own1 = -force*m0 + lost*tilt - m1*wall, own2 = e - force*m1;
    const float square2 = (near1*near1), product = 4.0f*near0*square;
    const float size = square2 + fabsf(product), square3 = (own1*own1);
    const float product2 = 4.0f*own0*own2, size2 = square3 + fabsf(product2);
    const float square4 = (far1*far1), product3 = 4.0f*far0*square;
    const float size3 = square4 + fabsf(product3);
    const float side = (slope >= 0.0f ? 1.0f : -1.0f);
    const float end = -d + (wall_far > 0.0f ? side : 0.0f) +
        (apart > 0.0f ? (n1 >= 0.0f ? 1.0f : -1.0f) : 0.0f) - 3.0f;
    const float disc4 = ((size >= size2) && (size2 <= size3) ? -product2 + square3 :
        ((size > size3) && (size2 > size3) ? -product3 + square4 : -product + square2));
    float total;
    if (disc4 >= 0.0f) {
        const float root = sqrtf(disc4);
        float low, high; quadratic_roots(near0, near1, square, root, &low, &high);
        float low2, high2; quadratic_roots(own0, own1, own2, root, &low2, &high2);
        float low3, high3; quadratic_roots(far0, far1, square, root, &low3, &high3);
        total = -2.0f*crossing_turns(high, low3, high2, center, beyond, alpha, slope, wall_far, d,
            n1, loss, together, apart) + 2.0f*crossing_turns(low, high3, low2, center, beyond,
            alpha, slope, wall_far, d, n1, loss, together, apart);
    } else {
        total = 0.0f;
    }
    const float total2 = total + (((((near1 == 0.0f) && (square < 0.0f)) || (near1 < 0.0f)) &&
        (near0 == 0.0f)) || (near0 < 0.0f) ? (alpha > 0.0f ? 0.0f : side) : 0.0f);
    return total2 - (((((far1 == 0.0f) && (square < 0.0f)) || (far1 < 0.0f)) && (far0 == 0.0f)) ||
        (far0 < 0.0f) ? end : 0.0f);
}

// the imaginary part of A/(z M) at z = exp(2 j psi); the real part of A/(z M) at z = exp(2 j psi)
static inline void ahead_in_phase(float psi, float at_one, float at_minus_one, float loss,
    float together, float apart, float across, float *ahead_out, float *in_phase_out) {
    const float t = tanf(psi), square = (t*t), low = fmaf(t, t, -(t*t));
    const float taken = at_minus_one*square;
    float total, lost; two_diff(at_one, taken, &total, &lost);
    const float missed = at_minus_one*low + fmaf(at_minus_one, square, -(at_minus_one*square));
    const float lost2 = lost - missed;
    float total2, lost3; fast_two_sum(total, lost2, &total2, &lost3);
    const float taken2 = apart*square;
    float total3, lost4; two_diff(together, taken2, &total3, &lost4);
    const float missed2 = apart*low + fmaf(apart, square, -(apart*square));
    const float lost5 = lost4 - missed2;
    float total4, lost6; fast_two_sum(total3, lost5, &total4, &lost6);
    const float above_j = 2.0f*loss*t, below_j = across*t;
    const float rest = (below_j*below_j) + 2.0f*lost6*total4;
    const float size = rest + (total4*total4), low2 = above_j*lost6 - below_j*lost3;
    const float found = above_j*total4 - below_j*total2, found2 = found + low2;
    const float low22 = lost3*total4 + lost6*total2, rest2 = above_j*below_j + low22;
    const float found3 = rest2 + total2*total4;
    *ahead_out = found2/size; *in_phase_out = found3/size; return;
}

// 1 + a + e; n1 + n0; (n1 - n0)/delta
static inline void device_at_minus_one_together_n_gap(float gamma, float delta,
    float *at_minus_one_out, float *together_out, float *n_gap_out) {
    float w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const float half = 0.5f*delta;
    if (w < 0.0f) {
        float even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        float near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        const float envelope = expf(-half);
        *at_minus_one_out = denominator_at_minus_one_swing(half, w, w_low, envelope, even,
            even_low, root);
        *together_out = numerator_at_one_swing(reach, half, w, w_low, envelope, root, gamma, near,
            moved);
        *n_gap_out = numerator_gap_swing(reach, half, w, envelope, odd, odd_low, gamma, delta);
        return;
    }
    float p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    float fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const float root_low = root_miss(w, w_low, root);
    float fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0f*root, 2.0f*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *at_minus_one_out = denominator_at_minus_one_creep(fall, fall_low, fall2, fall_low2);
    *together_out = numerator_at_one_creep(reach, half, w, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2);
    *n_gap_out = numerator_gap_creep(reach, half, w, delta, p, fall, mean, mean_low, fall2, mean2,
        mean_low2);
    return;
}

// cos((k + 1) x) and sin((k + 1) x)
static inline void next_wave(float k, float x, float *cosine_out, float *sine_out) {
    const float count = k + 1.0f, before = count - 1.0f, angle = count*x;
    const float missed = -before + k, quarters = floorf(2.0f*angle/3.1415927f + 0.5f);
    const float left = angle - 1.5707964f*quarters;
    float total, lost;
    two_diff(left, fmaf(quarters, 1.5707964f, -(quarters*1.5707964f)), &total, &lost);
    float total2, lost2; two_diff(total, -4.371139e-08f*quarters, &total2, &lost2);
    float total3, lost3; two_diff(total2, -fmaf(count, x, -(count*x)), &total3, &lost3);
    float total4, lost4; two_diff(total3, -missed*x, &total4, &lost4);
    const float low = lost + lost2 + lost3 + lost4 + 1.7151245e-15f*quarters -
        fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
    const float low2 = low + fmaf(missed, x, -(missed*x)), wave = sinf(total4);
    const float still = cosf(total4), turn_ = quarters - 4.0f*floorf(0.25f*quarters);
    const float sine = low2*still + wave, cosine = -low2*wave + still;
    const float value = ((turn_ == 1.0f) || (turn_ == 3.0f) ? sine : cosine);
    const float value2 = ((turn_ == 1.0f) || (turn_ == 3.0f) ? cosine : sine);
    *cosine_out = ((turn_ <= 2.0f) && (turn_ >= 1.0f) ? -value : value);
    *sine_out = (turn_ >= 2.0f ? -value2 : value2); return;
}

// cos((k + 1) x)
static inline float cos_next(float k, float x) {
    float cosine, sine; next_wave(k, x, &cosine, &sine);
    return cosine;
}

// has the sign of the slope of the boundary's alpha, d < 1
static inline float early_slope(float theta, float k4, float k3, float k2, float k1, float k0) {
    const float sine = sinf(0.5f*theta), cosine = cosf(0.5f*theta), up = (sine*sine);
    const float along = (cosine*cosine), found = along*k3 + k4*up;
    const float power2 = (along*along), found2 = found*up + k2*power2;
    const float power3 = along*power2, found3 = found2*up + k1*power3;
    const float power4 = along*power3;
    return found3*up + k0*power4;
}

// has the sign of the slope of the boundary's alpha next to pi
static inline float end_slope(float at_minus_one, float loss, float together, float apart,
    float last) {
    float total, lost; two_diff(together, 4.0f*last, &total, &lost);
    float total2, lost2; wide_prod(total, total, 2.0f*lost, &total2, &lost2);
    float total3, lost3; two_prod(apart, together, &total3, &lost3);
    float total4, lost4; two_diff(total3, total2, &total4, &lost4);
    float total5, lost5; two_diff(total2, 2.0f*total3, &total5, &lost5);
    float total7, lost7; wide_prod(apart, total3, lost3, &total7, &lost7);
    float total12, lost12; two_diff(2.0f*apart, total, &total12, &lost12);
    float total13, lost13; two_prod(apart, apart, &total13, &lost13);
    float total14, lost14; wide_prod(total13, total12, -lost + lost12, &total14, &lost14);
    const float gap_low = -lost2 + lost3 + lost4;
    float total10, lost10; wide_prod(apart, total4, gap_low, &total10, &lost10);
    float total11, lost11; wide_prod(loss, total10, lost10, &total11, &lost11);
    const float lean_low = lost2 - 2.0f*lost3 + lost5;
    float total6, lost6; wide_prod(total, total5, lean_low, &total6, &lost6);
    float total8, lost8; two_diff(total6, -total7, &total8, &lost8);
    const float bent_low = lost*total5 + lost6 + lost7 + lost8;
    float total9, lost9; wide_prod(at_minus_one, total8, bent_low, &total9, &lost9);
    float total15, lost15; two_diff(4.0f*total14, total9, &total15, &lost15);
    float total16, lost16; two_diff(total15, 2.0f*total11, &total16, &lost16);
    const float three_low = lost13*total12 + lost14;
    const float low = -2.0f*lost11 + lost15 + lost16 - lost9 + 4.0f*three_low;
    return low + total16;
}

// the next point of a search between a and b, where f is fa and fb, after c
static inline float next_guess(float b, float fb, float a, float fa, float c, float fc,
    float close) {
    const float span = -b + c, rise = -fb + fc, whole = (span == 0.0f ? 1.0f : span);
    const float place = (a - b)/whole, whole2 = (rise == 0.0f ? 1.0f : rise);
    const float height = (fa - fb)/whole2;
    const float safe = ((place < 1.0f - ((1.0f - height)*(1.0f - height))) &&
        (place > (height*height)) ? 1.0f : 0.0f);
    const float width = -a + b, whole3 = (width == 0.0f ? 1.0f : width);
    const float edge = close*fabsf((fabsf(fa) < fabsf(fb) ? a : b))/fabsf(whole3);
    const float edge2 = fminf(0.5f, edge);
    float guess;
    if (safe > 0.0f) {
        const float one = -fa + fb, two = fb - fc, three = fa - fc, here = fa/one;
        const float there = fc/two, other = fa/three, last = fb/two;
        guess = here*there + last*other*(-a + c)/whole3;
    } else {
        guess = 0.5f;
    }
    const float share = fminf(guess, 1.0f - edge2), share2 = fmaxf(edge2, share);
    return a + share2*width;
}

// the angle of the largest stiffness for delays below a period
static inline float early_angle(float at_one, float at_minus_one, float loss, float together,
    float apart, float last) {
    const float t = (apart*apart*apart), t2 = (together*together*together);
    const float t3 = (together*together), t4 = apart*t3, t5 = (apart*apart);
    const float t6 = 2.0f*loss, t7 = at_minus_one + t6, t8 = 4.0f*together;
    const float t9 = 16.0f*apart, t10 = at_one + t6, t11 = 2.0f*at_one;
    const float t12 = 5.0f*at_minus_one, t13 = -at_one, t14 = 4.0f*loss;
    const float t15 = apart*together, t16 = 16.0f*together, t17 = at_one*last;
    const float t18 = apart*t11, t19 = at_one*t5;
    const float k = end_slope(at_minus_one, loss, together, apart, last);
    const float k2 = -4.0f*at_minus_one*t2 + last*
        (32.0f*at_minus_one*t3 + last*(64.0f*apart*loss + 128.0f*at_minus_one*last - 96.0f*
        at_minus_one*together) - 96.0f*t5 - t7*t9*together) + 16.0f*t + 8.0f*t4*
        (at_minus_one + loss) - t5*t7*t8;
    const float k3 = last*(last*(last*(-192.0f*at_minus_one - 256.0f*at_one - 512.0f*loss) + t16*
        (9.0f*at_one + 16.0f*loss + t12) + t9*(8.0f*at_minus_one + 8.0f*at_one + 18.0f*loss)) -
        32.0f*t15 - 4.0f*t3*(at_minus_one + 7.0f*at_one + 14.0f*loss) - 112.0f*t5) + 8.0f*t + 2.0f*
        t2*(-2.0f*at_minus_one + t10) + 2.0f*t4*(t12 + t13 + t14) - 2.0f*t5*together*(-t11 + t7);
    const float k4 = last*(32.0f*t17*together - 8.0f*together*(t18 + 12.0f*together)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const float k5 = last*(t16*t17 + t8*(t10*together - t18)) + together*
        (-2.0f*t15*(at_one + loss) + t19 + t3*(at_minus_one + t11 + t14));
    float count = 1.0f, found = 0.0f;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0f) || (found > 0.0f)) { break; }
        const float rises = early_slope(0.041666668f*3.1415927f*count, k, k2, k3, k4, k5);
        const float next_count = (rises > 0.0f ? count + 1.0f : count);
        found = (rises > 0.0f ? 0.0f : 1.0f); count = next_count;
    }
    if (found > 0.0f) {
        const float high = 0.041666668f*3.1415927f*count;
        const float low = fmaxf(0.001f*high, 0.041666668f*3.1415927f*(count - 1.0f));
        const float above = early_slope(low, k, k2, k3, k4, k5);
        if (above <= 0.0f) { return low; }
        const float below = early_slope(high, k, k2, k3, k4, k5);
        if (below >= 0.0f) { return high; }
        float b = low, fb = above, a = high, fa = below, c = high, fc = below;
        for (int count_b = 0; count_b < 120; ++count_b) {
            if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) { break; }
            const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
            const float value = early_slope(new_, k, k2, k3, k4, k5);
            const float same = (((fa < 0.0f) && (value < 0.0f)) ||
                ((fa > 0.0f) && (value > 0.0f)) ? 1.0f : 0.0f);
            const float next_b = (same > 0.0f ? b : a), next_fb = (same > 0.0f ? fb : fa);
            const float next_c = (same > 0.0f ? a : b);
            fc = (same > 0.0f ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb;
            b = next_b;
        }
        if (fabsf(fa) < fabsf(fb)) { return a; }
        return b;
    }
    return 3.1415927f;
}

// sin((k + 1) x)
static inline float sin_next(float k, float x) {
    float cosine, sine; next_wave(k, x, &cosine, &sine);
    return sine;
}

// has the sign of the slope of the boundary's alpha
static inline float boundary_slope(float theta, float l, float at_one, float at_minus_one,
    float loss, float together, float apart, float across) {
    const float t = 2.0f*l + 2.0f, t2 = 0.5f*theta, t3 = sin_next(t, t2), t4 = tanf(t2);
    const float t5 = (t4*t4), t6 = 4.0f*t5, t7 = apart*t5, t8 = -t7 + together;
    const float t9 = at_minus_one*t5, t10 = at_one - t9, t11 = across*loss*t6 + t10*t8;
    const float t12 = cos_next(t, t2), t13 = -2.0f*across*t10*t4 + 2.0f*loss*t4*t8;
    const float t14 = (across*across), t15 = t14*t6 + (t8*t8), t16 = (loss*loss);
    const float t17 = (t10*t10) + t16*t6, t18 = t15*t17, t19 = t5 + 1.0f;
    return -t4*(0.5f*t18 + t19*(t15*(-at_minus_one*t10 + 2.0f*t16) - t17*(-apart*t8 + 2.0f*t14)))*
        (t11*t12 - t13*t3) + (t11*t3 + t12*t13)*
        (t18*(l + 1.5f) + t19*(-across*t17*(t7 + together) + loss*t15*(at_one + t9)));
}

// the angle of the largest stiffness for a period and more
static inline float later_angle(float d, float l, float at_one, float at_minus_one, float loss,
    float together, float apart, float across) {
    const float turn_ = 3.1415927f/(d + 1.0f);
    float count = 1.0f, found = 0.0f;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0f) || (found > 0.0f)) { break; }
        const float rises = boundary_slope(0.041666668f*count*turn_, l, at_one, at_minus_one, loss,
            together, apart, across);
        const float next_count = (rises > 0.0f ? count + 1.0f : count);
        found = (rises > 0.0f ? 0.0f : 1.0f); count = next_count;
    }
    if (found > 0.0f) {
        const float high = 0.041666668f*count*turn_;
        const float low = fmaxf(0.001f*high, 0.041666668f*turn_*(count - 1.0f));
        const float above = boundary_slope(low, l, at_one, at_minus_one, loss, together, apart,
            across);
        if (above <= 0.0f) { return low; }
        const float below = boundary_slope(high, l, at_one, at_minus_one, loss, together, apart,
            across);
        if (below >= 0.0f) { return high; }
        float b = low, fb = above, a = high, fa = below, c = high, fc = below;
        for (int count_b = 0; count_b < 120; ++count_b) {
            if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) { break; }
            const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
            const float value = boundary_slope(new_, l, at_one, at_minus_one, loss, together,
                apart, across);
            const float same = (((fa < 0.0f) && (value < 0.0f)) ||
                ((fa > 0.0f) && (value > 0.0f)) ? 1.0f : 0.0f);
            const float next_b = (same > 0.0f ? b : a), next_fb = (same > 0.0f ? fb : fa);
            const float next_c = (same > 0.0f ? a : b);
            fc = (same > 0.0f ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb;
            b = next_b;
        }
        if (fabsf(fa) < fabsf(fb)) { return a; }
        return b;
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static inline float undelayed_angle(float at_one, float at_minus_one, float loss, float together,
    float apart) {
    const float k = end_slope(at_minus_one, loss, together, apart, 0.0f);
    const float t = 2.0f*apart, t2 = -together, t3 = 2.0f*together;
    const float t4 = (together*together);
    const float k2 = t3*((apart*apart)*at_one + together*(at_minus_one*(t + t2) + loss*t));
    const float k3 = together*(at_minus_one*t4 + at_one*(t4 + ((-apart - t2)*(-apart - t2))) + loss*
        t3*(-apart + 2.0f*together));
    float above, below;
    if (k2 > 0.0f) {
        const float discriminant = -4.0f*k*k3 + (k2*k2);
        const float root = sqrtf(fmaxf(0.0f, discriminant));
        above = k2 + root; below = fmaxf(0.0f, -2.0f*k);
    } else {
        const float discriminant = -4.0f*k*k3 + (k2*k2);
        if (discriminant < 0.0f) {
            above = 2.0f*k3; below = 0.0f;
        } else {
            const float root = sqrtf(fmaxf(0.0f, discriminant));
            above = 2.0f*k3; below = -k2 + root;
        }
    }
    return 2.0f*atan2f(sqrtf(above), sqrtf(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static inline float max_stiffness_angle(float gamma, float delta, float d, float l, float part,
    float first, float last, float at_one, float at_minus_one, float loss, float together,
    float apart) {
    if (((d <= 1.0f) || (sqrtf(gamma)*(d + 1.0f) <= 3.1415927f)) && (gamma <= 9.8f)) {
        const float across = (part == 0.0f ? first : first - last);
        const float theta = (d == 0.0f ? undelayed_angle(at_one, at_minus_one, loss, together,
            apart) : (d < 1.0f ? early_angle(at_one, at_minus_one, loss, together, apart, last) :
            later_angle(d, l, at_one, at_minus_one, loss, together, apart, across)));
        const float t = sin_next(l, theta), t2 = 0.5f*theta, t3 = sinf(t2);
        const float t4 = cosf(t2), t5 = (t4*t4), t6 = (t3*t3), t7 = 4.0f*t5*t6;
        const float t8 = -apart*t6 + t5*together;
        const float t9 = 1.0f/((across*across)*t7 + (t8*t8));
        const float t10 = -at_minus_one*t6 + at_one*t5;
        const float t11 = -2.0f*across*t10 + 2.0f*loss*t8;
        const float t12 = across*loss*t7 + t10*t8, t13 = t9*cos_next(l, theta);
        const float t14 = -t*t12*t9/sinf(theta) - 0.5f*t11*t13;
        const float stiffness = t*t11*t3*t4*t9 - t12*t13 - 2.0f*t14*t6;
        float good;
        if ((delta > 0.0f) && (gamma > -stiffness) && (sqrtf(gamma)*(d + 1.0f) <= 3.1415927f)) {
            good = 1.0f;
        } else {
            const float inside = -7.6293945e-05f*gamma + 0.9999237f*stiffness;
            const float outside = (part == 0.0f ?
                whole_roots(inside, t14, l, first, last, at_one, at_minus_one, loss, together,
                apart) : fractional_roots(inside, t14, l, first, last, at_one, at_minus_one, loss,
                together, apart));
            good = stable(outside, inside, t14, gamma, delta);
        }
        if (good > 0.0f) { return theta; }
        return NAN;
    }
    return NAN;
}

// (x - sin(x))/x^3
static inline float gap(float x) {
    if (fabsf(x) < 2.0f) {
        const float square = -(x*x);
        float total = 0.0f;
        for (int n = 17; n >= 5; n -= 2) {
            const float number = inverse_factorial[n];
            total = number + square*total;
        }
        const float rest = square*total - 4.967054e-09f;
        return rest + 0.16666667f;
    }
    return (x - sinf(x))/(x*x*x);
}

// sin(x)/x
static inline float sinc(float x) {
    if (fabsf(x) < 1.0f) { return -(x*x)*gap(x) + 1.0f; }
    return sinf(x)/x;
}

// the damping that the wall needs at the angle 2 psi
static inline float damping_at(float alpha, float beta, float l, float epsilon, float psi) {
    const float early = 0.5f*alpha*(2.0f*l + 1.0f)*sinc(psi*(2.0f*l + 1.0f))/sinc(psi) - beta*
        cos_next(l, 2.0f*psi);
    if (epsilon == 0.0f) { return early; }
    const float n = early + epsilon*(0.5f*alpha*(2.0f*l + 3.0f)*sinc(psi*(2.0f*l + 3.0f))/
        sinc(psi) - beta*cos_next(l + 1.0f, 2.0f*psi) - early);
    const float root = sqrtf(epsilon*(1.0f - epsilon)*
        ((alpha*alpha)*(cosf(psi)*cosf(psi)) + ((alpha + 2.0f*beta)*(alpha + 2.0f*beta))*
        (sinf(psi)*sinf(psi))) + (n*n));
    return 0.5f*n + 0.5f*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static inline float chord(float k, float x) {
    const float turn_ = x*(k + 1.0f), order = 2.0f*k + 2.0f, along = cos_next(k, x);
    if (turn_ < 1.5f) {
        const float wave = sinc(0.5f*turn_), inner = 0.5f*(wave*wave) - gap(turn_);
        return order*(along*gap(x) + 0.25f*inner*(order*order));
    }
    return (-along*order*sinf(x) + 2.0f*sin_next(k, x))/(x*x*x);
}

// has the sign of the slope of DampingAt, at a fraction
static inline float rising(float alpha, float beta, float l, float epsilon, float psi) {
    const float t = 2.0f*psi, t2 = 2.0f*alpha/(sinc(psi)*sinc(psi));
    const float t3 = 0.5f*alpha + beta, t4 = 2.0f*l, t5 = t4 + 2.0f, t6 = t4 + 4.0f;
    const float early = -t2*chord(l, t) + t3*(t5*t5)*sinc(psi*t5);
    const float steep = early + epsilon*(-early - t2*chord(l + 1.0f, t) + t3*(t6*t6)*sinc(psi*t6));
    return 2.0f*beta*epsilon*(1.0f - epsilon)*(alpha + beta)*sinc(2.0f*psi) + steep*
        damping_at(alpha, beta, l, epsilon, psi);
}

// has the sign of the slope of DampingAt, up to the angle in phase
static inline float steepness(float alpha, float beta, float l, float epsilon, float psi) {
    if (epsilon == 0.0f) {
        const float t = 2.0f*l + 2.0f;
        return -2.0f*alpha*chord(l, 2.0f*psi)/(sinc(psi)*sinc(psi)) + (t*t)*(0.5f*alpha + beta)*
            sinc(psi*t);
    }
    const float rising_ = rising(alpha, beta, l, epsilon, psi);
    const float phase = psi*(2.0f*l + 2.0f) +
        atan2f(alpha*cosf(psi), (alpha + 2.0f*beta)*sinf(psi)) +
        atan2f(epsilon*sinf(2.0f*psi), epsilon*cosf(2.0f*psi) - epsilon + 1.0f) - 3.1415927f;
    if (phase > 0.0f) { return -fabsf(rising_); }
    return rising_;
}

// half of the angle at which the wall needs most damping
static inline float worst_angle(float alpha, float beta, float l, float epsilon) {
    const float size = fabsf(alpha) + fabsf(beta), whole = (size == 0.0f ? 1.0f : size);
    const float stiffness = alpha/whole, damping = beta/whole, low = 0.0f;
    const float above = steepness(stiffness, damping, l, epsilon, low);
    if (above <= 0.0f) { return low; }
    const float high = 3.1415925f/(2.0f*l + 2.0f);
    const float below = steepness(stiffness, damping, l, epsilon, high);
    if (below >= 0.0f) { return high; }
    float b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
            (fabsf(a - b) <= 7.6293945e-06f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) { break; }
        const float new_ = next_guess(b, fb, a, fa, c, fc, 7.6293945e-06f);
        const float value = steepness(stiffness, damping, l, epsilon, new_);
        const float same = (((fa < 0.0f) && (value < 0.0f)) || ((fa > 0.0f) && (value > 0.0f)) ?
            1.0f : 0.0f);
        const float next_b = (same > 0.0f ? b : a), next_fb = (same > 0.0f ? fb : fa);
        const float next_c = (same > 0.0f ? a : b);
        fc = (same > 0.0f ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb;
        b = next_b;
    }
    if (fabsf(fa) < fabsf(fb)) { return a; }
    return b;
}

// the damping that the wall needs at its worst angle
static inline float largest_required_damping(float alpha, float beta, float d) {
    if (alpha < 0.0f) { return INFINITY; }
    const float whole = floorf(d), part = d - whole;
    const float lift = (fabsf(alpha) + fabsf(beta) < 9.094947e-13f ? 1.2089258e+24f : 1.0f);
    const float stiffness = alpha*lift, damping = beta*lift;
    const float psi = worst_angle(stiffness, damping, whole, part);
    return damping_at(stiffness, damping, whole, part, psi)/lift;
}

// early + share (late - early)
static inline float between(float share, float early, float late) {
    const float more = -early + late;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static inline float lead(float theta, float l, float epsilon) {
    if (theta*(l + 1.0f) < 4.0f) {
        const float early = sin_next(l, theta), late = sin_next(l + 1.0f, theta);
        return early + epsilon*(-early + late);
    }
    return -1.0f;
}

// the value, NaN for number < 0
static inline float rated(float number, float value) {
    if (number < 0.0f) { return NAN; }
    return value;
}

// ((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3
static inline float spread(float k, float x) {
    const float turn_ = x*(k + 1.0f), order = 2.0f*k + 2.0f;
    if (turn_ < 1.5f) { return order*((order*order)*gap(2.0f*turn_) - gap(x)); }
    return (order*sinf(x) - 2.0f*cos_next(k, x)*sin_next(k, x))/(x*x*x);
}

// what straight motions need at a whole delay of k periods
static inline float straight(float stiffness, float damping, float k, float angle) {
    const float order = 2.0f*k + 1.0f, wave = sinc(angle*order);
    float total, lost; two_prod(order, wave, &total, &lost);
    const float near = 2.0f*sinc(angle);
    float total2, lost2; wide_quot(total, near, lost, 0.0f, &total2, &lost2);
    float total3, lost3; wide_prod(stiffness, total2, lost2, &total3, &lost3);
    const float along = cos_next(k, 2.0f*angle);
    float total4, lost4; two_prod(damping, along, &total4, &lost4);
    float total5, lost5; two_diff(total3, total4, &total5, &lost5);
    const float low = lost3 - lost4 + lost5;
    return low + total5;
}

// has the sign of minus the slope of what the wall phi needs
static inline float turning(float phi, float l, float epsilon, float wave, float wave2,
    float wave3, float wave4, float wave5, float wave6, float wave7, float wave8, float wave9,
    float wave10, float wave11, float wave12) {
    const float t = sinf(phi), t2 = l + 1.0f, t3 = cosf(phi), t4 = t3/t2, t5 = 0.5f*t4;
    const float t6 = t - t5, t7 = epsilon*(1.0f - epsilon), t8 = 2.0f*l;
    const float t9 = 2.0f*t4/(wave7*wave7);
    const float t10 = t*wave10*((t8 + 2.0f)*(t8 + 2.0f)) - t9*wave3, t11 = t6*wave5;
    const float t12 = 1.0f/wave7, t13 = wave9*(t8 + 1.0f), t14 = t12*t5, t15 = t13*t14;
    const float t16 = epsilon*(t11 + t14*wave11*(t8 + 3.0f) - t15 - t6*wave6);
    return -2.0f*t6*t7*wave8*(t + t5) - (epsilon*
        (t*wave12*((t8 + 4.0f)*(t8 + 4.0f)) - t10 - t9*wave4) + t10)*
        (-0.5f*t11 + 0.25f*t12*t13*t4 + 0.5f*t16 + 0.5f*
        sqrtf(t7*(4.0f*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2)) +
        ((-t11 + t15 + t16)*(-t11 + t15 + t16))));
}

// the wall whose worst angle is 2 psi, as an angle
static inline float turn(float psi, float l, float epsilon) {
    const float wave = sinf(psi), wave2 = cosf(psi), wave3 = chord(l, 2.0f*psi);
    const float wave4 = chord(l + 1.0f, 2.0f*psi), wave5 = cos_next(l, 2.0f*psi);
    const float wave6 = cos_next(l + 1.0f, 2.0f*psi), wave7 = sinc(psi);
    const float wave8 = sinc(2.0f*psi), wave9 = sinc(psi*(2.0f*l + 1.0f));
    const float wave10 = sinc(psi*(2.0f*l + 2.0f)), wave11 = sinc(psi*(2.0f*l + 3.0f));
    const float wave12 = sinc(psi*(2.0f*l + 4.0f)), low = 0.0f;
    const float above = turning(low, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7,
        wave8, wave9, wave10, wave11, wave12);
    if (above <= 0.0f) { return low; }
    const float high = 0.5f*3.1415927f;
    const float below = turning(high, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7,
        wave8, wave9, wave10, wave11, wave12);
    if (below >= 0.0f) { return high; }
    float b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
            (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) { break; }
        const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
        const float value = turning(new_, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6,
            wave7, wave8, wave9, wave10, wave11, wave12);
        const float same = (((fa < 0.0f) && (value < 0.0f)) || ((fa > 0.0f) && (value > 0.0f)) ?
            1.0f : 0.0f);
        const float next_b = (same > 0.0f ? b : a), next_fb = (same > 0.0f ? fb : fa);
        const float next_c = (same > 0.0f ? a : b);
        fc = (same > 0.0f ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb;
        b = next_b;
    }
    if (fabsf(fa) < fabsf(fb)) { return a; }
    return b;
}

// the wall whose worst angle is theta, as an angle, or NaN
static inline float touching(float theta, float l, float epsilon) {
    const float found = turn(0.5f*theta, l, epsilon);
    if (found < 0.5f*3.1415927f) { return found; }
    return NAN;
}

// whether another angle allows more stiffness, at a fraction
static inline float passive_slope(float psi, float l, float epsilon) {
    const float turned = turn(psi, l, epsilon), wall = cosf(turned)/(l + 1.0f);
    const float wall2 = sinf(turned) - 0.5f*cosf(turned)/(l + 1.0f);
    const float need = damping_at(wall, wall2, l, epsilon, psi);
    return -epsilon*(1.0f - epsilon)*(wall + 2.0f*wall2)*(sinf(psi)*sinf(psi)) + need*
        (epsilon*(-cos_next(l, 2.0f*psi) + cos_next(l + 1.0f, 2.0f*psi)) + cos_next(l, 2.0f*psi));
}

// the worst angle of the stiffest passive wall, at a fraction
static inline float passive_angle(float l, float epsilon) {
    const float low = 1e-06f*3.1415927f/(2.0f*epsilon + 2.0f*l + 2.0f);
    const float above = passive_slope(low, l, epsilon);
    if (above <= 0.0f) { return 2.0f*low; }
    const float high = 3.1415927f/(2.0f*epsilon + 2.0f*l + 2.0f);
    const float below = passive_slope(high, l, epsilon);
    if (below >= 0.0f) { return 2.0f*high; }
    float b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
            (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) { break; }
        const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
        const float value = passive_slope(new_, l, epsilon);
        const float same = (((fa < 0.0f) && (value < 0.0f)) || ((fa > 0.0f) && (value > 0.0f)) ?
            1.0f : 0.0f);
        const float next_b = (same > 0.0f ? b : a), next_fb = (same > 0.0f ? fb : fa);
        const float next_c = (same > 0.0f ? a : b);
        fc = (same > 0.0f ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb;
        b = next_b;
    }
    if (fabsf(fa) < fabsf(fb)) { return 2.0f*a; }
    return 2.0f*b;
}

void haptic_single_discretize(float gamma, float delta, float *n1_out, float *n0_out, float *a_out,
    float *e_out) {
    if (!((delta <= 1e+08f) && (delta >= 0.0f) && (gamma <= 1e+08f) && (gamma >= 0.0f))) {
        *n1_out = NAN; *n0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    float n0, n1, trace; device_n0_n1_trace(gamma, delta, &n0, &n1, &trace);
    *n1_out = n1; *n0_out = n0; *a_out = trace; *e_out = expf(-delta); return;
}

void haptic_single_discretize_fractional(float gamma, float delta, float epsilon, float *m2_out,
    float *m1_out, float *m0_out, float *a_out, float *e_out) {
    if (!((delta <= 1e+08f) && (delta >= 0.0f) && (epsilon < 1.0f) && (epsilon >= 0.0f) &&
        (gamma <= 1e+08f) && (gamma >= 0.0f))) {
        *m2_out = NAN; *m1_out = NAN; *m0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    float together, trace; device_together_trace(gamma, delta, &together, &trace);
    const float t0 = 1.0f - epsilon, t1 = (t0*t0), t2 = delta*t0;
    const float n1 = plant_n1(gamma*t1, t2), t3 = n1*t1, t4 = (epsilon*epsilon);
    const float n0 = plant_n0(gamma*t4, delta*epsilon), t5 = n0*t4*expf(-t2);
    *m2_out = t3; *m1_out = together - t3 - t5; *m0_out = t5; *a_out = trace;
    *e_out = expf(-delta); return;
}

bool haptic_single_is_stable(float alpha, float beta, float gamma, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f) && (gamma <= 1e+08f) &&
        (gamma >= 0.0f))) {
        return false;
    }
    float at_minus_one, together, n_gap, n0, n1;
    device_at_minus_one_together_n_gap_n0_n1(gamma, delta, &at_minus_one, &together, &n_gap, &n0,
        &n1);
    const float whole = floorf(d), part = d - whole, t1 = gamma*together;
    const float t3 = delta*decay(delta);
    if (part == 0.0f) {
        return stable(whole_roots(alpha, beta, d, n1, n0, t1, at_minus_one, t3, together, delta*
            n_gap), alpha, beta, gamma, delta) != 0.0f;
    }
    float apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    return stable(fractional_roots(alpha, beta, whole, m2, m0, t1, at_minus_one, t3, together,
        apart), alpha, beta, gamma, delta) != 0.0f;
}

float haptic_single_unstable_roots(float alpha, float beta, float gamma, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f) && (gamma <= 1e+08f) &&
        (gamma >= 0.0f))) {
        return -1.0f;
    }
    float at_minus_one, together, n_gap, n0, n1;
    device_at_minus_one_together_n_gap_n0_n1(gamma, delta, &at_minus_one, &together, &n_gap, &n0,
        &n1);
    const float whole = floorf(d), part = d - whole, t1 = gamma*together;
    const float t3 = delta*decay(delta);
    if (part == 0.0f) {
        return whole_roots(alpha, beta, d, n1, n0, t1, at_minus_one, t3, together, delta*n_gap);
    }
    float apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    return fractional_roots(alpha, beta, whole, m2, m0, t1, at_minus_one, t3, together, apart);
}

void haptic_single_stability_boundary(float theta, float gamma, float delta, float d,
    float *alpha_out, float *beta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (gamma <= 1e+08f) && (gamma >= 0.0f) && (theta <= 3.1415925f) && (theta > 0.0f))) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    float at_minus_one, together, n_gap;
    device_at_minus_one_together_n_gap(gamma, delta, &at_minus_one, &together, &n_gap);
    const float whole = floorf(d), part = d - whole, t1 = 0.5f*theta;
    const float t3 = gamma*together, t5 = delta*decay(delta), t11 = tanf(t1);
    const float t13 = sinf(theta);
    if (part == 0.0f) {
        float cosine, sine; next_wave(d, theta, &cosine, &sine);
        const float t6 = delta*n_gap, t7 = together + t6;
        float ahead_of, in_phase_of;
        ahead_in_phase(t1, t3, at_minus_one, t5, together, t6, t7, &ahead_of, &in_phase_of);
        const float t12 = ahead_of*cosine + in_phase_of*sine;
        *alpha_out = ahead_of*sine - cosine*in_phase_of + t11*t12; *beta_out = -t12/t13;
        return;
    }
    float cosine_2, sine_2; next_wave(whole, theta, &cosine_2, &sine_2);
    float apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    const float t18 = 2.0f*m2 - 2.0f*m0;
    float ahead_of2, in_phase_of2;
    ahead_in_phase(t1, t3, at_minus_one, t5, together, apart, t18, &ahead_of2, &in_phase_of2);
    const float t22 = ahead_of2*cosine_2 + in_phase_of2*sine_2;
    *alpha_out = ahead_of2*sine_2 - cosine_2*in_phase_of2 + t11*t22;
    *beta_out = -t22/t13; return;
}

void haptic_single_max_stable_stiffness(float gamma, float delta, float d, float *alpha_out,
    float *beta_out, float *theta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (gamma <= 1e+08f) && (gamma >= 0.0f))) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    float at_minus_one, together, n_gap, n0, n1;
    device_at_minus_one_together_n_gap_n0_n1(gamma, delta, &at_minus_one, &together, &n_gap, &n0,
        &n1);
    const float whole = floorf(d), part = d - whole, t1 = gamma*together;
    const float t3 = delta*decay(delta), t16 = 2.0f*t3;
    if (part == 0.0f) {
        const float t4 = delta*n_gap;
        const float t5 = max_stiffness_angle(gamma, delta, d, d, 0.0f, n1, n0, t1, at_minus_one,
            t3, together, t4);
        float cosine, sine; next_wave(d, t5, &cosine, &sine);
        const float t7 = 0.5f*t5, t8 = sinf(t7), t9 = cosf(t7), t10 = together + t4;
        const float t11 = (t9*t9), t12 = (t8*t8), t13 = t11*t12;
        const float t14 = together*t11 - t12*t4, t15 = 1.0f/((t10*t10)*t13 + (t14*t14));
        const float t17 = -at_minus_one*t12 + t1*t11, t18 = -t10*t17 + t14*t16;
        const float t19 = t10*t13*t16 + t14*t17, t20 = cosine*t15;
        const float t21 = -sine*t15*t19/sinf(t5) - 0.5f*t18*t20;
        *alpha_out = sine*t15*t18*t8*t9 - 2.0f*t12*t21 - t19*t20; *beta_out = t21;
        *theta_out = t5; return;
    }
    float apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    const float t27 = max_stiffness_angle(gamma, delta, d, whole, part, m2, m0, t1, at_minus_one,
        t3, together, apart);
    float cosine_2, sine_2; next_wave(whole, t27, &cosine_2, &sine_2);
    const float t28 = 0.5f*t27, t29 = sinf(t28), t30 = cosf(t28), t32 = (t30*t30);
    const float t33 = (t29*t29), t34 = -apart*t33 + together*t32;
    const float t35 = 2.0f*m2 - 2.0f*m0, t36 = t32*t33;
    const float t37 = 1.0f/((t34*t34) + (t35*t35)*t36);
    const float t38 = -at_minus_one*t33 + t1*t32, t39 = t16*t34 - t35*t38;
    const float t40 = t16*t35*t36 + t34*t38, t41 = cosine_2*t37;
    const float t42 = -sine_2*t37*t40/sinf(t27) - 0.5f*t39*t41;
    *alpha_out = sine_2*t29*t30*t37*t39 - 2.0f*t33*t42 - t40*t41; *beta_out = t42;
    *theta_out = t27; return;
}

float haptic_single_passivity_margin_at(float theta, float alpha, float beta, float delta,
    float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f) && (theta <= 3.1415925f) &&
        (theta > 0.0f))) {
        return NAN;
    }
    const float t0 = 0.5f*theta, cosine = cos_next(d, theta);
    const float sine = sin_next(2.0f*d, t0);
    return -0.5f*alpha*sine/sinf(t0) + beta*cosine + delta;
}

float haptic_single_passivity_margin(float alpha, float beta, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f))) {
        return NAN;
    }
    return delta - largest_required_damping(alpha, beta, d);
}

void haptic_single_passivity_boundary(float theta, float delta, float d, float *alpha_out,
    float *beta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (theta <= 3.1415925f) && (theta > 0.0f))) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const float whole = floorf(d), part = d - whole, t2 = 0.5f*theta;
    if (part == 0.0f) {
        const float t0 = lead(theta, d, 0.0f), t1 = delta/spread(d, theta);
        const float t15 = sinc(t2), sine = sin_next(d, theta);
        const float t3 = sine*(t15*t15)*(d + 1.0f)/theta;
        *alpha_out = rated(t0, 2.0f*t1*t3);
        *beta_out = rated(t0, t1*(-t3 + chord(d, theta))); return;
    }
    const float t6 = lead(theta, whole, part), t7 = whole + 1.0f;
    const float t8 = touching(theta, whole, part), t9 = cosf(t8), t10 = t9/t7;
    const float t11 = sinf(t8), t12 = -0.5f*t10 + t11;
    const float t13 = between(part, straight(t10, t12, whole, t2), straight(t10, t12, t7, t2));
    const float t16 = sinf(t2), t17 = cosf(t2);
    const float t14 = delta/(0.5f*t13 + 0.5f*
        sqrtf(part*(1.0f - part)*(4.0f*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7)) +
        (t13*t13)));
    *alpha_out = rated(t6, t10*t14); *beta_out = rated(t6, t12*t14); return;
}

void haptic_single_max_passive_stiffness(float delta, float d, float *alpha_out, float *beta_out,
    float *theta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f))) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const float whole = floorf(d), part = d - whole;
    if (part == 0.0f) {
        const float t0 = 3.1415927f/(d + 1.0f), t1 = tanf(0.25f*t0), t2 = 0.5f*t0;
        *alpha_out = 2.0f*delta*t1;
        *beta_out = delta*(-t1 + 2.0f/(3.1415927f*sinc(t2))); *theta_out = t2; return;
    }
    const float t4 = whole + 1.0f, t6 = passive_angle(whole, part);
    const float t7 = touching(t6, whole, part), t8 = cosf(t7), t9 = t8/t4;
    const float t10 = sinf(t7), t11 = t10 - 0.5f*t9, t12 = 0.5f*t6;
    const float t13 = between(part, straight(t9, t11, whole, t12), straight(t9, t11, t4, t12));
    const float t15 = sinf(t12), t16 = cosf(t12);
    const float t14 = delta/(0.5f*t13 + 0.5f*
        sqrtf(part*(1.0f - part)*(4.0f*(t10*t10)*(t15*t15) + (t16*t16)*(t8*t8)/(t4*t4)) +
        (t13*t13)));
    *alpha_out = t14*t9; *beta_out = t11*t14; *theta_out = t6; return;
}

float haptic_single_linear_limit(float beta, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(beta) <= 1e+08f))) {
        return NAN;
    }
    return (beta + delta)/(d + 0.5f);
}
