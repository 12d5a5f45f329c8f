/* The exported functions as one would write them by hand for speed: the same algorithms and the
   same care for the last digit. */

#include <math.h>

typedef struct { double hi, lo; } pair;

static inline pair fast_sum(double a, double b) {
    const double s = a + b;
    return (pair){s, b - (s - a)};
}

static inline pair sum(double a, double b) {
    const double s = a + b, t = s - a;
    return (pair){s, (a - (s - t)) + (b - t)};
}

static inline pair times(double a, pair b) {
    const double p = a*b.hi;
    return (pair){p, fma(a, b.hi, -p) + a*b.lo};
}

static inline pair over(pair a, pair b) {
    const double q = a.hi/b.hi;
    return (pair){q, (fma(-q, b.hi, a.hi) + (a.lo - q*b.lo))/b.hi};
}

/* -- series ----------------------------------------------------------------------------- */

static const double inverse[31] = { /* 1/k! */
    1.0, 1.0, 0.5, 0.16666666666666666, 0.041666666666666664, 0.008333333333333333,
    0.001388888888888889, 0.0001984126984126984, 2.48015873015873e-05, 2.7557319223985893e-06,
    2.755731922398589e-07, 2.505210838544172e-08, 2.08767569878681e-09, 1.6059043836821613e-10,
    1.1470745597729725e-11, 7.647163731819816e-13, 4.779477332387385e-14, 2.8114572543455206e-15,
    1.5619206968586225e-16, 8.22063524662433e-18, 4.110317623312165e-19, 1.9572941063391263e-20,
    8.896791392450574e-22, 3.868170170630684e-23, 1.6117375710961184e-24, 6.446950284384474e-26,
    2.4795962632247976e-27, 9.183689863795546e-29, 3.279889237069838e-30, 1.1309962886447716e-31,
    3.7699876288159054e-33};

#define UNROLLED _Pragma("GCC unroll 32")

/* whether the poles are up to 1/8, where fewer terms serve */
static inline int slow(double h, double w) {
    return h < 0.0625 && fabs(w) < 0.00390625;
}

static inline double rise_steps(double h, double w, const int n) {
    double e0 = 0.0, e1 = 0.0, total = 0.0;
    int k = n - 1;
    if (!(k & 1)) {
        e0 = inverse[k + 2];
        total = e0;
        --k;
    }
    UNROLLED for (; k > 1; k -= 2) {
        e1 = inverse[k + 2] + w*e1;
        total = e1 + h*total;
        e0 = inverse[k + 1] + w*e0;
        total = e0 + h*total;
    }
    e1 = inverse[3] + w*e1;
    total = e1 + h*total;
    return w*e0 + h*total;
}

static double rise_series(double h, double w, int few) {
    return few ? rise_steps(h, w, 12) : rise_steps(h, w, 27);
}

static inline double fall_steps(double gamma, double delta, const int n) {
    double one = 0.0, two = 0.0;
    UNROLLED for (int k = n - 1; k >= 4; --k) {
        const double next = inverse[k + 2] + delta*one - gamma*two;
        two = one;
        one = next;
    }
    pair a = {one, 0.0}, b = {two, 0.0};
    UNROLLED for (int k = 3; k >= 0; --k) {
        const pair up = times(delta, a), down = times(gamma, b);
        const pair part = sum(up.hi, -down.hi), all = sum(part.hi, k ? inverse[k + 2] : 0.0);
        b = a;
        a = (pair){all.hi, part.lo + all.lo + (up.lo - down.lo)};
    }
    return a.hi + a.lo;
}

static double fall_series(double gamma, double delta, int few) {
    return few ? fall_steps(gamma, delta, 12) : fall_steps(gamma, delta, 27);
}

static inline double mixed_steps(double h, double w, const int first, const int n) {
    const double y = h*h;
    double inner = 0.0, total = 0.0;
    UNROLLED for (int k = n - 1; k >= 0; --k) {
        inner = (k ? inverse[2*k + first] : 0.0) + w*inner;
        total = inner + y*total;
    }
    return total;
}

static inline double scaled(double number, double low, double series, double fall) {
    const pair all = fast_sum(number, series + low), found = times(fall, all);
    return found.hi + found.lo;
}

/* -- exponentials and waves -------------------------------------------------------------- */

typedef struct { pair fall, mean; } fading;

