#include "app/ui/language/translate.h"
#include "app/ui/model/preset_edits.h"
#include "app/ui/parameters/sections.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/list_buttons.h"
#include "app/ui/widgets/model_choice.h"
#include "app/ui/widgets/segments.h"
#include "texplorer/preset/preset.h"
#include "texplorer/scene/drawn_models.h"
#include "texplorer/scene/params/keys.h"
#include "texplorer/scene/texture_matrix.h"

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

/// A list of steps; the names of its widgets in tests begin with `name`.
struct StepList {
    std::string path;
    std::size_t count;
    const char* name = "";
};

StepList stepsOfPass(const Session& session) {
    return {fmt::format("{}.{}", selectedUnitPath(session), keyOf<&Unit::matrix>()),
            selectedUnit(session).matrix.size()};
}

/// For the selected unit of the selected model.
StepList stepsOfModel(const Session& session, const Model& model) {
    const Selection& selection = session.look.selection;
    const auto unit = static_cast<std::size_t>(selection.unit);
    return {fmt::format("{}.{}.{}", elementOf<&Scene::models>(static_cast<std::size_t>(selection.model)),
                        elementOf<&Model::units>(unit), keyOf<&ModelUnit::matrix>()),
            model.units[unit].matrix.size(), "model's "};
}

void addStep(const Session& session, const StepList& steps, const EnumRow& op) {
    const auto& [list, count, name] = steps;
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
void addStepButtons(const Session& session, const StepList& steps, int perLine) {
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
    ImGui::BeginDisabled(steps.count >= maxMatrixSteps);
    for (std::size_t i = 0; i < matrixOpRows.size(); ++i) {
        const EnumRow& op = matrixOpRows[i];
        if (static_cast<int>(i) % perLine > 0)
            ImGui::SameLine(0, gap);
        if (ImGui::Button(fmt::format("{}###{}", tr(Sentence("+ {0}", op.label)), op.name).c_str(),
                          {width, 0})) {
            addStep(session, steps, op);
            ImGui::CloseCurrentPopup(); // if they are in a popup
        }
        item(fmt::format("{}add:{}", steps.name, op.name), op.help);
    }
    ImGui::EndDisabled();
}

void stepRows(const Session& session, const StepList& steps, const std::vector<ShownStruct>& places) {
    std::size_t i = 0;
    for (const ShownStruct& place : places) {
        if (!place.owner.path.starts_with(steps.path + '['))
            continue;
        ImGui::PushID(place.owner.path.c_str());
        labelText(Sentence("Step {0}", i + 1), color::dim);
        constexpr ListWords words{
            N_("matrix step"),      "", N_("Move this step up"),    N_("Move this step down"),
            N_("Remove this step"), "", N_("Reorder matrix steps"), N_("Remove matrix step")};
        if (const std::optional<ListEdit> pressed = elementButtons(words, place.owner.path, i, steps.count))
            submit(session, {.name = words.nameOf(*pressed),
                             .edits = {editOf(*pressed, steps.path, i)},
                             .path = steps.path});
        paramRows(session, place.owner, *place.table, {.captions = false});
        ImGui::Separator();
        ImGui::PopID();
        ++i;
    }
}

/// That models before the selected one left in its pass, without a glPopMatrix.
std::size_t stepsOfEarlierModels(const Session& session) {
    const Selection& selection = session.look.selection;
    const auto pass = static_cast<std::size_t>(selection.pass);
    const auto model = static_cast<std::size_t>(selection.model);
    const Scene& scene = presentScene(session);
    const std::vector<std::size_t> drawn = drawnModels(scene, scene.passes[pass]);
    if (std::ranges::find(drawn, model) == drawn.end())
        return 0;
    const PlacedSteps steps = textureSteps(scene, pass, static_cast<std::size_t>(selection.unit), model);
    return static_cast<std::size_t>(std::ranges::count_if(steps, [&](const PlacedStep& placed) {
        return placed.pass == pass && placed.model && placed.model != model;
    }));
}

/// What is multiplied after the steps of the pass, for one model.
void modelSteps(const Session& session, const std::vector<ShownStruct>& places) {
    const Model* model = selectedModel(session);
    if (!model)
        return;
    static const Model initial;
    const Owner owner{model, &initial,
                      elementOf<&Scene::models>(static_cast<std::size_t>(session.look.selection.model))};
    const StepList steps = stepsOfModel(session, *model);
    caption("Then, for the model");
    const float width = std::max(1.0F, ImGui::GetContentRegionAvail().x);
    modelChoice(session, width, width);
    if (const std::size_t left = stepsOfEarlierModels(session); left > 0)
        dimText(Sentence("Earlier models left {0}", Sentence::plural("{0} step", "{0} steps", left)));
    if (steps.count > 0 || !model->pushMatrix)
        paramWidget(session, owner, *findParam(modelTable(), keyOf<&Model::pushMatrix>()));
    stepRows(session, steps, places);
    ImGui::PushID("model");
    addStepButtons(session, steps, 3);
    ImGui::PopID();
}

/// That the pass goes on from.
std::size_t leftStepCount(const Session& session) {
    const Selection& selection = session.look.selection;
    return inheritedSteps(presentScene(session), static_cast<std::size_t>(selection.pass),
                          static_cast<std::size_t>(selection.unit))
        .size();
}

} // namespace

std::size_t matrixStepCount(const Session& session) {
    const Model* model = selectedModel(session);
    return leftStepCount(session) + stepsOfPass(session).count +
           (model ? stepsOfEarlierModels(session) + stepsOfModel(session, *model).count : 0);
}

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
        choosePreset(session, *motion, stepsOfPass(session).path);
    else if (pressed == motions.size())
        ImGui::OpenPopup("steps");
    if (ImGui::BeginPopup("steps")) {
        ImGui::Dummy({ImGui::GetFontSize() * 16, 0});
        addStepButtons(session, stepsOfPass(session), 2);
        ImGui::EndPopup();
    }
    ImGui::PopID();
}

void matrixSection(const Session& session) {
    const std::vector<ShownStruct> places = shownStructs(session, Section::Matrix);
    const StepList steps = stepsOfPass(session);
    paramWidget(session, unitOwner(session), *findParam(unitTable(), keyOf<&Unit::matrixStart>()));
    if (const std::size_t left = leftStepCount(session); left > 0)
        dimText(Sentence("Earlier passes left {0}", Sentence::plural("{0} step", "{0} steps", left)));
    else if (places.empty())
        wrappedText("The identity: coordinates are unchanged. Each step moves, turns or scales them.");
    stepRows(session, steps, places);
    addStepButtons(session, steps, 3);
    motionButtons(session);
    modelSteps(session, places);
    ImGui::Spacing();
}

} // namespace texplorer::ui
