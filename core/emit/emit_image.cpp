// The texels of a texture object: what glTexImage is given.

#include "texplorer/base/sentence_format.h"
#include "texplorer/emit/emission.h"
#include "texplorer/gl/argument_names.h"
#include "texplorer/gl/core_format.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace texplorer::emit {
namespace {

/// "64 * 64 * 4", without factors of 1.
std::string product(std::initializer_list<int> factors) {
    std::string text;
    for (const int factor : factors)
        text += factor == 1 ? std::string() : fmt::format("{}{}", text.empty() ? "" : " * ", factor);
    return text.empty() ? "1" : text;
}

std::string listed(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes)
        text += fmt::format("{}{}", text.empty() ? "" : ", ", byte);
    return text;
}

class TexelWriter {
public:
    TexelWriter(Emission& emission, const Holder& holder, const Texture& texture,
                std::shared_ptr<const Result<TextureCode>> code, bool isTransferred)
        : emission_(emission)
        , writer_(emission.writer)
        , holder_(holder)
        , texture_(texture)
        , owner_(std::move(code))
        , code_(**owner_)
        , isTransferred_(isTransferred) {}

    void write() {
        if (code_.reader == FileReader::Dds) {
            emission_.use(CFunction::ReadDds);
            return writer_.add(
                {plain("readDds("), path(),
                 plain(fmt::format(", {}, {}); ", code_.flipsBlocks ? 1 : 0, code_.firstLevel)),
                 comment(code_.firstLevel == 0 ? "every mip level" : "the smaller mip levels")});
        }
        const auto prepare = [&](bool isOver) {
            if (isTransferred_)
                writeTransfer(writer_, texture_.preparation.front(),
                              pathOf(elementOf<&Texture::preparation>(0)), isOver);
            if (code_.call)
                writeUnpacking(writer_, texture_.upload, pathOf(keyOf<&Texture::upload>()), isOver);
        };
        prepare(false);
        for (const LevelGroup& group : groupsOf(code_))
            writeGroup(group);
        if (code_.mipmaps != MipPolicy::GenerateMipmap)
            writeSubimages();
        prepare(true);
    }

private:
    [[nodiscard]] bool isCube() const { return code_.faces > 1; }

    void writeGroup(const LevelGroup& group) {
        const LevelCode& level = group.first();
        std::string texels = makeTexels(level, !group.isOne());
        if (group.isOne()) {
            const std::string number = std::to_string(level.number);
            if (code_.mipmaps == MipPolicy::Glu)
                return build(level, faceOf(texels, level));
            if (code_.mipmaps == MipPolicy::OnUpload)
                writer_.add({call("glTexParameteri"),
                             plain(fmt::format("({}, ", rowOf(holder_.target).name)),
                             choice(rowOf(code_.mipmaps).name, pathOf(keyOf<&Texture::mipmaps>())),
                             plain(", GL_TRUE); "),
                             {Part::Kind::Comment, "/* each upload of level 0 makes the others */"}});
            upload(number,
                   {std::to_string(level.width), std::to_string(level.height), std::to_string(level.depth)},
                   level, faceOf(texels, level));
            if (code_.mipmaps == MipPolicy::GenerateMipmap) {
                writeSubimages();
                writer_.add(
                    {{Part::Kind::Call, std::string(rowOf(code_.mipmaps).name),
                      pathOf(keyOf<&Texture::mipmaps>())},
                     plain(fmt::format("({}); ", rowOf(holder_.target).name)),
                     {Part::Kind::Comment, "/* makes the other levels; a function of OpenGL 3.0 */"}});
            }
            return;
        }
        emission_.use(CFunction::Halve);
        if (isCube()) {
            writer_.add("for (GLenum face = 0; face < 6; ++face) {");
            writer_.indent();
            writer_.add(fmt::format("GLubyte *image = {};", faceOf(texels, level)));
            texels = "image";
        }
        const bool isApart =
            !isCube() &&
            &level != &code_.levels.front(); // its variables have the names of others before them
        if (isApart) {
            writer_.add("{");
            writer_.indent();
        }
        writer_.add(fmt::format("GLsizei width = {}, height = {};", level.width, level.height));
        writer_.add(
            fmt::format("for (GLint level = {}; level <= {}; ++level) {{", level.number, group.last()));
        writer_.indent();
        if (group.missing >= 0) {
            writer_.add({plain(fmt::format("if (level != {}) ", group.missing)),
                         {Part::Kind::Comment, "/* this one is missing */"}});
            writer_.indent();
        }
        writer_.add(imageCall("level", {"width", "height", "1"}, texels));
        if (group.missing >= 0)
            writer_.outdent();
        writer_.add({plain(fmt::format("halve({}, &width, &height); ", texels)),
                     {Part::Kind::Comment, "/* the next mip level */"}});
        writer_.outdent();
        writer_.add("}");
        if (isCube() || isApart) {
            writer_.outdent();
            writer_.add("}");
        }
    }

