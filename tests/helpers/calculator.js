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

  /** Fill in one setting after the other; return what is shown. */
  async run(settings) {
    const answers = [];
    for (const entries of settings) {
      this.fill(entries);
      await null; // the plot is drawn in a microtask
      await null;
      answers.push({ shown: this.shown() });
    }
    return answers;
  },

  /** Change the number of hosts, and wait until the answer is painted. */
  async untilPainted(hosts) {
    await new Promise(requestAnimationFrame);
    this.fill({ hosts });
    await new Promise(requestAnimationFrame);
    await new Promise((done) => {
      const channel = new MessageChannel();
      channel.port1.onmessage = done;
      channel.port2.postMessage(null); // comes after the frame
    });
  },
};
