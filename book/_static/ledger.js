// The ledger of claims: filters, which the address keeps, sorting, and cards on a narrow screen.
// Without it, it is a table.
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
  const number = (row) => Number(text(row, column("row")));
  // "Eq. (3); Sec. III-B, par. 5" and "Sec. I, par. 2; Sec. V, par. 1" belong to their first part.
  const section = (row) => text(row, column("in the paper")).split(/[,;]/)[0];
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
  // Parts of the paper, which chapters link to, say which rows they have; then its places, in its order.
  const parts = new Map();
  for (const link of document.querySelectorAll('[id^="claims-"] > a[href^="#claims-"]')) {
    const [from, to] = link.parentElement.textContent.match(/(\d+) to (\d+)/).slice(1).map(Number);
    parts.set(link.hash.slice(1), { name: link.textContent, from, to });
  }
  const places = new Set(rows.toSorted((a, b) => number(a) - number(b)).map(section));
  const group = (label, options) => {
    const found = make("optgroup", { label });
    found.append(...options);
    return found;
  };
  const sections = make(
    "select",
    {},
    new Option("all", ""),
    group("Parts", [...parts].map(([name, part]) => new Option(part.name, name))),
    group("Places", [...places].map((name) => new Option(name, name))),
  );
  const within = (row, place) => {
    const part = parts.get(place);
    return part ? part.from <= number(row) && number(row) <= part.to : section(row) === place;
  };
  const word = make("input", { type: "search", placeholder: "multicast" });
  // A symbol of the paper, such as S_REL, is typeset, so that its text has no underscore.
  const plain = (said) => said.toLowerCase().replaceAll("_", "");
  // On a phone, some cards are shown until a reader chooses, follows a link, or asks for all.
  const SOME = 5;
  let folded = matchMedia("(width < 37.5rem)").matches;
  const all = make("button", { type: "button", className: "ds-all", textContent: `Show all ${rows.length}` });
  const unfold = () => {
    folded = false;
    all.remove();
    filter();
  };
  all.addEventListener("click", () => {
    unfold();
    rows[SOME].tabIndex = -1;
    rows[SOME].focus({ preventScroll: true });
  });
  window.addEventListener("beforeprint", unfold);
  const filter = () => {
    const asked = plain(word.value.trim());
    for (const [index, row] of rows.entries()) {
      row.hidden =
        (folded && index >= SOME) ||
        (chosen.size > 0 && !chosen.has(row.dataset.verdict)) ||
        (sections.value !== "" && !within(row, sections.value)) ||
        !plain(row.textContent).includes(asked);
    }
    count.value = `${rows.filter((row) => !row.hidden).length} of ${rows.length} rows`;
  };
  // What a reader chose stands in the address, so that a copied link shows the same rows.
  const keep = () => {
    const asked = new URLSearchParams();
    for (const name of chosen) asked.append("verdict", labels.get(name));
    if (sections.value) asked.set("where", sections.value);
    if (word.value.trim()) asked.set("word", word.value.trim());
    history.replaceState(null, "", String(asked) ? `#${asked}` : location.pathname + location.search);
  };
  const change = () => {
    unfold();
    keep();
  };
  const labels = new Map();
  const buttons = [...new Set(rows.map((row) => text(row, column("verdict"))))].map((label) => {
    const name = label[0];
    labels.set(name, label.slice(1).trim());
    const button = make("button", { type: "button", textContent: label });
    button.dataset.verdict = name;
    button.setAttribute("aria-pressed", "false");
    button.addEventListener("click", () => {
      if (!chosen.delete(name)) chosen.add(name);
      press();
      change();
    });
    return button;
  });
  const press = () => {
    for (const button of buttons) button.setAttribute("aria-pressed", String(chosen.has(button.dataset.verdict)));
  };
  sections.addEventListener("change", change);
  word.addEventListener("input", change);
  const verdicts = make("div", { role: "group" }, ...buttons);
  verdicts.setAttribute("aria-label", "Verdicts");
  const bar = make(
    "form",
    { className: "ledger-filters" },
    verdicts,
    make("label", {}, "in the paper ", sections),
    make("label", {}, "word ", word),
    make("button", { type: "reset", textContent: "Reset" }),
    count,
  );
  bar.addEventListener("submit", (event) => event.preventDefault());
  // After the browser has emptied the fields: all rows, in the order in which they came.
  bar.addEventListener("reset", () =>
    setTimeout(() => {
      chosen.clear();
      press();
      change();
      unsorted();
    }),
  );
  const box = table.closest(".pst-scrollable-table-container, .cell_output");
  box.before(bar);
  if (folded) box.after(all);
  filter();

  // Sorting: once for each press; rows that are equal keep their order. Cards have no heads: they are
  // sorted by a select and a button, which say the same as the heads do.
  const order = new Intl.Collator("en", { numeric: true });
  const by = make("select", { ariaLabel: "sort by" }, new Option("severity", ""), ...names.map((name, index) => new Option(name, index)));
  const direction = make("button", { type: "button" });
  const sort = (index, down) => {
    for (const head of heads) head.removeAttribute("aria-sort");
    heads[index].setAttribute("aria-sort", down ? "descending" : "ascending");
    const sign = down ? -1 : 1;
    unfold();
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
  const unsorted = () => {
    for (const head of heads) head.removeAttribute("aria-sort");
    body.append(...rows);
    show("", false);
  };
  by.addEventListener("change", () => (by.value === "" ? unsorted() : sort(Number(by.value), false)));
  direction.addEventListener("click", () => by.value !== "" && sort(Number(by.value), !direction.dataset.down));
  show("", false);
  bar.append(make("span", { className: "ledger-sort" }, "sort by ", by, direction));

  // An address chooses rows, or leads to a part, a row or a formal test, which is in a fold.
  const read = () => {
    const hash = decodeURIComponent(location.hash.slice(1));
    const asked = new URLSearchParams(location.hash.slice(1));
    const target = document.getElementById(hash);
    target?.closest("details")?.setAttribute("open", "");
    const row = target?.closest(".tag_ledger tbody tr");
    if (!hash || (target && !parts.has(hash) && !row?.hidden)) return;
    chosen.clear();
    const verdicts = asked.getAll("verdict");
    for (const [sign, label] of labels) if (verdicts.includes(label)) chosen.add(sign);
    sections.value = parts.has(hash) ? hash : (asked.get("where") ?? "");
    if (sections.selectedIndex < 0) sections.value = "";
    word.value = asked.get("word") ?? "";
    press();
    unfold();
    if (row) row.scrollIntoView();
    else bar.scrollIntoView();
  };
  window.addEventListener("hashchange", read);
  read();
});
