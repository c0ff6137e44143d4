#include "app/ui/language/translate.h"
#include "app/ui/model/findings.h"
#include "app/ui/model/timeline_edits.h"
#include "app/ui/timeline/timeline_tab.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/translatable.h"
#include "texplorer/scene/params/params.h"
#include "texplorer/scene/params/value_mix.h"
#include "texplorer/text/printable.h"

#include <fmt/core.h>
#include <imgui_internal.h> // whether the focus rectangle is shown

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <ranges>
#include <string_view>
#include <vector>

namespace texplorer::ui {
namespace {

constexpr std::size_t maxValueBytes = 64; // of a drawn text, in bytes

/// The layout of the rows, in pixels.
struct TrackPlan {
    TimeScale scale;
    float names = 0;  ///< the width of the names' column
    float height = 1; ///< of a row
    float key = 1;    ///< half of a diamond's size
};

TrackPlan planTracks(const Session& session, const TimelineTabState& state) {
    const float em = ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ScrollbarSize;
    TrackPlan plan;
    plan.names = std::floor(std::min(em * 18, room * 0.36F));
    plan.height = std::max(std::floor(em * 1.75F), targetHeight());
    plan.key = std::max(std::floor(em * 0.42F), targetHeight() / 4);
    const Timeline& timeline = presentScene(session).timeline;
    plan.scale.left = ImGui::GetCursorScreenPos().x + plan.names + 2 * plan.key;
    plan.scale.width = std::max(em, room - plan.names - 4 * plan.key);
    plan.scale.seconds = state.seconds.value_or(secondsFor(lengthOf(timeline), session.look.playback.time));
    return plan;
}

/// The mouse moves the time until the button is released.
void scrub(const Session& session, TimelineTabState& state, const TimeScale& scale) {
    if (ImGui::IsItemActivated())
        state.seconds = scale.seconds;
    if (ImGui::IsItemActive())
        requestTime(session, snapped(scale.timeAt(ImGui::GetIO().MousePos.x), state.grid));
    if (ImGui::IsItemDeactivated())
        state.seconds.reset();
}

void drawPresent(ImDrawList& draw, const Session& session, const TimeScale& scale, float top, float bottom) {
    const double time = session.look.playback.time;
    if (time > static_cast<double>(scale.seconds))
        return;
    const float x = std::floor(scale.xOf(time)) + 0.5F;
    draw.AddLine({x, top}, {x, bottom}, color::accent, std::max(1.0F, std::floor(ImGui::GetFontSize() / 10)));
}

void ruler(const Session& session, TimelineTabState& state, const TrackPlan& plan) {
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float height = std::max(std::floor(ImGui::GetFontSize() * 1.35F), targetHeight());
    ImGui::SetCursorScreenPos({low.x + plan.names, low.y});
    ImGui::InvisibleButton("ruler", {plan.scale.width + 4 * plan.key, height});
    noteItem("timeline:ruler");
    scrub(session, state, plan.scale);
    helpTip("The scene's time. Drag to change it.");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    drawRuler(draw, plan.scale, low.y, height);
    drawPresent(draw, session, plan.scale, low.y, low.y + height);
    ImGui::SetCursorScreenPos({low.x, low.y + height});
}

void drawDiamond(ImDrawList& draw, ImVec2 at, float radius, ImU32 ink) {
    draw.AddQuadFilled({at.x, at.y - radius}, {at.x + radius, at.y}, {at.x, at.y + radius},
                       {at.x - radius, at.y}, ink);
}

void keyMenu(const Session& session, std::size_t number, const KeyFrame& key) {
    if (!beginPopup("keymenu"))
        return;
    dimText(Sentence("{0:.2f} s", key.time));
    ImGui::Separator();
    for (const EnumRow& row : EnumTable<Easing>::rows) {
        const auto easing = static_cast<Easing>(row.value);
        if (ImGui::MenuItem(label(row.label).c_str(), nullptr, key.easing == easing))
            setEasing(session, number, easing);
        item(fmt::format("key menu:{}", row.name), row.help);
    }
    ImGui::Separator();
    if (ImGui::MenuItem(label("Remove this key frame"), tr("Delete")))
        removeKey(session, number);
    noteItem("key menu:remove");
    endPopup();
}

/// Draws a key and handles the mouse on it; `room` is the space for its value on the right.
void drawKey(const Session& session, TimelineTabState& state, const TrackPlan& plan, const ParamRow& row,
             const KeyFrame& key, ImVec2 at, float room) {
    const auto number = static_cast<std::size_t>(&key - presentScene(session).timeline.keys.data());
    ImGui::PushID(static_cast<int>(number));
    ImGui::SetCursorScreenPos({at.x - plan.key, at.y - plan.height / 2});
    ImGui::InvisibleButton("key", {2 * plan.key, plan.height});
    noteItem(fmt::format("key:{}@{:g}", key.path, key.time));
    const bool isFocused = ImGui::IsItemFocused() && !ImGui::GetCurrentContext()->NavDisableHighlight;
    const bool isHovered = ImGui::IsItemHovered() || ImGui::IsItemActive();
    const Sentence words = wordsOfValue(session.settings, row, key.value);
    helpTip(Sentence("{0:.2f} s: {1}, {2}. Drag: move it. Right click: more.", key.time, words,
                     rowOf(key.easing).label));
    if (isHovered)
        ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    const bool asksMenu = ImGui::IsItemClicked(ImGuiMouseButton_Right) || isMenuAsked();
    if (ImGui::IsItemActivated() || asksMenu) {
        sealEdit(session);
        state.grabbed = key.time;
        state.seconds = plan.scale.seconds;
        state.chosen = {number, key.path};
        requestTime(session, key.time);
    }
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        const float way = plan.scale.secondsOf(ImGui::GetMouseDragDelta(ImGuiMouseButton_Left).x);
        const float wanted = snapped(std::clamp(state.grabbed + way, 0.0F, plan.scale.seconds), state.grid);
        if (moveKey(session, number, wanted))
            requestTime(session, wanted);
    }
    if (ImGui::IsItemDeactivated()) {
        state.seconds.reset();
        sealEdit(session);
    }
    if (asksMenu) {
        state.seconds.reset();
        ImGui::OpenPopup("keymenu");
    }
    keyMenu(session, number, key);
    ImGui::PopID();

    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const bool isChosen = state.chosen && state.chosen->number == number;
    if (isChosen || isFocused)
        drawDiamond(draw, at, plan.key * 1.45F, isChosen ? color::text : color::accent);
    if (isChosen)
        drawDiamond(draw, at, plan.key * 1.15F, color::panel);
    const bool isNow = std::abs(static_cast<double>(key.time) - session.look.playback.time) < 0.005;
    drawDiamond(draw, at, plan.key * 0.85F, isNow || isHovered ? color::accent : color::text);
    const float em = ImGui::GetFontSize();
    if (room > em * 1.5F) {
        const float size = em * 0.85F;
        const std::string shown = fitted(words, room / 0.85F);
        const ImVec2 low(at.x + plan.key * 1.8F, std::floor(at.y - size * 0.6F));
        const float width = ImGui::GetFont()->CalcTextSizeA(size, 1e6F, 0, shown.c_str()).x;
        draw.AddRectFilled({low.x - em * 0.2F, low.y}, {low.x + width + em * 0.2F, low.y + size},
                           color::ground); // the connection to the next key passes behind it
        draw.AddText(ImGui::GetFont(), size, low, color::dim, shown.c_str());
    }
}

/// The connection from a key to the next: none if both have the same value, steps if it jumps.
void drawWay(ImDrawList& draw, const ParamRow& row, const KeyFrame& from, const KeyFrame& to, ImVec2 begin,
             ImVec2 end) {
    const float em = ImGui::GetFontSize();
    if (from.value == to.value)
        return;
    const float line = std::max(1.0F, std::floor(em / 10));
    if (from.easing != Easing::Hold && canMix(row))
        return draw.AddLine(begin, end, color::outline, line);
    for (float x = begin.x; x < end.x; x += em * 0.5F)
        draw.AddLine({x, begin.y}, {std::min(end.x, x + em * 0.15F), begin.y}, color::outline, line);
}

void trackName(const Session& session, const TrackPlan& plan, const std::string& path, const ParamRow& row,
               const Sentence& name) {
    const float em = ImGui::GetFontSize();
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float width = plan.names - em * 0.5F;
    if (ImGui::InvisibleButton("name", {width, plan.height}))
        act(session, [path](Session& s) { reveal(s, path); });
    noteItem("track:" + path);
    const bool isHovered = ImGui::IsItemHovered();
    if (isHovered)
        ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    helpTip(Sentence("{0}\nClick: show the setting", ProperName{path}));
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right) || isMenuAsked())
        ImGui::OpenPopup("trackmenu");
    if (beginPopup("trackmenu")) {
        dimPlainText(path);
        ImGui::Separator();
        if (ImGui::MenuItem(label("Remove its key frames")))
            removeKeys(session, path);
        item("track menu:remove", "The parameter keeps its present value.");
        endPopup();
    }
    const Result<std::string> now = getParam(presentScene(session), path);
    const std::string value =
        fitted(now ? wordsOfValue(session.settings, row, *now) : Sentence(), width * 0.45F);
    const float valueWidth = ImGui::CalcTextSize(value.c_str()).x;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float top = low.y + (plan.height - em) / 2;
    draw.AddText({low.x, top}, isHovered ? color::accent : color::text,
                 fitted(name, width - valueWidth - em * 0.6F).c_str());
    draw.AddText({low.x + width - valueWidth, top}, color::dim, value.c_str());
    ImGui::SetCursorScreenPos({low.x + plan.names, low.y});
}

