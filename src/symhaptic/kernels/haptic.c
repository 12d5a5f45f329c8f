/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#include "haptic.h"

#include <math.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif

// 1/n!
static const double inverse_factorial[] =
    {1.0, 1.0, 0.5, 0.16666666666666666, 0.041666666666666664, 0.008333333333333333,
    0.001388888888888889, 0.0001984126984126984, 2.48015873015873e-05, 2.7557319223985893e-06,
    2.755731922398589e-07, 2.505210838544172e-08, 2.08767569878681e-09, 1.6059043836821613e-10,
    1.1470745597729725e-11, 7.647163731819816e-13, 4.779477332387385e-14, 2.8114572543455206e-15,
    1.5619206968586225e-16, 8.22063524662433e-18, 4.110317623312165e-19, 1.9572941063391263e-20,
    8.896791392450574e-22, 3.868170170630684e-23, 1.6117375710961184e-24, 6.446950284384474e-26,
    2.4795962632247976e-27, 9.183689863795546e-29, 3.279889237069838e-30};

// x + y and what it misses, for |x| >= |y|
static inline void fast_two_sum(double x, double y, double *total_out, double *lost_out) {
    const double total = x + y, back = total - x;
    *total_out = total; *lost_out = -back + y; return;
}

// x - y and what it misses
static inline void two_diff(double x, double y, double *total_out, double *lost_out) {
    const double total = x - y, back = total - x, rest = -back + total, one = -rest + x;
    const double two = -back - y;
    *total_out = total; *lost_out = one + two; return;
}

// w = delta^2/4 - gamma, what it misses, its root and the size of the poles
static inline void device_motion(double gamma, double delta, double *w_out, double *w_low_out,
    double *root_out, double *reach_out) {
    const double half = 0.5*delta, square = (half*half);
    double total, lost; two_diff(square, gamma, &total, &lost);
    const double rest = lost + fma(half, half, -(half*half));
    double total2, lost2; fast_two_sum(total, rest, &total2, &lost2);
    const double root = sqrt(fabs(total2));
    *w_out = total2; *w_low_out = lost2; *root_out = root;
    *reach_out = (total2 < 0.0 ? 0.25*gamma : 0.4444444444444444*half + 0.4444444444444444*root);
    return;
}

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static inline double decay_series(double x) {
    const double square = (x*x);
    return square*(square*(square*(square*(square*
        (square*(square*(8.22063524662433e-18*square + 2.8114572543455206e-15) +
        7.647163731819816e-13) + 1.6059043836821613e-10) + 2.505210838544172e-08) +
        2.7557319223985893e-06) + 0.0001984126984126984) + 0.008333333333333333) - x*
        (square*(square*(square*(square*(square*
        (square*(1.5619206968586225e-16*square + 4.779477332387385e-14) + 1.1470745597729725e-11) +
        2.08767569878681e-09) + 2.755731922398589e-07) + 2.48015873015873e-05) +
        0.001388888888888889) + 0.041666666666666664) + 0.16666666666666666;
}

