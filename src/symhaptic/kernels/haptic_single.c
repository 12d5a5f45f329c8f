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

typedef struct { float hi, lo; } Pair; // and what its float misses
typedef struct { Pair fall, mean; } Fading;
typedef struct { Pair p, q; } Poles;
typedef struct { Pair p, slow, mean, ratio, far; } Creeping;
typedef struct { float half; Pair w; float root, reach; } Motion;
typedef struct { Pair even, odd; } Wave;
typedef struct { float near, risen, sunk, moved; } Turns;
typedef struct { float envelope; Pair even, wave; float near, risen, sunk, moved; } Swinging;
typedef struct { float n0, n1, trace; } Device;
typedef struct { float together, trace; } Device2;
typedef struct { float at_minus_one, kick, together, n_gap, n0, n1; } Device3;
typedef struct { float halves, rest, size, per, off, blur, slope, fast, bend, turn, spread; } Part;
typedef struct { Pair kick; float n_gap, n0, n1; } Device4;
typedef struct { float apart, m2, kicked, m0; } Delayed;
typedef struct { float at, still, away, loose, free, there; } Point;
typedef struct { float low, high; } Roots;
typedef struct { float ahead, in_phase; } Response;
typedef struct { float at_minus_one, kick, together, n_gap; } Device5;
typedef struct { float cosine, sine; } CosSin;
typedef struct { float at_minus_one, together, n_gap, n0, n1; } Device6;
typedef struct { float alpha, slope, far, d, n1, loss, together, apart, apart_off, n1_off, a_off,
    center, beyond; } Loop;

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static inline float decay_series(float x) {
    const float square = x*x;
    float one = 0.0f, two = 0.0f;
    for (int n = 12; n >= 4; n -= 1) {
        const float number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return square*two - one*x + 0.16666667f;
}

// x + y and what it misses, for |x| >= |y|
static inline Pair fast_two_sum(float x, float y) {
    const float total = x + y, back = total - x;
    return (Pair){total, y - back};
}

// 1 - x of a pair, for |x| <= 1
static inline Pair one_minus(Pair x) {
    const Pair total = fast_two_sum(1.0f, -x.hi);
    return (Pair){total.hi, total.lo - x.lo};
}

// x y of a float and a pair
static inline Pair wide_prod(float x, Pair y) {
    return (Pair){x*y.hi, x*y.lo + fmaf(x, y.hi, -(x*y.hi))};
}

// x y of pairs
static inline Pair pair_prod(Pair x, Pair y) {
    const Pair prod = wide_prod(x.hi, y);
    return (Pair){prod.hi, prod.lo + x.lo*y.hi};
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4
static inline Fading brief_fading(Pair rate) {
    const Pair total = fast_two_sum(1.0f, -0.5f*rate.hi);
    const Pair total2 = fast_two_sum(total.hi, (rate.hi*rate.hi)*decay_series(rate.hi));
    const float bent = rate.lo*(0.125f*(rate.hi*rate.hi) - 0.33333334f*rate.hi + 0.5f);
    const float mean_low = total.lo - bent + total2.lo;
    return (Fading){one_minus(pair_prod(rate, (Pair){total2.hi, mean_low})), {total2.hi, mean_low}};
}

// x/y of pairs
static inline Pair pair_quot(Pair x, Pair y) {
    const float total = x.hi/y.hi, left = x.hi - total*y.hi;
    const float left2 = left - fmaf(total, y.hi, -(total*y.hi)), rest = x.lo - total*y.lo;
    const float left3 = left2 + rest;
    return (Pair){total, left3/y.hi};
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss
static inline Fading fading_pair(Pair rate) {
    if (rate.hi < 0.75f) { return brief_fading(rate); }
    const float sunk = expf(-rate.hi), sunk_low = -rate.lo*sunk;
    return (Fading){{sunk, sunk_low}, pair_quot(one_minus((Pair){sunk, sunk_low}), rate)};
}

// what the root of |square + square_low| misses
static inline float root_miss(Pair square, float root) {
    const float sign_low = square.hi < 0.0f ? -square.lo : square.lo;
    const float left = fabsf(square.hi) - (root*root);
    const float left2 = left - fmaf(root, root, -(root*root)), left3 = left2 + sign_low;
    const float whole = root == 0.0f ? 1.0f : root;
    return 0.5f*left3/whole;
}

// the poles p = half + root and q = gamma/p
static inline Poles real_poles(const Motion *motion, float gamma) {
    const Pair total = fast_two_sum(motion->half, motion->root);
    const float p_low = total.lo + root_miss(motion->w, motion->root);
    const float whole = total.hi == 0.0f ? 1.0f : total.hi;
    return (Poles){{whole, p_low}, pair_quot((Pair){gamma, 0.0f}, (Pair){whole, p_low})};
}

// of a creeping device the pole p, exp and mean of the other one and of their distance
static inline Creeping creeping_device(const Motion *motion, float gamma) {
    const Poles poles = real_poles(motion, gamma);
    const Fading fading = fading_pair(poles.q);
    const float root_low = root_miss(motion->w, motion->root);
    const Fading fading2 = fading_pair((Pair){2.0f*motion->root, 2.0f*root_low});
    return (Creeping){poles.p, fading.fall, fading.mean, fading2.fall, fading2.mean};
}

// x - y and what it misses
static inline Pair two_diff(float x, float y) {
    const float total = x - y, back = total - x, rest = total - back, one = x - rest;
    const float two = -back - y;
    return (Pair){total, one + two};
}

// x y and what it misses
static inline Pair two_prod(float x, float y) { return (Pair){x*y, fmaf(x, y, -(x*y))}; }

// half = delta/2, w = half^2 - gamma, its root and the size of the poles
static inline Motion device_motion(float gamma, float delta) {
    const float half = 0.5f*delta;
    const Pair prod = two_prod(half, half), diff = two_diff(prod.hi, gamma);
    const Pair total = fast_two_sum(diff.hi, diff.lo + prod.lo);
    const float root = sqrtf(fabsf(total.hi));
    return (Motion){half, total, root, total.hi < 0.0f ? 0.25f*gamma : 0.44444445f*half +
        0.44444445f*root};
}

// 1 + x of a pair, for |x| <= 1
static inline Pair one_plus(Pair x) {
    const Pair total = fast_two_sum(1.0f, x.hi);
    return (Pair){total.hi, total.lo + x.lo};
}

// x - y of pairs
static inline Pair pair_diff(Pair x, Pair y) {
    const Pair diff = two_diff(x.hi, y.hi);
    const float lost = diff.lo + x.lo;
    return (Pair){diff.hi, lost - y.lo};
}

// x^2 of a pair
static inline Pair pair_square(Pair x) { return wide_prod(x.hi, (Pair){x.hi, 2.0f*x.lo}); }

// number + delta one - gamma two and what it misses, of pairs
static inline Pair plant_n0_term(float gamma, float delta, Pair one, Pair two, float number) {
    return pair_diff(pair_diff(wide_prod(delta, one), wide_prod(gamma, two)),
        (Pair){-number, 0.0f});
}

// the float of a pair
static inline float rounded(Pair x) { return x.hi + x.lo; }

// divided difference of exp at 0, p and q, less 1/2
static inline float plant_n0_series(float gamma, float delta) {
    float one = 0.0f, two = 0.0f;
    for (int n = (0.5f*delta < 0.0625f && fabsf(gamma) < 0.00390625f ? 9 : 20); n >= 6; n -= 1) {
        const float number = inverse_factorial[n], next_one = delta*one - gamma*two + number;
        two = one; one = next_one;
    }
    const Pair one2 = plant_n0_term(gamma, delta, (Pair){one, 0.0f}, (Pair){two, 0.0f},
        0.008333334f);
    const Pair one3 = plant_n0_term(gamma, delta, one2, (Pair){one, 0.0f}, 0.041666668f);
    return rounded(plant_n0_term(gamma, delta,
        plant_n0_term(gamma, delta, one3, one2, 0.16666667f), one3, 0.0f));
}

// (fall + fall_low) (y + z), rounded once
static inline float scaled_sum(Pair fall, float y, float z) {
    return rounded(pair_prod(fall, two_diff(y, -z)));
}

// n0 of a device with slow poles
static inline float plant_n0_near(Pair decayed, float gamma, float delta) {
    return scaled_sum(pair_square(decayed), plant_n0_series(gamma, delta), 0.5f);
}

// n0 of a creeping device
static inline float plant_n0_creep(const Motion *motion, const Creeping *creeping, Pair decayed,
    float gamma, float delta) {
    if (motion->reach < 0.5625f) { return plant_n0_near(decayed, gamma, delta); }
    return rounded(pair_prod(creeping->slow,
        pair_quot(pair_diff(creeping->far, pair_prod(creeping->ratio, creeping->mean)),
        creeping->p)));
}

// x + y of pairs
static inline Pair pair_sum(Pair x, Pair y) {
    const Pair diff = two_diff(x.hi, -y.hi);
    const float lost = diff.lo + x.lo;
    return (Pair){diff.hi, lost + y.lo};
}

// n0 of a swinging device
static inline float plant_n0_swing(const Motion *motion, const Swinging *swinging, Pair decayed,
    float gamma) {
    if (motion->reach < 0.5625f) { return plant_n0_near(decayed, gamma, 2.0f*motion->half); }
    if (swinging->near > 0.0f) { return swinging->sunk; }
    return rounded(pair_quot(wide_prod(swinging->envelope,
        pair_sum(pair_diff(wide_prod(motion->half, swinging->wave), swinging->even),
        (Pair){swinging->envelope, 0.0f})), (Pair){gamma, 0.0f}));
}

// divided difference of exp at h and +-sqrt(w), less 1/2
static inline float plant_n1_series(float h, float w) {
    float total = 0.0f, one = 0.0f, two = 0.0f;
    for (int n = (fabsf(w) < 0.00390625f && h < 0.0625f ? 9 : 20); n >= 3; n -= 1) {
        const float number = inverse_factorial[n], even = number + two*w;
        total = even + h*total; two = one; one = even;
    }
    return h*total + two*w;
}

// n1 of a creeping device
static inline float plant_n1_creep(const Motion *motion, const Creeping *creeping, Pair decayed) {
    if (motion->reach < 0.5625f) {
        return scaled_sum(decayed, plant_n1_series(motion->half, motion->w.hi), 0.5f);
    }
    return rounded(pair_quot(pair_diff(creeping->mean, pair_prod(creeping->slow, creeping->far)),
        creeping->p));
}

// n1 of a swinging device
static inline float plant_n1_swing(const Motion *motion, const Swinging *swinging, Pair decayed,
    float gamma) {
    if (motion->reach < 0.5625f) {
        return scaled_sum(decayed, plant_n1_series(motion->half, motion->w.hi), 0.5f);
    }
    if (swinging->near > 0.0f) { return swinging->risen; }
    return rounded(pair_quot(one_minus(wide_prod(swinging->envelope,
        pair_sum(swinging->even, wide_prod(motion->half, swinging->wave)))), (Pair){gamma, 0.0f}));
}

// exp(-half) of a device with slow poles, and what it misses
static inline Pair slow_fade(const Motion *motion) {
    if (motion->reach < 0.5625f) {
        return pair_square(brief_fading((Pair){0.5f*motion->half, 0.0f}).fall);
    }
    return (Pair){0.0f, 0.0f};
}

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static inline float cos_series(float w) {
    const float square = w*w;
    float one = 0.0f, two = 0.0f;
    for (int n = 14; n >= 6; n -= 2) {
        const float number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.041666668f;
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static inline float sin_series(float w) {
    const float square = w*w;
    float one = 0.0f, two = 0.0f;
    for (int n = 13; n >= 5; n -= 2) {
        const float number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + 0.16666667f;
}

// cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle
static inline Wave waving_pair(Pair square, float angle) {
    if (square.hi > -1.5f) {
        const Pair total = fast_two_sum(1.0f, 0.5f*square.hi);
        const Pair total2 = fast_two_sum(total.hi, (square.hi*square.hi)*cos_series(square.hi));
        const float both = total.lo + total2.lo;
        return (Wave){{total2.hi, both + 0.5f*square.lo},
            one_plus((Pair){square.hi*sin_series(square.hi), 0.16666667f*square.lo})};
    }
    const float angle_low = root_miss(square, angle), sine = sinf(angle), cosine = cosf(angle);
    return (Wave){{cosine, -angle_low*sine},
        pair_quot((Pair){sine, angle_low*cosine}, (Pair){angle, angle_low})};
}

// whether the device has nearly swung whole turns; n1, n0 and n1 + n0 there
static inline Turns whole_turns(float half, Pair square, float root, float stiff) {
    if (half < 0.75f && root > 3.0f && root < 4096.0f) {
        const float count = floorf(0.5f*root/3.1415927f + 0.5f);
        const Pair prod3 = two_prod(count, 6.2831855f), diff6 = two_diff(root, -prod3.hi);
        const float missed = root_miss(square, root), turns = count*count;
        const Pair prod = two_prod(turns, 39.478416f), prod2 = two_prod(turns, 1.1614864e-06f);
        const Pair diff = two_diff(-square.hi, prod.hi), diff2 = two_diff(diff.hi, prod.lo);
        const Pair diff3 = two_diff(diff2.hi, prod2.hi), diff4 = two_diff(diff3.hi, square.lo);
        const float turned_low = -1.1704737e-14f*turns;
        const float low = diff.lo + diff2.lo + diff3.lo + diff4.lo - prod2.lo - turned_low;
        const float back = -1.7484555e-07f*count;
        const Pair quot = pair_quot(two_diff(diff4.hi, -low),
            (Pair){diff6.hi, back + diff6.lo + missed + prod3.lo});
        const float far = quot.hi*quot.hi;
        if (count > 0.0f && far < 1.5f) {
            const Fading fading = brief_fading((Pair){half, 0.0f});
            const Pair less2 = one_minus(fading.fall), squared = pair_square(quot);
            const Pair less = one_minus((Pair){squared.hi*sin_series(-squared.hi), 0.0f});
            const Pair prod4 = wide_prod(quot.hi, less);
            const float bent = (squared.hi*squared.hi)*cos_series(-squared.hi);
            const Pair total = fast_two_sum(0.5f*squared.hi, -bent);
            const float lift_low = 0.5f*less.hi*squared.lo + total.lo;
            const Pair prod5 = pair_prod(fading.fall, (Pair){total.hi, lift_low});
            const Pair quot2 = pair_quot((Pair){prod4.hi, prod4.lo + quot.lo*(1.0f - total.hi)},
                (Pair){root, missed});
            const Pair diff9 = pair_diff((Pair){total.hi, lift_low},
                wide_prod(half, pair_diff(fading.mean, quot2)));
            return (Turns){1.0f, rounded(pair_quot(
                pair_sum(wide_prod(half, pair_diff(fading.mean, pair_prod(fading.fall, quot2))),
                prod5), (Pair){stiff, 0.0f})), rounded(
                pair_quot(pair_prod(fading.fall, two_diff(diff9.hi, -diff9.lo)),
                (Pair){stiff, 0.0f})), rounded(pair_quot(
                pair_sum(pair_square(fast_two_sum(less2.hi, less2.lo)),
                (Pair){2.0f*prod5.hi, 2.0f*prod5.lo}), (Pair){stiff, 0.0f}))};
        }
    }
    return (Turns){0.0f, 0.0f, 0.0f, 0.0f};
}

// of a swinging device exp(-half), cos(root), sin(root)/root and what is near whole turns
static inline Swinging swinging_device(const Motion *motion, float gamma) {
    const Wave wave = waving_pair(motion->w, motion->root);
    const Turns turns = whole_turns(motion->half, motion->w, motion->root, gamma);
    return (Swinging){expf(-motion->half), wave.even, wave.odd, turns.near, turns.risen,
        turns.sunk, turns.moved};
}

// n0, n1 and trace of the device
static inline Device device_n0_n1_trace(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.w.hi < 0.0f) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const float rounded_of = rounded(wide_prod(swinging.envelope, swinging.even));
        return (Device){plant_n0_swing(&motion, &swinging, decayed, gamma),
            plant_n1_swing(&motion, &swinging, decayed, gamma), 2.0f*rounded_of};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device){plant_n0_creep(&motion, &creeping, decayed, gamma, delta),
        plant_n1_creep(&motion, &creeping, decayed),
        rounded(pair_prod(creeping.slow, one_plus(creeping.ratio)))};
}

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static inline float numerator_at_one_series(float h, float w) {
    const float y = h*h;
    float total = 0.0f, inner = 0.0f;
    for (int n = (fabsf(w) < 0.00390625f && h < 0.0625f ? 8 : 20); n >= 4; n -= 2) {
        const float number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y;
}

// n1 + n0 of a creeping device
static inline float numerator_at_one_creep(const Motion *motion, const Creeping *creeping) {
    if (motion->reach < 1.0f) {
        return 2.0f*scaled_sum((Pair){expf(-motion->half), 0.0f},
            numerator_at_one_series(motion->half, motion->w.hi), 0.5f);
    }
    return rounded(pair_quot(pair_prod(creeping->mean,
        one_minus(pair_prod(creeping->slow, creeping->ratio))), creeping->p));
}

// (1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses
static inline Pair half_squares(float half, float envelope, float wave, float back) {
    const float grown = -0.5f*expm1f(-half);
    return pair_sum(wide_prod(envelope, pair_square(two_diff(wave, back))),
        (Pair){grown*grown, 0.0f});
}

// n1 + n0 of a swinging device
static inline float numerator_at_one_swing(const Motion *motion, const Swinging *swinging,
    float gamma) {
    if (motion->reach < 1.0f) {
        return 2.0f*scaled_sum((Pair){swinging->envelope, 0.0f},
            numerator_at_one_series(motion->half, motion->w.hi), 0.5f);
    }
    if (swinging->near > 0.0f) { return swinging->moved; }
    const float angle = 0.5f*motion->root;
    const float back = -0.5f*root_miss(motion->w, motion->root)*cosf(angle);
    return 4.0f*rounded(pair_quot(half_squares(motion->half, swinging->envelope, sinf(angle),
        back), (Pair){gamma, 0.0f}));
}

// together and trace of the device
static inline Device2 device_together_trace(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0f) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const float rounded_of = rounded(wide_prod(swinging.envelope, swinging.even));
        return (Device2){numerator_at_one_swing(&motion, &swinging, gamma), 2.0f*rounded_of};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device2){numerator_at_one_creep(&motion, &creeping),
        rounded(pair_prod(creeping.slow, one_plus(creeping.ratio)))};
}

// n0, the same device with its time reversed, times exp(-delta)
static inline float plant_n0(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.reach < 0.5625f) { return plant_n0_near(decayed, gamma, delta); }
    if (motion.w.hi < 0.0f) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return plant_n0_swing(&motion, &swinging, decayed, gamma);
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return plant_n0_creep(&motion, &creeping, decayed, gamma, delta);
}

// n1, how far a unit force moves the device in a period
static inline float plant_n1(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.reach < 0.5625f) {
        return scaled_sum(decayed, plant_n1_series(motion.half, motion.w.hi), 0.5f);
    }
    if (motion.w.hi < 0.0f) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return plant_n1_swing(&motion, &swinging, decayed, gamma);
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return plant_n1_creep(&motion, &creeping, decayed);
}

// (1 - exp(-x))/x
static inline float decay(float x) { return (x == 0.0f ? 1.0f : -expm1f(-x)/x); }

// 1 + a + e of a creeping device
static inline float denominator_at_minus_one_creep(const Creeping *creeping) {
    return rounded(pair_prod(one_plus(creeping->slow),
        one_plus(pair_prod(creeping->slow, creeping->ratio))));
}

// 1 + a + e of a swinging device
static inline float denominator_at_minus_one_swing(const Motion *motion, const Swinging *swinging) {
    const Pair prod = wide_prod(2.0f*swinging->envelope, swinging->even);
    if (prod.hi > 0.0f) {
        return rounded(pair_sum(one_plus((Pair){expf(-2.0f*motion->half), 0.0f}), prod));
    }
    const float angle = 0.5f*motion->root;
    return 4.0f*rounded(half_squares(motion->half, swinging->envelope, cosf(angle), 0.5f*
        root_miss(motion->w, motion->root)*sinf(angle)));
}

// divided difference of sinh(sqrt)/sqrt at h^2 and w, less the float next to 1/6
static inline float numerator_gap_series(float h, float w) {
    const float y = h*h;
    float total = 0.0f, inner = 0.0f;
    for (int n = (fabsf(w) < 0.00390625f && h < 0.0625f ? 9 : 19); n >= 5; n -= 2) {
        const float number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y - 4.967054e-09f;
}

// (n1 - n0)/delta of a creeping device
static inline float numerator_gap_creep(const Motion *motion, const Creeping *creeping,
    float delta) {
    if (motion->reach < 1.0f) {
        return scaled_sum((Pair){expf(-motion->half), 0.0f},
            numerator_gap_series(motion->half, motion->w.hi), 0.16666667f);
    }
    const Pair diff = pair_diff(creeping->mean, wide_prod(2.0f*creeping->slow.hi, creeping->far));
    const Pair prod2 = wide_prod(creeping->ratio.hi*creeping->slow.hi, creeping->mean);
    const float top = diff.hi + prod2.hi, low = diff.lo + prod2.lo, whole = delta*creeping->p.hi;
    return (low + top)/whole;
}

// (n1 - n0)/delta of a swinging device
static inline float numerator_gap_swing(const Motion *motion, const Swinging *swinging,
    float gamma, float delta) {
    if (motion->reach < 1.0f) {
        return scaled_sum((Pair){swinging->envelope, 0.0f},
            numerator_gap_series(motion->half, motion->w.hi), 0.16666667f);
    }
    return rounded(pair_quot(pair_diff((Pair){decay(delta), 0.0f},
        wide_prod(swinging->envelope, swinging->wave)), (Pair){gamma, 0.0f}));
}

// at_minus_one, kick, together, n_gap, n0 and n1 of the device
static inline Device3 device_at_minus_one_kick_together_n_gap_n0_n1(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0f) {
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
static inline float cubic_root(float k0, float k1, float k2, float k3, float low, float high,
    float rise) {
    const float convex = 2.0f*k2 + 3.0f*k3*(high + low) > 0.0f ? 1.0f : -1.0f;
    const float down = convex*rise > 0.0f ? 1.0f : -1.0f;
    float y = down > 0.0f ? high : low, moves = 1.0f;
    for (int count_y = 0; count_y < 1000; ++count_y) {
        if (moves == 0.0f) { break; }
        const float steep = k1 + y*(2.0f*k2 + 3.0f*k3*y), some = steep == 0.0f ? 1.0f : steep;
        const float move = steep == 0.0f ? 0.0f : (k0 + y*(k1 + y*(k2 + k3*y)))/some;
        const float new_ = fminf(high, y - move), new2 = fmaxf(low, new_);
        moves = down*(y - new2) > 0.0f ? 1.0f : 0.0f; y = new2;
    }
    return y;
}

// of x + j u: half turns and the rest of the angle, the size and its inverse, how far both may be
// off, and how they change with y
static inline Part crossing_part(float x, float u, float x_off, float u_off, float steep,
    float low, float high) {
    const float most = fmaxf(fabsf(u), fabsf(x)), least = fminf(fabsf(u), fabsf(x));
    const float whole = most == 0.0f ? 1.0f : most, ratio = least/whole;
    const float longer = sqrtf(ratio*ratio + 1.0f), size = longer*most;
    const float whole2 = size == 0.0f ? 1.0f : size, per = 1.0f/whole2, real = per*x, up = per*u;
    const float along = per*x_off, across = per*u_off, away = across + along, one = fabsf(real);
    const float two = fabsf(up), blur = (2.0f*away + 1.0f)*(across*one + along*two);
    const float rest = atan2f(x < 0.0f ? -u : u, fabsf(x)), falls = per*steep;
    const float tilt = 0.5f*low - 0.5f*high, square = up*up;
    const float fast = square*(high + low) + 2.0f*fabsf(falls);
    return (Part){x < 0.0f ? (u < 0.0f ? -1.0f : 1.0f) : 0.0f, rest, size, per, size > 0.0f ?
        across*two + along*one + away*away : 1.0f, away < 0.25f ? blur + 2.3841858e-07f*
        fabsf(rest) : 4.0f, 2.0f*falls*real + 2.0f*square*tilt, fast, 2.0f*(falls*falls) + fast*
        fast + 2.0f*high*low*square, up*(real*tilt - falls), two*(one*fabsf(tilt) + fabsf(falls))};
}

// the nearest whole number of turns in the phase at a crossing, NaN where that is not certain
static inline float phase_turns(const Loop *loop, float y, float rest, float off, float loose,
    float free) {
    const float at = fmaxf(0.0f, y), still = fmaxf(0.0f, rest), sine = 2.0f*sqrtf(at*still);
    const float total = 2.0f - loop->loss, plain = loose + 2.3841858e-07f;
    const float made = loose + 7.1525574e-07f, edge = fminf(at, still);
    const float whole = at == 0.0f ? 1.0f : at, low = edge/whole;
    const float whole2 = still == 0.0f ? 1.0f : still, high = edge/whole2;
    const Part part2 = crossing_part(still*loop->together - loop->apart*at, loop->n1*sine,
        loop->apart_off*at + made*(at*fabsf(loop->apart) + still*loop->together), sine*
        (made*fabsf(loop->n1) + loop->n1_off), edge*(-loop->apart - loop->together), low, high);
    const Part part3 = crossing_part(loop->alpha*still - at*loop->far, sine*loop->slope, plain*
        (at*fabsf(loop->far) + still*fabsf(loop->alpha)), plain*sine*fabsf(loop->slope), edge*
        (-loop->alpha - loop->far), low, high);
    const Part part = crossing_part(-2.0f*off*total, loop->loss*sine, 4.0f*loop->a_off + total*
        (2.0f*free + 4.7683716e-07f*fabsf(off)), loop->loss*made*sine, -2.0f*edge*total, low, high);
    const float ratio = part.per*part2.size, gap_ = 1.0f - 0.25f*ratio*part3.size;
    const float rough = part.off + part2.off + part3.off + 7.1525574e-07f, distant = fabsf(gap_);
    const float miss = 3.0f*part.off + 4.7683716e-07f, miss2 = 3.0f*part2.off + 4.7683716e-07f;
    const float miss3 = 3.0f*part3.off + 4.7683716e-07f;
    const float sure = -part.fast*miss - part2.fast*miss2 - part3.fast*miss3 +
        fabsf(part2.slope - part.slope + part3.slope);
    const float whole3 = sure == 0.0f ? 1.0f : sure;
    const float reach = 0.25f*(9.0f*distant + 9.0f*rough)/whole3;
    const float bends = part.bend + part2.bend + part3.bend;
    const float half = atan2f(at > 2.0f ? sqrtf(still) : sqrtf(at), at > 2.0f ? sqrtf(at) :
        sqrtf(still));
    const float late = loop->d + 2.0f;
    const float halves4 = part2.halves - part.halves + part3.halves - (at > 2.0f ? late : 0.0f);
    const float share = 0.5f*(-late*(at > 2.0f ? -2.0f*half : 2.0f*half) - part.rest + part2.rest +
        part3.rest)/3.1415927f;
    const float even = floorf(0.5f*halves4), left = 0.5f*halves4 - even;
    const float near = fabsf(share - floorf(share + 0.5f));
    const float distance = left == 0.5f ? near : 0.5f - near, whole4 = sine == 0.0f ? 1.0f : sine;
    const float delayed = 2.0f*edge*late/whole4;
    const float most = delayed + part.spread + part2.spread + part3.spread;
    const float blur_ = part.blur + part2.blur + part3.blur + half*late*(loose + 4.7683716e-07f) +
        reach*(4.7683716e-07f*delayed + miss*part.spread + miss2*part2.spread + miss3*
        part3.spread + 2.0f*most*reach*(part.fast + part2.fast + part3.fast + 2.0f) +
        fabsf(delayed + part.turn - part2.turn - part3.turn));
    const float good = blur_ < 6.0f*distance && reach < 0.25f && sure > 0.0f && sure > 8.0f*bends*
        reach ? 1.0f : 0.0f;
    if (good > 0.0f) {
        return even + (left == 0.5f ? floorf(share) + 1.0f : floorf(left + share + 0.5f));
    }
    return NAN;
}

// what the crossing on a piece, if there is one, adds
static inline float piece_turns(const Loop *loop, float k0, float k1, float k2, float k3,
    float low, float high, float at_low, float at_high, float zone) {
    if (((at_high >= 0.0f && at_low < 0.0f) || (at_high < 0.0f && at_low >= 0.0f)) &&
        (at_low != 0.0f || low != 0.0f) && high > low) {
        const float x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const float y = zone == 0.0f ? x : (zone == 1.0f ? loop->center + x : 4.0f - x);
        const float rest = zone == 0.0f ? 4.0f - x : (zone == 1.0f ? loop->beyond - x : x);
        if (rest > 0.0f && y > 0.0f) {
            const float off = zone == 0.0f ? x - loop->center :
                (zone == 1.0f ? x : loop->beyond - x);
            const float loose = zone == 1.0f ? 9.536743e-07f : 1.1920929e-07f;
            const float free = zone == 1.0f ? 0.0f : 4.7683716e-07f*
                (zone == 0.0f ? loop->center : loop->beyond);
            const float found = phase_turns(loop, y, rest, off, loose, free);
            const float rises = (zone == 2.0f ? -1.0f : 1.0f)*(at_high > at_low ? 1.0f : -1.0f);
            return -2.0f*found*rises;
        }
        return NAN;
    }
    return 0.0f;
}

// NaN where it is not certain that the device is stronger if leads is positive, and else the wall,
// else 0
static inline float touches(const Loop *loop, float leads, float y, float rest, float off,
    float loose, float free) {
    const float at = fmaxf(0.0f, y), still = fmaxf(0.0f, rest), sine = 2.0f*sqrtf(at*still);
    const float total = 2.0f - loop->loss, plain = loose + 2.3841858e-07f;
    const Part part3 = crossing_part(loop->alpha*still - at*loop->far, sine*loop->slope, plain*
        (at*fabsf(loop->far) + still*fabsf(loop->alpha)), plain*sine*fabsf(loop->slope), 0.0f,
        0.0f, 0.0f);
    const float made = loose + 7.1525574e-07f;
    const Part part2 = crossing_part(still*loop->together - loop->apart*at, loop->n1*sine,
        loop->apart_off*at + made*(at*fabsf(loop->apart) + still*loop->together), sine*
        (made*fabsf(loop->n1) + loop->n1_off), 0.0f, 0.0f, 0.0f);
    const Part part = crossing_part(-2.0f*off*total, loop->loss*sine, 4.0f*loop->a_off + total*
        (2.0f*free + 4.7683716e-07f*fabsf(off)), loop->loss*made*sine, 0.0f, 0.0f, 0.0f);
    const float ratio = part.per*part2.size, gap_ = 1.0f - 0.25f*ratio*part3.size;
    const float rough = part.off + part2.off + part3.off + 7.1525574e-07f;
    const float signed_ = leads > 0.0f ? gap_ : -gap_, good = signed_ > 2.0f*rough ? 1.0f : 0.0f;
    if (good < 1.0f && rest > 0.0f && y > 0.0f) { return NAN; }
    return 0.0f;
}

// NaN where the wall may be as strong as the device at an extremum of both, else 0
static inline float zone_touches(const Loop *loop, float leads, float x, float zone) {
    const float y = zone == 0.0f ? x : (zone == 1.0f ? loop->center + x : 4.0f - x);
    const float rest = zone == 0.0f ? 4.0f - x : (zone == 1.0f ? loop->beyond - x : x);
    const float off = zone == 0.0f ? x - loop->center : (zone == 1.0f ? x : loop->beyond - x);
    const float loose = zone == 1.0f ? 9.536743e-07f : 1.1920929e-07f;
    const float free = zone == 1.0f ? 0.0f : 4.7683716e-07f*
        (zone == 0.0f ? loop->center : loop->beyond);
    return touches(loop, leads, y, rest, off, loose, free);
}

// what the crossings between two points add to the count
static inline float zone_turns(const Loop *loop, float k0, float k1, float k2, float k3, float low,
    float high, float at_low, float at_high, float zone) {
    const float disc = k2*k2 - 3.0f*k1*k3, root = sqrtf(fmaxf(0.0f, disc));
    const float q = -k2 - (k2 < 0.0f ? -root : root);
    const float some = fabsf(k2) < 24.0f*fabsf(k3) ? 3.0f*k3 : 1.0f, at = -k2/some;
    const float cut = at > low && at < high && fabsf(k2) < 24.0f*fabsf(k3) ? at : low;
    const float some2 = fabsf(q) < 24.0f*fabsf(k3) ? 3.0f*k3 : 1.0f, at2 = q/some2;
    const float cut2 = at2 > low && at2 < high && fabsf(q) < 24.0f*fabsf(k3) ? at2 : low;
    const float some3 = fabsf(k1) < 8.0f*fabsf(q) ? q : 1.0f, at3 = k1/some3;
    const float cut3 = at3 > low && at3 < high && fabsf(k1) < 8.0f*fabsf(q) ? at3 : low;
    const float less = fminf(cut2, cut3), more = fmaxf(cut2, cut3), first = fminf(cut, less);
    const float middle = fmaxf(cut, less), last = fmaxf(middle, more);
    const float middle2 = fminf(middle, more), p = first*(first*(first*k3 + k2) + k1) + k0;
    const float p2 = k0 + middle2*(k1 + middle2*(k2 + k3*middle2));
    const float p3 = k0 + last*(k1 + last*(k2 + k3*last));
    const float value2 = cut3*(cut3*(cut3*k3 + k2) + k1) + k0;
    float found = 0.0f;
    if (cut2 > low) {
        const float value = cut2*(cut2*(cut2*k3 + k2) + k1) + k0;
        found = zone_touches(loop, value, cut2, zone);
    }
    const float found2 = found + (cut3 > low ? zone_touches(loop, value2, cut3, zone) : 0.0f);
    const float found3 = found2 + piece_turns(loop, k0, k1, k2, k3, low, first, at_low, p, zone);
    const float found4 = found3 + piece_turns(loop, k0, k1, k2, k3, first, middle2, p, p2, zone);
    const float found5 = found4 + piece_turns(loop, k0, k1, k2, k3, middle2, last, p2, p3, zone);
    return found5 + piece_turns(loop, k0, k1, k2, k3, last, high, p3, at_high, zone);
}

// roots outside the unit circle behind a fractional delay, -1 where that is not certain
static inline float fractional_roots(float alpha, float beta, float d, float m2, float m0,
    float gamma, float at_minus_one, float loss, float together, float apart, float across) {
    if (alpha == 0.0f && beta == 0.0f) { return 0.0f; }
    const float strength = fabsf(alpha) + fabsf(beta), stiffest = fmaxf(gamma, fabsf(alpha));
    const float slope = alpha + beta, wall_far = alpha + 2.0f*beta, force = beta*slope;
    const float lost = loss*loss, square = m0*m2, size = across*across, at_one = gamma*together;
    const float size2 = m2 + together + fabsf(m0), near_half = sqrtf(fminf(1.0f, at_minus_one));
    const float whole = gamma == 0.0f ? 1.0f : gamma, apart_off = 3.8146973e-06f*near_half*size2;
    const float n1_off = 7.6293945e-06f*(gamma > 10.0f && loss < 0.5f ? 2.0f*
        sqrtf(fminf(1.0f, at_one))/whole : 0.125f*size2);
    const float a_off = 4.5474735e-13f*sqrtf(at_minus_one*gamma);
    const float apart_one = (gamma - alpha)*(alpha + gamma), even = together*together;
    const float even2 = together*(m0 + m2), linear = size - even2, push = alpha*alpha;
    const float near0 = apart_one*even;
    const float near1 = -at_one*(2.0f - loss) - force*(together*together) - linear*push + lost;
    const float near2 = -force*linear - loss - push*square + 1.0f, near3 = -force*square;
    const float most = at_one*(2.0f - loss) + lost + push*(size + fabsf(even2)) +
        (together*together)*fabsf(force);
    const float blurred = n1_off*(n1_off + 2.0f*fabsf(across)), pull = fabsf(apart*wall_far);
    const float end_off = a_off + apart_off*fabsf(wall_far) + 9.536743e-07f*at_minus_one +
        9.536743e-07f*pull;
    const float end_apart = fabsf(at_minus_one - pull) - end_off;
    const float end_least = end_apart*(at_minus_one + pull);
    const float room = (alpha*alpha)*blurred + 1.9073486e-06f*most, product = 4.0f*near0*near2;
    const float pushed_ = apart*wall_far, even3 = apart*(m0 + m2), linear2 = size - even3;
    const float push2 = wall_far*wall_far, far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_);
    const float far1 = (apart*apart)*force - at_minus_one*(2.0f - loss) - linear2*push2 + lost;
    const float far2 = force*linear2 - loss - push2*square + 1.0f, far3 = force*square;
    const float most2 = (apart*apart)*fabsf(force) + at_minus_one*(2.0f - loss) + lost + push2*
        (size + fabsf(even3));
    const float even4 = apart_off*(m2 + fabsf(m0));
    const float room2 = 2.0f*a_off + apart_off*(apart_off + 2.0f*fabsf(apart))*fabsf(force) +
        1.9073486e-06f*most2 + (wall_far*wall_far)*(blurred + even4);
    const float product2 = 4.0f*far0*far2;
    if ((((stiffest > 0.0f && stiffest < 9.094947e-13f) || loss + strength < 9.094947e-13f) &&
        strength > 0.0f) || (end_least <= 8.0f*room2 + 128.0f*fabsf(far3) && product2 >= 0.0f &&
        product2 <= room2*room2 && room2 >= fabsf(far1)) ||
        (fabsf(near0) <= 8.0f*room + 128.0f*fabsf(near3) && product >= 0.0f && product <= room*
        room && room >= fabsf(near1)) || end_apart <= 0.0f) {
        return -1.0f;
    }
    const float middle = 2.0f*at_one/(2.0f - loss), rest = 2.0f*at_minus_one/(2.0f - loss);
    const float sine = 0.25f*middle*rest, tilt = 0.25f*rest - 0.25f*middle;
    const float real = 0.25f*rest*together - 0.25f*apart*middle, one = real*real + sine*size;
    const float two = size*tilt - real*(m0 + m2), wave = 0.25f*alpha*rest - 0.25f*middle*wall_far;
    const float wall = sine*(slope*slope) + wave*wave, own0 = lost*sine - one*wall;
    const float own1 = lost*tilt - force*one - two*wall;
    const float own2 = -force*two - loss - square*wall + 1.0f, own3 = -force*square;
    const float one2 = 0.5f*middle, two2 = 0.5f*rest;
    const float before = own0 - one2*(own1 - one2*(own2 - one2*own3));
    const float after = own0 + two2*(own1 + two2*(own2 + own3*two2)), zone = 0.0f;
    const float side = slope >= 0.0f ? 1.0f : -1.0f;
    const float end = (wall_far > 0.0f ? side : 0.0f) - d +
        (apart > 0.0f ? (across >= 0.0f ? 1.0f : -1.0f) : 0.0f) - 3.0f;
    const Loop loop = {alpha, slope, wall_far, d, across, loss, together, apart, apart_off, n1_off,
        a_off, middle, rest};
    const float total = ((((((near2 == 0.0f && near3 < 0.0f) || near2 < 0.0f) && near1 == 0.0f) ||
        near1 < 0.0f) && near0 == 0.0f) || near0 < 0.0f ? (alpha > 0.0f ? 0.0f : side) : 0.0f) +
        zone_turns(&loop, far0, far1, far2, far3, zone, two2, far0, after, 2.0f) +
        zone_turns(&loop, near0, near1, near2, near3, zone, one2, near0, before, zone) +
        zone_turns(&loop, own0, own1, own2, own3, -one2, two2, before, after, 1.0f);
    const float total2 = total - ((((((far2 == 0.0f && far3 < 0.0f) || far2 < 0.0f) &&
        far1 == 0.0f) || far1 < 0.0f) && far0 == 0.0f) || far0 < 0.0f ? end : 0.0f);
    return (total2 >= 0.0f ? total2 : -1.0f);
}

// m2 - m1 + m0 of the device behind a fraction of a period
static inline float fractional_numerator_gap(float epsilon, Pair x, Pair y, float first,
    float last, float turned) {
    const Pair prod3 = pair_prod(wide_prod(epsilon, one_minus((Pair){epsilon, 0.0f})),
        pair_prod(x, y));
    return rounded(pair_sum(pair_diff(pair_diff((Pair){first, 0.0f},
        (Pair){2.0f*prod3.hi, 2.0f*prod3.lo}), (Pair){last, 0.0f}), (Pair){turned, 0.0f}));
}

// m2 - m1 + m0 of a device that swings, hardly damped
static inline float half_turned_swing(float gamma, float delta, float part) {
    const Motion motion = device_motion(gamma, delta);
    const float angle = 0.5f*motion.root, angle_low = 0.5f*root_miss(motion.w, motion.root);
    const Pair prod = pair_prod((Pair){angle, angle_low}, fast_two_sum(1.0f, -part));
    const Pair prod2 = pair_prod((Pair){angle, angle_low}, (Pair){part, 0.0f});
    const float wave = sinf(angle), still = cosf(angle), sine = angle_low*still + wave;
    const float cosine = still - angle_low*wave, wave2 = sinf(prod.hi), still2 = cosf(prod.hi);
    const float sine2 = prod.lo*still2 + wave2, cosine2 = still2 - prod.lo*wave2;
    const float wave3 = sinf(prod2.hi), still3 = cosf(prod2.hi), sine3 = prod2.lo*still3 + wave3;
    const float cosine3 = still3 - prod2.lo*wave3, along = cosine2*cosine3 + sine2*sine3;
    const float across = cosine3*sine2 - cosine2*sine3, before = 0.5f - part;
    const float step = expm1f(0.5f*motion.half), weak = 0.5f*step + 0.5f*step/(step + 1.0f);
    const float more = 0.5f*(step*step)/(step + 1.0f), strong = more + 1.0f;
    const float fallen = expm1f(-before*motion.half), grown = fallen + 1.0f;
    const float ratio = motion.half/motion.root;
    const float lost = weak*weak - along*cosine*(fallen*strong + more);
    const float turned = grown*sine*weak*(across - along*ratio);
    const float kept = across*cosine*grown*ratio*strong;
    const float total2 = -2.0f*cosine*sine2*sine3 - kept + lost + turned;
    return 4.0f*total2*expf(-motion.half)/gamma;
}

// m2 - m1 + m0 behind a fraction of a period
static inline float half_turned(float found, float gamma, float delta, float part) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.half < 0.25f && motion.root > 3.0f && motion.w.hi < 0.0f) {
        return half_turned_swing(gamma, delta, part);
    }
    return found;
}

