// Lanes of one start around a frame: who sends when, how many frames wait at each station; below them the
// access point's queue over the whole start.
"use strict";

function LanesOfStart(canvas) {
  const ctx = canvas.getContext("2d");
  const VIEW = 60_000; // ticks that the lanes show: 6 ms
  const LONGEST = 20_000; // no frame takes longer
  const [LANE, BELOW, AXIS] = [44, 64, 16]; // heights [px]
  const FUTURE = 0.3; // how opaque what is not sent yet is
  let [width, left, stations] = [0, 0, 0];
  let view = [0, VIEW];
  let whole = 1; // how long the start takes

  function resize(hosts) {
    stations = hosts + 1;
    canvas.style.height = `${stations * LANE + AXIS + BELOW}px`;
    const scale = Math.min(2, devicePixelRatio);
    width = canvas.clientWidth;
    left = width < 500 ? 40 : 96; // room for names
    [canvas.width, canvas.height] = [width * scale, (stations * LANE + AXIS + BELOW) * scale];
    ctx.setTransform(scale, 0, 0, scale, 0, 0);
  }

  const x = (time, [from, to] = view) => left + ((time - from) / (to - from)) * (width - left);

  function text(words, at, y, color, align = "left", size = 11) {
    [ctx.textAlign, ctx.textBaseline, ctx.fillStyle] = [align, "middle", color];
    ctx.font = `${size}px ${getComputedStyle(canvas).fontFamily}`;
    ctx.fillText(words, at, y);
  }

  // How many frames wait at a station, as an area; red where its queue is full.
  function area({ get, waiting, last, count, firstFrom }, station, [from, to], [top, bottom], { most, queue }, theme) {
    const each = (to - from) / (width - left); // ticks a pixel
    let row = Math.max(0, firstFrom(from - LONGEST) - 1);
    let [begin, many] = [left, waiting(row, station)];
    const fill = (end) => {
      ctx.fillStyle = queue && many >= 0.97 * queue ? theme.bad : theme.text;
      const high = (Math.min(many, most) / most) * (bottom - top);
      ctx.fillRect(begin, bottom - high, end - begin, high);
    };
    ctx.globalAlpha = 0.3;
    for (let pixel = left; pixel < width; pixel++) {
      // What waits after an exchange waits until the next has ended.
      const time = from + (pixel - left) * each;
      for (let next = last[row] + 1; next < count && get(next, "end") <= time; next = last[row] + 1) row = next;
      if (waiting(row, station) === many) continue;
      fill(pixel);
      [begin, many] = [pixel, waiting(row, station)];
    }
    fill(width);
    ctx.globalAlpha = 1;
  }

  function frames({ get, failed, firstFrom, count, POINT }, now, theme) {
    for (let row = firstFrom(view[0] - LONGEST); row < count && get(row, "start") < view[1]; row++) {
      const [begin, end] = [Math.max(left, x(get(row, "start"))), Math.min(width, x(get(row, "end")))];
      if (end <= left) continue;
      const station = get(row, "station");
      const [top, high] = [(station + 1) * LANE - 18, 14];
      ctx.globalAlpha = get(row, "start") > now ? FUTURE : 1;
      ctx.fillStyle = failed(row) ? theme.bad : station === POINT ? theme.text : theme.color;
      ctx.fillRect(begin, top, Math.max(1, end - begin), high);
      if (!failed(row) || end - begin < 4) continue;
      ctx.strokeStyle = theme.lane; // what failed is not told by its color alone
      ctx.lineWidth = 1.5;
      ctx.beginPath();
      ctx.moveTo(begin, top + high);
      ctx.lineTo(end, top);
      ctx.stroke();
    }
    ctx.globalAlpha = 1;
  }

  // The chosen frame: dashed while it is in the queue, a line while it is first in it, then a box.
  function chosen({ get, waits }, row, theme) {
    const [start, end] = [get(row, "start"), get(row, "end")];
    const y = (get(row, "station") + 1) * LANE - 11;
    const { came, head } = waits[row];
    [ctx.strokeStyle, ctx.lineWidth] = [theme.text, 2];
    for (const [from, to, dash] of [[came, head, [3, 3]], [head, start, []]]) {
      ctx.setLineDash(dash);
      ctx.beginPath();
      ctx.moveTo(Math.max(left, x(from)), y);
      ctx.lineTo(Math.max(left, x(to)), y);
      ctx.stroke();
    }
    ctx.strokeRect(x(start) - 1.5, y - 8.5, Math.max(3, x(end) - x(start) + 3), 17);
  }

  function draw(trace, row, start, theme) {
    const { get, waiting, count, robot } = trace;
    const [queue] = start.setting.queue ?? [0];
    const most = queue || start.most;
    const now = get(row, "start");
    whole = get(count - 1, "end");
    const from = Math.max(0, Math.min(now - VIEW / 2, whole - VIEW));
    view = [from, from + VIEW];
    ctx.clearRect(0, 0, width, canvas.height);
    for (let station = 0; station < stations; station++) {
      const top = station * LANE;
      ctx.fillStyle = theme.lane;
      ctx.fillRect(left, top, width - left, LANE - 3);
      area(trace, station, view, [top + 2, top + LANE - 20], { most, queue }, theme);
      const short = left < 50;
      const name = station === start.hosts ? (short ? "AP" : "access point") : short ? `${station + 1}` : robot(station);
      text(name, left - 6, top + 13, theme.text, "right", 13);
      text(`${waiting(row, station)}${short ? "" : " waiting"}`, left - 6, top + 29, theme.muted, "right");
    }
    frames(trace, now, theme);
    chosen(trace, row, theme);
    const axis = stations * LANE;
    for (let tick = Math.ceil(view[0] / 1e4); tick * 1e4 < view[1]; tick++) {
      ctx.fillStyle = theme.muted;
      ctx.fillRect(x(tick * 1e4), axis - 3, 1, 4);
      if (x(tick * 1e4) < width - 28) text(tick === Math.ceil(view[0] / 1e4) ? `${tick} ms` : `${tick}`, x(tick * 1e4), axis + 8, theme.muted);
    }
    below(trace, now, { most: queue || Math.max(1, start.most), queue }, theme);
  }

  // The access point's queue over the whole start, and what part of it the lanes show.
  function below(trace, now, limits, theme) {
    const [top, bottom] = [stations * LANE + AXIS + 8, stations * LANE + AXIS + BELOW - 14];
    ctx.fillStyle = theme.lane;
    ctx.fillRect(left, top, width - left, bottom - top);
    area(trace, stations - 1, [0, whole], [top + 2, bottom], limits, theme);
    [ctx.strokeStyle, ctx.lineWidth] = [theme.muted, 1];
    const [begin, end] = view.map((time) => x(time, [0, whole]));
    ctx.strokeRect(begin + 0.5, top + 0.5, Math.max(2, Math.min(width, end) - begin - 1), bottom - top - 1);
    ctx.fillStyle = theme.text;
    ctx.fillRect(x(now, [0, whole]) - 1, top - 4, 2, bottom - top + 8);
    const short = left < 50;
    text(short ? "AP" : "access point", left - 6, top + 12, theme.text, "right", 13);
    if (!short) text("whole start", left - 6, top + 28, theme.muted, "right");
    text("0", left, bottom + 8, theme.muted);
    text(`${Math.round(whole / 1e4)} ms`, width, bottom + 8, theme.muted, "right");
  }

  // Return the row that a pointer is at: in the lanes the nearest frame of the lane, below the frame of that time.
  function at(trace, event) {
    const box = canvas.getBoundingClientRect();
    const [across, down] = [event.clientX - box.left, event.clientY - box.top];
    const share = Math.min(1, Math.max(0, (across - left) / (width - left)));
    if (down >= stations * LANE) return Math.min(trace.count - 1, trace.firstFrom(share * whole));
    const [time, station] = [view[0] + share * (view[1] - view[0]), Math.floor(down / LANE)];
    let [nearest, distance] = [-1, Infinity];
    for (let row = trace.firstFrom(view[0] - LONGEST); row < trace.count && trace.get(row, "start") < view[1]; row++) {
      if (trace.get(row, "station") !== station) continue;
      const off = Math.max(0, trace.get(row, "start") - time, time - trace.get(row, "end"));
      if (off < distance) [nearest, distance] = [row, off];
    }
    return nearest;
  }

  return { resize, draw, at, isBelow: (event) => event.clientY - canvas.getBoundingClientRect().top >= stations * LANE };
}
