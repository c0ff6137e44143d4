#pragma once

#include "app/ui/model/session.h"
#include "texplorer/base/result.h"
#include "texplorer/texture/texture_levels.h"

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace texplorer::reference {
class EyeSpace;
}

namespace texplorer::ui {

/// A rectangle of the texture plane.
struct Bounds {
    glm::vec2 low{0};
    glm::vec2 high{1};

    void include(glm::vec2 place) {
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    [[nodiscard]] glm::vec2 middle() const { return (low + high) / 2.0F; }
};

/// Whether a position in the plane is finite.
[[nodiscard]] inline bool isPlace(glm::vec2 place) {
    return std::isfinite(place.x) && std::isfinite(place.y);
}

/// The coordinates of the selected model for the selected unit, as positions in the plane: the given ones, of
/// a vertex without glTexCoord those of the vertex before it, and the final ones after the unit's relief,
/// generation and matrix, divided by q. Computed again only after a change.
class PlaneCoords {
public:
    /// Call in every frame, and after an edit. Without a model there are none, nor for a cube map, whose
    /// directions have no position in a plane.
    void follow(const Session& session);

    /// Of each vertex, also where its glTexCoord is left out.
    [[nodiscard]] const TexCoords& given() const { return given_; }
    /// Whose coordinates a vertex has: its own if it is sent with glTexCoord; empty: (0, 0, 0, 1).
    [[nodiscard]] std::optional<std::uint32_t> source(std::size_t vertex) const { return sources_[vertex]; }
    /// The coordinates that it has.
    [[nodiscard]] glm::vec4 current(std::size_t vertex) const;
    /// Without effect are those of a vertex whose glTexCoord is left out: an error.
    [[nodiscard]] Result<void> hasOwn(std::size_t vertex) const;
    [[nodiscard]] const std::vector<glm::vec2>& givenPlaces() const { return givenPlaces_; }
    /// The final positions; those that are not finite are left out.
    [[nodiscard]] const std::vector<glm::vec2>& resultingPlaces() const { return resultingPlaces_; }
    /// The outlines of the mesh's faces, in its order, and the positions that they refer to: the final ones.
    /// A vertex that leaves out glTexCoord is elsewhere each time it is sent.
    [[nodiscard]] const std::vector<Face>& outlines() const {
        return sent_ ? sent_->faces : key_.mesh->faces;
    }
    [[nodiscard]] const std::vector<glm::vec2>& outlinePlaces() const {
        return sent_ ? sentPlaces_ : resultingPlaces_;
    }
    /// Whether any final position differs from the given one.
    [[nodiscard]] bool differ() const { return differ_; }

    /// The coordinate with which a vertex has this final position. The error says why there is none.
    [[nodiscard]] Result<glm::vec4> givenFor(std::size_t vertex, glm::vec2 place) const;

private:
    /// The inputs of the positions.
    struct Key {
        std::shared_ptr<const Mesh> mesh;
        SharedList<glm::vec4> own; ///< Model::texCoords
        std::vector<int> leftOut;  ///< Model::noTexCoord
        Unit unit;
        LateFlip flip = LateFlip::None;
        glm::mat4 matrix{1};
        glm::mat4 modelview{1}; ///< if it is used
        glm::vec4 light{0};     ///< if it is used

        bool operator==(const Key&) const = default;
    };
    void makePlaces(const Session& session, const Scene& scene, const Model& model);
    void makeOutlines(const Session& session, const Scene& scene, const Model& model);
    /// Generated from coordinates that the relief has moved.
    [[nodiscard]] glm::vec4 generatedFrom(glm::vec4 moved, const reference::EyeSpace& eye,
                                          const Vertex& vertex) const;

    Key key_;
    TexCoords given_;
    glm::mat4 shown_{1};  ///< from generated coordinates to the plane, before the division
    TexCoords generated_; ///< before the matrix
    TexCoords relief_;    ///< added to the given coordinates by the unit's relief; empty: nothing
    std::vector<std::optional<std::uint32_t>> sources_; ///< coordSources
    std::optional<Mesh> sent_; ///< with a vertex for each that is sent, if any leaves out glTexCoord
    std::vector<glm::vec2> sentPlaces_;
    std::vector<glm::vec2> givenPlaces_;
    std::vector<glm::vec2> resultingPlaces_;
    bool differ_ = false;
};

} // namespace texplorer::ui
