// The texels of a texture object, in JavaScript.

#include "texplorer/emit/webgl.h"
#include "texplorer/gl/core_format.h"
#include "texplorer/s3tc/decode.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/text/base64.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// A base64 text in rows between back quotes; the spaces mean nothing.
std::string quoted(ByteView bytes) {
    constexpr std::size_t columns = 112;
    const std::string all = base64(bytes);
    if (all.size() <= columns)
        return "\"" + all + "\"";
    std::string text = "`";
    for (std::size_t at = 0; at < all.size(); at += columns)
        text += "\n    " + all.substr(at, columns);
    return text + "`";
}

/// What keep() is given; empty: the texels as they are.
std::string_view keptOf(BaseFormat format) {
    switch (format) {
    case BaseFormat::Alpha:
        return "000a";
    case BaseFormat::Luminance:
        return "rrr1";
    case BaseFormat::LuminanceAlpha:
        return "rrra";
    case BaseFormat::Intensity:
        return "rrrr";
    case BaseFormat::Rgb:
        return "rgb1";
    case BaseFormat::Rgba:
        break;
    }
    return {};
}

/// Blocks as pixels, each face after the other.
Bytes decoded(const LevelCode& level, BlockFormat format, int faces) {
    Bytes texels;
    const std::size_t size = level.bytes.size() / static_cast<std::size_t>(faces);
    for (int face = 0; face < faces; ++face) {
        BlockImage image = BlockImage::uninitialised(format, level.width, level.height);
        const auto from = level.bytes.begin() + static_cast<std::ptrdiff_t>(size) * face;
        std::copy(from, from + static_cast<std::ptrdiff_t>(size), image.blocks.begin());
        const Image pixels = decodeBlocks(image);
        texels.insert(texels.end(), pixels.pixels.begin(), pixels.pixels.end());
    }
    return texels;
}

class WebTexelWriter {
public:
    WebTexelWriter(Emission& emission, const Holder& holder, const TextureCode& code)
        : writer_(emission.writer)
        , holder_(holder)
        , code_(code)
        , isDepth_(isDepth(code.shape.internalFormat)) {}

    void write() {
        for (const LevelGroup& group : groupsOf(code_))
            writeGroup(group);
    }

private:
    void writeGroup(const LevelGroup& group) {
        const LevelCode& level = group.first();
        const std::string name = "texels" + suffix(level);
        writer_.add(fmt::format("const {} = {}; // {}", name, made(level),
                                isDepth_ ? "depths, the bottom row first"
                                         : "red, green, blue, alpha: the bottom row first"));
        std::string texels = name;
        if (code_.faces > 1) {
            const int size = level.width * level.height * (isDepth_ ? 1 : 4);
            writer_.add("for (let face = 0; face < 6; ++face) {");
            writer_.indent();
            texels = fmt::format("{}.subarray(face * {}, (face + 1) * {})", name, size, size);
        }
        if (group.isOne())
            upload(std::to_string(level.number), std::to_string(level.width), std::to_string(level.height),
                   level.depth, texels);
        else
            writeHalved(group, texels);
        if (code_.faces > 1) {
            writer_.outdent();
            writer_.add("}");
        }
    }

    void writeHalved(const LevelGroup& group, const std::string& texels) {
        const LevelCode& level = group.first();
        const std::string image = "image" + suffix(level);
        writer_.add(fmt::format("let {} = {{width: {}, height: {}, texels: {}}};", image, level.width,
                                level.height, texels));
        writer_.add(fmt::format("for (let level = {}; level <= {}; ++level) {{", level.number, group.last()));
        writer_.indent();
        if (group.missing >= 0) {
            writer_.add(fmt::format("if (level !== {}) // this one is missing", group.missing));
            writer_.indent();
        }
        upload("level", image + ".width", image + ".height", 1, image + ".texels");
        if (group.missing >= 0)
            writer_.outdent();
        writer_.add(fmt::format("{0} = halve({0}); // the next mip level", image));
        writer_.outdent();
        writer_.add("}");
    }

    /// Of the names of its variables.
    [[nodiscard]] std::string suffix(const LevelCode& level) const {
        return &level == &code_.levels.front() ? std::string() : std::to_string(level.number);
    }

