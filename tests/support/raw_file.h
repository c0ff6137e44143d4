#pragma once

// Plain file access for tests, independent of core/files/file_io.

#include "texplorer/base/bytes.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace texplorer::test {

inline void writeRaw(const std::filesystem::path& path, ByteView bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

inline void writeRaw(const std::filesystem::path& path, const std::string& text) {
    writeRaw(path, std::as_bytes(std::span(text)));
}

[[nodiscard]] inline std::string readRawText(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

[[nodiscard]] inline Bytes readRaw(const std::filesystem::path& path) {
    const std::string text = readRawText(path);
    const auto view = std::as_bytes(std::span(text));
    return {view.begin(), view.end()};
}

} // namespace texplorer::test
