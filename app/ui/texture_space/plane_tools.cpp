#include "app/ui/texture_space/plane_tools.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/coord_text.h"
#include "app/ui/model/notice.h"
#include "app/ui/model/tex_coord_edits.h"
#include "app/ui/texture_space/plane_drawing.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/panel_menus.h"
#include "app/ui/widgets/param_widgets.h"
#include "texplorer/base/sentence_format.h"
#include "texplorer/scene/projections.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace texplorer::ui {
namespace {

constexpr const char* fitHelp = N_("Shows the image and every vertex (F or double click)");
constexpr const char* snapHelp =
    N_("Moved vertices snap to texels, quarters, or 0 and 1 (hold Ctrl to invert)");
constexpr const char* selectHelp =
    N_("Dragging selects the vertices in a box instead of moving the plane (also with Shift)");

/// A button that is highlighted while it is on.
bool toolButton(const char* words, std::string_view name, const char* help, bool on) {
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetColorU32(on ? ImGuiCol_HeaderActive : ImGuiCol_Button));
    const bool pressed = ImGui::Button(label(words));
    ImGui::PopStyleColor();
    item(name, help);
    return pressed;
}

bool hasVertices(const TextureSpaceState& state) {
    return !state.coords.given().empty();
}

/// A tool that has a button if there is room: it switches a flag, or mirrors vertices.
struct Tool {
    const char* label;
    const char* name;
    const char* help;
    bool& (*flagOf)(TextureSpaceState& state);
    int axis = 0; ///< if there is no flag
};

// In the order of the toolbar.
constexpr std::span channelTools = std::span(channelRows).subspan<1>(); // all but RGBA
constexpr std::array vertexTools{
    Tool{N_("Snap"), "snap", snapHelp, [](TextureSpaceState& state) -> bool& { return state.snapping.on; }},
    Tool{"▭", N_("box select"), selectHelp, [](TextureSpaceState& state) -> bool& { return state.selects; }},
    Tool{"↔", N_("mirror s"), N_("Mirrors the selected vertices, or all, from left to right"), nullptr, 0},
    Tool{"↕", N_("mirror t"), N_("Mirrors the selected vertices, or all, upside down"), nullptr, 1},
};

/// Pressing the button again shows all channels.
void drawTool(TextureSpaceState& state, const ChannelRow& row) {
    Channel& shown = state.look.channel;
    if (toolButton(row.brief, std::string("channel:") + row.brief, row.help, shown == row.channel))
        shown = shown == row.channel ? Channel::All : row.channel;
}

void drawTool(const Session& session, TextureSpaceState& state, const Tool& tool) {
    ImGui::BeginDisabled(!hasVertices(state));
    bool* flag = tool.flagOf ? &tool.flagOf(state) : nullptr;
    if (toolButton(tool.label, tool.name, tool.help, flag && *flag)) {
        if (flag)
            *flag = !*flag;
        else
            mirrorVertices(session, state.coords, tool.axis);
    }
    ImGui::EndDisabled();
}

void levelSlider(const Session& session, TextureSpaceState& state, float width) {
    const std::vector<LevelReport> levels = levelsOfBound(session);
    ImGui::BeginDisabled(levels.size() < 2);
    ImGui::SetNextItemWidth(width);
    ImGui::SliderInt(label("Level"), &state.look.level, levels.empty() ? 0 : levels.front().number,
                     levels.empty() ? 0 : levels.back().number, "%d", ImGuiSliderFlags_AlwaysClamp);
    noteItem("shown level");
    ImGui::EndDisabled();
    helpTip(levels.size() < 2 ? "The texture has only one level"
                              : N_("The mip level that is shown here. It does not change the scene"));
}

