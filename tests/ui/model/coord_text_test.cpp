#include "app/ui/model/coord_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace texplorer::ui::coord_text_test {
namespace {

TEST(CoordText, SaysRAndQOnlyWhereTheyDiffer) {
    const TexCoords coords{{0.25F, 0.5F, 0, 1}, {1, -2, 0, 2}};
    EXPECT_EQ(coordText(coords), "0.25 0.5\n1 -2 0 2\n");
    EXPECT_EQ(parseCoordText(coordText(coords)).value(), coords);
}

TEST(CoordText, TakesWhatOtherProgramsWrite) {
    EXPECT_EQ(parseCoordText("(0.25, 0.5)\r\n\n  1;\t2 \n3 4 5").value(),
              (TexCoords{{0.25F, 0.5F, 0, 1}, {1, 2, 0, 1}, {3, 4, 5, 1}}));
    EXPECT_EQ(parseCoordText("1e-2 -.5").value(), (TexCoords{{0.01F, -0.5F, 0, 1}}));
}

struct Case {
    const char* name;
    std::string text;
    const char* message;
};

TEST(CoordText, WhatIsWrongIsOneSentence) {
    for (const Case& row :
         {Case{"Nothing", "", "expected lines with two numbers each, found none"},
          Case{"Blanks", " \n\n", "expected lines with two numbers each, found none"},
          Case{"AWord", "0 0\nabc 1", "line 2: expected a number, found \"abc\""},
          Case{"Half", "0 0.5x", "line 1: expected a number, found \"0.5x\""},
          Case{"NotANumber", "nan 0", "line 1: expected a number, found \"nan\""},
          Case{"One", "1", "line 1: expected 2 to 4 numbers, found 1"},
          Case{"Five", "1 2 3 4 5", "line 1: expected 2 to 4 numbers, found 5"},
          Case{"TooLarge", "1 1001", "line 1: expected a number from -1000 to 1000, found 1001"},
          Case{"Control", "\x1b[2J 1", "line 1: expected a number, found \"\\u001b\""},
          Case{"Long", std::string(1000, 'x'),
               "line 1: expected a number, found \"xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx\""}}) {
        SCOPED_TRACE(row.name);
        const Result<TexCoords> parsed = parseCoordText(row.text);
        ASSERT_FALSE(parsed);
        EXPECT_EQ(parsed.error().message, row.message);
    }
}

} // namespace
} // namespace texplorer::ui::coord_text_test
