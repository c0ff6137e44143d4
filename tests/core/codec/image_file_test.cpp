#include "core/codec/image_file.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer {
namespace {

TEST(ImageFile, SaysWhatTheFileIsAndWhatItHolds) {
    const test::TempDir folder;
    test::writeRaw(folder / "red.picture", test::onePixelBmp("\1\2\3"));
    const Result<ImageFile> file = readImageFile(folder / "red.picture");
    ASSERT_TRUE(file) << describe(file.error());
    EXPECT_EQ(file->format, "BMP") << "by its content, not by its name";
    EXPECT_EQ(file->fileBytes, 58);
    EXPECT_EQ(file->image.width, 1);
    EXPECT_EQ(file->image.at(0, 0)[0], std::byte{3});
}

TEST(ImageFile, EveryErrorNamesTheFile) {
    const test::TempDir folder;
    test::writeRaw(folder / "text.bmp", std::string("not a picture"));
    test::writeRaw(folder / "cut.bmp", test::onePixelBmp("\1\2\3").substr(0, 56));
    for (const auto& [name, code] : {std::pair{"none.bmp", ErrorCode::NotFound},
                                     {"text.bmp", ErrorCode::Unsupported},
                                     {"cut.bmp", ErrorCode::Malformed},
                                     {"", ErrorCode::Unreadable}}) {
        const Result<ImageFile> file = readImageFile(folder / name);
        ASSERT_FALSE(file) << name;
        EXPECT_EQ(file.error().code, code) << name;
        EXPECT_EQ(file.error().where, (folder / name).string());
    }
}

} // namespace
} // namespace texplorer
