// Ten starts of the reader's own, simulated in this browser, among the quartiles of the stored ones. Where
// the panels are and what was stored comes from the package, in the data on the page (discostorm_book.interactive).
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("own-data").textContent);
  const figure = document.getElementById("fig-converge-own");
  const { make, put } = CHAPTER;
  const { runs: RUNS, setting, never: NEVER } = DATA;
  const STEPS = 20_000; // of the simulator between two signs of progress
  const [begin, robots] = DATA.begin;
  const HOSTS = DATA.middleware[begin].stored.map(([hosts]) => hosts);

  const { picture, panels } = CHAPTER.over(figure, DATA);
  const middleware = make("select", { id: "own-middleware", autocomplete: "off" }, ...DATA.middleware.map(({ name }, place) => new Option(name, place)));
  middleware.value = begin;
  const button = make("button", { type: "button" });
  const bar = make("progress", { max: RUNS, hidden: "", "aria-label": "Simulating" });
  const slider = CHAPTER.slider("robots", "Robots", 0, HOSTS.length - 1, 1, (place) => choose(place), (place) => String(HOSTS[place]));
  const told = CHAPTER.controls(figure, "Run ten starts of your own", "Each dot is one of your runs. The bars are the chapter’s.", [slider]);
  told.before(make("div", { class: "own-form" }, make("label", { for: middleware.id }, "Middleware:"), middleware, button, bar));

  let place = HOSTS.indexOf(robots); // of the robots chosen
  let seed = 0; // of the runs
  let current = null; // the run under way
  let asked = 0; // so that nothing of an earlier choice is shown
  let dots = [];

  // ---- what is said ----

  const WORDS = ["none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
  const word = (number) => WORDS[number] ?? String(number);
  const seconds = (value) => (value < 0.95 ? `${value.toFixed(2)} s` : value < 99.5 ? `${value.toFixed(1)} s` : `${value.toFixed(0)} s`);
  const timely = (value) => (Number.isFinite(value ?? Infinity) ? seconds(value) : `over ${setting.until} s`);
  // Of an even number of runs the upper of the two, as in the sweep.
  const middle = (values) => [...values].sort((one, other) => one - other)[values.length >> 1];

  function said(found) {
    const { name, stored } = DATA.middleware[middleware.value];
    const [hosts, , median, , converged] = stored[place];
    const good = found.filter(Number.isFinite).length;
    const mine = `${hosts} robots with ${name}, random seed ${seed}: ${word(good)} of ${word(found.length)} starts converged within ${setting.until / 60} minutes, in a median of ${timely(middle(found))}.`;
    const text = good ? mine : mine.replace(/, in a median of .*/, ".");
    const theirs = converged ? `${word(converged)} of ${word(RUNS)} converged, in a median of ${timely(median)}` : `${word(converged)} of ${word(RUNS)} converged`;
    return `${text} Of the chapter’s stored runs, ${theirs}.`;
  }

  // ---- what is drawn ----

  function clear() {
    for (const dot of dots) dot.remove();
    dots = [];
  }

  // On a phone the figure scrolls sideways: its panel has to be in sight.
  function inSight({ left, right }) {
    const box = picture.parentElement;
    const [begin, end] = [left, right].map((at) => (at / DATA.size[0]) * picture.clientWidth);
    if (begin < box.scrollLeft || end > box.scrollLeft + box.clientWidth) box.scrollLeft = begin - 48;
  }

  function draw(converged, run) {
    const dot = make("circle", { class: "line-end own-dot", r: 3.2, "data-seconds": converged });
    const panel = panels[middleware.value];
    const beside = RUNS > 1 ? (run / (RUNS - 1) - 0.5) * 0.8 : 0;
    put(dot, panel.place(HOSTS[place] + beside, Number.isFinite(converged) ? Math.log10(converged) : NEVER));
    dots.push(dot);
    picture.append(dot);
  }

  // ---- what the reader does ----

  function busy(on) {
    button.textContent = on ? "Stop" : `Run ${word(RUNS)} starts`;
    bar.hidden = !on;
    bar.value = 0;
  }

  async function simulate() {
    const mine = ++asked;
    seed++;
    clear();
    busy(true);
    inSight(panels[middleware.value]);
    told.textContent = "";
    const { name } = DATA.middleware[middleware.value];
    const fleet = { groups: [{ hosts: HOSTS[place], processes: DATA.processes, endpoints: DATA.endpoints }] };
    const found = [];
    try {
      await Live.load();
      while (found.length < RUNS && mine === asked) {
        const each = ({ done, time }) => (bar.value = found.length + Math.min(1, Math.max(done / 2, time / setting.until)));
        current = Live.run({ ...setting, table: name, fleet, seed, run: found.length }, { each, steps: STEPS, until: "complete" });
        const result = await current.found;
        if (mine !== asked || !result) break;
        draw(result.converged, found.length);
        found.push(result.converged);
      }
      if (mine === asked && found.length) told.textContent = said(found);
    } catch (error) {
      if (mine === asked) told.textContent = error.message;
    } finally {
      if (mine === asked) stop();
    }
  }

  function stop() {
    asked++;
    current?.stop();
    current = null;
    busy(false);
  }

  function choose(robots) {
    place = robots;
    slider.set(place);
    if (!bar.hidden || dots.length) {
      stop();
      clear();
    }
    told.textContent = "";
  }

  button.addEventListener("click", () => (bar.hidden ? simulate() : stop()));
  middleware.addEventListener("input", () => choose(place));
  busy(false);
  choose(place);
})();
