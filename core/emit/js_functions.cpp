#include "core/emit/js_functions.h"

#include <array>

namespace texplorer::emit {
namespace {

struct JsFunction {
    std::string_view name;
    std::string_view text;
};

/// In the order in which they stand: each calls only those before it.
constexpr std::array jsFunctions{
    JsFunction{
        "checkerboard",
        R"(// The board of checker.c in the OpenGL Programming Guide: dark squares, and others of a colour.
function checkerboard(size, square, red, green, blue) {
  const texels = new Uint8Array(size * size * 4);
  for (let y = 0; y < size; ++y) {
    for (let x = 0; x < size; ++x) {
      const light = ((x & square) === 0) !== ((y & square) === 0);
      texels.set(light ? [red, green, blue, 255] : [0, 0, 0, 255], 4 * (y * size + x));
    }
  }
  return texels;
}
)"},
    JsFunction{"gradient", R"(// The place is the colour: red grows to the right, green upwards.
function gradient() {
  const texels = new Uint8Array(256 * 256 * 4);
  for (let y = 0; y < 256; ++y) {
    for (let x = 0; x < 256; ++x) texels.set([x, y, 255 - ((x + y) >> 1), 255], 4 * (y * 256 + x));
  }
  return texels;
}
)"},
    JsFunction{"fill", R"(// One colour everywhere.
function fill(count, red, green, blue, alpha) {
  const texels = new Uint8Array(count * 4);
  for (let i = 0; i < count; ++i) texels.set([red, green, blue, alpha], 4 * i);
  return texels;
}
)"},
    JsFunction{"bytes", R"(// What base64 says; spaces and ends of lines mean nothing.
function bytes(text) {
  return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
}
)"},
    JsFunction{
        "unpack",
        R"(// RGBA texels that are packed as in the "Quite OK Image Format", qoiformat.org: a byte says how a texel differs
// from the one before it, or which one of those that were seen it is.
function unpack(packed, count) {
  const texels = new Uint8Array(count * 4);
  const seen = new Uint8Array(64 * 4);
  const texel = new Uint8Array([0, 0, 0, 255]);
  for (let at = 0, to = 0; at < packed.length; ) {
    const code = packed[at++];
    let run = 1;
    if (code >= 0xfe) { // red, green and blue; alpha, too
      for (let i = 0; i < code - 0xfb; ++i) texel[i] = packed[at++];
    } else if (code >> 6 === 0) { // one that was seen
      texel.set(seen.subarray(4 * code, 4 * code + 4));
    } else if (code >> 6 === 1) { // a small difference
      texel[0] += ((code >> 4) & 3) - 2;
      texel[1] += ((code >> 2) & 3) - 2;
      texel[2] += (code & 3) - 2;
    } else if (code >> 6 === 2) { // that of green, and how the others differ from it
      const green = (code & 63) - 32;
      const others = packed[at++];
      texel[0] += green + (others >> 4) - 8;
      texel[1] += green;
      texel[2] += green + (others & 15) - 8;
    } else { // the same one again
      run = (code & 63) + 1;
    }
    seen.set(texel, 4 * ((texel[0] * 3 + texel[1] * 5 + texel[2] * 7 + texel[3] * 11) % 64));
    for (; run > 0; --run, to += 4) texels.set(texel, to);
  }
  return texels;
}
)"},
    JsFunction{
        "halve",
        R"(// The next mip level: each texel is the average of four, or of two where there is one row or column.
function halve(image) {
  const right = image.width > 1 ? 4 : 0;
  const up = image.height > 1 ? 4 * image.width : 0;
  const width = Math.max(1, image.width >> 1);
  const height = Math.max(1, image.height >> 1);
  const texels = new Uint8Array(width * height * 4);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      for (let i = 0; i < 4; ++i) {
        const from = (up > 0 ? 2 * y : y) * 4 * image.width + (right > 0 ? 2 * x : x) * 4 + i;
        const sum = image.texels[from] + image.texels[from + right] + image.texels[from + up] + image.texels[from + up + right];
        texels[4 * (y * width + x) + i] = (sum + 2) >> 2;
      }
    }
  }
  return {width, height, texels};
}
)"},
    JsFunction{
        "keep",
        R"(// What a texture keeps of an image: for each component one of r, g, b and a, or 0 or 1. WebGL has neither the formats of
// luminance and alpha nor the swizzles that took their place.
function keep(texels, components) {
  const kept = new Uint8Array(texels.length);
  for (let i = 0; i < texels.length; ++i) {
    const component = components[i % 4];
    const from = "rgba".indexOf(component);
    kept[i] = from >= 0 ? texels[i - (i % 4) + from] : 255 * Number(component);
  }
  return kept;
}
)"},
    JsFunction{"multiply",
               R"(// What b does, then what a does. A matrix is 16 numbers, column by column as OpenGL has it.
function multiply(a, b) {
  const product = [];
  for (let column = 0; column < 16; column += 4) {
    for (let row = 0; row < 4; ++row) {
      product.push(a[row] * b[column] + a[4 + row] * b[column + 1] + a[8 + row] * b[column + 2] + a[12 + row] * b[column + 3]);
    }
  }
  return product;
}
)"},
    JsFunction{"translation", R"(// As glTranslate.
function translation(x, y, z) {
  return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, z, 1];
}
)"},
    JsFunction{"rotation", R"(// As glRotate; without an axis nothing turns.
function rotation(degrees, x, y, z) {
  const length = Math.hypot(x, y, z);
  if (length === 0) return translation(0, 0, 0);
  const turn = degrees % 360;
  const right = turn % 90 === 0; // whose sine and cosine are whole
  const sine = right ? Math.round(Math.sin((turn * Math.PI) / 180)) : Math.sin((turn * Math.PI) / 180);
  const cosine = right ? Math.round(Math.cos((turn * Math.PI) / 180)) : Math.cos((turn * Math.PI) / 180);
  x /= length;
  y /= length;
  z /= length;
  const rest = 1 - cosine;
  return [
    rest * x * x + cosine, rest * x * y + sine * z, rest * x * z - sine * y, 0,
    rest * y * x - sine * z, rest * y * y + cosine, rest * y * z + sine * x, 0,
    rest * z * x + sine * y, rest * z * y - sine * x, rest * z * z + cosine, 0,
    0, 0, 0, 1,
  ];
}
)"},
    JsFunction{"scaling", R"(// As glScale.
function scaling(x, y, z) {
  return [x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1];
}
)"},
    JsFunction{"about", R"(// What turns or scales about the origin does so about a point.
function about(x, y, z, matrix) {
  return multiply(multiply(translation(x, y, z), matrix), translation(-x, -y, -z));
}
)"},
    JsFunction{"perspective", R"(// As gluPerspective: the angle is vertical, in degrees.
function perspective(angle, aspect, nearest, farthest) {
  const top = nearest * Math.tan((angle * Math.PI) / 360);
  const depth = farthest - nearest;
  return [
    nearest / (top * aspect), 0, 0, 0, 0, nearest / top, 0, 0,
    0, 0, -(farthest + nearest) / depth, -1, 0, 0, (-2 * farthest * nearest) / depth, 0,
  ];
}
)"},
    JsFunction{"orthographic",
               R"(// As glOrtho with the eye in the middle: what is behind it is in sight, too.
function orthographic(right, top, farthest) {
  return scaling(1 / right, 1 / top, -1 / farthest);
}
)"},
    JsFunction{"setMatrix", R"(function setMatrix(program, name, matrix) {
  gl.uniformMatrix4fv(gl.getUniformLocation(program, name), false, matrix);
}
)"},
    JsFunction{
        "setNormalMatrix",
        R"(// What normals are multiplied by: the inverse of the rotation and scale, transposed, by Cramer's rule.
function setNormalMatrix(program, name, m) {
  const normal = [];
  for (let i = 0; i < 3; ++i) {
    const a = 4 * ((i + 1) % 3);
    const b = 4 * ((i + 2) % 3);
    for (let j = 0; j < 3; ++j) {
      const k = (j + 1) % 3;
      const l = (j + 2) % 3;
      normal.push(m[a + k] * m[b + l] - m[a + l] * m[b + k]);
    }
  }
  const determinant = m[0] * normal[0] + m[4] * normal[3] + m[8] * normal[6];
  gl.uniformMatrix3fv(gl.getUniformLocation(program, name), false, normal.map((each) => each / determinant));
}
)"},
    JsFunction{
        "lightInModel",
        R"(// Where the light is as the model has it, by the inverse of the modelview matrix; transposed: by the transpose of its
// rotation and scale, as one gets it who multiplies the row.
function lightInModel(m, light, transposed) {
  const determinant =
    m[0] * (m[5] * m[10] - m[6] * m[9]) - m[4] * (m[1] * m[10] - m[2] * m[9]) + m[8] * (m[1] * m[6] - m[2] * m[5]);
  const placed = light[3] !== 0;
  const eye = [0, 1, 2].map((i) => light[i] / (placed ? light[3] : 1) - (placed && !transposed ? m[12 + i] : 0));
  const inverse = (row, column) => {
    const a = 4 * ((row + 1) % 3);
    const b = 4 * ((row + 2) % 3);
    const i = (column + 1) % 3;
    const j = (column + 2) % 3;
    return (m[a + i] * m[b + j] - m[a + j] * m[b + i]) / determinant;
  };
  const found = [0, 1, 2].map((i) =>
    [0, 1, 2].reduce((sum, j) => sum + (transposed ? inverse(j, i) : inverse(i, j)) * eye[j], 0));
  return [...found, placed ? 1 : 0];
}
)"},
    JsFunction{
        "emboss",
        R"(// Moves coordinates towards the light, vertex by vertex, along the directions in which s and t grow (`tangents`, six
// numbers each): after NeHe's lesson 22.
function emboss(vertices, coords, tangents, light, depth) {
  const moved = new Float32Array(coords);
  for (let i = 0; i < coords.length / 4; ++i) {
    const to = [0, 1, 2].map((k) => light[k] - light[3] * vertices[10 * i + k]);
    const length = Math.hypot(...to);
    for (let k = 0; k < 3 && length > 0; ++k) {
      moved[4 * i] += ((tangents[6 * i + k] * to[k]) / length) * depth * coords[4 * i + 3];
      moved[4 * i + 1] += ((tangents[6 * i + 3 + k] * to[k]) / length) * depth * coords[4 * i + 3];
    }
  }
  return moved;
}
)"},
    JsFunction{"compile", R"(// Compiles one stage.
function compile(stage, source) {
  const shader = gl.createShader(stage);
  gl.shaderSource(shader, source);
  gl.compileShader(shader);
  if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
  return shader;
}
)"},
    JsFunction{"newProgram", R"(// Links both stages.
function newProgram(vertexShader, fragmentShader) {
  const program = gl.createProgram();
  gl.attachShader(program, compile(gl.VERTEX_SHADER, vertexShader));
  gl.attachShader(program, compile(gl.FRAGMENT_SHADER, fragmentShader));
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
  return program;
}
)"},
    JsFunction{"newBuffer", R"(// A new buffer, bound to the target, with a copy of the numbers.
function newBuffer(target, numbers) {
  const buffer = gl.createBuffer();
  gl.bindBuffer(target, buffer);
  gl.bufferData(target, numbers, gl.STATIC_DRAW);
  return buffer;
}
)"},
    JsFunction{
        "attribute",
        R"(// Where an input of the vertex shader lies in the buffer that is bound: so many floats, `stride` floats from vertex to
// vertex.
function attribute(location, count, stride, offset) {
  gl.enableVertexAttribArray(location);
  gl.vertexAttribPointer(location, count, gl.FLOAT, false, 4 * stride, 4 * offset);
}
)"},
};

/// Whether a text calls it: no other name ends with the same letters.
bool calls(std::string_view text, std::string_view name) {
    const std::string call = std::string(name) + "(";
    for (std::size_t at = text.find(call); at != std::string_view::npos; at = text.find(call, at + 1)) {
        const char before = at == 0 ? ' ' : text[at - 1];
        const bool isName =
            (before >= 'a' && before <= 'z') || (before >= 'A' && before <= 'Z') || before == '.';
        if (!isName)
            return true;
    }
    return false;
}

/// Four spaces for each two: these functions stand beside those that are written as C is.
std::string indented(std::string_view text) {
    std::string out;
    bool begins = true;
    for (const char c : text) {
        out += c;
        if (begins && c == ' ')
            out += ' ';
        begins = c == '\n' || (begins && c == ' ');
    }
    return out;
}

} // namespace

std::string jsFunctionsFor(std::string_view text) {
    std::string all;
    for (std::size_t i = jsFunctions.size(); i-- > 0;) {
        if (calls(text, jsFunctions[i].name) || calls(all, jsFunctions[i].name))
            all = indented(jsFunctions[i].text) + "\n" + all;
    }
    return all;
}

} // namespace texplorer::emit
