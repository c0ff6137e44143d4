#include "app/ui/texture_space/texture_space_panel.h"

#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/texture_space/texel_marks.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/image/cube_faces.h"
#include "core/scene/tex_coords.h"

#include <fmt/core.h>
#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr float nearestExtent = 0.02F;
constexpr float farthestExtent = 200;

/// The vertex under the mouse. Where several share a place (the faces of a cube do), the chosen one comes
/// first, then one of its face.
std::optional<std::size_t> vertexUnder(const Canvas& canvas, const Mesh& mesh, const TexCoords& coords,
                                       std::optional<std::size_t> chosen, ImVec2 mouse, float reach) {
    const auto isNear = [&](std::size_t vertex) {
        const ImVec2 at = canvas.toPixel(coords[vertex].x, coords[vertex].y);
        return std::hypot(at.x - mouse.x, at.y - mouse.y) <= reach;
    };
    if (chosen && *chosen < coords.size() && isNear(*chosen))
        return chosen;
    if (chosen) {
        for (const Face& face : mesh.faces) {
            if (!contains(face, *chosen))
                continue;
            for (const std::uint32_t vertex : face.vertices) {
                if (isNear(vertex))
                    return vertex;
            }
        }
    }
    for (std::size_t vertex = 0; vertex < coords.size(); ++vertex) {
        if (isNear(vertex))
            return vertex;
    }
    return std::nullopt;
}

void moveCanvas(Plane& plane, const Canvas& canvas, bool hovered, bool dragged) {
    const ImGuiIO& io = ImGui::GetIO();
    if (dragged) {
        plane.s -= io.MouseDelta.x / canvas.pixelsPerUnit;
        plane.t += io.MouseDelta.y / canvas.pixelsPerUnit;
    }
    if (hovered && io.MouseWheel != 0) {
        // What is under the mouse stays there.
        const glm::vec2 fixed = canvas.toCoord(io.MousePos);
        const float extent =
            std::clamp(plane.extent * std::pow(0.9F, io.MouseWheel), nearestExtent, farthestExtent);
        const float factor = extent / plane.extent;
        plane.s = fixed.x + (plane.s - fixed.x) * factor;
        plane.t = fixed.y + (plane.t - fixed.y) * factor;
        plane.extent = extent;
    }
}

void fitPlane(Plane& plane, const TexCoords& coords) {
    const auto [low, high] = boundsOf(coords);
    plane.s = (low.x + high.x) / 2;
    plane.t = (low.y + high.y) / 2;
    plane.extent = std::clamp(std::max(high.x - low.x, high.y - low.y) * 1.4F, nearestExtent, farthestExtent);
}

/// Left button: takes the vertex under the mouse, or the plane. Any other button moves the plane.
void dragVertex(Session& session, TextureSpaceState& state, const Canvas& canvas,
                std::optional<std::size_t> under, bool dragged) {
    const ImGuiIO& io = ImGui::GetIO();
    Model& model = *selectedModel(session);
    const Mesh& mesh = selectedMesh(session);
    const int unit = session.window.selection.unit;
    std::optional<std::size_t>& chosen = session.window.selection.vertex;
    if (ImGui::IsItemActivated()) {
        state.movesVertex = ImGui::IsMouseClicked(ImGuiMouseButton_Left) && under.has_value();
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left))
            chosen = under;
    }
    if (dragged && state.movesVertex && chosen) {
        const std::string key = fmt::format("texCoords{}", unit);
        glm::vec4 moved = effectiveTexCoords(model, mesh, unit)[*chosen];
        const auto within = [](float coord) { return std::clamp(coord, coordRange.min, coordRange.max); };
        moved.x = within(moved.x + io.MouseDelta.x / canvas.pixelsPerUnit);
        moved.y = within(moved.y - io.MouseDelta.y / canvas.pixelsPerUnit);
        setTexCoord(model, mesh, unit, *chosen, moved);
        recordEdit(session, fmt::format("Move vertex {}", *chosen),
                   fmt::format("models[{}].{}", session.window.selection.model, key));
    }
    if (ImGui::IsItemDeactivated())
        sealEdit(session);
}

