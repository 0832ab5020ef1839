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

// Tables in cells tagged "sortable": each heading becomes a button that sorts.
window.addEventListener("load", () => {
  for (const table of document.querySelectorAll(".tag_sortable table")) {
    for (const heading of table.querySelectorAll("thead th")) heading.tabIndex = 0;
    new Tablesort(table);
    table.addEventListener("keydown", (event) => {
      if ((event.key === "Enter" || event.key === " ") && event.target.matches("thead th")) {
        event.preventDefault();
        event.target.click();
      }
    });
  }
});
