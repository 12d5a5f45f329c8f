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

/* One ufunc's inner loop in one precision. */
template <auto f, class... Of>
void loop(char **at, npy_intp const *sizes, npy_intp const *steps, void *) {
    using K = Kernel<decltype(f), Of...>;
    bool all = true;
    for (npy_intp n = 0; n < sizes[0]; ++n) {
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
    K::call(f, x, y);
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
    static PyUFuncGenericFunction loops[] = {loop<single, Of...>, loop<in_two, Of...>};
    static void *data[] = {nullptr, nullptr};
    static char types[2*K::all];
    for (int i = 0; i < 2*K::all; ++i)
        types[i] = char(i % K::all >= K::given && K::truth ? NPY_BOOL
                        : i < K::all ? NPY_FLOAT : NPY_DOUBLE);
    PyObject *made = PyUFunc_FromFuncAndData(loops, data, types, 2, K::given, K::found,
                                             PyUFunc_None, name, about, 0);
    const int failed = made == nullptr || PyModule_AddObjectRef(module, name, made);
    Py_XDECREF(made);
    return failed;
}

#define ONE(name, about, ...) \
    {"one_" #name, (PyCFunction)(void (*)(void))one<haptic_##name, __VA_ARGS__>, METH_FASTCALL, \
     "Scalar version; None if an argument is no number or out of range, or a result is NaN."},

PyMethodDef functions[] = {
    KERNELS(ONE)
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
        ? -1 : 0;
}

PyModuleDef_Slot slots[] = {{Py_mod_exec, (void *)loaded}, {0, nullptr}};
PyModuleDef definition = {PyModuleDef_HEAD_INIT, "_compiled", "The stable forms as ufuncs.", 0,
                          functions, slots, nullptr, nullptr, nullptr};

} // namespace

PyMODINIT_FUNC PyInit__compiled(void) { return PyModuleDef_Init(&definition); }
