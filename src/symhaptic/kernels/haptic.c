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

typedef struct { double hi, lo; } Pair; // and what its float misses
typedef struct { Pair fall, mean; } Fading;
typedef struct { Pair p, q; } Poles;
typedef struct { Pair p, slow, mean, ratio, far; } Creeping;
typedef struct { double half; Pair w; double root, reach; } Motion;
typedef struct { Pair even, odd; } Wave;
typedef struct { double near, risen, sunk, moved; } Turns;
typedef struct { double envelope; Pair even, wave; double near, risen, sunk, moved; } Swinging;
typedef struct { double n0, n1, trace; } Device;
typedef struct { double together, trace; } Device2;
typedef struct { double at_minus_one, kick, together, n_gap, n0, n1; } Device3;
typedef struct { double halves, rest, size, per, off, blur, slope, fast, bend, turn, spread; } Part;
typedef struct { Pair kick; double n_gap, n0, n1; } Device4;
typedef struct { double apart, m2, kicked, m0; } Delayed;
typedef struct { double at, still, away, loose, free, there; } Point;
typedef struct { double low, high; } Roots;
typedef struct { double ahead, in_phase; } Response;
typedef struct { double at_minus_one, kick, together, n_gap; } Device5;
typedef struct { double cosine, sine; } CosSin;
typedef struct { double at_minus_one, together, n_gap, n0, n1; } Device6;
typedef struct { double alpha, slope, far, d, n1, loss, together, apart, apart_off, n1_off, a_off,
    center, beyond; } Loop;

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static inline double decay_series(double x) {
    const double square = x*x;
    double one = 0.0, two = 0.0;
    for (int n = 19; n >= 4; n -= 1) {
        const double number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return square*two - one*x + 0.16666666666666666;
}

// x + y and what it misses, for |x| >= |y|
static inline Pair fast_two_sum(double x, double y) {
    const double total = x + y, back = total - x;
    return (Pair){total, y - back};
}

// 1 - x of a pair, for |x| <= 1
static inline Pair one_minus(Pair x) {
    const Pair total = fast_two_sum(1.0, -x.hi);
    return (Pair){total.hi, total.lo - x.lo};
}

// x y of a float and a pair
static inline Pair wide_prod(double x, Pair y) {
    return (Pair){x*y.hi, x*y.lo + fma(x, y.hi, -(x*y.hi))};
}

// x y of pairs
static inline Pair pair_prod(Pair x, Pair y) {
    const Pair prod = wide_prod(x.hi, y);
    return (Pair){prod.hi, prod.lo + x.lo*y.hi};
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4
static inline Fading brief_fading(Pair rate) {
    const Pair total = fast_two_sum(1.0, -0.5*rate.hi);
    const Pair total2 = fast_two_sum(total.hi, (rate.hi*rate.hi)*decay_series(rate.hi));
    const double bent = rate.lo*(0.125*(rate.hi*rate.hi) - 0.3333333333333333*rate.hi + 0.5);
    const double mean_low = total.lo - bent + total2.lo;
    return (Fading){one_minus(pair_prod(rate, (Pair){total2.hi, mean_low})), {total2.hi, mean_low}};
}

// x/y of pairs
static inline Pair pair_quot(Pair x, Pair y) {
    const double total = x.hi/y.hi, left = x.hi - total*y.hi;
    const double left2 = left - fma(total, y.hi, -(total*y.hi)), rest = x.lo - total*y.lo;
    const double left3 = left2 + rest;
    return (Pair){total, left3/y.hi};
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss
static inline Fading fading_pair(Pair rate) {
    if (rate.hi < 0.75) { return brief_fading(rate); }
    const double sunk = exp(-rate.hi), sunk_low = -rate.lo*sunk;
    return (Fading){{sunk, sunk_low}, pair_quot(one_minus((Pair){sunk, sunk_low}), rate)};
}

// what the root of |square + square_low| misses
static inline double root_miss(Pair square, double root) {
    const double sign_low = square.hi < 0.0 ? -square.lo : square.lo;
    const double left = fabs(square.hi) - (root*root), left2 = left - fma(root, root, -(root*root));
    const double left3 = left2 + sign_low, whole = root == 0.0 ? 1.0 : root;
    return 0.5*left3/whole;
}

// the poles p = half + root and q = gamma/p
static inline Poles real_poles(const Motion *motion, double gamma) {
    const Pair total = fast_two_sum(motion->half, motion->root);
    const double p_low = total.lo + root_miss(motion->w, motion->root);
    const double whole = total.hi == 0.0 ? 1.0 : total.hi;
    return (Poles){{whole, p_low}, pair_quot((Pair){gamma, 0.0}, (Pair){whole, p_low})};
}

// of a creeping device the pole p, exp and mean of the other one and of their distance
static inline Creeping creeping_device(const Motion *motion, double gamma) {
    const Poles poles = real_poles(motion, gamma);
    const Fading fading = fading_pair(poles.q);
    const double root_low = root_miss(motion->w, motion->root);
    const Fading fading2 = fading_pair((Pair){2.0*motion->root, 2.0*root_low});
    return (Creeping){poles.p, fading.fall, fading.mean, fading2.fall, fading2.mean};
}

// x - y and what it misses
static inline Pair two_diff(double x, double y) {
    const double total = x - y, back = total - x, rest = total - back, one = x - rest;
    const double two = -back - y;
    return (Pair){total, one + two};
}

// x y and what it misses
static inline Pair two_prod(double x, double y) { return (Pair){x*y, fma(x, y, -(x*y))}; }

// half = delta/2, w = half^2 - gamma, its root and the size of the poles
static inline Motion device_motion(double gamma, double delta) {
    const double half = 0.5*delta;
    const Pair prod = two_prod(half, half), diff = two_diff(prod.hi, gamma);
    const Pair total = fast_two_sum(diff.hi, diff.lo + prod.lo);
    const double root = sqrt(fabs(total.hi));
    return (Motion){half, total, root, total.hi < 0.0 ? 0.25*gamma : 0.4444444444444444*half +
        0.4444444444444444*root};
}

// 1 + x of a pair, for |x| <= 1
static inline Pair one_plus(Pair x) {
    const Pair total = fast_two_sum(1.0, x.hi);
    return (Pair){total.hi, total.lo + x.lo};
}

// x - y of pairs
static inline Pair pair_diff(Pair x, Pair y) {
    const Pair diff = two_diff(x.hi, y.hi);
    const double lost = diff.lo + x.lo;
    return (Pair){diff.hi, lost - y.lo};
}

// x^2 of a pair
static inline Pair pair_square(Pair x) { return wide_prod(x.hi, (Pair){x.hi, 2.0*x.lo}); }

// number + delta one - gamma two and what it misses, of pairs
static inline Pair plant_n0_term(double gamma, double delta, Pair one, Pair two, double number) {
    return pair_diff(pair_diff(wide_prod(delta, one), wide_prod(gamma, two)), (Pair){-number, 0.0});
}

// the float of a pair
static inline double rounded(Pair x) { return x.hi + x.lo; }

// divided difference of exp at 0, p and q, less 1/2
static inline double plant_n0_series(double gamma, double delta) {
    double one = 0.0, two = 0.0;
    for (int n = (0.5*delta < 0.0625 && fabs(gamma) < 0.00390625 ? 13 : 28); n >= 6; n -= 1) {
        const double number = inverse_factorial[n], next_one = delta*one - gamma*two + number;
        two = one; one = next_one;
    }
    const Pair one2 = plant_n0_term(gamma, delta, (Pair){one, 0.0}, (Pair){two, 0.0},
        0.008333333333333333);
    const Pair one3 = plant_n0_term(gamma, delta, one2, (Pair){one, 0.0}, 0.041666666666666664);
    return rounded(plant_n0_term(gamma, delta,
        plant_n0_term(gamma, delta, one3, one2, 0.16666666666666666), one3, 0.0));
}

// (fall + fall_low) (y + z), rounded once
static inline double scaled_sum(Pair fall, double y, double z) {
    return rounded(pair_prod(fall, two_diff(y, -z)));
}

// n0 of a device with slow poles
static inline double plant_n0_near(Pair decayed, double gamma, double delta) {
    return scaled_sum(pair_square(decayed), plant_n0_series(gamma, delta), 0.5);
}

// n0 of a creeping device
static inline double plant_n0_creep(const Motion *motion, const Creeping *creeping, Pair decayed,
    double gamma, double delta) {
    if (motion->reach < 0.5625) { return plant_n0_near(decayed, gamma, delta); }
    return rounded(pair_prod(creeping->slow,
        pair_quot(pair_diff(creeping->far, pair_prod(creeping->ratio, creeping->mean)),
        creeping->p)));
}

// x + y of pairs
static inline Pair pair_sum(Pair x, Pair y) {
    const Pair diff = two_diff(x.hi, -y.hi);
    const double lost = diff.lo + x.lo;
    return (Pair){diff.hi, lost + y.lo};
}

// n0 of a swinging device
static inline double plant_n0_swing(const Motion *motion, const Swinging *swinging, Pair decayed,
    double gamma) {
    if (motion->reach < 0.5625) { return plant_n0_near(decayed, gamma, 2.0*motion->half); }
    if (swinging->near > 0.0) { return swinging->sunk; }
    return rounded(pair_quot(wide_prod(swinging->envelope,
        pair_sum(pair_diff(wide_prod(motion->half, swinging->wave), swinging->even),
        (Pair){swinging->envelope, 0.0})), (Pair){gamma, 0.0}));
}

// divided difference of exp at h and +-sqrt(w), less 1/2
static inline double plant_n1_series(double h, double w) {
    double total = 0.0, one = 0.0, two = 0.0;
    for (int n = (fabs(w) < 0.00390625 && h < 0.0625 ? 13 : 28); n >= 3; n -= 1) {
        const double number = inverse_factorial[n], even = number + two*w;
        total = even + h*total; two = one; one = even;
    }
    return h*total + two*w;
}

// n1 of a creeping device
static inline double plant_n1_creep(const Motion *motion, const Creeping *creeping, Pair decayed) {
    if (motion->reach < 0.5625) {
        return scaled_sum(decayed, plant_n1_series(motion->half, motion->w.hi), 0.5);
    }
    return rounded(pair_quot(pair_diff(creeping->mean, pair_prod(creeping->slow, creeping->far)),
        creeping->p));
}

// n1 of a swinging device
static inline double plant_n1_swing(const Motion *motion, const Swinging *swinging, Pair decayed,
    double gamma) {
    if (motion->reach < 0.5625) {
        return scaled_sum(decayed, plant_n1_series(motion->half, motion->w.hi), 0.5);
    }
    if (swinging->near > 0.0) { return swinging->risen; }
    return rounded(pair_quot(one_minus(wide_prod(swinging->envelope,
        pair_sum(swinging->even, wide_prod(motion->half, swinging->wave)))), (Pair){gamma, 0.0}));
}

// exp(-half) of a device with slow poles, and what it misses
static inline Pair slow_fade(const Motion *motion) {
    if (motion->reach < 0.5625) {
        return pair_square(brief_fading((Pair){0.5*motion->half, 0.0}).fall);
    }
    return (Pair){0.0, 0.0};
}

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static inline double cos_series(double w) {
    const double square = w*w;
    double one = 0.0, two = 0.0;
    for (int n = 22; n >= 6; n -= 2) {
        const double number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.041666666666666664;
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static inline double sin_series(double w) {
    const double square = w*w;
    double one = 0.0, two = 0.0;
    for (int n = 21; n >= 5; n -= 2) {
        const double number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.16666666666666666;
}

// cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle
static inline Wave waving_pair(Pair square, double angle) {
    if (square.hi > -1.5) {
        const Pair total = fast_two_sum(1.0, 0.5*square.hi);
        const Pair total2 = fast_two_sum(total.hi, (square.hi*square.hi)*cos_series(square.hi));
        const double both = total.lo + total2.lo;
        return (Wave){{total2.hi, both + 0.5*square.lo},
            one_plus((Pair){square.hi*sin_series(square.hi), 0.16666666666666666*square.lo})};
    }
    const double angle_low = root_miss(square, angle), sine = sin(angle), cosine = cos(angle);
    return (Wave){{cosine, -angle_low*sine},
        pair_quot((Pair){sine, angle_low*cosine}, (Pair){angle, angle_low})};
}

// whether the device has nearly swung whole turns; n1, n0 and n1 + n0 there
static inline Turns whole_turns(double half, Pair square, double root, double stiff) {
    if (half < 0.75 && root > 3.0 && root < 67108864.0) {
        const double count = floor(0.5*root/3.141592653589793 + 0.5);
        const Pair prod3 = two_prod(count, 6.283185307179586), diff6 = two_diff(root, -prod3.hi);
        const double missed = root_miss(square, root), turns = count*count;
        const Pair prod = two_prod(turns, 39.47841760435743);
        const Pair prod2 = two_prod(turns, 2.5061182034958845e-15);
        const Pair diff = two_diff(-square.hi, prod.hi), diff2 = two_diff(diff.hi, prod.lo);
        const Pair diff3 = two_diff(diff2.hi, prod2.hi), diff4 = two_diff(diff3.hi, square.lo);
        const double turned_low = 1.4920070805839235e-31*turns;
        const double low = diff.lo + diff2.lo + diff3.lo + diff4.lo - prod2.lo - turned_low;
        const double back = 2.4492935982947064e-16*count;
        const Pair quot = pair_quot(two_diff(diff4.hi, -low),
            (Pair){diff6.hi, back + diff6.lo + missed + prod3.lo});
        const double far = quot.hi*quot.hi;
        if (count > 0.0 && far < 1.5) {
            const Fading fading = brief_fading((Pair){half, 0.0});
            const Pair less2 = one_minus(fading.fall), squared = pair_square(quot);
            const Pair less = one_minus((Pair){squared.hi*sin_series(-squared.hi), 0.0});
            const Pair prod4 = wide_prod(quot.hi, less);
            const double bent = (squared.hi*squared.hi)*cos_series(-squared.hi);
            const Pair total = fast_two_sum(0.5*squared.hi, -bent);
            const double lift_low = 0.5*less.hi*squared.lo + total.lo;
            const Pair prod5 = pair_prod(fading.fall, (Pair){total.hi, lift_low});
            const Pair quot2 = pair_quot((Pair){prod4.hi, prod4.lo + quot.lo*(1.0 - total.hi)},
                (Pair){root, missed});
            const Pair diff9 = pair_diff((Pair){total.hi, lift_low},
                wide_prod(half, pair_diff(fading.mean, quot2)));
            return (Turns){1.0, rounded(pair_quot(
                pair_sum(wide_prod(half, pair_diff(fading.mean, pair_prod(fading.fall, quot2))),
                prod5), (Pair){stiff, 0.0})), rounded(
                pair_quot(pair_prod(fading.fall, two_diff(diff9.hi, -diff9.lo)),
                (Pair){stiff, 0.0})), rounded(pair_quot(
                pair_sum(pair_square(fast_two_sum(less2.hi, less2.lo)),
                (Pair){2.0*prod5.hi, 2.0*prod5.lo}), (Pair){stiff, 0.0}))};
        }
    }
    return (Turns){0.0, 0.0, 0.0, 0.0};
}

// of a swinging device exp(-half), cos(root), sin(root)/root and what is near whole turns
static inline Swinging swinging_device(const Motion *motion, double gamma) {
    const Wave wave = waving_pair(motion->w, motion->root);
    const Turns turns = whole_turns(motion->half, motion->w, motion->root, gamma);
    return (Swinging){exp(-motion->half), wave.even, wave.odd, turns.near, turns.risen, turns.sunk,
        turns.moved};
}

// n0, n1 and trace of the device
static inline Device device_n0_n1_trace(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const double rounded_of = rounded(wide_prod(swinging.envelope, swinging.even));
        return (Device){plant_n0_swing(&motion, &swinging, decayed, gamma),
            plant_n1_swing(&motion, &swinging, decayed, gamma), 2.0*rounded_of};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device){plant_n0_creep(&motion, &creeping, decayed, gamma, delta),
        plant_n1_creep(&motion, &creeping, decayed),
        rounded(pair_prod(creeping.slow, one_plus(creeping.ratio)))};
}

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static inline double numerator_at_one_series(double h, double w) {
    const double y = h*h;
    double total = 0.0, inner = 0.0;
    for (int n = (fabs(w) < 0.00390625 && h < 0.0625 ? 12 : 28); n >= 4; n -= 2) {
        const double number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y;
}

// n1 + n0 of a creeping device
static inline double numerator_at_one_creep(const Motion *motion, const Creeping *creeping) {
    if (motion->reach < 1.0) {
        return 2.0*scaled_sum((Pair){exp(-motion->half), 0.0},
            numerator_at_one_series(motion->half, motion->w.hi), 0.5);
    }
    return rounded(pair_quot(pair_prod(creeping->mean,
        one_minus(pair_prod(creeping->slow, creeping->ratio))), creeping->p));
}

// (1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses
static inline Pair half_squares(double half, double envelope, double wave, double back) {
    const double grown = -0.5*expm1(-half);
    return pair_sum(wide_prod(envelope, pair_square(two_diff(wave, back))),
        (Pair){grown*grown, 0.0});
}

// n1 + n0 of a swinging device
static inline double numerator_at_one_swing(const Motion *motion, const Swinging *swinging,
    double gamma) {
    if (motion->reach < 1.0) {
        return 2.0*scaled_sum((Pair){swinging->envelope, 0.0},
            numerator_at_one_series(motion->half, motion->w.hi), 0.5);
    }
    if (swinging->near > 0.0) { return swinging->moved; }
    const double angle = 0.5*motion->root;
    const double back = -0.5*root_miss(motion->w, motion->root)*cos(angle);
    return 4.0*rounded(pair_quot(half_squares(motion->half, swinging->envelope, sin(angle), back),
        (Pair){gamma, 0.0}));
}

// together and trace of the device
static inline Device2 device_together_trace(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const double rounded_of = rounded(wide_prod(swinging.envelope, swinging.even));
        return (Device2){numerator_at_one_swing(&motion, &swinging, gamma), 2.0*rounded_of};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device2){numerator_at_one_creep(&motion, &creeping),
        rounded(pair_prod(creeping.slow, one_plus(creeping.ratio)))};
}

// n0, the same device with its time reversed, times exp(-delta)
static inline double plant_n0(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.reach < 0.5625) { return plant_n0_near(decayed, gamma, delta); }
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return plant_n0_swing(&motion, &swinging, decayed, gamma);
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return plant_n0_creep(&motion, &creeping, decayed, gamma, delta);
}

// n1, how far a unit force moves the device in a period
static inline double plant_n1(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.reach < 0.5625) {
        return scaled_sum(decayed, plant_n1_series(motion.half, motion.w.hi), 0.5);
    }
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return plant_n1_swing(&motion, &swinging, decayed, gamma);
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return plant_n1_creep(&motion, &creeping, decayed);
}

// (1 - exp(-x))/x
static inline double decay(double x) { return (x == 0.0 ? 1.0 : -expm1(-x)/x); }

// 1 + a + e of a creeping device
static inline double denominator_at_minus_one_creep(const Creeping *creeping) {
    return rounded(pair_prod(one_plus(creeping->slow),
        one_plus(pair_prod(creeping->slow, creeping->ratio))));
}

// 1 + a + e of a swinging device
static inline double denominator_at_minus_one_swing(const Motion *motion,
    const Swinging *swinging) {
    const Pair prod = wide_prod(2.0*swinging->envelope, swinging->even);
    if (prod.hi > 0.0) {
        return rounded(pair_sum(one_plus((Pair){exp(-2.0*motion->half), 0.0}), prod));
    }
    const double angle = 0.5*motion->root;
    return 4.0*rounded(half_squares(motion->half, swinging->envelope, cos(angle), 0.5*
        root_miss(motion->w, motion->root)*sin(angle)));
}

// divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6
static inline double numerator_gap_series(double h, double w) {
    const double y = h*h;
    double total = 0.0, inner = 0.0;
    for (int n = (fabs(w) < 0.00390625 && h < 0.0625 ? 13 : 27); n >= 5; n -= 2) {
        const double number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y + 9.25185853854297e-18;
}

// (n1 - n0)/delta of a creeping device
static inline double numerator_gap_creep(const Motion *motion, const Creeping *creeping,
    double delta) {
    if (motion->reach < 1.0) {
        return scaled_sum((Pair){exp(-motion->half), 0.0},
            numerator_gap_series(motion->half, motion->w.hi), 0.16666666666666666);
    }
    const Pair diff = pair_diff(creeping->mean, wide_prod(2.0*creeping->slow.hi, creeping->far));
    const Pair prod2 = wide_prod(creeping->ratio.hi*creeping->slow.hi, creeping->mean);
    const double top = diff.hi + prod2.hi, low = diff.lo + prod2.lo, whole = delta*creeping->p.hi;
    return (low + top)/whole;
}

// (n1 - n0)/delta of a swinging device
static inline double numerator_gap_swing(const Motion *motion, const Swinging *swinging,
    double gamma, double delta) {
    if (motion->reach < 1.0) {
        return scaled_sum((Pair){swinging->envelope, 0.0},
            numerator_gap_series(motion->half, motion->w.hi), 0.16666666666666666);
    }
    return rounded(pair_quot(pair_diff((Pair){decay(delta), 0.0},
        wide_prod(swinging->envelope, swinging->wave)), (Pair){gamma, 0.0}));
}

// at_minus_one, kick, together, n_gap, n0 and n1 of the device
static inline Device3 device_at_minus_one_kick_together_n_gap_n0_n1(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const Pair decayed = slow_fade(&motion);
        return (Device3){denominator_at_minus_one_swing(&motion, &swinging),
            rounded(wide_prod(swinging.envelope, swinging.wave)),
            numerator_at_one_swing(&motion, &swinging, gamma),
            numerator_gap_swing(&motion, &swinging, gamma, delta),
            plant_n0_swing(&motion, &swinging, decayed, gamma),
            plant_n1_swing(&motion, &swinging, decayed, gamma)};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    const Pair decayed = slow_fade(&motion);
    return (Device3){denominator_at_minus_one_creep(&creeping),
        rounded(pair_prod(creeping.slow, creeping.far)),
        numerator_at_one_creep(&motion, &creeping), numerator_gap_creep(&motion, &creeping, delta),
        plant_n0_creep(&motion, &creeping, decayed, gamma, delta),
        plant_n1_creep(&motion, &creeping, decayed)};
}

// the root of a cubic on a piece where it bends one way
static inline double cubic_root(double k0, double k1, double k2, double k3, double low,
    double high, double rise) {
    const double convex = 2.0*k2 + 3.0*k3*(high + low) > 0.0 ? 1.0 : -1.0;
    const double down = convex*rise > 0.0 ? 1.0 : -1.0;
    double y = down > 0.0 ? high : low, moves = 1.0;
    for (int count_y = 0; count_y < 1000; ++count_y) {
        if (moves == 0.0) { break; }
        const double steep = k1 + y*(2.0*k2 + 3.0*k3*y), some = steep == 0.0 ? 1.0 : steep;
        const double move = steep == 0.0 ? 0.0 : (k0 + y*(k1 + y*(k2 + k3*y)))/some;
        const double new_ = fmin(high, y - move), new2 = fmax(low, new_);
        moves = down*(y - new2) > 0.0 ? 1.0 : 0.0; y = new2;
    }
    return y;
}

// of x + j u: half turns and the rest of the angle, the size and its inverse, how far both may be
// off, and how they change with y
static inline Part crossing_part(double x, double u, double x_off, double u_off, double steep,
    double low, double high) {
    const double most = fmax(fabs(u), fabs(x)), least = fmin(fabs(u), fabs(x));
    const double whole = most == 0.0 ? 1.0 : most, ratio = least/whole;
    const double longer = sqrt(ratio*ratio + 1.0), size = longer*most;
    const double whole2 = size == 0.0 ? 1.0 : size, per = 1.0/whole2, real = per*x, up = per*u;
    const double along = per*x_off, across = per*u_off, away = across + along, one = fabs(real);
    const double two = fabs(up), blur = (2.0*away + 1.0)*(across*one + along*two);
    const double rest = atan2(x < 0.0 ? -u : u, fabs(x)), falls = per*steep;
    const double tilt = 0.5*low - 0.5*high, square = up*up;
    const double fast = square*(high + low) + 2.0*fabs(falls);
    return (Part){x < 0.0 ? (u < 0.0 ? -1.0 : 1.0) : 0.0, rest, size, per, size > 0.0 ? across*
        two + along*one + away*away : 1.0, away < 0.25 ? blur + 4.440892098500626e-16*fabs(rest) :
        4.0, 2.0*falls*real + 2.0*square*tilt, fast, 2.0*(falls*falls) + fast*fast + 2.0*high*low*
        square, up*(real*tilt - falls), two*(one*fabs(tilt) + fabs(falls))};
}

// the nearest whole number of turns in the phase at a crossing, NaN where that is not certain
static inline double phase_turns(const Loop *loop, double y, double rest, double off, double loose,
    double free) {
    const double at = fmax(0.0, y), still = fmax(0.0, rest), sine = 2.0*sqrt(at*still);
    const double total = 2.0 - loop->loss, plain = loose + 4.440892098500626e-16;
    const double made = loose + 1.3322676295501878e-15, edge = fmin(at, still);
    const double whole = at == 0.0 ? 1.0 : at, low = edge/whole;
    const double whole2 = still == 0.0 ? 1.0 : still, high = edge/whole2;
    const Part part2 = crossing_part(still*loop->together - loop->apart*at, loop->n1*sine,
        loop->apart_off*at + made*(at*fabs(loop->apart) + still*loop->together), sine*
        (made*fabs(loop->n1) + loop->n1_off), edge*(-loop->apart - loop->together), low, high);
    const Part part3 = crossing_part(loop->alpha*still - at*loop->far, sine*loop->slope, plain*
        (at*fabs(loop->far) + still*fabs(loop->alpha)), plain*sine*fabs(loop->slope), edge*
        (-loop->alpha - loop->far), low, high);
    const Part part = crossing_part(-2.0*off*total, loop->loss*sine, 4.0*loop->a_off + total*
        (2.0*free + 8.881784197001252e-16*fabs(off)), loop->loss*made*sine, -2.0*edge*total, low,
        high);
    const double ratio = part.per*part2.size, gap_ = 1.0 - 0.25*ratio*part3.size;
    const double rough = part.off + part2.off + part3.off + 1.3322676295501878e-15;
    const double distant = fabs(gap_), miss = 3.0*part.off + 8.881784197001252e-16;
    const double miss2 = 3.0*part2.off + 8.881784197001252e-16;
    const double miss3 = 3.0*part3.off + 8.881784197001252e-16;
    const double sure = -part.fast*miss - part2.fast*miss2 - part3.fast*miss3 +
        fabs(part2.slope - part.slope + part3.slope);
    const double whole3 = sure == 0.0 ? 1.0 : sure, reach = 0.25*(9.0*distant + 9.0*rough)/whole3;
    const double bends = part.bend + part2.bend + part3.bend;
    const double half = atan2(at > 2.0 ? sqrt(still) : sqrt(at), at > 2.0 ? sqrt(at) : sqrt(still));
    const double late = loop->d + 2.0;
    const double halves4 = part2.halves - part.halves + part3.halves - (at > 2.0 ? late : 0.0);
    const double share = 0.5*(-late*(at > 2.0 ? -2.0*half : 2.0*half) - part.rest + part2.rest +
        part3.rest)/3.141592653589793;
    const double even = floor(0.5*halves4), left = 0.5*halves4 - even;
    const double near = fabs(share - floor(share + 0.5));
    const double distance = left == 0.5 ? near : 0.5 - near, whole4 = sine == 0.0 ? 1.0 : sine;
    const double delayed = 2.0*edge*late/whole4;
    const double most = delayed + part.spread + part2.spread + part3.spread;
    const double blur_ = part.blur + part2.blur + part3.blur + half*late*
        (loose + 8.881784197001252e-16) + reach*
        (8.881784197001252e-16*delayed + miss*part.spread + miss2*part2.spread + miss3*
        part3.spread + 2.0*most*reach*(part.fast + part2.fast + part3.fast + 2.0) +
        fabs(delayed + part.turn - part2.turn - part3.turn));
    const double good = blur_ < 6.0*distance && reach < 0.25 && sure > 0.0 && sure > 8.0*bends*
        reach ? 1.0 : 0.0;
    if (good > 0.0) {
        return even + (left == 0.5 ? floor(share) + 1.0 : floor(left + share + 0.5));
    }
    return NAN;
}

// what the crossing on a piece, if there is one, adds
static inline double piece_turns(const Loop *loop, double k0, double k1, double k2, double k3,
    double low, double high, double at_low, double at_high, double zone) {
    if (((at_high >= 0.0 && at_low < 0.0) || (at_high < 0.0 && at_low >= 0.0)) &&
        (at_low != 0.0 || low != 0.0) && high > low) {
        const double x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const double y = zone == 0.0 ? x : (zone == 1.0 ? loop->center + x : 4.0 - x);
        const double rest = zone == 0.0 ? 4.0 - x : (zone == 1.0 ? loop->beyond - x : x);
        if (rest > 0.0 && y > 0.0) {
            const double off = zone == 0.0 ? x - loop->center :
                (zone == 1.0 ? x : loop->beyond - x);
            const double loose = zone == 1.0 ? 1.7763568394002505e-15 : 2.220446049250313e-16;
            const double free = zone == 1.0 ? 0.0 : 8.881784197001252e-16*
                (zone == 0.0 ? loop->center : loop->beyond);
            const double found = phase_turns(loop, y, rest, off, loose, free);
            const double rises = (zone == 2.0 ? -1.0 : 1.0)*(at_high > at_low ? 1.0 : -1.0);
            return -2.0*found*rises;
        }
        return NAN;
    }
    return 0.0;
}

// NaN where it is not certain that the device is stronger if leads is positive, and else the wall,
// else 0
static inline double touches(const Loop *loop, double leads, double y, double rest, double off,
    double loose, double free) {
    const double at = fmax(0.0, y), still = fmax(0.0, rest), sine = 2.0*sqrt(at*still);
    const double total = 2.0 - loop->loss, plain = loose + 4.440892098500626e-16;
    const Part part3 = crossing_part(loop->alpha*still - at*loop->far, sine*loop->slope, plain*
        (at*fabs(loop->far) + still*fabs(loop->alpha)), plain*sine*fabs(loop->slope), 0.0, 0.0,
        0.0);
    const double made = loose + 1.3322676295501878e-15;
    const Part part2 = crossing_part(still*loop->together - loop->apart*at, loop->n1*sine,
        loop->apart_off*at + made*(at*fabs(loop->apart) + still*loop->together), sine*
        (made*fabs(loop->n1) + loop->n1_off), 0.0, 0.0, 0.0);
    const Part part = crossing_part(-2.0*off*total, loop->loss*sine, 4.0*loop->a_off + total*
        (2.0*free + 8.881784197001252e-16*fabs(off)), loop->loss*made*sine, 0.0, 0.0, 0.0);
    const double ratio = part.per*part2.size, gap_ = 1.0 - 0.25*ratio*part3.size;
    const double rough = part.off + part2.off + part3.off + 1.3322676295501878e-15;
    const double signed_ = leads > 0.0 ? gap_ : -gap_, good = signed_ > 2.0*rough ? 1.0 : 0.0;
    if (good < 1.0 && rest > 0.0 && y > 0.0) { return NAN; }
    return 0.0;
}

// NaN where the wall may be as strong as the device at an extremum of both, else 0
static inline double zone_touches(const Loop *loop, double leads, double x, double zone) {
    const double y = zone == 0.0 ? x : (zone == 1.0 ? loop->center + x : 4.0 - x);
    const double rest = zone == 0.0 ? 4.0 - x : (zone == 1.0 ? loop->beyond - x : x);
    const double off = zone == 0.0 ? x - loop->center : (zone == 1.0 ? x : loop->beyond - x);
    const double loose = zone == 1.0 ? 1.7763568394002505e-15 : 2.220446049250313e-16;
    const double free = zone == 1.0 ? 0.0 : 8.881784197001252e-16*
        (zone == 0.0 ? loop->center : loop->beyond);
    return touches(loop, leads, y, rest, off, loose, free);
}

// what the crossings between two points add to the count
static inline double zone_turns(const Loop *loop, double k0, double k1, double k2, double k3,
    double low, double high, double at_low, double at_high, double zone) {
    const double disc = k2*k2 - 3.0*k1*k3, root = sqrt(fmax(0.0, disc));
    const double q = -k2 - (k2 < 0.0 ? -root : root);
    const double some = fabs(k2) < 24.0*fabs(k3) ? 3.0*k3 : 1.0, at = -k2/some;
    const double cut = at > low && at < high && fabs(k2) < 24.0*fabs(k3) ? at : low;
    const double some2 = fabs(q) < 24.0*fabs(k3) ? 3.0*k3 : 1.0, at2 = q/some2;
    const double cut2 = at2 > low && at2 < high && fabs(q) < 24.0*fabs(k3) ? at2 : low;
    const double some3 = fabs(k1) < 8.0*fabs(q) ? q : 1.0, at3 = k1/some3;
    const double cut3 = at3 > low && at3 < high && fabs(k1) < 8.0*fabs(q) ? at3 : low;
    const double less = fmin(cut2, cut3), more = fmax(cut2, cut3), first = fmin(cut, less);
    const double middle = fmax(cut, less), last = fmax(middle, more), middle2 = fmin(middle, more);
    const double p = first*(first*(first*k3 + k2) + k1) + k0;
    const double p2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2));
    const double p3 = k0 + last*(k1 + last*(k2 + k3*last));
    const double value2 = cut3*(cut3*(cut3*k3 + k2) + k1) + k0;
    double found = 0.0;
    if (cut2 > low) {
        const double value = cut2*(cut2*(cut2*k3 + k2) + k1) + k0;
        found = zone_touches(loop, value, cut2, zone);
    }
    const double found2 = found + (cut3 > low ? zone_touches(loop, value2, cut3, zone) : 0.0);
    const double found3 = found2 + piece_turns(loop, k0, k1, k2, k3, low, first, at_low, p, zone);
    const double found4 = found3 + piece_turns(loop, k0, k1, k2, k3, first, middle2, p, p2, zone);
    const double found5 = found4 + piece_turns(loop, k0, k1, k2, k3, middle2, last, p2, p3, zone);
    return found5 + piece_turns(loop, k0, k1, k2, k3, last, high, p3, at_high, zone);
}

// roots outside the unit circle behind a fractional delay, -1 where that is not certain
static inline double fractional_roots(double alpha, double beta, double d, double m2, double m0,
    double gamma, double at_minus_one, double loss, double together, double apart, double across) {
    if (alpha == 0.0 && beta == 0.0) { return 0.0; }
    const double strength = fabs(alpha) + fabs(beta), stiffest = fmax(gamma, fabs(alpha));
    const double slope = alpha + beta, wall_far = alpha + 2.0*beta, force = beta*slope;
    const double lost = loss*loss, square = m0*m2, size = across*across, at_one = gamma*together;
    const double size2 = m2 + together + fabs(m0), near_half = sqrt(fmin(1.0, at_minus_one));
    const double whole = gamma == 0.0 ? 1.0 : gamma;
    const double apart_off = 7.105427357601002e-15*near_half*size2;
    const double n1_off = 1.4210854715202004e-14*
        (gamma > 10.0 && loss < 0.5 ? 2.0*sqrt(fmin(1.0, at_one))/whole : 0.125*size2);
    const double a_off = 1.5777218104420236e-30*sqrt(at_minus_one*gamma);
    const double apart_one = (gamma - alpha)*(alpha + gamma), even = together*together;
    const double even2 = together*(m0 + m2), linear = size - even2, push = alpha*alpha;
    const double near0 = apart_one*even;
    const double near1 = -at_one*(2.0 - loss) - force*(together*together) - linear*push + lost;
    const double near2 = -force*linear - loss - push*square + 1.0, near3 = -force*square;
    const double most = at_one*(2.0 - loss) + lost + push*(size + fabs(even2)) +
        (together*together)*fabs(force);
    const double blurred = n1_off*(n1_off + 2.0*fabs(across)), pull = fabs(apart*wall_far);
    const double end_off = a_off + apart_off*fabs(wall_far) + 1.7763568394002505e-15*at_minus_one +
        1.7763568394002505e-15*pull;
    const double end_apart = fabs(at_minus_one - pull) - end_off;
    const double end_least = end_apart*(at_minus_one + pull);
    const double room = (alpha*alpha)*blurred + 3.552713678800501e-15*most;
    const double product = 4.0*near0*near2, pushed_ = apart*wall_far, even3 = apart*(m0 + m2);
    const double linear2 = size - even3, push2 = wall_far*wall_far;
    const double far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_);
    const double far1 = (apart*apart)*force - at_minus_one*(2.0 - loss) - linear2*push2 + lost;
    const double far2 = force*linear2 - loss - push2*square + 1.0, far3 = force*square;
    const double most2 = (apart*apart)*fabs(force) + at_minus_one*(2.0 - loss) + lost + push2*
        (size + fabs(even3));
    const double even4 = apart_off*(m2 + fabs(m0));
    const double room2 = 2.0*a_off + apart_off*(apart_off + 2.0*fabs(apart))*fabs(force) +
        3.552713678800501e-15*most2 + (wall_far*wall_far)*(blurred + even4);
    const double product2 = 4.0*far0*far2;
    if ((((stiffest > 0.0 && stiffest < 3.8725919148493183e-121) || loss +
        strength < 3.8725919148493183e-121) && strength > 0.0) ||
        (end_least <= 8.0*room2 + 128.0*fabs(far3) && product2 >= 0.0 && product2 <= room2*room2 &&
        room2 >= fabs(far1)) || (fabs(near0) <= 8.0*room + 128.0*fabs(near3) && product >= 0.0 &&
        product <= room*room && room >= fabs(near1)) || end_apart <= 0.0) {
        return -1.0;
    }
    const double middle = 2.0*at_one/(2.0 - loss), rest = 2.0*at_minus_one/(2.0 - loss);
    const double sine = 0.25*middle*rest, tilt = 0.25*rest - 0.25*middle;
    const double real = 0.25*rest*together - 0.25*apart*middle, one = real*real + sine*size;
    const double two = size*tilt - real*(m0 + m2), wave = 0.25*alpha*rest - 0.25*middle*wall_far;
    const double wall = sine*(slope*slope) + wave*wave, own0 = lost*sine - one*wall;
    const double own1 = lost*tilt - force*one - two*wall;
    const double own2 = -force*two - loss - square*wall + 1.0, own3 = -force*square;
    const double one2 = 0.5*middle, two2 = 0.5*rest;
    const double before = own0 - one2*(own1 - one2*(own2 - one2*own3));
    const double after = own0 + two2*(own1 + two2*(own2 + own3*two2)), zone = 0.0;
    const double side = slope >= 0.0 ? 1.0 : -1.0;
    const double end = (wall_far > 0.0 ? side : 0.0) - d +
        (apart > 0.0 ? (across >= 0.0 ? 1.0 : -1.0) : 0.0) - 3.0;
    const Loop loop = {alpha, slope, wall_far, d, across, loss, together, apart, apart_off, n1_off,
        a_off, middle, rest};
    const double total = ((((((near2 == 0.0 && near3 < 0.0) || near2 < 0.0) && near1 == 0.0) ||
        near1 < 0.0) && near0 == 0.0) || near0 < 0.0 ? (alpha > 0.0 ? 0.0 : side) : 0.0) +
        zone_turns(&loop, far0, far1, far2, far3, zone, two2, far0, after, 2.0) +
        zone_turns(&loop, near0, near1, near2, near3, zone, one2, near0, before, zone) +
        zone_turns(&loop, own0, own1, own2, own3, -one2, two2, before, after, 1.0);
    const double total2 = total - ((((((far2 == 0.0 && far3 < 0.0) || far2 < 0.0) &&
        far1 == 0.0) || far1 < 0.0) && far0 == 0.0) || far0 < 0.0 ? end : 0.0);
    return (total2 >= 0.0 ? total2 : -1.0);
}

// m2 - m1 + m0 of the device behind a fraction of a period
static inline double fractional_numerator_gap(double epsilon, Pair x, Pair y, double first,
    double last, double turned) {
    const Pair prod3 = pair_prod(wide_prod(epsilon, one_minus((Pair){epsilon, 0.0})),
        pair_prod(x, y));
    return rounded(pair_sum(pair_diff(pair_diff((Pair){first, 0.0},
        (Pair){2.0*prod3.hi, 2.0*prod3.lo}), (Pair){last, 0.0}), (Pair){turned, 0.0}));
}

// m2 - m1 + m0 of a device that swings, hardly damped
static inline double half_turned_swing(double gamma, double delta, double part) {
    const Motion motion = device_motion(gamma, delta);
    const double angle = 0.5*motion.root, angle_low = 0.5*root_miss(motion.w, motion.root);
    const Pair prod = pair_prod((Pair){angle, angle_low}, fast_two_sum(1.0, -part));
    const Pair prod2 = pair_prod((Pair){angle, angle_low}, (Pair){part, 0.0});
    const double wave = sin(angle), still = cos(angle), sine = angle_low*still + wave;
    const double cosine = still - angle_low*wave, wave2 = sin(prod.hi), still2 = cos(prod.hi);
    const double sine2 = prod.lo*still2 + wave2, cosine2 = still2 - prod.lo*wave2;
    const double wave3 = sin(prod2.hi), still3 = cos(prod2.hi), sine3 = prod2.lo*still3 + wave3;
    const double cosine3 = still3 - prod2.lo*wave3, along = cosine2*cosine3 + sine2*sine3;
    const double across = cosine3*sine2 - cosine2*sine3, before = 0.5 - part;
    const double step = expm1(0.5*motion.half), weak = 0.5*step + 0.5*step/(step + 1.0);
    const double more = 0.5*(step*step)/(step + 1.0), strong = more + 1.0;
    const double fallen = expm1(-before*motion.half), grown = fallen + 1.0;
    const double ratio = motion.half/motion.root;
    const double lost = weak*weak - along*cosine*(fallen*strong + more);
    const double turned = grown*sine*weak*(across - along*ratio);
    const double kept = across*cosine*grown*ratio*strong;
    const double total2 = -2.0*cosine*sine2*sine3 - kept + lost + turned;
    return 4.0*total2*exp(-motion.half)/gamma;
}

// m2 - m1 + m0 behind a fraction of a period
static inline double half_turned(double found, double gamma, double delta, double part) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.half < 0.25 && motion.root > 3.0 && motion.w.hi < 0.0) {
        return half_turned_swing(gamma, delta, part);
    }
    return found;
}

