#include "app/ui/parameters/parameters_panel.h"

#include "app/ui/language/translate.h"
#include "app/ui/model/param_match.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/keys.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/popups.h"
#include "app/ui/widgets/segments.h"
#include "app/ui/widgets/text_field.h"
#include "app/ui/widgets/theme.h"
#include "texplorer/base/sentence.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace texplorer::ui {
namespace {

/// The section in which a parameter is edited.
Section sectionOf(std::string_view path) {
    constexpr std::array<std::pair<std::string_view, Section>, 12> parts{{{"textures[", Section::Texture},
                                                                          {".combine", Section::Combine},
                                                                          {".texGen", Section::Coordinates},
                                                                          {".emboss", Section::Coordinates},
                                                                          {".matrix", Section::Matrix},
                                                                          {".pushMatrix", Section::Matrix},
                                                                          {".texture", Section::Texture},
                                                                          {".units", Section::Unit},
                                                                          {"models[", Section::Model},
                                                                          {"passes[", Section::Pass},
                                                                          {"light", Section::Light},
                                                                          {"material", Section::Material}}};
    for (const auto& [part, section] : parts) {
        if (path.find(part) != std::string_view::npos)
            return section;
    }
    return Section::View;
}

/// A word at the right end of a section's title.
struct Mark {
    Sentence text;
    ImU32 tint;
};

void drawMarks(const std::vector<Mark>& marks) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float y = ImGui::GetItemRectMin().y + ImGui::GetStyle().FramePadding.y;
    float x = ImGui::GetItemRectMax().x - gap;
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
        const std::string words = tr(mark->text);
        x -= ImGui::CalcTextSize(words.c_str()).x + gap;
        ImGui::GetWindowDrawList()->AddText({x, y}, mark->tint, words.c_str());
    }
}

/// The title of a section, which closes and opens it. A section without effect is initially closed and dim.
bool section(const Session& session, Section which, const std::vector<Mark>& marks = {},
             const Sentence& idle = {}) {
    const SectionRow& row = rowOf(which);
    const bool named = session.out.wantedSection == which;
    if (named || (!session.out.wantedParam.empty() && sectionOf(session.out.wantedParam) == which))
        ImGui::SetNextItemOpen(true);
    ImGui::PushStyleColor(ImGuiCol_Text, idle.empty() ? color::text : color::dim);
    ImGui::PushID(idle.empty() ? "in use" : "idle"); // it opens when it has an effect
    const bool shown =
        ImGui::CollapsingHeader(label(row.title), idle.empty() ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    ImGui::PopID();
    ImGui::PopStyleColor();
    noteItem(std::string("section:") + row.title);
    if (!marks.empty())
        noteItem(std::string("in use:") + row.title);
    if (!idle.empty())
        helpTip(idle);
    drawMarks(marks);
    if (named)
        ImGui::SetScrollHereY(0);
    return shown;
}

/// The coordinates that the unit generates.
std::vector<Mark> generatedMarks(const Unit& unit) {
    std::vector<Mark> marks;
    constexpr std::array<const char*, 4> letters{"s", "t", "r", "q"};
    const std::array<bool, 4> on{unit.texGenS.enabled, unit.texGenT.enabled, unit.texGenR.enabled,
                                 unit.texGenQ.enabled};
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (on[i])
            marks.push_back({ProperName{letters[i]}, componentColor(static_cast<int>(i))});
    }
    if (unit.emboss.enabled)
        marks.push_back({N_("Emboss"), color::changed});
    return marks;
}

std::vector<Mark> matrixMarks(const Session& session) {
    const std::size_t steps = matrixStepCount(session);
    if (steps == 0)
        return {};
    return {{Sentence::plural("{0} step", "{0} steps", steps), color::changed}};
}

/// The selected unit and its environment.
void unitSection(const Session& session) {
    const std::string_view environment = findParam(unitTable(), keyOf<&Unit::envMode>())->group;
    RowOptions options;
    // The texture is chosen by its name, in the place where it is edited, and the matrix has its own section.
    options.leavesOut = [](const ParamRow& row) {
        return row.member == memberId<&Unit::texture> || row.member == memberId<&Unit::matrixStart>;
    };
    options.after = [&](std::string_view group) {
        if (group == environment)
            environmentLine(session);
    };
    paramRows(session, unitOwner(session), unitTable(), options);
}

