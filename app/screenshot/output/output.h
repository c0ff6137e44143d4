#pragma once

#include "app/screenshot/output/answer.h"
#include "texplorer/codec/registry.h"
#include "texplorer/files/descriptor.h"
#include "texplorer/files/new_folders.h"

#include <memory>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Where a command writes what it was asked for: a file, which appears as a whole; standard output ("-"); or
/// a device or pipe that has a name.
class Output {
public:
    /// Found to be writable; a device or pipe is open from here on. The file's folder is made where it is
    /// missing, and goes again if nothing is written into it. The error names the path.
    [[nodiscard]] static Result<Output> open(const std::string& path);

    [[nodiscard]] Result<void> write(ByteView bytes) const;

private:
    explicit Output(std::string path)
        : path_(std::move(path)) {}

    [[nodiscard]] Result<void> put(ByteView bytes) const;

    std::string path_;
    Descriptor stream_; ///< of a device or pipe
    std::unique_ptr<NewFolders> made_;
};

/// The same of many files, each folder once: what else a name may be is seen when it is written.
[[nodiscard]] Result<void> checkPlaces(const std::vector<std::string>& paths, NewFolders& made);

/// Whether a path names the program's standard output.
[[nodiscard]] bool isStandardOutput(const std::string& path);

/// An image file to write, and how.
struct ImageOutput {
    Output output;
    const CodecRow* format;
    std::string path;

    [[nodiscard]] Result<void> write(const TextureImage& texture, const WriteOptions& options = {}) const;
};

/// The format that a file's extension names; the error is about the path, which `argument` has given.
/// `streamFormat` (empty: only files are meant) and `only`: see openImageOutput.
[[nodiscard]] Result<const CodecRow*> imageFormatOf(const std::string& path, std::string_view streamFormat,
                                                    std::string_view only = {},
                                                    const char* argument = "--out");

/// Opens the output before the work that leads to it. Its extension is its format; what has none and is no
/// file (-, a pipe, /dev/null) gets `streamFormat`. A terminal is refused, as it would only be disturbed.
/// `only`: the one format that the command writes. What goes wrong is said on standard error; the error is
/// the exit status.
[[nodiscard]] tl::expected<ImageOutput, ExitCode> openImageOutput(const std::string& path,
                                                                  std::string_view streamFormat,
                                                                  std::string_view only = {},
                                                                  const char* argument = "--out");

} // namespace texplorer::screenshot
