// Names of arguments that no parameter has, and those that they share with rows.

#include "texplorer/gl/argument_names.h"

#include <gtest/gtest.h>

namespace texplorer::argument_names_test {
namespace {

TEST(ArgumentNames, UnitsHaveTheNamesThatACrossbarReads) {
    EXPECT_EQ(textureUnitName(0), "GL_TEXTURE0");
    EXPECT_EQ(textureUnitName(3), "GL_TEXTURE3");
    EXPECT_EQ(textureMode, "GL_TEXTURE");
}

TEST(ArgumentNames, BooleansAreOpenGls) {
    EXPECT_EQ(booleanName(true), "GL_TRUE");
    EXPECT_EQ(booleanName(false), "GL_FALSE");
}

} // namespace
} // namespace texplorer::argument_names_test