// kick, kick_low, n_gap, n0 and n1 of the device
static inline Device4 device_kick_kick_low_n_gap_n0_n1(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0f) {
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
static inline Delayed late_device(float gamma, float delta, float part) {
    const float t0 = 1.0f - part, t1 = t0*t0, t2 = gamma*t1, t3 = delta*t0;
    const Device4 device = device_kick_kick_low_n_gap_n0_n1(t2, t3);
    const float t5 = part*part, t6 = gamma*t5, t7 = delta*part;
    const Device4 device2 = device_kick_kick_low_n_gap_n0_n1(t6, t7);
    const float t9 = device2.n0*t5;
    return (Delayed){half_turned(fractional_numerator_gap(part, device.kick, device2.kick, delta*
        device.n_gap*(t0*t0*t0), delta*device2.n_gap*(part*part*part), device.n0*t1*
        (device2.kick.hi*t7 + device2.n1*t6) + device.n1*device2.n1*t2*t5 - t3*t9*decay(t3)),
        gamma, delta, part), device.n1*t1, device.kick.hi*t0, t9*expf(-t3)};
}

// 1 where the loop is stable, else 0
static inline float stable(float roots, float alpha, float beta, float gamma, float delta) {
    const float swing = sqrtf(gamma);
    if (!(alpha == 0.0f && beta == 0.0f && delta == 0.0f && gamma > 0.0f) &&
        !(delta < 5.9604645e-07f && gamma > 1.0f && swing >= 4.194304e+06f*fabsf(sinf(swing))) &&
        alpha > -gamma && roots == 0.0f) {
        return 1.0f;
    }
    return 0.0f;
}

// a point that is known about three, and whether it is on the circle
static inline Point nearest_point(const Loop *loop, float y, float rest, float off) {
    const float edge = rest > y ? y : rest;
    const float inside = edge > fabsf(off) && loop->beyond - off > 0.0f && loop->center +
        off > 0.0f ? 1.0f : 0.0f;
    return (Point){inside > 0.0f ? loop->center + off : (rest > y ? y : 4.0f - rest),
        inside > 0.0f ? loop->beyond - off : (rest > y ? 4.0f - y : rest), inside > 0.0f ? off :
        (rest > y ? y - loop->center : loop->beyond - rest), inside > 0.0f ? 9.536743e-07f :
        1.1920929e-07f, inside > 0.0f ? 0.0f : 4.7683716e-07f*
        (rest > y ? loop->center : loop->beyond), fminf(rest, y) < 4.0f && rest > 0.0f &&
        y > 0.0f ? 1.0f : 0.0f};
}

// NaN where the wall may be as strong as the device at an extremum of both, else 0
static inline float bottom_touches(const Loop *loop, float leads, float y, float rest, float off) {
    const Point point = nearest_point(loop, y, rest, off);
    if (point.there > 0.0f) {
        const Loop loop2 = {.alpha = loop->alpha, .slope = loop->slope, .far = loop->far, .n1 =
            loop->n1, .loss = loop->loss, .together = loop->together, .apart = loop->apart,
            .apart_off = 0.0f, .n1_off = 0.0f, .a_off = loop->a_off};
        return touches(&loop2, leads, point.at, point.still, point.away, point.loose, point.free);
    }
    return 0.0f;
}

// the turns at a crossing, if there is one
static inline float crossing_turns(const Loop *loop, float y, float rest, float off) {
    const Point point = nearest_point(loop, y, rest, off);
    if (point.there > 0.0f) {
        const Loop loop2 = {.alpha = loop->alpha, .slope = loop->slope, .far = loop->far, .d =
            loop->d, .n1 = loop->n1, .loss = loop->loss, .together = loop->together, .apart =
            loop->apart, .apart_off = 0.0f, .n1_off = 0.0f, .a_off = loop->a_off};
        return phase_turns(&loop2, point.at, point.still, point.away, point.loose, point.free);
    }
    return 0.0f;
}

// (-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite
static inline Roots quadratic_roots(float c, float b, float a, float root) {
    const float q = -0.5f*b - 0.5f*(b >= 0.0f ? root : -root), lead_ = a == 0.0f ? 1.0f : a;
    const float own = q == 0.0f ? 1.0f : q, one = a == 0.0f ? -1.0f : q/lead_;
    const float two = q == 0.0f ? -1.0f : c/own;
    if (b >= 0.0f) { return (Roots){one, two}; }
    return (Roots){two, one};
}

// roots outside the unit circle, -1 where that is not certain
static inline float whole_roots(float alpha, float beta, float d, float n1, float n0, float gamma,
    float at_minus_one, float loss, float together, float apart) {
    if (alpha == 0.0f && beta == 0.0f) { return 0.0f; }
    const float strength = fabsf(alpha) + fabsf(beta), stiffest = fmaxf(gamma, fabsf(alpha));
    const float e = 1.0f - loss, slope = alpha + beta, wall_far = alpha + 2.0f*beta;
    const float force = beta*slope, cross = n0*n1, lost = loss*loss, square = cross*force + e;
    const float at_one = gamma*together, even = together*together, pull = apart*wall_far;
    const float near1 = (alpha*alpha)*cross - at_one*(e + 1.0f) - even*force + lost;
    const float near1_size = fabsf(lost) + fabsf((alpha*alpha)*cross) + fabsf(at_one*(e + 1.0f)) +
        fabsf(even*force);
    const float apart_one = (gamma - alpha)*(alpha + gamma), near0 = apart_one*even;
    const float far1 = (apart*apart)*force - at_minus_one*(e + 1.0f) - cross*(wall_far*wall_far) +
        lost;
    const float far1_size = fabsf(lost) + fabsf((apart*apart)*force) +
        fabsf(at_minus_one*(e + 1.0f)) + fabsf(cross*(wall_far*wall_far));
    const float far0 = (at_minus_one - pull)*(at_minus_one + pull), center = 2.0f*at_one/(e + 1.0f);
    const float beyond = 2.0f*at_minus_one/(e + 1.0f), sine = 0.25f*beyond*center;
    const float tilt = 0.25f*beyond - 0.25f*center;
    const float real = 0.25f*beyond*together - 0.25f*apart*center, m0 = (n1*n1)*sine + real*real;
    const float m1 = (n1*n1)*tilt - n1*real, wave = 0.25f*alpha*beyond - 0.25f*center*wall_far;
    const float wall = sine*(slope*slope) + wave*wave, own0 = lost*sine - m0*wall;
    const float own1 = lost*tilt - force*m0 - m1*wall, own2 = e - force*m1;
    const float a_off = 4.5474735e-13f*sqrtf(at_minus_one*gamma), pull2 = fabsf(apart*wall_far);
    const float end_off = a_off + 9.536743e-07f*at_minus_one + 9.536743e-07f*pull2;
    const float end_apart = fabsf(at_minus_one - pull2) - end_off;
    const float end_least = end_apart*(at_minus_one + pull2), room = 1.9073486e-06f*near1_size;
    const float product = 4.0f*near0*square, room2 = 2.0f*a_off + 1.9073486e-06f*far1_size;
    const float product2 = 4.0f*far0*square, square2 = near1*near1, product3 = 4.0f*near0*square;
    const float size = square2 + fabsf(product3), square3 = own1*own1, product4 = 4.0f*own0*own2;
    const float size2 = square3 + fabsf(product4), square4 = far1*far1, product5 = 4.0f*far0*square;
    const float size3 = square4 + fabsf(product5);
    const float odd2 = fabsf(((((far1 == 0.0f && square < 0.0f) || far1 < 0.0f) && far0 == 0.0f) ||
        far0 < 0.0f ? 1.0f : 0.0f) - ((((near1 == 0.0f && square < 0.0f) || near1 < 0.0f) &&
        near0 == 0.0f) || near0 < 0.0f ? 1.0f : 0.0f));
    const float disc4 = size >= size2 && size2 <= size3 ? square3 - product4 :
        (size > size3 && size2 > size3 ? square4 - product5 : square2 - product3);
    const float positive = disc4 >= 0.0f ? disc4 : 0.0f, root = sqrtf(positive);
    const Roots roots = quadratic_roots(near0, near1, square, root);
    const Roots roots3 = quadratic_roots(far0, far1, square, root);
    const float odd = fabsf((disc4 >= 0.0f && fminf(roots.high, roots3.low) < 4.0f &&
        roots.high > 0.0f && roots3.low > 0.0f ? 1.0f : 0.0f) -
        (disc4 >= 0.0f && fminf(roots3.high, roots.low) < 4.0f && roots.low > 0.0f &&
        roots3.high > 0.0f ? 1.0f : 0.0f));
    if ((((stiffest > 0.0f && stiffest < 9.094947e-13f) || loss + strength < 9.094947e-13f) &&
        strength > 0.0f) || (end_least <= 8.0f*room2 && product2 >= 0.0f && product2 <= room2*
        room2 && room2 >= fabsf(far1)) || (fabsf(near0) <= 8.0f*room && product >= 0.0f &&
        product <= room*room && room >= fabsf(near1)) || end_apart <= 0.0f || odd != odd2) {
        return -1.0f;
    }
    const float side = slope >= 0.0f ? 1.0f : -1.0f;
    const float end = (wall_far > 0.0f ? side : 0.0f) - d +
        (apart > 0.0f ? (n1 >= 0.0f ? 1.0f : -1.0f) : 0.0f) - 3.0f;
    float total;
    if (disc4 >= 0.0f) {
        const Roots roots2 = quadratic_roots(own0, own1, own2, root);
        const Loop loop = {.alpha = alpha, .slope = slope, .far = wall_far, .d = d, .n1 = n1,
            .loss = loss, .together = together, .apart = apart, .a_off = a_off, .center = center,
            .beyond = beyond};
        total = 2.0f*crossing_turns(&loop, roots.low, roots3.high, roots2.low) - 2.0f*
            crossing_turns(&loop, roots.high, roots3.low, roots2.high);
    } else {
        float bottom, bottom2;
        if (square == 0.0f) {
            bottom = -1.0f; bottom2 = -1.0f;
        } else {
            bottom = -0.5f*near1/square; bottom2 = -0.5f*far1/square;
        }
        const float bottom3 = own2 == 0.0f ? -1.0f : -0.5f*own1/own2;
        const Loop loop2 = {.alpha = alpha, .slope = slope, .far = wall_far, .n1 = n1, .loss =
            loss, .together = together, .apart = apart, .a_off = a_off, .center = center, .beyond =
            beyond};
        total = bottom_touches(&loop2, square, bottom, bottom2, bottom3);
    }
    const float total2 = total + ((((near1 == 0.0f && square < 0.0f) || near1 < 0.0f) &&
        near0 == 0.0f) || near0 < 0.0f ? (alpha > 0.0f ? 0.0f : side) : 0.0f);
    const float total3 = total2 - ((((far1 == 0.0f && square < 0.0f) || far1 < 0.0f) &&
        far0 == 0.0f) || far0 < 0.0f ? end : 0.0f);
    return (total3 >= 0.0f ? total3 : -1.0f);
}

// the imaginary and the real part of A/(z M), M over A being the device, at z = exp(2 j psi)
static inline Response ahead_in_phase(float psi, float at_one, float at_minus_one, float loss,
    float together, float apart, float across) {
    const float t = tanf(psi), square = t*t, low = fmaf(t, t, -(t*t));
    const Pair diff = two_diff(at_one, at_minus_one*square);
    const float missed = at_minus_one*low + fmaf(at_minus_one, square, -(at_minus_one*square));
    const Pair total = fast_two_sum(diff.hi, diff.lo - missed);
    const Pair diff2 = two_diff(together, apart*square);
    const float missed2 = apart*low + fmaf(apart, square, -(apart*square));
    const Pair total2 = fast_two_sum(diff2.hi, diff2.lo - missed2);
    const float above_j = 2.0f*loss*t, below_j = across*t;
    const float rest = below_j*below_j + 2.0f*total2.hi*total2.lo;
    const float size = rest + total2.hi*total2.hi, low2 = above_j*total2.lo - below_j*total.lo;
    const float found = above_j*total2.hi - below_j*total.hi, found2 = found + low2;
    const float low22 = total.hi*total2.lo + total2.hi*total.lo, rest2 = above_j*below_j + low22;
    const float found3 = rest2 + total.hi*total2.hi;
    return (Response){found2/size, found3/size};
}

// at_minus_one, kick, together and n_gap of the device
static inline Device5 device_at_minus_one_kick_together_n_gap(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0f) {
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
static inline CosSin next_wave(float k, float x) {
    const float count = k + 1.0f, before = count - 1.0f, angle = count*x, missed = k - before;
    const float quarters = floorf(2.0f*angle/3.1415927f + 0.5f);
    const Pair diff = two_diff(angle - 1.5707964f*quarters,
        fmaf(quarters, 1.5707964f, -(quarters*1.5707964f)));
    const Pair diff2 = two_diff(diff.hi, -4.371139e-08f*quarters);
    const Pair diff3 = two_diff(diff2.hi, -fmaf(count, x, -(count*x)));
    const Pair diff4 = two_diff(diff3.hi, -missed*x);
    const float low = diff.lo + diff2.lo + diff3.lo + diff4.lo + 1.7151245e-15f*quarters -
        fmaf(quarters, -4.371139e-08f, -(quarters*-4.371139e-08f));
    const float low2 = low + fmaf(missed, x, -(missed*x)), wave = sinf(diff4.hi);
    const float still = cosf(diff4.hi), turn_ = quarters - 4.0f*floorf(0.25f*quarters);
    const float sine = low2*still + wave, cosine = still - low2*wave;
    const float value = turn_ == 1.0f || turn_ == 3.0f ? sine : cosine;
    const float value2 = turn_ == 1.0f || turn_ == 3.0f ? cosine : sine;
    return (CosSin){turn_ >= 1.0f && turn_ <= 2.0f ? -value : value, turn_ >= 2.0f ? -value2 :
        value2};
}

// at_minus_one, together, n_gap, n0 and n1 of the device
static inline Device6 device_at_minus_one_together_n_gap_n0_n1(float gamma, float delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < 0.0f) {
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
static inline float early_slope(float theta, float k4, float k3, float k2, float k1, float k0) {
    const float sine = sinf(0.5f*theta), cosine = cosf(0.5f*theta), up = sine*sine;
    const float along = cosine*cosine, found = along*k3 + k4*up, power2 = along*along;
    const float found2 = found*up + k2*power2, power3 = along*power2;
    const float found3 = found2*up + k1*power3, power4 = along*power3;
    return found3*up + k0*power4;
}

// has the sign of the slope of the boundary's alpha next to pi
static inline float end_slope(float at_minus_one, float loss, float together, float apart,
    float last) {
    const Pair diff = two_diff(together, 4.0f*last), squared = pair_square(diff);
    const Pair prod = two_prod(apart, together);
    const Pair prod5 = wide_prod(loss, wide_prod(apart, pair_diff(prod, squared)));
    const Pair prod6 = pair_prod(pair_square((Pair){apart, 0.0f}),
        pair_diff((Pair){2.0f*apart, 0.0f}, diff));
    return rounded(pair_diff(pair_diff((Pair){4.0f*prod6.hi, 4.0f*prod6.lo},
        wide_prod(at_minus_one, pair_sum(pair_prod(diff,
        pair_diff(squared, (Pair){2.0f*prod.hi, 2.0f*prod.lo})), wide_prod(apart, prod)))),
        (Pair){2.0f*prod5.hi, 2.0f*prod5.lo}));
}

// the next point of a search between a and b, where f is fa and fb, after c
static inline float next_guess(float b, float fb, float a, float fa, float c, float fc,
    float close) {
    const float span = c - b, rise = fc - fb, whole = span == 0.0f ? 1.0f : span;
    const float place = (a - b)/whole, whole2 = rise == 0.0f ? 1.0f : rise;
    const float height = (fa - fb)/whole2;
    const float safe = place > height*height && place < 1.0f - ((1.0f - height)*(1.0f - height)) ?
        1.0f : 0.0f;
    const float width = b - a, whole3 = width == 0.0f ? 1.0f : width;
    const float edge = close*fabsf(fabsf(fa) < fabsf(fb) ? a : b)/fabsf(whole3);
    const float edge2 = fminf(0.5f, edge);
    float guess = 0.5f;
    if (safe > 0.0f) {
        const float one = fb - fa, two = fb - fc, three = fa - fc, here = fa/one, there = fc/two;
        const float other = fa/three, last = fb/two;
        guess = here*there + last*other*(c - a)/whole3;
    }
    const float share = fminf(guess, 1.0f - edge2), share2 = fmaxf(edge2, share);
    return a + share2*width;
}

// the angle of the largest stiffness for delays below a period
static inline float early_angle(float at_one, float at_minus_one, float loss, float together,
    float apart, float last) {
    const float t = apart*apart*apart, t2 = together*together*together, t3 = together*together;
    const float t4 = apart*t3, t5 = apart*apart, t6 = 2.0f*loss, t7 = at_minus_one + t6;
    const float t8 = 4.0f*together, t9 = 16.0f*apart, t10 = at_one + t6, t11 = 2.0f*at_one;
    const float t12 = 5.0f*at_minus_one, t13 = -at_one, t14 = 4.0f*loss, t15 = apart*together;
    const float t16 = 16.0f*together, t17 = at_one*last, t18 = apart*t11, t19 = at_one*t5;
    const float k = end_slope(at_minus_one, loss, together, apart, last);
    const float k2 = last*(32.0f*at_minus_one*t3 + last*
        (64.0f*apart*loss + 128.0f*at_minus_one*last - 96.0f*at_minus_one*together) - 96.0f*t5 - t7*
        t9*together) - 4.0f*at_minus_one*t2 + 16.0f*t + 8.0f*t4*(at_minus_one + loss) - t5*t7*t8;
    const float k3 = last*(last*(last*(-192.0f*at_minus_one - 256.0f*at_one - 512.0f*loss) + t16*
        (9.0f*at_one + 16.0f*loss + t12) + t9*(8.0f*at_minus_one + 8.0f*at_one + 18.0f*loss)) -
        32.0f*t15 - 4.0f*t3*(at_minus_one + 7.0f*at_one + 14.0f*loss) - 112.0f*t5) + 8.0f*t + 2.0f*
        t2*(t10 - 2.0f*at_minus_one) + 2.0f*t4*(t12 + t13 + t14) - 2.0f*t5*together*(t7 - t11);
    const float k4 = last*(32.0f*t17*together - 8.0f*together*(t18 + 12.0f*together)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const float k5 = last*(t16*t17 + t8*(t10*together - t18)) + together*
        (t19 - 2.0f*t15*(at_one + loss) + t3*(at_minus_one + t11 + t14));
    float count = 1.0f, found = 0.0f;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if (count > 24.0f || found > 0.0f) { break; }
        const float rises = early_slope(0.041666668f*3.1415927f*count, k, k2, k3, k4, k5);
        const float next_count = rises > 0.0f ? count + 1.0f : count;
        found = rises > 0.0f ? 0.0f : 1.0f; count = next_count;
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
            if ((fa >= 0.0f && fb >= 0.0f) || (fa <= 0.0f && fb <= 0.0f) ||
                fabsf(a - b) <= 2.3841858e-07f*fabsf(fabsf(fa) < fabsf(fb) ? a : b)) { break; }
            const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
            const float value = early_slope(new_, k, k2, k3, k4, k5);
            const float same = (fa > 0.0f && value > 0.0f) || (fa < 0.0f && value < 0.0f) ? 1.0f :
                0.0f;
            const float next_b = same > 0.0f ? b : a, next_fb = same > 0.0f ? fb : fa;
            const float next_c = same > 0.0f ? a : b;
            fc = same > 0.0f ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
        }
        return (fabsf(fa) < fabsf(fb) ? a : b);
    }
    return 3.1415927f;
}

// has the sign of the slope of the boundary's alpha
static inline float boundary_slope(float theta, float l, float at_one, float at_minus_one,
    float loss, float together, float apart, float across) {
    const float t = 2.0f*l + 2.0f, t2 = 0.5f*theta, t3 = next_wave(t, t2).sine, t4 = tanf(t2);
    const float t5 = t4*t4, t6 = 4.0f*t5, t7 = apart*t5, t8 = together - t7, t9 = at_minus_one*t5;
    const float t10 = at_one - t9, t11 = across*loss*t6 + t10*t8, t12 = next_wave(t, t2).cosine;
    const float t13 = 2.0f*loss*t4*t8 - 2.0f*across*t10*t4, t14 = across*across;
    const float t15 = t14*t6 + t8*t8, t16 = loss*loss, t17 = t10*t10 + t16*t6, t18 = t15*t17;
    const float t19 = t5 + 1.0f;
    return (t11*t3 + t12*t13)*(t18*(l + 1.5f) + t19*
        (loss*t15*(at_one + t9) - across*t17*(t7 + together))) - t4*
        (0.5f*t18 + t19*(t15*(2.0f*t16 - at_minus_one*t10) - t17*(2.0f*t14 - apart*t8)))*
        (t11*t12 - t13*t3);
}

// the angle of the largest stiffness for a period and more
static inline float later_angle(float d, float l, float at_one, float at_minus_one, float loss,
    float together, float apart, float across) {
    const float turn_ = 3.1415927f/(d + 1.0f);
    float count = 1.0f, found = 0.0f;
    for (int count_count = 0; count_count < 24; ++count_count) {
        if (count > 24.0f || found > 0.0f) { break; }
        const float rises = boundary_slope(0.041666668f*count*turn_, l, at_one, at_minus_one, loss,
            together, apart, across);
        const float next_count = rises > 0.0f ? count + 1.0f : count;
        found = rises > 0.0f ? 0.0f : 1.0f; count = next_count;
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
            if ((fa >= 0.0f && fb >= 0.0f) || (fa <= 0.0f && fb <= 0.0f) ||
                fabsf(a - b) <= 2.3841858e-07f*fabsf(fabsf(fa) < fabsf(fb) ? a : b)) { break; }
            const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
            const float value = boundary_slope(new_, l, at_one, at_minus_one, loss, together,
                apart, across);
            const float same = (fa > 0.0f && value > 0.0f) || (fa < 0.0f && value < 0.0f) ? 1.0f :
                0.0f;
            const float next_b = same > 0.0f ? b : a, next_fb = same > 0.0f ? fb : fa;
            const float next_c = same > 0.0f ? a : b;
            fc = same > 0.0f ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
        }
        return (fabsf(fa) < fabsf(fb) ? a : b);
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static inline float undelayed_angle(float at_one, float at_minus_one, float loss, float together,
    float apart) {
    const float k = end_slope(at_minus_one, loss, together, apart, 0.0f), t = 2.0f*apart;
    const float t2 = -together, t3 = 2.0f*together, t4 = together*together;
    const float k2 = t3*((apart*apart)*at_one + together*(at_minus_one*(t + t2) + loss*t));
    const float k3 = together*(at_minus_one*t4 + at_one*(t4 + (-apart - t2)*(-apart - t2)) + loss*
        t3*(2.0f*together - apart));
    float above, below;
    if (k2 > 0.0f) {
        const float discriminant = k2*k2 - 4.0f*k*k3, root = sqrtf(fmaxf(0.0f, discriminant));
        above = k2 + root; below = fmaxf(0.0f, -2.0f*k);
    } else {
        const float discriminant = k2*k2 - 4.0f*k*k3;
        if (discriminant < 0.0f) {
            above = 2.0f*k3; below = 0.0f;
        } else {
            const float root = sqrtf(fmaxf(0.0f, discriminant));
            above = 2.0f*k3; below = root - k2;
        }
    }
    return 2.0f*atan2f(sqrtf(above), sqrtf(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static inline float max_stiffness_angle(float gamma, float delta, float d, float l, float part,
    float first, float last, float at_one, float at_minus_one, float loss, float together,
    float apart) {
    if ((d <= 1.0f || sqrtf(gamma)*(d + 1.0f) <= 3.1415927f) && gamma <= 9.8f) {
        const float across = part == 0.0f ? first : first - last;
        const float theta = d == 0.0f ? undelayed_angle(at_one, at_minus_one, loss, together,
            apart) : (d < 1.0f ? early_angle(at_one, at_minus_one, loss, together, apart, last) :
            later_angle(d, l, at_one, at_minus_one, loss, together, apart, across));
        const float t = next_wave(l, theta).sine, t2 = 0.5f*theta, t3 = sinf(t2), t4 = cosf(t2);
        const float t5 = t4*t4, t6 = t3*t3, t7 = 4.0f*t5*t6, t8 = t5*together - apart*t6;
        const float t9 = 1.0f/((across*across)*t7 + t8*t8), t10 = at_one*t5 - at_minus_one*t6;
        const float t11 = 2.0f*loss*t8 - 2.0f*across*t10, t12 = across*loss*t7 + t10*t8;
        const float t13 = t9*next_wave(l, theta).cosine, t14 = -t*t12*t9/sinf(theta) - 0.5f*t11*t13;
        const float stiffness = t*t11*t3*t4*t9 - t12*t13 - 2.0f*t14*t6;
        float good;
        if (delta > 0.0f && gamma > -stiffness && sqrtf(gamma)*(d + 1.0f) <= 3.1415927f) {
            good = 1.0f;
        } else {
            const float inside = 0.9999237f*stiffness - 7.6293945e-05f*gamma;
            const float outside = part == 0.0f ?
                whole_roots(inside, t14, l, first, last, gamma, at_minus_one, loss, together,
                apart) : fractional_roots(inside, t14, l, first, last, gamma, at_minus_one, loss,
                together, apart, first - last);
            if (outside < 0.0f) {
                const float inside2 = 0.99609375f*stiffness - 0.00390625f*gamma;
                const float outside2 = part == 0.0f ?
                    whole_roots(inside2, t14, l, first, last, gamma, at_minus_one, loss, together,
                    apart) : fractional_roots(inside2, t14, l, first, last, gamma, at_minus_one,
                    loss, together, apart, first - last);
                good = stable(outside2, inside2, t14, gamma, delta);
            } else {
                good = stable(outside, inside, t14, gamma, delta);
            }
        }
        if (good > 0.0f) { return theta; }
    }
    return NAN;
}

// the damping that the wall needs at the angle theta, at a fraction of a period
static inline float required_at(float alpha, float beta, float l, float epsilon, float theta) {
    const CosSin cossin = next_wave(l, theta);
    const float lift = fabsf(alpha) + fabsf(beta) < 9.094947e-13f ? 1.2089258e+24f : 1.0f;
    const float stiffness = alpha*lift, damping = beta*lift, half = 0.5f*theta, up = sinf(half);
    const float along = cosf(half), twice = 2.0f*epsilon;
    const Pair diff3 = pair_diff(wide_prod(0.5f*stiffness,
        pair_diff(pair_sum(pair_quot(two_prod(cossin.sine, along), (Pair){up, 0.0f}),
        two_prod(twice, cossin.cosine)), (Pair){cossin.cosine, 0.0f})),
        wide_prod(damping, pair_diff((Pair){cossin.cosine, 0.0f},
        wide_prod(twice, wide_prod(up, pair_sum(two_prod(cossin.sine, along),
        two_prod(cossin.cosine, up)))))));
    const float n = diff3.hi + diff3.lo;
    const float size = (along*along)*(stiffness*stiffness) + (up*up)*
        ((2.0f*damping + stiffness)*(2.0f*damping + stiffness));
    const float extra = epsilon*size*(1.0f - epsilon), root = sqrtf(extra + n*n);
    const float whole = root + fabsf(n) == 0.0f ? 1.0f : root + fabsf(n), more = 0.5f*extra/whole;
    const float rest = diff3.lo + more, whole_need = diff3.hi + rest;
    return (n < 0.0f ? more : whole_need)/lift;
}

// what straight motions need at an angle behind k whole periods
static inline float straight_at(float stiffness, float damping, float k, float angle) {
    const float half = 0.5f*angle;
    return rounded(pair_diff(wide_prod(stiffness,
        pair_quot((Pair){next_wave(2.0f*k, half).sine, 0.0f}, (Pair){2.0f*sinf(half), 0.0f})),
        two_prod(damping, next_wave(k, angle).cosine)));
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
    if (fabsf(x) < 1.0f) { return 1.0f - (x*x)*gap(x); }
    return sinf(x)/x;
}

// the damping that the wall needs at the angle 2 psi
static inline float damping_at(float alpha, float beta, float l, float epsilon, float psi) {
    const float early = 0.5f*alpha*(2.0f*l + 1.0f)*sinc(psi*(2.0f*l + 1.0f))/sinc(psi) - beta*
        next_wave(l, 2.0f*psi).cosine;
    if (epsilon == 0.0f) { return early; }
    const float n = early + epsilon*(0.5f*alpha*(2.0f*l + 3.0f)*sinc(psi*(2.0f*l + 3.0f))/
        sinc(psi) - beta*next_wave(l + 1.0f, 2.0f*psi).cosine - early);
    const float root = sqrtf(epsilon*(1.0f - epsilon)*
        ((alpha*alpha)*(cosf(psi)*cosf(psi)) + ((alpha + 2.0f*beta)*(alpha + 2.0f*beta))*
        (sinf(psi)*sinf(psi))) + n*n);
    return 0.5f*n + 0.5f*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static inline float chord(float k, float x) {
    const float turn_ = x*(k + 1.0f), order = 2.0f*k + 2.0f, along = next_wave(k, x).cosine;
    if (turn_ < 1.5f) {
        const float wave = sinc(0.5f*turn_), inner = 0.5f*(wave*wave) - gap(turn_);
        return order*(along*gap(x) + 0.25f*inner*(order*order));
    }
    return (2.0f*next_wave(k, x).sine - along*order*sinf(x))/(x*x*x);
}

// has the sign of the slope of DampingAt, at a fraction
static inline float rising(float alpha, float beta, float l, float epsilon, float psi) {
    const float t = 2.0f*psi, t2 = 2.0f*alpha/(sinc(psi)*sinc(psi)), t3 = 0.5f*alpha + beta;
    const float t4 = 2.0f*l, t5 = t4 + 2.0f, t6 = t4 + 4.0f;
    const float early = t3*(t5*t5)*sinc(psi*t5) - t2*chord(l, t);
    const float steep = early + epsilon*(-early - t2*chord(l + 1.0f, t) + t3*(t6*t6)*sinc(psi*t6));
    return 2.0f*beta*epsilon*(1.0f - epsilon)*(alpha + beta)*sinc(2.0f*psi) + steep*
        damping_at(alpha, beta, l, epsilon, psi);
}

// has the sign of the slope of DampingAt, up to the angle in phase
static inline float steepness(float alpha, float beta, float l, float epsilon, float psi) {
    if (epsilon == 0.0f) {
        const float t = 2.0f*l + 2.0f;
        return (t*t)*(0.5f*alpha + beta)*sinc(psi*t) - 2.0f*alpha*chord(l, 2.0f*psi)/
            (sinc(psi)*sinc(psi));
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
    const float size = fabsf(alpha) + fabsf(beta), whole = size == 0.0f ? 1.0f : size;
    const float stiffness = alpha/whole, damping = beta/whole, low = 0.0f;
    const float above = steepness(stiffness, damping, l, epsilon, low);
    if (above <= 0.0f) { return low; }
    const float high = 3.1415925f/(2.0f*l + 2.0f);
    const float below = steepness(stiffness, damping, l, epsilon, high);
    if (below >= 0.0f) { return high; }
    float b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if ((fa >= 0.0f && fb >= 0.0f) || (fa <= 0.0f && fb <= 0.0f) ||
            fabsf(a - b) <= 7.6293945e-06f*fabsf(fabsf(fa) < fabsf(fb) ? a : b)) { break; }
        const float new_ = next_guess(b, fb, a, fa, c, fc, 7.6293945e-06f);
        const float value = steepness(stiffness, damping, l, epsilon, new_);
        const float same = (fa > 0.0f && value > 0.0f) || (fa < 0.0f && value < 0.0f) ? 1.0f : 0.0f;
        const float next_b = same > 0.0f ? b : a, next_fb = same > 0.0f ? fb : fa;
        const float next_c = same > 0.0f ? a : b;
        fc = same > 0.0f ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (fabsf(fa) < fabsf(fb) ? a : b);
}

// the damping that the wall needs at its worst angle
static inline float largest_required_damping(float alpha, float beta, float d) {
    if (alpha < 0.0f) { return INFINITY; }
    const float whole = floorf(d), part = d - whole;
    const float lift = fabsf(alpha) + fabsf(beta) < 9.094947e-13f ? 1.2089258e+24f : 1.0f;
    const float stiffness = alpha*lift, damping = beta*lift;
    return damping_at(stiffness, damping, whole, part,
        worst_angle(stiffness, damping, whole, part))/lift;
}

// early + share (late - early)
static inline float between(float share, float early, float late) {
    const float more = late - early;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static inline float lead(float theta, float l, float epsilon) {
    if (theta*(l + 1.0f) < 4.0f) {
        const float early = next_wave(l, theta).sine, late = next_wave(l + 1.0f, theta).sine;
        return early + epsilon*(late - early);
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
    return (order*sinf(x) - 2.0f*next_wave(k, x).cosine*next_wave(k, x).sine)/(x*x*x);
}

// what straight motions need at a whole delay of k periods
static inline float straight(float stiffness, float damping, float k, float angle) {
    const float order = 2.0f*k + 1.0f;
    return rounded(pair_diff(wide_prod(stiffness,
        pair_quot(two_prod(order, sinc(angle*order)), (Pair){2.0f*sinc(angle), 0.0f})),
        two_prod(damping, next_wave(k, 2.0f*angle).cosine)));
}

// has the sign of minus the slope of what the wall phi needs
static inline float turning(float phi, float l, float epsilon, float wave, float wave2,
    float wave3, float wave4, float wave5, float wave6, float wave7, float wave8, float wave9,
    float wave10, float wave11, float wave12) {
    const float t = sinf(phi), t2 = l + 1.0f, t3 = cosf(phi), t4 = t3/t2, t5 = 0.5f*t4, t6 = t - t5;
    const float t7 = epsilon*(1.0f - epsilon), t8 = 2.0f*l, t9 = 2.0f*t4/(wave7*wave7);
    const float t10 = t*wave10*((t8 + 2.0f)*(t8 + 2.0f)) - t9*wave3, t11 = t6*wave5;
    const float t12 = 1.0f/wave7, t13 = wave9*(t8 + 1.0f), t14 = t12*t5, t15 = t13*t14;
    const float t16 = epsilon*(t11 + t14*wave11*(t8 + 3.0f) - t15 - t6*wave6);
    return -2.0f*t6*t7*wave8*(t + t5) - (epsilon*
        (t*wave12*((t8 + 4.0f)*(t8 + 4.0f)) - t10 - t9*wave4) + t10)*
        (0.25f*t12*t13*t4 - 0.5f*t11 + 0.5f*t16 + 0.5f*
        sqrtf(t7*(4.0f*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2)) + (t15 - t11 + t16)*
        (t15 - t11 + t16)));
}

// the wall whose worst angle is 2 psi, as an angle
static inline float turn(float psi, float l, float epsilon) {
    const float wave = sinf(psi), wave2 = cosf(psi), wave3 = chord(l, 2.0f*psi);
    const float wave4 = chord(l + 1.0f, 2.0f*psi), wave5 = next_wave(l, 2.0f*psi).cosine;
    const float wave6 = next_wave(l + 1.0f, 2.0f*psi).cosine, wave7 = sinc(psi);
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
        if ((fa >= 0.0f && fb >= 0.0f) || (fa <= 0.0f && fb <= 0.0f) ||
            fabsf(a - b) <= 2.3841858e-07f*fabsf(fabsf(fa) < fabsf(fb) ? a : b)) { break; }
        const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
        const float value = turning(new_, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6,
            wave7, wave8, wave9, wave10, wave11, wave12);
        const float same = (fa > 0.0f && value > 0.0f) || (fa < 0.0f && value < 0.0f) ? 1.0f : 0.0f;
        const float next_b = same > 0.0f ? b : a, next_fb = same > 0.0f ? fb : fa;
        const float next_c = same > 0.0f ? a : b;
        fc = same > 0.0f ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (fabsf(fa) < fabsf(fb) ? a : b);
}

// the wall whose worst angle is theta, as an angle, or NaN
static inline float touching(float theta, float l, float epsilon) {
    const float found = turn(0.5f*theta, l, epsilon);
    if (found < 0.5f*3.1415927f) { return found; }
    return NAN;
}

// whether a larger angle allows less stiffness, at a fraction
static inline float passive_slope(float theta, float l, float epsilon) {
    const CosSin cossin = next_wave(l, theta), cossin2 = next_wave(l + 1.0f, theta);
    const float up = epsilon*(cossin2.sine - cossin.sine) + cossin.sine;
    const float along = cossin.cosine + epsilon*(cossin2.cosine - cossin.cosine);
    return (1.0f - up)*cosf(theta) + (along*(epsilon + l + 1.0f) - epsilon*(1.0f - epsilon)*
        (cossin.cosine - cossin2.cosine))*sinf(theta);
}

// the worst angle of the stiffest passive wall, at a fraction
static inline float passive_angle(float l, float epsilon) {
    const float low = 0.0f, above = passive_slope(low, l, epsilon);
    if (above <= 0.0f) { return low; }
    const float high = 3.1415927f/(epsilon + l + 1.0f), below = passive_slope(high, l, epsilon);
    if (below >= 0.0f) { return high; }
    float b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if ((fa >= 0.0f && fb >= 0.0f) || (fa <= 0.0f && fb <= 0.0f) ||
            fabsf(a - b) <= 2.3841858e-07f*fabsf(fabsf(fa) < fabsf(fb) ? a : b)) { break; }
        const float new_ = next_guess(b, fb, a, fa, c, fc, 2.3841858e-07f);
        const float value = passive_slope(new_, l, epsilon);
        const float same = (fa > 0.0f && value > 0.0f) || (fa < 0.0f && value < 0.0f) ? 1.0f : 0.0f;
        const float next_b = same > 0.0f ? b : a, next_fb = same > 0.0f ? fb : fa;
        const float next_c = same > 0.0f ? a : b;
        fc = same > 0.0f ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (fabsf(fa) < fabsf(fb) ? a : b);
}

void haptic_single_discretize(float gamma, float delta, float *n1_out, float *n0_out, float *a_out,
    float *e_out) {
    if (!(delta >= 0.0f && delta <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f)) {
        *n1_out = NAN; *n0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    const Device device = device_n0_n1_trace(gamma, delta);
    *n1_out = device.n1; *n0_out = device.n0; *a_out = device.trace; *e_out = expf(-delta);
}

void haptic_single_discretize_fractional(float gamma, float delta, float epsilon, float *m2_out,
    float *m1_out, float *m0_out, float *a_out, float *e_out) {
    if (!(delta >= 0.0f && delta <= 1e+08f && epsilon >= 0.0f && epsilon < 1.0f && gamma >= 0.0f &&
        gamma <= 1e+08f)) {
        *m2_out = NAN; *m1_out = NAN; *m0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    const Device2 device = device_together_trace(gamma, delta);
    const float t0 = 1.0f - epsilon, t1 = t0*t0, t2 = delta*t0, n1 = plant_n1(gamma*t1, t2);
    const float t3 = n1*t1, t4 = epsilon*epsilon, n0 = plant_n0(gamma*t4, delta*epsilon);
    const float t5 = n0*t4*expf(-t2);
    *m2_out = t3; *m1_out = device.together - t3 - t5; *m0_out = t5; *a_out = device.trace;
    *e_out = expf(-delta);
}

bool haptic_single_is_stable(float alpha, float beta, float gamma, float delta, float d) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && fabsf(alpha) <= 1e+08f &&
        fabsf(beta) <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f)) {
        return false;
    }
    const Device3 device = device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta);
    const float whole = floorf(d), part = d - whole, t1 = delta*decay(delta);
    const float t3 = delta*device.n_gap;
    if (part == 0.0f) {
        return stable(whole_roots(alpha, beta, d, device.n1, device.n0, gamma, device.at_minus_one,
            t1, device.together, t3), alpha, beta, gamma, delta) != 0.0f;
    }
    const Delayed delayed = late_device(gamma, delta, part);
    return stable(fractional_roots(alpha, beta, whole, delayed.m2, delayed.m0, gamma,
        device.at_minus_one, t1, device.together, delayed.apart, 0.5f*device.kick*
        (delta*delayed.m2 + 2.0f*delayed.kicked) + 0.5f*delayed.m2*(gamma*device.together + t1) -
        0.5f*device.together + 0.5f*t3), alpha, beta, gamma, delta) != 0.0f;
}

float haptic_single_unstable_roots(float alpha, float beta, float gamma, float delta, float d) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && fabsf(alpha) <= 1e+08f &&
        fabsf(beta) <= 1e+08f && gamma >= 0.0f && gamma <= 1e+08f)) {
        return -1.0f;
    }
    const Device3 device = device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta);
    const float whole = floorf(d), part = d - whole, t1 = delta*decay(delta);
    const float t3 = delta*device.n_gap;
    if (part == 0.0f) {
        return whole_roots(alpha, beta, d, device.n1, device.n0, gamma, device.at_minus_one, t1,
            device.together, t3);
    }
    const Delayed delayed = late_device(gamma, delta, part);
    return fractional_roots(alpha, beta, whole, delayed.m2, delayed.m0, gamma, device.at_minus_one,
        t1, device.together, delayed.apart, 0.5f*device.kick*
        (delta*delayed.m2 + 2.0f*delayed.kicked) + 0.5f*delayed.m2*(gamma*device.together + t1) -
        0.5f*device.together + 0.5f*t3);
}

void haptic_single_stability_boundary(float theta, float gamma, float delta, float d,
    float *alpha_out, float *beta_out) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && gamma >= 0.0f &&
        gamma <= 1e+08f && theta > 0.0f && theta <= 3.1415925f)) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const Device5 device = device_at_minus_one_kick_together_n_gap(gamma, delta);
    const float whole = floorf(d);
    const CosSin cossin = next_wave(whole, theta);
    const float part = d - whole, t2 = 0.5f*theta, t4 = gamma*device.together;
    const float t6 = delta*decay(delta), t7 = delta*device.n_gap;
    float t10, t12;
    if (part == 0.0f) {
        t10 = t7; t12 = device.together + t7;
    } else {
        const Delayed delayed = late_device(gamma, delta, part);
        t10 = delayed.apart;
        t12 = device.kick*(delta*delayed.m2 + 2.0f*delayed.kicked) + delayed.m2*(t4 + t6) -
            device.together + t7;
    }
    const Response response = ahead_in_phase(t2, t4, device.at_minus_one, t6, device.together, t10,
        t12);
    const float t16 = response.ahead*cossin.cosine + response.in_phase*cossin.sine;
    *alpha_out = response.ahead*cossin.sine - cossin.cosine*response.in_phase + t16*tanf(t2);
    *beta_out = -t16/sinf(theta);
}