// kick, kick_low, n_gap, n0 and n1 of the device
static inline Device4 device_kick_kick_low_n_gap_n0_n1(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const Pair prod = wide_prod(swinging.envelope, swinging.wave), decayed = slow_fade(&motion);
        return (Device4){fast_two_sum(prod.hi, prod.lo),
            numerator_gap_swing(&motion, &swinging, gamma, delta),
            plant_n0_swing(&motion, &swinging, decayed, gamma),
            plant_n1_swing(&motion, &swinging, decayed, gamma)};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    const Pair prod2 = pair_prod(creeping.slow, creeping.far), decayed = slow_fade(&motion);
    return (Device4){fast_two_sum(prod2.hi, prod2.lo),
        numerator_gap_creep(&motion, &creeping, delta),
        plant_n0_creep(&motion, &creeping, decayed, gamma, delta),
        plant_n1_creep(&motion, &creeping, decayed)};
}

// m2 - m1 + m0, m2, an impulse's way in the rest of the period, m0, behind a fraction of it
static inline Delayed late_device(double gamma, double delta, double part) {
    const double t0 = 1.0 - part, t1 = t0*t0, t2 = gamma*t1, t3 = delta*t0;
    const Device4 device = device_kick_kick_low_n_gap_n0_n1(t2, t3);
    const double t5 = part*part, t6 = gamma*t5, t7 = delta*part;
    const Device4 device2 = device_kick_kick_low_n_gap_n0_n1(t6, t7);
    const double t9 = device2.n0*t5;
    return (Delayed){half_turned(fractional_numerator_gap(part, device.kick, device2.kick, delta*
        device.n_gap*(t0*t0*t0), delta*device2.n_gap*(part*part*part), device.n0*t1*
        (device2.kick.hi*t7 + device2.n1*t6) + device.n1*device2.n1*t2*t5 - t3*t9*decay(t3)),
        gamma, delta, part), device.n1*t1, device.kick.hi*t0, t9*exp(-t3)};
}

