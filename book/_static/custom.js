// Boxes that scroll sideways can be reached, and so scrolled, with the keyboard.
window.addEventListener("load", async () => {
  await window.MathJax?.startup?.promise;
  const boxes = document.querySelectorAll("div.math, .pst-scrollable-table-container, .bd-article pre");
  const observer = new ResizeObserver((changes) => {
    for (const { target: box } of changes) {
      if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
      else box.removeAttribute("tabindex");
    }
  });
  for (const box of boxes) observer.observe(box); // also when it is unfolded
});

// A notebook is saved, whatever type the server gives it.
window.addEventListener("load", () => {
  for (const link of document.querySelectorAll(".btn-download-source-button")) link.download = "";
});
