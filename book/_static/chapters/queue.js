// The queue of a startup over time: what waits for the channel when endpoints make the burst longer
// or the period of the announcements changes. When how much airtime is sent comes from the package,
// in the data on the page (discostorm_book.interactive); what is here lets it wait in line.
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("queue-data").textContent);
  const figure = document.getElementById("fig-queue");
  const { make, put } = CHAPTER;
  const [fewest, most, begun] = DATA.endpoints;
  const state = { endpoints: begun, period: DATA.period };
  const steady = new Map(DATA.periods);
  const periods = [...steady.keys()];

  // Return [time, airtime] of all that is sent up to a time, in order.
  function sent(until) {
    return DATA.rounds
      .flatMap(({ starts, repeats, airtime: [none, each] }) => {
        const airtime = none + each * state.endpoints;
        const times = [...starts];
        if (repeats) for (let n = 1; starts.at(-1) + n * state.period <= until; n++) times.push(starts.at(-1) + n * state.period);
        return times.map((time) => [time, airtime]);
      })
      .filter(([time]) => time <= until)
      .sort(([a], [b]) => a - b);
  }

  // Return the corners of what waits up to a time, and when nothing waits for the first time.
  function wait(until) {
    const corners = [[0, 0]];
    let [now, waiting, clear] = [0, 0, Infinity];
    const carry = (time) => {
      const left = waiting - (time - now);
      if (left <= 0 && now + waiting < time) {
        clear = Math.min(clear, now + waiting);
        corners.push([now + waiting, 0]);
      }
      [now, waiting] = [time, Math.max(0, left)];
      corners.push([now, waiting]);
    };
    for (const [time, airtime] of sent(until)) {
      if (time > now) carry(time);
      waiting += airtime;
      corners.push([now, waiting]);
    }
    carry(until);
    return { corners, clear };
  }

  const { picture, panels, inside } = CHAPTER.over(figure, DATA, () => show({}));
  const [panel] = panels;
  const end = panel.xlim[1];
  const curve = make("path", { class: "line-line" });
  const dot = make("circle", { class: "line-end", r: 7 });
  inside(panel, curve);
  picture.append(dot);

  function clearing() {
    if (steady.get(state.period) >= 1) return Infinity;
    for (let until = end; ; until *= 2) {
      const { clear } = wait(until);
      if (clear < until) return clear;
    }
  }

  function said(clear, corners) {
    const { endpoints, period } = state;
    const robots = `${DATA.hosts} robots with ${DATA.processes} processes of ${endpoints} endpoints each, announcing every ${period} s:`;
    const stays = steady.get(period);
    if (clear === Infinity) return `${robots} the queue never clears, because periodic traffic alone needs ${stays.toFixed(2)} s of every second.`;
    const highest = Math.max(...corners.map(([, waiting]) => waiting));
    return `${robots} the queue grows to ${highest.toFixed(1)} s of airtime and clears after ${clear.toFixed(1)} s. From then on discovery takes ${Math.round(100 * stays)}% of the channel.`;
  }

  const sliders = [
    CHAPTER.slider("endpoints", "Burst: endpoints of a process", fewest, most, 1, (endpoints) => show({ endpoints })),
    CHAPTER.slider("period", "Period of announcements", periods[0], periods.at(-1), 1, (period) => show({ period }), (period) => `${period} s`),
  ];
  const told = CHAPTER.controls(figure, "Change the queue", "Lengthen the burst or the period. The thick curve is yours.", sliders);

  function show(changed) {
    Object.assign(state, changed);
    for (const { name, set } of sliders) set(state[name]);
    const { corners } = wait(end);
    curve.setAttribute("d", `M${corners.map(([time, waiting]) => panel.place(time, waiting).map((x) => x.toFixed(1)).join()).join("L")}`);
    const clear = clearing();
    dot.classList.toggle("line-none", clear > end);
    if (clear <= end) put(dot, panel.place(clear, 0));
    told.textContent = said(clear, corners);
  }

  show({});
})();