static inline fading fade(pair rate) {
    const double x = rate.hi;
    fading f;
    if (x < 0.75) {
        const double y = x*x;
        double even = 0.0, odd = 0.0;
        UNROLLED for (int k = 16; k >= 0; k -= 2) even = inverse[k + 3] + y*even;
        UNROLLED for (int k = 15; k >= 1; k -= 2) odd = inverse[k + 3] + y*odd;
        const pair first = fast_sum(1.0, -0.5*x), mean = fast_sum(first.hi, y*(even - x*odd));
        f.mean.hi = mean.hi;
        f.mean.lo = first.lo + mean.lo - rate.lo*(0.5 - x/3 + 0.125*y);
        const pair gone = times(x, f.mean);
        f.fall = fast_sum(1.0, -gone.hi);
        f.fall.lo -= gone.lo + rate.lo*mean.hi;
    } else {
        f.fall.hi = exp(-x);
        f.fall.lo = -f.fall.hi*rate.lo;
        pair top = fast_sum(1.0, -f.fall.hi);
        top.lo -= f.fall.lo;
        f.mean = over(top, rate);
    }
    return f;
}

typedef struct { pair even, odd; } wave; /* cos(root) and sin(root)/root */

static inline wave swing(pair w, pair root) {
    wave v;
    if (w.hi > -1.0) {
        const double x = w.hi, y = x*x;
        const double c = (inverse[4] + y*(inverse[8] + y*(inverse[12] + y*inverse[16])))
            + x*(inverse[6] + y*(inverse[10] + y*(inverse[14] + y*inverse[18])));
        const double s = (inverse[3] + y*(inverse[7] + y*(inverse[11] + y*(inverse[15]
            + y*inverse[19])))) + x*(inverse[5] + y*(inverse[9] + y*(inverse[13] + y*inverse[17])));
        const pair first = fast_sum(1.0, 0.5*x);
        v.even = fast_sum(first.hi, y*c);
        v.even.lo += first.lo + 0.5*w.lo;
        v.odd = fast_sum(1.0, x*s);
        v.odd.lo += w.lo/6;
    } else {
        const double sine = sin(root.hi), cosine = cos(root.hi);
        v.even = (pair){cosine, -root.lo*sine};
        v.odd = over((pair){sine, root.lo*cosine}, root);
    }
    return v;
}

/* -- the device -------------------------------------------------------------------------- */

typedef struct {
    double half;
    pair w, root, p, q;
    int swings, near;
} motion;

static inline motion move(double gamma, double delta) {
    motion m = {0};
    m.half = 0.5*delta;
    const pair square = times(m.half, (pair){m.half, 0.0}), rest = sum(square.hi, -gamma);
    m.w = fast_sum(rest.hi, rest.lo + square.lo);
    m.swings = m.w.hi < 0.0;
    const double sign = m.swings ? -1.0 : 1.0, size = sign*m.w.hi, root = sqrt(size);
    m.root.hi = root;
    m.root.lo = root == 0.0 ? 0.0 : 0.5*(fma(-root, root, size) + sign*m.w.lo)/root;
    if (m.swings) {
        m.near = gamma < 4.0;
    } else {
        m.p = fast_sum(m.half, root);
        m.p.lo += m.root.lo;
        m.near = m.p.hi < 2.25;
        m.q = m.p.hi == 0.0 ? m.p : over((pair){gamma, 0.0}, m.p);
    }
    return m;
}

typedef struct { fading slow, apart; } creeping;

static inline creeping creep(const motion *m) {
    return (creeping){fade(m->q), fade((pair){2*m->root.hi, 2*m->root.lo})};
}

static inline double fallen(const fading *slow, const fading *apart, pair p) {
    pair pulled = times(apart->fall.hi, slow->mean);
    pulled.lo += apart->fall.lo*slow->mean.hi;
    pair top = sum(apart->mean.hi, -pulled.hi);
    top.lo += apart->mean.lo - pulled.lo;
    const pair rest = over(top, p), whole = times(slow->fall.hi, rest);
    return whole.hi + (whole.lo + slow->fall.lo*rest.hi);
}

static inline double risen(const fading *slow, const fading *apart, pair p) {
    pair pulled = times(slow->fall.hi, apart->mean);
    pulled.lo += slow->fall.lo*apart->mean.hi;
    pair top = sum(slow->mean.hi, -pulled.hi);
    top.lo += slow->mean.lo - pulled.lo;
    const pair all = over(top, p);
    return all.hi + all.lo;
}

