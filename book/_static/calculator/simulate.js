// "Simulate my fleet": runs of the package's simulator, in this browser, beside the counted answer.
"use strict";

// Return what tells the simulation that the entries have changed, and that its button was pressed. The words are
// calculator.js's, which loads this.
function FleetSimulation({ runs: RUNS, seed, queue, until }, { make, exact, duration, between, capitalized, two }) {
  const byId = (id) => document.getElementById(`calc-${id}`);
  const [button, bar, said, list] = ["simulate", "progress", "simulated", "runs"].map(byId);
  const MOST = 1e9; // that a run may take [B]
  const NAMES = ["none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten"];
  const word = (number) => NAMES[number] ?? String(number);

  let settings = null; // what is entered, null if that is not valid
  let asked = 0; // so that nothing of earlier entries is shown
  let current = null; // the run under way

  // ---- what is simulated ----

  function groupsOf({ N_H, N_P, N_E, N_S, N_H1, N_P1, N_E1, N_S1 }) {
    const robots = { hosts: N_H, processes: N_P, endpoints: N_E, shared: N_S };
    return N_H1 ? [robots, { hosts: N_H1, processes: N_P1, endpoints: N_E1, shared: N_S1 }] : [robots];
  }

  // Return why a fleet cannot be simulated here, or nothing.
  function refusal(groups, radio, { radios, layouts }) {
    const sum = (values) => values.reduce((total, value) => total + value, 0);
    if (sum(groups.map(({ hosts }) => hosts)) < 2) return "One robot alone has no one to discover. Enter at least two hosts.";
    if (!(radio in radios)) return "Rates and overheads of your own can be counted, but not simulated. Choose an access point from the list.";
    if (groups.some(({ endpoints }) => endpoints % 1)) return "A simulation needs whole endpoints. Enter a whole number of endpoints for each process.";
    const processes = sum(groups.map(({ hosts, processes }) => hosts * processes));
    const items = 1 + Math.max(...groups.map(({ endpoints }) => endpoints)) / 64;
    if (processes ** 2 * (layouts.pairs.size + 8 * items) > MOST) return "This fleet is too large to simulate in a browser. Enter fewer robots, processes or endpoints.";
    return "";
  }

  function settingOf({ middleware, channel, swarm }, { tables, radios, layouts }) {
    const groups = groupsOf(swarm);
    // A radio that aggregates does so.
    const radio = (channel.full ?? channel).name;
    const why = refusal(groups, radio, { radios, layouts });
    if (why) throw new RangeError(why);
    const { refused = "" } = tables[middleware].recovering;
    const fleet = { groups, matching: swarm.names === 2 ? 1 : 0 };
    return { refused, setting: { table: middleware, radio, recovery: !refused, fleet, queue, until, seed } };
  }

  async function simulate() {
    const mine = ++asked;
    const found = [];
    busy(true);
    try {
      const { setting, refused } = settingOf(settings, await Live.load());
      while (found.length < RUNS) {
        if (mine !== asked) return;
        let part = 0; // of this run
        const each = ({ time, done }) => {
          part = Math.max(part, refused ? done : Math.max(done / 2, time / until));
          bar.value = (found.length + Math.min(1, part)) / RUNS;
        };
        current = Live.run({ ...setting, run: found.length }, { each });
        const result = await current.found;
        if (mine !== asked) return;
        if (!result) break; // stopped by the reader
        found.push(result);
      }
      show(found, refused);
    } catch (error) {
      if (mine === asked) said.replaceChildren(make("p", {}, error.message));
    } finally {
      if (mine === asked) busy(false);
    }
  }

  // ---- what is said ----

  function busy(on) {
    if (on) clear();
    else current = null;
    button.textContent = on ? "Stop" : "Simulate my fleet";
    bar.hidden = !on;
    bar.value = 0;
  }

  function clear() {
    said.replaceChildren();
    list.hidden = true;
  }

  const middle = (values) => {
    const sorted = [...values].sort((one, other) => one - other);
    return (sorted[Math.floor((sorted.length - 1) / 2)] + sorted[Math.ceil((sorted.length - 1) / 2)]) / 2;
  };

  // Return two times in words, for machines with all their digits.
  function times(values) {
    const ends = [Math.min(...values), Math.max(...values)];
    const numbers = ends.map((value, i) => make("data", { value: String(value), "data-of": `simulated ${["first", "last"][i]}`, hidden: "" }));
    return [between(...ends.map(duration)), ...numbers];
  }

  function share(values) {
    const lost = middle(values);
    const text = lost ? `${lost < 0.0005 ? "less than 0.1" : two.format(100 * lost)}% lost` : "nothing lost";
    return exact(lost, text, "simulated lost");
  }

  // Return the answer: what of n of ten runs is known. Those that ended tell how much was lost, or all if none did.
  function answer(found, refused) {
    const ended = found.filter(({ converged, drained }) => Number.isFinite(refused ? drained : converged));
    const lost = share((ended.length ? ended : found).map(({ lost }) => lost));
    const of = `${word(found.length)} ${found.length === 1 ? "run" : "runs"}`;
    const rest = found.length - ended.length;
    if (refused) {
      const when = ended.length ? [`Startup carried after `, ...times(ended.map(({ drained }) => drained)), ", "] : ["Startup not carried, "];
      return [...when, lost, `, in ${word(ended.length || rest)} of ${of}. Nothing recovers what is lost here: ${refused.replace(/^[^:]*: /, "")}.`];
    }
    if (!ended.length) return [`Not complete within ${duration(until)}, `, lost, `, in ${word(rest)} of ${of}.`];
    const others = rest ? ` ${capitalized(word(rest))} ${rest === 1 ? "was" : "were"} not complete within ${duration(until)}.` : "";
    return ["Complete after ", ...times(ended.map(({ converged }) => converged)), ", ", lost, `, in ${word(ended.length)} of ${of}.${others}`];
  }

  function show(found, refused) {
    if (!found.length) {
      said.replaceChildren(make("p", {}, "Stopped before the first run was over."));
      return;
    }
    const stopped = found.length < RUNS ? ` Stopped after ${word(found.length)} of ${word(RUNS)} runs.` : "";
    const [frames, seconds] = queue;
    const assumed =
      `Simulated frame by frame, with collisions and with queues that hold ${frames} frames for ${seconds} s. ` +
      `The share lost is of all deliveries${refused ? "" : ` within ${duration(until)}, repeated ones included`} (median run). ` +
      "Assumes: simultaneous start · no frame errors.";
    said.replaceChildren(make("p", {}, make("b", {}, "Simulated: "), ...answer(found, refused), stopped), make("p", { class: "calc-hint" }, assumed));
    const cell = (value, text, of) => make("td", {}, exact(value, text, of));
    const row = ({ converged, drained, lost }, i) => {
      const end = refused ? drained : converged;
      const text = Number.isFinite(end) ? end.toFixed(2) : "not reached";
      return make("tr", {}, make("th", { scope: "row" }, String(i + 1)), cell(end, text, `run ${i} end`), cell(lost, (100 * lost).toFixed(1), `run ${i} lost`));
    };
    const head = ["Run", refused ? "Carried after [s]" : "Complete after [s]", "Lost [%]"].map((name) => make("th", { scope: "col" }, name));
    const table = make("table", { class: "calc-table" }, make("thead", {}, make("tr", {}, ...head)), make("tbody", {}, ...found.map(row)));
    list.replaceChildren(make("summary", {}, "Each run"), table);
    list.hidden = false;
  }

  function press() {
    if (bar.hidden) simulate();
    else if (current) current.stop();
    else {
      asked++; // the simulator is not loaded yet
      busy(false);
    }
  }

  /** Take what is entered: what was simulated of other entries goes. */
  function changed(entered) {
    asked++;
    current?.stop();
    settings = entered;
    clear();
    busy(false);
  }

  return { changed, press };
}