// 1 where the loop is stable, else 0
static inline double stable(double roots, double alpha, double beta, double gamma, double delta) {
    const double swing = sqrt(gamma);
    if (!(alpha == 0.0 && beta == 0.0 && delta == 0.0 && gamma > 0.0) &&
        !(delta < 1.1102230246251565e-15 && gamma > 1.0 && swing >= 2251799813685248.0*
        fabs(sin(swing))) && alpha > -gamma && roots == 0.0) {
        return 1.0;
    }
    return 0.0;
}

// a point that is known about three, and whether it is on the circle
static inline Point nearest_point(const Loop *loop, double y, double rest, double off) {
    const double edge = rest > y ? y : rest;
    const double inside = edge > fabs(off) && loop->beyond - off > 0.0 && loop->center +
        off > 0.0 ? 1.0 : 0.0;
    return (Point){inside > 0.0 ? loop->center + off : (rest > y ? y : 4.0 - rest), inside > 0.0 ?
        loop->beyond - off : (rest > y ? 4.0 - y : rest), inside > 0.0 ? off :
        (rest > y ? y - loop->center : loop->beyond - rest), inside > 0.0 ?
        1.7763568394002505e-15 : 2.220446049250313e-16, inside > 0.0 ? 0.0 : 8.881784197001252e-16*
        (rest > y ? loop->center : loop->beyond), fmin(rest, y) < 4.0 && rest > 0.0 && y > 0.0 ?
        1.0 : 0.0};
}