// x (y + y_low) and what it misses
static inline void wide_prod(double x, double y, double y_low, double *total_out,
    double *lost_out) {
    *total_out = x*y; *lost_out = x*y_low + fma(x, y, -(x*y)); return;
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4
static inline void brief_fading(double rate, double low, double *fall_out, double *fall_low_out,
    double *mean_out, double *mean_low_out) {
    double total, lost; fast_two_sum(1.0, -0.5*rate, &total, &lost);
    const double curved = (rate*rate)*decay_series(rate);
    double total2, lost2; fast_two_sum(total, curved, &total2, &lost2);
    const double bent = low*(0.125*(rate*rate) - 0.3333333333333333*rate + 0.5);
    const double mean_low = -bent + lost + lost2;
    double total3, lost3; wide_prod(rate, total2, mean_low, &total3, &lost3);
    double total4, lost4; fast_two_sum(1.0, -total3, &total4, &lost4);
    const double off = lost3 + low*total2;
    *fall_out = total4; *fall_low_out = lost4 - off; *mean_out = total2;
    *mean_low_out = mean_low; return;
}

// (x + x_low)/(y + y_low) and what it misses
static inline void wide_quot(double x, double y, double x_low, double y_low, double *total_out,
    double *lost_out) {
    const double total = x/y, left = -total*y + x;
    const double left2 = left - fma(total, y, -(total*y)), rest = -total*y_low + x_low;
    const double left3 = left2 + rest;
    *total_out = total; *lost_out = left3/y; return;
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss
static inline void fading_pair(double rate, double low, double *fall_out, double *fall_low_out,
    double *mean_out, double *mean_low_out) {
    if (rate < 0.75) {
        double fall, fall_low, mean, mean_low;
        brief_fading(rate, low, &fall, &fall_low, &mean, &mean_low);
        *fall_out = fall; *fall_low_out = fall_low; *mean_out = mean;
        *mean_low_out = mean_low; return;
    }
    const double sunk = exp(-rate);
    double total, lost; fast_two_sum(1.0, -sunk, &total, &lost);
    const double sunk_low = -low*sunk;
    double total2, lost2; wide_quot(total, rate, lost - sunk_low, low, &total2, &lost2);
    *fall_out = sunk; *fall_low_out = sunk_low; *mean_out = total2;
    *mean_low_out = lost2; return;
}

// number + delta one - gamma two and what it misses, of pairs
static inline void plant_n0_term(double gamma, double delta, double one, double one_low,
    double two, double two_low, double number, double *total_out, double *low_out) {
    double total, lost; wide_prod(delta, one, one_low, &total, &lost);
    double total2, lost2; wide_prod(gamma, two, two_low, &total2, &lost2);
    double total3, lost3; two_diff(total, total2, &total3, &lost3);
    double total4, lost4; two_diff(total3, -number, &total4, &lost4);
    const double rest = lost - lost2, both = lost3 + lost4;
    *total_out = total4; *low_out = both + rest; return;
}

// divided difference of exp at 0, p and q, less 1/2
static inline double plant_n0_series(double gamma, double delta) {
    double one = 0.0, two = 0.0;
    for (int n = ((0.5*delta < 0.0625) && (fabs(gamma) < 0.00390625) ? 13 : 28); n >= 6; n -= 1) {
        const double number = inverse_factorial[n], next_one = delta*one - gamma*two + number;
        two = one; one = next_one;
    }
    double one2, one_low;
    plant_n0_term(gamma, delta, one, 0.0, two, 0.0, 0.008333333333333333, &one2, &one_low);
    double one3, one_low2;
    plant_n0_term(gamma, delta, one2, one_low, one, 0.0, 0.041666666666666664, &one3, &one_low2);
    double one4, one_low3;
    plant_n0_term(gamma, delta, one3, one_low2, one2, one_low, 0.16666666666666666, &one4,
        &one_low3);
    double one5, one_low4;
    plant_n0_term(gamma, delta, one4, one_low3, one3, one_low2, 0.0, &one5, &one_low4);
    return one5 + one_low4;
}

// (fall + fall_low) (y + z), rounded once
static inline double scaled_sum(double fall, double fall_low, double y, double z) {
    double total, lost; two_diff(y, -z, &total, &lost);
    double total2, lost2; wide_prod(fall, total, lost, &total2, &lost2);
    const double low = fall_low*total + lost2;
    return low + total2;
}

// n0 of a device with slow poles
static inline double plant_n0_near(double fade_, double fade_low, double gamma, double delta) {
    double total, lost; wide_prod(fade_, fade_, 2.0*fade_low, &total, &lost);
    return scaled_sum(total, lost, plant_n0_series(gamma, delta), 0.5);
}

// n0 of a creeping device
static inline double plant_n0_creep(double reach, double fade_, double fade_low, double gamma,
    double delta, double p, double p_low, double slow, double slow_low, double mean,
    double mean_low, double ratio, double ratio_low, double even, double even_low) {
    if (reach < 0.5625) { return plant_n0_near(fade_, fade_low, gamma, delta); }
    double total, lost; wide_prod(ratio, mean, mean_low, &total, &lost);
    double total2, lost2; two_diff(even, total, &total2, &lost2);
    const double pulled_low = lost + mean*ratio_low;
    const double rest = even_low + lost2 - pulled_low;
    double total3, lost3; wide_quot(total2, p, rest, p_low, &total3, &lost3);
    double total4, lost4; wide_prod(slow, total3, lost3, &total4, &lost4);
    const double low = lost4 + slow_low*total3;
    return low + total4;
}

// n0 of a swinging device
static inline double plant_n0_swing(double reach, double fade_, double fade_low, double half,
    double envelope, double even, double even_low, double wave, double wave_low, double gamma,
    double near, double known) {
    if (reach < 0.5625) { return plant_n0_near(fade_, fade_low, gamma, 2.0*half); }
    if (near > 0.0) { return known; }
    double total, lost; wide_prod(half, wave, wave_low, &total, &lost);
    double total2, lost2; two_diff(total, even, &total2, &lost2);
    double total3, lost3; two_diff(total2, -envelope, &total3, &lost3);
    const double rest = -even_low + lost + lost2 + lost3;
    double total4, lost4; wide_prod(envelope, total3, rest, &total4, &lost4);
    const double whole = (gamma == 0.0 ? 1.0 : gamma);
    double total5, lost5; wide_quot(total4, whole, lost4, 0.0, &total5, &lost5);
    return lost5 + total5;
}

// divided difference of exp at h and +-sqrt(w), less 1/2
static inline double plant_n1_series(double h, double w) {
    double total = 0.0, one = 0.0, two = 0.0;
    for (int n = ((fabs(w) < 0.00390625) && (h < 0.0625) ? 13 : 28); n >= 3; n -= 1) {
        const double number = inverse_factorial[n], even = number + two*w;
        total = even + h*total; two = one; one = even;
    }
    return h*total + two*w;
}

// n1 of a creeping device
static inline double plant_n1_creep(double reach, double fade_, double fade_low, double half,
    double w, double p, double p_low, double slow, double slow_low, double mean, double mean_low,
    double even, double even_low) {
    if (reach < 0.5625) { return scaled_sum(fade_, fade_low, plant_n1_series(half, w), 0.5); }
    double total, lost; wide_prod(slow, even, even_low, &total, &lost);
    double total2, lost2; two_diff(mean, total, &total2, &lost2);
    const double pulled_low = even*slow_low + lost;
    const double rest = lost2 + mean_low - pulled_low;
    double total3, lost3; wide_quot(total2, p, rest, p_low, &total3, &lost3);
    return lost3 + total3;
}

// n1 of a swinging device
static inline double plant_n1_swing(double reach, double fade_, double fade_low, double half,
    double w, double envelope, double even, double even_low, double wave, double wave_low,
    double gamma, double near, double known) {
    if (reach < 0.5625) { return scaled_sum(fade_, fade_low, plant_n1_series(half, w), 0.5); }
    if (near > 0.0) { return known; }
    double total, lost; wide_prod(half, wave, wave_low, &total, &lost);
    double total2, lost2; two_diff(even, -total, &total2, &lost2);
    double total3, lost3;
    wide_prod(envelope, total2, even_low + lost + lost2, &total3, &lost3);
    double total4, lost4; fast_two_sum(1.0, -total3, &total4, &lost4);
    const double whole = (gamma == 0.0 ? 1.0 : gamma);
    double total5, lost5; wide_quot(total4, whole, -lost3 + lost4, 0.0, &total5, &lost5);
    return lost5 + total5;
}

// a of a creeping device
static inline double plant_trace_creep(double slow, double slow_low, double ratio,
    double ratio_low) {
    double total, lost; fast_two_sum(1.0, ratio, &total, &lost);
    double total2, lost2; wide_prod(slow, total, lost + ratio_low, &total2, &lost2);
    const double low = lost2 + slow_low*total;
    return low + total2;
}

// a of a swinging device
static inline double plant_trace_swing(double envelope, double even, double even_low) {
    double total, lost; wide_prod(envelope, even, even_low, &total, &lost);
    return 2.0*lost + 2.0*total;
}

// what the root of |square + square_low| misses
static inline double root_miss(double square, double square_low, double root) {
    const double sign_low = (square < 0.0 ? -square_low : square_low);
    const double left = -(root*root) + fabs(square);
    const double left2 = left - fma(root, root, -(root*root)), left3 = left2 + sign_low;
    const double whole = (root == 0.0 ? 1.0 : root);
    return 0.5*left3/whole;
}

// the poles p = half + root and q = gamma/p and what they miss
static inline void real_poles(double gamma, double half, double w, double w_low, double root,
    double *p_out, double *p_low_out, double *q_out, double *q_low_out) {
    double total, lost; fast_two_sum(half, root, &total, &lost);
    const double p_low = lost + root_miss(w, w_low, root);
    const double whole = (total == 0.0 ? 1.0 : total), q = gamma/whole;
    const double off = gamma - q*whole, off2 = off - fma(whole, q, -(whole*q));
    const double off3 = off2 - p_low*q;
    *p_out = whole; *p_low_out = p_low; *q_out = q; *q_low_out = off3/whole; return;
}

// exp(-half) of a device with slow poles, and what it misses
static inline void slow_fade(double reach, double half, double *fade_out, double *low_out) {
    if (reach < 0.5625) {
        double fall, fall_low, mean, mean_low;
        brief_fading(0.5*half, 0.0, &fall, &fall_low, &mean, &mean_low);
        double total, lost; wide_prod(fall, fall, 2.0*fall_low, &total, &lost);
        *fade_out = total; *low_out = lost; return;
    }
    *fade_out = 0.0; *low_out = 0.0; return;
}

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static inline double cos_series(double w) {
    const double square = (w*w);
    double one = 0.0, two = 0.0;
    for (int n = 22; n >= 6; n -= 2) {
        const double number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.041666666666666664;
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static inline double sin_series(double w) {
    const double square = (w*w);
    double one = 0.0, two = 0.0;
    for (int n = 21; n >= 5; n -= 2) {
        const double number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.16666666666666666;
}

// cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle
static inline void waving_pair(double square, double square_low, double angle, double *even_out,
    double *even_low_out, double *odd_out, double *odd_low_out) {
    if (square > -1.5) {
        double total, lost; fast_two_sum(1.0, 0.5*square, &total, &lost);
        const double curved = (square*square)*cos_series(square);
        double total2, lost2; fast_two_sum(total, curved, &total2, &lost2);
        const double both = lost + lost2, bent = square*sin_series(square);
        double total3, lost3; fast_two_sum(1.0, bent, &total3, &lost3);
        *even_out = total2; *even_low_out = both + 0.5*square_low; *odd_out = total3;
        *odd_low_out = lost3 + 0.16666666666666666*square_low; return;
    }
    const double angle_low = root_miss(square, square_low, angle), sine = sin(angle);
    const double cosine = cos(angle);
    double total4, lost4;
    wide_quot(sine, angle, angle_low*cosine, angle_low, &total4, &lost4);
    *even_out = cosine; *even_low_out = -angle_low*sine; *odd_out = total4;
    *odd_low_out = lost4; return;
}

// x y and what it misses
static inline void two_prod(double x, double y, double *total_out, double *lost_out) {
    *total_out = x*y; *lost_out = fma(x, y, -(x*y)); return;
}

// whether the device has nearly swung whole turns; n1, n0 and n1 + n0 there
static inline void whole_turns(double half, double square, double square_low, double root,
    double stiff, double *near_out, double *risen_out, double *sunk_out, double *moved_out) {
    if ((half < 0.75) && (root < 67108864.0) && (root > 3.0)) {
        const double count = floor(0.5*root/3.141592653589793 + 0.5);
        double total8, lost8; two_prod(count, 6.283185307179586, &total8, &lost8);
        double total9, lost9; two_diff(root, -total8, &total9, &lost9);
        const double missed = root_miss(square, square_low, root);
        const double turns = (count*count);
        double total, lost; two_prod(turns, 39.47841760435743, &total, &lost);
        double total2, lost2; two_prod(turns, 2.5061182034958845e-15, &total2, &lost2);
        double total3, lost3; two_diff(-square, total, &total3, &lost3);
        double total4, lost4; two_diff(total3, lost, &total4, &lost4);
        double total5, lost5; two_diff(total4, total2, &total5, &lost5);
        double total6, lost6; two_diff(total5, square_low, &total6, &lost6);
        const double turned_low = 1.4920070805839235e-31*turns;
        const double low = -lost2 + lost3 + lost4 + lost5 + lost6 - turned_low;
        double total7, lost7; two_diff(total6, -low, &total7, &lost7);
        const double back = 2.4492935982947064e-16*count;
        const double both_low = back + lost8 + lost9 + missed;
        const double whole = (total9 == 0.0 ? 1.0 : total9);
        double total10, lost10; wide_quot(total7, whole, lost7, both_low, &total10, &lost10);
        const double far = (total10*total10);
        if ((count > 0.0) && (far < 1.5)) {
            double fall, fall_low, mean, mean_low;
            brief_fading(half, 0.0, &fall, &fall_low, &mean, &mean_low);
            double total26, lost26; fast_two_sum(1.0, -fall, &total26, &lost26);
            double total11, lost11; wide_prod(total10, total10, 2.0*lost10, &total11, &lost11);
            double total13, lost13;
            fast_two_sum(1.0, -total11*sin_series(-total11), &total13, &lost13);
            double total14, lost14; wide_prod(total10, total13, lost13, &total14, &lost14);
            const double bent = (total11*total11)*cos_series(-total11);
            double total12, lost12; fast_two_sum(0.5*total11, -bent, &total12, &lost12);
            const double lift_low = 0.5*lost11*total13 + lost12;
            double total19, lost19; wide_prod(fall, total12, lift_low, &total19, &lost19);
            double total29, lost29; wide_prod(fall, total12, lift_low, &total29, &lost29);
            double total15, lost15;
            wide_quot(total14, root, lost10*(1.0 - total12) + lost14, missed, &total15, &lost15);
            double total16, lost16; wide_prod(fall, total15, lost15, &total16, &lost16);
            double total17, lost17; two_diff(mean, total16, &total17, &lost17);
            double total21, lost21; two_diff(mean, total15, &total21, &lost21);
            double total22, lost22;
            wide_prod(half, total21, -lost15 + lost21 + mean_low, &total22, &lost22);
            double total23, lost23; two_diff(total12, total22, &total23, &lost23);
            const double whole2 = (stiff == 0.0 ? 1.0 : stiff);
            const double low2 = -fall_low*total15 - lost16 + lost17 + mean_low;
            double total18, lost18; wide_prod(half, total17, low2, &total18, &lost18);
            double total20, lost20; two_diff(total18, -total19, &total20, &lost20);
            const double low3 = lift_low - lost22 + lost23;
            double total24, lost24; two_diff(total23, -low3, &total24, &lost24);
            double total25, lost25; wide_prod(fall, total24, lost24, &total25, &lost25);
            const double low4 = -fall_low + lost26;
            double total27, lost27; fast_two_sum(total26, low4, &total27, &lost27);
            double total28, lost28; wide_prod(total27, total27, 2.0*lost27, &total28, &lost28);
            double total30, lost30; two_diff(total28, -2.0*total29, &total30, &lost30);
            const double low5 = fall_low*total12 + lost18 + lost19 + lost20;
            double total31, lost31; wide_quot(total20, whole2, low5, 0.0, &total31, &lost31);
            const double low6 = fall_low*total24 + lost25;
            double total32, lost32; wide_quot(total25, whole2, low6, 0.0, &total32, &lost32);
            const double low7 = 2.0*fall_low*total12 + lost28 + 2.0*lost29 + lost30;
            double total33, lost33; wide_quot(total30, whole2, low7, 0.0, &total33, &lost33);
            *near_out = 1.0; *risen_out = lost31 + total31;
            *sunk_out = lost32 + total32; *moved_out = lost33 + total33; return;
        }
        *near_out = 0.0; *risen_out = 0.0; *sunk_out = 0.0; *moved_out = 0.0; return;
    }
    *near_out = 0.0; *risen_out = 0.0; *sunk_out = 0.0; *moved_out = 0.0; return;
}

// n0, the same device with its time reversed, times exp(-delta); n1, how far a unit force moves the
// device in a period; a, the sum of the sampled device's poles
static inline void device_n0_n1_trace(double gamma, double delta, double *n0_out, double *n1_out,
    double *trace_out) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
        const double envelope = exp(-half);
        *n0_out = plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd,
            odd_low, gamma, near, sunk);
        *n1_out = plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
        *trace_out = plant_trace_swing(envelope, even, even_low); return;
    }
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *n0_out = plant_n0_creep(reach, fade_, fade_low, gamma, delta, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2, mean2, mean_low2);
    *n1_out = plant_n1_creep(reach, fade_, fade_low, half, w, p, p_low, fall, fall_low, mean,
        mean_low, mean2, mean_low2);
    *trace_out = plant_trace_creep(fall, fall_low, fall2, fall_low2); return;
}

// exp(-p), of the faster pole, and what it misses
static inline void fast_fall(double slow, double slow_low, double ratio, double ratio_low,
    double *fast_out, double *low_out) {
    double total, lost; wide_prod(slow, ratio, ratio_low, &total, &lost);
    *fast_out = total; *low_out = lost + ratio*slow_low; return;
}

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static inline double numerator_at_one_series(double h, double w) {
    const double y = (h*h);
    double total = 0.0, inner = 0.0;
    for (int n = ((fabs(w) < 0.00390625) && (h < 0.0625) ? 12 : 28); n >= 4; n -= 2) {
        const double number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y;
}

// n1 + n0 of a creeping device
static inline double numerator_at_one_creep(double reach, double half, double w, double p,
    double p_low, double slow, double slow_low, double mean, double mean_low, double ratio,
    double ratio_low) {
    if (reach < 1.0) {
        return 2.0*scaled_sum(exp(-half), 0.0, numerator_at_one_series(half, w), 0.5);
    }
    double fast, fast_low; fast_fall(slow, slow_low, ratio, ratio_low, &fast, &fast_low);
    double total, lost; fast_two_sum(1.0, -fast, &total, &lost);
    double total2, lost2; wide_prod(mean, total, -fast_low + lost, &total2, &lost2);
    const double moved_low = lost2 + mean_low*total;
    double total3, lost3; wide_quot(total2, p, moved_low, p_low, &total3, &lost3);
    return lost3 + total3;
}

// (1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses
static inline void half_squares(double half, double envelope, double wave, double back,
    double *total_out, double *low_out) {
    double total, lost; two_diff(wave, back, &total, &lost);
    double total2, lost2; two_prod(total, total, &total2, &lost2);
    const double grown = -0.5*expm1(-half), low = 2.0*lost*total + lost2;
    double total3, lost3; wide_prod(envelope, total2, low, &total3, &lost3);
    double total4, lost4; two_diff(total3, -(grown*grown), &total4, &lost4);
    *total_out = total4; *low_out = lost3 + lost4; return;
}

// n1 + n0 of a swinging device
static inline double numerator_at_one_swing(double reach, double half, double w, double w_low,
    double envelope, double root, double gamma, double near, double known) {
    if (reach < 1.0) {
        return 2.0*scaled_sum(envelope, 0.0, numerator_at_one_series(half, w), 0.5);
    }
    if (near > 0.0) { return known; }
    const double angle = 0.5*root, back = -0.5*root_miss(w, w_low, root)*cos(angle);
    double total, low; half_squares(half, envelope, sin(angle), back, &total, &low);
    const double whole = (gamma == 0.0 ? 1.0 : gamma);
    double total2, lost; wide_quot(total, whole, low, 0.0, &total2, &lost);
    return 4.0*lost + 4.0*total2;
}

// n1 + n0; a, the sum of the sampled device's poles
static inline void device_together_trace(double gamma, double delta, double *together_out,
    double *trace_out) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        const double envelope = exp(-half);
        *together_out = numerator_at_one_swing(reach, half, w, w_low, envelope, root, gamma, near,
            moved);
        *trace_out = plant_trace_swing(envelope, even, even_low); return;
    }
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *together_out = numerator_at_one_creep(reach, half, w, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2);
    *trace_out = plant_trace_creep(fall, fall_low, fall2, fall_low2); return;
}

// n0, the same device with its time reversed, times exp(-delta)
static inline double plant_n0(double gamma, double delta) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    if (reach < 0.5625) { return plant_n0_near(fade_, fade_low, gamma, delta); }
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        const double envelope = exp(-half);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        return plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd, odd_low,
            gamma, near, sunk);
    }
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    return plant_n0_creep(reach, fade_, fade_low, gamma, delta, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2, mean2, mean_low2);
}

