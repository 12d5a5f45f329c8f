// The regions of stable and passive walls, and the motion, as SVG.
"use strict";
const SVG = "http://www.w3.org/2000/svg";
const WIDE = 640, HIGH = 440, LEFT = 104, RIGHT = 28, TOP = 14, FOOT = 56;

explorer.element = (name, attributes, parent, text) => {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  if (parent) parent.append(made);
  return made;
};

// what is shown: from the tip of the stable region, rounded so that it seldom changes
explorer.window = (found, near) => {
  const up = (x) => {
    const size = 10 ** Math.floor(Math.log10(x));
    return size * [1, 1.5, 2, 3, 4, 5, 7, 10].find((step) => step * size >= x * 0.999999);
  };
  const [wall, wide] = near && found.stiffestPassive.K > 0
    ? [found.stiffestPassive, found.n.own * found.n.B * 1.2] : [found.stiffest, found.stiffest.B * 2.4];
  const K = up(Math.max(wall.K * 1.12, 1e-9)), B = up(Math.max(wide, 1e-9));
  if (near) return { low: { B: -B, K: -K / 10 }, high: { B, K } };
  return { low: { B: -B / 4, K: -K / 10 }, high: { B, K } };
};

explorer.scales = (view) => ({
  x: (B) => LEFT + (B - view.low.B) / (view.high.B - view.low.B) * (WIDE - LEFT - RIGHT),
  y: (K) => HIGH - FOOT - (K - view.low.K) / (view.high.K - view.low.K) * (HIGH - FOOT - TOP),
  back: (px, py) => ({
    B: view.low.B + (px - LEFT) / (WIDE - LEFT - RIGHT) * (view.high.B - view.low.B),
    K: view.low.K + (HIGH - FOOT - py) / (HIGH - FOOT - TOP) * (view.high.K - view.low.K),
  }),
});

explorer.ticks = (low, high, count) => {
  const raw = (high - low) / count, size = 10 ** Math.floor(Math.log10(raw));
  const step = size * [1, 2, 5, 10].find((s) => s * size >= raw);
  const found = [];
  for (let i = Math.ceil(low / step); i * step <= high + step * 1e-9; i++) found.push(i * step);
  return found;
};

explorer.short = (x) => {
  if (x === 0) return "0";
  if (!Number.isFinite(x)) return Number.isNaN(x) ? "\u2013" : "\u221e";
  const plain = Math.abs(x) < 1e7 && Math.abs(x) >= 1e-3;
  const [digits, power] = plain ? [String(Number(x.toPrecision(4)))] : x.toExponential(2).split("e");
  const raised = [...(power || "").replace("+", "")].map((c) => (c === "-" ? "\u207b" : "\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"[c])).join("");
  return digits.replace("-", "\u2212") + (power ? `\u00b710${raised}` : "");
};

// stable walls cell by cell, a row at a time from `row` on, until `time` is over; the next row
explorer.raster = (map, view, n, row, time) => {
  const { columns, rows, pixels, colour } = map, until = performance.now() + time;
  for (; row < rows; row++) {
    if (performance.now() > until) return row;
    const K = view.high.K + (row + 0.5) / rows * (view.low.K - view.high.K);
    for (let i = 0; i < columns; i++) {
      const B = view.low.B + (i + 0.5) / columns * (view.high.B - view.low.B);
      const at = 4 * (row * columns + i);
      pixels.data.set(haptic.is_stable(K / n.K, B / n.B, n.gamma, n.delta, n.d) ? colour : [0, 0, 0, 0], at);
    }
  }
  return row;
};

// lines of a curve (B, K) that leave the window now and then
explorer.path = (points, scale, view) => {
  const spare = { B: view.high.B - view.low.B, K: view.high.K - view.low.K };
  let text = "", pen = false;
  for (const [B, K] of points) {
    const near = B > view.low.B - spare.B && B < view.high.B + spare.B && K > view.low.K - spare.K && K < view.high.K + spare.K;
    if (!near) { pen = false; continue; }
    text += `${pen ? "L" : "M"}${scale.x(B).toFixed(2)} ${scale.y(K).toFixed(2)}`;
    pen = true;
  }
  return text;
};

explorer.boundary = (n) => {
  const points = [], most = 700;
  for (let i = 1; i < most; i++) {
    const [alpha, beta] = haptic.stability_boundary(Math.PI * (i / most) ** 2, n.gamma, n.delta, n.d);
    points.push([beta * n.B, alpha * n.K]);
  }
  return points;
};

explorer.passiveRegion = (n) => {
  const points = [[-n.own * n.B, 0]], end = Math.PI / (n.d + 1), most = 160;
  for (let i = 1; i <= most; i++) {
    const [alpha, beta] = haptic.passivity_boundary(end * i / most, n.own, n.d);
    if (alpha >= 0) points.push([beta * n.B, alpha * n.K]);
  }
  if (n.d === 0) points.push([0, haptic.max_passive_stiffness(n.own, 0)[0] * n.K], [n.own * n.B, 0]);
  return points;
};

