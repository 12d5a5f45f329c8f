/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#include "haptic.h"

#include <math.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static double cos_series(double w) {
    const double square = (w*w);
    const double b9 = 8.896791392450574e-22;
    const double b8 = 4.110317623312165e-19;
    const double b7 = b9*square + 1.5619206968586225e-16;
    const double b6 = b8*square + 4.779477332387385e-14;
    const double b5 = b7*square + 1.1470745597729725e-11;
    const double b4 = b6*square + 2.08767569878681e-09;
    const double b3 = b5*square + 2.755731922398589e-07;
    const double b2 = b4*square + 2.48015873015873e-05;
    const double b1 = b3*square + 0.001388888888888889;
    const double b0 = b2*square + 0.041666666666666664;
    return b0 + b1*w;
}

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static double decay_series(double x) {
    const double square = (x*x);
    const double b16 = 8.22063524662433e-18;
    const double b15 = 1.5619206968586225e-16;
    const double b14 = b16*square + 2.8114572543455206e-15;
    const double b13 = b15*square + 4.779477332387385e-14;
    const double b12 = b14*square + 7.647163731819816e-13;
    const double b11 = b13*square + 1.1470745597729725e-11;
    const double b10 = b12*square + 1.6059043836821613e-10;
    const double b9 = b11*square + 2.08767569878681e-09;
    const double b8 = b10*square + 2.505210838544172e-08;
    const double b7 = b9*square + 2.755731922398589e-07;
    const double b6 = b8*square + 2.7557319223985893e-06;
    const double b5 = b7*square + 2.48015873015873e-05;
    const double b4 = b6*square + 0.0001984126984126984;
    const double b3 = b5*square + 0.001388888888888889;
    const double b2 = b4*square + 0.008333333333333333;
    const double b1 = b3*square + 0.041666666666666664;
    const double b0 = b2*square + 0.16666666666666666;
    return b0 - b1*x;
}

// divided difference of exp at 0, p and q, less 1/2
static double fall_series(double gamma, double delta) {
    if ((delta < 0.125) && (fabs(gamma) < 0.00390625)) {
        const double b11 = 1.6059043836821613e-10;
        const double b10 = b11*delta + 2.08767569878681e-09;
        const double b9 = b10*delta - b11*gamma + 2.505210838544172e-08;
        const double b8 = -b10*gamma + b9*delta + 2.755731922398589e-07;
        const double b7 = b8*delta - b9*gamma + 2.7557319223985893e-06;
        const double b6 = b7*delta - b8*gamma + 2.48015873015873e-05;
        const double b5 = b6*delta - b7*gamma + 0.0001984126984126984;
        const double b4 = b5*delta - b6*gamma + 0.001388888888888889;
        const double total = b4*delta;
        const double lost = fma(delta, b4, -(delta*b4));
        const double total2 = b5*gamma;
        const double lost2 = fma(gamma, b5, -(gamma*b5));
        const double total3 = total - total2;
        const double back = -total + total3;
        const double rest = -back + total3;
        const double one = -rest + total;
        const double two = -back - total2;
        const double lost3 = one + two;
        const double total4 = total3 + 0.008333333333333333;
        const double back2 = -total3 + total4;
        const double rest2 = -back2 + total4;
        const double one2 = -rest2 + total3;
        const double two2 = 0.008333333333333333 - back2;
        const double lost4 = one2 + two2;
        const double low = lost - lost2 + lost3 + lost4;
        const double total5 = delta*total4;
        const double lost5 = delta*low + fma(delta, total4, -(delta*total4));
        const double total6 = b4*gamma;
        const double lost6 = fma(gamma, b4, -(gamma*b4));
        const double total7 = total5 - total6;
        const double back3 = -total5 + total7;
        const double rest3 = -back3 + total7;
        const double one3 = -rest3 + total5;
        const double two3 = -back3 - total6;
        const double lost7 = one3 + two3;
        const double total8 = total7 + 0.041666666666666664;
        const double back4 = -total7 + total8;
        const double rest4 = -back4 + total8;
        const double one4 = -rest4 + total7;
        const double two4 = 0.041666666666666664 - back4;
        const double lost8 = one4 + two4;
        const double low2 = lost5 - lost6 + lost7 + lost8;
        const double total9 = delta*total8;
        const double lost9 = delta*low2 + fma(delta, total8, -(delta*total8));
        const double total10 = gamma*total4;
        const double lost10 = gamma*low + fma(gamma, total4, -(gamma*total4));
        const double total11 = -total10 + total9;
        const double back5 = total11 - total9;
        const double rest5 = -back5 + total11;
        const double one5 = -rest5 + total9;
        const double two5 = -back5 - total10;
        const double lost11 = one5 + two5;
        const double total12 = total11 + 0.16666666666666666;
        const double back6 = -total11 + total12;
        const double rest6 = -back6 + total12;
        const double one6 = -rest6 + total11;
        const double two6 = 0.16666666666666666 - back6;
        const double lost12 = one6 + two6;
        const double low3 = -lost10 + lost11 + lost12 + lost9;
        const double total13 = delta*total12;
        const double lost13 = delta*low3 + fma(delta, total12, -(delta*total12));
        const double total14 = gamma*total8;
        const double lost14 = gamma*low2 + fma(gamma, total8, -(gamma*total8));
        const double total15 = total13 - total14;
        const double back7 = -total13 + total15;
        const double rest7 = -back7 + total15;
        const double one7 = -rest7 + total13;
        const double two7 = -back7 - total14;
        const double lost15 = one7 + two7;
        const double total16 = total15;
        const double back8 = -total15 + total16;
        const double rest8 = -back8 + total16;
        const double one8 = -rest8 + total15;
        const double two8 = -back8;
        const double lost16 = one8 + two8;
        const double low4 = lost13 - lost14 + lost15 + lost16;
        return low4 + total16;
    }
    const double b26 = 3.279889237069838e-30;
    const double b25 = b26*delta + 9.183689863795546e-29;
    const double b24 = b25*delta - b26*gamma + 2.4795962632247976e-27;
    const double b23 = b24*delta - b25*gamma + 6.446950284384474e-26;
    const double b22 = b23*delta - b24*gamma + 1.6117375710961184e-24;
    const double b21 = b22*delta - b23*gamma + 3.868170170630684e-23;
    const double b20 = b21*delta - b22*gamma + 8.896791392450574e-22;
    const double b19 = b20*delta - b21*gamma + 1.9572941063391263e-20;
    const double b18 = b19*delta - b20*gamma + 4.110317623312165e-19;
    const double b17 = b18*delta - b19*gamma + 8.22063524662433e-18;
    const double b16 = b17*delta - b18*gamma + 1.5619206968586225e-16;
    const double b15 = b16*delta - b17*gamma + 2.8114572543455206e-15;
    const double b14 = b15*delta - b16*gamma + 4.779477332387385e-14;
    const double b13 = b14*delta - b15*gamma + 7.647163731819816e-13;
    const double b12 = b13*delta - b14*gamma + 1.1470745597729725e-11;
    const double b112 = b12*delta - b13*gamma + 1.6059043836821613e-10;
    const double b102 = b112*delta - b12*gamma + 2.08767569878681e-09;
    const double b92 = b102*delta - b112*gamma + 2.505210838544172e-08;
    const double b82 = -b102*gamma + b92*delta + 2.755731922398589e-07;
    const double b72 = b82*delta - b92*gamma + 2.7557319223985893e-06;
    const double b62 = b72*delta - b82*gamma + 2.48015873015873e-05;
    const double b52 = b62*delta - b72*gamma + 0.0001984126984126984;
    const double b42 = b52*delta - b62*gamma + 0.001388888888888889;
    const double total17 = b42*delta;
    const double lost17 = fma(delta, b42, -(delta*b42));
    const double total18 = b52*gamma;
    const double lost18 = fma(gamma, b52, -(gamma*b52));
    const double total19 = total17 - total18;
    const double back9 = -total17 + total19;
    const double rest9 = -back9 + total19;
    const double one9 = -rest9 + total17;
    const double two9 = -back9 - total18;
    const double lost19 = one9 + two9;
    const double total20 = total19 + 0.008333333333333333;
    const double back10 = -total19 + total20;
    const double rest10 = -back10 + total20;
    const double one10 = -rest10 + total19;
    const double two10 = 0.008333333333333333 - back10;
    const double lost20 = one10 + two10;
    const double low5 = lost17 - lost18 + lost19 + lost20;
    const double total21 = delta*total20;
    const double lost21 = delta*low5 + fma(delta, total20, -(delta*total20));
    const double total22 = b42*gamma;
    const double lost22 = fma(gamma, b42, -(gamma*b42));
    const double total23 = total21 - total22;
    const double back11 = -total21 + total23;
    const double rest11 = -back11 + total23;
    const double one11 = -rest11 + total21;
    const double two11 = -back11 - total22;
    const double lost23 = one11 + two11;
    const double total24 = total23 + 0.041666666666666664;
    const double back12 = -total23 + total24;
    const double rest12 = -back12 + total24;
    const double one12 = -rest12 + total23;
    const double two12 = 0.041666666666666664 - back12;
    const double lost24 = one12 + two12;
    const double low6 = lost21 - lost22 + lost23 + lost24;
    const double total25 = delta*total24;
    const double lost25 = delta*low6 + fma(delta, total24, -(delta*total24));
    const double total26 = gamma*total20;
    const double lost26 = gamma*low5 + fma(gamma, total20, -(gamma*total20));
    const double total27 = total25 - total26;
    const double back13 = -total25 + total27;
    const double rest13 = -back13 + total27;
    const double one13 = -rest13 + total25;
    const double two13 = -back13 - total26;
    const double lost27 = one13 + two13;
    const double total28 = total27 + 0.16666666666666666;
    const double back14 = -total27 + total28;
    const double rest14 = -back14 + total28;
    const double one14 = -rest14 + total27;
    const double two14 = 0.16666666666666666 - back14;
    const double lost28 = one14 + two14;
    const double low7 = lost25 - lost26 + lost27 + lost28;
    const double total29 = delta*total28;
    const double lost29 = delta*low7 + fma(delta, total28, -(delta*total28));
    const double total30 = gamma*total24;
    const double lost30 = gamma*low6 + fma(gamma, total24, -(gamma*total24));
    const double total31 = total29 - total30;
    const double back15 = -total29 + total31;
    const double rest15 = -back15 + total31;
    const double one15 = -rest15 + total29;
    const double two15 = -back15 - total30;
    const double lost31 = one15 + two15;
    const double total32 = total31;
    const double back16 = -total31 + total32;
    const double rest16 = -back16 + total32;
    const double one16 = -rest16 + total31;
    const double two16 = -back16;
    const double lost32 = one16 + two16;
    const double low8 = lost29 - lost30 + lost31 + lost32;
    return low8 + total32;
}

// divided difference of exp at h, sqrt(w), -sqrt(w), less 1/2
static double rise_series(double h, double w) {
    if ((fabs(w) < 0.00390625) && (h < 0.0625)) {
        const double e11 = 1.6059043836821613e-10;
        const double b11 = e11;
        const double e10 = 2.08767569878681e-09;
        const double b10 = b11*h + e10;
        const double e9 = e11*w + 2.505210838544172e-08;
        const double b9 = b10*h + e9;
        const double e8 = e10*w + 2.755731922398589e-07;
        const double b8 = b9*h + e8;
        const double e7 = e9*w + 2.7557319223985893e-06;
        const double b7 = b8*h + e7;
        const double e6 = e8*w + 2.48015873015873e-05;
        const double b6 = b7*h + e6;
        const double e5 = e7*w + 0.0001984126984126984;
        const double b5 = b6*h + e5;
        const double e4 = e6*w + 0.001388888888888889;
        const double b4 = b5*h + e4;
        const double e3 = e5*w + 0.008333333333333333;
        const double b3 = b4*h + e3;
        const double e2 = e4*w + 0.041666666666666664;
        const double b2 = b3*h + e2;
        const double e1 = e3*w + 0.16666666666666666;
        const double b1 = b2*h + e1;
        const double e0 = e2*w;
        const double b0 = b1*h + e0;
        return b0;
    }
    const double e26 = 3.279889237069838e-30;
    const double b26 = e26;
    const double e25 = 9.183689863795546e-29;
    const double b25 = b26*h + e25;
    const double e24 = e26*w + 2.4795962632247976e-27;
    const double b24 = b25*h + e24;
    const double e23 = e25*w + 6.446950284384474e-26;
    const double b23 = b24*h + e23;
    const double e22 = e24*w + 1.6117375710961184e-24;
    const double b22 = b23*h + e22;
    const double e21 = e23*w + 3.868170170630684e-23;
    const double b21 = b22*h + e21;
    const double e20 = e22*w + 8.896791392450574e-22;
    const double b20 = b21*h + e20;
    const double e19 = e21*w + 1.9572941063391263e-20;
    const double b19 = b20*h + e19;
    const double e18 = e20*w + 4.110317623312165e-19;
    const double b18 = b19*h + e18;
    const double e17 = e19*w + 8.22063524662433e-18;
    const double b17 = b18*h + e17;
    const double e16 = e18*w + 1.5619206968586225e-16;
    const double b16 = b17*h + e16;
    const double e15 = e17*w + 2.8114572543455206e-15;
    const double b15 = b16*h + e15;
    const double e14 = e16*w + 4.779477332387385e-14;
    const double b14 = b15*h + e14;
    const double e13 = e15*w + 7.647163731819816e-13;
    const double b13 = b14*h + e13;
    const double e12 = e14*w + 1.1470745597729725e-11;
    const double b12 = b13*h + e12;
    const double e112 = e13*w + 1.6059043836821613e-10;
    const double b112 = b12*h + e112;
    const double e102 = e12*w + 2.08767569878681e-09;
    const double b102 = b112*h + e102;
    const double e92 = e112*w + 2.505210838544172e-08;
    const double b92 = b102*h + e92;
    const double e82 = e102*w + 2.755731922398589e-07;
    const double b82 = b92*h + e82;
    const double e72 = e92*w + 2.7557319223985893e-06;
    const double b72 = b82*h + e72;
    const double e62 = e82*w + 2.48015873015873e-05;
    const double b62 = b72*h + e62;
    const double e52 = e72*w + 0.0001984126984126984;
    const double b52 = b62*h + e52;
    const double e42 = e62*w + 0.001388888888888889;
    const double b42 = b52*h + e42;
    const double e32 = e52*w + 0.008333333333333333;
    const double b32 = b42*h + e32;
    const double e27 = e42*w + 0.041666666666666664;
    const double b27 = b32*h + e27;
    const double e110 = e32*w + 0.16666666666666666;
    const double b110 = b27*h + e110;
    const double e02 = e27*w;
    const double b02 = b110*h + e02;
    return b02;
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static double sin_series(double w) {
    const double square = (w*w);
    const double b9 = 1.9572941063391263e-20;
    const double b8 = 8.22063524662433e-18;
    const double b7 = b9*square + 2.8114572543455206e-15;
    const double b6 = b8*square + 7.647163731819816e-13;
    const double b5 = b7*square + 1.6059043836821613e-10;
    const double b4 = b6*square + 2.505210838544172e-08;
    const double b3 = b5*square + 2.7557319223985893e-06;
    const double b2 = b4*square + 0.0001984126984126984;
    const double b1 = b3*square + 0.008333333333333333;
    const double b0 = b2*square + 0.16666666666666666;
    return b0 + b1*w;
}

// n0, the same device with its time reversed, times exp(-delta); n1, how far a unit force moves the
// device in a period; a, the sum of the sampled device's poles
static void fall_rise_swing(double gamma, double delta, double *fall_out, double *rise_out,
    double *swing_out) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    double fall_of;
    double rise_of;
    double swing_of;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 0.5625) {
            const double square2 = total2;
            const double envelope = exp(-half);
            const double given5 = 0.5*half;
            const double total54 = 1.0 - 0.5*given5;
            const double back32 = total54 - 1.0;
            const double lost54 = -back32 - 0.5*given5;
            const double decay_series_of4 = decay_series(given5);
            const double curved5 = decay_series_of4*(given5*given5);
            const double total55 = curved5 + total54;
            const double back33 = -total54 + total55;
            const double lost55 = -back33 + curved5;
            const double mean_low6 = lost54 + lost55;
            const double total56 = given5*total55;
            const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
            const double total57 = 1.0 - total56;
            const double back34 = total57 - 1.0;
            const double lost57 = -back34 - total56;
            const double fall_low6 = -lost56 + lost57;
            const double total58 = (total57*total57);
            const double lost58 = 2.0*fall_low6*total57 + fma(total57, total57, -(total57*total57));
            const double total59 = (total58*total58);
            const double lost59 = 2.0*lost58*total58 + fma(total58, total58, -(total58*total58));
            const double rest15 = fall_series(gamma, delta);
            const double total60 = rest15 + 0.5;
            const double back35 = -rest15 + total60;
            const double rest16 = -back35 + total60;
            const double one14 = rest15 - rest16;
            const double two14 = 0.5 - back35;
            const double lost60 = one14 + two14;
            const double total61 = total59*total60;
            const double lost61 = lost60*total59 + fma(total59, total60, -(total59*total60));
            const double half2 = half;
            const double given52 = 0.5*half2;
            const double total532 = 1.0 - 0.5*given52;
            const double back312 = total532 - 1.0;
            const double lost532 = -back312 - 0.5*given52;
            const double decay_series_of5 = decay_series(given52);
            const double curved52 = decay_series_of5*(given52*given52);
            const double total542 = curved52 + total532;
            const double back322 = -total532 + total542;
            const double lost542 = -back322 + curved52;
            const double mean_low62 = lost532 + lost542;
            const double total552 = given52*total542;
            const double lost552 = given52*mean_low62 + fma(given52, total542, -(given52*total542));
            const double total562 = 1.0 - total552;
            const double back332 = total562 - 1.0;
            const double lost562 = -back332 - total552;
            const double fall_low62 = -lost552 + lost562;
            const double total572 = (total562*total562);
            const double lost572 = 2.0*fall_low62*total562 +
                fma(total562, total562, -(total562*total562));
            const double rest132 = rise_series(half2, total2);
            const double total582 = rest132 + 0.5;
            const double back342 = -rest132 + total582;
            const double rest142 = -back342 + total582;
            const double one122 = rest132 - rest142;
            const double two122 = 0.5 - back342;
            const double lost582 = one122 + two122;
            const double total592 = total572*total582;
            const double lost592 = lost582*total572 + fma(total572, total582, -(total572*total582));
            double even;
            double even_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total20 = 0.5*given3 + 1.0;
                const double back13 = total20 - 1.0;
                const double lost20 = -back13 + 0.5*given3;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total21 = curved3 + total20;
                const double back14 = -total20 + total21;
                const double lost21 = -back14 + curved3;
                const double even_low = 0.5*lost2 + lost20 + lost21;
                even = total21;
                even_low2 = even_low;
            } else {
                const double size = fabs(total2);
                const double root = sqrt(size);
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const double total212 = envelope*even;
            const double lost212 = envelope*even_low2 + fma(envelope, even, -(envelope*even));
            fall_of = lost59*total60 + lost61 + total61;
            rise_of = lost572*total582 + lost592 + total592;
            swing_of = 2.0*lost212 + 2.0*total212;
        } else {
            const double size = fabs(total2);
            const double root = sqrt(size);
            const double square2 = total2;
            const double envelope = exp(-half);
            const double stiff = gamma;
            double even;
            double even_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total20 = 0.5*given3 + 1.0;
                const double back13 = total20 - 1.0;
                const double lost20 = -back13 + 0.5*given3;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total21 = curved3 + total20;
                const double back14 = -total20 + total21;
                const double lost21 = -back14 + curved3;
                const double even_low = 0.5*lost2 + lost20 + lost21;
                even = total21;
                even_low2 = even_low;
            } else {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const double total212 = envelope*even;
            const double lost212 = envelope*even_low2 + fma(envelope, even, -(envelope*even));
            double count;
            if (root < 67108864.0) {
                count = floor(0.5*root/3.141592653589793 + 0.5);
            } else {
                count = 0.0;
            }
            const double turns = (count*count);
            const double total29 = 39.47841760435743*turns;
            const double lost29 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
            const double total30 = 2.5061182034958845e-15*turns;
            const double lost30 = fma(turns, 2.5061182034958845e-15,
                -(turns*2.5061182034958845e-15));
            const double total31 = -total2 - total29;
            const double back18 = total2 + total31;
            const double rest6 = -back18 + total31;
            const double one5 = -rest6 - total2;
            const double two5 = -back18 - total29;
            const double lost31 = one5 + two5;
            const double total32 = -lost29 + total31;
            const double back19 = -total31 + total32;
            const double rest7 = -back19 + total32;
            const double one6 = -rest7 + total31;
            const double two6 = -back19 - lost29;
            const double lost32 = one6 + two6;
            const double total33 = -total30 + total32;
            const double back20 = -total32 + total33;
            const double rest8 = -back20 + total33;
            const double one7 = -rest8 + total32;
            const double two7 = -back20 - total30;
            const double lost33 = one7 + two7;
            const double total34 = -lost2 + total33;
            const double back21 = -total33 + total34;
            const double rest9 = -back21 + total34;
            const double one8 = -rest9 + total33;
            const double two8 = -back21 - lost2;
            const double lost34 = one8 + two8;
            const double low = -lost30 + lost31 + lost32 + lost33 + lost34 - 1.4920070805839235e-31*
                turns;
            const double total35 = low + total34;
            const double total36 = 6.283185307179586*count;
            const double total37 = root + total36;
            const double whole3 = (total37 == 0.0 ? 1.0 : total37);
            const double total38 = total35/whole3;
            const double far = (total38*total38);
            if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back22 = -total34 + total35;
                const double rest10 = -back22 + total35;
                const double one9 = -rest10 + total34;
                const double two9 = -back22 + low;
                const double lost35 = one9 + two9;
                const double lost36 = fma(count, 6.283185307179586, -(count*6.283185307179586));
                const double back23 = -root + total37;
                const double rest11 = -back23 + total37;
                const double one10 = -rest11 + root;
                const double two10 = -back23 + total36;
                const double lost37 = one10 + two10;
                const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low;
                const double left19 = total35 - total38*whole3;
                const double left20 = left19 - fma(total38, whole3, -(total38*whole3));
                const double left21 = -both_low*total38 + left20 + lost35;
                const double lost38 = left21/whole3;
                const double eta = total38;
                const double eta_low = lost38;
                const double total39 = (eta*eta);
                const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                const double cos_series_of2 = cos_series(-total39);
                const double bent2 = cos_series_of2*(total39*total39);
                const double total40 = -bent2 + 0.5*total39;
                const double back24 = -0.5*total39 + total40;
                const double lost40 = -back24 - bent2;
                const double sin_series_of2 = sin_series(-total39);
                const double total41 = -sin_series_of2*total39 + 1.0;
                const double back25 = total41 - 1.0;
                const double lost41 = -back25 - sin_series_of2*total39;
                const double lift_low = 0.5*lost39*total41 + lost40;
                const double total42 = eta*total41;
                const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                const double some2 = root;
                const double total43 = total42/some2;
                const double left22 = -some2*total43 + total42;
                const double left23 = left22 - fma(total43, some2, -(total43*some2));
                const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*total43;
                const double lost43 = left24/some2;
                const double given4 = half;
                const double total44 = 1.0 - 0.5*given4;
                const double back26 = total44 - 1.0;
                const double lost44 = -back26 - 0.5*given4;
                const double decay_series_of3 = decay_series(given4);
                const double curved4 = decay_series_of3*(given4*given4);
                const double total45 = curved4 + total44;
                const double back27 = -total44 + total45;
                const double lost45 = -back27 + curved4;
                const double mean_low5 = lost44 + lost45;
                const double total46 = given4*total45;
                const double lost46 = given4*mean_low5 + fma(given4, total45, -(given4*total45));
                const double total47 = 1.0 - total46;
                const double back28 = total47 - 1.0;
                const double lost47 = -back28 - total46;
                const double fall_low5 = -lost46 + lost47;
                const double total48 = -total43 + total45;
                const double back29 = -total45 + total48;
                const double rest12 = -back29 + total48;
                const double one11 = -rest12 + total45;
                const double two11 = -back29 - total43;
                const double lost48 = one11 + two11;
                const double total49 = given4*total48;
                const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                    fma(given4, total48, -(given4*total48));
                const double total50 = total40 - total49;
                const double back30 = -total40 + total50;
                const double rest13 = -back30 + total50;
                const double one12 = -rest13 + total40;
                const double two12 = -back30 - total49;
                const double lost50 = one12 + two12;
                const double low2 = lift_low - lost49 + lost50;
                const double total51 = low2 + total50;
                const double back31 = -total50 + total51;
                const double rest14 = -back31 + total51;
                const double one13 = -rest14 + total50;
                const double two13 = -back31 + low2;
                const double lost51 = one13 + two13;
                const double total52 = total47*total51;
                const double lost52 = lost51*total47 + fma(total47, total51, -(total47*total51));
                const double low3 = fall_low5*total51 + lost52;
                const double total53 = total52/stiff;
                const double left25 = -stiff*total53 + total52;
                const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                const double left27 = left26 + low3;
                const double lost53 = left27/stiff;
                const double total472 = total43*total47;
                const double lost472 = lost43*total47 + fma(total47, total43, -(total47*total43));
                const double total482 = total45 - total472;
                const double back292 = -total45 + total482;
                const double rest112 = -back292 + total482;
                const double one102 = -rest112 + total45;
                const double two102 = -back292 - total472;
                const double lost482 = one102 + two102;
                const double low22 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                const double total492 = given4*total482;
                const double lost492 = given4*low22 + fma(given4, total482, -(given4*total482));
                const double total502 = total40*total47;
                const double lost502 = lift_low*total47 + fma(total47, total40, -(total47*total40));
                const double total512 = total492 + total502;
                const double back302 = -total492 + total512;
                const double rest122 = -back302 + total512;
                const double one112 = -rest122 + total492;
                const double two112 = -back302 + total502;
                const double lost512 = one112 + two112;
                const double low32 = fall_low5*total40 + lost492 + lost502 + lost512;
                const double total522 = total512/stiff;
                const double left252 = -stiff*total522 + total512;
                const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                const double left272 = left262 + low32;
                const double lost522 = left272/stiff;
                fall_of = lost53 + total53;
                rise_of = lost522 + total522;
                swing_of = 2.0*lost212 + 2.0*total212;
            } else {
                double odd;
                double odd_low2;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double sin_series_of = sin_series(given3);
                    const double bent = given3*sin_series_of;
                    const double total22 = bent + 1.0;
                    const double back15 = total22 - 1.0;
                    const double lost22 = -back15 + bent;
                    const double odd_low = 0.16666666666666666*lost2 + lost22;
                    odd = total22;
                    odd_low2 = odd_low;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double sine = sin(root);
                    const double cosine = cos(root);
                    const double some = root;
                    const double total23 = sine/some;
                    const double left13 = sine - some*total23;
                    const double left14 = left13 - fma(total23, some, -(total23*some));
                    const double left15 = cosine*root_low + left14 - root_low*total23;
                    const double lost23 = left15/some;
                    odd = total23;
                    odd_low2 = lost23;
                }
                const double total24 = half*odd;
                const double lost24 = half*odd_low2 + fma(half, odd, -(half*odd));
                const double total25 = -even + total24;
                const double back16 = -total24 + total25;
                const double rest4 = -back16 + total25;
                const double one3 = -rest4 + total24;
                const double two3 = -back16 - even;
                const double lost25 = one3 + two3;
                const double total26 = envelope + total25;
                const double back17 = -total25 + total26;
                const double rest5 = -back17 + total26;
                const double one4 = -rest5 + total25;
                const double two4 = -back17 + envelope;
                const double lost26 = one4 + two4;
                const double total27 = envelope*total26;
                const double lost27 = envelope*(-even_low2 + lost24 + lost25 + lost26) +
                    fma(envelope, total26, -(envelope*total26));
                const double total28 = total27/stiff;
                const double left16 = -stiff*total28 + total27;
                const double left17 = left16 - fma(total28, stiff, -(total28*stiff));
                const double left18 = left17 + lost27;
                const double lost28 = left18/stiff;
                const double total242 = even + total24;
                const double back162 = -even + total242;
                const double rest42 = -back162 + total242;
                const double one32 = even - rest42;
                const double two32 = -back162 + total24;
                const double lost242 = one32 + two32;
                const double total252 = envelope*total242;
                const double lost252 = envelope*(even_low2 + lost24 + lost242) +
                    fma(envelope, total242, -(envelope*total242));
                const double total262 = 1.0 - total252;
                const double back172 = total262 - 1.0;
                const double lost262 = -back172 - total252;
                const double total272 = total262/stiff;
                const double left162 = -stiff*total272 + total262;
                const double left172 = left162 - fma(total272, stiff, -(total272*stiff));
                const double left182 = left172 - lost252 + lost262;
                const double lost272 = left182/stiff;
                fall_of = lost28 + total28;
                rise_of = lost272 + total272;
                swing_of = 2.0*lost212 + 2.0*total212;
            }
        }
    } else {
        const double size = fabs(total2);
        const double root = sqrt(size);
        const double total3 = half + root;
        const double reach = 0.4444444444444444*total3;
        if (reach < 0.5625) {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            const double given5 = 0.5*half;
            const double total54 = 1.0 - 0.5*given5;
            const double back32 = total54 - 1.0;
            const double lost54 = -back32 - 0.5*given5;
            const double decay_series_of4 = decay_series(given5);
            const double curved5 = decay_series_of4*(given5*given5);
            const double total55 = curved5 + total54;
            const double back33 = -total54 + total55;
            const double lost55 = -back33 + curved5;
            const double mean_low6 = lost54 + lost55;
            const double total56 = given5*total55;
            const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
            const double total57 = 1.0 - total56;
            const double back34 = total57 - 1.0;
            const double lost57 = -back34 - total56;
            const double fall_low6 = -lost56 + lost57;
            const double total58 = (total57*total57);
            const double lost58 = 2.0*fall_low6*total57 + fma(total57, total57, -(total57*total57));
            const double total59 = (total58*total58);
            const double lost59 = 2.0*lost58*total58 + fma(total58, total58, -(total58*total58));
            const double rest15 = fall_series(gamma, delta);
            const double total60 = rest15 + 0.5;
            const double back35 = -rest15 + total60;
            const double rest16 = -back35 + total60;
            const double one14 = rest15 - rest16;
            const double two14 = 0.5 - back35;
            const double lost60 = one14 + two14;
            const double total61 = total59*total60;
            const double lost61 = lost60*total59 + fma(total59, total60, -(total59*total60));
            const double half2 = half;
            const double given52 = 0.5*half2;
            const double total532 = 1.0 - 0.5*given52;
            const double back312 = total532 - 1.0;
            const double lost532 = -back312 - 0.5*given52;
            const double decay_series_of5 = decay_series(given52);
            const double curved52 = decay_series_of5*(given52*given52);
            const double total542 = curved52 + total532;
            const double back322 = -total532 + total542;
            const double lost542 = -back322 + curved52;
            const double mean_low62 = lost532 + lost542;
            const double total552 = given52*total542;
            const double lost552 = given52*mean_low62 + fma(given52, total542, -(given52*total542));
            const double total562 = 1.0 - total552;
            const double back332 = total562 - 1.0;
            const double lost562 = -back332 - total552;
            const double fall_low62 = -lost552 + lost562;
            const double total572 = (total562*total562);
            const double lost572 = 2.0*fall_low62*total562 +
                fma(total562, total562, -(total562*total562));
            const double rest132 = rise_series(half2, total2);
            const double total582 = rest132 + 0.5;
            const double back342 = -rest132 + total582;
            const double rest142 = -back342 + total582;
            const double one122 = rest132 - rest142;
            const double two122 = 0.5 - back342;
            const double lost582 = one122 + two122;
            const double total592 = total572*total582;
            const double lost592 = lost582*total572 + fma(total572, total582, -(total572*total582));
            double fall_;
            double fall_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                fall_ = sunk;
                fall_low2 = sunk_low;
            }
            double fall2;
            double fall_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const double total222 = fall2 + 1.0;
            const double back152 = total222 - 1.0;
            const double lost222 = -back152 + fall2;
            const double total232 = fall_*total222;
            const double lost232 = fall_*(fall_low4 + lost222) +
                fma(fall_, total222, -(fall_*total222));
            const double creep2 = fall_low2*total222 + lost232 + total232;
            fall_of = lost59*total60 + lost61 + total61;
            rise_of = lost572*total582 + lost592 + total592;
            swing_of = creep2;
        } else {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            double fall_;
            double fall_low2;
            double mean;
            double mean_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                const double total8 = 1.0 - sunk;
                const double back7 = total8 - 1.0;
                const double lost8 = -back7 - sunk;
                const double bottom = q;
                const double total9 = total8/bottom;
                const double left4 = -bottom*total9 + total8;
                const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const double lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            double fall2;
            double fall_low4;
            double mean2;
            double mean_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                const double total14 = 1.0 - sunk2;
                const double back11 = total14 - 1.0;
                const double lost14 = -back11 - sunk2;
                const double bottom2 = 2.0*root;
                const double total15 = total14/bottom2;
                const double left7 = -bottom2*total15 + total14;
                const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                const double lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const double total16 = fall2*mean;
            const double lost16 = fall2*mean_low2 + fma(fall2, mean, -(fall2*mean));
            const double pulled_low = fall_low4*mean + lost16;
            const double total17 = mean2 - total16;
            const double back12 = -mean2 + total17;
            const double rest3 = -back12 + total17;
            const double one2 = mean2 - rest3;
            const double two2 = -back12 - total16;
            const double lost17 = one2 + two2;
            const double total18 = total17/whole2;
            const double left10 = total17 - total18*whole2;
            const double left11 = left10 - fma(total18, whole2, -(total18*whole2));
            const double left12 = left11 + lost17 + mean_low4 - p_low*total18 - pulled_low;
            const double lost18 = left12/whole2;
            const double total19 = fall_*total18;
            const double lost19 = fall_*lost18 + fma(fall_, total18, -(fall_*total18));
            const double creep_ = fall_low2*total18 + lost19 + total19;
            const double total162 = fall_*mean2;
            const double lost162 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
            const double pulled_low2 = fall_low2*mean2 + lost162;
            const double total172 = mean - total162;
            const double back122 = -mean + total172;
            const double rest32 = -back122 + total172;
            const double one22 = mean - rest32;
            const double two22 = -back122 - total162;
            const double lost172 = one22 + two22;
            const double total182 = total172/whole2;
            const double left102 = total172 - total182*whole2;
            const double left112 = left102 - fma(total182, whole2, -(total182*whole2));
            const double left122 = left112 + lost172 + mean_low2 - p_low*total182 - pulled_low2;
            const double lost182 = left122/whole2;
            const double total222 = fall2 + 1.0;
            const double back152 = total222 - 1.0;
            const double lost222 = -back152 + fall2;
            const double total232 = fall_*total222;
            const double lost232 = fall_*(fall_low4 + lost222) +
                fma(fall_, total222, -(fall_*total222));
            const double creep2 = fall_low2*total222 + lost232 + total232;
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
static double fall(double gamma, double delta) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 0.5625) {
            const double given5 = 0.5*half;
            const double total54 = 1.0 - 0.5*given5;
            const double back32 = total54 - 1.0;
            const double lost54 = -back32 - 0.5*given5;
            const double curved5 = (given5*given5)*decay_series(given5);
            const double total55 = curved5 + total54;
            const double back33 = -total54 + total55;
            const double lost55 = -back33 + curved5;
            const double mean_low6 = lost54 + lost55;
            const double total56 = given5*total55;
            const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
            const double total57 = 1.0 - total56;
            const double back34 = total57 - 1.0;
            const double lost57 = -back34 - total56;
            const double fall_low6 = -lost56 + lost57;
            const double total58 = (total57*total57);
            const double lost58 = 2.0*fall_low6*total57 + fma(total57, total57, -(total57*total57));
            const double total59 = (total58*total58);
            const double lost59 = 2.0*lost58*total58 + fma(total58, total58, -(total58*total58));
            const double rest15 = fall_series(gamma, delta);
            const double total60 = rest15 + 0.5;
            const double back35 = -rest15 + total60;
            const double rest16 = -back35 + total60;
            const double one14 = rest15 - rest16;
            const double two14 = 0.5 - back35;
            const double lost60 = one14 + two14;
            const double envelope2 = total59;
            const double total61 = envelope2*total60;
            const double lost61 = envelope2*lost60 + fma(envelope2, total60, -(envelope2*total60));
            return lost59*total60 + lost61 + total61;
        }
        const double back2 = -total + total2;
        const double lost2 = -back2 + rest2;
        const double size = fabs(total2);
        const double root = sqrt(size);
        double count;
        if (root < 67108864.0) {
            count = floor(0.5*root/3.141592653589793 + 0.5);
        } else {
            count = 0.0;
        }
        const double turns = (count*count);
        const double total29 = 39.47841760435743*turns;
        const double lost29 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
        const double total30 = 2.5061182034958845e-15*turns;
        const double lost30 = fma(turns, 2.5061182034958845e-15, -(turns*2.5061182034958845e-15));
        const double total31 = -total2 - total29;
        const double back18 = total2 + total31;
        const double rest6 = -back18 + total31;
        const double one5 = -rest6 - total2;
        const double two5 = -back18 - total29;
        const double lost31 = one5 + two5;
        const double total32 = -lost29 + total31;
        const double back19 = -total31 + total32;
        const double rest7 = -back19 + total32;
        const double one6 = -rest7 + total31;
        const double two6 = -back19 - lost29;
        const double lost32 = one6 + two6;
        const double total33 = -total30 + total32;
        const double back20 = -total32 + total33;
        const double rest8 = -back20 + total33;
        const double one7 = -rest8 + total32;
        const double two7 = -back20 - total30;
        const double lost33 = one7 + two7;
        const double total34 = -lost2 + total33;
        const double back21 = -total33 + total34;
        const double rest9 = -back21 + total34;
        const double one8 = -rest9 + total33;
        const double two8 = -back21 - lost2;
        const double lost34 = one8 + two8;
        const double low = -lost30 + lost31 + lost32 + lost33 + lost34 - 1.4920070805839235e-31*
            turns;
        const double total35 = low + total34;
        const double total36 = 6.283185307179586*count;
        const double total37 = root + total36;
        const double whole3 = (total37 == 0.0 ? 1.0 : total37);
        const double total38 = total35/whole3;
        const double far = (total38*total38);
        if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
            const double sign_low = -lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double stiff = gamma;
            const double back22 = -total34 + total35;
            const double rest10 = -back22 + total35;
            const double one9 = -rest10 + total34;
            const double two9 = -back22 + low;
            const double lost35 = one9 + two9;
            const double lost36 = fma(count, 6.283185307179586, -(count*6.283185307179586));
            const double back23 = -root + total37;
            const double rest11 = -back23 + total37;
            const double one10 = -rest11 + root;
            const double two10 = -back23 + total36;
            const double lost37 = one10 + two10;
            const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low;
            const double left19 = total35 - total38*whole3;
            const double left20 = left19 - fma(total38, whole3, -(total38*whole3));
            const double left21 = -both_low*total38 + left20 + lost35;
            const double lost38 = left21/whole3;
            const double eta = total38;
            const double eta_low = lost38;
            const double total39 = (eta*eta);
            const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
            const double bent2 = (total39*total39)*cos_series(-total39);
            const double total40 = -bent2 + 0.5*total39;
            const double back24 = -0.5*total39 + total40;
            const double lost40 = -back24 - bent2;
            const double total41 = -total39*sin_series(-total39) + 1.0;
            const double back25 = total41 - 1.0;
            const double lost41 = -back25 - total39*sin_series(-total39);
            const double lift_low = 0.5*lost39*total41 + lost40;
            const double total42 = eta*total41;
            const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
            const double some2 = root;
            const double total43 = total42/some2;
            const double left22 = -some2*total43 + total42;
            const double left23 = left22 - fma(total43, some2, -(total43*some2));
            const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*total43;
            const double lost43 = left24/some2;
            const double given4 = half;
            const double total44 = 1.0 - 0.5*given4;
            const double back26 = total44 - 1.0;
            const double lost44 = -back26 - 0.5*given4;
            const double curved4 = (given4*given4)*decay_series(given4);
            const double total45 = curved4 + total44;
            const double back27 = -total44 + total45;
            const double lost45 = -back27 + curved4;
            const double mean_low5 = lost44 + lost45;
            const double total46 = given4*total45;
            const double lost46 = given4*mean_low5 + fma(given4, total45, -(given4*total45));
            const double total47 = 1.0 - total46;
            const double back28 = total47 - 1.0;
            const double lost47 = -back28 - total46;
            const double fall_low5 = -lost46 + lost47;
            const double total48 = -total43 + total45;
            const double back29 = -total45 + total48;
            const double rest12 = -back29 + total48;
            const double one11 = -rest12 + total45;
            const double two11 = -back29 - total43;
            const double lost48 = one11 + two11;
            const double total49 = given4*total48;
            const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                fma(given4, total48, -(given4*total48));
            const double total50 = total40 - total49;
            const double back30 = -total40 + total50;
            const double rest13 = -back30 + total50;
            const double one12 = -rest13 + total40;
            const double two12 = -back30 - total49;
            const double lost50 = one12 + two12;
            const double low2 = lift_low - lost49 + lost50;
            const double total51 = low2 + total50;
            const double back31 = -total50 + total51;
            const double rest14 = -back31 + total51;
            const double one13 = -rest14 + total50;
            const double two13 = -back31 + low2;
            const double lost51 = one13 + two13;
            const double total52 = total47*total51;
            const double lost52 = lost51*total47 + fma(total47, total51, -(total47*total51));
            const double low3 = fall_low5*total51 + lost52;
            const double total53 = total52/stiff;
            const double left25 = -stiff*total53 + total52;
            const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
            const double left27 = left26 + low3;
            const double lost53 = left27/stiff;
            return lost53 + total53;
        }
        const double square2 = total2;
        const double envelope = exp(-half);
        const double stiff = gamma;
        double even;
        double even_low2;
        double odd;
        double odd_low2;
        if (square2 > -1.5) {
            const double given3 = square2;
            const double total20 = 0.5*given3 + 1.0;
            const double back13 = total20 - 1.0;
            const double lost20 = -back13 + 0.5*given3;
            const double curved3 = (given3*given3)*cos_series(given3);
            const double total21 = curved3 + total20;
            const double back14 = -total20 + total21;
            const double lost21 = -back14 + curved3;
            const double even_low = 0.5*lost2 + lost20 + lost21;
            const double bent = given3*sin_series(given3);
            const double total22 = bent + 1.0;
            const double back15 = total22 - 1.0;
            const double lost22 = -back15 + bent;
            const double odd_low = 0.16666666666666666*lost2 + lost22;
            even = total21;
            even_low2 = even_low;
            odd = total22;
            odd_low2 = odd_low;
        } else {
            const double sign_low = -lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double sine = sin(root);
            const double cosine = cos(root);
            const double some = root;
            const double total23 = sine/some;
            const double left13 = sine - some*total23;
            const double left14 = left13 - fma(total23, some, -(total23*some));
            const double left15 = cosine*root_low + left14 - root_low*total23;
            const double lost23 = left15/some;
            even = cosine;
            even_low2 = -root_low*sine;
            odd = total23;
            odd_low2 = lost23;
        }
        const double total24 = half*odd;
        const double lost24 = half*odd_low2 + fma(half, odd, -(half*odd));
        const double total25 = -even + total24;
        const double back16 = -total24 + total25;
        const double rest4 = -back16 + total25;
        const double one3 = -rest4 + total24;
        const double two3 = -back16 - even;
        const double lost25 = one3 + two3;
        const double total26 = envelope + total25;
        const double back17 = -total25 + total26;
        const double rest5 = -back17 + total26;
        const double one4 = -rest5 + total25;
        const double two4 = -back17 + envelope;
        const double lost26 = one4 + two4;
        const double total27 = envelope*total26;
        const double lost27 = envelope*(-even_low2 + lost24 + lost25 + lost26) +
            fma(envelope, total26, -(envelope*total26));
        const double total28 = total27/stiff;
        const double left16 = -stiff*total28 + total27;
        const double left17 = left16 - fma(total28, stiff, -(total28*stiff));
        const double left18 = left17 + lost27;
        const double lost28 = left18/stiff;
        return lost28 + total28;
    }
    const double size = fabs(total2);
    const double root = sqrt(size);
    const double total3 = half + root;
    const double reach = 0.4444444444444444*total3;
    if (reach < 0.5625) {
        const double given5 = 0.5*half;
        const double total54 = 1.0 - 0.5*given5;
        const double back32 = total54 - 1.0;
        const double lost54 = -back32 - 0.5*given5;
        const double curved5 = (given5*given5)*decay_series(given5);
        const double total55 = curved5 + total54;
        const double back33 = -total54 + total55;
        const double lost55 = -back33 + curved5;
        const double mean_low6 = lost54 + lost55;
        const double total56 = given5*total55;
        const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
        const double total57 = 1.0 - total56;
        const double back34 = total57 - 1.0;
        const double lost57 = -back34 - total56;
        const double fall_low6 = -lost56 + lost57;
        const double total58 = (total57*total57);
        const double lost58 = 2.0*fall_low6*total57 + fma(total57, total57, -(total57*total57));
        const double total59 = (total58*total58);
        const double lost59 = 2.0*lost58*total58 + fma(total58, total58, -(total58*total58));
        const double rest15 = fall_series(gamma, delta);
        const double total60 = rest15 + 0.5;
        const double back35 = -rest15 + total60;
        const double rest16 = -back35 + total60;
        const double one14 = rest15 - rest16;
        const double two14 = 0.5 - back35;
        const double lost60 = one14 + two14;
        const double envelope2 = total59;
        const double total61 = envelope2*total60;
        const double lost61 = envelope2*lost60 + fma(envelope2, total60, -(envelope2*total60));
        return lost59*total60 + lost61 + total61;
    }
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    const double sign_low = lost2;
    const double left = -(root*root) + size;
    const double left2 = left - fma(root, root, -(root*root));
    const double left3 = left2 + sign_low;
    const double whole = (root == 0.0 ? 1.0 : root);
    const double root_low = 0.5*left3/whole;
    const double back3 = -half + total3;
    const double lost3 = -back3 + root;
    const double p_low = lost3 + root_low;
    const double whole2 = (total3 == 0.0 ? 1.0 : total3);
    const double q = gamma/whole2;
    const double off = gamma - q*whole2;
    const double off2 = off - fma(whole2, q, -(whole2*q));
    const double off3 = off2 - p_low*q;
    const double q_low = off3/whole2;
    const double rate = q;
    const double rate2 = 2.0*root;
    double fall_;
    double fall_low2;
    double mean;
    double mean_low2;
    if (rate < 0.75) {
        const double given = q;
        const double total4 = 1.0 - 0.5*given;
        const double back4 = total4 - 1.0;
        const double lost4 = -back4 - 0.5*given;
        const double curved = (given*given)*decay_series(given);
        const double total5 = curved + total4;
        const double back5 = -total4 + total5;
        const double lost5 = -back5 + curved;
        const double mean_low = lost4 + lost5 - q_low*
            (0.125*(given*given) - 0.3333333333333333*given + 0.5);
        const double total6 = given*total5;
        const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
        const double total7 = 1.0 - total6;
        const double back6 = total7 - 1.0;
        const double lost7 = -back6 - total6;
        const double fall_low = -lost6 + lost7 - q_low*total5;
        fall_ = total7;
        fall_low2 = fall_low;
        mean = total5;
        mean_low2 = mean_low;
    } else {
        const double sunk = exp(-q);
        const double sunk_low = -q_low*sunk;
        const double total8 = 1.0 - sunk;
        const double back7 = total8 - 1.0;
        const double lost8 = -back7 - sunk;
        const double bottom = q;
        const double total9 = total8/bottom;
        const double left4 = -bottom*total9 + total8;
        const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
        const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
        const double lost9 = left6/bottom;
        fall_ = sunk;
        fall_low2 = sunk_low;
        mean = total9;
        mean_low2 = lost9;
    }
    double fall2;
    double fall_low4;
    double mean2;
    double mean_low4;
    if (rate2 < 0.75) {
        const double given2 = 2.0*root;
        const double total10 = 1.0 - 0.5*given2;
        const double back8 = total10 - 1.0;
        const double lost10 = -back8 - 0.5*given2;
        const double curved2 = (given2*given2)*decay_series(given2);
        const double total11 = curved2 + total10;
        const double back9 = -total10 + total11;
        const double lost11 = -back9 + curved2;
        const double mean_low3 = lost10 + lost11 - 2.0*root_low*
            (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
        const double total12 = given2*total11;
        const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
        const double total13 = 1.0 - total12;
        const double back10 = total13 - 1.0;
        const double lost13 = -back10 - total12;
        const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
        fall2 = total13;
        fall_low4 = fall_low3;
        mean2 = total11;
        mean_low4 = mean_low3;
    } else {
        const double sunk2 = exp(-2.0*root);
        const double sunk_low2 = -2.0*root_low*sunk2;
        const double total14 = 1.0 - sunk2;
        const double back11 = total14 - 1.0;
        const double lost14 = -back11 - sunk2;
        const double bottom2 = 2.0*root;
        const double total15 = total14/bottom2;
        const double left7 = -bottom2*total15 + total14;
        const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
        const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
        const double lost15 = left9/bottom2;
        fall2 = sunk2;
        fall_low4 = sunk_low2;
        mean2 = total15;
        mean_low4 = lost15;
    }
    const double total16 = fall2*mean;
    const double lost16 = fall2*mean_low2 + fma(fall2, mean, -(fall2*mean));
    const double pulled_low = fall_low4*mean + lost16;
    const double total17 = mean2 - total16;
    const double back12 = -mean2 + total17;
    const double rest3 = -back12 + total17;
    const double one2 = mean2 - rest3;
    const double two2 = -back12 - total16;
    const double lost17 = one2 + two2;
    const double total18 = total17/whole2;
    const double left10 = total17 - total18*whole2;
    const double left11 = left10 - fma(total18, whole2, -(total18*whole2));
    const double left12 = left11 + lost17 + mean_low4 - p_low*total18 - pulled_low;
    const double lost18 = left12/whole2;
    const double total19 = fall_*total18;
    const double lost19 = fall_*lost18 + fma(fall_, total18, -(fall_*total18));
    const double creep_ = fall_low2*total18 + lost19 + total19;
    return creep_;
}

