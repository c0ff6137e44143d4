#include "app/ui/camera.h"
#include "app/ui/panels.h"
#include "app/ui/param_widgets.h"
#include "app/ui/show.h"
#include "app/ui/theme.h"

#include <cmath>

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
        if (ImGui::Button(row.label) && !chosen) {
            showOnly(session.scene, row.show, session.playback.time, aspectOf(layout));
            sealEdit(session);
            recordEdit(session, std::string("Show ") + row.label);
            sealEdit(session);
        }
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
        if (pictures.drawOpaque)
            draw.AddCallback(pictures.drawOpaque, nullptr);
        // The picture's first row is its bottom one.
        draw.AddImage(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(pictures.scene.texture)),
                      origin, end, {0, 1}, {1, 0});
        if (pictures.drawOpaque)
            draw.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
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
    }
    draw.PopClipRect();
    hintLine(layout);
    ImGui::End();
}

} // namespace texplorer::ui
