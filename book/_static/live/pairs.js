// Who has to learn of whom, directly or through a wired server: as discostorm_simulation.initial_state has it.
"use strict";

function livePairs(constants) {
  const { sum } = liveTraffic();

  // Add a wired server as the last process: what goes to it, comes from it, and is passed on by it.
  function addServer(found, sets, of, { messages }, { leg }, { processes, sizes }) {
    const count = processes.length;
    sets.forEach((set) => set.push(0));
    const server = sets.push([...processes.map(() => 0), 1]) - 1;
    const first = sets.push([...processes.map(({ speaks }) => speaks), 0]) - 1;
    found.shares.forEach((share, row) => {
      if (leg[row]) {
        const toHosts = messages[row].unit[1] === "other host";
        const sent = toHosts ? share.each : share.toAll;
        share.toAll = sent.map(() => 0);
        share.each = sent;
        if (leg[row] === constants.TO_SERVER) share.each = sent.map((number) => number * (toHosts ? sizes.length - 1 : 1));
        else if (leg[row] !== constants.FROM_SERVER && !toHosts) share.each = sent.map((number) => number / Math.max(count - 1, 1));
        of[row] = leg[row] === constants.TO_SERVER ? server : toHosts ? first : 0;
      }
      share.each.push(0);
      share.toAll.push(0);
    });
  }

  // Return what each process misses of each other, at [reader, writer]; a server is the last process.
  function missing({ rows, sets, each: toEach }, part, host, server) {
    const [count, found] = [host.length, new Float64Array(host.length ** 2)];
    rows.forEach(({ role, set, leg = 0, to_host: toHost = 0 }, row) => {
      if (role !== constants.DATA) return;
      const atHome = leg === constants.PASSED_ON && !toHost;
      for (let writer = 0; writer < count; writer++) {
        if (leg === constants.FROM_SERVER && writer !== server) continue;
        const begin = part[writer * rows.length + row];
        const own = sum(sets[set].filter((_, process) => host[process] === host[writer]));
        let before = 0;
        for (let reader = 0; reader < count; reader++) {
          const rank = before - (host[reader] >= host[writer] ? own : 0);
          before += sets[set][reader];
          const hears = atHome ? reader !== writer : host[reader] !== host[writer];
          if (!hears || !sets[set][reader]) continue;
          const wanted = toEach[(leg === constants.FROM_SERVER ? reader : writer) * rows.length + row];
          found[reader * count + writer] += Math.floor((rank + 1) * wanted + begin) - Math.floor(rank * wanted + begin);
        }
      }
    });
    return found;
  }

  // Return for how many pairs discovery has to be complete to be over.
  function toComplete(lacking, host, server, mute) {
    let found = 0;
    for (let reader = 0; reader < host.length; reader++) {
      for (let writer = 0; writer < host.length; writer++) {
        if (mute[reader] || reader === writer) continue;
        if (!server) found += host[reader] !== host[writer];
        else found += writer !== server && (reader === server || lacking[reader * host.length + writer] > 0);
      }
    }
    return found;
  }

  // Return for each pair of processes when the one knew all of the other [ticks], infinity if never, in ascending order:
  // as discostorm_simulation.run has it. `completed` tells it of a pair of the engine.
  function completedAt(completed, { host, server, mute, lacking }) {
    const [count, found] = [host.length, []];
    const [size, speakers] = [server ? count - 1 : count, mute.some(Boolean)];
    for (let reader = 0; reader < size; reader++) {
      const learner = speakers ? host.indexOf(host[reader]) : reader;
      for (let writer = 0; writer < size; writer++) {
        if (server && !speakers ? reader === writer : host[reader] === host[writer]) continue;
        const nothing = server && lacking[learner * count + writer] === 0;
        found.push(completed((nothing ? server : learner) * count + writer) || Infinity);
      }
    }
    return Float64Array.from(found).sort();
  }

  return { addServer, missing, toComplete, completedAt };
}
