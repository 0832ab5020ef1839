// Lanes of a run: who sends when, and how many frames wait at the access point.
"use strict";

// Return a function that draws what is sent between two times of the show.
function Lanes(canvas, queue) {
  const ctx = canvas.getContext("2d");
  const AP_LANES = 3; // as high as so many lanes of robots
  const FRESH = 0.03; // of the view: what has just collided is drawn larger
  const PALEST = 0.4; // how opaque what is thinner than a pixel stays
  const [SUCCESS, GAP] = [0, 2];
  const TILE = 256; // what moves is drawn once, in pieces of so many pixels
  let [width, height, left, scale] = [0, 0, 0, 1];
  let named = ""; // for what the names beside the lanes were written
  const tiles = new Map(); // by their number from time 0 on
  let tiled = []; // for what they were drawn

  function resize() {
    scale = Math.min(2, devicePixelRatio);
    [width, height] = [canvas.clientWidth, canvas.clientHeight];
    left = width < 500 ? 26 : 92; // room for names
    [canvas.width, canvas.height] = [width * scale, height * scale];
    ctx.setTransform(scale, 0, 0, scale, 0, 0);
    named = "";
  }

  /** The page's colors and letters, as they are now. */
  function theme() {
    const style = getComputedStyle(document.documentElement);
    const color = (name) => style.getPropertyValue(name).trim();
    return {
      bad: color("--ds-state-bad"),
      text: color("--ds-neutral-charcoal"),
      muted: color("--ds-page-muted"),
      lane: color("--ds-page-surface"),
      font: getComputedStyle(canvas).fontFamily,
    };
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

  function names({ hosts, nameOf = (host) => `robot ${host + 1}` }, lane, theme) {
    ctx.font = `${Math.min(13, Math.max(9, lane * 0.8))}px ${theme.font}`;
    ctx.textBaseline = "middle";
    ctx.textAlign = "right";
    ctx.fillStyle = theme.muted;
    const short = left < 50;
    for (let host = 0; host < hosts; host++) ctx.fillText(short ? host + 1 : nameOf(host), left - 6, (host + 0.5) * lane);
    ctx.fillStyle = theme.text;
    ctx.fillText(short ? "AP" : "access point", left - 6, (hosts + AP_LANES / 2) * lane);
  }

  // The queue at the access point as an area, red where it is full.
  function area(ctx, { looks }, from, to, x, top, bottom, theme) {
    const level = (waiting) => bottom - (Math.min(waiting, queue) / queue) * (bottom - top);
    let place = Math.max(0, search(looks.at, from) - 1);
    ctx.globalAlpha = 0.3;
    for (; place < looks.at.length && looks.at[place] < to; place++) {
      const end = Math.min(to, looks.at[place + 1] ?? to);
      const waiting = looks.waiting[place];
      ctx.fillStyle = waiting > 0.97 * queue ? theme.bad : theme.text;
      const begin = Math.round(x(Math.max(from, looks.at[place])));
      ctx.fillRect(begin, level(waiting), Math.round(x(end)) - begin, bottom - level(waiting));
    }
    ctx.globalAlpha = 1;
  }

  function full(top, theme) {
    ctx.strokeStyle = theme.bad;
    ctx.beginPath();
    ctx.moveTo(left, top);
    ctx.lineTo(width, top);
    ctx.stroke();
    ctx.font = `11px ${theme.font}`;
    [ctx.textAlign, ctx.textBaseline, ctx.fillStyle] = ["left", "top", theme.text];
    ctx.fillText(`queue full: ${queue} frames`, left + 4, top + 3);
  }

  // The more transmissions on so many pixels, the paler, or the last drawn would hide all others.
  const paleness = (many, wide) => Math.min(PALEST, (8 * wide) / many);

  // Draw the transmissions of one kind. Thinner than a pixel they are paler.
  function marks(ctx, { start, end, station, outcome }, [first, last], palest, chosen, y, high, x, grown = 0) {
    for (let i = first; i < last; i++) {
      if (!chosen(station[i], outcome[i])) continue;
      const begin = x(start[i]);
      const long = x(end[i]) - begin;
      ctx.globalAlpha = long + grown < 1 ? Math.max(palest, long) : 1;
      ctx.fillRect(Math.round(begin), y(station[i]) - grown, Math.max(1, Math.round(long)), high + 2 * grown);
    }
    ctx.globalAlpha = 1;
  }

  // Return all that moves in a piece of a run, so many seconds a pixel.
  function tile(run, number, each, { lane, top, bottom, y, high }, theme) {
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [TILE, height * scale];
    const ctx = canvas.getContext("2d");
    ctx.scale(scale, scale);
    const wide = TILE / scale;
    const [from, to] = [number * wide * each, (number + 1) * wide * each];
    const x = (time) => time / each - number * wide;
    ctx.fillStyle = theme.lane;
    for (let host = 0; host < run.hosts; host++) ctx.fillRect(0, Math.round(host * lane), wide, Math.round(lane) - GAP);
    area(ctx, run, from, Math.min(to, run.length), x, top, bottom, theme);
    const inside = [search(run.end, from), search(run.start, to)];
    const palest = run.still ? paleness(run.start.length, run.length / each) : paleness(inside[1] - inside[0], wide);
    ctx.fillStyle = run.color;
    marks(ctx, run, inside, palest, (station, outcome) => outcome === SUCCESS && station < run.hosts, y, high, x);
    ctx.fillStyle = theme.text;
    marks(ctx, run, inside, palest, (station, outcome) => outcome === SUCCESS && station === run.hosts, y, high, x);
    ctx.fillStyle = theme.bad;
    marks(ctx, run, inside, palest, (_, outcome) => outcome !== SUCCESS, y, high, x);
    return canvas;
  }

  // Put the pieces between two times beside each other.
  function pieces(run, from, each, places, theme) {
    const today = [run, run.color, theme.text, theme.lane, theme.bad, width, height, scale, each];
    if (today.some((one, i) => one !== tiled[i])) tiles.clear();
    tiled = today;
    const wide = TILE / scale;
    const begin = Math.round((from / each) * scale) / scale; // whole pixels, or it would blur
    const [first, last] = [Math.floor(begin / wide), Math.floor((begin + width - left) / wide)];
    for (const number of tiles.keys()) if (number < first || number > last) tiles.delete(number);
    for (let number = first; number <= last; number++) {
      if (!tiles.has(number)) tiles.set(number, tile(run, number, each, places, theme));
      ctx.drawImage(tiles.get(number), left + number * wide - begin, 0, wide, height);
    }
  }

  // Point at what moments are about, with their numbers.
  function pointers(moments, from, to, x, y, theme) {
    [ctx.textAlign, ctx.textBaseline, ctx.font] = ["center", "middle", `bold 13px ${theme.font}`];
    moments.forEach((moment, i) => {
      if (!moment || moment.time < from || moment.time > to) return;
      const at = [Math.min(Math.max(x(moment.time), left + 14), width - 14), Math.max(14, y(moment.station) + 8)];
      ctx.beginPath();
      ctx.arc(...at, 11, 0, 2 * Math.PI);
      [ctx.fillStyle, ctx.strokeStyle, ctx.lineWidth] = [theme.text, theme.lane, 3];
      ctx.fill();
      ctx.stroke();
      ctx.fillStyle = theme.lane;
      ctx.fillText(i + 1, ...at);
    });
    ctx.lineWidth = 1;
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
    theme,
    draw(run, from, to, theme, moments) {
      if (width <= left || height < 1) return; // not laid out
      const { hosts, start } = run;
      const lane = height / (hosts + AP_LANES);
      const each = Number(((to - from) / (width - left)).toPrecision(9)); // the same in all frames
      const x = (time) => left + (time - from) / each;
      const [top, bottom] = [Math.round(hosts * lane) + GAP, height];
      const y = (station) => (station === hosts ? bottom - Math.round(lane) : Math.round(station * lane));
      const high = Math.round(lane) - GAP;
      ctx.save();
      ctx.beginPath();
      ctx.rect(left, 0, width - left, height);
      ctx.clip();
      ctx.clearRect(left, 0, width - left, height);
      pieces(run, from, each, { lane, top, bottom, y, high }, theme);
      // What has just collided is drawn larger.
      const fresh = to - FRESH * (to - from);
      ctx.fillStyle = theme.bad;
      const recent = [search(start, fresh), search(start, to)];
      if (8 * FRESH * (width - left) > PALEST * (recent[1] - recent[0])) marks(ctx, run, recent, paleness(recent[1] - recent[0], width), (_, outcome) => outcome !== SUCCESS, y, high, x, 1);
      full(top, theme);
      ctx.restore();
      after(run, to, x, theme);
      pointers(moments, from, to, x, y, theme);
      const wanted = [hosts, run.nameOf, width, height, theme.text].join();
      if (wanted === named) return;
      named = wanted;
      ctx.clearRect(0, 0, left, height);
      names(run, lane, theme);
    },
  };
}
