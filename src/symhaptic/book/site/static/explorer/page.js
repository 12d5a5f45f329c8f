// The page: fields and sliders, what is redrawn when, presets, links, and what can be copied.
"use strict";
const FIELDS = [
  // key, symbol, name, unit, largest, may be negative
  ["mD", "m", "mass of the device", "kg", 5], ["bD", "b", "damping of the device", "Ns/m", 20],
  ["mH", "m", "mass of the arm", "kg", 20], ["bH", "b", "damping of the arm", "Ns/m", 200],
  ["kH", "k", "stiffness of the arm", "N/m", 2000], ["T", "T", "sampling period", "ms", 10],
  ["td", "t", "time delay", "ms", 20], ["K", "K", "virtual stiffness", "N/m", 50000],
  ["B", "B", "virtual damping", "Ns/m", 400, true],
];
const POSITIVE = new Set(["mD", "T"]);
const START = { mD: 0.1, bD: 0.5, mH: 0, bH: 0, kH: 0, T: 1, td: 1.5, K: 2000, B: 10 };

explorer.state = { ...START };

// a slider is finer near zero: the cube root of the share of the largest value
explorer.fromSlider = (share, most) => most * share ** 3;
explorer.toSlider = (value, most) => Math.cbrt(value / most);

explorer.checked = (key, text) => {
  const value = Number(text), [, , name, , , signed] = FIELDS.find(([k]) => k === key);
  if (String(text).trim() === "" || !Number.isFinite(value)) return `${name}: a number is needed`;
  if (POSITIVE.has(key) && !(value > 0)) return `${name}: more than 0 is needed`;
  if (!signed && key !== "K" && value < 0) return `${name}: 0 or more is needed`;
  return value;
};

explorer.fromLink = () => {
  for (const [key, text] of new URLSearchParams(location.hash.slice(1))) {
    if (!(key in START)) continue;
    const value = explorer.checked(key, text);
    if (typeof value === "number") explorer.state[key] = value;
  }
};

explorer.link = () => `#${new URLSearchParams(explorer.state)}`;

explorer.write = (s) => {
  const mass = s.mD + s.mH, damping = s.bD + s.bH, all = [`mass=${mass}`];
  if (damping > 0) all.push(`damping=${damping}`);
  if (s.kH > 0) all.push(`stiffness=${s.kH}`);
  all.push(`sampling_period=${s.T / 1000}`);
  if (s.td > 0) all.push(`delay=${s.td / 1000}`);
  const n = explorer.numbers(s);
  return {
    Python: `from symhaptic import Scene\n\nscene = Scene(${all.join(", ")})\nprint(scene.max_stable_stiffness(), scene.max_passive_stiffness())\nprint(scene.is_stable(K=${s.K}, B=${s.B}))\n`,
    TOML: `[device]\nmass = "${s.mD} kg"\ndamping = "${s.bD} Ns/m"\n\n[arm]\nmass = "${s.mH} kg"\ndamping = "${s.bH} Ns/m"\nstiffness = "${s.kH} N/m"\n\n[loop]\nsampling_period = "${s.T} ms"\ndelay = "${s.td} ms"\n\n[wall]\nstiffness = "${s.K} N/m"\ndamping = "${s.B} Ns/m"\n`,
    C: `#include "haptic.h"\n\nconst double T = ${s.T / 1000}, m = ${mass}; /* s, kg */\nconst double alpha = ${s.K}*T*T/m, beta = ${s.B}*T/m;\nconst double gamma = ${s.kH}*T*T/m, delta = ${damping}*T/m, d = ${n.d};\nint stable = haptic_is_stable(alpha, beta, gamma, delta, d);\n`,
  };
};

