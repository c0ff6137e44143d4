#pragma once

// Wraps libjpeg-turbo, which reports errors by longjmp, as functions that return errors.

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"
#include "texplorer/base/sentence.h"
#include "texplorer/codec/common/decode_limits.h"
#include "texplorer/image/image.h"

#include <csetjmp>
#include <cstddef>
#include <cstdio> // jpeglib.h needs it
#include <jpeglib.h>
#include <string>
#include <vector>

namespace texplorer {

/// The error for a picture whose number of components is not 1, 3 or 4.
[[nodiscard]] Error unreadableComponents(std::size_t count);

/// Reads one file: `readHeader`, then `readPixels`. After an error, no more calls.
class JpegReader {
public:
    /// `file` and `limits`, of which `stop` is used, must outlive the reader.
    JpegReader(ByteView file, const DecodeLimits& limits);
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader();

    struct Header {
        int width = 0;
        int height = 0;
        /// Luminance8, Rgb8; or Rgba8 for cyan, magenta, yellow and black.
        PixelFormat format = PixelFormat::Rgb8;
        bool inks = false; ///< the format is cyan, magenta, yellow and black
    };

    /// Reads up to the first scan; allocates no memory for pixels.
    [[nodiscard]] Result<Header> readHeader();

    /// Fills an image of the header's extents and format, bottom row first, and reads on to the end marker.
    /// All damage is an error, except unknown bytes, which are noted.
    [[nodiscard]] Result<void> readPixels(Image& image);

    /// What was tolerated, as sentences.
    [[nodiscard]] const std::vector<Sentence>& notes() const { return notes_; }

private:
    // These functions may longjmp, so they must not contain objects with destructors. Not noexcept: a longjmp
    // is an exception in WebAssembly.
    bool begin();
    bool fill(std::byte* topRow, std::size_t rowBytes);

    [[noreturn]] static void onError(j_common_ptr jpeg);
    static void onMessage(j_common_ptr jpeg, int level);
    static void onProgress(j_common_ptr jpeg);
    void keepMessage() noexcept;
    [[nodiscard]] Error failure() const;

    ByteView file_;
    const DecodeLimits& limits_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf failed_{};
    bool outOfMemory_ = false;
    Sentence error_;
    std::vector<Sentence> notes_;
};

} // namespace texplorer
