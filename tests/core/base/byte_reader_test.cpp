#include "texplorer/base/byte_reader.h"

#include <gtest/gtest.h>

#include <array>

namespace texplorer::byte_reader_test {
namespace {

constexpr std::array data{std::byte{0x01}, std::byte{0x02}, std::byte{0x03}, std::byte{0x84},
                          std::byte{0xFE}, std::byte{0xFF}, std::byte{0xFF}, std::byte{0xFF}};

TEST(ByteReader, NumbersAreLittleEndian) {
    ByteReader reader(data);
    EXPECT_EQ(reader.u8(), 0x01);
    EXPECT_EQ(reader.u16(), 0x0302);
    EXPECT_EQ(reader.u8(), 0x84);
    EXPECT_EQ(reader.i32(), -2);
    EXPECT_EQ(reader.position(), data.size());
    EXPECT_FALSE(reader.truncated());

    ByteReader whole(data);
    EXPECT_EQ(whole.u32(), 0x84030201U);
}

TEST(ByteReader, WhatIsMissingReadsAsZeroAndIsRemembered) {
    ByteReader reader(data);
    reader.skip(6);
    EXPECT_EQ(reader.u32(), 0U) << "two bytes are not half a number";
    EXPECT_TRUE(reader.truncated());
    EXPECT_EQ(reader.u8(), 0U);
    EXPECT_EQ(reader.position(), data.size());
}

TEST(ByteReader, TakesViewsAndRefusesTheLargestCount) {
    ByteReader reader(data);
    EXPECT_EQ(reader.take(3).data(), data.data());
    EXPECT_EQ(reader.position(), 3U);
    EXPECT_TRUE(reader.take(static_cast<std::size_t>(-1)).empty());
    EXPECT_TRUE(reader.truncated());
}

TEST(ByteReader, OfNothingIsTruncatedByTheFirstByte) {
    ByteReader reader({});
    EXPECT_FALSE(reader.truncated());
    EXPECT_EQ(reader.u8(), 0U);
    EXPECT_TRUE(reader.truncated());
}

} // namespace
} // namespace texplorer::byte_reader_test
