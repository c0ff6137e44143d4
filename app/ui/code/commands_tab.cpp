#include "app/ui/code/commands_tab.h"

#include "app/ui/files/program_file.h"
#include "app/ui/language/translate.h"
#include "app/ui/model/notice.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/program_menu.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/scene/model_mesh.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/sent_vertices.h"
#include "texplorer/scene/tex_coords.h"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace texplorer::ui {
namespace {

constexpr const char* commandsHint = N_("Drag numbers, click names and switches");
constexpr const char* makingHint = N_("Making the program…");

void toolRow(const Session& session, CommandsTabState& state) {
    const char* copy = N_("Copy");
    const char* save = N_("Export…");
    const char* hint = workers(session).programs->isMaking() ? makingHint : commandsHint;
    const float inner = ImGui::GetStyle().ItemInnerSpacing.x;
    const float width = buttonWidth(copy) + inner + buttonWidth(save);
    bool all = session.window.allCalls;
    if (ImGui::Checkbox(label("All calls"), &all))
        act(session, [all](Session& changed) { changed.window.allCalls = all; });
    item("all commands", "Off: only the calls that change OpenGL's initial state");
    ImGui::SameLine(0, ImGui::GetFontSize());
    if (ImGui::GetContentRegionAvail().x > ImGui::CalcTextSize(tr(hint)).x + ImGui::GetFontSize() + width) {
        labelText(hint, color::dim);
        noteItem(hint == makingHint ? "commands:making" : "commands:hint");
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - width);
    if (button(copy, "commands:copy", "Copies the listed program as C")) {
        const std::string program = emit::textOf(state.lines, all);
        ImGui::SetClipboardText(program.c_str());
        act(session, [lines = std::ranges::count(program, '\n')](Session& s) {
            tell(s, Sentence("Copied: {0} lines", lines));
        });
    }
    ImGui::SameLine(0, inner);
    if (button(save, "commands:export", "Writes a file with a program in C that draws the scene"))
        ImGui::OpenPopup("export");
    const ImVec2 corner = ImGui::GetItemRectMax();
    const float height =
        ImGui::GetFrameHeightWithSpacing() * static_cast<float>(emit::flavourRows.size() + 1);
    const bool hasRoom = corner.y + height < ImGui::GetIO().DisplaySize.y;
    ImGui::SetNextWindowPos({corner.x, hasRoom ? corner.y : ImGui::GetItemRectMin().y}, ImGuiCond_Appearing,
                            {1, hasRoom ? 0.0F : 1.0F}); // next to the button, not over it
    if (beginPopup("export")) {
        programMenuItems(session);
        endPopup();
    }
}

/// A list that a model has for each unit.
struct UnitList {
    std::size_t model;
    std::size_t unit;

