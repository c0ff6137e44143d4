#pragma once

#include "app/screenshot/command.h"
#include "core/base/descriptor.h"
#include "core/base/new_folders.h"
#include "core/codec/registry.h"

#include <span>
#include <string>
#include <vector>

namespace texplorer::screenshot {

/// Where a command writes what it was asked for: a file, which appears as a whole; standard output ("-"); or
/// a device or pipe that has a name.
class Output {
public:
    /// Found to be writable; a device or pipe is open from here on. The error names the path.
    [[nodiscard]] static Result<Output> open(const std::string& path);

    [[nodiscard]] Result<void> write(ByteView bytes) const;

private:
    explicit Output(std::string path)
        : path_(std::move(path)) {}

    [[nodiscard]] Result<void> put(ByteView bytes) const;

    std::string path_;
    Descriptor stream_; ///< of a device or pipe
};

/// Whether a file can be written there. The error names the path, and the folder that isn't there.
[[nodiscard]] Result<void> checkPlace(const std::string& path);

/// The same of many files, each folder once: what else a name may be is seen when it is written. `made` makes
/// the folders that aren't there; nullptr: they have to be.
[[nodiscard]] Result<void> checkPlaces(const std::vector<std::string>& paths, NewFolders* made);

/// Whether a path names the program's standard output.
[[nodiscard]] bool isStandardOutput(const std::string& path);

/// An option and the file that it names; an empty one names none.
struct NamedOutput {
    const char* option;
    std::string path;
};

/// No output may take the place of an input, under whatever name. The error names the option.
[[nodiscard]] Result<void> checkNotRead(const char* option, std::span<const std::string> outputs,
                                        const std::vector<std::string>& inputs);

/// No output may take the place of an input or of another output. The error names the option.
[[nodiscard]] Result<void> checkOutputsApart(const std::vector<NamedOutput>& outputs,
                                             const std::vector<std::string>& inputs);

/// An image file to write, and how.
struct ImageOutput {
    Output output;
    const CodecRow* format;
    std::string path;

    [[nodiscard]] Result<void> write(const TextureImage& texture, const WriteOptions& options = {}) const;
};

/// The format that a file's extension names; the error is about the path. `streamFormat` (empty: only files
/// are meant) and `only`: see openImageOutput.
[[nodiscard]] Result<const CodecRow*> imageFormatOf(const std::string& path, std::string_view streamFormat,
                                                    std::string_view only = {});

/// Opens the output before the work that leads to it. Its extension is its format; what has none and is no
/// file (-, a pipe, /dev/null) gets `streamFormat`. A terminal is refused, as it would only be disturbed.
/// `only`: the one format that the command writes. What goes wrong is said on standard error; the error is
/// the exit status.
[[nodiscard]] tl::expected<ImageOutput, ExitCode>
openImageOutput(const std::string& path, std::string_view streamFormat, std::string_view only = {});

} // namespace texplorer::screenshot