// NaN where the wall may be as strong as the device at an extremum of both, else 0
static inline double bottom_touches(const Loop *loop, double leads, double y, double rest,
    double off) {
    const Point point = nearest_point(loop, y, rest, off);
    if (point.there > 0.0) {
        const Loop loop2 = {.alpha = loop->alpha, .slope = loop->slope, .far = loop->far, .n1 =
            loop->n1, .loss = loop->loss, .together = loop->together, .apart = loop->apart,
            .apart_off = 0.0, .n1_off = 0.0, .a_off = loop->a_off};
        return touches(&loop2, leads, point.at, point.still, point.away, point.loose, point.free);
    }
    return 0.0;
}

// the turns at a crossing, if there is one
static inline double crossing_turns(const Loop *loop, double y, double rest, double off) {
    const Point point = nearest_point(loop, y, rest, off);
    if (point.there > 0.0) {
        const Loop loop2 = {.alpha = loop->alpha, .slope = loop->slope, .far = loop->far, .d =
            loop->d, .n1 = loop->n1, .loss = loop->loss, .together = loop->together, .apart =
            loop->apart, .apart_off = 0.0, .n1_off = 0.0, .a_off = loop->a_off};
        return phase_turns(&loop2, point.at, point.still, point.away, point.loose, point.free);
    }
    return 0.0;
}

