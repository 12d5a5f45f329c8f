// The state for elsewhere: Scene in Python and TOML, a call in C, and pictures as files.
"use strict";
(() => {
  const pythonArm = (s) => (explorer.hasArm(s) ? `
    arm=Arm(mass=${s.m_H}, damping=${s.b_H}, stiffness=${s.k_H}${explorer.replaces(s) ? ", with_device=True" : ""}),` : "");

  const tomlArm = (s) => (explorer.hasArm(s) ? `
[arm]
mass = ${s.m_H}
damping = ${s.b_H}
stiffness = ${s.k_H}
${explorer.replaces(s) ? "with_device = true\n" : ""}` : "");

  // kind of a filter, its options, and how they are written
  const filters = { "low-pass": {}, tustin: { mapping: '"Tustin"' }, "second-order": { order: 2 } };
  const given = (s, between) => Object.entries({ cutoff: s.f_c, ...filters[s.velocity] }).map((pair) => pair.join(between));

  const pythonFilter = (s) => (explorer.filtered(s) ? `
    velocity=LowPass(${given(s, "=").join(", ")}),  # Hz` : "");

  const tomlFilter = (s) => (explorer.filtered(s) ? `
[velocity]
kind = "low-pass"
${given(s, " = ").join("\n")}
` : "");

  const pythonPassive = (s, n) => (explorer.passivityTold(n)
    ? `print(scene.is_passive(K=${s.K}, B=${s.B}), scene.max_passive_stiffness())\n` : "");

  // the wall itself, where the exported functions do not know its filter
  function cWall(s, n) {
    const [above, below] = explorer.coefficients(n.filter);
    const [a2, a1, a0] = above.map((each) => each / Number(s.T));
    return `/* The wall in SI units, called once every ${s.T} s. With the file under TOML,
   symhaptic controller writes it with a self-test. */
double wall(double x) /* position in m; returns the force in N */
{
    static double x1, x2, v1, v2;
    const double v = ${a2} * x + ${a1} * x1 + ${a0} * x2
        - ${below[1]} * v1 - ${below[2]} * v2;
    x2 = x1;
    x1 = x;
    v2 = v1;
    v1 = v;
    return -(${s.K} * x + ${s.B} * v);
}
`;
  }

  explorer.copies = {
    Python: (s, n) => `from symhaptic import ${[...(explorer.hasArm(s) ? ["Arm"] : []), ...(n.filter ? ["LowPass"] : []), "Scene"].join(", ")}

scene = Scene(
    mass=${s.m}, damping=${s.b}, stiffness=${s.k},  # of the device, in kg, Ns/m, N/m
    sampling_period=${s.T}, delay=${s.t_d},  # s${pythonArm(s)}${pythonFilter(s)}
)
# K = ${s.K} N/m, B = ${s.B} Ns/m; stability counts device and arm, passivity the device alone
print(scene.is_stable(K=${s.K}, B=${s.B}), scene.limit_at(B=${s.B}), scene.max_stable_stiffness())
${pythonPassive(s, n)}print(scene.delay_margin(K=${s.K}, B=${s.B}))  # s that may be added to the delay
`,
    TOML: (s) => `# SI units: kg, Ns/m, N/m, s
mass = ${s.m}
damping = ${s.b}
stiffness = ${s.k}
sampling_period = ${s.T}
delay = ${s.t_d}
${tomlArm(s)}${tomlFilter(s)}
[wall]
K = ${s.K}
B = ${s.B}
`,
    C: (s, n) => (n.filter ? cWall(s, n) : `#include "haptic.h" /* symhaptic export is_stable passivity_margin --target c */

/* alpha, beta, then gamma and delta of device and arm, delay in sampling periods */
bool stable = haptic_is_stable(${n.alpha}, ${n.beta}, ${n.gamma}, ${n.delta}, ${n.d});
/* alpha, beta, then delta of the device alone, delay in sampling periods */
bool passive = haptic_passivity_margin(${n.alpha}, ${n.beta}, ${n.own}, ${n.d}) >= 0;
`),
  };

  function save(url, name) {
    const link = document.createElement("a");
    link.href = url;
    link.download = name;
    link.click();
  }

  // with the colours of the page written out, so that it looks the same elsewhere
  explorer.standing = (svg) => {
    const copy = svg.cloneNode(true);
    const [all, own] = [svg.querySelectorAll("*"), copy.querySelectorAll("*")];
    all.forEach((element, i) => {
      const style = getComputedStyle(element);
      const said = ["fill", "stroke", "stroke-width", "stroke-dasharray", "opacity", "fill-opacity", "font-size", "font-family"];
      own[i].setAttribute("style", said.map((name) => `${name}:${style.getPropertyValue(name)}`).join(";"));
    });
    const [, , width, height] = svg.getAttribute("viewBox").split(" ");
    copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
    copy.setAttribute("width", width);
    copy.setAttribute("height", height);
    return new XMLSerializer().serializeToString(copy);
  };

  const address = (text) => `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;

  explorer.saveSvg = (svg, name) => save(address(explorer.standing(svg)), `${name}.svg`);

  explorer.savePng = async (svg, name) => {
    const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
    const image = new Image();
    image.src = address(explorer.standing(svg));
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [3 * width, 3 * height];
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    save(canvas.toDataURL("image/png"), `${name}.png`);
  };
})();
