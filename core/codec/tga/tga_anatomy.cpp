#include "texplorer/base/byte_reader.h"
#include "texplorer/base/sentence.h"
#include "texplorer/base/translatable.h"
#include "texplorer/codec/tga/tga.h"
#include "texplorer/codec/tga/tga_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace texplorer {

namespace {

using namespace tga;

constexpr std::size_t maxMapEntries = 256; // of a colour map, one field each
constexpr std::size_t maxPackets = 64;
constexpr std::size_t maxTags = 64; // of the developer directory

using Fields = std::vector<Field>;

Field section(Sentence name, std::uint64_t offset, std::uint64_t size, Sentence value = {},
              Sentence meaning = {}, Sentence wrong = {}) {
    return {offset, size, std::move(name), std::move(value), std::move(meaning), std::move(wrong), 0};
}

Field field(Sentence name, std::uint64_t offset, std::uint64_t size, Sentence value, Sentence meaning = {},
            Sentence wrong = {}) {
    return {offset, size, std::move(name), std::move(value), std::move(meaning), std::move(wrong), 1};
}

Sentence beyond(std::uint64_t offset, std::uint64_t size, std::size_t fileSize) {
    if (offset <= fileSize && size <= fileSize - offset)
        return {};
    return Sentence("ends at offset {0}, the file has {1}", offset + size,
                    Sentence::plural("{0} byte", "{0} bytes", fileSize));
}

// Text up to its first NUL; what can't be printed as a dot.
std::string text(ByteView bytes) {
    std::string shown = "\"";
    for (const std::byte byte : bytes) {
        const auto c = std::to_integer<unsigned char>(byte);
        if (c == 0)
            break;
        shown += c >= ' ' && c < 127 ? static_cast<char>(c) : '.';
    }
    return shown + "\"";
}

Fields describeHeader(ByteView file, const Header& header) {
    Fields fields{section("Header", 0, Header::headerBytes)};
    for (const HeaderRow& row : headerRows()) {
        if (row.offset + row.size > file.size())
            break;
        const std::optional<Complaint> complaint = row.complaint(header);
        fields.push_back(field(row.name, row.offset, row.size, row.value(header), row.meaning(header),
                               complaint ? complaint->text : ""));
    }
    return fields;
}

//   "red 255, green 0, blue 0, alpha 1"
Sentence describeEntry(ByteView entry, int bits) {
    std::array<unsigned, 4> bgra{};
    if (entry.size() == 2) {
        const unsigned value = std::to_integer<unsigned>(entry[0]) | std::to_integer<unsigned>(entry[1]) << 8;
        bgra = {value & 31, value >> 5 & 31, value >> 10 & 31, value >> 15};
    } else {
        for (std::size_t i = 0; i < entry.size(); ++i)
            bgra[i] = std::to_integer<unsigned>(entry[i]);
    }
    const Sentence shown =
        bits == 16 || bits == 32
            ? Sentence("red {0}, green {1}, blue {2}, alpha {3}", bgra[2], bgra[1], bgra[0], bgra[3])
            : Sentence("red {0}, green {1}, blue {2}", bgra[2], bgra[1], bgra[0]);
    return entry.size() == 2 ? Sentence("{0} of 31", shown) : shown;
}

Fields describeColorMap(ByteView file, const Header& header) {
    if (header.mapBytes() == 0)
        return {};
    const std::size_t size = header.entryBytes();
    Fields fields{section("Color Map Data", header.mapOffset(), header.mapBytes(),
                          Sentence("{0} entries of {1} bits", header.mapLength, header.entryBits),
                          header.mapped() ? N_("the colours") : N_("not used by this picture"),
                          beyond(header.mapOffset(), header.mapBytes(), file.size()))};
    for (std::size_t i = 0; i < std::min<std::size_t>(header.mapLength, maxMapEntries); ++i) {
        const std::size_t offset = header.mapOffset() + i * size;
        if (size > 4 || !beyond(offset, size, file.size()).empty())
            break;
        fields.push_back(field(Sentence("Entry {0}", header.firstEntry + i), offset, size,
                               describeEntry(file.subspan(offset, size), header.entryBits)));
    }
    return fields;
}

struct Packets {
    Fields first;
    std::size_t bytes = 0;
    std::size_t count = 0;
    std::size_t pixels = 0;
    std::size_t crossing = 0; // the end of a row
    bool cut = false;
};

// Walks all packets, as damage may be in the last, and describes the first.
Packets walkPackets(ByteView data, const Header& header) {
    Packets packets;
    while (packets.pixels < header.pixelCount() && packets.bytes < data.size()) {
        const auto head = std::to_integer<unsigned>(data[packets.bytes]);
        const std::size_t pixels = (head & 127) + 1;
        const std::size_t size = 1 + header.pixelBytes() * (head >= 128 ? 1 : pixels);
        const std::size_t column = packets.pixels % header.width;
        const bool crosses = column + pixels > header.width;
        const bool cut = size > data.size() - packets.bytes;
        if (packets.count < maxPackets || cut)
            packets.first.push_back(field(
                Sentence("Packet {0}", packets.count), header.pixelOffset() + packets.bytes, size,
                head >= 128 ? Sentence("{0} times the same pixel", pixels)
                            : Sentence("{0} raw pixels", pixels),
                Sentence("from column {0} of row {1}", column, packets.pixels / header.width),
                cut ? Sentence("needs {0}, {1} are left", Sentence::plural("{0} byte", "{0} bytes", size),
                               Sentence::plural("{0} byte", "{0} bytes", data.size() - packets.bytes))
                : crosses ? N_("continues beyond the end of its row, which version 2 forbids")
                          : ""));
        packets.cut = cut;
        if (cut)
            break;
        packets.bytes += size;
        packets.pixels += pixels;
        packets.crossing += crosses ? 1 : 0;
        ++packets.count;
    }
    return packets;
}

Fields describePackets(ByteView data, const Header& header, Sentence& damage) {
    Packets packets = walkPackets(data, header);
    const std::uint64_t needed = header.pixelCount();
    Sentence wrong;
    if (packets.pixels < needed) {
        const Sentence got = Sentence("{0} of {1} pixels", packets.pixels, needed);
        wrong = Sentence("ends after {0}", got);
        damage =
            Sentence("the packets end at offset {0}, after {1}", header.pixelOffset() + packets.bytes, got);
    } else if (packets.crossing > 0) {
        wrong = Sentence("{0} packets continue beyond the end of a row", packets.crossing);
    }
    Fields fields{section("Image Data", header.pixelOffset(), packets.bytes,
                          Sentence("{0} packets", packets.count),
                          Sentence("{0} pixels, run-length coded", needed), wrong)};
    std::ranges::move(packets.first, std::back_inserter(fields));
    return fields;
}

Fields describePixels(ByteView data, const Header& header, Sentence& damage) {
    const std::uint64_t size = header.pixelCount() * header.pixelBytes();
    Sentence wrong;
    if (data.size() < size) {
        wrong = Sentence("needs {0}, there are {1}", Sentence::plural("{0} byte", "{0} bytes", size),
                         data.size());
        damage = Sentence("pixel data needs {0} from offset {1}, there are {2}",
                          Sentence::plural("{0} byte", "{0} bytes", size), header.pixelOffset(), data.size());
    }
    return {
        section("Image Data", header.pixelOffset(), size, Sentence("{0} pixels", header.pixelCount()),
                Sentence("rows from the {0}, each from the {1}", header.topFirst() ? N_("top") : N_("bottom"),
                         header.rightToLeft() ? N_("right") : N_("left")),
                wrong)};
}

Fields describeImageData(ByteView data, const Header& header, Sentence& damage) {
    if (header.pixelCount() == 0 || header.pixelBytes() == 0 || header.pixelBytes() > 4)
        return {};
    return header.runLengthCoded() ? describePackets(data, header, damage)
                                   : describePixels(data, header, damage);
}

Sentence ratio(ByteReader& reader) {
    const int above = reader.u16();
    const int below = reader.u16();
    return below == 0 ? N_("not given") : Sentence("{0} / {1}", above, below);
}

// "2026-11-21 12:05:00"; the file has month, day, year, hour, minute, second.
std::string dateTime(ByteReader& reader) {
    std::array<unsigned, 6> numbers{};
    for (unsigned& number : numbers)
        number = reader.u16();
    return fmt::format("{:02}-{:02}-{:02} {:02}:{:02}:{:02}", numbers[2], numbers[0], numbers[1], numbers[3],
                       numbers[4], numbers[5]);
}

Sentence elapsed(ByteReader& reader) {
    const unsigned hours = reader.u16();
    const unsigned minutes = reader.u16();
    return Sentence("{0} h, {1} min, {2} s", hours, minutes, reader.u16());
}

std::string version(ByteReader& reader) {
    const unsigned number = reader.u16();
    const char letter = static_cast<char>(reader.u8());
    std::string shown = fmt::format("{}.{:02}", number / 100, number % 100);
    return letter > ' ' && letter < 127 ? shown + letter : shown;
}

Sentence keyColor(ByteReader& reader) {
    std::array<unsigned, 4> bgra{};
    for (unsigned& component : bgra)
        component = reader.u8();
    return Sentence("red {0}, green {1}, blue {2}, alpha {3}", bgra[2], bgra[1], bgra[0], bgra[3]);
}

std::string number16(ByteReader& reader) {
    return std::to_string(reader.u16());
}

std::string offset32(ByteReader& reader) {
    const std::uint32_t offset = reader.u32();
    return offset == 0 ? N_("0 (none)") : std::to_string(offset);
}

std::string characters(ByteReader& reader, std::size_t size) {
    return text(reader.take(size));
}

std::string_view attributesMeaning(int type) {
    constexpr std::array<std::string_view, 5> meanings{N_("no alpha"), N_("undefined, can be ignored"),
                                                       N_("undefined, should be kept"), N_("useful alpha"),
                                                       N_("premultiplied alpha")};
    return type < static_cast<int>(meanings.size()) ? meanings[static_cast<std::size_t>(type)]
                                                    : std::string_view{N_("reserved")};
}

Fields describeExtension(ByteView file, const Footer& footer) {
    const std::size_t begin = footer.extensionOffset;
    if (begin == 0 || begin >= file.size())
        return {}; // the footer's field says that it is wrong
    ByteReader reader(file.subspan(begin));
    Fields fields{
        section("Extension Area", begin, extensionBytes, {}, {}, beyond(begin, extensionBytes, file.size()))};
    const auto add = [&](Sentence name, auto read, Sentence meaning = {}) {
        const std::size_t offset = reader.position();
        Sentence value = read(reader);
        if (!reader.truncated())
            fields.push_back(field(std::move(name), begin + offset, reader.position() - offset,
                                   std::move(value), std::move(meaning)));
    };
    const auto chars = [](std::size_t size) { return [size](ByteReader& r) { return characters(r, size); }; };
    add(N_("Extension Size"), number16, N_("bytes, 495 in version 2.0"));
    if (fields.size() > 1 && fields.back().value != std::to_string(extensionBytes))
        fields.back().wrong = N_("expected 495");
    add(N_("Author Name"), chars(41));
    for (const int line : {1, 2, 3, 4})
        add(Sentence("Author Comments, line {0}", line), chars(81));
    add(N_("Date/Time Stamp"), dateTime, N_("time of saving"));
    add(N_("Job Name/ID"), chars(41));
    add(N_("Job Time"), elapsed, N_("working time"));
    add(N_("Software ID"), chars(41));
    add(N_("Software Version"), version);
    add(N_("Key Color"), keyColor, N_("colour of the background"));
    add(N_("Pixel Aspect Ratio"), ratio, N_("width / height"));
    add(N_("Gamma Value"), ratio);
    add(N_("Color Correction Offset"), offset32);
    add(N_("Postage Stamp Offset"), offset32);
    add(N_("Scan Line Offset"), offset32);
    add(
        N_("Attributes Type"), [](ByteReader& r) { return std::to_string(r.u8()); }, N_("meaning of alpha"));
    if (Field& last = fields.back(); last.name == "Attributes Type") {
        const int type = std::to_integer<int>(bytesOf(last, file).front());
        last.meaning = attributesMeaning(type);
        if (type > 4)
            last.wrong = N_("expected 0 to 4");
    }
    return fields;
}

Fields describeDeveloper(ByteView file, const Footer& footer) {
    const std::size_t begin = footer.developerOffset;
    if (begin == 0 || begin >= file.size())
        return {};
    ByteReader reader(file.subspan(begin));
    const std::size_t tags = reader.u16();
    Fields fields{section("Developer Directory", begin, 2 + 10 * tags, Sentence("{0} tags", tags), {},
                          beyond(begin, 2 + 10 * tags, file.size()))};
    for (std::size_t i = 0; i < std::min(tags, maxTags); ++i) {
        const std::size_t offset = begin + reader.position();
        const std::string tag = number16(reader);
        const std::uint64_t where = reader.u32();
        const std::uint64_t size = reader.u32();
        if (reader.truncated())
            break;
        fields.push_back(
            field(Sentence("Tag {0}", ProperName{tag}), offset, 10,
                  Sentence("{0} at offset {1}", Sentence::plural("{0} byte", "{0} bytes", size), where),
                  N_("for programs that know it"), beyond(where, size, file.size())));
    }
    return fields;
}

Sentence wrongOffset(std::size_t offset, std::size_t fileSize) {
    if (offset != 0 && (offset < Header::headerBytes || offset >= fileSize - Footer::bytes))
        return Sentence("expected 0 or an offset between header and footer (18 to {0})",
                        fileSize - Footer::bytes);
    return {};
}

Fields describeFooter(ByteView file, const Footer& footer) {
    const std::size_t begin = file.size() - Footer::bytes;
    const auto shown = [](std::uint32_t offset) {
        return offset == 0 ? N_("0 (none)") : std::to_string(offset);
    };
    return {section("Footer", begin, Footer::bytes, {}, N_("version 2")),
            field(N_("Extension Area Offset"), begin, 4, shown(footer.extensionOffset), {},
                  wrongOffset(footer.extensionOffset, file.size())),
            field(N_("Developer Directory Offset"), begin + 4, 4, shown(footer.developerOffset), {},
                  wrongOffset(footer.developerOffset, file.size())),
            field(N_("Signature"), begin + 8, 16, text(file.subspan(begin + 8, 16))),
            field(N_("Reserved Character"), begin + 24, 1, "\".\""),
            field(N_("Binary Zero String Terminator"), begin + 25, 1, "0")};
}

} // namespace