// (-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite
static inline Roots quadratic_roots(double c, double b, double a, double root) {
    const double q = -0.5*b - 0.5*(b >= 0.0 ? root : -root), lead_ = a == 0.0 ? 1.0 : a;
    const double own = q == 0.0 ? 1.0 : q, one = a == 0.0 ? -1.0 : q/lead_;
    const double two = q == 0.0 ? -1.0 : c/own;
    if (b >= 0.0) { return (Roots){one, two}; }
    return (Roots){two, one};
}

// roots outside the unit circle, -1 where that is not certain
static inline double whole_roots(double alpha, double beta, double d, double n1, double n0,
    double gamma, double at_minus_one, double loss, double together, double apart) {
    if (alpha == 0.0 && beta == 0.0) { return 0.0; }
    const double strength = fabs(alpha) + fabs(beta), stiffest = fmax(gamma, fabs(alpha));
    const double e = 1.0 - loss, slope = alpha + beta, wall_far = alpha + 2.0*beta;
    const double force = beta*slope, cross = n0*n1, lost = loss*loss, square = cross*force + e;
    const double at_one = gamma*together, even = together*together, pull = apart*wall_far;
    const double near1 = (alpha*alpha)*cross - at_one*(e + 1.0) - even*force + lost;
    const double near1_size = fabs(lost) + fabs((alpha*alpha)*cross) + fabs(at_one*(e + 1.0)) +
        fabs(even*force);
    const double apart_one = (gamma - alpha)*(alpha + gamma), near0 = apart_one*even;
    const double far1 = (apart*apart)*force - at_minus_one*(e + 1.0) - cross*(wall_far*wall_far) +
        lost;
    const double far1_size = fabs(lost) + fabs((apart*apart)*force) +
        fabs(at_minus_one*(e + 1.0)) + fabs(cross*(wall_far*wall_far));
    const double far0 = (at_minus_one - pull)*(at_minus_one + pull), center = 2.0*at_one/(e + 1.0);
    const double beyond = 2.0*at_minus_one/(e + 1.0), sine = 0.25*beyond*center;
    const double tilt = 0.25*beyond - 0.25*center, real = 0.25*beyond*together - 0.25*apart*center;
    const double m0 = (n1*n1)*sine + real*real, m1 = (n1*n1)*tilt - n1*real;
    const double wave = 0.25*alpha*beyond - 0.25*center*wall_far;
    const double wall = sine*(slope*slope) + wave*wave, own0 = lost*sine - m0*wall;
    const double own1 = lost*tilt - force*m0 - m1*wall, own2 = e - force*m1;
    const double a_off = 1.5777218104420236e-30*sqrt(at_minus_one*gamma);
    const double pull2 = fabs(apart*wall_far);
    const double end_off = a_off + 1.7763568394002505e-15*at_minus_one + 1.7763568394002505e-15*
        pull2;
    const double end_apart = fabs(at_minus_one - pull2) - end_off;
    const double end_least = end_apart*(at_minus_one + pull2);
    const double room = 3.552713678800501e-15*near1_size, product = 4.0*near0*square;
    const double room2 = 2.0*a_off + 3.552713678800501e-15*far1_size, product2 = 4.0*far0*square;
    const double square2 = near1*near1, product3 = 4.0*near0*square;
    const double size = square2 + fabs(product3), square3 = own1*own1, product4 = 4.0*own0*own2;
    const double size2 = square3 + fabs(product4), square4 = far1*far1, product5 = 4.0*far0*square;
    const double size3 = square4 + fabs(product5);
    const double odd2 = fabs(((((far1 == 0.0 && square < 0.0) || far1 < 0.0) && far0 == 0.0) ||
        far0 < 0.0 ? 1.0 : 0.0) - ((((near1 == 0.0 && square < 0.0) || near1 < 0.0) &&
        near0 == 0.0) || near0 < 0.0 ? 1.0 : 0.0));
    const double disc4 = size >= size2 && size2 <= size3 ? square3 - product4 :
        (size > size3 && size2 > size3 ? square4 - product5 : square2 - product3);
    const double positive = disc4 >= 0.0 ? disc4 : 0.0, root = sqrt(positive);
    const Roots roots = quadratic_roots(near0, near1, square, root);
    const Roots roots3 = quadratic_roots(far0, far1, square, root);
    const double odd = fabs((disc4 >= 0.0 && fmin(roots.high, roots3.low) < 4.0 &&
        roots.high > 0.0 && roots3.low > 0.0 ? 1.0 : 0.0) -
        (disc4 >= 0.0 && fmin(roots3.high, roots.low) < 4.0 && roots.low > 0.0 &&
        roots3.high > 0.0 ? 1.0 : 0.0));
    if ((((stiffest > 0.0 && stiffest < 3.8725919148493183e-121) || loss +
        strength < 3.8725919148493183e-121) && strength > 0.0) ||
        (end_least <= 8.0*room2 && product2 >= 0.0 && product2 <= room2*room2 &&
        room2 >= fabs(far1)) || (fabs(near0) <= 8.0*room && product >= 0.0 && product <= room*
        room && room >= fabs(near1)) || end_apart <= 0.0 || odd != odd2) {
        return -1.0;
    }
    const double side = slope >= 0.0 ? 1.0 : -1.0;
    const double end = (wall_far > 0.0 ? side : 0.0) - d +
        (apart > 0.0 ? (n1 >= 0.0 ? 1.0 : -1.0) : 0.0) - 3.0;
    double total;
    if (disc4 >= 0.0) {
        const Roots roots2 = quadratic_roots(own0, own1, own2, root);
        const Loop loop = {.alpha = alpha, .slope = slope, .far = wall_far, .d = d, .n1 = n1,
            .loss = loss, .together = together, .apart = apart, .a_off = a_off, .center = center,
            .beyond = beyond};
        total = 2.0*crossing_turns(&loop, roots.low, roots3.high, roots2.low) - 2.0*
            crossing_turns(&loop, roots.high, roots3.low, roots2.high);
    } else {
        double bottom, bottom2;
        if (square == 0.0) {
            bottom = -1.0; bottom2 = -1.0;
        } else {
            bottom = -0.5*near1/square; bottom2 = -0.5*far1/square;
        }
        const double bottom3 = own2 == 0.0 ? -1.0 : -0.5*own1/own2;
        const Loop loop2 = {.alpha = alpha, .slope = slope, .far = wall_far, .n1 = n1, .loss =
            loss, .together = together, .apart = apart, .a_off = a_off, .center = center, .beyond =
            beyond};
        total = bottom_touches(&loop2, square, bottom, bottom2, bottom3);
    }
    const double total2 = total + ((((near1 == 0.0 && square < 0.0) || near1 < 0.0) &&
        near0 == 0.0) || near0 < 0.0 ? (alpha > 0.0 ? 0.0 : side) : 0.0);
    const double total3 = total2 - ((((far1 == 0.0 && square < 0.0) || far1 < 0.0) &&
        far0 == 0.0) || far0 < 0.0 ? end : 0.0);
    return (total3 >= 0.0 ? total3 : -1.0);
}

// the imaginary and the real part of A/(z M), M over A being the device, at z = exp(2 j psi)
static inline Response ahead_in_phase(double psi, double at_one, double at_minus_one, double loss,
    double together, double apart, double across) {
    const double t = tan(psi), square = t*t, low = fma(t, t, -(t*t));
    const Pair diff = two_diff(at_one, at_minus_one*square);
    const double missed = at_minus_one*low + fma(at_minus_one, square, -(at_minus_one*square));
    const Pair total = fast_two_sum(diff.hi, diff.lo - missed);
    const Pair diff2 = two_diff(together, apart*square);
    const double missed2 = apart*low + fma(apart, square, -(apart*square));
    const Pair total2 = fast_two_sum(diff2.hi, diff2.lo - missed2);
    const double above_j = 2.0*loss*t, below_j = across*t;
    const double rest = below_j*below_j + 2.0*total2.hi*total2.lo;
    const double size = rest + total2.hi*total2.hi, low2 = above_j*total2.lo - below_j*total.lo;
    const double found = above_j*total2.hi - below_j*total.hi, found2 = found + low2;
    const double low22 = total.hi*total2.lo + total2.hi*total.lo, rest2 = above_j*below_j + low22;
    const double found3 = rest2 + total.hi*total2.hi;
    return (Response){found2/size, found3/size};
}

// at_minus_one, kick, together and n_gap of the device
static inline Device5 device_at_minus_one_kick_together_n_gap(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return (Device5){denominator_at_minus_one_swing(&motion, &swinging),
            rounded(wide_prod(swinging.envelope, swinging.wave)),
            numerator_at_one_swing(&motion, &swinging, gamma),
            numerator_gap_swing(&motion, &swinging, gamma, delta)};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device5){denominator_at_minus_one_creep(&creeping),
        rounded(pair_prod(creeping.slow, creeping.far)),
        numerator_at_one_creep(&motion, &creeping), numerator_gap_creep(&motion, &creeping, delta)};
}

// cos((k + 1) x) and sin((k + 1) x)
static inline CosSin next_wave(double k, double x) {
    const double count = k + 1.0, before = count - 1.0, angle = count*x, missed = k - before;
    const double off = missed*x + fma(count, x, -(count*x)), sine = sin(angle), cosine = cos(angle);
    if (fabs(off) < 7.450580596923828e-09) {
        return (CosSin){cosine - off*sine, cosine*off + sine};
    }
    return (CosSin){cosine*cos(off) - sine*sin(off), cosine*sin(off) + sine*cos(off)};
}

// at_minus_one, together, n_gap, n0 and n1 of the device
static inline Device6 device_at_minus_one_together_n_gap_n0_n1(double gamma, double delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const Pair decayed = slow_fade(&motion);
        return (Device6){denominator_at_minus_one_swing(&motion, &swinging),
            numerator_at_one_swing(&motion, &swinging, gamma),
            numerator_gap_swing(&motion, &swinging, gamma, delta),
            plant_n0_swing(&motion, &swinging, decayed, gamma),
            plant_n1_swing(&motion, &swinging, decayed, gamma)};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    const Pair decayed = slow_fade(&motion);
    return (Device6){denominator_at_minus_one_creep(&creeping),
        numerator_at_one_creep(&motion, &creeping), numerator_gap_creep(&motion, &creeping, delta),
        plant_n0_creep(&motion, &creeping, decayed, gamma, delta),
        plant_n1_creep(&motion, &creeping, decayed)};
}

// has the sign of the slope of the boundary's alpha, d < 1
static inline double early_slope(double theta, double k4, double k3, double k2, double k1,
    double k0) {
    const double sine = sin(0.5*theta), cosine = cos(0.5*theta), up = sine*sine;
    const double along = cosine*cosine, found = along*k3 + k4*up, power2 = along*along;
    const double found2 = found*up + k2*power2, power3 = along*power2;
    const double found3 = found2*up + k1*power3, power4 = along*power3;
    return found3*up + k0*power4;
}

