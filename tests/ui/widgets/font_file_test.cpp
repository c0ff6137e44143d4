#include "app/ui/widgets/fonts.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"

#include <gtest/gtest.h>

#include <array>

namespace texplorer::ui::font_file_test {
namespace {

const std::filesystem::path dejaVu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

TEST(FontFile, IsToldFromWhatDearImGuiWouldEndTheProgramOver) {
    const Result<Bytes> font = readFile(dejaVu);
    if (!font)
        GTEST_SKIP() << "there is no DejaVu";
    EXPECT_TRUE(isFontFile(dejaVu));
    const test::TempDir folder;
    const auto written = [&](const char* name, const Bytes& bytes) {
        EXPECT_TRUE(writeFileAtomically(folder.path() / name, bytes));
        return folder.path() / name;
    };
    EXPECT_TRUE(isFontFile(written("whole.ttf", *font)));
    for (const std::size_t size : {std::size_t{0}, std::size_t{3}, std::size_t{11}, std::size_t{200},
                                   font->size() / 2, font->size() - 64})
        EXPECT_FALSE(
            isFontFile(written("cut.ttf", Bytes(font->begin(), font->begin() + std::ptrdiff_t(size)))))
            << size;
    Bytes other = *font;
    other[0] = std::byte{'P'};
    EXPECT_FALSE(isFontFile(written("text.ttf", other)));
    EXPECT_FALSE(isFontFile(folder.path()));
    EXPECT_FALSE(isFontFile(folder.path() / "none.ttf"));
}

// "ttcf", version 1, one font, at offset 16, whose tables are counted from the beginning of the file.
TEST(FontFile, ACollectionIsAsItsFirstFontIs) {
    Result<Bytes> font = readFile(dejaVu);
    if (!font)
        GTEST_SKIP() << "there is no DejaVu";
    const auto number = [](Bytes& bytes, std::size_t at, std::uint32_t value) {
        for (std::size_t i = 0; i < 4; ++i)
            bytes[at + i] = static_cast<std::byte>(value >> (24 - 8 * i));
    };
    const auto numberAt = [](const Bytes& bytes, std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i)
            value = value << 8U | std::to_integer<std::uint32_t>(bytes[at + i]);
        return value;
    };
    Bytes collection(16);
    number(collection, 0, 0x74746366);
    number(collection, 4, 0x00010000);
    number(collection, 8, 1);
    number(collection, 12, 16);
    const auto tables = std::to_integer<std::size_t>((*font)[5]);
    for (std::size_t i = 0; i < tables; ++i)
        number(*font, 12 + 16 * i + 8, numberAt(*font, 12 + 16 * i + 8) + 16);
    collection.insert(collection.end(), font->begin(), font->end());
    const test::TempDir folder;
    const std::filesystem::path file = folder.path() / "all.ttc";
    ASSERT_TRUE(writeFileAtomically(file, collection));
    EXPECT_TRUE(isFontFile(file));
    number(collection, 12, 20);
    ASSERT_TRUE(writeFileAtomically(file, collection));
    EXPECT_FALSE(isFontFile(file));
}

} // namespace
} // namespace texplorer::ui::font_file_test
