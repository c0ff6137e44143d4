#pragma once

#include "texplorer/base/bytes.h"

#include <string>
#include <vector>

namespace texplorer::test {

/// A TGA file, written down field by field; the rest is 0.
struct Recipe {
    int type = 2;
    int width = 2;
    int height = 1;
    int depth = 24;
    int descriptor = 0;
    int firstEntry = 0;
    int entries = 0;
    int entryBits = 0;
    std::vector<int> data{}; // colour map and pixels
};

[[nodiscard]] inline Bytes fileOf(const Recipe& recipe) {
    Bytes file(18, std::byte{0});
    const auto put = [&](std::size_t offset, int value) {
        file[offset] = static_cast<std::byte>(value & 255);
    };
    put(1, recipe.entries > 0 ? 1 : 0);
    put(2, recipe.type);
    put(3, recipe.firstEntry);
    put(4, recipe.firstEntry >> 8);
    put(5, recipe.entries);
    put(6, recipe.entries >> 8);
    put(7, recipe.entryBits);
    put(12, recipe.width);
    put(13, recipe.width >> 8);
    put(14, recipe.height);
    put(15, recipe.height >> 8);
    put(16, recipe.depth);
    put(17, recipe.descriptor);
    for (const int value : recipe.data)
        file.push_back(static_cast<std::byte>(value));
    return file;
}

/// Adds version 2's extension area and footer.
[[nodiscard]] inline Bytes withAttributesType(Bytes file, int type) {
    const std::size_t begin = file.size();
    file.resize(begin + 495 + 8, std::byte{0});
    file[begin] = std::byte{495 & 255};
    file[begin + 1] = std::byte{495 >> 8};
    file[begin + 494] = static_cast<std::byte>(type);
    file[begin + 495] = static_cast<std::byte>(begin);
    file[begin + 496] = static_cast<std::byte>(begin >> 8);
    for (const char c : std::string("TRUEVISION-XFILE.") + '\0')
        file.push_back(static_cast<std::byte>(c));
    return file;
}

} // namespace texplorer::test