void haptic_single_max_stable_stiffness(float gamma, float delta, float d, float *alpha_out,
    float *beta_out, float *theta_out) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && gamma >= 0.0f &&
        gamma <= 1e+08f)) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const Device6 device = device_at_minus_one_together_n_gap_n0_n1(gamma, delta);
    const float whole = floorf(d), part = d - whole, t1 = gamma*device.together;
    const float t3 = delta*decay(delta), t16 = 2.0f*t3;
    if (part == 0.0f) {
        const float t4 = delta*device.n_gap;
        const float t5 = max_stiffness_angle(gamma, delta, d, d, 0.0f, device.n1, device.n0, t1,
            device.at_minus_one, t3, device.together, t4);
        const CosSin cossin = next_wave(d, t5);
        const float t7 = 0.5f*t5, t8 = sinf(t7), t9 = cosf(t7), t10 = device.together + t4;
        const float t11 = t9*t9, t12 = t8*t8, t13 = t11*t12, t14 = device.together*t11 - t12*t4;
        const float t15 = 1.0f/((t10*t10)*t13 + t14*t14), t17 = t1*t11 - device.at_minus_one*t12;
        const float t18 = t14*t16 - t10*t17, t19 = t10*t13*t16 + t14*t17, t20 = cossin.cosine*t15;
        const float t21 = -cossin.sine*t15*t19/sinf(t5) - 0.5f*t18*t20;
        *alpha_out = cossin.sine*t15*t18*t8*t9 - 2.0f*t12*t21 - t19*t20; *beta_out = t21;
        *theta_out = t5; return;
    }
    const Delayed delayed = late_device(gamma, delta, part);
    const float t27 = max_stiffness_angle(gamma, delta, d, whole, part, delayed.m2, delayed.m0, t1,
        device.at_minus_one, t3, device.together, delayed.apart);
    const CosSin cossin2 = next_wave(whole, t27);
    const float t28 = 0.5f*t27, t29 = sinf(t28), t30 = cosf(t28), t32 = t30*t30, t33 = t29*t29;
    const float t34 = device.together*t32 - delayed.apart*t33;
    const float t35 = 2.0f*delayed.m2 - 2.0f*delayed.m0, t36 = t32*t33;
    const float t37 = 1.0f/(t34*t34 + (t35*t35)*t36), t38 = t1*t32 - device.at_minus_one*t33;
    const float t39 = t16*t34 - t35*t38, t40 = t16*t35*t36 + t34*t38, t41 = cossin2.cosine*t37;
    const float t42 = -cossin2.sine*t37*t40/sinf(t27) - 0.5f*t39*t41;
    *alpha_out = cossin2.sine*t29*t30*t37*t39 - 2.0f*t33*t42 - t40*t41; *beta_out = t42;
    *theta_out = t27;
}

