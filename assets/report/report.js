// The page: which case is looked at, and which key does what.

/** What report-data.js says, with what follows from it. */
function preparedReport(data) {
  const looks = new Map(data.states.map((state, rank) => [state.name, { ...state, rank }]));
  const taken = new Set();
  const members = new Map(); // of each group
  for (const { group } of data.cases) members.set(group, (members.get(group) ?? 0) + 1);
  data.cases.forEach((each, index) => {
    each.index = index;
    each.look = looks.get(each.state);
    each.rank = each.look.rank;
    each.hasNeighbours = Boolean(each.group) && members.get(each.group) > 1;
    each.wrong = each.look.tone === "bad" || each.look.tone === "look";
    each.words = `${each.name} ${each.group ?? ""} ${each.message ?? ""}`.toLowerCase();
    // Its name, by which a link finds it in the next run, too.
    each.id = each.name;
    for (let i = 2; taken.has(each.id); ++i) each.id = `${each.name} (${i})`;
    taken.add(each.id);
    each.address = `#case=${encodeURIComponent(each.id)}`;
  });
  return data;
}

const themes = [["", "Theme: auto"], ["light", "Theme: light"], ["dark", "Theme: dark"]];

function applyTheme(name) {
  document.documentElement.dataset.theme = name;
}

const onlyOneFits = matchMedia("(max-width: 52rem)"); // as the style sheet has it

class ReportPage {
  #report;
  #filter = new Filter();
  #accepted;
  #list;
  #detail;
  #main = document.getElementById("main");
  #keys;
  #listScroll = 0; // of the window, where the list has it to itself

