/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#include "haptic_single.h"

#include <math.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static float cos_series(float w) {
    const float square = (w*w);
    const float b5 = 1.1470745e-11f;
    const float b4 = 2.0876756e-09f;
    const float b3 = b5*square + 2.755732e-07f;
    const float b2 = b4*square + 2.4801588e-05f;
    const float b1 = b3*square + 0.0013888889f;
    const float b0 = b2*square + 0.041666668f;
    return b0 + b1*w;
}

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static float decay_series(float x) {
    const float square = (x*x);
    const float b9 = 2.0876756e-09f;
    const float b8 = 2.5052108e-08f;
    const float b7 = b9*square + 2.755732e-07f;
    const float b6 = b8*square + 2.7557319e-06f;
    const float b5 = b7*square + 2.4801588e-05f;
    const float b4 = b6*square + 0.0001984127f;
    const float b3 = b5*square + 0.0013888889f;
    const float b2 = b4*square + 0.008333334f;
    const float b1 = b3*square + 0.041666668f;
    const float b0 = b2*square + 0.16666667f;
    return b0 - b1*x;
}

// divided difference of exp at 0, p and q, less 1/2
static float fall_series(float gamma, float delta) {
    if ((delta < 0.125f) && (fabsf(gamma) < 0.00390625f)) {
        const float b7 = 2.7557319e-06f;
        const float b6 = b7*delta + 2.4801588e-05f;
        const float b5 = b6*delta - b7*gamma + 0.0001984127f;
        const float b4 = b5*delta - b6*gamma + 0.0013888889f;
        const float total = b4*delta;
        const float lost = fmaf(delta, b4, -(delta*b4));
        const float total2 = b5*gamma;
        const float lost2 = fmaf(gamma, b5, -(gamma*b5));
        const float total3 = total - total2;
        const float back = -total + total3;
        const float rest = -back + total3;
        const float one = -rest + total;
        const float two = -back - total2;
        const float lost3 = one + two;
        const float total4 = total3 + 0.008333334f;
        const float back2 = -total3 + total4;
        const float rest2 = -back2 + total4;
        const float one2 = -rest2 + total3;
        const float two2 = 0.008333334f - back2;
        const float lost4 = one2 + two2;
        const float low = lost - lost2 + lost3 + lost4;
        const float total5 = delta*total4;
        const float lost5 = delta*low + fmaf(delta, total4, -(delta*total4));
        const float total6 = b4*gamma;
        const float lost6 = fmaf(gamma, b4, -(gamma*b4));
        const float total7 = total5 - total6;
        const float back3 = -total5 + total7;
        const float rest3 = -back3 + total7;
        const float one3 = -rest3 + total5;
        const float two3 = -back3 - total6;
        const float lost7 = one3 + two3;
        const float total8 = total7 + 0.041666668f;
        const float back4 = -total7 + total8;
        const float rest4 = -back4 + total8;
        const float one4 = -rest4 + total7;
        const float two4 = 0.041666668f - back4;
        const float lost8 = one4 + two4;
        const float low2 = lost5 - lost6 + lost7 + lost8;
        const float total9 = delta*total8;
        const float lost9 = delta*low2 + fmaf(delta, total8, -(delta*total8));
        const float total10 = gamma*total4;
        const float lost10 = gamma*low + fmaf(gamma, total4, -(gamma*total4));
        const float total11 = -total10 + total9;
        const float back5 = total11 - total9;
        const float rest5 = -back5 + total11;
        const float one5 = -rest5 + total9;
        const float two5 = -back5 - total10;
        const float lost11 = one5 + two5;
        const float total12 = total11 + 0.16666667f;
        const float back6 = -total11 + total12;
        const float rest6 = -back6 + total12;
        const float one6 = -rest6 + total11;
        const float two6 = 0.16666667f - back6;
        const float lost12 = one6 + two6;
        const float low3 = -lost10 + lost11 + lost12 + lost9;
        const float total13 = delta*total12;
        const float lost13 = delta*low3 + fmaf(delta, total12, -(delta*total12));
        const float total14 = gamma*total8;
        const float lost14 = gamma*low2 + fmaf(gamma, total8, -(gamma*total8));
        const float total15 = total13 - total14;
        const float back7 = -total13 + total15;
        const float rest7 = -back7 + total15;
        const float one7 = -rest7 + total13;
        const float two7 = -back7 - total14;
        const float lost15 = one7 + two7;
        const float total16 = total15;
        const float back8 = -total15 + total16;
        const float rest8 = -back8 + total16;
        const float one8 = -rest8 + total15;
        const float two8 = -back8;
        const float lost16 = one8 + two8;
        const float low4 = lost13 - lost14 + lost15 + lost16;
        return low4 + total16;
    }
    const float b18 = 4.1103176e-19f;
    const float b17 = b18*delta + 8.220635e-18f;
    const float b16 = b17*delta - b18*gamma + 1.5619207e-16f;
    const float b15 = b16*delta - b17*gamma + 2.8114574e-15f;
    const float b14 = b15*delta - b16*gamma + 4.7794773e-14f;
    const float b13 = b14*delta - b15*gamma + 7.6471636e-13f;
    const float b12 = b13*delta - b14*gamma + 1.1470745e-11f;
    const float b11 = b12*delta - b13*gamma + 1.6059044e-10f;
    const float b10 = b11*delta - b12*gamma + 2.0876756e-09f;
    const float b9 = b10*delta - b11*gamma + 2.5052108e-08f;
    const float b8 = -b10*gamma + b9*delta + 2.755732e-07f;
    const float b72 = b8*delta - b9*gamma + 2.7557319e-06f;
    const float b62 = b72*delta - b8*gamma + 2.4801588e-05f;
    const float b52 = b62*delta - b72*gamma + 0.0001984127f;
    const float b42 = b52*delta - b62*gamma + 0.0013888889f;
    const float total17 = b42*delta;
    const float lost17 = fmaf(delta, b42, -(delta*b42));
    const float total18 = b52*gamma;
    const float lost18 = fmaf(gamma, b52, -(gamma*b52));
    const float total19 = total17 - total18;
    const float back9 = -total17 + total19;
    const float rest9 = -back9 + total19;
    const float one9 = -rest9 + total17;
    const float two9 = -back9 - total18;
    const float lost19 = one9 + two9;
    const float total20 = total19 + 0.008333334f;
    const float back10 = -total19 + total20;
    const float rest10 = -back10 + total20;
    const float one10 = -rest10 + total19;
    const float two10 = 0.008333334f - back10;
    const float lost20 = one10 + two10;
    const float low5 = lost17 - lost18 + lost19 + lost20;
    const float total21 = delta*total20;
    const float lost21 = delta*low5 + fmaf(delta, total20, -(delta*total20));
    const float total22 = b42*gamma;
    const float lost22 = fmaf(gamma, b42, -(gamma*b42));
    const float total23 = total21 - total22;
    const float back11 = -total21 + total23;
    const float rest11 = -back11 + total23;
    const float one11 = -rest11 + total21;
    const float two11 = -back11 - total22;
    const float lost23 = one11 + two11;
    const float total24 = total23 + 0.041666668f;
    const float back12 = -total23 + total24;
    const float rest12 = -back12 + total24;
    const float one12 = -rest12 + total23;
    const float two12 = 0.041666668f - back12;
    const float lost24 = one12 + two12;
    const float low6 = lost21 - lost22 + lost23 + lost24;
    const float total25 = delta*total24;
    const float lost25 = delta*low6 + fmaf(delta, total24, -(delta*total24));
    const float total26 = gamma*total20;
    const float lost26 = gamma*low5 + fmaf(gamma, total20, -(gamma*total20));
    const float total27 = total25 - total26;
    const float back13 = -total25 + total27;
    const float rest13 = -back13 + total27;
    const float one13 = -rest13 + total25;
    const float two13 = -back13 - total26;
    const float lost27 = one13 + two13;
    const float total28 = total27 + 0.16666667f;
    const float back14 = -total27 + total28;
    const float rest14 = -back14 + total28;
    const float one14 = -rest14 + total27;
    const float two14 = 0.16666667f - back14;
    const float lost28 = one14 + two14;
    const float low7 = lost25 - lost26 + lost27 + lost28;
    const float total29 = delta*total28;
    const float lost29 = delta*low7 + fmaf(delta, total28, -(delta*total28));
    const float total30 = gamma*total24;
    const float lost30 = gamma*low6 + fmaf(gamma, total24, -(gamma*total24));
    const float total31 = total29 - total30;
    const float back15 = -total29 + total31;
    const float rest15 = -back15 + total31;
    const float one15 = -rest15 + total29;
    const float two15 = -back15 - total30;
    const float lost31 = one15 + two15;
    const float total32 = total31;
    const float back16 = -total31 + total32;
    const float rest16 = -back16 + total32;
    const float one16 = -rest16 + total31;
    const float two16 = -back16;
    const float lost32 = one16 + two16;
    const float low8 = lost29 - lost30 + lost31 + lost32;
    return low8 + total32;
}

// divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2
static float rise_series(float h, float w) {
    if ((fabsf(w) < 0.00390625f) && (h < 0.0625f)) {
        const float e7 = 2.7557319e-06f;
        const float b7 = e7;
        const float e6 = 2.4801588e-05f;
        const float b6 = b7*h + e6;
        const float e5 = e7*w + 0.0001984127f;
        const float b5 = b6*h + e5;
        const float e4 = e6*w + 0.0013888889f;
        const float b4 = b5*h + e4;
        const float e3 = e5*w + 0.008333334f;
        const float b3 = b4*h + e3;
        const float e2 = e4*w + 0.041666668f;
        const float b2 = b3*h + e2;
        const float e1 = e3*w + 0.16666667f;
        const float b1 = b2*h + e1;
        const float e0 = e2*w;
        const float b0 = b1*h + e0;
        return b0;
    }
    const float e18 = 4.1103176e-19f;
    const float b18 = e18;
    const float e17 = 8.220635e-18f;
    const float b17 = b18*h + e17;
    const float e16 = e18*w + 1.5619207e-16f;
    const float b16 = b17*h + e16;
    const float e15 = e17*w + 2.8114574e-15f;
    const float b15 = b16*h + e15;
    const float e14 = e16*w + 4.7794773e-14f;
    const float b14 = b15*h + e14;
    const float e13 = e15*w + 7.6471636e-13f;
    const float b13 = b14*h + e13;
    const float e12 = e14*w + 1.1470745e-11f;
    const float b12 = b13*h + e12;
    const float e11 = e13*w + 1.6059044e-10f;
    const float b11 = b12*h + e11;
    const float e10 = e12*w + 2.0876756e-09f;
    const float b10 = b11*h + e10;
    const float e9 = e11*w + 2.5052108e-08f;
    const float b9 = b10*h + e9;
    const float e8 = e10*w + 2.755732e-07f;
    const float b8 = b9*h + e8;
    const float e72 = e9*w + 2.7557319e-06f;
    const float b72 = b8*h + e72;
    const float e62 = e8*w + 2.4801588e-05f;
    const float b62 = b72*h + e62;
    const float e52 = e72*w + 0.0001984127f;
    const float b52 = b62*h + e52;
    const float e42 = e62*w + 0.0013888889f;
    const float b42 = b52*h + e42;
    const float e32 = e52*w + 0.008333334f;
    const float b32 = b42*h + e32;
    const float e22 = e42*w + 0.041666668f;
    const float b22 = b32*h + e22;
    const float e19 = e32*w + 0.16666667f;
    const float b19 = b22*h + e19;
    const float e02 = e22*w;
    const float b02 = b19*h + e02;
    return b02;
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static float sin_series(float w) {
    const float square = (w*w);
    const float b5 = 1.6059044e-10f;
    const float b4 = 2.5052108e-08f;
    const float b3 = b5*square + 2.7557319e-06f;
    const float b2 = b4*square + 0.0001984127f;
    const float b1 = b3*square + 0.008333334f;
    const float b0 = b2*square + 0.16666667f;
    return b0 + b1*w;
}

// n0, the same device with its time reversed, times exp(-delta); n1, how far a unit force moves the
// device in a period; a, the sum of the sampled device's poles
static void fall_rise_swing(float gamma, float delta, float *fall_out, float *rise_out,
    float *swing_out) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    float fall_of;
    float rise_of;
    float swing_of;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 0.5625f) {
            const float square2 = total2;
            const float envelope = expf(-half);
            const float given5 = 0.5f*half;
            const float total54 = 1.0f - 0.5f*given5;
            const float back32 = total54 - 1.0f;
            const float lost54 = -back32 - 0.5f*given5;
            const float decay_series_of4 = decay_series(given5);
            const float curved5 = decay_series_of4*(given5*given5);
            const float total55 = curved5 + total54;
            const float back33 = -total54 + total55;
            const float lost55 = -back33 + curved5;
            const float mean_low6 = lost54 + lost55;
            const float total56 = given5*total55;
            const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
            const float total57 = 1.0f - total56;
            const float back34 = total57 - 1.0f;
            const float lost57 = -back34 - total56;
            const float fall_low6 = -lost56 + lost57;
            const float total58 = (total57*total57);
            const float lost58 = 2.0f*fall_low6*total57 +
                fmaf(total57, total57, -(total57*total57));
            const float total59 = (total58*total58);
            const float lost59 = 2.0f*lost58*total58 + fmaf(total58, total58, -(total58*total58));
            const float rest15 = fall_series(gamma, delta);
            const float total60 = rest15 + 0.5f;
            const float back35 = -rest15 + total60;
            const float rest16 = -back35 + total60;
            const float one14 = rest15 - rest16;
            const float two14 = 0.5f - back35;
            const float lost60 = one14 + two14;
            const float total61 = total59*total60;
            const float lost61 = lost60*total59 + fmaf(total59, total60, -(total59*total60));
            const float half2 = half;
            const float given52 = 0.5f*half2;
            const float total532 = 1.0f - 0.5f*given52;
            const float back312 = total532 - 1.0f;
            const float lost532 = -back312 - 0.5f*given52;
            const float decay_series_of5 = decay_series(given52);
            const float curved52 = decay_series_of5*(given52*given52);
            const float total542 = curved52 + total532;
            const float back322 = -total532 + total542;
            const float lost542 = -back322 + curved52;
            const float mean_low62 = lost532 + lost542;
            const float total552 = given52*total542;
            const float lost552 = given52*mean_low62 + fmaf(given52, total542, -(given52*total542));
            const float total562 = 1.0f - total552;
            const float back332 = total562 - 1.0f;
            const float lost562 = -back332 - total552;
            const float fall_low62 = -lost552 + lost562;
            const float total572 = (total562*total562);
            const float lost572 = 2.0f*fall_low62*total562 +
                fmaf(total562, total562, -(total562*total562));
            const float rest132 = rise_series(half2, total2);
            const float total582 = rest132 + 0.5f;
            const float back342 = -rest132 + total582;
            const float rest142 = -back342 + total582;
            const float one122 = rest132 - rest142;
            const float two122 = 0.5f - back342;
            const float lost582 = one122 + two122;
            const float total592 = total572*total582;
            const float lost592 = lost582*total572 + fmaf(total572, total582, -(total572*total582));
            float even;
            float even_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total20 = 0.5f*given3 + 1.0f;
                const float back13 = total20 - 1.0f;
                const float lost20 = -back13 + 0.5f*given3;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total21 = curved3 + total20;
                const float back14 = -total20 + total21;
                const float lost21 = -back14 + curved3;
                const float even_low = 0.5f*lost2 + lost20 + lost21;
                even = total21;
                even_low2 = even_low;
            } else {
                const float size = fabsf(total2);
                const float root = sqrtf(size);
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const float total212 = envelope*even;
            const float lost212 = envelope*even_low2 + fmaf(envelope, even, -(envelope*even));
            fall_of = lost59*total60 + lost61 + total61;
            rise_of = lost572*total582 + lost592 + total592;
            swing_of = 2.0f*lost212 + 2.0f*total212;
        } else {
            const float size = fabsf(total2);
            const float root = sqrtf(size);
            const float square2 = total2;
            const float envelope = expf(-half);
            const float stiff = gamma;
            float even;
            float even_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total20 = 0.5f*given3 + 1.0f;
                const float back13 = total20 - 1.0f;
                const float lost20 = -back13 + 0.5f*given3;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total21 = curved3 + total20;
                const float back14 = -total20 + total21;
                const float lost21 = -back14 + curved3;
                const float even_low = 0.5f*lost2 + lost20 + lost21;
                even = total21;
                even_low2 = even_low;
            } else {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const float total212 = envelope*even;
            const float lost212 = envelope*even_low2 + fmaf(envelope, even, -(envelope*even));
            float count;
            if (root < 4096.0f) {
                count = floorf(0.5f*root/3.1415927f + 0.5f);
            } else {
                count = 0.0f;
            }
            const float turns = (count*count);
            const float total29 = 39.478416f*turns;
            const float lost29 = fmaf(turns, 39.478416f, -(turns*39.478416f));
            const float total30 = 1.1614864e-06f*turns;
            const float lost30 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
            const float total31 = -total2 - total29;
            const float back18 = total2 + total31;
            const float rest6 = -back18 + total31;
            const float one5 = -rest6 - total2;
            const float two5 = -back18 - total29;
            const float lost31 = one5 + two5;
            const float total32 = -lost29 + total31;
            const float back19 = -total31 + total32;
            const float rest7 = -back19 + total32;
            const float one6 = -rest7 + total31;
            const float two6 = -back19 - lost29;
            const float lost32 = one6 + two6;
            const float total33 = -total30 + total32;
            const float back20 = -total32 + total33;
            const float rest8 = -back20 + total33;
            const float one7 = -rest8 + total32;
            const float two7 = -back20 - total30;
            const float lost33 = one7 + two7;
            const float total34 = -lost2 + total33;
            const float back21 = -total33 + total34;
            const float rest9 = -back21 + total34;
            const float one8 = -rest9 + total33;
            const float two8 = -back21 - lost2;
            const float lost34 = one8 + two8;
            const float low = -lost30 + lost31 + lost32 + lost33 + lost34 + 1.1704737e-14f*turns;
            const float total35 = low + total34;
            const float total36 = 6.2831855f*count;
            const float total37 = root + total36;
            const float whole3 = (total37 == 0.0f ? 1.0f : total37);
            const float total38 = total35/whole3;
            const float far = (total38*total38);
            if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back22 = -total34 + total35;
                const float rest10 = -back22 + total35;
                const float one9 = -rest10 + total34;
                const float two9 = -back22 + low;
                const float lost35 = one9 + two9;
                const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                const float back23 = -root + total37;
                const float rest11 = -back23 + total37;
                const float one10 = -rest11 + root;
                const float two10 = -back23 + total36;
                const float lost37 = one10 + two10;
                const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                const float left19 = total35 - total38*whole3;
                const float left20 = left19 - fmaf(total38, whole3, -(total38*whole3));
                const float left21 = -both_low*total38 + left20 + lost35;
                const float lost38 = left21/whole3;
                const float eta = total38;
                const float eta_low = lost38;
                const float total39 = (eta*eta);
                const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                const float cos_series_of2 = cos_series(-total39);
                const float bent2 = cos_series_of2*(total39*total39);
                const float total40 = -bent2 + 0.5f*total39;
                const float back24 = -0.5f*total39 + total40;
                const float lost40 = -back24 - bent2;
                const float sin_series_of2 = sin_series(-total39);
                const float total41 = -sin_series_of2*total39 + 1.0f;
                const float back25 = total41 - 1.0f;
                const float lost41 = -back25 - sin_series_of2*total39;
                const float lift_low = 0.5f*lost39*total41 + lost40;
                const float total42 = eta*total41;
                const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                const float some2 = root;
                const float total43 = total42/some2;
                const float left22 = -some2*total43 + total42;
                const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*total43;
                const float lost43 = left24/some2;
                const float given4 = half;
                const float total44 = 1.0f - 0.5f*given4;
                const float back26 = total44 - 1.0f;
                const float lost44 = -back26 - 0.5f*given4;
                const float decay_series_of3 = decay_series(given4);
                const float curved4 = decay_series_of3*(given4*given4);
                const float total45 = curved4 + total44;
                const float back27 = -total44 + total45;
                const float lost45 = -back27 + curved4;
                const float mean_low5 = lost44 + lost45;
                const float total46 = given4*total45;
                const float lost46 = given4*mean_low5 + fmaf(given4, total45, -(given4*total45));
                const float total47 = 1.0f - total46;
                const float back28 = total47 - 1.0f;
                const float lost47 = -back28 - total46;
                const float fall_low5 = -lost46 + lost47;
                const float total48 = -total43 + total45;
                const float back29 = -total45 + total48;
                const float rest12 = -back29 + total48;
                const float one11 = -rest12 + total45;
                const float two11 = -back29 - total43;
                const float lost48 = one11 + two11;
                const float total49 = given4*total48;
                const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                    fmaf(given4, total48, -(given4*total48));
                const float total50 = total40 - total49;
                const float back30 = -total40 + total50;
                const float rest13 = -back30 + total50;
                const float one12 = -rest13 + total40;
                const float two12 = -back30 - total49;
                const float lost50 = one12 + two12;
                const float low2 = lift_low - lost49 + lost50;
                const float total51 = low2 + total50;
                const float back31 = -total50 + total51;
                const float rest14 = -back31 + total51;
                const float one13 = -rest14 + total50;
                const float two13 = -back31 + low2;
                const float lost51 = one13 + two13;
                const float total52 = total47*total51;
                const float lost52 = lost51*total47 + fmaf(total47, total51, -(total47*total51));
                const float low3 = fall_low5*total51 + lost52;
                const float total53 = total52/stiff;
                const float left25 = -stiff*total53 + total52;
                const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                const float left27 = left26 + low3;
                const float lost53 = left27/stiff;
                const float total472 = total43*total47;
                const float lost472 = lost43*total47 + fmaf(total47, total43, -(total47*total43));
                const float total482 = total45 - total472;
                const float back292 = -total45 + total482;
                const float rest112 = -back292 + total482;
                const float one102 = -rest112 + total45;
                const float two102 = -back292 - total472;
                const float lost482 = one102 + two102;
                const float low22 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                const float total492 = given4*total482;
                const float lost492 = given4*low22 + fmaf(given4, total482, -(given4*total482));
                const float total502 = total40*total47;
                const float lost502 = lift_low*total47 + fmaf(total47, total40, -(total47*total40));
                const float total512 = total492 + total502;
                const float back302 = -total492 + total512;
                const float rest122 = -back302 + total512;
                const float one112 = -rest122 + total492;
                const float two112 = -back302 + total502;
                const float lost512 = one112 + two112;
                const float low32 = fall_low5*total40 + lost492 + lost502 + lost512;
                const float total522 = total512/stiff;
                const float left252 = -stiff*total522 + total512;
                const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                const float left272 = left262 + low32;
                const float lost522 = left272/stiff;
                fall_of = lost53 + total53;
                rise_of = lost522 + total522;
                swing_of = 2.0f*lost212 + 2.0f*total212;
            } else {
                float odd;
                float odd_low2;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float sin_series_of = sin_series(given3);
                    const float bent = given3*sin_series_of;
                    const float total22 = bent + 1.0f;
                    const float back15 = total22 - 1.0f;
                    const float lost22 = -back15 + bent;
                    const float odd_low = 0.16666667f*lost2 + lost22;
                    odd = total22;
                    odd_low2 = odd_low;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float sine = sinf(root);
                    const float cosine = cosf(root);
                    const float some = root;
                    const float total23 = sine/some;
                    const float left13 = sine - some*total23;
                    const float left14 = left13 - fmaf(total23, some, -(total23*some));
                    const float left15 = cosine*root_low + left14 - root_low*total23;
                    const float lost23 = left15/some;
                    odd = total23;
                    odd_low2 = lost23;
                }
                const float total24 = half*odd;
                const float lost24 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                const float total25 = -even + total24;
                const float back16 = -total24 + total25;
                const float rest4 = -back16 + total25;
                const float one3 = -rest4 + total24;
                const float two3 = -back16 - even;
                const float lost25 = one3 + two3;
                const float total26 = envelope + total25;
                const float back17 = -total25 + total26;
                const float rest5 = -back17 + total26;
                const float one4 = -rest5 + total25;
                const float two4 = -back17 + envelope;
                const float lost26 = one4 + two4;
                const float total27 = envelope*total26;
                const float lost27 = envelope*(-even_low2 + lost24 + lost25 + lost26) +
                    fmaf(envelope, total26, -(envelope*total26));
                const float total28 = total27/stiff;
                const float left16 = -stiff*total28 + total27;
                const float left17 = left16 - fmaf(total28, stiff, -(total28*stiff));
                const float left18 = left17 + lost27;
                const float lost28 = left18/stiff;
                const float total242 = even + total24;
                const float back162 = -even + total242;
                const float rest42 = -back162 + total242;
                const float one32 = even - rest42;
                const float two32 = -back162 + total24;
                const float lost242 = one32 + two32;
                const float total252 = envelope*total242;
                const float lost252 = envelope*(even_low2 + lost24 + lost242) +
                    fmaf(envelope, total242, -(envelope*total242));
                const float total262 = 1.0f - total252;
                const float back172 = total262 - 1.0f;
                const float lost262 = -back172 - total252;
                const float total272 = total262/stiff;
                const float left162 = -stiff*total272 + total262;
                const float left172 = left162 - fmaf(total272, stiff, -(total272*stiff));
                const float left182 = left172 - lost252 + lost262;
                const float lost272 = left182/stiff;
                fall_of = lost28 + total28;
                rise_of = lost272 + total272;
                swing_of = 2.0f*lost212 + 2.0f*total212;
            }
        }
    } else {
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        const float total3 = half + root;
        const float reach = 0.44444445f*total3;
        if (reach < 0.5625f) {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            const float given5 = 0.5f*half;
            const float total54 = 1.0f - 0.5f*given5;
            const float back32 = total54 - 1.0f;
            const float lost54 = -back32 - 0.5f*given5;
            const float decay_series_of4 = decay_series(given5);
            const float curved5 = decay_series_of4*(given5*given5);
            const float total55 = curved5 + total54;
            const float back33 = -total54 + total55;
            const float lost55 = -back33 + curved5;
            const float mean_low6 = lost54 + lost55;
            const float total56 = given5*total55;
            const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
            const float total57 = 1.0f - total56;
            const float back34 = total57 - 1.0f;
            const float lost57 = -back34 - total56;
            const float fall_low6 = -lost56 + lost57;
            const float total58 = (total57*total57);
            const float lost58 = 2.0f*fall_low6*total57 +
                fmaf(total57, total57, -(total57*total57));
            const float total59 = (total58*total58);
            const float lost59 = 2.0f*lost58*total58 + fmaf(total58, total58, -(total58*total58));
            const float rest15 = fall_series(gamma, delta);
            const float total60 = rest15 + 0.5f;
            const float back35 = -rest15 + total60;
            const float rest16 = -back35 + total60;
            const float one14 = rest15 - rest16;
            const float two14 = 0.5f - back35;
            const float lost60 = one14 + two14;
            const float total61 = total59*total60;
            const float lost61 = lost60*total59 + fmaf(total59, total60, -(total59*total60));
            const float half2 = half;
            const float given52 = 0.5f*half2;
            const float total532 = 1.0f - 0.5f*given52;
            const float back312 = total532 - 1.0f;
            const float lost532 = -back312 - 0.5f*given52;
            const float decay_series_of5 = decay_series(given52);
            const float curved52 = decay_series_of5*(given52*given52);
            const float total542 = curved52 + total532;
            const float back322 = -total532 + total542;
            const float lost542 = -back322 + curved52;
            const float mean_low62 = lost532 + lost542;
            const float total552 = given52*total542;
            const float lost552 = given52*mean_low62 + fmaf(given52, total542, -(given52*total542));
            const float total562 = 1.0f - total552;
            const float back332 = total562 - 1.0f;
            const float lost562 = -back332 - total552;
            const float fall_low62 = -lost552 + lost562;
            const float total572 = (total562*total562);
            const float lost572 = 2.0f*fall_low62*total562 +
                fmaf(total562, total562, -(total562*total562));
            const float rest132 = rise_series(half2, total2);
            const float total582 = rest132 + 0.5f;
            const float back342 = -rest132 + total582;
            const float rest142 = -back342 + total582;
            const float one122 = rest132 - rest142;
            const float two122 = 0.5f - back342;
            const float lost582 = one122 + two122;
            const float total592 = total572*total582;
            const float lost592 = lost582*total572 + fmaf(total572, total582, -(total572*total582));
            float fall_;
            float fall_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                fall_ = sunk;
                fall_low2 = sunk_low;
            }
            float fall2;
            float fall_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const float total222 = fall2 + 1.0f;
            const float back152 = total222 - 1.0f;
            const float lost222 = -back152 + fall2;
            const float total232 = fall_*total222;
            const float lost232 = fall_*(fall_low4 + lost222) +
                fmaf(fall_, total222, -(fall_*total222));
            const float creep2 = fall_low2*total222 + lost232 + total232;
            fall_of = lost59*total60 + lost61 + total61;
            rise_of = lost572*total582 + lost592 + total592;
            swing_of = creep2;
        } else {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            float fall_;
            float fall_low2;
            float mean;
            float mean_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                const float total8 = 1.0f - sunk;
                const float back7 = total8 - 1.0f;
                const float lost8 = -back7 - sunk;
                const float bottom = q;
                const float total9 = total8/bottom;
                const float left4 = -bottom*total9 + total8;
                const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const float lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            float fall2;
            float fall_low4;
            float mean2;
            float mean_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                const float total14 = 1.0f - sunk2;
                const float back11 = total14 - 1.0f;
                const float lost14 = -back11 - sunk2;
                const float bottom2 = 2.0f*root;
                const float total15 = total14/bottom2;
                const float left7 = -bottom2*total15 + total14;
                const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                const float lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const float total16 = fall2*mean;
            const float lost16 = fall2*mean_low2 + fmaf(fall2, mean, -(fall2*mean));
            const float pulled_low = fall_low4*mean + lost16;
            const float total17 = mean2 - total16;
            const float back12 = -mean2 + total17;
            const float rest3 = -back12 + total17;
            const float one2 = mean2 - rest3;
            const float two2 = -back12 - total16;
            const float lost17 = one2 + two2;
            const float total18 = total17/whole2;
            const float left10 = total17 - total18*whole2;
            const float left11 = left10 - fmaf(total18, whole2, -(total18*whole2));
            const float left12 = left11 + lost17 + mean_low4 - p_low*total18 - pulled_low;
            const float lost18 = left12/whole2;
            const float total19 = fall_*total18;
            const float lost19 = fall_*lost18 + fmaf(fall_, total18, -(fall_*total18));
            const float creep_ = fall_low2*total18 + lost19 + total19;
            const float total162 = fall_*mean2;
            const float lost162 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
            const float pulled_low2 = fall_low2*mean2 + lost162;
            const float total172 = mean - total162;
            const float back122 = -mean + total172;
            const float rest32 = -back122 + total172;
            const float one22 = mean - rest32;
            const float two22 = -back122 - total162;
            const float lost172 = one22 + two22;
            const float total182 = total172/whole2;
            const float left102 = total172 - total182*whole2;
            const float left112 = left102 - fmaf(total182, whole2, -(total182*whole2));
            const float left122 = left112 + lost172 + mean_low2 - p_low*total182 - pulled_low2;
            const float lost182 = left122/whole2;
            const float total222 = fall2 + 1.0f;
            const float back152 = total222 - 1.0f;
            const float lost222 = -back152 + fall2;
            const float total232 = fall_*total222;
            const float lost232 = fall_*(fall_low4 + lost222) +
                fmaf(fall_, total222, -(fall_*total222));
            const float creep2 = fall_low2*total222 + lost232 + total232;
            fall_of = creep_;
            rise_of = lost182 + total182;
            swing_of = creep2;
        }
    }
    *fall_out = fall_of;
    *rise_out = rise_of;
    *swing_out = swing_of;
    return;
}

