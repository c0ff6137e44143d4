#include "texplorer/codec/png/png_text.h"

#include "texplorer/files/file_io.h"

#include <algorithm>
#include <libdeflate.h>
#include <memory>
#include <new>
#include <utility>

namespace texplorer {

namespace {

constexpr std::size_t maxKeywordBytes = 79;

std::string charactersOf(ByteView bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string fromLatin1(ByteView bytes) {
    std::string text;
    text.reserve(bytes.size());
    for (const std::byte each : bytes) {
        const auto code = std::to_integer<unsigned>(each);
        if (code >= 0x80)
            text += static_cast<char>(0xC0 | code >> 6);
        text += static_cast<char>(code < 0x80 ? code : 0x80 | (code & 0x3F));
    }
    return text;
}

/// Where the 0 is that ends what begins at `offset`; nothing: there is none.
std::optional<std::size_t> endOf(ByteView data, std::size_t offset) {
    for (std::size_t i = offset; i < data.size(); ++i) {
        if (data[i] == std::byte{0})
            return i;
    }
    return std::nullopt;
}

struct FreeDecompressor {
    void operator()(libdeflate_decompressor* made) const { libdeflate_free_decompressor(made); }
};

/// Unpacked, or why it isn't. Memory: as the text grows, never more than `maxBytes` nor than the stream can
/// hold.
Result<Bytes> unpacked(ByteView stream, std::size_t maxBytes) {
    const std::unique_ptr<libdeflate_decompressor, FreeDecompressor> decompressor(
        libdeflate_alloc_decompressor());
    if (!decompressor)
        throw std::bad_alloc();
    constexpr std::size_t bestRatio = 1032; // of deflate
    const auto limit =
        static_cast<std::size_t>(std::min<std::uint64_t>(maxBytes, std::uint64_t{stream.size()} * bestRatio));
    for (std::size_t room = std::min<std::size_t>(limit, 4096);; room = std::min(limit, room * 4)) {
        Bytes text;
        text.resize(room);
        std::size_t size = 0;
        const libdeflate_result result = libdeflate_zlib_decompress(
            decompressor.get(), stream.data(), stream.size(), text.data(), text.size(), &size);
        if (result == LIBDEFLATE_SUCCESS) {
            text.resize(size);
            return text;
        }
        if (result != LIBDEFLATE_INSUFFICIENT_SPACE)
            return fail(ErrorCode::Malformed, "the zlib stream is damaged");
        if (room == limit)
            return fail(ErrorCode::TooLarge, "it is too long");
    }
}

PngText readPacked(PngText found, ByteView stream, bool latin1, std::size_t maxBytes) {
    found.packed = true;
    const Result<Bytes> text = unpacked(stream, maxBytes);
    if (text)
        found.text = latin1 ? fromLatin1(*text) : charactersOf(*text);
    else if (text.error().code == ErrorCode::TooLarge)
        found.tooLong = true;
    else
        found.wrong = text.error().message;
    return found;
}

bool isAscii(std::string_view text) {
    return std::ranges::all_of(text, [](char each) { return each == '\n' || (each >= ' ' && each <= '~'); });
}

Result<void> checkKeyword(std::string_view keyword) {
    const bool spaced = keyword.starts_with(' ') || keyword.ends_with(' ') ||
                        keyword.find("  ") != std::string_view::npos ||
                        keyword.find('\n') != std::string_view::npos;
    if (!keyword.empty() && keyword.size() <= maxKeywordBytes && isAscii(keyword) && !spaced)
        return {};
    return fail(ErrorCode::OutOfRange,
                Sentence("PNG: a text's keyword has 1 to {0} letters and single spaces, found \"{1}\"",
                         maxKeywordBytes, keyword));
}

void append(Bytes& bytes, std::string_view text) {
    const ByteView view = viewBytes(text);
    bytes.insert(bytes.end(), view.begin(), view.end());
}

struct FreeTextCompressor {
    void operator()(libdeflate_compressor* made) const { libdeflate_free_compressor(made); }
};

void appendPacked(Bytes& bytes, std::string_view text) {
    constexpr int level = 6;
    const std::unique_ptr<libdeflate_compressor, FreeTextCompressor> compressor(
        libdeflate_alloc_compressor(level));
    if (!compressor)
        throw std::bad_alloc();
    const std::size_t at = bytes.size();
    bytes.resize(at + libdeflate_zlib_compress_bound(compressor.get(), text.size()));
    bytes.resize(at + libdeflate_zlib_compress(compressor.get(), text.data(), text.size(), bytes.data() + at,
                                               bytes.size() - at));
}

} // namespace

bool isTextChunk(const PngChunk& chunk) {
    return chunk.type == "tEXt" || chunk.type == "zTXt" || chunk.type == "iTXt";
}

PngText readTextChunk(const PngChunk& chunk, std::size_t maxBytes) {
    PngText found;
    const ByteView data = chunk.data;
    const std::optional<std::size_t> end = endOf(data, 0);
    found.keywordBytes = std::min(end.value_or(data.size()), data.size());
    found.keyword = fromLatin1(data.first(std::min(found.keywordBytes, maxKeywordBytes)));
    if (!end || *end == 0 || *end > maxKeywordBytes) {
        found.wrong = Sentence("expected a keyword of 1 to {0} letters and a 0 after it", maxKeywordBytes);
        return found;
    }
    std::size_t at = *end + 1;
    const auto byteAt = [&](std::size_t offset) {
        return offset < data.size() ? std::to_integer<unsigned>(data[offset]) : 256U;
    };
    if (chunk.type == "tEXt") {
        found.textOffset = at;
        found.text = fromLatin1(data.subspan(at, std::min(data.size() - at, maxBytes)));
        found.tooLong = data.size() - at > maxBytes;
        return found;
    }
    const bool international = chunk.type == "iTXt";
    const unsigned packed = international ? byteAt(at) : 1;
    const unsigned method = byteAt(international ? at + 1 : at);
    at += international ? 2 : 1;
    if (packed > 1 || method != 0) {
        found.wrong =
            packed > 1 ? N_("expected 0 or 1 as the compression flag") : N_("expected compression method 0");
        return found;
    }
    for (int before = 0; international && before < 2; ++before) { // the language, the translated keyword
        const std::optional<std::size_t> stop = endOf(data, at);
        if (!stop) {
            found.wrong = N_("expected a language and a translated keyword, each with a 0 after it");
            return found;
        }
        at = *stop + 1;
    }
    found.textOffset = at;
    const ByteView text = data.subspan(at);
    if (packed == 1)
        return readPacked(std::move(found), text, !international, maxBytes);
    found.tooLong = text.size() > maxBytes;
    found.text = charactersOf(text.first(std::min(text.size(), maxBytes)));
    return found;
}

Result<std::pair<std::string, Bytes>> textChunk(const PictureText& text) {
    if (const Result<void> good = checkKeyword(text.keyword); !good)
        return fail(good.error());
    Bytes data;
    append(data, text.keyword);
    data.push_back(std::byte{0});
    const bool packed = text.text.size() >= packedTextBytes;
    if (!packed && isAscii(text.text)) {
        append(data, text.text);
        return std::pair<std::string, Bytes>{"tEXt", std::move(data)};
    }
    data.push_back(packed ? std::byte{1} : std::byte{0});
    for (int i = 0; i < 3; ++i) // the method; no language, no translated keyword
        data.push_back(std::byte{0});
    if (packed)
        appendPacked(data, text.text);
    else
        append(data, text.text);
    return std::pair<std::string, Bytes>{"iTXt", std::move(data)};
}

Result<std::optional<std::string>> findPngText(ByteView file, std::string_view keyword,
                                               std::size_t maxBytes) {
    if (!hasPngSignature(file))
        return fail(ErrorCode::Malformed, "PNG: it doesn't begin as a PNG");
    for (PngChunks chunks(file); const std::optional<PngChunk> chunk = chunks.next();) {
        if (!isTextChunk(*chunk) ||
            !fromLatin1(chunk->data.first(std::min(chunk->data.size(), keyword.size()))).starts_with(keyword))
            continue;
        PngText text = readTextChunk(*chunk, maxBytes);
        if (text.keyword != keyword)
            continue;
        if (text.tooLong)
            return fail(ErrorCode::TooLarge,
                        Sentence("PNG: its text \"{0}\" holds more than {1} bytes", keyword, maxBytes));
        if (!text.wrong.empty())
            return fail(ErrorCode::Malformed,
                        Sentence("PNG: its text \"{0}\" can't be read: {1}", keyword, text.wrong));
        if (!chunk->complete() || libdeflate_crc32(0, file.data() + chunk->offset + 4,
                                                   4 + std::size_t{chunk->length}) != *chunk->crc)
            return fail(ErrorCode::Malformed, Sentence("PNG: its text \"{0}\" is damaged", keyword));
        return std::move(text.text);
    }
    return std::optional<std::string>();
}

} // namespace texplorer
