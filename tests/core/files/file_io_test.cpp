#include "tests/support/raw_file.h"
#include "tests/support/temp_dir.h"
#include "texplorer/files/file_io.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/file.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace texplorer::file_io_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Drops root's privileges while it exists.
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

TEST(WriteFileIf, AsksRightBeforeItReplaces) {
    const test::TempDir folder;
    const std::filesystem::path file = folder / "a.txt";
    ASSERT_TRUE(writeFileAtomically(file, viewBytes("old")));
    const Result<bool> kept = writeFileIf(file, viewBytes("new"), [&] { return readText(file) == "new"; });
    ASSERT_TRUE(kept);
    EXPECT_FALSE(*kept);
    EXPECT_EQ(readText(file).value(), "old");
    const Result<bool> replaced =
        writeFileIf(file, viewBytes("new"), [&] { return readText(file) == "old"; });
    ASSERT_TRUE(replaced);
    EXPECT_TRUE(*replaced);
    EXPECT_EQ(readText(file).value(), "new");
    EXPECT_FALSE(writeFileIf(folder / "none" / "a.txt", viewBytes("new"), [] { return true; }));
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
                "is a pipe"); // would block for ever in open()
    expectError(writeFileAtomically(pipe, viewBytes("x")), ErrorCode::Unwritable, pipe, "is a pipe");
    EXPECT_TRUE(fs::is_fifo(pipe));

    int ends[2] = {};
    ASSERT_EQ(::pipe(ends), 0);
    const fs::path open = "/proc/self/fd/" + std::to_string(ends[1]); // like /dev/stdout
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

/// Files end at `bytes`, as on a full disk, while it exists.
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

/// A feature that a system may lack; a filter of the kernel removes it.
enum class Lacking { Nothing, NamelessFiles, NamesForThem };

std::string nameOf(Lacking what) {
    constexpr std::array names{"Nothing", "NamelessFiles", "NamesForThem"};
    return names[static_cast<std::size_t>(what)];
}

void takeAway(Lacking what) {
    if (what == Lacking::Nothing)
        return;
    constexpr unsigned number = offsetof(seccomp_data, nr);
    constexpr unsigned flags = offsetof(seccomp_data, args[2]); // of openat
    const bool files = what == Lacking::NamelessFiles;
    const unsigned call = files ? SYS_openat : SYS_linkat;
    const unsigned every = 0xFFFFFFFFU;
    sock_filter program[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, number),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, call, 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, flags),
        BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, files ? unsigned{O_TMPFILE & ~O_DIRECTORY} : every, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | unsigned{EOPNOTSUPP}),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog filter{std::size(program), program};
    ASSERT_EQ(::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0), 0);
    ASSERT_EQ(::prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter), 0);
}

class Writing : public FileIo, public testing::WithParamInterface<Lacking> {
protected:
    /// Runs in its own process without that feature. Returns its signal, or 0.
    template<class Work>
    int inChild(const Work& work) const {
        const pid_t child = ::fork();
        if (child == 0) {
            takeAway(GetParam());
            work();
            ::_exit(HasFailure() ? 1 : 0);
        }
        int status = 0;
        EXPECT_EQ(::waitpid(child, &status, 0), child);
        EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) == 0) << "what failed is said above";
        return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    }
    static void dieNow() { ::kill(::getpid(), SIGKILL); }
};

TEST_P(Writing, MakesAndReplacesFiles) {
    const fs::path old = make("old", "before");
    fs::permissions(old, static_cast<fs::perms>(0751));
    inChild([&] {
        EXPECT_TRUE(writeFileAtomically(folder_ / "new", viewBytes("fresh")));
        EXPECT_TRUE(writeFileAtomically(old, viewBytes("after")));
        EXPECT_TRUE(checkFileWritable(old));
        EXPECT_TRUE(checkFileWritable(folder_ / "later"));
        const std::vector<FileContent> all{
            {"a", viewBytes("1")}, {"b", viewBytes("2")}, {"c/d/e", viewBytes("3")}, {"c/f", viewBytes("4")}};
        EXPECT_TRUE(writeFolderAtomically(folder_ / "sub" / "report", all));
    });
    EXPECT_EQ(test::readRawText(folder_ / "new"), "fresh");
    EXPECT_EQ(test::readRawText(old), "after");
    EXPECT_EQ(mode(old), 0751U);
    EXPECT_EQ(test::readRawText(folder_ / "sub" / "report" / "b"), "2");
    EXPECT_EQ(test::readRawText(folder_ / "sub" / "report" / "c" / "d" / "e"), "3");
    EXPECT_EQ(test::readRawText(folder_ / "sub" / "report" / "c" / "f"), "4");
    EXPECT_THAT(names(), testing::ElementsAre("new", "old", "sub"));
}

