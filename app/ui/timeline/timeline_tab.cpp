// The tab "Timeline": the key frames of the scene's parameters.

#include "app/ui/timeline/timeline_tab.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_place.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/scene/params/param_text.h"
#include "texplorer/scene/params/params.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace texplorer::ui {
namespace {

constexpr const char* recordWords = N_("Record animation…");
constexpr std::array grids{0.0F, 0.05F, 0.1F, 0.25F, 0.5F, 1.0F};

/// Puts the next item of this width on the same line, or on the next one if there is no room.
void besideOrBelow(float width) {
    ImGui::SameLine(0, ImGui::GetFontSize() * 0.8F);
    if (ImGui::GetContentRegionAvail().x < width)
        ImGui::NewLine();
}

/// Deselects a key that was removed, by undo or otherwise.
void followChosen(const Session& session, TimelineTabState& state) {
    const std::vector<KeyFrame>& keys = presentScene(session).timeline.keys;
    if (state.chosen &&
        (state.chosen->number >= keys.size() || keys[state.chosen->number].path != state.chosen->path))
        state.chosen.reset();
}

std::string nameOfGrid(float grid) {
    return tr(grid > 0 ? Sentence("{0:g} s", grid) : "no grid");
}

void gridChoice(TimelineTabState& state) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 6);
    const bool open = beginCombo("##grid", nameOfGrid(state.grid).c_str());
    item("timeline:grid", "Dragging snaps to multiples of this.");
    if (!open)
        return;
    for (const float grid : grids) {
        if (ImGui::Selectable(nameOfGrid(grid).c_str(), grid == state.grid))
            state.grid = grid;
        noteItem(fmt::format("timeline grid:{:g}", grid));
    }
    endCombo();
}

void timeControls(const Session& session, TimelineTabState& state) {
    const Timeline& timeline = presentScene(session).timeline;
    if (squareButton("◀", "timeline:previous", "Go to the previous key frame (,)", !timeline.keys.empty()))
        act(session, [](Session& s) { goToKey(s, -1); });
    ImGui::SameLine(0, 1);
    if (squareButton("▶", "timeline:next", "Go to the next key frame (.)", !timeline.keys.empty()))
        act(session, [](Session& s) { goToKey(s, 1); });
    ImGui::SameLine(0, ImGui::GetFontSize() * 0.8F);
    labelText(Sentence("{0:.2f} of {1:.2f} s", session.look.playback.time, lengthOf(timeline)));
    item("timeline:time", "The scene's time and the time of the last key frame");
    besideOrBelow(ImGui::GetFontSize() * 4);
    bool loops = session.look.playback.loops;
    if (ImGui::Checkbox(label("Loop"), &loops))
        act(session, [loops](Session& changed) { changed.look.playback.loops = loops; });
    item("timeline:loop", "Time restarts after the last key frame.");
    besideOrBelow(ImGui::GetFontSize() * 6);
    gridChoice(state);
    besideOrBelow(buttonWidth(recordWords));
    if (button(recordWords, "timeline:record", "Writes an animation as GIF, WebP or PNG, in the background."))
        act(session, [](Session& changed) { changed.asking.dialog = Dialog::Record; });
}

/// A hint how to begin, with buttons.
void drawBeginning(const Session& session) {
    dimWrappedText(
        N_("There are no key frames yet. Select a time, right-click a parameter and add one. The parameter "
           "moves from each key frame to the next."));
    noteItem("timeline:empty");
    ImGui::Spacing();
    if (button("Turn the view", "timeline:turn",
               "An example: two key frames move the camera once around the models in 4 seconds."))
        act(session, turnView);
}

void easingChoice(const Session& session, const TimelineTabState::ChosenKey& chosen, const KeyFrame& key) {
    const EnumRow& now = rowOf(key.easing);
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 10);
    const bool open = beginCombo("##easing", tr(now.label).c_str());
    item("key:easing",
         Sentence("{0}\n{1}", N_("How the value changes from this key to the next one."), now.help));
    if (!open)
        return;
    for (const EnumRow& row : EnumTable<Easing>::rows) {
        if (ImGui::Selectable(label(row.label).c_str(), &row == &now))
            setEasing(session, chosen.number, static_cast<Easing>(row.value));
        item(fmt::format("easing:{}", row.name), row.help);
    }
    endCombo();
}