// n0, the same device with its time reversed, times exp(-delta)
static float fall(float gamma, float delta) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 0.5625f) {
            const float given5 = 0.5f*half;
            const float total54 = 1.0f - 0.5f*given5;
            const float back32 = total54 - 1.0f;
            const float lost54 = -back32 - 0.5f*given5;
            const float curved5 = (given5*given5)*decay_series(given5);
            const float total55 = curved5 + total54;
            const float back33 = -total54 + total55;
            const float lost55 = -back33 + curved5;
            const float mean_low6 = lost54 + lost55;
            const float total56 = given5*total55;
            const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
            const float total57 = 1.0f - total56;
            const float back34 = total57 - 1.0f;
            const float lost57 = -back34 - total56;
            const float fall_low6 = -lost56 + lost57;
            const float total58 = (total57*total57);
            const float lost58 = 2.0f*fall_low6*total57 +
                fmaf(total57, total57, -(total57*total57));
            const float total59 = (total58*total58);
            const float lost59 = 2.0f*lost58*total58 + fmaf(total58, total58, -(total58*total58));
            const float rest15 = fall_series(gamma, delta);
            const float total60 = rest15 + 0.5f;
            const float back35 = -rest15 + total60;
            const float rest16 = -back35 + total60;
            const float one14 = rest15 - rest16;
            const float two14 = 0.5f - back35;
            const float lost60 = one14 + two14;
            const float envelope2 = total59;
            const float total61 = envelope2*total60;
            const float lost61 = envelope2*lost60 + fmaf(envelope2, total60, -(envelope2*total60));
            return lost59*total60 + lost61 + total61;
        }
        const float back2 = -total + total2;
        const float lost2 = -back2 + rest2;
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        float count;
        if (root < 4096.0f) {
            count = floorf(0.5f*root/3.1415927f + 0.5f);
        } else {
            count = 0.0f;
        }
        const float turns = (count*count);
        const float total29 = 39.478416f*turns;
        const float lost29 = fmaf(turns, 39.478416f, -(turns*39.478416f));
        const float total30 = 1.1614864e-06f*turns;
        const float lost30 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
        const float total31 = -total2 - total29;
        const float back18 = total2 + total31;
        const float rest6 = -back18 + total31;
        const float one5 = -rest6 - total2;
        const float two5 = -back18 - total29;
        const float lost31 = one5 + two5;
        const float total32 = -lost29 + total31;
        const float back19 = -total31 + total32;
        const float rest7 = -back19 + total32;
        const float one6 = -rest7 + total31;
        const float two6 = -back19 - lost29;
        const float lost32 = one6 + two6;
        const float total33 = -total30 + total32;
        const float back20 = -total32 + total33;
        const float rest8 = -back20 + total33;
        const float one7 = -rest8 + total32;
        const float two7 = -back20 - total30;
        const float lost33 = one7 + two7;
        const float total34 = -lost2 + total33;
        const float back21 = -total33 + total34;
        const float rest9 = -back21 + total34;
        const float one8 = -rest9 + total33;
        const float two8 = -back21 - lost2;
        const float lost34 = one8 + two8;
        const float low = -lost30 + lost31 + lost32 + lost33 + lost34 + 1.1704737e-14f*turns;
        const float total35 = low + total34;
        const float total36 = 6.2831855f*count;
        const float total37 = root + total36;
        const float whole3 = (total37 == 0.0f ? 1.0f : total37);
        const float total38 = total35/whole3;
        const float far = (total38*total38);
        if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
            const float sign_low = -lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float stiff = gamma;
            const float back22 = -total34 + total35;
            const float rest10 = -back22 + total35;
            const float one9 = -rest10 + total34;
            const float two9 = -back22 + low;
            const float lost35 = one9 + two9;
            const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
            const float back23 = -root + total37;
            const float rest11 = -back23 + total37;
            const float one10 = -rest11 + root;
            const float two10 = -back23 + total36;
            const float lost37 = one10 + two10;
            const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
            const float left19 = total35 - total38*whole3;
            const float left20 = left19 - fmaf(total38, whole3, -(total38*whole3));
            const float left21 = -both_low*total38 + left20 + lost35;
            const float lost38 = left21/whole3;
            const float eta = total38;
            const float eta_low = lost38;
            const float total39 = (eta*eta);
            const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
            const float bent2 = (total39*total39)*cos_series(-total39);
            const float total40 = -bent2 + 0.5f*total39;
            const float back24 = -0.5f*total39 + total40;
            const float lost40 = -back24 - bent2;
            const float total41 = -total39*sin_series(-total39) + 1.0f;
            const float back25 = total41 - 1.0f;
            const float lost41 = -back25 - total39*sin_series(-total39);
            const float lift_low = 0.5f*lost39*total41 + lost40;
            const float total42 = eta*total41;
            const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
            const float some2 = root;
            const float total43 = total42/some2;
            const float left22 = -some2*total43 + total42;
            const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
            const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*total43;
            const float lost43 = left24/some2;
            const float given4 = half;
            const float total44 = 1.0f - 0.5f*given4;
            const float back26 = total44 - 1.0f;
            const float lost44 = -back26 - 0.5f*given4;
            const float curved4 = (given4*given4)*decay_series(given4);
            const float total45 = curved4 + total44;
            const float back27 = -total44 + total45;
            const float lost45 = -back27 + curved4;
            const float mean_low5 = lost44 + lost45;
            const float total46 = given4*total45;
            const float lost46 = given4*mean_low5 + fmaf(given4, total45, -(given4*total45));
            const float total47 = 1.0f - total46;
            const float back28 = total47 - 1.0f;
            const float lost47 = -back28 - total46;
            const float fall_low5 = -lost46 + lost47;
            const float total48 = -total43 + total45;
            const float back29 = -total45 + total48;
            const float rest12 = -back29 + total48;
            const float one11 = -rest12 + total45;
            const float two11 = -back29 - total43;
            const float lost48 = one11 + two11;
            const float total49 = given4*total48;
            const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                fmaf(given4, total48, -(given4*total48));
            const float total50 = total40 - total49;
            const float back30 = -total40 + total50;
            const float rest13 = -back30 + total50;
            const float one12 = -rest13 + total40;
            const float two12 = -back30 - total49;
            const float lost50 = one12 + two12;
            const float low2 = lift_low - lost49 + lost50;
            const float total51 = low2 + total50;
            const float back31 = -total50 + total51;
            const float rest14 = -back31 + total51;
            const float one13 = -rest14 + total50;
            const float two13 = -back31 + low2;
            const float lost51 = one13 + two13;
            const float total52 = total47*total51;
            const float lost52 = lost51*total47 + fmaf(total47, total51, -(total47*total51));
            const float low3 = fall_low5*total51 + lost52;
            const float total53 = total52/stiff;
            const float left25 = -stiff*total53 + total52;
            const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
            const float left27 = left26 + low3;
            const float lost53 = left27/stiff;
            return lost53 + total53;
        }
        const float square2 = total2;
        const float envelope = expf(-half);
        const float stiff = gamma;
        float even;
        float even_low2;
        float odd;
        float odd_low2;
        if (square2 > -1.5f) {
            const float given3 = square2;
            const float total20 = 0.5f*given3 + 1.0f;
            const float back13 = total20 - 1.0f;
            const float lost20 = -back13 + 0.5f*given3;
            const float curved3 = (given3*given3)*cos_series(given3);
            const float total21 = curved3 + total20;
            const float back14 = -total20 + total21;
            const float lost21 = -back14 + curved3;
            const float even_low = 0.5f*lost2 + lost20 + lost21;
            const float bent = given3*sin_series(given3);
            const float total22 = bent + 1.0f;
            const float back15 = total22 - 1.0f;
            const float lost22 = -back15 + bent;
            const float odd_low = 0.16666667f*lost2 + lost22;
            even = total21;
            even_low2 = even_low;
            odd = total22;
            odd_low2 = odd_low;
        } else {
            const float sign_low = -lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float sine = sinf(root);
            const float cosine = cosf(root);
            const float some = root;
            const float total23 = sine/some;
            const float left13 = sine - some*total23;
            const float left14 = left13 - fmaf(total23, some, -(total23*some));
            const float left15 = cosine*root_low + left14 - root_low*total23;
            const float lost23 = left15/some;
            even = cosine;
            even_low2 = -root_low*sine;
            odd = total23;
            odd_low2 = lost23;
        }
        const float total24 = half*odd;
        const float lost24 = half*odd_low2 + fmaf(half, odd, -(half*odd));
        const float total25 = -even + total24;
        const float back16 = -total24 + total25;
        const float rest4 = -back16 + total25;
        const float one3 = -rest4 + total24;
        const float two3 = -back16 - even;
        const float lost25 = one3 + two3;
        const float total26 = envelope + total25;
        const float back17 = -total25 + total26;
        const float rest5 = -back17 + total26;
        const float one4 = -rest5 + total25;
        const float two4 = -back17 + envelope;
        const float lost26 = one4 + two4;
        const float total27 = envelope*total26;
        const float lost27 = envelope*(-even_low2 + lost24 + lost25 + lost26) +
            fmaf(envelope, total26, -(envelope*total26));
        const float total28 = total27/stiff;
        const float left16 = -stiff*total28 + total27;
        const float left17 = left16 - fmaf(total28, stiff, -(total28*stiff));
        const float left18 = left17 + lost27;
        const float lost28 = left18/stiff;
        return lost28 + total28;
    }
    const float size = fabsf(total2);
    const float root = sqrtf(size);
    const float total3 = half + root;
    const float reach = 0.44444445f*total3;
    if (reach < 0.5625f) {
        const float given5 = 0.5f*half;
        const float total54 = 1.0f - 0.5f*given5;
        const float back32 = total54 - 1.0f;
        const float lost54 = -back32 - 0.5f*given5;
        const float curved5 = (given5*given5)*decay_series(given5);
        const float total55 = curved5 + total54;
        const float back33 = -total54 + total55;
        const float lost55 = -back33 + curved5;
        const float mean_low6 = lost54 + lost55;
        const float total56 = given5*total55;
        const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
        const float total57 = 1.0f - total56;
        const float back34 = total57 - 1.0f;
        const float lost57 = -back34 - total56;
        const float fall_low6 = -lost56 + lost57;
        const float total58 = (total57*total57);
        const float lost58 = 2.0f*fall_low6*total57 + fmaf(total57, total57, -(total57*total57));
        const float total59 = (total58*total58);
        const float lost59 = 2.0f*lost58*total58 + fmaf(total58, total58, -(total58*total58));
        const float rest15 = fall_series(gamma, delta);
        const float total60 = rest15 + 0.5f;
        const float back35 = -rest15 + total60;
        const float rest16 = -back35 + total60;
        const float one14 = rest15 - rest16;
        const float two14 = 0.5f - back35;
        const float lost60 = one14 + two14;
        const float envelope2 = total59;
        const float total61 = envelope2*total60;
        const float lost61 = envelope2*lost60 + fmaf(envelope2, total60, -(envelope2*total60));
        return lost59*total60 + lost61 + total61;
    }
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    const float sign_low = lost2;
    const float left = -(root*root) + size;
    const float left2 = left - fmaf(root, root, -(root*root));
    const float left3 = left2 + sign_low;
    const float whole = (root == 0.0f ? 1.0f : root);
    const float root_low = 0.5f*left3/whole;
    const float back3 = -half + total3;
    const float lost3 = -back3 + root;
    const float p_low = lost3 + root_low;
    const float whole2 = (total3 == 0.0f ? 1.0f : total3);
    const float q = gamma/whole2;
    const float off = gamma - q*whole2;
    const float off2 = off - fmaf(whole2, q, -(whole2*q));
    const float off3 = off2 - p_low*q;
    const float q_low = off3/whole2;
    const float rate = q;
    const float rate2 = 2.0f*root;
    float fall_;
    float fall_low2;
    float mean;
    float mean_low2;
    if (rate < 0.75f) {
        const float given = q;
        const float total4 = 1.0f - 0.5f*given;
        const float back4 = total4 - 1.0f;
        const float lost4 = -back4 - 0.5f*given;
        const float curved = (given*given)*decay_series(given);
        const float total5 = curved + total4;
        const float back5 = -total4 + total5;
        const float lost5 = -back5 + curved;
        const float mean_low = lost4 + lost5 - q_low*
            (0.125f*(given*given) - 0.33333334f*given + 0.5f);
        const float total6 = given*total5;
        const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
        const float total7 = 1.0f - total6;
        const float back6 = total7 - 1.0f;
        const float lost7 = -back6 - total6;
        const float fall_low = -lost6 + lost7 - q_low*total5;
        fall_ = total7;
        fall_low2 = fall_low;
        mean = total5;
        mean_low2 = mean_low;
    } else {
        const float sunk = expf(-q);
        const float sunk_low = -q_low*sunk;
        const float total8 = 1.0f - sunk;
        const float back7 = total8 - 1.0f;
        const float lost8 = -back7 - sunk;
        const float bottom = q;
        const float total9 = total8/bottom;
        const float left4 = -bottom*total9 + total8;
        const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
        const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
        const float lost9 = left6/bottom;
        fall_ = sunk;
        fall_low2 = sunk_low;
        mean = total9;
        mean_low2 = lost9;
    }
    float fall2;
    float fall_low4;
    float mean2;
    float mean_low4;
    if (rate2 < 0.75f) {
        const float given2 = 2.0f*root;
        const float total10 = 1.0f - 0.5f*given2;
        const float back8 = total10 - 1.0f;
        const float lost10 = -back8 - 0.5f*given2;
        const float curved2 = (given2*given2)*decay_series(given2);
        const float total11 = curved2 + total10;
        const float back9 = -total10 + total11;
        const float lost11 = -back9 + curved2;
        const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
            (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
        const float total12 = given2*total11;
        const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
        const float total13 = 1.0f - total12;
        const float back10 = total13 - 1.0f;
        const float lost13 = -back10 - total12;
        const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
        fall2 = total13;
        fall_low4 = fall_low3;
        mean2 = total11;
        mean_low4 = mean_low3;
    } else {
        const float sunk2 = expf(-2.0f*root);
        const float sunk_low2 = -2.0f*root_low*sunk2;
        const float total14 = 1.0f - sunk2;
        const float back11 = total14 - 1.0f;
        const float lost14 = -back11 - sunk2;
        const float bottom2 = 2.0f*root;
        const float total15 = total14/bottom2;
        const float left7 = -bottom2*total15 + total14;
        const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
        const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
        const float lost15 = left9/bottom2;
        fall2 = sunk2;
        fall_low4 = sunk_low2;
        mean2 = total15;
        mean_low4 = lost15;
    }
    const float total16 = fall2*mean;
    const float lost16 = fall2*mean_low2 + fmaf(fall2, mean, -(fall2*mean));
    const float pulled_low = fall_low4*mean + lost16;
    const float total17 = mean2 - total16;
    const float back12 = -mean2 + total17;
    const float rest3 = -back12 + total17;
    const float one2 = mean2 - rest3;
    const float two2 = -back12 - total16;
    const float lost17 = one2 + two2;
    const float total18 = total17/whole2;
    const float left10 = total17 - total18*whole2;
    const float left11 = left10 - fmaf(total18, whole2, -(total18*whole2));
    const float left12 = left11 + lost17 + mean_low4 - p_low*total18 - pulled_low;
    const float lost18 = left12/whole2;
    const float total19 = fall_*total18;
    const float lost19 = fall_*lost18 + fmaf(fall_, total18, -(fall_*total18));
    const float creep_ = fall_low2*total18 + lost19 + total19;
    return creep_;
}

// n1, how far a unit force moves the device in a period
static float rise(float gamma, float delta) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 0.5625f) {
            const float half2 = half;
            const float given5 = 0.5f*half2;
            const float total53 = 1.0f - 0.5f*given5;
            const float back31 = total53 - 1.0f;
            const float lost53 = -back31 - 0.5f*given5;
            const float curved5 = (given5*given5)*decay_series(given5);
            const float total54 = curved5 + total53;
            const float back32 = -total53 + total54;
            const float lost54 = -back32 + curved5;
            const float mean_low6 = lost53 + lost54;
            const float total55 = given5*total54;
            const float lost55 = given5*mean_low6 + fmaf(given5, total54, -(given5*total54));
            const float total56 = 1.0f - total55;
            const float back33 = total56 - 1.0f;
            const float lost56 = -back33 - total55;
            const float fall_low6 = -lost55 + lost56;
            const float total57 = (total56*total56);
            const float lost57 = 2.0f*fall_low6*total56 +
                fmaf(total56, total56, -(total56*total56));
            const float rest13 = rise_series(half2, total2);
            const float total58 = rest13 + 0.5f;
            const float back34 = -rest13 + total58;
            const float rest14 = -back34 + total58;
            const float one12 = rest13 - rest14;
            const float two12 = 0.5f - back34;
            const float lost58 = one12 + two12;
            const float envelope2 = total57;
            const float total59 = envelope2*total58;
            const float lost59 = envelope2*lost58 + fmaf(envelope2, total58, -(envelope2*total58));
            return lost57*total58 + lost59 + total59;
        }
        const float back2 = -total + total2;
        const float lost2 = -back2 + rest2;
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        float count;
        if (root < 4096.0f) {
            count = floorf(0.5f*root/3.1415927f + 0.5f);
        } else {
            count = 0.0f;
        }
        const float turns = (count*count);
        const float total28 = 39.478416f*turns;
        const float lost28 = fmaf(turns, 39.478416f, -(turns*39.478416f));
        const float total29 = 1.1614864e-06f*turns;
        const float lost29 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
        const float total30 = -total2 - total28;
        const float back18 = total2 + total30;
        const float rest5 = -back18 + total30;
        const float one4 = -rest5 - total2;
        const float two4 = -back18 - total28;
        const float lost30 = one4 + two4;
        const float total31 = -lost28 + total30;
        const float back19 = -total30 + total31;
        const float rest6 = -back19 + total31;
        const float one5 = -rest6 + total30;
        const float two5 = -back19 - lost28;
        const float lost31 = one5 + two5;
        const float total32 = -total29 + total31;
        const float back20 = -total31 + total32;
        const float rest7 = -back20 + total32;
        const float one6 = -rest7 + total31;
        const float two6 = -back20 - total29;
        const float lost32 = one6 + two6;
        const float total33 = -lost2 + total32;
        const float back21 = -total32 + total33;
        const float rest8 = -back21 + total33;
        const float one7 = -rest8 + total32;
        const float two7 = -back21 - lost2;
        const float lost33 = one7 + two7;
        const float low = -lost29 + lost30 + lost31 + lost32 + lost33 + 1.1704737e-14f*turns;
        const float total34 = low + total33;
        const float total35 = 6.2831855f*count;
        const float total36 = root + total35;
        const float whole3 = (total36 == 0.0f ? 1.0f : total36);
        const float total37 = total34/whole3;
        const float far = (total37*total37);
        if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
            const float sign_low = -lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float stiff = gamma;
            const float back22 = -total33 + total34;
            const float rest9 = -back22 + total34;
            const float one8 = -rest9 + total33;
            const float two8 = -back22 + low;
            const float lost34 = one8 + two8;
            const float lost35 = fmaf(count, 6.2831855f, -(count*6.2831855f));
            const float back23 = -root + total36;
            const float rest10 = -back23 + total36;
            const float one9 = -rest10 + root;
            const float two9 = -back23 + total35;
            const float lost36 = one9 + two9;
            const float both_low = -1.7484555e-07f*count + lost35 + lost36 + root_low;
            const float left19 = total34 - total37*whole3;
            const float left20 = left19 - fmaf(total37, whole3, -(total37*whole3));
            const float left21 = -both_low*total37 + left20 + lost34;
            const float lost37 = left21/whole3;
            const float eta = total37;
            const float eta_low = lost37;
            const float total38 = (eta*eta);
            const float lost38 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
            const float bent2 = (total38*total38)*cos_series(-total38);
            const float total39 = -bent2 + 0.5f*total38;
            const float back24 = -0.5f*total38 + total39;
            const float lost39 = -back24 - bent2;
            const float total40 = -total38*sin_series(-total38) + 1.0f;
            const float back25 = total40 - 1.0f;
            const float lost40 = -back25 - total38*sin_series(-total38);
            const float lift_low = 0.5f*lost38*total40 + lost39;
            const float total41 = eta*total40;
            const float lost41 = eta*lost40 + fmaf(eta, total40, -(eta*total40));
            const float some2 = root;
            const float total42 = total41/some2;
            const float left22 = -some2*total42 + total41;
            const float left23 = left22 - fmaf(total42, some2, -(total42*some2));
            const float left24 = eta_low*(1.0f - total39) + left23 + lost41 - root_low*total42;
            const float lost42 = left24/some2;
            const float given4 = half;
            const float total43 = 1.0f - 0.5f*given4;
            const float back26 = total43 - 1.0f;
            const float lost43 = -back26 - 0.5f*given4;
            const float curved4 = (given4*given4)*decay_series(given4);
            const float total44 = curved4 + total43;
            const float back27 = -total43 + total44;
            const float lost44 = -back27 + curved4;
            const float mean_low5 = lost43 + lost44;
            const float total45 = given4*total44;
            const float lost45 = given4*mean_low5 + fmaf(given4, total44, -(given4*total44));
            const float total46 = 1.0f - total45;
            const float back28 = total46 - 1.0f;
            const float lost46 = -back28 - total45;
            const float fall_low5 = -lost45 + lost46;
            const float total47 = total42*total46;
            const float lost47 = lost42*total46 + fmaf(total46, total42, -(total46*total42));
            const float total48 = total44 - total47;
            const float back29 = -total44 + total48;
            const float rest11 = -back29 + total48;
            const float one10 = -rest11 + total44;
            const float two10 = -back29 - total47;
            const float lost48 = one10 + two10;
            const float low2 = -fall_low5*total42 - lost47 + lost48 + mean_low5;
            const float total49 = given4*total48;
            const float lost49 = given4*low2 + fmaf(given4, total48, -(given4*total48));
            const float total50 = total39*total46;
            const float lost50 = lift_low*total46 + fmaf(total46, total39, -(total46*total39));
            const float total51 = total49 + total50;
            const float back30 = -total49 + total51;
            const float rest12 = -back30 + total51;
            const float one11 = -rest12 + total49;
            const float two11 = -back30 + total50;
            const float lost51 = one11 + two11;
            const float low3 = fall_low5*total39 + lost49 + lost50 + lost51;
            const float total52 = total51/stiff;
            const float left25 = -stiff*total52 + total51;
            const float left26 = left25 - fmaf(total52, stiff, -(total52*stiff));
            const float left27 = left26 + low3;
            const float lost52 = left27/stiff;
            return lost52 + total52;
        }
        const float square2 = total2;
        const float envelope = expf(-half);
        const float stiff = gamma;
        float even;
        float even_low2;
        float odd;
        float odd_low2;
        if (square2 > -1.5f) {
            const float given3 = square2;
            const float total19 = 0.5f*given3 + 1.0f;
            const float back13 = total19 - 1.0f;
            const float lost19 = -back13 + 0.5f*given3;
            const float curved3 = (given3*given3)*cos_series(given3);
            const float total20 = curved3 + total19;
            const float back14 = -total19 + total20;
            const float lost20 = -back14 + curved3;
            const float even_low = lost19 + 0.5f*lost2 + lost20;
            const float bent = given3*sin_series(given3);
            const float total21 = bent + 1.0f;
            const float back15 = total21 - 1.0f;
            const float lost21 = -back15 + bent;
            const float odd_low = 0.16666667f*lost2 + lost21;
            even = total20;
            even_low2 = even_low;
            odd = total21;
            odd_low2 = odd_low;
        } else {
            const float sign_low = -lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float sine = sinf(root);
            const float cosine = cosf(root);
            const float some = root;
            const float total22 = sine/some;
            const float left13 = sine - some*total22;
            const float left14 = left13 - fmaf(total22, some, -(total22*some));
            const float left15 = cosine*root_low + left14 - root_low*total22;
            const float lost22 = left15/some;
            even = cosine;
            even_low2 = -root_low*sine;
            odd = total22;
            odd_low2 = lost22;
        }
        const float total23 = half*odd;
        const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
        const float total24 = even + total23;
        const float back16 = -even + total24;
        const float rest4 = -back16 + total24;
        const float one3 = even - rest4;
        const float two3 = -back16 + total23;
        const float lost24 = one3 + two3;
        const float total25 = envelope*total24;
        const float lost25 = envelope*(even_low2 + lost23 + lost24) +
            fmaf(envelope, total24, -(envelope*total24));
        const float total26 = 1.0f - total25;
        const float back17 = total26 - 1.0f;
        const float lost26 = -back17 - total25;
        const float total27 = total26/stiff;
        const float left16 = -stiff*total27 + total26;
        const float left17 = left16 - fmaf(total27, stiff, -(total27*stiff));
        const float left18 = left17 - lost25 + lost26;
        const float lost27 = left18/stiff;
        return lost27 + total27;
    }
    const float size = fabsf(total2);
    const float root = sqrtf(size);
    const float total3 = half + root;
    const float reach = 0.44444445f*total3;
    if (reach < 0.5625f) {
        const float half2 = half;
        const float given5 = 0.5f*half2;
        const float total53 = 1.0f - 0.5f*given5;
        const float back31 = total53 - 1.0f;
        const float lost53 = -back31 - 0.5f*given5;
        const float curved5 = (given5*given5)*decay_series(given5);
        const float total54 = curved5 + total53;
        const float back32 = -total53 + total54;
        const float lost54 = -back32 + curved5;
        const float mean_low6 = lost53 + lost54;
        const float total55 = given5*total54;
        const float lost55 = given5*mean_low6 + fmaf(given5, total54, -(given5*total54));
        const float total56 = 1.0f - total55;
        const float back33 = total56 - 1.0f;
        const float lost56 = -back33 - total55;
        const float fall_low6 = -lost55 + lost56;
        const float total57 = (total56*total56);
        const float lost57 = 2.0f*fall_low6*total56 + fmaf(total56, total56, -(total56*total56));
        const float rest13 = rise_series(half2, total2);
        const float total58 = rest13 + 0.5f;
        const float back34 = -rest13 + total58;
        const float rest14 = -back34 + total58;
        const float one12 = rest13 - rest14;
        const float two12 = 0.5f - back34;
        const float lost58 = one12 + two12;
        const float envelope2 = total57;
        const float total59 = envelope2*total58;
        const float lost59 = envelope2*lost58 + fmaf(envelope2, total58, -(envelope2*total58));
        return lost57*total58 + lost59 + total59;
    }
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    const float sign_low = lost2;
    const float left = -(root*root) + size;
    const float left2 = left - fmaf(root, root, -(root*root));
    const float left3 = left2 + sign_low;
    const float whole = (root == 0.0f ? 1.0f : root);
    const float root_low = 0.5f*left3/whole;
    const float back3 = -half + total3;
    const float lost3 = -back3 + root;
    const float p_low = lost3 + root_low;
    const float whole2 = (total3 == 0.0f ? 1.0f : total3);
    const float q = gamma/whole2;
    const float off = gamma - q*whole2;
    const float off2 = off - fmaf(whole2, q, -(whole2*q));
    const float off3 = off2 - p_low*q;
    const float q_low = off3/whole2;
    const float rate = q;
    const float rate2 = 2.0f*root;
    float fall_;
    float fall_low2;
    float mean;
    float mean_low2;
    if (rate < 0.75f) {
        const float given = q;
        const float total4 = 1.0f - 0.5f*given;
        const float back4 = total4 - 1.0f;
        const float lost4 = -back4 - 0.5f*given;
        const float curved = (given*given)*decay_series(given);
        const float total5 = curved + total4;
        const float back5 = -total4 + total5;
        const float lost5 = -back5 + curved;
        const float mean_low = lost4 + lost5 - q_low*
            (0.125f*(given*given) - 0.33333334f*given + 0.5f);
        const float total6 = given*total5;
        const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
        const float total7 = 1.0f - total6;
        const float back6 = total7 - 1.0f;
        const float lost7 = -back6 - total6;
        const float fall_low = -lost6 + lost7 - q_low*total5;
        fall_ = total7;
        fall_low2 = fall_low;
        mean = total5;
        mean_low2 = mean_low;
    } else {
        const float sunk = expf(-q);
        const float sunk_low = -q_low*sunk;
        const float total8 = 1.0f - sunk;
        const float back7 = total8 - 1.0f;
        const float lost8 = -back7 - sunk;
        const float bottom = q;
        const float total9 = total8/bottom;
        const float left4 = -bottom*total9 + total8;
        const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
        const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
        const float lost9 = left6/bottom;
        fall_ = sunk;
        fall_low2 = sunk_low;
        mean = total9;
        mean_low2 = lost9;
    }
    float mean2;
    float mean_low4;
    if (rate2 < 0.75f) {
        const float given2 = 2.0f*root;
        const float total10 = 1.0f - 0.5f*given2;
        const float back8 = total10 - 1.0f;
        const float lost10 = -back8 - 0.5f*given2;
        const float curved2 = (given2*given2)*decay_series(given2);
        const float total11 = curved2 + total10;
        const float back9 = -total10 + total11;
        const float lost11 = -back9 + curved2;
        const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
            (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
        mean2 = total11;
        mean_low4 = mean_low3;
    } else {
        const float sunk2 = expf(-2.0f*root);
        const float sunk_low2 = -2.0f*root_low*sunk2;
        const float total14 = 1.0f - sunk2;
        const float back11 = total14 - 1.0f;
        const float lost14 = -back11 - sunk2;
        const float bottom2 = 2.0f*root;
        const float total15 = total14/bottom2;
        const float left7 = -bottom2*total15 + total14;
        const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
        const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
        const float lost15 = left9/bottom2;
        mean2 = total15;
        mean_low4 = lost15;
    }
    const float total16 = fall_*mean2;
    const float lost16 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
    const float pulled_low = fall_low2*mean2 + lost16;
    const float total17 = mean - total16;
    const float back12 = -mean + total17;
    const float rest3 = -back12 + total17;
    const float one2 = mean - rest3;
    const float two2 = -back12 - total16;
    const float lost17 = one2 + two2;
    const float total18 = total17/whole2;
    const float left10 = total17 - total18*whole2;
    const float left11 = left10 - fmaf(total18, whole2, -(total18*whole2));
    const float left12 = left11 + lost17 + mean_low2 - p_low*total18 - pulled_low;
    const float lost18 = left12/whole2;
    return lost18 + total18;
}

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static float together_series(float h, float w) {
    if ((fabsf(w) < 0.00390625f) && (h < 0.0625f)) {
        const float y = (h*h);
        const float e3 = 2.4801588e-05f;
        const float b3 = e3;
        const float e2 = e3*w + 0.0013888889f;
        const float b2 = b3*y + e2;
        const float e1 = e2*w + 0.041666668f;
        const float b1 = b2*y + e1;
        const float e0 = e1*w;
        const float b0 = b1*y + e0;
        return b0;
    }
    const float y2 = (h*h);
    const float e9 = 4.1103176e-19f;
    const float b9 = e9;
    const float e8 = e9*w + 1.5619207e-16f;
    const float b8 = b9*y2 + e8;
    const float e7 = e8*w + 4.7794773e-14f;
    const float b7 = b8*y2 + e7;
    const float e6 = e7*w + 1.1470745e-11f;
    const float b6 = b7*y2 + e6;
    const float e5 = e6*w + 2.0876756e-09f;
    const float b5 = b6*y2 + e5;
    const float e4 = e5*w + 2.755732e-07f;
    const float b4 = b5*y2 + e4;
    const float e32 = e4*w + 2.4801588e-05f;
    const float b32 = b4*y2 + e32;
    const float e22 = e32*w + 0.0013888889f;
    const float b22 = b32*y2 + e22;
    const float e12 = e22*w + 0.041666668f;
    const float b12 = b22*y2 + e12;
    const float e02 = e12*w;
    const float b02 = b12*y2 + e02;
    return b02;
}

// a, the sum of the sampled device's poles; n1 + n0
static void swing_together(float gamma, float delta, float *swing_out, float *together_out) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    float swing_of;
    float together_of;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 1.0f) {
            const float square2 = total2;
            const float envelope = expf(-half);
            const float rest12 = together_series(half, total2);
            const float total55 = rest12 + 0.5f;
            const float back33 = -rest12 + total55;
            const float rest13 = -back33 + total55;
            const float one11 = rest12 - rest13;
            const float two11 = 0.5f - back33;
            const float lost55 = one11 + two11;
            const float total56 = envelope*total55;
            const float lost56 = envelope*lost55 + fmaf(envelope, total55, -(envelope*total55));
            float even;
            float even_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total16 = 0.5f*given3 + 1.0f;
                const float back12 = total16 - 1.0f;
                const float lost16 = -back12 + 0.5f*given3;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total17 = curved3 + total16;
                const float back13 = -total16 + total17;
                const float lost17 = -back13 + curved3;
                const float even_low = lost16 + lost17 + 0.5f*lost2;
                even = total17;
                even_low2 = even_low;
            } else {
                const float size = fabsf(total2);
                const float root = sqrtf(size);
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const float total21 = envelope*even;
            const float lost21 = envelope*even_low2 + fmaf(envelope, even, -(envelope*even));
            swing_of = 2.0f*lost21 + 2.0f*total21;
            together_of = 2.0f*lost56 + 2.0f*total56;
        } else {
            const float size = fabsf(total2);
            const float root = sqrtf(size);
            const float square2 = total2;
            const float envelope = expf(-half);
            const float stiff = gamma;
            float even;
            float even_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total16 = 0.5f*given3 + 1.0f;
                const float back12 = total16 - 1.0f;
                const float lost16 = -back12 + 0.5f*given3;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total17 = curved3 + total16;
                const float back13 = -total16 + total17;
                const float lost17 = -back13 + curved3;
                const float even_low = lost16 + lost17 + 0.5f*lost2;
                even = total17;
                even_low2 = even_low;
            } else {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const float total21 = envelope*even;
            const float lost21 = envelope*even_low2 + fmaf(envelope, even, -(envelope*even));
            float count;
            if (root < 4096.0f) {
                count = floorf(0.5f*root/3.1415927f + 0.5f);
            } else {
                count = 0.0f;
            }
            const float turns = (count*count);
            const float total142 = 39.478416f*turns;
            const float lost142 = fmaf(turns, 39.478416f, -(turns*39.478416f));
            const float total152 = 1.1614864e-06f*turns;
            const float lost152 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
            const float total162 = -total142 - total2;
            const float back102 = total162 + total2;
            const float rest5 = -back102 + total162;
            const float one4 = -rest5 - total2;
            const float two4 = -back102 - total142;
            const float lost162 = one4 + two4;
            const float total172 = -lost142 + total162;
            const float back112 = -total162 + total172;
            const float rest6 = -back112 + total172;
            const float one5 = -rest6 + total162;
            const float two5 = -back112 - lost142;
            const float lost172 = one5 + two5;
            const float total182 = -total152 + total172;
            const float back122 = -total172 + total182;
            const float rest7 = -back122 + total182;
            const float one6 = -rest7 + total172;
            const float two6 = -back122 - total152;
            const float lost182 = one6 + two6;
            const float total192 = -lost2 + total182;
            const float back132 = -total182 + total192;
            const float rest8 = -back132 + total192;
            const float one7 = -rest8 + total182;
            const float two7 = -back132 - lost2;
            const float lost192 = one7 + two7;
            const float low3 = -lost152 + lost162 + lost172 + lost182 + lost192 + 1.1704737e-14f*
                turns;
            const float total202 = low3 + total192;
            const float total212 = 6.2831855f*count;
            const float total222 = root + total212;
            const float whole3 = (total222 == 0.0f ? 1.0f : total222);
            const float total232 = total202/whole3;
            const float far = (total232*total232);
            if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back142 = -total192 + total202;
                const float rest9 = -back142 + total202;
                const float one8 = -rest9 + total192;
                const float two8 = -back142 + low3;
                const float lost202 = one8 + two8;
                const float lost212 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                const float back152 = -root + total222;
                const float rest10 = -back152 + total222;
                const float one9 = -rest10 + root;
                const float two9 = -back152 + total212;
                const float lost222 = one9 + two9;
                const float both_low = -1.7484555e-07f*count + lost212 + lost222 + root_low;
                const float left102 = total202 - total232*whole3;
                const float left112 = left102 - fmaf(total232, whole3, -(total232*whole3));
                const float left122 = -both_low*total232 + left112 + lost202;
                const float lost232 = left122/whole3;
                const float eta = total232;
                const float eta_low = lost232;
                const float total24 = (eta*eta);
                const float lost24 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                const float cos_series_of2 = cos_series(-total24);
                const float bent2 = cos_series_of2*(total24*total24);
                const float total25 = -bent2 + 0.5f*total24;
                const float back16 = -0.5f*total24 + total25;
                const float lost25 = -back16 - bent2;
                const float sin_series_of2 = sin_series(-total24);
                const float total26 = -sin_series_of2*total24 + 1.0f;
                const float lift_low = 0.5f*lost24*total26 + lost25;
                const float given22 = half;
                const float total29 = 1.0f - 0.5f*given22;
                const float back18 = total29 - 1.0f;
                const float lost29 = -back18 - 0.5f*given22;
                const float decay_series_of3 = decay_series(given22);
                const float curved22 = decay_series_of3*(given22*given22);
                const float total30 = curved22 + total29;
                const float back19 = -total29 + total30;
                const float lost30 = -back19 + curved22;
                const float mean_low5 = lost29 + lost30;
                const float total31 = given22*total30;
                const float lost31 = given22*mean_low5 + fmaf(given22, total30, -(given22*total30));
                const float total32 = 1.0f - total31;
                const float back20 = total32 - 1.0f;
                const float lost32 = -back20 - total31;
                const float fall_low5 = -lost31 + lost32;
                const float total33 = 1.0f - total32;
                const float back21 = total33 - 1.0f;
                const float lost33 = -back21 - total32;
                const float low4 = -fall_low5 + lost33;
                const float total34 = low4 + total33;
                const float back22 = -total33 + total34;
                const float lost34 = -back22 + low4;
                const float total35 = (total34*total34);
                const float lost35 = 2.0f*lost34*total34 +
                    fmaf(total34, total34, -(total34*total34));
                const float total36 = total25*total32;
                const float lost36 = lift_low*total32 + fmaf(total32, total25, -(total32*total25));
                const float total37 = total35 + 2.0f*total36;
                const float back23 = -total35 + total37;
                const float rest11 = -back23 + total37;
                const float one10 = -rest11 + total35;
                const float two10 = -back23 + 2.0f*total36;
                const float lost37 = one10 + two10;
                const float low5 = 2.0f*fall_low5*total25 + lost35 + 2.0f*lost36 + lost37;
                const float total38 = total37/stiff;
                const float left16 = -stiff*total38 + total37;
                const float left17 = left16 - fmaf(total38, stiff, -(total38*stiff));
                const float left18 = left17 + low5;
                const float lost38 = left18/stiff;
                swing_of = 2.0f*lost21 + 2.0f*total21;
                together_of = lost38 + total38;
            } else {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float expm1_of = expm1f(-half);
                const float grown = -0.5f*expm1_of;
                const float angle = 0.5f*root;
                const float wave = sinf(angle);
                const float cos_of = cosf(angle);
                const float back72 = -0.5f*cos_of*root_low;
                const float total92 = -back72 + wave;
                const float back82 = total92 - wave;
                const float rest3 = -back82 + total92;
                const float one2 = -rest3 + wave;
                const float two2 = -back72 - back82;
                const float lost92 = one2 + two2;
                const float total102 = (total92*total92);
                const float lost102 = fmaf(total92, total92, -(total92*total92));
                const float low = lost102 + 2.0f*lost92*total92;
                const float total112 = envelope*total102;
                const float lost112 = envelope*low + fmaf(envelope, total102, -(envelope*total102));
                const float total122 = (grown*grown) + total112;
                const float back92 = -total112 + total122;
                const float rest4 = -back92 + total122;
                const float one3 = -rest4 + total112;
                const float two3 = -back92 + (grown*grown);
                const float lost122 = one3 + two3;
                const float low2 = lost112 + lost122;
                const float total132 = total122/stiff;
                const float left72 = -stiff*total132 + total122;
                const float left82 = left72 - fmaf(total132, stiff, -(total132*stiff));
                const float left92 = left82 + low2;
                const float lost132 = left92/stiff;
                swing_of = 2.0f*lost21 + 2.0f*total21;
                together_of = 4.0f*lost132 + 4.0f*total132;
            }
        }
    } else {
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        const float total3 = half + root;
        const float reach = 0.44444445f*total3;
        if (reach < 1.0f) {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            const float envelope = expf(-half);
            const float rest12 = together_series(half, total2);
            const float total55 = rest12 + 0.5f;
            const float back33 = -rest12 + total55;
            const float rest13 = -back33 + total55;
            const float one11 = rest12 - rest13;
            const float two11 = 0.5f - back33;
            const float lost55 = one11 + two11;
            const float total56 = envelope*total55;
            const float lost56 = envelope*lost55 + fmaf(envelope, total55, -(envelope*total55));
            float fall_;
            float fall_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                fall_ = sunk;
                fall_low2 = sunk_low;
            }
            float fall2;
            float fall_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const float total22 = fall2 + 1.0f;
            const float back15 = total22 - 1.0f;
            const float lost22 = -back15 + fall2;
            const float total23 = fall_*total22;
            const float lost23 = fall_*(fall_low4 + lost22) +
                fmaf(fall_, total22, -(fall_*total22));
            const float creep_ = fall_low2*total22 + lost23 + total23;
            swing_of = creep_;
            together_of = 2.0f*lost56 + 2.0f*total56;
        } else {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            float fall_;
            float fall_low2;
            float mean;
            float mean_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                const float total8 = 1.0f - sunk;
                const float back7 = total8 - 1.0f;
                const float lost8 = -back7 - sunk;
                const float bottom = q;
                const float total9 = total8/bottom;
                const float left4 = -bottom*total9 + total8;
                const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const float lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            float fall2;
            float fall_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const float total22 = fall2 + 1.0f;
            const float back15 = total22 - 1.0f;
            const float lost22 = -back15 + fall2;
            const float total23 = fall_*total22;
            const float lost23 = fall_*(fall_low4 + lost22) +
                fmaf(fall_, total22, -(fall_*total22));
            const float creep_ = fall_low2*total22 + lost23 + total23;
            const float total51 = fall_*fall2;
            const float lost51 = fall_*fall_low4 + fmaf(fall_, fall2, -(fall_*fall2));
            const float low6 = fall2*fall_low2 + lost51;
            const float total52 = 1.0f - total51;
            const float back32 = total52 - 1.0f;
            const float lost52 = -back32 - total51;
            const float total53 = mean*total52;
            const float lost53 = mean*(lost52 - low6) + fmaf(mean, total52, -(mean*total52));
            const float moved_low = lost53 + mean_low2*total52;
            const float total54 = total53/whole2;
            const float left25 = total53 - total54*whole2;
            const float left26 = left25 - fmaf(total54, whole2, -(total54*whole2));
            const float left27 = left26 + moved_low - p_low*total54;
            const float lost54 = left27/whole2;
            swing_of = creep_;
            together_of = lost54 + total54;
        }
    }
    *swing_out = swing_of;
    *together_out = together_of;
    return;
}

// divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6
static float apart_series(float h, float w) {
    if ((fabsf(w) < 0.00390625f) && (h < 0.0625f)) {
        const float y = (h*h);
        const float e3 = 2.7557319e-06f;
        const float b3 = e3;
        const float e2 = e3*w + 0.0001984127f;
        const float b2 = b3*y + e2;
        const float e1 = e2*w + 0.008333334f;
        const float b1 = b2*y + e1;
        const float e0 = e1*w;
        const float b0 = b1*y + e0;
        return b0 - 4.967054e-09f;
    }
    const float y2 = (h*h);
    const float e8 = 8.220635e-18f;
    const float b8 = e8;
    const float e7 = e8*w + 2.8114574e-15f;
    const float b7 = b8*y2 + e7;
    const float e6 = e7*w + 7.6471636e-13f;
    const float b6 = b7*y2 + e6;
    const float e5 = e6*w + 1.6059044e-10f;
    const float b5 = b6*y2 + e5;
    const float e4 = e5*w + 2.5052108e-08f;
    const float b4 = b5*y2 + e4;
    const float e32 = e4*w + 2.7557319e-06f;
    const float b32 = b4*y2 + e32;
    const float e22 = e32*w + 0.0001984127f;
    const float b22 = b32*y2 + e22;
    const float e12 = e22*w + 0.008333334f;
    const float b12 = b22*y2 + e12;
    const float e02 = e12*w;
    const float b02 = b12*y2 + e02;
    return b02 - 4.967054e-09f;
}

// (1 - exp(-x))/x
static float decay(float x) {
    if (x == 0.0f) {
        return 1.0f;
    }
    const float whole = x;
    return -expm1f(-x)/whole;
}

