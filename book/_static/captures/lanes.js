// Captures as lanes on one clock: a lane a host, a mark a message, which says what it is under the pointer and
// with the arrow keys. What was captured is as `discostorm capture --json` writes it.
"use strict";

const LANES = (() => {
  const DATA = JSON.parse(document.getElementById("lanes-data").textContent);
  const SVG = "http://www.w3.org/2000/svg";
  const DRAWN = ["svg", "path", "rect"];
  const [WIDE, ROW, GAP] = [1000, 10, 1]; // of a lane's own units; the page stretches them
  const NEAR = 12; // so far from a mark the pointer may be [px]
  const STEPS = 24; // of the slider that says how much is shown

  function make(tag, attributes = {}, ...children) {
    const element = DRAWN.includes(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  // ---- words ----

  const many = (count, one, more = `${one}s`) => `${count.toLocaleString("en-US")} ${count === 1 ? one : more}`;
  const digits = (until) => (until < 0.5 ? 4 : until < 5 ? 3 : 2);
  const seconds = (time, until = 1) => `${time.toFixed(digits(until))} s`;

  function means(kind) {
    if (kind in DATA.means) return DATA.means[kind];
    const ending = Object.keys(DATA.endings).find((end) => kind.endsWith(end));
    return ending ? DATA.endings[ending].replace("{}", kind.slice(0, -ending.length)) : null;
  }

  function meaning({ kind, ends }) {
    if (ends) return kind.startsWith("TCP") || kind === "Close" ? "ends a connection" : "takes back what it announced";
    return means(kind);
  }

  const whom = ({ receiver, multicast }) => (multicast ? `to all (${receiver})` : receiver ? `to ${receiver}` : "to others");

  // Return what a mark is, in one sentence or two.
  function told(row, { step_s: step }) {
    const when = step ? `From ${seconds(row.time_s)} on, within ${seconds(step)}` : seconds(row.time_s, 0);
    const count = row.messages === 1 ? row.kind : `${row.messages.toLocaleString("en-US")} × ${row.kind}`;
    const what = meaning(row);
    return `${when}: ${count} from ${row.host} ${whom(row)}, ${many(row.bytes, "byte")}.${what ? ` ${row.kind} ${what}.` : ""}`;
  }

  // ---- a lane ----

  const rowOf = (kind) => {
    const found = DATA.rows.findIndex(({ kinds }) => kinds.includes(kind));
    return found < 0 ? DATA.rows.length - 1 : found;
  };

  function ended({ host, knows_all_s: complete }, { incomplete }) {
    if (complete !== null) return seconds(complete, 10);
    return incomplete.some(({ by }) => by === host) ? "never" : "not seen";
  }

  // Return a lane that draws itself up to a time, and says which mark is chosen.
  function lane(host, diagnosis, say) {
    const rows = diagnosis.timeline.rows.filter((row) => row.host === host.host);
    const bands = rows.map(({ kind }) => rowOf(kind));
    const high = DATA.rows.length * ROW;
    const ground = make("rect", { class: "lanes-knows", y: 0, height: high });
    const paths = DATA.rows.map(({ color }) => make("path", { class: "lanes-marks", style: `stroke: var(${color})` }));
    const chosen = make("path", { class: "lanes-chosen" });
    const picture = make("svg", { viewBox: `0 0 ${WIDE} ${high}`, preserveAspectRatio: "none", "aria-hidden": "true" }, ground, ...paths, chosen);
    const when = ended(host, diagnosis);
    const track = make("div", { class: "lanes-track", tabindex: 0, role: "slider", "aria-valuemin": 0, "aria-label": `Messages of ${host.host}, complete: ${when}` }, picture);
    const element = make("div", { class: "lanes-lane" }, make("span", { class: "lanes-host" }, host.host), track, make("span", { class: "lanes-when" }, when));
    let [until, seen, at] = [1, 0, -1];
    const x = (time) => (WIDE * time) / until;
    const mark = (i) => `M${x(rows[i].time_s).toFixed(2)} ${bands[i] * ROW + GAP}v${ROW - 2 * GAP}`;

    function draw(end) {
      until = end;
      seen = rows.findLastIndex(({ time_s }) => time_s <= until) + 1;
      const complete = host.knows_all_s ?? Infinity;
      ground.setAttribute("x", Math.min(WIDE, x(complete)));
      ground.setAttribute("width", Math.max(0, WIDE - x(complete)));
      const lines = DATA.rows.map(() => []);
      for (let i = 0; i < seen; i++) lines[bands[i]].push(mark(i));
      paths.forEach((path, row) => path.setAttribute("d", lines[row].join("")));
      track.setAttribute("aria-valuemax", seen);
      choose(-1);
    }

    function choose(index, speak = true) {
      at = index;
      chosen.setAttribute("d", at < 0 ? "" : mark(at));
      const text = at < 0 ? `${many(seen, "mark")}. Arrow keys go from one to the next.` : told(rows[at], diagnosis.timeline);
      track.setAttribute("aria-valuenow", at + 1);
      track.setAttribute("aria-valuetext", text);
      if (speak) say(at < 0 ? null : text, at < 0 ? null : api);
    }

    function nearest({ clientX, clientY }) {
      const box = track.getBoundingClientRect();
      const place = (clientX - box.left) / box.width;
      const band = Math.floor(((clientY - box.top) / box.height) * DATA.rows.length);
      let [best, least] = [-1, NEAR];
      for (let i = 0; i < seen; i++) {
        // A mark of another row is as if it were a little farther away.
        const distance = Math.abs(rows[i].time_s / until - place) * box.width + (bands[i] === band ? 0 : NEAR / 2);
        if (distance < least) [best, least] = [i, distance];
      }
      return best;
    }

    const point = (event) => {
      const found = nearest(event);
      if (found >= 0 && found !== at) choose(found);
    };
    track.addEventListener("pointermove", point);
    track.addEventListener("pointerdown", point);
    track.addEventListener("keydown", (event) => {
      const to = { ArrowRight: at + 1, ArrowUp: at + 1, ArrowLeft: at - 1, ArrowDown: at - 1, PageUp: at + 10, PageDown: at - 10, Home: 0, End: seen - 1, Escape: -1 }[event.key];
      if (to === undefined || !seen) return;
      event.preventDefault();
      choose(event.key === "Escape" ? -1 : Math.min(seen - 1, Math.max(0, to)));
    });
    const api = { element, draw, clear: () => choose(-1, false) };
    return api;
  }

  // ---- all lanes ----

  function axis() {
    const element = make("div", { class: "lanes-axis", "aria-hidden": "true" });
    return {
      element: make("div", { class: "lanes-lane lanes-clock" }, make("span"), element, make("span")),
      draw(until) {
        const power = 10 ** Math.floor(Math.log10(until / 3));
        const step = [1, 2, 5, 10].map((digit) => digit * power).find((step) => until / step <= 5);
        const marks = [];
        for (let time = 0; time <= until * 1.0001; time += step) {
          const label = make("span", {}, `${Number(time.toPrecision(6))}`);
          label.style.left = `${(100 * time) / until}%`;
          marks.push(label);
        }
        element.replaceChildren(...marks);
      },
    };
  }

  // All marks as a table, made when it is opened.
  function table(sets) {
    const box = make("div", { class: "lanes-table", tabindex: 0, role: "region", "aria-label": "Messages of all lanes" });
    const details = make("details", {}, make("summary", {}, "All messages as a table"), box);
    dispatchEvent(new CustomEvent("ds-made", { detail: box })); // custom.js says if it scrolls sideways
    details.addEventListener("toggle", () => {
      if (!details.open || box.firstChild) return;
      const several = sets.length > 1;
      const heads = [...(several ? ["capture"] : []), "time [s]", "from", "to", "what", "messages", "bytes"];
      const lines = sets.flatMap(({ name, diagnosis: { timeline } }) =>
        timeline.rows.map((row) => [
          ...(several ? [name] : []),
          row.time_s.toFixed(4),
          row.host,
          whom(row).slice(3),
          `${row.kind}${meaning(row) ? ` ${meaning(row)}` : ""}`,
          row.messages,
          row.bytes,
        ]),
      );
      const cells = (tag, texts) => texts.map((text) => make(tag, tag === "th" ? { scope: "col" } : {}, String(text)));
      const body = lines.map((line) => make("tr", {}, ...cells("td", line)));
      box.append(make("table", { class: "table" }, make("thead", {}, make("tr", {}, ...cells("th", heads))), make("tbody", {}, ...body)));
    });
    return details;
  }

  function legend() {
    const items = DATA.rows.map(({ name, color }) => make("li", {}, make("span", { class: "lanes-key", style: `background: var(${color})` }), name));
    items.push(make("li", {}, make("span", { class: "lanes-key lanes-key-knows" }), "knows all others"));
    return make("ul", { class: "lanes-legend" }, ...items);
  }

  function remark({ timeline: { step_s: step, left_out: left } }) {
    const notes = [];
    if (step) notes.push(`There are many messages, so a mark holds those of ${seconds(step)}.`);
    if (left) notes.push(`${many(left, "message")} are left out.`);
    return notes.map((note) => make("p", { class: "lanes-note" }, note));
  }

  // Return an element with the lanes of captures, each with its name and diagnosis, on one clock. So
  // much of it is shown at first [s]; the reader may show less or more.
  function drawn(sets, shown) {
    const longest = Math.max(...sets.map(({ diagnosis }) => diagnosis.timeline.until_s), 0.01);
    const HOW = "Point at a mark, or choose a lane and press the arrow keys, to read what was sent.";
    const line = make("p", { class: "lanes-told" }, HOW);
    let last = null;
    const say = (text, mine) => {
      if (last && last !== mine) last.clear();
      last = mine;
      line.textContent = text ?? HOW;
    };
    const parts = [];
    const element = make("div", { class: "lanes", role: "group", "aria-label": "Messages over time" }, legend());
    for (const { name, diagnosis } of sets) {
      element.append(make("p", { class: "lanes-name" }, name), ...remark(diagnosis));
      const byAddress = ({ host: one }, { host: other }) => one.localeCompare(other, "en", { numeric: true });
      for (const host of diagnosis.hosts.toSorted(byAddress)) {
        const part = lane(host, diagnosis, say);
        parts.push(part);
        element.append(part.element);
      }
    }
    const clock = axis();
    const input = make("input", { type: "range", min: 0, max: STEPS, step: "any", autocomplete: "off" });
    const amount = make("strong", { "aria-hidden": "true" });
    const least = Math.min(longest, 0.02);
    const show = (until) => {
      amount.textContent = `${until.toPrecision(2)} s`;
      input.setAttribute("aria-valuetext", amount.textContent);
      for (const part of [...parts, clock]) part.draw(until);
    };
    input.addEventListener("input", () => show(least * (longest / least) ** (input.valueAsNumber / STEPS)));
    const begin = Math.min(longest, shown);
    input.value = longest > least ? (STEPS * Math.log(begin / least)) / Math.log(longest / least) : STEPS;
    const control = make("label", { class: "lanes-shown" }, "Time shown: ", amount, input);
    element.append(clock.element, make("p", { class: "lanes-unit" }, "time since the first packet [s]"), line, control, table(sets));
    show(begin);
    return element;
  }

  // The figure's own captures take the place of its picture, except on paper.
  const figure = document.getElementById("fig-capture-lanes");
  if (figure) {
    figure.classList.add("lanes-figure");
    figure.querySelector("figcaption").before(drawn(DATA.captures, DATA.until));
  }
  return { DATA, make, many, seconds, ended, drawn };
})();