// n1, how far a unit force moves the device in a period
static double rise(double gamma, double delta) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 0.5625) {
            const double half2 = half;
            const double given5 = 0.5*half2;
            const double total53 = 1.0 - 0.5*given5;
            const double back31 = total53 - 1.0;
            const double lost53 = -back31 - 0.5*given5;
            const double curved5 = (given5*given5)*decay_series(given5);
            const double total54 = curved5 + total53;
            const double back32 = -total53 + total54;
            const double lost54 = -back32 + curved5;
            const double mean_low6 = lost53 + lost54;
            const double total55 = given5*total54;
            const double lost55 = given5*mean_low6 + fma(given5, total54, -(given5*total54));
            const double total56 = 1.0 - total55;
            const double back33 = total56 - 1.0;
            const double lost56 = -back33 - total55;
            const double fall_low6 = -lost55 + lost56;
            const double total57 = (total56*total56);
            const double lost57 = 2.0*fall_low6*total56 + fma(total56, total56, -(total56*total56));
            const double rest13 = rise_series(half2, total2);
            const double total58 = rest13 + 0.5;
            const double back34 = -rest13 + total58;
            const double rest14 = -back34 + total58;
            const double one12 = rest13 - rest14;
            const double two12 = 0.5 - back34;
            const double lost58 = one12 + two12;
            const double envelope2 = total57;
            const double total59 = envelope2*total58;
            const double lost59 = envelope2*lost58 + fma(envelope2, total58, -(envelope2*total58));
            return lost57*total58 + lost59 + total59;
        }
        const double back2 = -total + total2;
        const double lost2 = -back2 + rest2;
        const double size = fabs(total2);
        const double root = sqrt(size);
        double count;
        if (root < 67108864.0) {
            count = floor(0.5*root/3.141592653589793 + 0.5);
        } else {
            count = 0.0;
        }
        const double turns = (count*count);
        const double total28 = 39.47841760435743*turns;
        const double lost28 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
        const double total29 = 2.5061182034958845e-15*turns;
        const double lost29 = fma(turns, 2.5061182034958845e-15, -(turns*2.5061182034958845e-15));
        const double total30 = -total2 - total28;
        const double back18 = total2 + total30;
        const double rest5 = -back18 + total30;
        const double one4 = -rest5 - total2;
        const double two4 = -back18 - total28;
        const double lost30 = one4 + two4;
        const double total31 = -lost28 + total30;
        const double back19 = -total30 + total31;
        const double rest6 = -back19 + total31;
        const double one5 = -rest6 + total30;
        const double two5 = -back19 - lost28;
        const double lost31 = one5 + two5;
        const double total32 = -total29 + total31;
        const double back20 = -total31 + total32;
        const double rest7 = -back20 + total32;
        const double one6 = -rest7 + total31;
        const double two6 = -back20 - total29;
        const double lost32 = one6 + two6;
        const double total33 = -lost2 + total32;
        const double back21 = -total32 + total33;
        const double rest8 = -back21 + total33;
        const double one7 = -rest8 + total32;
        const double two7 = -back21 - lost2;
        const double lost33 = one7 + two7;
        const double low = -lost29 + lost30 + lost31 + lost32 + lost33 - 1.4920070805839235e-31*
            turns;
        const double total34 = low + total33;
        const double total35 = 6.283185307179586*count;
        const double total36 = root + total35;
        const double whole3 = (total36 == 0.0 ? 1.0 : total36);
        const double total37 = total34/whole3;
        const double far = (total37*total37);
        if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
            const double sign_low = -lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double stiff = gamma;
            const double back22 = -total33 + total34;
            const double rest9 = -back22 + total34;
            const double one8 = -rest9 + total33;
            const double two8 = -back22 + low;
            const double lost34 = one8 + two8;
            const double lost35 = fma(count, 6.283185307179586, -(count*6.283185307179586));
            const double back23 = -root + total36;
            const double rest10 = -back23 + total36;
            const double one9 = -rest10 + root;
            const double two9 = -back23 + total35;
            const double lost36 = one9 + two9;
            const double both_low = 2.4492935982947064e-16*count + lost35 + lost36 + root_low;
            const double left19 = total34 - total37*whole3;
            const double left20 = left19 - fma(total37, whole3, -(total37*whole3));
            const double left21 = -both_low*total37 + left20 + lost34;
            const double lost37 = left21/whole3;
            const double eta = total37;
            const double eta_low = lost37;
            const double total38 = (eta*eta);
            const double lost38 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
            const double bent2 = (total38*total38)*cos_series(-total38);
            const double total39 = -bent2 + 0.5*total38;
            const double back24 = -0.5*total38 + total39;
            const double lost39 = -back24 - bent2;
            const double total40 = -total38*sin_series(-total38) + 1.0;
            const double back25 = total40 - 1.0;
            const double lost40 = -back25 - total38*sin_series(-total38);
            const double lift_low = 0.5*lost38*total40 + lost39;
            const double total41 = eta*total40;
            const double lost41 = eta*lost40 + fma(eta, total40, -(eta*total40));
            const double some2 = root;
            const double total42 = total41/some2;
            const double left22 = -some2*total42 + total41;
            const double left23 = left22 - fma(total42, some2, -(total42*some2));
            const double left24 = eta_low*(1.0 - total39) + left23 + lost41 - root_low*total42;
            const double lost42 = left24/some2;
            const double given4 = half;
            const double total43 = 1.0 - 0.5*given4;
            const double back26 = total43 - 1.0;
            const double lost43 = -back26 - 0.5*given4;
            const double curved4 = (given4*given4)*decay_series(given4);
            const double total44 = curved4 + total43;
            const double back27 = -total43 + total44;
            const double lost44 = -back27 + curved4;
            const double mean_low5 = lost43 + lost44;
            const double total45 = given4*total44;
            const double lost45 = given4*mean_low5 + fma(given4, total44, -(given4*total44));
            const double total46 = 1.0 - total45;
            const double back28 = total46 - 1.0;
            const double lost46 = -back28 - total45;
            const double fall_low5 = -lost45 + lost46;
            const double total47 = total42*total46;
            const double lost47 = lost42*total46 + fma(total46, total42, -(total46*total42));
            const double total48 = total44 - total47;
            const double back29 = -total44 + total48;
            const double rest11 = -back29 + total48;
            const double one10 = -rest11 + total44;
            const double two10 = -back29 - total47;
            const double lost48 = one10 + two10;
            const double low2 = -fall_low5*total42 - lost47 + lost48 + mean_low5;
            const double total49 = given4*total48;
            const double lost49 = given4*low2 + fma(given4, total48, -(given4*total48));
            const double total50 = total39*total46;
            const double lost50 = lift_low*total46 + fma(total46, total39, -(total46*total39));
            const double total51 = total49 + total50;
            const double back30 = -total49 + total51;
            const double rest12 = -back30 + total51;
            const double one11 = -rest12 + total49;
            const double two11 = -back30 + total50;
            const double lost51 = one11 + two11;
            const double low3 = fall_low5*total39 + lost49 + lost50 + lost51;
            const double total52 = total51/stiff;
            const double left25 = -stiff*total52 + total51;
            const double left26 = left25 - fma(total52, stiff, -(total52*stiff));
            const double left27 = left26 + low3;
            const double lost52 = left27/stiff;
            return lost52 + total52;
        }
        const double square2 = total2;
        const double envelope = exp(-half);
        const double stiff = gamma;
        double even;
        double even_low2;
        double odd;
        double odd_low2;
        if (square2 > -1.5) {
            const double given3 = square2;
            const double total19 = 0.5*given3 + 1.0;
            const double back13 = total19 - 1.0;
            const double lost19 = -back13 + 0.5*given3;
            const double curved3 = (given3*given3)*cos_series(given3);
            const double total20 = curved3 + total19;
            const double back14 = -total19 + total20;
            const double lost20 = -back14 + curved3;
            const double even_low = lost19 + 0.5*lost2 + lost20;
            const double bent = given3*sin_series(given3);
            const double total21 = bent + 1.0;
            const double back15 = total21 - 1.0;
            const double lost21 = -back15 + bent;
            const double odd_low = 0.16666666666666666*lost2 + lost21;
            even = total20;
            even_low2 = even_low;
            odd = total21;
            odd_low2 = odd_low;
        } else {
            const double sign_low = -lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double sine = sin(root);
            const double cosine = cos(root);
            const double some = root;
            const double total22 = sine/some;
            const double left13 = sine - some*total22;
            const double left14 = left13 - fma(total22, some, -(total22*some));
            const double left15 = cosine*root_low + left14 - root_low*total22;
            const double lost22 = left15/some;
            even = cosine;
            even_low2 = -root_low*sine;
            odd = total22;
            odd_low2 = lost22;
        }
        const double total23 = half*odd;
        const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
        const double total24 = even + total23;
        const double back16 = -even + total24;
        const double rest4 = -back16 + total24;
        const double one3 = even - rest4;
        const double two3 = -back16 + total23;
        const double lost24 = one3 + two3;
        const double total25 = envelope*total24;
        const double lost25 = envelope*(even_low2 + lost23 + lost24) +
            fma(envelope, total24, -(envelope*total24));
        const double total26 = 1.0 - total25;
        const double back17 = total26 - 1.0;
        const double lost26 = -back17 - total25;
        const double total27 = total26/stiff;
        const double left16 = -stiff*total27 + total26;
        const double left17 = left16 - fma(total27, stiff, -(total27*stiff));
        const double left18 = left17 - lost25 + lost26;
        const double lost27 = left18/stiff;
        return lost27 + total27;
    }
    const double size = fabs(total2);
    const double root = sqrt(size);
    const double total3 = half + root;
    const double reach = 0.4444444444444444*total3;
    if (reach < 0.5625) {
        const double half2 = half;
        const double given5 = 0.5*half2;
        const double total53 = 1.0 - 0.5*given5;
        const double back31 = total53 - 1.0;
        const double lost53 = -back31 - 0.5*given5;
        const double curved5 = (given5*given5)*decay_series(given5);
        const double total54 = curved5 + total53;
        const double back32 = -total53 + total54;
        const double lost54 = -back32 + curved5;
        const double mean_low6 = lost53 + lost54;
        const double total55 = given5*total54;
        const double lost55 = given5*mean_low6 + fma(given5, total54, -(given5*total54));
        const double total56 = 1.0 - total55;
        const double back33 = total56 - 1.0;
        const double lost56 = -back33 - total55;
        const double fall_low6 = -lost55 + lost56;
        const double total57 = (total56*total56);
        const double lost57 = 2.0*fall_low6*total56 + fma(total56, total56, -(total56*total56));
        const double rest13 = rise_series(half2, total2);
        const double total58 = rest13 + 0.5;
        const double back34 = -rest13 + total58;
        const double rest14 = -back34 + total58;
        const double one12 = rest13 - rest14;
        const double two12 = 0.5 - back34;
        const double lost58 = one12 + two12;
        const double envelope2 = total57;
        const double total59 = envelope2*total58;
        const double lost59 = envelope2*lost58 + fma(envelope2, total58, -(envelope2*total58));
        return lost57*total58 + lost59 + total59;
    }
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    const double sign_low = lost2;
    const double left = -(root*root) + size;
    const double left2 = left - fma(root, root, -(root*root));
    const double left3 = left2 + sign_low;
    const double whole = (root == 0.0 ? 1.0 : root);
    const double root_low = 0.5*left3/whole;
    const double back3 = -half + total3;
    const double lost3 = -back3 + root;
    const double p_low = lost3 + root_low;
    const double whole2 = (total3 == 0.0 ? 1.0 : total3);
    const double q = gamma/whole2;
    const double off = gamma - q*whole2;
    const double off2 = off - fma(whole2, q, -(whole2*q));
    const double off3 = off2 - p_low*q;
    const double q_low = off3/whole2;
    const double rate = q;
    const double rate2 = 2.0*root;
    double fall_;
    double fall_low2;
    double mean;
    double mean_low2;
    if (rate < 0.75) {
        const double given = q;
        const double total4 = 1.0 - 0.5*given;
        const double back4 = total4 - 1.0;
        const double lost4 = -back4 - 0.5*given;
        const double curved = (given*given)*decay_series(given);
        const double total5 = curved + total4;
        const double back5 = -total4 + total5;
        const double lost5 = -back5 + curved;
        const double mean_low = lost4 + lost5 - q_low*
            (0.125*(given*given) - 0.3333333333333333*given + 0.5);
        const double total6 = given*total5;
        const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
        const double total7 = 1.0 - total6;
        const double back6 = total7 - 1.0;
        const double lost7 = -back6 - total6;
        const double fall_low = -lost6 + lost7 - q_low*total5;
        fall_ = total7;
        fall_low2 = fall_low;
        mean = total5;
        mean_low2 = mean_low;
    } else {
        const double sunk = exp(-q);
        const double sunk_low = -q_low*sunk;
        const double total8 = 1.0 - sunk;
        const double back7 = total8 - 1.0;
        const double lost8 = -back7 - sunk;
        const double bottom = q;
        const double total9 = total8/bottom;
        const double left4 = -bottom*total9 + total8;
        const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
        const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
        const double lost9 = left6/bottom;
        fall_ = sunk;
        fall_low2 = sunk_low;
        mean = total9;
        mean_low2 = lost9;
    }
    double mean2;
    double mean_low4;
    if (rate2 < 0.75) {
        const double given2 = 2.0*root;
        const double total10 = 1.0 - 0.5*given2;
        const double back8 = total10 - 1.0;
        const double lost10 = -back8 - 0.5*given2;
        const double curved2 = (given2*given2)*decay_series(given2);
        const double total11 = curved2 + total10;
        const double back9 = -total10 + total11;
        const double lost11 = -back9 + curved2;
        const double mean_low3 = lost10 + lost11 - 2.0*root_low*
            (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
        mean2 = total11;
        mean_low4 = mean_low3;
    } else {
        const double sunk2 = exp(-2.0*root);
        const double sunk_low2 = -2.0*root_low*sunk2;
        const double total14 = 1.0 - sunk2;
        const double back11 = total14 - 1.0;
        const double lost14 = -back11 - sunk2;
        const double bottom2 = 2.0*root;
        const double total15 = total14/bottom2;
        const double left7 = -bottom2*total15 + total14;
        const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
        const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
        const double lost15 = left9/bottom2;
        mean2 = total15;
        mean_low4 = lost15;
    }
    const double total16 = fall_*mean2;
    const double lost16 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
    const double pulled_low = fall_low2*mean2 + lost16;
    const double total17 = mean - total16;
    const double back12 = -mean + total17;
    const double rest3 = -back12 + total17;
    const double one2 = mean - rest3;
    const double two2 = -back12 - total16;
    const double lost17 = one2 + two2;
    const double total18 = total17/whole2;
    const double left10 = total17 - total18*whole2;
    const double left11 = left10 - fma(total18, whole2, -(total18*whole2));
    const double left12 = left11 + lost17 + mean_low2 - p_low*total18 - pulled_low;
    const double lost18 = left12/whole2;
    return lost18 + total18;
}

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static double together_series(double h, double w) {
    if ((fabs(w) < 0.00390625) && (h < 0.0625)) {
        const double y = (h*h);
        const double e5 = 2.08767569878681e-09;
        const double b5 = e5;
        const double e4 = e5*w + 2.755731922398589e-07;
        const double b4 = b5*y + e4;
        const double e3 = e4*w + 2.48015873015873e-05;
        const double b3 = b4*y + e3;
        const double e2 = e3*w + 0.001388888888888889;
        const double b2 = b3*y + e2;
        const double e1 = e2*w + 0.041666666666666664;
        const double b1 = b2*y + e1;
        const double e0 = e1*w;
        const double b0 = b1*y + e0;
        return b0;
    }
    const double y2 = (h*h);
    const double e13 = 3.279889237069838e-30;
    const double b13 = e13;
    const double e12 = e13*w + 2.4795962632247976e-27;
    const double b12 = b13*y2 + e12;
    const double e11 = e12*w + 1.6117375710961184e-24;
    const double b11 = b12*y2 + e11;
    const double e10 = e11*w + 8.896791392450574e-22;
    const double b10 = b11*y2 + e10;
    const double e9 = e10*w + 4.110317623312165e-19;
    const double b9 = b10*y2 + e9;
    const double e8 = e9*w + 1.5619206968586225e-16;
    const double b8 = b9*y2 + e8;
    const double e7 = e8*w + 4.779477332387385e-14;
    const double b7 = b8*y2 + e7;
    const double e6 = e7*w + 1.1470745597729725e-11;
    const double b6 = b7*y2 + e6;
    const double e52 = e6*w + 2.08767569878681e-09;
    const double b52 = b6*y2 + e52;
    const double e42 = e52*w + 2.755731922398589e-07;
    const double b42 = b52*y2 + e42;
    const double e32 = e42*w + 2.48015873015873e-05;
    const double b32 = b42*y2 + e32;
    const double e22 = e32*w + 0.001388888888888889;
    const double b22 = b32*y2 + e22;
    const double e14 = e22*w + 0.041666666666666664;
    const double b14 = b22*y2 + e14;
    const double e02 = e14*w;
    const double b02 = b14*y2 + e02;
    return b02;
}

// a, the sum of the sampled device's poles; n1 + n0
static void swing_together(double gamma, double delta, double *swing_out, double *together_out) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    double swing_of;
    double together_of;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 1.0) {
            const double square2 = total2;
            const double envelope = exp(-half);
            const double rest12 = together_series(half, total2);
            const double total55 = rest12 + 0.5;
            const double back33 = -rest12 + total55;
            const double rest13 = -back33 + total55;
            const double one11 = rest12 - rest13;
            const double two11 = 0.5 - back33;
            const double lost55 = one11 + two11;
            const double total56 = envelope*total55;
            const double lost56 = envelope*lost55 + fma(envelope, total55, -(envelope*total55));
            double even;
            double even_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total16 = 0.5*given3 + 1.0;
                const double back12 = total16 - 1.0;
                const double lost16 = -back12 + 0.5*given3;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total17 = curved3 + total16;
                const double back13 = -total16 + total17;
                const double lost17 = -back13 + curved3;
                const double even_low = lost16 + lost17 + 0.5*lost2;
                even = total17;
                even_low2 = even_low;
            } else {
                const double size = fabs(total2);
                const double root = sqrt(size);
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const double total21 = envelope*even;
            const double lost21 = envelope*even_low2 + fma(envelope, even, -(envelope*even));
            swing_of = 2.0*lost21 + 2.0*total21;
            together_of = 2.0*lost56 + 2.0*total56;
        } else {
            const double size = fabs(total2);
            const double root = sqrt(size);
            const double square2 = total2;
            const double envelope = exp(-half);
            const double stiff = gamma;
            double even;
            double even_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total16 = 0.5*given3 + 1.0;
                const double back12 = total16 - 1.0;
                const double lost16 = -back12 + 0.5*given3;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total17 = curved3 + total16;
                const double back13 = -total16 + total17;
                const double lost17 = -back13 + curved3;
                const double even_low = lost16 + lost17 + 0.5*lost2;
                even = total17;
                even_low2 = even_low;
            } else {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                even = cosine;
                even_low2 = -root_low*sine;
            }
            const double total21 = envelope*even;
            const double lost21 = envelope*even_low2 + fma(envelope, even, -(envelope*even));
            double count;
            if (root < 67108864.0) {
                count = floor(0.5*root/3.141592653589793 + 0.5);
            } else {
                count = 0.0;
            }
            const double turns = (count*count);
            const double total142 = 39.47841760435743*turns;
            const double lost142 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
            const double total152 = 2.5061182034958845e-15*turns;
            const double lost152 = fma(turns, 2.5061182034958845e-15,
                -(turns*2.5061182034958845e-15));
            const double total162 = -total142 - total2;
            const double back102 = total162 + total2;
            const double rest5 = -back102 + total162;
            const double one4 = -rest5 - total2;
            const double two4 = -back102 - total142;
            const double lost162 = one4 + two4;
            const double total172 = -lost142 + total162;
            const double back112 = -total162 + total172;
            const double rest6 = -back112 + total172;
            const double one5 = -rest6 + total162;
            const double two5 = -back112 - lost142;
            const double lost172 = one5 + two5;
            const double total182 = -total152 + total172;
            const double back122 = -total172 + total182;
            const double rest7 = -back122 + total182;
            const double one6 = -rest7 + total172;
            const double two6 = -back122 - total152;
            const double lost182 = one6 + two6;
            const double total192 = -lost2 + total182;
            const double back132 = -total182 + total192;
            const double rest8 = -back132 + total192;
            const double one7 = -rest8 + total182;
            const double two7 = -back132 - lost2;
            const double lost192 = one7 + two7;
            const double low3 = -lost152 + lost162 + lost172 + lost182 + lost192 -
                1.4920070805839235e-31*turns;
            const double total202 = low3 + total192;
            const double total212 = 6.283185307179586*count;
            const double total222 = root + total212;
            const double whole3 = (total222 == 0.0 ? 1.0 : total222);
            const double total232 = total202/whole3;
            const double far = (total232*total232);
            if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back142 = -total192 + total202;
                const double rest9 = -back142 + total202;
                const double one8 = -rest9 + total192;
                const double two8 = -back142 + low3;
                const double lost202 = one8 + two8;
                const double lost212 = fma(count, 6.283185307179586, -(count*6.283185307179586));
                const double back152 = -root + total222;
                const double rest10 = -back152 + total222;
                const double one9 = -rest10 + root;
                const double two9 = -back152 + total212;
                const double lost222 = one9 + two9;
                const double both_low = 2.4492935982947064e-16*count + lost212 + lost222 + root_low;
                const double left102 = total202 - total232*whole3;
                const double left112 = left102 - fma(total232, whole3, -(total232*whole3));
                const double left122 = -both_low*total232 + left112 + lost202;
                const double lost232 = left122/whole3;
                const double eta = total232;
                const double eta_low = lost232;
                const double total24 = (eta*eta);
                const double lost24 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                const double cos_series_of2 = cos_series(-total24);
                const double bent2 = cos_series_of2*(total24*total24);
                const double total25 = -bent2 + 0.5*total24;
                const double back16 = -0.5*total24 + total25;
                const double lost25 = -back16 - bent2;
                const double sin_series_of2 = sin_series(-total24);
                const double total26 = -sin_series_of2*total24 + 1.0;
                const double lift_low = 0.5*lost24*total26 + lost25;
                const double given22 = half;
                const double total29 = 1.0 - 0.5*given22;
                const double back18 = total29 - 1.0;
                const double lost29 = -back18 - 0.5*given22;
                const double decay_series_of3 = decay_series(given22);
                const double curved22 = decay_series_of3*(given22*given22);
                const double total30 = curved22 + total29;
                const double back19 = -total29 + total30;
                const double lost30 = -back19 + curved22;
                const double mean_low5 = lost29 + lost30;
                const double total31 = given22*total30;
                const double lost31 = given22*mean_low5 + fma(given22, total30, -(given22*total30));
                const double total32 = 1.0 - total31;
                const double back20 = total32 - 1.0;
                const double lost32 = -back20 - total31;
                const double fall_low5 = -lost31 + lost32;
                const double total33 = 1.0 - total32;
                const double back21 = total33 - 1.0;
                const double lost33 = -back21 - total32;
                const double low4 = -fall_low5 + lost33;
                const double total34 = low4 + total33;
                const double back22 = -total33 + total34;
                const double lost34 = -back22 + low4;
                const double total35 = (total34*total34);
                const double lost35 = 2.0*lost34*total34 +
                    fma(total34, total34, -(total34*total34));
                const double total36 = total25*total32;
                const double lost36 = lift_low*total32 + fma(total32, total25, -(total32*total25));
                const double total37 = total35 + 2.0*total36;
                const double back23 = -total35 + total37;
                const double rest11 = -back23 + total37;
                const double one10 = -rest11 + total35;
                const double two10 = -back23 + 2.0*total36;
                const double lost37 = one10 + two10;
                const double low5 = 2.0*fall_low5*total25 + lost35 + 2.0*lost36 + lost37;
                const double total38 = total37/stiff;
                const double left16 = -stiff*total38 + total37;
                const double left17 = left16 - fma(total38, stiff, -(total38*stiff));
                const double left18 = left17 + low5;
                const double lost38 = left18/stiff;
                swing_of = 2.0*lost21 + 2.0*total21;
                together_of = lost38 + total38;
            } else {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double expm1_of = expm1(-half);
                const double grown = -0.5*expm1_of;
                const double angle = 0.5*root;
                const double wave = sin(angle);
                const double cos_of = cos(angle);
                const double back72 = -0.5*cos_of*root_low;
                const double total92 = -back72 + wave;
                const double back82 = total92 - wave;
                const double rest3 = -back82 + total92;
                const double one2 = -rest3 + wave;
                const double two2 = -back72 - back82;
                const double lost92 = one2 + two2;
                const double total102 = (total92*total92);
                const double lost102 = fma(total92, total92, -(total92*total92));
                const double low = lost102 + 2.0*lost92*total92;
                const double total112 = envelope*total102;
                const double lost112 = envelope*low + fma(envelope, total102, -(envelope*total102));
                const double total122 = (grown*grown) + total112;
                const double back92 = -total112 + total122;
                const double rest4 = -back92 + total122;
                const double one3 = -rest4 + total112;
                const double two3 = -back92 + (grown*grown);
                const double lost122 = one3 + two3;
                const double low2 = lost112 + lost122;
                const double total132 = total122/stiff;
                const double left72 = -stiff*total132 + total122;
                const double left82 = left72 - fma(total132, stiff, -(total132*stiff));
                const double left92 = left82 + low2;
                const double lost132 = left92/stiff;
                swing_of = 2.0*lost21 + 2.0*total21;
                together_of = 4.0*lost132 + 4.0*total132;
            }
        }
    } else {
        const double size = fabs(total2);
        const double root = sqrt(size);
        const double total3 = half + root;
        const double reach = 0.4444444444444444*total3;
        if (reach < 1.0) {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            const double envelope = exp(-half);
            const double rest12 = together_series(half, total2);
            const double total55 = rest12 + 0.5;
            const double back33 = -rest12 + total55;
            const double rest13 = -back33 + total55;
            const double one11 = rest12 - rest13;
            const double two11 = 0.5 - back33;
            const double lost55 = one11 + two11;
            const double total56 = envelope*total55;
            const double lost56 = envelope*lost55 + fma(envelope, total55, -(envelope*total55));
            double fall_;
            double fall_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                fall_ = sunk;
                fall_low2 = sunk_low;
            }
            double fall2;
            double fall_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const double total22 = fall2 + 1.0;
            const double back15 = total22 - 1.0;
            const double lost22 = -back15 + fall2;
            const double total23 = fall_*total22;
            const double lost23 = fall_*(fall_low4 + lost22) +
                fma(fall_, total22, -(fall_*total22));
            const double creep_ = fall_low2*total22 + lost23 + total23;
            swing_of = creep_;
            together_of = 2.0*lost56 + 2.0*total56;
        } else {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            double fall_;
            double fall_low2;
            double mean;
            double mean_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                const double total8 = 1.0 - sunk;
                const double back7 = total8 - 1.0;
                const double lost8 = -back7 - sunk;
                const double bottom = q;
                const double total9 = total8/bottom;
                const double left4 = -bottom*total9 + total8;
                const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const double lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            double fall2;
            double fall_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const double total22 = fall2 + 1.0;
            const double back15 = total22 - 1.0;
            const double lost22 = -back15 + fall2;
            const double total23 = fall_*total22;
            const double lost23 = fall_*(fall_low4 + lost22) +
                fma(fall_, total22, -(fall_*total22));
            const double creep_ = fall_low2*total22 + lost23 + total23;
            const double total51 = fall_*fall2;
            const double lost51 = fall_*fall_low4 + fma(fall_, fall2, -(fall_*fall2));
            const double low6 = fall2*fall_low2 + lost51;
            const double total52 = 1.0 - total51;
            const double back32 = total52 - 1.0;
            const double lost52 = -back32 - total51;
            const double total53 = mean*total52;
            const double lost53 = mean*(lost52 - low6) + fma(mean, total52, -(mean*total52));
            const double moved_low = lost53 + mean_low2*total52;
            const double total54 = total53/whole2;
            const double left25 = total53 - total54*whole2;
            const double left26 = left25 - fma(total54, whole2, -(total54*whole2));
            const double left27 = left26 + moved_low - p_low*total54;
            const double lost54 = left27/whole2;
            swing_of = creep_;
            together_of = lost54 + total54;
        }
    }
    *swing_out = swing_of;
    *together_out = together_of;
    return;
}

// divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6
static double apart_series(double h, double w) {
    if ((fabs(w) < 0.00390625) && (h < 0.0625)) {
        const double y = (h*h);
        const double e5 = 1.6059043836821613e-10;
        const double b5 = e5;
        const double e4 = e5*w + 2.505210838544172e-08;
        const double b4 = b5*y + e4;
        const double e3 = e4*w + 2.7557319223985893e-06;
        const double b3 = b4*y + e3;
        const double e2 = e3*w + 0.0001984126984126984;
        const double b2 = b3*y + e2;
        const double e1 = e2*w + 0.008333333333333333;
        const double b1 = b2*y + e1;
        const double e0 = e1*w;
        const double b0 = b1*y + e0;
        return b0 + 9.25185853854297e-18;
    }
    const double y2 = (h*h);
    const double e12 = 9.183689863795546e-29;
    const double b12 = e12;
    const double e11 = e12*w + 6.446950284384474e-26;
    const double b11 = b12*y2 + e11;
    const double e10 = e11*w + 3.868170170630684e-23;
    const double b10 = b11*y2 + e10;
    const double e9 = e10*w + 1.9572941063391263e-20;
    const double b9 = b10*y2 + e9;
    const double e8 = e9*w + 8.22063524662433e-18;
    const double b8 = b9*y2 + e8;
    const double e7 = e8*w + 2.8114572543455206e-15;
    const double b7 = b8*y2 + e7;
    const double e6 = e7*w + 7.647163731819816e-13;
    const double b6 = b7*y2 + e6;
    const double e52 = e6*w + 1.6059043836821613e-10;
    const double b52 = b6*y2 + e52;
    const double e42 = e52*w + 2.505210838544172e-08;
    const double b42 = b52*y2 + e42;
    const double e32 = e42*w + 2.7557319223985893e-06;
    const double b32 = b42*y2 + e32;
    const double e22 = e32*w + 0.0001984126984126984;
    const double b22 = b32*y2 + e22;
    const double e13 = e22*w + 0.008333333333333333;
    const double b13 = b22*y2 + e13;
    const double e02 = e13*w;
    const double b02 = b13*y2 + e02;
    return b02 + 9.25185853854297e-18;
}

// (1 - exp(-x))/x
static double decay(double x) {
    if (x == 0.0) {
        return 1.0;
    }
    const double whole = x;
    return -expm1(-x)/whole;
}

