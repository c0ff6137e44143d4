// WebGL 2 in a page of HTML that needs no other file.

#include "texplorer/emit/js_functions.h"
#include "texplorer/emit/piece_files.h"
#include "texplorer/emit/webgl.h"
#include "texplorer/gl/fragment.h"
#include "texplorer/text/html.h"
#include "texplorer/text/printable.h"

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

const std::string& pieceOf(std::string_view file) {
    return std::ranges::find(pageFiles(), file, &PieceFile::name)->text;
}

/// Nothing within a script ends it.
std::string withinScript(std::string text) {
    replaceAll(text, "</", "<\\/");
    replaceAll(text, "<!--", "<\\!--");
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
    std::string text = pieceOf("page.html");
    replaceAll(text, "TITLE", escapedHtml(withoutLine(options.title)));
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
    text += "\n" + pieceOf("handlers.js") + "\n";
    std::string frames = pieceOf(emission.moves ? "moving_frames.js" : "still_frames.js");
    if (readsAlpha) {
        text += pieceOf("make_opaque.js") + "\n";
        const std::size_t end = frames.find(");\n", frames.find("draw(canvas"));
        frames.insert(end + 3, "    makeOpaque();\n");
    }
    text += frames + "\n" + pieceOf("start.js");
    text += "</script>\n</body>\n</html>\n";
    std::vector<Line> lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back({{plain(text.substr(at, end - at))}});
        at = end + 1;
    }
    return lines;
}

} // namespace texplorer::emit
