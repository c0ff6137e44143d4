#pragma once

// DDS files put together by hand, for the tests. The numbers are Microsoft's, written out again.

#include "texplorer/codec/dds/dds_header.h"

namespace texplorer::test {

/// The header of a texture of 1 x 1 texels that nothing is wrong with.
[[nodiscard]] inline dds::Header plainDds() {
    dds::Header header;
    header.flags = 0x1007;
    header.width = header.height = 1;
    header.caps = 0x1000;
    return header;
}

[[nodiscard]] inline dds::Header legacyDds(const char (&code)[5]) {
    dds::Header header = plainDds();
    header.formatFlags = 0x4;
    header.fourCC = dds::fourCC(code);
    return header;
}

[[nodiscard]] inline dds::Header dxgi(std::uint32_t format, std::uint32_t alphaMode = 0) {
    dds::Header header = legacyDds("DX10");
    header.dxgiFormat = format;
    header.dimension = 3;
    header.arraySize = 1;
    header.miscFlags2 = alphaMode;
    return header;
}

[[nodiscard]] inline dds::Header masked(std::uint32_t flags, std::uint32_t bits, std::uint32_t red,
                                        std::uint32_t green, std::uint32_t blue, std::uint32_t alpha = 0) {
    dds::Header header = plainDds();
    header.formatFlags = flags;
    header.bitCount = bits;
    header.masks = {red, green, blue, alpha};
    return header;
}

[[nodiscard]] inline Bytes ddsFile(const dds::Header& header, const std::vector<int>& pixels) {
    Bytes file = dds::writeHeader(header);
    for (const int byte : pixels)
        file.push_back(static_cast<std::byte>(byte));
    return file;
}

} // namespace texplorer::test