void timeOfKey(const Session& session, const TimelineTabState::ChosenKey& chosen, float time) {
    ImGui::SetNextItemWidth(ImGui::GetFontSize() * 5);
    float wanted = time;
    if (dragFloat("##time", wanted, 0.01F, 0, maxKeyTime, secondsFormat().c_str()) &&
        moveKey(session, chosen.number, snapped(wanted, 0)))
        requestTime(session, snapped(wanted, 0));
    markDraggable();
    sealAfterItem(session);
    item("key:time",
         "The time at which the parameter has this value. Drag it, or double-click to type a number.");
}

float valueWidth(const ParamRow& row) {
    return ImGui::GetFontSize() * (row.kind == Kind::Float || row.kind == Kind::Int ? 7.0F : 14.0F);
}

/// Edits the value of the key at the present time with the parameter's own control.
void valueOfKey(const Session& session, const KeyFrame& key, const ParamRow& row) {
    std::optional<ParamPlace> place = placeOf(presentScene(session), key.path);
    const bool isNow = key.time == presentKeyTime(session) && !session.look.playback.playing;
    if (!isNow || !place || place->vertex || isList(row.kind) || row.kind == Kind::Matrix) {
        labelText(wordsOfValue(session.settings, row, key.value), color::dim);
        noteItem("key:value");
        return;
    }
    place->owner.initial = place->owner.values;
    paramControl(session, place->owner, row, std::min(valueWidth(row), ImGui::GetContentRegionAvail().x));
}

void keyControls(const Session& session, TimelineTabState& state) {
    const float em = ImGui::GetFontSize();
    const TimelineTabState::ChosenKey chosen = *state.chosen;
    const KeyFrame key = presentScene(session).timeline.keys[chosen.number];
    const auto row = rowAt(presentScene(session), key.path);
    if (!row)
        return;
    labelText(shownName(session.settings, **row));
    helpTip(ProperName{key.path});
    besideOrBelow(em * 5);
    timeOfKey(session, chosen, key.time);
    besideOrBelow(valueWidth(**row));
    valueOfKey(session, key, **row);
    besideOrBelow(em * 10);
    easingChoice(session, chosen, key);
    besideOrBelow(buttonWidth(N_("Remove")));
    if (button("Remove", "key:remove", "Removes this key frame (Delete).")) {
        removeKey(session, chosen.number);
        state.chosen.reset();
    }
}

void takeKeys(const Session& session, TimelineTabState& state) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!state.chosen || io.WantTextInput || session.out.keyTaken ||
        !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows))
        return;
    const std::size_t number = state.chosen->number;
    const bool walks = (io.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0;
    const int way = walks ? 0 : isKeyPressed(key::right) ? 1 : isKeyPressed(key::left) ? -1 : 0;
    if (isKeyPressed(key::del, false)) {
        removeKey(session, number);
        state.chosen.reset();
    } else if (way != 0) {
        const float time = presentScene(session).timeline.keys[number].time;
        const float step = state.grid > 0 ? state.grid : 0.01F;
        const float wanted = std::clamp(snapped(time + static_cast<float>(way) * step, 0), 0.0F, maxKeyTime);
        if (moveKey(session, number, wanted))
            requestTime(session, wanted);
        sealEdit(session);
    } else {
        return;
    }
    session.out.keyTaken = true;
}

} // namespace

void drawTimelineTab(const Session& session, TimelineTabState& state) {
    followChosen(session, state);
    timeControls(session, state);
    if (presentScene(session).timeline.keys.empty()) {
        state.chosen.reset();
        return drawBeginning(session);
    }
    if (state.chosen) {
        keyControls(session, state);
    } else {
        constexpr const char* words = N_("Click a key frame to change it. Editing a parameter that has key "
                                         "frames adds one at this time.");
        ImGui::AlignTextToFramePadding();
        if (fittedText(words, color::dim))
            helpTip(words);
    }
    followChosen(session, state);
    if (!presentScene(session).timeline.keys.empty())
        drawTracks(session, state);
    takeKeys(session, state);
    followChosen(session, state);
}

} // namespace texplorer::ui
