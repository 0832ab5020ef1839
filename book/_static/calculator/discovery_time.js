// The discovery time of a fleet in several runs, and the sentences on it: as discostorm_planner.discovery_time,
// discovery and answer_text have them. Sentences and limits come from the package (model.js).
"use strict";

const DiscoveryTimes = (({ discovery: RULES, sentences: SENTENCES }) => {
  const { SPACE, longTime, seconds, share } = TimeWords;
  const ascending = (values) => [...Float64Array.from(values).sort()];

  function median(values) {
    const sorted = ascending(values);
    return (sorted[Math.floor((sorted.length - 1) / 2)] + sorted[Math.ceil((sorted.length - 1) / 2)]) / 2;
  }

  // ---- numbers ----

  /** What several runs say together, from a time on. Without recovery a run ends when the channel falls idle. */
  function ofRuns(runs, { recovery, until, begin = 0 }) {
    const end = ({ converged, drained }) => (recovery ? converged : drained) - begin;
    const inOrder = [...runs].sort((one, other) => (end(one) < end(other) ? -1 : Number(end(one) > end(other))));
    const times = inOrder.map(end);
    const cut = Number(times.length >= RULES.runs);
    const pairs = ascending(runs.map(({ done }) => done).filter((done) => !Number.isNaN(done)));
    const lost = median(runs.map((run) => run.lost));
    return {
      times,
      pairs,
      median: median(times),
      interval: [times[cut], times[times.length - 1 - cut]],
      nine: times[Math.ceil(0.9 * times.length) - 1],
      // Of the runs without an expired lease.
      nineGood: ascending(inOrder.map((run) => (run.expired ? Infinity : end(run))))[Math.ceil(0.9 * times.length) - 1],
      mostPairs: median(runs.map(({ most }) => most)),
      lost,
      lostAt: [0, 1, 2].map((where) => median(runs.map(({ lostAt }) => lostAt[where]))),
      expired: inOrder.map(({ expired }) => expired),
      forgetful: runs.filter((run) => end(run) < Infinity && run.expired > 0).length,
      until,
      repaired: recovery,
      isLowerBound: !recovery && lost > 0,
    };
  }

  /** Whether the first run of a long job ends with so few pairs that no other is simulated. */
  const isHopeless = ({ converged, drained, done }, recovery) => (recovery ? converged : drained) === Infinity && done < RULES.near;

  /** Whether nine of ten runs are complete within a time, and no lease expires in these. */
  const works = ({ nineGood, isLowerBound }, within) => nineGood <= within && !isLowerBound;

  function isShorter(time, than) {
    if (time.median === Infinity) return time.pairs.length > 0 && than.pairs.length > 0 && time.pairs[0] > than.pairs.at(-1) && than.median === Infinity;
    return than.interval[0] === Infinity || (time.interval[1] < than.interval[0] && time.median < (1 - RULES.min_gain) * than.median);
  }

  /** Whether so many messages are lost that simulations of the product may be wrong. */
  const isCautious = ({ time, caution }) => Boolean(caution) && time.lost > RULES.few_lost;

  /** Whether the startup works with a change, also if reality is as slow as measured. */
  const suffices = ({ time, caution, ratios }, within) => works(time, within / Math.max(1, ratios.high)) && !isCautious({ time, caution });

  /** Why the startup may not work with a change with which it does in simulations; `said` is known already. */
  function doubt(change, within, said) {
    const { time, caution, ratios } = change;
    if (!works(time, within) || suffices(change, within)) return "";
    if (isCautious(change)) return caution === said ? "" : say("doubtful", { caution });
    return say("perhaps", { slow: seconds(ratios.high * time.nineGood) });
  }

  /** By the first part in which lists of numbers differ. */
  const by = (key) => (one, other) => {
    const [mine, theirs] = [key(one), key(other)];
    const place = mine.findIndex((part, i) => part !== theirs[i]);
    return place < 0 ? 0 : mine[place] < theirs[place] ? -1 : 1;
  };

  /** By the median; without one, the most completed pairs first: discostorm_planner.discovery_time.DiscoveryTime.rank. */
  const rank = ({ time }) => [time.median, time.nine, -median(time.pairs.length ? time.pairs : [0])];
  const byRank = by(rank);

  /** In the order of advice: what suffices first, by its effort. */
  function compare(within) {
    const level = (change) => Number(change.time.median === Infinity) - Number(works(change.time, within)) - Number(suffices(change, within));
    return by((change) => [level(change), Number(!isEasy(change)), change.effort, ...rank(change)]);
  }

  /** Whether today's startup works, and nothing speaks against the simulation. */
  const surelyWorks = ({ today, within, caution, ratios }) => today !== null && suffices({ time: today, caution, ratios }, within);

  /** Whether a combination does not suffice, and a part of it is just as good. */
  function isNoBetterThanPart(change, changes, within) {
    if (change.kind !== "combination" || suffices(change, within)) return false;
    const isPart = ({ steps, time }) => time && steps.length < change.steps.length && steps.every((step) => change.steps.includes(step));
    return changes.some((part) => isPart(part) && byRank(part, change) <= 0);
  }

  /** The changes that shorten discovery by more than the runs scatter; where it is not sure to work, those with which it is. */
  const helpful = ({ today, changes, within, caution, ratios }) =>
    changes.filter((change) => {
      const { time } = change;
      if (!time || time.isLowerBound || isNoBetterThanPart(change, changes, within)) return false;
      if (today ? isShorter(time, today) : time.median < Infinity) return true;
      return !surelyWorks({ today, within, caution, ratios }) && suffices(change, within);
    });

  /** Whether a change needs no other software. */
  const isEasy = ({ efforts }) => !efforts.some((name) => RULES.other_software.includes(name));

  /** The helpful changes after which the fleet works, and whether it does without other software. */
  const sufficient = (found) => helpful(found).filter((change) => suffices(change, found.within));
  const isEasily = (found) => (found.today !== null && works(found.today, found.within)) || sufficient(found).some(isEasy);

  /** The first of all servers, of all routers, and of each other kind; all combinations. */
  function ofDifferentKinds(changes) {
    const seen = new Set();
    return changes.filter(({ kind }) => {
      const like = ["discovery server", "router"].find((name) => kind.includes(name)) ?? kind;
      return kind === "combination" || (!seen.has(like) && seen.add(like));
    });
  }

  // ---- words ----

  /** The name of a protocol or channel as it reads within a sentence. */
  const inWords = (name) => SENTENCES[name] ?? name;
  const say = (key, values = {}) => SENTENCES[key].replace(/\{(\w+)\}/g, (whole, name) => values[name]);

  /** A discovery time with its interval, or how far it got. */
  function timeWords(time) {
    if (time.median === Infinity) {
      const [low, high] = [share(time.pairs[0] ?? 0), share(time.pairs.at(-1) ?? 0)];
      return `never (${low === high ? low : low.startsWith("less") ? `at most ${high}` : `${low} to ${high}`} of pairs complete)`;
    }
    let text = seconds(time.median);
    const [low, high] = time.interval.map(seconds);
    const [number, unit] = low.split(SPACE);
    const least = high.endsWith(SPACE + unit) ? number : low;
    if (low !== high) text += time.interval[1] === Infinity ? ` (${low} or more)` : ` (${least} to ${high})`;
    if (time.isLowerBound) return `${text} or longer, with ${share(time.lost)} of the messages lost`;
    return time.repaired ? text : `${text}, with nothing lost`;
  }

  /** The runs that `nine` counts: all, if there are fewer than ten. */
  const mostRuns = (runs) => (runs >= RULES.runs ? "nine of ten runs" : runs === 2 ? "both runs" : `all ${runs} runs`);

  /** The discovery time after a change, in how many runs leases expire, and that after the smallest change that is enough. */
  function afterWords({ time, enough }) {
    const { forgetful, times } = time;
    const words = forgetful ? say("leases", { time: timeWords(time), forgetful, runs: times.length }) : timeWords(time);
    return enough ? say("enough", { time: timeWords(enough.time), least: words }) : words;
  }

  /** Name a change, or the smallest such change that is enough. */
  const whatWords = ({ what, enough }) => enough?.what ?? what;

  function causes(time, steady, values) {
    if (steady >= 1) return say("periodic traffic fills");
    const most = Math.max(...time.lostAt);
    const losses = ["robots lose", "access point loses", "air loses"][time.lostAt.indexOf(most)];
    return [most ? say(losses, values) : "", !time.forgetful && median(time.expired) > RULES.many_expired ? say("leases end") : ""].filter(Boolean).join(" ");
  }

  /** The verdict, how good it is (0 works, 1 not sure, 2 too slow, 3 never), and the sentences below. */
  function verdict({ today, reason, within, fleet, protocol, wifi, caution, ratios, drain, steady }) {
    const how = `${inWords(protocol)}, on ${wifi}`;
    const values = { fleet, how, within: seconds(within), drain: seconds(drain), protocol: inWords(protocol) };
    if (!today) {
      const [key, grade] = drain === Infinity ? ["endless", 3] : drain > within ? ["too busy", 2] : ["unknown", 1];
      return { grade, title: say(key, values), lines: [say("not simulated", { reason })] };
    }
    const late = today.times.filter((time) => time === Infinity).length;
    const [middle, nine] = [seconds(today.median), seconds(today.nine)];
    Object.assign(values, { until: seconds(today.until), median: middle, nine, lost: share(today.lost), runs: today.times.length, late });
    values.forgetful = today.forgetful;
    values.most = mostRuns(values.runs);
    if (today.isLowerBound && today.median < Infinity) {
      const slow = today.median > within;
      return { grade: slow ? 2 : 1, title: say(slow ? "unrepaired and slow" : "unrepaired", values), lines: [say("busy", values)] };
    }
    const [fine, lines] = [works(today, within), []];
    const stop = fine || (today.nine < Infinity && today.lost <= RULES.few_lost) ? [] : [causes(today, steady, values)];
    if (today.median === Infinity) {
      if (today.pairs.length) lines.push(say("share of pairs", { ...values, share: share(median(today.pairs)) }));
      const missed = within < today.until ? "never in time" : "never";
      return { grade: 3, title: say(late < today.times.length ? "seldom" : missed, values), lines: [...lines, ...stop] };
    }
    const sure = suffices({ time: today, caution, ratios }, within);
    const failed = today.nine > within ? "too slow" : "forgotten";
    const [omitted, slow] = [isCautious({ time: today, caution }), seconds(ratios.high * today.nineGood)];
    const slower = say(ratios.measured ? "slower" : "slower elsewhere", { measured: ratios.measured, times: Number(Number(ratios.high).toPrecision(2)), slow });
    const title = say(!fine ? failed : sure ? "works" : omitted ? "works in simulations" : "probably", { ...values, caution, slower });
    let times = say(today.nine === Infinity ? "times of some" : values.runs > 1 ? "times" : "time of one", values);
    if (today.mostPairs < Infinity) times += ` ${say("most pairs", { share: share(RULES.most_pairs), time: seconds(today.mostPairs) })}`;
    return { grade: !fine ? 2 : sure ? 0 : 1, title, lines: [times, ...stop] };
  }

  /** How long all take to know a robot that starts later, and how good that is. */
  function late(time, within) {
    if (!time) return { grade: 1, title: say("no reboot") };
    const { median: middle, forgetful, times } = time;
    if (middle === Infinity) return { grade: 3, title: say("not known again") };
    const kept = say(forgetful ? "not kept" : "kept", { forgetful, runs: times.length });
    return { grade: Number(!works(time, within)) * 2, title: say("reboot", { time: seconds(middle), kept }) };
  }

  /** How the changes are listed: titles, each with its changes, and what is said of the others: answer_text._change_blocks. */
  function advice({ today, changes, within, caution, ratios, fewer }) {
    const known = helpful({ today, changes, within, caution, ratios }).sort(compare(within));
    const enough = known.filter((change) => suffices(change, within));
    const fine = surelyWorks({ today, within, caution, ratios });
    const good = today !== null && works(today, within);
    const best = enough.length && !fine ? enough : known;
    const shown = ofDifferentKinds(best).slice(0, RULES.shown);
    const near = ({ time }) => median(time.pairs.length ? time.pairs : [1]) >= RULES.near;
    const tried = changes.filter(({ time }) => time).length;
    const values = { within: seconds(within), until: seconds(Math.max(within, RULES.within)), count: tried };
    const blocks = [];
    const block = (title, rows) => blocks.push({ title: say(title, values), rows });
    const few = fewer && { fewer: say("fewer", { ...fewer, time: timeWords(fewer.time) }) };
    if (few && !enough.length) blocks.push({ title: say("stopgap", few), rows: [] });
    if (!known.length) block(tried ? "none helps" : "none known", []);
    else if (fine || !enough.length) {
      const rows = shown.some(near) ? shown.filter(near) : known.filter(near).sort(byRank).slice(0, 1);
      const unsure = good || known.some(({ time }) => works(time, within));
      block(!rows.length ? "none near" : fine ? "faster" : unsure ? "not sure either" : "shorter", rows);
    } else {
      const first = good ? shown.length : 1;
      block(good ? "covered" : "first", shown.slice(0, first));
      if (few) blocks.push({ title: say("until then", few), rows: [] });
      const easier = good || isEasy(shown[0]) ? [] : known.filter((change) => isEasy(change) && near(change)).slice(0, 1);
      if (easier.length) block(works(easier[0].time, within) ? "easier, perhaps" : "easier", easier);
      if (shown.length > first) block("then", shown.slice(first));
    }
    const named = blocks.flatMap(({ rows }) => rows);
    const name = (change) => `${whatWords(change)}, ${afterWords(change)}`;
    const list = (key, some) => (some.length ? [say(key, { names: some.map(name).join("; ") })] : []);
    const others = changes.filter((change) => !known.includes(change));
    const timed = others.filter(({ time }) => time);
    const reasons = [...new Set(others.map(({ reason }) => reason).filter(Boolean))];
    const mayHelp = timed.filter(({ time }) => time.isLowerBound && time.lost < RULES.many_lost && time.median <= within);
    const possible = fine || enough.length ? [] : mayHelp.slice(0, 1);
    return {
      blocks,
      more: known.filter((change) => !named.includes(change)),
      possible: [...list("possible", possible), ...(tried && !fine && !enough.length ? [say("several at once")] : [])],
      rest: [
        ...list("others", timed.filter(({ time }) => !time.isLowerBound)),
        ...list("bounds", timed.filter((change) => change.time.isLowerBound && !possible.includes(change))),
        ...reasons.map((reason) => say("left out", { reason, names: others.filter((change) => change.reason === reason).map(({ what }) => what).join("; ") })),
      ],
    };
  }

  /** How the times were found, and what would make them surer. */
  function certainty({ today, changes, protocol, hosts, captured, rounded, within, caution, ratios, server, cells }) {
    const all = [today, ...changes.map(({ time }) => time)].filter(Boolean);
    if (!all.length) return [];
    const counts = [...new Set(all.map(({ times }) => times.length))].sort((one, other) => other - one);
    const ranged = counts.filter((runs) => runs > 1);
    const intervals = ranged.map((runs) => say(runs >= RULES.runs ? "most runs" : runs > 2 ? "all runs" : "both runs", { runs }));
    const interval = intervals.length > 1 ? `${intervals[0]} or, with fewer runs, all of them` : intervals[0];
    const more = counts.slice(1).map((runs) => say(runs > 1 ? "long runs" : "hopeless run", { runs }));
    const told = `${counts[0]} run${counts[0] === 1 ? "" : "s"}${more.length ? ` (${more.join(", ")})` : ""}`;
    const until = seconds(all[0].until);
    const sure = [say("sure", { runs: told, until }), ...(interval ? [say("ranges", { interval })] : []), say(cells > 1 ? "assumed of cells" : "assumed")];
    if (all.some((time) => time.median === Infinity)) sure.push(say("never means", { until }));
    if (captured && hosts > captured) sure.push(say("extrapolated", { protocol: inWords(protocol), hosts: `${captured} host${captured === 1 ? "" : "s"}` }));
    const named = (of) => ({ ...of, measured: inWords(of.measured) });
    if (today?.median < Infinity) sure.push(say(ratios.measured ? "air" : "not compared", named(ratios)));
    const longer = today?.median < Infinity && ratios.measured && today.median > Number(ratios.seconds);
    const known = { today, changes, within, caution, ratios };
    const shown = sufficient(known).length ? sufficient(known) : helpful(known);
    if (shown.some((change) => change.ratios === server)) sure.push(say(server.measured ? "air" : "server not compared", named(server)));
    if (longer) sure.push(say("watched", ratios));
    for (const { name, ...ends } of rounded) {
      const [mean, whole] = [ends.mean.toFixed(1), ends.whole.toFixed(1)];
      if (mean !== whole) sure.push(say("rounded", { name, mean, whole }));
    }
    return sure;
  }

  return { ofRuns, isHopeless, suffices, doubt, byRank, surelyWorks, sufficient, isEasily, late, verdict, advice, certainty, timeWords, whatWords, afterWords, seconds, longTime, inWords, say };
})(DISCOSTORM);