static inline void swung(double gamma, double envelope, double half, const wave *v,
                         double *n1, double *n0) {
    const pair odd = times(half, v->odd), both = sum(v->even.hi, odd.hi);
    const pair left = times(envelope, (pair){both.hi, both.lo + (v->even.lo + odd.lo)});
    pair top = fast_sum(1.0, -left.hi);
    top.lo -= left.lo;
    const pair up = over(top, (pair){gamma, 0.0});
    *n1 = up.hi + up.lo;
    const pair off = sum(odd.hi, -v->even.hi), rest = sum(off.hi, envelope);
    const pair found = times(envelope, (pair){rest.hi, rest.lo + (off.lo + odd.lo - v->even.lo)});
    const pair down = over(found, (pair){gamma, 0.0});
    *n0 = down.hi + down.lo;
}

void hand_discretize(double gamma, double delta, double *n1, double *n0, double *a, double *e) {
    const motion m = move(gamma, delta);
    *e = exp(-delta);
    if (m.swings) {
        const double envelope = exp(-m.half);
        const wave v = swing(m.w, m.root);
        const pair turn = times(envelope, v.even);
        *a = 2*(turn.hi + turn.lo);
        if (!m.near) {
            swung(gamma, envelope, m.half, &v, n1, n0);
            return;
        }
    } else {
        const creeping c = creep(&m);
        pair both = fast_sum(1.0, c.apart.fall.hi);
        both.lo += c.apart.fall.lo;
        const pair all = times(c.slow.fall.hi, both);
        *a = all.hi + (all.lo + c.slow.fall.lo*both.hi);
        if (!m.near) {
            *n1 = risen(&c.slow, &c.apart, m.p);
            *n0 = fallen(&c.slow, &c.apart, m.p);
            return;
        }
    }
    const int few = slow(m.half, m.w.hi);
    *n1 = scaled(0.5, 0.0, rise_series(m.half, m.w.hi, few), exp(-m.half));
    *n0 = scaled(0.5, 0.0, fall_series(gamma, delta, few), *e);
}

/* grown^2 + envelope (own + low)^2 */
static inline pair squares(double grown, double envelope, double own, double low) {
    const pair wave = sum(own, low);
    pair square = times(wave.hi, (pair){wave.hi, 0.0});
    square.lo += 2*wave.hi*wave.lo;
    const pair turned = times(envelope, square);
    const pair all = sum(turned.hi, grown*grown);
    return (pair){all.hi, all.lo + turned.lo};
}

/* -- the device on the circle ------------------------------------------------------------- */

typedef struct { double at_one, at_minus_one, loss, together, apart, n1, n0; } ends;

static const double sixth_low = 9.25185853854297e-18;

static inline ends device(double gamma, double delta, int counting) {
    const motion m = move(gamma, delta);
    ends x = {0};
    const double e = exp(-delta), envelope = exp(-m.half);
    x.loss = -expm1(-delta);
    if (m.swings) {
        const wave v = swing(m.w, m.root);
        const double grown = -0.5*expm1(-m.half), angle = 0.5*m.root.hi;
        const double sine = sin(angle), cosine = cos(angle);
        if (v.even.hi > 0.0) {
            const pair begin = fast_sum(1.0, e), turn = times(2*envelope, v.even);
            const pair both = fast_sum(begin.hi, turn.hi);
            x.at_minus_one = both.hi + (both.lo + begin.lo + turn.lo);
        } else {
            const pair all = squares(grown, envelope, cosine, -0.5*m.root.lo*sine);
            x.at_minus_one = 4*(all.hi + all.lo);
        }
        if (!m.near) {
            const pair all = squares(grown, envelope, sine, 0.5*m.root.lo*cosine);
            const pair both = over(all, (pair){gamma, 0.0}), turn = times(envelope*delta, v.odd);
            const pair left = sum(x.loss, -turn.hi);
            const pair away = over((pair){left.hi, left.lo - turn.lo}, (pair){gamma, 0.0});
            x.together = 4*(both.hi + both.lo);
            x.apart = away.hi + away.lo;
            if (counting) swung(gamma, envelope, m.half, &v, &x.n1, &x.n0);
        }
    } else {
        const creeping c = creep(&m);
        pair quick = times(c.slow.fall.hi, c.apart.fall);
        quick.lo += c.slow.fall.lo*c.apart.fall.hi;
        const double fast = quick.hi;
        const pair one = fast_sum(1.0, c.slow.fall.hi), two = fast_sum(1.0, fast);
        const pair ended = times(one.hi, (pair){two.hi, two.lo + quick.lo});
        x.at_minus_one = ended.hi + (ended.lo + (one.lo + c.slow.fall.lo)*two.hi);
        if (!m.near) {
            const pair gone = fast_sum(1.0, -fast);
            pair moved = times(c.slow.mean.hi, (pair){gone.hi, gone.lo - quick.lo});
            moved.lo += c.slow.mean.lo*gone.hi;
            const pair both = over(moved, m.p);
            x.together = both.hi + both.lo;
            const pair pulled = times(2*c.slow.fall.hi, c.apart.mean);
            const pair top = sum(c.slow.mean.hi, -pulled.hi), more = times(fast, c.slow.mean);
            x.apart = ((top.hi + more.hi) + (top.lo + (c.slow.mean.lo + more.lo - pulled.lo)))/m.p.hi;
            if (counting) {
                x.n1 = risen(&c.slow, &c.apart, m.p);
                x.n0 = fallen(&c.slow, &c.apart, m.p);
            }
        }
    }
    if (m.near) {
        const int few = slow(m.half, m.w.hi);
        x.together = 2*scaled(0.5, 0.0, few ? mixed_steps(m.half, m.w.hi, 2, 7) : mixed_steps(m.half, m.w.hi, 2, 14), envelope);
        x.apart = delta*scaled(inverse[3], sixth_low, few ? mixed_steps(m.half, m.w.hi, 3, 6)
            : mixed_steps(m.half, m.w.hi, 3, 14), envelope);
        if (counting) {
            x.n1 = scaled(0.5, 0.0, rise_series(m.half, m.w.hi, few), envelope);
            x.n0 = scaled(0.5, 0.0, fall_series(gamma, delta, few), e);
        }
    }
    x.at_one = gamma*x.together;
    return x;
}

