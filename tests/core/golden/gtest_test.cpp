#include "tests/core/compare/metric_maps.h"
#include "tests/support/temp_dir.h"
#include "texplorer/codec/texture_file.h"
#include "texplorer/golden/gtest.h"

#include <gmock/gmock.h>

#include <cstdlib>

namespace texplorer::golden_gtest_test {
namespace {

using test::even;
using testing::HasSubstr;

/// TEXPLORER_UPDATE_GOLDENS as it is given, and as it was afterwards.
class Asked {
public:
    explicit Asked(const char* value) {
        if (const char* before = std::getenv(name_))
            before_ = before;
        set(value);
    }
    Asked(const Asked&) = delete;
    Asked& operator=(const Asked&) = delete;
    ~Asked() { set(before_ ? before_->c_str() : nullptr); }

private:
    static void set(const char* value) {
        if (value != nullptr)
            ::setenv(name_, value, 1);
        else
            ::unsetenv(name_);
    }

    static constexpr const char* name_ = "TEXPLORER_UPDATE_GOLDENS";
    std::optional<std::string> before_;
};

TEST(GoldenGtest, IsAskedByTheEnvironment) {
    for (const auto& [value, asked] : {std::pair("1", true), {"yes", true}, {"0", false}, {"", false}}) {
        const Asked environment(value);
        EXPECT_EQ(goldensAreUpdated(), asked) << value;
    }
    const Asked environment(nullptr);
    EXPECT_FALSE(goldensAreUpdated());
}

TEST(GoldenGtest, SaysWhatTheCheckSays) {
    const test::TempDir folder;
    const std::filesystem::path golden = folder / "start.png";
    const Image picture = even(4, 4, {10, 20, 30, 255});
    const GoldenOptions options{.failures = folder.path()};
    const Asked unasked(nullptr);

    testing::AssertionResult result = matchesGolden(picture, golden, options);
    EXPECT_FALSE(result);
    EXPECT_THAT(result.message(), HasSubstr("there is no golden"));
    {
        const Asked asked("1");
        EXPECT_TRUE(matchesGolden(picture, golden, options));
    }
    EXPECT_TRUE(matchesGolden(picture, golden, options));
    EXPECT_TRUE(matchesGolden(4, 4, picture.pixels, golden, options));
    result = matchesGolden(even(4, 4, {10, 21, 30, 255}), golden, options);
    EXPECT_FALSE(result);
    EXPECT_THAT(result.message(), HasSubstr("16 of 16 pixels"));
    result = matchesGolden(4, 5, picture.pixels, golden, options);
    EXPECT_FALSE(result);
    EXPECT_THAT(result.message(), HasSubstr("found 64 bytes"));
}

} // namespace
} // namespace texplorer::golden_gtest_test