void drawTrack(const Session& session, TimelineTabState& state, const TrackPlan& plan, const Track& track,
               const Sentence& name) {
    const Scene& scene = presentScene(session);
    const auto row = rowAt(scene, track.path);
    if (!row)
        return; // it was removed
    const std::string path(track.path);
    ImGui::PushID(path.c_str());
    const ImVec2 low = ImGui::GetCursorScreenPos();
    trackName(session, plan, path, **row, name);
    const float left = low.x + plan.names;
    const float width = plan.scale.width + 4 * plan.key;
    overlappedItem([&] { return ImGui::InvisibleButton("times", {width, plan.height}); }); // for the keyboard
    noteItem("times:" + path);
    scrub(session, state, plan.scale);
    const float mouse = ImGui::GetIO().MousePos.x;
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
        addKey(session, path, snapped(plan.scale.timeAt(mouse), state.grid));
    const bool isOnKey = std::ranges::any_of(track.keys, [&](const KeyFrame* key) {
        return std::abs(plan.scale.xOf(static_cast<double>(key->time)) - mouse) <= plan.key;
    });
    if (!isOnKey)
        helpTip("Double click: add a key frame here. Drag: change the time.");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled({left, low.y + 1}, {left + width, low.y + plan.height - 1}, color::ground);
    const float middle = std::floor(low.y + plan.height / 2);
    const auto placeOfKey = [&](const KeyFrame& key) {
        return ImVec2(std::floor(plan.scale.xOf(static_cast<double>(key.time))), middle);
    };
    for (std::size_t i = 0; i + 1 < track.keys.size(); ++i)
        drawWay(draw, **row, *track.keys[i], *track.keys[i + 1], placeOfKey(*track.keys[i]),
                placeOfKey(*track.keys[i + 1]));
    for (std::size_t i = 0; i < track.keys.size(); ++i) {
        const ImVec2 at = placeOfKey(*track.keys[i]);
        const float next =
            i + 1 < track.keys.size() ? placeOfKey(*track.keys[i + 1]).x - plan.key : left + width;
        drawKey(session, state, plan, **row, *track.keys[i], at, next - at.x - plan.key * 2.5F);
    }
    ImGui::PopID();
    ImGui::SetCursorScreenPos({low.x, low.y + plan.height});
}

