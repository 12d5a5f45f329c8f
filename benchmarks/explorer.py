"""Frames a second of the explorer while a slider is dragged, in a browser without a screen.

`python benchmarks/explorer.py [SITE]` opens explorer.html of a site (reports/site unless told
otherwise), moves the delay once a frame for five seconds, as dragging does, and prints how many
frames were drawn and how long the redraws took; needs Debian's chromium.
"""

import shutil
import sys
from pathlib import Path

from playwright.sync_api import sync_playwright

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
  return [1000 / each, ...[0, 0.5, 0.9, 0.99].map((p) => took[Math.floor(p * took.length)])];
}"""


def main(site):
    with sync_playwright() as playwright:
        found = shutil.which("chromium")
        browser = playwright.chromium.launch(executable_path=found, args=["--no-sandbox"])
        page = browser.new_page()
        page.goto((site / "explorer.html").resolve().as_uri())
        page.wait_for_timeout(500)
        rate, *took = page.evaluate(DRAG, 5)
        browser.close()
    print(f"{rate:.1f} frames a second; a redraw takes, in ms:")
    for name, value in zip(("quickest", "median", "9 of 10", "99 of 100"), took, strict=True):
        print(f"  {name:10} {value:.1f}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "reports/site"))
