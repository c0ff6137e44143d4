// WebGL 2 in a page of HTML that needs no other file.

#include "core/base/html.h"
#include "core/base/printable.h"
#include "core/emit/js_functions.h"
#include "core/emit/webgl.h"
#include "core/gl/fragment.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <regex>

namespace texplorer::emit {
namespace {

/// "Matrix projection, Matrix modelView" as "projection, modelView".
std::string namesAlone(const std::string& parameters) {
    std::string names;
    for (std::size_t at = 0; at < parameters.size();) {
        const std::size_t end = std::min(parameters.find(',', at), parameters.size());
        const std::string one = parameters.substr(at, end - at);
        const std::size_t space = one.rfind(' ');
        if (space != std::string::npos)
            names += (names.empty() ? "" : ", ") + one.substr(space + 1);
        at = end + 1;
    }
    return names;
}

/// Lines of C as JavaScript; a brace stands on the line of its function.
std::vector<Line> scriptOf(std::vector<Line> lines) {
    static const std::regex head(R"(static void (\w+)\((.*)\))", std::regex::optimize);
    std::vector<Line> script;
    for (Line& given : lines) {
        if (!given.needed && !given.heading)
            continue;
        Line line = asJavaScript(std::move(given));
        const std::string text = textOf(line);
        std::smatch found;
        if (text == "{" && !script.empty()) {
            script.back().parts.push_back(plain(" {"));
            continue;
        }
        if (text.starts_with("static void") && std::regex_match(text, found, head))
            line.parts = {plain(fmt::format("function {}({})", found[1].str(), namesAlone(found[2].str())))};
        script.push_back(std::move(line));
    }
    return script;
}

bool readsTargetAlpha(const Scene& scene) {
    return std::ranges::any_of(scene.passes, [](const Pass& pass) {
        const auto reads = [](auto factor) {
            const std::string_view name = rowOf(factor).name;
            return name.find("DST_ALPHA") != std::string_view::npos ||
                   name.find("SATURATE") != std::string_view::npos;
        };
        return pass.enabled && pass.blend && (reads(pass.blendSrc) || reads(pass.blendDst));
    });
}

constexpr std::string_view pageHead = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width">
<title>{0}</title>
<style>
html, body {{ height: 100%; margin: 0; background: #222; color: #eee; font-family: sans-serif; }}
canvas {{ display: block; width: 100%; height: 100%; touch-action: none; }}
p {{ padding: 1em; }}
</style>
</head>
<body>
<canvas id="canvas" tabindex="0" role="img" aria-label="{0}. Drag it or use the arrow keys to turn the view; plus and minus go nearer and farther."></canvas>
<p id="problem" role="alert" hidden></p>
<script>
"use strict";
)";

constexpr std::string_view pageHandlers = R"(
// Dragging turns the view, the wheel goes nearer; keys do the same.
canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
canvas.addEventListener("pointermove", (event) => {
    if (event.buttons & 1) turn(-event.movementX / 2, event.movementY / 2, 1);
});
canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    turn(0, 0, 0.9 ** (-event.deltaY / 100));
}, {passive: false});
canvas.addEventListener("keydown", (event) => {
    const steps = {
        ArrowLeft: [5, 0, 1], ArrowRight: [-5, 0, 1], ArrowUp: [0, -5, 1], ArrowDown: [0, 5, 1],
        "+": [0, 0, 0.9], "-": [0, 0, 1 / 0.9],
    };
    if (steps[event.key]) turn(...steps[event.key]);
});

function turn(aside, upwards, farther) {
    azimuth += aside;
    elevation += upwards;
    distance *= farther;
    redraw();
}

// As many pixels as the screen has where the canvas is.
function resize() {
    const width = Math.max(1, Math.round(canvas.clientWidth * devicePixelRatio));
    const height = Math.max(1, Math.round(canvas.clientHeight * devicePixelRatio));
    if (canvas.width === width && canvas.height === height) return;
    canvas.width = width;
    canvas.height = height;
    redraw();
}
)";

constexpr std::string_view movingFrames = R"(
function redraw() {} // the next frame comes anyway