Anatomy dissectTga(ByteView file) {
    const Header header = readHeader(file);
    const std::optional<Footer> footer = readFooter(file);
    Anatomy anatomy{"TGA", {}, {}};
    std::vector<Fields> sections;
    const auto add = [&](Fields fields) {
        if (!fields.empty())
            sections.push_back(std::move(fields));
    };
    add(describeHeader(file, header));
    if (file.size() < Header::headerBytes) {
        anatomy.damage = Sentence("the header needs 18 bytes, the file has {0}", file.size());
    } else {
        if (header.idLength > 0)
            add({section(
                "Image ID", Header::headerBytes, header.idLength,
                text(file.subspan(Header::headerBytes,
                                  std::min<std::size_t>(header.idLength, file.size() - Header::headerBytes))),
                {}, beyond(Header::headerBytes, header.idLength, file.size()))});
        add(describeColorMap(file, header));
        if (header.pixelOffset() > file.size())
            anatomy.damage =
                Sentence("the image ID and the colour map end at offset {0}, the file has {1}",
                         header.pixelOffset(), Sentence::plural("{0} byte", "{0} bytes", file.size()));
        else
            add(describeImageData(pixelData(file, header, footer), header, anatomy.damage));
    }
    if (footer) {
        add(describeDeveloper(file, *footer));
        add(describeExtension(file, *footer));
        add(describeFooter(file, *footer));
    }
    std::ranges::stable_sort(sections, {}, [](const Fields& fields) { return fields.front().offset; });
    for (Fields& fields : sections)
        std::ranges::move(fields, std::back_inserter(anatomy.fields));
    return anatomy;
}

} // namespace texplorer