explorer.build = (root) => {
  const form = root.querySelector("form");
  for (const [key, symbol, name, unit, most, signed] of FIELDS) {
    const row = document.createElement("div");
    row.className = "field";
    const sub = { mD: "D", bD: "D", mH: "H", bH: "H", kH: "H", td: "d" }[key] || "";
    row.innerHTML = `<label for="x-${key}"><i>${symbol}</i>${sub ? `<sub>${sub}</sub>` : ""} ${name}</label>
      <input type="range" id="r-${key}" min="${signed ? -1 : 0}" max="1" step="0.0005" aria-label="${name}, slider">
      <input type="number" id="x-${key}" step="any"> <span class="unit">${unit}</span>`;
    form.querySelector(`[data-group~="${key}"]`).append(row);
    const [range, number] = row.querySelectorAll("input");
    range.addEventListener("input", () => {
      let value = Number(explorer.fromSlider(Number(range.value), most).toPrecision(3));
      if (POSITIVE.has(key)) value = Math.max(value, most * 1e-4);
      explorer.put({ [key]: value });
    });
    number.addEventListener("input", () => {
      const value = explorer.checked(key, number.value);
      number.setAttribute("aria-invalid", typeof value !== "number");
      root.querySelector(".told").textContent = typeof value === "number" ? "" : value;
      if (typeof value === "number") explorer.put({ [key]: value }, key);
    });
  }
  for (const [id, presets] of [["devices", explorerData.devices], ["arms", explorerData.arms]]) {
    const choice = form.querySelector(`#${id}`);
    presets.forEach((preset, i) => choice.append(new Option(preset.name, i)));
    choice.addEventListener("change", () => {
      if (choice.value === "") return;
      const { values, source } = presets[choice.value];
      form.querySelector(`#${id}-source`).textContent = source;
      explorer.put(values);
    });
  }
  root.querySelector("#near").addEventListener("change", () => explorer.put({}));
  form.addEventListener("submit", (event) => event.preventDefault());
  const map = root.querySelector("svg.regions");
  const drag = (event) => {
    const box = map.getBoundingClientRect();
    const at = explorer.scales(explorer.view).back((event.clientX - box.left) / box.width * WIDE, (event.clientY - box.top) / box.height * HIGH);
    explorer.put({ K: Number(at.K.toPrecision(4)), B: Number(at.B.toPrecision(4)) });
  };
  map.addEventListener("pointerdown", (event) => { map.setPointerCapture(event.pointerId); drag(event); });
  map.addEventListener("pointermove", (event) => { if (event.buttons) drag(event); });
  for (const button of root.querySelectorAll("button[data-copy]")) {
    button.addEventListener("click", () => {
      const text = button.dataset.copy === "link" ? location.href : explorer.write(explorer.state)[button.dataset.copy];
      navigator.clipboard?.writeText(text);
      root.querySelector(".copied").textContent = text;
    });
  }
  for (const button of root.querySelectorAll("button[data-save]")) {
    button.addEventListener("click", () => explorer.save(map, button.dataset.save));
  }
};

// another state: everything that depends on it is drawn in the next frame, once
explorer.put = (change, typed) => {
  Object.assign(explorer.state, change);
  explorer.typed = typed;
  if (!explorer.waiting) explorer.waiting = requestAnimationFrame(explorer.draw);
};

explorer.draw = () => {
  explorer.waiting = 0;
  const begin = performance.now(), root = document.querySelector(".explorer"), s = explorer.state;
  for (const [key, , , , most] of FIELDS) {
    root.querySelector(`#r-${key}`).value = explorer.toSlider(s[key], most);
    if (explorer.typed !== key) root.querySelector(`#x-${key}`).value = s[key];
  }
  const found = explorer.limits(s), view = explorer.window(found, root.querySelector("#near").checked);
  explorer.view = view;
  const colour = explorer.colour(root);
  const coarse = explorer.canvas(56, 40, colour), n = found.n;
  explorer.raster(coarse, view, n, 0, 1e9);
  explorer.regions(root.querySelector("svg.regions"), s, found, view, coarse.href());
  explorer.response(root.querySelector("svg.motion"), s);
  explorer.table(root, s, found);
  explorer.took = performance.now() - begin;
  clearTimeout(explorer.later_);
  explorer.later_ = setTimeout(() => explorer.refine(root, view, n, colour), 120);
  clearTimeout(explorer.linked);
  explorer.linked = setTimeout(() => history.replaceState(null, "", explorer.link()), 200);
};

