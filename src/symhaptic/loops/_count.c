/* roots_inside of count.py for walls whose polynomials are short, one after the other.

   The same steps, in the same order: where |A| = |W| and where A and W cross the real axis, as roots
   of polynomials in x = 2 - 2 cos(theta); on the arcs between, turns of the larger part and
   principal values at both ends.  An arc on which the parts themselves tell otherwise is halved. */

#define PY_SSIZE_T_CLEAN
#include <Python.h>
#include <math.h>

enum { SIZE = 17, ENDS = 3 * SIZE + 2, DEEPEST = 50 };

static const double PI = 3.141592653589793238, TERMS = 16;

/* by Horner's rule, of n coefficients */
static double real_value(const double *q, int n, double x)
{
    double found = q[n - 1];
    for (int k = n - 2; k >= 0; k--)
        found = found * x + q[k];
    return found;
}

static double middle(double low, double high)
{
    if (high > 4 * low)
        return sqrt(fmax(low, 1e-20) * high);
    return (low + high) / 2;
}

/* the root of q, whose derivative is slope, between two places where its signs differ */
static double between(const double *q, const double *slope, int n, double low, double high, int before)
{
    double x = middle(low, high);
    for (int k = 0; k < 80; k++) {
        double here = real_value(q, n, x);
        if (here == 0)
            break;
        if ((here < 0) == before)
            low = x;
        else
            high = x;
        double step = x - here / real_value(slope, n - 1, x);
        if (!(step > low && step < high))
            step = middle(low, high);
        if (fabs(step - x) <= 4e-16 * fabs(x)) {
            x = step;
            break;
        }
        x = step;
    }
    return x;
}

/* where a polynomial of n coefficients changes its sign for 0 < x < 4; how many places */
static int real_roots(const double *q, int n, double *roots)
{
    double chain[SIZE][SIZE];
    int found = 0;
    for (int k = 0; k < n; k++)
        chain[0][k] = q[k];
    for (int d = 1; d < n; d++)
        for (int k = 0; k < n - d; k++)
            chain[d][k] = chain[d - 1][k + 1] * (k + 1);
    for (int d = n - 2; d >= 0; d--) {
        double ends[SIZE + 1], next[SIZE];
        int many = 0;
        ends[0] = 0;
        for (int k = 0; k < found; k++)
            ends[k + 1] = roots[k];
        ends[found + 1] = 4;
        int negative = real_value(chain[d], n - d, 0) < 0;
        for (int k = 0; k <= found; k++) {
            int then = real_value(chain[d], n - d, ends[k + 1]) < 0;
            if (then != negative)
                next[many++] = between(chain[d], chain[d + 1], n - d, ends[k], ends[k + 1], negative);
            negative = then;
        }
        found = many;
        for (int k = 0; k < found; k++)
            roots[k] = next[k];
    }
    return found;
}

/* w^k + its conjugate, and Im w^k/sin(theta), as polynomials in x */
static double sums[SIZE + 1][SIZE + 1] = {{2}, {0, -1}}, parts[SIZE + 1][SIZE + 1] = {{0}, {1}};

static void powers(void)
{
    for (int k = 1; k < SIZE; k++)
        for (int i = 0; i < SIZE; i++) {
            sums[k + 1][i + 1] = -(sums[k][i] + sums[k - 1][i]);
            parts[k + 1][i + 1] = -(parts[k][i] + parts[k - 1][i]);
        }
}

/* |q|^2 on the circle as a polynomial in x */
static void squared(const double *q, int n, double *found)
{
    for (int i = 0; i < n; i++)
        found[i] = 0;
    for (int i = 0; i < n; i++) {
        found[i] += q[i] * q[i];
        for (int j = i + 1; j < n; j++)
            for (int k = 0; k <= j - i; k++)
                found[i + k] += q[i] * q[j] * sums[j - i][k];
    }
}

/* Im q/sin(theta) on the circle as a polynomial in x, of n - 1 coefficients */
static void imaginary(const double *q, int n, double *found)
{
    for (int i = 0; i + 1 < n; i++) {
        found[i] = 0;
        for (int k = i + 1; k < n; k++)
            found[i] += q[k] * parts[k][i];
    }
}

