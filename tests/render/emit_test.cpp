// What core/emit writes, compiled by the C compiler and run, against what the fixed renderer draws.

#include "app/render/render_target.h"
#include "core/base/file_io.h"
#include "core/emit/emit.h"
#include "core/image/patterns/pattern.h"
#include "core/scene/drawn_models.h"
#include "core/scene/model_mesh.h"
#include "core/scene/params/json.h"
#include "core/scene/tex_coords.h"
#include "core/texture/target_image.h"
#include "tests/support/render_fixture.h"
#include "tests/support/temp_dir.h"

#include <fmt/core.h>
#include <gmock/gmock.h>

#include <array>
#include <cstdlib>
#include <dlfcn.h>
#include <fstream>

namespace texplorer::emit_test {
namespace {

using namespace test;

constexpr view::Size extent{320, 240};
constexpr int tolerance = 2; // 255ths

/// The arrays that a text declares as extern: bytes in files that the assembler includes.
class ExternArrays {
public:
    explicit ExternArrays(const TempDir& folder)
        : folder_(folder) {}

    template<class T>
    void array(const std::string& name, const std::vector<T>& elements) {
        const std::filesystem::path file = folder_ / name;
        std::ofstream(file, std::ios::binary)
            .write(reinterpret_cast<const char*>(elements.data()),
                   static_cast<std::streamsize>(elements.size() * sizeof(T)));
        text_ += fmt::format(
            "__asm__(\".pushsection .rodata\\n.balign 16\\n.globl {0}\\n{0}: .incbin \\\"{1}\\\"\\n"
            ".popsection\");\n",
            name, file.string());
    }
    void size(const std::string& name, std::size_t value) {
        text_ += fmt::format("const GLsizei {} = {};\n", name, value);
    }
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    const TempDir& folder_;
    std::string text_;
};

void addTexture(ExternArrays& arrays, const Scene& scene, std::size_t index) {
    Target target = Target::Texture2D;
    for (const Pass& pass : scene.passes)
        for (const Unit& unit : pass.units)
            if (unit.enabled && unit.texture == static_cast<int>(index))
                target = unit.target;
    const Image image = imageForTarget(drawPattern(scene.textures[index].pattern), target);
    const std::string name = fmt::format("texture{}", index);
    arrays.size(name + "Width", static_cast<std::size_t>(image.width));
    arrays.size(name + "Height", static_cast<std::size_t>(image.height));
    arrays.size(name + "Depth", static_cast<std::size_t>(image.depth));
    arrays.array(name + "Texels", std::vector<std::byte>(image.pixels.begin(), image.pixels.end()));
}

void addModel(ExternArrays& arrays, const Scene& scene, std::size_t index) {
    const Mesh mesh = meshOf(scene.models[index]);
    const std::string name = fmt::format("model{}", index);
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    for (const Vertex& vertex : mesh.vertices) {
        positions.push_back(vertex.position);
        normals.push_back(vertex.normal);
    }
    arrays.array(name + "Positions", positions);
    arrays.array(name + "Normals", normals);
    for (int unit = 0; unit < maxUnits; ++unit)
        arrays.array(fmt::format("{}TexCoords{}", name, unit),
                     effectiveTexCoords(scene.models[index], mesh, unit));
    arrays.array(name + "Indices", mesh.triangles);
    arrays.size(name + "IndexCount", mesh.triangles.size());
}

/// A shared library with the calls of a scene, loaded.
class Program {
public:
    Program(const Scene& scene, bool all) {
        ExternArrays arrays(folder_);
        for (std::size_t i = 0; i < scene.textures.size(); ++i)
            addTexture(arrays, scene, i);
        const std::string calls = textOf(emit::callsOf(scene), all);
        for (std::size_t i = 0; i < scene.models.size(); ++i) {
            if (calls.find(fmt::format("extern const GLfloat model{}Positions", i)) != std::string::npos)
                addModel(arrays, scene, i);
        }
        const std::filesystem::path source = folder_ / "calls.c";
        const std::filesystem::path library = folder_ / "calls.so";
        std::ofstream(source) << emit::includes() << arrays.text() << "void draw(void);\nvoid draw(void) {\n"
                              << calls << "}\n";
        const std::string command =
            fmt::format(TEXPLORER_C_COMPILER " -std=c99 -Wall -Werror -shared -fPIC '{}' -o '{}'",
                        source.string(), library.string());
        if (std::system(command.c_str()) == 0)
            library_ = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (library_)
            draw_ = reinterpret_cast<void (*)()>(::dlsym(library_, "draw"));
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    ~Program() {
        if (library_)
            ::dlclose(library_);
    }

    [[nodiscard]] bool draw() const {
        if (draw_)
            draw_();
        return draw_ != nullptr;
    }

private:
    TempDir folder_;
    void* library_ = nullptr;
    void (*draw_)() = nullptr;
};

Image run(const Program& program) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glPushClientAttrib(GL_CLIENT_ALL_ATTRIB_BITS);
    Image found = Image::uninitialised(PixelFormat::Rgba8, extent.width, extent.height);
    {
        render::RenderTarget target;
        EXPECT_TRUE(target.bind(extent));
        glViewport(0, 0, extent.width, extent.height);
        EXPECT_TRUE(program.draw()) << ::dlerror();
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
        glReadPixels(0, 0, extent.width, extent.height, GL_RGBA, GL_UNSIGNED_BYTE, found.pixels.data());
    }
    glPopClientAttrib();
    glPopAttrib();
    for (const int mode : {GL_PROJECTION, GL_TEXTURE, GL_MODELVIEW}) {
        glMatrixMode(static_cast<GLenum>(mode));
        glLoadIdentity();
    }
    return found;
}

/// How many pixels differ, alpha aside.
int differing(const Image& found, const Image& expected) {
    int count = 0;
    for (int y = 0; y < found.height; ++y) {
        for (int x = 0; x < found.width; ++x) {
            bool differs = false;
            for (std::size_t i = 0; i < 3; ++i)
                differs |= std::abs(std::to_integer<int>(found.at(x, y)[i]) -
                                    std::to_integer<int>(expected.at(x, y)[i])) > tolerance;
            count += differs ? 1 : 0;
        }
    }
    return count;
}

struct Case {
    const char* name;
    const char* scene; ///< of the examples; empty: the default
    void (*adjust)(Scene& scene) = nullptr;
    int mayDiffer =
        extent.width * extent.height / 100; ///< pixels: the driver's mip levels have other last bits
};

const std::array cases{
    Case{"Default", ""},
    Case{"Checker", "checker"},
    Case{"Contours", "contours"},
    Case{"Cube", "cube"},
    Case{"Earth", "earth"},
    Case{"Environment", "environment"},
    Case{"Fog", "fog"},
    Case{"InternalFormats", "internal-formats"},
    Case{"Line", "line"},
    Case{"Marble", "marble"},
    // Between glBegin and glEnd Mesa divides quadrilaterals the other way: a light nearby isn't linear on
    // them.
    Case{"NeheNoBumps", "nehe-no-bumps", nullptr, extent.width* extent.height / 40},
    Case{"Quadrics", "quadrics"},
    Case{"SlideProjector", "slide-projector"},
    Case{"Teapot", "teapot"},
    Case{"Texbind", "texbind"},
    Case{"TwoUnits", "",
         [](Scene& scene) {
             Unit& second = scene.passes[0].units[1];
             second.enabled = true;
             second.envMode = EnvMode::Combine;
             second.combine.rgb = CombineRgb::Interpolate;
             second.combine.source2Rgb = CombineSource::Constant;
             second.envColor = {0.2F, 0.5F, 0.8F, 0.3F};
             second.matrix = {{.op = MatrixOp::Scale, .amount = {3, 2, 1}, .pivot = {0.5F, 0.5F, 0}},
                              {.op = MatrixOp::Rotate, .amount = {0, 0, 1}, .angle = 20}};
         }},
    Case{"Materials", "",
         [](Scene& scene) {
             scene.models[0].ownMaterial = true;
             scene.models[0].material.colorMaterial = false;
             scene.models[0].material.diffuse = {0.9F, 0.3F, 0.2F, 1};
             scene.material.color = {0.5F, 1, 0.5F, 1};
             scene.light.colorControl = ColorControl::SeparateSpecular;
             scene.passes.push_back(scene.passes[0]);
             scene.passes[1].models = {1};
             scene.passes[1].depthFunc = CompareFunc::LessEqual;
             scene.passes[1].blend = true;
             scene.passes[1].blendDst = BlendFactor::One;
             scene.passes[1].units[0].enabled = false;
         }},
};

Result<Scene> sceneOf(const Case& which) {
    Result<Scene> scene = defaultScene();
    if (*which.scene != 0) {
        const Result<std::string> text =
            readText(std::filesystem::path(TEXPLORER_SCENES) / fmt::format("{}.json", which.scene));
        scene = text ? parseScene(*text) : fail(text.error());
    }
    if (scene && which.adjust)
        which.adjust(*scene);
    return scene;
}

class EmittedPrograms : public RenderTest, public testing::WithParamInterface<Case> {};

TEST_P(EmittedPrograms, DrawTheirScenes) {
    const Result<Scene> scene = sceneOf(GetParam());
    ASSERT_TRUE(scene) << describe(scene.error());
    const Result<view::Frame> frame = renderer->draw(*scene, images, 0, extent);
    ASSERT_TRUE(frame) << describe(frame.error());
    const Result<Image> expected = renderer->read();
    ASSERT_TRUE(expected);
    const Image needed = run(Program(*scene, false));
    EXPECT_LE(differing(needed, *expected), GetParam().mayDiffer);
}

// What the list leaves out is what OpenGL has anyway.
TEST_P(EmittedPrograms, DrawTheSameWithAllCalls) {
    const Result<Scene> scene = sceneOf(GetParam());
    ASSERT_TRUE(scene) << describe(scene.error());
    const Image all = run(Program(*scene, true));
    TearDown(); // another context, with OpenGL's initial state
    SetUp();
    EXPECT_EQ(differing(run(Program(*scene, false)), all), 0);
}

INSTANTIATE_TEST_SUITE_P(All, EmittedPrograms, testing::ValuesIn(cases),
                         [](const auto& test) { return std::string(test.param.name); });

} // namespace
} // namespace texplorer::emit_test
