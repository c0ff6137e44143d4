// The texels of a texture object: what glTexImage is given.

#include "core/emit/emission.h"
#include "core/gl/argument_names.h"
#include "core/gl/pixel_transfer.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::emit {
namespace {

/// The step that can be left to the upload, after all others: nothing is done to the image between.
const ImageStep* lastScale(const Texture& texture) {
    const bool isLast = !texture.preparation.empty() && texture.preparation.back().op == ImageOp::Scale &&
                        texture.transparency == Transparency::File;
    return isLast ? &texture.preparation.back() : nullptr;
}

/// Sets what isn't initial, or sets it back.
void writeTransfer(CodeWriter& writer, const ImageStep& step, const std::string& path, bool back) {
    constexpr int components = 4;
    const auto write = [&](glm::vec4 amounts, float initial, std::size_t firstRow, const std::string& key) {
        for (int i = 0; i < components; ++i) {
            if (amounts[i] == initial)
                continue;
            const std::string own = fmt::format("{}.{}", path, key);
            const std::string_view name = pixelTransferRows.at(firstRow + static_cast<std::size_t>(i)).name;
            writer.add(callWith("glPixelTransferf", {plain(fmt::format("{}, ", name)),
                                                     back ? number(initial) : number(amounts[i], own, i)}));
        }
    };
    write(step.factor, 1, 0, keyOf<&ImageStep::factor>());
    write(step.bias, 0, components, keyOf<&ImageStep::bias>());
}

/// Where the texels of an image come from, as a comment.
std::string originOf(SourceKind source, Pattern pattern, const std::string& file, bool isUpright) {
    if (source == SourceKind::Pattern)
        return fmt::format("the pattern \"{}\", bottom row first", rowOf(pattern).name);
    return isUpright ? fmt::format("\"{}\", bottom row first", file)
                     : fmt::format("\"{}\", rows in the order of the file", file);
}

/// The names of what is declared for one image, or for all levels of it.
struct ImageNames {
    std::string name;  ///< "texture0"
    std::string level; ///< what stands for the level's number
    std::string index; ///< of the level among its arrays, "[level]"; empty: there is one
};

class ImageWriter {
public:
    ImageWriter(Emission& emission, const Holder& holder, std::size_t index)
        : writer_(emission.writer)
        , holder_(holder)
        , texture_(emission.scene.textures[index]) {}

    void write() {
        const ImageStep* scale = lastScale(texture_);
        const std::string step = fmt::format(
            "{}.{}", holder_.path,
            elementOf<&Texture::preparation>(std::max<std::size_t>(texture_.preparation.size(), 1) - 1));
        if (scale)
            writeTransfer(writer_, *scale, step, false);
        if (texture_.source == SourceKind::LightDepth)
            writeLightDepth();
        else if (texture_.mipmaps == MipPolicy::Given)
            writeGiven();
        else if (texture_.mipmaps == MipPolicy::None || isGeneratedByGl())
            writeOne();
        else
            writeAll();
        if (scale)
            writeTransfer(writer_, *scale, step, true);
    }

private:
    [[nodiscard]] bool isOfDepths() const { return isDepth(texture_.internalFormat); }
    [[nodiscard]] bool isCube() const { return holder_.target == Target::CubeMap; }
    /// Blocks are made before they are uploaded. OpenGL has none of lines and volumes.
    [[nodiscard]] bool hasBlocks() const {
        return texture_.compression == Compression::Cached && axesOf(holder_.target) == 2 && !isOfDepths() &&
               texture_.source != SourceKind::LightDepth;
    }
    [[nodiscard]] bool isGeneratedByGl() const {
        return texture_.mipmaps == MipPolicy::Generated && texture_.mipFilter == MipFilter::Box &&
               !texture_.mipGamma && !hasBlocks() && !isOfDepths();
    }
    [[nodiscard]] std::string origin() const {
        const bool isUpright = texture_.flip == FlipMode::Blocks || texture_.flip == FlipMode::Pixels;
        const std::string from = originOf(texture_.source, texture_.pattern, texture_.file, isUpright);
        const std::size_t steps = texture_.preparation.size() - (lastScale(texture_) ? 1 : 0);
        return steps == 0 ? from : fmt::format("{}, after its preparation", from);
    }

    /// "extern const GLsizei texture0Width, texture0Height;" and the texels, with where they come from.
    void declare(const ImageNames& names, const std::string& from) {
        const bool many = !names.index.empty();
        const std::string sizes = many ? "s[]" : "";
        std::string extents = fmt::format("extern const GLsizei {0}Width{1}", names.name, sizes);
        if (axesOf(holder_.target) > 1)
            extents += fmt::format(", {0}Height{1}", names.name, sizes);
        if (axesOf(holder_.target) > 2)
            extents += fmt::format(", {0}Depth{1}", names.name, sizes);
        if (hasBlocks())
            extents += fmt::format(", {0}ByteCount{1}", names.name, sizes);
        if (many)
            extents += fmt::format("; extern const GLint {}LevelCount", names.name);
        writer_.add(extents + ";");
        const std::string_view element = isOfDepths() ? "GLuint" : "GLubyte";
        const std::string_view what = hasBlocks() ? "Blocks" : "Texels";
        const std::string type =
            many || isCube() ? fmt::format("const {}* const", element) : fmt::format("const {}", element);
        const std::string brackets =
            fmt::format("{}{}", many || !isCube() ? "[]" : "", isCube() ? "[6]" : "");
        writer_.add({plain(fmt::format("extern {} {}{}{}; ", type, names.name, what, brackets)),
                     {Part::Kind::Comment, fmt::format("/* {} */", inComment(from)),
                      fmt::format("{}.{}", holder_.path, sourceKey())}});
    }

