#include "app/render/gl_functions.h"
#include "tests/support/render_fixture.h"
#include "texplorer/files/file_io.h"
#include "texplorer/scene/params/params.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>

namespace texplorer::gl_functions_test {
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

/// Every name that GLEW's and GLU's headers give to a function or a number.
Names namesOfHeaders() {
    const std::string glew = textOf(TEXPLORER_GLEW_HEADER);
    Names names = pointersOfGlew();
    names.merge(found(glew, std::regex("#define (GL_\\w+) ")));
    names.merge(found(glew, std::regex("GLAPIENTRY (gl[A-Z]\\w*) \\(")));
    names.merge(found(textOf(TEXPLORER_GLU_HEADER), std::regex("GLAPIENTRY (glu[A-Z]\\w*) \\(")));
    return names;
}

TEST(GlCalls, NameWhatTheHeadersOfOpenGlHave) {
    const Names known = namesOfHeaders();
    ASSERT_GT(known.size(), 3000U);
    Names said;
    Scene scene;
    scene.models.resize(1);
    scene.textures.resize(1);
    scene.passes[0].units[0].matrix.resize(1);
    forEachParam(scene, [&](const std::string& path, const ParamRow& row, const Value& value) {
        for (const EnumRow& target : EnumTable<Target>::rows) {
            const std::string call = formatCall(row, value, static_cast<Target>(target.value));
            EXPECT_EQ(call.find("{target}"), std::string::npos) << path;
            for (const std::string& name : found(call, std::regex("\\b((?:glu?[A-Z]|GL_)\\w*)"))) {
                EXPECT_TRUE(known.contains(name)) << path << ": " << call;
                said.insert(name);
            }
        }
    });
    for (const char* name :
         {"glTexImage3D", "glTexGenfv", "gluPerspective", "GL_TEXTURE_LOD_BIAS", "GL_SRC2_ALPHA"})
        EXPECT_TRUE(said.contains(name)) << name;
}

class LoadedGlFunctions : public test::RenderTest {};

TEST_F(LoadedGlFunctions, AreThere) {
    for (const render::GlFunction& each : render::glFunctions())
        EXPECT_TRUE(each.isLoaded()) << each.name;
}

} // namespace
} // namespace texplorer::gl_functions_test
