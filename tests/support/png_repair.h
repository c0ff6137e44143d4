#pragma once

#include "texplorer/base/bytes.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace texplorer::test {

/// The checksum of PNG's annex D, bit by bit.
[[nodiscard]] inline std::uint32_t pngCrc(ByteView bytes) {
    std::uint32_t crc = 0xFFFFFFFF;
    for (const std::byte byte : bytes) {
        crc ^= std::to_integer<std::uint32_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc & 1) != 0 ? crc >> 1 ^ 0xEDB88320 : crc >> 1;
    }
    return ~crc;
}

/// Makes the checksums of all whole chunks of a PNG right again, so that a changed file is refused for what
/// it says rather than for its checksum. Other files are left as they are.
inline void repairPng(std::span<std::byte> file) {
    constexpr std::size_t signature = 8;
    if (file.size() < signature || file[0] != std::byte{0x89} || file[1] != std::byte{'P'})
        return;
    // |length: 4, big-endian|type: 4|data: length|CRC of type and data: 4, big-endian|
    for (std::size_t at = signature; file.size() - at >= 12;) {
        std::size_t length = 0;
        for (std::size_t i = 0; i < 4; ++i)
            length = length << 8 | std::to_integer<std::size_t>(file[at + i]);
        if (length > file.size() - at - 12)
            return;
        const std::uint32_t crc = pngCrc(file.subspan(at + 4, 4 + length));
        for (std::size_t i = 0; i < 4; ++i)
            file[at + 8 + length + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
        at += 12 + length;
    }
}

} // namespace texplorer::test
