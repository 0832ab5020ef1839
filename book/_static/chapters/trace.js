// One start as the simulator traced it (live/run.js): what each transmission is, why it waited, and what
// has arrived after it. A row is a transmission; times are whole ticks.
"use strict";

function Trace(values, columns, { hosts, processes, announcements, messages, setting }, { constants, radios, causes }) {
  const width = columns.length + hosts + 1;
  const count = values.length / width;
  const at = Object.fromEntries(columns.map((name, place) => [name, place]));
  const get = (row, name) => values[row * width + at[name]];
  const waiting = (row, station) => values[row * width + columns.length + station];
  const POINT = hosts; // the access point's number
  const { TICK, CAUSES } = constants;
  const window = radios[setting.radio].record; // of back-off, among others
  const host = (process) => Math.floor(process / processes);
  const message = (row) => messages[get(row, "kind")];
  const failed = (row) => get(row, "outcome") !== 0;

  // ---- exchanges: rows that begin together have collided ----

  const [first, last] = [new Int32Array(count), new Int32Array(count)];
  const ends = []; // of exchanges, and how long the channel was busy before each
  const begins = [];
  const busy = [0];
  for (let row = 0; row < count; row = last[row] + 1) {
    let [to, end] = [row, 0];
    for (; to < count && get(to, "start") === get(row, "start"); to++) end = Math.max(end, get(to, "end"));
    first.fill(row, row, to);
    last.fill(to - 1, row, to);
    begins.push(get(row, "start"));
    ends.push(end);
    busy.push(busy.at(-1) + end - get(row, "start"));
  }

  // Return the first place whose value is not below a limit, in ascending values.
  function search(sorted, limit, value = (place) => sorted[place], length = sorted.length) {
    let [low, high] = [0, length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (value(middle) < limit) low = middle + 1;
      else high = middle;
    }
    return low;
  }
  const firstFrom = (time) => search(null, time, (row) => get(row, "start"), count);

  // Return for how long the channel was busy up to a time.
  function busyUntil(time) {
    const place = search(ends, time);
    return busy[place] + (place < ends.length ? Math.max(0, time - begins[place]) : 0);
  }

  // ---- waits: behind others in the queue, then for the channel ----

  const waits = Array(count);
  const again = new Uint8Array(count); // whether its sender tries again
  const stations = Array.from({ length: hosts + 1 }, () => ({ row: -1, done: [] }));
  const SAME = ["kind", "source", "destination", "item", "came"];
  for (let row = 0; row < count; row++) {
    const own = stations[get(row, "station")];
    const [before, start, came] = [own.row, get(row, "start"), get(row, "came")];
    own.row = row;
    if (before >= 0 && failed(before) && SAME.every((name) => get(before, name) === get(row, name))) {
      const { head, ahead, failures, tried } = waits[before];
      const lasted = ends[search(begins, get(before, "start"))] - get(before, "start");
      again[before] = 1;
      waits[row] = { came, head, ahead, failures: failures + 1, tried: tried + lasted };
    } else {
      const free = before < 0 ? 0 : get(before, "end");
      if (before >= 0) own.done.push(free);
      const head = Math.max(came, free);
      waits[row] = { came, head, ahead: own.done.length - search(own.done, came + 1), failures: 0, tried: 0 };
    }
    const one = waits[row];
    const busySince = busyUntil(start) - busyUntil(one.head);
    // All four together are the time from when the frame came to when it is sent.
    Object.assign(one, { queued: one.head - came, others: busySince - one.tried, idle: start - one.head - busySince });
  }

  // ---- what has arrived ----

  // Return how many endpoint announcements of each robot have arrived at each other, at [reader][writer].
  function known(row) {
    const found = Array.from({ length: hosts }, () => new Float64Array(hosts));
    for (let each = 0; each <= last[row]; each++) {
      if (get(each, "station") !== POINT || failed(each) || !message(each).endpoint) continue;
      found[host(get(each, "destination"))][host(get(each, "source"))]++;
    }
    return found;
  }

  const lost = (row) => CAUSES.reduce((sum, name) => sum + get(row, name), 0);
  const more = (row, name) => get(row, name) - (first[row] ? get(first[row] - 1, name) : 0);

  // ---- words ----

  const whole = new Intl.NumberFormat("en-US");
  const ms = (ticks) => `${(ticks * TICK * 1e3).toFixed(2)}\u00a0ms`;
  const many = (number, one, several = `${one}s`) => `${whole.format(number)} ${number === 1 ? one : several}`;
  const robot = (number) => (number === POINT ? "the access point" : `robot ${number + 1}`);
  const listed = (parts) => (parts.length < 3 ? parts.join(" and ") : `${parts.slice(0, -1).join(", ")}, and ${parts.at(-1)}`);
  const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}.`;

  function what(row) {
    const { name, multicast } = message(row);
    const text = `${/^[aeiou]/i.test(name) ? "an" : "a"} ${name}`;
    const [from, to] = [robot(host(get(row, "source"))), multicast ? "all other robots" : robot(host(get(row, "destination")))];
    return sentence(get(row, "station") === POINT ? `the access point sends ${to} ${text} from ${from}` : `${from} sends the access point ${text} for ${to}`);
  }

  function outcome(row) {
    if (!failed(row)) return more(row, "ap_full") ? "It arrives, but the access point’s queue is full and drops it." : "It arrives.";
    const others = [];
    for (let other = first[row]; other <= last[row]; other++) if (other !== row) others.push(robot(get(other, "station")));
    const collides = `It collides with ${others.length > 1 ? "frames" : "a frame"} of ${listed(others)}`;
    if (again[row]) return `${collides}, so ${robot(get(row, "station"))} tries again.`;
    if (message(row).multicast && get(row, "station") === POINT) return `${collides}. No robot acknowledges a multicast frame, so it is lost.`;
    return `${collides}. ${sentence(`${robot(get(row, "station"))} drops it`)}`;
  }

  function why(row) {
    const { came, queued, ahead, tried, failures, others, idle } = waits[row];
    const parts = [
      [queued, `in the queue behind ${many(ahead, "frame")} sent first`],
      [tried, `in ${many(failures, "attempt")} that collided`],
      [others, "while other stations sent"],
      [idle, "of pauses and back-off"],
    ];
    const told = listed(parts.filter(([ticks]) => ticks > 0).map(([ticks, text]) => `${ms(ticks)} ${text}`));
    const slots = Math.min((window.cw_min + 1) * 2 ** failures, window.cw_max + 1) - 1;
    const doubled = failures ? ` After ${many(failures, "collision")}, ${robot(get(row, "station"))} draws a back-off of up to ${slots} slots.` : "";
    return `It waited ${ms(get(row, "start") - came)}: ${told}.${doubled}`;
  }

  // Return what the cell is at after a frame: queues, losses, and what has arrived.
  function state(row) {
    const queues = Array.from({ length: hosts + 1 }, (_, station) => `${whole.format(waiting(row, station))} at ${robot(station)}`);
    const gone = CAUSES.filter((name) => get(row, name)).map((name) => `${whole.format(get(row, name))} ${causes[name]}`);
    const arrived = known(row).reduce((sum, from) => sum + from.reduce((one, other) => one + other, 0), 0);
    const all = hosts * (hosts - 1) * announcements;
    return [
      `Frames waiting: ${listed(queues)}.`,
      `Receptions lost so far: ${gone.length ? `${whole.format(lost(row))} (${gone.join(", ")})` : "none"}.`,
      `Endpoint announcements that have arrived: ${whole.format(arrived)} of ${whole.format(all)}.`,
    ].join(" ");
  }

  return { count, get, waiting, waits, first, last, failed, lost, known, firstFrom, search, ms, robot, what, outcome, why, state, POINT };
}