TEST_P(Writing, WhatAKilledProgramLeftIsGoneAfterTheNextOne) {
    make("old", "before");
    const auto die = [&](const char* name) {
        return inChild(
            [&] { static_cast<void>(writeFileAtomically(folder_ / name, viewBytes("lost"), &dieNow)); });
    };
    EXPECT_EQ(die("old"), SIGKILL);
    EXPECT_EQ(die("new"), SIGKILL);
    const std::vector<FileContent> both{{"a", viewBytes("1")}, {"b", viewBytes("2")}};
    EXPECT_EQ(inChild([&] { static_cast<void>(writeFolderAtomically(folder_ / "report", both, &dieNow)); }),
              SIGKILL);
    if (GetParam() != Lacking::NamelessFiles) {
        EXPECT_THAT(names(), testing::ElementsAre("old")) << "nothing had a name yet";
    }
    EXPECT_TRUE(writeFileAtomically(folder_ / "next", viewBytes("x")));
    EXPECT_THAT(names(), testing::ElementsAre("next", "old"));
    EXPECT_EQ(test::readRawText(folder_ / "old"), "before");
}

TEST_P(Writing, WhatAnotherProgramIsWritingIsLeftAlone) {
    inChild([&] {
        EXPECT_TRUE(writeFileAtomically(folder_ / "slow", viewBytes("slow"), [&] {
            EXPECT_TRUE(writeFileAtomically(folder_ / "quick", viewBytes("quick")));
        }));
    });
    EXPECT_EQ(test::readRawText(folder_ / "slow"), "slow");
    EXPECT_EQ(test::readRawText(folder_ / "quick"), "quick");
    EXPECT_THAT(names(), testing::ElementsAre("quick", "slow"));
}

INSTANTIATE_TEST_SUITE_P(Without, Writing,
                         testing::Values(Lacking::Nothing, Lacking::NamelessFiles, Lacking::NamesForThem),
                         [](const auto& test) { return nameOf(test.param); });

TEST_F(FileIo, OnlyWhatIsSurelyADraftThatWasLeftIsRemoved) {
    make(".texplorer-4711-0.tmp", "left");
    const fs::path held = make(".texplorer-4711-1.tmp", "held");
    const int lock = ::open(held.c_str(), O_RDONLY);
    ASSERT_EQ(::flock(lock, LOCK_EX | LOCK_NB), 0);
    make("mine", "x");
    fs::create_symlink("mine", folder_ / ".texplorer-4711-2.tmp");
    fs::create_directory(folder_ / ".texplorer-4711-3.tmp");
    ASSERT_EQ(::mkfifo((folder_ / ".texplorer-4711-6.tmp").c_str(), 0666), 0);
    for (const char* name :
         {".texplorer-4711.tmp", ".texplorer-4711-.tmp", ".texplorer--1.tmp", ".texplorer-a-1.tmp",
          ".texplorer-4711-1.tmp~", ".texplorer-.tmp", ".texplorer-1-2-3.tmp"})
        make(name, "another file");
    const std::vector<std::string> before = names();
    const bool root = ::geteuid() == 0;
    if (root) {
        make(".texplorer-4711-5.tmp", "another user's");
        EXPECT_EQ(::chown((folder_ / ".texplorer-4711-5.tmp").c_str(), 65534, 65534), 0);
    }
    EXPECT_TRUE(writeFileAtomically(folder_ / "mine", viewBytes("y")));
    std::vector<std::string> expected = before;
    std::erase(expected, ".texplorer-4711-0.tmp");
    if (root)
        expected.emplace_back(".texplorer-4711-5.tmp");
    std::ranges::sort(expected);
    EXPECT_EQ(names(), expected);
    ::close(lock);
}

