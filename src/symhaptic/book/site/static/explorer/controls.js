// Sliders and number fields for what is set, in SI units or without.
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

  function row(key, q, changed) {
    const box = document.createElement("div");
    box.className = "quantity";
    const symbol = key === "t_d" ? "t<sub>d</sub>" : key;
    box.innerHTML = `<label for="field-${key}"><i>${symbol}</i> <span>${q.label}<small>${q.note ? `, ${q.note}` : ""}</small></span></label>`
      + `<input type="range" min="0" max="${STEPS}" id="slider-${key}" aria-label="${q.label}, ${q.note ?? ""} (${q.unit})">`
      + `<input type="text" inputmode="decimal" id="field-${key}" autocomplete="off" spellcheck="false"><span class="unit">${q.unit}</span>`;
    const [slider, field] = [box.querySelector("input[type=range]"), box.querySelector("input[type=text]")];
    slider.addEventListener("input", () => changed(key, fromSlider(q, Number(slider.value))));
    field.addEventListener("input", () => {
      const good = explorer.allowed(key, field.value);
      field.setAttribute("aria-invalid", String(!good));
      const least = q.signed ? "" : q.zero ? " from 0 on" : " more than 0";
      document.getElementById("wrong").textContent = good ? "" : `${q.label} in ${q.unit}: a number${least} is allowed; the picture shows ${field.now}.`;
      if (good) changed(key, String(Number(field.value)));
    });
    box.show = (state) => {
      field.now = state[key];
      const place = toSlider(q, Number(state[key]));
      if (Number(slider.value) !== place) slider.value = place;
      const said = `${state[key]} ${q.unit}`;
      if (slider.getAttribute("aria-valuetext") === said && field.value === state[key]) return;
      slider.setAttribute("aria-valuetext", said);
      if (document.activeElement !== field) {
        field.value = state[key];
        field.setAttribute("aria-invalid", "false");
      }
    };
    return box;
  }

  function ratio(name, changed) {
    const { of, label, name: symbol } = explorer.ratios[name];
    const box = document.createElement("div");
    box.className = "ratio";
    box.innerHTML = `<label for="ratio-${name}"><i>${symbol}</i><span>${label}</span></label><input type="text" inputmode="decimal" id="ratio-${name}" autocomplete="off" spellcheck="false">`;
    const field = box.querySelector("input");
    let state = {};
    field.addEventListener("input", () => {
      const si = Number.isFinite(Number(field.value)) && field.value.trim() ? explorer.fromRatio(state, name, field.value) : "";
      const good = explorer.allowed(of, si);
      field.setAttribute("aria-invalid", String(!good));
      if (good) changed(of, si);
    });
    box.show = (now, n) => {
      state = now;
      if (document.activeElement !== field) {
        field.value = Number(n[name].toPrecision(8));
        field.setAttribute("aria-invalid", "false");
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

  // a device and an arm move together: masses, dampings and springs add up
  explorer.presets = (device, arm, set) => {
    const { devices, arms } = explorer.data;
    for (const [select, all] of [[device, devices], [arm, arms]]) {
      all.forEach((one, i) => select.append(new Option(one.name, String(i))));
    }
    const apply = () => {
      const chosen = [devices[device.value], arms[arm.value]].filter(Boolean);
      const fresh = Object.assign({}, ...chosen.map((one) => one.values));
      for (const key of ["m", "b", "k"]) {
        const there = chosen.map((one) => one.values[key]).filter((text) => text !== undefined);
        if (there.length) fresh[key] = String(Number(there.reduce((sum, text) => sum + Number(text), 0).toPrecision(12)));
      }
      set(fresh, chosen.map((one) => one.source).filter(Boolean));
    };
    device.addEventListener("change", apply);
    arm.addEventListener("change", apply);
  };
})();