// (n1 - n0)/delta; n0, the same device with its time reversed, times exp(-delta); displacement by a
// unit impulse after a period; what the last rounding of Kick takes; n1, how far a unit force moves
// the device in a period
static void apart_fall_kick_kick_low_rise(double gamma, double delta, double *apart_out,
    double *fall_out, double *kick_out, double *kick_low_out, double *rise_out) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    double apart_of;
    double fall_of;
    double kick_of;
    double kick_low_of;
    double rise_of;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 1.0) {
            if (reach < 0.5625) {
                const double square2 = total2;
                const double envelope = exp(-half);
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                const double given5 = 0.5*half;
                const double total54 = 1.0 - 0.5*given5;
                const double back32 = total54 - 1.0;
                const double lost54 = -back32 - 0.5*given5;
                const double decay_series_of4 = decay_series(given5);
                const double curved5 = decay_series_of4*(given5*given5);
                const double total55 = curved5 + total54;
                const double back33 = -total54 + total55;
                const double lost55 = -back33 + curved5;
                const double mean_low6 = lost54 + lost55;
                const double total56 = given5*total55;
                const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
                const double total57 = 1.0 - total56;
                const double back34 = total57 - 1.0;
                const double lost57 = -back34 - total56;
                const double fall_low6 = -lost56 + lost57;
                const double total58 = (total57*total57);
                const double lost58 = 2.0*fall_low6*total57 +
                    fma(total57, total57, -(total57*total57));
                const double total59 = (total58*total58);
                const double lost59 = 2.0*lost58*total58 +
                    fma(total58, total58, -(total58*total58));
                const double rest15 = fall_series(gamma, delta);
                const double total60 = rest15 + 0.5;
                const double back35 = -rest15 + total60;
                const double rest16 = -back35 + total60;
                const double one14 = rest15 - rest16;
                const double two14 = 0.5 - back35;
                const double lost60 = one14 + two14;
                const double total61 = total59*total60;
                const double lost61 = lost60*total59 + fma(total59, total60, -(total59*total60));
                const double half2 = half;
                const double given52 = 0.5*half2;
                const double total532 = 1.0 - 0.5*given52;
                const double back312 = total532 - 1.0;
                const double lost532 = -back312 - 0.5*given52;
                const double decay_series_of5 = decay_series(given52);
                const double curved52 = decay_series_of5*(given52*given52);
                const double total542 = curved52 + total532;
                const double back322 = -total532 + total542;
                const double lost542 = -back322 + curved52;
                const double mean_low62 = lost532 + lost542;
                const double total552 = given52*total542;
                const double lost552 = given52*mean_low62 +
                    fma(given52, total542, -(given52*total542));
                const double total562 = 1.0 - total552;
                const double back332 = total562 - 1.0;
                const double lost562 = -back332 - total552;
                const double fall_low62 = -lost552 + lost562;
                const double total572 = (total562*total562);
                const double lost572 = 2.0*fall_low62*total562 +
                    fma(total562, total562, -(total562*total562));
                const double rest132 = rise_series(half2, total2);
                const double total582 = rest132 + 0.5;
                const double back342 = -rest132 + total582;
                const double rest142 = -back342 + total582;
                const double one122 = rest132 - rest142;
                const double two122 = 0.5 - back342;
                const double lost582 = one122 + two122;
                const double total592 = total572*total582;
                const double lost592 = lost582*total572 +
                    fma(total572, total582, -(total572*total582));
                double odd;
                double odd_low2;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double sin_series_of = sin_series(given3);
                    const double bent = given3*sin_series_of;
                    const double total21 = bent + 1.0;
                    const double back15 = total21 - 1.0;
                    const double lost21 = -back15 + bent;
                    const double odd_low = 0.16666666666666666*lost2 + lost21;
                    odd = total21;
                    odd_low2 = odd_low;
                } else {
                    const double size = fabs(total2);
                    const double root = sqrt(size);
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double sine = sin(root);
                    const double cosine = cos(root);
                    const double some = root;
                    const double total22 = sine/some;
                    const double left10 = sine - some*total22;
                    const double left11 = left10 - fma(total22, some, -(total22*some));
                    const double left12 = cosine*root_low + left11 - root_low*total22;
                    const double lost22 = left12/some;
                    odd = total22;
                    odd_low2 = lost22;
                }
                const double total24 = envelope*odd;
                const double lost24 = envelope*odd_low2 + fma(envelope, odd, -(envelope*odd));
                const double total222 = lost24 + total24;
                const double back152 = total222 - total24;
                const double lost222 = -back152 + lost24;
                apart_of = lost28 + total28;
                fall_of = lost59*total60 + lost61 + total61;
                kick_of = total222;
                kick_low_of = lost222;
                rise_of = lost572*total582 + lost592 + total592;
            } else {
                const double size = fabs(total2);
                const double root = sqrt(size);
                const double square2 = total2;
                const double envelope = exp(-half);
                const double stiff = gamma;
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                double odd;
                double odd_low2;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double sin_series_of = sin_series(given3);
                    const double bent = given3*sin_series_of;
                    const double total21 = bent + 1.0;
                    const double back15 = total21 - 1.0;
                    const double lost21 = -back15 + bent;
                    const double odd_low = 0.16666666666666666*lost2 + lost21;
                    odd = total21;
                    odd_low2 = odd_low;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double sine = sin(root);
                    const double cosine = cos(root);
                    const double some = root;
                    const double total22 = sine/some;
                    const double left10 = sine - some*total22;
                    const double left11 = left10 - fma(total22, some, -(total22*some));
                    const double left12 = cosine*root_low + left11 - root_low*total22;
                    const double lost22 = left12/some;
                    odd = total22;
                    odd_low2 = lost22;
                }
                const double total24 = envelope*odd;
                const double lost24 = envelope*odd_low2 + fma(envelope, odd, -(envelope*odd));
                const double total222 = lost24 + total24;
                const double back152 = total222 - total24;
                const double lost222 = -back152 + lost24;
                double count;
                if (root < 67108864.0) {
                    count = floor(0.5*root/3.141592653589793 + 0.5);
                } else {
                    count = 0.0;
                }
                const double turns = (count*count);
                const double total29 = 39.47841760435743*turns;
                const double lost29 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
                const double total30 = 2.5061182034958845e-15*turns;
                const double lost30 = fma(turns, 2.5061182034958845e-15,
                    -(turns*2.5061182034958845e-15));
                const double total31 = -total2 - total29;
                const double back18 = total2 + total31;
                const double rest62 = -back18 + total31;
                const double one5 = -rest62 - total2;
                const double two5 = -back18 - total29;
                const double lost31 = one5 + two5;
                const double total32 = -lost29 + total31;
                const double back19 = -total31 + total32;
                const double rest7 = -back19 + total32;
                const double one6 = -rest7 + total31;
                const double two6 = -back19 - lost29;
                const double lost32 = one6 + two6;
                const double total33 = -total30 + total32;
                const double back20 = -total32 + total33;
                const double rest8 = -back20 + total33;
                const double one7 = -rest8 + total32;
                const double two7 = -back20 - total30;
                const double lost33 = one7 + two7;
                const double total34 = -lost2 + total33;
                const double back21 = -total33 + total34;
                const double rest9 = -back21 + total34;
                const double one8 = -rest9 + total33;
                const double two8 = -back21 - lost2;
                const double lost34 = one8 + two8;
                const double low2 = -lost30 + lost31 + lost32 + lost33 + lost34 -
                    1.4920070805839235e-31*turns;
                const double total35 = low2 + total34;
                const double total36 = 6.283185307179586*count;
                const double total37 = root + total36;
                const double whole32 = (total37 == 0.0 ? 1.0 : total37);
                const double total38 = total35/whole32;
                const double far = (total38*total38);
                if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double back22 = -total34 + total35;
                    const double rest10 = -back22 + total35;
                    const double one9 = -rest10 + total34;
                    const double two9 = -back22 + low2;
                    const double lost35 = one9 + two9;
                    const double lost36 = fma(count, 6.283185307179586, -(count*6.283185307179586));
                    const double back23 = -root + total37;
                    const double rest11 = -back23 + total37;
                    const double one10 = -rest11 + root;
                    const double two10 = -back23 + total36;
                    const double lost37 = one10 + two10;
                    const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 +
                        root_low;
                    const double left19 = total35 - total38*whole32;
                    const double left20 = left19 - fma(total38, whole32, -(total38*whole32));
                    const double left21 = -both_low*total38 + left20 + lost35;
                    const double lost38 = left21/whole32;
                    const double eta = total38;
                    const double eta_low = lost38;
                    const double total39 = (eta*eta);
                    const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                    const double cos_series_of2 = cos_series(-total39);
                    const double bent2 = cos_series_of2*(total39*total39);
                    const double total40 = -bent2 + 0.5*total39;
                    const double back24 = -0.5*total39 + total40;
                    const double lost40 = -back24 - bent2;
                    const double sin_series_of2 = sin_series(-total39);
                    const double total41 = -sin_series_of2*total39 + 1.0;
                    const double back25 = total41 - 1.0;
                    const double lost41 = -back25 - sin_series_of2*total39;
                    const double lift_low = 0.5*lost39*total41 + lost40;
                    const double total42 = eta*total41;
                    const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                    const double some2 = root;
                    const double total43 = total42/some2;
                    const double left22 = -some2*total43 + total42;
                    const double left23 = left22 - fma(total43, some2, -(total43*some2));
                    const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*
                        total43;
                    const double lost43 = left24/some2;
                    const double given4 = half;
                    const double total44 = 1.0 - 0.5*given4;
                    const double back26 = total44 - 1.0;
                    const double lost44 = -back26 - 0.5*given4;
                    const double decay_series_of3 = decay_series(given4);
                    const double curved4 = decay_series_of3*(given4*given4);
                    const double total45 = curved4 + total44;
                    const double back27 = -total44 + total45;
                    const double lost45 = -back27 + curved4;
                    const double mean_low5 = lost44 + lost45;
                    const double total46 = given4*total45;
                    const double lost46 = given4*mean_low5 +
                        fma(given4, total45, -(given4*total45));
                    const double total47 = 1.0 - total46;
                    const double back28 = total47 - 1.0;
                    const double lost47 = -back28 - total46;
                    const double fall_low5 = -lost46 + lost47;
                    const double total48 = -total43 + total45;
                    const double back29 = -total45 + total48;
                    const double rest12 = -back29 + total48;
                    const double one11 = -rest12 + total45;
                    const double two11 = -back29 - total43;
                    const double lost48 = one11 + two11;
                    const double total49 = given4*total48;
                    const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                        fma(given4, total48, -(given4*total48));
                    const double total50 = total40 - total49;
                    const double back30 = -total40 + total50;
                    const double rest13 = -back30 + total50;
                    const double one12 = -rest13 + total40;
                    const double two12 = -back30 - total49;
                    const double lost50 = one12 + two12;
                    const double low22 = lift_low - lost49 + lost50;
                    const double total51 = low22 + total50;
                    const double back31 = -total50 + total51;
                    const double rest14 = -back31 + total51;
                    const double one13 = -rest14 + total50;
                    const double two13 = -back31 + low22;
                    const double lost51 = one13 + two13;
                    const double total52 = total47*total51;
                    const double lost52 = lost51*total47 +
                        fma(total47, total51, -(total47*total51));
                    const double low3 = fall_low5*total51 + lost52;
                    const double total53 = total52/stiff;
                    const double left25 = -stiff*total53 + total52;
                    const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                    const double left27 = left26 + low3;
                    const double lost53 = left27/stiff;
                    const double total472 = total43*total47;
                    const double lost472 = lost43*total47 +
                        fma(total47, total43, -(total47*total43));
                    const double total482 = total45 - total472;
                    const double back292 = -total45 + total482;
                    const double rest112 = -back292 + total482;
                    const double one102 = -rest112 + total45;
                    const double two102 = -back292 - total472;
                    const double lost482 = one102 + two102;
                    const double low23 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                    const double total492 = given4*total482;
                    const double lost492 = given4*low23 + fma(given4, total482, -(given4*total482));
                    const double total502 = total40*total47;
                    const double lost502 = lift_low*total47 +
                        fma(total47, total40, -(total47*total40));
                    const double total512 = total492 + total502;
                    const double back302 = -total492 + total512;
                    const double rest122 = -back302 + total512;
                    const double one112 = -rest122 + total492;
                    const double two112 = -back302 + total502;
                    const double lost512 = one112 + two112;
                    const double low32 = fall_low5*total40 + lost492 + lost502 + lost512;
                    const double total522 = total512/stiff;
                    const double left252 = -stiff*total522 + total512;
                    const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                    const double left272 = left262 + low32;
                    const double lost522 = left272/stiff;
                    apart_of = lost28 + total28;
                    fall_of = lost53 + total53;
                    kick_of = total222;
                    kick_low_of = lost222;
                    rise_of = lost522 + total522;
                } else {
                    const double total23 = half*odd;
                    const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
                    double even;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even = total20;
                        even_low2 = even_low;
                    } else {
                        const double sign_low = -lost2;
                        const double left = -(root*root) + size;
                        const double left2 = left - fma(root, root, -(root*root));
                        const double left3 = left2 + sign_low;
                        const double whole = (root == 0.0 ? 1.0 : root);
                        const double root_low = 0.5*left3/whole;
                        const double sine = sin(root);
                        const double cosine = cos(root);
                        even = cosine;
                        even_low2 = -root_low*sine;
                    }
                    const double total252 = -even + total23;
                    const double back162 = -total23 + total252;
                    const double rest42 = -back162 + total252;
                    const double one32 = -rest42 + total23;
                    const double two32 = -back162 - even;
                    const double lost252 = one32 + two32;
                    const double total262 = envelope + total252;
                    const double back172 = -total252 + total262;
                    const double rest52 = -back172 + total262;
                    const double one42 = -rest52 + total252;
                    const double two42 = -back172 + envelope;
                    const double lost262 = one42 + two42;
                    const double total272 = envelope*total262;
                    const double lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                        fma(envelope, total262, -(envelope*total262));
                    const double total282 = total272/stiff;
                    const double left16 = -stiff*total282 + total272;
                    const double left17 = left16 - fma(total282, stiff, -(total282*stiff));
                    const double left18 = left17 + lost272;
                    const double lost282 = left18/stiff;
                    const double total242 = even + total23;
                    const double back164 = -even + total242;
                    const double rest43 = -back164 + total242;
                    const double one33 = even - rest43;
                    const double two33 = -back164 + total23;
                    const double lost242 = one33 + two33;
                    const double total253 = envelope*total242;
                    const double lost253 = envelope*(even_low2 + lost23 + lost242) +
                        fma(envelope, total242, -(envelope*total242));
                    const double total263 = 1.0 - total253;
                    const double back173 = total263 - 1.0;
                    const double lost263 = -back173 - total253;
                    const double total273 = total263/stiff;
                    const double left162 = -stiff*total273 + total263;
                    const double left172 = left162 - fma(total273, stiff, -(total273*stiff));
                    const double left182 = left172 - lost253 + lost263;
                    const double lost273 = left182/stiff;
                    apart_of = lost28 + total28;
                    fall_of = lost282 + total282;
                    kick_of = total222;
                    kick_low_of = lost222;
                    rise_of = lost273 + total273;
                }
            }
        } else {
            const double size = fabs(total2);
            const double root = sqrt(size);
            const double square2 = total2;
            const double envelope = exp(-half);
            const double stiff = gamma;
            const double mean3 = decay(delta);
            double odd;
            double odd_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double sin_series_of = sin_series(given3);
                const double bent = given3*sin_series_of;
                const double total21 = bent + 1.0;
                const double back15 = total21 - 1.0;
                const double lost21 = -back15 + bent;
                const double odd_low = 0.16666666666666666*lost2 + lost21;
                odd = total21;
                odd_low2 = odd_low;
            } else {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                const double some = root;
                const double total22 = sine/some;
                const double left10 = sine - some*total22;
                const double left11 = left10 - fma(total22, some, -(total22*some));
                const double left12 = cosine*root_low + left11 - root_low*total22;
                const double lost22 = left12/some;
                odd = total22;
                odd_low2 = lost22;
            }
            const double total24 = envelope*odd;
            const double lost24 = envelope*odd_low2 + fma(envelope, odd, -(envelope*odd));
            const double total25 = mean3 - total24;
            const double back16 = -mean3 + total25;
            const double rest4 = -back16 + total25;
            const double one3 = mean3 - rest4;
            const double two3 = -back16 - total24;
            const double lost25 = one3 + two3;
            const double total26 = total25/stiff;
            const double left13 = -stiff*total26 + total25;
            const double left14 = left13 - fma(total26, stiff, -(total26*stiff));
            const double left15 = left14 - lost24 + lost25;
            const double lost26 = left15/stiff;
            const double total222 = lost24 + total24;
            const double back152 = total222 - total24;
            const double lost222 = -back152 + lost24;
            double count;
            if (root < 67108864.0) {
                count = floor(0.5*root/3.141592653589793 + 0.5);
            } else {
                count = 0.0;
            }
            const double turns = (count*count);
            const double total29 = 39.47841760435743*turns;
            const double lost29 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
            const double total30 = 2.5061182034958845e-15*turns;
            const double lost30 = fma(turns, 2.5061182034958845e-15,
                -(turns*2.5061182034958845e-15));
            const double total31 = -total2 - total29;
            const double back18 = total2 + total31;
            const double rest62 = -back18 + total31;
            const double one5 = -rest62 - total2;
            const double two5 = -back18 - total29;
            const double lost31 = one5 + two5;
            const double total32 = -lost29 + total31;
            const double back19 = -total31 + total32;
            const double rest7 = -back19 + total32;
            const double one6 = -rest7 + total31;
            const double two6 = -back19 - lost29;
            const double lost32 = one6 + two6;
            const double total33 = -total30 + total32;
            const double back20 = -total32 + total33;
            const double rest8 = -back20 + total33;
            const double one7 = -rest8 + total32;
            const double two7 = -back20 - total30;
            const double lost33 = one7 + two7;
            const double total34 = -lost2 + total33;
            const double back21 = -total33 + total34;
            const double rest9 = -back21 + total34;
            const double one8 = -rest9 + total33;
            const double two8 = -back21 - lost2;
            const double lost34 = one8 + two8;
            const double low2 = -lost30 + lost31 + lost32 + lost33 + lost34 -
                1.4920070805839235e-31*turns;
            const double total35 = low2 + total34;
            const double total36 = 6.283185307179586*count;
            const double total37 = root + total36;
            const double whole32 = (total37 == 0.0 ? 1.0 : total37);
            const double total38 = total35/whole32;
            const double far = (total38*total38);
            if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back22 = -total34 + total35;
                const double rest10 = -back22 + total35;
                const double one9 = -rest10 + total34;
                const double two9 = -back22 + low2;
                const double lost35 = one9 + two9;
                const double lost36 = fma(count, 6.283185307179586, -(count*6.283185307179586));
                const double back23 = -root + total37;
                const double rest11 = -back23 + total37;
                const double one10 = -rest11 + root;
                const double two10 = -back23 + total36;
                const double lost37 = one10 + two10;
                const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 + root_low;
                const double left19 = total35 - total38*whole32;
                const double left20 = left19 - fma(total38, whole32, -(total38*whole32));
                const double left21 = -both_low*total38 + left20 + lost35;
                const double lost38 = left21/whole32;
                const double eta = total38;
                const double eta_low = lost38;
                const double total39 = (eta*eta);
                const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                const double cos_series_of2 = cos_series(-total39);
                const double bent2 = cos_series_of2*(total39*total39);
                const double total40 = -bent2 + 0.5*total39;
                const double back24 = -0.5*total39 + total40;
                const double lost40 = -back24 - bent2;
                const double sin_series_of2 = sin_series(-total39);
                const double total41 = -sin_series_of2*total39 + 1.0;
                const double back25 = total41 - 1.0;
                const double lost41 = -back25 - sin_series_of2*total39;
                const double lift_low = 0.5*lost39*total41 + lost40;
                const double total42 = eta*total41;
                const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                const double some2 = root;
                const double total43 = total42/some2;
                const double left22 = -some2*total43 + total42;
                const double left23 = left22 - fma(total43, some2, -(total43*some2));
                const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*total43;
                const double lost43 = left24/some2;
                const double given4 = half;
                const double total44 = 1.0 - 0.5*given4;
                const double back26 = total44 - 1.0;
                const double lost44 = -back26 - 0.5*given4;
                const double decay_series_of3 = decay_series(given4);
                const double curved4 = decay_series_of3*(given4*given4);
                const double total45 = curved4 + total44;
                const double back27 = -total44 + total45;
                const double lost45 = -back27 + curved4;
                const double mean_low5 = lost44 + lost45;
                const double total46 = given4*total45;
                const double lost46 = given4*mean_low5 + fma(given4, total45, -(given4*total45));
                const double total47 = 1.0 - total46;
                const double back28 = total47 - 1.0;
                const double lost47 = -back28 - total46;
                const double fall_low5 = -lost46 + lost47;
                const double total48 = -total43 + total45;
                const double back29 = -total45 + total48;
                const double rest12 = -back29 + total48;
                const double one11 = -rest12 + total45;
                const double two11 = -back29 - total43;
                const double lost48 = one11 + two11;
                const double total49 = given4*total48;
                const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                    fma(given4, total48, -(given4*total48));
                const double total50 = total40 - total49;
                const double back30 = -total40 + total50;
                const double rest13 = -back30 + total50;
                const double one12 = -rest13 + total40;
                const double two12 = -back30 - total49;
                const double lost50 = one12 + two12;
                const double low22 = lift_low - lost49 + lost50;
                const double total51 = low22 + total50;
                const double back31 = -total50 + total51;
                const double rest14 = -back31 + total51;
                const double one13 = -rest14 + total50;
                const double two13 = -back31 + low22;
                const double lost51 = one13 + two13;
                const double total52 = total47*total51;
                const double lost52 = lost51*total47 + fma(total47, total51, -(total47*total51));
                const double low3 = fall_low5*total51 + lost52;
                const double total53 = total52/stiff;
                const double left25 = -stiff*total53 + total52;
                const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                const double left27 = left26 + low3;
                const double lost53 = left27/stiff;
                const double total472 = total43*total47;
                const double lost472 = lost43*total47 + fma(total47, total43, -(total47*total43));
                const double total482 = total45 - total472;
                const double back292 = -total45 + total482;
                const double rest112 = -back292 + total482;
                const double one102 = -rest112 + total45;
                const double two102 = -back292 - total472;
                const double lost482 = one102 + two102;
                const double low23 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                const double total492 = given4*total482;
                const double lost492 = given4*low23 + fma(given4, total482, -(given4*total482));
                const double total502 = total40*total47;
                const double lost502 = lift_low*total47 + fma(total47, total40, -(total47*total40));
                const double total512 = total492 + total502;
                const double back302 = -total492 + total512;
                const double rest122 = -back302 + total512;
                const double one112 = -rest122 + total492;
                const double two112 = -back302 + total502;
                const double lost512 = one112 + two112;
                const double low32 = fall_low5*total40 + lost492 + lost502 + lost512;
                const double total522 = total512/stiff;
                const double left252 = -stiff*total522 + total512;
                const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                const double left272 = left262 + low32;
                const double lost522 = left272/stiff;
                apart_of = lost26 + total26;
                fall_of = lost53 + total53;
                kick_of = total222;
                kick_low_of = lost222;
                rise_of = lost522 + total522;
            } else {
                const double total23 = half*odd;
                const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
                double even;
                double even_low2;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double total19 = 0.5*given3 + 1.0;
                    const double back13 = total19 - 1.0;
                    const double lost19 = -back13 + 0.5*given3;
                    const double cos_series_of = cos_series(given3);
                    const double curved3 = cos_series_of*(given3*given3);
                    const double total20 = curved3 + total19;
                    const double back14 = -total19 + total20;
                    const double lost20 = -back14 + curved3;
                    const double even_low = lost19 + 0.5*lost2 + lost20;
                    even = total20;
                    even_low2 = even_low;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double sine = sin(root);
                    const double cosine = cos(root);
                    even = cosine;
                    even_low2 = -root_low*sine;
                }
                const double total252 = -even + total23;
                const double back162 = -total23 + total252;
                const double rest42 = -back162 + total252;
                const double one32 = -rest42 + total23;
                const double two32 = -back162 - even;
                const double lost252 = one32 + two32;
                const double total262 = envelope + total252;
                const double back172 = -total252 + total262;
                const double rest52 = -back172 + total262;
                const double one42 = -rest52 + total252;
                const double two42 = -back172 + envelope;
                const double lost262 = one42 + two42;
                const double total272 = envelope*total262;
                const double lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                    fma(envelope, total262, -(envelope*total262));
                const double total282 = total272/stiff;
                const double left16 = -stiff*total282 + total272;
                const double left17 = left16 - fma(total282, stiff, -(total282*stiff));
                const double left18 = left17 + lost272;
                const double lost282 = left18/stiff;
                const double total242 = even + total23;
                const double back164 = -even + total242;
                const double rest43 = -back164 + total242;
                const double one33 = even - rest43;
                const double two33 = -back164 + total23;
                const double lost242 = one33 + two33;
                const double total253 = envelope*total242;
                const double lost253 = envelope*(even_low2 + lost23 + lost242) +
                    fma(envelope, total242, -(envelope*total242));
                const double total263 = 1.0 - total253;
                const double back173 = total263 - 1.0;
                const double lost263 = -back173 - total253;
                const double total273 = total263/stiff;
                const double left162 = -stiff*total273 + total263;
                const double left172 = left162 - fma(total273, stiff, -(total273*stiff));
                const double left182 = left172 - lost253 + lost263;
                const double lost273 = left182/stiff;
                apart_of = lost26 + total26;
                fall_of = lost282 + total282;
                kick_of = total222;
                kick_low_of = lost222;
                rise_of = lost273 + total273;
            }
        }
    } else {
        const double size = fabs(total2);
        const double root = sqrt(size);
        const double total3 = half + root;
        const double reach = 0.4444444444444444*total3;
        if (reach < 1.0) {
            if (reach < 0.5625) {
                const double sign_low = lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back3 = -half + total3;
                const double lost3 = -back3 + root;
                const double p_low = lost3 + root_low;
                const double whole2 = (total3 == 0.0 ? 1.0 : total3);
                const double q = gamma/whole2;
                const double off = gamma - q*whole2;
                const double off2 = off - fma(whole2, q, -(whole2*q));
                const double off3 = off2 - p_low*q;
                const double q_low = off3/whole2;
                const double rate2 = 2.0*root;
                const double envelope = exp(-half);
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                const double given5 = 0.5*half;
                const double total54 = 1.0 - 0.5*given5;
                const double back32 = total54 - 1.0;
                const double lost54 = -back32 - 0.5*given5;
                const double decay_series_of4 = decay_series(given5);
                const double curved5 = decay_series_of4*(given5*given5);
                const double total55 = curved5 + total54;
                const double back33 = -total54 + total55;
                const double lost55 = -back33 + curved5;
                const double mean_low6 = lost54 + lost55;
                const double total56 = given5*total55;
                const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
                const double total57 = 1.0 - total56;
                const double back34 = total57 - 1.0;
                const double lost57 = -back34 - total56;
                const double fall_low6 = -lost56 + lost57;
                const double total58 = (total57*total57);
                const double lost58 = 2.0*fall_low6*total57 +
                    fma(total57, total57, -(total57*total57));
                const double total59 = (total58*total58);
                const double lost59 = 2.0*lost58*total58 +
                    fma(total58, total58, -(total58*total58));
                const double rest15 = fall_series(gamma, delta);
                const double total60 = rest15 + 0.5;
                const double back35 = -rest15 + total60;
                const double rest16 = -back35 + total60;
                const double one14 = rest15 - rest16;
                const double two14 = 0.5 - back35;
                const double lost60 = one14 + two14;
                const double total61 = total59*total60;
                const double lost61 = lost60*total59 + fma(total59, total60, -(total59*total60));
                const double half2 = half;
                const double given52 = 0.5*half2;
                const double total532 = 1.0 - 0.5*given52;
                const double back312 = total532 - 1.0;
                const double lost532 = -back312 - 0.5*given52;
                const double decay_series_of5 = decay_series(given52);
                const double curved52 = decay_series_of5*(given52*given52);
                const double total542 = curved52 + total532;
                const double back322 = -total532 + total542;
                const double lost542 = -back322 + curved52;
                const double mean_low62 = lost532 + lost542;
                const double total552 = given52*total542;
                const double lost552 = given52*mean_low62 +
                    fma(given52, total542, -(given52*total542));
                const double total562 = 1.0 - total552;
                const double back332 = total562 - 1.0;
                const double lost562 = -back332 - total552;
                const double fall_low62 = -lost552 + lost562;
                const double total572 = (total562*total562);
                const double lost572 = 2.0*fall_low62*total562 +
                    fma(total562, total562, -(total562*total562));
                const double rest132 = rise_series(half2, total2);
                const double total582 = rest132 + 0.5;
                const double back342 = -rest132 + total582;
                const double rest142 = -back342 + total582;
                const double one122 = rest132 - rest142;
                const double two122 = 0.5 - back342;
                const double lost582 = one122 + two122;
                const double total592 = total572*total582;
                const double lost592 = lost582*total572 +
                    fma(total572, total582, -(total572*total582));
                double fall_;
                double fall_low2;
                if (q < 0.75) {
                    const double given = q;
                    const double total4 = 1.0 - 0.5*given;
                    const double back4 = total4 - 1.0;
                    const double lost4 = -back4 - 0.5*given;
                    const double decay_series_of = decay_series(given);
                    const double curved = decay_series_of*(given*given);
                    const double total5 = curved + total4;
                    const double back5 = -total4 + total5;
                    const double lost5 = -back5 + curved;
                    const double mean_low = lost4 + lost5 - q_low*
                        (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                    const double total6 = given*total5;
                    const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                    const double total7 = 1.0 - total6;
                    const double back6 = total7 - 1.0;
                    const double lost7 = -back6 - total6;
                    const double fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                } else {
                    const double sunk = exp(-q);
                    const double sunk_low = -q_low*sunk;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                }
                double mean2;
                double mean_low4;
                if (rate2 < 0.75) {
                    const double given2 = 2.0*root;
                    const double total10 = 1.0 - 0.5*given2;
                    const double back8 = total10 - 1.0;
                    const double lost10 = -back8 - 0.5*given2;
                    const double decay_series_of2 = decay_series(given2);
                    const double curved2 = decay_series_of2*(given2*given2);
                    const double total11 = curved2 + total10;
                    const double back9 = -total10 + total11;
                    const double lost11 = -back9 + curved2;
                    const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                    mean2 = total11;
                    mean_low4 = mean_low3;
                } else {
                    const double sunk2 = exp(-2.0*root);
                    const double sunk_low2 = -2.0*root_low*sunk2;
                    const double total14 = 1.0 - sunk2;
                    const double back11 = total14 - 1.0;
                    const double lost14 = -back11 - sunk2;
                    const double bottom2 = 2.0*root;
                    const double total15 = total14/bottom2;
                    const double left7 = -bottom2*total15 + total14;
                    const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                    const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                    const double lost15 = left9/bottom2;
                    mean2 = total15;
                    mean_low4 = lost15;
                }
                const double total163 = fall_*mean2;
                const double lost163 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
                const double creep_low = fall_low2*mean2 + lost163;
                const double total232 = creep_low + total163;
                const double back163 = -total163 + total232;
                const double lost232 = -back163 + creep_low;
                apart_of = lost28 + total28;
                fall_of = lost59*total60 + lost61 + total61;
                kick_of = total232;
                kick_low_of = lost232;
                rise_of = lost572*total582 + lost592 + total592;
            } else {
                const double sign_low = lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back3 = -half + total3;
                const double lost3 = -back3 + root;
                const double p_low = lost3 + root_low;
                const double whole2 = (total3 == 0.0 ? 1.0 : total3);
                const double q = gamma/whole2;
                const double off = gamma - q*whole2;
                const double off2 = off - fma(whole2, q, -(whole2*q));
                const double off3 = off2 - p_low*q;
                const double q_low = off3/whole2;
                const double rate2 = 2.0*root;
                const double envelope = exp(-half);
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                double fall_;
                double fall_low2;
                double mean;
                double mean_low2;
                if (q < 0.75) {
                    const double given = q;
                    const double total4 = 1.0 - 0.5*given;
                    const double back4 = total4 - 1.0;
                    const double lost4 = -back4 - 0.5*given;
                    const double decay_series_of = decay_series(given);
                    const double curved = decay_series_of*(given*given);
                    const double total5 = curved + total4;
                    const double back5 = -total4 + total5;
                    const double lost5 = -back5 + curved;
                    const double mean_low = lost4 + lost5 - q_low*
                        (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                    const double total6 = given*total5;
                    const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                    const double total7 = 1.0 - total6;
                    const double back6 = total7 - 1.0;
                    const double lost7 = -back6 - total6;
                    const double fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                    mean = total5;
                    mean_low2 = mean_low;
                } else {
                    const double sunk = exp(-q);
                    const double sunk_low = -q_low*sunk;
                    const double total8 = 1.0 - sunk;
                    const double back7 = total8 - 1.0;
                    const double lost8 = -back7 - sunk;
                    const double bottom = q;
                    const double total9 = total8/bottom;
                    const double left4 = -bottom*total9 + total8;
                    const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                    const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                    const double lost9 = left6/bottom;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                    mean = total9;
                    mean_low2 = lost9;
                }
                double fall2;
                double fall_low4;
                double mean2;
                double mean_low4;
                if (rate2 < 0.75) {
                    const double given2 = 2.0*root;
                    const double total10 = 1.0 - 0.5*given2;
                    const double back8 = total10 - 1.0;
                    const double lost10 = -back8 - 0.5*given2;
                    const double decay_series_of2 = decay_series(given2);
                    const double curved2 = decay_series_of2*(given2*given2);
                    const double total11 = curved2 + total10;
                    const double back9 = -total10 + total11;
                    const double lost11 = -back9 + curved2;
                    const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                    const double total12 = given2*total11;
                    const double lost12 = given2*mean_low3 +
                        fma(given2, total11, -(given2*total11));
                    const double total13 = 1.0 - total12;
                    const double back10 = total13 - 1.0;
                    const double lost13 = -back10 - total12;
                    const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                    fall2 = total13;
                    fall_low4 = fall_low3;
                    mean2 = total11;
                    mean_low4 = mean_low3;
                } else {
                    const double sunk2 = exp(-2.0*root);
                    const double sunk_low2 = -2.0*root_low*sunk2;
                    const double total14 = 1.0 - sunk2;
                    const double back11 = total14 - 1.0;
                    const double lost14 = -back11 - sunk2;
                    const double bottom2 = 2.0*root;
                    const double total15 = total14/bottom2;
                    const double left7 = -bottom2*total15 + total14;
                    const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                    const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                    const double lost15 = left9/bottom2;
                    fall2 = sunk2;
                    fall_low4 = sunk_low2;
                    mean2 = total15;
                    mean_low4 = lost15;
                }
                const double total162 = fall2*mean;
                const double lost162 = fall2*mean_low2 + fma(fall2, mean, -(fall2*mean));
                const double pulled_low = fall_low4*mean + lost162;
                const double total172 = mean2 - total162;
                const double back122 = -mean2 + total172;
                const double rest32 = -back122 + total172;
                const double one22 = mean2 - rest32;
                const double two22 = -back122 - total162;
                const double lost172 = one22 + two22;
                const double total182 = total172/whole2;
                const double left102 = total172 - total182*whole2;
                const double left112 = left102 - fma(total182, whole2, -(total182*whole2));
                const double left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
                const double lost182 = left122/whole2;
                const double total192 = fall_*total182;
                const double lost192 = fall_*lost182 + fma(fall_, total182, -(fall_*total182));
                const double creep_ = fall_low2*total182 + lost192 + total192;
                const double total163 = fall_*mean2;
                const double lost163 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
                const double creep_low = fall_low2*mean2 + lost163;
                const double total232 = creep_low + total163;
                const double back163 = -total163 + total232;
                const double lost232 = -back163 + creep_low;
                const double total173 = mean - total163;
                const double back123 = -mean + total173;
                const double rest33 = -back123 + total173;
                const double one23 = mean - rest33;
                const double two23 = -back123 - total163;
                const double lost173 = one23 + two23;
                const double total183 = total173/whole2;
                const double left103 = total173 - total183*whole2;
                const double left113 = left103 - fma(total183, whole2, -(total183*whole2));
                const double left123 = -creep_low + left113 + lost173 + mean_low2 - p_low*total183;
                const double lost183 = left123/whole2;
                apart_of = lost28 + total28;
                fall_of = creep_;
                kick_of = total232;
                kick_low_of = lost232;
                rise_of = lost183 + total183;
            }
        } else {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            const double whole3 = (delta*total3 == 0.0 ? 1.0 : delta*total3);
            double fall_;
            double fall_low2;
            double mean;
            double mean_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                const double total8 = 1.0 - sunk;
                const double back7 = total8 - 1.0;
                const double lost8 = -back7 - sunk;
                const double bottom = q;
                const double total9 = total8/bottom;
                const double left4 = -bottom*total9 + total8;
                const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const double lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            const double twice = 2.0*fall_;
            double fall2;
            double fall_low4;
            double mean2;
            double mean_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                const double total14 = 1.0 - sunk2;
                const double back11 = total14 - 1.0;
                const double lost14 = -back11 - sunk2;
                const double bottom2 = 2.0*root;
                const double total15 = total14/bottom2;
                const double left7 = -bottom2*total15 + total14;
                const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                const double lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const double fast = fall_*fall2;
            const double total16 = mean2*twice;
            const double lost16 = mean_low4*twice + fma(twice, mean2, -(twice*mean2));
            const double total17 = mean - total16;
            const double back12 = -mean + total17;
            const double rest3 = -back12 + total17;
            const double one2 = mean - rest3;
            const double two2 = -back12 - total16;
            const double lost17 = one2 + two2;
            const double total18 = fast*mean;
            const double lost18 = fast*mean_low2 + fma(fast, mean, -(fast*mean));
            const double top = total17 + total18;
            const double low = -lost16 + lost17 + lost18 + mean_low2;
            const double total162 = fall2*mean;
            const double lost162 = fall2*mean_low2 + fma(fall2, mean, -(fall2*mean));
            const double pulled_low = fall_low4*mean + lost162;
            const double total172 = mean2 - total162;
            const double back122 = -mean2 + total172;
            const double rest32 = -back122 + total172;
            const double one22 = mean2 - rest32;
            const double two22 = -back122 - total162;
            const double lost172 = one22 + two22;
            const double total182 = total172/whole2;
            const double left102 = total172 - total182*whole2;
            const double left112 = left102 - fma(total182, whole2, -(total182*whole2));
            const double left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
            const double lost182 = left122/whole2;
            const double total192 = fall_*total182;
            const double lost192 = fall_*lost182 + fma(fall_, total182, -(fall_*total182));
            const double creep_ = fall_low2*total182 + lost192 + total192;
            const double total163 = fall_*mean2;
            const double lost163 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
            const double creep_low = fall_low2*mean2 + lost163;
            const double total232 = creep_low + total163;
            const double back163 = -total163 + total232;
            const double lost232 = -back163 + creep_low;
            const double total173 = mean - total163;
            const double back123 = -mean + total173;
            const double rest33 = -back123 + total173;
            const double one23 = mean - rest33;
            const double two23 = -back123 - total163;
            const double lost173 = one23 + two23;
            const double total183 = total173/whole2;
            const double left103 = total173 - total183*whole2;
            const double left113 = left103 - fma(total183, whole2, -(total183*whole2));
            const double left123 = -creep_low + left113 + lost173 + mean_low2 - p_low*total183;
            const double lost183 = left123/whole2;
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
static void apart_fall_nyquist_rise_together(double gamma, double delta, double *apart_out,
    double *fall_out, double *nyquist_out, double *rise_out, double *together_out) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    double apart_of;
    double fall_of;
    double nyquist_of;
    double rise_of;
    double together_of;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 1.0) {
            if (reach < 0.5625) {
                const double square2 = total2;
                const double envelope = exp(-half);
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                const double given5 = 0.5*half;
                const double total54 = 1.0 - 0.5*given5;
                const double back32 = total54 - 1.0;
                const double lost54 = -back32 - 0.5*given5;
                const double decay_series_of4 = decay_series(given5);
                const double curved5 = decay_series_of4*(given5*given5);
                const double total55 = curved5 + total54;
                const double back33 = -total54 + total55;
                const double lost55 = -back33 + curved5;
                const double mean_low6 = lost54 + lost55;
                const double total56 = given5*total55;
                const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
                const double total57 = 1.0 - total56;
                const double back34 = total57 - 1.0;
                const double lost57 = -back34 - total56;
                const double fall_low6 = -lost56 + lost57;
                const double total58 = (total57*total57);
                const double lost58 = 2.0*fall_low6*total57 +
                    fma(total57, total57, -(total57*total57));
                const double total59 = (total58*total58);
                const double lost59 = 2.0*lost58*total58 +
                    fma(total58, total58, -(total58*total58));
                const double rest15 = fall_series(gamma, delta);
                const double total60 = rest15 + 0.5;
                const double back35 = -rest15 + total60;
                const double rest16 = -back35 + total60;
                const double one14 = rest15 - rest16;
                const double two14 = 0.5 - back35;
                const double lost60 = one14 + two14;
                const double total61 = total59*total60;
                const double lost61 = lost60*total59 + fma(total59, total60, -(total59*total60));
                const double twice2 = 2.0*envelope;
                const double half2 = half;
                const double given52 = 0.5*half2;
                const double total532 = 1.0 - 0.5*given52;
                const double back312 = total532 - 1.0;
                const double lost532 = -back312 - 0.5*given52;
                const double decay_series_of5 = decay_series(given52);
                const double curved52 = decay_series_of5*(given52*given52);
                const double total542 = curved52 + total532;
                const double back322 = -total532 + total542;
                const double lost542 = -back322 + curved52;
                const double mean_low62 = lost532 + lost542;
                const double total552 = given52*total542;
                const double lost552 = given52*mean_low62 +
                    fma(given52, total542, -(given52*total542));
                const double total562 = 1.0 - total552;
                const double back332 = total562 - 1.0;
                const double lost562 = -back332 - total552;
                const double fall_low62 = -lost552 + lost562;
                const double total572 = (total562*total562);
                const double lost572 = 2.0*fall_low62*total562 +
                    fma(total562, total562, -(total562*total562));
                const double rest132 = rise_series(half2, total2);
                const double total582 = rest132 + 0.5;
                const double back342 = -rest132 + total582;
                const double rest142 = -back342 + total582;
                const double one122 = rest132 - rest142;
                const double two122 = 0.5 - back342;
                const double lost582 = one122 + two122;
                const double total592 = total572*total582;
                const double lost592 = lost582*total572 +
                    fma(total572, total582, -(total572*total582));
                const double rest123 = together_series(half, total2);
                const double total553 = rest123 + 0.5;
                const double back333 = -rest123 + total553;
                const double rest133 = -back333 + total553;
                const double one113 = rest123 - rest133;
                const double two113 = 0.5 - back333;
                const double lost553 = one113 + two113;
                const double total563 = envelope*total553;
                const double lost563 = envelope*lost553 +
                    fma(envelope, total553, -(envelope*total553));
                double even;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double total19 = 0.5*given3 + 1.0;
                    const double cos_series_of = cos_series(given3);
                    const double curved3 = cos_series_of*(given3*given3);
                    const double total20 = curved3 + total19;
                    even = total20;
                } else {
                    const double size = fabs(total2);
                    const double root = sqrt(size);
                    const double cosine = cos(root);
                    even = cosine;
                }
                const double total263 = even*twice2;
                if (total263 > 0.0) {
                    const double e = exp(-delta);
                    const double total253 = e + 1.0;
                    const double back182 = total253 - 1.0;
                    const double lost253 = -back182 + e;
                    const double total273 = total253 + total263;
                    const double back192 = -total253 + total273;
                    const double lost273 = -back192 + total263;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const double size = fabs(total2);
                        const double root = sqrt(size);
                        const double sign_low = -lost2;
                        const double left = -(root*root) + size;
                        const double left2 = left - fma(root, root, -(root*root));
                        const double left3 = left2 + sign_low;
                        const double whole = (root == 0.0 ? 1.0 : root);
                        const double root_low = 0.5*left3/whole;
                        const double sine = sin(root);
                        even_low2 = -root_low*sine;
                    }
                    const double lost263 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                    apart_of = lost28 + total28;
                    fall_of = lost59*total60 + lost61 + total61;
                    nyquist_of = lost253 + lost263 + lost273 + total273;
                    rise_of = lost572*total582 + lost592 + total592;
                    together_of = 2.0*lost563 + 2.0*total563;
                } else {
                    const double size = fabs(total2);
                    const double root = sqrt(size);
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double back72 = 0.5*root_low*sin_of;
                    const double total92 = -back72 + wave;
                    const double back82 = total92 - wave;
                    const double rest33 = -back82 + total92;
                    const double one23 = -rest33 + wave;
                    const double two23 = -back72 - back82;
                    const double lost92 = one23 + two23;
                    const double total102 = (total92*total92);
                    const double lost102 = fma(total92, total92, -(total92*total92));
                    const double low4 = lost102 + 2.0*lost92*total92;
                    const double total112 = envelope*total102;
                    const double lost112 = envelope*low4 +
                        fma(envelope, total102, -(envelope*total102));
                    const double total122 = (grown*grown) + total112;
                    const double back92 = -total112 + total122;
                    const double rest43 = -back92 + total122;
                    const double one33 = -rest43 + total112;
                    const double two33 = -back92 + (grown*grown);
                    const double lost122 = one33 + two33;
                    const double low23 = lost112 + lost122;
                    apart_of = lost28 + total28;
                    fall_of = lost59*total60 + lost61 + total61;
                    nyquist_of = 4.0*low23 + 4.0*total122;
                    rise_of = lost572*total582 + lost592 + total592;
                    together_of = 2.0*lost563 + 2.0*total563;
                }
            } else {
                const double size = fabs(total2);
                const double root = sqrt(size);
                const double square2 = total2;
                const double envelope = exp(-half);
                const double stiff = gamma;
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                const double twice2 = 2.0*envelope;
                const double rest123 = together_series(half, total2);
                const double total553 = rest123 + 0.5;
                const double back333 = -rest123 + total553;
                const double rest133 = -back333 + total553;
                const double one113 = rest123 - rest133;
                const double two113 = 0.5 - back333;
                const double lost553 = one113 + two113;
                const double total563 = envelope*total553;
                const double lost563 = envelope*lost553 +
                    fma(envelope, total553, -(envelope*total553));
                double even;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double total19 = 0.5*given3 + 1.0;
                    const double cos_series_of = cos_series(given3);
                    const double curved3 = cos_series_of*(given3*given3);
                    const double total20 = curved3 + total19;
                    even = total20;
                } else {
                    const double cosine = cos(root);
                    even = cosine;
                }
                const double total263 = even*twice2;
                double count;
                if (root < 67108864.0) {
                    count = floor(0.5*root/3.141592653589793 + 0.5);
                } else {
                    count = 0.0;
                }
                const double turns = (count*count);
                const double total29 = 39.47841760435743*turns;
                const double lost29 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
                const double total30 = 2.5061182034958845e-15*turns;
                const double lost30 = fma(turns, 2.5061182034958845e-15,
                    -(turns*2.5061182034958845e-15));
                const double total31 = -total2 - total29;
                const double back18 = total2 + total31;
                const double rest62 = -back18 + total31;
                const double one5 = -rest62 - total2;
                const double two5 = -back18 - total29;
                const double lost31 = one5 + two5;
                const double total32 = -lost29 + total31;
                const double back19 = -total31 + total32;
                const double rest7 = -back19 + total32;
                const double one6 = -rest7 + total31;
                const double two6 = -back19 - lost29;
                const double lost32 = one6 + two6;
                const double total33 = -total30 + total32;
                const double back20 = -total32 + total33;
                const double rest8 = -back20 + total33;
                const double one7 = -rest8 + total32;
                const double two7 = -back20 - total30;
                const double lost33 = one7 + two7;
                const double total34 = -lost2 + total33;
                const double back21 = -total33 + total34;
                const double rest9 = -back21 + total34;
                const double one8 = -rest9 + total33;
                const double two8 = -back21 - lost2;
                const double lost34 = one8 + two8;
                const double low2 = -lost30 + lost31 + lost32 + lost33 + lost34 -
                    1.4920070805839235e-31*turns;
                const double total35 = low2 + total34;
                const double total36 = 6.283185307179586*count;
                const double total37 = root + total36;
                const double whole32 = (total37 == 0.0 ? 1.0 : total37);
                const double total38 = total35/whole32;
                const double far = (total38*total38);
                if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                    if (total263 > 0.0) {
                        const double sign_low = -lost2;
                        const double left = -(root*root) + size;
                        const double left2 = left - fma(root, root, -(root*root));
                        const double left3 = left2 + sign_low;
                        const double whole = (root == 0.0 ? 1.0 : root);
                        const double root_low = 0.5*left3/whole;
                        const double back22 = -total34 + total35;
                        const double rest10 = -back22 + total35;
                        const double one9 = -rest10 + total34;
                        const double two9 = -back22 + low2;
                        const double lost35 = one9 + two9;
                        const double lost36 = fma(count, 6.283185307179586,
                            -(count*6.283185307179586));
                        const double back23 = -root + total37;
                        const double rest11 = -back23 + total37;
                        const double one10 = -rest11 + root;
                        const double two10 = -back23 + total36;
                        const double lost37 = one10 + two10;
                        const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 +
                            root_low;
                        const double left19 = total35 - total38*whole32;
                        const double left20 = left19 - fma(total38, whole32, -(total38*whole32));
                        const double left21 = -both_low*total38 + left20 + lost35;
                        const double lost38 = left21/whole32;
                        const double eta = total38;
                        const double eta_low = lost38;
                        const double total39 = (eta*eta);
                        const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                        const double cos_series_of2 = cos_series(-total39);
                        const double bent2 = cos_series_of2*(total39*total39);
                        const double total40 = -bent2 + 0.5*total39;
                        const double back24 = -0.5*total39 + total40;
                        const double lost40 = -back24 - bent2;
                        const double sin_series_of2 = sin_series(-total39);
                        const double total41 = -sin_series_of2*total39 + 1.0;
                        const double back25 = total41 - 1.0;
                        const double lost41 = -back25 - sin_series_of2*total39;
                        const double lift_low = 0.5*lost39*total41 + lost40;
                        const double total42 = eta*total41;
                        const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                        const double some2 = root;
                        const double total43 = total42/some2;
                        const double left22 = -some2*total43 + total42;
                        const double left23 = left22 - fma(total43, some2, -(total43*some2));
                        const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*
                            total43;
                        const double lost43 = left24/some2;
                        const double given4 = half;
                        const double total44 = 1.0 - 0.5*given4;
                        const double back26 = total44 - 1.0;
                        const double lost44 = -back26 - 0.5*given4;
                        const double decay_series_of3 = decay_series(given4);
                        const double curved4 = decay_series_of3*(given4*given4);
                        const double total45 = curved4 + total44;
                        const double back27 = -total44 + total45;
                        const double lost45 = -back27 + curved4;
                        const double mean_low5 = lost44 + lost45;
                        const double total46 = given4*total45;
                        const double lost46 = given4*mean_low5 +
                            fma(given4, total45, -(given4*total45));
                        const double total47 = 1.0 - total46;
                        const double back28 = total47 - 1.0;
                        const double lost47 = -back28 - total46;
                        const double fall_low5 = -lost46 + lost47;
                        const double total48 = -total43 + total45;
                        const double back29 = -total45 + total48;
                        const double rest12 = -back29 + total48;
                        const double one11 = -rest12 + total45;
                        const double two11 = -back29 - total43;
                        const double lost48 = one11 + two11;
                        const double total49 = given4*total48;
                        const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                            fma(given4, total48, -(given4*total48));
                        const double total50 = total40 - total49;
                        const double back30 = -total40 + total50;
                        const double rest13 = -back30 + total50;
                        const double one12 = -rest13 + total40;
                        const double two12 = -back30 - total49;
                        const double lost50 = one12 + two12;
                        const double low22 = lift_low - lost49 + lost50;
                        const double total51 = low22 + total50;
                        const double back31 = -total50 + total51;
                        const double rest14 = -back31 + total51;
                        const double one13 = -rest14 + total50;
                        const double two13 = -back31 + low22;
                        const double lost51 = one13 + two13;
                        const double total52 = total47*total51;
                        const double lost52 = lost51*total47 +
                            fma(total47, total51, -(total47*total51));
                        const double low3 = fall_low5*total51 + lost52;
                        const double total53 = total52/stiff;
                        const double left25 = -stiff*total53 + total52;
                        const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                        const double left27 = left26 + low3;
                        const double lost53 = left27/stiff;
                        const double e = exp(-delta);
                        const double total253 = e + 1.0;
                        const double back182 = total253 - 1.0;
                        const double lost253 = -back182 + e;
                        const double total273 = total253 + total263;
                        const double back192 = -total253 + total273;
                        const double lost273 = -back192 + total263;
                        const double total472 = total43*total47;
                        const double lost472 = lost43*total47 +
                            fma(total47, total43, -(total47*total43));
                        const double total482 = total45 - total472;
                        const double back292 = -total45 + total482;
                        const double rest112 = -back292 + total482;
                        const double one102 = -rest112 + total45;
                        const double two102 = -back292 - total472;
                        const double lost482 = one102 + two102;
                        const double low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                        const double total492 = given4*total482;
                        const double lost492 = given4*low24 +
                            fma(given4, total482, -(given4*total482));
                        const double total502 = total40*total47;
                        const double lost502 = lift_low*total47 +
                            fma(total47, total40, -(total47*total40));
                        const double total512 = total492 + total502;
                        const double back302 = -total492 + total512;
                        const double rest122 = -back302 + total512;
                        const double one112 = -rest122 + total492;
                        const double two112 = -back302 + total502;
                        const double lost512 = one112 + two112;
                        const double low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                        const double total522 = total512/stiff;
                        const double left252 = -stiff*total522 + total512;
                        const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                        const double left272 = left262 + low33;
                        const double lost522 = left272/stiff;
                        double even_low2;
                        if (square2 > -1.5) {
                            const double given3 = square2;
                            const double total19 = 0.5*given3 + 1.0;
                            const double back13 = total19 - 1.0;
                            const double lost19 = -back13 + 0.5*given3;
                            const double cos_series_of = cos_series(given3);
                            const double curved3 = cos_series_of*(given3*given3);
                            const double total20 = curved3 + total19;
                            const double back14 = -total19 + total20;
                            const double lost20 = -back14 + curved3;
                            const double even_low = lost19 + 0.5*lost2 + lost20;
                            even_low2 = even_low;
                        } else {
                            const double sine = sin(root);
                            even_low2 = -root_low*sine;
                        }
                        const double lost263 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                        apart_of = lost28 + total28;
                        fall_of = lost53 + total53;
                        nyquist_of = lost253 + lost263 + lost273 + total273;
                        rise_of = lost522 + total522;
                        together_of = 2.0*lost563 + 2.0*total563;
                    } else {
                        const double sign_low = -lost2;
                        const double left = -(root*root) + size;
                        const double left2 = left - fma(root, root, -(root*root));
                        const double left3 = left2 + sign_low;
                        const double whole = (root == 0.0 ? 1.0 : root);
                        const double root_low = 0.5*left3/whole;
                        const double back22 = -total34 + total35;
                        const double rest10 = -back22 + total35;
                        const double one9 = -rest10 + total34;
                        const double two9 = -back22 + low2;
                        const double lost35 = one9 + two9;
                        const double lost36 = fma(count, 6.283185307179586,
                            -(count*6.283185307179586));
                        const double back23 = -root + total37;
                        const double rest11 = -back23 + total37;
                        const double one10 = -rest11 + root;
                        const double two10 = -back23 + total36;
                        const double lost37 = one10 + two10;
                        const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 +
                            root_low;
                        const double left19 = total35 - total38*whole32;
                        const double left20 = left19 - fma(total38, whole32, -(total38*whole32));
                        const double left21 = -both_low*total38 + left20 + lost35;
                        const double lost38 = left21/whole32;
                        const double eta = total38;
                        const double eta_low = lost38;
                        const double total39 = (eta*eta);
                        const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                        const double cos_series_of2 = cos_series(-total39);
                        const double bent2 = cos_series_of2*(total39*total39);
                        const double total40 = -bent2 + 0.5*total39;
                        const double back24 = -0.5*total39 + total40;
                        const double lost40 = -back24 - bent2;
                        const double sin_series_of2 = sin_series(-total39);
                        const double total41 = -sin_series_of2*total39 + 1.0;
                        const double back25 = total41 - 1.0;
                        const double lost41 = -back25 - sin_series_of2*total39;
                        const double lift_low = 0.5*lost39*total41 + lost40;
                        const double total42 = eta*total41;
                        const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                        const double some2 = root;
                        const double total43 = total42/some2;
                        const double left22 = -some2*total43 + total42;
                        const double left23 = left22 - fma(total43, some2, -(total43*some2));
                        const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*
                            total43;
                        const double lost43 = left24/some2;
                        const double given4 = half;
                        const double total44 = 1.0 - 0.5*given4;
                        const double back26 = total44 - 1.0;
                        const double lost44 = -back26 - 0.5*given4;
                        const double decay_series_of3 = decay_series(given4);
                        const double curved4 = decay_series_of3*(given4*given4);
                        const double total45 = curved4 + total44;
                        const double back27 = -total44 + total45;
                        const double lost45 = -back27 + curved4;
                        const double mean_low5 = lost44 + lost45;
                        const double total46 = given4*total45;
                        const double lost46 = given4*mean_low5 +
                            fma(given4, total45, -(given4*total45));
                        const double total47 = 1.0 - total46;
                        const double back28 = total47 - 1.0;
                        const double lost47 = -back28 - total46;
                        const double fall_low5 = -lost46 + lost47;
                        const double total48 = -total43 + total45;
                        const double back29 = -total45 + total48;
                        const double rest12 = -back29 + total48;
                        const double one11 = -rest12 + total45;
                        const double two11 = -back29 - total43;
                        const double lost48 = one11 + two11;
                        const double total49 = given4*total48;
                        const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                            fma(given4, total48, -(given4*total48));
                        const double total50 = total40 - total49;
                        const double back30 = -total40 + total50;
                        const double rest13 = -back30 + total50;
                        const double one12 = -rest13 + total40;
                        const double two12 = -back30 - total49;
                        const double lost50 = one12 + two12;
                        const double low22 = lift_low - lost49 + lost50;
                        const double total51 = low22 + total50;
                        const double back31 = -total50 + total51;
                        const double rest14 = -back31 + total51;
                        const double one13 = -rest14 + total50;
                        const double two13 = -back31 + low22;
                        const double lost51 = one13 + two13;
                        const double total52 = total47*total51;
                        const double lost52 = lost51*total47 +
                            fma(total47, total51, -(total47*total51));
                        const double low3 = fall_low5*total51 + lost52;
                        const double total53 = total52/stiff;
                        const double left25 = -stiff*total53 + total52;
                        const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                        const double left27 = left26 + low3;
                        const double lost53 = left27/stiff;
                        const double expm1_of = expm1(-half);
                        const double grown = -0.5*expm1_of;
                        const double angle = 0.5*root;
                        const double wave = cos(angle);
                        const double sin_of = sin(angle);
                        const double back72 = 0.5*root_low*sin_of;
                        const double total92 = -back72 + wave;
                        const double back82 = total92 - wave;
                        const double rest33 = -back82 + total92;
                        const double one23 = -rest33 + wave;
                        const double two23 = -back72 - back82;
                        const double lost92 = one23 + two23;
                        const double total102 = (total92*total92);
                        const double lost102 = fma(total92, total92, -(total92*total92));
                        const double low4 = lost102 + 2.0*lost92*total92;
                        const double total112 = envelope*total102;
                        const double lost112 = envelope*low4 +
                            fma(envelope, total102, -(envelope*total102));
                        const double total122 = (grown*grown) + total112;
                        const double back92 = -total112 + total122;
                        const double rest43 = -back92 + total122;
                        const double one33 = -rest43 + total112;
                        const double two33 = -back92 + (grown*grown);
                        const double lost122 = one33 + two33;
                        const double low23 = lost112 + lost122;
                        const double total472 = total43*total47;
                        const double lost472 = lost43*total47 +
                            fma(total47, total43, -(total47*total43));
                        const double total482 = total45 - total472;
                        const double back292 = -total45 + total482;
                        const double rest112 = -back292 + total482;
                        const double one102 = -rest112 + total45;
                        const double two102 = -back292 - total472;
                        const double lost482 = one102 + two102;
                        const double low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                        const double total492 = given4*total482;
                        const double lost492 = given4*low24 +
                            fma(given4, total482, -(given4*total482));
                        const double total502 = total40*total47;
                        const double lost502 = lift_low*total47 +
                            fma(total47, total40, -(total47*total40));
                        const double total512 = total492 + total502;
                        const double back302 = -total492 + total512;
                        const double rest122 = -back302 + total512;
                        const double one112 = -rest122 + total492;
                        const double two112 = -back302 + total502;
                        const double lost512 = one112 + two112;
                        const double low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                        const double total522 = total512/stiff;
                        const double left252 = -stiff*total522 + total512;
                        const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                        const double left272 = left262 + low33;
                        const double lost522 = left272/stiff;
                        apart_of = lost28 + total28;
                        fall_of = lost53 + total53;
                        nyquist_of = 4.0*low23 + 4.0*total122;
                        rise_of = lost522 + total522;
                        together_of = 2.0*lost563 + 2.0*total563;
                    }
                } else {
                    if (total263 > 0.0) {
                        const double e = exp(-delta);
                        const double total253 = e + 1.0;
                        const double back182 = total253 - 1.0;
                        const double lost253 = -back182 + e;
                        const double total273 = total253 + total263;
                        const double back192 = -total253 + total273;
                        const double lost273 = -back192 + total263;
                        double even_low2;
                        double odd;
                        double odd_low2;
                        if (square2 > -1.5) {
                            const double given3 = square2;
                            const double total19 = 0.5*given3 + 1.0;
                            const double back13 = total19 - 1.0;
                            const double lost19 = -back13 + 0.5*given3;
                            const double cos_series_of = cos_series(given3);
                            const double curved3 = cos_series_of*(given3*given3);
                            const double total20 = curved3 + total19;
                            const double back14 = -total19 + total20;
                            const double lost20 = -back14 + curved3;
                            const double even_low = lost19 + 0.5*lost2 + lost20;
                            const double sin_series_of = sin_series(given3);
                            const double bent = given3*sin_series_of;
                            const double total21 = bent + 1.0;
                            const double back15 = total21 - 1.0;
                            const double lost21 = -back15 + bent;
                            const double odd_low = 0.16666666666666666*lost2 + lost21;
                            even_low2 = even_low;
                            odd = total21;
                            odd_low2 = odd_low;
                        } else {
                            const double sign_low = -lost2;
                            const double left = -(root*root) + size;
                            const double left2 = left - fma(root, root, -(root*root));
                            const double left3 = left2 + sign_low;
                            const double whole = (root == 0.0 ? 1.0 : root);
                            const double root_low = 0.5*left3/whole;
                            const double sine = sin(root);
                            const double cosine = cos(root);
                            const double some = root;
                            const double total22 = sine/some;
                            const double left10 = sine - some*total22;
                            const double left11 = left10 - fma(total22, some, -(total22*some));
                            const double left12 = cosine*root_low + left11 - root_low*total22;
                            const double lost22 = left12/some;
                            even_low2 = -root_low*sine;
                            odd = total22;
                            odd_low2 = lost22;
                        }
                        const double total23 = half*odd;
                        const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
                        const double total252 = -even + total23;
                        const double back162 = -total23 + total252;
                        const double rest42 = -back162 + total252;
                        const double one32 = -rest42 + total23;
                        const double two32 = -back162 - even;
                        const double lost252 = one32 + two32;
                        const double total262 = envelope + total252;
                        const double back172 = -total252 + total262;
                        const double rest52 = -back172 + total262;
                        const double one42 = -rest52 + total252;
                        const double two42 = -back172 + envelope;
                        const double lost262 = one42 + two42;
                        const double total272 = envelope*total262;
                        const double lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                            fma(envelope, total262, -(envelope*total262));
                        const double total282 = total272/stiff;
                        const double left16 = -stiff*total282 + total272;
                        const double left17 = left16 - fma(total282, stiff, -(total282*stiff));
                        const double left18 = left17 + lost272;
                        const double lost282 = left18/stiff;
                        const double lost263 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                        const double total242 = even + total23;
                        const double back163 = -even + total242;
                        const double rest44 = -back163 + total242;
                        const double one34 = even - rest44;
                        const double two34 = -back163 + total23;
                        const double lost242 = one34 + two34;
                        const double total254 = envelope*total242;
                        const double lost254 = envelope*(even_low2 + lost23 + lost242) +
                            fma(envelope, total242, -(envelope*total242));
                        const double total264 = 1.0 - total254;
                        const double back173 = total264 - 1.0;
                        const double lost264 = -back173 - total254;
                        const double total274 = total264/stiff;
                        const double left162 = -stiff*total274 + total264;
                        const double left172 = left162 - fma(total274, stiff, -(total274*stiff));
                        const double left182 = left172 - lost254 + lost264;
                        const double lost274 = left182/stiff;
                        apart_of = lost28 + total28;
                        fall_of = lost282 + total282;
                        nyquist_of = lost253 + lost263 + lost273 + total273;
                        rise_of = lost274 + total274;
                        together_of = 2.0*lost563 + 2.0*total563;
                    } else {
                        const double sign_low = -lost2;
                        const double left = -(root*root) + size;
                        const double left2 = left - fma(root, root, -(root*root));
                        const double left3 = left2 + sign_low;
                        const double whole = (root == 0.0 ? 1.0 : root);
                        const double root_low = 0.5*left3/whole;
                        const double expm1_of = expm1(-half);
                        const double grown = -0.5*expm1_of;
                        const double angle = 0.5*root;
                        const double wave = cos(angle);
                        const double sin_of = sin(angle);
                        const double back72 = 0.5*root_low*sin_of;
                        const double total92 = -back72 + wave;
                        const double back82 = total92 - wave;
                        const double rest33 = -back82 + total92;
                        const double one23 = -rest33 + wave;
                        const double two23 = -back72 - back82;
                        const double lost92 = one23 + two23;
                        const double total102 = (total92*total92);
                        const double lost102 = fma(total92, total92, -(total92*total92));
                        const double low4 = lost102 + 2.0*lost92*total92;
                        const double total112 = envelope*total102;
                        const double lost112 = envelope*low4 +
                            fma(envelope, total102, -(envelope*total102));
                        const double total122 = (grown*grown) + total112;
                        const double back92 = -total112 + total122;
                        const double rest43 = -back92 + total122;
                        const double one33 = -rest43 + total112;
                        const double two33 = -back92 + (grown*grown);
                        const double lost122 = one33 + two33;
                        const double low23 = lost112 + lost122;
                        double even_low2;
                        double odd;
                        double odd_low2;
                        if (square2 > -1.5) {
                            const double given3 = square2;
                            const double total19 = 0.5*given3 + 1.0;
                            const double back13 = total19 - 1.0;
                            const double lost19 = -back13 + 0.5*given3;
                            const double cos_series_of = cos_series(given3);
                            const double curved3 = cos_series_of*(given3*given3);
                            const double total20 = curved3 + total19;
                            const double back14 = -total19 + total20;
                            const double lost20 = -back14 + curved3;
                            const double even_low = lost19 + 0.5*lost2 + lost20;
                            const double sin_series_of = sin_series(given3);
                            const double bent = given3*sin_series_of;
                            const double total21 = bent + 1.0;
                            const double back15 = total21 - 1.0;
                            const double lost21 = -back15 + bent;
                            const double odd_low = 0.16666666666666666*lost2 + lost21;
                            even_low2 = even_low;
                            odd = total21;
                            odd_low2 = odd_low;
                        } else {
                            const double sine = sin(root);
                            const double cosine = cos(root);
                            const double some = root;
                            const double total22 = sine/some;
                            const double left10 = sine - some*total22;
                            const double left11 = left10 - fma(total22, some, -(total22*some));
                            const double left12 = cosine*root_low + left11 - root_low*total22;
                            const double lost22 = left12/some;
                            even_low2 = -root_low*sine;
                            odd = total22;
                            odd_low2 = lost22;
                        }
                        const double total23 = half*odd;
                        const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
                        const double total252 = -even + total23;
                        const double back162 = -total23 + total252;
                        const double rest42 = -back162 + total252;
                        const double one32 = -rest42 + total23;
                        const double two32 = -back162 - even;
                        const double lost252 = one32 + two32;
                        const double total262 = envelope + total252;
                        const double back172 = -total252 + total262;
                        const double rest52 = -back172 + total262;
                        const double one42 = -rest52 + total252;
                        const double two42 = -back172 + envelope;
                        const double lost262 = one42 + two42;
                        const double total272 = envelope*total262;
                        const double lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                            fma(envelope, total262, -(envelope*total262));
                        const double total282 = total272/stiff;
                        const double left16 = -stiff*total282 + total272;
                        const double left17 = left16 - fma(total282, stiff, -(total282*stiff));
                        const double left18 = left17 + lost272;
                        const double lost282 = left18/stiff;
                        const double total242 = even + total23;
                        const double back163 = -even + total242;
                        const double rest44 = -back163 + total242;
                        const double one34 = even - rest44;
                        const double two34 = -back163 + total23;
                        const double lost242 = one34 + two34;
                        const double total254 = envelope*total242;
                        const double lost254 = envelope*(even_low2 + lost23 + lost242) +
                            fma(envelope, total242, -(envelope*total242));
                        const double total264 = 1.0 - total254;
                        const double back173 = total264 - 1.0;
                        const double lost264 = -back173 - total254;
                        const double total274 = total264/stiff;
                        const double left162 = -stiff*total274 + total264;
                        const double left172 = left162 - fma(total274, stiff, -(total274*stiff));
                        const double left182 = left172 - lost254 + lost264;
                        const double lost274 = left182/stiff;
                        apart_of = lost28 + total28;
                        fall_of = lost282 + total282;
                        nyquist_of = 4.0*low23 + 4.0*total122;
                        rise_of = lost274 + total274;
                        together_of = 2.0*lost563 + 2.0*total563;
                    }
                }
            }
        } else {
            const double size = fabs(total2);
            const double root = sqrt(size);
            const double square2 = total2;
            const double envelope = exp(-half);
            const double stiff = gamma;
            const double mean3 = decay(delta);
            const double twice2 = 2.0*envelope;
            double even;
            double odd;
            double odd_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total19 = 0.5*given3 + 1.0;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total20 = curved3 + total19;
                const double sin_series_of = sin_series(given3);
                const double bent = given3*sin_series_of;
                const double total21 = bent + 1.0;
                const double back15 = total21 - 1.0;
                const double lost21 = -back15 + bent;
                const double odd_low = 0.16666666666666666*lost2 + lost21;
                even = total20;
                odd = total21;
                odd_low2 = odd_low;
            } else {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                const double some = root;
                const double total22 = sine/some;
                const double left10 = sine - some*total22;
                const double left11 = left10 - fma(total22, some, -(total22*some));
                const double left12 = cosine*root_low + left11 - root_low*total22;
                const double lost22 = left12/some;
                even = cosine;
                odd = total22;
                odd_low2 = lost22;
            }
            const double total24 = envelope*odd;
            const double lost24 = envelope*odd_low2 + fma(envelope, odd, -(envelope*odd));
            const double total25 = mean3 - total24;
            const double back16 = -mean3 + total25;
            const double rest4 = -back16 + total25;
            const double one3 = mean3 - rest4;
            const double two3 = -back16 - total24;
            const double lost25 = one3 + two3;
            const double total26 = total25/stiff;
            const double left13 = -stiff*total26 + total25;
            const double left14 = left13 - fma(total26, stiff, -(total26*stiff));
            const double left15 = left14 - lost24 + lost25;
            const double lost26 = left15/stiff;
            const double total263 = even*twice2;
            double count;
            if (root < 67108864.0) {
                count = floor(0.5*root/3.141592653589793 + 0.5);
            } else {
                count = 0.0;
            }
            const double turns = (count*count);
            const double total29 = 39.47841760435743*turns;
            const double lost29 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
            const double total30 = 2.5061182034958845e-15*turns;
            const double lost30 = fma(turns, 2.5061182034958845e-15,
                -(turns*2.5061182034958845e-15));
            const double total31 = -total2 - total29;
            const double back18 = total2 + total31;
            const double rest62 = -back18 + total31;
            const double one5 = -rest62 - total2;
            const double two5 = -back18 - total29;
            const double lost31 = one5 + two5;
            const double total32 = -lost29 + total31;
            const double back19 = -total31 + total32;
            const double rest7 = -back19 + total32;
            const double one6 = -rest7 + total31;
            const double two6 = -back19 - lost29;
            const double lost32 = one6 + two6;
            const double total33 = -total30 + total32;
            const double back20 = -total32 + total33;
            const double rest8 = -back20 + total33;
            const double one7 = -rest8 + total32;
            const double two7 = -back20 - total30;
            const double lost33 = one7 + two7;
            const double total34 = -lost2 + total33;
            const double back21 = -total33 + total34;
            const double rest9 = -back21 + total34;
            const double one8 = -rest9 + total33;
            const double two8 = -back21 - lost2;
            const double lost34 = one8 + two8;
            const double low2 = -lost30 + lost31 + lost32 + lost33 + lost34 -
                1.4920070805839235e-31*turns;
            const double total35 = low2 + total34;
            const double total36 = 6.283185307179586*count;
            const double total37 = root + total36;
            const double whole32 = (total37 == 0.0 ? 1.0 : total37);
            const double total38 = total35/whole32;
            const double far = (total38*total38);
            if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                if (total263 > 0.0) {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double back22 = -total34 + total35;
                    const double rest10 = -back22 + total35;
                    const double one9 = -rest10 + total34;
                    const double two9 = -back22 + low2;
                    const double lost35 = one9 + two9;
                    const double lost36 = fma(count, 6.283185307179586, -(count*6.283185307179586));
                    const double back23 = -root + total37;
                    const double rest11 = -back23 + total37;
                    const double one10 = -rest11 + root;
                    const double two10 = -back23 + total36;
                    const double lost37 = one10 + two10;
                    const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 +
                        root_low;
                    const double left19 = total35 - total38*whole32;
                    const double left20 = left19 - fma(total38, whole32, -(total38*whole32));
                    const double left21 = -both_low*total38 + left20 + lost35;
                    const double lost38 = left21/whole32;
                    const double eta = total38;
                    const double eta_low = lost38;
                    const double total39 = (eta*eta);
                    const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                    const double cos_series_of2 = cos_series(-total39);
                    const double bent2 = cos_series_of2*(total39*total39);
                    const double total40 = -bent2 + 0.5*total39;
                    const double back24 = -0.5*total39 + total40;
                    const double lost40 = -back24 - bent2;
                    const double sin_series_of2 = sin_series(-total39);
                    const double total41 = -sin_series_of2*total39 + 1.0;
                    const double back25 = total41 - 1.0;
                    const double lost41 = -back25 - sin_series_of2*total39;
                    const double lift_low = 0.5*lost39*total41 + lost40;
                    const double total42 = eta*total41;
                    const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                    const double some2 = root;
                    const double total43 = total42/some2;
                    const double left22 = -some2*total43 + total42;
                    const double left23 = left22 - fma(total43, some2, -(total43*some2));
                    const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*
                        total43;
                    const double lost43 = left24/some2;
                    const double given4 = half;
                    const double total44 = 1.0 - 0.5*given4;
                    const double back26 = total44 - 1.0;
                    const double lost44 = -back26 - 0.5*given4;
                    const double decay_series_of3 = decay_series(given4);
                    const double curved4 = decay_series_of3*(given4*given4);
                    const double total45 = curved4 + total44;
                    const double back27 = -total44 + total45;
                    const double lost45 = -back27 + curved4;
                    const double mean_low5 = lost44 + lost45;
                    const double total46 = given4*total45;
                    const double lost46 = given4*mean_low5 +
                        fma(given4, total45, -(given4*total45));
                    const double total47 = 1.0 - total46;
                    const double back28 = total47 - 1.0;
                    const double lost47 = -back28 - total46;
                    const double fall_low5 = -lost46 + lost47;
                    const double total48 = -total43 + total45;
                    const double back29 = -total45 + total48;
                    const double rest12 = -back29 + total48;
                    const double one11 = -rest12 + total45;
                    const double two11 = -back29 - total43;
                    const double lost48 = one11 + two11;
                    const double total49 = given4*total48;
                    const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                        fma(given4, total48, -(given4*total48));
                    const double total50 = total40 - total49;
                    const double back30 = -total40 + total50;
                    const double rest13 = -back30 + total50;
                    const double one12 = -rest13 + total40;
                    const double two12 = -back30 - total49;
                    const double lost50 = one12 + two12;
                    const double low22 = lift_low - lost49 + lost50;
                    const double total51 = low22 + total50;
                    const double back31 = -total50 + total51;
                    const double rest14 = -back31 + total51;
                    const double one13 = -rest14 + total50;
                    const double two13 = -back31 + low22;
                    const double lost51 = one13 + two13;
                    const double total52 = total47*total51;
                    const double lost52 = lost51*total47 +
                        fma(total47, total51, -(total47*total51));
                    const double low3 = fall_low5*total51 + lost52;
                    const double total53 = total52/stiff;
                    const double left25 = -stiff*total53 + total52;
                    const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                    const double left27 = left26 + low3;
                    const double lost53 = left27/stiff;
                    const double e = exp(-delta);
                    const double total253 = e + 1.0;
                    const double back182 = total253 - 1.0;
                    const double lost253 = -back182 + e;
                    const double total273 = total253 + total263;
                    const double back192 = -total253 + total273;
                    const double lost273 = -back192 + total263;
                    const double total472 = total43*total47;
                    const double lost472 = lost43*total47 +
                        fma(total47, total43, -(total47*total43));
                    const double total482 = total45 - total472;
                    const double back292 = -total45 + total482;
                    const double rest112 = -back292 + total482;
                    const double one102 = -rest112 + total45;
                    const double two102 = -back292 - total472;
                    const double lost482 = one102 + two102;
                    const double low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                    const double total492 = given4*total482;
                    const double lost492 = given4*low24 + fma(given4, total482, -(given4*total482));
                    const double total502 = total40*total47;
                    const double lost502 = lift_low*total47 +
                        fma(total47, total40, -(total47*total40));
                    const double total512 = total492 + total502;
                    const double back302 = -total492 + total512;
                    const double rest122 = -back302 + total512;
                    const double one112 = -rest122 + total492;
                    const double two112 = -back302 + total502;
                    const double lost512 = one112 + two112;
                    const double low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                    const double total522 = total512/stiff;
                    const double left252 = -stiff*total522 + total512;
                    const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                    const double left272 = left262 + low33;
                    const double lost522 = left272/stiff;
                    const double total332 = 1.0 - total47;
                    const double back213 = total332 - 1.0;
                    const double lost332 = -back213 - total47;
                    const double low42 = -fall_low5 + lost332;
                    const double total342 = low42 + total332;
                    const double back222 = -total332 + total342;
                    const double lost342 = -back222 + low42;
                    const double total352 = (total342*total342);
                    const double lost352 = 2.0*lost342*total342 +
                        fma(total342, total342, -(total342*total342));
                    const double total372 = total352 + 2.0*total502;
                    const double back232 = -total352 + total372;
                    const double rest113 = -back232 + total372;
                    const double one103 = -rest113 + total352;
                    const double two103 = -back232 + 2.0*total502;
                    const double lost372 = one103 + two103;
                    const double low52 = 2.0*fall_low5*total40 + lost352 + lost372 + 2.0*lost502;
                    const double total382 = total372/stiff;
                    const double left163 = -stiff*total382 + total372;
                    const double left173 = left163 - fma(total382, stiff, -(total382*stiff));
                    const double left183 = left173 + low52;
                    const double lost382 = left183/stiff;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const double sine = sin(root);
                        even_low2 = -root_low*sine;
                    }
                    const double lost263 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                    apart_of = lost26 + total26;
                    fall_of = lost53 + total53;
                    nyquist_of = lost253 + lost263 + lost273 + total273;
                    rise_of = lost522 + total522;
                    together_of = lost382 + total382;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double back22 = -total34 + total35;
                    const double rest10 = -back22 + total35;
                    const double one9 = -rest10 + total34;
                    const double two9 = -back22 + low2;
                    const double lost35 = one9 + two9;
                    const double lost36 = fma(count, 6.283185307179586, -(count*6.283185307179586));
                    const double back23 = -root + total37;
                    const double rest11 = -back23 + total37;
                    const double one10 = -rest11 + root;
                    const double two10 = -back23 + total36;
                    const double lost37 = one10 + two10;
                    const double both_low = 2.4492935982947064e-16*count + lost36 + lost37 +
                        root_low;
                    const double left19 = total35 - total38*whole32;
                    const double left20 = left19 - fma(total38, whole32, -(total38*whole32));
                    const double left21 = -both_low*total38 + left20 + lost35;
                    const double lost38 = left21/whole32;
                    const double eta = total38;
                    const double eta_low = lost38;
                    const double total39 = (eta*eta);
                    const double lost39 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                    const double cos_series_of2 = cos_series(-total39);
                    const double bent2 = cos_series_of2*(total39*total39);
                    const double total40 = -bent2 + 0.5*total39;
                    const double back24 = -0.5*total39 + total40;
                    const double lost40 = -back24 - bent2;
                    const double sin_series_of2 = sin_series(-total39);
                    const double total41 = -sin_series_of2*total39 + 1.0;
                    const double back25 = total41 - 1.0;
                    const double lost41 = -back25 - sin_series_of2*total39;
                    const double lift_low = 0.5*lost39*total41 + lost40;
                    const double total42 = eta*total41;
                    const double lost42 = eta*lost41 + fma(eta, total41, -(eta*total41));
                    const double some2 = root;
                    const double total43 = total42/some2;
                    const double left22 = -some2*total43 + total42;
                    const double left23 = left22 - fma(total43, some2, -(total43*some2));
                    const double left24 = eta_low*(1.0 - total40) + left23 + lost42 - root_low*
                        total43;
                    const double lost43 = left24/some2;
                    const double given4 = half;
                    const double total44 = 1.0 - 0.5*given4;
                    const double back26 = total44 - 1.0;
                    const double lost44 = -back26 - 0.5*given4;
                    const double decay_series_of3 = decay_series(given4);
                    const double curved4 = decay_series_of3*(given4*given4);
                    const double total45 = curved4 + total44;
                    const double back27 = -total44 + total45;
                    const double lost45 = -back27 + curved4;
                    const double mean_low5 = lost44 + lost45;
                    const double total46 = given4*total45;
                    const double lost46 = given4*mean_low5 +
                        fma(given4, total45, -(given4*total45));
                    const double total47 = 1.0 - total46;
                    const double back28 = total47 - 1.0;
                    const double lost47 = -back28 - total46;
                    const double fall_low5 = -lost46 + lost47;
                    const double total48 = -total43 + total45;
                    const double back29 = -total45 + total48;
                    const double rest12 = -back29 + total48;
                    const double one11 = -rest12 + total45;
                    const double two11 = -back29 - total43;
                    const double lost48 = one11 + two11;
                    const double total49 = given4*total48;
                    const double lost49 = given4*(-lost43 + lost48 + mean_low5) +
                        fma(given4, total48, -(given4*total48));
                    const double total50 = total40 - total49;
                    const double back30 = -total40 + total50;
                    const double rest13 = -back30 + total50;
                    const double one12 = -rest13 + total40;
                    const double two12 = -back30 - total49;
                    const double lost50 = one12 + two12;
                    const double low22 = lift_low - lost49 + lost50;
                    const double total51 = low22 + total50;
                    const double back31 = -total50 + total51;
                    const double rest14 = -back31 + total51;
                    const double one13 = -rest14 + total50;
                    const double two13 = -back31 + low22;
                    const double lost51 = one13 + two13;
                    const double total52 = total47*total51;
                    const double lost52 = lost51*total47 +
                        fma(total47, total51, -(total47*total51));
                    const double low3 = fall_low5*total51 + lost52;
                    const double total53 = total52/stiff;
                    const double left25 = -stiff*total53 + total52;
                    const double left26 = left25 - fma(total53, stiff, -(total53*stiff));
                    const double left27 = left26 + low3;
                    const double lost53 = left27/stiff;
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double back72 = 0.5*root_low*sin_of;
                    const double total92 = -back72 + wave;
                    const double back82 = total92 - wave;
                    const double rest33 = -back82 + total92;
                    const double one23 = -rest33 + wave;
                    const double two23 = -back72 - back82;
                    const double lost92 = one23 + two23;
                    const double total102 = (total92*total92);
                    const double lost102 = fma(total92, total92, -(total92*total92));
                    const double low4 = lost102 + 2.0*lost92*total92;
                    const double total112 = envelope*total102;
                    const double lost112 = envelope*low4 +
                        fma(envelope, total102, -(envelope*total102));
                    const double total122 = (grown*grown) + total112;
                    const double back92 = -total112 + total122;
                    const double rest43 = -back92 + total122;
                    const double one33 = -rest43 + total112;
                    const double two33 = -back92 + (grown*grown);
                    const double lost122 = one33 + two33;
                    const double low23 = lost112 + lost122;
                    const double total472 = total43*total47;
                    const double lost472 = lost43*total47 +
                        fma(total47, total43, -(total47*total43));
                    const double total482 = total45 - total472;
                    const double back292 = -total45 + total482;
                    const double rest112 = -back292 + total482;
                    const double one102 = -rest112 + total45;
                    const double two102 = -back292 - total472;
                    const double lost482 = one102 + two102;
                    const double low24 = -fall_low5*total43 - lost472 + lost482 + mean_low5;
                    const double total492 = given4*total482;
                    const double lost492 = given4*low24 + fma(given4, total482, -(given4*total482));
                    const double total502 = total40*total47;
                    const double lost502 = lift_low*total47 +
                        fma(total47, total40, -(total47*total40));
                    const double total512 = total492 + total502;
                    const double back302 = -total492 + total512;
                    const double rest122 = -back302 + total512;
                    const double one112 = -rest122 + total492;
                    const double two112 = -back302 + total502;
                    const double lost512 = one112 + two112;
                    const double low33 = fall_low5*total40 + lost492 + lost502 + lost512;
                    const double total522 = total512/stiff;
                    const double left252 = -stiff*total522 + total512;
                    const double left262 = left252 - fma(total522, stiff, -(total522*stiff));
                    const double left272 = left262 + low33;
                    const double lost522 = left272/stiff;
                    const double total332 = 1.0 - total47;
                    const double back213 = total332 - 1.0;
                    const double lost332 = -back213 - total47;
                    const double low42 = -fall_low5 + lost332;
                    const double total342 = low42 + total332;
                    const double back222 = -total332 + total342;
                    const double lost342 = -back222 + low42;
                    const double total352 = (total342*total342);
                    const double lost352 = 2.0*lost342*total342 +
                        fma(total342, total342, -(total342*total342));
                    const double total372 = total352 + 2.0*total502;
                    const double back232 = -total352 + total372;
                    const double rest113 = -back232 + total372;
                    const double one103 = -rest113 + total352;
                    const double two103 = -back232 + 2.0*total502;
                    const double lost372 = one103 + two103;
                    const double low52 = 2.0*fall_low5*total40 + lost352 + lost372 + 2.0*lost502;
                    const double total382 = total372/stiff;
                    const double left163 = -stiff*total382 + total372;
                    const double left173 = left163 - fma(total382, stiff, -(total382*stiff));
                    const double left183 = left173 + low52;
                    const double lost382 = left183/stiff;
                    apart_of = lost26 + total26;
                    fall_of = lost53 + total53;
                    nyquist_of = 4.0*low23 + 4.0*total122;
                    rise_of = lost522 + total522;
                    together_of = lost382 + total382;
                }
            } else {
                if (total263 > 0.0) {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double total23 = half*odd;
                    const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
                    const double total252 = -even + total23;
                    const double back162 = -total23 + total252;
                    const double rest42 = -back162 + total252;
                    const double one32 = -rest42 + total23;
                    const double two32 = -back162 - even;
                    const double lost252 = one32 + two32;
                    const double total262 = envelope + total252;
                    const double back172 = -total252 + total262;
                    const double rest52 = -back172 + total262;
                    const double one42 = -rest52 + total252;
                    const double two42 = -back172 + envelope;
                    const double lost262 = one42 + two42;
                    const double total272 = envelope*total262;
                    const double total282 = total272/stiff;
                    const double left16 = -stiff*total282 + total272;
                    const double left17 = left16 - fma(total282, stiff, -(total282*stiff));
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double e = exp(-delta);
                    const double total253 = e + 1.0;
                    const double back182 = total253 - 1.0;
                    const double lost253 = -back182 + e;
                    const double total273 = total253 + total263;
                    const double back192 = -total253 + total273;
                    const double lost273 = -back192 + total263;
                    const double total242 = even + total23;
                    const double back163 = -even + total242;
                    const double rest44 = -back163 + total242;
                    const double one34 = even - rest44;
                    const double two34 = -back163 + total23;
                    const double lost242 = one34 + two34;
                    const double total254 = envelope*total242;
                    const double total264 = 1.0 - total254;
                    const double back173 = total264 - 1.0;
                    const double lost264 = -back173 - total254;
                    const double total274 = total264/stiff;
                    const double left162 = -stiff*total274 + total264;
                    const double left172 = left162 - fma(total274, stiff, -(total274*stiff));
                    const double back73 = -0.5*root_low*wave;
                    const double total93 = -back73 + sin_of;
                    const double back83 = -sin_of + total93;
                    const double rest35 = -back83 + total93;
                    const double one25 = -rest35 + sin_of;
                    const double two25 = -back73 - back83;
                    const double lost93 = one25 + two25;
                    const double total103 = (total93*total93);
                    const double lost103 = fma(total93, total93, -(total93*total93));
                    const double low5 = lost103 + 2.0*lost93*total93;
                    const double total113 = envelope*total103;
                    const double lost113 = envelope*low5 +
                        fma(envelope, total103, -(envelope*total103));
                    const double total123 = (grown*grown) + total113;
                    const double back93 = -total113 + total123;
                    const double rest45 = -back93 + total123;
                    const double one35 = -rest45 + total113;
                    const double two35 = -back93 + (grown*grown);
                    const double lost123 = one35 + two35;
                    const double low25 = lost113 + lost123;
                    const double total132 = total123/stiff;
                    const double left72 = -stiff*total132 + total123;
                    const double left82 = left72 - fma(total132, stiff, -(total132*stiff));
                    const double left92 = left82 + low25;
                    const double lost132 = left92/stiff;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const double sine = sin(root);
                        even_low2 = -root_low*sine;
                    }
                    const double lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                        fma(envelope, total262, -(envelope*total262));
                    const double left18 = left17 + lost272;
                    const double lost282 = left18/stiff;
                    const double lost263 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                    const double lost254 = envelope*(even_low2 + lost23 + lost242) +
                        fma(envelope, total242, -(envelope*total242));
                    const double left182 = left172 - lost254 + lost264;
                    const double lost274 = left182/stiff;
                    apart_of = lost26 + total26;
                    fall_of = lost282 + total282;
                    nyquist_of = lost253 + lost263 + lost273 + total273;
                    rise_of = lost274 + total274;
                    together_of = 4.0*lost132 + 4.0*total132;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double total23 = half*odd;
                    const double lost23 = half*odd_low2 + fma(half, odd, -(half*odd));
                    const double total252 = -even + total23;
                    const double back162 = -total23 + total252;
                    const double rest42 = -back162 + total252;
                    const double one32 = -rest42 + total23;
                    const double two32 = -back162 - even;
                    const double lost252 = one32 + two32;
                    const double total262 = envelope + total252;
                    const double back172 = -total252 + total262;
                    const double rest52 = -back172 + total262;
                    const double one42 = -rest52 + total252;
                    const double two42 = -back172 + envelope;
                    const double lost262 = one42 + two42;
                    const double total272 = envelope*total262;
                    const double total282 = total272/stiff;
                    const double left16 = -stiff*total282 + total272;
                    const double left17 = left16 - fma(total282, stiff, -(total282*stiff));
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double back72 = 0.5*root_low*sin_of;
                    const double total92 = -back72 + wave;
                    const double back82 = total92 - wave;
                    const double rest33 = -back82 + total92;
                    const double one23 = -rest33 + wave;
                    const double two23 = -back72 - back82;
                    const double lost92 = one23 + two23;
                    const double total102 = (total92*total92);
                    const double lost102 = fma(total92, total92, -(total92*total92));
                    const double low4 = lost102 + 2.0*lost92*total92;
                    const double total112 = envelope*total102;
                    const double lost112 = envelope*low4 +
                        fma(envelope, total102, -(envelope*total102));
                    const double total122 = (grown*grown) + total112;
                    const double back92 = -total112 + total122;
                    const double rest43 = -back92 + total122;
                    const double one33 = -rest43 + total112;
                    const double two33 = -back92 + (grown*grown);
                    const double lost122 = one33 + two33;
                    const double low23 = lost112 + lost122;
                    const double total242 = even + total23;
                    const double back163 = -even + total242;
                    const double rest44 = -back163 + total242;
                    const double one34 = even - rest44;
                    const double two34 = -back163 + total23;
                    const double lost242 = one34 + two34;
                    const double total254 = envelope*total242;
                    const double total264 = 1.0 - total254;
                    const double back173 = total264 - 1.0;
                    const double lost264 = -back173 - total254;
                    const double total274 = total264/stiff;
                    const double left162 = -stiff*total274 + total264;
                    const double left172 = left162 - fma(total274, stiff, -(total274*stiff));
                    const double back73 = -0.5*root_low*wave;
                    const double total93 = -back73 + sin_of;
                    const double back83 = -sin_of + total93;
                    const double rest35 = -back83 + total93;
                    const double one25 = -rest35 + sin_of;
                    const double two25 = -back73 - back83;
                    const double lost93 = one25 + two25;
                    const double total103 = (total93*total93);
                    const double lost103 = fma(total93, total93, -(total93*total93));
                    const double low5 = lost103 + 2.0*lost93*total93;
                    const double total113 = envelope*total103;
                    const double lost113 = envelope*low5 +
                        fma(envelope, total103, -(envelope*total103));
                    const double total123 = (grown*grown) + total113;
                    const double back93 = -total113 + total123;
                    const double rest45 = -back93 + total123;
                    const double one35 = -rest45 + total113;
                    const double two35 = -back93 + (grown*grown);
                    const double lost123 = one35 + two35;
                    const double low25 = lost113 + lost123;
                    const double total132 = total123/stiff;
                    const double left72 = -stiff*total132 + total123;
                    const double left82 = left72 - fma(total132, stiff, -(total132*stiff));
                    const double left92 = left82 + low25;
                    const double lost132 = left92/stiff;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const double sine = sin(root);
                        even_low2 = -root_low*sine;
                    }
                    const double lost272 = envelope*(-even_low2 + lost23 + lost252 + lost262) +
                        fma(envelope, total262, -(envelope*total262));
                    const double left18 = left17 + lost272;
                    const double lost282 = left18/stiff;
                    const double lost254 = envelope*(even_low2 + lost23 + lost242) +
                        fma(envelope, total242, -(envelope*total242));
                    const double left182 = left172 - lost254 + lost264;
                    const double lost274 = left182/stiff;
                    apart_of = lost26 + total26;
                    fall_of = lost282 + total282;
                    nyquist_of = 4.0*low23 + 4.0*total122;
                    rise_of = lost274 + total274;
                    together_of = 4.0*lost132 + 4.0*total132;
                }
            }
        }
    } else {
        const double size = fabs(total2);
        const double root = sqrt(size);
        const double total3 = half + root;
        const double reach = 0.4444444444444444*total3;
        if (reach < 1.0) {
            if (reach < 0.5625) {
                const double sign_low = lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back3 = -half + total3;
                const double lost3 = -back3 + root;
                const double p_low = lost3 + root_low;
                const double whole2 = (total3 == 0.0 ? 1.0 : total3);
                const double q = gamma/whole2;
                const double off = gamma - q*whole2;
                const double off2 = off - fma(whole2, q, -(whole2*q));
                const double off3 = off2 - p_low*q;
                const double q_low = off3/whole2;
                const double rate2 = 2.0*root;
                const double envelope = exp(-half);
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                const double given5 = 0.5*half;
                const double total54 = 1.0 - 0.5*given5;
                const double back32 = total54 - 1.0;
                const double lost54 = -back32 - 0.5*given5;
                const double decay_series_of4 = decay_series(given5);
                const double curved5 = decay_series_of4*(given5*given5);
                const double total55 = curved5 + total54;
                const double back33 = -total54 + total55;
                const double lost55 = -back33 + curved5;
                const double mean_low6 = lost54 + lost55;
                const double total56 = given5*total55;
                const double lost56 = given5*mean_low6 + fma(given5, total55, -(given5*total55));
                const double total57 = 1.0 - total56;
                const double back34 = total57 - 1.0;
                const double lost57 = -back34 - total56;
                const double fall_low6 = -lost56 + lost57;
                const double total58 = (total57*total57);
                const double lost58 = 2.0*fall_low6*total57 +
                    fma(total57, total57, -(total57*total57));
                const double total59 = (total58*total58);
                const double lost59 = 2.0*lost58*total58 +
                    fma(total58, total58, -(total58*total58));
                const double rest15 = fall_series(gamma, delta);
                const double total60 = rest15 + 0.5;
                const double back35 = -rest15 + total60;
                const double rest16 = -back35 + total60;
                const double one14 = rest15 - rest16;
                const double two14 = 0.5 - back35;
                const double lost60 = one14 + two14;
                const double total61 = total59*total60;
                const double lost61 = lost60*total59 + fma(total59, total60, -(total59*total60));
                const double half2 = half;
                const double given52 = 0.5*half2;
                const double total532 = 1.0 - 0.5*given52;
                const double back312 = total532 - 1.0;
                const double lost532 = -back312 - 0.5*given52;
                const double decay_series_of5 = decay_series(given52);
                const double curved52 = decay_series_of5*(given52*given52);
                const double total542 = curved52 + total532;
                const double back322 = -total532 + total542;
                const double lost542 = -back322 + curved52;
                const double mean_low62 = lost532 + lost542;
                const double total552 = given52*total542;
                const double lost552 = given52*mean_low62 +
                    fma(given52, total542, -(given52*total542));
                const double total562 = 1.0 - total552;
                const double back332 = total562 - 1.0;
                const double lost562 = -back332 - total552;
                const double fall_low62 = -lost552 + lost562;
                const double total572 = (total562*total562);
                const double lost572 = 2.0*fall_low62*total562 +
                    fma(total562, total562, -(total562*total562));
                const double rest132 = rise_series(half2, total2);
                const double total582 = rest132 + 0.5;
                const double back342 = -rest132 + total582;
                const double rest142 = -back342 + total582;
                const double one122 = rest132 - rest142;
                const double two122 = 0.5 - back342;
                const double lost582 = one122 + two122;
                const double total592 = total572*total582;
                const double lost592 = lost582*total572 +
                    fma(total572, total582, -(total572*total582));
                const double rest123 = together_series(half, total2);
                const double total553 = rest123 + 0.5;
                const double back333 = -rest123 + total553;
                const double rest133 = -back333 + total553;
                const double one113 = rest123 - rest133;
                const double two113 = 0.5 - back333;
                const double lost553 = one113 + two113;
                const double total563 = envelope*total553;
                const double lost563 = envelope*lost553 +
                    fma(envelope, total553, -(envelope*total553));
                double fall_;
                double fall_low2;
                if (q < 0.75) {
                    const double given = q;
                    const double total4 = 1.0 - 0.5*given;
                    const double back4 = total4 - 1.0;
                    const double lost4 = -back4 - 0.5*given;
                    const double decay_series_of = decay_series(given);
                    const double curved = decay_series_of*(given*given);
                    const double total5 = curved + total4;
                    const double back5 = -total4 + total5;
                    const double lost5 = -back5 + curved;
                    const double mean_low = lost4 + lost5 - q_low*
                        (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                    const double total6 = given*total5;
                    const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                    const double total7 = 1.0 - total6;
                    const double back6 = total7 - 1.0;
                    const double lost7 = -back6 - total6;
                    const double fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                } else {
                    const double sunk = exp(-q);
                    const double sunk_low = -q_low*sunk;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                }
                const double total283 = fall_ + 1.0;
                const double back202 = total283 - 1.0;
                const double lost283 = -back202 + fall_;
                double fall2;
                double fall_low4;
                if (rate2 < 0.75) {
                    const double given2 = 2.0*root;
                    const double total10 = 1.0 - 0.5*given2;
                    const double back8 = total10 - 1.0;
                    const double lost10 = -back8 - 0.5*given2;
                    const double decay_series_of2 = decay_series(given2);
                    const double curved2 = decay_series_of2*(given2*given2);
                    const double total11 = curved2 + total10;
                    const double back9 = -total10 + total11;
                    const double lost11 = -back9 + curved2;
                    const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                    const double total12 = given2*total11;
                    const double lost12 = given2*mean_low3 +
                        fma(given2, total11, -(given2*total11));
                    const double total13 = 1.0 - total12;
                    const double back10 = total13 - 1.0;
                    const double lost13 = -back10 - total12;
                    const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                    fall2 = total13;
                    fall_low4 = fall_low3;
                } else {
                    const double sunk2 = exp(-2.0*root);
                    const double sunk_low2 = -2.0*root_low*sunk2;
                    fall2 = sunk2;
                    fall_low4 = sunk_low2;
                }
                const double fast = fall_*fall2;
                const double lost292 = fall_*fall_low4 + fma(fall_, fall2, -(fall_*fall2));
                const double low32 = fall2*fall_low2 + lost292;
                const double total302 = fast + 1.0;
                const double back212 = total302 - 1.0;
                const double lost302 = -back212 + fast;
                const double total312 = total283*total302;
                const double lost312 = total283*(lost302 + low32) +
                    fma(total283, total302, -(total283*total302));
                apart_of = lost28 + total28;
                fall_of = lost59*total60 + lost61 + total61;
                nyquist_of = lost312 + total302*(fall_low2 + lost283) + total312;
                rise_of = lost572*total582 + lost592 + total592;
                together_of = 2.0*lost563 + 2.0*total563;
            } else {
                const double sign_low = lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double back3 = -half + total3;
                const double lost3 = -back3 + root;
                const double p_low = lost3 + root_low;
                const double whole2 = (total3 == 0.0 ? 1.0 : total3);
                const double q = gamma/whole2;
                const double off = gamma - q*whole2;
                const double off2 = off - fma(whole2, q, -(whole2*q));
                const double off3 = off2 - p_low*q;
                const double q_low = off3/whole2;
                const double rate2 = 2.0*root;
                const double envelope = exp(-half);
                const double rest5 = apart_series(half, total2);
                const double total27 = rest5 + 0.16666666666666666;
                const double back17 = -rest5 + total27;
                const double rest6 = -back17 + total27;
                const double one4 = rest5 - rest6;
                const double two4 = 0.16666666666666666 - back17;
                const double lost27 = one4 + two4;
                const double total28 = envelope*total27;
                const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
                const double rest123 = together_series(half, total2);
                const double total553 = rest123 + 0.5;
                const double back333 = -rest123 + total553;
                const double rest133 = -back333 + total553;
                const double one113 = rest123 - rest133;
                const double two113 = 0.5 - back333;
                const double lost553 = one113 + two113;
                const double total563 = envelope*total553;
                const double lost563 = envelope*lost553 +
                    fma(envelope, total553, -(envelope*total553));
                double fall_;
                double fall_low2;
                double mean;
                double mean_low2;
                if (q < 0.75) {
                    const double given = q;
                    const double total4 = 1.0 - 0.5*given;
                    const double back4 = total4 - 1.0;
                    const double lost4 = -back4 - 0.5*given;
                    const double decay_series_of = decay_series(given);
                    const double curved = decay_series_of*(given*given);
                    const double total5 = curved + total4;
                    const double back5 = -total4 + total5;
                    const double lost5 = -back5 + curved;
                    const double mean_low = lost4 + lost5 - q_low*
                        (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                    const double total6 = given*total5;
                    const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                    const double total7 = 1.0 - total6;
                    const double back6 = total7 - 1.0;
                    const double lost7 = -back6 - total6;
                    const double fall_low = -lost6 + lost7 - q_low*total5;
                    fall_ = total7;
                    fall_low2 = fall_low;
                    mean = total5;
                    mean_low2 = mean_low;
                } else {
                    const double sunk = exp(-q);
                    const double sunk_low = -q_low*sunk;
                    const double total8 = 1.0 - sunk;
                    const double back7 = total8 - 1.0;
                    const double lost8 = -back7 - sunk;
                    const double bottom = q;
                    const double total9 = total8/bottom;
                    const double left4 = -bottom*total9 + total8;
                    const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                    const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                    const double lost9 = left6/bottom;
                    fall_ = sunk;
                    fall_low2 = sunk_low;
                    mean = total9;
                    mean_low2 = lost9;
                }
                const double total283 = fall_ + 1.0;
                const double back202 = total283 - 1.0;
                const double lost283 = -back202 + fall_;
                double fall2;
                double fall_low4;
                double mean2;
                double mean_low4;
                if (rate2 < 0.75) {
                    const double given2 = 2.0*root;
                    const double total10 = 1.0 - 0.5*given2;
                    const double back8 = total10 - 1.0;
                    const double lost10 = -back8 - 0.5*given2;
                    const double decay_series_of2 = decay_series(given2);
                    const double curved2 = decay_series_of2*(given2*given2);
                    const double total11 = curved2 + total10;
                    const double back9 = -total10 + total11;
                    const double lost11 = -back9 + curved2;
                    const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                        (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                    const double total12 = given2*total11;
                    const double lost12 = given2*mean_low3 +
                        fma(given2, total11, -(given2*total11));
                    const double total13 = 1.0 - total12;
                    const double back10 = total13 - 1.0;
                    const double lost13 = -back10 - total12;
                    const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                    fall2 = total13;
                    fall_low4 = fall_low3;
                    mean2 = total11;
                    mean_low4 = mean_low3;
                } else {
                    const double sunk2 = exp(-2.0*root);
                    const double sunk_low2 = -2.0*root_low*sunk2;
                    const double total14 = 1.0 - sunk2;
                    const double back11 = total14 - 1.0;
                    const double lost14 = -back11 - sunk2;
                    const double bottom2 = 2.0*root;
                    const double total15 = total14/bottom2;
                    const double left7 = -bottom2*total15 + total14;
                    const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                    const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                    const double lost15 = left9/bottom2;
                    fall2 = sunk2;
                    fall_low4 = sunk_low2;
                    mean2 = total15;
                    mean_low4 = lost15;
                }
                const double fast = fall_*fall2;
                const double total162 = fall2*mean;
                const double lost162 = fall2*mean_low2 + fma(fall2, mean, -(fall2*mean));
                const double pulled_low = fall_low4*mean + lost162;
                const double total172 = mean2 - total162;
                const double back122 = -mean2 + total172;
                const double rest32 = -back122 + total172;
                const double one22 = mean2 - rest32;
                const double two22 = -back122 - total162;
                const double lost172 = one22 + two22;
                const double total182 = total172/whole2;
                const double left102 = total172 - total182*whole2;
                const double left112 = left102 - fma(total182, whole2, -(total182*whole2));
                const double left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
                const double lost182 = left122/whole2;
                const double total192 = fall_*total182;
                const double lost192 = fall_*lost182 + fma(fall_, total182, -(fall_*total182));
                const double creep_ = fall_low2*total182 + lost192 + total192;
                const double lost292 = fall_*fall_low4 + fma(fall_, fall2, -(fall_*fall2));
                const double low32 = fall2*fall_low2 + lost292;
                const double total302 = fast + 1.0;
                const double back212 = total302 - 1.0;
                const double lost302 = -back212 + fast;
                const double total312 = total283*total302;
                const double lost312 = total283*(lost302 + low32) +
                    fma(total283, total302, -(total283*total302));
                const double total163 = fall_*mean2;
                const double lost163 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
                const double pulled_low2 = fall_low2*mean2 + lost163;
                const double total173 = mean - total163;
                const double back123 = -mean + total173;
                const double rest34 = -back123 + total173;
                const double one24 = mean - rest34;
                const double two24 = -back123 - total163;
                const double lost173 = one24 + two24;
                const double total183 = total173/whole2;
                const double left103 = total173 - total183*whole2;
                const double left113 = left103 - fma(total183, whole2, -(total183*whole2));
                const double left123 = left113 + lost173 + mean_low2 - p_low*total183 - pulled_low2;
                const double lost183 = left123/whole2;
                apart_of = lost28 + total28;
                fall_of = creep_;
                nyquist_of = lost312 + total302*(fall_low2 + lost283) + total312;
                rise_of = lost183 + total183;
                together_of = 2.0*lost563 + 2.0*total563;
            }
        } else {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            const double whole3 = (delta*total3 == 0.0 ? 1.0 : delta*total3);
            double fall_;
            double fall_low2;
            double mean;
            double mean_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                const double total8 = 1.0 - sunk;
                const double back7 = total8 - 1.0;
                const double lost8 = -back7 - sunk;
                const double bottom = q;
                const double total9 = total8/bottom;
                const double left4 = -bottom*total9 + total8;
                const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const double lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            const double twice = 2.0*fall_;
            const double total283 = fall_ + 1.0;
            const double back202 = total283 - 1.0;
            const double lost283 = -back202 + fall_;
            double fall2;
            double fall_low4;
            double mean2;
            double mean_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                const double total14 = 1.0 - sunk2;
                const double back11 = total14 - 1.0;
                const double lost14 = -back11 - sunk2;
                const double bottom2 = 2.0*root;
                const double total15 = total14/bottom2;
                const double left7 = -bottom2*total15 + total14;
                const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                const double lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const double fast = fall_*fall2;
            const double total16 = mean2*twice;
            const double lost16 = mean_low4*twice + fma(twice, mean2, -(twice*mean2));
            const double total17 = mean - total16;
            const double back12 = -mean + total17;
            const double rest3 = -back12 + total17;
            const double one2 = mean - rest3;
            const double two2 = -back12 - total16;
            const double lost17 = one2 + two2;
            const double total18 = fast*mean;
            const double lost18 = fast*mean_low2 + fma(fast, mean, -(fast*mean));
            const double top = total17 + total18;
            const double low = -lost16 + lost17 + lost18 + mean_low2;
            const double total162 = fall2*mean;
            const double lost162 = fall2*mean_low2 + fma(fall2, mean, -(fall2*mean));
            const double pulled_low = fall_low4*mean + lost162;
            const double total172 = mean2 - total162;
            const double back122 = -mean2 + total172;
            const double rest32 = -back122 + total172;
            const double one22 = mean2 - rest32;
            const double two22 = -back122 - total162;
            const double lost172 = one22 + two22;
            const double total182 = total172/whole2;
            const double left102 = total172 - total182*whole2;
            const double left112 = left102 - fma(total182, whole2, -(total182*whole2));
            const double left122 = left112 + lost172 + mean_low4 - p_low*total182 - pulled_low;
            const double lost182 = left122/whole2;
            const double total192 = fall_*total182;
            const double lost192 = fall_*lost182 + fma(fall_, total182, -(fall_*total182));
            const double creep_ = fall_low2*total182 + lost192 + total192;
            const double lost292 = fall_*fall_low4 + fma(fall_, fall2, -(fall_*fall2));
            const double low32 = fall2*fall_low2 + lost292;
            const double total302 = fast + 1.0;
            const double back212 = total302 - 1.0;
            const double lost302 = -back212 + fast;
            const double total312 = total283*total302;
            const double lost312 = total283*(lost302 + low32) +
                fma(total283, total302, -(total283*total302));
            const double total163 = fall_*mean2;
            const double lost163 = fall_*mean_low4 + fma(fall_, mean2, -(fall_*mean2));
            const double pulled_low2 = fall_low2*mean2 + lost163;
            const double total173 = mean - total163;
            const double back123 = -mean + total173;
            const double rest34 = -back123 + total173;
            const double one24 = mean - rest34;
            const double two24 = -back123 - total163;
            const double lost173 = one24 + two24;
            const double total183 = total173/whole2;
            const double left103 = total173 - total183*whole2;
            const double left113 = left103 - fma(total183, whole2, -(total183*whole2));
            const double left123 = left113 + lost173 + mean_low2 - p_low*total183 - pulled_low2;
            const double lost183 = left123/whole2;
            const double total523 = 1.0 - fast;
            const double back323 = total523 - 1.0;
            const double lost523 = -back323 - fast;
            const double total533 = mean*total523;
            const double lost533 = mean*(lost523 - low32) + fma(mean, total523, -(mean*total523));
            const double moved_low = lost533 + mean_low2*total523;
            const double total543 = total533/whole2;
            const double left253 = total533 - total543*whole2;
            const double left263 = left253 - fma(total543, whole2, -(total543*whole2));
            const double left273 = left263 + moved_low - p_low*total543;
            const double lost543 = left273/whole2;
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
static double late_apart(double epsilon, double x, double x_low, double y, double y_low,
    double first, double last, double turned) {
    const double total = 1.0 - epsilon;
    const double back = total - 1.0;
    const double lost = -back - epsilon;
    const double total2 = epsilon*total;
    const double lost2 = epsilon*lost + fma(epsilon, total, -(epsilon*total));
    const double total3 = x*y;
    const double lost3 = x*y_low + fma(x, y, -(x*y));
    const double both_low = lost3 + x_low*y;
    const double total4 = total2*total3;
    const double lost4 = both_low*total2 + fma(total2, total3, -(total2*total3));
    const double low = lost2*total3 + lost4;
    const double total5 = first - 2.0*total4;
    const double back2 = -first + total5;
    const double rest = -back2 + total5;
    const double one = first - rest;
    const double two = -back2 - 2.0*total4;
    const double lost5 = one + two;
    const double total6 = -last + total5;
    const double back3 = -total5 + total6;
    const double rest2 = -back3 + total6;
    const double one2 = -rest2 + total5;
    const double two2 = -back3 - last;
    const double lost6 = one2 + two2;
    const double total7 = total6 + turned;
    const double back4 = -total6 + total7;
    const double rest3 = -back4 + total7;
    const double one3 = -rest3 + total6;
    const double two3 = -back4 + turned;
    const double lost7 = one3 + two3;
    const double rest4 = lost5 + lost6;
    const double rest5 = lost7 + rest4;
    const double rest6 = -2.0*low + rest5;
    return rest6 + total7;
}

// the fraction of a period in a delay
static double late_part(double d) {
    return d - floor(d);
}

// the root of a cubic on a piece where it bends one way
static double cubic_root(double k0, double k1, double k2, double k3, double low, double high,
    double rise_) {
    const double convex = (2.0*k2 + 3.0*k3*(high + low) > 0.0 ? 1.0 : -1.0);
    const double down = (convex*rise_ > 0.0 ? 1.0 : -1.0);
    double y = (down > 0.0 ? high : low);
    double moves = 1.0;
    for (int count_y = 0; count_y < 100; ++count_y) {
        if (moves == 0.0) { break; }
        const double steep = k1 + y*(2.0*k2 + 3.0*k3*y);
        const double some = (steep == 0.0 ? 1.0 : steep);
        const double move = (steep == 0.0 ? 0.0 : (k0 + y*(k1 + y*(k2 + k3*y)))/some);
        const double new_ = fmin(high, -move + y);
        const double new2 = fmax(low, new_);
        const double next_y = new2;
        const double next_moves = (down*(-new2 + y) > 0.0 ? 1.0 : 0.0);
        y = next_y;
        moves = next_moves;
    }
    return y;
}

// what the crossing on a piece, if there is one, adds
static double piece_turns(double k0, double k1, double k2, double k3, double low, double high,
    double at_low, double at_high, double zone, double alpha, double slope, double far, double n1,
    double loss, double together_, double apart_, double center, double beyond, double d) {
    if ((((at_high < 0.0) && (at_low >= 0.0)) || ((at_high >= 0.0) && (at_low < 0.0))) &&
        (high > low)) {
        const double x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const double y = (zone == 0.0 ? x : (zone == 1.0 ? center + x : 4.0 - x));
        const double rest = (zone == 0.0 ? 4.0 - x : (zone == 1.0 ? beyond - x : x));
        double turned4;
        if ((rest > 0.0) && (y > 0.0)) {
            const double off = (zone == 0.0 ? -center + x : (zone == 1.0 ? x : beyond - x));
            const double at = fmax(0.0, y);
            const double still = fmax(0.0, rest);
            const double sine = 2.0*sqrt(at*still);
            const double x2 = off*(2.0*loss - 4.0);
            const double y2 = loss*sine;
            const double halves = (x2 < 0.0 ? (y2 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned = atan2((x2 < 0.0 ? -y2 : y2), fabs(x2));
            const double x3 = -apart_*at + still*together_;
            const double y3 = n1*sine;
            const double halves2 = (x3 < 0.0 ? (y3 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned2 = atan2((x3 < 0.0 ? -y3 : y3), fabs(x3));
            const double x4 = alpha*still - at*far;
            const double y4 = sine*slope;
            const double halves3 = (x4 < 0.0 ? (y4 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned3 = atan2((x4 < 0.0 ? -y4 : y4), fabs(x4));
            const double half = atan2((at > 2.0 ? sqrt(still) : sqrt(at)),
                (at > 2.0 ? sqrt(at) : sqrt(still)));
            const double late = d + 2.0;
            const double halves4 = -halves + halves2 + halves3 - (at > 2.0 ? late : 0.0);
            const double share = 0.5*(-late*(at > 2.0 ? -2.0*half : 2.0*half) - turned + turned2 +
                turned3)/3.141592653589793;
            const double even = floor(0.5*halves4);
            const double left = -even + 0.5*halves4;
            const double turns = even + (left == 0.5 ? floor(share) + 1.0 :
                floor(left + share + 0.5));
            const double rises = (zone == 2.0 ? -1.0 : 1.0)*(at_high > at_low ? 1.0 : -1.0);
            turned4 = -2.0*rises*turns;
        } else {
            turned4 = 0.0;
        }
        return turned4;
    }
    return 0.0;
}

// what the crossings between two points add to the count
static double zone_turns(double k0, double k1, double k2, double k3, double low, double high,
    double at_low, double at_high, double zone, double alpha, double slope, double far, double n1,
    double loss, double together_, double apart_, double center, double beyond, double d) {
    const double disc = -3.0*k1*k3 + (k2*k2);
    const double some = (fabs(k2) < 24.0*fabs(k3) ? 3.0*k3 : 1.0);
    const double at = -k2/some;
    const double cut = ((at < high) && (at > low) && (fabs(k2) < 24.0*fabs(k3)) ? at : low);
    double one;
    double two;
    if (disc < 0.0) {
        one = low;
        two = low;
    } else {
        const double root = sqrt(fmax(0.0, disc));
        const double q = -k2 - (k2 < 0.0 ? -root : root);
        const double some2 = (fabs(q) < 24.0*fabs(k3) ? 3.0*k3 : 1.0);
        const double at2 = q/some2;
        const double cut2 = ((at2 < high) && (at2 > low) && (fabs(q) < 24.0*fabs(k3)) ? at2 : low);
        const double some3 = (fabs(k1) < 8.0*fabs(q) ? q : 1.0);
        const double at3 = k1/some3;
        const double cut3 = ((at3 < high) && (at3 > low) && (fabs(k1) < 8.0*fabs(q)) ? at3 : low);
        one = cut2;
        two = cut3;
    }
    const double less = fmin(one, two);
    const double more = fmax(one, two);
    const double first = fmin(cut, less);
    const double middle = fmax(cut, less);
    const double last = fmax(middle, more);
    const double middle2 = fmin(middle, more);
    const double height = first*(first*(first*k3 + k2) + k1) + k0;
    const double height2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2));
    const double height3 = k0 + last*(k1 + last*(k2 + k3*last));
    const double found = piece_turns(k0, k1, k2, k3, low, first, at_low, height, zone, alpha,
        slope, far, n1, loss, together_, apart_, center, beyond, d);
    const double found2 = found + piece_turns(k0, k1, k2, k3, first, middle2, height, height2,
        zone, alpha, slope, far, n1, loss, together_, apart_, center, beyond, d);
    const double found3 = found2 + piece_turns(k0, k1, k2, k3, middle2, last, height2, height3,
        zone, alpha, slope, far, n1, loss, together_, apart_, center, beyond, d);
    const double found4 = found3 + piece_turns(k0, k1, k2, k3, last, high, height3, at_high, zone,
        alpha, slope, far, n1, loss, together_, apart_, center, beyond, d);
    return found4;
}

// roots outside the unit circle, behind a fractional delay
static double late_roots(double alpha, double beta, double d, double m2, double m0, double at_one,
    double at_minus_one, double loss, double together_, double apart_) {
    const double slope = alpha + beta;
    const double wall_far = alpha + 2.0*beta;
    const double force = beta*slope;
    const double across = -m0 + m2;
    const double square = m0*m2;
    const double even = together_*(m0 + m2);
    const double linear = (across*across) - even;
    const double pushed_ = alpha*together_;
    const double lost = (loss*loss);
    const double near0 = (at_one - pushed_)*(at_one + pushed_);
    const double near1 = -(alpha*alpha)*linear - at_one*(2.0 - loss) - force*
        (together_*together_) + lost;
    const double near2 = -(alpha*alpha)*square - force*linear - loss + 1.0;
    const double near3 = -force*square;
    const double square2 = m0*m2;
    const double even2 = apart_*(m0 + m2);
    const double linear2 = (across*across) - even2;
    const double pushed2 = apart_*wall_far;
    const double lost2 = (loss*loss);
    const double far0 = (at_minus_one - pushed2)*(at_minus_one + pushed2);
    const double far1 = (apart_*apart_)*force - at_minus_one*(2.0 - loss) - linear2*
        (wall_far*wall_far) + lost2;
    const double far2 = force*linear2 - loss - square2*(wall_far*wall_far) + 1.0;
    const double far3 = force*square2;
    const double middle = 2.0*at_one/(2.0 - loss);
    const double rest = 2.0*at_minus_one/(2.0 - loss);
    const double sine = 0.25*middle*rest;
    const double tilt = -0.25*middle + 0.25*rest;
    const double real = -0.25*apart_*middle + 0.25*rest*together_;
    const double size = (across*across);
    const double lost3 = (loss*loss);
    const double one = (real*real) + sine*size;
    const double two = -real*(m0 + m2) + size*tilt;
    const double three = m0*m2;
    const double wave = 0.25*alpha*rest - 0.25*middle*wall_far;
    const double wall = sine*(slope*slope) + (wave*wave);
    const double own0 = lost3*sine - one*wall;
    const double own1 = -force*one + lost3*tilt - two*wall;
    const double own2 = -force*two - loss - three*wall + 1.0;
    const double own3 = -force*three;
    const double one2 = 0.5*middle;
    const double two2 = 0.5*rest;
    const double before = -one2*(-one2*(-one2*own3 + own2) + own1) + own0;
    const double after = own0 + two2*(own1 + two2*(own2 + own3*two2));
    const double zone = 0.0;
    const double zone2 = 1.0;
    const double zone3 = 2.0;
    const double side = (slope >= 0.0 ? 1.0 : -1.0);
    const double end = -d + (wall_far > 0.0 ? side : 0.0) +
        (apart_ > 0.0 ? (across >= 0.0 ? 1.0 : -1.0) : 0.0) - 3.0;
    const double total = (((((((near2 == 0.0) && (near3 < 0.0)) || (near2 < 0.0)) &&
        (near1 == 0.0)) || (near1 < 0.0)) && (near0 == 0.0)) || (near0 < 0.0) ?
        (alpha > 0.0 ? 0.0 : side) : 0.0) + zone_turns(far0, far1, far2, far3, zone, two2, far0,
        after, zone3, alpha, slope, wall_far, across, loss, together_, apart_, middle, rest, d) +
        zone_turns(near0, near1, near2, near3, zone, one2, near0, before, zone, alpha, slope,
        wall_far, across, loss, together_, apart_, middle, rest, d) +
        zone_turns(own0, own1, own2, own3, -one2, two2, before, after, zone2, alpha, slope,
        wall_far, across, loss, together_, apart_, middle, rest, d);
    return total - (((((((far2 == 0.0) && (far3 < 0.0)) || (far2 < 0.0)) && (far1 == 0.0)) ||
        (far1 < 0.0)) && (far0 == 0.0)) || (far0 < 0.0) ? end : 0.0);
}

// the same, or 1/2 where it is 0
static double some_part(double d) {
    const double part = d - floor(d);
    if (part == 0.0) {
        return 0.5;
    }
    return part;
}

// 1 where the loop is stable, else 0
static double stable(double roots, double alpha, double beta, double gamma, double delta) {
    const double swing_ = sqrt(gamma);
    if ((!((alpha == 0.0) && (beta == 0.0) && (delta == 0.0))) &&
        (!((delta < 1.1102230246251565e-15) && (gamma > 1.0) &&
        (swing_ >= 2251799813685248.0*fabs(sin(swing_))))) && (alpha > -gamma) && (roots == 0.0)) {
        return 1.0;
    }
    return 0.0;
}

// whole periods of a delay
static double whole_part(double d) {
    return floor(d);
}

// roots outside the unit circle
static double whole_roots(double alpha, double beta, double d, double n1, double n0, double at_one,
    double at_minus_one, double loss, double together_, double apart_) {
    const double e = 1.0 - loss;
    const double slope = alpha + beta;
    const double wall_far = alpha + 2.0*beta;
    const double force = beta*slope;
    const double cross = n0*n1;
    const double lost = (loss*loss);
    const double square = cross*force + e;
    const double push = alpha*together_;
    const double pull = apart_*wall_far;
    const double near0 = (at_one - push)*(at_one + push);
    const double near1 = (alpha*alpha)*cross - at_one*(e + 1.0) - force*(together_*together_) +
        lost;
    const double far0 = (at_minus_one - pull)*(at_minus_one + pull);
    const double far1 = (apart_*apart_)*force - at_minus_one*(e + 1.0) - cross*
        (wall_far*wall_far) + lost;
    const double center = 2.0*at_one/(e + 1.0);
    const double beyond = 2.0*at_minus_one/(e + 1.0);
    const double sine = 0.25*beyond*center;
    const double tilt = 0.25*beyond - 0.25*center;
    const double real = -0.25*apart_*center + 0.25*beyond*together_;
    const double m0 = (n1*n1)*sine + (real*real);
    const double m1 = (n1*n1)*tilt - n1*real;
    const double wave = 0.25*alpha*beyond - 0.25*center*wall_far;
    const double wall = sine*(slope*slope) + (wave*wave);
    const double own0 = lost*sine - m0*wall;
    const double own1 = -force*m0 + lost*tilt - m1*wall;
    const double own2 = e - force*m1;
    const double square2 = (near1*near1);
    const double product = 4.0*near0*square;
    const double size = square2 + fabs(product);
    const double square3 = (own1*own1);
    const double product2 = 4.0*own0*own2;
    const double size2 = square3 + fabs(product2);
    const double square4 = (far1*far1);
    const double product3 = 4.0*far0*square;
    const double size3 = square4 + fabs(product3);
    const double side = (slope >= 0.0 ? 1.0 : -1.0);
    const double end = -d + (wall_far > 0.0 ? side : 0.0) +
        (apart_ > 0.0 ? (n1 >= 0.0 ? 1.0 : -1.0) : 0.0) - 3.0;
    double disc4;
    if ((size >= size2) && (size2 <= size3)) {
        const double disc2 = -product2 + square3;
        disc4 = disc2;
    } else {
        if ((size > size3) && (size2 > size3)) {
            const double disc3 = -product3 + square4;
            disc4 = disc3;
        } else {
            const double disc = -product + square2;
            disc4 = disc;
        }
    }
    double total3;
    if (disc4 >= 0.0) {
        double low;
        double high;
        if (near1 >= 0.0) {
            const double positive = disc4;
            const double root = sqrt(positive);
            const double q = -0.5*near1 - 0.5*root;
            double one;
            if (square == 0.0) {
                one = -1.0;
            } else {
                const double lead_ = square;
                one = q/lead_;
            }
            double two;
            if (q == 0.0) {
                two = -1.0;
            } else {
                const double own = q;
                two = near0/own;
            }
            low = one;
            high = two;
        } else {
            const double positive = disc4;
            const double root = sqrt(positive);
            const double q = -0.5*near1 + 0.5*root;
            double one;
            if (square == 0.0) {
                one = -1.0;
            } else {
                const double lead_ = square;
                one = q/lead_;
            }
            double two;
            if (q == 0.0) {
                two = -1.0;
            } else {
                const double own = q;
                two = near0/own;
            }
            low = two;
            high = one;
        }
        double low3;
        double high3;
        if (far1 >= 0.0) {
            const double positive = disc4;
            const double root = sqrt(positive);
            const double q3 = -0.5*far1 - 0.5*root;
            double one3;
            if (square == 0.0) {
                one3 = -1.0;
            } else {
                const double lead3 = square;
                one3 = q3/lead3;
            }
            double two3;
            if (q3 == 0.0) {
                two3 = -1.0;
            } else {
                const double own4 = q3;
                two3 = far0/own4;
            }
            low3 = one3;
            high3 = two3;
        } else {
            const double positive = disc4;
            const double root = sqrt(positive);
            const double q3 = -0.5*far1 + 0.5*root;
            double one3;
            if (square == 0.0) {
                one3 = -1.0;
            } else {
                const double lead3 = square;
                one3 = q3/lead3;
            }
            double two3;
            if (q3 == 0.0) {
                two3 = -1.0;
            } else {
                const double own4 = q3;
                two3 = far0/own4;
            }
            low3 = two3;
            high3 = one3;
        }
        const double edge = (high3 > low ? low : high3);
        const double edge2 = (high < low3 ? high : low3);
        double found;
        if ((edge < 4.0) && (high3 > 0.0) && (low > 0.0)) {
            const double late = d + 2.0;
            double low2;
            if (own1 >= 0.0) {
                double one2;
                if (own2 == 0.0) {
                    one2 = -1.0;
                } else {
                    const double positive = disc4;
                    const double root = sqrt(positive);
                    const double q2 = -0.5*own1 - 0.5*root;
                    const double lead2 = own2;
                    one2 = q2/lead2;
                }
                low2 = one2;
            } else {
                const double positive = disc4;
                const double root = sqrt(positive);
                const double q2 = -0.5*own1 + 0.5*root;
                double two2;
                if (q2 == 0.0) {
                    two2 = -1.0;
                } else {
                    const double own3 = q2;
                    two2 = own0/own3;
                }
                low2 = two2;
            }
            const double at = ((beyond - low2 > 0.0) && (center + low2 > 0.0) &&
                (edge > fabs(low2)) ? center + low2 : (high3 > low ? low : 4.0 - high3));
            const double still = ((beyond - low2 > 0.0) && (center + low2 > 0.0) &&
                (edge > fabs(low2)) ? beyond - low2 : (high3 > low ? 4.0 - low : high3));
            const double away = ((beyond - low2 > 0.0) && (center + low2 > 0.0) &&
                (edge > fabs(low2)) ? low2 : (high3 > low ? -center + low : beyond - high3));
            const double at2 = at;
            const double still2 = still;
            const double at3 = fmax(0.0, at2);
            const double still3 = fmax(0.0, still2);
            const double sine2 = 2.0*sqrt(at3*still3);
            const double x = away*(-2.0*e - 2.0);
            const double y = loss*sine2;
            const double halves = (x < 0.0 ? (y < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned = atan2((x < 0.0 ? -y : y), fabs(x));
            const double x2 = -apart_*at3 + still3*together_;
            const double y2 = n1*sine2;
            const double halves2 = (x2 < 0.0 ? (y2 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned2 = atan2((x2 < 0.0 ? -y2 : y2), fabs(x2));
            const double x3 = alpha*still3 - at3*wall_far;
            const double y3 = sine2*slope;
            const double halves3 = (x3 < 0.0 ? (y3 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned3 = atan2((x3 < 0.0 ? -y3 : y3), fabs(x3));
            const double half = atan2((at3 > 2.0 ? sqrt(still3) : sqrt(at3)),
                (at3 > 2.0 ? sqrt(at3) : sqrt(still3)));
            const double halves4 = -halves + halves2 + halves3 - (at3 > 2.0 ? late : 0.0);
            const double share = 0.5*(-late*(at3 > 2.0 ? -2.0*half : 2.0*half) - turned + turned2 +
                turned3)/3.141592653589793;
            const double even = floor(0.5*halves4);
            const double left = -even + 0.5*halves4;
            const double turns = even + (left == 0.5 ? floor(share) + 1.0 :
                floor(left + share + 0.5));
            found = 2.0*turns;
        } else {
            found = 0.0;
        }
        const double total = found;
        double found2;
        if ((edge2 < 4.0) && (high > 0.0) && (low3 > 0.0)) {
            const double late2 = d + 2.0;
            double high2;
            if (own1 >= 0.0) {
                const double positive = disc4;
                const double root = sqrt(positive);
                const double q2 = -0.5*own1 - 0.5*root;
                double two2;
                if (q2 == 0.0) {
                    two2 = -1.0;
                } else {
                    const double own3 = q2;
                    two2 = own0/own3;
                }
                high2 = two2;
            } else {
                double one2;
                if (own2 == 0.0) {
                    one2 = -1.0;
                } else {
                    const double positive = disc4;
                    const double root = sqrt(positive);
                    const double q2 = -0.5*own1 + 0.5*root;
                    const double lead2 = own2;
                    one2 = q2/lead2;
                }
                high2 = one2;
            }
            const double at4 = ((beyond - high2 > 0.0) && (center + high2 > 0.0) &&
                (edge2 > fabs(high2)) ? center + high2 : (high < low3 ? high : 4.0 - low3));
            const double still4 = ((beyond - high2 > 0.0) && (center + high2 > 0.0) &&
                (edge2 > fabs(high2)) ? beyond - high2 : (high < low3 ? 4.0 - high : low3));
            const double away2 = ((beyond - high2 > 0.0) && (center + high2 > 0.0) &&
                (edge2 > fabs(high2)) ? high2 : (high < low3 ? -center + high : beyond - low3));
            const double at5 = at4;
            const double still5 = still4;
            const double at6 = fmax(0.0, at5);
            const double still6 = fmax(0.0, still5);
            const double sine3 = 2.0*sqrt(at6*still6);
            const double x4 = away2*(-2.0*e - 2.0);
            const double y4 = loss*sine3;
            const double halves5 = (x4 < 0.0 ? (y4 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned4 = atan2((x4 < 0.0 ? -y4 : y4), fabs(x4));
            const double x5 = -apart_*at6 + still6*together_;
            const double y5 = n1*sine3;
            const double halves6 = (x5 < 0.0 ? (y5 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned5 = atan2((x5 < 0.0 ? -y5 : y5), fabs(x5));
            const double x6 = alpha*still6 - at6*wall_far;
            const double y6 = sine3*slope;
            const double halves7 = (x6 < 0.0 ? (y6 < 0.0 ? -1.0 : 1.0) : 0.0);
            const double turned6 = atan2((x6 < 0.0 ? -y6 : y6), fabs(x6));
            const double half2 = atan2((at6 > 2.0 ? sqrt(still6) : sqrt(at6)),
                (at6 > 2.0 ? sqrt(at6) : sqrt(still6)));
            const double halves8 = -halves5 + halves6 + halves7 - (at6 > 2.0 ? late2 : 0.0);
            const double share2 = 0.5*(-late2*(at6 > 2.0 ? -2.0*half2 : 2.0*half2) - turned4 +
                turned5 + turned6)/3.141592653589793;
            const double even2 = floor(0.5*halves8);
            const double left2 = -even2 + 0.5*halves8;
            const double turns2 = even2 + (left2 == 0.5 ? floor(share2) + 1.0 :
                floor(left2 + share2 + 0.5));
            found2 = -2.0*turns2;
        } else {
            found2 = 0.0;
        }
        const double total2 = found2 + total;
        total3 = total2;
    } else {
        total3 = 0.0;
    }
    const double total4 = total3 + (((((near1 == 0.0) && (square < 0.0)) || (near1 < 0.0)) &&
        (near0 == 0.0)) || (near0 < 0.0) ? (alpha > 0.0 ? 0.0 : side) : 0.0);
    return total4 - (((((far1 == 0.0) && (square < 0.0)) || (far1 < 0.0)) && (far0 == 0.0)) ||
        (far0 < 0.0) ? end : 0.0);
}

// the imaginary part of A/(z M) at z = exp(2 j psi); the real part of A/(z M) at z = exp(2 j psi)
static void ahead_in_phase(double psi, double at_one, double at_minus_one, double loss,
    double together_, double apart_, double across, double *ahead_out, double *in_phase_out) {
    const double t = tan(psi);
    const double square = (t*t);
    const double low = fma(t, t, -(t*t));
    const double taken = at_minus_one*square;
    const double total = at_one - taken;
    const double back = -at_one + total;
    const double rest = -back + total;
    const double one = at_one - rest;
    const double two = -back - taken;
    const double lost = one + two;
    const double missed = at_minus_one*low + fma(at_minus_one, square, -(at_minus_one*square));
    const double lost2 = lost - missed;
    const double total2 = lost2 + total;
    const double back2 = -total + total2;
    const double lost3 = -back2 + lost2;
    const double taken2 = apart_*square;
    const double total3 = -taken2 + together_;
    const double back3 = -together_ + total3;
    const double rest2 = -back3 + total3;
    const double one2 = -rest2 + together_;
    const double two2 = -back3 - taken2;
    const double lost4 = one2 + two2;
    const double missed2 = apart_*low + fma(apart_, square, -(apart_*square));
    const double lost5 = lost4 - missed2;
    const double total4 = lost5 + total3;
    const double back4 = -total3 + total4;
    const double lost6 = -back4 + lost5;
    const double above_j = 2.0*loss*t;
    const double below_j = across*t;
    const double rest3 = (below_j*below_j) + 2.0*lost6*total4;
    const double size = rest3 + (total4*total4);
    const double low2 = above_j*lost6 - below_j*lost3;
    const double found = above_j*total4 - below_j*total2;
    const double found2 = found + low2;
    const double ahead_of = found2/size;
    const double low22 = lost3*total4 + lost6*total2;
    const double rest4 = above_j*below_j + low22;
    const double found3 = rest4 + total2*total4;
    const double in_phase_of = found3/size;
    *ahead_out = ahead_of;
    *in_phase_out = in_phase_of;
    return;
}

// (n1 - n0)/delta; 1 + a + e; n1 + n0
static void apart_nyquist_together(double gamma, double delta, double *apart_out,
    double *nyquist_out, double *together_out) {
    const double half = 0.5*delta;
    const double square = (half*half);
    const double total = -gamma + square;
    const double back = -square + total;
    const double rest = -back + total;
    const double one = -rest + square;
    const double two = -back - gamma;
    const double lost = one + two;
    const double rest2 = lost + fma(half, half, -(half*half));
    const double total2 = rest2 + total;
    const double back2 = -total + total2;
    const double lost2 = -back2 + rest2;
    double apart_of;
    double nyquist_of;
    double together_of;
    if (total2 < 0.0) {
        const double reach = 0.25*gamma;
        if (reach < 1.0) {
            const double square2 = total2;
            const double envelope = exp(-half);
            const double rest5 = apart_series(half, total2);
            const double total27 = rest5 + 0.16666666666666666;
            const double back17 = -rest5 + total27;
            const double rest6 = -back17 + total27;
            const double one4 = rest5 - rest6;
            const double two4 = 0.16666666666666666 - back17;
            const double lost27 = one4 + two4;
            const double total28 = envelope*total27;
            const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
            const double twice2 = 2.0*envelope;
            const double rest12 = together_series(half, total2);
            const double total55 = rest12 + 0.5;
            const double back33 = -rest12 + total55;
            const double rest13 = -back33 + total55;
            const double one11 = rest12 - rest13;
            const double two11 = 0.5 - back33;
            const double lost55 = one11 + two11;
            const double total56 = envelope*total55;
            const double lost56 = envelope*lost55 + fma(envelope, total55, -(envelope*total55));
            double even;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total19 = 0.5*given3 + 1.0;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total20 = curved3 + total19;
                even = total20;
            } else {
                const double size = fabs(total2);
                const double root = sqrt(size);
                const double cosine = cos(root);
                even = cosine;
            }
            const double total262 = even*twice2;
            if (total262 > 0.0) {
                const double e = exp(-delta);
                const double total252 = e + 1.0;
                const double back18 = total252 - 1.0;
                const double lost252 = -back18 + e;
                const double total272 = total252 + total262;
                const double back19 = -total252 + total272;
                const double lost272 = -back19 + total262;
                double even_low2;
                if (square2 > -1.5) {
                    const double given3 = square2;
                    const double total19 = 0.5*given3 + 1.0;
                    const double back13 = total19 - 1.0;
                    const double lost19 = -back13 + 0.5*given3;
                    const double cos_series_of = cos_series(given3);
                    const double curved3 = cos_series_of*(given3*given3);
                    const double total20 = curved3 + total19;
                    const double back14 = -total19 + total20;
                    const double lost20 = -back14 + curved3;
                    const double even_low = lost19 + 0.5*lost2 + lost20;
                    even_low2 = even_low;
                } else {
                    const double size = fabs(total2);
                    const double root = sqrt(size);
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double sine = sin(root);
                    even_low2 = -root_low*sine;
                }
                const double lost262 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                apart_of = lost28 + total28;
                nyquist_of = lost252 + lost262 + lost272 + total272;
                together_of = 2.0*lost56 + 2.0*total56;
            } else {
                const double size = fabs(total2);
                const double root = sqrt(size);
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double expm1_of = expm1(-half);
                const double grown = -0.5*expm1_of;
                const double angle = 0.5*root;
                const double wave = cos(angle);
                const double sin_of = sin(angle);
                const double back72 = 0.5*root_low*sin_of;
                const double total92 = -back72 + wave;
                const double back82 = total92 - wave;
                const double rest32 = -back82 + total92;
                const double one22 = -rest32 + wave;
                const double two22 = -back72 - back82;
                const double lost92 = one22 + two22;
                const double total102 = (total92*total92);
                const double lost102 = fma(total92, total92, -(total92*total92));
                const double low2 = lost102 + 2.0*lost92*total92;
                const double total112 = envelope*total102;
                const double lost112 = envelope*low2 +
                    fma(envelope, total102, -(envelope*total102));
                const double total122 = (grown*grown) + total112;
                const double back92 = -total112 + total122;
                const double rest42 = -back92 + total122;
                const double one32 = -rest42 + total112;
                const double two32 = -back92 + (grown*grown);
                const double lost122 = one32 + two32;
                const double low22 = lost112 + lost122;
                apart_of = lost28 + total28;
                nyquist_of = 4.0*low22 + 4.0*total122;
                together_of = 2.0*lost56 + 2.0*total56;
            }
        } else {
            const double size = fabs(total2);
            const double root = sqrt(size);
            const double square2 = total2;
            const double envelope = exp(-half);
            const double stiff = gamma;
            const double mean3 = decay(delta);
            const double twice2 = 2.0*envelope;
            double even;
            double odd;
            double odd_low2;
            if (square2 > -1.5) {
                const double given3 = square2;
                const double total19 = 0.5*given3 + 1.0;
                const double cos_series_of = cos_series(given3);
                const double curved3 = cos_series_of*(given3*given3);
                const double total20 = curved3 + total19;
                const double sin_series_of = sin_series(given3);
                const double bent = given3*sin_series_of;
                const double total21 = bent + 1.0;
                const double back15 = total21 - 1.0;
                const double lost21 = -back15 + bent;
                const double odd_low = 0.16666666666666666*lost2 + lost21;
                even = total20;
                odd = total21;
                odd_low2 = odd_low;
            } else {
                const double sign_low = -lost2;
                const double left = -(root*root) + size;
                const double left2 = left - fma(root, root, -(root*root));
                const double left3 = left2 + sign_low;
                const double whole = (root == 0.0 ? 1.0 : root);
                const double root_low = 0.5*left3/whole;
                const double sine = sin(root);
                const double cosine = cos(root);
                const double some = root;
                const double total22 = sine/some;
                const double left10 = sine - some*total22;
                const double left11 = left10 - fma(total22, some, -(total22*some));
                const double left12 = cosine*root_low + left11 - root_low*total22;
                const double lost22 = left12/some;
                even = cosine;
                odd = total22;
                odd_low2 = lost22;
            }
            const double total24 = envelope*odd;
            const double lost24 = envelope*odd_low2 + fma(envelope, odd, -(envelope*odd));
            const double total25 = mean3 - total24;
            const double back16 = -mean3 + total25;
            const double rest4 = -back16 + total25;
            const double one3 = mean3 - rest4;
            const double two3 = -back16 - total24;
            const double lost25 = one3 + two3;
            const double total26 = total25/stiff;
            const double left13 = -stiff*total26 + total25;
            const double left14 = left13 - fma(total26, stiff, -(total26*stiff));
            const double left15 = left14 - lost24 + lost25;
            const double lost26 = left15/stiff;
            const double total262 = even*twice2;
            double count;
            if (root < 67108864.0) {
                count = floor(0.5*root/3.141592653589793 + 0.5);
            } else {
                count = 0.0;
            }
            const double turns = (count*count);
            const double total142 = 39.47841760435743*turns;
            const double lost142 = fma(turns, 39.47841760435743, -(turns*39.47841760435743));
            const double total152 = 2.5061182034958845e-15*turns;
            const double lost152 = fma(turns, 2.5061182034958845e-15,
                -(turns*2.5061182034958845e-15));
            const double total162 = -total142 - total2;
            const double back102 = total162 + total2;
            const double rest52 = -back102 + total162;
            const double one42 = -rest52 - total2;
            const double two42 = -back102 - total142;
            const double lost162 = one42 + two42;
            const double total172 = -lost142 + total162;
            const double back112 = -total162 + total172;
            const double rest62 = -back112 + total172;
            const double one5 = -rest62 + total162;
            const double two5 = -back112 - lost142;
            const double lost172 = one5 + two5;
            const double total182 = -total152 + total172;
            const double back122 = -total172 + total182;
            const double rest7 = -back122 + total182;
            const double one6 = -rest7 + total172;
            const double two6 = -back122 - total152;
            const double lost182 = one6 + two6;
            const double total192 = -lost2 + total182;
            const double back132 = -total182 + total192;
            const double rest8 = -back132 + total192;
            const double one7 = -rest8 + total182;
            const double two7 = -back132 - lost2;
            const double lost192 = one7 + two7;
            const double low32 = -lost152 + lost162 + lost172 + lost182 + lost192 -
                1.4920070805839235e-31*turns;
            const double total202 = low32 + total192;
            const double total212 = 6.283185307179586*count;
            const double total222 = root + total212;
            const double whole32 = (total222 == 0.0 ? 1.0 : total222);
            const double total232 = total202/whole32;
            const double far = (total232*total232);
            if (total262 > 0.0) {
                if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double e = exp(-delta);
                    const double total252 = e + 1.0;
                    const double back18 = total252 - 1.0;
                    const double lost252 = -back18 + e;
                    const double total272 = total252 + total262;
                    const double back19 = -total252 + total272;
                    const double lost272 = -back19 + total262;
                    const double back142 = -total192 + total202;
                    const double rest9 = -back142 + total202;
                    const double one8 = -rest9 + total192;
                    const double two8 = -back142 + low32;
                    const double lost202 = one8 + two8;
                    const double lost212 = fma(count, 6.283185307179586,
                        -(count*6.283185307179586));
                    const double back152 = -root + total222;
                    const double rest10 = -back152 + total222;
                    const double one9 = -rest10 + root;
                    const double two9 = -back152 + total212;
                    const double lost222 = one9 + two9;
                    const double both_low = 2.4492935982947064e-16*count + lost212 + lost222 +
                        root_low;
                    const double left102 = total202 - total232*whole32;
                    const double left112 = left102 - fma(total232, whole32, -(total232*whole32));
                    const double left122 = -both_low*total232 + left112 + lost202;
                    const double lost232 = left122/whole32;
                    const double eta = total232;
                    const double eta_low = lost232;
                    const double total242 = (eta*eta);
                    const double lost242 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                    const double cos_series_of2 = cos_series(-total242);
                    const double bent2 = cos_series_of2*(total242*total242);
                    const double total253 = -bent2 + 0.5*total242;
                    const double back162 = -0.5*total242 + total253;
                    const double lost253 = -back162 - bent2;
                    const double sin_series_of2 = sin_series(-total242);
                    const double total263 = -sin_series_of2*total242 + 1.0;
                    const double lift_low = 0.5*lost242*total263 + lost253;
                    const double given22 = half;
                    const double total29 = 1.0 - 0.5*given22;
                    const double back182 = total29 - 1.0;
                    const double lost292 = -back182 - 0.5*given22;
                    const double decay_series_of3 = decay_series(given22);
                    const double curved22 = decay_series_of3*(given22*given22);
                    const double total302 = curved22 + total29;
                    const double back192 = -total29 + total302;
                    const double lost302 = -back192 + curved22;
                    const double mean_low5 = lost292 + lost302;
                    const double total312 = given22*total302;
                    const double lost312 = given22*mean_low5 +
                        fma(given22, total302, -(given22*total302));
                    const double total32 = 1.0 - total312;
                    const double back202 = total32 - 1.0;
                    const double lost32 = -back202 - total312;
                    const double fall_low5 = -lost312 + lost32;
                    const double total33 = 1.0 - total32;
                    const double back212 = total33 - 1.0;
                    const double lost33 = -back212 - total32;
                    const double low42 = -fall_low5 + lost33;
                    const double total34 = low42 + total33;
                    const double back22 = -total33 + total34;
                    const double lost34 = -back22 + low42;
                    const double total35 = (total34*total34);
                    const double lost35 = 2.0*lost34*total34 +
                        fma(total34, total34, -(total34*total34));
                    const double total36 = total253*total32;
                    const double lost36 = lift_low*total32 +
                        fma(total32, total253, -(total32*total253));
                    const double total37 = total35 + 2.0*total36;
                    const double back23 = -total35 + total37;
                    const double rest11 = -back23 + total37;
                    const double one10 = -rest11 + total35;
                    const double two10 = -back23 + 2.0*total36;
                    const double lost37 = one10 + two10;
                    const double low5 = 2.0*fall_low5*total253 + lost35 + 2.0*lost36 + lost37;
                    const double total38 = total37/stiff;
                    const double left16 = -stiff*total38 + total37;
                    const double left17 = left16 - fma(total38, stiff, -(total38*stiff));
                    const double left18 = left17 + low5;
                    const double lost38 = left18/stiff;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const double sine = sin(root);
                        even_low2 = -root_low*sine;
                    }
                    const double lost262 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                    apart_of = lost26 + total26;
                    nyquist_of = lost252 + lost262 + lost272 + total272;
                    together_of = lost38 + total38;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double e = exp(-delta);
                    const double total252 = e + 1.0;
                    const double back18 = total252 - 1.0;
                    const double lost252 = -back18 + e;
                    const double total272 = total252 + total262;
                    const double back19 = -total252 + total272;
                    const double lost272 = -back19 + total262;
                    const double back73 = -0.5*root_low*wave;
                    const double total93 = -back73 + sin_of;
                    const double back83 = -sin_of + total93;
                    const double rest33 = -back83 + total93;
                    const double one23 = -rest33 + sin_of;
                    const double two23 = -back73 - back83;
                    const double lost93 = one23 + two23;
                    const double total103 = (total93*total93);
                    const double lost103 = fma(total93, total93, -(total93*total93));
                    const double low4 = lost103 + 2.0*lost93*total93;
                    const double total113 = envelope*total103;
                    const double lost113 = envelope*low4 +
                        fma(envelope, total103, -(envelope*total103));
                    const double total123 = (grown*grown) + total113;
                    const double back93 = -total113 + total123;
                    const double rest43 = -back93 + total123;
                    const double one33 = -rest43 + total113;
                    const double two33 = -back93 + (grown*grown);
                    const double lost123 = one33 + two33;
                    const double low23 = lost113 + lost123;
                    const double total132 = total123/stiff;
                    const double left72 = -stiff*total132 + total123;
                    const double left82 = left72 - fma(total132, stiff, -(total132*stiff));
                    const double left92 = left82 + low23;
                    const double lost132 = left92/stiff;
                    double even_low2;
                    if (square2 > -1.5) {
                        const double given3 = square2;
                        const double total19 = 0.5*given3 + 1.0;
                        const double back13 = total19 - 1.0;
                        const double lost19 = -back13 + 0.5*given3;
                        const double cos_series_of = cos_series(given3);
                        const double curved3 = cos_series_of*(given3*given3);
                        const double total20 = curved3 + total19;
                        const double back14 = -total19 + total20;
                        const double lost20 = -back14 + curved3;
                        const double even_low = lost19 + 0.5*lost2 + lost20;
                        even_low2 = even_low;
                    } else {
                        const double sine = sin(root);
                        even_low2 = -root_low*sine;
                    }
                    const double lost262 = even_low2*twice2 + fma(twice2, even, -(twice2*even));
                    apart_of = lost26 + total26;
                    nyquist_of = lost252 + lost262 + lost272 + total272;
                    together_of = 4.0*lost132 + 4.0*total132;
                }
            } else {
                if ((count > 0.0) && (far < 1.5) && (half < 0.75)) {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double back72 = 0.5*root_low*sin_of;
                    const double total92 = -back72 + wave;
                    const double back82 = total92 - wave;
                    const double rest32 = -back82 + total92;
                    const double one22 = -rest32 + wave;
                    const double two22 = -back72 - back82;
                    const double lost92 = one22 + two22;
                    const double total102 = (total92*total92);
                    const double lost102 = fma(total92, total92, -(total92*total92));
                    const double low2 = lost102 + 2.0*lost92*total92;
                    const double total112 = envelope*total102;
                    const double lost112 = envelope*low2 +
                        fma(envelope, total102, -(envelope*total102));
                    const double total122 = (grown*grown) + total112;
                    const double back92 = -total112 + total122;
                    const double rest42 = -back92 + total122;
                    const double one32 = -rest42 + total112;
                    const double two32 = -back92 + (grown*grown);
                    const double lost122 = one32 + two32;
                    const double low22 = lost112 + lost122;
                    const double back142 = -total192 + total202;
                    const double rest9 = -back142 + total202;
                    const double one8 = -rest9 + total192;
                    const double two8 = -back142 + low32;
                    const double lost202 = one8 + two8;
                    const double lost212 = fma(count, 6.283185307179586,
                        -(count*6.283185307179586));
                    const double back152 = -root + total222;
                    const double rest10 = -back152 + total222;
                    const double one9 = -rest10 + root;
                    const double two9 = -back152 + total212;
                    const double lost222 = one9 + two9;
                    const double both_low = 2.4492935982947064e-16*count + lost212 + lost222 +
                        root_low;
                    const double left102 = total202 - total232*whole32;
                    const double left112 = left102 - fma(total232, whole32, -(total232*whole32));
                    const double left122 = -both_low*total232 + left112 + lost202;
                    const double lost232 = left122/whole32;
                    const double eta = total232;
                    const double eta_low = lost232;
                    const double total242 = (eta*eta);
                    const double lost242 = 2.0*eta*eta_low + fma(eta, eta, -(eta*eta));
                    const double cos_series_of2 = cos_series(-total242);
                    const double bent2 = cos_series_of2*(total242*total242);
                    const double total253 = -bent2 + 0.5*total242;
                    const double back162 = -0.5*total242 + total253;
                    const double lost253 = -back162 - bent2;
                    const double sin_series_of2 = sin_series(-total242);
                    const double total263 = -sin_series_of2*total242 + 1.0;
                    const double lift_low = 0.5*lost242*total263 + lost253;
                    const double given22 = half;
                    const double total29 = 1.0 - 0.5*given22;
                    const double back182 = total29 - 1.0;
                    const double lost292 = -back182 - 0.5*given22;
                    const double decay_series_of3 = decay_series(given22);
                    const double curved22 = decay_series_of3*(given22*given22);
                    const double total302 = curved22 + total29;
                    const double back192 = -total29 + total302;
                    const double lost302 = -back192 + curved22;
                    const double mean_low5 = lost292 + lost302;
                    const double total312 = given22*total302;
                    const double lost312 = given22*mean_low5 +
                        fma(given22, total302, -(given22*total302));
                    const double total32 = 1.0 - total312;
                    const double back202 = total32 - 1.0;
                    const double lost32 = -back202 - total312;
                    const double fall_low5 = -lost312 + lost32;
                    const double total33 = 1.0 - total32;
                    const double back212 = total33 - 1.0;
                    const double lost33 = -back212 - total32;
                    const double low42 = -fall_low5 + lost33;
                    const double total34 = low42 + total33;
                    const double back22 = -total33 + total34;
                    const double lost34 = -back22 + low42;
                    const double total35 = (total34*total34);
                    const double lost35 = 2.0*lost34*total34 +
                        fma(total34, total34, -(total34*total34));
                    const double total36 = total253*total32;
                    const double lost36 = lift_low*total32 +
                        fma(total32, total253, -(total32*total253));
                    const double total37 = total35 + 2.0*total36;
                    const double back23 = -total35 + total37;
                    const double rest11 = -back23 + total37;
                    const double one10 = -rest11 + total35;
                    const double two10 = -back23 + 2.0*total36;
                    const double lost37 = one10 + two10;
                    const double low5 = 2.0*fall_low5*total253 + lost35 + 2.0*lost36 + lost37;
                    const double total38 = total37/stiff;
                    const double left16 = -stiff*total38 + total37;
                    const double left17 = left16 - fma(total38, stiff, -(total38*stiff));
                    const double left18 = left17 + low5;
                    const double lost38 = left18/stiff;
                    apart_of = lost26 + total26;
                    nyquist_of = 4.0*low22 + 4.0*total122;
                    together_of = lost38 + total38;
                } else {
                    const double sign_low = -lost2;
                    const double left = -(root*root) + size;
                    const double left2 = left - fma(root, root, -(root*root));
                    const double left3 = left2 + sign_low;
                    const double whole = (root == 0.0 ? 1.0 : root);
                    const double root_low = 0.5*left3/whole;
                    const double expm1_of = expm1(-half);
                    const double grown = -0.5*expm1_of;
                    const double angle = 0.5*root;
                    const double wave = cos(angle);
                    const double sin_of = sin(angle);
                    const double back72 = 0.5*root_low*sin_of;
                    const double total92 = -back72 + wave;
                    const double back82 = total92 - wave;
                    const double rest32 = -back82 + total92;
                    const double one22 = -rest32 + wave;
                    const double two22 = -back72 - back82;
                    const double lost92 = one22 + two22;
                    const double total102 = (total92*total92);
                    const double lost102 = fma(total92, total92, -(total92*total92));
                    const double low2 = lost102 + 2.0*lost92*total92;
                    const double total112 = envelope*total102;
                    const double lost112 = envelope*low2 +
                        fma(envelope, total102, -(envelope*total102));
                    const double total122 = (grown*grown) + total112;
                    const double back92 = -total112 + total122;
                    const double rest42 = -back92 + total122;
                    const double one32 = -rest42 + total112;
                    const double two32 = -back92 + (grown*grown);
                    const double lost122 = one32 + two32;
                    const double low22 = lost112 + lost122;
                    const double back73 = -0.5*root_low*wave;
                    const double total93 = -back73 + sin_of;
                    const double back83 = -sin_of + total93;
                    const double rest33 = -back83 + total93;
                    const double one23 = -rest33 + sin_of;
                    const double two23 = -back73 - back83;
                    const double lost93 = one23 + two23;
                    const double total103 = (total93*total93);
                    const double lost103 = fma(total93, total93, -(total93*total93));
                    const double low4 = lost103 + 2.0*lost93*total93;
                    const double total113 = envelope*total103;
                    const double lost113 = envelope*low4 +
                        fma(envelope, total103, -(envelope*total103));
                    const double total123 = (grown*grown) + total113;
                    const double back93 = -total113 + total123;
                    const double rest43 = -back93 + total123;
                    const double one33 = -rest43 + total113;
                    const double two33 = -back93 + (grown*grown);
                    const double lost123 = one33 + two33;
                    const double low23 = lost113 + lost123;
                    const double total132 = total123/stiff;
                    const double left72 = -stiff*total132 + total123;
                    const double left82 = left72 - fma(total132, stiff, -(total132*stiff));
                    const double left92 = left82 + low23;
                    const double lost132 = left92/stiff;
                    apart_of = lost26 + total26;
                    nyquist_of = 4.0*low22 + 4.0*total122;
                    together_of = 4.0*lost132 + 4.0*total132;
                }
            }
        }
    } else {
        const double size = fabs(total2);
        const double root = sqrt(size);
        const double total3 = half + root;
        const double reach = 0.4444444444444444*total3;
        if (reach < 1.0) {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            const double envelope = exp(-half);
            const double rest5 = apart_series(half, total2);
            const double total27 = rest5 + 0.16666666666666666;
            const double back17 = -rest5 + total27;
            const double rest6 = -back17 + total27;
            const double one4 = rest5 - rest6;
            const double two4 = 0.16666666666666666 - back17;
            const double lost27 = one4 + two4;
            const double total28 = envelope*total27;
            const double lost28 = envelope*lost27 + fma(envelope, total27, -(envelope*total27));
            const double rest12 = together_series(half, total2);
            const double total55 = rest12 + 0.5;
            const double back33 = -rest12 + total55;
            const double rest13 = -back33 + total55;
            const double one11 = rest12 - rest13;
            const double two11 = 0.5 - back33;
            const double lost55 = one11 + two11;
            const double total56 = envelope*total55;
            const double lost56 = envelope*lost55 + fma(envelope, total55, -(envelope*total55));
            double fall_;
            double fall_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                fall_ = sunk;
                fall_low2 = sunk_low;
            }
            const double total282 = fall_ + 1.0;
            const double back20 = total282 - 1.0;
            const double lost282 = -back20 + fall_;
            double fall2;
            double fall_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
            }
            const double fast = fall_*fall2;
            const double lost29 = fall_*fall_low4 + fma(fall_, fall2, -(fall_*fall2));
            const double low3 = fall2*fall_low2 + lost29;
            const double total30 = fast + 1.0;
            const double back21 = total30 - 1.0;
            const double lost30 = -back21 + fast;
            const double total31 = total282*total30;
            const double lost31 = total282*(lost30 + low3) +
                fma(total282, total30, -(total282*total30));
            apart_of = lost28 + total28;
            nyquist_of = lost31 + total30*(fall_low2 + lost282) + total31;
            together_of = 2.0*lost56 + 2.0*total56;
        } else {
            const double sign_low = lost2;
            const double left = -(root*root) + size;
            const double left2 = left - fma(root, root, -(root*root));
            const double left3 = left2 + sign_low;
            const double whole = (root == 0.0 ? 1.0 : root);
            const double root_low = 0.5*left3/whole;
            const double back3 = -half + total3;
            const double lost3 = -back3 + root;
            const double p_low = lost3 + root_low;
            const double whole2 = (total3 == 0.0 ? 1.0 : total3);
            const double q = gamma/whole2;
            const double off = gamma - q*whole2;
            const double off2 = off - fma(whole2, q, -(whole2*q));
            const double off3 = off2 - p_low*q;
            const double q_low = off3/whole2;
            const double rate2 = 2.0*root;
            const double whole3 = (delta*total3 == 0.0 ? 1.0 : delta*total3);
            double fall_;
            double fall_low2;
            double mean;
            double mean_low2;
            if (q < 0.75) {
                const double given = q;
                const double total4 = 1.0 - 0.5*given;
                const double back4 = total4 - 1.0;
                const double lost4 = -back4 - 0.5*given;
                const double decay_series_of = decay_series(given);
                const double curved = decay_series_of*(given*given);
                const double total5 = curved + total4;
                const double back5 = -total4 + total5;
                const double lost5 = -back5 + curved;
                const double mean_low = lost4 + lost5 - q_low*
                    (0.125*(given*given) - 0.3333333333333333*given + 0.5);
                const double total6 = given*total5;
                const double lost6 = given*mean_low + fma(given, total5, -(given*total5));
                const double total7 = 1.0 - total6;
                const double back6 = total7 - 1.0;
                const double lost7 = -back6 - total6;
                const double fall_low = -lost6 + lost7 - q_low*total5;
                fall_ = total7;
                fall_low2 = fall_low;
                mean = total5;
                mean_low2 = mean_low;
            } else {
                const double sunk = exp(-q);
                const double sunk_low = -q_low*sunk;
                const double total8 = 1.0 - sunk;
                const double back7 = total8 - 1.0;
                const double lost8 = -back7 - sunk;
                const double bottom = q;
                const double total9 = total8/bottom;
                const double left4 = -bottom*total9 + total8;
                const double left5 = left4 - fma(total9, bottom, -(total9*bottom));
                const double left6 = left5 + lost8 - q_low*total9 - sunk_low;
                const double lost9 = left6/bottom;
                fall_ = sunk;
                fall_low2 = sunk_low;
                mean = total9;
                mean_low2 = lost9;
            }
            const double twice = 2.0*fall_;
            const double total282 = fall_ + 1.0;
            const double back20 = total282 - 1.0;
            const double lost282 = -back20 + fall_;
            double fall2;
            double fall_low4;
            double mean2;
            double mean_low4;
            if (rate2 < 0.75) {
                const double given2 = 2.0*root;
                const double total10 = 1.0 - 0.5*given2;
                const double back8 = total10 - 1.0;
                const double lost10 = -back8 - 0.5*given2;
                const double decay_series_of2 = decay_series(given2);
                const double curved2 = decay_series_of2*(given2*given2);
                const double total11 = curved2 + total10;
                const double back9 = -total10 + total11;
                const double lost11 = -back9 + curved2;
                const double mean_low3 = lost10 + lost11 - 2.0*root_low*
                    (0.125*(given2*given2) - 0.3333333333333333*given2 + 0.5);
                const double total12 = given2*total11;
                const double lost12 = given2*mean_low3 + fma(given2, total11, -(given2*total11));
                const double total13 = 1.0 - total12;
                const double back10 = total13 - 1.0;
                const double lost13 = -back10 - total12;
                const double fall_low3 = -lost12 + lost13 - 2.0*root_low*total11;
                fall2 = total13;
                fall_low4 = fall_low3;
                mean2 = total11;
                mean_low4 = mean_low3;
            } else {
                const double sunk2 = exp(-2.0*root);
                const double sunk_low2 = -2.0*root_low*sunk2;
                const double total14 = 1.0 - sunk2;
                const double back11 = total14 - 1.0;
                const double lost14 = -back11 - sunk2;
                const double bottom2 = 2.0*root;
                const double total15 = total14/bottom2;
                const double left7 = -bottom2*total15 + total14;
                const double left8 = left7 - fma(total15, bottom2, -(total15*bottom2));
                const double left9 = left8 + lost14 - 2.0*root_low*total15 - sunk_low2;
                const double lost15 = left9/bottom2;
                fall2 = sunk2;
                fall_low4 = sunk_low2;
                mean2 = total15;
                mean_low4 = lost15;
            }
            const double fast = fall_*fall2;
            const double total16 = mean2*twice;
            const double lost16 = mean_low4*twice + fma(twice, mean2, -(twice*mean2));
            const double total17 = mean - total16;
            const double back12 = -mean + total17;
            const double rest3 = -back12 + total17;
            const double one2 = mean - rest3;
            const double two2 = -back12 - total16;
            const double lost17 = one2 + two2;
            const double total18 = fast*mean;
            const double lost18 = fast*mean_low2 + fma(fast, mean, -(fast*mean));
            const double top = total17 + total18;
            const double low = -lost16 + lost17 + lost18 + mean_low2;
            const double lost29 = fall_*fall_low4 + fma(fall_, fall2, -(fall_*fall2));
            const double low3 = fall2*fall_low2 + lost29;
            const double total30 = fast + 1.0;
            const double back21 = total30 - 1.0;
            const double lost30 = -back21 + fast;
            const double total31 = total282*total30;
            const double lost31 = total282*(lost30 + low3) +
                fma(total282, total30, -(total282*total30));
            const double total52 = 1.0 - fast;
            const double back32 = total52 - 1.0;
            const double lost52 = -back32 - fast;
            const double total53 = mean*total52;
            const double lost53 = mean*(lost52 - low3) + fma(mean, total52, -(mean*total52));
            const double moved_low = lost53 + mean_low2*total52;
            const double total54 = total53/whole2;
            const double left25 = total53 - total54*whole2;
            const double left26 = left25 - fma(total54, whole2, -(total54*whole2));
            const double left27 = left26 + moved_low - p_low*total54;
            const double lost54 = left27/whole2;
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
static void cos_next_sin_next(double k, double x, double *cos_next_out, double *sin_next_out) {
    const double count = k + 1.0;
    const double before = count - 1.0;
    const double angle = count*x;
    const double missed = -before + k;
    const double off = missed*x + fma(count, x, -(count*x));
    const double cosine = cos(angle);
    const double sine = sin(angle);
    const double cos_next_of = cosine - off*sine;
    const double sin_next_of = cosine*off + sine;
    *cos_next_out = cos_next_of;
    *sin_next_out = sin_next_of;
    return;
}

// cos((k + 1) x)
static double cos_next(double k, double x) {
    const double count = k + 1.0;
    const double before = count - 1.0;
    const double angle = count*x;
    const double missed = -before + k;
    const double off = missed*x + fma(count, x, -(count*x));
    const double cosine = cos(angle);
    const double sine = sin(angle);
    return cosine - off*sine;
}

// has the sign of the slope of the boundary's alpha, d < 1
static double early_slope(double theta, double k4, double k3, double k2, double k1, double k0) {
    const double sine = sin(0.5*theta);
    const double cosine = cos(0.5*theta);
    const double up = (sine*sine);
    const double along = (cosine*cosine);
    const double power = along;
    const double found = k3*power + k4*up;
    const double power2 = along*power;
    const double found2 = found*up + k2*power2;
    const double power3 = along*power2;
    const double found3 = found2*up + k1*power3;
    const double power4 = along*power3;
    const double found4 = found3*up + k0*power4;
    return found4;
}

// has the sign of the slope of the boundary's alpha next to pi
static double end_slope(double at_minus_one, double loss, double together_, double apart_,
    double last) {
    const double total = -4.0*last + together_;
    const double back = -together_ + total;
    const double rest = -back + total;
    const double one = -rest + together_;
    const double two = -back - 4.0*last;
    const double lost = one + two;
    const double total2 = (total*total);
    const double lost2 = 2.0*lost*total + fma(total, total, -(total*total));
    const double total3 = apart_*together_;
    const double lost3 = fma(apart_, together_, -(apart_*together_));
    const double total4 = -total2 + total3;
    const double back2 = -total3 + total4;
    const double rest2 = -back2 + total4;
    const double one2 = -rest2 + total3;
    const double two2 = -back2 - total2;
    const double lost4 = one2 + two2;
    const double gap_low = -lost2 + lost3 + lost4;
    const double total5 = total2 - 2.0*total3;
    const double back3 = -total2 + total5;
    const double rest3 = -back3 + total5;
    const double one3 = -rest3 + total2;
    const double two3 = -back3 - 2.0*total3;
    const double lost5 = one3 + two3;
    const double lean_low = lost2 - 2.0*lost3 + lost5;
    const double total6 = total*total5;
    const double lost6 = lean_low*total + fma(total, total5, -(total*total5));
    const double total7 = apart_*total3;
    const double lost7 = apart_*lost3 + fma(apart_, total3, -(apart_*total3));
    const double total8 = total6 + total7;
    const double back4 = -total6 + total8;
    const double rest4 = -back4 + total8;
    const double one4 = -rest4 + total6;
    const double two4 = -back4 + total7;
    const double lost8 = one4 + two4;
    const double bent_low = lost*total5 + lost6 + lost7 + lost8;
    const double total9 = at_minus_one*total8;
    const double lost9 = at_minus_one*bent_low + fma(at_minus_one, total8, -(at_minus_one*total8));
    const double total10 = apart_*total4;
    const double lost10 = apart_*gap_low + fma(apart_, total4, -(apart_*total4));
    const double total11 = loss*total10;
    const double lost11 = loss*lost10 + fma(loss, total10, -(loss*total10));
    const double total12 = 2.0*apart_ - total;
    const double back5 = -2.0*apart_ + total12;
    const double rest5 = -back5 + total12;
    const double one5 = 2.0*apart_ - rest5;
    const double two5 = -back5 - total;
    const double lost12 = one5 + two5;
    const double total13 = (apart_*apart_);
    const double lost13 = fma(apart_, apart_, -(apart_*apart_));
    const double total14 = total12*total13;
    const double lost14 = total13*(-lost + lost12) + fma(total13, total12, -(total13*total12));
    const double three_low = lost13*total12 + lost14;
    const double total15 = 4.0*total14 - total9;
    const double back6 = -4.0*total14 + total15;
    const double rest6 = -back6 + total15;
    const double one6 = -rest6 + 4.0*total14;
    const double two6 = -back6 - total9;
    const double lost15 = one6 + two6;
    const double total16 = -2.0*total11 + total15;
    const double back7 = -total15 + total16;
    const double rest7 = -back7 + total16;
    const double one7 = -rest7 + total15;
    const double two7 = -back7 - 2.0*total11;
    const double lost16 = one7 + two7;
    const double low = -2.0*lost11 + lost15 + lost16 - lost9 + 4.0*three_low;
    return low + total16;
}

// the angle of the largest stiffness for delays below a period
static double early_angle(double at_one, double at_minus_one, double loss, double together_,
    double apart_, double last) {
    const double t = (apart_*apart_*apart_);
    const double t2 = (together_*together_*together_);
    const double t3 = (together_*together_);
    const double t4 = apart_*t3;
    const double t5 = (apart_*apart_);
    const double t6 = 2.0*loss;
    const double t7 = at_minus_one + t6;
    const double t8 = 4.0*together_;
    const double t9 = 16.0*apart_;
    const double t10 = at_one + t6;
    const double t11 = 2.0*at_one;
    const double t12 = 5.0*at_minus_one;
    const double t13 = -at_one;
    const double t14 = 4.0*loss;
    const double t15 = apart_*together_;
    const double t16 = 16.0*together_;
    const double t17 = at_one*last;
    const double t18 = apart_*t11;
    const double t19 = at_one*t5;
    const double k = end_slope(at_minus_one, loss, together_, apart_, last);
    const double k2 = -4.0*at_minus_one*t2 + last*
        (32.0*at_minus_one*t3 + last*(64.0*apart_*loss + 128.0*at_minus_one*last - 96.0*
        at_minus_one*together_) - 96.0*t5 - t7*t9*together_) + 16.0*t + 8.0*t4*
        (at_minus_one + loss) - t5*t7*t8;
    const double k3 = last*(last*(last*(-192.0*at_minus_one - 256.0*at_one - 512.0*loss) + t16*
        (9.0*at_one + 16.0*loss + t12) + t9*(8.0*at_minus_one + 8.0*at_one + 18.0*loss)) - 32.0*
        t15 - 4.0*t3*(at_minus_one + 7.0*at_one + 14.0*loss) - 112.0*t5) + 8.0*t + 2.0*t2*
        (-2.0*at_minus_one + t10) + 2.0*t4*(t12 + t13 + t14) - 2.0*t5*together_*(-t11 + t7);
    const double k4 = last*(32.0*t17*together_ - 8.0*together_*(t18 + 12.0*together_)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const double k5 = last*(t16*t17 + t8*(t10*together_ - t18)) + together_*
        (-2.0*t15*(at_one + loss) + t19 + t3*(at_minus_one + t11 + t14));
    double count = 1.0;
    double found = 0.0;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0) || (found > 0.0)) { break; }
        const double rises = early_slope(0.041666666666666664*3.141592653589793*count, k, k2, k3,
            k4, k5);
        const double next_count = (rises > 0.0 ? count + 1.0 : count);
        const double next_found = (rises > 0.0 ? 0.0 : 1.0);
        count = next_count;
        found = next_found;
    }
    if (found > 0.0) {
        const double high = 0.041666666666666664*3.141592653589793*count;
        const double low = fmax(0.001*high, 0.041666666666666664*3.141592653589793*(count - 1.0));
        const double low2 = low;
        const double above = early_slope(low2, k, k2, k3, k4, k5);
        double root;
        if (above <= 0.0) {
            root = low2;
        } else {
            const double high2 = high;
            const double below = early_slope(high2, k, k2, k3, k4, k5);
            if (below >= 0.0) {
                root = high2;
            } else {
                double b = low2;
                double fb = above;
                double a = high2;
                double fa = below;
                double c = high2;
                double fc = below;
                for (int count_b = 0; count_b < 120; ++count_b) {
                    if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                        (fabs(a - b) <= 4.440892098500626e-16*
                        fabs((fabs(fa) < fabs(fb) ? a : b)))) { break; }
                    const double span = -b + c;
                    const double rise_ = -fb + fc;
                    const double whole = (span == 0.0 ? 1.0 : span);
                    const double place = (a - b)/whole;
                    const double whole2 = (rise_ == 0.0 ? 1.0 : rise_);
                    const double height = (fa - fb)/whole2;
                    const double safe = ((place < 1.0 - ((1.0 - height)*(1.0 - height))) &&
                        (place > (height*height)) ? 1.0 : 0.0);
                    const double one = (safe > 0.0 ? -fa + fb : 1.0);
                    const double two = (safe > 0.0 ? fb - fc : 1.0);
                    const double three = (safe > 0.0 ? fa - fc : 1.0);
                    const double width = -a + b;
                    const double here = fa/one;
                    const double there = fc/two;
                    const double whole3 = (width == 0.0 ? 1.0 : width);
                    const double other = fa/three;
                    const double last2 = fb/two;
                    const double guess = (safe > 0.0 ? here*there + last2*other*(-a + c)/whole3 :
                        0.5);
                    const double edge = 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b))/
                        fabs(whole3);
                    const double edge2 = fmin(0.5, edge);
                    const double share = fmin(guess, 1.0 - edge2);
                    const double share2 = fmax(edge2, share);
                    const double new_ = a + share2*width;
                    const double value = early_slope(new_, k, k2, k3, k4, k5);
                    const double next_b = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? b : a);
                    const double next_fb = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? fb : fa);
                    const double next_a = new_;
                    const double next_fa = value;
                    const double next_c = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? a : b);
                    const double next_fc = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? fa : fb);
                    b = next_b;
                    fb = next_fb;
                    a = next_a;
                    fa = next_fa;
                    c = next_c;
                    fc = next_fc;
                }
                root = (fabs(fa) < fabs(fb) ? a : b);
            }
        }
        return root;
    }
    return 3.141592653589793;
}

// sin((k + 1) x)
static double sin_next(double k, double x) {
    const double count = k + 1.0;
    const double before = count - 1.0;
    const double angle = count*x;
    const double missed = -before + k;
    const double off = missed*x + fma(count, x, -(count*x));
    const double cosine = cos(angle);
    const double sine = sin(angle);
    return cosine*off + sine;
}

// has the sign of the slope of the boundary's alpha
static double boundary_slope(double theta, double l, double at_one, double at_minus_one,
    double loss, double together_, double apart_, double across) {
    const double t = 2.0*l + 2.0;
    const double t2 = 0.5*theta;
    const double t3 = sin_next(t, t2);
    const double t4 = tan(t2);
    const double t5 = (t4*t4);
    const double t6 = 4.0*t5;
    const double t7 = apart_*t5;
    const double t8 = -t7 + together_;
    const double t9 = at_minus_one*t5;
    const double t10 = at_one - t9;
    const double t11 = across*loss*t6 + t10*t8;
    const double t12 = cos_next(t, t2);
    const double t13 = -2.0*across*t10*t4 + 2.0*loss*t4*t8;
    const double t14 = (across*across);
    const double t15 = t14*t6 + (t8*t8);
    const double t16 = (loss*loss);
    const double t17 = (t10*t10) + t16*t6;
    const double t18 = t15*t17;
    const double t19 = t5 + 1.0;
    return -t4*(0.5*t18 + t19*(t15*(-at_minus_one*t10 + 2.0*t16) - t17*(-apart_*t8 + 2.0*t14)))*
        (t11*t12 - t13*t3) + (t11*t3 + t12*t13)*
        (t18*(l + 1.5) + t19*(-across*t17*(t7 + together_) + loss*t15*(at_one + t9)));
}

// the angle of the largest stiffness for a period and more
static double later_angle(double d, double l, double at_one, double at_minus_one, double loss,
    double together_, double apart_, double across) {
    const double turn_ = 3.141592653589793/(d + 1.0);
    double count = 1.0;
    double found = 0.0;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if ((count > 24.0) || (found > 0.0)) { break; }
        const double rises = boundary_slope(0.041666666666666664*count*turn_, l, at_one,
            at_minus_one, loss, together_, apart_, across);
        const double next_count = (rises > 0.0 ? count + 1.0 : count);
        const double next_found = (rises > 0.0 ? 0.0 : 1.0);
        count = next_count;
        found = next_found;
    }
    if (found > 0.0) {
        const double high = 0.041666666666666664*count*turn_;
        const double low = fmax(0.001*high, 0.041666666666666664*turn_*(count - 1.0));
        const double low2 = low;
        const double above = boundary_slope(low2, l, at_one, at_minus_one, loss, together_, apart_,
            across);
        double root;
        if (above <= 0.0) {
            root = low2;
        } else {
            const double high2 = high;
            const double below = boundary_slope(high2, l, at_one, at_minus_one, loss, together_,
                apart_, across);
            if (below >= 0.0) {
                root = high2;
            } else {
                double b = low2;
                double fb = above;
                double a = high2;
                double fa = below;
                double c = high2;
                double fc = below;
                for (int count_b = 0; count_b < 120; ++count_b) {
                    if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                        (fabs(a - b) <= 4.440892098500626e-16*
                        fabs((fabs(fa) < fabs(fb) ? a : b)))) { break; }
                    const double span = -b + c;
                    const double rise_ = -fb + fc;
                    const double whole = (span == 0.0 ? 1.0 : span);
                    const double place = (a - b)/whole;
                    const double whole2 = (rise_ == 0.0 ? 1.0 : rise_);
                    const double height = (fa - fb)/whole2;
                    const double safe = ((place < 1.0 - ((1.0 - height)*(1.0 - height))) &&
                        (place > (height*height)) ? 1.0 : 0.0);
                    const double one = (safe > 0.0 ? -fa + fb : 1.0);
                    const double two = (safe > 0.0 ? fb - fc : 1.0);
                    const double three = (safe > 0.0 ? fa - fc : 1.0);
                    const double width = -a + b;
                    const double here = fa/one;
                    const double there = fc/two;
                    const double whole3 = (width == 0.0 ? 1.0 : width);
                    const double other = fa/three;
                    const double last = fb/two;
                    const double guess = (safe > 0.0 ? here*there + last*other*(-a + c)/whole3 :
                        0.5);
                    const double edge = 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b))/
                        fabs(whole3);
                    const double edge2 = fmin(0.5, edge);
                    const double share = fmin(guess, 1.0 - edge2);
                    const double share2 = fmax(edge2, share);
                    const double new_ = a + share2*width;
                    const double value = boundary_slope(new_, l, at_one, at_minus_one, loss,
                        together_, apart_, across);
                    const double next_b = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? b : a);
                    const double next_fb = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? fb : fa);
                    const double next_a = new_;
                    const double next_fa = value;
                    const double next_c = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? a : b);
                    const double next_fc = (((fa < 0.0) && (value < 0.0)) ||
                        ((fa > 0.0) && (value > 0.0)) ? fa : fb);
                    b = next_b;
                    fb = next_fb;
                    a = next_a;
                    fa = next_fa;
                    c = next_c;
                    fc = next_fc;
                }
                root = (fabs(fa) < fabs(fb) ? a : b);
            }
        }
        return root;
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static double undelayed_angle(double at_one, double at_minus_one, double loss, double together_,
    double apart_) {
    const double k = end_slope(at_minus_one, loss, together_, apart_, 0.0);
    const double t = 2.0*apart_;
    const double t2 = -together_;
    const double t3 = 2.0*together_;
    const double t4 = (together_*together_);
    const double k2 = t3*((apart_*apart_)*at_one + together_*(at_minus_one*(t + t2) + loss*t));
    const double k3 = together_*(at_minus_one*t4 + at_one*(t4 + ((-apart_ - t2)*(-apart_ - t2))) +
        loss*t3*(-apart_ + 2.0*together_));
    double above;
    double below;
    if (k2 > 0.0) {
        const double discriminant = -4.0*k*k3 + (k2*k2);
        const double root = sqrt(fmax(0.0, discriminant));
        above = k2 + root;
        below = fmax(0.0, -2.0*k);
    } else {
        const double discriminant = -4.0*k*k3 + (k2*k2);
        if (discriminant < 0.0) {
            above = 2.0*k3;
            below = 0.0;
        } else {
            const double root = sqrt(fmax(0.0, discriminant));
            above = 2.0*k3;
            below = -k2 + root;
        }
    }
    return 2.0*atan2(sqrt(above), sqrt(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static double stiffest_angle(double gamma, double delta, double d, double l, double part,
    double first, double last, double at_one, double at_minus_one, double loss, double together_,
    double apart_) {
    if (((d <= 1.0) || (sqrt(gamma)*(d + 1.0) <= 3.141592653589793)) && (gamma <= 9.8)) {
        const double across = (part == 0.0 ? first : first - last);
        double theta;
        if (d == 0.0) {
            theta = undelayed_angle(at_one, at_minus_one, loss, together_, apart_);
        } else {
            if (d < 1.0) {
                theta = early_angle(at_one, at_minus_one, loss, together_, apart_, last);
            } else {
                theta = later_angle(d, l, at_one, at_minus_one, loss, together_, apart_, across);
            }
        }
        const double t = sin_next(l, theta);
        const double t2 = 0.5*theta;
        const double t3 = sin(t2);
        const double t4 = cos(t2);
        const double t5 = (t4*t4);
        const double t6 = (t3*t3);
        const double t7 = 4.0*t5*t6;
        const double t8 = -apart_*t6 + t5*together_;
        const double t9 = 1.0/((across*across)*t7 + (t8*t8));
        const double t10 = -at_minus_one*t6 + at_one*t5;
        const double t11 = -2.0*across*t10 + 2.0*loss*t8;
        const double t12 = across*loss*t7 + t10*t8;
        const double t13 = t9*cos_next(l, theta);
        const double t14 = -t*t12*t9/sin(theta) - 0.5*t11*t13;
        const double stiffness = t*t11*t3*t4*t9 - t12*t13 - 2.0*t14*t6;
        double good;
        if ((delta > 0.0) && (gamma > -stiffness) && (sqrt(gamma)*(d + 1.0) <= 3.141592653589793)) {
            good = 1.0;
        } else {
            const double damping = t14;
            const double inside = -4.6566128730773926e-09*gamma + 0.9999999953433871*stiffness;
            double outside;
            if (part == 0.0) {
                outside = whole_roots(inside, damping, l, first, last, at_one, at_minus_one, loss,
                    together_, apart_);
            } else {
                outside = late_roots(inside, damping, l, first, last, at_one, at_minus_one, loss,
                    together_, apart_);
            }
            good = stable(outside, inside, damping, gamma, delta);
        }
        if (good > 0.0) {
            return theta;
        }
        return NAN;
    }
    return NAN;
}

// (x - sin(x))/x^3
static double gap(double x) {
    if (fabs(x) < 2.0) {
        const double near = x;
        const double square = -(near*near);
        const double b11 = 6.446950284384474e-26;
        const double b10 = b11*square + 3.868170170630684e-23;
        const double b9 = b10*square + 1.9572941063391263e-20;
        const double b8 = b9*square + 8.22063524662433e-18;
        const double b7 = b8*square + 2.8114572543455206e-15;
        const double b6 = b7*square + 7.647163731819816e-13;
        const double b5 = b6*square + 1.6059043836821613e-10;
        const double b4 = b5*square + 2.505210838544172e-08;
        const double b3 = b4*square + 2.7557319223985893e-06;
        const double b2 = b3*square + 0.0001984126984126984;
        const double b1 = b2*square + 0.008333333333333333;
        const double rest = b1*square + 9.25185853854297e-18;
        const double total = rest + 0.16666666666666666;
        return total;
    }
    const double whole = x;
    return (x - sin(x))/(whole*whole*whole);
}

// sin(x)/x
static double sinc(double x) {
    if (fabs(x) < 1.0) {
        const double near = x;
        return -(near*near)*gap(near) + 1.0;
    }
    const double whole = (x == 0.0 ? 1.0 : x);
    return sin(x)/whole;
}

// the damping that the wall needs at the angle 2 psi
static double need(double alpha, double beta, double l, double epsilon, double psi) {
    if (epsilon == 0.0) {
        const double early = 0.5*alpha*(2.0*l + 1.0)*sinc(psi*(2.0*l + 1.0))/sinc(psi) - beta*
            cos_next(l, 2.0*psi);
        return early;
    }
    const double early = 0.5*alpha*(2.0*l + 1.0)*sinc(psi*(2.0*l + 1.0))/sinc(psi) - beta*
        cos_next(l, 2.0*psi);
    const double n = early + epsilon*(0.5*alpha*(2.0*l + 3.0)*sinc(psi*(2.0*l + 3.0))/sinc(psi) -
        beta*cos_next(l + 1.0, 2.0*psi) - early);
    const double root = sqrt(epsilon*(1.0 - epsilon)*
        ((alpha*alpha)*(cos(psi)*cos(psi)) + ((alpha + 2.0*beta)*(alpha + 2.0*beta))*
        (sin(psi)*sin(psi))) + (n*n));
    return 0.5*n + 0.5*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static double chord(double k, double x) {
    const double turn_ = x*(k + 1.0);
    if (turn_ < 1.5) {
        const double angle = turn_;
        const double order = 2.0*k + 2.0;
        const double along = cos_next(k, x);
        const double wave = sinc(0.5*angle);
        const double inner = 0.5*(wave*wave) - gap(angle);
        return order*(along*gap(x) + 0.25*inner*(order*order));
    }
    const double some = x;
    const double order = 2.0*k + 2.0;
    const double along = cos_next(k, x);
    return (-along*order*sin(x) + 2.0*sin_next(k, x))/(some*some*some);
}

// has the sign of the slope of Need, at a fraction
static double rising(double alpha, double beta, double l, double epsilon, double psi) {
    const double t = 2.0*psi;
    const double t2 = 2.0*alpha/(sinc(psi)*sinc(psi));
    const double t3 = 0.5*alpha + beta;
    const double t4 = 2.0*l;
    const double t5 = t4 + 2.0;
    const double t6 = t4 + 4.0;
    const double early = -t2*chord(l, t) + t3*(t5*t5)*sinc(psi*t5);
    const double steep = early + epsilon*(-early - t2*chord(l + 1.0, t) + t3*(t6*t6)*sinc(psi*t6));
    return 2.0*beta*epsilon*(1.0 - epsilon)*(alpha + beta)*sinc(2.0*psi) + steep*
        need(alpha, beta, l, epsilon, psi);
}

// has the sign of the slope of Need, up to the angle in phase
static double steepness(double alpha, double beta, double l, double epsilon, double psi) {
    if (epsilon == 0.0) {
        const double t = 2.0*l + 2.0;
        const double early = -2.0*alpha*chord(l, 2.0*psi)/(sinc(psi)*sinc(psi)) + (t*t)*
            (0.5*alpha + beta)*sinc(psi*t);
        return early;
    }
    const double phase = psi*(2.0*l + 2.0) + atan2(alpha*cos(psi), (alpha + 2.0*beta)*sin(psi)) +
        atan2(epsilon*sin(2.0*psi), epsilon*cos(2.0*psi) - epsilon + 1.0) - 3.141592653589793;
    if (phase > 0.0) {
        const double rising_ = rising(alpha, beta, l, epsilon, psi);
        return -fabs(rising_);
    }
    const double rising_ = rising(alpha, beta, l, epsilon, psi);
    return rising_;
}

// half of the angle at which the wall needs most damping
static double worst_angle(double alpha, double beta, double l, double epsilon) {
    const double size = fabs(alpha) + fabs(beta);
    const double whole = (size == 0.0 ? 1.0 : size);
    const double stiffness = alpha/whole;
    const double damping = beta/whole;
    const double low = 0.0;
    const double above = steepness(stiffness, damping, l, epsilon, low);
    double root;
    if (above <= 0.0) {
        root = low;
    } else {
        const double high = 3.141592653589793/(2.0*l + 2.0);
        const double below = steepness(stiffness, damping, l, epsilon, high);
        if (below >= 0.0) {
            root = high;
        } else {
            double b = low;
            double fb = above;
            double a = high;
            double fa = below;
            double c = high;
            double fc = below;
            for (int count_b = 0; count_b < 120; ++count_b) {
                if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                    (fabs(a - b) <= 4.656612873077393e-10*fabs((fabs(fa) < fabs(fb) ? a : b)))) {
                    break; }
                const double span = -b + c;
                const double rise_ = -fb + fc;
                const double whole2 = (span == 0.0 ? 1.0 : span);
                const double place = (a - b)/whole2;
                const double whole3 = (rise_ == 0.0 ? 1.0 : rise_);
                const double height = (fa - fb)/whole3;
                const double safe = ((place < 1.0 - ((1.0 - height)*(1.0 - height))) &&
                    (place > (height*height)) ? 1.0 : 0.0);
                const double one = (safe > 0.0 ? -fa + fb : 1.0);
                const double two = (safe > 0.0 ? fb - fc : 1.0);
                const double three = (safe > 0.0 ? fa - fc : 1.0);
                const double width = -a + b;
                const double here = fa/one;
                const double there = fc/two;
                const double whole4 = (width == 0.0 ? 1.0 : width);
                const double other = fa/three;
                const double last = fb/two;
                const double guess = (safe > 0.0 ? here*there + last*other*(-a + c)/whole4 : 0.5);
                const double edge = 4.656612873077393e-10*fabs((fabs(fa) < fabs(fb) ? a : b))/
                    fabs(whole4);
                const double edge2 = fmin(0.5, edge);
                const double share = fmin(guess, 1.0 - edge2);
                const double share2 = fmax(edge2, share);
                const double new_ = a + share2*width;
                const double value = steepness(stiffness, damping, l, epsilon, new_);
                const double next_b = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? b : a);
                const double next_fb = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? fb : fa);
                const double next_a = new_;
                const double next_fa = value;
                const double next_c = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? a : b);
                const double next_fc = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? fa : fb);
                b = next_b;
                fb = next_fb;
                a = next_a;
                fa = next_fa;
                c = next_c;
                fc = next_fc;
            }
            root = (fabs(fa) < fabs(fb) ? a : b);
        }
    }
    return root;
}

// the damping that the wall needs at its worst angle
static double largest_need(double alpha, double beta, double d) {
    if (alpha < 0.0) {
        return INFINITY;
    }
    const double whole = floor(d);
    const double part = d - whole;
    const double psi = worst_angle(alpha, beta, whole, part);
    return need(alpha, beta, whole, part, psi);
}

// early + share (late - early)
static double between(double share, double early, double late) {
    const double more = -early + late;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static double lead(double theta, double l, double epsilon) {
    if (theta*(l + 1.0) < 4.0) {
        const double early = sin_next(l, theta);
        const double late = sin_next(l + 1.0, theta);
        const double sine = early + epsilon*(-early + late);
        return sine;
    }
    return -1.0;
}

// the value, NaN for number < 0
static double rated(double number, double value) {
    if (number < 0.0) {
        return NAN;
    }
    return value;
}

// ((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3
static double spread(double k, double x) {
    const double turn_ = x*(k + 1.0);
    if (turn_ < 1.5) {
        const double angle = turn_;
        const double order = 2.0*k + 2.0;
        return order*((order*order)*gap(2.0*angle) - gap(x));
    }
    const double some = x;
    const double order = 2.0*k + 2.0;
    return (order*sin(x) - 2.0*cos_next(k, x)*sin_next(k, x))/(some*some*some);
}

// what straight motions need at a whole delay of k periods
static double straight(double stiffness, double damping, double k, double angle) {
    const double order = 2.0*k + 1.0;
    const double wave = sinc(angle*order);
    const double near = 2.0*sinc(angle);
    const double total = order*wave;
    const double lost = fma(order, wave, -(order*wave));
    const double total2 = total/near;
    const double left = -near*total2 + total;
    const double left2 = left - fma(total2, near, -(total2*near));
    const double left3 = left2 + lost;
    const double lost2 = left3/near;
    const double total3 = stiffness*total2;
    const double lost3 = lost2*stiffness + fma(stiffness, total2, -(stiffness*total2));
    const double along = cos_next(k, 2.0*angle);
    const double total4 = along*damping;
    const double lost4 = fma(damping, along, -(damping*along));
    const double total5 = total3 - total4;
    const double back = -total3 + total5;
    const double rest = -back + total5;
    const double one = -rest + total3;
    const double two = -back - total4;
    const double lost5 = one + two;
    const double low = lost3 - lost4 + lost5;
    return low + total5;
}

// the wall whose worst angle is 2 psi, as an angle
static double turn(double psi, double l, double epsilon) {
    const double wave = sin(psi);
    const double wave2 = cos(psi);
    const double wave3 = chord(l, 2.0*psi);
    const double wave4 = chord(l + 1.0, 2.0*psi);
    const double wave5 = cos_next(l, 2.0*psi);
    const double wave6 = cos_next(l + 1.0, 2.0*psi);
    const double wave7 = sinc(psi);
    const double wave8 = sinc(2.0*psi);
    const double wave9 = sinc(psi*(2.0*l + 1.0));
    const double wave10 = sinc(psi*(2.0*l + 2.0));
    const double wave11 = sinc(psi*(2.0*l + 3.0));
    const double wave12 = sinc(psi*(2.0*l + 4.0));
    const double low = 0.0;
    const double t = sin(low);
    const double t2 = l + 1.0;
    const double t3 = cos(low);
    const double t4 = t3/t2;
    const double t5 = 0.5*t4;
    const double t6 = t - t5;
    const double t7 = epsilon*(1.0 - epsilon);
    const double t8 = 2.0*l;
    const double t9 = 2.0*t4/(wave7*wave7);
    const double t10 = t*wave10*((t8 + 2.0)*(t8 + 2.0)) - t9*wave3;
    const double t11 = t6*wave5;
    const double t12 = 1.0/wave7;
    const double t13 = wave9*(t8 + 1.0);
    const double t14 = t12*t5;
    const double t15 = t13*t14;
    const double t16 = epsilon*(t11 + t14*wave11*(t8 + 3.0) - t15 - t6*wave6);
    const double above = -2.0*t6*t7*wave8*(t + t5) -
        (epsilon*(t*wave12*((t8 + 4.0)*(t8 + 4.0)) - t10 - t9*wave4) + t10)*
        (-0.5*t11 + 0.25*t12*t13*t4 + 0.5*t16 + 0.5*
        sqrt(t7*(4.0*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2)) +
        ((-t11 + t15 + t16)*(-t11 + t15 + t16))));
    double root;
    if (above <= 0.0) {
        root = low;
    } else {
        const double high = 0.5*3.141592653589793;
        const double t17 = sin(high);
        const double t18 = l + 1.0;
        const double t19 = cos(high);
        const double t20 = t19/t18;
        const double t21 = 0.5*t20;
        const double t22 = t17 - t21;
        const double t23 = epsilon*(1.0 - epsilon);
        const double t24 = 2.0*l;
        const double t25 = 2.0*t20/(wave7*wave7);
        const double t26 = t17*wave10*((t24 + 2.0)*(t24 + 2.0)) - t25*wave3;
        const double t27 = t22*wave5;
        const double t28 = 1.0/wave7;
        const double t29 = wave9*(t24 + 1.0);
        const double t30 = t21*t28;
        const double t31 = t29*t30;
        const double t32 = epsilon*(-t22*wave6 + t27 + t30*wave11*(t24 + 3.0) - t31);
        const double below = -2.0*t22*t23*wave8*(t17 + t21) -
            (epsilon*(t17*wave12*((t24 + 4.0)*(t24 + 4.0)) - t25*wave4 - t26) + t26)*
            (0.25*t20*t28*t29 - 0.5*t27 + 0.5*t32 + 0.5*
            sqrt(t23*(4.0*(t17*t17)*(wave*wave) + (t19*t19)*(wave2*wave2)/(t18*t18)) +
            ((-t27 + t31 + t32)*(-t27 + t31 + t32))));
        if (below >= 0.0) {
            root = high;
        } else {
            double b = low;
            double fb = above;
            double a = high;
            double fa = below;
            double c = high;
            double fc = below;
            for (int count_b = 0; count_b < 120; ++count_b) {
                if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                    (fabs(a - b) <= 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b)))) {
                    break; }
                const double span = -b + c;
                const double rise_ = -fb + fc;
                const double whole = (span == 0.0 ? 1.0 : span);
                const double place = (a - b)/whole;
                const double whole2 = (rise_ == 0.0 ? 1.0 : rise_);
                const double height = (fa - fb)/whole2;
                const double safe = ((place < 1.0 - ((1.0 - height)*(1.0 - height))) &&
                    (place > (height*height)) ? 1.0 : 0.0);
                const double one = (safe > 0.0 ? -fa + fb : 1.0);
                const double two = (safe > 0.0 ? fb - fc : 1.0);
                const double three = (safe > 0.0 ? fa - fc : 1.0);
                const double width = -a + b;
                const double here = fa/one;
                const double there = fc/two;
                const double whole3 = (width == 0.0 ? 1.0 : width);
                const double other = fa/three;
                const double last = fb/two;
                const double guess = (safe > 0.0 ? here*there + last*other*(-a + c)/whole3 : 0.5);
                const double edge = 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b))/
                    fabs(whole3);
                const double edge2 = fmin(0.5, edge);
                const double share = fmin(guess, 1.0 - edge2);
                const double share2 = fmax(edge2, share);
                const double new_ = a + share2*width;
                const double t33 = sin(new_);
                const double t34 = l + 1.0;
                const double t35 = cos(new_);
                const double t36 = t35/t34;
                const double t37 = 0.5*t36;
                const double t38 = t33 - t37;
                const double t39 = epsilon*(1.0 - epsilon);
                const double t40 = 2.0*l;
                const double t41 = 2.0*t36/(wave7*wave7);
                const double t42 = t33*wave10*((t40 + 2.0)*(t40 + 2.0)) - t41*wave3;
                const double t43 = t38*wave5;
                const double t44 = 1.0/wave7;
                const double t45 = wave9*(t40 + 1.0);
                const double t46 = t37*t44;
                const double t47 = t45*t46;
                const double t48 = epsilon*(-t38*wave6 + t43 + t46*wave11*(t40 + 3.0) - t47);
                const double value = -2.0*t38*t39*wave8*(t33 + t37) -
                    (epsilon*(t33*wave12*((t40 + 4.0)*(t40 + 4.0)) - t41*wave4 - t42) + t42)*
                    (0.25*t36*t44*t45 - 0.5*t43 + 0.5*t48 + 0.5*
                    sqrt(t39*(4.0*(t33*t33)*(wave*wave) + (t35*t35)*(wave2*wave2)/(t34*t34)) +
                    ((-t43 + t47 + t48)*(-t43 + t47 + t48))));
                const double next_b = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? b : a);
                const double next_fb = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? fb : fa);
                const double next_a = new_;
                const double next_fa = value;
                const double next_c = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? a : b);
                const double next_fc = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? fa : fb);
                b = next_b;
                fb = next_fb;
                a = next_a;
                fa = next_fa;
                c = next_c;
                fc = next_fc;
            }
            root = (fabs(fa) < fabs(fb) ? a : b);
        }
    }
    return root;
}

