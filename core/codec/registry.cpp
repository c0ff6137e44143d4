#include "core/codec/registry.h"

#include <algorithm>
#include <array>
#include <string>

namespace texplorer {

namespace {

bool beginsWith(ByteView file, std::string_view magic) {
    return file.size() >= magic.size() &&
           std::ranges::equal(file.first(magic.size()), std::as_bytes(std::span(magic)));
}

constexpr std::array rows{
    CodecRow{"BMP", ".bmp", [](ByteView file) { return beginsWith(file, "BM"); }, decodeBmp},
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

std::span<const CodecRow> codecRows() {
    return rows;
}

const CodecRow* recogniseImage(ByteView file) {
    const auto found = std::ranges::find_if(rows, [&](const CodecRow& row) { return row.recognise(file); });
    return found == rows.end() ? nullptr : &*found;
}

Result<Image> decodeImage(ByteView file, const DecodeLimits& limits) {
    if (const CodecRow* codec = recogniseImage(file))
        return codec->decode(file, limits);
    std::string known;
    for (const CodecRow& row : rows)
        known.append(known.empty() ? "" : ", ").append(row.name);
    if (file.empty())
        return fail(ErrorCode::Malformed, "expected an image (" + known + "), the file is empty");
    return fail(ErrorCode::Unsupported,
                "expected an image (" + known + "), the file begins with " + firstBytes(file));
}

} // namespace texplorer