// n1, how far a unit force moves the device in a period
static inline double plant_n1(double gamma, double delta) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    if (reach < 0.5625) { return scaled_sum(fade_, fade_low, plant_n1_series(half, w), 0.5); }
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        const double envelope = exp(-half);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        return plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
    }
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    return plant_n1_creep(reach, fade_, fade_low, half, w, p, p_low, fall, fall_low, mean,
        mean_low, mean2, mean_low2);
}

// (1 - exp(-x))/x
static inline double decay(double x) {
    if (x == 0.0) { return 1.0; }
    return -expm1(-x)/x;
}

// 1 + a + e of a creeping device
static inline double denominator_at_minus_one_creep(double slow, double slow_low, double ratio,
    double ratio_low) {
    double total, lost; fast_two_sum(1.0, slow, &total, &lost);
    double fast, fast_low; fast_fall(slow, slow_low, ratio, ratio_low, &fast, &fast_low);
    double total2, lost2; fast_two_sum(1.0, fast, &total2, &lost2);
    double total3, lost3; wide_prod(total, total2, fast_low + lost2, &total3, &lost3);
    const double low = lost3 + total2*(lost + slow_low);
    return low + total3;
}

// 1 + a + e of a swinging device
static inline double denominator_at_minus_one_swing(double half, double w, double w_low,
    double envelope, double even, double even_low, double root) {
    double total3, lost2; wide_prod(2.0*envelope, even, even_low, &total3, &lost2);
    if (total3 > 0.0) {
        const double e = exp(-2.0*half);
        double total2, lost; fast_two_sum(1.0, e, &total2, &lost);
        double total4, lost3; fast_two_sum(total2, total3, &total4, &lost3);
        const double rest = lost + lost2 + lost3;
        return rest + total4;
    }
    const double angle = 0.5*root, back = 0.5*root_miss(w, w_low, root)*sin(angle);
    double total, low; half_squares(half, envelope, cos(angle), back, &total, &low);
    return 4.0*low + 4.0*total;
}

// divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6
static inline double numerator_gap_series(double h, double w) {
    const double y = (h*h);
    double total = 0.0, inner = 0.0;
    for (int n = ((fabs(w) < 0.00390625) && (h < 0.0625) ? 13 : 27); n >= 5; n -= 2) {
        const double number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y + 9.25185853854297e-18;
}

// (n1 - n0)/delta of a creeping device
static inline double numerator_gap_creep(double reach, double half, double w, double delta,
    double p, double slow, double mean, double mean_low, double ratio, double even,
    double even_low) {
    if (reach < 1.0) {
        return scaled_sum(exp(-half), 0.0, numerator_gap_series(half, w), 0.16666666666666666);
    }
    const double fast = ratio*slow;
    double total3, lost3; wide_prod(fast, mean, mean_low, &total3, &lost3);
    const double twice = 2.0*slow;
    double total, lost; wide_prod(twice, even, even_low, &total, &lost);
    double total2, lost2; two_diff(mean, total, &total2, &lost2);
    const double top = total2 + total3, rest = -lost + lost3 + mean_low;
    const double low = lost2 + rest, whole = (delta*p == 0.0 ? 1.0 : delta*p);
    return (low + top)/whole;
}

// (n1 - n0)/delta of a swinging device
static inline double numerator_gap_swing(double reach, double half, double w, double envelope,
    double wave, double wave_low, double gamma, double delta) {
    if (reach < 1.0) {
        return scaled_sum(envelope, 0.0, numerator_gap_series(half, w), 0.16666666666666666);
    }
    double total, lost; wide_prod(envelope, wave, wave_low, &total, &lost);
    const double mean = decay(delta);
    double total2, lost2; two_diff(mean, total, &total2, &lost2);
    const double whole = (gamma == 0.0 ? 1.0 : gamma);
    double total3, lost3; wide_quot(total2, whole, -lost + lost2, 0.0, &total3, &lost3);
    return lost3 + total3;
}

// 1 + a + e; n1 + n0; (n1 - n0)/delta; n0, the same device with its time reversed, times
// exp(-delta); n1, how far a unit force moves the device in a period
static inline void device_at_minus_one_together_n_gap_n0_n1(double gamma, double delta,
    double *at_minus_one_out, double *together_out, double *n_gap_out, double *n0_out,
    double *n1_out) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
        const double envelope = exp(-half);
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
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
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
static inline double cubic_root(double k0, double k1, double k2, double k3, double low,
    double high, double rise) {
    const double convex = (2.0*k2 + 3.0*k3*(high + low) > 0.0 ? 1.0 : -1.0);
    const double down = (convex*rise > 0.0 ? 1.0 : -1.0);
    double y = (down > 0.0 ? high : low), moves = 1.0;
    for (int count_y = 0; count_y < 100; ++count_y) {
        if (moves == 0.0) { break; }
        const double steep = k1 + y*(2.0*k2 + 3.0*k3*y), some = (steep == 0.0 ? 1.0 : steep);
        const double move = (steep == 0.0 ? 0.0 : (k0 + y*(k1 + y*(k2 + k3*y)))/some);
        const double new_ = fmin(high, -move + y), new2 = fmax(low, new_);
        moves = (down*(-new2 + y) > 0.0 ? 1.0 : 0.0); y = new2;
    }
    return y;
}

// the angle of x + j y in half turns, and the rest
static inline void turn_angle(double x, double y, double *halves_out, double *rest_out) {
    *halves_out = (x < 0.0 ? (y < 0.0 ? -1.0 : 1.0) : 0.0);
    *rest_out = atan2((x < 0.0 ? -y : y), fabs(x)); return;
}

// the nearest whole number of turns in the phase at a crossing
static inline double phase_turns(double y, double rest, double off, double alpha, double slope,
    double far, double d, double n1, double loss, double together, double apart) {
    const double at = fmax(0.0, y), still = fmax(0.0, rest), sine = 2.0*sqrt(at*still);
    double halves, turned; turn_angle(off*(2.0*loss - 4.0), loss*sine, &halves, &turned);
    double halves2, turned2;
    turn_angle(-apart*at + still*together, n1*sine, &halves2, &turned2);
    double halves3, turned3;
    turn_angle(alpha*still - at*far, sine*slope, &halves3, &turned3);
    const double half = atan2((at > 2.0 ? sqrt(still) : sqrt(at)),
        (at > 2.0 ? sqrt(at) : sqrt(still)));
    const double late = d + 2.0;
    const double halves4 = -halves + halves2 + halves3 - (at > 2.0 ? late : 0.0);
    const double share = 0.5*(-late*(at > 2.0 ? -2.0*half : 2.0*half) - turned + turned2 + turned3)/
        3.141592653589793;
    const double even = floor(0.5*halves4), left = -even + 0.5*halves4;
    return even + (left == 0.5 ? floor(share) + 1.0 : floor(left + share + 0.5));
}

// what the crossing on a piece, if there is one, adds
static inline double piece_turns(double k0, double k1, double k2, double k3, double low,
    double high, double at_low, double at_high, double zone, double alpha, double slope,
    double far, double n1, double loss, double together, double apart, double center,
    double beyond, double d) {
    if ((((at_high < 0.0) && (at_low >= 0.0)) || ((at_high >= 0.0) && (at_low < 0.0))) &&
        (high > low)) {
        const double x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const double y = (zone == 0.0 ? x : (zone == 1.0 ? center + x : 4.0 - x));
        const double rest = (zone == 0.0 ? 4.0 - x : (zone == 1.0 ? beyond - x : x));
        double turned;
        if ((rest > 0.0) && (y > 0.0)) {
            const double off = (zone == 0.0 ? -center + x : (zone == 1.0 ? x : beyond - x));
            const double found = phase_turns(y, rest, off, alpha, slope, far, d, n1, loss,
                together, apart);
            const double rises = (zone == 2.0 ? -1.0 : 1.0)*(at_high > at_low ? 1.0 : -1.0);
            turned = -2.0*found*rises;
        } else {
            turned = 0.0;
        }
        return turned;
    }
    return 0.0;
}

// what the crossings between two points add to the count
static inline double zone_turns(double k0, double k1, double k2, double k3, double low,
    double high, double at_low, double at_high, double zone, double alpha, double slope,
    double far, double n1, double loss, double together, double apart, double center,
    double beyond, double d) {
    const double disc = -3.0*k1*k3 + (k2*k2);
    const double some = (fabs(k2) < 24.0*fabs(k3) ? 3.0*k3 : 1.0), at = -k2/some;
    const double cut = ((at < high) && (at > low) && (fabs(k2) < 24.0*fabs(k3)) ? at : low);
    double one, two;
    if (disc < 0.0) {
        one = low; two = low;
    } else {
        const double root = sqrt(fmax(0.0, disc)), q = -k2 - (k2 < 0.0 ? -root : root);
        const double some2 = (fabs(q) < 24.0*fabs(k3) ? 3.0*k3 : 1.0), at2 = q/some2;
        const double some3 = (fabs(k1) < 8.0*fabs(q) ? q : 1.0), at3 = k1/some3;
        one = ((at2 < high) && (at2 > low) && (fabs(q) < 24.0*fabs(k3)) ? at2 : low);
        two = ((at3 < high) && (at3 > low) && (fabs(k1) < 8.0*fabs(q)) ? at3 : low);
    }
    const double less = fmin(one, two), more = fmax(one, two), first = fmin(cut, less);
    const double middle = fmax(cut, less), last = fmax(middle, more);
    const double middle2 = fmin(middle, more);
    const double height = first*(first*(first*k3 + k2) + k1) + k0;
    const double height2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2));
    const double height3 = k0 + last*(k1 + last*(k2 + k3*last));
    const double found = piece_turns(k0, k1, k2, k3, low, first, at_low, height, zone, alpha,
        slope, far, n1, loss, together, apart, center, beyond, d);
    const double found2 = found + piece_turns(k0, k1, k2, k3, first, middle2, height, height2,
        zone, alpha, slope, far, n1, loss, together, apart, center, beyond, d);
    const double found3 = found2 + piece_turns(k0, k1, k2, k3, middle2, last, height2, height3,
        zone, alpha, slope, far, n1, loss, together, apart, center, beyond, d);
    return found3 + piece_turns(k0, k1, k2, k3, last, high, height3, at_high, zone, alpha, slope,
        far, n1, loss, together, apart, center, beyond, d);
}