void unitTab(const Session& session, const Pictures& /*pictures*/) {
    if (section(session, Section::Unit))
        unitSection(session);
    const EnvMode mode = selectedUnit(session).envMode;
    const Sentence idle(N_("No effect now: the mode is {0}."), ProperName{rowOf(mode).name});
    if (section(session, Section::Combine, {}, mode == EnvMode::Combine ? Sentence() : idle))
        combineSection(session);
}

void coordinatesTab(const Session& session, const Pictures& /*pictures*/) {
    if (section(session, Section::Matrix, matrixMarks(session)))
        matrixSection(session);
    if (section(session, Section::Coordinates, generatedMarks(selectedUnit(session))))
        coordinatesSection(session);
}

/// A section with nothing but rows: those of each struct after the first are below its title.
void sectionOfRows(const Session& session, Section which) {
    if (!section(session, which))
        return;
    bool isFirst = true;
    for (const ShownStruct& place : shownStructs(session, which)) {
        if (!std::exchange(isFirst, false))
            caption(place.title);
        paramRows(session, place.owner, *place.table);
    }
}

void lightTab(const Session& session, const Pictures& /*pictures*/) {
    sectionOfRows(session, Section::Light);
    sectionOfRows(session, Section::Material);
}

void viewTab(const Session& session, const Pictures& /*pictures*/) {
    if (section(session, Section::Model))
        modelSection(session);
    sectionOfRows(session, Section::View);
}

/// In the order of ParameterTab.
constexpr std::array<void (*)(const Session& session, const Pictures& pictures), parameterTabRows.size()>
    drawTabs{essentials,
             textureSection,
             unitTab,
             coordinatesTab,
             [](const Session& session, const Pictures&) { passSection(session); },
             lightTab,
             viewTab};

/// The search field, and the switch to OpenGL's names.
void searchLine(const Session& session, ParametersState& state) {
    constexpr const char* names = "GL";
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float button = ImGui::CalcTextSize(names).x + 2 * ImGui::GetStyle().FramePadding.x;
    const float clear = state.search.empty() ? 0 : ImGui::GetFrameHeight() + gap;
    if (std::exchange(session.out.wantsSearch, false))
        focusNextWidget();
    const float width = ImGui::GetContentRegionAvail().x - button - gap - clear;
    constexpr std::array hints{N_("Search parameters (Ctrl+F)"), N_("Search (Ctrl+F)"), N_("Search")};
    const auto* hint =
        std::ranges::find_if(hints, [&](const char* each) { return buttonWidth(each) <= width; });
    ImGui::SetNextItemWidth(width);
    textField("##search", state.search, 0, hint == hints.end() ? hints.back() : *hint);
    noteItem("search");
    if (ImGui::IsItemDeactivated() && isKeyPressed(key::escape, false))
        state.search.clear();
    helpTip("Searches labels, OpenGL's names, choices and help: \"aniso\", \"GL_TEXTURE_MIN\", \"wrap\". "
            "Escape ends the search.");
    ImGui::SameLine(0, gap);
    if (!state.search.empty()) {
        if (squareButton("✕", N_("clear search"), "Ends the search", true))
            state.search.clear();
        ImGui::SameLine(0, gap);
    }
    const bool glNames = session.settings.glNames;
    if (markedButton(names, glNames))
        act(session, [](Session& changed) { changed.settings.glNames = !changed.settings.glNames; });
    item("GL names",
         glNames ? N_("Shows plain words again")
                 : N_("Shows OpenGL's names of parameters and choices: GL_TEXTURE_WRAP_S, GL_REPEAT"));
}

/// Draws every parameter that matches the search, with its tab and its control: first those with a matching
/// name.
void searchResults(const Session& session, std::string_view words) {
    std::size_t found = 0;
    for (const int wanted : {2, 1}) {
        for (const ShownStruct& place : shownStructs(session)) {
            bool titled = false;
            for (const ParamRow& row : place.table->params) {
                if (matchOf(row, words) != wanted)
                    continue;
                if (!std::exchange(titled, true)) {
                    const char* tab = rowOf(rowOf(place.section).tab).label;
                    caption(place.title.empty() || place.title == tab
                                ? Sentence(tab)
                                : Sentence("{0} · {1}", tab, place.title));
                    noteItem(fmt::format("found in:{}", tab));
                }
                ++found;
                paramWidget(session, place.owner, row);
            }
        }
    }
    if (found == 0)
        wrappedText("No parameter matches: the label, OpenGL's name, the choices and the help are searched.");
    noteItem(fmt::format("found:{}", found));
}

