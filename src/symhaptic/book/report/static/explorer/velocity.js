// Loops whose velocity is filtered. V(z), the velocity in units of 1/T over the position, is a
// quotient of quadratics q(z) = z (r + j g sin(theta)) on the circle, r = s - p x/2, x = 2 - 2 cos(theta),
// kept as [s, p, g]: the sum at z = 1, and the sum and the difference of the outer coefficients.
"use strict";
(() => {
  const DOUBT = 1e-12; // of the sizes of all terms: where less is left of them, no wall counts as stable
  const LONGEST = 200; // periods of delay up to which the table is made
  const TWICE = Math.SQRT2; // 2 D of Butterworth's filter

  // above and below of V for a time constant in sampling periods
  const once = [0, 1, 1]; // z^2 - z
  const filters = {
    "low-pass": (tau) => [once, [1, 1 + tau, 1 + tau]],
    tustin: (tau) => [[0, 0, 2], [2, 1 + 2 * tau, 1 + 2 * tau]],
    "second-order": (tau) => [once, [1, 1 + TWICE * tau + 2 * tau * tau, 1 + TWICE * tau]],
  };

  explorer.filter = (name, tau) => (filters[name] && tau > 0 ? filters[name](tau) : null);

  // the largest x between two, where the first is inside and the second is not
  explorer.halved = (inside, low, high) => {
    for (let i = 0; i < 64; ++i) {
      const middle = (low + high) / 2;
      if (inside(middle)) low = middle;
      else high = middle;
    }
    return low;
  };

  // where f is largest between two
  explorer.largest = (f, low, high, rounds) => {
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
  };

  const mix = (a, p, b, q) => p.map((each, i) => a * each + b * q[i]);
  const real = ([s, p], x) => s - (p * x) / 2;

  // |q|^2 as a polynomial in x, the lowest power first
  const square = ([s, p, g]) => [s * s, g * g - s * p, ((p - g) * (p + g)) / 4];
  const product = (f, g) => {
    const found = new Array(f.length + g.length - 1).fill(0);
    f.forEach((a, i) => g.forEach((b, j) => { found[i + j] += a * b; }));
    return found;
  };
  const at = (f, x) => f.reduceRight((sum, each) => sum * x + each, 0);

  // where a polynomial changes its sign between 0 and 4; it rises or falls between the extremes, which
  // come along. Steps of Newton's, or halves in size where the ends differ in size
  function changes(f) {
    if (f.length < 2) return [[], []];
    const slope = f.slice(1).map((each, i) => each * (i + 1));
    const [extremes] = changes(slope);
    const ends = [0, ...extremes, 4];
    const found = [];
    for (let i = 1; i < ends.length; ++i) {
      let [low, high] = [ends[i - 1], ends[i]];
      const below = at(f, low) < 0;
      if ((at(f, high) < 0) === below) continue;
      const middle = () => (high > 4 * low ? Math.sqrt(Math.max(low, 1e-20) * high) : (low + high) / 2);
      let x = middle();
      for (let turn = 0; turn < 100; ++turn) {
        const here = at(f, x);
        if ((here < 0) === below) low = x;
        else high = x;
        const next = x - here / at(slope, x);
        const step = next > low && next < high ? next : middle();
        const done = Math.abs(step - x) <= 4e-16 * x;
        x = step;
        if (done) break;
      }
      found.push(x);
    }
    return [found, extremes];
  }

  // device and force of a sampled loop as quadratics: (z^2 - a z + e) x = -(m2 z^2 + m1 z + m0) f
  let last = {};
  function sampled({ gamma, delta }, part) {
    if (last.gamma !== gamma || last.delta !== delta || last.part !== part) {
      const [m2, m1, m0] = haptic.discretize_fractional(gamma, delta, part);
      const moved = m2 + m1 + m0;
      const fall = -Math.expm1(-delta);
      last = { gamma, delta, part, device: [gamma * moved, 2 - fall, fall], force: [moved, m2 + m0, m2 - m0] };
    }
    return last;
  }

  // whether the argument of z^(whole + 1) device below + force (alpha below + beta above) turns as far
  // as that of a polynomial does whose roots are all inside. Between angles at which both parts are
  // equal the sum turns as the larger does, but for principal values at the ends
  function inside({ gamma, delta, filter: [above, below] }, alpha, beta, d) {
    const whole = Math.floor(d);
    const { device, force } = sampled({ gamma, delta }, d - whole);
    const parts = [[device, below], [force, mix(alpha, below, beta, above)]];
    const sizes = parts.map(([p, q]) => product(square(p), square(q)));
    const [crossed, extremes] = changes(mix(1, sizes[0], -1, sizes[1]));
    const angles = [0, ...crossed, ...extremes, 4].sort((one, two) => one - two).map((x) => {
      const theta = x === 4 ? Math.PI : 2 * Math.atan2(Math.sqrt(x), Math.sqrt(4 - x));
      const sine = x === 4 ? 0 : Math.sqrt(x * (4 - x)) / 2;
      const values = parts.map((pair) => {
        let [re, im, turned, terms] = [1, 0, 0, 1];
        for (const q of pair) {
          const [r, i] = [real(q, x), q[2] * sine];
          [re, im] = [re * r - im * i, re * i + im * r];
          turned += Math.atan2(i, r);
          terms *= Math.abs(q[0]) + (Math.abs(q[1]) * x) / 2 + Math.abs(q[2]) * sine;
        }
        return { re, im, turned, terms };
      });
      const [own, wall] = values;
      const late = (whole + 1) * theta;
      const [c, s] = [Math.cos(late), Math.sin(late)];
      [own.re, own.im] = [own.re * c - own.im * s, own.re * s + own.im * c];
      own.turned += late;
      const near = Math.hypot(own.re + wall.re, own.im + wall.im);
      // the angle of the sum beyond that of each part
      const beyond = values.map((v) => Math.atan2(
        v.re * (own.im + wall.im) - v.im * (own.re + wall.re),
        v.re * (own.re + wall.re) + v.im * (own.im + wall.im),
      ));
      const sure = near > DOUBT * (1 + 1e-3 * whole) * (own.terms + wall.terms);
      return { x, sure, turned: values.map((v, i) => v.turned + beyond[i]) };
    });
    if (!angles.every(({ sure }) => sure)) return false;
    let turned = 0;
    for (let i = 1; i < angles.length; ++i) {
      const [low, high] = [angles[i - 1], angles[i]];
      const middle = (low.x + high.x) / 2;
      const larger = at(sizes[0], middle) >= at(sizes[1], middle) ? 0 : 1;
      turned += high.turned[larger] - low.turned[larger];
    }
    return turned > Math.PI * (whole + 2.9);
  }

  explorer.stable = (n, alpha, beta, d = n.d) => (n.filter ? inside(n, alpha, beta, d)
    : haptic.is_stable(alpha, beta, n.gamma, n.delta, d));

  // Re V and Im V/sin(theta)
  explorer.velocity = ([above, below], theta) => {
    const x = 4 * Math.sin(theta / 2) ** 2;
    const sine = Math.sin(theta);
    const [a, b] = [real(above, x), real(below, x)];
    const size = b * b + (below[2] * sine) ** 2;
    return [(a * b + above[2] * below[2] * sine * sine) / size, (above[2] * b - a * below[2]) / size];
  };

  // of above and below, for z^2, z and 1, divided by the first of below
  explorer.coefficients = (filter) => {
    const [above, below] = (filter ?? [once, [1, 1, 1]]).map(([s, p, g]) => [(p + g) / 2, s - p, (p - g) / 2]);
    return [above, below].map((q) => q.map((each) => each / below[0]));
  };

  // the wall with a root at exp(j theta), and the slope of V, whose sign changes at a pole: in the
  // paper's loop the wall with that root has the same alpha + beta V(z)
  explorer.boundary = (n, theta) => {
    const [alpha, beta] = haptic.stability_boundary(theta, n.gamma, n.delta, n.d);
    if (!n.filter) return [alpha, beta];
    const [re, slope] = explorer.velocity(n.filter, theta);
    return [alpha + 2 * beta * Math.sin(theta / 2) ** 2 - (beta / slope) * re, beta / slope, slope];
  };

  // whether (4) tells which walls are passive: with a filter for whole periods of delay
  explorer.passivityTold = (n) => !n.filter || (n.d % 1 === 0 && n.d <= LONGEST);

  // what alpha = 1 and beta = 1 need of the damping at an angle, (4)
  function needs({ d, filter: [above, below] }, theta) {
    const [h, c] = [Math.sin(theta / 2), Math.cos(theta / 2)];
    const [r, i] = [real(below, 4 * h * h), 2 * below[2] * h * c];
    const [re, im] = [above[2] * c * r + above[1] * h * i, above[1] * h * r - above[2] * c * i];
    const late = (d + 0.5) * theta;
    return [Math.sin(late) / (2 * h), -(re * Math.cos(late) + im * Math.sin(late)) / (r * r + i * i)];
  }

  // the same at many angles that see each turn of the delay, denser at small ones
  let listed = {};
  function table(n) {
    const loop = [n.d, n.filter].join();
    if (listed.loop !== loop) {
      const count = 256 + 128 * (n.d + 1);
      const angles = Array.from({ length: count }, (_, i) => Math.PI * ((i + 1) / count) ** 3);
      listed = { loop, angles, each: angles.map((theta) => needs(n, theta)) };
    }
    return listed;
  }

  // the damping that a wall needs of the device with a filter, and the angle where it needs most: each
  // peak of the table that is nearly the highest is looked at closely
  explorer.required = (n, alpha, beta) => {
    if (!explorer.passivityTold(n)) return [NaN, NaN];
    const { angles, each } = table(n);
    const need = ([p, q]) => alpha * p + beta * q;
    const all = each.map(need);
    const [least, most] = [Math.min(...all), Math.max(...all)];
    let found = [most, angles[all.indexOf(most)]];
    all.forEach((value, i) => {
      if (value < most - 0.01 * (most - least) || value < all[i - 1] || value < all[i + 1]) return;
      const own = (theta) => need(needs(n, theta));
      const theta = explorer.largest(own, angles[i - 1] ?? 0, angles[i + 1] ?? Math.PI, 40);
      if (own(theta) > found[0]) found = [own(theta), theta];
    });
    return alpha < 0 ? [Infinity, NaN] : found;
  };

  // the damping of the device less what a wall needs; a billionth more than was found with a filter
  explorer.margin = (n, alpha, beta) => {
    if (!n.filter) return haptic.passivity_margin(alpha, beta, n.own, n.d);
    return n.own - explorer.required(n, alpha, beta)[0] - 1e-9 * (Math.abs(alpha) + Math.abs(beta));
  };
})();
