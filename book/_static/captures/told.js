// What `discostorm capture --json` found, as elements of a page: diagnosis, hosts, pairs that never completed, lanes.
"use strict";

const TOLD = (() => {
  const { DATA, make, many, ended, drawn } = LANES;

  // ---- is it such a file? ----

  const isText = (value) => typeof value === "string";
  const isNumber = (value) => Number.isFinite(value);
  const isTime = (value) => value === null || isNumber(value);
  const isFlag = (value) => value === null || typeof value === "boolean";
  const list = (shape) => (value) => Array.isArray(value) && value.every((one) => fits(one, shape));
  const HOST = { host: isText, products: isText, processes: isNumber, endpoints: isNumber, announced_s: isTime, knows_all_s: isTime, sent: isNumber, received: isNumber };
  const PAIR = { of: isText, by: isText, of_process: isText, by_process: isText, heard_s: isTime, sent: isNumber };
  const PASTE = { where: isText, load: isText, text: isText };
  const FINDING = { about: isText, what: isText, evidence: isText, advice: isText, paste: list(PASTE) };
  const ROW = { time_s: isNumber, host: isText, kind: isText, messages: isNumber, bytes: isNumber };
  const DIAGNOSIS = { summary: isText, healthy: isFlag, complete_s: isTime, pairs: isNumber, findings: list(FINDING), hosts: list(HOST), incomplete: list(PAIR) };
  const TIMELINE = { until_s: isNumber, step_s: isNumber, left_out: isNumber, rows: list(ROW) };

  function fits(value, shape) {
    return typeof value === "object" && value !== null && Object.entries(shape).every(([key, is]) => is(value[key]));
  }

  // Return what is wrong with what a file holds, null if nothing.
  function wrong(answer) {
    if (!fits(answer, {}) || !("diagnosis" in answer)) return "It holds JSON, but no diagnosis.";
    if (!isText(answer.file) || !fits(answer.diagnosis, DIAGNOSIS)) return "Its diagnosis lacks what this page shows.";
    const { timeline } = answer.diagnosis;
    return timeline === undefined || fits(timeline, TIMELINE) ? null : "Its times of messages can't be read.";
  }

  // ---- what it says ----

  const time = (value, otherwise) => (value === null ? otherwise : value.toFixed(2));

  function table(heads, lines, label) {
    const row = (tag, texts) => make("tr", {}, ...texts.map((text) => make(tag, tag === "th" ? { scope: "col" } : {}, String(text))));
    const body = make("tbody", {}, ...lines.map((line) => row("td", line)));
    const box = make("div", { class: "told-table", tabindex: 0, role: "region", "aria-label": label }, make("table", { class: "table" }, make("thead", {}, row("th", heads)), body));
    dispatchEvent(new CustomEvent("ds-made", { detail: box })); // custom.js says if it scrolls sideways
    return box;
  }

  const sentence = (text) => (text ? `${text[0].toUpperCase()}${text.slice(1).replace(/\.$/, "")}. ` : "");

  const pasted = ({ paste }) =>
    paste.map(({ where, load, text }) =>
      make("details", {}, make("summary", {}, `Configuration to copy: ${where}`), make("p", {}, sentence(load)), make("pre", { tabindex: 0 }, text)),
    );

  function finding(one) {
    const { what, evidence, advice, about } = one;
    return make("li", {}, make("strong", {}, sentence(what)), sentence(evidence), about === "event" ? "" : sentence(advice), ...pasted(one));
  }

  function hosts(diagnosis) {
    const lines = diagnosis.hosts.map((host) => [host.host, host.products, host.processes, host.endpoints, time(host.announced_s, "–"), ended(host, diagnosis).replace(/ s$/, ""), host.sent, host.received]);
    return table(["host", "products", "processes", "endpoints", "first [s]", "complete [s]", "sent", "received"], lines, "Hosts");
  }

  function pairs({ incomplete, pairs }) {
    const name = (host, process) => `${host} ${process.slice(0, 12)}`;
    const line = (pair) => [name(pair.of, pair.of_process), name(pair.by, pair.by_process), time(pair.heard_s, "never"), pair.sent];
    const show = (some) => table(["process", "not fully known to", "answered [s]", "endpoints announced"], some.map(line), "Pairs that never completed");
    const list = make("div", {}, show(incomplete.slice(0, DATA.most)));
    const box = make("div", {}, make("h4", {}, `Pairs that never completed: ${incomplete.length} of ${pairs}`), list);
    if (incomplete.length > DATA.most) {
      const button = make("button", { type: "button" }, `Show all ${incomplete.length}`);
      button.addEventListener("click", () => {
        const whole = show(incomplete);
        list.replaceChildren(whole); // also instead of what is said about it
        button.remove();
        whole.focus();
      });
      box.append(button);
    }
    return box;
  }

  // Return the name of a file without its folders.
  const nameOf = (path) => path.split(/[\\/]/).pop();

  // Return the lanes of a capture, beside others on the same clock.
  function lanes(answer, others) {
    const { diagnosis } = answer;
    if (!diagnosis.timeline) return make("p", {}, "For lanes, this file needs the times of messages. Update discostorm and run the command once more.");
    if (!diagnosis.timeline.rows.length) return make("p", {}, "There is no message of DDS or Zenoh to draw.");
    const mine = { name: nameOf(answer.file), diagnosis };
    const shown = diagnosis.complete_s === null ? diagnosis.timeline.until_s : Math.max(0.1, 1.25 * diagnosis.complete_s);
    return drawn([mine, ...others], shown);
  }

  function all(answer, beside) {
    const { diagnosis } = answer;
    const state = { true: "ok", false: "bad", null: "slow" }[diagnosis.healthy];
    const parts = [make("h3", { tabindex: -1 }, nameOf(answer.file)), make("p", { class: `told-answer told-${state}` }, diagnosis.summary)];
    // The first sentences may have told one of them already.
    const isTold = ({ evidence }) => diagnosis.summary.includes(sentence(evidence).trim());
    parts.push(...diagnosis.findings.filter(isTold).flatMap(pasted));
    const others = diagnosis.findings.filter((one) => !isTold(one));
    if (others.length) parts.push(make("h4", {}, "Also found"), make("ul", {}, ...others.map(finding)));
    if (diagnosis.hosts.length) parts.push(make("h4", {}, many(diagnosis.hosts.length, "host")), hosts(diagnosis));
    if (diagnosis.incomplete.length) parts.push(pairs(diagnosis));
    if (Array.isArray(answer.notes) && answer.notes.length) parts.push(make("ul", { class: "told-notes" }, ...answer.notes.map((note) => make("li", {}, `Note: ${note}.`))));
    const box = make("div", {}, lanes(answer, []));
    const both = make("input", { type: "checkbox", autocomplete: "off" });
    both.addEventListener("change", () => box.replaceChildren(lanes(answer, both.checked ? [beside] : [])));
    parts.push(make("h4", {}, "Messages over time"), make("label", { class: "told-beside" }, both, " Show the healthy startup above on the same clock"), box);
    return parts;
  }

  return { wrong, all };
})();