// roots outside the unit circle, behind a fractional delay
static inline double fractional_roots(double alpha, double beta, double d, double m2, double m0,
    double at_one, double at_minus_one, double loss, double together, double apart) {
    const double slope = alpha + beta, wall_far = alpha + 2.0*beta, force = beta*slope;
    const double across = -m0 + m2, square = m0*m2, even = together*(m0 + m2);
    const double linear = (across*across) - even, pushed_ = alpha*together;
    const double lost = (loss*loss), near0 = (at_one - pushed_)*(at_one + pushed_);
    const double near1 = -(alpha*alpha)*linear - at_one*(2.0 - loss) - force*(together*together) +
        lost;
    const double near2 = -(alpha*alpha)*square - force*linear - loss + 1.0;
    const double near3 = -force*square, square2 = m0*m2, even2 = apart*(m0 + m2);
    const double linear2 = (across*across) - even2, pushed2 = apart*wall_far;
    const double lost2 = (loss*loss);
    const double far0 = (at_minus_one - pushed2)*(at_minus_one + pushed2);
    const double far1 = (apart*apart)*force - at_minus_one*(2.0 - loss) - linear2*
        (wall_far*wall_far) + lost2;
    const double far2 = force*linear2 - loss - square2*(wall_far*wall_far) + 1.0;
    const double far3 = force*square2, middle = 2.0*at_one/(2.0 - loss);
    const double rest = 2.0*at_minus_one/(2.0 - loss), sine = 0.25*middle*rest;
    const double tilt = -0.25*middle + 0.25*rest;
    const double real = -0.25*apart*middle + 0.25*rest*together, size = (across*across);
    const double lost3 = (loss*loss), one = (real*real) + sine*size;
    const double two = -real*(m0 + m2) + size*tilt, three = m0*m2;
    const double wave = 0.25*alpha*rest - 0.25*middle*wall_far;
    const double wall = sine*(slope*slope) + (wave*wave), own0 = lost3*sine - one*wall;
    const double own1 = -force*one + lost3*tilt - two*wall;
    const double own2 = -force*two - loss - three*wall + 1.0, own3 = -force*three;
    const double one2 = 0.5*middle, two2 = 0.5*rest;
    const double before = -one2*(-one2*(-one2*own3 + own2) + own1) + own0;
    const double after = own0 + two2*(own1 + two2*(own2 + own3*two2)), zone = 0.0;
    const double zone2 = 1.0, zone3 = 2.0, side = (slope >= 0.0 ? 1.0 : -1.0);
    const double end = -d + (wall_far > 0.0 ? side : 0.0) +
        (apart > 0.0 ? (across >= 0.0 ? 1.0 : -1.0) : 0.0) - 3.0;
    const double total = (((((((near2 == 0.0) && (near3 < 0.0)) || (near2 < 0.0)) &&
        (near1 == 0.0)) || (near1 < 0.0)) && (near0 == 0.0)) || (near0 < 0.0) ?
        (alpha > 0.0 ? 0.0 : side) : 0.0) + zone_turns(far0, far1, far2, far3, zone, two2, far0,
        after, zone3, alpha, slope, wall_far, across, loss, together, apart, middle, rest, d) +
        zone_turns(near0, near1, near2, near3, zone, one2, near0, before, zone, alpha, slope,
        wall_far, across, loss, together, apart, middle, rest, d) +
        zone_turns(own0, own1, own2, own3, -one2, two2, before, after, zone2, alpha, slope,
        wall_far, across, loss, together, apart, middle, rest, d);
    return total - (((((((far2 == 0.0) && (far3 < 0.0)) || (far2 < 0.0)) && (far1 == 0.0)) ||
        (far1 < 0.0)) && (far0 == 0.0)) || (far0 < 0.0) ? end : 0.0);
}

// m2 - m1 + m0, M at z = -1 behind a fraction of a period
static inline double fractional_numerator_gap(double epsilon, double x, double x_low, double y,
    double y_low, double first, double last, double turned) {
    double total, lost; fast_two_sum(1.0, -epsilon, &total, &lost);
    double total2, lost2; wide_prod(epsilon, total, lost, &total2, &lost2);
    double total3, lost3; wide_prod(x, y, y_low, &total3, &lost3);
    const double both_low = lost3 + x_low*y;
    double total4, lost4; wide_prod(total2, total3, both_low, &total4, &lost4);
    double total5, lost5; two_diff(first, 2.0*total4, &total5, &lost5);
    double total6, lost6; two_diff(total5, last, &total6, &lost6);
    double total7, lost7; two_diff(total6, -turned, &total7, &lost7);
    const double low = lost2*total3 + lost4, rest = lost5 + lost6, rest2 = lost7 + rest;
    const double rest3 = -2.0*low + rest2;
    return rest3 + total7;
}