    /// glTexSubImage, also where OpenGL refuses it.
    void writeSubimages() {
        for (const SubimageCode& each : code_.subimages) {
            const Subimage& subimage = texture_.subimages[each.index];
            const std::string path = pathOf(elementOf<&Texture::subimages>(each.index)) + ".";
            const std::string name = fmt::format("subimage{}", each.index);
            const std::string texels = makeTexels(
                each.texels, holder_.variable + "Subimage" + std::to_string(each.index), name, false, 1);
            const auto own = [&](int value, const std::string& key) { return whole(value, path + key); };
            const int axes = axesOf(holder_.target);
            std::vector<Part> arguments{
                isCube() ? plain(fmt::format("GL_TEXTURE_CUBE_MAP_POSITIVE_X + {}", subimage.z))
                         : plain(std::string(rowOf(holder_.target).name)),
                own(subimage.level, keyOf<&Subimage::level>()), own(subimage.x, keyOf<&Subimage::x>())};
            if (axes > 1)
                arguments.push_back(own(subimage.y, keyOf<&Subimage::y>()));
            if (axes > 2)
                arguments.push_back(own(subimage.z, keyOf<&Subimage::z>()));
            arguments.push_back(whole(each.texels.width));
            if (axes > 1)
                arguments.push_back(whole(each.texels.height));
            if (axes > 2)
                arguments.push_back(whole(each.texels.depth));
            std::vector<Part> parts{call(fmt::format("glTexSubImage{}D", axes)), plain("(")};
            for (Part& argument : arguments) {
                parts.push_back(std::move(argument));
                parts.push_back(plain(", "));
            }
            parts.push_back(
                plain(fmt::format("{}, {}, {});", rowOf(BaseFormat::Rgba).name, unsignedByteType, texels)));
            writer_.add(std::move(parts));
        }
    }

    /// Where the texels of a face begin.
    [[nodiscard]] std::string faceOf(const std::string& texels, const LevelCode& level) const {
        if (!isCube())
            return texels;
        const bool isWhole = level.source == TexelSource::Compressed || level.source == TexelSource::Memory;
        const std::size_t size = isWhole ? level.bytes.size() / 6 : 0;
        return fmt::format("{} + face * {}", texels,
                           size > 0 ? std::to_string(size) : product({level.width, level.height, 4}));
    }

    /// Makes them, and says what they are called; `changes`: they are overwritten by those of other levels.
    std::string makeTexels(const LevelCode& level, bool changes) {
        const bool isFirst = level.number == code_.levels.front().number;
        return makeTexels(
            level, isFirst ? holder_.variable : fmt::format("{}Level{}", holder_.variable, level.number),
            isFirst ? std::string("texels") : fmt::format("texels{}", level.number), changes, code_.faces);
    }

