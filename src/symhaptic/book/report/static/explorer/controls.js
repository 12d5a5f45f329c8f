// Sliders and number fields for the state, in SI units or without.
"use strict";
(() => {
  const STEPS = 1000;

  function toSlider(q, value) {
    if (value <= 0) return 0;
    const at = Math.log(value / q.least) / Math.log(q.most / q.least);
    return Math.round(Math.max(q.zero ? 1 : 0, Math.min(STEPS, at * STEPS)));
  }

  function fromSlider(q, place) {
    if (q.zero && place === 0) return "0";
    return String(Number((q.least * (q.most / q.least) ** (place / STEPS)).toPrecision(3)));
  }

  // what is wrong with a field, or that nothing is
  function told(field, wrong) {
    if (!wrong && field.getAttribute("aria-invalid") !== "true") return;
    field.setAttribute("aria-invalid", String(Boolean(wrong)));
    document.getElementById("wrong").textContent = wrong;
  }

  const sunk = (symbol) => symbol.replace(/_(.*)/, "<sub>$1</sub>");

  function row(key, q, changed) {
    const box = document.createElement("div");
    box.className = "quantity";
    box.innerHTML = `<label for="field-${key}"><i>${sunk(q.symbol ?? key)}</i> <span>${q.label}<small>${q.note ? `, ${q.note}` : ""}</small></span></label>`
      + `<input type="range" min="0" max="${STEPS}" id="slider-${key}" aria-label="${q.label}, ${q.note ?? ""} (${q.unit})">`
      + `<input type="text" inputmode="decimal" id="field-${key}" autocomplete="off" spellcheck="false"><span class="unit">${q.unit}</span>`;
    const [slider, field] = [box.querySelector("input[type=range]"), box.querySelector("input[type=text]")];
    slider.addEventListener("input", () => changed(key, fromSlider(q, Number(slider.value))));
    field.addEventListener("input", () => {
      const good = explorer.allowed(key, field.value);
      told(field, good ? "" : `${explorer.named(q)} in ${q.unit}: ${explorer.range(key)} is allowed; the picture shows ${field.now}.`);
      if (good) changed(key, String(Number(field.value)));
    });
    box.show = (state) => {
      box.hidden = q.with ? !q.with(state) : false;
      if (q.also) box.querySelector("small").textContent = `, ${q.note}: ${q.also(state)}`;
      field.now = state[key];
      const place = toSlider(q, Number(state[key]));
      if (Number(slider.value) !== place) slider.value = place;
      const said = `${state[key]} ${q.unit}`;
      if (slider.getAttribute("aria-valuetext") === said && field.value === state[key]) return;
      slider.setAttribute("aria-valuetext", said);
      if (document.activeElement !== field) {
        field.value = state[key];
        told(field, "");
      }
    };
    return box;
  }

  function ratio(name, changed) {
    const { label, name: symbol } = explorer.ratios[name];
    const box = document.createElement("div");
    box.className = "ratio";
    box.innerHTML = `<label for="ratio-${name}"><i>${sunk(symbol)}</i><span>${label}</span></label><input type="text" inputmode="decimal" id="ratio-${name}" autocomplete="off" spellcheck="false">`;
    const field = box.querySelector("input");
    let state = {};
    field.addEventListener("input", () => {
      const given = Number.isFinite(Number(field.value)) && field.value.trim();
      const [of, si] = given ? explorer.fromRatio(state, name, field.value) : [explorer.ratios[name].of, ""];
      const good = explorer.allowed(of, si);
      const q = explorer.quantities[of];
      told(field, good ? "" : `${symbol}: ${explorer.named(q)} in ${q.unit}: ${explorer.range(of)} has to result; the picture shows ${field.now}.`);
      if (good) changed(of, si);
    });
    box.show = (now, n) => {
      state = now;
      field.now = Number(n[name].toPrecision(8));
      if (document.activeElement !== field) {
        field.value = field.now;
        told(field, "");
      }
    };
    return box;
  }

  explorer.controls = (place, ratios, changed) => {
    const boxes = Object.entries(explorer.quantities).map(([key, q]) => row(key, q, changed));
    const plain = Object.keys(explorer.ratios).map((name) => ratio(name, changed));
    place.replaceChildren(...boxes);
    ratios.replaceChildren(...plain);
    return (state, n) => [...boxes, ...plain].forEach((box) => box.show(state, n));
  };

  // a device and an arm are set apart from each other
  explorer.presets = (device, arm, set) => {
    const { devices, arms } = explorer.data;
    for (const [select, all] of [[device, devices], [arm, arms]]) {
      all.forEach((one, i) => select.append(new Option(one.name, String(i))));
    }
    const none = Object.fromEntries(["m_H", "b_H", "k_H", explorer.WITH_DEVICE].map((key) => [key, "0"]));
    const apply = (fresh) => {
      const sources = [devices[device.value], arms[arm.value]].map((one) => one?.source);
      set(fresh, sources.filter(Boolean));
    };
    device.addEventListener("change", () => apply(devices[device.value]?.values));
    arm.addEventListener("change", () => apply({ ...none, ...arms[arm.value]?.values }));
  };
})();