// the wall whose worst angle is theta, as an angle, or NaN
static double touching(double theta, double l, double epsilon) {
    const double found = turn(0.5*theta, l, epsilon);
    if (found < 0.5*3.141592653589793) {
        return found;
    }
    return NAN;
}

// the worst angle of the stiffest passive wall, at a fraction
static double passive_angle(double l, double epsilon) {
    const double low = 1e-06*3.141592653589793/(2.0*epsilon + 2.0*l + 2.0);
    const double turned = turn(low, l, epsilon);
    const double wall = cos(turned)/(l + 1.0);
    const double wall2 = sin(turned) - 0.5*cos(turned)/(l + 1.0);
    const double need_ = need(wall, wall2, l, epsilon, low);
    const double above = -epsilon*(1.0 - epsilon)*(wall + 2.0*wall2)*(sin(low)*sin(low)) + need_*
        (epsilon*(-cos_next(l, 2.0*low) + cos_next(l + 1.0, 2.0*low)) + cos_next(l, 2.0*low));
    double root;
    if (above <= 0.0) {
        root = low;
    } else {
        const double high = 3.141592653589793/(2.0*epsilon + 2.0*l + 2.0);
        const double turned2 = turn(high, l, epsilon);
        const double wall3 = cos(turned2)/(l + 1.0);
        const double wall4 = sin(turned2) - 0.5*cos(turned2)/(l + 1.0);
        const double need2 = need(wall3, wall4, l, epsilon, high);
        const double below = -epsilon*(1.0 - epsilon)*(wall3 + 2.0*wall4)*(sin(high)*sin(high)) +
            need2*(epsilon*(-cos_next(l, 2.0*high) + cos_next(l + 1.0, 2.0*high)) +
            cos_next(l, 2.0*high));
        if (below >= 0.0) {
            root = high;
        } else {
            double b = low;
            double fb = above;
            double a = high;
            double fa = below;
            double c = high;
            double fc = below;
            for (int count_b = 0; count_b < 120; ++count_b) {
                if (((fa <= 0.0) && (fb <= 0.0)) || ((fa >= 0.0) && (fb >= 0.0)) ||
                    (fabs(a - b) <= 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b)))) {
                    break; }
                const double span = -b + c;
                const double rise_ = -fb + fc;
                const double whole = (span == 0.0 ? 1.0 : span);
                const double place = (a - b)/whole;
                const double whole2 = (rise_ == 0.0 ? 1.0 : rise_);
                const double height = (fa - fb)/whole2;
                const double safe = ((place < 1.0 - ((1.0 - height)*(1.0 - height))) &&
                    (place > (height*height)) ? 1.0 : 0.0);
                const double one = (safe > 0.0 ? -fa + fb : 1.0);
                const double two = (safe > 0.0 ? fb - fc : 1.0);
                const double three = (safe > 0.0 ? fa - fc : 1.0);
                const double width = -a + b;
                const double here = fa/one;
                const double there = fc/two;
                const double whole3 = (width == 0.0 ? 1.0 : width);
                const double other = fa/three;
                const double last = fb/two;
                const double guess = (safe > 0.0 ? here*there + last*other*(-a + c)/whole3 : 0.5);
                const double edge = 4.440892098500626e-16*fabs((fabs(fa) < fabs(fb) ? a : b))/
                    fabs(whole3);
                const double edge2 = fmin(0.5, edge);
                const double share = fmin(guess, 1.0 - edge2);
                const double share2 = fmax(edge2, share);
                const double new_ = a + share2*width;
                const double turned3 = turn(new_, l, epsilon);
                const double wall5 = cos(turned3)/(l + 1.0);
                const double wall6 = sin(turned3) - 0.5*cos(turned3)/(l + 1.0);
                const double need3 = need(wall5, wall6, l, epsilon, new_);
                const double value = -epsilon*(1.0 - epsilon)*(wall5 + 2.0*wall6)*
                    (sin(new_)*sin(new_)) + need3*(epsilon*
                    (-cos_next(l, 2.0*new_) + cos_next(l + 1.0, 2.0*new_)) + cos_next(l, 2.0*new_));
                const double next_b = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? b : a);
                const double next_fb = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? fb : fa);
                const double next_a = new_;
                const double next_fa = value;
                const double next_c = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? a : b);
                const double next_fc = (((fa < 0.0) && (value < 0.0)) ||
                    ((fa > 0.0) && (value > 0.0)) ? fa : fb);
                b = next_b;
                fb = next_fb;
                a = next_a;
                fa = next_fa;
                c = next_c;
                fc = next_fc;
            }
            root = (fabs(fa) < fabs(fb) ? a : b);
        }
    }
    return 2.0*root;
}

