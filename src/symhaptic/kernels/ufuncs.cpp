/* The kernels as NumPy ufuncs, in both precisions, and as functions of Python's own numbers.
 *
 * What a kernel takes and gives follows from its signature in C: `T` is an argument, `T *` a
 * result, and what is returned is the only result. table.h lists the kernels and says where their
 * arguments may be; `symhaptic kernels` writes it. */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#define NPY_NO_DEPRECATED_API NPY_1_22_API_VERSION
#include <numpy/arrayobject.h>
#include <numpy/arrayscalars.h>
#include <numpy/ufuncobject.h>

#include <cfenv>
#include <cmath>
#include <type_traits>
#include <utility>

#include "ordinary.h"
#include "table.h"

namespace {

/* Of each thread its own: whether an argument of its calls was NaN or out of range. */
thread_local bool strayed = false;

/* What a signature says; `Of` are the ranges of the arguments, where they are asked. */
template <class F, class... Of> struct Kernel;
template <class R, class... A, class... Of> struct Kernel<R (*)(A...), Of...> {
    using T = std::common_type_t<std::remove_pointer_t<A>...>;
    using Found = std::conditional_t<std::is_void_v<R>, T, R>;
    static constexpr int given = (int(!std::is_pointer_v<A>) + ...);
    static constexpr int found = std::is_void_v<R> ? int(sizeof...(A)) - given : 1;
    static constexpr int all = given + found;
    static constexpr bool truth = std::is_same_v<Found, bool>;

    template <class To> static To argument(const T *x, Found *y, std::size_t i) {
        if constexpr (std::is_pointer_v<To>) return y + (i - given);
        else return x[i];
    }
    template <std::size_t... I>
    static void call(R (*f)(A...), const T *x, Found *y, std::index_sequence<I...>) {
        if constexpr (std::is_void_v<R>) f(argument<A>(x, y, I)...);
        else *y = f(argument<A>(x, y, I)...);
    }
    static void call(R (*f)(A...), const T *x, Found *y) {
        call(f, x, y, std::index_sequence_for<A...>());
    }
    template <std::size_t... I> static bool inside(const T *x, std::index_sequence<I...>) {
        return (Of::inside(x[I]) && ... && (x != nullptr));
    }
    static bool inside(const T *x) { return inside(x, std::index_sequence_for<Of...>()); }
};

/* Verdicts for which the filter is asked before the kernel, on floats as on doubles: the number of
 * roots outside, whether it is 0, and (`filtered`) what the filter alone is sure of. */
double filtered(double count, double, double, double, double) { return count; }

template <auto f> constexpr bool any_of() { return false; }
template <auto f, auto g, auto... others> constexpr bool any_of() {
    if constexpr (std::is_same_v<decltype(f), decltype(g)>) {
        if (f == g) return true;
    }
    return any_of<f, others...>();
}
template <auto f>
constexpr bool counts = any_of<f, filtered, haptic_is_stable, haptic_unstable_roots,
                               haptic_single_is_stable, haptic_single_unstable_roots>();

template <auto f> auto after_filter(double count, double alpha, double beta, double gamma,
                                    double delta, double delay) {
    using Found = typename Kernel<decltype(f)>::Found;
    if constexpr (any_of<f, filtered>()) return filtered(count, alpha, beta, gamma, delta);
    else if constexpr (std::is_same_v<Found, bool>) {
        if (count != filter::UNKNOWN) return count == 0;
        return haptic_is_stable(alpha, beta, gamma, delta, delay);
    } else if (count >= 0) return Found(count);
    else return Found(haptic_unstable_roots(alpha, beta, gamma, delta, delay));
}

/* The largest delay where it is proved and the kernel agrees on both of its sides; else NaN. */
double max_delay(double alpha, double beta, double gamma, double delta) {
    const double found = filter::largest_delay(alpha, beta, gamma, delta);
    const bool known = std::isfinite(found), stronger = gamma > std::fabs(alpha);
    if (!known || stronger) { /* else no root has come back */
        const double begin = haptic_unstable_roots(alpha, beta, gamma, delta, 0);
        if (begin != 0 || !known) return begin > 0 ? 0 : begin == 0 ? found : NAN;
    }
    /* what the kernel mostly tells apart, and less where angles are ill-conditioned */
    const double near = (stronger ? 2e-14 : 1e-13)*(1 + std::floor(found));
    const double below = found > near ? found - near : 0;
    const bool right = haptic_is_stable(alpha, beta, gamma, delta, below)
                       && haptic_unstable_roots(alpha, beta, gamma, delta, found + near) > 0;
    return right ? found : NAN;
}

double delay_margin(double alpha, double beta, double gamma, double delta, double delay) {
    const double left = max_delay(alpha, beta, gamma, delta) - delay;
    if (!(delay >= 0) || !(left <= 0)) return delay >= 0 ? left : NAN;
    return haptic_is_stable(alpha, beta, gamma, delta, delay) ? NAN : 0;
}

/* The stiffest stable wall of a damping, on the arc of the boundary on which the damping rises from
 * theta = 0 past the stiffest wall of all; NaN where it is not there, or the kernel disagrees. */
void limit_at(double beta, double gamma, double delta, double d, double *alpha, double *theta) {
    double most, damping, top, stiffness = NAN;
    *alpha = *theta = NAN;
    haptic_max_stable_stiffness(gamma, delta, d, &most, &damping, &top);
    const auto missed = [&](double angle) {
        double found;
        haptic_stability_boundary(angle, gamma, delta, d, &stiffness, &found);
        return found - beta;
    };
    const bool beyond = beta > damping;
    double low = beyond ? top : 1e-3*top, high = top, below = missed(low);
    double above = beyond ? below : damping - beta;
    for (int k = 1; k <= 16 && above < 0; ++k) {
        low = high, below = above;
        high = top + 0.0625*k*(3.14159 - top)/(1 + d);
        above = missed(high);
        if (!(above > below && stiffness > -gamma)) return;
    }
    if (!(below <= 0 && above >= 0)) return;
    double next = high, value = above;
    for (int k = 0; k < 60 && value != 0 && high - low > 0x1p-51*high; ++k) {
        next = high - above*(high - low)/(above - below);
        if (!(next > low && next < high) || k % 8 == 7) next = 0.5*(low + high);
        value = missed(next);
        if (value < 0) { /* an end that stays counts half */
            low = next, below = value, above *= 0.5;
        } else high = next, above = value, below *= 0.5;
    }
    missed(next);
    const double near = 1e-12*(std::fabs(stiffness) + gamma);
    bool right = haptic_is_stable(stiffness - near, beta, gamma, delta, d);
    for (double more : {near, 0.25*(most - stiffness), most - stiffness})
        right = right && haptic_unstable_roots(stiffness + more + near, beta, gamma, delta, d) > 0;
    if (right) *alpha = stiffness, *theta = next;
}

/* Walls with or without a fraction of a period, and where they come from. */
struct Walls {
    filter::Block block;
    npy_intp from[filter::BLOCK];
    int size = 0;
};

/* Verdicts on these walls; whether all arguments are inside, as far as that matters. */
template <auto f, class... Of>
bool flush(Walls &walls, bool fraction, bool once, char *out, npy_intp step) {
    using K = Kernel<decltype(f), Of...>;
    using T = typename K::T;
    const filter::Block &b = walls.block;
    if (walls.size) filter::counted(walls.block, walls.size, fraction, once);
    bool all = true;
    for (int i = 0; i < walls.size; ++i) {
        const double delay = b.steps[i] + b.part[i];
        const auto y = after_filter<f>(b.found[i], b.alpha[i], b.beta[i], b.gamma[i], b.delta[i],
                                       delay);
        *(typename K::Found *)(out + walls.from[i]*step) = y;
        const T x[] = {T(b.alpha[i]), T(b.beta[i]), T(b.gamma[i]), T(b.delta[i]), T(delay)};
        if (!(y > 0)) all &= K::inside(x);
    }
    walls.size = 0;
    return all;
}

/* By Jury's table a free mass without delay is stable where alpha, beta and this are positive:
 * 2 beta (2 - beta) - alpha (2 + beta).  NaN where roundings decide, or a number is not ordinary. */
INLINE double free_mass(double alpha, double beta) {
    const double most = 0x1p20, some = 0x1p-60, pull = alpha*(2 + beta), push = 2*beta*(2 - beta);
    const double left = push - pull, size = pull + std::fabs(push);
    const bool known = (alpha >= some) & (alpha <= most) & (beta >= some) & (beta <= most)
                     & (std::fabs(left) > 0x1p-50*size);
    return known ? left : NAN;
}

template <auto f, class... Of>
bool filtered_loop(char **at, npy_intp size, npy_intp const *steps) {
    using T = typename Kernel<decltype(f)>::T;
    const bool once = !(steps[2] || steps[3] || steps[4]);
    bool all = true;
    if constexpr (Kernel<decltype(f)>::truth) {
        if (once && *(T *)at[2] == 0 && *(T *)at[3] == 0 && *(T *)at[4] == 0) {
            for (npy_intp n = 0; n < size; ++n) {
                const T x[] = {*(T *)(at[0] + n*steps[0]), *(T *)(at[1] + n*steps[1]), 0, 0, 0};
                const double left = free_mass(x[0], x[1]);
                bool good = left > 0;
                if (left != left) {
                    good = haptic_is_stable(x[0], x[1], 0, 0, 0);
                    all &= Kernel<decltype(f), Of...>::inside(x);
                }
                *(bool *)(at[5] + n*steps[5]) = good;
            }
            return all;
        }
    }
    Walls walls[2];
    for (npy_intp n = 0; n < size; ++n) {
        const auto x = [&](int i) { return double(*(T *)(at[i] + n*steps[i])); };
        const double delay = x(4), whole = std::floor(delay);
        const bool fraction = delay != whole;
        Walls &own = walls[fraction];
        filter::Block &b = own.block;
        const int k = own.size++;
        own.from[k] = n;
        b.alpha[k] = x(0), b.beta[k] = x(1), b.gamma[k] = x(2), b.delta[k] = x(3);
        b.steps[k] = whole, b.part[k] = delay - whole;
        if (own.size == filter::BLOCK) all &= flush<f, Of...>(own, fraction, once, at[5], steps[5]);
    }
    for (bool fraction : {false, true})
        all &= flush<f, Of...>(walls[fraction], fraction, once, at[5], steps[5]);
    return all;
}

/* What computes blocks of ordinary arguments of a kernel, if there is one. */
using InBlocks = void (*)(int, const ordinary::Rows &, ordinary::Rows &);
template <auto f> constexpr InBlocks in_blocks() {
    if constexpr (any_of<f, haptic_discretize>()) return ordinary::discretize;
    else if constexpr (any_of<f, haptic_stability_boundary>()) return ordinary::stability_boundary;
    else if constexpr (any_of<f, haptic_passivity_margin_at>()) return ordinary::passivity_margin_at;
    else return nullptr;
}

template <auto f, class... Of>
bool blocked_loop(char **at, npy_intp size, npy_intp const *steps) {
    using K = Kernel<decltype(f), Of...>;
    ordinary::Rows given, found;
    bool all = true;
    for (npy_intp begin = 0; begin < size; begin += filter::BLOCK) {
        const int n = int(size - begin < filter::BLOCK ? size - begin : filter::BLOCK);
        for (int i = 0; i < K::given; ++i)
            for (int k = 0; k < n; ++k) given[i][k] = *(double *)(at[i] + (begin + k)*steps[i]);
        in_blocks<f>()(n, given, found);
        for (int k = 0; k < n; ++k) {
            if (found[0][k] == found[0][k]) continue;
            double x[K::given], y[K::found];
            for (int i = 0; i < K::given; ++i) x[i] = given[i][k];
            K::call(f, x, y);
            for (int i = 0; i < K::found; ++i) found[i][k] = y[i];
            if (y[0] != y[0]) all &= K::inside(x);
        }
        for (int i = 0; i < K::found; ++i)
            for (int k = 0; k < n; ++k)
                *(double *)(at[K::given + i] + (begin + k)*steps[K::given + i]) = found[i][k];
    }
    return all;
}

/* One ufunc's inner loop in one precision. */
template <auto f, class... Of>
void loop(char **at, npy_intp const *sizes, npy_intp const *steps, void *) {
    using K = Kernel<decltype(f), Of...>;
    bool all = true;
    if constexpr (counts<f>) all = filtered_loop<f, Of...>(at, sizes[0], steps);
    else if constexpr (in_blocks<f>() != nullptr) all = blocked_loop<f, Of...>(at, sizes[0], steps);
    else for (npy_intp n = 0; n < sizes[0]; ++n) {
        typename K::T x[K::given];
        typename K::Found y[K::found];
        for (int i = 0; i < K::given; ++i) x[i] = *(typename K::T *)(at[i] + n*steps[i]);
        K::call(f, x, y);
        for (int i = 0; i < K::found; ++i)
            *(typename K::Found *)(at[K::given + i] + n*steps[K::given + i]) = y[i];
        /* NaN tells that it may be outside; a count is -1 there, and a verdict is no */
        if (y[0] != y[0] || (K::found == 1 && !(y[0] > 0))) all &= K::inside(x);
    }
    if (!all) strayed = true;
    std::feclearexcept(FE_ALL_EXCEPT); /* what is out of range is told by NaN */
}

/* Whether it is a number of Python's, a whole one that a double has; then it is in x. */
bool given(PyObject *from, double *x) {
    if (PyFloat_CheckExact(from) || PyArray_IsScalar(from, Double)) {
        *x = PyFloat_AS_DOUBLE(from);
        return true;
    }
    if (!PyLong_CheckExact(from)) return false;
    int over = 0;
    const long long whole = PyLong_AsLongLongAndOverflow(from, &over);
    *x = double(whole);
    return !over && whole <= (1LL << 53) && whole >= -(1LL << 53);
}

PyObject *number(double value) {
    PyObject *made = PyArrayScalar_New(Double);
    if (made != nullptr) PyArrayScalar_ASSIGN(made, Double, value);
    return made;
}

/* What the ufunc gives, of numbers: one of NumPy's or a tuple of them, or None. */
template <auto f, class... Of>
PyObject *one(PyObject *, PyObject *const *args, Py_ssize_t count) {
    using K = Kernel<decltype(f), Of...>;
    double x[K::given];
    typename K::Found y[K::found];
    if (count != K::given) Py_RETURN_NONE;
    for (int i = 0; i < K::given; ++i)
        if (!given(args[i], x + i)) Py_RETURN_NONE;
    if constexpr (counts<f> || in_blocks<f>() != nullptr) {
        char *at[K::all];
        for (int i = 0; i < K::given; ++i) at[i] = (char *)(x + i);
        for (int i = 0; i < K::found; ++i) at[K::given + i] = (char *)(y + i);
        const npy_intp steps[K::all] = {};
        if constexpr (counts<f>) filtered_loop<f>(at, 1, steps);
        else blocked_loop<f>(at, 1, steps);
    } else K::call(f, x, y);
    if (!K::inside(x)) Py_RETURN_NONE;
    for (int i = 0; i < K::found; ++i)
        if (y[i] != y[i]) Py_RETURN_NONE;
    if constexpr (K::truth) {
        if (y[0]) PyArrayScalar_RETURN_TRUE;
        PyArrayScalar_RETURN_FALSE;
    } else {
        if (K::found == 1) return number(y[0]);
        PyObject *all = PyTuple_New(K::found);
        for (int i = 0; all != nullptr && i < K::found; ++i) {
            PyObject *made = number(y[i]);
            if (made == nullptr) Py_CLEAR(all);
            else PyTuple_SET_ITEM(all, i, made);
        }
        return all;
    }
}

PyObject *outside(PyObject *, PyObject *) {
    return PyBool_FromLong(std::exchange(strayed, false));
}

/* A ufunc of floats and of doubles: NumPy takes the first that is safe. */
template <auto single, auto in_two, class... Of>
int add(PyObject *module, const char *name, const char *about) {
    using K = Kernel<decltype(in_two), Of...>;
    using First = typename Kernel<decltype(single), Of...>::T;
    static PyUFuncGenericFunction loops[] = {loop<single, Of...>, loop<in_two, Of...>};
    static void *data[] = {nullptr, nullptr};
    static char types[2*K::all];
    for (int i = 0; i < 2*K::all; ++i)
        types[i] = char(i % K::all >= K::given && K::truth ? NPY_BOOL
                        : i < K::all && sizeof(First) == 4 ? NPY_FLOAT : NPY_DOUBLE);
    PyObject *made = PyUFunc_FromFuncAndData(loops, data, types, 2, K::given, K::found,
                                             PyUFunc_None, name, about, 0);
    const int failed = made == nullptr || PyModule_AddObjectRef(module, name, made);
    Py_XDECREF(made);
    return failed;
}

#define SCALAR(name, function, ...) \
    {"one_" #name, (PyCFunction)(void (*)(void))one<function, __VA_ARGS__>, METH_FASTCALL, \
     "Scalar version; None if an argument is no number or out of range, or a result is NaN."},
#define ONE(name, about, ...) SCALAR(name, haptic_##name, __VA_ARGS__)
#define LOOP in_alpha, in_beta, in_gamma, in_delta

PyMethodDef functions[] = {
    KERNELS(ONE)
    SCALAR(max_delay, max_delay, LOOP)
    SCALAR(delay_margin, delay_margin, LOOP, in_d)
    SCALAR(limit_at, limit_at, in_beta, in_gamma, in_delta, in_d)
    {"outside", outside, METH_NOARGS,
     "Whether an argument was NaN or out of range since this thread last asked."},
    {nullptr, nullptr, 0, nullptr}};

#define ADD(name, about, ...) \
    || add<haptic_single_##name, haptic_##name, __VA_ARGS__>(module, #name, about)
#define ADD_INSIDE(name, about) || add<haptic_single_##name, haptic_##name>(module, #name, about)

int loaded(PyObject *module) {
    import_array1(-1);
    import_umath1(-1);
    return PyModule_AddStringConstant(module, "STAMP", STAMP) KERNELS(ADD) INSIDE(ADD_INSIDE)
        || add<filtered, filtered>(module, "certain_roots",
               "roots outside the circle of (alpha, beta, gamma, delta, d)\n\n"
               "Where doubles with proved bounds are enough; -1 where not, -2 for at least one.\n")
        || add<max_delay, max_delay, LOOP>(module, "max_delay",
               "the largest delay of (alpha, beta, gamma, delta)\n\n"
               "NaN where it needs more than doubles, and where an argument is out of range.\n")
        || add<delay_margin, delay_margin, LOOP, in_d>(module, "delay_margin",
               "the delay that may be added to d, of (alpha, beta, gamma, delta, d)\n\n"
               "NaN where it needs more than doubles, and where an argument is out of range.\n")
        || add<limit_at, limit_at, in_beta, in_gamma, in_delta, in_d>(module, "limit_at",
               "alpha, theta of (beta, gamma, delta, d)\n\n"
               "NaN where it needs more than doubles, and where an argument is out of range.\n")
        ? -1 : 0;
}

PyModuleDef_Slot slots[] = {{Py_mod_exec, (void *)loaded}, {0, nullptr}};
PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_compiled", "The stable forms as ufuncs.", 0,
                          functions, slots, nullptr, nullptr, nullptr};

} // namespace

PyMODINIT_FUNC PyInit__compiled(void) { return PyModuleDef_Init(&definition); }
