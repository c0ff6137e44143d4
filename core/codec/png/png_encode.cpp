#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_chunks.h"
#include "texplorer/codec/png/png_text.h"
#include "texplorer/s3tc/surface_pixels.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <libdeflate.h>
#include <limits>
#include <memory>
#include <new>
#include <string>
#include <utility>

namespace texplorer {

namespace {

// On rendered pictures libdeflate's fourth level takes hardly longer than its first, and packs tighter.
constexpr int fastLevel = 4;
constexpr int smallLevel = 12;

enum Filter : std::uint8_t { None, Sub, Up, Average, Paeth };

// PNG has no picture of alpha alone: it becomes grey, as one would want to look at it.
int colorTypeOf(PixelFormat format) {
    switch (format) {
    case PixelFormat::Alpha8:
    case PixelFormat::Luminance8:
        return 0;
    case PixelFormat::LuminanceAlpha8:
        return 4;
    case PixelFormat::Rgb8:
        return 2;
    case PixelFormat::Rgba8:
    case PixelFormat::Depth32:
    case PixelFormat::RgbaFloat:
        break;
    }
    return 6;
}

std::uint8_t paeth(int left, int above, int corner) {
    const int toLeft = std::abs(above - corner);
    const int toAbove = std::abs(left - corner);
    const int toCorner = std::abs(left + above - 2 * corner);
    if (toLeft <= toAbove && toLeft <= toCorner)
        return static_cast<std::uint8_t>(left);
    return static_cast<std::uint8_t>(toAbove <= toCorner ? above : corner);
}

// A row, the one above it in the picture, and how far to the left the same component of the neighbour is.
struct Row {
    const std::uint8_t* bytes;
    const std::uint8_t* above;
    std::size_t size;
    std::size_t step;
};

// What each byte is predicted to be; `predict` gets the bytes to the left, above, and above on the left. The
// row is passed by value: written bytes could alias a reference, and the loop would not be vectorised.
template<class Predict>
void filterWith(const Row row, std::uint8_t* to, Predict predict) {
    for (std::size_t i = 0; i < row.step; ++i)
        to[i] = static_cast<std::uint8_t>(row.bytes[i] - predict(0, row.above[i], 0));
    for (std::size_t i = row.step; i < row.size; ++i)
        to[i] = static_cast<std::uint8_t>(
            row.bytes[i] - predict(row.bytes[i - row.step], row.above[i], row.above[i - row.step]));
}

void applyFilter(Filter filter, const Row& row, std::uint8_t* to) {
    *to++ = filter;
    switch (filter) {
    case Sub:
        return filterWith(row, to, [](int left, int, int) { return left; });
    case Up:
        return filterWith(row, to, [](int, int above, int) { return above; });
    case Average:
        return filterWith(row, to, [](int left, int above, int) { return (left + above) / 2; });
    case Paeth:
        return filterWith(row, to, paeth);
    default:
        std::memcpy(to, row.bytes, row.size);
    }
}

// The specification's heuristic (section 12.8): the smaller the differences, the better they pack. Summed in
// runs that sixteen bits can hold, which is four times as fast as in 32.
std::uint32_t sumOfDifferences(const std::uint8_t* filtered, std::size_t size) {
    constexpr std::size_t run = 256;
    std::uint32_t sum = 0;
    for (std::size_t begin = 0; begin < size; begin += run) {
        std::uint16_t part = 0;
        const std::size_t end = std::min(begin + run, size);
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint8_t value = filtered[i];
            part = static_cast<std::uint16_t>(part + std::min(value, static_cast<std::uint8_t>(-value)));
        }
        sum += part;
    }
    return sum;
}

// All rows from the top, each behind the byte that names its filter: of those from `first` to `last` the one
// with the smallest differences.
Bytes filterRows(const Image& image, Filter first, Filter last) {
    const std::size_t size = image.rowBytes();
    Bytes filtered;
    filtered.resize((size + 1) * static_cast<std::size_t>(image.height));
    Bytes spare;
    spare.resize(size + 1);
    const Bytes nothing(size, std::byte{0});
    auto* to = reinterpret_cast<std::uint8_t*>(filtered.data());
    auto* trial = reinterpret_cast<std::uint8_t*>(spare.data());
    const auto* above = reinterpret_cast<const std::uint8_t*>(nothing.data());
    for (int y = image.height; y-- > 0; to += size + 1) {
        const Row row{reinterpret_cast<const std::uint8_t*>(image.at(0, y).data()), above, size,
                      static_cast<std::size_t>(bytesPerPixel(image.format))};
        applyFilter(first, row, to);
        std::uint32_t best = first == last ? 0 : sumOfDifferences(to + 1, size);
        for (int next = first + 1; next <= last; ++next) {
            applyFilter(static_cast<Filter>(next), row, trial);
            const std::uint32_t sum = sumOfDifferences(trial + 1, size);
            if (sum < best) {
                best = sum;
                std::memcpy(to, trial, size + 1);
            }
        }
        above = row.bytes;
    }
    return filtered;
}

void put32(std::byte* at, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8)
        *at++ = static_cast<std::byte>(value >> shift);
}

// Around `length` bytes of data that already stand 8 behind `at`; gives the place behind the chunk.
std::byte* frameChunk(std::byte* at, const char* type, std::size_t length) {
    put32(at, static_cast<std::uint32_t>(length));
    std::memcpy(at + 4, type, 4);
    put32(at + 8 + length, libdeflate_crc32(0, at + 4, 4 + length));
    return at + 12 + length;
}

