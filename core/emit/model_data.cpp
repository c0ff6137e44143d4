#include "texplorer/emit/model_data.h"

#include "texplorer/emit/code_writer.h"
#include "texplorer/emit/program.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/texture_matrix.h"

#include <fmt/core.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::emit {
namespace {

/// Whether some vertex has another r than 0, which is compared, or another q than 1, by which all are
/// divided.
bool givesRorQ(const Model& model, std::size_t unit) {
    const auto isOdd = [](const glm::vec4& coord) { return coord.z != 0 || coord.w != 1; };
    return std::ranges::any_of(model.texCoords[unit], isOdd) ||
           (model.shape == Shape::Mesh && std::ranges::any_of(model.mesh.texCoords, isOdd));
}

} // namespace

std::string floatsText(std::span<const float> values, std::size_t columns) {
    std::string text;
    text.reserve(values.size() * 12);
    for (std::size_t i = 0; i < values.size(); ++i) {
        text += i % columns == 0 ? "    " : " ";
        text += literal(values[i], Literal::Float);
        text += i % columns == columns - 1 || i + 1 == values.size() ? ",\n" : ",";
    }
    return text;
}

std::string indicesText(std::span<const std::uint32_t> indices) {
    constexpr std::size_t columns = 12;
    std::string text;
    for (std::size_t i = 0; i < indices.size(); ++i)
        text += fmt::format("{}{},{}", i % columns == 0 ? "    " : " ", indices[i],
                            i % columns == columns - 1 || i + 1 == indices.size() ? "\n" : "");
    return text;
}

bool isTwisted(const Model& model) {
    if (model.shape != Shape::Mesh || model.mesh.primitive != Primitive::QuadStrip)
        return false;
    constexpr float flat = 1e-5F;
    const Mesh mesh = makeMesh(model.mesh);
    const auto at = [&](std::size_t i) { return mesh.vertices[mesh.triangles[i]].position; };
    for (std::size_t i = 0; i + 5 < mesh.triangles.size(); i += 6) {
        const glm::vec3 first = glm::cross(at(i + 1) - at(i), at(i + 2) - at(i));
        const glm::vec3 second = glm::cross(at(i + 4) - at(i + 3), at(i + 5) - at(i + 3));
        if (std::abs(glm::dot(first, at(i + 3) - at(i))) > flat || glm::dot(first, second) < 0)
            return true;
    }
    return false;
}

const std::vector<std::uint32_t>& drawnIndices(const Mesh& mesh) {
    return !mesh.triangles.empty() ? mesh.triangles : !mesh.lines.empty() ? mesh.lines : mesh.points;
}

bool isTurned(Shape shape) {
    return shape == Shape::Sphere || shape == Shape::Cylinder || shape == Shape::Disk ||
           shape == Shape::PartialDisk || shape == Shape::Torus;
}

bool takesCoords(const Scene& scene, const Pass& pass, std::size_t index, std::size_t model) {
    const Unit& unit = pass.units[index];
    if (!unit.enabled)
        return false;
    const std::array generated{unit.texGenS.enabled, unit.texGenT.enabled, unit.texGenR.enabled,
                               unit.texGenQ.enabled};
    const bool looksAtAll =
        !textureSteps(scene, static_cast<std::size_t>(&pass - scene.passes.data()), index, model).empty() ||
        givesRorQ(scene.models[model], index);
    const int looked = looksAtAll ? 4 : coordinatesOf(unit.target);
    return !std::all_of(generated.begin(), generated.begin() + looked, [](bool on) { return on; });
}

bool hasIndices(const Model& model) {
    return model.shape == Shape::Mesh ? !model.mesh.indices.empty()
                                      : sentPrimitive(model) != Primitive::Quads;
}

ModelForm formOf(const Scene& scene, std::size_t index, bool flips) {
    const SentModel sent(scene.models[index]);
    const Model& model = *sent;
    ModelForm form;
    int passes = 0;
    for (const Pass& pass : scene.passes) {
        const std::vector<std::size_t> drawn = drawnModels(scene, pass);
        passes += static_cast<int>(std::ranges::count(drawn, index));
        for (std::size_t u = 0; u < maxUnits && std::ranges::find(drawn, index) != drawn.end(); ++u) {
            const Unit& unit = pass.units[u];
            const bool takes = takesCoords(scene, pass, u, index);
            form.coords[u] |= takes && !unit.emboss.enabled;
            form.embossed[u] |= takes && unit.emboss.enabled;
        }
    }
    if (passes == 0)
        return form;
    const bool isEmbossed = std::ranges::find(form.embossed, true) != form.embossed.end();
    const bool isSmall = vertexCountOf(model) <= maxWrittenVertices;
    const bool isPlain = model.shape == Shape::Mesh || sentPrimitive(model) == Primitive::Quads;
    bool hasOwnCoords = false;
    for (std::size_t u = 0; u < maxUnits; ++u)
        hasOwnCoords |= form.coords[u] && !model.texCoords[u].empty();
    if (isTurned(model.shape) && !isEmbossed && !hasOwnCoords && !flips)
        form.drawing = Drawing::Shape;
    else if (isPlain && isSmall && !hasIndices(model) && !isEmbossed && !isTwisted(model))
        form.drawing = Drawing::List;
    else
        form.drawing = Drawing::Arrays;
    form.isWritten = isPlain && isSmall && !isEmbossed && model.mesh.indices.size() <= maxWrittenVertices;
    return form;
}

} // namespace texplorer::emit
