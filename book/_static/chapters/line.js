// Fig. 3 to touch: a line of robots with the same number of endpoints in all, drawn over the stored
// figure. Where the panels are and what utilization is comes from the package, in the data on the
// page (discostorm_book.interactive); what is here adds up that polynomial and turns it into places.
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("line-data").textContent);
  const figure = document.getElementById("fig-paper-3");
  const [fewest, most, start] = DATA.endpoints;
  const [first, last, begun] = DATA.processes;
  const state = { endpoints: start, processes: begun };
  const { make, put, within } = CHAPTER;
  const STEPS = 200; // of a curve

  const utilization = ({ terms }, processes) =>
    terms.reduce((sum, [i, j, factor]) => sum + factor * processes ** i * (state.endpoints / processes) ** j, 0);

  // ---- what is drawn ----

  const { picture, panels, inside } = CHAPTER.over(figure, DATA, () => show({}));
  const maps = panels.slice(0, -1);
  const [below] = panels.slice(-1);
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

  // ---- what is said ----

  const percent = (share) => `${(100 * share).toFixed(1)}%`;
  const split = (processes) => {
    const each = state.endpoints / processes;
    if (processes === 1) return "1 process";
    return `${processes} processes of ${Number.isInteger(each) ? each : `${each.toFixed(1)} endpoints on average`}`;
  };
  const listed = (processes, unit = "") =>
    DATA.protocols.map((one, place) => `${percent(utilization(one, processes))}${place ? "" : unit} with ${one.name}`).join(" and ");
  function said() {
    const { endpoints, processes } = state;
    const robots = `${DATA.hosts} robots with ${endpoints} endpoints each, in ${split(processes)}, need ${listed(processes, " of a second")}.`;
    return processes === first ? robots : `${robots} In 1 process they need ${listed(first)}.`;
  }

  const sliders = [
    ["endpoints", "Endpoints of a robot, M", fewest, most],
    ["processes", "Processes they are split into", first, last],
  ].map(([name, label, least, greatest]) => CHAPTER.slider(name, label, least, greatest, 1, (value) => show({ [name]: value })));
  const told = CHAPTER.controls(figure, "Move the line of Fig. 3", "Drag the line in a map, or use the sliders.", sliders);

  function show(changed) {
    Object.assign(state, changed);
    const { endpoints, processes } = state;
    for (const { name, set } of sliders) set(state[name]);
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
    // Names stand where the curves do not come: one above the other, at the panel's upper left.
    const order = ends.map(([, y], index) => [y, index]).sort(([a], [b]) => a - b);
    order.forEach(([, index], rank) => {
      const { name, protocol } = curves[index];
      name.textContent = `${protocol.name} ${percent(utilization(protocol, processes))}`;
      name.setAttribute("x", below.left + 10);
      name.setAttribute("y", below.top + 18 + 18 * rank);
    });
    told.textContent = said();
  }

  // ---- the pointer: the line goes where it is dragged to ----

  function drag({ panel }, event) {
    const [processes, endpoints] = panel.at(event);
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

  show({});
})();
