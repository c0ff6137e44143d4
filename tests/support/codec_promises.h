#pragma once

// What every row of codecRows() promises for any bytes at all: the tests and the fuzzers ask the same
// questions.

#include "core/codec/registry.h"

namespace texplorer::test {

/// Decodes, dissects and writes again. Empty, or the first promise that was broken: a picture that
/// contradicts itself or exceeds the limits, an error that isn't one sentence beginning with the format's
/// name, pixels that nobody wrote, an anatomy without end, a written file that reads back as another picture.
[[nodiscard]] std::string brokenPromise(const CodecRow& row, ByteView file, const DecodeLimits& limits);

/// Whether the text is one line that a terminal can show: not empty, UTF-8, no control characters, at most
/// 600 bytes.
[[nodiscard]] bool isOneLine(std::string_view text);

} // namespace texplorer::test