void drawCanvas(Session& session, TextureSpaceState& state, const Pictures& pictures) {
    const ImVec2 topLeft = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(1.0F, ImGui::GetContentRegionAvail().x),
                      std::max(1.0F, ImGui::GetContentRegionAvail().y));
    ImGui::InvisibleButton("canvas", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    noteItem("texture space");
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    const bool dragged = active && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0);
    const Canvas canvas(topLeft, size, session.window.plane);

    // A direction has no place in this plane: there is no vertex to show or to move.
    const bool isCube = selectedUnit(session).target == Target::CubeMap;
    const Model* model = isCube ? nullptr : selectedModel(session);
    const Mesh& mesh = selectedMesh(session);
    const auto current = [&] {
        return model ? effectiveTexCoords(*model, mesh, session.window.selection.unit) : TexCoords{};
    };
    TexCoords coords = current();
    std::optional<std::size_t> under;
    const bool onPatch = isOnPatch(session, canvas, io.MousePos);
    if (model && (hovered || active) && !onPatch)
        under = vertexUnder(canvas, mesh, coords, session.window.selection.vertex, io.MousePos,
                            ImGui::GetFontSize() * 0.55F);
    if (model && !onPatch)
        dragVertex(session, state, canvas, under, dragged);
    if (dragged && state.movesVertex)
        coords = current();
    if (under)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    moveCanvas(session.window.plane, canvas, hovered, dragged && !(model && state.movesVertex));
    if (hovered && !under && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        fitPlane(session.window.plane, coords);

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(canvas.low, canvas.high, true);
    draw.AddRectFilled(canvas.low, canvas.high, color::ground);
    const Texture* texture = boundTexture(std::as_const(session));
    const std::shared_ptr<const TextureImage> image =
        texture ? session.document.images.find(*texture) : nullptr;
    if (isCube && image && pictures.texture != view::PictureHandle::None)
        drawUnfolded(draw, canvas, *image, pictures.texture);
    else if (image && pictures.texture != view::PictureHandle::None)
        drawTiles(draw, canvas, *texture, image->surfaces.front(), pictures.texture, boundsOf(coords));
    if (!isCube) {
        drawAxes(draw, canvas);
        drawMesh(draw, canvas, mesh, coords, session.window.selection.vertex, under);
    }
    const bool clicked =
        hovered && !under && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
        io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] < io.MouseDragThreshold * io.MouseDragThreshold;
    drawTexelMarks(session, draw, canvas, clicked);
    draw.PopClipRect();
    for (std::size_t vertex = 0; arePlacesWanted() && vertex < coords.size(); ++vertex) {
        const ImVec2 at = canvas.toPixel(coords[vertex].x, coords[vertex].y);
        noteDrawn(fmt::format("coord:{}", vertex), at, at);
    }
}

/// "64 × 64", "6 faces of 128 × 128": as OpenGL has the image, whichever way it lies in its file.
std::string extentsOf(const TextureImage& image, Target target) {
    const Surface& first = image.surfaces.front();
    const auto [width, height] = target == Target::CubeMap && image.faces != cubeFaceCount
                                     ? cubeFaceExtents(widthOf(first), heightOf(first))
                                     : FaceExtents{widthOf(first), heightOf(first)};
    const std::string extents = fmt::format("{} × {}", width, height);
    return target == Target::CubeMap ? fmt::format("{} faces of {}", cubeFaceCount, extents) : extents;
}

} // namespace

void drawTextureSpacePanel(Session& session, TextureSpaceState& state, const Pictures& pictures,
                           const Layout& layout) {
    beginPanel("Texture space", layout.texture,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Texture space");
    const Texture* texture = boundTexture(std::as_const(session));
    const std::shared_ptr<const TextureImage> image =
        texture ? session.document.images.find(*texture) : nullptr;
    const std::string extents =
        image ? extentsOf(*image, selectedUnit(session).target) : std::string("no texture");
    const std::string what = fmt::format("unit {} · {}", session.window.selection.unit, extents);
    const float button = buttonWidth("Fit");
    ImGui::SameLine();
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(what.c_str()).x + button)
        ImGui::TextDisabled("%s", what.c_str());
    noteItem("texture size:" + extents);
    ImGui::SameLine(ImGui::GetContentRegionMax().x - button);
    if (ImGui::Button("Fit")) {
        const bool isCube = selectedUnit(session).target == Target::CubeMap;
        const Model* model = isCube ? nullptr : selectedModel(session);
        fitPlane(session.window.plane,
                 model ? effectiveTexCoords(*model, selectedMesh(session), session.window.selection.unit)
                       : TexCoords{});
    }
    noteItem("fit plane");
    helpTip("Shows the image and every vertex. Drag a vertex to move its coordinates, drag elsewhere to pan, "
            "turn the "
            "wheel to zoom.");
    drawCanvas(session, state, pictures);
    ImGui::End();
}

} // namespace texplorer::ui
