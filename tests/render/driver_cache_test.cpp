#include "app/render/driver_cache.h"
#include "tests/support/temp_dir.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <sys/resource.h>
#include <sys/stat.h>

namespace texplorer::driver_cache_test {
namespace {

namespace fs = std::filesystem;
using render::checkDriverCache;

constexpr off_t indexBytes = 8 + 65536 * 20; // what Mesa 22.3 maps: a counter and its keys

struct stat statusOf(const fs::path& path) {
    struct stat found {};
    EXPECT_EQ(::lstat(path.c_str(), &found), 0) << path;
    return found;
}

class DriverCache : public testing::Test {
protected:
    test::TempDir folder;
    fs::path cache = folder.path() / "texplorer" / "driver";
    fs::path index = cache / "mesa_shader_cache" / "index";
};

TEST_F(DriverCache, IsPrivateAndItsIndexHasAllItsBlocks) {
    const Result<void> fit = checkDriverCache(cache);
    ASSERT_TRUE(fit) << describe(fit.error());
    EXPECT_EQ(statusOf(cache).st_mode & 07777U, 0700U);
    EXPECT_EQ(statusOf(index.parent_path()).st_mode & 07777U, 0700U);
    EXPECT_EQ(statusOf(index).st_size, indexBytes);
    EXPECT_GE(statusOf(index).st_blocks * 512, indexBytes);
}

TEST_F(DriverCache, FillsTheHolesOfAnIndexAndKeepsWhatIsThere) {
    fs::create_directories(index.parent_path());
    fs::permissions(cache, fs::perms::owner_all);
    fs::permissions(index.parent_path(), fs::perms::owner_all);
    std::ofstream(index) << "content";
    fs::resize_file(index, indexBytes);
    ASSERT_LT(statusOf(index).st_blocks * 512, indexBytes);
    ASSERT_TRUE(checkDriverCache(cache));
    EXPECT_GE(statusOf(index).st_blocks * 512, indexBytes);
    std::string begin(7, ' ');
    std::ifstream(index).read(begin.data(), 7);
    EXPECT_EQ(begin, "content");
}

TEST_F(DriverCache, RefusesADirectoryThatOthersMayWriteTo) {
    fs::create_directories(cache);
    fs::permissions(cache, fs::perms::all);
    const Result<void> fit = checkDriverCache(cache);
    ASSERT_FALSE(fit);
    EXPECT_EQ(fit.error().message, "is writable by others");
}

TEST_F(DriverCache, RefusesLinks) {
    const fs::path elsewhere = folder.path() / "elsewhere";
    fs::create_directories(elsewhere);
    fs::permissions(elsewhere, fs::perms::owner_all);
    fs::create_directories(cache.parent_path());
    fs::create_directory_symlink(elsewhere, cache);
    EXPECT_FALSE(checkDriverCache(cache));
    EXPECT_TRUE(fs::is_empty(elsewhere));

    fs::remove(cache);
    ASSERT_TRUE(checkDriverCache(cache));
    fs::remove(index);
    const fs::path precious = elsewhere / "precious";
    std::ofstream(precious) << "content";
    fs::create_symlink(precious, index);
    EXPECT_FALSE(checkDriverCache(cache));
    EXPECT_EQ(fs::file_size(precious), 7U);
}

TEST_F(DriverCache, RefusesWhatHasNoRoomForTheIndex) {
    struct rlimit before {};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    struct rlimit small = before;
    small.rlim_cur = 100000;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const Result<void> fit = checkDriverCache(cache); // the limit's signal would end the process
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    ASSERT_FALSE(fit);
    EXPECT_NE(fit.error().message.english().find("1310728 bytes"), std::string::npos)
        << describe(fit.error()).english();
}

TEST_F(DriverCache, RefusesAPlaceWhereNothingCanBeMade) {
    EXPECT_FALSE(checkDriverCache("/dev/null/texplorer/driver"));
}

} // namespace
} // namespace texplorer::driver_cache_test
