#include "texplorer/base/sentence.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_chunks.h"
#include "texplorer/text/printable.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <new>
#include <png.h>
#include <string>
#include <utility>

namespace texplorer {

namespace {

tl::unexpected<Error> malformed(const Sentence& message) {
    return fail(ErrorCode::Malformed, Sentence("PNG: {0}", message));
}

// What is known before libpng allocates anything.
struct Survey {
    PngHeader header;
    std::size_t compressed = 0; // bytes of pixel data
    std::uint32_t pictures = 1; // of an animation
    bool animated = false;
    std::uint64_t end = 0; // behind IEND, or 0
    std::vector<FilePart> parts;
    std::string others; // chunks that are neither read nor among the parts: "bKGD, tIME"
};

// What stays true of the same pixels in another file.
constexpr std::array<std::string_view, 9> kept{"cHRM", "gAMA", "iCCP", "sRGB", "pHYs",
                                               "tEXt", "zTXt", "iTXt", "eXIf"};
// What is read, or belongs to the coding of the pixels.
constexpr std::array<std::string_view, 5> used{"tRNS", "sBIT", "acTL", "fcTL", "fdAT"};

void surveyBeside(const PngChunk& chunk, Survey& found) {
    const bool ancillary = !chunk.type.empty() && chunk.type.front() >= 'a';
    if (!ancillary || std::ranges::find(used, chunk.type) != used.end())
        return;
    constexpr std::size_t enough = 80;
    if (std::ranges::find(kept, chunk.type) == kept.end()) {
        if (found.others.size() < enough && found.others.find(chunk.type) == std::string::npos)
            found.others.append(found.others.empty() ? "" : ", ").append(chunk.type);
    } else if (chunk.complete() && pngCrc(chunk) == *chunk.crc)
        found.parts.push_back({chunk.type, Bytes(chunk.data.begin(), chunk.data.end())});
}

Survey survey(ByteView file, bool everything) {
    Survey found;
    for (PngChunks chunks(file); const std::optional<PngChunk> chunk = chunks.next();) {
        if (chunk->type == "IHDR" && chunk->offset == pngSignature.size())
            found.header = readPngHeader(chunk->data);
        else if (chunk->type == "IDAT")
            found.compressed += chunk->data.size();
        else if (chunk->type == "acTL") {
            found.animated = true;
            found.pictures = bigEndian32(chunk->data, 0);
        } else if (chunk->type == "IEND" && chunk->complete()) {
            found.end = chunk->offset + chunk->size();
            break;
        }
        if (everything)
            surveyBeside(*chunk, found);
    }
    return found;
}

Result<void> checkExtents(const PngHeader& header, const DecodeLimits& limits) {
    const Sentence extents(N_("{0} × {1} pixels"), header.width, header.height);
    if (header.width < 1 || header.height < 1)
        return malformed(Sentence("a picture has at least 1 × 1 pixels, this one has {0}", extents));
    const auto maxExtent = static_cast<std::uint32_t>(std::max(limits.maxExtent, 0));
    if (header.width > maxExtent || header.height > maxExtent)
        return fail(ErrorCode::TooLarge,
                    Sentence("PNG: at most {0} × {0} pixels are read, the file has {1}", maxExtent, extents));
    const std::uint64_t pixels = std::uint64_t{header.width} * header.height;
    if (pixels > limits.maxPixels)
        return fail(ErrorCode::TooLarge,
                    Sentence("PNG: at most {0} pixels are read, the file has {1}", limits.maxPixels, pixels));
    return {};
}

Result<void> checkColors(const PngHeader& header) {
    // A bit for each depth that a colour type may have.
    constexpr std::array<std::uint32_t, 7> depths{
        1 | 2 | 4 | 8 | 16, 0, 8 | 16, 1 | 2 | 4 | 8, 8 | 16, 0, 8 | 16};
    const std::uint32_t depth = header.depth;
    if (header.colorType < depths.size() && (depths[header.colorType] & depth) != 0 &&
        (depth & (depth - 1)) == 0)
        return {};
    return malformed(
        Sentence("colour type {0} with {1} bits a sample is not one of the format's 15 combinations",
                 header.colorType, depth));
}

Result<void> checkSurvey(const Survey& found, ByteView file, const DecodeLimits& limits) {
    if (Result<void> checked = checkExtents(found.header, limits); !checked)
        return checked;
    if (Result<void> checked = checkColors(found.header); !checked)
        return checked;
    if (found.compressed == 0)
        return malformed(Sentence("there is no pixel data (IDAT) in the {0} bytes of the file", file.size()));
    // Deflate's longest match is 258 bytes and takes at least two bits.
    constexpr std::uint64_t bestRatio = 1032;
    const std::uint64_t needed = found.header.filteredBytes();
    if (needed / bestRatio > found.compressed)
        return malformed(Sentence(
            "{0} × {1} pixels need {2} bytes, the file's {3} bytes of pixel data can hold at most {4}",
            found.header.width, found.header.height, needed, found.compressed, found.compressed * bestRatio));
    return {};
}

// libpng reports an error by jumping out of its own functions, so that nothing with a destructor may live in
// the functions that it jumps back to: all state is here, outside of them.
struct Decoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    ByteView file;
    std::size_t position = 0;
    Sentence error;
    std::vector<Sentence> notes;

    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }

