"use strict";
// Elements and what they lead to. Texts of the report only ever become text nodes and properties: no markup is parsed.

/** An element with properties or attributes, listeners (`on`) and children. */
function make(tag, settings = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(settings)) {
    if (value === undefined || value === null) continue;
    if (name === "on") for (const [event, listener] of Object.entries(value)) element.addEventListener(event, listener);
    else if (name in element) element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...present(children));
  return element;
}

/** What there is of children: conditions leave null, undefined or false where there is none. */
function present(children) {
  return children.flat(Infinity).filter((child) => child !== null && child !== undefined && child !== false);
}

/** A name that may go on in the next line after what divides it. */
function breakable(name) {
  return name.split(/(?<=[/_.,:=-])(?=[^/_.,:=-])/).flatMap((part, i) => (i > 0 ? [make("wbr"), part] : [part]));
}

function button(text, action, settings = {}) {
  return make("button", { type: "button", on: { click: action }, ...settings }, text);
}

/** Where a file of the folder is. Each part is escaped: a "#" or "?" of its name is none of the address's. */
function urlOf(file) {
  return file.split("/").map(encodeURIComponent).join("/");
}

/** A number of things, "1 case", "2,000 cases". */
function countOf(count, thing) {
  return `${count.toLocaleString("en")} ${thing}${count === 1 ? "" : "s"}`;
}

/** Says it to who cannot see that something has changed. */
function say(text) {
  document.getElementById("said").textContent = text;
}

async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
  } catch { // no permission, or a browser to which a file is no secure place
    const area = make("textarea", { value: text, class: "unseen" });
    document.body.append(area);
    area.select();
    document.execCommand("copy");
    area.remove();
  }
}

/** Copies what `text()` gives, and shows that it has. */
function copyButton(label, text, settings = {}) {
  const copy = button(label, async () => {
    await copyText(text());
    copy.textContent = "Copied";
    say("Copied");
    setTimeout(() => { copy.textContent = label; }, 1500);
  }, settings);
  return copy;
}

/** A command of the shell as a line that can be copied. It goes on in the next line between words alone. */
function commandLine(text) {
  const words = text.split(" ").flatMap((word, i) => [i > 0 && " ", make("span", { class: "word" }, word)]);
  return make("div", { class: "command" }, make("code", {}, words), copyButton("Copy", () => text, { class: "small", "aria-label": `Copy the command ${text}` }));
}

/** What the browser keeps for this page; some keep nothing for files. */
const kept = {
  get(key) {
    try { return localStorage.getItem(key); } catch { return null; }
  },
  set(key, value) {
    try {
      if (value === null) localStorage.removeItem(key);
      else localStorage.setItem(key, value);
    } catch { /* then it lasts as long as the page is open */ }
  },
};
