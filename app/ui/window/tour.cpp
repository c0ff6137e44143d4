#include "app/ui/view/view_panel.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_tips.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_places.h"
#include "app/ui/window/dialog_parts.h"
#include "app/ui/window/window_parts.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

struct TourRow {
    Rect Layout::*about;
    const char* title;
    const char* text;
    const char* forFingers = nullptr; ///< if it is another one
};

constexpr std::array tourRows{
    TourRow{&Layout::parameters, N_("Change it here"),
            N_("Every setting of a texture has a row: filters, wrap modes, environment, coordinates. Drag "
               "numbers, click choices. Point at anything, and the lower edge of the window explains it."),
            N_("Every setting of a texture has a row: filters, wrap modes, environment, coordinates. Drag "
               "numbers, tap choices.")},
    TourRow{&Layout::view, N_("See it here"),
            N_("OpenGL draws the scene with these settings. Drag to turn it, use the wheel to move nearer, "
               "click a corner to select its vertex."),
            N_("OpenGL draws the scene with these settings. Drag to turn it, use two fingers to move nearer, "
               "tap a corner to select its vertex.")},
    TourRow{
        &Layout::texture, N_("Find the coordinates"),
        N_("The texture and the places of the vertices on it. Drag a vertex: beyond 0 and 1 the wrap mode "
           "decides what is shown.")},
    TourRow{&Layout::view, N_("Ask why"),
            N_("Hold E over a pixel: Explain shows every number between the scene and its colour, and the "
               "lower edge shows what the filter does there."),
            N_("Hold a finger on a pixel: Explain shows every number between the scene and its colour.")},
    TourRow{
        &Layout::menu, N_("Try, compare, undo"),
        N_("Presets change several settings at once. A/B keeps the scene and switches between then and now. "
           "Ctrl+Z undoes any edit, and F1 lists all keys."),
        N_("Presets change several settings at once. A/B keeps the scene and switches between then and now. "
           "Edit › Undo takes back any edit.")},
};
static_assert(tourRows.size() == tourSteps);

constexpr float tourWidth = 24; ///< of the card, in letters' heights

/// Next to the rectangle if there is room, else over it.
ImVec2 cardPlace(const Rect& about, const Rect& window, ImVec2 size, float gap) {
    const ImVec2 low = lowOf(about);
    const ImVec2 high = highOf(about);
    const ImVec2 whole = extentOf(window);
    ImVec2 place(low.x + gap, high.y + gap);
    if (about.height > window.height / 3) {
        place.y = low.y + (extentOf(about).y - size.y) / 2;
        place.x = high.x + gap + size.x <= whole.x ? high.x + gap
                  : low.x - gap - size.x >= 0      ? low.x - gap - size.x
                                                   : low.x + (extentOf(about).x - size.x) / 2;
    }
    return {std::clamp(place.x, gap, std::max(gap, whole.x - size.x - gap)),
            std::clamp(place.y, gap, std::max(gap, whole.y - size.y - gap))};
}

/// In the corner of the dock below, if it has room: the card then hides nothing that it mentions, its buttons
/// stay below the pointer, and the panel on the left and the view are next to it.
bool hasCorner(const Rect& dock, ImVec2 size) {
    return static_cast<float>(dock.width) >= size.x * 1.5F && static_cast<float>(dock.height) >= size.y;
}

/// Returns the step to go to; `tourSteps`: the tour ends.
std::optional<int> drawCard(int step, const char* title, const char* words, float width) {
    const float em = ImGui::GetFontSize();
    std::optional<int> wanted;
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    dimText(Sentence("{0} of {1}", step + 1, tourSteps));
    text(title);
    ImGui::Dummy({width, em * 0.2F});
    text(words);
    ImGui::PopTextWrapPos();
    ImGui::Dummy({0, em * 0.3F});
    const auto button = [&](const char* name, int leadsTo, bool enabled) {
        ImGui::BeginDisabled(!enabled);
        if (dialogButton(name, fmt::format("tour:{}", name)))
            wanted = leadsTo;
        ImGui::EndDisabled();
        ImGui::SameLine();
    };
    const bool last = step + 1 == tourSteps;
    button("Previous", step - 1, step > 0);
    button(last ? N_("Done") : N_("Next"), step + 1, true);
    if (!last)
        button("Skip", tourSteps, true);
    ImGui::NewLine();
    return wanted;
}

} // namespace

void drawTour(const Session& session, const Layout& layout, bool takesEscape) {
    const std::optional<int>& shown = session.window.tour;
    if (!shown || session.asking.dialog != Dialog::None)
        return;
    const int step = std::clamp(*shown, 0, tourSteps - 1);
    const TourRow& row = tourRows[static_cast<std::size_t>(step)];
    const Rect& about = (layout.*row.about).isEmpty() ? layout.window : layout.*row.about;
    const float em = ImGui::GetFontSize();
    ImGui::GetForegroundDrawList()->AddRect(lowOf(about) + ImVec2(1, 1), highOf(about) - ImVec2(1, 1),
                                            color::accent, 0, 0, em * 0.15F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {em, em * 0.8F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ImGui::GetStyleColorVec4(ImGuiCol_PopupBg));
    const float width = std::min(em * tourWidth, static_cast<float>(layout.window.width) - em * 4);
    const ImVec2 guess(width + em * 2, em * 11); // the size is known only after the first frame
    if (const Rect& dock = layout.belowDock; hasCorner(dock, guess))
        ImGui::SetNextWindowPos({static_cast<float>(dock.x) + em, static_cast<float>(dock.bottom()) - em},
                                ImGuiCond_Always, {0, 1});
    else
        ImGui::SetNextWindowPos(cardPlace(about, layout.window, guess, layout.isStacked ? em * 0.4F : em));
    std::optional<int> wanted;
    if (ImGui::Begin(N_("Tour"), nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                         ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings))
        wanted = drawCard(step, row.title,
                          row.forFingers && areHintsForFingers(session) ? row.forFingers : row.text, width);
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
    if (takesEscape && isKeyPressed(key::escape, false) && !session.out.keyTaken &&
        !ImGui::GetIO().WantTextInput) {
        session.out.keyTaken = true;
        wanted = tourSteps;
    }
    if (wanted && *wanted < tourSteps)
        act(session, [wanted](Session& changed) { changed.window.tour = wanted; });
    else if (wanted)
        act(session, [](Session& changed) {
            changed.window.tour.reset();
            changed.settings.hasSeenTour = true;
        });
}

} // namespace texplorer::ui
