// The pictures of one case: beside each other, across each other, one after the other, or how far they are apart.

const views = [
  { name: "side", label: "Side by side", pair: false },
  { name: "slider", label: "Slider", pair: true },
  { name: "flicker", label: "Flicker", pair: true },
  { name: "difference", label: "Difference", pair: true }, // times the gain, as its button says
];
// No more than three flashes a second: WCAG 2.2, 2.3.1.
const flickerRates = [1, 2, 3];
const gains = [1, 2, 4, 8, 16, 32, 64];

class Stage {
  #store = new PixelStore();
  #viewport = new Viewport();
  #magnifier = new Magnifier();
  #panes = make("div", { class: "panes" });
  #tools = make("div", { class: "tools", role: "toolbar", "aria-label": "How to look at the pictures" });
  #case = null;
  #pixels = {};      // by role, of the case that is shown
  #naturalSizes = {}; // by role
  #view = views[0];
  #gain = 8;
  #divider = 0.5;  // where the slider is, from 0 to 1
  #flickered = 0;  // which of the two is shown
  #timer = 0;
  #rate = 2;
  #pin = null;
  #pointed = null;

  element = make("section", { class: "stage", "aria-label": "Pictures" }, this.#tools, this.#panes, this.#magnifier.element);

  constructor() {
    this.#viewport.onChange = () => this.#place();
    new ResizeObserver(() => this.#measure()).observe(this.#panes);
  }

  show(aCase) {
    this.#case = aCase;
    this.#pixels = {};
    this.#naturalSizes = {};
    this.#flickered = 0;
    this.#pause();
    this.#pointed = null;
    this.#pin = aCase.worst ? { x: aCase.worst[0], y: aCase.worst[1] } : null;
    this.#viewport.fitted = true;
    this.element.hidden = aCase.pictures.length === 0;
    this.#loadPixels(aCase);
    this.#build();
  }

  hide() {
    this.#pause();
  }

  setView(number) {
    const view = views[number];
    if (!view || (view.pair && !this.#pair)) return;
    this.#view = view;
    if (view.name !== "flicker") this.#pause();
    this.#build();
    say(view.label);
  }

  get #differenceName() {
    return `Difference × ${this.#gain}`;
  }

  get #shownView() {
    return this.#view.pair && !this.#pair ? views[0] : this.#view;
  }

  #picture(role) {
    return this.#case?.pictures.find((picture) => picture.role === role);
  }

  get #pair() {
    const [expected, actual] = [this.#picture("expected"), this.#picture("actual")];
    return expected && actual ? [expected, actual] : null;
  }

  // What keys do.

  flip() {
    if (!this.#pair) return;
    if (this.#shownView.name === "flicker") this.#flickered = 1 - this.#flickered;
    else {
      this.#view = views[2];
      this.#build();
    }
    this.#showFlickered();
    say(this.#pair[this.#flickered].label);
  }

  togglePlay() {
    if (!this.#pair) return;
    const play = this.#timer === 0;
    if (this.#shownView.name !== "flicker") this.setView(2);
    if (play) this.#play();
    else this.#pause();
  }

  nextGain() {
    if (this.#shownView.name !== "difference") this.setView(3);
    else this.#setGain(gains[(gains.indexOf(this.#gain) + 1) % gains.length]);
  }

  zoomIn() { this.#viewport.zoomIn(); }
  zoomOut() { this.#viewport.zoomOut(); }
  fit() { this.#viewport.fit(); }
  oneToOne() { this.#viewport.zoomTo(1); }

  toWorst() {
    if (!this.#case?.worst) return;
    const [x, y] = this.#case.worst;
    this.#pin = { x, y };
    this.#viewport.center(this.#pin, Math.max(this.#viewport.scale, 16));
  }

  movePin(dx, dy) {
    const { width, height } = this.#viewport.picture;
    const from = this.#pin ?? { x: width >> 1, y: height >> 1 };
    this.#pin = { x: Math.min(Math.max(from.x + dx, 0), width - 1), y: Math.min(Math.max(from.y + dy, 0), height - 1) };
    this.#pointed = null;
    this.#place();
    say(`Pixel ${this.#pin.x}, ${this.#pin.y}`);
  }

  // Pixels.

  async #loadPixels(aCase) {
    const without = aCase.pictures.every((picture) => !picture.pixels);
    this.#magnify(without ? "The numbers of these pictures' pixels were not kept." : "");
    await Promise.all(aCase.pictures.filter((picture) => picture.pixels && picture.role !== "difference").map(async (picture) => {
      try {
        const pixels = await this.#store.load(picture.file);
        if (this.#case === aCase) this.#pixels[picture.role] = pixels;
      } catch (error) {
        if (this.#case === aCase) this.#magnify(`The numbers of the pixels can't be shown: ${error.message}.`);
      }
    }));
    if (this.#case !== aCase || Object.keys(this.#pixels).length === 0) return;
    this.#magnify("");
    if (this.#shownView.name === "difference") this.#build();
  }

  #magnify(why) {
    const pictures = this.#case.pictures.filter(({ role }) => role !== "difference");
    this.#magnifier.setPictures(pictures.map(({ role, label }) => ({ label, pixels: this.#pixels[role] ?? null })), why);
    this.#showPixel();
  }

  #showPixel() {
    const pixel = this.#pointed ?? this.#pin;
    const worst = this.#case.worst;
    this.#magnifier.show(pixel, pixel && worst && pixel.x === worst[0] && pixel.y === worst[1] ? "the worst" : "");
  }

  // The panes.

  #build() {
    const panes = {
      side: () => this.#case.pictures.map((picture) => this.#pane(picture.label, [this.#layer(this.#image(picture))], picture)),
      slider: () => [this.#sliderPane()],
      flicker: () => [this.#flickerPane()],
      difference: () => [this.#differencePane()],
    }[this.#shownView.name]();
    this.#panes.replaceChildren(...panes);
    this.#panes.dataset.view = this.#shownView.name;
    this.#buildTools();
    this.#measure();
    this.#showFlickered();
  }

  #image(picture, settings = {}) {
    const image = make("img", { alt: `${picture.label}, ${this.#case.name}`, draggable: false, decoding: "async", ...settings });
    image.addEventListener("load", () => {
      image.style.width = `${image.naturalWidth}px`;
      image.style.height = `${image.naturalHeight}px`;
      this.#naturalSizes[picture.role] = { width: image.naturalWidth, height: image.naturalHeight };
      this.#measure();
    });
    image.addEventListener("error", () => {
      image.closest(".pane")?.append(make("p", { class: "absent" }, `${picture.file} is not there.`));
      image.remove();
    });
    image.src = urlOf(picture.file);
    return image;
  }

  #layer(...content) {
    return make("div", { class: "layer" }, content);
  }

  #pane(label, layers, picture = null) {
    const legend = picture?.role === "difference" && this.#case.legend;
    const pane = make("div", { class: "pane" }, layers,
      make("div", { class: "grid" }), make("div", { class: "mark worst", title: "The worst pixel" }), make("div", { class: "mark pin" }));
    steerViewport(pane, this.#viewport, {
      onPoint: (pixel) => { this.#pointed = pixel; this.#showPixel(); },
      onPin: (pixel) => { this.#pin = pixel; this.#place(); },
    });
    return make("figure", { class: "figure", "data-role": picture?.role },
      make("figcaption", {}, make("span", { class: "caption" }, label), picture && make("span", { class: "extent muted" }), picture && make("a", { href: urlOf(picture.file), target: "_blank", "aria-label": `${label} as a file of its own` }, "file")),
      pane,
      legend && make("div", { class: "legend", role: "group", "aria-label": "What the colours of the difference mean" }, legend.map(legendEntry)));
  }

  #sliderPane() {
    const [expected, actual] = this.#pair;
    const front = make("div", { class: "front" }, this.#layer(this.#image(actual)));
    const handle = make("div", { class: "divider", tabIndex: 0, role: "slider", "aria-label": `${expected.label} on the left, ${actual.label} on the right`,
      "aria-valuemin": 0, "aria-valuemax": 100 });
    const figure = this.#pane(expected.label, [this.#layer(this.#image(expected)), front, handle]);
    figure.querySelector("figcaption").append(make("span", { class: "caption right" }, actual.label));
    const move = (to) => {
      this.#divider = Math.min(Math.max(to, 0), 1);
      front.style.clipPath = `inset(0 0 0 ${this.#divider * 100}%)`;
      handle.style.left = `${this.#divider * 100}%`;
      handle.setAttribute("aria-valuenow", Math.round(this.#divider * 100));
    };
    move(this.#divider);
    handle.addEventListener("pointerdown", (event) => {
      event.stopPropagation(); // and the picture stays where it is
      handle.setPointerCapture(event.pointerId);
    });
    handle.addEventListener("pointermove", (event) => {
      if (!handle.hasPointerCapture(event.pointerId)) return;
      event.stopPropagation();
      const box = handle.parentElement.getBoundingClientRect();
      move((event.clientX - box.left) / box.width);
    });
    handle.addEventListener("keydown", (event) => {
      const step = event.shiftKey ? 0.1 : 0.01;
      const to = { ArrowLeft: this.#divider - step, ArrowRight: this.#divider + step, Home: 0, End: 1 }[event.key];
      if (to === undefined) return;
      event.preventDefault();
      event.stopPropagation();
      move(to);
    });
    return figure;
  }

  #flickerPane() {
    const [expected, actual] = this.#pair;
    return this.#pane("", [this.#layer(this.#image(expected)), this.#layer(this.#image(actual))]);
  }

  #showFlickered() {
    if (this.#shownView.name !== "flicker") return;
    const layers = this.#panes.querySelectorAll(".layer");
    layers.forEach((layer, i) => { layer.style.visibility = i === this.#flickered ? "visible" : "hidden"; });
    this.#panes.querySelector(".caption").textContent = this.#pair[this.#flickered].label;
  }

  #play() {
    clearInterval(this.#timer);
    this.#timer = setInterval(() => {
      this.#flickered = 1 - this.#flickered;
      this.#showFlickered();
    }, 1000 / this.#rate);
    this.#buildTools();
  }

  #pause() {
    if (this.#timer === 0) return;
    clearInterval(this.#timer);
    this.#timer = 0;
    this.#buildTools();
  }

  #differencePane() {
    const [expected, actual] = this.#pair;
    const label = `${expected.label} − ${actual.label}, × ${this.#gain}`;
    const { expected: a, actual: b } = this.#pixels;
    if (!a || !b) {
      // Without numbers the browser subtracts what it draws.
      const blend = make("div", { class: "blend", style: `filter: brightness(${this.#gain})` }, this.#image(expected), this.#image(actual, { class: "over" }));
      return this.#pane(label, [this.#layer(blend)]);
    }
    const { width, height, rgba } = differenceOf(a, b, this.#gain);
    const canvas = make("canvas", { width, height, role: "img", "aria-label": `Difference, ${this.#case.name}` });
    canvas.style.width = `${width}px`;
    canvas.style.height = `${height}px`;
    canvas.getContext("2d").putImageData(new ImageData(rgba, width, height), 0, 0);
    return this.#pane(label, [this.#layer(canvas)]);
  }

  #rateChoice() {
    const choose = (event) => {
      this.#rate = Number(event.target.value);
      if (this.#timer) this.#play();
    };
    return make("select", { "data-tool": "rate", "aria-label": "Pictures a second", on: { change: choose } },
      flickerRates.map((rate) => make("option", { value: rate, selected: rate === this.#rate }, `${rate} / s`)));
  }

  #gainChoice() {
    const range = make("input", { type: "range", "data-tool": "gain", min: 0, max: gains.length - 1, value: gains.indexOf(this.#gain),
      "aria-label": "Gain", "aria-valuetext": `${this.#gain}`, title: "Key g", on: { input: () => this.#setGain(gains[range.value]) } });
    return [make("span", { class: "gain" }, `Gain × ${this.#gain}`), range];
  }

  #setGain(gain) {
    this.#gain = gain;
    say(`Gain ${gain}`);
    // The bar that is being dragged stays.
    const range = this.#tools.querySelector("input");
    range.value = gains.indexOf(gain);
    range.setAttribute("aria-valuetext", `${gain}`);
    this.#tools.querySelector(".gain").textContent = `Gain × ${gain}`;
    this.#tools.querySelector("[data-tool=difference]").textContent = this.#differenceName;
    this.#panes.replaceChildren(this.#differencePane());
    this.#measure();
  }

  // Where everything is.

  #measure() {
    const pane = this.#panes.querySelector(".pane");
    if (!pane || !this.#case) return;
    const [width, height] = this.#case.size ?? [0, 0];
    const sizes = [{ width, height }, ...Object.values(this.#naturalSizes)];
    const picture = { width: Math.max(1, ...sizes.map((size) => size.width)), height: Math.max(1, ...sizes.map((size) => size.height)) };
    this.#panes.style.setProperty("--ratio", picture.width / picture.height);
    this.#sayExtents();
    if (pane.clientWidth > 0) this.#viewport.setSizes(picture, { width: pane.clientWidth, height: pane.clientHeight });
  }

  /** Beside their names, where the pictures have two sizes. */
  #sayExtents() {
    const textOf = (size) => `${size.width} × ${size.height}`;
    const differ = new Set(Object.values(this.#naturalSizes).map(textOf)).size > 1;
    for (const figure of this.#panes.querySelectorAll("[data-role]")) {
      const size = this.#naturalSizes[figure.dataset.role];
      figure.querySelector(".extent").textContent = differ && size ? textOf(size) : "";
    }
  }

  #place() {
    const { x, y, scale } = this.#viewport;
    for (const layer of this.#panes.querySelectorAll(".layer")) {
      layer.style.transform = `translate(${x}px, ${y}px) scale(${scale})`;
      layer.classList.toggle("crisp", scale >= 1);
    }
    for (const grid of this.#panes.querySelectorAll(".grid")) {
      grid.hidden = scale < gridScale;
      const { width, height } = this.#viewport.picture;
      grid.style.backgroundSize = `${scale}px ${scale}px`;
      Object.assign(grid.style, { left: `${x}px`, top: `${y}px`, width: `${width * scale}px`, height: `${height * scale}px` });
    }
    const worst = this.#case.worst;
    this.#mark("worst", worst ? { x: worst[0], y: worst[1] } : null);
    // The ring alone hides less of the pixel that it is about.
    this.#mark("pin", this.#pin && !(scale < gridScale && worst && this.#pin.x === worst[0] && this.#pin.y === worst[1]) ? this.#pin : null);
    for (const pane of this.#panes.querySelectorAll(".pane")) pane.classList.toggle("moved", !this.#viewport.fitted);
    const text = this.#tools.querySelector(".scale");
    if (text) text.textContent = `${scale >= 0.1 ? Math.round(scale * 100) : (scale * 100).toFixed(1)} %`;
    this.#showPixel();
  }

  #mark(kind, pixel) {
    const { x, y, scale } = this.#viewport;
    const size = kind === "worst" ? Math.max(scale + 6, 18) : Math.max(scale, 7);
    for (const mark of this.#panes.querySelectorAll(`.${kind}`)) {
      mark.hidden = !pixel;
      if (!pixel) continue;
      mark.style.width = mark.style.height = `${size}px`;
      mark.style.left = `${x + (pixel.x + 0.5) * scale - size / 2}px`;
      mark.style.top = `${y + (pixel.y + 0.5) * scale - size / 2}px`;
    }
  }

  #buildTools() {
    const focused = this.#tools.contains(document.activeElement) ? document.activeElement.dataset.tool : null;
    const chosen = this.#shownView;
    const tool = (name, text, action, settings = {}) => button(text, action, { "data-tool": name, ...settings });
    const group = (label, ...content) => make("div", { class: "group", role: "group", "aria-label": label }, content);
    this.#tools.replaceChildren(...present([
      group("View", views.map((view, i) => tool(view.name, view.name === "difference" ? this.#differenceName : view.label, () => this.setView(i), {
        "aria-pressed": view === chosen, disabled: view.pair && !this.#pair,
        title: view.pair && !this.#pair ? "There is only one picture" : `Key ${i + 1}` }))),
      group("Zoom",
        tool("out", "−", () => this.zoomOut(), { "aria-label": "Smaller", title: "Key −" }),
        make("span", { class: "scale" }),
        tool("in", "+", () => this.zoomIn(), { "aria-label": "Larger", title: "Key +" }),
        tool("fit", "Fit", () => this.fit(), { title: "Key 0" }),
        tool("one", "1:1", () => this.oneToOne(), { title: "Key z", "aria-label": "One to one" }),
        this.#case.worst && tool("worst", "Worst", () => this.toWorst(), { title: "Key w", "aria-label": "To the worst pixel" })),
      chosen.name === "flicker" && group("Flicker",
        tool("flip", "Swap", () => this.flip(), { title: "Key f", "aria-label": "The other picture" }),
        tool("play", this.#timer ? "Stop" : "Play", () => this.togglePlay(), { title: "Key p", "aria-pressed": this.#timer !== 0 }),
        this.#rateChoice()),
      chosen.name === "difference" && group("Gain", this.#gainChoice()),
    ]));
    if (focused) this.#tools.querySelector(`[data-tool="${focused}"]`)?.focus();
    const text = this.#tools.querySelector(".scale");
    if (text) text.textContent = `${Math.round(this.#viewport.scale * 100)} %`;
  }
}

function legendEntry({ label, color }) {
  const [r, g, b] = color;
  const light = 0.2126 * r + 0.7152 * g + 0.0722 * b > 110;
  return make("span", { style: `background: rgb(${r} ${g} ${b}); color: ${light ? "#000" : "#fff"}` }, label);
}
