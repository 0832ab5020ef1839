// The ledger of claims: filters, sorting, and cards on a narrow screen. Without it, it is a table.
window.addEventListener("DOMContentLoaded", () => {
  const table = document.querySelector(".tag_ledger table");
  if (!table) return;
  const body = table.tBodies[0];
  const rows = [...body.rows];
  const heads = [...table.tHead.rows[0].cells];
  const names = heads.map((head) => head.textContent.trim());
  const column = (name) => names.indexOf(name);
  const text = (row, index) => row.cells[index].textContent.trim();
  // The sign before the word, which may be another one.
  const verdict = (row) => text(row, column("verdict"))[0];
  // A place such as "Sec. IV-B" or "Abstract, Sec. I" belongs to its first part.
  const section = (row) => text(row, column("where")).split(",")[0];
  const make = (name, properties, ...children) => {
    const element = Object.assign(document.createElement(name), properties);
    element.append(...children);
    return element;
  };

  for (const row of rows) {
    row.dataset.verdict = verdict(row);
    for (const [index, cell] of [...row.cells].entries()) cell.dataset.label = names[index];
  }

  // Filters: all that are set must fit.
  const chosen = new Set();
  const count = make("output", { className: "ledger-count" });
  const sections = make("select", {}, new Option("all", ""));
  for (const name of new Set(rows.map(section))) sections.add(new Option(name));
  const word = make("input", { type: "search", placeholder: "multicast" });
  // A symbol of the paper, such as S_REL, is typeset, so that its text has no underscore.
  const plain = (said) => said.toLowerCase().replaceAll("_", "");
  const filter = () => {
    const asked = plain(word.value.trim());
    for (const row of rows) {
      row.hidden =
        (chosen.size > 0 && !chosen.has(row.dataset.verdict)) ||
        (sections.value !== "" && section(row) !== sections.value) ||
        !plain(row.textContent).includes(asked);
    }
    count.value = `${rows.filter((row) => !row.hidden).length} of ${rows.length} claims`;
  };
  const buttons = [...new Set(rows.map((row) => text(row, column("verdict"))))].map((label) => {
    const name = label[0];
    const button = make("button", { type: "button", textContent: label });
    button.dataset.verdict = name;
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => {
      if (!chosen.delete(name)) chosen.add(name);
      button.setAttribute("aria-pressed", String(chosen.has(name)));
      filter();
    });
    return button;
  });
  sections.addEventListener("change", filter);
  word.addEventListener("input", filter);
  const verdicts = make("div", { role: "group" }, ...buttons);
  verdicts.setAttribute("aria-label", "Verdicts");
  const bar = make(
    "form",
    { className: "ledger-filters" },
    verdicts,
    make("label", {}, "where ", sections),
    make("label", {}, "word ", word),
    count,
  );
  bar.addEventListener("submit", (event) => event.preventDefault());
  table.closest(".pst-scrollable-table-container, .cell_output").before(bar);
  filter();

  // Sorting: once for each press; rows that are equal keep their order. Cards have no heads: they are
  // sorted by a select and a button, which say the same as the heads do.
  const order = new Intl.Collator("en", { numeric: true });
  const by = make("select", { ariaLabel: "sort by" }, ...names.map((name, index) => new Option(name, index)));
  const direction = make("button", { type: "button" });
  const sort = (index, down) => {
    for (const head of heads) head.removeAttribute("aria-sort");
    heads[index].setAttribute("aria-sort", down ? "descending" : "ascending");
    const sign = down ? -1 : 1;
    const current = [...body.rows];
    current.sort((a, b) => sign * order.compare(text(a, index), text(b, index)));
    body.append(...current);
    show(index, down);
  };
  const show = (index, down) => {
    by.value = index;
    direction.textContent = down ? "\u2193 descending" : "\u2191 ascending";
    direction.dataset.down = down ? "yes" : "";
  };
  for (const [index, head] of heads.entries()) {
    const button = make("button", { type: "button" }, ...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => sort(index, head.getAttribute("aria-sort") === "ascending"));
  }
  by.addEventListener("change", () => sort(Number(by.value), false));
  direction.addEventListener("click", () => sort(Number(by.value), !direction.dataset.down));
  show(0, false);
  bar.append(make("span", { className: "ledger-sort" }, "sort by ", by, direction));

  // A link to a formal test opens the fold in which it is.
  const unfold = () => document.getElementById(location.hash.slice(1))?.closest("details")?.setAttribute("open", "");
  window.addEventListener("hashchange", unfold);
  unfold();
});