void exposureSlider(PlaneLook& look, float width) {
    // The number is drawn over the grab, which is faint enough to keep the number readable.
    ImVec4 grab = ImGui::GetStyleColorVec4(ImGuiCol_SliderGrab);
    grab.w *= 0.4F;
    ImGui::PushStyleColor(ImGuiCol_SliderGrab, grab);
    ImGui::PushStyleColor(ImGuiCol_SliderGrabActive, grab);
    ImGui::SetNextItemWidth(width);
    ImGui::SliderFloat(label("Exposure"), &look.exposure, -PlaneLook::maxExposure, PlaneLook::maxExposure,
                       "× 2^%.1f", ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopStyleColor(2);
    noteItem("exposure");
}

ImU32 componentTint(std::size_t component) {
    return component < 3 ? componentColor(static_cast<int>(component)) : color::text;
}

const char* componentLetter(std::size_t component) {
    return channelRows[component + 1].brief;
}

/// Red, green and blue, or the shown component.
std::vector<std::size_t> shownComponents(Channel channel) {
    if (channel == Channel::All)
        return {0, 1, 2};
    return {static_cast<std::size_t>(channel) - 1};
}

/// The bars of one component, with its letter in front.
void drawBars(ImDrawList& draw, const reference::TexelStatistics& statistics, std::size_t component,
              ImVec2 low, ImVec2 high) {
    const auto& counts = statistics.components[component].counts;
    const std::uint32_t most = std::max(1U, std::ranges::max(counts));
    const ImU32 tint = componentTint(component);
    const float em = ImGui::GetFontSize();
    draw.AddText({low.x + em * 0.2F, std::round((low.y + high.y) / 2 - em / 2)}, tint,
                 componentLetter(component));
    const float left = low.x + em * 1.1F;
    const float one = (high.x - left) / 256;
    for (int value = 0; value < 256; ++value) {
        const std::uint32_t count = counts[static_cast<std::size_t>(value)];
        if (count == 0)
            continue;
        // Rare values are visible, too.
        const float share = std::sqrt(static_cast<float>(count) / static_cast<float>(most));
        const float x = left + one * static_cast<float>(value);
        draw.AddRectFilled({x, high.y - (high.y - low.y) * share}, {x + std::max(1.0F, one), high.y}, tint);
    }
}

/// How often each value occurs in the shown components: one line for each, with its letter.
void drawHistogram(const LevelPicture& level, Channel channel, float width) {
    const float em = ImGui::GetFontSize();
    const float height = em * 4.5F;
    const ImVec2 low = ImGui::GetCursorScreenPos();
    ImGui::Dummy({width, height});
    noteItem("histogram");
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(low, {low.x + width, low.y + height}, color::ground, em * 0.2F);
    if (const reference::TexelStatistics* statistics = level.statistics()) {
        const std::vector<std::size_t> shown = shownComponents(channel);
        const float line = height / static_cast<float>(shown.size());
        for (std::size_t i = 0; i < shown.size(); ++i) {
            const float top = low.y + line * static_cast<float>(i);
            const ImVec2 from(low.x, top + 1);
            const ImVec2 to(low.x + width, top + line);
            drawBars(draw, *statistics, shown[i], from, to);
            noteDrawn(fmt::format("histogram:{}", componentLetter(shown[i])), from, to);
        }
    }
    const char* words = level.isComputing()       ? N_("Counting…")
                        : level.problem().empty() ? ""
                                                  : N_("There is no such level");
    if (*words == '\0')
        return;
    const ImVec2 size = ImGui::CalcTextSize(tr(words));
    const ImVec2 at(low.x + width - size.x - em * 0.5F, low.y + em * 0.3F);
    drawTextChip(draw, chipBox(at, size), em, color::text, tr(words));
    noteDrawn(std::string("histogram:") + words, at, {at.x + size.x, at.y + size.y});
}

/// min, max and mean of each component, in 255ths.
void drawStatistics(const LevelPicture& level) {
    const reference::TexelStatistics* statistics = level.statistics();
    const ImVec2 size(ImGui::GetFontSize() * 16, 0);
    if (!statistics || !ImGui::BeginTable("statistics", 4, ImGuiTableFlags_SizingStretchSame, size))
        return;
    for (const char* name : {"", tr("min"), tr("max"), tr("mean")}) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", name);
    }
    for (std::size_t i = 0; i < statistics->components.size(); ++i) {
        const reference::ComponentStatistics& each = statistics->components[i];
        const std::string least = std::to_string(each.least);
        const std::string most = std::to_string(each.most);
        const std::string mean = fmt::format("{:.2f}", each.mean);
        ImGui::TableNextColumn();
        plainText(componentLetter(i), componentTint(i));
        for (const std::string& number : {least, most, mean}) {
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(number.c_str());
        }
        noteItem(fmt::format("statistics:{} {} {} {}", componentLetter(i), least, most, mean));
    }
    ImGui::EndTable();
}

