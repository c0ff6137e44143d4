// Tests every row of codecRows() with any bytes: written files that are cut at every byte, changed and
// spliced, and headers with a wrong size of the picture. New rows are tested automatically.

#include "tests/support/codec_promises.h"
#include "tests/support/png_repair.h"
#include "tests/support/sample_textures.h"
#include "tests/support/watched_heap.h"
#include "texplorer/codec/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace texplorer::robustness_test {
namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;
constexpr DecodeLimits limits{.maxBytes = 64 * mebibyte};

class Robustness : public testing::TestWithParam<const CodecRow*> {
protected:
    const CodecRow& row_ = *GetParam();
    const std::vector<Bytes> files_ = test::sampleFiles(row_);
    std::mt19937 random_{8}; // NOLINT: the same files each time

    std::size_t below(std::size_t end) { return random_() % end; }

    void keepsItsPromises(ByteView file) {
        // A copy of exactly that size, so that the sanitizer sees a read beyond its end.
        const Bytes exact(file.begin(), file.end());
        EXPECT_EQ(test::brokenPromise(row_, exact, limits), "");
    }
};

TEST_P(Robustness, WhatTheWriterWritesIsReadAgain) {
    for (const Bytes& file : files_) {
        ASSERT_EQ(recogniseImage(file), &row_);
        const Result<TextureImage> texture = decodeTexture(file);
        ASSERT_TRUE(texture) << texture.error().message;
        keepsItsPromises(file);
    }
    EXPECT_EQ(files_.empty(), row_.encode == nullptr) << "a writer that refuses every sample";
}

TEST_P(Robustness, AFileMayEndAnywhere) {
    for (const Bytes& file : files_)
        // Every byte of headers and tables, some bytes among pixels.
        for (std::size_t size = 0; size < file.size() && !HasFailure(); size += size < 256 ? 1 : 5)
            keepsItsPromises(ByteView(file).first(size));
}

TEST_P(Robustness, AnyBytesMayBeOthers) {
    for (const Bytes& original : files_) {
        for (int round = 0; round < 120 && !HasFailure(); ++round) {
            Bytes file = original;
            // Headers are at the beginning: half of the changes go there.
            const std::size_t end = round % 2 == 0 ? std::min<std::size_t>(64, file.size()) : file.size();
            for (std::size_t changes = 1 + below(4); changes > 0; --changes)
                file[below(end)] ^= static_cast<std::byte>(random_() % 2 ? 1U << below(8) : random_());
            if (round % 4 != 0)
                test::repairPng(file);
            keepsItsPromises(file);
        }
    }
}

TEST_P(Robustness, TwoFilesMayBeSpliced) {
    for (int round = 0; round < 1000 && !files_.empty() && !HasFailure(); ++round) {
        const Bytes& first = files_[below(files_.size())];
        const Bytes& second = files_[below(files_.size())];
        Bytes file(first.begin(), first.begin() + static_cast<std::ptrdiff_t>(below(first.size())));
        file.insert(file.end(), second.begin() + static_cast<std::ptrdiff_t>(below(second.size())),
                    second.end());
        test::repairPng(file);
        keepsItsPromises(file);
    }
}

TEST_P(Robustness, NoiseIsRefusedInOneSentence) {
    for (int round = 0; round < 2000 && !HasFailure(); ++round) {
        Bytes file(below(300));
        std::ranges::generate(file, [&] { return static_cast<std::byte>(random_() >> 24); });
        keepsItsPromises(file);
    }
}

/// Writes `value` at `at` as two or four bytes, little- or big-endian.
void claim(Bytes& file, std::size_t at, std::size_t bytes, bool bigEndian, unsigned value) {
    for (std::size_t i = 0; i < bytes && at + i < file.size(); ++i)
        file[at + i] = static_cast<std::byte>(value >> 8 * (bigEndian ? bytes - 1 - i : i));
}

// Two numbers at any two places of the header are set to 16384: as width and height, that is a gigabyte.
TEST_P(Robustness, AHeaderThatLiesAboutTheSizeCostsNoMemory) {
    constexpr unsigned large = 16384;
    constexpr std::size_t headerEnd = 40;
    // No coding expands a byte to more than 1032 bytes (deflate's limit); the rest is for tables and
    // libraries.
    const auto allowed = [](const Bytes& file) { return 2048 * file.size() + mebibyte; };
    std::size_t lies = 0;
    for (std::size_t i = 0; i < files_.size() && !HasFailure(); i += 3) {
        for (const auto& [bytes, bigEndian] : {std::pair{2, false}, {4, false}, {2, true}, {4, true}}) {
            const auto step = static_cast<std::size_t>(bytes);
            for (std::size_t first = 0; first < headerEnd; first += 2) {
                Bytes file = files_[i];
                if (file.size() > 1024) // the bound is too loose for them
                    continue;
                claim(file, first, step, bigEndian, large);
                claim(file, first + step, step, bigEndian, large);
                test::repairPng(file);
                const test::HeapWatch heap;
                static_cast<void>(row_.decode(file, {}));
                if (row_.dissect)
                    static_cast<void>(row_.dissect(file));
                ASSERT_LE(heap.peak(), allowed(file)) << "16384 × 16384 claimed at offset " << first;
                ++lies;
            }
        }
    }
    EXPECT_EQ(lies == 0, files_.empty());
}

INSTANTIATE_TEST_SUITE_P(All, Robustness, testing::ValuesIn([] {
                             std::vector<const CodecRow*> rows;
                             for (const CodecRow& row : codecRows())
                                 rows.push_back(&row);
                             return rows;
                         }()),
                         [](const auto& test) { return std::string(test.param->name); });

TEST(WatchedHeap, CountsAndFills) {
    test::heapFill = std::byte{0x5C};
    const test::HeapWatch heap;
    const Bytes bytes(mebibyte);
    test::heapFill = {};
    Bytes uninitialised;
    uninitialised.resize(16);
    EXPECT_GE(heap.peak(), mebibyte + 16);
    EXPECT_LT(heap.peak(), mebibyte + 65536);
    EXPECT_TRUE(std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0x5C}; }));
}

} // namespace
} // namespace texplorer::robustness_test
