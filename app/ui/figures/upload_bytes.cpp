#include "app/ui/figures/upload_bytes.h"

#include <algorithm>

namespace texplorer::ui {
namespace {

/// "b g r", and the type unless it is a byte on both sides.
Sentence wordsOf(const PixelLayout& layout, const PixelLayout& other) {
    std::string letters;
    for (const char letter : componentsOf(layout.format)) {
        letters += letters.empty() ? "" : " ";
        letters += letter;
    }
    if (layout.type == TransferType::UnsignedByte && other.type == layout.type)
        return ProperName{letters};
    return Sentence("{0}, {1}", ProperName{letters}, rowOf(layout.type).label);
}

Sentence nameOf(const HeldByte& byte) {
    switch (byte.kind) {
    case HeldByte::Kind::Component:
        return Sentence("{0} of pixel ({1}, {2})", ProperName{std::string_view(&byte.component, 1)}, byte.x,
                        byte.y);
    case HeldByte::Kind::Packed:
        return Sentence("part of pixel ({0}, {1})", byte.x, byte.y);
    case HeldByte::Kind::Padding:
        return Sentence("unused, after row {0}", byte.y);
    case HeldByte::Kind::Beyond:
        break;
    }
    return N_("beyond the end of the memory, counts as 0");
}

/// What the bytes of a texel hold: "b g r", with "-" for unused ones and those beyond the end.
std::string heldIn(const UploadBytes& bytes, const ByteRange& range) {
    std::string letters;
    const auto element = static_cast<std::size_t>(factsOf(bytes.held.pixels.type).bytes);
    for (std::size_t byte = range.first; byte < range.end(); ++byte) {
        const HeldByte held = heldByte(bytes, byte);
        const bool isPart = held.kind == HeldByte::Kind::Component || held.kind == HeldByte::Kind::Packed;
        const bool isFirst = !isPart || byte == range.first || byte % bytes.heldStride() % element == 0;
        if (!isFirst) // one letter for a number
            continue;
        letters += letters.empty() ? "" : " ";
        letters += held.kind == HeldByte::Kind::Component ? held.component : isPart ? '*' : '-';
    }
    return letters;
}

} // namespace

HeldByte heldByte(const UploadBytes& bytes, std::size_t byte) {
    if (byte >= bytes.heldBytes())
        return {};
    const auto size = static_cast<std::size_t>(bytesPerPixel(bytes.held.pixels));
    const TransferTypeFacts& facts = factsOf(bytes.held.pixels.type);
    const auto y = static_cast<int>(byte / bytes.heldStride());
    const std::size_t column = byte % bytes.heldStride();
    const auto x = static_cast<int>(column / size);
    if (x >= bytes.extent.width)
        return {HeldByte::Kind::Padding, 0, x, y};
    if (facts.isPacked())
        return {HeldByte::Kind::Packed, 0, x, y};
    const std::size_t component = column % size / static_cast<std::size_t>(facts.bytes);
    return {HeldByte::Kind::Component, componentsOf(bytes.held.pixels.format)[component], x, y};
}

std::optional<TexelPlace> readerOf(const UploadBytes& bytes, std::size_t byte) {
    const auto size = static_cast<std::size_t>(bytesPerPixel(bytes.call.layout));
    const auto width = static_cast<std::size_t>(bytes.extent.width);
    const std::size_t stride = bytes.readStride();
    for (auto y = std::min(static_cast<long long>(byte / stride) - bytes.call.unpacking.skipRows,
                           static_cast<long long>(bytes.extent.height) - 1);
         y >= 0; --y) {
        const std::size_t start = bytesOf(bytes.call, bytes.extent, 0, static_cast<int>(y)).first;
        if (byte < start) // among the skipped pixels
            continue;
        const std::size_t x = (byte - start) / size;
        return x < width ? std::optional(TexelPlace{static_cast<int>(x), static_cast<int>(y)}) : std::nullopt;
    }
    return std::nullopt;
}

Sentence verdictOn(const UploadBytes& bytes) {
    const std::size_t held = bytes.heldStride();
    const std::size_t read = bytes.readStride();
    const int heldPixel = bytesPerPixel(bytes.held.pixels);
    const int readPixel = bytesPerPixel(bytes.call.layout);
    if (heldPixel != readPixel)
        return Sentence("Pixels are {0} bytes in the memory, but OpenGL expects {1}.", heldPixel, readPixel);
    if (held != read && bytes.extent.height > 1)
        return Sentence("Rows are {0} bytes in the memory, but OpenGL expects {1}: the picture is slanted.",
                        held, read);
    if (bytes.held.pixels != bytes.call.layout)
        return Sentence("The memory holds {0}; OpenGL reads {1}.",
                        wordsOf(bytes.held.pixels, bytes.call.layout),
                        wordsOf(bytes.call.layout, bytes.held.pixels));
    if (bytesRead(bytes.call, bytes.extent) > bytes.heldBytes())
        return Sentence("OpenGL reads {0} bytes, the memory has {1}.", bytesRead(bytes.call, bytes.extent),
                        bytes.heldBytes());
    if (bytesOf(bytes.call, bytes.extent, 0, 0).first > 0)
        return Sentence("OpenGL begins at byte {0} of the memory.",
                        bytesOf(bytes.call, bytes.extent, 0, 0).first);
    if (bytes.call.unpacking.swapBytes && factsOf(bytes.call.layout.type).bytes > 1)
        return N_("OpenGL reads the bytes of each number in reverse order.");
    return Sentence("The call fits the memory: rows are {0} bytes.", held);
}

Sentence wordsOf(const UploadBytes& bytes, TexelPlace texel) {
    const ByteRange range = bytesOf(bytes.call, bytes.extent, texel.x, texel.y);
    const std::string held = heldIn(bytes, range);
    const Sentence read = wordsOf(bytes.call.layout, bytes.held.pixels);
    if (range.count == 1)
        return Sentence("Texel ({0}, {1}) = byte {2} of the memory: {3}, read as {4}", texel.x, texel.y,
                        range.first, ProperName{held}, read);
    return Sentence("Texel ({0}, {1}) = bytes {2} to {3} of the memory: {4}, read as {5}", texel.x, texel.y,
                    range.first, range.end() - 1, ProperName{held}, read);
}

Sentence wordsOf(const UploadBytes& bytes, std::size_t byte) {
    const Sentence held = nameOf(heldByte(bytes, byte));
    const std::optional<TexelPlace> texel = readerOf(bytes, byte);
    return texel ? Sentence("Byte {0}: {1}; read by texel ({2}, {3})", byte, held, texel->x, texel->y)
                 : Sentence("Byte {0}: {1}; no texel reads it", byte, held);
}

} // namespace texplorer::ui
