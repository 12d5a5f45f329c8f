// The page: what changes is drawn once a frame, and written into the address when it rests.
"use strict";
document.addEventListener("DOMContentLoaded", () => {
  const find = (id) => document.getElementById(id);
  if (!find("explorer")) return;
  const [region, motion] = [find("region"), find("motion")];
  let state = explorer.fromHash(location.hash);
  let frame = null;
  let asked = 0;
  let resting = 0;
  let held = null;

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
    if (["m", "b", "k"].includes(key)) find("device").value = find("arm").value = "";
    change({ [key]: text });
  });
  explorer.presets(find("device"), find("arm"), (fresh, sources) => {
    find("sources").textContent = sources.join(" ");
    change(fresh);
  });

  function draw() {
    asked = 0;
    const began = performance.now();
    const n = explorer.numbers(state);
    const points = explorer.curve(n);
    const limits = explorer.limits(n, points);
    showControls(state, n);
    const [K, B] = [Number(state.m) / Number(state.T) ** 2, Number(state.m) / Number(state.T)];
    drawRegion(n, points, limits, K, B);
    explorer.drawMotion(motion, state, n, limits.stable);
    explorer.tell(state, n, limits, K, B);
    find("code").textContent = explorer.copies[find("language").value](state, n);
    explorer.took = performance.now() - began;
  }

  function drawRegion(n, points, limits, K, B) {
    const view = held ?? explorer.view(n, points, find("view").value, limits);
    const width = Math.max(300, Math.round(region.clientWidth));
    const si = { left: view.left * K, right: view.right * K, low: view.low * B, high: view.high * B };
    frame = explorer.frame(region, si, [width, Math.round(Math.max(280, Math.min(430, width * 0.72)))], ["virtual stiffness K in N/m", "virtual damping B in Ns/m"]);
    const plain = {
      ...frame, view,
      x: (alpha) => frame.x(alpha * K),
      y: (beta) => frame.y(beta * B),
      value: (px, py) => { const [k, b] = frame.value(px, py); return [k / K, b / B]; },
    };
    const { element } = explorer;
    const linear = [view.low, view.high].map((beta) => `${plain.x(haptic.linear_limit(beta, n.delta, n.d)).toFixed(1)} ${plain.y(beta).toFixed(1)}`);
    const [stable, left] = explorer.stablePath(n, points, view, plain);
    plain.inside.append(
      element("path", { class: "stable", d: stable }),
      element("path", { class: "edge", d: left + explorer.borderPath(n, points, plain) }),
      element("path", { class: "passive", d: explorer.passivePath(n, plain) }),
      element("path", { class: "linear", d: `M${linear.join("L")}` }),
      element("path", { class: "axis", d: `M${plain.x(0).toFixed(1)} ${frame.top}V${frame.bottom}M${frame.left} ${plain.y(0).toFixed(1)}H${frame.right}` }),
      element("circle", { class: limits.stable ? "wall" : "wall lost", cx: plain.x(n.alpha), cy: plain.y(n.beta), r: 7 }),
    );
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
  addEventListener("resize", () => change({}));
  addEventListener("hashchange", () => {
    state = explorer.fromHash(location.hash);
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
  draw();
  rest();
});
