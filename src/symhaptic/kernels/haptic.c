/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#include <math.h>
#include <stdbool.h>

/* Compiled once in each precision: what is a number, an operation or a name in it. */
#ifdef SINGLE
#define REAL float
#define NAME(name) haptic_single_##name
#define M(operation) operation##f
#define R(number) number##f
#define PICK(in_double, in_single) in_single
#else
#define REAL double
#define NAME(name) haptic_##name
#define M(operation) operation
#define R(number) number
#define PICK(in_double, in_single) in_double
#endif

#ifdef _MSC_VER
#define EACH_THREAD __declspec(thread)
#else
#define EACH_THREAD __thread
#endif

/* What is made of the device alone: that of the call before is kept, as most arrays have one
 * device. -0.0 is 0.0 here, as it is for the comparison. */
#define KEEP(Kind, name) \
    static inline Kind name(REAL gamma, REAL delta) { \
        static EACH_THREAD REAL last[2] = {NAN, NAN}; \
        static EACH_THREAD Kind kept; \
        if (last[0] == gamma && last[1] == delta) return kept; \
        last[0] = gamma + R(0.0); last[1] = delta + R(0.0); \
        return kept = name##_anew(last[0], last[1]); \
    }
#define KEEP_PART(Kind, name) \
    static inline Kind name(REAL gamma, REAL delta, REAL part) { \
        static EACH_THREAD REAL last[3] = {NAN, NAN, NAN}; \
        static EACH_THREAD Kind kept; \
        if (last[0] == gamma && last[1] == delta && last[2] == part) return kept; \
        last[0] = gamma + R(0.0); last[1] = delta + R(0.0); last[2] = part + R(0.0); \
        return kept = name##_anew(last[0], last[1], last[2]); \
    }

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) || \
    (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "this file needs IEEE arithmetic: compile it without -ffast-math, -Ofast and /fp:fast"
#endif
#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "this file needs IEEE arithmetic: compile it with -mfpmath=sse or /arch:SSE2"
#endif

#ifndef SINGLE
// 1/n!
static const double inverse_factorial[] =
    {1.0, 1.0, 0.5, 0.16666666666666666, 0.041666666666666664, 0.008333333333333333,
    0.001388888888888889, 0.0001984126984126984, 2.48015873015873e-05, 2.7557319223985893e-06,
    2.755731922398589e-07, 2.505210838544172e-08, 2.08767569878681e-09, 1.6059043836821613e-10,
    1.1470745597729725e-11, 7.647163731819816e-13, 4.779477332387385e-14, 2.8114572543455206e-15,
    1.5619206968586225e-16, 8.22063524662433e-18, 4.110317623312165e-19, 1.9572941063391263e-20,
    8.896791392450574e-22, 3.868170170630684e-23, 1.6117375710961184e-24, 6.446950284384474e-26,
    2.4795962632247976e-27, 9.183689863795546e-29, 3.279889237069838e-30};
#else
// 1/n!
static const float inverse_factorial[] =
    {1.0f, 1.0f, 0.5f, 0.16666667f, 0.041666668f, 0.008333334f, 0.0013888889f, 0.0001984127f,
    2.4801588e-05f, 2.7557319e-06f, 2.755732e-07f, 2.5052108e-08f, 2.0876756e-09f, 1.6059044e-10f,
    1.1470745e-11f, 7.6471636e-13f, 4.7794773e-14f, 2.8114574e-15f, 1.5619207e-16f, 8.220635e-18f,
    4.1103176e-19f};
#endif

typedef struct { REAL hi, lo; } Pair; // and what its float misses
typedef struct { Pair fall, mean; } Fading;
typedef struct { Pair p, q; } Poles;
typedef struct { Pair p, slow, mean, ratio, far; } Creeping;
typedef struct { REAL half; Pair w; REAL root, reach; } Motion;
typedef struct { Pair even, odd; } Wave;
typedef struct { REAL near, risen, sunk, moved; } Turns;
typedef struct { REAL envelope; Pair even, wave; REAL near, risen, sunk, moved; } Swinging;
typedef struct { REAL n0, n1, trace; } Device;
typedef struct { REAL together, trace; } Device2;
typedef struct { REAL at_minus_one, kick, together, n_gap, n0, n1; } Device3;
typedef struct { REAL halves, rest, size, per, off, blur, slope, fast, bend, turn, spread; } Part;
typedef struct { Pair kick; REAL n_gap, n0, n1; } Device4;
typedef struct { REAL apart, m2, kicked, m0; } Delayed;
typedef struct { REAL at, still, away, loose, free, there; } Point;
typedef struct { REAL low, high; } Roots;
typedef struct { REAL ahead, in_phase; } Response;
typedef struct { REAL at_minus_one, kick, together, n_gap; } Device5;
typedef struct { REAL cosine, sine; } CosSin;
typedef struct { REAL at_minus_one, together, n_gap, n0, n1; } Device6;
typedef struct { REAL alpha, slope, far, d, n1, loss, together, apart, apart_off, n1_off, a_off,
    center, beyond; } Loop;

// ((1 - exp(-x))/x - 1 + x/2)/x^2
static inline REAL decay_series(REAL x) {
    const REAL square = x*x;
    REAL one = R(0.0), two = R(0.0);
    for (int n = PICK(19, 12); n >= 4; n -= 1) {
        const REAL number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return square*two - one*x + PICK(0.16666666666666666, 0.16666667f);
}

// x + y and what it misses, for |x| >= |y|
static inline Pair fast_two_sum(REAL x, REAL y) {
    const REAL total = x + y, back = total - x;
    return (Pair){total, y - back};
}

// 1 - x of a pair, for |x| <= 1
static inline Pair one_minus(Pair x) {
    const Pair total = fast_two_sum(R(1.0), -x.hi);
    return (Pair){total.hi, total.lo - x.lo};
}

// x y of a float and a pair
static inline Pair wide_prod(REAL x, Pair y) {
    return (Pair){x*y.hi, x*y.lo + M(fma)(x, y.hi, -(x*y.hi))};
}

// x y of pairs
static inline Pair pair_prod(Pair x, Pair y) {
    const Pair prod = wide_prod(x.hi, y);
    return (Pair){prod.hi, prod.lo + x.lo*y.hi};
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss, for a rate up to 3/4
static inline Fading brief_fading(Pair rate) {
    const Pair total = fast_two_sum(R(1.0), -R(0.5)*rate.hi);
    const Pair total2 = fast_two_sum(total.hi, (rate.hi*rate.hi)*decay_series(rate.hi));
    const REAL bent = rate.lo*(R(0.125)*(rate.hi*rate.hi) - PICK(0.3333333333333333, 0.33333334f)*
        rate.hi + R(0.5));
    const REAL mean_low = total.lo - bent + total2.lo;
    return (Fading){one_minus(pair_prod(rate, (Pair){total2.hi, mean_low})), {total2.hi, mean_low}};
}

// x/y of pairs
static inline Pair pair_quot(Pair x, Pair y) {
    const REAL total = x.hi/y.hi, left = x.hi - total*y.hi;
    const REAL left2 = left - M(fma)(total, y.hi, -(total*y.hi)), rest = x.lo - total*y.lo;
    const REAL left3 = left2 + rest;
    return (Pair){total, left3/y.hi};
}

// exp(-rate), (1 - exp(-rate))/rate and what they miss
static inline Fading fading_pair(Pair rate) {
    if (rate.hi < R(0.75)) { return brief_fading(rate); }
    const REAL sunk = M(exp)(-rate.hi), sunk_low = -rate.lo*sunk;
    return (Fading){{sunk, sunk_low}, pair_quot(one_minus((Pair){sunk, sunk_low}), rate)};
}

#ifndef SINGLE
// what the root of |square + square_low| misses
static inline double root_miss(Pair square, double root) {
    const double sign_low = square.hi < 0.0 ? -square.lo : square.lo;
    const double left = fabs(square.hi) - (root*root), left2 = left - fma(root, root, -(root*root));
    const double left3 = left2 + sign_low, whole = root == 0.0 ? 1.0 : root;
    return 0.5*left3/whole;
}
#else
// what the root of |square + square_low| misses
static inline float root_miss(Pair square, float root) {
    const float sign_low = square.hi < 0.0f ? -square.lo : square.lo;
    const float left = fabsf(square.hi) - (root*root);
    const float left2 = left - fmaf(root, root, -(root*root)), left3 = left2 + sign_low;
    const float whole = root == 0.0f ? 1.0f : root;
    return 0.5f*left3/whole;
}
#endif

// the poles p = half + root and q = gamma/p
static inline Poles real_poles(const Motion *motion, REAL gamma) {
    const Pair total = fast_two_sum(motion->half, motion->root);
    const REAL p_low = total.lo + root_miss(motion->w, motion->root);
    const REAL whole = total.hi == R(0.0) ? R(1.0) : total.hi;
    return (Poles){{whole, p_low}, pair_quot((Pair){gamma, R(0.0)}, (Pair){whole, p_low})};
}

// of an overdamped device the pole p, exp and mean of the other one and of their distance
static inline Creeping creeping_device(const Motion *motion, REAL gamma) {
    const Poles poles = real_poles(motion, gamma);
    const Fading fading = fading_pair(poles.q);
    const REAL root_low = root_miss(motion->w, motion->root);
    const Fading fading2 = fading_pair((Pair){R(2.0)*motion->root, R(2.0)*root_low});
    return (Creeping){poles.p, fading.fall, fading.mean, fading2.fall, fading2.mean};
}

// x - y and what it misses
static inline Pair two_diff(REAL x, REAL y) {
    const REAL total = x - y, back = total - x, rest = total - back, one = x - rest;
    const REAL two = -back - y;
    return (Pair){total, one + two};
}

// x y and what it misses
static inline Pair two_prod(REAL x, REAL y) { return (Pair){x*y, M(fma)(x, y, -(x*y))}; }

// half = delta/2, w = half^2 - gamma, its root and the size of the poles
static inline Motion device_motion(REAL gamma, REAL delta) {
    const REAL half = R(0.5)*delta;
    const Pair prod = two_prod(half, half), diff = two_diff(prod.hi, gamma);
    const Pair total = fast_two_sum(diff.hi, diff.lo + prod.lo);
    const REAL root = M(sqrt)(M(fabs)(total.hi));
    return (Motion){half, total, root, total.hi < R(0.0) ? R(0.25)*gamma :
        PICK(0.4444444444444444, 0.44444445f)*half +
        PICK(0.4444444444444444, 0.44444445f)*root};
}

// 1 + x of a pair, for |x| <= 1
static inline Pair one_plus(Pair x) {
    const Pair total = fast_two_sum(R(1.0), x.hi);
    return (Pair){total.hi, total.lo + x.lo};
}

// x - y of pairs
static inline Pair pair_diff(Pair x, Pair y) {
    const Pair diff = two_diff(x.hi, y.hi);
    const REAL lost = diff.lo + x.lo;
    return (Pair){diff.hi, lost - y.lo};
}

// x^2 of a pair
static inline Pair pair_square(Pair x) { return wide_prod(x.hi, (Pair){x.hi, R(2.0)*x.lo}); }

// number + delta one - gamma two and what it misses, of pairs
static inline Pair plant_n0_term(REAL gamma, REAL delta, Pair one, Pair two, REAL number) {
    return pair_diff(pair_diff(wide_prod(delta, one), wide_prod(gamma, two)),
        (Pair){-number, R(0.0)});
}

// the float of a pair
static inline REAL rounded(Pair x) { return x.hi + x.lo; }

// divided difference of exp at 0, p and q, less 1/2
static inline REAL plant_n0_series(REAL gamma, REAL delta) {
    REAL one = R(0.0), two = R(0.0);
    for (int n = (R(0.5)*delta < R(0.0625) && M(fabs)(gamma) < R(0.00390625) ? PICK(13, 9) :
        PICK(28, 20)); n >= 6; n -= 1) {
        const REAL number = inverse_factorial[n], next_one = delta*one - gamma*two + number;
        two = one; one = next_one;
    }
    const Pair one2 = plant_n0_term(gamma, delta, (Pair){one, R(0.0)}, (Pair){two, R(0.0)},
        PICK(0.008333333333333333, 0.008333334f));
    const Pair one3 = plant_n0_term(gamma, delta, one2, (Pair){one, R(0.0)},
        PICK(0.041666666666666664, 0.041666668f));
    return rounded(plant_n0_term(gamma, delta,
        plant_n0_term(gamma, delta, one3, one2, PICK(0.16666666666666666, 0.16666667f)), one3,
            R(0.0)));
}

// (fall + fall_low) (y + z), rounded once
static inline REAL scaled_sum(Pair fall, REAL y, REAL z) {
    return rounded(pair_prod(fall, two_diff(y, -z)));
}

// n0 of a device with slow poles
static inline REAL plant_n0_near(Pair decayed, REAL gamma, REAL delta) {
    return scaled_sum(pair_square(decayed), plant_n0_series(gamma, delta), R(0.5));
}

// n0 of an overdamped device
static inline REAL plant_n0_creep(const Motion *motion, const Creeping *creeping, Pair decayed,
    REAL gamma, REAL delta) {
    if (motion->reach < R(0.5625)) { return plant_n0_near(decayed, gamma, delta); }
    return rounded(pair_prod(creeping->slow,
        pair_quot(pair_diff(creeping->far, pair_prod(creeping->ratio, creeping->mean)),
        creeping->p)));
}

// x + y of pairs
static inline Pair pair_sum(Pair x, Pair y) {
    const Pair diff = two_diff(x.hi, -y.hi);
    const REAL lost = diff.lo + x.lo;
    return (Pair){diff.hi, lost + y.lo};
}

// n0 of an oscillating device
static inline REAL plant_n0_swing(const Motion *motion, const Swinging *swinging, Pair decayed,
    REAL gamma) {
    if (motion->reach < R(0.5625)) { return plant_n0_near(decayed, gamma, R(2.0)*motion->half); }
    if (swinging->near > R(0.0)) { return swinging->sunk; }
    return rounded(pair_quot(wide_prod(swinging->envelope,
        pair_sum(pair_diff(wide_prod(motion->half, swinging->wave), swinging->even),
        (Pair){swinging->envelope, R(0.0)})), (Pair){gamma, R(0.0)}));
}

// divided difference of exp at h and +-sqrt(w), less 1/2
static inline REAL plant_n1_series(REAL h, REAL w) {
    REAL total = R(0.0), one = R(0.0), two = R(0.0);
    for (int n = (M(fabs)(w) < R(0.00390625) && h < R(0.0625) ? PICK(13, 9) :
        PICK(28, 20)); n >= 3; n -= 1) {
        const REAL number = inverse_factorial[n], even = number + two*w;
        total = even + h*total; two = one; one = even;
    }
    return h*total + two*w;
}

// n1 of an overdamped device
static inline REAL plant_n1_creep(const Motion *motion, const Creeping *creeping, Pair decayed) {
    if (motion->reach < R(0.5625)) {
        return scaled_sum(decayed, plant_n1_series(motion->half, motion->w.hi), R(0.5));
    }
    return rounded(pair_quot(pair_diff(creeping->mean, pair_prod(creeping->slow, creeping->far)),
        creeping->p));
}

// n1 of an oscillating device
static inline REAL plant_n1_swing(const Motion *motion, const Swinging *swinging, Pair decayed,
    REAL gamma) {
    if (motion->reach < R(0.5625)) {
        return scaled_sum(decayed, plant_n1_series(motion->half, motion->w.hi), R(0.5));
    }
    if (swinging->near > R(0.0)) { return swinging->risen; }
    return rounded(pair_quot(one_minus(wide_prod(swinging->envelope,
        pair_sum(swinging->even, wide_prod(motion->half, swinging->wave)))),
            (Pair){gamma, R(0.0)}));
}

// exp(-half) of a device with slow poles, and what it misses
static inline Pair slow_fade(const Motion *motion) {
    if (motion->reach < R(0.5625)) {
        return pair_square(brief_fading((Pair){R(0.5)*motion->half, R(0.0)}).fall);
    }
    return (Pair){R(0.0), R(0.0)};
}

// (cosh(sqrt(w)) - 1 - w/2)/w^2
static inline REAL cos_series(REAL w) {
    const REAL square = w*w;
    REAL one = R(0.0), two = R(0.0);
    for (int n = PICK(22, 14); n >= 6; n -= 2) {
        const REAL number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + PICK(0.041666666666666664, 0.041666668f);
}

// (sinh(sqrt(w))/sqrt(w) - 1)/w
static inline REAL sin_series(REAL w) {
    const REAL square = w*w;
    REAL one = R(0.0), two = R(0.0);
    for (int n = PICK(21, 13); n >= 5; n -= 2) {
        const REAL number = inverse_factorial[n], both = number + square*two;
        two = one; one = both;
    }
    return one*w + square*two + PICK(0.16666666666666666, 0.16666667f);
}

// cos(angle), sin(angle)/angle and what they miss, where -square is the square of the angle
static inline Wave waving_pair(Pair square, REAL angle) {
    if (square.hi > -R(1.5)) {
        const Pair total = fast_two_sum(R(1.0), R(0.5)*square.hi);
        const Pair total2 = fast_two_sum(total.hi, (square.hi*square.hi)*cos_series(square.hi));
        const REAL both = total.lo + total2.lo;
        return (Wave){{total2.hi, both + R(0.5)*square.lo},
            one_plus((Pair){square.hi*sin_series(square.hi), PICK(0.16666666666666666, 0.16666667f)*
                square.lo})};
    }
    const REAL angle_low = root_miss(square, angle), sine = M(sin)(angle), cosine = M(cos)(angle);
    return (Wave){{cosine, -angle_low*sine},
        pair_quot((Pair){sine, angle_low*cosine}, (Pair){angle, angle_low})};
}

#ifndef SINGLE
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
#else
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
#endif

// exp(-half), cos(root), sin(root)/root and nearby turns of an oscillating device
static inline Swinging swinging_device(const Motion *motion, REAL gamma) {
    const Wave wave = waving_pair(motion->w, motion->root);
    const Turns turns = whole_turns(motion->half, motion->w, motion->root, gamma);
    return (Swinging){M(exp)(-motion->half), wave.even, wave.odd, turns.near, turns.risen,
        turns.sunk,
        turns.moved};
}

// n0, n1 and trace of the device
static inline Device device_n0_n1_trace_anew(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.w.hi < R(0.0)) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const REAL rounded_of = rounded(wide_prod(swinging.envelope, swinging.even));
        return (Device){plant_n0_swing(&motion, &swinging, decayed, gamma),
            plant_n1_swing(&motion, &swinging, decayed, gamma), R(2.0)*rounded_of};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device){plant_n0_creep(&motion, &creeping, decayed, gamma, delta),
        plant_n1_creep(&motion, &creeping, decayed),
        rounded(pair_prod(creeping.slow, one_plus(creeping.ratio)))};
}
KEEP(Device, device_n0_n1_trace)

// divided difference of cosh(sqrt) at h^2 and w, less 1/2
static inline REAL numerator_at_one_series(REAL h, REAL w) {
    const REAL y = h*h;
    REAL total = R(0.0), inner = R(0.0);
    for (int n = (M(fabs)(w) < R(0.00390625) && h < R(0.0625) ? PICK(12, 8) :
        PICK(28, 20)); n >= 4; n -= 2) {
        const REAL number = inverse_factorial[n], own = inner*w + number;
        total = own + total*y; inner = own;
    }
    return inner*w + total*y;
}

// n1 + n0 of an overdamped device
static inline REAL numerator_at_one_creep(const Motion *motion, const Creeping *creeping) {
    if (motion->reach < R(1.0)) {
        return R(2.0)*scaled_sum((Pair){M(exp)(-motion->half), R(0.0)},
            numerator_at_one_series(motion->half, motion->w.hi), R(0.5));
    }
    return rounded(pair_quot(pair_prod(creeping->mean,
        one_minus(pair_prod(creeping->slow, creeping->ratio))), creeping->p));
}

// (1 - exp(-half))^2/4 + envelope (wave - back)^2 and what it misses
static inline Pair half_squares(REAL half, REAL envelope, REAL wave, REAL back) {
    const REAL grown = -R(0.5)*M(expm1)(-half);
    return pair_sum(wide_prod(envelope, pair_square(two_diff(wave, back))),
        (Pair){grown*grown, R(0.0)});
}

// n1 + n0 of an oscillating device
static inline REAL numerator_at_one_swing(const Motion *motion, const Swinging *swinging,
    REAL gamma) {
    if (motion->reach < R(1.0)) {
        return R(2.0)*scaled_sum((Pair){swinging->envelope, R(0.0)},
            numerator_at_one_series(motion->half, motion->w.hi), R(0.5));
    }
    if (swinging->near > R(0.0)) { return swinging->moved; }
    const REAL angle = R(0.5)*motion->root;
    const REAL back = -R(0.5)*root_miss(motion->w, motion->root)*M(cos)(angle);
    return R(4.0)*rounded(pair_quot(half_squares(motion->half, swinging->envelope, M(sin)(angle),
        back),
        (Pair){gamma, R(0.0)}));
}

// together and trace of the device
static inline Device2 device_together_trace_anew(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < R(0.0)) {
        const Swinging swinging = swinging_device(&motion, gamma);
        const REAL rounded_of = rounded(wide_prod(swinging.envelope, swinging.even));
        return (Device2){numerator_at_one_swing(&motion, &swinging, gamma), R(2.0)*rounded_of};
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return (Device2){numerator_at_one_creep(&motion, &creeping),
        rounded(pair_prod(creeping.slow, one_plus(creeping.ratio)))};
}
KEEP(Device2, device_together_trace)

// n0, the same device with its time reversed, times exp(-delta)
static inline REAL plant_n0(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.reach < R(0.5625)) { return plant_n0_near(decayed, gamma, delta); }
    if (motion.w.hi < R(0.0)) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return plant_n0_swing(&motion, &swinging, decayed, gamma);
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return plant_n0_creep(&motion, &creeping, decayed, gamma, delta);
}

// n1, how far a unit force moves the device in a period
static inline REAL plant_n1(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    const Pair decayed = slow_fade(&motion);
    if (motion.reach < R(0.5625)) {
        return scaled_sum(decayed, plant_n1_series(motion.half, motion.w.hi), R(0.5));
    }
    if (motion.w.hi < R(0.0)) {
        const Swinging swinging = swinging_device(&motion, gamma);
        return plant_n1_swing(&motion, &swinging, decayed, gamma);
    }
    const Creeping creeping = creeping_device(&motion, gamma);
    return plant_n1_creep(&motion, &creeping, decayed);
}

// (1 - exp(-x))/x
static inline REAL decay(REAL x) { return (x == R(0.0) ? R(1.0) : -M(expm1)(-x)/x); }

// 1 + a + e of an overdamped device
static inline REAL denominator_at_minus_one_creep(const Creeping *creeping) {
    return rounded(pair_prod(one_plus(creeping->slow),
        one_plus(pair_prod(creeping->slow, creeping->ratio))));
}

// 1 + a + e of an oscillating device
static inline REAL denominator_at_minus_one_swing(const Motion *motion,
    const Swinging *swinging) {
    const Pair prod = wide_prod(R(2.0)*swinging->envelope, swinging->even);
    if (prod.hi > R(0.0)) {
        return rounded(pair_sum(one_plus((Pair){M(exp)(-R(2.0)*motion->half), R(0.0)}), prod));
    }
    const REAL angle = R(0.5)*motion->root;
    return R(4.0)*rounded(half_squares(motion->half, swinging->envelope, M(cos)(angle), R(0.5)*
        root_miss(motion->w, motion->root)*M(sin)(angle)));
}

#ifndef SINGLE
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
#else
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
#endif

// (n1 - n0)/delta of an overdamped device
static inline REAL numerator_gap_creep(const Motion *motion, const Creeping *creeping,
    REAL delta) {
    if (motion->reach < R(1.0)) {
        return scaled_sum((Pair){M(exp)(-motion->half), R(0.0)},
            numerator_gap_series(motion->half, motion->w.hi),
                PICK(0.16666666666666666, 0.16666667f));
    }
    const Pair diff = pair_diff(creeping->mean, wide_prod(R(2.0)*creeping->slow.hi, creeping->far));
    const Pair prod2 = wide_prod(creeping->ratio.hi*creeping->slow.hi, creeping->mean);
    const REAL top = diff.hi + prod2.hi, low = diff.lo + prod2.lo, whole = delta*creeping->p.hi;
    return (low + top)/whole;
}

// (n1 - n0)/delta of an oscillating device
static inline REAL numerator_gap_swing(const Motion *motion, const Swinging *swinging,
    REAL gamma, REAL delta) {
    if (motion->reach < R(1.0)) {
        return scaled_sum((Pair){swinging->envelope, R(0.0)},
            numerator_gap_series(motion->half, motion->w.hi),
                PICK(0.16666666666666666, 0.16666667f));
    }
    return rounded(pair_quot(pair_diff((Pair){decay(delta), R(0.0)},
        wide_prod(swinging->envelope, swinging->wave)), (Pair){gamma, R(0.0)}));
}

// at_minus_one, kick, together, n_gap, n0 and n1 of the device
static inline Device3 device_at_minus_one_kick_together_n_gap_n0_n1_anew(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < R(0.0)) {
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
KEEP(Device3, device_at_minus_one_kick_together_n_gap_n0_n1)

#ifndef SINGLE
// the root of a cubic on a piece where it bends one way
static inline double cubic_root(double k0, double k1, double k2, double k3, double low,
    double high, double rise) {
    const double three = 3.0*k3, two = 2.0*k2, convex = three*(high + low) + two > 0.0 ? 1.0 : -1.0;
    const double down = convex*rise > 0.0 ? 1.0 : -1.0;
    const double begin = convex*k0 > 0.0 && high > 0.0 && low < 0.0 ? 0.0 :
        (down > 0.0 ? high : low);
    const double end = convex*k0 <= 0.0 && high > 0.0 && low < 0.0 ? 0.0 :
        (down > 0.0 ? low : high);
    const double part = 0.0625*begin;
    const double above = convex*(k0 + part*(k1 + part*(k2 + k3*part))) > 0.0 &&
        fabs(end) < fabs(part) ? 1.0 : 0.0;
    double begin2 = above > 0.0 ? part : begin;
    double end2 = above <= 0.0 && fabs(end) < fabs(part) ? part : end;
    for (int count_begin2 = 0; count_begin2 < 8; ++count_begin2) {
        if (fabs(begin2) <= 16.0*fmax(1.499696813895631e-241, fabs(end2))) { break; }
        const double more = fmax(1.499696813895631e-241, fabs(end2)), size = sqrt(more)*
            sqrt(fabs(begin2));
        const double at = begin2 < 0.0 ? -size : size;
        const double outside = convex*(at*(at*(at*k3 + k2) + k1) + k0) > 0.0 ? 1.0 : 0.0;
        const double next_begin = outside > 0.0 ? at : begin2;
        end2 = outside > 0.0 ? end2 : at; begin2 = next_begin;
    }
    double y = begin2, moves = 1.0;
    for (int count_y = 0; count_y < 98; ++count_y) {
        if (moves == 0.0) { break; }
        const double steep = k1 + y*(three*y + two), some = steep == 0.0 ? 1.0 : steep;
        const double move = steep == 0.0 ? 0.0 : (k0 + y*(k1 + y*(k2 + k3*y)))/some;
        const double new_ = fmin(high, y - move), new2 = fmax(low, new_);
        const double moves2 = down*(y - new2) > 0.0 ? 1.0 : 0.0;
        y = moves2 > 0.0 ? new2 : y; moves = moves2;
    }
    return y;
}
#else
// the root of a cubic on a piece where it bends one way
static inline float cubic_root(float k0, float k1, float k2, float k3, float low, float high,
    float rise) {
    const float three = 3.0f*k3, two = 2.0f*k2;
    const float convex = three*(high + low) + two > 0.0f ? 1.0f : -1.0f;
    const float down = convex*rise > 0.0f ? 1.0f : -1.0f;
    const float begin = convex*k0 > 0.0f && high > 0.0f && low < 0.0f ? 0.0f :
        (down > 0.0f ? high : low);
    const float end = convex*k0 <= 0.0f && high > 0.0f && low < 0.0f ? 0.0f :
        (down > 0.0f ? low : high);
    const float part = 0.0625f*begin;
    const float above = convex*(k0 + part*(k1 + part*(k2 + k3*part))) > 0.0f &&
        fabsf(end) < fabsf(part) ? 1.0f : 0.0f;
    float begin2 = above > 0.0f ? part : begin;
    float end2 = above <= 0.0f && fabsf(end) < fabsf(part) ? part : end;
    for (int count_begin2 = 0; count_begin2 < 5; ++count_begin2) {
        if (fabsf(begin2) <= 16.0f*fmaxf(8.271806e-25f, fabsf(end2))) { break; }
        const float more = fmaxf(8.271806e-25f, fabsf(end2)), size = sqrtf(more)*
            sqrtf(fabsf(begin2));
        const float at = begin2 < 0.0f ? -size : size;
        const float outside = convex*(at*(at*(at*k3 + k2) + k1) + k0) > 0.0f ? 1.0f : 0.0f;
        const float next_begin = outside > 0.0f ? at : begin2;
        end2 = outside > 0.0f ? end2 : at; begin2 = next_begin;
    }
    float y = begin2, moves = 1.0f;
    for (int count_y = 0; count_y < 48; ++count_y) {
        if (moves == 0.0f) { break; }
        const float steep = k1 + y*(three*y + two), some = steep == 0.0f ? 1.0f : steep;
        const float move = steep == 0.0f ? 0.0f : (k0 + y*(k1 + y*(k2 + k3*y)))/some;
        const float new_ = fminf(high, y - move), new2 = fmaxf(low, new_);
        const float moves2 = down*(y - new2) > 0.0f ? 1.0f : 0.0f;
        y = moves2 > 0.0f ? new2 : y; moves = moves2;
    }
    return y;
}
#endif

// of x + j u: half turns and the rest of the angle, the size and its inverse, how far both may be
// off, and how they change with y
static inline Part crossing_part(REAL x, REAL u, REAL x_off, REAL u_off, REAL steep,
    REAL low, REAL high) {
    const REAL most = M(fmax)(M(fabs)(u), M(fabs)(x)), least = M(fmin)(M(fabs)(u), M(fabs)(x));
    const REAL whole = most == R(0.0) ? R(1.0) : most, ratio = least/whole;
    const REAL longer = M(sqrt)(ratio*ratio + R(1.0)), size = longer*most;
    const REAL whole2 = size == R(0.0) ? R(1.0) : size, per = R(1.0)/whole2, real = per*x, up = per*
        u;
    const REAL along = per*x_off, across = per*u_off, away = across + along, one = M(fabs)(real);
    const REAL two = M(fabs)(up), blur = (R(2.0)*away + R(1.0))*(across*one + along*two);
    const REAL rest = M(atan2)(x < R(0.0) ? -u : u, M(fabs)(x)), falls = per*steep;
    const REAL tilt = R(0.5)*low - R(0.5)*high, square = up*up;
    const REAL fast = square*(high + low) + R(2.0)*M(fabs)(falls);
    return (Part){x < R(0.0) ? (u < R(0.0) ? -R(1.0) : R(1.0)) : R(0.0), rest, size, per,
        size > R(0.0) ? across*
        two + along*one + away*away : R(1.0), away < R(0.25) ? blur +
            PICK(4.440892098500626e-16, 2.3841858e-07f)*M(fabs)(rest) :
        R(4.0), R(2.0)*falls*real + R(2.0)*square*tilt, fast, R(2.0)*(falls*falls) + fast*fast +
            R(2.0)*high*low*
        square, up*(real*tilt - falls), two*(one*M(fabs)(tilt) + M(fabs)(falls))};
}

#ifndef SINGLE
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
    const double around = late*(at > 2.0 ? -2.0*half : 2.0*half);
    const double share = 0.5*(-around - part.rest + part2.rest + part3.rest)/3.141592653589793;
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
#else
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
    const float around = late*(at > 2.0f ? -2.0f*half : 2.0f*half);
    const float share = 0.5f*(-around - part.rest + part2.rest + part3.rest)/3.1415927f;
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
#endif

// what the crossing on a piece, if there is one, adds
static inline REAL piece_turns(const Loop *loop, REAL k0, REAL k1, REAL k2, REAL k3,
    REAL low, REAL high, REAL at_low, REAL at_high, REAL zone) {
    if (((at_high >= R(0.0) && at_low < R(0.0)) || (at_high < R(0.0) && at_low >= R(0.0))) &&
        (at_low != R(0.0) || low != R(0.0)) && high > low) {
        const REAL x = cubic_root(k0, k1, k2, k3, low, high, at_high - at_low);
        const REAL y = zone == R(0.0) ? x : (zone == R(1.0) ? loop->center + x : R(4.0) - x);
        const REAL rest = zone == R(0.0) ? R(4.0) - x : (zone == R(1.0) ? loop->beyond - x : x);
        if (rest > R(0.0) && y > R(0.0)) {
            const REAL off = zone == R(0.0) ? x - loop->center :
                (zone == R(1.0) ? x : loop->beyond - x);
            const REAL loose = zone == R(1.0) ? PICK(1.7763568394002505e-15, 9.536743e-07f) :
                PICK(2.220446049250313e-16, 1.1920929e-07f);
            const REAL free = zone == R(1.0) ? R(0.0) : PICK(8.881784197001252e-16, 4.7683716e-07f)*
                (zone == R(0.0) ? loop->center : loop->beyond);
            const REAL found = phase_turns(loop, y, rest, off, loose, free);
            const REAL up = at_high > at_low ? R(1.0) : -R(1.0), rises = zone == R(2.0) ? -up : up;
            return -R(2.0)*found*rises;
        }
        return NAN;
    }
    return R(0.0);
}

// NaN where it is not certain that the device is stronger if leads is positive, and else the wall,
// else 0
static inline REAL touches(const Loop *loop, REAL leads, REAL y, REAL rest, REAL off,
    REAL loose, REAL free) {
    const REAL at = M(fmax)(R(0.0), y), still = M(fmax)(R(0.0), rest), sine = R(2.0)*
        M(sqrt)(at*still);
    const REAL total = R(2.0) - loop->loss, plain = loose +
        PICK(4.440892098500626e-16, 2.3841858e-07f);
    const Part part3 = crossing_part(loop->alpha*still - at*loop->far, sine*loop->slope, plain*
        (at*M(fabs)(loop->far) + still*M(fabs)(loop->alpha)), plain*sine*M(fabs)(loop->slope),
            R(0.0), R(0.0),
        R(0.0));
    const REAL made = loose + PICK(1.3322676295501878e-15, 7.1525574e-07f);
    const Part part2 = crossing_part(still*loop->together - loop->apart*at, loop->n1*sine,
        loop->apart_off*at + made*(at*M(fabs)(loop->apart) + still*loop->together), sine*
        (made*M(fabs)(loop->n1) + loop->n1_off), R(0.0), R(0.0), R(0.0));
    const Part part = crossing_part(-R(2.0)*off*total, loop->loss*sine, R(4.0)*loop->a_off + total*
        (R(2.0)*free + PICK(8.881784197001252e-16, 4.7683716e-07f)*M(fabs)(off)), loop->loss*made*
            sine, R(0.0), R(0.0), R(0.0));
    const REAL ratio = part.per*part2.size, gap_ = R(1.0) - R(0.25)*ratio*part3.size;
    const REAL rough = part.off + part2.off + part3.off +
        PICK(1.3322676295501878e-15, 7.1525574e-07f);
    const REAL signed_ = leads > R(0.0) ? gap_ : -gap_, good = signed_ > R(2.0)*rough ? R(1.0) :
        R(0.0);
    if (good < R(1.0) && rest > R(0.0) && y > R(0.0)) { return NAN; }
    return R(0.0);
}

// NaN where the wall may be as strong as the device at an extremum of both, else 0
static inline REAL zone_touches(const Loop *loop, REAL leads, REAL x, REAL zone) {
    const REAL y = zone == R(0.0) ? x : (zone == R(1.0) ? loop->center + x : R(4.0) - x);
    const REAL rest = zone == R(0.0) ? R(4.0) - x : (zone == R(1.0) ? loop->beyond - x : x);
    const REAL off = zone == R(0.0) ? x - loop->center : (zone == R(1.0) ? x : loop->beyond - x);
    const REAL loose = zone == R(1.0) ? PICK(1.7763568394002505e-15, 9.536743e-07f) :
        PICK(2.220446049250313e-16, 1.1920929e-07f);
    const REAL free = zone == R(1.0) ? R(0.0) : PICK(8.881784197001252e-16, 4.7683716e-07f)*
        (zone == R(0.0) ? loop->center : loop->beyond);
    return touches(loop, leads, y, rest, off, loose, free);
}

#ifndef SINGLE
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
#else
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
#endif

#ifndef SINGLE
// roots outside the unit circle with a fractional delay, -1 if that is not certain
static inline double fractional_roots(double alpha, double beta, double d, double m2, double m0,
    double gamma, double at_minus_one, double loss, double together, double apart, double across,
    double delta) {
    if (alpha == 0.0 && beta == 0.0) { return 0.0; }
    const double strength = fabs(alpha) + fabs(beta), stiffest = fmax(gamma, fabs(alpha));
    const double slope = alpha + beta, wall_far = alpha + 2.0*beta, force = beta*slope;
    const double lost = loss*loss, square = m0*m2, size = across*across, at_one = gamma*together;
    const double turn_off = gamma > 10.0 ? 8.881784197001252e-16/
        (fmax(1.0, delta)*sqrt(fmax(1.0, gamma))) : 0.0;
    const double size2 = m2 + together + fabs(m0), near = sqrt(fmin(1.0, at_minus_one));
    const double near2 = sqrt(fmin(1.0, at_one)), whole = gamma == 0.0 ? 1.0 : gamma;
    const double apart_off = near*(7.105427357601002e-15*size2 + 2.0*turn_off);
    const double n1_off = near2*turn_off + 1.4210854715202004e-14*
        (gamma > 10.0 && loss < 0.5 ? 2.0*near2/whole : 0.125*size2);
    const double a_off = 1.5777218104420236e-30*sqrt(at_minus_one*gamma), ends = m2 + fabs(m0);
    const double apart_one = (gamma - alpha)*(alpha + gamma), even = together*together;
    const double even2 = together*(m0 + m2), linear = size - even2, push = alpha*alpha;
    const double near0 = apart_one*even;
    const double near1 = -at_one*(2.0 - loss) - force*(together*together) - linear*push + lost;
    const double near22 = -force*linear - loss - push*square + 1.0, near3 = -force*square;
    const double cross = size + fabs(even2), bent = cross*fabs(force) + push*fabs(square) + 1.0;
    const double most = at_one*(2.0 - loss) + cross*push + lost + (together*together)*fabs(force);
    const double blurred = n1_off*(n1_off + 2.0*fabs(across));
    const double cross_off = blurred + together*turn_off, pull = fabs(apart*wall_far);
    const double end_off = a_off + apart_off*fabs(wall_far) + 1.7763568394002505e-15*at_minus_one +
        1.7763568394002505e-15*pull;
    const double end_apart = fabs(at_minus_one - pull) - end_off;
    const double end_least = end_apart*(at_minus_one + pull), cubed = ends*turn_off*fabs(force);
    const double room = (alpha*alpha)*cross_off + 3.552713678800501e-15*most;
    const double product = 4.0*near0*near22, outer = near1*near3, pushed_ = apart*wall_far;
    const double even3 = apart*(m0 + m2), linear2 = size - even3, push2 = wall_far*wall_far;
    const double far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_);
    const double far1 = (apart*apart)*force - at_minus_one*(2.0 - loss) - linear2*push2 + lost;
    const double far2 = force*linear2 - loss - push2*square + 1.0, far3 = force*square;
    const double cross2 = size + fabs(even3), bent2 = cross2*fabs(force) + push2*fabs(square) + 1.0;
    const double most2 = (apart*apart)*fabs(force) + at_minus_one*(2.0 - loss) + cross2*push2 +
        lost;
    const double cross_off2 = apart_off*ends + blurred + turn_off*fabs(apart);
    const double room2 = 2.0*a_off + apart_off*(apart_off + 2.0*fabs(apart))*fabs(force) +
        cross_off2*(wall_far*wall_far) + 3.552713678800501e-15*most2;
    const double product2 = 4.0*far0*far2, outer2 = far1*far3;
    const double base = 1.7763568394002505e-14*bent2 + 5.0*cross_off2*fabs(force) + 5.0*ends*
        turn_off*(wall_far*wall_far);
    const double base2 = 5.0*(alpha*alpha)*ends*turn_off + 1.7763568394002505e-14*bent + 5.0*
        cross_off*fabs(force);
    if ((((stiffest > 0.0 && stiffest < 3.8725919148493183e-121) || loss +
        strength < 3.8725919148493183e-121) && strength > 0.0) ||
        (end_least <= 2.2737367544323206e-12*bent2 + 640.0*cross_off2*fabs(force) + 128.0*cubed +
        640.0*ends*turn_off*(wall_far*wall_far) + 128.0*fabs(far3) &&
        fabs(far1) <= 1.2789769243681803e-13*bent2 + 36.0*cross_off2*fabs(force) + 36.0*ends*
        turn_off*(wall_far*wall_far) && fabs(far2) <= 2.842170943040401e-14*bent2 + 8.0*cross_off2*
        fabs(force) + 8.0*ends*turn_off*(wall_far*wall_far) && outer2 >= 0.0 && outer2 <= base*
        base) || (end_least <= 8.0*room2 + 128.0*fabs(far3) && product2 >= 0.0 && product2 <= room2*
        room2 && room2 >= fabs(far1)) || (fabs(near0) <= 640.0*(alpha*alpha)*ends*turn_off +
        2.2737367544323206e-12*bent + 640.0*cross_off*fabs(force) + 128.0*cubed + 128.0*
        fabs(near3) && fabs(near1) <= 36.0*(alpha*alpha)*ends*turn_off + 1.2789769243681803e-13*
        bent + 36.0*cross_off*fabs(force) && fabs(near22) <= 8.0*(alpha*alpha)*ends*turn_off +
        2.842170943040401e-14*bent + 8.0*cross_off*fabs(force) && outer >= 0.0 && outer <= base2*
        base2) || (fabs(near0) <= 8.0*room + 128.0*fabs(near3) && product >= 0.0 && product <= room*
        room && room >= fabs(near1)) || end_apart <= 0.0) {
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
    const double total = ((((((near22 == 0.0 && near3 < 0.0) || near22 < 0.0) && near1 == 0.0) ||
        near1 < 0.0) && near0 == 0.0) || near0 < 0.0 ? (alpha > 0.0 ? 0.0 : side) : 0.0) +
        zone_turns(&loop, far0, far1, far2, far3, zone, two2, far0, after, 2.0) +
        zone_turns(&loop, near0, near1, near22, near3, zone, one2, near0, before, zone) +
        zone_turns(&loop, own0, own1, own2, own3, -one2, two2, before, after, 1.0);
    const double total2 = total - ((((((far2 == 0.0 && far3 < 0.0) || far2 < 0.0) &&
        far1 == 0.0) || far1 < 0.0) && far0 == 0.0) || far0 < 0.0 ? end : 0.0);
    return (total2 >= 0.0 ? total2 : -1.0);
}
#else
// roots outside the unit circle with a fractional delay, -1 if that is not certain
static inline float fractional_roots(float alpha, float beta, float d, float m2, float m0,
    float gamma, float at_minus_one, float loss, float together, float apart, float across,
    float delta) {
    if (alpha == 0.0f && beta == 0.0f) { return 0.0f; }
    const float strength = fabsf(alpha) + fabsf(beta), stiffest = fmaxf(gamma, fabsf(alpha));
    const float slope = alpha + beta, wall_far = alpha + 2.0f*beta, force = beta*slope;
    const float lost = loss*loss, square = m0*m2, size = across*across, at_one = gamma*together;
    const float turn_off = gamma > 10.0f ? 4.7683716e-07f/
        (fmaxf(1.0f, delta)*sqrtf(fmaxf(1.0f, gamma))) : 0.0f;
    const float size2 = m2 + together + fabsf(m0), near = sqrtf(fminf(1.0f, at_minus_one));
    const float near2 = sqrtf(fminf(1.0f, at_one)), whole = gamma == 0.0f ? 1.0f : gamma;
    const float apart_off = near*(3.8146973e-06f*size2 + 2.0f*turn_off);
    const float n1_off = near2*turn_off + 7.6293945e-06f*
        (gamma > 10.0f && loss < 0.5f ? 2.0f*near2/whole : 0.125f*size2);
    const float a_off = 4.5474735e-13f*sqrtf(at_minus_one*gamma), ends = m2 + fabsf(m0);
    const float apart_one = (gamma - alpha)*(alpha + gamma), even = together*together;
    const float even2 = together*(m0 + m2), linear = size - even2, push = alpha*alpha;
    const float near0 = apart_one*even;
    const float near1 = -at_one*(2.0f - loss) - force*(together*together) - linear*push + lost;
    const float near22 = -force*linear - loss - push*square + 1.0f, near3 = -force*square;
    const float cross = size + fabsf(even2), bent = cross*fabsf(force) + push*fabsf(square) + 1.0f;
    const float most = at_one*(2.0f - loss) + cross*push + lost + (together*together)*fabsf(force);
    const float blurred = n1_off*(n1_off + 2.0f*fabsf(across));
    const float cross_off = blurred + together*turn_off, pull = fabsf(apart*wall_far);
    const float end_off = a_off + apart_off*fabsf(wall_far) + 9.536743e-07f*at_minus_one +
        9.536743e-07f*pull;
    const float end_apart = fabsf(at_minus_one - pull) - end_off;
    const float end_least = end_apart*(at_minus_one + pull), cubed = ends*turn_off*fabsf(force);
    const float room = (alpha*alpha)*cross_off + 1.9073486e-06f*most, product = 4.0f*near0*near22;
    const float outer = near1*near3, pushed_ = apart*wall_far, even3 = apart*(m0 + m2);
    const float linear2 = size - even3, push2 = wall_far*wall_far;
    const float far0 = (at_minus_one - pushed_)*(at_minus_one + pushed_);
    const float far1 = (apart*apart)*force - at_minus_one*(2.0f - loss) - linear2*push2 + lost;
    const float far2 = force*linear2 - loss - push2*square + 1.0f, far3 = force*square;
    const float cross2 = size + fabsf(even3);
    const float bent2 = cross2*fabsf(force) + push2*fabsf(square) + 1.0f;
    const float most2 = (apart*apart)*fabsf(force) + at_minus_one*(2.0f - loss) + cross2*push2 +
        lost;
    const float cross_off2 = apart_off*ends + blurred + turn_off*fabsf(apart);
    const float room2 = 2.0f*a_off + apart_off*(apart_off + 2.0f*fabsf(apart))*fabsf(force) +
        cross_off2*(wall_far*wall_far) + 1.9073486e-06f*most2;
    const float product2 = 4.0f*far0*far2, outer2 = far1*far3;
    const float base = 9.536743e-06f*bent2 + 5.0f*cross_off2*fabsf(force) + 5.0f*ends*turn_off*
        (wall_far*wall_far);
    const float base2 = 5.0f*(alpha*alpha)*ends*turn_off + 9.536743e-06f*bent + 5.0f*cross_off*
        fabsf(force);
    if ((((stiffest > 0.0f && stiffest < 9.094947e-13f) || loss + strength < 9.094947e-13f) &&
        strength > 0.0f) || (end_least <= 0.0012207031f*bent2 + 640.0f*cross_off2*fabsf(force) +
        128.0f*cubed + 640.0f*ends*turn_off*(wall_far*wall_far) + 128.0f*fabsf(far3) &&
        fabsf(far1) <= 6.866455e-05f*bent2 + 36.0f*cross_off2*fabsf(force) + 36.0f*ends*turn_off*
        (wall_far*wall_far) && fabsf(far2) <= 1.5258789e-05f*bent2 + 8.0f*cross_off2*fabsf(force) +
        8.0f*ends*turn_off*(wall_far*wall_far) && outer2 >= 0.0f && outer2 <= base*base) ||
        (end_least <= 8.0f*room2 + 128.0f*fabsf(far3) && product2 >= 0.0f && product2 <= room2*
        room2 && room2 >= fabsf(far1)) || (fabsf(near0) <= 640.0f*(alpha*alpha)*ends*turn_off +
        0.0012207031f*bent + 640.0f*cross_off*fabsf(force) + 128.0f*cubed + 128.0f*fabsf(near3) &&
        fabsf(near1) <= 36.0f*(alpha*alpha)*ends*turn_off + 6.866455e-05f*bent + 36.0f*cross_off*
        fabsf(force) && fabsf(near22) <= 8.0f*(alpha*alpha)*ends*turn_off + 1.5258789e-05f*bent +
        8.0f*cross_off*fabsf(force) && outer >= 0.0f && outer <= base2*base2) ||
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
    const float total = ((((((near22 == 0.0f && near3 < 0.0f) || near22 < 0.0f) &&
        near1 == 0.0f) || near1 < 0.0f) && near0 == 0.0f) || near0 < 0.0f ?
        (alpha > 0.0f ? 0.0f : side) : 0.0f) +
        zone_turns(&loop, far0, far1, far2, far3, zone, two2, far0, after, 2.0f) +
        zone_turns(&loop, near0, near1, near22, near3, zone, one2, near0, before, zone) +
        zone_turns(&loop, own0, own1, own2, own3, -one2, two2, before, after, 1.0f);
    const float total2 = total - ((((((far2 == 0.0f && far3 < 0.0f) || far2 < 0.0f) &&
        far1 == 0.0f) || far1 < 0.0f) && far0 == 0.0f) || far0 < 0.0f ? end : 0.0f);
    return (total2 >= 0.0f ? total2 : -1.0f);
}
#endif

// m2 - m1 + m0 of the device with a fractional delay
static inline REAL fractional_numerator_gap(REAL epsilon, Pair x, Pair y, REAL first,
    REAL last, REAL turned) {
    const Pair prod3 = pair_prod(wide_prod(epsilon, one_minus((Pair){epsilon, R(0.0)})),
        pair_prod(x, y));
    return rounded(pair_sum(pair_diff(pair_diff((Pair){first, R(0.0)},
        (Pair){R(2.0)*prod3.hi, R(2.0)*prod3.lo}), (Pair){last, R(0.0)}), (Pair){turned, R(0.0)}));
}

// m2 - m1 + m0 of a lightly damped oscillating device
static inline REAL half_turned_swing(REAL gamma, REAL delta, REAL part) {
    const Motion motion = device_motion(gamma, delta);
    const REAL angle = R(0.5)*motion.root, angle_low = R(0.5)*root_miss(motion.w, motion.root);
    const Pair prod = pair_prod((Pair){angle, angle_low}, fast_two_sum(R(1.0), -part));
    const Pair prod2 = pair_prod((Pair){angle, angle_low}, (Pair){part, R(0.0)});
    const REAL wave = M(sin)(angle), still = M(cos)(angle), sine = angle_low*still + wave;
    const REAL cosine = still - angle_low*wave, wave2 = M(sin)(prod.hi), still2 = M(cos)(prod.hi);
    const REAL sine2 = prod.lo*still2 + wave2, cosine2 = still2 - prod.lo*wave2;
    const REAL wave3 = M(sin)(prod2.hi), still3 = M(cos)(prod2.hi), sine3 = prod2.lo*still3 + wave3;
    const REAL cosine3 = still3 - prod2.lo*wave3, along = cosine2*cosine3 + sine2*sine3;
    const REAL across = cosine3*sine2 - cosine2*sine3, before = R(0.5) - part;
    const REAL step = M(expm1)(R(0.5)*motion.half), weak = R(0.5)*step + R(0.5)*step/
        (step + R(1.0));
    const REAL more = R(0.5)*(step*step)/(step + R(1.0)), strong = more + R(1.0);
    const REAL fallen = M(expm1)(-before*motion.half), grown = fallen + R(1.0);
    const REAL ratio = motion.half/motion.root;
    const REAL lost = weak*weak - along*cosine*(fallen*strong + more);
    const REAL turned = grown*sine*weak*(across - along*ratio);
    const REAL kept = across*cosine*grown*ratio*strong;
    const REAL total2 = -R(2.0)*cosine*sine2*sine3 - kept + lost + turned;
    return R(4.0)*total2*M(exp)(-motion.half)/gamma;
}

// m2 - m1 + m0 with a fractional delay
static inline REAL half_turned(REAL found, REAL gamma, REAL delta, REAL part) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.half < R(0.25) && motion.root > R(3.0) && motion.w.hi < R(0.0)) {
        return half_turned_swing(gamma, delta, part);
    }
    return found;
}

// kick, kick_low, n_gap, n0 and n1 of the device
static inline Device4 device_kick_kick_low_n_gap_n0_n1_anew(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < R(0.0)) {
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
KEEP(Device4, device_kick_kick_low_n_gap_n0_n1)

// m2 - m1 + m0, m2, displacement by an impulse in the rest of the period, m0
static inline Delayed late_device_anew(REAL gamma, REAL delta, REAL part) {
    const REAL t0 = R(1.0) - part, t1 = t0*t0, t2 = gamma*t1, t3 = delta*t0;
    const Device4 device = device_kick_kick_low_n_gap_n0_n1(t2, t3);
    const REAL t5 = part*part, t6 = gamma*t5, t7 = delta*part;
    const Device4 device2 = device_kick_kick_low_n_gap_n0_n1(t6, t7);
    const REAL t9 = device2.n0*t5;
    return (Delayed){half_turned(fractional_numerator_gap(part, device.kick, device2.kick, delta*
        device.n_gap*(t0*t0*t0), delta*device2.n_gap*(part*part*part), device.n0*t1*
        (device2.kick.hi*t7 + device2.n1*t6) + device.n1*device2.n1*t2*t5 - t3*t9*decay(t3)),
        gamma, delta, part), device.n1*t1, device.kick.hi*t0, t9*M(exp)(-t3)};
}
KEEP_PART(Delayed, late_device)

// 1 if the loop is stable, 0 if it is not, -1 if that is not certain
static inline REAL stable(REAL roots, REAL alpha, REAL beta, REAL gamma, REAL delta) {
    const REAL swing = M(sqrt)(gamma);
    const REAL yes = !(alpha == R(0.0) && beta == R(0.0) && delta == R(0.0) && gamma > R(0.0)) &&
        !(delta < PICK(1.1102230246251565e-15, 5.9604645e-07f) && gamma > R(1.0) &&
            swing >= PICK(2251799813685248.0, 4.194304e+06f)*
        M(fabs)(M(sin)(swing))) && alpha > -gamma && roots == R(0.0) ? R(1.0) : R(0.0);
    return yes - ((alpha == R(0.0) && beta == R(0.0) && delta == R(0.0) && gamma > R(0.0)) ||
        alpha <= -gamma || roots > R(0.0) || yes > R(0.0) ? R(0.0) : R(1.0));
}

// a point that is known about three, and whether it is on the circle
static inline Point nearest_point(const Loop *loop, REAL y, REAL rest, REAL off) {
    const REAL edge = rest > y ? y : rest;
    const REAL inside = edge > M(fabs)(off) && loop->beyond - off > R(0.0) && loop->center +
        off > R(0.0) ? R(1.0) : R(0.0);
    return (Point){inside > R(0.0) ? loop->center + off : (rest > y ? y : R(4.0) - rest),
        inside > R(0.0) ?
        loop->beyond - off : (rest > y ? R(4.0) - y : rest), inside > R(0.0) ? off :
        (rest > y ? y - loop->center : loop->beyond - rest), inside > R(0.0) ?
        PICK(1.7763568394002505e-15, 9.536743e-07f) : PICK(2.220446049250313e-16, 1.1920929e-07f),
            inside > R(0.0) ? R(0.0) : PICK(8.881784197001252e-16, 4.7683716e-07f)*
        (rest > y ? loop->center : loop->beyond), M(fmin)(rest, y) < R(4.0) && rest > R(0.0) &&
            y > R(0.0) ?
        R(1.0) : R(0.0)};
}

// NaN where the wall may be as strong as the device at an extremum of both, else 0
static inline REAL bottom_touches(const Loop *loop, REAL leads, REAL y, REAL rest,
    REAL off) {
    const Point point = nearest_point(loop, y, rest, off);
    if (point.there > R(0.0)) {
        const Loop loop2 = {.alpha = loop->alpha, .slope = loop->slope, .far = loop->far, .n1 =
            loop->n1, .loss = loop->loss, .together = loop->together, .apart = loop->apart,
            .apart_off = R(0.0), .n1_off = R(0.0), .a_off = loop->a_off};
        return touches(&loop2, leads, point.at, point.still, point.away, point.loose, point.free);
    }
    return R(0.0);
}

// the turns at a crossing, if there is one
static inline REAL crossing_turns(const Loop *loop, REAL y, REAL rest, REAL off) {
    const Point point = nearest_point(loop, y, rest, off);
    if (point.there > R(0.0)) {
        const Loop loop2 = {.alpha = loop->alpha, .slope = loop->slope, .far = loop->far, .d =
            loop->d, .n1 = loop->n1, .loss = loop->loss, .together = loop->together, .apart =
            loop->apart, .apart_off = R(0.0), .n1_off = R(0.0), .a_off = loop->a_off};
        return phase_turns(&loop2, point.at, point.still, point.away, point.loose, point.free);
    }
    return R(0.0);
}

// (-b - root)/(2 a) and (-b + root)/(2 a), without cancellation; -1 for what is infinite
static inline Roots quadratic_roots(REAL c, REAL b, REAL a, REAL root) {
    const REAL q = -R(0.5)*b - R(0.5)*(b >= R(0.0) ? root : -root), lead_ = a == R(0.0) ? R(1.0) :
        a;
    const REAL own = q == R(0.0) ? R(1.0) : q, one = a == R(0.0) ? -R(1.0) : q/lead_;
    const REAL two = q == R(0.0) ? -R(1.0) : c/own;
    if (b >= R(0.0)) { return (Roots){one, two}; }
    return (Roots){two, one};
}

#ifndef SINGLE
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
#else
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
#endif

// the imaginary and the real part of A/(z M), M over A being the device, at z = exp(2 j psi)
static inline Response ahead_in_phase(REAL psi, REAL at_one, REAL at_minus_one, REAL loss,
    REAL together, REAL apart, REAL across) {
    const REAL t = M(tan)(psi), square = t*t, low = M(fma)(t, t, -(t*t));
    const Pair diff = two_diff(at_one, at_minus_one*square);
    const REAL missed = at_minus_one*low + M(fma)(at_minus_one, square, -(at_minus_one*square));
    const Pair total = fast_two_sum(diff.hi, diff.lo - missed);
    const Pair diff2 = two_diff(together, apart*square);
    const REAL missed2 = apart*low + M(fma)(apart, square, -(apart*square));
    const Pair total2 = fast_two_sum(diff2.hi, diff2.lo - missed2);
    const REAL above_j = R(2.0)*loss*t, below_j = across*t;
    const REAL rest = below_j*below_j + R(2.0)*total2.hi*total2.lo;
    const REAL size = rest + total2.hi*total2.hi, low2 = above_j*total2.lo - below_j*total.lo;
    const REAL found = above_j*total2.hi - below_j*total.hi, found2 = found + low2;
    const REAL low22 = total.hi*total2.lo + total2.hi*total.lo, rest2 = above_j*below_j + low22;
    const REAL found3 = rest2 + total.hi*total2.hi;
    return (Response){found2/size, found3/size};
}

// at_minus_one, kick, together and n_gap of the device
static inline Device5 device_at_minus_one_kick_together_n_gap_anew(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < R(0.0)) {
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
KEEP(Device5, device_at_minus_one_kick_together_n_gap)

#ifndef SINGLE
// cos((k + 1) x) and sin((k + 1) x)
static inline CosSin next_wave(double k, double x) {
    const double count = k + 1.0, before = count - 1.0, angle = count*x, missed = k - before;
    const double off = missed*x + fma(count, x, -(count*x)), sine = sin(angle), cosine = cos(angle);
    if (fabs(off) < 7.450580596923828e-09) {
        return (CosSin){cosine - off*sine, cosine*off + sine};
    }
    return (CosSin){cosine*cos(off) - sine*sin(off), cosine*sin(off) + sine*cos(off)};
}
#else
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
#endif

// at_minus_one, together, n_gap, n0 and n1 of the device
static inline Device6 device_at_minus_one_together_n_gap_n0_n1_anew(REAL gamma, REAL delta) {
    const Motion motion = device_motion(gamma, delta);
    if (motion.w.hi < R(0.0)) {
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
KEEP(Device6, device_at_minus_one_together_n_gap_n0_n1)

// has the sign of the slope of the boundary's alpha, d < 1
static inline REAL early_slope(REAL theta, REAL k4, REAL k3, REAL k2, REAL k1,
    REAL k0) {
    const REAL sine = M(sin)(R(0.5)*theta), cosine = M(cos)(R(0.5)*theta), up = sine*sine;
    const REAL along = cosine*cosine, found = along*k3 + k4*up, power2 = along*along;
    const REAL found2 = found*up + k2*power2, power3 = along*power2;
    const REAL found3 = found2*up + k1*power3, power4 = along*power3;
    return found3*up + k0*power4;
}

// has the sign of the slope of the boundary's alpha next to pi
static inline REAL end_slope(REAL at_minus_one, REAL loss, REAL together, REAL apart,
    REAL last) {
    const Pair diff = two_diff(together, R(4.0)*last), squared = pair_square(diff);
    const Pair prod = two_prod(apart, together);
    const Pair prod5 = wide_prod(loss, wide_prod(apart, pair_diff(prod, squared)));
    const Pair prod6 = pair_prod(pair_square((Pair){apart, R(0.0)}),
        pair_diff((Pair){R(2.0)*apart, R(0.0)}, diff));
    return rounded(pair_diff(pair_diff((Pair){R(4.0)*prod6.hi, R(4.0)*prod6.lo},
        wide_prod(at_minus_one, pair_sum(pair_prod(diff,
        pair_diff(squared, (Pair){R(2.0)*prod.hi, R(2.0)*prod.lo})), wide_prod(apart, prod)))),
        (Pair){R(2.0)*prod5.hi, R(2.0)*prod5.lo}));
}

// the next point of a search between a and b, where f is fa and fb, after c
static inline REAL next_guess(REAL b, REAL fb, REAL a, REAL fa, REAL c, REAL fc,
    REAL close) {
    const REAL span = c - b, rise = fc - fb, whole = span == R(0.0) ? R(1.0) : span;
    const REAL place = (a - b)/whole, whole2 = rise == R(0.0) ? R(1.0) : rise;
    const REAL height = (fa - fb)/whole2, base = R(1.0) - height;
    const REAL safe = place > height*height && place < R(1.0) - (base*base) ? R(1.0) : R(0.0);
    const REAL width = b - a, whole3 = width == R(0.0) ? R(1.0) : width;
    const REAL edge = close*M(fabs)(M(fabs)(fa) < M(fabs)(fb) ? a : b)/M(fabs)(whole3);
    const REAL edge2 = M(fmin)(R(0.5), edge);
    REAL guess = R(0.5);
    if (safe > R(0.0)) {
        const REAL one = fb - fa, two = fb - fc, three = fa - fc, here = fa/one, there = fc/two;
        const REAL other = fa/three, last = fb/two;
        guess = here*there + last*other*(c - a)/whole3;
    }
    const REAL share = M(fmin)(guess, R(1.0) - edge2), share2 = M(fmax)(edge2, share);
    return a + share2*width;
}

// the angle of the largest stiffness for delays below a period
static inline REAL early_angle(REAL at_one, REAL at_minus_one, REAL loss, REAL together,
    REAL apart, REAL last) {
    const REAL t = apart*apart*apart, t2 = together*together*together, t3 = together*together;
    const REAL t4 = apart*t3, t5 = apart*apart, t6 = R(2.0)*loss, t7 = at_minus_one + t6;
    const REAL t8 = R(4.0)*together, t9 = R(16.0)*apart, t10 = at_one + t6, t11 = R(2.0)*at_one;
    const REAL t12 = R(5.0)*at_minus_one, t13 = -at_one, t14 = R(4.0)*loss, t15 = apart*together;
    const REAL t16 = R(16.0)*together, t17 = at_one*last, t18 = apart*t11, t19 = at_one*t5;
    const REAL k = end_slope(at_minus_one, loss, together, apart, last);
    const REAL k2 = last*(R(32.0)*at_minus_one*t3 + last*
        (R(64.0)*apart*loss + R(128.0)*at_minus_one*last - R(96.0)*at_minus_one*together) - R(96.0)*
            t5 - t7*t9*
        together) - R(4.0)*at_minus_one*t2 + R(16.0)*t + R(8.0)*t4*(at_minus_one + loss) - t5*t7*t8;
    const REAL k3 = last*(last*(last*(-R(192.0)*at_minus_one - R(256.0)*at_one - R(512.0)*loss) +
        t16*
        (R(9.0)*at_one + R(16.0)*loss + t12) + t9*
            (R(8.0)*at_minus_one + R(8.0)*at_one + R(18.0)*loss)) - R(32.0)*
        t15 - R(4.0)*t3*(at_minus_one + R(7.0)*at_one + R(14.0)*loss) - R(112.0)*t5) + R(8.0)*t +
            R(2.0)*t2*
        (t10 - R(2.0)*at_minus_one) + R(2.0)*t4*(t12 + t13 + t14) - R(2.0)*t5*together*(t7 - t11);
    const REAL k4 = last*(R(32.0)*t17*together - R(8.0)*together*(t18 + R(12.0)*together)) + t8*
        (t10*t3 + t15*(at_minus_one + t13) + t19);
    const REAL k5 = last*(t16*t17 + t8*(t10*together - t18)) + together*
        (t19 - R(2.0)*t15*(at_one + loss) + t3*(at_minus_one + t11 + t14));
    REAL count = R(1.0), found = R(0.0);
    for (int count_count = 0; count_count < 24; ++count_count) {
        if (count > R(24.0) || found > R(0.0)) { break; }
        const REAL rises = early_slope(PICK(0.041666666666666664, 0.041666668f)*
            PICK(3.141592653589793, 3.1415927f)*count, k, k2, k3,
            k4, k5);
        const REAL next_count = rises > R(0.0) ? count + R(1.0) : count;
        found = rises > R(0.0) ? R(0.0) : R(1.0); count = next_count;
    }
    if (found > R(0.0)) {
        const REAL high = PICK(0.041666666666666664, 0.041666668f)*
            PICK(3.141592653589793, 3.1415927f)*count;
        const REAL low = M(fmax)(R(0.001)*high, PICK(0.041666666666666664, 0.041666668f)*
            PICK(3.141592653589793, 3.1415927f)*(count - R(1.0)));
        const REAL above = early_slope(low, k, k2, k3, k4, k5);
        if (above <= R(0.0)) { return low; }
        const REAL below = early_slope(high, k, k2, k3, k4, k5);
        if (below >= R(0.0)) { return high; }
        REAL b = low, fb = above, a = high, fa = below, c = high, fc = below;
        for (int count_b = 0; count_b < 120; ++count_b) {
            if ((fa >= R(0.0) && fb >= R(0.0)) || (fa <= R(0.0) && fb <= R(0.0)) ||
                M(fabs)(a - b) <= PICK(4.440892098500626e-16, 2.3841858e-07f)*
                    M(fabs)(M(fabs)(fa) < M(fabs)(fb) ? a : b)) { break; }
            const REAL new_ = next_guess(b, fb, a, fa, c, fc,
                PICK(4.440892098500626e-16, 2.3841858e-07f));
            const REAL value = early_slope(new_, k, k2, k3, k4, k5);
            const REAL same = (fa > R(0.0) && value > R(0.0)) || (fa < R(0.0) && value < R(0.0)) ?
                R(1.0) : R(0.0);
            const REAL next_b = same > R(0.0) ? b : a, next_fb = same > R(0.0) ? fb : fa;
            const REAL next_c = same > R(0.0) ? a : b;
            fc = same > R(0.0) ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b =
                next_b;
        }
        return (M(fabs)(fa) < M(fabs)(fb) ? a : b);
    }
    return PICK(3.141592653589793, 3.1415927f);
}

// has the sign of the slope of the boundary's alpha
static inline REAL boundary_slope(REAL theta, REAL l, REAL at_one, REAL at_minus_one,
    REAL loss, REAL together, REAL apart, REAL across) {
    const REAL t = R(2.0)*l + R(2.0), t2 = R(0.5)*theta, t3 = next_wave(t, t2).sine, t4 =
        M(tan)(t2);
    const REAL t5 = t4*t4, t6 = R(4.0)*t5, t7 = apart*t5, t8 = together - t7, t9 = at_minus_one*t5;
    const REAL t10 = at_one - t9, t11 = across*loss*t6 + t10*t8, t12 = next_wave(t, t2).cosine;
    const REAL t13 = R(2.0)*loss*t4*t8 - R(2.0)*across*t10*t4, t14 = across*across;
    const REAL t15 = t14*t6 + t8*t8, t16 = loss*loss, t17 = t10*t10 + t16*t6, t18 = t15*t17;
    const REAL t19 = t5 + R(1.0);
    return (t11*t3 + t12*t13)*(t18*(l + R(1.5)) + t19*
        (loss*t15*(at_one + t9) - across*t17*(t7 + together))) - t4*
        (R(0.5)*t18 + t19*(t15*(R(2.0)*t16 - at_minus_one*t10) - t17*(R(2.0)*t14 - apart*t8)))*
        (t11*t12 - t13*t3);
}

// the angle of the largest stiffness for a period and more
static inline REAL later_angle(REAL d, REAL l, REAL at_one, REAL at_minus_one,
    REAL loss, REAL together, REAL apart, REAL across) {
    const REAL turn_ = PICK(3.141592653589793, 3.1415927f)/(d + R(1.0));
    REAL count = R(1.0), found = R(0.0);
    for (int count_count = 0; count_count < 24; ++count_count) {
        if (count > R(24.0) || found > R(0.0)) { break; }
        const REAL rises = boundary_slope(PICK(0.041666666666666664, 0.041666668f)*count*turn_, l,
            at_one,
            at_minus_one, loss, together, apart, across);
        const REAL next_count = rises > R(0.0) ? count + R(1.0) : count;
        found = rises > R(0.0) ? R(0.0) : R(1.0); count = next_count;
    }
    if (found > R(0.0)) {
        const REAL high = PICK(0.041666666666666664, 0.041666668f)*count*turn_;
        const REAL low = M(fmax)(R(0.001)*high, PICK(0.041666666666666664, 0.041666668f)*turn_*
            (count - R(1.0)));
        const REAL above = boundary_slope(low, l, at_one, at_minus_one, loss, together, apart,
            across);
        if (above <= R(0.0)) { return low; }
        const REAL below = boundary_slope(high, l, at_one, at_minus_one, loss, together, apart,
            across);
        if (below >= R(0.0)) { return high; }
        REAL b = low, fb = above, a = high, fa = below, c = high, fc = below;
        for (int count_b = 0; count_b < 120; ++count_b) {
            if ((fa >= R(0.0) && fb >= R(0.0)) || (fa <= R(0.0) && fb <= R(0.0)) ||
                M(fabs)(a - b) <= PICK(4.440892098500626e-16, 2.3841858e-07f)*
                    M(fabs)(M(fabs)(fa) < M(fabs)(fb) ? a : b)) { break; }
            const REAL new_ = next_guess(b, fb, a, fa, c, fc,
                PICK(4.440892098500626e-16, 2.3841858e-07f));
            const REAL value = boundary_slope(new_, l, at_one, at_minus_one, loss, together,
                apart, across);
            const REAL same = (fa > R(0.0) && value > R(0.0)) || (fa < R(0.0) && value < R(0.0)) ?
                R(1.0) : R(0.0);
            const REAL next_b = same > R(0.0) ? b : a, next_fb = same > R(0.0) ? fb : fa;
            const REAL next_c = same > R(0.0) ? a : b;
            fc = same > R(0.0) ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b =
                next_b;
        }
        return (M(fabs)(fa) < M(fabs)(fb) ? a : b);
    }
    return NAN;
}

// the angle of the largest stiffness without delay
static inline REAL undelayed_angle(REAL at_one, REAL at_minus_one, REAL loss,
    REAL together, REAL apart) {
    const REAL k = end_slope(at_minus_one, loss, together, apart, R(0.0)), t = R(2.0)*apart;
    const REAL t2 = -together, t3 = R(2.0)*together, t4 = together*together;
    const REAL k2 = t3*((apart*apart)*at_one + together*(at_minus_one*(t + t2) + loss*t));
    const REAL base = -apart - t2;
    const REAL k3 = together*(at_minus_one*t4 + at_one*(base*base + t4) + loss*t3*
        (R(2.0)*together - apart));
    REAL above, below;
    if (k2 > R(0.0)) {
        const REAL discriminant = k2*k2 - R(4.0)*k*k3, root =
            M(sqrt)(M(fmax)(R(0.0), discriminant));
        above = k2 + root; below = M(fmax)(R(0.0), -R(2.0)*k);
    } else {
        const REAL discriminant = k2*k2 - R(4.0)*k*k3;
        if (discriminant < R(0.0)) {
            above = R(2.0)*k3; below = R(0.0);
        } else {
            const REAL root = M(sqrt)(M(fmax)(R(0.0), discriminant));
            above = R(2.0)*k3; below = root - k2;
        }
    }
    return R(2.0)*M(atan2)(M(sqrt)(above), M(sqrt)(below));
}

// the angle of the wall of largest stable stiffness, or NaN
static inline REAL max_stiffness_angle(REAL gamma, REAL delta, REAL d, REAL l,
    REAL part, REAL first, REAL last, REAL at_one, REAL at_minus_one, REAL loss,
    REAL together, REAL apart) {
    if ((d <= R(1.0) || M(sqrt)(gamma)*(d + R(1.0)) <= PICK(3.141592653589793, 3.1415927f)) &&
        gamma <= R(9.8)) {
        const REAL across = part == R(0.0) ? first : first - last;
        const REAL theta = d == R(0.0) ? undelayed_angle(at_one, at_minus_one, loss, together,
            apart) : (d < R(1.0) ? early_angle(at_one, at_minus_one, loss, together, apart, last) :
            later_angle(d, l, at_one, at_minus_one, loss, together, apart, across));
        const REAL t = next_wave(l, theta).sine, t2 = R(0.5)*theta, t3 = M(sin)(t2), t4 =
            M(cos)(t2);
        const REAL t5 = t4*t4, t6 = t3*t3, t7 = R(4.0)*t5*t6, t8 = t5*together - apart*t6;
        const REAL t9 = R(1.0)/((across*across)*t7 + t8*t8), t10 = at_one*t5 - at_minus_one*t6;
        const REAL t11 = R(2.0)*loss*t8 - R(2.0)*across*t10, t12 = across*loss*t7 + t10*t8;
        const REAL t13 = t9*next_wave(l, theta).cosine, t14 = -t*t12*t9/M(sin)(theta) - R(0.5)*t11*
            t13;
        const REAL stiffness = t*t11*t3*t4*t9 - t12*t13 - R(2.0)*t14*t6;
        REAL good;
        if (delta > R(0.0) && gamma > -stiffness && M(sqrt)(gamma)*
            (d + R(1.0)) <= PICK(3.141592653589793, 3.1415927f)) {
            good = R(1.0);
        } else {
            const REAL inside = PICK(0.9999999953433871, 0.9999237f)*stiffness -
                PICK(4.6566128730773926e-09, 7.6293945e-05f)*gamma;
            const REAL outside = part == R(0.0) ?
                whole_roots(inside, t14, l, first, last, gamma, at_minus_one, loss, together,
                apart) : fractional_roots(inside, t14, l, first, last, gamma, at_minus_one, loss,
                together, apart, first - last, delta);
            if (outside < R(0.0)) {
                const REAL inside2 = R(0.99609375)*stiffness - R(0.00390625)*gamma;
                const REAL outside2 = part == R(0.0) ?
                    whole_roots(inside2, t14, l, first, last, gamma, at_minus_one, loss, together,
                    apart) : fractional_roots(inside2, t14, l, first, last, gamma, at_minus_one,
                    loss, together, apart, first - last, delta);
                good = stable(outside2, inside2, t14, gamma, delta);
            } else {
                good = stable(outside, inside, t14, gamma, delta);
            }
        }
        if (good > R(0.0)) { return theta; }
    }
    return NAN;
}

// the damping that the wall requires at the angle theta, for a fractional delay
static inline REAL required_at(REAL alpha, REAL beta, REAL l, REAL epsilon,
    REAL theta) {
    const CosSin cossin = next_wave(l, theta);
    const REAL lift = M(fabs)(alpha) + M(fabs)(beta) < PICK(3.8725919148493183e-121,
        9.094947e-13f) ?
        PICK(6.668014432879854e+240, 1.2089258e+24f) : R(1.0);
    const REAL stiffness = alpha*lift, damping = beta*lift, half = R(0.5)*theta, up = M(sin)(half);
    const REAL along = M(cos)(half), twice = R(2.0)*epsilon;
    const Pair diff3 = pair_diff(wide_prod(R(0.5)*stiffness,
        pair_diff(pair_sum(pair_quot(two_prod(cossin.sine, along), (Pair){up, R(0.0)}),
        two_prod(twice, cossin.cosine)), (Pair){cossin.cosine, R(0.0)})),
        wide_prod(damping, pair_diff((Pair){cossin.cosine, R(0.0)},
        wide_prod(twice, wide_prod(up, pair_sum(two_prod(cossin.sine, along),
        two_prod(cossin.cosine, up)))))));
    const REAL n = diff3.hi + diff3.lo, base = R(2.0)*damping + stiffness;
    const REAL size = (along*along)*(stiffness*stiffness) + (base*base)*(up*up);
    const REAL extra = epsilon*size*(R(1.0) - epsilon), root = M(sqrt)(extra + n*n);
    const REAL whole = root + M(fabs)(n) == R(0.0) ? R(1.0) : root + M(fabs)(n), more = R(0.5)*
        extra/whole;
    const REAL rest = diff3.lo + more, whole_need = diff3.hi + rest;
    return (n < R(0.0) ? more : whole_need)/lift;
}

// what straight motions require at an angle, with a delay of k periods
static inline REAL straight_at(REAL stiffness, REAL damping, REAL k, REAL angle) {
    const REAL half = R(0.5)*angle;
    return rounded(pair_diff(wide_prod(stiffness,
        pair_quot((Pair){next_wave(R(2.0)*k, half).sine, R(0.0)},
            (Pair){R(2.0)*M(sin)(half), R(0.0)})),
        two_prod(damping, next_wave(k, angle).cosine)));
}

#ifndef SINGLE
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
#else
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
#endif

// sin(x)/x
static inline REAL sinc(REAL x) {
    if (M(fabs)(x) < R(1.0)) { return R(1.0) - (x*x)*gap(x); }
    return M(sin)(x)/x;
}

// the damping that the wall requires at the angle 2 psi
static inline REAL damping_at(REAL alpha, REAL beta, REAL l, REAL epsilon, REAL psi) {
    const REAL early = R(0.5)*alpha*(R(2.0)*l + R(1.0))*sinc(psi*(R(2.0)*l + R(1.0)))/sinc(psi) -
        beta*
        next_wave(l, R(2.0)*psi).cosine;
    if (epsilon == R(0.0)) { return early; }
    const REAL n = early + epsilon*(R(0.5)*alpha*(R(2.0)*l + R(3.0))*sinc(psi*(R(2.0)*l + R(3.0)))/
        sinc(psi) -
        beta*next_wave(l + R(1.0), R(2.0)*psi).cosine - early);
    const REAL base = M(sin)(psi), base2 = M(cos)(psi), base3 = alpha + R(2.0)*beta;
    const REAL root = M(sqrt)(epsilon*(R(1.0) - epsilon)*
        ((alpha*alpha)*(base2*base2) + (base*base)*(base3*base3)) + n*n);
    return R(0.5)*n + R(0.5)*root;
}

// (2 sin((k + 1) x) - (2 k + 2) sin(x) cos((k + 1) x))/x^3
static inline REAL chord(REAL k, REAL x) {
    const REAL turn_ = x*(k + R(1.0)), order = R(2.0)*k + R(2.0), along = next_wave(k, x).cosine;
    if (turn_ < R(1.5)) {
        const REAL wave = sinc(R(0.5)*turn_), inner = R(0.5)*(wave*wave) - gap(turn_);
        return order*(along*gap(x) + R(0.25)*inner*(order*order));
    }
    return (R(2.0)*next_wave(k, x).sine - along*order*M(sin)(x))/(x*x*x);
}

// has the sign of the slope of DampingAt, at a fraction
static inline REAL rising(REAL alpha, REAL beta, REAL l, REAL epsilon, REAL psi) {
    const REAL t = R(2.0)*psi, base = sinc(psi), t2 = R(2.0)*alpha/(base*base), t3 = R(0.5)*alpha +
        beta;
    const REAL t4 = R(2.0)*l, t5 = t4 + R(2.0), t6 = t4 + R(4.0);
    const REAL early = t3*(t5*t5)*sinc(psi*t5) - t2*chord(l, t);
    const REAL steep = early + epsilon*(-early - t2*chord(l + R(1.0), t) + t3*(t6*t6)*sinc(psi*t6));
    return R(2.0)*beta*epsilon*(R(1.0) - epsilon)*(alpha + beta)*sinc(R(2.0)*psi) + steep*
        damping_at(alpha, beta, l, epsilon, psi);
}

#ifndef SINGLE
// has the sign of the slope of DampingAt, up to the angle in phase
static inline double steepness(double alpha, double beta, double l, double epsilon, double psi) {
    if (epsilon == 0.0) {
        const double t = 2.0*l + 2.0, base = sinc(psi);
        return (t*t)*(0.5*alpha + beta)*sinc(psi*t) - 2.0*alpha*chord(l, 2.0*psi)/(base*base);
    }
    const double rising_ = rising(alpha, beta, l, epsilon, psi);
    const double phase = psi*(2.0*l + 2.0) + atan2(alpha*cos(psi), (alpha + 2.0*beta)*sin(psi)) +
        atan2(epsilon*sin(2.0*psi), epsilon*cos(2.0*psi) - epsilon + 1.0) - 3.141592653589793;
    return (phase > 0.0 ? -fabs(rising_) : rising_);
}
#else
// has the sign of the slope of DampingAt, up to the angle in phase
static inline float steepness(float alpha, float beta, float l, float epsilon, float psi) {
    if (epsilon == 0.0f) {
        const float t = 2.0f*l + 2.0f, base = sinc(psi);
        return (t*t)*(0.5f*alpha + beta)*sinc(psi*t) - 2.0f*alpha*chord(l, 2.0f*psi)/(base*base);
    }
    const float rising_ = rising(alpha, beta, l, epsilon, psi);
    const float phase = psi*(2.0f*l + 2.0f) +
        atan2f(alpha*cosf(psi), (alpha + 2.0f*beta)*sinf(psi)) +
        atan2f(epsilon*sinf(2.0f*psi), epsilon*cosf(2.0f*psi) - epsilon + 1.0f) - 3.1415927f;
    if (phase > 0.0f) { return -fabsf(rising_); }
    return rising_;
}
#endif

// half of the angle at which the wall requires most damping
static inline REAL worst_angle(REAL alpha, REAL beta, REAL l, REAL epsilon) {
    const REAL size = M(fabs)(alpha) + M(fabs)(beta), whole = size == R(0.0) ? R(1.0) : size;
    const REAL stiffness = alpha/whole, damping = beta/whole, low = R(0.0);
    const REAL above = steepness(stiffness, damping, l, epsilon, low);
    if (above <= R(0.0)) { return low; }
    const REAL high = PICK(3.141592653589793, 3.1415925f)/(R(2.0)*l + R(2.0));
    const REAL below = steepness(stiffness, damping, l, epsilon, high);
    if (below >= R(0.0)) { return high; }
    REAL b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if ((fa >= R(0.0) && fb >= R(0.0)) || (fa <= R(0.0) && fb <= R(0.0)) ||
            M(fabs)(a - b) <= PICK(4.656612873077393e-10, 7.6293945e-06f)*
                M(fabs)(M(fabs)(fa) < M(fabs)(fb) ? a : b)) { break; }
        const REAL new_ = next_guess(b, fb, a, fa, c, fc,
            PICK(4.656612873077393e-10, 7.6293945e-06f));
        const REAL value = steepness(stiffness, damping, l, epsilon, new_);
        const REAL same = (fa > R(0.0) && value > R(0.0)) || (fa < R(0.0) && value < R(0.0)) ?
            R(1.0) : R(0.0);
        const REAL next_b = same > R(0.0) ? b : a, next_fb = same > R(0.0) ? fb : fa;
        const REAL next_c = same > R(0.0) ? a : b;
        fc = same > R(0.0) ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (M(fabs)(fa) < M(fabs)(fb) ? a : b);
}

// the damping that the wall requires at its worst angle
static inline REAL largest_required_damping(REAL alpha, REAL beta, REAL d) {
    if (alpha < R(0.0)) { return INFINITY; }
    const REAL whole = M(floor)(d), part = d - whole;
    const REAL lift = M(fabs)(alpha) + M(fabs)(beta) < PICK(3.8725919148493183e-121,
        9.094947e-13f) ?
        PICK(6.668014432879854e+240, 1.2089258e+24f) : R(1.0);
    const REAL stiffness = alpha*lift, damping = beta*lift;
    return damping_at(stiffness, damping, whole, part,
        worst_angle(stiffness, damping, whole, part))/lift;
}

// early + share (late - early)
static inline REAL between(REAL share, REAL early, REAL late) {
    const REAL more = late - early;
    return early + more*share;
}

// negative beyond the angle in phase with the delay
static inline REAL lead(REAL theta, REAL l, REAL epsilon) {
    if (theta*(l + R(1.0)) < R(4.0)) {
        const REAL early = next_wave(l, theta).sine, late = next_wave(l + R(1.0), theta).sine;
        return early + epsilon*(late - early);
    }
    return -R(1.0);
}

// the value, NaN for number < 0
static inline REAL rated(REAL number, REAL value) {
    if (number < R(0.0)) { return NAN; }
    return value;
}

// ((2 k + 2) sin(x) - sin((2 k + 2) x))/x^3
static inline REAL spread(REAL k, REAL x) {
    const REAL turn_ = x*(k + R(1.0)), order = R(2.0)*k + R(2.0);
    if (turn_ < R(1.5)) { return order*((order*order)*gap(R(2.0)*turn_) - gap(x)); }
    return (order*M(sin)(x) - R(2.0)*next_wave(k, x).cosine*next_wave(k, x).sine)/(x*x*x);
}

// what straight motions require with an integer delay of k periods
static inline REAL straight(REAL stiffness, REAL damping, REAL k, REAL angle) {
    const REAL order = R(2.0)*k + R(1.0);
    return rounded(pair_diff(wide_prod(stiffness,
        pair_quot(two_prod(order, sinc(angle*order)), (Pair){R(2.0)*sinc(angle), R(0.0)})),
        two_prod(damping, next_wave(k, R(2.0)*angle).cosine)));
}

// has the sign of minus the slope of what the wall phi needs
static inline REAL turning(REAL phi, REAL l, REAL epsilon, REAL wave, REAL wave2,
    REAL wave3, REAL wave4, REAL wave5, REAL wave6, REAL wave7, REAL wave8,
    REAL wave9, REAL wave10, REAL wave11, REAL wave12) {
    const REAL t = M(sin)(phi), t2 = l + R(1.0), t3 = M(cos)(phi), t4 = t3/t2, t5 = R(0.5)*t4, t6 =
        t - t5;
    const REAL t7 = t6*wave5, t8 = R(2.0)*l, t9 = t5/wave7, t10 = t9*wave9*(t8 + R(1.0));
    const REAL t11 = epsilon*(R(1.0) - epsilon), t12 = R(2.0)*t4/(wave7*wave7), base = t8 + R(2.0);
    const REAL t13 = (base*base)*t*wave10 - t12*wave3;
    const REAL mean = epsilon*(-t10 - t6*wave6 + t7 + t9*wave11*(t8 + R(3.0))) + t10 - t7;
    const REAL base2 = t8 + R(4.0);
    return -R(2.0)*t11*t6*wave8*(t + t5) - (R(0.5)*mean + R(0.5)*
        M(sqrt)(mean*mean + t11*(R(4.0)*(t*t)*(wave*wave) + (t3*t3)*(wave2*wave2)/(t2*t2))))*
        (epsilon*((base2*base2)*t*wave12 - t12*wave4 - t13) + t13);
}

// the wall whose worst angle is 2 psi, as an angle
static inline REAL turn(REAL psi, REAL l, REAL epsilon) {
    const REAL wave = M(sin)(psi), wave2 = M(cos)(psi), wave3 = chord(l, R(2.0)*psi);
    const REAL wave4 = chord(l + R(1.0), R(2.0)*psi), wave5 = next_wave(l, R(2.0)*psi).cosine;
    const REAL wave6 = next_wave(l + R(1.0), R(2.0)*psi).cosine, wave7 = sinc(psi);
    const REAL wave8 = sinc(R(2.0)*psi), wave9 = sinc(psi*(R(2.0)*l + R(1.0)));
    const REAL wave10 = sinc(psi*(R(2.0)*l + R(2.0))), wave11 = sinc(psi*(R(2.0)*l + R(3.0)));
    const REAL wave12 = sinc(psi*(R(2.0)*l + R(4.0))), low = R(0.0);
    const REAL above = turning(low, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7,
        wave8, wave9, wave10, wave11, wave12);
    if (above <= R(0.0)) { return low; }
    const REAL high = R(0.5)*PICK(3.141592653589793, 3.1415927f);
    const REAL below = turning(high, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6, wave7,
        wave8, wave9, wave10, wave11, wave12);
    if (below >= R(0.0)) { return high; }
    REAL b = low, fb = above, a = high, fa = below, c = high, fc = below;
    for (int count_b = 0; count_b < 120; ++count_b) {
        if ((fa >= R(0.0) && fb >= R(0.0)) || (fa <= R(0.0) && fb <= R(0.0)) ||
            M(fabs)(a - b) <= PICK(4.440892098500626e-16, 2.3841858e-07f)*
                M(fabs)(M(fabs)(fa) < M(fabs)(fb) ? a : b)) { break; }
        const REAL new_ = next_guess(b, fb, a, fa, c, fc,
            PICK(4.440892098500626e-16, 2.3841858e-07f));
        const REAL value = turning(new_, l, epsilon, wave, wave2, wave3, wave4, wave5, wave6,
            wave7, wave8, wave9, wave10, wave11, wave12);
        const REAL same = (fa > R(0.0) && value > R(0.0)) || (fa < R(0.0) && value < R(0.0)) ?
            R(1.0) : R(0.0);
        const REAL next_b = same > R(0.0) ? b : a, next_fb = same > R(0.0) ? fb : fa;
        const REAL next_c = same > R(0.0) ? a : b;
        fc = same > R(0.0) ? fa : fb; c = next_c; fa = value; a = new_; fb = next_fb; b = next_b;
    }
    return (M(fabs)(fa) < M(fabs)(fb) ? a : b);
}

// the wall whose worst angle is theta, as an angle, or NaN
static inline REAL touching(REAL theta, REAL l, REAL epsilon) {
    const REAL found = turn(R(0.5)*theta, l, epsilon);
    if (found < R(0.5)*PICK(3.141592653589793, 3.1415927f)) { return found; }
    return NAN;
}

// whether a larger angle allows less stiffness, at a fraction
static inline REAL passive_slope(REAL theta, REAL l, REAL epsilon) {
    const CosSin cossin = next_wave(l, theta), cossin2 = next_wave(l + R(1.0), theta);
    const REAL up = epsilon*(cossin2.sine - cossin.sine) + cossin.sine;
    const REAL along = cossin.cosine + epsilon*(cossin2.cosine - cossin.cosine);
    return (R(1.0) - up)*M(cos)(theta) + (along*(epsilon + l + R(1.0)) - epsilon*(R(1.0) - epsilon)*
        (cossin.cosine - cossin2.cosine))*M(sin)(theta);
}

#ifndef SINGLE
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
#else
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
#endif

void NAME(discretize)(REAL gamma, REAL delta, REAL *n1_out, REAL *n0_out, REAL *a_out,
    REAL *e_out) {
    if (!(delta >= R(0.0) && delta <= PICK(1e+70, 1e+08f) && gamma >= R(0.0) &&
        gamma <= PICK(1e+15, 1e+07f))) {
        *n1_out = NAN; *n0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    const Device device = device_n0_n1_trace(gamma, delta);
    *n1_out = device.n1; *n0_out = device.n0; *a_out = device.trace; *e_out = M(exp)(-delta);
}

void NAME(discretize_fractional)(REAL gamma, REAL delta, REAL epsilon, REAL *m2_out,
    REAL *m1_out, REAL *m0_out, REAL *a_out, REAL *e_out) {
    if (!(delta >= R(0.0) && delta <= PICK(1e+70, 1e+08f) && epsilon >= R(0.0) &&
        epsilon < R(1.0) && gamma >= R(0.0) &&
        gamma <= PICK(1e+15, 1e+07f))) {
        *m2_out = NAN; *m1_out = NAN; *m0_out = NAN; *a_out = NAN; *e_out = NAN; return;
    }
    const Device2 device = device_together_trace(gamma, delta);
    const REAL t0 = R(1.0) - epsilon, t1 = t0*t0, t2 = delta*t0, n1 = plant_n1(gamma*t1, t2);
    const REAL t3 = n1*t1, t4 = epsilon*epsilon, n0 = plant_n0(gamma*t4, delta*epsilon);
    const REAL t5 = n0*t4*M(exp)(-t2);
    *m2_out = t3; *m1_out = device.together - t3 - t5; *m0_out = t5; *a_out = device.trace;
    *e_out = M(exp)(-delta);
}

bool NAME(is_stable)(REAL alpha, REAL beta, REAL gamma, REAL delta, REAL d) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && M(fabs)(alpha) <= PICK(1e+70, 1e+08f) &&
        M(fabs)(beta) <= PICK(1e+70, 1e+08f) && gamma >= R(0.0) && gamma <= PICK(1e+15, 1e+07f))) {
        return false;
    }
    const Device3 device = device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta);
    const REAL whole = M(floor)(d), part = d - whole, t1 = delta*decay(delta);
    const REAL t3 = delta*device.n_gap;
    if (part == R(0.0)) {
        return stable(whole_roots(alpha, beta, d, device.n1, device.n0, gamma, device.at_minus_one,
            t1, device.together, t3), alpha, beta, gamma, delta) > R(0.0);
    }
    const Delayed delayed = late_device(gamma, delta, part);
    return stable(fractional_roots(alpha, beta, whole, delayed.m2, delayed.m0, gamma,
        device.at_minus_one, t1, device.together, delayed.apart, R(0.5)*device.kick*
        (delta*delayed.m2 + R(2.0)*delayed.kicked) + R(0.5)*delayed.m2*
            (gamma*device.together + t1) - R(0.5)*
        device.together + R(0.5)*t3, delta), alpha, beta, gamma, delta) > R(0.0);
}

REAL NAME(unstable_roots)(REAL alpha, REAL beta, REAL gamma, REAL delta, REAL d) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && M(fabs)(alpha) <= PICK(1e+70, 1e+08f) &&
        M(fabs)(beta) <= PICK(1e+70, 1e+08f) && gamma >= R(0.0) && gamma <= PICK(1e+15, 1e+07f))) {
        return -R(1.0);
    }
    const Device3 device = device_at_minus_one_kick_together_n_gap_n0_n1(gamma, delta);
    const REAL whole = M(floor)(d), part = d - whole, t1 = delta*decay(delta);
    const REAL t3 = delta*device.n_gap;
    if (part == R(0.0)) {
        return whole_roots(alpha, beta, d, device.n1, device.n0, gamma, device.at_minus_one, t1,
            device.together, t3);
    }
    const Delayed delayed = late_device(gamma, delta, part);
    return fractional_roots(alpha, beta, whole, delayed.m2, delayed.m0, gamma, device.at_minus_one,
        t1, device.together, delayed.apart, R(0.5)*device.kick*
        (delta*delayed.m2 + R(2.0)*delayed.kicked) + R(0.5)*delayed.m2*
            (gamma*device.together + t1) - R(0.5)*
        device.together + R(0.5)*t3, delta);
}