    // Not noexcept: a longjmp is an exception in WebAssembly.
    bool start(const DecodeLimits& limits);
    bool readPixels(Image& image, const DecodeLimits& limits);
};

Decoder& decoderOf(png_voidp pointer) {
    return *static_cast<Decoder*>(pointer);
}

// Text is made in functions of its own, which have returned before libpng jumps.
void keepError(Decoder& decoder, png_const_charp message) noexcept {
    try {
        if (decoder.error.empty())
            decoder.error = Sentence("{0} (read up to offset {1})", ProperName{message}, decoder.position);
    } catch (const std::bad_alloc&) {
        decoder.error = {};
    }
}

void keepEnd(Decoder& decoder, std::size_t wanted) noexcept {
    try {
        decoder.error =
            Sentence("the file ends early: {0} more bytes were expected at offset {1}, the file has {2}",
                     wanted, decoder.position, decoder.file.size());
    } catch (const std::bad_alloc&) {
        decoder.error = {};
    }
}

void onError(png_structp png, png_const_charp message) {
    keepError(decoderOf(png_get_error_ptr(png)), message);
    png_longjmp(png, 1);
}

void onWarning(png_structp png, png_const_charp message) {
    constexpr std::size_t enough = 8;
    std::vector<Sentence>& notes = decoderOf(png_get_error_ptr(png)).notes;
    try {
        if (notes.size() < enough)
            notes.push_back(Sentence("recovered: {0}", ProperName{message}));
    } catch (const std::bad_alloc&) { // then without
        notes.clear();
    }
}

void onRead(png_structp png, png_bytep to, png_size_t count) {
    Decoder& decoder = decoderOf(png_get_io_ptr(png));
    if (count > decoder.file.size() - decoder.position) {
        keepEnd(decoder, count);
        png_error(png, N_("the file ends early"));
    }
    std::memcpy(to, decoder.file.data() + decoder.position, count);
    decoder.position += count;
}

// Chunks that change no pixel and may hold much; libpng would unpack them.
constexpr png_byte skipped[] = "iCCP\0tEXt\0zTXt\0iTXt\0eXIf\0sPLT\0hIST";
constexpr int skippedCount = sizeof skipped / 5;

bool Decoder::start(const DecodeLimits& limits) {
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_set_read_fn(png, this, onRead);
    png_set_user_limits(png, static_cast<png_uint_32>(limits.maxExtent),
                        static_cast<png_uint_32>(limits.maxExtent));
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, skipped, skippedCount);
    png_read_info(png, info);
    png_set_expand(png); // palettes to RGB, grey to 8 bits, tRNS to alpha
    png_set_scale_16(png);
    png_set_interlace_handling(png);
    png_read_update_info(png, info);
    return true;
}

bool Decoder::readPixels(Image& image, const DecodeLimits& limits) {
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    for (int passes = png_set_interlace_handling(png); passes > 0; --passes) {
        for (int y = image.height - 1; y >= 0; --y) {
            if (limits.isStopped())
                return false;
            png_read_row(png, reinterpret_cast<png_bytep>(image.at(0, y).data()), nullptr);
        }
    }
    png_read_end(png, nullptr);
    return true;
}

PixelFormat formatOf(int channels) {
    constexpr std::array formats{PixelFormat::Luminance8, PixelFormat::LuminanceAlpha8, PixelFormat::Rgb8,
                                 PixelFormat::Rgba8};
    return formats[static_cast<std::size_t>(channels - 1)];
}

