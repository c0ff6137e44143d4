#include "texplorer/codec/tga/tga.h"

#include "texplorer/base/byte_reader.h"
#include "texplorer/base/sentence.h"
#include "texplorer/codec/tga/tga_format.h"
#include "texplorer/codec/tga/tga_pixels.h"

#include <algorithm>
#include <array>
#include <new>
#include <string>

namespace texplorer {

namespace {

using namespace tga;

tl::unexpected<Error> malformed(const Sentence& message) {
    return fail(ErrorCode::Malformed, Sentence("TGA: {0}", message));
}

tl::unexpected<Error> tooLarge(const Sentence& message) {
    return fail(ErrorCode::TooLarge, Sentence("TGA: {0}", message));
}

// The first complaint that matters; what is merely odd goes into the notes.
Result<void> checkHeader(const Header& header, std::vector<Sentence>& notes) {
    for (const HeaderRow& row : headerRows()) {
        const std::optional<Complaint> complaint = row.complaint(header);
        if (!complaint)
            continue;
        const Sentence text(N_("{0}: {1}"), ProperName{row.name}, complaint->text);
        if (complaint->severity == Severity::Malformed)
            return malformed(text);
        if (complaint->severity == Severity::Unsupported)
            return fail(ErrorCode::Unsupported, Sentence("TGA: {0}", text));
        notes.push_back(text);
    }
    return {};
}

Result<void> checkSize(const Header& header, std::size_t decodedPixelBytes, const DecodeLimits& limits) {
    const Sentence extents(N_("{0} × {1} pixels"), header.width, header.height);
    if (header.width > limits.maxExtent || header.height > limits.maxExtent)
        return tooLarge(
            Sentence("at most {0} × {0} pixels are read, the file has {1}", limits.maxExtent, extents));
    if (header.pixelCount() > limits.maxPixels)
        return tooLarge(Sentence("at most {0} pixels are read, the file has {1}", limits.maxPixels, extents));
    if (header.pixelCount() * decodedPixelBytes > limits.maxBytes)
        return tooLarge(Sentence("at most {0} of pixels are decoded, the file has {1}",
                                 Sentence::plural("{0} byte", "{0} bytes", limits.maxBytes),
                                 header.pixelCount() * decodedPixelBytes));
    return {};
}

Sentence shortage(const Header& header, std::uint64_t needed, std::size_t found) {
    return Sentence("pixel data needs {0} from offset {1}, the file has {2} there",
                    header.runLengthCoded()
                        ? Sentence("at least {0}", Sentence::plural("{0} byte", "{0} bytes", needed))
                        : Sentence::plural("{0} byte", "{0} bytes", needed),
                    header.pixelOffset(), found);
}

// No file is long enough for more pixels than this before anything is allocated for them.
Result<void> checkData(const Header& header, ByteView file, ByteView data) {
    if (header.pixelOffset() > file.size())
        return malformed(Sentence("the image ID and the colour map end at offset {0}, the file has {1}",
                                  header.pixelOffset(),
                                  Sentence::plural("{0} byte", "{0} bytes", file.size())));
    const std::uint64_t needed = minDataBytes(header);
    if (data.size() < needed)
        return malformed(shortage(header, needed, data.size()));
    return {};
}

void mirror(std::byte* row, std::size_t width, std::size_t pixelBytes) {
    std::byte* last = row + (width - 1) * pixelBytes;
    for (; row < last; row += pixelBytes, last -= pixelBytes)
        std::swap_ranges(row, row + pixelBytes, last);
}

// `read` gives the next pixels of the file, in its order.
bool fillRows(PixelReader& reader, const Header& header, Image& image) {
    if (!header.topFirst() && !header.rightToLeft())
        return reader.read(image.pixels.data(), static_cast<std::size_t>(header.pixelCount()));
    const std::size_t height = header.height;
    for (std::size_t y = 0; y < height; ++y) {
        std::byte* row = image.pixels.data() + (header.topFirst() ? height - 1 - y : y) * image.rowBytes();
        if (!reader.read(row, header.width))
            return false;
        if (header.rightToLeft())
            mirror(row, header.width, static_cast<std::size_t>(bytesPerPixel(image.format)));
    }
    return true;
}

// A Windows cursor reads as true colour with fields of a colour map that it doesn't have. Its first picture
// follows its directory: 6 bytes, and 16 for each picture, whose last 4 say where it is.
bool isCursor(ByteView file) {
    constexpr std::array magic{std::byte{0}, std::byte{0}, std::byte{2}, std::byte{0}};
    if (!std::ranges::equal(file.first(magic.size()), magic))
        return false;
    ByteReader reader(file.subspan(magic.size()));
    const std::size_t pictures = reader.u16();
    reader.skip(12);
    return pictures > 0 && reader.u32() == 6 + 16 * pictures && !reader.truncated();
}

} // namespace

bool isTga(ByteView file) {
    if (readFooter(file))
        return true;
    const Header header = readHeader(file);
    if (header.pixelOffset() >= file.size() || header.attributeBits() > 8)
        return false;
    if (isCursor(file))
        return false;
    return std::ranges::none_of(headerRows(), [&](const HeaderRow& row) {
        const std::optional<Complaint> complaint = row.complaint(header);
        return complaint && complaint->severity == Severity::Malformed;
    });
}

Result<TextureImage> decodeTga(ByteView file, const DecodeLimits& limits) {
    if (file.size() < Header::headerBytes)
        return malformed(Sentence("the header needs 18 bytes, the file has {0}", file.size()));
    const Header header = readHeader(file);
    const std::optional<Footer> footer = readFooter(file);
    const ByteView data = pixelData(file, header, footer);
    TextureImage texture;
    if (const Result<void> checked = checkHeader(header, texture.notes); !checked)
        return fail(checked.error());
    const AlphaReading alpha = readAlpha(header, findExtension(file, footer), texture.notes);
    const PixelFormat format = decodedFormat(header, alpha.rule);
    if (const Result<void> checked =
            checkSize(header, static_cast<std::size_t>(bytesPerPixel(format)), limits);
        !checked)
        return fail(checked.error());
    if (const Result<void> checked = checkData(header, file, data); !checked)
        return fail(checked.error());
    texture.losses = lossesOf(findExtension(file, footer));
    texture.format = "TGA";
    texture.fileTopFirst = header.topFirst();
    if (!limits.pixels) {
        texture.alpha = meaningOf(alpha.rule, format);
        texture.surfaces.emplace_back(Image{format, header.width, header.height, 1, {}});
        return texture;
    }
    try {
        PixelReader reader(header, format, file.subspan(header.mapOffset(), header.mapBytes()), data);
        Image image = Image::uninitialised(format, header.width, header.height);
        if (!fillRows(reader, header, image))
            return malformed(
                Sentence("the packets end after {0} from offset {1}, before the picture's {2} pixels",
                         Sentence::plural("{0} byte", "{0} bytes", data.size()), header.pixelOffset(),
                         header.pixelCount()));
        reader.describeStrays(texture.notes);
        texture.alpha = applyAlpha(alpha, image, texture.notes);
        texture.surfaces.emplace_back(std::move(image));
        return texture;
    } catch (const std::bad_alloc&) {
        return tooLarge(Sentence("not enough memory for {0} pixels", header.pixelCount()));
    }
}

} // namespace texplorer
