// The runs behind the calculator's answer: today's fleet and what changes make of it, with the same seeds, numbers
// of runs and limits as discostorm_planner.change_simulation, in a worker. The limits are the package's (model.js).
"use strict";

const FleetSimulation = (RULES, folder) => {
  const known = new Map(); // discovery times by setting: what was simulated once is not simulated again
  let asked = 0; // so that nothing of earlier entries is shown
  let current = null; // the run under way
  let loading = null;

  // What is drawn has at most so many hosts and transmissions; numbers of each; steps between looks, and looks in a share.
  const [MOST_HOSTS, MOST_ROWS, ROW, STEPS, LOOKS] = [40, 400_000, 6, 60, 50];

  function script(address) {
    return new Promise((done, failed) => {
      const element = document.createElement("script");
      element.src = address;
      element.onload = done;
      element.onerror = () => failed(new Error("the simulator does not load; reload the page"));
      document.head.append(element);
    });
  }

  /** Load the simulator, and the tables and radios that only changes need. */
  function load() {
    loading ??= (async () => {
      await script(`${folder}../live/live.js`);
      const tables = await Live.load();
      await script(`${folder}changed_tables.js`);
      return tables;
    })();
    return loading;
  }

  // ---- what is simulated ----

  const fleetOf = (swarm) => ({ groups: FleetFile.groupsOf(swarm), matching: swarm.names === 2 ? 1 : 0 });

  /** How long a run is estimated to take [s], and how much memory [MB]: as discostorm_simulation.run has it. */
  function estimate({ fleet, table: name, radio, recovery, queue, until, within, start }, data) {
    const { constants, layouts, tables, radios } = data;
    const { traffic, reserve } = liveSetup(data);
    const [{ population }, { fractions }] = [liveTraffic(), liveChance()];
    const [all, table, wifi] = [population(fleet), tables[name], radios[radio]];
    const recovering = recovery ? table.recovering : table.alone;
    const { repairs, bursts } = recovering;
    const sent = traffic(table, recovering, wifi, all);
    const [kinds, count, hosts] = [sent.rows.length, all.processes.length, all.sizes.length];
    const total = (numbers) => {
      const sums = sent.rows.map(() => 0);
      numbers.forEach((number, i) => (sums[i % kinds] += number));
      return sums;
    };
    const [each, toAll] = [total(sent.each), total(sent.toAll)];
    const remote = count - count / hosts;
    const ofRow = sent.rows.map(({ to_all: all }, row) => (all ? toAll[row] : remote * each[row]));
    const sum = (rows) => rows.reduce((found, row) => found + ofRow[row], 0);
    const frames = sum([...ofRow.keys()]);
    const draw = fractions(0, []);
    const starts = within ? Array.from({ length: hosts }, () => within * draw()) : [start].flat();
    const span = (recovery ? until : 0) + Math.max(...starts) - Math.min(...starts);
    let again = 0;
    bursts.periods.forEach((period, number) => (again += period ? (span * sum(bursts.messages[number])) / (period * constants.TICK) : 0));
    const held = Math.min(frames, queue[0] * (1 + hosts));
    let [looks, pairs, carried] = [0, 0, Math.min(frames, 4 * held)];
    if (repairs) {
      carried = frames;
      const broadcast = [...ofRow.keys()].filter((row) => sent.rows[row].to_all);
      const period = (repairs.announce_interval_max ?? 0) * constants.TICK;
      if (period) again += (span * sum(broadcast.length ? broadcast : [0])) / period;
      looks = (count ** 2 * span) / (repairs.lease * constants.TICK);
      let items = 0;
      for (let first = 0; first < sent.each.length; first += kinds) {
        const own = sent.rows.reduce((found, { role }, row) => found + (role === constants.DATA ? sent.each[first + row] : 0), 0);
        items = Math.max(items, own);
      }
      pairs = count ** 2 * (layouts.pairs.size + Math.floor(items / 8));
    }
    const entries = reserve(sent, repairs, wifi.record.window, all) * (layouts.pool.size + layouts.events.size);
    return { seconds: (4 * (carried + again) + looks) * 1e-7, megabytes: (pairs + held * layouts.pool.size + entries) / 1e6 };
  }

  /** The runs of a fleet with a middleware on a channel, or why it cannot be simulated. */
  function jobOf({ name, air, fleet, window = 0 }, within, data) {
    const radio = (air.full ?? air).name; // a radio that aggregates does so
    if (fleet.N_H * fleet.N_P + fleet.N_H1 * fleet.N_P1 > RULES.max_processes) return { reason: RULES.too_large };
    if (!(radio in data.radios)) return { reason: "rates and overheads of your own can be counted, but not simulated" };
    if (!(name in data.tables)) return { reason: "this page does not know its messages" };
    const setting = {
      table: name,
      radio,
      recovery: !data.tables[name].recovering.refused,
      fleet: fleetOf(fleet),
      queue: RULES.queue,
      until: Math.max(within, RULES.within),
      giveUp: RULES.give_up * Math.max(1, within / RULES.within),
      within: window,
      start: 0,
      seed: RULES.seed,
    };
    return sized(setting, data);
  }

  /** The runs of a setting, or why these cannot be simulated. */
  function sized(setting, data) {
    try {
      const { seconds, megabytes } = estimate(setting, data);
      if (seconds > RULES.max_seconds || megabytes > RULES.max_megabytes) return { reason: RULES.too_large };
      const runs = seconds > RULES.long_run ? RULES.few_runs : RULES.runs;
      return { setting, runs, seconds, work: runs * seconds, first: firstRuns(runs, seconds) * seconds };
    } catch (error) {
      return { reason: error.message };
    }
  }

  /** After how many runs it is decided whether there are more: discostorm_planner.simulation_jobs.Job.first_runs. */
  const firstRuns = (runs, seconds) => (runs * seconds > RULES.long_run ? 1 : runs);

  /** The runs in which one robot starts when all others have finished: discostorm_planner.change_simulation.simulate_late_join. */
  function lateJob({ setting }, { times, repaired }, data) {
    const begin = Math.ceil(times.at(-1));
    if (!begin || begin === Infinity || !repaired) return null;
    const { groups } = setting.fleet;
    const robots = groups.map(({ processes, wired }) => (wired ? 0 : processes));
    const most = robots.indexOf(Math.max(...robots));
    const start = groups.flatMap(({ hosts }, group) => Array.from({ length: hosts }, (_, host) => begin * (group === most && host === hosts - 1)));
    return sized({ ...setting, start, begin }, data);
  }

  // ---- the runs ----

  /** The discovery time of a job, or why it is not known; null if the entries changed meanwhile. */
  async function timeOf({ setting, runs, seconds }, mine, progress) {
    const key = JSON.stringify([setting, runs]);
    if (known.has(key)) return known.get(key);
    const found = [];
    try {
      while (found.length < runs) {
        current = Live.run({ ...setting, run: found.length });
        const result = await current.found;
        if (mine !== asked || !result) return null;
        found.push(result);
        progress(found.length / runs);
        if (found.length === firstRuns(runs, seconds) && found.length < runs && DiscoveryTimes.isHopeless(result, setting.recovery)) break;
      }
    } catch (error) {
      return mine === asked ? { reason: error.message } : null;
    }
    const time = DiscoveryTimes.ofRuns(found, setting);
    const answer = time.median === Infinity && !setting.recovery ? { reason: `repairs are not simulated with ${setting.table}` } : { time };
    known.set(key, answer);
    return answer;
  }

  /** The largest number between two others that suffices, and its time, by halving: discostorm_planner.change_simulation._bisect_largest. */
  async function most(low, high, job, suffices, mine, show) {
    const timed = async (count, runs) => {
      const own = job(count);
      if (own.reason || own.work > RULES.max_work) return null;
      const answer = await timeOf({ ...own, runs: Math.min(runs, own.runs) }, mine, show);
      return answer?.time && suffices(answer.time) ? answer.time : null;
    };
    const least = low;
    while (high - low > 1 && mine === asked) {
      const middle = Math.floor((low + high) / 2);
      if (await timed(middle, RULES.few_runs)) low = middle;
      else high = middle;
    }
    for (let count = low; count > least && mine === asked; count--) {
      const time = await timed(count, RULES.runs);
      if (time) return { count, time };
    }
    return null;
  }

  /** How many hosts of the group with most processes suffice, beside all others; which group that is, of how many, and how many hosts each group has. */
  async function fewerHosts({ setting }, { caution, ratios }, within, data, mine, show) {
    const { groups } = setting.fleet;
    const sizes = groups.map(({ hosts, processes, wired }) => (wired ? 0 : hosts * processes));
    const place = sizes.indexOf(Math.max(...sizes));
    const { hosts } = groups[place];
    const job = (count) => sized({ ...setting, fleet: { ...setting.fleet, groups: groups.map((group, i) => (i === place ? { ...group, hosts: count } : group)) } }, data);
    // No host discovers itself.
    const found = await most(groups.length === 1 ? 1 : 0, hosts, job, (time) => DiscoveryTimes.suffices({ time, caution, ratios }, within), mine, show);
    return found && { ...found, place, hosts, others: groups.map((group) => group.hosts) };
  }

  /** What the first run of a job sends until discovery is complete; null if that is too much to draw. */
  async function drawn({ setting }) {
    const hosts = setting.fleet.groups.reduce((sum, group) => sum + group.hosts, 0);
    if (hosts > MOST_HOSTS || setting.fleet.groups.some(({ cell, wired }) => cell || wired)) return null;
    const shares = [];
    let many = 0;
    const each = (share) => {
      many += share.rows.length / ROW;
      if (many > MOST_ROWS) current.stop();
      else shares.push(share);
    };
    current = Live.run({ ...setting, run: 0 }, { each, steps: STEPS, looks: LOOKS, until: "complete", log: true });
    const result = await current.found;
    return result && { ...Show.collected(shares), hosts, converged: result.converged, until: setting.until };
  }

  /** Simulate today's fleet, then one that reboots if it does, then each change, then the best of these with a staggered
   * start if none suffices, then how much of one is enough; call `show` with what is known, as soon as there is more.
   * `planned` says the window of starts [s], the changes, or why there are none, and which to join with a staggered
   * start, from a function that tells the airtime of a fleet's cells. */
  async function simulate(today, planned, within, show) {
    const mine = ++asked;
    current?.stop();
    const found = { today: null, reason: "", changes: [], left: [], part: 0, begun: true };
    try {
      const data = await load();
      if (mine !== asked) return;
      const airtimeOf = (name, fleet) => CellAirtime({ fleet: fleetOf(fleet), table: name }, data.tables);
      let job = jobOf(today, within, data);
      if (job.setting && FleetFile.byCell(today.fleet)) found.airtime = airtimeOf(today.name, today.fleet);
      const { changes, closest, window, reason: endless } = planned(job.reason ? null : airtimeOf);
      if (endless) job = { reason: endless };
      else if (window) job = jobOf({ ...today, window }, within, data);
      const ofChange = (change) => jobOf({ ...change, window: change.window || window }, within, data);
      let [total, done] = [job.work ?? 0, 0];
      /** Changes with their runs, as far as there is time for these. */
      const prepared = (some) => {
        const jobs = some.map((change) => [change, ofChange(change)]);
        let room = RULES.max_work;
        for (const own of jobs.map(([, job]) => job).filter(({ reason }) => !reason).sort((one, other) => one.first - other.first)) {
          room -= own.first;
          if (room < 0) Object.assign(own, { reason: RULES.too_large });
          else total += own.work;
        }
        found.left = [...some];
        return jobs;
      };
      const run = async (own) => {
        if (own.reason) return own;
        const answer = await timeOf(own, mine, (part) => show({ ...found, part: (done + part * own.work) / total }, true));
        done += own.work;
        return answer;
      };
      /** Simulate changes one after the other; whether the entries are still the same. */
      const runAll = async (jobs) => {
        for (const [change, own] of jobs) {
          show({ ...found, part: total ? done / total : 1 });
          const answer = await run(own);
          if (!answer || mine !== asked) return false;
          found.left.shift();
          found.changes = [...found.changes, { ...change, time: answer.time, reason: answer.reason ?? "" }];
        }
        return true;
      };
      const singles = prepared(changes);
      const first = await run(job);
      if (!first || mine !== asked) return;
      const again = today.reboots && first.time && lateJob(job, first.time, data);
      const late = again && (again.reason ? again : await timeOf(again, mine, (part) => show({ ...found, part }, true)));
      if (mine !== asked) return;
      Object.assign(found, { today: first.time ?? null, late: late?.time ?? null, reason: first.reason ?? "", known: true });
      if (first.time) {
        const sent = await drawn(job);
        if (mine !== asked) return;
        Object.assign(found, { sent });
      }
      const answered = () => ({ ...found, within, caution: today.caution, ratios: today.ratios });
      const works = () => DiscoveryTimes.surelyWorks(answered());
      if (!(await runAll(singles))) return;
      for (const switches of [false, true]) {
        if (works() || DiscoveryTimes.sufficient(answered()).length) break;
        if (!(await runAll(prepared(closest(found.changes, switches))))) return;
      }
      show({ ...found, part: null });
      const onlyPart = () => show({ ...found, part: null }, true);
      if (!works()) {
        for (const change of found.changes) {
          if (!change.into || !change.time || !DiscoveryTimes.suffices(change, within)) continue;
          const suffices = (time) => DiscoveryTimes.suffices({ ...change, time }, within);
          const { high, of } = change.into;
          const enough = await most(1, high, (count) => ofChange({ ...change, ...of(count) }), suffices, mine, onlyPart);
          if (mine !== asked) return;
          if (enough) change.enough = { what: of(enough.count).what, time: enough.time };
        }
      }
      if (found.today && !DiscoveryTimes.isEasily(answered())) {
        found.fewer = await fewerHosts(job, today, within, data, mine, onlyPart);
        if (mine !== asked) return;
      }
      show({ ...found, part: 1, over: true });
    } catch (error) {
      if (mine === asked) show({ ...found, reason: error.message, known: true, left: [], part: 1, over: true });
    }
  }

  /** Drop what is under way: its entries are old, or the reader wants no more. */
  function stop() {
    asked++;
    current?.stop();
    current = null;
  }
  return { simulate, stop };
};
