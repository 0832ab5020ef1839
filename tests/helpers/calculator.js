// What the tests of the calculator do on its page.
window.calculatorTest = {
  /** Fill in fields by name as a reader would, then let the page react. */
  fill(entries) {
    const form = document.getElementById("calc-form");
    for (const [name, value] of Object.entries(entries)) form.elements[name].value = value;
    form.elements.wifi.dispatchEvent(new Event("input", { bubbles: true }));
  },

  /** Return the numbers shown, with all their digits. */
  shown() {
    return Object.fromEntries(
      [...document.querySelectorAll("#calc-tool data")].map((e) => [e.dataset.of, e.value]),
    );
  },

  /** Return the times of simulated changes, each with its name. */
  changes() {
    return [...document.querySelectorAll("#calc-tool li > data")].map((e) => [e.dataset.of, Number(e.value)]);
  },

  /** Return the advice as the command prints it: titles, and numbered changes up to their effort. */
  advice() {
    return [...document.getElementById("calc-remedies").children].flatMap((e) =>
      e.tagName === "P"
        ? [e.textContent]
        : [...e.children].map((item, i) => `${e.start + i}. ${item.textContent.split(". Effort: ")[0]}`),
    );
  },

  /** Fill in one setting after the other; return what is shown and how long it took [ms]. */
  async run(settings) {
    const answers = [];
    for (const entries of settings) {
      const start = performance.now();
      this.fill(entries);
      await null; // the plot is drawn in a microtask
      await null;
      document.body.getBoundingClientRect(); // ask for the layout too
      const took = performance.now() - start;
      answers.push({ shown: this.shown(), took });
    }
    return answers;
  },

  /** Change the number of hosts; return how long it takes until the answer is painted [ms]. */
  async untilPainted(hosts) {
    await new Promise(requestAnimationFrame);
    const start = performance.now();
    this.fill({ hosts });
    await new Promise(requestAnimationFrame);
    await new Promise((done) => {
      const channel = new MessageChannel();
      channel.port1.onmessage = done;
      channel.port2.postMessage(null); // comes after the frame
    });
    return performance.now() - start;
  },
};
