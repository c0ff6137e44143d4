// Reading in the background and reading at once give the same results.

#include "app/ui/services/files.h"
#include "tests/support/raw_file.h"
#include "tests/support/small_bmp.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>

namespace texplorer::ui::files_test {
namespace {

using testing::HasSubstr;

template<class Implementation>
class FilesTest : public testing::Test {
protected:
    std::filesystem::path bmp(const std::string& name) {
        test::writeRaw(folder / name, test::onePixelBmp({0, 0, 50}));
        return folder / name;
    }
    test::TempDir folder;
    Implementation files;
};

using Implementations = testing::Types<FilesAtOnce, FilesBeside>;
TYPED_TEST_SUITE(FilesTest, Implementations);

TYPED_TEST(FilesTest, AreTakenOnceInTheOrderInWhichTheyWereAskedFor) {
    const auto first = this->files.load(this->bmp("a.bmp"));
    const auto second = this->files.load(this->bmp("b.bmp"), Files::Wanted::Anatomy);
    EXPECT_NE(first, 0U);
    EXPECT_NE(first, second);
    this->files.wait();
    const auto loaded = this->files.take();
    ASSERT_EQ(loaded.size(), 2U);
    EXPECT_EQ(loaded[0].ticket, first);
    EXPECT_EQ(loaded[0].path, this->folder / "a.bmp");
    EXPECT_TRUE(std::holds_alternative<std::shared_ptr<const TextureImage>>(loaded[0].content.value()));
    EXPECT_EQ(loaded[1].ticket, second);
    const auto& dissected = std::get<std::shared_ptr<const DissectedFile>>(loaded[1].content.value());
    EXPECT_EQ(dissected->fileBytes, 58U);
    EXPECT_TRUE(this->files.take().empty());
    EXPECT_FALSE(this->files.progress().has_value());
}

TYPED_TEST(FilesTest, NothingComesOfWhatIsCancelled) {
    const auto given = this->files.load(this->bmp("a.bmp"));
    const auto kept = this->files.load(this->bmp("b.bmp"));
    this->files.cancel(given);
    this->files.wait();
    const auto loaded = this->files.take();
    ASSERT_EQ(loaded.size(), 1U);
    EXPECT_EQ(loaded[0].ticket, kept);
}

TYPED_TEST(FilesTest, AFileThatIsGoneIsAnErrorWithItsPath) {
    (void)this->files.load(this->folder / "gone.bmp");
    this->files.wait();
    const auto loaded = this->files.take();
    ASSERT_EQ(loaded.size(), 1U);
    ASSERT_FALSE(loaded[0].content.has_value());
    EXPECT_EQ(loaded[0].content.error().where, (this->folder / "gone.bmp").string());
}

} // namespace
} // namespace texplorer::ui::files_test