function frame(milliseconds) {
    draw(canvas.width, canvas.height, milliseconds / 1000);
    requestAnimationFrame(frame);
}
)";

constexpr std::string_view stillFrames = R"(
// Nothing moves by itself: a frame is drawn where something has changed.
let isAsked = false;
function redraw() {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(frame);
}

function frame() {
    isAsked = false;
    draw(canvas.width, canvas.height);
}
)";

constexpr std::string_view opaque = R"(
// Blending needs alpha while it draws; the page isn't to shine through what it leaves.
function makeOpaque() {{
    gl.colorMask(false, false, false, true);
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT);
    gl.colorMask(true, true, true, true);
    gl.clearColor({}, {}, {}, {});
}}
)";

constexpr std::string_view pageStart = R"(
try {
    if (!gl) throw new Error("This page needs WebGL 2, which the browser doesn't offer.");
    init();
    resize();
    new ResizeObserver(resize).observe(canvas);
    requestAnimationFrame(frame);
} catch (error) {
    canvas.style.display = "none";
    const problem = document.getElementById("problem");
    problem.textContent = error.message;
    problem.hidden = false;
}
</script>
</body>
</html>
)";

/// Nothing within a script ends it.
std::string withinScript(std::string text) {
    for (const auto& [word, with] :
         {std::pair<std::string_view, std::string_view>{"</", "<\\/"}, {"<!--", "<\\!--"}}) {
        for (std::size_t at = text.find(word); at != std::string::npos;
             at = text.find(word, at + with.size()))
            text.replace(at, word.size(), with);
    }
    return text;
}

std::string withoutLine(std::string_view words) {
    std::string text = printable(words);
    std::ranges::replace(text, '\n', ' ');
    return text;
}

/// In rows of a hundred letters; nothing of nothing.
std::string commentOf(std::string_view words) {
    constexpr std::size_t columns = 100;
    std::string rest = withoutLine(words);
    std::string text;
    while (!rest.empty()) {
        std::size_t cut = rest.size();
        if (rest.size() > columns)
            cut = std::min(rest.rfind(' ', columns), rest.size());
        text += "// " + rest.substr(0, cut) + "\n";
        rest.erase(0, std::min(cut + 1, rest.size()));
    }
    return text;
}

} // namespace

std::vector<Line> webPage(Emission&& emission) {
    const ProgramOptions& options = emission.options;
    std::vector<Line> script = scriptOf(std::move(emission.atStart).take());
    std::ranges::move(scriptOf(std::move(emission.writer).take()), std::back_inserter(script));
    std::vector<Line> data = scriptOf(std::move(emission.atEnd).take());
    finish(script);
    std::string words = textOf(script, false) + textOf(data, false);
    std::string text = fmt::format(pageHead, escapedHtml(withoutLine(options.title)));
    std::string first = commentOf(options.title) + commentOf(options.about);
    const bool readsAlpha = readsTargetAlpha(emission.scene);
    first += "const canvas = document.getElementById(\"canvas\");\n";
    first += fmt::format("const gl = canvas.getContext(\"webgl2\", {{alpha: {}, antialias: false}});\n",
                         readsAlpha);
    if (words.find("anisotropic.") != std::string::npos)
        first += "const anisotropic = gl && gl.getExtension(\"EXT_texture_filter_anisotropic\");\n";
    text += withinScript(first);
    text += withinScript("\n" + jsFunctionsFor(words));
    text += withinScript(words);
    text += pageHandlers;
    std::string frames(emission.moves ? movingFrames : stillFrames);
    if (readsAlpha) {
        const glm::vec4& background = emission.scene.view.background;
        text += fmt::format(opaque, background.r, background.g, background.b, background.a);
        const std::size_t end = frames.find(");\n", frames.find("draw(canvas"));
        frames.insert(end + 3, "    makeOpaque();\n");
    }
    text += frames;
    text += pageStart;
    std::vector<Line> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back({{plain(text.substr(at, end - at))}});
        at = end + 1;
    }
    return lines;
}

} // namespace texplorer::emit
