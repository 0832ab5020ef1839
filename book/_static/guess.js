// A question before the answer: "In short" stays folded until the reader guesses or skips. The
// question and the answer are the package's, in the data on the page (discostorm_book.interactive).
// Nothing leaves the page: that it was answered is kept in this tab alone.
"use strict";

(() => {
  const DATA = JSON.parse(document.getElementById("guess-data").textContent);
  const article = document.querySelector(".bd-article");
  const isAnswer = ({ firstElementChild: first }) => first?.tagName === "STRONG" && first.textContent === "In short.";
  const answer = [...article.querySelectorAll("p")].find(isAnswer);
  const KEY = `guess ${location.pathname}`;

  // Where a browser keeps nothing, as some do for files, the question comes again.
  const kept = {
    get: () => {
      try {
        return sessionStorage.getItem(KEY);
      } catch {
        return null;
      }
    },
    set: () => {
      try {
        sessionStorage.setItem(KEY, "yes");
      } catch {}
    },
  };
  // Who comes by a link to a place on the page looks for that place.
  if (!answer || location.hash || kept.get()) return;

  function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }

  const sign = DATA.unit === "%" ? "%" : `\u00a0${DATA.unit}`;
  const number = (value) => value.toFixed(DATA.places);
  const shown = (value) => `${number(value)}${sign}`;

  const question = make("p", { id: "guess-question" }, make("strong", {}, "Guess first. "), DATA.question);
  const output = make("strong", { class: "guess-shown" });
  const input = make("input", { type: "range", id: "guess-value", min: DATA.least, max: DATA.most, step: DATA.step, value: DATA.least, autocomplete: "off", "aria-describedby": "guess-question" });
  const range = make("div", { class: "guess-range" }, input);
  const ends = make("div", { class: "guess-ends", "aria-hidden": "true" }, ...[DATA.least, DATA.most].map((end) => make("span", {}, DATA.unit === "%" ? `${end}%` : String(end))));
  const guessed = make("button", { type: "submit" }, "Guess");
  const skip = make("button", { type: "button" }, "Skip");
  const told = make("p", { role: "status" });
  const form = make(
    "form",
    { class: "guess", "aria-label": "Guess first" },
    question,
    make("label", { for: input.id }, "Your guess: ", output),
    range,
    ends,
    guessed,
    skip,
    told,
  );

  function tell() {
    output.textContent = shown(input.valueAsNumber);
    input.setAttribute("aria-valuetext", shown(input.valueAsNumber));
  }

  function unfold() {
    kept.set();
    answer.classList.remove("guess-folded");
    removeEventListener("hashchange", leave);
  }

  // The keyboard goes on at the answer.
  function goOn() {
    answer.tabIndex = -1;
    answer.focus({ preventScroll: true });
  }

  function leave() {
    unfold();
    form.remove();
  }

  function compare(event) {
    event.preventDefault();
    unfold();
    input.disabled = true;
    const mark = make("span", { class: "guess-mark", "aria-hidden": "true" });
    mark.style.setProperty("--part", (DATA.answer - DATA.least) / (DATA.most - DATA.least));
    range.append(mark);
    const mine = input.valueAsNumber;
    const same = number(mine) === number(DATA.answer);
    told.textContent = same ? `You guessed it: ${shown(DATA.answer)}.` : `You guessed ${shown(mine)}. It is ${shown(DATA.answer)}.`;
    guessed.remove();
    skip.remove();
    goOn();
  }

  input.addEventListener("input", tell);
  form.addEventListener("submit", compare);
  skip.addEventListener("click", () => {
    leave();
    goOn();
  });
  addEventListener("hashchange", leave);
  answer.classList.add("guess-folded");
  answer.before(form);
  tell();
})();
