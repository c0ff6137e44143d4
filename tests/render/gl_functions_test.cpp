#include "app/render/gl_functions.h"
#include "core/base/file_io.h"
#include "tests/support/render_fixture.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

namespace texplorer {
namespace {

using Names = std::set<std::string>;

std::string textOf(const std::filesystem::path& file) {
    const Result<Bytes> bytes = readFile(file);
    EXPECT_TRUE(bytes) << file;
    return bytes ? std::string(reinterpret_cast<const char*>(bytes->data()), bytes->size()) : std::string();
}

/// What `pattern` has in its parentheses, everywhere in a text.
Names found(const std::string& text, const std::regex& pattern) {
    Names names;
    for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
        names.insert((*at)[1]);
    return names;
}

/// GLEW's own header says which functions it has a pointer for.
Names pointersOfGlew() {
    return found(textOf(TEXPLORER_GLEW_HEADER), std::regex("#define (gl[A-Z]\\w*) GLEW_GET_FUN"));
}

/// The functions that the sources name, without comments and strings.
Names namedIn(const std::filesystem::path& folder) {
    const std::regex said(R"raw(//[^\n]*|"(?:\\.|[^"\\\n])*")raw");
    Names names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const auto extension = entry.path().extension();
        if ((extension != ".cpp" && extension != ".h") || entry.path().stem() == "gl_functions")
            continue;
        names.merge(
            found(std::regex_replace(textOf(entry.path()), said, " "), std::regex("\\b(gl[A-Z]\\w*)")));
    }
    return names;
}

TEST(GlFunctions, AreAllThatTheSourcesCallThroughGlew) {
    const Names pointers = pointersOfGlew();
    ASSERT_GT(pointers.size(), 1000U);
    Names called;
    for (const std::string& name : namedIn(TEXPLORER_APP_DIR)) {
        if (pointers.contains(name))
            called.insert(name);
    }
    Names listed;
    for (const render::GlFunction& each : render::glFunctions())
        EXPECT_TRUE(listed.insert(each.name).second) << each.name << " is listed twice";
    EXPECT_EQ(called, listed);
}

class LoadedGlFunctions : public testing_support::RenderTest {};

TEST_F(LoadedGlFunctions, AreThere) {
    for (const render::GlFunction& each : render::glFunctions())
        EXPECT_TRUE(each.isLoaded()) << each.name;
}

} // namespace
} // namespace texplorer
