// Draws the window's panels with WebGL 2: triangles of Dear ImGui with one texture each.

const VERTEX_BYTES = 20; // ImDrawVert: position, texture coordinates, colour

const vertexShader = `#version 300 es
uniform vec2 size;
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 coords;
layout(location = 2) in vec4 color;
out vec2 at;
out vec4 tint;
void main() {
    at = coords;
    tint = color;
    gl_Position = vec4(position.x * 2.0 / size.x - 1.0, 1.0 - position.y * 2.0 / size.y, 0, 1);
}`;

const fragmentShader = `#version 300 es
precision highp float;
uniform sampler2D picture;
in vec2 at;
in vec4 tint;
out vec4 color;
void main() { color = tint * texture(picture, at); }`;

function compile(gl, kind, source) {
    const shader = gl.createShader(kind);
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    return shader;
}

// Textures by the names that the program knows.
class Textures {
    #gl;
    #all = new Map();
    #last = 0;

    constructor(gl) { this.#gl = gl; }
    add(texture) {
        this.#all.set(++this.#last, texture);
        return this.#last;
    }
    get(name) { return this.#all.get(name) ?? null; }
    drop(name) {
        this.#gl.deleteTexture(this.get(name));
        this.#all.delete(name);
    }
    clear() { this.#all.clear(); } // names are not used again
}

export class Panels {
    #gl;
    #canvas;
    #bytes; // () → Uint8Array of the program's memory
    #program;
    #size;
    #density = 1;
    #vertices;
    #indices;

    // Throws if the browser has no WebGL 2. `bytes` returns the program's memory.
    constructor(canvas, bytes) {
        this.#canvas = canvas;
        this.#bytes = bytes;
        this.#gl = canvas.getContext('webgl2', {
            alpha: false, antialias: false, depth: false, stencil: false, preserveDrawingBuffer: true,
        });
        if (!this.#gl)
            throw new Error('Texplorer needs WebGL 2, which this browser has not or has switched off.');
        this.textures = new Textures(this.#gl);
        this.#prepare();
    }

    get gl() { return this.#gl; }

    // Call after the context was restored: there are no textures any more.
    restore() {
        this.textures.clear();
        this.#prepare();
    }

    #prepare() {
        const gl = this.#gl;
        this.#program = gl.createProgram();
        gl.attachShader(this.#program, compile(gl, gl.VERTEX_SHADER, vertexShader));
        gl.attachShader(this.#program, compile(gl, gl.FRAGMENT_SHADER, fragmentShader));
        gl.linkProgram(this.#program);
        this.#size = gl.getUniformLocation(this.#program, 'size');
        this.#vertices = gl.createBuffer();
        this.#indices = gl.createBuffer();
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    }

    makeTexture(pixels, width, height, enlarged) {
        const gl = this.#gl;
        const most = gl.getParameter(gl.MAX_TEXTURE_SIZE);
        const texture = Math.max(width, height) <= most ? gl.createTexture() : null;
        if (!texture || gl.isContextLost())
            return 0;
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, enlarged ? gl.NEAREST : gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE,
            this.#bytes().subarray(pixels, pixels + width * height * 4));
        return this.textures.add(texture);
    }

    dropTexture(name) {
        this.textures.drop(name);
    }

    beginPanels(width, height, density, red, green, blue) {
        const gl = this.#gl;
        if (this.#canvas.width !== width || this.#canvas.height !== height) {
            this.#canvas.width = width;
            this.#canvas.height = height;
        }
        this.#density = density;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.bindVertexArray(null);
        gl.viewport(0, 0, width, height);
        gl.disable(gl.DEPTH_TEST);
        gl.disable(gl.SCISSOR_TEST);
        gl.clearColor(red, green, blue, 1);
        gl.clear(gl.COLOR_BUFFER_BIT);
        gl.enable(gl.SCISSOR_TEST);
        gl.useProgram(this.#program);
        gl.uniform2f(this.#size, width / density, height / density);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        this.setBlending(true);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#vertices);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#indices);
        for (let i = 0; i < 3; ++i)
            gl.enableVertexAttribArray(i);
        gl.vertexAttribPointer(0, 2, gl.FLOAT, false, VERTEX_BYTES, 0);
        gl.vertexAttribPointer(1, 2, gl.FLOAT, false, VERTEX_BYTES, 8);
        gl.vertexAttribPointer(2, 4, gl.UNSIGNED_BYTE, true, VERTEX_BYTES, 16);
    }

    panelList(vertices, vertexCount, indices, indexCount) {
        const gl = this.#gl;
        const bytes = this.#bytes();
        gl.bufferData(gl.ARRAY_BUFFER, bytes.subarray(vertices, vertices + vertexCount * VERTEX_BYTES), gl.STREAM_DRAW);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, bytes.subarray(indices, indices + indexCount * 2), gl.STREAM_DRAW);
    }

    panelTriangles(texture, firstIndex, count, left, top, right, bottom) {
        const gl = this.#gl;
        const height = this.#canvas.height;
        const [x, y] = [Math.max(0, left), Math.max(0, height - bottom)];
        const [width, rows] = [Math.min(right, this.#canvas.width) - x, height - Math.max(0, top) - y];
        if (width <= 0 || rows <= 0)
            return;
        gl.scissor(x, y, width, rows);
        gl.bindTexture(gl.TEXTURE_2D, this.textures.get(texture));
        gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_SHORT, firstIndex * 2);
    }

    setBlending(on) {
        if (on)
            this.#gl.enable(this.#gl.BLEND);
        else
            this.#gl.disable(this.#gl.BLEND);
    }

    readPanels(pixels, width, height) {
        const gl = this.#gl;
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE,
            this.#bytes().subarray(pixels, pixels + width * height * 4));
    }
}
