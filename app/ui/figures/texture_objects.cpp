#include "app/ui/figures/texture_objects.h"

#include "app/ui/figures/plot.h"
#include "app/ui/language/translate.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/hover_link.h"
#include "app/ui/widgets/param_names.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/points.h"
#include "app/ui/widgets/same_line.h"
#include "app/ui/widgets/segments.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/sentence_format.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace texplorer::ui {
namespace {

using objects::Call;
using objects::Name;
using objects::TextureNames;
using objects::TextureObject;
using objects::UnitState;

constexpr Name maxNames = 4;
constexpr std::size_t maxLoggedCalls = 100;

void makeCall(TextureObjectsState& state, const Call& call) {
    state.before = state.names;
    state.log.push_back(codeOf(call, apply(state.names, call)));
    if (state.log.size() > maxLoggedCalls)
        state.log.erase(state.log.begin());
}

/// A call by the user; it ends a running program.
using Wanted = std::optional<Call>;

/// Buttons of an enumeration, each of which makes a call; the tooltip has its C code.
template<class Enum, class CallOf>
void enumCalls(const Session& session, std::string_view name, std::span<const Enum> choices, Enum chosen,
               float width, Wanted& wanted, const CallOf& callOf) {
    std::vector<Segment> segments =
        segmentsOf(choices, [&](Enum each) { return shownBrief(session.settings, rowOf(each)); });
    if constexpr (std::is_same_v<Enum, MinFilter>)
        segments.back().text = N_("Blended mips"); // Nearest within each: the initial value
    ImGui::PushID(name.data());
    const auto pressed = drawSegments(segments, width, indexIn(choices, chosen), [&](std::size_t i) {
        item(fmt::format("objects:{}={}", name, rowOf(choices[i]).name), codeOf(callOf(choices[i])));
    });
    ImGui::PopID();
    if (pressed)
        wanted = callOf(choices[*pressed]);
}

/// A button that makes a call.
void callButton(const char* words, std::string_view name, const Call& call, Wanted& wanted, float width = 0,
                bool enabled = true) {
    ImGui::BeginDisabled(!enabled);
    if (ImGui::Button(words, {width, 0}))
        wanted = call;
    ImGui::EndDisabled();
    item(name, codeOf(call));
}

/// Highlights the last item if the last call changed it.
void lightItem(bool changed, std::string_view name) {
    if (!changed)
        return;
    frameItem(2, color::changed, 3, plotLine() * 1.5F);
    noteItem(fmt::format("objects:lit {}", name));
}

/// In the order of Sampled.
constexpr std::array<Sentence::Key<Name>, 4> sampledRemarks{
    N_("Object {0} is bound, texturing is off"),
    N_("Object {0} has no image: untextured"),
    N_("Object {0} lacks mipmaps: untextured"),
    N_("Object {0} is drawn"),
};

/// The start of a unit's line to its object, and the end at the object's row.
struct Ends {
    std::array<ImVec2, objects::unitCount> units{};
    std::array<std::optional<ImVec2>, maxNames + 1> names{};
};

/// The state of a unit, and the resulting fragment.
void drawUnitCard(const Session& session, const TextureObjectsState& state, std::size_t number, float width,
                  Wanted& wanted, Ends& ends) {
    const float em = ImGui::GetFontSize();
    const UnitState& unit = state.names.units.at(number);
    const UnitState& before = state.before.units.at(number);
    const bool isActive = state.names.active == number;
    ImGui::PushID(static_cast<int>(number));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    const float pad = em * 0.25F;
    const float side = 2 * ImGui::GetFrameHeight();
    ImGui::SetCursorScreenPos(low + ImVec2(pad, pad));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {em * 0.5F, 2});
    ImGui::BeginGroup();
    const float inner = width - side - 3 * pad;
    ImGui::PushStyleColor(ImGuiCol_Text, isActive ? color::chosen : color::text);
    if (ImGui::Button(fmt::format("{}###unit", tr(Sentence("Unit {0}", number))).c_str()))
        wanted = objects::ActiveTexture{number};
    ImGui::PopStyleColor();
    item(fmt::format("objects:unit {}", number), codeOf(objects::ActiveTexture{number}));
    lightItem(isActive && state.before.active != number, fmt::format("unit {}", number));
    ImGui::SameLine();
    ImGui::BeginDisabled(!isActive);
    const objects::EnableTexture toggle{!unit.enabled};
    bool on = unit.enabled;
    if (ImGui::Checkbox(rowOf(Target::Texture2D).name.data(), &on))
        wanted = toggle;
    item(fmt::format("objects:enable {}", number), codeOf(toggle));
    lightItem(unit.enabled != before.enabled, fmt::format("enable {}", number));
    constexpr std::array modes{EnvMode::Modulate, EnvMode::Replace, EnvMode::Decal};
    ImGui::BeginGroup();
    enumCalls<EnvMode>(session, fmt::format("env {}", number), modes, unit.envMode, inner, wanted,
                       [](EnvMode mode) { return objects::SetEnvMode{mode}; });
    ImGui::EndGroup();
    lightItem(unit.envMode != before.envMode, fmt::format("env {}", number));
    ImGui::EndDisabled();
    const objects::Sampled sampled = sampledBy(state.names, number);
    const std::string remark = tr(Sentence(sampledRemarks.at(static_cast<std::size_t>(sampled)), unit.bound));
    const bool isWrong = sampled == objects::Sampled::NoImage || sampled == objects::Sampled::NoMipmaps;
    plotText(ImGui::GetCursorScreenPos(), {0, 0}, remark, isWrong ? color::problem : color::text);
    ImGui::Dummy({inner, em});
    noteItem(fmt::format("objects:bound {} {}", number, unit.bound));
    ImGui::EndGroup();
    ImGui::PopStyleVar();
    const float bottom = ImGui::GetItemRectMax().y + pad;
    const ImVec2 fragments = low + ImVec2(width - pad - side, pad);
    drawFragments(fragments, side, state.names, number);
    noteDrawn(fmt::format("objects:fragments {}", number), fragments, fragments + ImVec2(side, side));
    ImGui::GetWindowDrawList()->AddRect(low, {low.x + width, bottom},
                                        isActive ? color::chosen : color::outline, em * 0.25F, 0,
                                        isActive ? plotLine() * 1.5F : plotLine());
    ends.units.at(number) = {low.x + width, bottom - pad - em / 2};
    ImGui::SetCursorScreenPos({low.x, bottom + em * 0.3F});
    ImGui::Dummy({0, 0});
    ImGui::PopID();
}

