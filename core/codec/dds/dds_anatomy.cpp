#include "texplorer/base/byte_reader.h"
#include "texplorer/base/translatable.h"
#include "texplorer/codec/dds/dds.h"
#include "texplorer/codec/dds/dds_layout.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>

namespace texplorer {
namespace {

using namespace dds;

/// Appends fields one after the other and hangs each finding on the field that it is about.
class Dissection {
public:
    Dissection(ByteView file, Findings findings)
        : file_(file)
        , findings_(std::move(findings)) {}

    Field& add(int depth, std::uint64_t offset, std::uint64_t size, Sentence name, Sentence value,
               Sentence meaning) {
        Field field{offset, size, std::move(name), std::move(value), std::move(meaning), {}, depth};
        if (offset + size > file_.size()) {
            field.value = {};
            blame(field, Sentence("it ends at offset {0}, the file at {1}", offset + size, file_.size()));
        }
        for (const Finding& finding : findings_) {
            if (finding.offset == offset && finding.isFault)
                blame(field, finding.sentence);
            else if (finding.offset == offset)
                field.meaning = Sentence("{0}; {1}", field.meaning, finding.sentence);
        }
        anatomy.fields.push_back(std::move(field));
        return anatomy.fields.back();
    }

    void section(std::uint64_t offset, std::uint64_t size, Sentence name, Sentence meaning) {
        anatomy.fields.push_back({offset, size, std::move(name), {}, std::move(meaning), {}, 0});
        if (offset + size > file_.size())
            anatomy.fields.back().wrong =
                Sentence("it needs {0} bytes, the file has {1} of them", size,
                         file_.size() - std::min<std::uint64_t>(file_.size(), offset));
    }

    Field& number(std::size_t offset, Sentence name, std::uint32_t value, Sentence meaning) {
        return add(1, offset, 4, std::move(name), std::to_string(value), std::move(meaning));
    }

    /// A field of bits: the value is their names.
    Field& bits(std::size_t offset, Sentence name, std::uint32_t value, std::span<const NameRow> rows) {
        std::vector<Sentence> meanings;
        for (const NameRow& row : rows)
            if ((value & row.value) != 0)
                meanings.emplace_back(row.meaning);
        return add(1, offset, 4, std::move(name),
                   Sentence("{0}: {1}", ProperName{hex(value)}, ProperName{spellBits(value, rows)}),
                   Sentence::joined("{0}; {1}", meanings));
    }

    /// A field that has one of several values.
    Field& choice(std::size_t offset, Sentence name, std::uint32_t value, std::span<const NameRow> rows) {
        const auto row = std::ranges::find(rows, value, &NameRow::value);
        const bool known = row != rows.end();
        return add(1, offset, 4, std::move(name),
                   known ? Sentence("{0}: {1}", value, ProperName{row->name})
                         : Sentence(std::to_string(value)),
                   known ? Sentence(row->meaning) : N_("unknown value"));
    }

    static void blame(Field& field, const Sentence& sentence) {
        field.wrong = field.wrong.empty() ? sentence : Sentence("{0}; {1}", field.wrong, sentence);
    }

    Anatomy anatomy{"DDS", {}, {}};

private:
    ByteView file_;
    Findings findings_;
};

std::uint32_t wordAt(ByteView file, std::size_t offset) {
    ByteReader reader(file);
    reader.skip(offset);
    return reader.u32();
}

/// What a program may have left there: text as far as it is text.
std::string reservedText(ByteView file) {
    const ByteView bytes =
        file.size() <= at::reserved
            ? ByteView{}
            : file.subspan(at::reserved, std::min<std::size_t>(44, file.size() - at::reserved));
    if (std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0}; }))
        return N_("zeros");
    std::string text = "\"";
    for (const std::byte byte : bytes) {
        const auto c = std::to_integer<char>(byte);
        text += c >= 0x20 && c <= 0x7E ? c : '.';
    }
    return text + "\"";
}

Sentence describeFormat(const DxgiRow* format) {
    if (format == nullptr)
        return N_("not a format that is read");
    if (std::holds_alternative<UnreadPixels>(format->pixels))
        return N_("known, but not read");
    if (const BlockFormat* block = std::get_if<BlockFormat>(&format->pixels))
        return findRow(EnumTable<BlockFormat>::rows, static_cast<std::uint32_t>(*block))->help;
    return Sentence("uncompressed, {0} bits a pixel", std::get<MaskedPixels>(format->pixels).bits);
}

