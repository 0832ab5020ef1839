// Who sends how many of each message to whom: what discostorm.messages.Unit and
// discostorm_simulation.cell_setup say, process by process.
"use strict";

function liveTraffic() {
  // NumPy adds up in eight columns and in halves; another order would round otherwise.
  function sum(values, first = 0, count = values.length) {
    if (count > 128) {
      const half = Math.floor(count / 16) * 8;
      return sum(values, first, half) + sum(values, first + half, count - half);
    }
    const whole = count - (count % 8);
    let total = 0;
    if (whole) {
      const columns = values.slice(first, first + 8);
      for (let i = 8; i < whole; i++) columns[i % 8] += values[first + i];
      const pair = (i) => columns[i] + columns[i + 1];
      total = pair(0) + pair(2) + (pair(4) + pair(6));
    }
    for (let i = whole; i < count; i++) total += values[first + i];
    return total;
  }

  // Return the processes of a fleet, host by host, and its counts. The endpoints of a group are those of each process,
  // or a list. All cells have the same channel; wired hosts have a cell of their own, the last.
  function population({ groups, matching = 0 }) {
    const processes = [];
    const sizes = []; // of hosts
    for (const { hosts, processes: size, endpoints, shared = 0 } of groups) {
      for (let copy = 0; copy < hosts; copy++) {
        for (let number = 0; number < size; number++) {
          const [speaks, first] = [Number(number === 0), Number(copy === 0)];
          const own = endpoints[number] ?? endpoints;
          const matched = shared + (own - shared) * matching;
          processes.push({ host: sizes.length, size, endpoints: own, matched, speaks, first });
        }
        sizes.push(size);
      }
    }
    const matches = Number(matching > 0 || groups.some(({ shared = 0 }) => shared > 0));
    const aerial = Math.max(...groups.map(({ wired, cell = 0 }) => (wired ? 0 : cell))) + 1;
    const cellOf = groups.flatMap(({ hosts, wired, cell = 0 }) => Array(hosts).fill(wired ? aerial : cell));
    const cells = aerial + groups.some(({ wired }) => wired);
    const radios = cells > 1 ? cells + 1 : 1; // that of the fleet, then of each cell
    return { processes, sizes, matches, matched: sum(processes.map((process) => process.matched)), cellOf, aerial, cells, radios };
  }

  // What a process has of each: a column of the unit.
  const OWN = {
    process: () => 1,
    endpoint: (process) => process.endpoints,
    "matched endpoint": (process) => process.matched,
    "unmatched endpoint": (process) => process.endpoints - process.matched,
    "matched writer": (process) => process.matched / 2,
    "unknown type": () => 0, // robots of the pages have no types of their own
    "matched endpoint of others": (process, number, all) => all.matched - process.matched,
    "listed endpoint": ({ endpoints }) => (endpoints * (endpoints + 1)) / 2,
    "endpoint of a kind of host": (process) => process.endpoints * process.first,
    // The mean, added up as NumPy does.
    "matched endpoint of a host": ({ speaks, size }, number, { processes }) =>
      speaks && processes.slice(number, number + size).reduce((all, { matched }) => all + matched, 0) / size,
    host: (process) => process.speaks,
    fleet: (process, number) => Number(number === 0),
  };
  const TIMES = {
    "third process": ({ processes }) => processes.length - 2,
    "third host": ({ sizes }) => sizes.length - 2,
    match: ({ matches }) => matches,
    "matched process": ({ processes, matches }) => (processes.length - 1) * matches,
    link: ({ sizes }) => (sizes.length - 1) * (sizes.length - 2),
  };
  const RECEIVES = {
    "remote process": () => 1,
    "other host": (process) => process.speaks,
    server: (process, number) => Number(number === 0),
  };

  // Return for how many of a unit each process sends: to all, or to each receiver.
  function senders([what, to, factor], all) {
    const times = factor ? TIMES[factor](all) : 1;
    const others = to === "other process" ? all.processes.length - 1 : 1;
    const away = (process) => Number(to !== "server" || process.host > 0);
    return all.processes.map((process, number) => OWN[what](process, number, all) * others * times * away(process));
  }

  // Return how many of a message each process sends, to each and to all, and who receives them.
  // What is spread goes to all processes of the hosts it is for, as many to each on average.
  function share({ unit, multicast }, times, all, spread = false) {
    let sent = senders(unit, all).map((number) => number * times);
    const count = all.processes.length;
    if (!RECEIVES[unit[1]]) {
      return { each: sent.map((number, i) => number / (count - all.processes[i].size)), toAll: sent };
    }
    if (spread) sent = sent.map((number, i) => (number * (all.sizes.length - 1)) / (count - all.processes[i].size));
    const taking = all.processes.map(spread ? () => 1 : RECEIVES[unit[1]]);
    const here = all.sizes.map(() => 0);
    taking.forEach((takes, i) => (here[all.processes[i].host] += takes));
    const many = sum(taking);
    const remote = all.processes.map((process) => many - here[process.host]);
    return { each: sent, toAll: sent.map((number, i) => number * remote[i] * multicast), taking, remote };
  }

  function frames({ each, toAll, remote }) {
    return sum(toAll) || (remote ? sum(each.map((number, i) => number * remote[i])) : 0);
  }

  // Return the shares of all messages, and the octets of a frame of each.
  function shares(table, all, spread = []) {
    const found = table.messages.map((message, row) => share(message, message.sent, all, spread.includes(row)));
    const octets = table.messages.map(() => 0);
    for (const [row, carrier, payload] of table.inside) {
      const alone = frames(share(table.messages[row], table.messages[row].alone, all));
      octets[carrier] += (payload * alone) / Math.max(frames(found[carrier]), 1);
    }
    return { shares: found, octets: octets.map((inside, row) => table.messages[row].bytes + inside) };
  }

  return { sum, population, shares };
}