// displacement by a unit impulse after a period; what the last rounding of Kick takes; (n1 -
// n0)/delta; n0, the same device with its time reversed, times exp(-delta); n1, how far a unit
// force moves the device in a period
static inline void device_kick_kick_low_n_gap_n0_n1(double gamma, double delta, double *kick_out,
    double *kick_low_out, double *n_gap_out, double *n0_out, double *n1_out) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
        const double envelope = exp(-half);
        double total2, lost2; wide_prod(envelope, odd, odd_low, &total2, &lost2);
        double total3, lost3; fast_two_sum(total2, lost2, &total3, &lost3);
        *kick_out = total3; *kick_low_out = lost3;
        *n_gap_out = numerator_gap_swing(reach, half, w, envelope, odd, odd_low, gamma, delta);
        *n0_out = plant_n0_swing(reach, fade_, fade_low, half, envelope, even, even_low, odd,
            odd_low, gamma, near, sunk);
        *n1_out = plant_n1_swing(reach, fade_, fade_low, half, w, envelope, even, even_low, odd,
            odd_low, gamma, near, risen);
        return;
    }
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    double fade_, fade_low; slow_fade(reach, half, &fade_, &fade_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    double total, lost; wide_prod(fall, mean2, mean_low2, &total, &lost);
    const double creep_low = fall_low*mean2 + lost;
    double total4, lost4; fast_two_sum(total, creep_low, &total4, &lost4);
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
static inline void late_device(double gamma, double delta, double part, double *apart_out,
    double *m2_out, double *m0_out) {
    const double t0 = 1.0 - part, t1 = (t0*t0), t2 = gamma*t1, t3 = delta*t0;
    double kick_of2, kick_low_of, n_gap, n0_2, n1;
    device_kick_kick_low_n_gap_n0_n1(t2, t3, &kick_of2, &kick_low_of, &n_gap, &n0_2, &n1);
    const double t4 = (part*part), t5 = gamma*t4, t6 = delta*part;
    double kick_of, kick_low_of2, n_gap_2, n0, n1_2;
    device_kick_kick_low_n_gap_n0_n1(t5, t6, &kick_of, &kick_low_of2, &n_gap_2, &n0, &n1_2);
    const double t8 = n0*t4;
    *apart_out = fractional_numerator_gap(part, kick_of2, kick_low_of, kick_of, kick_low_of2, delta*
        n_gap*(t0*t0*t0), delta*n_gap_2*(part*part*part), n0_2*t1*(kick_of*t6 + n1_2*t5) + n1*n1_2*
        t2*t4 - t3*t8*decay(t3));
    *m2_out = n1*t1; *m0_out = t8*exp(-t3); return;
}

// 1 where the loop is stable, else 0
static inline double stable(double roots, double alpha, double beta, double gamma, double delta) {
    const double swing = sqrt(gamma);
    if ((!((alpha == 0.0) && (beta == 0.0) && (delta == 0.0))) &&
        (!((delta < 1.1102230246251565e-15) && (gamma > 1.0) &&
        (swing >= 2251799813685248.0*fabs(sin(swing))))) && (alpha > -gamma) && (roots == 0.0)) {
        return 1.0;
    }
    return 0.0;
}

// the turns at a crossing, if there is one
static inline double crossing_turns(double y, double rest, double off, double center,
    double beyond, double alpha, double slope, double far, double d, double n1, double loss,
    double together, double apart) {
    const double edge = (rest > y ? y : rest);
    if ((edge < 4.0) && (rest > 0.0) && (y > 0.0)) {
        const double inside = ((beyond - off > 0.0) && (center + off > 0.0) && (edge > fabs(off)) ?
            1.0 : 0.0);
        const double at = (inside > 0.0 ? center + off : (rest > y ? y : 4.0 - rest));
        const double still = (inside > 0.0 ? beyond - off : (rest > y ? 4.0 - y : rest));
        const double away = (inside > 0.0 ? off : (rest > y ? -center + y : beyond - rest));
        return phase_turns(at, still, away, alpha, slope, far, d, n1, loss, together, apart);
    }
    return 0.0;
}

// (-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite
static inline void quadratic_roots(double c, double b, double a, double root, double *low_out,
    double *high_out) {
    const double q = -0.5*b - 0.5*(b >= 0.0 ? root : -root);
    const double lead_ = (a == 0.0 ? 1.0 : a), own = (q == 0.0 ? 1.0 : q);
    const double one = (a == 0.0 ? -1.0 : q/lead_), two = (q == 0.0 ? -1.0 : c/own);
    if (b >= 0.0) { *low_out = one; *high_out = two; return; }
    *low_out = two; *high_out = one; return;
}

// roots outside the unit circle
static inline double whole_roots(double alpha, double beta, double d, double n1, double n0,
    double at_one, double at_minus_one, double loss, double together, double apart) {
    const double e = 1.0 - loss, slope = alpha + beta, wall_far = alpha + 2.0*beta;
    const double force = beta*slope, cross = n0*n1, lost = (loss*loss);
    const double square = cross*force + e, push = alpha*together, pull = apart*wall_far;
    const double near0 = (at_one - push)*(at_one + push);
    const double near1 = (alpha*alpha)*cross - at_one*(e + 1.0) - force*(together*together) + lost;
    const double far0 = (at_minus_one - pull)*(at_minus_one + pull);
    const double far1 = (apart*apart)*force - at_minus_one*(e + 1.0) - cross*(wall_far*wall_far) +
        lost;
    const double center = 2.0*at_one/(e + 1.0), beyond = 2.0*at_minus_one/(e + 1.0);
    const double sine = 0.25*beyond*center, tilt = 0.25*beyond - 0.25*center;
    const double real = -0.25*apart*center + 0.25*beyond*together;
    const double m0 = (n1*n1)*sine + (real*real), m1 = (n1*n1)*tilt - n1*real;
    const double wave = 0.25*alpha*beyond - 0.25*center*wall_far;
    const double wall = sine*(slope*slope) + (wave*wave), own0 = lost*sine - m0*wall;
    const double own1 = -force*m0 + lost*tilt - m1*wall, own2 = e - force*m1;
    const double square2 = (near1*near1), product = 4.0*near0*square;
    const double size = square2 + fabs(product), square3 = (own1*own1);
    const double product2 = 4.0*own0*own2, size2 = square3 + fabs(product2);
    const double square4 = (far1*far1), product3 = 4.0*far0*square;
    const double size3 = square4 + fabs(product3), side = (slope >= 0.0 ? 1.0 : -1.0);
    const double end = -d + (wall_far > 0.0 ? side : 0.0) +
        (apart > 0.0 ? (n1 >= 0.0 ? 1.0 : -1.0) : 0.0) - 3.0;
    const double disc4 = ((size >= size2) && (size2 <= size3) ? -product2 + square3 :
        ((size > size3) && (size2 > size3) ? -product3 + square4 : -product + square2));
    double total;
    if (disc4 >= 0.0) {
        const double root = sqrt(disc4);
        double low, high; quadratic_roots(near0, near1, square, root, &low, &high);
        double low2, high2; quadratic_roots(own0, own1, own2, root, &low2, &high2);
        double low3, high3; quadratic_roots(far0, far1, square, root, &low3, &high3);
        total = -2.0*crossing_turns(high, low3, high2, center, beyond, alpha, slope, wall_far, d,
            n1, loss, together, apart) + 2.0*crossing_turns(low, high3, low2, center, beyond,
            alpha, slope, wall_far, d, n1, loss, together, apart);
    } else {
        total = 0.0;
    }
    const double total2 = total + (((((near1 == 0.0) && (square < 0.0)) || (near1 < 0.0)) &&
        (near0 == 0.0)) || (near0 < 0.0) ? (alpha > 0.0 ? 0.0 : side) : 0.0);
    return total2 - (((((far1 == 0.0) && (square < 0.0)) || (far1 < 0.0)) && (far0 == 0.0)) ||
        (far0 < 0.0) ? end : 0.0);
}

// the imaginary part of A/(z M) at z = exp(2 j psi); the real part of A/(z M) at z = exp(2 j psi)
static inline void ahead_in_phase(double psi, double at_one, double at_minus_one, double loss,
    double together, double apart, double across, double *ahead_out, double *in_phase_out) {
    const double t = tan(psi), square = (t*t), low = fma(t, t, -(t*t));
    const double taken = at_minus_one*square;
    double total, lost; two_diff(at_one, taken, &total, &lost);
    const double missed = at_minus_one*low + fma(at_minus_one, square, -(at_minus_one*square));
    const double lost2 = lost - missed;
    double total2, lost3; fast_two_sum(total, lost2, &total2, &lost3);
    const double taken2 = apart*square;
    double total3, lost4; two_diff(together, taken2, &total3, &lost4);
    const double missed2 = apart*low + fma(apart, square, -(apart*square));
    const double lost5 = lost4 - missed2;
    double total4, lost6; fast_two_sum(total3, lost5, &total4, &lost6);
    const double above_j = 2.0*loss*t, below_j = across*t;
    const double rest = (below_j*below_j) + 2.0*lost6*total4;
    const double size = rest + (total4*total4), low2 = above_j*lost6 - below_j*lost3;
    const double found = above_j*total4 - below_j*total2, found2 = found + low2;
    const double low22 = lost3*total4 + lost6*total2, rest2 = above_j*below_j + low22;
    const double found3 = rest2 + total2*total4;
    *ahead_out = found2/size; *in_phase_out = found3/size; return;
}

// 1 + a + e; n1 + n0; (n1 - n0)/delta
static inline void device_at_minus_one_together_n_gap(double gamma, double delta,
    double *at_minus_one_out, double *together_out, double *n_gap_out) {
    double w, w_low, root, reach; device_motion(gamma, delta, &w, &w_low, &root, &reach);
    const double half = 0.5*delta;
    if (w < 0.0) {
        double even, even_low, odd, odd_low;
        waving_pair(w, w_low, root, &even, &even_low, &odd, &odd_low);
        double near, risen, sunk, moved;
        whole_turns(half, w, w_low, root, gamma, &near, &risen, &sunk, &moved);
        const double envelope = exp(-half);
        *at_minus_one_out = denominator_at_minus_one_swing(half, w, w_low, envelope, even,
            even_low, root);
        *together_out = numerator_at_one_swing(reach, half, w, w_low, envelope, root, gamma, near,
            moved);
        *n_gap_out = numerator_gap_swing(reach, half, w, envelope, odd, odd_low, gamma, delta);
        return;
    }
    double p, p_low, q, q_low;
    real_poles(gamma, half, w, w_low, root, &p, &p_low, &q, &q_low);
    double fall, fall_low, mean, mean_low;
    fading_pair(q, q_low, &fall, &fall_low, &mean, &mean_low);
    const double root_low = root_miss(w, w_low, root);
    double fall2, fall_low2, mean2, mean_low2;
    fading_pair(2.0*root, 2.0*root_low, &fall2, &fall_low2, &mean2, &mean_low2);
    *at_minus_one_out = denominator_at_minus_one_creep(fall, fall_low, fall2, fall_low2);
    *together_out = numerator_at_one_creep(reach, half, w, p, p_low, fall, fall_low, mean,
        mean_low, fall2, fall_low2);
    *n_gap_out = numerator_gap_creep(reach, half, w, delta, p, fall, mean, mean_low, fall2, mean2,
        mean_low2);
    return;
}

// cos((k + 1) x) and sin((k + 1) x)
static inline void next_wave(double k, double x, double *cosine_out, double *sine_out) {
    const double count = k + 1.0, before = count - 1.0, angle = count*x;
    const double missed = -before + k, off = missed*x + fma(count, x, -(count*x));
    const double sine = sin(angle), cosine = cos(angle);
    *cosine_out = cosine - off*sine; *sine_out = cosine*off + sine; return;
}

// cos((k + 1) x)
static inline double cos_next(double k, double x) {
    double cosine, sine; next_wave(k, x, &cosine, &sine);
    return cosine;
}

// has the sign of the slope of the boundary's alpha, d < 1
static inline double early_slope(double theta, double k4, double k3, double k2, double k1,
    double k0) {
    const double sine = sin(0.5*theta), cosine = cos(0.5*theta), up = (sine*sine);
    const double along = (cosine*cosine), found = along*k3 + k4*up;
    const double power2 = (along*along), found2 = found*up + k2*power2;
    const double power3 = along*power2, found3 = found2*up + k1*power3;
    const double power4 = along*power3;
    return found3*up + k0*power4;
}

// has the sign of the slope of the boundary's alpha next to pi
static inline double end_slope(double at_minus_one, double loss, double together, double apart,
    double last) {
    double total, lost; two_diff(together, 4.0*last, &total, &lost);
    double total2, lost2; wide_prod(total, total, 2.0*lost, &total2, &lost2);
    double total3, lost3; two_prod(apart, together, &total3, &lost3);
    double total4, lost4; two_diff(total3, total2, &total4, &lost4);
    double total5, lost5; two_diff(total2, 2.0*total3, &total5, &lost5);
    double total7, lost7; wide_prod(apart, total3, lost3, &total7, &lost7);
    double total12, lost12; two_diff(2.0*apart, total, &total12, &lost12);
    double total13, lost13; two_prod(apart, apart, &total13, &lost13);
    double total14, lost14; wide_prod(total13, total12, -lost + lost12, &total14, &lost14);
    const double gap_low = -lost2 + lost3 + lost4;
    double total10, lost10; wide_prod(apart, total4, gap_low, &total10, &lost10);
    double total11, lost11; wide_prod(loss, total10, lost10, &total11, &lost11);
    const double lean_low = lost2 - 2.0*lost3 + lost5;
    double total6, lost6; wide_prod(total, total5, lean_low, &total6, &lost6);
    double total8, lost8; two_diff(total6, -total7, &total8, &lost8);
    const double bent_low = lost*total5 + lost6 + lost7 + lost8;
    double total9, lost9; wide_prod(at_minus_one, total8, bent_low, &total9, &lost9);
    double total15, lost15; two_diff(4.0*total14, total9, &total15, &lost15);
    double total16, lost16; two_diff(total15, 2.0*total11, &total16, &lost16);
    const double three_low = lost13*total12 + lost14;
    const double low = -2.0*lost11 + lost15 + lost16 - lost9 + 4.0*three_low;
    return low + total16;
}

// the next point of a search between a and b, where f is fa and fb, after c
static inline double next_guess(double b, double fb, double a, double fa, double c, double fc,
    double close) {
    const double span = -b + c, rise = -fb + fc, whole = (span == 0.0 ? 1.0 : span);
    const double place = (a - b)/whole, whole2 = (rise == 0.0 ? 1.0 : rise);
    const double height = (fa - fb)/whole2;
    const double safe = ((place < 1.0 - ((1.0 - height)*(1.0 - height))) &&
        (place > (height*height)) ? 1.0 : 0.0);
    const double width = -a + b, whole3 = (width == 0.0 ? 1.0 : width);
    const double edge = close*fabs((fabs(fa) < fabs(fb) ? a : b))/fabs(whole3);
    const double edge2 = fmin(0.5, edge);
    double guess;
    if (safe > 0.0) {
        const double one = -fa + fb, two = fb - fc, three = fa - fc, here = fa/one;
        const double there = fc/two, other = fa/three, last = fb/two;
        guess = here*there + last*other*(-a + c)/whole3;
    } else {
        guess = 0.5;
    }
    const double share = fmin(guess, 1.0 - edge2), share2 = fmax(edge2, share);
    return a + share2*width;
}

// the angle of the largest stiffness for delays below a period
static inline double early_angle(double at_one, double at_minus_one, double loss, double together,
    double apart, double last) {
    const double t = (apart*apart*apart), t2 = (together*together*together);
    const double t3 = (together*together), t4 = apart*t3, t5 = (apart*apart);
    const double t6 = 2.0*loss, t7 = at_minus_one + t6, t8 = 4.0*together;
    const double t9 = 16.0*apart, t10 = at_one + t6, t11 = 2.0*at_one;
    const double t12 = 5.0*at_minus_one, t13 = -at_one, t14 = 4.0*loss;
    const double t15 = apart*together, t16 = 16.0*together, t17 = at_one*last;
    const double t18 = apart*t11, t19 = at_one*t5;
    const double k = end_slope(at_minus_one, loss, together, apart, last);
    const double k2 = -4.0*at_minus_one*t2 + last*
        (32.0*at_minus_one*t3 + last*(64.0*apart*loss + 128.0*at_minus_one*last - 96.0*at_minus_one*
        together) - 96.0*t5 - t7*t9*together) + 16.0*t + 8.0*t4*(at_minus_one + loss) - t5*t7*t8;
    const double k3 = last*(last*(last*(-192.0*at_minus_one - 256.0*at_one - 512.0*loss) + t16*
        (9.0*at_one + 16.0*loss + t12) + t9*(8.0*at_minus_one + 8.0*at_one + 18.0*loss)) - 32.0*
        t15 - 4.0*t3*(at_minus_one + 7.0*at_one + 14.0*loss) - 112.0*t5) + 8.0*t + 2.0*t2*
        (-2.0*at_minus_one + t10) + 2.0*t4*(t12 + t13 + t14) - 2.0*t5*together*(-t11 + t7);
    const double k4 = last*(32.0*t17*together - 8.0*together*(t18 + 12.0*together)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const double k5 = last*(t16*t17 + t8*(t10*together - t18)) + together*
        (-2.0*t15*(at_one + loss) + t19 + t3*(at_minus_one + t11 + t14));
    double count = 1.0, found = 0.0;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0) || (found > 0.0)) { break; }
        const double rises = early_slope(0.041666666666666664*3.141592653589793*count, k, k2, k3,
            k4, k5);
        const double next_count = (rises > 0.0 ? count + 1.0 : count);
        found = (rises > 0.0 ? 0.0 : 1.0); count = next_count;
    }
    if (found > 0.0) {
        const double high = 0.041666666666666664*3.141592653589793*count;
        const double low = fmax(0.001*high, 0.041666666666666664*3.141592653589793*(count - 1.0));
        const double above = early_slope(low, k, k2, k3, k4, k5);
        if (above <= 0.0) { return low; }
        const double below = early_slope(high, k, k2, k3, k4, k5);
        if (below >= 0.0) { return high; }
        double b = low, fb = above, a = high, fa = below, c = high, fc = below;
        for (int count_b = 0; count_b < 120; ++count_b) {
            if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                (fabs(a - b) <= 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b)))) {
                break; }
            const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
            const double value = early_slope(new_, k, k2, k3, k4, k5);
            const double same = (((fa < 0.0) && (value < 0.0)) || ((fa > 0.0) && (value > 0.0)) ?
                1.0 : 0.0);
            const double next_b = (same > 0.0 ? b : a), next_fb = (same > 0.0 ? fb : fa);
            const double next_c = (same > 0.0 ? a : b);
            fc = (same > 0.0 ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
        }
        if (fabs(fa) < fabs(fb)) { return a; }
        return b;
    }
    return 3.141592653589793;
}

