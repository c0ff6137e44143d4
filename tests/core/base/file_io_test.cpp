#include "core/base/file_io.h"
#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

namespace texplorer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Without root's right to pass every permission, as long as it lives.
class Unprivileged {
public:
    Unprivileged() {
        if (user_ == 0) {
            EXPECT_EQ(::seteuid(65534), 0);
        }
    }
    Unprivileged(const Unprivileged&) = delete;
    Unprivileged& operator=(const Unprivileged&) = delete;
    ~Unprivileged() {
        if (user_ == 0) {
            EXPECT_EQ(::seteuid(0), 0);
        }
    }

private:
    uid_t user_ = ::geteuid();
};

class FileIo : public testing::Test {
protected:
    test::TempDir folder_;

    fs::path make(const char* name, const std::string& content) const {
        const fs::path path = folder_ / name;
        test::writeRaw(path, content);
        return path;
    }
    std::vector<std::string> names() const {
        std::vector<std::string> found;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            found.push_back(entry.path().filename());
        std::ranges::sort(found);
        return found;
    }
    static mode_t mode(const fs::path& path) {
        struct stat info = {};
        EXPECT_EQ(::stat(path.c_str(), &info), 0);
        return info.st_mode & 07777;
    }
};

std::string text(const Bytes& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void expectError(const auto& result, ErrorCode code, const fs::path& where, const char* message) {
    ASSERT_FALSE(result.has_value());
    EXPECT_EQ(result.error().code, code);
    EXPECT_EQ(result.error().where, where.string());
    EXPECT_THAT(result.error().message, HasSubstr(message));
}

TEST_F(FileIo, ReadsTheWholeFile) {
    std::string content = "a line\r\n";
    content += '\0';
    content += std::string(100000, 'x');
    const fs::path path = make("file", content);
    const Result<Bytes> bytes = readFile(path);
    ASSERT_TRUE(bytes);
    EXPECT_EQ(text(*bytes), content);
    EXPECT_EQ(readText(path), content);
}

TEST_F(FileIo, AnEmptyFileIsEmpty) {
    const Result<Bytes> bytes = readFile(make("empty", ""));
    ASSERT_TRUE(bytes);
    EXPECT_TRUE(bytes->empty());
}

TEST_F(FileIo, AFileThatSaysZeroBytesIsReadToItsEnd) {
    const Result<std::string> status = readText("/proc/self/status");
    ASSERT_TRUE(status);
    EXPECT_THAT(*status, HasSubstr("VmPeak"));
}

TEST_F(FileIo, TheLimitIsTheLargestSizeThatIsRead) {
    const fs::path path = make("ten", "0123456789");
    EXPECT_TRUE(readFile(path, 10));
    expectError(readFile(path, 9), ErrorCode::TooLarge, path,
                "at most 9 bytes are read, the file has at least 10");
    expectError(readText("/proc/self/status", 9), ErrorCode::TooLarge, "/proc/self/status",
                "at most 9 bytes are read, the file has");
}

TEST_F(FileIo, AHugeSparseFileIsRefusedWithoutReadingIt) {
    const fs::path path = make("huge", "");
    fs::resize_file(path, std::uintmax_t{1} << 40);
    expectError(readFile(path), ErrorCode::TooLarge, path,
                "at most 2147483648 bytes are read, the file has at least 1099511627776");
}

TEST_F(FileIo, WhatCantBeReadSaysWhy) {
    expectError(readFile(folder_ / "none"), ErrorCode::NotFound, folder_ / "none",
                "No such file or directory");
    expectError(readFile(""), ErrorCode::NotFound, "", "No such file or directory");
    expectError(readFile(folder_.path()), ErrorCode::Unreadable, folder_.path(), "is a directory");
    expectError(readFile("/dev/zero"), ErrorCode::Unreadable, "/dev/zero", "is a device");
    const fs::path below = make("file", "x") / "below";
    expectError(readFile(below), ErrorCode::NotFound, below, "Not a directory");
    const fs::path longName = folder_ / std::string(300, 'n');
    expectError(readFile(longName), ErrorCode::Unreadable, longName, "File name too long");
}

TEST_F(FileIo, APipeIsRefusedAtOnce) {
    const fs::path pipe = folder_ / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0666), 0);
    expectError(readFile(pipe), ErrorCode::Unreadable, pipe,
                "is a pipe"); // blocks for ever if it opens it to wait
    expectError(writeFileAtomically(pipe, viewBytes("x")), ErrorCode::Unwritable, pipe, "is a pipe");
    EXPECT_TRUE(fs::is_fifo(pipe));

    int ends[2] = {};
    ASSERT_EQ(::pipe(ends), 0);
    const fs::path open = "/proc/self/fd/" + std::to_string(ends[1]); // as /dev/stdout may be
    expectError(writeFileAtomically(open, viewBytes("x")), ErrorCode::Unwritable, open, "is a pipe");
    ::close(ends[0]);
    ::close(ends[1]);
}

TEST_F(FileIo, AFileThatOneMayNotReadSaysSo) {
    fs::permissions(folder_.path(), fs::perms::all);
    const fs::path path = make("secret", "x");
    fs::permissions(path, fs::perms::none);
    const Unprivileged user;
    expectError(readFile(path), ErrorCode::Unreadable, path, "Permission denied");
}

