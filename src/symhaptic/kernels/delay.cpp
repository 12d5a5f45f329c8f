/* The largest delay of a loop, where bounds prove that the root found is the first that leaves.
 *
 * A root at z moves with the delay d by d(ln z) = h/(l + 2 - Z): h is the logarithmic derivative of
 * M by the fraction of the period, Z that of M W/A by ln z, and l has the whole periods.  In a part
 * of the period all of these are balls around their values in its middle, with the angle at which
 * plant and wall are equally strong.  The real part of h conj(l + 2 - Z) is linear in l: its sign at
 * both ends of l tells whether roots leave or come back there at all delays between.  They have to
 * leave at the larger angle and to come back at the smaller one, if there are two. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("no-trapping-math", "no-math-errno")
#endif

#include "filter.h"

namespace filter {
namespace {

struct Loop {
    double alpha, beta, gamma, delta;
    bool stronger; /* the device, at z = 1 */
    Ball slope;
};

/* A number whose slope in the middle is so large and changes by at most `bend` a period. */
INLINE void widen(Ball &x, Ball &slope, double half, double bend) {
    x.e += half*(size(slope.v) + slope.e + 0.5*half*bend);
    slope.e += half*bend;
}

/* The device in a part of the period, and what its numbers change by there. */
struct Part {
    Device x;
    Ball gap;         /* of D = m2 - m0 */
    Ball cross, tilt; /* D^2 - N S, with S = m2 + m0, and what it changes by */
    Ball twist;       /* S' D - D' S */
};

/* m2'' = g'(1 - part) and m0'' = exp(-delta (1 - part)) (delta g + g')(part) of the impulse response
 * g are at most 1, and at least 1 - delta - gamma/2; g itself is at least 0 and at most the time. */
Part part_of(const Loop &w, double middle, double half) {
    Ball slopes[2];
    Part p;
    p.x = device<true>(w.gamma, w.delta, middle, slopes);
    Ball sums = slopes[0] + slopes[1];
    p.gap = slopes[0] - slopes[1], p.cross = across(p.x);
    p.tilt = 2*(p.x.gap*p.gap) - p.x.force*sums, p.twist = sums*p.x.gap - p.gap*p.x.sums;
    const double slow = w.delta + 0.5*w.gamma, bend = slow < 2 ? slow : 2;
    const Ball fast = {2 - bend, bend}, even = {0, bend}; /* S'' and D'' */
    widen(p.x.sums, sums, half, 2);
    widen(p.x.gap, p.gap, half, bend);
    const Ball turn = 2*(p.gap*p.gap + p.x.gap*even) - p.x.force*fast;
    const Ball turned = fast*p.x.gap - even*p.x.sums;
    widen(p.cross, p.tilt, half, size(turn.v) + turn.e);
    p.twist.e += half*(size(turned.v) + turned.e);
    p.x.both.e += half < 0.125 ? 0.125*half : 0x1p-6; /* m2 m0 <= (part (1 - part))^2/4 */
    p.x.apart = 2*p.x.sums - p.x.force;
    return p;
}

/* Whether all roots next to this y leave (side 1) or come back (side -1).
 *
 * The logarithmic derivative of a factor by ln z has the change of its angle with theta, and less
 * that of the logarithm of its size; the squares of the sizes are polynomials in y. */
bool crosses(const Loop &w, const Part &p, const Surplus &c, double at, double side,
             double periods) {
    const Device &x = p.x;
    bool known = true;
    const double off = reach<true>(c, at, side, known);
    if (!known) return false;
    const Ball y = {at, off}, near = 0.5*y, along = exact(1) - near;
    const Ball sine = root(near*(exact(2) - near)), e = exact(1) - x.loss, begin = w.gamma*x.force;
    const Ball force = w.beta*w.slope, m = x.force*x.force + (p.cross + x.both*y)*y;
    const Ball wall = exact(w.alpha)*exact(w.alpha) + force*y;
    const Ball linear = x.loss*x.loss - begin*(exact(1) + e), a = begin*begin + (linear + e*y)*y;
    const Ball angle = x.gap*(x.force*along + x.sums*near)/m
                     + w.slope*(exact(w.alpha) + w.beta*near)/wall
                     - x.loss*(begin*along + (exact(1) + e)*near)/a;
    const Ball less = sine*((linear + 2*(e*y))/a - (p.cross + 2*(x.both*y))/m - force/wall);
    /* h; the product m2 m0 changes by part (1 - part)/2 at most */
    const Ball grows = 0.5*(y*(p.tilt + Ball{0, 0.125}*y))/m;
    const Ball turns = sine*(p.gap*x.force + near*p.twist)/m;
    const Ball rest = grows*angle + turns*less;
    return lower(side*(2*grows - rest)) > 0 && lower(side*((periods + 2)*grows - rest)) > 0;
}