float haptic_single_passivity_margin_at(float theta, float alpha, float beta, float delta,
    float d) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && fabsf(alpha) <= 1e+08f &&
        fabsf(beta) <= 1e+08f && theta > 0.0f && theta <= 3.1415925f)) {
        return NAN;
    }
    const float whole = floorf(d), part = d - whole;
    if (part == 0.0f) { return delta - straight_at(alpha, beta, d, theta); }
    return delta - required_at(alpha, beta, whole, part, theta);
}

float haptic_single_passivity_margin(float alpha, float beta, float delta, float d) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && fabsf(alpha) <= 1e+08f &&
        fabsf(beta) <= 1e+08f)) {
        return NAN;
    }
    return delta - largest_required_damping(alpha, beta, d);
}

void haptic_single_passivity_boundary(float theta, float delta, float d, float *alpha_out,
    float *beta_out) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && theta > 0.0f &&
        theta <= 3.1415925f)) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const float whole = floorf(d), part = d - whole, t2 = 0.5f*theta;
    if (part == 0.0f) {
        const float t0 = lead(theta, d, 0.0f), t1 = delta/spread(d, theta), t15 = sinc(t2);
        const float sine = next_wave(d, theta).sine, t3 = sine*(t15*t15)*(d + 1.0f)/theta;
        *alpha_out = rated(t0, 2.0f*t1*t3); *beta_out = rated(t0, t1*(chord(d, theta) - t3));
        return;
    }
    const float t6 = lead(theta, whole, part), t7 = whole + 1.0f, t8 = touching(theta, whole, part);
    const float t9 = cosf(t8), t10 = t9/t7, t11 = sinf(t8), t12 = t11 - 0.5f*t10;
    const float t13 = between(part, straight(t10, t12, whole, t2), straight(t10, t12, t7, t2));
    const float t16 = sinf(t2), t17 = cosf(t2);
    const float t14 = delta/(0.5f*t13 + 0.5f*
        sqrtf(part*(1.0f - part)*(4.0f*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7)) + t13*t13));
    *alpha_out = rated(t6, t10*t14); *beta_out = rated(t6, t12*t14);
}

