// Three robots to click through, one message at a time. Who sends what to whom, in which order, comes from the
// package, in the data on the page (discostorm_book.interactive).
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("network-data").textContent);
  const { make, put, slider, within } = CHAPTER;
  const cell = document.getElementById("network-data").closest(".cell");
  const [WIDE, HIGH, R] = [360, 260, 15]; // of the picture, and of a process
  const POINT = [WIDE / 2, HIGH / 2 + 8]; // the access point
  // Where robots are, and their processes beside each other.
  const ROBOTS = [[62, 205], [WIDE / 2, 46], [WIDE - 62, 205]];
  const place = (process) => {
    const [x, y] = ROBOTS[Math.floor(process / DATA.processes)];
    return [x + ((process % DATA.processes) - (DATA.processes - 1) / 2) * 3 * R, y];
  };
  const name = (process) => `robot ${Math.floor(process / DATA.processes) + 1}, process ${(process % DATA.processes) + 1}`;
  const everyone = [...Array(DATA.processes * ROBOTS.length).keys()];
  const state = { protocol: 0, message: 1 };

  const picture = make("svg", { class: "network", viewBox: `0 0 ${WIDE} ${HIGH}`, "aria-hidden": "true" });
  for (const [number, [x, y]] of ROBOTS.entries()) {
    picture.append(make("rect", { class: "network-robot", x: x - 3.4 * R, y: y - 1.6 * R, width: 6.8 * R, height: 3.2 * R, rx: 8 }));
    picture.append(make("text", { x, y: y < POINT[1] ? y - 2 * R : y + 2.6 * R }, `robot ${number + 1}`)); // away from arrows
  }
  const ways = make("g", {});
  picture.append(ways);
  const dots = everyone.map((process) => {
    const dot = make("circle", { class: "network-process", r: R });
    put(dot, place(process));
    picture.append(dot);
    return dot;
  });
  picture.append(make("circle", { class: "network-ap", cx: POINT[0], cy: POINT[1], r: 9 }));
  picture.append(make("text", { class: "network-beside", x: POINT[0] + 18, y: POINT[1] }, "access point"));

  // An arrow between two places, which ends before them.
  function arrow([x, y], [u, v], before, after, color) {
    const long = Math.hypot(u - x, v - y);
    const at = (part) => [x + ((u - x) * part) / long, y + ((v - y) * part) / long];
    const [begin, end, neck] = [at(before), at(long - after), at(long - after - 9)];
    const [a, b] = [(4.5 * (v - y)) / long, (-4.5 * (u - x)) / long];
    const head = `M${end}L${neck[0] + a},${neck[1] + b}L${neck[0] - a},${neck[1] - b}Z`;
    for (const path of [make("path", { class: "network-way", d: `M${begin}L${neck}` }), make("path", { class: "network-head", d: head })]) {
      path.style.setProperty("--color", `var(${color})`);
      ways.append(path);
    }
  }

  const select = make("select", { id: "network-protocol", autocomplete: "off" }, ...DATA.protocols.map(({ name }, i) => make("option", { value: i }, name)));
  select.addEventListener("change", () => show({ protocol: Number(select.value), message: 1 }));
  const dial = slider("network", "Message", 1, DATA.protocols[0].messages.length, 1, (message) => show({ message }));
  const step = (label, by) => {
    const button = make("button", { type: "button" }, label);
    button.addEventListener("click", () => show({ message: state.message + by }));
    return button;
  };
  const [back, next] = [step("Back", -1), step("Next message", 1)];
  const told = make("p", { class: "line-told", role: "status" });
  const counts = make("p", { class: "network-counts" });
  const lead = make("p", { class: "line-how" }, make("strong", {}, "Click through the swarm."), " Send its messages one by one, and see which kind it sends most often.");
  const buttons = make("div", { class: "network-buttons" }, back, next);
  const chosen = make("div", {}, make("label", { for: select.id }, "Protocol: "), select);
  cell.after(make("div", { class: "line-controls choose", role: "group", "aria-label": "Messages of three robots" }, lead, picture, chosen, dial.box, buttons, told, counts));

  function show(changed) {
    Object.assign(state, changed);
    const { kinds, messages } = DATA.protocols[state.protocol];
    state.message = within(state.message, 1, messages.length);
    dial.box.querySelector("input").max = messages.length;
    dial.set(state.message);
    [back.disabled, next.disabled] = [state.message === 1, state.message === messages.length];
    const [kind, from, to, about] = messages[state.message - 1];
    const { color, says } = kinds[kind];
    const mine = (process) => Math.floor(process / DATA.processes) === Math.floor(from / DATA.processes);
    const hear = to === null ? everyone.filter((process) => !mine(process)) : [to];
    ways.replaceChildren();
    arrow(place(from), POINT, R + 2, 11, color);
    for (const process of hear) arrow(POINT, place(process), 11, R + 2, color);
    for (const [process, dot] of dots.entries()) {
      dot.classList.toggle("network-on", process === from || hear.includes(process));
      dot.style.setProperty("--color", `var(${color})`);
    }
    const words = { from: name(from), to: to === null ? "" : name(to), about };
    told.textContent = `Message ${state.message} of ${messages.length}: ${says.replace(/\{(\w+)\}/g, (_, key) => words[key])}`;
    const sent = kinds.map((_, i) => messages.slice(0, state.message).filter(([one]) => one === i).length);
    const bars = kinds.map(({ name, color }, i) => {
      const box = make("span", {}, make("i", {}), `${name} ${sent[i]}`);
      box.style.setProperty("--color", `var(${color})`);
      return box;
    });
    counts.replaceChildren("Sent so far: ", ...bars);
  }

  show({});
})();
