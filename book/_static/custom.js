// Before anything is drawn: the theme resolves "auto" only later, and the page would move.
if (document.documentElement.dataset.theme === "auto")
  document.documentElement.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";

// The fonts come in the style sheet, but are unpacked only when a letter is set in them: all lines would then be
// broken anew. So they are unpacked first, and the page is shown with them.
{
  const MOST = 1000; // ms
  const root = document.documentElement;
  const faces = [...document.fonts].filter(({ family }) => family.includes("Source"));
  const unpacked = Promise.all(faces.map((face) => face.load()));
  root.classList.add("ds-unpacking");
  Promise.race([unpacked, new Promise((done) => setTimeout(done, MOST))])
    .catch(() => {})
    .then(() => root.classList.remove("ds-unpacking"));
}

window.addEventListener("load", async () => {
  const narrow = window.matchMedia("(width < 37.5rem)");
  const TABLE = ".pst-scrollable-table-container";

  // On a phone a table of words that is too wide becomes a card for each row, as the ledger does.
  const WORDS = 24; // letters from which on a cell is more than a number or a name
  const labels = (table) => [...(table.tHead?.rows[0]?.cells ?? [])].map((cell) => cell.textContent.trim());
  const isOfWords = (table) =>
    !table.closest(".tag_ledger") &&
    table.tHead?.rows.length === 1 &&
    !table.tHead.querySelector(".math") &&
    [...table.querySelectorAll("td:not(:first-child)")].some(
      (cell) => !cell.querySelector(".math") && cell.textContent.trim().length > WORDS,
    );
  const ofWords = new Set();
  for (const box of document.querySelectorAll(TABLE)) {
    const table = box.querySelector("table");
    if (!table || !isOfWords(table)) continue;
    ofWords.add(box);
    const names = labels(table);
    for (const row of table.tBodies[0].rows)
      for (const [index, cell] of [...row.cells].entries()) {
        cell.dataset.label = names[index];
        if (["", "\u2013"].includes(cell.textContent.trim())) cell.dataset.none = "";
      }
  }

  // A figure leads to its file, which opens at its own size, to be enlarged with fingers.
  const FIGURE = ".ds-figure";
  for (const image of document.querySelectorAll(".bd-article figure img")) {
    const linked = image.closest("a"); // Sphinx does where a width is given
    const [box, link] = [document.createElement("div"), linked ?? document.createElement("a")];
    box.className = FIGURE.slice(1);
    link.href = image.src;
    link.title = "Open the figure at its own size";
    const picture = image.closest("picture") ?? image; // with another one for phones
    (linked ?? picture).replaceWith(box);
    box.append(link);
    link.append(picture);
  }

  // After a search, the keyboard is where it was before.
  document.querySelector("dialog:has(#search-input)")?.addEventListener("close", () => {
    const buttons = [...document.querySelectorAll(".search-button__button, .search-button")];
    if (document.activeElement === document.body) buttons.find((button) => button.checkVisibility())?.focus();
  });

  await window.MathJax?.startup?.promise;
  // The calculator makes its own boxes, when it likes, and sees to its keyboard itself.
  const FRAME = ".cell_output .text_html:has(table.dataframe)"; // a table of pandas, as a reader gets it
  const MADE = ".lanes-table, .told-table"; // by scripts, which see to their keyboard themselves
  const boxes = document.querySelectorAll(`div.math, ${FIGURE}, ${TABLE}, ${FRAME}, ${MADE}, .bd-article pre:not(.calc pre)`);
  // A wide table or output fades where it goes on; a line above it, or above a figure, says so.
  const atEnd = (box) => box.classList.toggle("ds-at-end", box.scrollLeft + box.clientWidth > box.scrollWidth - 2);
  const HINTED = { table: `${TABLE}, ${FRAME}, ${MADE}`, figure: FIGURE, output: ".cell_output pre", code: "pre" };
  const hint = (box, wider) => {
    const what = Object.keys(HINTED).find((kind) => box.matches(HINTED[kind]));
    if (!what || box.classList.contains("ds-wider") === wider) return;
    box.classList.toggle("ds-wider", wider);
    const outside = box.closest(".cell_input") ?? box.closest("[class*='highlight-']") ?? box;
    if (!wider) return outside.previousElementSibling.remove();
    const line = document.createElement("p");
    line.className = "ds-scroll-hint";
    line.textContent = `\u2190 the ${what} scrolls sideways \u2192`;
    outside.before(line);
    box.addEventListener("scroll", () => atEnd(box), { passive: true });
    atEnd(box);
  };
  // A formula that is a little too wide is set smaller, down to this part of its size.
  const LEAST = 0.7;
  const shrink = (box) => {
    const formula = box.querySelector("mjx-container[display]");
    if (!formula) return;
    formula.style.fontSize = "";
    const part = formula.clientWidth / formula.scrollWidth;
    if (part < 1) formula.style.fontSize = `${Math.floor(100 * Math.max(LEAST, part))}%`;
  };
  // On a phone ticks and legends of a figure, 12 px high in its own size, are 10 px high; what is then only a
  // little wider than the screen is left as wide as that.
  const [DRAWN, LEGIBLE, LITTLE] = [12, 10, 1.05];
  const widen = (box) => {
    const least = (LEGIBLE / DRAWN) * box.querySelector("img").naturalWidth;
    box.firstChild.style.width = narrow.matches && least > LITTLE * box.clientWidth ? `${Math.round(least)}px` : "";
  };
  // Of many cards some are shown, and a button shows the others.
  const [SOME, MANY] = [5, 8];
  const shorten = (box) => {
    const rows = [...box.querySelectorAll("tbody tr")];
    if (rows.length <= MANY || box.dataset.unfolded) return;
    const short = box.classList.contains("ds-cards");
    for (const row of rows.slice(SOME)) row.hidden = short;
    if (box.nextElementSibling?.matches(".ds-all")) box.nextElementSibling.remove();
    if (!short) return;
    const button = document.createElement("button");
    button.type = "button";
    button.className = "ds-all";
    button.textContent = `Show all ${rows.length}`;
    const unfold = () => {
      box.dataset.unfolded = "yes";
      for (const row of rows) row.hidden = false;
      button.remove();
    };
    button.addEventListener("click", () => {
      unfold();
      rows[SOME].tabIndex = -1;
      rows[SOME].focus({ preventScroll: true });
    });
    window.addEventListener("beforeprint", unfold, { once: true });
    box.after(button);
  };
  const isWider = (box) => box.scrollWidth > box.clientWidth + 1;
  // A table that is only a little too wide for a phone is set tighter.
  const tighten = (box) => {
    box.classList.remove("ds-tight");
    if (!isWider(box)) return;
    box.classList.add("ds-tight");
    if (isWider(box)) box.classList.remove("ds-tight");
  };
  const widths = new Map();
  const observer = new ResizeObserver((changes) => {
    for (const { target: box } of changes) {
      if (widths.get(box) !== box.clientWidth) {
        widths.set(box, box.clientWidth);
        if (box.matches("div.math")) shrink(box);
        if (box.matches(FIGURE)) widen(box);
        if (ofWords.has(box)) {
          box.classList.remove("ds-cards");
          box.classList.toggle("ds-cards", narrow.matches && isWider(box));
          shorten(box);
        } else if (box.matches(TABLE)) tighten(box);
      }
      // Boxes that scroll sideways can be reached, and so scrolled, with the keyboard.
      const wider = isWider(box);
      if (wider) box.tabIndex = 0;
      else if (!box.matches(MADE)) box.removeAttribute("tabindex");
      hint(box, wider);
    }
  });
  for (const box of boxes) observer.observe(box); // also when it is unfolded
  addEventListener("ds-made", ({ detail: box }) => observer.observe(box));
});

// The page that is shown is in sight in the contents, below the links that stay at its head.
window.addEventListener("load", () => {
  const contents = document.querySelector(".bd-sidebar-primary");
  const first = contents?.querySelector(".bd-sidenav__home-link + ul");
  const shown = contents?.querySelector(".toctree-l1.active > a");
  if (!shown || !first || first.contains(shown)) return;
  const ROOM = 16;
  const { top, bottom } = shown.getBoundingClientRect();
  const above = first.getBoundingClientRect().bottom + ROOM - top;
  const below = bottom + ROOM - contents.getBoundingClientRect().bottom;
  if (above > 0) contents.scrollTop -= above;
  else if (below > 0) contents.scrollTop += below;
});

// A notebook is saved, whatever type the server gives it.
window.addEventListener("load", () => {
  for (const link of document.querySelectorAll(".btn-download-source-button")) link.download = "";
});
