/* Counts roots outside the unit circle in plain doubles, where a bound of the errors allows it.
 *
 * A Ball is a double with a bound of its error.  Each operation adds its own rounding to the bounds
 * that it was given, so that a verdict that is certain is proved by the rules below, each of which
 * `tests/kernels/test_filter.py` checks against fractions.  The bounds themselves are sums and
 * products of positive doubles, so they are too small by 2^-40 at most: SLACK covers it.
 *
 * The algorithm is that of chapter s4d_roots_counted, for the loops that occur most: a slow device
 * (2 delta + gamma <= 4) that is stronger than the wall at z = -1.  Everything else is unknown here.
 * There are no branches, so that compilers vectorise the loops over blocks of walls. */
#ifndef FILTER_H
#define FILTER_H

#include <cmath>

namespace filter {

constexpr int BLOCK = 256;
constexpr int NUMBERS = 14; /* of a device: seven balls */
constexpr double UNKNOWN = -1;  /* more than doubles can tell */
constexpr double UNSTABLE = -2; /* at least one root is outside */
constexpr double TWICE = -3;    /* the wall is the stronger one between two angles */

constexpr double U = 0x1p-53;
constexpr double SLACK = 1 + 0x1p-30;
constexpr double PI = 3.141592653589793;

/* Walls that are counted together. */
struct Block {
    double alpha[BLOCK], beta[BLOCK], gamma[BLOCK], delta[BLOCK], steps[BLOCK], part[BLOCK];
    double device[NUMBERS][BLOCK];
    double found[BLOCK];
};

/* Counts the roots of the first n walls; `once` where they have one device and one delay. */
void counted(Block &walls, int n, bool fraction, bool once);

/* About the largest delay of a loop, below which no root comes back; NaN where that is not proved,
 * and if it is next to 0. */
double largest_delay(double alpha, double beta, double gamma, double delta);

#ifdef _MSC_VER
#define INLINE static __forceinline
#else
#define INLINE static inline __attribute__((always_inline))
#endif

struct Ball {
    double v, e;
};

INLINE double size(double x) { return std::fabs(x); }
INLINE Ball exact(double x) { return {x, 0}; }
INLINE Ball operator-(Ball a) { return {-a.v, a.e}; }
INLINE Ball operator+(Ball a, Ball b) {
    const double v = a.v + b.v;
    return {v, a.e + b.e + U*size(v)};
}
INLINE Ball operator-(Ball a, Ball b) { return a + -b; }
INLINE Ball operator*(Ball a, Ball b) {
    const double v = a.v*b.v;
    return {v, size(a.v)*b.e + (size(b.v) + b.e)*a.e + U*size(v)};
}
INLINE Ball operator*(double a, Ball b) {
    const double v = a*b.v;
    return {v, size(a)*b.e + U*size(v)};
}
INLINE Ball operator/(Ball a, Ball b) {
    const double v = a.v/b.v, least = size(b.v) - SLACK*b.e;
    return {v, least > 0 ? (a.e + size(v)*b.e)/least + U*size(v) : INFINITY};
}
INLINE Ball root(Ball a) {
    const double v = std::sqrt(a.v);
    return {v, a.v > SLACK*a.e ? a.e/v + U*v : INFINITY};
}
INLINE double least(Ball a) { return size(a.v) - SLACK*a.e; } /* positive: the sign is certain */
INLINE double lower(Ball a) { return a.v - SLACK*a.e; }

/* The sampled device: M(1), M(-1), m2 + m0, m2 - m0, m2 m0, 1 - e and A(-1). */
struct Device {
    Ball force, apart, sums, gap, both, loss, far;
};

/* Terms of the device's step response; each is at most 2^(k-2)/k! where 2 delta + gamma <= 4. */
constexpr int TERMS = 24;

/* The device behind a fraction of a period; what m2 and m0 change by with it goes to `slopes`. */
template <bool fraction>
INLINE Device device(double gamma, double delta, double part, Ball *slopes = nullptr) {
    const double near = 1 - part, share = 0.25*(2*delta + gamma);
    double before = 0, now = 0.5, power = near;
    double way = 0.5, speed = 1, early = 0, fast = 0;
    if (fraction) early = 0.5*near*near, fast = near;
#pragma GCC unroll 24
    for (int k = 3; k <= TERMS; ++k) {
        const double next = -(delta*(1.0/k*now) + gamma*(1.0/(k*(k - 1))*before));
        before = now, now = next;
        way += now, speed += k*now;
        if (fraction) {
            power *= near; /* near^(k - 1) */
            const double term = now*power;
            early += term*near, fast += k*term;
        }
    }
    const double off_way = U*(16 + 32*share), off_speed = U*(32 + 96*share);
    const Ball n1 = {way, off_way}, kick = {speed, off_speed};
    const Ball drag = delta*kick, spring = gamma*n1, fall = drag + spring;
    const Ball force = kick*kick + n1*fall;
    const Ball twice = {2*n1.v, 2*n1.e}, plain = twice - force; /* M(-1) without a fraction */
    const Ball loss = drag + gamma*plain;
    const Ball far = exact(4) - fall - spring - loss;
    if (!fraction) return {force, plain, n1, n1, exact(0), loss, far};
    const Ball m2 = {early, off_way}, old_way = n1 - m2;
    const Ball near_speed = {fast, off_speed}, old_speed = kick - near_speed;
    const Ball m0 = kick*old_speed - (exact(1) - fall)*old_way;
    if (slopes) {
        slopes[0] = -near_speed;
        slopes[1] = kick*(exact(1) - delta*near_speed - gamma*m2) - (exact(1) - fall)*near_speed;
    }
    const Ball sums = m2 + m0;
    return {force, Ball{2*sums.v, 2*sums.e} - force, sums, m2 - m0, m2*m0, loss, far};
}

/* atan(x)/x for 0 <= x <= 1 as a polynomial of x^2, within FAR_ATAN of atan with its roundings. */
constexpr double ATAN[] = {
    0.9999999999999925, -0.3333333333289398, 0.19999999957481826, -0.142857126460504,
    0.11111077584971772, -0.09090489647799033, 0.07688811662401294, -0.06646145790221254,
    0.05794192316881845, -0.04977996675955047, 0.04051778977125066, -0.029589012194344372,
    0.018198570485395787, -0.008792435542217635, 0.0030659957028108006, -0.0006774105399645076,
    7.063142635888046e-05};
constexpr double OFF_ATAN = 0x1p-46;

INLINE double arctangent(double up, double along) { /* of up >= 0, in the right half plane */
    const double one = size(up), two = size(along), steep = one > two ? one : two;
    const double flat = one > two ? two : one, x = flat/steep, square = x*x;
    double sum = ATAN[16];
#pragma GCC unroll 16
    for (int k = 15; k >= 0; --k) sum = sum*square + ATAN[k];
    const double angle = x*sum, turned = one > two ? PI/2 - angle : angle;
    const double around = along < 0 ? PI - turned : turned;
    return up < 0 ? -around : around;
}

/* What a loop has besides its device. */
struct Wall {
    double alpha, slope_sign, steps;
    Ball slope;
};

/* |A|^2 - |M W|^2 by powers of y = 2 - 2 cos(theta). */
struct Surplus {
    Ball c0, c1, c2, c3;
};

template <bool fraction> INLINE double value(const Surplus &c, double y) {
    return ((fraction ? c.c3.v*y : 0) + c.c2.v)*y*y + c.c1.v*y + c.c0.v;
}
template <bool fraction> INLINE double slope(const Surplus &c, double y) {
    return ((fraction ? 3*c.c3.v*y : 0) + 2*c.c2.v)*y + c.c1.v;
}

INLINE Ball across(const Device &x) { return x.gap*x.gap - x.force*x.sums; }

template <bool fraction>
INLINE Surplus surplus(const Device &x, Ball cross, double alpha, double beta, double gamma) {
    const Ball slope_ = exact(alpha) + exact(beta), force = beta*slope_;
    const Ball e = exact(1) - x.loss, at_one = gamma*x.force, push = exact(alpha)*exact(alpha);
    const Ball top = x.force*x.force;
    Surplus c;
    c.c0 = ((exact(gamma) - exact(alpha))*(exact(gamma) + exact(alpha)))*top;
    c.c1 = x.loss*x.loss - (exact(1) + e)*at_one - cross*push - top*force;
    c.c2 = e - cross*force;
    c.c3 = exact(0);
    if (fraction) {
        c.c2 = c.c2 - x.both*push;
        c.c3 = -(x.both*force);
    }
    return c;
}

/* How far from y a crossing is at most. */
template <bool fraction>
INLINE double reach(const Surplus &c, double y, double side, bool &known) {
    const Ball at = exact(y);
    const Ball square = fraction ? (c.c3*at + c.c2)*at : c.c2*at;
    const Ball left = (square + c.c1)*at + c.c0;
    const Ball steep = (fraction ? (3*c.c3*at + 2*c.c2)*at : 2*c.c2*at) + c.c1;
    const double bend = 2*(size(c.c2.v) + c.c2.e) + (fraction ? 24*(size(c.c3.v) + c.c3.e) : 0);
    const double rise = 1/lower(side*steep), off = 1.25*SLACK*(size(left.v) + left.e)*rise;
    /* the slope falls by no more than a fifth within off, so a zero is there */
    known = known & (rise > 0) & (5*SLACK*off*bend*rise <= 1);
    return off;
}

/* Turns of p next to a crossing near y, and whether they are certain. */
template <bool fraction>
INLINE double turns(const Device &x, const Wall &w, const Surplus &c, Ball start, double y,
                    double side, bool &known) {
    const double off = reach<fraction>(c, y, side, known);
    const double rest = 4 - y, edge = y < rest ? y : rest;
    known = known & (edge > 0) & (off <= 0x1p-7*edge);
    const double inner = y*rest > 0 ? y*rest : 1, root = std::sqrt(inner), per = 1/root;
    /* sin(theta) and theta change by 1.02 off/root; roundings beside */
    const double away = off*per;
    const Ball half = {0.5*y, 0.5*off};
    const Ball sine = {0.5*root, 1.02*away + 4*U*root};
    const Ball m_real = x.force - x.sums*half, m_up = x.gap*sine;
    const Ball w_real = exact(w.alpha) - w.slope*half, w_up = w.slope*sine;
    const Ball a_real = start - (exact(2) - x.loss)*half, a_up = x.loss*sine;
    known = known & (lower(m_real) > 0);
    /* W and A turned by half a turn where they point to the left */
    const double w_turn = w_real.v < 0 ? -1 : 1, a_turn = a_real.v < 0 ? -1 : 1;
    const Ball real = m_real*w_real - m_up*w_up, up = m_real*w_up + m_up*w_real;
    const double p_real = w_turn*real.v, p_up = w_turn*up.v;
    known = known & ((p_real >= 0) | (least(up) > 0));
    const double p_turn = p_real < 0 ? -1 : 1, turn = w_turn*p_turn*a_turn;
    const Ball q_real = real*a_real + up*a_up, q_up = up*a_real - real*a_up;
    known = known & ((turn*q_real.v > 0) | (least(q_up) > 0));
    const double most = size(q_real.v) > size(q_up.v) ? size(q_real.v) : size(q_up.v);
    const double ratio = SLACK*(q_real.e + q_up.e)/most;
    known = known & (ratio <= 0.25);
    const double halves = (w_real.v < 0 ? w.slope_sign : 0)
                        + (p_real < 0 ? (p_up < 0 ? -1.0 : 1.0) : 0) - (a_real.v < 0 ? 1 : 0);
    const double theta = 2*arctangent(std::sqrt(y > 0 ? y : 1), std::sqrt(rest > 0 ? rest : 1));
    const double delayed = (w.steps + 2)*theta;
    const double phase = PI*halves + arctangent(turn*q_up.v, turn*q_real.v) - delayed;
    const double miss = 1.1*ratio + (w.steps + 2)*(1.02*away + 2*OFF_ATAN) + OFF_ATAN
                      + 8*U*(delayed + 16);
    const double shift = 0x1.8p52, found = (phase/(2*PI) + shift) - shift;
    known = known & (PI - size(phase - 2*PI*found) > 1.01*miss + 8*U*(delayed + 16));
    return found;
}

/* Where the surplus vanishes, about: at `high`, or if the device is stronger at 1 at both. */
struct Shape {
    bool bent, clear, twice;
    double high, low;
};

template <bool fraction> INLINE Shape shape(const Surplus &c, bool stronger) {
    const Ball last = fraction ? c.c2 + 12*c.c3 : c.c2;
    /* bent one way from 0 to 4: one crossing if the wall leads at 1, else none or two */
    const bool up = (lower(c.c2) > 0) & (lower(last) > 0);
    const bool down = (lower(-c.c2) > 0) & (lower(-last) > 0);
    /* plain Newton steps: what they find is checked */
    const double discriminant = c.c1.v*c.c1.v - 4*c.c0.v*c.c2.v;
    const double root = std::sqrt(discriminant > 0 ? discriminant : 0);
    const double sum = size(c.c1.v) + root, whole = sum > 0 ? sum : 1;
    double high = c.c1.v < 0 ? sum/(2*c.c2.v) : -2*c.c0.v/whole, low = 2*c.c0.v/whole;
    double bottom = -c.c1.v/(2*c.c2.v);
    if (fraction) {
#pragma GCC unroll 4
        for (int k = 0; k < 4; ++k) {
            high -= value<true>(c, high)/slope<true>(c, high);
            low -= value<true>(c, low)/slope<true>(c, low);
            bottom -= slope<true>(c, bottom)/(6*c.c3.v*bottom + 2*c.c2.v);
        }
    }
    const Ball at = exact(bottom);
    const Ball under = ((fraction ? (c.c3*at + c.c2) : c.c2)*at + c.c1)*at + c.c0;
    const Ball tilt = (fraction ? (3*c.c3*at + 2*c.c2) : 2*c.c2)*at + c.c1;
    /* the device leads everywhere: the surplus is above its tangent */
    const double above = under.v - SLACK*(under.e + 4*(size(tilt.v) + tilt.e));
    const bool between = (bottom >= 0) & (bottom <= 4);
    const bool clear = stronger & (down | (lower(c.c1) > 0) | (between & (above > 0)));
    const bool twice = stronger & up & between & (lower(-under) > 0);
    return {bool(up | down), clear, twice, high, low};
}

/* Whether the device is slow, and no product underflows. */
INLINE bool plain(double alpha, double beta, double gamma, double delta) {
    const double most = 0x1p20, some = 0x1p-60;
    const double strong = size(alpha) > size(beta) ? size(alpha) : size(beta);
    const auto told = [&](double v) { return (v == 0) | ((size(v) >= some) & (size(v) <= most)); };
    return told(alpha) & told(beta) & (gamma >= 0) & (delta >= 0) & (strong > 0)
           & ((gamma == 0) | (gamma >= some)) & ((delta == 0) | (delta >= some))
           & (2*delta + gamma <= 4);
}

/* Roots outside the circle, or UNKNOWN or UNSTABLE; TWICE for two crossings, unless `both`. */
template <bool fraction, bool both>
INLINE double count(const Device &x, double alpha, double beta, double gamma, double delta,
                    double steps) {
    bool known = plain(alpha, beta, gamma, delta) & (steps <= 0x1p20) & (steps >= 0);
    const bool pulled = known & (alpha < -gamma);
    const Ball slope_ = exact(alpha) + exact(beta), far = slope_ + exact(beta);
    known = known & (slope_.v != 0) & (size(alpha) != gamma);
    const Ball pull = x.apart*far, at_one = gamma*x.force;
    known = known & (x.far.v - size(pull.v) > SLACK*(x.far.e + pull.e)); /* the device leads at -1 */
    const Surplus c = surplus<fraction>(x, across(x), alpha, beta, gamma);
    const bool stronger = gamma > size(alpha);
    const Shape at = shape<fraction>(c, stronger);
    known = known & at.bent;
    const Wall w = {alpha, slope_.v < 0 ? -1.0 : 1.0, steps, slope_};
    bool above_ = known, below = known;
    const double second = turns<fraction>(x, w, c, at_one, at.high, 1, above_);
    double first = 0;
    if (both) first = turns<fraction>(x, w, c, at_one, at.low, -1, below);
    const double found = 2*((both & at.twice ? first : 0) - second);
    const bool crossed = above_ & (found >= 0) & ((!stronger) | (at.twice & below & both));
    const double open = !both & known & at.twice ? TWICE : UNKNOWN;
    const double behind = crossed ? found : open, told = known & at.clear ? 0 : behind;
    return pulled ? UNSTABLE : told;
}

} // namespace filter
#endif
