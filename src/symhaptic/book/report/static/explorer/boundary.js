// The boundary of a loop: sampled, the pieces that border stable walls, and one row.
"use strict";
(() => {
  const SAMPLES = 800;
  const EACH = 8; // pieces
  const KEPT = 2; // curves: with the filter and without
  const { stable, boundary } = explorer;

  // walls [alpha, beta, theta] with a root at exp(j theta), denser at small angles; while a wall is
  // dragged the loop stays the same, and so does its curve. A point without numbers is a pole
  const curves = new Map();
  explorer.curve = (n) => {
    const loop = [n.gamma, n.delta, n.d, n.filter].join();
    if (curves.has(loop)) return curves.get(loop);
    const points = [];
    let before = 1;
    for (let i = 1; i <= SAMPLES; ++i) {
      const theta = Math.PI * (i / SAMPLES) ** 3;
      const [alpha, beta, slope = 1] = boundary(n, theta);
      if (slope * before < 0) points.push([NaN, NaN, theta]);
      if (Number.isFinite(alpha) && Number.isFinite(beta)) points.push([alpha, beta, theta]);
      before = slope;
    }
    if (curves.size === KEPT) curves.delete(curves.keys().next().value);
    curves.set(loop, points);
    return points;
  };

  // whether just one side of a piece is stable
  explorer.borders = (n, p, q) => {
    const [x, y] = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
    const [u, v] = [(q[1] - p[1]) * 1e-2, (p[0] - q[0]) * 1e-2];
    return stable(n, x + u, y + v) !== stable(n, x - u, y - v);
  };

  // the same of every piece of a curve, told once; the piece i ends at point i. A run of pieces is of
  // one kind up to a crossing, so that every eighth is asked, and between two kinds each one; all are
  // asked where it has to be exact: where the rows of a picture say that a crossing was missed
  const known = new WeakMap();
  explorer.bordering = (n, points, exactly = false) => {
    const kept = known.get(points);
    if (kept && (kept.exact || !exactly)) return kept;
    const found = new Array(points.length).fill(false);
    const ask = (i) => explorer.borders(n, points[i - 1], points[i]);
    const asked = points.map((_, i) => i).filter((i) => i > 0 && (exactly || i % EACH === 1 || i === points.length - 1));
    asked.forEach((i, at) => {
      found[i] = ask(i);
      const last = at > 0 ? asked[at - 1] : i;
      for (let j = last + 1; j < i; ++j) found[j] = found[i] === found[last] ? found[i] : ask(j);
    });
    known.set(points, Object.assign(found, { exact: exactly }));
    return found;
  };

  // alpha of the wall with a root at -1, by its damping; all of them are on a line through the end
  explorer.line = (n, points) => {
    const [alpha, beta, theta] = points.at(-1) ?? [NaN, NaN, 0];
    const last = n.filter ? explorer.velocity(n.filter, Math.PI)[0] : 2;
    const whole = theta === Math.PI ? alpha + last * beta : NaN;
    return (at) => whole - last * at;
  };

  // all places where the count of roots can change on a row of one damping, from left to right
  explorer.marks = (n, points, beta) => {
    const found = [[-n.gamma, 0], [explorer.line(n, points)(beta), Math.PI]].filter(([x]) => Number.isFinite(x));
    for (let i = 1; i < points.length; ++i) {
      const [p, q] = [points[i - 1], points[i]];
      if ((p[1] < beta) === (q[1] < beta) || Number.isNaN(p[1] + q[1])) continue;
      const share = (beta - p[1]) / (q[1] - p[1]);
      found.push([p[0] + share * (q[0] - p[0]), p[2] + share * (q[2] - p[2]), i]);
    }
    return found.sort((one, two) => one[0] - two[0]);
  };

  // the same for every row of a picture, each with the branch that it is on: a branch rises or falls
  explorer.rows = (n, points, betas) => {
    const line = explorer.line(n, points);
    const rows = betas.map((beta) => {
      const found = [{ x: -n.gamma, theta: 0, branch: -1, piece: 0 }];
      if (Number.isFinite(line(beta))) found.push({ x: line(beta), theta: Math.PI, branch: -2, piece: 0 });
      return found;
    });
    const [first, last] = [betas[0], betas.at(-1)];
    const place = (beta) => Math.max(-1, Math.min(betas.length, ((beta - first) / (last - first)) * (betas.length - 1)));
    let [branch, rising] = [0, null];
    for (let i = 1; i < points.length; ++i) {
      const [p, q] = [points[i - 1], points[i]];
      if ((q[1] > p[1]) !== rising) [branch, rising] = [branch + 1, !rising];
      const [one, two] = [place(p[1]), place(q[1])];
      const end = Math.min(betas.length - 1, Math.floor(Math.max(one, two)) + 1);
      for (let r = Math.max(0, Math.ceil(Math.min(one, two)) - 1); r <= end; ++r) {
        const beta = betas[r];
        if ((p[1] < beta) === (q[1] < beta)) continue;
        const share = (beta - p[1]) / (q[1] - p[1]);
        rows[r].push({ x: p[0] + share * (q[0] - p[0]), theta: p[2] + share * (q[2] - p[2]), branch, piece: i });
      }
    }
    return rows.map((row) => row.sort((a, b) => a.x - b.x));
  };

  // the angle between two samples at which the boundary has this damping, and its stiffness
  function refined(n, p, q, beta) {
    let [low, high] = [p[2], q[2]];
    for (let i = 0; i < 60; ++i) {
      const middle = (low + high) / 2;
      const below = boundary(n, middle)[1] < beta;
      if (below === (p[1] < beta)) low = middle;
      else high = middle;
    }
    const theta = (low + high) / 2;
    return [boundary(n, theta)[0], theta];
  }

  // the stiffest stable wall of this damping, and the angle of its roots
  explorer.stiffestAt = (n, points, beta) => {
    const marks = explorer.marks(n, points, beta).map(([x, theta, i]) =>
      (i ? refined(n, points[i - 1], points[i], beta) : [x, theta]));
    marks.sort((one, two) => one[0] - two[0]);
    for (let i = marks.length - 1; i > 0; --i) {
      const low = (marks[i][0] + marks[i - 1][0]) / 2;
      if (!stable(n, low, beta)) continue;
      const high = marks[i][0] - 1e-9 * (marks[i][0] - low);
      if (!n.filter || stable(n, high, beta)) return marks[i];
      return [explorer.halved((alpha) => stable(n, alpha, beta), low, high), NaN]; // a crossing was missed
    }
    return [NaN, NaN];
  };

  // about the stiffest stable wall of each of many dampings
  explorer.lasts = (n, points, betas) => explorer.rows(n, points, betas).map((row, r) => {
    for (let i = row.length - 1; i > 0; --i) {
      if (stable(n, (row[i].x + row[i - 1].x) / 2, betas[r])) return row[i].x;
    }
    return NaN;
  });
})();
