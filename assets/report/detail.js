// One case: its pictures first, then what is said of it.

class Detail {
  #stage = new Stage();
  #list;
  #accepted;
  #go;
  #case = null;
  element = make("article", { class: "detail", "aria-labelledby": "case-name" });

  constructor(list, accepted, go) {
    this.#list = list;
    this.#accepted = accepted;
    this.#go = go;
  }

  get stage() { return this.#stage; }
  get shown() { return this.#case; }

  show(each) {
    this.#case = each;
    const rows = [...(each.facts ?? [])];
    if (each.worst && !rows.some(([name]) => /worst pixel/i.test(name))) rows.push(["Worst pixel", `${each.worst[0]}, ${each.worst[1]}`]);
    if (each.size) rows.push(["Size", `${each.size[0]} × ${each.size[1]}`]);
    if (each.seconds !== undefined && each.seconds !== null) rows.push(["Time", secondsText(each.seconds)]);
    this.element.replaceChildren(...present([
      make("header", { class: "detail-top" },
        make("div", { class: "detail-name" },
          make("h2", { id: "case-name" }, breakable(each.name)),
          make("p", { class: "row-facts" }, stateLabel(each.look), each.group && make("span", { class: "muted" }, each.group)),
          each.message && make("p", { class: "message" }, each.message)),
        make("div", { class: "detail-tools" }, this.#accept(), this.#steps())),
      this.#stage.element,
      each.pictures.length === 0 && make("p", { class: "muted" }, "This case has no pictures."),
      make("div", { class: "said-of-it" },
        make("section", {}, rows.length > 0 && make("h3", {}, "Facts"), facts(rows), this.#links(each)),
        each.explanation && make("section", {}, make("h3", {}, "Explanation"), make("pre", { tabIndex: 0 }, each.explanation)),
        each.commands && make("section", { class: "commands" }, each.commands.map(({ label, line }) => [make("h3", {}, label), commandLine(line)]))),
    ]));
    this.#stage.show(each);
  }

  hide() {
    this.#case = null;
    this.#stage.hide();
  }

  /** After the list has changed, or what is accepted. */
  refresh() {
    if (!this.#case) return;
    const focused = this.element.contains(document.activeElement) ? document.activeElement.id : "";
    this.element.querySelector(".detail-tools").replaceChildren(...present([this.#accept(), this.#steps()]));
    if (focused) document.getElementById(focused)?.focus();
  }

  #accept() {
    if (!this.#case.acceptable) return null;
    const accepted = this.#accepted.has(this.#case.name);
    return button(accepted ? "✓ Accepted" : "Accept", () => this.#accepted.toggle(this.#case.name),
      { id: "accept", class: accepted ? "strong" : "", "aria-pressed": accepted, title: "Key a" });
  }

  #steps() {
    const place = this.#list.placeOf(this.#case);
    const count = this.#list.shown.length;
    return make("div", { class: "steps" },
      button("‹", () => this.#go(-1), { id: "previous", "aria-label": "Previous case", title: "Key k", disabled: place <= 1 }),
      make("span", { class: "muted" }, place > 0 ? `${place.toLocaleString("en")} of ${count.toLocaleString("en")}` : "not in the list"),
      button("›", () => this.#go(1), { id: "next", "aria-label": "Next case", title: "Key j", disabled: place === count || count === 0 }));
  }

  #links(each) {
    return each.links && make("p", { class: "links" }, each.links.map(({ label, file }) => make("a", { href: urlOf(file) }, label)));
  }
}
