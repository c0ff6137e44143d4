#include "app/screenshot/workers/message.h"

#include <gtest/gtest.h>

#include <array>
#include <sys/socket.h>
#include <unistd.h>

namespace texplorer::workers::message_test {
namespace {

class Messages : public testing::Test {
protected:
    void SetUp() override { ASSERT_EQ(::socketpair(AF_UNIX, SOCK_STREAM, 0, ends.data()), 0); }
    void TearDown() override {
        close(ends[0]);
        close(ends[1]);
    }
    void write(std::string_view bytes) const {
        ASSERT_EQ(::send(ends[0], bytes.data(), bytes.size(), 0), static_cast<ssize_t>(bytes.size()));
    }
    bool read() { return inbox.read(ends[1]); }

    std::array<int, 2> ends{};
    Inbox inbox;
};

TEST_F(Messages, AreTheirLengthALetterAndBytes) {
    EXPECT_EQ(bytesOf(Kind::Answer, "ok"), std::string("\3\0\0\0aok", 7));
    EXPECT_EQ(bytesOf(Kind::Begun, ""), std::string("\1\0\0\0b", 5));
    EXPECT_EQ(bytesOf(Kind::Job, std::string(0x1234, ' ')).substr(0, 5), std::string("\x35\x12\0\0j", 5));
}

TEST_F(Messages, ArriveWholeHoweverTheirBytesDo) {
    const std::string bytes = bytesOf(Kind::Job, std::string("with\0zero", 9)) + bytesOf(Kind::Begun, "");
    for (std::size_t i = 0; i < bytes.size(); ++i) {
        write(bytes.substr(i, 1));
        ASSERT_TRUE(read());
        const std::optional<Message> message = inbox.take();
        ASSERT_EQ(message.has_value(), i == 13 || i + 1 == bytes.size()) << i;
        if (i == 13) {
            EXPECT_EQ(message->kind, Kind::Job);
            EXPECT_EQ(message->text, std::string("with\0zero", 9));
        }
    }
    write(bytes + bytes);
    ASSERT_TRUE(read());
    for (int i = 0; i < 4; ++i)
        EXPECT_TRUE(inbox.take());
    EXPECT_FALSE(inbox.take());
}

TEST_F(Messages, WhatIsNoMessageIsToldAtOnce) {
    for (const std::string& bytes : {std::string("\0\0\0\0", 4), std::string("\xff\xff\xff\xff", 4),
                                     std::string("\1\0\0\0z", 5), std::string("\2\0\0\4a", 5)}) {
        inbox = {};
        write(bytes);
        ASSERT_TRUE(read());
        EXPECT_TRUE(inbox.isBroken());
        EXPECT_FALSE(inbox.take());
    }
}

TEST_F(Messages, SecondMessageThatIsNoneIsToldToo) {
    write(bytesOf(Kind::Answer, "fine") + std::string(8, '\xff'));
    ASSERT_TRUE(read());
    EXPECT_FALSE(inbox.isBroken());
    EXPECT_TRUE(inbox.take());
    EXPECT_TRUE(inbox.isBroken());
}

TEST_F(Messages, EndOfTheOtherSideIsTold) {
    write(std::string("\5\0\0", 3));
    ASSERT_TRUE(read());
    ASSERT_EQ(::shutdown(ends[0], SHUT_WR), 0);
    EXPECT_FALSE(read());
    EXPECT_FALSE(inbox.take());
    ASSERT_EQ(::shutdown(ends[1], SHUT_RDWR), 0);
    EXPECT_FALSE(send(ends[0], Kind::Job, "without a reader"));
}

} // namespace
} // namespace texplorer::workers::message_test
