// The boundary as the kernels give it: sampled, the pieces that border stable walls, and one row.
"use strict";
(() => {
  const SAMPLES = 800;
  const stable = (n, alpha, beta) => haptic.is_stable(alpha, beta, n.gamma, n.delta, n.d);

  // walls [alpha, beta, theta] with a root at exp(j theta), denser at small angles
  explorer.curve = (n) => {
    const points = [];
    for (let i = 1; i <= SAMPLES; ++i) {
      const theta = Math.PI * (i / SAMPLES) ** 3;
      const [alpha, beta] = haptic.stability_boundary(theta, n.gamma, n.delta, n.d);
      if (Number.isFinite(alpha) && Number.isFinite(beta)) points.push([alpha, beta, theta]);
    }
    return points;
  };

  // whether just one side of a piece is stable
  explorer.borders = (n, p, q) => {
    const [x, y] = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const [u, v] = [(q[1] - p[1]) * 1e-2, (p[0] - q[0]) * 1e-2];
    return stable(n, x + u, y + v) !== stable(n, x - u, y - v);
  };

  // the same of every piece of a curve, told once; the piece i ends at point i
  const known = new WeakMap();
  explorer.bordering = (n, points) => {
    if (!known.has(points)) known.set(points, points.map((point, i) => i > 0 && explorer.borders(n, points[i - 1], point)));
    return known.get(points);
  };

  // alpha + 2 beta of the walls with a root at -1, from the end of the curve
  explorer.line = (points) => {
    const [alpha, beta, theta] = points.at(-1) ?? [NaN, NaN, 0];
    return theta === Math.PI ? alpha + 2 * beta : NaN;
  };

  // all places where the count of roots can change on a row of one damping, from left to right
  explorer.marks = (n, points, beta) => {
    const found = [[-n.gamma, 0], [explorer.line(points) - 2 * beta, Math.PI]].filter(([x]) => Number.isFinite(x));
    for (let i = 1; i < points.length; ++i) {
      const [p, q] = [points[i - 1], points[i]];
      if ((p[1] < beta) === (q[1] < beta)) continue;
      const share = (beta - p[1]) / (q[1] - p[1]);
      found.push([p[0] + share * (q[0] - p[0]), p[2] + share * (q[2] - p[2]), i]);
    }
    return found.sort((one, two) => one[0] - two[0]);
  };

  // the angle between two samples at which the boundary has this damping, and its stiffness
  function refined(n, p, q, beta) {
    let [low, high] = [p[2], q[2]];
    for (let i = 0; i < 60; ++i) {
      const middle = (low + high) / 2;
      const below = haptic.stability_boundary(middle, n.gamma, n.delta, n.d)[1] < beta;
      if (below === (p[1] < beta)) low = middle;
      else high = middle;
    }
    const theta = (low + high) / 2;
    return [haptic.stability_boundary(theta, n.gamma, n.delta, n.d)[0], theta];
  }

  // the stiffest stable wall of this damping, and the angle of its roots
  explorer.stiffestAt = (n, points, beta) => {
    const marks = explorer.marks(n, points, beta).map(([x, theta, i]) =>
      (i ? refined(n, points[i - 1], points[i], beta) : [x, theta]));
    marks.sort((one, two) => one[0] - two[0]);
    for (let i = marks.length - 1; i > 0; --i) {
      if (stable(n, (marks[i][0] + marks[i - 1][0]) / 2, beta)) return marks[i];
    }
    return [NaN, NaN];
  };
})();