void haptic_discretize(double gamma, double delta, double *n1_out, double *n0_out, double *a_out,
    double *e_out) {
    if (!((delta <= 1e+70) && (delta >= 0.0) && (gamma <= 1e+70) && (gamma >= 0.0))) {
        *n1_out = NAN;
        *n0_out = NAN;
        *a_out = NAN;
        *e_out = NAN;
        return;
    }
    double fall_of, rise_of, swing_of;
    fall_rise_swing(gamma, delta, &fall_of, &rise_of, &swing_of);
    *n1_out = rise_of;
    *n0_out = fall_of;
    *a_out = swing_of;
    *e_out = exp(-delta);
    return;
}

void haptic_discretize_late(double gamma, double delta, double epsilon, double *m2_out,
    double *m1_out, double *m0_out, double *a_out, double *e_out) {
    if (!((delta <= 1e+70) && (delta >= 0.0) && (epsilon < 1.0) && (epsilon >= 0.0) &&
        (gamma <= 1e+70) && (gamma >= 0.0))) {
        *m2_out = NAN;
        *m1_out = NAN;
        *m0_out = NAN;
        *a_out = NAN;
        *e_out = NAN;
        return;
    }
    double swing_of, together_of;
    swing_together(gamma, delta, &swing_of, &together_of);
    const double t0 = 1.0 - epsilon;
    const double t1 = (t0*t0);
    const double t2 = delta*t0;
    const double rise_of = rise(gamma*t1, t2);
    const double t3 = rise_of*t1;
    const double t4 = (epsilon*epsilon);
    const double fall_of = fall(gamma*t4, delta*epsilon);
    const double t5 = fall_of*t4*exp(-t2);
    *m2_out = t3;
    *m1_out = -t3 - t5 + together_of;
    *m0_out = t5;
    *a_out = swing_of;
    *e_out = exp(-delta);
    return;
}

