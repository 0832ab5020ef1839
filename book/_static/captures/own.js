// A reader's own capture: the file that `discostorm capture --json` writes, chosen or dropped. It is read here, and
// goes nowhere. What is wrong with a file is said, and what was shown before stays.
"use strict";

(() => {
  const { DATA, make } = LANES;
  const RUN = "discostorm capture FILE --json > capture.json";
  const MOST = 64; // megabytes; the command writes one or two
  // How captures begin: pcap of both byte orders and clocks, pcapng; compressed ones.
  const MAGIC = ["d4c3b2a1", "a1b2c3d4", "4d3cb2a1", "a1b23c4d", "0a0d0d0a", "1f8b", "fd377a58"];
  const section = document.getElementById("my-capture")?.closest("section");
  if (!section) return;

  const input = make("input", { type: "file", id: "own-file", accept: ".json,.txt,application/json" });
  const error = make("p", { class: "own-error", role: "alert" });
  const shown = make("div", { class: "own-shown" });
  const drop = make(
    "div",
    { class: "own-drop" },
    make("label", { for: input.id }, "Choose the file, or drop it here: "),
    input,
    make("p", {}, "It doesn’t leave your computer."),
  );
  const box = make("div", { class: "own", role: "group", "aria-label": "Your capture" }, drop, error, shown);
  section.append(box);

  // PowerShell writes UTF-16.
  function decoded(bytes) {
    const name = { "255,254": "utf-16le", "254,255": "utf-16be" }[bytes.slice(0, 2).join()] ?? "utf-8";
    return new TextDecoder(name).decode(bytes);
  }

  // Return what a file holds; raise an error that says what to do.
  async function read(file) {
    if (file.size > MOST * 1e6) throw new Error(`It has more than ${MOST} MB. Choose what this command writes: ${RUN}`);
    const bytes = new Uint8Array(await file.arrayBuffer());
    const begin = [...bytes.slice(0, 4)].map((byte) => byte.toString(16).padStart(2, "0")).join("");
    if (MAGIC.some((magic) => begin.startsWith(magic))) throw new Error(`It is the capture itself. Run ${RUN.replace("FILE", () => file.name)} and choose the file capture.json.`);
    let answer;
    try {
      answer = JSON.parse(decoded(bytes));
    } catch {
      throw new Error(`It holds no JSON. Choose what this command writes: ${RUN}`);
    }
    const problem = TOLD.wrong(answer);
    if (problem) throw new Error(`${problem} Choose what this command writes: ${RUN}`);
    return answer;
  }

  let asked = 0; // so that a late answer to an earlier choice is dropped
  async function take(file) {
    const mine = ++asked;
    try {
      const answer = await read(file);
      if (mine !== asked) return;
      const parts = TOLD.all(answer, DATA.captures[0]);
      error.textContent = "";
      shown.replaceChildren(...parts);
      shown.firstChild.focus();
    } catch (problem) {
      if (mine !== asked) return;
      const kept = shown.firstChild ? " Below is still the file that you chose before." : "";
      error.textContent = `${file.name}: ${problem.message}${kept}`;
    }
  }

  input.addEventListener("change", () => {
    if (input.files.length) take(input.files[0]);
    input.value = ""; // the same file may be chosen again
  });
  const files = (event) => [...event.dataTransfer.types].includes("Files");
  // A file that misses the box would take the page's place.
  for (const name of ["dragover", "drop"]) addEventListener(name, (event) => files(event) && event.preventDefault());
  addEventListener("dragover", (event) => drop.classList.toggle("own-over", files(event) && drop.contains(event.target)));
  addEventListener("dragleave", () => drop.classList.remove("own-over"));
  addEventListener("drop", (event) => {
    drop.classList.remove("own-over");
    if (!files(event)) return;
    if (event.dataTransfer.files.length > 1) error.textContent = "Drop one file at a time.";
    else take(event.dataTransfer.files[0]);
  });
})();
