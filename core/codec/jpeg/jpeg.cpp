#include "texplorer/codec/jpeg/jpeg.h"

#include "texplorer/base/sentence_format.h"
#include "texplorer/codec/jpeg/jpeg_markers.h"
#include "texplorer/codec/jpeg/jpeg_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <new>
#include <string>

namespace texplorer {

namespace {

tl::unexpected<Error> malformed(const Sentence& message) {
    return fail(ErrorCode::Malformed, Sentence("JPEG: {0}", message));
}

bool beginsWith(ByteView bytes, std::string_view text) {
    return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

// What is known before libjpeg-turbo allocates anything.
struct Survey {
    std::optional<JpegFrame> frame;
    int orientation = 0;
    bool adobe = false;
    bool exif = false;
    bool profile = false;
    bool comment = false;
    std::size_t end = 0; // behind EOI, or 0
};

Survey survey(ByteView file) {
    Survey found;
    JpegSegments segments(file);
    while (const std::optional<JpegSegment> segment = segments.next()) {
        if (segment->isFrame() && !found.frame)
            found.frame = readJpegFrame(*segment);
        else if (segment->marker == jpegApp1) {
            found.exif = true;
            if (found.orientation == 0)
                found.orientation = exifOrientation(segment->payload);
        } else if (segment->marker == jpegApp2 && beginsWith(segment->payload, "ICC_PROFILE"))
            found.profile = true;
        else if (segment->marker == jpegCom)
            found.comment = true;
        else if (segment->marker == jpegApp14 && segment->payload.size() >= 12 &&
                 beginsWith(segment->payload, N_("Adobe")))
            found.adobe = true;
        else if (segment->marker == jpegEoi)
            found.end = segments.offset();
    }
    return found;
}

/// "3 x 1, 2 x 1, 2 x 1"
std::string samplingOf(const JpegFrame& frame) {
    std::string text;
    for (const JpegComponent& each : frame.components)
        text.append(text.empty() ? "" : ", ").append(fmt::format("{} × {}", each.horizontal, each.vertical));
    return text;
}

Error inJpeg(const Error& error) {
    return {error.code, Sentence("JPEG: {0}", error.message), error.where};
}

Result<void> checkFrame(const JpegFrame& frame, ByteView file, const DecodeLimits& limits) {
    const Sentence extents(N_("{0} × {1} pixels"), frame.width, frame.height);
    if (frame.width < 1 || frame.height < 1)
        return malformed(Sentence("a picture has at least 1 × 1 pixels, this one has {0}", extents));
    if (static_cast<int>(frame.width) > limits.maxExtent || static_cast<int>(frame.height) > limits.maxExtent)
        return fail(ErrorCode::TooLarge, Sentence("JPEG: at most {0} × {0} pixels are read, the file has {1}",
                                                  limits.maxExtent, extents));
    const std::uint64_t pixels = std::uint64_t{frame.width} * frame.height;
    if (pixels > limits.maxPixels)
        return fail(ErrorCode::TooLarge, Sentence("JPEG: at most {0} pixels are read, the file has {1}",
                                                  limits.maxPixels, pixels));
    if (const std::size_t count = frame.components.size(); count != 1 && count != 3 && count != 4)
        return fail(inJpeg(unreadableComponents(count)));
    const auto divides = [&](std::uint8_t JpegComponent::*factor) {
        std::uint8_t most = 0;
        for (const JpegComponent& each : frame.components)
            most = std::max(most, each.*factor);
        return std::ranges::all_of(frame.components, [&](const JpegComponent& each) {
            return each.*factor == 0 || most % each.*factor == 0;
        });
    };
    if (!divides(&JpegComponent::horizontal) || !divides(&JpegComponent::vertical))
        return fail(ErrorCode::Unsupported,
                    Sentence("JPEG: sampling factors must divide the largest, the components have {0}",
                             samplingOf(frame)));
    if (!frame.arithmetic() && frame.blocks() / 8 > file.size())
        return malformed(Sentence("{0} need {1} coded blocks of at least 1 bit each, the file has {2} bytes",
                                  extents, frame.blocks(), file.size()));
    return {};
}

// In place: what is written never overtakes what is read.
Image rgbOfCmyk(Image image, bool inverted) {
    const auto paper = [inverted](std::byte ink) { return std::to_integer<unsigned>(inverted ? ink : ~ink); };
    std::byte* to = image.pixels.data();
    const std::byte* end = to + image.pixels.size();
    for (const std::byte* from = to; from != end; from += 4, to += 3) {
        const unsigned black = paper(from[3]);
        for (std::size_t i = 0; i < 3; ++i)
            to[i] = static_cast<std::byte>((paper(from[i]) * black + 127) / 255);
    }
    image.format = PixelFormat::Rgb8;
    image.pixels.resize(image.pixels.size() / 4 * 3);
    return image;
}

Result<TextureImage> decode(ByteView file, const Survey& found, const DecodeLimits& limits) {
    JpegReader reader(file, limits);
    const Result<JpegReader::Header> header = reader.readHeader();
    if (!header)
        return fail(inJpeg(header.error()));
    // The second opinion counts: only extents that were checked may be allocated.
    if (header->width != static_cast<int>(found.frame->width) ||
        header->height != static_cast<int>(found.frame->height))
        return malformed(Sentence("its first frame has {0} × {1} pixels, another {2} × {3}",
                                  found.frame->width, found.frame->height, header->width, header->height));
    const std::uint64_t needed = std::uint64_t{found.frame->width} * found.frame->height *
                                 static_cast<std::uint64_t>(bytesPerPixel(header->format));
    if (needed > limits.maxBytes)
        return fail(ErrorCode::TooLarge,
                    Sentence("JPEG: at most {0} bytes of pixels are read, the file has {1}", limits.maxBytes,
                             needed));
    Image image{header->inks ? PixelFormat::Rgb8 : header->format, header->width, header->height, 1, {}};
    if (limits.pixels) {
        image = Image::uninitialised(header->format, header->width, header->height);
        if (const Result<void> read = reader.readPixels(image); !read)
            return fail(inJpeg({read.error().code,
                                Sentence("{0} (the file has {1} bytes)", read.error().message, file.size()),
                                {}}));
        if (header->inks)
            image = rgbOfCmyk(std::move(image), found.adobe);
    }

    TextureImage texture = textureOf(std::move(image), "JPEG");
    texture.notes = reader.notes();
    if (header->inks)
        texture.losses.push_back({"inks", N_("cyan, magenta, yellow and black become red, green and blue")});
    if (found.profile)
        texture.losses.push_back({"colorProfile", N_("the ICC profile"), false});
    if (found.exif)
        texture.losses.push_back({"metadata", N_("metadata (Exif, XMP)"), false});
    if (found.comment)
        texture.losses.push_back({"metadata", N_("the comment"), false});
    if (found.orientation > 1)
        texture.remarks.push_back(
            Sentence("Exif says that the camera was turned (orientation {0}); the picture is read as stored",
                     found.orientation));
    if (found.end != 0 && found.end < file.size())
        texture.notes.push_back(Sentence("{0} bytes after the end (EOI) ignored", file.size() - found.end));
    return texture;
}

} // namespace

Result<TextureImage> decodeJpeg(ByteView file, const DecodeLimits& limits) {
    try {
        if (file.empty())
            return malformed("the file is empty");
        if (file.size() < 2 || file[0] != std::byte{0xFF} || file[1] != std::byte{jpegSoi})
            return malformed("the file does not begin with a start marker (FF D8)");
        const Survey found = survey(file);
        if (!found.frame)
            return malformed(
                Sentence("there is no frame header (SOF) in the {0} bytes of the file", file.size()));
        if (const Result<void> checked = checkFrame(*found.frame, file, limits); !checked)
            return fail(checked.error());
        return decode(file, found, limits);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "JPEG: not enough memory for the pixels");
    }
}

} // namespace texplorer
