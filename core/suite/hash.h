#pragma once

#include "texplorer/base/bytes.h"

#include <string>
#include <string_view>

namespace texplorer::suite {

/// XXH3 of 128 bits as 32 hex digits. Not cryptographic: collisions can be made on purpose.
[[nodiscard]] std::string hashOf(ByteView bytes);
[[nodiscard]] std::string hashOf(std::string_view text);

/// A sequence of texts, each with its length, so that "a", "bc" and "ab", "c" differ.
class HashedText {
public:
    void add(std::string_view text);
    [[nodiscard]] std::string hash() const { return hashOf(text_); }

private:
    std::string text_;
};

} // namespace texplorer::suite
