// What is shown of runs: what they sent, on one clock, without long silences.
"use strict";

const Show = (() => {
  const TICK = 1e-7; // of the simulator's clock [s]
  const PAUSE = 0.03; // the longest silence that is shown whole [s]

  const [SHORTEST, LONGEST, SLOWEST] = [6, 40, 60]; // of a show [s]; times slower than real
  const SLOWER = 10; // times slower again, if the reader wants it slowly

  // Return how long so much is shown [s].
  function seconds(length, slowly) {
    if (slowly) return Math.min(LONGEST, length * SLOWEST * SLOWER);
    return Math.min(LONGEST, Math.max(SHORTEST, length * 10), length * SLOWEST);
  }

  function paragraph(...parts) {
    const element = document.createElement("p");
    element.append(...parts);
    return element;
  }

  // Return what a run sent, by its own clock [s]. Shares hold six numbers a transmission: start, end [ticks],
  // station, row of the table, frames, outcome; and looks at the run meanwhile, each after so many of these.
  function collected(shares) {
    const many = shares.reduce((total, { rows }) => total + rows.length / 6, 0);
    const [start, end] = [new Float64Array(many), new Float64Array(many)];
    const [station, outcome] = [new Uint8Array(many), new Uint8Array(many)];
    const looks = { rows: [], time: [], waiting: [], lost: [], done: [] };
    let place = 0;
    for (const { rows, states } of shares) {
      for (const state of states) {
        looks.rows.push(place + state.rows);
        for (const name of ["time", "waiting", "lost", "done"]) looks[name].push(state[name]);
      }
      for (let row = 0; row < rows.length; row += 6, place++) {
        [start[place], end[place]] = [rows[row] * TICK, rows[row + 1] * TICK];
        [station[place], outcome[place]] = [rows[row + 2], rows[row + 5]];
      }
    }
    return { start, end, station, outcome, looks, length: 0 };
  }

  // Put runs on one clock, from which silences of all of them are cut. Return them by this clock, how long that
  // is [s], and how late it is at a time of it.
  function together(given) {
    const runs = given.map((run) => ({ ...run, start: run.start.slice(), end: run.end.slice(), looks: { ...run.looks, at: [] } }));
    const places = runs.map(() => 0); // of what each sends next
    const cuts = { at: [0], before: [0] }; // from when on how much silence is left out [s]
    let [cut, last] = [0, 0];
    const look = ({ looks, length }, place) => {
      while (looks.rows[looks.at.length] <= place) looks.at.push(length);
    };
    for (const run of runs) look(run, 0);
    const next = () => {
      let [found, first] = [-1, Infinity];
      for (let i = 0; i < runs.length; i++) {
        if (runs[i].start[places[i]] < first) [found, first] = [i, runs[i].start[places[i]]];
      }
      return found;
    };
    for (let i = next(); i >= 0; i = next()) {
      const run = runs[i];
      const place = places[i]++;
      const silence = run.start[place] - last - PAUSE;
      last = Math.max(last, run.end[place]);
      if (silence > 0) {
        cut += silence;
        cuts.at.push(run.start[place] - cut);
        cuts.before.push(cut);
      }
      run.start[place] -= cut;
      run.end[place] -= cut;
      run.length = Math.max(run.length, run.end[place]);
      look(run, place + 1);
    }
    const real = (time) => time + cuts.before[cuts.at.findLastIndex((at) => at <= time)];
    return { runs, length: Math.max(...runs.map(({ length }) => length)), real, silences: cuts.at.slice(1) };
  }

  // Return the four moments of a run, each with the station that it is about: when each robot has sent, when the
  // access point's queue is full, when repeats end the first silence after a loss, and when it ends. Null: it never is.
  function moments({ start, station, looks, hosts, length }, silences, full) {
    const sent = new Set();
    const all = start.findIndex((_, i) => sent.add(station[i]) && station[i] < hosts && sent.size - sent.has(hosts) === hosts);
    const place = looks.waiting.findIndex((waiting) => waiting > full);
    const lost = looks.at[looks.lost.findIndex((number) => number > 0)] ?? Infinity;
    const again = start.indexOf(silences.find((at) => at > lost));
    const of = (i) => (i < 0 ? null : { time: start[i], station: station[i] });
    return [of(all), place < 0 ? null : { time: looks.at[place], station: hosts }, of(again), { time: length, station: hosts }];
  }

  return { seconds, paragraph, collected, together, moments };
})();