/// A cell of the table, highlighted if the last call changed it.
void objectCell(const Sentence& words, bool changed, std::string_view name) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(fitted(words, ImGui::GetContentRegionAvail().x).c_str());
    noteItem(name);
    if (changed) {
        ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, color::lit);
        noteItem(fmt::format("objects:lit {}", name));
    }
}

void drawObjectRow(const Session& session, const TextureObjectsState& state, Name name,
                   const std::optional<TextureObject>& object, Wanted& wanted, Ends& ends) {
    const auto earlier = state.before.names.find(name);
    const bool isNew = earlier == state.before.names.end();
    const std::optional<TextureObject> before = isNew ? std::nullopt : earlier->second;
    const bool isMade = object && !before;
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(static_cast<int>(name));
    const ImVec2 low = ImGui::GetCursorScreenPos();
    if (name < ends.names.size())
        ends.names.at(name) = ImVec2(low.x, low.y + ImGui::GetFrameHeight() / 2);
    const bool isBound = state.names.activeUnit().bound == name;
    ImGui::PushStyleColor(ImGuiCol_Text, isBound ? color::chosen : color::text);
    callButton(fmt::format("{}###bind", tr(Sentence("Bind {0}", name))).c_str(),
               fmt::format("objects:bind {}", name), objects::BindTexture{name}, wanted,
               ImGui::GetContentRegionAvail().x);
    ImGui::PopStyleColor();
    if (isNew || isMade)
        lightItem(true, fmt::format("name {}", name));
    if (object) {
        const Texture& texture = object->state;
        const auto differs = [&](auto part) { return isMade || texture.*part != before->state.*part; };
        const auto choice = [&](auto value) { return Sentence(shownName(session.settings, rowOf(value))); };
        const auto brief = [&](Wrap wrap) { return Sentence(shownBrief(session.settings, rowOf(wrap))); };
        ImGui::TableNextColumn();
        const float side = ImGui::GetFrameHeight();
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::Dummy({side, side});
        if (object->picture) {
            drawBoardImage(at, side, boards.at(static_cast<std::size_t>(*object->picture)));
            noteItem(fmt::format("objects:picture {} {}", name, *object->picture));
        } else {
            plotText({at.x, at.y + side / 2}, {0, 0.5F}, tr("none"), color::dim);
        }
        if (object->picture && (isMade || object->picture != before->picture))
            ImGui::TableSetBgColor(ImGuiTableBgTarget_CellBg, color::lit);
        objectCell(choice(texture.magFilter), differs(&Texture::magFilter), fmt::format("mag {}", name));
        objectCell(choice(texture.minFilter), differs(&Texture::minFilter), fmt::format("min {}", name));
        const Sentence wraps = texture.wrapS == texture.wrapT
                                   ? brief(texture.wrapS)
                                   : Sentence("{0}, {1}", brief(texture.wrapS), brief(texture.wrapT));
        objectCell(wraps, differs(&Texture::wrapS) || differs(&Texture::wrapT), fmt::format("wrap {}", name));
    } else {
        ImGui::TableSetColumnIndex(3);
        ImGui::AlignTextToFramePadding();
        dimText("a name only");
        noteItem(fmt::format("objects:name only {}", name));
    }
    ImGui::TableSetColumnIndex(5);
    callButton("?", fmt::format("objects:is {}", name), objects::IsTexture{name}, wanted,
               ImGui::GetFrameHeight());
    ImGui::SameLine(0, 2);
    callButton("✕", fmt::format("objects:delete {}", name), objects::DeleteTexture{name}, wanted,
               ImGui::GetFrameHeight());
    ImGui::PopID();
}

