#pragma once

#include "texplorer/base/result.h"
#include "texplorer/files/file_io.h"
#include "texplorer/files/read_stream.h"

#include <span>
#include <string>

namespace texplorer::screenshot {

/// Whether an argument names the program's own standard input: "-", or /dev/stdin.
[[nodiscard]] bool isStandardInput(const std::string& path);

/// Whether an input is an OBJ file, by its name, or on standard input by its content.
[[nodiscard]] bool isObjInput(const std::string& path, ByteView file);

/// How sentences call an input: by its path, or as standard input.
[[nodiscard]] std::string inputName(const std::string& path);

/// Standard input can be read once.
[[nodiscard]] Result<void> checkStandardInputOnce(std::span<const std::string> paths);

/// All of a file, of standard input ("-") or of a pipe that has a name, within the same limit; errors name it
/// as inputName does. Of a stream that isn't worth reading on only the start is given.
[[nodiscard]] Result<Bytes> readInput(const std::string& path, std::size_t maxBytes = defaultMaxFileBytes,
                                      const IsWorthReading& isWorthReading = {});

/// The same of an image: of what begins as no image does, or has a header that no more bytes make right, only
/// the start is read. A stream is not read far beyond what its header says, as it may have no end.
[[nodiscard]] Result<Bytes> readImageInput(const std::string& path);

/// Asked as IsWorthReading is.
class ImageHead {
public:
    [[nodiscard]] bool operator()(ByteView start);

private:
    std::string last_; ///< what was wrong with half as many bytes
};

} // namespace texplorer::screenshot