// (n1 - n0)/delta; n0, the same device with its time reversed, times exp(-delta); displacement by a
// unit impulse after a period; what the last rounding of Kick takes; n1, how far a unit force moves
// the device in a period
static void apart_fall_kick_kick_low_rise(float gamma, float delta, float *apart_out,
    float *fall_out, float *kick_out, float *kick_low_out, float *rise_out) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    float apart_of;
    float fall_of;
    float kick_of;
    float kick_low_of;
    float rise_of;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 1.0f) {
            if (reach < 0.5625f) {
                const float square2 = total2;
                const float envelope = expf(-half);
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                const float given5 = 0.5f*half;
                const float total54 = 1.0f - 0.5f*given5;
                const float back32 = total54 - 1.0f;
                const float lost54 = -back32 - 0.5f*given5;
                const float decay_series_of4 = decay_series(given5);
                const float curved5 = decay_series_of4*(given5*given5);
                const float total55 = curved5 + total54;
                const float back33 = -total54 + total55;
                const float lost55 = -back33 + curved5;
                const float mean_low6 = lost54 + lost55;
                const float total56 = given5*total55;
                const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
                const float total57 = 1.0f - total56;
                const float back34 = total57 - 1.0f;
                const float lost57 = -back34 - total56;
                const float fall_low6 = -lost56 + lost57;
                const float total58 = (total57*total57);
                const float lost58 = 2.0f*fall_low6*total57 +
                    fmaf(total57, total57, -(total57*total57));
                const float total59 = (total58*total58);
                const float lost59 = 2.0f*lost58*total58 +
                    fmaf(total58, total58, -(total58*total58));
                const float rest15 = fall_series(gamma, delta);
                const float total60 = rest15 + 0.5f;
                const float back35 = -rest15 + total60;
                const float rest16 = -back35 + total60;
                const float one14 = rest15 - rest16;
                const float two14 = 0.5f - back35;
                const float lost60 = one14 + two14;
                const float total61 = total59*total60;
                const float lost61 = lost60*total59 + fmaf(total59, total60, -(total59*total60));
                const float half2 = half;
                const float given52 = 0.5f*half2;
                const float total532 = 1.0f - 0.5f*given52;
                const float back312 = total532 - 1.0f;
                const float lost532 = -back312 - 0.5f*given52;
                const float decay_series_of5 = decay_series(given52);
                const float curved52 = decay_series_of5*(given52*given52);
                const float total542 = curved52 + total532;
                const float back322 = -total532 + total542;
                const float lost542 = -back322 + curved52;
                const float mean_low62 = lost532 + lost542;
                const float total552 = given52*total542;
                const float lost552 = given52*mean_low62 +
                    fmaf(given52, total542, -(given52*total542));
                const float total562 = 1.0f - total552;
                const float back332 = total562 - 1.0f;
                const float lost562 = -back332 - total552;
                const float fall_low62 = -lost552 + lost562;
                const float total572 = (total562*total562);
                const float lost572 = 2.0f*fall_low62*total562 +
                    fmaf(total562, total562, -(total562*total562));
                const float rest132 = rise_series(half2, total2);
                const float total582 = rest132 + 0.5f;
                const float back342 = -rest132 + total582;
                const float rest142 = -back342 + total582;
                const float one122 = rest132 - rest142;
                const float two122 = 0.5f - back342;
                const float lost582 = one122 + two122;
                const float total592 = total572*total582;
                const float lost592 = lost582*total572 +
                    fmaf(total572, total582, -(total572*total582));
                float odd;
                float odd_low2;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float sin_series_of = sin_series(given3);
                    const float bent = given3*sin_series_of;
                    const float total21 = bent + 1.0f;
                    const float back15 = total21 - 1.0f;
                    const float lost21 = -back15 + bent;
                    const float odd_low = 0.16666667f*lost2 + lost21;
                    odd = total21;
                    odd_low2 = odd_low;
                } else {
                    const float size = fabsf(total2);
                    const float root = sqrtf(size);
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float sine = sinf(root);
                    const float cosine = cosf(root);
                    const float some = root;
                    const float total22 = sine/some;
                    const float left10 = sine - some*total22;
                    const float left11 = left10 - fmaf(total22, some, -(total22*some));
                    const float left12 = cosine*root_low + left11 - root_low*total22;
                    const float lost22 = left12/some;
                    odd = total22;
                    odd_low2 = lost22;
                }
                const float total24 = envelope*odd;
                const float lost24 = envelope*odd_low2 + fmaf(envelope, odd, -(envelope*odd));
                const float total222 = lost24 + total24;
                const float back152 = total222 - total24;
                const float lost222 = -back152 + lost24;
                apart_of = lost28 + total28;
                fall_of = lost59*total60 + lost61 + total61;
                kick_of = total222;
                kick_low_of = lost222;
                rise_of = lost572*total582 + lost592 + total592;
            } else {
                const float size = fabsf(total2);
                const float root = sqrtf(size);
                const float square2 = total2;
                const float envelope = expf(-half);
                const float stiff = gamma;
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                float odd;
                float odd_low2;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float sin_series_of = sin_series(given3);
                    const float bent = given3*sin_series_of;
                    const float total21 = bent + 1.0f;
                    const float back15 = total21 - 1.0f;
                    const float lost21 = -back15 + bent;
                    const float odd_low = 0.16666667f*lost2 + lost21;
                    odd = total21;
                    odd_low2 = odd_low;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float sine = sinf(root);
                    const float cosine = cosf(root);
                    const float some = root;
                    const float total22 = sine/some;
                    const float left10 = sine - some*total22;
                    const float left11 = left10 - fmaf(total22, some, -(total22*some));
                    const float left12 = cosine*root_low + left11 - root_low*total22;
                    const float lost22 = left12/some;
                    odd = total22;
                    odd_low2 = lost22;
                }
                const float total24 = envelope*odd;
                const float lost24 = envelope*odd_low2 + fmaf(envelope, odd, -(envelope*odd));
                const float total222 = lost24 + total24;
                const float back152 = total222 - total24;
                const float lost222 = -back152 + lost24;
                float count;
                if (root < 4096.0f) {
                    count = floorf(0.5f*root/3.1415927f + 0.5f);
                } else {
                    count = 0.0f;
                }
                const float turns = (count*count);
                const float total29 = 39.478416f*turns;
                const float lost29 = fmaf(turns, 39.478416f, -(turns*39.478416f));
                const float total30 = 1.1614864e-06f*turns;
                const float lost30 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
                const float total31 = -total2 - total29;
                const float back18 = total2 + total31;
                const float rest62 = -back18 + total31;
                const float one5 = -rest62 - total2;
                const float two5 = -back18 - total29;
                const float lost31 = one5 + two5;
                const float total32 = -lost29 + total31;
                const float back19 = -total31 + total32;
                const float rest7 = -back19 + total32;
                const float one6 = -rest7 + total31;
                const float two6 = -back19 - lost29;
                const float lost32 = one6 + two6;
                const float total33 = -total30 + total32;
                const float back20 = -total32 + total33;
                const float rest8 = -back20 + total33;
                const float one7 = -rest8 + total32;
                const float two7 = -back20 - total30;
                const float lost33 = one7 + two7;
                const float total34 = -lost2 + total33;
                const float back21 = -total33 + total34;
                const float rest9 = -back21 + total34;
                const float one8 = -rest9 + total33;
                const float two8 = -back21 - lost2;
                const float lost34 = one8 + two8;
                const float low2 = -lost30 + lost31 + lost32 + lost33 + lost34 + 1.1704737e-14f*
                    turns;
                const float total35 = low2 + total34;
                const float total36 = 6.2831855f*count;
                const float total37 = root + total36;
                const float whole32 = (total37 == 0.0f ? 1.0f : total37);
                const float total38 = total35/whole32;
                const float far = (total38*total38);
                if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float back22 = -total34 + total35;
                    const float rest10 = -back22 + total35;
                    const float one9 = -rest10 + total34;
                    const float two9 = -back22 + low2;
                    const float lost35 = one9 + two9;
                    const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                    const float back23 = -root + total37;
                    const float rest11 = -back23 + total37;
                    const float one10 = -rest11 + root;
                    const float two10 = -back23 + total36;
                    const float lost37 = one10 + two10;
                    const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                    const float left19 = total35 - total38*whole32;
                    const float left20 = left19 - fmaf(total38, whole32, -(total38*whole32));
                    const float left21 = -both_low*total38 + left20 + lost35;
                    const float lost38 = left21/whole32;
                    const float eta = total38;
                    const float eta_low = lost38;
                    const float total39 = (eta*eta);
                    const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                    const float cos_series_of2 = cos_series(-total39);
                    const float bent2 = cos_series_of2*(total39*total39);
                    const float total40 = -bent2 + 0.5f*total39;
                    const float back24 = -0.5f*total39 + total40;
                    const float lost40 = -back24 - bent2;
                    const float sin_series_of2 = sin_series(-total39);
                    const float total41 = -sin_series_of2*total39 + 1.0f;
                    const float back25 = total41 - 1.0f;
                    const float lost41 = -back25 - sin_series_of2*total39;
                    const float lift_low = 0.5f*lost39*total41 + lost40;
                    const float total42 = eta*total41;
                    const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                    const float some2 = root;
                    const float total43 = total42/some2;
                    const float left22 = -some2*total43 + total42;
                    const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                    const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*
                        total43;
                    const float lost43 = left24/some2;
                    const float given4 = half;
                    const float total44 = 1.0f - 0.5f*given4;
                    const float back26 = total44 - 1.0f;
                    const float lost44 = -back26 - 0.5f*given4;
                    const float decay_series_of3 = decay_series(given4);
                    const float curved4 = decay_series_of3*(given4*given4);
                    const float total45 = curved4 + total44;
                    const float back27 = -total44 + total45;
                    const float lost45 = -back27 + curved4;
                    const float mean_low5 = lost44 + lost45;
                    const float total46 = given4*total45;
                    const float lost46 = given4*mean_low5 +
                        fmaf(given4, total45, -(given4*total45));
                    const float total47 = 1.0f - total46;
                    const float back28 = total47 - 1.0f;
                    const float lost47 = -back28 - total46;
                    const float fall_low5 = -lost46 + lost47;
                    const float total48 = -total43 + total45;
                    const float back29 = -total45 + total48;
                    const float rest12 = -back29 + total48;
                    const float one11 = -rest12 + total45;
                    const float two11 = -back29 - total43;
                    const float lost48 = one11 + two11;
                    const float total49 = given4*total48;
                    const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                        fmaf(given4, total48, -(given4*total48));
                    const float total50 = total40 - total49;
                    const float back30 = -total40 + total50;
                    const float rest13 = -back30 + total50;
                    const float one12 = -rest13 + total40;
                    const float two12 = -back30 - total49;
                    const float lost50 = one12 + two12;
                    const float low22 = lift_low - lost49 + lost50;
                    const float total51 = low22 + total50;
                    const float back31 = -total50 + total51;
                    const float rest14 = -back31 + total51;
                    const float one13 = -rest14 + total50;
                    const float two13 = -back31 + low22;
                    const float lost51 = one13 + two13;
                    const float total52 = total47*total51;
                    const float lost52 = lost51*total47 +
                        fmaf(total47, total51, -(total47*total51));
                    const float low3 = fall_low5*total51 + lost52;
                    const float total53 = total52/stiff;
                    const float left25 = -stiff*total53 + total52;
                    const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                    const float left27 = left26 + low3;
                    const float lost53 = left27/stiff;
                    const float total472 = total43*total47;
                    const float lost472 = lost43*total47 +
                        fmaf(total47, total43, -(total47*total43));
                    const float total482 = total45 - total472;
                    const float back292 = -total45 + total482;
                    const float rest112 = -back292 + total482;
                    const float one102 = -rest112 + total45;
                    const float two102 = -back292 - total472;
                    const float lost482 = one102 + two102;
                    const float low23 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                    const float total492 = given4*total482;
                    const float lost492 = given4*low23 + fmaf(given4, total482, -(given4*total482));
                    const float total502 = total40*total47;
                    const float lost502 = lift_low*total47 +
                        fmaf(total47, total40, -(total47*total40));
                    const float total512 = total492 + total502;
                    const float back302 = -total492 + total512;
                    const float rest122 = -back302 + total512;
                    const float one112 = -rest122 + total492;
                    const float two112 = -back302 + total502;
                    const float lost512 = one112 + two112;
                    const float low32 = fall_low5*total40 + lost492 + lost502 + lost512;
                    const float total522 = total512/stiff;
                    const float left252 = -stiff*total522 + total512;
                    const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                    const float left272 = left262 + low32;
                    const float lost522 = left272/stiff;
                    apart_of = lost28 + total28;
                    fall_of = lost53 + total53;
                    kick_of = total222;
                    kick_low_of = lost222;
                    rise_of = lost522 + total522;
                } else {
                    const float total23 = half*odd;
                    const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                    float even;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even = total20;
                        even_low2 = even_low;
                    } else {
                        const float sign_low = -lost2;
                        const float left = -(root*root) + size;
                        const float left2 = left - fmaf(root, root, -(root*root));
                        const float left3 = left2 + sign_low;
                        const float whole = (root == 0.0f ? 1.0f : root);
                        const float root_low = 0.5f*left3/whole;
                        const float sine = sinf(root);
                        const float cosine = cosf(root);
                        even = cosine;
                        even_low2 = -root_low*sine;
                    }
                    const float total252 = -even + total23;
                    const float back162 = -total23 + total252;
                    const float rest42 = -back162 + total252;
                    const float one32 = -rest42 + total23;
                    const float two32 = -back162 - even;
                    const float lost252 = one32 + two32;
                    const float total262 = envelope + total252;
                    const float back172 = -total252 + total262;
                    const float rest52 = -back172 + total262;
                    const float one42 = -rest52 + total252;
                    const float two42 = -back172 + envelope;
                    const float lost262 = one42 + two42;
                    const float total272 = envelope*total262;
                    const float lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                        fmaf(envelope, total262, -(envelope*total262));
                    const float total282 = total272/stiff;
                    const float left16 = -stiff*total282 + total272;
                    const float left17 = left16 - fmaf(total282, stiff, -(total282*stiff));
                    const float left18 = left17 + lost272;
                    const float lost282 = left18/stiff;
                    const float total242 = even + total23;
                    const float back164 = -even + total242;
                    const float rest43 = -back164 + total242;
                    const float one33 = even - rest43;
                    const float two33 = -back164 + total23;
                    const float lost242 = one33 + two33;
                    const float total253 = envelope*total242;
                    const float lost253 = envelope*(even_low2 + lost23 + lost242) +
                        fmaf(envelope, total242, -(envelope*total242));
                    const float total263 = 1.0f - total253;
                    const float back173 = total263 - 1.0f;
                    const float lost263 = -back173 - total253;
                    const float total273 = total263/stiff;
                    const float left162 = -stiff*total273 + total263;
                    const float left172 = left162 - fmaf(total273, stiff, -(total273*stiff));
                    const float left182 = left172 - lost253 + lost263;
                    const float lost273 = left182/stiff;
                    apart_of = lost28 + total28;
                    fall_of = lost282 + total282;
                    kick_of = total222;
                    kick_low_of = lost222;
                    rise_of = lost273 + total273;
                }
            }
        } else {
            const float size = fabsf(total2);
            const float root = sqrtf(size);
            const float square2 = total2;
            const float envelope = expf(-half);
            const float stiff = gamma;
            const float mean3 = decay(delta);
            float odd;
            float odd_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float sin_series_of = sin_series(given3);
                const float bent = given3*sin_series_of;
                const float total21 = bent + 1.0f;
                const float back15 = total21 - 1.0f;
                const float lost21 = -back15 + bent;
                const float odd_low = 0.16666667f*lost2 + lost21;
                odd = total21;
                odd_low2 = odd_low;
            } else {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                const float some = root;
                const float total22 = sine/some;
                const float left10 = sine - some*total22;
                const float left11 = left10 - fmaf(total22, some, -(total22*some));
                const float left12 = cosine*root_low + left11 - root_low*total22;
                const float lost22 = left12/some;
                odd = total22;
                odd_low2 = lost22;
            }
            const float total24 = envelope*odd;
            const float lost24 = envelope*odd_low2 + fmaf(envelope, odd, -(envelope*odd));
            const float total25 = mean3 - total24;
            const float back16 = -mean3 + total25;
            const float rest4 = -back16 + total25;
            const float one3 = mean3 - rest4;
            const float two3 = -back16 - total24;
            const float lost25 = one3 + two3;
            const float total26 = total25/stiff;
            const float left13 = -stiff*total26 + total25;
            const float left14 = left13 - fmaf(total26, stiff, -(total26*stiff));
            const float left15 = left14 - lost24 + lost25;
            const float lost26 = left15/stiff;
            const float total222 = lost24 + total24;
            const float back152 = total222 - total24;
            const float lost222 = -back152 + lost24;
            float count;
            if (root < 4096.0f) {
                count = floorf(0.5f*root/3.1415927f + 0.5f);
            } else {
                count = 0.0f;
            }
            const float turns = (count*count);
            const float total29 = 39.478416f*turns;
            const float lost29 = fmaf(turns, 39.478416f, -(turns*39.478416f));
            const float total30 = 1.1614864e-06f*turns;
            const float lost30 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
            const float total31 = -total2 - total29;
            const float back18 = total2 + total31;
            const float rest62 = -back18 + total31;
            const float one5 = -rest62 - total2;
            const float two5 = -back18 - total29;
            const float lost31 = one5 + two5;
            const float total32 = -lost29 + total31;
            const float back19 = -total31 + total32;
            const float rest7 = -back19 + total32;
            const float one6 = -rest7 + total31;
            const float two6 = -back19 - lost29;
            const float lost32 = one6 + two6;
            const float total33 = -total30 + total32;
            const float back20 = -total32 + total33;
            const float rest8 = -back20 + total33;
            const float one7 = -rest8 + total32;
            const float two7 = -back20 - total30;
            const float lost33 = one7 + two7;
            const float total34 = -lost2 + total33;
            const float back21 = -total33 + total34;
            const float rest9 = -back21 + total34;
            const float one8 = -rest9 + total33;
            const float two8 = -back21 - lost2;
            const float lost34 = one8 + two8;
            const float low2 = -lost30 + lost31 + lost32 + lost33 + lost34 + 1.1704737e-14f*turns;
            const float total35 = low2 + total34;
            const float total36 = 6.2831855f*count;
            const float total37 = root + total36;
            const float whole32 = (total37 == 0.0f ? 1.0f : total37);
            const float total38 = total35/whole32;
            const float far = (total38*total38);
            if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back22 = -total34 + total35;
                const float rest10 = -back22 + total35;
                const float one9 = -rest10 + total34;
                const float two9 = -back22 + low2;
                const float lost35 = one9 + two9;
                const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                const float back23 = -root + total37;
                const float rest11 = -back23 + total37;
                const float one10 = -rest11 + root;
                const float two10 = -back23 + total36;
                const float lost37 = one10 + two10;
                const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                const float left19 = total35 - total38*whole32;
                const float left20 = left19 - fmaf(total38, whole32, -(total38*whole32));
                const float left21 = -both_low*total38 + left20 + lost35;
                const float lost38 = left21/whole32;
                const float eta = total38;
                const float eta_low = lost38;
                const float total39 = (eta*eta);
                const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                const float cos_series_of2 = cos_series(-total39);
                const float bent2 = cos_series_of2*(total39*total39);
                const float total40 = -bent2 + 0.5f*total39;
                const float back24 = -0.5f*total39 + total40;
                const float lost40 = -back24 - bent2;
                const float sin_series_of2 = sin_series(-total39);
                const float total41 = -sin_series_of2*total39 + 1.0f;
                const float back25 = total41 - 1.0f;
                const float lost41 = -back25 - sin_series_of2*total39;
                const float lift_low = 0.5f*lost39*total41 + lost40;
                const float total42 = eta*total41;
                const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                const float some2 = root;
                const float total43 = total42/some2;
                const float left22 = -some2*total43 + total42;
                const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*total43;
                const float lost43 = left24/some2;
                const float given4 = half;
                const float total44 = 1.0f - 0.5f*given4;
                const float back26 = total44 - 1.0f;
                const float lost44 = -back26 - 0.5f*given4;
                const float decay_series_of3 = decay_series(given4);
                const float curved4 = decay_series_of3*(given4*given4);
                const float total45 = curved4 + total44;
                const float back27 = -total44 + total45;
                const float lost45 = -back27 + curved4;
                const float mean_low5 = lost44 + lost45;
                const float total46 = given4*total45;
                const float lost46 = given4*mean_low5 + fmaf(given4, total45, -(given4*total45));
                const float total47 = 1.0f - total46;
                const float back28 = total47 - 1.0f;
                const float lost47 = -back28 - total46;
                const float fall_low5 = -lost46 + lost47;
                const float total48 = -total43 + total45;
                const float back29 = -total45 + total48;
                const float rest12 = -back29 + total48;
                const float one11 = -rest12 + total45;
                const float two11 = -back29 - total43;
                const float lost48 = one11 + two11;
                const float total49 = given4*total48;
                const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                    fmaf(given4, total48, -(given4*total48));
                const float total50 = total40 - total49;
                const float back30 = -total40 + total50;
                const float rest13 = -back30 + total50;
                const float one12 = -rest13 + total40;
                const float two12 = -back30 - total49;
                const float lost50 = one12 + two12;
                const float low22 = lift_low - lost49 + lost50;
                const float total51 = low22 + total50;
                const float back31 = -total50 + total51;
                const float rest14 = -back31 + total51;
                const float one13 = -rest14 + total50;
                const float two13 = -back31 + low22;
                const float lost51 = one13 + two13;
                const float total52 = total47*total51;
                const float lost52 = lost51*total47 + fmaf(total47, total51, -(total47*total51));
                const float low3 = fall_low5*total51 + lost52;
                const float total53 = total52/stiff;
                const float left25 = -stiff*total53 + total52;
                const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                const float left27 = left26 + low3;
                const float lost53 = left27/stiff;
                const float total472 = total43*total47;
                const float lost472 = lost43*total47 + fmaf(total47, total43, -(total47*total43));
                const float total482 = total45 - total472;
                const float back292 = -total45 + total482;
                const float rest112 = -back292 + total482;
                const float one102 = -rest112 + total45;
                const float two102 = -back292 - total472;
                const float lost482 = one102 + two102;
                const float low23 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                const float total492 = given4*total482;
                const float lost492 = given4*low23 + fmaf(given4, total482, -(given4*total482));
                const float total502 = total40*total47;
                const float lost502 = lift_low*total47 + fmaf(total47, total40, -(total47*total40));
                const float total512 = total492 + total502;
                const float back302 = -total492 + total512;
                const float rest122 = -back302 + total512;
                const float one112 = -rest122 + total492;
                const float two112 = -back302 + total502;
                const float lost512 = one112 + two112;
                const float low32 = fall_low5*total40 + lost492 + lost502 + lost512;
                const float total522 = total512/stiff;
                const float left252 = -stiff*total522 + total512;
                const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                const float left272 = left262 + low32;
                const float lost522 = left272/stiff;
                apart_of = lost26 + total26;
                fall_of = lost53 + total53;
                kick_of = total222;
                kick_low_of = lost222;
                rise_of = lost522 + total522;
            } else {
                const float total23 = half*odd;
                const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                float even;
                float even_low2;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float total19 = 0.5f*given3 + 1.0f;
                    const float back13 = total19 - 1.0f;
                    const float lost19 = -back13 + 0.5f*given3;
                    const float cos_series_of = cos_series(given3);
                    const float curved3 = cos_series_of*(given3*given3);
                    const float total20 = curved3 + total19;
                    const float back14 = -total19 + total20;
                    const float lost20 = -back14 + curved3;
                    const float even_low = lost19 + 0.5f*lost2 + lost20;
                    even = total20;
                    even_low2 = even_low;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float sine = sinf(root);
                    const float cosine = cosf(root);
                    even = cosine;
                    even_low2 = -root_low*sine;
                }
                const float total252 = -even + total23;
                const float back162 = -total23 + total252;
                const float rest42 = -back162 + total252;
                const float one32 = -rest42 + total23;
                const float two32 = -back162 - even;
                const float lost252 = one32 + two32;
                const float total262 = envelope + total252;
                const float back172 = -total252 + total262;
                const float rest52 = -back172 + total262;
                const float one42 = -rest52 + total252;
                const float two42 = -back172 + envelope;
                const float lost262 = one42 + two42;
                const float total272 = envelope*total262;
                const float lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                    fmaf(envelope, total262, -(envelope*total262));
                const float total282 = total272/stiff;
                const float left16 = -stiff*total282 + total272;
                const float left17 = left16 - fmaf(total282, stiff, -(total282*stiff));
                const float left18 = left17 + lost272;
                const float lost282 = left18/stiff;
                const float total242 = even + total23;
                const float back164 = -even + total242;
                const float rest43 = -back164 + total242;
                const float one33 = even - rest43;
                const float two33 = -back164 + total23;
                const float lost242 = one33 + two33;
                const float total253 = envelope*total242;
                const float lost253 = envelope*(even_low2 + lost23 + lost242) +
                    fmaf(envelope, total242, -(envelope*total242));
                const float total263 = 1.0f - total253;
                const float back173 = total263 - 1.0f;
                const float lost263 = -back173 - total253;
                const float total273 = total263/stiff;
                const float left162 = -stiff*total273 + total263;
                const float left172 = left162 - fmaf(total273, stiff, -(total273*stiff));
                const float left182 = left172 - lost253 + lost263;
                const float lost273 = left182/stiff;
                apart_of = lost26 + total26;
                fall_of = lost282 + total282;
                kick_of = total222;
                kick_low_of = lost222;
                rise_of = lost273 + total273;
            }
        }
    } else {
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        const float total3 = half + root;
        const float reach = 0.44444445f*total3;
        if (reach < 1.0f) {
            if (reach < 0.5625f) {
                const float sign_low = lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back3 = -half + total3;
                const float lost3 = -back3 + root;
                const float p_low = lost3 + root_low;
                const float whole2 = (total3 == 0.0f ? 1.0f : total3);
                const float q = gamma/whole2;
                const float off = gamma - q*whole2;
                const float off2 = off - fmaf(whole2, q, -(whole2*q));
                const float off3 = off2 - p_low*q;
                const float q_low = off3/whole2;
                const float rate2 = 2.0f*root;
                const float envelope = expf(-half);
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                const float given5 = 0.5f*half;
                const float total54 = 1.0f - 0.5f*given5;
                const float back32 = total54 - 1.0f;
                const float lost54 = -back32 - 0.5f*given5;
                const float decay_series_of4 = decay_series(given5);
                const float curved5 = decay_series_of4*(given5*given5);
                const float total55 = curved5 + total54;
                const float back33 = -total54 + total55;
                const float lost55 = -back33 + curved5;
                const float mean_low6 = lost54 + lost55;
                const float total56 = given5*total55;
                const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
                const float total57 = 1.0f - total56;
                const float back34 = total57 - 1.0f;
                const float lost57 = -back34 - total56;
                const float fall_low6 = -lost56 + lost57;
                const float total58 = (total57*total57);
                const float lost58 = 2.0f*fall_low6*total57 +
                    fmaf(total57, total57, -(total57*total57));
                const float total59 = (total58*total58);
                const float lost59 = 2.0f*lost58*total58 +
                    fmaf(total58, total58, -(total58*total58));
                const float rest15 = fall_series(gamma, delta);
                const float total60 = rest15 + 0.5f;
                const float back35 = -rest15 + total60;
                const float rest16 = -back35 + total60;
                const float one14 = rest15 - rest16;
                const float two14 = 0.5f - back35;
                const float lost60 = one14 + two14;
                const float total61 = total59*total60;
                const float lost61 = lost60*total59 + fmaf(total59, total60, -(total59*total60));
                const float half2 = half;
                const float given52 = 0.5f*half2;
                const float total532 = 1.0f - 0.5f*given52;
                const float back312 = total532 - 1.0f;
                const float lost532 = -back312 - 0.5f*given52;
                const float decay_series_of5 = decay_series(given52);
                const float curved52 = decay_series_of5*(given52*given52);
                const float total542 = curved52 + total532;
                const float back322 = -total532 + total542;
                const float lost542 = -back322 + curved52;
                const float mean_low62 = lost532 + lost542;
                const float total552 = given52*total542;
                const float lost552 = given52*mean_low62 +
                    fmaf(given52, total542, -(given52*total542));
                const float total562 = 1.0f - total552;
                const float back332 = total562 - 1.0f;
                const float lost562 = -back332 - total552;
                const float fall_low62 = -lost552 + lost562;
                const float total572 = (total562*total562);
                const float lost572 = 2.0f*fall_low62*total562 +
                    fmaf(total562, total562, -(total562*total562));
                const float rest132 = rise_series(half2, total2);
                const float total582 = rest132 + 0.5f;
                const float back342 = -rest132 + total582;
                const float rest142 = -back342 + total582;
                const float one122 = rest132 - rest142;
                const float two122 = 0.5f - back342;
                const float lost582 = one122 + two122;
                const float total592 = total572*total582;
                const float lost592 = lost582*total572 +
                    fmaf(total572, total582, -(total572*total582));
                float fall_;
                float fall_low2;
                if (q < 0.75f) {
                    const float given = q;
                    const float total4 = 1.0f - 0.5f*given;
                    const float back4 = total4 - 1.0f;
                    const float lost4 = -back4 - 0.5f*given;
                    const float decay_series_of = decay_series(given);
                    const float curved = decay_series_of*(given*given);
                    const float total5 = curved + total4;
                    const float back5 = -total4 + total5;
                    const float lost5 = -back5 + curved;
                    const float mean_low = lost4 + lost5 - q_low*
                        (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                    const float total6 = given*total5;
                    const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                    const float total7 = 1.0f - total6;
                    const float back6 = total7 - 1.0f;
                    const float lost7 = -back6 - total6;
                    const float fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                } else {
                    const float sunk = expf(-q);
                    const float sunk_low = -q_low*sunk;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                }
                float mean2;
                float mean_low4;
                if (rate2 < 0.75f) {
                    const float given2 = 2.0f*root;
                    const float total10 = 1.0f - 0.5f*given2;
                    const float back8 = total10 - 1.0f;
                    const float lost10 = -back8 - 0.5f*given2;
                    const float decay_series_of2 = decay_series(given2);
                    const float curved2 = decay_series_of2*(given2*given2);
                    const float total11 = curved2 + total10;
                    const float back9 = -total10 + total11;
                    const float lost11 = -back9 + curved2;
                    const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                        (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                    mean2 = total11;
                    mean_low4 = mean_low3;
                } else {
                    const float sunk2 = expf(-2.0f*root);
                    const float sunk_low2 = -2.0f*root_low*sunk2;
                    const float total14 = 1.0f - sunk2;
                    const float back11 = total14 - 1.0f;
                    const float lost14 = -back11 - sunk2;
                    const float bottom2 = 2.0f*root;
                    const float total15 = total14/bottom2;
                    const float left7 = -bottom2*total15 + total14;
                    const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                    const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                    const float lost15 = left9/bottom2;
                    mean2 = total15;
                    mean_low4 = lost15;
                }
                const float total163 = fall_*mean2;
                const float lost163 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
                const float creep_low = fall_low2*mean2 + lost163;
                const float total232 = creep_low + total163;
                const float back163 = -total163 + total232;
                const float lost232 = -back163 + creep_low;
                apart_of = lost28 + total28;
                fall_of = lost59*total60 + lost61 + total61;
                kick_of = total232;
                kick_low_of = lost232;
                rise_of = lost572*total582 + lost592 + total592;
            } else {
                const float sign_low = lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back3 = -half + total3;
                const float lost3 = -back3 + root;
                const float p_low = lost3 + root_low;
                const float whole2 = (total3 == 0.0f ? 1.0f : total3);
                const float q = gamma/whole2;
                const float off = gamma - q*whole2;
                const float off2 = off - fmaf(whole2, q, -(whole2*q));
                const float off3 = off2 - p_low*q;
                const float q_low = off3/whole2;
                const float rate2 = 2.0f*root;
                const float envelope = expf(-half);
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                float fall_;
                float fall_low2;
                float mean;
                float mean_low2;
                if (q < 0.75f) {
                    const float given = q;
                    const float total4 = 1.0f - 0.5f*given;
                    const float back4 = total4 - 1.0f;
                    const float lost4 = -back4 - 0.5f*given;
                    const float decay_series_of = decay_series(given);
                    const float curved = decay_series_of*(given*given);
                    const float total5 = curved + total4;
                    const float back5 = -total4 + total5;
                    const float lost5 = -back5 + curved;
                    const float mean_low = lost4 + lost5 - q_low*
                        (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                    const float total6 = given*total5;
                    const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                    const float total7 = 1.0f - total6;
                    const float back6 = total7 - 1.0f;
                    const float lost7 = -back6 - total6;
                    const float fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                    mean = total5;
                    mean_low2 = mean_low;
                } else {
                    const float sunk = expf(-q);
                    const float sunk_low = -q_low*sunk;
                    const float total8 = 1.0f - sunk;
                    const float back7 = total8 - 1.0f;
                    const float lost8 = -back7 - sunk;
                    const float bottom = q;
                    const float total9 = total8/bottom;
                    const float left4 = -bottom*total9 + total8;
                    const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                    const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                    const float lost9 = left6/bottom;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                    mean = total9;
                    mean_low2 = lost9;
                }
                float fall2;
                float fall_low4;
                float mean2;
                float mean_low4;
                if (rate2 < 0.75f) {
                    const float given2 = 2.0f*root;
                    const float total10 = 1.0f - 0.5f*given2;
                    const float back8 = total10 - 1.0f;
                    const float lost10 = -back8 - 0.5f*given2;
                    const float decay_series_of2 = decay_series(given2);
                    const float curved2 = decay_series_of2*(given2*given2);
                    const float total11 = curved2 + total10;
                    const float back9 = -total10 + total11;
                    const float lost11 = -back9 + curved2;
                    const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                        (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                    const float total12 = given2*total11;
                    const float lost12 = given2*mean_low3 +
                        fmaf(given2, total11, -(given2*total11));
                    const float total13 = 1.0f - total12;
                    const float back10 = total13 - 1.0f;
                    const float lost13 = -back10 - total12;
                    const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                    fall2 = total13;
                    fall_low4 = fall_low3;
                    mean2 = total11;
                    mean_low4 = mean_low3;
                } else {
                    const float sunk2 = expf(-2.0f*root);
                    const float sunk_low2 = -2.0f*root_low*sunk2;
                    const float total14 = 1.0f - sunk2;
                    const float back11 = total14 - 1.0f;
                    const float lost14 = -back11 - sunk2;
                    const float bottom2 = 2.0f*root;
                    const float total15 = total14/bottom2;
                    const float left7 = -bottom2*total15 + total14;
                    const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                    const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                    const float lost15 = left9/bottom2;
                    fall2 = sunk2;
                    fall_low4 = sunk_low2;
                    mean2 = total15;
                    mean_low4 = lost15;
                }
                const float total162 = fall2*mean;
                const float lost162 = fall2*mean_low2 + fmaf(fall2, mean, -(fall2*mean));
                const float pulled_low = fall_low4*mean + lost162;
                const float total172 = mean2 - total162;
                const float back122 = -mean2 + total172;
                const float rest32 = -back122 + total172;
                const float one22 = mean2 - rest32;
                const float two22 = -back122 - total162;
                const float lost172 = one22 + two22;
                const float total182 = total172/whole2;
                const float left102 = total172 - total182*whole2;
                const float left112 = left102 - fmaf(total182, whole2, -(total182*whole2));
                const float left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
                const float lost182 = left122/whole2;
                const float total192 = fall_*total182;
                const float lost192 = fall_*lost182 + fmaf(fall_, total182, -(fall_*total182));
                const float creep_ = fall_low2*total182 + lost192 + total192;
                const float total163 = fall_*mean2;
                const float lost163 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
                const float creep_low = fall_low2*mean2 + lost163;
                const float total232 = creep_low + total163;
                const float back163 = -total163 + total232;
                const float lost232 = -back163 + creep_low;
                const float total173 = mean - total163;
                const float back123 = -mean + total173;
                const float rest33 = -back123 + total173;
                const float one23 = mean - rest33;
                const float two23 = -back123 - total163;
                const float lost173 = one23 + two23;
                const float total183 = total173/whole2;
                const float left103 = total173 - total183*whole2;
                const float left113 = left103 - fmaf(total183, whole2, -(total183*whole2));
                const float left123 = -creep_low + left113 + lost173 + mean_low2 - p_low*total183;
                const float lost183 = left123/whole2;
                apart_of = lost28 + total28;
                fall_of = creep_;
                kick_of = total232;
                kick_low_of = lost232;
                rise_of = lost183 + total183;
            }
        } else {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            const float whole3 = (delta*total3 == 0.0f ? 1.0f : delta*total3);
            float fall_;
            float fall_low2;
            float mean;
            float mean_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                const float total8 = 1.0f - sunk;
                const float back7 = total8 - 1.0f;
                const float lost8 = -back7 - sunk;
                const float bottom = q;
                const float total9 = total8/bottom;
                const float left4 = -bottom*total9 + total8;
                const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const float lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            const float twice = 2.0f*fall_;
            float fall2;
            float fall_low4;
            float mean2;
            float mean_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                const float total14 = 1.0f - sunk2;
                const float back11 = total14 - 1.0f;
                const float lost14 = -back11 - sunk2;
                const float bottom2 = 2.0f*root;
                const float total15 = total14/bottom2;
                const float left7 = -bottom2*total15 + total14;
                const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                const float lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const float fast = fall_*fall2;
            const float total16 = mean2*twice;
            const float lost16 = mean_low4*twice + fmaf(twice, mean2, -(twice*mean2));
            const float total17 = mean - total16;
            const float back12 = -mean + total17;
            const float rest3 = -back12 + total17;
            const float one2 = mean - rest3;
            const float two2 = -back12 - total16;
            const float lost17 = one2 + two2;
            const float total18 = fast*mean;
            const float lost18 = fast*mean_low2 + fmaf(fast, mean, -(fast*mean));
            const float top = total17 + total18;
            const float low = -lost16 + lost17 + lost18 + mean_low2;
            const float total162 = fall2*mean;
            const float lost162 = fall2*mean_low2 + fmaf(fall2, mean, -(fall2*mean));
            const float pulled_low = fall_low4*mean + lost162;
            const float total172 = mean2 - total162;
            const float back122 = -mean2 + total172;
            const float rest32 = -back122 + total172;
            const float one22 = mean2 - rest32;
            const float two22 = -back122 - total162;
            const float lost172 = one22 + two22;
            const float total182 = total172/whole2;
            const float left102 = total172 - total182*whole2;
            const float left112 = left102 - fmaf(total182, whole2, -(total182*whole2));
            const float left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
            const float lost182 = left122/whole2;
            const float total192 = fall_*total182;
            const float lost192 = fall_*lost182 + fmaf(fall_, total182, -(fall_*total182));
            const float creep_ = fall_low2*total182 + lost192 + total192;
            const float total163 = fall_*mean2;
            const float lost163 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
            const float creep_low = fall_low2*mean2 + lost163;
            const float total232 = creep_low + total163;
            const float back163 = -total163 + total232;
            const float lost232 = -back163 + creep_low;
            const float total173 = mean - total163;
            const float back123 = -mean + total173;
            const float rest33 = -back123 + total173;
            const float one23 = mean - rest33;
            const float two23 = -back123 - total163;
            const float lost173 = one23 + two23;
            const float total183 = total173/whole2;
            const float left103 = total173 - total183*whole2;
            const float left113 = left103 - fmaf(total183, whole2, -(total183*whole2));
            const float left123 = -creep_low + left113 + lost173 + mean_low2 - p_low*total183;
            const float lost183 = left123/whole2;
            apart_of = (low + top)/whole3;
            fall_of = creep_;
            kick_of = total232;
            kick_low_of = lost232;
            rise_of = lost183 + total183;
        }
    }
    *apart_out = apart_of;
    *fall_out = fall_of;
    *kick_out = kick_of;
    *kick_low_out = kick_low_of;
    *rise_out = rise_of;
    return;
}

// (n1 - n0)/delta; n0, the same device with its time reversed, times exp(-delta); 1 + a + e; n1,
// how far a unit force moves the device in a period; n1 + n0
static void apart_fall_nyquist_rise_together(float gamma, float delta, float *apart_out,
    float *fall_out, float *nyquist_out, float *rise_out, float *together_out) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    float apart_of;
    float fall_of;
    float nyquist_of;
    float rise_of;
    float together_of;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 1.0f) {
            if (reach < 0.5625f) {
                const float square2 = total2;
                const float envelope = expf(-half);
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                const float given5 = 0.5f*half;
                const float total54 = 1.0f - 0.5f*given5;
                const float back32 = total54 - 1.0f;
                const float lost54 = -back32 - 0.5f*given5;
                const float decay_series_of4 = decay_series(given5);
                const float curved5 = decay_series_of4*(given5*given5);
                const float total55 = curved5 + total54;
                const float back33 = -total54 + total55;
                const float lost55 = -back33 + curved5;
                const float mean_low6 = lost54 + lost55;
                const float total56 = given5*total55;
                const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
                const float total57 = 1.0f - total56;
                const float back34 = total57 - 1.0f;
                const float lost57 = -back34 - total56;
                const float fall_low6 = -lost56 + lost57;
                const float total58 = (total57*total57);
                const float lost58 = 2.0f*fall_low6*total57 +
                    fmaf(total57, total57, -(total57*total57));
                const float total59 = (total58*total58);
                const float lost59 = 2.0f*lost58*total58 +
                    fmaf(total58, total58, -(total58*total58));
                const float rest15 = fall_series(gamma, delta);
                const float total60 = rest15 + 0.5f;
                const float back35 = -rest15 + total60;
                const float rest16 = -back35 + total60;
                const float one14 = rest15 - rest16;
                const float two14 = 0.5f - back35;
                const float lost60 = one14 + two14;
                const float total61 = total59*total60;
                const float lost61 = lost60*total59 + fmaf(total59, total60, -(total59*total60));
                const float twice2 = 2.0f*envelope;
                const float half2 = half;
                const float given52 = 0.5f*half2;
                const float total532 = 1.0f - 0.5f*given52;
                const float back312 = total532 - 1.0f;
                const float lost532 = -back312 - 0.5f*given52;
                const float decay_series_of5 = decay_series(given52);
                const float curved52 = decay_series_of5*(given52*given52);
                const float total542 = curved52 + total532;
                const float back322 = -total532 + total542;
                const float lost542 = -back322 + curved52;
                const float mean_low62 = lost532 + lost542;
                const float total552 = given52*total542;
                const float lost552 = given52*mean_low62 +
                    fmaf(given52, total542, -(given52*total542));
                const float total562 = 1.0f - total552;
                const float back332 = total562 - 1.0f;
                const float lost562 = -back332 - total552;
                const float fall_low62 = -lost552 + lost562;
                const float total572 = (total562*total562);
                const float lost572 = 2.0f*fall_low62*total562 +
                    fmaf(total562, total562, -(total562*total562));
                const float rest132 = rise_series(half2, total2);
                const float total582 = rest132 + 0.5f;
                const float back342 = -rest132 + total582;
                const float rest142 = -back342 + total582;
                const float one122 = rest132 - rest142;
                const float two122 = 0.5f - back342;
                const float lost582 = one122 + two122;
                const float total592 = total572*total582;
                const float lost592 = lost582*total572 +
                    fmaf(total572, total582, -(total572*total582));
                const float rest123 = together_series(half, total2);
                const float total553 = rest123 + 0.5f;
                const float back333 = -rest123 + total553;
                const float rest133 = -back333 + total553;
                const float one113 = rest123 - rest133;
                const float two113 = 0.5f - back333;
                const float lost553 = one113 + two113;
                const float total563 = envelope*total553;
                const float lost563 = envelope*lost553 +
                    fmaf(envelope, total553, -(envelope*total553));
                float even;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float total19 = 0.5f*given3 + 1.0f;
                    const float cos_series_of = cos_series(given3);
                    const float curved3 = cos_series_of*(given3*given3);
                    const float total20 = curved3 + total19;
                    even = total20;
                } else {
                    const float size = fabsf(total2);
                    const float root = sqrtf(size);
                    const float cosine = cosf(root);
                    even = cosine;
                }
                const float total263 = even*twice2;
                if (total263 > 0.0f) {
                    const float e = expf(-delta);
                    const float total253 = e + 1.0f;
                    const float back182 = total253 - 1.0f;
                    const float lost253 = -back182 + e;
                    const float total273 = total253 + total263;
                    const float back192 = -total253 + total273;
                    const float lost273 = -back192 + total263;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const float size = fabsf(total2);
                        const float root = sqrtf(size);
                        const float sign_low = -lost2;
                        const float left = -(root*root) + size;
                        const float left2 = left - fmaf(root, root, -(root*root));
                        const float left3 = left2 + sign_low;
                        const float whole = (root == 0.0f ? 1.0f : root);
                        const float root_low = 0.5f*left3/whole;
                        const float sine = sinf(root);
                        even_low2 = -root_low*sine;
                    }
                    const float lost263 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                    apart_of = lost28 + total28;
                    fall_of = lost59*total60 + lost61 + total61;
                    nyquist_of = lost253 + lost263 + lost273 + total273;
                    rise_of = lost572*total582 + lost592 + total592;
                    together_of = 2.0f*lost563 + 2.0f*total563;
                } else {
                    const float size = fabsf(total2);
                    const float root = sqrtf(size);
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float back72 = 0.5f*root_low*sin_of;
                    const float total92 = -back72 + wave;
                    const float back82 = total92 - wave;
                    const float rest33 = -back82 + total92;
                    const float one23 = -rest33 + wave;
                    const float two23 = -back72 - back82;
                    const float lost92 = one23 + two23;
                    const float total102 = (total92*total92);
                    const float lost102 = fmaf(total92, total92, -(total92*total92));
                    const float low4 = lost102 + 2.0f*lost92*total92;
                    const float total112 = envelope*total102;
                    const float lost112 = envelope*low4 +
                        fmaf(envelope, total102, -(envelope*total102));
                    const float total122 = (grown*grown) + total112;
                    const float back92 = -total112 + total122;
                    const float rest43 = -back92 + total122;
                    const float one33 = -rest43 + total112;
                    const float two33 = -back92 + (grown*grown);
                    const float lost122 = one33 + two33;
                    const float low23 = lost112 + lost122;
                    apart_of = lost28 + total28;
                    fall_of = lost59*total60 + lost61 + total61;
                    nyquist_of = 4.0f*low23 + 4.0f*total122;
                    rise_of = lost572*total582 + lost592 + total592;
                    together_of = 2.0f*lost563 + 2.0f*total563;
                }
            } else {
                const float size = fabsf(total2);
                const float root = sqrtf(size);
                const float square2 = total2;
                const float envelope = expf(-half);
                const float stiff = gamma;
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                const float twice2 = 2.0f*envelope;
                const float rest123 = together_series(half, total2);
                const float total553 = rest123 + 0.5f;
                const float back333 = -rest123 + total553;
                const float rest133 = -back333 + total553;
                const float one113 = rest123 - rest133;
                const float two113 = 0.5f - back333;
                const float lost553 = one113 + two113;
                const float total563 = envelope*total553;
                const float lost563 = envelope*lost553 +
                    fmaf(envelope, total553, -(envelope*total553));
                float even;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float total19 = 0.5f*given3 + 1.0f;
                    const float cos_series_of = cos_series(given3);
                    const float curved3 = cos_series_of*(given3*given3);
                    const float total20 = curved3 + total19;
                    even = total20;
                } else {
                    const float cosine = cosf(root);
                    even = cosine;
                }
                const float total263 = even*twice2;
                float count;
                if (root < 4096.0f) {
                    count = floorf(0.5f*root/3.1415927f + 0.5f);
                } else {
                    count = 0.0f;
                }
                const float turns = (count*count);
                const float total29 = 39.478416f*turns;
                const float lost29 = fmaf(turns, 39.478416f, -(turns*39.478416f));
                const float total30 = 1.1614864e-06f*turns;
                const float lost30 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
                const float total31 = -total2 - total29;
                const float back18 = total2 + total31;
                const float rest62 = -back18 + total31;
                const float one5 = -rest62 - total2;
                const float two5 = -back18 - total29;
                const float lost31 = one5 + two5;
                const float total32 = -lost29 + total31;
                const float back19 = -total31 + total32;
                const float rest7 = -back19 + total32;
                const float one6 = -rest7 + total31;
                const float two6 = -back19 - lost29;
                const float lost32 = one6 + two6;
                const float total33 = -total30 + total32;
                const float back20 = -total32 + total33;
                const float rest8 = -back20 + total33;
                const float one7 = -rest8 + total32;
                const float two7 = -back20 - total30;
                const float lost33 = one7 + two7;
                const float total34 = -lost2 + total33;
                const float back21 = -total33 + total34;
                const float rest9 = -back21 + total34;
                const float one8 = -rest9 + total33;
                const float two8 = -back21 - lost2;
                const float lost34 = one8 + two8;
                const float low2 = -lost30 + lost31 + lost32 + lost33 + lost34 + 1.1704737e-14f*
                    turns;
                const float total35 = low2 + total34;
                const float total36 = 6.2831855f*count;
                const float total37 = root + total36;
                const float whole32 = (total37 == 0.0f ? 1.0f : total37);
                const float total38 = total35/whole32;
                const float far = (total38*total38);
                if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                    if (total263 > 0.0f) {
                        const float sign_low = -lost2;
                        const float left = -(root*root) + size;
                        const float left2 = left - fmaf(root, root, -(root*root));
                        const float left3 = left2 + sign_low;
                        const float whole = (root == 0.0f ? 1.0f : root);
                        const float root_low = 0.5f*left3/whole;
                        const float back22 = -total34 + total35;
                        const float rest10 = -back22 + total35;
                        const float one9 = -rest10 + total34;
                        const float two9 = -back22 + low2;
                        const float lost35 = one9 + two9;
                        const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                        const float back23 = -root + total37;
                        const float rest11 = -back23 + total37;
                        const float one10 = -rest11 + root;
                        const float two10 = -back23 + total36;
                        const float lost37 = one10 + two10;
                        const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                        const float left19 = total35 - total38*whole32;
                        const float left20 = left19 - fmaf(total38, whole32, -(total38*whole32));
                        const float left21 = -both_low*total38 + left20 + lost35;
                        const float lost38 = left21/whole32;
                        const float eta = total38;
                        const float eta_low = lost38;
                        const float total39 = (eta*eta);
                        const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                        const float cos_series_of2 = cos_series(-total39);
                        const float bent2 = cos_series_of2*(total39*total39);
                        const float total40 = -bent2 + 0.5f*total39;
                        const float back24 = -0.5f*total39 + total40;
                        const float lost40 = -back24 - bent2;
                        const float sin_series_of2 = sin_series(-total39);
                        const float total41 = -sin_series_of2*total39 + 1.0f;
                        const float back25 = total41 - 1.0f;
                        const float lost41 = -back25 - sin_series_of2*total39;
                        const float lift_low = 0.5f*lost39*total41 + lost40;
                        const float total42 = eta*total41;
                        const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                        const float some2 = root;
                        const float total43 = total42/some2;
                        const float left22 = -some2*total43 + total42;
                        const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                        const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*
                            total43;
                        const float lost43 = left24/some2;
                        const float given4 = half;
                        const float total44 = 1.0f - 0.5f*given4;
                        const float back26 = total44 - 1.0f;
                        const float lost44 = -back26 - 0.5f*given4;
                        const float decay_series_of3 = decay_series(given4);
                        const float curved4 = decay_series_of3*(given4*given4);
                        const float total45 = curved4 + total44;
                        const float back27 = -total44 + total45;
                        const float lost45 = -back27 + curved4;
                        const float mean_low5 = lost44 + lost45;
                        const float total46 = given4*total45;
                        const float lost46 = given4*mean_low5 +
                            fmaf(given4, total45, -(given4*total45));
                        const float total47 = 1.0f - total46;
                        const float back28 = total47 - 1.0f;
                        const float lost47 = -back28 - total46;
                        const float fall_low5 = -lost46 + lost47;
                        const float total48 = -total43 + total45;
                        const float back29 = -total45 + total48;
                        const float rest12 = -back29 + total48;
                        const float one11 = -rest12 + total45;
                        const float two11 = -back29 - total43;
                        const float lost48 = one11 + two11;
                        const float total49 = given4*total48;
                        const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                            fmaf(given4, total48, -(given4*total48));
                        const float total50 = total40 - total49;
                        const float back30 = -total40 + total50;
                        const float rest13 = -back30 + total50;
                        const float one12 = -rest13 + total40;
                        const float two12 = -back30 - total49;
                        const float lost50 = one12 + two12;
                        const float low22 = lift_low - lost49 + lost50;
                        const float total51 = low22 + total50;
                        const float back31 = -total50 + total51;
                        const float rest14 = -back31 + total51;
                        const float one13 = -rest14 + total50;
                        const float two13 = -back31 + low22;
                        const float lost51 = one13 + two13;
                        const float total52 = total47*total51;
                        const float lost52 = lost51*total47 +
                            fmaf(total47, total51, -(total47*total51));
                        const float low3 = fall_low5*total51 + lost52;
                        const float total53 = total52/stiff;
                        const float left25 = -stiff*total53 + total52;
                        const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                        const float left27 = left26 + low3;
                        const float lost53 = left27/stiff;
                        const float e = expf(-delta);
                        const float total253 = e + 1.0f;
                        const float back182 = total253 - 1.0f;
                        const float lost253 = -back182 + e;
                        const float total273 = total253 + total263;
                        const float back192 = -total253 + total273;
                        const float lost273 = -back192 + total263;
                        const float total472 = total43*total47;
                        const float lost472 = lost43*total47 +
                            fmaf(total47, total43, -(total47*total43));
                        const float total482 = total45 - total472;
                        const float back292 = -total45 + total482;
                        const float rest112 = -back292 + total482;
                        const float one102 = -rest112 + total45;
                        const float two102 = -back292 - total472;
                        const float lost482 = one102 + two102;
                        const float low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                        const float total492 = given4*total482;
                        const float lost492 = given4*low24 +
                            fmaf(given4, total482, -(given4*total482));
                        const float total502 = total40*total47;
                        const float lost502 = lift_low*total47 +
                            fmaf(total47, total40, -(total47*total40));
                        const float total512 = total492 + total502;
                        const float back302 = -total492 + total512;
                        const float rest122 = -back302 + total512;
                        const float one112 = -rest122 + total492;
                        const float two112 = -back302 + total502;
                        const float lost512 = one112 + two112;
                        const float low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                        const float total522 = total512/stiff;
                        const float left252 = -stiff*total522 + total512;
                        const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                        const float left272 = left262 + low33;
                        const float lost522 = left272/stiff;
                        float even_low2;
                        if (square2 > -1.5f) {
                            const float given3 = square2;
                            const float total19 = 0.5f*given3 + 1.0f;
                            const float back13 = total19 - 1.0f;
                            const float lost19 = -back13 + 0.5f*given3;
                            const float cos_series_of = cos_series(given3);
                            const float curved3 = cos_series_of*(given3*given3);
                            const float total20 = curved3 + total19;
                            const float back14 = -total19 + total20;
                            const float lost20 = -back14 + curved3;
                            const float even_low = lost19 + 0.5f*lost2 + lost20;
                            even_low2 = even_low;
                        } else {
                            const float sine = sinf(root);
                            even_low2 = -root_low*sine;
                        }
                        const float lost263 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                        apart_of = lost28 + total28;
                        fall_of = lost53 + total53;
                        nyquist_of = lost253 + lost263 + lost273 + total273;
                        rise_of = lost522 + total522;
                        together_of = 2.0f*lost563 + 2.0f*total563;
                    } else {
                        const float sign_low = -lost2;
                        const float left = -(root*root) + size;
                        const float left2 = left - fmaf(root, root, -(root*root));
                        const float left3 = left2 + sign_low;
                        const float whole = (root == 0.0f ? 1.0f : root);
                        const float root_low = 0.5f*left3/whole;
                        const float back22 = -total34 + total35;
                        const float rest10 = -back22 + total35;
                        const float one9 = -rest10 + total34;
                        const float two9 = -back22 + low2;
                        const float lost35 = one9 + two9;
                        const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                        const float back23 = -root + total37;
                        const float rest11 = -back23 + total37;
                        const float one10 = -rest11 + root;
                        const float two10 = -back23 + total36;
                        const float lost37 = one10 + two10;
                        const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                        const float left19 = total35 - total38*whole32;
                        const float left20 = left19 - fmaf(total38, whole32, -(total38*whole32));
                        const float left21 = -both_low*total38 + left20 + lost35;
                        const float lost38 = left21/whole32;
                        const float eta = total38;
                        const float eta_low = lost38;
                        const float total39 = (eta*eta);
                        const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                        const float cos_series_of2 = cos_series(-total39);
                        const float bent2 = cos_series_of2*(total39*total39);
                        const float total40 = -bent2 + 0.5f*total39;
                        const float back24 = -0.5f*total39 + total40;
                        const float lost40 = -back24 - bent2;
                        const float sin_series_of2 = sin_series(-total39);
                        const float total41 = -sin_series_of2*total39 + 1.0f;
                        const float back25 = total41 - 1.0f;
                        const float lost41 = -back25 - sin_series_of2*total39;
                        const float lift_low = 0.5f*lost39*total41 + lost40;
                        const float total42 = eta*total41;
                        const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                        const float some2 = root;
                        const float total43 = total42/some2;
                        const float left22 = -some2*total43 + total42;
                        const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                        const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*
                            total43;
                        const float lost43 = left24/some2;
                        const float given4 = half;
                        const float total44 = 1.0f - 0.5f*given4;
                        const float back26 = total44 - 1.0f;
                        const float lost44 = -back26 - 0.5f*given4;
                        const float decay_series_of3 = decay_series(given4);
                        const float curved4 = decay_series_of3*(given4*given4);
                        const float total45 = curved4 + total44;
                        const float back27 = -total44 + total45;
                        const float lost45 = -back27 + curved4;
                        const float mean_low5 = lost44 + lost45;
                        const float total46 = given4*total45;
                        const float lost46 = given4*mean_low5 +
                            fmaf(given4, total45, -(given4*total45));
                        const float total47 = 1.0f - total46;
                        const float back28 = total47 - 1.0f;
                        const float lost47 = -back28 - total46;
                        const float fall_low5 = -lost46 + lost47;
                        const float total48 = -total43 + total45;
                        const float back29 = -total45 + total48;
                        const float rest12 = -back29 + total48;
                        const float one11 = -rest12 + total45;
                        const float two11 = -back29 - total43;
                        const float lost48 = one11 + two11;
                        const float total49 = given4*total48;
                        const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                            fmaf(given4, total48, -(given4*total48));
                        const float total50 = total40 - total49;
                        const float back30 = -total40 + total50;
                        const float rest13 = -back30 + total50;
                        const float one12 = -rest13 + total40;
                        const float two12 = -back30 - total49;
                        const float lost50 = one12 + two12;
                        const float low22 = lift_low - lost49 + lost50;
                        const float total51 = low22 + total50;
                        const float back31 = -total50 + total51;
                        const float rest14 = -back31 + total51;
                        const float one13 = -rest14 + total50;
                        const float two13 = -back31 + low22;
                        const float lost51 = one13 + two13;
                        const float total52 = total47*total51;
                        const float lost52 = lost51*total47 +
                            fmaf(total47, total51, -(total47*total51));
                        const float low3 = fall_low5*total51 + lost52;
                        const float total53 = total52/stiff;
                        const float left25 = -stiff*total53 + total52;
                        const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                        const float left27 = left26 + low3;
                        const float lost53 = left27/stiff;
                        const float expm1_of = expm1f(-half);
                        const float grown = -0.5f*expm1_of;
                        const float angle = 0.5f*root;
                        const float wave = cosf(angle);
                        const float sin_of = sinf(angle);
                        const float back72 = 0.5f*root_low*sin_of;
                        const float total92 = -back72 + wave;
                        const float back82 = total92 - wave;
                        const float rest33 = -back82 + total92;
                        const float one23 = -rest33 + wave;
                        const float two23 = -back72 - back82;
                        const float lost92 = one23 + two23;
                        const float total102 = (total92*total92);
                        const float lost102 = fmaf(total92, total92, -(total92*total92));
                        const float low4 = lost102 + 2.0f*lost92*total92;
                        const float total112 = envelope*total102;
                        const float lost112 = envelope*low4 +
                            fmaf(envelope, total102, -(envelope*total102));
                        const float total122 = (grown*grown) + total112;
                        const float back92 = -total112 + total122;
                        const float rest43 = -back92 + total122;
                        const float one33 = -rest43 + total112;
                        const float two33 = -back92 + (grown*grown);
                        const float lost122 = one33 + two33;
                        const float low23 = lost112 + lost122;
                        const float total472 = total43*total47;
                        const float lost472 = lost43*total47 +
                            fmaf(total47, total43, -(total47*total43));
                        const float total482 = total45 - total472;
                        const float back292 = -total45 + total482;
                        const float rest112 = -back292 + total482;
                        const float one102 = -rest112 + total45;
                        const float two102 = -back292 - total472;
                        const float lost482 = one102 + two102;
                        const float low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                        const float total492 = given4*total482;
                        const float lost492 = given4*low24 +
                            fmaf(given4, total482, -(given4*total482));
                        const float total502 = total40*total47;
                        const float lost502 = lift_low*total47 +
                            fmaf(total47, total40, -(total47*total40));
                        const float total512 = total492 + total502;
                        const float back302 = -total492 + total512;
                        const float rest122 = -back302 + total512;
                        const float one112 = -rest122 + total492;
                        const float two112 = -back302 + total502;
                        const float lost512 = one112 + two112;
                        const float low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                        const float total522 = total512/stiff;
                        const float left252 = -stiff*total522 + total512;
                        const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                        const float left272 = left262 + low33;
                        const float lost522 = left272/stiff;
                        apart_of = lost28 + total28;
                        fall_of = lost53 + total53;
                        nyquist_of = 4.0f*low23 + 4.0f*total122;
                        rise_of = lost522 + total522;
                        together_of = 2.0f*lost563 + 2.0f*total563;
                    }
                } else {
                    if (total263 > 0.0f) {
                        const float e = expf(-delta);
                        const float total253 = e + 1.0f;
                        const float back182 = total253 - 1.0f;
                        const float lost253 = -back182 + e;
                        const float total273 = total253 + total263;
                        const float back192 = -total253 + total273;
                        const float lost273 = -back192 + total263;
                        float even_low2;
                        float odd;
                        float odd_low2;
                        if (square2 > -1.5f) {
                            const float given3 = square2;
                            const float total19 = 0.5f*given3 + 1.0f;
                            const float back13 = total19 - 1.0f;
                            const float lost19 = -back13 + 0.5f*given3;
                            const float cos_series_of = cos_series(given3);
                            const float curved3 = cos_series_of*(given3*given3);
                            const float total20 = curved3 + total19;
                            const float back14 = -total19 + total20;
                            const float lost20 = -back14 + curved3;
                            const float even_low = lost19 + 0.5f*lost2 + lost20;
                            const float sin_series_of = sin_series(given3);
                            const float bent = given3*sin_series_of;
                            const float total21 = bent + 1.0f;
                            const float back15 = total21 - 1.0f;
                            const float lost21 = -back15 + bent;
                            const float odd_low = 0.16666667f*lost2 + lost21;
                            even_low2 = even_low;
                            odd = total21;
                            odd_low2 = odd_low;
                        } else {
                            const float sign_low = -lost2;
                            const float left = -(root*root) + size;
                            const float left2 = left - fmaf(root, root, -(root*root));
                            const float left3 = left2 + sign_low;
                            const float whole = (root == 0.0f ? 1.0f : root);
                            const float root_low = 0.5f*left3/whole;
                            const float sine = sinf(root);
                            const float cosine = cosf(root);
                            const float some = root;
                            const float total22 = sine/some;
                            const float left10 = sine - some*total22;
                            const float left11 = left10 - fmaf(total22, some, -(total22*some));
                            const float left12 = cosine*root_low + left11 - root_low*total22;
                            const float lost22 = left12/some;
                            even_low2 = -root_low*sine;
                            odd = total22;
                            odd_low2 = lost22;
                        }
                        const float total23 = half*odd;
                        const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                        const float total252 = -even + total23;
                        const float back162 = -total23 + total252;
                        const float rest42 = -back162 + total252;
                        const float one32 = -rest42 + total23;
                        const float two32 = -back162 - even;
                        const float lost252 = one32 + two32;
                        const float total262 = envelope + total252;
                        const float back172 = -total252 + total262;
                        const float rest52 = -back172 + total262;
                        const float one42 = -rest52 + total252;
                        const float two42 = -back172 + envelope;
                        const float lost262 = one42 + two42;
                        const float total272 = envelope*total262;
                        const float lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                            fmaf(envelope, total262, -(envelope*total262));
                        const float total282 = total272/stiff;
                        const float left16 = -stiff*total282 + total272;
                        const float left17 = left16 - fmaf(total282, stiff, -(total282*stiff));
                        const float left18 = left17 + lost272;
                        const float lost282 = left18/stiff;
                        const float lost263 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                        const float total242 = even + total23;
                        const float back163 = -even + total242;
                        const float rest44 = -back163 + total242;
                        const float one34 = even - rest44;
                        const float two34 = -back163 + total23;
                        const float lost242 = one34 + two34;
                        const float total254 = envelope*total242;
                        const float lost254 = envelope*(even_low2 + lost23 + lost242) +
                            fmaf(envelope, total242, -(envelope*total242));
                        const float total264 = 1.0f - total254;
                        const float back173 = total264 - 1.0f;
                        const float lost264 = -back173 - total254;
                        const float total274 = total264/stiff;
                        const float left162 = -stiff*total274 + total264;
                        const float left172 = left162 - fmaf(total274, stiff, -(total274*stiff));
                        const float left182 = left172 - lost254 + lost264;
                        const float lost274 = left182/stiff;
                        apart_of = lost28 + total28;
                        fall_of = lost282 + total282;
                        nyquist_of = lost253 + lost263 + lost273 + total273;
                        rise_of = lost274 + total274;
                        together_of = 2.0f*lost563 + 2.0f*total563;
                    } else {
                        const float sign_low = -lost2;
                        const float left = -(root*root) + size;
                        const float left2 = left - fmaf(root, root, -(root*root));
                        const float left3 = left2 + sign_low;
                        const float whole = (root == 0.0f ? 1.0f : root);
                        const float root_low = 0.5f*left3/whole;
                        const float expm1_of = expm1f(-half);
                        const float grown = -0.5f*expm1_of;
                        const float angle = 0.5f*root;
                        const float wave = cosf(angle);
                        const float sin_of = sinf(angle);
                        const float back72 = 0.5f*root_low*sin_of;
                        const float total92 = -back72 + wave;
                        const float back82 = total92 - wave;
                        const float rest33 = -back82 + total92;
                        const float one23 = -rest33 + wave;
                        const float two23 = -back72 - back82;
                        const float lost92 = one23 + two23;
                        const float total102 = (total92*total92);
                        const float lost102 = fmaf(total92, total92, -(total92*total92));
                        const float low4 = lost102 + 2.0f*lost92*total92;
                        const float total112 = envelope*total102;
                        const float lost112 = envelope*low4 +
                            fmaf(envelope, total102, -(envelope*total102));
                        const float total122 = (grown*grown) + total112;
                        const float back92 = -total112 + total122;
                        const float rest43 = -back92 + total122;
                        const float one33 = -rest43 + total112;
                        const float two33 = -back92 + (grown*grown);
                        const float lost122 = one33 + two33;
                        const float low23 = lost112 + lost122;
                        float even_low2;
                        float odd;
                        float odd_low2;
                        if (square2 > -1.5f) {
                            const float given3 = square2;
                            const float total19 = 0.5f*given3 + 1.0f;
                            const float back13 = total19 - 1.0f;
                            const float lost19 = -back13 + 0.5f*given3;
                            const float cos_series_of = cos_series(given3);
                            const float curved3 = cos_series_of*(given3*given3);
                            const float total20 = curved3 + total19;
                            const float back14 = -total19 + total20;
                            const float lost20 = -back14 + curved3;
                            const float even_low = lost19 + 0.5f*lost2 + lost20;
                            const float sin_series_of = sin_series(given3);
                            const float bent = given3*sin_series_of;
                            const float total21 = bent + 1.0f;
                            const float back15 = total21 - 1.0f;
                            const float lost21 = -back15 + bent;
                            const float odd_low = 0.16666667f*lost2 + lost21;
                            even_low2 = even_low;
                            odd = total21;
                            odd_low2 = odd_low;
                        } else {
                            const float sine = sinf(root);
                            const float cosine = cosf(root);
                            const float some = root;
                            const float total22 = sine/some;
                            const float left10 = sine - some*total22;
                            const float left11 = left10 - fmaf(total22, some, -(total22*some));
                            const float left12 = cosine*root_low + left11 - root_low*total22;
                            const float lost22 = left12/some;
                            even_low2 = -root_low*sine;
                            odd = total22;
                            odd_low2 = lost22;
                        }
                        const float total23 = half*odd;
                        const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                        const float total252 = -even + total23;
                        const float back162 = -total23 + total252;
                        const float rest42 = -back162 + total252;
                        const float one32 = -rest42 + total23;
                        const float two32 = -back162 - even;
                        const float lost252 = one32 + two32;
                        const float total262 = envelope + total252;
                        const float back172 = -total252 + total262;
                        const float rest52 = -back172 + total262;
                        const float one42 = -rest52 + total252;
                        const float two42 = -back172 + envelope;
                        const float lost262 = one42 + two42;
                        const float total272 = envelope*total262;
                        const float lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                            fmaf(envelope, total262, -(envelope*total262));
                        const float total282 = total272/stiff;
                        const float left16 = -stiff*total282 + total272;
                        const float left17 = left16 - fmaf(total282, stiff, -(total282*stiff));
                        const float left18 = left17 + lost272;
                        const float lost282 = left18/stiff;
                        const float total242 = even + total23;
                        const float back163 = -even + total242;
                        const float rest44 = -back163 + total242;
                        const float one34 = even - rest44;
                        const float two34 = -back163 + total23;
                        const float lost242 = one34 + two34;
                        const float total254 = envelope*total242;
                        const float lost254 = envelope*(even_low2 + lost23 + lost242) +
                            fmaf(envelope, total242, -(envelope*total242));
                        const float total264 = 1.0f - total254;
                        const float back173 = total264 - 1.0f;
                        const float lost264 = -back173 - total254;
                        const float total274 = total264/stiff;
                        const float left162 = -stiff*total274 + total264;
                        const float left172 = left162 - fmaf(total274, stiff, -(total274*stiff));
                        const float left182 = left172 - lost254 + lost264;
                        const float lost274 = left182/stiff;
                        apart_of = lost28 + total28;
                        fall_of = lost282 + total282;
                        nyquist_of = 4.0f*low23 + 4.0f*total122;
                        rise_of = lost274 + total274;
                        together_of = 2.0f*lost563 + 2.0f*total563;
                    }
                }
            }
        } else {
            const float size = fabsf(total2);
            const float root = sqrtf(size);
            const float square2 = total2;
            const float envelope = expf(-half);
            const float stiff = gamma;
            const float mean3 = decay(delta);
            const float twice2 = 2.0f*envelope;
            float even;
            float odd;
            float odd_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total19 = 0.5f*given3 + 1.0f;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total20 = curved3 + total19;
                const float sin_series_of = sin_series(given3);
                const float bent = given3*sin_series_of;
                const float total21 = bent + 1.0f;
                const float back15 = total21 - 1.0f;
                const float lost21 = -back15 + bent;
                const float odd_low = 0.16666667f*lost2 + lost21;
                even = total20;
                odd = total21;
                odd_low2 = odd_low;
            } else {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                const float some = root;
                const float total22 = sine/some;
                const float left10 = sine - some*total22;
                const float left11 = left10 - fmaf(total22, some, -(total22*some));
                const float left12 = cosine*root_low + left11 - root_low*total22;
                const float lost22 = left12/some;
                even = cosine;
                odd = total22;
                odd_low2 = lost22;
            }
            const float total24 = envelope*odd;
            const float lost24 = envelope*odd_low2 + fmaf(envelope, odd, -(envelope*odd));
            const float total25 = mean3 - total24;
            const float back16 = -mean3 + total25;
            const float rest4 = -back16 + total25;
            const float one3 = mean3 - rest4;
            const float two3 = -back16 - total24;
            const float lost25 = one3 + two3;
            const float total26 = total25/stiff;
            const float left13 = -stiff*total26 + total25;
            const float left14 = left13 - fmaf(total26, stiff, -(total26*stiff));
            const float left15 = left14 - lost24 + lost25;
            const float lost26 = left15/stiff;
            const float total263 = even*twice2;
            float count;
            if (root < 4096.0f) {
                count = floorf(0.5f*root/3.1415927f + 0.5f);
            } else {
                count = 0.0f;
            }
            const float turns = (count*count);
            const float total29 = 39.478416f*turns;
            const float lost29 = fmaf(turns, 39.478416f, -(turns*39.478416f));
            const float total30 = 1.1614864e-06f*turns;
            const float lost30 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
            const float total31 = -total2 - total29;
            const float back18 = total2 + total31;
            const float rest62 = -back18 + total31;
            const float one5 = -rest62 - total2;
            const float two5 = -back18 - total29;
            const float lost31 = one5 + two5;
            const float total32 = -lost29 + total31;
            const float back19 = -total31 + total32;
            const float rest7 = -back19 + total32;
            const float one6 = -rest7 + total31;
            const float two6 = -back19 - lost29;
            const float lost32 = one6 + two6;
            const float total33 = -total30 + total32;
            const float back20 = -total32 + total33;
            const float rest8 = -back20 + total33;
            const float one7 = -rest8 + total32;
            const float two7 = -back20 - total30;
            const float lost33 = one7 + two7;
            const float total34 = -lost2 + total33;
            const float back21 = -total33 + total34;
            const float rest9 = -back21 + total34;
            const float one8 = -rest9 + total33;
            const float two8 = -back21 - lost2;
            const float lost34 = one8 + two8;
            const float low2 = -lost30 + lost31 + lost32 + lost33 + lost34 + 1.1704737e-14f*turns;
            const float total35 = low2 + total34;
            const float total36 = 6.2831855f*count;
            const float total37 = root + total36;
            const float whole32 = (total37 == 0.0f ? 1.0f : total37);
            const float total38 = total35/whole32;
            const float far = (total38*total38);
            if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                if (total263 > 0.0f) {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float back22 = -total34 + total35;
                    const float rest10 = -back22 + total35;
                    const float one9 = -rest10 + total34;
                    const float two9 = -back22 + low2;
                    const float lost35 = one9 + two9;
                    const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                    const float back23 = -root + total37;
                    const float rest11 = -back23 + total37;
                    const float one10 = -rest11 + root;
                    const float two10 = -back23 + total36;
                    const float lost37 = one10 + two10;
                    const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                    const float left19 = total35 - total38*whole32;
                    const float left20 = left19 - fmaf(total38, whole32, -(total38*whole32));
                    const float left21 = -both_low*total38 + left20 + lost35;
                    const float lost38 = left21/whole32;
                    const float eta = total38;
                    const float eta_low = lost38;
                    const float total39 = (eta*eta);
                    const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                    const float cos_series_of2 = cos_series(-total39);
                    const float bent2 = cos_series_of2*(total39*total39);
                    const float total40 = -bent2 + 0.5f*total39;
                    const float back24 = -0.5f*total39 + total40;
                    const float lost40 = -back24 - bent2;
                    const float sin_series_of2 = sin_series(-total39);
                    const float total41 = -sin_series_of2*total39 + 1.0f;
                    const float back25 = total41 - 1.0f;
                    const float lost41 = -back25 - sin_series_of2*total39;
                    const float lift_low = 0.5f*lost39*total41 + lost40;
                    const float total42 = eta*total41;
                    const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                    const float some2 = root;
                    const float total43 = total42/some2;
                    const float left22 = -some2*total43 + total42;
                    const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                    const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*
                        total43;
                    const float lost43 = left24/some2;
                    const float given4 = half;
                    const float total44 = 1.0f - 0.5f*given4;
                    const float back26 = total44 - 1.0f;
                    const float lost44 = -back26 - 0.5f*given4;
                    const float decay_series_of3 = decay_series(given4);
                    const float curved4 = decay_series_of3*(given4*given4);
                    const float total45 = curved4 + total44;
                    const float back27 = -total44 + total45;
                    const float lost45 = -back27 + curved4;
                    const float mean_low5 = lost44 + lost45;
                    const float total46 = given4*total45;
                    const float lost46 = given4*mean_low5 +
                        fmaf(given4, total45, -(given4*total45));
                    const float total47 = 1.0f - total46;
                    const float back28 = total47 - 1.0f;
                    const float lost47 = -back28 - total46;
                    const float fall_low5 = -lost46 + lost47;
                    const float total48 = -total43 + total45;
                    const float back29 = -total45 + total48;
                    const float rest12 = -back29 + total48;
                    const float one11 = -rest12 + total45;
                    const float two11 = -back29 - total43;
                    const float lost48 = one11 + two11;
                    const float total49 = given4*total48;
                    const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                        fmaf(given4, total48, -(given4*total48));
                    const float total50 = total40 - total49;
                    const float back30 = -total40 + total50;
                    const float rest13 = -back30 + total50;
                    const float one12 = -rest13 + total40;
                    const float two12 = -back30 - total49;
                    const float lost50 = one12 + two12;
                    const float low22 = lift_low - lost49 + lost50;
                    const float total51 = low22 + total50;
                    const float back31 = -total50 + total51;
                    const float rest14 = -back31 + total51;
                    const float one13 = -rest14 + total50;
                    const float two13 = -back31 + low22;
                    const float lost51 = one13 + two13;
                    const float total52 = total47*total51;
                    const float lost52 = lost51*total47 +
                        fmaf(total47, total51, -(total47*total51));
                    const float low3 = fall_low5*total51 + lost52;
                    const float total53 = total52/stiff;
                    const float left25 = -stiff*total53 + total52;
                    const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                    const float left27 = left26 + low3;
                    const float lost53 = left27/stiff;
                    const float e = expf(-delta);
                    const float total253 = e + 1.0f;
                    const float back182 = total253 - 1.0f;
                    const float lost253 = -back182 + e;
                    const float total273 = total253 + total263;
                    const float back192 = -total253 + total273;
                    const float lost273 = -back192 + total263;
                    const float total472 = total43*total47;
                    const float lost472 = lost43*total47 +
                        fmaf(total47, total43, -(total47*total43));
                    const float total482 = total45 - total472;
                    const float back292 = -total45 + total482;
                    const float rest112 = -back292 + total482;
                    const float one102 = -rest112 + total45;
                    const float two102 = -back292 - total472;
                    const float lost482 = one102 + two102;
                    const float low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                    const float total492 = given4*total482;
                    const float lost492 = given4*low24 + fmaf(given4, total482, -(given4*total482));
                    const float total502 = total40*total47;
                    const float lost502 = lift_low*total47 +
                        fmaf(total47, total40, -(total47*total40));
                    const float total512 = total492 + total502;
                    const float back302 = -total492 + total512;
                    const float rest122 = -back302 + total512;
                    const float one112 = -rest122 + total492;
                    const float two112 = -back302 + total502;
                    const float lost512 = one112 + two112;
                    const float low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                    const float total522 = total512/stiff;
                    const float left252 = -stiff*total522 + total512;
                    const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                    const float left272 = left262 + low33;
                    const float lost522 = left272/stiff;
                    const float total332 = 1.0f - total47;
                    const float back213 = total332 - 1.0f;
                    const float lost332 = -back213 - total47;
                    const float low42 = -fall_low5 + lost332;
                    const float total342 = low42 + total332;
                    const float back222 = -total332 + total342;
                    const float lost342 = -back222 + low42;
                    const float total352 = (total342*total342);
                    const float lost352 = 2.0f*lost342*total342 +
                        fmaf(total342, total342, -(total342*total342));
                    const float total372 = total352 + 2.0f*total502;
                    const float back232 = -total352 + total372;
                    const float rest113 = -back232 + total372;
                    const float one103 = -rest113 + total352;
                    const float two103 = -back232 + 2.0f*total502;
                    const float lost372 = one103 + two103;
                    const float low52 = 2.0f*fall_low5*total40 + lost352 + lost372 + 2.0f*lost502;
                    const float total382 = total372/stiff;
                    const float left163 = -stiff*total382 + total372;
                    const float left173 = left163 - fmaf(total382, stiff, -(total382*stiff));
                    const float left183 = left173 + low52;
                    const float lost382 = left183/stiff;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const float sine = sinf(root);
                        even_low2 = -root_low*sine;
                    }
                    const float lost263 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                    apart_of = lost26 + total26;
                    fall_of = lost53 + total53;
                    nyquist_of = lost253 + lost263 + lost273 + total273;
                    rise_of = lost522 + total522;
                    together_of = lost382 + total382;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float back22 = -total34 + total35;
                    const float rest10 = -back22 + total35;
                    const float one9 = -rest10 + total34;
                    const float two9 = -back22 + low2;
                    const float lost35 = one9 + two9;
                    const float lost36 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                    const float back23 = -root + total37;
                    const float rest11 = -back23 + total37;
                    const float one10 = -rest11 + root;
                    const float two10 = -back23 + total36;
                    const float lost37 = one10 + two10;
                    const float both_low = -1.7484555e-07f*count + lost36 + lost37 + root_low;
                    const float left19 = total35 - total38*whole32;
                    const float left20 = left19 - fmaf(total38, whole32, -(total38*whole32));
                    const float left21 = -both_low*total38 + left20 + lost35;
                    const float lost38 = left21/whole32;
                    const float eta = total38;
                    const float eta_low = lost38;
                    const float total39 = (eta*eta);
                    const float lost39 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                    const float cos_series_of2 = cos_series(-total39);
                    const float bent2 = cos_series_of2*(total39*total39);
                    const float total40 = -bent2 + 0.5f*total39;
                    const float back24 = -0.5f*total39 + total40;
                    const float lost40 = -back24 - bent2;
                    const float sin_series_of2 = sin_series(-total39);
                    const float total41 = -sin_series_of2*total39 + 1.0f;
                    const float back25 = total41 - 1.0f;
                    const float lost41 = -back25 - sin_series_of2*total39;
                    const float lift_low = 0.5f*lost39*total41 + lost40;
                    const float total42 = eta*total41;
                    const float lost42 = eta*lost41 + fmaf(eta, total41, -(eta*total41));
                    const float some2 = root;
                    const float total43 = total42/some2;
                    const float left22 = -some2*total43 + total42;
                    const float left23 = left22 - fmaf(total43, some2, -(total43*some2));
                    const float left24 = eta_low*(1.0f - total40) + left23 + lost42 - root_low*
                        total43;
                    const float lost43 = left24/some2;
                    const float given4 = half;
                    const float total44 = 1.0f - 0.5f*given4;
                    const float back26 = total44 - 1.0f;
                    const float lost44 = -back26 - 0.5f*given4;
                    const float decay_series_of3 = decay_series(given4);
                    const float curved4 = decay_series_of3*(given4*given4);
                    const float total45 = curved4 + total44;
                    const float back27 = -total44 + total45;
                    const float lost45 = -back27 + curved4;
                    const float mean_low5 = lost44 + lost45;
                    const float total46 = given4*total45;
                    const float lost46 = given4*mean_low5 +
                        fmaf(given4, total45, -(given4*total45));
                    const float total47 = 1.0f - total46;
                    const float back28 = total47 - 1.0f;
                    const float lost47 = -back28 - total46;
                    const float fall_low5 = -lost46 + lost47;
                    const float total48 = -total43 + total45;
                    const float back29 = -total45 + total48;
                    const float rest12 = -back29 + total48;
                    const float one11 = -rest12 + total45;
                    const float two11 = -back29 - total43;
                    const float lost48 = one11 + two11;
                    const float total49 = given4*total48;
                    const float lost49 = given4*(-lost43 + lost48 + mean_low5) +
                        fmaf(given4, total48, -(given4*total48));
                    const float total50 = total40 - total49;
                    const float back30 = -total40 + total50;
                    const float rest13 = -back30 + total50;
                    const float one12 = -rest13 + total40;
                    const float two12 = -back30 - total49;
                    const float lost50 = one12 + two12;
                    const float low22 = lift_low - lost49 + lost50;
                    const float total51 = low22 + total50;
                    const float back31 = -total50 + total51;
                    const float rest14 = -back31 + total51;
                    const float one13 = -rest14 + total50;
                    const float two13 = -back31 + low22;
                    const float lost51 = one13 + two13;
                    const float total52 = total47*total51;
                    const float lost52 = lost51*total47 +
                        fmaf(total47, total51, -(total47*total51));
                    const float low3 = fall_low5*total51 + lost52;
                    const float total53 = total52/stiff;
                    const float left25 = -stiff*total53 + total52;
                    const float left26 = left25 - fmaf(total53, stiff, -(total53*stiff));
                    const float left27 = left26 + low3;
                    const float lost53 = left27/stiff;
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float back72 = 0.5f*root_low*sin_of;
                    const float total92 = -back72 + wave;
                    const float back82 = total92 - wave;
                    const float rest33 = -back82 + total92;
                    const float one23 = -rest33 + wave;
                    const float two23 = -back72 - back82;
                    const float lost92 = one23 + two23;
                    const float total102 = (total92*total92);
                    const float lost102 = fmaf(total92, total92, -(total92*total92));
                    const float low4 = lost102 + 2.0f*lost92*total92;
                    const float total112 = envelope*total102;
                    const float lost112 = envelope*low4 +
                        fmaf(envelope, total102, -(envelope*total102));
                    const float total122 = (grown*grown) + total112;
                    const float back92 = -total112 + total122;
                    const float rest43 = -back92 + total122;
                    const float one33 = -rest43 + total112;
                    const float two33 = -back92 + (grown*grown);
                    const float lost122 = one33 + two33;
                    const float low23 = lost112 + lost122;
                    const float total472 = total43*total47;
                    const float lost472 = lost43*total47 +
                        fmaf(total47, total43, -(total47*total43));
                    const float total482 = total45 - total472;
                    const float back292 = -total45 + total482;
                    const float rest112 = -back292 + total482;
                    const float one102 = -rest112 + total45;
                    const float two102 = -back292 - total472;
                    const float lost482 = one102 + two102;
                    const float low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                    const float total492 = given4*total482;
                    const float lost492 = given4*low24 + fmaf(given4, total482, -(given4*total482));
                    const float total502 = total40*total47;
                    const float lost502 = lift_low*total47 +
                        fmaf(total47, total40, -(total47*total40));
                    const float total512 = total492 + total502;
                    const float back302 = -total492 + total512;
                    const float rest122 = -back302 + total512;
                    const float one112 = -rest122 + total492;
                    const float two112 = -back302 + total502;
                    const float lost512 = one112 + two112;
                    const float low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                    const float total522 = total512/stiff;
                    const float left252 = -stiff*total522 + total512;
                    const float left262 = left252 - fmaf(total522, stiff, -(total522*stiff));
                    const float left272 = left262 + low33;
                    const float lost522 = left272/stiff;
                    const float total332 = 1.0f - total47;
                    const float back213 = total332 - 1.0f;
                    const float lost332 = -back213 - total47;
                    const float low42 = -fall_low5 + lost332;
                    const float total342 = low42 + total332;
                    const float back222 = -total332 + total342;
                    const float lost342 = -back222 + low42;
                    const float total352 = (total342*total342);
                    const float lost352 = 2.0f*lost342*total342 +
                        fmaf(total342, total342, -(total342*total342));
                    const float total372 = total352 + 2.0f*total502;
                    const float back232 = -total352 + total372;
                    const float rest113 = -back232 + total372;
                    const float one103 = -rest113 + total352;
                    const float two103 = -back232 + 2.0f*total502;
                    const float lost372 = one103 + two103;
                    const float low52 = 2.0f*fall_low5*total40 + lost352 + lost372 + 2.0f*lost502;
                    const float total382 = total372/stiff;
                    const float left163 = -stiff*total382 + total372;
                    const float left173 = left163 - fmaf(total382, stiff, -(total382*stiff));
                    const float left183 = left173 + low52;
                    const float lost382 = left183/stiff;
                    apart_of = lost26 + total26;
                    fall_of = lost53 + total53;
                    nyquist_of = 4.0f*low23 + 4.0f*total122;
                    rise_of = lost522 + total522;
                    together_of = lost382 + total382;
                }
            } else {
                if (total263 > 0.0f) {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float total23 = half*odd;
                    const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                    const float total252 = -even + total23;
                    const float back162 = -total23 + total252;
                    const float rest42 = -back162 + total252;
                    const float one32 = -rest42 + total23;
                    const float two32 = -back162 - even;
                    const float lost252 = one32 + two32;
                    const float total262 = envelope + total252;
                    const float back172 = -total252 + total262;
                    const float rest52 = -back172 + total262;
                    const float one42 = -rest52 + total252;
                    const float two42 = -back172 + envelope;
                    const float lost262 = one42 + two42;
                    const float total272 = envelope*total262;
                    const float total282 = total272/stiff;
                    const float left16 = -stiff*total282 + total272;
                    const float left17 = left16 - fmaf(total282, stiff, -(total282*stiff));
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float e = expf(-delta);
                    const float total253 = e + 1.0f;
                    const float back182 = total253 - 1.0f;
                    const float lost253 = -back182 + e;
                    const float total273 = total253 + total263;
                    const float back192 = -total253 + total273;
                    const float lost273 = -back192 + total263;
                    const float total242 = even + total23;
                    const float back163 = -even + total242;
                    const float rest44 = -back163 + total242;
                    const float one34 = even - rest44;
                    const float two34 = -back163 + total23;
                    const float lost242 = one34 + two34;
                    const float total254 = envelope*total242;
                    const float total264 = 1.0f - total254;
                    const float back173 = total264 - 1.0f;
                    const float lost264 = -back173 - total254;
                    const float total274 = total264/stiff;
                    const float left162 = -stiff*total274 + total264;
                    const float left172 = left162 - fmaf(total274, stiff, -(total274*stiff));
                    const float back73 = -0.5f*root_low*wave;
                    const float total93 = -back73 + sin_of;
                    const float back83 = -sin_of + total93;
                    const float rest35 = -back83 + total93;
                    const float one25 = -rest35 + sin_of;
                    const float two25 = -back73 - back83;
                    const float lost93 = one25 + two25;
                    const float total103 = (total93*total93);
                    const float lost103 = fmaf(total93, total93, -(total93*total93));
                    const float low5 = lost103 + 2.0f*lost93*total93;
                    const float total113 = envelope*total103;
                    const float lost113 = envelope*low5 +
                        fmaf(envelope, total103, -(envelope*total103));
                    const float total123 = (grown*grown) + total113;
                    const float back93 = -total113 + total123;
                    const float rest45 = -back93 + total123;
                    const float one35 = -rest45 + total113;
                    const float two35 = -back93 + (grown*grown);
                    const float lost123 = one35 + two35;
                    const float low25 = lost113 + lost123;
                    const float total132 = total123/stiff;
                    const float left72 = -stiff*total132 + total123;
                    const float left82 = left72 - fmaf(total132, stiff, -(total132*stiff));
                    const float left92 = left82 + low25;
                    const float lost132 = left92/stiff;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const float sine = sinf(root);
                        even_low2 = -root_low*sine;
                    }
                    const float lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                        fmaf(envelope, total262, -(envelope*total262));
                    const float left18 = left17 + lost272;
                    const float lost282 = left18/stiff;
                    const float lost263 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                    const float lost254 = envelope*(even_low2 + lost23 + lost242) +
                        fmaf(envelope, total242, -(envelope*total242));
                    const float left182 = left172 - lost254 + lost264;
                    const float lost274 = left182/stiff;
                    apart_of = lost26 + total26;
                    fall_of = lost282 + total282;
                    nyquist_of = lost253 + lost263 + lost273 + total273;
                    rise_of = lost274 + total274;
                    together_of = 4.0f*lost132 + 4.0f*total132;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float total23 = half*odd;
                    const float lost23 = half*odd_low2 + fmaf(half, odd, -(half*odd));
                    const float total252 = -even + total23;
                    const float back162 = -total23 + total252;
                    const float rest42 = -back162 + total252;
                    const float one32 = -rest42 + total23;
                    const float two32 = -back162 - even;
                    const float lost252 = one32 + two32;
                    const float total262 = envelope + total252;
                    const float back172 = -total252 + total262;
                    const float rest52 = -back172 + total262;
                    const float one42 = -rest52 + total252;
                    const float two42 = -back172 + envelope;
                    const float lost262 = one42 + two42;
                    const float total272 = envelope*total262;
                    const float total282 = total272/stiff;
                    const float left16 = -stiff*total282 + total272;
                    const float left17 = left16 - fmaf(total282, stiff, -(total282*stiff));
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float back72 = 0.5f*root_low*sin_of;
                    const float total92 = -back72 + wave;
                    const float back82 = total92 - wave;
                    const float rest33 = -back82 + total92;
                    const float one23 = -rest33 + wave;
                    const float two23 = -back72 - back82;
                    const float lost92 = one23 + two23;
                    const float total102 = (total92*total92);
                    const float lost102 = fmaf(total92, total92, -(total92*total92));
                    const float low4 = lost102 + 2.0f*lost92*total92;
                    const float total112 = envelope*total102;
                    const float lost112 = envelope*low4 +
                        fmaf(envelope, total102, -(envelope*total102));
                    const float total122 = (grown*grown) + total112;
                    const float back92 = -total112 + total122;
                    const float rest43 = -back92 + total122;
                    const float one33 = -rest43 + total112;
                    const float two33 = -back92 + (grown*grown);
                    const float lost122 = one33 + two33;
                    const float low23 = lost112 + lost122;
                    const float total242 = even + total23;
                    const float back163 = -even + total242;
                    const float rest44 = -back163 + total242;
                    const float one34 = even - rest44;
                    const float two34 = -back163 + total23;
                    const float lost242 = one34 + two34;
                    const float total254 = envelope*total242;
                    const float total264 = 1.0f - total254;
                    const float back173 = total264 - 1.0f;
                    const float lost264 = -back173 - total254;
                    const float total274 = total264/stiff;
                    const float left162 = -stiff*total274 + total264;
                    const float left172 = left162 - fmaf(total274, stiff, -(total274*stiff));
                    const float back73 = -0.5f*root_low*wave;
                    const float total93 = -back73 + sin_of;
                    const float back83 = -sin_of + total93;
                    const float rest35 = -back83 + total93;
                    const float one25 = -rest35 + sin_of;
                    const float two25 = -back73 - back83;
                    const float lost93 = one25 + two25;
                    const float total103 = (total93*total93);
                    const float lost103 = fmaf(total93, total93, -(total93*total93));
                    const float low5 = lost103 + 2.0f*lost93*total93;
                    const float total113 = envelope*total103;
                    const float lost113 = envelope*low5 +
                        fmaf(envelope, total103, -(envelope*total103));
                    const float total123 = (grown*grown) + total113;
                    const float back93 = -total113 + total123;
                    const float rest45 = -back93 + total123;
                    const float one35 = -rest45 + total113;
                    const float two35 = -back93 + (grown*grown);
                    const float lost123 = one35 + two35;
                    const float low25 = lost113 + lost123;
                    const float total132 = total123/stiff;
                    const float left72 = -stiff*total132 + total123;
                    const float left82 = left72 - fmaf(total132, stiff, -(total132*stiff));
                    const float left92 = left82 + low25;
                    const float lost132 = left92/stiff;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const float sine = sinf(root);
                        even_low2 = -root_low*sine;
                    }
                    const float lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                        fmaf(envelope, total262, -(envelope*total262));
                    const float left18 = left17 + lost272;
                    const float lost282 = left18/stiff;
                    const float lost254 = envelope*(even_low2 + lost23 + lost242) +
                        fmaf(envelope, total242, -(envelope*total242));
                    const float left182 = left172 - lost254 + lost264;
                    const float lost274 = left182/stiff;
                    apart_of = lost26 + total26;
                    fall_of = lost282 + total282;
                    nyquist_of = 4.0f*low23 + 4.0f*total122;
                    rise_of = lost274 + total274;
                    together_of = 4.0f*lost132 + 4.0f*total132;
                }
            }
        }
    } else {
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        const float total3 = half + root;
        const float reach = 0.44444445f*total3;
        if (reach < 1.0f) {
            if (reach < 0.5625f) {
                const float sign_low = lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back3 = -half + total3;
                const float lost3 = -back3 + root;
                const float p_low = lost3 + root_low;
                const float whole2 = (total3 == 0.0f ? 1.0f : total3);
                const float q = gamma/whole2;
                const float off = gamma - q*whole2;
                const float off2 = off - fmaf(whole2, q, -(whole2*q));
                const float off3 = off2 - p_low*q;
                const float q_low = off3/whole2;
                const float rate2 = 2.0f*root;
                const float envelope = expf(-half);
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                const float given5 = 0.5f*half;
                const float total54 = 1.0f - 0.5f*given5;
                const float back32 = total54 - 1.0f;
                const float lost54 = -back32 - 0.5f*given5;
                const float decay_series_of4 = decay_series(given5);
                const float curved5 = decay_series_of4*(given5*given5);
                const float total55 = curved5 + total54;
                const float back33 = -total54 + total55;
                const float lost55 = -back33 + curved5;
                const float mean_low6 = lost54 + lost55;
                const float total56 = given5*total55;
                const float lost56 = given5*mean_low6 + fmaf(given5, total55, -(given5*total55));
                const float total57 = 1.0f - total56;
                const float back34 = total57 - 1.0f;
                const float lost57 = -back34 - total56;
                const float fall_low6 = -lost56 + lost57;
                const float total58 = (total57*total57);
                const float lost58 = 2.0f*fall_low6*total57 +
                    fmaf(total57, total57, -(total57*total57));
                const float total59 = (total58*total58);
                const float lost59 = 2.0f*lost58*total58 +
                    fmaf(total58, total58, -(total58*total58));
                const float rest15 = fall_series(gamma, delta);
                const float total60 = rest15 + 0.5f;
                const float back35 = -rest15 + total60;
                const float rest16 = -back35 + total60;
                const float one14 = rest15 - rest16;
                const float two14 = 0.5f - back35;
                const float lost60 = one14 + two14;
                const float total61 = total59*total60;
                const float lost61 = lost60*total59 + fmaf(total59, total60, -(total59*total60));
                const float half2 = half;
                const float given52 = 0.5f*half2;
                const float total532 = 1.0f - 0.5f*given52;
                const float back312 = total532 - 1.0f;
                const float lost532 = -back312 - 0.5f*given52;
                const float decay_series_of5 = decay_series(given52);
                const float curved52 = decay_series_of5*(given52*given52);
                const float total542 = curved52 + total532;
                const float back322 = -total532 + total542;
                const float lost542 = -back322 + curved52;
                const float mean_low62 = lost532 + lost542;
                const float total552 = given52*total542;
                const float lost552 = given52*mean_low62 +
                    fmaf(given52, total542, -(given52*total542));
                const float total562 = 1.0f - total552;
                const float back332 = total562 - 1.0f;
                const float lost562 = -back332 - total552;
                const float fall_low62 = -lost552 + lost562;
                const float total572 = (total562*total562);
                const float lost572 = 2.0f*fall_low62*total562 +
                    fmaf(total562, total562, -(total562*total562));
                const float rest132 = rise_series(half2, total2);
                const float total582 = rest132 + 0.5f;
                const float back342 = -rest132 + total582;
                const float rest142 = -back342 + total582;
                const float one122 = rest132 - rest142;
                const float two122 = 0.5f - back342;
                const float lost582 = one122 + two122;
                const float total592 = total572*total582;
                const float lost592 = lost582*total572 +
                    fmaf(total572, total582, -(total572*total582));
                const float rest123 = together_series(half, total2);
                const float total553 = rest123 + 0.5f;
                const float back333 = -rest123 + total553;
                const float rest133 = -back333 + total553;
                const float one113 = rest123 - rest133;
                const float two113 = 0.5f - back333;
                const float lost553 = one113 + two113;
                const float total563 = envelope*total553;
                const float lost563 = envelope*lost553 +
                    fmaf(envelope, total553, -(envelope*total553));
                float fall_;
                float fall_low2;
                if (q < 0.75f) {
                    const float given = q;
                    const float total4 = 1.0f - 0.5f*given;
                    const float back4 = total4 - 1.0f;
                    const float lost4 = -back4 - 0.5f*given;
                    const float decay_series_of = decay_series(given);
                    const float curved = decay_series_of*(given*given);
                    const float total5 = curved + total4;
                    const float back5 = -total4 + total5;
                    const float lost5 = -back5 + curved;
                    const float mean_low = lost4 + lost5 - q_low*
                        (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                    const float total6 = given*total5;
                    const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                    const float total7 = 1.0f - total6;
                    const float back6 = total7 - 1.0f;
                    const float lost7 = -back6 - total6;
                    const float fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                } else {
                    const float sunk = expf(-q);
                    const float sunk_low = -q_low*sunk;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                }
                const float total283 = fall_ + 1.0f;
                const float back202 = total283 - 1.0f;
                const float lost283 = -back202 + fall_;
                float fall2;
                float fall_low4;
                if (rate2 < 0.75f) {
                    const float given2 = 2.0f*root;
                    const float total10 = 1.0f - 0.5f*given2;
                    const float back8 = total10 - 1.0f;
                    const float lost10 = -back8 - 0.5f*given2;
                    const float decay_series_of2 = decay_series(given2);
                    const float curved2 = decay_series_of2*(given2*given2);
                    const float total11 = curved2 + total10;
                    const float back9 = -total10 + total11;
                    const float lost11 = -back9 + curved2;
                    const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                        (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                    const float total12 = given2*total11;
                    const float lost12 = given2*mean_low3 +
                        fmaf(given2, total11, -(given2*total11));
                    const float total13 = 1.0f - total12;
                    const float back10 = total13 - 1.0f;
                    const float lost13 = -back10 - total12;
                    const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                    fall2 = total13;
                    fall_low4 = fall_low3;
                } else {
                    const float sunk2 = expf(-2.0f*root);
                    const float sunk_low2 = -2.0f*root_low*sunk2;
                    fall2 = sunk2;
                    fall_low4 = sunk_low2;
                }
                const float fast = fall_*fall2;
                const float lost292 = fall_*fall_low4 + fmaf(fall_, fall2, -(fall_*fall2));
                const float low32 = fall2*fall_low2 + lost292;
                const float total302 = fast + 1.0f;
                const float back212 = total302 - 1.0f;
                const float lost302 = -back212 + fast;
                const float total312 = total283*total302;
                const float lost312 = total283*(lost302 + low32) +
                    fmaf(total283, total302, -(total283*total302));
                apart_of = lost28 + total28;
                fall_of = lost59*total60 + lost61 + total61;
                nyquist_of = lost312 + total302*(fall_low2 + lost283) + total312;
                rise_of = lost572*total582 + lost592 + total592;
                together_of = 2.0f*lost563 + 2.0f*total563;
            } else {
                const float sign_low = lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float back3 = -half + total3;
                const float lost3 = -back3 + root;
                const float p_low = lost3 + root_low;
                const float whole2 = (total3 == 0.0f ? 1.0f : total3);
                const float q = gamma/whole2;
                const float off = gamma - q*whole2;
                const float off2 = off - fmaf(whole2, q, -(whole2*q));
                const float off3 = off2 - p_low*q;
                const float q_low = off3/whole2;
                const float rate2 = 2.0f*root;
                const float envelope = expf(-half);
                const float rest5 = apart_series(half, total2);
                const float total27 = rest5 + 0.16666667f;
                const float back17 = -rest5 + total27;
                const float rest6 = -back17 + total27;
                const float one4 = rest5 - rest6;
                const float two4 = 0.16666667f - back17;
                const float lost27 = one4 + two4;
                const float total28 = envelope*total27;
                const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
                const float rest123 = together_series(half, total2);
                const float total553 = rest123 + 0.5f;
                const float back333 = -rest123 + total553;
                const float rest133 = -back333 + total553;
                const float one113 = rest123 - rest133;
                const float two113 = 0.5f - back333;
                const float lost553 = one113 + two113;
                const float total563 = envelope*total553;
                const float lost563 = envelope*lost553 +
                    fmaf(envelope, total553, -(envelope*total553));
                float fall_;
                float fall_low2;
                float mean;
                float mean_low2;
                if (q < 0.75f) {
                    const float given = q;
                    const float total4 = 1.0f - 0.5f*given;
                    const float back4 = total4 - 1.0f;
                    const float lost4 = -back4 - 0.5f*given;
                    const float decay_series_of = decay_series(given);
                    const float curved = decay_series_of*(given*given);
                    const float total5 = curved + total4;
                    const float back5 = -total4 + total5;
                    const float lost5 = -back5 + curved;
                    const float mean_low = lost4 + lost5 - q_low*
                        (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                    const float total6 = given*total5;
                    const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                    const float total7 = 1.0f - total6;
                    const float back6 = total7 - 1.0f;
                    const float lost7 = -back6 - total6;
                    const float fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                    mean = total5;
                    mean_low2 = mean_low;
                } else {
                    const float sunk = expf(-q);
                    const float sunk_low = -q_low*sunk;
                    const float total8 = 1.0f - sunk;
                    const float back7 = total8 - 1.0f;
                    const float lost8 = -back7 - sunk;
                    const float bottom = q;
                    const float total9 = total8/bottom;
                    const float left4 = -bottom*total9 + total8;
                    const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                    const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                    const float lost9 = left6/bottom;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                    mean = total9;
                    mean_low2 = lost9;
                }
                const float total283 = fall_ + 1.0f;
                const float back202 = total283 - 1.0f;
                const float lost283 = -back202 + fall_;
                float fall2;
                float fall_low4;
                float mean2;
                float mean_low4;
                if (rate2 < 0.75f) {
                    const float given2 = 2.0f*root;
                    const float total10 = 1.0f - 0.5f*given2;
                    const float back8 = total10 - 1.0f;
                    const float lost10 = -back8 - 0.5f*given2;
                    const float decay_series_of2 = decay_series(given2);
                    const float curved2 = decay_series_of2*(given2*given2);
                    const float total11 = curved2 + total10;
                    const float back9 = -total10 + total11;
                    const float lost11 = -back9 + curved2;
                    const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                        (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                    const float total12 = given2*total11;
                    const float lost12 = given2*mean_low3 +
                        fmaf(given2, total11, -(given2*total11));
                    const float total13 = 1.0f - total12;
                    const float back10 = total13 - 1.0f;
                    const float lost13 = -back10 - total12;
                    const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                    fall2 = total13;
                    fall_low4 = fall_low3;
                    mean2 = total11;
                    mean_low4 = mean_low3;
                } else {
                    const float sunk2 = expf(-2.0f*root);
                    const float sunk_low2 = -2.0f*root_low*sunk2;
                    const float total14 = 1.0f - sunk2;
                    const float back11 = total14 - 1.0f;
                    const float lost14 = -back11 - sunk2;
                    const float bottom2 = 2.0f*root;
                    const float total15 = total14/bottom2;
                    const float left7 = -bottom2*total15 + total14;
                    const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                    const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                    const float lost15 = left9/bottom2;
                    fall2 = sunk2;
                    fall_low4 = sunk_low2;
                    mean2 = total15;
                    mean_low4 = lost15;
                }
                const float fast = fall_*fall2;
                const float total162 = fall2*mean;
                const float lost162 = fall2*mean_low2 + fmaf(fall2, mean, -(fall2*mean));
                const float pulled_low = fall_low4*mean + lost162;
                const float total172 = mean2 - total162;
                const float back122 = -mean2 + total172;
                const float rest32 = -back122 + total172;
                const float one22 = mean2 - rest32;
                const float two22 = -back122 - total162;
                const float lost172 = one22 + two22;
                const float total182 = total172/whole2;
                const float left102 = total172 - total182*whole2;
                const float left112 = left102 - fmaf(total182, whole2, -(total182*whole2));
                const float left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
                const float lost182 = left122/whole2;
                const float total192 = fall_*total182;
                const float lost192 = fall_*lost182 + fmaf(fall_, total182, -(fall_*total182));
                const float creep_ = fall_low2*total182 + lost192 + total192;
                const float lost292 = fall_*fall_low4 + fmaf(fall_, fall2, -(fall_*fall2));
                const float low32 = fall2*fall_low2 + lost292;
                const float total302 = fast + 1.0f;
                const float back212 = total302 - 1.0f;
                const float lost302 = -back212 + fast;
                const float total312 = total283*total302;
                const float lost312 = total283*(lost302 + low32) +
                    fmaf(total283, total302, -(total283*total302));
                const float total163 = fall_*mean2;
                const float lost163 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
                const float pulled_low2 = fall_low2*mean2 + lost163;
                const float total173 = mean - total163;
                const float back123 = -mean + total173;
                const float rest34 = -back123 + total173;
                const float one24 = mean - rest34;
                const float two24 = -back123 - total163;
                const float lost173 = one24 + two24;
                const float total183 = total173/whole2;
                const float left103 = total173 - total183*whole2;
                const float left113 = left103 - fmaf(total183, whole2, -(total183*whole2));
                const float left123 = left113 + lost173 + mean_low2 - p_low*total183 - pulled_low2;
                const float lost183 = left123/whole2;
                apart_of = lost28 + total28;
                fall_of = creep_;
                nyquist_of = lost312 + total302*(fall_low2 + lost283) + total312;
                rise_of = lost183 + total183;
                together_of = 2.0f*lost563 + 2.0f*total563;
            }
        } else {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            const float whole3 = (delta*total3 == 0.0f ? 1.0f : delta*total3);
            float fall_;
            float fall_low2;
            float mean;
            float mean_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                const float total8 = 1.0f - sunk;
                const float back7 = total8 - 1.0f;
                const float lost8 = -back7 - sunk;
                const float bottom = q;
                const float total9 = total8/bottom;
                const float left4 = -bottom*total9 + total8;
                const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const float lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            const float twice = 2.0f*fall_;
            const float total283 = fall_ + 1.0f;
            const float back202 = total283 - 1.0f;
            const float lost283 = -back202 + fall_;
            float fall2;
            float fall_low4;
            float mean2;
            float mean_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                const float total14 = 1.0f - sunk2;
                const float back11 = total14 - 1.0f;
                const float lost14 = -back11 - sunk2;
                const float bottom2 = 2.0f*root;
                const float total15 = total14/bottom2;
                const float left7 = -bottom2*total15 + total14;
                const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                const float lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const float fast = fall_*fall2;
            const float total16 = mean2*twice;
            const float lost16 = mean_low4*twice + fmaf(twice, mean2, -(twice*mean2));
            const float total17 = mean - total16;
            const float back12 = -mean + total17;
            const float rest3 = -back12 + total17;
            const float one2 = mean - rest3;
            const float two2 = -back12 - total16;
            const float lost17 = one2 + two2;
            const float total18 = fast*mean;
            const float lost18 = fast*mean_low2 + fmaf(fast, mean, -(fast*mean));
            const float top = total17 + total18;
            const float low = -lost16 + lost17 + lost18 + mean_low2;
            const float total162 = fall2*mean;
            const float lost162 = fall2*mean_low2 + fmaf(fall2, mean, -(fall2*mean));
            const float pulled_low = fall_low4*mean + lost162;
            const float total172 = mean2 - total162;
            const float back122 = -mean2 + total172;
            const float rest32 = -back122 + total172;
            const float one22 = mean2 - rest32;
            const float two22 = -back122 - total162;
            const float lost172 = one22 + two22;
            const float total182 = total172/whole2;
            const float left102 = total172 - total182*whole2;
            const float left112 = left102 - fmaf(total182, whole2, -(total182*whole2));
            const float left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
            const float lost182 = left122/whole2;
            const float total192 = fall_*total182;
            const float lost192 = fall_*lost182 + fmaf(fall_, total182, -(fall_*total182));
            const float creep_ = fall_low2*total182 + lost192 + total192;
            const float lost292 = fall_*fall_low4 + fmaf(fall_, fall2, -(fall_*fall2));
            const float low32 = fall2*fall_low2 + lost292;
            const float total302 = fast + 1.0f;
            const float back212 = total302 - 1.0f;
            const float lost302 = -back212 + fast;
            const float total312 = total283*total302;
            const float lost312 = total283*(lost302 + low32) +
                fmaf(total283, total302, -(total283*total302));
            const float total163 = fall_*mean2;
            const float lost163 = fall_*mean_low4 + fmaf(fall_, mean2, -(fall_*mean2));
            const float pulled_low2 = fall_low2*mean2 + lost163;
            const float total173 = mean - total163;
            const float back123 = -mean + total173;
            const float rest34 = -back123 + total173;
            const float one24 = mean - rest34;
            const float two24 = -back123 - total163;
            const float lost173 = one24 + two24;
            const float total183 = total173/whole2;
            const float left103 = total173 - total183*whole2;
            const float left113 = left103 - fmaf(total183, whole2, -(total183*whole2));
            const float left123 = left113 + lost173 + mean_low2 - p_low*total183 - pulled_low2;
            const float lost183 = left123/whole2;
            const float total523 = 1.0f - fast;
            const float back323 = total523 - 1.0f;
            const float lost523 = -back323 - fast;
            const float total533 = mean*total523;
            const float lost533 = mean*(lost523 - low32) + fmaf(mean, total523, -(mean*total523));
            const float moved_low = lost533 + mean_low2*total523;
            const float total543 = total533/whole2;
            const float left253 = total533 - total543*whole2;
            const float left263 = left253 - fmaf(total543, whole2, -(total543*whole2));
            const float left273 = left263 + moved_low - p_low*total543;
            const float lost543 = left273/whole2;
            apart_of = (low + top)/whole3;
            fall_of = creep_;
            nyquist_of = lost312 + total302*(fall_low2 + lost283) + total312;
            rise_of = lost183 + total183;
            together_of = lost543 + total543;
        }
    }
    *apart_out = apart_of;
    *fall_out = fall_of;
    *nyquist_out = nyquist_of;
    *rise_out = rise_of;
    *together_out = together_of;
    return;
}

// m2 - m1 + m0, M at z = -1 behind a fraction of a period
static float late_apart(float epsilon, float x, float x_low, float y, float y_low, float first,
    float last, float turned) {
    const float total = 1.0f - epsilon;
    const float back = total - 1.0f;
    const float lost = -back - epsilon;
    const float total2 = epsilon*total;
    const float lost2 = epsilon*lost + fmaf(epsilon, total, -(epsilon*total));
    const float total3 = x*y;
    const float lost3 = x*y_low + fmaf(x, y, -(x*y));
    const float both_low = lost3 + x_low*y;
    const float total4 = total2*total3;
    const float lost4 = both_low*total2 + fmaf(total2, total3, -(total2*total3));
    const float low = lost2*total3 + lost4;
    const float total5 = first - 2.0f*total4;
    const float back2 = -first + total5;
    const float rest = -back2 + total5;
    const float one = first - rest;
    const float two = -back2 - 2.0f*total4;
    const float lost5 = one + two;
    const float total6 = -last + total5;
    const float back3 = -total5 + total6;
    const float rest2 = -back3 + total6;
    const float one2 = -rest2 + total5;
    const float two2 = -back3 - last;
    const float lost6 = one2 + two2;
    const float total7 = total6 + turned;
    const float back4 = -total6 + total7;
    const float rest3 = -back4 + total7;
    const float one3 = -rest3 + total6;
    const float two3 = -back4 + turned;
    const float lost7 = one3 + two3;
    const float rest4 = lost5 + lost6;
    const float rest5 = lost7 + rest4;
    const float rest6 = -2.0f*low + rest5;
    return rest6 + total7;
}

// the fraction of a period in a delay
static float late_part(float d) {
    return d - floorf(d);
}

// the root of a cubic on a piece where it bends one way
static float cubic_root(float k0, float k1, float k2, float k3, float low, float high,
    float rise_) {
    const float convex = (2.0f*k2 + 3.0f*k3*(high + low) > 0.0f ? 1.0f : -1.0f);
    const float down = (convex*rise_ > 0.0f ? 1.0f : -1.0f);
    float y = (down > 0.0f ? high : low);
    float moves = 1.0f;
    for (int count_y = 0; count_y < 100; ++count_y) {
        if (moves == 0.0f) { break; }
        const float steep = k1 + y*(2.0f*k2 + 3.0f*k3*y);
        const float some = (steep == 0.0f ? 1.0f : steep);
        const float move = (steep == 0.0f ? 0.0f : (k0 + y*(k1 + y*(k2 + k3*y)))/some);
        const float new_ = fminf(high, -move + y);
        const float new2 = fmaxf(low, new_);
        const float next_y = new2;
        const float next_moves = (down*(-new2 + y) > 0.0f ? 1.0f : 0.0f);
        y = next_y;
        moves = next_moves;
    }
    return y;
}

// what the crossing on a piece, if there is one, adds
static float piece_turns(float k0, float k1, float k2, float k3, float low, float high,
    float at_low, float at_high, float zone, float alpha, float slope, float far, float n1,
    float loss, float together_, float apart_, float center, float beyond, float d) {
    if ((((at_high < 0.0f) && (at_low >= 0.0f)) || ((at_high >= 0.0f) && (at_low < 0.0f))) &&
        (high > low)) {
        const float x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const float y = (zone == 0.0f ? x : (zone == 1.0f ? center + x : 4.0f - x));
        const float rest = (zone == 0.0f ? 4.0f - x : (zone == 1.0f ? beyond - x : x));
        float turned4;
        if ((rest > 0.0f) && (y > 0.0f)) {
            const float off = (zone == 0.0f ? -center + x : (zone == 1.0f ? x : beyond - x));
            const float at = fmaxf(0.0f, y);
            const float still = fmaxf(0.0f, rest);
            const float sine = 2.0f*sqrtf(at*still);
            const float x2 = off*(2.0f*loss - 4.0f);
            const float y2 = loss*sine;
            const float halves = (x2 < 0.0f ? (y2 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned = atan2f((x2 < 0.0f ? -y2 : y2), fabsf(x2));
            const float x3 = -apart_*at + still*together_;
            const float y3 = n1*sine;
            const float halves2 = (x3 < 0.0f ? (y3 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned2 = atan2f((x3 < 0.0f ? -y3 : y3), fabsf(x3));
            const float x4 = alpha*still - at*far;
            const float y4 = sine*slope;
            const float halves3 = (x4 < 0.0f ? (y4 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned3 = atan2f((x4 < 0.0f ? -y4 : y4), fabsf(x4));
            const float half = atan2f((at > 2.0f ? sqrtf(still) : sqrtf(at)),
                (at > 2.0f ? sqrtf(at) : sqrtf(still)));
            const float late = d + 2.0f;
            const float halves4 = -halves + halves2 + halves3 - (at > 2.0f ? late : 0.0f);
            const float share = 0.5f*(-late*(at > 2.0f ? -2.0f*half : 2.0f*half) - turned +
                turned2 + turned3)/3.1415927f;
            const float even = floorf(0.5f*halves4);
            const float left = -even + 0.5f*halves4;
            const float turns = even + (left == 0.5f ? floorf(share) + 1.0f :
                floorf(left + share + 0.5f));
            const float rises = (zone == 2.0f ? -1.0f : 1.0f)*(at_high > at_low ? 1.0f : -1.0f);
            turned4 = -2.0f*rises*turns;
        } else {
            turned4 = 0.0f;
        }
        return turned4;
    }
    return 0.0f;
}

// what the crossings between two points add to the count
static float zone_turns(float k0, float k1, float k2, float k3, float low, float high,
    float at_low, float at_high, float zone, float alpha, float slope, float far, float n1,
    float loss, float together_, float apart_, float center, float beyond, float d) {
    const float disc = -3.0f*k1*k3 + (k2*k2);
    const float some = (fabsf(k2) < 24.0f*fabsf(k3) ? 3.0f*k3 : 1.0f);
    const float at = -k2/some;
    const float cut = ((at < high) && (at > low) && (fabsf(k2) < 24.0f*fabsf(k3)) ? at : low);
    float one;
    float two;
    if (disc < 0.0f) {
        one = low;
        two = low;
    } else {
        const float root = sqrtf(fmaxf(0.0f, disc));
        const float q = -k2 - (k2 < 0.0f ? -root : root);
        const float some2 = (fabsf(q) < 24.0f*fabsf(k3) ? 3.0f*k3 : 1.0f);
        const float at2 = q/some2;
        const float cut2 = ((at2 < high) && (at2 > low) && (fabsf(q) < 24.0f*fabsf(k3)) ? at2 :
            low);
        const float some3 = (fabsf(k1) < 8.0f*fabsf(q) ? q : 1.0f);
        const float at3 = k1/some3;
        const float cut3 = ((at3 < high) && (at3 > low) && (fabsf(k1) < 8.0f*fabsf(q)) ? at3 : low);
        one = cut2;
        two = cut3;
    }
    const float less = fminf(one, two);
    const float more = fmaxf(one, two);
    const float first = fminf(cut, less);
    const float middle = fmaxf(cut, less);
    const float last = fmaxf(middle, more);
    const float middle2 = fminf(middle, more);
    const float height = first*(first*(first*k3 + k2) + k1) + k0;
    const float height2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2));
    const float height3 = k0 + last*(k1 + last*(k2 + k3*last));
    const float found = piece_turns(k0, k1, k2, k3, low, first, at_low, height, zone, alpha, slope,
        far, n1, loss, together_, apart_, center, beyond, d);
    const float found2 = found + piece_turns(k0, k1, k2, k3, first, middle2, height, height2, zone,
        alpha, slope, far, n1, loss, together_, apart_, center, beyond, d);
    const float found3 = found2 + piece_turns(k0, k1, k2, k3, middle2, last, height2, height3,
        zone, alpha, slope, far, n1, loss, together_, apart_, center, beyond, d);
    const float found4 = found3 + piece_turns(k0, k1, k2, k3, last, high, height3, at_high, zone,
        alpha, slope, far, n1, loss, together_, apart_, center, beyond, d);
    return found4;
}

// roots outside the unit circle, behind a fractional delay
static float late_roots(float alpha, float beta, float d, float m2, float m0, float at_one,
    float at_minus_one, float loss, float together_, float apart_) {
    const float slope = alpha + beta;
    const float wall_far = alpha + 2.0f*beta;
    const float force = beta*slope;
    const float across = -m0 + m2;
    const float square = m0*m2;
    const float even = together_*(m0 + m2);
    const float linear = (across*across) - even;
    const float pushed_ = alpha*together_;
    const float lost = (loss*loss);
    const float near0 = (at_one - pushed_)*(at_one + pushed_);
    const float near1 = -(alpha*alpha)*linear - at_one*(2.0f - loss) - force*
        (together_*together_) + lost;
    const float near2 = -(alpha*alpha)*square - force*linear - loss + 1.0f;
    const float near3 = -force*square;
    const float square2 = m0*m2;
    const float even2 = apart_*(m0 + m2);
    const float linear2 = (across*across) - even2;
    const float pushed2 = apart_*wall_far;
    const float lost2 = (loss*loss);
    const float far0 = (at_minus_one - pushed2)*(at_minus_one + pushed2);
    const float far1 = (apart_*apart_)*force - at_minus_one*(2.0f - loss) - linear2*
        (wall_far*wall_far) + lost2;
    const float far2 = force*linear2 - loss - square2*(wall_far*wall_far) + 1.0f;
    const float far3 = force*square2;
    const float middle = 2.0f*at_one/(2.0f - loss);
    const float rest = 2.0f*at_minus_one/(2.0f - loss);
    const float sine = 0.25f*middle*rest;
    const float tilt = -0.25f*middle + 0.25f*rest;
    const float real = -0.25f*apart_*middle + 0.25f*rest*together_;
    const float size = (across*across);
    const float lost3 = (loss*loss);
    const float one = (real*real) + sine*size;
    const float two = -real*(m0 + m2) + size*tilt;
    const float three = m0*m2;
    const float wave = 0.25f*alpha*rest - 0.25f*middle*wall_far;
    const float wall = sine*(slope*slope) + (wave*wave);
    const float own0 = lost3*sine - one*wall;
    const float own1 = -force*one + lost3*tilt - two*wall;
    const float own2 = -force*two - loss - three*wall + 1.0f;
    const float own3 = -force*three;
    const float one2 = 0.5f*middle;
    const float two2 = 0.5f*rest;
    const float before = -one2*(-one2*(-one2*own3 + own2) + own1) + own0;
    const float after = own0 + two2*(own1 + two2*(own2 + own3*two2));
    const float zone = 0.0f;
    const float zone2 = 1.0f;
    const float zone3 = 2.0f;
    const float side = (slope >= 0.0f ? 1.0f : -1.0f);
    const float end = -d + (wall_far > 0.0f ? side : 0.0f) +
        (apart_ > 0.0f ? (across >= 0.0f ? 1.0f : -1.0f) : 0.0f) - 3.0f;
    const float total = (((((((near2 == 0.0f) && (near3 < 0.0f)) || (near2 < 0.0f)) &&
        (near1 == 0.0f)) || (near1 < 0.0f)) && (near0 == 0.0f)) || (near0 < 0.0f) ?
        (alpha > 0.0f ? 0.0f : side) : 0.0f) +
        zone_turns(far0, far1, far2, far3, zone, two2, far0, after, zone3, alpha, slope, wall_far,
        across, loss, together_, apart_, middle, rest, d) +
        zone_turns(near0, near1, near2, near3, zone, one2, near0, before, zone, alpha, slope,
        wall_far, across, loss, together_, apart_, middle, rest, d) +
        zone_turns(own0, own1, own2, own3, -one2, two2, before, after, zone2, alpha, slope,
        wall_far, across, loss, together_, apart_, middle, rest, d);
    return total - (((((((far2 == 0.0f) && (far3 < 0.0f)) || (far2 < 0.0f)) && (far1 == 0.0f)) ||
        (far1 < 0.0f)) && (far0 == 0.0f)) || (far0 < 0.0f) ? end : 0.0f);
}

// the same, or 1/2 where it is 0
static float some_part(float d) {
    const float part = d - floorf(d);
    if (part == 0.0f) {
        return 0.5f;
    }
    return part;
}

// 1 where the loop is stable, else 0
static float stable(float roots, float alpha, float beta, float gamma, float delta) {
    const float swing_ = sqrtf(gamma);
    if ((!((alpha == 0.0f) && (beta == 0.0f) && (delta == 0.0f))) &&
        (!((delta < 5.9604645e-07f) && (gamma > 1.0f) &&
        (swing_ >= 4.194304e+06f*fabsf(sinf(swing_))))) && (alpha > -gamma) && (roots == 0.0f)) {
        return 1.0f;
    }
    return 0.0f;
}

// whole periods of a delay
static float whole_part(float d) {
    return floorf(d);
}

// roots outside the unit circle
static float whole_roots(float alpha, float beta, float d, float n1, float n0, float at_one,
    float at_minus_one, float loss, float together_, float apart_) {
    const float e = 1.0f - loss;
    const float slope = alpha + beta;
    const float wall_far = alpha + 2.0f*beta;
    const float force = beta*slope;
    const float cross = n0*n1;
    const float lost = (loss*loss);
    const float square = cross*force + e;
    const float push = alpha*together_;
    const float pull = apart_*wall_far;
    const float near0 = (at_one - push)*(at_one + push);
    const float near1 = (alpha*alpha)*cross - at_one*(e + 1.0f) - force*(together_*together_) +
        lost;
    const float far0 = (at_minus_one - pull)*(at_minus_one + pull);
    const float far1 = (apart_*apart_)*force - at_minus_one*(e + 1.0f) - cross*
        (wall_far*wall_far) + lost;
    const float center = 2.0f*at_one/(e + 1.0f);
    const float beyond = 2.0f*at_minus_one/(e + 1.0f);
    const float sine = 0.25f*beyond*center;
    const float tilt = 0.25f*beyond - 0.25f*center;
    const float real = -0.25f*apart_*center + 0.25f*beyond*together_;
    const float m0 = (n1*n1)*sine + (real*real);
    const float m1 = (n1*n1)*tilt - n1*real;
    const float wave = 0.25f*alpha*beyond - 0.25f*center*wall_far;
    const float wall = sine*(slope*slope) + (wave*wave);
    const float own0 = lost*sine - m0*wall;
    const float own1 = -force*m0 + lost*tilt - m1*wall;
    const float own2 = e - force*m1;
    const float square2 = (near1*near1);
    const float product = 4.0f*near0*square;
    const float size = square2 + fabsf(product);
    const float square3 = (own1*own1);
    const float product2 = 4.0f*own0*own2;
    const float size2 = square3 + fabsf(product2);
    const float square4 = (far1*far1);
    const float product3 = 4.0f*far0*square;
    const float size3 = square4 + fabsf(product3);
    const float side = (slope >= 0.0f ? 1.0f : -1.0f);
    const float end = -d + (wall_far > 0.0f ? side : 0.0f) +
        (apart_ > 0.0f ? (n1 >= 0.0f ? 1.0f : -1.0f) : 0.0f) - 3.0f;
    float disc4;
    if ((size >= size2) && (size2 <= size3)) {
        const float disc2 = -product2 + square3;
        disc4 = disc2;
    } else {
        if ((size > size3) && (size2 > size3)) {
            const float disc3 = -product3 + square4;
            disc4 = disc3;
        } else {
            const float disc = -product + square2;
            disc4 = disc;
        }
    }
    float total3;
    if (disc4 >= 0.0f) {
        float low;
        float high;
        if (near1 >= 0.0f) {
            const float positive = disc4;
            const float root = sqrtf(positive);
            const float q = -0.5f*near1 - 0.5f*root;
            float one;
            if (square == 0.0f) {
                one = -1.0f;
            } else {
                const float lead_ = square;
                one = q/lead_;
            }
            float two;
            if (q == 0.0f) {
                two = -1.0f;
            } else {
                const float own = q;
                two = near0/own;
            }
            low = one;
            high = two;
        } else {
            const float positive = disc4;
            const float root = sqrtf(positive);
            const float q = -0.5f*near1 + 0.5f*root;
            float one;
            if (square == 0.0f) {
                one = -1.0f;
            } else {
                const float lead_ = square;
                one = q/lead_;
            }
            float two;
            if (q == 0.0f) {
                two = -1.0f;
            } else {
                const float own = q;
                two = near0/own;
            }
            low = two;
            high = one;
        }
        float low3;
        float high3;
        if (far1 >= 0.0f) {
            const float positive = disc4;
            const float root = sqrtf(positive);
            const float q3 = -0.5f*far1 - 0.5f*root;
            float one3;
            if (square == 0.0f) {
                one3 = -1.0f;
            } else {
                const float lead3 = square;
                one3 = q3/lead3;
            }
            float two3;
            if (q3 == 0.0f) {
                two3 = -1.0f;
            } else {
                const float own4 = q3;
                two3 = far0/own4;
            }
            low3 = one3;
            high3 = two3;
        } else {
            const float positive = disc4;
            const float root = sqrtf(positive);
            const float q3 = -0.5f*far1 + 0.5f*root;
            float one3;
            if (square == 0.0f) {
                one3 = -1.0f;
            } else {
                const float lead3 = square;
                one3 = q3/lead3;
            }
            float two3;
            if (q3 == 0.0f) {
                two3 = -1.0f;
            } else {
                const float own4 = q3;
                two3 = far0/own4;
            }
            low3 = two3;
            high3 = one3;
        }
        const float edge = (high3 > low ? low : high3);
        const float edge2 = (high < low3 ? high : low3);
        float found;
        if ((edge < 4.0f) && (high3 > 0.0f) && (low > 0.0f)) {
            const float late = d + 2.0f;
            float low2;
            if (own1 >= 0.0f) {
                float one2;
                if (own2 == 0.0f) {
                    one2 = -1.0f;
                } else {
                    const float positive = disc4;
                    const float root = sqrtf(positive);
                    const float q2 = -0.5f*own1 - 0.5f*root;
                    const float lead2 = own2;
                    one2 = q2/lead2;
                }
                low2 = one2;
            } else {
                const float positive = disc4;
                const float root = sqrtf(positive);
                const float q2 = -0.5f*own1 + 0.5f*root;
                float two2;
                if (q2 == 0.0f) {
                    two2 = -1.0f;
                } else {
                    const float own3 = q2;
                    two2 = own0/own3;
                }
                low2 = two2;
            }
            const float at = ((beyond - low2 > 0.0f) && (center + low2 > 0.0f) &&
                (edge > fabsf(low2)) ? center + low2 : (high3 > low ? low : 4.0f - high3));
            const float still = ((beyond - low2 > 0.0f) && (center + low2 > 0.0f) &&
                (edge > fabsf(low2)) ? beyond - low2 : (high3 > low ? 4.0f - low : high3));
            const float away = ((beyond - low2 > 0.0f) && (center + low2 > 0.0f) &&
                (edge > fabsf(low2)) ? low2 : (high3 > low ? -center + low : beyond - high3));
            const float at2 = at;
            const float still2 = still;
            const float at3 = fmaxf(0.0f, at2);
            const float still3 = fmaxf(0.0f, still2);
            const float sine2 = 2.0f*sqrtf(at3*still3);
            const float x = away*(-2.0f*e - 2.0f);
            const float y = loss*sine2;
            const float halves = (x < 0.0f ? (y < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned = atan2f((x < 0.0f ? -y : y), fabsf(x));
            const float x2 = -apart_*at3 + still3*together_;
            const float y2 = n1*sine2;
            const float halves2 = (x2 < 0.0f ? (y2 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned2 = atan2f((x2 < 0.0f ? -y2 : y2), fabsf(x2));
            const float x3 = alpha*still3 - at3*wall_far;
            const float y3 = sine2*slope;
            const float halves3 = (x3 < 0.0f ? (y3 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned3 = atan2f((x3 < 0.0f ? -y3 : y3), fabsf(x3));
            const float half = atan2f((at3 > 2.0f ? sqrtf(still3) : sqrtf(at3)),
                (at3 > 2.0f ? sqrtf(at3) : sqrtf(still3)));
            const float halves4 = -halves + halves2 + halves3 - (at3 > 2.0f ? late : 0.0f);
            const float share = 0.5f*(-late*(at3 > 2.0f ? -2.0f*half : 2.0f*half) - turned +
                turned2 + turned3)/3.1415927f;
            const float even = floorf(0.5f*halves4);
            const float left = -even + 0.5f*halves4;
            const float turns = even + (left == 0.5f ? floorf(share) + 1.0f :
                floorf(left + share + 0.5f));
            found = 2.0f*turns;
        } else {
            found = 0.0f;
        }
        const float total = found;
        float found2;
        if ((edge2 < 4.0f) && (high > 0.0f) && (low3 > 0.0f)) {
            const float late2 = d + 2.0f;
            float high2;
            if (own1 >= 0.0f) {
                const float positive = disc4;
                const float root = sqrtf(positive);
                const float q2 = -0.5f*own1 - 0.5f*root;
                float two2;
                if (q2 == 0.0f) {
                    two2 = -1.0f;
                } else {
                    const float own3 = q2;
                    two2 = own0/own3;
                }
                high2 = two2;
            } else {
                float one2;
                if (own2 == 0.0f) {
                    one2 = -1.0f;
                } else {
                    const float positive = disc4;
                    const float root = sqrtf(positive);
                    const float q2 = -0.5f*own1 + 0.5f*root;
                    const float lead2 = own2;
                    one2 = q2/lead2;
                }
                high2 = one2;
            }
            const float at4 = ((beyond - high2 > 0.0f) && (center + high2 > 0.0f) &&
                (edge2 > fabsf(high2)) ? center + high2 : (high < low3 ? high : 4.0f - low3));
            const float still4 = ((beyond - high2 > 0.0f) && (center + high2 > 0.0f) &&
                (edge2 > fabsf(high2)) ? beyond - high2 : (high < low3 ? 4.0f - high : low3));
            const float away2 = ((beyond - high2 > 0.0f) && (center + high2 > 0.0f) &&
                (edge2 > fabsf(high2)) ? high2 : (high < low3 ? -center + high : beyond - low3));
            const float at5 = at4;
            const float still5 = still4;
            const float at6 = fmaxf(0.0f, at5);
            const float still6 = fmaxf(0.0f, still5);
            const float sine3 = 2.0f*sqrtf(at6*still6);
            const float x4 = away2*(-2.0f*e - 2.0f);
            const float y4 = loss*sine3;
            const float halves5 = (x4 < 0.0f ? (y4 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned4 = atan2f((x4 < 0.0f ? -y4 : y4), fabsf(x4));
            const float x5 = -apart_*at6 + still6*together_;
            const float y5 = n1*sine3;
            const float halves6 = (x5 < 0.0f ? (y5 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned5 = atan2f((x5 < 0.0f ? -y5 : y5), fabsf(x5));
            const float x6 = alpha*still6 - at6*wall_far;
            const float y6 = sine3*slope;
            const float halves7 = (x6 < 0.0f ? (y6 < 0.0f ? -1.0f : 1.0f) : 0.0f);
            const float turned6 = atan2f((x6 < 0.0f ? -y6 : y6), fabsf(x6));
            const float half2 = atan2f((at6 > 2.0f ? sqrtf(still6) : sqrtf(at6)),
                (at6 > 2.0f ? sqrtf(at6) : sqrtf(still6)));
            const float halves8 = -halves5 + halves6 + halves7 - (at6 > 2.0f ? late2 : 0.0f);
            const float share2 = 0.5f*(-late2*(at6 > 2.0f ? -2.0f*half2 : 2.0f*half2) - turned4 +
                turned5 + turned6)/3.1415927f;
            const float even2 = floorf(0.5f*halves8);
            const float left2 = -even2 + 0.5f*halves8;
            const float turns2 = even2 + (left2 == 0.5f ? floorf(share2) + 1.0f :
                floorf(left2 + share2 + 0.5f));
            found2 = -2.0f*turns2;
        } else {
            found2 = 0.0f;
        }
        const float total2 = found2 + total;
        total3 = total2;
    } else {
        total3 = 0.0f;
    }
    const float total4 = total3 + (((((near1 == 0.0f) && (square < 0.0f)) || (near1 < 0.0f)) &&
        (near0 == 0.0f)) || (near0 < 0.0f) ? (alpha > 0.0f ? 0.0f : side) : 0.0f);
    return total4 - (((((far1 == 0.0f) && (square < 0.0f)) || (far1 < 0.0f)) && (far0 == 0.0f)) ||
        (far0 < 0.0f) ? end : 0.0f);
}

// the imaginary part of A/(z M) at z = exp(2 j psi); the real part of A/(z M) at z = exp(2 j psi)
static void ahead_in_phase(float psi, float at_one, float at_minus_one, float loss,
    float together_, float apart_, float across, float *ahead_out, float *in_phase_out) {
    const float t = tanf(psi);
    const float square = (t*t);
    const float low = fmaf(t, t, -(t*t));
    const float taken = at_minus_one*square;
    const float total = at_one - taken;
    const float back = -at_one + total;
    const float rest = -back + total;
    const float one = at_one - rest;
    const float two = -back - taken;
    const float lost = one + two;
    const float missed = at_minus_one*low + fmaf(at_minus_one, square, -(at_minus_one*square));
    const float lost2 = lost - missed;
    const float total2 = lost2 + total;
    const float back2 = -total + total2;
    const float lost3 = -back2 + lost2;
    const float taken2 = apart_*square;
    const float total3 = -taken2 + together_;
    const float back3 = -together_ + total3;
    const float rest2 = -back3 + total3;
    const float one2 = -rest2 + together_;
    const float two2 = -back3 - taken2;
    const float lost4 = one2 + two2;
    const float missed2 = apart_*low + fmaf(apart_, square, -(apart_*square));
    const float lost5 = lost4 - missed2;
    const float total4 = lost5 + total3;
    const float back4 = -total3 + total4;
    const float lost6 = -back4 + lost5;
    const float above_j = 2.0f*loss*t;
    const float below_j = across*t;
    const float rest3 = (below_j*below_j) + 2.0f*lost6*total4;
    const float size = rest3 + (total4*total4);
    const float low2 = above_j*lost6 - below_j*lost3;
    const float found = above_j*total4 - below_j*total2;
    const float found2 = found + low2;
    const float ahead_of = found2/size;
    const float low22 = lost3*total4 + lost6*total2;
    const float rest4 = above_j*below_j + low22;
    const float found3 = rest4 + total2*total4;
    const float in_phase_of = found3/size;
    *ahead_out = ahead_of;
    *in_phase_out = in_phase_of;
    return;
}

// (n1 - n0)/delta; 1 + a + e; n1 + n0
static void apart_nyquist_together(float gamma, float delta, float *apart_out, float *nyquist_out,
    float *together_out) {
    const float half = 0.5f*delta;
    const float square = (half*half);
    const float total = -gamma + square;
    const float back = -square + total;
    const float rest = -back + total;
    const float one = -rest + square;
    const float two = -back - gamma;
    const float lost = one + two;
    const float rest2 = lost + fmaf(half, half, -(half*half));
    const float total2 = rest2 + total;
    const float back2 = -total + total2;
    const float lost2 = -back2 + rest2;
    float apart_of;
    float nyquist_of;
    float together_of;
    if (total2 < 0.0f) {
        const float reach = 0.25f*gamma;
        if (reach < 1.0f) {
            const float square2 = total2;
            const float envelope = expf(-half);
            const float rest5 = apart_series(half, total2);
            const float total27 = rest5 + 0.16666667f;
            const float back17 = -rest5 + total27;
            const float rest6 = -back17 + total27;
            const float one4 = rest5 - rest6;
            const float two4 = 0.16666667f - back17;
            const float lost27 = one4 + two4;
            const float total28 = envelope*total27;
            const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
            const float twice2 = 2.0f*envelope;
            const float rest12 = together_series(half, total2);
            const float total55 = rest12 + 0.5f;
            const float back33 = -rest12 + total55;
            const float rest13 = -back33 + total55;
            const float one11 = rest12 - rest13;
            const float two11 = 0.5f - back33;
            const float lost55 = one11 + two11;
            const float total56 = envelope*total55;
            const float lost56 = envelope*lost55 + fmaf(envelope, total55, -(envelope*total55));
            float even;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total19 = 0.5f*given3 + 1.0f;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total20 = curved3 + total19;
                even = total20;
            } else {
                const float size = fabsf(total2);
                const float root = sqrtf(size);
                const float cosine = cosf(root);
                even = cosine;
            }
            const float total262 = even*twice2;
            if (total262 > 0.0f) {
                const float e = expf(-delta);
                const float total252 = e + 1.0f;
                const float back18 = total252 - 1.0f;
                const float lost252 = -back18 + e;
                const float total272 = total252 + total262;
                const float back19 = -total252 + total272;
                const float lost272 = -back19 + total262;
                float even_low2;
                if (square2 > -1.5f) {
                    const float given3 = square2;
                    const float total19 = 0.5f*given3 + 1.0f;
                    const float back13 = total19 - 1.0f;
                    const float lost19 = -back13 + 0.5f*given3;
                    const float cos_series_of = cos_series(given3);
                    const float curved3 = cos_series_of*(given3*given3);
                    const float total20 = curved3 + total19;
                    const float back14 = -total19 + total20;
                    const float lost20 = -back14 + curved3;
                    const float even_low = lost19 + 0.5f*lost2 + lost20;
                    even_low2 = even_low;
                } else {
                    const float size = fabsf(total2);
                    const float root = sqrtf(size);
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float sine = sinf(root);
                    even_low2 = -root_low*sine;
                }
                const float lost262 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                apart_of = lost28 + total28;
                nyquist_of = lost252 + lost262 + lost272 + total272;
                together_of = 2.0f*lost56 + 2.0f*total56;
            } else {
                const float size = fabsf(total2);
                const float root = sqrtf(size);
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float expm1_of = expm1f(-half);
                const float grown = -0.5f*expm1_of;
                const float angle = 0.5f*root;
                const float wave = cosf(angle);
                const float sin_of = sinf(angle);
                const float back72 = 0.5f*root_low*sin_of;
                const float total92 = -back72 + wave;
                const float back82 = total92 - wave;
                const float rest32 = -back82 + total92;
                const float one22 = -rest32 + wave;
                const float two22 = -back72 - back82;
                const float lost92 = one22 + two22;
                const float total102 = (total92*total92);
                const float lost102 = fmaf(total92, total92, -(total92*total92));
                const float low2 = lost102 + 2.0f*lost92*total92;
                const float total112 = envelope*total102;
                const float lost112 = envelope*low2 +
                    fmaf(envelope, total102, -(envelope*total102));
                const float total122 = (grown*grown) + total112;
                const float back92 = -total112 + total122;
                const float rest42 = -back92 + total122;
                const float one32 = -rest42 + total112;
                const float two32 = -back92 + (grown*grown);
                const float lost122 = one32 + two32;
                const float low22 = lost112 + lost122;
                apart_of = lost28 + total28;
                nyquist_of = 4.0f*low22 + 4.0f*total122;
                together_of = 2.0f*lost56 + 2.0f*total56;
            }
        } else {
            const float size = fabsf(total2);
            const float root = sqrtf(size);
            const float square2 = total2;
            const float envelope = expf(-half);
            const float stiff = gamma;
            const float mean3 = decay(delta);
            const float twice2 = 2.0f*envelope;
            float even;
            float odd;
            float odd_low2;
            if (square2 > -1.5f) {
                const float given3 = square2;
                const float total19 = 0.5f*given3 + 1.0f;
                const float cos_series_of = cos_series(given3);
                const float curved3 = cos_series_of*(given3*given3);
                const float total20 = curved3 + total19;
                const float sin_series_of = sin_series(given3);
                const float bent = given3*sin_series_of;
                const float total21 = bent + 1.0f;
                const float back15 = total21 - 1.0f;
                const float lost21 = -back15 + bent;
                const float odd_low = 0.16666667f*lost2 + lost21;
                even = total20;
                odd = total21;
                odd_low2 = odd_low;
            } else {
                const float sign_low = -lost2;
                const float left = -(root*root) + size;
                const float left2 = left - fmaf(root, root, -(root*root));
                const float left3 = left2 + sign_low;
                const float whole = (root == 0.0f ? 1.0f : root);
                const float root_low = 0.5f*left3/whole;
                const float sine = sinf(root);
                const float cosine = cosf(root);
                const float some = root;
                const float total22 = sine/some;
                const float left10 = sine - some*total22;
                const float left11 = left10 - fmaf(total22, some, -(total22*some));
                const float left12 = cosine*root_low + left11 - root_low*total22;
                const float lost22 = left12/some;
                even = cosine;
                odd = total22;
                odd_low2 = lost22;
            }
            const float total24 = envelope*odd;
            const float lost24 = envelope*odd_low2 + fmaf(envelope, odd, -(envelope*odd));
            const float total25 = mean3 - total24;
            const float back16 = -mean3 + total25;
            const float rest4 = -back16 + total25;
            const float one3 = mean3 - rest4;
            const float two3 = -back16 - total24;
            const float lost25 = one3 + two3;
            const float total26 = total25/stiff;
            const float left13 = -stiff*total26 + total25;
            const float left14 = left13 - fmaf(total26, stiff, -(total26*stiff));
            const float left15 = left14 - lost24 + lost25;
            const float lost26 = left15/stiff;
            const float total262 = even*twice2;
            float count;
            if (root < 4096.0f) {
                count = floorf(0.5f*root/3.1415927f + 0.5f);
            } else {
                count = 0.0f;
            }
            const float turns = (count*count);
            const float total142 = 39.478416f*turns;
            const float lost142 = fmaf(turns, 39.478416f, -(turns*39.478416f));
            const float total152 = 1.1614864e-06f*turns;
            const float lost152 = fmaf(turns, 1.1614864e-06f, -(turns*1.1614864e-06f));
            const float total162 = -total142 - total2;
            const float back102 = total162 + total2;
            const float rest52 = -back102 + total162;
            const float one42 = -rest52 - total2;
            const float two42 = -back102 - total142;
            const float lost162 = one42 + two42;
            const float total172 = -lost142 + total162;
            const float back112 = -total162 + total172;
            const float rest62 = -back112 + total172;
            const float one5 = -rest62 + total162;
            const float two5 = -back112 - lost142;
            const float lost172 = one5 + two5;
            const float total182 = -total152 + total172;
            const float back122 = -total172 + total182;
            const float rest7 = -back122 + total182;
            const float one6 = -rest7 + total172;
            const float two6 = -back122 - total152;
            const float lost182 = one6 + two6;
            const float total192 = -lost2 + total182;
            const float back132 = -total182 + total192;
            const float rest8 = -back132 + total192;
            const float one7 = -rest8 + total182;
            const float two7 = -back132 - lost2;
            const float lost192 = one7 + two7;
            const float low32 = -lost152 + lost162 + lost172 + lost182 + lost192 + 1.1704737e-14f*
                turns;
            const float total202 = low32 + total192;
            const float total212 = 6.2831855f*count;
            const float total222 = root + total212;
            const float whole32 = (total222 == 0.0f ? 1.0f : total222);
            const float total232 = total202/whole32;
            const float far = (total232*total232);
            if (total262 > 0.0f) {
                if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float e = expf(-delta);
                    const float total252 = e + 1.0f;
                    const float back18 = total252 - 1.0f;
                    const float lost252 = -back18 + e;
                    const float total272 = total252 + total262;
                    const float back19 = -total252 + total272;
                    const float lost272 = -back19 + total262;
                    const float back142 = -total192 + total202;
                    const float rest9 = -back142 + total202;
                    const float one8 = -rest9 + total192;
                    const float two8 = -back142 + low32;
                    const float lost202 = one8 + two8;
                    const float lost212 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                    const float back152 = -root + total222;
                    const float rest10 = -back152 + total222;
                    const float one9 = -rest10 + root;
                    const float two9 = -back152 + total212;
                    const float lost222 = one9 + two9;
                    const float both_low = -1.7484555e-07f*count + lost212 + lost222 + root_low;
                    const float left102 = total202 - total232*whole32;
                    const float left112 = left102 - fmaf(total232, whole32, -(total232*whole32));
                    const float left122 = -both_low*total232 + left112 + lost202;
                    const float lost232 = left122/whole32;
                    const float eta = total232;
                    const float eta_low = lost232;
                    const float total242 = (eta*eta);
                    const float lost242 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                    const float cos_series_of2 = cos_series(-total242);
                    const float bent2 = cos_series_of2*(total242*total242);
                    const float total253 = -bent2 + 0.5f*total242;
                    const float back162 = -0.5f*total242 + total253;
                    const float lost253 = -back162 - bent2;
                    const float sin_series_of2 = sin_series(-total242);
                    const float total263 = -sin_series_of2*total242 + 1.0f;
                    const float lift_low = 0.5f*lost242*total263 + lost253;
                    const float given22 = half;
                    const float total29 = 1.0f - 0.5f*given22;
                    const float back182 = total29 - 1.0f;
                    const float lost292 = -back182 - 0.5f*given22;
                    const float decay_series_of3 = decay_series(given22);
                    const float curved22 = decay_series_of3*(given22*given22);
                    const float total302 = curved22 + total29;
                    const float back192 = -total29 + total302;
                    const float lost302 = -back192 + curved22;
                    const float mean_low5 = lost292 + lost302;
                    const float total312 = given22*total302;
                    const float lost312 = given22*mean_low5 +
                        fmaf(given22, total302, -(given22*total302));
                    const float total32 = 1.0f - total312;
                    const float back202 = total32 - 1.0f;
                    const float lost32 = -back202 - total312;
                    const float fall_low5 = -lost312 + lost32;
                    const float total33 = 1.0f - total32;
                    const float back212 = total33 - 1.0f;
                    const float lost33 = -back212 - total32;
                    const float low42 = -fall_low5 + lost33;
                    const float total34 = low42 + total33;
                    const float back22 = -total33 + total34;
                    const float lost34 = -back22 + low42;
                    const float total35 = (total34*total34);
                    const float lost35 = 2.0f*lost34*total34 +
                        fmaf(total34, total34, -(total34*total34));
                    const float total36 = total253*total32;
                    const float lost36 = lift_low*total32 +
                        fmaf(total32, total253, -(total32*total253));
                    const float total37 = total35 + 2.0f*total36;
                    const float back23 = -total35 + total37;
                    const float rest11 = -back23 + total37;
                    const float one10 = -rest11 + total35;
                    const float two10 = -back23 + 2.0f*total36;
                    const float lost37 = one10 + two10;
                    const float low5 = 2.0f*fall_low5*total253 + lost35 + 2.0f*lost36 + lost37;
                    const float total38 = total37/stiff;
                    const float left16 = -stiff*total38 + total37;
                    const float left17 = left16 - fmaf(total38, stiff, -(total38*stiff));
                    const float left18 = left17 + low5;
                    const float lost38 = left18/stiff;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const float sine = sinf(root);
                        even_low2 = -root_low*sine;
                    }
                    const float lost262 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                    apart_of = lost26 + total26;
                    nyquist_of = lost252 + lost262 + lost272 + total272;
                    together_of = lost38 + total38;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float e = expf(-delta);
                    const float total252 = e + 1.0f;
                    const float back18 = total252 - 1.0f;
                    const float lost252 = -back18 + e;
                    const float total272 = total252 + total262;
                    const float back19 = -total252 + total272;
                    const float lost272 = -back19 + total262;
                    const float back73 = -0.5f*root_low*wave;
                    const float total93 = -back73 + sin_of;
                    const float back83 = -sin_of + total93;
                    const float rest33 = -back83 + total93;
                    const float one23 = -rest33 + sin_of;
                    const float two23 = -back73 - back83;
                    const float lost93 = one23 + two23;
                    const float total103 = (total93*total93);
                    const float lost103 = fmaf(total93, total93, -(total93*total93));
                    const float low4 = lost103 + 2.0f*lost93*total93;
                    const float total113 = envelope*total103;
                    const float lost113 = envelope*low4 +
                        fmaf(envelope, total103, -(envelope*total103));
                    const float total123 = (grown*grown) + total113;
                    const float back93 = -total113 + total123;
                    const float rest43 = -back93 + total123;
                    const float one33 = -rest43 + total113;
                    const float two33 = -back93 + (grown*grown);
                    const float lost123 = one33 + two33;
                    const float low23 = lost113 + lost123;
                    const float total132 = total123/stiff;
                    const float left72 = -stiff*total132 + total123;
                    const float left82 = left72 - fmaf(total132, stiff, -(total132*stiff));
                    const float left92 = left82 + low23;
                    const float lost132 = left92/stiff;
                    float even_low2;
                    if (square2 > -1.5f) {
                        const float given3 = square2;
                        const float total19 = 0.5f*given3 + 1.0f;
                        const float back13 = total19 - 1.0f;
                        const float lost19 = -back13 + 0.5f*given3;
                        const float cos_series_of = cos_series(given3);
                        const float curved3 = cos_series_of*(given3*given3);
                        const float total20 = curved3 + total19;
                        const float back14 = -total19 + total20;
                        const float lost20 = -back14 + curved3;
                        const float even_low = lost19 + 0.5f*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const float sine = sinf(root);
                        even_low2 = -root_low*sine;
                    }
                    const float lost262 = even_low2*twice2 + fmaf(twice2, even, -(twice2*even));
                    apart_of = lost26 + total26;
                    nyquist_of = lost252 + lost262 + lost272 + total272;
                    together_of = 4.0f*lost132 + 4.0f*total132;
                }
            } else {
                if ((count > 0.0f) && (far < 1.5f) && (half < 0.75f)) {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float back72 = 0.5f*root_low*sin_of;
                    const float total92 = -back72 + wave;
                    const float back82 = total92 - wave;
                    const float rest32 = -back82 + total92;
                    const float one22 = -rest32 + wave;
                    const float two22 = -back72 - back82;
                    const float lost92 = one22 + two22;
                    const float total102 = (total92*total92);
                    const float lost102 = fmaf(total92, total92, -(total92*total92));
                    const float low2 = lost102 + 2.0f*lost92*total92;
                    const float total112 = envelope*total102;
                    const float lost112 = envelope*low2 +
                        fmaf(envelope, total102, -(envelope*total102));
                    const float total122 = (grown*grown) + total112;
                    const float back92 = -total112 + total122;
                    const float rest42 = -back92 + total122;
                    const float one32 = -rest42 + total112;
                    const float two32 = -back92 + (grown*grown);
                    const float lost122 = one32 + two32;
                    const float low22 = lost112 + lost122;
                    const float back142 = -total192 + total202;
                    const float rest9 = -back142 + total202;
                    const float one8 = -rest9 + total192;
                    const float two8 = -back142 + low32;
                    const float lost202 = one8 + two8;
                    const float lost212 = fmaf(count, 6.2831855f, -(count*6.2831855f));
                    const float back152 = -root + total222;
                    const float rest10 = -back152 + total222;
                    const float one9 = -rest10 + root;
                    const float two9 = -back152 + total212;
                    const float lost222 = one9 + two9;
                    const float both_low = -1.7484555e-07f*count + lost212 + lost222 + root_low;
                    const float left102 = total202 - total232*whole32;
                    const float left112 = left102 - fmaf(total232, whole32, -(total232*whole32));
                    const float left122 = -both_low*total232 + left112 + lost202;
                    const float lost232 = left122/whole32;
                    const float eta = total232;
                    const float eta_low = lost232;
                    const float total242 = (eta*eta);
                    const float lost242 = 2.0f*eta*eta_low + fmaf(eta, eta, -(eta*eta));
                    const float cos_series_of2 = cos_series(-total242);
                    const float bent2 = cos_series_of2*(total242*total242);
                    const float total253 = -bent2 + 0.5f*total242;
                    const float back162 = -0.5f*total242 + total253;
                    const float lost253 = -back162 - bent2;
                    const float sin_series_of2 = sin_series(-total242);
                    const float total263 = -sin_series_of2*total242 + 1.0f;
                    const float lift_low = 0.5f*lost242*total263 + lost253;
                    const float given22 = half;
                    const float total29 = 1.0f - 0.5f*given22;
                    const float back182 = total29 - 1.0f;
                    const float lost292 = -back182 - 0.5f*given22;
                    const float decay_series_of3 = decay_series(given22);
                    const float curved22 = decay_series_of3*(given22*given22);
                    const float total302 = curved22 + total29;
                    const float back192 = -total29 + total302;
                    const float lost302 = -back192 + curved22;
                    const float mean_low5 = lost292 + lost302;
                    const float total312 = given22*total302;
                    const float lost312 = given22*mean_low5 +
                        fmaf(given22, total302, -(given22*total302));
                    const float total32 = 1.0f - total312;
                    const float back202 = total32 - 1.0f;
                    const float lost32 = -back202 - total312;
                    const float fall_low5 = -lost312 + lost32;
                    const float total33 = 1.0f - total32;
                    const float back212 = total33 - 1.0f;
                    const float lost33 = -back212 - total32;
                    const float low42 = -fall_low5 + lost33;
                    const float total34 = low42 + total33;
                    const float back22 = -total33 + total34;
                    const float lost34 = -back22 + low42;
                    const float total35 = (total34*total34);
                    const float lost35 = 2.0f*lost34*total34 +
                        fmaf(total34, total34, -(total34*total34));
                    const float total36 = total253*total32;
                    const float lost36 = lift_low*total32 +
                        fmaf(total32, total253, -(total32*total253));
                    const float total37 = total35 + 2.0f*total36;
                    const float back23 = -total35 + total37;
                    const float rest11 = -back23 + total37;
                    const float one10 = -rest11 + total35;
                    const float two10 = -back23 + 2.0f*total36;
                    const float lost37 = one10 + two10;
                    const float low5 = 2.0f*fall_low5*total253 + lost35 + 2.0f*lost36 + lost37;
                    const float total38 = total37/stiff;
                    const float left16 = -stiff*total38 + total37;
                    const float left17 = left16 - fmaf(total38, stiff, -(total38*stiff));
                    const float left18 = left17 + low5;
                    const float lost38 = left18/stiff;
                    apart_of = lost26 + total26;
                    nyquist_of = 4.0f*low22 + 4.0f*total122;
                    together_of = lost38 + total38;
                } else {
                    const float sign_low = -lost2;
                    const float left = -(root*root) + size;
                    const float left2 = left - fmaf(root, root, -(root*root));
                    const float left3 = left2 + sign_low;
                    const float whole = (root == 0.0f ? 1.0f : root);
                    const float root_low = 0.5f*left3/whole;
                    const float expm1_of = expm1f(-half);
                    const float grown = -0.5f*expm1_of;
                    const float angle = 0.5f*root;
                    const float wave = cosf(angle);
                    const float sin_of = sinf(angle);
                    const float back72 = 0.5f*root_low*sin_of;
                    const float total92 = -back72 + wave;
                    const float back82 = total92 - wave;
                    const float rest32 = -back82 + total92;
                    const float one22 = -rest32 + wave;
                    const float two22 = -back72 - back82;
                    const float lost92 = one22 + two22;
                    const float total102 = (total92*total92);
                    const float lost102 = fmaf(total92, total92, -(total92*total92));
                    const float low2 = lost102 + 2.0f*lost92*total92;
                    const float total112 = envelope*total102;
                    const float lost112 = envelope*low2 +
                        fmaf(envelope, total102, -(envelope*total102));
                    const float total122 = (grown*grown) + total112;
                    const float back92 = -total112 + total122;
                    const float rest42 = -back92 + total122;
                    const float one32 = -rest42 + total112;
                    const float two32 = -back92 + (grown*grown);
                    const float lost122 = one32 + two32;
                    const float low22 = lost112 + lost122;
                    const float back73 = -0.5f*root_low*wave;
                    const float total93 = -back73 + sin_of;
                    const float back83 = -sin_of + total93;
                    const float rest33 = -back83 + total93;
                    const float one23 = -rest33 + sin_of;
                    const float two23 = -back73 - back83;
                    const float lost93 = one23 + two23;
                    const float total103 = (total93*total93);
                    const float lost103 = fmaf(total93, total93, -(total93*total93));
                    const float low4 = lost103 + 2.0f*lost93*total93;
                    const float total113 = envelope*total103;
                    const float lost113 = envelope*low4 +
                        fmaf(envelope, total103, -(envelope*total103));
                    const float total123 = (grown*grown) + total113;
                    const float back93 = -total113 + total123;
                    const float rest43 = -back93 + total123;
                    const float one33 = -rest43 + total113;
                    const float two33 = -back93 + (grown*grown);
                    const float lost123 = one33 + two33;
                    const float low23 = lost113 + lost123;
                    const float total132 = total123/stiff;
                    const float left72 = -stiff*total132 + total123;
                    const float left82 = left72 - fmaf(total132, stiff, -(total132*stiff));
                    const float left92 = left82 + low23;
                    const float lost132 = left92/stiff;
                    apart_of = lost26 + total26;
                    nyquist_of = 4.0f*low22 + 4.0f*total122;
                    together_of = 4.0f*lost132 + 4.0f*total132;
                }
            }
        }
    } else {
        const float size = fabsf(total2);
        const float root = sqrtf(size);
        const float total3 = half + root;
        const float reach = 0.44444445f*total3;
        if (reach < 1.0f) {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            const float envelope = expf(-half);
            const float rest5 = apart_series(half, total2);
            const float total27 = rest5 + 0.16666667f;
            const float back17 = -rest5 + total27;
            const float rest6 = -back17 + total27;
            const float one4 = rest5 - rest6;
            const float two4 = 0.16666667f - back17;
            const float lost27 = one4 + two4;
            const float total28 = envelope*total27;
            const float lost28 = envelope*lost27 + fmaf(envelope, total27, -(envelope*total27));
            const float rest12 = together_series(half, total2);
            const float total55 = rest12 + 0.5f;
            const float back33 = -rest12 + total55;
            const float rest13 = -back33 + total55;
            const float one11 = rest12 - rest13;
            const float two11 = 0.5f - back33;
            const float lost55 = one11 + two11;
            const float total56 = envelope*total55;
            const float lost56 = envelope*lost55 + fmaf(envelope, total55, -(envelope*total55));
            float fall_;
            float fall_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                fall_ = sunk;
                fall_low2 = sunk_low;
            }
            const float total282 = fall_ + 1.0f;
            const float back20 = total282 - 1.0f;
            const float lost282 = -back20 + fall_;
            float fall2;
            float fall_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const float fast = fall_*fall2;
            const float lost29 = fall_*fall_low4 + fmaf(fall_, fall2, -(fall_*fall2));
            const float low3 = fall2*fall_low2 + lost29;
            const float total30 = fast + 1.0f;
            const float back21 = total30 - 1.0f;
            const float lost30 = -back21 + fast;
            const float total31 = total282*total30;
            const float lost31 = total282*(lost30 + low3) +
                fmaf(total282, total30, -(total282*total30));
            apart_of = lost28 + total28;
            nyquist_of = lost31 + total30*(fall_low2 + lost282) + total31;
            together_of = 2.0f*lost56 + 2.0f*total56;
        } else {
            const float sign_low = lost2;
            const float left = -(root*root) + size;
            const float left2 = left - fmaf(root, root, -(root*root));
            const float left3 = left2 + sign_low;
            const float whole = (root == 0.0f ? 1.0f : root);
            const float root_low = 0.5f*left3/whole;
            const float back3 = -half + total3;
            const float lost3 = -back3 + root;
            const float p_low = lost3 + root_low;
            const float whole2 = (total3 == 0.0f ? 1.0f : total3);
            const float q = gamma/whole2;
            const float off = gamma - q*whole2;
            const float off2 = off - fmaf(whole2, q, -(whole2*q));
            const float off3 = off2 - p_low*q;
            const float q_low = off3/whole2;
            const float rate2 = 2.0f*root;
            const float whole3 = (delta*total3 == 0.0f ? 1.0f : delta*total3);
            float fall_;
            float fall_low2;
            float mean;
            float mean_low2;
            if (q < 0.75f) {
                const float given = q;
                const float total4 = 1.0f - 0.5f*given;
                const float back4 = total4 - 1.0f;
                const float lost4 = -back4 - 0.5f*given;
                const float decay_series_of = decay_series(given);
                const float curved = decay_series_of*(given*given);
                const float total5 = curved + total4;
                const float back5 = -total4 + total5;
                const float lost5 = -back5 + curved;
                const float mean_low = lost4 + lost5 - q_low*
                    (0.125f*(given*given) - 0.33333334f*given + 0.5f);
                const float total6 = given*total5;
                const float lost6 = given*mean_low + fmaf(given, total5, -(given*total5));
                const float total7 = 1.0f - total6;
                const float back6 = total7 - 1.0f;
                const float lost7 = -back6 - total6;
                const float fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const float sunk = expf(-q);
                const float sunk_low = -q_low*sunk;
                const float total8 = 1.0f - sunk;
                const float back7 = total8 - 1.0f;
                const float lost8 = -back7 - sunk;
                const float bottom = q;
                const float total9 = total8/bottom;
                const float left4 = -bottom*total9 + total8;
                const float left5 = left4 - fmaf(total9, bottom, -(total9*bottom));
                const float left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const float lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            const float twice = 2.0f*fall_;
            const float total282 = fall_ + 1.0f;
            const float back20 = total282 - 1.0f;
            const float lost282 = -back20 + fall_;
            float fall2;
            float fall_low4;
            float mean2;
            float mean_low4;
            if (rate2 < 0.75f) {
                const float given2 = 2.0f*root;
                const float total10 = 1.0f - 0.5f*given2;
                const float back8 = total10 - 1.0f;
                const float lost10 = -back8 - 0.5f*given2;
                const float decay_series_of2 = decay_series(given2);
                const float curved2 = decay_series_of2*(given2*given2);
                const float total11 = curved2 + total10;
                const float back9 = -total10 + total11;
                const float lost11 = -back9 + curved2;
                const float mean_low3 = lost10 + lost11 - 2.0f*root_low*
                    (0.125f*(given2*given2) - 0.33333334f*given2 + 0.5f);
                const float total12 = given2*total11;
                const float lost12 = given2*mean_low3 + fmaf(given2, total11, -(given2*total11));
                const float total13 = 1.0f - total12;
                const float back10 = total13 - 1.0f;
                const float lost13 = -back10 - total12;
                const float fall_low3 = -lost12 + lost13 - 2.0f*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const float sunk2 = expf(-2.0f*root);
                const float sunk_low2 = -2.0f*root_low*sunk2;
                const float total14 = 1.0f - sunk2;
                const float back11 = total14 - 1.0f;
                const float lost14 = -back11 - sunk2;
                const float bottom2 = 2.0f*root;
                const float total15 = total14/bottom2;
                const float left7 = -bottom2*total15 + total14;
                const float left8 = left7 - fmaf(total15, bottom2, -(total15*bottom2));
                const float left9 = left8 + lost14 - 2.0f*root_low*total15 - sunk_low2;
                const float lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const float fast = fall_*fall2;
            const float total16 = mean2*twice;
            const float lost16 = mean_low4*twice + fmaf(twice, mean2, -(twice*mean2));
            const float total17 = mean - total16;
            const float back12 = -mean + total17;
            const float rest3 = -back12 + total17;
            const float one2 = mean - rest3;
            const float two2 = -back12 - total16;
            const float lost17 = one2 + two2;
            const float total18 = fast*mean;
            const float lost18 = fast*mean_low2 + fmaf(fast, mean, -(fast*mean));
            const float top = total17 + total18;
            const float low = -lost16 + lost17 + lost18 + mean_low2;
            const float lost29 = fall_*fall_low4 + fmaf(fall_, fall2, -(fall_*fall2));
            const float low3 = fall2*fall_low2 + lost29;
            const float total30 = fast + 1.0f;
            const float back21 = total30 - 1.0f;
            const float lost30 = -back21 + fast;
            const float total31 = total282*total30;
            const float lost31 = total282*(lost30 + low3) +
                fmaf(total282, total30, -(total282*total30));
            const float total52 = 1.0f - fast;
            const float back32 = total52 - 1.0f;
            const float lost52 = -back32 - fast;
            const float total53 = mean*total52;
            const float lost53 = mean*(lost52 - low3) + fmaf(mean, total52, -(mean*total52));
            const float moved_low = lost53 + mean_low2*total52;
            const float total54 = total53/whole2;
            const float left25 = total53 - total54*whole2;
            const float left26 = left25 - fmaf(total54, whole2, -(total54*whole2));
            const float left27 = left26 + moved_low - p_low*total54;
            const float lost54 = left27/whole2;
            apart_of = (low + top)/whole3;
            nyquist_of = lost31 + total30*(fall_low2 + lost282) + total31;
            together_of = lost54 + total54;
        }
    }
    *apart_out = apart_of;
    *nyquist_out = nyquist_of;
    *together_out = together_of;
    return;
}

// cos((k + 1) x); sin((k + 1) x)
static void cos_next_sin_next(float k, float x, float *cos_next_out, float *sin_next_out) {
    const float count = k + 1.0f;
    const float before = count - 1.0f;
    const float angle = count*x;
    const float missed = -before + k;
    const float quarters = floorf(2.0f*angle/3.1415927f + 0.5f);
    const float left = angle - 1.5707964f*quarters;
    const float total = left - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
    const float back = -left + total;
    const float rest = -back + total;
    const float one = left - rest;
    const float two = -back - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
    const float lost = one + two;
    const float total2 = 4.371139e-08f*quarters + total;
    const float back2 = -total + total2;
    const float rest2 = -back2 + total2;
    const float one2 = -rest2 + total;
    const float two2 = -back2 + 4.371139e-08f*quarters;
    const float lost2 = one2 + two2;
    const float total3 = total2 + fmaf(count, x, -(count*x));
    const float back3 = -total2 + total3;
    const float rest3 = -back3 + total3;
    const float one3 = -rest3 + total2;
    const float two3 = -back3 + fmaf(count, x, -(count*x));
    const float lost3 = one3 + two3;
    const float total4 = missed*x + total3;
    const float back4 = -total3 + total4;
    const float rest4 = -back4 + total4;
    const float one4 = -rest4 + total3;
    const float two4 = -back4 + missed*x;
    const float lost4 = one4 + two4;
    const float low = lost + lost2 + lost3 + lost4 + 1.7151245e-15f*quarters -
        fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
    const float low2 = low + fmaf(missed, x, -(missed*x));
    const float wave = sinf(total4);
    const float still = cosf(total4);
    const float turn_ = quarters - 4.0f*floorf(0.25f*quarters);
    float value;
    float value2;
    if ((turn_ == 1.0f) || (turn_ == 3.0f)) {
        const float sine = low2*still + wave;
        const float cosine = -low2*wave + still;
        value = sine;
        value2 = cosine;
    } else {
        const float sine = low2*still + wave;
        const float cosine = -low2*wave + still;
        value = cosine;
        value2 = sine;
    }
    const float cos_next_of = ((turn_ <= 2.0f) && (turn_ >= 1.0f) ? -value : value);
    const float sin_next_of = (turn_ >= 2.0f ? -value2 : value2);
    *cos_next_out = cos_next_of;
    *sin_next_out = sin_next_of;
    return;
}

// cos((k + 1) x)
static float cos_next(float k, float x) {
    const float count = k + 1.0f;
    const float angle = count*x;
    const float quarters = floorf(2.0f*angle/3.1415927f + 0.5f);
    const float turn_ = quarters - 4.0f*floorf(0.25f*quarters);
    if ((turn_ <= 2.0f) && (turn_ >= 1.0f)) {
        const float before = count - 1.0f;
        const float missed = -before + k;
        const float left = angle - 1.5707964f*quarters;
        const float total = left - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
        const float back = -left + total;
        const float rest = -back + total;
        const float one = left - rest;
        const float two = -back - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
        const float lost = one + two;
        const float total2 = 4.371139e-08f*quarters + total;
        const float back2 = -total + total2;
        const float rest2 = -back2 + total2;
        const float one2 = -rest2 + total;
        const float two2 = -back2 + 4.371139e-08f*quarters;
        const float lost2 = one2 + two2;
        const float total3 = total2 + fmaf(count, x, -(count*x));
        const float back3 = -total2 + total3;
        const float rest3 = -back3 + total3;
        const float one3 = -rest3 + total2;
        const float two3 = -back3 + fmaf(count, x, -(count*x));
        const float lost3 = one3 + two3;
        const float total4 = missed*x + total3;
        const float back4 = -total3 + total4;
        const float rest4 = -back4 + total4;
        const float one4 = -rest4 + total3;
        const float two4 = -back4 + missed*x;
        const float lost4 = one4 + two4;
        const float low = lost + lost2 + lost3 + lost4 + 1.7151245e-15f*quarters -
            fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
        const float low2 = low + fmaf(missed, x, -(missed*x));
        const float wave = sinf(total4);
        const float still = cosf(total4);
        float value;
        if ((turn_ == 1.0f) || (turn_ == 3.0f)) {
            const float sine = low2*still + wave;
            value = sine;
        } else {
            const float cosine = -low2*wave + still;
            value = cosine;
        }
        return -value;
    }
    const float before = count - 1.0f;
    const float missed = -before + k;
    const float left = angle - 1.5707964f*quarters;
    const float total = left - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
    const float back = -left + total;
    const float rest = -back + total;
    const float one = left - rest;
    const float two = -back - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
    const float lost = one + two;
    const float total2 = 4.371139e-08f*quarters + total;
    const float back2 = -total + total2;
    const float rest2 = -back2 + total2;
    const float one2 = -rest2 + total;
    const float two2 = -back2 + 4.371139e-08f*quarters;
    const float lost2 = one2 + two2;
    const float total3 = total2 + fmaf(count, x, -(count*x));
    const float back3 = -total2 + total3;
    const float rest3 = -back3 + total3;
    const float one3 = -rest3 + total2;
    const float two3 = -back3 + fmaf(count, x, -(count*x));
    const float lost3 = one3 + two3;
    const float total4 = missed*x + total3;
    const float back4 = -total3 + total4;
    const float rest4 = -back4 + total4;
    const float one4 = -rest4 + total3;
    const float two4 = -back4 + missed*x;
    const float lost4 = one4 + two4;
    const float low = lost + lost2 + lost3 + lost4 + 1.7151245e-15f*quarters -
        fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
    const float low2 = low + fmaf(missed, x, -(missed*x));
    const float wave = sinf(total4);
    const float still = cosf(total4);
    float value;
    if ((turn_ == 1.0f) || (turn_ == 3.0f)) {
        const float sine = low2*still + wave;
        value = sine;
    } else {
        const float cosine = -low2*wave + still;
        value = cosine;
    }
    return value;
}

// has the sign of the slope of the boundary's alpha, d < 1
static float early_slope(float theta, float k4, float k3, float k2, float k1, float k0) {
    const float sine = sinf(0.5f*theta);
    const float cosine = cosf(0.5f*theta);
    const float up = (sine*sine);
    const float along = (cosine*cosine);
    const float power = along;
    const float found = k3*power + k4*up;
    const float power2 = along*power;
    const float found2 = found*up + k2*power2;
    const float power3 = along*power2;
    const float found3 = found2*up + k1*power3;
    const float power4 = along*power3;
    const float found4 = found3*up + k0*power4;
    return found4;
}

// has the sign of the slope of the boundary's alpha next to pi
static float end_slope(float at_minus_one, float loss, float together_, float apart_, float last) {
    const float total = -4.0f*last + together_;
    const float back = -together_ + total;
    const float rest = -back + total;
    const float one = -rest + together_;
    const float two = -back - 4.0f*last;
    const float lost = one + two;
    const float total2 = (total*total);
    const float lost2 = 2.0f*lost*total + fmaf(total, total, -(total*total));
    const float total3 = apart_*together_;
    const float lost3 = fmaf(apart_, together_, -(apart_*together_));
    const float total4 = -total2 + total3;
    const float back2 = -total3 + total4;
    const float rest2 = -back2 + total4;
    const float one2 = -rest2 + total3;
    const float two2 = -back2 - total2;
    const float lost4 = one2 + two2;
    const float gap_low = -lost2 + lost3 + lost4;
    const float total5 = total2 - 2.0f*total3;
    const float back3 = -total2 + total5;
    const float rest3 = -back3 + total5;
    const float one3 = -rest3 + total2;
    const float two3 = -back3 - 2.0f*total3;
    const float lost5 = one3 + two3;
    const float lean_low = lost2 - 2.0f*lost3 + lost5;
    const float total6 = total*total5;
    const float lost6 = lean_low*total + fmaf(total, total5, -(total*total5));
    const float total7 = apart_*total3;
    const float lost7 = apart_*lost3 + fmaf(apart_, total3, -(apart_*total3));
    const float total8 = total6 + total7;
    const float back4 = -total6 + total8;
    const float rest4 = -back4 + total8;
    const float one4 = -rest4 + total6;
    const float two4 = -back4 + total7;
    const float lost8 = one4 + two4;
    const float bent_low = lost*total5 + lost6 + lost7 + lost8;
    const float total9 = at_minus_one*total8;
    const float lost9 = at_minus_one*bent_low + fmaf(at_minus_one, total8, -(at_minus_one*total8));
    const float total10 = apart_*total4;
    const float lost10 = apart_*gap_low + fmaf(apart_, total4, -(apart_*total4));
    const float total11 = loss*total10;
    const float lost11 = loss*lost10 + fmaf(loss, total10, -(loss*total10));
    const float total12 = 2.0f*apart_ - total;
    const float back5 = -2.0f*apart_ + total12;
    const float rest5 = -back5 + total12;
    const float one5 = 2.0f*apart_ - rest5;
    const float two5 = -back5 - total;
    const float lost12 = one5 + two5;
    const float total13 = (apart_*apart_);
    const float lost13 = fmaf(apart_, apart_, -(apart_*apart_));
    const float total14 = total12*total13;
    const float lost14 = total13*(-lost + lost12) + fmaf(total13, total12, -(total13*total12));
    const float three_low = lost13*total12 + lost14;
    const float total15 = 4.0f*total14 - total9;
    const float back6 = -4.0f*total14 + total15;
    const float rest6 = -back6 + total15;
    const float one6 = -rest6 + 4.0f*total14;
    const float two6 = -back6 - total9;
    const float lost15 = one6 + two6;
    const float total16 = -2.0f*total11 + total15;
    const float back7 = -total15 + total16;
    const float rest7 = -back7 + total16;
    const float one7 = -rest7 + total15;
    const float two7 = -back7 - 2.0f*total11;
    const float lost16 = one7 + two7;
    const float low = -2.0f*lost11 + lost15 + lost16 - lost9 + 4.0f*three_low;
    return low + total16;
}

// the angle of the largest stiffness for delays below a period
static float early_angle(float at_one, float at_minus_one, float loss, float together_,
    float apart_, float last) {
    const float t = (apart_*apart_*apart_);
    const float t2 = (together_*together_*together_);
    const float t3 = (together_*together_);
    const float t4 = apart_*t3;
    const float t5 = (apart_*apart_);
    const float t6 = 2.0f*loss;
    const float t7 = at_minus_one + t6;
    const float t8 = 4.0f*together_;
    const float t9 = 16.0f*apart_;
    const float t10 = at_one + t6;
    const float t11 = 2.0f*at_one;
    const float t12 = 5.0f*at_minus_one;
    const float t13 = -at_one;
    const float t14 = 4.0f*loss;
    const float t15 = apart_*together_;
    const float t16 = 16.0f*together_;
    const float t17 = at_one*last;
    const float t18 = apart_*t11;
    const float t19 = at_one*t5;
    const float k = end_slope(at_minus_one, loss, together_, apart_, last);
    const float k2 = -4.0f*at_minus_one*t2 + last*
        (32.0f*at_minus_one*t3 + last*(64.0f*apart_*loss + 128.0f*at_minus_one*last - 96.0f*
        at_minus_one*together_) - 96.0f*t5 - t7*t9*together_) + 16.0f*t + 8.0f*t4*
        (at_minus_one + loss) - t5*t7*t8;
    const float k3 = last*(last*(last*(-192.0f*at_minus_one - 256.0f*at_one - 512.0f*loss) + t16*
        (9.0f*at_one + 16.0f*loss + t12) + t9*(8.0f*at_minus_one + 8.0f*at_one + 18.0f*loss)) -
        32.0f*t15 - 4.0f*t3*(at_minus_one + 7.0f*at_one + 14.0f*loss) - 112.0f*t5) + 8.0f*t + 2.0f*
        t2*(-2.0f*at_minus_one + t10) + 2.0f*t4*(t12 + t13 + t14) - 2.0f*t5*together_*(-t11 + t7);
    const float k4 = last*(32.0f*t17*together_ - 8.0f*together_*(t18 + 12.0f*together_)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const float k5 = last*(t16*t17 + t8*(t10*together_ - t18)) + together_*
        (-2.0f*t15*(at_one + loss) + t19 + t3*(at_minus_one + t11 + t14));
    float count = 1.0f;
    float found = 0.0f;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0f) || (found > 0.0f)) { break; }
        const float rises = early_slope(0.041666668f*3.1415927f*count, k, k2, k3, k4, k5);
        const float next_count = (rises > 0.0f ? count + 1.0f : count);
        const float next_found = (rises > 0.0f ? 0.0f : 1.0f);
        count = next_count;
        found = next_found;
    }
    if (found > 0.0f) {
        const float high = 0.041666668f*3.1415927f*count;
        const float low = fmaxf(0.001f*high, 0.041666668f*3.1415927f*(count - 1.0f));
        const float low2 = low;
        const float above = early_slope(low2, k, k2, k3, k4, k5);
        float root;
        if (above <= 0.0f) {
            root = low2;
        } else {
            const float high2 = high;
            const float below = early_slope(high2, k, k2, k3, k4, k5);
            if (below >= 0.0f) {
                root = high2;
            } else {
                float b = low2;
                float fb = above;
                float a = high2;
                float fa = below;
                float c = high2;
                float fc = below;
                for (int count_b = 0; count_b < 120; ++count_b) {
                    if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                        (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) {
                        break; }
                    const float span = -b + c;
                    const float rise_ = -fb + fc;
                    const float whole = (span == 0.0f ? 1.0f : span);
                    const float place = (a - b)/whole;
                    const float whole2 = (rise_ == 0.0f ? 1.0f : rise_);
                    const float height = (fa - fb)/whole2;
                    const float safe = ((place < 1.0f - ((1.0f - height)*(1.0f - height))) &&
                        (place > (height*height)) ? 1.0f : 0.0f);
                    const float one = (safe > 0.0f ? -fa + fb : 1.0f);
                    const float two = (safe > 0.0f ? fb - fc : 1.0f);
                    const float three = (safe > 0.0f ? fa - fc : 1.0f);
                    const float width = -a + b;
                    const float here = fa/one;
                    const float there = fc/two;
                    const float whole3 = (width == 0.0f ? 1.0f : width);
                    const float other = fa/three;
                    const float last2 = fb/two;
                    const float guess = (safe > 0.0f ? here*there + last2*other*(-a + c)/whole3 :
                        0.5f);
                    const float edge = 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b))/
                        fabsf(whole3);
                    const float edge2 = fminf(0.5f, edge);
                    const float share = fminf(guess, 1.0f - edge2);
                    const float share2 = fmaxf(edge2, share);
                    const float new_ = a + share2*width;
                    const float value = early_slope(new_, k, k2, k3, k4, k5);
                    const float next_b = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? b : a);
                    const float next_fb = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? fb : fa);
                    const float next_a = new_;
                    const float next_fa = value;
                    const float next_c = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? a : b);
                    const float next_fc = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? fa : fb);
                    b = next_b;
                    fb = next_fb;
                    a = next_a;
                    fa = next_fa;
                    c = next_c;
                    fc = next_fc;
                }
                root = (fabsf(fa) < fabsf(fb) ? a : b);
            }
        }
        return root;
    }
    return 3.1415927f;
}

// sin((k + 1) x)
static float sin_next(float k, float x) {
    const float count = k + 1.0f;
    const float angle = count*x;
    const float quarters = floorf(2.0f*angle/3.1415927f + 0.5f);
    const float turn_ = quarters - 4.0f*floorf(0.25f*quarters);
    if (turn_ >= 2.0f) {
        const float before = count - 1.0f;
        const float missed = -before + k;
        const float left = angle - 1.5707964f*quarters;
        const float total = left - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
        const float back = -left + total;
        const float rest = -back + total;
        const float one = left - rest;
        const float two = -back - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
        const float lost = one + two;
        const float total2 = 4.371139e-08f*quarters + total;
        const float back2 = -total + total2;
        const float rest2 = -back2 + total2;
        const float one2 = -rest2 + total;
        const float two2 = -back2 + 4.371139e-08f*quarters;
        const float lost2 = one2 + two2;
        const float total3 = total2 + fmaf(count, x, -(count*x));
        const float back3 = -total2 + total3;
        const float rest3 = -back3 + total3;
        const float one3 = -rest3 + total2;
        const float two3 = -back3 + fmaf(count, x, -(count*x));
        const float lost3 = one3 + two3;
        const float total4 = missed*x + total3;
        const float back4 = -total3 + total4;
        const float rest4 = -back4 + total4;
        const float one4 = -rest4 + total3;
        const float two4 = -back4 + missed*x;
        const float lost4 = one4 + two4;
        const float low = lost + lost2 + lost3 + lost4 + 1.7151245e-15f*quarters -
            fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
        const float low2 = low + fmaf(missed, x, -(missed*x));
        const float wave = sinf(total4);
        const float still = cosf(total4);
        float value;
        if ((turn_ == 1.0f) || (turn_ == 3.0f)) {
            const float cosine = -low2*wave + still;
            value = cosine;
        } else {
            const float sine = low2*still + wave;
            value = sine;
        }
        return -value;
    }
    const float before = count - 1.0f;
    const float missed = -before + k;
    const float left = angle - 1.5707964f*quarters;
    const float total = left - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
    const float back = -left + total;
    const float rest = -back + total;
    const float one = left - rest;
    const float two = -back - fmaf(quarters, 1.5707964f, -(quarters*1.5707964f));
    const float lost = one + two;
    const float total2 = 4.371139e-08f*quarters + total;
    const float back2 = -total + total2;
    const float rest2 = -back2 + total2;
    const float one2 = -rest2 + total;
    const float two2 = -back2 + 4.371139e-08f*quarters;
    const float lost2 = one2 + two2;
    const float total3 = total2 + fmaf(count, x, -(count*x));
    const float back3 = -total2 + total3;
    const float rest3 = -back3 + total3;
    const float one3 = -rest3 + total2;
    const float two3 = -back3 + fmaf(count, x, -(count*x));
    const float lost3 = one3 + two3;
    const float total4 = missed*x + total3;
    const float back4 = -total3 + total4;
    const float rest4 = -back4 + total4;
    const float one4 = -rest4 + total3;
    const float two4 = -back4 + missed*x;
    const float lost4 = one4 + two4;
    const float low = lost + lost2 + lost3 + lost4 + 1.7151245e-15f*quarters -
        fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
    const float low2 = low + fmaf(missed, x, -(missed*x));
    const float wave = sinf(total4);
    const float still = cosf(total4);
    float value;
    if ((turn_ == 1.0f) || (turn_ == 3.0f)) {
        const float cosine = -low2*wave + still;
        value = cosine;
    } else {
        const float sine = low2*still + wave;
        value = sine;
    }
    return value;
}

// has the sign of the slope of the boundary's alpha
static float boundary_slope(float theta, float l, float at_one, float at_minus_one, float loss,
    float together_, float apart_, float across) {
    const float t = 2.0f*l + 2.0f;
    const float t2 = 0.5f*theta;
    const float t3 = sin_next(t, t2);
    const float t4 = tanf(t2);
    const float t5 = (t4*t4);
    const float t6 = 4.0f*t5;
    const float t7 = apart_*t5;
    const float t8 = -t7 + together_;
    const float t9 = at_minus_one*t5;
    const float t10 = at_one - t9;
    const float t11 = across*loss*t6 + t10*t8;
    const float t12 = cos_next(t, t2);
    const float t13 = -2.0f*across*t10*t4 + 2.0f*loss*t4*t8;
    const float t14 = (across*across);
    const float t15 = t14*t6 + (t8*t8);
    const float t16 = (loss*loss);
    const float t17 = (t10*t10) + t16*t6;
    const float t18 = t15*t17;
    const float t19 = t5 + 1.0f;
    return -t4*(0.5f*t18 + t19*(t15*(-at_minus_one*t10 + 2.0f*t16) - t17*(-apart_*t8 + 2.0f*t14)))*
        (t11*t12 - t13*t3) + (t11*t3 + t12*t13)*
        (t18*(l + 1.5f) + t19*(-across*t17*(t7 + together_) + loss*t15*(at_one + t9)));
}

// the angle of the largest stiffness for a period and more
static float later_angle(float d, float l, float at_one, float at_minus_one, float loss,
    float together_, float apart_, float across) {
    const float turn_ = 3.1415927f/(d + 1.0f);
    float count = 1.0f;
    float found = 0.0f;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0f) || (found > 0.0f)) { break; }
        const float rises = boundary_slope(0.041666668f*count*turn_, l, at_one, at_minus_one, loss,
            together_, apart_, across);
        const float next_count = (rises > 0.0f ? count + 1.0f : count);
        const float next_found = (rises > 0.0f ? 0.0f : 1.0f);
        count = next_count;
        found = next_found;
    }
    if (found > 0.0f) {
        const float high = 0.041666668f*count*turn_;
        const float low = fmaxf(0.001f*high, 0.041666668f*turn_*(count - 1.0f));
        const float low2 = low;
        const float above = boundary_slope(low2, l, at_one, at_minus_one, loss, together_, apart_,
            across);
        float root;
        if (above <= 0.0f) {
            root = low2;
        } else {
            const float high2 = high;
            const float below = boundary_slope(high2, l, at_one, at_minus_one, loss, together_,
                apart_, across);
            if (below >= 0.0f) {
                root = high2;
            } else {
                float b = low2;
                float fb = above;
                float a = high2;
                float fa = below;
                float c = high2;
                float fc = below;
                for (int count_b = 0; count_b < 120; ++count_b) {
                    if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                        (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) {
                        break; }
                    const float span = -b + c;
                    const float rise_ = -fb + fc;
                    const float whole = (span == 0.0f ? 1.0f : span);
                    const float place = (a - b)/whole;
                    const float whole2 = (rise_ == 0.0f ? 1.0f : rise_);
                    const float height = (fa - fb)/whole2;
                    const float safe = ((place < 1.0f - ((1.0f - height)*(1.0f - height))) &&
                        (place > (height*height)) ? 1.0f : 0.0f);
                    const float one = (safe > 0.0f ? -fa + fb : 1.0f);
                    const float two = (safe > 0.0f ? fb - fc : 1.0f);
                    const float three = (safe > 0.0f ? fa - fc : 1.0f);
                    const float width = -a + b;
                    const float here = fa/one;
                    const float there = fc/two;
                    const float whole3 = (width == 0.0f ? 1.0f : width);
                    const float other = fa/three;
                    const float last = fb/two;
                    const float guess = (safe > 0.0f ? here*there + last*other*(-a + c)/whole3 :
                        0.5f);
                    const float edge = 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b))/
                        fabsf(whole3);
                    const float edge2 = fminf(0.5f, edge);
                    const float share = fminf(guess, 1.0f - edge2);
                    const float share2 = fmaxf(edge2, share);
                    const float new_ = a + share2*width;
                    const float value = boundary_slope(new_, l, at_one, at_minus_one, loss,
                        together_, apart_, across);
                    const float next_b = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? b : a);
                    const float next_fb = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? fb : fa);
                    const float next_a = new_;
                    const float next_fa = value;
                    const float next_c = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? a : b);
                    const float next_fc = (((fa < 0.0f) && (value < 0.0f)) ||
                        ((fa > 0.0f) && (value > 0.0f)) ? fa : fb);
                    b = next_b;
                    fb = next_fb;
                    a = next_a;
                    fa = next_fa;
                    c = next_c;
                    fc = next_fc;
                }
                root = (fabsf(fa) < fabsf(fb) ? a : b);
            }
        }
        return root;
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static float undelayed_angle(float at_one, float at_minus_one, float loss, float together_,
    float apart_) {
    const float k = end_slope(at_minus_one, loss, together_, apart_, 0.0f);
    const float t = 2.0f*apart_;
    const float t2 = -together_;
    const float t3 = 2.0f*together_;
    const float t4 = (together_*together_);
    const float k2 = t3*((apart_*apart_)*at_one + together_*(at_minus_one*(t + t2) + loss*t));
    const float k3 = together_*(at_minus_one*t4 + at_one*(t4 + ((-apart_ - t2)*(-apart_ - t2))) +
        loss*t3*(-apart_ + 2.0f*together_));
    float above;
    float below;
    if (k2 > 0.0f) {
        const float discriminant = -4.0f*k*k3 + (k2*k2);
        const float root = sqrtf(fmaxf(0.0f, discriminant));
        above = k2 + root;
        below = fmaxf(0.0f, -2.0f*k);
    } else {
        const float discriminant = -4.0f*k*k3 + (k2*k2);
        if (discriminant < 0.0f) {
            above = 2.0f*k3;
            below = 0.0f;
        } else {
            const float root = sqrtf(fmaxf(0.0f, discriminant));
            above = 2.0f*k3;
            below = -k2 + root;
        }
    }
    return 2.0f*atan2f(sqrtf(above), sqrtf(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static float stiffest_angle(float gamma, float delta, float d, float l, float part, float first,
    float last, float at_one, float at_minus_one, float loss, float together_, float apart_) {
    if (((d <= 1.0f) || (sqrtf(gamma)*(d + 1.0f) <= 3.1415927f)) && (gamma <= 9.8f)) {
        const float across = (part == 0.0f ? first : first - last);
        float theta;
        if (d == 0.0f) {
            theta = undelayed_angle(at_one, at_minus_one, loss, together_, apart_);
        } else {
            if (d < 1.0f) {
                theta = early_angle(at_one, at_minus_one, loss, together_, apart_, last);
            } else {
                theta = later_angle(d, l, at_one, at_minus_one, loss, together_, apart_, across);
            }
        }
        const float t = sin_next(l, theta);
        const float t2 = 0.5f*theta;
        const float t3 = sinf(t2);
        const float t4 = cosf(t2);
        const float t5 = (t4*t4);
        const float t6 = (t3*t3);
        const float t7 = 4.0f*t5*t6;
        const float t8 = -apart_*t6 + t5*together_;
        const float t9 = 1.0f/((across*across)*t7 + (t8*t8));
        const float t10 = -at_minus_one*t6 + at_one*t5;
        const float t11 = -2.0f*across*t10 + 2.0f*loss*t8;
        const float t12 = across*loss*t7 + t10*t8;
        const float t13 = t9*cos_next(l, theta);
        const float t14 = -t*t12*t9/sinf(theta) - 0.5f*t11*t13;
        const float stiffness = t*t11*t3*t4*t9 - t12*t13 - 2.0f*t14*t6;
        float good;
        if ((delta > 0.0f) && (gamma > -stiffness) && (sqrtf(gamma)*(d + 1.0f) <= 3.1415927f)) {
            good = 1.0f;
        } else {
            const float damping = t14;
            const float inside = -7.6293945e-05f*gamma + 0.9999237f*stiffness;
            float outside;
            if (part == 0.0f) {
                outside = whole_roots(inside, damping, l, first, last, at_one, at_minus_one, loss,
                    together_, apart_);
            } else {
                outside = late_roots(inside, damping, l, first, last, at_one, at_minus_one, loss,
                    together_, apart_);
            }
            good = stable(outside, inside, damping, gamma, delta);
        }
        if (good > 0.0f) {
            return theta;
        }
        return NAN;
    }
    return NAN;
}

// (x - sin(x))/x^3
static float gap(float x) {
    if (fabsf(x) < 2.0f) {
        const float near = x;
        const float square = -(near*near);
        const float b7 = 2.8114574e-15f;
        const float b6 = b7*square + 7.6471636e-13f;
        const float b5 = b6*square + 1.6059044e-10f;
        const float b4 = b5*square + 2.5052108e-08f;
        const float b3 = b4*square + 2.7557319e-06f;
        const float b2 = b3*square + 0.0001984127f;
        const float b1 = b2*square + 0.008333334f;
        const float rest = b1*square - 4.967054e-09f;
        const float total = rest + 0.16666667f;
        return total;
    }
    const float whole = x;
    return (x - sinf(x))/(whole*whole*whole);
}

// sin(x)/x
static float sinc(float x) {
    if (fabsf(x) < 1.0f) {
        const float near = x;
        return -(near*near)*gap(near) + 1.0f;
    }
    const float whole = (x == 0.0f ? 1.0f : x);
    return sinf(x)/whole;
}

// the damping that the wall needs at the angle 2 psi
static float need(float alpha, float beta, float l, float epsilon, float psi) {
    if (epsilon == 0.0f) {
        const float early = 0.5f*alpha*(2.0f*l + 1.0f)*sinc(psi*(2.0f*l + 1.0f))/sinc(psi) - beta*
            cos_next(l, 2.0f*psi);
        return early;
    }
    const float early = 0.5f*alpha*(2.0f*l + 1.0f)*sinc(psi*(2.0f*l + 1.0f))/sinc(psi) - beta*
        cos_next(l, 2.0f*psi);
    const float n = early + epsilon*(0.5f*alpha*(2.0f*l + 3.0f)*sinc(psi*(2.0f*l + 3.0f))/
        sinc(psi) - beta*cos_next(l + 1.0f, 2.0f*psi) - early);
    const float root = sqrtf(epsilon*(1.0f - epsilon)*
        ((alpha*alpha)*(cosf(psi)*cosf(psi)) + ((alpha + 2.0f*beta)*(alpha + 2.0f*beta))*
        (sinf(psi)*sinf(psi))) + (n*n));
    return 0.5f*n + 0.5f*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static float chord(float k, float x) {
    const float turn_ = x*(k + 1.0f);
    if (turn_ < 1.5f) {
        const float angle = turn_;
        const float order = 2.0f*k + 2.0f;
        const float along = cos_next(k, x);
        const float wave = sinc(0.5f*angle);
        const float inner = 0.5f*(wave*wave) - gap(angle);
        return order*(along*gap(x) + 0.25f*inner*(order*order));
    }
    const float some = x;
    const float order = 2.0f*k + 2.0f;
    const float along = cos_next(k, x);
    return (-along*order*sinf(x) + 2.0f*sin_next(k, x))/(some*some*some);
}

// has the sign of the slope of Need, at a fraction
static float rising(float alpha, float beta, float l, float epsilon, float psi) {
    const float t = 2.0f*psi;
    const float t2 = 2.0f*alpha/(sinc(psi)*sinc(psi));
    const float t3 = 0.5f*alpha + beta;
    const float t4 = 2.0f*l;
    const float t5 = t4 + 2.0f;
    const float t6 = t4 + 4.0f;
    const float early = -t2*chord(l, t) + t3*(t5*t5)*sinc(psi*t5);
    const float steep = early + epsilon*(-early - t2*chord(l + 1.0f, t) + t3*(t6*t6)*sinc(psi*t6));
    return 2.0f*beta*epsilon*(1.0f - epsilon)*(alpha + beta)*sinc(2.0f*psi) + steep*
        need(alpha, beta, l, epsilon, psi);
}

// has the sign of the slope of Need, up to the angle in phase
static float steepness(float alpha, float beta, float l, float epsilon, float psi) {
    if (epsilon == 0.0f) {
        const float t = 2.0f*l + 2.0f;
        const float early = -2.0f*alpha*chord(l, 2.0f*psi)/(sinc(psi)*sinc(psi)) + (t*t)*
            (0.5f*alpha + beta)*sinc(psi*t);
        return early;
    }
    const float phase = psi*(2.0f*l + 2.0f) +
        atan2f(alpha*cosf(psi), (alpha + 2.0f*beta)*sinf(psi)) +
        atan2f(epsilon*sinf(2.0f*psi), epsilon*cosf(2.0f*psi) - epsilon + 1.0f) - 3.1415927f;
    if (phase > 0.0f) {
        const float rising_ = rising(alpha, beta, l, epsilon, psi);
        return -fabsf(rising_);
    }
    const float rising_ = rising(alpha, beta, l, epsilon, psi);
    return rising_;
}

// half of the angle at which the wall needs most damping
static float worst_angle(float alpha, float beta, float l, float epsilon) {
    const float size = fabsf(alpha) + fabsf(beta);
    const float whole = (size == 0.0f ? 1.0f : size);
    const float stiffness = alpha/whole;
    const float damping = beta/whole;
    const float low = 0.0f;
    const float above = steepness(stiffness, damping, l, epsilon, low);
    float root;
    if (above <= 0.0f) {
        root = low;
    } else {
        const float high = 3.1415925f/(2.0f*l + 2.0f);
        const float below = steepness(stiffness, damping, l, epsilon, high);
        if (below >= 0.0f) {
            root = high;
        } else {
            float b = low;
            float fb = above;
            float a = high;
            float fa = below;
            float c = high;
            float fc = below;
            for (int count_b = 0; count_b < 120; ++count_b) {
                if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                    (fabsf(a - b) <= 7.6293945e-06f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) {
                    break; }
                const float span = -b + c;
                const float rise_ = -fb + fc;
                const float whole2 = (span == 0.0f ? 1.0f : span);
                const float place = (a - b)/whole2;
                const float whole3 = (rise_ == 0.0f ? 1.0f : rise_);
                const float height = (fa - fb)/whole3;
                const float safe = ((place < 1.0f - ((1.0f - height)*(1.0f - height))) &&
                    (place > (height*height)) ? 1.0f : 0.0f);
                const float one = (safe > 0.0f ? -fa + fb : 1.0f);
                const float two = (safe > 0.0f ? fb - fc : 1.0f);
                const float three = (safe > 0.0f ? fa - fc : 1.0f);
                const float width = -a + b;
                const float here = fa/one;
                const float there = fc/two;
                const float whole4 = (width == 0.0f ? 1.0f : width);
                const float other = fa/three;
                const float last = fb/two;
                const float guess = (safe > 0.0f ? here*there + last*other*(-a + c)/whole4 : 0.5f);
                const float edge = 7.6293945e-06f*fabsf((fabsf(fa) < fabsf(fb) ? a : b))/
                    fabsf(whole4);
                const float edge2 = fminf(0.5f, edge);
                const float share = fminf(guess, 1.0f - edge2);
                const float share2 = fmaxf(edge2, share);
                const float new_ = a + share2*width;
                const float value = steepness(stiffness, damping, l, epsilon, new_);
                const float next_b = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? b : a);
                const float next_fb = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? fb : fa);
                const float next_a = new_;
                const float next_fa = value;
                const float next_c = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? a : b);
                const float next_fc = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? fa : fb);
                b = next_b;
                fb = next_fb;
                a = next_a;
                fa = next_fa;
                c = next_c;
                fc = next_fc;
            }
            root = (fabsf(fa) < fabsf(fb) ? a : b);
        }
    }
    return root;
}

// the damping that the wall needs at its worst angle
static float largest_need(float alpha, float beta, float d) {
    if (alpha < 0.0f) {
        return INFINITY;
    }
    const float whole = floorf(d);
    const float part = d - whole;
    const float psi = worst_angle(alpha, beta, whole, part);
    return need(alpha, beta, whole, part, psi);
}

// early + share (late - early)
static float between(float share, float early, float late) {
    const float more = -early + late;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static float lead(float theta, float l, float epsilon) {
    if (theta*(l + 1.0f) < 4.0f) {
        const float early = sin_next(l, theta);
        const float late = sin_next(l + 1.0f, theta);
        const float sine = early + epsilon*(-early + late);
        return sine;
    }
    return -1.0f;
}

// the value, NaN for number < 0
static float rated(float number, float value) {
    if (number < 0.0f) {
        return NAN;
    }
    return value;
}

// ((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3
static float spread(float k, float x) {
    const float turn_ = x*(k + 1.0f);
    if (turn_ < 1.5f) {
        const float angle = turn_;
        const float order = 2.0f*k + 2.0f;
        return order*((order*order)*gap(2.0f*angle) - gap(x));
    }
    const float some = x;
    const float order = 2.0f*k + 2.0f;
    return (order*sinf(x) - 2.0f*cos_next(k, x)*sin_next(k, x))/(some*some*some);
}

// what straight motions need at a whole delay of k periods
static float straight(float stiffness, float damping, float k, float angle) {
    const float order = 2.0f*k + 1.0f;
    const float wave = sinc(angle*order);
    const float near = 2.0f*sinc(angle);
    const float total = order*wave;
    const float lost = fmaf(order, wave, -(order*wave));
    const float total2 = total/near;
    const float left = -near*total2 + total;
    const float left2 = left - fmaf(total2, near, -(total2*near));
    const float left3 = left2 + lost;
    const float lost2 = left3/near;
    const float total3 = stiffness*total2;
    const float lost3 = lost2*stiffness + fmaf(stiffness, total2, -(stiffness*total2));
    const float along = cos_next(k, 2.0f*angle);
    const float total4 = along*damping;
    const float lost4 = fmaf(damping, along, -(damping*along));
    const float total5 = total3 - total4;
    const float back = -total3 + total5;
    const float rest = -back + total5;
    const float one = -rest + total3;
    const float two = -back - total4;
    const float lost5 = one + two;
    const float low = lost3 - lost4 + lost5;
    return low + total5;
}

// the wall whose worst angle is 2 psi, as an angle
static float turn(float psi, float l, float epsilon) {
    const float wave = sinf(psi);
    const float wave2 = cosf(psi);
    const float wave3 = chord(l, 2.0f*psi);
    const float wave4 = chord(l + 1.0f, 2.0f*psi);
    const float wave5 = cos_next(l, 2.0f*psi);
    const float wave6 = cos_next(l + 1.0f, 2.0f*psi);
    const float wave7 = sinc(psi);
    const float wave8 = sinc(2.0f*psi);
    const float wave9 = sinc(psi*(2.0f*l + 1.0f));
    const float wave10 = sinc(psi*(2.0f*l + 2.0f));
    const float wave11 = sinc(psi*(2.0f*l + 3.0f));
    const float wave12 = sinc(psi*(2.0f*l + 4.0f));
    const float low = 0.0f;
    const float t = sinf(low);
    const float t2 = l + 1.0f;
    const float t3 = cosf(low);
    const float t4 = t3/t2;
    const float t5 = 0.5f*t4;
    const float t6 = t - t5;
    const float t7 = epsilon*(1.0f - epsilon);
    const float t8 = 2.0f*l;
    const float t9 = 2.0f*t4/(wave7*wave7);
    const float t10 = t*wave10*((t8 + 2.0f)*(t8 + 2.0f)) - t9*wave3;
    const float t11 = t6*wave5;
    const float t12 = 1.0f/wave7;
    const float t13 = wave9*(t8 + 1.0f);
    const float t14 = t12*t5;
    const float t15 = t13*t14;
    const float t16 = epsilon*(t11 + t14*wave11*(t8 + 3.0f) - t15 - t6*wave6);
    const float above = -2.0f*t6*t7*wave8*(t + t5) -
        (epsilon*(t*wave12*((t8 + 4.0f)*(t8 + 4.0f)) - t10 - t9*wave4) + t10)*
        (-0.5f*t11 + 0.25f*t12*t13*t4 + 0.5f*t16 + 0.5f*
        sqrtf(t7*(4.0f*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2)) +
        ((-t11 + t15 + t16)*(-t11 + t15 + t16))));
    float root;
    if (above <= 0.0f) {
        root = low;
    } else {
        const float high = 0.5f*3.1415927f;
        const float t17 = sinf(high);
        const float t18 = l + 1.0f;
        const float t19 = cosf(high);
        const float t20 = t19/t18;
        const float t21 = 0.5f*t20;
        const float t22 = t17 - t21;
        const float t23 = epsilon*(1.0f - epsilon);
        const float t24 = 2.0f*l;
        const float t25 = 2.0f*t20/(wave7*wave7);
        const float t26 = t17*wave10*((t24 + 2.0f)*(t24 + 2.0f)) - t25*wave3;
        const float t27 = t22*wave5;
        const float t28 = 1.0f/wave7;
        const float t29 = wave9*(t24 + 1.0f);
        const float t30 = t21*t28;
        const float t31 = t29*t30;
        const float t32 = epsilon*(-t22*wave6 + t27 + t30*wave11*(t24 + 3.0f) - t31);
        const float below = -2.0f*t22*t23*wave8*(t17 + t21) -
            (epsilon*(t17*wave12*((t24 + 4.0f)*(t24 + 4.0f)) - t25*wave4 - t26) + t26)*
            (0.25f*t20*t28*t29 - 0.5f*t27 + 0.5f*t32 + 0.5f*
            sqrtf(t23*(4.0f*(t17*t17)*(wave*wave) + (t19*t19)*(wave2*wave2)/(t18*t18)) +
            ((-t27 + t31 + t32)*(-t27 + t31 + t32))));
        if (below >= 0.0f) {
            root = high;
        } else {
            float b = low;
            float fb = above;
            float a = high;
            float fa = below;
            float c = high;
            float fc = below;
            for (int count_b = 0; count_b < 120; ++count_b) {
                if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                    (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) {
                    break; }
                const float span = -b + c;
                const float rise_ = -fb + fc;
                const float whole = (span == 0.0f ? 1.0f : span);
                const float place = (a - b)/whole;
                const float whole2 = (rise_ == 0.0f ? 1.0f : rise_);
                const float height = (fa - fb)/whole2;
                const float safe = ((place < 1.0f - ((1.0f - height)*(1.0f - height))) &&
                    (place > (height*height)) ? 1.0f : 0.0f);
                const float one = (safe > 0.0f ? -fa + fb : 1.0f);
                const float two = (safe > 0.0f ? fb - fc : 1.0f);
                const float three = (safe > 0.0f ? fa - fc : 1.0f);
                const float width = -a + b;
                const float here = fa/one;
                const float there = fc/two;
                const float whole3 = (width == 0.0f ? 1.0f : width);
                const float other = fa/three;
                const float last = fb/two;
                const float guess = (safe > 0.0f ? here*there + last*other*(-a + c)/whole3 : 0.5f);
                const float edge = 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b))/
                    fabsf(whole3);
                const float edge2 = fminf(0.5f, edge);
                const float share = fminf(guess, 1.0f - edge2);
                const float share2 = fmaxf(edge2, share);
                const float new_ = a + share2*width;
                const float t33 = sinf(new_);
                const float t34 = l + 1.0f;
                const float t35 = cosf(new_);
                const float t36 = t35/t34;
                const float t37 = 0.5f*t36;
                const float t38 = t33 - t37;
                const float t39 = epsilon*(1.0f - epsilon);
                const float t40 = 2.0f*l;
                const float t41 = 2.0f*t36/(wave7*wave7);
                const float t42 = t33*wave10*((t40 + 2.0f)*(t40 + 2.0f)) - t41*wave3;
                const float t43 = t38*wave5;
                const float t44 = 1.0f/wave7;
                const float t45 = wave9*(t40 + 1.0f);
                const float t46 = t37*t44;
                const float t47 = t45*t46;
                const float t48 = epsilon*(-t38*wave6 + t43 + t46*wave11*(t40 + 3.0f) - t47);
                const float value = -2.0f*t38*t39*wave8*(t33 + t37) -
                    (epsilon*(t33*wave12*((t40 + 4.0f)*(t40 + 4.0f)) - t41*wave4 - t42) + t42)*
                    (0.25f*t36*t44*t45 - 0.5f*t43 + 0.5f*t48 + 0.5f*
                    sqrtf(t39*(4.0f*(t33*t33)*(wave*wave) + (t35*t35)*(wave2*wave2)/(t34*t34)) +
                    ((-t43 + t47 + t48)*(-t43 + t47 + t48))));
                const float next_b = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? b : a);
                const float next_fb = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? fb : fa);
                const float next_a = new_;
                const float next_fa = value;
                const float next_c = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? a : b);
                const float next_fc = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? fa : fb);
                b = next_b;
                fb = next_fb;
                a = next_a;
                fa = next_fa;
                c = next_c;
                fc = next_fc;
            }
            root = (fabsf(fa) < fabsf(fb) ? a : b);
        }
    }
    return root;
}

