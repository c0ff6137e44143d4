// Random sequences of calls in core/reference/texture_calls and in OpenGL: names, bindings, parameters,
// environments and the colour that is drawn are the same after each.

#include "tests/support/render_fixture.h"
#include "texplorer/reference/texture_calls.h"

#include <GL/glew.h>

#include <array>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace texplorer::render::texture_names_test {
namespace {

using namespace objects;
using namespace test;

constexpr std::array colors{glm::vec3(1, 0.5F, 0.25F), glm::vec3(0.25F, 1, 0.5F), glm::vec3(0.5F, 0.25F, 1)};
const glm::vec4 fragment(0.4F, 0.6F, 1, 1);

template<class T, std::size_t N>
const T& oneOf(const std::array<T, N>& choices, std::mt19937& dice) {
    return choices.at(std::uniform_int_distribution<std::size_t>(0, N - 1)(dice));
}

/// The same calls to OpenGL, whose names are others: what glGenTextures gives is its own affair.
class Driver {
public:
    /// Of a name that is unknown, one that OpenGL never saw.
    [[nodiscard]] GLuint nameOf(Name name) const {
        const auto found = names_.find(name);
        return name == 0 ? 0 : found != names_.end() ? found->second : unseen;
    }

    void operator()(const GenTexture& /*call*/, const Answer& answer) {
        GLuint name = 0;
        glGenTextures(1, &name);
        EXPECT_NE(name, 0U);
        names_[*answer.name] = name;
    }
    void operator()(const BindTexture& call, const Answer& /*answer*/) {
        // Downwards: glGenTextures gives the least that is free, or what is above all.
        if (call.name != 0 && !names_.contains(call.name))
            names_[call.name] = ownName_--;
        glBindTexture(GL_TEXTURE_2D, nameOf(call.name));
    }
    void operator()(const DeleteTexture& call, const Answer& /*answer*/) {
        const GLuint name = nameOf(call.name);
        glDeleteTextures(1, &name);
        names_.erase(call.name); // glGenTextures may give it to another one
    }
    void operator()(const IsTexture& call, const Answer& answer) {
        EXPECT_EQ(glIsTexture(nameOf(call.name)) == GL_TRUE, answer.isTexture);
    }
    void operator()(const ActiveTexture& call, const Answer& /*answer*/) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(call.unit));
    }
    void operator()(const EnableTexture& call, const Answer& /*answer*/) {
        (call.on ? glEnable : glDisable)(GL_TEXTURE_2D);
    }
    void operator()(const SetEnvMode& call, const Answer& /*answer*/) {
        glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, static_cast<GLint>(call.mode));
    }
    void operator()(const SetParameter& call, const Answer& /*answer*/) {
        const std::map<std::string_view, GLenum> names{{"magFilter", GL_TEXTURE_MAG_FILTER},
                                                       {"minFilter", GL_TEXTURE_MIN_FILTER},
                                                       {"wrapS", GL_TEXTURE_WRAP_S},
                                                       {"wrapT", GL_TEXTURE_WRAP_T}};
        glTexParameteri(GL_TEXTURE_2D, names.at(call.row->key),
                        static_cast<GLint>(std::get<EnumValue>(call.value).number));
    }
    void operator()(const GiveImage& call, const Answer& /*answer*/) {
        const glm::vec3 color = colors.at(static_cast<std::size_t>(call.picture));
        const std::vector<glm::vec3> texels(16, color);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB, GL_FLOAT, texels.data());
    }

private:
    static constexpr GLuint unseen = 4'000'000;

    std::map<Name, GLuint> names_;
    GLuint ownName_ = 1'000'000;
};

Call randomCall(std::mt19937& dice) {
    const auto number = [&](int most) { return std::uniform_int_distribution(0, most)(dice); };
    const auto name = [&] { return static_cast<Name>(number(5)); };
    switch (number(11)) {
    case 0:
        return GenTexture{};
    case 1:
        return DeleteTexture{name()};
    case 2:
        return IsTexture{name()};
    case 3:
        return ActiveTexture{static_cast<std::size_t>(number(1))};
    case 4:
        return EnableTexture{number(3) > 0};
    case 5:
        return SetEnvMode{
            oneOf(std::array{EnvMode::Modulate, EnvMode::Replace, EnvMode::Decal, EnvMode::Add}, dice)};
    case 6:
        return setParameter(
            oneOf(std::array{MinFilter::Nearest, MinFilter::Linear, MinFilter::NearestMipmapLinear}, dice));
    case 7:
        return setParameter(oneOf(std::array{MagFilter::Nearest, MagFilter::Linear}, dice));
    case 8:
        return setWrapS(oneOf(std::array{Wrap::Repeat, Wrap::Clamp, Wrap::ClampToEdge}, dice));
    case 9:
        return GiveImage{number(2)};
    default:
        return BindTexture{name()};
    }
}