void drawObjects(const Session& session, const TextureObjectsState& state, float width, Wanted& wanted,
                 Ends& ends) {
    const float em = ImGui::GetFontSize();
    if (!ImGui::BeginTable("objects", 6, ImGuiTableFlags_BordersInnerH, {width, 0}))
        return;
    constexpr auto fixed = ImGuiTableColumnFlags_WidthFixed;
    constexpr auto stretched = ImGuiTableColumnFlags_WidthStretch;
    ImGui::TableSetupColumn("name", fixed, buttonWidth(Sentence("Bind {0}", 0)));
    ImGui::TableSetupColumn("image", fixed, em * 2.8F);
    ImGui::TableSetupColumn("mag", stretched, 1);
    ImGui::TableSetupColumn("min", stretched, 2.4F);
    ImGui::TableSetupColumn("wrap", stretched, 1);
    ImGui::TableSetupColumn("calls", fixed, 2 * ImGui::GetFrameHeight() + 2);
    ImGui::TableNextRow();
    for (const char* heading : {N_("Object"), N_("Image"), N_("Mag"), N_("Min"), N_("Wrap")}) {
        ImGui::TableNextColumn();
        plotText(ImGui::GetCursorScreenPos(), {0, 0},
                 fitted(heading, ImGui::GetContentRegionAvail().x * 1.15F), color::dim);
        ImGui::Dummy({0, em});
    }
    for (const auto& [name, object] : state.names.names)
        drawObjectRow(session, state, name, object, wanted, ends);
    ImGui::EndTable();
}

/// Lines from each unit to its bound object.
void drawBindings(const TextureObjectsState& state, const Ends& ends) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const float em = ImGui::GetFontSize();
    for (std::size_t i = 0; i < objects::unitCount; ++i) {
        const UnitState& unit = state.names.units.at(i);
        if (unit.bound >= ends.names.size() || !ends.names.at(unit.bound))
            continue;
        const ImVec2 from = ends.units.at(i);
        const ImVec2 to = *ends.names.at(unit.bound);
        if (to.x <= from.x)
            continue; // they are one below the other
        const bool isNew = unit.bound != state.before.units.at(i).bound;
        const bool isActive = i == state.names.active;
        const ImU32 ink = isNew ? color::changed : isActive ? color::chosen : color::dim;
        const float bend = (to.x - from.x) / 2;
        draw.AddBezierCubic(from, {from.x + bend, from.y}, {to.x - bend, to.y}, {to.x - em * 0.3F, to.y}, ink,
                            plotLine() * (isNew ? 2.5F : 1.5F));
        draw.AddTriangleFilled({to.x - em * 0.05F, to.y}, {to.x - em * 0.45F, to.y - em * 0.25F},
                               {to.x - em * 0.45F, to.y + em * 0.25F}, ink);
    }
}

/// The calls, the last one on top.
void drawLog(const TextureObjectsState& state, ImVec2 size) {
    ImGui::BeginChild("log", size, true);
    ImGui::PushFont(codeFont());
    ImGui::PushTextWrapPos(0);
    for (std::size_t i = state.log.size(); i-- > 0;) {
        const std::string& code = state.log[i];
        const bool isLast = i + 1 == state.log.size();
        if (isLast) {
            const ImVec2 low = ImGui::GetCursorScreenPos();
            const float width = ImGui::GetContentRegionAvail().x;
            const float height = ImGui::CalcTextSize(code.c_str(), nullptr, false, width).y;
            ImGui::GetWindowDrawList()->AddRectFilled(low, low + ImVec2(width, height), color::lit, 2);
        }
        ImGui::PushStyleColor(ImGuiCol_Text, isLast ? color::text : color::dim);
        ImGui::TextUnformatted(code.c_str());
        ImGui::PopStyleColor();
        if (isLast)
            noteItem("objects:last " + code);
    }
    ImGui::PopTextWrapPos();
    ImGui::PopFont();
    if (state.log.empty())
        dimWrappedText(N_("The calls appear here, newest first."));
    ImGui::EndChild();
}