// the wall whose worst angle is theta, as an angle, or NaN
static float touching(float theta, float l, float epsilon) {
    const float found = turn(0.5f*theta, l, epsilon);
    if (found < 0.5f*3.1415927f) {
        return found;
    }
    return NAN;
}

// the worst angle of the stiffest passive wall, at a fraction
static float passive_angle(float l, float epsilon) {
    const float low = 1e-06f*3.1415927f/(2.0f*epsilon + 2.0f*l + 2.0f);
    const float turned = turn(low, l, epsilon);
    const float wall = cosf(turned)/(l + 1.0f);
    const float wall2 = sinf(turned) - 0.5f*cosf(turned)/(l + 1.0f);
    const float need_ = need(wall, wall2, l, epsilon, low);
    const float above = -epsilon*(1.0f - epsilon)*(wall + 2.0f*wall2)*(sinf(low)*sinf(low)) + need_*
        (epsilon*(-cos_next(l, 2.0f*low) + cos_next(l + 1.0f, 2.0f*low)) + cos_next(l, 2.0f*low));
    float root;
    if (above <= 0.0f) {
        root = low;
    } else {
        const float high = 3.1415927f/(2.0f*epsilon + 2.0f*l + 2.0f);
        const float turned2 = turn(high, l, epsilon);
        const float wall3 = cosf(turned2)/(l + 1.0f);
        const float wall4 = sinf(turned2) - 0.5f*cosf(turned2)/(l + 1.0f);
        const float need2 = need(wall3, wall4, l, epsilon, high);
        const float below = -epsilon*(1.0f - epsilon)*(wall3 + 2.0f*wall4)*
            (sinf(high)*sinf(high)) + need2*(epsilon*
            (-cos_next(l, 2.0f*high) + cos_next(l + 1.0f, 2.0f*high)) + cos_next(l, 2.0f*high));
        if (below >= 0.0f) {
            root = high;
        } else {
            float b = low;
            float fb = above;
            float a = high;
            float fa = below;
            float c = high;
            float fc = below;
            for (int count_b = 0; count_b < 120; ++count_b) {
                if (((fa <= 0.0f) && (fb <= 0.0f)) || ((fa >= 0.0f) && (fb >= 0.0f)) ||
                    (fabsf(a - b) <= 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b)))) {
                    break; }
                const float span = -b + c;
                const float rise_ = -fb + fc;
                const float whole = (span == 0.0f ? 1.0f : span);
                const float place = (a - b)/whole;
                const float whole2 = (rise_ == 0.0f ? 1.0f : rise_);
                const float height = (fa - fb)/whole2;
                const float safe = ((place < 1.0f - ((1.0f - height)*(1.0f - height))) &&
                    (place > (height*height)) ? 1.0f : 0.0f);
                const float one = (safe > 0.0f ? -fa + fb : 1.0f);
                const float two = (safe > 0.0f ? fb - fc : 1.0f);
                const float three = (safe > 0.0f ? fa - fc : 1.0f);
                const float width = -a + b;
                const float here = fa/one;
                const float there = fc/two;
                const float whole3 = (width == 0.0f ? 1.0f : width);
                const float other = fa/three;
                const float last = fb/two;
                const float guess = (safe > 0.0f ? here*there + last*other*(-a + c)/whole3 : 0.5f);
                const float edge = 2.3841858e-07f*fabsf((fabsf(fa) < fabsf(fb) ? a : b))/
                    fabsf(whole3);
                const float edge2 = fminf(0.5f, edge);
                const float share = fminf(guess, 1.0f - edge2);
                const float share2 = fmaxf(edge2, share);
                const float new_ = a + share2*width;
                const float turned3 = turn(new_, l, epsilon);
                const float wall5 = cosf(turned3)/(l + 1.0f);
                const float wall6 = sinf(turned3) - 0.5f*cosf(turned3)/(l + 1.0f);
                const float need3 = need(wall5, wall6, l, epsilon, new_);
                const float value = -epsilon*(1.0f - epsilon)*(wall5 + 2.0f*wall6)*
                    (sinf(new_)*sinf(new_)) + need3*(epsilon*
                    (-cos_next(l, 2.0f*new_) + cos_next(l + 1.0f, 2.0f*new_)) +
                    cos_next(l, 2.0f*new_));
                const float next_b = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? b : a);
                const float next_fb = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? fb : fa);
                const float next_a = new_;
                const float next_fa = value;
                const float next_c = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? a : b);
                const float next_fc = (((fa < 0.0f) && (value < 0.0f)) ||
                    ((fa > 0.0f) && (value > 0.0f)) ? fa : fb);
                b = next_b;
                fb = next_fb;
                a = next_a;
                fa = next_fa;
                c = next_c;
                fc = next_fc;
            }
            root = (fabsf(fa) < fabsf(fb) ? a : b);
        }
    }
    return 2.0f*root;
}

