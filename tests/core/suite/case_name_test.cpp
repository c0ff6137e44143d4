#include "texplorer/suite/case_name.h"

#include <gmock/gmock.h>

#include <set>

namespace texplorer::suite::case_name_test {
namespace {

using namespace std::string_literals;
using testing::EndsWith;
using testing::StartsWith;

TEST(CaseName, IsAFileThatCanBeRead) {
    EXPECT_EQ(fileNameFor("bricks/minFilter=GL_NEAREST/wrapS=GL_REPEAT/shader@512x512"),
              "bricks__minFilter=GL_NEAREST__wrapS=GL_REPEAT__shader@512x512");
    EXPECT_EQ(fileNameFor("fog/color=1,0,0,1/fixed@64x64@0.5s"), "fog__color=1,0,0,1__fixed@64x64@0.5s");
}

/// Every name gives a file in the folder, with a name that any file system accepts.
TEST(CaseName, OfHostileNamesIsASafeFile) {
    const std::array names{"../../etc/passwd"s,
                           "/etc/passwd"s,
                           "<script>alert(1)</script>"s,
                           "a\0b"s,
                           "a\nb"s,
                           std::string(4096, 'x'),
                           "Ziegel/größe=1"s,
                           "砖"s,
                           ""s,
                           "."s,
                           ".."s,
                           ".hidden"s,
                           "-rf"s,
                           "a b"s,
                           "a\\b"s,
                           "C:\\x"s,
                           "a//b"s,
                           "/"s,
                           "\xFF\xFE"s};
    std::set<std::string> files;
    for (const std::string& name : names) {
        const std::string file = fileNameFor(name);
        EXPECT_TRUE(files.insert(file).second) << file;
        EXPECT_LE(file.size(), maxFileNameBytes);
        EXPECT_EQ(
            file.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=.,+@"),
            std::string::npos)
            << file;
        EXPECT_FALSE(file.starts_with('.') || file.starts_with('-') || file.empty()) << file;
    }
}

/// Names that would give the same file if "/" were simply replaced by "__", or if a name could look like the
/// hash of another.
TEST(CaseName, OfTwoNamesAreTwoFiles) {
    const std::string hashed = fileNameFor("a b");
    EXPECT_THAT(hashed, StartsWith("a_b-"));
    const std::array names{"a/b"s,  "a__b"s,  "a_/b"s, "a/_b"s, "a_b"s, "a b"s, hashed,
                           "a//b"s, "a___b"s, "a/b/"s, "/a/b"s, "a_"s,  "_a"s};
    std::set<std::string> files;
    for (const std::string& name : names)
        EXPECT_TRUE(files.insert(fileNameFor(name)).second) << name << " is " << fileNameFor(name);
}

TEST(CaseName, OfALongNameKeepsItsBeginning) {
    const std::string name = "bricks/" + std::string(300, 'q');
    EXPECT_THAT(fileNameFor(name), StartsWith("bricks_qqq"));
    EXPECT_NE(fileNameFor(name), fileNameFor(name + "q"));
}

TEST(CaseName, DriversAreShortAndSafe) {
    EXPECT_EQ(driverSlug("llvmpipe (LLVM 15.0.6, 256 bits)"), "llvmpipe");
    EXPECT_EQ(driverSlug("NVIDIA GeForce RTX 3080/PCIe/SSE2"), "NVIDIA_GeForce_RTX_3080");
    EXPECT_EQ(driverSlug("Mesa Intel(R) UHD Graphics 620 (KBL GT2)"), "Mesa_Intel_R_UHD_Graphics_620");
    EXPECT_EQ(driverSlug(""), "reference");
    EXPECT_EQ(driverSlug("../x"), driverSlug("../x"));
    EXPECT_THAT(driverSlug("../x"), StartsWith("driver-"));
}

struct Fit {
    std::string glob;
    std::string text;
    bool fits;
};

TEST(Glob, FitsAsInAShell) {
    const std::array fits{
        Fit{"*", "", true},
        Fit{"*", "anything/at all", true},
        Fit{"a?c", "abc", true},
        Fit{"a?c", "ac", false},
        Fit{"*GL_NEAREST*", "x/minFilter=GL_NEAREST/y", true},
        Fit{"[ab]x", "bx", true},
        Fit{"[!ab]x", "bx", false},
        Fit{"[!ab]x", "cx", true},
        Fit{"[a-c]", "b", true},
        Fit{"[a-c]", "d", false},
        Fit{"[]]", "]", true},
        Fit{"[", "[", true},
        Fit{"[ab", "[ab", true},
        Fit{"\\*", "*", true},
        Fit{"\\*", "x", false},
        Fit{"a*b*c", "aXbYbZc", true},
        Fit{"a*b*c", "aXbYbZ", false},
        Fit{"", "", true},
        Fit{"", "x", false},
        Fit{"llvmpipe*", "llvmpipe (LLVM)", true},
        Fit{"abc", "abcd", false},
        Fit{"\\", "\\", true},
    };
    for (const Fit& each : fits)
        EXPECT_EQ(fitsGlob(each.glob, each.text), each.fits) << each.glob << " and " << each.text;
}

/// A pattern with which a matcher that retries every star would run for ever.
TEST(Glob, WithManyStarsEnds) {
    std::string glob;
    for (int i = 0; i < 1000; ++i)
        glob += "a*";
    EXPECT_FALSE(fitsGlob(glob + "b", std::string(4000, 'a')));
}

TEST(Glob, OnlyFitsGroupsOfCasesToo) {
    EXPECT_TRUE(isWanted("bricks", "bricks/wrapS=GL_REPEAT/fixed@1x1"));
    EXPECT_TRUE(isWanted("bricks/*", "bricks/fixed@1x1"));
    EXPECT_TRUE(isWanted("*/fixed@1x1", "bricks/fixed@1x1"));
    EXPECT_FALSE(isWanted("brick", "bricks/fixed@1x1"));
    EXPECT_FALSE(isWanted("fixed@1x1", "bricks/fixed@1x1"));
}

} // namespace
} // namespace texplorer::suite::case_name_test