/// What the path has between the beginning and the end that are common to all of them: "matrix[1]" of
/// "passes[0].units[0].matrix[1].amount".
std::string_view differenceOf(std::string_view path, const std::vector<std::string_view>& all) {
    std::size_t begin = path.size();
    std::size_t end = 0;
    for (const std::string_view other : all) {
        if (other == path)
            continue;
        const auto first = std::ranges::mismatch(path, other).in1 - path.begin();
        begin = std::min(begin, path.substr(0, static_cast<std::size_t>(first)).rfind('.') + 1);
        const auto last =
            std::ranges::mismatch(path | std::views::reverse, other | std::views::reverse).in1.base() -
            path.begin();
        if (last > 0)
            end = std::max(end, std::min(path.find('.', static_cast<std::size_t>(last) - 1), path.size()));
    }
    return path.substr(begin, end > begin ? end - begin : 0);
}

/// The labels of the parameters. Of those with the same label what differs is first, as the end of a long
/// name is cut.
std::vector<Sentence> namesOfTracks(const Session& session, const std::vector<Track>& tracks) {
    std::vector<Sentence> names;
    std::map<std::string, std::vector<std::string_view>> paths; // by label
    for (const Track& track : tracks) {
        const auto row = rowAt(presentScene(session), track.path);
        names.push_back(row ? Sentence(shownName(session.settings, **row)) : ProperName{track.path});
        paths[names.back()].push_back(track.path);
    }
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string_view different = differenceOf(tracks[i].path, paths[names[i].english()]);
        if (!different.empty())
            names[i] = Sentence("{0}: {1}", ProperName{different}, Sentence(names[i]));
    }
    return names;
}