// has the sign of the slope of the boundary's alpha next to pi
static inline double end_slope(double at_minus_one, double loss, double together, double apart,
    double last) {
    const Pair diff = two_diff(together, 4.0*last), squared = pair_square(diff);
    const Pair prod = two_prod(apart, together);
    const Pair prod5 = wide_prod(loss, wide_prod(apart, pair_diff(prod, squared)));
    const Pair prod6 = pair_prod(pair_square((Pair){apart, 0.0}),
        pair_diff((Pair){2.0*apart, 0.0}, diff));
    return rounded(pair_diff(pair_diff((Pair){4.0*prod6.hi, 4.0*prod6.lo},
        wide_prod(at_minus_one, pair_sum(pair_prod(diff,
        pair_diff(squared, (Pair){2.0*prod.hi, 2.0*prod.lo})), wide_prod(apart, prod)))),
        (Pair){2.0*prod5.hi, 2.0*prod5.lo}));
}

// the next point of a search between a and b, where f is fa and fb, after c
static inline double next_guess(double b, double fb, double a, double fa, double c, double fc,
    double close) {
    const double span = c - b, rise = fc - fb, whole = span == 0.0 ? 1.0 : span;
    const double place = (a - b)/whole, whole2 = rise == 0.0 ? 1.0 : rise;
    const double height = (fa - fb)/whole2;
    const double safe = place > height*height && place < 1.0 - ((1.0 - height)*(1.0 - height)) ?
        1.0 : 0.0;
    const double width = b - a, whole3 = width == 0.0 ? 1.0 : width;
    const double edge = close*fabs(fabs(fa) < fabs(fb) ? a : b)/fabs(whole3);
    const double edge2 = fmin(0.5, edge);
    double guess = 0.5;
    if (safe > 0.0) {
        const double one = fb - fa, two = fb - fc, three = fa - fc, here = fa/one, there = fc/two;
        const double other = fa/three, last = fb/two;
        guess = here*there + last*other*(c - a)/whole3;
    }
    const double share = fmin(guess, 1.0 - edge2), share2 = fmax(edge2, share);
    return a + share2*width;
}

// the angle of the largest stiffness for delays below a period
static inline double early_angle(double at_one, double at_minus_one, double loss, double together,
    double apart, double last) {
    const double t = apart*apart*apart, t2 = together*together*together, t3 = together*together;
    const double t4 = apart*t3, t5 = apart*apart, t6 = 2.0*loss, t7 = at_minus_one + t6;
    const double t8 = 4.0*together, t9 = 16.0*apart, t10 = at_one + t6, t11 = 2.0*at_one;
    const double t12 = 5.0*at_minus_one, t13 = -at_one, t14 = 4.0*loss, t15 = apart*together;
    const double t16 = 16.0*together, t17 = at_one*last, t18 = apart*t11, t19 = at_one*t5;
    const double k = end_slope(at_minus_one, loss, together, apart, last);
    const double k2 = last*(32.0*at_minus_one*t3 + last*
        (64.0*apart*loss + 128.0*at_minus_one*last - 96.0*at_minus_one*together) - 96.0*t5 - t7*t9*
        together) - 4.0*at_minus_one*t2 + 16.0*t + 8.0*t4*(at_minus_one + loss) - t5*t7*t8;
    const double k3 = last*(last*(last*(-192.0*at_minus_one - 256.0*at_one - 512.0*loss) + t16*
        (9.0*at_one + 16.0*loss + t12) + t9*(8.0*at_minus_one + 8.0*at_one + 18.0*loss)) - 32.0*
        t15 - 4.0*t3*(at_minus_one + 7.0*at_one + 14.0*loss) - 112.0*t5) + 8.0*t + 2.0*t2*
        (t10 - 2.0*at_minus_one) + 2.0*t4*(t12 + t13 + t14) - 2.0*t5*together*(t7 - t11);
    const double k4 = last*(32.0*t17*together - 8.0*together*(t18 + 12.0*together)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const double k5 = last*(t16*t17 + t8*(t10*together - t18)) + together*
        (t19 - 2.0*t15*(at_one + loss) + t3*(at_minus_one + t11 + t14));
    double count = 1.0, found = 0.0;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if (count > 24.0 || found > 0.0) { break; }
        const double rises = early_slope(0.041666666666666664*3.141592653589793*count, k, k2, k3,
            k4, k5);
        const double next_count = rises > 0.0 ? count + 1.0 : count;
        found = rises > 0.0 ? 0.0 : 1.0; count = next_count;
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
            if ((fa >= 0.0 && fb >= 0.0) || (fa <= 0.0 && fb <= 0.0) ||
                fabs(a - b) <= 4.440892098500626e-16*fabs(fabs(fa) < fabs(fb) ? a : b)) { break; }
            const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
            const double value = early_slope(new_, k, k2, k3, k4, k5);
            const double same = (fa > 0.0 && value > 0.0) || (fa < 0.0 && value < 0.0) ? 1.0 : 0.0;
            const double next_b = same > 0.0 ? b : a, next_fb = same > 0.0 ? fb : fa;
            const double next_c = same > 0.0 ? a : b;
            fc = same > 0.0 ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
        }
        return (fabs(fa) < fabs(fb) ? a : b);
    }
    return 3.141592653589793;
}

// has the sign of the slope of the boundary's alpha
static inline double boundary_slope(double theta, double l, double at_one, double at_minus_one,
    double loss, double together, double apart, double across) {
    const double t = 2.0*l + 2.0, t2 = 0.5*theta, t3 = next_wave(t, t2).sine, t4 = tan(t2);
    const double t5 = t4*t4, t6 = 4.0*t5, t7 = apart*t5, t8 = together - t7, t9 = at_minus_one*t5;
    const double t10 = at_one - t9, t11 = across*loss*t6 + t10*t8, t12 = next_wave(t, t2).cosine;
    const double t13 = 2.0*loss*t4*t8 - 2.0*across*t10*t4, t14 = across*across;
    const double t15 = t14*t6 + t8*t8, t16 = loss*loss, t17 = t10*t10 + t16*t6, t18 = t15*t17;
    const double t19 = t5 + 1.0;
    return (t11*t3 + t12*t13)*(t18*(l + 1.5) + t19*
        (loss*t15*(at_one + t9) - across*t17*(t7 + together))) - t4*
        (0.5*t18 + t19*(t15*(2.0*t16 - at_minus_one*t10) - t17*(2.0*t14 - apart*t8)))*
        (t11*t12 - t13*t3);
}