  constructor(report) {
    this.#report = report;
    this.#accepted = new AcceptList(report.key, new Set(report.cases.filter((each) => each.acceptable).map((each) => each.name)));
    this.#accepted.onChange = () => this.#acceptChanged();
    this.#list = new CaseList(document.getElementById("list"), this.#accepted);
    document.getElementById("list").classList.toggle("bare", report.cases.every((each) => each.pictures.length === 0));
    history.scrollRestoration = "manual"; // a phone's list comes back as it was left
    this.#detail = new Detail(this.#list, this.#accepted, (step) => this.#go(step));
    this.#keys = this.#keyRows();
    this.#buildTop();
    document.getElementById("filters").append(...present(filterControls(this.#filter, report, () => this.#filterChanged())));
    this.#filterChanged();
    this.#route();
    addEventListener("hashchange", () => this.#route());
    document.getElementById("skip").addEventListener("click", (event) => {
      event.preventDefault(); // the address is the case's
      if (onlyOneFits.matches && document.body.dataset.show === "list") location.hash = "#overview";
      else this.#main.focus();
    });
    addEventListener("keydown", (event) => this.#onKey(event));
  }

  #buildTop() {
    const { title, verdict, tone } = this.#report;
    document.title = title;
    document.getElementById("title").textContent = title;
    const said = document.getElementById("verdict");
    said.textContent = verdict;
    said.className = tone;
    const theme = button("", () => this.#nextTheme(), { id: "theme" });
    document.getElementById("top-tools").append(
      make("a", { class: "button", id: "to-list", href: "#list" }, "Cases"),
      make("a", { class: "button", id: "to-overview", href: "#overview" }, "Overview"),
      theme,
      button("Keys", () => this.#showHelp(), { id: "keys", title: "Key ?" }));
    this.#nameTheme();
  }

  // Which case.

  #route() {
    const hash = location.hash.slice(1);
    let each = null;
    if (hash.startsWith("case=")) {
      let id = hash.slice(5);
      try { id = decodeURIComponent(id); } catch { /* as it stands */ }
      each = this.#report.cases.find((one) => one.id === id) ?? null;
    }
    // Where there is room for one of them only: the list comes first, and comes back as it was left.
    const before = document.body.dataset.show;
    if (before === "list") this.#listScroll = scrollY;
    document.body.dataset.looked = each ? "case" : "overview";
    document.body.dataset.show = each || hash === "overview" ? "main" : "list";
    const toOverview = document.getElementById("to-overview");
    if (each) toOverview.removeAttribute("aria-current");
    else toOverview.setAttribute("aria-current", "page");
    this.#list.select(each);
    if (each) {
      if (this.#detail.shown !== each) {
        if (!this.#detail.element.isConnected) this.#main.replaceChildren(this.#detail.element);
        this.#detail.show(each);
        this.#main.scrollTop = 0;
        document.title = `${each.name} – ${this.#report.title}`;
      }
    } else if (!this.#main.querySelector(".overview")) {
      this.#detail.hide();
      this.#main.replaceChildren(overview(this.#report));
      document.title = this.#report.title;
    }
    const shows = document.body.dataset.show;
    if (shows === before || !onlyOneFits.matches) return;
    if (shows === "list") this.#list.scrollBack(this.#listScroll);
    else scrollTo(0, 0);
  }

  #go(step) {
    const each = this.#list.neighbour(step);
    if (!each) return;
    // From case to case is no way back: Back leads to where one came from.
    if (this.#detail.shown) location.replace(each.address);
    else location.hash = each.address;
  }

  #filterChanged() {
    const shown = this.#filter.apply(this.#report.cases);
    this.#list.show(shown);
    this.#list.select(this.#detail.shown);
    this.#detail.refresh();
    const count = document.getElementById("count");
    const all = this.#report.cases.length;
    count.textContent = shown.length === all ? countOf(all, "case") : `${shown.length.toLocaleString("en")} of ${countOf(all, "case")}`;
    say(`${countOf(shown.length, "case")} shown`);
    this.#buildTray();
  }

  // What is accepted.

  #acceptChanged() {
    this.#list.markAccepted();
    this.#detail.refresh();
    this.#buildTray();
  }

  #buildTray() {
    const tray = document.getElementById("tray");
    const focused = tray.contains(document.activeElement) ? document.activeElement.id : "";
    tray.hidden = !this.#report.cases.some((each) => each.acceptable);
    tray.replaceChildren(...(tray.hidden ? [] : acceptTray(this.#accepted, this.#report, this.#list.shown)));
    if (focused) document.getElementById(focused)?.focus();
  }

  // Looks.

  #nextTheme() {
    const now = themes.findIndex(([name]) => name === (document.documentElement.dataset.theme ?? ""));
    const [name] = themes[(now + 1) % themes.length];
    kept.set("texplorer-theme", name || null);
    applyTheme(name);
    this.#nameTheme();
  }

  #nameTheme() {
    const [, label] = themes.find(([name]) => name === (document.documentElement.dataset.theme ?? ""));
    document.getElementById("theme").textContent = label;
  }

  // Keys.

  #keyRows() {
    const stage = this.#detail.stage;
    const ofCase = (action) => (key) => this.#detail.shown && action(key);
    return [
      { keys: ["j", "ArrowDown", "ArrowRight"], shown: "j ↓ →", help: "next case", action: () => this.#go(1) },
      { keys: ["k", "ArrowUp", "ArrowLeft"], shown: "k ↑ ←", help: "previous case", action: () => this.#go(-1) },
      ...views.map(({ label }, i) => ({ keys: [`${i + 1}`], shown: `${i + 1}`, help: label.toLowerCase(), action: ofCase(() => stage.setView(i)) })),
      { keys: ["f"], shown: "f", help: "flicker: the other picture", action: ofCase(() => stage.flip()) },
      { keys: ["p"], shown: "p", help: "flicker by itself, or stop", action: ofCase(() => stage.togglePlay()) },
      { keys: ["g"], shown: "g", help: "difference: the next gain", action: ofCase(() => stage.nextGain()) },
      { keys: ["+", "="], shown: "+ or wheel", help: "larger", action: ofCase(() => stage.zoomIn()) },
      { keys: ["-"], shown: "−", help: "smaller", action: ofCase(() => stage.zoomOut()) },
      { keys: ["0"], shown: "0", help: "fit", action: ofCase(() => stage.fit()) },
      { keys: ["z"], shown: "z", help: "one to one", action: ofCase(() => stage.oneToOne()) },
      { keys: ["w"], shown: "w", help: "to the worst pixel", action: ofCase(() => stage.toWorst()) },
      { keys: ["Shift+ArrowLeft", "Shift+ArrowRight", "Shift+ArrowUp", "Shift+ArrowDown"], shown: "Shift and arrows", help: "the pixel beside the marked one",
        action: ofCase((key) => stage.movePin({ ArrowLeft: -1, ArrowRight: 1 }[key] ?? 0, { ArrowUp: -1, ArrowDown: 1 }[key] ?? 0)) },
      { keys: ["a"], shown: "a", help: "accept it, or not", action: ofCase(() => this.#detail.shown.acceptable && this.#accepted.toggle(this.#detail.shown.name)) },
      { keys: ["u"], shown: "u", help: "undo the last acceptance", action: () => this.#accepted.undo() },
      { keys: ["/"], shown: "/", help: "search", action: () => this.#search() },
      { keys: ["o", "Escape"], shown: "o or Esc", help: "overview", action: () => { location.hash = "#overview"; } },
      { keys: ["t"], shown: "t", help: "light, dark or as the system", action: () => this.#nextTheme() },
      { keys: ["?"], shown: "?", help: "these keys", action: () => this.#showHelp() },
    ];
  }

  #onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey || document.getElementById("help").open) return;
    const target = event.target;
    const writes = target.matches("input[type=search], select");
    if (writes) {
      if (event.key === "Escape") target.blur();
      return;
    }
    const arrow = event.key.startsWith("Arrow");
    // What has arrows of its own keeps them; up and down scroll what is read.
    if (arrow && !event.shiftKey && (target.matches("input") || (/Up|Down/.test(event.key) && this.#main.contains(target)))) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key; // Caps Lock is no other key
    const name = event.shiftKey && arrow ? `Shift+${key}` : key;
    const row = this.#keys.find(({ keys }) => keys.includes(name));
    if (!row) return;
    event.preventDefault();
    row.action(key);
  }

  #search() {
    if (document.body.dataset.show === "main" && !document.getElementById("cases").offsetParent) location.hash = "#list";
    document.body.dataset.show = "list";
    document.getElementById("search").focus();
  }

  #showHelp() {
    const help = document.getElementById("help");
    help.replaceChildren(
      make("h2", { id: "help-title" }, "Keys"),
      make("dl", {}, this.#keys.map(({ shown, help: text }) => [make("dt", {}, make("kbd", {}, shown)), make("dd", {}, text)])),
      make("form", { method: "dialog" }, make("button", {}, "Close")));
    help.showModal();
  }
}

applyTheme(kept.get("texplorer-theme") ?? "");
if (typeof texplorerReport === "undefined") document.getElementById("main").append(make("p", { class: "without" }, "report-data.js is not beside this page, or is damaged."));
else {
  new ReportPage(preparedReport(texplorerReport));
  // For who measures how long it takes.
  requestAnimationFrame(() => setTimeout(() => performance.mark("texplorer-shown")));
}
