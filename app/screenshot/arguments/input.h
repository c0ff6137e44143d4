#pragma once

#include "core/base/file_io.h"
#include "core/base/read_stream.h"
#include "core/base/result.h"

#include <span>
#include <string>

namespace texplorer::screenshot {

/// Whether an argument names the program's own standard input: "-", or /dev/stdin.
[[nodiscard]] bool isStandardInput(const std::string& path);

/// How sentences call an input: by its path, or as standard input.
[[nodiscard]] std::string inputName(const std::string& path);

/// Standard input can be read once.
[[nodiscard]] Result<void> checkStandardInputOnce(std::span<const std::string> paths);

/// All of a file, of standard input ("-") or of a pipe that has a name, within the same limit; errors name it
/// as inputName does. Of a stream that isn't worth reading on only the start is given.
[[nodiscard]] Result<Bytes> readInput(const std::string& path, std::size_t maxBytes = defaultMaxFileBytes,
                                      const IsWorthReading& isWorthReading = {});

/// The same of an image: a stream that begins as no image does is not read to an end that it may not have.
[[nodiscard]] Result<Bytes> readImageInput(const std::string& path);

} // namespace texplorer::screenshot
