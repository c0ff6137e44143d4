#include "app/render/gl_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace texplorer::render::gl_errors_test {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

unsigned nothing() {
    return 0;
}
unsigned invalidValueForEver() {
    return 0x0501;
}
unsigned contextLostForEver() {
    return 0x0507;
}
unsigned unknownOnce() {
    static bool asked = false;
    return std::exchange(asked, true) ? 0 : 0x0999;
}

TEST(GlErrors, NoErrorIsNoSentence) {
    GlErrors errors;
    EXPECT_TRUE(errors.check("glClear", nothing));
    EXPECT_THAT(errors.sentences(), SizeIs(0));
}

TEST(GlErrors, AnErrorIsNamedWithItsCallAndWhatItMeans) {
    GlErrors errors;
    EXPECT_FALSE(errors.check("glTexImage2D", invalidValueForEver));
    EXPECT_THAT(errors.sentences(),
                ElementsAre("glTexImage2D: GL_INVALID_VALUE (A number is out of range.)"));
}

TEST(GlErrors, ANameThatHasToBePutTogetherIsAskedForOnlyThen) {
    GlErrors errors;
    int asked = 0;
    const auto where = [&] { return "models[" + std::to_string(asked++) + "]: glMaterial"; };
    EXPECT_TRUE(errors.check(where, nothing));
    EXPECT_EQ(asked, 0);
    EXPECT_FALSE(errors.check(where, contextLostForEver));
    EXPECT_THAT(errors.sentences(), ElementsAre(testing::StartsWith("models[0]: glMaterial: ")));
}

TEST(GlErrors, ALostContextIsSaidOnceAndDoesNotLoop) {
    GlErrors errors;
    EXPECT_FALSE(errors.check("glClear", contextLostForEver));
    EXPECT_FALSE(errors.check("glClear", contextLostForEver));
    EXPECT_THAT(errors.sentences(), SizeIs(1));
}

TEST(GlErrors, AnUnknownErrorIsShownAsANumber) {
    GlErrors errors;
    EXPECT_FALSE(errors.check("glClear", unknownOnce));
    EXPECT_THAT(errors.sentences(), ElementsAre("glClear: error 2457"));
}

} // namespace
} // namespace texplorer::render::gl_errors_test
