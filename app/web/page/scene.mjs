// Draws the scene with WebGL 2: the functions that app/gles asks for (browser.h), each a call or two.

const UNIFORMS = ['uniform1iv', 'uniform1fv', 'uniform3fv', 'uniform4fv', 'uniformMatrix3fv', 'uniformMatrix4fv', 'uniform4iv'];
const WIDTHS = [1, 1, 3, 4, 9, 16, 4]; // numbers of a value, by UniformKind

export class SceneDevice {
    #gl;
    #memory; // () → ArrayBuffer of the program
    #textures; // shared with the panels, which show targets
    #decoder = new TextDecoder();
    #encoder = new TextEncoder();
    #buffers = new Map();
    #programs = new Map();
    #targets = new Map();
    #last = 0;
    #log = '';
    #array;
    #program = null;
    #maxTextureSize = 2048; // what WebGL 2 promises
    #maxPointSize = 1;

    constructor(gl, textures, memory) {
        this.#gl = gl;
        this.#textures = textures;
        this.#memory = memory;
        this.restore();
    }

    // Call after the context was restored: there are no objects any more.
    restore() {
        this.#buffers.clear();
        this.#programs.clear();
        this.#targets.clear();
        const gl = this.#gl;
        this.#array = gl.createVertexArray();
        this.#maxTextureSize = gl.getParameter(gl.MAX_TEXTURE_SIZE) ?? this.#maxTextureSize;
        this.#maxPointSize = gl.getParameter(gl.ALIASED_POINT_SIZE_RANGE)?.[1] ?? this.#maxPointSize;
    }

    #bytes(at, length) { return new Uint8Array(this.#memory(), at, length); }
    #text(at, length) { return this.#decoder.decode(this.#bytes(at, length)); }