void haptic_single_discretize(float gamma, float delta, float *n1_out, float *n0_out, float *a_out,
    float *e_out) {
    if (!((delta <= 1e+08f) && (delta >= 0.0f) && (gamma <= 1e+08f) && (gamma >= 0.0f))) {
        *n1_out = NAN;
        *n0_out = NAN;
        *a_out = NAN;
        *e_out = NAN;
        return;
    }
    float fall_of, rise_of, swing_of;
    fall_rise_swing(gamma, delta, &fall_of, &rise_of, &swing_of);
    *n1_out = rise_of;
    *n0_out = fall_of;
    *a_out = swing_of;
    *e_out = expf(-delta);
    return;
}

void haptic_single_discretize_late(float gamma, float delta, float epsilon, float *m2_out,
    float *m1_out, float *m0_out, float *a_out, float *e_out) {
    if (!((delta <= 1e+08f) && (delta >= 0.0f) && (epsilon < 1.0f) && (epsilon >= 0.0f) &&
        (gamma <= 1e+08f) && (gamma >= 0.0f))) {
        *m2_out = NAN;
        *m1_out = NAN;
        *m0_out = NAN;
        *a_out = NAN;
        *e_out = NAN;
        return;
    }
    float swing_of, together_of;
    swing_together(gamma, delta, &swing_of, &together_of);
    const float t0 = 1.0f - epsilon;
    const float t1 = (t0*t0);
    const float t2 = delta*t0;
    const float rise_of = rise(gamma*t1, t2);
    const float t3 = rise_of*t1;
    const float t4 = (epsilon*epsilon);
    const float fall_of = fall(gamma*t4, delta*epsilon);
    const float t5 = fall_of*t4*expf(-t2);
    *m2_out = t3;
    *m1_out = -t3 - t5 + together_of;
    *m0_out = t5;
    *a_out = swing_of;
    *e_out = expf(-delta);
    return;
}