    [[nodiscard]] const std::string& sourceKey() const {
        return texture_.source == SourceKind::Pattern ? keyOf<&Texture::pattern>() : keyOf<&Texture::file>();
    }

    /// The row whose call uploads, and with whose value.
    [[nodiscard]] const ParamRow& uploadRow() const {
        const bool isCompressed =
            (texture_.compression == Compression::Driver || hasBlocks()) && !isOfDepths();
        const std::string& key =
            isCompressed ? keyOf<&Texture::compressedFormat>() : keyOf<&Texture::internalFormat>();
        return *findParam(textureTable(), key);
    }

    /// glTexImage with all of its arguments.
    [[nodiscard]] std::vector<Part> upload(const ImageNames& names,
                                           const std::vector<Part>& size = {}) const {
        const ParamRow& row = uploadRow();
        const auto pathOf = [&](std::string_view key) { return fmt::format("{}.{}", holder_.path, key); };
        const EnumRow* format = findRow(row.choices, std::get<EnumValue>(row.read(&texture_)).number);
        const Part stored = choice(format ? format->name : rowOf(InternalFormat::Rgba).name, pathOf(row.key));
        const auto own = [&](std::string_view what) {
            return fmt::format("{}{}{}{}", names.name, what, names.index.empty() ? "" : "s", names.index);
        };
        const auto extent = [&](std::string_view what) {
            return size.empty() ? std::vector<Part>{plain(own(what))} : size;
        };
        const std::string pixels =
            !size.empty() ? std::string("NULL")
                          : fmt::format("{}{}{}{}", names.name, hasBlocks() ? "Blocks" : "Texels",
                                        names.index, isCube() ? "[face]" : "");
        const std::string words = callFor(row, holder_.target);
        const std::size_t bracket = words.find('(');
        std::vector<Part> parts{call(words.substr(0, bracket))};
        const auto resolve = [&](std::string_view word) -> std::optional<std::vector<Part>> {
            if (word == "{}")
                return std::vector<Part>{stored};
            if (word == "level")
                return std::vector<Part>{plain(names.level)};
            if (word == "width")
                return extent("Width");
            if (word == "height")
                return extent("Height");
            if (word == "depth")
                return size.empty() ? extent("Depth") : std::vector<Part>{plain("1")};
            if (word == keyOf<&Texture::border>())
                return std::vector<Part>{whole(texture_.border, pathOf(word))};
            if (word == "format")
                return std::vector<Part>{
                    plain(std::string(isOfDepths() ? depthPixels : rowOf(BaseFormat::Rgba).name))};
            if (word == unsignedByteType)
                return std::vector<Part>{
                    plain(std::string(isOfDepths() ? unsignedIntType : unsignedByteType))};
            if (word == "pixels")
                return std::vector<Part>{plain(pixels)};
            return std::nullopt;
        };
        if (!hasBlocks()) {
            append(parts, filled(words.substr(bracket) + ";", resolve));
            return parts;
        }
        const std::string image = words.substr(bracket + 1, words.find(',') - bracket - 1);
        return callWith("glCompressedTexImage2D",
                        {plain(fmt::format("{}, {}, ", image, names.level)), stored,
                         plain(fmt::format(", {}, {}, 0, {}, {}", own("Width"), own("Height"),
                                           own("ByteCount"), pixels))});
    }

    /// The call, for each face of a cube map.
    void add(std::vector<Part> parts, std::string inset = {}) {
        if (isCube()) {
            writer_.add(inset + "for (GLenum face = 0; face < 6; ++face)");
            inset += "    ";
        }
        if (!inset.empty())
            parts.insert(parts.begin(), plain(std::move(inset)));
        writer_.add(std::move(parts));
    }

    void writeOne() {
        const ImageNames names{holder_.variable, "0", {}};
        declare(names, origin());
        if (isGeneratedByGl())
            writer_.add(
                {call("glTexParameteri"), plain(fmt::format("({}, GL_GENERATE_MIPMAP, {});",
                                                            rowOf(holder_.target).name, booleanName(true)))});
        add(upload(names));
    }

    void writeAll() {
        const ImageNames names{holder_.variable, "level", "[level]"};
        const EnumRow& policy = rowOf(texture_.mipmaps);
        declare(names, fmt::format("{}; mip levels: {}", origin(), policy.label));
        writer_.add(fmt::format("for (GLint level = 0; level < {}LevelCount; ++level)", names.name));
        add(upload(names), "    ");
    }

    void writeGiven() {
        const ImageNames base{holder_.variable, "0", {}};
        declare(base, origin());
        add(upload(base));
        for (std::size_t i = 0; i < texture_.levels.size(); ++i) {
            const GivenLevel& level = texture_.levels[i];
            const ImageNames names{
                fmt::format("{}Level{}", holder_.variable, i + 1), fmt::format("{}", i + 1), {}};
            declare(names, originOf(level.source, level.pattern, level.file, true));
            add(upload(names));
        }
    }

    /// An image that is drawn anew in every frame.
    void writeLightDepth() {
        const std::string path = fmt::format("{}.{}", holder_.path, keyOf<&Texture::depthSize>());
        writer_.comment(
            "in every frame: draw what the light sees and copy its depths, with glCopyTexSubImage2D");
        add(uploadWithoutTexels(whole(texture_.depthSize, path)));
    }

    [[nodiscard]] std::vector<Part> uploadWithoutTexels(const Part& size) const {
        return upload({holder_.variable, "0", {}}, {size});
    }

    CodeWriter& writer_;
    const Holder& holder_;
    const Texture& texture_;
};

} // namespace

void writeImages(Emission& emission, const Holder& holder, std::size_t texture) {
    ImageWriter(emission, holder, texture).write();
}

} // namespace texplorer::emit
