#include "app/ui/parameters/parameters_panel.h"

#include "app/ui/model/scene_files.h"
#include "app/ui/parameters/combine_section.h"
#include "app/ui/parameters/coordinates_section.h"
#include "app/ui/parameters/model_section.h"
#include "app/ui/parameters/pass_section.h"
#include "app/ui/parameters/texture_section.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/number_choice.h"
#include "app/ui/widgets/panel.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/theme.h"
#include "core/base/count.h"
#include "core/scene/params/keys.h"

#include <fmt/core.h>

#include <array>
#include <cfloat>
#include <utility>

namespace texplorer::ui {
namespace {

std::string indexed(std::string_view list, int index) {
    return fmt::format("{}[{}]", list, index);
}

/// The section in which a parameter is edited.
Section sectionOf(std::string_view path) {
    constexpr std::array<std::pair<std::string_view, Section>, 10> parts{{{"textures[", Section::Texture},
                                                                          {".combine", Section::Combine},
                                                                          {".texGen", Section::Coordinates},
                                                                          {".matrix", Section::Matrix},
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
    std::string text;
    ImU32 tint;
};

void drawMarks(const std::vector<Mark>& marks) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const float y = ImGui::GetItemRectMin().y + ImGui::GetStyle().FramePadding.y;
    float x = ImGui::GetItemRectMax().x - gap;
    for (auto mark = marks.rbegin(); mark != marks.rend(); ++mark) {
        x -= ImGui::CalcTextSize(mark->text.c_str()).x + gap;
        ImGui::GetWindowDrawList()->AddText({x, y}, mark->tint, mark->text.c_str());
    }
}

/// A section that has marks is in use: it is open until the user shuts it, and says what is in it even then.
bool section(Session& session, Section which, const std::vector<Mark>& marks = {}) {
    const SectionRow& row = rowOf(which);
    const bool named = session.window.wantedSection == which;
    if (named || (!session.window.wantedParam.empty() && sectionOf(session.window.wantedParam) == which))
        ImGui::SetNextItemOpen(true);
    else if (!marks.empty())
        ImGui::SetNextItemOpen(true, ImGuiCond_Once);
    const bool shown = ImGui::CollapsingHeader(row.title, row.open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    noteItem(std::string("section:") + row.title);
    if (!marks.empty())
        noteItem(std::string("in use:") + row.title);
    drawMarks(marks);
    if (named)
        ImGui::SetScrollHereY(0);
    return shown;
}

/// A dot marks the units that are on.
void unitChoice(Session& session) {
    std::vector<NumberChoice> choices;
    choices.reserve(maxUnits);
    for (int i = 0; i < maxUnits; ++i) {
        const bool on = selectedPass(session).units[static_cast<std::size_t>(i)].enabled;
        const std::string sharers = sharersText(session, i);
        choices.push_back(
            {on, std::string(on ? "This unit is on." : "This unit is off.") +
                     (sharers.empty() ? "" : fmt::format("\nIt shares its texture with {}.", sharers))});
    }
    numberChoice("Texture unit", "Unit", "unit", choices, session.window.selection.unit);
}

void unitSection(Session& session) {
    static const Unit initial;
    const auto accepts = [&](const ParamRow& row, const Value& value) {
        const bool lacksTexture =
            row.key == keyOf<&Unit::enabled>() && std::get<bool>(value) && boundTexture(session) == nullptr;
        if (lacksTexture)
            say(session, "A unit needs a texture before it can be enabled: add one with +.");
        return !lacksTexture;
    };
    const Owner owner{&selectedUnit(session), &initial, selectedUnitPath(session), accepts};
    std::string_view group;
    for (const ParamRow& row : unitTable().params) {
        if (row.key == keyOf<&Unit::texture>()) // chosen by its name, in the section of the texture
            continue;
        if (!group.empty() && row.group != group)
            caption(row.group);
        group = row.group;
        paramWidget(session, owner, row);
        if (row.key == keyOf<&Unit::enabled>())
            sharingNote(session, "of the unit");
    }
}

void moveStep(Session& session, std::vector<MatrixStep>& steps, std::size_t from, std::size_t to) {
    std::swap(steps[from], steps[to]);
    sealEdit(session);
    recordEdit(session, "Reorder matrix steps");
    sealEdit(session);
}

void matrixSection(Session& session) {
    std::vector<MatrixStep>& steps = selectedUnit(session).matrix;
    static const MatrixStep initial;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    if (steps.empty())
        ImGui::TextWrapped(
            "The identity: coordinates reach the image as they are. Each step moves, turns or scales them.");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const std::string path =
            fmt::format("{}.{}", selectedUnitPath(session), indexed("matrix", static_cast<int>(i)));
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("Step %d", static_cast<int>(i) + 1);
        constexpr ListWords words{"matrix step", "", "Multiply this step earlier", "Multiply this step later",
                                  "Remove this step"};
        const std::optional<ListEdit> pressed = elementButtons(words, path, i, steps.size());
        if (pressed == ListEdit::Up)
            moveStep(session, steps, i, i - 1);
        else if (pressed == ListEdit::Down)
            moveStep(session, steps, i, i + 1);
        else if (pressed == ListEdit::Remove) {
            steps.erase(steps.begin() + static_cast<std::ptrdiff_t>(i));
            sealEdit(session);
            recordEdit(session, "Remove matrix step");
            sealEdit(session);
            ImGui::PopID();
            break; // the rest is drawn at the next frame
        }
        const Owner owner{&steps[i], &initial, path};
        for (const ParamRow& row : matrixStepTable().params) {
            if (isRelevant(session, owner, row))
                paramWidget(session, owner, row);
        }
        ImGui::Separator();
        ImGui::PopID();
    }
    ImGui::BeginDisabled(steps.size() >= maxMatrixSteps);
    constexpr std::size_t perLine = 3;
    const float width = (ImGui::GetContentRegionAvail().x - 2 * gap) / static_cast<float>(perLine);
    for (std::size_t i = 0; i < matrixOpRows.size(); ++i) {
        const EnumRow& op = matrixOpRows[i];
        if (i % perLine > 0)
            ImGui::SameLine(0, gap);
        const std::string label = "+ " + std::string(op.label);
        if (ImGui::Button(label.c_str(), {width, 0})) {
            MatrixStep step;
            step.op = static_cast<MatrixOp>(op.value);
            if (step.op == MatrixOp::Scale)
                step.amount = glm::vec3(1);
            if (step.op == MatrixOp::Rotate)
                step.amount = {0, 0, 1};
            steps.push_back(step);
            sealEdit(session);
            recordEdit(session, "Add matrix step");
            sealEdit(session);
        }
        noteItem("add:" + std::string(op.name));
        helpTip(op.help);
    }
    ImGui::EndDisabled();
}

/// The coordinates that the unit makes itself.
std::vector<Mark> generatedMarks(const Unit& unit) {
    std::vector<Mark> marks;
    constexpr std::array<const char*, 4> letters{"s", "t", "r", "q"};
    const std::array<bool, 4> on{unit.texGenS.enabled, unit.texGenT.enabled, unit.texGenR.enabled,
                                 unit.texGenQ.enabled};
    for (std::size_t i = 0; i < letters.size(); ++i) {
        if (on[i])
            marks.push_back({letters[i], componentColor(static_cast<int>(i))});
    }
    if (unit.emboss.enabled)
        marks.push_back({"emboss", color::changed});
    return marks;
}

std::vector<Mark> matrixMarks(const Unit& unit) {
    const std::size_t steps = unit.matrix.size();
    if (steps == 0)
        return {};
    return {{countOf(steps, "step"), color::changed}};
}

std::vector<Mark> passMarks(const Scene& scene) {
    if (scene.passes.size() < 2)
        return {};
    return {{fmt::format("{} passes", scene.passes.size()), color::changed}};
}

} // namespace

void drawParametersPanel(Session& session, const Layout& layout, const Pictures& pictures) {
    beginPanel("Parameters", layout.parameters, ImGuiWindowFlags_AlwaysVerticalScrollbar);
    static const Scene initial;
    static const View start = defaultScene().view;
    passChoice(session);
    unitChoice(session);
    ImGui::Dummy({0, ImGui::GetFontSize() * 0.2F});
    if (section(session, Section::Texture))
        textureSection(session, pictures);
    if (section(session, Section::Unit))
        unitSection(session);
    if (selectedUnit(session).envMode == EnvMode::Combine && section(session, Section::Combine))
        combineSection(session);
    if (section(session, Section::Coordinates, generatedMarks(selectedUnit(session))))
        coordinatesSection(session);
    if (section(session, Section::Matrix, matrixMarks(selectedUnit(session))))
        matrixSection(session);
    if (section(session, Section::Model))
        modelSection(session);
    if (section(session, Section::Pass, passMarks(session.document.scene)))
        passSection(session);
    if (section(session, Section::Light)) {
        paramRows(session, {&session.document.scene.light, &initial.light, "light"}, lightTable());
        caption("Projector");
        paramRows(session,
                  {&session.document.scene.light.projector, &initial.light.projector,
                   pathOf<&Scene::light, &Light::projector>()},
                  projectorTable());
    }
    if (section(session, Section::Material))
        paramRows(session, {&session.document.scene.material, &initial.material, "material"},
                  materialTable());
    if (section(session, Section::View))
        paramRows(session, {&session.document.scene.view, &start, "view"}, viewTable());
    session.window.wantedSection.reset();
    session.window.wantedParam.clear(); // what has no control of its own is not waited for
    ImGui::End();
}

} // namespace texplorer::ui
