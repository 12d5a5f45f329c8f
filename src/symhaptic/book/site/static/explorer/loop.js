// A loop in SI units: its numbers of Table I, its limits, and how it moves. All verdicts and numbers
// are those of the exported functions, haptic.*; what is searched here is searched with them.
"use strict";
globalThis.explorer = globalThis.explorer || {};

explorer.numbers = (s) => {
  const m = s.mD + s.mH, T = s.T / 1000;
  return {
    m, T,
    alpha: s.K * T * T / m, beta: s.B * T / m, gamma: s.kH * T * T / m,
    delta: (s.bD + s.bH) * T / m, own: s.bD * T / m, d: s.td / s.T,
    K: m / (T * T), B: m / T, hertz: 1 / (2 * Math.PI * T),
  };
};

explorer.limits = (s) => {
  const n = explorer.numbers(s);
  const stable = haptic.max_stable_stiffness(n.gamma, n.delta, n.d);
  const passive = haptic.max_passive_stiffness(n.own, n.d);
  const margin = haptic.passivity_margin(n.alpha, n.beta, n.own, n.d);
  const wall = (found) => ({ K: found[0] * n.K, B: found[1] * n.B, f: found[2] * n.hertz });
  return {
    n,
    stable: haptic.is_stable(n.alpha, n.beta, n.gamma, n.delta, n.d),
    passive: margin >= 0, margin: margin * n.B,
    stiffest: wall(stable), stiffestPassive: wall(passive),
    here: explorer.highest(stable[0] * 1.2, (a) => haptic.is_stable(a, n.beta, n.gamma, n.delta, n.d)) * n.K,
    passiveHere: explorer.highest(passive[0] * 1.05, (a) => haptic.passivity_margin(a, n.beta, n.own, n.d) >= 0) * n.K,
    later: explorer.later(n),
  };
};

// the first border when the stiffness is raised from nothing; NaN where none is allowed
explorer.highest = (top, allowed) => {
  const steps = 60;
  let low = top * 1e-9, last = NaN;
  if (!allowed(low)) return NaN;
  for (let i = 1; i <= steps; i++) {
    const next = top * i / steps;
    if (!allowed(next)) { last = next; break; }
    low = next;
  }
  if (Number.isNaN(last)) return low;
  for (let i = 0; i < 48; i++) {
    const middle = (low + last) / 2;
    if (middle <= low || middle >= last) break;
    if (allowed(middle)) low = middle; else last = middle;
  }
  return low;
};

// how many more milliseconds of delay until the first loop, in steps of 1/16 period, that is not stable
explorer.later = (n) => {
  const stable = (d) => haptic.is_stable(n.alpha, n.beta, n.gamma, n.delta, d);
  if (!stable(n.d)) return NaN;
  let low = n.d, step = 1 / 16;
  for (let i = 0; i < 260; i++) {
    const next = low + step;
    if (!stable(next)) {
      let good = low, bad = next;
      for (let j = 0; j < 40; j++) {
        const middle = (good + bad) / 2;
        if (stable(middle)) good = middle; else bad = middle;
      }
      return (good - n.d) * n.T * 1000;
    }
    low = next;
    if (i > 120) step *= 1.06;
  }
  return Infinity;
};

explorer.rules = (s) => {
  const n = explorer.numbers(s), b = s.bD + s.bH, late = s.td / 1000 + n.T / 2;
  const told = (name, latex, K, B) => ({
    name, latex, K, B,
    stable: K > 0 && haptic.is_stable(K / n.K, B / n.B, n.gamma, n.delta, n.d),
  });
  return [
    told("twice-damping", "2b/T, with B = 0", 2 * b / n.T, 0),
    told("damping-over-delay", "(b + B)/(t_d + T/2)", (b + s.B) / late, s.B),
    told("four-masses", "4m/T\u00b2, with B = 0", 4 * n.m / (n.T * n.T), 0),
  ];
};

// the way x/x_static after a push of 1 N that stays, one value a period: held forces, the exact delay
explorer.motion = (s, periods) => {
  const n = explorer.numbers(s), whole = Math.floor(n.d), part = n.d - whole;
  const [m2, m1, m0, a, e] = haptic.discretize_late(n.gamma, n.delta, part);
  const [n1, n0] = haptic.discretize_late(n.gamma, n.delta, 0);
  const x = [], F = [];
  const at = (list, k) => (k < 0 ? 0 : list[k]);
  for (let k = 0; k < periods; k++) {
    const j = k - whole;
    const held = m2 * at(F, j - 1) + m1 * at(F, j - 2) + m0 * at(F, j - 3);
    const pushed = (k >= 1 ? n1 : 0) + (k >= 2 ? n0 : 0);
    x.push(a * at(x, k - 1) - e * at(x, k - 2) + pushed + held);
    F.push(-(n.alpha * x[k] + n.beta * (x[k] - at(x, k - 1))));
    if (!(Math.abs(x[k]) < 1e9)) break;
  }
  return x.map((way) => way * n.T * n.T / n.m);
};
