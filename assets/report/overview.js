// The run as a whole: what is wrong in it, the tables, and what it ran on.

const cardsAtMost = 24;

function overview(report) {
  const wrong = report.cases.filter((each) => each.wrong).sort(sorts[0].less);
  const seconds = report.cases.reduce((sum, each) => sum + (each.seconds ?? 0), 0);
  return make("article", { class: "overview", "aria-labelledby": "overview-title" },
    make("h2", { id: "overview-title", class: `verdict ${report.tone}` }, report.verdict || "Overview"),
    shares(report),
    make("section", { class: "about" }, report.introduction.map((paragraph) => make("p", {}, paragraph))),
    wrong.length > 0 && make("section", {},
      make("h3", {}, "What to look at"),
      make("div", { class: "cards" }, wrong.slice(0, cardsAtMost).map(card)),
      wrong.length > cardsAtMost && make("p", { class: "muted" }, `${(wrong.length - cardsAtMost).toLocaleString("en")} more are in the list.`)),
    report.tables.map((table) => summaryTable(table, report)),
    make("section", {},
      make("h3", {}, "This run"),
      report.madeBy && make("p", {}, `Made by ${report.madeBy}.`),
      report.command && [make("p", { class: "muted" }, "To make it again:"), commandLine(report.command)],
      facts([...report.environment, ["Cases", report.cases.length.toLocaleString("en")], ...(seconds > 0 ? [["Time of all cases", secondsText(seconds)]] : [])])));
}

/** How many cases have which state, as a bar. */
function shares(report) {
  const parts = report.states.map((state) => ({ state, count: report.cases.filter((each) => each.state === state.name).length })).filter(({ count }) => count > 0);
  const words = parts.map(({ state, count }) => `${count.toLocaleString("en")} ${state.label.toLowerCase()}`).join(", ");
  return parts.length > 0 && [
    make("div", { class: "shares", role: "img", "aria-label": words }, parts.map(({ state, count }) =>
      make("span", { class: state.tone, style: `flex: ${count} 0 4px`, title: `${count} ${state.label}` }))),
    // Most runs say the same in their headline.
    !parts.every(({ state, count }) => report.verdict.includes(`${count} ${state.label.toLowerCase()}`)) && make("p", { class: "muted" }, `${words}.`)];
}

function card(each) {
  return make("a", { class: "card", href: each.address },
    make("span", { class: "card-pictures" }, each.pictures.map((picture) => make("span", {}, thumbnail(picture), make("span", { class: "caption muted" }, picture.label)))),
    make("span", { class: "name" }, breakable(each.name)),
    make("span", { class: "row-facts" }, stateLabel(each.look), each.group && make("span", { class: "muted" }, each.group)),
    each.message && make("span", { class: "muted message" }, each.message));
}

function summaryTable(table, report) {
  const side = (i) => (table.columns[i]?.number ? "number" : "");
  const content = (cell) => {
    const target = report.cases[cell.case];
    const text = cell.tone ? make("span", { class: `state ${cell.tone}` }, make("span", { class: "dot" }), cell.text) : cell.text;
    return target ? make("a", { href: target.address }, text) : text;
  };
  return make("section", {},
    make("h3", {}, table.title),
    make("div", { class: "wide", tabIndex: 0, role: "region", "aria-label": table.title }, make("table", {},
      make("thead", {}, make("tr", {}, table.columns.map(({ label }, i) => make("th", { scope: "col", class: side(i) }, label)))),
      make("tbody", {}, table.rows.map((row) => make("tr", {}, row.map((cell, i) => make(i === 0 ? "th" : "td", i === 0 ? { scope: "row", class: side(i) } : { class: side(i) }, content(cell)))))))),
    table.notes.map((note) => make("p", { class: "muted" }, note)));
}

function facts(pairs) {
  return pairs.length > 0 && make("dl", { class: "facts" }, pairs.map(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]));
}