/// "0.233,0.15,1" of "0.23333333,0.15,1".
std::string roundedNumbers(std::string_view numbers) {
    std::string rounded;
    while (!numbers.empty()) {
        const std::string_view part = numbers.substr(0, numbers.find(','));
        numbers.remove_prefix(std::min(numbers.size(), part.size() + 1));
        double number = 0;
        const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), number);
        const bool isNumber = error == std::errc() && end == part.data() + part.size();
        rounded += rounded.empty() ? "" : ", ";
        rounded += isNumber ? fmt::format("{:.4g}", number) : printable(part);
    }
    return rounded;
}

} // namespace

Sentence wordsOfValue(const Settings& settings, const ParamRow& row, std::string_view value) {
    if (const EnumRow* choice = findRow(row.choices, value))
        return shownName(settings, *choice);
    if (row.kind == Kind::Bool)
        return value == "true" ? N_("on") : N_("off");
    const bool isText = row.kind == Kind::Text;
    value = value.substr(0, maxValueBytes);
    return ProperName{isText ? printable(value) : roundedNumbers(value)};
}

void requestTime(const Session& session, float time) {
    act(session, [time](Session& s) { goToTime(s, double{time}); });
}

void drawTracks(const Session& session, TimelineTabState& state) {
    const TrackPlan plan = planTracks(session, state);
    ruler(session, state, plan);
    ImGui::BeginChild("tracks");
    const std::vector<Track> tracks = tracksOf(presentScene(session).timeline);
    const std::vector<Sentence> names = namesOfTracks(session, tracks);
    const float top = ImGui::GetCursorScreenPos().y;
    for (std::size_t i = 0; i < tracks.size(); ++i)
        drawTrack(session, state, plan, tracks[i], names[i]);
    drawPresent(*ImGui::GetWindowDrawList(), session, plan.scale, top, ImGui::GetCursorScreenPos().y);
    ImGui::Dummy({0, 0}); // lets the last row be scrolled into view
    ImGui::EndChild();
}

} // namespace texplorer::ui