// the angle of the largest stiffness for a period and more
static inline double later_angle(double d, double l, double at_one, double at_minus_one,
    double loss, double together, double apart, double across) {
    const double turn_ = 3.141592653589793/(d + 1.0);
    double count = 1.0, found = 0.0;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if (count > 24.0 || found > 0.0) { break; }
        const double rises = boundary_slope(0.041666666666666664*count*turn_, l, at_one,
            at_minus_one, loss, together, apart, across);
        const double next_count = rises > 0.0 ? count + 1.0 : count;
        found = rises > 0.0 ? 0.0 : 1.0; count = next_count;
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
            if ((fa >= 0.0 && fb >= 0.0) || (fa <= 0.0 && fb <= 0.0) ||
                fabs(a - b) <= 4.440892098500626e-16*fabs(fabs(fa) < fabs(fb) ? a : b)) { break; }
            const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
            const double value = boundary_slope(new_, l, at_one, at_minus_one, loss, together,
                apart, across);
            const double same = (fa > 0.0 && value > 0.0) || (fa < 0.0 && value < 0.0) ? 1.0 : 0.0;
            const double next_b = same > 0.0 ? b : a, next_fb = same > 0.0 ? fb : fa;
            const double next_c = same > 0.0 ? a : b;
            fc = same > 0.0 ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
        }
        return (fabs(fa) < fabs(fb) ? a : b);
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static inline double undelayed_angle(double at_one, double at_minus_one, double loss,
    double together, double apart) {
    const double k = end_slope(at_minus_one, loss, together, apart, 0.0), t = 2.0*apart;
    const double t2 = -together, t3 = 2.0*together, t4 = together*together;
    const double k2 = t3*((apart*apart)*at_one + together*(at_minus_one*(t + t2) + loss*t));
    const double k3 = together*(at_minus_one*t4 + at_one*(t4 + (-apart - t2)*(-apart - t2)) + loss*
        t3*(2.0*together - apart));
    double above, below;
    if (k2 > 0.0) {
        const double discriminant = k2*k2 - 4.0*k*k3, root = sqrt(fmax(0.0, discriminant));
        above = k2 + root; below = fmax(0.0, -2.0*k);
    } else {
        const double discriminant = k2*k2 - 4.0*k*k3;
        if (discriminant < 0.0) {
            above = 2.0*k3; below = 0.0;
        } else {
            const double root = sqrt(fmax(0.0, discriminant));
            above = 2.0*k3; below = root - k2;
        }
    }
    return 2.0*atan2(sqrt(above), sqrt(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static inline double max_stiffness_angle(double gamma, double delta, double d, double l,
    double part, double first, double last, double at_one, double at_minus_one, double loss,
    double together, double apart) {
    if ((d <= 1.0 || sqrt(gamma)*(d + 1.0) <= 3.141592653589793) && gamma <= 9.8) {
        const double across = part == 0.0 ? first : first - last;
        const double theta = d == 0.0 ? undelayed_angle(at_one, at_minus_one, loss, together,
            apart) : (d < 1.0 ? early_angle(at_one, at_minus_one, loss, together, apart, last) :
            later_angle(d, l, at_one, at_minus_one, loss, together, apart, across));
        const double t = next_wave(l, theta).sine, t2 = 0.5*theta, t3 = sin(t2), t4 = cos(t2);
        const double t5 = t4*t4, t6 = t3*t3, t7 = 4.0*t5*t6, t8 = t5*together - apart*t6;
        const double t9 = 1.0/((across*across)*t7 + t8*t8), t10 = at_one*t5 - at_minus_one*t6;
        const double t11 = 2.0*loss*t8 - 2.0*across*t10, t12 = across*loss*t7 + t10*t8;
        const double t13 = t9*next_wave(l, theta).cosine, t14 = -t*t12*t9/sin(theta) - 0.5*t11*t13;
        const double stiffness = t*t11*t3*t4*t9 - t12*t13 - 2.0*t14*t6;
        double good;
        if (delta > 0.0 && gamma > -stiffness && sqrt(gamma)*(d + 1.0) <= 3.141592653589793) {
            good = 1.0;
        } else {
            const double inside = 0.9999999953433871*stiffness - 4.6566128730773926e-09*gamma;
            const double outside = part == 0.0 ?
                whole_roots(inside, t14, l, first, last, gamma, at_minus_one, loss, together,
                apart) : fractional_roots(inside, t14, l, first, last, gamma, at_minus_one, loss,
                together, apart, first - last);
            if (outside < 0.0) {
                const double inside2 = 0.99609375*stiffness - 0.00390625*gamma;
                const double outside2 = part == 0.0 ?
                    whole_roots(inside2, t14, l, first, last, gamma, at_minus_one, loss, together,
                    apart) : fractional_roots(inside2, t14, l, first, last, gamma, at_minus_one,
                    loss, together, apart, first - last);
                good = stable(outside2, inside2, t14, gamma, delta);
            } else {
                good = stable(outside, inside, t14, gamma, delta);
            }
        }
        if (good > 0.0) { return theta; }
    }
    return NAN;
}

// the damping that the wall needs at the angle theta, at a fraction of a period
static inline double required_at(double alpha, double beta, double l, double epsilon,
    double theta) {
    const CosSin cossin = next_wave(l, theta);
    const double lift = fabs(alpha) + fabs(beta) < 3.8725919148493183e-121 ?
        6.668014432879854e+240 : 1.0;
    const double stiffness = alpha*lift, damping = beta*lift, half = 0.5*theta, up = sin(half);
    const double along = cos(half), twice = 2.0*epsilon;
    const Pair diff3 = pair_diff(wide_prod(0.5*stiffness,
        pair_diff(pair_sum(pair_quot(two_prod(cossin.sine, along), (Pair){up, 0.0}),
        two_prod(twice, cossin.cosine)), (Pair){cossin.cosine, 0.0})),
        wide_prod(damping, pair_diff((Pair){cossin.cosine, 0.0},
        wide_prod(twice, wide_prod(up, pair_sum(two_prod(cossin.sine, along),
        two_prod(cossin.cosine, up)))))));
    const double n = diff3.hi + diff3.lo;
    const double size = (along*along)*(stiffness*stiffness) + (up*up)*
        ((2.0*damping + stiffness)*(2.0*damping + stiffness));
    const double extra = epsilon*size*(1.0 - epsilon), root = sqrt(extra + n*n);
    const double whole = root + fabs(n) == 0.0 ? 1.0 : root + fabs(n), more = 0.5*extra/whole;
    const double rest = diff3.lo + more, whole_need = diff3.hi + rest;
    return (n < 0.0 ? more : whole_need)/lift;
}

// what straight motions need at an angle behind k whole periods
static inline double straight_at(double stiffness, double damping, double k, double angle) {
    const double half = 0.5*angle;
    return rounded(pair_diff(wide_prod(stiffness,
        pair_quot((Pair){next_wave(2.0*k, half).sine, 0.0}, (Pair){2.0*sin(half), 0.0})),
        two_prod(damping, next_wave(k, angle).cosine)));
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
    if (fabs(x) < 1.0) { return 1.0 - (x*x)*gap(x); }
    return sin(x)/x;
}

// the damping that the wall needs at the angle 2 psi
static inline double damping_at(double alpha, double beta, double l, double epsilon, double psi) {
    const double early = 0.5*alpha*(2.0*l + 1.0)*sinc(psi*(2.0*l + 1.0))/sinc(psi) - beta*
        next_wave(l, 2.0*psi).cosine;
    if (epsilon == 0.0) { return early; }
    const double n = early + epsilon*(0.5*alpha*(2.0*l + 3.0)*sinc(psi*(2.0*l + 3.0))/sinc(psi) -
        beta*next_wave(l + 1.0, 2.0*psi).cosine - early);
    const double root = sqrt(epsilon*(1.0 - epsilon)*
        ((alpha*alpha)*(cos(psi)*cos(psi)) + ((alpha + 2.0*beta)*(alpha + 2.0*beta))*
        (sin(psi)*sin(psi))) + n*n);
    return 0.5*n + 0.5*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static inline double chord(double k, double x) {
    const double turn_ = x*(k + 1.0), order = 2.0*k + 2.0, along = next_wave(k, x).cosine;
    if (turn_ < 1.5) {
        const double wave = sinc(0.5*turn_), inner = 0.5*(wave*wave) - gap(turn_);
        return order*(along*gap(x) + 0.25*inner*(order*order));
    }
    return (2.0*next_wave(k, x).sine - along*order*sin(x))/(x*x*x);
}

// has the sign of the slope of DampingAt, at a fraction
static inline double rising(double alpha, double beta, double l, double epsilon, double psi) {
    const double t = 2.0*psi, t2 = 2.0*alpha/(sinc(psi)*sinc(psi)), t3 = 0.5*alpha + beta;
    const double t4 = 2.0*l, t5 = t4 + 2.0, t6 = t4 + 4.0;
    const double early = t3*(t5*t5)*sinc(psi*t5) - t2*chord(l, t);
    const double steep = early + epsilon*(-early - t2*chord(l + 1.0, t) + t3*(t6*t6)*sinc(psi*t6));
    return 2.0*beta*epsilon*(1.0 - epsilon)*(alpha + beta)*sinc(2.0*psi) + steep*
        damping_at(alpha, beta, l, epsilon, psi);
}

// has the sign of the slope of DampingAt, up to the angle in phase
static inline double steepness(double alpha, double beta, double l, double epsilon, double psi) {
    if (epsilon == 0.0) {
        const double t = 2.0*l + 2.0;
        return (t*t)*(0.5*alpha + beta)*sinc(psi*t) - 2.0*alpha*chord(l, 2.0*psi)/
            (sinc(psi)*sinc(psi));
    }
    const double rising_ = rising(alpha, beta, l, epsilon, psi);
    const double phase = psi*(2.0*l + 2.0) + atan2(alpha*cos(psi), (alpha + 2.0*beta)*sin(psi)) +
        atan2(epsilon*sin(2.0*psi), epsilon*cos(2.0*psi) - epsilon + 1.0) - 3.141592653589793;
    return (phase > 0.0 ? -fabs(rising_) : rising_);
}

// half of the angle at which the wall needs most damping
static inline double worst_angle(double alpha, double beta, double l, double epsilon) {
    const double size = fabs(alpha) + fabs(beta), whole = size == 0.0 ? 1.0 : size;
    const double stiffness = alpha/whole, damping = beta/whole, low = 0.0;
    const double above = steepness(stiffness, damping, l, epsilon, low);
    if (above <= 0.0) { return low; }
    const double high = 3.141592653589793/(2.0*l + 2.0);
    const double below = steepness(stiffness, damping, l, epsilon, high);
    if (below >= 0.0) { return high; }
    double b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if ((fa >= 0.0 && fb >= 0.0) || (fa <= 0.0 && fb <= 0.0) ||
            fabs(a - b) <= 4.656612873077393e-10*fabs(fabs(fa) < fabs(fb) ? a : b)) { break; }
        const double new_ = next_guess(b, fb, a, fa, c, fc, 4.656612873077393e-10);
        const double value = steepness(stiffness, damping, l, epsilon, new_);
        const double same = (fa > 0.0 && value > 0.0) || (fa < 0.0 && value < 0.0) ? 1.0 : 0.0;
        const double next_b = same > 0.0 ? b : a, next_fb = same > 0.0 ? fb : fa;
        const double next_c = same > 0.0 ? a : b;
        fc = same > 0.0 ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (fabs(fa) < fabs(fb) ? a : b);
}

// the damping that the wall needs at its worst angle
static inline double largest_required_damping(double alpha, double beta, double d) {
    if (alpha < 0.0) { return INFINITY; }
    const double whole = floor(d), part = d - whole;
    const double lift = fabs(alpha) + fabs(beta) < 3.8725919148493183e-121 ?
        6.668014432879854e+240 : 1.0;
    const double stiffness = alpha*lift, damping = beta*lift;
    return damping_at(stiffness, damping, whole, part,
        worst_angle(stiffness, damping, whole, part))/lift;
}

// early + share (late - early)
static inline double between(double share, double early, double late) {
    const double more = late - early;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static inline double lead(double theta, double l, double epsilon) {
    if (theta*(l + 1.0) < 4.0) {
        const double early = next_wave(l, theta).sine, late = next_wave(l + 1.0, theta).sine;
        return early + epsilon*(late - early);
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
    return (order*sin(x) - 2.0*next_wave(k, x).cosine*next_wave(k, x).sine)/(x*x*x);
}

// what straight motions need at a whole delay of k periods
static inline double straight(double stiffness, double damping, double k, double angle) {
    const double order = 2.0*k + 1.0;
    return rounded(pair_diff(wide_prod(stiffness,
        pair_quot(two_prod(order, sinc(angle*order)), (Pair){2.0*sinc(angle), 0.0})),
        two_prod(damping, next_wave(k, 2.0*angle).cosine)));
}

// has the sign of minus the slope of what the wall phi needs
static inline double turning(double phi, double l, double epsilon, double wave, double wave2,
    double wave3, double wave4, double wave5, double wave6, double wave7, double wave8,
    double wave9, double wave10, double wave11, double wave12) {
    const double t = sin(phi), t2 = l + 1.0, t3 = cos(phi), t4 = t3/t2, t5 = 0.5*t4, t6 = t - t5;
    const double t7 = epsilon*(1.0 - epsilon), t8 = 2.0*l, t9 = 2.0*t4/(wave7*wave7);
    const double t10 = t*wave10*((t8 + 2.0)*(t8 + 2.0)) - t9*wave3, t11 = t6*wave5, t12 = 1.0/wave7;
    const double t13 = wave9*(t8 + 1.0), t14 = t12*t5, t15 = t13*t14;
    const double t16 = epsilon*(t11 + t14*wave11*(t8 + 3.0) - t15 - t6*wave6);
    return -2.0*t6*t7*wave8*(t + t5) - (epsilon*
        (t*wave12*((t8 + 4.0)*(t8 + 4.0)) - t10 - t9*wave4) + t10)*
        (0.25*t12*t13*t4 - 0.5*t11 + 0.5*t16 + 0.5*
        sqrt(t7*(4.0*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2)) + (t15 - t11 + t16)*
        (t15 - t11 + t16)));
}

// the wall whose worst angle is 2 psi, as an angle
static inline double turn(double psi, double l, double epsilon) {
    const double wave = sin(psi), wave2 = cos(psi), wave3 = chord(l, 2.0*psi);
    const double wave4 = chord(l + 1.0, 2.0*psi), wave5 = next_wave(l, 2.0*psi).cosine;
    const double wave6 = next_wave(l + 1.0, 2.0*psi).cosine, wave7 = sinc(psi);
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
        if ((fa >= 0.0 && fb >= 0.0) || (fa <= 0.0 && fb <= 0.0) ||
            fabs(a - b) <= 4.440892098500626e-16*fabs(fabs(fa) < fabs(fb) ? a : b)) { break; }
        const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
        const double value = turning(new_, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6,
            wave7, wave8, wave9, wave10, wave11, wave12);
        const double same = (fa > 0.0 && value > 0.0) || (fa < 0.0 && value < 0.0) ? 1.0 : 0.0;
        const double next_b = same > 0.0 ? b : a, next_fb = same > 0.0 ? fb : fa;
        const double next_c = same > 0.0 ? a : b;
        fc = same > 0.0 ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (fabs(fa) < fabs(fb) ? a : b);
}

// the wall whose worst angle is theta, as an angle, or NaN
static inline double touching(double theta, double l, double epsilon) {
    const double found = turn(0.5*theta, l, epsilon);
    if (found < 0.5*3.141592653589793) { return found; }
    return NAN;
}

// whether a larger angle allows less stiffness, at a fraction
static inline double passive_slope(double theta, double l, double epsilon) {
    const CosSin cossin = next_wave(l, theta), cossin2 = next_wave(l + 1.0, theta);
    const double up = epsilon*(cossin2.sine - cossin.sine) + cossin.sine;
    const double along = cossin.cosine + epsilon*(cossin2.cosine - cossin.cosine);
    return (1.0 - up)*cos(theta) + (along*(epsilon + l + 1.0) - epsilon*(1.0 - epsilon)*
        (cossin.cosine - cossin2.cosine))*sin(theta);
}

// the worst angle of the stiffest passive wall, at a fraction
static inline double passive_angle(double l, double epsilon) {
    const double low = 0.0, above = passive_slope(low, l, epsilon);
    if (above <= 0.0) { return low; }
    const double high = 3.141592653589793/(epsilon + l + 1.0);
    const double below = passive_slope(high, l, epsilon);
    if (below >= 0.0) { return high; }
    double b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if ((fa >= 0.0 && fb >= 0.0) || (fa <= 0.0 && fb <= 0.0) ||
            fabs(a - b) <= 4.440892098500626e-16*fabs(fabs(fa) < fabs(fb) ? a : b)) { break; }
        const double new_ = next_guess(b, fb, a, fa, c, fc, 4.440892098500626e-16);
        const double value = passive_slope(new_, l, epsilon);
        const double same = (fa > 0.0 && value > 0.0) || (fa < 0.0 && value < 0.0) ? 1.0 : 0.0;
        const double next_b = same > 0.0 ? b : a, next_fb = same > 0.0 ? fb : fa;
        const double next_c = same > 0.0 ? a : b;
        fc = same > 0.0 ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (fabs(fa) < fabs(fb) ? a : b);
}

void haptic_discretize(double gamma, double delta, double *n1_out, double *n0_out, double *a_out,
    double *e_out) {
    if (!(delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) {
        *n1_out = NAN; *n0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    const Device device = device_n0_n1_trace(gamma, delta);
    *n1_out = device.n1; *n0_out = device.n0; *a_out = device.trace; *e_out = exp(-delta);
}

void haptic_discretize_fractional(double gamma, double delta, double epsilon, double *m2_out,
    double *m1_out, double *m0_out, double *a_out, double *e_out) {
    if (!(delta >= 0.0 && delta <= 1e+70 && epsilon >= 0.0 && epsilon < 1.0 && gamma >= 0.0 &&
        gamma <= 1e+15)) {
        *m2_out = NAN; *m1_out = NAN; *m0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    const Device2 device = device_together_trace(gamma, delta);
    const double t0 = 1.0 - epsilon, t1 = t0*t0, t2 = delta*t0, n1 = plant_n1(gamma*t1, t2);
    const double t3 = n1*t1, t4 = epsilon*epsilon, n0 = plant_n0(gamma*t4, delta*epsilon);
    const double t5 = n0*t4*exp(-t2);
    *m2_out = t3; *m1_out = device.together - t3 - t5; *m0_out = t5; *a_out = device.trace;
    *e_out = exp(-delta);
}

bool haptic_is_stable(double alpha, double beta, double gamma, double delta, double d) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) {
        return false;
    }
    const Device3 device = device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta);
    const double whole = floor(d), part = d - whole, t1 = delta*decay(delta);
    const double t3 = delta*device.n_gap;
    if (part == 0.0) {
        return stable(whole_roots(alpha, beta, d, device.n1, device.n0, gamma, device.at_minus_one,
            t1, device.together, t3), alpha, beta, gamma, delta) != 0.0;
    }
    const Delayed delayed = late_device(gamma, delta, part);
    return stable(fractional_roots(alpha, beta, whole, delayed.m2, delayed.m0, gamma,
        device.at_minus_one, t1, device.together, delayed.apart, 0.5*device.kick*
        (delta*delayed.m2 + 2.0*delayed.kicked) + 0.5*delayed.m2*(gamma*device.together + t1) - 0.5*
        device.together + 0.5*t3), alpha, beta, gamma, delta) != 0.0;
}

double haptic_unstable_roots(double alpha, double beta, double gamma, double delta, double d) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70 && gamma >= 0.0 && gamma <= 1e+15)) {
        return -1.0;
    }
    const Device3 device = device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta);
    const double whole = floor(d), part = d - whole, t1 = delta*decay(delta);
    const double t3 = delta*device.n_gap;
    if (part == 0.0) {
        return whole_roots(alpha, beta, d, device.n1, device.n0, gamma, device.at_minus_one, t1,
            device.together, t3);
    }
    const Delayed delayed = late_device(gamma, delta, part);
    return fractional_roots(alpha, beta, whole, delayed.m2, delayed.m0, gamma, device.at_minus_one,
        t1, device.together, delayed.apart, 0.5*device.kick*
        (delta*delayed.m2 + 2.0*delayed.kicked) + 0.5*delayed.m2*(gamma*device.together + t1) - 0.5*
        device.together + 0.5*t3);
}

void haptic_stability_boundary(double theta, double gamma, double delta, double d,
    double *alpha_out, double *beta_out) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 &&
        gamma <= 1e+15 && theta > 0.0 && theta <= 3.141592653589793)) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const Device5 device = device_at_minus_one_kick_together_n_gap(gamma, delta);
    const double whole = floor(d);
    const CosSin cossin = next_wave(whole, theta);
    const double part = d - whole, t2 = 0.5*theta, t4 = gamma*device.together;
    const double t6 = delta*decay(delta), t7 = delta*device.n_gap;
    double t10, t12;
    if (part == 0.0) {
        t10 = t7; t12 = device.together + t7;
    } else {
        const Delayed delayed = late_device(gamma, delta, part);
        t10 = delayed.apart;
        t12 = device.kick*(delta*delayed.m2 + 2.0*delayed.kicked) + delayed.m2*(t4 + t6) -
            device.together + t7;
    }
    const Response response = ahead_in_phase(t2, t4, device.at_minus_one, t6, device.together, t10,
        t12);
    const double t16 = response.ahead*cossin.cosine + response.in_phase*cossin.sine;
    *alpha_out = response.ahead*cossin.sine - cossin.cosine*response.in_phase + t16*tan(t2);
    *beta_out = -t16/sin(theta);
}

