// Something to move: dials, and bars that say what follows. For each setting of the dials the values are the
// package's, in the data on the page (discostorm_book.interactive).
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("choose-data").textContent);
  const { make, slider } = CHAPTER;
  const cell = document.getElementById("choose-data").closest(".cell");
  const state = DATA.dials.map(({ start }) => start);

  const shown = (value) => (value === null ? "never" : `${value.toLocaleString("en-US", value < 9.95 ? { maximumSignificantDigits: value < 0.995 ? 2 : 3 } : { maximumFractionDigits: 0 })}${DATA.unit}`);
  const at = ({ values }) => values[state.reduce((place, one, i) => place * DATA.dials[i].values.length + one, 0)];

  // A dial with the values no and yes is a box to tick.
  const dials = DATA.dials.map(({ label, values }, i) => {
    if (values.join() !== "no,yes") return slider(`choose-${i}`, label, 0, values.length - 1, 1, (one) => show(i, one), (one) => values[one]);
    const input = make("input", { type: "checkbox", autocomplete: "off" });
    input.addEventListener("change", () => show(i, Number(input.checked)));
    return { set: (one) => (input.checked = one > 0), box: make("div", {}, make("label", { class: "choose-box" }, input, ` ${label}`)) };
  });
  const rows = DATA.bars.map(({ name, color }) => {
    const [fill, value] = [make("span", { class: "choose-fill" }), make("span", { class: "choose-value" })];
    fill.style.setProperty("--color", `var(${color})`);
    return { fill, value, row: make("div", { class: "choose-bar" }, make("span", {}, name), make("span", { class: "choose-track" }, fill), value) };
  });
  const bars = make("div", { class: "choose-bars", role: "status" }, ...rows.map(({ row }) => row));
  if (DATA.limit) {
    bars.style.setProperty("--limit", DATA.limit / DATA.most);
    bars.classList.add("choose-limited");
  }
  const lead = make("p", { class: "line-how" }, make("strong", {}, DATA.title), ` ${DATA.lead}`);
  const box = make("div", { class: "line-controls choose", role: "group", "aria-label": DATA.title }, lead, ...dials.map(({ box }) => box), bars);

  function show(i, one) {
    state[i] = one;
    dials[i].set(one);
    rows.forEach(({ fill, value }, row) => {
      const found = at(DATA.bars[row]);
      fill.style.width = `${100 * Math.min(1, (found ?? Infinity) / DATA.most)}%`;
      fill.classList.toggle("choose-over", found === null || found > DATA.most);
      value.textContent = shown(found);
    });
  }

  cell.after(box);
  state.forEach((one, i) => show(i, one));
})();
