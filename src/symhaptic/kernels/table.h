/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#ifndef TABLE_H
#define TABLE_H

#include <math.h>

#define STAMP "74033439a6099cd0"

extern "C" {
void haptic_discretize(double gamma, double delta, double *n1_out, double *n0_out, double *a_out,
    double *e_out);
void haptic_discretize_fractional(double gamma, double delta, double epsilon, double *m2_out,
    double *m1_out, double *m0_out, double *a_out, double *e_out);
bool haptic_is_stable(double alpha, double beta, double gamma, double delta, double d);
double haptic_unstable_roots(double alpha, double beta, double gamma, double delta, double d);
void haptic_stability_boundary(double theta, double gamma, double delta, double d,
    double *alpha_out, double *beta_out);
void haptic_max_stable_stiffness(double gamma, double delta, double d, double *alpha_out,
    double *beta_out, double *theta_out);
double haptic_passivity_margin_at(double theta, double alpha, double beta, double delta, double d);
double haptic_passivity_margin(double alpha, double beta, double delta, double d);
void haptic_passivity_boundary(double theta, double delta, double d, double *alpha_out,
    double *beta_out);
void haptic_max_passive_stiffness(double delta, double d, double *alpha_out, double *beta_out,
    double *theta_out);
double haptic_linear_limit(double beta, double delta, double d);
void haptic_late_device(double gamma, double delta, double part, double *apart_out, double *m2_out,
    double *kicked_out, double *m0_out);
void haptic_single_discretize(float gamma, float delta, float *n1_out, float *n0_out, float *a_out,
    float *e_out);
void haptic_single_discretize_fractional(float gamma, float delta, float epsilon, float *m2_out,
    float *m1_out, float *m0_out, float *a_out, float *e_out);
bool haptic_single_is_stable(float alpha, float beta, float gamma, float delta, float d);
float haptic_single_unstable_roots(float alpha, float beta, float gamma, float delta, float d);
void haptic_single_stability_boundary(float theta, float gamma, float delta, float d,
    float *alpha_out, float *beta_out);
void haptic_single_max_stable_stiffness(float gamma, float delta, float d, float *alpha_out,
    float *beta_out, float *theta_out);
float haptic_single_passivity_margin_at(float theta, float alpha, float beta, float delta, float d);
float haptic_single_passivity_margin(float alpha, float beta, float delta, float d);
void haptic_single_passivity_boundary(float theta, float delta, float d, float *alpha_out,
    float *beta_out);
void haptic_single_max_passive_stiffness(float delta, float d, float *alpha_out, float *beta_out,
    float *theta_out);
float haptic_single_linear_limit(float beta, float delta, float d);
void haptic_single_late_device(float gamma, float delta, float part, float *apart_out,
    float *m2_out, float *kicked_out, float *m0_out);
}

/* What is true of each argument inside its range alone. */
struct in_gamma {
    static bool inside(double gamma) { return gamma >= 0.0 && gamma <= 1e+15; }
    static bool inside(float gamma) { return gamma >= 0.0f && gamma <= 1e+07f; }
};
struct in_delta {
    static bool inside(double delta) { return delta >= 0.0 && delta <= 1e+70; }
    static bool inside(float delta) { return delta >= 0.0f && delta <= 1e+08f; }
};
struct in_epsilon {
    static bool inside(double epsilon) { return epsilon >= 0.0 && epsilon < 1.0; }
    static bool inside(float epsilon) { return epsilon >= 0.0f && epsilon < 1.0f; }
};
struct in_alpha {
    static bool inside(double alpha) { return fabs(alpha) <= 1e+70; }
    static bool inside(float alpha) { return fabsf(alpha) <= 1e+08f; }
};
struct in_beta {
    static bool inside(double beta) { return fabs(beta) <= 1e+70; }
    static bool inside(float beta) { return fabsf(beta) <= 1e+08f; }
};
struct in_d {
    static bool inside(double d) { return d >= 0.0 && d <= 1e+15; }
    static bool inside(float d) { return d >= 0.0f && d <= 1e+06f; }
};
struct in_theta {
    static bool inside(double theta) { return theta > 0.0 && theta <= 3.141592653589793; }
    static bool inside(float theta) { return theta > 0.0f && theta <= 3.1415925f; }
};

/* Each kernel with what it says and its arguments. */
#define KERNELS(KERNEL) \
KERNEL(discretize, \
    "n1, n0, a, e of (gamma, delta)\n" \
    "\n" \
    "the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m.\n" \
    "gamma: physical stiffness, k T^2/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "Results: n1; n0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].\n" \
    "Domain: gamma >= 0, delta >= 0.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or gamma larger than 1e15.\n", in_gamma, in_delta) \
KERNEL(discretize_fractional, \
    "m2, m1, m0, a, e of (gamma, delta, epsilon)\n" \
    "\n" \
    "the sampled device with a delay of epsilon periods, P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z + e)) in units of T^2/m.\n" \
    "gamma: physical stiffness, k T^2/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "epsilon: rest of a delay, a fraction of a period [1]\n" \
    "Results: m2; m1; m0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].\n" \
    "Domain: gamma >= 0, delta >= 0, 0 <= epsilon < 1.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or gamma larger than 1e15.\n", in_gamma, in_delta, in_epsilon) \
