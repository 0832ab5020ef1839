// The calculator's fleet as groups to simulate, and as a file for `discostorm plan`, which gives the same answer.
"use strict";

const FleetFile = (() => {
  const entries = (pairs) => Object.entries(pairs).flatMap(([key, value]) => (value === undefined ? [] : `${key} = ${JSON.stringify(value)}`));
  const table = (name, pairs) => ["", `[[${name}]]`, ...entries(pairs)];

  /** Return whether airtime is counted cell by cell, as the formulas have all hosts on one Wi-Fi. */
  const byCell = ({ cells, wired }) => cells > 1 || wired;

  /** Spread hosts evenly over cells: how many are in each. */
  const spread = (hosts, cells) => Array.from({ length: cells }, (_, cell) => Math.floor(hosts / cells) + Number(cell < hosts % cells));

  const even = (number) => Math.round(number) - (Math.abs(number % 1) === 0.5 && Math.round(number) % 2 ? 1 : 0);
  /** Processes that have so many endpoints together, each a whole number: discostorm.host_group.even_sizes. */
  const evenSizes = ([processes, endpoints]) => Array.from({ length: processes }, (_, i) => Math.floor(endpoints / processes) + Number(i < endpoints % processes));

  /** The groups of a fleet, with whole endpoints; robots are spread evenly over cells, others are in the first or wired. */
  function groupsOf({ N_H, N_P, N_E, N_S, N_H1, N_P1, N_E1, N_S1, cells, sizes, wired }) {
    const group = (hosts, processes, mean, shared, parts) => {
      const endpoints = (parts ?? [[processes, even(processes * mean)]]).flatMap(evenSizes);
      return { hosts, processes, endpoints, shared: Math.min(shared, ...endpoints), cell: 0 };
    };
    const robots = group(N_H, N_P, N_E, N_S, sizes);
    const each = spread(N_H, cells).map((hosts, cell) => ({ ...robots, hosts, cell }));
    return N_H1 ? [...each, { ...group(N_H1, N_P1, N_E1, N_S1), wired }] : each;
  }

  /** Several access points in words, as discostorm_planner.multi_cell_plan has them. */
  function joined(cells) {
    const all = names(cells).map((name) => `"${name}"`);
    return `${all.slice(0, -1).join(", ")} and ${all.at(-1)}`;
  }

  const names = (cells) => Array.from({ length: cells }, (_, cell) => `AP ${cell + 1}`);

  /** The file of a fleet: its robots by the name of a ready-made one, if they are; other computers are wired, or at the first access point. */
  function text({ swarm, within, secure, ros }, { robot, others, nodes, wifi }) {
    const { N_H, N_P, N_E, N_S, N_H1, N_P1, N_E1, N_S1, cells, wired } = swarm;
    const several = cells > 1;
    const counts = robot ? { robot } : { processes: N_P, endpoints: N_E, shared: N_S };
    const at = names(cells);
    const lines = [
      ...entries({ within, ros: ros === "none" ? undefined : ros, matching: swarm.names === 2 ? 1 : undefined, security: secure || undefined }),
      ...(several ? at.flatMap((name) => table("cells", { name, wifi })) : []),
      ...spread(N_H, cells).flatMap((hosts, i) => table("groups", { name: several ? `robots at ${at[i]}` : "robots", hosts, ...counts, cell: several ? at[i] : undefined })),
      ...(N_H1 ? table("groups", { name: others, hosts: N_H1, processes: N_P1, endpoints: N_E1, nodes, shared: N_S1, ...(wired ? { wired } : { cell: several ? at[0] : undefined }) }) : []),
    ];
    return `${lines.join("\n")}\n`;
  }

  /** The command that reads it, with what it calls the middleware and the channel. */
  function command({ swarm }, middleware, wifi) {
    const channel = swarm.cells > 1 ? "" : ` --wifi '${wifi}'`;
    return `discostorm plan fleet.toml --protocol '${middleware}'${channel}`;
  }

  return { text, command, joined, names, groupsOf, byCell };
})();
