// Limits of a wall, by the kernels and by bisection. Stability takes gamma and delta of device and
// arm, passivity the damping n.own of the device alone.
"use strict";
(() => {
  const LONGEST = 200; // periods up to which the largest delay is looked for
  // parts of a period; if gamma is large, instability may begin and end within an eighth
  const steps = (gamma) => (gamma > 1 ? 32 : 8);

  // the largest x between two, where the first is inside and the second is not
  function halved(inside, low, high) {
    for (let i = 0; i < 64; ++i) {
      const middle = (low + high) / 2;
      if (inside(middle)) low = middle;
      else high = middle;
    }
    return low;
  }

  // where f is largest between two
  function largest(f, low, high, rounds) {
    const share = (Math.sqrt(5) - 1) / 2;
    let [one, two] = [high - share * (high - low), low + share * (high - low)];
    let [at_one, at_two] = [f(one), f(two)];
    for (let i = 0; i < rounds; ++i) {
      if (at_one > at_two) {
        [high, two, at_two] = [two, one, at_one];
        one = high - share * (high - low);
        at_one = f(one);
      } else {
        [low, one, at_one] = [one, two, at_two];
        two = low + share * (high - low);
        at_two = f(two);
      }
    }
    return (low + high) / 2;
  }

  // the largest delay, in periods, such that the loop is stable for every smaller one
  function maxDelay(n) {
    const stable = (d) => haptic.is_stable(n.alpha, n.beta, n.gamma, n.delta, d);
    if (!stable(0)) return 0;
    const each = steps(n.gamma);
    for (let i = 1; i <= LONGEST * each; ++i) {
      if (!stable(i / each)) return halved(stable, (i - 1) / each, i / each);
    }
    return Infinity;
  }

  function passiveAt(n, most) {
    const margin = (alpha) => haptic.passivity_margin(alpha, n.beta, n.own, n.d);
    const best = margin(0) >= 0 ? 0 : largest(margin, 0, most, 80);
    return margin(best) >= 0 ? halved((alpha) => margin(alpha) >= 0, best, 2 * most) : NaN;
  }

  // the angle at which the wall needs most damping
  function worst(n) {
    const needed = (theta) => -haptic.passivity_margin_at(theta, n.alpha, n.beta, n.own, n.d);
    const count = 64 * (1 + Math.min(Math.ceil(n.d), 40));
    let [best, most] = [1, -Infinity];
    for (let i = 1; i <= count; ++i) {
      const value = needed((Math.PI * i) / count);
      if (value > most) [best, most] = [i, value];
    }
    if (best === count) return Math.PI;
    return largest(needed, (Math.PI * (best - 1)) / count, (Math.PI * (best + 1)) / count, 40);
  }

  explorer.limits = (n, points) => {
    const stiffest = haptic.max_stable_stiffness(n.gamma, n.delta, n.d);
    const stable = haptic.is_stable(n.alpha, n.beta, n.gamma, n.delta, n.d);
    const passive = haptic.max_passive_stiffness(n.own, n.d);
    const margin = haptic.passivity_margin(n.alpha, n.beta, n.own, n.d);
    const delay = maxDelay(n);
    const [alpha, theta] = explorer.stiffestAt(n, points, n.beta);
    return {
      stable,
      passive: margin >= 0,
      needed: n.own - margin,
      worst: worst(n),
      alpha,
      theta,
      stiffest,
      stiffest_passive: passive,
      passive_alpha: passiveAt(n, passive[0]),
      linear: haptic.linear_limit(n.beta, n.delta, n.d),
      delay,
      // what may be added: nothing to an unstable loop; not known after an instability at less delay
      delay_margin: delay > n.d ? delay - n.d : stable ? NaN : 0,
    };
  };
})();
