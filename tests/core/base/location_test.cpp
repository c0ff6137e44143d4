#include "texplorer/base/result.h"

#include <gtest/gtest.h>

namespace texplorer::location_test {
namespace {

using Kind = Location::Kind;

TEST(Location, IsAWayFromTheOutside) {
    const Location place = inFile("a: b.png") / inFile("c.json") / atPointer("/textures/0") / atLine(2, 5);
    EXPECT_EQ(place, "a: b.png: c.json: /textures/0: line 2, column 5");
    ASSERT_EQ(place.steps().size(), 4U);
    EXPECT_EQ(place.steps()[0], (Location::Step{Kind::File, "a: b.png"}));
    EXPECT_EQ(place.steps()[3], (Location::Step{Kind::Line, "line 2, column 5", 2, 5}));
    EXPECT_TRUE(place.isOf(Kind::File));
    EXPECT_FALSE(place.isOf(Kind::Line));
    EXPECT_EQ(place.inside(), "c.json: /textures/0: line 2, column 5");
    EXPECT_TRUE(Location().inside().empty());
}

TEST(Location, JoinsPointersIntoOneDocument) {
    const Location place = inFile("a.json") / atPointer("/steps/0") / atPointer("/edits/1") / "view.azimuth";
    EXPECT_EQ(place, "a.json: /steps/0/edits/1: view.azimuth");
    EXPECT_EQ(place.steps().size(), 3U);
    EXPECT_EQ((atPointer("/scene") / inFile("b.json") / atPointer("/view")).steps().size(), 3U);
}

TEST(Location, MayBeEmpty) {
    EXPECT_TRUE(Location().empty());
    EXPECT_TRUE(Location("").empty());
    EXPECT_TRUE(atPointer("").empty());
    EXPECT_EQ(Location() / inFile("a") / Location(), inFile("a"));
    EXPECT_EQ(atLine(3), "line 3");
}

TEST(Location, IsOfAKindEvenIfItsTextIsTheSame) {
    EXPECT_FALSE(inFile("a") == atOption("a"));
    EXPECT_EQ(Location("a").steps().front().kind, Kind::Parameter);
}

TEST(Location, OfAnErrorIsWithinAnother) {
    const Error error = within(inFile("a.json"), {ErrorCode::Malformed, "wrong", atPointer("/view")});
    EXPECT_EQ(describe(error), "a.json: /view: wrong");
    EXPECT_EQ(error.code, ErrorCode::Malformed);
}

} // namespace
} // namespace texplorer::location_test