bool haptic_single_is_stable(float alpha, float beta, float gamma, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f) && (gamma <= 1e+08f) &&
        (gamma >= 0.0f))) {
        return false;
    }
    if (late_part(d) == 0.0f) {
        float apart_of, fall_of2, nyquist_of, rise_of3, together_of;
        apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of,
            &rise_of3, &together_of);
        const float t1 = gamma*together_of;
        const float t3 = delta*decay(delta);
        return stable(whole_roots(alpha, beta, d, rise_of3, fall_of2, t1, nyquist_of, t3,
            together_of, apart_of*delta), alpha, beta, gamma, delta) != 0.0f;
    }
    float apart_of, fall_of2, nyquist_of, rise_of3, together_of;
    apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of, &rise_of3,
        &together_of);
    const float t1 = gamma*together_of;
    const float t3 = delta*decay(delta);
    const float t4 = some_part(d);
    const float t5 = 1.0f - t4;
    const float t6 = (t5*t5);
    const float t7 = gamma*t6;
    const float t8 = delta*t5;
    float apart_of3, fall_of3, kick_of2, kick_low_of2, rise_of;
    apart_fall_kick_kick_low_rise(t7, t8, &apart_of3, &fall_of3, &kick_of2, &kick_low_of2,
        &rise_of);
    const float t10 = (t4*t4);
    const float t11 = gamma*t10;
    const float t12 = delta*t4;
    float apart_of2, fall_of, kick_of, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t11, t12, &apart_of2, &fall_of, &kick_of, &kick_low_of,
        &rise_of2);
    const float t13 = fall_of*t10;
    return stable(late_roots(alpha, beta, whole_part(d), rise_of*t6, t13*expf(-t8), t1, nyquist_of,
        t3, together_of, late_apart(t4, kick_of2, kick_low_of2, kick_of, kick_low_of, apart_of3*
        delta*(t5*t5*t5), apart_of2*delta*(t4*t4*t4), fall_of3*t6*(kick_of*t12 + rise_of2*t11) +
        rise_of*rise_of2*t10*t7 - t13*t8*decay(t8))), alpha, beta, gamma, delta) != 0.0f;
}

