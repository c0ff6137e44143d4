#include "texplorer/base/thrown.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <thread>

namespace texplorer::thrown_test {
namespace {

TEST(ReasonOf, IsTheSystemsOrThatItIsAMistake) {
    EXPECT_EQ(reasonOf(std::system_error(std::make_error_code(std::errc::no_space_on_device), "write")),
              "No space left on device");
    EXPECT_EQ(reasonOf(std::filesystem::filesystem_error("cannot remove", "/x",
                                                         std::make_error_code(std::errc::permission_denied))),
              "Permission denied");
    EXPECT_EQ(reasonOf(std::out_of_range("vector::_M_range_check: __n (which is 0) >= this->size()")),
              ownMistake);
}

TEST(SayWhatNothingCatches, EndsAThreadsProgramWithASentence) {
    const auto throwOnAThread = [] {
        sayWhatNothingCatches("texshot");
        std::thread([] { throw std::out_of_range("vector::_M_range_check"); }).join();
    };
    EXPECT_EXIT(throwOnAThread(), testing::KilledBySignal(SIGABRT),
                "^texshot: this is a bug in Texplorer; please report it and how it happened\n$");
}

} // namespace
} // namespace texplorer::thrown_test