void NAME(stability_boundary)(REAL theta, REAL gamma, REAL delta, REAL d,
    REAL *alpha_out, REAL *beta_out) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && gamma >= R(0.0) &&
        gamma <= PICK(1e+15, 1e+07f) && theta > R(0.0) &&
            theta <= PICK(3.141592653589793, 3.1415925f))) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const Device5 device = device_at_minus_one_kick_together_n_gap(gamma, delta);
    const REAL whole = M(floor)(d);
    const CosSin cossin = next_wave(whole, theta);
    const REAL part = d - whole, t2 = R(0.5)*theta, t4 = gamma*device.together;
    const REAL t6 = delta*decay(delta), t7 = delta*device.n_gap;
    REAL t10, t12;
    if (part == R(0.0)) {
        t10 = t7; t12 = device.together + t7;
    } else {
        const Delayed delayed = late_device(gamma, delta, part);
        t10 = delayed.apart;
        t12 = device.kick*(delta*delayed.m2 + R(2.0)*delayed.kicked) + delayed.m2*(t4 + t6) -
            device.together + t7;
    }
    const Response response = ahead_in_phase(t2, t4, device.at_minus_one, t6, device.together, t10,
        t12);
    const REAL t16 = response.ahead*cossin.cosine + response.in_phase*cossin.sine;
    *alpha_out = response.ahead*cossin.sine - cossin.cosine*response.in_phase + t16*M(tan)(t2);
    *beta_out = -t16/M(sin)(theta);
}