void noteTab(std::size_t number) {
    item(fmt::format("parameters:{}", parameterTabRows.at(number).label), parameterTabRows.at(number).help);
}

/// A choice instead of the tabs, if their buttons would leave no height for the content.
std::optional<std::size_t> tabList(const ParametersState& state) {
    const char* shown = state.search.empty() ? rowOf(state.tab).label : N_("Search");
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool open = beginCombo("##tabs", tr(shown), ImGuiComboFlags_HeightLargest);
    noteItem("parameters' tabs");
    if (!open)
        return std::nullopt;
    std::optional<std::size_t> pressed;
    for (std::size_t i = 0; i < parameterTabRows.size(); ++i) {
        if (ImGui::Selectable(label(parameterTabRows.at(i).label),
                              state.search.empty() && parameterTabRows.at(i).tab == state.tab))
            pressed = i;
        noteTab(i);
    }
    endCombo();
    return pressed;
}

void tabBar(ParametersState& state) {
    constexpr float comfortable = 30; // height for large tabs, in letters' heights
    const bool isLow =
        targetHeight() > 0 && ImGui::GetContentRegionAvail().y < comfortable * ImGui::GetFontSize();
    const std::size_t maxLines = isLow ? 1 : 3;
    const std::vector<Segment> tabs = segmentsOf(parameterTabRows, &ParameterTabRow::label);
    const std::optional<SegmentPlan> plan = planSegments(tabs, ImGui::GetContentRegionAvail().x, maxLines);
    ImGui::PushID("tabs");
    const auto shown =
        state.search.empty() ? std::optional(static_cast<std::size_t>(state.tab)) : std::nullopt;
    const auto pressed = plan ? drawSegments(tabs, *plan, shown, noteTab) : tabList(state);
    ImGui::PopID();
    if (!pressed)
        return;
    state.tab = parameterTabRows.at(*pressed).tab;
    state.search.clear();
}

bool isEssentialsShown(const ParametersState& state) {
    return state.tab == ParameterTab::Essentials && state.search.empty();
}

/// Brings the requested tab to the front.
void bringForth(ParametersState& state, Section wanted) {
    state.tab = rowOf(wanted).tab;
    state.search.clear();
}

} // namespace

void drawParametersPanel(const Session& session, ParametersState& state, const Pictures& pictures,
                         const Layout& layout) {
    beginPanel(N_("Parameters"), layout.parameters,
               ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    constexpr float comfortable = 37; // height of Essentials, in letters' heights
    searchLine(session, state);
    passChoice(session);
    unitBar(session, pictures);
    Outbox& wanted = session.out;
    const std::optional<Section> asked = wanted.wantedSection;
    if (wanted.wantedSection)
        bringForth(state, *wanted.wantedSection);
    else if (!wanted.wantedParam.empty() && !isEssentialsShown(state)) // which may have it
        bringForth(state, sectionOf(wanted.wantedParam));
    tabBar(state);
    ImGui::Dummy({0, 0});

    const float em = ImGui::GetFontSize();
    const bool tight = targetHeight() == 0 && ImGui::GetContentRegionAvail().y < comfortable * em;
    const ImGuiStyle& style = ImGui::GetStyle();
    if (tight) {
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {style.FramePadding.x, std::floor(em * 0.07F)});
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.x, std::floor(em * 0.2F)});
    }
    const std::string id =
        state.search.empty() ? rowOf(state.tab).label : "results"; // each has its own scroll position
    const bool essential = isEssentialsShown(state);
    ImGui::BeginChild(id.c_str(), {0, 0}, false, essential ? 0 : ImGuiWindowFlags_AlwaysVerticalScrollbar);
    noteDrawn("parameters", ImGui::GetWindowPos(),
              {ImGui::GetWindowPos().x + ImGui::GetWindowWidth(),
               ImGui::GetWindowPos().y + ImGui::GetWindowHeight()});
    if (state.search.empty())
        drawTabs.at(static_cast<std::size_t>(state.tab))(session, pictures);
    else
        searchResults(session, state.search);
    ImGui::EndChild();
    if (tight)
        ImGui::PopStyleVar(2);
    if (wanted.wantedSection == asked) // else a button asked for another one
        wanted.wantedSection.reset();
    if (essential && !wanted.wantedParam.empty())
        bringForth(state, sectionOf(wanted.wantedParam)); // it is visible in the next frame
    else
        wanted.wantedParam.clear(); // a parameter without its own control is not waited for
    ImGui::End();
}

} // namespace texplorer::ui
