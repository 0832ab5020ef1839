// What figures to touch have in common: a layer over the stored picture, whose panels are where the
// package says they are, sliders below it, and a sentence for those who do not see it.
"use strict";

const CHAPTER = (() => {
  const SVG = "http://www.w3.org/2000/svg";
  const DRAWN = ["svg", "path", "circle", "text", "clipPath", "rect", "g"];

  function make(tag, attributes = {}, ...children) {
    const element = DRAWN.includes(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  function put(dot, [x, y]) {
    dot.setAttribute("cx", x);
    dot.setAttribute("cy", y);
  }

  const within = (value, low, high) => Math.min(high, Math.max(low, value));

  // Lay a picture over that of the figure, which is as large as it likes. `size` is that of the
  // stored picture; `panels` are parts of it, with the values at their ends; `narrow` has the same of
  // the picture for phones. When one takes the place of the other, `redraw` is called.
  function over(figure, { narrow, ...wide }, redraw = () => {}) {
    const picture = make("svg", { class: "line-picture", "aria-hidden": "true" });
    const across = (part, [from, to]) => from + part * (to - from);
    const share = (value, [from, to]) => (value - from) / (to - from);
    const placed = ({ size: [width, height], panels: boxes }) => boxes.map(({ x, y, xlim, ylim }, index) => ({
      index,
      xlim,
      ylim,
      left: width * x[0],
      right: width * x[1],
      top: height * y[1],
      bottom: height * y[0],
      // From the panel's own units to the picture, and from the pointer back.
      place: (a, b) => [width * across(share(a, xlim), x), height * across(share(b, ylim), y)],
      at: ({ clientX, clientY }) => {
        const box = picture.getBoundingClientRect();
        const [a, b] = [(clientX - box.left) / box.width, (clientY - box.top) / box.height];
        return [across(share(a, x), xlim), across(share(b, y), ylim)];
      },
    }));
    const panels = placed(wide);
    const clips = panels.map(() => make("rect"));
    for (const [index, clip] of clips.entries()) picture.append(make("clipPath", { id: `${figure.id}-clip-${index}` }, clip));
    const phone = matchMedia("(width < 37.5rem)"); // as _ext/pictures.py says
    const fit = () => {
      const shown = narrow && phone.matches && figure.querySelector("picture") ? narrow : wide;
      picture.setAttribute("viewBox", `0 0 ${shown.size.join(" ")}`);
      for (const [index, panel] of placed(shown).entries()) {
        Object.assign(panels[index], panel);
        const { left, right, top, bottom } = panel;
        const box = { x: left, y: top, width: right - left, height: bottom - top };
        for (const [name, value] of Object.entries(box)) clips[index].setAttribute(name, value);
      }
    };
    fit();
    phone.addEventListener("change", () => {
      fit();
      redraw();
    });
    const inside = ({ index }, ...children) =>
      picture.append(make("g", { "clip-path": `url(#${figure.id}-clip-${index})` }, ...children));
    addEventListener("load", () => {
      const image = figure.querySelector("img");
      const box = image.closest(".ds-figure") ?? image.parentElement; // custom.js makes it
      box.classList.add("line-box");
      box.append(picture);
      const cover = () => {
        // The box scrolls sideways on a phone; what is in it goes along.
        const [outer, inner] = [box.getBoundingClientRect(), image.getBoundingClientRect()];
        picture.style.left = `${inner.left - outer.left + box.scrollLeft}px`;
        picture.style.top = `${inner.top - outer.top + box.scrollTop}px`;
        picture.style.width = `${inner.width}px`;
        picture.style.height = `${inner.height}px`;
      };
      new ResizeObserver(cover).observe(image);
      cover();
    });
    return { picture, panels, inside };
  }

  function slider(name, label, min, max, step, changed, told = String) {
    const shown = make("strong", { class: "line-shown", "aria-hidden": "true" });
    const input = make("input", { type: "range", id: `line-${name}`, min, max, step, autocomplete: "off" });
    input.addEventListener("input", () => changed(input.valueAsNumber));
    const set = (value) => {
      input.value = value;
      shown.textContent = told(value);
      input.setAttribute("aria-valuetext", told(value));
    };
    return { name, set, box: make("div", {}, make("label", { for: input.id }, `${label}:`), shown, input) };
  }

  // Put sliders below the figure, and return the line that says what is drawn.
  function controls(figure, name, how, sliders) {
    const told = make("p", { class: "line-told", role: "status" });
    const boxes = sliders.map(({ box }) => box);
    const group = make("div", { class: "line-controls", role: "group", "aria-label": name }, make("p", { class: "line-how" }, how), ...boxes, told);
    figure.querySelector("figcaption").before(group);
    return told;
  }

  return { make, put, within, over, slider, controls };
})();
