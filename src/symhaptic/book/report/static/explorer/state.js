// The state of the page: numbers in SI units as text, in the address of the page, and without units.
// Device and arm are kept apart: stability counts both, (2) of the paper, passivity the device, (3).
"use strict";
(() => {
  const { quotient, sum, difference } = explorer;

  explorer.quantities = {
    m: { symbol: "m_D", label: "Mass", note: "device", unit: "kg", least: 0.01, most: 100, start: "0.1" },
    b: { symbol: "b_D", label: "Damping", note: "device", unit: "Ns/m", least: 0.01, most: 200, start: "0.5", zero: true },
    k: { symbol: "k_D", label: "Stiffness", note: "device", unit: "N/m", least: 0.1, most: 5000, start: "0", zero: true },
    m_H: { label: "Mass", note: "arm", unit: "kg", least: 0.01, most: 100, start: "0", zero: true },
    b_H: { label: "Damping", note: "arm", unit: "Ns/m", least: 0.01, most: 200, start: "0", zero: true },
    k_H: { label: "Stiffness", note: "arm", unit: "N/m", least: 0.1, most: 5000, start: "0", zero: true },
    T: { label: "Sampling period", unit: "s", least: 1e-5, most: 0.02, start: "0.001" },
    t_d: { label: "Delay", note: "added to the hold", unit: "s", least: 1e-5, most: 0.1, start: "0.0015", zero: true },
    f_c: { label: "Cut-off frequency", note: "velocity filter", unit: "Hz", least: 1, most: 10000, start: "50", with: (state) => explorer.filtered(state), also: (state) => `time constant ${explorer.number(1e3 / (2 * Math.PI * state.f_c))} ms` },
    K: { label: "Stiffness", note: "virtual wall", unit: "N/m", least: 1, most: 1e6, start: "1000", zero: true, signed: true },
    B: { label: "Damping", note: "virtual wall", unit: "Ns/m", least: 0.01, most: 5000, start: "5", zero: true, signed: true },
  };

  // whether the numbers of the arm were measured together with the device, which they then replace
  explorer.WITH_DEVICE = "with_device";

  // what is chosen from a few words; the first is the choice at the start
  const choices = { [explorer.WITH_DEVICE]: ["0", "1"], velocity: ["difference", "low-pass", "tustin", "second-order"] };

  explorer.filtered = (state) => choices.velocity.indexOf(state.velocity) > 0;

  // the dimensionless parameters, with the mass m of device and arm
  explorer.ratios = {
    gamma: { of: "k", both: true, name: "γ", label: "Stiffness, device and arm", up: ["T", "T"], down: ["m"] },
    delta: { of: "b", both: true, name: "δ", label: "Damping, device and arm", up: ["T"], down: ["m"] },
    own: { of: "b", name: "δ_D", label: "Damping, device alone", up: ["T"], down: ["m"] },
    d: { of: "t_d", name: "d", label: "Delay", up: [], down: ["T"] },
    alpha: { of: "K", name: "α", label: "Wall stiffness", up: ["T", "T"], down: ["m"] },
    beta: { of: "B", name: "β", label: "Wall damping", up: ["T"], down: ["m"] },
  };

  const [SMALLEST, LARGEST] = [1e-12, 1e12];

  explorer.named = (q) => (q.note ? `${q.label}, ${q.note},` : q.label);

  // in words, what is allowed
  explorer.range = (key) => {
    const q = explorer.quantities[key];
    if (q.signed) return "a number up to 1e12 in size";
    return `${q.zero ? "0 or " : ""}a number from 1e-12 to 1e12`;
  };

  explorer.allowed = (key, text) => {
    const value = Number(text);
    const q = explorer.quantities[key];
    if (String(text).trim() === "" || !Number.isFinite(value)) return false;
    if (q.signed) return Math.abs(value) <= LARGEST;
    return (q.zero ? value >= 0 : value > 0) && value <= LARGEST && (value === 0 || value >= SMALLEST);
  };

  explorer.start = () => ({
    ...Object.fromEntries(Object.entries(explorer.quantities).map(([key, q]) => [key, q.start])),
    ...Object.fromEntries(Object.entries(choices).map(([key, [first]]) => [key, first])),
  });

  explorer.hasArm = (state) => ["m_H", "b_H", "k_H"].some((key) => Number(state[key] ?? 0) > 0);

  // an arm without a mass cannot take the place of a device
  explorer.replaces = (state) => state[explorer.WITH_DEVICE] === "1" && Number(state.m_H) > 0;

  // mass, damping and stiffness of device and arm together, (2)
  explorer.coupled = (state) => Object.fromEntries(["m", "b", "k"].map((key) => {
    const arm = state[`${key}_H`] ?? "0";
    return [key, explorer.replaces(state) ? arm : sum(state[key], arm)];
  }));

  explorer.numbers = (state) => {
    const both = { ...state, ...explorer.coupled(state) };
    const out = {};
    for (const [name, { of, both: shared, up, down }] of Object.entries(explorer.ratios)) {
      const own = shared ? both[of] : state[of];
      out[name] = quotient([own, ...up.map((key) => state[key])], down.map((key) => both[key]));
    }
    out.filter = explorer.filter(state.velocity, 1 / (2 * Math.PI * state.f_c * state.T));
    return out;
  };

  // the quantity that a number without unit sets, and its value; the arm stays as it is
  explorer.fromRatio = (state, name, text) => {
    const { of, both: shared, up, down } = explorer.ratios[name];
    const both = { ...state, ...explorer.coupled(state) };
    const value = String(quotient([text, ...down.map((key) => both[key])], up.map((key) => state[key])));
    if (!shared) return [of, value];
    return explorer.replaces(state) ? [`${of}_H`, value] : [of, difference(value, state[`${of}_H`])];
  };

  explorer.toHash = (state) => {
    const filtered = explorer.filtered(state);
    const keys = Object.keys(explorer.quantities).filter((key) => filtered || key !== "f_c");
    if (explorer.replaces(state)) keys.push(explorer.WITH_DEVICE);
    if (filtered) keys.push("velocity");
    return `#${keys.map((key) => `${key}=${state[key]}`).join("&")}`;
  };

  explorer.fromHash = (hash) => {
    const state = explorer.start();
    for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
      if (taken(key, text)) state[key] = Object.hasOwn(choices, key) ? text : String(Number(text));
    }
    return state;
  };

  const taken = (key, text) => (Object.hasOwn(choices, key) ? choices[key].includes(text)
    : Object.hasOwn(explorer.quantities, key) && explorer.allowed(key, text));

  // in words, the parts of a link that are not allowed; one without numbers is a place in the page
  explorer.refused = (hash, state) => (hash.includes("=") ? [...new URLSearchParams(hash.replace(/^#/, ""))] : [])
    .filter(([key, text]) => !taken(key, text))
    .map(([key, text]) => {
      const q = Object.hasOwn(explorer.quantities, key) && explorer.quantities[key];
      const known = q ? `${explorer.named(q)} in ${q.unit}: ${explorer.range(key)} is allowed; the picture shows ${state[key]}.`
        : Object.hasOwn(choices, key) ? `${choices[key].join(" or ")} is allowed.`
          : `it may have ${[...Object.keys(explorer.quantities), "velocity"].join(", ")}.`;
      return `The link has ${key} = ${text}; ${known}`;
    }).join(" ");
})();
