// What a Scene is before anybody changes it: the initial values of the OpenGL 2.1 state tables.

#include "texplorer/scene/params/params.h"

#include <gtest/gtest.h>

namespace texplorer::scene_test {
namespace {

struct InitialValue {
    const char* name;
    const char* path;
    const char* value;
};

class InitialValues : public testing::TestWithParam<InitialValue> {};

TEST_P(InitialValues, AreThoseOfTheSpecification) {
    Scene scene;
    scene.textures.resize(1);
    EXPECT_EQ(getParam(scene, GetParam().path).value_or("no such path"), GetParam().value);
}

// The numbers are written as the specification prints them: tables 6.6 to 6.20, table 3.18 (texture
// parameters), table 2.10 (lighting), EXT_texture_filter_anisotropic for the last one.
INSTANTIATE_TEST_SUITE_P(
    OpenGL21, InitialValues,
    testing::Values(InitialValue{"MagFilter", "textures[0].magFilter", "GL_LINEAR"},
                    InitialValue{"MinFilter", "textures[0].minFilter", "GL_NEAREST_MIPMAP_LINEAR"},
                    InitialValue{"WrapS", "textures[0].wrapS", "GL_REPEAT"},
                    InitialValue{"WrapT", "textures[0].wrapT", "GL_REPEAT"},
                    InitialValue{"WrapR", "textures[0].wrapR", "GL_REPEAT"},
                    InitialValue{"BorderColor", "textures[0].borderColor", "0,0,0,0"},
                    InitialValue{"BaseLevel", "textures[0].baseLevel", "0"},
                    InitialValue{"MaxLevel", "textures[0].maxLevel", "1000"},
                    InitialValue{"MinLod", "textures[0].minLod", "-1000"},
                    InitialValue{"MaxLod", "textures[0].maxLod", "1000"},
                    InitialValue{"LodBiasOfTheTexture", "textures[0].lodBias", "0"},
                    InitialValue{"Priority", "textures[0].priority", "1"},
                    InitialValue{"UnitEnabled", "passes[0].units[0].enabled", "false"},
                    InitialValue{"EnvMode", "passes[0].units[0].envMode", "GL_MODULATE"},
                    InitialValue{"EnvColor", "passes[0].units[0].envColor", "0,0,0,0"},
                    InitialValue{"LodBias", "passes[0].units[3].lodBias", "0"},
                    InitialValue{"Lighting", "passes[0].lighting", "false"},
                    InitialValue{"DepthTest", "passes[0].depthTest", "false"},
                    InitialValue{"DepthFunc", "passes[0].depthFunc", "GL_LESS"},
                    InitialValue{"AlphaTest", "passes[0].alphaTest", "false"},
                    InitialValue{"AlphaFunc", "passes[0].alphaFunc", "GL_ALWAYS"},
                    InitialValue{"AlphaRef", "passes[0].alphaRef", "0"},
                    InitialValue{"Blend", "passes[0].blend", "false"},
                    InitialValue{"BlendSrc", "passes[0].blendSrc", "GL_ONE"},
                    InitialValue{"BlendDst", "passes[0].blendDst", "GL_ZERO"},
                    InitialValue{"LightPosition", "light.position", "0,0,1,0"},
                    InitialValue{"LightAmbient", "light.ambient", "0,0,0,1"},
                    InitialValue{"Light0Diffuse", "light.diffuse", "1,1,1,1"},
                    InitialValue{"Light0Specular", "light.specular", "1,1,1,1"},
                    InitialValue{"ModelAmbient", "light.modelAmbient", "0.2,0.2,0.2,1"},
                    InitialValue{"ColorControl", "light.colorControl", "GL_SINGLE_COLOR"},
                    InitialValue{"LocalViewer", "light.localViewer", "false"},
                    InitialValue{"CurrentColor", "material.color", "1,1,1,1"},
                    InitialValue{"MaterialSpecular", "material.specular", "0,0,0,1"},
                    InitialValue{"Shininess", "material.shininess", "0"},
                    InitialValue{"ShadeModel", "material.shadeModel", "GL_SMOOTH"},
                    InitialValue{"ClearColor", "view.background", "0,0,0,0"},
                    InitialValue{"MaxAnisotropy", "textures[0].maxAnisotropy", "1"}),
    [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::scene_test