explorer.axes = (svg, view, scale, names) => {
  const group = explorer.element("g", { class: "axes" }, svg);
  for (const B of explorer.ticks(view.low.B, view.high.B, 7)) {
    explorer.element("path", { class: B === 0 ? "zero" : "grid", d: `M${scale.x(B)} ${TOP}V${HIGH - FOOT}` }, group);
    explorer.element("text", { x: scale.x(B), y: HIGH - FOOT + 18, "text-anchor": "middle" }, group, explorer.short(B));
  }
  for (const K of explorer.ticks(view.low.K, view.high.K, 6)) {
    explorer.element("path", { class: K === 0 ? "zero" : "grid", d: `M${LEFT} ${scale.y(K)}H${WIDE - RIGHT}` }, group);
    explorer.element("text", { x: LEFT - 8, y: scale.y(K) + 4, "text-anchor": "end" }, group, explorer.short(K));
  }
  const x = (LEFT + WIDE - RIGHT) / 2, y = (TOP + HIGH - FOOT) / 2;
  explorer.element("text", { x, y: HIGH - 8, "text-anchor": "middle", class: "name" }, group, names[0]);
  explorer.element("text", { transform: `translate(20 ${y}) rotate(-90)`, "text-anchor": "middle", class: "name" }, group, names[1]);
};

explorer.regions = (svg, s, found, view, image) => {
  const scale = explorer.scales(view), n = found.n;
  svg.replaceChildren();
  explorer.element("title", {}, svg, "Stable and passive walls by virtual damping and stiffness");
  const clip = explorer.element("clipPath", { id: "inside" }, explorer.element("defs", {}, svg));
  const frame = { x: LEFT, y: TOP, width: WIDE - LEFT - RIGHT, height: HIGH - FOOT - TOP };
  explorer.element("rect", frame, clip);
  const inner = explorer.element("g", { "clip-path": "url(#inside)" }, svg);
  explorer.element("image", { ...frame, preserveAspectRatio: "none", href: image, class: "stable" }, inner);
  explorer.axes(svg, view, scale, ["virtual damping B in Ns/m", "virtual stiffness K in N/m"]);
  const over = explorer.element("g", { "clip-path": "url(#inside)" }, svg);
  const passive = explorer.path(explorer.passiveRegion(n), scale, { low: { B: -1e99, K: -1e99 }, high: { B: 1e99, K: 1e99 } });
  explorer.element("path", { class: "passive", d: `${passive}Z` }, over);
  explorer.element("path", { class: "edge", d: explorer.path(explorer.boundary(n), scale, view) }, over);
  const marks = [[found.stiffest, "stiffest stable", -8], [found.stiffestPassive, "stiffest passive", view.low.B === -view.high.B ? -8 : 14]];
  for (const [wall, name, off] of marks) {
    if (!Number.isFinite(wall.K)) continue;
    explorer.element("circle", { class: "limit", cx: scale.x(wall.B), cy: scale.y(wall.K), r: 3.5 }, over);
    explorer.element("text", { class: "mark", x: scale.x(wall.B) + 7, y: scale.y(wall.K) + off + 4 }, over, name);
  }
  const at = { x: scale.x(s.B), y: scale.y(s.K) };
  const cross = `M${at.x - 9} ${at.y}H${at.x + 9}M${at.x} ${at.y - 9}V${at.y + 9}`;
  explorer.element("path", { class: `wall ${found.stable ? "good" : "bad"}`, d: cross }, over);
  explorer.element("circle", { class: `wall ${found.stable ? "good" : "bad"}`, cx: at.x, cy: at.y, r: 5.5 }, over);
};

explorer.response = (svg, s) => {
  const n = explorer.numbers(s), ways = explorer.motion(s, 240);
  const wide = 640, high = 200, left = 104, foot = 48, top = 12;
  const most = Math.max(...ways.map(Math.abs), 1e-300);
  const start = ways.some((way) => way < -0.02 * most) ? -most : 0;
  const x = (k) => left + k / 240 * (wide - left - 28);
  const y = (way) => high - foot - (way - start) / (1.08 * most - start) * (high - foot - top);
  svg.replaceChildren();
  explorer.element("title", {}, svg, "Way after a push of one newton that stays");
  const group = explorer.element("g", { class: "axes" }, svg);
  for (const way of explorer.ticks(start, 1.08 * most, 3)) {
    explorer.element("path", { class: way === 0 ? "zero" : "grid", d: `M${left} ${y(way)}H${wide - 28}` }, group);
    explorer.element("text", { x: left - 8, y: y(way) + 4, "text-anchor": "end" }, group, explorer.short(way * 1000));
  }
  for (const k of explorer.ticks(0, 240, 6)) {
    explorer.element("text", { x: x(k), y: high - foot + 18, "text-anchor": "middle" }, group, explorer.short(k * s.T));
  }
  explorer.element("text", { x: (left + wide - 28) / 2, y: high - 5, "text-anchor": "middle", class: "name" }, group, "time in ms, after a push of 1 N that stays");
  explorer.element("text", { transform: `translate(20 ${(high - foot + top) / 2}) rotate(-90)`, "text-anchor": "middle", class: "name" }, group, "way in mm");
  const stable = haptic.is_stable(n.alpha, n.beta, n.gamma, n.delta, n.d);
  const line = ways.map((way, k) => `${k ? "L" : "M"}${x(k).toFixed(2)} ${y(way).toFixed(2)}`).join("");
  explorer.element("path", { class: `motion ${stable ? "good" : "bad"}`, d: line }, svg);
};
