#pragma once

// Primitive assembly: flat colours, clipping and set-up of shaded vertices.

#include "texplorer/mesh/mesh.h"
#include "texplorer/reference/raster/triangle.h"
#include "texplorer/reference/shading/pass_state.h"

#include <functional>
#include <span>

namespace texplorer::reference {

/// Calls work(indices of the 1 to 3 vertices, number of the part) for the triangles, lines or points of a
/// mesh, in drawing order.
template<class Work>
void eachPart(const Mesh& mesh, const Work& work) {
    const auto visit = [&](const std::vector<std::uint32_t>& indices, std::size_t corners) {
        for (std::size_t i = 0; i + corners <= indices.size(); i += corners)
            work(std::span(indices).subspan(i, corners), i / corners);
    };
    visit(mesh.triangles, 3);
    visit(mesh.lines, 2);
    visit(mesh.points, 1);
}

/// Clips and sets up parts of one model in one pass.
class Assembly {
public:
    /// `work` is called for each resulting triangle.
    Assembly(const PassState& pass, const Model& model, Viewport viewport,
             const std::function<void(const Triangle&)>& work)
        : pass_(pass)
        , model_(model)
        , viewport_(viewport)
        , work_(work) {}

    void add(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const; ///< a triangle
    void add(const ShadedVertex& a, const ShadedVertex& b) const;                        ///< a line
    void add(const ShadedVertex& a) const;                                               ///< a point

    /// Adds a part with these corners, 1 to 3.
    void add(std::span<const ShadedVertex> corners) const;

private:
    void addClipped(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const;
    void addTriangle(const ShadedVertex& a, const ShadedVertex& b, const ShadedVertex& c) const;

    const PassState& pass_;
    const Model& model_;
    Viewport viewport_;
    const std::function<void(const Triangle&)>& work_;
};

} // namespace texplorer::reference