// sin((k + 1) x)
static inline double sin_next(double k, double x) {
    double cosine, sine; next_wave(k, x, &cosine, &sine);
    return sine;
}

// has the sign of the slope of the boundary's alpha
static inline double boundary_slope(double theta, double l, double at_one, double at_minus_one,
    double loss, double together, double apart, double across) {
    const double t = 2.0*l + 2.0, t2 = 0.5*theta, t3 = sin_next(t, t2), t4 = tan(t2);
    const double t5 = (t4*t4), t6 = 4.0*t5, t7 = apart*t5, t8 = -t7 + together;
    const double t9 = at_minus_one*t5, t10 = at_one - t9, t11 = across*loss*t6 + t10*t8;
    const double t12 = cos_next(t, t2), t13 = -2.0*across*t10*t4 + 2.0*loss*t4*t8;
    const double t14 = (across*across), t15 = t14*t6 + (t8*t8), t16 = (loss*loss);
    const double t17 = (t10*t10) + t16*t6, t18 = t15*t17, t19 = t5 + 1.0;
    return -t4*(0.5*t18 + t19*(t15*(-at_minus_one*t10 + 2.0*t16) - t17*(-apart*t8 + 2.0*t14)))*
        (t11*t12 - t13*t3) + (t11*t3 + t12*t13)*
        (t18*(l + 1.5) + t19*(-across*t17*(t7 + together) + loss*t15*(at_one + t9)));
}

