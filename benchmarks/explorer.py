"""Frames a second of the explorer while a slider is dragged, in a browser without a screen.

`python benchmarks/explorer.py [SITE]` opens explorer.html of a site (reports/site unless told
otherwise), moves the delay once a frame for five seconds, as dragging does, and prints how many
frames were drawn, beside a page that draws nothing, and how long the redraws took; needs Debian's
chromium.  On a machine that does other work it shows that work, too.
"""

import shutil
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

NOTHING = """async (seconds) => {
  let frames = 0;
  const begin = performance.now();
  while (performance.now() - begin < 1000 * seconds) {
    await new Promise(requestAnimationFrame);
    frames += 1;
  }
  return (1000 * frames) / (performance.now() - begin);
}"""

DRAG = """async (seconds) => {
  const slider = document.getElementById("slider-t_d");
  const took = [];
  let frames = 0;
  const begin = performance.now();
  while (performance.now() - begin < 1000 * seconds) {
    slider.value = 300 + 3 * (frames % 60);
    slider.dispatchEvent(new Event("input"));
    await new Promise(requestAnimationFrame);
    took.push(explorer.took);
    frames += 1;
  }
  const each = (performance.now() - begin) / frames;
  took.sort((a, b) => a - b);
  return [1000 / each, ...[0, 0.5, 0.9, 0.99, 1].map((p) => took[Math.floor(p * (frames - 1))])];
}"""


def main(site):
    with sync_playwright() as playwright:
        found = shutil.which("chromium")
        browser = playwright.chromium.launch(executable_path=found, args=["--no-sandbox"])
        page = browser.new_page()
        most = page.evaluate(NOTHING, 5)
        page.goto((site / "explorer.html").resolve().as_uri())
        page.wait_for_timeout(1000)
        rate, *took = page.evaluate(DRAG, 5)
        browser.close()
    print(f"{rate:.1f} frames a second, {rate / most:.3f} of an empty page; a redraw takes, in ms:")
    names = ("quickest", "median", "9 of 10", "99 of 100", "longest")
    for name, value in zip(names, took, strict=True):
        print(f"  {name:10} {value:.1f}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "reports/site"))
