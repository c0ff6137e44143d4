#include "texplorer/suite/accept_list.h"

#include <gmock/gmock.h>

namespace texplorer::suite::accept_list_test {
namespace {

using testing::ElementsAre;

const std::vector<std::string> known{"a/fixed@1x1", "b/fixed@1x1", "#c/fixed@1x1", " d"};

TEST(AcceptList, HasANameOnALine) {
    const Result<std::vector<std::string>> names = parseAcceptList(
        "# of the report\n\nb/fixed@1x1\r\n  a/fixed@1x1  \nb/fixed@1x1\n#c/fixed@1x1\n d", known);
    ASSERT_TRUE(names) << describe(names.error());
    EXPECT_THAT(*names, ElementsAre("b/fixed@1x1", "a/fixed@1x1", "#c/fixed@1x1", " d"));
    EXPECT_EQ(describe(parseAcceptList("# nothing\n\n", known).error()),
              "expected the name of a case on each line, found none");
}

TEST(AcceptList, MayBeginWithAByteOrderMark) {
    EXPECT_THAT(*parseAcceptList("\xEF\xBB\xBF"
                                 "a/fixed@1x1\r\n",
                                 known),
                ElementsAre("a/fixed@1x1"));
}

TEST(AcceptList, WhatWouldSteerATerminalStandsAsThePageWritesIt) {
    const std::vector<std::string> odd{"a\x1b[31m\nb.png", "a.png"};
    EXPECT_THAT(*parseAcceptList("a\\u001b[31m\\u000ab.png\n", odd), ElementsAre(odd.front()));
}

TEST(AcceptList, NamesThatAreNoTextAreRefused) {
    EXPECT_THAT(describe(parseAcceptList("inv\xFF.png", {"inv\xFE.png"}).error()),
                testing::HasSubstr("isn't UTF-8"));
}

TEST(AcceptList, NamesThatThereAreNotAreSaid) {
    const Result<std::vector<std::string>> near = parseAcceptList("#\na/fixde@1x1", known);
    ASSERT_FALSE(near);
    EXPECT_EQ(describe(near.error()),
              "line 2: there is no case \"a/fixde@1x1\"; did you mean \"a/fixed@1x1\"?");
    const Result<std::vector<std::string>> far = parseAcceptList("../../etc/passwd", known);
    ASSERT_FALSE(far);
    EXPECT_EQ(describe(far.error()), "line 1: there is no case \"../../etc/passwd\"");
}

TEST(AcceptList, TooLargeIsRefused) {
    EXPECT_EQ(parseAcceptList(std::string(maxAcceptBytes + 1, '\n'), known).error().code,
              ErrorCode::TooLarge);
}

} // namespace
} // namespace texplorer::suite::accept_list_test
