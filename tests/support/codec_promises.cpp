#include "tests/support/codec_promises.h"

#include "tests/support/watched_heap.h"
#include "texplorer/s3tc/surface_pixels.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/text/utf8.h"

#include <algorithm>

namespace texplorer::test {
namespace {

std::string sizeOf(const Surface& surface) {
    return std::to_string(widthOf(surface)) + " x " + std::to_string(heightOf(surface)) + " x " +
           std::to_string(depthOf(surface));
}

bool holdsItsPixels(const Surface& surface) {
    const auto depth = static_cast<std::size_t>(depthOf(surface));
    if (const Image* image = std::get_if<Image>(&surface))
        return image->pixels.size() == image->rowBytes() * static_cast<std::size_t>(image->height) * depth;
    const BlockImage& blocks = std::get<BlockImage>(surface);
    return blocks.blocks.size() == blocks.blockRowBytes() * blocks.blockRows() * depth;
}

bool sameFormat(const Surface& a, const Surface& b) {
    if (a.index() != b.index())
        return false;
    if (const Image* image = std::get_if<Image>(&a))
        return image->format == std::get<Image>(b).format;
    return std::get<BlockImage>(a).format == std::get<BlockImage>(b).format;
}

std::string brokenBySurface(const TextureImage& texture, int face, int level, const DecodeLimits& limits) {
    const Surface& base = texture.surfaces.front();
    const Surface& surface = texture.surface(face, level);
    const auto expected = [&](int extent) { return std::max(1, extent >> level); };
    const std::string name = "face " + std::to_string(face) + ", level " + std::to_string(level) + " of " +
                             sizeOf(surface) + " texels";
    for (const int extent : {widthOf(surface), heightOf(surface), depthOf(surface)})
        if (extent < 1 || extent > limits.maxExtent)
            return name + " exceeds the limit of " + std::to_string(limits.maxExtent);
    if (level > 15 || widthOf(surface) != expected(widthOf(base)) ||
        heightOf(surface) != expected(heightOf(base)) || depthOf(surface) != expected(depthOf(base)))
        return name + " is no mip level of " + sizeOf(base);
    const auto pixels = static_cast<std::size_t>(widthOf(surface)) *
                        static_cast<std::size_t>(heightOf(surface)) *
                        static_cast<std::size_t>(depthOf(surface));
    if (pixels > limits.maxPixels)
        return name + " exceeds the limit of " + std::to_string(limits.maxPixels) + " pixels";
    if (!holdsItsPixels(surface))
        return name + " has " + std::to_string(byteCount(surface)) + " bytes";
    if (!sameFormat(surface, base))
        return name + " has another format than level 0";
    return {};
}

std::string brokenByTexture(const CodecRow& row, const TextureImage& texture, const DecodeLimits& limits) {
    if (texture.format != row.name)
        return "the texture says that its file's format is " + inQuotes(texture.format);
    if (texture.faces != 1 && texture.faces != 6)
        return std::to_string(texture.faces) + " faces";
    if (texture.levels < 1 || texture.surfaces.size() != static_cast<std::size_t>(texture.faces) *
                                                             static_cast<std::size_t>(texture.levels))
        return std::to_string(texture.surfaces.size()) + " surfaces for " + std::to_string(texture.faces) +
               " faces with " + std::to_string(texture.levels) + " levels";
    std::size_t bytes = 0;
    for (int face = 0; face < texture.faces; ++face) {
        for (int level = 0; level < texture.levels; ++level) {
            if (std::string broken = brokenBySurface(texture, face, level, limits); !broken.empty())
                return broken;
            bytes += byteCount(texture.surface(face, level));
        }
    }
    if (bytes > limits.maxBytes)
        return std::to_string(bytes) + " bytes exceed the limit of " + std::to_string(limits.maxBytes);
    for (const std::string& note : texture.notes)
        if (!isOneLine(note))
            return "a note isn't one line: " + inQuotes(note);
    return {};
}

/// The outline of a texture must match its pixels.
std::string brokenByOutline(const TextureImage& texture, const TextureImage& outline) {
    if (outline.format != texture.format || outline.faces != texture.faces ||
        outline.levels != texture.levels || outline.surfaces.size() != texture.surfaces.size() ||
        outline.fileTopFirst != texture.fileTopFirst || outline.topFirst != texture.topFirst ||
        outline.srgb != texture.srgb)
        return "the outline is that of another texture";
    for (std::size_t i = 0; i < texture.surfaces.size(); ++i) {
        const Surface& surface = outline.surfaces[i];
        if (sizeOf(surface) != sizeOf(texture.surfaces[i]) || !sameFormat(surface, texture.surfaces[i]))
            return "the outline's surface " + std::to_string(i) + " is another one";
        if (bytesHeld(surface) != 0)
            return "the outline's surface " + std::to_string(i) + " has pixels";
    }
    for (const Sentence& note : outline.notes)
        if (std::ranges::find(texture.notes, note) == texture.notes.end())
            return "the outline alone notes that " + note.english();
    return {};
}

std::string brokenByError(const CodecRow& row, const Error& error) {
    if (!isOneLine(error.message))
        return "the error isn't one line: " + inQuotes(error.message);
    if (!error.message.english().starts_with(row.name))
        return "the error doesn't begin with the format's name: " + error.message.english();
    if (!error.where.empty())
        return "a decoder can't know a place, its error names " + inQuotes(error.where.text());
    return {};
}

std::string brokenByAnatomy(const CodecRow& row, const Anatomy& anatomy) {
    constexpr std::size_t maxFields = 4096;
    if (anatomy.format != row.name)
        return "the anatomy says that the format is " + inQuotes(anatomy.format);
    if (anatomy.fields.size() > maxFields)
        return "an anatomy of " + std::to_string(anatomy.fields.size()) + " fields";
    if (!anatomy.damage.empty() && !isOneLine(anatomy.damage))
        return "the damage isn't said in one line: " + inQuotes(anatomy.damage);
    for (const Field& field : anatomy.fields) {
        if (!isOneLine(field.name))
            return "a field's name isn't one line: " + inQuotes(field.name);
        for (const std::string& text : {field.value, field.meaning, field.wrong})
            if (!text.empty() && !isOneLine(text))
                return "the text of " + field.name.english() + " isn't one line: " + inQuotes(text);
        if (field.depth < 0)
            return field.name.english() + " lies at depth " + std::to_string(field.depth);
    }
    return {};
}

std::string brokenByWriting(const CodecRow& row, const TextureImage& texture, const WriteOptions& options) {
    const Result<Bytes> written = row.encode(texture, options);
    if (!written)
        return brokenByError(row, written.error());
    const Result<TextureImage> again = row.decode(*written, {});
    if (!again)
        return "what was written can't be read: " + again.error().message.english();
    const Image first = uprightImage(texture);
    const Image second = uprightImage(*again);
    if (first.width != second.width || first.height != second.height)
        return sizeOf(texture.surfaces.front()) + " became " + sizeOf(again->surfaces.front());
    if (first.format == second.format && first.depth == second.depth && first.pixels != second.pixels)
        return "writing and reading again gives other pixels";
    return {};
}

} // namespace

bool isOneLine(std::string_view text) {
    constexpr std::size_t longest = 600;
    return !text.empty() && text.size() <= longest && isUtf8(text) &&
           std::ranges::none_of(text, [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; });
}

std::string brokenPromise(const CodecRow& row, ByteView file, const DecodeLimits& limits) {
    if (row.dissect)
        if (std::string broken = brokenByAnatomy(row, row.dissect(file)); !broken.empty())
            return broken;

    // Two heaps that are filled with different bytes: pixels that a decoder does not write differ.
    heapFill = std::byte{0x55};
    const Result<TextureImage> texture = row.decode(file, limits);
    heapFill = std::byte{0xAA};
    const Result<TextureImage> again = row.decode(file, limits);
    heapFill = {};
    DecodeLimits withoutPixels = limits;
    withoutPixels.pixels = false;
    const Result<TextureImage> outline = row.decode(file, withoutPixels);
    if (!outline)
        if (std::string broken = brokenByError(row, outline.error()); !broken.empty())
            return broken;

    if (texture.has_value() != again.has_value())
        return "the second decoding of the same file ends differently";
    if (!texture)
        return brokenByError(row, texture.error());
    if (!outline)
        return "the texture is read and its outline isn't: " + outline.error().message.english();
    if (std::string broken = brokenByOutline(*texture, *outline); !broken.empty())
        return broken;
    if (std::string broken = brokenByTexture(row, *texture, limits); !broken.empty())
        return broken;
    if (texture->surfaces != again->surfaces)
        return "uninitialised pixels: the second decoding of the same file gives others";

    constexpr std::size_t manyBytes = std::size_t{1}
                                      << 18; // writing larger ones finds nothing more, but takes longer
    if (!row.encode || byteCount(texture->surfaces.front()) > manyBytes)
        return {};
    for (const WriteOptions& options : {WriteOptions{}, WriteOptions{.small = true, .runLengthCoded = true}})
        if (std::string broken = brokenByWriting(row, *texture, options); !broken.empty())
            return broken;
    return {};
}

} // namespace texplorer::test
