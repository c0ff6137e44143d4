#include "app/ui/model/timeline_edits.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/window/window_parts.h"
#include "texplorer/scene/animation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace texplorer::ui {
namespace {

constexpr float stepSeconds = 0.1F;
constexpr float scrubSeconds = 10; // the range of the slider, unless the time has gone further
// In widths of a letter m.
constexpr float maxSliderWidth = 11;
constexpr float minSliderWidth = 4.5F;
constexpr float speedText = 1.97F;
constexpr float speeds[] = {0.1F, 0.25F, 0.5F, 1, 2, 4};

/// A square button whose sign is drawn, so that it is sharp and centred at every scale.
bool signButton(const char* name, bool enabled,
                void (*sign)(ImDrawList& draw, ImVec2 centre, float radius, ImU32 tint)) {
    const float side = ImGui::GetFrameHeight();
    ImGui::BeginDisabled(!enabled);
    const bool pressed = flatButton((std::string("##") + name).c_str(), false, {side * 1.2F, side});
    ImGui::EndDisabled();
    noteItem(name);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    sign(*ImGui::GetWindowDrawList(), {(low.x + high.x) / 2, (low.y + high.y) / 2}, side * 0.22F,
         enabled ? color::text : color::dim);
    return pressed;
}

void playSign(ImDrawList& draw, ImVec2 c, float r, ImU32 tint) {
    draw.AddTriangleFilled({c.x - 0.8F * r, c.y - r}, {c.x - 0.8F * r, c.y + r}, {c.x + r, c.y}, tint);
}

void pauseSign(ImDrawList& draw, ImVec2 c, float r, ImU32 tint) {
    draw.AddRectFilled({c.x - 0.85F * r, c.y - r}, {c.x - 0.25F * r, c.y + r}, tint);
    draw.AddRectFilled({c.x + 0.25F * r, c.y - r}, {c.x + 0.85F * r, c.y + r}, tint);
}

void stepSign(ImDrawList& draw, ImVec2 c, float r, ImU32 tint) {
    draw.AddTriangleFilled({c.x - r, c.y - r}, {c.x - r, c.y + r}, {c.x + 0.5F * r, c.y}, tint);
    draw.AddRectFilled({c.x + 0.6F * r, c.y - r}, {c.x + 1.1F * r, c.y + r}, tint);
}

void rewindSign(ImDrawList& draw, ImVec2 c, float r, ImU32 tint) {
    draw.AddTriangleFilled({c.x + r, c.y - r}, {c.x + r, c.y + r}, {c.x - 0.5F * r, c.y}, tint);
    draw.AddRectFilled({c.x - 1.1F * r, c.y - r}, {c.x - 0.6F * r, c.y + r}, tint);
}

void keysSign(ImDrawList& draw, ImVec2 c, float r, ImU32 tint) {
    draw.AddQuadFilled({c.x, c.y - 1.15F * r}, {c.x + 1.15F * r, c.y}, {c.x, c.y + 1.15F * r},
                       {c.x - 1.15F * r, c.y}, tint);
}

/// Marks the key frames on the last widget, a slider from 0 to `end`.
void markKeys(const Session& session, float end) {
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    const float em = ImGui::GetFontSize();
    const float inset = 2 + ImGui::GetStyle().GrabMinSize / 2; // as in Dear ImGui's sliders
    const float mark = std::max(1.0F, std::floor(em / 10));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (const KeyFrame& key : session.document.scene.timeline.keys) {
        if (key.time > end)
            continue;
        const float x = std::floor(low.x + inset + (high.x - low.x - 2 * inset) * key.time / end);
        draw.AddRectFilled({x - mark / 2, high.y - em * 0.28F}, {x + mark / 2, high.y}, color::accent);
    }
}

float speedWidth() {
    return ImGui::GetFontSize() * speedText + ImGui::GetFrameHeight() + 2 * ImGui::GetStyle().FramePadding.x;
}

/// The width of all controls.
float widthWith(float slider) {
    const float em = ImGui::GetFontSize();
    const float button = ImGui::GetFrameHeight() * 1.2F;
    return 4 * button + 2 * em + slider + speedWidth() + 4 * ImGui::GetStyle().ItemInnerSpacing.x;
}

std::string speedName(float speed) {
    return fmt::format("{:g}×", speed);
}

} // namespace

float minPlaybackWidth() {
    return widthWith(ImGui::GetFontSize() * minSliderWidth);
}

float playbackButtonsWidth() {
    return 3 * ImGui::GetFrameHeight() * 1.2F + ImGui::GetFontSize();
}

void drawPlaybackControls(const Session& session) {
    const Playback& playback = session.look.playback;
    const float em = ImGui::GetFontSize();
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float available = ImGui::GetContentRegionMax().x - ImGui::GetCursorPosX();
    if (playbackButtonsWidth() > available)
        return; // a very narrow window keeps its menus; Space still plays
    const bool hasClock = minPlaybackWidth() <= available;
    const float widest = em * maxSliderWidth;
    const float slider = std::min(widest, widest - (widthWith(widest) - available));
    ImGui::SetCursorPos(
        {ImGui::GetContentRegionMax().x - (hasClock ? widthWith(slider) : playbackButtonsWidth()) + em,
         (ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) / 2});

    const bool animated = isAnimated(session.document.scene);
    if (signButton("rewind", playback.time != 0, rewindSign))
        act(session, [](Session& changed) { changed.look.playback.time = 0; });
    helpTip("Go to time 0");
    ImGui::SameLine(0, 0);
    const bool running = playback.playing && animated;
    if (signButton("play", animated, running ? pauseSign : playSign))
        act(session,
            [](Session& changed) { changed.look.playback.playing = !changed.look.playback.playing; });
    helpTip(!animated          ? "Nothing moves. Add a rate, a spin or key frames."
            : playback.playing ? N_("Pause (Space)")
                               : N_("Play (Space)"));
    ImGui::SameLine(0, 0);
    if (signButton("step", true, stepSign))
        act(session, [](Session& changed) {
            changed.look.playback.playing = false;
            changed.look.playback.time += static_cast<double>(stepSeconds);
        });
    helpTip("Pause and advance by 0.1 s");
    if (!hasClock)
        return;

    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(slider);
    auto shown = static_cast<float>(playback.time);
    const float last = std::max(shown, static_cast<float>(lengthOf(session.document.scene.timeline)));
    const float end = std::max(scrubSeconds, std::ceil(last / scrubSeconds) * scrubSeconds);
    if (ImGui::SliderFloat("##time", &shown, 0, end, secondsFormat().c_str(), ImGuiSliderFlags_AlwaysClamp))
        act(session, [shown](Session& s) { goToTime(s, static_cast<double>(shown)); });
    noteItem("time");
    markKeys(session, end);
    helpTip("The scene's time. Drag to change it.");

    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(speedWidth());
    if (beginCombo("##speed", speedName(playback.speed).c_str())) {
        for (const float speed : speeds) {
            if (ImGui::Selectable(speedName(speed).c_str(), speed == playback.speed))
                act(session, [speed](Session& changed) { changed.look.playback.speed = speed; });
            noteItem("speed:" + speedName(speed));
        }
        endCombo();
    }
    item("speed", "The speed of the scene's time");
    ImGui::SameLine(0, gap);
    if (signButton("timeline", true, keysSign))
        act(session, [](Session& changed) { changed.window.wantedTab = Tab::Timeline; });
    helpTip("Timeline: shows which parameters move and when");
}

} // namespace texplorer::ui