    /// The same; `own` is what its arrays outside the function are called, `variable` the one inside.
    std::string makeTexels(const LevelCode& level, const std::string& own, const std::string& variable,
                           bool changes, int faces) {
        const int count = level.width * level.height * level.depth * faces;
        if (level.source == TexelSource::Compressed) {
            const std::string name = own + "Blocks";
            emission_.addData("GLubyte", name, level.bytes.size(), numbersOf(level));
            return name;
        }
        if (level.source == TexelSource::Depths) {
            const std::string name = own + "Depths";
            emission_.addData("GLuint", name, level.bytes.size() / 4,
                              numbersOf(level, NumberType::UnsignedInt));
            return name;
        }
        if (level.source == TexelSource::Floats) {
            const std::string name = own + "Floats";
            emission_.addData("GLfloat", name, level.bytes.size() / 4, numbersOf(level, NumberType::Float));
            return name;
        }
        if (level.source == TexelSource::Memory)
            return writeMemory(emission_, {owner_, &level}, texture_.upload, own + "Memory");
        const std::string size = product({level.width, level.height, level.depth, faces, 4});
        if (level.source == TexelSource::Listed) {
            std::vector<std::uint8_t> bytes(level.bytes.size());
            std::ranges::transform(level.bytes, bytes.begin(),
                                   [](std::byte each) { return std::to_integer<std::uint8_t>(each); });
            writer_.add({plain(fmt::format("{}GLubyte {}[] = {{ ", changes ? "" : "const ", variable)),
                         comment(), plain("")});
            writer_.indent();
            const std::size_t row = std::size_t{4} * static_cast<std::size_t>(std::clamp(level.width, 1, 4));
            for (std::size_t at = 0; at < bytes.size(); at += row)
                writer_.add(fmt::format(
                    "{},", listed(std::span(bytes).subspan(at, std::min(row, bytes.size() - at)))));
            writer_.outdent();
            writer_.add("};");
            return variable;
        }
        writer_.add({plain(fmt::format("static GLubyte {}[{}]; ", variable, size)), comment()});
        switch (level.source) {
        case TexelSource::Read: {
            const bool isBmp = code_.reader == FileReader::Bmp;
            emission_.use(isBmp ? CFunction::ReadBmp : CFunction::ReadTga);
            writer_.add({plain(isBmp ? "readBmp(" : "readTga("), path(),
                         plain(fmt::format(", {}, {}, {});", level.width, level.height, variable))});
            break;
        }
        case TexelSource::Checker:
            emission_.use(CFunction::Checkerboard);
            writer_.add(fmt::format("checkerboard({}, {}, {}, {}, {}, {});", variable, level.width,
                                    level.square, level.color[0], level.color[1], level.color[2]));
            break;
        case TexelSource::Gradient:
            emission_.use(CFunction::Gradient);
            writer_.add(fmt::format("gradient({});", variable));
            break;
        case TexelSource::Flat:
            emission_.use(CFunction::Fill);
            writer_.add(fmt::format("fill({}, {}, {});", variable, count, listed(level.color)));
            break;
        default:
            emission_.use(CFunction::Unpack);
            emission_.addData("GLubyte", own + "Packed", level.bytes.size(), numbersOf(level));
            writer_.add(fmt::format("unpack({0}Packed, sizeof {0}Packed, {1});", own, variable));
            break;
        }
        return variable;
    }

    [[nodiscard]] Numbers numbersOf(const LevelCode& level, NumberType type = NumberType::Byte) const {
        return {[owner = owner_, &level, type] { return numbersText(level.bytes, type); },
                std::shared_ptr<const void>(owner_, &level)};
    }

    [[nodiscard]] Part
    comment(std::string_view words = "red, green, blue, alpha: the bottom row first") const {
        const std::string& key =
            texture_.source == SourceKind::Pattern ? keyOf<&Texture::pattern>() : keyOf<&Texture::file>();
        return {Part::Kind::Comment, fmt::format("/* {} */", words), fmt::format("{}.{}", holder_.path, key)};
    }

    /// The file that is read.
    [[nodiscard]] Part path() const {
        return {Part::Kind::Plain, stringLiteral(emission_.options.fileName(texture_.file)),
                pathOf(keyOf<&Texture::file>())};
    }

    void upload(const std::string& level, const std::array<std::string, 3>& size, const LevelCode& of,
                const std::string& texels) {
        if (isCube()) {
            writer_.add("for (GLenum face = 0; face < 6; ++face)");
            writer_.indent();
        }
        if (of.source == TexelSource::Compressed)
            writer_.add(compressedCall(of, texels));
        else
            writer_.add(imageCall(level, size, texels, of.source));
        if (isCube())
            writer_.outdent();
    }

