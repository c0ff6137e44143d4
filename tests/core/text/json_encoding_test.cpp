#include "texplorer/text/json_encoding.h"

#include <gtest/gtest.h>

#include <string>

namespace texplorer::json_encoding_test {
namespace {

using namespace std::string_literals;

std::string said(const std::string& json) {
    const Result<void> checked = checkEncoding(json);
    return checked ? "" : describe(checked.error()).english();
}

TEST(JsonEncoding, NamesAnotherOne) {
    for (const std::string& json : {"\xFF\xFE{\0}\0"s, "\xFE\xFF\0{\0}"s, "{\0}\0"s, "\0{\0}"s, "\xFF\xFE"s})
        EXPECT_EQ(said(json), "expected UTF-8, found UTF-16");
    for (const std::string& json :
         {"\xFF\xFE\0\0{\0\0\0"s, "\0\0\xFE\xFF\0\0\0{"s, "{\0\0\0}\0\0\0"s, "\0\0\0{"s})
        EXPECT_EQ(said(json), "expected UTF-8, found UTF-32");
}

TEST(JsonEncoding, SaysWhereANulIs) {
    EXPECT_EQ(said("{}\0"s), "line 1, column 3: expected JSON, found a NUL character");
    EXPECT_EQ(said("\0"s), "line 1, column 1: expected JSON, found a NUL character");
    EXPECT_EQ(said("\n\n\"\xC3\xA9\0\""s), "line 3, column 3: expected JSON, found a NUL character");
    EXPECT_EQ(said("\xEF\xBB\xBF{\0"s), "line 1, column 2: expected JSON, found a NUL character");
}

TEST(JsonEncoding, WritesAKeyAsAPointerHasIt) {
    EXPECT_EQ(pointerStep("a/b~c"), "a~1b~0c");
    EXPECT_EQ(pointerStep(""), "");
}

TEST(JsonEncoding, LeavesTheRestToTheReader) {
    for (const std::string& json : {""s, "{}"s, "\xEF\xBB\xBF{}"s, "[\xFF]"s, "x"s})
        EXPECT_EQ(said(json), "");
}

} // namespace
} // namespace texplorer::json_encoding_test
