// The arrays of a run at its start: what discostorm_simulation.initial_state makes of a setting.
// What depends on neither fleet nor seed is in tables.js.
"use strict";

function liveSetup({ layouts, arrays: TYPES, constants, tables, radios }) {
  const { state, bits, fractions } = liveChance();
  const { sum, population, shares } = liveTraffic();
  const { addServer, missing, toComplete } = livePairs(constants);
  const { NEVER, TICK, PROCESS_BITS } = constants;
  const DEFAULTS = {
    recovery: true,
    queue: [500, 0.5], // frames and seconds; null: no limit
    start: 0, // of all hosts, or one of each [s]
    within: 0, // at random instead, within so many seconds
    loss: 0, // of all hosts, or one of each [1]
    until: 120, // after the last host's start [s]
    giveUp: null, // see discostorm_simulation.simulate
    eifs: false,
    block_ack: "negotiate",
    power: null, // at [sender][receiver], the access point last, as factors; null: all heard alike
    seed: 0,
    run: 0,
    log: constants.LOG, // rows
  };

  const even = (number) => Math.round(number) - (Math.abs(number % 1) === 0.5 && Math.round(number) % 2 ? 1 : 0);
  const ticks = (seconds) => Math.min(even(seconds / TICK), NEVER);
  const each = (value, hosts) => (Array.isArray(value) ? value : Array(hosts).fill(value));

  // Arrays: bytes with a shape; the fields of records have names.

  const SIZES = { i8: 8, f8: 8, i4: 4 };
  const ACCESS = {
    i8: [(view, at) => view.getBigInt64(at, true), (view, at, value) => view.setBigInt64(at, BigInt(value), true)],
    i4: [(view, at) => view.getInt32(at, true), (view, at, value) => view.setInt32(at, value, true)],
    f8: [(view, at) => view.getFloat64(at, true), (view, at, value) => view.setFloat64(at, value, true)],
  };

  function array(name, ...shape) {
    const type = TYPES[name];
    const size = SIZES[type] ?? layouts[type].size;
    const bytes = new Uint8Array(shape.reduce((product, length) => product * length, size));
    const view = new DataView(bytes.buffer);
    const put = (place, field, value) => {
      const [offset, kind] = layouts[type].fields[field];
      ACCESS[kind][1](view, place * size + offset, value);
    };
    const fill = (values) => {
      let at = -size;
      for (const value of values) ACCESS[type][1](view, (at += size), value);
    };
    return { bytes, shape, size, put, fill };
  }

  function record(name, values, many = 1) {
    const found = array(name, many);
    for (let place = 0; place < many; place++) put(found, place, values);
    return found;
  }

  const put = (records, place, values) => Object.entries(values).forEach(([field, value]) => records.put(place, field, value));

  const refuse = (message) => {
    throw new RangeError(message);
  };
  const MOST = 1e9; // that a run may take [B]

  function checkSize(bytes) {
    if (bytes > MOST) refuse(`This run needs more than ${MOST / 1e6} MB of memory. Choose fewer robots or endpoints.`);
  }

  // Return the rows of messages, and how many of each a process sends.
  function traffic(table, recovering, wifi, all) {
    const { spread = [] } = recovering;
    const found = shares(table, all, spread);
    for (const row of spread) {
      const [{ name, sent, alone = sent }, least] = [table.messages[row], Math.min(...found.shares[row].each)];
      if (least < 1) refuse(`${name}: hosts must have at most ${alone} processes on average; got ${alone / least}`);
    }
    const most = 2 ** constants.ITEM_BITS;
    const sets = [all.processes.map(() => 1)];
    const of = found.shares.map(({ taking }) => {
      const known = sets.findIndex((set) => !taking || set.join() === taking.join());
      return known < 0 ? sets.push(taking) - 1 : known;
    });
    if (recovering.server) addServer(found, sets, of, table, recovering.kinds, all);
    const rows = found.shares.map(({ each: toEach, toAll }, row) => {
      const message = table.messages[row];
      const octets = even(found.octets[row]) + (wifi.aggregates ? 2 : 0);
      if (octets > constants.OCTETS) refuse(`${message.name}: its frames must have at most ${constants.OCTETS} B; got ${octets}`);
      const columns = Object.fromEntries(Object.entries(recovering.kinds).map(([name, values]) => [name, values[row]]));
      if (columns.role === constants.DATA && Math.max(...toEach) > most) {
        refuse(`${message.name}: a process must send at most ${most} to each other; got ${Math.max(...toEach)}`);
      }
      const up = length(octets, wifi.fast);
      const down = message.multicast ? length(octets, wifi.slow) : up;
      const whole = Number(![...toEach, ...toAll].some((number) => number % 1));
      return { ...columns, octets, set: of[row], whole, time_up: up, time_down: down };
    });
    const numbers = (name) => found.shares[0].each.flatMap((_, i) => found.shares.map((one) => one[name][i]));
    return { rows, sets, each: numbers("each"), toAll: numbers("toAll") };
  }

  // Return how long a PPDU with one frame takes [ticks].
  function length(octets, { bits: perSymbol, added, symbol, grid, preamble }) {
    const symbols = Math.ceil((added + 8 * octets) / perSymbol);
    return preamble + Math.ceil((symbols * symbol) / grid) * grid;
  }

  // Return the first events: bursts, announcements, lease checks.
  function firstEvents({ bursts, repairs }, starts, host) {
    const due = starts.flatMap((start, host) =>
      bursts.times.map(([time, number]) => [ticks(start + time), constants.SEND | BigInt(host) | (BigInt(number) << BigInt(PROCESS_BITS))]),
    );
    if (repairs) {
      const { announce_interval_initial: first = 0, lease } = repairs;
      host.forEach((at, i) => {
        const begin = ticks(starts[at] ?? 0);
        if (first) due.push([begin + first, constants.ANNOUNCE | BigInt(i)]);
        if (lease < NEVER) due.push([begin + lease, constants.LEASE_CHECK | BigInt(i)]);
      });
    }
    return due.sort(([one, what], [other, that]) => one - other || (what < that ? -1 : 1));
  }

  function startsOf({ start, within, seed, run }, hosts) {
    if (!within) return each(start, hosts);
    const draw = fractions(seed, [run, 0]);
    return Array.from({ length: hosts }, () => within * draw());
  }

  // Return how long a run goes on without a new complete pair [ticks].
  function patience({ giveUp }, { kinds, bursts, repairs }) {
    const { announce_interval_max: announces = 0, heartbeat_period_max: beats = 0, rto_max: sends = 0 } = repairs;
    const overTcp = kinds.role?.some((role, row) => role === constants.DATA && kinds.tcp?.[row]);
    return even(giveUp * Math.max(announces, beats, overTcp ? sends : 0, ...bursts.periods));
  }

  // Return how many frames and events one step adds at most.
  function reserve({ rows, each: toEach, toAll }, repairs, window, { sizes, radios }) {
    const count = toEach.length / rows.length;
    const most = Math.max(...sizes) * count;
    const least = (1024 + sizes.length * window) * radios;
    const numbers = rows.map((_, row) => {
      const own = Array.from({ length: count }, (_, i) => Math.max(toEach[i * rows.length + row], toAll[i * rows.length + row]));
      return Math.ceil(Math.max(...own));
    });
    if (!repairs) return least + sum(numbers.filter((_, row) => !(rows[row].up && rows[row].down))) * most;
    return least + 2 * most * (sum(numbers) + 4 + sum(rows.map(({ gap_number: gaps = 0 }) => gaps)));
  }

  // Return the arrays of a run, its latest end [ticks], and how much one step adds at most.
  function setUp(given) {
    const setting = { ...DEFAULTS, ...given };
    const [table, wifi] = [tables[setting.table], radios[setting.radio]];
    const recovering = setting.recovery ? table.recovering : table.alone;
    if (recovering.refused) refuse(recovering.refused);
    const all = population(setting.fleet);
    const { processes, sizes, cellOf, aerial, cells, radios: parts } = all;
    const server = recovering.server ? processes.length : 0;
    const [count, hosts, rows] = [processes.length + (server > 0), sizes.length, table.messages.length];
    if (hosts < 2) refuse(`fleet must have at least 2 hosts to simulate; got ${hosts}`);
    const { bursts } = recovering;
    const repairs = recovering.repairs && { ...recovering.repairs, ...(server && { server }) };
    const host = processes.map((process) => process.host).concat(server ? [hosts] : []);
    const mute = host.map((_, i) => Boolean(recovering.kinds.to_host && i < processes.length && !processes[i].speaks));
    if (repairs) checkSize(count ** 2 * layouts.pairs.size);
    const sent = traffic(table, recovering, wifi, all);
    const starts = startsOf(setting, hosts);
    const [frames, seconds] = setting.queue ?? [null, null];
    const radio = {
      ...wifi.record,
      eifs_extra: setting.eifs ? wifi.record.eifs_extra : 0,
      queue: Math.min(frames ?? NEVER, NEVER),
      lifetime: ticks(seconds ?? Infinity),
    };
    const { mpdus, window } = radio;

    const draw = bits(setting.seed, [setting.run, 2]);
    const part = sent.each.map(() => (draw() >>> 12) / 2 ** 20);
    const due = firstEvents(recovering, starts, host);
    const lacking = repairs ? missing(sent, part, host, server) : new Float64Array(0);
    const channel = {
      base: radio.slot,
      idle: -1,
      deferred_time: NEVER,
      per_receiver: Number(mpdus > 1),
      cold: Number(setting.block_ack === "negotiate" && mpdus > 1),
    };
    const cell = {
      ...channel,
      step: ticks(1e-3),
      spare: constants.POOL,
      hosts,
      links: hosts - 1,
      kinds: rows,
      unlike: Number(Boolean(setting.power)),
      cells,
      // As xorshift must not begin at zero.
      random: BigInt.asIntN(64, state(setting.seed, [setting.run, 1], 1)[0] | 1n),
      events: due.length,
      coming: hosts * bursts.times.filter(([, number]) => bursts.periods[number] === 0).length,
      repairs: Number(Boolean(repairs)),
      pairs: repairs ? toComplete(lacking, host, server, mute) : 0,
      ...(repairs && setting.giveUp && { progress: ticks(Math.max(...starts)), patience: patience(setting, recovering) }),
    };

    const every = hosts + cells;
    const stations = array("stations", every);
    for (let station = 0; station < every; station++) {
      put(stations, station, { head: -1, tail: -1, to_head: -1, to_tail: -1 });
    }
    let first = 0;
    sizes.forEach((size, host) => {
      put(stations, host, { processes: size, first, loss: cellOf[host] < aerial ? each(setting.loss, hosts)[host] : 0 });
      first += size;
    });
    const pool = array("pool", constants.POOL);
    for (let entry = 0; entry < constants.POOL; entry++) pool.put(entry, "next", entry + 1);
    const events = array("events", 2 * due.length + 1024);
    due.forEach(([time, what], place) => put(events, place, { time, what }));
    const kinds = array("kinds", cells * rows);
    for (let at = 0; at < cells * rows; at++) put(kinds, at, { ...sent.rows[at % rows], ...(at >= aerial * rows && { octets: 1, time_up: 1, time_down: 1 }) });
    const own = array("processes", count);
    host.forEach((at, i) => {
      put(own, i, { host: at, start: ticks(starts[at] ?? 0), announce: repairs?.announce_interval_initial ?? 0, mute: Number(mute[i]) });
    });
    const plain = (name, values, ...shape) => {
      const found = array(name, ...shape);
      return found.fill(values), found;
    };
    const members = bursts.messages.map((burst, number) => [
      ...sent.rows.map((_, row) => Number(burst.includes(row))),
      bursts.periods[number],
    ]);
    const before = sent.sets.map((set) => {
      let taking = 0;
      return [0, ...set.map((takes) => (taking += takes))];
    });
    const pairs = repairs ? array("pairs", count, count) : array("pairs", 1, 1);
    lacking.forEach((items, pair) => items && pairs.put(pair, "missing", items));
    const most = lacking.reduce((most, one) => Math.max(most, one), 0);
    const noted = repairs?.nack_response_delay ? [count, count, most] : [1, 1, 1];
    const wheel = 2 ** (32 - Math.clz32(2 * radio.cw_max + 1));

    const channels = record("channels", { ...channel, next: NEVER }, cells);
    for (let number = 0; number < cells; number++) put(channels, number, { hosts: cellOf.filter((own) => own === number).length, ...(number === aerial && { base: 1, per_receiver: 0, cold: 0 }) });
    // As discostorm_simulation.cell_setup.wire_record.
    const air = record("radio", radio, parts);
    const ones = Object.fromEntries(Object.keys(layouts.radio.fields).map((name) => [name, 1]));
    const wire = { ...ones, cw_min: 0, cw_max: 0, attempts: NEVER, queue: NEVER, lifetime: NEVER };
    if (cells > aerial) put(air, cells, wire);

    const made = {
      radio: air,
      state: record("state", cell),
      channels,
      cell_of: plain("cell_of", [...cellOf, ...Array(cells).keys()], every),
      stations,
      window: array("window", every, mpdus),
      ordered: plain("ordered", Array(hosts * window).fill(-1), hosts, window),
      wheel: plain("wheel", Array(cells * wheel).fill(-1), cells, wheel),
      behind: plain("behind", Array(every).fill(-1), every),
      deferred: array("deferred", cells, every),
      senders: array("senders", Math.max(every, mpdus)),
      pool,
      block_acks: array("block_acks", hosts, 2),
      addba: array("addba", every),
      events,
      kinds,
      bursts: plain("bursts", members.flat(), Math.max(1, members.length), rows + 1),
      processes: own,
      each: plain("each", sent.each, count, rows),
      to_all: plain("to_all", sent.toAll, count, rows),
      part: plain("part", part, count, rows),
      receivers_before: plain("receivers_before", before.flat(), before.length, count + 1),
      power: setting.power ? plain("power", setting.power.flat(), hosts + 1, hosts + 1) : array("power", 1, 1),
      repairs: record("repairs", repairs ?? {}),
      pairs,
      received_bitmap: repairs ? array("received_bitmap", count, count, 1 + Math.floor(most / 64)) : array("received_bitmap", 1, 1, 1),
      delays: array("delays", 1, 1), // pages have no user data
      airtime: array("airtime", rows + 1, 3),
      queue_samples: array("queue_samples", constants.QUEUE_SAMPLES),
      log: array("log", setting.log),
      came_after: array("came_after", ...noted),
    };
    const arrays = Object.fromEntries(Object.keys(TYPES).map((name) => [name, made[name]]));
    const end = repairs ? ticks(Math.max(...starts) + setting.until) : NEVER;
    return { arrays, until: end < NEVER ? BigInt(end) : BigInt(NEVER) - 1n, reserve: reserve(sent, repairs, window, all), learners: { host, server, mute, lacking } };
  }

  return { setUp, checkSize, traffic, reserve };
}
