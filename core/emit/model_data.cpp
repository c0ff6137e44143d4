#include "core/emit/model_data.h"

#include "core/emit/program.h"
#include "core/scene/drawn_models.h"
#include "core/scene/model_mesh.h"

#include <algorithm>

namespace texplorer::emit {
namespace {

/// Of squares, four corners each.
bool isMadeOfQuads(Shape shape) {
    return shape == Shape::Cube || shape == Shape::Quad || shape == Shape::Floor;
}

} // namespace

bool isTurned(Shape shape) {
    return shape == Shape::Sphere || shape == Shape::Cylinder || shape == Shape::Disk ||
           shape == Shape::PartialDisk || shape == Shape::Torus;
}

bool takesCoords(const Unit& unit) {
    if (!unit.enabled)
        return false;
    const std::array generated{unit.texGenS.enabled, unit.texGenT.enabled, unit.texGenR.enabled};
    const int looked = coordinatesOf(unit.target);
    return !std::all_of(generated.begin(), generated.begin() + looked, [](bool on) { return on; });
}

bool hasIndices(const Model& model) {
    return model.shape == Shape::Mesh ? !model.mesh.indices.empty() : !isMadeOfQuads(model.shape);
}

std::string primitiveOf(const Model& model) {
    if (model.shape == Shape::Mesh)
        return std::string(rowOf(model.mesh.primitive).name);
    return std::string(rowOf(isMadeOfQuads(model.shape) ? Primitive::Quads : Primitive::Triangles).name);
}

ModelForm formOf(const Scene& scene, std::size_t index, bool flips) {
    const Model& model = scene.models[index];
    ModelForm form;
    int passes = 0;
    for (const Pass& pass : scene.passes) {
        const std::vector<std::size_t> drawn = drawnModels(scene, pass);
        passes += static_cast<int>(std::ranges::count(drawn, index));
        for (std::size_t u = 0; u < maxUnits && std::ranges::find(drawn, index) != drawn.end(); ++u) {
            const Unit& unit = pass.units[u];
            form.coords[u] |= takesCoords(unit) && !unit.emboss.enabled;
            form.embossed[u] |= takesCoords(unit) && unit.emboss.enabled;
        }
    }
    if (passes == 0)
        return form;
    const bool isEmbossed = std::ranges::find(form.embossed, true) != form.embossed.end();
    const bool isSmall = vertexCountOf(model) <= mostWrittenVertices;
    const bool isPlain = isMadeOfQuads(model.shape) || model.shape == Shape::Mesh;
    bool hasOwnCoords = false;
    for (std::size_t u = 0; u < maxUnits; ++u)
        hasOwnCoords |= form.coords[u] && !model.texCoords[u].empty();
    if (isTurned(model.shape) && !isEmbossed && !hasOwnCoords && !flips)
        form.drawing = Drawing::Shape;
    else if (isPlain && isSmall && !hasIndices(model) && !isEmbossed)
        form.drawing = Drawing::List;
    else
        form.drawing = Drawing::Arrays;
    form.isWritten = isPlain && isSmall && !isEmbossed && model.mesh.indices.size() <= mostWrittenVertices;
    return form;
}

} // namespace texplorer::emit
