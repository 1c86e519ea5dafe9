"use strict";
(() => {
  // All texts come from submissions: they are set as text, never parsed as HTML.
  const ROWS_AT_ONCE = 120;
  const ASK_EVERY = 3000;
  const SIGNS = {
    "passed": ["✓", "passed"],
    "not passed": ["✗", "failed"],
    "not handed in": ["–", "none"],
    "not applicable": ["·", "none"],
    "not available here": ["!", "open"],
    "our error": ["!", "open"],
    "excused": ["·", "none"],
    "marked by hand": ["✎", "none"],
  };
  const OUTCOMES = {
    "passed": ["✓", "passed"],
    "failed": ["✗", "failed"],
    "skipped": ["–", "none"],
    "not applicable": ["·", "none"],
    "error": ["!", "open"],
  };
  const byId = (id) => document.getElementById(id);
  const mode = document.body.dataset.mode;
  const title = document.title;
  let data = JSON.parse(byId("data").textContent);
  document.documentElement.classList.add("on");

  function make(tag, properties, ...children) {
    const element = document.createElement(tag);
    for (const [name, value] of Object.entries(properties || {})) {
      if (name in element) element[name] = value;
      else element.setAttribute(name, value);
    }
    element.append(...children);
    return element;
  }

  // Text in `backquotes` is code.
  function prose(text) {
    const parts = text.split("`");
    if (parts.length % 2 === 0) return [text];
    return parts.map((part, at) => (at % 2 ? make("code", {}, part) : part));
  }

  const points = (value) => (value === null ? "" : String(value));
  const collator = new Intl.Collator(undefined, { numeric: true, sensitivity: "base" });

  // ------------------------------------------------------------------------------------- one submission

  const cache = new Map();

  async function unpacked(place) {
    const packed = atob(byId(`s${place}`).textContent);
    const bytes = Uint8Array.from(packed, (char) => char.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return JSON.parse(await new Response(stream).text());
  }

  async function fetched(place) {
    const answer = await fetch(`submission/${place}.json`, { cache: "no-store" });
    if (!answer.ok) throw new Error(`the server answered ${answer.status}`);
    return answer.json();
  }

  async function submission(place) {
    if (!cache.has(place)) cache.set(place, await (mode === "live" ? fetched : unpacked)(place));
    return cache.get(place);
  }

  function feedback(told, name) {
    const box = make("div", { className: name }, make("p", {}, ...prose(told.summary)));
    if (told.parts.length) {
      const list = make("dl");
      for (const [label, text] of told.parts) {
        const shown = label === "in" ? [make("code", {}, text)] : prose(text);
        list.append(make("dt", {}, label), make("dd", {}, ...shown));
      }
      box.append(list);
    }
    if (told.details.length) {
      box.append(make("pre", { tabIndex: 0, role: "group", "aria-label": "Lines of evidence" }, told.details.join("\n")));
    }
    return box;
  }

  function check(one) {
    const [sign, kind] = OUTCOMES[one.outcome];
    const item = make(
      "li", {},
      make("span", { className: `mark ${kind}`, "aria-hidden": "true" }, sign),
      make("span", {}, make("span", { className: "vh" }, `${one.outcome}: `), ...prose(one.title)),
      make("span", { className: "n quiet" }, one.points),
    );
    if (one.why) item.append(feedback(one.why, "why"));
    return item;
  }

  function picture(source) {
    const drawn = new DOMParser().parseFromString(source, "image/svg+xml").documentElement;
    if (drawn.nodeName !== "svg") return "";
    const words = drawn.querySelector("desc").textContent;
    const figure = make("figure", {}, document.importNode(drawn, true));
    figure.append(
      make("figcaption", {}, drawn.querySelector("title").textContent),
      make("details", {}, make("summary", {}, "The same in words"), make("p", {}, words)),
    );
    return figure;
  }

  function code({ path, lines, found }) {
    const list = make("ol", { className: "code" });
    lines.forEach((text, at) => {
      const line = make("li", {}, make("code", {}, text || " "));
      found.filter((each) => each[0] === at + 1).forEach((each) => line.append(make("p", { className: "found" }, ...prose(each[1]))));
      list.append(line);
    });
    const room = make("div", { className: "scroll", role: "region", "aria-label": `Code: ${path}`, tabIndex: 0 }, list);
    const told = found.length ? `: ${found.length} found` : "";
    return make("details", { open: found.length > 0 }, make("summary", {}, make("code", { className: "what" }, path), told), room);
  }

  function exercise(one, at) {
    const [sign, kind] = SIGNS[one.verdict];
    const part = make("section", { "aria-labelledby": `e${at}` });
    part.append(
      make("h3", { id: `e${at}`, tabIndex: -1 }, `${one.id}: ${one.title}${one.bonus ? " (bonus)" : ""}`),
      make(
        "p", { className: "headline" },
        make("span", { className: `mark ${kind}`, "aria-hidden": "true" }, sign),
        ` ${one.headline}${one.total ? `, ${one.total}` : ""}`,
        make("span", { className: "quiet" }, one.seconds ? `  (${one.seconds} s)` : ""),
      ),
    );
    if (one.before) part.append(make("p", { className: "quiet" }, `Before: ${one.before}`));
    part.append(...one.byHand.map((text) => make("p", { className: "by-hand" }, ...prose(text))));
    if (one.fault) part.append(feedback(one.fault, "fault"));
    if (one.checks.length) part.append(make("ul", { className: "checks" }, ...one.checks.map(check)));
    part.append(...one.notes.map((note) => make("p", { className: "quiet" }, ...prose(note))));
    part.append(...one.code.map(code), ...one.pictures.map(picture));
    return part;
  }

  function steps(place) {
    const to = (at, words) => make("a", { href: `#submission-${at}` }, words);
    const nav = make("nav", { className: "steps", "aria-label": "Submissions" }, make("a", { href: "#people" }, "Back to everyone"));
    if (place > 0) nav.append(to(place - 1, "Previous"));
    if (place + 1 < data.people.length) nav.append(to(place + 1, "Next"));
    return nav;
  }

  function index(marks, place) {
    const to = (at) => (mode === "learner" ? `#e${at}` : `#submission-${place}-${at}`);
    const entry = (one, at) => {
      const [sign, kind] = SIGNS[one.verdict];
      const shown = make("span", { className: `mark ${kind}`, "aria-hidden": "true" }, sign);
      const words = make("span", { className: "vh" }, ` ${one.verdict}`);
      return make("li", {}, shown, make("a", { href: to(at) }, one.id), words);
    };
    return make("ul", { className: "index" }, ...marks.map(entry));
  }

  function article(told, place) {
    const box = byId("submission");
    const about = told.source ? `${told.id}, handed in as ${told.source}` : told.id;
    const head = make("h2", { id: "submission-name", tabIndex: -1 }, told.name);
    box.replaceChildren(...(mode === "learner" ? [] : [steps(place)]), head);
    box.append(
      make("p", { className: "quiet" }, about, ...(mode === "learner" ? [] : [" (", make("a", { href: `#person-${encodeURIComponent(told.id)}` }, "permanent link"), ")"])),
      make("p", { className: "headline" }, `${told.summary}.`),
      ...told.says.map((text) => make("p", {}, ...prose(text))),
      ...(told.marks.length > 1 ? [index(told.marks, place)] : []),
      ...told.marks.map(exercise),
    );
    return head;
  }

  async function open(place, focus, at) {
    let head;
    try {
      head = article(await submission(place), place);
    } catch (error) {
      head = make("h2", { id: "submission-name", tabIndex: -1 }, "This submission cannot be shown");
      byId("submission").replaceChildren(steps(place), head, make("p", {}, String(error.message)));
    }
    byId("submission").hidden = false;
    if (mode === "learner") return;
    byId("class").hidden = true;
    byId("parts").hidden = true;
    document.title = `${data.people[place] ? data.people[place].name : ""} - ${title}`;
    if (focus) {
      (byId(`e${at}`) || head).focus({ preventScroll: true });
      if (byId(`e${at}`)) byId(`e${at}`).scrollIntoView();
      else window.scrollTo({ top: 0, behavior: "instant" });
    }
  }

  function close(from) {
    byId("submission").hidden = true;
    byId("class").hidden = false;
    byId("parts").hidden = false;
    document.title = title;
    const link = from === null ? null : document.querySelector(`#marks a[href="#submission-${from}"]`);
    if (link) link.focus();
  }

  let shown = null;

  // `#person-ada` leads to ada on every page of the class, wherever she is in the list.
  function placeOf(hash) {
    const named = /^#person-(.+)$/.exec(hash);
    if (!named) return null;
    const place = data.people.findIndex((one) => encodeURIComponent(one.id) === named[1] || one.id === named[1]);
    return place < 0 ? null : place;
  }

  function route() {
    const found = /^#submission-(\d+)(?:-(\d+))?$/.exec(location.hash) || [];
    const place = found[1] ? Number(found[1]) : placeOf(location.hash);
    if (place !== null && place < data.people.length) {
      open(place, true, found[2]);
    } else if (shown !== null) {
      close(shown);
    }
    shown = place;
  }

  // ------------------------------------------------------------------------------------------ the table

  const sorted = { by: null, down: false };
  let only = null;
  let drawing = 0;

  const columns = () => [
    { head: "Name", of: (one) => one.name },
    { head: "Id", of: (one) => one.id },
    ...data.exercises.map((each, at) => ({ head: each.id, title: each.title, of: (one) => one.marks[at][1] })),
    { head: "Total", of: (one) => one.points },
    ...(data.compared ? [{ head: "Before", title: "Points of the earlier run", of: (one) => one.before }] : []),
    ...(data.dated ? [{ head: "Late", title: "After the deadline", of: (one) => one.lateness }] : []),
    { head: "Time", of: (one) => one.seconds },
    ...(data.remarked ? [{ head: "Remarks", of: (one) => one.said }] : []),
  ];

  function heads() {
    const row = make("tr");
    columns().forEach((column, at) => {
      const button = make("button", { type: "button" }, column.head);
      if (column.title) button.title = column.title;
      button.addEventListener("click", () => sort(at));
      row.append(make("th", { scope: "col", "aria-sort": "none" }, button));
    });
    document.querySelector("#marks thead").replaceChildren(row);
  }

  // First in one direction, then in the other, then in the order of the class.
  function sort(at) {
    if (sorted.by !== at) Object.assign(sorted, { by: at, down: at > 1 });
    else if (sorted.down === at > 1) sorted.down = !sorted.down;
    else sorted.by = null;
    draw();
  }

  function compare(one, other) {
    const missing = (value) => value === null;
    const [first, second] = [one.value, other.value];
    if (missing(first) || missing(second)) return missing(first) - missing(second) || one.place - other.place;
    const order = typeof first === "string" ? collator.compare(first, second) : first - second;
    return (sorted.down ? -order : order) || one.place - other.place;
  }

  function matches(one, place) {
    const wanted = byId("find").value.trim().toLocaleLowerCase();
    const [at, verdict] = [byId("of").value, byId("ended").value];
    if (only && !only.people.has(place)) return false;
    if (wanted && !`${one.name}\n${one.id}`.toLocaleLowerCase().includes(wanted)) return false;
    const marks = at === "" ? one.marks : [one.marks[Number(at)]];
    return verdict === "" ? at === "" || marks[0][0] !== "not handed in" : marks.some((mark) => mark[0] === verdict);
  }

  function cell(mark) {
    const [sign, kind] = SIGNS[mark[0]];
    const words = make("span", { className: "vh" }, ` ${mark[0]}`);
    return make("td", {}, make("span", { className: `mark ${kind}`, "aria-hidden": "true" }, sign), points(mark[1]), words);
  }

  function row({ one, place }) {
    const name = make("a", { href: `#submission-${place}` }, one.name);
    const before = one.raw === one.points ? "" : `${one.raw} → `;
    const total = one.points === null ? "–" : `${before}${one.points} of ${one.max}`;
    return make(
      "tr", {},
      make("th", { scope: "row" }, name),
      make("td", { className: "id" }, one.id === one.name ? "" : one.id),
      ...one.marks.map(cell),
      make("td", { className: "n" }, total),
      ...(data.compared ? [make("td", { className: "n" }, points(one.before))] : []),
      ...(data.dated ? [make("td", {}, one.late)] : []),
      make("td", { className: "n" }, `${one.seconds} s`),
      ...(data.remarked ? [make("td", { className: "said" }, ...prose(one.said))] : []),
    );
  }

  function chosen() {
    const key = sorted.by === null ? () => null : columns()[sorted.by].of;
    const found = data.people.map((one, place) => ({ one, place, value: key(one) }));
    const kept = found.filter(({ one, place }) => matches(one, place));
    return sorted.by === null ? kept : kept.sort(compare);
  }

  // The first rows at once, the others when there is time, so that a large class appears at once, too.
  function draw() {
    const rows = chosen();
    const body = document.querySelector("#marks tbody");
    const turn = ++drawing;
    document.querySelectorAll("#marks thead th").forEach((head, at) => {
      head.setAttribute("aria-sort", sorted.by === at ? (sorted.down ? "descending" : "ascending") : "none");
    });
    const why = only ? `, of those with "${only.why}"` : "";
    byId("shown").textContent = `${rows.length} of ${data.people.length} shown${why}.`;
    body.replaceChildren(...rows.splice(0, ROWS_AT_ONCE).map(row));
    const more = () => {
      if (turn !== drawing || !rows.length) return;
      body.append(...rows.splice(0, ROWS_AT_ONCE).map(row));
      setTimeout(more);
    };
    setTimeout(more);
    finish = () => body.append(...rows.splice(0).map(row));
  }

  let finish = () => {};

  function choices() {
    const verdicts = [...new Set(data.people.flatMap((one) => one.marks.map((mark) => mark[0])))];
    const fill = (id, found) => {
      const select = byId(id);
      const before = select.value;
      select.replaceChildren(select.options[0], ...found.map(([value, text]) => make("option", { value }, text)));
      select.value = before;
      if (select.selectedIndex < 0) select.value = "";
    };
    fill("of", data.exercises.map((one, at) => [String(at), one.id]));
    fill("ended", verdicts.map((verdict) => [verdict, verdict]));
  }

  function showThose(event) {
    const button = event.target.closest("button.those");
    if (!button) return;
    byId("filter").reset();
    only = { people: new Set(button.dataset.people.split(",").map(Number)), why: button.dataset.why };
    draw();
    byId("people").scrollIntoView();
    byId("find").focus({ preventScroll: true });
  }

  // ---------------------------------------------------------------------------------------------- live

  let tag = "";

  function renew(news) {
    const opened = [...document.querySelectorAll("#overview details[open]")].map((each) => each.id);
    data = news.data;
    cache.clear();
    heads();
    choices();
    draw();
    // Our own templates made this, and they escape every text. The page's policy lets nothing in it run.
    for (const [id, source] of Object.entries(news.parts)) {
      byId(id).replaceChildren(...new DOMParser().parseFromString(source, "text/html").body.childNodes);
    }
    opened.map(byId).forEach((each) => each && (each.open = true));
    if (shown !== null && !byId("submission").hidden) open(shown, false);
  }

  async function ask() {
    try {
      const answer = await fetch("data.json", { headers: tag ? { "If-None-Match": tag } : {}, cache: "no-store" });
      if (answer.status === 200) {
        tag = answer.headers.get("ETag");
        renew(await answer.json());
        byId("live").textContent = `live, as of ${new Date().toLocaleTimeString()}.`;
      } else if (answer.status !== 304) {
        byId("live").textContent = "the results cannot be read right now.";
      }
    } catch {
      byId("live").textContent = "its server no longer answers; this is its last state.";
    }
    setTimeout(ask, ASK_EVERY);
  }

  // ------------------------------------------------------------------------------------------- beginning

  if (mode === "learner") {
    open(0, false);
  } else {
    heads();
    choices();
    draw();
    byId("filter").addEventListener("input", draw);
    byId("filter").addEventListener("submit", (event) => event.preventDefault());
    byId("filter").addEventListener("reset", () => {
      only = null;
      setTimeout(draw);
    });
    byId("overview").addEventListener("click", showThose);
    window.addEventListener("hashchange", route);
    window.addEventListener("beforeprint", () => finish());
    route();
    if (mode === "live") setTimeout(ask, ASK_EVERY);
  }
  document.documentElement.dataset.ready = "yes";
})();
