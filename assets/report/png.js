// A PNG's own numbers (ISO/IEC 15948). A canvas would give others: it multiplies by alpha, converts colours and cuts 16
// bits down to 8, and of a picture beside the page a browser gives none.

/** { width, height, max, rgba }: four numbers a pixel, from the upper left, each from 0 to max (255 or 65535). */
async function decodePng(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 33 || view.getUint32(0) !== 0x89504e47 || view.getUint32(4) !== 0x0d0a1a0a) throw new Error("this is no PNG");
  const [width, height] = [view.getUint32(16), view.getUint32(20)];
  const [depth, type, interlaced] = [bytes[24], bytes[25], bytes[28]];
  const channels = [1, 0, 3, 1, 2, 0, 4][type];
  if (!channels || ![1, 2, 4, 8, 16].includes(depth) || width * height === 0) throw new Error("this is no PNG that can be shown");
  if (width * height > 1 << 26) throw new Error(`${width} x ${height} pixels are too many to show their numbers`);

  const data = [];
  let palette = null;
  let transparent = null;
  for (let at = 8; at + 12 <= bytes.length;) {
    const size = view.getUint32(at);
    const name = String.fromCharCode(...bytes.subarray(at + 4, at + 8));
    const content = bytes.subarray(at + 8, at + 8 + size);
    if (name === "IDAT") data.push(content);
    else if (name === "PLTE") palette = content;
    else if (name === "tRNS") transparent = content;
    else if (name === "IEND") break;
    at += 12 + size;
  }
  const inflated = new Blob(data).stream().pipeThrough(new DecompressionStream("deflate"));
  const lines = new Uint8Array(await new Response(inflated).arrayBuffer());

  const max = depth === 16 ? 65535 : 255;
  const rgba = max === 255 ? new Uint8Array(width * height * 4) : new Uint16Array(width * height * 4);
  const key = transparent && type !== 3 ? pngKey(transparent, channels) : null;
  // x, y of the first pixel of each of Adam7's pictures, and the steps to the next ones.
  const passes = interlaced
    ? [[0, 0, 8, 8], [4, 0, 8, 8], [0, 4, 4, 8], [2, 0, 4, 4], [0, 2, 2, 4], [1, 0, 2, 2], [0, 1, 1, 2]]
    : [[0, 0, 1, 1]];
  const sample = new Uint16Array(4);
  let at = 0;
  for (const [left, top, stepX, stepY] of passes) {
    const columns = Math.ceil((width - left) / stepX);
    const rows = Math.ceil((height - top) / stepY);
    if (columns <= 0 || rows <= 0) continue;
    const stride = Math.ceil((columns * channels * depth) / 8);
    const distance = Math.max(1, (channels * depth) >> 3);
    if (lines.length < at + rows * (stride + 1)) throw new Error("this PNG ends too early");
    let above = null;
    for (let row = 0; row < rows; ++row, at += stride + 1) {
      const line = lines.subarray(at + 1, at + 1 + stride);
      undoPngFilter(lines[at], line, above, distance);
      above = line;
      for (let column = 0; column < columns; ++column) {
        readPngSample(line, column, depth, channels, sample);
        const to = ((top + row * stepY) * width + left + column * stepX) * 4;
        writePngPixel(rgba, to, sample, { type, depth, max, palette, transparent, key });
      }
    }
  }
  return { width, height, max, rgba };
}

function undoPngFilter(filter, line, above, distance) {
  for (let i = 0; i < line.length; ++i) {
    const left = i >= distance ? line[i - distance] : 0;
    const up = above ? above[i] : 0;
    if (filter === 1) line[i] += left;
    else if (filter === 2) line[i] += up;
    else if (filter === 3) line[i] += (left + up) >> 1;
    else if (filter === 4) {
      const corner = above && i >= distance ? above[i - distance] : 0;
      const toLeft = Math.abs(up - corner);
      const toUp = Math.abs(left - corner);
      const toCorner = Math.abs(left + up - 2 * corner);
      line[i] += toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
    }
  }
}

function readPngSample(line, column, depth, channels, sample) {
  for (let k = 0; k < channels; ++k) {
    const i = column * channels + k;
    if (depth === 8) sample[k] = line[i];
    else if (depth === 16) sample[k] = line[2 * i] << 8 | line[2 * i + 1];
    else sample[k] = line[i * depth >> 3] >> (8 - depth - (i * depth & 7)) & ((1 << depth) - 1); // the first one in the high bits
  }
}

/** The colour that is to be transparent, of a picture without alpha. */
function pngKey(transparent, channels) {
  return Array.from({ length: channels }, (_, k) => transparent[2 * k] << 8 | transparent[2 * k + 1]);
}

function writePngPixel(rgba, to, sample, { type, depth, max, palette, transparent, key }) {
  if (type === 3) {
    for (let k = 0; k < 3; ++k) rgba[to + k] = palette?.[sample[0] * 3 + k] ?? 0;
    rgba[to + 3] = transparent?.[sample[0]] ?? 255;
    return;
  }
  const scale = depth < 8 ? 255 / ((1 << depth) - 1) : 1;
  const gray = type === 0 || type === 4;
  for (let k = 0; k < 3; ++k) rgba[to + k] = sample[gray ? 0 : k] * scale;
  rgba[to + 3] = type === 4 ? sample[1] : type === 6 ? sample[3] : key?.every((value, k) => value === sample[k]) ? 0 : max;
}
