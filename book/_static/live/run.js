// A run: its arrays in the memory of the compiled simulator, which goes on with it share by share.
"use strict";

function liveRun(module, data) {
  const { setUp, checkSize } = liveSetup(data);
  const { completedAt } = livePairs(data.constants);
  const { layouts, arrays: TYPES, constants } = data;
  const LINE = 64; // where arrays begin, in lines of a processor's cache [B]
  const PAGE = 65536; // in which memory grows [B]
  const { OVER, MEMORY, TICK, KIND_BITS, PROCESS_BITS, ITEM_BITS } = constants;

  return class Run {
    constructor(setting) {
      const { exports } = new WebAssembly.Instance(module);
      this.memory = exports.memory;
      this.compiled = exports.advance;
      this.top = exports.__heap_base.value;
      this.cell = {};
      const { arrays, until, reserve, learners } = setUp(setting);
      this.learners = learners;
      // What grows comes last: frames that wait, then events.
      const grows = (name) => (name === "pool" ? 1 : 0) + (name === "events" ? 2 : 0);
      for (const name of Object.keys(arrays).sort((one, other) => grows(one) - grows(other))) {
        const { bytes, shape, size } = arrays[name];
        const at = this.place(bytes.length);
        new Uint8Array(this.memory.buffer).set(bytes, at);
        this.cell[name] = { at, shape, size };
      }
      this.limits = [until, BigInt(reserve)];
      this.table = exports.arrays.value;
      this.describe();
    }

    // Reserve bytes; the memory grows as needed.
    place(length) {
      const at = Math.ceil(this.top / LINE) * LINE;
      this.top = at + length;
      checkSize(this.top);
      const more = this.top - this.memory.buffer.byteLength;
      if (more > 0) this.memory.grow(Math.ceil(more / PAGE));
      return at;
    }

    grow() {
      const { pool, events } = this.cell;
      const [frames, [count]] = [pool.shape[0], events.shape];
      this.top = pool.at;
      this.place(2 * frames * pool.size);
      const at = this.place(2 * count * events.size);
      const bytes = new Uint8Array(this.memory.buffer);
      bytes.copyWithin(at, events.at, events.at + count * events.size);
      bytes.fill(0, pool.at + frames * pool.size, at);
      bytes.fill(0, at + count * events.size, at + 2 * count * events.size);
      this.cell.pool = { ...pool, shape: [2 * frames] };
      this.cell.events = { at, size: events.size, shape: [2 * count] };
      for (let entry = frames; entry < 2 * frames - 1; entry++) this.put("pool", entry, "next", entry + 1);
      this.put("pool", 2 * frames - 1, "next", this.get("state", 0, "free"));
      this.put("state", 0, "free", frames);
      this.put("state", 0, "spare", this.get("state", 0, "spare") + BigInt(frames));
      this.describe();
    }

    // Describe an array as numba would: no owner, number, size, place, shape, strides.
    describe() {
      const numbers = Object.keys(TYPES).flatMap((name) => {
        const { at, shape, size } = this.cell[name];
        const strides = shape.map((_, axis) => shape.slice(axis + 1).reduce((product, length) => product * length, size));
        const count = shape.reduce((product, length) => product * length, 1);
        return [0, 0, count, size, at, ...shape, ...strides];
      });
      new BigInt64Array(this.memory.buffer, this.table).set(numbers.map(BigInt));
    }

    // Go on; return whether the run is over.
    go(steps) {
      for (;;) {
        const state = this.compiled(...this.limits, BigInt(steps));
        if (state !== MEMORY) return state === OVER;
        this.grow();
      }
    }

    where(name, place, field) {
      const { at, size } = this.cell[name];
      const [offset, kind] = layouts[TYPES[name]].fields[field];
      return [at + place * size + offset, kind];
    }

    get(name, place, field) {
      const [at, kind] = this.where(name, place, field);
      const view = new DataView(this.memory.buffer);
      return kind === "i8" ? view.getBigInt64(at, true) : kind === "i4" ? view.getInt32(at, true) : view.getFloat64(at, true);
    }

    put(name, place, field, value) {
      new DataView(this.memory.buffer).setBigInt64(this.where(name, place, field)[0], BigInt(value), true);
    }

    bytes(name) {
      const { at, shape, size } = this.cell[name];
      return new Uint8Array(this.memory.buffer, at, shape.reduce((product, length) => product * length, size));
    }

    now(field) {
      return Number(this.get("state", 0, field));
    }

    // Return the transmissions since the last call, six numbers each: start and end [ticks], station,
    // row of the table, frames, outcome. What one share sends has to fit in the log.
    sent() {
      const rows = new BigInt64Array(this.memory.buffer, this.cell.log.at, 6 * this.now("logged"));
      const found = Float64Array.from(rows, Number);
      this.put("state", 0, "logged", 0);
      return found;
    }

    // Return the transmissions of the last step: the six numbers, sending and receiving process, number of the frame,
    // and when it came to the station [ticks]; then frames lost by cause, and those that wait at each station. For
    // radios that send one message in a frame.
    traced() {
      const [sent, parts] = [this.sent(), [KIND_BITS, PROCESS_BITS, PROCESS_BITS, ITEM_BITS]];
      const lost = constants.CAUSES.map((name) => this.now(name));
      const waiting = Array.from({ length: this.now("hosts") + 1 }, (_, station) => Number(this.get("stations", station, "length")));
      const rows = [];
      for (let row = 0; row < sent.length; row += 6) {
        const station = sent[row + 2];
        let frame = this.get("window", station, "frame");
        const [, to, from, item] = parts.map((bits) => {
          const part = Number(BigInt.asUintN(bits, frame));
          frame >>= BigInt(bits);
          return part;
        });
        rows.push(...sent.subarray(row, row + 6), from, to, item, Number(this.get("window", station, "came")), ...lost, ...waiting);
      }
      return rows;
    }

    // Return the state: time [s], share of complete pairs [1], frames lost and waiting at the access point, and
    // whether discovery is complete.
    state() {
      const gone = this.now("arrived") + this.lost();
      const [done, all] = this.now("repairs") ? [this.now("finished"), this.now("pairs")] : [gone, this.now("expected")];
      return {
        time: this.now("clock") * TICK,
        done: all ? done / all : 0,
        lost: this.lost(),
        waiting: Number(this.get("stations", this.now("hosts"), "length")),
        complete: this.now("converged") > 0,
      };
    }

    // Count lost frames by how their cause begins.
    lost(where = "") {
      return constants.CAUSES.filter((name) => name.startsWith(where)).reduce((total, name) => total + this.now(name), 0);
    }

    // Return for all pairs: the share that is complete, the time of most of them [s], and expired leases.
    pairs() {
      if (!this.now("repairs")) return { done: NaN, most: Infinity, expired: 0 };
      const times = completedAt((pair) => Number(this.get("pairs", pair, "completed_at")), this.learners);
      const unfinished = times.indexOf(Infinity);
      const most = times[Math.ceil(0.95 * times.length) - 1];
      return { done: (unfinished < 0 ? times.length : unfinished) / times.length, most: most * TICK, expired: this.now("expired") / times.length };
    }

    // Return what one run found: times [s] and counts, as discostorm_simulation.Run has them.
    result() {
      const lost = this.lost();
      const [expected, arrived] = [this.now("expected"), this.now("arrived")];
      const drained = this.now("open") || this.now("coming") ? Infinity : this.now("drained") * TICK;
      const converged = this.now("repairs") ? this.now("converged") * TICK || Infinity : arrived === expected ? drained : Infinity;
      const lostAt = ["host_", "ap_", "on_air"].map((where) => this.lost(where) / Math.max(expected, 1));
      return { drained, converged, lost: expected ? lost / expected : 0, lostAt, expected, arrived, busy: this.now("busy") * TICK, ...this.pairs() };
    }
  };
}
