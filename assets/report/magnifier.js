// The pixel that one points at, in each picture: what is around it, and its numbers.

const magnifierRadius = 5; // pixels to each side
const magnifierCell = 10;  // of the canvas for one of the picture

class Magnifier {
  #entries = [];
  #place = make("p", { class: "place" });
  #pictures = make("div", { class: "magnified" });
  element = make("section", { class: "magnifier", "aria-label": "Pixel values" }, this.#place, this.#pictures);

  /** `pictures`: [{ label, pixels }], where pixels may be null; `why` then says so. */
  setPictures(pictures, why) {
    const size = (2 * magnifierRadius + 1) * magnifierCell;
    this.#entries = pictures.filter(({ pixels }) => pixels).map(({ label, pixels }) => {
      const canvas = make("canvas", { width: size, height: size, "aria-hidden": "true" });
      const swatch = make("span", { class: "swatch" });
      const numbers = make("span", { class: "numbers" });
      const hex = make("span", { class: "hex" });
      this.#pictures.append();
      return { pixels, canvas, swatch, numbers, hex,
        element: make("div", { class: "magnified-one" }, canvas, make("div", {}, make("b", {}, label), numbers, make("span", {}, swatch, hex))) };
    });
    this.apart = this.#entries.length >= 2 ? make("span", { class: "numbers" }) : null;
    this.#pictures.replaceChildren(...this.#entries.map(({ element }) => element));
    if (this.apart) this.#pictures.append(make("div", { class: "magnified-one apart" }, make("div", {}, make("b", {}, "Apart by"), this.apart)));
    if (this.#entries.length === 0 && why) this.#pictures.append(make("p", { class: "muted" }, why));
  }

  show(pixel, words) {
    this.#place.textContent = pixel ? `Pixel ${pixel.x}, ${pixel.y}${words ? ` (${words})` : ""}, from the upper left` : "Point at a pixel";
    for (const entry of this.#entries) this.#draw(entry, pixel);
    if (!this.apart) return;
    const [a, b] = this.#entries.map(({ pixels }) => valueAt(pixels, pixel));
    const [{ pixels: { max: maxA } }, { pixels: { max: maxB } }] = this.#entries;
    this.apart.textContent = !a || !b ? "–" : a.map((value, k) =>
      maxA === maxB ? Math.abs(value - b[k]) : Math.round(Math.abs(value / maxA - b[k] / maxB) * 255)).join(" ");
  }

  #draw({ pixels, canvas, swatch, numbers, hex }, pixel) {
    const context = canvas.getContext("2d");
    context.clearRect(0, 0, canvas.width, canvas.height);
    const value = valueAt(pixels, pixel);
    numbers.textContent = value ? value.join(" ") : "–";
    hex.textContent = value ? `#${value.map((each) => Math.round(each * (255 / pixels.max)).toString(16).padStart(2, "0")).join("")}` : "";
    swatch.style.backgroundColor = value ? cssColor(value, pixels.max) : "transparent";
    if (!pixel) return;
    for (let dy = -magnifierRadius; dy <= magnifierRadius; ++dy) {
      for (let dx = -magnifierRadius; dx <= magnifierRadius; ++dx) {
        const each = valueAt(pixels, { x: pixel.x + dx, y: pixel.y + dy });
        if (!each) continue;
        context.fillStyle = cssColor(each, pixels.max);
        context.fillRect((dx + magnifierRadius) * magnifierCell, (dy + magnifierRadius) * magnifierCell, magnifierCell, magnifierCell);
      }
    }
    // White in black is seen on every colour.
    const at = magnifierRadius * magnifierCell;
    context.strokeStyle = "#000";
    context.strokeRect(at - 1.5, at - 1.5, magnifierCell + 3, magnifierCell + 3);
    context.strokeStyle = "#fff";
    context.strokeRect(at - 0.5, at - 0.5, magnifierCell + 1, magnifierCell + 1);
  }
}

/** [r, g, b, a] as the file has them, or null beside the picture. */
function valueAt(pixels, pixel) {
  if (!pixel || pixel.x < 0 || pixel.y < 0 || pixel.x >= pixels.width || pixel.y >= pixels.height) return null;
  const at = (pixel.y * pixels.width + pixel.x) * 4;
  return [...pixels.rgba.subarray(at, at + 4)];
}

function cssColor(value, max) {
  const [r, g, b, a] = value.map((each) => each / max);
  return `rgb(${r * 255} ${g * 255} ${b * 255} / ${a})`;
}
