#pragma once

// libjpeg-turbo, whose functions jump out of themselves where something is wrong, as functions that return.

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/image/image.h"

#include <csetjmp>
#include <cstddef>
#include <cstdio> // jpeglib.h needs it
#include <jpeglib.h>
#include <string>
#include <vector>

namespace texplorer {

/// What is said of a picture whose number of components isn't 1, 3 or 4.
[[nodiscard]] Error unreadableComponents(std::size_t count);

/// Reads one file: `readHeader`, then `readPixels`, and nothing more once one of them has failed.
class JpegReader {
public:
    /// `file` must outlive the reader.
    explicit JpegReader(ByteView file);
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;
    ~JpegReader();

    struct Header {
        int width = 0;
        int height = 0;
        /// Luminance8, Rgb8; or Rgba8, which holds cyan, magenta, yellow and black.
        PixelFormat format = PixelFormat::Rgb8;
        bool inks = false; ///< the latter
    };

    /// Everything up to the first scan; no memory for pixels is taken.
    [[nodiscard]] Result<Header> readHeader();

    /// Fills an image of the header's extents and format, bottom row first, and reads on to the end marker.
    /// Any damage is an error but bytes that belong to nothing, which are noted.
    [[nodiscard]] Result<void> readPixels(Image& image);

    /// What was survived, as sentences.
    [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }

private:
    // They jump, so that nothing with a destructor may live in them.
    bool begin() noexcept;
    bool fill(std::byte* topRow, std::size_t rowBytes) noexcept;

    [[noreturn]] static void onError(j_common_ptr jpeg);
    static void onMessage(j_common_ptr jpeg, int level);
    static void onProgress(j_common_ptr jpeg);
    void keepMessage() noexcept;
    [[nodiscard]] Error failure() const;

    ByteView file_;
    jpeg_decompress_struct jpeg_{};
    jpeg_error_mgr errors_{};
    jpeg_progress_mgr progress_{};
    std::jmp_buf failed_{};
    bool outOfMemory_ = false;
    std::string error_;
    std::vector<std::string> notes_;
};

} // namespace texplorer