bool haptic_is_stable(double alpha, double beta, double gamma, double delta, double d) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70) && (gamma <= 1e+70) && (gamma >= 0.0))) {
        return false;
    }
    if (late_part(d) == 0.0) {
        double apart_of, fall_of2, nyquist_of, rise_of3, together_of;
        apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of,
            &rise_of3, &together_of);
        const double t1 = gamma*together_of;
        const double t3 = delta*decay(delta);
        return stable(whole_roots(alpha, beta, d, rise_of3, fall_of2, t1, nyquist_of, t3,
            together_of, apart_of*delta), alpha, beta, gamma, delta) != 0.0;
    }
    double apart_of, fall_of2, nyquist_of, rise_of3, together_of;
    apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of, &rise_of3,
        &together_of);
    const double t1 = gamma*together_of;
    const double t3 = delta*decay(delta);
    const double t4 = some_part(d);
    const double t5 = 1.0 - t4;
    const double t6 = (t5*t5);
    const double t7 = gamma*t6;
    const double t8 = delta*t5;
    double apart_of3, fall_of3, kick_of2, kick_low_of2, rise_of;
    apart_fall_kick_kick_low_rise(t7, t8, &apart_of3, &fall_of3, &kick_of2, &kick_low_of2,
        &rise_of);
    const double t10 = (t4*t4);
    const double t11 = gamma*t10;
    const double t12 = delta*t4;
    double apart_of2, fall_of, kick_of, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t11, t12, &apart_of2, &fall_of, &kick_of, &kick_low_of,
        &rise_of2);
    const double t13 = fall_of*t10;
    return stable(late_roots(alpha, beta, whole_part(d), rise_of*t6, t13*exp(-t8), t1, nyquist_of,
        t3, together_of, late_apart(t4, kick_of2, kick_low_of2, kick_of, kick_low_of, apart_of3*
        delta*(t5*t5*t5), apart_of2*delta*(t4*t4*t4), fall_of3*t6*(kick_of*t12 + rise_of2*t11) +
        rise_of*rise_of2*t10*t7 - t13*t8*decay(t8))), alpha, beta, gamma, delta) != 0.0;
}

