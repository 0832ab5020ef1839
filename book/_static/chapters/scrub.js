// One start to step through, frame by frame: the simulator traces it in this browser. Starts and words are
// the package's, from the data on the page (discostorm_book.trace).
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("scrub-data").textContent);
  const figure = document.getElementById("fig-burst-scrub");
  const { make, within } = CHAPTER;
  const LOOKS = 500; // steps of the simulator between two signs of progress

  const canvas = make("canvas", { "aria-hidden": "true" });
  const lanes = LanesOfStart(canvas);
  const choice = make("select", { id: "scrub-start", autocomplete: "off" }, ...DATA.starts.map(({ label }, place) => new Option(label, place)));
  const bar = make("progress", { max: 1, hidden: "", "aria-label": "Simulating" });
  const told = make("p", { class: "line-told", role: "status" });
  const matrix = make("div", { class: "scrub-known" });
  const time = CHAPTER.slider("time", "Time", 0, 0, 1, (row) => trace && show(row), (row) => (trace ? shown(row) : ""));
  const slider = time.box.querySelector("input");
  const BUTTONS = [
    ["Previous frame", (row) => row - 1],
    ["Next frame", (row) => row + 1],
    ["Next collision", (row) => next(row, (one) => trace.failed(one))],
    ["Next loss", (row) => next(row, (one) => trace.lost(one) > trace.lost(trace.first[one] - 1))],
  ];
  const buttons = BUTTONS.map(([name, to]) => {
    const button = make("button", { type: "button" }, name);
    button.addEventListener("click", () => trace && show(to(chosen)));
    return button;
  });

  let trace = null;
  let start = null; // what it is of
  let chosen = 0; // a row
  let asked = 0; // so that a late answer to an earlier choice is dropped

  const shown = (row) => `${trace.ms(trace.get(row, "start"))}, frame ${row + 1} of ${trace.count}`;

  // Return the first row of the next exchange that is such a one, or where one is already.
  function next(row, is) {
    for (let one = trace.last[row] + 1; one < trace.count; one = trace.last[one] + 1) if (is(one)) return one;
    return row;
  }

  async function simulate() {
    const mine = ++asked;
    const wanted = DATA.starts[choice.value];
    bar.hidden = false;
    bar.removeAttribute("value");
    try {
      const tables = await Live.load();
      const rows = [];
      const each = (share) => {
        rows.push(share.rows);
        bar.value = share.done;
      };
      const result = await Live.run(wanted.setting, { each, looks: LOOKS, trace: true }).found;
      if (mine !== asked || !result) return;
      const values = new Float64Array(rows.reduce((sum, { length }) => sum + length, 0));
      rows.reduce((place, part) => (values.set(part, place), place + part.length), 0);
      trace = Trace(values, DATA.columns, wanted, { ...tables, causes: DATA.causes });
      start = wanted;
      start.most = 1;
      for (let row = 0; row < trace.count; row++) {
        for (let station = 0; station <= start.hosts; station++) start.most = Math.max(start.most, trace.waiting(row, station));
      }
      slider.max = trace.count - 1;
      makeMatrix();
      lanes.resize(start.hosts);
      show(0);
    } catch (error) {
      if (mine === asked) told.textContent = error.message;
    } finally {
      if (mine === asked) bar.hidden = true;
    }
  }

  // ---- who knows whom ----

  let cells = []; // at [reader][writer], null of the same

  function makeMatrix() {
    const robots = Array.from({ length: start.hosts }, (_, number) => number);
    const head = make("tr", {}, make("th", { scope: "col" }, "Robot"), ...robots.map((number) => make("th", { scope: "col" }, `of ${number + 1}`)));
    cells = robots.map((reader) => robots.map((writer) => (reader === writer ? null : make("td"))));
    const rows = cells.map((row, reader) => make("tr", {}, make("th", { scope: "row" }, `${reader + 1}`), ...row.map((cell) => cell ?? make("td", {}, "–"))));
    const caption = make("p", { id: "scrub-caption", class: "line-how" }, "Who knows whom: endpoint announcements that have arrived at each robot [%]");
    matrix.replaceChildren(caption, make("table", { "aria-labelledby": caption.id }, make("thead", {}, head), make("tbody", {}, ...rows)));
  }

  function fillMatrix() {
    trace.known(chosen).forEach((row, reader) =>
      row.forEach((arrived, writer) => {
        const cell = cells[reader][writer];
        if (!cell) return;
        const share = Math.floor((100 * arrived) / start.announcements);
        cell.textContent = share;
        cell.style.setProperty("--part", `${share}%`);
      }),
    );
  }

  // ---- drawing ----

  function theme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    const [bad, text, muted, lane] = ["--ds-state-bad", "--ds-neutral-charcoal", "--ds-page-muted", "--ds-page-surface"].map(color);
    return { bad, text, muted, lane, color: color(start.color) };
  }

  let waiting = false; // for the next frame of the screen
  function paint() {
    if (!trace || waiting) return;
    waiting = true;
    requestAnimationFrame(() => {
      waiting = false;
      lanes.draw(trace, chosen, start, theme());
    });
  }

  function show(row) {
    chosen = within(row, 0, trace.count - 1);
    time.set(chosen);
    const is = make("strong", {}, `${trace.what(chosen)} ${trace.outcome(chosen)}`);
    told.replaceChildren(is, ` ${trace.why(chosen)} `, make("span", {}, trace.state(chosen)));
    fillMatrix();
    paint();
  }

  // ---- what the reader does ----

  function pointed(event) {
    const row = trace ? lanes.at(trace, event) : -1;
    if (row < 0) return;
    show(row);
    slider.focus({ preventScroll: true }); // arrow keys go on from here
  }
  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !trace) return;
    if (lanes.isBelow(event)) canvas.setPointerCapture(event.pointerId);
    event.preventDefault();
    pointed(event);
  });
  canvas.addEventListener("pointermove", (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) pointed(event);
  });
  choice.addEventListener("input", simulate);

  figure.classList.add("scrub-live");
  figure.style.setProperty("--color", `var(${DATA.starts[0].color})`);
  const form = make("div", { class: "scrub-form" }, make("label", { for: choice.id }, "Start:"), choice, bar);
  const HOW = [
    "Move through time, or click a frame in a lane. Arrow keys step frame by frame.",
    "Blue frames come from robots, gray ones from the access point, and red ones collide. Gray areas show how many frames wait, in red where the queue is full.",
    "Of the chosen frame, the dashed line is the time in its queue, the solid line the wait for the channel.",
  ];
  const how = make("p", { class: "line-how" }, HOW.join(" "));
  const group = make("div", { class: "line-controls scrub", role: "group", "aria-label": "Step through a start" });
  group.append(form, canvas, how, time.box, make("div", { class: "scrub-buttons" }, ...buttons), told, matrix);
  figure.querySelector("figcaption").before(group);

  let wanted = false; // once it has been in sight
  new IntersectionObserver(([{ isIntersecting }], observer) => {
    if (!isIntersecting || wanted) return;
    wanted = true;
    observer.disconnect();
    simulate(); // loads the simulator
  }).observe(group);
  new ResizeObserver(() => {
    if (!trace) return;
    lanes.resize(start.hosts);
    paint();
  }).observe(canvas.parentElement);
  new MutationObserver(paint).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
})();
