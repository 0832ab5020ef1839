// Frames on the air, on the first page: the simulator's runs, played slower. Robots, tables and channels
// are the package's, from the data on the page (discostorm.book.air).
"use strict";

(() => {
  const byId = (id) => document.getElementById(`air-${id}`);
  const DATA = JSON.parse(byId("data").textContent);
  const still = document.getElementById("fig-air");
  const reduced = matchMedia("(prefers-reduced-motion: reduce)").matches;

  const TICK = 1e-7; // of the simulator's clock [s]
  const [STEPS, LOOKS] = [60, 50]; // of the simulator between two looks at the queue; looks in a share
  const PAUSE = 0.03; // the longest silence that is shown whole [s]
  const VIEW = 2; // how long a frame takes across the view [s]
  const [SHORTEST, LONGEST, SLOWEST] = [6, 40, 60]; // of a show [s]; times slower than real
  const REST = 4; // until it begins anew [s]

  const canvas = byId("canvas");
  const { resize, draw } = Lanes(canvas, DATA.queue[0]);
  const form = byId("form").elements;
  const whole = new Intl.NumberFormat("en-US");

  let run = null; // what is shown
  let asked = 0; // so that a late answer to an earlier question is dropped
  let seed = 0;
  let [time, playing, seen, last, told] = [0, !reduced, true, null, -1];

  // ---- a run: what the simulator sends share by share, with long silences cut ----

  // Return a run to show. Shares hold six numbers a transmission: start, end [ticks], station, row of the
  // table, frames, outcome; and looks at the run meanwhile, each after so many of these.
  function shown(shares, hosts, result, refused) {
    const many = shares.reduce((total, { rows }) => total + rows.length / 6, 0);
    const [start, end] = [new Float64Array(many), new Float64Array(many)];
    const [station, outcome] = [new Uint8Array(many), new Uint8Array(many)];
    const looks = { at: [], time: [], waiting: [], lost: [], done: [] };
    let [cut, last, place] = [0, 0, 0]; // silence left out, end of what was sent last [s]; transmissions
    for (const { rows, states } of shares) {
      let row = 0;
      for (const state of states) {
        for (; row < 6 * state.rows; row += 6, place++) {
          const [begin, over] = [rows[row] * TICK, rows[row + 1] * TICK];
          cut += Math.max(0, begin - last - PAUSE);
          last = Math.max(last, over);
          [start[place], end[place], station[place], outcome[place]] = [begin - cut, over - cut, rows[row + 2], rows[row + 5]];
        }
        looks.at.push(last - cut);
        for (const name of ["time", "waiting", "lost", "done"]) looks[name].push(state[name]);
      }
    }
    const length = last - cut; // [s] of the air
    const seconds = Math.min(LONGEST, Math.max(SHORTEST, length * 10), length * SLOWEST); // of the show
    return { hosts, start, end, station, outcome, looks, length, seconds, rate: length / seconds, result, refused };
  }

  const setting = (hosts, recovery) => ({
    table: form.middleware.value,
    radio: DATA.radios[Number(form.aggregation.checked)],
    recovery,
    fleet: { groups: [{ hosts, processes: DATA.processes, endpoints: DATA.endpoints }] },
    queue: DATA.queue,
    seed,
  });

  async function simulate() {
    const mine = ++asked;
    const hosts = Number(form.hosts.value);
    byId("many").textContent = hosts;
    const bar = byId("progress");
    const late = setTimeout(() => (bar.hidden = false), 300);
    try {
      const { tables } = await Live.load();
      if (mine !== asked) return;
      const { refused } = tables[form.middleware.value].recovering;
      const shares = [];
      const each = (share) => {
        shares.push(share);
        bar.value = share.done;
      };
      const options = { each, steps: STEPS, looks: LOOKS, until: "complete", log: true };
      const result = await Live.run(setting(hosts, !refused), options).found;
      if (mine !== asked) return;
      run = shown(shares, hosts, result, refused);
      again();
      paint();
      byId("sum").textContent = summary();
      if (last === null) requestAnimationFrame(frame);
    } catch (error) {
      if (mine === asked) byId("sum").textContent = `${error.message}`;
    } finally {
      clearTimeout(late);
      if (mine === asked) bar.hidden = true;
    }
  }

  // ---- words ----

  const seconds = (value) => `${value < 20 ? value.toFixed(1) : Math.round(value)} s`;
  const deliveries = (number) => `${whole.format(number)} ${number === 1 ? "delivery" : "deliveries"}`;

  function summary() {
    const { converged, drained } = run.result;
    const number = run.looks.lost.at(-1);
    const lost = (then) => (number ? `The channel and full queues lost ${deliveries(number)}${then}.` : "Nothing was lost.");
    const slower = run.length / run.seconds < 0.67 ? `${Math.round(run.seconds / run.length)} times slower than real` : "at about real speed";
    const shown = reduced ? "The whole startup is shown, without its silences." : `Shown ${slower}, with silences cut.`;
    if (run.refused) {
      const end = Number.isFinite(drained) ? `has carried the startup after ${seconds(drained)}` : "has not carried the startup yet";
      const why = run.refused.replace(/^[^:]*: /, "");
      return `The channel ${end}. ${lost(`, and nothing recovers them here: ${why}`)} ${shown}`;
    }
    if (!Number.isFinite(converged)) return `After ${seconds(run.looks.time.at(-1))} some robots still don't know each other. ${lost("")} ${shown}`;
    return `Every robot knows every other after ${seconds(converged)}. ${lost("; the middleware sent again what it needed")} ${shown}`;
  }

  function tell(place) {
    const { time: real, lost, done } = run.looks;
    const known = run.refused ? "" : `, ${Math.floor(100 * done[place])}% of the pairs of processes know each other`;
    byId("told").textContent = `${real[place].toFixed(2)} s after the start: ${deliveries(lost[place])} lost${known}.`;
  }

  // ---- drawing ----

  const theme = {};
  function readTheme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    const chosen = DATA.tables.find(({ name }) => name === form.middleware.value);
    Object.assign(theme, {
      color: color(chosen.color),
      bad: color("--ds-state-bad"),
      text: color("--ds-neutral-charcoal"),
      muted: color("--ds-page-muted"),
      lane: color("--ds-page-surface"),
      font: getComputedStyle(canvas).fontFamily,
    });
  }

  function paint() {
    if (!run) return;
    readTheme();
    picture();
  }

  function picture() {
    const to = reduced ? run.length : Math.min(run.length, time * run.rate);
    const from = reduced ? 0 : to - VIEW * run.rate;
    draw(run, from, to, theme);
    // Ten times a second is enough to read.
    if (Math.floor(time * 10) === told && !reduced) return;
    told = Math.floor(time * 10);
    const { at } = run.looks;
    let place = at.length - 1;
    while (place > 0 && at[place] > to) place--;
    tell(place);
  }

  function frame(now) {
    last ??= now;
    time += Math.min(0.1, (now - last) / 1000);
    last = now;
    if (time > run.seconds + REST) again();
    picture();
    if (playing && seen) requestAnimationFrame(frame);
    else last = null;
  }

  // ---- what the reader does ----

  function again() {
    [time, told] = [0, -1];
  }

  function play(on) {
    playing = on;
    byId("pause").textContent = on ? "Pause" : "Play";
    if (on && run && last === null) requestAnimationFrame(frame);
  }

  still?.classList.add("air-still");
  form.middleware.append(...DATA.tables.map(({ name, label }) => new Option(label, name, name === DATA.table, name === DATA.table)));
  [form.hosts.max, form.hosts.value] = [DATA.most, DATA.hosts];
  document.getElementById("air").hidden = false;
  for (const name of ["pause", "again"]) byId(name).hidden = reduced;
  resize();
  readTheme();
  byId("form").addEventListener("input", simulate);
  byId("form").addEventListener("submit", (event) => event.preventDefault());
  byId("pause").addEventListener("click", () => play(!playing));
  byId("again").addEventListener("click", () => {
    again();
    play(true);
  });
  byId("seed").addEventListener("click", () => {
    seed++;
    simulate();
  });
  let wanted = false;
  new IntersectionObserver(([{ isIntersecting }]) => {
    seen = isIntersecting;
    if (seen && !wanted) simulate(); // loads the simulator
    wanted ||= seen;
    if (seen && playing && run && last === null) requestAnimationFrame(frame);
  }).observe(canvas);
  new ResizeObserver(() => {
    resize();
    paint();
  }).observe(canvas);
  new MutationObserver(paint).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
})();
