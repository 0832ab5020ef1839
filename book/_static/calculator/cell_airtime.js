// The airtime of each of several access points, as discostorm.cell_utilization has it: what the simulator's processes send.
"use strict";

/** Return a function that tells the airtime of each cell in a window, or of its burst [s], from what each message costs. */
function CellAirtime({ fleet, table }, tables) {
  const { sum, population, shares } = liveTraffic();
  const all = population(fleet);
  const at = all.processes.map(({ host }) => all.cellOf[host]);
  const cells = [...Array(all.aerial).keys()];
  // As often as units say, in how many frames ever.
  const rows = tables[table].messages.map(({ sent, alone = sent, ...row }) => ({ ...row, sent: alone }));
  const within = (numbers, cell) => sum(numbers.filter((_, i) => at[i] === cell));

  /** How many of a message each cell has of its senders, of its receivers, and of all. */
  function counts({ each, toAll, taking, remote }, cell) {
    const held = taking ? each.map((number, i) => number * remote[i]) : toAll;
    const home = (i) => Number(at[i] === cell);
    // Those on the sender's own host hear nothing; what is passed on goes to all others, also there.
    const takes = taking ?? at.map(() => 1);
    const [takers, many] = [within(takes, cell), sum(takes)];
    const received = taking
      ? each.map((number, i) => number * (takers - home(i) * (many - remote[i])))
      : toAll.map((number, i) => (number * (takers - home(i))) / (at.length - 1));
    return { held: within(held, cell), received: sum(received), every: sum(held), paired: Boolean(taking) };
  }

  const known = shares({ messages: rows, inside: [] }, all).shares.map((share) => cells.map((cell) => counts(share, cell)));

  return ({ protocol, rows: costs }, window) =>
    cells.map((cell) =>
      protocol.messages.reduce((total, { hops, cast, sent }, row) => {
        const { held, received, every, paired } = known[row][cell];
        const up = rows[row].unit[1] === "other process" && hops !== "up down" ? received : held;
        const down = hops !== "up down" ? up : cast === "unicast" && paired ? received : every;
        return total + (sent[window] && sent[window] * (up * costs[row].up + down * costs[row].down));
      }, 0),
    );
}