void haptic_max_stable_stiffness(double gamma, double delta, double d, double *alpha_out,
    double *beta_out, double *theta_out) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && gamma >= 0.0 &&
        gamma <= 1e+15)) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const Device6 device = device_at_minus_one_together_n_gap_n0_n1(gamma, delta);
    const double whole = floor(d), part = d - whole, t1 = gamma*device.together;
    const double t3 = delta*decay(delta), t16 = 2.0*t3;
    if (part == 0.0) {
        const double t4 = delta*device.n_gap;
        const double t5 = max_stiffness_angle(gamma, delta, d, d, 0.0, device.n1, device.n0, t1,
            device.at_minus_one, t3, device.together, t4);
        const CosSin cossin = next_wave(d, t5);
        const double t7 = 0.5*t5, t8 = sin(t7), t9 = cos(t7), t10 = device.together + t4;
        const double t11 = t9*t9, t12 = t8*t8, t13 = t11*t12, t14 = device.together*t11 - t12*t4;
        const double t15 = 1.0/((t10*t10)*t13 + t14*t14), t17 = t1*t11 - device.at_minus_one*t12;
        const double t18 = t14*t16 - t10*t17, t19 = t10*t13*t16 + t14*t17, t20 = cossin.cosine*t15;
        const double t21 = -cossin.sine*t15*t19/sin(t5) - 0.5*t18*t20;
        *alpha_out = cossin.sine*t15*t18*t8*t9 - 2.0*t12*t21 - t19*t20; *beta_out = t21;
        *theta_out = t5; return;
    }
    const Delayed delayed = late_device(gamma, delta, part);
    const double t27 = max_stiffness_angle(gamma, delta, d, whole, part, delayed.m2, delayed.m0,
        t1, device.at_minus_one, t3, device.together, delayed.apart);
    const CosSin cossin2 = next_wave(whole, t27);
    const double t28 = 0.5*t27, t29 = sin(t28), t30 = cos(t28), t32 = t30*t30, t33 = t29*t29;
    const double t34 = device.together*t32 - delayed.apart*t33;
    const double t35 = 2.0*delayed.m2 - 2.0*delayed.m0, t36 = t32*t33;
    const double t37 = 1.0/(t34*t34 + (t35*t35)*t36), t38 = t1*t32 - device.at_minus_one*t33;
    const double t39 = t16*t34 - t35*t38, t40 = t16*t35*t36 + t34*t38, t41 = cossin2.cosine*t37;
    const double t42 = -cossin2.sine*t37*t40/sin(t27) - 0.5*t39*t41;
    *alpha_out = cossin2.sine*t29*t30*t37*t39 - 2.0*t33*t42 - t40*t41; *beta_out = t42;
    *theta_out = t27;
}

double haptic_passivity_margin_at(double theta, double alpha, double beta, double delta, double d) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70 && theta > 0.0 && theta <= 3.141592653589793)) {
        return NAN;
    }
    const double whole = floor(d), part = d - whole;
    if (part == 0.0) { return delta - straight_at(alpha, beta, d, theta); }
    return delta - required_at(alpha, beta, whole, part, theta);
}

double haptic_passivity_margin(double alpha, double beta, double delta, double d) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(alpha) <= 1e+70 &&
        fabs(beta) <= 1e+70)) {
        return NAN;
    }
    return delta - largest_required_damping(alpha, beta, d);
}

void haptic_passivity_boundary(double theta, double delta, double d, double *alpha_out,
    double *beta_out) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && theta > 0.0 &&
        theta <= 3.141592653589793)) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const double whole = floor(d), part = d - whole, t2 = 0.5*theta;
    if (part == 0.0) {
        const double t0 = lead(theta, d, 0.0), t1 = delta/spread(d, theta), t15 = sinc(t2);
        const double sine = next_wave(d, theta).sine, t3 = sine*(t15*t15)*(d + 1.0)/theta;
        *alpha_out = rated(t0, 2.0*t1*t3); *beta_out = rated(t0, t1*(chord(d, theta) - t3)); return;
    }
    const double t6 = lead(theta, whole, part), t7 = whole + 1.0, t8 = touching(theta, whole, part);
    const double t9 = cos(t8), t10 = t9/t7, t11 = sin(t8), t12 = t11 - 0.5*t10;
    const double t13 = between(part, straight(t10, t12, whole, t2), straight(t10, t12, t7, t2));
    const double t16 = sin(t2), t17 = cos(t2);
    const double t14 = delta/(0.5*t13 + 0.5*
        sqrt(part*(1.0 - part)*(4.0*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7)) + t13*t13));
    *alpha_out = rated(t6, t10*t14); *beta_out = rated(t6, t12*t14);
}

void haptic_max_passive_stiffness(double delta, double d, double *alpha_out, double *beta_out,
    double *theta_out) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70)) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const double whole = floor(d), part = d - whole, t3 = 2.0*delta;
    if (part == 0.0) {
        const double t0 = d + 1.0, t1 = 3.141592653589793/t0, t2 = tan(0.25*t1), t4 = 0.5*t1;
        *alpha_out = t2*t3; *beta_out = delta*(1.0/(t0*sin(t4)) - t2); *theta_out = t4; return;
    }
    const double t7 = passive_angle(whole, part);
    const CosSin cossin = next_wave(whole, t7);
    const double t9 = whole + 1.0;
    const CosSin cossin2 = next_wave(t9, t7);
    const double t10 = cossin.cosine + part*(cossin2.cosine - cossin.cosine), t12 = 0.5*t7;
    const double t13 = sin(t12), t14 = t13*t13, t15 = 2.0*whole, t16 = t15 + 2.0;
    const double sine_2 = next_wave(t16, t12).sine, t17 = 2.0*sine_2*t13;
    const double t18 = (t10*t17 + t14*(4.0*part + 4.0*whole + 4.0))/
        (t10*cos(t7) + (part + t9)*(part*(cossin2.sine - cossin.sine) + cossin.sine + 1.0)*sin(t7));
    const double t19 = 2.0*part;
    *alpha_out = t18*t3; *beta_out = delta*(t17 - t18*(t14*(t15 + t19) + 1.0))/(t14*(t16 + t19));
    *theta_out = t7;
}

double haptic_linear_limit(double beta, double delta, double d) {
    if (!(d >= 0.0 && d <= 1e+15 && delta >= 0.0 && delta <= 1e+70 && fabs(beta) <= 1e+70)) {
        return NAN;
    }
    return (beta + delta)/(d + 0.5);
}

void haptic_late_device(double gamma, double delta, double part, double *apart_out, double *m2_out,
    double *kicked_out, double *m0_out) {
    const Delayed found = late_device(gamma, delta, part);
    *apart_out = found.apart;
    *m2_out = found.m2;
    *kicked_out = found.kicked;
    *m0_out = found.m0;
}
