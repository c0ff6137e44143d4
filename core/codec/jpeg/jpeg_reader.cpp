#include "texplorer/codec/jpeg/jpeg_reader.h"

#include <algorithm>
#include <array>
#include <jerror.h>
#include <new>

namespace texplorer {

namespace {

constexpr int maxScans = 500; // each goes through all coefficients again

JpegReader& readerOf(j_common_ptr jpeg) {
    return *static_cast<JpegReader*>(jpeg->client_data);
}

} // namespace

Error unreadableComponents(std::size_t count) {
    return {ErrorCode::Unsupported,
            Sentence("only pictures with 1 (grey), 3 (colour) or 4 (CMYK) components are read, this one "
                     "has {0}",
                     count),
            {}};
}

JpegReader::JpegReader(ByteView file, const DecodeLimits& limits)
    : file_(file)
    , limits_(limits) {
    jpeg_.err = jpeg_std_error(&errors_);
    errors_.error_exit = onError;
    errors_.emit_message = onMessage;
    errors_.output_message = [](j_common_ptr) {};
    progress_.progress_monitor = onProgress;
    jpeg_.client_data = this;
}

JpegReader::~JpegReader() {
    jpeg_destroy_decompress(&jpeg_);
}

// Text is made in a function of its own, which has returned before libjpeg jumps.
void JpegReader::keepMessage() noexcept {
    std::array<char, JMSG_LENGTH_MAX> text{};
    errors_.format_message(reinterpret_cast<j_common_ptr>(&jpeg_), text.data());
    try {
        if (errors_.msg_code == JWRN_EXTRANEOUS_DATA)
            notes_.push_back(Sentence("recovered: {0}", ProperName{text.data()}));
        else
            error_ = ProperName{text.data()};
    } catch (const std::bad_alloc&) {
        outOfMemory_ = true;
    }
}

void JpegReader::onError(j_common_ptr jpeg) {
    JpegReader& reader = readerOf(jpeg);
    reader.outOfMemory_ = reader.errors_.msg_code == JERR_OUT_OF_MEMORY;
    reader.keepMessage();
    std::longjmp(reader.failed_, 1); // NOLINT: libjpeg's way
}

void JpegReader::onMessage(j_common_ptr jpeg, int level) {
    constexpr int warning = -1;
    constexpr std::size_t enough = 8;
    JpegReader& reader = readerOf(jpeg);
    if (level != warning)
        return;
    if (reader.errors_.msg_code != JWRN_EXTRANEOUS_DATA)
        onError(jpeg);
    if (reader.notes_.size() < enough)
        reader.keepMessage();
}

void JpegReader::onProgress(j_common_ptr jpeg) {
    JpegReader& reader = readerOf(jpeg);
    if (reader.limits_.isStopped())
        std::longjmp(reader.failed_, 1); // NOLINT
    if (reader.jpeg_.input_scan_number <= maxScans)
        return;
    try {
        reader.error_ = Sentence("at most {0} scans are read, the file has more", maxScans);
    } catch (const std::bad_alloc&) {
        reader.outOfMemory_ = true;
    }
    std::longjmp(reader.failed_, 1); // NOLINT
}

Error JpegReader::failure() const {
    if (limits_.isStopped())
        return {ErrorCode::Cancelled, N_("decoding was cancelled"), {}};
    if (outOfMemory_)
        return {ErrorCode::TooLarge, N_("not enough memory for the decoder"), {}};
    return {ErrorCode::Malformed, error_, {}};
}

bool JpegReader::begin() {
    if (setjmp(failed_) != 0) // NOLINT
        return false;
    jpeg_create_decompress(&jpeg_);
    jpeg_.progress = &progress_;
    jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(file_.data()), file_.size());
    jpeg_read_header(&jpeg_, TRUE);
    return true;
}

Result<JpegReader::Header> JpegReader::readHeader() {
    if (!begin())
        return fail(failure());
    Header header{static_cast<int>(jpeg_.image_width), static_cast<int>(jpeg_.image_height)};
    switch (jpeg_.jpeg_color_space) {
    case JCS_GRAYSCALE:
        jpeg_.out_color_space = JCS_GRAYSCALE;
        header.format = PixelFormat::Luminance8;
        return header;
    case JCS_RGB:
    case JCS_YCbCr:
        jpeg_.out_color_space = JCS_RGB;
        return header;
    case JCS_CMYK:
    case JCS_YCCK:
        jpeg_.out_color_space = JCS_CMYK;
        header.format = PixelFormat::Rgba8;
        header.inks = true;
        return header;
    default:
        return fail(unreadableComponents(static_cast<std::size_t>(jpeg_.num_components)));
    }
}

bool JpegReader::fill(std::byte* topRow, std::size_t rowBytes) {
    constexpr JDIMENSION atOnce = 16; // as many as one row of blocks gives
    if (setjmp(failed_) != 0)         // NOLINT
        return false;
    jpeg_start_decompress(&jpeg_);
    while (jpeg_.output_scanline < jpeg_.output_height) {
        std::array<JSAMPROW, atOnce> rows{};
        for (JDIMENSION i = 0; i < atOnce && jpeg_.output_scanline + i < jpeg_.output_height; ++i)
            rows[i] = reinterpret_cast<JSAMPROW>(topRow - (jpeg_.output_scanline + i) * rowBytes);
        jpeg_read_scanlines(&jpeg_, rows.data(),
                            std::min(atOnce, jpeg_.output_height - jpeg_.output_scanline));
    }
    jpeg_finish_decompress(&jpeg_);
    return true;
}

Result<void> JpegReader::readPixels(Image& image) {
    if (fill(image.at(0, image.height - 1).data(), image.rowBytes()))
        return {};
    return fail(failure());
}

} // namespace texplorer