typedef struct { double re, im; } point;

static point value(const double *q, int n, point at)
{
    point found = {q[n - 1], 0};
    for (int k = n - 2; k >= 0; k--) {
        double re = found.re * at.re - found.im * at.im + q[k];
        found.im = found.re * at.im + found.im * at.re;
        found.re = re;
    }
    return found;
}

/* what a coefficient's rounding costs: the sum of the sizes of all terms, for |w| = r */
static double terms(const double *q, int n, double r)
{
    double found = fabs(q[n - 1]);
    for (int k = n - 2; k >= 0; k--)
        found = found * r + fabs(q[k]);
    return found;
}

/* the angle of b/a */
static double turn(point a, point b)
{
    double re = b.re * a.re + b.im * a.im, im = b.im * a.re - b.re * a.im;
    return re == 0 && im == 0 ? 0 : atan2(im, re);
}

/* the angle of 1 + b/a */
static double beside(point a, point b)
{
    point both = {a.re + b.re, a.im + b.im};
    return turn(a, both);
}

static double size(point a)
{
    return a.re * a.re + a.im * a.im;
}

static void sort(double *x, int n)
{
    for (int i = 1; i < n; i++) {
        double one = x[i];
        int k = i;
        for (; k > 0 && x[k - 1] > one; k--)
            x[k] = x[k - 1];
        x[k] = one;
    }
}

typedef struct { const double *A, *W; int a, w; double M, nearest; } loop;

/* values on the circle; late is z^M A, and apart |p|^2 over the larger part */
typedef struct { double theta, apart; point device, wall, late; } place;

static place in_the_middle(const loop *p, double one, double two)
{
    double theta = (one + two) / 2, s = sin(theta / 2);
    point on = {-2 * s * s, sin(theta)};
    return (place){theta, 0, value(p->A, p->a, on), value(p->W, p->w, on), {0, 0}};
}

/* an end of an arc: z^M A there, and how near p comes to 0 */
static void ends_there(loop *p, place *end)
{
    point spin = {cos(p->M * end->theta), sin(p->M * end->theta)}, of = end->device;
    end->late = (point){of.re * spin.re - of.im * spin.im, of.re * spin.im + of.im * spin.re};
    point both = {end->late.re + end->wall.re, end->late.im + end->wall.im};
    double larger = fmax(size(of), size(end->wall)), r = 2 * sin(end->theta / 2);
    double least = (terms(p->A, p->a, r) + terms(p->W, p->w, r)) / TERMS;
    end->apart = larger > 0 ? size(both) / larger : 0;
    p->nearest = fmin(p->nearest, larger > 0 ? size(both) / fmax(larger, least * least) : 0);
}

/* whether |a| >= |b| at an end, but for rounding: by so much less than p is apart from 0 there */
static int outweighs(point a, point b, const place *end)
{
    return size(b) <= size(a) * (1 + 1e-14 + 1e-9 * end->apart);
}

/* whether both are in one half plane, but for rounding, or less than a right angle apart */
static int on_one_side(point a, point b)
{
    return a.im * b.im >= 0 || a.re * b.re + a.im * b.im > 0
        || a.im * a.im < 1e-20 * size(a) || b.im * b.im < 1e-20 * size(b);
}

/* the turn of p on an arc, in halves until no part changes its side and the larger one stays so */
static double turned(loop *p, const place *one, const place *two, int depth)
{
    place mid = in_the_middle(p, one->theta, two->theta);
    int leads = size(mid.device) >= size(mid.wall);
    int fits = leads
        ? outweighs(one->device, one->wall, one) && outweighs(two->device, two->wall, two)
        : outweighs(one->wall, one->device, one) && outweighs(two->wall, two->device, two);
    fits = fits && on_one_side(one->device, mid.device) && on_one_side(mid.device, two->device)
        && on_one_side(one->wall, mid.wall) && on_one_side(mid.wall, two->wall);
    if (!fits && depth < DEEPEST) {
        ends_there(p, &mid);
        return turned(p, one, &mid, depth + 1) + turned(p, &mid, two, depth + 1);
    }
    if (leads)
        return turn(one->device, mid.device) + turn(mid.device, two->device)
            + p->M * (two->theta - one->theta)
            + beside(two->late, two->wall) - beside(one->late, one->wall);
    return turn(one->wall, mid.wall) + turn(mid.wall, two->wall)
        + beside(two->wall, two->late) - beside(one->wall, one->late);
}

