// What a link to an equation, a figure or a chapter leads to, shown under the pointer and at the keyboard's focus. The
// pointer may go onto it, Escape closes it. Its index (book/_ext/hover.py) is loaded when it is first wanted.
"use strict";

(() => {
  const [WAIT, LINGER] = [300, 250]; // until it comes and goes [ms]
  const LINK = ".bd-article a.reference.internal[href]";
  const root = new URL(document.documentElement.dataset.content_root ?? "./", location.href).href;
  const tip = document.createElement("div");
  tip.id = "ds-hover";
  tip.setAttribute("role", "tooltip");
  tip.hidden = true;
  let index = null; // a promise of it
  let [link, timer] = [null, null];

  const load = () =>
    (index ??= new Promise((done, failed) => {
      const script = document.createElement("script");
      script.src = `${root}_static/hover-index.js`;
      script.onload = () => done(HOVER_INDEX);
      script.onerror = failed;
      document.head.append(script);
    }));

  const make = (tag, content) => Object.assign(document.createElement(tag), content);

  async function show(wanted) {
    const found = (await load())[wanted.href.slice(root.length)];
    if (!found || link !== wanted || (found.tex && !window.MathJax?.typesetPromise)) return;
    // The link knows its number.
    const parts = [make("p", { className: "ds-hover-name", textContent: found.tex ? `Equation ${wanted.textContent}` : found.name })];
    if (found.tex) parts.push(make("div", { textContent: `\\[${found.tex}\\]` }));
    const dark = document.documentElement.dataset.theme === "dark";
    const image = dark ? found.image?.replace(".svg", "-dark.svg") : found.image; // as _ext/pictures.py names it
    if (image) parts.push(make("img", { src: root + image, alt: "", onload: () => link && place() }));
    if (found.text) parts.push(make("p", { textContent: found.text }));
    tip.replaceChildren(...parts);
    document.body.append(tip);
    [tip.hidden, tip.style.visibility] = [false, "hidden"]; // formulas are measured
    if (found.tex) await MathJax.typesetPromise([tip]);
    for (const element of tip.querySelectorAll("[tabindex]")) element.removeAttribute("tabindex");
    if (link !== wanted) return;
    wanted.setAttribute("aria-describedby", tip.id);
    place();
  }

  // Below the link, or above it where there is no room.
  function place() {
    const [at, box] = [link.getClientRects()[0], tip.getBoundingClientRect()];
    tip.style.visibility = !at || at.bottom < 0 || at.top > innerHeight ? "hidden" : ""; // it scrolls into sight
    if (!at) return;
    const below = at.bottom + box.height + 8 < innerHeight;
    tip.style.left = `${Math.max(8, Math.min(at.left, innerWidth - box.width - 8))}px`;
    tip.style.top = `${below ? at.bottom + 4 : Math.max(8, at.top - box.height - 4)}px`;
  }

  function hide() {
    clearTimeout(timer);
    link?.removeAttribute("aria-describedby");
    link = null;
    tip.hidden = true;
  }

  function soon(wanted, time) {
    clearTimeout(timer);
    if (wanted === link) return;
    timer = setTimeout(() => {
      hide();
      link = wanted;
      if (wanted) show(wanted).catch(hide);
    }, time);
  }

  const linkOf = ({ target }) => (target.closest?.(LINK)?.href.startsWith(root) ? target.closest(LINK) : null);
  addEventListener("pointerover", (event) => {
    if (event.pointerType !== "mouse") return;
    const wanted = linkOf(event);
    if (wanted) soon(wanted, WAIT);
    else if (tip.contains(event.target)) clearTimeout(timer);
    else if (link !== document.activeElement) soon(null, LINGER);
  });
  addEventListener("focusin", (event) => {
    const wanted = linkOf(event);
    if (wanted?.matches(":focus-visible")) soon(wanted, WAIT);
  });
  addEventListener("focusout", hide);
  addEventListener("scroll", () => tip.hidden || place(), { passive: true });
  addEventListener("keydown", ({ key }) => key === "Escape" && hide());
})();