float haptic_single_unstable_roots(float alpha, float beta, float gamma, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f) && (gamma <= 1e+08f) &&
        (gamma >= 0.0f))) {
        return -1.0f;
    }
    if (late_part(d) == 0.0f) {
        float apart_of, fall_of2, nyquist_of, rise_of3, together_of;
        apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of,
            &rise_of3, &together_of);
        const float t1 = gamma*together_of;
        const float t3 = delta*decay(delta);
        return whole_roots(alpha, beta, d, rise_of3, fall_of2, t1, nyquist_of, t3, together_of,
            apart_of*delta);
    }
    float apart_of, fall_of2, nyquist_of, rise_of3, together_of;
    apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of, &rise_of3,
        &together_of);
    const float t1 = gamma*together_of;
    const float t3 = delta*decay(delta);
    const float t4 = some_part(d);
    const float t5 = 1.0f - t4;
    const float t6 = (t5*t5);
    const float t7 = gamma*t6;
    const float t8 = delta*t5;
    float apart_of3, fall_of3, kick_of2, kick_low_of2, rise_of;
    apart_fall_kick_kick_low_rise(t7, t8, &apart_of3, &fall_of3, &kick_of2, &kick_low_of2,
        &rise_of);
    const float t10 = (t4*t4);
    const float t11 = gamma*t10;
    const float t12 = delta*t4;
    float apart_of2, fall_of, kick_of, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t11, t12, &apart_of2, &fall_of, &kick_of, &kick_low_of,
        &rise_of2);
    const float t13 = fall_of*t10;
    return late_roots(alpha, beta, whole_part(d), rise_of*t6, t13*expf(-t8), t1, nyquist_of, t3,
        together_of, late_apart(t4, kick_of2, kick_low_of2, kick_of, kick_low_of, apart_of3*delta*
        (t5*t5*t5), apart_of2*delta*(t4*t4*t4), fall_of3*t6*(kick_of*t12 + rise_of2*t11) + rise_of*
        rise_of2*t10*t7 - t13*t8*decay(t8)));
}

