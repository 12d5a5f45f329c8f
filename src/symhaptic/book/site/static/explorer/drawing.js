// Pictures as SVG: axes, the stable and the passive region, the wall, and the response.
"use strict";
(() => {
  const SVG = "http://www.w3.org/2000/svg";
  const ROW = 2; // pixels
  const MARGIN = { left: 58, right: 14, top: 14, bottom: 46 };

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
    const wide = right - left || 1;
    const tall = high - low || 1;
    return { left: left - 0.06 * wide, right: right + 0.08 * wide, low: low - 0.08 * tall, high: high + 0.08 * tall };
  };

  // what is stable, row by row, and its part of the line alpha = -gamma
  explorer.stablePath = (n, points, view, frame) => {
    const [out, edge] = [[], []];
    for (let py = frame.top; py < frame.bottom; py += ROW) {
      const beta = frame.value(0, py + ROW / 2)[1];
      const inside = explorer.marks(n, points, beta).map(([alpha]) => alpha).filter((alpha) => alpha > view.left && alpha < view.right);
      const ends = [view.left, ...inside, view.right];
      for (let i = 1; i < ends.length; ++i) {
        if (!haptic.is_stable((ends[i] + ends[i - 1]) / 2, beta, n.gamma, n.delta, n.d)) continue;
        if (ends[i - 1] === -n.gamma) edge.push(`M${frame.x(-n.gamma).toFixed(1)} ${py}v${ROW}`);
        out.push(`M${frame.x(ends[i - 1]).toFixed(1)} ${py}H${frame.x(ends[i]).toFixed(1)}v${ROW}H${frame.x(ends[i - 1]).toFixed(1)}z`);
      }
    }
    return [out.join(""), edge.join("")];
  };

  // a point that lies left of a bound, moved there along its piece
  function cut(point, other, left) {
    if (point[0] >= left || other[0] < left) return point;
    const share = (left - point[0]) / (other[0] - point[0]);
    return [left, point[1] + share * (other[1] - point[1])];
  }

  explorer.borderPath = (n, points, frame) => {
    let [out, open] = ["", false];
    const bordering = explorer.bordering(n, points);
    for (let i = 1; i < points.length; ++i) {
      const [p, q] = [cut(points[i - 1], points[i], -n.gamma), cut(points[i], points[i - 1], -n.gamma)];
      const there = bordering[i];
      if (there && !open) out += `M${frame.x(p[0]).toFixed(1)} ${frame.y(p[1]).toFixed(1)}`;
      if (there) out += `L${frame.x(q[0]).toFixed(1)} ${frame.y(q[1]).toFixed(1)}`;
      open = there;
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
