#pragma once

#include <string>

namespace texplorer::test {

/// A 24-bit BMP of one pixel with the given blue, green and red: 58 bytes.
[[nodiscard]] inline std::string onePixelBmp(const std::string& bgr) {
    using namespace std::string_literals;
    return "BM\0\0\0\0\0\0\0\0\x36\0\0\0"s + "\x28\0\0\0\1\0\0\0\1\0\0\0\1\0\x18\0"s + std::string(24, '\0') +
           bgr + "\0"s;
}

} // namespace texplorer::test
