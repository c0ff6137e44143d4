#include "app/ui/details/commands_tab.h"

#include "app/ui/details/code_controls.h"
#include "app/ui/files/program_file.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/program_menu.h"
#include "app/ui/widgets/theme.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr const char* commandsHint = "Drag numbers, click names and switches";
constexpr const char* makingHint = "Making the program…";

void toolRow(const Session& session, CommandsTabState& state) {
    const char* copy = "Copy";
    const char* save = "Export…";
    const char* hint = session.services.programs.isMaking() ? makingHint : commandsHint;
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = buttonWidth(copy) + inner + buttonWidth(save);
    bool all = session.window.allCalls;
    if (ImGui::Checkbox(label("All calls"), &all))
        act(session, [all](Session& changed) { changed.window.allCalls = all; });
    noteItem("all commands");
    helpTip("Off: only the calls that change OpenGL's initial state");
    ImGui::SameLine(0, ImGui::GetFontSize());
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(tr(hint)).x + ImGui::GetFontSize() + width) {
        ImGui::AlignTextToFramePadding();
        dimText(hint);
        noteItem(hint == makingHint ? "commands:making" : "commands:hint");
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    if (ImGui::Button(label(copy))) {
        const std::string program = emit::textOf(state.lines, all);
        ImGui::SetClipboardText(program.c_str());
        act(session, [lines = std::ranges::count(program, '\n')](Session& s) {
            tell(s, fmt::format("Copied: {} lines", lines));
        });
    }
    noteItem("copy commands");
    helpTip("Copies the listed program as C");
    ImGui::SameLine(0, inner);
    if (ImGui::Button(label(save)))
        ImGui::OpenPopup("export");
    noteItem("export commands");
    helpTip("Writes a program that draws the scene into a file: in C, or as a page for a browser");
    const ImVec2 corner = ImGui::GetItemRectMax();
    const float height =
        ImGui::GetFrameHeightWithSpacing() * static_cast<float>(emit::flavourRows.size() + 1);
    const bool hasRoom = corner.y + height < ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowPos({corner.x, hasRoom ? corner.y : ImGui::GetItemRectMin().y}, ImGuiCond_Appearing,
                            {1, hasRoom ? 0.0F : 1.0F}); // next to the button, not over it
    if (ImGui::BeginPopup("export")) {
        programMenuItems(session);
        ImGui::EndPopup();
    }
}

/// The listed lines, broken into rows of this many letters.
void makeRows(CommandsTabState& state, bool showsAll) {
    state.rows.clear();
    for (std::size_t i = 0; i < state.lines.size(); ++i) {
        const emit::Line& line = state.lines[i];
        if (!showsAll && !line.needed && !mentionsAny(line, state.changed))
            continue;
        const bool begins = line.depth > (state.rows.empty() ? 0 : state.lines[state.rows.back().line].depth);
        if (line.heading && !state.rows.empty() && !state.rows.back().parts.empty() && !begins)
            state.rows.push_back({{}, i, false});
        for (std::vector<emit::Part>& parts : emit::wrapped(line, state.columns))
            state.rows.push_back({std::move(parts), i, false});
        state.rows.back().isLast = true;
    }
}

/// Makes the lines again if the scene has changed. Until its program is ready, the previous lines stay.
void renewLines(const Session& session, CommandsTabState& state) {
    const Document& document = session.document;
    const Scene& scene = document.scene;
    const bool isSame = state.scene && *state.scene == scene && state.images == document.images;
    if (isSame && !session.services.programs.isMaking()) // the running work is for another scene: cancel it
        return;
    const std::optional<emit::ProgramWorker::Program> made = programNow(session, emit::Flavour::Fixed);
    if (!made)
        return;
    state.changed = changedPaths(document);
    state.rowsAreOld = true;
    state.refused = *made ? std::string() : describe(made->error());
    std::vector<emit::Line> lines = made->value_or(std::vector<emit::Line>{});
    const auto haveChanged = [&](const std::vector<emit::Line>& among) {
        return std::ranges::any_of(among,
                                   [&](const emit::Line& line) { return mentionsAny(line, state.changed); });
    };
    // A number that is dragged to a value for which its call is not needed stays under the pointer.
    if (ImGui::IsAnyItemActive() && !haveChanged(lines) && haveChanged(state.lines))
        return;
    state.lines = std::move(lines);
    state.scene = scene;
    state.images = document.images;
}

