// The calculator page: reads the fields, asks the functions of model.js, shows and draws what
// they say. All formulas are in model.js, which is made from the Python package.
"use strict";

(() => {
  const MODEL = DISCOSTORM;
  const NAMES = Object.keys(MODEL.protocols);
  const PAPER = "paper";
  const OWN = "own";
  // Curves and markers differ in shape too, not in colour alone.
  const DASHES = [[], [9, 6], [2, 4], [9, 3, 2, 3], [14, 4]];
  const dashOf = (name) => DASHES[NAMES.indexOf(name) % DASHES.length];
  const CURVE_POINTS = 120;

  const byId = (id) => document.getElementById(`calc-${id}`);

  /** Make an element: attributes, then children, which are elements or text. */
  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  // ---- numbers in words ----

  const significant = new Intl.NumberFormat("en-US", { maximumSignificantDigits: 3 });
  const whole = new Intl.NumberFormat("en-US", { maximumFractionDigits: 0 });
  const tenth = new Intl.NumberFormat("en-US", { maximumFractionDigits: 1 });
  const scientific = new Intl.NumberFormat("en-US", { notation: "scientific", maximumFractionDigits: 2 });

  function number(value) {
    if (!Number.isFinite(value)) return "more than can be computed";
    if (value >= 1e9 || (value > 0 && value < 1e-6)) return scientific.format(value).replace("E", "e");
    return value >= 1000 ? whole.format(value) : value >= 100 ? tenth.format(value) : significant.format(value);
  }

  // No line ends between a number and its unit.
  const SPACE = "\u00a0";
  /** What is below 100% is never shown as 100%. */
  function percent(share) {
    const text = number(100 * share);
    return share < 1 && text === number(100) ? "just below 100%" : `${text}%`;
  }
  const seconds = (value) => `${number(value)}${SPACE}s`;
  const count = (value) => (value < 1e9 && Number.isInteger(value) ? whole.format(value) : number(value));
  const plural = (value, one, many) => `${count(value)} ${value === 1 ? one : many}`;

  /** A number as shown, with all its digits and what it is of for machines. */
  const exact = (value, text, of) => make("data", { value: String(value), "data-of": of }, text);

  // ---- the fields ----

  const FIELDS = [...MODEL.fields.swarm, ...MODEL.fields.own];
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
      "aria-describedby": `${id}-hint ${id}-error`,
    });
    parent.append(
      make(
        "div",
        { class: "calc-field" },
        make("label", { for: id }, field.label + unit),
        input,
        make("span", { class: "calc-hint", id: `${id}-hint` }, field.allowed),
        make("span", { class: "calc-error", id: `${id}-error`, role: "alert" }),
      ),
    );
  }

  function buildForm() {
    for (const name of NAMES) {
      const id = `calc-middleware-${name}`;
      const radio = make("input", {
        type: "radio",
        name: "middleware",
        id,
        value: name,
        "aria-describedby": "calc-middleware-hint",
      });
      radio.defaultChecked = name === NAMES[0];
      byId("middleware-hint").before(make("label", { class: "calc-choice", for: id }, radio, ` ${name}`));
    }
    for (const field of MODEL.fields.swarm) addField(byId("swarm"), field);
    for (const field of MODEL.fields.own) addField(byId("own"), field);

    const groups = { linear: "As in the paper", padded: "From the standard", aggregated: "With aggregation" };
    const select = byId("channel");
    for (const [model, label] of Object.entries(groups)) {
      const group = make("optgroup", { label });
      for (const [key, channel] of channels) {
        const name = key === PAPER ? "The paper's, 802.11n" : channel.name;
        if (channel.model === model) group.append(make("option", { value: key }, name));
      }
      if (model === "linear") group.append(make("option", { value: OWN }, "Own rates and overheads"));
      select.append(group);
    }
  }

  const middleware = () => byId("form").elements.middleware.value;
  const isOwn = () => byId("channel").value === OWN;
  const usedFields = () => (isOwn() ? FIELDS : MODEL.fields.swarm);

  const brief = (text) => (text.length > 24 ? `${text.slice(0, 24)}…` : text);

  /** Return the number in a field in SI units, or why there is none. */
  function readField(field) {
    const text = byId(field.name).value.trim();
    const value = /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) * field.scale : NaN;
    const fits = (field.above ? value > field.low : value >= field.low) && value <= field.high;
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
    if (error && !input.matches("fieldset")) input.setAttribute("aria-invalid", "true");
    else input.removeAttribute("aria-invalid");
  }

  /** Return the settings, or null if one is not valid; each error is shown at its field. */
  function readForm() {
    const values = {};
    let valid = true;
    for (const field of FIELDS) {
      const { value, error } = usedFields().includes(field) ? readField(field) : {};
      showError(field.name, error ?? "");
      if (error) valid = false;
      else if (value !== undefined) values[field.symbol] = value;
    }
    if (!valid) return null;
    const channel = isOwn() ? { name: "own", model: "linear", values: {} } : channels.get(byId("channel").value);
    return { middleware: middleware(), channel, values: { ...channel.values, ...values, ...MODEL.limit } };
  }

  // ---- the answer: nothing but calls of the functions in model.js ----

  function answerOf(name, channel, given) {
    const protocol = MODEL.protocols[name];
    const formulas = protocol.models[channel.model];
    const values = { ...protocol.values, ...given };
    const single = formulas.utilization({ ...values, N_H: 1 });
    // As in Python: one host alone must not exceed the limit, else there is no such number.
    const fits = single <= values.U_limit;
    const saturation = fits ? Math.max(1, formulas.saturation(values)) : null;
    return {
      name,
      single,
      saturation,
      largest: fits ? MODEL.largest({ N_sat: saturation }) : 0,
      utilization: formulas.utilization(values),
      at: (hosts) => formulas.utilization({ ...values, N_H: hosts }),
      messages: protocol.messages.map((message) => ({
        name: message.name,
        phase: message.phase,
        cast: message.cast,
        load: message.load(values),
        up: formulas.costs[message.name].up(values),
        down: formulas.costs[message.name].down(values),
        both: formulas.costs[message.name].both(values),
      })),
      products: Object.entries(formulas.products).map(([product, formula]) => {
        const own = { ...values, ...formula.values };
        const burst = formula.burst(own);
        const steady = formula.steady(own);
        const drain = MODEL.drain({ B: burst, rho: steady });
        const { lease, until, never } = protocol.outlooks[product];
        const found = drain < Infinity && until.find(([limit]) => drain <= limit);
        return { name: product, steady, drain, lease, outlook: found ? found[1] : never };
      }),
    };
  }

  function compute(settings) {
    const names = NAMES.filter((name) => name === settings.middleware || MODEL.compared.includes(name));
    const all = names.map((name) => answerOf(name, settings.channel, settings.values));
    const front = all.find((one) => one.name === settings.middleware);
    return { settings, hosts: settings.values.N_H, all, front };
  }

  // ---- showing it ----

  const fullAt = (one) =>
    one.saturation === null ? "less than one host" : plural(Number(number(one.saturation)) || one.saturation, "host", "hosts");

  function sentence(one) {
    const full =
      one.saturation === null
        ? `A single host already takes ${percent(one.single)}.`
        : `The channel is full at ${number(one.saturation)} hosts: ${count(one.largest)} ${one.largest === 1 ? "stays" : "stay"} below 100%.`;
    return `${one.name}: discovery takes ${percent(one.utilization)} of the channel. ${full}`;
  }

  function showAnswer(answer) {
    const { N_P, N_E } = answer.settings.values;
    const swarm =
      `${plural(answer.hosts, "host", "hosts")} with ${plural(N_P, "process", "processes")} of ` +
      `${plural(N_E, "endpoint", "endpoints")} each, ${channelName(answer.settings.channel)}.`;
    const others = answer.all.filter((one) => one !== answer.front);
    byId("answer").replaceChildren(
      make("strong", {}, sentence(answer.front)),
      ` ${others.map(sentence).join(" ")} `,
      make("span", { class: "calc-hint" }, `For ${swarm} ${assumed(answer.settings.channel)}`),
    );
  }

  const channelName = (channel) =>
    channel.name === OWN ? "own rates and overheads" : channel === channels.get(PAPER) ? "the paper's Wi-Fi" : channel.name;

  /** What every number of this page assumes. */
  function assumed(channel) {
    const frames =
      channel.model === "aggregated"
        ? `${count(channel.values.n_agg)} frames in every exchange where that many fit`
        : "each message a frame of its own";
    return `Assumed: the paper's messages, all sent in one second; ${frames}; no losses or collisions.`;
  }

  function showBoth(answer) {
    const table = byId("both");
    table.tHead.rows[0].replaceChildren(
      make("td"),
      ...answer.all.map((one) =>
        make("th", { scope: "col" }, sample(one), ` ${one.name}`, one === answer.front ? " (in detail below)" : ""),
      ),
    );
    const products = (one, show) =>
      one.products.map((product) =>
        make("div", {}, `${product.name}: `, ...show(product, one)),
      );
    const rows = [
      ["Utilization", (one) => [exact(one.utilization, percent(one.utilization), `${one.name} utilization`)]],
      [
        "Verdict",
        (one) => [one.utilization >= answer.settings.values.U_limit ? "the channel is full" : "below 100%"],
      ],
      [
        "The channel is full at",
        (one) => [exact(one.saturation ?? NaN, fullAt(one), `${one.name} saturation`)],
      ],
      [
        "Largest swarm below 100%",
        (one) => [exact(one.largest, plural(one.largest, "host", "hosts"), `${one.name} largest`)],
      ],
      [
        "The start takes at best (the paper's messages, default periods of)",
        (one) =>
          products(one, ({ name, drain, outlook, lease }) => [
            exact(drain, drain < Infinity ? `${seconds(drain)}, ${outlook}` : outlook, `${one.name} drain ${name}`),
            ` (lease ${seconds(lease)})`,
          ]),
      ],
      [
        "What is repeated takes (the paper's messages, default periods of)",
        (one) =>
          products(one, ({ name, steady }) => [exact(steady, percent(steady), `${one.name} steady ${name}`)]),
      ],
    ];
    table.tBodies[0].replaceChildren(
      ...rows.map(([head, cell]) =>
        make("tr", {}, make("th", { scope: "row" }, head), ...answer.all.map((one) => make("td", {}, ...cell(one)))),
      ),
    );
  }

  function showParts(answer) {
    const { front } = answer;
    byId("parts-title").textContent = `What takes the airtime with ${front.name}`;
    const [body] = byId("parts").tBodies;
    body.replaceChildren(
      ...front.messages.map((message) => {
        const share = message.both / front.utilization || 0;
        const bar = make("span", { class: "calc-bar", "aria-hidden": "true" }, make("span"));
        bar.firstChild.style.width = `${100 * share}%`;
        bar.firstChild.style.background = MODEL.protocols[front.name].color;
        const of = (what) => `${front.name} ${message.name} ${what}`;
        return make(
          "tr",
          {},
          make("th", { scope: "row" }, message.name, make("span", { class: "calc-hint" }, ` ${message.cast}`)),
          make("td", {}, exact(message.load, count(message.load), of("messages"))),
          make("td", {}, exact(message.both, seconds(message.both), of("airtime"))),
          make("td", {}, percent(share), bar),
        );
      }),
    );
  }

  // ---- the plot ----

  /** A piece of a protocol's line, for the legend. */
  function sample(one) {
    const draw = (tag, attributes) => {
      const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
      for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
      return element;
    };
    const svg = draw("svg", { class: "calc-sample", viewBox: "0 0 36 8", "aria-hidden": "true" });
    const stroke = MODEL.protocols[one.name].color;
    const dash = dashOf(one.name).join(" ");
    svg.append(draw("line", { x2: 36, y1: 4, y2: 4, stroke, "stroke-width": 3, "stroke-dasharray": dash }));
    return svg;
  }

  // The theme's colours; read when they change only, as that takes time.
  let theme = {};

  function readTheme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(`--pst-color-${name}`).trim();
    theme = { text: color("text-base"), background: color("background"), border: color("border") };
  }

  let plot = null;
  let drawn = null;

  /** Return what the axes show: where they end, and whether they are logarithmic. */
  function view(answer) {
    const points = answer.all.map((one) => one.utilization);
    const full = answer.all.map((one) => one.saturation).filter((hosts) => hosts !== null);
    const limit = answer.settings.values.U_limit;
    const far = Math.max(...points) > 4 * limit || answer.hosts > 4 * Math.max(1, ...full);
    if (far) {
      const singles = answer.all.map((one) => one.single);
      return {
        log: true,
        hosts: 1.5 * Math.max(2, answer.hosts, ...full),
        low: Math.min(0.5 * limit, ...singles) / 1.5,
        high: 2 * Math.max(limit, ...points),
      };
    }
    return {
      log: false,
      hosts: Math.max(1.25 * Math.max(1, ...full), 1.15 * answer.hosts, answer.hosts + 1),
      low: 0,
      high: 1.25 * Math.max(limit, ...points),
    };
  }

  /** Where a logarithmic axis has its marks: uPlot's own ones end at 1e32. */
  function powers(least, most) {
    const first = Math.ceil(Math.log10(least) - 1e-9);
    const last = Math.floor(Math.log10(most) + 1e-9);
    const step = Math.max(1, Math.ceil((last - first) / 5));
    const marks = [];
    for (let power = first; power <= last; power += step) marks.push(10 ** power);
    if (marks.length > 2) return marks;
    return [first - 1, first, last]
      .flatMap((power) => [1, 2, 5].map((digit) => digit * 10 ** power))
      .filter((value, i, all) => value >= least && value <= most && all.indexOf(value) === i);
  }

  /** A mark of a logarithmic axis: 100, but 2·10⁷. */
  function short(value) {
    if (value >= 1e-3 && value < 1e5) return number(value);
    const [digit, power] = value.toExponential(0).split("e");
    const raised = [...String(Number(power))].map((c) => "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"["-0123456789".indexOf(c)]).join("");
    return `${digit === "1" ? "" : `${digit}·`}10${raised}`;
  }

  function curve(answer) {
    const { log, hosts } = view(answer);
    const x = [];
    for (let i = 0; i <= CURVE_POINTS; i++) {
      const part = i / CURVE_POINTS;
      x.push(log ? hosts ** part : 1 + (hosts - 1) * part);
    }
    return { x, lines: answer.all.map((one) => x.map(one.at)) };
  }

  function marks(answer) {
    const { text, background } = theme;
    return (u) => {
      const { ctx, bbox } = u;
      const scale = devicePixelRatio;
      const limit = u.valToPos(100 * answer.settings.values.U_limit, "y", true);
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
      ctx.font = `${13 * scale}px sans-serif`;
      ctx.textAlign = "left";
      ctx.textBaseline = "bottom";
      ctx.fillText("100%: full", bbox.left + 6 * scale, limit - 3 * scale);
      // The one in front last, so that its point is on top.
      for (const one of [...answer.all].sort((a) => (a === answer.front ? 1 : -1))) {
        const x = u.valToPos(answer.hosts, "x", true);
        const y = u.valToPos(100 * one.utilization, "y", true);
        ctx.beginPath();
        ctx.arc(x, y, 6 * scale, 0, 2 * Math.PI);
        ctx.fillStyle = one === answer.front ? MODEL.protocols[one.name].color : background;
        ctx.strokeStyle = one === answer.front ? text : MODEL.protocols[one.name].color;
        ctx.lineWidth = 2 * scale;
        ctx.fill();
        ctx.stroke();
      }
      ctx.restore();
    };
  }

  function draw(answer) {
    drawn = answer;
    const box = byId("plot");
    plot?.destroy();
    plot = null;
    const points = answer.all.map((one) => one.utilization);
    const what =
      `Channel utilization against the number of hosts: ${answer.all.map((one) => one.name).join(" and ")} curve upwards and cross ` +
      `the line of 100 percent. Your swarm is a point on each curve.`;
    if (!points.every((value) => value < 1e300)) {
      box.setAttribute("aria-label", "No curve: the numbers are too large to draw.");
      box.textContent = "The numbers are too large to draw.";
      return;
    }
    box.textContent = "";
    box.setAttribute("aria-label", `${what} ${answer.all.map(sentence).join(" ")}`);
    const { log, hosts, low, high } = view(answer);
    const { x, lines } = curve(answer);
    const { text, border } = theme;
    const axis = (label, size) => ({
      label,
      size,
      labelSize: 24,
      stroke: text,
      font: "13px sans-serif",
      labelFont: "13px sans-serif",
      grid: { stroke: border, width: 1 },
      ticks: { stroke: border, width: 1 },
      ...(log ? { splits: (u, index, least, most) => powers(least, most), filter: (u, splits) => splits } : {}),
      values: (u, splits) => splits.map(log ? short : number),
    });
    // The one in front is drawn last and thickest.
    const order = answer.all.map((one, index) => index).sort((a) => (answer.all[a] === answer.front ? 1 : -1));
    plot = new uPlot(
      {
        width: box.clientWidth,
        height: 320,
        cursor: { show: false },
        legend: { show: false },
        select: { show: false },
        scales: {
          x: { time: false, distr: log ? 3 : 1, range: [1, hosts] },
          y: { distr: log ? 3 : 1, range: [100 * low, 100 * high] },
        },
        axes: [
          axis(`hosts${log ? ", logarithmic" : ""}`, 36),
          axis(`channel utilization [%]${log ? ", logarithmic" : ""}`, 58),
        ],
        series: [
          {},
          ...order.map((index) => ({
            stroke: MODEL.protocols[answer.all[index].name].color,
            width: answer.all[index] === answer.front ? 3 : 2,
            dash: dashOf(answer.all[index].name),
            points: { show: false },
            pxAlign: 0,
          })),
        ],
        hooks: { draw: [marks(answer)] },
      },
      [x, ...order.map((index) => lines[index].map((value) => 100 * value))],
      box,
    );
  }

  function showLegend(answer) {
    const dot = (one) => {
      const { color } = MODEL.protocols[one.name];
      const element = make("span", { class: "calc-dot", "aria-hidden": "true" });
      element.style.borderColor = one === answer.front ? "currentcolor" : color;
      element.style.background = one === answer.front ? color : "none";
      return element;
    };
    byId("legend").replaceChildren(
      ...answer.all.map((one) => make("li", {}, sample(one), ` ${one.name}`)),
      ...answer.all.map((one) => make("li", {}, dot(one), ` your swarm, ${one.name}: ${percent(one.utilization)}`)),
    );
    byId("caption").textContent =
      `Utilization against the number of hosts, with as many processes and endpoints as you entered.`;
  }

  // ---- the numbers as CSV ----

  function csv(answer) {
    const quote = (cell) => (/[",\n]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : String(cell));
    const { settings, hosts } = answer;
    const rows = [["protocol", "quantity", "of", "hosts", "value", "unit"]];
    rows.push(["", "channel", settings.channel.name, "", "", ""]);
    for (const field of FIELDS) {
      const unit = { "Mbit/s": "bit/s", "µs": "s" }[field.unit] ?? "1";
      rows.push(["", "input", field.symbol, "", settings.values[field.symbol], unit]);
    }
    for (const one of answer.all) {
      rows.push([one.name, "utilization", "", hosts, one.utilization, "1"]);
      rows.push([one.name, "saturation", "", "", one.saturation ?? "", "hosts"]);
      rows.push([one.name, "largest swarm below 100%", "", "", one.largest, "hosts"]);
      for (const product of one.products) {
        rows.push([one.name, "drain time", product.name, hosts, product.drain, "s"]);
        rows.push([one.name, "steady utilization", product.name, hosts, product.steady, "1"]);
      }
      for (const message of one.messages) {
        rows.push([one.name, "uplink messages", message.name, hosts, message.load, "1"]);
        rows.push([one.name, "uplink airtime", message.name, hosts, message.up, "s"]);
        rows.push([one.name, "downlink airtime", message.name, hosts, message.down, "s"]);
      }
    }
    const { x, lines } = curve(answer);
    answer.all.forEach((one, index) =>
      x.forEach((at, i) => rows.push([one.name, "curve", "utilization", at, lines[index][i], "1"])),
    );
    return rows.map((row) => row.map((cell) => quote(String(cell))).join(",") + "\r\n").join("");
  }

  function download() {
    if (!drawn) return;
    const url = URL.createObjectURL(new Blob([csv(drawn)], { type: "text/csv;charset=utf-8" }));
    make("a", { href: url, download: "discovery.csv" }).click();
    setTimeout(() => URL.revokeObjectURL(url), 10_000);
  }

  // ---- the state in the address ----

  function hash() {
    const parts = new URLSearchParams({ middleware: middleware() });
    for (const field of MODEL.fields.swarm) parts.set(field.name, byId(field.name).value.trim());
    parts.set("wifi", byId("channel").value);
    if (isOwn()) for (const field of MODEL.fields.own) parts.set(field.name, byId(field.name).value.trim());
    return `#${parts}`;
  }

  // Not on every key: browsers take a limited number of changes.
  let writing;

  function writeHash() {
    clearTimeout(writing);
    writing = setTimeout(() => history.replaceState(null, "", byId("link").getAttribute("href")), 200);
  }

  // What the address asked for and cannot have, by the field where it is shown.
  let refused = {};

  /** Fill the fields from the address; return whether it says anything of them. */
  function readHash() {
    clearTimeout(writing);
    const parts = new URLSearchParams(location.hash.slice(1));
    const known = ["middleware", "wifi", ...FIELDS.map((field) => field.name)];
    if (!known.some((name) => parts.has(name))) return false;
    byId("form").reset();
    refused = {};
    const refuse = (name, value) => {
      refused[name] = `The link asks for “${brief(value)}”, which is not in the list; this is used instead.`;
    };
    const front = parts.get("middleware");
    if (NAMES.includes(front)) byId(`middleware-${front}`).checked = true;
    else if (front !== null) refuse("middleware", front);
    const wifi = parts.get("wifi");
    if (channels.has(wifi) || wifi === OWN) byId("channel").value = wifi;
    else if (wifi !== null) refuse("channel", wifi);
    for (const field of FIELDS) if (parts.has(field.name)) byId(field.name).value = parts.get(field.name);
    return true;
  }

  // ---- putting it together ----

  function showChannel() {
    byId("own").hidden = !isOwn();
    const channel = channels.get(byId("channel").value);
    const { R_uni, O_uni, R_multi, O_multi, O_agg, n_agg } = channel?.values ?? {};
    const mega = (rate) => `${number(rate / 1e6)} Mbit/s`;
    const micro = (time) => `${number(time * 1e6)} µs`;
    byId("channel-hint").textContent = channel
      ? `unicast ${mega(R_uni)} and ${micro(O_agg ?? O_uni)}${O_agg ? ` for up to ${count(n_agg)} frames` : " a frame"}, ` +
        `multicast ${mega(R_multi)} and ${micro(O_multi)}`
      : "";
  }

  /** Read the fields and show what follows; returns whether all were valid. */
  function update({ address = true } = {}) {
    showChannel();
    for (const name of ["middleware", "channel"]) showError(name, refused[name] ?? "");
    const settings = readForm();
    byId("stale").hidden = settings !== null || drawn === null;
    if (settings !== null) {
      const answer = compute(settings);
      showAnswer(answer);
      showBoth(answer);
      showParts(answer);
      draw(answer);
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
    if (readHash()) update({ address: false });
    form.addEventListener("input", (event) => {
      if (event.target.matches("select")) delete refused.channel;
      if (event.target.matches("[type=radio]")) delete refused.middleware;
      update();
    });
    form.addEventListener("submit", (event) => event.preventDefault());
    byId("reset").addEventListener("click", () => {
      form.reset();
      refused = {};
      update();
    });
    byId("csv").addEventListener("click", download);
    addEventListener("hashchange", () => {
      if (readHash()) update({ address: false });
    });
    new MutationObserver(() => {
      readTheme();
      draw(drawn);
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