void haptic_single_stability_boundary(float theta, float gamma, float delta, float d,
    float *alpha_out, float *beta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (gamma <= 1e+08f) && (gamma >= 0.0f) && (theta <= 3.1415925f) && (theta > 0.0f))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0f) {
        float cos_next_of, sin_next_of;
        cos_next_sin_next(d, theta, &cos_next_of, &sin_next_of);
        float apart_of, nyquist_of, together_of;
        apart_nyquist_together(gamma, delta, &apart_of, &nyquist_of, &together_of);
        const float t1 = 0.5f*theta;
        const float t3 = gamma*together_of;
        const float t5 = delta*decay(delta);
        const float t6 = apart_of*delta;
        const float t7 = t6 + together_of;
        float ahead_of, in_phase_of;
        ahead_in_phase(t1, t3, nyquist_of, t5, together_of, t6, t7, &ahead_of, &in_phase_of);
        const float t11 = tanf(t1);
        const float t12 = ahead_of*cos_next_of + in_phase_of*sin_next_of;
        const float t13 = sinf(theta);
        *alpha_out = ahead_of*sin_next_of - cos_next_of*in_phase_of + t11*t12;
        *beta_out = -t12/t13;
        return;
    }
    float apart_of, nyquist_of, together_of;
    apart_nyquist_together(gamma, delta, &apart_of, &nyquist_of, &together_of);
    const float t1 = 0.5f*theta;
    const float t3 = gamma*together_of;
    const float t5 = delta*decay(delta);
    const float t11 = tanf(t1);
    const float t13 = sinf(theta);
    const float t14 = whole_part(d);
    float cos_next_of2, sin_next_of2;
    cos_next_sin_next(t14, theta, &cos_next_of2, &sin_next_of2);
    const float t16 = some_part(d);
    const float t17 = 1.0f - t16;
    const float t18 = (t17*t17);
    const float t19 = gamma*t18;
    const float t20 = delta*t17;
    float apart_of2, fall_of2, kick_of2, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t19, t20, &apart_of2, &fall_of2, &kick_of2, &kick_low_of,
        &rise_of2);
    const float t21 = (t16*t16);
    const float t22 = gamma*t21;
    const float t23 = delta*t16;
    float apart_of3, fall_of, kick_of, kick_low_of2, rise_of;
    apart_fall_kick_kick_low_rise(t22, t23, &apart_of3, &fall_of, &kick_of, &kick_low_of2,
        &rise_of);
    const float t25 = fall_of*t21;
    const float t28 = late_apart(t16, kick_of2, kick_low_of, kick_of, kick_low_of2, apart_of2*delta*
        (t17*t17*t17), apart_of3*delta*(t16*t16*t16), fall_of2*t18*(kick_of*t23 + rise_of*t22) +
        rise_of*rise_of2*t19*t21 - t20*t25*decay(t20));
    const float t29 = 2.0f*rise_of2*t18 - 2.0f*t25*expf(-t20);
    float ahead_of2, in_phase_of2;
    ahead_in_phase(t1, t3, nyquist_of, t5, together_of, t28, t29, &ahead_of2, &in_phase_of2);
    const float t33 = ahead_of2*cos_next_of2 + in_phase_of2*sin_next_of2;
    *alpha_out = ahead_of2*sin_next_of2 - cos_next_of2*in_phase_of2 + t11*t33;
    *beta_out = -t33/t13;
    return;
}

void haptic_single_max_stable_stiffness(float gamma, float delta, float d, float *alpha_out,
    float *beta_out, float *theta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (gamma <= 1e+08f) && (gamma >= 0.0f))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        *theta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0f) {
        float apart_of, fall_of, nyquist_of, rise_of, together_of;
        apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of, &nyquist_of, &rise_of,
            &together_of);
        const float t1 = gamma*together_of;
        const float t3 = delta*decay(delta);
        const float t4 = apart_of*delta;
        const float t5 = stiffest_angle(gamma, delta, d, d, 0.0f, rise_of, fall_of, t1, nyquist_of,
            t3, together_of, t4);
        float cos_next_of, sin_next_of;
        cos_next_sin_next(d, t5, &cos_next_of, &sin_next_of);
        const float t7 = 0.5f*t5;
        const float t8 = sinf(t7);
        const float t9 = cosf(t7);
        const float t10 = t4 + together_of;
        const float t11 = (t9*t9);
        const float t12 = (t8*t8);
        const float t13 = t11*t12;
        const float t14 = t11*together_of - t12*t4;
        const float t15 = 1.0f/((t10*t10)*t13 + (t14*t14));
        const float t16 = 2.0f*t3;
        const float t17 = -nyquist_of*t12 + t1*t11;
        const float t18 = -t10*t17 + t14*t16;
        const float t19 = t10*t13*t16 + t14*t17;
        const float t20 = cos_next_of*t15;
        const float t21 = -sin_next_of*t15*t19/sinf(t5) - 0.5f*t18*t20;
        *alpha_out = sin_next_of*t15*t18*t8*t9 - 2.0f*t12*t21 - t19*t20;
        *beta_out = t21;
        *theta_out = t5;
        return;
    }
    float apart_of, fall_of, nyquist_of, rise_of, together_of;
    apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of, &nyquist_of, &rise_of,
        &together_of);
    const float t1 = gamma*together_of;
    const float t3 = delta*decay(delta);
    const float t16 = 2.0f*t3;
    const float t22 = whole_part(d);
    const float t23 = some_part(d);
    const float t24 = 1.0f - t23;
    const float t25 = (t24*t24);
    const float t26 = gamma*t25;
    const float t27 = delta*t24;
    float apart_of2, fall_of3, kick_of2, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t26, t27, &apart_of2, &fall_of3, &kick_of2, &kick_low_of,
        &rise_of2);
    const float t29 = rise_of2*t25;
    const float t30 = (t23*t23);
    const float t31 = gamma*t30;
    const float t32 = delta*t23;
    float apart_of3, fall_of2, kick_of, kick_low_of2, rise_of3;
    apart_fall_kick_kick_low_rise(t31, t32, &apart_of3, &fall_of2, &kick_of, &kick_low_of2,
        &rise_of3);
    const float t33 = fall_of2*t30;
    const float t34 = t33*expf(-t27);
    const float t37 = late_apart(t23, kick_of2, kick_low_of, kick_of, kick_low_of2, apart_of2*delta*
        (t24*t24*t24), apart_of3*delta*(t23*t23*t23), fall_of3*t25*(kick_of*t32 + rise_of3*t31) +
        rise_of2*rise_of3*t26*t30 - t27*t33*decay(t27));
    const float t38 = stiffest_angle(gamma, delta, d, t22, t23, t29, t34, t1, nyquist_of, t3,
        together_of, t37);
    float cos_next_of2, sin_next_of2;
    cos_next_sin_next(t22, t38, &cos_next_of2, &sin_next_of2);
    const float t39 = 0.5f*t38;
    const float t40 = sinf(t39);
    const float t41 = cosf(t39);
    const float t43 = 2.0f*t29 - 2.0f*t34;
    const float t44 = (t41*t41);
    const float t45 = (t40*t40);
    const float t46 = t44*t45;
    const float t47 = -t37*t45 + t44*together_of;
    const float t48 = 1.0f/((t43*t43)*t46 + (t47*t47));
    const float t49 = -nyquist_of*t45 + t1*t44;
    const float t50 = t16*t47 - t43*t49;
    const float t51 = t16*t43*t46 + t47*t49;
    const float t52 = cos_next_of2*t48;
    const float t53 = -sin_next_of2*t48*t51/sinf(t38) - 0.5f*t50*t52;
    *alpha_out = sin_next_of2*t40*t41*t48*t50 - 2.0f*t45*t53 - t51*t52;
    *beta_out = t53;
    *theta_out = t38;
    return;
}

float haptic_single_passivity_margin_at(float theta, float alpha, float beta, float delta,
    float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f) && (theta <= 3.1415925f) &&
        (theta > 0.0f))) {
        return NAN;
    }
    const float t0 = 0.5f*theta;
    const float cos_next_of = cos_next(d, theta);
    const float sin_next_of = sin_next(2.0f*d, t0);
    return -0.5f*alpha*sin_next_of/sinf(t0) + beta*cos_next_of + delta;
}

float haptic_single_passivity_margin(float alpha, float beta, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(alpha) <= 1e+08f) && (fabsf(beta) <= 1e+08f))) {
        return NAN;
    }
    return delta - largest_need(alpha, beta, d);
}

void haptic_single_passivity_boundary(float theta, float delta, float d, float *alpha_out,
    float *beta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (theta <= 3.1415925f) && (theta > 0.0f))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0f) {
        const float t0 = lead(theta, d, 0.0f);
        const float t1 = delta/spread(d, theta);
        const float t2 = 0.5f*theta;
        const float t15 = sinc(t2);
        const float sin_next_of = sin_next(d, theta);
        const float t3 = sin_next_of*(t15*t15)*(d + 1.0f)/theta;
        *alpha_out = rated(t0, 2.0f*t1*t3);
        *beta_out = rated(t0, t1*(-t3 + chord(d, theta)));
        return;
    }
    const float t2 = 0.5f*theta;
    const float t4 = whole_part(d);
    const float t5 = some_part(d);
    const float t6 = lead(theta, t4, t5);
    const float t7 = t4 + 1.0f;
    const float t8 = touching(theta, t4, t5);
    const float t9 = cosf(t8);
    const float t10 = t9/t7;
    const float t11 = sinf(t8);
    const float t12 = -0.5f*t10 + t11;
    const float t13 = between(t5, straight(t10, t12, t4, t2), straight(t10, t12, t7, t2));
    const float t16 = sinf(t2);
    const float t17 = cosf(t2);
    const float t14 = delta/(0.5f*t13 + 0.5f*
        sqrtf((t13*t13) + t5*(1.0f - t5)*(4.0f*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7))));
    *alpha_out = rated(t6, t10*t14);
    *beta_out = rated(t6, t12*t14);
    return;
}

void haptic_single_max_passive_stiffness(float delta, float d, float *alpha_out, float *beta_out,
    float *theta_out) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        *theta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0f) {
        const float t0 = 3.1415927f/(d + 1.0f);
        const float t1 = tanf(0.25f*t0);
        const float t2 = 0.5f*t0;
        *alpha_out = 2.0f*delta*t1;
        *beta_out = delta*(-t1 + 2.0f/(3.1415927f*sinc(t2)));
        *theta_out = t2;
        return;
    }
    const float t3 = whole_part(d);
    const float t4 = t3 + 1.0f;
    const float t5 = some_part(d);
    const float t6 = passive_angle(t3, t5);
    const float t7 = touching(t6, t3, t5);
    const float t8 = cosf(t7);
    const float t9 = t8/t4;
    const float t10 = sinf(t7);
    const float t11 = t10 - 0.5f*t9;
    const float t12 = 0.5f*t6;
    const float t13 = between(t5, straight(t9, t11, t3, t12), straight(t9, t11, t4, t12));
    const float t15 = sinf(t12);
    const float t16 = cosf(t12);
    const float t14 = delta/(0.5f*t13 + 0.5f*
        sqrtf((t13*t13) + t5*(1.0f - t5)*(4.0f*(t10*t10)*(t15*t15) + (t16*t16)*(t8*t8)/(t4*t4))));
    *alpha_out = t14*t9;
    *beta_out = t11*t14;
    *theta_out = t6;
    return;
}

float haptic_single_linear_limit(float beta, float delta, float d) {
    if (!((d <= 1e+06f) && (d >= 0.0f) && (delta <= 1e+08f) && (delta >= 0.0f) &&
        (fabsf(beta) <= 1e+08f))) {
        return NAN;
    }
    return (beta + delta)/(d + 0.5f);
}
