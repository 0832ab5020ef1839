// Search in the sections of the book, which sections.js holds: it needs no server.
(() => {
  // What readers call by another name than the book, which says host and Wi-Fi.
  const ALSO = [
    ["robot", "host"],
    ["node", "process"],
    ["topic", "endpoint"],
    ["stagger", "staggered"],
    ["saturation", "saturate", "full"],
    ["pcap", "capture"],
  ];
  const STOP = new Set("a an and are as at be but by for from how if in into is it many much my no not of on or so such that the their then there these they this to was what when which will with".split(" "));
  const MOST = 20;
  const MOST_OF_A_PAGE = 3;
  const LENGTH = 240;

  const plain = (text) =>
    text.toLowerCase().replace(/wi-fi/g, "wifi").replace(/\b(cyclone|fast)dds\b/g, "$1 dds").replace(/[’']/g, "");
  const singular = (term) => (/[^su]s$/.test(term) && term.length > 3 ? term.slice(0, -1) : term);
  const tokenize = (text) => plain(text).match(/[\p{L}\p{N}_]+/gu) ?? [];
  const processTerm = (term) => (STOP.has(term) ? null : singular(term));
  const phrase = (text) => ` ${tokenize(text).map(singular).join(" ")} `;

  const sections = window.SECTIONS.map((section, id) => ({ id, ...section }));
  const index = new MiniSearch({
    fields: ["title", "page", "text", "code"],
    tokenize,
    processTerm,
    searchOptions: { prefix: (term) => term.length > 3 },
  });
  index.addAll(sections);

  function find(query) {
    const asked = phrase(query);
    const several = asked.trim().includes(" ");
    const words = [...new Set(tokenize(query).map(processTerm).filter(Boolean))];
    // Every word, or another name for it; if no section has all of them, any.
    const any = words.map((word) => ALSO.find((names) => names.includes(word)) ?? [word]);
    const queries = any.map((names, i) => ({
      combineWith: "OR",
      queries: names.map((name) =>
        name === words[i] ? name : { combineWith: "OR", queries: [name], boostTerm: () => 0.4 },
      ),
    }));
    // The words side by side, the oftener the better; before all the pages to which all readers are led.
    const boostDocument = (id) => {
      const { title, text, url } = sections[id];
      const front = /^book\/(index|calculator)\./.test(url) ? 1.5 : 1;
      if (!several) return front;
      const often = phrase(text).split(asked.trimEnd() + " ").length - 1;
      return front * (phrase(title).includes(asked) ? 4 : 1) * (1 + Math.log2(1 + often));
    };
    // One of several words in a title says little; all of them side by side count above.
    const options = { boostDocument, boost: { title: several ? 2 : 6, page: 2, code: 0.3 } };
    const all = index.search({ combineWith: "AND", queries }, options);
    const found = all.length ? all : index.search({ combineWith: "OR", queries }, { ...options, fuzzy: 0.2 });
    const ofPage = new Map();
    return found.filter(({ id }) => {
      const { page } = sections[id];
      ofPage.set(page, (ofPage.get(page) ?? 0) + 1);
      return ofPage.get(page) <= MOST_OF_A_PAGE;
    });
  }

  // The part of a text where most of the terms are, with these marked.
  function excerpt(text, terms) {
    const hits = [...text.matchAll(/[\p{L}\p{N}_-]+/gu)].filter(([word]) =>
      tokenize(word).some((part) => terms.has(singular(part))),
    );
    const within = (first) => hits.filter((hit) => hit.index >= first.index && hit.index < first.index + LENGTH - 60);
    const distinct = (first) => new Set(within(first).map(([word]) => singular(plain(word)))).size;
    const best = hits.reduce((a, b) => (a && distinct(a) >= distinct(b) ? a : b), undefined);
    let start = Math.max(0, (best?.index ?? 0) - 60);
    if (start) start = text.indexOf(" ", start) + 1;
    let end = Math.min(text.length, start + LENGTH);
    if (end < text.length) end = Math.max(text.lastIndexOf(" ", end), start);
    const shown = document.createElement("p");
    shown.append(start ? "… " : "");
    let at = start;
    for (const hit of hits.filter(({ index }) => index >= start && index < end)) {
      const mark = document.createElement("mark");
      mark.textContent = hit[0];
      shown.append(text.slice(at, hit.index), mark);
      at = hit.index + hit[0].length;
    }
    shown.append(text.slice(at, end), end < text.length ? " …" : "");
    return shown;
  }

  function show(query) {
    const results = find(query);
    const list = document.createElement("ol");
    for (const { id, terms } of results.slice(0, MOST)) {
      const { title, page, url, text, code, number } = sections[id];
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = url;
      link.textContent = title;
      const where = document.createElement("span");
      where.className = "ds-where";
      where.textContent = page === title ? number && ` chapter ${number}` : ` in ${number ? `${number}. ` : ""}${page}`;
      const matched = new Set(terms);
      const inText = excerpt(text, matched);
      const shown = inText.querySelector("mark") || !code || (text && tokenize(title).some((word) => matched.has(singular(word))));
      item.append(link, where, shown ? inText : excerpt(code, matched));
      list.append(item);
    }
    document.getElementById("search-results").replaceChildren(list);
    document.getElementById("search-count").textContent = results.length
      ? `${results.length === 1 ? "One section" : `${results.length} sections`} for “${query}”${results.length > MOST ? `; the best ${MOST}` : ""}`
      : `Nothing found for “${query}”. Fewer or other words may help.`;
  }

  const query = new URLSearchParams(location.search).get("q")?.trim();
  const input = document.querySelector(".bd-search-container input[name=q]");
  if (query) {
    input.value = query;
    show(query);
  } else input.focus();
})();