static inline pair angle_of(double d, double theta) {
    const double count = d + 1.0, angle = count*theta;
    return (pair){angle, fma(count, theta, -angle) + (d - (count - 1.0))*theta};
}

/* x - y z, rounded once */
static inline double less(double x, double y, pair z) {
    const pair p = times(y, z), s = sum(x, -p.hi);
    return s.hi + (s.lo - p.lo);
}

void hand_stability_boundary(double theta, double gamma, double delta, double d,
                             double *alpha, double *beta) {
    const ends x = device(gamma, delta, 0);
    const double t = tan(0.5*theta);
    const pair t2 = times(t, (pair){t, 0.0});
    const double above = less(x.at_one, x.at_minus_one, t2), above_j = 2*t*x.loss;
    const double below = less(x.together, x.apart, t2), below_j = t*(x.together + x.apart);
    const double size = below*below + below_j*below_j;
    const double ratio = (above*below + above_j*below_j)/size;
    const double ratio_j = (above_j*below - above*below_j)/size;
    const pair turn = angle_of(d, theta);
    const double s = sin(turn.hi), c = cos(turn.hi);
    const double sine = s + turn.lo*c, cosine = c - turn.lo*s;
    const double imaginary = -ratio_j*cosine - ratio*sine;
    *alpha = ratio_j*sine - ratio*cosine - imaginary*t;
    *beta = imaginary/sin(theta);
}

double hand_passivity_margin_at(double theta, double alpha, double beta, double delta, double d) {
    const double half = 0.5*theta;
    const pair up = angle_of(2*d, half), turn = angle_of(d, theta);
    const double sine = sin(up.hi) + up.lo*cos(up.hi);
    const double cosine = cos(turn.hi) - turn.lo*sin(turn.hi);
    return delta - alpha*sine/(2*sin(half)) + beta*cosine;
}

/* -- roots outside the unit circle --------------------------------------------------------- */

typedef struct { double c, b, a; } quadratic;

static inline double angle(double x, double y, double *halves) {
    *halves += x < 0.0 ? (y < 0.0 ? -1.0 : 1.0) : 0.0;
    return atan2(x < 0.0 ? -y : y, fabs(x));
}

static inline void solve(const quadratic *k, double root, double found[2]) {
    const int upper = k->b >= 0.0;
    const double q = -0.5*(k->b + (upper ? root : -root));
    const double one = k->a == 0.0 ? -1.0 : q/k->a, two = q == 0.0 ? -1.0 : k->c/q;
    found[0] = upper ? one : two;
    found[1] = upper ? two : one;
}

static inline int leads(const quadratic *k) {
    return k->c < 0.0 || (k->c == 0.0 && (k->b < 0.0 || (k->b == 0.0 && k->a < 0.0)));
}

