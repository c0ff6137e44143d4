#include "core/codec/jpeg.h"

#include "core/codec/jpeg_markers.h"

#include <array>
#include <cstring>
#include <memory>
#include <new>
#include <string>
#include <turbojpeg.h>
#include <type_traits>

namespace texplorer {

namespace {

tl::unexpected<Error> malformed(const std::string& message) {
    return fail(ErrorCode::Malformed, "JPEG: " + message);
}

// What is known before libjpeg-turbo allocates anything.
struct Survey {
    std::optional<JpegFrame> frame;
    int orientation = 0;
    bool adobe = false;
    std::size_t end = 0; // behind EOI, or 0
};

Survey survey(ByteView file) {
    Survey found;
    JpegSegments segments(file);
    while (const std::optional<JpegSegment> segment = segments.next()) {
        if (segment->isFrame() && !found.frame)
            found.frame = readJpegFrame(*segment);
        else if (segment->marker == jpegApp1 && found.orientation == 0)
            found.orientation = exifOrientation(segment->payload);
        else if (segment->marker == jpegApp14 && segment->payload.size() >= 12 &&
                 std::memcmp(segment->payload.data(), "Adobe", 5) == 0)
            found.adobe = true;
        else if (segment->marker == jpegEoi)
            found.end = segments.offset();
    }
    return found;
}

Result<void> checkFrame(const JpegFrame& frame, ByteView file, const DecodeLimits& limits) {
    const std::string extents =
        std::to_string(frame.width) + " x " + std::to_string(frame.height) + " pixels";
    if (frame.width < 1 || frame.height < 1)
        return malformed("a picture has at least 1 x 1 pixels, this one says " + extents);
    if (static_cast<int>(frame.width) > limits.maxExtent || static_cast<int>(frame.height) > limits.maxExtent)
        return fail(ErrorCode::TooLarge, "JPEG: at most " + std::to_string(limits.maxExtent) + " x " +
                                             std::to_string(limits.maxExtent) +
                                             " pixels are read, the file has " + extents);
    const std::uint64_t pixels = std::uint64_t{frame.width} * frame.height;
    if (pixels > limits.maxPixels)
        return fail(ErrorCode::TooLarge, "JPEG: at most " + std::to_string(limits.maxPixels) +
                                             " pixels are read, the file has " + std::to_string(pixels));
    if (!frame.arithmetic() && frame.blocks() / 8 > file.size())
        return malformed(extents + " need " + std::to_string(frame.blocks()) +
                         " coded blocks of at least 1 bit each, the file has " + std::to_string(file.size()) +
                         " bytes");
    return {};
}

struct DestroyHandle {
    void operator()(void* handle) const { tjDestroy(handle); }
};

using Handle = std::unique_ptr<std::remove_pointer_t<tjhandle>, DestroyHandle>;

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

// Whether the last failure was only "Corrupt JPEG data: 3 extraneous bytes before marker 0xd9".
bool survived(tjhandle handle) {
    return tjGetErrorCode(handle) == TJERR_WARNING &&
           std::strstr(tjGetErrorStr2(handle), "extraneous bytes before marker") != nullptr;
}

struct Layout {
    TJPF pixels;
    PixelFormat format;
};

Layout layoutFor(int colorspace) {
    switch (colorspace) {
    case TJCS_GRAY:
        return {TJPF_GRAY, PixelFormat::Luminance8};
    case TJCS_CMYK:
    case TJCS_YCCK:
        return {TJPF_CMYK, PixelFormat::Rgba8};
    default:
        return {TJPF_RGB, PixelFormat::Rgb8};
    }
}

Result<TextureImage> decode(ByteView file, const Survey& found, const DecodeLimits& limits) {
    const Handle handle(tjInitDecompress());
    if (!handle)
        return fail(ErrorCode::TooLarge, "JPEG: there is no memory for the decoder");
    const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());
    int width = 0;
    int height = 0;
    int subsampling = 0;
    int colorspace = 0;
    if (tjDecompressHeader3(handle.get(), bytes, file.size(), &width, &height, &subsampling, &colorspace) !=
            0 &&
        !survived(handle.get()))
        return malformed(tjGetErrorStr2(handle.get()));
    // The second opinion counts: only extents that were checked may be allocated.
    if (width != static_cast<int>(found.frame->width) || height != static_cast<int>(found.frame->height))
        return malformed("its first frame says " + std::to_string(found.frame->width) + " x " +
                         std::to_string(found.frame->height) + " pixels, another " + std::to_string(width) +
                         " x " + std::to_string(height));

    const Layout layout = layoutFor(colorspace);
    const std::uint64_t needed = std::uint64_t{found.frame->width} * found.frame->height *
                                 static_cast<std::uint64_t>(bytesPerPixel(layout.format));
    if (needed > limits.maxBytes)
        return fail(ErrorCode::TooLarge, "JPEG: at most " + std::to_string(limits.maxBytes) +
                                             " bytes of pixels are read, the file has " +
                                             std::to_string(needed));
    Image image = Image::uninitialised(layout.format, width, height);
    std::vector<std::string> notes;
    if (tjDecompress2(handle.get(), bytes, file.size(), reinterpret_cast<unsigned char*>(image.pixels.data()),
                      width, 0, height, layout.pixels, TJFLAG_BOTTOMUP | TJFLAG_LIMITSCANS) != 0) {
        const std::string said = tjGetErrorStr2(handle.get());
        if (!survived(handle.get()))
            return malformed(said + " (the file has " + std::to_string(file.size()) + " bytes)");
        notes.push_back("survived: " + said);
    }
    if (layout.pixels == TJPF_CMYK)
        image = rgbOfCmyk(std::move(image), found.adobe);

    TextureImage texture = textureOf(std::move(image), "JPEG");
    texture.notes = std::move(notes);
    if (found.orientation > 1)
        texture.notes.push_back("Exif says that the camera was turned (orientation " +
                                std::to_string(found.orientation) + "); the picture stands as it is stored");
    if (found.end != 0 && found.end < file.size())
        texture.notes.push_back(std::to_string(file.size() - found.end) +
                                " bytes behind the end (EOI) left out");
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
            return malformed("there is no frame header (SOF) in the " + std::to_string(file.size()) +
                             " bytes of the file");
        if (const Result<void> checked = checkFrame(*found.frame, file, limits); !checked)
            return fail(checked.error());
        return decode(file, found, limits);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge, "JPEG: there is no memory for the pixels");
    }
}

} // namespace texplorer