    [[nodiscard]] std::string pathOf(std::string_view key) const {
        return fmt::format("{}.{}", holder_.path, key);
    }

    [[nodiscard]] std::vector<Part> compressedCall(const LevelCode& of, const std::string& texels) const {
        const std::string image = isCube() ? std::string("GL_TEXTURE_CUBE_MAP_POSITIVE_X + face")
                                           : std::string(rowOf(holder_.target).name);
        const EnumRow* row = findRow(blockFormatRows, static_cast<std::uint32_t>(*code_.blocks));
        return callWith(
            "glCompressedTexImage2D",
            {plain(fmt::format("{}, {}, ", image, of.number)),
             choice(row ? row->name : "0", texture_.compression == Compression::Cached
                                               ? pathOf(keyOf<&Texture::compressedFormat>())
                                               : std::string()),
             plain(fmt::format(", {}, {}, 0, {}, {}", of.width, of.height,
                               of.bytes.size() / static_cast<std::size_t>(code_.faces), texels))});
    }

    /// gluBuild2DMipmaps, for each face.
    void build(const LevelCode& level, const std::string& texels) {
        ParamRow row = formatRow();
        row.glCall = "gluBuild{n}DMipmaps({image}, {}, {extents}, format, GL_UNSIGNED_BYTE, pixels)";
        const std::array size{std::to_string(level.width), std::to_string(level.height),
                              std::to_string(level.depth)};
        if (isCube()) {
            writer_.add("for (GLenum face = 0; face < 6; ++face)");
            writer_.indent();
        }
        std::vector<Part> parts = imageCall(row, {}, size, texels);
        parts.front().path = pathOf(keyOf<&Texture::mipmaps>());
        writer_.add(std::move(parts));
        if (isCube())
            writer_.outdent();
    }

    /// Of an image of few bits drivers would store as few.
    [[nodiscard]] bool namesBits() const {
        return !emission_.isCore && !code_.driverCompresses && code_.call &&
               factsOf(code_.call->layout.type).isPacked();
    }
    [[nodiscard]] std::string uploadPath(const std::string& key) const {
        return fmt::format("{}.{}", pathOf(keyOf<&Texture::upload>()), key);
    }

    [[nodiscard]] ParamRow formatRow() const {
        return *findParam(textureTable(), code_.driverCompresses ? keyOf<&Texture::compressedFormat>()
                                                                 : keyOf<&Texture::internalFormat>());
    }

    /// glTexImage with all of its arguments.
    [[nodiscard]] std::vector<Part> imageCall(const std::string& level,
                                              const std::array<std::string, 3>& size,
                                              const std::string& texels,
                                              TexelSource source = TexelSource::Listed) const {
        return imageCall(formatRow(), level, size, texels, source);
    }

