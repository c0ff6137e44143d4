#include "app/render/texture_object.h"

#include <fmt/core.h>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>

namespace texplorer::render {

namespace {

/// Requests the bits that its facts say on every driver. A format with few bits is requested by its own name:
/// the pixels have its precision already, so a driver with more bits stores the same values.
GLint sizedFormat(InternalFormat format) {
    return static_cast<GLint>(factsOf(format).sized);
}

GLenum pixelFormat(PixelFormat format) {
    switch (format) {
    case PixelFormat::Alpha8:
        return GL_ALPHA;
    case PixelFormat::Luminance8:
        return GL_LUMINANCE;
    case PixelFormat::LuminanceAlpha8:
        return GL_LUMINANCE_ALPHA;
    case PixelFormat::Rgb8:
        return GL_RGB;
    case PixelFormat::Rgba8:
    case PixelFormat::RgbaFloat:
        return GL_RGBA;
    case PixelFormat::Depth32:
        return GL_DEPTH_COMPONENT;
    }
    return GL_RGBA;
}

GLenum pixelType(PixelFormat format) {
    return format == PixelFormat::Depth32     ? GL_UNSIGNED_INT
           : format == PixelFormat::RgbaFloat ? GL_FLOAT
                                              : GL_UNSIGNED_BYTE;
}

/// What glTexImage is given of an image. The driver reads the memory of a custom upload itself.
struct Given {
    GLenum format;
    GLenum type;
    const std::byte* pixels;
};

Given givenOf(const Image& image) {
    return {pixelFormat(image.format), pixelType(image.format), image.pixels.data()};
}

Given givenOf(const Image& image, const UploadCall& call, const Bytes& memory) {
    // In place of GL_UNPACK_SKIP_ROWS and GL_UNPACK_SKIP_PIXELS: Mesa 22.3 skips wrongly when it swaps bytes
    // or scales as well.
    const ByteRange first = bytesOf(call, {image.width, image.height, image.depth}, 0, 0);
    return {static_cast<GLenum>(call.layout.format), static_cast<GLenum>(call.layout.type),
            memory.data() + first.first};
}

/// glPixelStore and glPixelTransfer as a custom upload wants them, set back at the end.
class PixelState {
public:
    explicit PixelState(const UploadCall& call) { set(call); }
    PixelState(const PixelState&) = delete;
    PixelState& operator=(const PixelState&) = delete;
    ~PixelState() { set({.unpacking = {.alignment = 1}}); }

private:
    static void set(const UploadCall& call) {
        constexpr std::array<GLenum, 4> scales{GL_RED_SCALE, GL_GREEN_SCALE, GL_BLUE_SCALE, GL_ALPHA_SCALE};
        constexpr std::array<GLenum, 4> biases{GL_RED_BIAS, GL_GREEN_BIAS, GL_BLUE_BIAS, GL_ALPHA_BIAS};
        glPixelStorei(GL_UNPACK_ALIGNMENT, effectiveAlignment(call.unpacking.alignment));
        glPixelStorei(GL_UNPACK_ROW_LENGTH, call.unpacking.rowLength);
        for (std::size_t i = 0; i < scales.size(); ++i) {
            glPixelTransferf(scales.at(i), call.scale[static_cast<int>(i)]);
            glPixelTransferf(biases.at(i), call.bias[static_cast<int>(i)]);
        }
    }
};

/// How much slower the driver compresses than it copies.
constexpr std::size_t driverSlowness = 8;

/// The target for glTexImage2D: each face has its own.
GLenum imageTarget(Target target, int face) {
    return static_cast<GLenum>(target == Target::CubeMap ? static_cast<std::uint32_t>(cubeFaceAt(face))
                                                         : static_cast<std::uint32_t>(target));
}

/// Returns the name of the call, for messages. Without pixels the level is allocated, but not filled.
const char* uploadImage(Target target, const TextureLevel& level, GLint stored, int border,
                        const Given& given) {
    const Image& image = std::get<Image>(*level.surface);
    const auto& [format, type, pixels] = given;
    const GLenum aim = imageTarget(target, level.face);
    switch (axesOf(target)) {
    case 1:
        glTexImage1D(aim, level.number, stored, image.width, border, format, type, pixels);
        return "glTexImage1D";
    case 2:
        glTexImage2D(aim, level.number, stored, image.width, image.height, border, format, type, pixels);
        return "glTexImage2D";
    default:
        glTexImage3D(aim, level.number, stored, image.width, image.height, image.depth, border, format, type,
                     pixels);
        return "glTexImage3D";
    }
}

const char* uploadMemory(Target target, const TextureLevel& level, GLint stored, int border,
                         const UploadCall& call) {
    const auto& image = std::get<Image>(*level.surface);
    const PixelState state(call);
    if (!call.unpacking.swapBytes)
        return uploadImage(target, level, stored, border, givenOf(image, call, *level.memory));
    // In place of GL_UNPACK_SWAP_BYTES, with which Mesa 22.3 ignores the row length and writes out of bounds.
    const Bytes swapped = withSwappedBytes(*level.memory, call.layout.type);
    return uploadImage(target, level, stored, border, givenOf(image, call, swapped));
}

/// Uploads some rows of a picture, or slices of a volume.
const char* uploadRows(Target target, const TextureLevel& level, int first, int count) {
    const Image& image = std::get<Image>(*level.surface);
    const auto& [format, type, pixels] = givenOf(image);
    const GLenum aim = imageTarget(target, level.face);
    if (target == Target::Texture3D) {
        glTexSubImage3D(aim, level.number, 0, 0, first, image.width, image.height, count, format, type,
                        pixels + image.offset(0, 0, first));
        return "glTexSubImage3D";
    }
    glTexSubImage2D(aim, level.number, 0, first, image.width, count, format, type,
                    pixels + image.offset(0, first, 0));
    return "glTexSubImage2D";
}

const char* uploadBlocks(Target target, const TextureLevel& level) {
    const auto& image = std::get<BlockImage>(*level.surface);
    glCompressedTexImage2D(imageTarget(target, level.face), level.number, static_cast<GLenum>(image.format),
                           image.width, image.height, 0, static_cast<GLsizei>(image.blocks.size()),
                           image.blocks.data());
    return "glCompressedTexImage2D";
}

/// The longest side of a texture.
int largestExtent(Target target) {
    GLint most = 0;
    glGetIntegerv(target == Target::Texture3D ? GL_MAX_3D_TEXTURE_SIZE
                  : target == Target::CubeMap ? GL_MAX_CUBE_MAP_TEXTURE_SIZE
                                              : GL_MAX_TEXTURE_SIZE,
                  &most);
    return most;
}

/// Whether OpenGL accepts it: faces that are not square are an error, and the texture is incomplete anyway.
/// So are levels whose base would be too large (OpenGL 2.1, section 3.8.1).
bool isAccepted(Target target, const TextureLevel& level, int border) {
    const Surface& surface = level.surface;
    if (target == Target::CubeMap && widthOf(surface) != heightOf(surface))
        return false;
    const int extent = std::max({widthOf(surface), heightOf(surface), depthOf(surface)}) - 2 * border;
    return level.number == 0 || extent <= largestExtent(target) >> level.number;
}

int levelParameter(GLenum aim, GLint level, GLenum what) {
    GLint value = 0;
    glGetTexLevelParameteriv(aim, level, what, &value);
    return value;
}

/// Reads the levels of the bound texture, or of one of its faces.
Result<void> readImages(GLenum aim, int face, int maxLevels, std::vector<TextureLevel>& levels) {
    const auto ask = [aim](GLint level, GLenum what) { return levelParameter(aim, level, what); };
    for (GLint level = 0; level < maxLevels; ++level) {
        const int width = ask(level, GL_TEXTURE_WIDTH);
        if (width == 0)
            continue;
        const int height = ask(level, GL_TEXTURE_HEIGHT);
        const int depth = ask(level, GL_TEXTURE_DEPTH);
        const auto stored = static_cast<std::uint32_t>(ask(level, GL_TEXTURE_INTERNAL_FORMAT));
        const EnumRow* row = findRow(blockFormatRows, stored);
        if (ask(level, GL_TEXTURE_COMPRESSED) == GL_FALSE || !row) { // OpenGL decompresses the others
            const bool isOfFloats = findRow(internalFormatRows, stored) && isFloat(InternalFormat{stored});
            const PixelFormat format = ask(level, GL_TEXTURE_DEPTH_SIZE) > 0 ? PixelFormat::Depth32
                                       : isOfFloats                          ? PixelFormat::RgbaFloat
                                                                             : PixelFormat::Rgba8;
            Image image = Image::uninitialised(format, width, std::max(height, 1), std::max(depth, 1));
            glGetTexImage(aim, level, pixelFormat(format), pixelType(format), image.pixels.data());
            levels.push_back({level, std::move(image), face});
            continue;
        }
        BlockImage image =
            BlockImage::uninitialised(static_cast<BlockFormat>(stored), width, height, std::max(depth, 1));
        const auto size = static_cast<std::size_t>(ask(level, GL_TEXTURE_COMPRESSED_IMAGE_SIZE));
        if (size != image.blocks.size())
            return fail(ErrorCode::Driver,
                        Sentence("level {0} should have {1} bytes of blocks, the driver says {2}", level,
                                 image.blocks.size(), size));
        glGetCompressedTexImage(aim, level, image.blocks.data());
        levels.push_back({level, std::move(image), face});
    }
    return {};
}

/// Formats that drivers choose and Texplorer itself doesn't make.
struct OtherCompressed {
    GLenum format;
    std::string_view name;
};
constexpr std::array otherCompressed{
    OtherCompressed{GL_COMPRESSED_LUMINANCE_LATC1_EXT, "GL_COMPRESSED_LUMINANCE_LATC1_EXT"},
    OtherCompressed{GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT, "GL_COMPRESSED_LUMINANCE_ALPHA_LATC2_EXT"},
    OtherCompressed{GL_COMPRESSED_SRGB_S3TC_DXT1_EXT, "GL_COMPRESSED_SRGB_S3TC_DXT1_EXT"},
    OtherCompressed{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT, "GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT"},
    OtherCompressed{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT, "GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT"},
    OtherCompressed{GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT, "GL_COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT"},
};

std::string nameOfFormat(GLenum format) {
    for (const std::span<const EnumRow> rows :
         {std::span<const EnumRow>(internalFormatRows), std::span<const EnumRow>(blockFormatRows)}) {
        if (const EnumRow* row = findRow(rows, format))
            return std::string(row->name);
    }
    const auto* other = std::ranges::find(otherCompressed, format, &OtherCompressed::format);
    return other == otherCompressed.end() ? fmt::format("0x{:04X}", format) : std::string(other->name);
}

/// In the order of view::storedComponents.
constexpr std::array<GLenum, view::storedComponents.size()> sizeNames{
    GL_TEXTURE_RED_SIZE,       GL_TEXTURE_GREEN_SIZE,     GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE,
    GL_TEXTURE_LUMINANCE_SIZE, GL_TEXTURE_INTENSITY_SIZE, GL_TEXTURE_DEPTH_SIZE};

/// A proxy texture has no texels: OpenGL says only whether there would be room (section 3.8.11).
int largestFitting(Target target, GLenum format, bool hasDepths) {
    const auto stored = static_cast<GLint>(format);
    const GLenum layout = hasDepths ? GL_DEPTH_COMPONENT : GL_RGBA;
    int extent = largestExtent(target);
    for (; extent > 1; extent /= 2) {
        GLenum proxy = GL_PROXY_TEXTURE_2D;
        switch (target) {
        case Target::Texture1D:
            proxy = GL_PROXY_TEXTURE_1D;
            glTexImage1D(proxy, 0, stored, extent, 0, layout, GL_UNSIGNED_BYTE, nullptr);
            break;
        case Target::Texture3D:
            proxy = GL_PROXY_TEXTURE_3D;
            glTexImage3D(proxy, 0, stored, extent, extent, extent, 0, layout, GL_UNSIGNED_BYTE, nullptr);
            break;
        case Target::CubeMap:
            proxy = GL_PROXY_TEXTURE_CUBE_MAP;
            [[fallthrough]];
        case Target::Texture2D:
            glTexImage2D(proxy, 0, stored, extent, extent, 0, layout, GL_UNSIGNED_BYTE, nullptr);
        }
        if (levelParameter(proxy, 0, GL_TEXTURE_WIDTH) > 0)
            break;
    }
    return extent;
}

GLint enumerant(auto value) {
    return static_cast<GLint>(value);
}

} // namespace

TextureObject::TextureObject(Target target)
    : handle_(TextureHandle::create())
    , target_(static_cast<GLenum>(target)) {}

TextureObject::TextureObject(Target target, const TextureLevels& levels, std::string_view where,
                             GlErrors& errors)
    : TextureObject(target) {
    UploadCursor cursor;
    static_cast<void>(upload(levels, cursor, std::numeric_limits<std::size_t>::max(), where, errors));
}

bool TextureObject::upload(const TextureLevels& levels, UploadCursor& cursor, std::size_t bytes,
                           std::string_view where, GlErrors& errors) {
    const auto target = static_cast<Target>(target_);
    const GLint stored =
        levels.driverFormat ? enumerant(*levels.driverFormat) : sizedFormat(levels.internalFormat);
    const std::size_t slowness =
        levels.driverFormat || isGenericCompressed(levels.internalFormat) ? driverSlowness : 1;
    std::size_t left = std::max<std::size_t>(1, bytes / slowness);
    glBindTexture(target_, handle_.name());
    // The driver makes no levels of cube faces that it refuses.
    const bool driverMakes = levels.madeByDriver && !levels.levels.empty() &&
                             isAccepted(target, levels.levels.front(), levels.border);
    if (cursor.level == 0 && cursor.row == 0 &&
        !levels.levels.empty()) // otherwise Mesa allocates all levels that fit
        glTexParameteri(target_, GL_TEXTURE_MAX_LEVEL, levels.levels.back().number);
    while (left > 0 && cursor.level < levels.levels.size()) {
        const TextureLevel& level = levels.levels[cursor.level];
        if ((driverMakes && level.number > 0) || !isAccepted(target, level, levels.border)) {
            ++cursor.level;
            continue;
        }
        const Image* image = std::get_if<Image>(&*level.surface);
        const int axes = image ? axesOf(target) : 1; // blocks cannot be uploaded in part
        const int rows = axes == 3 ? image->depth : axes == 2 ? image->height : 1;
        const std::size_t all = byteCount(level.surface);
        const char* call = nullptr;
        // If the driver has removed a border, the rows have moved.
        const bool readsMemory = image && level.memory && levels.call;
        const bool whole = rows == 1 || levels.border != 0 || readsMemory;
        if (cursor.row == 0 && (all <= left || whole)) {
            if (readsMemory) {
                call = uploadMemory(target, level, stored, levels.border, *levels.call);
            } else
                call = image ? uploadImage(target, level, stored, levels.border, givenOf(*image))
                             : uploadBlocks(target, level);
            left -= std::min(left, all);
            ++cursor.level;
        } else {
            if (cursor.row == 0)
                uploadImage(target, level, stored, 0,
                            {pixelFormat(image->format), pixelType(image->format), nullptr});
            const std::size_t perRow = std::max<std::size_t>(1, all / static_cast<std::size_t>(rows));
            // At least four rows and a multiple of four: blocks cannot be uploaded in part.
            const int fitting = static_cast<int>(std::min<std::size_t>(left / perRow, 1U << 20)) / 4 * 4;
            const int count = std::min(std::max(4, fitting), rows - cursor.row);
            call = uploadRows(target, level, cursor.row, count);
            left -= std::min(left, perRow * static_cast<std::size_t>(count));
            cursor.row += count;
            if (cursor.row == rows) {
                cursor.row = 0;
                ++cursor.level;
            }
        }
        errors.check(Sentence("{0}: {1}", ProperName{where},
                              Sentence("{0} level {1}", ProperName{call}, level.number)));
    }
    const bool isWhole = cursor.level == levels.levels.size();
    if (isWhole && driverMakes) {
        glGenerateMipmap(target_);
        errors.check(
            Sentence("{0}: {1}", ProperName{where}, ProperName{rowOf(MipPolicy::GenerateMipmap).name}));
    }
    return isWhole;
}

void TextureObject::apply(const Texture& texture, float maxAnisotropy, std::string_view where,
                          GlErrors& errors) {
    if (applied_ == texture)
        return errors.add(applyErrors_.sentences());
    applied_ = texture;
    applyErrors_ = {};
    glBindTexture(target_, handle_.name());
    glTexParameteri(target_, GL_TEXTURE_MAG_FILTER, enumerant(texture.magFilter));
    glTexParameteri(target_, GL_TEXTURE_MIN_FILTER, enumerant(texture.minFilter));
    glTexParameteri(target_, GL_TEXTURE_WRAP_S, enumerant(texture.wrapS));
    glTexParameteri(target_, GL_TEXTURE_WRAP_T, enumerant(texture.wrapT));
    glTexParameteri(target_, GL_TEXTURE_WRAP_R, enumerant(texture.wrapR));
    glTexParameterfv(target_, GL_TEXTURE_BORDER_COLOR, glm::value_ptr(texture.borderColor));
    glTexParameteri(target_, GL_TEXTURE_BASE_LEVEL, texture.baseLevel);
    glTexParameteri(target_, GL_TEXTURE_MAX_LEVEL, texture.maxLevel);
    glTexParameterf(target_, GL_TEXTURE_MIN_LOD, texture.minLod);
    glTexParameterf(target_, GL_TEXTURE_MAX_LOD, texture.maxLod);
    glTexParameterf(target_, GL_TEXTURE_LOD_BIAS, texture.lodBias);
    glTexParameteri(target_, GL_TEXTURE_COMPARE_MODE, enumerant(texture.compareMode));
    glTexParameteri(target_, GL_TEXTURE_COMPARE_FUNC, enumerant(texture.compareFunc));
    glTexParameterf(target_, GL_TEXTURE_PRIORITY, texture.priority);
    if (maxAnisotropy > 1) // otherwise the driver does not know the parameter
        glTexParameterf(target_, GL_TEXTURE_MAX_ANISOTROPY_EXT,
                        std::clamp(texture.maxAnisotropy, 1.0F, maxAnisotropy));
    applyErrors_.check(Sentence("{0}: {1}", ProperName{where}, ProperName{"glTexParameter"}));
    errors.add(applyErrors_.sentences());
}

view::StoredTexture TextureObject::stored() const {
    const auto target = static_cast<Target>(target_);
    const GLenum aim = imageTarget(target, 0);
    glBindTexture(target_, handle_.name());
    view::StoredTexture stored;
    const int count = mipLevelCount(largestExtent(target), 1);
    for (int number = 0; number < count; ++number) {
        const auto ask = [&](GLenum what) { return levelParameter(aim, number, what); };
        view::StoredLevel level{number, ask(GL_TEXTURE_WIDTH), std::max(1, ask(GL_TEXTURE_HEIGHT)),
                                std::max(1, ask(GL_TEXTURE_DEPTH)), ask(GL_TEXTURE_BORDER)};
        if (level.width == 0)
            continue;
        const auto format = static_cast<GLenum>(ask(GL_TEXTURE_INTERNAL_FORMAT));
        if (stored.levels.empty())
            stored.largest = largestFitting(target, format, ask(GL_TEXTURE_DEPTH_SIZE) > 0);
        level.internalFormat = nameOfFormat(format);
        std::ranges::transform(sizeNames, level.bits.begin(), ask);
        if (ask(GL_TEXTURE_COMPRESSED) != GL_FALSE)
            level.bytes = static_cast<std::size_t>(ask(GL_TEXTURE_COMPRESSED_IMAGE_SIZE));
        stored.levels.push_back(std::move(level));
    }
    GLint resident = GL_FALSE;
    glGetTexParameteriv(target_, GL_TEXTURE_RESIDENT, &resident);
    stored.resident = resident != GL_FALSE;
    glGetTexParameterfv(target_, GL_TEXTURE_PRIORITY, &stored.priority);
    return stored;
}

Result<std::vector<TextureLevel>> TextureObject::read() const {
    const auto target = static_cast<Target>(target_);
    const int maxLevels = mipLevelCount(largestExtent(target), 1); // it is an error to query a level beyond
    std::vector<TextureLevel> levels;
    glBindTexture(target_, handle_.name());
    for (int face = 0; face < facesOf(target); ++face) {
        if (Result<void> read = readImages(imageTarget(target, face), face, maxLevels, levels); !read)
            return fail(read.error());
    }
    GlErrors errors;
    if (!errors.check("glGetTexImage, glGetCompressedTexImage"))
        return fail(ErrorCode::Driver, errors.sentences().front());
    return levels;
}

} // namespace texplorer::render
