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

  // a picture with axes: how numbers become pixels, and where to draw
  explorer.frame = (svg, view, size, names) => {
    const [width, height] = size;
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    const right = width - MARGIN.right;
    const bottom = height - MARGIN.bottom;
    const x = (value) => MARGIN.left + ((value - view.left) / (view.right - view.left)) * (right - MARGIN.left);
    const y = (value) => bottom - ((value - view.low) / (view.high - view.low)) * (bottom - MARGIN.top);
    const value = (px, py) => [
      view.left + ((px - MARGIN.left) / (right - MARGIN.left)) * (view.right - view.left),
      view.low + ((bottom - py) / (bottom - MARGIN.top)) * (view.high - view.low),
    ];
    const parts = [];
    const grid = [];
    for (const tick of explorer.ticks(view.left, view.right, width < 420 ? 3 : 6)) {
      grid.push(`M${x(tick).toFixed(1)} ${MARGIN.top}V${bottom}`);
      parts.push(explorer.element("text", { class: "tick", x: x(tick), y: bottom + 16, "text-anchor": "middle" }, explorer.short(tick)));
    }
    for (const tick of explorer.ticks(view.low, view.high, 5)) {
      grid.push(`M${MARGIN.left} ${y(tick).toFixed(1)}H${right}`);
      parts.push(explorer.element("text", { class: "tick", x: MARGIN.left - 7, y: y(tick) + 4, "text-anchor": "end" }, explorer.short(tick)));
    }
    parts.push(explorer.element("text", { class: "name", x: (MARGIN.left + right) / 2, y: height - 8, "text-anchor": "middle" }, names[0]));
    parts.push(explorer.element("text", { class: "name", x: 0, y: 0, transform: `translate(13 ${(MARGIN.top + bottom) / 2}) rotate(-90)`, "text-anchor": "middle" }, names[1]));
    const inside = explorer.element("svg", { x: MARGIN.left, y: MARGIN.top, width: right - MARGIN.left, height: bottom - MARGIN.top, viewBox: `${MARGIN.left} ${MARGIN.top} ${right - MARGIN.left} ${bottom - MARGIN.top}` });
    const back = explorer.element("rect", { class: "back", x: 0, y: 0, width, height });
    svg.replaceChildren(back, explorer.element("path", { class: "grid", d: grid.join("") }), inside, ...parts);
    return { x, y, value, inside, top: MARGIN.top, bottom, left: MARGIN.left, right };
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
      else if (n.delta > 0) [left, right, low, high] = [0, limits.stiffest_passive[0], -n.delta, n.delta];
    } else {
      add(-n.gamma, 0);
      explorer.bordering(n, points).forEach((there, i) => {
        if (there) for (const [alpha, beta] of [points[i - 1], points[i]]) add(alpha, beta);
      });
    }
    const corner = (explorer.line(points) + n.gamma) / 2; // where both straight parts meet
    const near = 1e-6 * Math.abs(corner);
    if (kind === "stable" && haptic.is_stable(-n.gamma + near, corner - near, n.gamma, n.delta, n.d)) add(-n.gamma, corner);
    const wide = right - left || 1;
    const tall = high - low || 1;
    return { left: left - 0.06 * wide, right: right + 0.08 * wide, low: low - 0.08 * tall, high: high + 0.08 * tall };
  };

  // what is stable, row by row, and the straight parts of its boundary: a root at 1 or at -1
  explorer.stablePath = (n, points, view, frame) => {
    const [out, edge] = [[], []];
    const line = explorer.line(points);
    const place = (value) => frame.x(value).toFixed(1);
    for (let py = frame.top; py < frame.bottom; py += ROW) {
      const [top, beta, bottom] = [0, ROW / 2, ROW].map((down) => frame.value(0, py + down)[1]);
      const inside = explorer.marks(n, points, beta).filter(([alpha]) => alpha > view.left && alpha < view.right);
      const ends = [[view.left, NaN, 1], ...inside, [view.right, NaN, 1]];
      for (let i = 1; i < ends.length; ++i) {
        const [from, to] = [ends[i - 1], ends[i]];
        if (!haptic.is_stable((from[0] + to[0]) / 2, beta, n.gamma, n.delta, n.d)) continue;
        out.push(`M${place(from[0])} ${py}H${place(to[0])}v${ROW}H${place(from[0])}z`);
        for (const [, theta, curved] of [from, to]) {
          if (curved) continue;
          const [above, below] = theta === 0 ? [-n.gamma, -n.gamma] : [line - 2 * top, line - 2 * bottom];
          edge.push(`M${place(above)} ${py}L${place(below)} ${py + ROW}`);
        }
      }
    }
    return [out.join(""), edge.join("")];
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
      const at = (share) => haptic.stability_boundary(p[2] + share * (q[2] - p[2]), n.gamma, n.delta, n.d);
      for (let j = 0; j < PARTS; ++j) {
        const [one, two] = [at(j / PARTS), at((j + 1) / PARTS)];
        draw(explorer.borders(n, one, two), one, two);
      }
    }
    return out;
  };

  // the needed damping grows with the wall: in each direction it is a multiple of that of one wall
  explorer.passivePath = (n, frame) => {
    if (!(n.delta > 0)) return "";
    const out = [];
    for (let i = 0; i <= 240; ++i) {
      const angle = Math.PI * (i / 240 - 0.5);
      const [alpha, beta] = [i % 240 ? Math.cos(angle) : 0, Math.sin(angle)];
      const far = n.delta / (n.delta - haptic.passivity_margin(alpha * n.delta, beta * n.delta, n.delta, n.d));
      out.push(`${frame.x(alpha * far * n.delta).toFixed(2)} ${frame.y(beta * far * n.delta).toFixed(2)}`);
    }
    return `M${out.join("L")}Z`;
  };
})();
