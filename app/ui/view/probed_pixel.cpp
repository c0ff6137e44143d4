#include "app/ui/model/explaining.h"
#include "app/ui/view/pane_drawing.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_widgets.h"

#include <algorithm>

namespace texplorer::ui {

void probeWithMouse(const Session& session, const Panes& panes, bool hovered, bool clicked) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool held = hovered && isKeyDown('E') && !io.WantTextInput && !io.KeyCtrl && !session.out.keyTaken;
    if (!held && !(clicked && session.look.explaining.isOpen))
        return;
    if (const auto pixel = panes.pixelAt(io.MousePos))
        act(session, [to = reference::PixelPlace{pixel->x, pixel->y}](Session& changed) {
            changed.look.explaining.pixel = to;
        });
    if (held && !session.look.explaining.isOpen)
        act(session, [](Session& changed) { changed.window.wantedTab = Tab::Explain; });
}

void drawProbedPixel(const Session& session, const Pictures& pictures, const Panes& panes, const Pane& pane) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Explaining& asked = session.look.explaining;
    if (asked.texel && asked.light) {
        if (const view::PictureHandle light = pictures.show(asked.light); light != view::PictureHandle::None)
            panes.draw(draw, pane, light, color::probed);
    }
    if (const reference::Explanation* pinned = pinnedExplanation(session)) {
        const ImVec2 at = panes.toWindow(pane, glm::vec2(pinned->pixel.x, pinned->pixel.y) + 0.5F);
        const float radius = ImGui::GetFontSize() * 0.4F;
        draw.AddCircle(at, radius, color::shade, 0, radius * 0.7F);
        draw.AddCircle(at, radius, color::probed, 0, radius * 0.3F);
        noteDrawn(N_("pinned pixel"), at, at);
    }
    if (!asked.pixel)
        return;
    const auto corner = [&](int dx, int dy) {
        return panes.toWindow(pane, glm::vec2(static_cast<float>(asked.pixel->x + dx),
                                              static_cast<float>(asked.pixel->y + dy)));
    };
    const ImVec2 low = corner(0, 1); // the upper left
    const ImVec2 high = corner(1, 0);
    const ImVec2 middle((low.x + high.x) / 2, (low.y + high.y) / 2);
    const float em = ImGui::GetFontSize();
    const float half = std::max((high.x - low.x) / 2, em * 0.22F) + 1;
    for (const auto& [tint, width] :
         {std::pair(color::shade, em * 0.26F), std::pair(color::probed, em * 0.12F)}) {
        draw.AddRect({middle.x - half, middle.y - half}, {middle.x + half, middle.y + half}, tint, 0, 0,
                     width);
        const float far = half + em * 0.55F;
        draw.AddLine({middle.x - far, middle.y}, {middle.x - half, middle.y}, tint, width);
        draw.AddLine({middle.x + half, middle.y}, {middle.x + far, middle.y}, tint, width);
        draw.AddLine({middle.x, middle.y - far}, {middle.x, middle.y - half}, tint, width);
        draw.AddLine({middle.x, middle.y + half}, {middle.x, middle.y + far}, tint, width);
    }
    noteDrawn(N_("explained pixel"), middle, middle);
}

} // namespace texplorer::ui
