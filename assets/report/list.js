// The cases, as many of them as the filter leaves.

const rowsAtOnce = 60; // what fits on a large screen; the others follow when the browser has time

const whenIdle = window.requestIdleCallback ?? ((work) => setTimeout(work, 1));
const notWhenIdle = window.cancelIdleCallback ?? clearTimeout;

const sorts = [
  { name: "worst", label: "Worst first", less: (a, b) => a.rank - b.rank || (b.distance ?? 0) - (a.distance ?? 0) || a.index - b.index },
  { name: "run", label: "As run", less: (a, b) => a.index - b.index },
  { name: "slowest", label: "Slowest first", less: (a, b) => (b.seconds ?? -1) - (a.seconds ?? -1) || a.index - b.index },
];

/** What is shown of the cases: states (none: all), words, a group and an order. */
class Filter {
  states = new Set();
  text = "";
  group = "";
  sort = sorts[0];

  apply(cases) {
    const words = this.text.toLowerCase().split(/\s+/).filter(Boolean);
    return cases
      .filter((each) => (this.states.size === 0 || this.states.has(each.state)) && (!this.group || each.group === this.group) && words.every((word) => each.words.includes(word)))
      .sort(this.sort.less);
  }
}

function filterControls(filter, report, changed) {
  const counts = new Map();
  for (const each of report.cases) counts.set(each.state, (counts.get(each.state) ?? 0) + 1);
  const chips = report.states.filter(({ name }) => counts.has(name)).map((state) => {
    const chip = button("", () => {
      if (!filter.states.delete(state.name)) filter.states.add(state.name);
      chip.setAttribute("aria-pressed", filter.states.has(state.name));
      changed();
    }, { class: `chip ${state.tone}`, "aria-pressed": "false", "data-state": state.name, title: state.help });
    chip.append(make("span", { class: "dot" }), `${state.label} `, make("b", {}, counts.get(state.name).toLocaleString("en")));
    return chip;
  });
  const groups = [...new Set(report.cases.map((each) => each.group ?? ""))].filter(Boolean);
  const select = (id, label, options, choose) => make("select", { id, "aria-label": label, on: { change: (event) => { choose(event.target.value); changed(); } } },
    options.map(([value, text]) => make("option", { value }, text)));
  return [
    make("input", { type: "search", id: "search", placeholder: "Search names", "aria-label": "Search names", autocomplete: "off", spellcheck: false,
      on: { input: (event) => { filter.text = event.target.value; changed(); } } }),
    make("div", { class: "chips", role: "group", "aria-label": "States" }, chips),
    make("div", { class: "orders" },
      make("span", { id: "count", class: "muted" }),
      groups.length > 1 && select("group", "Group", [["", "All groups"], ...groups.map((name) => [name, name])], (value) => { filter.group = value; }),
      select("sort", "Order", sorts.map(({ name, label }) => [name, label]), (value) => { filter.sort = sorts.find(({ name }) => name === value); })),
  ];
}

/** A small picture that is loaded when it comes near. */
function thumbnail(picture) {
  return make("img", { class: "thumbnail", alt: "", loading: "lazy", decoding: "async", src: urlOf(picture.file), draggable: false,
    on: { error: (event) => event.target.classList.add("broken") } });
}

function stateLabel(state) {
  return make("span", { class: `state ${state.tone}` }, make("span", { class: "dot" }), state.label);
}

const shortName = 60; // letters, which three lines of a row hold for certain
const nameTail = 44;  // and two

/** A name without what its group says, unless it is alone there. Of a long one the end can be seen: that is where names differ. */
function nameInRow(each) {
  const prefix = each.hasNeighbours && each.name.startsWith(`${each.group}/`) ? `${each.group}/` : "";
  const name = each.name.slice(prefix.length);
  const head = name.length > shortName ? name.slice(0, -nameTail) : "";
  return make("span", { class: "name" }, prefix && make("span", { class: "unseen" }, prefix),
    head && make("span", { class: "head" }, head), make("span", { class: "tail" }, breakable(name.slice(head.length))));
}

class CaseList {
  #element;
  #accepted;
  #shown = [];
  #rows = new Map(); // by case
  #pending = 0;
  #current = null;
  #last = null; // that was looked at
  #stop = null; // the link that the tab key leads to

