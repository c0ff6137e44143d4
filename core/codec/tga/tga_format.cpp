#include "texplorer/codec/tga/tga_format.h"

#include "texplorer/base/byte_reader.h"
#include "texplorer/base/translatable.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::tga {

namespace {

using Check = std::optional<Complaint>;

Check malformed(const char* expected, int found) {
    return Complaint{Severity::Malformed, Sentence("expected {0}, found {1}", expected, found)};
}

Check fine(const Header&) {
    return {};
}

bool isColorDepth(int bits) {
    return bits == 15 || bits == 16 || bits == 24 || bits == 32;
}

const char* describeType(const Header& header) {
    switch (header.imageType) {
    case 0:
        return N_("no picture");
    case 1:
        return "colour-mapped";
    case 2:
        return N_("true colour");
    case 3:
        return N_("grey");
    case 9:
        return N_("colour-mapped, run-length coded");
    case 10:
        return N_("true colour, run-length coded");
    case 11:
        return N_("grey, run-length coded");
    case 32:
        return N_("colour-mapped; Huffman, delta and run-length coded");
    case 33:
        return N_("colour-mapped; Huffman, delta and run-length coded, as a quadtree");
    default:
        return N_("unknown");
    }
}

Check checkMapType(const Header& header) {
    if (header.mapped() && header.colorMapType != 1)
        return malformed("1, as the picture is colour-mapped", header.colorMapType);
    if (header.colorMapType > 1)
        return malformed("0 (no colour map) or 1 (a colour map)", header.colorMapType);
    return {};
}

Check checkType(const Header& header) {
    const int type = header.imageType;
    if (type == 32 || type == 33)
        return Complaint{Severity::Unsupported,
                         Sentence("types 1, 2, 3, 9, 10 and 11 are read, the file has {0}: {1}", type,
                                  describeType(header))};
    if (type == 0 || std::string_view(describeType(header)) == "unknown")
        return malformed("type 1, 2, 3, 9, 10 or 11", type);
    return {};
}

Check checkUnusedMapField(const Header& header, int value) {
    if (header.colorMapType == 0 && value != 0)
        return Complaint{Severity::Odd, Sentence("expected 0 without a colour map, found {0}", value)};
    return {};
}

Check checkMapLength(const Header& header) {
    if (header.mapped() && header.mapLength == 0)
        return malformed("at least 1 entry of the colour map", 0);
    return checkUnusedMapField(header, header.mapLength);
}

Check checkEntrySize(const Header& header) {
    if (header.colorMapType == 0 || (header.mapLength == 0 && !header.mapped()))
        return checkUnusedMapField(header, header.entryBits);
    if (!isColorDepth(header.entryBits))
        return malformed("15, 16, 24 or 32 bits an entry", header.entryBits);
    return {};
}

Check checkExtent(int extent) {
    return extent == 0 ? malformed("at least 1 pixel", 0) : Check{};
}

Check checkDepth(const Header& header) {
    const int bits = header.pixelBits;
    if (header.mapped())
        return bits == 8 || bits == 15 || bits == 16
                   ? Check{}
                   : malformed("8, 15 or 16 bits for a colour map's index", bits);
    if (header.gray())
        return bits == 8 || bits == 16 ? Check{} : malformed("8 or 16 bits for grey", bits);
    return isColorDepth(bits) ? Check{} : malformed("15, 16, 24 or 32 bits for true colour", bits);
}

Check checkDescriptor(const Header& header) {
    if (header.interleave() != 0)
        return Complaint{
            Severity::Unsupported,
            Sentence("rows one after the other are read, these are interleaved ({0} in bits 6 and 7)",
                     header.interleave())};
    const int bits = header.attributeBits();
    if (bits != 0 && bits != header.alphaBits())
        return Complaint{
            Severity::Odd,
            Sentence("expected {0} attribute bits, found {1}",
                     header.alphaBits() == 0 ? Sentence("0") : Sentence("0 or {0}", header.alphaBits()),
                     bits)};
    return {};
}

Sentence describeDescriptor(const Header& header) {
    constexpr std::array corners{N_("bottom left"), N_("bottom right"), N_("top left"), N_("top right")};
    const auto corner = (header.topFirst() ? 2U : 0U) + (header.rightToLeft() ? 1U : 0U);
    const Sentence text =
        Sentence("{0} attribute bits, first pixel at the {1}", header.attributeBits(), corners[corner]);
    return header.interleave() == 0 ? text : Sentence("{0}, interleaved rows", text);
}

std::string bitsOf(int value) {
    return fmt::format("{:#04x}", value);
}

template<auto Member>
std::string number(const Header& header) {
    return std::to_string(header.*Member);
}

constexpr std::array rows{
    HeaderRow{0, 1, N_("ID Length"), number<&Header::idLength>,
              [](const Header&) -> Sentence { return N_("bytes of the image ID, which follows the header"); },
              fine},
    HeaderRow{1, 1, N_("Color Map Type"), number<&Header::colorMapType>,
              [](const Header& h) -> Sentence {
                  return h.colorMapType == 0   ? N_("no colour map")
                         : h.colorMapType == 1 ? N_("a colour map")
                                               : N_("unknown");
              },
              checkMapType},
    HeaderRow{2, 1, N_("Image Type"), number<&Header::imageType>,
              [](const Header& h) -> Sentence { return describeType(h); }, checkType},
    HeaderRow{3, 2, N_("First Entry Index"), number<&Header::firstEntry>,
              [](const Header&) -> Sentence { return N_("index of the first stored entry"); },
              [](const Header& h) { return checkUnusedMapField(h, h.firstEntry); }},
    HeaderRow{5, 2, N_("Color map Length"), number<&Header::mapLength>,
              [](const Header&) -> Sentence { return N_("stored entries"); }, checkMapLength},
    HeaderRow{7, 1, N_("Color map Entry Size"), number<&Header::entryBits>,
              [](const Header&) -> Sentence { return N_("bits an entry"); }, checkEntrySize},
    HeaderRow{8, 2, N_("X-origin of Image"), number<&Header::xOrigin>,
              [](const Header&) -> Sentence { return N_("left edge on the screen"); }, fine},
    HeaderRow{10, 2, N_("Y-origin of Image"), number<&Header::yOrigin>,
              [](const Header&) -> Sentence { return N_("lower edge on the screen"); }, fine},
    HeaderRow{12, 2, N_("Image Width"), number<&Header::width>,
              [](const Header&) -> Sentence { return N_("pixels in a row"); },
              [](const Header& h) { return checkExtent(h.width); }},
    HeaderRow{14, 2, N_("Image Height"), number<&Header::height>,
              [](const Header&) -> Sentence { return N_("rows"); },
              [](const Header& h) { return checkExtent(h.height); }},
    HeaderRow{
        16, 1, N_("Pixel Depth"), number<&Header::pixelBits>,
        [](const Header& h) -> Sentence { return h.mapped() ? N_("bits an index") : N_("bits a pixel"); },
        checkDepth},
    HeaderRow{17, 1, N_("Image Descriptor"), [](const Header& h) { return bitsOf(h.descriptor); },
              describeDescriptor, checkDescriptor},
};

static_assert(rows.size() == 12 && rows.back().offset + rows.back().size == Header::headerBytes);

} // namespace