struct FreeCompressor {
    void operator()(libdeflate_compressor* compressor) const { libdeflate_free_compressor(compressor); }
};

constexpr std::size_t chunkFrame = 12;
constexpr std::size_t headBytes = 8 + chunkFrame + 13;

using OtherChunks = std::vector<std::pair<std::string, Bytes>>; // type and data

// Those in front of the pixels: what stood in another PNG of the same pixels, and texts.
Result<OtherChunks> otherChunks(const std::vector<FilePart>& parts, bool srgb,
                                const std::vector<PictureText>& texts) {
    OtherChunks chunks;
    const auto saysColors = [](const FilePart& part) { return part.name == "sRGB" || part.name == "iCCP"; };
    if (srgb && std::ranges::none_of(parts, saysColors))
        chunks.emplace_back("sRGB", Bytes{std::byte{0}}); // perceptual intent
    for (const FilePart& part : parts)
        chunks.emplace_back(part.name, part.data);
    for (const PictureText& text : texts) {
        Result<std::pair<std::string, Bytes>> chunk = textChunk(text);
        if (!chunk)
            return fail(chunk.error());
        chunks.push_back(*std::move(chunk));
    }
    return chunks;
}

// Filtered rows as a whole file. The compressed data is written where it stays.
Result<Bytes> assemble(const Image& image, const Bytes& rows, int level, const OtherChunks& others) {
    const std::unique_ptr<libdeflate_compressor, FreeCompressor> compressor(
        libdeflate_alloc_compressor(level));
    if (!compressor)
        throw std::bad_alloc();
    const std::size_t bound = libdeflate_zlib_compress_bound(compressor.get(), rows.size());
    constexpr std::size_t maxBytes = std::numeric_limits<std::int32_t>::max();
    if (bound > maxBytes)
        return fail(
            ErrorCode::TooLarge,
            Sentence("PNG: a chunk holds at most {0} bytes, this picture may need {1}", maxBytes, bound));
    std::size_t otherBytes = 0;
    for (const auto& [type, data] : others)
        otherBytes += chunkFrame + data.size();
    Bytes file;
    file.resize(headBytes + otherBytes + chunkFrame + bound + chunkFrame);
    std::byte* at = file.data();
    std::memcpy(at, pngSignature.data(), pngSignature.size());
    at += pngSignature.size();
    put32(at + 8, static_cast<std::uint32_t>(image.width));
    put32(at + 12, static_cast<std::uint32_t>(image.height));
    const std::array last{std::byte{8}, static_cast<std::byte>(colorTypeOf(image.format)), std::byte{0},
                          std::byte{0}, std::byte{0}};
    std::ranges::copy(last, at + 16);
    at = frameChunk(at, "IHDR", 13);
    for (const auto& [type, data] : others) {
        std::ranges::copy(data, at + 8);
        at = frameChunk(at, type.c_str(), data.size());
    }
    const std::size_t packed =
        libdeflate_zlib_compress(compressor.get(), rows.data(), rows.size(), at + 8, bound);
    at = frameChunk(at, "IDAT", packed);
    at = frameChunk(at, "IEND", 0);
    file.resize(static_cast<std::size_t>(at - file.data()));
    return file;
}

Result<Bytes> encode(const Image& image, bool small, const OtherChunks& others) {
    if (!small)
        return assemble(image, filterRows(image, Sub, Up), fastLevel, others);
    // Which is smaller can't be told beforehand: flat drawings pack best as they are, photographs filtered.
    Result<Bytes> plain = assemble(image, filterRows(image, None, None), smallLevel, others);
    Result<Bytes> filtered = assemble(image, filterRows(image, None, Paeth), smallLevel, others);
    return plain && filtered && plain->size() < filtered->size() ? std::move(plain) : std::move(filtered);
}

Result<Bytes> checkAndEncode(const Image& image, bool small, const Result<OtherChunks>& others) {
    if (!others)
        return fail(others.error());
    if (image.width < 1 || image.height < 1 || image.empty())
        return fail(ErrorCode::OutOfRange,
                    Sentence("PNG: a picture has at least 1 × 1 pixels, this one has {0} × {1}", image.width,
                             image.height));
    const std::size_t slice = image.rowBytes() * static_cast<std::size_t>(image.height);
    if (image.pixels.size() < slice)
        return fail(ErrorCode::Malformed,
                    Sentence("PNG: the picture needs {0} bytes, it has {1}", slice, image.pixels.size()));
    try {
        return encode(image, small, *others);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, Sentence("PNG: not enough memory for {0} bytes of pixels", slice));
    }
}

} // namespace

Result<Bytes> encodePng(const Image& image, const WriteOptions& options) {
    return checkAndEncode(image, options.small, otherChunks({}, false, options.texts));
}

Result<Bytes> encodePng(const TextureImage& texture, const WriteOptions& options) {
    if (texture.surfaces.empty())
        return encodePng(Image{}, options);
    try {
        const Result<OtherChunks> others = otherChunks(texture.parts, texture.srgb, options.texts);
        const Image* image = std::get_if<Image>(&texture.surfaces.front());
        if (image != nullptr && !texture.topFirst)
            return checkAndEncode(*image, options.small, others);
        TextureImage first;
        first.surfaces.push_back(texture.surfaces.front());
        first.topFirst = texture.topFirst;
        return checkAndEncode(uprightImage(std::move(first)), options.small, others);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "PNG: not enough memory for the pixels");
    }
}

} // namespace texplorer