    /// The coordinates of a vertex for this unit, which its glTexCoord sets.
    [[nodiscard]] std::string coordsOf(std::size_t vertex) const {
        return fmt::format("{}.{}[{}]", elementOf<&Scene::models>(model),
                           findKey(memberId<&Model::texCoords>, unit), vertex);
    }
};

/// The list, if the path is that of one.
template<auto Member>
std::optional<UnitList> unitListAt(const Scene& scene, const std::string& path) {
    for (std::size_t i = 0; i < scene.models.size(); ++i) {
        for (std::size_t unit = 0; unit < maxUnits; ++unit) {
            if (path == fmt::format("{}.{}", elementOf<&Scene::models>(i), findKey(memberId<Member>, unit)))
                return UnitList{i, unit};
        }
    }
    return std::nullopt;
}

/// A list whose vertices stand in lines of their own, if that is what the path stands for.
std::optional<Value> vertexListAt(const Scene& scene, const std::string& path) {
    if (const auto list = unitListAt<&Model::texCoords>(scene, path)) {
        const Model& model = scene.models[list->model];
        return effectiveTexCoords(model, meshOf(model), static_cast<int>(list->unit));
    }
    Result<ParamAt> at = paramAt(scene, path);
    if (at && !path.ends_with(']') && hasElements(*at->row))
        return std::move(at->value);
    return std::nullopt;
}

/// The calls that one scene leaves out and the other doesn't.
ChangedPaths changedCalls(const UnitList& list, const Scene& now, const Scene& was) {
    ChangedPaths changed;
    if (list.model >= was.models.size())
        return changed;
    const std::vector<int>& left = now.models[list.model].noTexCoord[list.unit];
    const std::vector<int>& before = was.models[list.model].noTexCoord[list.unit];
    const auto addOf = [&](const std::vector<int>& some, const std::vector<int>& others) {
        for (const int vertex : some)
            if (std::ranges::find(others, vertex) == others.end())
                changed.insert(list.coordsOf(static_cast<std::size_t>(vertex)));
    };
    addOf(left, before);
    addOf(before, left);
    return changed;
}

/// The changes of the last undo step: the parameter, or the changed vertices of a list.
ChangedPaths changedPaths(const Document& document) {
    const std::string& path = document.lastChanged;
    if (path.empty())
        return {};
    const History& history = document.history;
    if (const auto calls = unitListAt<&Model::noTexCoord>(document.scene, path); calls && history.canUndo())
        return changedCalls(*calls, document.scene, history.sceneOf(history.position() - 1));
    const auto is = vertexListAt(document.scene, path);
    const auto was =
        is && history.canUndo() ? vertexListAt(history.sceneOf(history.position() - 1), path) : std::nullopt;
    if (!was)
        return {path};
    ChangedPaths changed;
    const auto compare = [&](const auto& now, const auto& before) {
        for (std::size_t vertex = 0; vertex < now.size(); ++vertex) {
            if (vertex >= before.size() || before[vertex] != now[vertex])
                changed.insert(fmt::format("{}[{}]", path, vertex));
        }
    };
    if (const auto* points = std::get_if<SharedList<glm::vec3>>(&*is))
        compare(*points, std::get<SharedList<glm::vec3>>(*was));
    else if (const auto* coords = std::get_if<SharedList<glm::vec4>>(&*is))
        compare(*coords, std::get<SharedList<glm::vec4>>(*was));
    else
        return {path};
    return changed;
}

bool mentionsAny(const emit::Line& line, const ChangedPaths& paths) {
    return std::ranges::any_of(line.parts, [&](const emit::Part& part) { return paths.contains(part.path); });
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
/// Returns true if there is something new to show.
bool renewLines(Session& session, CommandsTabState& state) {
    const Document& document = session.document;
    const Scene& scene = document.scene;
    const bool isSame = state.scene && *state.scene == scene && state.images == document.images;
    const bool wasMaking = workers(session).programs->isMaking();
    if (isSame && !wasMaking) // the running work is for another scene: cancel it
        return false;
    const std::optional<emit::ProgramWorker::Program> made = programNow(session, emit::Flavour::Fixed);
    if (!made)
        return !wasMaking;
    state.changed = changedPaths(document);
    state.rowsAreOld = true;
    state.refused = *made ? Sentence() : describe(made->error());
    std::vector<emit::Line> lines = made->value_or(std::vector<emit::Line>{});
    const auto changedIn = [&](const std::vector<emit::Line>& among) {
        return std::ranges::count_if(
            among, [&](const emit::Line& line) { return mentionsAny(line, state.changed); });
    };
    // A number that is dragged to a value for which its call is not needed stays under the pointer.
    if (ImGui::IsAnyItemActive() && changedIn(lines) < changedIn(state.lines))
        return false;
    state.lines = std::move(lines);
    state.scene = scene;
    state.images = document.images;
    return true;
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

/// The calls before those that the last step has left out: those of the vertices whose coordinates the others
/// have now; of the first ones, any call of the list.
ChangedPaths callsBesideChanged(const Scene& scene, const CommandsTabState& state) {
    ChangedPaths beside;
    const auto calls = unitListAt<&Model::noTexCoord>(scene, state.lastChanged);
    if (!calls)
        return beside;
    const Model& model = scene.models[calls->model];
    const auto sources = coordSources(model, meshOf(model), static_cast<int>(calls->unit));
    for (std::size_t vertex = 0; vertex < sources.size(); ++vertex) {
        if (sources[vertex] && state.changed.contains(calls->coordsOf(vertex)))
            beside.insert(calls->coordsOf(*sources[vertex]));
    }
    for (std::size_t vertex = 0; beside.empty() && vertex < sources.size(); ++vertex) {
        if (sources[vertex] == vertex)
            beside.insert(calls->coordsOf(vertex));
    }
    return beside;
}

/// Scrolls once to the last changed line, if it is not visible; to where it was if its call is left out.
void showChanged(const Session& session, CommandsTabState& state, float rowHeight) {
    if (state.revealed == state.changed)
        return;
    const auto rowOf = [&](const ChangedPaths& paths) {
        return std::ranges::find_if(
            state.rows, [&](const CodeRow& row) { return mentionsAny(state.lines[row.line], paths); });
    };
    auto found = rowOf(state.changed);
    if (found == state.rows.end())
        found = rowOf(callsBesideChanged(session.document.scene, state));
    if (found == state.rows.end()) // the program that has it may not be ready
        return;
    state.revealed = state.changed;
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
    showChanged(session, state, rowHeight);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(state.rows.size()), rowHeight);
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            drawRow(session, state, state.rows[static_cast<std::size_t>(i)], letter);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
    ImGui::EndChild();
    ask(session, [&state](Session& changed) { return renewLines(changed, state); });
}

} // namespace texplorer::ui
