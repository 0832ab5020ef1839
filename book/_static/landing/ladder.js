// The ladder of assumptions: switches, and where the markers go. The numbers are the package's, from
// the data on the page (discostorm_book.assumption_ladder); what is here looks them up.
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("ladder-data").textContent);
  const box = document.getElementById("ladder");
  const keys = DATA.switches.map(({ key }) => key);
  const names = new Map(DATA.switches.map(({ key, name }) => [key, name]));
  const keysOf = (places) => places.map((place) => keys[place]);
  const rungs = DATA.rungs.map(([on, protocol, fit, within, shown = String(fit), runs]) => ({ switches: keysOf(on), protocol, fit, within, shown, runs }));
  const [LEAST, MOST] = [1, 100]; // ends of the line [robots], which is logarithmic
  const place = (robots) => `${(100 * Math.log(Math.min(MOST, Math.max(LEAST, robots)) / LEAST)) / Math.log(MOST / LEAST)}%`;

  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  // ---- the line ----

  const line = make("div", { class: "ladder-line", "aria-hidden": "true" });
  for (const robots of [1, 2, 5, 10, 20, 50, 100]) {
    const tick = make("span", { class: "ladder-tick" }, String(robots));
    tick.style.left = place(robots);
    line.append(tick);
  }
  const markers = DATA.protocols.map(({ name, color }, i) => {
    const marker = make("span", { class: `ladder-marker ladder-${i}` }, make("b", {}, ""), ` ${name}`);
    marker.style.setProperty("--color", `var(${color})`);
    line.append(marker);
    return marker;
  });
  const told = make("p", { class: "ladder-told", role: "status" });

  // ---- the switches ----

  const list = make("ul", { class: "ladder-switches" });
  for (const { key, name, why, kind } of DATA.switches) {
    const input = make("input", { type: "checkbox", id: `ladder-${key}`, value: key });
    list.append(
      make(
        "li",
        {},
        make("label", { for: input.id }, input, ` ${name}`),
        make("span", { class: `ladder-kind ladder-${kind}` }, kind),
        make("span", { class: "ladder-why" }, why),
      ),
    );
  }
  const inputs = new Map([...list.querySelectorAll("input")].map((input) => [input.value, input]));

  // ---- what is known ----

  const known = [...new Set(rungs.map(({ switches }) => switches.join()))].map((all) => all.split(",").filter(Boolean));
  const same = (one, other) => one.length === other.length && one.every((key) => other.includes(key));
  const distance = (one, other) => keys.filter((key) => one.includes(key) !== other.includes(key)).length;

  // Return the known combination that is nearest to one.
  const nearest = (wanted) => [...known].sort((a, b) => distance(a, wanted) - distance(b, wanted))[0];

  // Return what would have to change so that there is a number.
  function without(on) {
    const found = nearest(on);
    const listed = (all) => all.map((key) => `“${names.get(key)}”`).join(" and ");
    const [more, less] = [found.filter((key) => !on.includes(key)), on.filter((key) => !found.includes(key))];
    const ways = [more.length ? `switch on ${listed(more)}` : "", less.length ? `switch off ${listed(less)}` : ""];
    return `There is no number for these together. To see one, ${ways.filter(Boolean).join(" and ")}.`;
  }

  function show(on) {
    for (const [key, input] of inputs) input.checked = on.includes(key);
    const fits = DATA.protocols.map(({ name }) => rungs.find((rung) => rung.protocol === name && same(rung.switches, on)));
    fits.forEach((rung, i) => {
      markers[i].hidden = !rung;
      if (!rung) return;
      markers[i].style.left = place(rung.fit);
      markers[i].firstChild.textContent = rung.shown;
    });
    // The lower marker's name does not cross the line of the higher one.
    markers[1].classList.toggle("ladder-left", fits[1]?.fit < fits[0]?.fit);
    const shown = fits.filter(Boolean);
    if (!shown.length) {
      told.textContent = without(on);
      return;
    }
    const words = shown.map(({ shown, protocol }) => `${shown} with ${protocol}`).join(", ");
    const times = new Set(shown.map(({ within }) => within));
    const time =
      times.size > 1
        ? shown.map(({ within, protocol }) => `${within} s with ${protocol}`).join(" and ")
        : `${[...times]} s`;
    told.textContent = `Robots that fit: ${words}${on.length ? "" : ", by the paper model"}. Startup may take ${time}.`;
  }

  list.addEventListener("change", () => {
    const on = [...inputs].filter(([, input]) => input.checked).map(([key]) => key);
    show(on);
    Address.write({ ladder: on.join() || null });
  });

  // ---- the table below: a simulated number tells of its runs ----

  const note = make("div", { class: "ladder-note", role: "tooltip", id: "ladder-note" });
  note.hidden = true;
  let open = null;
  function close() {
    note.hidden = true;
    open?.setAttribute("aria-expanded", "false");
    open = null;
  }
  function tell(button, runs) {
    close();
    open = button;
    button.setAttribute("aria-expanded", "true");
    note.textContent = runs;
    note.hidden = false;
    put();
  }
  function put() {
    if (!open) return;
    const { left, bottom } = open.getBoundingClientRect();
    const most = document.documentElement.clientWidth - note.offsetWidth - 8;
    note.style.left = `${Math.max(8, Math.min(left, most))}px`;
    note.style.top = `${bottom}px`;
  }
  function ask({ shown, runs }) {
    const button = make("button", { type: "button", class: "ladder-runs", "aria-expanded": "false", "aria-label": `${shown}: ${runs}` }, shown);
    // Safari does not focus a button that is clicked.
    for (const event of ["focus", "click"]) button.addEventListener(event, () => tell(button, runs));
    button.addEventListener("mouseenter", ({ movementX, movementY }) => {
      if (movementX || movementY) tell(button, runs); // not what only came under the pointer, as by Escape
    });
    button.addEventListener("blur", close);
    button.addEventListener("mouseleave", ({ relatedTarget }) => {
      if (relatedTarget !== note && document.activeElement !== button) close();
    });
    return button;
  }
  addEventListener("DOMContentLoaded", () => {
    const rows = document.querySelector(".tag_ladder-table table")?.tBodies[0].rows ?? [];
    DATA.rows.forEach((on, row) =>
      DATA.protocols.forEach(({ name }, column) => {
        const rung = rungs.find(({ protocol, switches }) => protocol === name && same(switches, keysOf(on)));
        if (rung?.runs) rows[row]?.cells[2 + column]?.replaceChildren(ask(rung));
      }),
    );
  });
  note.addEventListener("mouseleave", close);
  addEventListener("keydown", ({ key }) => key === "Escape" && close());
  addEventListener("scroll", put, { capture: true, passive: true });

  box.append(line, told, list, note);
  box.hidden = false;
  Address.follow(() => show((Address.get("ladder") ?? "").split(",").filter((key) => keys.includes(key))));
})();