static void count(
    const double *A, int a, const double *W, int w, double M, const double *of_A, int many,
    const double *square, double *inside, double *near)
{
    int n = a > w ? a : w, ends = 0;
    double balance[SIZE], other[SIZE], x[ENDS];
    squared(W, w, other);
    for (int k = 0; k < n; k++)
        balance[k] = (k < a ? square[k] : 0) - (k < w ? other[k] : 0);
    x[ends++] = 0;
    ends += real_roots(balance, n, x + ends);
    if (w > 1) {
        imaginary(W, w, other);
        ends += real_roots(other, w - 1, x + ends);
    }
    for (int k = 0; k < many; k++)
        x[ends++] = of_A[k];
    sort(x, ends);
    x[ends++] = 4;
    loop p = {A, W, a, w, M, INFINITY};
    place before = {0};
    double sum = 0;
    for (int k = 0; k < ends; k++) {
        point on = {-x[k] / 2, sqrt(x[k] * (4 - x[k])) / 2};
        place end = {2 * atan2(sqrt(x[k]), sqrt(4 - x[k])), 0, value(A, a, on), value(W, w, on), {0, 0}};
        ends_there(&p, &end);
        if (k > 0)
            sum += turned(&p, &before, &end, 0);
        before = end;
    }
    *inside = sum / PI;
    *near = sqrt(p.nearest);
}

/* rows of doubles: A and M once or for each wall, W, and room for both results */
static PyObject *roots_inside(PyObject *self, PyObject *args)
{
    Py_buffer A, W, M, inside, near;
    int a, w;
    (void)self;
    if (!PyArg_ParseTuple(args, "y*iy*iy*w*w*", &A, &a, &W, &w, &M, &inside, &near))
        return NULL;
    Py_ssize_t walls = near.len / (Py_ssize_t)sizeof(double);
    Py_ssize_t loops = M.len / (Py_ssize_t)sizeof(double);
    int fits = a >= 1 && a <= SIZE && w >= 1 && w <= SIZE && inside.len == near.len
        && W.len == walls * w * (Py_ssize_t)sizeof(double) && (loops == 1 || loops == walls)
        && A.len == loops * a * (Py_ssize_t)sizeof(double);
    if (fits) {
        Py_BEGIN_ALLOW_THREADS
        double of_A[SIZE], square[SIZE], other[SIZE];
        int many = 0;
        for (Py_ssize_t k = 0; k < walls; k++) {
            const double *own = (const double *)A.buf + (loops == 1 ? 0 : k * a);
            if (k == 0 || loops > 1) {
                squared(own, a, square);
                many = 0;
                if (a > 1) {
                    imaginary(own, a, other);
                    many = real_roots(other, a - 1, of_A);
                }
            }
            count(own, a, (const double *)W.buf + k * w, w,
                  ((const double *)M.buf)[loops == 1 ? 0 : k], of_A, many, square,
                  (double *)inside.buf + k, (double *)near.buf + k);
        }
        Py_END_ALLOW_THREADS
    }
    PyBuffer_Release(&A);
    PyBuffer_Release(&W);
    PyBuffer_Release(&M);
    PyBuffer_Release(&inside);
    PyBuffer_Release(&near);
    if (!fits) {
        PyErr_SetString(PyExc_ValueError, "roots_inside: rows do not fit");
        return NULL;
    }
    Py_RETURN_NONE;
}

static PyMethodDef methods[] = {
    {"roots_inside", roots_inside, METH_VARARGS, "Fill two arrays, see count.py."},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef module = {
    PyModuleDef_HEAD_INIT, "_count", NULL, -1, methods, NULL, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit__count(void)
{
    powers();
    return PyModule_Create(&module);
}