void pictureTools(const Session& session, TextureSpaceState& state) {
    const float em = ImGui::GetFontSize();
    const float width = em * 11;
    PlaneLook& look = state.look;
    caption("Picture");
    for (const ChannelRow& row : channelRows) {
        if (&row != &channelRows.front())
            ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x / 2);
        if (toolButton(row.brief, std::string("channel=") + row.label, row.help, look.channel == row.channel))
            look.channel = row.channel;
    }
    levelSlider(session, state, width);
    exposureSlider(look, width);
    helpTip("Multiplies the shown values by 2 to this power, to see dark ones");
    ImGui::SetNextItemWidth(width);
    constexpr float minRange = 0.01F;
    if (ImGui::DragFloatRange2(label("Range"), &look.low, &look.high, 0.005F, 0, 1, "%.2f", nullptr,
                               ImGuiSliderFlags_AlwaysClamp) &&
        look.high - look.low < minRange) {
        look.low = std::min(look.low, 1 - minRange);
        look.high = look.low + minRange;
    }
    item("range", "The values that are shown as 0 and 1");
    ImGui::BeginDisabled(look.isPlain());
    if (ImGui::Button(label("Reset")))
        look = {{}, 0, look.board};
    noteItem("plain look");
    ImGui::EndDisabled();
    helpTip("Shows all channels of level 0 with the initial exposure and range");
    ImGui::SameLine();
    ImGui::Checkbox(label("Checker behind alpha"), &look.board);
    item("board", "Transparent texels show a checkerboard instead of their colour");
    drawHistogram(state.level, look.channel, width + em * 5);
    drawStatistics(state.level);
}

void snapChoice(TextureSpaceState& state) {
    ImGui::Checkbox(label("Snap to"), &state.snapping.on);
    item("snap on", snapHelp);
    for (const SnapRow& row : snapRows) {
        ImGui::SameLine();
        if (toolButton(row.label, std::string("snap:") + row.label, row.help,
                       state.snapping.to == row.snap)) {
            state.snapping.to = row.snap;
            state.snapping.on = true;
        }
    }
}

void vertexMenu(const Session& session, TextureSpaceState& state) {
    const std::size_t count = editedVertices(session).size();
    caption("Vertices");
    if (!hasVertices(state)) {
        dimText("Directions can't be shown in this plane");
        return;
    }
    snapChoice(state);
    ImGui::Checkbox(label("Drag selects"), &state.selects);
    item("drag selects", selectHelp);
    ImGui::SameLine();
    ImGui::Checkbox(label("Numbers"), &state.numbers);
    item("vertex numbers", "Shows the numbers of the vertices where they fit");
    ImGui::SameLine();
    ImGui::Checkbox(label("Legend"), &state.legend);
    item("legend on", "Describes the picture at the upper edge");
    ImGui::AlignTextToFramePadding();
    dimText(Sentence("Of {0} vertices:", count));
    helpTip("The selected vertices if two or more, else all");
    for (const auto& [words, name, help, axis] :
         {std::tuple{N_("Mirror s"), N_("menu mirror s"), vertexTools[2].help, 0},
          std::tuple{N_("Mirror t"), N_("menu mirror t"), vertexTools[3].help, 1}}) {
        ImGui::SameLine();
        if (toolButton(words, name, help, false))
            mirrorVertices(session, state.coords, axis);
    }
    for (const EnumRow& row : EnumTable<CoordProjection>::rows) {
        if (&row != &EnumTable<CoordProjection>::rows.front())
            ImGui::SameLine(0, ImGui::GetStyle().ItemInnerSpacing.x);
        const std::string help(row.help);
        if (toolButton(std::string(row.label).c_str(), fmt::format("project:{}", row.label), help.c_str(),
                       false))
            submitTexCoords(session, Sentence("{0} projection", row.label),
                            projectedTexCoords(selectedMesh(session), static_cast<CoordProjection>(row.value),
                                               editedVertices(session), state.coords.given()));
    }
    if (toolButton(N_("Copy"), N_("copy coordinates"),
                   N_("Copies s and t as text, one line for each vertex (Ctrl + C)"), false))
        copyCoords(session, state.coords);
    ImGui::SameLine();
    if (toolButton(N_("Paste"), N_("paste coordinates"),
                   N_("Pastes coordinates, a line \"s t\" or \"s t r q\" for each vertex (Ctrl + V)"), false))
        pasteCoords(session, state.coords);
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 18);
    dimText("Keys over the plane do all of this and move by texels. F1 lists them.");
    ImGui::PopTextWrapPos();
}

} // namespace

