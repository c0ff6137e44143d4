#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"

#include <functional>
#include <string>

namespace texplorer {

/// Asked with the first megabyte of what is longer, and each time that it has doubled: whether it is worth
/// reading on.
using IsWorthReading = std::function<bool(ByteView start)>;

/// All that comes from something that is open and has no size of its own: a pipe, a terminal, standard input.
/// Waits for who writes into it. Where the rest isn't worth reading, its start is what is given. `where` is
/// named in errors: Unreadable; TooLarge as soon as more than `maxBytes` have come, or without memory.
[[nodiscard]] Result<Bytes> readStream(int file, const std::string& where, std::size_t maxBytes,
                                       const IsWorthReading& isWorthReading = {});

} // namespace texplorer