TEST_F(FileIo, WritesANewFileAndNothingBesideIt) {
    const fs::path path = folder_ / "new";
    const mode_t mask = ::umask(027);
    EXPECT_TRUE(writeFileAtomically(path, viewBytes("content")));
    ::umask(mask);
    EXPECT_EQ(test::readRawText(path), "content");
    EXPECT_EQ(mode(path), 0640U) << "as the umask wants it";
    EXPECT_THAT(names(), testing::ElementsAre("new"));
    EXPECT_TRUE(writeFileAtomically(path, {}));
    EXPECT_EQ(fs::file_size(path), 0U);
}

TEST_F(FileIo, ReplacingKeepsThePermissions) {
    const fs::path path = make("script", "old and longer than the new");
    fs::permissions(path, static_cast<fs::perms>(0751));
    EXPECT_TRUE(writeFileAtomically(path, viewBytes("new")));
    EXPECT_EQ(test::readRawText(path), "new");
    EXPECT_EQ(mode(path), 0751U);
}

TEST_F(FileIo, ARelativePathIsWrittenInTheCurrentDirectory) {
    const fs::path before = fs::current_path();
    fs::current_path(folder_.path());
    const Result<void> written = writeFileAtomically("plain", viewBytes("x"));
    fs::current_path(before);
    EXPECT_TRUE(written);
    EXPECT_EQ(test::readRawText(folder_ / "plain"), "x");
}

TEST_F(FileIo, TheLongestNameThatTheSystemAllowsCanBeWritten) {
    EXPECT_TRUE(writeFileAtomically(folder_ / std::string(255, 'n'), viewBytes("x")));
}

TEST_F(FileIo, LinksAreFollowed) {
    make("target", "old");
    fs::create_directory(folder_ / "sub");
    fs::create_symlink("../target", folder_ / "sub" / "link");
    fs::create_symlink("sub/link", folder_ / "link");
    EXPECT_TRUE(writeFileAtomically(folder_ / "link", viewBytes("new")));
    EXPECT_EQ(test::readRawText(folder_ / "target"), "new");
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_TRUE(fs::is_symlink(folder_ / "sub" / "link"));

    fs::create_symlink("later", folder_ / "dangling");
    EXPECT_TRUE(writeFileAtomically(folder_ / "dangling", viewBytes("here")));
    EXPECT_EQ(test::readRawText(folder_ / "later"), "here");
}

TEST_F(FileIo, ALoopOfLinksIsRefused) {
    fs::create_symlink("b", folder_ / "a");
    fs::create_symlink("a", folder_ / "b");
    expectError(writeFileAtomically(folder_ / "a", viewBytes("x")), ErrorCode::Unwritable, folder_ / "a",
                "Too many levels of symbolic links");
    expectError(readFile(folder_ / "a"), ErrorCode::Unreadable, folder_ / "a",
                "Too many levels of symbolic links");
}

TEST_F(FileIo, WhatCantBeWrittenSaysWhy) {
    expectError(writeFileAtomically(folder_.path(), viewBytes("x")), ErrorCode::Unwritable, folder_.path(),
                "is a directory");
    expectError(writeFileAtomically("/dev/null", viewBytes("x")), ErrorCode::Unwritable, "/dev/null",
                "is a device");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
    const fs::path lost = folder_ / "none" / "file";
    expectError(writeFileAtomically(lost, viewBytes("x")), ErrorCode::Unwritable, lost,
                "No such file or directory");
    const fs::path below = make("file", "x") / "below";
    expectError(writeFileAtomically(below, viewBytes("x")), ErrorCode::Unwritable, below, "Not a directory");
    expectError(writeFileAtomically("/proc/new", viewBytes("x")), ErrorCode::Unwritable, "/proc/new",
                "No such file or directory");
    EXPECT_THAT(names(), testing::ElementsAre("file"));
}

TEST_F(FileIo, AReadOnlyFileOrDirectoryIsLeftAlone) {
    const fs::path path = make("fixed", "old");
    fs::permissions(path, static_cast<fs::perms>(0444));
    fs::permissions(folder_.path(), fs::perms::all);
    {
        const Unprivileged user;
        expectError(writeFileAtomically(path, viewBytes("new")), ErrorCode::Unwritable, path,
                    "Permission denied");
    }
    fs::permissions(folder_.path(), static_cast<fs::perms>(0555));
    {
        const Unprivileged user;
        const fs::path fresh = folder_ / "fresh";
        expectError(writeFileAtomically(fresh, viewBytes("new")), ErrorCode::Unwritable, fresh,
                    "Permission denied");
    }
    fs::permissions(folder_.path(), fs::perms::all);
    EXPECT_EQ(test::readRawText(path), "old");
    EXPECT_THAT(names(), testing::ElementsAre("fixed"));
}

/// Files end at `bytes`, as if the disk were full, as long as it lives.
class SmallDisk {
public:
    explicit SmallDisk(rlim_t bytes) {
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
        EXPECT_EQ(::getrlimit(RLIMIT_FSIZE, &before_), 0);
        const rlimit small{bytes, before_.rlim_max};
        EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;
    ~SmallDisk() {
        EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &before_), 0);
        std::signal(SIGXFSZ, handler_);
    }

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST_F(FileIo, AnExistingFileSurvivesAFailedWrite) {
    const fs::path path = make("picture", "old");
    Result<void> written;
    {
        const SmallDisk disk(1000);
        written = writeFileAtomically(path, viewBytes(std::string(5000, 'x')));
    }
    expectError(written, ErrorCode::Unwritable, path, "File too large");
    EXPECT_EQ(test::readRawText(path), "old");
    EXPECT_THAT(names(), testing::ElementsAre("picture")) << "no partial file stays behind";
}

} // namespace
} // namespace texplorer
