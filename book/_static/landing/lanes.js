// Lanes of a run: who sends when, and how many frames wait at the access point.
"use strict";

// Return a function that draws what is sent between two times of the show.
function Lanes(canvas, queue) {
  const ctx = canvas.getContext("2d");
  const AP_LANES = 3; // as high as so many lanes of robots
  const FRESH = 0.03; // of the view: what has just collided is drawn larger
  const PALEST = 0.4; // how opaque what is thinner than a pixel stays
  const [SUCCESS, GAP] = [0, 2];
  let [width, height, left] = [0, 0, 0];
  let named = ""; // for what the names beside the lanes were written

  function resize() {
    const scale = Math.min(2, devicePixelRatio);
    [width, height] = [canvas.clientWidth, canvas.clientHeight];
    left = width < 500 ? 26 : 92; // room for names
    [canvas.width, canvas.height] = [width * scale, height * scale];
    ctx.setTransform(scale, 0, 0, scale, 0, 0);
    named = "";
  }

  // Return the first place whose value is not below a limit, in ascending values.
  function search(values, limit) {
    let [low, high] = [0, values.length];
    while (low < high) {
      const middle = (low + high) >> 1;
      if (values[middle] < limit) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  function names(hosts, lane, theme) {
    ctx.font = `${Math.min(13, Math.max(9, lane * 0.8))}px ${theme.font}`;
    ctx.textBaseline = "middle";
    ctx.textAlign = "right";
    ctx.fillStyle = theme.muted;
    const short = left < 50;
    for (let host = 0; host < hosts; host++) ctx.fillText(short ? host + 1 : `robot ${host + 1}`, left - 6, (host + 0.5) * lane);
    ctx.fillStyle = theme.text;
    ctx.fillText(short ? "AP" : "access point", left - 6, (hosts + AP_LANES / 2) * lane);
  }

  // The queue at the access point as an area, red where it is full.
  function area({ looks }, from, to, top, bottom, theme) {
    const x = (time) => left + (Math.max(time, from) - from) / (to - from) * (width - left);
    const level = (waiting) => bottom - (Math.min(waiting, queue) / queue) * (bottom - top);
    let place = Math.max(0, search(looks.at, from) - 1);
    ctx.globalAlpha = 0.3;
    for (; place < looks.at.length && looks.at[place] < to; place++) {
      const end = Math.min(to, looks.at[place + 1] ?? to);
      const waiting = looks.waiting[place];
      ctx.fillStyle = waiting > 0.97 * queue ? theme.bad : theme.text;
      const begin = Math.round(x(looks.at[place]));
      ctx.fillRect(begin, level(waiting), Math.round(x(end)) - begin, bottom - level(waiting));
    }
    ctx.globalAlpha = 1;
    ctx.strokeStyle = theme.bad;
    ctx.beginPath();
    ctx.moveTo(left, top);
    ctx.lineTo(width, top);
    ctx.stroke();
    ctx.font = `11px ${theme.font}`;
    [ctx.textAlign, ctx.textBaseline, ctx.fillStyle] = ["left", "top", theme.text];
    ctx.fillText(`queue full: ${queue} frames`, left + 4, top + 3);
  }

  // Draw the transmissions of one kind. Thinner than a pixel they are paler; what is fresh is drawn larger.
  function marks({ start, end, station, outcome }, [first, last], chosen, y, high, x, fresh) {
    // The more there are, the paler, or the last drawn would hide all others.
    const palest = Math.min(PALEST, (8 * (width - left)) / (last - first));
    for (let i = first; i < last; i++) {
      if (!chosen(station[i], outcome[i])) continue;
      const begin = Math.max(left, x(start[i]));
      const wide = Math.min(width, x(end[i])) - begin;
      const grown = start[i] > fresh && palest === PALEST ? 1 : 0;
      ctx.globalAlpha = wide + grown < 1 ? Math.max(palest, wide) : 1;
      ctx.fillRect(Math.round(begin), y(station[i]) - grown, Math.max(1, Math.round(wide)), high + 2 * grown);
    }
    ctx.globalAlpha = 1;
  }

  // What comes after the end of a run is not simulated.
  function after({ length, ended }, to, x, theme) {
    if (to <= length) return;
    const begin = Math.max(left, Math.round(x(length)));
    ctx.fillStyle = theme.text;
    ctx.fillRect(begin, 0, 1, height);
    ctx.font = `13px ${theme.font}`;
    const wide = ctx.measureText(ended).width + 12;
    const at = Math.max(left, Math.min(begin + 1, width - wide));
    ctx.fillStyle = theme.lane;
    ctx.fillRect(at, 0, wide, 22);
    [ctx.textAlign, ctx.textBaseline, ctx.fillStyle] = ["left", "middle", theme.text];
    ctx.fillText(ended, at + 6, 11);
  }

  return {
    resize,
    draw(run, from, to, theme) {
      const { hosts, start, end } = run;
      const lane = height / (hosts + AP_LANES);
      const x = (time) => left + ((time - from) / (to - from)) * (width - left);
      ctx.clearRect(left, 0, width, height);
      ctx.fillStyle = theme.lane;
      for (let host = 0; host < hosts; host++) ctx.fillRect(left, Math.round(host * lane), width - left, Math.round(lane) - GAP);
      const [top, bottom] = [Math.round(hosts * lane) + GAP, height];
      area(run, from, to, top, bottom, theme);
      const inView = [search(end, from), search(start, to)];
      const y = (station) => (station === hosts ? bottom - Math.round(lane) : Math.round(station * lane));
      const high = Math.round(lane) - GAP;
      ctx.fillStyle = run.color;
      marks(run, inView, (station, outcome) => outcome === SUCCESS && station < hosts, y, high, x, Infinity);
      ctx.fillStyle = theme.text;
      marks(run, inView, (station, outcome) => outcome === SUCCESS && station === hosts, y, high, x, Infinity);
      ctx.fillStyle = theme.bad;
      marks(run, inView, (station, outcome) => outcome !== SUCCESS, y, high, x, to - FRESH * (to - from));
      after(run, to, x, theme);
      const wanted = [hosts, width, height, theme.text].join();
      if (wanted === named) return;
      named = wanted;
      ctx.clearRect(0, 0, left, height);
      names(hosts, lane, theme);
    },
  };
}