TEST_F(FileIo, AFolderIsWrittenAsAWholeOrNotAtAll) {
    const std::string large(5000, 'x');
    const std::vector<FileContent> files{{"a", viewBytes("1")}, {"b", viewBytes(large)}};
    fs::create_directory(folder_ / "there");
    test::writeRaw(folder_ / "there" / "a", "old");
    for (const char* name : {"there", "fresh", "deep/er"}) {
        const SmallDisk disk(1000);
        expectError(writeFolderAtomically(folder_ / name, files), ErrorCode::Unwritable, folder_ / name / "b",
                    "File too large");
    }
    EXPECT_THAT(names(), testing::ElementsAre("there"));
    EXPECT_EQ(test::readRawText(folder_ / "there" / "a"), "old");
    EXPECT_FALSE(fs::exists(folder_ / "there" / "b"));

    // This file cannot be replaced, which is noticed only when others have been.
    fs::create_directories(folder_ / "there" / "b");
    const std::vector<FileContent> blocked{{"new", viewBytes("1")}, {"b", viewBytes("2")}};
    expectError(writeFolderAtomically(folder_ / "there", blocked), ErrorCode::Unwritable,
                folder_ / "there" / "b", "Is a directory");
    EXPECT_FALSE(fs::exists(folder_ / "there" / "new"));
    const std::vector<FileContent> replacing{{"a", viewBytes("1")}, {"b", viewBytes("2")}};
    expectError(writeFolderAtomically(folder_ / "there", replacing), ErrorCode::Unwritable,
                folder_ / "there" / "b", "Is a directory");
    EXPECT_EQ(test::readRawText(folder_ / "there" / "a"), "old");
    const std::vector<FileContent> deeper{{"own/new", viewBytes("1")}, {"a/new", viewBytes("2")}};
    expectError(writeFolderAtomically(folder_ / "there", deeper), ErrorCode::Unwritable,
                folder_ / "there" / "a" / "new", "Not a directory");
    EXPECT_FALSE(fs::exists(folder_ / "there" / "own"));
    make("file", "x");
    expectError(writeFolderAtomically(folder_ / "file" / "below", files), ErrorCode::Unwritable,
                folder_ / "file" / "below", "file is not a folder");
    expectError(checkFolderWritable(folder_ / "file"), ErrorCode::Unwritable, folder_ / "file",
                "is not a folder");
    EXPECT_TRUE(checkFolderWritable(folder_ / "deep" / "er"));
}

TEST_F(FileIo, WhetherAFileCanBeWrittenIsKnownBefore) {
    const fs::path path = folder_ / "new";
    EXPECT_TRUE(checkFileWritable(path));
    EXPECT_THAT(names(), testing::IsEmpty());
    for (const fs::path& bad : {folder_ / "none" / "file", folder_.path(), fs::path("/dev/null"),
                                fs::path("/proc/new"), fs::path(""), folder_ / "new" / ""}) {
        const Result<void> known = checkFileWritable(bad);
        ASSERT_FALSE(known) << bad;
        EXPECT_EQ(known.error(), writeFileAtomically(bad, viewBytes("x")).error());
    }
}

TEST_F(FileIo, WithinADirectoryALinkIsReplacedAndNotFollowed) {
    make("precious", "old");
    fs::create_symlink("precious", folder_ / "link");
    const Descriptor directory(::open(folder_.path().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    EXPECT_TRUE(writeFileAtomically(directory, "link", viewBytes("new"), "link"));
    EXPECT_EQ(test::readRawText(folder_ / "precious"), "old");
    EXPECT_EQ(test::readRawText(folder_ / "link"), "new");
    EXPECT_FALSE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(mode(folder_ / "link"), 0600U);
}

} // namespace
} // namespace texplorer::file_io_test