void NAME(max_stable_stiffness)(REAL gamma, REAL delta, REAL d, REAL *alpha_out,
    REAL *beta_out, REAL *theta_out) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && gamma >= R(0.0) &&
        gamma <= PICK(1e+15, 1e+07f))) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const Device6 device = device_at_minus_one_together_n_gap_n0_n1(gamma, delta);
    const REAL whole = M(floor)(d), part = d - whole, t1 = gamma*device.together;
    const REAL t3 = delta*decay(delta), t16 = R(2.0)*t3;
    if (part == R(0.0)) {
        const REAL t4 = delta*device.n_gap;
        const REAL t5 = max_stiffness_angle(gamma, delta, d, d, R(0.0), device.n1, device.n0, t1,
            device.at_minus_one, t3, device.together, t4);
        const CosSin cossin = next_wave(d, t5);
        const REAL t7 = R(0.5)*t5, t8 = M(sin)(t7), t9 = M(cos)(t7), t10 = device.together + t4;
        const REAL t11 = t9*t9, t12 = t8*t8, t13 = t11*t12, t14 = device.together*t11 - t12*t4;
        const REAL t15 = R(1.0)/((t10*t10)*t13 + t14*t14), t17 = t1*t11 - device.at_minus_one*t12;
        const REAL t18 = t14*t16 - t10*t17, t19 = t10*t13*t16 + t14*t17, t20 = cossin.cosine*t15;
        const REAL t21 = -cossin.sine*t15*t19/M(sin)(t5) - R(0.5)*t18*t20;
        *alpha_out = cossin.sine*t15*t18*t8*t9 - R(2.0)*t12*t21 - t19*t20; *beta_out = t21;
        *theta_out = t5; return;
    }
    const Delayed delayed = late_device(gamma, delta, part);
    const REAL t27 = max_stiffness_angle(gamma, delta, d, whole, part, delayed.m2, delayed.m0,
        t1, device.at_minus_one, t3, device.together, delayed.apart);
    const CosSin cossin2 = next_wave(whole, t27);
    const REAL t28 = R(0.5)*t27, t29 = M(sin)(t28), t30 = M(cos)(t28), t32 = t30*t30, t33 = t29*t29;
    const REAL t34 = device.together*t32 - delayed.apart*t33;
    const REAL t35 = R(2.0)*delayed.m2 - R(2.0)*delayed.m0, t36 = t32*t33;
    const REAL t37 = R(1.0)/(t34*t34 + (t35*t35)*t36), t38 = t1*t32 - device.at_minus_one*t33;
    const REAL t39 = t16*t34 - t35*t38, t40 = t16*t35*t36 + t34*t38, t41 = cossin2.cosine*t37;
    const REAL t42 = -cossin2.sine*t37*t40/M(sin)(t27) - R(0.5)*t39*t41;
    *alpha_out = cossin2.sine*t29*t30*t37*t39 - R(2.0)*t33*t42 - t40*t41; *beta_out = t42;
    *theta_out = t27;
}