    /// The call that makes them.
    [[nodiscard]] std::string made(const LevelCode& level) const {
        const int count = level.width * level.height * level.depth * code_.faces;
        const auto& color = level.color;
        switch (level.source) {
        case TexelSource::Checker:
            return fmt::format("checkerboard({}, {}, {}, {}, {})", level.width, level.square, color[0],
                               color[1], color[2]);
        case TexelSource::Gradient:
            return "gradient()";
        case TexelSource::Flat:
            return fmt::format("fill({}, {}, {}, {}, {})", count, color[0], color[1], color[2], color[3]);
        case TexelSource::Depths:
            return fmt::format("new Uint32Array(bytes({}).buffer)", quoted(level.bytes));
        case TexelSource::Compressed:
            return fmt::format("unpack(bytes({}), {})",
                               quoted(packed(decoded(level, *code_.blocks, code_.faces))), count);
        case TexelSource::Listed: {
            std::string numbers;
            for (const std::byte each : level.bytes)
                numbers += fmt::format("{}{}", numbers.empty() ? "" : ", ", std::to_integer<int>(each));
            return fmt::format("new Uint8Array([{}])", numbers);
        }
        default:
            return fmt::format("unpack(bytes({}), {})", quoted(level.bytes), count);
        }
    }

    void upload(const std::string& level, const std::string& width, const std::string& height, int depth,
                const std::string& texels) {
        const std::string_view kept = isDepth_ ? std::string_view() : keptOf(code_.shape.format);
        const std::string given = kept.empty() ? texels : fmt::format("keep({}, \"{}\")", texels, kept);
        const std::string aim = code_.faces > 1 ? std::string("gl.TEXTURE_CUBE_MAP_POSITIVE_X + face")
                                                : std::string(rowOf(holder_.target).name);
        const std::string_view stored = isDepth_ ? rowOf(code_.shape.internalFormat).name
                                        : isSrgb(code_.shape.internalFormat)
                                            ? std::string_view("gl.SRGB8_ALPHA8")
                                            : std::string_view("gl.RGBA8");
        const bool isVolume = holder_.target == Target::Texture3D;
        writer_.add(fmt::format("gl.texImage{}D({}, {}, {}, {}, {}, {}0, {}, {}, {});", isVolume ? 3 : 2, aim,
                                level, stored, width, height,
                                isVolume ? fmt::format("{}, ", depth) : std::string(),
                                isDepth_ ? "gl.DEPTH_COMPONENT" : "gl.RGBA",
                                isDepth_ ? "gl.UNSIGNED_INT" : "gl.UNSIGNED_BYTE", given));
    }

    CodeWriter& writer_;
    const Holder& holder_;
    const TextureCode& code_;
    bool isDepth_;
};

/// Room for what the light sees, and the framebuffer object that it is drawn into.
void writeWebDepths(Emission& emission, const Texture& texture, Target target, std::size_t object) {
    CodeWriter& writer = emission.writer;
    writer.add(fmt::format("gl.texStorage2D({}, 1, {}, {}, {});", rowOf(target).name,
                           rowOf(texture.internalFormat).name, texture.depthSize, texture.depthSize));
    emission.atStart.add(fmt::format("let shadowMap{}; // a framebuffer object", object));
    writer.add(fmt::format("shadowMap{} = gl.createFramebuffer();", object));
    writer.add(fmt::format("gl.bindFramebuffer(gl.FRAMEBUFFER, shadowMap{});", object));
    writer.add(
        fmt::format("gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, {}, textures[{}], 0);",
                    rowOf(target).name, object));
    writer.add("gl.bindFramebuffer(gl.FRAMEBUFFER, null);");
}

} // namespace

void writeWebTexels(Emission& emission, const Holder& holder, std::size_t object) {
    const Texture& texture = emission.scene.textures[emission.objects[object].texture];
    const TextureCode& code = **emission.texels[object];
    if (texture.source == SourceKind::LightDepth)
        return writeWebDepths(emission, texture, holder.target, object);
    WebTexelWriter(emission, holder, code).write();
}

std::string base64Text(ByteView bytes) {
    return quoted(bytes);
}

} // namespace texplorer::emit
