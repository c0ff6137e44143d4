// Borders beyond the edge, which WebGL 2 has not: its shader mixes their colour in.

#include "texplorer/emit/code_writer.h"
#include "texplorer/emit/piece_files.h"
#include "texplorer/emit/webgl.h"
#include "texplorer/reference/sampling/comparison.h"
#include "texplorer/reference/sampling/lod.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

namespace texplorer::emit {
namespace {

bool averagesMinified(const Texture& texture) {
    return reference::isLinear(texture.minFilter);
}

bool averagesMagnified(const Texture& texture) {
    return texture.magFilter == MagFilter::Linear;
}

/// Whether what is read depends on how large the texels are on the screen.
bool asksForLambda(const Texture& texture) {
    return reference::wantsMipmaps(texture.minFilter) ||
           averagesMinified(texture) != averagesMagnified(texture);
}

std::string vec4Of(const glm::vec4& color) {
    const auto text = [](float number) { return literal(number, Literal::Double); };
    return fmt::format("vec4({}, {}, {}, {})", text(color.r), text(color.g), text(color.b), text(color.a));
}

/// The condition under which r passes against a depth of the border's.
std::string_view operatorOf(CompareFunc function) {
    switch (function) {
    case CompareFunc::Less:
        return "<";
    case CompareFunc::Equal:
        return "==";
    case CompareFunc::LessEqual:
        return "<=";
    case CompareFunc::Greater:
        return ">";
    case CompareFunc::NotEqual:
        return "!=";
    case CompareFunc::GreaterEqual:
        return ">=";
    case CompareFunc::Never:
    case CompareFunc::Always:
        break;
    }
    return {};
}

/// Which of s, t and r end at the border.
std::array<bool, 3> endsOf(const Texture& texture, Target target) {
    const auto ends = [&](Wrap wrap) {
        return wrap == Wrap::ClampToBorder || (wrap == Wrap::Clamp && !readsNearestAlone(texture));
    };
    if (target == Target::CubeMap)
        return {};
    return {ends(texture.wrapS), target != Target::Texture1D && ends(texture.wrapT),
            target == Target::Texture3D && ends(texture.wrapR)};
}

/// The lookup of one unit, in the place of the one that asks the sampler alone.
class BorderedLookup {
public:
    BorderedLookup(const Unit& unit, const glsl::SampledUnit& sampled, const Texture& texture,
                   const TextureCode& code, std::size_t index)
        : unit_(unit)
        , sampled_(sampled)
        , texture_(texture)
        , shape_(code.shape)
        , n_(std::to_string(index))
        , ended_(std::ranges::find(sampled.ends, true) != sampled.ends.end()) {
        reference::setParameters(shape_, texture, code.lastLevel);
    }

    [[nodiscard]] std::string text() const {
        std::string lines;
        if (!ended_)
            lines += fmt::format("    vec3 place{0} = texCoord{0}.stp / texCoord{0}.q;\n", n_);
        return lines + (sampled_.compares ? comparison() : colors());
    }

private:
    [[nodiscard]] std::string ends() const {
        const auto [s, t, r] = endsOf(texture_, unit_.target);
        return unit_.target == Target::Texture3D ? fmt::format("bvec3({}, {}, {})", s, t, r)
                                                 : fmt::format("bvec2({}, {})", s, t);
    }
    [[nodiscard]] std::string place(std::string_view name) const {
        switch (unit_.target) {
        case Target::Texture1D:
            return fmt::format("vec2({}{}.s, 0.0)", name, n_);
        case Target::Texture3D:
            return fmt::format("{}{}", name, n_);
        default:
            return fmt::format("{}{}.st", name, n_);
        }
    }

    [[nodiscard]] std::string comparison() const {
        const std::string_view compares = operatorOf(texture_.compareFunc);
        const std::string beyond = compares.empty()
                                       ? (texture_.compareFunc == CompareFunc::Always ? "1.0" : "0.0")
                                       : fmt::format("float(clamp(place{}.p, 0.0, 1.0) {} {:#})", n_,
                                                     compares, shape_.borderColor.r);
        const std::string asked = unit_.target == Target::Texture1D
                                      ? fmt::format("vec3(place{0}.s, 0.0, place{0}.p)", n_)
                                      : "place" + n_;
        return fmt::format("    float depth{0} = borderedDepth(texture{0}, {1}, {2}, {3}, {4});\n", n_, asked,
                           averagesMagnified(texture_), ends(), beyond);
    }

