// Which part of the pictures one sees. All panes of a case show the same part, as large as each other.

/** Below it a grid would hide what it divides. In CSS pixels for one of the picture's. */
const gridScale = 8;
const zoomSteps = [1 / 16, 1 / 8, 1 / 4, 1 / 2, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];

/** `scale` is in CSS pixels for one of the picture's; `x` and `y` are where the picture's upper left corner is in a pane,
    in CSS pixels. */
class Viewport {
  picture = { width: 1, height: 1 };
  pane = { width: 1, height: 1 };
  scale = 1;
  x = 0;
  y = 0;
  fitted = true;
  onChange = () => {};

  setSizes(picture, pane) {
    this.picture = picture;
    this.pane = pane;
    if (this.fitted) this.fit();
    else this.#changed();
  }

  /** All of the picture; whole pixels where it is enlarged. */
  fit() {
    const most = Math.min(this.pane.width / this.picture.width, this.pane.height / this.picture.height);
    this.scale = most >= 1 ? Math.min(Math.floor(most), 64) : Math.max(most, 1e-4);
    this.x = (this.pane.width - this.picture.width * this.scale) / 2;
    this.y = (this.pane.height - this.picture.height * this.scale) / 2;
    this.fitted = true;
    this.#changed();
  }

  /** What lies at (x, y) of the pane stays there. */
  zoomTo(scale, x = this.pane.width / 2, y = this.pane.height / 2) {
    const to = Math.min(Math.max(scale, zoomSteps[0]), zoomSteps.at(-1));
    this.x = x - (x - this.x) * (to / this.scale);
    this.y = y - (y - this.y) * (to / this.scale);
    this.scale = to;
    this.fitted = false;
    this.#changed();
  }

  zoomIn() {
    this.zoomTo(zoomSteps.find((step) => step > this.scale * 1.001) ?? zoomSteps.at(-1));
  }

  zoomOut() {
    this.zoomTo(zoomSteps.findLast((step) => step < this.scale * 0.999) ?? zoomSteps[0]);
  }

  pan(dx, dy) {
    this.x += dx;
    this.y += dy;
    this.fitted = false;
    this.#changed();
  }

  /** Puts the middle of a pixel into the middle of the pane. */
  center(pixel, scale = this.scale) {
    this.scale = scale;
    this.x = this.pane.width / 2 - (pixel.x + 0.5) * scale;
    this.y = this.pane.height / 2 - (pixel.y + 0.5) * scale;
    this.fitted = false;
    this.#changed();
  }

  /** The pixel at a place of the pane, or null beside the picture. */
  pixelAt(x, y) {
    const pixel = { x: Math.floor((x - this.x) / this.scale), y: Math.floor((y - this.y) / this.scale) };
    const inside = pixel.x >= 0 && pixel.y >= 0 && pixel.x < this.picture.width && pixel.y < this.picture.height;
    return inside ? pixel : null;
  }

  #changed() {
    // Some of the picture stays in sight.
    const margin = Math.min(32, this.pane.width / 4, this.pane.height / 4);
    const keep = (at, pane, size) => Math.min(Math.max(at, margin - size), pane - margin);
    this.x = keep(this.x, this.pane.width, this.picture.width * this.scale);
    this.y = keep(this.y, this.pane.height, this.picture.height * this.scale);
    this.onChange();
  }
}

/** Lets mouse and fingers move the viewport, and says where they point: `onPoint` (null: nowhere) and `onPin`. */
function steerViewport(pane, viewport, { onPoint, onPin }) {
  const down = new Map(); // of each finger or button, where it is
  let moved = false;
  const placeOf = (event) => {
    const box = pane.getBoundingClientRect();
    return { x: event.clientX - box.left - pane.clientLeft, y: event.clientY - box.top - pane.clientTop };
  };
  const spread = () => {
    const [a, b] = [...down.values()];
    return { distance: Math.hypot(a.x - b.x, a.y - b.y), x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  };
  pane.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pane.setPointerCapture(event.pointerId);
    if (down.size === 0) moved = false;
    down.set(event.pointerId, placeOf(event));
  });
  pane.addEventListener("pointermove", (event) => {
    const place = placeOf(event);
    const before = down.get(event.pointerId);
    if (!before) {
      onPoint(viewport.pixelAt(place.x, place.y));
      return;
    }
    if (down.size === 1) {
      if (!moved && Math.hypot(place.x - before.x, place.y - before.y) < 4) return;
      moved = true;
      viewport.pan(place.x - before.x, place.y - before.y);
      down.set(event.pointerId, place);
    } else if (down.size === 2) {
      moved = true;
      const from = spread();
      down.set(event.pointerId, place);
      const to = spread();
      viewport.zoomTo(viewport.scale * (to.distance / Math.max(from.distance, 1)), from.x, from.y);
      viewport.pan(to.x - from.x, to.y - from.y);
    }
  });
  pane.addEventListener("pointerup", (event) => {
    if (down.delete(event.pointerId) && !moved && down.size === 0) {
      const place = placeOf(event);
      onPin(viewport.pixelAt(place.x, place.y));
    }
  });
  pane.addEventListener("pointercancel", (event) => down.delete(event.pointerId));
  pane.addEventListener("pointerleave", () => onPoint(null));
  pane.addEventListener("wheel", (event) => {
    event.preventDefault();
    const place = placeOf(event);
    const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 16 : 1;
    viewport.zoomTo(viewport.scale * Math.exp(-event.deltaY * lines * 0.002), place.x, place.y);
  }, { passive: false });
}