/// Breaks them into rows again if something has changed.
void renewRows(const Session& session, CommandsTabState& state, std::size_t columns) {
    const Document& document = session.document;
    // The numbers of a list are compared with the previous ones only after a change.
    if (!state.rowsAreOld && state.columns == columns && state.rowsShowAll == session.window.allCalls &&
        state.lastChanged == document.lastChanged)
        return;
    state.changed = changedPaths(document);
    state.columns = columns;
    state.rowsAreOld = false;
    state.rowsShowAll = session.window.allCalls;
    state.lastChanged = document.lastChanged;
    makeRows(state, session.window.allCalls);
}

/// Scrolls once to the first call of the scene: the calls before it are the same in most programs.
void showCalls(CommandsTabState& state, float rowHeight) {
    if (state.rows.empty() || std::exchange(state.hasShownCalls, true))
        return;
    const auto isCall = [&](const CodeRow& row) {
        return std::ranges::any_of(row.parts, [](const emit::Part& part) {
            return part.kind == emit::Part::Kind::Call && !part.path.empty();
        });
    };
    const auto call = std::ranges::find_if(state.rows, isCall);
    if (call == state.rows.end())
        return;
    const auto blank = std::find_if(std::make_reverse_iterator(call), state.rows.rend(),
                                    [](const CodeRow& row) { return row.parts.empty(); });
    ImGui::SetScrollY(rowHeight * static_cast<float>(blank.base() - state.rows.begin()));
}

/// Scrolls once to the last changed line, if it is not visible.
void showChanged(CommandsTabState& state, float rowHeight) {
    if (state.revealed == state.changed)
        return;
    state.revealed = state.changed;
    const auto found = std::ranges::find_if(
        state.rows, [&](const CodeRow& row) { return mentionsAny(state.lines[row.line], state.changed); });
    if (found == state.rows.end())
        return;
    const float top = rowHeight * static_cast<float>(found - state.rows.begin());
    const float height = ImGui::GetWindowHeight();
    if (top < ImGui::GetScrollY() || top + rowHeight > ImGui::GetScrollY() + height)
        ImGui::SetScrollY(std::max(0.0F, top - height / 2));
}

std::string firstPath(const emit::Line& line) {
    const auto named =
        std::ranges::find_if(line.parts, [](const emit::Part& part) { return !part.path.empty(); });
    return named == line.parts.end() ? std::string() : named->path;
}

void drawRow(const Session& session, const CommandsTabState& state, const CodeRow& row, float letter) {
    const emit::Line& line = state.lines[row.line];
    const bool isChanged = mentionsAny(line, state.changed);
    const CodeLook look{letter, !line.needed && !line.heading, isChanged};
    const ImVec2 start = ImGui::GetCursorPos();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float bar = letter * 0.4F;
    if (isChanged) {
        const ImVec2 end(corner.x + bar, corner.y + ImGui::GetFontSize());
        ImGui::GetWindowDrawList()->AddRectFilled(corner, end, color::changed);
        noteDrawn(fmt::format("changed line:{}", row.line), corner, end);
    }
    float x = start.x + letter;
    for (const emit::Part& part : row.parts) {
        ImGui::SetCursorPos({x, start.y});
        x += codePart(session, part, look);
    }
    if (row.isLast) {
        ImGui::SetCursorPos({x, start.y});
        codeSwatch(session, line, look);
    }
    // The whole line belongs to the parameter that it sets, including its brackets.
    const float end = corner.x + ImGui::GetWindowContentRegionMax().x;
    if (session.out.hoveredParam.empty() && ImGui::IsWindowHovered() &&
        ImGui::IsMouseHoveringRect(corner, {end, corner.y + ImGui::GetFontSize()}))
        session.out.hoveredParam = firstPath(line);
    ImGui::SetCursorPos(start);
    ImGui::Dummy({0, ImGui::GetFontSize()});
}

} // namespace

void drawCommandsTab(const Session& session, CommandsTabState& state) {
    renewLines(session, state);
    toolRow(session, state);
    if (!state.refused.empty())
        wrappedText(state.refused);
    ImGui::BeginChild("commands");
    ImGui::PushFont(codeFont());
    constexpr int sample = 64; // letters: the width of a single one may be rounded
    const float letter = ImGui::CalcTextSize(std::string(sample, 'M').c_str()).x / sample;
    const float room = ImGui::GetContentRegionAvail().x / letter - 3; // a bar in front, a swatch behind
    renewRows(session, state, static_cast<std::size_t>(std::max(16.0F, room)));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, ImGui::GetFontSize() * 0.2F});
    const float rowHeight = ImGui::GetFontSize() + ImGui::GetStyle().ItemSpacing.y;
    showCalls(state, rowHeight);
    showChanged(state, rowHeight);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(state.rows.size()), rowHeight);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            drawRow(session, state, state.rows[static_cast<std::size_t>(i)], letter);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
}

} // namespace texplorer::ui