Sentence describeMask(std::string_view channel, std::uint32_t mask) {
    if (mask == 0)
        return Sentence("no {0}", channel);
    const int low = std::countr_zero(mask);
    const int high = 31 - std::countl_zero(mask);
    const Sentence text = low == high ? Sentence("{0} in bit {1}", channel, low)
                                      : Sentence("{0} in bits {1} to {2}", channel, low, high);
    const bool holes = std::popcount(mask) != high - low + 1;
    return holes ? Sentence("{0}, with holes", text) : text;
}

void addPixelFormat(Dissection& to, const Header& header) {
    to.section(at::formatSize, formatSize, "DDS_PIXELFORMAT", N_("the pixel format, within the header"));
    to.number(at::formatSize, "ddspf.dwSize", header.formatSize, "bytes of this structure: 32");
    to.bits(at::formatFlags, "ddspf.dwFlags", header.formatFlags, formatFlagRows);
    Sentence code = N_("not a format that is read");
    if (header.fourCC == 0)
        code = N_("none: the masks define the format");
    else if (header.fourCC == fourCC("DX10"))
        code = N_("a DX10 header follows with the format");
    else if (const auto row = std::ranges::find(fourCCRows(), header.fourCC, &FourCCRow::code);
             row != fourCCRows().end())
        code = findRow(EnumTable<BlockFormat>::rows, static_cast<std::uint32_t>(row->format))->help;
    to.add(1, at::fourCC, 4, "ddspf.dwFourCC", header.fourCC == 0 ? "0" : spellFourCC(header.fourCC), code);
    to.number(at::bitCount, "ddspf.dwRGBBitCount", header.bitCount,
              header.hasFourCC() ? N_("bits a pixel; ignored with a FourCC") : N_("bits a pixel"));
    constexpr std::array<std::string_view, 4> letters{"R", "G", "B", "A"};
    constexpr std::array<std::string_view, 4> channels{N_("red"), N_("green"), N_("blue"), N_("alpha")};
    const bool luminance = (header.formatFlags & formatLuminance) != 0;
    const bool depth = (header.formatFlags & formatZBuffer) != 0;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::string_view channel = luminance && i == 0 ? N_("luminance")
                                         : depth && i == 1   ? N_("depth")
                                                             : channels[i];
        to.add(1, at::masks + 4 * i, 4, ProperName{fmt::format("ddspf.dw{}BitMask", letters[i])},
               hex(header.masks[i]), describeMask(channel, header.masks[i]));
    }
}

void addHeader(Dissection& to, ByteView file, const Header& header) {
    Field& magic = to.add(0, 0, 4, "dwMagic", spellFourCC(wordAt(file, 0)), N_("\"DDS \" in every DDS file"));
    if (file.size() >= 4 && wordAt(file, 0) != fourCC("DDS "))
        Dissection::blame(magic, N_("expected \"DDS \""));
    to.section(at::size, headerSize, "DDS_HEADER", N_("the header of every DDS file"));
    Field& size = to.number(at::size, "dwSize", header.size, "bytes of this structure: 124");
    if (file.size() >= 8 && header.size != headerSize)
        Dissection::blame(size, N_("expected 124"));
    to.bits(at::flags, "dwFlags", header.flags, flagRows);
    to.number(at::height, "dwHeight", header.height, "rows of texels in level 0");
    to.number(at::width, "dwWidth", header.width, "texels in a row of level 0");
    to.number(at::pitchOrLinearSize, "dwPitchOrLinearSize", header.pitchOrLinearSize,
              (header.flags & flagLinearSize) != 0 ? N_("bytes of level 0")
              : (header.flags & flagPitch) != 0
                  ? N_("bytes of a row of level 0")
                  : N_("neither DDSD_PITCH nor DDSD_LINEARSIZE is set: no meaning"));
    to.number(at::depth, "dwDepth", header.depth, "slices of a volume");
    to.number(at::mipMapCount, "dwMipMapCount", header.mipMapCount, "levels, with level 0; 0 means one");
    to.add(1, at::reserved, 44, "dwReserved1", reservedText(file),
           N_("not used; some programs store their "
              "name here"));
    addPixelFormat(to, header);
    to.bits(at::caps, "dwCaps", header.caps, capsRows);
    to.bits(at::caps2, "dwCaps2", header.caps2, caps2Rows);
    to.number(at::caps3, "dwCaps3", wordAt(file, at::caps3), "not used");
    to.number(at::caps4, "dwCaps4", wordAt(file, at::caps4), "not used");
    to.number(at::reserved2, "dwReserved2", wordAt(file, at::reserved2), "not used");
}

