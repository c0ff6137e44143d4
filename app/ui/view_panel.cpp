#include "app/ui/camera.h"
#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"
#include "app/ui/show.h"
#include "app/ui/theme.h"
#include "core/scene/picking.h"
#include "core/scene/tex_coords.h"

#include <cmath>
#include <cstdio>

namespace texplorer::ui {
namespace {

constexpr const char* cameraEdit = "Move camera"; // never sealed: looking around is one step of undo

float aspectOf(const Layout& layout) {
    return static_cast<float>(layout.picture.width) / static_cast<float>(std::max(1, layout.picture.height));
}

void toolRow(Session& session, const Layout& layout) {
    ImGui::SetCursorPos(
        {ImGui::GetStyle().WindowPadding.x,
         (static_cast<float>(layout.picture.y - layout.view.y) - ImGui::GetFrameHeight()) / 2});
    const auto shown = shownNow(session.scene);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    const auto room = [](const char* label) {
        return ImGui::GetContentRegionAvail().x >=
               ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
    };
    for (std::size_t i = 0; i < showRows.size(); ++i) {
        const ShowRow& row = showRows[i];
        if (i > 0)
            ImGui::SameLine(0, gap);
        if (!room(row.label))
            return; // the View menu has them all
        const bool chosen = shown == row.show;
        ImGui::PushStyleColor(ImGuiCol_Button,
                              chosen ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : IM_COL32(0, 0, 0, 0));
        if (ImGui::Button(row.label) && !chosen)
            show(session, row, layout);
        ImGui::PopStyleColor();
        noteItem(session, std::string("show:") + row.label);
    }
    const char* frame = "Frame";
    const float width = ImGui::CalcTextSize(frame).x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::SameLine(0, gap);
    if (!room(frame))
        return;
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
    if (ImGui::Button(frame))
        frameAll(session, layout);
    noteItem(session, "frame");
    helpTip("Aims the camera so that every model is whole (F, or a double click)");
}

void moveCamera(Session& session, bool hovered, bool active, const Layout& layout) {
    const ImGuiIO& io = ImGui::GetIO();
    View& view = session.scene.view;
    const View before = view;
    if (active && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0)) {
        const bool left = ImGui::IsMouseDragging(ImGuiMouseButton_Left);
        const bool sideways = ImGui::IsMouseDragging(ImGuiMouseButton_Right) ||
                              ImGui::IsMouseDragging(ImGuiMouseButton_Middle) || (left && io.KeyShift);
        if (sideways)
            pan(view, io.MouseDelta.x, io.MouseDelta.y, static_cast<float>(layout.picture.height));
        else if (left)
            orbit(view, io.MouseDelta.x, io.MouseDelta.y);
    }
    if (hovered && io.MouseWheel != 0)
        zoom(view, io.MouseWheel);
    if (view != before)
        recordEdit(session, cameraEdit);
}

void drawMarker(Session& session, const Layout& layout, ImVec2 origin) {
    const Model* model = selectedModel(session);
    if (!model || !model->visible || !session.selection.vertex)
        return;
    const std::size_t vertex = *session.selection.vertex;
    const auto place = projectVertex(session.scene, static_cast<std::size_t>(session.selection.model), vertex,
                                     session.playback.time, aspectOf(layout));
    if (!place)
        return;
    const float em = ImGui::GetFontSize();
    const ImVec2 at(origin.x + place->x * static_cast<float>(layout.picture.width),
                    origin.y + place->y * static_cast<float>(layout.picture.height));
    if (session.probe)
        session.probe->items["marker"] = {at.x, at.y, at.x, at.y, true};
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddCircle(at, em * 0.45F, color::shade, 0, em * 0.3F);
    draw.AddCircle(at, em * 0.45F, color::chosen, 0, em * 0.15F);
    draw.AddCircleFilled(at, em * 0.12F, color::chosen);

    const TexCoords coords = effectiveTexCoords(*model, selectedMesh(session), session.selection.unit);
    if (vertex >= coords.size())
        return;
    char text[96];
    std::snprintf(text, sizeof text, "%zu   (%.2f, %.2f)", vertex, double{coords[vertex].x},
                  double{coords[vertex].y});
    const ImVec2 size = ImGui::CalcTextSize(text);
    // Beside the vertex, inside of the picture.
    ImVec2 label(at.x + em * 0.9F, at.y - size.y - em * 0.5F);
    label.x = std::min(label.x, origin.x + static_cast<float>(layout.picture.width) - size.x - em * 0.5F);
    label.y = std::max(label.y, origin.y + em * 0.4F);
    const float pad = em * 0.3F;
    draw.AddRectFilled({label.x - pad, label.y - pad / 2},
                       {label.x + size.x + pad, label.y + size.y + pad / 2}, color::shade, pad);
    draw.AddText(label, color::chosen, text);
}

void hintLine(const Layout& layout) {
    const float em = ImGui::GetFontSize();
    const float height = static_cast<float>(layout.view.bottom() - layout.picture.bottom());
    constexpr const char* hints[] = {
        "Drag: orbit  ·  Right drag: pan  ·  Wheel: zoom  ·  Click: pick a vertex  ·  Double click: frame",
        "Drag: orbit  ·  Right drag: pan  ·  Wheel: zoom  ·  Click: pick",
        "Drag: orbit  ·  Wheel: zoom",
    };
    for (const char* hint : hints) {
        const float width = ImGui::CalcTextSize(hint).x;
        if (width > static_cast<float>(layout.view.width) - em)
            continue;
        ImGui::SetCursorPos(
            {(static_cast<float>(layout.view.width) - width) / 2,
             static_cast<float>(layout.picture.bottom() - layout.view.y) + (height - em) / 2});
        ImGui::TextDisabled("%s", hint);
        return;
    }
}

} // namespace