explorer.colour = (root) => {
  const probe = getComputedStyle(root).getPropertyValue("--stable").trim();
  const [r, g, b] = probe.match(/\w\w/g).map((two) => parseInt(two, 16));
  return [r, g, b, 255];
};

explorer.canvas = (columns, rows, colour) => {
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [columns, rows];
  const brush = canvas.getContext("2d"), pixels = brush.createImageData(columns, rows);
  return { columns, rows, pixels, colour, href: () => { brush.putImageData(pixels, 0, 0); return canvas.toDataURL(); } };
};

explorer.refine = (root, view, n, colour) => {
  const fine = explorer.canvas(224, 160, colour);
  const work = (row) => {
    if (explorer.view !== view) return;
    const next = explorer.raster(fine, view, n, row, 8);
    if (next < fine.rows) requestAnimationFrame(() => work(next));
    else { root.querySelector("image.stable").setAttribute("href", fine.href()); root.dataset.fine = "yes"; }
  };
  root.dataset.fine = "no";
  work(0);
};

explorer.table = (root, s, found) => {
  const cell = (name, text, kind = "") => {
    const place = root.querySelector(`[data-out="${name}"]`);
    place.textContent = text;
    place.className = kind;
  };
  const put = explorer.short, wall = (w) => `${put(w.K)} N/m with B = ${put(w.B)} Ns/m, at ${put(w.f)} Hz`;
  const upTo = (K) => (Number.isNaN(K) ? "no stiffness" : `${put(K)} N/m`);
  cell("stable", found.stable ? "stable" : "not stable", found.stable ? "good" : "bad");
  cell("passive", found.passive ? "passive" : "not passive", found.passive ? "good" : "bad");
  cell("margin", `${put(found.margin)} Ns/m`);
  cell("stiffest", wall(found.stiffest));
  cell("here", upTo(found.here));
  cell("stiffest-passive", wall(found.stiffestPassive));
  cell("passive-here", upTo(found.passiveHere));
  cell("later", found.later === Infinity ? "none found" : found.stable ? `${put(found.later)} ms` : "it is not now");
  const n = found.n;
  cell("numbers", `\u03b1 = ${put(n.alpha)}, \u03b2 = ${put(n.beta)}, \u03b3 = ${put(n.gamma)}, \u03b4 = ${put(n.delta)}, d = ${put(n.d)}`);
  for (const rule of explorer.rules(s)) {
    const kind = rule.K > 0 ? (rule.stable ? "good" : "bad") : "";
    cell(rule.name, rule.K > 0 ? `${put(rule.K)} N/m, which is ${rule.stable ? "stable" : "not stable"} here` : "allows nothing", kind);
  }
  root.querySelector(".short").textContent = `The wall is ${found.stable ? "stable" : "not stable"} and ${found.passive ? "passive" : "not passive"}.`;
};

explorer.save = (svg, kind) => {
  const copy = svg.cloneNode(true), style = document.querySelector("#explorer-style").textContent;
  copy.setAttribute("xmlns", SVG);
  copy.setAttribute("class", "regions explorer-light");
  copy.prepend(explorer.element("rect", { width: WIDE, height: HIGH, fill: "#ffffff" }));
  copy.prepend(explorer.element("style", {}, null, style));
  const address = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(copy)], { type: "image/svg+xml" }));
  const give = (href) => Object.assign(document.createElement("a"), { href, download: `walls.${kind}` }).click();
  if (kind === "svg") { give(address); return; }
  const image = new Image();
  image.onload = () => {
    const canvas = Object.assign(document.createElement("canvas"), { width: 2 * WIDE, height: 2 * HIGH });
    canvas.getContext("2d").drawImage(image, 0, 0, 2 * WIDE, 2 * HIGH);
    give(canvas.toDataURL("image/png"));
  };
  image.src = address;
};

document.addEventListener("DOMContentLoaded", () => {
  const root = document.querySelector(".explorer");
  if (!root) return;
  explorer.build(root);
  explorer.fromLink();
  explorer.put({});
  addEventListener("hashchange", () => { explorer.fromLink(); explorer.put({}); });
  new MutationObserver(() => explorer.put({})).observe(document.body, { attributes: true, attributeFilter: ["data-theme"] });
});
