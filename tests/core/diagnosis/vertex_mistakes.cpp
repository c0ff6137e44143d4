#include "tests/core/diagnosis/mistakes.h"

#include <numeric>

namespace texplorer::test {
namespace {

using enum Severity;

/// A triangle with its own vertices that faces the viewer.
MeshData& triangle(Subject& s) {
    Model& model = s.scene.models[0];
    model = Model{.shape = Shape::Mesh, .attachment = Attachment::Eye};
    model.mesh.positions = {{0, 0, -3}, {1, 0, -3}, {0, 1, -3}};
    model.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    return model.mesh;
}

std::vector<int> allOfACube() {
    std::vector<int> vertices(24);
    std::iota(vertices.begin(), vertices.end(), 0);
    return vertices;
}

constexpr std::array vertexRows{
    Mistake{"NormalWithoutLength", "zero-normal", Warning, "models[0].mesh.normals",
            "the normal of vertex 1 has length 0",
            [](Subject& s) {
                triangle(s).normals.edit()[1] = glm::vec3(0);
                s.pass().lighting = true;
            }},
    Mistake{"NormalsWithoutLength", "zero-normal", Warning, "models[0].mesh.normals",
            "the same is true of "
            "2 more",
            [](Subject& s) {
                triangle(s).normals.assign(3, glm::vec3(0));
                s.unit().texGenS = {.enabled = true, .mode = TexGenMode::SphereMap};
            }},
    Mistake{"NormalThatNothingReads", "zero-normal", Warning, "models[0].mesh.normals", "vertex 0",
            [](Subject& s) {
                triangle(s).normals.edit()[0] = glm::vec3(0);
                s.pass().lighting = true;
            },
            [](Subject& s) { s.pass().lighting = false; }},
    Mistake{"NoGlTexCoord", "no-tex-coord", Warning, "models[0].noTexCoord0",
            "vertex 2 has no glTexCoord: it shows the colour at the coordinates of vertex 1",
            [](Subject& s) { s.scene.models[0].noTexCoord[0] = {2}; },
            [](Subject& s) { s.scene.models[0].noTexCoord[0] = {}; }},
    Mistake{
        "NoGlTexCoordAtAll", "no-tex-coord", Warning, "models[0].noTexCoord0",
        "vertex 0 has no glTexCoord, and none is sent before it: it shows the colour at (0, 0); the same is "
        "true of 1 more",
        [](Subject& s) {
            s.scene.models[0].noTexCoord[0] = {0, 1};
        },
        [](Subject& s) { s.unit().texGenS.enabled = s.unit().texGenT.enabled = true; }},
    Mistake{"NoGlTexCoordOfAnyVertex", "no-tex-coord", Warning, "models[0].noTexCoord0",
            "no vertex has a glTexCoord: all show the colour at (0, 0)",
            [](Subject& s) { s.scene.models[0].noTexCoord[0] = allOfACube(); }},
    Mistake{
        "CoordinatesOfAnotherUnit", "no-tex-coord", Warning, "models[0].noTexCoord1",
        "no vertex has coordinates of unit 1, and all show the colour at (0, 0): glTexCoord sends those of "
        "unit 0, also after glActiveTexture",
        [](Subject& s) {
            s.pass().units[1] = s.unit();
            s.unit().enabled = false;
            s.scene.models[0].noTexCoord[1] = allOfACube();
        }},
    Mistake{"NoGlTexCoordAtAKey", "no-tex-coord", Warning, "models[0].noTexCoord0",
            "at 2 s: vertex 2 has no glTexCoord: it shows the colour at the coordinates of vertex 1",
            [](Subject& s) {
                s.scene.timeline.keys = {{.time = 0, .path = "models[0].noTexCoord0"},
                                         {.time = 2, .path = "models[0].noTexCoord0", .value = "2"}};
            },
            [](Subject& s) { s.scene.timeline.keys[1].value = ""; }},
    Mistake{"ReflectionAwayFromTheEye", "sphere-map-rim", Warning, "passes[0].units[0].texGenS",
            "at vertex 0 of models[0]",
            [](Subject& s) {
                triangle(s).normals.edit()[0] = {1, 0, 0}; // seen along the surface
                s.unit().texGenT = {.enabled = true, .mode = TexGenMode::SphereMap};
            },
            [](Subject& s) {
                s.scene.models[0].mesh.normals.edit()[0] = {0, 0, 1};
            }},
    Mistake{"CoordinatesFarAway", "far-coordinates", Note, "passes[0].units[0].matrix",
            "reach 871, 55744 texels",
            [](Subject& s) {
                s.unit().matrix = {{.op = MatrixOp::Translate, .amount = {870, 0, 0}}};
            },
            [](Subject& s) { s.unit().matrix[0].amount.x = 400; }},
    Mistake{"FogWithoutLengthOfAModelAtTheEye", "fog-range", Warning, "passes[0].fog.end", "divides by 0",
            [](Subject& s) {
                MeshData& mesh = triangle(s);
                // Rounding to a power of ten is not possible for this float.
                mesh.positions.edit()[0].z = mesh.positions.edit()[1].z = -1e-45F;
                mesh.positions.edit()[2].z = -5;
                s.scene.view.projection = Projection::Orthographic;
                s.pass().fog = {.enabled = true, .mode = FogMode::Linear, .start = 5, .end = 5};
            }},
    Mistake{"LineOfAMillionPixels", "long-line", Note, "models[0].mesh", "more than a million pixels",
            [](Subject& s) {
                triangle(s).primitive = Primitive::Lines;
                s.scene.models[0].mesh.positions.edit()[1].x = 1e6F;
            },
            [](Subject& s) { s.driver.renderer = "softpipe"; }},
    Mistake{"MeshOfNothing", "empty-mesh", Warning, "models[0].shape", "has no vertices",
            [](Subject& s) { s.scene.models[0].shape = Shape::Mesh; }, [](Subject& s) { triangle(s); }},
    Mistake{"MeshOfAFileThatIsNotThere", "missing-mesh", Error, "models[0].mesh.file",
            "gone.obj can't be read, or has no part 2",
            [](Subject& s) {
                s.scene.models[0].shape = Shape::Mesh;
                s.scene.models[0].mesh.file = "gone.obj";
                s.scene.models[0].mesh.part = 2;
            },
            [](Subject& s) { triangle(s); }},
    Mistake{"MeshWithoutCoordinates", "no-mesh-coords", Warning, "models[0].mesh.texCoords", "at (0, 0)",
            [](Subject& s) { triangle(s); },
            [](Subject& s) {
                s.scene.models[0].mesh.texCoords = {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}};
            }},
    Mistake{"MeshOfTwoVertices", "empty-mesh", Warning, "models[0].shape", "too few vertices",
            [](Subject& s) { triangle(s).positions.edit().pop_back(); }, [](Subject& s) { triangle(s); }},
    Mistake{"WidthOfNoLines", "other-primitive", Unused, "models[0].lineWidth", "it has no lines",
            [](Subject& s) { triangle(s).primitive = Primitive::Points; },
            [](Subject& s) { s.scene.models[0].mesh.primitive = Primitive::Lines; }},
    Mistake{"SizeOfNoPoints", "other-primitive", Unused, "models[0].pointSize", "it has no points",
            [](Subject& s) { triangle(s); },
            [](Subject& s) { s.scene.models[0].mesh.primitive = Primitive::Points; }},
    Mistake{"MaterialOfTheScene", "shared-material", Unused, "models[0].material", "has the scene's material",
            [](Subject&) {}, [](Subject& s) { s.scene.models[0].ownMaterial = true; }},
    Mistake{"MaterialThatNoModelHas", "unused-material", Hint, "material.ambient", "material of its own",
            [](Subject& s) {
                for (Model& each : s.scene.models)
                    each.ownMaterial = true;
            },
            [](Subject& s) { s.scene.models[0].ownMaterial = false; }},
    Mistake{"ColourThatLightReplaces", "other-reflectance", Hint, "material.color",
            "without GL_COLOR_MATERIAL", [](Subject& s) { s.scene.material.colorMaterial = false; },
            [](Subject& s) { s.pass().lighting = false; }},
    Mistake{"ReflectanceThatColourReplaces", "other-reflectance", Hint, "material.diffuse", "glColor is used",
            [](Subject& s) { s.scene.material.colorMaterial = true; }}};

} // namespace

std::span<const Mistake> vertexMistakes() {
    return vertexRows;
}

} // namespace texplorer::test
