#pragma once

#include "texplorer/base/bytes.h"
#include "texplorer/base/result.h"

#include <functional>
#include <string>

namespace texplorer {

/// Called with the first megabyte of a longer stream, and again each time that the size has doubled. Returns
/// whether to read on.
using IsWorthReading = std::function<bool(ByteView start)>;

/// Reads everything from an open file without a size: a pipe, a terminal, standard input. Blocks until the
/// writer closes it. If `isWorthReading` returns false, the start that was read is returned. Errors name
/// `where`: Unreadable; TooLarge once more than `maxBytes` have arrived, or without memory.
[[nodiscard]] Result<Bytes> readStream(int file, const std::string& where, std::size_t maxBytes,
                                       const IsWorthReading& isWorthReading = {});

} // namespace texplorer