    /// The call of a row, with all of its arguments.
    [[nodiscard]] std::vector<Part> imageCall(const ParamRow& row, const std::string& level,
                                              const std::array<std::string, 3>& size,
                                              const std::string& texels,
                                              TexelSource source = TexelSource::Listed) const {
        const EnumRow* format = findRow(row.choices, std::get<EnumValue>(row.read(&texture_)).number);
        std::string words = callFor(row, holder_.target);
        const std::size_t bracket = words.find('(');
        const auto resolve = [&](std::string_view word) -> std::optional<std::vector<Part>> {
            if (word == "{}" && namesBits())
                return std::vector<Part>{
                    choice(rowOf(factsOf(texture_.internalFormat).sized).name, pathOf(row.key))};
            if (word == "{}")
                return std::vector<Part>{choice(emission_.isCore && !code_.driverCompresses
                                                    ? coreFormatOf(code_.shape.internalFormat).name
                                                : format ? format->name
                                                         : rowOf(InternalFormat::Rgba).name,
                                                pathOf(row.key))};
            if (word == "level")
                return std::vector<Part>{plain(level)};
            if (word == "width")
                return std::vector<Part>{plain(size[0])};
            if (word == "height")
                return std::vector<Part>{plain(size[1])};
            if (word == "depth")
                return std::vector<Part>{plain(size[2])};
            if (word == keyOf<&Texture::border>())
                return std::vector<Part>{code_.border == texture_.border || texture_.border > 1
                                             ? whole(texture_.border, pathOf(word))
                                             : whole(code_.border)};
            if (word == "format" && code_.call)
                return std::vector<Part>{
                    choice(rowOf(code_.call->layout.format).name, uploadPath(keyOf<&Upload::format>()))};
            if (word == unsignedByteType && code_.call)
                return std::vector<Part>{
                    choice(rowOf(code_.call->layout.type).name, uploadPath(keyOf<&Upload::type>()))};
            if (word == "format")
                return std::vector<Part>{plain(
                    std::string(source == TexelSource::Depths ? depthPixels : rowOf(BaseFormat::Rgba).name))};
            if (word == unsignedByteType)
                return std::vector<Part>{
                    plain(std::string(source == TexelSource::Depths   ? unsignedIntType
                                      : source == TexelSource::Floats ? rowOf(TransferType::Float).name
                                                                      : unsignedByteType))};
            if (word == "pixels")
                return std::vector<Part>{plain(texels)};
            return std::nullopt;
        };
        std::vector<Part> parts{call(words.substr(0, bracket))};
        append(parts, filled(words.substr(bracket) + ";", resolve));
        return parts;
    }

    Emission& emission_;
    CodeWriter& writer_;
    const Holder& holder_;
    const Texture& texture_;
    const std::shared_ptr<const Result<TextureCode>> owner_;
    const TextureCode& code_;
    bool isTransferred_;
};

/// Room for them, and the framebuffer object that they are drawn into.
void writeDepthsOfLight(Emission& emission, const Holder& holder, const Texture& texture,
                        std::size_t object) {
    CodeWriter& writer = emission.writer;
    const Part size =
        whole(texture.depthSize, fmt::format("{}.{}", holder.path, keyOf<&Texture::depthSize>()));
    writer.add({call("glTexImage2D"), plain(fmt::format("({}, 0, ", rowOf(holder.target).name)),
                choice(rowOf(texture.internalFormat).name,
                       fmt::format("{}.{}", holder.path, keyOf<&Texture::internalFormat>())),
                plain(", "), size, plain(", "), size,
                plain(fmt::format(", 0, {}, {}, NULL);", depthPixels, unsignedIntType))});
    emission.atStart.add({plain(fmt::format("static GLuint shadowMap{}; ", object)),
                          {Part::Kind::Comment, "/* a framebuffer object */"}});
    writer.add(fmt::format("glGenFramebuffers(1, &shadowMap{});", object));
    writer.add(fmt::format("glBindFramebuffer(GL_FRAMEBUFFER, shadowMap{});", object));
    writer.add(
        fmt::format("glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, {}, textures[{}], 0);",
                    rowOf(holder.target).name, object));
    writer.add("glDrawBuffer(GL_NONE); /* it has no colours */");
    writer.add("glReadBuffer(GL_NONE);");
    writer.add("glBindFramebuffer(GL_FRAMEBUFFER, 0);");
}

} // namespace

void writeTexels(Emission& emission, const Holder& holder, std::size_t object) {
    const auto& code = emission.texels[object];
    const Texture& texture = emission.scene.textures[emission.objects[object].texture];
    if (texture.source == SourceKind::LightDepth && !isShadowMap(emission, object))
        return emission.writer.comment("nothing shows it");
    if (texture.source == SourceKind::LightDepth)
        return writeDepthsOfLight(emission, holder, texture, object);
    if (texture.source == SourceKind::Picture)
        return writePictureRoom(emission, object);
    if (!code)
        return emission.writer.comment(texture.file.empty() ? "no file is chosen" : "the file isn't there");
    if (!*code)
        return emission.writer.comment((*code).error().message);
    TexelWriter(emission, holder, texture, code, emission.transferred.contains(object)).write();
}

} // namespace texplorer::emit
