#include "texplorer/scene/params/params.h"

#include <gtest/gtest.h>

#include <array>

namespace texplorer::gl_call_test {
namespace {

struct Call {
    const char* name;
    const StructTable& (*table)();
    const char* key;
    const char* value;
    const char* call;
    Target target = Target::Texture2D;
};

class Calls : public testing::TestWithParam<Call> {};

TEST_P(Calls, HaveTheValueInItsPlace) {
    const ParamRow& row = *findParam(GetParam().table(), GetParam().key);
    EXPECT_EQ(formatCall(row, parseValue(row, GetParam().value).value(), GetParam().target), GetParam().call);
}

INSTANTIATE_TEST_SUITE_P(
    Gl, Calls,
    testing::Values(
        Call{"Enum", textureTable, "wrapS", "GL_CLAMP",
             "glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP)"},
        Call{"Line", textureTable, "wrapS", "GL_REPEAT",
             "glTexParameteri(GL_TEXTURE_1D, GL_TEXTURE_WRAP_S, GL_REPEAT)", Target::Texture1D},
        Call{"Volume", textureTable, "borderColor", "0,1,0,1",
             "glTexParameterfv(GL_TEXTURE_3D, GL_TEXTURE_BORDER_COLOR, {0, 1, 0, 1})", Target::Texture3D},
        Call{"Cube", textureTable, "lodBias", "0.25",
             "glTexParameterf(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_LOD_BIAS, 0.25)", Target::CubeMap},
        Call{"ImageOfALine", textureTable, "internalFormat", "GL_RGB",
             "glTexImage1D(GL_TEXTURE_1D, level, GL_RGB, width, border, format, "
             "GL_UNSIGNED_BYTE, pixels)",
             Target::Texture1D},
        Call{"ImageOfACube", textureTable, "border", "1",
             "glTexImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, level, internalFormat, width, "
             "height, 1, format, GL_UNSIGNED_BYTE, pixels)",
             Target::CubeMap},
        Call{"ImageOfAVolume", textureTable, "border", "0",
             "glTexImage3D(GL_TEXTURE_3D, level, internalFormat, width, height, depth, 0, format, "
             "GL_UNSIGNED_BYTE, pixels)",
             Target::Texture3D},
        Call{"Negated", viewTable, "target", "1,-2,0", "glTranslatef(-1, 2, 0)"},
        Call{"NegatedNumber", viewTable, "distance", "0.5", "glTranslatef(0, 0, -0.5)"},
        Call{"Float", textureTable, "minLod", "-0.5",
             "glTexParameterf(GL_TEXTURE_2D, GL_TEXTURE_MIN_LOD, -0.5)"},
        Call{"Pointer", unitTable, "envColor", "1,0,0.5,1",
             "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {1, 0, 0.5, 1})"},
        Call{"Combine", combineTable, "rgbScale", "4", "glTexEnvf(GL_TEXTURE_ENV, GL_RGB_SCALE, 4)"},
        Call{"TexGen", []() -> const StructTable& { return texGenTable(2); }, "objectPlane", "1,0,0,0.5",
             "glTexGenfv(GL_R, GL_OBJECT_PLANE, {1, 0, 0, 0.5})"},
        Call{"Arguments", viewTable, "background", "0,0,0,1", "glClearColor(0, 0, 0, 1)"},
        Call{"Repeated", modelTable, "size", "2", "glScalef(2, 2, 2)"},
        Call{"Enable", passTable, "blend", "true", "glEnable(GL_BLEND)"},
        Call{"Disable", passTable, "blend", "false", "glDisable(GL_BLEND)"},
        Call{"Bool", lightTable, "localViewer", "true",
             "glLightModeli(GL_LIGHT_MODEL_LOCAL_VIEWER, GL_TRUE)"},
        Call{"None", modelTable, "shape", "cube", ""}),
    [](const auto& test) { return std::string(test.param.name); });

struct Name {
    const StructTable& (*table)();
    const char* key;
    const char* name;
};

TEST(GlNames, AreThoseOfTheParameters) {
    constexpr std::array names{
        Name{textureTable, "wrapS", "GL_TEXTURE_WRAP_S"},
        Name{textureTable, "maxAnisotropy", "GL_TEXTURE_MAX_ANISOTROPY_EXT"},
        Name{textureTable, "internalFormat", ""}, // an argument of glTexImage
        Name{textureTable, "pattern", ""},
        Name{unitTable, "envColor", "GL_TEXTURE_ENV_COLOR"},
        Name{unitTable, "enabled", ""}, // the target's
        Name{passTable, "lighting", "GL_LIGHTING"},
        Name{passTable, "depthFunc", "glDepthFunc"},
        Name{passTable, "alphaRef", ""}, // one of two numbers
        Name{lightTable, "position", "GL_POSITION"},
        Name{materialTable, "color", "glColor4f"},
        Name{viewTable, "azimuth", ""},
    };
    for (const Name& each : names)
        EXPECT_EQ(glNameOf(*findParam(each.table(), each.key)), each.name) << each.key;
}

} // namespace
} // namespace texplorer::gl_call_test