void drawViewPanel(Session& session, const Pictures& pictures, const Layout& layout) {
    beginPanel("View", layout.view, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    toolRow(session, layout);

    const ImVec2 origin(static_cast<float>(layout.picture.x), static_cast<float>(layout.picture.y));
    const ImVec2 size(static_cast<float>(layout.picture.width), static_cast<float>(layout.picture.height));
    const ImVec2 end(origin.x + size.x, origin.y + size.y);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.PushClipRect(origin, end, false);
    draw.AddRectFilled(origin, end, color::ground);
    if (pictures.scene.texture != 0) {
        if (pictures.setBlending)
            draw.AddCallback(pictures.setBlending, nullptr);
        // The picture's first row is its bottom one.
        draw.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(pictures.scene.texture)),
                      origin, end, {0, 1}, {1, 0});
        if (pictures.setBlending)
            draw.AddCallback(pictures.setBlending, &draw);
    }

    ImGui::SetCursorScreenPos(origin);
    ImGui::InvisibleButton("picture", size,
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    noteItem(session, "view");
    const bool hovered = ImGui::IsItemHovered();
    const bool active = ImGui::IsItemActive();
    moveCamera(session, hovered, active, layout);
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        frameAll(session, layout);
    } else if (ImGui::IsItemDeactivated() && ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
               ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] <
                   ImGui::GetIO().MouseDragThreshold * ImGui::GetIO().MouseDragThreshold) {
        const ImVec2 mouse = ImGui::GetIO().MousePos;
        const auto picked = pickVertex(session.scene, session.playback.time, aspectOf(layout),
                                       {(mouse.x - origin.x) / size.x, (mouse.y - origin.y) / size.y});
        if (picked) {
            session.selection.model = static_cast<int>(picked->model);
            session.selection.vertex = picked->vertex;
        } else {
            session.selection.vertex.reset();
        }
    }
    drawMarker(session, layout, origin);
    draw.PopClipRect();
    hintLine(layout);
    ImGui::End();
}

} // namespace texplorer::ui
