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
  focusable();
  addEventListener("resize", focusable);
  for (const table of document.querySelectorAll("table.ledger")) ledger(table);
});

// what scrolls can be reached by keyboard
function focusable() {
  for (const box of document.querySelectorAll("div.math, .claim p, .answer p, .statement p, .verdict p, pre")) {
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
  }
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
