// The calculator page: reads the fields, shows the discovery time that simulate.js finds, and below it what the
// functions of model.js say of airtime. All formulas are in model.js, which is made from the Python package.
"use strict";

(() => {
  const MODEL = DISCOSTORM;
  const FOLDER = document.currentScript.src.replace(/[^/]*$/, "");
  const F = MODEL.formulas;
  // Names share what is equal.
  for (const protocol of new Set(Object.values(MODEL.protocols)))
    protocol.messages = protocol.messages.map((row) => Object.fromEntries(row.map((cell, i) => [MODEL.columns[i], cell])));
  const rank = (name) => MODEL.groups.indexOf(MODEL.protocols[name].group);
  // What can be chosen, in the order of the groups; the others are what changes make of these.
  const NAMES = Object.keys(MODEL.protocols).filter((name) => MODEL.protocols[name].group).sort((a, b) => rank(a) - rank(b));
  const [PAPER, OWN, NONE, LAPTOP] = ["paper", "own", "none", "laptop"];
  const [TOGETHER, IN_TURN, REBOOT] = ["together", "turn", "reboot"];
  // Curves and markers differ in shape too, not in color alone.
  const DASHES = [[], [9, 6], [2, 4], [9, 3, 2, 3], [14, 4]];
  const CURVE_POINTS = 120;
  // There are no half robots.
  const WHOLE_STEPS = Array.from({ length: 30 }, (_, i) => [1, 2, 5][i % 3] * 10 ** Math.floor(i / 3));
  // From a change of less than this on, remedies are not told apart, as in the planner.
  const NOTHING = 0.005;

  const byId = (id) => document.getElementById(`calc-${id}`);

  /** Make an element: attributes, then children, which are elements or text. */
  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  /** Make an element's children be like others: what is the same stays, or all would be styled and laid out anew. */
  function become(element, ...fresh) {
    const there = [...element.childNodes];
    fresh.forEach((child, i) => {
      const old = there[i];
      const node = child instanceof Node ? child : document.createTextNode(child);
      if (!old) element.append(node);
      else if (old.nodeName !== node.nodeName) old.replaceWith(node);
      else if (node instanceof Text) {
        if (old.data !== node.data) old.data = node.data;
      } else if (!old.isEqualNode(node)) {
        for (const { name } of [...old.attributes]) if (!node.hasAttribute(name)) old.removeAttribute(name);
        for (const { name, value } of node.attributes) if (old.getAttribute(name) !== value) old.setAttribute(name, value);
        become(old, ...node.childNodes);
      }
    });
    for (const old of there.slice(fresh.length)) old.remove();
  }

  // ---- numbers in words ----

  const digits = (most) => new Intl.NumberFormat("en-US", { maximumFractionDigits: most });
  const [whole, tenth] = [digits(0), digits(1)];
  const two = new Intl.NumberFormat("en-US", { maximumSignificantDigits: 2 });
  const three = new Intl.NumberFormat("en-US", { maximumSignificantDigits: 3 });

  /** A power of ten in print: 2·10⁷. */
  function power(value) {
    const [digit, exponent] = value.toExponential(0).split("e");
    const raised = [...String(Number(exponent))].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
    return `${digit === "1" ? "" : `${digit}·`}10${raised}`;
  }

  function number(value) {
    if (!Number.isFinite(value)) return "more than can be computed";
    if (value >= 1e9 || (value > 0 && value < 1e-6)) return power(value);
    return value >= 100 ? whole.format(value) : three.format(value);
  }

  // No line ends between a number and its unit.
  const SPACE = "\u00a0";
  /** What is below 100% is never shown as 100%; what is far beyond is told in channels. */
  function percent(share) {
    if (share > 10) return `${number(share)} times the channel`;
    if (share >= 1e7 || (share > 0 && share < 1e-8)) return `${number(100 * share)}%`;
    const text = two.format(100 * share);
    return share < 1 && text === "100" ? "just below 100%" : `${text}%`;
  }

  const [, , , MINUTE, HOUR, DAY, YEAR] = MODEL.times.map(([, length]) => length);
  /** A time as people tell it: 0.45 s, 58 minutes, 3 years. */
  function duration(seconds) {
    if (seconds === Infinity) return "indefinitely";
    if (seconds === 0) return "no time";
    const [, length, unit] = MODEL.times.findLast(([least]) => seconds >= least);
    const value = seconds / length;
    if (value >= 1e6) return `${power(value)}${SPACE}${unit}`;
    return `${value < 10 ? two.format(value) : whole.format(Number(value.toPrecision(3)))}${SPACE}${unit}`;
  }

  /** A range in words, with the unit once where both ends have it. */
  function between(low, high) {
    if (low === high) return low;
    const [number, unit] = low.split(SPACE);
    return `${unit && high.endsWith(`${SPACE}${unit}`) ? number : low} to ${high}`;
  }
  const durations = (low, high, never = "indefinitely") => between(...[low, high].map((end) => (end < Infinity ? duration(end) : never)));

  const count = (value) => (value < 1e9 && Number.isInteger(value) ? whole.format(value) : number(value));
  const plural = (value, one, many = `${one}s`) => `${count(value)}${SPACE}${value === 1 ? one : many}`;
  const decapitalized = (sentence) => sentence.charAt(0).toLowerCase() + sentence.slice(1, -1);
  const capitalized = (text) => text.charAt(0).toUpperCase() + text.slice(1);

  /** A number as shown, with all its digits and what it is of for machines. */
  const exact = (value, text, of) => make("data", { value: String(value), "data-of": of }, text);

  // ---- the fields ----

  const { swarm: SWARM, beside: BESIDE, own: LINKS, cells: [CELLS], target: [WITHIN] } = MODEL.fields;
  const FIELDS = [...SWARM, ...BESIDE, ...LINKS, CELLS, WITHIN];
  const robots = new Map(MODEL.robots.map((robot) => [robot.name, robot]));
  const channels = new Map(
    MODEL.channels.map((channel, index) => [index === 0 ? PAPER : channel.name, channel]),
  );

  function addField(parent, field) {
    const id = `calc-${field.name}`;
    const unit = field.unit ? ` [${field.unit}]` : "";
    const input = make("input", {
      id,
      name: field.name,
      type: "text",
      inputmode: "decimal",
      value: field.start,
      "aria-describedby": `${id}-error`,
    });
    parent.append(
      make(
        "div",
        { class: "calc-field" },
        make("label", { for: id }, field.label + unit),
        input,
        make("span", { class: "calc-error", id: `${id}-error`, role: "alert" }),
      ),
    );
  }

  /** Fill a list with groups of [value, text]; those without a heading come first. */
  function fill(select, groups) {
    for (const [label, options] of groups) {
      const parent = label ? make("optgroup", { label }) : select;
      for (const [value, text] of options) parent.append(make("option", { value }, text));
      if (label) select.append(parent);
    }
  }

  function choose(select, value) {
    for (const option of select.options) option.defaultSelected = option.value === value;
    select.value = value;
  }

  function buildForm() {
    fill(byId("robot"), [
      ["", [...robots.keys()].map((name) => [name, name])],
      ["", [[OWN, "My own numbers"]]],
    ]);
    choose(byId("robot"), MODEL.start.robot);
    fill(byId("beside"), [["", [[NONE, "Nothing"], [LAPTOP, "Laptop with RViz"], [OWN, "Others, by number"]]]]);
    choose(byId("beside"), LAPTOP);
    fill(byId("cable"), [["", [["0", "The same Wi-Fi"], ["1", "A cable to the access point"]]]]);
    choose(byId("cable"), "0");
    const of = (group) => NAMES.filter((name) => MODEL.protocols[name].group === group);
    fill(byId("middleware"), MODEL.groups.map((group) => [group, of(group).map((name) => [name, capitalized(name)])]).filter(([, names]) => names.length));
    fill(byId("matching"), [["", [["0", "A namespace for each robot"], ["1", "The same on all robots"]]]]);
    choose(byId("matching"), "0");
    choose(byId("middleware"), MODEL.start.middleware);
    fill(byId("security"), [["", [["0", "Off"], ["1", "On"]]]]);
    fill(byId("start"), [["", [[TOGETHER, "All together"], [IN_TURN, "One after the other"], [REBOOT, "One robot reboots"]]]]);
    choose(byId("security"), "0");
    choose(byId("start"), TOGETHER);
    fill(byId("ros"), [["", [[NONE, "Any"], ...Object.keys(MODEL.ros).reverse().map((name) => [name, capitalized(name)])]]]);
    choose(byId("ros"), MODEL.start.ros);
    const named = (model) =>
      [...channels].filter(([, channel]) => channel.model === model).map(([key, channel]) => [key, key === PAPER ? "The paper's, 802.11n" : channel.name]);
    fill(byId("channel"), [
      ["As in the paper", [...named("linear"), [OWN, "Own rates and overheads"]]],
      ["From the standard", named("padded")],
    ]);
    for (const field of SWARM) addField(byId("counts"), field);
    for (const field of BESIDE) addField(byId("others"), field);
    for (const field of LINKS) addField(byId("own"), field);
    addField(byId("several"), CELLS);
    addField(byId("target"), WITHIN);
  }

  const { byCell } = FleetFile;
  const LISTS = ["robot", "beside", "cable", "ros", "middleware", "channel", "matching", "security", "start"];
  const listName = (list) => (list === "channel" ? "wifi" : list);
  const chosen = (list) => byId(list).value;
  const usedFields = () => [
    ...SWARM,
    ...(chosen("beside") === NONE ? [] : chosen("beside") === OWN ? BESIDE : BESIDE.slice(0, 1)),
    ...(chosen("channel") === OWN ? LINKS : []),
    CELLS,
    WITHIN,
  ];

  const brief = (text) => (text.length > 24 ? `${text.slice(0, 24)}…` : text);

  /** Return the number that a text says, NaN if it is none; thousands may be parted. */
  function parsed(text) {
    const plain = /^\d{1,3}([, '_\u00a0\u202f]\d{3})+(\.\d*)?$/.test(text) ? text.replace(/[, '_\u00a0\u202f]/g, "") : text;
    return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(plain) ? Number(plain) : NaN;
  }

  /** Return the number in a field in SI units, or why there is none. */
  function readField(field) {
    const text = byId(field.name).value.trim();
    const value = parsed(text) * field.scale;
    const fits =
      (field.above ? value > field.low : value >= field.low) && value <= field.high && (!field.whole || Number.isInteger(value));
    if (fits && Number.isFinite(value)) return { value };
    const unit = field.unit ? ` of ${field.unit}` : "";
    const allowed = unit ? field.allowed.replace("number", `number${unit}`) : field.allowed;
    const got = text === "" ? "the field is empty" : `got “${brief(text)}”`;
    return { error: `${field.label} must be ${allowed}; ${got}.` };
  }

  function showError(name, error) {
    const element = byId(`${name}-error`);
    if (element.textContent !== error) element.textContent = error;
    const input = byId(name);
    input.parentElement.classList.toggle("calc-wrong", error !== "");
    if (error) input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }

  /** Return the settings, or null if one is not valid; each error is shown at its field. */
  function readForm() {
    const swarm = { N_H1: 0, N_P1: 1, N_E1: 0 };
    const link = {};
    const target = {};
    let valid = true;
    const used = usedFields();
    for (const field of FIELDS) {
      const { value, error } = used.includes(field) ? readField(field) : {};
      showError(field.name, error ?? "");
      if (error) valid = false;
      else if (value !== undefined) (LINKS.includes(field) ? link : field === WITHIN ? target : swarm)[field.symbol] = value;
    }
    if (valid && swarm.cells > swarm.N_H) {
      showError("cells", `${CELLS.label} must be at most as many as robots; got ${swarm.cells}.`);
      valid = false;
    }
    if (!valid) return null;
    if (chosen("beside") === LAPTOP) for (const field of BESIDE.slice(1)) swarm[field.symbol] = Number(field.start);
    const channel =
      chosen("channel") === OWN ? { name: OWN, model: "linear", values: link, remedies: [] } : channels.get(chosen("channel"));
    const robot = robots.get(chosen("robot"));
    swarm.sizes = robot?.parts.map(({ processes, endpoints }) => [processes, endpoints]);
    swarm.wired = swarm.N_H1 > 0 && chosen("cable") === "1";
    const guess = (endpoints) => (endpoints >= MODEL.service_endpoints ? 1 : 0);
    const nodes = [robot?.nodes ?? guess(swarm.N_E), chosen("beside") === LAPTOP ? MODEL.laptop_nodes : guess(swarm.N_E1)];
    const [ofProcess, withNode] = MODEL.shared_endpoints;
    const likely = (endpoints) => guess(endpoints) && Math.max(1, endpoints / MODEL.endpoints_of_a_node);
    const shared = (endpoints, known) => Math.min(endpoints, ofProcess + (withNode - ofProcess) * (known ?? likely(endpoints)));
    swarm.N_S = shared(swarm.N_E, robot?.nodes);
    swarm.N_S1 = swarm.N_H1 ? shared(swarm.N_E1, chosen("beside") === LAPTOP ? MODEL.laptop_nodes : undefined) : 0;
    // Which formulas count: nothing matches, what ROS 2 shares, or all.
    swarm.names = chosen("matching") === "1" ? 2 : swarm.N_S || swarm.N_S1 ? 1 : 0;
    return { middleware: chosen("middleware"), channel, swarm, nodes, ros: chosen("ros"), start: chosen("start"), secure: chosen("security") === "1", ...target, with: [] };
  }

  // ---- the answer: rows of model.js, each its functions, added up ----

  // What was asked before, by channel, then by name.
  const prices = new WeakMap();

  /** Return what each message of a table costs on a channel, and each unit in each window [s]. */
  function priced(name, channel) {
    if (!prices.has(channel)) prices.set(channel, {});
    return (prices.get(channel)[name] ??= price(name, channel));
  }

  function price(name, channel) {
    const protocol = MODEL.protocols[name];
    const rows = protocol.messages.map(({ hops, bytes, frames, cast }) => {
      const airtime = MODEL.airtime[frames ? channel.model : "inside"];
      const of = (hop, formula) => (hops.includes(hop) ? (frames || 1) * F[formula]({ ...channel.values, L: bytes }) : 0);
      return { up: of("up", airtime.up), down: of("down", airtime[cast]) };
    });
    const costs = {};
    for (const window of ["burst", ...Object.keys(protocol.windows)]) {
      costs[window] = protocol.units.map(() => 0);
      protocol.messages.forEach(({ unit, per_unit, sent }, i) => {
        costs[window][unit] += per_unit * sent[window] * (rows[i].up + rows[i].down);
      });
    }
    return { protocol, rows, costs };
  }

  /** Return the utilization of a window, or the airtime of the burst [s]. */
  function total({ protocol, costs }, window, swarm) {
    return protocol.units.reduce((sum, unit, i) => sum + (costs[window][i] && costs[window][i] * F[unit[swarm.names].count](swarm)), 0);
  }

  /** Return the number of robots at which the utilization of a window reaches the limit. */
  function saturation({ protocol, costs }, window, swarm) {
    // What each further robot adds: the polynomial's coefficients, that of the constant first.
    const powers = Array.from({ length: protocol.degree + 1 }, (_, power) =>
      protocol.units.reduce((sum, unit, i) => {
        const part = unit[swarm.names].more[power];
        return part && costs[window][i] ? sum + costs[window][i] * F[part](swarm) : sum;
      }, 0),
    );
    if (powers.slice(MODEL.saturation.length).some(Boolean)) return byNewton(powers, MODEL.limit);
    const [c, b, a] = powers;
    return F[MODEL.saturation[Math.min(protocol.degree, 2)]]({ c, b, a, U_limit: MODEL.limit });
  }

  /** The same where it has no closed form: from a number that is too large each step is down, none too far. */
  function byNewton([single, ...powers], limit) {
    const rest = limit - single;
    let more = Math.min(...powers.map((part, i) => (part ? (rest / part) ** (1 / (i + 1)) : Infinity)));
    for (let step = 0; step < 20; step++) {
      const taken = powers.reduce((sum, part, i) => sum + part * more ** (i + 1), -rest);
      const slope = powers.reduce((sum, part, i) => sum + (i + 1) * part * more ** i, 0);
      more -= taken / slope;
    }
    return 1 + more;
  }

  // ---- between the ends of a channel that aggregates ----

  /** A number with full A-MPDUs and with single frames. */
  function spanOf(name, channel, swarm, window) {
    const single = total(priced(name, channel), window, swarm);
    return { full: channel.full ? total(priced(name, channel.full), window, swarm) : single, single };
  }

  /** What it takes when one robot reboots, as `discostorm_planner.further_loads` has it; null if that was not measured. */
  function rebootOf(name, channel, swarm) {
    const factors = MODEL.protocols[name].reboot;
    const { N_H, N_P, N_H1, N_P1 } = swarm;
    const everyone = N_H * N_P + N_H1 * N_P1;
    const pairs = everyone ** 2 - (N_H * N_P ** 2 + N_H1 * N_P1 ** 2);
    if (!factors.length || pairs <= 0) return null;
    // Of both kinds the one that takes part in more pairs.
    const [own, other] = [N_P, N_H1 ? N_P1 : 0].map((processes) => 2 * processes * (everyone - processes));
    const start = spanOf(name, channel, swarm, "burst");
    const [low, high] = [Math.min, Math.max].map((end, i) => (end(start.full, start.single) * Math.max(own, other) * factors[i]) / pairs);
    return { low, high, other: other > own };
  }

  function answerOf(name, channel, swarm) {
    const single = atOneEnd(name, channel, swarm);
    return { ...single, full: channel.full ? atOneEnd(name, channel.full, swarm) : single };
  }

  function atOneEnd(name, channel, swarm) {
    const table = priced(name, channel);
    const { protocol, rows, costs } = table;
    const one = { ...swarm, N_H: 1 };
    const fitting = {};
    for (const window of Object.keys(protocol.windows)) {
      // As in Python: one robot must not exceed the limit, else there is no such number.
      const fits = total(table, window, one) <= MODEL.limit;
      const found = saturation(table, window, swarm);
      const full = fits ? (costs[window].some(Boolean) && !Number.isNaN(found) ? Math.max(1, found) : Infinity) : null;
      fitting[window] = { full, largest: full === null ? 0 : full < Infinity ? F[MODEL.largest]({ N_sat: full }) : Infinity };
    }
    const burst = total(table, "burst", swarm);
    const steady = total(table, "ever", swarm);
    const drain = F[MODEL.drain]({ B: burst, rho: steady });
    const { until, never } = protocol.outlooks;
    const found = drain < Infinity ? until.findIndex(([limit]) => drain <= limit) : -1;
    return {
      name,
      protocol,
      fitting,
      steady,
      drain,
      severity: found < 0 ? until.length : found,
      outlook: found < 0 ? never : until[found][1],
      utilization: total(table, "second", swarm),
      single: total(table, "second", one),
      at: (hosts) => total(table, "second", { ...swarm, N_H: hosts }),
      messages: protocol.messages.map((message, i) => {
        const load = message.per_unit * message.sent.second * F[protocol.units[message.unit][swarm.names].count](swarm);
        const [up, down] = [load * rows[i].up, load * rows[i].down];
        return { ...message, load, up, down, both: up + down };
      }),
    };
  }

  // Changes of the hosts, one function a kind: what it is called and what then is, null where it cannot be. Those of
  // tables and channels are in model.js.
  const FLEETS = {
    processes(swarm, nodes, left = 1) {
      const { N_P, N_P1, N_H1, cells, sizes } = swarm;
      const [into, into1] = [Math.min(left, N_P), Math.min(left, N_P1)];
      const [each, each1] = [N_P / into, N_P1 / into1];
      const fleet = { ...swarm, sizes: each > 1 ? null : sizes, N_P: into, N_P1: into1, N_E: each * swarm.N_E, N_E1: each1 * swarm.N_E1, N_S: each * swarm.N_S, N_S1: each1 * swarm.N_S1 };
      // Groups as the command has them, and those of several processes.
      const groups = [...Array(cells).fill([N_P, "robots"]), ...(N_H1 ? [[N_P1, chosen("beside") === LAPTOP ? "laptop" : "others"]] : [])];
      const several = groups.filter(([processes]) => processes > 1);
      if (!several.length || Math.max(fleet.N_E, fleet.N_E1) > SWARM[2].high) return null;
      const [[many, whose]] = several;
      const which = several.length > 1 ? "the processes of each host" : `${count(many)} processes${groups.length > 1 ? ` of "${whose}"` : ""}`;
      return {
        what: `composing ${which} into ${left}${left > 1 ? " or fewer" : ""}`,
        nodes: [nodes[0] * each, nodes[1] * each1],
        fleet,
        into: { high: Math.max(...several.map(([processes]) => processes)), of: (number) => FLEETS.processes(swarm, nodes, number) },
      };
    },
    endpoints(swarm, nodes) {
      const without = (endpoints, own) => Math.max(0, endpoints - MODEL.service_endpoints * own);
      const [N_E, N_E1] = [without(swarm.N_E, nodes[0]), without(swarm.N_E1, nodes[1])];
      const [N_S, N_S1] = [Math.min(swarm.N_S, N_E), Math.min(swarm.N_S1, N_E1)];
      return { what: "leaving out the parameter services of the robots' nodes", nodes: [0, 0], fleet: { ...swarm, sizes: null, N_E, N_E1, N_S, N_S1 } };
    },
  };

  /** Return all changes, in the planner's order: the same functions, asked again. `cost` tells a window's airtime. */
  function changesOf({ middleware, channel, swarm, nodes, within, ros }, cost = spanOf) {
    const found = [];
    // One alone has nobody to find.
    if (swarm.N_H + swarm.N_H1 === 1) return found;
    // Within how long robots then start one after the other [s]; 0 if periodic traffic fills the channel.
    const windowOf = (name, air, fleet) => {
      const [burst, steady] = ["burst", "ever"].map((window) => cost(name, air, fleet, window));
      if (steady.full >= MODEL.limit) return 0;
      const needed = Math.min(...["full", "single"].map((end) => F[MODEL.drain]({ B: burst[end], rho: steady[end] })));
      return Math.max(1, Math.ceil(Math.min(needed, within / 2)));
    };
    const inTurnWords = (window) => `starting one after the other, at random times within ${DiscoveryTimes.seconds(window)}`;
    const aboutOf = ({ of }, name) => of[MODEL.protocols[name].family] ?? of.None;
    // The same change and a staggered start, if any is long enough: discostorm_planner.plan._with_staggered_start.
    const joined = (change, way) => {
      const { name, air, fleet, into, efforts } = change;
      const window = efforts.includes("research") ? 0 : windowOf(name, air, fleet);
      if (!window) return null;
      const both = MODEL.remedies[`${way} and staggered start`];
      const { steps } = both;
      const start = (one) => ({ ...one, what: `${one.what} and ${inTurnWords(window)}` });
      return { ...start(change), kind: "combination", steps, window, ...aboutOf(both, name), into: into && { ...into, of: (number) => start(into.of(number)) }, paste: pasted({ steps, name, air, window }) };
    };
    const add = (kind, what, { name = middleware, from = middleware, air = channel, base = channel, fleet = swarm, nodes: left = nodes, note = "", way = kind, window = 0, into }) => {
      const [before, after] = [cost(from, base, swarm, "second").single, cost(name, air, fleet, "second").single];
      const saved = before ? 1 - after / before : 0;
      const { steps } = MODEL.remedies[way];
      const fits = before >= MODEL.limit && after < MODEL.limit;
      // A table that a change makes has no group; if its product is today's, so is its release.
      const [made, today] = [MODEL.protocols[name], MODEL.protocols[middleware]];
      const same = made.product === today.product;
      const served = same && today.product && made.has_server && !today.has_server;
      const { caution, ratios } = served ? { caution: "", ratios: today.server_ratios } : made.group || !same ? made : today;
      const change = { kind, steps, what, note, name, caution, ratios, saved, fits, air, fleet, nodes: left, window, into, ...aboutOf(MODEL.remedies[way], name), paste: pasted({ steps, name, air, window }) };
      found.push({ ...change, place: found.length, inTurn: () => (window ? null : joined(change, way)) });
    };
    for (const kind of MODEL.fleets) {
      const change = FLEETS[kind](swarm, nodes);
      if (change) add(kind, change.what, change);
    }
    for (const [kind, what, note, name, from, way] of tablesAfter(middleware, ros)) add(kind, what, { note, name, from, way });
    for (const { kind, what, note, base, wifi } of channel.remedies) add(kind, what, { note, base, air: wifi });
    const window = windowOf(middleware, channel, swarm);
    if (window) add("staggered start", inTurnWords(window), { window });
    // What makes it fit first, the easiest before all; then what saves most; in both parts the best case behind what is counted.
    return found.sort((a, b) => b.fits - a.fits || a.best_case - b.best_case || (a.fits ? a.effort - b.effort || a.steps.length - b.steps.length : 0) || b.saved - a.saved);
  }

  /** Return the changes of a table, as the ROS 2 release has them that ships it. */
  function tablesAfter(name, ros) {
    const { tables } = MODEL.protocols[name];
    return tables[ros] ?? tables.any;
  }

  /** Return all changes of such a fleet: of the access point where discovery takes most; of several, on its channel. */
  function changesByCell(settings, airtimeOf) {
    const { middleware, channel, swarm } = settings;
    const ends = (air) => [air.full ?? air, air];
    const [used] = ends(channel).map((end) => airtimeOf(middleware, swarm)(priced(middleware, end), "second"));
    const cell = used.indexOf(Math.max(...used));
    const cost = (name, air, fleet, window) => {
      const [full, single] = ends(air).map((end) => airtimeOf(name, fleet)(priced(name, end), window)[cell]);
      return { full, single };
    };
    if (swarm.cells === 1) return changesOf(settings, cost);
    return changesOf({ ...settings, channel: { ...channel, remedies: [] } }, cost).map((change) => ({ ...change, air: channel }));
  }

  /** Return the changes to simulate: the best of each kind, and of each other product, as many as the planner. */
  function simulatedChanges(changes) {
    const first = new Map();
    for (const change of changes) {
      const { kind, steps, name, saved } = change;
      const key = steps.includes("middleware") ? `switch ${MODEL.protocols[name].product}` : kind;
      if ((saved >= NOTHING || MODEL.discovery.simulated_anyway.includes(kind)) && !first.has(key)) first.set(key, change);
    }
    const [starts, others] = [true, false].map((late) => [...first.values()].filter(({ window }) => window > 0 === late));
    return [...starts, ...others.slice(0, MODEL.discovery.max_changes - starts.length)];
  }

  /** Return the changes joined with a staggered start whose change alone comes closest to the target, those of another middleware or those of none: discostorm_planner.change_simulation._pick_closest. */
  function closestInTurn(every, done, switches) {
    const { max_combinations: most, other_middleware: others } = MODEL.discovery;
    const key = ({ steps, name }) => [...steps, name].join();
    const alone = new Map(done.filter(({ time }) => time).map((change) => [key(change), change]));
    return every
      .filter((change) => alone.has(key(change)) && change.efforts.some((effort) => others.includes(effort)) === switches)
      .sort((one, other) => DiscoveryTimes.byRank(alone.get(key(one)), alone.get(key(other))) || one.place - other.place)
      .map(({ inTurn }) => inTurn())
      .filter(Boolean)
      .slice(0, most);
  }

  /** Return the settings after the changes that the reader applied, as far as there are such changes. */
  function withApplied(settings, kinds) {
    return kinds.reduce((now, kind) => {
      const change = changesOf(now).find((one) => one.kind === kind && !one.window);
      if (!change) return now;
      const { name: middleware, air, fleet: swarm, nodes } = change;
      const channel = air === now.channel ? air : { ...air, remedies: channels.get(air.name)?.remedies ?? [] };
      return { ...now, middleware, channel, swarm, nodes, with: [...now.with, change] };
    }, settings);
  }

  /** What to paste is for any, for a middleware, its product or family, or for a radio. */
  function pasted({ steps, name, air, window }) {
    const { family, product } = MODEL.protocols[name];
    // What is switched to together with a configuration are no peers.
    const peers = steps.filter((kind) => kind !== "staggered start").length === 1 && `${family} peers`;
    const named = (key) => [name, product, family, peers, "any"].includes(key) || air.name.startsWith(key);
    return steps
      .map((kind) => MODEL.pastes[kind])
      .flatMap((paste) => Object.keys(paste).filter(named).flatMap((key) => paste[key]))
      .map((piece) => ({ ...piece, text: window ? piece.text.replace(/^WINDOW=\d+$/m, `WINDOW=${window}`) : piece.text }));
  }

  function compute(settings) {
    const all = NAMES.map((name) => answerOf(name, settings.channel, settings.swarm));
    const front = all.find((one) => one.name === settings.middleware) ?? answerOf(settings.middleware, settings.channel, settings.swarm);
    const peers = all.filter((one) => one !== front && one.protocol.group === front.protocol.group && !one.protocol.variant);
    const planned = byCell(settings.swarm) ? { changes: [], turn: null, closest: () => [] } : plannedOf(settings, changesOf(settings));
    return { settings, hosts: settings.swarm.N_H, all, front, drawn: [front, ...peers.slice(0, DASHES.length - 1)], ...planned, reboot: rebootOf(front.name, settings.channel, settings.swarm) };
  }

  /** Return the changes to simulate, and which of them is how robots start; it has its window as a change of today's fleet. */
  function plannedOf({ start, secure }, every) {
    const turn = start === IN_TURN ? (every.find(({ window }) => window) ?? { what: "", window: 0 }) : null;
    // No window is long enough where periodic traffic alone fills the channel.
    const changes = secure || turn?.window === 0 ? [] : simulatedChanges(turn ? every.filter(({ window }) => !window) : every);
    return { changes, turn, closest: (done, switches) => (turn ? [] : closestInTurn(every, done, switches)) };
  }

  // ---- showing it ----

  const SIGNS = ["✓", "?", "!", "✕"];
  // What each assumes is said once, above.
  const outlookOf = ({ outlook }) => outlook.replace(" at best", "");
  const robotsWord = (value) => plural(value, "robot");

  function everybody({ swarm }) {
    const beside = swarm.N_H1 ? ` and ${chosen("beside") === LAPTOP ? plural(swarm.N_H1, "laptop") : plural(swarm.N_H1, "other")}` : "";
    return `${robotsWord(swarm.N_H)}${beside}`;
  }

  const busyFor = (low, high) => (low < Infinity && high === Infinity ? `${duration(low)} or more` : durations(low, high));

  /** Behind the answer: how long the channel is busy if nothing is lost, and what repeats. */
  function busyText({ front, settings }, today) {
    const { steady, protocol, full } = front;
    const who = everybody(settings);
    if (full.drain === Infinity) return `The periodic traffic of ${who} alone needs ${percent(steady)}${steady > 10 ? "" : " of the channel"}, so the channel never carries the whole startup.`;
    const ends = full.drain === front.drain ? "" : " The shorter time assumes full A-MPDUs, and the longer time one message per frame.";
    const after = protocol.repeats ? ` After startup, discovery needs ${between(percent(full.steady), percent(steady))}${steady > 10 ? "" : " of the channel"}.` : "";
    const sooner = today && today.median < full.drain ? " Discovery is complete sooner: messages that queues drop take no airtime, and not every message says something new." : "";
    const lease = full.drain > protocol.lease ? ` That is longer than the lease of ${duration(protocol.lease)}.` : "";
    return `If nothing is lost, ${who} keep the channel busy for ${busyFor(full.drain, front.drain)} (drain time).${ends}${lease}${sooner}${after}`;
  }

  /** The verdict on the discovery time: as simulated, or what is known until then. */
  function verdictOf({ front, settings }, found) {
    const { swarm, channel, within, start, secure } = settings;
    if (swarm.N_H + swarm.N_H1 === 1) return { grade: 0, title: MODEL.alone, lines: [] };
    if (secure) {
      const [title, ...lines] = MODEL.security;
      return { grade: 1, title, lines };
    }
    const drain = `If nothing is lost, startup keeps the channel busy for ${busyFor(front.full.drain, front.drain)}.`;
    if (!found?.known) return { title: `Simulating whether discovery is complete within ${DiscoveryTimes.seconds(within)} …`, lines: byCell(swarm) ? [] : [drain] };
    const { today, reason } = found;
    const name = channel.name === OWN ? "your own channel" : DiscoveryTimes.inWords(channel.name);
    const { name: protocol, protocol: { caution, ratios } } = front;
    const wifi = swarm.cells > 1 ? `${name} in ${FleetFile.joined(swarm.cells)}` : name;
    // Too many processes for the page to count those of each cell, as the command does.
    if (byCell(swarm) && !found.airtime) return { grade: 1, title: DiscoveryTimes.say("not simulated", { reason }), lines: [] };
    const busy = byCell(swarm) ? busiest(settings, found) : { drain: Math.min(front.full.drain, front.drain), steady: front.full.steady };
    const verdict = DiscoveryTimes.verdict({ today, reason, within, fleet: everybody(settings), protocol, wifi, caution, ratios, ...busy });
    if (start !== REBOOT || !today) return verdict;
    const { grade, title } = DiscoveryTimes.late(found.late, within);
    return { grade, title, lines: [verdict.title, ...verdict.lines] };
  }

  /** The airtime of each cell in a window, or of its burst [s], with full A-MPDUs and without. */
  const ofCells = ({ middleware, channel }, { airtime }, window) => [channel.full ?? channel, channel].map((end) => airtime(priced(middleware, end), window));

  /** How long the busiest cell is busy if nothing is lost [s], at the better end, and its least periodic traffic. */
  function busiest(settings, found) {
    const [bursts, steady] = ["burst", "ever"].map((window) => ofCells(settings, found, window));
    const drains = bursts.map((burst, end) => Math.max(...burst.map((B, cell) => F[MODEL.drain]({ B, rho: steady[end][cell] }))));
    return { drain: Math.min(...drains), steady: Math.max(...steady[0]) };
  }

  /** What each cell carries, in the command's words. */
  function cellLines(settings, found) {
    const [full, single] = ofCells(settings, found, "second");
    return FleetFile.names(settings.swarm.cells).map((cell, i) => {
      const [low, high] = [full[i], single[i]].sort((one, other) => one - other).map(DiscoveryTimes.longTime);
      return DiscoveryTimes.say("cell", { cell, airtime: low === high ? low : `at least ${low}` });
    });
  }

  function showAnswer(answer, found) {
    const { settings, front } = answer;
    const { grade, title, lines } = verdictOf(answer, found);
    const box = byId("answer");
    box.dataset.severity = grade ?? "waiting";
    const today = found?.today;
    const numbers = today ? [["median", today.median], ["nine", today.nine], ["most pairs", today.mostPairs]] : [];
    if (found?.late) numbers.push(["late median", found.late.median]);
    const how = answer.turn?.what ? `, ${answer.turn.what}` : settings.swarm.cells > 1 ? `, evenly at ${settings.swarm.cells} access points` : "";
    const applied = settings.with.map(({ kind, what }) => {
      const undo = make("button", { type: "button", "data-undo": kind }, "Undo");
      return make("p", { class: "calc-hint" }, `With this change: ${what}. `, undo);
    });
    become(
      box,
      make("p", { class: "calc-verdict" }, make("span", { class: "calc-sign", "aria-hidden": "true" }, SIGNS[grade] ?? "…"), make("strong", {}, title)),
      ...lines.map((line) => make("p", { class: "calc-line" }, line)),
      make("p", { class: "calc-hint" }, `${everybody(settings)}, ${capitalized(front.name)}${how}`, ...numbers.map(([of, value]) => make("data", { value: String(value), "data-of": `simulated ${of}`, hidden: "" }))),
      ...applied,
    );
    // The airtime is that of one access point, without wired hosts and security.
    byId("behind").hidden = byId("csv").disabled = byCell(settings.swarm) || settings.secure;
    showFile(settings);
    byId("reason").textContent = busyText(answer, today);
    become(byId("numbers"), ...rebooting(answer), make("p", { class: "calc-hint" }, assumed(answer)));
  }

  /** The same fleet for the command; not with changes or rates that no file can say. */
  function showFile(settings) {
    const { channel, nodes } = settings;
    byId("file").hidden = settings.with.length > 0 || channel.name === OWN;
    const laptop = chosen("beside") === LAPTOP;
    const wifi = chosen("channel");
    const robot = robots.get(chosen("robot"))?.name;
    byId("command").textContent = FleetFile.command(settings, MODEL.exact[settings.middleware] ?? settings.middleware, wifi);
    byId("toml").textContent = FleetFile.text(settings, { robot, wifi, others: laptop ? "laptop" : "others", nodes: laptop ? nodes[1] : undefined });
  }

  /** What one robot takes that reboots, or one of the others if these have more processes. */
  function rebooting({ reboot, front }) {
    if (!reboot) return [];
    const { low, high, other } = reboot;
    const who = other ? (chosen("beside") === LAPTOP ? "laptop" : "other") : "robot";
    return [make("p", {}, make("b", {}, `One ${who} reboots: `), make("data", { value: String(low), "data-of": `${front.name} reboot low`, hidden: "" }), exact(high, durations(low, high), `${front.name} reboot high`), " of airtime.")];
  }

  /** How many fit, in words: beyond twice what a product was captured with, only that more do. */
  function robotsThatFit(one, { settings: { swarm } }, largest) {
    const [hosts = Infinity, processes = Infinity] = one.protocol.measured;
    const most = Math.max(1, Math.floor(MODEL.told * Math.min(hosts, processes / swarm.N_P)));
    return largest > most ? `more than ${count(most)}` : count(largest);
  }

  /** What every number of this page assumes, and whether the product ever ran with so many. */
  function assumed({ settings: { channel, swarm }, front }) {
    const frames = channel.full
      ? `${count(channel.full.values.n_agg)} messages to one per A-MPDU`
      : "one message per frame, except where a product packs or splits messages";
    const all = [
      swarm.N_H + swarm.N_H1,
      swarm.N_H * swarm.N_P + swarm.N_H1 * swarm.N_P1,
      Math.max(swarm.N_E, swarm.N_H1 && swarm.N_E1),
    ];
    const [hosts, processes, endpoints] = front.protocol.measured;
    const beyond = all.some((many, i) => many > front.protocol.measured[i]) ? " Your fleet is larger, so its numbers are extrapolated." : "";
    const captured = hosts
      ? ` The measured model of ${front.name} comes from captures of up to ${plural(hosts, "host")} and ${plural(processes, "process", "processes")} ` +
        `with up to ${plural(endpoints, "endpoint")} each.${beyond}${bandOf(front.protocol, all)}`
      : "";
    return `This estimate assumes: ${MODEL.topology} · simultaneous startup · ${frames} · no losses · no collisions.${captured}`;
  }

  /** How far a measured table was off where it was not fitted, as `discostorm.prediction_error.error_band` has it. */
  function bandOf({ band, measured: [hosts, processes, endpoints] }, [ofHosts, ofAll, ofProcess]) {
    if (!band.length) return "";
    const many = Math.max(ofHosts / hosts, ofAll / processes);
    const ends = ofProcess / Math.max(endpoints, 1);
    const needed = Math.max(Math.min(many, MODEL.told), ends);
    const [, mostHosts, mostEnds, sentence] = band.find(([upTo]) => upTo >= needed) ?? band.at(-1);
    return ` ${sentence}${many > mostHosts || ends > mostEnds ? MODEL.beyond : ""}.`;
  }

  // The item of each change, as it was shown last: an open configuration stays open while others come.
  const items = new Map();

  function changeItem(change, before, within, said) {
    const { time, takes, cost, note, paste, kind, window } = change;
    const [what, after] = [DiscoveryTimes.whatWords(change), DiscoveryTimes.afterWords(change)];
    const doubtful = DiscoveryTimes.doubt(change, within, said);
    const key = [what, before, after, doubtful].join("|");
    if (items.has(key)) return items.get(key);
    const item = make(
      "li",
      {},
      make("span", { class: "calc-what" }, `${capitalized(what)}: `),
      `${before} → ${after}. `,
      make("data", { value: String(time.median), "data-of": `simulated ${change.steps.join(" and ")} of ${change.name}`, hidden: "" }),
      make("span", { class: "calc-hint" }, `Effort: ${takes}. Trade-off${cost.includes("; ") ? "s" : ""}: ${cost}.${note && ` ${capitalized(note)}.`}${doubtful}`),
    );
    if (!window) item.append(make("button", { type: "button", "data-apply": kind, "aria-label": `Apply: ${what}` }, "Apply"));
    for (const { where, version, text } of paste) {
      const copy = make("button", { type: "button" }, "Copy");
      copy.addEventListener("click", () => copied(copy, text));
      item.append(make("details", { class: "calc-paste" }, make("summary", {}, `To copy: ${where} (${version})`), make("pre", { tabindex: "0" }, text), copy));
    }
    items.set(key, item);
    return item;
  }

  /** Today's time; how far it got only beside a change that never ends, either. */
  const beforeWords = (today, { time }) =>
    !today ? "not simulated" : today.median === Infinity && time?.median < Infinity ? "never" : DiscoveryTimes.timeWords(today);

  /** The changes in the order of advice, those that are not simulated yet, and how sure all is. */
  function showChanges({ settings, front, changes }, found) {
    const { within, swarm, start, secure } = settings;
    const { today = null, changes: done = [], left = changes, over = false } = found ?? {};
    const fewer = found?.fewer && fewerWords(settings, found.fewer);
    const { caution, ratios } = front.protocol;
    const advice = DiscoveryTimes.advice({ today, changes: done, within, caution, ratios, fewer });
    if (!left.length && items.size > 200) items.clear();
    const said = today?.lost > MODEL.discovery.few_lost ? caution : "";
    const rows = (some) => some.map((change) => changeItem(change, beforeWords(today, change), within, said));
    const none = swarm.N_H + swarm.N_H1 === 1 || secure;
    const other = start === REBOOT && !none ? DiscoveryTimes.say("other start") : "";
    // Until all is simulated, what comes first is not known.
    const blocks = none ? [] : over ? advice.blocks : [{ title: "What would help:", rows: advice.blocks.flatMap((block) => block.rows) }];
    let number = 1;
    const listed = blocks.flatMap(({ title, rows: some }) => {
      const list = make("ol", { start: String(number) }, ...rows(some));
      number += some.length;
      return [make("p", { class: "calc-title" }, title), ...(some.length ? [list] : [])];
    });
    byId("remedies").replaceChildren(...listed);
    byId("more-changes").replaceChildren(...rows(advice.more));
    become(byId("rest"), ...advice.rest.map((line) => make("p", {}, line)));
    become(byId("cell-list"), ...(found?.airtime && swarm.cells > 1 ? cellLines(settings, found).map((line) => make("li", {}, line)) : []));
    byId("others-tried").hidden = !advice.more.length && !advice.rest.length;
    const waiting = left.length ? `To be simulated: ${left.map(({ what }) => what).join("; ")}.` : DiscoveryTimes.say("searching");
    become(byId("possible"), ...(over ? advice.possible : found?.known ? [waiting] : []));
    const [hosts] = front.protocol.measured;
    const endpoints = [...(swarm.sizes ? [] : [["A robot", swarm.N_P, swarm.N_E]]), ...(swarm.N_H1 ? [["Another computer", swarm.N_P1, swarm.N_E1]] : [])];
    const rounded = endpoints
      .map(([name, processes, mean]) => ({ name, mean, whole: Math.round(processes * mean) / processes }))
      .filter(({ mean, whole }) => Math.abs(whole - mean) > 1e-9 * mean);
    const sure = DiscoveryTimes.certainty({ today, changes: done, protocol: front.name, hosts: swarm.N_H + swarm.N_H1, captured: hosts, rounded, within, caution, ratios, server: front.protocol.server_ratios, cells: swarm.cells });
    byId("sure").textContent = secure ? "" : [...sure, other].join(" ");
  }

  /** What the command calls a group of hosts: the robots at each access point come first. */
  /** What the sentence on fewer hosts of a group needs. */
  function fewerWords(settings, { others, place, hosts, ...found }) {
    const rest = others.flatMap((many, at) => (at === place ? [] : [`${count(many)} ${groupName(settings, at, many)}`]));
    const last = rest.length > 1 ? ` and ${rest.pop()}` : "";
    const total = others.reduce((sum, many) => sum + many, 0) - hosts + found.count;
    return {
      ...found,
      group: `${count(hosts)} ${groupName(settings, place, hosts)}`,
      beside: rest.length ? `, plus ${rest.join(", ")}${last},` : "",
      total: `${count(total)} host${total === 1 ? "" : "s"}`,
    };
  }

  function groupName({ swarm: { cells } }, place, hosts) {
    if (place >= cells) return chosen("beside") !== LAPTOP ? "others" : hosts === 1 ? "laptop" : "laptops";
    return cells > 1 ? `robots at ${FleetFile.names(cells)[place]}` : "robots";
  }

  function showAll(answer) {
    const some = (one, { full, largest }) =>
      full === null ? "none" : full === Infinity ? "any" : robotsThatFit(one, answer, largest);
    /** Both ends where they differ: for people a range, for machines each with all its digits. */
    const both = (low, high, of, words) => [
      ...(Object.is(low, high) ? [] : [make("data", { value: String(low), "data-of": `${of} full`, hidden: "" })]),
      exact(high, words, of),
    ];
    const cell = (one, window) => {
      const [found, best] = [one.fitting[window], one.full.fitting[window]];
      const of = `${one.name} saturation ${window}`;
      return found ? both(best.full ?? NaN, found.full ?? NaN, of, between(some(one, found), some(one, best))) : ["–"];
    };
    become(
      byId("all").tBodies[0],
      ...answer.all.flatMap((one, i, all) => {
        const { group } = one.protocol;
        const row = make(
          "tr",
          one === answer.front ? { class: "calc-front" } : {},
          make("th", { scope: "row" }, answer.drawn.includes(one) ? sample(answer, one) : "", ` ${capitalized(one.name)}`),
          make(
            "td",
            {},
            ...both(one.full.drain, one.drain, `${one.name} drain`, durations(one.full.drain, one.drain, "never done")),
            make("span", { class: "calc-hint" }, ` ${between(outlookOf(one.full), outlookOf(one))}`),
          ),
          make("td", {}, ...(one.protocol.repeats ? both(one.full.steady, one.steady, `${one.name} steady`, between(percent(one.full.steady), percent(one.steady))) : ["nothing"])),
          make("td", {}, ...cell(one, "second")),
          make("td", {}, ...cell(one, "lease")),
          make("td", {}, ...cell(one, "ever")),
        );
        const head = make("tr", { class: "calc-group" }, make("th", { scope: "rowgroup", colspan: "6" }, group));
        return group === all[i - 1]?.protocol.group ? [row] : [head, row];
      }),
    );
  }

  function showParts(answer) {
    const { front } = answer;
    const single = answer.settings.channel.full ? ", one frame in each exchange" : "";
    byId("parts-title").textContent = `Airtime of the first second by message type, with ${front.name}${single}`;
    const [body] = byId("parts").tBodies;
    become(
      body,
      ...front.messages.map((message) => {
        const share = message.both / front.utilization || 0;
        const bar = make("span", { class: "calc-bar", "aria-hidden": "true" }, make("span"));
        bar.firstChild.style.width = `${100 * share}%`;
        bar.firstChild.style.background = `var(${front.protocol.color})`;
        const of = (what) => `${front.name} ${message.name} ${what}`;
        return make(
          "tr",
          {},
          make("th", { scope: "row" }, message.name, message.name.includes(message.cast) ? "" : make("span", { class: "calc-hint" }, ` ${message.cast}`)),
          make("td", {}, exact(message.load, count(message.load < 10 ? message.load : Math.round(message.load)), of("messages"))),
          make("td", {}, exact(message.both, duration(message.both), of("airtime"))),
          make("td", {}, make("span", { class: "calc-part" }, share > 0 && share < 1e-5 ? "<0.001%" : percent(share)), bar),
        );
      }),
      make("tr", { class: "calc-sum" }, make("th", { scope: "row" }, "All"), make("td"), make("td", {}, exact(front.utilization, duration(front.utilization), `${front.name} utilization`)), make("td")),
    );
  }

  // ---- the plot ----

  // The theme's colors; read when they change only, as that takes time.
  let theme = {};

  function readTheme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(`--pst-color-${name}`).trim();
    theme = {
      text: color("text-base"),
      background: color("background"),
      border: color("border"),
      font: style.getPropertyValue("--ds-sans").trim(),
      lines: Object.fromEntries(Object.keys(MODEL.protocols).map((name) => [name, style.getPropertyValue(MODEL.protocols[name].color).trim()])),
    };
  }

  // A product has one color everywhere; lines of the same differ in their dashes.
  const colorOf = (one) => theme.lines[one.name];
  const dashOf = (answer, one) => DASHES[answer.drawn.indexOf(one)];

  /** A piece of a protocol's line, for the legend. */
  function sample(answer, one) {
    const draw = (tag, attributes) => {
      const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
      return element;
    };
    const svg = draw("svg", { class: "calc-sample", viewBox: "0 0 36 8", "aria-hidden": "true" });
    const dash = dashOf(answer, one).join(" ");
    svg.append(draw("line", { x2: 36, y1: 4, y2: 4, style: `stroke: var(${one.protocol.color})`, "stroke-width": 3, "stroke-dasharray": dash }));
    return svg;
  }

  let plot = null;
  let drawn = null;

  /** Return what the axes show: where they end, and whether they are logarithmic. */
  function view(answer) {
    const points = answer.drawn.map((one) => one.utilization);
    const full = answer.drawn.map((one) => one.fitting.second.full).filter((hosts) => hosts !== null);
    const far = Math.max(...points) > 4 * MODEL.limit || answer.hosts > 4 * Math.max(1, ...full);
    if (far) {
      const singles = answer.drawn.map((one) => one.single).filter(Boolean);
      const end = 1.5 * Math.max(2, answer.hosts, ...full);
      return {
        log: true,
        hosts: end,
        low: Math.min(0.5 * MODEL.limit, ...singles) / 1.5,
        high: Math.max(2 * Math.max(MODEL.limit, ...points), Math.min(1e300, answer.front.at(end))),
      };
    }
    return {
      log: false,
      hosts: Math.max(1.25 * Math.max(1, ...full), 1.15 * answer.hosts, answer.hosts + 1),
      low: 0,
      high: 1.25 * Math.max(MODEL.limit, ...points),
    };
  }

  /** At most so many of the marks, evenly, the last of them always. */
  const thinned = (marks, most) => {
    const step = Math.max(1, Math.ceil(marks.length / most));
    return marks.filter((mark, i) => (marks.length - 1 - i) % step === 0);
  };

  /** Where a logarithmic axis has its marks: right up to its end; the units are what is told in one. */
  function marksOf(least, most, units, at_most) {
    const fine = most / least < 15 ? [1, 2, 3, 4, 5, 6, 7, 8, 9] : most / least < 1000 ? [1, 2, 5] : [1];
    const marks = [];
    units.forEach((unit, i) => {
      const end = units[i + 1] ?? Infinity;
      for (let length = unit; length < Math.min(end, 10 * most); length *= 10)
        marks.push(...fine.map((digit) => digit * length).filter((mark) => mark < end));
    });
    return thinned(marks.filter((mark) => mark >= least * 0.999 && mark <= most), at_most);
  }
  const powers = (least, most) => marksOf(least, most, [1], 8);
  const times = (least, most) => marksOf(least, most, [1e-6, MINUTE, HOUR, DAY, YEAR], 6);

  /** A mark on the axis of time. */
  function short(seconds) {
    if (seconds === 0) return "0";
    const [length, unit] = [[1e-6, "µs"], [1e-3, "ms"], [1, "s"], [MINUTE, "min"], [HOUR, "h"], [DAY, "d"], [YEAR, "y"]].findLast(([least]) => seconds >= least * 0.999) ?? [1, "s"];
    const value = seconds / length;
    return `${value >= 1e4 ? power(value) : three.format(value)} ${unit}`;
  }
  const shortCount = (value) => (value < 1e5 ? number(value) : power(value));

  function curve(answer) {
    const { log, hosts } = view(answer);
    const x = [];
    for (let i = 0; i <= CURVE_POINTS; i++) {
      const part = i / CURVE_POINTS;
      x.push(log ? hosts ** part : 1 + (hosts - 1) * part);
    }
    return { x, lines: answer.drawn.map((one) => x.map(one.at)) };
  }

  function marks(answer) {
    const { text, background } = theme;
    return (u) => {
      const { ctx, bbox } = u;
      const scale = devicePixelRatio;
      const limit = u.valToPos(MODEL.limit, "y", true);
      ctx.save();
      ctx.strokeStyle = text;
      ctx.fillStyle = text;
      ctx.lineWidth = 1.5 * scale;
      ctx.setLineDash([2 * scale, 3 * scale]);
      ctx.beginPath();
      ctx.moveTo(bbox.left, limit);
      ctx.lineTo(bbox.left + bbox.width, limit);
      ctx.stroke();
      ctx.setLineDash([]);
      ctx.font = `${13 * scale}px ${theme.font}`;
      // Where no curve runs: at either end of the line, above it or below, in fewer words if there is little
      // room; if there is none, on a plate.
      ctx.textBaseline = "bottom";
      const height = 17 * scale;
      const [above, below] = [limit - height - 2 * scale, limit + 2 * scale];
      const spots = ["1 s: the channel is full", "channel full", "full"].flatMap((words) => {
        const { width } = ctx.measureText(words);
        const ends = [bbox.left + 6 * scale, bbox.left + bbox.width - width - 6 * scale];
        return [[ends[0], above], [ends[1], below], [ends[0], below], [ends[1], above]].map((at) => [...at, width, words]);
      });
      const { x, lines } = curve(answer);
      const across = x.map((value) => u.valToPos(value, "x", true));
      const along = lines.map((line) => line.map((value) => u.valToPos(value, "y", true)));
      const isFree = ([left, top, width]) =>
        top + height < bbox.top + bbox.height &&
        !along.some((line) =>
          line.some((y, i) => across[i] > left - height && across[i] < left + width + height && y > top && y < top + height),
        );
      const [left, top, width, words] = spots.find(isFree) ?? spots[0];
      ctx.textAlign = "left";
      ctx.fillStyle = background;
      ctx.fillRect(left - 2 * scale, top, width + 4 * scale, height);
      ctx.fillStyle = text;
      ctx.fillText(words, left, top + height - 2 * scale);
      // The one in front last, so that its point is on top.
      for (const one of [...answer.drawn].reverse()) {
        const x = u.valToPos(answer.hosts, "x", true);
        const y = u.valToPos(one.utilization, "y", true);
        ctx.beginPath();
        ctx.arc(x, y, 6 * scale, 0, 2 * Math.PI);
        ctx.fillStyle = one === answer.front ? colorOf(one) : background;
        ctx.strokeStyle = one === answer.front ? text : colorOf(one);
        ctx.lineWidth = 2 * scale;
        ctx.fill();
        ctx.stroke();
      }
      ctx.restore();
    };
  }

  /** What is under the pointer, in words beside it. */
  function pointed(answer) {
    const tip = make("div", { class: "calc-tip", hidden: "" });
    return {
      init: (u) => u.over.append(tip),
      setCursor: (u) => {
        const { left, top } = u.cursor;
        tip.hidden = !(left >= 0);
        if (tip.hidden) return;
        const hosts = Math.max(1, Math.round(u.posToVal(left, "x")));
        tip.replaceChildren(
          make("b", {}, robotsWord(hosts)),
          ...answer.drawn.map((one) => make("span", {}, sample(answer, one), ` ${capitalized(one.name)}: ${duration(one.at(hosts))}`)),
        );
        const { clientWidth: width, clientHeight: height } = u.over;
        tip.style.left = `${left + tip.offsetWidth + 16 < width ? left + 12 : Math.max(0, left - tip.offsetWidth - 12)}px`;
        tip.style.top = `${Math.max(0, Math.min(top, height - tip.offsetHeight))}px`;
      },
    };
  }

  function draw(answer) {
    drawn = answer;
    const box = byId("plot");
    const width = box.clientWidth; // before anything changes, or the page is laid out once more
    plot?.destroy();
    plot = null;
    if (!width) return; // folded: it is drawn when it comes into sight
    const points = answer.drawn.map((one) => one.utilization);
    const names = answer.drawn.map((one) => one.name);
    if (!points.every((value) => value < 1e300)) {
      box.setAttribute("aria-label", "No curve: the numbers are too large to draw.");
      box.textContent = "The numbers are too large to draw.";
      return;
    }
    box.textContent = "";
    box.setAttribute(
      "aria-label",
      `Airtime of the first second against the number of robots: ${names.join(", ")} curve upwards and cross the line where the channel is full. ` +
        `Your robots are a point on each curve. ${answer.drawn.map((one) => `${one.name}: ${duration(one.utilization)}`).join("; ")}.`,
    );
    const { log, hosts, low, high } = view(answer);
    const { x, lines } = curve(answer);
    const { text, border, font } = theme;
    const axis = (label, size, splits, values, steps) => ({
      label,
      size,
      labelSize: 24,
      stroke: text,
      font: `13px ${font}`,
      labelFont: `13px ${font}`,
      grid: { stroke: border, width: 1 },
      ticks: { stroke: border, width: 1 },
      // uPlot's own steps end at 1e32, beyond which it would draw no axis.
      ...(log ? { incrs: [1e300], splits: (u, index, least, most) => splits(least, most), filter: (u, all) => all } : steps ? { incrs: steps } : {}),
      values: (u, all) => all.map(values),
    });
    const { init, setCursor } = pointed(answer);
    // The one in front is drawn last and thickest.
    const order = answer.drawn.map((one, index) => index).reverse();
    plot = new uPlot(
      {
        width,
        height: 320,
        padding: [12, 16, 0, 0],
        cursor: { y: false, points: { show: false }, drag: { x: false, y: false } },
        legend: { show: false },
        select: { show: false },
        scales: {
          x: { time: false, distr: log ? 3 : 1, range: [1, hosts] },
          y: { distr: log ? 3 : 1, range: [low, high] },
        },
        axes: [
          axis(`robots${log ? ", logarithmic" : ""}`, 36, powers, shortCount, WHOLE_STEPS),
          axis(`airtime of the first second${log ? ", logarithmic" : ""}`, 66, times, short),
        ],
        series: [
          {},
          ...order.map((index) => ({
            stroke: colorOf(answer.drawn[index]),
            width: answer.drawn[index] === answer.front ? 3 : 2,
            dash: dashOf(answer, answer.drawn[index]),
            points: { show: false },
            pxAlign: 0,
          })),
        ],
        hooks: { draw: [marks(answer)], init: [init], setCursor: [setCursor] },
      },
      [x, ...order.map((index) => lines[index])],
      box,
    );
  }

  function showLegend(answer) {
    become(byId("legend"), ...answer.drawn.map((one) => make("li", {}, sample(answer, one), ` ${capitalized(one.name)}`)));
  }

  // ---- the numbers as CSV ----

  function csv(answer) {
    const quote = (cell) => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : String(cell));
    const { settings, hosts } = answer;
    const rows = [["protocol", "quantity", "of", "hosts", "value", "unit"]];
    rows.push(["", "channel", settings.channel.name, "", "", ""]);
    for (const field of FIELDS) {
      const value = { ...settings.swarm, ...settings.channel.values, within: settings.within }[field.symbol];
      rows.push(["", "input", field.symbol, "", value, { "Mbit/s": "bit/s", "µs": "s", s: "s" }[field.unit] ?? "1"]);
    }
    for (const one of answer.all) {
      rows.push([one.name, "utilization", "", hosts, one.utilization, "1"]);
      for (const [window, { full, largest }] of Object.entries(one.fitting)) {
        rows.push([one.name, "saturation", window, "", full ?? "", "hosts"]);
        rows.push([one.name, "largest number of robots that fits", window, "", largest, "hosts"]);
      }
      rows.push([one.name, "drain time", "", hosts, one.drain, "s"]);
      rows.push([one.name, "steady utilization", "", hosts, one.steady, "1"]);
      if (settings.channel.full) {
        rows.push([one.name, "utilization", "full A-MPDUs", hosts, one.full.utilization, "1"]);
        rows.push([one.name, "drain time", "full A-MPDUs", hosts, one.full.drain, "s"]);
      }
      for (const message of one.messages) {
        rows.push([one.name, "uplink messages", message.name, hosts, message.hops.includes("up") ? message.load : 0, "1"]);
        rows.push([one.name, "uplink airtime", message.name, hosts, message.up, "s"]);
        rows.push([one.name, "downlink airtime", message.name, hosts, message.down, "s"]);
      }
    }
    const { x, lines } = curve(answer);
    answer.drawn.forEach((one, index) =>
      x.forEach((at, i) => rows.push([one.name, "curve", "utilization", at, lines[index][i], "1"])),
    );
    return rows.map((row) => row.map((cell) => quote(String(cell))).join(",") + "\r\n").join("");
  }

  function download() {
    if (!drawn) return;
    save(new Blob([csv(drawn)], { type: "text/csv;charset=utf-8" }), "discovery.csv");
  }

  function save(blob, name) {
    const url = URL.createObjectURL(blob);
    make("a", { href: url, download: name }).click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  }

  // ---- the state in the address ----

  function hash() {
    const parts = new URLSearchParams();
    for (const list of LISTS) parts.set(listName(list), chosen(list));
    for (const field of usedFields()) parts.set(field.name, byId(field.name).value.trim());
    if (applied.length) parts.set("with", applied.join(","));
    return `#${parts}`;
  }

  // Not on every key: browsers take a limited number of changes.
  let writing;

  function writeHash() {
    clearTimeout(writing);
    writing = setTimeout(() => history.replaceState(null, "", byId("link").getAttribute("href")), 200);
  }

  /** Put a text on the clipboard and say so on what was clicked. */
  async function copied(element, text) {
    const before = element.dataset.text ?? element.textContent;
    element.dataset.text = before;
    let done = true;
    try {
      await navigator.clipboard.writeText(text);
    } catch {
      const area = make("textarea", { class: "calc-off" }, text);
      document.body.append(area);
      area.select();
      done = document.execCommand("copy");
      area.remove();
    }
    element.textContent = done ? "Copied" : "Not copied: the browser refused";
    byId("said").textContent = done ? "Copied to the clipboard." : "The browser refused to copy.";
    setTimeout(() => {
      element.textContent = before;
      byId("said").textContent = "";
    }, 2500);
  }

  // What the address asked for and cannot have, by the list where it is shown.
  let refused = {};

  /** Fill the fields from the address; return whether it says anything of them. */
  function readHash() {
    clearTimeout(writing);
    const parts = new URLSearchParams(location.hash.slice(1));
    const known = [...LISTS.map(listName), ...FIELDS.map((field) => field.name), "with"];
    if (!known.some((name) => parts.has(name))) return false;
    byId("form").reset();
    refused = {};
    for (const list of LISTS) {
      const wanted = parts.get(listName(list)) ?? null;
      if (wanted === null) continue;
      if ([...byId(list).options].some((option) => option.value === wanted)) byId(list).value = wanted;
      else refused[list] = `The link names “${brief(wanted)}”, which is not in the list. We use this entry instead.`;
    }
    applied = (parts.get("with") ?? "").split(",").filter(Boolean);
    if (parts.has("robot") && !refused.robot) takeRobot();
    if (parts.has("ros") && !refused.ros && !parts.has("middleware")) takeRelease();
    for (const field of FIELDS) if (parts.has(field.name)) byId(field.name).value = parts.get(field.name);
    // Numbers that are not those of the robot are one's own.
    const robot = robots.get(chosen("robot"));
    if (robot && ["processes", "endpoints"].some((name) => byId(name).value.trim() !== robot[name])) byId("robot").value = OWN;
    return true;
  }

  // ---- putting it together ----

  function takeRobot() {
    const robot = robots.get(chosen("robot"));
    for (const name of robot ? ["processes", "endpoints"] : []) byId(name).value = robot[name];
  }

  // The tables of which a ROS 2 release ships one: the release says which.
  const releases = new Set([...Object.values(MODEL.ros).flatMap(Object.values), "Fast DDS", "Cyclone DDS"]);

  function takeRelease() {
    const { product } = MODEL.protocols[chosen("middleware")];
    const shipped = MODEL.ros[chosen("ros")];
    if (shipped) byId("middleware").value = shipped[product] ?? shipped[MODEL.start.product];
  }

  /** No release is chosen that ships another table of the middleware. */
  function fitRelease() {
    const shipped = MODEL.ros[chosen("ros")];
    if (shipped && !Object.values(shipped).includes(chosen("middleware"))) byId("ros").value = NONE;
  }

  function showLists() {
    const robot = robots.get(chosen("robot"));
    byId("robot-parts").hidden = !robot;
    if (robot) {
      const kinds = [...new Set(robot.parts.map((part) => part.kind))].join(" and ");
      byId("robot-kind").textContent = `Where these numbers come from (${kinds.replace("printed", "printed in the paper")})`;
      become(
        byId("robot-list"),
        ...robot.parts.map(({ what, processes, endpoints, kind, source }) =>
          make("li", {}, `${capitalized(what)}: ${plural(processes, "process", "processes")}, ${plural(endpoints, "endpoint")}, ${kind}. `, make("span", { class: "calc-hint" }, source)),
        ),
      );
    }
    byId("others").hidden = byId("cable").parentElement.hidden = chosen("beside") === NONE;
    BESIDE.slice(1).forEach((field) => (byId(field.name).parentElement.hidden = chosen("beside") !== OWN));
    const { lease, group, about } = MODEL.protocols[chosen("middleware")];
    byId("middleware-hint").textContent = `${capitalized(about || group)}${lease < Infinity ? `; lease ${duration(lease)}` : ""}.`;
    byId("own").hidden = chosen("channel") !== OWN;
    const channel = channels.get(chosen("channel"));
    const { R_uni, O_uni, R_multi } = channel?.values ?? {};
    const { O_agg, n_agg } = channel?.full?.values ?? {};
    const mega = (rate) => `${tenth.format(rate / 1e6)}${SPACE}Mbit/s`;
    const several = parsed(byId("cells").value) > 1;
    byId("cells-hint").textContent = several ? "Each has a channel of its own. Robots are spread evenly, other computers without a cable are at the first." : "";
    byId("ros").disabled = !releases.has(chosen("middleware"));
    byId("channel-hint").textContent = channel
      ? `Unicast at ${mega(R_uni)} after ${number(O_uni * 1e6)}${SPACE}µs a frame${O_agg ? `, or ${number(O_agg * 1e6)}${SPACE}µs for up to ${count(n_agg)} frames` : ""}, multicast at ${mega(R_multi)}.`
      : "";
  }

  // ---- simulated, in a worker: typing never waits for it ----

  const simulation = FleetSimulation(MODEL.discovery, FOLDER);
  let pictured = null; // the startup that is drawn
  const lanes = OwnLanes(byId("lanes"), MODEL.discovery.queue[0]);
  const WAIT = 300; // after the last change of a field [ms]
  let [shown, waits, under, running] = [null, null, "", false]; // what is known of the entries, and which they are

  /** What an answer is simulated from; another one makes what is under way old. */
  const simulatedOf = ({ settings: { middleware, channel, swarm, nodes, within, start, secure, ros } }) => JSON.stringify([middleware, channel.name, swarm, nodes, within, start, secure, ros]);

  function simulate(answer) {
    const key = simulatedOf(answer);
    if (key === under) return;
    [under, shown, running] = [key, null, true];
    simulation.stop();
    clearTimeout(waits);
    const { settings, hosts } = answer;
    const { start, secure, swarm: fleet } = settings;
    running = hosts + fleet.N_H1 > 1 && !secure;
    showProgress(0);
    if (!running) {
      lanes.show(null);
      return;
    }
    const { caution, ratios } = answer.front.protocol;
    const today = { name: settings.middleware, air: settings.channel, fleet, caution, ratios, reboots: start === REBOOT };
    const planned = (airtimeOf) => {
      if (byCell(fleet) && airtimeOf) Object.assign(answer, plannedOf(settings, changesByCell(settings, airtimeOf)));
      const { changes, turn, closest } = answer;
      const reason = turn?.window === 0 ? decapitalized(MODEL.sentences["periodic traffic fills"]) : "";
      return { changes, closest, window: turn?.window, reason };
    };
    waits = setTimeout(() => {
      simulation.simulate(today, planned, settings.within, (found, onlyPart) => {
        if (key !== under) return;
        if (!onlyPart) shown = found;
        running = !found.over;
        showProgress(found.part);
        if (onlyPart) return;
        showAnswer(answer, shown);
        showChanges(answer, shown);
        showLanes(answer, shown);
      });
    }, WAIT);
  }

  /** One startup of the fleet, frame by frame; the last one stays until there is another. */
  function showLanes({ front, settings: { swarm } }, { sent, left }) {
    if (sent === undefined) {
      if (!left.length) lanes.show(null);
      return;
    }
    if (sent === pictured) return;
    pictured = sent;
    if (sent === null) {
      lanes.show(null);
      return;
    }
    const { converged, until, hosts } = sent;
    const length = Math.min(converged, until);
    const complete = Number.isFinite(converged) ? `complete after ${duration(converged)}` : `not complete after ${duration(until)}`;
    const nameOf = (host) => (host < swarm.N_H ? `robot ${host + 1}` : chosen("beside") === LAPTOP ? "laptop" : `computer ${host - swarm.N_H + 1}`);
    const label = `One simulated startup of ${plural(hosts, "host")} with ${front.name}, ${complete}: a lane for each host with the frames it sends, and the queue at the access point.`;
    lanes.show({ ...sent, nameOf, length, from: front.protocol.color, words: complete, label });
  }

  function showProgress(part) {
    if (part === null) byId("progress").removeAttribute("value");
    else byId("progress").value = part;
    byId("progress").hidden = !running;
    byId("simulate").hidden = !running && under !== "";
    byId("simulate").textContent = running ? "Stop" : "Simulate";
  }

  /** Stop what is under way, or begin again. */
  function press() {
    if (!drawn) return;
    if (!running) {
      under = "";
      update({ address: false });
      return;
    }
    clearTimeout(waits);
    simulation.stop();
    shown = { today: null, changes: [], reason: "you stopped the simulation", ...shown, left: [], known: true, over: true };
    [running, under] = [false, ""];
    showProgress(0);
    showAnswer(drawn, shown);
    showChanges(drawn, shown);
  }

  // ---- changes that the reader applied: in the fields where these can say it, else kept beside them ----

  let applied = []; // kinds

  function apply(kind) {
    const change = drawn.changes.find((one) => one.kind === kind);
    if (!change) return;
    const { settings } = drawn;
    const listed = channels.get(change.air.name);
    if (change.name !== settings.middleware && NAMES.includes(change.name)) byId("middleware").value = change.name;
    else if (change.air !== settings.channel && listed && Boolean(listed.full) === Boolean(change.air.full)) byId("channel").value = change.air.name;
    else applied = [...applied, kind];
    byId("said").textContent = `Applied: ${change.what}.`;
    update();
    byId("answer").focus();
  }

  function undo(kind) {
    applied = applied.filter((one) => one !== kind);
    update();
    byId("answer").focus();
  }

  /** Read the fields and show what follows; returns whether all were valid. */
  function update({ address = true } = {}) {
    fitRelease();
    showLists();
    for (const list of LISTS) showError(list, refused[list] ?? "");
    const read = readForm();
    const settings = read && withApplied(read, applied);
    byId("stale").hidden = settings !== null || drawn === null;
    if (settings !== null) {
      applied = settings.with.map(({ kind }) => kind);
      const answer = compute(settings);
      draw(answer); // first: it reads the width, before the others make the page be laid out anew
      simulate(answer);
      showAnswer(answer, shown);
      showChanges(answer, shown);
      showAll(answer);
      showParts(answer);
      showLegend(answer);
      byId("link").setAttribute("href", hash());
      if (address) writeHash();
    }
    return settings !== null;
  }

  function start() {
    buildForm();
    readTheme();
    byId("tool").hidden = false;
    const form = byId("form");
    update({ address: false }); // an answer to fall back on, should the address ask for nonsense
    byId("form").addEventListener("reset", () => (applied = []));
    if (readHash()) update({ address: false });
    form.addEventListener("input", ({ target }) => {
      delete refused[target.id.replace("calc-", "")];
      if (target === byId("ros")) takeRelease();
      if (target === byId("robot")) takeRobot();
      else if ([byId("processes"), byId("endpoints")].includes(target)) byId("robot").value = OWN;
      update();
    });
    form.addEventListener("submit", (event) => event.preventDefault());
    byId("reset").addEventListener("click", () => {
      form.reset();
      refused = {};
      update();
    });
    byId("csv").addEventListener("click", download);
    for (const name of ["command", "toml"]) byId(`${name}-copy`).addEventListener("click", ({ target }) => copied(target, byId(name).textContent));
    byId("simulate").addEventListener("click", press);
    byId("picture").addEventListener("click", async () => save(await lanes.picture(`${capitalized(everybody(drawn.settings))}, ${drawn.front.name}:`), "startup.png"));
    byId("tool").addEventListener("click", ({ target }) => {
      if (target.dataset.apply) apply(target.dataset.apply);
      else if (target.dataset.undo) undo(target.dataset.undo);
    });
    byId("link").addEventListener("click", (event) => {
      event.preventDefault();
      copied(byId("link"), byId("link").href);
    });
    addEventListener("hashchange", () => {
      if (readHash()) update({ address: false });
    });
    new MutationObserver(() => {
      readTheme();
      lanes.paint();
      draw(drawn);
      showParts(drawn);
      showAll(drawn);
      showLegend(drawn);
    }).observe(document.documentElement, {
      attributes: true,
      attributeFilter: ["data-theme"],
    });
    let width = byId("plot").clientWidth;
    new ResizeObserver(() => {
      if (byId("plot").clientWidth === width) return;
      width = byId("plot").clientWidth;
      draw(drawn);
    }).observe(byId("plot"));
  }

  start();
})();
