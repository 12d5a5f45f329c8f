/* Ordinary arguments, by series and polynomials without a branch; compilers vectorise the loops.
 *
 * Devices with 2 delta + gamma <= 1/8 behind whole delays; elsewhere the first result is NaN, and
 * the kernel is asked.  Sine and cosine are those of Sun's fdlibm, of an angle known to twice the
 * digits, so that bits are the same for all instruction sets. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("O3", "no-trapping-math", "no-math-errno")
#endif

#include "ordinary.h"

namespace ordinary {
namespace {

constexpr double LONGEST = 0x1p17, LARGEST = 1e70, LEAST = 0x1p-300, SHIFT = 0x1.8p52;

/* The sampled device; `loss` is 1 - e. */
struct Device {
    double n1, n0, both, apart, trace, loss, far;
};

/* With h = delta/2, its step response times exp(h t) obeys v'' = exp(h t) + u v, u = h^2 - gamma:
 * n1 and n0 are exp(-h) v(1) and exp(-h) v(-1).  What is added to 1/2, 1, 2 or 4 is small. */
INLINE Device device(double gamma, double delta) {
    const double h = 0.5*delta, square = h*h, u = square - gamma;
    double even = 0, odd = h/6, before = 0.5, last = odd, power = h;
#pragma GCC unroll 12
    for (int k = 4; k <= 15; ++k) {
        power *= h/(k - 2);
        const double next = (power + u*before)*(1.0/(k*(k - 1)));
        before = last, last = next;
        if (k % 2) odd += next;
        else even += next;
    }
    double lost = 0, swing = 0, fall = 0, rise = 0; /* 1 - exp(-h), cosh(sqrt(u)) - 1, ... */
#pragma GCC unroll 9
    for (int k = 9; k >= 1; --k) lost = (1 - lost)*h*(1.0/k);
#pragma GCC unroll 8
    for (int k = 8; k >= 1; --k) swing = (1 + swing)*u*(1.0/(2*k*(2*k - 1)));
#pragma GCC unroll 4
    for (int k = 4; k >= 1; --k) {
        fall = (1 + fall)*square*(1.0/(2*k*(2*k - 1)));
        rise = (1 + rise)*square*(1.0/(2*k*(2*k + 1)));
    }
    const double kept = 1 - lost, one = even + odd, other = even - odd, sides = swing + fall;
    return {0.5 + (one - lost*(0.5 + one)), 0.5 + (other - lost*(0.5 + other)),
            1 + (2*even - lost*(1 + 2*even)), 2*kept*odd, 2 + 2*(swing - lost*(1 + swing)),
            2*kept*(h + h*rise), 4 + 2*(sides - lost*(2 + sides))};
}

struct Turn {
    double cosine, sine;
};

/* Of `count` angles up to pi; a count of halves up to LONGEST. */
INLINE Turn turn(double count, double angle) {
    const double big = 0x1.0000002p27*angle, high = big - (big - angle);
    const double product = count*angle, off = (count*high - product) + count*(angle - high);
    const double quarters = (product*0x1.45f306dc9c883p-1 + SHIFT) - SHIFT;
    const double near = product - quarters*0x1.921fb544p0, rest = quarters*0x1.0b4611a6p-34;
    const double left = near - rest, back = near - left;
    const double low = ((near - (left + back)) + (back - rest))
                     + (off - quarters*0x1.3198a2e037073p-69);
    const double x = left + low, y = (left - x) + low, z = x*x, half = 0.5*z, w = 1 - half;
    const double r = 8.33333333332248946124e-03 + z*(-1.98412698298579493134e-04
        + z*(2.75573137070700676789e-06 + z*(-2.50507602534068634195e-08
        + z*1.58969099521155010221e-10)));
    const double s = x - ((z*(0.5*y - z*x*r) - y) - z*x*-1.66666666666666324348e-01);
    const double q = z*(4.16666666666666019037e-02 + z*(-1.38888888888741095749e-03
        + z*(2.48015872894767294178e-05 + z*(-2.75573143513906633035e-07
        + z*(2.08757232129817482790e-09 + z*-1.13596475577881948265e-11)))));
    const double c = w + (((1 - w) - half) + (z*q - x*y));
    const double side = quarters - 4*((0.25*quarters + SHIFT) - SHIFT); /* -2 to 2 */
    const bool over = (side == 1) | (side == -1), turned = (side == 2) | (side == -2);
    const double sine = over ? c : s, cosine = over ? -s : c;
    return side == -1 || turned ? Turn{-cosine, -sine} : Turn{cosine, sine};
}

INLINE bool slow(double gamma, double delta) {
    return ((gamma == 0) | (gamma >= LEAST)) & ((delta == 0) | (delta >= LEAST))
           & (2*delta + gamma <= 0.125);
}
INLINE bool whole(double d) {
    return (d >= 0) & (d <= LONGEST) & ((d + SHIFT) - SHIFT == d);
}
INLINE bool angle(double theta) {
    return (theta >= LEAST) & (theta <= 3.141592653589793);
}

} // namespace

CLONES void discretize(int n, const Rows &x, Rows &y) {
    for (int i = 0; i < n; ++i) {
        const double gamma = x[0][i], delta = x[1][i];
        const Device found = device(gamma, delta);
        y[0][i] = slow(gamma, delta) ? found.n1 : NAN;
        y[1][i] = found.n0, y[2][i] = found.trace, y[3][i] = 1 - found.loss;
    }
}

CLONES void stability_boundary(int n, const Rows &x, Rows &y) {
    for (int i = 0; i < n; ++i) {
        const double theta = x[0][i], gamma = x[1][i], delta = x[2][i], d = x[3][i];
        const Device m = device(gamma, delta);
        const Turn half = turn(0.5, theta), late = turn(d + 1, theta);
        const double near = half.cosine*half.cosine, far = half.sine*half.sine;
        const double across = turn(1, theta).sine, spring = gamma*m.both*near;
        const double drag = m.far*far, a = spring - drag, a_up = m.loss*across;
        const double b = m.both*near - m.apart*far, b_up = m.n1*across;
        const double size = b*b + b_up*b_up;
        const double ahead = (a_up*b - a*b_up)/size, phase = (a*b + a_up*b_up)/size;
        const double pull = ahead*late.cosine + phase*late.sine;
        /* the kernel has the digits that are lost next to the own frequency */
        const bool good = slow(gamma, delta) & whole(d) & angle(theta)
                        & (std::fabs(a) + a_up >= 0.5*(spring + drag));
        const double alpha = ahead*late.sine - late.cosine*phase + pull*(half.sine/half.cosine);
        y[0][i] = good ? alpha : NAN;
        y[1][i] = -pull/across;
    }
}

CLONES void passivity_margin_at(int n, const Rows &x, Rows &y) {
    for (int i = 0; i < n; ++i) {
        const double theta = x[0][i], alpha = x[1][i], beta = x[2][i], delta = x[3][i];
        const double d = x[4][i];
        const Turn half = turn(0.5, theta), late = turn(d + 1, theta), middle = turn(d + 0.5, theta);
        const bool good = whole(d) & angle(theta) & (delta >= 0) & (delta <= LARGEST)
                        & (std::fabs(alpha) <= LARGEST) & (std::fabs(beta) <= LARGEST);
        const double needs = alpha*(middle.sine/(2*half.sine)) - beta*late.cosine;
        y[0][i] = good ? delta - needs : NAN;
    }
}

} // namespace ordinary
