// The vertices of a file against the same ones of a scene.

#include "tests/support/render_fixture.h"
#include "texplorer/files/file_io.h"
#include "texplorer/mesh/mesh_file.h"
#include "texplorer/reference/draw.h"

#include <fmt/core.h>

#include <cmath>
#include <memory>

namespace texplorer::mesh_file_test {
namespace {

/// A wave of more vertices than a scene can have of its own.
std::string waveText() {
    constexpr int count = 260;
    std::string text;
    for (int i = 0; i < count * count; ++i) {
        const int x = i % count;
        const int y = i / count;
        text += fmt::format("v {} {} {}\nvt {} {}\n", x, y, 20 * std::sin(static_cast<float>(x + y) / 30),
                            static_cast<float>(x) / 60, static_cast<float>(y) / 90);
    }
    for (int y = 0; y + 1 < count; ++y)
        for (int x = 0; x + 1 < count; ++x) {
            const int a = y * count + x + 1;
            text += fmt::format("f {0}/{0} {1}/{1} {2}/{2} {3}/{3}\n", a, a + 1, a + count + 1, a + count);
        }
    return text;
}

class MeshFiles : public test::RenderTest {};

TEST_F(MeshFiles, AreDrawnAsTheSameVerticesOfAScene) {
    images.put("wave.obj", std::make_shared<const MeshFile>(meshFileIn(viewBytes(waveText()), {}).value()));
    Scene own = defaultScene();
    own.models = {Model{.shape = Shape::Mesh}};
    own.models[0].rotation = {-50, 20, 0};
    Scene named = own;
    named.models[0].mesh.file = "wave.obj";
    const Image without = picture(named, 64);
    images.fillMeshes(named);
    own.models[0].mesh = named.models[0].mesh;
    own.models[0].mesh.file.clear();
    const Image drawn = picture(named, 64);
    EXPECT_NE(drawn, without) << "it has arrived";
    EXPECT_EQ(drawn, picture(own, 64));
    const auto reference = [&](const Scene& scene) {
        return reference::drawReference({scene, images, 0, 64, 64}).value().image;
    };
    EXPECT_EQ(reference(named), reference(own));
}

} // namespace
} // namespace texplorer::mesh_file_test
