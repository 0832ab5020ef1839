// Boxes that scroll sideways can be reached, and so scrolled, with the keyboard.
window.addEventListener("load", async () => {
  await window.MathJax?.startup?.promise;
  const boxes = document.querySelectorAll("div.math, .pst-scrollable-table-container, .bd-article pre");
  // A wide table fades where it goes on, and a line below it says so.
  const atEnd = (box) => box.classList.toggle("ds-at-end", box.scrollLeft + box.clientWidth > box.scrollWidth - 2);
  const hint = (box, wider) => {
    if (!box.matches(".pst-scrollable-table-container") || box.classList.contains("ds-wider") === wider) return;
    box.classList.toggle("ds-wider", wider);
    if (!wider) return box.nextElementSibling.remove();
    const line = document.createElement("p");
    line.className = "ds-scroll-hint";
    line.textContent = "\u2190 the table scrolls sideways \u2192";
    box.after(line);
    box.addEventListener("scroll", () => atEnd(box), { passive: true });
    atEnd(box);
  };
  const observer = new ResizeObserver((changes) => {
    for (const { target: box } of changes) {
      const wider = box.scrollWidth > box.clientWidth + 1;
      if (wider) box.tabIndex = 0;
      else box.removeAttribute("tabindex");
      hint(box, wider);
    }
  });
  for (const box of boxes) observer.observe(box); // also when it is unfolded
});

// A notebook is saved, whatever type the server gives it.
window.addEventListener("load", () => {
  for (const link of document.querySelectorAll(".btn-download-source-button")) link.download = "";
});