void fitPlane(const Session& session, const PlaneCoords& coords) {
    const auto [low, high] = boundsOf(coords);
    Plane plane;
    plane.s = (low.x + high.x) / 2;
    plane.t = (low.y + high.y) / 2;
    plane.extent = std::clamp(std::max(high.x - low.x, high.y - low.y) * 1.4F, minPlane, maxPlane);
    act(session, [plane](Session& changed) { changed.look.plane = plane; });
}

void copyCoords(const Session& session, const PlaneCoords& coords) {
    TexCoords chosen;
    for (const std::size_t vertex : editedVertices(session)) {
        if (vertex < coords.given().size())
            chosen.push_back(coords.given()[vertex]);
    }
    if (!chosen.empty())
        ImGui::SetClipboardText(coordText(chosen).c_str());
}

void pasteCoords(const Session& session, const PlaneCoords& coords) {
    const auto refuse = [&session](const Sentence& why) {
        act(session, [why](Session& told) { say(told, why); });
    };
    const char* text = ImGui::GetClipboardText();
    const Result<TexCoords> pasted = parseCoordText(text ? text : "");
    if (!pasted)
        return refuse({"The clipboard has no texture coordinates: {0}.", pasted.error().message});
    TexCoords list = coords.given();
    if (list.empty())
        return refuse("Directions can't be shown in this plane, so nothing can be pasted.");
    const std::vector<std::size_t> edited = editedVertices(session);
    if (pasted->size() != edited.size() && pasted->size() != list.size())
        return refuse({"Expected coordinates of {0} vertices, but the clipboard has {1}.", edited.size(),
                       pasted->size()});
    if (pasted->size() == edited.size()) {
        for (std::size_t i = 0; i < edited.size(); ++i)
            list[edited[i]] = (*pasted)[i];
    } else {
        list = *pasted;
    }
    submitTexCoords(session, N_("Paste coordinates"), std::move(list));
}

void drawPlaneTools(const Session& session, TextureSpaceState& state) {
    constexpr const char* more = "…";
    // Translators: a button that shows the image and every vertex
    constexpr const char* fit = N_("Fit");
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    const float end = ImGui::GetContentRegionMax().x - buttonWidth(fit) - buttonWidth(more) - gap;
    textureSpaceTitle(session, end - ImGui::GetCursorPosX() - ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine();
    const float begin = ImGui::GetCursorPosX();
    // The tools that fit: first the channels, all of them or none, then the others one by one.
    const float room = end - begin - gap;
    const auto widthOf = [gap](const char* words) { return buttonWidth(words) + gap; };
    float width = 0;
    for (const ChannelRow& row : channelTools)
        width += widthOf(row.brief);
    const bool hasChannels = width <= room;
    width = hasChannels ? width : 0;
    std::size_t count = 0;
    while (hasChannels && count < vertexTools.size() && width + widthOf(vertexTools[count].label) <= room)
        width += widthOf(vertexTools[count++].label);
    ImGui::SameLine(std::max(begin, end - width));
    for (const ChannelRow& row : channelTools.first(hasChannels ? channelTools.size() : 0)) {
        drawTool(state, row);
        ImGui::SameLine(0, gap);
    }
    for (const Tool& tool : std::span(vertexTools).first(count)) {
        drawTool(session, state, tool);
        ImGui::SameLine(0, gap);
    }
    ImGui::SetCursorPosX(std::max(begin, end));
    if (toolButton(more, N_("plane tools"),
                   N_("Channels, exposure, histogram, snapping, projections and more"),
                   !state.look.isPlain()))
        ImGui::OpenPopup(N_("plane tools"));
    ImGui::SameLine(0, gap);
    if (ImGui::Button(label(fit)))
        fitPlane(session, state.coords);
    item("fit plane", fitHelp);
    // Next to the panel, so that the effect of the tools is visible.
    ImGui::SetNextWindowPos(ImGui::GetWindowPos(), ImGuiCond_Always, {1, 0});
    const bool open = ImGui::BeginPopup(N_("plane tools"));
    if (open) {
        pictureTools(session, state);
        ImGui::Spacing();
        vertexMenu(session, state);
        ImGui::EndPopup();
    }
    if (state.look.level != 0) { // another texture may have fewer levels
        if (const std::vector<LevelReport> levels = levelsOfBound(session); !levels.empty())
            state.look.level = std::clamp(state.look.level, levels.front().number, levels.back().number);
    }
    state.level.follow(session, state.look, open || !state.look.isPlain());
}

} // namespace texplorer::ui