/* Whether in this part of the period roots only leave at the larger angle; `clear` stays true if
 * the device leads at all angles. */
bool leaves(const Loop &w, double middle, double half, double periods, bool &clear) {
    const Part p = part_of(w, middle, half);
    const Ball pull = p.x.apart*(w.slope + exact(w.beta));
    const Surplus c = surplus<true>(p.x, p.cross, w.alpha, w.beta, w.gamma);
    const Shape at = shape<true>(c, w.stronger);
    if (!at.bent || !(p.x.far.v - size(pull.v) > SLACK*(p.x.far.e + pull.e))) return false;
    if (at.clear) return true;
    clear = false;
    if (w.stronger && !(at.twice && crosses(w, p, c, at.low, -1, periods))) return false;
    return crosses(w, p, c, at.high, 1, periods);
}

/* The same of all parts; parts are cut in four, twice at most. */
bool all_leave(const Loop &w, double middle, double half, double periods, int cuts, bool &clear) {
    bool whole = clear;
    if (leaves(w, middle, half, periods, whole)) {
        clear = whole;
        return true;
    }
    if (cuts == 0) return false;
    for (int k = -3; k <= 3; k += 2)
        if (!all_leave(w, middle + 0.25*half*k, 0.25*half, periods, cuts - 1, clear)) return false;
    return true;
}

/* Where plant and wall are equally strong, at the larger angle, and the phase there. */
struct Crossing {
    double theta, phase;
};

Crossing crossing(const Loop &w, double part) {
    const Device x = device<true>(w.gamma, w.delta, part);
    const Surplus c = surplus<true>(x, across(x), w.alpha, w.beta, w.gamma);
    const double y = shape<true>(c, w.stronger).high;
    const double rest = 4 - y, sine = 0.5*std::sqrt(y*rest), half = 0.5*y;
    const double m = std::atan2(x.gap.v*sine, x.force.v - x.sums.v*half);
    const double wall = std::atan2(w.slope.v*sine, w.alpha - w.slope.v*half);
    const double a = std::atan2(x.loss.v*sine, w.gamma*x.force.v - (2 - x.loss.v)*half);
    return {2*std::atan2(std::sqrt(y), std::sqrt(rest)), m + wall - a};
}

} // namespace

double largest_delay(double alpha, double beta, double gamma, double delta) {
    const Loop w = {alpha, beta, gamma, delta, gamma > size(alpha), exact(alpha) + exact(beta)};
    if (!plain(alpha, beta, gamma, delta) || alpha == gamma || w.slope.v == 0) return NAN;
    const Crossing first = crossing(w, 0);
    const double half_turn = first.phase + PI, most = first.phase - 2*first.theta;
    const double phase = half_turn - 2*PI*std::nearbyint(most/(2*PI));
    const double real = phase/first.theta - 2, periods = real < 0x1p20 ? std::floor(real) : 0;
    if (!w.stronger && !(real >= 0)) return NAN;
    bool clear = true;
    if (!all_leave(w, 0.5, 0.5, periods + 1, 2, clear)) return NAN;
    if (clear) return INFINITY;
    if (!(real >= 0 && real < 0x1p20)) return NAN;
    /* secants for the fraction, of phases that hardly bend */
    const double turns = periods + 2, close = 0x1p-50*turns;
    double low = 0, above = phase - turns*first.theta, high = 1, below = above - first.theta;
    double part = -1;
    for (int k = 0; k < 8; ++k) {
        double next = high - below*(high - low)/(below - above);
        next = next < 0 ? 0 : next > 1 ? 1 : next;
        if (size(next - part) <= close) return periods + next;
        part = next;
        const Crossing c = crossing(w, part);
        low = high, above = below;
        high = part, below = c.phase - first.phase + phase - turns*c.theta;
    }
    return NAN;
}

} // namespace filter
