// Save a figure as SVG or PNG, and copy how to cite it. The picture comes in a script, which pages
// that were opened as files may read. Without this, the SVG is a link and the citation a text.
"use strict";

addEventListener("DOMContentLoaded", () => {
  const SCALE = 3; // of a PNG: sharp on paper, too

  function picture(address, name) {
    if (window.PICTURES?.[name]) return Promise.resolve(window.PICTURES[name]);
    return new Promise((found, failed) => {
      const script = Object.assign(document.createElement("script"), { src: address, onerror: failed });
      script.onload = () => found(window.PICTURES[name]);
      document.head.append(script);
    });
  }

  function save(blob, file) {
    const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: file });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  }

  async function pixels(svg) {
    const image = new Image();
    image.src = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    await image.decode();
    const canvas = document.createElement("canvas");
    [canvas.width, canvas.height] = [SCALE * image.naturalWidth, SCALE * image.naturalHeight];
    const paper = canvas.getContext("2d");
    paper.fillStyle = "white";
    paper.fillRect(0, 0, canvas.width, canvas.height);
    paper.drawImage(image, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(image.src);
    return new Promise((done) => canvas.toBlob(done, "image/png"));
  }

  for (const tools of document.querySelectorAll(".ds-tools")) {
    const { id } = tools.closest("figure");
    const [svg, png] = [tools.querySelector("a"), tools.querySelector("button")];
    const { picture: address } = png.dataset;
    png.hidden = false;
    png.addEventListener("click", async () => save(await pixels(await picture(address, id)), `${id}.png`));
    svg.addEventListener("click", async (event) => {
      if (location.protocol !== "file:") return; // there a link is saved by the browser itself
      event.preventDefault();
      save(new Blob([await picture(address, id)], { type: "image/svg+xml" }), svg.download);
    });
    const data = document.querySelector(`.output > a[download="${id}.csv"]`);
    data?.parentElement.remove();
    if (data) png.after(data); // on the line of the other files
    const text = tools.querySelector("details > p");
    const copy = Object.assign(document.createElement("button"), { type: "button", textContent: "Copy" });
    copy.addEventListener("click", async () => {
      await navigator.clipboard.writeText(text.textContent);
      copy.textContent = "Copied";
    });
    if (navigator.clipboard) text.after(copy);
  }
});
