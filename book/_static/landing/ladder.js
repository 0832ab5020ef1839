// The ladder of assumptions: switches, and where the markers go. The numbers are the package's, from
// the data on the page (discostorm.book.ladder); what is here looks them up.
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("ladder-data").textContent);
  const box = document.getElementById("ladder");
  const keys = DATA.switches.map(({ key }) => key);
  const names = new Map(DATA.switches.map(({ key, name }) => [key, name]));
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

  const known = [...new Set(DATA.rungs.map(({ switches }) => switches.join()))].map((all) => all.split(",").filter(Boolean));
  const same = (one, other) => one.length === other.length && one.every((key) => other.includes(key));
  const distance = (one, other) => keys.filter((key) => one.includes(key) !== other.includes(key)).length;

  function show(on, changed = "") {
    for (const [key, input] of inputs) input.checked = on.includes(key);
    const fits = DATA.protocols.map(({ name }) => DATA.rungs.find((rung) => rung.protocol === name && same(rung.switches, on)));
    fits.forEach((rung, i) => {
      markers[i].hidden = !rung;
      if (!rung) return;
      markers[i].style.left = place(rung.fit);
      markers[i].firstChild.textContent = rung.fit;
    });
    // The lower marker's name does not cross the line of the higher one.
    markers[1].classList.toggle("ladder-left", fits[1]?.fit < fits[0]?.fit);
    const shown = fits.filter(Boolean);
    const words = shown.map(({ fit, protocol }) => `${fit} with ${protocol}`).join(", ");
    const times = new Set(shown.map(({ within }) => within));
    const time =
      times.size > 1
        ? shown.map(({ within, protocol }) => `${within} s with ${protocol}`).join(" and ")
        : `${[...times]} s`;
    told.textContent = `Robots that fit: ${words}${on.length ? "" : ", as the paper counts"}. The start may take ${time}.${changed}`;
  }

  list.addEventListener("change", ({ target }) => {
    const wanted = [...inputs].filter(([, input]) => input.checked).map(([key]) => key);
    // The nearest combination that somebody computed or simulated.
    const [found] = known
      .filter((on) => on.includes(target.value) === target.checked)
      .sort((a, b) => distance(a, wanted) - distance(b, wanted));
    const listed = (all) => all.map((key) => `“${names.get(key)}”`).join(" and ");
    const more = found.filter((key) => !wanted.includes(key));
    const less = wanted.filter((key) => !found.includes(key));
    const changed = [
      more.length ? ` ${listed(more)} ${more.length > 1 ? "go" : "goes"} with it.` : "",
      less.length ? ` ${listed(less)} ${less.length > 1 ? "were" : "was"} switched off: there is no number for them together.` : "",
    ].join("");
    show(found, changed);
  });

  box.append(line, told, list);
  box.hidden = false;
  show([]);
})();
