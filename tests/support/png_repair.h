#pragma once

#include "core/base/bytes.h"

#include <cstdint>

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

/// Makes the checksums of all whole chunks right, so that damage in a file gets past them.
inline void repairPng(Bytes& file) {
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8 | std::to_integer<std::uint32_t>(file[at + i]);
        return value;
    };
    for (std::size_t at = 8; at + 12 <= file.size();) {
        const std::size_t length = number(at);
        if (length > file.size() - at - 12)
            return;
        const std::uint32_t crc = pngCrc(ByteView(file).subspan(at + 4, length + 4));
        for (std::size_t i = 0; i < 4; ++i)
            file[at + 8 + length + i] = static_cast<std::byte>(crc >> (24 - 8 * i));
        at += 12 + length;
    }
}

} // namespace texplorer::test