void addExtendedHeader(Dissection& to, const Header& header) {
    to.section(at::dxgiFormat, extendedEnd - legacyEnd, "DDS_HEADER_DXT10",
               N_("the extension of Direct3D 10 and later: any DXGI format"));
    const DxgiRow* format = findDxgi(header.dxgiFormat);
    to.add(1, at::dxgiFormat, 4, "dxgiFormat",
           format ? Sentence("{0}: {1}", header.dxgiFormat, ProperName{format->name})
                  : Sentence(std::to_string(header.dxgiFormat)),
           describeFormat(format));
    to.choice(at::dimension, "resourceDimension", header.dimension, dimensionRows);
    to.bits(at::miscFlag, "miscFlag", header.miscFlag, miscRows);
    to.number(at::arraySize, "arraySize", header.arraySize, "textures in an array; a cube map counts as one");
    Field& alpha = to.choice(at::miscFlags2, "miscFlags2", header.miscFlags2 & alphaModeMask, alphaModeRows);
    if ((header.miscFlags2 & ~alphaModeMask) != 0)
        Dissection::blame(
            alpha, Sentence("bits {0} have no meaning", ProperName{hex(header.miscFlags2 & ~alphaModeMask)}));
}

Sentence describeLevel(const Layout& layout, const Level& level) {
    const auto blocks = [](int extent) { return (extent + 3) / 4; };
    const std::string slices = level.depth > 1 ? fmt::format(" × {}", level.depth) : "";
    const BlockFormat* block = std::get_if<BlockFormat>(&layout.format.pixels);
    const UnreadPixels* unread = std::get_if<UnreadPixels>(&layout.format.pixels);
    if (block != nullptr || (unread != nullptr && unread->extent > 1))
        return Sentence("{0} × {1}{2} blocks of {3} bytes", blocks(level.width), blocks(level.height),
                        ProperName{slices},
                        block != nullptr ? bytesPerBlock(*block) : static_cast<std::size_t>(unread->bytes));
    return Sentence("rows of {0} bytes, top row first", level.size /
                                                            static_cast<std::uint64_t>(level.height) /
                                                            static_cast<std::uint64_t>(level.depth));
}

void addLevels(Dissection& to, const Layout& layout) {
    to.section(layout.begin, layout.end() - layout.begin, N_("pixel data"),
               Sentence("{0}, {1}", ProperName{layout.format.name},
                        layout.faces > 1 ? N_("face by face, each with all its levels")
                                         : N_("level by level, largest first")));
    for (int face = 0; face < layout.faces; ++face)
        for (int i = 0; i < layout.levels; ++i) {
            const Level level = layout.at(face, i);
            Sentence name = layout.faces > 1 ? Sentence("face {0}, level {1}", faceName(face), i)
                                             : Sentence("level {0}", i);
            Field& field =
                to.add(1, level.offset, level.size, std::move(name), "", describeLevel(layout, level));
            field.value = fmt::format("{} × {}{}", level.width, level.height,
                                      layout.depth > 1 ? fmt::format(" × {}", level.depth) : "");
        }
}

} // namespace

Anatomy dissectDds(ByteView file) {
    Findings findings;
    const Header header = readHeader(file);
    const Result<Layout> layout = planLayout(file, {}, findings);
    Sentence damage;
    if (!layout)
        damage = layout.error().message;
    else if (const Result<int> levels = wholeLevels(*layout, file.size(), findings); !levels)
        damage = levels.error().message;
    else if (file.size() < layout->end())
        damage =
            Sentence("DDS: the last level ends at offset {0}, the file at {1}", layout->end(), file.size());

    Dissection dissection(file, std::move(findings));
    addHeader(dissection, file, header);
    if (header.extended() && file.size() > legacyEnd)
        addExtendedHeader(dissection, header);
    if (layout) {
        addLevels(dissection, *layout);
        const std::uint64_t elementsEnd = std::min<std::uint64_t>(layout->arrayEnd(), file.size());
        if (elementsEnd > layout->end())
            dissection.add(0, layout->end(), elementsEnd - layout->end(), N_("other elements"),
                           Sentence("{0} of the array", layout->elements - 1),
                           N_("scenes show only the first"));
        if (file.size() > elementsEnd)
            dissection.add(0, elementsEnd, file.size() - elementsEnd, N_("trailing bytes"), "",
                           N_("not part of any level"));
    }
    dissection.anatomy.damage = std::move(damage);
    return std::move(dissection.anatomy);
}

} // namespace texplorer