  constructor(element, accepted) {
    this.#element = element;
    this.#accepted = accepted;
  }

  get shown() { return this.#shown; }

  show(cases) {
    this.#shown = cases;
    this.#rows.clear();
    this.#element.replaceChildren();
    this.#element.scrollTop = 0;
    if (cases.length === 0) this.#element.append(make("li", { class: "none muted" }, "No case is like that."));
    this.#append(rowsAtOnce);
    this.#later();
    this.#rove();
  }

  /** The case that is looked at; null: none. The last one stays marked. */
  select(aCase) {
    this.#rows.get(this.#current)?.firstChild.removeAttribute("aria-current");
    const focused = this.#element.contains(document.activeElement);
    this.#current = aCase;
    if (aCase) this.#last = aCase;
    const at = aCase ? this.#shown.indexOf(aCase) : -1;
    if (at >= 0) {
      this.#append(at + rowsAtOnce - this.#rows.size);
      const row = this.#rows.get(aCase);
      row.firstChild.setAttribute("aria-current", "true");
      row.scrollIntoView({ block: "nearest" });
    }
    this.#rove();
    if (focused && at >= 0) this.#stop?.focus({ preventScroll: true });
  }

  /** Puts the list, which has the window to itself, where it was left, with the last case in sight. */
  scrollBack(top) {
    this.#append(this.#shown.length);
    scrollTo(0, top);
    this.#rows.get(this.#last)?.scrollIntoView({ block: "nearest" });
  }

  /** One stop of the tab key, from which arrows lead on: the last case, or the first that is shown. */
  #rove() {
    this.#stop?.parentElement.classList.remove("last");
    if (this.#stop) this.#stop.tabIndex = -1;
    const last = this.#rows.get(this.#last);
    last?.classList.add("last");
    this.#stop = (last ?? this.#rows.get(this.#shown[0]))?.firstChild ?? null;
    if (this.#stop) this.#stop.tabIndex = 0;
  }

  /** The neighbour of what is looked at, or was last: 1 the next one, -1 the one before. */
  neighbour(step) {
    const at = this.#shown.indexOf(this.#current ?? this.#last);
    return at < 0 ? this.#shown[0] : this.#shown[at + step];
  }

  /** Where it is among what is shown, from 1 on; 0: nowhere. */
  placeOf(aCase) { return this.#shown.indexOf(aCase) + 1; }

  markAccepted() {
    for (const [each, row] of this.#rows) this.#markRow(each, row);
  }

  #markRow(each, row) {
    row.querySelector(".accepted").hidden = !(each.acceptable && this.#accepted.has(each.name));
  }

  #append(count) {
    const rows = this.#shown.slice(this.#rows.size, this.#rows.size + Math.max(count, 0)).map((each) => {
      const row = this.#row(each);
      this.#rows.set(each, row);
      return row;
    });
    this.#element.append(...rows);
  }

  #later() {
    notWhenIdle(this.#pending);
    if (this.#rows.size >= this.#shown.length) return;
    this.#pending = whenIdle(() => {
      this.#append(200);
      this.#later();
    }, { timeout: 200 });
  }

  #row(each) {
    const picture = (role) => each.pictures.find((one) => one.role === role);
    const small = [picture("actual") ?? picture("expected"), each.wrong && picture("difference")];
    const row = make("li", { class: "row" }, make("a", { href: each.address, title: each.name, tabIndex: -1, "aria-current": each === this.#current ? "true" : null },
      make("span", { class: "thumbnails" }, small.filter(Boolean).map(thumbnail)),
      make("span", { class: "row-text" },
        nameInRow(each),
        make("span", { class: "row-facts" }, stateLabel(each.look), each.group && make("span", { class: "muted group-name" }, each.group),
          each.seconds !== undefined && each.seconds !== null && make("span", { class: "muted" }, secondsText(each.seconds)),
          make("span", { class: "accepted", hidden: true }, "✓ accepted")))));
    this.#markRow(each, row);
    return row;
  }
}

function secondsText(seconds) {
  return seconds < 0.1 ? `${(seconds * 1000).toFixed(seconds < 0.01 ? 1 : 0)} ms` : `${seconds.toFixed(seconds < 10 ? 2 : 0)} s`;
}
