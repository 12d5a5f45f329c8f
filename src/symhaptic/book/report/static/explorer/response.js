// The position after a push, at the sampling instants, by the sampled device of the kernels.
"use strict";
(() => {
  const MOST = 1500;

  // in units of F T^2/m: the push acts at once, the wall's force after the delay
  explorer.response = (n) => {
    const whole = Math.floor(n.d);
    const [n1, n0, a, e] = haptic.discretize(n.gamma, n.delta);
    const [m2, m1, m0] = haptic.discretize_fractional(n.gamma, n.delta, n.d - whole);
    const swing = Math.sqrt(Math.abs(n.alpha + n.gamma)) || 0.05;
    const count = Math.max(60, Math.min(MOST, Math.ceil((8 * Math.PI) / swing + 6 * n.d)));
    const x = [];
    const v = [];
    const [above, below] = explorer.coefficients(n.filter);
    const past = (row, from, i, first) => row.reduce((sum, each, j) => sum + (j >= first ? each * (from[i - j] ?? 0) : 0), 0);
    const force = (i) => (i < 0 ? 0 : n.alpha * x[i] + n.beta * v[i]);
    for (let i = 0; i <= count; ++i) {
      const own = a * (x[i - 1] ?? 0) - e * (x[i - 2] ?? 0);
      const push = (i > 0 ? n1 : 0) + (i > 1 ? n0 : 0);
      const at = i - whole - 1;
      const wall = m2 * force(at) + m1 * force(at - 1) + m0 * force(at - 2);
      const next = own + push - wall;
      if (!(Math.abs(next) < 1e9)) break;
      x.push(next);
      v.push(past(above, x, i, 0) - past(below, v, i, 1));
    }
    return x;
  };
})();