REAL NAME(passivity_margin_at)(REAL theta, REAL alpha, REAL beta, REAL delta, REAL d) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && M(fabs)(alpha) <= PICK(1e+70, 1e+08f) &&
        M(fabs)(beta) <= PICK(1e+70, 1e+08f) && theta > R(0.0) &&
            theta <= PICK(3.141592653589793, 3.1415925f))) {
        return NAN;
    }
    const REAL whole = M(floor)(d), part = d - whole;
    if (part == R(0.0)) { return delta - straight_at(alpha, beta, d, theta); }
    return delta - required_at(alpha, beta, whole, part, theta);
}

REAL NAME(passivity_margin)(REAL alpha, REAL beta, REAL delta, REAL d) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && M(fabs)(alpha) <= PICK(1e+70, 1e+08f) &&
        M(fabs)(beta) <= PICK(1e+70, 1e+08f))) {
        return NAN;
    }
    return delta - largest_required_damping(alpha, beta, d);
}

void NAME(passivity_boundary)(REAL theta, REAL delta, REAL d, REAL *alpha_out,
    REAL *beta_out) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && theta > R(0.0) &&
        theta <= PICK(3.141592653589793, 3.1415925f))) {
        *alpha_out = NAN; *beta_out = NAN; return;
    }
    const REAL whole = M(floor)(d), part = d - whole, t2 = R(0.5)*theta;
    if (part == R(0.0)) {
        const REAL t0 = lead(theta, d, R(0.0)), t1 = delta/spread(d, theta), t15 = sinc(t2);
        const REAL sine = next_wave(d, theta).sine, t3 = sine*(t15*t15)*(d + R(1.0))/theta;
        *alpha_out = rated(t0, R(2.0)*t1*t3); *beta_out =
            rated(t0, t1*(chord(d, theta) - t3)); return;
    }
    const REAL t6 = lead(theta, whole, part), t7 = whole + R(1.0), t8 =
        touching(theta, whole, part);
    const REAL t9 = M(cos)(t8), t10 = t9/t7, t11 = M(sin)(t8), t12 = t11 - R(0.5)*t10;
    const REAL t13 = between(part, straight(t10, t12, whole, t2), straight(t10, t12, t7, t2));
    const REAL t16 = M(sin)(t2), t17 = M(cos)(t2);
    const REAL t14 = delta/(R(0.5)*t13 + R(0.5)*
        M(sqrt)(part*(R(1.0) - part)*(R(4.0)*(t11*t11)*(t16*t16) + (t17*t17)*(t9*t9)/(t7*t7)) + t13*
            t13));
    *alpha_out = rated(t6, t10*t14); *beta_out = rated(t6, t12*t14);
}