// Whether libpng has looked at such a chunk and left it out.
bool isRefused(const Decoder& decoder, std::string_view chunk) {
    constexpr std::array<std::pair<std::string_view, png_uint_32>, 4> read{
        {{"cHRM", PNG_INFO_cHRM}, {"gAMA", PNG_INFO_gAMA}, {"sRGB", PNG_INFO_sRGB}, {"pHYs", PNG_INFO_pHYs}}};
    return std::ranges::any_of(read, [&](const auto& each) {
        return each.first == chunk && png_get_valid(decoder.png, decoder.info, each.second) == 0;
    });
}

tl::unexpected<Error> failure(const Decoder& decoder) {
    return malformed(decoder.error.empty() ? "libpng rejected the file" : decoder.error);
}

Result<TextureImage> decode(ByteView file, Survey found, const DecodeLimits& limits) {
    Decoder decoder;
    decoder.file = file;
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, onError, onWarning);
    decoder.info = decoder.png != nullptr ? png_create_info_struct(decoder.png) : nullptr;
    if (decoder.info == nullptr)
        return fail(ErrorCode::TooLarge, "PNG: not enough memory for the decoder");
    if (!decoder.start(limits))
        return failure(decoder);

    const PixelFormat format = formatOf(png_get_channels(decoder.png, decoder.info));
    const std::uint64_t needed = std::uint64_t{found.header.width} * found.header.height *
                                 static_cast<std::uint64_t>(bytesPerPixel(format));
    if (needed > limits.maxBytes)
        return fail(
            ErrorCode::TooLarge,
            Sentence("PNG: at most {0} bytes of pixels are read, the file has {1}", limits.maxBytes, needed));
    Image image{format, static_cast<int>(found.header.width), static_cast<int>(found.header.height), 1, {}};
    if (png_get_rowbytes(decoder.png, decoder.info) != image.rowBytes())
        return malformed(Sentence("libpng's rows have {0} bytes, expected {1}",
                                  png_get_rowbytes(decoder.png, decoder.info), image.rowBytes()));
    if (limits.pixels) {
        image.pixels.resize(image.byteCount());
        if (!decoder.readPixels(image, limits))
            return limits.isStopped() ? fail(ErrorCode::Cancelled, "PNG: decoding was cancelled")
                                      : failure(decoder);
    }

    TextureImage texture = textureOf(std::move(image), "PNG");
    texture.srgb = png_get_valid(decoder.png, decoder.info, PNG_INFO_sRGB) != 0;
    texture.notes = std::move(decoder.notes);
    texture.componentBits = std::max<int>(texture.componentBits, found.header.depth);
    texture.parts = std::move(found.parts);
    std::erase_if(texture.parts, [&](const FilePart& part) { return isRefused(decoder, part.name); });
    if (found.pictures > 1)
        texture.losses.push_back(
            {"frames", Sentence("{0} of the animation's {1} pictures", found.pictures - 1, found.pictures)});
    if (!found.others.empty())
        texture.losses.push_back(
            {"metadata", Sentence("the chunks {0}", ProperName{printable(found.others)}), false});
    if (found.animated)
        texture.remarks.emplace_back(N_("the file is an animation; its first picture is read"));
    if (found.end != 0 && found.end < file.size())
        texture.notes.push_back(Sentence("{0} after the end (IEND) ignored",
                                         Sentence::plural("{0} byte", "{0} bytes", file.size() - found.end)));
    return texture;
}

} // namespace

Result<TextureImage> decodePng(ByteView file, const DecodeLimits& limits) {
    try {
        if (file.empty())
            return malformed("the file is empty");
        if (!hasPngSignature(file))
            return malformed("the file does not begin with PNG's signature of 8 bytes");
        if (file.size() < pngHeaderEnd)
            return malformed(
                Sentence("the header needs {0} bytes, the file has {1}", pngHeaderEnd, file.size()));
        if (!beginsWithPngHeader(file))
            return malformed("the first chunk is not an IHDR of 13 bytes");
        Survey found = survey(file, limits.everything);
        if (const Result<void> checked = checkSurvey(found, file, limits); !checked)
            return fail(checked.error());
        return decode(file, std::move(found), limits);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "PNG: not enough memory for the pixels");
    }
}

} // namespace texplorer
