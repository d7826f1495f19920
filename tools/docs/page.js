"use strict";
(() => {
  const root = document.documentElement, get = id => document.getElementById(id);
  const words = get("words"), found = get("found"), contents = get("contents");
  const articles = [...document.querySelectorAll("main > article")];
  root.classList.add("js");

  // ---- light and dark: the system's, until the button says otherwise ----

  const keep = theme => { try { localStorage.setItem("theme", theme); } catch { /* a file may keep nothing */ } };
  const system = () => matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  try { root.dataset.theme = localStorage.getItem("theme") || ""; } catch { /* as the system has it */ }
  get("theme").onclick = () => {
    const other = (root.dataset.theme || system()) === "dark" ? "light" : "dark";
    keep(root.dataset.theme = other === system() ? "" : other);
  };

  // ---- one page at a time; its sections stand open in the contents ----

  let page = null, heads = [];

  function show(article) {
    if (page === article) return;
    page = article;
    for (const a of articles) a.classList.toggle("now", a === article);
    for (const li of contents.querySelectorAll("li[data-page]"))
      li.classList.toggle("open", li.dataset.page === article.id);
    heads = [...article.querySelectorAll("h2[id], h3[id]")];
    document.title = article.id === "readme" ? "Curtain" : article.dataset.name + " - Curtain";
  }
  const entry = id => contents.querySelector('a[href="#' + CSS.escape(id) + '"]');

  // The section at the top of the window is marked in the contents.
  function mark() {
    const at = heads.filter(h => h.getBoundingClientRect().top < 120).pop();
    const now = entry((at || page).id), old = contents.querySelector("a.now");
    if (!now || now === old) return;
    if (old) old.classList.remove("now");
    now.classList.add("now");
    for (const li of contents.querySelectorAll("li[data-page] li.open")) li.classList.remove("open");
    for (let li = now.closest("li"); li && !li.dataset.page; li = li.parentElement.closest("li"))
      li.classList.add("open");
    const box = contents.getBoundingClientRect(), a = now.getBoundingClientRect();
    if (a.top < box.top + 40 || a.bottom > box.bottom - 40)
      contents.scrollTop += a.top - box.top - box.height / 3;
  }
  let asked = false;
  addEventListener("scroll", () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => { asked = false; mark(); });
  }, { passive: true });

  // #page, #page/section, or #?words: a search
  function go() {
    const id = decodeURIComponent(location.hash.slice(1));
    menu(false);
    if (id.startsWith("?")) {
      show(page || articles[0]);
      words.value = id.slice(1);
      words.focus();
      search();
      return;
    }
    const target = get(id) || articles[0];
    show(target.closest("article"));
    close();
    if (target === page) scrollTo(0, 0);
    else target.scrollIntoView();
    mark();
    paint(target);
  }
  addEventListener("hashchange", go);

  // ---- narrow windows: contents over the page ----

  function menu(open) {
    document.body.classList.toggle("menu", open);
    get("menu").setAttribute("aria-expanded", open);
  }
  get("menu").onclick = () => menu(!document.body.classList.contains("menu"));
  get("shade").onclick = () => menu(false);
  contents.onclick = e => { if (e.target.closest("a")) menu(false); };

  // ---- search: sections that have all words ----

  let index = null;

  // A section is a heading and what stands up to the next one.
  function build() {
    index = [];
    for (const article of articles) {
      let path = [], section = null;
      const begin = h => {
        const level = h ? +h.tagName[1] : 1, title = h ? text(h) : article.dataset.name;
        path = path.slice(0, level - 1);
        path[level - 1] = title;
        section = { article, id: h && level > 1 ? h.id : article.id, title, body: [], level,
                    path: [article.dataset.name, ...path.slice(1, -1)].filter(Boolean) };
        index.push(section);
      };
      for (const child of article.children) {
        if (/^H[1-6]$/.test(child.tagName)) begin(child);
        else { if (!section) begin(null); section.body.push(child.textContent); }
      }
    }
    for (const s of index) {
      s.body = s.body.join(" ").replace(/\s+/g, " ").trim();
      s.low = s.body.toLowerCase();
      s.head = s.title.toLowerCase();
    }
  }
  const text = h => [...h.childNodes].filter(n => !(n.classList && n.classList.contains("here")))
    .map(n => n.textContent).join("").trim();

  // Of a plural the singular is looked for, which is in both.
  const asks = value => value.toLowerCase().split(/\s+/).filter(Boolean)
    .map(w => w.length > 3 && /[^s]s$/.test(w) ? w.slice(0, -1) : w);

  function count(low, word) {
    let n = 0;
    for (let at = low.indexOf(word); at >= 0 && n < 5; at = low.indexOf(word, at + word.length)) n++;
    return n;
  }

  // Pages for authors rank above pages on the engine's internals and its measurements.
  const weight = { tutorial: 6, guide: 6, reference: 5, readme: 4, cookbook: 3 };

  function score(s, wanted) {
    let sum = weight[s.article.id.split('-')[0]] || 0;
    for (const word of wanted) {
      const inHead = s.head.includes(word), n = count(s.low, word);
      if (!inHead && !n && !s.path.some(p => p.toLowerCase().includes(word))) return 0;
      sum += n + (inHead ? 20 : 0) + (s.head.split(/[^\w.:]+/).includes(word) ? 10 : 0);
    }
    const all = wanted.join(" ");
    if (s.head === all || s.head.replace(/^\d+\. /, "") === all) sum += 60;
    else if (wanted.length > 1 && s.low.includes(all)) sum += 15;
    return sum + (s.level === 1 ? 2 : 0);
  }

  // Where most of the words stand near each other.
  function densest(low, wanted) {
    let best = 0, most = 0;
    for (const word of wanted) {
      for (let at = low.indexOf(word), n = 0; at >= 0 && n < 50; at = low.indexOf(word, at + word.length), n++) {
        const near = low.slice(at, at + 110), has = wanted.filter(w => near.includes(w)).length;
        if (has > most || (has === most && at < best)) [best, most] = [at, has];
      }
    }
    return best;
  }

  function excerpt(s, wanted) {
    const at = wanted.every(w => s.head.includes(w)) ? 0 : densest(s.low, wanted);
    let from = Math.max(0, at - 50);
    if (from) from = s.body.indexOf(" ", from) + 1;
    return (from ? "… " : "") + s.body.slice(from, from + 170) + (from + 170 < s.body.length ? " …" : "");
  }

  // The words, marked, as children of an element.
  function put(element, string, wanted) {
    const low = string.toLowerCase();
    for (let at = 0; at < string.length;) {
      const next = wanted.map(w => [low.indexOf(w, at), w.length]).filter(([i]) => i >= 0)
        .sort((a, b) => a[0] - b[0])[0];
      element.append(string.slice(at, next ? next[0] : undefined));
      if (!next) break;
      const m = document.createElement("mark");
      m.textContent = string.slice(next[0], next[0] + next[1]);
      element.append(m);
      at = next[0] + next[1];
    }
    return element;
  }

  function line(s, wanted) {
    const a = document.createElement("a"), b = document.createElement("b"), where = document.createElement("span");
    a.href = "#" + s.id;
    a.setAttribute("role", "option");
    put(b, s.title, wanted);
    if (s.level > 1) {
      where.textContent = "  " + s.path.join(" › ");
      b.append(where);
    }
    a.append(b);
    if (s.body) a.append(put(document.createElement("small"), excerpt(s, wanted), wanted));
    return a;
  }

  function search() {
    if (!index) build();
    const wanted = asks(words.value);
    found.textContent = "";
    if (!wanted.length) return close();
    const hits = index.map(s => [score(s, wanted), s]).filter(([n]) => n > 0).sort((a, b) => b[0] - a[0]);
    for (const [, s] of hits.slice(0, 40)) found.append(line(s, wanted));
    if (hits.length > 40 || !hits.length) {
      const p = document.createElement("p");
      p.textContent = hits.length ? "and " + (hits.length - 40) + " more; another word makes them fewer"
        : "No section has " + (wanted.length > 1 ? "all of these words." : "this word.");
      found.append(p);
    }
    choose(0);
    found.hidden = false;
    found.scrollTop = 0;
    words.setAttribute("aria-expanded", "true");
  }

  let chosen = 0;
  function choose(n) {
    const all = found.querySelectorAll("a");
    if (!all.length) return;
    chosen = Math.max(0, Math.min(n, all.length - 1));
    all.forEach((a, i) => a.setAttribute("aria-selected", i === chosen));
    all[chosen].scrollIntoView({ block: "nearest" });
  }
  function close() {
    found.hidden = true;
    words.setAttribute("aria-expanded", "false");
  }

  // What was looked for is marked in the section that was opened.
  let looked = [];
  function paint(target) {
    if (!CSS.highlights) return;
    CSS.highlights.delete("found");
    if (!looked.length) return;
    const ranges = [], head = /^H[1-6]$/.test(target.tagName);
    const parts = head ? [target] : [...target.children];
    for (let e = head && target.nextElementSibling; e && !/^H[1-6]$/.test(e.tagName); e = e.nextElementSibling)
      parts.push(e);
    for (const part of parts) {
      const walk = document.createTreeWalker(part, NodeFilter.SHOW_TEXT);
      for (let node = walk.nextNode(); node; node = walk.nextNode()) {
        const low = node.data.toLowerCase();
        for (const w of looked) {
          for (let at = low.indexOf(w); at >= 0; at = low.indexOf(w, at + w.length)) {
            const range = new Range();
            range.setStart(node, at);
            range.setEnd(node, at + w.length);
            ranges.push(range);
          }
        }
      }
    }
    CSS.highlights.set("found", new Highlight(...ranges));
    looked = [];
  }

  words.oninput = search;
  words.onfocus = () => { menu(false); if (words.value) search(); };
  words.onkeydown = e => {
    if (e.key === "ArrowDown") choose(chosen + 1);
    else if (e.key === "ArrowUp") choose(chosen - 1);
    else if (e.key === "Escape") { close(); words.blur(); }
    else if (e.key === "Enter") { const a = found.querySelectorAll("a")[chosen]; if (a && !found.hidden) a.click(); }
    else return;
    e.preventDefault();
  };
  found.onclick = e => {
    const a = e.target.closest("a");
    if (!a) return;
    looked = asks(words.value);
    words.blur();
    close();
    if (a.getAttribute("href") === location.hash) go();
  };
  document.addEventListener("click", e => { if (!e.target.closest("#search")) close(); });
  document.addEventListener("keydown", e => {
    if (e.key === "/" && document.activeElement !== words && !e.ctrlKey && !e.altKey && !e.metaKey) {
      e.preventDefault();
      words.focus();
      words.select();
    } else if (e.key === "Escape") menu(false);
  });

  // ---- code can be copied ----

  document.querySelector("main").addEventListener("mouseover", e => {
    const figure = e.target.closest("figure.code");
    if (!figure || figure.lastChild.className === "copy" || !navigator.clipboard) return;
    const b = document.createElement("button");
    b.className = "copy";
    b.type = "button";
    b.textContent = "Copy";
    b.onclick = () => navigator.clipboard.writeText(figure.querySelector("code").textContent)
      .then(() => { b.textContent = "Copied"; }, () => { b.textContent = "Not allowed"; });
    figure.append(b);
  });

  go();
})();
