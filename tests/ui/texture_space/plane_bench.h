#pragma once

#include "tests/ui/workbench.h"
#include "texplorer/scene/tex_coords.h"

namespace texplorer::test {

/// The window with the default scene, or with one shape alone: the vertices of a Quad are 0 at (0, 0), 1 at
/// (1, 0), 2 at (1, 1) and 3 at (0, 1).
class PlaneBench : public Workbench {
protected:
    PlaneBench() = default;
    explicit PlaneBench(Shape shape) {
        Scene alone = defaultScene();
        alone.models.resize(1);
        alone.models[0].shape = shape;
        start(std::move(alone));
    }

    ui::TextureSpaceState& state() { return states.textureSpace; }
    glm::vec4 coord(std::size_t vertex) {
        return effectiveTexCoord(*ui::selectedModel(*session), ui::selectedMesh(*session), 0, vertex);
    }
    float pixelsPerUnit() {
        const ui::WidgetPlaces::Item& canvas = places.items.at("texture space");
        return std::min(canvas.right - canvas.left, canvas.bottom - canvas.top) / session->look.plane.extent;
    }
    /// Where the panel shows a coordinate.
    ImVec2 at(float s, float t) {
        const ui::WidgetPlaces::Item& canvas = places.items.at("texture space");
        return {std::floor((canvas.left + canvas.right) / 2) + (s - session->look.plane.s) * pixelsPerUnit(),
                std::floor((canvas.top + canvas.bottom) / 2) - (t - session->look.plane.t) * pixelsPerUnit()};
    }
    void expectCoord(std::size_t vertex, float s, float t, float tolerance = 1e-4F) {
        EXPECT_NEAR(coord(vertex).s, s, tolerance) << "vertex " << vertex;
        EXPECT_NEAR(coord(vertex).t, t, tolerance) << "vertex " << vertex;
    }
    /// What the plane says that begins so; empty where it says nothing of that kind.
    std::string noted(std::string_view beginning) {
        const auto found = places.items.lower_bound(beginning);
        return found != places.items.end() && found->first.starts_with(beginning) ? found->first : "";
    }
    std::size_t undoSteps() { return session->document.history.position(); }
    /// A component of the window's picture at a place.
    int shown(ImVec2 place, int component = 0) {
        frames();
        const Image window = picture();
        return std::to_integer<int>(
            window.at(static_cast<int>(place.x),
                      window.height - 1 - static_cast<int>(place.y))[static_cast<std::size_t>(component)]);
    }
    void dragTo(ImVec2 from, ImVec2 to) { drag(from, {to.x - from.x, to.y - from.y}); }
    /// Presses at a place and moves, without a release.
    void hold(ImVec2 from, ImVec2 way) {
        moveTo(from);
        ImGui::GetIO().MouseDown[0] = true;
        frames(1);
        moveTo({from.x + way.x, from.y + way.y});
    }
    void release() {
        ImGui::GetIO().MouseDown[0] = false;
        frames(3);
    }
    /// A key that is held while the mouse does something.
    struct Held {
        Held(PlaneBench& window, int code)
            : window_(window)
            , code_(code) {
            window_.setHeld(code_, true);
        }
        ~Held() { window_.setHeld(code_, false); }
        Held(const Held&) = delete;
        Held& operator=(const Held&) = delete;

    private:
        PlaneBench& window_;
        int code_;
    };
};

} // namespace texplorer::test
