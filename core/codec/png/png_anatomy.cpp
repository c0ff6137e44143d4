#include "texplorer/base/translatable.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_chunks.h"
#include "texplorer/codec/png/png_text.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>

#include <libdeflate.h>
#include <string>
#include <string_view>
#include <utility>

namespace texplorer {

namespace {

constexpr std::size_t maxChunks = 400;                          // of at most ten fields each
constexpr std::size_t unpackedTextBytes = std::size_t{1} << 20; // of what is looked at
constexpr std::size_t shownTextBytes = 60;

struct ChunkMeaning {
    std::string_view type;
    std::string_view meaning;
};

constexpr std::array chunkMeanings{
    ChunkMeaning{"IHDR", N_("the header")},
    ChunkMeaning{"PLTE", N_("the palette")},
    ChunkMeaning{"IDAT", N_("compressed pixels")},
    ChunkMeaning{"IEND", N_("the end")},
    ChunkMeaning{"tRNS", N_("transparency without an alpha channel")},
    ChunkMeaning{"gAMA", N_("gamma times 100000")},
    ChunkMeaning{"sRGB", N_("the colours are sRGB")},
    ChunkMeaning{"pHYs", N_("size of a pixel")},
    ChunkMeaning{"tEXt", N_("text")},
    ChunkMeaning{"zTXt", N_("compressed text")},
    ChunkMeaning{"iTXt", N_("text in UTF-8")},
    ChunkMeaning{"iCCP", N_("a colour profile")},
};

Sentence meaningOf(const PngChunk& chunk) {
    for (const ChunkMeaning& each : chunkMeanings)
        if (each.type == chunk.type)
            return each.meaning;
    return (chunk.type[0] & 0x20) != 0 ? N_("may be skipped") : N_("unknown and not skippable");
}

Sentence wrongOrder(const PngChunk& chunk, std::size_t index, std::string_view before, bool pixelsSeen) {
    if ((index == 0) != (chunk.type == "IHDR"))
        return index == 0 ? N_("expected IHDR first") : N_("a second IHDR");
    if (chunk.type == "IDAT" && pixelsSeen && before != "IDAT")
        return N_("the IDAT chunks must follow each other");
    if ((chunk.type == "PLTE" || chunk.type == "tRNS") && pixelsSeen)
        return N_("expected before the first IDAT");
    return {};
}

const char* colorTypeName(std::uint8_t type) {
    constexpr std::array names{N_("grey"),         "", "RGB", N_("palette"), N_("grey and alpha"), "",
                               N_("RGB and alpha")};
    return type < names.size() ? names[type] : "";
}

void describeHeader(const PngChunk& chunk, std::vector<Field>& fields) {
    const PngHeader header = readPngHeader(chunk.data);
    const std::size_t at = chunk.offset + 8;
    const auto add = [&](std::size_t offset, std::size_t size, Sentence name, std::uint32_t value,
                         Sentence meaning, bool good, Sentence expected) {
        if (offset + size <= chunk.data.size())
            fields.push_back({at + offset, size, std::move(name), std::to_string(value), std::move(meaning),
                              good ? Sentence() : std::move(expected), 1});
    };
    const Sentence kind = colorTypeName(header.colorType);
    add(0, 4, N_("width"), header.width, N_("pixels"), header.width > 0, N_("expected 1 or more"));
    add(4, 4, N_("height"), header.height, N_("pixels"), header.height > 0, N_("expected 1 or more"));
    add(8, 1, N_("bit depth"), header.depth, N_("bits a sample"),
        header.depth <= 16 && (0x10116U >> header.depth & 1) != 0, N_("expected 1, 2, 4, 8 or 16"));
    add(9, 1, N_("colour type"), header.colorType, kind, !kind.empty(), N_("expected 0, 2, 3, 4 or 6"));
    add(10, 1, N_("compression"), header.compression, "deflate", header.compression == 0, N_("expected 0"));
    add(11, 1, N_("filter"), header.filter, N_("five kinds of row filter"), header.filter == 0,
        N_("expected 0"));
    add(12, 1, N_("interlace"), header.interlace, header.interlace == 1 ? N_("Adam7") : N_("none"),
        header.interlace < 2, N_("expected 0 or 1"));
}

/// The beginning of a text, in one line.
std::string shownText(std::string_view text) {
    std::size_t end = std::min(shownTextBytes, text.size());
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
        --end; // a letter stays whole
    return printable(text.substr(0, end)) + (end < text.size() ? " …" : "");
}

void describeText(const PngChunk& chunk, std::vector<Field>& fields) {
    const PngText text = readTextChunk(chunk, unpackedTextBytes);
    const std::size_t at = chunk.offset + 8;
    fields.push_back({at, text.keywordBytes, N_("keyword"), shownText(text.keyword), {}, text.wrong, 1});
    if (text.textOffset == 0)
        return;
    Sentence meaning;
    if (text.packed && text.wrong.empty())
        meaning = text.tooLong ? Sentence("more than {0} bytes uncompressed", unpackedTextBytes)
                               : Sentence("{0} bytes uncompressed", text.text.size());
    fields.push_back({at + text.textOffset,
                      chunk.length - text.textOffset,
                      N_("text"),
                      shownText(text.text),
                      std::move(meaning),
                      {},
                      1});
}

void describeChunk(const PngChunk& chunk, Sentence wrong, std::vector<Field>& fields) {
    fields.push_back(
        {chunk.offset, chunk.size(), printable(chunk.type), {}, meaningOf(chunk), std::move(wrong), 0});
    fields.push_back(
        {chunk.offset, 4, N_("length"), std::to_string(chunk.length), N_("bytes of data"), {}, 1});
    if (chunk.type == "IHDR")
        describeHeader(chunk, fields);
    else if (isTextChunk(chunk) && chunk.length > 0)
        describeText(chunk, fields);
    else if (chunk.length > 0)
        fields.push_back({chunk.offset + 8, chunk.length, N_("data"), {}, {}, {}, 1});
    if (!chunk.complete())
        return;
    const std::uint32_t found = pngCrc(chunk);
    fields.push_back({chunk.offset + 8 + chunk.length, 4, "CRC", fmt::format("{:#010x}", *chunk.crc),
                      N_("of type and data"),
                      found == *chunk.crc ? Sentence() : Sentence("the bytes give {0:#010x}", found), 1});
}

/// Of a chunk that isn't listed: what is wrong with its place or its CRC; empty: nothing.
Sentence faultOf(const PngChunk& chunk, const Sentence& order) {
    if (!order.empty())
        return Sentence("{0} at {1}: {2}", ProperName{printable(chunk.type)}, chunk.offset, order);
    if (!chunk.complete() || pngCrc(chunk) == *chunk.crc)
        return {};
    return Sentence("the CRC of {0} at {1} does not match its bytes", ProperName{printable(chunk.type)},
                    chunk.offset);
}

} // namespace

Anatomy dissectPng(ByteView file) {
    Anatomy anatomy{"PNG", {}, {}};
    anatomy.fields.push_back({0,
                              pngSignature.size(),
                              N_("Signature"),
                              {},
                              "89 50 4e 47 0d 0a 1a 0a",
                              hasPngSignature(file) ? "" : N_("wrong bytes"),
                              0});
    PngChunks chunks(file);
    std::string before;
    bool pixelsSeen = false;
    for (std::size_t index = 0; const std::optional<PngChunk> chunk = chunks.next(); ++index) {
        if (index == maxChunks)
            anatomy.fields.push_back({chunk->offset, 0, N_("More chunks"), {}, {}, {}, 0});
        if (index < maxChunks) {
            describeChunk(*chunk, wrongOrder(*chunk, index, before, pixelsSeen), anatomy.fields);
        } else {
            Field& more = anatomy.fields.back();
            more.size = chunk->offset + chunk->size() - more.offset;
            more.value = std::to_string(index + 1 - maxChunks);
            more.meaning = Sentence("only the first {0} are listed", maxChunks);
            if (more.wrong.empty())
                more.wrong = faultOf(*chunk, wrongOrder(*chunk, index, before, pixelsSeen));
        }
        if (!chunk->complete()) {
            anatomy.damage =
                Sentence("the chunk {0} at offset {1} needs {2} bytes, the file has {3}",
                         ProperName{printable(chunk->type)}, chunk->offset, chunk->size(), file.size());
            return anatomy;
        }
        pixelsSeen = pixelsSeen || chunk->type == "IDAT";
        before = chunk->type;
        if (chunk->type == "IEND")
            break;
    }
    const std::size_t end = chunks.offset();
    if (before != "IEND")
        anatomy.damage = Sentence("the file ends at offset {0} without an IEND", file.size());
    else if (end < file.size())
        anatomy.fields.push_back(
            {end, file.size() - end, N_("Trailing data"), {}, N_("after the end"), N_("not read"), 0});
    return anatomy;
}

} // namespace texplorer
