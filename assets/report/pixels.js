// The pixels of pictures, which come by scripts beside them when a case is looked at: no page that is opened from a file
// may read the pictures themselves.

const pixelScripts = new Map();

/** What a picture's script calls, "a.png.js" for "a.png". */
window.texplorerPixels = (file, base64) => pixelScripts.set(file, base64);

class PixelStore {
  #limit = 24; // pictures: some cases, there and back
  #loads = new Map();

  /** Decoded as decodePng does; the promise fails where there are none. */
  load(file) {
    const load = this.#loads.get(file) ?? this.#read(file);
    this.#loads.delete(file);
    this.#loads.set(file, load); // the newest is the last
    if (this.#loads.size > this.#limit) this.#loads.delete(this.#loads.keys().next().value);
    return load;
  }

  async #read(file) {
    await new Promise((loaded, failed) => {
      const script = make("script", { src: `${urlOf(file)}.js`, on: {
        load: () => { script.remove(); loaded(); },
        error: () => { script.remove(); failed(new Error(`${file}.js is not there`)); },
      } });
      document.head.append(script);
    });
    const base64 = pixelScripts.get(file);
    pixelScripts.delete(file);
    if (base64 === undefined) throw new Error(`${file}.js is that of another picture`);
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < bytes.length; ++i) bytes[i] = text.charCodeAt(i);
    return decodePng(bytes);
  }
}

/** { width, height, rgba }: how far two pictures are apart in each channel, `gain` times, opaque. What only one of them
    has, or alpha alone tells apart, is white; what neither has is transparent. */
function differenceOf(a, b, gain) {
  const width = Math.max(a.width, b.width);
  const height = Math.max(a.height, b.height);
  const rgba = new Uint8ClampedArray(width * height * 4);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const to = (y * width + x) * 4;
      rgba[to + 3] = 255;
      const inA = x < a.width && y < a.height;
      const inB = x < b.width && y < b.height;
      if (!inA || !inB) {
        rgba.fill(inA || inB ? 255 : 0, to, to + 4);
        continue;
      }
      const ofA = (y * a.width + x) * 4;
      const ofB = (y * b.width + x) * 4;
      const apart = (k) => Math.abs(a.rgba[ofA + k] * (255 / a.max) - b.rgba[ofB + k] * (255 / b.max));
      const alpha = apart(3);
      for (let k = 0; k < 3; ++k) rgba[to + k] = Math.max(apart(k), alpha) * gain;
    }
  }
  return { width, height, rgba };
}
