#include "core/codec/png.h"

#include <algorithm>
#include <csetjmp>
#include <cstring>
#include <new>
#include <png.h>
#include <string>
#include <vector>

namespace texplorer {

namespace {

// libpng reports an error by jumping out of its own functions, so that nothing with a destructor may live in
// the function that it jumps back to: all state is here, outside of it.
struct Encoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    Bytes out;
    std::string error;
    std::vector<png_const_bytep> rows; // from the top

    Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { png_destroy_write_struct(&png, &info); }

    bool write(const Image& image, int colorType) noexcept;
};

void onError(png_structp png, png_const_charp message) {
    static_cast<Encoder*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void onWarning(png_structp, png_const_charp) {}

void onData(png_structp png, png_bytep data, png_size_t count) {
    Bytes& out = static_cast<Encoder*>(png_get_io_ptr(png))->out;
    bool stored = true;
    try {
        out.resize(out.size() + count);
    } catch (const std::bad_alloc&) {
        stored = false; // the jump must not leave a catch block
    }
    if (!stored)
        png_error(png, "there is no memory for the file");
    std::memcpy(out.data() + out.size() - count, data, count);
}

void onFlush(png_structp) {}

bool Encoder::write(const Image& image, int colorType) noexcept {
    if (setjmp(png_jmpbuf(png)) != 0)
        return false;
    png_set_write_fn(png, this, onData, onFlush);
    png_set_user_limits(png, 0x7FFFFFFF, 0x7FFFFFFF);
    png_set_IHDR(png, info, static_cast<png_uint_32>(image.width), static_cast<png_uint_32>(image.height), 8,
                 colorType, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_compression_level(png, 1);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_SUB);
    png_write_info(png, info);
    for (const png_const_bytep row : rows)
        png_write_row(png, row);
    png_write_end(png, nullptr);
    return true;
}

// PNG has no picture of alpha alone: it becomes grey, as one would want to look at it.
int colorTypeOf(PixelFormat format) {
    switch (format) {
    case PixelFormat::Alpha8:
    case PixelFormat::Luminance8:
        return PNG_COLOR_TYPE_GRAY;
    case PixelFormat::LuminanceAlpha8:
        return PNG_COLOR_TYPE_GRAY_ALPHA;
    case PixelFormat::Rgb8:
        return PNG_COLOR_TYPE_RGB;
    case PixelFormat::Rgba8:
        return PNG_COLOR_TYPE_RGB_ALPHA;
    }
    return PNG_COLOR_TYPE_RGB_ALPHA;
}

} // namespace

Result<Bytes> encodePng(const Image& image) {
    if (image.width < 1 || image.height < 1 || image.empty())
        return fail(ErrorCode::OutOfRange, "PNG: a picture has at least 1 x 1 pixels, this one has " +
                                               std::to_string(image.width) + " x " +
                                               std::to_string(image.height));
    const std::size_t slice = image.rowBytes() * static_cast<std::size_t>(image.height);
    if (image.pixels.size() < slice)
        return fail(ErrorCode::Malformed, "PNG: the picture needs " + std::to_string(slice) +
                                              " bytes, it has " + std::to_string(image.pixels.size()));
    try {
        Encoder encoder;
        encoder.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoder, onError, onWarning);
        encoder.info = encoder.png != nullptr ? png_create_info_struct(encoder.png) : nullptr;
        if (encoder.info == nullptr)
            return fail(ErrorCode::TooLarge, "PNG: there is no memory for the encoder");
        encoder.out.reserve(slice / 2 + 1024);
        for (int y = image.height; y-- > 0;)
            encoder.rows.push_back(reinterpret_cast<png_const_bytep>(image.at(0, y).data()));
        if (!encoder.write(image, colorTypeOf(image.format)))
            return fail(ErrorCode::Unwritable, "PNG: " + encoder.error);
        return std::move(encoder.out);
    } catch (const std::bad_alloc&) {
        return fail(ErrorCode::TooLarge,
                    "PNG: there is no memory for " + std::to_string(slice) + " bytes of pixels");
    }
}

} // namespace texplorer
