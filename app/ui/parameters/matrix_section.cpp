#include "app/ui/language/translate.h"
#include "app/ui/model/preset_edits.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/params/keys.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace texplorer::ui {
namespace {

/// Presets of core/preset, with the text of the button.
struct Motion {
    std::string_view preset;
    const char* label;
};
constexpr std::array motions{Motion{"scroll", N_("Scroll")}, Motion{"spin", N_("Spin")},
                             Motion{"pulse", N_("Pulse")}, Motion{"rotate-centre", N_("Rotate")}};

std::string matrixPath(const Session& session) {
    return fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::matrix>());
}

void addStep(const Session& session, const EnumRow& op) {
    const std::string list = matrixPath(session);
    const std::size_t count = selectedUnit(session).matrix.size();
    const std::string step = fmt::format("{}[{}].", list, count);
    std::vector<Edit> edits{edit::Insert{list, count},
                            edit::Set{step + keyOf<&MatrixStep::op>(), std::string(op.name)}};
    const auto kind = static_cast<MatrixOp>(op.value);
    if (kind == MatrixOp::Scale || kind == MatrixOp::Rotate)
        edits.emplace_back(
            edit::Set{step + keyOf<&MatrixStep::amount>(), kind == MatrixOp::Scale ? "1,1,1" : "0,0,1"});
    submit(session, {.name = N_("Add matrix step"), .edits = std::move(edits), .path = list});
}

void offerMotion(const Session& session, const Motion& motion) {
    noteItem(fmt::format("motion:{}", motion.preset));
    const Preset* preset = findPreset(motion.preset);
    if (!preset)
        return;
    helpTip(Sentence("{0}\n{1}\n{2}", preset->label, preset->help, preset->look));
    if (ImGui::IsItemHovered())
        previewPreset(session, *preset);
}

/// A button for each operation, which adds a step: at most `perLine` buttons per line.
void addStepButtons(const Session& session, int perLine) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x;
    const auto widthFor = [gap](int count) {
        return (ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * gap) /
               static_cast<float>(count);
    };
    float widest = 0;
    for (const EnumRow& op : matrixOpRows)
        widest = std::max(widest, buttonWidth(Sentence("+ {0}", op.label)));
    while (perLine > 1 && widthFor(perLine) < widest)
        --perLine;
    const float width = widthFor(perLine);
    ImGui::BeginDisabled(selectedUnit(session).matrix.size() >= maxMatrixSteps);
    for (std::size_t i = 0; i < matrixOpRows.size(); ++i) {
        const EnumRow& op = matrixOpRows[i];
        if (static_cast<int>(i) % perLine > 0)
            ImGui::SameLine(0, gap);
        if (ImGui::Button(fmt::format("{}###{}", tr(Sentence("+ {0}", op.label)), op.name).c_str(),
                          {width, 0})) {
            addStep(session, op);
            ImGui::CloseCurrentPopup(); // if they are in a popup
        }
        item(fmt::format("add:{}", op.name), op.help);
    }
    ImGui::EndDisabled();
}

} // namespace

void motionButtons(const Session& session) {
    std::vector<Segment> buttons = segmentsOf(motions, &Motion::label);
    buttons.push_back({N_("+ Step")});
    ImGui::PushID("motions");
    const auto pressed =
        drawSegments(buttons, ImGui::GetContentRegionAvail().x, std::nullopt, [&](std::size_t number) {
            if (number < motions.size())
                return offerMotion(session, motions[number]);
            item("add matrix step", "Adds a step at the end of the texture matrix");
        });
    const Preset* motion =
        pressed && *pressed < motions.size() ? findPreset(motions[*pressed].preset) : nullptr;
    if (motion)
        choosePreset(session, *motion, matrixPath(session));
    else if (pressed == motions.size())
        ImGui::OpenPopup("steps");
    if (ImGui::BeginPopup("steps")) {
        ImGui::Dummy({ImGui::GetFontSize() * 16, 0});
        addStepButtons(session, 2);
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

void matrixSection(const Session& session) {
    const std::vector<ShownStruct> steps = shownStructs(session, Section::Matrix);
    if (steps.empty())
        wrappedText("The identity: coordinates are unchanged. Each step moves, turns or scales them.");
    for (std::size_t i = 0; i < steps.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        labelText(Sentence("Step {0}", i + 1), color::dim);
        constexpr ListWords words{
            N_("matrix step"),      "", N_("Move this step up"),    N_("Move this step down"),
            N_("Remove this step"), "", N_("Reorder matrix steps"), N_("Remove matrix step")};
        if (const std::optional<ListEdit> pressed =
                elementButtons(words, steps[i].owner.path, i, steps.size())) {
            const std::string list = matrixPath(session);
            submit(session,
                   {.name = words.nameOf(*pressed), .edits = {editOf(*pressed, list, i)}, .path = list});
        }
        paramRows(session, steps[i].owner, matrixStepTable(), {.captions = false});
        ImGui::Separator();
        ImGui::PopID();
    }
    addStepButtons(session, 3);
    motionButtons(session);
    ImGui::Spacing();
}

} // namespace texplorer::ui
