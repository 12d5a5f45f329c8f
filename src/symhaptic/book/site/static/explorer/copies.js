// The state for elsewhere: Scene in Python and TOML, a call in C, and pictures as files.
"use strict";
(() => {
  explorer.copies = {
    Python: (s) => `from symhaptic import Scene

scene = Scene(
    mass=${s.m}, damping=${s.b}, stiffness=${s.k},  # kg, Ns/m, N/m
    sampling_period=${s.T}, delay=${s.t_d},  # s
)
print(scene.limit_at(B=${s.B}))  # the wall: K = ${s.K} N/m, B = ${s.B} Ns/m
print(scene.max_stable_stiffness(), scene.max_passive_stiffness())
print(scene.delay_margin(K=${s.K}, B=${s.B}))
`,
    TOML: (s) => `# SI units: kg, Ns/m, N/m, s
mass = ${s.m}
damping = ${s.b}
stiffness = ${s.k}
sampling_period = ${s.T}
delay = ${s.t_d}

[wall]
K = ${s.K}
B = ${s.B}
`,
    C: (s, n) => `#include "haptic.h" /* symhaptic export is_stable --target c */

/* alpha, beta, gamma, delta, delay in sampling periods */
bool stable = haptic_is_stable(${n.alpha}, ${n.beta}, ${n.gamma}, ${n.delta}, ${n.d});
`,
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