    [[nodiscard]] std::string colors() const {
        std::string lines = fmt::format("    vec4 border{} = {}; // GL_TEXTURE_BORDER_COLOR\n", n_,
                                        vec4Of(shape_.borderColor));
        std::string averages = averagesMagnified(texture_) ? "true" : "false";
        if (asksForLambda(texture_)) {
            lines += fmt::format("    float lambda{} = {};\n", n_, lambda());
            if (averagesMagnified(texture_) != averagesMinified(texture_))
                averages = fmt::format("lambda{} <= 0.0", n_);
        }
        const auto level = [&](std::string_view number) {
            return fmt::format("bordered(texture{0}, {1}, {2}, {3}, {4}, border{0})", n_,
                               place(ended_ ? "end" : "place"), number, averages, ends());
        };
        std::string texel = level("0.0");
        if (reference::wantsMipmaps(texture_.minFilter)) {
            const bool blends = reference::blendsLevels(texture_.minFilter);
            lines += fmt::format("    float level{0} = clamp({1}, 0.0, {2:#});\n", n_,
                                 blends ? "lambda" + n_ : fmt::format("ceil(lambda{} - 0.5)", n_),
                                 static_cast<float>(reference::lastMipLevel(shape_) - shape_.baseLevel));
            texel = level("level" + n_);
            if (blends)
                texel = fmt::format("mix({},\n        {}, fract(level{}))", level("floor(level" + n_ + ")"),
                                    level("ceil(level" + n_ + ")"), n_);
        }
        if (sampled_.hasDepths)
            return lines + fmt::format("    float depth{} = {}.r;\n", n_, texel);
        return lines + fmt::format("    vec4 texel{} = {};\n", n_, texel);
    }

    [[nodiscard]] std::string lambda() const {
        static const Texture initial;
        std::string text = fmt::format("lambda(texture{}, {})", n_, place("place"));
        if (unit_.lodBias != 0)
            text += " + lodBias" + n_;
        if (texture_.minLod != initial.minLod || texture_.maxLod != initial.maxLod)
            text = fmt::format("clamp({}, {:#}, {:#})", text, texture_.minLod, texture_.maxLod);
        return text;
    }

    const Unit& unit_;
    const glsl::SampledUnit& sampled_;
    const Texture& texture_;
    reference::SampledTexture shape_;
    std::string n_;
    bool ended_; ///< GL_CLAMP: the shader has the place and where it ends
};

/// A function of pictures for those of three dimensions.
std::string ofVolumes(std::string text) {
    replaceAll(text, "sampler2D", "sampler3D");
    replaceAll(text, "vec2", "vec3"); // and bvec2
    replaceAll(text, "within.s * within.t", "within.s * within.t * within.p");
    return text;
}

const std::string& shaderPiece(std::string_view file) {
    return std::ranges::find(pageFiles(), file, &PieceFile::name)->text;
}

} // namespace

bool hasBorder(const Texture& texture, Target target) {
    const std::array<bool, 3> ends = endsOf(texture, target);
    return std::ranges::find(ends, true) != ends.end();
}

Result<void> checkBorder(const Texture& texture, const glsl::SampledUnit& sampled, Wrap wrap,
                         const std::string& path, const std::string& key) {
    const std::string_view name = rowOf(wrap).name;
    if (texture.maxAnisotropy > 1)
        return refuse(
            Sentence("WebGL 2 has no {0}, and the page's shader can't replace it with anisotropy", name),
            path, key);
    if (averagesMinified(texture) && !averagesMagnified(texture))
        return refuse(
            Sentence("WebGL 2 has no {0}, and the page's shader can't replace it where only minification "
                     "averages",
                     name),
            path, key);
    if (sampled.compares && asksForLambda(texture))
        return refuse(Sentence("WebGL 2 has no {0}, and the page's shader can't replace it where depths are "
                               "compared at several levels",
                               name),
                      path, key);
    return {};
}

void writeBorders(const GlslEmission& glsl, GlslPass& pass) {
    const Scene& scene = glsl.emission.scene;
    std::string& text = pass.source.fragment.text;
    std::map<std::string_view, std::set<bool>> calls; // of functions of pictures, of volumes
    for (std::size_t i = 0; i < maxUnits; ++i) {
        const Unit& unit = scene.passes[pass.index].units[i];
        if (!pass.units[i] || !hasBorder(scene.textures[static_cast<std::size_t>(unit.texture)], unit.target))
            continue;
        const BorderedLookup lookup(unit, *pass.units[i],
                                    scene.textures[static_cast<std::size_t>(unit.texture)],
                                    *glsl.emission.codeOf(unit), i);
        const std::regex given(fmt::format(
            "(    float scale{0} = [^\n]*\n)?    (vec4 texel|float depth){0} = texture[^\n]*\n", i));
        const std::string lines = lookup.text();
        text = std::regex_replace(text, given, lines, std::regex_constants::format_first_only);
        for (const std::string_view name : {"lambda", "bordered", "borderedDepth"}) {
            if (lines.find(fmt::format("{}(", name)) != std::string::npos)
                calls[name].insert(unit.target == Target::Texture3D);
        }
    }
    std::string functions;
    for (const std::string_view name : {"lambda", "bordered", "borderedDepth"}) {
        const std::string file =
            name == "borderedDepth" ? "bordered_depth.glsl" : std::string(name) + ".glsl";
        if (calls[name].contains(false))
            functions += shaderPiece(file) + "\n";
        if (calls[name].contains(true))
            functions += ofVolumes(shaderPiece(file)) + "\n";
    }
    const std::size_t main = text.find("void main() {\n");
    text.insert(main, functions);
}

} // namespace texplorer::emit
