#include "app/screenshot/output/json_text.h"
#include "app/screenshot/output/message_ids.h"
#include "app/screenshot/output/sent_error.h"

#include <gtest/gtest.h>

#include <limits>

namespace texplorer::screenshot::sent_error_test {
namespace {

Error sent(const Error& error) {
    return sentError(nlohmann::json::parse(sentJson(error).dump()));
}

TEST(SentErrors, AreTheSame) {
    const Sentence opened("can't be opened: {0}", "No such file");
    for (const Error& error :
         {Error{ErrorCode::NotFound, opened, inFile("a: b") / atPointer("/c") / atLine(2, 3)},
          Error{
              ErrorCode::Driver,
              Sentence("expected at most {0} bytes, found {1}", 3, std::numeric_limits<std::int64_t>::min()),
              {}},
          Error{ErrorCode::Cancelled,
                Sentence("can't be opened: {0}", Sentence::plural("{0} byte", "{0} bytes", 7)), "view"},
          Error{ErrorCode::TooLarge, "a text of a driver", {}}, Error{ErrorCode::Driver, {}, {}}}) {
        const Error there = sent(error);
        EXPECT_EQ(there, error);
        EXPECT_EQ(idOf(there.message), idOf(error.message));
        EXPECT_EQ(there.message.arguments(), error.message.arguments());
    }
    EXPECT_TRUE(idOf(sent({ErrorCode::NotFound, opened, {}}).message));
}

TEST(SentErrors, KeepWhichArgumentIsANumber) {
    const Error there = sent(
        {ErrorCode::TooLarge, Sentence("expected at most {0} bytes, found {1}", 3, ProperName{"4"}), {}});
    EXPECT_EQ(there.message.arguments()[0].number(), 3U);
    EXPECT_TRUE(there.message.arguments()[1].isName());
}

TEST(SentErrors, KeepNumbersWithTheirDigits) {
    for (const auto& [message, arguments] :
         {std::pair(Sentence("expected up to {0} pictures a second in a {1}, found {2:g}", 50, "GIF", 62.5),
                    R"([50,"GIF",62.5])"),
          std::pair(Sentence("alpha {0:.2f}", 0.5F), "[0.5]"),
          std::pair(Sentence("c0 = {0:04X} is larger than c1 = {1:04X}: four colours.", 255, 10), "[255,10]"),
          std::pair(Sentence("{0} bytes", std::numeric_limits<std::uint64_t>::max()),
                    "[18446744073709551615]")}) {
        const Sentence there = sent({ErrorCode::OutOfRange, message, {}}).message;
        EXPECT_EQ(there, message);
        EXPECT_EQ(messageJson(there)["arguments"], nlohmann::ordered_json::parse(arguments)) << message;
    }
}

TEST(SentErrors, OfAMessageWithoutAnIdKeepTheirWords) {
    EXPECT_EQ(sent({ErrorCode::Driver, Sentence("these {0} words have none", 5), {}}).message,
              "these 5 words have none");
}

TEST(SentErrors, AreNoOtherJson) {
    EXPECT_THROW(static_cast<void>(sentError(nlohmann::json::parse(R"({"code": "x"})"))),
                 nlohmann::json::exception);
    EXPECT_THROW(
        static_cast<void>(sentError(nlohmann::json::parse(R"({"code": 1, "message": [], "where": []})"))),
        nlohmann::json::exception);
    for (const char* text :
         {R"({"code": 9, "message": "", "where": []})", R"({"code": -1, "message": "", "where": []})",
          R"({"code": 1, "message": "", "where": [[6, "a", 0, 0]]})"})
        EXPECT_THROW(static_cast<void>(sentError(nlohmann::json::parse(text))), nlohmann::json::exception)
            << text;
}

} // namespace
} // namespace texplorer::screenshot::sent_error_test
