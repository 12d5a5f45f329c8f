// A formula's LaTeX to copy, and a ledger to filter and to sort. Everything is there without it.
"use strict";
document.addEventListener("DOMContentLoaded", () => {
  for (const box of document.querySelectorAll("div.math")) {
    const source = box.querySelector("annotation[encoding='application/x-tex']");
    if (!source) continue;
    const button = document.createElement("button");
    button.className = "tex";
    button.type = "button";
    button.textContent = "LaTeX";
    button.setAttribute("aria-label", "Copy the LaTeX of this formula");
    button.addEventListener("click", async () => {
      await navigator.clipboard.writeText(source.textContent);
      button.textContent = "copied";
      setTimeout(() => { button.textContent = "LaTeX"; }, 1500);
    });
    box.append(button);
  }
  wide();
  addEventListener("resize", wide);
  addEventListener("toggle", wide, true);
  addEventListener("scroll", ({ target }) => { if (target.dataset?.more) target.dataset.more = arrow(target); }, { capture: true, passive: true });
  for (const table of document.querySelectorAll("table.ledger")) ledger(table);
});

// what is wider than its column is reached by keyboard, and an arrow says where it goes on
function wide() {
  const boxes = [...document.querySelectorAll("div.math, .claim p, .answer p, .statement p, .verdict p, pre, .table-wrapper")];
  const arrows = boxes.map(arrow); // all are read before any is written
  boxes.forEach((box, i) => {
    if (arrows[i]) Object.assign(box, { tabIndex: 0 }).dataset.more = arrows[i];
    else for (const name of ["tabindex", "data-more"]) box.removeAttribute(name);
  });
}

function arrow(box) {
  if (box.scrollWidth <= box.clientWidth + 1) return "";
  const [before, behind] = [box.scrollLeft > 1, box.scrollLeft + box.clientWidth < box.scrollWidth - 1];
  return [before ? "←" : "", behind ? "→" : ""].join(" ").trim();
}

function ledger(table) {
  const body = table.tBodies[0];
  const rows = [...body.rows];
  const kinds = [...new Set(rows.map((row) => row.cells[2].textContent.trim()))].sort();
  const tools = document.createElement("div");
  tools.className = "ledger-tools";
  tools.innerHTML = '<label>Find <input type="search"></label><label>Verdict <select><option value="">all</option></select></label><span role="status"></span>';
  const [find, kind, status] = [tools.querySelector("input"), tools.querySelector("select"), tools.querySelector("span")];
  for (const one of kinds) kind.append(new Option(one, one));
  const show = () => {
    const wanted = find.value.toLowerCase();
    let count = 0;
    for (const row of rows) {
      const fits = row.textContent.toLowerCase().includes(wanted) && (!kind.value || row.cells[2].textContent.trim() === kind.value);
      row.hidden = !fits;
      count += fits;
    }
    status.textContent = `${count} of ${rows.length} statements`;
  };
  find.addEventListener("input", show);
  kind.addEventListener("change", show);
  table.before(tools);
  [...table.tHead.rows[0].cells].forEach((cell, at) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = cell.textContent.trim();
    cell.replaceChildren(button);
    let up = false;
    button.addEventListener("click", () => {
      up = !up;
      for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
      cell.setAttribute("aria-sort", up ? "ascending" : "descending");
      const key = (row) => row.cells[at].textContent.trim();
      rows.sort((a, b) => (up ? 1 : -1) * key(a).localeCompare(key(b), "en", { numeric: true }));
      body.append(...rows);
    });
  });
  show();
}
