#pragma once

// Files that a Python script makes in every variant of a format, and what a decoder owes to damaged ones.

#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>
#include <vector>

namespace texplorer::test {

/// A fixture whose suite calls `make` first. Its files belong to the suite.
class MadeFiles : public testing::Test {
protected:
    static void make(const std::string& script) {
        const TempDir folder;
        ASSERT_TRUE(runPython(script, folder.path()));
        for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
            contents()[entry.path().filename().string()] = readRaw(entry.path());
    }
    static void TearDownTestSuite() { contents().clear(); }

    static std::map<std::string, Bytes>& contents() {
        static std::map<std::string, Bytes> files;
        return files;
    }
    static std::vector<std::string> names(std::string_view ending) {
        std::vector<std::string> found;
        for (const auto& [name, file] : contents())
            if (name.ends_with(ending))
                found.push_back(name);
        return found;
    }
};

/// Cut behind any byte, the file is refused with a sentence that begins with the format's name.
inline void expectRefusedWhenCut(const CodecRow& row, const Bytes& file) {
    for (std::size_t size = 0; size < file.size(); ++size) {
        // A copy of exactly that size, so that the sanitizer sees a read beyond its end.
        const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
        const Result<TextureImage> texture = row.decode(cut, {});
        ASSERT_FALSE(texture) << size << " of " << file.size() << " bytes";
        ASSERT_THAT(texture.error().message, testing::StartsWith(std::string(row.name) + ": "));
    }
}

/// Turns one to three bits of the file behind its first `spared` bytes.
inline void flipBits(Bytes& file, std::size_t spared, std::mt19937& random) {
    for (int flips = 1 + static_cast<int>(random() % 3); flips > 0; --flips)
        file[spared + random() % (file.size() - spared)] ^= static_cast<std::byte>(1U << (random() % 8));
}

struct Outcomes {
    int decoded = 0;
    int refused = 0;
};

/// Decodes a damaged file: it gives a whole picture or a sentence that begins with the format's name.
inline void countOutcome(const CodecRow& row, const Bytes& file, Outcomes& outcomes) {
    const Result<TextureImage> texture = row.decode(file, {.maxExtent = 4096});
    if (!texture) {
        ++outcomes.refused;
        ASSERT_THAT(texture.error().message, testing::StartsWith(std::string(row.name) + ": "));
        return;
    }
    ++outcomes.decoded;
    const Image& image = std::get<Image>(texture->surfaces.at(0));
    ASSERT_EQ(image.pixels.size(), image.rowBytes() * static_cast<std::size_t>(image.height));
}

} // namespace texplorer::test
