#include "texplorer/files/read_stream.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

namespace texplorer::read_stream_test {
namespace {

/// A pipe that a thread writes to.
class Pipe {
public:
    explicit Pipe(std::string content, bool waits = true) {
        EXPECT_EQ(::pipe(ends_.data()), 0);
        if (!waits) {
            EXPECT_EQ(::fcntl(ends_[0], F_SETFL, O_NONBLOCK), 0);
        }
        writer_ = std::thread([this, content = std::move(content)] {
            for (std::size_t done = 0; done < content.size();) {
                const ssize_t put = ::write(ends_[1], content.data() + done, content.size() - done);
                if (put <= 0)
                    break;
                done += static_cast<std::size_t>(put);
            }
            ::close(ends_[1]);
        });
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    ~Pipe() {
        // Read the rest as well, so that the writer ends.
        std::array<char, 65536> rest{};
        ::fcntl(ends_[0], F_SETFL, 0);
        while (::read(ends_[0], rest.data(), rest.size()) > 0)
            ;
        writer_.join();
        ::close(ends_[0]);
    }
    [[nodiscard]] int end() const { return ends_[0]; }

private:
    std::array<int, 2> ends_{};
    std::thread writer_;
};

std::string asText(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string pattern(std::size_t count) {
    std::string text(count, '\0');
    for (std::size_t i = 0; i < count; ++i)
        text[i] = static_cast<char>(i * 31 % 251);
    return text;
}

TEST(ReadStream, GivesAllThatComes) {
    for (const std::size_t count : {0U, 1U, 65537U, 1U << 20, (1U << 20) + 1, 5000000U}) {
        const std::string content = pattern(count);
        const Pipe pipe(content);
        const auto read = readStream(pipe.end(), "in", 5000000);
        ASSERT_TRUE(read) << count;
        EXPECT_TRUE(asText(*read) == content) << count;
    }
}

TEST(ReadStream, WaitsForAPipeThatDoesNotWait) {
    const Pipe pipe(pattern(300000), false);
    const auto read = readStream(pipe.end(), "in", 300000);
    ASSERT_TRUE(read) << describe(read.error());
    EXPECT_EQ(read->size(), 300000U);
}

TEST(ReadStream, StopsAtItsLimit) {
    const Pipe pipe(pattern(300001));
    const auto read = readStream(pipe.end(), "in", 300000);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error(), (Error{ErrorCode::TooLarge, "at most 300000 bytes are read, but there are more",
                                   inFile("in")}));
}

TEST(ReadStream, WhatIsNotWorthReadingIsLeft) {
    int asked = 0;
    const auto refuse = [&](ByteView start) {
        ++asked;
        EXPECT_GE(start.size(), std::size_t{1} << 20);
        return false;
    };
    const Pipe pipe(pattern(3000000));
    const auto read = readStream(pipe.end(), "in", 3000000, refuse);
    ASSERT_TRUE(read);
    EXPECT_LT(read->size(), 3000000U);
    EXPECT_EQ(asked, 1);
    const Pipe shorter(pattern(1000));
    EXPECT_EQ(readStream(shorter.end(), "in", 3000000, refuse)->size(), 1000U);
    EXPECT_EQ(asked, 1) << "a short stream is not checked";
}

TEST(ReadStream, WhatCantBeReadIsSaid) {
    const auto read = readStream(-1, "in", 10);
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error(),
              (Error{ErrorCode::Unreadable, "can't be read: Bad file descriptor", inFile("in")}));
}

} // namespace
} // namespace texplorer::read_stream_test
