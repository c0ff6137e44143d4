#include "texplorer/codec/dds/dds_header.h"

#include "texplorer/base/byte_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace texplorer::dds {

bool Header::hasFourCC() const {
    constexpr std::uint32_t otherKinds =
        formatAlpha | formatRgb | formatLuminance | formatZBuffer | formatUnread;
    return fourCC != 0 && ((formatFlags & formatFourCC) != 0 || (formatFlags & otherKinds) == 0);
}

bool Header::extended() const {
    return hasFourCC() && fourCC == dds::fourCC("DX10");
}

Header readHeader(ByteView file) {
    ByteReader reader(file);
    reader.skip(at::size);
    Header header;
    header.size = reader.u32();
    header.flags = reader.u32();
    header.height = reader.u32();
    header.width = reader.u32();
    header.pitchOrLinearSize = reader.u32();
    header.depth = reader.u32();
    header.mipMapCount = reader.u32();
    reader.skip(at::formatSize - at::reserved);
    header.formatSize = reader.u32();
    header.formatFlags = reader.u32();
    header.fourCC = reader.u32();
    header.bitCount = reader.u32();
    for (std::uint32_t& mask : header.masks)
        mask = reader.u32();
    header.caps = reader.u32();
    header.caps2 = reader.u32();
    reader.skip(legacyEnd - at::caps3);
    if (header.extended()) {
        header.dxgiFormat = reader.u32();
        header.dimension = reader.u32();
        header.miscFlag = reader.u32();
        header.arraySize = reader.u32();
        header.miscFlags2 = reader.u32();
    }
    return header;
}

Bytes writeHeader(const Header& header) {
    Bytes file(header.end(), std::byte{0});
    const auto put = [&](std::size_t offset, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i)
            file[offset + i] = static_cast<std::byte>(value >> (8 * i));
    };
    put(0, fourCC("DDS "));
    put(at::size, header.size);
    put(at::flags, header.flags);
    put(at::height, header.height);
    put(at::width, header.width);
    put(at::pitchOrLinearSize, header.pitchOrLinearSize);
    put(at::depth, header.depth);
    put(at::mipMapCount, header.mipMapCount);
    put(at::formatSize, header.formatSize);
    put(at::formatFlags, header.formatFlags);
    put(at::fourCC, header.fourCC);
    put(at::bitCount, header.bitCount);
    for (std::size_t i = 0; i < header.masks.size(); ++i)
        put(at::masks + 4 * i, header.masks[i]);
    put(at::caps, header.caps);
    put(at::caps2, header.caps2);
    if (header.extended()) {
        put(at::dxgiFormat, header.dxgiFormat);
        put(at::dimension, header.dimension);
        put(at::miscFlag, header.miscFlag);
        put(at::arraySize, header.arraySize);
        put(at::miscFlags2, header.miscFlags2);
    }
    return file;
}

std::string hex(std::uint32_t value) {
    return fmt::format("0x{:08X}", value);
}

std::string spellBits(std::uint32_t bits, std::span<const NameRow> rows) {
    std::string text;
    const auto add = [&](std::string_view name) { text.append(text.empty() ? "" : " | ").append(name); };
    for (const NameRow& row : rows) {
        if ((bits & row.value) != 0)
            add(row.name);
        bits &= ~row.value;
    }
    if (bits != 0)
        add(hex(bits));
    return text.empty() ? "0" : text;
}

std::string spellFourCC(std::uint32_t code) {
    std::string text = "\"";
    for (int shift = 0; shift < 32; shift += 8) {
        const auto c = static_cast<char>(code >> shift & 0xFF);
        if (c < 0x20 || c > 0x7E)
            return hex(code);
        text += c;
    }
    return text + "\"";
}

} // namespace texplorer::dds