void haptic_single_max_passive_stiffness(float delta, float d, float *alpha_out, float *beta_out,
    float *theta_out) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f)) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const float whole = floorf(d), part = d - whole, t3 = 2.0f*delta;
    if (part == 0.0f) {
        const float t0 = d + 1.0f, t1 = 3.1415927f/t0, t2 = tanf(0.25f*t1), t4 = 0.5f*t1;
        *alpha_out = t2*t3; *beta_out = delta*(1.0f/(t0*sinf(t4)) - t2); *theta_out = t4; return;
    }
    const float t7 = passive_angle(whole, part);
    const CosSin cossin = next_wave(whole, t7);
    const float t9 = whole + 1.0f;
    const CosSin cossin2 = next_wave(t9, t7);
    const float t10 = cossin.cosine + part*(cossin2.cosine - cossin.cosine), t12 = 0.5f*t7;
    const float t13 = sinf(t12), t14 = t13*t13, t15 = 2.0f*whole, t16 = t15 + 2.0f;
    const float sine_2 = next_wave(t16, t12).sine, t17 = 2.0f*sine_2*t13;
    const float t18 = (t10*t17 + t14*(4.0f*part + 4.0f*whole + 4.0f))/
        (t10*cosf(t7) + (part + t9)*(part*(cossin2.sine - cossin.sine) + cossin.sine + 1.0f)*
        sinf(t7));
    const float t19 = 2.0f*part;
    *alpha_out = t18*t3; *beta_out = delta*(t17 - t18*(t14*(t15 + t19) + 1.0f))/(t14*(t16 + t19));
    *theta_out = t7;
}

float haptic_single_linear_limit(float beta, float delta, float d) {
    if (!(d >= 0.0f && d <= 1e+06f && delta >= 0.0f && delta <= 1e+08f && fabsf(beta) <= 1e+08f)) {
        return NAN;
    }
    return (beta + delta)/(d + 0.5f);
}

void haptic_single_late_device(float gamma, float delta, float part, float *apart_out,
    float *m2_out, float *kicked_out, float *m0_out) {
    const Delayed found = late_device(gamma, delta, part);
    *apart_out = found.apart;
    *m2_out = found.m2;
    *kicked_out = found.kicked;
    *m0_out = found.m0;
}
