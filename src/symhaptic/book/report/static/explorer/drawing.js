// Pictures as SVG: axes, the stable and the passive region, the wall, and the response.
"use strict";
(() => {
  const SVG = "http://www.w3.org/2000/svg";
  const ROW = 2; // pixels
  const PARTS = 16; // of a piece with a corner
  const MARGIN = { left: 70, right: 24, top: 14, bottom: 46 };

  explorer.element = (name, attributes = {}, text = "") => {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text) made.textContent = text;
    return made;
  };

  explorer.ticks = (low, high, count) => {
    const rough = (high - low) / count;
    const ten = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((i) => i * ten).find((i) => i >= rough);
    const found = [];
    for (let i = Math.ceil(low / step); i * step <= high; ++i) found.push(i * step);
    return found;
  };

  explorer.short = (value) => {
    const size = Math.abs(value);
    if (size !== 0 && (size < 1e-3 || size >= 1e5)) return value.toExponential(1).replace("e+", "e").replace(".0e", "e").replace("-", "−");
    return String(Number(value.toPrecision(4))).replace("-", "−");
  };

  // how numbers become pixels
  explorer.scale = (view, [width, height]) => {
    const [left, right, top, bottom] = [MARGIN.left, width - MARGIN.right, MARGIN.top, height - MARGIN.bottom];
    return {
      x: (value) => left + ((value - view.left) / (view.right - view.left)) * (right - left),
      y: (value) => bottom - ((value - view.low) / (view.high - view.low)) * (bottom - top),
      value: (px, py) => [
        view.left + ((px - left) / (right - left)) * (view.right - view.left),
        view.low + ((bottom - py) / (bottom - top)) * (view.high - view.low),
      ],
      top, bottom, left, right,
    };
  };

  // a picture with axes, and where to draw
  explorer.frame = (svg, view, size, names) => {
    const [width, height] = size;
    const scale = explorer.scale(view, size);
    const { x, y, left, right, top, bottom } = scale;
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const parts = [];
    const grid = [];
    for (const tick of explorer.ticks(view.left, view.right, width < 420 ? 3 : 6)) {
      grid.push(`M${x(tick).toFixed(1)} ${top}V${bottom}`);
      parts.push(explorer.element("text", { class: "tick", x: x(tick), y: bottom + 16, "text-anchor": "middle" }, explorer.short(tick)));
    }
    for (const tick of explorer.ticks(view.low, view.high, 5)) {
      grid.push(`M${left} ${y(tick).toFixed(1)}H${right}`);
      parts.push(explorer.element("text", { class: "tick", x: left - 7, y: y(tick) + 4, "text-anchor": "end" }, explorer.short(tick)));
    }
    parts.push(explorer.element("text", { class: "name", x: (left + right) / 2, y: height - 8, "text-anchor": "middle" }, names[0]));
    parts.push(explorer.element("text", { class: "name", x: 0, y: 0, transform: `translate(13 ${(top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, names[1]));
    const inside = explorer.element("svg", { x: left, y: top, width: right - left, height: bottom - top, viewBox: `${left} ${top} ${right - left} ${bottom - top}` });
    const back = explorer.element("rect", { class: "back", x: 0, y: 0, width, height });
    svg.replaceChildren(back, explorer.element("path", { class: "grid", d: grid.join("") }), inside, ...parts);
    return { ...scale, inside };
  };

  // the box around what borders stable walls, with the wall itself
  explorer.view = (n, points, kind, limits) => {
    let [left, right, low, high] = [Math.min(0, n.alpha), Math.max(0, n.alpha), Math.min(0, n.beta), Math.max(0, n.beta)];
    const add = (alpha, beta) => {
      [left, right] = [Math.min(left, alpha), Math.max(right, alpha)];
      [low, high] = [Math.min(low, beta), Math.max(high, beta)];
    };
    if (kind === "passive" || kind === "wall") {
      if (kind === "wall") [left, right, low, high] = [0, 2 * n.alpha, 0, 2 * n.beta];
      else if (n.own > 0) [left, right, low, high] = [0, limits.stiffest_passive[0], -n.own, n.own];
    } else {
      add(-n.gamma, 0);
      explorer.bordering(n, points).forEach((there, i) => {
        if (there) for (const [alpha, beta] of [points[i - 1], points[i]]) add(alpha, beta);
      });
    }
    const line = explorer.line(n, points);
    const corner = (line(0) + n.gamma) / (line(0) - line(1)); // where both straight parts meet
    const near = 1e-6 * Math.abs(corner);
    if (kind === "stable" && Number.isFinite(corner) && explorer.stable(n, -n.gamma + near, corner - near)) add(-n.gamma, corner);
    const wide = right - left || 1;
    const tall = high - low || 1;
    return { left: left - 0.06 * wide, right: right + 0.08 * wide, low: low - 0.08 * tall, high: high + 0.08 * tall };
  };

  // what is stable, row by row, and the straight parts of its boundary: a root at 1 or at -1. Between
  // the same branches in the same order nothing changes from one row to the next, and after two rows
  // no root is counted anew. Where the rows contradict what is known of the pieces, all is asked
  explorer.stablePath = (n, points, view, frame, exactly = false) => {
    const [out, edge] = [[], []];
    const line = explorer.line(n, points);
    const bordering = explorer.bordering(n, points, exactly);
    const place = (value) => frame.x(value).toFixed(1);
    const tops = [];
    for (let py = frame.top; py < frame.bottom; py += ROW) tops.push(py);
    const beta = (py) => frame.value(0, py)[1];
    const rows = explorer.rows(n, points, tops.map((py) => beta(py + ROW / 2)));
    let [before, same, stable, sure] = ["", 0, [], true];
    rows.forEach((row, r) => {
      const py = tops[r];
      const side = (x) => (x <= view.left ? "<" : x >= view.right ? ">" : "");
      const inside = row.filter(({ x }) => !side(x));
      const ends = [view.left, ...inside.map(({ x }) => x), view.right];
      const order = row.map(({ x, branch }) => side(x) + branch).join();
      same = r > 0 && order === before ? same + 1 : 0;
      before = order;
      if (same < 2 || exactly) { // a part that has just begun may be too narrow to be judged
        const middle = beta(py + ROW / 2);
        stable = ends.slice(1).map((end, i) => explorer.stable(n, (ends[i] + end) / 2, middle));
      }
      stable.forEach((good, i) => {
        if (good) out.push(`M${place(ends[i])} ${py}H${place(ends[i + 1])}v${ROW}H${place(ends[i])}z`);
      });
      inside.forEach(({ theta, piece }, i) => {
        const border = stable[i] !== stable[i + 1];
        if (piece) {
          const near = [-1, 0, 1].map((by) => bordering[piece + by] ?? bordering[piece]);
          if (same > 0 && near.every((kind) => kind !== border)) sure = false;
        } else if (border) {
          const [above, below] = theta === 0 ? [-n.gamma, -n.gamma] : [line(beta(py)), line(beta(py + ROW))];
          edge.push(`M${place(above)} ${py}L${place(below)} ${py + ROW}`);
        }
      });
    });
    return sure || exactly ? [out.join(""), edge.join("")] : explorer.stablePath(n, points, view, frame, true);
  };

  // the curved parts; a piece beside one of another kind holds a corner, and is judged in parts
  explorer.borderPath = (n, points, frame) => {
    let [out, open] = ["", false];
    const bordering = explorer.bordering(n, points);
    const place = ([alpha, beta]) => `${frame.x(alpha).toFixed(1)} ${frame.y(beta).toFixed(1)}`;
    const draw = (there, p, q) => {
      if (there) out += `${open ? "" : `M${place(p)}`}L${place(q)}`;
      open = there;
    };
    for (let i = 1; i < points.length; ++i) {
      const [p, q] = [points[i - 1], points[i]];
      if (bordering[i] === bordering[i - 1] && bordering[i] === (bordering[i + 1] ?? bordering[i])) {
        draw(bordering[i], p, q);
        continue;
      }
      const at = (share) => explorer.boundary(n, p[2] + share * (q[2] - p[2]));
      for (let j = 0; j < PARTS; ++j) {
        const [one, two] = [at(j / PARTS), at((j + 1) / PARTS)];
        draw(explorer.borders(n, one, two), one, two);
      }
    }
    return out;
  };

  // everything that is drawn of the walls, as paths
  explorer.paths = (n, points, view, frame) => {
    const [stable, straight] = explorer.stablePath(n, points, view, frame);
    const linear = n.filter ? [] : [view.low, view.high].map((beta) => `${frame.x(haptic.linear_limit(beta, n.delta, n.d)).toFixed(1)} ${frame.y(beta).toFixed(1)}`);
    return {
      stable,
      edge: straight + explorer.borderPath(n, points, frame),
      passive: explorer.passivePath(n, frame),
      linear: linear.length ? `M${linear.join("L")}` : "",
      axis: `M${frame.x(0).toFixed(1)} ${frame.top}V${frame.bottom}M${frame.left} ${frame.y(0).toFixed(1)}H${frame.right}`,
    };
  };

  // the needed damping grows with the wall: in each direction it is a multiple of that of one wall
  explorer.passivePath = (n, frame) => {
    if (!(n.own > 0 && explorer.passivityTold(n))) return "";
    const out = [];
    for (let i = 0; i <= 240; ++i) {
      const angle = Math.PI * (i / 240 - 0.5);
      const [alpha, beta] = [i % 240 ? Math.cos(angle) : 0, Math.sin(angle)];
      const far = n.own / (n.own - explorer.margin(n, alpha * n.own, beta * n.own));
      out.push(`${frame.x(alpha * far * n.own).toFixed(2)} ${frame.y(beta * far * n.own).toFixed(2)}`);
    }
    return `M${out.join("L")}Z`;
  };
})();