KERNEL(is_stable, \
    "stable of (alpha, beta, gamma, delta, d)\n" \
    "\n" \
    "whether all characteristic roots lie inside the unit circle.\n" \
    "alpha: virtual stiffness, K T^2/m [1]\n" \
    "beta: virtual damping, B T/m [1]\n" \
    "gamma: physical stiffness, k T^2/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) rounds to a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|, gamma) < 2^-400 (single: 2^-40).\n" \
    "False outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n", in_alpha, in_beta, in_gamma, in_delta, in_d) \
KERNEL(unstable_roots, \
    "roots of (alpha, beta, gamma, delta, d)\n" \
    "\n" \
    "number of characteristic roots outside the unit circle.\n" \
    "alpha: virtual stiffness, K T^2/m [1]\n" \
    "beta: virtual damping, B T/m [1]\n" \
    "gamma: physical stiffness, k T^2/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) rounds to a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|, gamma) < 2^-400 (single: 2^-40).\n" \
    "-1 outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n", in_alpha, in_beta, in_gamma, in_delta, in_d) \
KERNEL(stability_boundary, \
    "alpha, beta of (theta, gamma, delta, d)\n" \
    "\n" \
    "the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).\n" \
    "theta: angle on the unit circle, omega T [1]\n" \
    "gamma: physical stiffness, k T^2/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].\n" \
    "Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n", in_theta, in_gamma, in_delta, in_d) \
KERNEL(max_stable_stiffness, \
    "alpha, beta, theta of (gamma, delta, d)\n" \
    "\n" \
    "the wall of largest stable stiffness, a limit that is not stable itself, and the angle theta = omega T of its roots on the unit circle.\n" \
    "gamma: physical stiffness, k T^2/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta, angle on the unit circle, omega T [1].\n" \
    "Domain: gamma >= 0, delta >= 0, d >= 0, gamma <= 9.8, sqrt(gamma) (d + 1) <= pi or d <= 1, delta = 0 or delta >= 5 ulp(1) if sqrt(gamma) (d + 1) > pi, NaN elsewhere, and if no wall is stable, or none that is slightly softer.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or gamma or d larger than 1e15.\n", in_gamma, in_delta, in_d) \
KERNEL(passivity_margin_at, \
    "margin of (theta, alpha, beta, delta, d)\n" \
    "\n" \
    "physical damping minus the damping that the wall requires at the angle theta = omega T; a wall with alpha >= 0 is passive if this is not negative at any angle.\n" \
    "theta: angle on the unit circle, omega T [1]\n" \
    "alpha: virtual stiffness, K T^2/m [1]\n" \
    "beta: virtual damping, B T/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Domain: 0 < theta < pi, delta >= 0, d >= 0.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.\n", in_theta, in_alpha, in_beta, in_delta, in_d) \
KERNEL(passivity_margin, \
    "margin of (alpha, beta, delta, d)\n" \
    "\n" \
    "physical damping minus the damping that the wall requires at its worst angle; the wall is passive if this is not negative.\n" \
    "alpha: virtual stiffness, K T^2/m [1]\n" \
    "beta: virtual damping, B T/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Domain: delta >= 0, d >= 0, -inf for alpha < 0.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.\n", in_alpha, in_beta, in_delta, in_d) \
KERNEL(passivity_boundary, \
    "alpha, beta of (theta, delta, d)\n" \
    "\n" \
    "the wall that is just passive and whose worst angle is theta = omega T.\n" \
    "theta: angle on the unit circle, omega T [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].\n" \
    "Domain: 0 < theta < pi, delta >= 0, d >= 0, NaN beyond the angle where alpha is 0: pi/(d + 1) for integer delays, for d <= 2/9 the curve continues to pi.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.\n", in_theta, in_delta, in_d) \
KERNEL(max_passive_stiffness, \
    "alpha, beta, theta of (delta, d)\n" \
    "\n" \
    "the passive wall of largest stiffness, and its worst angle theta = omega T.\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta, angle on the unit circle, omega T [1].\n" \
    "Domain: delta >= 0, d >= 0.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.\n", in_delta, in_d) \
KERNEL(linear_limit, \
    "alpha of (beta, delta, d)\n" \
    "\n" \
    "the stiffness alpha at which the linear condition is an equality.\n" \
    "beta: virtual damping, B T/m [1]\n" \
    "delta: physical damping, b T/m [1]\n" \
    "d: delay in sampling periods, t_d/T [1]\n" \
    "Domain: delta >= 0, d >= 0.\n" \
    "NaN outside it, and if an argument is NaN or larger than 1e70 or d larger than 1e15.\n", in_beta, in_delta, in_d)

#define INSIDE(KERNEL) \
KERNEL(late_device, \
    "apart, m2, kicked, m0 of (gamma, delta, part)\n" \
    "\n" \
    "m2 - m1 + m0, m2, displacement by an impulse in the rest of the period, m0.\n")

#endif
