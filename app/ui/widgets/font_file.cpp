#include "app/ui/widgets/fonts.h"

#include <array>
#include <cstdint>
#include <fstream>
#include <optional>
#include <set>

namespace texplorer::ui {
namespace {

/// Numbers in a font, big-endian.
class FontReader {
public:
    explicit FontReader(const std::filesystem::path& file)
        : file_(file, std::ios::binary) {
        std::error_code failed;
        const std::uintmax_t size = std::filesystem::file_size(file, failed);
        size_ = failed ? 0 : size;
    }
    [[nodiscard]] std::uintmax_t size() const { return size_; }

    std::optional<std::uint32_t> number(std::uintmax_t offset, std::size_t bytes) {
        std::array<char, 4> read{};
        if (offset + bytes > size_ || !file_.seekg(static_cast<std::streamoff>(offset)) ||
            !file_.read(read.data(), static_cast<std::streamsize>(bytes)))
            return std::nullopt;
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < bytes; ++i)
            value = value << 8U | static_cast<unsigned char>(read.at(i));
        return value;
    }

private:
    std::ifstream file_;
    std::uintmax_t size_ = 0;
};

constexpr std::uint32_t tag(const char (&name)[5]) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i)
        value = value << 8U | static_cast<unsigned char>(name[i]);
    return value;
}

} // namespace

// OpenType 1.9, "Organization of an OpenType Font": 12 bytes, the second two of which count the tables; of
// each table 16 bytes: tag, checksum, offset and length. A collection has the offset of its first font at 12.
bool isFontFile(const std::filesystem::path& file) {
    std::error_code failed;
    if (!std::filesystem::is_regular_file(file, failed))
        return false;
    FontReader font(file);
    std::uintmax_t start = 0;
    std::optional<std::uint32_t> kind = font.number(0, 4);
    if (kind == tag("ttcf")) {
        start = font.number(12, 4).value_or(0);
        kind = font.number(start, 4);
    }
    if (kind != 0x00010000U && kind != tag("true") && kind != tag("OTTO"))
        return false;
    const std::uint32_t tables = font.number(start + 4, 2).value_or(0);
    std::set<std::uint32_t> found;
    for (std::uint32_t i = 0; i < tables; ++i) {
        const std::uintmax_t row = start + 12 + std::uintmax_t{16} * i;
        const std::optional<std::uint32_t> name = font.number(row, 4);
        const std::optional<std::uint32_t> offset = font.number(row + 8, 4);
        const std::optional<std::uint32_t> length = font.number(row + 12, 4);
        if (!name || !offset || !length || std::uintmax_t{*offset} + *length > font.size())
            return false;
        found.insert(*name);
    }
    for (const std::uint32_t needed : {tag("cmap"), tag("head"), tag("hhea"), tag("hmtx"), tag("maxp")}) {
        if (!found.contains(needed))
            return false;
    }
    return (found.contains(tag("glyf")) && found.contains(tag("loca"))) || found.contains(tag("CFF "));
}

} // namespace texplorer::ui
