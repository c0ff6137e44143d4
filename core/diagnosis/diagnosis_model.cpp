// Models: what is not drawn, and which of their settings do nothing.

#include "texplorer/diagnosis/diagnosis_rules.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"

#include <fmt/core.h>

#include <algorithm>

namespace texplorer::diagnosis {
namespace {

std::string modelPath(std::size_t model, const std::string& key) {
    return fmt::format("{}.{}", elementOf<&Scene::models>(model), key);
}

void hiddenModel(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        if (!about.scene.models[m].visible)
            report.add(elementOf<&Scene::models>(m), N_("the model is hidden"),
                       Fix{N_("Show it"), {{modelPath(m, keyOf<&Model::visible>()), "true"}}});
        else if (!isDrawn(about.scene, m))
            report.add(elementOf<&Scene::models>(m), N_("no enabled pass draws it"));
    }
}

/// A parameter of a shape, and the shapes that have it.
struct ShapeRow {
    Key key;
    std::vector<Shape> shapes;
};

void otherShape(const Case& about, Report& report) {
    const std::vector round{Shape::Sphere,      Shape::Cylinder, Shape::Disk,
                            Shape::PartialDisk, Shape::Torus,    Shape::Teapot};
    const std::array rows{
        ShapeRow{keyOf<&Model::slices>, round},
        ShapeRow{keyOf<&Model::stacks>, round},
        ShapeRow{keyOf<&Model::topRadius>, {Shape::Cylinder}},
        ShapeRow{keyOf<&Model::innerRadius>, {Shape::Disk, Shape::PartialDisk}},
        ShapeRow{keyOf<&Model::tubeRadius>, {Shape::Torus}},
        ShapeRow{keyOf<&Model::startAngle>, {Shape::PartialDisk}},
        ShapeRow{keyOf<&Model::sweepAngle>, {Shape::PartialDisk}},
        ShapeRow{keyOf<&Model::mesh>, {Shape::Mesh}},
    };
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Shape shape = about.scene.models[m].shape;
        for (const ShapeRow& row : rows) {
            if (std::ranges::find(row.shapes, shape) == row.shapes.end())
                report.add(modelPath(m, row.key()), Sentence("the shape \"{0}\" has none", named(shape)));
        }
    }
}

void otherPrimitive(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Model& model = about.scene.models[m];
        if (partCorners(model) != 2)
            report.add(modelPath(m, keyOf<&Model::lineWidth>()), N_("it has no lines"));
        if (partCorners(model) != 1)
            report.add(modelPath(m, keyOf<&Model::pointSize>()), N_("it has no points"));
    }
}

void sharedMaterial(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        if (!about.scene.models[m].ownMaterial)
            report.add(modelPath(m, keyOf<&Model::material>()), N_("it has the scene's material"));
    }
}

/// How many vertices the first part of a primitive takes (section 2.6.1).
std::size_t minVertices(Primitive primitive) {
    const bool quads = primitive == Primitive::Quads || primitive == Primitive::QuadStrip;
    return quads ? 4 : static_cast<std::size_t>(partCorners(primitive));
}

void missingMesh(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const MeshData& mesh = about.scene.models[m].mesh;
        if (about.scene.models[m].shape == Shape::Mesh && !mesh.file.empty() && mesh.positions.empty())
            report.add(modelPath(m, fmt::format("{}.{}", keyOf<&Model::mesh>(), keyOf<&MeshData::file>())),
                       Sentence("{0} can't be read, or has no part {1}: nothing is drawn",
                                ProperName{mesh.file}, mesh.part));
    }
}

void emptyMesh(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Model& model = about.scene.models[m];
        if (model.shape != Shape::Mesh)
            continue;
        const MeshData& mesh = model.mesh;
        const std::size_t given = mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
        if (mesh.file.empty() && given < minVertices(mesh.primitive))
            report.add(modelPath(m, keyOf<&Model::shape>()),
                       mesh.positions.empty()
                           ? N_("the mesh has no vertices: nothing is drawn")
                           : N_("the mesh has too few vertices for its primitive: nothing is drawn"));
    }
}

void tooManyStacks(const Case& about, Report& report) {
    for (std::size_t m = 0; m < about.scene.models.size(); ++m) {
        const Model& model = about.scene.models[m];
        if (model.shape != Shape::Teapot || model.stacks <= maxTeapotStacks)
            continue;
        const std::string path = modelPath(m, keyOf<&Model::stacks>());
        report.add(
            path,
            Sentence("a teapot has at most {0} along each patch and is drawn with these", maxTeapotStacks),
            Fix{Sentence("Make it {0}", maxTeapotStacks), {{path, std::to_string(maxTeapotStacks)}}});
    }
}

constexpr std::array modelRuleRows{
    Rule{"missing-mesh", Severity::Error, missingMesh},
    Rule{"empty-mesh", Severity::Warning, emptyMesh},
    Rule{"too-many-stacks", Severity::Warning, tooManyStacks},
    Rule{"hidden-model", Severity::Hint, hiddenModel},
    Rule{"other-shape", Severity::Unused, otherShape},
    Rule{"other-primitive", Severity::Unused, otherPrimitive},
    Rule{"shared-material", Severity::Unused, sharedMaterial},
};

} // namespace

std::span<const Rule> modelRules() {
    return modelRuleRows;
}

} // namespace texplorer::diagnosis
