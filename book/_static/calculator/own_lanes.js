// One simulated startup of the reader's own fleet as lanes: who sends when, and how many frames wait at the access
// point. It is the whole startup at once, at the first page's scale of colors.
"use strict";

const OwnLanes = (box, queue) => {
  const [ROW, LEAST, MOST] = [18, 160, 480]; // of the picture: a lane's height, and its own [px]
  const canvas = box.querySelector("canvas");
  const lanes = Lanes(canvas, queue);
  let shown = null;

  function paint() {
    if (!shown || !canvas.clientWidth) return;
    const style = getComputedStyle(document.documentElement);
    shown.color = style.getPropertyValue(shown.from).trim();
    lanes.draw(shown, 0, shown.length, lanes.theme(), []);
  }

  /** Draw what was sent, by hosts with names, up to so many seconds; null hides the picture. */
  function show(run) {
    box.hidden = run === null;
    shown = run && { ...run, ended: "", still: true, looks: { ...run.looks, at: run.looks.time } };
    if (!run) return;
    box.querySelector(".calc-lanes-robot").style.setProperty("--color", `var(${run.from})`);
    box.querySelector(".calc-lanes-end").textContent = run.words;
    canvas.style.height = `${Math.min(MOST, Math.max(LEAST, ROW * (run.hosts + 3)))}px`;
    canvas.setAttribute("aria-label", run.label);
    lanes.resize();
    paint();
  }

  /** The picture below a title, as a PNG. */
  function picture(title) {
    const style = getComputedStyle(document.documentElement);
    const [wide, scale] = [canvas.clientWidth, canvas.width / canvas.clientWidth];
    const [line, font] = [22, `bold 16px ${getComputedStyle(canvas).fontFamily}`];
    const sheet = document.createElement("canvas");
    const pen = sheet.getContext("2d");
    pen.font = font;
    const lines = [""];
    for (const word of `${title} ${shown.words}`.split(" ")) {
      const longer = `${lines.at(-1)} ${word}`.trim();
      if (pen.measureText(longer).width > wide) lines.push(word);
      else lines[lines.length - 1] = longer;
    }
    const top = line * lines.length + 8;
    [sheet.width, sheet.height] = [canvas.width, canvas.height + top * scale];
    pen.scale(scale, scale);
    pen.fillStyle = style.getPropertyValue("--pst-color-background");
    pen.fillRect(0, 0, sheet.width, sheet.height);
    [pen.fillStyle, pen.font, pen.textBaseline] = [lanes.theme().text, font, "top"];
    lines.forEach((text, i) => pen.fillText(text, 0, i * line));
    pen.drawImage(canvas, 0, top, wide, canvas.clientHeight);
    return new Promise((done) => sheet.toBlob(done, "image/png"));
  }

  new ResizeObserver(() => {
    lanes.resize();
    paint();
  }).observe(canvas);

  return { show, paint, picture };
};
