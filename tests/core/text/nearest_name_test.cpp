#include "texplorer/text/nearest_name.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::nearest_name_test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(NearestName, IsTheOneWithTheFewestLettersToChange) {
    EXPECT_EQ(nearestName("minFliter", {"magFilter", "minFilter", "wrapS"}), "minFilter");
    EXPECT_EQ(nearestName("MINFILTER", {"magFilter", "minFilter"}), "minFilter");
    EXPECT_EQ(nearestName("wrapS", {"magFilter"}), "");
    EXPECT_EQ(nearestName("", {"magFilter"}), "");
}

TEST(NearestName, AThirdOfTheLettersMayDiffer) {
    EXPECT_EQ(nearestName("abcdef", {"abcdxy"}), "abcdxy"); // 2 of 6
    EXPECT_EQ(nearestName("abcdef", {"abcxyz"}), "");       // 3 of 6
    EXPECT_EQ(nearestName("abc", {"abd"}), "abd");          // of a short one, one letter
    EXPECT_EQ(nearestName("abc", {"ade"}), "");
}

TEST(NearestName, TwoLettersThatChangedPlacesAreOneMistake) {
    EXPECT_EQ(nearestName("hsot", {"shot"}), "shot");
    EXPECT_EQ(nearestName("veiw", {"light", "view"}), "view");
    EXPECT_EQ(nearestName("shto", {"stop", "shot"}), "shot");
    EXPECT_EQ(nearestName("hsto", {"shot"}), ""); // two of them, in four letters
}

TEST(NearestName, ThoseThatAreEquallyCloseAreAllNamed) {
    EXPECT_THAT(nearestNames("wrapX", {"wrapS", "wrapT", "wrapping"}), ElementsAre("wrapS", "wrapT"));
    EXPECT_THAT(nearestNames("wrapS", {"wrapT", "wrapS"}), ElementsAre("wrapS"));
    EXPECT_THAT(nearestNames(std::string(65, 'a'), {"a"}), IsEmpty());
}

TEST(NearestName, ABeginningOfThreeLettersStandsForWhatBeginsWithIt) {
    EXPECT_THAT(nearestNames("dist", {"azimuth", "distance", "list"}), ElementsAre("distance"));
    EXPECT_THAT(nearestNames("WRAP", {"wrapS", "magFilter", "wrapT", "rap"}), ElementsAre("wrapS", "wrapT"));
    EXPECT_THAT(nearestNames("di", {"distance"}), IsEmpty());
}

} // namespace
} // namespace texplorer::nearest_name_test
