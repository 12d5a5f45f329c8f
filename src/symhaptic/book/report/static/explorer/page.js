// The page: what changes is drawn once a frame, and written into the address when it rests.
"use strict";
const WARM = 24; // states
document.addEventListener("DOMContentLoaded", () => {
  const find = (id) => document.getElementById(id);
  if (!find("explore")) return;
  const [region, chart, motion] = ["region", "chart", "motion"].map(find);
  let state = explorer.fromHash(location.hash);
  let frame = null;
  let asked = 0;
  let resting = 0;
  let held = null;
  let width = 300; // pixels, of both pictures; asked for once, for a page that is asked is laid out

  const measure = () => { width = Math.max(300, Math.round(region.clientWidth)); };
  const change = (fresh) => {
    Object.assign(state, fresh);
    if (!asked) asked = requestAnimationFrame(draw);
    clearTimeout(resting);
    resting = setTimeout(rest, 250);
  };
  const rest = () => {
    history.replaceState(null, "", explorer.toHash(state));
    find("link").value = location.href;
  };
  const showControls = explorer.controls(find("quantities"), find("ratios"), (key, text) => {
    if (["m", "b", "k"].includes(key)) find("device").value = "";
    if (["m_H", "b_H", "k_H"].includes(key)) find("arm").value = "";
    find("wrong").textContent = "";
    change({ [key]: text });
  });
  explorer.presets(find("device"), find("arm"), (fresh, sources) => {
    find("sources").textContent = sources.join(" ");
    change(fresh);
  });

  const together = find(explorer.WITH_DEVICE);
  together.addEventListener("change", () => {
    find("arm").value = "";
    change({ [explorer.WITH_DEVICE]: together.checked ? "1" : "0" });
  });

  const velocity = find("velocity");
  velocity.addEventListener("change", () => change({ velocity: velocity.value }));

  function draw() {
    asked = 0;
    const began = performance.now();
    const n = explorer.numbers(state);
    const points = explorer.curve(n);
    const limits = explorer.limits(n, points);
    showControls(state, n);
    velocity.value = state.velocity;
    together.checked = explorer.replaces(state);
    together.disabled = !(Number(state.m_H) > 0);
    const mass = Number(explorer.coupled(state).m);
    const [K, B] = [mass / Number(state.T) ** 2, mass / Number(state.T)];
    drawRegion(n, points, limits, K, B);
    explorer.drawChart(chart, size(), n, points, limits, K, B);
    find("bare-key").hidden = !n.filter;
    for (const key of document.querySelectorAll(".passive-key")) key.hidden = !limits.told;
    find("linear-key").hidden = Boolean(n.filter);
    explorer.drawMotion(motion, width, state, n, limits.stable);
    explorer.tell(state, n, limits, K, B);
    explorer.write(find("code"), explorer.copies[find("language").value](state, n));
    explorer.took = performance.now() - began;
  }

  const size = () => [width, Math.round(Math.max(280, Math.min(430, width * 0.72)))];

  function drawRegion(n, points, limits, K, B) {
    const view = held ?? explorer.view(n, points, find("view").value, limits);
    const si = { left: view.left * K, right: view.right * K, low: view.low * B, high: view.high * B };
    frame = explorer.frame(region, si, size(), ["virtual stiffness K in N/m", "virtual damping B in Ns/m"]);
    const plain = explorer.scale(view, size());
    const { element } = explorer;
    for (const [name, d] of Object.entries(explorer.paths(n, points, view, plain))) frame.inside.append(element("path", { class: name, d }));
    frame.inside.append(element("circle", { class: limits.stable ? "wall" : "wall lost", cx: plain.x(n.alpha), cy: plain.y(n.beta), r: 7 }));
  }

  // a browser compiles what has run often: so that the first drag is not slow, some states are
  // computed while nothing else is asked for
  const idle = globalThis.requestIdleCallback ?? ((work) => setTimeout(work, 20));
  function warm(left) {
    const n = explorer.numbers({ ...state, t_d: String(Number(state.T) * left * 0.25) });
    const points = explorer.curve(n);
    const view = explorer.view(n, points, "stable", explorer.limits(n, points));
    explorer.paths(n, points, view, explorer.scale(view, size()));
    explorer.response(n);
    if (left > 1) idle(() => warm(left - 1));
  }

  // the wall is dragged, with the axes held
  const drag = (event) => {
    const box = region.getBoundingClientRect();
    const scale = region.viewBox.baseVal.width / box.width;
    const [K, B] = frame.value((event.clientX - box.left) * scale, (event.clientY - box.top) * scale);
    change({ K: String(Number(K.toPrecision(3))), B: String(Number(B.toPrecision(3))) });
  };
  region.addEventListener("pointerdown", (event) => {
    const n = explorer.numbers(state);
    const points = explorer.curve(n);
    held = explorer.view(n, points, find("view").value, explorer.limits(n, points));
    region.setPointerCapture(event.pointerId);
    drag(event);
  });
  region.addEventListener("pointermove", (event) => held && drag(event));
  for (const end of ["pointerup", "pointercancel"]) {
    region.addEventListener(end, () => {
      held = null;
      change({});
    });
  }

  for (const id of ["view", "language"]) find(id).addEventListener("change", () => change({}));
  new ResizeObserver(() => {
    measure();
    change({});
  }).observe(region.parentElement);
  addEventListener("hashchange", (event) => {  // rest may have put the old address back by now
    const { hash } = new URL(event.newURL);
    state = explorer.fromHash(hash);
    find("wrong").textContent = explorer.refused(hash, state);
    change({});
  });
  const copied = async (button, text) => {
    await navigator.clipboard.writeText(text);
    const said = button.textContent;
    button.textContent = "copied";
    setTimeout(() => { button.textContent = said; }, 1500);
  };
  find("copy-link").addEventListener("click", (event) => {
    rest();
    copied(event.target, location.href);
  });
  find("copy-code").addEventListener("click", (event) => copied(event.target, find("code").textContent));
  find("save-svg").addEventListener("click", () => explorer.saveSvg(region, "walls"));
  find("save-png").addEventListener("click", () => explorer.savePng(region, "walls"));
  measure();
  find("wrong").textContent = explorer.refused(location.hash, state);
  draw();
  rest();
  idle(() => warm(WARM));
});
