// One switch for the code that only sets type: without scripts each cell has its own.
window.addEventListener("DOMContentLoaded", () => {
  const folds = [...document.querySelectorAll("div.cell.tag_hide-input > details.hide.above-input")];
  const links = document.querySelector(".ds-links");
  if (!folds.length || !links) return;
  const KEY = "ds-code";
  const root = document.documentElement;
  const button = document.createElement("button");
  button.type = "button";
  const show = (all) => {
    root.classList.toggle("ds-code-folded", !all);
    for (const fold of folds) fold.open = all;
    button.textContent = all ? "Hide code" : "All code";
    button.setAttribute("aria-pressed", String(all));
  };
  const remembered = () => {
    try {
      return localStorage.getItem(KEY) === "all";
    } catch {
      return false; // storage may be forbidden
    }
  };
  button.addEventListener("click", () => {
    const all = root.classList.contains("ds-code-folded");
    show(all);
    try {
      localStorage.setItem(KEY, all ? "all" : "some");
    } catch {
      // then the next page begins anew
    }
  });
  const item = document.createElement("li");
  item.append(button);
  links.append(item);
  show(remembered());
});
