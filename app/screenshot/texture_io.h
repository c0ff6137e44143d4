#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/codec/registry.h"
#include "core/image/texture_image.h"

#include <atomic>
#include <functional>
#include <stop_token>
#include <string>

namespace texplorer::screenshot {

/// Reads and decodes a file. Errors name the path.
[[nodiscard]] Result<TextureImage> readTexture(const std::string& path);

/// The row whose format the file name's extension asks for and that can be written; the error lists those
/// that can.
[[nodiscard]] Result<const CodecRow*> writerFor(const std::string& path);

/// Encodes by the file name's extension and writes atomically.
[[nodiscard]] Result<void> writeTexture(const std::string& path, const TextureImage& texture,
                                        const WriteOptions& options = {});

/// Work that may take long: Ctrl+C asks it to stop instead of ending the program half-way, and after a second
/// a terminal shows how far it is.
class LongWork {
public:
    explicit LongWork(std::string what);
    ~LongWork();
    LongWork(const LongWork&) = delete;
    LongWork& operator=(const LongWork&) = delete;

    [[nodiscard]] std::stop_token stopToken() const { return stop_.get_token(); }
    /// From any thread; `done` from 0 to 1.
    void report(float done);
    /// Wipes the terminal's line; from here on nothing is reported.
    void finish();

private:
    std::string what_;
    std::stop_source stop_;
    double start_;
    bool terminal_;
    std::atomic<int> shownPercent_ = -1;
};

} // namespace texplorer::screenshot
