#pragma once

// The promises of every row of codecRows() for any bytes. The tests and the fuzzers use the same checks.

#include "texplorer/codec/registry.h"

namespace texplorer::test {

/// Decodes, dissects and writes again. Returns an empty text, or the first broken promise: a picture that
/// contradicts itself or exceeds the limits, an error that is not one sentence beginning with the format's
/// name, uninitialised pixels, an endless anatomy, a written file that reads back as another picture.
[[nodiscard]] std::string brokenPromise(const CodecRow& row, ByteView file, const DecodeLimits& limits);

/// Whether the text is one line that a terminal can show: not empty, UTF-8, no control characters, at most
/// 600 bytes.
[[nodiscard]] bool isOneLine(std::string_view text);

} // namespace texplorer::test
