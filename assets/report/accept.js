// Which cases are accepted: a list of names for `texshot test --accept`, that the browser keeps until it is written.

class AcceptList {
  #key;
  #names = new Set();
  #before = []; // what undo returns to
  onChange = () => {};

  constructor(key, possible) {
    this.#key = `texplorer-accept:${location.pathname}:${key}`;
    try {
      const names = JSON.parse(kept.get(this.#key) ?? "[]");
      this.#names = new Set(names.filter((name) => possible.has(name)));
    } catch { /* it is none of ours */ }
  }

  has(name) { return this.#names.has(name); }
  get size() { return this.#names.size; }
  get canUndo() { return this.#before.length > 0; }

  toggle(name) {
    const names = new Set(this.#names);
    if (!names.delete(name)) names.add(name);
    this.#become(names);
  }

  addAll(names) { this.#become(new Set([...this.#names, ...names])); }
  clear() { this.#become(new Set()); }

  undo() {
    if (this.canUndo) this.#set(this.#before.pop());
  }

  /** A name a line, in the order of the run. */
  text(cases) {
    return cases.filter((each) => each.acceptable && this.has(each.name)).map((each) => `${each.name}\n`).join("");
  }

  #become(names) {
    this.#before.push(this.#names);
    this.#set(names);
  }

  #set(names) {
    this.#names = names;
    kept.set(this.#key, names.size ? JSON.stringify([...names]) : null);
    say(`${countOf(names.size, "case")} accepted`);
    this.onChange();
  }
}

/** Below the list: what is accepted so far, and what to do with it. */
function acceptTray(accepted, report, shownCases) {
  const open = shownCases.filter((each) => each.acceptable && !accepted.has(each.name));
  const download = () => {
    const address = URL.createObjectURL(new Blob([accepted.text(report.cases)], { type: "text/plain" }));
    make("a", { href: address, download: "accept.txt" }).click();
    setTimeout(() => URL.revokeObjectURL(address), 10000);
  };
  const some = accepted.size > 0;
  return present([
    make("div", { class: "tray-line" },
      some && make("b", {}, `${accepted.size.toLocaleString("en")} accepted`),
      button(`Accept all shown (${open.length.toLocaleString("en")})`, () => accepted.addAll(open.map((each) => each.name)),
        { disabled: open.length === 0, id: "accept-all" }),
      button("Undo", () => accepted.undo(), { disabled: !accepted.canUndo, title: "Key u", id: "undo" }),
      some && button("Clear", () => accepted.clear(), { id: "clear" })),
    some && make("div", { class: "tray-line" },
      button("Download accept.txt", download, { class: "strong", id: "download" }),
      copyButton("Copy the list", () => accepted.text(report.cases), { id: "copy" })),
    some && make("p", { class: "muted" }, "The browser puts it into its downloads folder. Move it to where the run was made, then:"),
    some && commandLine(report.acceptCommand),
  ]);
}