/// glGenTextures, the program of the slides, and a reset.
void drawProgram(TextureObjectsState& state, Wanted& wanted) {
    const bool full = state.names.names.size() > maxNames;
    callButton("glGenTextures", "objects:gen", objects::GenTexture{}, wanted, 0, !full);
    ImGui::SameLine();
    const std::vector<ToldCall>& program = texbindCalls();
    const bool ended = state.played >= program.size();
    const Sentence words = ended ? Sentence("texbind.c: from the start")
                                 : Sentence("texbind.c: call {0} of {1}", state.played + 1, program.size());
    if (ImGui::Button(fmt::format("{}###texbind", tr(words)).c_str())) {
        if (state.played == 0 || ended)
            state = {};
        makeCall(state, program[state.played].call);
        ++state.played;
        wanted.reset();
    }
    item("objects:texbind", "The next call of the program texbind.c in the slides. The first call restarts.");
    ImGui::SameLine();
    if (ImGui::Button(label("Reset")))
        state = {};
    item("objects:reset", "A new context, which has only the default object with name 0.");
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    if (state.played > 0)
        fittedText(program[state.played - 1].remark, color::text);
    else
        fittedText(
            N_("Each button is a call. Binding switches the state of the object; the state of the unit stays."),
            color::dim);
}

/// Controls for glTexImage2D and glTexParameter on the bound object.
void drawParameters(const Session& session, const TextureObjectsState& state, Wanted& wanted) {
    const float em = ImGui::GetFontSize();
    const TextureObject& object = state.names.objectOf(state.names.active);
    const auto group = [&](const char* words, float width) {
        sameLineFor(ImGui::CalcTextSize(tr(words)).x + width + em * 0.5F, em * 0.8F);
        rowName(words);
    };
    ImGui::AlignTextToFramePadding();
    text(Sentence("To object {0}:", state.names.activeUnit().bound));
    group(N_("Image"), 3 * ImGui::GetFrameHeight());
    for (std::size_t i = 0; i < boards.size(); ++i) {
        if (i > 0)
            ImGui::SameLine(0, 3);
        const float side = ImGui::GetFrameHeight();
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const objects::GiveImage call{static_cast<int>(i)};
        if (ImGui::InvisibleButton(fmt::format("image {}", i).c_str(), {side, side}))
            wanted = call;
        item(fmt::format("objects:image {}", i), codeOf(call));
        const float inset = ImGui::IsItemHovered() ? 0 : 2;
        drawBoardImage(low + ImVec2(inset, inset), side - 2 * inset, boards.at(i));
    }
    constexpr std::array magnify{MagFilter::Nearest, MagFilter::Linear};
    constexpr std::array minify{MinFilter::Nearest, MinFilter::Linear, MinFilter::NearestMipmapLinear};
    constexpr std::array wraps{Wrap::Repeat, Wrap::Clamp};
    group(N_("Mag filter"), em * 7.5F);
    enumCalls<MagFilter>(session, "mag", magnify, object.state.magFilter, em * 7.5F, wanted,
                         [](MagFilter filter) { return objects::setParameter(filter); });
    group(N_("Min filter"), em * 14.5F);
    enumCalls<MinFilter>(session, "min", minify, object.state.minFilter, em * 14.5F, wanted,
                         [](MinFilter filter) { return objects::setParameter(filter); });
    group(N_("Wrap s"), em * 7.5F);
    enumCalls<Wrap>(session, "wrap", wraps, object.state.wrapS, em * 7.5F, wanted,
                    [](Wrap wrap) { return objects::setWrapS(wrap); });
}

} // namespace

void drawTextureObjects(const Session& session, TextureObjectsState& state) {
    const float em = ImGui::GetFontSize();
    Wanted wanted;
    drawProgram(state, wanted);
    drawParameters(session, state, wanted);
    ImGui::Dummy({0, em * 0.1F});
    Ends ends;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    const bool beside = room.x > em * 52;
    const ImVec2 top = ImGui::GetCursorPos();
    const float units = beside ? em * 19 : std::min(room.x, em * 26);
    for (std::size_t i = 0; i < objects::unitCount; ++i)
        drawUnitCard(session, state, i, units, wanted, ends);
    const float log = beside ? std::max(em * 13, room.x * 0.2F) : room.x;
    const float gap = em * 2;
    if (beside)
        ImGui::SetCursorPos({top.x + units + gap, top.y});
    const float middle = beside ? room.x - units - log - gap - em : room.x;
    ImGui::BeginGroup();
    drawObjects(session, state, middle, wanted, ends);
    ImGui::EndGroup();
    if (beside)
        ImGui::SetCursorPos({top.x + room.x - log, top.y});
    drawLog(state, {log, beside ? std::max(room.y, em * 9) : em * 8});
    drawBindings(state, ends);
    if (wanted) {
        state.played = 0;
        makeCall(state, *wanted);
    }
}

} // namespace texplorer::ui
