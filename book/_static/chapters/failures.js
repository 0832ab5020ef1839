// Kill a server, router or hub, and see who hears whom from then on: one run of the lab at a time.
// When who lost whom and heard them again was measured, and is in the data on the page
// (discostorm_book.failure_runs); what is here runs the clock, draws the moment and says it.
"use strict";

(() => {
  const CASES = JSON.parse(document.getElementById("failures-data").textContent);
  const figure = document.getElementById("fig-deaths");
  const { make, within } = CHAPTER;
  const BEFORE = -5; // s: the clock begins before the failure
  const SHOW = 20; // s that a run takes on the page
  const ALIKE = 0.1; // s within which times are told as one
  const still = matchMedia("(prefers-reduced-motion: reduce)");
  const state = { of: CASES[0], staging: CASES[0].stagings[0], run: 0, time: BEFORE, playing: false };

  // ---- what was measured: the state of a relation, and the events of a run ----

  const isLate = ([one]) => one === "newcomer" || one === "beside";
  const spans = () => state.staging.runs[state.run];
  function hears(relation, span, time) {
    if (isLate(relation) && time < state.staging.joins) return "absent";
    return span && time >= span[0] && time < (span[1] ?? Infinity) ? "not" : "hear";
  }
  const upper = (text) => text[0].toUpperCase() + text.slice(1);
  const listed = (names) => names.map((name, place) => (place ? name[0].toLowerCase() + name.slice(1) : name)).join("; ");

  function events() {
    const { of: it, staging } = state;
    const late = it.relations.some(([one]) => one === "beside") ? "Two late joiners start." : "A late joiner starts.";
    const found = [
      { time: 0, text: `${upper(it.victim)} is killed.` },
      { time: staging.back, text: `${upper(it.victim)} is back.` },
      { time: staging.joins, text: late },
    ];
    const add = (time, verb, name) => {
      const same = found.find((event) => event.verb === verb && Math.abs(event.time - time) < ALIKE);
      if (same) return same.names.push(name);
      found.push({ time, verb, names: [name] });
    };
    for (const [place, relation] of it.relations.entries()) {
      const [name, span] = [relation[2], spans()[place]];
      if (!span) continue;
      if (!isLate(relation)) add(span[0], "no longer all hear each other", name);
      if (span[1] !== null) add(span[1], isLate(relation) ? "hear each other" : "hear each other again", name);
      else add(staging.end, `have not heard each other in ${(staging.end - span[0]).toFixed(0)} s`, name);
    }
    found.sort((a, b) => a.time - b.time);
    return found.map(({ time, text, verb, names }) => ({ time, text: text ?? `${listed(names)} ${verb}.` }));
  }

  // What all runs of a staging have in common, in words: who fared alike is named together.
  function summary() {
    const { of: it, staging } = state;
    const runs = staging.runs.length;
    const fates = new Map();
    for (const [place, relation] of it.relations.entries()) {
      const fate = fared(relation, staging.runs.map((run) => run[place]).filter(Boolean), runs);
      fates.set(fate, [...(fates.get(fate) ?? []), relation[2]]);
    }
    const together = it.relations.some(([one]) => one === "beside") && staging.joins < staging.back;
    const note = together ? ["After the return, the two late joiners were timed together."] : [];
    return [...[...fates].map(([fate, names]) => `${listed(names)}: ${fate}.`), ...note];
  }
  function fared(relation, lost, runs) {
    if (!lost.length) return `not disturbed in ${runs} of ${runs} runs`;
    const { of: it, staging } = state;
    const ended = lost.filter(([, end]) => end !== null);
    const count = `hear each other${isLate(relation) ? "" : " again"} in ${ended.length} of ${runs} runs`;
    if (!ended.length) return count;
    const isBack = ended.every(([begin, end]) => begin < staging.back && end > staging.back);
    const after = ended.map(([begin, end]) => end - (isBack ? staging.back : begin));
    const [least, most] = [Math.min(...after), Math.max(...after)].map((time) => time.toFixed(1));
    const since = isBack ? `${it.victim} is back` : isLate(relation) ? "the start" : "the failure";
    return `${count}, ${least === most ? least : `${least} to ${most}`} s after ${since}`;
  }

  // ---- the robots, and lines between those who hear each other ----

  const PLACES = {
    one: { survivors: [[62, 78], [298, 78], [282, 176], [78, 176]], newcomer: [[180, 202]], server: [180, 30] },
    each: { orphans: [[52, 66], [52, 122]], beside: [[52, 178]], survivors: [[200, 40], [310, 84], [310, 160]], newcomer: [[200, 198]], server: [92, 122] },
  };
  PLACES.hub = PLACES.each;
  const NUMBERS = { one: { survivors: [1, 2, 3, 4] }, each: { orphans: [1, 1], survivors: [2, 3, 4] } };
  NUMBERS.hub = NUMBERS.each;
  const scene = make("svg", { class: "failures-scene", viewBox: "0 0 360 224", "aria-hidden": "true" });
  let parts = [];

  const square = ([x, y], half) => make("rect", { x: x - half, y: y - half, width: 2 * half, height: 2 * half, rx: 4 });
  function put() {
    const { of: it } = state;
    const places = PLACES[it.routers];
    parts = [];
    const links = it.relations.flatMap((relation, place) => {
      const [one, other] = relation;
      const pairs = places[one].flatMap((a, i) => places[other].filter((_, j) => one !== other || j > i).map((b) => [a, b]));
      return pairs.map(([a, b]) => {
        const link = make("path", { d: `M${a}L${b}` });
        parts.push(() => link.setAttribute("class", `failures-link failures-${hears(relation, spans()[place], state.time)}`));
        return link;
      });
    });
    const robots = Object.entries(places).flatMap(([group, spots]) => {
      if (group === "server") return [];
      const late = isLate([group]);
      return spots.map(([x, y], place) => {
        const label = make("text", { x, y: y + 5 }, late ? "late" : NUMBERS[it.routers][group][place]);
        const robot = make("g", {}, make("circle", { cx: x, cy: y, r: 17 }), label);
        parts.push(() => robot.setAttribute("class", `failures-robot${late && state.time < state.staging.joins ? " failures-absent" : ""}`));
        return robot;
      });
    });
    const [x, y] = places.server;
    const half = it.routers === "each" ? 9 : 15;
    const cross = make("path", { d: `M${x - half} ${y - half}l${2 * half} ${2 * half}m0 ${-2 * half}l${-2 * half} ${2 * half}` });
    const server = make("g", {}, square([x, y], half), cross);
    parts.push(() => server.setAttribute("class", `failures-server${isDown() ? " failures-down" : ""}`));
    const own = it.routers === "each" ? [...places.survivors, ...places.newcomer].map(([a, b]) => square([a + 22, b - 14], 6)) : [];
    const frame = it.routers === "one" ? [] : [make("rect", { class: "failures-frame", x: 24, y: 28, width: 68, height: 178, rx: 8 }), make("text", { x: 58, y: 20 }, "robot 1")];
    const named = make("text", { x: it.routers === "one" ? x : x + half + 4, y: it.routers === "one" ? y - half - 3 : y + half + 14, class: it.routers === "one" ? "" : "failures-beside" }, it.routers === "hub" ? "hub" : it.routers === "one" ? it.victim.split(" ").at(-1) : "router");
    scene.replaceChildren(...frame, ...links, make("g", { class: "failures-server" }, ...own), server, ...robots, named);
  }
  const isDown = () => state.time >= 0 && state.time < state.staging.back;

  // ---- lanes, as in the figure ----

  const lanes = make("div", { class: "failures-lanes", "aria-hidden": "true" });
  const cursor = make("div", { class: "failures-cursor" });
  function lay() {
    const { of: it, staging } = state;
    const part = (time) => `${(100 * (within(time, BEFORE, staging.end) - BEFORE)) / (staging.end - BEFORE)}%`;
    const bar = (kind, from, to) => {
      const piece = make("div", { class: `failures-bar failures-${kind}` });
      piece.style.left = part(from);
      piece.style.width = `calc(${part(to)} - ${part(from)})`;
      return piece;
    };
    const rows = it.relations.map((relation, place) => {
      const span = spans()[place];
      const [from, to] = [isLate(relation) ? staging.joins : BEFORE, staging.end];
      const [begin, end] = span ? [span[0], span[1] ?? to] : [to, to];
      const pieces = [bar("hear", from, begin), bar("not", begin, end), bar("hear", end, to)];
      return make("div", { class: "failures-lane" }, make("span", {}, relation[2]), make("div", { class: "failures-track" }, ...pieces));
    });
    const marks = [0, staging.back].map((time) => {
      const mark = make("div", { class: "failures-mark" });
      mark.style.left = part(time);
      return mark;
    });
    lanes.replaceChildren(...rows, make("div", { class: "failures-over" }, ...marks, cursor));
    lanes.move = () => {
      cursor.style.left = part(state.time);
    };
  }

  // ---- what is chosen, and the clock ----

  const list = make("ol", { class: "failures-events" });
  const whole = make("ul", { class: "failures-whole", "aria-label": "All runs" });
  const kill = make("button", { type: "button", class: "failures-kill" });
  const next = make("button", { type: "button" }, "Next event");
  const all = make("button", { type: "button", "aria-expanded": "false" });
  const choice = make("fieldset", { class: "failures-choice" }, make("legend", {}, "Configuration"));
  for (const it of CASES) {
    const input = make("input", { type: "radio", name: "failures-case", autocomplete: "off" });
    input.checked = it === state.of;
    input.addEventListener("change", () => stage({ of: it, staging: it.stagings[0], run: 0 }));
    choice.append(make("label", {}, input, ` ${it.title}`));
  }
  const select = make("select", { id: "failures-staging", autocomplete: "off" });
  select.addEventListener("change", () => stage({ staging: state.of.stagings[select.selectedIndex], run: 0 }));
  const outage = make("div", {}, make("label", { for: select.id }, "Outage: "), select);
  const runs = CHAPTER.slider("run", "Run of the lab", 1, 1, 1, (run) => stage({ run: run - 1 }), (run) => `${run} of ${state.staging.runs.length}`);
  const clock = CHAPTER.slider("time", "Time since the failure", BEFORE, 1, 0.1, (time) => go(time), (time) => `${time.toFixed(1)} s`);
  const told = CHAPTER.controls(figure, "Kill a server or router", "Measured, one run at a time. Kill the server, or move the clock.", [runs, clock]);
  const group = told.parentElement;
  let steps = [];
  let before = -2; // which event was last, when it was last told

  function stage(changed) {
    Object.assign(state, changed, { time: BEFORE, playing: false });
    const { of: it, staging } = state;
    const input = (slider) => slider.box.querySelector("input");
    const named = ({ back, joins }) => make("option", {}, `${back} s; late joiner starts at ${joins} s`);
    select.replaceChildren(...it.stagings.map(named));
    select.selectedIndex = it.stagings.indexOf(staging);
    input(runs).max = staging.runs.length;
    runs.set(state.run + 1);
    input(clock).max = staging.end;
    steps = events();
    list.replaceChildren(...steps.map(({ time, text }) => make("li", {}, make("b", {}, `${time.toFixed(1)} s`), ` ${text}`)));
    whole.replaceChildren(...summary().map((text) => make("li", {}, text)));
    put();
    lay();
    before = -2;
    show();
  }

  const last = () => steps.findLastIndex(({ time }) => time <= state.time + 1e-9);
  function show() {
    const { of: it, staging, time } = state;
    clock.set(time);
    lanes.move();
    kill.textContent = state.playing ? "Pause" : time >= staging.end ? "Start again" : time < 0 ? `Kill ${it.victim}` : "Continue";
    next.disabled = last() >= steps.length - 1;
    const now = last();
    if (now === before) return; // only what has changed is drawn and said
    before = now;
    for (const part of parts) part();
    for (const [place, item] of [...list.children].entries()) item.className = place > now ? "failures-later" : place === now ? "failures-now" : "";
    const deaf = it.relations.filter((relation, place) => hears(relation, spans()[place], time) === "not").map(([, , name]) => name);
    const who = deaf.length ? `Not hearing each other: ${listed(deaf)}.` : "All running robots hear each other.";
    told.textContent = now < 0 ? `Before the failure. ${who}` : `${steps[now].time.toFixed(1)} s: ${steps[now].text} ${who}`;
  }

  function go(time, playing = false) {
    Object.assign(state, { time, playing });
    show();
  }
  function run() {
    const speed = (state.staging.end - BEFORE) / SHOW / 1000;
    let then = performance.now();
    const tick = (now) => {
      if (!state.playing) return;
      const time = Math.min(state.staging.end, state.time + (now - then) * speed);
      then = now;
      go(time, time < state.staging.end);
      if (state.playing) requestAnimationFrame(tick);
    };
    requestAnimationFrame(tick);
  }
  kill.addEventListener("click", () => {
    if (state.playing) return go(state.time);
    if (state.time >= state.staging.end) return go(BEFORE);
    const playing = !still.matches; // else the reader goes from event to event
    go(state.time < 0 ? 0 : state.time, playing);
    if (playing) run();
    else if (state.time > 0) next.click();
  });
  next.addEventListener("click", () => {
    const step = steps.find(({ time }) => time > state.time + 1e-9);
    if (step) go(step.time);
  });
  const fold = (open) => {
    figure.classList.toggle("failures-all", open);
    all.setAttribute("aria-expanded", open);
    all.textContent = open ? "Hide the figure of all cases" : "Show all cases in one figure";
  };
  all.addEventListener("click", () => fold(!figure.classList.contains("failures-all")));

  group.querySelector(".line-how").after(choice, outage);
  runs.box.after(make("div", { class: "failures-buttons" }, kill, next));
  runs.box.classList.add("failures-run");
  told.before(make("div", { class: "failures-picture" }, scene, list), lanes);
  told.after(whole, all);
  clock.box.classList.add("failures-clock");
  lanes.after(clock.box);
  figure.prepend(group);
  figure.classList.add("failures-live");
  fold(false);
  stage({});
})();
