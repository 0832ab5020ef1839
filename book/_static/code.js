// One switch for the code that only sets type: without scripts each cell has its own. On a phone the line
// at the top has no room for it, so that it stands below the title.
window.addEventListener("DOMContentLoaded", () => {
  const folds = [...document.querySelectorAll("div.cell.tag_hide-input > details.hide.above-input")];
  const links = document.querySelector(".ds-links");
  if (!folds.length || !links) return;
  const KEY = "ds-code";
  const root = document.documentElement;
  const buttons = ["li", "p"].map((tag) => {
    const button = document.createElement("button");
    button.type = "button";
    const item = document.createElement(tag);
    item.className = "ds-code-switch";
    item.append(button);
    return button;
  });
  const show = (all) => {
    root.classList.toggle("ds-code-folded", !all);
    for (const fold of folds) fold.open = all;
    for (const button of buttons) {
      button.textContent = all ? "Hide code" : "All code";
      button.setAttribute("aria-pressed", String(all));
    }
  };
  const remembered = () => {
    try {
      return localStorage.getItem(KEY) === "all";
    } catch {
      return false; // storage may be forbidden
    }
  };
  const press = () => {
    const all = root.classList.contains("ds-code-folded");
    show(all);
    try {
      localStorage.setItem(KEY, all ? "all" : "some");
    } catch {
      // then the next page begins anew
    }
  };
  for (const button of buttons) button.addEventListener("click", press);
  links.append(buttons[0].parentElement);
  document.querySelector(".bd-article h1")?.after(buttons[1].parentElement);
  show(remembered());
});
