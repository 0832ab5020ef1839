// Wait until the page that is shown has come to rest.
async () => {
  if (document.readyState !== "complete") await new Promise((done) => addEventListener("load", done));
  await window.MathJax?.startup?.promise;
  // Let the page react to what it was told last, such as its new size, to the end of what moves.
  for (let i = 0; i < 3; i++) await new Promise(requestAnimationFrame);
  const moving = document.getAnimations().filter((a) => Number.isFinite(a.effect.getComputedTiming().endTime));
  const waited = new Promise((done) => setTimeout(done, 1000)); // a paused one would never end
  await Promise.race([waited, Promise.allSettled(moving.map((animation) => animation.finished))]);
};
