#pragma once

#include "texplorer/mesh/mesh.h"
#include "texplorer/scene/scene.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace texplorer::emit {

/// How a program draws a model.
enum class Drawing : std::uint8_t {
    None,
    List,    ///< a display list of what stands between glBegin and glEnd
    Shape,   ///< arrays that a function makes: sphere()
    Arrays,  ///< arrays whose numbers stand in the program
    Quadric, ///< gluSphere and the like
};

struct ModelForm {
    Drawing drawing = Drawing::None;
    bool isWritten = false;                ///< of arrays: a row for each vertex, and not at the end
    std::array<bool, maxUnits> coords{};   ///< which units take coordinates from the vertices as they are
    std::array<bool, maxUnits> embossed{}; ///< which take those that the program makes anew in every frame

    bool operator==(const ModelForm&) const = default;
};

/// Whether any coordinate that a unit of a pass looks at comes from the model's vertices. A texture matrix
/// looks at all four. The pass and the model are the scene's.
[[nodiscard]] bool takesCoords(const Scene& scene, const Pass& pass, std::size_t unit, std::size_t model);

/// `flips`: whether t of its coordinates is turned around for some unit.
[[nodiscard]] ModelForm formOf(const Scene& scene, std::size_t model, bool flips);

/// Of its triangles, or else of its lines or points; none: no program draws it.
[[nodiscard]] const std::vector<std::uint32_t>& drawnIndices(const Mesh& mesh);

/// "1.0f, 0.5f,\n": so many in a row.
[[nodiscard]] std::string floatsText(std::span<const float> values, std::size_t columns);
[[nodiscard]] std::string indicesText(std::span<const std::uint32_t> indices);

/// Turned about an axis: a function of the program makes it.
[[nodiscard]] bool isTurned(Shape shape);

/// A strip of quadrilaterals of which some isn't flat and convex: which of its triangles comes first, and
/// covers the other, OpenGL leaves open, and Mesa has it one way where it clips and the other where it
/// doesn't. A program draws its triangles.
[[nodiscard]] bool isTwisted(const Model& model);

/// Whether its vertices are drawn in an order of their own.
[[nodiscard]] bool hasIndices(const Model& model);

} // namespace texplorer::emit
