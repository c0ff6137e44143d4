// The functions that programs have: what the files of assets/programs become.

#include "texplorer/emit/c_functions.h"
#include "texplorer/emit/piece_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace texplorer::pieces_test {
namespace {

using namespace emit;

constexpr int functionCount = static_cast<int>(CFunction::Buffers) + 1;

std::string textOf(CFunction function) {
    return emit::textOf(linesOf({function}), true);
}

TEST(Pieces, AreTheFilesOfTheFolder) {
    std::vector<std::string> expected;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(TEXPLORER_SOURCE_DIR) /
                                                                 "assets/programs")) {
        if (entry.path().extension() == ".c" || entry.path().extension() == ".h")
            expected.push_back(entry.path().filename().string());
    }
    std::vector<std::string> names;
    for (const PieceFile& each : cFunctionFiles())
        names.push_back(each.name);
    for (const PieceFile& each : keyFrameFiles())
        names.push_back(each.name);
    EXPECT_THAT(names, testing::UnorderedElementsAreArray(expected));
}

TEST(Pieces, AreWithoutWhatTheyInclude) {
    for (int i = 0; i < functionCount; ++i)
        EXPECT_THAT(textOf(static_cast<CFunction>(i)), testing::Not(testing::HasSubstr("#include"))) << i;
    EXPECT_TRUE(textOf(CFunction::Sphere).starts_with("/* Radius 1;")) << textOf(CFunction::Sphere);
    EXPECT_EQ(textOf(CFunction::Pi), "static const double pi = 3.14159265358979323846;\n");
}

TEST(Pieces, BringWhatTheyCallAndItsHeaders) {
    std::set<CFunction> functions;
    addWithCallees(functions, CFunction::Sphere);
    EXPECT_THAT(functions, testing::ElementsAre(CFunction::MeshTypes, CFunction::Pi, CFunction::Grid,
                                                CFunction::Ring, CFunction::Sphere));
    EXPECT_THAT(headersOf(functions), testing::ElementsAre("math.h", "stdio.h", "stdlib.h"));
    EXPECT_THAT(headersOf({CFunction::Unpack}), testing::ElementsAre("string.h"));
}

TEST(Pieces, CallOnlyThoseBeforeThem) {
    for (int i = 0; i < functionCount; ++i) {
        std::set<CFunction> functions;
        addWithCallees(functions, static_cast<CFunction>(i));
        EXPECT_EQ(*functions.rbegin(), static_cast<CFunction>(i));
    }
}

} // namespace
} // namespace texplorer::pieces_test
