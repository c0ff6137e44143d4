#pragma once

#include "app/ui/model/session.h"
#include "core/base/result.h"
#include "core/texture/texture_levels.h"

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <memory>
#include <vector>

namespace texplorer::ui {

/// The coordinates of the selected model for the selected unit, as places of the plane: as they are given,
/// and where they end after the unit's relief, generation and matrix, divided by q. Made anew only where
/// something of that changed.
class PlaneCoords {
public:
    /// To be called in every frame, and after an edit. Of a cube map, whose directions have no place in a
    /// plane, and without a model there are none.
    void follow(Session& session);

    [[nodiscard]] const TexCoords& given() const { return key_.given; }
    [[nodiscard]] const std::vector<glm::vec2>& givenPlaces() const { return givenPlaces_; }
    /// A place that isn't finite is none.
    [[nodiscard]] const std::vector<glm::vec2>& resultingPlaces() const { return resultingPlaces_; }
    /// Whether any coordinate ends elsewhere than it is given.
    [[nodiscard]] bool differ() const { return differ_; }

    /// What has to be given for a vertex to end in this place. The error says why nothing does.
    [[nodiscard]] Result<glm::vec4> givenFor(std::size_t vertex, glm::vec2 place) const;

private:
    /// What the places are made of.
    struct Key {
        std::shared_ptr<const Mesh> mesh;
        TexCoords given;
        Unit unit;
        LateFlip flip = LateFlip::None;
        glm::mat4 matrix{1};
        glm::mat4 modelview{1}; ///< where it matters
        glm::vec4 light{0};     ///< where it matters

        bool operator==(const Key&) const = default;
    };
    void makePlaces(const Session& session, const Scene& scene, const Model& model);

    Key key_;
    glm::mat4 shown_{1};  ///< from generated coordinates to the plane, before the division
    TexCoords generated_; ///< before the matrix
    TexCoords relief_;    ///< what the unit's relief adds to those that are given; empty: nothing
    std::vector<glm::vec2> givenPlaces_;
    std::vector<glm::vec2> resultingPlaces_;
    bool differ_ = false;
};

} // namespace texplorer::ui
