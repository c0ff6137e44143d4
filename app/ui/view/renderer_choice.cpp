#include "app/ui/view/renderer_choice.h"

#include "app/ui/language/translate.h"
#include "app/ui/widgets/button_width.h"
#include "app/ui/widgets/fitted_text.h"
#include "app/ui/widgets/param_widgets.h"

#include <fmt/core.h>

namespace texplorer::ui {

namespace {

constexpr const char* compareHelp = "Two renderers in one picture, or all of them with the difference.";
constexpr const char* nothingToCompare = "Only one renderer is available.";

bool choice(const std::string& name, const std::string& words, bool chosen, bool offered,
            std::string_view help) {
    ImGui::BeginDisabled(!offered);
    ImGui::PushStyleColor(ImGuiCol_Button,
                          chosen ? ImGui::GetColorU32(ImGuiCol_HeaderActive) : IM_COL32(0, 0, 0, 0));
    const bool pressed = ImGui::Button(label(words).c_str());
    ImGui::PopStyleColor();
    ImGui::EndDisabled();
    noteItem("renderer:" + name);
    helpTip(help);
    return pressed;
}

constexpr const char* compareWords = "Compare";

std::string wordsOf(const EnumRow& renderer, RendererForm form) {
    return std::string(form == RendererForm::Buttons ? renderer.label : briefOf(renderer));
}

/// The current choice.
std::string chosenWords(const ViewSettings& settings) {
    return comparesRenderers(settings) ? compareWords : wordsOf(rowOf(settings.renderer), RendererForm::List);
}

constexpr const char* listSign = " ▾";

std::string keyHelp(int key) {
    return fmt::format("Key {}", key);
}

} // namespace

std::string helpOf(const ViewSettings& settings, const EnumRow& renderer) {
    const std::string& reason = settings.offered.whyNot(static_cast<RendererKind>(renderer.value));
    return reason.empty() ? std::string(renderer.help)
                          : fmt::format("{}\n{}", renderer.help, fmt::format("Not available: {}.", reason));
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

namespace {

void drawButtons(const Session& session, RendererForm form) {
    const ViewSettings& settings = session.window.view;
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x / 2;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize());
    ImGui::SetCursorPosY((ImGui::GetWindowHeight() - ImGui::GetFrameHeight()) / 2);
    int key = 0;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen = !comparesRenderers(settings) && settings.renderer == renderer;
        const std::string help = fmt::format("{}\n{}", helpOf(settings, row), keyHelp(++key));
        if (choice(std::string(row.label), wordsOf(row, form), chosen, settings.offered.has(renderer), help))
            change(session, [renderer](WindowState& window) { showOne(window.view, renderer); });
        ImGui::SameLine(0, gap);
    }
    if (choice(compareWords, compareWords, comparesRenderers(settings), canCompare(settings),
               fmt::format("{}\n{}", canCompare(settings) ? compareHelp : nothingToCompare, keyHelp(++key))))
        change(session, [](WindowState& window) { showComparison(window.view); });
    ImGui::SameLine(0, gap);
}

bool listItem(const std::string& name, int key, bool chosen, bool offered, std::string_view help) {
    const bool pressed = ImGui::MenuItem(label(name).c_str(), std::to_string(key).c_str(), chosen, offered);
    noteItem("renderer:" + name);
    helpTip(help);
    return pressed;
}

void drawList(const Session& session, float maxWidth) {
    const ViewSettings& settings = session.window.view;
    const float room = maxWidth - ImGui::GetFontSize() - 2 * ImGui::GetStyle().ItemSpacing.x -
                       ImGui::CalcTextSize(listSign).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize());
    const std::string words = fitted(chosenWords(settings), room + 1) + listSign;
    const bool open = ImGui::BeginMenu((words + "###renderers").c_str());
    noteItem("renderers");
    if (!open)
        return helpTip("The renderer of the picture");
    int key = 0;
    for (const EnumRow& row : EnumTable<RendererKind>::rows) {
        const auto renderer = static_cast<RendererKind>(row.value);
        const bool chosen = !comparesRenderers(settings) && settings.renderer == renderer;
        if (listItem(std::string(row.label), ++key, chosen, settings.offered.has(renderer),
                     helpOf(settings, row)))
            change(session, [renderer](WindowState& window) { showOne(window.view, renderer); });
    }
    if (listItem(compareWords, ++key, comparesRenderers(settings), canCompare(settings),
                 canCompare(settings) ? compareHelp : nothingToCompare))
        change(session, [](WindowState& window) { showComparison(window.view); });
    ImGui::EndMenu();
}

} // namespace

void drawRendererChoice(const Session& session, RendererForm form, float maxWidth) {
    if (form == RendererForm::List)
        drawList(session, maxWidth);
    else
        drawButtons(session, form);
}

} // namespace texplorer::ui