int Header::alphaBits() const {
    if (gray())
        return pixelBits == 16 ? 8 : 0;
    const int bits = mapped() ? entryBits : pixelBits;
    return bits == 32 ? 8 : bits == 16 ? 1 : 0;
}

Header readHeader(ByteView file) {
    ByteReader reader(file.first(std::min(file.size(), Header::headerBytes)));
    Header header;
    header.idLength = reader.u8();
    header.colorMapType = reader.u8();
    header.imageType = reader.u8();
    header.firstEntry = reader.u16();
    header.mapLength = reader.u16();
    header.entryBits = reader.u8();
    header.xOrigin = reader.u16();
    header.yOrigin = reader.u16();
    header.width = reader.u16();
    header.height = reader.u16();
    header.pixelBits = reader.u8();
    header.descriptor = reader.u8();
    return header;
}

std::span<const HeaderRow> headerRows() {
    return rows;
}

std::optional<Footer> readFooter(ByteView file) {
    if (file.size() < Header::headerBytes + Footer::bytes)
        return {};
    ByteReader reader(file.last(Footer::bytes));
    const Footer footer{reader.u32(), reader.u32()};
    if (!std::ranges::equal(reader.take(Footer::signature.size()),
                            std::as_bytes(std::span(Footer::signature))))
        return {};
    return footer;
}

ByteView findExtension(ByteView file, const std::optional<Footer>& footer) {
    if (!footer || footer->extensionOffset < Header::headerBytes || file.size() < extensionBytes ||
        footer->extensionOffset > file.size() - extensionBytes)
        return {};
    const ByteView area = file.subspan(footer->extensionOffset, extensionBytes);
    return ByteReader(area).u16() >= extensionBytes ? area : ByteView{};
}

std::vector<Loss> lossesOf(ByteView extension) {
    if (extension.empty())
        return {};
    constexpr std::size_t authorOffset = 2; // the author's name and the comments stand side by side
    constexpr std::size_t writtenBytes = 41 + 324;
    constexpr std::size_t gammaOffset = 478;
    std::vector<Loss> losses;
    ByteReader gamma(extension.subspan(gammaOffset));
    const unsigned numerator = gamma.u16();
    const unsigned denominator = gamma.u16();
    if (denominator != 0 && numerator != denominator)
        losses.push_back({"colorProfile", Sentence("the gamma of {0}/{1}", numerator, denominator), false});
    const auto isWritten = [](std::byte letter) {
        return letter != std::byte{0} && letter != std::byte{' '};
    };
    if (std::ranges::any_of(extension.subspan(authorOffset, writtenBytes), isWritten))
        losses.push_back({"metadata", N_("the author's name and the comments"), false});
    return losses;
}

ByteView pixelData(ByteView file, const Header& header, const std::optional<Footer>& footer) {
    const std::size_t end = footer ? file.size() - Footer::bytes : file.size();
    return header.pixelOffset() < end ? file.subspan(header.pixelOffset(), end - header.pixelOffset())
                                      : ByteView{};
}

} // namespace texplorer::tga
