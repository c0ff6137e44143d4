#include "texplorer/suite/png_size.h"

#include "texplorer/files/file_io.h"

#include <algorithm>
#include <string_view>

namespace texplorer::suite {
namespace {

constexpr std::size_t pngHeaderBytes = 24; // up to the height

int bigEndian(ByteView bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8U | std::to_integer<std::uint32_t>(bytes[at + i]);
    return number <= static_cast<std::uint32_t>(maxPictureSize) ? static_cast<int>(number) : 0;
}

} // namespace

std::optional<PictureSize> sizeOfPng(const std::filesystem::path& file) {
    constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
    const Result<Bytes> start = readFileStart(file, pngHeaderBytes);
    if (!start || start->size() < pngHeaderBytes ||
        !std::ranges::equal(ByteView(*start).first(signature.size()), viewBytes(signature)))
        return std::nullopt;
    const PictureSize size{bigEndian(*start, 16), bigEndian(*start, 20)};
    return size.width > 0 && size.height > 0 ? std::optional(size) : std::nullopt;
}

} // namespace texplorer::suite
