#pragma once

#include "core/base/bytes.h"

#include <string>
#include <string_view>

namespace texplorer::suite {

/// XXH3 of 128 bits as 32 hex digits. Not for secrets: who wants two texts of one hash can make them.
[[nodiscard]] std::string hashOf(ByteView bytes);
[[nodiscard]] std::string hashOf(std::string_view text);

/// Texts one after the other, each with its length, so that "a", "bc" and "ab", "c" are two things.
class HashedText {
public:
    void add(std::string_view text);
    [[nodiscard]] std::string hash() const { return hashOf(text_); }

private:
    std::string text_;
};

} // namespace texplorer::suite