double haptic_unstable_roots(double alpha, double beta, double gamma, double delta, double d) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70) && (gamma <= 1e+70) && (gamma >= 0.0))) {
        return -1.0;
    }
    if (late_part(d) == 0.0) {
        double apart_of, fall_of2, nyquist_of, rise_of3, together_of;
        apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of,
            &rise_of3, &together_of);
        const double t1 = gamma*together_of;
        const double t3 = delta*decay(delta);
        return whole_roots(alpha, beta, d, rise_of3, fall_of2, t1, nyquist_of, t3, together_of,
            apart_of*delta);
    }
    double apart_of, fall_of2, nyquist_of, rise_of3, together_of;
    apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of2, &nyquist_of, &rise_of3,
        &together_of);
    const double t1 = gamma*together_of;
    const double t3 = delta*decay(delta);
    const double t4 = some_part(d);
    const double t5 = 1.0 - t4;
    const double t6 = (t5*t5);
    const double t7 = gamma*t6;
    const double t8 = delta*t5;
    double apart_of3, fall_of3, kick_of2, kick_low_of2, rise_of;
    apart_fall_kick_kick_low_rise(t7, t8, &apart_of3, &fall_of3, &kick_of2, &kick_low_of2,
        &rise_of);
    const double t10 = (t4*t4);
    const double t11 = gamma*t10;
    const double t12 = delta*t4;
    double apart_of2, fall_of, kick_of, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t11, t12, &apart_of2, &fall_of, &kick_of, &kick_low_of,
        &rise_of2);
    const double t13 = fall_of*t10;
    return late_roots(alpha, beta, whole_part(d), rise_of*t6, t13*exp(-t8), t1, nyquist_of, t3,
        together_of, late_apart(t4, kick_of2, kick_low_of2, kick_of, kick_low_of, apart_of3*delta*
        (t5*t5*t5), apart_of2*delta*(t4*t4*t4), fall_of3*t6*(kick_of*t12 + rise_of2*t11) + rise_of*
        rise_of2*t10*t7 - t13*t8*decay(t8)));
}

void haptic_stability_boundary(double theta, double gamma, double delta, double d,
    double *alpha_out, double *beta_out) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (gamma <= 1e+70) && (gamma >= 0.0) && (theta <= 3.141592653589793) && (theta > 0.0))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0) {
        double cos_next_of, sin_next_of;
        cos_next_sin_next(d, theta, &cos_next_of, &sin_next_of);
        double apart_of, nyquist_of, together_of;
        apart_nyquist_together(gamma, delta, &apart_of, &nyquist_of, &together_of);
        const double t1 = 0.5*theta;
        const double t3 = gamma*together_of;
        const double t5 = delta*decay(delta);
        const double t6 = apart_of*delta;
        const double t7 = t6 + together_of;
        double ahead_of, in_phase_of;
        ahead_in_phase(t1, t3, nyquist_of, t5, together_of, t6, t7, &ahead_of, &in_phase_of);
        const double t11 = tan(t1);
        const double t12 = ahead_of*cos_next_of + in_phase_of*sin_next_of;
        const double t13 = sin(theta);
        *alpha_out = ahead_of*sin_next_of - cos_next_of*in_phase_of + t11*t12;
        *beta_out = -t12/t13;
        return;
    }
    double apart_of, nyquist_of, together_of;
    apart_nyquist_together(gamma, delta, &apart_of, &nyquist_of, &together_of);
    const double t1 = 0.5*theta;
    const double t3 = gamma*together_of;
    const double t5 = delta*decay(delta);
    const double t11 = tan(t1);
    const double t13 = sin(theta);
    const double t14 = whole_part(d);
    double cos_next_of2, sin_next_of2;
    cos_next_sin_next(t14, theta, &cos_next_of2, &sin_next_of2);
    const double t16 = some_part(d);
    const double t17 = 1.0 - t16;
    const double t18 = (t17*t17);
    const double t19 = gamma*t18;
    const double t20 = delta*t17;
    double apart_of2, fall_of2, kick_of2, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t19, t20, &apart_of2, &fall_of2, &kick_of2, &kick_low_of,
        &rise_of2);
    const double t21 = (t16*t16);
    const double t22 = gamma*t21;
    const double t23 = delta*t16;
    double apart_of3, fall_of, kick_of, kick_low_of2, rise_of;
    apart_fall_kick_kick_low_rise(t22, t23, &apart_of3, &fall_of, &kick_of, &kick_low_of2,
        &rise_of);
    const double t25 = fall_of*t21;
    const double t28 = late_apart(t16, kick_of2, kick_low_of, kick_of, kick_low_of2, apart_of2*
        delta*(t17*t17*t17), apart_of3*delta*(t16*t16*t16), fall_of2*t18*
        (kick_of*t23 + rise_of*t22) + rise_of*rise_of2*t19*t21 - t20*t25*decay(t20));
    const double t29 = 2.0*rise_of2*t18 - 2.0*t25*exp(-t20);
    double ahead_of2, in_phase_of2;
    ahead_in_phase(t1, t3, nyquist_of, t5, together_of, t28, t29, &ahead_of2, &in_phase_of2);
    const double t33 = ahead_of2*cos_next_of2 + in_phase_of2*sin_next_of2;
    *alpha_out = ahead_of2*sin_next_of2 - cos_next_of2*in_phase_of2 + t11*t33;
    *beta_out = -t33/t13;
    return;
}

void haptic_max_stable_stiffness(double gamma, double delta, double d, double *alpha_out,
    double *beta_out, double *theta_out) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (gamma <= 1e+70) && (gamma >= 0.0))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        *theta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0) {
        double apart_of, fall_of, nyquist_of, rise_of, together_of;
        apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of, &nyquist_of, &rise_of,
            &together_of);
        const double t1 = gamma*together_of;
        const double t3 = delta*decay(delta);
        const double t4 = apart_of*delta;
        const double t5 = stiffest_angle(gamma, delta, d, d, 0.0, rise_of, fall_of, t1, nyquist_of,
            t3, together_of, t4);
        double cos_next_of, sin_next_of;
        cos_next_sin_next(d, t5, &cos_next_of, &sin_next_of);
        const double t7 = 0.5*t5;
        const double t8 = sin(t7);
        const double t9 = cos(t7);
        const double t10 = t4 + together_of;
        const double t11 = (t9*t9);
        const double t12 = (t8*t8);
        const double t13 = t11*t12;
        const double t14 = t11*together_of - t12*t4;
        const double t15 = 1.0/((t10*t10)*t13 + (t14*t14));
        const double t16 = 2.0*t3;
        const double t17 = -nyquist_of*t12 + t1*t11;
        const double t18 = -t10*t17 + t14*t16;
        const double t19 = t10*t13*t16 + t14*t17;
        const double t20 = cos_next_of*t15;
        const double t21 = -sin_next_of*t15*t19/sin(t5) - 0.5*t18*t20;
        *alpha_out = sin_next_of*t15*t18*t8*t9 - 2.0*t12*t21 - t19*t20;
        *beta_out = t21;
        *theta_out = t5;
        return;
    }
    double apart_of, fall_of, nyquist_of, rise_of, together_of;
    apart_fall_nyquist_rise_together(gamma, delta, &apart_of, &fall_of, &nyquist_of, &rise_of,
        &together_of);
    const double t1 = gamma*together_of;
    const double t3 = delta*decay(delta);
    const double t16 = 2.0*t3;
    const double t22 = whole_part(d);
    const double t23 = some_part(d);
    const double t24 = 1.0 - t23;
    const double t25 = (t24*t24);
    const double t26 = gamma*t25;
    const double t27 = delta*t24;
    double apart_of2, fall_of3, kick_of2, kick_low_of, rise_of2;
    apart_fall_kick_kick_low_rise(t26, t27, &apart_of2, &fall_of3, &kick_of2, &kick_low_of,
        &rise_of2);
    const double t29 = rise_of2*t25;
    const double t30 = (t23*t23);
    const double t31 = gamma*t30;
    const double t32 = delta*t23;
    double apart_of3, fall_of2, kick_of, kick_low_of2, rise_of3;
    apart_fall_kick_kick_low_rise(t31, t32, &apart_of3, &fall_of2, &kick_of, &kick_low_of2,
        &rise_of3);
    const double t33 = fall_of2*t30;
    const double t34 = t33*exp(-t27);
    const double t37 = late_apart(t23, kick_of2, kick_low_of, kick_of, kick_low_of2, apart_of2*
        delta*(t24*t24*t24), apart_of3*delta*(t23*t23*t23), fall_of3*t25*
        (kick_of*t32 + rise_of3*t31) + rise_of2*rise_of3*t26*t30 - t27*t33*decay(t27));
    const double t38 = stiffest_angle(gamma, delta, d, t22, t23, t29, t34, t1, nyquist_of, t3,
        together_of, t37);
    double cos_next_of2, sin_next_of2;
    cos_next_sin_next(t22, t38, &cos_next_of2, &sin_next_of2);
    const double t39 = 0.5*t38;
    const double t40 = sin(t39);
    const double t41 = cos(t39);
    const double t43 = 2.0*t29 - 2.0*t34;
    const double t44 = (t41*t41);
    const double t45 = (t40*t40);
    const double t46 = t44*t45;
    const double t47 = -t37*t45 + t44*together_of;
    const double t48 = 1.0/((t43*t43)*t46 + (t47*t47));
    const double t49 = -nyquist_of*t45 + t1*t44;
    const double t50 = t16*t47 - t43*t49;
    const double t51 = t16*t43*t46 + t47*t49;
    const double t52 = cos_next_of2*t48;
    const double t53 = -sin_next_of2*t48*t51/sin(t38) - 0.5*t50*t52;
    *alpha_out = sin_next_of2*t40*t41*t48*t50 - 2.0*t45*t53 - t51*t52;
    *beta_out = t53;
    *theta_out = t38;
    return;
}

double haptic_passivity_margin_at(double theta, double alpha, double beta, double delta, double d) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70) && (theta <= 3.141592653589793) &&
        (theta > 0.0))) {
        return NAN;
    }
    const double t0 = 0.5*theta;
    const double cos_next_of = cos_next(d, theta);
    const double sin_next_of = sin_next(2.0*d, t0);
    return -0.5*alpha*sin_next_of/sin(t0) + beta*cos_next_of + delta;
}

double haptic_passivity_margin(double alpha, double beta, double delta, double d) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(alpha) <= 1e+70) && (fabs(beta) <= 1e+70))) {
        return NAN;
    }
    return delta - largest_need(alpha, beta, d);
}

void haptic_passivity_boundary(double theta, double delta, double d, double *alpha_out,
    double *beta_out) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (theta <= 3.141592653589793) && (theta > 0.0))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0) {
        const double t0 = lead(theta, d, 0.0);
        const double t1 = delta/spread(d, theta);
        const double t2 = 0.5*theta;
        const double t15 = sinc(t2);
        const double sin_next_of = sin_next(d, theta);
        const double t3 = sin_next_of*(t15*t15)*(d + 1.0)/theta;
        *alpha_out = rated(t0, 2.0*t1*t3);
        *beta_out = rated(t0, t1*(-t3 + chord(d, theta)));
        return;
    }
    const double t2 = 0.5*theta;
    const double t4 = whole_part(d);
    const double t5 = some_part(d);
    const double t6 = lead(theta, t4, t5);
    const double t7 = t4 + 1.0;
    const double t8 = touching(theta, t4, t5);
    const double t9 = cos(t8);
    const double t10 = t9/t7;
    const double t11 = sin(t8);
    const double t12 = -0.5*t10 + t11;
    const double t13 = between(t5, straight(t10, t12, t4, t2), straight(t10, t12, t7, t2));
    const double t16 = sin(t2);
    const double t17 = cos(t2);
    const double t14 = delta/(0.5*t13 + 0.5*
        sqrt((t13*t13) + t5*(1.0 - t5)*(4.0*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7))));
    *alpha_out = rated(t6, t10*t14);
    *beta_out = rated(t6, t12*t14);
    return;
}

void haptic_max_passive_stiffness(double delta, double d, double *alpha_out, double *beta_out,
    double *theta_out) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0))) {
        *alpha_out = NAN;
        *beta_out = NAN;
        *theta_out = NAN;
        return;
    }
    if (late_part(d) == 0.0) {
        const double t0 = 3.141592653589793/(d + 1.0);
        const double t1 = tan(0.25*t0);
        const double t2 = 0.5*t0;
        *alpha_out = 2.0*delta*t1;
        *beta_out = delta*(-t1 + 2.0/(3.141592653589793*sinc(t2)));
        *theta_out = t2;
        return;
    }
    const double t3 = whole_part(d);
    const double t4 = t3 + 1.0;
    const double t5 = some_part(d);
    const double t6 = passive_angle(t3, t5);
    const double t7 = touching(t6, t3, t5);
    const double t8 = cos(t7);
    const double t9 = t8/t4;
    const double t10 = sin(t7);
    const double t11 = t10 - 0.5*t9;
    const double t12 = 0.5*t6;
    const double t13 = between(t5, straight(t9, t11, t3, t12), straight(t9, t11, t4, t12));
    const double t15 = sin(t12);
    const double t16 = cos(t12);
    const double t14 = delta/(0.5*t13 + 0.5*
        sqrt((t13*t13) + t5*(1.0 - t5)*(4.0*(t10*t10)*(t15*t15) + (t16*t16)*(t8*t8)/(t4*t4))));
    *alpha_out = t14*t9;
    *beta_out = t11*t14;
    *theta_out = t6;
    return;
}

double haptic_linear_limit(double beta, double delta, double d) {
    if (!((d <= 1000000000000000.0) && (d >= 0.0) && (delta <= 1e+70) && (delta >= 0.0) &&
        (fabs(beta) <= 1e+70))) {
        return NAN;
    }
    return (beta + delta)/(d + 0.5);
}