GLint parameterOf(GLenum name) {
    GLint value = -1;
    glGetTexParameteriv(GL_TEXTURE_2D, name, &value);
    return value;
}

void expectSame(const TextureNames& names, const Driver& driver) {
    GLint active = -1;
    glGetIntegerv(GL_ACTIVE_TEXTURE, &active);
    EXPECT_EQ(active, GL_TEXTURE0 + static_cast<GLint>(names.active));
    for (const auto& [name, object] : names.names)
        EXPECT_EQ(glIsTexture(driver.nameOf(name)) == GL_TRUE, name != 0 && object.has_value()) << name;
    for (std::size_t unit = 0; unit < unitCount; ++unit) {
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        GLint bound = -1;
        glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
        EXPECT_EQ(static_cast<GLuint>(bound), driver.nameOf(names.units.at(unit).bound));
        EXPECT_EQ(glIsEnabled(GL_TEXTURE_2D) == GL_TRUE, names.units.at(unit).enabled);
        GLint mode = -1;
        glGetTexEnviv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &mode);
        EXPECT_EQ(mode, static_cast<GLint>(names.units.at(unit).envMode));
        const Texture& state = names.objectOf(unit).state;
        EXPECT_EQ(parameterOf(GL_TEXTURE_MAG_FILTER), static_cast<GLint>(state.magFilter));
        EXPECT_EQ(parameterOf(GL_TEXTURE_MIN_FILTER), static_cast<GLint>(state.minFilter));
        EXPECT_EQ(parameterOf(GL_TEXTURE_WRAP_S), static_cast<GLint>(state.wrapS));
        EXPECT_EQ(parameterOf(GL_TEXTURE_WRAP_T), static_cast<GLint>(state.wrapT));
        GLint width = -1;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        EXPECT_EQ(width > 0, names.objectOf(unit).picture.has_value());
    }
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(names.active));
}

/// A pixel in the middle of a square over all of it.
glm::vec4 drawnColor() {
    glColor4f(fragment.r, fragment.g, fragment.b, fragment.a);
    glBegin(GL_QUADS);
    for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        for (std::size_t unit = 0; unit < unitCount; ++unit)
            glMultiTexCoord2f(GL_TEXTURE0 + static_cast<GLenum>(unit), 0.5F, 0.5F);
        glVertex2i(x, y);
    }
    glEnd();
    std::array<GLubyte, 4> bytes{};
    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return glm::vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0F;
}

glm::vec4 expectedColor(const TextureNames& names) {
    glm::vec4 color = fragment;
    for (std::size_t unit = 0; unit < unitCount; ++unit) {
        const std::optional<int> picture = names.objectOf(unit).picture;
        const glm::vec3 texel = picture ? colors.at(static_cast<std::size_t>(*picture)) : glm::vec3(0);
        color = colorAfter(names, unit, color, glm::vec4(texel, 1));
    }
    return color;
}

class TextureNamesInGl : public RenderTest, public testing::WithParamInterface<int> {};

TEST_P(TextureNamesInGl, AreWhatOpenGlHasAfterRandomCalls) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glUseProgram(0);
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    glDisable(GL_LIGHTING);
    glDisable(GL_DEPTH_TEST);
    glViewport(0, 0, 1, 1);
    std::mt19937 dice(static_cast<unsigned>(GetParam()));
    TextureNames names;
    Driver driver;
    std::string program;
    for (int i = 0; i < 120 && !HasFailure(); ++i) {
        const Call call = randomCall(dice);
        const Answer answer = apply(names, call);
        std::visit([&](const auto& each) { driver(each, answer); }, call);
        program += codeOf(call, answer) + "\n";
        expectSame(names, driver);
        EXPECT_TRUE(isColor(drawnColor(), expectedColor(names), 2)) << program;
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << program;
    }
    EXPECT_FALSE(HasFailure()) << program;
    glPopAttrib();
}

INSTANTIATE_TEST_SUITE_P(Seeds, TextureNamesInGl, testing::Range(1, 9));

} // namespace
} // namespace texplorer::render::texture_names_test
