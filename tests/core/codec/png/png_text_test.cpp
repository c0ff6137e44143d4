#include "tests/support/python.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/png/png.h"
#include "texplorer/codec/png/png_text.h"
#include "texplorer/files/file_io.h"
#include "texplorer/image/patterns/pattern.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::png_text_test {
namespace {

std::string longText() {
    std::string text;
    for (int i = 0; i < 5000; ++i)
        text += std::to_string(i) + "ö\n";
    return text;
}

std::vector<PictureText> someTexts() {
    return {{"Software", "texshot"},
            {"Two Words", "a line\nand another"},
            {"Letters", "größe 日本"},
            {"Empty", ""},
            {"Plain and long", std::string(packedTextBytes, 'x')},
            {"Long", longText()}};
}

Bytes pngWith(const std::vector<PictureText>& texts) {
    return encodePng(drawPattern(Pattern::Brick), {.texts = texts}).value_or(Bytes());
}

TEST(PngText, PillowReadsWhatWasWritten) {
    const test::TempDir folder;
    test::writeRaw(folder / "texts.png", pngWith(someTexts()));
    for (std::size_t i = 0; i < someTexts().size(); ++i) {
        test::writeRaw(folder / (std::to_string(i) + ".keyword"), viewBytes(someTexts()[i].keyword));
        test::writeRaw(folder / (std::to_string(i) + ".text"), viewBytes(someTexts()[i].text));
    }
    EXPECT_TRUE(test::runPython("core/codec/png/png_text_against_pillow.py", folder.path()));
}

/// "none" or "error" where there is no text.
std::string found(ByteView png, const char* keyword, std::size_t maxBytes = std::size_t{1} << 20) {
    const Result<std::optional<std::string>> text = findPngText(png, keyword, maxBytes);
    return text ? text->value_or("none") : "error";
}

TEST(PngText, IsFoundAgain) {
    const Bytes png = pngWith(someTexts());
    for (const PictureText& each : someTexts())
        EXPECT_EQ(found(png, each.keyword.c_str()), each.text);
    EXPECT_EQ(found(png, "Soft"), "none");
    EXPECT_EQ(found(pngWith({}), "Software"), "none");
}

TEST(PngText, ChangesNoPixel) {
    const auto plain = decodePng(pngWith({}));
    const auto texts = decodePng(pngWith(someTexts()));
    ASSERT_TRUE(plain && texts);
    EXPECT_EQ(plain->surfaces, texts->surfaces);
    EXPECT_THAT(texts->notes, testing::IsEmpty());
}

TEST(PngText, ALongTextIsPackedAndBounded) {
    const Bytes png = pngWith({{"Long", std::string(std::size_t{1} << 20, 'x')}});
    EXPECT_LT(png.size(), pngWith({}).size() + 2000);
    EXPECT_TRUE(findPngText(png, "Long", std::size_t{1} << 20));
    const auto refused = findPngText(png, "Long", (std::size_t{1} << 20) - 1);
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::TooLarge);
    EXPECT_EQ(refused.error().message, "PNG: its text \"Long\" holds more than 1048575 bytes");
}

TEST(PngText, AKeywordThatPngHasntIsRefused) {
    for (const std::string& keyword :
         {std::string(), std::string(80, 'x'), std::string(" a"), std::string("a "), std::string("a  b"),
          std::string("größe"), std::string("a\nb"), std::string("a\0b", 3)}) {
        const auto refused = encodePng(drawPattern(Pattern::Brick), {.texts = {{keyword, "text"}}});
        ASSERT_FALSE(refused) << keyword;
        EXPECT_THAT(refused.error().message, testing::HasSubstr("keyword has 1 to 79 letters"));
    }
}

TEST(PngText, ADamagedOneIsSaid) {
    const Bytes good = pngWith({{"Key", "value"}, {"Long", longText()}});
    for (std::size_t at = 33; at < good.size() && at < 33 + 600; ++at) {
        Bytes png = good;
        png[at] ^= std::byte{0x10};
        EXPECT_THAT(found(png, "Key"), testing::AnyOf("value", "none", "error")) << at;
        EXPECT_THAT(found(png, "Long"), testing::AnyOf(longText(), "none", "error")) << at;
        png.resize(at);
        EXPECT_THAT(found(png, "Long"), testing::AnyOf(longText(), "none", "error")) << at;
        static_cast<void>(dissectPng(png));
    }
    EXPECT_EQ(found({}, "Key"), "error");
}

} // namespace
} // namespace texplorer::png_text_test
