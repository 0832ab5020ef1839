// What a browser test needs to know of the page that is shown.
() => {
  const all = (selector) => [...document.querySelectorAll(selector)];
  const name = (element) =>
    element.outerHTML.slice(0, 100) + " ... " + element.textContent.trim().slice(0, 40);
  const shown = (element) => element.checkVisibility({ opacityProperty: true, visibilityProperty: true });

  // Colors, as a canvas paints them one over the other on white.
  const paint = document.createElement("canvas").getContext("2d", { willReadFrequently: true });
  const painted = new Map();
  const pixel = (colors) => {
    const key = colors.join();
    if (!painted.has(key)) {
      for (const color of ["white", ...colors]) {
        paint.fillStyle = color;
        paint.fillRect(0, 0, 1, 1);
      }
      painted.set(key, [...paint.getImageData(0, 0, 1, 1).data].slice(0, 3));
    }
    return painted.get(key);
  };
  const backgrounds = (element) => {
    const colors = [];
    for (let e = element; e; e = e.parentElement) colors.unshift(getComputedStyle(e).backgroundColor);
    return colors;
  };

  const formulas = all(".bd-article .math");
  const article = all(".bd-article");
  const prose = article.map((element) => {
    const copy = element.cloneNode(true);
    copy.querySelectorAll("pre, code, script, style, mjx-container").forEach((e) => e.remove());
    return copy.textContent;
  });
  const tooWide = all(".bd-article *").filter(
    (e) => e.clientWidth > 1 && e.scrollWidth > e.clientWidth + 1 && !e.closest("svg, mjx-container") && shown(e),
  );
  const overflow = (element) => getComputedStyle(element).overflowX;
  const images = [...document.images].filter(shown);
  return {
    theme: document.documentElement.dataset.theme,
    width: document.documentElement.scrollWidth,
    formulas: formulas.length,
    broken_formulas: formulas
      // Of a row that waits for "Show all", the parts of the formula are there, without a width.
      .filter((e) => !e.querySelector("mjx-container svg > g *"))
      .concat(formulas.filter((e) => shown(e) && !(e.getBoundingClientRect().width > 0)))
      // An error in a formula, and a command that is not known, which MathJax shows in red.
      .concat(all("mjx-container [data-mml-node=merror], mjx-container [fill=red]"))
      .map(name),
    formulas_that_scroll: all("div.math, .bd-article mjx-container[display]")
      .filter((e) => e.scrollWidth > e.clientWidth + 1 && shown(e))
      .map(name),
    // Ticks and legends are drawn with letters of 9 points, 12 px: how high these are on the page [px].
    letters_of_figures: all(".bd-article figure img").filter(shown).map((e) => (12 * e.clientWidth) / e.naturalWidth),
    raw_tex: prose.flatMap((text) => text.match(/\$\$|\\\(|\\\[|\\[a-z]+\{.{0,40}/gi) ?? []),
    figures: all("figure").filter((e) => e.querySelector("img, svg")).map((e) => e.id),
    images_not_loaded: images.filter((e) => !e.naturalWidth).map(name),
    // Where no text is given, Sphinx puts the name of the file.
    images_without_alt: images.filter((e) => !e.alt.trim() || /\.(svg|png|jpe?g)$/.test(e.alt)).map((e) => e.src),
    // Drawn on white and for white, unless it is the picture for dark pages.
    images_on_dark: images
      .filter((e) => e.closest(".bd-article") && !getComputedStyle(e).content.includes("-dark.svg"))
      .filter((e) => pixel(backgrounds(e)).some((value) => value < 243))
      .map((e) => e.src),
    clipped: tooWide.filter((e) => ["hidden", "clip"].includes(overflow(e))).map(name),
    code_that_scrolls: tooWide.filter((e) => e.matches("pre")).map(name),
    not_focusable: tooWide.filter((e) => ["auto", "scroll"].includes(overflow(e)) && e.tabIndex < 0).map(name),
    links: all("a[href]").map((e) => e.href).filter((url) => url.startsWith(location.origin === "null" ? "file:" : location.origin)),
  };
};
