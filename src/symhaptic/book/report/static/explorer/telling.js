// The numbers beside the pictures, and the motion after a push.
"use strict";
(() => {
  // the numbers of the state, with mass, damping and stiffness of device and arm together
  const together = (s) => Object.fromEntries(Object.entries({ ...s, ...explorer.coupled(s) }).map(([key, text]) => [key, Number(text)]));

  // four digits, as a reader wants them; the whole number is in the title
  explorer.number = (value) => {
    if (value === Infinity) return "unlimited";
    if (!Number.isFinite(value)) return "none";
    const text = Number(value.toPrecision(4));
    if (text === 0) return "0";
    if (Math.abs(text) >= 1e7 || Math.abs(text) < 1e-4) return text.toExponential().replace("e+", "e").replace("-", "−");
    return String(text).replace("-", "−");
  };

  // a page lays out what is written, so that only what changes is
  explorer.write = (place, text) => {
    if (place.textContent !== text) place.textContent = text;
  };

  function say(id, value, unit, note = "", text = "") {
    const place = document.getElementById(id);
    explorer.write(place, text || (Number.isFinite(value) ? `${explorer.number(value)} ${unit}` : explorer.number(value)));
    place.dataset.value = String(value);
    explorer.write(document.getElementById(`${id}-note`), note);
  }

  function judge(id, good, yes, no) {
    const place = document.getElementById(id);
    explorer.write(place, good ? yes : no);
    place.className = good ? "judged good" : "judged bad";
  }

  function hold(id, text) {
    const place = document.getElementById(id);
    explorer.write(place, text);
    place.className = "judged";
  }

  explorer.tell = (s, n, limits, K, B) => {
    const T = Number(s.T);
    const hertz = (theta) => theta / (2 * Math.PI * T);
    const at = (theta) => (Number.isFinite(theta) && theta > 0 ? `swings at ${explorer.number(hertz(theta))} Hz` : "");
    judge("told-stable", limits.stable, "stable", "unstable");
    if (limits.told) judge("told-passive", limits.passive, "passive", "not passive");
    else hold("told-passive", "passivity not computed");
    const limit = Math.abs(limits.alpha) < 1e-14 ? 0 : limits.alpha; // where nothing damps, but for rounding
    say("told-limit", limit * K, "N/m", limit > 0 ? at(limits.theta) : "");
    if (Number.isFinite(limits.stiffest[0])) say("told-stiffest", limits.stiffest[0] * K, "N/m", [`with B = ${explorer.number(limits.stiffest[1] * B)} Ns/m`, at(limits.stiffest[2])].filter(Boolean).join(", "));
    else if (n.filter) say("told-stiffest", NaN, "N/m");
    else say("told-stiffest", NaN, "N/m", "outside of what the exported search covers", "not searched for");
    const untold = ["with a filter it is computed for integer delays", "not computed"];
    if (!limits.told) for (const id of ["told-passive-limit", "told-stiffest-passive", "told-needed"]) say(id, NaN, "", ...untold);
    else passivity(s, limits, K, B, hertz);
    if (n.filter) say("told-linear", NaN, "N/m", "the paper derives it for the difference of two samples", "not computed");
    else say("told-linear", limits.linear * K, "N/m");
    delay(limits, n, 1000 * T);
    rules(together(s), limit * K, n.filter);
    short(together(s), limit * K);
    for (const [kind, hidden] of [["whole", n.filter || n.d % 1 !== 0], ["fraction", n.filter || n.d % 1 === 0], ["filter", !n.filter]]) {
      for (const place of document.querySelectorAll(`.delay-${kind}`)) place.hidden = Boolean(hidden);
    }
  };

  function passivity(s, limits, K, B, hertz) {
    say("told-passive-limit", limits.passive_alpha * K, "N/m");
    say("told-stiffest-passive", limits.stiffest_passive[0] * K, "N/m", `with B = ${explorer.number(limits.stiffest_passive[1] * B)} Ns/m`);
    say("told-needed", limits.needed * B, "Ns/m", Number.isFinite(limits.needed) ? `the device has ${explorer.number(Number(s.b))} Ns/m; most at ${explorer.number(hertz(limits.worst))} Hz` : "no damping suffices for K < 0");
  }

  // what may be added to the delay, and the sum
  function delay(limits, n, ms) {
    const margin = limits.delay_margin * ms;
    if (limits.delay === Infinity) say("told-delay", margin, "ms", "stable for more than 200 periods of delay", `> ${explorer.number((200 - n.d) * ms)} ms`);
    else if (!limits.stable) say("told-delay", margin, "ms", "the wall is not stable", "none");
    else if (Number.isNaN(margin)) say("told-delay", margin, "ms", "the wall is unstable with some smaller delay", "not computed");
    else say("told-delay", margin, "ms", `stable up to a delay of ${explorer.number(limits.delay * ms)} ms`);
  }

  // the limit beside the rule that one would have used, which is shown as it is in print below
  function short(s, exact) {
    const plain = s.B === 0 && s.t_d === 0;
    const rule = explorer.rules.find((one) => one.id === (plain ? "twice-damping" : "damping-over-delay"));
    const value = rule.limit(s);
    const times = exact > 0 ? `, ${explorer.number(Number((value / exact).toPrecision(3)))} times that` : "";
    const [own, formula, allows] = document.getElementById("told-short").children;
    explorer.write(own, exact > 0 ? `At this damping K may reach ${explorer.number(exact)} N/m` : "At this damping no stiffness is stable");
    explorer.write(allows, `allows ${explorer.number(value)} N/m${times}.`);
    if (formula.dataset.rule === rule.id) return;
    formula.dataset.rule = rule.id;
    const print = document.querySelector(`.rule-${rule.id} math`).cloneNode(true);
    print.setAttribute("display", "inline");
    formula.replaceChildren(print);
  }

  function rules(values, exact, filter) {
    for (const rule of explorer.rules) {
      const row = document.querySelector(`.rule-${rule.id}`);
      const value = rule.limit(values);
      const meant = rule.meant(values) && !(filter && values.B !== 0);
      const [number, verdict] = row.querySelectorAll(".rule-value, .rule-verdict");
      explorer.write(number, Number.isFinite(value) ? `${explorer.number(value)} N/m` : "none");
      number.dataset.value = String(value);
      const over = exact > 0 ? value / exact : Infinity;
      let text = "on the safe side here";
      if (!(value > 0)) text = "allows no stiffness here";
      else if (!(exact > 0)) text = "unstable: no stiffness is stable here";
      else if (over > 1) text = `allows unstable walls: ${over > 10 ? "more than 10" : explorer.number(Number(over.toPrecision(3)))} times the limit`;
      explorer.write(verdict, meant ? text : `${text} (not made for this loop)`);
      verdict.className = `rule-verdict ${value > 0 && !(over <= 1) ? "over" : "safe"}`;
    }
  }

  // the limits over the damping, with the filter and without it
  explorer.drawChart = (svg, size, n, points, limits, K, B) => {
    const chart = explorer.chart(n, points);
    const plain = { ...n, filter: null };
    const bare = n.filter ? explorer.chart(plain, explorer.curve(plain)) : [];
    const top = (i, walls) => Math.max(0, ...walls.map((wall) => wall[i] || 0));
    const beta = Math.max(n.beta, top(1, chart));
    const alpha = top(0, chart);
    const beside = Math.min(3 * alpha, top(0, bare.filter((wall) => wall[1] <= beta)));
    const view = { left: 0, right: 1.05 * Math.max(n.alpha, alpha, beside) || 1, low: 0, high: 1.05 * beta || 1 };
    const si = { left: 0, right: view.right * K, low: 0, high: view.high * B };
    const { inside } = explorer.frame(svg, si, size, ["virtual stiffness K in N/m", "virtual damping B in Ns/m"]);
    const { element } = explorer;
    const frame = explorer.scale(view, size);
    const far = (value) => Math.max(-9999, Math.min(9999, value)).toFixed(1);
    const line = (walls) => walls.map(([alpha, beta], i) => (Number.isNaN(alpha) ? "" : `${Number.isFinite(walls[i - 1]?.[0]) ? "L" : "M"}${far(frame.x(alpha))} ${far(frame.y(beta))}`)).join("");
    const paths = { passive: explorer.passivePath(n, frame), linear: line(bare), edge: line(chart) };
    for (const [name, d] of Object.entries(paths)) inside.append(element("path", { class: name, d }));
    inside.append(element("circle", { class: limits.stable ? "wall" : "wall lost", cx: frame.x(n.alpha), cy: frame.y(n.beta), r: 7 }));
  };

  explorer.drawMotion = (svg, width, s, n, stable) => {
    const x = explorer.response(n);
    const { T, K, m, k } = together(s);
    const unit = (1e3 * T ** 2) / m; // mm of a push of 1 N
    const rest = 1e3 / (K + k);
    const values = x.map((value) => value * unit);
    const limit = Number.isFinite(rest) && rest > 0 ? 12 * rest : Infinity;
    const most = Math.min(Math.max(1e-9, ...values), limit);
    const least = Math.max(Math.min(0, ...values), -limit);
    const room = 0.06 * (most - least);
    const view = { left: 0, right: 1e3 * T * Math.max(1, x.length - 1), low: least - room, high: most + room };
    const frame = explorer.frame(svg, view, [width, 240], ["time in ms", "position in mm"]);
    const far = (value) => Math.max(-9999, Math.min(9999, value)).toFixed(1);
    const path = values.map((value, i) => `${frame.x(1e3 * T * i).toFixed(1)} ${far(frame.y(value))}`).join("L");
    if (Number.isFinite(rest)) frame.inside.append(explorer.element("path", { class: "linear", d: `M${frame.left} ${far(frame.y(rest))}H${frame.right}` }));
    frame.inside.append(explorer.element("path", { class: stable ? "motion" : "motion lost", d: `M${path}` }));
    svg.setAttribute("aria-label", stable ? `The position settles at ${explorer.number(rest)} mm.` : "The position swings up: the loop is unstable.");
  };
})();