// the angle of the largest stiffness for a period and more
static inline double later_angle(double d, double l, double at_one, double at_minus_one,
    double loss, double together, double apart, double across) {
    const double turn_ = 3.141592653589793/(d + 1.0);
    double count = 1.0, found = 0.0;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0) || (found > 0.0)) { break; }
        const double rises = boundary_slope(0.041666666666666664*count*turn_, l, at_one,
            at_minus_one, loss, together, apart, across);
        const double next_count = (rises > 0.0 ? count + 1.0 : count);
        found = (rises > 0.0 ? 0.0 : 1.0); count = next_count;
    }
    if (found > 0.0) {
        const double high = 0.041666666666666664*count*turn_;
        const double low = fmax(0.001*high, 0.041666666666666664*turn_*(count - 1.0));
        const double above = boundary_slope(low, l, at_one, at_minus_one, loss, together, apart,
            across);
        if (above <= 0.0) { return low; }
        const double below = boundary_slope(high, l, at_one, at_minus_one, loss, together, apart,
            across);
        if (below >= 0.0) { return high; }
        double b = low, fb = above, a = high, fa = below, c = high, fc = below;
        for (int count_b = 0; count_b < 120; ++count_b) {
            if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                (fabs(a - b) <= 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b)))) {
                break; }
            const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
            const double value = boundary_slope(new_, l, at_one, at_minus_one, loss, together,
                apart, across);
            const double same = (((fa < 0.0) && (value < 0.0)) || ((fa > 0.0) && (value > 0.0)) ?
                1.0 : 0.0);
            const double next_b = (same > 0.0 ? b : a), next_fb = (same > 0.0 ? fb : fa);
            const double next_c = (same > 0.0 ? a : b);
            fc = (same > 0.0 ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
        }
        if (fabs(fa) < fabs(fb)) { return a; }
        return b;
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static inline double undelayed_angle(double at_one, double at_minus_one, double loss,
    double together, double apart) {
    const double k = end_slope(at_minus_one, loss, together, apart, 0.0), t = 2.0*apart;
    const double t2 = -together, t3 = 2.0*together, t4 = (together*together);
    const double k2 = t3*((apart*apart)*at_one + together*(at_minus_one*(t + t2) + loss*t));
    const double k3 = together*(at_minus_one*t4 + at_one*(t4 + ((-apart - t2)*(-apart - t2))) +
        loss*t3*(-apart + 2.0*together));
    double above, below;
    if (k2 > 0.0) {
        const double discriminant = -4.0*k*k3 + (k2*k2);
        const double root = sqrt(fmax(0.0, discriminant));
        above = k2 + root; below = fmax(0.0, -2.0*k);
    } else {
        const double discriminant = -4.0*k*k3 + (k2*k2);
        if (discriminant < 0.0) {
            above = 2.0*k3; below = 0.0;
        } else {
            const double root = sqrt(fmax(0.0, discriminant));
            above = 2.0*k3; below = -k2 + root;
        }
    }
    return 2.0*atan2(sqrt(above), sqrt(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static inline double max_stiffness_angle(double gamma, double delta, double d, double l,
    double part, double first, double last, double at_one, double at_minus_one, double loss,
    double together, double apart) {
    if (((d <= 1.0) || (sqrt(gamma)*(d + 1.0) <= 3.141592653589793)) && (gamma <= 9.8)) {
        const double across = (part == 0.0 ? first : first - last);
        const double theta = (d == 0.0 ? undelayed_angle(at_one, at_minus_one, loss, together,
            apart) : (d < 1.0 ? early_angle(at_one, at_minus_one, loss, together, apart, last) :
            later_angle(d, l, at_one, at_minus_one, loss, together, apart, across)));
        const double t = sin_next(l, theta), t2 = 0.5*theta, t3 = sin(t2), t4 = cos(t2);
        const double t5 = (t4*t4), t6 = (t3*t3), t7 = 4.0*t5*t6;
        const double t8 = -apart*t6 + t5*together;
        const double t9 = 1.0/((across*across)*t7 + (t8*t8));
        const double t10 = -at_minus_one*t6 + at_one*t5;
        const double t11 = -2.0*across*t10 + 2.0*loss*t8, t12 = across*loss*t7 + t10*t8;
        const double t13 = t9*cos_next(l, theta);
        const double t14 = -t*t12*t9/sin(theta) - 0.5*t11*t13;
        const double stiffness = t*t11*t3*t4*t9 - t12*t13 - 2.0*t14*t6;
        double good;
        if ((delta > 0.0) && (gamma > -stiffness) && (sqrt(gamma)*(d + 1.0) <= 3.141592653589793)) {
            good = 1.0;
        } else {
            const double inside = -4.6566128730773926e-09*gamma + 0.9999999953433871*stiffness;
            const double outside = (part == 0.0 ?
                whole_roots(inside, t14, l, first, last, at_one, at_minus_one, loss, together,
                apart) : fractional_roots(inside, t14, l, first, last, at_one, at_minus_one, loss,
                together, apart));
            good = stable(outside, inside, t14, gamma, delta);
        }
        if (good > 0.0) { return theta; }
        return NAN;
    }
    return NAN;
}

// (x - sin(x))/x^3
static inline double gap(double x) {
    if (fabs(x) < 2.0) {
        const double square = -(x*x);
        double total = 0.0;
        for (int n = 25; n >= 5; n -= 2) {
            const double number = inverse_factorial[n];
            total = number + square*total;
        }
        const double rest = square*total + 9.25185853854297e-18;
        return rest + 0.16666666666666666;
    }
    return (x - sin(x))/(x*x*x);
}

// sin(x)/x
static inline double sinc(double x) {
    if (fabs(x) < 1.0) { return -(x*x)*gap(x) + 1.0; }
    return sin(x)/x;
}

// the damping that the wall needs at the angle 2 psi
static inline double damping_at(double alpha, double beta, double l, double epsilon, double psi) {
    const double early = 0.5*alpha*(2.0*l + 1.0)*sinc(psi*(2.0*l + 1.0))/sinc(psi) - beta*
        cos_next(l, 2.0*psi);
    if (epsilon == 0.0) { return early; }
    const double n = early + epsilon*(0.5*alpha*(2.0*l + 3.0)*sinc(psi*(2.0*l + 3.0))/sinc(psi) -
        beta*cos_next(l + 1.0, 2.0*psi) - early);
    const double root = sqrt(epsilon*(1.0 - epsilon)*
        ((alpha*alpha)*(cos(psi)*cos(psi)) + ((alpha + 2.0*beta)*(alpha + 2.0*beta))*
        (sin(psi)*sin(psi))) + (n*n));
    return 0.5*n + 0.5*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static inline double chord(double k, double x) {
    const double turn_ = x*(k + 1.0), order = 2.0*k + 2.0, along = cos_next(k, x);
    if (turn_ < 1.5) {
        const double wave = sinc(0.5*turn_), inner = 0.5*(wave*wave) - gap(turn_);
        return order*(along*gap(x) + 0.25*inner*(order*order));
    }
    return (-along*order*sin(x) + 2.0*sin_next(k, x))/(x*x*x);
}

// has the sign of the slope of DampingAt, at a fraction
static inline double rising(double alpha, double beta, double l, double epsilon, double psi) {
    const double t = 2.0*psi, t2 = 2.0*alpha/(sinc(psi)*sinc(psi));
    const double t3 = 0.5*alpha + beta, t4 = 2.0*l, t5 = t4 + 2.0, t6 = t4 + 4.0;
    const double early = -t2*chord(l, t) + t3*(t5*t5)*sinc(psi*t5);
    const double steep = early + epsilon*(-early - t2*chord(l + 1.0, t) + t3*(t6*t6)*sinc(psi*t6));
    return 2.0*beta*epsilon*(1.0 - epsilon)*(alpha + beta)*sinc(2.0*psi) + steep*
        damping_at(alpha, beta, l, epsilon, psi);
}

// has the sign of the slope of DampingAt, up to the angle in phase
static inline double steepness(double alpha, double beta, double l, double epsilon, double psi) {
    if (epsilon == 0.0) {
        const double t = 2.0*l + 2.0;
        return -2.0*alpha*chord(l, 2.0*psi)/(sinc(psi)*sinc(psi)) + (t*t)*(0.5*alpha + beta)*
            sinc(psi*t);
    }
    const double rising_ = rising(alpha, beta, l, epsilon, psi);
    const double phase = psi*(2.0*l + 2.0) + atan2(alpha*cos(psi), (alpha + 2.0*beta)*sin(psi)) +
        atan2(epsilon*sin(2.0*psi), epsilon*cos(2.0*psi) - epsilon + 1.0) - 3.141592653589793;
    if (phase > 0.0) { return -fabs(rising_); }
    return rising_;
}

// half of the angle at which the wall needs most damping
static inline double worst_angle(double alpha, double beta, double l, double epsilon) {
    const double size = fabs(alpha) + fabs(beta), whole = (size == 0.0 ? 1.0 : size);
    const double stiffness = alpha/whole, damping = beta/whole, low = 0.0;
    const double above = steepness(stiffness, damping, l, epsilon, low);
    if (above <= 0.0) { return low; }
    const double high = 3.141592653589793/(2.0*l + 2.0);
    const double below = steepness(stiffness, damping, l, epsilon, high);
    if (below >= 0.0) { return high; }
    double b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
            (fabs(a - b) <= 4.656612873077393e-10*fabs((fabs(fa) < fabs(fb) ? a : b)))) { break; }
        const double new_ = next_guess(b, fb, a, fa, c, fc, 4.656612873077393e-10);
        const double value = steepness(stiffness, damping, l, epsilon, new_);
        const double same = (((fa < 0.0) && (value < 0.0)) || ((fa > 0.0) && (value > 0.0)) ? 1.0 :
            0.0);
        const double next_b = (same > 0.0 ? b : a), next_fb = (same > 0.0 ? fb : fa);
        const double next_c = (same > 0.0 ? a : b);
        fc = (same > 0.0 ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    if (fabs(fa) < fabs(fb)) { return a; }
    return b;
}

// the damping that the wall needs at its worst angle
static inline double largest_required_damping(double alpha, double beta, double d) {
    if (alpha < 0.0) { return INFINITY; }
    const double whole = floor(d), part = d - whole;
    const double lift = (fabs(alpha) + fabs(beta) < 3.8725919148493183e-121 ?
        6.668014432879854e+240 : 1.0);
    const double stiffness = alpha*lift, damping = beta*lift;
    const double psi = worst_angle(stiffness, damping, whole, part);
    return damping_at(stiffness, damping, whole, part, psi)/lift;
}

// early + share (late - early)
static inline double between(double share, double early, double late) {
    const double more = -early + late;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static inline double lead(double theta, double l, double epsilon) {
    if (theta*(l + 1.0) < 4.0) {
        const double early = sin_next(l, theta), late = sin_next(l + 1.0, theta);
        return early + epsilon*(-early + late);
    }
    return -1.0;
}

// the value, NaN for number < 0
static inline double rated(double number, double value) {
    if (number < 0.0) { return NAN; }
    return value;
}

// ((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3
static inline double spread(double k, double x) {
    const double turn_ = x*(k + 1.0), order = 2.0*k + 2.0;
    if (turn_ < 1.5) { return order*((order*order)*gap(2.0*turn_) - gap(x)); }
    return (order*sin(x) - 2.0*cos_next(k, x)*sin_next(k, x))/(x*x*x);
}

// what straight motions need at a whole delay of k periods
static inline double straight(double stiffness, double damping, double k, double angle) {
    const double order = 2.0*k + 1.0, wave = sinc(angle*order);
    double total, lost; two_prod(order, wave, &total, &lost);
    const double near = 2.0*sinc(angle);
    double total2, lost2; wide_quot(total, near, lost, 0.0, &total2, &lost2);
    double total3, lost3; wide_prod(stiffness, total2, lost2, &total3, &lost3);
    const double along = cos_next(k, 2.0*angle);
    double total4, lost4; two_prod(damping, along, &total4, &lost4);
    double total5, lost5; two_diff(total3, total4, &total5, &lost5);
    const double low = lost3 - lost4 + lost5;
    return low + total5;
}

// has the sign of minus the slope of what the wall phi needs
static inline double turning(double phi, double l, double epsilon, double wave, double wave2,
    double wave3, double wave4, double wave5, double wave6, double wave7, double wave8,
    double wave9, double wave10, double wave11, double wave12) {
    const double t = sin(phi), t2 = l + 1.0, t3 = cos(phi), t4 = t3/t2, t5 = 0.5*t4;
    const double t6 = t - t5, t7 = epsilon*(1.0 - epsilon), t8 = 2.0*l;
    const double t9 = 2.0*t4/(wave7*wave7);
    const double t10 = t*wave10*((t8 + 2.0)*(t8 + 2.0)) - t9*wave3, t11 = t6*wave5;
    const double t12 = 1.0/wave7, t13 = wave9*(t8 + 1.0), t14 = t12*t5, t15 = t13*t14;
    const double t16 = epsilon*(t11 + t14*wave11*(t8 + 3.0) - t15 - t6*wave6);
    return -2.0*t6*t7*wave8*(t + t5) - (epsilon*
        (t*wave12*((t8 + 4.0)*(t8 + 4.0)) - t10 - t9*wave4) + t10)*
        (-0.5*t11 + 0.25*t12*t13*t4 + 0.5*t16 + 0.5*
        sqrt(t7*(4.0*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2)) +
        ((-t11 + t15 + t16)*(-t11 + t15 + t16))));
}

// the wall whose worst angle is 2 psi, as an angle
static inline double turn(double psi, double l, double epsilon) {
    const double wave = sin(psi), wave2 = cos(psi), wave3 = chord(l, 2.0*psi);
    const double wave4 = chord(l + 1.0, 2.0*psi), wave5 = cos_next(l, 2.0*psi);
    const double wave6 = cos_next(l + 1.0, 2.0*psi), wave7 = sinc(psi);
    const double wave8 = sinc(2.0*psi), wave9 = sinc(psi*(2.0*l + 1.0));
    const double wave10 = sinc(psi*(2.0*l + 2.0)), wave11 = sinc(psi*(2.0*l + 3.0));
    const double wave12 = sinc(psi*(2.0*l + 4.0)), low = 0.0;
    const double above = turning(low, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7,
        wave8, wave9, wave10, wave11, wave12);
    if (above <= 0.0) { return low; }
    const double high = 0.5*3.141592653589793;
    const double below = turning(high, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7,
        wave8, wave9, wave10, wave11, wave12);
    if (below >= 0.0) { return high; }
    double b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
            (fabs(a - b) <= 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b)))) { break; }
        const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
        const double value = turning(new_, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6,
            wave7, wave8, wave9, wave10, wave11, wave12);
        const double same = (((fa < 0.0) && (value < 0.0)) || ((fa > 0.0) && (value > 0.0)) ? 1.0 :
            0.0);
        const double next_b = (same > 0.0 ? b : a), next_fb = (same > 0.0 ? fb : fa);
        const double next_c = (same > 0.0 ? a : b);
        fc = (same > 0.0 ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    if (fabs(fa) < fabs(fb)) { return a; }
    return b;
}

// the wall whose worst angle is theta, as an angle, or NaN
static inline double touching(double theta, double l, double epsilon) {
    const double found = turn(0.5*theta, l, epsilon);
    if (found < 0.5*3.141592653589793) { return found; }
    return NAN;
}

// whether another angle allows more stiffness, at a fraction
static inline double passive_slope(double psi, double l, double epsilon) {
    const double turned = turn(psi, l, epsilon), wall = cos(turned)/(l + 1.0);
    const double wall2 = sin(turned) - 0.5*cos(turned)/(l + 1.0);
    const double need = damping_at(wall, wall2, l, epsilon, psi);
    return -epsilon*(1.0 - epsilon)*(wall + 2.0*wall2)*(sin(psi)*sin(psi)) + need*
        (epsilon*(-cos_next(l, 2.0*psi) + cos_next(l + 1.0, 2.0*psi)) + cos_next(l, 2.0*psi));
}

// the worst angle of the stiffest passive wall, at a fraction
static inline double passive_angle(double l, double epsilon) {
    const double low = 1e-06*3.141592653589793/(2.0*epsilon + 2.0*l + 2.0);
    const double above = passive_slope(low, l, epsilon);
    if (above <= 0.0) { return 2.0*low; }
    const double high = 3.141592653589793/(2.0*epsilon + 2.0*l + 2.0);
    const double below = passive_slope(high, l, epsilon);
    if (below >= 0.0) { return 2.0*high; }
    double b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
            (fabs(a - b) <= 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b)))) { break; }
        const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
        const double value = passive_slope(new_, l, epsilon);
        const double same = (((fa < 0.0) && (value < 0.0)) || ((fa > 0.0) && (value > 0.0)) ? 1.0 :
            0.0);
        const double next_b = (same > 0.0 ? b : a), next_fb = (same > 0.0 ? fb : fa);
        const double next_c = (same > 0.0 ? a : b);
        fc = (same > 0.0 ? fa : fb); c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    if (fabs(fa) < fabs(fb)) { return 2.0*a; }
    return 2.0*b;
}