double hand_is_stable(double alpha, double beta, double gamma, double delta, double d) {
    const ends x = device(gamma, delta, 1);
    const double pi = 3.141592653589793, e = 1.0 - x.loss;
    const double slope = alpha + beta, force = slope*beta, edge_force = alpha + 2*beta;
    const double cross = x.n1*x.n0, lost = x.loss*x.loss, square = e + cross*force;
    const double push = x.together*alpha, pull = x.apart*edge_force;
    const quadratic near = {(x.at_one - push)*(x.at_one + push),
        lost - x.at_one*(1.0 + e) + cross*(alpha*alpha) - x.together*x.together*force, square};
    const quadratic far = {(x.at_minus_one - pull)*(x.at_minus_one + pull),
        lost - x.at_minus_one*(1.0 + e) - cross*(edge_force*edge_force) + x.apart*x.apart*force,
        square};
    const double center = 2*x.at_one/(1.0 + e), beyond = 2*x.at_minus_one/(1.0 + e);
    const double sine = 0.25*center*beyond, tilt = 0.25*(beyond - center);
    const double real = 0.25*(x.together*beyond - x.apart*center), n11 = x.n1*x.n1;
    const double m0 = real*real + n11*sine, m1 = n11*tilt - x.n1*real;
    const double turning = 0.25*(alpha*beyond - edge_force*center);
    const double wall = turning*turning + slope*slope*sine;
    const quadratic own = {lost*sine - m0*wall, lost*tilt - m1*wall - m0*force, e - m1*force};
    const quadratic *all[3] = {&near, &own, &far};
    double disc[3], size[3];
    for (int i = 0; i < 3; ++i) {
        const double b2 = all[i]->b*all[i]->b, ac = 4*all[i]->c*all[i]->a;
        disc[i] = b2 - ac;
        size[i] = b2 + fabs(ac);
    }
    const int which = size[1] <= size[0] && size[1] <= size[2] ? 1
        : size[2] < size[0] && size[2] < size[1] ? 2 : 0;
    double total = 0.0;
    if (disc[which] >= 0.0) {
        const double root = sqrt(disc[which]);
        double ys[2], offs[2], rests[2];
        solve(&near, root, ys);
        solve(&own, root, offs);
        solve(&far, root, rests);
        for (int i = 0; i < 2; ++i) {
            const double y = ys[i], rest = rests[1 - i], off = offs[i];
            const int small = y < rest;
            const double edge = small ? y : rest;
            if (!(y > 0.0 && rest > 0.0 && edge < 4.0)) continue;
            const int inside = fabs(off) < edge && center + off > 0.0 && beyond - off > 0.0;
            const double at = fmax(inside ? center + off : small ? y : 4.0 - rest, 0.0);
            const double still = fmax(inside ? beyond - off : small ? 4.0 - y : rest, 0.0);
            const double away = inside ? off : small ? y - center : beyond - rest;
            const double wide = 2*sqrt(at*still);
            double below = 0.0, above = 0.0;
            const double phase_below = angle(-2*(1.0 + e)*away, x.loss*wide, &below);
            const double phase_above = angle(x.together*still - x.apart*at, x.n1*wide, &above)
                + angle(alpha*still - edge_force*at, slope*wide, &above);
            const int beyond_half = at > 2.0;
            const double half = atan2(sqrt(beyond_half ? still : at), sqrt(beyond_half ? at : still));
            const double late = d + 2.0;
            const double halves = above - below - (beyond_half ? late : 0.0);
            const double share = (phase_above - phase_below - late*(beyond_half ? -2*half : 2*half))
                /(2*pi);
            const double even = floor(0.5*halves), left = 0.5*halves - even;
            const double turns = even + (left == 0.5 ? floor(share) + 1.0 : floor(share + left + 0.5));
            total += (i ? -2.0 : 2.0)*turns;
        }
    }
    const double side = slope >= 0.0 ? 1.0 : -1.0;
    if (leads(&near)) total += alpha > 0.0 ? 0.0 : side;
    if (leads(&far))
        total -= (edge_force > 0.0 ? side : 0.0) - (d + 3.0)
            + (x.apart > 0.0 ? (x.n1 >= 0.0 ? 1.0 : -1.0) : 0.0);
    const double own_angle = sqrt(gamma);
    return total == 0.0 && alpha > -gamma && !(alpha == 0.0 && beta == 0.0 && delta == 0.0)
        && !(delta < 1.1e-15 && gamma > 1.0 && fabs(sin(own_angle)) <= 4.4e-16*own_angle);
}
