// Limits of a wall, by the kernels and by bisection. Stability takes gamma and delta of device and
// arm, passivity the damping n.own of the device alone.
"use strict";
(() => {
  const { largest, halved } = explorer;
  const LONGEST = 200; // periods up to which the largest delay is looked for
  const ROWS = 96; // dampings of a chart
  const BEYOND = 2.25; // times the damping of the stiffest wall, where a chart ends
  // parts of a period; if gamma is large, instability may begin and end within an eighth
  const steps = (gamma) => (gamma > 1 ? 32 : 8);

  // the largest delay, in periods, such that the loop is stable for every smaller one
  function maxDelay(n) {
    const stable = (d) => explorer.stable(n, n.alpha, n.beta, d);
    if (!stable(0)) return 0;
    const each = steps(n.gamma);
    for (let i = 1; i <= LONGEST * each; ++i) {
      if (!stable(i / each)) return halved(stable, (i - 1) / each, i / each);
    }
    return Infinity;
  }

  function passiveAt(n, most) {
    const margin = (alpha) => explorer.margin(n, alpha, n.beta);
    const best = margin(0) >= 0 ? 0 : largest(margin, 0, most, 80);
    return margin(best) >= 0 ? halved((alpha) => margin(alpha) >= 0, best, 2 * most) : NaN;
  }

  // the angle at which the wall needs most damping
  function worst(n) {
    if (n.filter) return explorer.required(n, n.alpha, n.beta)[1];
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

  // about the largest stable stiffness of each of many dampings: [alpha, beta]
  function swept(n, points, low, high) {
    const betas = Array.from({ length: ROWS + 1 }, (_, i) => low + ((high - low) * i) / ROWS);
    return explorer.lasts(n, points, betas).map((alpha, i) => [alpha, betas[i]]);
  }

  const stiffestOf = (walls) => walls.reduce((best, wall, i) => (wall[0] > (walls[best]?.[0] ?? -Infinity) ? i : best), -1);

  // dampings between which walls are stable: corners are beyond the last piece of the curve
  function dampings(n, points) {
    const there = explorer.bordering(n, points);
    const near = points.filter((_, i) => there[i] || there[i + 1]).map(([, beta]) => beta).filter(Number.isFinite);
    const [low, high] = [Math.min(-n.delta, ...near), Math.max(0, ...near)];
    return [low - 0.1 * (high - low), high + 0.1 * (high - low)];
  }

  // the stiffest stable wall of a loop, told once; searched where no kernel knows it
  const known = new WeakMap();
  function stiffest(n, points) {
    if (!n.filter) return haptic.max_stable_stiffness(n.gamma, n.delta, n.d);
    if (known.has(points)) return known.get(points);
    const walls = swept(n, points, ...dampings(n, points));
    const best = walls[stiffestOf(walls)]?.[1] ?? NaN;
    const width = walls[1][1] - walls[0][1];
    const at = (beta) => explorer.stiffestAt(n, points, beta);
    const most = (beta) => { // where nothing is stable, more the nearer to the best
      const [alpha] = at(beta);
      return Number.isNaN(alpha) ? -1e300 * (1 + Math.abs(beta - best) / width) : alpha;
    };
    const beta = largest(most, best - width, best + width, 40);
    const [alpha, theta] = at(beta);
    known.set(points, [alpha, beta, theta]);
    return known.get(points);
  }

  // passive walls are convex, so that the stiffest is found by its direction
  function stiffestPassive(n) {
    if (!n.filter) return haptic.max_passive_stiffness(n.own, n.d);
    const wall = (angle) => {
      const [alpha, beta] = [Math.cos(angle), Math.sin(angle)];
      const far = n.own / explorer.required(n, alpha, beta)[0];
      return [alpha * far, beta * far];
    };
    return wall(largest((angle) => wall(angle)[0], -Math.PI / 2, Math.PI / 2, 60));
  }

  // the largest stable stiffness from no damping to beyond the stiffest wall: [alpha, beta]
  const charts = new WeakMap();
  explorer.chart = (n, points) => {
    if (charts.has(points)) return charts.get(points);
    const [, end] = dampings(n, points);
    const whole = swept(n, points, 0, end);
    const most = whole[stiffestOf(whole)]?.[1] || end;
    const walls = swept(n, points, 0, Math.min(BEYOND * most, end));
    charts.set(points, walls.slice(0, 2 + walls.findLastIndex(([alpha]) => Number.isFinite(alpha))));
    return charts.get(points);
  };

  explorer.limits = (n, points) => {
    const stable = explorer.stable(n, n.alpha, n.beta);
    const passive = stiffestPassive(n);
    const margin = explorer.margin(n, n.alpha, n.beta);
    const delay = maxDelay(n);
    const [alpha, theta] = explorer.stiffestAt(n, points, n.beta);
    return {
      stable,
      passive: margin >= 0,
      told: explorer.passivityTold(n),
      needed: n.own - margin,
      worst: worst(n),
      alpha,
      theta,
      stiffest: stiffest(n, points),
      stiffest_passive: passive,
      passive_alpha: passiveAt(n, passive[0]),
      linear: n.filter ? NaN : haptic.linear_limit(n.beta, n.delta, n.d),
      delay,
      // what may be added: nothing to an unstable loop; not known after an instability at less delay
      delay_margin: delay > n.d ? delay - n.d : stable ? NaN : 0,
    };
  };
})();