void haptic_discretize(double gamma, double delta, double *n1_out, double *n0_out, double *a_out,
    double *e_out) {
    if (!((delta <= 1e+70) && (delta >= 0.0) && (gamma <= 1e+70) && (gamma >= 0.0))) {
        *n1_out = NAN; *n0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    double n0, n1, trace; device_n0_n1_trace(gamma, delta, &n0, &n1, &trace);
    *n1_out = n1; *n0_out = n0; *a_out = trace; *e_out = exp(-delta); return;
}

void haptic_discretize_fractional(double gamma, double delta, double epsilon, double *m2_out,
    double *m1_out, double *m0_out, double *a_out, double *e_out) {
    if (!((delta <= 1e+70) && (delta >= 0.0) && (epsilon < 1.0) && (epsilon >= 0.0) &&
        (gamma <= 1e+70) && (gamma >= 0.0))) {
        *m2_out = NAN; *m1_out = NAN; *m0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    double together, trace; device_together_trace(gamma, delta, &together, &trace);
    const double t0 = 1.0 - epsilon, t1 = (t0*t0), t2 = delta*t0;
    const double n1 = plant_n1(gamma*t1, t2), t3 = n1*t1, t4 = (epsilon*epsilon);
    const double n0 = plant_n0(gamma*t4, delta*epsilon), t5 = n0*t4*exp(-t2);
    *m2_out = t3; *m1_out = together - t3 - t5; *m0_out = t5; *a_out = trace;
    *e_out = exp(-delta); return;
}

bool haptic_is_stable(double alpha, double beta, double gamma, double delta, double d) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70) && (gamma <= 1e+70) && (gamma >= 0.0))) {
        return false;
    }
    double at_minus_one, together, n_gap, n0, n1;
    device_at_minus_one_together_n_gap_n0_n1(gamma, delta, &at_minus_one, &together, &n_gap, &n0,
        &n1);
    const double whole = floor(d), part = d - whole, t1 = gamma*together;
    const double t3 = delta*decay(delta);
    if (part == 0.0) {
        return stable(whole_roots(alpha, beta, d, n1, n0, t1, at_minus_one, t3, together, delta*
            n_gap), alpha, beta, gamma, delta) != 0.0;
    }
    double apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    return stable(fractional_roots(alpha, beta, whole, m2, m0, t1, at_minus_one, t3, together,
        apart), alpha, beta, gamma, delta) != 0.0;
}

double haptic_unstable_roots(double alpha, double beta, double gamma, double delta, double d) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70) && (gamma <= 1e+70) && (gamma >= 0.0))) {
        return -1.0;
    }
    double at_minus_one, together, n_gap, n0, n1;
    device_at_minus_one_together_n_gap_n0_n1(gamma, delta, &at_minus_one, &together, &n_gap, &n0,
        &n1);
    const double whole = floor(d), part = d - whole, t1 = gamma*together;
    const double t3 = delta*decay(delta);
    if (part == 0.0) {
        return whole_roots(alpha, beta, d, n1, n0, t1, at_minus_one, t3, together, delta*n_gap);
    }
    double apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    return fractional_roots(alpha, beta, whole, m2, m0, t1, at_minus_one, t3, together, apart);
}

void haptic_stability_boundary(double theta, double gamma, double delta, double d,
    double *alpha_out, double *beta_out) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) && (gamma <= 1e+70) &&
        (gamma >= 0.0) && (theta <= 3.141592653589793) && (theta > 0.0))) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    double at_minus_one, together, n_gap;
    device_at_minus_one_together_n_gap(gamma, delta, &at_minus_one, &together, &n_gap);
    const double whole = floor(d), part = d - whole, t1 = 0.5*theta;
    const double t3 = gamma*together, t5 = delta*decay(delta), t11 = tan(t1);
    const double t13 = sin(theta);
    if (part == 0.0) {
        double cosine, sine; next_wave(d, theta, &cosine, &sine);
        const double t6 = delta*n_gap, t7 = together + t6;
        double ahead_of, in_phase_of;
        ahead_in_phase(t1, t3, at_minus_one, t5, together, t6, t7, &ahead_of, &in_phase_of);
        const double t12 = ahead_of*cosine + in_phase_of*sine;
        *alpha_out = ahead_of*sine - cosine*in_phase_of + t11*t12; *beta_out = -t12/t13;
        return;
    }
    double cosine_2, sine_2; next_wave(whole, theta, &cosine_2, &sine_2);
    double apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    const double t18 = 2.0*m2 - 2.0*m0;
    double ahead_of2, in_phase_of2;
    ahead_in_phase(t1, t3, at_minus_one, t5, together, apart, t18, &ahead_of2, &in_phase_of2);
    const double t22 = ahead_of2*cosine_2 + in_phase_of2*sine_2;
    *alpha_out = ahead_of2*sine_2 - cosine_2*in_phase_of2 + t11*t22;
    *beta_out = -t22/t13; return;
}

void haptic_max_stable_stiffness(double gamma, double delta, double d, double *alpha_out,
    double *beta_out, double *theta_out) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) && (gamma <= 1e+70) &&
        (gamma >= 0.0))) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    double at_minus_one, together, n_gap, n0, n1;
    device_at_minus_one_together_n_gap_n0_n1(gamma, delta, &at_minus_one, &together, &n_gap, &n0,
        &n1);
    const double whole = floor(d), part = d - whole, t1 = gamma*together;
    const double t3 = delta*decay(delta), t16 = 2.0*t3;
    if (part == 0.0) {
        const double t4 = delta*n_gap;
        const double t5 = max_stiffness_angle(gamma, delta, d, d, 0.0, n1, n0, t1, at_minus_one,
            t3, together, t4);
        double cosine, sine; next_wave(d, t5, &cosine, &sine);
        const double t7 = 0.5*t5, t8 = sin(t7), t9 = cos(t7), t10 = together + t4;
        const double t11 = (t9*t9), t12 = (t8*t8), t13 = t11*t12;
        const double t14 = together*t11 - t12*t4, t15 = 1.0/((t10*t10)*t13 + (t14*t14));
        const double t17 = -at_minus_one*t12 + t1*t11, t18 = -t10*t17 + t14*t16;
        const double t19 = t10*t13*t16 + t14*t17, t20 = cosine*t15;
        const double t21 = -sine*t15*t19/sin(t5) - 0.5*t18*t20;
        *alpha_out = sine*t15*t18*t8*t9 - 2.0*t12*t21 - t19*t20; *beta_out = t21;
        *theta_out = t5; return;
    }
    double apart, m2, m0; late_device(gamma, delta, part, &apart, &m2, &m0);
    const double t27 = max_stiffness_angle(gamma, delta, d, whole, part, m2, m0, t1, at_minus_one,
        t3, together, apart);
    double cosine_2, sine_2; next_wave(whole, t27, &cosine_2, &sine_2);
    const double t28 = 0.5*t27, t29 = sin(t28), t30 = cos(t28), t32 = (t30*t30);
    const double t33 = (t29*t29), t34 = -apart*t33 + together*t32;
    const double t35 = 2.0*m2 - 2.0*m0, t36 = t32*t33;
    const double t37 = 1.0/((t34*t34) + (t35*t35)*t36);
    const double t38 = -at_minus_one*t33 + t1*t32, t39 = t16*t34 - t35*t38;
    const double t40 = t16*t35*t36 + t34*t38, t41 = cosine_2*t37;
    const double t42 = -sine_2*t37*t40/sin(t27) - 0.5*t39*t41;
    *alpha_out = sine_2*t29*t30*t37*t39 - 2.0*t33*t42 - t40*t41; *beta_out = t42;
    *theta_out = t27; return;
}

double haptic_passivity_margin_at(double theta, double alpha, double beta, double delta, double d) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70) && (theta <= 3.141592653589793) &&
        (theta > 0.0))) {
        return NAN;
    }
    const double t0 = 0.5*theta, cosine = cos_next(d, theta);
    const double sine = sin_next(2.0*d, t0);
    return -0.5*alpha*sine/sin(t0) + beta*cosine + delta;
}

double haptic_passivity_margin(double alpha, double beta, double delta, double d) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70))) {
        return NAN;
    }
    return delta - largest_required_damping(alpha, beta, d);
}

void haptic_passivity_boundary(double theta, double delta, double d, double *alpha_out,
    double *beta_out) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (theta <= 3.141592653589793) && (theta > 0.0))) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const double whole = floor(d), part = d - whole, t2 = 0.5*theta;
    if (part == 0.0) {
        const double t0 = lead(theta, d, 0.0), t1 = delta/spread(d, theta);
        const double t15 = sinc(t2), sine = sin_next(d, theta);
        const double t3 = sine*(t15*t15)*(d + 1.0)/theta;
        *alpha_out = rated(t0, 2.0*t1*t3);
        *beta_out = rated(t0, t1*(-t3 + chord(d, theta))); return;
    }
    const double t6 = lead(theta, whole, part), t7 = whole + 1.0;
    const double t8 = touching(theta, whole, part), t9 = cos(t8), t10 = t9/t7;
    const double t11 = sin(t8), t12 = -0.5*t10 + t11;
    const double t13 = between(part, straight(t10, t12, whole, t2), straight(t10, t12, t7, t2));
    const double t16 = sin(t2), t17 = cos(t2);
    const double t14 = delta/(0.5*t13 + 0.5*
        sqrt(part*(1.0 - part)*(4.0*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7)) + (t13*t13)));
    *alpha_out = rated(t6, t10*t14); *beta_out = rated(t6, t12*t14); return;
}

void haptic_max_passive_stiffness(double delta, double d, double *alpha_out, double *beta_out,
    double *theta_out) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0))) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const double whole = floor(d), part = d - whole;
    if (part == 0.0) {
        const double t0 = 3.141592653589793/(d + 1.0), t1 = tan(0.25*t0), t2 = 0.5*t0;
        *alpha_out = 2.0*delta*t1;
        *beta_out = delta*(-t1 + 2.0/(3.141592653589793*sinc(t2))); *theta_out = t2;
        return;
    }
    const double t4 = whole + 1.0, t6 = passive_angle(whole, part);
    const double t7 = touching(t6, whole, part), t8 = cos(t7), t9 = t8/t4;
    const double t10 = sin(t7), t11 = t10 - 0.5*t9, t12 = 0.5*t6;
    const double t13 = between(part, straight(t9, t11, whole, t12), straight(t9, t11, t4, t12));
    const double t15 = sin(t12), t16 = cos(t12);
    const double t14 = delta/(0.5*t13 + 0.5*
        sqrt(part*(1.0 - part)*(4.0*(t10*t10)*(t15*t15) + (t16*t16)*(t8*t8)/(t4*t4)) + (t13*t13)));
    *alpha_out = t14*t9; *beta_out = t11*t14; *theta_out = t6; return;
}

double haptic_linear_limit(double beta, double delta, double d) {
    if (!((d <= 1e+15) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(beta) <= 1e+70))) {
        return NAN;
    }
    return (beta + delta)/(d + 0.5);
}
