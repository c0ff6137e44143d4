#include "texplorer/codec/registry.h"

#include "texplorer/codec/bmp/bmp.h"
#include "texplorer/codec/dds/dds.h"
#include "texplorer/codec/jpeg/jpeg.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/tga/tga.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <string>

namespace texplorer {

namespace {

bool beginsWith(ByteView file, std::string_view magic) {
    return file.size() >= magic.size() &&
           std::ranges::equal(file.first(magic.size()), std::as_bytes(std::span(magic)));
}

constexpr std::array rows{
    CodecRow{"BMP", ".bmp", [](ByteView file) { return beginsWith(file, "BM"); }, decodeBmp, dissectBmp,
             encodeBmp},
    CodecRow{"DDS", ".dds", [](ByteView file) { return beginsWith(file, "DDS "); }, decodeDds, dissectDds,
             encodeDds},
    CodecRow{"JPEG", N_(".jpg .jpeg"), [](ByteView file) { return beginsWith(file, "\xFF\xD8\xFF"); },
             decodeJpeg, dissectJpeg, nullptr},
    CodecRow{"PNG", ".png", [](ByteView file) { return beginsWith(file, "\x89PNG\r\n\x1A\n"); }, decodePng,
             dissectPng, encodePng},
    // Last, because it has no magic number.
    CodecRow{"TGA", N_(".tga .vda .icb .vst"), isTga, decodeTga, dissectTga, encodeTga},
};

// "89 50 4e 47", so that one can look up what it is.
std::string firstBytes(ByteView file) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (const std::byte byte : file.first(std::min<std::size_t>(file.size(), 4))) {
        const auto value = std::to_integer<unsigned>(byte);
        text += text.empty() ? "" : " ";
        text += digits[value >> 4];
        text += digits[value & 15];
    }
    return text;
}

} // namespace

std::vector<std::string> extensionsOf(const CodecRow& row) {
    std::istringstream words{std::string(row.extensions)};
    return {std::istream_iterator<std::string>(words), {}};
}

std::span<const CodecRow> codecRows() {
    return rows;
}

const CodecRow* recogniseImage(ByteView file) {
    const auto found = std::ranges::find_if(rows, [&](const CodecRow& row) { return row.recognise(file); });
    return found == rows.end() ? nullptr : &*found;
}

std::string writtenExtensions(std::string_view last, std::string_view only) {
    std::vector<std::string> names;
    for (const CodecRow& row : codecRows())
        if (row.encode && (only.empty() || row.name == only))
            names.push_back(extensionsOf(row).front());
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text.append(i == 0 ? "" : i + 1 == names.size() ? last : ", ").append(names[i]);
    return text;
}

const CodecRow* codecForExtension(std::string_view fileName) {
    const std::size_t dot = fileName.rfind('.');
    if (dot == std::string_view::npos)
        return nullptr;
    std::string extension(fileName.substr(dot));
    std::ranges::transform(extension, extension.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    const auto names = [&](const CodecRow& row) {
        const std::vector<std::string> known = extensionsOf(row);
        return std::ranges::find(known, extension) != known.end();
    };
    const auto found = std::ranges::find_if(rows, names);
    return found == rows.end() ? nullptr : &*found;
}

Result<TextureImage> decodeTexture(ByteView file, const DecodeLimits& limits) {
    if (const CodecRow* codec = recogniseImage(file))
        return codec->decode(file, limits);
    std::string known;
    for (const CodecRow& row : rows)
        known.append(known.empty() ? "" : ", ").append(row.name);
    if (file.empty())
        return fail(ErrorCode::Malformed, Sentence("expected an image ({0}), the file is empty", known));
    return fail(ErrorCode::Unsupported,
                Sentence("expected an image ({0}), the file begins with {1}", known, firstBytes(file)));
}

Result<TextureImage> outlineTexture(ByteView file, const Anatomy& anatomy, DecodeLimits limits) {
    const bool suspicious =
        !anatomy.damage.empty() ||
        std::ranges::any_of(anatomy.fields, [](const Field& field) { return !field.wrong.empty(); });
    limits.pixels = false;
    Result<TextureImage> outline = decodeTexture(file, limits);
    if (!outline || !suspicious)
        return outline;
    if (const Result<TextureImage> texture = decodeTexture(file); !texture)
        return fail(texture.error());
    return outline;
}

Result<Image> decodeImage(ByteView file, const DecodeLimits& limits) {
    Result<TextureImage> texture = decodeTexture(file, limits);
    if (!texture)
        return fail(texture.error());
    return uprightImage(std::move(*texture));
}

Anatomy dissect(ByteView file) {
    const CodecRow* codec = recogniseImage(file);
    if (!codec)
        return {};
    return codec->dissect ? codec->dissect(file) : Anatomy{codec->name, {}, {}};
}

} // namespace texplorer
