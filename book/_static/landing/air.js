// The simulator's runs on the first page, played slower. Robots, tables and channels
// are the package's, from the data on the page (discostorm_book.landing).
"use strict";

(() => {
  const byId = (id) => document.getElementById(`air-${id}`);
  const DATA = JSON.parse(byId("data").textContent);
  const still = document.getElementById("fig-air");
  const reduced = matchMedia("(prefers-reduced-motion: reduce)").matches;

  const [STEPS, LOOKS] = [60, 50]; // of the simulator between two looks at the queue; looks in a share
  // Until a frame crossed the view, a moment is held, goes on, and the show begins anew [s].
  const [VIEW, LEAD, HOLD, REST] = [2, 0.7, 4, 4];
  const FULL = 0.97; // of the queue

  // The lanes of one middleware, and of another to compare it with, on the same clock.
  const sets = ["", "-2"].map((end) => {
    const [box, name, canvas, told] = ["set", "name", "canvas", "told"].map((part) => byId(`${part}${end}`));
    return { box, name, canvas, told, ...Lanes(canvas, DATA.queue[0]) };
  });
  const [{ canvas }] = sets;
  const form = byId("form").elements;
  const marked = [...byId("moments").querySelectorAll("button")];
  const numbers = new Intl.NumberFormat("en-US");

  let stages = []; // runs and their clock: what was asked for; then it beside the same robots behind a server
  let [stage, runs, clock] = [0, [], null]; // what is shown
  let asked = 0; // so that a late answer to an earlier question is dropped
  let seed = 0;
  let [time, playing, seen, last, told] = [0, !reduced, true, null, -1];
  let [moments, next, held] = [[], 0, 0]; // of a single run; the next, and how long one is still held [s]
  let [slow, pending, skipping, skipped, finished] = Array(5).fill(false);

  // ---- runs ----

  const tables = new Map([...DATA.tables, ...Object.values(DATA.behind)].map((table) => [table.name, table]));
  const labelOf = ({ table }) => tables.get(table).label;
  const setting = (table, hosts) => ({
    table,
    radio: DATA.radios[Number(form.aggregation.checked)],
    fleet: { groups: [{ hosts, processes: DATA.processes, endpoints: DATA.endpoints }] },
    queue: DATA.queue,
    seed,
  });

  // Return what the simulator makes of a table, null if it was stopped.
  async function simulated(table, hosts, progress) {
    const shares = [];
    const each = (share) => {
      shares.push(share);
      progress(share.done);
    };
    const options = { each, steps: STEPS, looks: LOOKS, until: "complete", log: true };
    const result = await Live.run(setting(table, hosts), options).found;
    return result && { ...Show.collected(shares), table, hosts, result };
  }

  async function simulate() {
    const mine = ++asked;
    [pending, skipping] = [true, false];
    const hosts = Number(form.hosts.value);
    const wanted = form.compare.checked ? [form.middleware.value, form.other.value] : [form.middleware.value];
    const bar = byId("progress");
    const late = setTimeout(() => (bar.hidden = false), 300);
    try {
      const found = [];
      for (const table of wanted) {
        const run = await simulated(table, hosts, (done) => (bar.value = (found.length + done) / wanted.length));
        if (mine !== asked) return;
        found.push(run);
      }
      pending = false;
      show(found);
      const server = found.length === 1 && found[0] && DATA.behind[found[0].table];
      const served = server && (await simulated(server.name, hosts, () => {}));
      if (mine !== asked || !served) return;
      stages.push(staged([found[0], served]));
      marked.at(-1).disabled = false;
    } catch (error) {
      if (mine === asked) byId("sum").textContent = `${error.message}`;
    } finally {
      clearTimeout(late);
      if (mine === asked) [bar.hidden, pending] = [true, false];
    }
  }

  function staged(found) {
    const { runs, ...clock } = Show.together(found);
    for (const run of runs) run.ended = ending(run);
    const seconds = Show.seconds(clock.length, slow);
    return { runs, clock: { ...clock, seconds, rate: clock.length / seconds } };
  }

  function show(found) {
    stages = [staged(found)];
    const [{ runs, clock }] = stages;
    const several = runs.length > 1;
    moments = several ? [] : Show.moments(runs[0], clock.silences, FULL * DATA.queue[0]);
    byId("moments").hidden = several;
    marked.forEach((button, i) => (button.disabled = !moments[i]));
    // The lanes take the place of the still picture, which stays until there is something to see.
    still?.classList.add("air-still");
    byId("sets").hidden = false;
    finished = false;
    again();
    paint();
    byId("sum").replaceChildren(how());
    if (reduced || skipping) end();
    else if (skipped) play(true);
    if (!skipping) skipped = false;
    if (last === null) requestAnimationFrame(frame);
  }

  // Show one of the stages.
  function enter(number) {
    stage = number;
    ({ runs, clock } = stages[stage]);
    const several = runs.length > 1;
    byId("sets").classList.toggle("air-compared", several && !stage);
    byId("sets").classList.toggle("air-last", stage > 0);
    sets.forEach(({ box, name, told, resize }, i) => {
      box.hidden = !runs[i];
      told.hidden = !runs[i] || stage + i > 1; // of the last picture one line tells
      byId("legend").style.setProperty(`--color${i}`, runs[i] ? `var(${colorOf(runs[i])})` : "");
      if (!runs[i]) return;
      name.hidden = !several;
      name.textContent = labelOf(runs[i]);
      name.style.setProperty("--color", `var(${colorOf(runs[i])})`);
      resize();
    });
    readTheme();
    if (stage) [time, told, next, held] = [clock.seconds, -1, moments.length, 0];
    if (finished) byId("sum").replaceChildren(...summaries());
  }

  // ---- words ----

  const seconds = (value) => `${value < 20 ? value.toFixed(1) : Math.round(value)} s`;
  const deliveries = (number) => `${numbers.format(number)} ${number === 1 ? "delivery" : "deliveries"}`;

  function ending({ looks, result: { converged } }) {
    if (Number.isFinite(converged)) return `discovery complete after ${seconds(converged)}`;
    return `discovery not complete after ${seconds(looks.time.at(-1))}`;
  }

  function summary({ table, looks, result: { converged, lost: share } }) {
    const number = looks.lost.at(-1);
    // Why a run of this table that loses many may be wrong.
    const [caution = ""] = Object.entries(share > DATA.few_lost ? DATA.cautions : {}).find(([, names]) => names.includes(table)) ?? [];
    const lost = (then) => (number ? `The channel and full queues lost ${deliveries(number)}${then}. ${caution}` : "Nothing was lost.");
    if (!Number.isFinite(converged)) return `After ${seconds(looks.time.at(-1))} some robots still don't know each other. ${lost("")}`;
    return `Every robot knows every other after ${seconds(converged)}. ${lost("; the middleware sent again what it needed")}`;
  }

  // Return how the runs are shown. How they end is told when they have ended.
  function how() {
    const slower = clock.rate < 0.67 ? `${Math.round(1 / clock.rate)} times slower than real` : "at about real speed";
    const cut = reduced ? "The whole startup is shown, without its silences." : `Shown ${slower}, with silences cut.`;
    return Show.paragraph(runs.length === 1 ? cut : `${cut} Traffic after the end of a startup is not shown.`);
  }

  // Return a paragraph a run, and how they are shown.
  function summaries() {
    if (runs.length === 1) return [Show.paragraph(`${summary(runs[0])} `, ...how().childNodes)];
    const name = (text) => Object.assign(document.createElement("b"), { textContent: text });
    const each = runs.map((run) => Show.paragraph(name(`${labelOf(run)}.`), ` ${summary(run)}`));
    return stage ? each : [...each, how()];
  }

  function tell(run, to) {
    if (stage) return "Both whole startups, on one clock, without silences.";
    const { at, lost, done } = run.looks;
    let place = at.length - 1;
    while (place > 0 && at[place] > to) place--;
    const known = `, ${Math.floor(100 * done[place])}% of process pairs have discovered each other`;
    const which = runs.length > 1 ? `${labelOf(run)}, ` : "";
    const when = runs.length > 1 && to >= run.length ? run.ended : `${clock.real(to).toFixed(2)} s after the start`;
    return `${which}${when}: ${deliveries(lost[place])} lost${known}.`;
  }

  // ---- drawing ----

  const theme = {};
  const colorOf = ({ table }) => tables.get(table).color;
  function readTheme() {
    const style = getComputedStyle(document.documentElement);
    runs.forEach((run) => (run.color = style.getPropertyValue(colorOf(run)).trim()));
    Object.assign(theme, sets[0].theme());
  }

  function paint() {
    if (!clock) return;
    readTheme();
    picture();
  }

  function picture() {
    const whole = stage || (reduced && time >= clock.seconds);
    const to = Math.min(clock.length, time * clock.rate);
    const from = whole ? 0 : to - VIEW * clock.rate;
    runs.forEach((run, i) => sets[i].draw(run, from, to, theme, stage ? [] : moments));
    // Ten times a second is enough.
    if (Math.floor(time * 10) === told) return;
    told = Math.floor(time * 10);
    runs.forEach((run, i) => (sets[i].told.textContent = tell(run, to)));
    const past = whole ? -1 : moments.findLastIndex((one, i) => one && heldAt(i) <= time);
    const now = stage ? marked.length - 1 : past;
    marked.forEach((button, i) => button.setAttribute("aria-pressed", i === now));
  }

  const heldAt = (i) => Math.min(clock.seconds, moments[i] ? moments[i].time / clock.rate + LEAD : 0);

  function frame(now) {
    last ??= now;
    const passed = Math.min(0.1, (now - last) / 1000);
    last = now;
    if (held > passed) held -= passed;
    else [time, held] = [time + passed, 0];
    while (next < moments.length && heldAt(next) <= time) {
      // The end is held anyway.
      if (moments[next] && next < moments.length - 1) [time, told, held] = [heldAt(next), -1, HOLD];
      next++;
      if (held) break;
    }
    if (time >= clock.seconds) finish();
    if (time > clock.seconds + (1 + stage) * REST) {
      if (stages[stage + 1]) enter(stage + 1);
      else again();
    }
    picture();
    if (playing && seen) requestAnimationFrame(frame);
    else last = null;
  }

  // ---- what the reader does ----

  function again() {
    if (stages.length) enter(0);
    [time, told, next, held] = [0, -1, 0, 0];
  }

  // Stand still at a moment.
  function stopAt(i) {
    play(false);
    if (i === moments.length) finish();
    enter(Number(i === moments.length));
    if (!stage) [time, told, next, held] = [heldAt(i), -1, i + 1, 0];
    if (i === moments.length - 1) finish();
    picture();
  }

  // The show is over: tell how the runs ended, once.
  function finish() {
    if (finished) return;
    finished = true;
    byId("sum").replaceChildren(...summaries());
  }

  function end() {
    enter(0);
    [time, told, skipped, next, held] = [clock.seconds, -1, true, moments.length, 0];
    play(false);
    finish();
    picture();
  }

  function play(on) {
    playing = on;
    byId("pause").textContent = on ? "Pause" : "Play";
    if (on && clock && last === null) requestAnimationFrame(frame);
  }

  // What was chosen is in the address, and comes from there.
  function remember() {
    const on = ({ checked }, value) => (checked ? value : null);
    Address.write({
      robots: form.hosts.value,
      middleware: form.middleware.value,
      compare: on(form.compare, form.other.value),
      aggregation: on(form.aggregation, 1),
      seed: seed || null,
    });
  }

  const offered = (table) => DATA.tables.some(({ name }) => name === table);

  function restore() {
    const number = (name, least, most, otherwise) => {
      const value = Number(Address.get(name) ?? NaN);
      return Number.isInteger(value) && value >= least && value <= most ? value : otherwise;
    };
    const table = (name, otherwise) => (offered(Address.get(name)) ? Address.get(name) : otherwise);
    form.hosts.value = number("robots", Number(form.hosts.min), DATA.most, DATA.hosts);
    form.middleware.value = table("middleware", DATA.table);
    form.other.value = table("compare", DATA.other);
    form.compare.checked = offered(Address.get("compare"));
    form.aggregation.checked = Address.get("aggregation") === "1";
    seed = number("seed", 0, Number.MAX_SAFE_INTEGER - 1, 0);
    choose();
  }

  function choose() {
    byId("other").hidden = !form.compare.checked;
    byId("many").textContent = form.hosts.value;
    if (wanted) simulate();
  }

  let wanted = false; // once the picture has been in sight
  byId("sets").hidden = true;
  for (const list of [form.middleware, form.other]) list.append(...DATA.tables.map(({ name, label }) => new Option(label, name)));
  form.hosts.max = DATA.most;
  document.getElementById("air").hidden = false;
  for (const name of ["pause", "again", "slow"]) byId(name).hidden = reduced;
  if (reduced) byId("skip").textContent = "The whole startup";
  marked.forEach((button, i) => button.addEventListener("click", () => stopAt(i)));
  Address.follow(restore);
  byId("form").addEventListener("input", () => {
    slow = false;
    remember();
    choose();
  });
  byId("form").addEventListener("submit", (event) => event.preventDefault());
  byId("pause").addEventListener("click", () => play(!playing));
  byId("again").addEventListener("click", () => {
    again();
    play(true);
  });
  byId("skip").addEventListener("click", () => {
    skipping = pending;
    if (!pending && clock) end();
  });
  byId("slow").addEventListener("click", () => {
    form.hosts.value = form.hosts.min;
    [slow, skipped, playing] = [true, true, false];
    remember();
    choose();
  });
  byId("seed").addEventListener("click", () => {
    seed++;
    remember();
    choose();
  });
  const observer = new IntersectionObserver((entries) => {
    const lanes = entries.find(({ target }) => target === byId("sets"));
    if (lanes) seen = lanes.isIntersecting;
    if (!wanted && entries.some(({ isIntersecting }) => isIntersecting)) {
      wanted = true;
      simulate(); // loads the simulator
    }
    if (seen && playing && clock && last === null) requestAnimationFrame(frame);
  });
  for (const element of [still, document.getElementById("air"), byId("sets")]) if (element) observer.observe(element);
  const sized = new ResizeObserver(() => {
    for (const { resize } of sets) resize();
    paint();
  });
  for (const { canvas } of sets) sized.observe(canvas);
  new MutationObserver(paint).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
})();
