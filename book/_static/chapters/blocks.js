// Equation (12) to touch: its terms as blocks of airtime, one on the other, beside the line of one
// second, and the term of one message written out. What a frame costs, how many there are and what
// symbols mean comes from the package, in the data on the page (discostorm_book.interactive).
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("blocks-data").textContent);
  const figure = document.getElementById("fig-blocks");
  const { make } = CHAPTER;
  const size = Object.fromEntries(DATA.sizes.map(([name, , , start]) => [name, start]));
  const NAMED = 17; // px from which on a block has room for its name
  const ROOM = 1.06; // of the scale above what is drawn

  // ---- how much ----

  const sum = (values) => values.reduce((total, value) => total + value, 0);
  const count = ({ count: factors }) => factors.reduce((product, [name, less, power]) => product * ((size[name] ?? 0) - less) ** power, 1);
  const once = (message, way) => sum(message[way].seconds);
  const airtime = (message) => count(message) * (once(message, "up") + once(message, "down"));
  const total = ({ messages }) => sum(messages.map(airtime));
  const largest = ({ messages }) => messages.reduce((most, one) => (airtime(one) > airtime(most) ? one : most));
  const chosen = { protocol: DATA.protocols[0], message: largest(DATA.protocols[0]) };
  const seconds = (value) => `${value.toFixed(value < 10 ? 3 : 1)} s`;
  const nice = (least) => {
    const power = 10 ** Math.floor(Math.log10(least));
    return power * [1, 1.2, 1.5, 2, 3, 4, 6, 8, 10].find((step) => step * power >= least);
  };

  // ---- symbols, written as in the book ----

  function symbol(name) {
    const [letter, below] = name.split("_");
    return [make("i", {}, letter), make("sub", {}, below.length > 1 ? below : make("i", {}, below))];
  }
  const plain = (name) => name.replace("_", "");
  function meaning(name) {
    const [what, value] = DATA.symbols[name];
    return `${what}. Now ${value || size[name]}.`;
  }

  const tip = make("p", { class: "blocks-tip" });
  const INVITE = "Point at a symbol, or reach it with the keyboard: what it is stands here.";
  const explain = (name) => tip.replaceChildren(...(name ? [...symbol(name), `: ${meaning(name)}`] : [INVITE]));

  // A symbol that says what it is: to those who see it in the line below, to others in its name.
  function button(name) {
    const said = make("span", { class: "blocks-said" }, `: ${meaning(name)}`);
    const element = make("button", { type: "button", class: "blocks-symbol", "data-symbol": name }, ...symbol(name), said);
    for (const event of ["pointerenter", "focus", "click"]) element.addEventListener(event, () => explain(name));
    return element;
  }

  function counted({ count: factors }) {
    return factors.flatMap(([name, less, power]) => {
      if (!name) return [`${-less} `];
      const raised = power > 1 ? [make("sup", {}, power)] : [];
      return less ? ["(", button(name), ` \u2212 ${less})`, ...raised, " "] : [button(name), ...raised, " "];
    });
  }
  const frame = ({ header, payload }, { rate, overhead }) => [
    button(overhead),
    " + 8 (",
    button(header),
    " + ",
    button(payload),
    ") / ",
    button(rate),
  ];

  // ---- what is drawn ----

  const stage = make("div", { class: "blocks-stage", "aria-hidden": "true" });
  const line = make("div", { class: "blocks-line" }, make("span", {}, "one second"));
  const scale = make("div", { class: "blocks-scale" });
  const stacks = DATA.protocols.map((protocol) => {
    const stack = make("div", { class: "blocks-stack" });
    stack.style.setProperty("--color", `var(${protocol.color})`);
    const blocks = protocol.messages.flatMap((message) =>
      ["up", "down"].map((way) => {
        const name = make("span");
        const box = make("div", { class: "blocks-block" }, name);
        box.addEventListener("click", () => choose({ protocol, message }));
        stack.append(box);
        return { message, way, box, name };
      }),
    );
    const sum = make("strong", { class: "blocks-sum" });
    stack.append(sum);
    return { protocol, stack, blocks, sum };
  });
  stage.append(scale, ...stacks.map(({ stack }) => stack), line);

  function draw() {
    const top = nice(ROOM * Math.max(1, ...DATA.protocols.map(total)));
    const part = (value) => `${(100 * value) / top}%`;
    const high = stage.clientHeight;
    line.style.bottom = part(1);
    const step = nice(top / 6);
    const ticks = Array.from({ length: Math.floor(top / step + 1e-9) + 1 }, (_, tick) => tick * step);
    scale.replaceChildren(
      ...ticks.map((at) => {
        const tick = make("span", {}, `${Number(at.toPrecision(3))} s`);
        tick.style.bottom = part(at);
        return tick;
      }),
    );
    for (const { protocol, stack, blocks, sum: told } of stacks) {
      let below = 0;
      for (const { message, way, box, name } of blocks) {
        const each = count(message) * once(message, way);
        box.style.bottom = part(below);
        box.style.height = part(each);
        box.style.setProperty("--overhead", `${(100 * message[way].seconds[0]) / once(message, way)}%`);
        box.classList.toggle("blocks-chosen", message === chosen.message);
        name.textContent = (each / top) * high < NAMED ? "" : `${message.name} ${way}: ${seconds(each)}`;
        below += each;
      }
      told.textContent = `${protocol.name}: ${seconds(below)}`;
      stack.classList.toggle("blocks-other", protocol !== chosen.protocol);
    }
  }

  // ---- the equation: its terms, and the chosen one written out ----

  const equation = make("div", { class: "blocks-equation", role: "group", "aria-label": "Equation (12), written out" });
  const terms = make("div", { class: "blocks-terms" });
  const term = make("div", { class: "blocks-term" });
  const worked = make("span", { class: "blocks-worked" });
  equation.append(terms, term, tip);
  let buttons = [];

  function list() {
    buttons = chosen.protocol.messages.map((message) => {
      const value = make("span");
      const element = make("button", { type: "button" }, `${message.name} `, value);
      element.addEventListener("click", () => choose({ message }));
      return { message, element, value };
    });
    const { name, color } = chosen.protocol;
    equation.style.setProperty("--color", `var(${color})`);
    const signed = buttons.flatMap(({ element }, place) => [place ? " + " : " = ", element]);
    terms.replaceChildren(make("i", {}, "U"), make("sub", {}, name), ...signed);
  }

  function write() {
    const { message } = chosen;
    for (const { message: one, element, value } of buttons) {
      value.textContent = seconds(airtime(one));
      element.setAttribute("aria-pressed", one === message);
    }
    const ways = [make("span", {}, "[", ...frame(message, message.up)), make("span", {}, " + ", ...frame(message, message.down), "]")];
    term.replaceChildren(make("span", {}, make("b", {}, message.name), " = ", ...counted(message)), ...ways, " ", worked);
    const micro = (way) => `${(1e6 * once(message, way)).toFixed(0)} \u00b5s ${way}`;
    worked.textContent = `= ${count(message).toLocaleString("en-US")} \u00d7 (${micro("up")} + ${micro("down")}) = ${seconds(airtime(message))}`;
  }

  // ---- what is said ----

  const many = (number, one, more) => `${number} ${number === 1 ? one : more}`;
  function said() {
    const [hosts, processes, endpoints] = DATA.sizes.map(([name]) => size[name]);
    const swarm = `${many(hosts, "robot", "robots")} with ${many(processes, "process", "processes")} of ${many(endpoints, "endpoint", "endpoints")}`;
    const needs = DATA.protocols.map((one) => `${seconds(total(one))} with ${one.name}`).join(" and ");
    const fit = DATA.protocols.filter((one) => total(one) <= 1).map(({ name }) => name);
    const every = fit.length === DATA.protocols.length;
    const verdict = every ? "Both fit within one second." : fit.length ? `Only ${fit} fits within one second.` : "Neither fits within one second.";
    return `${swarm} ${hosts === 1 ? "needs" : "need"} ${needs}. ${verdict}`;
  }

  const NAMES = { N_H: "Hosts", N_P: "Processes of a host", N_E: "Endpoints of a process" };
  const sliders = DATA.sizes.map(([name, least, most]) =>
    CHAPTER.slider(plain(name), NAMES[name], least, most, 1, (value) => {
      size[name] = value;
      show();
    }),
  );
  const choice = make("fieldset", { class: "blocks-choice" }, make("legend", {}, "Write out:"));
  const radios = DATA.protocols.map((protocol) => {
    const input = make("input", { type: "radio", name: "blocks-protocol", autocomplete: "off" });
    input.addEventListener("change", () => choose({ protocol }));
    choice.append(make("label", {}, input, ` ${protocol.name}`));
    return { protocol, input };
  });
  const told = CHAPTER.controls(figure, "Equation (12) to touch", "Change the swarm, choose a term.", sliders);
  told.before(choice, equation);
  told.parentElement.prepend(stage);
  figure.classList.add("blocks-live");

  function choose({ protocol = chosen.protocol, message = largest(protocol) }) {
    const other = protocol !== chosen.protocol;
    Object.assign(chosen, { protocol, message });
    if (other) list();
    explain();
    show();
  }

  function show() {
    for (const [place, { set }] of sliders.entries()) set(size[DATA.sizes[place][0]]);
    for (const { protocol, input } of radios) input.checked = protocol === chosen.protocol;
    draw();
    write();
    told.textContent = said();
  }

  list();
  explain();
  show();
  new ResizeObserver(draw).observe(stage);
})();
