/* Written by `symhaptic kernels` from the stable forms; do not edit. */
#ifndef HAPTIC_SINGLE_H
#define HAPTIC_SINGLE_H

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * the sampled device, P(z) = (n1 z + n0)/(z^2 - a z + e) in units of T^2/m.
 * gamma: physical stiffness, k T^2/m [1]
 * delta: physical damping, b T/m [1]
 * Results: n1; n0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].
 * Domain: gamma >= 0, delta >= 0.
 * NaN outside, and where an argument is NaN or larger than 1e8.
 */
void haptic_single_discretize(float gamma, float delta, float *n1_out, float *n0_out, float *a_out,
    float *e_out);

/*
 * the sampled device behind a delay of epsilon periods, P(z) = (m2 z^2 + m1 z + m0)/(z (z^2 - a z +
 * e)) in units of T^2/m.
 * gamma: physical stiffness, k T^2/m [1]
 * delta: physical damping, b T/m [1]
 * epsilon: rest of a delay, a fraction of a period [1]
 * Results: m2; m1; m0; a, trace of the sampled plant [1]; e, determinant of the sampled plant [1].
 * Domain: gamma >= 0, delta >= 0, 0 <= epsilon < 1.
 * NaN outside, and where an argument is NaN or larger than 1e8.
 */
void haptic_single_discretize_fractional(float gamma, float delta, float epsilon, float *m2_out,
    float *m1_out, float *m0_out, float *a_out, float *e_out);

/*
 * whether all characteristic roots lie inside the unit circle.
 * alpha: virtual stiffness, K T^2/m [1]
 * beta: virtual damping, B T/m [1]
 * gamma: physical stiffness, k T^2/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) where sqrt(gamma) is,
 * rounded, a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|,
 * gamma) < 2^-400 (single: 2^-40).
 * False outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
bool haptic_single_is_stable(float alpha, float beta, float gamma, float delta, float d);

/*
 * number of characteristic roots outside the unit circle.
 * alpha: virtual stiffness, K T^2/m [1]
 * beta: virtual damping, B T/m [1]
 * gamma: physical stiffness, k T^2/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Domain: gamma >= 0, delta >= 0, d >= 0, delta = 0 or delta >= 5 ulp(1) where sqrt(gamma) is,
 * rounded, a multiple of pi, no wall with |alpha| + |beta| + delta < 2^-400 or 0 < max(|alpha|,
 * gamma) < 2^-400 (single: 2^-40).
 * -1 outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
float haptic_single_unstable_roots(float alpha, float beta, float gamma, float delta, float d);

/*
 * the wall (alpha, beta) that puts a characteristic root at z = exp(j theta).
 * theta: angle on the unit circle, omega T [1]
 * gamma: physical stiffness, k T^2/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].
 * Domain: 0 < theta < pi, gamma >= 0, delta >= 0, d >= 0.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
void haptic_single_stability_boundary(float theta, float gamma, float delta, float d,
    float *alpha_out, float *beta_out);

/*
 * the wall of largest stable stiffness, a limit that is not stable itself, and the angle theta =
 * omega T of its roots on the unit circle.
 * gamma: physical stiffness, k T^2/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta, angle on
 * the unit circle, omega T [1].
 * Domain: gamma >= 0, delta >= 0, d >= 0, gamma <= 9.8, sqrt(gamma) (d + 1) <= pi or d <= 1, delta
 * = 0 or delta >= 5 ulp(1) if sqrt(gamma) (d + 1) > pi, NaN elsewhere, and where no wall is stable
 * or none that is a little softer.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
void haptic_single_max_stable_stiffness(float gamma, float delta, float d, float *alpha_out,
    float *beta_out, float *theta_out);

/*
 * physical damping minus the damping that the wall needs at the angle theta = omega T; a wall with
 * alpha >= 0 is passive where this is not negative at any angle.
 * theta: angle on the unit circle, omega T [1]
 * alpha: virtual stiffness, K T^2/m [1]
 * beta: virtual damping, B T/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Domain: 0 < theta < pi, delta >= 0, d >= 0.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
float haptic_single_passivity_margin_at(float theta, float alpha, float beta, float delta, float d);

/*
 * physical damping minus the damping that the wall needs at its worst angle; the wall is passive
 * where it is not negative.
 * alpha: virtual stiffness, K T^2/m [1]
 * beta: virtual damping, B T/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Domain: delta >= 0, d >= 0, -inf for alpha < 0.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
float haptic_single_passivity_margin(float alpha, float beta, float delta, float d);

/*
 * the wall that is just passive and whose worst angle is theta = omega T.
 * theta: angle on the unit circle, omega T [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1].
 * Domain: 0 < theta < pi, delta >= 0, d >= 0, NaN beyond the angle where alpha is 0: pi/(d + 1) for
 * whole delays, for d <= 2/9 the curve goes on to pi.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
void haptic_single_passivity_boundary(float theta, float delta, float d, float *alpha_out,
    float *beta_out);

/*
 * the passive wall of largest stiffness, and its worst angle theta = omega T.
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Results: alpha, virtual stiffness, K T^2/m [1]; beta, virtual damping, B T/m [1]; theta, angle on
 * the unit circle, omega T [1].
 * Domain: delta >= 0, d >= 0.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
void haptic_single_max_passive_stiffness(float delta, float d, float *alpha_out, float *beta_out,
    float *theta_out);

/*
 * the stiffness alpha at which the linear condition is an equality.
 * beta: virtual damping, B T/m [1]
 * delta: physical damping, b T/m [1]
 * d: delay in sampling periods, t_d/T [1]
 * Domain: delta >= 0, d >= 0.
 * NaN outside, and where an argument is NaN or larger than 1e8 or d larger than 1e6.
 */
float haptic_single_linear_limit(float beta, float delta, float d);

#ifdef __cplusplus
}
#endif

#endif
