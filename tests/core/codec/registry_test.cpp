#include "texplorer/codec/registry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace texplorer::registry_test {
namespace {

ByteView view(std::string_view text) {
    return std::as_bytes(std::span(text));
}

TEST(Registry, RowsAreCompleteAndUnique) {
    std::set<std::string_view> names;
    for (const CodecRow& row : codecRows()) {
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_TRUE(row.extensions.starts_with(".")) << row.name;
        EXPECT_FALSE(row.recognise({})) << row.name << " recognises an empty file";
        EXPECT_FALSE(row.decode({}, {})) << row.name << " decodes an empty file";
    }
    EXPECT_TRUE(names.contains("BMP"));
}

TEST(Registry, AFileIsRecognisedByItsFirstBytes) {
    ASSERT_NE(recogniseImage(view("BM and more")), nullptr);
    EXPECT_EQ(recogniseImage(view("BM and more"))->name, "BMP");
    EXPECT_EQ(recogniseImage(view("B")), nullptr);
    EXPECT_EQ(recogniseImage(view("")), nullptr);
    EXPECT_EQ(recogniseImage(view("#!/bin/sh")), nullptr);
}

TEST(Registry, TheRightDecoderIsAsked) {
    const Result<Image> image = decodeImage(view("BM"));
    ASSERT_FALSE(image);
    EXPECT_THAT(image.error().message, testing::StartsWith("BMP: "));
}

struct Stranger {
    const char* name;
    std::string_view content;
    ErrorCode code;
    const char* message;
};

class Strangers : public testing::TestWithParam<Stranger> {};

TEST_P(Strangers, AreRefusedWithWhatIsKnownAndWhatWasFound) {
    const Result<Image> image = decodeImage(view(GetParam().content));
    ASSERT_FALSE(image);
    EXPECT_EQ(image.error().code, GetParam().code);
    EXPECT_THAT(image.error().message, testing::MatchesRegex(GetParam().message));
}

INSTANTIATE_TEST_SUITE_P(
    All, Strangers,
    testing::Values(Stranger{"Empty", "", ErrorCode::Malformed,
                             "expected an image \\(.*BMP.*\\), the file is empty"},
                    Stranger{"OneByte", "\x7F", ErrorCode::Unsupported,
                             "expected an image \\(.*BMP.*\\), the file begins with 7f"},
                    Stranger{"Text", "hello", ErrorCode::Unsupported,
                             "expected an image \\(.*BMP.*\\), the file begins with 68 65 6c 6c"}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::registry_test