void NAME(max_passive_stiffness)(REAL delta, REAL d, REAL *alpha_out, REAL *beta_out,
    REAL *theta_out) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f))) {
        *alpha_out = NAN; *beta_out = NAN; *theta_out = NAN; return;
    }
    const REAL whole = M(floor)(d), part = d - whole, t3 = R(2.0)*delta;
    if (part == R(0.0)) {
        const REAL t0 = d + R(1.0), t1 = PICK(3.141592653589793, 3.1415927f)/t0, t2 =
            M(tan)(R(0.25)*t1), t4 = R(0.5)*t1;
        *alpha_out = t2*t3; *beta_out = delta*(R(1.0)/(t0*M(sin)(t4)) - t2); *theta_out =
            t4; return;
    }
    const REAL t7 = passive_angle(whole, part);
    const CosSin cossin = next_wave(whole, t7);
    const REAL t9 = whole + R(1.0);
    const CosSin cossin2 = next_wave(t9, t7);
    const REAL t10 = cossin.cosine + part*(cossin2.cosine - cossin.cosine), t12 = R(0.5)*t7;
    const REAL t13 = M(sin)(t12), t14 = t13*t13, t15 = R(2.0)*whole, t16 = t15 + R(2.0);
    const REAL sine_2 = next_wave(t16, t12).sine, t17 = R(2.0)*sine_2*t13;
    const REAL t18 = (t10*t17 + t14*(R(4.0)*part + R(4.0)*whole + R(4.0)))/
        (t10*M(cos)(t7) + (part + t9)*(part*(cossin2.sine - cossin.sine) + cossin.sine + R(1.0))*
            M(sin)(t7));
    const REAL t19 = R(2.0)*part;
    *alpha_out = t18*t3; *beta_out = delta*(t17 - t18*(t14*(t15 + t19) + R(1.0)))/(t14*(t16 + t19));
    *theta_out = t7;
}

REAL NAME(linear_limit)(REAL beta, REAL delta, REAL d) {
    if (!(d >= R(0.0) && d <= PICK(1e+15, 1e+06f) && delta >= R(0.0) &&
        delta <= PICK(1e+70, 1e+08f) && M(fabs)(beta) <= PICK(1e+70, 1e+08f))) {
        return NAN;
    }
    return (beta + delta)/(d + R(0.5));
}

void NAME(late_device)(REAL gamma, REAL delta, REAL part, REAL *apart_out, REAL *m2_out,
    REAL *kicked_out, REAL *m0_out) {
    const Delayed found = late_device(gamma, delta, part);
    *apart_out = found.apart;
    *m2_out = found.m2;
    *kicked_out = found.kicked;
    *m0_out = found.m0;
}
