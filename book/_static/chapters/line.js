// Fig. 3 to touch: a line of robots with the same number of endpoints in all, drawn over the stored
// figure. Where the panels are and what utilization is comes from the package, in the data on the
// page (discostorm.book.pages); what is here adds up that polynomial and turns it into places.
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("line-data").textContent);
  const figure = document.getElementById("fig-paper-3");
  const [fewest, most, start] = DATA.endpoints;
  const [first, last, begun] = DATA.processes;
  const state = { endpoints: start, processes: begun };
  const SVG = "http://www.w3.org/2000/svg";
  const STEPS = 200; // of a curve

  function make(tag, attributes = {}, ...children) {
    const drawn = ["svg", "path", "circle", "text", "clipPath", "rect", "g"].includes(tag);
    const element = drawn ? document.createElementNS(SVG, tag) : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  const within = (value, low, high) => Math.min(high, Math.max(low, value));
  const utilization = ({ terms }, processes) =>
    terms.reduce((sum, [i, j, factor]) => sum + factor * processes ** i * (state.endpoints / processes) ** j, 0);

  // ---- places: from the panel's own units to the figure, and back ----

  const [width, height] = DATA.size;
  const panels = DATA.panels.map(({ x, y, xlim, ylim }, index) => {
    const across = (part, [from, to]) => from + part * (to - from);
    const share = (value, [from, to]) => (value - from) / (to - from);
    return {
      index,
      xlim,
      left: width * x[0],
      right: width * x[1],
      top: height * y[1],
      bottom: height * y[0],
      place: (a, b) => [width * across(share(a, xlim), x), height * across(share(b, ylim), y)],
      value: (a, b) => [across(share(a / width, x), xlim), across(share(b / height, y), ylim)],
    };
  });
  const [below] = panels.slice(-1);
  const maps = panels.slice(0, -1);

  // ---- what is drawn ----

  const picture = make("svg", { class: "line-picture", viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" });
  for (const { index, left, right, top, bottom } of panels) {
    const box = { x: left, y: top, width: right - left, height: bottom - top };
    picture.append(make("clipPath", { id: `line-clip-${index}` }, make("rect", box)));
  }
  const inside = ({ index }, ...children) => {
    const group = make("g", { "clip-path": `url(#line-clip-${index})` }, ...children);
    picture.append(group);
    return group;
  };
  const lines = maps.map((panel) => {
    const line = { panel, path: make("path", { class: "line-line" }), grip: make("path", { class: "line-grip" }), dot: make("circle", { class: "line-dot line-grip", r: 8 }) };
    inside(panel, line.path, line.grip);
    picture.append(line.dot);
    return line;
  });
  const curves = DATA.protocols.map((protocol) => {
    const curve = { protocol, path: make("path", { class: "line-curve" }), dot: make("circle", { class: "line-end", r: 6 }), name: make("text", { class: "line-name" }) };
    inside(below, curve.path, curve.dot);
    picture.append(curve.name);
    for (const part of [curve.path, curve.dot, curve.name]) part.style.setProperty("--color", `var(${protocol.color})`);
    return curve;
  });

  function drawn({ place, xlim }, height) {
    const from = Math.max(first, xlim[0]);
    const to = Math.min(last, xlim[1]);
    const at = Array.from({ length: STEPS + 1 }, (_, step) => from + (step / STEPS) * (to - from));
    return `M${at.map((processes) => place(processes, height(processes)).map((x) => x.toFixed(1)).join()).join("L")}`;
  }

  function put(dot, [x, y]) {
    dot.setAttribute("cx", x);
    dot.setAttribute("cy", y);
  }

  // ---- what is said ----

  const percent = (share) => `${(100 * share).toFixed(1)}%`;
  const split = (processes) => {
    const each = state.endpoints / processes;
    if (processes === 1) return "1 process";
    return `${processes} processes of ${Number.isInteger(each) ? each : `${each.toFixed(1)} endpoints on average`}`;
  };
  const listed = (processes) => DATA.protocols.map((one) => `${percent(utilization(one, processes))} with ${one.name}`).join(" and ");
  function said() {
    const { endpoints, processes } = state;
    const robots = `${DATA.hosts} robots with ${endpoints} endpoints each, in ${split(processes)}, need ${listed(processes)} of one second.`;
    return processes === first ? robots : `${robots} In 1 process they need ${listed(first)}.`;
  }

  function slider(name, label, least, greatest) {
    const shown = make("output", { id: `line-${name}-shown` });
    const input = make("input", { type: "range", id: `line-${name}`, min: least, max: greatest, step: 1, autocomplete: "off" });
    input.addEventListener("input", () => show({ [name]: input.valueAsNumber }));
    return { name, input, shown, box: make("label", {}, make("span", {}, `${label}: `, shown), input) };
  }
  const sliders = [
    slider("endpoints", "Endpoints of a robot, M", fewest, most),
    slider("processes", "Processes they are split into", first, last),
  ];
  const told = make("p", { class: "line-told", role: "status" });
  const controls = make(
    "div",
    { class: "line-controls", role: "group", "aria-label": "Move the line of Fig. 3" },
    make("p", { class: "line-how" }, "Drag the line in a map, or use the sliders."),
    ...sliders.map(({ box }) => box),
    told,
  );

  function show(changed) {
    Object.assign(state, changed);
    const { endpoints, processes } = state;
    for (const { name, input, shown } of sliders) {
      input.value = state[name];
      shown.textContent = String(state[name]);
    }
    for (const { panel, path, grip, dot } of lines) {
      const along = drawn(panel, (at) => endpoints / at);
      path.setAttribute("d", along);
      grip.setAttribute("d", along);
      const [x, y] = panel.place(processes, endpoints / processes);
      put(dot, [x, Math.max(panel.top, y)]);
      dot.classList.toggle("line-outside", y < panel.top); // more endpoints of each than the map shows
    }
    const ends = curves.map(({ protocol, path, dot }) => {
      path.setAttribute("d", drawn(below, (at) => utilization(protocol, at)));
      const end = below.place(processes, utilization(protocol, processes));
      put(dot, end);
      return end;
    });
    // Names stand beside their dots, one above the other, and within the panel.
    const order = ends.map(([, y], index) => [y, index]).sort(([a], [b]) => a - b);
    const right = processes < (first + last) / 2;
    let free = below.top + 16;
    order.forEach(([y, index], rank) => {
      const at = within(y + (right ? 20 * rank + 4 : -8), free, below.bottom - 6 - 18 * (order.length - 1 - rank));
      free = at + 18;
      const { name, protocol } = curves[index];
      name.textContent = `${protocol.name} ${percent(utilization(protocol, processes))}`;
      name.setAttribute("x", ends[index][0] + (right ? 12 : -12));
      name.setAttribute("y", at);
      name.setAttribute("text-anchor", right ? "start" : "end");
    });
    told.textContent = said();
  }

  // ---- the pointer: the line goes where it is dragged to ----

  function drag({ panel }, { clientX, clientY }) {
    const box = picture.getBoundingClientRect();
    const [processes, endpoints] = panel.value(
      ((clientX - box.left) / box.width) * width,
      ((clientY - box.top) / box.height) * height,
    );
    const [from, to] = panel.xlim;
    const across = within(processes, Math.max(first, from), Math.min(last, to));
    show({ endpoints: within(Math.round(across * Math.max(0, endpoints)), fewest, most), processes: Math.round(across) });
  }
  for (const line of lines)
    for (const grip of [line.grip, line.dot]) {
      grip.addEventListener("pointerdown", (event) => {
        if (event.button !== 0) return;
        grip.setPointerCapture(event.pointerId);
        event.preventDefault(); // no text is selected
        drag(line, event);
      });
      grip.addEventListener("pointermove", (event) => {
        if (grip.hasPointerCapture(event.pointerId)) drag(line, event);
      });
    }

  // ---- on the page: over the picture, which is as large as it likes ----

  figure.querySelector("figcaption").before(controls);
  show({});
  addEventListener("load", () => {
    const image = figure.querySelector("img");
    const box = image.closest(".ds-figure") ?? image.parentElement;
    box.classList.add("line-box");
    box.append(picture);
    const cover = () => {
      // The box scrolls sideways on a phone; what is in it goes along.
      const [outer, inner] = [box.getBoundingClientRect(), image.getBoundingClientRect()];
      picture.style.left = `${inner.left - outer.left + box.scrollLeft}px`;
      picture.style.top = `${inner.top - outer.top + box.scrollTop}px`;
      picture.style.width = `${inner.width}px`;
      picture.style.height = `${inner.height}px`;
    };
    new ResizeObserver(cover).observe(image);
    cover();
  });
})();
