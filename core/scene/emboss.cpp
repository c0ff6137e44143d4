#include "texplorer/scene/emboss.h"

#include "texplorer/scene/animation.h"
#include "texplorer/scene/tex_coords.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <cmath>

namespace texplorer {
namespace {

/// What points where v does and has the length 1; 0 where nothing does.
glm::vec3 unitVector(glm::vec3 v) {
    const float length = glm::length(v);
    return length > 0 && std::isfinite(length) ? v / length : glm::vec3(0);
}

} // namespace

std::vector<Tangents> tangentsOf(const Mesh& mesh, const TexCoords& coords) {
    std::vector<Tangents> sums(mesh.vertices.size());
    for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
        const std::array corners{mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
        const glm::vec3 origin = mesh.vertices[corners[0]].position;
        const glm::vec3 ab = mesh.vertices[corners[1]].position - origin;
        const glm::vec3 ac = mesh.vertices[corners[2]].position - origin;
        const auto placeOf = [&](std::uint32_t corner) {
            return glm::vec2(coords[corner]) / coords[corner].q;
        };
        const glm::vec2 abCoords = placeOf(corners[1]) - placeOf(corners[0]);
        const glm::vec2 acCoords = placeOf(corners[2]) - placeOf(corners[0]);
        const float area = abCoords.s * acCoords.t - abCoords.t * acCoords.s;
        if (area == 0 || !std::isfinite(area))
            continue; // s and t say no direction here
        const float side = area > 0 ? 1.0F : -1.0F;
        const glm::vec3 s = unitVector((ab * acCoords.t - ac * abCoords.t) * side);
        const glm::vec3 t = unitVector((ac * abCoords.s - ab * acCoords.s) * side);
        for (const std::uint32_t corner : corners) {
            sums[corner].s += s;
            sums[corner].t += t;
        }
    }
    for (Tangents& each : sums)
        each = {unitVector(each.s), unitVector(each.t)};
    return sums;
}

glm::vec4 lightInModel(const Scene& scene, const Model& model, LightCarrier carrier, double time) {
    const glm::dmat4 toModel = glm::inverse(glm::dmat4(modelViewMatrix(scene.view, model, time)));
    const glm::vec4& light = scene.light.position;
    const bool placed = light.w != 0;
    const glm::dvec3 eye = glm::dvec3(light) / (placed ? double{light.w} : 1.0);
    const glm::dvec3 carried = carrier == LightCarrier::Transpose
                                   ? glm::transpose(glm::dmat3(toModel)) * eye
                                   : glm::dvec3(toModel * glm::dvec4(eye, placed ? 1 : 0));
    return {glm::vec3(carried), placed ? 1.0F : 0.0F};
}

glm::vec2 embossOffset(glm::vec3 position, const Tangents& tangents, glm::vec4 light, float depth) {
    const glm::vec3 toLight = unitVector(light.w != 0 ? glm::vec3(light) - position : glm::vec3(light));
    return glm::vec2(glm::dot(tangents.s, toLight), glm::dot(tangents.t, toLight)) * depth;
}

TexCoords givenTexCoords(const Scene& scene, const Pass& pass, int unit, const Model& model, const Mesh& mesh,
                         double time) {
    TexCoords coords = effectiveTexCoords(model, mesh, unit);
    const Emboss& emboss = pass.units[static_cast<std::size_t>(unit)].emboss;
    if (!emboss.enabled)
        return coords;
    const std::vector<Tangents> tangents = tangentsOf(mesh, coords);
    const glm::vec4 light = lightInModel(scene, model, emboss.carrier, time);
    for (std::size_t i = 0; i < coords.size(); ++i) {
        const glm::vec2 offset =
            embossOffset(mesh.vertices[i].position, tangents[i], light, emboss.depth) * coords[i].q;
        coords[i].s += offset.s;
        coords[i].t += offset.t;
    }
    return coords;
}

} // namespace texplorer
