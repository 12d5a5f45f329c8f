// What is set: numbers in SI units as text, in the address of the page, and without units.
"use strict";
(() => {
  const { quotient } = explorer;

  explorer.quantities = {
    m: { label: "Mass", note: "device and arm", unit: "kg", least: 0.01, most: 100, start: "0.1", above: 0 },
    b: { label: "Damping", note: "physical", unit: "Ns/m", least: 0.01, most: 200, start: "0.5", zero: true },
    k: { label: "Stiffness", note: "physical", unit: "N/m", least: 0.1, most: 5000, start: "0", zero: true },
    T: { label: "Sampling period", unit: "s", least: 1e-5, most: 0.02, start: "0.001", above: 0 },
    t_d: { label: "Delay", note: "added to the hold", unit: "s", least: 1e-5, most: 0.1, start: "0.0015", zero: true },
    K: { label: "Stiffness", note: "virtual wall", unit: "N/m", least: 1, most: 1e6, start: "1000", zero: true, signed: true },
    B: { label: "Damping", note: "virtual wall", unit: "Ns/m", least: 0.01, most: 5000, start: "5", zero: true, signed: true },
  };

  // alpha to delta and the delay in periods, by what they are made of
  explorer.ratios = {
    gamma: { of: "k", name: "γ", label: "Stiffness", up: ["T", "T"], down: ["m"] },
    delta: { of: "b", name: "δ", label: "Damping", up: ["T"], down: ["m"] },
    d: { of: "t_d", name: "d", label: "Delay", up: [], down: ["T"] },
    alpha: { of: "K", name: "α", label: "Wall stiffness", up: ["T", "T"], down: ["m"] },
    beta: { of: "B", name: "β", label: "Wall damping", up: ["T"], down: ["m"] },
  };

  const [SMALLEST, LARGEST] = [1e-12, 1e12];

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

  explorer.start = () => Object.fromEntries(Object.entries(explorer.quantities).map(([key, q]) => [key, q.start]));

  explorer.numbers = (state) => {
    const out = {};
    for (const [name, { of, up, down }] of Object.entries(explorer.ratios)) {
      out[name] = quotient([state[of], ...up.map((key) => state[key])], down.map((key) => state[key]));
    }
    return out;
  };

  // the SI value that a number without unit stands for
  explorer.fromRatio = (state, name, text) => {
    const { up, down } = explorer.ratios[name];
    return String(quotient([text, ...down.map((key) => state[key])], up.map((key) => state[key])));
  };

  explorer.toHash = (state) => `#${Object.keys(explorer.quantities).map((key) => `${key}=${state[key]}`).join("&")}`;

  explorer.fromHash = (hash) => {
    const state = explorer.start();
    for (const [key, text] of new URLSearchParams(hash.replace(/^#/, ""))) {
      if (taken(key, text)) state[key] = String(Number(text));
    }
    return state;
  };

  const taken = (key, text) => Object.hasOwn(explorer.quantities, key) && explorer.allowed(key, text);

  // in words, what a link has that is not taken; one without numbers is a place in the page
  explorer.refused = (hash, state) => (hash.includes("=") ? [...new URLSearchParams(hash.replace(/^#/, ""))] : [])
    .filter(([key, text]) => !taken(key, text))
    .map(([key, text]) => {
      const q = Object.hasOwn(explorer.quantities, key) && explorer.quantities[key];
      const known = q ? `${q.label} in ${q.unit}: ${explorer.range(key)} is allowed; the picture shows ${state[key]}.`
        : `it may have ${Object.keys(explorer.quantities).join(", ")}.`;
      return `The link has ${key} = ${text}; ${known}`;
    }).join(" ");
})();
