#include "app/ui/view/renderer_choice.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/buttons.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"
#include "app/ui/widgets/popups.h"

#include <functional>
#include <vector>

namespace texplorer::ui {

namespace {

constexpr const char* compareHelp = N_("Two renderers in one picture, or all of them with the difference.");
constexpr const char* nothingToCompare = N_("Only one renderer is available.");

constexpr const char* compareWords = N_("Compare");

std::string wordsOf(const EnumRow& renderer, RendererForm form) {
    return std::string(form == RendererForm::Buttons ? renderer.label : briefOf(renderer));
}

/// The current choice.
std::string chosenWords(const ViewSettings& settings) {
    return comparesRenderers(settings) ? compareWords : wordsOf(rowOf(settings.renderer), RendererForm::List);
}

constexpr const char* listSign = " ▾";

/// A renderer, or the comparison.
struct RendererChoice {
    std::string name;
    std::string words;
    bool chosen;
    bool offered;
    Sentence help;
    std::function<void(ViewSettings& settings)> choose;
};

std::vector<RendererChoice> choicesOf(const ViewSettings& settings, RendererForm form) {
    std::vector<RendererChoice> choices;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        choices.push_back({std::string(row.label), wordsOf(row, form),
                           !comparesRenderers(settings) && settings.renderer == renderer,
                           settings.offered.has(renderer), helpOf(settings, row),
                           [renderer](ViewSettings& view) { showOne(view, renderer); }});
    }
    choices.push_back({compareWords, compareWords, comparesRenderers(settings), canCompare(settings),
                       canCompare(settings) ? compareHelp : nothingToCompare,
                       [](ViewSettings& view) { showComparison(view); }});
    return choices;
}

void choose(const Session& session, const RendererChoice& choice) {
    act(session, [choose = choice.choose](Session& changed) { choose(changed.view); });
}

void drawButtons(const Session& session, RendererForm form) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize());
    ImGui::SetCursorPosY((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) / 2);
    int key = 0;
    for (const RendererChoice& each : choicesOf(session.view, form)) {
        ImGui::BeginDisabled(!each.offered);
        if (flatButton(label(each.words).c_str(), each.chosen))
            choose(session, each);
        ImGui::EndDisabled();
        item("renderer:" + each.name, Sentence("{0}\n{1}", each.help, Sentence("Key {0}", ++key)));
        ImGui::SameLine(0, gap);
    }
}

void drawList(const Session& session, float maxWidth) {
    const ViewSettings& settings = session.view;
    const float room = maxWidth - ImGui::GetFontSize() - 2 * ImGui::GetStyle().ItemSpacing.x -
                       ImGui::CalcTextSize(listSign).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize());
    const std::string words = fitted(chosenWords(settings), room + 1) + listSign;
    const bool open = beginMenu((words + "###renderers").c_str());
    noteItem("renderers");
    if (!open)
        return helpTip("The renderer of the picture");
    int key = 0;
    for (const RendererChoice& each : choicesOf(settings, RendererForm::List)) {
        if (ImGui::MenuItem(label(each.name).c_str(), std::to_string(++key).c_str(), each.chosen,
                            each.offered))
            choose(session, each);
        item("renderer:" + each.name, each.help);
    }
    endMenu();
}

} // namespace

Sentence helpOf(const ViewSettings& settings, const EnumRow& renderer) {
    const auto& reason = settings.offered.whyNot(static_cast<RendererKind>(renderer.value));
    return reason.empty() ? Sentence(renderer.help)
                          : Sentence("{0}\n{1}", renderer.help, Sentence("Not available: {0}.", reason));
}

float rendererChoiceWidth(const ViewSettings& settings, RendererForm form) {
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    const float before = ImGui::GetFontSize();
    if (form == RendererForm::List)
        return before + ImGui::CalcTextSize((tr(chosenWords(settings)) + listSign).c_str()).x +
               2 * ImGui::GetStyle().ItemSpacing.x;
    float width = before + buttonWidth(compareWords);
    for (const EnumRow& row : EnumTable<RendererKind>::rows)
        width += buttonWidth(wordsOf(row, form).c_str()) + gap;
    return width;
}

void drawRendererChoice(const Session& session, RendererForm form, float maxWidth) {
    if (form == RendererForm::List)
        drawList(session, maxWidth);
    else
        drawButtons(session, form);
}

} // namespace texplorer::ui
