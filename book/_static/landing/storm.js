// The live storm of the first page. Messages, their order and their airtime are the package's, from
// the data on the page (discostorm.book.storm); what is here moves dots and adds up airtime.
"use strict";

(() => {
  const byId = (id) => document.getElementById(`storm-${id}`);
  const DATA = JSON.parse(byId("data").textContent);
  const still = document.getElementById("fig-storm");
  // Who asked for less motion keeps the picture.
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;

  const FLIGHT = 0.3; // how long a dot flies, up and again down [s]
  const REST = 2.5; // until the storm begins anew [s]
  const [SHORTEST, LONGEST, PER_SECOND] = [8, 30, 200]; // of a storm [s], and messages a second
  const { most } = DATA;
  const everyone = most.hosts * most.processes;
  const decode = new Map([...DATA.letters].map((letter, index) => [letter, index]));

  const canvas = byId("canvas");
  const ctx = canvas.getContext("2d");
  const chosen = (name) => byId("form").elements[name].value;
  const whole = new Intl.NumberFormat("en-US");

  // ---- the messages of a swarm: the part of the largest storm between those who take part ----

  function storm() {
    const protocol = DATA.protocols[chosen("middleware")];
    const [hosts, processes, endpoints] = ["hosts", "processes", "endpoints"].map((name) => Number(chosen(name)));
    const takesPart = (place) => place === everyone || (Math.floor(place / most.processes) < hosts && place % most.processes < processes);
    const host = (place) => (place === everyone ? -1 : Math.floor(place / most.processes));
    const [start, from, to, tells] = [[], [], [], []];
    let used = 0;
    for (let i = 0; i < protocol.runs.length; i += 4) {
      const [kind, sender, receiver, numbers] = [0, 1, 2, 3].map((j) => decode.get(protocol.runs[i + j]));
      if (!takesPart(sender) || !takesPart(receiver)) continue;
      const [up, down] = protocol.airtimes[kind];
      const told = protocol.numbers[numbers];
      const many = told.length ? told.filter((number) => number <= endpoints).length : 1;
      for (let j = 0; j < many; j++) {
        start.push(used);
        from.push(host(sender));
        to.push(host(receiver));
        tells.push(told.length > 0);
        used += up + down;
      }
    }
    const length = Math.min(LONGEST, Math.max(SHORTEST, start.length / PER_SECOND));
    const all = Array(hosts).fill(0);
    to.forEach((receiver, i) => tells[i] && all[receiver]++);
    const rate = used / length; // airtime a second of the show
    return { protocol, hosts, start, from, to, tells, all, used, length, rate };
  }

  // ---- drawing ----

  let theme = {};
  function readTheme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(`--pst-color-${name}`).trim();
    theme = { text: color("text-base"), ground: color("background"), line: color("border"), muted: color("text-muted") };
  }

  let [width, height, places, radius] = [0, 0, [], 0];
  let now; // the storm that is shown
  let [time, heard, first] = [0, [], 0]; // of the show [s]; what hosts were told; the first message still in flight
  let [playing, seen, last, told] = [true, true, null, -1];

  function layOut() {
    const scale = Math.min(2, devicePixelRatio);
    width = canvas.clientWidth;
    height = canvas.clientHeight;
    canvas.width = width * scale;
    canvas.height = height * scale;
    ctx.setTransform(scale, 0, 0, scale, 0, 0);
    radius = Math.max(11, Math.min(18, width / 30));
    places = Array.from({ length: now.hosts }, (_, i) => {
      const angle = (2 * Math.PI * i) / now.hosts - Math.PI / 2;
      return [width / 2 + (width / 2 - radius - 10) * Math.cos(angle), height / 2 + (height / 2 - radius - 8) * Math.sin(angle)];
    });
  }

  function robot([x, y], share) {
    const r = radius;
    ctx.strokeStyle = theme.muted;
    ctx.fillStyle = theme.ground;
    ctx.lineWidth = 2;
    ctx.beginPath();
    ctx.roundRect(x - r, y - r * 0.75, 2 * r, 1.5 * r, r * 0.4);
    ctx.fill();
    ctx.stroke();
    // Wheels, an aerial, and how much of the others it has been told of.
    ctx.fillStyle = theme.muted;
    for (const side of [-1, 1]) ctx.fillRect(x + side * r * 0.6 - r * 0.25, y + r * 0.75, r * 0.5, r * 0.25);
    ctx.fillRect(x - 1, y - r * 1.1, 2, r * 0.35);
    ctx.fillStyle = theme.color;
    ctx.beginPath();
    ctx.roundRect(x - r * 0.75, y - r * 0.5, 1.5 * r * share, r, Math.min(r * 0.2, r * 0.7 * share));
    ctx.fill();
  }

  function accessPoint() {
    const [x, y, r] = [width / 2, height / 2, radius];
    ctx.strokeStyle = theme.text;
    ctx.lineWidth = 2.5;
    for (const size of [1, 1.7]) {
      for (const side of [0, Math.PI]) {
        ctx.beginPath();
        ctx.arc(x, y, r * size, side - 0.7, side + 0.7);
        ctx.stroke();
      }
    }
    ctx.fillStyle = theme.text;
    ctx.beginPath();
    ctx.arc(x, y, r * 0.45, 0, 2 * Math.PI);
    ctx.fill();
  }

  function draw() {
    ctx.clearRect(0, 0, width, height);
    const { start, from, to, rate } = now;
    const [cx, cy] = [width / 2, height / 2];
    ctx.fillStyle = theme.color;
    const dot = ([x, y], part) => ctx.fillRect(cx + (x - cx) * part - 2, cy + (y - cy) * part - 2, 4, 4);
    for (let i = first; i < start.length && start[i] / rate <= time; i++) {
      const flown = (time - start[i] / rate) / FLIGHT;
      if (flown < 1) dot(places[from[i]], 1 - flown);
      else if (flown < 2 && to[i] >= 0) dot(places[to[i]], flown - 1);
      else if (flown < 2) places.forEach((place, j) => j !== from[i] && dot(place, flown - 1));
    }
    places.forEach((place, i) => robot(place, now.all[i] ? heard[i] / now.all[i] : 1));
    accessPoint();
    const used = Math.min(now.used, time * rate);
    const scale = Math.max(1, now.used);
    byId("fill").style.transform = `scaleX(${Math.min(used, 1) / scale})`;
    byId("over").style.transform = `scaleX(${Math.max(0, used - 1) / scale})`;
    // Ten times a second is enough to read.
    if (Math.floor(time * 10) !== told) {
      told = Math.floor(time * 10);
      byId("told").textContent = `${whole.format(first)} of ${whole.format(start.length)} messages have arrived, ${used.toFixed(2)} s of airtime.`;
    }
  }

  function advance(seconds) {
    time += seconds;
    const { start, to, tells, rate, length } = now;
    while (first < start.length && start[first] / rate + 2 * FLIGHT <= time) {
      if (tells[first]) heard[to[first]]++;
      first++;
    }
    if (time > length + 2 * FLIGHT + REST) again();
  }

  function frame(at) {
    last ??= at;
    advance(Math.min(0.1, (at - last) / 1000));
    last = at;
    draw();
    if (playing && seen) requestAnimationFrame(frame);
    else last = null;
  }

  // ---- what the reader does ----

  function again() {
    [time, first, told] = [0, 0, -1];
    heard = Array(now.hosts).fill(0);
  }

  function paint() {
    // The protocol's color in the palette, by the name of its property.
    theme.color = getComputedStyle(document.documentElement).getPropertyValue(now.protocol.color).trim();
    byId("over").parentElement.style.setProperty("--color", `var(${now.protocol.color})`);
  }

  function choose() {
    const before = last;
    now = storm();
    again();
    layOut();
    byId("many").textContent = chosen("hosts");
    byId("over").parentElement.style.setProperty("--second", `${100 / Math.max(1, now.used)}%`);
    byId("over").parentElement.classList.toggle("storm-early", now.used > 2);
    paint();
    const slowed = now.length / now.used;
    byId("sum").textContent =
      `${whole.format(now.start.length)} messages, ${now.used.toFixed(2)} s of airtime: ` +
      (now.used < 1 ? "it fits into one second, and leaves " + (1 - now.used).toFixed(2) + " s for everything else." : "more than the second that the paper allows.") +
      ` Shown ${slowed >= 1.5 ? `${Math.round(slowed)} times slower than` : slowed > 0.67 ? "as fast as" : `${Math.round(1 / slowed)} times faster than`} it happens.`;
    if (before === null) draw();
  }

  function play(on) {
    playing = on;
    byId("pause").textContent = on ? "Pause" : "Play";
    if (on && last === null) requestAnimationFrame(frame);
  }

  if (still) still.hidden = true;
  document.getElementById("storm").hidden = false;
  readTheme();
  choose();
  play(true);
  byId("form").addEventListener("input", choose);
  byId("form").addEventListener("submit", (event) => event.preventDefault());
  byId("pause").addEventListener("click", () => play(!playing));
  byId("again").addEventListener("click", () => {
    again();
    play(true);
  });
  new IntersectionObserver(([{ isIntersecting }]) => {
    const waiting = !seen && isIntersecting;
    seen = isIntersecting;
    if (waiting && playing && last === null) requestAnimationFrame(frame);
  }).observe(canvas);
  new ResizeObserver(() => {
    layOut();
    if (last === null) draw();
  }).observe(canvas);
  new MutationObserver(() => {
    readTheme();
    paint();
    if (last === null) draw();
  }).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });
})();