    maxTextureSize() { return this.#maxTextureSize; }
    maxPointSize() { return this.#maxPointSize; }

    makeTexels(at, width, height, floats) {
        const gl = this.#gl;
        const texture = gl.createTexture();
        if (!texture)
            return 0;
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        const count = width * height * 4;
        for (let i = 0; i < 16 && gl.getError() !== gl.NO_ERROR; ++i); // older ones
        if (floats)
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, new Float32Array(this.#memory(), at, count));
        else
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, this.#bytes(at, count));
        if (gl.getError() !== gl.NO_ERROR) {
            gl.deleteTexture(texture);
            return 0;
        }
        return this.#textures.add(texture);
    }

    makeBuffer(at, length, isIndices) {
        const gl = this.#gl;
        const target = isIndices ? gl.ELEMENT_ARRAY_BUFFER : gl.ARRAY_BUFFER;
        const buffer = gl.createBuffer();
        gl.bindBuffer(target, buffer);
        gl.bufferData(target, this.#bytes(at, length), gl.STATIC_DRAW);
        this.#buffers.set(++this.#last, buffer);
        return this.#last;
    }

    dropBuffer(name) {
        this.#gl.deleteBuffer(this.#buffers.get(name) ?? null);
        this.#buffers.delete(name);
    }

    makeProgram(vertexAt, vertexLength, fragmentAt, fragmentLength) {
        const gl = this.#gl;
        if (gl.isContextLost()) {
            this.#log = 'The browser has taken the graphics away.';
            return 0;
        }
        const program = gl.createProgram();
        this.#log = '';
        const stages = [[gl.VERTEX_SHADER, this.#text(vertexAt, vertexLength)], [gl.FRAGMENT_SHADER, this.#text(fragmentAt, fragmentLength)]];
        for (const [kind, source] of stages) {
            const shader = gl.createShader(kind);
            gl.shaderSource(shader, source);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
            if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
                this.#log += gl.getShaderInfoLog(shader) ?? '';
            gl.deleteShader(shader);
        }
        gl.linkProgram(program);
        if (!gl.getProgramParameter(program, gl.LINK_STATUS)) {
            this.#log ||= gl.getProgramInfoLog(program) || 'The browser gives no reason.';
            gl.deleteProgram(program);
            return 0;
        }
        this.#programs.set(++this.#last, { program, uniforms: new Map() });
        return this.#last;
    }

    programLog(at, room) {
        return this.#encoder.encodeInto(this.#log, this.#bytes(at, room)).written;
    }

    dropProgram(name) {
        this.#gl.deleteProgram(this.#programs.get(name)?.program ?? null);
        this.#programs.delete(name);
    }

    makeTarget(width, height) {
        const gl = this.#gl;
        const texture = gl.createTexture();
        const depth = gl.createRenderbuffer();
        const framebuffer = gl.createFramebuffer();
        if (!texture || gl.isContextLost())
            return 0;
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST); // a view may enlarge its pixels
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
        gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, width, height);
        gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT24, width, height);
        gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
        const complete = gl.checkFramebufferStatus(gl.FRAMEBUFFER) === gl.FRAMEBUFFER_COMPLETE;
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        const name = this.#textures.add(texture);
        this.#targets.set(name, { framebuffer, depth });
        if (!complete)
            this.dropTarget(name);
        return complete ? name : 0;
    }

    dropTarget(name) {
        const target = this.#targets.get(name);
        if (!target)
            return;
        this.#gl.deleteFramebuffer(target.framebuffer);
        this.#gl.deleteRenderbuffer(target.depth);
        this.#targets.delete(name);
        this.#textures.drop(name);
    }

    readTarget(name, at, width, height) {
        const gl = this.#gl;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.#targets.get(name)?.framebuffer ?? null);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, this.#bytes(at, width * height * 4));
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    }

    beginScene(name, width, height, red, green, blue, alpha) {
        const gl = this.#gl;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.#targets.get(name)?.framebuffer ?? null);
        gl.bindVertexArray(this.#array);
        gl.viewport(0, 0, width, height);
        gl.disable(gl.SCISSOR_TEST);
        gl.clearColor(red, green, blue, alpha);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    }

    setFragmentTests(depthTest, depthFunc, blend, source, destination) {
        const gl = this.#gl;
        (depthTest ? gl.enable(gl.DEPTH_TEST) : gl.disable(gl.DEPTH_TEST));
        gl.depthFunc(depthFunc);
        (blend ? gl.enable(gl.BLEND) : gl.disable(gl.BLEND));
        gl.blendFunc(source, destination);
    }

    useProgram(name) {
        this.#program = this.#programs.get(name) ?? null;
        this.#gl.useProgram(this.#program?.program ?? null);
    }

    setUniform(nameAt, nameLength, kind, at, count) {
        if (!this.#program)
            return;
        const name = this.#text(nameAt, nameLength);
        const { program, uniforms } = this.#program;
        if (!uniforms.has(name))
            uniforms.set(name, this.#gl.getUniformLocation(program, name));
        const location = uniforms.get(name);
        if (!location)
            return;
        const isWhole = kind === 0 || kind === 6;
        const values = new (isWhole ? Int32Array : Float32Array)(this.#memory(), at, WIDTHS[kind] * count);
        const set = UNIFORMS[kind];
        if (kind === 4 || kind === 5)
            this.#gl[set](location, false, values);
        else
            this.#gl[set](location, values);
    }

    setTexels(unit, texture) {
        const gl = this.#gl;
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, this.#textures.get(texture));
        gl.activeTexture(gl.TEXTURE0);
    }

    setAttribute(location, buffer, components, stride, offset) {
        const gl = this.#gl;
        gl.bindBuffer(gl.ARRAY_BUFFER, this.#buffers.get(buffer) ?? null);
        gl.enableVertexAttribArray(location);
        gl.vertexAttribPointer(location, components, gl.FLOAT, false, stride, offset);
    }

    setConstant(location, x, y, z, w) {
        this.#gl.disableVertexAttribArray(location);
        this.#gl.vertexAttrib4f(location, x, y, z, w);
    }

    drawParts(corners, indices, first, count) {
        const gl = this.#gl;
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.#buffers.get(indices) ?? null);
        gl.drawElements([gl.POINTS, gl.LINES, gl.TRIANGLES][corners - 1], count, gl.UNSIGNED_INT, first * 4);
    }

    endScene() {
        const gl = this.#gl;
        gl.bindVertexArray(null);
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.disable(gl.DEPTH_TEST);
    }
}
